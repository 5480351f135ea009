"""One look for every figure, and labels with a fitting unit."""

import matplotlib
import matplotlib.pyplot as plt
import matplotlib.ticker
import numpy as np

from plotting.data import PlotError

# Okabe & Ito (2008): told apart with every common kind of colour vision.
COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000"]
INK = "#222222"
FAINT = "#8a8a8a"
WIDTH = 7.2  # inches, the text width of a page

#  stem: what it is, symbol, SI unit
QUANTITIES = {
    "displacement": ("displacement", "u", "m"),
    "velocity": ("velocity", "v", "m/s"),
    "acceleration": ("acceleration", "a", "m/s²"),
    "deformation_gradient": ("deformation gradient", "F", ""),
    "pk1": ("first Piola–Kirchhoff stress", "P", "Pa"),
    "cauchy": ("Cauchy stress", r"\sigma", "Pa"),
    "pressure": ("pressure", "p", "Pa"),
    "von_mises": ("von Mises stress", r"\sigma_{\mathrm{vM}}", "Pa"),
}
PREFIXES = [(1e9, "G"), (1e6, "M"), (1e3, "k"), (1.0, ""), (1e-3, "m"), (1e-6, "µ"), (1e-9, "n")]


def use_style():
    plt.rcParams.update({
        "figure.dpi": 100, "savefig.dpi": 200, "figure.constrained_layout.use": True,
        "font.size": 9, "axes.titlesize": 9, "axes.labelsize": 9, "legend.fontsize": 8,
        "xtick.labelsize": 8, "ytick.labelsize": 8, "mathtext.fontset": "dejavusans",
        "axes.prop_cycle": matplotlib.cycler(color=COLOURS), "axes.spines.top": False, "axes.spines.right": False,
        "axes.edgecolor": INK, "axes.labelcolor": INK, "text.color": INK, "xtick.color": INK, "ytick.color": INK,
        "axes.linewidth": 0.7, "xtick.major.width": 0.7, "ytick.major.width": 0.7,
        "axes.grid": True, "grid.color": "#e4e4e4", "grid.linewidth": 0.6, "axes.axisbelow": True,
        "lines.linewidth": 1.4, "lines.solid_capstyle": "round", "legend.frameon": False, "svg.fonttype": "path",
    })


def split_quantity(name):
    """('cauchy', 'xx') of cauchy_xx; the suffix is empty for a scalar."""
    if name in QUANTITIES:
        return name, ""
    stem, _, suffix = name.rpartition("_")
    return (stem, suffix) if stem in QUANTITIES else (name, "")


def symbol(name):
    """Mathematical symbol of a quantity, empty for one that is not known."""
    stem, suffix = split_quantity(name)
    if stem not in QUANTITIES:
        return ""
    letter = QUANTITIES[stem][1]
    if suffix == "magnitude":
        return rf"$|{letter}|$"
    return rf"${letter}_{{{suffix}}}$" if suffix else f"${letter}$"


def prefix(values, unit):
    """(factor, unit with prefix) that brings the largest of the values between 1 and 1000."""
    values = np.abs(np.asarray(values, dtype=float))
    largest = np.max(values[np.isfinite(values)], initial=0.0)
    if not unit or largest == 0.0:
        return 1.0, unit
    # 0.9995: a value that would print as 1000 counts as one of the next prefix
    for factor, letter in PREFIXES:
        if largest >= 0.9995 * factor:
            return 1.0 / factor, letter + unit
    return 1.0, unit


def label(name, unit):
    """Axis label such as 'Cauchy stress σ_xx [kPa]'."""
    stem, _ = split_quantity(name)
    words = QUANTITIES[stem][0] if stem in QUANTITIES else name.replace("_", " ")
    return " ".join(part for part in (words, symbol(name), f"[{unit}]" if unit else "") if part)


def unit_of(name):
    stem, _ = split_quantity(name)
    return QUANTITIES[stem][2] if stem in QUANTITIES else ""


def time_axis(times):
    """(factor, unit) for a time axis."""
    return prefix(times, "s")


def significant(value, digits=3):
    """Number for people: 0.0123, 45.6, 7.89e-08."""
    text = f"{value:.{digits}g}"
    return text.replace("e-0", "e-").replace("e+0", "e").replace("e-", "e−").replace("-", "−")


def scientific(value, _=None):
    """Tick label: plain where that is short, else 2×10⁻⁵."""
    if value == 0.0 or 1e-2 <= abs(value) < 1e4:
        return f"${value:g}$"
    mantissa, exponent = f"{value:e}".split("e")
    front = {"1": "", "-1": "-"}.get(f"{float(mantissa):g}", rf"{float(mantissa):g}\times")
    return f"${front}10^{{{int(exponent)}}}$"


def readable_log_axis(axis, values):
    """Plain numbers at 1, 2, 5 where less than two decades are shown; powers of ten elsewhere."""
    values = np.asarray(values)
    values = values[values > 0]
    if len(values) and np.log10(values.max() / values.min()) < 2:
        axis.set_minor_locator(matplotlib.ticker.LogLocator(subs=(2, 5)))
        axis.set_minor_formatter(matplotlib.ticker.FuncFormatter(scientific))
        axis.set_major_formatter(matplotlib.ticker.FuncFormatter(scientific))


def heading(figure, title):
    if title:
        figure.suptitle(title, fontsize=11, fontweight="bold")


def save(figure, path):
    if path.suffix.lower() not in (".png", ".svg", ".pdf"):
        raise PlotError(f"{path}: the suffix must be .png, .svg or .pdf")
    path.parent.mkdir(parents=True, exist_ok=True)
    metadata = {"Date": None} if path.suffix.lower() == ".svg" else None
    figure.savefig(path, metadata=metadata, facecolor="white")
    plt.close(figure)
    return path
