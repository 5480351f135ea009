"""What a run writes and says."""

import os
import pty
import unittest

import h5py
import numpy as np

from support import BAR, PROGRAM, RUBBER, SHEET, ProgramTest, read_probes, read_summary


class Results(ProgramTest):
    def test_files(self):
        out = self.run_scene(BAR)

        written = {path.name for path in out.iterdir()}
        always = {"probes.csv", "run.h5", "run.xdmf", "run.xdmf.h5", "summary.json"}
        self.assertLessEqual(always, written)
        self.assertEqual(
            written - always - {"checkpoint.h5"},
            {"probes_exact.csv"},  # there is an exact solution
        )

    def test_default_folder_is_named_after_the_scene(self):
        self.write("my scene.toml", BAR)

        done = self.tlsph("run", "my scene.toml", "--quiet")

        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue((self.folder / "out/my scene/summary.json").is_file())

    def test_probes(self):
        out = self.run_scene(BAR)

        header, rows = read_probes(out / "probes.csv")
        values = np.array(rows, dtype=float)
        summary = read_summary(out)

        self.assertEqual(
            header, ["time", "tip.displacement_x", "tip.cauchy_xx", "p2.displacement_x"]
        )
        self.assertEqual(len(rows), summary["steps"] + 1)
        self.assertEqual(float(rows[0][0]), 0.0)
        self.assertEqual(float(rows[-1][0]), 2e-2)
        self.assertTrue(np.all(np.diff(values[:, 0]) > 0))
        self.assertTrue(np.all(values[0] == 0))
        self.assertGreater(abs(values[-1, 1]), 0)

    def test_probes_keep_17_digits(self):
        out = self.run_scene(BAR)

        _, rows = read_probes(out / "probes.csv")

        for text in rows[-1]:
            self.assertEqual(float(f"{float(text):.17g}"), float(text))
        with h5py.File(out / "run.h5") as file:
            tip = file["frames/displacement"][-1, -1, 0]
        self.assertEqual(float(rows[-1][1]), tip)

    def test_probe_every(self):
        out = self.run_scene(BAR, "--set", "output.probe_every=7")

        _, rows = read_probes(out / "probes.csv")

        self.assertLessEqual(len(rows), read_summary(out)["steps"] // 7 + 2)
        self.assertEqual(float(rows[-1][0]), 2e-2)

    def test_components_in_2d(self):
        out = self.run_scene(SHEET)

        header, _ = read_probes(out / "probes.csv")

        quantities = "displacement_x displacement_y pk1_xx pk1_xy pk1_yx pk1_yy von_mises".split()
        self.assertEqual(header, ["time"] + ["corner." + name for name in quantities])

    def test_summary(self):
        summary = read_summary(self.run_scene(BAR))

        promised = """scene version dimension formulation kernel support particles points nonzeros
            neighbours_mean dt dt_critical steps end_time threads wall_seconds ns_per_particle_step
            peak_memory_bytes energy momentum errors consistency failure"""
        self.assertLessEqual(set(promised.split()), set(summary))
        self.assertEqual(
            set(summary["energy"]),
            {"kinetic", "elastic", "external_work", "dissipated", "drift_relative"},
        )
        self.assertEqual(set(summary["momentum"]), {"linear_drift", "angular_drift"})
        self.assertEqual(set(summary["errors"]), {"displacement", "velocity", "stress"})
        self.assertEqual(summary["dimension"], 1)
        self.assertEqual(summary["formulation"], "stress-point")
        self.assertEqual(summary["particles"], 21)
        self.assertEqual(summary["points"], 20)
        self.assertEqual(summary["end_time"], 2e-2)
        self.assertIsNone(summary["support"])
        self.assertIsNone(summary["failure"])
        self.assertLess(summary["dt"], summary["dt_critical"])
        self.assertEqual(set(summary["wall_seconds"]), {"setup", "stepping", "output"})
        self.assertLess(summary["energy"]["drift_relative"], 1e-2)
        self.assertLess(summary["errors"]["displacement"], 0.05)

    def test_loads_are_told(self):
        """A load on 0.51 … 0.71 m of the top: 0.2 m, though its ends lie within faces."""
        part = SHEET.replace('where = "right"', 'where = "part"')
        self.write("scene.toml", part)
        done = self.tlsph("run", "scene.toml", "--out", "results", "--set",
                          'body.tags=[{name="part", box=[[0.51, 0.99], [0.71, 1.01]]}]')
        self.assertEqual(done.returncode, 0, done.stderr)
        (load,) = read_summary(self.folder / "results")["loads"]
        self.assertEqual(load["where"], "part")
        self.assertAlmostEqual(load["length"], 0.2, delta=1e-12)
        self.assertEqual(load["resultant"][0], 0.0)
        self.assertAlmostEqual(load["resultant"][1], 200.0, delta=1e-9)
        self.assertIn("load on part: 0.2 m of the boundary, resultant (0, 200) N at its amplitude", done.stdout)

    def test_errors_are_null_without_an_exact_solution(self):
        self.assertIsNone(read_summary(self.run_scene(SHEET))["errors"])

    def test_loss_of_hyperbolicity_is_told(self):
        self.write("scene.toml", RUBBER)

        done = self.tlsph("run", "scene.toml")

        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("the material, not the method, lost stability at t = 0.26", done.stdout)

    def test_loss_of_hyperbolicity_is_kept_over_a_resume(self):
        settings = ("--set", "output.checkpoint_steps=50", "--threads", "1")
        whole = self.run_scene(RUBBER, *settings)  # its last checkpoint is one after the loss
        loss = read_summary(whole)["hyperbolicity_lost"]

        again = self.run_scene(RUBBER, "--resume", *settings)

        self.assertEqual(set(loss), {"time", "point", "position", "stretches", "acoustic_eigenvalue"})
        self.assertAlmostEqual(loss["stretches"][0], 3.6307, delta=0.01)  # where dP/dF vanishes
        self.assertLess(loss["acoustic_eigenvalue"], 0)
        self.assertEqual(read_summary(again)["hyperbolicity_lost"], loss)
        self.assertIsNone(read_summary(self.run_scene(BAR))["hyperbolicity_lost"])

    def test_fields(self):
        out = self.run_scene(SHEET)
        summary = read_summary(out)

        with h5py.File(out / "run.h5") as file:
            self.assertEqual(file["scene"].attrs["text"], SHEET)
            self.assertEqual(file["particles/X"].shape, (121, 2))
            self.assertAlmostEqual(file["particles/V"][:].sum(), 1.0, places=12)
            self.assertEqual(file["points/X"].shape, (100, 2))
            self.assertAlmostEqual(file["points/V"][:].sum(), 1.0, places=12)
            np.testing.assert_allclose(
                file["frames/time"][:], np.linspace(0, 2e-2, 5), atol=summary["dt"]
            )
            self.assertEqual(file["frames/displacement"].shape, (5, 121, 2))
            self.assertEqual(file["frames/pk1"].shape, (5, 100, 4))
            self.assertEqual(file["frames/time"][-1], 2e-2)
            for name in ("particles/X", "frames/time", "frames/displacement", "series/kinetic"):
                self.assertIn("unit", file[name].attrs)

    def test_overrides_are_recorded(self):
        out = self.run_scene(BAR, "--set", "body.spacing=0.1", "--set", "output.frames=2")

        with h5py.File(out / "run.h5") as file:
            text = file["scene"].attrs["text"]
            self.assertEqual(file["frames/time"].shape, (3,))
        self.assertIn("spacing = 0.1\n", text)
        self.assertEqual(read_summary(out)["particles"], 11)

    def test_threads_are_those_that_step(self):
        # 121 particles are not worth a second thread, 2601 are
        fine = ("--set", "body.spacing=0.02", "--set", "time.end=1e-3")
        for overrides, expected in (((), 1), (fine, 2)):
            with self.subTest(overrides):
                out = self.run_scene(SHEET, "--threads", "2", *overrides)
                self.assertEqual(read_summary(out)["threads"], expected)
        thesis = ("--set", "formulation=thesis")
        self.assertEqual(read_summary(self.run_scene(BAR, "--threads", "2", *thesis))["threads"], 1)

    def test_storage(self):
        lattice = read_summary(self.run_scene(SHEET))
        jittered = ("--set", "body.jitter=0.2")
        irregular = read_summary(self.run_scene(SHEET, *jittered))
        mixed = read_summary(self.run_scene(SHEET, *jittered, "--set", "precision=mixed"))
        thesis = read_summary(self.run_scene(BAR, "--set", "formulation=thesis"))

        # 100 points and 121 nodes; the four corners have nodes of their own kind
        self.assertEqual(lattice["storage"]["general_rows"], 4)
        self.assertEqual(lattice["storage"]["stencil_rows"], 217)
        self.assertEqual(lattice["storage"]["distinct_stencils"], 6)
        self.assertEqual(irregular["storage"]["general_rows"], 221)
        self.assertGreater(
            irregular["storage"]["bytes_per_particle"], lattice["storage"]["bytes_per_particle"]
        )
        self.assertAlmostEqual(
            mixed["energy"]["elastic"] / irregular["energy"]["elastic"], 1.0, delta=1e-5
        )
        self.assertNotEqual(mixed["energy"]["elastic"], irregular["energy"]["elastic"])
        self.assertIsNone(thesis["storage"])

    def test_every_formulation(self):
        for formulation in ("thesis", "mirror", "variational", "stress-point"):
            with self.subTest(formulation):
                out = self.run_scene(BAR, "--set", "formulation=" + formulation)

                self.assertEqual(read_summary(out)["formulation"], formulation)


class Words(ProgramTest):
    def test_plain_lines(self):
        self.write("scene.toml", BAR)

        done = self.tlsph("run", "scene.toml")

        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertNotIn("\r", done.stdout)
        self.assertNotIn("\x1b", done.stdout)
        self.assertIn("21 particles", done.stdout)
        self.assertTrue(done.stdout.endswith("results in out/scene\n"))

    def test_quiet(self):
        self.write("scene.toml", BAR)

        done = self.tlsph("run", "scene.toml", "--quiet")

        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))

    def test_bar_on_a_terminal(self):
        self.write("scene.toml", BAR)
        shown = b""

        pid, terminal = pty.fork()
        if pid == 0:
            os.chdir(self.folder)
            os.execv(PROGRAM, [PROGRAM, "run", "scene.toml", "--set", "time.end=20"])
        try:
            while chunk := os.read(terminal, 4096):
                shown += chunk
        except OSError:  # the program closed its side
            pass
        _, status = os.waitpid(pid, 0)

        self.assertEqual(os.waitstatus_to_exitcode(status), 0)
        self.assertRegex(shown, rb"\r\[=* *\] +\d+ %  step \d+ of \d+")
        self.assertIn(b"results in out/scene", shown)


