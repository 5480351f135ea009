"""Nodes from a file of points, and hexagonal ones: run, planned, exported; what is wrong is named."""

import json
import math
import random
import re
import unittest

import h5py
from support import SHEET, SOURCE, ProgramTest, read_probes, read_summary

CLOUD = SHEET.replace("spacing = 0.1", 'cloud = "points.csv"')

# (case, the whole file, line and column, phrase).
BROKEN = [
    ("empty", "", "1:1", "empty; the first line must name the columns"),
    ("no rows", "x,y\n", "1:1", "no points below the header"),
    ("no header", "0,0\n1,0\n", "1:1", 'unknown column "0"; allowed: x, y, volume, tag'),
    ("missing column", "x,tag\n0,a\n", "1:1", 'the column "y" is missing'),
    ("unknown column", "x,y,colour\n0,0,red\n", "1:5", 'unknown column "colour"'),
    ("no number", "x,y\n0,0\n0,one\n", "3:3", '"one" is no finite number'),
    ("not finite", "x,y\n0,nan\n", "2:3", '"nan" is no finite number'),
    ("short row", "x,y,tag\n0,0,a\n1,0\n", "3:1", "2 cells where the header has 3"),
]

# A section of a dam on a rigid base under its weight, its left face loaded within 0.3 s.
DAM = """\
gravity = [0.0, -9.81]
[body]
cloud = "points.csv"
shape = { polygon = [[0.0, 0.0], [1.0, 0.0], [0.6, 1.0], [0.2, 1.0]] }
[material]
law = "linear-elastic"
assumption = "strain"
young = 1e7
poisson = 0.2
density = 2400
[[boundary]]
where = "base"
fixed = true
[[boundary]]
where = "left_face"
traction = { curve = "smooth-ramp", amplitude = -5e3, rise = 0.3 }
[time]
end = 0.5
[[probe]]
name = "crest"
at = [0.4, 1.0]
record = ["displacement"]
[output]
frames = 1
"""

LATTICE = """\
formulation = "consistent"
[body]
shape = SHAPE
spacing = SIZE
[material]
young = 1e7
poisson = 0.3
density = 1000
[time]
end = 1e-6
[output]
frames = 0
"""

CORNERS = "x,y\n0,0\n1,0\n1,1\n0,1\n"

MISPLACED = [
    ("outside", CORNERS + "1.5,0.5\n", 6, "the point (1.5, 0.5) lies outside the shape"),
    ("twice", CORNERS + "0.5,0.5\n0.5,0.5\n", 7, "the point (0.5, 0.5) stands where (0.5, 0.5) does, on line 6"),
    ("no corner", "x,y\n0,0\n1,0\n0.8,1\n0,1\n", 4, "the shape has a corner at (1, 1)"),
    ("bare boundary", CORNERS + "0.5,0.05\n", None, "too few points on the boundary"),
    ("volume", "x,y,volume\n0,0,1\n1,0,-1\n1,1,1\n0,1,1\n", 3, "a volume must be greater than 0, not -1"),
    ("volumes", "x,y,volume\n0,0,1\n1,0,1\n1,1,1\n0,1,1\n", 2, "the volumes sum to 4, but the shape has 1"),
    ("tag of a patch", "x,y,tag\n0,0,left\n1,0,\n1,1,\n0,1,\n", 2, 'tag "left" already names'),
]


def lattice(n, tag=""):
    """Rows of a file: n + 1 points a side, every other row shifted within."""
    rows = []
    for j in range(n + 1):
        inner = [(i + (0.5 if j % 2 else 0.0)) / n for i in range(1, n - (j % 2 == 1))]
        rows += [f"{x:.9g},{j / n:.9g},{tag if x == 1.0 else ''}" for x in [0.0, *inner, 1.0]]
    return "x,y,tag\n" + "\n".join(rows) + "\n"


