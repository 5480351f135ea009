"""Error of the first period of a clamped plate against the particles through its thickness."""

import matplotlib.pyplot as plt
import numpy as np

from plotting.case import table
from plotting.style import COLOURS, FAINT, WIDTH

MARKERS = "osD^v"


def draw(folder):
    data = table(folder / "periods.csv")
    spacings = data.pop("particles") - 1
    figure, axes = plt.subplots(figsize=(0.75 * WIDTH, 3.6))
    for k, (method, error) in enumerate(data.items()):
        axes.loglog(spacings, 100 * np.abs(error), marker=MARKERS[k], markersize=4.5, color=COLOURS[k], label=method)
    axes.loglog(spacings, 8 * (spacings[0] / spacings) ** 2, ":", color=FAINT)
    axes.text(spacings[1] * 1.05, 8 * (spacings[0] / spacings[1]) ** 2, "order 2", color=FAINT, fontsize=8)
    axes.set(title="First period of a clamped plate", xlabel="spacings through the thickness", ylabel="|error| [%]",
             ylim=(1e-3, 60))
    axes.set_xticks(spacings, [f"{n:.0f}" for n in spacings])
    axes.minorticks_off()
    axes.legend(loc="lower left", fontsize=7)
    return figure
