#!/usr/bin/env python3
"""Write the reference operators, or check the ones that are here.

    python3 matrices/generate.py            writes every .mtx and index.csv beside this file
    python3 matrices/generate.py --check    exit 1 unless the files equal what would be written and
                                            satisfy the laws of their operators

Needs nothing but Python's standard library.
"""

import argparse
import csv
import io
import sys
from decimal import Decimal
from fractions import Fraction
from pathlib import Path

import edges
import layouts
import operators as op
from kernels import KERNELS, decimal
from laws import broken_laws

HERE = Path(__file__).resolve().parent
AXES = "xy"
COLUMNS = ["file", "layout", "dimension", "operator", "formulation", "correction", "kernel", "support",
           "arithmetic", "rows", "columns", "nonzeros"]


def number(x):
    """Nearest double, in the fewest digits that give it back."""
    return repr(float(x))


def coordinate(matrix, comments):
    entries = matrix.nonzeros()
    lines = ["%%MatrixMarket matrix coordinate real general"] + [f"% {c}" for c in comments]
    lines.append(f"{matrix.rows} {matrix.columns} {len(entries)}")
    lines += [f"{i + 1} {j + 1} {number(v)}" for (i, j), v in entries.items()]
    return "\n".join(lines) + "\n"


def array(rows, comments, kind="real"):
    """A dense table; Matrix Market stores it column by column."""
    show = str if kind == "integer" else number
    lines = [f"%%MatrixMarket matrix array {kind} general"] + [f"% {c}" for c in comments]
    lines.append(f"{len(rows)} {len(rows[0])}")
    lines += [show(row[j]) for j in range(len(rows[0])) for row in rows]
    return "\n".join(lines) + "\n"


class Collection:
    """Files to be, by path relative to this folder, and the index that lists them."""

    def __init__(self):
        self.files, self.index = {}, []

    def layout(self, layout):
        folder, d = layout.name, layout.dimension
        self.files[f"{folder}/X.mtx"] = array(layout.X, [f"{folder}: positions of the nodes [m]"])
        self.files[f"{folder}/V.mtx"] = array([(v,) for v in layout.V], [f"{folder}: volumes of the nodes [m^{d}]"])
        if layout.cells:
            X, V = layouts.stress_points(layout)
            self.files[f"{folder}/cells.mtx"] = array(
                layout.cells, [f"{folder}: corners of the cells, counter-clockwise, numbered from 0"], "integer")
            self.files[f"{folder}/points_X.mtx"] = array(X, [f"{folder}: positions of the stress points [m]"])
            self.files[f"{folder}/points_V.mtx"] = array(
                [(v,) for v in V], [f"{folder}: volumes of the stress points [m^{d}]"])

    def add(self, layout, matrix, operator, formulation, correction="", kernel="", support="", says=""):
        support = str(float(support)) if support else ""
        exact = all(isinstance(v, (Fraction, int)) for v in matrix.entries.values())
        arithmetic = "rational" if exact else "decimal"
        stem = "_".join(part for part in (operator, formulation, correction, kernel, support) if part)
        path = f"{layout.name}/{stem}.mtx"
        facts = [f"operator {operator}, formulation {formulation}"]
        if kernel:
            facts[0] += f", kernel {kernel}, support {support} spacings of {float(layout.spacing)} m"
        facts += [says, {"rational": "computed in exact fractions", "decimal": "computed with 60 digits"}[arithmetic]
                  + ", rounded once to the nearest double"]
        assert path not in self.files, path
        self.files[path] = coordinate(matrix, [f for f in facts if f])
        self.index.append([path, layout.name, layout.dimension, operator, formulation, correction, kernel, support,
                           arithmetic, matrix.rows, matrix.columns, len(matrix.nonzeros())])

    def add_directions(self, layout, matrices, letter, *about, says=""):
        for axis, matrix in zip(AXES, matrices):
            self.add(layout, matrix, f"{letter}_{axis}", *about, says=says.replace("#", axis))

    def finish(self):
        text = io.StringIO()
        writer = csv.writer(text, lineterminator="\n")
        writer.writerow(COLUMNS)
        writer.writerows(self.index)
        self.files["index.csv"] = text.getvalue()
        return self.files


def arithmetic(layout, kernel):
    """Fractions where every entry is one: polynomials on a line. Decimals elsewhere."""
    return layout if KERNELS[kernel].exact and layout.dimension == 1 else layout.decimal()


def suit(layout, support):
    return decimal(support) if isinstance(layout.spacing, Decimal) else support


def smoothing(out, base, kernel, support, gradient):
    """W, and the plain gradient of the thesis."""
    layout = arithmetic(base, kernel)
    args = (layout, KERNELS[kernel], suit(layout, support))
    out.add(base, op.kernel_matrix(*args), "W", "thesis", "", kernel, support, "W(|X_p - X_q|) V_q")
    if gradient:
        out.add_directions(base, op.plain_gradient(*args), "G", "thesis", "", kernel, support,
                           says="V_q dW/d# (X_p - X_q), no difference taken")


def variational(out, base, kernel, support, correction, stabiliser=False):
    layout = arithmetic(base, kernel)
    make = {"none": op.difference_gradient, "gradient": op.corrected_gradient, "mixed": op.mixed_gradient}[correction]
    G = make(layout, KERNELS[kernel], suit(layout, support))
    about = ("variational", correction, kernel, support)
    out.add_directions(base, G, "G", *about, says="difference form (40)" if correction == "none" else
                       {"gradient": "corrected gradient (42)-(45)", "mixed": "mixed correction (54)-(58)"}[correction])
    if stabiliser:
        out.add_directions(base, op.adjoint(G, layout.V), "D", *about, says="minus the transpose of G_# times V")
        out_layout = base.decimal()
        S = op.pair_stabiliser(out_layout, [as_decimal(g) for g in G], Decimal("1.6"))
        out.add(base, S, "S_pair", *about, says="pairs nearer than 1.6 spacings, coefficient left out")


