"""Histories at the probes: a panel a quantity, every probe in it.

Reads DIR/probes.csv, whose header is time,<probe>.<quantity>,…; the exact histories of
DIR/probes_exact.csv (the same header) are laid over them in dashes.
"""

from argparse import BooleanOptionalAction
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from plotting.data import PlotError, listing, table
from plotting.style import COLOURS, INK, WIDTH, label, prefix, time_axis, unit_of


def arguments(command):
    command.add_argument("directory", type=Path, metavar="DIR", help="output of a run, or a CSV file of probes")
    command.add_argument("--exact", action=BooleanOptionalAction,
                         help="demand the exact histories, or leave them out; without it they are drawn if present")
    command.add_argument("--quantity", nargs="+", metavar="Q", help="only these, such as cauchy_xx")
    command.add_argument("--probe", nargs="+", metavar="NAME", help="only these")


def histories(path):
    """Time and {(probe, quantity): values}."""
    columns = table(path)
    if "time" not in columns:
        raise PlotError(f"{path}: no column time; it has: {listing(columns)}")
    time = columns.pop("time")
    bad = [name for name, values in columns.items() if "." not in name or isinstance(values, list)]
    if bad:
        raise PlotError(f"{path}: column {bad[0]} is not <probe>.<quantity> with numbers")
    return time, {tuple(name.rsplit(".", 1)): values for name, values in columns.items()}


def chosen(series, position, wanted, path, noun):
    """The names at that position of the keys, in order of appearance, cut down to the wanted ones."""
    names = list(dict.fromkeys(key[position] for key in series))
    for name in wanted or ():
        if name not in names:
            raise PlotError(f"{path}: no {noun} {name}; it has: {listing(names)}")
    return [name for name in names if not wanted or name in wanted]


def draw(options):
    path = options.directory / "probes.csv" if options.directory.is_dir() else options.directory
    time, series = histories(path)
    quantities = chosen(series, 1, options.quantity, path, "quantity")
    probes = chosen(series, 0, options.probe, path, "probe")

    exact_path = path.with_name(path.stem + "_exact.csv")
    exact_time, exact = None, {}
    if options.exact or (options.exact is None and exact_path.exists()):
        exact_time, exact = histories(exact_path)

    t_scale, t_unit = time_axis(time)
    figure, panels = plt.subplots(len(quantities), 1, sharex=True, squeeze=False,
                                  figsize=(WIDTH, 0.5 + (2.6 if len(quantities) == 1 else 2.1) * len(quantities)))
    for axes, quantity in zip(panels[:, 0], quantities):
        everything = np.concatenate([v for (p, q), v in series.items() if q == quantity and p in probes])
        scale, unit = prefix(everything, unit_of(quantity))
        for k, probe in enumerate(probes):
            colour = COLOURS[k % len(COLOURS)]
            if (probe, quantity) in series:
                axes.plot(t_scale * time, scale * series[probe, quantity], color=colour)
            if (probe, quantity) in exact:
                axes.plot(t_scale * exact_time, scale * exact[probe, quantity], color=INK, linewidth=0.8,
                          dashes=(4, 2.5), zorder=3)
        axes.set_ylabel(label(quantity, unit).replace(" $", "\n$", 1))
        axes.margins(x=0)
    panels[-1, 0].set_xlabel(f"time $t$ [{t_unit}]")
    figure.align_ylabels(panels[:, 0])

    handles = [plt.Line2D([], [], color=COLOURS[k % len(COLOURS)], label=probe) for k, probe in enumerate(probes)]
    if exact:
        handles.append(plt.Line2D([], [], color=INK, linewidth=0.8, dashes=(4, 2.5), label="exact"))
    panels[0, 0].legend(handles=handles, ncols=min(len(handles), 7), loc="lower left", bbox_to_anchor=(0, 1.0),
                        borderaxespad=0.2, handlelength=1.8, columnspacing=1.4)
    return figure, path.with_suffix(".png")
