"""The body as the triangles between scattered nodes, at their deformed positions."""

import numpy as np

from plotting.cells import paint_polygons


class Triangles:
    """`triangles` K×3 numbers of nodes; a field lives at the nodes or, with `edges`, on these.

    An edge (M×4: ends, node on its left, node on its right or -1) is painted as its third of the triangles
    beside it: from its ends to their centres.
    """

    def __init__(self, nodes, triangles, edges=None):
        self.nodes, self.triangles, self.edges = nodes, triangles, edges

    def moved(self, u):
        """Corners of the triangles or of the parts that belong to the edges, nodes moved by u."""
        x = self.nodes + u
        if self.edges is None:
            return x[self.triangles]
        a, b, left, right = x[self.edges].swapaxes(0, 1)
        beyond = np.where(self.edges[:, 3:] < 0, (a + b) / 2, (a + b + right) / 3)
        return np.stack([a, beyond, b, (a + b + left) / 3], axis=1)

    def paint(self, axes, polygons, values, colours, limits):
        if self.edges is not None:
            return paint_polygons(axes, polygons, values, colours, limits)
        vertices = polygons.reshape(-1, 2)
        return axes.tripcolor(vertices[:, 0], vertices[:, 1], np.arange(len(vertices)).reshape(-1, 3),
                              values[self.triangles].ravel(), shading="gouraud", cmap=colours, norm=limits,
                              rasterized=True)