def as_decimal(matrix):
    return op.Matrix(matrix.rows, matrix.columns, {k: decimal(v) for k, v in matrix.entries.items()})


def stress_point(out, layout):
    G = op.stress_point_gradient(layout)
    out.add_directions(layout, G, "G", "stress-point", says="mean gradient over each cell")
    out.add_directions(layout, op.adjoint(G, layouts.stress_points(layout)[1]), "D", "stress-point",
                       says="minus the transpose of G_# times the volumes of the points")
    if layout.dimension == 2:
        A = op.cell_errors(layout, G)
        out.add(layout, A, "A_cell", "stress-point", says="hourglass rows, one a cell")
        out.add(layout, A.gram(), "S_cell", "stress-point", says="A^T A, coefficient left out")


def fitted(out, base, kernel, support):
    layout = arithmetic(base, kernel)
    G = op.fitted_gradient(layout, KERNELS[kernel], suit(layout, support))
    out.add_directions(base, G, "G", "stress-point", "fit", kernel, support,
                       says="slope of the linear fit with weights W")


LOADS = "columns: strain at the left end, displacement of the right end"


def mirrored(out, base, kernel, support):
    layout = arithmetic(base, kernel)
    G, G_load, D, D_load = edges.mirror(layout, KERNELS[kernel], suit(layout, support))
    about = ("mirror", "", kernel, support)
    out.add(base, G, "G_x", *about, says="folded, traction at the left end, fixed at the right")
    out.add(base, G_load, "G_load", *about, says=LOADS)
    out.add(base, D, "D_x", *about, says="V X, folded for the stress")
    out.add(base, D_load, "D_load", *about, says="column: traction at the left end")


def closed(out, base, kernel, support, closure):
    """The whole strain operator of the thesis, ghosts eliminated."""
    layout = arithmetic(base, kernel)
    G, G_load = edges.thesis(layout, KERNELS[kernel], suit(layout, support), closure)
    about = ("thesis", closure, kernel, support)
    out.add(base, G, "G_x", *about, says="strain with ghosts, traction at the left end, fixed at the right")
    out.add(base, G_load, "G_load", *about, says=LOADS)


def ghosted(out, base, real, kernel, support):
    """What the thesis's operator is made of, over real nodes and ghosts."""
    layout = arithmetic(base, kernel)
    W, X = edges.lattice_matrices(layout, real, KERNELS[kernel], suit(layout, support))
    about = ("thesis", "lattice", kernel, support)
    out.add(base, W, "W", *about, says="lattice weights, scaled to sum to one")
    out.add(base, X, "G_x", *about, says="lattice weights, scaled to be exact for linear fields")
    for closure, coupled in (("consistent", True), ("as-printed", False)):
        out.add(base, edges.modified_kernel_matrix(layout, real, W, coupled), "W_modified", "thesis", closure, kernel,
                support, "modified SPH matrix (2.46)" + ("" if coupled else ", coupling to the other nodes dropped"))


def collection():
    out = Collection()
    narrow, wide = Fraction(5, 2), Fraction(7, 2)
    line, behind, sheet, cloud = layouts.line(), layouts.ghosted_line(), layouts.sheet(), layouts.cloud()
    for layout in (line, behind, sheet, cloud):
        out.layout(layout)

    for kernel in KERNELS:
        smoothing(out, line, kernel, narrow, gradient=True)
    ghosted(out, behind, line.size, "cubic-spline", narrow)
    for closure in ("consistent", "as-printed", "eta"):
        closed(out, line, "cubic-spline", narrow, closure)
    variational(out, line, "wendland-c2", narrow, "none")
    variational(out, line, "wendland-c2", narrow, "gradient", stabiliser=True)
    variational(out, line, "modified-mollifier", wide, "gradient")
    variational(out, line, "cubic-spline", narrow, "mixed")
    stress_point(out, line)
    mirrored(out, line, "cubic-spline", narrow)
    mirrored(out, line, "modified-mollifier", wide)

    for kernel in KERNELS:
        smoothing(out, sheet, kernel, narrow, gradient=kernel == "modified-mollifier")
    variational(out, sheet, "wendland-c2", narrow, "gradient", stabiliser=True)
    stress_point(out, sheet)

    smoothing(out, cloud, "modified-mollifier", narrow, gradient=True)
    variational(out, cloud, "quadratic", narrow, "none")
    variational(out, cloud, "cubic-spline", narrow, "gradient", stabiliser=True)
    variational(out, cloud, "wendland-c2", narrow, "mixed")
    stress_point(out, cloud)
    fitted(out, cloud, "wendland-c2", narrow)
    return out.finish()


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--check", action="store_true", help="write nothing, compare and verify")
    check = parser.parse_args().check
    wanted = collection()
    if not check:
        for path, text in wanted.items():
            (HERE / path).parent.mkdir(exist_ok=True)
            (HERE / path).write_text(text)
        print(f"wrote {len(wanted)} files")
        return 0

    present = {str(p.relative_to(HERE)) for p in HERE.glob("*/*.mtx")} | {"index.csv"}
    faults = [f"{path}: no longer generated" for path in sorted(present - wanted.keys())]
    faults += [f"{path}: missing" for path in sorted(wanted.keys() - present)]
    faults += [f"{path}: differs from what is generated" for path in sorted(wanted.keys() & present)
               if (HERE / path).is_file() and (HERE / path).read_text() != wanted[path]]
    if not faults:
        faults = broken_laws(HERE)
    print("\n".join(faults) or f"{len(wanted)} files agree and satisfy their laws")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
