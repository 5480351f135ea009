"""tlsph chart: the front and its files, peers beside it, what it refuses, what it keeps; the peers themselves."""

import csv
import json
import math
import os
import signal
import subprocess
import sys
import time
import unittest

from support import BAR, SOURCE, ProgramTest, read_summary

LINEAR = BAR.replace("rise = 5e-3", "rise = 1e-2").replace("[material]", '[material]\nlaw = "linear-elastic"')
FREE = LINEAR.replace('[reference]\nexact = "bar-wave"\n', "")
GENTLE = LINEAR.replace('law = "linear-elastic"', 'law = "neo-hookean"').replace("amplitude = 1e3", "amplitude = 10")
QUICK = ["--budget", "2", "--spacing", "0.1,0.05,0.025"]

ANSWERING = """\
import json, sys
spacing = float(sys.argv[sys.argv.index("--spacing") + 1])
print(json.dumps({"peer": "quick", "scene": sys.argv[1], "n": 1, "spacing": spacing, "particles": 7, "steps": 3,
                  "stepping_seconds": 1e-9, "repetitions": [1e-9], "note": "", "errors": {},
                  "quantities": [{"name": "displacement", "error": -spacing, "value": None},
                                 {"name": "stress", "error": None, "value": None}]}))
"""

# Chooses step and law, and says what it was told.
CHOOSING = ANSWERING.replace('"note"', '**told, "note"').replace("print(", """\
argument = lambda name, default: sys.argv[sys.argv.index(name) + 1] if name in sys.argv else default
told = {"step_share": float(argument("--share", None)), "law": argument("--law", "neo-hookean")}
print(""", 1)


class ChartTest(ProgramTest):
    def chart(self, *arguments, code=0, scene=LINEAR, **options):
        self.write("scene.toml", scene)
        done = self.tlsph("chart", "scene.toml", *arguments, **options)
        self.assertEqual(done.returncode, code, done.stderr)
        return done

    def report(self, out="study"):
        return json.loads((self.folder / out / "chart.json").read_text(encoding="utf-8"))


