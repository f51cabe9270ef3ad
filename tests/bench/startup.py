"""Compare the start-up of the installed command with other commands; see README.md."""

import shutil
import sys
import tempfile
from pathlib import Path

from measure import RADCALC, command, report

RUNS = 60
PASS, CLICK = (sys.executable, "-c", "pass"), (sys.executable, "-c", "import click")
FILE = str(Path(tempfile.gettempdir()) / "radcalc-bench.svg")
LINE = """
import click
from matplotlib.figure import Figure
made = Figure(figsize=(7.2, 4.5), layout="constrained")
axes = made.subplots()
axes.plot(range(471))
axes.set_xlabel("x")
made.savefig({!r})
"""
FIGURE = (sys.executable, "-c", LINE.format(FILE))
RICH = (sys.executable, "-c", "import click, rich.console, rich.table")
QALC = ("qalc", "-t", "100 lux to fc")
CALCULATORS = [
    "solid-angle cone --half-angle 30deg",
    "solid-angle sphere --radius 695700km --distance 1au",
    "solid-angle zone --polar 30deg:60deg",
    "point-source --flux 800lm --distance 2m",
    "point-source --intensity 1000cd --beam-angle 30deg --json",
    "lambertian disc --luminance 1e4cd/m2 --radius 25cm --height 75cm --offset 10cm",
    "ev --ev100 15",
    "calorimeter --mass 10g --specific-heat 385J/kg/K --temperature-rise 2K --time 30s",
    "photon 555nm",
    "point-source --intensity 100cd --distance 2m",
    "laser --flux 5mW --diameter 1mm --receiver-diameter 7mm",
    "ev --f-number 16 --time 1/100s",
    "sensor --luminance 100cd/m2 --f-number 2.8 --wavelength 550nm",
    "mesopic --luminance 0.1cd/m2 --spectrum LED-B3",
    "sky overcast --zenith-luminance 9000cd/m2 --tilt 90deg",
]
LIST = "point-source --flux 800lm --distance 1m:20m:1m"
CASES = [
    ("plain conversion / python -c pass", "convert 100 lx fc", PASS, 1.1),
    ("plain conversion / qalc", "convert 100 lx fc", QALC, 0.4),
    ("sentence / convert", "100 lx fc", (RADCALC, "convert", "100", "lx", "fc"), 1.05),
    ("expression / import click", "500lx*20m2/(0.6*0.8) klm", CLICK, 1.3),
    ("--wavelength / import click", "convert 5 mW lm --wavelength 632.8nm", CLICK, 1.2),
    ("--isotropic / import click", "convert 800 lm cd --isotropic", CLICK, 1.2),
    ("--json / import click", "convert 100 lx fc --json", CLICK, 1.2),
    ("refusal / import click", "convert 800 lm cd", CLICK, 1.2),
    ("a sentence's refusal / import click", "800 lm cd", CLICK, 1.5),
    *((f"{words} / import click", words, CLICK, 1.2) for words in CALCULATORS),
    ("--help / import click", "--help", CLICK, 1.3),
    ("-h / import click", "-h", CLICK, 1.2),
    ("convert -h / import click", "convert -h", CLICK, 1.2),
    ("point-source -h / import click", "point-source -h", CLICK, 1.2),
    ("--plot / the same without", "spectrum LED-B3 --plot", (RADCALC, "spectrum", "LED-B3"), 1.3),
    ("--plot FILE / a line of Matplotlib", f"spectrum LED-B3 --plot {FILE}", FIGURE, 1.3),
    ("convert --help / import click", "convert --help", CLICK, 1.4),
    ("a table / import click, rich.table", "100 lx fc --format table", RICH, 1.2),
    ("a list's table / import click, rich.table", f"{LIST} --format table", RICH, 1.2),
]


def main() -> int:
    """Print all ratios; exit with status 1 if an aim is missed."""
    met = True
    for name, words, other, aim in CASES:
        if shutil.which(other[0]) is None:
            print(f"{name}: {other[0]} is not installed")
            met = False
            continue
        ours = command(RADCALC, *words.split())
        met &= report(name, ours, command(*other), aim, RUNS)
    return 0 if met else 1


if __name__ == "__main__":
    sys.exit(main())
