"""tlsph fit: the scene it writes has the error it promises; verdicts, refusals; what a plan could do without."""

import csv
import json
import signal
import unittest

from support import BAR, SHEET, SOURCE, ProgramTest, read_summary

LINEAR = BAR.replace("rise = 5e-3", "rise = 1e-2")
FREE = LINEAR.replace('[reference]\nexact = "bar-wave"\n', "")
PERIOD = "tip.displacement_y.period=0.25523"  # of the clamped beam, 2D elasticity


class FitTest(ProgramTest):
    def fit(self, scene, *arguments, code=0):
        done = self.tlsph("fit", scene, "--out", "study", *arguments)
        self.assertEqual(done.returncode, code, done.stderr)
        return done

    def report(self):
        return json.loads((self.folder / "study/fit.json").read_text(encoding="utf-8"))

    def rerun(self):
        """Errors of the scene that was written, run once more."""
        done = self.tlsph("run", "study/scene.toml", "--out", "again", "--quiet")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return read_summary(self.folder / "again")

    def assert_fits(self, wanted, measured):
        self.assertLessEqual(measured, wanted)
        self.assertGreaterEqual(measured, wanted / 5)


class Fits(FitTest):
    def test_examples(self):
        for scene, quantity in (("swinging_plate", "stress"), ("swinging_plate", "velocity"), ("bar_wave", "stress"),
                                ("bar_wave", "displacement"), ("bar_wave_2d", "stress")):
            for wanted in (3e-2, 1e-2, 3e-3):
                with self.subTest(scene=scene, quantity=quantity, wanted=wanted):
                    self.fit(SOURCE / f"examples/{scene}.toml", "--error", wanted, "--quantity", quantity, "--quiet")

                    summary = self.rerun()
                    self.assert_fits(wanted, summary["errors"][quantity])
                    self.assertEqual(summary["errors"][quantity], self.report()["measured_error"])
                    self.assertEqual(summary["dimension"], 1 if "bar" in scene else 2)

    def test_period_of_the_beam(self):
        for wanted in (3e-2, 1e-2, 3e-3):
            with self.subTest(wanted=wanted):
                self.fit(SOURCE / "examples/clamped_beam.toml", "--error", wanted, "--value", PERIOD, "--quiet")

                self.assert_fits(wanted, self.report()["measured_error"])

    def test_report(self):
        self.write("scene.toml", LINEAR)

        done = self.fit("scene.toml", "--error", "0.01")

        report = self.report()
        self.assertRegex(done.stdout, r"(?m)^predicted: error \S+ in \S+ s$")
        self.assertRegex(done.stdout, r"(?m)^measured: error \S+ in \S+ s, \d+ particles, \d+ steps: meets 0.01$")
        self.assertIn("    [body]\n", done.stdout)
        self.assertIn("scene in study/scene.toml", done.stdout)
        self.assertTrue(report["meets"])
        with open(self.folder / "study/fit.csv", encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        pilots = [pilot for family in report["families"] for pilot in family["pilots"]]
        self.assertEqual([float(row["error"]) for row in rows], [pilot["error"] for pilot in pilots])

    def test_answer_that_is_wrong_is_missed(self):
        self.write("scene.toml", FREE)

        done = self.fit("scene.toml", "--error", "0.01", "--value", "tip.cauchy_xx.max=1e9", code=1)

        self.assertIn("misses 0.01", done.stdout)
        self.assertFalse(self.report()["meets"])

    def test_interrupt_keeps_what_is_done(self):
        beam = SOURCE / "examples/clamped_beam.toml"
        process = self.start("fit", beam, "--error", "1e-6", "--value", PERIOD, "--out", "study", "--quiet")
        self.wait_for((self.folder / "study").is_dir, process)

        process.send_signal(signal.SIGINT)

        self.assertEqual(process.wait(timeout=60), 130)
        self.assertTrue(self.report()["interrupted"])
        self.assertFalse(self.report()["meets"])

    def test_bad_input(self):
        self.write("scene.toml", LINEAR)
        for arguments, message in (
            ([], "--error"),
            (["--error", "0"], "--error"),
            (["--error", "2"], "--error"),
            (["--error", "small"], "--error"),
            (["--error", "0.01", "--quantity", "heat"], "choose from displacement, velocity, stress"),
            (["--error", "0.01", "--quantity", "stress", "--value", "tip.cauchy_xx.max=1"], "--value"),
            (["--error", "0.01", "--value", "tip.cauchy_xx"], "--value"),
            (["--error", "0.01", "--set", "reference.exact=none"], "--value NAME"),
            (["--error", "0.01", "--set", "material.poisson=0.5"], "poisson"),
            (["--error", "0.01", "--set", "kernel.support=2.5"], "kernel is what a fit chooses"),
            (["--error", "0.01", "--set", "formulation=variational"], "formulation is what a fit chooses"),
        ):
            with self.subTest(arguments):
                done = self.fit("scene.toml", *arguments, code=2)

                self.assertIn(message, done.stderr)
                self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
                self.assertEqual(self.listing(), ["scene.toml"])


class Advice(ProgramTest):
    def plan(self, scene, *arguments):
        done = self.tlsph("plan", scene, *arguments)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout

    def test_strip_is_a_bar(self):
        text = self.plan(SOURCE / "examples/bar_wave_2d.toml")

        self.assertIn("1D: nothing depends on y; 301 particles in place of 1806", text)
        self.assertIn("neo-hookean at strains of at most about 1.0e-06", text)

    def test_scene_that_needs_all_it_has(self):
        for scene in ("swinging_plate", "pressure_ring", "plate_with_hole", "clamped_beam", "stretch"):
            with self.subTest(scene):
                self.assertNotIn("it could do without", self.plan(SOURCE / f"examples/{scene}.toml"))

    def test_sheet(self):
        self.write("scene.toml", SHEET)

        self.assertNotIn("symmetry", self.plan("scene.toml"))
        pulled = self.plan("scene.toml", "--set", 'boundary[1]={where="right",traction=1e3}')
        self.assertIn("y = 0.5 m is a plane of symmetry; 66 particles in place of 121", pulled)


if __name__ == "__main__":
    unittest.main()
