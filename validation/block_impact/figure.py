"""Kinetic energy of two bonded blocks, updated and total Lagrangian, and with free sides; gaps between particles."""

import matplotlib.pyplot as plt
import numpy as np

from plotting.case import table
from plotting.run import Run
from plotting.style import COLOURS, INK, WIDTH

CYCLE = 2 / np.sqrt(1.5e6 * 0.51 / (1.49 * 0.02) / 1200)  # [s]
TOTAL = [("stress-point", COLOURS[0], "-"), ("variational", COLOURS[2], "-"), ("mirror", COLOURS[4], "--"),
         ("thesis", COLOURS[3], "-")]


def triangle(axes):
    axes.plot(np.arange(0, 3.5, 0.5), [1, 0, 1, 0, 1, 0, 1], color=INK, linestyle="--", linewidth=0.9, zorder=3,
              label="plane wave, exact")


def energy(axes, title, curves):
    for data, label, colour, dashes in curves:
        axes.plot(data["time"] / CYCLE, data["energy"], color=colour, linestyle=dashes, linewidth=1.1, label=label)
    triangle(axes)
    axes.set(title=title, xlim=(0, 3), ylim=(-0.03, 1.42), xlabel="time $tc/(2L)$", yticks=[0, 0.5, 1])
    axes.legend(loc="upper center", ncols=3, fontsize=6.5, columnspacing=0.8, handlelength=1.2)


def draw(folder):
    updated, free = table(folder / "updated.csv"), table(folder / "sheet-free.csv")
    figure, ((left, right), (gaps, sides)) = plt.subplots(2, 2, figsize=(0.83 * WIDTH, 3.8))
    energy(left, "Kinetic energy, updated Lagrangian", [(updated, "updated", COLOURS[1], "-")])
    left.set_ylabel("energy over the first")
    energy(right, "Kinetic energy, total Lagrangian",
           [(table(folder / f"{name}-80.csv"), name, colour, dashes) for name, colour, dashes in TOTAL])

    x = table(folder / "positions.csv")["x"]
    middle = 0.5 * (x[1:] + x[:-1])
    gaps.plot(middle - 0.5 * (x[0] + x[-1]), np.diff(x) / 0.025, color=COLOURS[1], linewidth=0.8, marker="o",
              markersize=2, label="updated")
    with Run(folder / "stress-point-80" / "run.h5") as run:
        y = (run.nodes + run.displacement([1])[0]).ravel()
    gaps.plot(0.5 * (y[1:] + y[:-1]) - 1.0, np.diff(y) / 0.025, color=COLOURS[0], label="stress-point")
    gaps.set(title="Gaps between particles at $t=1.5$", ylim=(0.86, 1.2), xlabel="place $x$ [m]", xlim=(-0.5, 0.5),
             ylabel=r"gap over $\Delta$")
    gaps.legend(loc="upper right", ncols=2, fontsize=7)

    energy(sides, "Kinetic energy, sides free", [(free, "stress-point, 80 × 40", COLOURS[0], "-")])
    sides.set_ylabel("energy over the first")
    return figure
