"""The command line of a sweep: PYTHONPATH=tests python -m fuzz.NAME [--count N] [--seed S]."""

import argparse
import time
from collections.abc import Callable


def main(sweep: Callable[[int, int], str], count: int) -> None:
    """Run a sweep, and print its summary and time."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--count", type=int, default=count)
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args()
    start = time.perf_counter()
    summary = sweep(given.count, given.seed)
    took = time.perf_counter() - start
    print(f"{summary}  ({given.count} cases, seed {given.seed}, {took:.0f} s)")
