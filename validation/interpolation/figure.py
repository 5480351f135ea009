"""Values at bare ends and under the modified SPH matrix, orders of the errors, four falling edges."""

import matplotlib.pyplot as plt
import numpy as np

from plotting.case import table
from plotting.style import COLOURS, FAINT, INK, WIDTH

SUPPORTS = [("1.5", COLOURS[1]), ("2.5", COLOURS[2]), ("3.5", COLOURS[5]), ("4.5", COLOURS[3]), ("5.5", COLOURS[0])]
STUDIES = [
    ("plain sums, no ghosts", "plain, bare", COLOURS[1], "v"),
    ("plain sums, ghosts", "plain, ghosts", COLOURS[4], "^"),
    ("least squares, no ghosts", "least squares, bare", COLOURS[2], "s"),
    ("normalised sums, ghosts", "normalised, ghosts", COLOURS[0], "o"),
    ("stress points, no ghosts", "stress points, bare", COLOURS[3], "D"),
]
EDGES = [(64, "very low gradient"), (16, "low"), (4, "high"), (1, "discontinuous")]


def draw(folder):
    figure = plt.figure(figsize=(0.83 * WIDTH, 4.05))
    upper, lower = figure.add_gridspec(2, 1, height_ratios=[1.15, 1])
    bare, ends, orders = upper.subgridspec(1, 3).subplots()
    edges = lower.subgridspec(1, 4).subplots(sharey=True)

    data = table(folder / "bare.csv")
    bare.plot(data["x"], 16 * data["exact"], color=INK, linewidth=3, alpha=0.25)
    for support, colour in SUPPORTS:
        bare.plot(data["x"], 16 * data[support], color=colour, linewidth=1.1, marker=".", markersize=3.5, label=support)
    bare.set(xlabel="$x$", ylabel=r"$16\,\langle f\rangle$", xlim=(-0.005, 0.3), ylim=(0, 1.05),
             title=r"$f=(x-\frac{1}{2})^4$, no ghosts")
    bare.legend(title="support/Δ", fontsize=7, title_fontsize=7, loc="upper right", handlelength=1.4,
                labelspacing=0.3)

    data = table(folder / "modified.csv")
    exact = 16 * (data["x"] - 0.5) ** 4
    ends.plot(data["x"], exact, color=INK, linewidth=3, alpha=0.25, label="$f$")
    for support, colour in (SUPPORTS[1], SUPPORTS[4]):
        ends.plot(data["x"], 16 * data[f"consistent {support}"], color=colour, linewidth=1.1, marker=".", markersize=4,
                  label=f"consistent, {support}")
        ends.plot(data["x"], 16 * data[f"printed {support}"], color=colour, linestyle="--", linewidth=1.1,
                  label=f"as printed, {support}")
    ends.axhline(1.0, color=FAINT, linewidth=0.8)
    ends.set(xlabel="$x$", xlim=(-0.005, 0.2), ylim=(0, 2.4), title="Modified SPH matrix (2.46)")
    ends.legend(fontsize=6.5, handlelength=1.6, loc="upper right", labelspacing=0.3)

    data = table(folder / "orders.csv")
    for name, label, colour, marker in STUDIES:
        orders.loglog(data["spacing"], data[f"derivative, {name}"], color=colour, marker=marker, markersize=3,
                      linewidth=1.0, label=label)
    orders.set(xlabel="spacing Δ", ylabel=r"largest error of $f'$", title="Derivative, 2.5 Δ", ylim=(1e-7, 1e8))
    orders.legend(fontsize=6.2, handlelength=1.4, loc="upper right", labelspacing=0.25)

    for panel, (width, label) in zip(edges, EDGES):
        data = table(folder / f"edge{width}.csv")
        x = data["x"]
        panel.plot(x, -width * data["exact"], color=INK, linewidth=3, alpha=0.25, label="exact")
        for support, colour in (SUPPORTS[0], SUPPORTS[1], SUPPORTS[4]):
            panel.plot(x, -width * data[f"plain {support}"], color=colour, linewidth=1.1, label=f"plain, {support}")
        panel.plot(x, -width * data["normalised 1.5"], color=INK, linestyle=":", linewidth=1.2,
                   label="normalised, 1.5")
        panel.set(xlabel="$x/Δ$", title=label, xlim=(-0.25 * width - 5, 1.25 * width + 5), ylim=(-0.05, 1.45))
    edges[0].set_ylabel("slope / that of the edge")
    edges[3].legend(fontsize=6.5, handlelength=1.4, loc="upper left", labelspacing=0.25)
    return figure
