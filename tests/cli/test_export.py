"""The exported operators, read back by scipy: what they promise holds there too."""

import json
import unittest

import h5py
import numpy as np
import scipy.io
import scipy.sparse

from support import BAR, SHEET, ProgramTest


def csr(group):
    return scipy.sparse.csr_matrix(
        (group["data"][:], group["indices"][:], group["indptr"][:]), shape=tuple(group["shape"][:])
    )


class Export(ProgramTest):
    def export(self, text, *arguments):
        self.write("scene.toml", text)
        done = self.tlsph("export", "scene.toml", "--out", "matrices", *arguments)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return self.folder / "matrices"

    def test_both_formats_hold_the_same(self):
        out = self.export(SHEET)

        with h5py.File(out / "operators.h5") as file:
            names = [name for name in file if isinstance(file[name], h5py.Group) and "indptr" in file[name]]
            self.assertLessEqual({"G_x", "G_y", "D_x", "D_y", "S", "M"}, set(names))
            for name in names:
                with self.subTest(name):
                    text = scipy.io.mmread(out / f"{name}.mtx").tocsr()
                    self.assertEqual((text != csr(file[name])).nnz, 0)

    def test_gradients_are_exact_for_linear_fields(self):
        for formulation in ("stress-point", "variational"):
            with self.subTest(formulation):
                out = self.export(SHEET, "--set", "formulation=" + formulation)

                with h5py.File(out / "operators.h5") as file:
                    X = file["particles/X"][:]
                    G = [csr(file["G_x"]), csr(file["G_y"])]

                for a in range(2):
                    scale = abs(G[a]).sum(axis=1).max()
                    np.testing.assert_allclose(G[a] @ np.ones(len(X)), 0, atol=1e-12 * scale)
                    for b in range(2):
                        np.testing.assert_allclose(G[a] @ X[:, b], float(a == b), atol=1e-12 * scale)

    def test_divergence_is_the_adjoint(self):
        for formulation in ("stress-point", "variational"):
            with self.subTest(formulation):
                out = self.export(SHEET, "--set", "formulation=" + formulation)

                with h5py.File(out / "operators.h5") as file:
                    V = scipy.sparse.diags(file["points/V"][:])
                    for a in "xy":
                        G, D = csr(file["G_" + a]), csr(file["D_" + a])
                        self.assertLessEqual(abs(D + G.T @ V).max(), 1e-14 * abs(D).max())

    def test_mass_is_that_of_the_body(self):
        out = self.export(SHEET)

        M = scipy.io.mmread(out / "M.mtx")

        self.assertAlmostEqual(M.tocsr().diagonal().sum(), 1000.0, places=9)

    def test_report_agrees(self):
        for formulation in ("stress-point", "variational"):
            with self.subTest(formulation):
                out = self.export(SHEET, "--set", "formulation=" + formulation)

                report = json.loads((out / "report.json").read_text(encoding="utf-8"))
                with h5py.File(out / "operators.h5") as file:
                    X, V = file["particles/X"][:], file["points/V"][:]
                    operators = {name: csr(file[name]) for name in report["operators"]}
                G = [operators["G_x"], operators["G_y"]]
                D = [operators["D_x"], operators["D_y"]]

                for name, told in report["operators"].items():
                    matrix = operators[name]
                    self.assertEqual((told["rows"], told["columns"]), matrix.shape)
                    self.assertEqual(told["nonzeros"], matrix.nnz)
                adjointness = max(abs(D[a] + G[a].T @ scipy.sparse.diags(V)).max() for a in range(2))
                told = report["gradient"]
                self.assertLessEqual(told["adjointness_error"], 1e-13)
                self.assertLessEqual(adjointness, 1e-13)
                rows = max(abs(G[a] @ np.ones(len(X))).max() for a in range(2))
                self.assertAlmostEqual(told["row_sum_residual"], rows, delta=1e-11)
                self.assertLessEqual(told["linear_moment_residual"], 1e-11)

    def test_report_tells_what_is_not_adjoint(self):
        out = self.export(BAR, "--set", "formulation=mirror")

        report = json.loads((out / "report.json").read_text(encoding="utf-8"))

        self.assertGreater(report["gradient"]["adjointness_error"], 1e-6)

    def test_a_used_folder_holds_the_matrices_of_the_last_export_only(self):
        for settings in (
            ("formulation=variational",),
            ("formulation=stress-point",),
            ("formulation=stress-point", "stabiliser.kind=none"),
        ):
            arguments = [word for setting in settings for word in ("--set", setting)]
            out = self.export(SHEET, *arguments)
            (out / "X.mtx").touch()  # of somebody else

            report = json.loads((out / "report.json").read_text(encoding="utf-8"))
            written = {path.stem for path in out.glob("*.mtx")}
            self.assertEqual(written, set(report["operators"]) | {"X"})
        self.assertNotIn("S", report["operators"])

    def test_a_report_that_cannot_be_read_is_no_one_s(self):
        (self.folder / "matrices").mkdir()
        (self.folder / "matrices/report.json").write_text("no report", encoding="utf-8")
        (self.folder / "matrices/S.mtx").touch()

        out = self.export(SHEET, "--set", "stabiliser.kind=none")

        self.assertTrue((out / "S.mtx").exists())
        self.assertIn("operators", json.loads((out / "report.json").read_text(encoding="utf-8")))

    def test_shapes_match_in_1d(self):
        for formulation, points in (("mirror", 21), ("variational", 21), ("stress-point", 20)):
            with self.subTest(formulation):
                out = self.export(BAR, "--set", "formulation=" + formulation)

                G = scipy.io.mmread(out / "G_x.mtx").tocsr()
                D = scipy.io.mmread(out / "D_x.mtx").tocsr()

                self.assertEqual((G.shape, D.shape), ((points, 21), (21, points)))

    def test_thesis_shows_its_ghosts(self):
        out = self.export(BAR, "--set", "formulation=thesis")

        with h5py.File(out / "operators.h5") as file:
            particles = len(file["particles/X"])
            V = file["particles/V"][...]
            W, G, D, folded = (csr(file[name]) for name in ("W", "G_x", "D_x", "D_folded_x"))

        self.assertGreater(particles, 21)
        self.assertEqual(W.shape, (particles, particles))
        self.assertEqual(G.shape, W.shape)
        difference = abs(D - scipy.sparse.diags(V) @ G).max()
        self.assertLessEqual(difference, 1e-14 * abs(D).max())
        self.assertEqual(folded.shape, (21, 21))


if __name__ == "__main__":
    unittest.main()
