"""The lessons of examples/: each is run as it stands and must give the number its header tells."""

import unittest

import h5py
import numpy as np

from support import SOURCE, ProgramTest, read_probes, read_summary


class Examples(ProgramTest):
    def run_example(self, name, *arguments):
        scene = SOURCE / "examples" / f"{name}.toml"
        done = self.tlsph("run", scene, "--out", name, "--quiet", "--threads", "1", *arguments)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        header, rows = read_probes(self.folder / name / "probes.csv")
        columns = dict(zip(header, np.array(rows, dtype=float).T))
        return columns, read_summary(self.folder / name)

    def fields(self, name):
        file = h5py.File(self.folder / name / "run.h5")
        self.addCleanup(file.close)
        return file

    def test_bar_wave(self):
        probes, summary = self.run_example("bar_wave")

        self.assertLessEqual(summary["errors"]["stress"], 1e-3)
        self.assertLessEqual(summary["errors"]["displacement"], 1e-4)
        # The middle of the pulse passes the loaded end at 3 r + T/2 = 7 us and travels at c.
        c = np.sqrt(200e9 * 0.7 / (1.3 * 0.4) / 8000)
        for name, x, stress in (("p2", 0.05, -1e5), ("p3", 0.10, -1e5), ("p4", 0.15, -2e5)):
            history = probes[f"{name}.pk1_xx"]
            np.testing.assert_allclose(history.min(), stress, rtol=1e-4)
            rise = probes["time"][np.argmax(history < stress / 2)]
            self.assertAlmostEqual(rise, 3e-6 + x / c, delta=2 * summary["dt"])
        self.assertTrue(np.all(probes["p4.displacement_x"] == 0))

    def test_bar_wave_2d(self):
        probes, summary = self.run_example("bar_wave_2d")

        self.assertLessEqual(summary["errors"]["stress"], 2e-3)
        np.testing.assert_allclose(probes["p4.pk1_xx"].min(), -2e5, rtol=1e-4)
        lateral = abs(self.fields("bar_wave_2d")["frames/displacement"][:, :, 1]).max()
        self.assertLessEqual(lateral, 1e-6 * abs(probes["p2.displacement_x"]).max())

    def test_stretch(self):
        probes, _ = self.run_example("stretch")

        for name in ("end", "middle"):
            self.assertAlmostEqual(probes[f"{name}.deformation_gradient_xx"][-1], 6.0, delta=1e-4)
            np.testing.assert_allclose(probes[f"{name}.pk1_xx"][-1], 169.1112e6, rtol=1e-5)
        # All along the way within 1 % of the static curve, once the bar is stretched by a tenth.
        mu, lame = 70e6 / 2.6, 70e6 * 0.3 / (1.3 * 0.4)
        F = 1 + probes["end.displacement_x"] / 0.015
        static = mu * (F - 1 / F) + lame * np.log(F) / F
        middle = probes["middle.pk1_xx"]
        np.testing.assert_allclose(middle[F > 1.1], static[F > 1.1], rtol=1e-2)

    def test_pressure_ring(self):
        probes, summary = self.run_example("pressure_ring")

        self.assertEqual(summary["particles"], 381)
        np.testing.assert_allclose(probes["bore.displacement_x"][-1], 0.95333e-6, rtol=2e-3)
        np.testing.assert_allclose(probes["rim.displacement_x"][-1], 0.60667e-6, rtol=2e-3)
        np.testing.assert_allclose(probes["bore.cauchy_yy"][-1], 16.667e6, rtol=1e-2)

    def test_swinging_plate(self):
        _, summary = self.run_example("swinging_plate")

        self.assertLessEqual(summary["errors"]["displacement"], 6e-5)
        self.assertLessEqual(summary["errors"]["velocity"], 1e-3)
        self.assertLessEqual(summary["errors"]["stress"], 4e-4)

    def test_clamped_beam(self):
        for spacing, tolerance in ((5e-3, 0.0032), (2.5e-3, 0.0016)):
            with self.subTest(spacing):
                probes, summary = self.run_example(
                    "clamped_beam", "--set", f"body.spacing={spacing}"
                )

                t, y = probes["time"], probes["tip.displacement_y"]
                crossings = np.flatnonzero(y[1:-1] * y[2:] < 0) + 1
                zeros = t[crossings] - y[crossings] * (t[crossings + 1] - t[crossings]) / (
                    y[crossings + 1] - y[crossings]
                )
                self.assertGreaterEqual(len(zeros), 6)  # three periods
                self.assertAlmostEqual(zeros[1] / 0.25523, 1.0, delta=tolerance)
                self.assertAlmostEqual(zeros[5] / 3 / 0.25523, 1.0, delta=tolerance)
                self.assertAlmostEqual(abs(y).max(), 1e-3, delta=2e-5)
                self.assertLessEqual(summary["energy"]["drift_relative"], 1e-6)

    def test_plate_with_hole(self):
        # Quadratic finite elements at rest: 16.74 MPa at A, 3.534 mm at the edge.
        for spacing, stress, motion in ((1.25e-3, 0.02, 0.003), (6.25e-4, 0.007, 0.002)):
            with self.subTest(spacing):
                probes, _ = self.run_example(
                    "plate_with_hole", "--set", f"body.spacing={spacing}"
                )

                self.assertAlmostEqual(probes["A.cauchy_xx"][-1] / 16.74e6, 1.0, delta=stress)
                self.assertAlmostEqual(
                    probes["edge.displacement_x"][-1] / 3.534e-3, 1.0, delta=motion
                )
                with self.fields("plate_with_hole") as file:
                    largest = file["points/X"][file["frames/cauchy"][-1, :, 0].argmax()]
                self.assertLess(np.hypot(largest[0], largest[1] - 0.01), spacing)


if __name__ == "__main__":
    unittest.main()
