"""Stress over stretch against the law, and the phases of a bar that carries no waves any more."""

import matplotlib.pyplot as plt
import numpy as np

from plotting.case import table
from plotting.run import Run
from plotting.style import COLOURS, FAINT, INK, WIDTH

LENGTH = 0.015  # [m]
YOUNG = 200e9  # [Pa]
LIMITS = 3.6307, 6.3997  # dP/dF < 0 between them at nu = 0.49
METHODS = {"thesis": ("v", COLOURS[3]), "mirror": ("s", COLOURS[2]), "variational": ("^", COLOURS[1]),
           "stress-point": ("o", COLOURS[0])}


def law(stretch, poisson):
    """Cauchy stress of a bar in 1D strain [GPa]."""
    mu, lame = YOUNG / 2 / (1 + poisson), YOUNG * poisson / (1 + poisson) / (1 - 2 * poisson)
    return 1e-9 * (mu * (stretch - 1 / stretch) + lame * np.log(stretch) / stretch)


def history(folder):
    """Stretch of the bar and Cauchy stress in its middle [GPa]."""
    columns = table(folder / "probes.csv")
    return 1 + columns["end.displacement_x"] / LENGTH, 1e-9 * columns["middle.cauchy_xx"]


def markers(axes, stretch, stress, name, at, **style):
    marker, colour = METHODS[name]
    axes.plot(at, np.interp(at, stretch, stress), marker, color=colour, markersize=4.5, markerfacecolor="none", **style)


def draw(folder):
    figure, ((rest, curves), (errors, phases)) = plt.subplots(2, 2, figsize=(0.87 * WIDTH, 4.3))
    grid = np.linspace(1, 6, 300)
    for k, name in enumerate(METHODS):
        marker, colour = METHODS[name]
        stretch, stress = history(folder / f"{name}-from-rest")
        rest.plot(stretch, stress, color=colour, linewidth=1.0, label=name)
        for poisson in 0.3, 0.48:
            stretch, stress = history(folder / f"{name}-{poisson}")
            markers(curves, stretch, stress, name, np.arange(1.25 + 0.15 * k, 6.01, 0.6))
        stretch, stress = history(folder / f"{name}-0.3")
        stretch, stress = stretch[1::12], stress[1::12]
        errors.semilogy(stretch, np.abs(stress / law(stretch, 0.3) - 1), color=colour, linewidth=0.8)
    rest.plot(grid, law(grid, 0.3), color=INK, linewidth=1.0, linestyle="--", label="law")
    rest.set(title="From rest in 30 transits, ν = 0.3")
    rest.legend(loc="lower right")

    for poisson, below in (0.3, 16), (0.48, 16), (0.49, 18):
        curves.plot(grid, law(grid, poisson), color=INK, linewidth=1.0, linestyle="--")
        curves.annotate(f"ν = {poisson}", (5.95, law(5.95, poisson)), xytext=(0, -below), textcoords="offset points",
                        ha="right")
    stretch, stress = history(folder / "stress-point-0.49")
    curves.plot(stretch, stress, color=COLOURS[0], linewidth=0.6)
    curves.axvline(LIMITS[0], color=FAINT, linewidth=0.9, linestyle=":")
    curves.annotate("dP/dF = 0\nat ν = 0.49", (LIMITS[0], 25), xytext=(4, 0), textcoords="offset points",
                    color=FAINT, fontsize=8)
    curves.set(title="Without waves, in 300 transits", ylim=(0, None))

    errors.axhline(1e-2, color=FAINT, linewidth=0.9, linestyle=":")
    errors.annotate("1 %", (1.15, 2.2e-3), color=FAINT, fontsize=8)
    errors.set(title="Error of the stress, ν = 0.3, without waves", ylabel="|σ/law − 1|", ylim=(1e-13, 1))
    for axes in (rest, curves):
        axes.set_ylabel("Cauchy stress σ [GPa]")
    for axes in (rest, curves, errors):
        axes.set(xlabel="stretch of the bar", xlim=(1, 6))

    phases.axhspan(*LIMITS, color="#eeeeee", linewidth=0)
    phases.annotate("no waves: dP/dF < 0", (0.3, 4.9), fontsize=8, color=FAINT)
    phases.axhline(4, color=INK, linewidth=1.0, linestyle="--")
    for name in "stress-point", "mirror":
        with Run(folder / f"{name}-0.49" / "run.h5") as run:
            X, F = run.field("deformation_gradient_xx", [3])
        marker, colour = METHODS[name]
        phases.plot(1e3 * X[:, 0], F[0], marker, color=colour, markersize=3.2, markerfacecolor="none", label=name)
    phases.set(title="Local stretch at a mean of 4, ν = 0.49", xlabel="$X$ [mm]", ylabel="stretch $F$", xlim=(0, 15),
               ylim=(1.5, 10.9))
    phases.legend(loc="upper center", ncols=2)
    return figure
