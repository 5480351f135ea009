"""The operators, written down from their equations with no regard for speed.

Every function takes a layout, in fractions or decimals, and returns matrices as dictionaries
{(row, column): value} wrapped with their shape; G and D come as one matrix per direction.
"""

from dataclasses import dataclass, field
from decimal import Decimal
from fractions import Fraction
from itertools import combinations

from layouts import stress_points

NOTHING = Decimal("1e-40")  # what cancellation leaves of a zero in 60-digit arithmetic


@dataclass
class Matrix:
    rows: int
    columns: int
    entries: dict = field(default_factory=dict)

    def add(self, row, column, value):
        self.entries[row, column] = self.entries.get((row, column), 0) + value

    def row(self, row):
        return {j: v for (i, j), v in self.entries.items() if i == row}

    def gram(self):
        """A^T A."""
        out = Matrix(self.columns, self.columns)
        for row in range(self.rows):
            out.add_outer(self.row(row), 1)
        return out

    def add_outer(self, a, weight):
        """Add weight a a^T for a sparse row a."""
        for i, x in a.items():
            for j, y in a.items():
                self.add(i, j, weight * x * y)

    def nonzeros(self):
        return {k: v for k, v in sorted(self.entries.items()) if abs(v) > NOTHING}


def sqrt(x):
    """Of a decimal, or of a fraction that is a square."""
    if isinstance(x, Decimal):
        return x.sqrt()
    top, bottom = (int(Decimal(n).sqrt()) for n in (x.numerator, x.denominator))
    if top * top != x.numerator or bottom * bottom != x.denominator:
        raise ValueError(f"the root of {x} is irrational: take the layout in decimals")
    return Fraction(top, bottom)


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def inverse(m):
    """Of a 1 x 1 or 2 x 2 matrix."""
    if len(m) == 1:
        return [[1 / m[0][0]]]
    (a, b), (c, d) = m
    det = a * d - b * c
    return [[d / det, -b / det], [-c / det, a / det]]


def kernel_matrix(layout, kernel, support):
    """W_pq = W(|X_p - X_q|, h) V_q, h = support x spacing."""
    h = support * layout.spacing
    scale = kernel.normalisation(layout.dimension) / h**layout.dimension
    W = Matrix(layout.size, layout.size)
    for p, xp in enumerate(layout.X):
        for q, xq in enumerate(layout.X):
            r = sqrt(dot(minus(xp, xq), minus(xp, xq)))
            if r < h:
                W.add(p, q, scale * kernel.shape(r / h) * layout.V[q])
    return W


def kernel_gradients(layout, kernel, support):
    """For each p the neighbours {q: grad_p W(X_p - X_q)}; at q = p the gradient is zero."""
    h = support * layout.spacing
    scale = kernel.normalisation(layout.dimension) / h ** (layout.dimension + 1)
    gradients = []
    for p, xp in enumerate(layout.X):
        row = {}
        for q, xq in enumerate(layout.X):
            d = minus(xp, xq)
            r = sqrt(dot(d, d))
            if p != q and r < h:
                row[q] = tuple(scale * kernel.first(r / h) * x / r for x in d)
        gradients.append(row)
    return gradients


def assemble(layout, weights):
    """One matrix per direction from rows of {q: vector}."""
    G = [Matrix(layout.size, layout.size) for _ in range(layout.dimension)]
    for p, row in enumerate(weights):
        for q, g in row.items():
            for matrix, component in zip(G, g):
                matrix.add(p, q, component)
    return G


def plain_gradient(layout, kernel, support):
    """(G^a f)_p = sum_q V_q f_q dW/dX_a(X_p - X_q): the sum without f_p."""
    rows = kernel_gradients(layout, kernel, support)
    return assemble(layout, [{q: tuple(layout.V[q] * x for x in g) for q, g in row.items()} for row in rows])


def corrected_rows(layout, rows):
    """L_p times rows of V_q grad W, with L_p the inverse of sum_q V_q grad W (x) (X_q - X_p), (45)."""
    d = range(layout.dimension)
    out = []
    for p, row in enumerate(rows):
        e = {q: minus(layout.X[q], layout.X[p]) for q in row}
        L = inverse([[sum(g[a] * e[q][b] for q, g in row.items()) for b in d] for a in d])
        out.append({q: tuple(dot(L[a], g) for a in d) for q, g in row.items()})
    return out


def corrected_gradient(layout, kernel, support):
    """G_pq = V_q L_p grad_p W for q != p, G_pp minus their sum: (42)-(45)."""
    rows = kernel_gradients(layout, kernel, support)
    rows = [{q: tuple(layout.V[q] * x for x in g) for q, g in row.items()} for row in rows]
    rows = corrected_rows(layout, rows)
    for p, row in enumerate(rows):
        row[p] = tuple(-sum(g[a] for g in row.values()) for a in range(layout.dimension))
    return assemble(layout, rows)


