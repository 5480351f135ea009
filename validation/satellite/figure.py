"""The satellite at four times, and its momenta over all steps."""

import matplotlib.pyplot as plt
import numpy as np
import h5py
from matplotlib.collections import PolyCollection

from plotting.style import COLOURS, WIDTH

TIMES = [0.0, 4.0, 12.0, 20.0]


def snapshots(axes, folder):
    with h5py.File(folder / "frames" / "run.h5") as file:
        X, cells, time = file["particles/X"][:], file["points/cells"][:], file["frames/time"][:]
        frames = [int(np.argmin(abs(time - t))) for t in TIMES]
        pressure = file["frames/pressure"][:] / 1e3
        top = np.percentile(abs(pressure[frames]), 99.5)
        for panel, k in zip(axes, frames):
            x = X + file["frames/displacement"][k]
            picture = PolyCollection(x[cells], array=pressure[k].ravel(), cmap="RdBu_r", edgecolor="face", linewidth=0.2)
            picture.set_clim(-top, top)
            panel.add_collection(picture)
            panel.set(xlim=(-9, 9), ylim=(-9, 9), aspect="equal", xticks=[], yticks=[])
            panel.set_title(f"t = {time[k]:.0f} s")
            panel.grid(False)
            for spine in panel.spines.values():
                spine.set_visible(False)
    return picture


def momenta(panel, folder):
    for formulation, colour in (("stress-point", COLOURS[0]), ("variational", COLOURS[1])):
        with h5py.File(folder / formulation / "run.h5") as file:
            series = file["series"]
            time, angular = series["time"][:], series["angular_momentum"][:]
            panel.semilogy(time[1:], np.maximum.accumulate(abs(angular[1:] / angular[0] - 1)), color=colour,
                           label=formulation)
    panel.set(xlabel="time t [s]", ylabel="largest change of the\nangular momentum so far", ylim=(1e-16, 1e-10))
    panel.axhline(1e-11, color="k", lw=0.8, ls="--")
    panel.text(panel.get_xlim()[1], 1.3e-11, "limit of the check", ha="right", va="bottom", fontsize=8)
    panel.legend(loc="center right", ncols=2)


def draw(folder):
    figure = plt.figure(figsize=(WIDTH * 1.25, 4.6))
    grid = figure.add_gridspec(2, 4, height_ratios=[1.25, 1])
    top = [figure.add_subplot(grid[0, k]) for k in range(4)]
    picture = snapshots(top, folder)
    bar = figure.colorbar(picture, ax=top, aspect=18, pad=0.01)
    bar.set_label("pressure p [kPa]")
    bar.outline.set_visible(False)
    momenta(figure.add_subplot(grid[1, :]), folder)
    return figure
