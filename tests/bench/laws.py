"""Calculators as ratios in one run; see README.md."""

import sys

from measure import RADCALC, command, report

CLICK = (sys.executable, "-c", "import click")
SCALARS = [
    ("point-source", "--flux 800lm --distance 2m"),
    ("point-source", "--intensity 1000cd --beam-angle 30deg --json"),
    ("lambertian", "disc --luminance 1e4cd/m2 --radius 25cm --height 75cm --offset 10cm"),
    ("ev", "--ev100 15"),
]
SCRIPT = """
import numpy
distance = numpy.arange(1.0, 1000001.0)
illuminance = 800 / (4 * numpy.pi) / distance**2
print("\\n".join([f"{value:.12g}" for value in illuminance.tolist()]))
"""
RANGE = "--flux 800lm --distance 1m:1000000m:1m -g illuminance:lx"


def main() -> int:
    """Print every ratio; the exit status says whether all aims are met."""
    met = True
    for name, words in SCALARS:
        ours = command(RADCALC, name, *words.split())
        met &= report(f"{name} {words} / import click", ours, command(*CLICK), 1.4, 40)
    met &= report(
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
