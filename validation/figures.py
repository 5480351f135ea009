#!/usr/bin/env python3
"""Remakes the figures in validation/figures/: runs their scenes, draws what comes out.

    figures.py                                    all of them
    figures.py hero bar_wave                      these
    figures.py --program build/release/tlsph      with that program; default: ./tlsph, which builds itself

Runs and exports are left in --work (default: out/figures), a folder each. Exit code 1 if the program fails.
"""

import argparse
import subprocess
import sys
import tomllib
from pathlib import Path

import plot  # noqa: F401  checks that the libraries are there and chooses a renderer that needs no screen
import matplotlib
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import PolyCollection
from matplotlib.patches import Rectangle

from plotting import frames, operator, probes, space_time
from plotting.run import Run
from plotting.style import COLOURS, FAINT, INK, WIDTH, label, prefix, save, unit_of, use_style

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent


class Program:
    """Runs scenes of examples/, each once."""

    def __init__(self, path, work):
        self.path, self.work, self.done = path, work, set()

    def call(self, command, scene, *settings):
        """The folder of the output of that command."""
        directory = self.work / f"{command}_{scene}"
        if directory not in self.done:
            arguments = [str(self.path), command, str(ROOT / "examples" / f"{scene}.toml"), "--out", str(directory)]
            for setting in settings:
                arguments += ["--set", setting]
            print(" ".join(arguments), flush=True)
            subprocess.run(arguments, check=True, stdout=subprocess.DEVNULL)
            self.done.add(directory)
        return directory

    def bar(self):
        return self.call("run", "bar_wave", "output.frames=400")

    def beam(self):
        return self.call("run", "clamped_beam", "output.frames=100")

    def sheet(self):
        return self.call("run", "plate_with_hole", SHEET_SPACING, "output.frames=5")


SHEET_SPACING = "body.spacing=1e-3"  # 50 x 50 cells, a little finer than the example
STRESS = "stress $P_{xx}$ [kPa]"


def colour_bar(figure, picture, axes, text, **place):
    bar = figure.colorbar(picture, ax=axes, **place)
    bar.set_label(text)
    bar.outline.set_visible(False)
    return bar


def history_panel(axes, directory, **legend):
    """Stress at the probes of the bar against the exact one."""
    table = directory / "probes.csv"
    computed, exact = probes.histories(table), probes.exact_histories(table, demanded=True)
    names = list(dict.fromkeys(probe for probe, _ in computed[1]))
    axes.set_xlabel(probes.paint(axes, "pk1_xx", names, computed, exact))
    axes.set_ylabel(STRESS)
    probes.legend(axes, names, exact[1], **legend)


def bar_wave(program):
    """Left the pulse over place and time, right the histories at the probes."""
    directory = program.bar()
    figure, (left, right) = plt.subplots(1, 2, figsize=(WIDTH * 1.25, 3.1), width_ratios=[1.1, 1])
    with Run(directory / "run.h5") as run:
        picture, _ = space_time.paint(left, run, "pk1_xx", "Blues_r")
        places = tomllib.loads(run.scene)["probe"]
    for k, probe in enumerate(places):
        x = 1e3 * probe["at"][0]
        left.plot(x, 0, "^", color=COLOURS[k], markersize=7, clip_on=False, zorder=4)
        left.axvline(x, color=COLOURS[k], linewidth=1.1, clip_on=False)
    colour_bar(figure, picture, left, STRESS, aspect=28, pad=0.01)
    history_panel(right, directory)
    return figure


BEAM_TIMES = [0.032, 0.064, 0.160, 0.192]  # about 1/8, 1/4, 5/8, 3/4 of the period
BEAM_SCALE = 30


