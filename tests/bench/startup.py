"""Start-up of the installed command, as ratios in one run; see README.md."""

import shutil
import statistics
import subprocess
import sys
import time
from pathlib import Path

RUNS = 60
RADCALC = str(Path(sys.executable).with_name("radcalc"))
PASS, CLICK = [sys.executable, "-c", "pass"], [sys.executable, "-c", "import click"]
CASES = [
    ("plain conversion / python -c pass", ["convert", "100", "lx", "fc"], PASS, 1.8),
    ("plain conversion / qalc",
     ["convert", "100", "lx", "fc"], ["qalc", "-t", "100 lux to fc"], 0.4),
    ("--wavelength / import click",
     ["convert", "5", "mW", "lm", "--wavelength", "632.8nm"], CLICK, 1.3),
    ("--isotropic / import click", ["convert", "800", "lm", "cd", "--isotropic"], CLICK, 1.3),
    ("--json / import click", ["convert", "100", "lx", "fc", "--json"], CLICK, 1.3),
    ("refusal / import click", ["convert", "800", "lm", "cd"], CLICK, 1.3),
]  # fmt: skip


def seconds(command: list[str]) -> float:
    """One run of a command into a pipe."""
    start = time.perf_counter()
    subprocess.run(command, capture_output=True, check=False)
    return time.perf_counter() - start


def compare(ours: list[str], theirs: list[str]) -> tuple[float, float]:
    """Median seconds of both, taking turns after a warm-up."""
    seconds(ours), seconds(theirs)
    pairs = [(seconds(ours), seconds(theirs)) for _ in range(RUNS)]
    return statistics.median(a for a, _ in pairs), statistics.median(b for _, b in pairs)


def main() -> int:
    """Print every ratio; the exit status says whether all aims are met."""
    met = True
    for name, words, other, aim in CASES:
        if shutil.which(other[0]) is None:
            print(f"{name}: {other[0]} is not installed")
            met = False
            continue
        mine, theirs = compare([RADCALC, *words], other)
        met &= mine / theirs <= aim
        print(
            f"{name}: {mine * 1e3:.1f} ms / {theirs * 1e3:.1f} ms = {mine / theirs:.2f} (aim {aim})"
        )
    return 0 if met else 1


if __name__ == "__main__":
    sys.exit(main())