class Fronts(ChartTest):
    def test_front(self):
        done = self.chart(*QUICK, "--out", "study")

        report = self.report()
        self.assertEqual(report["quantities"], ["displacement", "velocity", "stress"])
        points = [point for point in report["points"] if not point["failure"]]
        self.assertGreater(len(points), 50)
        for q, quantity in enumerate(report["quantities"]):
            at = [(sorted(p["stepping_seconds"]), p["errors"][q], quantity in p["front"]) for p in points]
            middle = [(0.5 * (s[(len(s) - 1) // 2] + s[len(s) // 2]), error, on) for s, error, on in at]
            for t, error, on in middle:
                beaten = any(u <= t and e <= error and (u < t or e < error) for u, e, _ in middle)
                self.assertEqual(on, not beaten)
            front = [point for point in points if quantity in point["front"]]
            for point in front:
                self.assertIn(point["family"], done.stdout)
        with open(self.folder / "study/chart.csv", encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["family"] for row in rows], [point["family"] for point in report["points"]])
        self.assertEqual(float(rows[0]["stress"]), report["points"][0]["errors"][2])
        self.assertEqual([(row["law"], float(row["step_share"])) for row in rows],
                         [(point["law"], point["step_share"]) for point in report["points"]])
        self.assertIn(f"and {report['variants']} variants of law and step", done.stdout)

    def test_variants_are_runs(self):
        self.chart(*QUICK, "--formulation", "stress-point", "--out", "study", scene=GENTLE)

        variants = [p for p in self.report()["points"] if p["family"].endswith(" linear step 0.99")]
        self.assertGreater(len(variants), 0)
        arguments = [word for text in variants[-1]["set"] for word in ("--set", text)]
        summary = read_summary(self.run_scene(GENTLE, *arguments))
        self.assertEqual(summary["errors"]["stress"], variants[-1]["errors"][2])
        self.assertEqual(summary["steps"], variants[-1]["steps"])

    def test_step_of_the_scene(self):
        self.chart(*QUICK, "--formulation", "stress-point", "--out", "study", "--set", "time.step=1e-5")

        self.assertEqual({point["step_share"] for point in self.report()["points"]}, {None})
        with open(self.folder / "study/chart.csv", encoding="utf-8", newline="") as file:
            self.assertEqual({row["step_share"] for row in csv.DictReader(file)}, {""})

    def test_points_are_runs(self):
        self.chart(*QUICK, "--formulation", "stress-point,mirror", "--out", "study")

        point = self.report()["points"][-1]
        self.write("scene.toml", LINEAR)
        arguments = [word for text in point["set"] for word in ("--set", text)]
        out = self.run_scene(LINEAR, *arguments)
        self.assertEqual(read_summary(out)["errors"]["stress"], point["errors"][2])

    def test_value_and_figure(self):
        done = self.chart(
            *QUICK, "--formulation", "stress-point", "--out", "study", "--value", "tip.cauchy_xx.max=1000", scene=FREE,
            env=dict(os.environ, TLSPH_PLOT=str(SOURCE / "validation/plot.py")),
        )

        report = self.report()
        self.assertEqual((report["quantities"], report["answers"]), (["tip.cauchy_xx.max"], [1000]))
        self.assertIn("tip.cauchy_xx.max = 1000", done.stdout)
        self.assertEqual((self.folder / "study/chart.png").read_bytes()[:4], b"\x89PNG")

    def test_interrupt_keeps_what_is_done(self):
        self.write("scene.toml", LINEAR)
        process = self.start("chart", "scene.toml", "--budget", "10min", "--out", "study", "--quiet")
        self.wait_for((self.folder / "study/chart.json").is_file, process)

        process.send_signal(signal.SIGINT)

        self.assertEqual(process.wait(timeout=60), 130)
        self.assertTrue(self.report()["interrupted"])
        self.assertGreater(len(self.report()["points"]), 0)

    def test_cloud_has_a_spacing_of_its_own(self):
        done = self.tlsph("chart", SOURCE / "examples/pressure_ring.toml", "--value", "inside.displacement_x.max")

        self.assertEqual(done.returncode, 2)
        self.assertIn("leave the cloud out", done.stderr)
        self.assertEqual(self.listing(), [])

    def test_bad_input(self):
        for arguments, scene, message in (
            ([], FREE, "--value NAME=ANSWER"),
            (["--value", "tip.cauchy_xx.max=high"], FREE, "must be a number"),
            (["--value", "tip.cauchy_xx"], FREE, "--value"),
            (["--budget", "0"], LINEAR, "--budget"),
            (["--budget", "soon"], LINEAR, "--budget"),
            (["--peer", "nastran"], LINEAR, 'there is no "nastran"; choose from ccx, fe_q4'),
            (["--peer", "fe_q4", "--set", "material.poisson=0.2"], LINEAR, "peers know the scene as the examples"),
            (["--formulation", "fem"], LINEAR, "fem"),
            (["--spacing", "0.1,0.07"], LINEAR, "spacing"),
            (["--set", "material.poisson=0.5"], LINEAR, "poisson"),
        ):
            with self.subTest(arguments):
                done = self.chart(*arguments, code=2, scene=scene)

                self.assertIn(message, done.stderr)
                self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
                self.assertEqual(self.listing(), ["scene.toml"])


class PeersBeside(ChartTest):
    def with_peers(self, **scripts):
        for name, text in scripts.items():
            path = self.folder / "validation/peers" / (name + ".py")
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        return dict(os.environ, TLSPH_VALIDATION=str(self.folder / "validation"), TLSPH_PLOT="/no/such/plot.py")

    def test_peer_is_on_the_chart(self):
        done = self.chart("--budget", "10", *QUICK[2:], "--peer", "quick", "--out", "study",
                          env=self.with_peers(quick=ANSWERING))

        mine = [point for point in self.report()["points"] if point["peer"] == "quick"]
        self.assertEqual([(p["spacing"], p["errors"]) for p in mine],
                         [(h, [h, None, None]) for h in (0.1, 0.05, 0.025)])
        self.assertEqual([p["front"] for p in mine], [[], [], ["displacement"]])
        self.assertEqual({len(p["stepping_seconds"]) for p in mine}, {3})
        self.assertRegex(done.stdout, r"quick: (not reached|[0-9.e-]+ s, [0-9.e+-]+ of it)")

    def test_peer_that_chooses_has_the_same_freedom(self):
        self.chart(*QUICK, "--peer", "quick", "--out", "study", scene=GENTLE, env=self.with_peers(quick=CHOOSING))

        mine = {(p["peer"], p["law"], p["step_share"]) for p in self.report()["points"] if p["peer"]}
        self.assertEqual(mine, {("quick", "neo-hookean", 0.9), ("quick step 0.99", "neo-hookean", 0.99),
                                ("quick linear", "linear-elastic", 0.9),
                                ("quick linear step 0.99", "linear-elastic", 0.99)})

    def test_peer_has_the_share_of_the_scene(self):
        self.chart(*QUICK, "--formulation", "stress-point", "--peer", "quick", "--set", "time.safety=0.5",
                   "--out", "study", env=self.with_peers(quick=CHOOSING.replace("neo-hookean", "linear-elastic")))

        mine = {(p["peer"], p["law"], p["step_share"]) for p in self.report()["points"] if p["peer"]}
        self.assertEqual(mine, {("quick", "linear-elastic", 0.5), ("quick step 0.99", "linear-elastic", 0.99)})

    def test_peer_that_cannot(self):
        done = self.chart(
            *QUICK, "--formulation", "stress-point", "--peer", "lost", "--out", "study",
            env=self.with_peers(lost="import sys\nsys.exit('lost: is not installed')"),
        )

        self.assertIn("\nlost: is not installed\n", done.stdout)
        self.assertEqual(self.report()["notes"], ["lost: is not installed"])

    def test_peer_that_takes_too_long(self):
        start = time.monotonic()
        sleeping = "import subprocess\nsubprocess.run(['sleep', '100'])"

        self.chart(*QUICK, "--formulation", "stress-point", "--peer", "slow", "--out", "study",
                   env=self.with_peers(slow=sleeping))

        self.assertLess(time.monotonic() - start, 30)
        self.assertRegex(self.report()["notes"][0], "slow: took more than")


class FiniteElements(ProgramTest):
    """fe_q4, the peer that is the project's own."""

    def peer(self, scene, spacing, *arguments):
        done = subprocess.run(
            [sys.executable, "-B", SOURCE / "validation/peers/fe_q4.py", scene, "--spacing", str(spacing), *arguments],
            env=dict(os.environ, XDG_CACHE_HOME=str(self.folder / "cache")), capture_output=True, text=True, check=True,
        )
        return json.loads(done.stdout)

    def ours(self, scene, spacing, *overrides):
        text = (SOURCE / "examples" / (scene + ".toml")).read_text(encoding="utf-8")
        arguments = [word for override in overrides for word in ("--set", override)]
        return read_summary(self.run_scene(text, "--set", f"body.spacing={spacing}", *arguments))

    def test_bar_is_the_bar_of_stress_points(self):
        # Between two nodes there is one gradient: both must come out with the same errors.
        for law, share in (("neo-hookean", 0.9), ("neo-hookean", 0.99), ("linear-elastic", 0.99)):
            with self.subTest(law=law, share=share):
                result = self.peer("bar_wave", 5e-4, "--law", law, "--share", str(share))
                summary = self.ours("bar_wave", 5e-4, f"material.law={law}", f"time.safety={share}")

                self.assertEqual((result["law"], result["step_share"]), (law, share))
                self.assertEqual((result["n"], result["particles"]), (300, summary["particles"]))
                self.assertEqual(result["steps"], summary["steps"])
                for name, error in summary["errors"].items():
                    self.assertAlmostEqual(result["errors"][name] / error, 1.0, delta=5e-3)

    def test_plate_converges_with_order_two(self):
        coarse, fine = self.peer("swinging_plate", 1 / 16), self.peer("swinging_plate", 1 / 32)

        for name, bound in (("displacement", 6e-5), ("velocity", 1e-3), ("stress", 4e-4)):
            self.assertAlmostEqual(math.log2(coarse["errors"][name] / fine["errors"][name]), 2.0, delta=0.2)
            self.assertLess(fine["errors"][name], bound)

    def test_beam_has_its_period(self):
        result = self.peer("clamped_beam", 5e-3)

        error = result["errors"]["tip.displacement_y.period"]
        self.assertAlmostEqual(error, -0.0027, delta=2e-4)  # one-point elements of assumed strain, 4 of them
        (quantity,) = result["quantities"]
        self.assertAlmostEqual(quantity["value"], 0.25523 * (1 + error), places=12)
        self.assertGreater(result["stepping_seconds"], 0.0)

    def test_unknown_scene(self):
        done = subprocess.run([sys.executable, "-B", SOURCE / "validation/peers/fe_q4.py", "stretch", "--spacing", "1"],
                              capture_output=True, text=True, check=False)

        self.assertEqual(done.returncode, 3)
        self.assertIn("clamped_beam, swinging_plate, bar_wave, not stretch", done.stderr)


if __name__ == "__main__":
    unittest.main()
