"""the stability atlas: where methods fail, how waves travel, what runs say of the spectra"""

import csv
import json
from pathlib import Path

import matplotlib.patches
import matplotlib.pyplot as plt
import numpy as np

from plotting.data import PlotError
from plotting.style import COLOURS, FAINT, INK, WIDTH

#  verdict: colour, letter, words. Told apart by lightness too, and by the letter.
VERDICTS = {
    "stable": ("#cfe8dc", "", "stable"),
    "material": ("#bdbdbd", "m", "material not hyperbolic"),
    "negative": (COLOURS[1], "N", r"$\omega^2 < 0$, numerical"),
    "growing": (COLOURS[3], "G", "growing, no adjoint"),
    "soft": (COLOURS[4], "s", "modes without energy"),
    "refused": ("#4d4d4d", "R", "cannot be built"),
}
#  Methods whose waves are drawn, where the atlas has them.
SHEET_WAVES = ["stress-point cells + S", "variational 1.5 + S", "variational 2.5", "variational 5.5 + S"]
BAR_WAVES = ["stress-point", "variational 1.5", "mirror 2.5", "variational 2.5 + S", "mirror 5.5", "thesis consistent 5.5"]


def arguments(parser):
    parser.add_argument("data", type=Path, metavar="STABILITY.json", help="what `tlsph stability` wrote")


def read(path):
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except json.JSONDecodeError as error:
        raise PlotError(f"{path}: no JSON: {error}") from None


def draw(options):
    atlas = read(options.data)
    for key in ("rows", "waves", "crush", "dimension"):
        if key not in atlas:
            raise PlotError(f"{options.data}: no \"{key}\"; is it the stability.json of tlsph stability?")
    rows = [row for row in atlas["rows"] if row["body"] == "scene"]
    waves = read_waves(options.data.with_name("waves.csv"), atlas["dimension"])
    methods = list(dict.fromkeys(row["method"] for row in rows))
    heights = ([0.155 * len(methods) + 1.0] if rows else []) + ([2.1] if waves else []) + ([2.5] if rows else [])
    if not heights:
        raise PlotError(f"{options.data}: no states and no waves to draw")
    figure = plt.figure(figsize=(WIDTH, sum(heights)))
    parts = iter(figure.subfigures(len(heights), 1, height_ratios=heights, squeeze=False)[:, 0])
    if rows:
        draw_states(next(parts), rows, methods)
    if waves:
        part = next(parts)
        draw_zone(part, waves) if atlas["dimension"] == 2 else draw_curves(part, waves)
    if rows:
        draw_runs(next(parts), atlas, rows)
    return figure, options.data.with_suffix(".png")


def read_waves(path, dimension):
    """{method: array of rows (kΔ…, c/c₀…)}, empty without the file."""
    if not path.exists():
        return {}
    table = {}
    with open(path, encoding="utf-8", newline="") as file:
        for row in csv.reader(file):
            if row[0] != "method":
                table.setdefault(row[0], []).append([float(x) for x in row[2:2 + 2 * dimension]])
    return {method: np.array(values) for method, values in table.items()}


def draw_states(part, rows, methods):
    """A square a state: methods downwards, layouts, Poisson ratios and stretches across."""
    columns = sorted({(row["jitter"], row["poisson"], row["stretch"]) for row in rows})
    places, x = {}, 0.0
    for before, column in zip([None] + columns, columns):
        if before and before[0] != column[0]:
            x += 1.2
        elif before and before[1] != column[1]:
            x += 0.5
        places[column] = x
        x += 1.0
    axes = part.subplots()
    for row in rows:
        colour, letter, _ = VERDICTS[row["verdict"]]
        at = places[row["jitter"], row["poisson"], row["stretch"]], methods.index(row["method"])
        axes.add_patch(matplotlib.patches.Rectangle((at[0] - 0.46, at[1] - 0.42), 0.92, 0.84, color=colour, lw=0))
        if letter and row["verdict"] != "material":
            axes.text(*at, letter, ha="center", va="center", fontsize=5, color="white")
    axes.set(xlim=(-0.8, x - 0.2), ylim=(len(methods) - 0.4, -0.6))
    axes.set_yticks(range(len(methods)), methods, fontsize=6.5)
    axes.set_xticks([places[c] for c in columns], [f"{c[2]:g}" for c in columns], fontsize=4.6, rotation=90)
    axes.set_xlabel("stretch of the first direction", fontsize=7)
    axes.tick_params(length=0, pad=1)
    axes.grid(False)
    for spine in axes.spines.values():
        spine.set_visible(False)
    for group, y, words in (((0, 1), -1.0, r"$\nu$ = {:g}"), ((0,), -2.1, "jitter {:g} Δ")):
        for key in dict.fromkeys(tuple(c[k] for k in group) for c in columns):
            inside = [places[c] for c in columns if tuple(c[k] for k in group) == key]
            axes.text(np.mean(inside), y, words.format(key[-1]), ha="center", va="center", fontsize=6, color=INK,
                      clip_on=False)
    used = {row["verdict"] for row in rows}
    handles = [matplotlib.patches.Patch(color=colour, label=f"{letter}  {words}" if letter else words)
               for name, (colour, letter, words) in VERDICTS.items() if name in used]
    axes.legend(handles=handles, ncol=3, loc="upper center", bbox_to_anchor=(0.45, -0.5 / len(methods) - 0.06),
                fontsize=6.2, handlelength=1.2, columnspacing=1.2)


