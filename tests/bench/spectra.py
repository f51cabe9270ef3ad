"""Compare calculations with spectra; see README.md."""

import sys
import tempfile
from pathlib import Path

import numpy as np
from measure import RADCALC, command, report

from radcalc.spectra import luminous, luminous_efficacy

LOADTXT = """
import sys, numpy
data = numpy.loadtxt(sys.argv[1], delimiter=",")
print(numpy.trapezoid(data[:, 1], data[:, 0]))
"""


def main() -> int:
    """Print all ratios; exit with status 1 if an aim is missed."""
    convert = (RADCALC, "convert")
    met = report(
        "--spectrum D65 / --wavelength",
        command(*convert, "1000", "lx", "W/m2", "--spectrum", "D65"),
        command(*convert, "1000", "lx", "W/m2", "--wavelength", "555nm"),
        1.15,
        60,
    )
    met &= report(
        "spectrum D65 / import click, numpy",
        command(RADCALC, "spectrum", "D65"),
        command(sys.executable, "-c", "import click, numpy"),
        1.3,
        60,
    )
    grid = np.linspace(300, 1100, 1_000_000)
    with tempfile.TemporaryDirectory() as folder:
        path = str(Path(folder) / "spectrum.csv")
        table = np.c_[grid, np.exp(-(((grid - 550) / 80) ** 2))]
        np.savetxt(path, table, fmt="%.8g", delimiter=",")
        met &= report(
            "1e6 rows / numpy.loadtxt",
            command(*convert, "1", "W", "lm", "--spectrum", path),
            command(sys.executable, "-c", LOADTXT, path),
            2,
            7,
        )
    wavelengths = np.linspace(400, 700, 61)
    cube, weights = np.random.default_rng(0).random((1000, 1000, 61)), np.ones(61)
    for function in (luminous, luminous_efficacy):
        met &= report(
            f"{function.__name__} of a cube / cube @ vector",
            lambda function=function: function(wavelengths, cube),
            lambda: cube @ weights,
            1.5,
            21,
        )
    return 0 if met else 1


if __name__ == "__main__":
    sys.exit(main())
