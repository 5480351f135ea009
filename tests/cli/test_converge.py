"""tlsph converge: the table, its files and figure."""

import csv
import json
import os
import pty
import re
import unittest

import numpy as np

from convergence import SMOOTH, Convergence
from support import PROGRAM, SHEET, SOURCE

HEADER = (
    "spacing,particles,steps,dt,wall_seconds,formulation,displacement,velocity,stress,"
    "order_displacement,order_velocity,order_stress,failure"
)


class Table(Convergence):
    def test_exact(self):
        done = self.converge("--spacing", "0.00625,0.025,0.0125", "--out", "study")

        self.assertEqual(done.stderr, "")
        self.assertEqual(
            (self.folder / "study/convergence.csv").read_text(encoding="utf-8").splitlines()[0], HEADER
        )
        rows = self.rows()
        self.assertEqual([float(row["spacing"]) for row in rows], [0.025, 0.0125, 0.00625])
        self.assertEqual([row["particles"] for row in rows], ["41", "81", "161"])
        self.assertEqual({row["formulation"] for row in rows}, {"stress-point"})
        report = self.report()
        self.assertEqual(report["method"], "exact")
        for order in report["orders"]:
            errors = self.numbers(rows, order["quantity"])
            slope = np.polyfit(np.log(self.numbers(rows, "spacing")), np.log(errors), 1)[0]
            self.assertAlmostEqual(order["order"], slope, places=10)
            self.assertAlmostEqual(order["order"], 2.0, delta=0.1)
            pairwise = np.log2(errors[:-1] / errors[1:])
            np.testing.assert_allclose(
                self.numbers(rows[1:], "order_" + order["quantity"]), pairwise, atol=1e-10
            )
            self.assertEqual(rows[0]["order_" + order["quantity"]], "")
            self.assertRegex(done.stdout, rf"fitted order.*\b{order['order']:.2f}\b")
        self.assertEqual(len(re.findall(r"(?m)^ +0\.\d+ +\d+ +\d+ .*e-", done.stdout)), 3)

    def test_errors_are_those_of_the_run(self):
        self.converge("--spacing", "0.1,0.05", "--out", "study")

        out = self.run_scene(SMOOTH, "--set", "body.spacing=0.05")

        summary = json.loads((out / "summary.json").read_text(encoding="utf-8"))
        row = self.report()["rows"][1]
        for name in ("displacement", "velocity", "stress"):
            self.assertEqual(row[name], summary["errors"][name])
        for name in ("particles", "steps", "dt"):
            self.assertEqual(row[name], summary[name])

    def test_formulations(self):
        self.converge("--spacing", "0.1,0.05", "--formulation", "mirror,stress-point", "--out", "study")

        self.assertEqual(
            [(row["formulation"], float(row["spacing"])) for row in self.rows()],
            [("mirror", 0.1), ("mirror", 0.05), ("stress-point", 0.1), ("stress-point", 0.05)],
        )
        self.assertEqual(
            {(order["formulation"], order["quantity"]) for order in self.report()["orders"]},
            {(f, q) for f in ("mirror", "stress-point") for q in ("displacement", "velocity", "stress")},
        )

    def test_probes(self):
        sheet = SHEET.replace("duration = 5e-3", "duration = 2e-2")

        done = self.converge("--spacing", "0.2,0.1,0.05", "--out", "study", scene=sheet)

        self.assertIn("no exact solution", done.stdout)
        report, rows = self.report(), self.rows()
        self.assertEqual(report["method"], "probes")
        self.assertEqual(report["quantities"], ["displacement", "pk1", "von_mises"])
        for spacing in ("0.2", "0.1", "0.05"):
            self.assertTrue((self.folder / "study/stress-point" / spacing / "probes.csv").is_file())
        for row, nextrow in zip(rows[:1], rows[1:]):
            self.assertGreater(float(row["displacement"]), float(nextrow["displacement"]))
        self.assertEqual(rows[2]["displacement"], "")
        self.assertGreater(float(rows[2]["order_displacement"]), 1.0)

        # The same from the histories themselves, with linear interpolation.
        histories = [
            np.genfromtxt(self.folder / f"study/stress-point/{s}/probes.csv", delimiter=",", names=True)
            for s in ("0.2", "0.1", "0.05")
        ]
        t = histories[2]["time"]
        columns = ["cornerdisplacement_x", "cornerdisplacement_y"]

        def norm(values):
            return np.sqrt(np.trapz(np.sum(np.square(values), axis=0), t))

        q = [np.array([np.interp(t, h["time"], h[c]) for c in columns]) for h in histories]
        for k in range(2):
            self.assertAlmostEqual(
                float(rows[k]["displacement"]) / (norm(q[k] - q[k + 1]) / norm(q[2])), 1.0, delta=0.05
            )

    def test_compared_keys_and_seeds(self):
        done = self.converge(
            "--spacing", "0.1,0.05", "--formulation", "consistent,variational", "--over", "kernel.support=2.1,2.6",
            "--seed", "1,2,3", "--out", "study", "--set", "body.jitter=0.2",
            scene=(SOURCE / "examples/swinging_plate.toml").read_text(encoding="utf-8"),
        )

        rows = self.rows()
        self.assertEqual(len(rows), 2 * 2 * 2 * 3)
        self.assertEqual(
            [(row["formulation"], row["kernel.support"], row["body.seed"]) for row in rows[:7]],
            [("consistent", "2.1", seed) for seed in "123123"] + [("consistent", "2.6", "1")],
        )
        with open(self.folder / "study/spread.csv", encoding="utf-8", newline="") as file:
            levels = list(csv.DictReader(file))
        for level in levels:
            errors = sorted(
                float(row[level["quantity"]]) for row in rows
                if row["spacing"] == level["spacing"]
                and f"{row['formulation']} kernel.support={row['kernel.support']}" == level["series"]
            )
            self.assertEqual([float(level[name]) for name in ("best", "median", "worst")], errors)
        orders = {(order["series"], order["quantity"]): order for order in self.report()["orders"]}
        self.assertEqual(len(orders), 4 * 3)
        finest = levels[3:6]
        coarse = levels[0:3]
        for a, b in zip(coarse, finest):
            order = orders[(a["series"], a["quantity"])]
            self.assertAlmostEqual(order["order"], np.log2(float(a["median"]) / float(b["median"])), places=9)
            self.assertAlmostEqual(order["order_worst"], np.log2(float(a["worst"]) / float(b["worst"])), places=9)
        self.assertIn("consistent kernel.support=2.1: velocity", done.stdout)
        self.assertIn("worst/best", done.stdout)

    def write_cloud(self, name, n, seed):
        """Points of a lattice of n x n cells on the unit square, the inner ones moved by up to 0.2 of the spacing."""
        points = np.stack(np.meshgrid(*2 * [np.arange(n + 1) / n], indexing="ij"), axis=-1).reshape(-1, 2)
        inner = np.all((points > 0) & (points < 1), axis=1)
        points[inner] += np.random.default_rng(seed).uniform(-0.2 / n, 0.2 / n, (inner.sum(), 2))
        self.write(name, "x,y\n" + "".join(f"{x:.17g},{y:.17g}\n" for x, y in points))

    def test_clouds(self):
        for n in (8, 16):
            for seed in (1, 2):
                self.write_cloud(f"{n}-{seed}.csv", n, seed)

        done = self.converge(
            "--cloud", "16-1.csv,8-1.csv,8-2.csv,16-2.csv", "--out", "study", "--formulation", "consistent",
            "--set", "stabiliser.kind=pair",
            scene=(SOURCE / "examples/swinging_plate.toml").read_text(encoding="utf-8"),
        )

        rows = self.rows()
        self.assertEqual([(row["body.cloud"], row["particles"]) for row in rows],
                         [("8-1.csv", "81"), ("8-2.csv", "81"), ("16-1.csv", "289"), ("16-2.csv", "289")])
        np.testing.assert_allclose(self.numbers(rows, "spacing"), [1 / 8, 1 / 8, 1 / 16, 1 / 16], rtol=1e-12)
        self.assertEqual([level["runs"] for level in self.report()["levels"]], [2, 2])
        for order in self.report()["orders"]:
            self.assertGreater(order["order"], 1.5, order)
            self.assertGreater(order["order_worst"], 1.5, order)
        self.assertIn("consistent: velocity", done.stdout)

    def test_values_are_extrapolated(self):
        # The first mode of a plane-stress bar that is fixed on the left swings with 4 L/sqrt(E/rho).
        bar = SMOOTH.replace('[reference]\nexact = "bar-wave"\n', "").replace("end = 2e-2", "end = 0.5")
        bar = bar.replace('[material]\n', '[material]\nassumption = "stress"\n').replace("poisson = 0.3", "poisson = 0")
        bar = re.sub(r"traction = .*", 'traction = { curve = "sine-squared", amplitude = 1e3, duration = 0.1265 }', bar)

        done = self.converge("--spacing", "0.1,0.05,0.025", "--out", "study", "--value",
                             "tip.displacement_x.max,tip.displacement_x.end", scene=bar)

        values = {value["name"]: value for value in self.report()["values"]}
        self.assertEqual(list(values), ["tip.displacement_x.max", "tip.displacement_x.end"])
        rows = self.rows()
        for name, value in values.items():
            f = np.array(value["value"])
            self.assertEqual([float(row[name]) for row in rows], list(f))
            if value["order"] is not None:
                ratio = 2.0 ** value["order"]
                self.assertAlmostEqual(abs((f[1] - f[0]) / (f[2] - f[1])) / ratio, 1.0, places=9)
                self.assertAlmostEqual(value["extrapolated"] / (f[2] + (f[2] - f[1]) / (ratio - 1)), 1.0, places=9)
        self.assertIsNotNone(values["tip.displacement_x.max"]["order"])
        self.assertRegex(done.stdout, r"tip\.displacement_x\.max +\d")
        extrapolated = self.folder / "study/stress-point/probes_extrapolated.csv"
        self.assertEqual(extrapolated.read_text(encoding="utf-8").split("\n")[0].split(",")[0], "time")

    def test_set_reaches_every_run(self):
        self.converge("--spacing", "0.1,0.05", "--set", "time.end=1e-2", "--out", "study")

        for row in self.rows():
            self.assertLess(float(row["dt"]) * (int(row["steps"]) - 1), 1e-2)

    def test_default_folder(self):
        self.converge("--spacing", "0.1,0.05", "--quiet")

        self.assertTrue((self.folder / "out/scene-converge/convergence.json").is_file())

    def test_quiet(self):
        done = self.converge("--spacing", "0.1,0.05", "--quiet")

        self.assertEqual((done.stdout, done.stderr), ("", ""))

    def test_bar_on_a_terminal(self):
        self.write("scene.toml", SMOOTH)
        shown = b""

        pid, terminal = pty.fork()
        if pid == 0:
            os.chdir(self.folder)
            os.execv(PROGRAM, [PROGRAM, "converge", "scene.toml", "--spacing", "0.1,0.05",
                               "--set", "time.end=10"])
        try:
            while chunk := os.read(terminal, 4096):
                shown += chunk
        except OSError:  # the program closed its side
            pass
        _, status = os.waitpid(pid, 0)

        self.assertEqual(os.waitstatus_to_exitcode(status), 0, shown)
        self.assertRegex(shown, rb"\r\[=* *\] +\d+ %  step \d+ of \d+")
        self.assertIn(b"fitted order", shown)


class Figures(Convergence):
    def test_figure(self):
        done = self.converge(
            "--spacing", "0.1,0.05", "--out", "study",
            env=dict(os.environ, TLSPH_PLOT=str(SOURCE / "validation/plot.py")),
        )

        self.assertEqual((self.folder / "study/convergence.png").read_bytes()[:4], b"\x89PNG")
        self.assertIn("study/convergence.png", done.stdout)

    def test_figure_of_samples(self):
        self.converge(
            "--spacing", "0.1,0.05", "--seed", "1,2,3", "--out", "study", "--set", "body.jitter=0.2",
            "--set", "formulation=consistent", env=dict(os.environ, TLSPH_PLOT=str(SOURCE / "validation/plot.py")),
        )

        self.assertEqual((self.folder / "study/convergence.png").read_bytes()[:4], b"\x89PNG")

    def test_no_figure_says_how(self):
        done = self.converge("--spacing", "0.1,0.05", "--out", "study", env=self.without_figure())

        self.assertIn("draw it with: python3 /no/such/plot.py convergence study/convergence.csv", done.stdout)
        self.assertFalse((self.folder / "study/convergence.png").exists())


if __name__ == "__main__":
    unittest.main()
