"""The laws that the reference operators obey, checked on the files as they are read back."""

import csv

from edges import solved

ROUNDING = 1e-13  # entries are of order 1 to 30 and carry one rounding each


def read(path):
    """Shape and entries {(row, column): value} of a Matrix Market file, numbered from 0."""
    lines = path.read_text().splitlines()
    dense = " array " in lines[0]
    body = [line.split() for line in lines if not line.startswith("%")]
    rows, columns = int(body[0][0]), int(body[0][1])
    if dense:
        return rows, columns, {(k % rows, k // rows): float(v) for k, (v,) in enumerate(body[1:])}
    assert len(body) - 1 == int(body[0][2]), f"{path}: wrong number of entries"
    return rows, columns, {(int(i) - 1, int(j) - 1): float(v) for i, j, v in body[1:]}


def times(A, x):
    rows, _, entries = A
    y = [0.0] * rows
    for (i, j), v in entries.items():
        y[i] += v * x[j]
    return y


def column(table, j):
    return [table[2][i, j] for i in range(table[0])]


class Laws:
    def __init__(self, home):
        self.home, self.faults, self.checked = home, [], 0
        with open(home / "index.csv", newline="") as file:
            self.index = list(csv.DictReader(file))

    def hold(self, entry, law, left, right):
        self.checked += 1
        error = max((abs(a - b) for a, b in zip(left, right, strict=True)), default=0.0)
        if not error < ROUNDING:
            self.faults.append(f"{entry['file']}: {law} is off by {error:.1e}")

    def sibling(self, entry, operator, formulation=None):
        """The operator of the same family as this one."""
        same = ("layout", "correction", "kernel", "support")
        wanted = formulation or entry["formulation"]
        match = [e for e in self.index if e["operator"] == operator and e["formulation"] == wanted
                 and all(e[k] == entry[k] for k in same)]
        return read(self.home / match[0]["file"])

    def check(self, entry):
        matrix = read(self.home / entry["file"])
        rows, columns, entries = matrix
        if [rows, columns, len(entries)] != [int(entry[k]) for k in ("rows", "columns", "nonzeros")]:
            self.faults.append(f"{entry['file']}: shape or non-zeros differ from the index")
        folder = self.home / entry["layout"]
        X, V = read(folder / "X.mtx"), column(read(folder / "V.mtx"), 0)
        axes = [column(X, a) for a in range(int(entry["dimension"]))]
        getattr(self, entry["operator"][0].lower())(entry, matrix, axes, V)

    def w(self, entry, matrix, axes, V):
        rows, _, entries = matrix
        if entry["operator"] == "W":
            self.hold(entry, "symmetry of W/V", [entries[p, q] / V[q] for p, q in entries],
                      [entries[q, p] / V[p] for p, q in entries])
            return
        # (2.47): with the fields of (2.46) W f takes the target on boundary nodes and ghosts. The
        # printed matrix does not keep that promise, by its own share of the inner nodes.
        W = self.read_first(entry, "W")
        inner = [p for p in range(rows) if [q for q in range(rows) if (p, q) in entries] == [p]]
        wanted = [0.3 + p if p in inner else 1.0 for p in range(rows)]
        dense = [[entries.get((p, q), 0.0) for q in range(rows)] for p in range(rows)]
        taken = times(W, solved(dense, wanted))
        error = max(abs(taken[p] - wanted[p]) for p in range(rows) if p not in inner)
        if (error < 1e-12) != (entry["correction"] == "consistent"):
            self.faults.append(f"{entry['file']}: W f misses its target by {error:.1e}")

    def read_first(self, entry, operator):
        return read(self.home / next(e["file"] for e in self.index if e["operator"] == operator and
                                     all(e[k] == entry[k] for k in ("layout", "kernel", "support"))))

    def g(self, entry, matrix, axes, V):
        rows, _, entries = matrix
        ones = [1.0] * len(V)
        if entry["operator"] == "G_load":
            return  # checked with its G_x
        if entry["formulation"] == "mirror":
            load = self.sibling(entry, "G_load")
            u = [2.0 + 3.0 * x for x in axes[0]]
            H = [a + b for a, b in zip(times(matrix, u), times(load, [3.0, u[-1]]))]
            self.hold(entry, "gradient of a linear field", H, [3.0] * rows)
        elif entry["formulation"] == "thesis" and entry["correction"] in ("consistent", "as-printed", "eta"):
            load = self.sibling(entry, "G_load")
            H = [a + b for a, b in zip(times(matrix, ones), times(load, [5.0, 1.0]))]
            self.hold(entry, "strain asked for at the end", H[:1], [5.0])
        elif entry["formulation"] == "thesis":
            self.hold(entry, "antisymmetry of G/V", [entries[p, q] / V[q] for p, q in entries],
                      [-entries[q, p] / V[p] for p, q in entries])
        else:
            self.hold(entry, "G 1 = 0", times(matrix, ones), [0.0] * rows)
            if entry["correction"] != "none":
                axis = "xy".index(entry["operator"][-1])
                for a, x in enumerate(axes):
                    self.hold(entry, "G X = I", times(matrix, x), [float(a == axis)] * rows)

    def d(self, entry, matrix, axes, V):
        if entry["operator"] == "D_load":
            return  # checked with its D_x
        if entry["formulation"] == "mirror":
            load = self.sibling(entry, "D_load")
            f = [a + b for a, b in zip(times(matrix, [7.0] * len(V)), times(load, [7.0]))]
            self.hold(entry, "force of a constant stress", f, [0.0] * len(V))
            return
        G = self.sibling(entry, "G" + entry["operator"][1:])
        points = entry["formulation"] == "stress-point"
        volumes = column(read(self.home / entry["layout"] / "points_V.mtx"), 0) if points else V
        self.hold(entry, "D = -G^T V", [matrix[2].get((q, s), 0.0) for s, q in G[2]],
                  [-v * volumes[s] for (s, q), v in G[2].items()])
        assert len(matrix[2]) == len(G[2])

    def s(self, entry, matrix, axes, V):
        rows, _, entries = matrix
        self.hold(entry, "symmetry", list(entries.values()), [entries[j, i] for i, j in entries])
        for field in [[1.0] * rows, *axes]:
            self.hold(entry, "S of a linear field", times(matrix, field), [0.0] * rows)
        if entry["operator"] == "S_cell":
            A = self.sibling(entry, "A_cell")
            noise = [float((7 * p * p) % 11) for p in range(rows)]
            self.hold(entry, "x S x = |A x|^2", [sum(x * y for x, y in zip(noise, times(matrix, noise)))],
                      [sum(y * y for y in times(A, noise))])

    def a(self, entry, matrix, axes, V):
        for field in [[1.0] * matrix[1], *axes]:
            self.hold(entry, "A of a linear field", times(matrix, field), [0.0] * matrix[0])


def broken_laws(home):
    laws = Laws(home)
    for entry in laws.index:
        laws.check(entry)
    assert laws.checked > len(laws.index) / 2
    return laws.faults
