"""The bodies of the reference operators, in fractions.

Coordinates and volumes are multiples of powers of two, so the doubles in the files are exact.
"""

from dataclasses import dataclass, replace
from fractions import Fraction

from kernels import decimal

DELTA = Fraction(1, 4)


@dataclass(frozen=True)
class Layout:
    name: str
    X: tuple  # positions [m], a tuple of d coordinates per node
    V: tuple  # volumes [m^d]
    cells: tuple = ()  # corners, counter-clockwise, of the cells that carry stress points
    spacing: Fraction = DELTA

    @property
    def size(self):
        return len(self.X)

    @property
    def dimension(self):
        return len(self.X[0])

    def decimal(self):
        """The same layout in decimals, for kernels and distances that are irrational."""
        return replace(
            self,
            X=tuple(tuple(map(decimal, x)) for x in self.X),
            V=tuple(map(decimal, self.V)),
            spacing=decimal(self.spacing),
        )


def line(cells=6):
    """[0, 3/2], nodes on both ends, which own half a volume."""
    X = tuple((i * DELTA,) for i in range(cells + 1))
    V = tuple(DELTA / 2 if i in (0, cells) else DELTA for i in range(cells + 1))
    return Layout("line7", X, V, tuple((i, i + 1) for i in range(cells)))


def ghosted_line(cells=6, ghosts=4):
    """The line with ghosts behind both ends, each a full volume: the real nodes first, then the ghosts."""
    real = range(cells + 1)
    behind = [*range(-ghosts, 0), *range(cells + 1, cells + ghosts + 1)]
    return Layout("line15-ghosts", tuple((i * DELTA,) for i in [*real, *behind]), (DELTA,) * (len(behind) + len(real)))


def sheet(nx=4, ny=3):
    """[0, 1] x [0, 3/4], node i (ny + 1) + j at (i, j)/4; half volumes on edges, quarters in corners."""
    half = lambda i, n: Fraction(1, 2) if i in (0, n) else Fraction(1)
    grid = [(i, j) for i in range(nx + 1) for j in range(ny + 1)]
    node = lambda i, j: i * (ny + 1) + j
    return Layout(
        "sheet20",
        tuple((i * DELTA, j * DELTA) for i, j in grid),
        tuple(half(i, nx) * half(j, ny) * DELTA**2 for i, j in grid),
        tuple((node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)) for i in range(nx) for j in range(ny)),
    )


# Displacement of the inner nodes of the sheet, in 64ths: at most a fifth of the spacing, no symmetry.
JITTER = {5: (2, -1), 6: (-3, 2), 9: (-1, -3), 10: (3, 1), 13: (1, 3), 14: (-2, -2)}


def cloud():
    """The sheet with its six inner nodes moved; volumes as before, so that they still add up to the area."""
    base = sheet()
    X = list(base.X)
    for node, shift in JITTER.items():
        X[node] = tuple(x + Fraction(s, 64) for x, s in zip(X[node], shift))
    return replace(base, name="cloud20", X=tuple(X))


def quad_area(corners):
    """Area of a quadrilateral with counter-clockwise corners, by its diagonals."""
    (ax, ay), (bx, by), (cx, cy), (dx, dy) = corners
    return ((cx - ax) * (dy - by) - (dx - bx) * (cy - ay)) / 2


def stress_points(layout):
    """Positions (mean of the corners) and volumes of the stress points, one a cell."""
    corners = [[layout.X[q] for q in cell] for cell in layout.cells]
    X = tuple(tuple(sum(x) / len(c) for x in zip(*c)) for c in corners)
    V = tuple(abs(c[1][0] - c[0][0]) if layout.dimension == 1 else quad_area(c) for c in corners)
    return X, V
