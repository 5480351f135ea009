"""Snapshots of one field in the deformed configuration (lines over X in one dimension).

Reads DIR/run.h5. A field is a component of a recorded array, such as pk1_xx, displacement_x or
velocity_y, its magnitude (velocity_magnitude), a recorded scalar, or what follows from the recorded
ones: cauchy_xx from pk1 and deformation_gradient.
"""

from pathlib import Path

import matplotlib
import matplotlib.pyplot as plt
import numpy as np

from plotting.cells import Cells
from plotting.data import PlotError, run_file
from plotting.run import Run
from plotting.style import WIDTH, heading, label, prefix, significant, split_quantity, time_axis, unit_of
from plotting.tiles import Tiles
from plotting.triangles import Triangles


TWO_SIDED = 0.2  # of the largest value: what the other sign must reach for colours on both sides of zero
TRAVELS = 2.0  # times the size of the body: where the places of all frames reach farther, each panel follows the body


def arguments(command):
    command.add_argument("directory", type=Path, metavar="DIR", help="output of a run, or its run.h5")
    command.add_argument("--field", nargs="+", metavar="FIELD",
                         help="default: displacement_x and pk1_xx in one dimension, pk1_xx in two (one only there)")
    command.add_argument("--times", nargs="+", type=float, metavar="T", help="the frames nearest to these times [s]")
    command.add_argument("--scale", default="1", metavar="S",
                         help="factor on the displacements of the picture, or auto for one that shows them")
    command.add_argument("--mirror", default="", choices=("x", "y", "xy"), metavar="AXES",
                         help="show also the images of a body modelled in part: x mirrors left and right, y top and "
                              "bottom, xy both")
    command.add_argument("--colours", metavar="MAP", help="a matplotlib colour map")


def pick_frames(times, wanted, path, count, bare_start=False):
    """Rows of `count` frames evenly over the run, without the first if nothing is to be seen there."""
    if len(times) == 0:
        raise PlotError(f"{path}: no frames")
    if wanted is None:
        first = 1 if bare_start and len(times) > 1 else 0
        return sorted(set(np.linspace(0, len(times) - 1, count + first)[first:].round().astype(int)))
    slack = 0.5 * np.max(np.diff(times), initial=0.0)
    for t in wanted:
        if not times[0] - slack <= t <= times[-1] + slack:
            raise PlotError(f"--times: {t:g} s lies outside the frames of {path}, {times[0]:g} to {times[-1]:g} s")
    return list(dict.fromkeys(int(np.argmin(np.abs(times - t))) for t in wanted))


