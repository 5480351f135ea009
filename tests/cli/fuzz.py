#!/usr/bin/env python3
"""Random scenes, sound and broken, through the program: it must never crash, hang or lie.

    TLSPH_PROGRAM=build/release/tlsph python3 tests/cli/fuzz.py [--cases 10000] [--seed 1] [--jobs 2]
                                      [--first 0] [--keep FOLDER] [--seconds 4]

Case K of seed S is the same everywhere; `--first K --cases 1 --keep FOLDER` leaves what it was. A case is a scene that
the generator below makes, or one of examples/, cut short; most are then changed in some of their keys (those of `tlsph
scene-reference`) or bytes. Exit code 1 if any case breaks a promise:

- the program ends by itself, with 0, 2, 3 (143 after SIGTERM, sent when the time of a case is over), never by a signal
- 0: no nan and no infinity in probes.csv, summary.json and run.h5; 3: none in probes.csv and run.h5
- 2: nothing is left behind; the message says file, line and column, or the override
- 3: the message says time and particle
"""

import argparse
import collections
import concurrent.futures
import csv
import json
import math
import os
import pathlib
import random
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import tomllib

import h5py
import numpy as np

SOURCE = pathlib.Path(__file__).resolve().parents[2]
EXAMPLES = sorted((SOURCE / "examples").glob("*.toml"))
MEMORY = 3 << 30  # bytes a case may take
KERNELS = ("wendland-c2", "modified-mollifier", "mollifier", "cubic-spline", "lucy", "gaussian", "quadratic")
QUANTITIES = ("displacement", "velocity", "acceleration", "deformation_gradient", "pk1", "cauchy", "pressure", "von_mises")
NASTY = (0, -0.0, 1, -1, 2, 3, 0.5, 1e-300, 5e-324, 1e-30, 1e-9, 1e9, 1e30, 1e154, 1e300, 1.7976931348623157e308,
         math.inf, -math.inf, math.nan, 2**31 - 1, 2**31, 2**53 + 1, 2**63 - 1, -(2**63), True, False, "", "x", "left",
         "é\t\"\\", "auto", "none", [], [[]], [0.0], [1.0, 2.0], [[0.0, 0.0], [1.0, 1.0]], [1e300, -1e300], {},
         {"curve": "ramp"}, {"constant": [1.0]}, {"field": "swinging-plate", "amplitude": 1e-3}, [{}], ["x", "y"])


