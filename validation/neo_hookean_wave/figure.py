"""Histories, the path in the plane of stress and velocity, speeds of the levels of the front, and errors."""

import matplotlib.pyplot as plt
import matplotlib.ticker
import numpy as np

from plotting import bar
from plotting.case import table
from plotting.style import COLOURS, WIDTH

POINTS = {"p1": "0", "p2": "0.05 m", "p3": "0.10 m", "p4": "0.15 m"}
SPACING = "0.00025"
IMPEDANCE = 8000 * 5801.19  # of the bar at rest [kg/(m² s)]
MARKERS = "o^sD"


def draw(folder):
    figure = plt.figure(figsize=(WIDTH, 4.6))
    head, panels, lower = bar.grid(figure, 1, 4, heights=[1, 1.15])
    bar.legend(head, POINTS.values(), exact="exact, 0.10 m")
    bar.titles(panels)
    exact = table(folder / "exact.csv")
    for axes, formulation in zip(panels[0], bar.FORMULATIONS):
        bar.stresses(axes, folder / f"{formulation}-{SPACING}", POINTS, unit=1e9)
        axes.plot(1e6 * exact["time"], 1e-9 * exact["stress"], **bar.EXACT)
    panels[0, 0].set(xlim=(0, 42), ylim=(-72, 5), ylabel="$P$ [GPa]")
    left, middle, right = lower.subplots(1, 3)
    path(left, folder, exact)
    speeds(middle, folder)
    errors(right, table(folder / "errors.csv"))
    return figure


def path(axes, folder, exact):
    """Velocity against stress at 0.10 m, until the fixed end sends something back, less what linear theory says."""
    for k, formulation in enumerate(bar.FORMULATIONS):
        run = table(folder / f"{formulation}-{SPACING}" / "probes.csv")
        early = run["time"] < 32e-6
        P = run["p3.pk1_xx"][early]
        axes.plot(-1e-9 * P, run["p3.velocity_x"][early] + P / IMPEDANCE, color=COLOURS[k], linewidth=2.6 - 0.6 * k)
    axes.plot(-1e-9 * exact["stress"], exact["velocity"] + exact["stress"] / IMPEDANCE, **bar.EXACT)
    axes.set(xlabel="$-P$ at 0.10 m [GPa]", ylabel="$v$ less the linear $-P/\\rho c_0$ [m/s]", title="$v = -\\int c\\,dF$")


def speeds(axes, folder):
    for k, formulation in enumerate(bar.FORMULATIONS):
        seen = table(folder / f"speeds-{formulation}.csv")
        axes.plot(-1e2 * seen["gradient"], 1e-3 * seen["observed"], MARKERS[k], markersize=6.5 - 1.2 * k, color=COLOURS[k],
                  markerfacecolor="none", label=formulation)
    axes.plot(-1e2 * seen["gradient"], 1e-3 * seen["exact"], **bar.EXACT)
    axes.set(xlabel="compression $1 - F$ [%]", ylabel="speed of the level [km/s]", title="$c = \\sqrt{(dP/dF)/\\rho}$")
    axes.legend(handlelength=1.0)


def errors(axes, data):
    for k, formulation in enumerate(bar.FORMULATIONS):
        mine = data["formulation"] == k
        axes.loglog(1e3 * data["spacing"][mine], data["error"][mine], MARKERS[k] + "-", color=COLOURS[k], markersize=3.5,
                    linewidth=1.1)
    ends = np.array([0.125, 0.5])
    axes.loglog(ends, 6e-6 * (ends / ends[0]) ** 2, color="#8a8a8a", linewidth=0.7)
    axes.text(0.27, 1.7e-5, "order 2", color="#8a8a8a", fontsize=8)
    axes.set_xticks([0.125, 0.25, 0.5], minor=False)
    axes.xaxis.set_major_formatter(matplotlib.ticker.FormatStrFormatter("%g"))
    axes.xaxis.set_minor_formatter(matplotlib.ticker.NullFormatter())
    axes.set(xlabel="spacing Δ [mm]", title="relative $L_2$ error of stress")
