"""The cases of a call: what is given for each answer, where inputs are lists or ranges.

Several lists make a grid, in the order in which they were typed: the last runs fastest.
"""

from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import Any, NamedTuple

from radcalc.answer import Input
from radcalc.errors import TooMany, UsageError, option, quote
from radcalc.given import Given, Inputs, read, read_interval, values_of
from radcalc.maths import is_array
from radcalc.quantities.symbols import DISTRIBUTION, QUANTITY, SPECTRUM, SYMBOLS
from radcalc.streams import Source
from radcalc.units.ranges import grid, note_of
from radcalc.units.scales import resolve_given
from radcalc.units.table import NUMBER, Unit

READERS_OF_STDIN = (SPECTRUM, DISTRIBUTION)  # of which - is a file
NOTHING: Mapping[str, str] = MappingProxyType({})


class Case(NamedTuple):
    """What is given for an answer, what of it differs from answer to answer, and notes on it.

    `long` is the input that is a range too long for a case each: its values are an array.
    `stream` is the input of which standard input has the values, where `names` has its place.
    """

    given: Inputs
    varied: tuple[Input, ...] = ()
    notes: tuple[str, ...] = ()
    long: Given | None = None
    stream: Source | None = None
    names: tuple[str, ...] = ()

    @property
    def label(self) -> str:
        """Which of several it is: `distance 2m, half-angle 30deg`."""
        return label(self.varied)

    @property
    def size(self) -> int:
        """How many answers there are to it."""
        return len(self.long.value) if self.long else 1

    def of_line(self, given: Given) -> Inputs:
        """All that is given for a line of standard input, in the order in which it was typed."""
        return {name: self.given.get(name, given) for name in self.names}


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
    names = tuple(typed)
    stream = _stream(typed, intervals, bare)
    typed = {name: text for name, text in typed.items() if not stream or name != stream.name}
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
    lists = [name for name, each in given.items() if len(each) > 1]
    arrays_given = [one for (one, *_) in given.values() if is_array(one.value)]
    long = arrays_given[0] if arrays_given else None
    size = len(long.value) if long else 1
    notes = tuple(note for name in lists for note in note_of(typed[name]))
    return [
        Case(case, tuple([told(case[name]) for name in lists]), notes, long, stream, names)
        for case in grid(given, size)
    ]


def _stream(
    typed: dict[str, Any], intervals: Sequence[str], bare: Mapping[str, str]
) -> Source | None:
    """The option that is - or '- UNIT', and how a line of standard input is read for it."""
    streams = [name for name, text in typed.items() if str(text)[:1] in "- " and is_stream(text)]
    sources = [name for name in streams if SYMBOLS[name].form in READERS_OF_STDIN]
    own = [name for name in streams if name not in sources]
    if len(streams) > 1:
        told = " and ".join(option(name, quote(typed[name].strip())) for name in streams)
        raise UsageError(f"{told}: there is one standard input", "one -")
    if not own:
        return None
    (name,) = own
    if SYMBOLS[name].form != QUANTITY or name in intervals:
        problem = f"{option(name)} takes no lines of standard input"
        raise UsageError(problem, "- for an option that is one number with its unit")
    unit = str(typed[name]).strip()[1:].strip()

    def read_line(text: str) -> Given:
        return read(name, text, bare=bare.get(name, ""))

    def check(unit: Unit) -> None:
        if unit.dimension not in SYMBOLS[name].dimensions:
            read(name, f"1 {unit.text}")  # which says what it takes

    if unit:
        check(resolve_given(unit))
    is_bare = bool(unit) or name in bare or NUMBER in SYMBOLS[name].dimensions
    return Source(name, unit, is_bare, read_line, check)


def is_stream(text: Any) -> bool:
    """Whether a text is - or '- UNIT'."""
    return isinstance(text, str) and text.strip().partition(" ")[0] == "-"


def told(given: Given) -> Input:
    """An input as it was typed."""
    return Input(given.name, text=given.text)


def label(varied: Sequence[Input]) -> str:
    """Which of several answers it is."""
    return ", ".join(f"{one.name} {one.text}".strip() for one in varied)
