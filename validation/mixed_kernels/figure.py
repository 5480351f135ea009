"""Kinetic energy in tension under pairs of kernels, growth of the same pairs at rest, the mixed form against the run."""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import LogNorm

from plotting.case import table
from plotting.style import COLOURS, INK, WIDTH, prefix

FAMILIES = [("quadratic", "quadratic", COLOURS[0]), ("cubic-spline", "cubic", COLOURS[1]),
            ("wendland-c2", "Wendland", COLOURS[2])]
DASHES = ["-", (0, (4, 2)), (0, (1, 1.5))]


def draw(folder):
    figure = plt.figure(figsize=(0.86 * WIDTH, 4.1))
    left, right = figure.add_gridspec(1, 2, width_ratios=[1.1, 1])
    energy = figure.add_subplot(left)
    pairs, mixed = right.subgridspec(2, 1, height_ratios=[1.1, 1]).subplots()

    data = table(folder / "tension.csv")
    first = data["cubic-spline cubic-spline"][0]
    for strain, dashes in zip(FAMILIES, DASHES):
        for stress in FAMILIES:
            energy.semilogy(data["time"], data[f"{strain[0]} {stress[0]}"] / first, color=stress[2], linestyle=dashes,
                            linewidth=1.3)
    for family, marker in (("quadratic", "o"), ("wendland-c2", "x")):
        energy.semilogy(data["time"][::8], data[f"mixed {family}"][::8] / first, color=INK, linestyle="none",
                        marker=marker, markersize=4, fillstyle="none",
                        label=f"mixed form, {family.split('-')[0].replace('wendl', 'Wendl')}")
    for _, label, colour in FAMILIES:
        energy.plot([], [], color=colour, label=f"stress {label}")
    for (_, label, _), dashes in zip(FAMILIES, DASHES):
        energy.plot([], [], color=INK, linestyle=dashes, label=f"strain {label}")
    energy.set(xlabel=r"time $t\,c/\Delta$", ylabel="kinetic energy / first", xlim=(0, 36),
               title=r"Tension $\sigma_0=0.05\,\rho c^2$, current configuration")
    energy.legend(fontsize=7, loc="upper left", handlelength=2.2)

    data = table(folder / "pairs.csv")
    rates = np.array([data[name] for name, _, _ in FAMILIES])  # strain, stress
    pairs.imshow(np.maximum(rates, 1e-9), cmap="cividis", norm=LogNorm(1e-9, 1e-1), aspect="auto")
    for row in range(3):
        for column in range(3):
            rate = rates[row, column]
            pairs.text(column, row, "stable" if rate < 1e-6 else f"{rate:.1e}".replace("e-0", "e−"), ha="center",
                       va="center", fontsize=7.5, color=INK if rate > 1e-5 else "white")
    labels = [label for _, label, _ in FAMILIES]
    pairs.set(xticks=range(3), yticks=range(3), xticklabels=labels, yticklabels=labels, xlabel="stress",
              ylabel="strain", title=r"At rest, reference [$c/\Delta$]")
    pairs.grid(False)

    data = table(folder / "reinterpolated.csv")
    scale, unit = prefix(data["time"], "s")
    for name, colour in (("displacement", COLOURS[0]), ("stress", COLOURS[1])):
        mixed.semilogy(scale * data["time"], data[name], color=colour, linewidth=1.0, label=name)
    mixed.set(xlabel=f"time $t$ [{unit}]", ylabel="relative difference", ylim=(1e-16, 1e-12),
              title="Re-interpolated run, error")
    mixed.legend(loc="upper left", ncols=2, fontsize=7, handlelength=1.4, columnspacing=1.2)
    return figure
