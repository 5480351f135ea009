"""Sparsity pattern and spectrum of an operator.

Takes a Matrix Market file, or a group of an HDF5 file of operators as FILE.h5:GROUP. The spectrum is
that of the eigenvalues of a square operator, in the complex plane or sorted if they are real, and of
the singular values of a rectangular one.
"""

from pathlib import Path

import matplotlib
import matplotlib.pyplot as plt
import numpy as np
import scipy.io
import scipy.linalg
import scipy.sparse as sp

from mpl_toolkits.axes_grid1 import make_axes_locatable

from plotting.data import PlotError, dataset, listing, need, open_h5
from plotting.style import COLOURS, FAINT, WIDTH, readable_log_axis, scientific, significant

DENSE_ROWS = 3000
ROUNDING = 1e-12  # of the largest: below it a value counts as zero


def arguments(command):
    command.add_argument("file", metavar="FILE", help="operator.mtx, or operators.h5:G_x")


def groups(file):
    """Paths of the groups of an HDF5 file that hold a compressed sparse matrix."""
    found = []
    file.visititems(lambda name, item: found.append(name) if hasattr(item, "keys") and "indptr" in item else None)
    return found


def load(text):
    """The matrix as compressed rows, and its name."""
    path, _, group = text.rpartition(":") if ".h5:" in text or ".hdf5:" in text else (text, "", "")
    path = need(path)
    if path.suffix in (".h5", ".hdf5"):
        with open_h5(path) as file:
            if group not in file or "indptr" not in file[group]:
                raise PlotError(f"{path}: {'no operator ' + group if group else 'name an operator as FILE.h5:GROUP'}; "
                                f"it has: {listing(groups(file))}")
            parts = [dataset(file, f"{group}/{name}") for name in ("data", "indices", "indptr")]
            shape = tuple(int(n) for n in np.ravel(dataset(file, f"{group}/shape")))
        return sp.csr_matrix(tuple(parts), shape=shape), group, path.with_name(f"{group.replace('/', '_')}.png")
    try:
        matrix = scipy.io.mmread(path)
    except (ValueError, IndexError, UnicodeDecodeError) as error:
        raise PlotError(f"{path}: not a Matrix Market file ({error})") from None
    matrix = sp.csr_matrix(matrix)
    if np.iscomplexobj(matrix):
        raise PlotError(f"{path}: complex entries, operators are real")
    return matrix, path.stem, Path.cwd() / f"{path.stem}.png"


def draw(options):
    A, name, beside = load(options.file)
    A.eliminate_zeros()
    rows, columns = A.shape
    figure, (left, right) = plt.subplots(1, 2, figsize=(WIDTH, 3.7))
    draw_pattern(figure, left, A)
    if max(rows, columns) > DENSE_ROWS:
        right.set_axis_off()
        right.text(0.5, 0.5, f"no spectrum: more than {DENSE_ROWS} rows", ha="center", color=FAINT)
    elif rows != columns:
        draw_sorted(right, scipy.linalg.svdvals(A.toarray()), "singular value")
    else:
        draw_eigenvalues(right, A)
    density = A.nnz / (rows * columns)
    figure.suptitle(f"{name}   {rows} × {columns}, {A.nnz} non-zeros ({significant(100 * density, 2)} %)", fontsize=9)
    return figure, beside


