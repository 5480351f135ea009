"""Errors against the spacing on logarithmic axes, with fitted orders.

Reads convergence.csv (a header with spacing and a column an error, such as displacement, velocity,
stress; optionally particles, formulation and columns between that and the errors, which tell series
apart) or the same as JSON: a list of such rows, alone or under the key "rows". Several runs at one
spacing (column body.seed or body.cloud) are drawn as their median with a band from the best to the
worst. The order beside each line is the slope of a least-squares fit over all its points.
"""

import json
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from plotting.data import PlotError, listing, need, table
from plotting.style import COLOURS, INK, WIDTH, prefix, readable_log_axis

NOT_ERRORS = {"spacing", "particles", "points", "steps", "dt", "wall_seconds", "formulation", "end_time", "series",
              "sample"}
SAMPLES = {"body.seed", "body.cloud", "sample"}
MARKERS = "osD^v<>"


def arguments(command):
    command.add_argument("file", type=Path, metavar="FILE", help="convergence.csv or convergence.json")
    command.add_argument("--quantity", nargs="+", metavar="Q", help="only these errors")


def columns(path):
    if path.suffix.lower() != ".json":
        return table(path)
    try:
        content = json.loads(need(path).read_text())
    except ValueError as error:
        raise PlotError(f"{path}: not JSON ({error})") from None
    rows = content.get("rows") if isinstance(content, dict) else content
    if not isinstance(rows, list) or not rows or not all(isinstance(row, dict) for row in rows):
        raise PlotError(f"{path}: neither a list of rows nor an object with a list under rows")
    names = list(dict.fromkeys(name for row in rows for name in row))
    result = {}
    for name in names:
        cells = [row.get(name) for row in rows]
        if all(cell is None or isinstance(cell, (int, float)) for cell in cells):
            result[name] = np.array([np.nan if cell is None else float(cell) for cell in cells])
        else:
            result[name] = [str(cell) for cell in cells]
    return result


def errors(data, path, wanted):
    if "spacing" not in data:
        raise PlotError(f"{path}: no column spacing; it has: {listing(data)}")
    names = [name for name, values in data.items() if name not in NOT_ERRORS and not isinstance(values, list)
             and "." not in name and "order" not in name and np.any(values > 0.0)]
    for name in wanted or ():
        if name not in names:
            raise PlotError(f"{path}: no error {name}; it has: {listing(names)}")
    names = wanted or names
    if not names:
        raise PlotError(f"{path}: no column holds errors; it has: {listing(data)}")
    return names


def series(data):
    """What each row belongs to, for people: its formulation and the keys that are compared, 'mirror support 2.5'."""
    if "series" in data:
        return np.array(data["series"])
    names = list(data)
    rows = len(data["spacing"])
    labels = list(data["formulation"]) if isinstance(data.get("formulation"), list) else [""] * rows
    if "formulation" in data:
        for name in names[names.index("formulation") + 1:]:
            if "order_" + name in data:  # the errors begin
                break
            if name not in SAMPLES:
                word = name.rpartition(".")[2]
                cells = data[name] if isinstance(data[name], list) else [f"{value:g}" for value in data[name]]
                labels = [f"{label} {word} {cell}" for label, cell in zip(labels, cells)]
    return np.array(labels)


def median_and_range(h, e, failed, level):
    """(spacing, best, median, worst) by level, finest first; a failed run is worse than any, and drawn nowhere."""
    levels = []
    for here in (level == one for one in np.unique(level)):
        spacing = np.median(h[here])
        values = np.where(failed[here], np.inf, e[here])
        values = np.sort(values[values > 0.0])
        if len(values) and np.isfinite(median := np.median(values)):
            levels.append((spacing, values[0], median, values[-1]))
    return np.array(sorted(levels)).reshape(-1, 4).T


def slope_triangle(axes, h, e, order, colour):
    """Right triangle of that slope under the finest interval of a line, the order beside it."""
    x0, x1 = h[0] * (h[1] / h[0]) ** 0.2, h[0] * (h[1] / h[0]) ** 0.8
    y0 = e[0] * (x0 / h[0]) ** order / 1.35
    y1 = y0 * (x1 / x0) ** order
    axes.fill([x0, x1, x1], [y0, y0, y1], facecolor=colour, alpha=0.18, edgecolor=colour, linewidth=0.8)
    axes.annotate(f"{order:.2f}", xy=(x1, np.sqrt(y0 * y1)), xytext=(4, 0), textcoords="offset points", va="center",
                  fontsize=8, color=colour)


def draw(options):
    path = options.file
    data = columns(path)
    names = errors(data, path, options.quantity)
    groups = series(data)
    kinds = list(dict.fromkeys(groups))
    failure = data.get("failure")
    failed = np.array([bool(text) and text != "None" for text in failure]) if isinstance(failure, list) else np.zeros(
        len(groups), bool)
    levels = data["particles"] if "particles" in data else data["spacing"]  # clouds: one spacing but for round-off
    scale, unit = prefix(data["spacing"], "m")

    across = min(len(names), 3)
    down = -(-len(names) // across)
    figure, all_axes = plt.subplots(down, across, squeeze=False, figsize=(
        WIDTH if across > 1 else 0.6 * WIDTH, 3.4 if down == 1 else 2.9 * down))
    for axes in all_axes.flat[len(names):]:
        axes.set_visible(False)
    for axes, name in zip(all_axes.flat, names):
        for k, kind in enumerate(kinds):
            mine = groups == kind
            h, best, e, worst = median_and_range(scale * data["spacing"][mine], data[name][mine], failed[mine],
                                                 levels[mine])
            if not len(h):
                continue
            colour = COLOURS[k % len(COLOURS)]
            axes.loglog(h, e, marker=MARKERS[k % len(MARKERS)], markersize=5, color=colour, label=kind)
            if np.any(worst > best):
                axes.fill_between(h, best, np.where(np.isfinite(worst), worst, e), color=colour, alpha=0.2, linewidth=0)
            if len(h) > 1:
                slope_triangle(axes, h, e, np.polyfit(np.log(h), np.log(e), 1)[0], colour)
        axes.set_title(f"{name.replace('_', ' ')}", loc="left")
        axes.set_xlabel(f"spacing $\\Delta$ [{unit}]")
        axes.grid(True, which="minor", linewidth=0.3)
        axes.margins(x=0.12, y=0.12)
        plain_ticks(axes, scale * data["spacing"])
        readable_log_axis(axes.yaxis, data[name])
    for axes in all_axes[:, 0]:
        axes.set_ylabel("relative error" + (", median and range" if SAMPLES & set(data) else ""))
    if len(kinds) > 1:
        # Wider than its axes: kept out of the layout, which it would stretch; a blank line above the titles holds
        # its place.
        first = all_axes[0, 0]
        first.set_title(" \n" * -(-len(kinds) // 4) + first.get_title(loc="left"), loc="left")
        first.legend(ncols=min(len(kinds), 4), loc="lower left", bbox_to_anchor=(0, 1.07),
                     borderaxespad=0.2).set_in_layout(False)
    return figure, path.with_suffix(".png")


def plain_ticks(axes, spacings):
    """The spacings themselves as ticks, thinned where they would touch."""
    ticks = []
    for h in sorted(set(spacings)):
        if not ticks or h / ticks[-1] > 1.25:
            ticks.append(h)
    axes.set_xticks(ticks, [f"{h:.3g}" for h in ticks], color=INK)
    axes.set_xticks([], minor=True)
