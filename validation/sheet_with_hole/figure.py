"""Peak stress at the hole against the spacing, and the cells at its edge, fitted and in stairs."""

import matplotlib.cm
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import PolyCollection

from plotting import frames
from plotting.case import table
from plotting.run import Run
from plotting.style import COLOURS, FAINT, INK, WIDTH, label

LINEAR, NEO_HOOKEAN = 3.3600, 16.738e6  # finite elements at rest
THESIS = 2.5e-3, 60e6
PEAKS = {  # column: label, marker, colour
    "fitted": ("fitted, stress-point", "o", COLOURS[0]),
    "variational fitted": ("fitted, variational", "^", COLOURS[1]),
    "stairs": ("stairs, stress-point", "s", COLOURS[2]),
    "variational stairs": ("stairs, variational", "v", COLOURS[4]),
}


def ticks(axes, spacing):
    axes.set_xticks(1e3 * spacing, [f"{1e3 * h:.3g}" for h in spacing])
    axes.set_xticks([], minor=True)
    axes.set_xlabel(r"spacing $\Delta$ [mm]")


def peaks(axes, data):
    for column, (text, marker, colour) in PEAKS.items():
        axes.loglog(1e3 * data["spacing"], 1e-6 * data[column], marker=marker, markersize=4.5, color=colour,
                    markerfacecolor="none", label=text)
    axes.axhline(1e-6 * NEO_HOOKEAN, color=INK, linewidth=0.9, linestyle="--", label="finite elements")
    axes.plot(1e3 * THESIS[0], 1e-6 * THESIS[1], "*", color=COLOURS[3], markersize=8, label="thesis, Fig. 5.15")
    axes.set(title="Peak principal stress under 5 MPa", ylabel="[MPa]", ylim=(8, 340), xlim=(0.5, 6.2))
    axes.set_yticks([10, 15, 20, 30, 50], ["10", "15", "20", "30", "50"])
    axes.set_yticks([], minor=True)
    axes.legend(loc="upper center", ncols=2, columnspacing=0.9, handlelength=1.5)


def errors(axes, data):
    spacing = 1e3 * data["spacing"]
    for column, exact, text, marker in (("linear", LINEAR, "linear elastic, small load", "D"),
                                        ("fitted", NEO_HOOKEAN, "Neo-Hookean, 5 MPa", "o")):
        axes.loglog(spacing, 100 * np.abs(data[column] / exact - 1), marker=marker, markersize=4.5, color=COLOURS[0],
                    markerfacecolor="none", linestyle="-" if marker == "o" else "--", label=text)
    axes.loglog(spacing, 0.13 * (spacing / spacing[-1]) ** 2, ":", color=FAINT)
    axes.annotate("order 2", (1.25, 0.52), xytext=(7, -9), textcoords="offset points", color=FAINT)
    axes.set(title="Its error, fitted, stress-point", ylabel="[%]", xlim=(0.5, 6.2))
    axes.set_yticks([0.1, 1, 10], ["0.1", "1", "10"])
    axes.legend(loc="upper left")


def cells(axes, folder, limits, title):
    with Run(folder / "run.h5") as run:
        X, values = run.field("cauchy_xx", [1])
        shape = frames.shape_of(run, X)
        body = shape.moved(run.displacement([1])[0])
    frames.paint(axes, shape, body, 1e3, frames.images("x"), "cauchy_xx", 1e-6 * values[0], "magma", limits)
    for image in frames.images("x"):
        axes.add_collection(PolyCollection(1e3 * body * image, facecolors="none", edgecolors="white", linewidths=0.4))
    axes.set(title=title, xlim=(-9, 9), ylim=(5, 17.5), aspect="equal", ylabel="$y$ [mm]")
    axes.grid(False)


def draw(folder):
    data = table(folder / "peaks.csv")
    figure = plt.figure(figsize=(0.87 * WIDTH, 4.5))
    left, right = figure.subfigures(1, 2, width_ratios=[1.1, 1])
    above, below = left.subplots(2, 1, height_ratios=[1.25, 1])
    peaks(above, data)
    errors(below, data)
    for axes in (above, below):
        ticks(axes, data["spacing"])
    fitted, stairs = right.subplots(2, 1, sharex=True)
    limits = matplotlib.colors.Normalize(0, 17)
    cells(fitted, folder / "fitted-40", limits, "Fitted to the hole, 40 × 40 cells")
    cells(stairs, folder / "stairs-40", limits, "In stairs, 40 × 40 cells")
    stairs.set_xlabel("$x$ [mm]")
    bar = right.colorbar(matplotlib.cm.ScalarMappable(limits, "magma"), ax=[fitted, stairs], location="bottom",
                         aspect=40, pad=0.02)
    bar.set_label(label("cauchy_xx", "MPa"))
    bar.outline.set_visible(False)
    return figure
