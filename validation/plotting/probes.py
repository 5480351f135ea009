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


EXACT = dict(color=INK, linewidth=0.8, dashes=(4, 2.5))


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


def exact_histories(path, demanded=None):
    """Those of the exact solution beside the file of probes; empty where there is none, if not demanded."""
    exact_path = path.with_name(path.stem + "_exact.csv")
    if demanded or (demanded is None and exact_path.exists()):
        return histories(exact_path)
    return None, {}


def paint(axes, quantity, probes, computed, exact):
    """The histories of a quantity on those axes; `computed` and `exact` are what histories() gives."""
    (time, series), (exact_time, exact_series) = computed, exact
    everything = np.concatenate([v for (p, q), v in series.items() if q == quantity and p in probes])
    scale, unit = prefix(everything, unit_of(quantity))
    t_scale, t_unit = time_axis(time)
    for k, probe in enumerate(probes):
        if (probe, quantity) in series:
            axes.plot(t_scale * time, scale * series[probe, quantity], color=COLOURS[k % len(COLOURS)])
        if (probe, quantity) in exact_series:
            axes.plot(t_scale * exact_time, scale * exact_series[probe, quantity], **EXACT, zorder=3)
    axes.set_ylabel(label(quantity, unit).replace(" $", "\n$", 1))
    axes.margins(x=0)
    return f"time $t$ [{t_unit}]"


def legend(axes, probes, exact, **place):
    """Names of the probes above those axes, or at that place."""
    place = place or dict(ncols=7, loc="lower left", bbox_to_anchor=(0, 1.0), borderaxespad=0.2, columnspacing=1.4)
    handles = [plt.Line2D([], [], color=COLOURS[k % len(COLOURS)], label=probe) for k, probe in enumerate(probes)]
    if exact:
        handles.append(plt.Line2D([], [], **EXACT, label="exact"))
    axes.legend(handles=handles, handlelength=1.8, **place)


def draw(options):
    path = options.directory / "probes.csv" if options.directory.is_dir() else options.directory
    computed = histories(path)
    series = computed[1]
    quantities = chosen(series, 1, options.quantity, path, "quantity")
    probes = chosen(series, 0, options.probe, path, "probe")
    recorded = [q for q in quantities if any((p, q) in series for p in probes)]
    if not recorded:
        raise PlotError(f"{path}: {', '.join(probes)} records none of {', '.join(quantities)}")
    quantities = recorded

    exact = exact_histories(path, options.exact)

    figure, panels = plt.subplots(len(quantities), 1, sharex=True, squeeze=False,
                                  figsize=(WIDTH, 0.5 + (2.6 if len(quantities) == 1 else 2.1) * len(quantities)))
    for axes, quantity in zip(panels[:, 0], quantities):
        time_label = paint(axes, quantity, probes, computed, exact)
    panels[-1, 0].set_xlabel(time_label)
    figure.align_ylabels(panels[:, 0])
    legend(panels[0, 0], probes, exact[1])
    return figure, path.with_suffix(".png")
