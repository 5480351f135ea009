"""run.xdmf as meshio reads it: points, cells and every field of every frame are those of run.h5."""

import unittest

import h5py
import meshio
import numpy as np

from support import BAR, SHEET, ProgramTest

FIELDS = 'output.fields=["displacement", "velocity", "cauchy", "von_mises"]'
HEXAGONAL = ("--set", "body.layout=hexagonal", "--set", "stabiliser.kind=none")

# Scene, settings, cells and where the stresses are, if not with the particles.
RUNS = {
    "cells": (SHEET, (), "quad", "cell"),
    "nodes": (SHEET, ("--set", "formulation=variational"), "vertex", "point"),
    "cells of a bar": (BAR, (), "line", "cell"),
    "nodes of a bar": (BAR, ("--set", "formulation=mirror"), "vertex", "point"),
    "nodes of triangles": (SHEET, (*HEXAGONAL, "--set", "formulation=variational"), "triangle", "point"),
    "edges of triangles": (SHEET, HEXAGONAL, "triangle", None),
}


class Xdmf(ProgramTest):
    def test_every_frame_is_read_whole(self):
        for name, (scene, settings, cells, stresses) in RUNS.items():
            with self.subTest(name):
                out = self.run_scene(scene, "--set", FIELDS, *settings)

                with (
                    h5py.File(out / "run.h5") as file,
                    meshio.xdmf.TimeSeriesReader(out / "run.xdmf") as reader,
                ):
                    self.expect_body(file, *reader.read_points_cells(), cells)
                    frames = file["frames"]
                    self.assertEqual(reader.num_steps, len(frames["time"]))
                    for k in range(reader.num_steps):
                        time, at_points, at_cells = reader.read_data(k)
                        self.assertEqual(time, frames["time"][k])
                        at_cells = {field: values for field, (values,) in at_cells.items()}
                        self.expect_fields(frames, k, at_points, at_cells, stresses)

    def expect_body(self, file, points, blocks, cells):
        X = file["particles/X"][:]
        np.testing.assert_array_equal(points[:, : X.shape[1]], X)
        np.testing.assert_array_equal(points[:, X.shape[1] :], 0.0)
        (block,) = blocks
        self.assertEqual(block.type, cells)
        corners = {"triangle": "particles/triangles", "quad": "points/cells", "line": "points/cells"}
        expected = file[corners[cells]][:] if cells in corners else np.arange(len(X))[:, None]
        np.testing.assert_array_equal(block.data, expected)

    def expect_fields(self, frames, k, at_points, at_cells, stresses):
        seen = {"point": at_points, "cell": at_cells}
        d = frames["displacement"].shape[2]
        expected = {"point": {}, "cell": {}}
        for field in ("displacement", "velocity"):
            values = frames[field][k]
            if d == 2:
                expected["point"][field] = np.column_stack([values, np.zeros(len(values))])
            else:
                expected["point"][field + "_x"] = values[:, 0]
        if stresses:
            expected[stresses]["von_mises"] = frames["von_mises"][k]
            for i in range(d):
                for j in range(d):
                    name = "cauchy_" + "xyz"[i] + "xyz"[j]
                    expected[stresses][name] = frames["cauchy"][k][:, d * i + j]
        for place, fields in expected.items():
            self.assertEqual(set(seen[place]), set(fields))
            for name, values in fields.items():
                np.testing.assert_array_equal(seen[place][name], values, f"{name} in frame {k}")


if __name__ == "__main__":
    unittest.main()
