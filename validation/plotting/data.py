"""Reading what the program writes; everything missing is one clear error."""

import csv
from pathlib import Path

import h5py
import numpy as np


class PlotError(Exception):
    """What is wrong and what would be right, for the user."""


def need(path):
    path = Path(path)
    if not path.exists():
        raise PlotError(f"{path}: no such file")
    return path


def listing(names):
    return ", ".join(sorted(names)) or "nothing"


def run_file(directory):
    """The run.h5 of an output directory, or the file itself."""
    path = Path(directory)
    return need(path / "run.h5" if path.is_dir() else path)


def open_h5(path):
    try:
        return h5py.File(path, "r")
    except OSError as error:
        raise PlotError(f"{path}: not a readable HDF5 file ({error})") from None


def dataset(file, name):
    """A whole dataset by its path in the file."""
    if name not in file:
        parent = name.rpartition("/")[0] or "/"
        while parent not in file:
            parent = parent.rpartition("/")[0] or "/"
        raise PlotError(f"{file.filename}: no {name}; {parent} has: {listing(file[parent].keys())}")
    return file[name][()]


def as_table(values):
    """N rows, also of a field of one component that was stored flat."""
    return values.reshape(len(values), -1)


def table(path):
    """Columns of a CSV file with a header, in order; numeric where every cell is, else text.

    An empty cell counts as not a number.
    """
    with open(need(path), newline="") as file:
        try:
            rows = [row for row in csv.reader(file) if row and not row[0].startswith("#")]
        except (csv.Error, UnicodeDecodeError) as error:
            raise PlotError(f"{path}: not a CSV file ({error})") from None
    if len(rows) < 2:
        raise PlotError(f"{path}: no rows")
    header = [name.strip() for name in rows[0]]
    for number, row in enumerate(rows[1:], start=2):
        if len(row) != len(header):
            raise PlotError(f"{path}: row {number} has {len(row)} cells, the header {len(header)}")
    columns = {}
    for name, cells in zip(header, zip(*rows[1:])):
        try:
            columns[name] = np.array([float(cell) if cell.strip() else np.nan for cell in cells])
        except ValueError:
            columns[name] = list(cells)
    return columns
