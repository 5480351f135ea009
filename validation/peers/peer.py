"""What every peer script shares: its command line and what it prints.

    NAME.py SCENE --spacing H [--end T] [--share S] [--law LAW]

prints one line of JSON: peer, scene, n, spacing, particles, steps, stepping_seconds, repetitions, errors,
quantities, note, and step_share and law of a peer that can choose them by --share (of the critical step) and --law;
others take no notice of both. `n` counts cells across the body, `stepping_seconds` is the time of the steps alone,
without set-up and output, on one thread, the median of the `repetitions`. `errors` are relative, by name;
`quantities` is the same as a list of {name, error, value}, value null for fields. Exit code 3 if the program
behind the peer is not installed or cannot run the scene, with the reason on stderr.
"""

import argparse
import dataclasses
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


def main(name, run, scenes, chooses=False):
    """`run(scene, n, end)` returns particles, steps, repetitions, errors and a note as a dict; that of a peer which
    `chooses` step and law is `run(scene, n, end, share)`, with the law in its scene."""
    parser = argparse.ArgumentParser(prog=f"{name}.py", description=f"Runs a scene of examples/ with {name}.")
    parser.add_argument("scene", help=f"one of {', '.join(scenes)}")
    parser.add_argument("--spacing", type=float, required=True, metavar="H", help="particle or node spacing [m]")
    parser.add_argument("--end", type=float, metavar="T", help="end time [s]; default: that of the example")
    parser.add_argument("--share", type=float, default=0.9, metavar="S",
                        help="of the critical step; default 0.9" if chooses else argparse.SUPPRESS)
    parser.add_argument("--law", choices=["linear-elastic", "neo-hookean"],
                        help="default: that of the example" if chooses else argparse.SUPPRESS)
    options = parser.parse_args()
    os.environ["OMP_NUM_THREADS"] = "1"
    try:
        if options.scene not in scenes:
            raise Unable(f"{name} runs {', '.join(scenes)}, not {options.scene}")
        scene = SCENES[options.scene]
        n = scene.cells(options.spacing)
        end = options.end or scene.end
        if chooses:
            scene = dataclasses.replace(scene, law=options.law or scene.law)
            result = run(scene, n, end, options.share) | {"law": scene.law, "step_share": options.share}
        else:
            result = run(scene, n, end)
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
