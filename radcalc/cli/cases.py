"""Cases of a call: the inputs of each answer if some inputs are lists or ranges.

Several lists make a grid in the order in which they were typed: the last varies fastest.
"""

import math
from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from radcalc.answer import ShownInput
from radcalc.errors import MissingUnit, TooMany, Try, UsageError, add, option, quote
from radcalc.inputs.given import Input, Inputs
from radcalc.inputs.reading import read, read_interval, split_values
from radcalc.maths import is_array
from radcalc.quantities.symbols import DISTRIBUTION, QUANTITY, SPECTRUM, SYMBOLS
from radcalc.tuples import NamedTuple
from radcalc.units.ranges import MOST, MOST_IN_ARRAY, grid, note_of, with_larger_step
from radcalc.units.unit import NUMBER, Unit

if TYPE_CHECKING:
    from radcalc.streams import Source

READERS_OF_STDIN = (SPECTRUM, DISTRIBUTION)  # a - is a file for these
NOTHING: Mapping[str, str] = MappingProxyType({})


class Case(NamedTuple):
    """The inputs of an answer, those that differ between answers, and notes on them.

    `long` is an input with an array as its value: a range too long for one case per value.
    `stream` is the input whose values come from standard input; `names` has its place.
    """

    given: Inputs
    varied: tuple[ShownInput, ...] = ()
    notes: tuple[str, ...] = ()
    long: Input | None = None
    stream: "Source | None" = None
    names: tuple[str, ...] = ()

    @property
    def label(self) -> str:
        return label(self.varied)

    @property
    def size(self) -> int:
        return len(self.long.value) if self.long else 1

    def of_line(self, given: Input) -> Inputs:
        """Return the inputs for a line of standard input, in the order in which they were typed."""
        return {name: self.given.get(name, given) for name in self.names}


def cases(
    typed: dict[str, Any],
    arrays: bool = True,
    intervals: Sequence[str] = (),
    bare: Mapping[str, str] = NOTHING,
) -> list[Case]:
    """Return the cases, one for each combination of listed values.

    With `arrays`, a long range that is the last list is one case with an array; `intervals` are
    A:B; `bare` has the units of symbols that are usually written without one.
    """
    names = tuple(typed)
    stream = _stream(typed, intervals, bare)
    typed = {name: text for name, text in typed.items() if not stream or name != stream.name}
    given = _given(typed, _values(typed, arrays, intervals), intervals, bare)
    lists = [name for name, entries in given.items() if len(entries) > 1]
    arrays_given = [first for (first, *_) in given.values() if is_array(first.value)]
    long = arrays_given[0] if arrays_given else None
    size = len(long.value) if long else 1
    notes = tuple(note for name in lists for note in note_of(typed[name]))
    try:
        combined = grid(given, size)
    except TooMany as error:
        answers = math.prod([size, *map(len, given.values())])
        most = MOST if size == 1 else MOST_IN_ARRAY
        coarser = {name: with_larger_step(str(typed[name]), answers, most) for name in lists}
        hint = [add(name, text, "a larger step") for name, text in coarser.items() if text]
        raise error.reworded(hint=hint[::-1] or error.hint) from None
    return [
        Case(case, tuple([as_typed(case[name]) for name in lists]), notes, long, stream, names)
        for case in combined
    ]


def _given(
    typed: dict[str, Any],
    values: dict[str, Sequence[Any]],
    intervals: Sequence[str],
    bare: Mapping[str, str],
) -> dict[str, list[Input]]:
    """Return the inputs of each name, one for each value."""
    given = {}
    for name, entries in reversed(values.items()):
        unit = bare.get(name, "")
        try:
            given[name] = [
                read_interval(name, value)
                if name in intervals
                else read(name, value, uncertain=True, bare=unit)
                for value in entries
            ]
        except MissingUnit as error:
            is_one = len(entries) == 1 or not error.number
            raise (error if is_one else error.of_all(str(typed[name]))) from None
    return given


def _values(
    typed: dict[str, Any], arrays: bool, intervals: Sequence[str]
) -> dict[str, Sequence[Any]]:
    """Return the values of each name, the last name first; refuse lists that are too long."""
    values: dict[str, Sequence[Any]] = {}
    is_last = True
    for name, text in reversed(typed.items()):
        is_interval = name in intervals
        try:
            values[name] = [text] if is_interval else split_values(name, text, arrays and is_last)
        except TooMany as error:
            if arrays and not is_last:
                hint = f"{error.hint}, or {option(name)} after the other lists"
                last = Try(((name, str(text)),), (name,))
                raise TooMany(error.message, hint, [last]) from None
            raise
        is_last = is_last and len(values[name]) == 1 and not isinstance(values[name][0], tuple)
    return values


def at_points(given_cases: Sequence[Case], name: str, words: Sequence[str]) -> list[Case]:
    """Return the cases at each of several typed points."""
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
    """Return the option whose values are lines of standard input, or None; refuse several."""
    streams = [name for name, text in typed.items() if str(text)[:1] in "- " and is_stream(text)]
    sources = [name for name in streams if SYMBOLS[name].form in READERS_OF_STDIN]
    line_streams = [name for name in streams if name not in sources]
    if len(streams) > 1:
        all_ = "both" if len(streams) == 2 else "all"
        listed = " and ".join(option(name, quote(typed[name].strip())) for name in streams)
        raise UsageError(f"{listed} cannot {all_} read standard input", "one -")
    if not line_streams:
        return None
    (name,) = line_streams
    if SYMBOLS[name].form != QUANTITY or name in intervals:
        problem = f"{option(name)} cannot be read from standard input"
        raise UsageError(problem, "- for an option that is one number with its unit")
    unit = str(typed[name]).strip()[1:].strip()

    def read_line(text: str) -> Input:
        return read(name, text, bare=bare.get(name, ""))

    def check(unit: Unit) -> None:
        if unit.dimension not in SYMBOLS[name].dimensions:
            read(name, f"1 {unit.text}")  # its error names the units that fit

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
    """Return an input as it was typed."""
    return ShownInput(given.name, text=given.text)


def label(varied: Sequence[ShownInput]) -> str:
    """Return the inputs that tell an answer from the others."""
    return ", ".join(f"{given.name} {given.text}".strip() for given in varied)