def draw_pattern(figure, axes, A):
    """Cells coloured by sign and size, or dots where there are too many to see cells."""
    rows, columns = A.shape
    axes.grid(False)
    axes.spines[["top", "right"]].set_visible(True)
    axes.xaxis.tick_top()
    axes.xaxis.set_label_position("top")
    axes.set(xlabel="column", ylabel="row", aspect="equal" if 1 / 4 < rows / columns < 4 else "auto")
    ticks = matplotlib.ticker.MaxNLocator(6, integer=True)
    axes.xaxis.set_major_locator(ticks)
    axes.yaxis.set_major_locator(matplotlib.ticker.MaxNLocator(6, integer=True))
    triples = A.tocoo()
    axes.set(xlim=(-0.5, columns - 0.5), ylim=(rows - 0.5, -0.5))
    if max(rows, columns) > 400:
        axes.plot(triples.col, triples.row, ",", color=COLOURS[0], rasterized=True)
        return
    cells = np.full(A.shape, np.nan)
    cells[triples.row, triples.col] = triples.data
    limit = np.max(np.abs(triples.data), initial=0.0) or 1.0
    smallest = np.min(np.abs(triples.data), initial=limit)
    threshold = max(smallest, 1e-3 * limit)
    norm = matplotlib.colors.SymLogNorm(threshold, vmin=-limit, vmax=limit) if threshold < 0.2 * limit else (
        matplotlib.colors.Normalize(-limit, limit))
    image = axes.imshow(cells, cmap="RdBu_r", norm=norm, interpolation="nearest", aspect=axes.get_aspect())
    place = make_axes_locatable(axes).append_axes("bottom", size="4%", pad=0.12)
    bar = figure.colorbar(image, cax=place, orientation="horizontal")
    if isinstance(norm, matplotlib.colors.SymLogNorm):
        top = 10.0 ** np.floor(np.log10(limit))
        sizes = [s for s in (top, 1e-2 * top) if s > threshold]
        bar.set_ticks([-s for s in sizes] + [0.0] + sizes[::-1])
        bar.ax.xaxis.set_major_formatter(matplotlib.ticker.FuncFormatter(scientific))
        bar.ax.minorticks_off()
    bar.set_label("entry")
    bar.outline.set_visible(False)


def draw_eigenvalues(axes, A):
    dense = A.toarray()
    size = np.max(np.abs(dense), initial=0.0) or 1.0
    if np.max(np.abs(dense - dense.T)) <= ROUNDING * size:
        draw_sorted(axes, scipy.linalg.eigvalsh(dense)[::-1], "eigenvalue")
        return
    values = scipy.linalg.eigvals(dense)
    extent = np.max(np.abs(values)) or 1.0
    axes.axhline(0, color=FAINT, linewidth=0.6)
    axes.axvline(0, color=FAINT, linewidth=0.6)
    axes.plot(values.real, values.imag, "o", markersize=4, markerfacecolor=COLOURS[0], markeredgecolor="white",
              markeredgewidth=0.3, linestyle="none")
    half = 1.1 * max(np.max(np.abs(values.real)), 0.1 * extent), 1.1 * max(np.max(np.abs(values.imag)), 0.1 * extent)
    axes.set(xlim=(-half[0], half[0]), ylim=(-half[1], half[1]), xlabel="real part", ylabel="imaginary part")
    note(axes, [f"spectral radius {significant(extent)}",
                f"largest real part {significant(np.max(values.real))}"])


def draw_sorted(axes, values, what):
    """Values in falling order on a logarithmic axis; those lost in rounding are counted, not drawn."""
    largest = np.max(np.abs(values), initial=0.0)
    zero = np.abs(values) <= ROUNDING * largest
    index = np.arange(1, len(values) + 1)
    for sign, colour, text in ((1, COLOURS[0], "positive"), (-1, COLOURS[1], "negative")):
        keep = ~zero & (sign * values > 0)
        if np.any(keep):
            axes.semilogy(index[keep], np.abs(values[keep]), "o", markersize=3.5, color=colour, label=text)
    if np.any(values[~zero] < 0):
        axes.legend(loc="lower left")
    axes.set(xlabel="number", ylabel=what if not np.any(values[~zero] < 0) else f"|{what}|")
    axes.set_xlim(0, len(values) + 1)
    axes.xaxis.set_major_locator(matplotlib.ticker.MaxNLocator(8, integer=True))
    readable_log_axis(axes.yaxis, np.abs(values[~zero]))
    axes.grid(True, which="minor", linewidth=0.3)
    nonzero = np.abs(values[~zero])
    lines = [f"largest {significant(largest)}"]
    if len(nonzero):
        lines.append(f"smallest not zero {significant(np.min(nonzero))}")
    lines.append(f"{np.count_nonzero(zero)} zero" if np.any(zero) else "none zero")
    note(axes, lines)


def note(axes, lines):
    axes.set_title("   ".join(lines), fontsize=8, loc="left", color=FAINT)
