"""Commands, options, help, and the exit codes of the command line."""

import re
import unittest

from support import BAR, ProgramTest


class CommandLine(ProgramTest):
    def test_misuse_is_bad_input(self):
        self.write("scene.toml", BAR)
        for arguments in (
            [],
            ["fly"],
            ["run"],
            ["run", "scene.toml", "extra.toml"],
            ["run", "scene.toml", "--speed", "9"],
            ["run", "scene.toml", "--threads", "many"],
            ["run", "scene.toml", "--threads", "0"],
            ["run", "scene.toml", "--set"],
            ["export", "scene.toml"],
            ["plan"],
        ):
            with self.subTest(arguments):
                done = self.tlsph(*arguments)

                self.assertEqual(done.returncode, 2)
                self.assertRegex(done.stderr, r"^tlsph: .+; see tlsph --help\n$")
                self.assertEqual(done.stdout, "")
                self.assertEqual(self.listing(), ["scene.toml"])

    def test_help_names_every_command(self):
        done = self.tlsph("--help")

        self.assertEqual((done.returncode, done.stderr), (0, ""))
        for command in ("run", "plan", "export", "converge", "chart", "fit", "stability", "validate", "benchmark",
                        "scene-reference"):
            self.assertRegex(done.stdout, rf"(?m)^  {command} ")

    def test_help_of_a_command(self):
        done = self.tlsph("run", "--help")

        self.assertEqual((done.returncode, done.stderr), (0, ""))
        for option in ("--set", "--out", "--threads", "--quiet", "--resume"):
            self.assertIn(option, done.stdout)

    def test_version(self):
        done = self.tlsph("--version")

        self.assertEqual(done.returncode, 0)
        self.assertRegex(done.stdout, r"^\d+\.\d+\.\d+\n$")

    def test_scene_reference(self):
        done = self.tlsph("scene-reference")

        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertRegex(done.stdout, r"(?m)^  end +number \[s\], required$")
        self.assertEqual(self.listing(), [])

    def test_plan_runs_nothing(self):
        self.write("scene.toml", BAR)

        done = self.tlsph("plan", "scene.toml", "--set", "body.spacing=0.025")

        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertRegex(done.stdout, r"\b41\b")  # particles
        self.assertEqual(self.listing(), ["scene.toml"])

    def test_full_disk(self):
        with open("/dev/full", "w", encoding="utf-8") as full:
            import subprocess

            from support import PROGRAM

            done = subprocess.run(
                [PROGRAM, "scene-reference"], stdout=full, stderr=subprocess.PIPE, text=True, check=False
            )

        self.assertEqual(done.returncode, 4)
        self.assertTrue(re.search("could not be written", done.stderr))


if __name__ == "__main__":
    unittest.main()
