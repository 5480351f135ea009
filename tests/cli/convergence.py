"""What the tests of `tlsph converge` share: a study in a folder of its own, and what it leaves behind."""

import csv
import json
import os

import numpy as np

from support import BAR, ProgramTest

# The exact solution is that of a linear bar.
SMOOTH = BAR.replace("rise = 5e-3", "rise = 1e-2").replace("[material]", '[material]\nlaw = "linear-elastic"')


class Convergence(ProgramTest):
    def converge(self, *arguments, code=0, scene=SMOOTH, **options):
        self.write("scene.toml", scene)
        done = self.tlsph("converge", "scene.toml", *arguments, **options)
        self.assertEqual(done.returncode, code, done.stderr)
        return done

    def rows(self, out="study"):
        with open(self.folder / out / "convergence.csv", encoding="utf-8", newline="") as file:
            return list(csv.DictReader(file))

    def report(self, out="study"):
        return json.loads((self.folder / out / "convergence.json").read_text(encoding="utf-8"))

    @staticmethod
    def numbers(rows, name):
        return np.array([float(row[name]) for row in rows])

    @staticmethod
    def without_figure():
        return dict(os.environ, TLSPH_PLOT="/no/such/plot.py")
