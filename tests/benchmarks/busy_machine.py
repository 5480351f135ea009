#!/usr/bin/env python3
"""What the default number of threads costs where other programs keep every core busy.

    busy_machine.py PROGRAM [SCENE]    PROGRAM: build/release/tlsph

Runs a scene by default and with `--threads 1`, in turns, beside one spinning process a core, and
prints the seconds of each and the ratio of their medians. Exit code 1 if it is above 1.2. On a
machine that does nothing else: other load makes the times of either wander.
"""

import json
import multiprocessing
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

LIMIT = 1.2
ROUNDS = 5

# Two thousand particles in plane stress: a step is short, so that waiting weighs most.
SCENE = """\
[body]
shape = { box = [[0.0, 0.0], [0.1, 0.02]] }
spacing = 1e-3
[material]
assumption = "stress"
young = 1e6
poisson = 0.49
density = 1000
[[boundary]]
where = "left"
fixed = true
[[boundary]]
where = "right"
traction = { curve = "smooth-ramp", amplitude = 1e3, rise = 0.05 }
[time]
end = 0.2
"""


def spin():
    while True:
        pass


def seconds(program, scene, folder, *arguments):
    out = pathlib.Path(folder) / "out"
    subprocess.run([program, "run", scene, "--out", out, "--quiet", *arguments], check=True)
    summary = json.loads((out / "summary.json").read_text(encoding="utf-8"))
    return summary["wall_seconds"]["setup"] + summary["wall_seconds"]["stepping"]


def main():
    program = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        scene = pathlib.Path(folder) / "scene.toml"
        scene.write_text(SCENE, encoding="utf-8")
        if len(sys.argv) > 2:
            scene = sys.argv[2]
        others = [multiprocessing.Process(target=spin, daemon=True) for _ in range(os.cpu_count())]
        for other in others:
            other.start()
        times = {"default": [], "--threads 1": []}
        try:
            for _ in range(ROUNDS):
                times["default"].append(seconds(program, scene, folder))
                times["--threads 1"].append(seconds(program, scene, folder, "--threads", "1"))
        finally:
            for other in others:
                other.terminate()
    for name, all_times in times.items():
        print(f"{name:12}", *(f"{value:8.3f}" for value in all_times), "s")
    ratio = statistics.median(times["default"]) / statistics.median(times["--threads 1"])
    print(f"ratio of the medians {ratio:.2f}, at most {LIMIT}")
    return 1 if ratio > LIMIT else 0


if __name__ == "__main__":
    sys.exit(main())
