"""The figure of a validation case, from the folder that `tlsph validate` left.

The folder has the name of the case; `draw(folder)` of validation/<case>/figure.py returns the figure.
"""

import csv
import importlib.util
from pathlib import Path

import numpy as np

from .data import PlotError

CASES = Path(__file__).resolve().parents[1]


def table(path):
    """{column: values} of a table of numbers that a case wrote."""
    try:
        with open(path, encoding="utf-8", newline="") as file:
            header, *rows = csv.reader(file)
    except OSError as error:
        raise PlotError(f"{path}: {error.strerror}") from error
    columns = zip(*rows) if rows else [[] for _ in header]
    return {name: np.array(values, dtype=float) for name, values in zip(header, columns)}


def arguments(parser):
    parser.add_argument("data", type=Path, metavar="FOLDER", help="what the case left, out/validation/<case>")


def draw(options):
    script = CASES / options.data.name / "figure.py"
    if not script.is_file():
        raise PlotError(f"{script}: there is no such case, or it has no figure")
    specification = importlib.util.spec_from_file_location(f"case_{options.data.name}", script)
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module.draw(options.data), options.data.with_suffix(".png")
