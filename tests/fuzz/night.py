"""Run all sweeps with their LONG number of cases, some two million, with the date as the seed.

    PYTHONPATH=tests python -m fuzz.night [--share 0.01] [--seed S] [--jobs N]

A failure is printed, and the other sweeps continue; the exit status is then 1.
"""

import argparse
import datetime
import importlib
import os
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from typing import NamedTuple

from fuzz.sweeps import SWEEPS


class Ended(NamedTuple):
    """The end of a sweep."""

    name: str
    status: int
    output: str
    seconds: float


def run(name: str, share: float, seed: int) -> Ended:
    """Run a sweep in a new process, which may crash."""
    count = max(1, round(importlib.import_module(f"fuzz.{name}").LONG * share))
    begin = time.monotonic()
    done = subprocess.run(
        [sys.executable, "-m", f"fuzz.{name}", "--count", str(count), "--seed", str(seed)],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        errors="replace",
    )
    return Ended(name, done.returncode, done.stdout.strip(), time.monotonic() - begin)


def main() -> int:
    """Run all sweeps; return the exit status."""
    today = int(datetime.date.today().strftime("%Y%m%d"))
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--share", type=float, default=1, help="of each LONG number")
    parser.add_argument("--seed", type=int, default=today)
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    given = parser.parse_args()
    failed = 0
    with ThreadPoolExecutor(given.jobs) as pool:
        running = [pool.submit(run, name, given.share, given.seed) for name in SWEEPS]
        for one in running:
            ended = one.result()
            failed += ended.status != 0
            verdict = "failed" if ended.status else "passed"
            print(f"{verdict} {ended.name} ({ended.seconds:.0f} s): {ended.output}", flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
