#!/usr/bin/env python3
"""The stress at the edge of the hole of examples/plate_with_hole.toml, from finite elements at rest.

A quarter of a square sheet (half width 5 hole radii, as long as wide) is pulled at X = 5 by a dead
traction t per reference area; X = 0 and Y = 0 are planes of symmetry; plane strain. Nine-node
quadrilaterals (3 x 3 Gauss points) lie on a polar map from the hole to the outer square, refined
towards the hole; Newton's method finds the equilibrium of

    linear elastic    P = lambda tr(e) I + 2 mu e
    Neo-Hookean       P = mu (F - F^-T) + lambda ln(J) F^-T

and the answer is read at A = (0, 1), the top of the hole: the stretch along the edge there, and from
it the Cauchy stress along the pull, because the edge itself is free (P_YY = 0). It shares no code
with the program it checks. Lengths are in hole radii (10 mm), stresses in units of Young's modulus
(70 MPa).

    python3 validation/sheet_with_hole/stress_concentration.py

prints, for 8 x 8, 16 x 16 and 32 x 32 elements: linear elastic sigma/t = 3.354, 3.359, 3.360 at
small strains, whatever Poisson's ratio (a strip of endless length has 3.14, an endless sheet 3);
Neo-Hookean at 5 MPa sigma = 16.72, 16.74, 16.74 MPa, and the middle of the pulled edge moves by
3.524, 3.532, 3.534 mm.
"""

import numpy as np
import scipy.sparse as sp
from scipy.optimize import brentq
from scipy.sparse.linalg import spsolve

HALF_WIDTH = 5.0
CORNERS = np.array([-1.0, 0.0, 1.0])
GAUSS = np.sqrt(0.6) * CORNERS
WEIGHTS = np.array([5.0, 8.0, 5.0]) / 9.0


def parabolas(x):
    """Values and derivatives of the three quadratic shape functions on -1, 0, 1."""
    return (
        np.array([x * (x - 1) / 2, 1 - x * x, x * (x + 1) / 2]),
        np.array([x - 0.5, -2 * x, x + 0.5]),
    )


def polar_map(n):
    """Nodes (…, 2) and the 9 nodes of each of the n x n elements; rows along the angle."""
    angles = np.linspace(0.0, np.pi / 2, 2 * n + 1)
    s = np.expm1(3 * np.linspace(0.0, 1.0, 2 * n + 1)) / np.expm1(3.0)
    hole = np.stack([np.cos(angles), np.sin(angles)], axis=-1)
    square = HALF_WIDTH * hole / abs(hole).max(axis=1, keepdims=True)
    X = (hole[:, None] + (square - hole)[:, None] * s[:, None]).reshape(-1, 2)
    number = np.arange(len(X)).reshape(2 * n + 1, 2 * n + 1)
    elements = np.array(
        [
            number[i : i + 3, j : j + 3].ravel()
            for i in range(0, 2 * n, 2)
            for j in range(0, 2 * n, 2)
        ]
    )
    return X, number, elements


def gradients(X, elements, eta, xi):
    """dN/dX of the 9 nodes (elements, 9, 2) and the determinant of the map at one parent point."""
    (a, da), (b, db) = parabolas(eta), parabolas(xi)
    d = np.stack([np.outer(da, b).ravel(), np.outer(a, db).ravel()], axis=-1)
    J = np.einsum("eni,na->eia", X[elements], d)
    return np.einsum("na,eai->eni", d, np.linalg.inv(J)), abs(np.linalg.det(J))


def linear_elastic(F, lame, mu):
    """P and its derivative dP_ia/dF_jb (plane strain)."""
    I = np.eye(2)
    tangent = (
        lame * np.einsum("ia,jb->iajb", I, I)
        + mu * np.einsum("ij,ab->iajb", I, I)
        + mu * np.einsum("ib,aj->iajb", I, I)
    )
    return np.einsum("iajb,ejb->eia", tangent, F - I), np.broadcast_to(tangent, (len(F), 2, 2, 2, 2))


