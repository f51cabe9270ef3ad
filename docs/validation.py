"""Bring the commands of docs/validation.md up to date: python docs/validation.py.

A row has a published value, its source and a command.  The answer of the `radcalc` next to this
Python and its deviation from the published value follow; a deviation that the printed digits do
not explain is bold.
"""

import re
import shlex
import subprocess
import sys
from collections.abc import Callable
from decimal import Decimal
from pathlib import Path

PAGE = Path(__file__).with_suffix(".md")
ROW = re.compile(r"^(\| (\S+)[^|]*\|[^|]*\| `radcalc ([^|`]*)` \|).*$", re.M)


def ask(words: list[str]) -> str:
    """Return what radcalc prints."""
    program = Path(sys.executable).with_name("radcalc")
    return subprocess.run([program, *words], capture_output=True, text=True, check=True).stdout


def current(page: str, ask: Callable[[list[str]], str]) -> str:
    """Return the page with new answers and deviations."""

    def row(found: re.Match[str]) -> str:
        answer = ask([*shlex.split(found[3]), "-q", "--precision", "15"]).split()[0]
        published, value = Decimal(found[2]), Decimal(answer)
        off, half = value - published, Decimal((0, (5,), published.as_tuple().exponent - 1))
        percent = f"{100 * float(off / published):+.1g} %" if off else "0"
        return (
            f"{found[1]} {float(answer):.8g} | {f'**{percent}**' if abs(off) > half else percent} |"
        )

    return ROW.sub(row, page)


if __name__ == "__main__":
    PAGE.write_text(current(PAGE.read_text(encoding="utf-8"), ask), encoding="utf-8")