class Failures(ProgramTest):
    def test_numerical_failure(self):
        self.write("scene.toml", BAR.replace("amplitude = 1e3", "amplitude = -1e9"))

        done = self.tlsph("run", "scene.toml", "--out", "results", "--quiet")

        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertRegex(done.stderr, r"t = [\d.e+-]+")
        self.assertRegex(done.stderr, r"(particle|point) \d+")
        with h5py.File(self.folder / "results/run.h5") as file:
            self.assertTrue(np.all(np.isfinite(file["frames/displacement"][:])))
            self.assertGreaterEqual(file["frames/time"].shape[0], 2)  # the initial and the last good
        self.assertTrue(read_summary(self.folder / "results")["failure"])

    def test_the_last_frame_of_a_lost_body_is_sound(self):
        crushed = """
            dimension = 1
            [body]
            shape = { interval = [0.0, 0.1] }
            spacing = 0.02
            [material]
            law = "st-venant-kirchhoff"  # its stress stays finite when the body is turned inside out
            young = 1e6
            poisson = 0.3
            density = 1000
            [[boundary]]
            where = "left"
            fixed = true
            [[boundary]]
            where = "right"
            displacement = { x = { curve = "ramp", amplitude = -0.15, rise = 0.02 } }
            [time]
            end = 0.02
            [output]
            fields = ["displacement", "deformation_gradient"]
        """
        for frames in (4, 100):  # the last good state comes between two frames, or has one already
            with self.subTest(frames=frames):
                out = self.folder / f"crushed-{frames}"
                scene = self.write("crushed.toml", crushed)

                done = self.tlsph("run", str(scene), "--out", str(out), "--quiet",
                                  "--set", f"output.frames={frames}")

                self.assertEqual(done.returncode, 3, done.stderr)
                with h5py.File(out / "run.h5") as file:
                    times = file["frames/time"][...]
                    F = file["frames/deformation_gradient"][...]
                self.assertGreater(F.min(), 0.0)
                self.assertTrue(np.all(np.diff(times) > 0))
                self.assertEqual(times[-1], read_summary(out)["end_time"])

    def test_output_in_the_way(self):
        self.write("scene.toml", BAR)
        self.write("results", "a file, not a folder")

        done = self.tlsph("run", "scene.toml", "--out", "results", "--quiet")

        self.assertEqual(done.returncode, 4, done.stderr)
        self.assertIn("results", done.stderr)

    def test_output_nowhere(self):
        self.write("scene.toml", BAR)

        done = self.tlsph("run", "scene.toml", "--out", "/proc/no/such", "--quiet")

        self.assertEqual(done.returncode, 4, done.stderr)


if __name__ == "__main__":
    unittest.main()
