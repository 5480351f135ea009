"""Stress over stretch of a sheet drawn in two directions, its width, and where its waves stop."""

import matplotlib.pyplot as plt
import numpy as np

from plotting.case import table
from plotting.style import COLOURS, FAINT, INK, WIDTH

LENGTH, WIDTH_OF_SHEET = 0.015, 0.0025  # [m]
YOUNG = 200e9  # [Pa]
METHODS = {"thesis": ("v", COLOURS[3]), "mirror": ("s", COLOURS[2]), "variational": ("^", COLOURS[1]),
           "stress-point": ("o", COLOURS[0])}
PATHS = {"1-1": "$λ_2=1$", "2-2": "$λ_2=2$", "1-2": "$λ_2$ from 1 to 2"}


def constants(poisson):
    return YOUNG * poisson / (1 + poisson) / (1 - 2 * poisson), YOUNG / 2 / (1 + poisson)


def second(path, first):
    start, end = (float(value) for value in path.split("-"))
    return start + (end - start) * (first - 1) / 5


def law(first, across, poisson=0.3):
    """Cauchy stress along the first stretch [GPa]."""
    lame, mu = constants(poisson)
    J = first * across
    return 1e-9 * (mu * (first**2 - 1) + lame * np.log(J)) / J


def slowest(first, across, poisson=0.49):
    """Sign of rho c^2 of the slowest wave."""
    lame, mu = constants(poisson)
    s = np.minimum(first, across)
    return mu * (s**2 + 1) + lame * (1 - np.log(first * across))


def draw(folder):
    figure, (stress, width, waves) = plt.subplots(1, 3, figsize=(0.9 * WIDTH, 3.7), width_ratios=[1.25, 1, 1])
    first = np.linspace(1, 6, 200)
    for path, text in PATHS.items():
        line, = stress.plot(first, law(first, second(path, first)), color=INK, linewidth=0.9, linestyle="--")
        for k, (name, (marker, colour)) in enumerate(METHODS.items()):
            columns = table(folder / f"{name}-{path}" / "probes.csv")
            stretch = 1 + columns["corner.displacement_x"] / LENGTH
            sigma = 1e-9 * columns["centre.cauchy_xx"]
            if name == "thesis":
                stress.plot(stretch, sigma, color=colour, linewidth=1.2)
                continue
            at = np.arange(1.2 + 0.2 * k, 6.01, 0.8)
            stress.plot(at, np.interp(at, stretch, sigma), marker, color=colour, markersize=4, markerfacecolor="none")
        for name in "thesis", "stress-point":
            columns = table(folder / f"{name}-{path}" / "probes.csv")
            width.plot(1 + columns["corner.displacement_x"] / LENGTH, columns["centre.deformation_gradient_yy"],
                       color=METHODS[name][1], linewidth=1.2)
        width.plot(first, second(path, first), color=INK, linewidth=0.9, linestyle="--")
    line.set_label("law (5.5)")
    for name, (marker, colour) in METHODS.items():
        style = {"linestyle": "-"} if name == "thesis" else {"linestyle": "", "marker": marker, "markersize": 4}
        stress.plot([], [], color=colour, markerfacecolor="none", label=name, **style)
    stress.legend(loc="upper left")
    stress.set(title="Stress, ν = 0.3", xlabel="$λ_1$", ylabel="Cauchy stress $σ_1$ [GPa]", xlim=(1, 6), ylim=(0, 560))
    width.set(title="Width at the centre", xlabel="$λ_1$", ylabel="$λ_2$", xlim=(1, 6), ylim=(0.9, 2.15),
              xticks=[1, 2, 3, 4, 5, 6])
    width.annotate("imposed", (3.4, second("1-2", 3.4)), xytext=(-7, 0), textcoords="offset points", ha="right")
    width.annotate("thesis", (4.2, 1.46), color=METHODS["thesis"][1])

    x, y = np.meshgrid(np.linspace(0.8, 3.4, 400), np.linspace(0.8, 2.4, 300))
    waves.contourf(x, y, slowest(x, y), levels=[-np.inf, 0], colors=["#e8e8e8"])
    waves.contour(x, y, slowest(x, y), levels=[0], colors=[FAINT], linewidths=0.9)
    waves.annotate("no waves", (2.75, 2.2), ha="center", color=FAINT)
    for path, text in PATHS.items():
        for name in "mirror", "variational", "stress-point":
            columns = table(folder / f"{name}-{path}-0.49" / "probes.csv")
            F = columns["centre.deformation_gradient_xx"], columns["centre.deformation_gradient_yy"]
            marker, colour = METHODS[name]
            waves.plot(*F, color=INK, linewidth=0.8)
            lost = np.argmax(slowest(*F) < 0)
            waves.plot(F[0][lost], F[1][lost], marker, color=colour, markersize=5, markerfacecolor="none", zorder=3)
    for at, text in (((1.5, 0.93), PATHS["1-1"]), ((1.02, 2.05), PATHS["2-2"]), ((1.05, 1.32), PATHS["1-2"])):
        waves.annotate(text, at, fontsize=8)
    waves.set(title="Waves stop, ν = 0.49", xlabel="$λ_1$", ylabel="$λ_2$", xlim=(0.95, 3.4), ylim=(0.9, 2.4))
    return figure
