"""Dispersion curves and phase errors of a bar, lowest vibrations of a free sheet."""

import matplotlib.pyplot as plt
import numpy as np

from plotting.case import table
from plotting.style import COLOURS, FAINT, INK, WIDTH

LINES = [  # column, label, colour, dashes
    ("stress-point", "stress-point", COLOURS[0], "-"),
    ("variational + one-sided stabiliser 4/3", "variational, 1.5 $\\Delta$,\n  one-sided stabiliser 4/3", COLOURS[1], "-"),
    ("variational, support 1.5", r"variational, support 1.5 $\Delta$", COLOURS[2], "-"),
    ("variational, support 2.5", r"variational, 2.5 $\Delta$", COLOURS[3], "-"),
    ("variational, support 5.5", r"variational, 5.5 $\Delta$", COLOURS[4], "-"),
]
MODES = [
    ("stress-point, cell stabiliser", "o", COLOURS[0]),
    ("variational, pair stabiliser", "s", COLOURS[2]),
    ("stress-point", "^", COLOURS[5]),
    ("variational", "v", COLOURS[3]),
]


def draw(folder):
    curves, modes = table(folder / "curves.csv"), table(folder / "modes.csv")
    theta = curves["theta"]
    figure = plt.figure(figsize=(0.9 * WIDTH, 4.2))
    left, right = figure.add_gridspec(1, 2, width_ratios=[1.15, 1])
    wave = figure.add_subplot(left)
    upper, lower = right.subgridspec(2, 1).subplots()

    wave.plot(theta / np.pi, theta, color=FAINT, linestyle="--", linewidth=1)
    wave.annotate("bar", xy=(0.72, 0.72 * np.pi), xytext=(-6, 2), textcoords="offset points", ha="right", color=FAINT)
    for name, label, colour, dashes in LINES:
        wave.plot(theta / np.pi, curves[name], color=colour, linestyle=dashes, label=label)
    wave.set(xlabel=r"wave number $k\Delta/\pi$", ylabel=r"frequency $\omega\Delta/c$", xlim=(0, 1), ylim=(0, 3.2),
             title="Dispersion")
    wave.legend(loc="upper left", bbox_to_anchor=(0.0, 1.0))

    for name, _, colour, dashes in LINES:
        error = np.abs(curves[name] / theta - 1)
        part = theta < 0.55 * np.pi
        upper.loglog(theta[part] / np.pi, error[part], color=colour, linestyle=dashes)
    for order, at, factor in ((2, 0.026, 0.25), (4, 0.08, 0.36)):
        x = np.array([at, 2 * at])
        y = factor * x**order
        upper.loglog(x, y, color=INK, linewidth=0.9)
        upper.annotate(f"order {order}", xy=(x[0], y[0]), xytext=(2, -8), textcoords="offset points", fontsize=8)
    upper.set_xticks([0.02, 0.05, 0.1, 0.2, 0.5], ["0.02", "0.05", "0.1", "0.2", "0.5"])
    upper.tick_params(axis="x", which="minor", labelbottom=False)
    upper.set(xlabel=r"wave number $k\Delta/\pi$", ylabel=r"$|\omega/(ck)-1|$", ylim=(1e-8, 2),
              title="Error of the phase speed")

    for name, marker, colour in MODES:
        lower.plot(modes["number"], modes[name], marker=marker, markersize=3.2, linewidth=0.8, color=colour, label=name)
    lower.axhline(1.0, color=FAINT, linewidth=0.8, linestyle="--")
    lower.set(xlabel="number of the mode", ylabel=r"$\omega_n/\omega_1$", xlim=(0.5, 24.5),
              ylim=(-0.08, 3.6), title="Free sheet of 12 × 12 cells")
    lower.legend(loc="upper left", fontsize=6.5)
    return figure