class BadClouds(ProgramTest):
    def refused(self, points, scene=CLOUD):
        self.write("scene.toml", scene)
        if points is not None:
            self.write("points.csv", points)
        before = self.listing()

        done = self.tlsph("run", "scene.toml", "--out", "results")

        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(done.stdout, "")
        self.assertEqual(self.listing(), before)
        return done.stderr

    def test_files(self):
        for case, text, place, phrase in BROKEN:
            with self.subTest(case):
                message = self.refused(text)

                self.assertTrue(message.startswith(f"points.csv:{place}: "), message)
                self.assertIn(phrase, message)

    def test_points(self):
        for case, text, line, phrase in MISPLACED:
            with self.subTest(case):
                message = self.refused(text)

                self.assertRegex(message, rf"^points\.csv:{line or '[0-9]+'}:1: ")
                self.assertIn(phrase, message)

    def test_missing_file(self):
        message = self.refused(None)
        self.assertRegex(message, r"^scene\.toml:4:9: body\.cloud: there is no file points\.csv")

    def test_path_is_relative_to_the_scene(self):
        (self.folder / "scenes").mkdir()
        self.write("scenes/scene.toml", CLOUD)
        self.write("scenes/points.csv", "x,y\n")

        done = self.tlsph("plan", "scenes/scene.toml")

        self.assertRegex(done.stderr, r"^scenes/points\.csv:1:1: no points")

    def test_what_does_not_go_with_a_cloud(self):
        for more, key, phrase in [
            ('layout = "hexagonal"', "body.layout", "leave it out"),
            ("jitter = 0.1", "body.jitter", "allowed: 0"),
            ("fit = false", "body.fit", "allowed: true"),
        ]:
            with self.subTest(more):
                message = self.refused(CORNERS, CLOUD.replace("cloud =", more + "\ncloud ="))

                self.assertRegex(message, rf"^scene\.toml:4:\d+: {re.escape(key)}: ")
                self.assertIn(phrase, message)


