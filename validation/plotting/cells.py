"""The body as the cells between its nodes, at their deformed positions: a surface without gaps."""

import numpy as np
from matplotlib.collections import PolyCollection


class Cells:
    """`cells` M×4 numbers of nodes; a field lives on the cells or, with `at_nodes`, at their corners."""

    def __init__(self, nodes, cells, at_nodes):
        self.nodes, self.cells, self.at_nodes = nodes, cells, at_nodes

    def moved(self, u):
        """M×4×2 corners, the nodes moved by their displacements u."""
        return (self.nodes + u)[self.cells]

    def paint(self, axes, polygons, values, colours, limits):
        if not self.at_nodes:
            return paint_polygons(axes, polygons, values, colours, limits)
        # Four triangles a cell, their common corner the mean of the four others.
        corner_values = values[self.cells]
        vertices = np.concatenate([polygons, polygons.mean(axis=1, keepdims=True)], axis=1).reshape(-1, 2)
        shades = np.concatenate([corner_values, corner_values.mean(axis=1, keepdims=True)], axis=1).ravel()
        fan = np.array([[k, (k + 1) % 4, 4] for k in range(4)])
        triangles = (5 * np.arange(len(polygons))[:, None, None] + fan).reshape(-1, 3)
        return axes.tripcolor(vertices[:, 0], vertices[:, 1], triangles, shades, shading="gouraud", cmap=colours,
                              norm=limits, rasterized=True)


def paint_polygons(axes, polygons, values, colours, limits):
    """One colour a polygon; their edges in the same colour close the seams of the renderer."""
    return axes.add_collection(PolyCollection(polygons, array=values, cmap=colours, norm=limits, edgecolors="face",
                                              linewidths=0.4, rasterized=True))
