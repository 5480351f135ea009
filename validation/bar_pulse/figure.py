"""Histories at the four points, a row a smoothing of the load and a column a formulation; below what wide kernels cost."""

import matplotlib.pyplot as plt
import matplotlib.ticker
import numpy as np

from plotting import bar
from plotting.case import table
from plotting.style import COLOURS, FAINT, WIDTH

SMOOTHINGS = {"large": "large", "intermediate": "intermediate", "none": "no"}
POINTS = {"p1": "0", "p2": "0.05 m", "p3": "0.10 m", "p4": "0.15 m"}
END = 44  # [µs]


def draw(folder):
    figure = plt.figure(figsize=(WIDTH, 5.4))
    head, panels, lower = bar.grid(figure, 3, 4, heights=[2.2, 1.15])
    bar.legend(head, POINTS.values())
    bar.titles(panels)
    for row, (smoothing, words) in zip(panels, SMOOTHINGS.items()):
        for axes, formulation in zip(row, bar.FORMULATIONS):
            histories(axes, folder / f"{smoothing}-{formulation}")
        row[0].set_ylabel(f"{words}\nsmoothing\n$P$ [kPa]")
    panels[0, 0].set(xlim=(0, END), ylim=(-275, 65), yticks=[-200, -100, 0])
    kernels(*lower.subplots(1, 2, sharey=True), table(folder / "supports.csv"))
    return figure


def histories(axes, run):
    computed = table(run / "probes.csv")
    late = computed["time"] > 0.5e-6 * END  # the pulse has left
    ringing = 1e-3 * np.max(np.abs(computed["p1.pk1_xx"][late]))
    hidden = ["p1"] if ringing > 50 else []
    if hidden:
        axes.text(0.03, 0.06, f"0: rings at\n±{ringing:.0f} kPa", transform=axes.transAxes, fontsize=7, color=FAINT)
    bar.stresses(axes, run, POINTS, hidden=hidden)
    bar.exact_stresses(axes, run / "probes_exact.csv", POINTS, hidden=hidden)


def kernels(left, right, data):
    """Error against spacing and against work; a line a formulation and support."""
    for k, formulation in enumerate(bar.FORMULATIONS):
        for support, marker in (0.0, "o"), (2.5, "o"), (3.5, "^"), (5.5, "s"):
            mine = (data["formulation"] == k) & (data["support"] == support)
            if not mine.any():
                continue
            style = dict(color=[*COLOURS[:3], COLOURS[4]][k], marker=marker, markersize=3.5, linewidth=1.1)
            left.loglog(1e3 * data["spacing"][mine], data["error"][mine],
                        label=formulation + (f", {support} Δ" if support else ""), **style)
            right.loglog(data["products"][mine], data["error"][mine], **style)
    left.set_ylim(2e-4, 0.6)
    left.set_xticks([0.125, 0.25, 0.5], minor=False)
    left.xaxis.set_major_formatter(matplotlib.ticker.FormatStrFormatter("%g"))
    left.xaxis.set_minor_formatter(matplotlib.ticker.NullFormatter())
    left.set(xlabel="spacing Δ [mm]", ylabel="relative $L_2$ error\nof stress at 0.10 m")
    right.set(xlabel="work: steps × entries of the gradient")
    right.legend(*left.get_legend_handles_labels(), loc="center left", bbox_to_anchor=(1.02, 0.5), handlelength=1.8)
