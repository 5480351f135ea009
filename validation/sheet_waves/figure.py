"""Histories of the strain and the stress wave against the pulse at the speeds of theory."""

import matplotlib.pyplot as plt
import numpy as np
from scipy.special import erf

from plotting.case import table
from plotting.style import COLOURS, FAINT, INK, WIDTH

YOUNG, POISSON, DENSITY = 200e9, 0.3, 8000
METHODS = {  # colour, dashes that let the lines below show
    "stress-point": (COLOURS[0], "-"), "variational": (COLOURS[1], (0, (4, 8))), "mirror": (COLOURS[2], (4, (4, 8))),
    "thesis": (COLOURS[3], (8, (4, 8)))}
PLACES = ("p2", 0.05), ("p3", 0.10)
BAR = np.sqrt(YOUNG / DENSITY)
PANELS = [  # scene, title, speed, that of the source if it is another
    ("strain", "Strain wave: the sides cannot move",
     BAR * np.sqrt((1 - POISSON) / (1 + POISSON) / (1 - 2 * POISSON)), None),
    ("plane-strain", "Stress wave in plane strain: free sides", BAR / np.sqrt(1 - POISSON**2), BAR),
    ("plane-stress", "Stress wave in plane stress: free sides", BAR, None),
]


def pulse(t, rise=1.5e-6, duration=8e-6):
    """The load on the left [kPa]."""
    return 50 * (erf((t - 3 * rise) / rise) - erf((t - 3 * rise - duration) / rise))


def draw(folder):
    figure, panels = plt.subplots(3, 1, figsize=(0.87 * WIDTH, 4.6), sharex=True, sharey=True)
    t = np.linspace(5e-6, 34e-6, 1500)
    for axes, (scene, title, speed, claimed) in zip(panels, PANELS):
        for name, (colour, dashes) in METHODS.items():
            if not (folder / f"{scene}-{name}").is_dir():
                continue
            columns = table(folder / f"{scene}-{name}" / "probes.csv")
            shown = columns["time"] < 34e-6
            for probe, _ in PLACES:
                axes.plot(1e6 * columns["time"][shown], 1e-3 * columns[f"{probe}.pk1_xx"][shown], color=colour,
                          linestyle=dashes, label=name if probe == "p2" else None)
        for probe, x in PLACES:
            axes.plot(1e6 * t, pulse(t - x / speed), color=INK, linewidth=0.8, linestyle=":",
                      label=f"pulse at {speed:.0f} m/s" if probe == "p2" else None)
            if claimed:
                axes.plot(1e6 * t, pulse(t - x / claimed), color=FAINT, linewidth=0.8, linestyle="--",
                          label=f"pulse at {claimed:.0f} m/s (thesis)" if probe == "p2" else None)
        axes.set(title=title, ylabel="$P_{xx}$ [kPa]", xlim=(0, 34.2), ylim=(-15, 135), yticks=[0, 50, 100])
        axes.legend(loc="upper left")
    for x, at in ((0.05, 15.8), (0.10, 25.5)):
        panels[0].annotate(f"at {x:.2f} m", (at, 112), ha="center")
    panels[-1].set_xlabel("time $t$ [µs]")
    return figure
