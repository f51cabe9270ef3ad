"""Compare sums over samples in time with mawk, and measure their memory; see README.md."""

import os
import random
import shutil
import subprocess
import sys
import tempfile
from datetime import UTC, datetime, timedelta
from pathlib import Path

from measure import RADCALC, command, report

SAMPLES, LONG, STEP = 2_000_000, 10_000_000, 10  # s
MEGABYTES = 80
START = datetime(2024, 1, 1, tzinfo=UTC)
SUM = "if (n++) s += (v + $2)/2 * (t - u); u = t; v = $2"
OF_UNIX = f'NR > 1 {{t = $1; {SUM}}} END {{printf "%.12g\\n", s}}'
OF_ISO = (
    "NR > 1 {day = substr($1, 1, 10); if (day != last) {last = day; parts = day; "
    'gsub("-", " ", parts); midnight = mktime(parts " 0 0 0")} '
    "t = midnight + 3600*substr($1, 12, 2) + 60*substr($1, 15, 2) + substr($1, 18, 2); "
    f'{SUM}}} END {{printf "%.12g\\n", s}}'
)


def write(folder: Path) -> None:
    """Write logs with equal steps, with Unix time and with ISO 8601."""
    random.seed(1)
    first = round(START.timestamp())
    with (folder / "unix").open("w") as unix, (folder / "iso").open("w") as iso:
        unix.write("timestamp,E [lx]\n")
        iso.write("timestamp,E [lx]\n")
        for k in range(SAMPLES):
            value = f"{random.uniform(0, 1e5):.1f}"
            when = START + timedelta(seconds=k * STEP)
            unix.write(f"{first + k * STEP},{value}\n")
            iso.write(f"{when:%Y-%m-%d %H:%M:%S},{value}\n")


def memory() -> bool:
    """Sum up a long generated stream, and print the peak memory."""
    script = f'BEGIN {{for (k = 0; k < {LONG}; k++) print k ",100"}}'
    feeder = subprocess.Popen(["mawk", script], stdout=subprocess.PIPE)
    words = [RADCALC, "dose", "-", "--unit", "lx", "--time-unit", "s", "-q", "-g", "exposure:lx.s"]
    child = subprocess.Popen(words, stdin=feeder.stdout, stdout=subprocess.PIPE, text=True)
    assert child.stdout
    answer = child.stdout.read()
    _, status, used = os.wait4(child.pid, 0)
    feeder.wait()
    most = used.ru_maxrss / (1 if sys.platform == "darwin" else 1024)
    print(f"{LONG:.0e} samples: {most:.1f} MB resident at most (aim {MEGABYTES})")
    return status == 0 and float(answer) == 100 * (LONG - 1) and most <= MEGABYTES


def main() -> int:
    """Print all ratios; exit with status 1 if an aim is missed."""
    if shutil.which("mawk") is None:
        print("mawk is not installed")
        return 1
    met = memory()  # first, because a child process inherits the memory of its parent
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        write(folder)
        by_day = ("--by", "day", "--time-zone", "Europe/Prague")
        for title, log, script, options in (
            ("2e6 samples, Unix time / mawk", "unix", OF_UNIX, ()),
            ("2e6 samples, ISO 8601 / mawk", "iso", OF_ISO, ("--time-zone", "UTC")),
            ("the same by the day in a zone / mawk", "iso", OF_ISO, by_day),
        ):
            path = str(folder / log)
            ours = command(RADCALC, "dose", path, "-q", "-g", "exposure:lx.s", *options)
            met &= report(title, ours, command("mawk", "-F,", script, path), 3, 3)
    return 0 if met else 1


if __name__ == "__main__":
    sys.exit(main())