class GoodClouds(ProgramTest):
    def test_tags_carry_conditions(self):
        self.write("points.csv", lattice(8, "end"))
        self.write("scene.toml", CLOUD.replace('where = "right"', 'where = "end"'))
        self.write("same.toml", CLOUD)
        for formulation in ("stress-point", "consistent", "variational"):
            with self.subTest(formulation):
                rows = []
                for scene in ("scene.toml", "same.toml"):
                    done = self.tlsph("run", scene, "--set", f"formulation={formulation}", "--out", "results")
                    self.assertEqual(done.returncode, 0, done.stderr)
                    rows.append((self.folder / "results/probes.csv").read_text())

                self.assertEqual(rows[0], rows[1])
                summary = json.loads((self.folder / "results/summary.json").read_text())
                self.assertEqual(summary["formulation"], formulation)
                self.assertGreater(abs(float(rows[0].splitlines()[-1].split(",")[2])), 0.0)

    def test_order_of_the_file(self):
        header, *rows = lattice(12).splitlines()
        probes = []
        for seed in (None, 3):
            listed = list(rows)
            if seed is not None:
                random.Random(seed).shuffle(listed)
            self.write("points.csv", "\n".join([header, *listed]) + "\n")
            self.write("scene.toml", CLOUD)
            done = self.tlsph("run", "scene.toml", "--out", "results")
            self.assertEqual(done.returncode, 0, done.stderr)
            probes.append([float(x) for x in (self.folder / "results/probes.csv").read_text().split("\n")[-2].split(",")])

            with h5py.File(self.folder / "results/run.h5") as file:
                lines, X = file["particles/line"][:], file["particles/X"][:]
            self.assertEqual(sorted(lines), list(range(2, len(rows) + 2)))
            for line, x in zip(lines, X):
                for cell, coordinate in zip(listed[line - 2].split(","), x):
                    self.assertAlmostEqual(float(cell), coordinate, delta=1e-9)
            way = sum(math.dist(a, b) for a, b in zip(X, X[1:])) / len(X)
            self.assertLess(way, 3 / 12)  # at random it is half of the side

        for one, other in zip(*probes):
            self.assertAlmostEqual(one, other, delta=1e-9 * max(abs(one), 1e-12))

    def test_plan_and_export(self):
        self.write("points.csv", lattice(6))
        self.write("scene.toml", CLOUD)

        plan = self.tlsph("plan", "scene.toml")
        export = self.tlsph("export", "scene.toml", "--out", "matrices")

        self.assertEqual(plan.returncode, 0, plan.stderr)
        self.assertIn("points of points.csv", plan.stdout)
        self.assertRegex(plan.stdout, r"spacing 0\.\d+ m, estimated from the points\n")
        self.assertIn("triangles between them", plan.stdout)
        self.assertEqual(export.returncode, 0, export.stderr)
        report = json.loads((self.folder / "matrices/report.json").read_text())
        self.assertTrue(report)

    def test_formulations_agree(self):
        self.write("points.csv", (SOURCE / "tests/data/dam.csv").read_text())
        largest = []
        for formulation in ("consistent", "stress-point"):
            out = self.run_scene(DAM, "--set", f"formulation={formulation}", out=formulation)
            _, rows = read_probes(out / "probes.csv")
            largest.append([max(abs(float(row[column])) for row in rows) for column in (1, 2)])
        for one, other in zip(*largest):
            self.assertAlmostEqual(one, other, delta=0.02 * other)

    def test_a_sharp_tip(self):
        # Within the support of a point in the 27 degree tip lie five others, of the six that a
        # polynomial of degree two needs.
        scene = LATTICE.replace("SHAPE", "{ polygon = [[0.0, 0.0], [2.0, 0.0], [0.0, 1.0]] }").replace("SIZE", "0.05")
        consistency = read_summary(self.run_scene(scene))["consistency"]
        self.assertLess(max(consistency["row_residual"], consistency["column_residual"]), 1e-12)

    def test_a_thin_strip(self):
        scene = LATTICE.replace("SHAPE", "{ box = [[0.0, 0.0], [1.2, 0.004]] }").replace("SIZE", "0.002")
        consistency = read_summary(self.run_scene(scene))["consistency"]
        self.assertLess(max(consistency["row_residual"], consistency["column_residual"]), 1e-12)

    def test_a_void_is_remarked(self):
        def rows(void, jitter):
            draw = random.Random(3)
            for i in range(13):
                for j in range(13):
                    inner = 0 < i < 12 and 0 < j < 12
                    move = [draw.uniform(-jitter, jitter) if inner else 0.0 for _ in "xy"]
                    if not void or max(abs(i - 6), abs(j - 6)) > 1:
                        yield f"{(i + move[0]) / 12:.9g},{(j + move[1]) / 12:.9g}\n"

        self.write("scene.toml", CLOUD)
        for void, jitter in ((True, 0.0), (True, 0.3), (False, 0.0), (False, 0.3)):
            self.write("points.csv", "x,y\n" + "".join(rows(void, jitter)))
            planned = self.tlsph("plan", "scene.toml")
            done = self.tlsph("run", "scene.toml", "--out", "results")
            with self.subTest(void=void, jitter=jitter):
                self.assertEqual((planned.returncode, done.returncode), (0, 0), planned.stderr + done.stderr)
                warnings = json.loads((self.folder / "results/summary.json").read_text())["warnings"]
                self.assertEqual(len(warnings), 1 if void else 0)
                for text in (planned.stdout, done.stdout, *warnings):
                    self.assertEqual("no point of points.csv lies within" in text, void)

    def test_hexagonal(self):
        self.write("scene.toml", SHEET.replace("spacing = 0.1", 'spacing = 0.1\nlayout = "hexagonal"'))

        done = self.tlsph("run", "scene.toml", "--out", "results")

        self.assertEqual(done.returncode, 0, done.stderr)
        summary = json.loads((self.folder / "results/summary.json").read_text())
        self.assertGreater(summary["particles"], 121)
        self.assertGreater(summary["points"], 2.5 * summary["particles"])

    def test_in_one_dimension(self):
        self.write("points.csv", "x\n" + "\n".join(str((k / 20) ** 1.2) for k in range(21)) + "\n")
        bar = (
            'dimension = 1\nformulation = "consistent"\n[body]\nshape = { interval = [0.0, 1.0] }\n'
            'cloud = "points.csv"\n[material]\nyoung = 1e6\npoisson = 0.3\ndensity = 1000\n'
            '[[boundary]]\nwhere = "left"\nfixed = true\n[time]\nend = 1e-3\n'
            '[initial]\nvelocity = { gradient = [[1.0]] }\n'
        )
        for formulation in ("consistent", "stress-point"):
            with self.subTest(formulation):
                self.write("scene.toml", bar.replace("consistent", formulation))

                done = self.tlsph("run", "scene.toml", "--out", "results")

                self.assertEqual(done.returncode, 0, done.stderr)


if __name__ == "__main__":
    unittest.main()
