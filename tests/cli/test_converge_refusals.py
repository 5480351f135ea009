"""tlsph converge: what it refuses, what it keeps of runs that fail or are interrupted."""

import re
import signal
import unittest

from convergence import SMOOTH, Convergence
from support import SHEET


class Refusals(Convergence):
    def test_bad_input(self):
        free = SMOOTH.replace('[reference]\nexact = "bar-wave"\n', "")
        blind = re.sub(r"\[\[probe\]\]\n(?:[^\[\n].*\n)*", "", free)
        two = ["--spacing", "0.1,0.05"]
        for arguments, scene, message in (
            ([], SMOOTH, "--spacing"),
            (["--spacing"], SMOOTH, "--spacing"),
            (["--spacing", ""], SMOOTH, "--spacing"),
            (["--spacing", "0.1"], SMOOTH, "--spacing: 1 given; at least 2"),
            (["--spacing", "0.1,fine"], SMOOTH, "fine"),
            (["--spacing", "0.1,0.05x"], SMOOTH, "0.05x"),
            (["--spacing", "0.1,nan"], SMOOTH, "nan is no spacing"),
            (["--spacing", "0.1,inf"], SMOOTH, "inf is no spacing"),
            (["--spacing", "0.1,0"], SMOOTH, "0 is no spacing"),
            (["--spacing", "0.1,-0.05"], SMOOTH, "-0.05 is no spacing"),
            (["--spacing", "0.1,0.05,0.1"], SMOOTH, "0.1 stands twice"),
            (["--spacing", "0.1,0.07"], SMOOTH, "spacing"),
            (["--spacing", "0.1,1e-12"], SMOOTH, "spacing"),
            ([*two, "--formulation", "finite-elements"], SMOOTH, "finite-elements"),
            ([*two, "--formulation", "mirror,mirror"], SMOOTH, "mirror stands twice"),
            ([*two, "--formulation", ""], SMOOTH, "--formulation"),
            ([*two, "--set", "material.poisson=0.5"], SMOOTH, "poisson"),
            ([*two, "--set", "no.such=1"], SMOOTH, "no"),
            ([*two, "--threads", "0"], SMOOTH, "--threads"),
            ([*two, "--seed", "1,2"], SMOOTH, "--seed: the particles do not depend on it"),
            ([*two, "--seed", "1,x"], SMOOTH, "--seed"),
            ([*two, "--over", "kernel.support"], SMOOTH, "key=a,b"),
            ([*two, "--over", "body.spacing=0.1,0.2"], SMOOTH, "--spacing"),
            ([*two, "--over", "kernel.suport=2,3"], SMOOTH, "kernel.suport"),
            ([*two, "--value", "tip.cauchy_xx"], SMOOTH, "--value"),
            ([*two, "--value", "top.cauchy_xx.max"], SMOOTH, "no probe records top.cauchy_xx"),
            ([*two, "--cloud", "a.csv,b.csv"], SMOOTH, "--cloud"),
            (["--cloud", "a.csv,b.csv"], SMOOTH, "there is no file"),
            (["--cloud", "a.csv,a.csv"], SMOOTH, "--cloud: a.csv stands twice"),
            (["--cloud", "a.csv,b.csv", "--seed", "1,2"], SMOOTH, "--seed: a cloud has no seed"),
            (two, free, "at least 3"),
            (["--spacing", "0.1,0.05,0.025"], blind, "nothing to compare"),
            (two, "dimension = 7", "dimension"),
            (["--spacing", "0.2,0.1,0.05", "--formulation", "stress-point,mirror"], SHEET, "mirror"),
        ):
            with self.subTest(arguments):
                done = self.converge(*arguments, code=2, scene=scene)

                self.assertIn(message, done.stderr)
                self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
                self.assertEqual(done.stdout, "")
                self.assertEqual(self.listing(), ["scene.toml"])

    def test_no_such_scene(self):
        done = self.tlsph("converge", "nothing.toml", "--spacing", "0.1,0.05")

        self.assertEqual(done.returncode, 2)
        self.assertIn("nothing.toml", done.stderr)

    def test_output_in_the_way(self):
        self.write("study", "a file, not a folder")

        done = self.converge("--spacing", "0.1,0.05", "--out", "study", code=4)

        self.assertIn("study", done.stderr)


class Failures(Convergence):
    def test_failed_run_is_a_row(self):
        # A step of 1.5 ms holds at the spacings 0.2 and 0.1 (critical 5.4 and 2.7 ms), not at 0.0125.
        done = self.converge(
            "--spacing", "0.2,0.0125,0.1", "--out", "study", "--set", "time.step=1.5e-3",
            "--set", "time.allow_unstable=true", "--set", "time.end=0.5", "--set", "material.law=neo-hookean", code=3,
        )

        rows = self.rows()
        self.assertEqual([bool(row["failure"]) for row in rows], [False, False, True])
        self.assertEqual(rows[2]["displacement"], "")
        self.assertGreater(float(rows[1]["displacement"]), 0.0)
        self.assertIn("failed: " + rows[2]["failure"], done.stdout)
        self.assertIn("1 of 3 runs failed", done.stderr)
        self.assertEqual(self.report()["rows"][2]["failure"], rows[2]["failure"])

    def assert_keeps_what_is_done(self, number, code):
        self.write("scene.toml", SMOOTH)
        process = self.start("converge", "scene.toml", "--spacing", "0.1,0.05,0.0001", "--out", "study",
                             "--threads", "1", "--quiet", "--set", "time.end=1.0")
        self.wait_for(
            lambda: (self.folder / "study/convergence.csv").is_file() and len(self.rows()) >= 2, process
        )

        process.send_signal(number)

        self.assertEqual(process.wait(timeout=120), code)
        self.assertEqual([float(row["spacing"]) for row in self.rows()], [0.1, 0.05])
        self.assertTrue(self.report()["interrupted"])

    def test_interrupt(self):
        self.assert_keeps_what_is_done(signal.SIGINT, 130)

    def test_terminate(self):
        self.assert_keeps_what_is_done(signal.SIGTERM, 143)


if __name__ == "__main__":
    unittest.main()
