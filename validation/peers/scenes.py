"""The scenes peers run, and one measure of error for all of them: that of `tlsph run`.

A scene is examples/<name>.toml told in numbers: what lies on a lattice of `n` cells, what is held, how
it starts, and what must come out. Displacements and velocities are compared at the nodes, stress at
the points where a peer has it, in relative L2 with volumes as weights; the beam by the period of its
tip, from a straight line through the times at which it passes zero.
"""

import math
from dataclasses import dataclass, field

import numpy as np


@dataclass
class Scene:
    name: str
    dimension: int
    young: float
    poisson: float
    density: float
    law: str
    lengths: tuple  # of the box [m]
    corner: tuple
    end: float
    across: int  # direction along which `n` counts cells
    answer: dict = field(default_factory=dict)

    @property
    def lame(self):
        mu = self.young / (2 * (1 + self.poisson))
        return self.young * self.poisson / ((1 + self.poisson) * (1 - 2 * self.poisson)), mu

    @property
    def wave_speed(self):
        lam, mu = self.lame
        return math.sqrt((lam + 2 * mu) / self.density)

    def cells(self, spacing):
        return max(1, round(self.lengths[self.across] / spacing))

    def counts(self, n):
        """Cells in each direction, squares."""
        return [max(1, round(length / self.lengths[self.across] * n)) for length in self.lengths]


PLATE_AMPLITUDE = 5e-4
BEAM_SPEED = 0.0246177
PULSE = {"amplitude": -100e3, "duration": 8e-6, "rise": 1e-6}

SCENES = {
    "clamped_beam": Scene("clamped_beam", 2, 2e6, 0.3975, 1000.0, "neo-hookean", (0.2, 0.02), (0.0, -0.01), 0.8, 1,
                          {"tip.displacement_y.period": 0.25523}),
    "swinging_plate": Scene("swinging_plate", 2, 17e6, 0.3, 1100.0, "linear-elastic", (1.0, 1.0), (0.0, 0.0), 2e-3, 0),
    "bar_wave": Scene("bar_wave", 1, 200e9, 0.3, 8000.0, "neo-hookean", (0.15,), (0.0,), 40e-6, 0),
}


@dataclass
class Lattice:
    """Nodes at the corners of cells: positions N×D, volumes N, corners E×2^D in cyclic order."""
    X: np.ndarray
    V: np.ndarray
    corners: np.ndarray
    spacing: float


def lattice(scene, n):
    counts = scene.counts(n)
    axes = [c + np.linspace(0.0, length, k + 1) for c, length, k in zip(scene.corner, scene.lengths, counts)]
    X = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, scene.dimension)
    shares = [np.full(k + 1, length / k) for length, k in zip(scene.lengths, counts)]
    for share in shares:
        share[[0, -1]] *= 0.5
    V = shares[0] if scene.dimension == 1 else np.outer(*shares).ravel()
    row = np.arange(len(X)).reshape([k + 1 for k in counts])
    if scene.dimension == 1:
        corners = np.stack([row[:-1], row[1:]], axis=-1)
    else:
        corners = np.stack([row[:-1, :-1], row[1:, :-1], row[1:, 1:], row[:-1, 1:]], axis=-1).reshape(-1, 4)
    return Lattice(X, V, corners, scene.lengths[scene.across] / counts[scene.across])


def free_components(scene, X):
    """N×D, True where a node may move."""
    free = np.ones(X.shape, bool)
    tolerance = 1e-9 * scene.lengths[0]
    if scene.name == "clamped_beam":
        free[np.abs(X[:, 0]) < tolerance] = False
    elif scene.name == "swinging_plate":
        low, high = np.abs(X) < tolerance, np.abs(X - 1.0) < tolerance
        free[low[:, 0], 0] = free[low[:, 1], 1] = False
        free[high[:, 0], 1] = free[high[:, 1], 0] = False
    else:
        free[np.abs(X[:, 0] - scene.lengths[0]) < tolerance] = False
    return free


def cantilever_mode(xi):
    k = 1.875104068711961
    s = k * xi
    sigma = (math.cosh(k) + math.cos(k)) / (math.sinh(k) + math.sin(k))
    return 0.5 * (np.cosh(s) - np.cos(s) - sigma * (np.sinh(s) - np.sin(s)))


def plate_mode(X):
    s, c = np.sin(0.5 * np.pi * X), np.cos(0.5 * np.pi * X)
    return np.stack([-s[:, 0] * c[:, 1], c[:, 0] * s[:, 1]], axis=1)


