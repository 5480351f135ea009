"""Operators of a line that goes on beyond its ends: `mirror` and `thesis`.

The bar has a traction on its left end, which asks for the strain e there, and the displacement u_bar on
its right one. Every operator is affine in (u, e, u_bar), so `tabulate` gets its matrix and its load
columns by applying the procedure to unit vectors.
"""

from operators import Matrix


def lattice_weights(spacing, kernel, support):
    """Weights of W and of the derivative by offset on the unbounded line, scaled so that the first sum to
    one and the second are exact for linear fields: {o: w}, {o: g}, the sum of g o spacing is one."""
    h = support * spacing
    reach = max(o for o in range(1, 100) if o * spacing < h)
    value = {o: kernel.shape(abs(o) * spacing / h) for o in range(-reach, reach + 1)}
    slope = {o: -kernel.first(abs(o) * spacing / h) * (1 if o > 0 else -1) for o in value if o}
    total = sum(value.values())
    moment = sum(g * o * spacing for o, g in slope.items())
    return {o: w / total for o, w in value.items()}, {o: g / moment for o, g in slope.items()}


def tabulate(procedure, size, loads):
    """Matrix and load columns of procedure(u, *loads), which is linear in all of them."""
    unit = lambda n, k: [1 if j == k else 0 for j in range(n)]
    G, G_load = Matrix(size, size), Matrix(size, loads)
    for k in range(size):
        for p, value in enumerate(procedure(unit(size, k), *[0] * loads)):
            G.add(p, k, value)
    for k in range(loads):
        for p, value in enumerate(procedure([0] * size, *unit(loads, k))):
            G_load.add(p, k, value)
    return G, G_load


def applied(weights, field, rows):
    """sum_o weights[o] field[p + o] over what there is of the field."""
    return {p: sum(w * field[p + o] for o, w in weights.items() if p + o in field) for p in rows}


def mirror(layout, kernel, support):
    """G, G_load (e, u_bar), D = V X and D_load (t) with u(-x) = u(x) - 2xe, P(-x) = 2t - P(x),
    u(2L - x) = 2 u_bar - u(x) and P(2L - x) = P(x)."""
    _, g = lattice_weights(layout.spacing, kernel, support)
    n, reach = layout.size, max(g)

    def extended(field, left, right):
        inside = dict(enumerate(field))
        behind = {-m: left(m, field[m]) for m in range(1, reach + 1)}
        beyond = {n - 1 + m: right(field[n - 1 - m]) for m in range(1, reach + 1)}
        return inside | behind | beyond

    def gradient(u, e, u_bar):
        u = extended(u, lambda m, v: v - 2 * m * layout.spacing * e, lambda v: 2 * u_bar - v)
        return applied(g, u, range(n)).values()

    def force(P, t):
        P = extended(P, lambda _, v: 2 * t - v, lambda v: v)
        return [layout.V[p] * f for p, f in applied(g, P, range(n)).items()]

    return *tabulate(gradient, n, 2), *tabulate(force, n, 1)


def solved(A, b):
    """Gauss elimination with row pivots, exact for fractions."""
    n = len(b)
    rows = [list(row) + [value] for row, value in zip(A, b)]
    for k in range(n):
        pivot = max(range(k, n), key=lambda i: abs(rows[i][k]))
        rows[k], rows[pivot] = rows[pivot], rows[k]
        rows[k] = [x / rows[k][k] for x in rows[k]]
        for i in range(n):
            if i != k and rows[i][k]:
                rows[i] = [x - rows[i][k] * y for x, y in zip(rows[i], rows[k])]
    return [row[n] for row in rows]


def close(w, field, nodes, target, coupled):
    """(2.46): values of the field on the nodes that make W f take the target there, given it elsewhere.

    As printed (not coupled) the share of the other nodes in W f is forgotten.
    """
    others = {p: v for p, v in field.items() if p not in nodes}
    share = applied(w, others, nodes) if coupled else dict.fromkeys(nodes, 0)
    A = [[w.get(q - p, 0) for q in nodes] for p in nodes]
    return others | dict(zip(nodes, solved(A, [target - share[p] for p in nodes])))


def thesis(layout, kernel, support, closure):
    """G and G_load (e, u_bar) of the strain with ghosts twice the reach of the kernel behind each end.

    consistent, as-printed: ghosts of u at the left by u(-x) = u(x) - 2xe, at the right by (2.46); <u> = W u,
    set to u_bar there; strain X <u>, its ghosts at the left by (2.46); H = W strain, set to e at the end.
    eta: ghosts carry u of their end plus eta W, eta such that W u = u_bar (2.42) at the right end and
    X u = e (2.45) at the left one, changed in the ghosts only; H = X u.
    """
    w, g = lattice_weights(layout.spacing, kernel, support)
    n, ghosts = layout.size, 2 * max(w)
    everything = range(-ghosts, n + ghosts)
    left, right = range(-ghosts, 1), range(n - 1, n + ghosts)

    def closed(u, e, u_bar):
        u = dict(enumerate(u)) | {-m: u[m] - 2 * m * layout.spacing * e for m in range(1, ghosts + 1)}
        u |= dict.fromkeys(right[1:], 0)
        u = close(w, u, right, u_bar, closure == "consistent")
        smooth = applied(w, u, everything) | dict.fromkeys(right, u_bar)
        strain = close(w, applied(g, smooth, everything), left, e, closure == "consistent")
        return [e, *applied(w, strain, range(1, n)).values()]

    def corrected(u, e, u_bar):
        u = dict(enumerate(u)) | dict.fromkeys(left[:-1], u[0]) | dict.fromkeys(right[1:], u[-1])
        for end, weights, target, behind in ((0, g, e, left[:-1]), (n - 1, w, u_bar, right[1:])):
            shape = {q: w[q - end] for q in behind if q - end in w}
            missing = target - applied(weights, u, [end])[end]
            eta = missing / sum(weights[q - end] * s for q, s in shape.items())
            u |= {q: u[q] + eta * s for q, s in shape.items()}
        return applied(g, u, range(n)).values()

    return tabulate(corrected if closure == "eta" else closed, n, 2)


def lattice_matrices(layout, real, kernel, support):
    """W and the derivative over real nodes and ghosts, truncated where the ghosts end."""
    index = {round(x / layout.spacing): p for p, (x,) in enumerate(layout.X)}
    result = []
    for weights in lattice_weights(layout.spacing, kernel, support):
        matrix = Matrix(layout.size, layout.size)
        for at, p in index.items():
            for o, value in weights.items():
                if at + o in index:
                    matrix.add(p, index[at + o], value)
        result.append(matrix)
    return result


def modified_kernel_matrix(layout, real, W, coupled):
    """(2.46): identity for inner nodes, rows of W for the boundary nodes and the ghosts behind them, which
    as printed (not coupled) lack the columns of all others."""
    place = [round(x / layout.spacing) for (x,) in layout.X]
    left, right = ({p for p, at in enumerate(place) if inside(at)}
                   for inside in (lambda at: at <= 0, lambda at: at >= real - 1))
    out = Matrix(W.rows, W.columns)
    for p in range(W.rows):
        end = left if p in left else right if p in right else None
        if end is None:
            out.add(p, p, 1)
            continue
        for q, value in W.row(p).items():
            if q in end or coupled:
                out.add(p, q, value)
    return out
