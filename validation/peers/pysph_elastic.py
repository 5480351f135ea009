#!/usr/bin/env python3
"""PySPH, its elastic scheme after Gray, Monaghan and Swift (2001): updated Lagrangian, cubic spline with
h = 1.3 spacings, artificial viscosity, XSPH and artificial stress as its own example of this plate has
them, and the same clamp: a quarter of the length more, between walls of three layers. The first call
compiles for about a minute."""

import contextlib
import io
import os
import sys
import tempfile
import time

import numpy as np

import peer
import scenes

SHARE = 0.3  # of Δ/c_p, as the example's step
WALL_LAYERS = 3


def plate_and_wall(scene, n):
    """(x, y of the plate, x, y of the walls, spacing), particles at the centres of their cells."""
    h = scene.lengths[1] / n
    along, inside = round(scene.lengths[0] / h), round(scene.lengths[0] / 4 / h)
    x = (np.arange(-inside, along) + 0.5) * h
    y = scene.corner[1] + (np.arange(n) + 0.5) * h
    plate = np.stack(np.meshgrid(x, y, indexing="ij")).reshape(2, -1)
    x = (np.arange(-inside - WALL_LAYERS, 0) + 0.5) * h
    y = scene.corner[1] + (np.arange(-WALL_LAYERS, n + WALL_LAYERS) + 0.5) * h
    wall = np.stack(np.meshgrid(x, y, indexing="ij")).reshape(2, -1)
    beside = (wall[0] < -inside * h) | (np.abs(wall[1]) > scene.lengths[1] / 2)
    return plate, wall[:, beside], h


def application(scene, n, end):
    from pysph.base.kernels import CubicSpline
    from pysph.solver.application import Application
    from pysph.sph.solid_mech.basic import ElasticSolidsScheme, get_particle_array_elastic_dynamics

    (x, y), wall, h = plate_and_wall(scene, n)
    tip = np.flatnonzero((x > scene.lengths[0] - h) & (np.abs(y) < 0.6 * h))

    class Beam(Application):
        """Takes the time from the first step to the last, and the tip's path."""

        def initialize(self):
            self.history, self.start, self.stop = [], None, None

        def create_particles(self):
            v = np.where(x > 0, scenes.BEAM_SPEED * scenes.cantilever_mode(x / scene.lengths[0]), 0.0)
            material = {"E": scene.young, "nu": scene.poisson}
            plate = get_particle_array_elastic_dynamics(
                name="plate", x=x, y=y, v=v, m=scene.density * h * h, h=1.3 * h, rho=scene.density,
                constants=dict(material, n=4, rho_ref=scene.density,
                               wdeltap=CubicSpline(dim=2).kernel(rij=h, h=1.3 * h)))
            walls = get_particle_array_elastic_dynamics(
                name="wall", x=wall[0], y=wall[1], m=scene.density * h * h, h=1.3 * h, rho=scene.density,
                constants=material)
            return [plate, walls]

        def create_scheme(self):
            scheme = ElasticSolidsScheme(elastic_solids=["plate"], solids=["wall"], dim=2)
            scheme.configure_solver(dt=SHARE * h / scene.wave_speed, tf=end, adaptive_timestep=False)
            return scheme

        def pre_step(self, solver):
            if self.start is None:
                self.start = time.perf_counter()

        def post_step(self, solver):
            self.stop = time.perf_counter()
            path = self.particles[0].y[tip] - y[tip]
            self.history.append((solver.t, float(np.mean(path))))

    return Beam(), np.count_nonzero(x > 0)


def run(scene, n, end):
    if sys.executable != "/usr/bin/python3" and os.access("/usr/bin/python3", os.X_OK):
        os.execv("/usr/bin/python3", ["/usr/bin/python3", "-B", *sys.argv])
    try:
        import pysph  # noqa: F401
    except ImportError:
        raise peer.Unable("pysph is not installed (Debian: apt-get install python3-pysph)") from None
    words = io.StringIO()
    with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(words):
        app, particles = application(scene, n, end)
        app.run(["--disable-output", "--directory", folder, "--pfreq", "1000000000",
                 "--logfile", ""])
    t, path = np.array(app.history).T
    if not np.all(np.isfinite(path)):
        raise peer.Unable(f"PySPH lost its particles at t = {t[~np.isfinite(path)][0]:.3g} s")
    return {"particles": int(particles), "steps": len(t), "repetitions": [app.stop - app.start],
            "errors": scenes.period_error(scene, np.append(0.0, t), np.append(0.0, path)),
            "note": "updated-Lagrangian SPH (Gray, Monaghan & Swift), clamped between walls"}


if __name__ == "__main__":
    sys.exit(peer.main("pysph_elastic", run, ["clamped_beam"]))
