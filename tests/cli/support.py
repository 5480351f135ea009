"""The program from outside: run it in a fresh folder and look at what it leaves behind."""

import csv
import json
import os
import pathlib
import subprocess
import tempfile
import time
import unittest

PROGRAM = os.environ.get("TLSPH_PROGRAM", "")
SOURCE = pathlib.Path(__file__).resolve().parents[2]

BAR = """\
title = "bar"
dimension = 1
[body]
shape = { interval = [0.0, 1.0] }
spacing = 0.05
[material]
young = 1e6
poisson = 0.3
density = 1000
[[boundary]]
where = "left"
fixed = true
[[boundary]]
where = "right"
traction = { curve = "smooth-ramp", amplitude = 1e3, rise = 5e-3 }
[time]
end = 2e-2
[[probe]]
name = "tip"
at = [1.0]
record = ["displacement", "cauchy"]
[[probe]]
at = [0.5]
[reference]
exact = "bar-wave"
[output]
frames = 4
"""

SHEET = """\
title = "sheet"
[body]
shape = { box = [[0.0, 0.0], [1.0, 1.0]] }
spacing = 0.1
[material]
young = 1e6
poisson = 0.3
density = 1000
[[boundary]]
where = "left"
fixed = true
[[boundary]]
where = "right"
traction = { curve = "sine-squared", amplitude = [0.0, 1e3], duration = 5e-3 }
[time]
end = 2e-2
[[probe]]
name = "corner"
at = [1.0, 1.0]
record = ["displacement", "pk1", "von_mises"]
[output]
frames = 4
"""

# Drawn to four times its length; at 3.63 its law carries no waves any more.
RUBBER = """\
dimension = 1
[body]
shape = { interval = [0.0, 1.0] }
spacing = 0.1
[material]
young = 1e6
poisson = 0.49
density = 1000
[[boundary]]
where = "left"
fixed = true
[[boundary]]
where = "right"
displacement = { x = { curve = "ramp", amplitude = 3.0, rise = 0.3 } }
[initial]
velocity = { gradient = [[10.0]] }
[time]
end = 0.3
[output]
frames = 4
energy_every = 1
"""


class ProgramTest(unittest.TestCase):
    """A test with a folder of its own, which is also the program's working directory."""

    def setUp(self):
        if not PROGRAM:
            self.fail("set TLSPH_PROGRAM to the path of the program")
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def write(self, name, text):
        path = self.folder / name
        path.write_text(text, encoding="utf-8")
        return path

    def tlsph(self, *arguments, **options):
        """Runs the program to its end; paths among the arguments are relative to the folder."""
        return subprocess.run(
            [PROGRAM, *map(str, arguments)],
            cwd=self.folder,
            capture_output=True,
            text=True,
            encoding="utf-8",
            errors="replace",
            timeout=300,
            check=False,
            stdin=subprocess.DEVNULL,
            **options,
        )

    def start(self, *arguments):
        """Starts the program; the caller waits for it."""
        process = subprocess.Popen(
            [PROGRAM, *map(str, arguments)],
            cwd=self.folder,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.stderr.close)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def wait_for(self, condition, process, what="the study"):
        """Until the condition holds; the process must not end before that."""
        limit = time.monotonic() + 120
        while not condition():
            self.assertIsNone(process.poll(), f"{what} ended before it could be interrupted")
            self.assertLess(time.monotonic(), limit)
            time.sleep(0.02)

    def run_scene(self, text, *arguments, name="scene.toml", out="results"):
        """Runs a scene that must succeed; returns the folder of its results."""
        self.write(name, text)
        done = self.tlsph("run", name, "--out", out, "--quiet", *arguments)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return self.folder / out

    def listing(self):
        return sorted(str(path.relative_to(self.folder)) for path in self.folder.rglob("*"))


def read_probes(path):
    """Header and rows of probes.csv, the numbers as they are written."""
    with open(path, encoding="utf-8", newline="") as file:
        header, *rows = csv.reader(file)
    return header, rows


def read_summary(path):
    return json.loads((path / "summary.json").read_text(encoding="utf-8"))


def broken_scenes():
    """(case, text, line, key, phrase) for each scene of tests/data/broken_scenes.txt."""
    bases, cases, target = {}, [], None
    for line in (SOURCE / "tests/data/broken_scenes.txt").read_text(encoding="utf-8").splitlines():
        if line.startswith("== base "):
            target = bases.setdefault(line[8:], [])
        elif line.startswith("== "):
            case, base = line[3:].rsplit(" : ", 1)
            target = []
        elif line.startswith("? "):
            place, phrase = line[2:].split(" | ", 1)
            number, key = place.split(" ", 1)
            cases.append((case, edited(bases[base], target), int(number), key, phrase))
        elif target is not None and line:
            target.append(line)
    return cases


def edited(base, edits):
    lines, at = list(base), len(base)
    for edit in edits:
        if edit[0] == "-":
            at = lines.index(edit[2:])
            del lines[at]
        else:
            lines.insert(at, edit[2:])
            at += 1
    return "\n".join(lines) + "\n"