def neo_hookean(F, lame, mu):
    """P and its derivative dP_ia/dF_jb (plane strain)."""
    I = np.eye(2)
    R = np.linalg.inv(F).transpose(0, 2, 1)  # F^-T
    pressure = (lame * np.log(np.linalg.det(F)))[:, None, None]
    tangent = (
        mu * np.einsum("ij,ab->iajb", I, I)
        + (mu - pressure[..., None, None]) * np.einsum("eib,eja->eiajb", R, R)
        + lame * np.einsum("eia,ejb->eiajb", R, R)
    )
    return mu * (F - R) + pressure * R, tangent


def edge_stress(law, stretch, lame, mu):
    """Cauchy stress along a free edge, given the stretch along it: P_YY = 0 gives that across."""

    def pk1(across):
        return law(np.diag([stretch, across])[None], lame, mu)[0][0]

    across = brentq(lambda y: pk1(y)[1, 1], 0.2, 2.0, xtol=1e-14)
    return pk1(across)[0, 0] / (1.0 if law is linear_elastic else across)


def stress_at_hole(law, n, traction, poisson, load_steps=1):
    """Cauchy stress along the pull at A and displacement of (5, 0); E = 1, n x n elements."""
    lame, mu = poisson / (1 + poisson) / (1 - 2 * poisson), 0.5 / (1 + poisson)
    X, number, elements = polar_map(n)
    dofs = (2 * elements[:, :, None] + np.arange(2)).reshape(len(elements), -1)
    points = [
        (weight_i * weight_j, *gradients(X, elements, eta, xi))
        for eta, weight_i in zip(GAUSS, WEIGHTS)
        for xi, weight_j in zip(GAUSS, WEIGHTS)
    ]

    load = np.zeros(2 * len(X))
    for i in range(0, n, 2):  # element edges with angles up to 45 degrees lie on X = 5
        edge = number[i : i + 3, -1]
        for g, weight in zip(GAUSS, WEIGHTS):
            N, dN = parabolas(g)
            load[2 * edge] += weight * traction * N * (dN @ X[edge, 1])
    free = np.ones(2 * len(X), dtype=bool)
    free[2 * number[-1]] = False  # u_x = 0 on X = 0
    free[2 * number[0] + 1] = False  # u_y = 0 on Y = 0

    def deformation(u, dN, some=slice(None)):
        return np.eye(2) + np.einsum("eni,ena->eia", u.reshape(-1, 2)[elements[some]], dN)

    u = np.zeros(2 * len(X))
    for share in np.linspace(0.0, 1.0, load_steps + 1)[1:]:
        for _ in range(20):
            force, blocks = share * load, 0.0
            for weight, dN, J in points:
                P, tangent = law(deformation(u, dN), lame, mu)
                f = np.einsum("eia,ena,e->eni", P, dN, weight * J)
                np.subtract.at(force, dofs.ravel(), f.ravel())
                blocks = blocks + np.einsum(
                    "ena,eiajb,emb,e->enimj", dN, tangent, dN, weight * J, optimize=True
                )
            if np.linalg.norm(force[free]) <= 1e-9 * np.linalg.norm(load):
                break
            rows, columns = np.broadcast_arrays(dofs[:, :, None], dofs[:, None, :])
            K = sp.csc_matrix((blocks.ravel(), (rows.ravel(), columns.ravel())), (len(u), len(u)))
            u[free] += spsolve(K[free][:, free], force[free])
        else:
            raise RuntimeError("Newton's method did not converge")

    last = slice((n - 1) * n, (n - 1) * n + 1)  # its corner eta = 1, xi = -1 is A
    dN, _ = gradients(X, elements[last], 1.0, -1.0)
    stretch = deformation(u, dN, last)[0, 0, 0]
    return edge_stress(law, stretch, lame, mu), u[2 * number[0, -1]]


def main():
    print("elements  linear elastic: sigma_A/t  Neo-Hookean at 5 MPa: sigma_A [MPa]  edge [mm]")
    for n in (8, 16, 32):
        factor = stress_at_hole(linear_elastic, n, traction=1e-3, poisson=0.49)[0] / 1e-3
        stress, edge = stress_at_hole(neo_hookean, n, 5.0 / 70.0, poisson=0.49, load_steps=2)
        print(f"{n:3d} x {n:<3d} {factor:22.4f} {70 * stress:30.3f} {10 * edge:18.4f}")


if __name__ == "__main__":
    main()
