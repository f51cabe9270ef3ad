"""Compare streams with mawk and units, and measure the memory of a long one; see README.md."""

import os
import random
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

from measure import RADCALC, report

LINES, DISTANCES, OWN, LONG = 2_000_000, 1_000_000, 100_000, 100_000_000
MEGABYTES = 60
OBLIQUE = ("point-source", "--intensity", "250cd", "--height", "6m", "--offset", "- m")
CASES = [
    (
        "2e6 numbers lx to fc / mawk",
        ("convert", "-", "lx", "fc"),
        '{printf "%.12g\\n", $1*0.09290304}',
        "numbers",
        1,
    ),
    (
        "2e6 numbers fc to lx, no decimal ratio / mawk",
        ("convert", "-", "fc", "lx"),
        '{printf "%.12g\\n", $1/0.09290304}',
        "numbers",
        2,
    ),
    (
        "field 3 of a CSV of 5 columns / mawk",
        ("convert", "-", "lx", "fc", "--field", "3", "-d", ","),
        'BEGIN{FS=OFS=","}{$3 = sprintf("%.12g", $3*0.09290304); print}',
        "table",
        1,
    ),
    (
        "a column by its title, and one added / mawk",
        ("convert", "-", "lx", "fc", "--column", "E", "-d", ",", "--add", "E2"),
        'BEGIN{FS=OFS=","} NR==1{print $0, "E2 [fc]"; next}'
        '{print $0, sprintf("%.12g", $3*0.09290304)}',
        "titled",
        1,
    ),
    (
        "1e6 distances to illuminances / mawk",
        ("point-source", "--intensity", "100cd", "--distance", "- m", "-g", "irradiance:lx", "-q"),
        '{printf "%.12g\\n", 100/($1*$1)}',
        "distances",
        2.5,
    ),
    (
        "1e6 offsets under a height to illuminances / mawk",
        (*OBLIQUE, "-g", "irradiance:lx", "-q"),
        '{d = 36 + $1*$1; printf "%.12g\\n", 250*6/(d*sqrt(d))}',
        "distances",
        2.5,
    ),
]
UNITS = {"lx": "lx", "fc": "footcandle", "klx": "klx", "ph": "phot", "mlx": "mlx"}


def fed(path: Path, *words: str) -> Callable[[], object]:
    """Return a function that runs a command with a file as its standard input."""

    def action() -> None:
        with path.open("rb") as data, open(os.devnull, "wb") as null:
            command = subprocess.Popen(words, stdin=data, stdout=subprocess.PIPE)
            subprocess.run(["cat"], stdin=command.stdout, stdout=null, check=True)
            if command.wait():
                raise RuntimeError(words[0])

    return action


def write(folder: Path) -> None:
    """Write the inputs: numbers below 100 000 with two decimals."""
    random.seed(1)
    numbers = [f"{random.uniform(0, 1e5):.2f}" for _ in range(LINES)]
    (folder / "numbers").write_text("\n".join(numbers) + "\n")
    (folder / "distances").write_text("\n".join(numbers[:DISTANCES]) + "\n")
    rows = [f"{i},room{i % 7},{number},ok,{3 * i}\n" for i, number in enumerate(numbers)]
    (folder / "table").write_text("".join(rows))
    (folder / "titled").write_text("".join(["i,room,E [lx],ok,n\n", *rows]))
    own = [(number, random.choice(list(UNITS))) for number in numbers[:OWN]]
    (folder / "own").write_text("".join([f"{number} {unit}\n" for number, unit in own]))
    asked = [f"{number} {UNITS[unit]}\nlx\n" for number, unit in own]
    (folder / "asked").write_text("".join(asked))


def memory() -> bool:
    """Convert a long generated stream, and print the peak memory."""
    feeder = subprocess.Popen(
        ["sh", "-c", f"yes 100 | head -n {LONG}"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL
    )
    with open(os.devnull, "wb") as null:
        child = subprocess.Popen(
            [RADCALC, "convert", "-", "lx", "fc"], stdin=feeder.stdout, stdout=null
        )
        _, status, used = os.wait4(child.pid, 0)
    feeder.wait()
    most = used.ru_maxrss / (1 if sys.platform == "darwin" else 1024)
    print(f"{LONG:.0e} numbers: {most:.1f} MB resident at most (aim {MEGABYTES})")
    return status == 0 and most <= MEGABYTES


def main() -> int:
    """Print all ratios; exit with status 1 if an aim is missed."""
    met = memory()  # first, because a child process inherits the memory of its parent
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        write(folder)
        for title, words, script, data, aim in CASES:
            if shutil.which("mawk") is None:
                print(f"{title}: mawk is not installed")
                met = False
                continue
            ours = fed(folder / data, RADCALC, *words)
            met &= report(title, ours, fed(folder / data, "mawk", script), aim, 9)
        if shutil.which("units") is None:
            print("units is not installed")
            met = False
        else:
            ours = fed(folder / "own", RADCALC, "convert", "-", "lx", "-q")
            theirs = fed(folder / "asked", "units", "-t")
            met &= report("1e5 lines with units / units -t", ours, theirs, 0.1, 3)
    return 0 if met else 1


if __name__ == "__main__":
    sys.exit(main())
