"""Energy of a run: kinetic, elastic, work of the loads, dissipated, and the drift of their balance.

Reads /series of DIR/run.h5. The balance is kinetic + elastic + dissipated − work of the loads, whose
change since the start is drawn as a share of the largest energy.
"""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from plotting.data import PlotError, as_table, dataset, listing, open_h5, run_file
from plotting.style import COLOURS, INK, WIDTH, prefix, significant, time_axis

#  dataset: label, sign in the balance, colour
PARTS = {
    "kinetic": ("kinetic", 1, COLOURS[0]),
    "elastic": ("elastic", 1, COLOURS[1]),
    "external_work": ("work of the loads", -1, COLOURS[2]),
    "dissipated": ("dissipated", 1, COLOURS[3]),
}


def arguments(command):
    command.add_argument("directory", type=Path, metavar="DIR", help="output of a run, or its run.h5")


def draw(options):
    path = run_file(options.directory)
    with open_h5(path) as file:
        # A body of d < 3 dimensions holds energy per unit of what is left: area on a line, thickness in a plane.
        joule = {1: "J/m²", 2: "J/m", 3: "J"}[as_table(dataset(file, "particles/X")).shape[1]]
        time = dataset(file, "series/time")
        series = {name: dataset(file, f"series/{name}") for name in PARTS if f"series/{name}" in file}
        there = listing(file["series"].keys())
    missing = {"kinetic", "elastic"} - series.keys()
    if missing:
        raise PlotError(f"{path}: /series lacks {listing(missing)}; it has: {there}")
    if len(time) < 2:
        raise PlotError(f"{path}: /series has {len(time)} rows, a history needs two")

    balance = sum(PARTS[name][1] * values for name, values in series.items())
    scale, unit = prefix(np.concatenate(list(series.values())), joule)
    t_scale, t_unit = time_axis(time)
    largest = max(np.max(np.abs(values)) for values in series.values()) or 1.0
    drift = (balance - balance[0]) / largest

    figure, (top, bottom) = plt.subplots(2, 1, sharex=True, figsize=(WIDTH, 4.4), height_ratios=[2.6, 1])
    for name, values in series.items():
        if np.any(values != 0.0):
            text, _, colour = PARTS[name]
            top.plot(t_scale * time, scale * values, color=colour, label=text)
    top.plot(t_scale * time, scale * (series["kinetic"] + series["elastic"]), color=INK, linewidth=0.9,
             dashes=(4, 2.5), label="kinetic + elastic")
    top.set_ylabel(f"energy [{unit}]")
    top.legend(ncols=5, loc="lower left", bbox_to_anchor=(0, 1.0), borderaxespad=0.2, handlelength=1.8)
    bottom.axhline(0.0, color=INK, linewidth=0.6)
    bottom.plot(t_scale * time, drift, color=INK, linewidth=1.0)
    bottom.set_ylabel("drift of the balance\n/ largest energy")
    bottom.ticklabel_format(axis="y", scilimits=(-2, 2), useMathText=True)
    bottom.set_title(f"largest {significant(np.max(np.abs(drift)), 2)}", loc="right", fontsize=8, pad=3)
    bottom.set_xlabel(f"time $t$ [{t_unit}]")
    top.margins(x=0)
    bottom.margins(x=0)
    figure.align_ylabels([top, bottom])
    return figure, path.with_name("energy.png")
