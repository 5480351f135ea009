"""Whatever is wrong with a scene: exit code 2, place, key and remedy on stderr, nothing written."""

import os
import re
import unittest

from support import BAR, SHEET, ProgramTest, broken_scenes


class BadScenes(ProgramTest):
    def assert_refused(self, text, line, key, phrase, *arguments):
        self.write("scene.toml", text)

        done = self.tlsph("run", "scene.toml", "--out", "results", *arguments)

        key = "" if key == "-" else re.escape(key) + ": "
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertRegex(done.stderr, rf"^scene\.toml:{line}:\d+: {key}")
        self.assertIn(phrase, done.stderr)
        self.assertEqual(done.stdout, "")
        self.assertEqual(self.listing(), ["scene.toml"])

    def test_table(self):
        cases = broken_scenes()
        self.assertGreaterEqual(len(cases), 40)
        for case, text, line, key, phrase in cases:
            with self.subTest(case):
                self.assert_refused(text, line, key, phrase)


# What only shows when the body is built: (case, base, old, new, line, key, phrase).
WHEN_BUILT = [
    ("unknown patch", SHEET, 'where = "left"', 'where = "west"', 9, "boundary[0]", "left"),
    ("no hole to hold", SHEET, 'where = "left"', 'where = "hole"', 9, "boundary[0]", "left"),
    ("spacing that does not divide the body", BAR, "spacing = 0.05", "spacing = 0.06", 5,
     "body.spacing", "1 %"),
    ("spacing larger than the body", BAR, "spacing = 0.05", "spacing = 2.0", 5, "body.spacing", ""),
    ("more particles than memory", SHEET, "spacing = 0.1", "spacing = 1e-6", 4, "body.spacing",
     "memory"),
    ("more particles than integers", SHEET, "spacing = 0.1", "spacing = 1e-300", 4, "body.spacing",
     ""),
    ("region between the particles", SHEET, "density = 1000",
     "density = 1000\n[[material.region]]\nbox = [[0.12, 0.12], [0.13, 0.13]]\nyoung = 2e6", 9,
     "material.region[0]", "region"),
    ("tag between the particles", SHEET, "spacing = 0.1",
     'spacing = 0.1\ntags = [{ name = "spot", box = [[0.12, 0.12], [0.13, 0.13]] }]', 5,
     "body.tags[0]", ""),
    ("tag with the name of a patch", SHEET, "spacing = 0.1",
     'spacing = 0.1\ntags = [{ name = "left", box = [[0.0, 0.0], [0.5, 0.5]] }]', 5,
     "body.tags[0]", "left"),
    ("corner with two displacements", SHEET, 'where = "right"',
     'where = "top"\ndisplacement = { x = 0.1 }\n[[boundary]]\nwhere = "right"', 12,
     "boundary[1]", "two displacements"),
]


class BadBodies(BadScenes):
    def test_table(self):
        for case, base, old, new, line, key, phrase in WHEN_BUILT:
            with self.subTest(case):
                self.assertEqual(base.count(old), 1)
                self.assert_refused(base.replace(old, new), line, key, phrase)

    def test_symmetry_about_a_curve(self):
        text = SHEET.replace(
            "shape = { box = [[0.0, 0.0], [1.0, 1.0]] }",
            "shape = { difference = [{ box = [[0.0, 0.0], [1.0, 1.0]] }, "
            "{ disc = { centre = [0.5, 0.5], radius = 0.25 } }] }",
        ).replace('where = "left"\nfixed = true', 'where = "hole"\nsymmetry = true')

        self.assert_refused(text, 9, "boundary[0]", "no straight edge")

    def test_cholmod_on_an_indefinite_matrix(self):
        text = (
            'formulation = "thesis"\nboundary_solver = "cholmod"\n'
            + SHEET.replace("[0.0, 1e3]", "1e3")
            + '[[boundary]]\nwhere = "top"\nsymmetry = true\n'
            + '[[boundary]]\nwhere = "bottom"\nsymmetry = true\n'
            + "[kernel]\nsupport = 4.5\n"
        )

        self.assert_refused(text, 2, "boundary_solver", "umfpack")


class BadFiles(ProgramTest):
    def assert_refused(self, message, *arguments):
        before = self.listing()

        done = self.tlsph("run", *arguments, "--out", "results")

        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertRegex(done.stderr, message)
        self.assertEqual(self.listing(), before)

    def test_missing(self):
        self.assert_refused("^no/scene.toml: no such file\n$", "no/scene.toml")

    def test_directory(self):
        self.assert_refused(": a directory, not a scene file\n$", self.folder)

    def test_binary(self):
        (self.folder / "noise.toml").write_bytes(bytes(range(256)))
        self.assert_refused(r"^noise\.toml:1:1: a binary file, not a scene", "noise.toml")

    def test_latin_1(self):
        (self.folder / "latin.toml").write_bytes('# ok\ntitle = "Stäbchen"\n'.encode("latin-1"))
        self.assert_refused(r"^latin\.toml:2:12: byte 0xe4 is not UTF-8", "latin.toml")

    def test_empty(self):
        self.write("empty.toml", "")
        self.assert_refused(r"^empty\.toml:1:1: empty", "empty.toml")

    def test_endless(self):
        self.assert_refused("^/dev/zero: larger than 16 MiB", "/dev/zero")

    @unittest.skipIf(os.geteuid() == 0, "root may read everything")
    def test_forbidden(self):
        self.write("secret.toml", BAR).chmod(0)
        self.assert_refused("^secret.toml: cannot be read", "secret.toml")


class BadOverrides(ProgramTest):
    def test_are_named(self):
        for change, message in [
            ("body.spacng=1", "unknown key, did you mean body.spacing"),
            ("body.spacing=-1", "must be > 0, not -1"),
            ("probe[7].at=[0.5]", "probe has 2 entries; the next index is 2"),
            ("boundary[0].fixed.x=1", "boundary[0].fixed is true, not a table"),
            ("nonsense", "an override is key=value"),
        ]:
            with self.subTest(change):
                self.write("scene.toml", BAR)

                done = self.tlsph("run", "scene.toml", "--out", "results", "--set", change)

                self.assertEqual(done.returncode, 2)
                self.assertTrue(done.stderr.startswith(f"--set {change}: {message}"), done.stderr)
                self.assertEqual(self.listing(), ["scene.toml"])


class OtherCommands(ProgramTest):
    def test_refuse_the_same(self):
        self.write("scene.toml", BAR.replace("spacing = 0.05", "spacing = 0"))
        for command in (["plan", "scene.toml"], ["export", "scene.toml", "--out", "matrices"]):
            with self.subTest(command[0]):
                done = self.tlsph(*command)

                self.assertEqual(done.returncode, 2)
                self.assertEqual(done.stderr, "scene.toml:5:11: body.spacing: must be > 0, not 0\n")
                self.assertEqual(self.listing(), ["scene.toml"])


if __name__ == "__main__":
    unittest.main()
