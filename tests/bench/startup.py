"""Start-up of the installed command, as ratios in one run; see README.md."""

import shutil
import sys

from measure import RADCALC, command, report

RUNS = 60
PASS, CLICK = (sys.executable, "-c", "pass"), (sys.executable, "-c", "import click")
QALC = ("qalc", "-t", "100 lux to fc")
CASES = [
    ("plain conversion / python -c pass", "100 lx fc", PASS, 1.8),
    ("plain conversion / qalc", "100 lx fc", QALC, 0.4),
    ("--wavelength / import click", "5 mW lm --wavelength 632.8nm", CLICK, 1.3),
    ("--isotropic / import click", "800 lm cd --isotropic", CLICK, 1.3),
    ("--json / import click", "100 lx fc --json", CLICK, 1.3),
    ("refusal / import click", "800 lm cd", CLICK, 1.3),
]


def main() -> int:
    """Print every ratio; the exit status says whether all aims are met."""
    met = True
    for name, words, other, aim in CASES:
        if shutil.which(other[0]) is None:
            print(f"{name}: {other[0]} is not installed")
            met = False
            continue
        ours = command(RADCALC, "convert", *words.split())
        met &= report(name, ours, command(*other), aim, RUNS)
    return 0 if met else 1


if __name__ == "__main__":
    sys.exit(main())
