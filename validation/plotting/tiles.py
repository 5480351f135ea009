"""The body as tiles, one for each position of a field, carried along by the displacement."""

import numpy as np
from scipy.spatial import Voronoi, cKDTree

from plotting.cells import paint_polygons


class Tiles:
    """Reference corners of all tiles, one under the other, with the position each belongs to.

    A tile is what lies nearer to its position than to any other: squares on a lattice, Voronoi cells
    elsewhere. It ends at the box around the body, on which nodes lie if they own less than a full
    volume there, and half a spacing away where nothing is near, as at a hole.
    """

    def __init__(self, X, nodes, volumes):
        self.X, self.nodes = X, nodes
        neighbours, _ = cKDTree(X).query(X, k=2)
        self.side = float(np.sqrt(np.median(volumes)) if volumes is not None else np.median(neighbours[:, 1]))
        low, high = nodes.min(axis=0), nodes.max(axis=0)
        if not on_boundary(nodes, volumes):
            low, high = low - self.side / 2, high + self.side / 2
        regular = np.ptp(neighbours[:, 1]) < 1e-6 * self.side
        cells = [None] * len(X) if regular else voronoi_cells(X, self.side, low, high)
        square = 0.5 * self.side * np.array([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]])
        polygons = [np.clip(x + square if cell is None else cell, low, high) for x, cell in zip(X, cells)]
        self.corners = np.concatenate(polygons)
        self.owner = np.repeat(np.arange(len(X)), [len(p) for p in polygons])
        self.ends = np.cumsum([len(p) for p in polygons])[:-1]

    def moved(self, u):
        """Polygons moved by the linear field that fits the displacements u of the nearest nodes."""
        distance, near = cKDTree(self.nodes).query(self.X, k=min(9, len(self.nodes)))
        arm = self.nodes[near] - self.X[:, None, :]
        weight = np.exp(-((distance / self.side) ** 2))
        basis = np.concatenate([np.ones((*arm.shape[:2], 1)), arm], axis=2)
        normal = np.einsum("nk,nki,nkj->nij", weight, basis, basis)
        fit = np.linalg.pinv(normal) @ np.einsum("nk,nki,nkj->nij", weight, basis, u[near])
        at_node = distance[:, 0] < 1e-6 * self.side
        fit[at_node, 0] = u[near[at_node, 0]]
        arm = self.corners - self.X[self.owner]
        moved = self.corners + fit[self.owner, 0] + np.einsum("ca,caj->cj", arm, fit[self.owner, 1:])
        return np.split(moved, self.ends)

    def paint(self, axes, polygons, values, colours, limits):
        return paint_polygons(axes, polygons, values, colours, limits)


def on_boundary(nodes, volumes):
    """Whether the outermost nodes own less than a full volume, as they do on the boundary of a body."""
    if volumes is None:
        return False
    edge = nodes[:, 0] <= nodes[:, 0].min() + 1e-9 * np.ptp(nodes[:, 0])
    return bool(np.median(volumes[edge]) < 0.75 * np.median(volumes))


def voronoi_cells(X, reach, low, high):
    """Voronoi cells within the box, None for those with a corner farther than that from their position."""
    mirrored = [X]
    for a in range(2):
        for wall in (low[a], high[a]):
            image = X.copy()
            image[:, a] = 2 * wall - image[:, a]
            mirrored.append(image[image[:, a] != wall])
    diagram = Voronoi(np.concatenate(mirrored))
    cells = []
    for x, region in zip(X, diagram.point_region):
        corners = diagram.regions[region]
        cell = diagram.vertices[corners] if corners and -1 not in corners else None
        whole = cell is not None and np.max(np.linalg.norm(np.clip(cell, low, high) - x, axis=1)) < reach
        cells.append(cell if whole else None)
    return cells
