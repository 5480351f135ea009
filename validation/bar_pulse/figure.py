"""Histories at the four points, a row a smoothing of the load and a column a formulation; below what wide kernels cost."""

import matplotlib.pyplot as plt
import matplotlib.ticker
import numpy as np

from plotting.case import table
from plotting.style import COLOURS, FAINT, INK, WIDTH

FORMULATIONS = ["thesis", "mirror", "stress-point", "variational"]
POINTS = {"p1": "0", "p2": "0.05 m", "p3": "0.10 m", "p4": "0.15 m"}
EXACT = dict(color=INK, linewidth=0.6, dashes=(4, 2.5), zorder=3)
END = 44  # [µs]
FLOOR = -275  # [kPa]


def draw(folder):
    figure = plt.figure(figsize=(WIDTH, 5.4))
    head, upper, lower = figure.subfigures(3, 1, height_ratios=[0.09, 2.2, 1.15])
    handles = [plt.Line2D([], [], color=COLOURS[k], label=x) for k, x in enumerate(POINTS.values())]
    handles.append(plt.Line2D([], [], **EXACT, label="d'Alembert"))
    head.legend(handles=handles, ncols=5, loc="center", handlelength=1.8)
    panels = upper.subplots(3, 4, sharex=True, sharey=True)
    for row, smoothing, words in zip(panels, ["large", "intermediate", "none"], ["large", "intermediate", "no"]):
        for axes, formulation in zip(row, FORMULATIONS):
            histories(axes, folder / f"{smoothing}-{formulation}")
        row[0].set_ylabel(f"{words}\nsmoothing\n$P$ [kPa]")
    for axes, formulation in zip(panels[0], FORMULATIONS):
        axes.set_title(formulation, fontweight="bold")
    for axes in panels[-1]:
        axes.set_xlabel("time $t$ [µs]")
    panels[0, 0].set(xlim=(0, END), ylim=(FLOOR, 65), yticks=[-200, -100, 0])
    kernels(*lower.subplots(1, 2, sharey=True), table(folder / "supports.csv"))
    return figure


def histories(axes, run):
    computed, exact = table(run / "probes.csv"), table(run / "probes_exact.csv")
    for k, point in enumerate(POINTS):
        name = f"{point}.pk1_xx"
        time, stress = 1e6 * computed["time"], 1e-3 * computed[name]
        if k == 0 and np.ptp(stress[time > END / 2]) > 100:  # long after the pulse has left
            top = np.max(np.abs(stress[time > END / 2]))
            axes.text(0.03, 0.06, f"{POINTS[point]}: rings at\n±{top:.0f} kPa", transform=axes.transAxes,
                      fontsize=7, color=FAINT)
            continue
        axes.plot(time[time < END], stress[time < END], color=COLOURS[k], linewidth=0.8)
        axes.plot(1e6 * exact["time"][time < END], 1e-3 * exact[name][time < END], **EXACT)


def kernels(left, right, data):
    """Error against spacing and against work; a line a formulation and support."""
    for k, formulation in enumerate(FORMULATIONS):
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