def clamped_beam(program):
    """Four states of a period, and where they lie on the path of the tip."""
    directory = program.beam()
    figure = plt.figure(figsize=(WIDTH * 1.25, 5.0))
    grid = figure.add_gridspec(3, 2, height_ratios=[1, 1, 0.72])
    with Run(directory / "run.h5") as run:
        chosen = frames.pick_frames(run.times, BEAM_TIMES, run.path, 4)
        X, values = run.field("pk1_xx", chosen)
        scale, unit = prefix(values, unit_of("pk1_xx"))
        colours, limits = frames.colouring(scale * values, None)
        shape = frames.shape_of(run, X)
        panels = []
        for k, (frame, u) in enumerate(zip(chosen, run.displacement(chosen))):
            axes = figure.add_subplot(grid[k % 2, k // 2])
            body = shape.moved(BEAM_SCALE * u)
            frames.paint(axes, shape, body, 1e3, frames.images(""), "pk1_xx", scale * values[k], colours, limits)
            axes.add_patch(Rectangle((-4, -16), 4, 32, facecolor="#d0d0d0", edgecolor=INK, linewidth=0.6, hatch="////"))
            axes.set(xlim=(-5, 206), ylim=(-43, 43), aspect="equal", yticks=[-40, 0, 40])
            axes.set_title(frames.clock(run.times[frame], 1e3, "ms"), loc="left", color=COLOURS[k])
            axes.grid(False)
            axes.tick_params(labelbottom=k % 2 == 1, labelleft=k < 2)
            panels.append(axes)
        times = run.times[chosen]
    panels[1].set_xlabel("$x$ [mm]")
    panels[3].set_xlabel("$x$ [mm]")
    panels[0].set_ylabel("$y$ [mm]")
    panels[1].set_ylabel("$y$ [mm]")
    panels[2].set_title(f"displacements × {BEAM_SCALE}", loc="right", fontsize=8, color=FAINT)
    colour_bar(figure, matplotlib.cm.ScalarMappable(limits, colours), panels, label("pk1_xx", unit).replace(" $", "\n$"),
               aspect=24, pad=0.01)
    time, series = probes.histories(directory / "probes.csv")
    tip = 1e3 * series["tip", "displacement_y"]
    axes = figure.add_subplot(grid[2, :])
    axes.plot(1e3 * time, tip, color=INK, linewidth=1.0)
    for k, moment in enumerate(times):
        axes.plot(1e3 * moment, np.interp(moment, time, tip), "o", color=COLOURS[k], markersize=7, clip_on=False, zorder=3)
    axes.set(xlabel="time $t$ [ms]", ylabel="tip $u_y$ [mm]")
    axes.margins(x=0)
    return figure


def paint_sheet(figure, axes, zoom, directory, **place):
    """The whole sheet at the end, from the quarter that was computed, and a window on its cells."""
    with Run(directory / "run.h5") as run:
        last = [len(run.times) - 1]
        X, values = run.field("cauchy_xx", last)
        scale, unit = prefix(values, unit_of("cauchy_xx"))
        shape = frames.shape_of(run, X)
        body = shape.moved(run.displacement(last)[0])
        colours, limits = frames.colouring(scale * values, "magma")
    extent = 1e3 * body.reshape(-1, 2).max(axis=0)
    for target, mirror in (axes, "xy"), (zoom, "x"):
        frames.paint(target, shape, body, 1e3, frames.images(mirror), "cauchy_xx", scale * values[0], colours, limits)
        target.set_aspect("equal")
        target.grid(False)
    for image in frames.images("x"):
        zoom.add_collection(PolyCollection(1e3 * body * image, facecolors="none", edgecolors="white", linewidths=0.4))
    axes.set(xlim=(-extent[0] - 1, extent[0] + 1), ylim=(-extent[1] - 1, extent[1] + 1))
    left, right, low, high = WINDOW
    zoom.set(xlim=(left, right), ylim=(low, high))
    axes.add_patch(Rectangle((left, low), right - left, high - low, fill=False, edgecolor="white", linewidth=0.9))
    picture = matplotlib.cm.ScalarMappable(limits, colours)
    colour_bar(figure, picture, place.pop("beside", axes), label("cauchy_xx", unit), **place)
    return extent


WINDOW = (-7.5, 7.5, 5.0, 18.5)  # [mm], at the upper edge of the hole


def plate_with_hole(program):
    """The sheet under load, and the cells at the edge of its hole."""
    figure, (left, right) = plt.subplots(1, 2, figsize=(WIDTH * 1.25, 4.0), layout="compressed")
    paint_sheet(figure, left, right, program.sheet(), beside=[left, right], aspect=28, pad=0.01)
    left.set(xlabel="$x$ [mm]", ylabel="$y$ [mm]")
    right.set(xlabel="$x$ [mm]")
    return figure


def operator_spectrum(program):
    """The gradient of a plate of 8 × 8 cells."""
    directory = program.call("export", "swinging_plate", "body.spacing=0.125")
    return operator.draw(argparse.Namespace(file=f"{directory / 'operators.h5'}:G_x"))[0]


def hero(program):
    """The sheet under load with its cells, a matrix that takes a gradient, and the wave in a bar against theory."""
    export = program.call("export", "plate_with_hole", "body.spacing=5e-3")
    G = operator.load(f"{export / 'operators.h5'}:G_x")[0]
    figure = plt.figure(figsize=(9.0, 4.6))
    left, right = figure.subfigures(1, 2, width_ratios=[1.08, 1])
    sheet = left.subplots()
    grid = right.add_gridspec(2, 2, height_ratios=[1.1, 1])
    zoom, pattern, bar = (right.add_subplot(grid[place]) for place in ((0, 0), (0, 1), (1, slice(None))))
    extent = paint_sheet(left, sheet, zoom, program.sheet(), location="bottom", aspect=40, shrink=0.8, pad=0.01)
    sheet.set_axis_off()
    pull(sheet, extent)
    zoom.set(xticks=[], yticks=[])
    zoom.spines[["top", "right"]].set_visible(True)
    limit = np.max(np.abs(G.data))
    pattern.imshow(np.where(G.toarray() != 0.0, G.toarray(), np.nan), cmap="RdBu_r", vmin=-limit, vmax=limit,
                   interpolation="nearest")
    pattern.set(xticks=[], yticks=[], aspect="auto", box_aspect=(WINDOW[3] - WINDOW[2]) / (WINDOW[1] - WINDOW[0]))
    pattern.grid(False)
    pattern.spines[["top", "right"]].set_visible(True)
    history_panel(bar, program.bar(), loc="lower left", ncols=3, frameon=True, framealpha=1.0, edgecolor="none",
                  columnspacing=1.2, borderaxespad=0.6)
    for axes, text in ((sheet, "Stretched sheet with a hole"), (zoom, "Its cells"),
                       (pattern, "Gradient matrix"),
                       (bar, "Stress wave at four places of a bar")):
        axes.set_title(text, fontsize=9, fontweight="bold")
    return figure


def pull(axes, extent):
    """Arrows of the load on both sides."""
    for y in np.linspace(-0.85, 0.85, 7) * extent[1]:
        for side in (1, -1):
            axes.annotate("", xy=(side * (extent[0] + 8), y), xytext=(side * (extent[0] + 1), y),
                          arrowprops=dict(arrowstyle="-|>", color=INK, linewidth=0.9, mutation_scale=8))
    axes.set_xlim(-extent[0] - 9, extent[0] + 9)


FIGURES = {f.__name__: f for f in (hero, bar_wave, clamped_beam, plate_with_hole, operator_spectrum)}


def main():
    p = argparse.ArgumentParser(prog="figures.py", description=__doc__,
                                formatter_class=argparse.RawDescriptionHelpFormatter)
    p.add_argument("names", nargs="*", metavar="NAME", help=f"of {', '.join(FIGURES)}; default: all")
    p.add_argument("--program", type=Path, default=ROOT / "tlsph", metavar="PATH", help="default: ./tlsph of the project")
    p.add_argument("--work", type=Path, default=ROOT / "out" / "figures", metavar="DIR", help="default: out/figures")
    p.add_argument("--out", type=Path, default=HERE / "figures", metavar="DIR", help="default: validation/figures")
    options = p.parse_args()
    for name in options.names:
        if name not in FIGURES:
            p.error(f"no figure {name}; there are: {', '.join(FIGURES)}")
    use_style()
    program = Program(options.program.resolve(), options.work)
    for name in options.names or FIGURES:
        try:
            print(save(FIGURES[name](program), options.out / f"{name}.png"))
        except subprocess.CalledProcessError as error:
            print(f"figures.py: {name}: the program failed with exit code {error.returncode}", file=sys.stderr)
            return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
