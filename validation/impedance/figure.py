"""Histories on both sides of the interface, a row a density ratio and a column a formulation."""

import matplotlib.pyplot as plt

from plotting import bar
from plotting.style import WIDTH

POINTS = {"p1": "0.0375 m", "p2": "0.074 m", "p3": "0.1125 m"}
DENSITIES = {"1-4": "ρ × 1/4", "4": "ρ × 4", "heavy": "ρ × $10^8$", "light": "ρ × $10^{-4}$"}


def draw(folder):
    figure = plt.figure(figsize=(WIDTH, 5.0))
    head, panels = bar.grid(figure, 4, 4)
    bar.legend(head, POINTS.values(), exact="exact")
    bar.titles(panels)
    for row, (name, words) in zip(panels, DENSITIES.items()):
        for axes, formulation in zip(row, bar.FORMULATIONS):
            run = f"{formulation}-{name}"
            bar.stresses(axes, folder / run, POINTS)
            bar.exact_stresses(axes, folder / f"{run}-exact.csv", POINTS)
        row[0].set_ylabel(f"{words}\n$P$ [kPa]")
    panels[0, 0].set(xlim=(0, 40), ylim=(-225, 125), yticks=[-200, -100, 0, 100])
    return figure
