"""A field over place and time, for bodies of one dimension: waves are slanted lines.

Reads DIR/run.h5; output.frames of the scene says how fine it is in time.
"""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from plotting.data import PlotError, run_file
from plotting.frames import colouring
from plotting.run import Run
from plotting.style import WIDTH, label, prefix, time_axis, unit_of


def arguments(command):
    command.add_argument("directory", type=Path, metavar="DIR", help="output of a run, or its run.h5")
    command.add_argument("--field", default="pk1_xx", metavar="FIELD", help="default: pk1_xx")
    command.add_argument("--colours", metavar="MAP", help="a matplotlib colour map")


def paint(axes, run, field, map_name=None):
    """The field on those axes, with labels; gives the picture back, and the unit of its values."""
    if run.dimension != 1:
        raise PlotError(f"{run.path}: a body of {run.dimension} dimensions; place and time make a picture for one only")
    if len(run.times) < 2:
        raise PlotError(f"{run.path}: {len(run.times)} frames, a picture over time needs two")
    X, values = run.field(field, range(len(run.times)))
    order = np.argsort(X[:, 0])
    scale, unit = prefix(values, unit_of(field))
    colours, limits = colouring(scale * values, map_name)
    x_scale, x_unit = prefix(run.nodes[:, 0], "m")
    t_scale, t_unit = time_axis(run.times)
    picture = axes.pcolormesh(x_scale * X[order, 0], t_scale * run.times, scale * values[:, order], shading="gouraud",
                              cmap=colours, norm=limits, rasterized=True)
    axes.set(xlabel=f"reference position $X$ [{x_unit}]", ylabel=f"time $t$ [{t_unit}]",
             xlim=x_scale * np.array([run.nodes.min(), run.nodes.max()]))
    axes.grid(False)
    return picture, unit


def draw(options):
    path = run_file(options.directory)
    figure, axes = plt.subplots(figsize=(0.75 * WIDTH, 3.8))
    with Run(path) as run:
        picture, unit = paint(axes, run, options.field, options.colours)
    bar = figure.colorbar(picture, pad=0.02, aspect=28)
    bar.set_label(label(options.field, unit))
    bar.outline.set_visible(False)
    return figure, path.with_name(f"{options.field}_space_time.png")
