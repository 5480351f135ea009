"""Errors on irregular particles against the spacing: corrected gradients converge, plain ones do not."""

import matplotlib.pyplot as plt

from plotting.case import table
from plotting.style import COLOURS, FAINT, WIDTH

METHODS = {"variational": ("^", COLOURS[1]), "consistent, degrees (1, 1)": ("o", COLOURS[0]),
           "consistent, degrees (2, 1)": ("s", COLOURS[2])}
QUANTITIES = {"displacement": "displacement $u$", "velocity": "velocity $v$", "stress": "stress $P$"}


def draw(folder):
    data = table(folder / "plate.csv")
    spacing = data["spacing"]
    figure = plt.figure(figsize=(WIDTH * 1.25, 3.9))
    grid = figure.add_gridspec(2, 3, height_ratios=[1, 0.12])
    axes = [figure.add_subplot(grid[0, k]) for k in range(3)]
    for panel, (quantity, text) in zip(axes, QUANTITIES.items()):
        for method, (marker, colour) in METHODS.items():
            worst, best = data[f"{method} {quantity} worst"], data[f"{method} {quantity} best"]
            panel.fill_between(spacing, best, worst, color=colour, alpha=0.25, linewidth=0)
            panel.loglog(spacing, data[f"{method} {quantity} median"], marker=marker, markersize=4, color=colour,
                         label=method)
        low = data[f"consistent, degrees (2, 1) {quantity} worst"][-1] / 2
        panel.loglog(spacing, low * (spacing / spacing[-1]) ** 2, ":", color=FAINT)
        panel.text(spacing[1], low * (spacing[1] / spacing[-1]) ** 2 / 2.2, "order 2", color=FAINT, fontsize=8)
        panel.set(title=text, xlabel="spacing Δ [m]")
        panel.set_xticks(spacing, [f"1/{round(1 / h)}" for h in spacing])
        panel.tick_params(axis="x", which="minor", bottom=False, labelbottom=False)
    axes[0].set_ylabel("relative L2 error, median and spread")
    below = figure.add_subplot(grid[1, :])
    below.axis("off")
    below.legend(*axes[0].get_legend_handles_labels(), loc="center", ncols=3)
    return figure
