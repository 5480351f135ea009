"""Speed against accuracy on logarithmic axes, the front of the best marked and labelled.

Reads chart.json of `tlsph chart`: a point a configuration, its stepping time (the bar is the range of
the repetitions) and the relative error it is judged by, a panel a quantity. Numbers on the front are explained below.
"""

import json
import textwrap
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.transforms import ScaledTranslation

from plotting.data import PlotError, listing, need
from plotting.style import COLOURS, FAINT, INK, WIDTH

#  formulation: colour, marker
FORMULATIONS = {"stress-point": (COLOURS[0], "o"), "consistent": (COLOURS[2], "s"), "variational": (COLOURS[1], "^"),
                "mirror": (COLOURS[3], "D"), "thesis": (COLOURS[4], "v")}
PEER_MARKERS = "XP*hdp<>8H"
LIST_SIZE = 6.2  # points, of the names below a panel
LINE_HEIGHT = 1.2 * LIST_SIZE / 72  # inches
LIST_WIDTH = 132  # characters of the list in the width of the figure, over its panels
LEGEND_WIDTH = 116  # the same of the legend, a marker and its space counting as MARKER_WIDTH
MARKER_WIDTH = 4.5


def arguments(command):
    command.add_argument("file", type=Path, metavar="FILE", help="chart.json")
    command.add_argument("--quantity", nargs="+", metavar="Q", help="only these errors")


def read(path):
    try:
        table = json.loads(need(path).read_text())
        points = [point for point in table["points"] if not point["failure"]]
        for point in points:
            point["time"] = float(np.median(point["stepping_seconds"]))
            point["errors"] = [np.nan if error is None else error for error in point["judged"]]
        return table["quantities"], points
    except (ValueError, KeyError, TypeError) as error:
        raise PlotError(f"{path}: not a chart.json of tlsph chart ({error!r})") from None


def short(point):
    """The configuration in the words of its table, its particles behind it."""
    return f"{point['peer'] or point['family']}, {point['particles']}"


def scatter(axes, points, q, colour, marker, label, filled):
    t = np.array([point["time"] for point in points])
    e = np.array([point["errors"][q] for point in points])
    axes.scatter(t, e, s=16 if filled else 12, marker=marker, facecolor=colour if filled else "none", edgecolor=colour,
                 linewidth=0.7, alpha=1.0 if filled else 0.35, label=label, zorder=3 if filled else 2)


def ranges(axes, points, q):
    for point in points:
        if len(point["stepping_seconds"]) > 1:
            axes.plot([min(point["stepping_seconds"]), max(point["stepping_seconds"])], 2 * [point["errors"][q]],
                      color=INK, linewidth=0.8, zorder=2.5)


