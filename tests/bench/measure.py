"""Measure commands and functions in turn, and compare their medians."""

import statistics
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

RADCALC = str(Path(sys.executable).with_name("radcalc"))


def command(*words: str) -> Callable[[], object]:
    """Return a function that runs a command with its output captured."""
    return lambda: subprocess.run(words, capture_output=True, check=False)


def seconds(action: Callable[[], object]) -> float:
    """Measure one run [s]."""
    start = time.perf_counter()
    action()
    return time.perf_counter() - start


def report(
    name: str, ours: Callable[[], object], theirs: Callable[[], object], aim: float, runs: int
) -> bool:
    """Print the ratio of the medians after a warm-up; return whether it meets the aim.

    The ratio of the shortest times, which a loaded machine changes less, is printed also.
    """
    seconds(ours), seconds(theirs)
    pairs = [(seconds(ours), seconds(theirs)) for _ in range(runs)]
    mine, other = (statistics.median(side) for side in zip(*pairs, strict=True))
    least = min(pair[0] for pair in pairs) / min(pair[1] for pair in pairs)
    times = f"{mine * 1e3:.1f} ms / {other * 1e3:.1f} ms = {mine / other:.2f}"
    print(f"{name}: {times} (aim {aim}; of the shortest {least:.2f})")
    return mine / other <= aim
