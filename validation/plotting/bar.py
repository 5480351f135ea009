"""Histories of stress in a bar, panels side by side: what the cases of waves share."""

import matplotlib.pyplot as plt
import numpy as np

from plotting.case import table
from plotting.style import COLOURS, INK

FORMULATIONS = ["thesis", "mirror", "stress-point", "variational"]
EXACT = dict(color=INK, linewidth=0.6, dashes=(4, 2.5), zorder=3)


def grid(figure, rows, columns, **ratios):
    """Panels with common axes, under a line for the legend; the rest of the figure, if there is to be one."""
    heights = ratios.get("heights", [1])
    head, upper, *rest = figure.subfigures(1 + len(heights), 1, height_ratios=[0.035 * sum(heights), *heights])
    panels = upper.subplots(rows, columns, sharex=True, sharey=True, squeeze=False)
    for axes in panels[-1]:
        axes.set_xlabel("time $t$ [µs]")
    return head, panels, *rest


def legend(head, places, exact="d'Alembert"):
    """Names of the probes, in the colours of their order, and of the dashed line if there is one."""
    handles = [plt.Line2D([], [], color=COLOURS[k], label=place) for k, place in enumerate(places)]
    if exact:
        handles.append(plt.Line2D([], [], **EXACT, label=exact))
    head.legend(handles=handles, ncols=len(handles), loc="center", handlelength=1.8)


def titles(panels, names=FORMULATIONS):
    for axes, name in zip(panels[0], names):
        axes.set_title(name, fontweight="bold")


def stresses(axes, run, points, unit=1e3, cut=np.inf, hidden=()):
    """P at the probes over µs, but for hidden ones; a history ends where |P| [unit] exceeds the cut."""
    computed = table(run / "probes.csv")
    for k, point in enumerate(points):
        if point in hidden:
            continue
        stress = computed[f"{point}.pk1_xx"] / unit
        lost = np.abs(stress) > cut
        kept = slice(0, np.argmax(lost) + 1 if lost.any() else None)
        axes.plot(1e6 * computed["time"][kept], stress[kept], color=COLOURS[k], linewidth=0.8)


def exact_stresses(axes, path, points, unit=1e3, hidden=()):
    """The same of a table of exact histories."""
    exact = table(path)
    for point in points:
        if point not in hidden:
            axes.plot(1e6 * exact["time"], exact[f"{point}.pk1_xx"] / unit, **EXACT)
