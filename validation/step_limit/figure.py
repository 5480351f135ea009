"""Histories below, at and above the limit, a column a formulation; below amplitudes over the steps, and growing motions."""

import matplotlib.pyplot as plt
import numpy as np

from plotting import bar
from plotting.case import table
from plotting.style import COLOURS, FAINT, INK, WIDTH

STEPS = {"below": "half the limit", "at": "at the limit", "above": "1.02 × limit"}
POINTS = {"p1": "0", "p2": "0.05 m", "p3": "0.10 m", "p4": "0.15 m"}
CLOSURES = ["thesis, consistent", "thesis, as printed", "thesis, η", "mirror"]


def draw(folder):
    figure = plt.figure(figsize=(WIDTH, 5.4))
    head, panels, lower = bar.grid(figure, 3, 4, heights=[2.2, 1.15])
    bar.legend(head, POINTS.values(), exact=None)
    bar.titles(panels, ["thesis, as printed", *bar.FORMULATIONS[1:]])
    for row, (step, words) in zip(panels, STEPS.items()):
        for axes, formulation in zip(row, bar.FORMULATIONS):
            bar.stresses(axes, folder / f"{formulation}-{step}", POINTS, cut=1000)
        row[0].set_ylabel(f"{words}\n$P$ [kPa]")
    panels[0, 0].set(xlim=(0, 44), ylim=(-275, 65), yticks=[-200, -100, 0])
    left, right = lower.subplots(1, 2)
    amplitudes(left, folder)
    motions(right, table(folder / "spectrum.csv"))
    return figure


def amplitudes(axes, folder):
    """The largest stress so far at 0.05 m."""
    for k, formulation in list(enumerate(bar.FORMULATIONS))[1:]:
        for name, dashes in ("below", (None, None)), ("above", (4, 1.5)):
            run = table(folder / f"{formulation}-long-{name}" / "probes.csv")
            draw_amplitude(axes, run, color=COLOURS[k], dashes=dashes)
    draw_amplitude(axes, table(folder / "thesis-long-consistent" / "probes.csv"), color=COLOURS[0])
    axes.set(yscale="log", xlim=(0, 1200), ylim=(1e-3, 1e21), xlabel="steps", ylabel="largest $|P|$ / 100 kPa")
    axes.text(0.30, 0.88, "1.02 × limit", transform=axes.transAxes, color=FAINT, fontsize=8)
    axes.text(0.30, 0.60, "thesis, consistent,\n5.5 Δ, 0.9 × limit", transform=axes.transAxes, color=COLOURS[0], fontsize=8)
    axes.text(0.97, 0.02, "0.99 × limit", transform=axes.transAxes, color=FAINT, fontsize=8, ha="right")


def draw_amplitude(axes, run, **style):
    values = np.abs(run["p2.pk1_xx"]) / 1e5
    values = np.maximum.accumulate(np.clip(values[np.isfinite(values)], 0, 1e30))
    axes.plot(values, linewidth=1.1, **style)


def motions(axes, data):
    """Growth of the motions e^{st} against their frequency; a motion that grows has a twin that decays."""
    for number, (text, marker) in enumerate(zip(CLOSURES, "o^sD")):
        mine = data["closure"] == number
        colour = [COLOURS[0], COLOURS[5], COLOURS[4], COLOURS[1]][number]
        axes.plot(data["frequency"][mine], np.abs(data["growth"][mine]), marker, markersize=3, color=colour, label=text)
    axes.axhline(0.0, color=INK, linewidth=0.5)
    axes.set(xlabel="frequency [$c/Δ$]", ylabel="growth [$c/Δ$]")
    axes.set_yscale("symlog", linthresh=1e-5)
    axes.set(ylim=(-1e-6, 3e-2), yticks=[0, 1e-5, 1e-4, 1e-3, 1e-2])
    axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5), handlelength=0.8, title="support 5.5 Δ",
                title_fontsize=8)