def difference_gradient(layout, kernel, support):
    """G_pq = V_q grad_p W for q != p, G_pp minus their sum: exact for constants only, (40)."""
    G = plain_gradient(layout, kernel, support)
    for g in G:
        for p in range(layout.size):
            g.add(p, p, -sum(g.row(p).values()))
    return G


def mixed_gradient(layout, kernel, support):
    """Gradient of the Shepard-normalised kernel, corrected: (54)-(58).

    With s = sum V W the quotient rule gives grad(W/s) = (grad W - W gamma)/s, gamma = grad s / s. The
    printed (57) lacks the factor W at gamma; only with it does the gradient of a constant vanish.
    """
    W = kernel_matrix(layout, kernel, support)
    d = range(layout.dimension)
    rows = []
    for p, gradients in enumerate(kernel_gradients(layout, kernel, support)):
        wv = W.row(p)  # W_pq V_q
        s = sum(wv.values())
        vg = {q: tuple(layout.V[q] * x for x in gradients.get(q, (0,) * layout.dimension)) for q in wv}
        gamma = [sum(g[a] for g in vg.values()) / s for a in d]
        rows.append({q: tuple((vg[q][a] - wv[q] * gamma[a]) / s for a in d) for q in wv})
    return assemble(layout, corrected_rows(layout, rows))


def fitted_gradient(layout, kernel, support):
    """Slope b at each stress point of the fit min sum_q W(r_q) (f_q - c - b.(X_q - X_s))^2."""
    points, _ = stress_points(layout)
    h = support * layout.spacing
    d = range(layout.dimension)
    G = [Matrix(len(points), layout.size) for _ in d]
    for s, x in enumerate(points):
        e = {q: minus(xq, x) for q, xq in enumerate(layout.X)}
        r = {q: sqrt(dot(v, v)) for q, v in e.items()}
        w = {q: kernel.shape(r[q] / h) for q in e if r[q] < h}
        total = sum(w.values())
        mean = [sum(w[q] * e[q][a] for q in w) / total for a in d]
        f = {q: minus(e[q], mean) for q in w}
        L = inverse([[sum(w[q] * f[q][a] * f[q][b] for q in w) for b in d] for a in d])
        for q in w:
            for a in d:
                G[a].add(s, q, w[q] * dot(L[a], f[q]))
    return G


def adjoint(G, volumes):
    """D^a = -(G^a)^T V_s."""
    D = [Matrix(g.columns, g.rows) for g in G]
    for g, matrix in zip(G, D):
        for (s, q), value in g.entries.items():
            matrix.add(q, s, -value * volumes[s])
    return D


def stress_point_gradient(layout):
    """Mean gradient over each cell: the divergence theorem on its straight edges."""
    _, volumes = stress_points(layout)
    G = [Matrix(len(layout.cells), layout.size) for _ in range(layout.dimension)]
    for s, cell in enumerate(layout.cells):
        if layout.dimension == 1:
            G[0].add(s, cell[0], -1 / volumes[s])
            G[0].add(s, cell[1], 1 / volumes[s])
            continue
        for k, q in enumerate(cell):
            x, y = minus(layout.X[cell[(k + 1) % 4]], layout.X[cell[k - 1]])
            G[0].add(s, q, y / (2 * volumes[s]))
            G[1].add(s, q, -x / (2 * volumes[s]))
    return G


def pair_stabiliser(layout, G, reach):
    """S = sum of w a a^T over the pairs p < q nearer than reach x spacing, w = sqrt(V_p V_q) / r^2.

    Row a gives the error e = u_q - u_p - (G_p u + G_q u)/2 . (X_q - X_p) of one component.
    """
    S = Matrix(layout.size, layout.size)
    rows = [[g.row(p) for p in range(layout.size)] for g in G]
    for p, q in combinations(range(layout.size), 2):
        d = minus(layout.X[q], layout.X[p])
        if dot(d, d) >= (reach * layout.spacing) ** 2:
            continue
        a = {p: -1, q: 1}
        for direction, component in enumerate(d):
            for end in (p, q):
                for node, g in rows[direction][end].items():
                    a[node] = a.get(node, 0) - g * component / 2
        S.add_outer(a, sqrt(layout.V[p] * layout.V[q]) / dot(d, d))
    return S


def cell_errors(layout, G):
    """Rows gamma_q = (h_q - sum_a G^a_sq sum_r h_r X^a_r) / 4, h = (1, -1, 1, -1) round the cell."""
    A = Matrix(len(layout.cells), layout.size)
    for s, cell in enumerate(layout.cells):
        h = dict(zip(cell, (1, -1, 1, -1)))
        moment = [sum(sign * layout.X[q][a] for q, sign in h.items()) for a in range(layout.dimension)]
        for q, sign in h.items():
            seen = sum(G[a].entries.get((s, q), 0) * moment[a] for a in range(layout.dimension))
            A.add(s, q, (sign - seen) / 4)
    return A
