"""Compare the time of a Tab, including the start of the process; see README.md."""

import os
import subprocess
import sys
from collections.abc import Callable

from measure import RADCALC, command, report

RUNS = 60
PASS, CLICK = (sys.executable, "-c", "pass"), (sys.executable, "-c", "import click")
CASES = [
    ("radcalc conv", PASS, 1.3),
    ("radcalc lambertian --", PASS, 1.3),
    ("radcalc point-source --distance 2", PASS, 1.3),
    ("radcalc point-source -g illuminance:", PASS, 1.3),
    ("radcalc convert 5 mW lm --spectrum LED", PASS, 1.3),
    ("radcalc 100 lx ", CLICK, 1.0),
    ("radcalc 100 lx W/m", CLICK, 1.0),
    ("radcalc 800 lm --isotropic --distance 2m ", CLICK, 1.0),
    ("radcalc 5 mW --spectrum LED-B3 l", CLICK, 1.0),
]


def tab(line: str) -> Callable[[], object]:
    """Return a function that runs what bash runs for a Tab after a line."""
    asked = {**os.environ, "_RADCALC_COMPLETE": "bash_complete", "COMP_LINE": line}
    return lambda: subprocess.run([RADCALC], capture_output=True, check=True, env=asked)


def main() -> int:
    """Print all ratios; exit with status 1 if an aim is missed."""
    met = True
    for line, other, aim in CASES:
        name = f"{line!r} / {' '.join(other[1:])}"
        met &= report(name, tab(line), command(*other), aim, RUNS)
    return 0 if met else 1


if __name__ == "__main__":
    sys.exit(main())
