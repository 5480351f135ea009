"""What every peer script shares: its command line and what it prints.

    NAME.py SCENE --spacing H [--end T]

prints one line of JSON: peer, scene, n, spacing, particles, steps, stepping_seconds, repetitions, errors,
quantities, note. `n` counts cells across the body, `stepping_seconds` is the time of the steps alone,
without set-up and output, on one thread, the median of the `repetitions`. `errors` are relative, by name;
`quantities` is the same as a list of {name, error, value}, value null for fields. Exit code 3 if the program
behind the peer is not installed or cannot run the scene, with the reason on stderr.
"""

import argparse
import json
import os
import shutil
import statistics
import sys
from pathlib import Path

from scenes import SCENES


class Unable(Exception):
    """Why a peer cannot do what it is asked."""


def need(program, package):
    found = shutil.which(program)
    if not found:
        raise Unable(f"{program} is not installed (Debian: apt-get install {package})")
    return found


def cache():
    """A folder for what is compiled once."""
    folder = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "tlsph" / "peers"
    folder.mkdir(parents=True, exist_ok=True)
    return folder


def main(name, run, scenes):
    """`run(scene, n, end)` returns particles, steps, repetitions, errors and a note as a dict."""
    parser = argparse.ArgumentParser(prog=f"{name}.py", description=f"Runs a scene of examples/ with {name}.")
    parser.add_argument("scene", help=f"one of {', '.join(scenes)}")
    parser.add_argument("--spacing", type=float, required=True, metavar="H", help="particle or node spacing [m]")
    parser.add_argument("--end", type=float, metavar="T", help="end time [s]; default: that of the example")
    options = parser.parse_args()
    os.environ["OMP_NUM_THREADS"] = "1"
    try:
        if options.scene not in scenes:
            raise Unable(f"{name} runs {', '.join(scenes)}, not {options.scene}")
        scene = SCENES[options.scene]
        n = scene.cells(options.spacing)
        result = run(scene, n, options.end or scene.end)
    except Unable as reason:
        print(f"{name}: {reason}", file=sys.stderr)
        return 3
    result["stepping_seconds"] = statistics.median(result["repetitions"])
    # NaN is no JSON: a number that is none becomes null.
    errors = {key: (value if value == value else None) for key, value in result["errors"].items()}
    result["errors"] = errors
    result["quantities"] = [
        {"name": key, "error": error,
         "value": None if error is None or key not in scene.answer else scene.answer[key] * (1 + error)}
        for key, error in errors.items()]
    print(json.dumps({"peer": name, "scene": scene.name, "n": n, "spacing": scene.lengths[scene.across] / n, **result}))
    return 0
