"""The seven particles in the middle, updated and total Lagrangian; neighbours out of phase; the displaced particle."""

import matplotlib.pyplot as plt
import numpy as np

from plotting.case import table
from plotting.style import COLOURS, FAINT, INK, WIDTH

SEVEN = ["m3", "m2", "m1", "c", "p1", "p2", "p3"]
TOTAL = [("stress-point", COLOURS[0]), ("variational", COLOURS[2]), ("mirror", COLOURS[4]), ("thesis", COLOURS[3])]
DASHES = {"mirror": "--"}  # on top of variational
FIRST = 7.5  # micrometres, of the displaced particle
UNIT = 1e-3 / np.sqrt(200e9 * 0.7 / (1.3 * 0.4) / 8000)  # spacing / wave speed [s]


def seven(axes, data, title):
    """Displacements beside the uniform stretch; the middle one heavy, the others from light to dark outwards."""
    for j, name in enumerate(SEVEN):
        if name == "c":
            continue
        side = COLOURS[0] if j < 3 else COLOURS[5]
        axes.plot(data["time"] / UNIT, 1e6 * data[name], color=side, linewidth=0.9, alpha=1.0 - 0.22 * (abs(j - 3) - 1),
                  label={2: "left of it", 4: "right of it"}.get(j))
    axes.plot(data["time"] / UNIT, 1e6 * data["c"], color=COLOURS[1], label="displaced particle")
    axes.set(title=title, xlim=(0, 68), xlabel=r"time $tc/\Delta$")


def draw(folder):
    updated, growth = table(folder / "updated.csv"), table(folder / "growth.csv")
    total = {name: table(folder / f"{name}.csv") for name, _ in TOTAL}
    figure, ((left, right), (phase, middle)) = plt.subplots(2, 2, figsize=(0.83 * WIDTH, 3.8))
    seven(left, updated, "Updated Lagrangian: moving kernels")
    seven(right, total["stress-point"], "Total Lagrangian: stress-point")
    right.sharey(left)
    left.set_ylabel(r"displacement $u-\bar\varepsilon X$ [µm]")
    right.legend(loc="upper right")

    start = growth["slight"][0]
    phase.semilogy(updated["time"] / UNIT, updated["amplitude"] / updated["amplitude"][0], color=COLOURS[1])
    phase.semilogy(growth["time"] / UNIT, growth["slight"] / start, color=COLOURS[1], linestyle=":")
    phase.semilogy(growth["time"] / UNIT, growth["theory"] / start, color=INK, linestyle="--", linewidth=0.9)
    for name, colour in TOTAL:
        data = total[name]
        size = data["amplitude"] / data["amplitude"][0]
        peaks = [0, *(np.flatnonzero((size[1:-1] > size[:-2]) & (size[1:-1] >= size[2:])) + 1)]
        phase.semilogy(data["time"][peaks] / UNIT, size[peaks], color=colour, linewidth=1.0,
                       linestyle=DASHES.get(name, "-"))
    phase.text(46, 60, "updated, 0.005 %\ndashed: theory", ha="right", va="center", fontsize=7.5, color=INK)
    phase.text(67, 6, "updated, 5 %", ha="right", va="top", fontsize=7.5, color=COLOURS[1])
    phase.text(67, 0.5, "total, peaks", ha="right", va="center", fontsize=7.5, color=COLOURS[0])
    phase.set(title="Neighbours out of phase", xlabel=r"time $tc/\Delta$", ylabel="amplitude over the first", xlim=(0, 68),
              ylim=(2e-3, 3e2))

    for name, colour in TOTAL:
        middle.plot(total[name]["time"] / UNIT, 1e6 * total[name]["c"] / FIRST, color=colour,
                    linestyle=DASHES.get(name, "-"), label=name)
    middle.axhline(0.0, color=FAINT, linewidth=0.7)
    middle.set(title="Displaced particle, total Lagrangian", xlabel=r"time $tc/\Delta$", ylabel="over the first",
               xlim=(0, 30))
    middle.legend(loc="upper right", ncols=2)
    return figure
