"""The numbers after the label of an IES LM-63 file."""

import re
from bisect import bisect_right
from collections.abc import Sequence
from itertools import accumulate
from typing import Any

import numpy

from radcalc.errors import ConditionError, quote
from radcalc.files.columns import has_odd_digits, is_number, numbers_at_once
from radcalc.files.text import refusal

BEYOND = 1e18  # limit of a number, so that products stay finite


class Numbers:
    """The numbers after the label, in order; `start` is the line of the label's end."""

    def __init__(self, lines: Sequence[str], start: int, name: str) -> None:
        self.name = name
        self.start = start
        self.place = 0
        self.body = list(lines[start:])
        while self.body and self.body[-1].strip().upper() in ("", "END"):
            self.body.pop()
        values = _at_once(self.body)
        self.values = numpy.array(self._one_by_one()) if values is None else values
        are_sound = numpy.abs(self.values) < BEYOND
        if not are_sound.all():
            place = int(numpy.argmin(are_sound))
            problem = f"{self.values[place]:g} is out of range: numbers must be below {BEYOND:g}"
            raise self.error(place, problem, "a finite number")

    def _one_by_one(self) -> list[float]:
        lines = enumerate(self.body, self.start + 1)
        return [value for number, line in lines for value in self.numbers(line, number)]

    def numbers(self, line: str, number: int) -> list[float]:
        words = line.split()
        values = numbers_at_once(line, words)
        if values is not None:
            return values
        if len(words) > 1 and any(re.fullmatch(r"[+-]?\d+,\d+", word) for word in words):
            raise refusal(
                self.name,
                number,
                "a number has a decimal comma",
                "decimal points: commas separate numbers",
            )
        if re.search(r",\s*,", line):
            raise refusal(self.name, number, "a number is missing between two commas", "a number")
        words = " ".join(words).replace(",", " ").split()
        for word in words:
            if not is_number(word, False):
                raise refusal(
                    self.name,
                    number,
                    f"'{quote(word)}' is not a number",
                    "only numbers after TILT",
                )
        return list(map(float, words))

    @property
    def ends(self) -> list[int]:
        """Return the count of numbers up to the end of each line."""
        return [*accumulate(len(line.replace(",", " ").split()) for line in self.body)]

    def error(self, place: int, problem: str, hint: str) -> ConditionError:
        """Return an error about the number at an index."""
        line = bisect_right(self.ends, min(place, len(self.values) - 1))
        return refusal(self.name, self.start + line + (1 if len(self.values) else 0), problem, hint)

    def take(self, count: int) -> Any:
        """Return the next numbers; the caller has checked that there are enough."""
        self.place += count
        return self.values[self.place - count : self.place]

    def number(self) -> float:
        return float(self.take(1)[0])

    def remaining(self) -> int:
        return len(self.values) - self.place

    def whole(self, what: str, least: int) -> int:
        value = self.number()
        if value != int(value) or value < least:
            raise self.error(
                self.place - 1, f"the {what} is {value:g}", f"a whole number, {least} or more"
            )
        return int(value)

    def one_of(self, what: str, codes: dict[int, str]) -> int:
        value = self.number()
        if value not in codes:
            meanings = ", ".join(f"{code} ({meaning})" for code, meaning in codes.items())
            raise self.error(self.place - 1, f"the {what} is {value:g}", f"one of: {meanings}")
        return int(value)

    def factor(self, what: str) -> float:
        value = self.number()
        if value <= 0:
            raise self.error(self.place - 1, f"the {what} is {value:g}", "a factor above 0")
        return value

    def need(self, count: int, what: str) -> None:
        if self.remaining() < count:
            raise self.error(
                len(self.values),
                f"the file ends after {self.remaining()} of {what}",
                f"{count} numbers, and the rest of the file",
            )


def _at_once(lines: Sequence[str]) -> Any:
    """Return the numbers of lines as an array, read at once; None if a word is not a number."""
    text = " ".join(lines)
    if not text.strip() or has_odd_digits(text):
        return None
    try:
        return numpy.loadtxt([text], comments=None, ndmin=1)
    except ValueError:
        return None
