#!/usr/bin/env python3
"""LAMMPS, state-based peridynamics (peri/lps): a cubic lattice, horizon 3.01 spacings, periodic across
the plane with seven layers there, so that no particle meets its own image (plane strain). The held end
is four layers of particles that do not move."""

import math
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

import peer
import scenes

HORIZON = 3.01  # spacings
LAYERS = 7
HELD = 4
SHARE = 0.4  # of Δ/c_p
PROBE_EVERY = 10

SCRIPT = """\
units si
dimension 3
boundary f f p
atom_style peri
atom_modify map array
neighbor {skin:.9g} bin
read_data body.data
set group all density {density:.9g}
set group all volume {volume:.9g}
pair_style peri/lps
pair_coeff * * {bulk:.9g} {shear:.9g} {horizon:.9g} 1e3 0.0
group held type 2
group free type 1
timestep {dt:.12g}
thermo 100000000
velocity held set 0 0 0
fix move all nve
fix hold held setforce 0 0 0
variable kick atom {kick}
velocity free set NULL v_kick NULL
run 0 post no
group tip id {tip}
compute moved tip displace/atom
compute tip tip reduce ave c_moved[2]
fix history tip ave/time {every} 1 {every} c_tip file history.txt
run {steps}
"""


def positions(scene, n):
    """(X N×3, held N, spacing, low and high of the box)."""
    h = scene.lengths[scene.across] / n
    along = round(scene.lengths[0] / h)
    x = (np.arange(-HELD, along) + 0.5) * h
    y = scene.corner[1] + (np.arange(n) + 0.5) * h
    z = (np.arange(LAYERS) + 0.5) * h
    X = np.stack(np.meshgrid(x, y, z, indexing="ij"), axis=-1).reshape(-1, 3)
    box = [(-2 * scene.lengths[0], 3 * scene.lengths[0]), (-scene.lengths[0], scene.lengths[0]), (0.0, LAYERS * h)]
    return X, X[:, 0] < 0, h, box


def data_file(X, held, h, box, density):
    rows = ["peer", "", f"{len(X)} atoms", "2 atom types", ""]
    rows += [f"{low:.9g} {high:.9g} {axis}lo {axis}hi" for (low, high), axis in zip(box, "xyz")]
    rows += ["", "Atoms # peri", ""]
    rows += [f"{k + 1} {2 if held[k] else 1} {h ** 3:.12g} {density:.9g} {x:.12g} {y:.12g} {z:.12g}"
             for k, (x, y, z) in enumerate(X)]
    return "\n".join([*rows, ""])


def call(program, folder, script):
    (folder / "in.peer").write_text(script)
    done = subprocess.run([program, "-in", "in.peer", "-log", "none", "-nocite"], cwd=folder, capture_output=True,
                          text=True, check=False)
    loops = re.findall(r"Loop time of ([0-9.e+-]+) on", done.stdout)
    if done.returncode != 0 or not loops:
        last = [line for line in (done.stdout + done.stderr).splitlines() if "ERROR" in line]
        raise peer.Unable(f"LAMMPS failed: {last[0] if last else done.returncode}")
    return float(loops[-1])


def mode_expression(scene):
    """BEAM_SPEED times the first mode of the cantilever, in LAMMPS's words."""
    k = 1.875104068711961
    sigma = (math.cosh(k) + math.cos(k)) / (math.sinh(k) + math.sin(k))
    s = f"({k / scene.lengths[0]:.16g}*x)"
    cosh, sinh = (f"(0.5*(exp{s}{sign}exp(-{s})))" for sign in "+-")
    return f"{0.5 * scenes.BEAM_SPEED:.12g}*({cosh}-cos{s}-{sigma:.16g}*({sinh}-sin{s}))"


def run(scene, n, end):
    program = peer.need("lmp", "lammps")
    X, held, h, box = positions(scene, n)
    lam, mu = scene.lame
    steps = math.ceil(end / (SHARE * h / scene.wave_speed))
    tip = np.flatnonzero((X[:, 0] > scene.lengths[0] - h) & (np.abs(X[:, 1]) < 0.6 * h))
    script = SCRIPT.format(skin=0.5 * h, density=scene.density, volume=h ** 3, bulk=lam + 2 * mu / 3, shear=mu,
                           horizon=HORIZON * h, dt=end / steps, kick=mode_expression(scene),
                           tip=" ".join(str(q + 1) for q in tip), every=PROBE_EVERY, steps=steps)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "body.data").write_text(data_file(X, held, h, box, scene.density))
        seconds = call(program, folder, script)
        history = np.loadtxt(folder / "history.txt")
    return {"particles": int(np.count_nonzero(~held)), "steps": steps, "repetitions": [seconds],
            "errors": scenes.period_error(scene, history[:, 0] * end / steps, history[:, 1]),
            "note": f"peri/lps in 3D, {LAYERS} layers, horizon {HORIZON} spacings"}


if __name__ == "__main__":
    sys.exit(peer.main("lammps", run, ["clamped_beam"]))
