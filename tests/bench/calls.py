"""How many of radcalc's own functions an answer calls, and in how many files; see README.md.

Counted, not timed: the second run in one process, so that imports do not count.
"""

import io
import os
import sys
from collections import Counter
from contextlib import redirect_stderr, redirect_stdout
from types import FrameType
from typing import Any
from unittest.mock import patch

import radcalc
from radcalc.__main__ import run

PACKAGE = os.path.dirname(radcalc.__file__) + os.sep
INLINED = ("<listcomp>", "<dictcomp>", "<setcomp>")  # functions before Python 3.12, none after
CASES = [
    ("convert 800 lm cd", 500),
    ("convert 800 lm lx --isotropic --distance 2m", 500),
    ("lambertian disc --luminance 1e4cd/m2 --radius 25cm --height 75cm", 800),
]


def calls(words: str) -> Counter[str]:
    """The calls of radcalc's functions in a run into a pipe, by the file they are in."""
    found: Counter[str] = Counter()

    def count(frame: FrameType, event: str, _: Any) -> None:
        code = frame.f_code
        own = code.co_filename.startswith(PACKAGE)
        if event == "call" and own and code.co_name not in INLINED:
            found[code.co_filename.removeprefix(PACKAGE)] += 1

    before = sys.getprofile()
    silent = redirect_stdout(_nowhere()), redirect_stderr(_nowhere())
    with silent[0], silent[1], patch("radcalc.stdio.is_terminal", lambda: False):
        run(words.split())
        sys.setprofile(count)
        try:
            run(words.split())
        finally:
            sys.setprofile(before)
    return found


def _nowhere() -> io.TextIOWrapper:
    return io.TextIOWrapper(io.BytesIO())


def main() -> int:
    """Print the calls and the files of every case; the exit status says whether all aims are met.

    With -v also how many calls there are in each file.
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
    return 0 if met else 1


if __name__ == "__main__":
    sys.exit(main())