def toml(value):
    """A value as TOML; what is no TOML (the text of a mutation) as it is."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, float):
        return repr(value).replace("inf", "inf") if math.isfinite(value) else str(value)
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(map(toml, value)) + "]"
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{key} = {toml(item)}" for key, item in value.items()) + " }"
    return str(value)


def scene_text(scene):
    """The scene, tables of its top level under headings."""
    def is_list_of_tables(value):
        return isinstance(value, list) and value != [] and all(isinstance(item, dict) for item in value)

    lines = [f"{key} = {toml(value)}" for key, value in scene.items()
             if not isinstance(value, dict) and not is_list_of_tables(value)]
    for key, value in scene.items():
        if isinstance(value, dict):
            lines += ["", f"[{key}]"] + [f"{name} = {toml(item)}" for name, item in value.items()]
        elif is_list_of_tables(value):
            for table in value:
                lines += ["", f"[[{key}]]"] + [f"{name} = {toml(item)}" for name, item in table.items()]
    return "\n".join(lines) + "\n"


class Keys:
    """What `tlsph scene-reference` says: the names of keys and the words they take."""

    def __init__(self, program):
        text = subprocess.run([program, "scene-reference"], capture_output=True, text=True, check=True).stdout
        self.paths, self.words = [], ["true"]
        group = ""
        for line in text.splitlines():
            if heading := re.match(r"\[+([a-z_. ]+)\]+$", line):
                group = heading[1] + "."
            elif line.startswith("Top level"):
                group = ""
            elif key := re.match(r"  ([a-z_]+) +\S", line):
                self.paths.append(group + key[1])
            elif words := re.fullmatch(r" {22}([a-z0-9_-]+(?: \| [a-z0-9_-]+)+).*", line):
                self.words += words[1].split(" | ")
        if len(self.paths) < 50 or len(self.words) < 20:
            raise SystemExit("scene-reference cannot be read")


class Generator:
    """Small bodies and short runs, everything else at random: most scenes are sound; careless ones need not be."""

    def __init__(self, rng):
        self.rng = rng
        self.careless = rng.random() < 0.12

    def may(self, chance, sound=True):
        return self.rng.random() < chance and (sound or self.careless)

    def optional(self, table, chance, **choices):
        for name, values in choices.items():
            if self.rng.random() < chance:
                table[name] = self.rng.choice(values)

    def scene(self):
        rng = self.rng
        self.d = d = rng.choice((1, 2, 2))
        self.young, density = 10.0 ** rng.randint(0, 11), 10.0 ** rng.randint(0, 4)
        self.length = 10.0 ** rng.choice((-6, -3, -2, -1, 0, 0, 1, 3))
        self.cells = rng.randint(2, 12) if d == 2 else rng.randint(2, 40)
        self.spacing = self.length / self.cells
        speed = math.sqrt(self.young / density)
        pace = self.spacing / speed  # about a critical step [s]
        self.strain = 10.0 ** (rng.uniform(-9, -1) if rng.random() < 0.7 else rng.uniform(-1, 2))
        self.formulation = rng.choice(("stress-point", "stress-point", "variational", "consistent", "mirror", "thesis"))
        self.ghosts = self.formulation in ("mirror", "thesis")
        thesis = self.formulation == "thesis"
        scene = {"title": rng.choice(("", "fuzz", "ü → \"x\"")), "dimension": d}
        if self.formulation != "stress-point" or rng.random() < 0.5:
            scene["formulation"] = self.formulation
        if self.may(0.3, thesis):
            scene["boundary_treatment"] = rng.choice(("consistent", "as-printed", *(("eta",) * (d == 1))))
        if self.may(0.3, thesis):
            scene["boundary_solver"] = rng.choice(("auto", "cholmod", "umfpack"))
        self.optional(scene, 0.1, precision=("double", "mixed"))
        if self.may(0.3, self.formulation == "consistent"):
            scene["consistency"] = rng.choice((True, [1, 0], [1, 1], [2, 1]))
        if self.may(0.15, not self.ghosts):
            scene["gravity"] = [rng.uniform(-10, 10) for _ in range(d)]
        scene["body"] = body = self.body()
        if rng.random() < 0.35:
            scene["kernel"] = kernel = {}
            self.optional(kernel, 0.5, family=KERNELS, support=(1.6, 2.1, 2.6, 3.1, 3.6))
            if self.may(0.5, not self.ghosts and "consistency" not in scene):
                kernel.update(rng.choice(({"order": 1}, {"order": 2, "support": 3.6}, {"correction": "least-squares"})))
            if self.may(0.3, self.formulation == "variational"):
                kernel["correction"] = rng.choice(("none", "gradient", "mixed"))
        if self.may(0.25, not self.ghosts):
            scene["stabiliser"] = stabiliser = {"kind": rng.choice(("none", "pair"))}
            if stabiliser["kind"] == "pair" or self.careless:
                self.optional(stabiliser, 0.6, coefficient=("auto", 0, 0.1, 1.0), **{"as": ("stiffness", "viscosity")})
        scene["material"] = {"young": self.young, "poisson": rng.choice((0, 0.3, 0.45, 0.499, -0.5)), "density": density}
        self.optional(scene["material"], 0.5, law=("neo-hookean", "st-venant-kirchhoff", "linear-elastic"),
                      assumption=("strain", "stress"))
        if rng.random() < 0.1:
            scene["material"]["region"] = [{"box": self.box(), "young": self.young * 10.0 ** rng.uniform(-3, 3)}]
        self.end = pace * rng.choice((1, 3, 10, 30, 100))
        scene["boundary"] = self.boundaries(body)
        scene["time"] = {"end": self.end}
        self.optional(scene["time"], 0.25, safety=(0.1, 0.7, 0.95, 1.0))
        if rng.random() < 0.15:
            scene["time"]["step"] = pace * rng.choice((0.05, 0.1, 0.3, 0.5, 1.5 if self.careless else 0.2))
        scene["probe"] = [self.probe() for _ in range(rng.choice((0, 1, 1, 2)))]
        still = not (self.ghosts and scene["boundary"])  # an edge that is held starts undeformed there
        if rng.random() < 0.3:
            scene["initial"] = initial = {"velocity": self.field(speed)}
            if self.may(0.5, still):
                initial["displacement"] = self.field(1.0)
            if rng.random() < 0.2:
                initial["region"] = [{"box": self.box(), "velocity": self.field(speed)}]
        if self.may(0.3, False):
            scene["reference"] = {"exact": rng.choice(("bar-wave", "swinging-plate", "uniform-stretch"))}
        scene["output"] = output = {"frames": rng.choice((0, 1, 2, 5))}
        self.optional(output, 0.25, probe_every=(1, 3), energy_every=(0, 1, 2), checkpoint_steps=(0, 1, 5),
                      fields=(["displacement"], ["cauchy", "pressure"], list(QUANTITIES), []))
        return {key: value for key, value in scene.items() if value != []}

    def body(self):
        rng = self.rng
        body = {"shape": self.shape(), "spacing": self.spacing}
        self.optional(body, 0.1, fit=(True, False), seed=(0, 7, 2**40))
        if self.may(0.15, self.ghosts or "box" in body["shape"]):
            body["placement"] = rng.choice(("on-boundary", "cell-centred"))
        elif self.may(0.2, not self.ghosts):
            body["jitter"] = rng.choice((0.0, 0.1, 0.2, 0.4))
        elif self.may(0.2, self.d == 2 and not self.ghosts):
            body["layout"] = "hexagonal"
        if self.may(0.15, not self.ghosts):
            body["tags"] = [{"name": "spot", "box": self.box()}]
        return body

    def shape(self):
        rng, length = self.rng, self.length
        self.low = at = rng.choice((0.0, 0.0, -length, 0.3 * length))
        self.height = length
        if self.d == 1:
            return {"interval": [at, at + length]}
        height = self.spacing * rng.choice((self.cells, self.cells, rng.randint(2, 12), 1))
        box = {"box": [[at, 0.0], [at + length, height]]}
        if rng.random() < 0.6 or (self.ghosts and not self.careless):
            self.height = height
            return box
        self.spacing = length / max(6, self.cells)
        if rng.random() < 0.3:
            self.low = at - 0.5 * length
            return {"disc": {"centre": [at, 0.5 * length], "radius": 0.5 * length}}
        if rng.random() < 0.5:
            corners = [[0, 0], [1, 0], [1, rng.uniform(0.7, 1)], [rng.uniform(0, 0.3), 1]]
            return {"polygon": [[at + length * x, length * y] for x, y in corners[: rng.choice((3, 4, 4))]]}
        hole = {"disc": {"centre": [at + 0.5 * length, 0.5 * length], "radius": 0.25 * length}}
        return {"difference": [{"box": [[at, 0.0], [at + length, length]]}, hole]}

    def box(self):
        low, high = sorted(self.rng.choice((0.0, 1.0, self.rng.random())) for _ in range(2))
        low, high = self.low + low * self.length, self.low + high * self.length
        return [low, high] if self.d == 1 else [[low, -self.length], [high, 3 * self.length]]

    def curve(self, size):
        rng = self.rng
        kind = rng.choice(("constant", "ramp", "smooth-ramp", "pulse", "sine-squared", "table"))
        time = self.end * rng.choice((0.1, 0.5, 1.0))
        needs = {"ramp": {"rise": time}, "smooth-ramp": {"rise": time}, "pulse": {"rise": time, "duration": 2 * time},
                 "sine-squared": {"duration": time}, "table": {"time": [0.0, time], "value": [0.0, 1.0]}}
        return {"curve": kind, "amplitude": size, **needs.get(kind, {})}

    def boundaries(self, body):
        rng = self.rng
        places = [["left", "right"], ["left"], ["right"], []]
        if self.d == 2:
            places += [["top", "bottom"], ["bottom"]]
        if "difference" in body["shape"]:
            places += [["hole"], ["hole", "left"]]
        if "tags" in body:
            places += [["spot"]]
        if self.careless:
            places += [["left", "top"], ["outer"], ["left", "left"], ["hole"], ["spot"]]
        sides = []
        if self.ghosts and self.d == 2 and not self.careless:  # what strains along itself cannot be mirrored
            places = places[:4]
            sides = [{"where": where, "symmetry": True} for where in ("top", "bottom")]
        return [self.boundary(where) for where in rng.choice(places)] + sides

    def boundary(self, where):
        rng, d = self.rng, self.d
        kinds = ["fixed", "displacement", "traction", "traction"]
        if not self.ghosts or self.careless:
            kinds += ["held"]
        if where not in ("hole", "spot", "outer") or self.careless:
            kinds += ["symmetry"]
        kind = rng.choice(kinds)
        axis = "y" if where in ("top", "bottom") else "x"
        if kind in ("fixed", "held"):
            value = rng.choice((True, axis, ["x", "y"][:d]))
        elif kind == "symmetry":
            value = True
        elif kind == "displacement":
            size = rng.choice((-1, 1)) * self.strain * self.length
            value = {axis: rng.choice((size, self.curve(size)))}
        else:
            size = rng.choice((-1, 1)) * self.strain * self.young
            vector = [size if name == axis or (not self.ghosts and rng.random() < 0.5) else 0.0 for name in "xy"[:d]]
            value = rng.choice((size, self.curve(size), *(() if self.ghosts else (vector, self.curve(vector)))))
        return {"where": where, kind: value}

    def probe(self):
        rng = self.rng
        x = self.low + self.length * rng.choice((0.0, 0.2, rng.uniform(0.1, 0.3)))
        probe = {"at": [x] if self.d == 1 else [x, self.height * rng.choice((0.0, 0.5, rng.uniform(0.2, 0.8)))]}
        self.optional(probe, 0.6, record=[rng.sample(QUANTITIES, k=rng.randint(1, 4))])
        if rng.random() < 0.5:
            probe["name"] = f"q{rng.randrange(10**6)}"
        return probe

    def field(self, scale):
        rng, d = self.rng, self.d
        size = scale * self.strain * rng.choice((-1, 1))
        if self.may(0.15, d == 2):
            return {"field": rng.choice(("swinging-plate", "cantilever-mode")), "amplitude": size * self.length}
        if rng.random() < 0.3:
            return [size * self.length for _ in range(d)]
        return {"gradient": [[size * rng.uniform(-1, 1) for _ in range(d)] for _ in range(d)]}


def tables_of(scene):
    """Every table of the scene, the scene among them."""
    found = [scene]
    for value in scene.values():
        for item in value if isinstance(value, list) else [value]:
            if isinstance(item, dict):
                found += tables_of(item)
    return found


def change_key(rng, scene, keys):
    table = rng.choice(tables_of(scene))
    name = rng.choice(list(table)) if table and rng.random() < 0.8 else rng.choice(keys.paths).split(".")[-1]
    kind = rng.random()
    value = table.get(name)
    if kind < 0.15:
        table.pop(name, None)
    elif kind < 0.25:
        table[name + rng.choice("xs_")] = table.pop(name, 1)
    elif kind < 0.45 and isinstance(value, (int, float)) and not isinstance(value, bool):
        table[name] = value * rng.choice((-1, 0, 0.1, 0.5, 1.003, 2, 10, 1e3, 1e-3, 1e100, 1e-100))
    elif kind < 0.6:
        table[name] = rng.choice(keys.words)
    elif kind < 0.75 and isinstance(value, list) and value:
        table[name] = rng.choice((value + value[:1], value[:-1], value[::-1], [value[0]] * len(value), [value]))
    else:
        table[name] = rng.choice(NASTY)


def change_bytes(rng, text):
    data = bytearray(text.encode())
    for _ in range(rng.choice((1, 1, 2, 5))):
        at = rng.randrange(len(data) + 1)
        length = rng.choice((1, 1, 2, 10, 50))
        kind = rng.random()
        if kind < 0.3 and at < len(data):
            data[at] = rng.choice((data[at] ^ (1 << rng.randrange(8)), rng.randrange(256), ord(rng.choice("0123456789.-+e[]{}\"'=#,\n"))))
        elif kind < 0.5:
            data[at:at] = bytes(rng.choice((rng.randrange(256), ord(rng.choice("0123456789.-e[]{}\"=\n")))) for _ in range(length))
        elif kind < 0.75:
            del data[at : at + length]
        elif kind < 0.9:
            data[at:at] = data[at : at + length] * rng.choice((1, 2, 100))
        else:
            del data[at:]
    return bytes(data)


class Case:
    """What is run: the bytes of a scene and a command line; all of it follows from `seed` and `number`."""

    def __init__(self, seed, number, keys):
        rng = random.Random(f"{seed}:{number}")
        self.number = number
        if rng.random() < 0.12:
            scene = tomllib.loads(rng.choice(EXAMPLES).read_text(encoding="utf-8"))
            scene["time"]["end"] *= 10.0 ** rng.uniform(-6, -2)
            scene["body"]["spacing"] = scene["body"].get("spacing", 0.05) * rng.choice((1, 2, 4))
            scene.setdefault("output", {})["frames"] = 2
        else:
            scene = Generator(rng).scene()
        self.kind = rng.choices(("sound", "keys", "bytes"), (6, 3, 1))[0]
        if self.kind == "keys":
            for _ in range(rng.choice((1, 1, 2, 3))):
                change_key(rng, scene, keys)
        text = scene_text(scene)
        self.bytes = change_bytes(rng, text) if self.kind == "bytes" else text.encode()
        command = rng.choices(("run", "plan", "export"), (8, 1, 1))[0]
        self.arguments = [command, "scene.toml"]
        if command != "plan":
            self.arguments += ["--out", "results"]
        if command == "run":
            self.arguments += ["--threads", str(rng.choice((1, 1, 2)))]
        if rng.random() < 0.1:
            value = rng.choice((rng.choice(NASTY), rng.choice(keys.words)))
            path = re.sub(r"^(boundary|probe)", r"\1[0]", rng.choice(keys.paths))
            self.arguments += ["--set", f"{path}={toml(value)}"]

    def run(self, program, folder, seconds):
        """(exit code, complaints)"""
        (folder / "scene.toml").write_bytes(self.bytes)
        for example in EXAMPLES[0].parent.glob("*.csv"):
            shutil.copy(example, folder)
        before = sorted(folder.rglob("*"))
        process = subprocess.Popen([program, *self.arguments], cwd=folder, stdin=subprocess.DEVNULL,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                   preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY)))
        stopped = False
        try:
            _, told = process.communicate(timeout=seconds)
        except subprocess.TimeoutExpired:
            stopped = True
            process.terminate()
            try:
                _, told = process.communicate(timeout=30)
            except subprocess.TimeoutExpired:
                process.kill()
                process.communicate()
                return "hangs", ["does not answer SIGTERM for 30 s"]
        told = told.decode(errors="replace")
        code = process.returncode
        complaints = []
        if code not in (0, 2, 3) and not (stopped and code == 143):
            complaints.append(f"exit code {code}: {told[-300:]}")
        if code == 2:
            if sorted(folder.rglob("*")) != before:
                complaints.append("leaves files after exit code 2")
            if not re.match(r"(?s)(scene\.toml:\d+:\d+|--set .*|\S*\.csv:\d+(:\d+)?): .", told):
                complaints.append(f"exit code 2 without place: {told[:300]}")
        if code == 3 and not (re.search(r"\bt = [-+.e\d]+ s", told) and re.search(r"\b(particle|point|node) \d", told)):
            complaints.append(f"exit code 3 without time and particle: {told[:300]}")
        if self.arguments[0] == "run" and code in (0, 3):
            complaints += not_finite(folder / "results", code == 0)
        return code, complaints


def not_finite(out, done):
    """Complaints about numbers that are none in the files of a run; of one that is `done` also about its summary."""
    complaints = []
    if (out / "probes.csv").is_file():
        with open(out / "probes.csv", encoding="utf-8", newline="") as file:
            _, *rows = csv.reader(file)
        if any(not math.isfinite(float(text)) for row in rows for text in row):
            complaints.append("nan in probes.csv")
    if (out / "run.h5").is_file():
        with h5py.File(out / "run.h5") as file:
            def look(name, item):
                if isinstance(item, h5py.Dataset) and item.dtype.kind == "f" and not np.all(np.isfinite(item[()])):
                    complaints.append(f"nan in run.h5:{name}")
            file.visititems(look)
    if done:
        def numbers(tree, path):
            for key, value in tree.items():
                if isinstance(value, dict):
                    numbers(value, f"{path}{key}.")
                elif value is None and path:  # in a group that is there
                    complaints.append(f"null in summary.json: {path}{key}")
        summary = json.loads((out / "summary.json").read_text(encoding="utf-8"))
        numbers(summary, "")
        complaints += [f"null in summary.json: {key}" for key in ("dt", "dt_critical", "end_time") if summary[key] is None]
    return complaints


def fuzz(program, cases, seed=1, first=0, jobs=2, seconds=4.0, keep=None):
    """(exit codes by number of cases, complaints as {case: texts})"""
    keys = Keys(program)
    codes, found = collections.Counter(), {}

    def one(number):
        case = Case(seed, number, keys)
        with tempfile.TemporaryDirectory() as temporary:
            folder = pathlib.Path(temporary)
            code, complaints = case.run(program, folder, seconds)
            if keep is not None and (complaints or cases == 1):
                shutil.copytree(folder, pathlib.Path(keep) / str(number), dirs_exist_ok=True)
                line = " ".join(case.arguments) + "\n" + "\n".join(complaints) + "\n"
                (pathlib.Path(keep) / str(number) / "case.txt").write_text(line, encoding="utf-8")
        return number, case, code, complaints

    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for number, case, code, complaints in pool.map(one, range(first, first + cases)):
            codes[code] += 1
            if complaints:
                found[number] = complaints
                print(f"case {number} ({case.kind}, {' '.join(case.arguments)}): " + "; ".join(complaints), flush=True)
    return codes, found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--cases", type=int, default=10000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--first", type=int, default=0, help="number of the first case")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--seconds", type=float, default=4.0, help="time of a case before it is sent SIGTERM")
    parser.add_argument("--keep", type=pathlib.Path, help="folder for the cases that break a promise")
    arguments = parser.parse_args()
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    program = str(pathlib.Path(os.environ["TLSPH_PROGRAM"]).resolve())
    codes, found = fuzz(program, arguments.cases, arguments.seed, arguments.first, arguments.jobs, arguments.seconds,
                        arguments.keep)
    print(f"{sum(codes.values())} cases: " + ", ".join(f"{count} with {code}" for code, count in codes.most_common())
          + f"; {len(found)} break a promise")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
