"""tlsph stability: the atlas of a small selection, its files and figure, what it refuses."""

import csv
import json
import os
import signal
import unittest

from support import BAR, SOURCE, SHEET, ProgramTest

HEADER = (
    "name,method,formulation,kernel,support,body,jitter,poisson,stretch,particles,verdict,refusal,acoustic,imbalance,"
    "unrest,critical_step,true_limit,soft_modes,excursion,negative,growth,label,dt_ratio,growth_expected,growth_seen,"
    "amplitude,energy_drift,steps,lost_at"
)
#  SHEET has 11 x 11 particles.
PAIR = r"^stress-point cells( \+ S)?, jitter 0.2, nu 0.3, stretch 1$"


class Stability(ProgramTest):
    def stability(self, only, *arguments, scene=SHEET, code=0, **options):
        self.write("scene.toml", scene)
        done = self.tlsph("stability", "scene.toml", "--only", only, "--out", "atlas", *arguments, **options)
        self.assertEqual(done.returncode, code, done.stderr)
        return done

    def rows(self):
        with open(self.folder / "atlas/stability.csv", encoding="utf-8", newline="") as file:
            return list(csv.DictReader(file))

    def report(self):
        return json.loads((self.folder / "atlas/stability.json").read_text(encoding="utf-8"))


class Atlas(Stability):
    def test_failure_and_cure(self):
        done = self.stability(PAIR)

        self.assertEqual(done.stderr, "")
        text = (self.folder / "atlas/stability.csv").read_text(encoding="utf-8")
        self.assertEqual(text.splitlines()[0], HEADER)
        rows = self.rows()
        self.assertEqual([row["verdict"] for row in rows], ["stable"] * 2 + ["soft"] * 2)
        self.assertEqual([row["label"] for row in rows], ["0.95", "1.02"] * 2)
        self.assertEqual({row["particles"] for row in rows}, {"121"})
        for row in rows:
            self.assertAlmostEqual(float(row["critical_step"]) / float(row["true_limit"]), 1.0, delta=5e-3)
            above = row["label"] == "1.02"
            self.assertEqual(int(row["lost_at"] or 0) > 0, above, row["name"])
            if above:
                self.assertAlmostEqual(float(row["growth_seen"]) / float(row["growth_expected"]), 1.0, delta=0.03)
        self.assertAlmostEqual(float(rows[0]["excursion"]), 1.0, delta=0.05)
        self.assertGreater(float(rows[2]["excursion"]), 10.0)
        report = self.report()
        self.assertEqual(report["dimension"], 2)
        self.assertEqual(report["step"]["stable_states"], 2)
        self.assertEqual(report["step"]["lost_runs"], 0)
        soft = report["failures"][0]
        self.assertIn("without energy", soft["what"])
        self.assertIn("stress-point cells + S", soft["cured"])
        for line in (soft["why"], soft["cure"], "0 were lost at 0.95"):
            self.assertIn(line, done.stdout)

    def test_figure(self):
        done = self.stability(PAIR + "|^waves of stress-point cells")

        self.assertIn("drawn in atlas/stability.png", done.stdout)
        self.assertGreater((self.folder / "atlas/stability.png").stat().st_size, 10_000)
        with open(self.folder / "atlas/waves.csv", encoding="utf-8", newline="") as file:
            waves = list(csv.DictReader(file))
        self.assertEqual({row["method"] for row in waves}, {"stress-point cells + S", "stress-point cells"})

    def test_a_body_of_many_particles_is_made_small(self):
        self.stability("^stress-point, lattice, nu 0.3, stretch 2$", "--set", "body.spacing=0.001", scene=BAR)

        self.assertEqual({row["particles"] for row in self.rows()}, {"61"})

    def test_quiet(self):
        done = self.stability("^updated", "--quiet", env=dict(os.environ, TLSPH_PLOT="/no/such/plot.py"))

        self.assertEqual(done.stdout, "")
        self.assertEqual(len(self.report()["contrast"]), 4)

    def test_an_interrupt_leaves_what_was_done(self):
        process = self.start("stability", SOURCE / "validation/stability/bar.toml", "--out", "atlas")
        self.assertIsNone(process.poll())
        try:
            process.wait(timeout=3)
        except Exception:  # still at work, as it should be
            process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(timeout=60), 130)
        report = self.report()
        self.assertTrue(report["interrupted"])
        self.assertGreater(len(report["rows"]), 0)


class Refused(Stability):
    def test_selection(self):
        for only, words in (("(", "no regular expression"), ("^no such row$", "matches no row")):
            done = self.stability(only, code=2)
            self.assertIn(words, done.stderr)
            self.assertFalse((self.folder / "atlas").exists())

    def test_output_that_cannot_be_written(self):
        (self.folder / "atlas").write_text("a file in the way")
        done = self.stability("", code=4)  # at once, not after the minute that all of it takes
        self.assertIn("atlas", done.stderr)

    def test_two_materials(self):
        scene = SHEET.replace("[material]", "[[material]]").replace(
            "[[boundary]]",
            "[[material]]\nbox = [[0.0, 0.0], [0.5, 1.0]]\nyoung = 2e6\npoisson = 0.3\ndensity = 1000\n[[boundary]]",
            1,
        )
        done = self.stability(PAIR, scene=scene, code=2)
        self.assertIn("scene.toml:", done.stderr)
        self.assertIn("material", done.stderr)


if __name__ == "__main__":
    unittest.main()