def starts_bare(run, fields):
    """Whether every field is the same everywhere in the first frame, rounding apart."""
    def bare(field):
        values = run.field(field, [0, len(run.times) // 2, len(run.times) - 1])[1]
        return np.ptp(values[0]) <= 1e-9 * np.ptp(values)
    return len(run.times) > 0 and all(bare(field) for field in fields)


def clock(seconds, scale, unit):
    return f"$t$ = {significant(scale * seconds)} {unit}"


def draw(options):
    path = run_file(options.directory)
    with Run(path) as run:
        if run.dimension == 1:
            figure = draw_lines(run, options)
        else:
            figure = draw_bodies(run, options)
    name = "_".join(options.field) if options.field else "frames"
    return figure, path.with_name(f"{name}.png")


def draw_lines(run, options):
    fields = options.field or ["displacement_x", "pk1_xx"]
    frames = pick_frames(run.times, options.times, run.path, 6, starts_bare(run, fields))
    t_scale, t_unit = time_axis(run.times[frames])
    x_scale, x_unit = prefix(run.nodes[:, 0], "m")
    colours = matplotlib.colormaps["viridis"](np.linspace(0.0, 0.9, len(frames)))
    figure, panels = plt.subplots(len(fields), 1, sharex=True, squeeze=False, figsize=(WIDTH, 0.6 + 2.3 * len(fields)))
    for axes, field in zip(panels[:, 0], fields):
        X, values = run.field(field, frames)
        order = np.argsort(X[:, 0])
        scale, unit = prefix(values, unit_of(field))
        for k, frame in enumerate(frames):
            axes.plot(x_scale * X[order, 0], scale * values[k][order], color=colours[k],
                      label=clock(run.times[frame], t_scale, t_unit))
        axes.set_ylabel(label(field, unit).replace(" $", "\n$", 1))
        axes.margins(x=0)
    panels[-1, 0].set_xlabel(f"reference position $X$ [{x_unit}]")
    lines = -(-len(frames) // 6)
    panels[0, 0].legend(ncols=-(-len(frames) // lines), loc="lower left", bbox_to_anchor=(0, 1.0), borderaxespad=0.2,
                        handlelength=1.3, columnspacing=1.2)
    figure.align_ylabels(panels[:, 0])
    return figure


def magnification(text, displacement, size):
    """The factor asked for; auto makes the largest displacement about 8 % of the body, and never shrinks."""
    if text != "auto":
        try:
            return float(text)
        except ValueError:
            raise PlotError(f"--scale: {text} is neither a number nor auto") from None
    largest = np.max(np.linalg.norm(displacement, axis=-1), initial=0.0)
    if largest == 0.0 or 0.08 * size / largest <= 1.5:
        return 1.0
    exact = 0.08 * size / largest
    decade = 10.0 ** np.floor(np.log10(exact))
    return decade * max(step for step in (1, 2, 5) if step * decade <= exact)


def colouring(values, name):
    """Colour map and limits: symmetric about zero for fields of both signs, if neither is a mere trace."""
    low, high = float(np.nanmin(values)), float(np.nanmax(values))
    signed = low < 0.0 < high and min(-low, high) > TWO_SIDED * max(-low, high)
    if signed:
        high = max(-low, high)
        low = -high
    if high == low:
        high, low = high + 0.5, low - 0.5
    # From dark at nothing to bright at the most, also where that is negative.
    return name or ("RdBu_r" if signed else "viridis_r" if -low > high else "viridis"), matplotlib.colors.Normalize(low, high)


def grid_shape(count, width, height):
    """Rows and columns that show bodies of that size large and leave few gaps, rather wide than high."""
    best = None
    for columns in range(count, 0, -1):
        rows = -(-count // columns)
        merit = min(WIDTH / columns / width, 6.0 / rows / height) * count / (rows * columns)
        if best is None or merit > 1.05 * best[0]:
            best = (merit, rows, columns)
    return best[1:]


def trim(figure, panels):
    """Take away what panels of equal aspect leave unused, first of the height, then of the width."""
    for direction, count in (("height", len(panels)), ("width", len(panels[0])), ("height", len(panels))):
        figure.canvas.draw()
        given, used = (getattr(panels[0, 0].get_position(original=o), direction) for o in (True, False))
        size = getattr(figure, f"get_fig{direction}")()
        getattr(figure, f"set_fig{direction}")(size * (1 - count * (given - used)))


def shape_of(run, X):
    """What paints a field with values at X, run.nodes or run.points."""
    if run.cells is not None:
        return Cells(run.nodes, run.cells, at_nodes=X is run.nodes)
    at_nodes = X is run.nodes or len(run.points) == len(run.nodes)
    if run.triangles is not None and (at_nodes or run.edges is not None):
        return Triangles(run.nodes, run.triangles, None if at_nodes else run.edges)
    return Tiles(X, run.nodes, run.volumes)


def images(mirror):
    """Factors on the coordinates that make the body and its mirror images."""
    return [np.array([x, y]) for x in ((1, -1) if "x" in mirror else (1,))
            for y in ((1, -1) if "y" in mirror else (1,))]


def parity(field, image):
    """±1: what the mirror does to a component; invariants stay as they are."""
    suffix = split_quantity(field)[1]
    return np.prod([image["xy".index(axis)] for axis in suffix]) if set(suffix) <= set("xy") else 1


def paint(axes, shape, body, x_scale, mirrors, field, values, colours, limits):
    """The deformed body and its images on those axes."""
    for image in mirrors:
        polygons = [x_scale * polygon * image for polygon in body]
        shape.paint(axes, np.array(polygons) if isinstance(body, np.ndarray) else polygons,
                    parity(field, image) * values, colours, limits)


def windows(bodies, mirrors):
    """Lower and upper corners of the panels [frame, axis]: one box around all bodies (corners of their tiles
    [corner, axis]) and their images, or, where that would be mostly empty, boxes of one size around each."""
    corners = [np.concatenate([body * image for image in mirrors]) for body in bodies]
    low, high = np.array([c.min(axis=0) for c in corners]), np.array([c.max(axis=0) for c in corners])
    size = np.max(high - low, axis=0)
    if np.any(np.ptp(0.5 * (low + high), axis=0) > (TRAVELS - 1.0) * size):
        middle = 0.5 * (low + high)
        low, high = middle - 0.5 * size, middle + 0.5 * size
    else:
        low, high = np.tile(low.min(axis=0), (len(low), 1)), np.tile(high.max(axis=0), (len(high), 1))
    margin = 0.02 * np.max(high - low)
    return low - margin, high + margin


def draw_bodies(run, options):
    if options.field and len(options.field) > 1:
        raise PlotError("--field: one field a figure in two dimensions")
    field = options.field[0] if options.field else "pk1_xx"
    frames = pick_frames(run.times, options.times, run.path, 4, starts_bare(run, [field]))
    X, values = run.field(field, frames)
    scale, unit = prefix(values, unit_of(field))
    u = run.displacement(frames)
    factor = magnification(options.scale, u, np.max(np.ptp(run.nodes, axis=0)))
    shape = shape_of(run, X)
    bodies = [shape.moved(factor * displacement) for displacement in u]
    mirrors = images(options.mirror)
    signed = np.concatenate([parity(field, image) * values for image in mirrors]) * scale
    map_name, limits = colouring(signed, options.colours)

    x_scale, x_unit = prefix(np.ptp(run.nodes, axis=0), "m")
    low, high = windows([x_scale * np.concatenate(list(body)) for body in bodies], mirrors)
    travels = np.any(low != low[0])
    width, height = high[0] - low[0]
    rows, columns = grid_shape(len(frames), width, height)
    panel = min((WIDTH - 1.2) / columns, 7.0 / rows * width / height)
    figure, panels = plt.subplots(rows, columns, squeeze=False, sharex=not travels, sharey=not travels, figsize=(
        columns * panel + 1.3, rows * (panel * height / width + 0.28) + 0.6))
    t_scale, t_unit = time_axis(run.times[frames])
    for k, axes in enumerate(panels.flat):
        if k >= len(frames):
            axes.set_visible(False)
            continue
        paint(axes, shape, bodies[k], x_scale, mirrors, field, scale * values[k], map_name, limits)
        axes.set(xlim=(low[k, 0], high[k, 0]), ylim=(low[k, 1], high[k, 1]), aspect="equal")
        axes.set_title(clock(run.times[frames[k]], t_scale, t_unit), loc="left")
        axes.grid(False)
    figure.supxlabel(f"$x$ [{x_unit}]" + (f"     displacements × {factor:g}" if factor != 1.0 else ""), fontsize=9)
    figure.supylabel(f"$y$ [{x_unit}]", fontsize=9)
    wide = rows == 1 and columns * width > 2.5 * height
    bar = figure.colorbar(matplotlib.cm.ScalarMappable(limits, map_name), ax=panels, pad=0.02,
                          **(dict(location="top", shrink=0.6, aspect=40) if wide else dict(aspect=28)))
    bar.set_label(label(field, unit))
    bar.outline.set_visible(False)
    heading(figure, options.title)
    trim(figure, panels)
    return figure
