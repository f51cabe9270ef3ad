"""The cases of a call: what is given for each answer, where inputs are lists or ranges.

Several lists make a grid, in the order in which they were typed: the last runs fastest.
"""

from collections.abc import Sequence
from typing import Any, NamedTuple

from radcalc.answer import Input
from radcalc.errors import TooMany, option
from radcalc.given import Given, Inputs, read, read_interval, values_of
from radcalc.maths import is_array
from radcalc.units.ranges import grid, note_of


class Case(NamedTuple):
    """What is given for an answer, what of it differs from answer to answer, and notes on it."""

    given: Inputs
    varied: tuple[Input, ...] = ()
    notes: tuple[str, ...] = ()

    @property
    def label(self) -> str:
        """Which of several it is: `distance 2m, half-angle 30deg`."""
        return label(self.varied)

    @property
    def long(self) -> Given | None:
        """The input that is a range too long for a case each: its values are an array."""
        return next((one for one in self.given.values() if is_array(one.value)), None)

    @property
    def size(self) -> int:
        """How many answers there are to it."""
        return len(self.long.value) if self.long else 1


def cases(typed: dict[str, Any], arrays: bool = False, intervals: Sequence[str] = ()) -> list[Case]:
    """The inputs as given; several times where some of them are lists or ranges.

    With `arrays` a long range is one case, whose values are an array, if it is the last of the
    lists; `intervals` are A:B.
    """
    values: dict[str, Sequence[Any]] = {}
    for name, text in reversed(typed.items()):
        is_last = not any(_varies(behind) for behind in values.values())
        is_interval = name in intervals
        try:
            values[name] = [text] if is_interval else values_of(name, text, arrays and is_last)
        except TooMany as error:
            if arrays and not is_last:
                error.hint += f", or {option(name)} behind the other lists"
            raise
    given = {
        name: [
            read_interval(name, one) if name in intervals else read(name, one, uncertain=True)
            for one in each
        ]
        for name, each in reversed(values.items())
    }
    names = [name for name, each in given.items() if len(each) > 1]
    long = next((len(one.value) for (one, *_) in given.values() if is_array(one.value)), 1)
    notes = tuple(note for name in names for note in note_of(typed[name]))
    return [
        Case(case, tuple(told(case[name]) for name in names), notes) for case in grid(given, long)
    ]


def _varies(values: Sequence[Any]) -> bool:
    """Whether an option has several values, or one that is an array."""
    return len(values) > 1 or isinstance(values[0], tuple)


def told(given: Given) -> Input:
    """An input as it was typed."""
    return Input(given.name, text=given.text)


def label(varied: Sequence[Input]) -> str:
    """Which of several answers it is."""
    return ", ".join(f"{one.name} {one.text}".strip() for one in varied)
