"""Calls that hints propose, and whether these calls are answered as the hints say."""

import re
import shlex
from collections.abc import Iterator
from itertools import pairwise
from math import isclose
from pathlib import Path
from typing import Any, NamedTuple
from unittest import mock

from conftest import standard_streams

from radcalc import cli, terminal
from radcalc.cli.spelling import Shell
from radcalc.cli.trials import is_long, reads_stdin
from radcalc.errors import RadcalcError

Words = list[str]
LINES = (
    b"1\n",
    b"1 lx\n",
    b"E,F\n1,2\n",
    b"E,F\n1 lx,2 lx\n",
    b"1 2\n",
    b"E F\n1 2\n",
    b"x F\n1 2\n",
    b"1 2 3\n",
    b"1,2,3\n",
    b"nm I\n400 1\n700 2\n",  # a spectrum
)  # for a stream


# Problems whose hint may be a sentence: a number that is out of range or not finite, and a file
# that is missing, damaged or malformed.
PROSE = (
    "not understood: ",  # what was understood, and what was not
    "not used( for .*)?: ",
    r"out of range|not a finite number|too (large|small) for a number|divides by zero",
    r"exponent too large|no reading on|not the reciprocal|is invisible|no CIE daylight|near '0lx'",
    r"^cannot (read|write) |^there is no file ",
)


class Outcome(NamedTuple):
    """The outcome of a call; `hints` are the lines that propose other calls, with their answers."""

    status: int
    output: str
    error: RadcalcError | None
    hints: Words

    @property
    def proposed(self) -> Iterator[tuple[Words, str]]:
        """Yield the calls in the hints as they are pasted, each with the answer below it."""
        for line, below in pairwise([*self.hints, ""]):
            if line.startswith(terminal.CALLS):
                answer = below.strip() if below.startswith("     ") else ""
                yield shlex.split(line.partition("radcalc ")[2]), answer


def call(words: Words, lines: bytes = LINES[0]) -> Outcome:
    """Run a command in this process, with lines as its input; catch its error."""
    caught: list[RadcalcError] = []
    hinted: Words = []

    def complain(error: RadcalcError, spelling: Any = None, hints: Any = None) -> int:
        caught.append(error)
        hinted.extend(hints or [])
        return terminal.FAILED

    with standard_streams(lines) as (out, _), mock.patch.object(terminal, "complain", complain):
        status = cli.run(list(words))
        out.seek(0)
        return Outcome(status, out.read().decode(), caught[0] if caught else None, hinted)


NUMBER = re.compile(r"-?[0-9]+\.?[0-9]*(?:e[+-]?[0-9]+)?")


def unlike(words: Words, answer: str, lines: bytes) -> str:
    """Return what is wrong with a call in a hint: it is refused, or its number is another."""
    if "<" in words:
        place = words.index("<")
        lines = Path(words[place + 1]).read_bytes()
        words = [*words[:place], *words[place + 2 :]]
        return "" if call(words, lines).output else "answers nothing"
    if is_long(words):  # the gate does not make it
        return ""
    outcomes = [call(words, each) for each in (LINES if reads_stdin(words) else [lines])]
    good = [one for one in outcomes if one.status in (terminal.ANSWERED, terminal.WRONG)]
    if not good:
        return f"refused: {outcomes[0].error}"
    outcome = good[0]
    if not answer or "--check" in words or answer.startswith("--"):  # a remark alone
        return ""
    shown = NUMBER.search(answer.rpartition(" ")[0] or answer)
    numbers = [float(number) for number in NUMBER.findall(outcome.output)]
    if shown and not any(
        isclose(float(shown[0]), number, rel_tol=0.01 if "±" in answer else 1e-5)
        for number in numbers
    ):
        return f"answers {outcome.output!r}, not {answer!r}"
    return ""


def is_prose(outcome: Outcome) -> bool:
    """Return whether a call is refused with a sentence instead of a call."""
    return outcome.error is not None and not any(outcome.proposed)


def may_be_prose(error: RadcalcError) -> bool:
    """Return whether no call can put an error right."""
    message, _ = error.spelled(Shell)
    return any(re.search(pattern, message) for pattern in PROSE)


def liars(words: Words, lines: bytes = LINES[0]) -> list[str]:
    """Return the calls in the hint of a refused call that are not answered as it says."""
    outcome = call(words, lines)
    assert outcome.error is not None, words
    faults = [(typed, unlike(typed, answer, lines)) for typed, answer in outcome.proposed]
    return [
        f"radcalc {shlex.join(words)}\n    try: radcalc {shlex.join(typed)}\n    {fault}"
        for typed, fault in faults
        if fault
    ]
