"""The frames of a run.h5 as fields with their positions."""

import numpy as np

from plotting.data import PlotError, as_table, dataset, listing, open_h5
from plotting.style import QUANTITIES, split_quantity

AXES = "xyz"


class Run:
    def __init__(self, path):
        self.path = path
        self.file = open_h5(path)
        self.scene = self.file["scene"].attrs.get("text", "") if "scene" in self.file else ""
        self.nodes = as_table(dataset(self.file, "particles/X"))
        self.volumes = dataset(self.file, "particles/V").ravel() if "particles/V" in self.file else None
        self.points = as_table(dataset(self.file, "points/X")) if "points/X" in self.file else self.nodes
        self.cells = dataset(self.file, "points/cells") if "points/cells" in self.file else None
        self.triangles = dataset(self.file, "particles/triangles") if "particles/triangles" in self.file else None
        self.edges = dataset(self.file, "points/edges") if "points/edges" in self.file else None
        self.times = dataset(self.file, "frames/time")
        self.dimension = self.nodes.shape[1]

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.file.close()

    def recorded(self):
        return [name for name in self.file["frames"] if name != "time"]

    def rows(self, name, frames):
        """The chosen frames of a recorded array, frames × positions × components."""
        data = self.file[f"frames/{name}"]
        return np.stack([np.asarray(data[f], dtype=float).reshape(data.shape[1], -1) for f in frames])

    def displacement(self, frames):
        if "displacement" not in self.recorded():
            raise PlotError(f"{self.path}: no frames/displacement, so the deformed body is not known; "
                            "add displacement to output.fields of the scene")
        return self.rows("displacement", frames)

    def field(self, name, frames):
        """Positions X and values, frames × positions, of a field by its name.

        X is `nodes` or `points` itself, where the field lives.
        """
        stem, suffix = split_quantity(name)
        if stem not in QUANTITIES and name not in self.recorded():
            stem, _, suffix = name.rpartition("_") if name.rpartition("_")[0] in self.recorded() else (name, "", "")
        if stem in self.recorded():
            data = self.rows(stem, frames)
        elif stem == "cauchy" and {"pk1", "deformation_gradient"} <= set(self.recorded()):
            data = self.cauchy(frames)
        else:
            raise PlotError(f"{self.path}: no field {name}; recorded are: {listing(self.recorded())}. "
                            f"Others come with output.fields of the scene")
        if data.shape[1] not in (len(self.nodes), len(self.points)):
            raise PlotError(f"{self.path}: frames/{stem} has {data.shape[1]} rows, neither that of the nodes "
                            f"({len(self.nodes)}) nor of the material points ({len(self.points)})")
        # Vectors and masses live at nodes, deformation and stress at material points.
        at_nodes = stem in ("displacement", "velocity", "acceleration") or data.shape[1] != len(self.points)
        return (self.nodes if at_nodes else self.points), self.component(name, suffix, data)

    def component(self, name, suffix, data):
        count, d = data.shape[2], self.dimension
        if suffix == "magnitude":
            return np.linalg.norm(data, axis=2)
        if count == 1 and suffix in ("", "x", "xx"):
            return data[:, :, 0]
        names = [a for a in AXES[:d]] if count == d else [a + b for a in AXES[:d] for b in AXES[:d]]
        if len(names) != count or suffix not in names:
            raise PlotError(f"{self.path}: {name} has the components {', '.join(names[:count])}, or magnitude")
        return data[:, :, names.index(suffix)]

    def cauchy(self, frames):
        """P F^T / det F."""
        d = self.dimension
        P = self.rows("pk1", frames).reshape(len(frames), -1, d, d)
        F = self.rows("deformation_gradient", frames).reshape(len(frames), -1, d, d)
        sigma = P @ np.swapaxes(F, -1, -2) / np.linalg.det(F)[..., None, None]
        return sigma.reshape(len(frames), -1, d * d)