def draw_zone(part, waves):
    """Phase-speed error over the Brillouin zone: a quarter of it, longitudinal above, transverse below."""
    chosen = [m for m in SHEET_WAVES if m in waves] or list(waves)[:4]
    panels = part.subplots(1, 2 * len(chosen), sharex=True, sharey=True, squeeze=False)[0]
    levels = np.linspace(-1.0, 1.0, 21)
    image = None
    for index, method in enumerate(chosen):
        values = waves[method]
        angles = int(np.sum(np.isclose(np.hypot(values[:, 0], values[:, 1]), np.hypot(*values[0, :2]))))
        grid = values.reshape(angles, -1, 4)
        for column, (name, speed) in enumerate((("longitudinal", 3), ("transverse", 2))):
            axes = panels[2 * index + column]
            image = axes.contourf(grid[..., 0] / np.pi, grid[..., 1] / np.pi, np.clip(grid[..., speed] - 1, -1, 1),
                                  levels=levels, cmap="RdBu_r")
            axes.contour(grid[..., 0] / np.pi, grid[..., 1] / np.pi, np.abs(grid[..., speed] - 1), levels=[0.01, 0.1],
                         colors=INK, linewidths=0.5)
            axes.set_title(f"{method}\n{name}" if column == 0 else f"\n{name}", fontsize=5.6)
            axes.set_aspect("equal")
            axes.set(xticks=[0, 1], yticks=[0, 1])
            axes.tick_params(labelsize=6, pad=1)
            axes.grid(False)
    panels[0].set_ylabel(r"$k_y\Delta/\pi$", fontsize=7)
    for axes in panels:
        axes.set_xlabel(r"$k_x\Delta/\pi$", fontsize=6)
    bar = part.colorbar(image, ax=panels, shrink=0.6, aspect=14, ticks=[-1, -0.5, 0, 0.5, 1])
    bar.set_label(r"$c/c_0 - 1$", fontsize=7)
    bar.ax.tick_params(labelsize=6)


def draw_curves(part, waves):
    axes = part.subplots()
    for method in [m for m in BAR_WAVES if m in waves] or list(waves)[:6]:
        values = waves[method]
        axes.plot(values[:, 0] / np.pi, values[:, 1], label=method, ls="--" if method.startswith("variational") else "-")
    axes.set(xlabel=r"wave number $k\Delta/\pi$", ylabel=r"phase speed $c/c_0$", xlim=(0, 1), ylim=(0, None))
    axes.legend(fontsize=6.5, loc="center left", bbox_to_anchor=(1.0, 0.5))


def draw_runs(part, atlas, rows):
    growth, step, crush = part.subplots(1, 3)
    for number, (label, words) in enumerate((("0.95", "0.95 of the critical step"), ("1.02", "1.02 of it"),
                                             ("h/c", "step h/c"))):
        pairs = [(run["growth_expected"], run["growth_seen"]) for row in rows for run in row["runs"]
                 if run["label"] == label and run["growth_expected"] and run["growth_seen"]]
        pairs = np.array([p for p in pairs if p[0] > 1e-4 and p[1] > 1e-4])
        if len(pairs):
            growth.loglog(*pairs.T, "o", ms=2.4, mew=0, alpha=0.6, color=COLOURS[number], label=words)
    growth.loglog([1e-3, 5], [1e-3, 5], "-", color=FAINT, lw=0.7, zorder=0)
    growth.set(xlabel="growth a step, spectrum", ylabel="growth a step, run")
    growth.legend(fontsize=5.8, handletextpad=0.2)

    shares = [row["critical_step"] / row["true_limit"] for row in rows
              if row["critical_step"] and row["true_limit"] and row["verdict"] != "material"]
    step.hist(shares, bins=np.linspace(0.995, 1.005, 41), color=COLOURS[0])
    step.axvline(1.0, color=INK, lw=0.7)
    step.set(xlabel="computed critical step / true limit", ylabel="states")
    step.set_xticks([0.996, 0.998, 1.0, 1.002, 1.004], ["0.996", "0.998", "1", "1.002", "1.004"], fontsize=6.5)

    followed = [row for row in atlas["crush"] if row["follow"] == "followed" and row["closest"] is not None]
    left = [row for row in atlas["crush"] if row["follow"] != "followed"]
    for shown, colour, words in ((left, COLOURS[1], "the first step"), (followed, COLOURS[0], "followed")):
        for lost, marker in ((True, "x"), (False, "o")):
            points = [(row["closest"], row["smallest_det_F"]) for row in shown if bool(row["failure"]) == lost]
            if points:
                x, y = np.array(points).T
                crush.semilogx(x, np.maximum(y, -0.2), marker, ms=3.5, color=colour, ls="none",
                               label=words + (", lost" if lost else ", to the end"))
    crush.axhline(0.0, color=INK, lw=0.7)
    crush.axvline(1.0, color=FAINT, lw=0.7)
    crush.set_xticks([1, 2, 4, 8, 16], ["1", "2", "4", "8", "16"])
    crush.minorticks_off()
    crush.set(xlabel=r"largest $\Delta t/\Delta t_{\mathrm{crit}}$ on the way", ylabel=r"smallest det $F$ (≥ −0.2 drawn)")
    if followed or left:
        crush.legend(fontsize=5.8, handletextpad=0.2, loc="center right", frameon=True, framealpha=1.0, edgecolor="none")
