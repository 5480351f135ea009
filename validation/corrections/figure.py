"""What the corrections leave of (41), and what pairs of operators lose of both momenta."""

import matplotlib.pyplot as plt
import numpy as np

from plotting.case import table
from plotting.style import COLOURS, WIDTH, prefix

OPERATORS = ["none (40)", "gradient (42)", "linear kernel (47)", "constant kernel (53)", "mixed (54)",
             "(57) as printed", "least squares"]
PAIRS = [  # correction of G, with D = −GᵀV if no other is named; colour, dashes
    ("gradient", COLOURS[0], "-"),
    ("mixed", COLOURS[2], "--"),
    ("least squares", COLOURS[5], ":"),
    ("none", COLOURS[4], "-"),
    (r"$G$ gradient, $D$ of none", COLOURS[3], "-"),
    (r"$G$ mixed, $D=VX$", COLOURS[1], "-"),
]


def draw(folder):
    cloud, residuals = table(folder / "cloud.csv"), table(folder / "residuals.csv")
    figure = plt.figure(figsize=(0.86 * WIDTH, 4.1))
    upper, lower = figure.add_gridspec(2, 1)
    place, bars = upper.subgridspec(1, 2, width_ratios=[0.9, 1]).subplots()
    linear, angular = lower.subgridspec(1, 2).subplots(sharey=True)

    picture = place.scatter(cloud["x"], cloud["y"], c=cloud["residual"], s=2.5, cmap="cividis", linewidths=0, vmin=0,
                            antialiased=False, rasterized=True)
    place.set(aspect="equal", xlabel="$X$ [m]", ylabel="$Y$ [m]", xticks=[-1, 0, 1], yticks=[-1, 0, 1],
              title="Residual of (41) without correction")
    place.grid(False)
    bar = figure.colorbar(picture, ax=place, pad=0.02)
    bar.outline.set_visible(False)

    rows = np.arange(len(OPERATORS))
    for name, shift, colour in (("constant", -0.19, COLOURS[5]), ("linear", 0.19, COLOURS[0])):
        label = r"$\Delta\,|\nabla 1|$" if name == "constant" else r"$|\nabla X - I|$"
        bars.barh(rows + shift, np.maximum(residuals[name], 1e-17), height=0.36, left=1e-17, color=colour,
                  label=label)
    bars.set(xscale="log", xlim=(1e-17, 1e3), yticks=rows, yticklabels=OPERATORS,
             title="Constants and linear fields")
    bars.set_xticks([1e-16, 1e-12, 1e-8, 1e-4, 1])
    bars.invert_yaxis()
    bars.grid(axis="y", visible=False)
    bars.legend(loc="center right", bbox_to_anchor=(0.86, 0.64), fontsize=7)

    for k, (name, colour, dashes) in enumerate(PAIRS):
        pair = table(folder / f"pair{k}.csv")
        scale, unit = prefix(pair["time"], "s")
        for panel, which in ((linear, "linear"), (angular, "angular")):
            panel.semilogy(scale * pair["time"], np.maximum(pair[which], 1e-17), color=colour,
                           linestyle=dashes, linewidth=1.1, label=name)
    for panel, which in ((linear, "Linear"), (angular, "Angular")):
        panel.set(xlabel=f"time $t$ [{unit}]", ylim=(1e-17, 10), title=f"{which} momentum")
    linear.set_ylabel("lost, of its scale")
    linear.legend(loc="center left", bbox_to_anchor=(0.05, 0.56), fontsize=6.5, ncols=2, columnspacing=1.0,
                  handlelength=1.8)
    return figure
