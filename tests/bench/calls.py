"""Count the calls of radcalc's functions during an answer, by file, and the moves between files.

The second run in one process is counted, so that imports do not count.
"""

import gc
import io
import os
import sys
from collections import Counter
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path
from types import FrameType
from typing import Any
from unittest.mock import patch

import radcalc
from radcalc.__main__ import run

ROOT = Path(__file__).parents[2]
PACKAGE = os.path.dirname(radcalc.__file__) + os.sep
INLINED = ("<listcomp>", "<dictcomp>", "<setcomp>")  # functions only before Python 3.12
DISC = "lambertian disc --luminance 1e4cd/m2 --radius 25cm --height 75cm"
LAMP = str(ROOT / "examples" / "downlight.ies")
CASES = [
    ("convert 800 lm cd", 1390),
    ("convert 800 lm lx --isotropic --distance 2m", 500),
    (DISC, 855),  # two of them to compare inputs that are given twice
]
TRACES = [
    "convert 800 lm cd --isotropic",
    f"{DISC} -g illuminance",
    "lambertian disc --luminance 1e4cd/m2 --radius -0.5m --height 75cm",
    f"point-source --distribution {LAMP} -g flux",
    f"{DISC} --check illuminance=3000lx",
]


class Trace:
    """The calls during an answer by file, its functions, and the calls that leave a file."""

    def __init__(self) -> None:
        self.calls: Counter[str] = Counter()
        self.functions: set[tuple[str, int]] = set()
        self.moves = 0

    def add(self, frame: FrameType, event: str, _: Any) -> None:
        """Count a call; a profile function of `sys.setprofile`."""
        code = frame.f_code
        own = code.co_filename.startswith(PACKAGE)
        if event != "call" or not own or code.co_name in INLINED:
            return
        self.calls[code.co_filename.removeprefix(PACKAGE)] += 1
        self.functions.add((code.co_filename, code.co_firstlineno))
        caller = frame.f_back
        while caller and not caller.f_code.co_filename.startswith(PACKAGE):
            caller = caller.f_back
        self.moves += bool(caller and caller.f_code.co_filename != code.co_filename)

    def __str__(self) -> str:
        """Format the counts as in the table of README.md."""
        counts = len(self.calls), len(self.functions), sum(self.calls.values()), self.moves
        return "{} files, {} functions, {} calls, {} moves".format(*counts)


def calls(words: str) -> Counter[str]:
    """Count the calls of radcalc's functions during a command, by file."""
    return trace(words).calls


def trace(words: str) -> Trace:
    """Trace the second run of a command."""
    found = Trace()

    before = sys.getprofile()
    silent = redirect_stdout(_nowhere()), redirect_stderr(_nowhere())
    with silent[0], silent[1], patch("radcalc.terminal.is_terminal", lambda: False):
        run(words.split())
        gc.collect()  # ends the generators that earlier calls left, which would count here
        sys.setprofile(found.add)
        try:
            run(words.split())
        finally:
            sys.setprofile(before)
    return found


def _nowhere() -> io.TextIOWrapper:
    return io.TextIOWrapper(io.BytesIO())


def main() -> int:
    """Print the calls and the files of all cases; exit with status 1 if an aim is missed.

    With -v, print the calls in each file, too.
    """
    met = True
    for words, aim in CASES:
        found = calls(words)
        count = sum(found.values())
        print(f"{words}: {count} calls in {len(found)} files (aim {aim})")
        if "-v" in sys.argv:
            for name, number in found.most_common():
                print(f"    {name}: {number}")
        met &= count <= aim
    for words in TRACES:
        print(f"{words}: {trace(words)}")
    return 0 if met else 1


if __name__ == "__main__":
    sys.exit(main())
