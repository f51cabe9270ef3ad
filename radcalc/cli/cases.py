"""The cases of a call: what is given for each answer, where inputs are lists or ranges.

Several lists make a grid, in the order in which they were typed: the last runs fastest.
"""

from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from radcalc.answer import ShownInput
from radcalc.errors import TooMany, UsageError, option, quote
from radcalc.inputs.given import Input, Inputs
from radcalc.inputs.reading import read, read_interval, split_values
from radcalc.maths import is_array
from radcalc.quantities.symbols import DISTRIBUTION, QUANTITY, SPECTRUM, SYMBOLS
from radcalc.tuples import NamedTuple
from radcalc.units.ranges import grid, note_of
from radcalc.units.unit import NUMBER, Unit

if TYPE_CHECKING:
    from radcalc.streams import Source

READERS_OF_STDIN = (SPECTRUM, DISTRIBUTION)  # of which - is a file
NOTHING: Mapping[str, str] = MappingProxyType({})


class Case(NamedTuple):
    """The inputs of an answer, those that differ from answer to answer, and notes on them.

    `long` is the input that is a range too long for a case each: its values are an array.
    `stream` is the input of which standard input has the values, where `names` has its place.
    """

    given: Inputs
    varied: tuple[ShownInput, ...] = ()
    notes: tuple[str, ...] = ()
    long: Input | None = None
    stream: "Source | None" = None
    names: tuple[str, ...] = ()

    @property
    def label(self) -> str:
        """Return which of several cases it is: `distance 2m, half-angle 30deg`."""
        return label(self.varied)

    @property
    def size(self) -> int:
        """Return the number of answers to it."""
        return len(self.long.value) if self.long else 1

    def of_line(self, given: Input) -> Inputs:
        """All that is given for a line of standard input, in the order in which it was typed."""
        return {name: self.given.get(name, given) for name in self.names}


def cases(
    typed: dict[str, Any],
    arrays: bool = True,
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
    values = _values(typed, arrays, intervals)
    given = {
        name: [
            read_interval(name, value)
            if name in intervals
            else read(name, value, uncertain=True, bare=bare.get(name, ""))
            for value in entries
        ]
        for name, entries in reversed(values.items())
    }
    lists = [name for name, entries in given.items() if len(entries) > 1]
    arrays_given = [first for (first, *_) in given.values() if is_array(first.value)]
    long = arrays_given[0] if arrays_given else None
    size = len(long.value) if long else 1
    notes = tuple(note for name in lists for note in note_of(typed[name]))
    return [
        Case(case, tuple([as_typed(case[name]) for name in lists]), notes, long, stream, names)
        for case in grid(given, size)
    ]


def _values(
    typed: dict[str, Any], arrays: bool, intervals: Sequence[str]
) -> dict[str, Sequence[Any]]:
    """Split lists and ranges into values, the last input first."""
    values: dict[str, Sequence[Any]] = {}
    is_last = True
    for name, text in reversed(typed.items()):
        is_interval = name in intervals
        try:
            values[name] = [text] if is_interval else split_values(name, text, arrays and is_last)
        except TooMany as error:
            if arrays and not is_last:
                hint = f"{error.hint}, or {option(name)} behind the other lists"
                raise error.reworded(hint=hint) from None
            raise
        is_last = is_last and len(values[name]) == 1 and not isinstance(values[name][0], tuple)
    return values


def at_points(given_cases: Sequence[Case], name: str, words: Sequence[str]) -> list[Case]:
    """Return the cases at each of several points, which words say."""
    from radcalc.inputs.places import read_place

    points = [read_place(name, word) for word in words]
    places = [(as_typed(point),) if len(points) > 1 else () for point in points]
    return [
        case._replace(given=case.given | {name: point}, varied=(*place, *case.varied))
        for point, place in zip(points, places, strict=True)
        for case in given_cases
    ]


def _stream(
    typed: dict[str, Any], intervals: Sequence[str], bare: Mapping[str, str]
) -> "Source | None":
    """The option that is - or '- UNIT', and how a line of standard input is read for it."""
    streams = [name for name, text in typed.items() if str(text)[:1] in "- " and is_stream(text)]
    sources = [name for name in streams if SYMBOLS[name].form in READERS_OF_STDIN]
    line_streams = [name for name in streams if name not in sources]
    if len(streams) > 1:
        listed = " and ".join(option(name, quote(typed[name].strip())) for name in streams)
        raise UsageError(f"{listed}: there is one standard input", "one -")
    if not line_streams:
        return None
    (name,) = line_streams
    if SYMBOLS[name].form != QUANTITY or name in intervals:
        problem = f"{option(name)} takes no lines of standard input"
        raise UsageError(problem, "- for an option that is one number with its unit")
    unit = str(typed[name]).strip()[1:].strip()

    def read_line(text: str) -> Input:
        return read(name, text, bare=bare.get(name, ""))

    def check(unit: Unit) -> None:
        if unit.dimension not in SYMBOLS[name].dimensions:
            read(name, f"1 {unit.text}")  # which says what it takes

    if unit:
        from radcalc.units.scales import resolve_given

        check(resolve_given(unit))
    is_bare = bool(unit) or name in bare or NUMBER in SYMBOLS[name].dimensions
    from radcalc.streams import Source

    return Source(name, unit, is_bare, read_line, check)


def is_stream(text: Any) -> bool:
    """Return whether a text is - or '- UNIT'."""
    return isinstance(text, str) and text.strip().partition(" ")[0] == "-"


def as_typed(given: Input) -> ShownInput:
    """An input as it was typed."""
    return ShownInput(given.name, text=given.text)


def label(varied: Sequence[ShownInput]) -> str:
    """Return the inputs that tell an answer from the others."""
    return ", ".join(f"{given.name} {given.text}".strip() for given in varied)
