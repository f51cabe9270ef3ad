"""The cases of a call: what is given for each answer, where inputs are lists or ranges.

Several lists make a grid, in the order in which they were typed: the last runs fastest.
"""

from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import Any, NamedTuple

from radcalc.answer import Input
from radcalc.errors import TooMany, option
from radcalc.given import Given, Inputs, read, read_interval, values_of
from radcalc.maths import is_array
from radcalc.units.ranges import grid, note_of

NOTHING: Mapping[str, str] = MappingProxyType({})


class Case(NamedTuple):
    """What is given for an answer, what of it differs from answer to answer, and notes on it.

    `long` is the input that is a range too long for a case each: its values are an array.
    """

    given: Inputs
    varied: tuple[Input, ...] = ()
    notes: tuple[str, ...] = ()
    long: Given | None = None

    @property
    def label(self) -> str:
        """Which of several it is: `distance 2m, half-angle 30deg`."""
        return label(self.varied)

    @property
    def size(self) -> int:
        """How many answers there are to it."""
        return len(self.long.value) if self.long else 1


def cases(
    typed: dict[str, Any],
    arrays: bool = False,
    intervals: Sequence[str] = (),
    bare: Mapping[str, str] = NOTHING,
) -> list[Case]:
    """The inputs as given; several times where some of them are lists or ranges.

    With `arrays` a long range is one case, whose values are an array, if it is the last of the
    lists; `intervals` are A:B; `bare` has the units of what is mostly written without one.
    """
    values: dict[str, Sequence[Any]] = {}
    is_last = True
    for name, text in reversed(typed.items()):
        is_interval = name in intervals
        try:
            values[name] = [text] if is_interval else values_of(name, text, arrays and is_last)
        except TooMany as error:
            if arrays and not is_last:
                error.hint += f", or {option(name)} behind the other lists"
            raise
        is_last = is_last and len(values[name]) == 1 and not isinstance(values[name][0], tuple)
    given = {
        name: [
            read_interval(name, one)
            if name in intervals
            else read(name, one, uncertain=True, bare=bare.get(name, ""))
            for one in each
        ]
        for name, each in reversed(values.items())
    }
    names = [name for name, each in given.items() if len(each) > 1]
    arrays_given = [one for (one, *_) in given.values() if is_array(one.value)]
    long = arrays_given[0] if arrays_given else None
    size = len(long.value) if long else 1
    notes = tuple(note for name in names for note in note_of(typed[name]))
    return [
        Case(case, tuple([told(case[name]) for name in names]), notes, long)
        for case in grid(given, size)
    ]


def told(given: Given) -> Input:
    """An input as it was typed."""
    return Input(given.name, text=given.text)


def label(varied: Sequence[Input]) -> str:
    """Which of several answers it is."""
    return ", ".join(f"{one.name} {one.text}".strip() for one in varied)