def initial(scene, X):
    """(displacement, velocity) at t = 0."""
    u, v = np.zeros_like(X), np.zeros_like(X)
    if scene.name == "clamped_beam":
        v[:, 1] = BEAM_SPEED * cantilever_mode(X[:, 0] / scene.lengths[0])
    elif scene.name == "swinging_plate":
        u = PLATE_AMPLITUDE * plate_mode(X)
    return u, v


def pulse(t):
    """Traction on the left end of the bar [Pa]."""
    on = (np.asarray(t, float) - 3 * PULSE["rise"]) / PULSE["rise"]
    erf = np.vectorize(math.erf)
    return 0.5 * PULSE["amplitude"] * (erf(on) - erf(on - PULSE["duration"] / PULSE["rise"]))


def pulse_integral(t):
    length = PULSE["duration"] / PULSE["rise"]
    erfc = np.vectorize(math.erfc)

    def step(x):
        return np.exp(-x * x) / math.sqrt(math.pi) + x * erfc(-x)

    def both(x):
        return step(x) - step(x - length)

    on = (np.asarray(t, float) - 3 * PULSE["rise"]) / PULSE["rise"]
    return 0.5 * PULSE["amplitude"] * PULSE["rise"] * (both(on) - both(np.float64(-3.0)))


def exact(scene, X, t):
    """(displacement N×D, velocity N×D, stress N×D×D), None for the beam."""
    if scene.name == "clamped_beam":
        return None
    lam, mu = scene.lame
    if scene.name == "swinging_plate":
        omega = 0.5 * np.pi * math.sqrt(2 * mu / scene.density)
        cosines = np.cos(0.5 * np.pi * X)
        strain = 0.5 * np.pi * PLATE_AMPLITUDE * math.cos(omega * t) * cosines[:, 0] * cosines[:, 1]
        P = np.zeros((len(X), 2, 2))
        P[:, 0, 0], P[:, 1, 1] = -2 * mu * strain, 2 * mu * strain
        mode = PLATE_AMPLITUDE * plate_mode(X)
        return math.cos(omega * t) * mode, -omega * math.sin(omega * t) * mode, P
    # d'Alembert with images: loaded on the left, fixed on the right
    c, length = scene.wave_speed, scene.lengths[0]
    impedance = scene.density * c
    u, v, P = (np.zeros(len(X)) for _ in range(3))
    for k in range(int(t * c / (2 * length)) + 2):
        for delay, back in ((2 * k * length + X[:, 0], False), (2 * (k + 1) * length - X[:, 0], True)):
            arrived = np.where(t - delay / c > 0, t - delay / c, -1.0)
            on = arrived >= 0
            sign = (-1.0) ** k
            u += np.where(on, sign * (-1.0 if back else 1.0) * pulse_integral(np.maximum(arrived, 0)), 0.0)
            v += np.where(on, sign * (-1.0 if back else 1.0) * pulse(np.maximum(arrived, 0)), 0.0)
            P += np.where(on, sign * pulse(np.maximum(arrived, 0)), 0.0)
    return -u[:, None] / impedance, -v[:, None] / impedance, P[:, None, None]


def relative(values, truth, volumes):
    weight = volumes.reshape([-1] + [1] * (truth.ndim - 1))
    return float(math.sqrt(np.sum(weight * (values - truth) ** 2) / np.sum(weight * truth ** 2)))


def field_errors(scene, t, nodes, volumes, u, v, points, point_volumes, stress):
    at_nodes, at_points = exact(scene, nodes, t), exact(scene, points, t)
    return {"displacement": relative(u, at_nodes[0], volumes), "velocity": relative(v, at_nodes[1], volumes),
            "stress": relative(stress, at_points[2], point_volumes)}


def mean_period(time, values):
    """Period of an oscillation about zero, from the straight line through its passages; nan without one."""
    time, values = np.asarray(time), np.asarray(values)
    before, after = values[:-1], values[1:]
    passing = (before * after < 0) | ((after == 0) & (before != 0))
    at = (time[:-1] + np.diff(time) * before / np.where(before == after, 1.0, before - after))[passing]
    return 2 * float(np.polyfit(np.arange(len(at)), at, 1)[0]) if len(at) >= 3 else math.nan


def period_error(scene, time, values):
    """Relative error of the tip's period, its sign kept."""
    (name, answer), = scene.answer.items()
    return {name: mean_period(time, values) / answer - 1.0}
