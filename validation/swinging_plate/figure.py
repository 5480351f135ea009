"""Errors of the swinging plate against the spacing, by formulation and Poisson's ratio."""

import matplotlib.pyplot as plt

from plotting.case import table
from plotting.style import COLOURS, FAINT, WIDTH

METHODS = {"stress-point": ("o", COLOURS[0]), "mirror": ("s", COLOURS[2]), "variational": ("^", COLOURS[1])}
QUANTITIES = {"displacement": "displacement $u$", "velocity": "velocity $v$", "stress": "stress $P$"}


def draw(folder):
    data = table(folder / "errors.csv")
    spacing = data["spacing"]
    figure = plt.figure(figsize=(WIDTH * 1.25, 3.9))
    grid = figure.add_gridspec(2, 3, height_ratios=[1, 0.16])
    axes = [figure.add_subplot(grid[0, k]) for k in range(3)]
    for panel, (quantity, text) in zip(axes, QUANTITIES.items()):
        for method, (marker, colour) in METHODS.items():
            for poisson, line in (("0.3", "-"), ("0.45", "--")):
                panel.loglog(spacing, data[f"{method} {poisson} {quantity}"], line, marker=marker, markersize=4,
                             color=colour, label=f"{method}, ν = {poisson}")
        low = data[f"stress-point 0.45 {quantity}"][-1] / 2.2
        panel.loglog(spacing, low * (spacing / spacing[-1]) ** 2, ":", color=FAINT)
        panel.text(spacing[1], low * (spacing[1] / spacing[-1]) ** 2 / 1.9, "order 2", color=FAINT, fontsize=8)
        panel.set_title(text)
        panel.set_xlabel("spacing Δ [m]")
        panel.set_xticks(spacing, [f"1/{round(1 / h)}" for h in spacing])
        panel.minorticks_off()
    axes[0].set_ylabel("relative L2 error at t = 2 ms")
    below = figure.add_subplot(grid[1, :])
    below.axis("off")
    below.legend(*axes[0].get_legend_handles_labels(), loc="center", ncols=3)
    return figure
