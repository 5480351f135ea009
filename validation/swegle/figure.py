"""Kinetic energy over time, total and updated Lagrangian; the sheet in tension; growth against stress."""

import matplotlib.pyplot as plt
import numpy as np

from plotting.case import table
from plotting.run import Run
from plotting.style import COLOURS, INK, WIDTH

UNIT = 1e-3 / 1500  # spacing / wave speed [s]
TOTAL = [("stress-point", COLOURS[0]), ("variational", COLOURS[2]), ("mirror", COLOURS[4])]


def sheet(axes, x, title, colour):
    axes.plot(*x.T, "o", color=colour, markersize=1.7)
    axes.set(title=title, aspect="equal", xticks=[], yticks=[])
    axes.grid(False)
    axes.spines[["left", "bottom"]].set_visible(False)


def draw(folder):
    tension, compression = table(folder / "total-tension.csv"), table(folder / "total-compression.csv")
    updated = {name: table(folder / f"updated-{name}.csv") for name in ("tension", "compression")}
    clumps, rates = table(folder / "clumps.csv"), table(folder / "rates.csv")
    figure = plt.figure(figsize=(0.87 * WIDTH, 4.2))
    grid = figure.add_gridspec(2, 4, height_ratios=[1.15, 1])
    energy = figure.add_subplot(grid[0, :2])
    long = figure.add_subplot(grid[0, 2:])
    left, right = figure.add_subplot(grid[1, 0]), figure.add_subplot(grid[1, 1])
    growth = figure.add_subplot(grid[1, 2:])

    energy.semilogy(updated["tension"]["time"] / UNIT, updated["tension"]["energy"], color=COLOURS[1],
                    label="updated Lagrangian")
    energy.semilogy(tension["time"] / UNIT, tension["stress-point"], color=COLOURS[0], label="total Lagrangian")
    rate = rates["theory_2d"][list(np.round(rates["stress"], 4)).index(0.05)]
    t = np.array([15.0, 45.0])
    energy.semilogy(t, 3e4 * np.exp(2 * rate * (t - 15)), color=INK, linestyle="--", linewidth=0.9)
    energy.text(26, 3e11, "theory", ha="right", fontsize=8)
    energy.set(xlim=(0, 72), ylim=(1e-2, 1e20), xlabel=r"time $tc/\Delta$", ylabel="kinetic energy over the first",
               title=r"In tension, $\sigma_0=0.05\,\rho c^2$")
    energy.legend(loc="upper left")

    for name, colour in TOTAL:
        for data, dashes in ((tension, "-"), (compression, ":")):
            long.plot(data["time"][::2] / UNIT, data[name][::2], color=colour, linestyle=dashes, linewidth=0.7,
                      label=name if data is tension else None)
    long.axhline(1.0, color=INK, linewidth=0.8, linestyle="--")
    long.set(xlim=(0, 450), ylim=(0, 1.35), xlabel=r"time $tc/\Delta$", title="Total Lagrangian (dotted: compression)")
    long.legend(loc="upper right", ncols=3, fontsize=7, columnspacing=1.0, handlelength=1.2)

    sheet(left, np.column_stack([clumps["x"], clumps["y"]]), r"updated, $t=72\,\Delta/c$", COLOURS[1])
    with Run(folder / "stress-point-tension" / "run.h5") as run:
        sheet(right, run.nodes + run.displacement([len(run.times) - 1])[0], r"total, $t=450\,\Delta/c$", COLOURS[0])

    s = np.geomspace(0.009, 0.14, 50)
    growth.loglog(s, rates["theory_1d"][0] * np.sqrt(s / rates["stress"][0]), color=INK, linestyle="--", linewidth=0.9,
                  label=r"$\sqrt{2\sigma_0 C/\rho}$, 1D")
    growth.loglog(rates["stress"], rates["measured_1d"], "o", color=COLOURS[1], markersize=5, label="bar")
    growth.loglog(rates["stress"], rates["theory_2d"], color=COLOURS[3], linestyle="-", linewidth=0.9,
                  label=r"25 × 25, linearised")
    growth.loglog(rates["stress"], rates["measured_2d"], "s", color=COLOURS[3], markersize=4, label="sheet, 25 × 25")
    growth.set_xticks([0.0125, 0.025, 0.05, 0.1], ["0.0125", "0.025", "0.05", "0.1"])
    growth.set_yticks([0.15, 0.2, 0.3, 0.4, 0.5], ["0.15", "0.2", "0.3", "0.4", "0.5"])
    growth.minorticks_off()
    growth.set(xlabel=r"stress $\sigma_0/(\rho c^2)$", ylabel=r"rate $\gamma\Delta/c$", title="Growth, updated Lagrangian")
    growth.legend(loc="upper left", fontsize=7)
    return figure