def draw(options):
    path = options.file
    quantities, points = read(path)
    wanted = options.quantity or quantities
    for name in wanted:
        if name not in quantities:
            raise PlotError(f"{path}: no error {name}; it has: {listing(quantities)}")
    across = min(len(wanted), 3)
    down = -(-len(wanted) // across)
    figure, all_axes = plt.subplots(down, across, squeeze=False)
    for axes in all_axes.flat[len(wanted):]:
        axes.set_visible(False)
    width = int(LIST_WIDTH / across if across > 1 else 0.75 * LIST_WIDTH)
    lines = max(panel(axes, quantities.index(name), name, points, width) for axes, name in zip(all_axes.flat, wanted))
    figure.set_size_inches(WIDTH if across > 1 else 0.75 * WIDTH, (3.7 + lines * LINE_HEIGHT) * down)
    for axes in all_axes[:, 0]:
        axes.set_ylabel("relative error")
    first = all_axes[0, 0]
    handles, labels = first.get_legend_handles_labels()
    if len(labels) > 1:
        # Wider than its axes: kept out of the layout, which it would stretch; blank lines above the titles hold its
        # place, 15 points above the axes.
        columns = legend_columns(labels, LEGEND_WIDTH if across > 1 else 0.75 * LEGEND_WIDTH)
        first.set_title(" \n" * -(-len(labels) // columns) + first.get_title(loc="left"), loc="left")
        above = first.transAxes + ScaledTranslation(0, 15 / 72, figure.dpi_scale_trans)
        first.legend(handles, labels, ncols=columns, loc="lower left", bbox_to_anchor=(-0.05, 1.0),
                     bbox_transform=above, borderaxespad=0, borderpad=0, labelspacing=0.15, columnspacing=0.9,
                     handletextpad=0.2, handlelength=1.2).set_in_layout(False)
    return figure, path.with_suffix(".png")


def legend_columns(labels, width):
    """As many as fit; each is filled downwards and as wide as the longest label in it."""
    for columns in range(min(8, len(labels)), 1, -1):
        full, more = divmod(len(labels), columns)
        ends = np.cumsum([full + 1] * more + [full] * (columns - more))
        parts = np.split(np.array([len(label) for label in labels]), ends[:-1])
        if sum(part.max() + MARKER_WIDTH for part in parts) <= width:
            return columns
    return 1


def panel(axes, q, name, points, width):
    points = [point for point in points if np.isfinite(point["errors"][q]) and point["errors"][q] > 0]
    own = [point for point in points if not point["peer"]]
    for formulation, (colour, marker) in FORMULATIONS.items():
        mine = [point for point in own if point["formulation"] == formulation]
        if mine:
            front = [point for point in mine if name in point["front"]]
            scatter(axes, [point for point in mine if name not in point["front"]], q, colour, marker, None, False)
            scatter(axes, front, q, colour, marker, formulation, True)
    peers = list(dict.fromkeys(point["peer"] for point in points if point["peer"]))
    for k, peer in enumerate(peers):
        mine = sorted((point for point in points if point["peer"] == peer), key=lambda point: point["time"])
        axes.plot([point["time"] for point in mine], [point["errors"][q] for point in mine], color=INK, linewidth=0.8,
                  linestyle=":", zorder=1.5)
        scatter(axes, mine, q, INK, PEER_MARKERS[k % len(PEER_MARKERS)], peer, True)
    front = sorted((point for point in points if name in point["front"]), key=lambda point: point["time"])
    axes.plot([point["time"] for point in front], [point["errors"][q] for point in front], color=FAINT, linewidth=1.0,
              label="front", zorder=1)
    ranges(axes, front, q)
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_title(name, loc="left")
    axes.set_xlabel("stepping time [s]")
    axes.margins(x=0.12, y=0.12)
    return explain(axes, q, front, width)


def explain(axes, q, front, width):
    """Numbers at the points of the front, thinned where they would touch, and their names in lines below the panel,
    broken at `width` characters; how many lines these are. Below and left of a front there is nothing; a point that has another one close to its
    left carries its number on the other side."""
    number, lines, last = 0, [], None
    for point in front:
        here = np.log10([point["time"], point["errors"][q]])
        across, along = (np.inf, np.inf) if last is None else np.abs(here - last)
        if np.hypot(across, along) < 0.15 and point is not front[-1]:
            continue
        beside = across < 0.9 and along < 0.25
        last = here
        number += 1
        lines += textwrap.wrap(f"{number}  {short(point)}", width, subsequent_indent="      ")
        axes.annotate(f"{number}", xy=(point["time"], point["errors"][q]),
                      xytext=(4, 3) if beside else (-3, -3), textcoords="offset points", fontsize=7, color=INK,
                      ha="left" if beside else "right", va="bottom" if beside else "top")
    # Below the ticks and the label of the axis, whatever the height of the panel.
    axes.annotate("\n".join(lines), xy=(0.0, 0.0), xycoords="axes fraction", xytext=(0, -38),
                  textcoords="offset points", fontsize=LIST_SIZE, va="top", color=INK)
    return len(lines)
