#!/usr/bin/env python3
"""Figures from what the program wrote.

    plot.py probes out/bar_wave                 histories, against the exact ones where there are any
    plot.py frames out/swinging_plate           snapshots of a field in the deformed configuration
    plot.py space-time out/bar_wave             a field over place and time, in one dimension
    plot.py operator export/operators.h5:G_x    sparsity pattern and spectrum
    plot.py convergence out/convergence.csv     errors against the spacing, with fitted orders
    plot.py chart out/chart.json                speed against accuracy, with the front of the best
    plot.py energy out/clamped_beam             where the energy goes, and the drift of the balance
    plot.py stability out/sheet-stability/stability.json   where methods fail, and how waves travel on the lattice
    plot.py case out/validation/bar_pulse       the figure of a validation case, from what it left there

Figures are written beside the data unless --out names a file; its suffix (png, svg, pdf) is the format.
Exit code 2 and one line on stderr if a file or a field is missing.
"""

import argparse
import sys
from pathlib import Path

try:
    import h5py  # noqa: F401
    import matplotlib
    import scipy  # noqa: F401
except ImportError as missing:
    print(f"plot.py: {missing}; install python3-matplotlib, python3-h5py and python3-scipy", file=sys.stderr)
    sys.exit(2)

matplotlib.use("Agg")

from plotting import case, chart, convergence, energy, frames, operator, probes, space_time, stability  # noqa: E402
from plotting.data import PlotError  # noqa: E402
from plotting.style import heading, save, use_style  # noqa: E402


def parser():
    p = argparse.ArgumentParser(prog="plot.py", description=__doc__,
                                formatter_class=argparse.RawDescriptionHelpFormatter)
    common = argparse.ArgumentParser(add_help=False)
    common.add_argument("--out", type=Path, metavar="FILE", help="figure to write (.png, .svg or .pdf)")
    common.add_argument("--title", default="", help="heading of the figure")
    commands = p.add_subparsers(dest="command", required=True, metavar="COMMAND")
    for name, module in (("probes", probes), ("frames", frames), ("space-time", space_time),
                         ("operator", operator), ("convergence", convergence), ("chart", chart),
                         ("energy", energy), ("stability", stability),
                         ("case", case)):
        text = module.__doc__.split("\n", 1)[0]
        command = commands.add_parser(name, parents=[common], help=text, description=module.__doc__,
                                      formatter_class=argparse.RawDescriptionHelpFormatter)
        module.arguments(command)
        command.set_defaults(draw=module.draw)
    return p


def main(arguments=None):
    options = parser().parse_args(arguments)
    use_style()
    try:
        figure, beside = options.draw(options)
        heading(figure, options.title)
        print(save(figure, options.out or beside))
    except PlotError as error:
        print(f"plot.py: {error}", file=sys.stderr)
        return 2
    except OSError as error:
        print(f"plot.py: {error.filename or ''}: {error.strerror or error}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
