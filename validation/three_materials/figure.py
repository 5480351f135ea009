"""Histories at the four points, a row a material and a column a formulation."""

import matplotlib.pyplot as plt

from plotting import bar
from plotting.style import WIDTH

POINTS = {"p1": "0", "p2": "0.05 m", "p3": "0.10 m", "p4": "0.15 m"}
MATERIALS = {1: "1: 5801 m/s", 2: "2: 4102 m/s", 3: "3: 8204 m/s"}


def draw(folder):
    figure = plt.figure(figsize=(WIDTH, 4.2))
    head, panels = bar.grid(figure, 3, 4)
    bar.legend(head, POINTS.values())
    bar.titles(panels)
    for row, (number, words) in zip(panels, MATERIALS.items()):
        for axes, formulation in zip(row, bar.FORMULATIONS):
            run = folder / f"{formulation}-{number}"
            bar.stresses(axes, run, POINTS)
            bar.exact_stresses(axes, run / "probes_exact.csv", POINTS)
        row[0].set_ylabel(f"{words}\n$P$ [kPa]")
    panels[0, 0].set(xlim=(0, 54), ylim=(-240, 130), yticks=[-200, -100, 0, 100])
    return figure
