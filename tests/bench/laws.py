"""Compare calculators with a NumPy script; see README.md."""

import sys

from measure import RADCALC, command, report

SCRIPT = """
import numpy
distance = numpy.arange(1.0, 1000001.0)
illuminance = 800 / (4 * numpy.pi) / distance**2
print("\\n".join([f"{value:.12g}" for value in illuminance.tolist()]))
"""
RANGE = "--flux 800lm --distance 1m:1000000m:1m -g illuminance:lx"


def main() -> int:
    """Print all ratios; exit with status 1 if an aim is missed."""
    met = report(
        "1e6 distances / a NumPy script that prints the same rows",
        command(RADCALC, "point-source", *RANGE.split()),
        command(sys.executable, "-c", SCRIPT),
        1.5,
        11,
    )
    question = (RADCALC, "solid-angle", "cone", "--half-angle", "30deg")
    for name, answer in (("right", "0.842sr"), ("wrong", "3.14sr")):
        ours = command(*question, "--check", answer)
        met &= report(f"--check of a {name} answer / without", ours, command(*question), 1.2, 60)
    return 0 if met else 1


if __name__ == "__main__":
    sys.exit(main())
