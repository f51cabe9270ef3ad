"""Measure the time from Enter to the answer at the prompt, in one process; see README.md."""

import io
import os
import statistics
import sys
from contextlib import redirect_stderr, redirect_stdout
from unittest.mock import patch

from measure import command, seconds

from radcalc.cli.session import Session

RUNS = 200
PASS = (sys.executable, "-c", "pass")
LINES = ("100 lx fc", "ans klx", "800 lm lx --isotropic --distance 2m", "800 lm cd")
AIM = 0.1  # of a start of Python, which takes about 12 ms


def main() -> int:
    """Print the median time of all lines; exit with status 1 if an aim is missed."""
    start = statistics.median(seconds(command(*PASS)) for _ in range(20))
    met = True
    for line in LINES:
        session = Session()
        taken = []
        with (
            open(os.devnull, "w") as nowhere,
            redirect_stdout(nowhere),
            redirect_stderr(io.TextIOWrapper(io.BytesIO())),
            patch("radcalc.terminal.is_terminal", lambda: True),
        ):
            session.answer(line)  # loads what it needs
            for _ in range(RUNS):
                session.answer("100 lx fc")
                taken.append(seconds(lambda: session.answer(line)))  # noqa: B023
        median = statistics.median(taken)
        ratio = median / start
        print(f"{line}: {median * 1e3:.2f} ms; of a start of Python {ratio:.2f} (aim {AIM})")
        met &= ratio <= AIM
    return 0 if met else 1


if __name__ == "__main__":
    sys.exit(main())
