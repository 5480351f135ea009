"""The hoop stress along the hole, and how the errors of the stress fall with the spacing."""

import matplotlib.pyplot as plt
import numpy as np

from plotting.case import table
from plotting.style import COLOURS, FAINT, INK, WIDTH

METHODS = {"consistent": ("o", COLOURS[0]), "consistent, irregular": ("s", COLOURS[2]),
           "variational": ("^", COLOURS[1])}
ERRORS = {0: ("peak", "-"), 2: ("all stresses, L2", "--")}


def hoop(axes, folder):
    theta = np.linspace(0, 90, 200)
    axes.plot(theta, 1 - 2 * np.cos(2 * np.radians(theta)), color=INK, linewidth=1, label="Kirsch")
    for method, (marker, colour) in METHODS.items():
        name = method.replace(",", "").replace(" ", "_")
        data = table(folder / f"hoop_{name}.csv")
        axes.plot(np.degrees(data["angle"]), data["hoop"], marker, markersize=3.5, color=colour,
                  markerfacecolor="none", label=method)
    axes.set(title="Hoop stress along the hole, 20 particles a radius", xlabel=r"$\theta$ [degrees]",
             ylabel=r"$\sigma_{\theta\theta}/S$", xlim=(-2, 92))
    axes.set_xticks(range(0, 91, 15))
    axes.legend(loc="upper left")


def errors(axes, data):
    spacing = data["spacing"]
    for method, (marker, colour) in METHODS.items():
        for column, (text, line) in ERRORS.items():
            axes.loglog(spacing, data[f"{method} {column}"], line, marker=marker, markersize=4, color=colour,
                        label=f"{method}: {text}")
    low = data["consistent 2"][-1] / 2
    axes.loglog(spacing, low * (spacing / spacing[-1]) ** 2, ":", color=FAINT)
    axes.text(spacing[1], low * (spacing[1] / spacing[-1]) ** 2 / 1.9, "order 2", color=FAINT, fontsize=8)
    axes.set(title="Relative errors", xlabel=r"spacing $\Delta/a$", ylim=(None, 4))
    axes.set_xticks(spacing, [f"1/{round(1 / h)}" for h in spacing])
    axes.minorticks_off()
    axes.legend(loc="upper left", fontsize=7)


def draw(folder):
    figure, (left, right) = plt.subplots(1, 2, figsize=(WIDTH * 1.15, 3.6))
    hoop(left, folder)
    errors(right, table(folder / "errors.csv"))
    return figure
