"""The request of a call: the cases of its inputs, its results, checks and lines.

Cases are the inputs of each answer if some inputs are lists or ranges.  Several lists make a grid
in the order in which they were typed: the last varies fastest.
"""

import math
from collections.abc import Callable, Mapping, Sequence
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from radcalc import errors, terminal
from radcalc.answer import Answer, Row, ShownInput
from radcalc.calculators.page import Page
from radcalc.calculators.solved import requesting
from radcalc.errors import MissingUnit, TooMany, Try, UsageError, add, option, quote
from radcalc.inputs import Input, Inputs
from radcalc.inputs.reading import read, read_interval, split_values
from radcalc.maths import is_array
from radcalc.quantities.symbols import DISTRIBUTION, QUANTITY, SPECTRUM, SYMBOLS
from radcalc.tuples import NamedTuple
from radcalc.units import NUMBER, Unit
from radcalc.units.ranges import MOST, MOST_IN_ARRAY, grid, note_of, with_larger_step

if TYPE_CHECKING:
    from radcalc.cli.output import Output
    from radcalc.homework.question import Question
    from radcalc.streams import Source


def refuse_idle(check: str | None, tolerance: str | None) -> None:
    """Refuse --tolerance without --check."""
    if tolerance is not None and check is None:
        problem = "--tolerance does not apply without --check"
        raise errors.UsageError(problem, errors.leave_out("tolerance"))


def several(
    varied: Sequence[ShownInput] = (), operands: Sequence[tuple[str, str]] = ()
) -> errors.UsageError:
    """Return the error for --check with several answers, with the first values as a proposal.

    `varied` are the inputs with several values, `operands` the lists typed as words, each with
    its first value.
    """
    problem = "--check takes one answer, not several"
    first = first_of(varied)
    if first.inputs:
        return errors.UsageError(problem, first)
    lists = [errors.correct(typed, value) for typed, value in operands if typed != value]
    return errors.UsageError(problem, lists or errors.leave_out("check"))


def first_of(varied: Sequence[ShownInput]) -> errors.Try:
    """Propose the first value of each input that has several."""
    return errors.Try(tuple([(given.name, given.text) for given in varied if given.name]))


def refuse_stream(check: str | None) -> None:
    """Refuse --check with a stream."""
    if check is not None:
        raise errors.UsageError("--check cannot be used with a stream", errors.leave_out("check"))


def judge(
    question: "Question",
    claim: str,
    tolerance: str | None,
    output: "Output",
    inputs: Sequence[ShownInput] = (),
) -> int:
    """Write whether an answer is right, or its likely mistake; return the exit status."""
    output.ask(question)
    from radcalc.calculators.results import of_kind, said_of
    from radcalc.homework import check
    from radcalc.inputs.quantities import measured_in
    from radcalc.render.formats import Judgement

    output.refuse_auto("--check compares it with the answer given", errors.leave_out("auto"))
    verdict = check(question, claim, tolerance)
    answer = question.answer
    right = next(value for value in answer.values if value.name == verdict.result)
    name = right.also if question.plan else verdict.name
    label = of_kind(right, measured_in(verdict.unit, right.name))
    is_given, off = right.given is not None, verdict.uncertainty
    row = Row(*label, verdict.value, verdict.unit, "", name, is_given, off)
    output.judge(Judgement(verdict, row, inputs, *said_of(answer, [row])))
    return terminal.ANSWERED if verdict.right else terminal.WRONG


class LineOptions(NamedTuple):
    """The options for streams as typed, or None."""

    field: str | None
    column: str | None
    delimiter: str | None
    header: int | None
    add: str | None
    rename: str | None
    decimal: str | None
    invalid: str | None


def refuse_lines(options: LineOptions, hint: errors.Hint) -> None:
    """Refuse an option for streams if there is no stream."""
    for name, value in zip(LineOptions._fields, options, strict=True):
        if value is not None and value in SYMBOLS["electric-field"].choices:
            raise errors.UsageError(
                f"--{name} {value} applies to the fields of lines, not to a wave",
                errors.Try((("electric-field", value),), (name,), remark="for a wave"),
            )
        if value is not None:
            raise errors.UsageError(f"--{name} applies to lines of standard input only", hint)


def refuse_second_reader(typed: dict[str, Any]) -> None:
    """Refuse a spectrum from standard input, which has the numbers."""
    if str(typed.get("spectrum", "")).partition(":")[0].strip() == "-":
        problem = "- cannot be used twice: there is one standard input"
        raise errors.UsageError(problem, add("spectrum"))


def refuse_condition(case: "Case") -> None:
    """Refuse lines of standard input for a condition of a conversion."""
    if case.stream:
        stream_option = errors.option(case.stream.name, "-")
        problem = f"{stream_option}: a conversion reads lines of standard input only for VALUE"
        raise errors.UsageError(problem, errors.command("convert", "-", "UNIT", "TARGET"))


class Request(NamedTuple):
    """The requested results, derivation, check and picture.

    `lines` are the options for lines of standard input; `plot` is the place of the picture.
    """

    wanted: tuple[str, ...] = ()
    steps: bool = False
    check: str | None = None
    tolerance: str | None = None
    lines: LineOptions | None = None
    plot: str = ""

    @classmethod
    def of(cls, values: dict[str, Any], takes_lines: bool) -> "Request":
        """Take the request out of a command's values; refuse --check and --get together."""
        lines = None
        if takes_lines:
            line_values = [values.pop(name) for name in LineOptions._fields]
            lines = LineOptions(*line_values)
        from radcalc.calculators.results import listed_in

        wanted, steps = listed_in(values.pop("wanted")), values.pop("steps")
        checked, tolerance = values.pop("check"), values.pop("tolerance")
        request = cls(wanted, steps, checked, tolerance, lines, values.pop("plot", None) or "")
        refuse_idle(request.check, request.tolerance)
        if request.check is not None and request.wanted:
            tries = [*_named(request.check, request.wanted), errors.leave_out("check")]
            raise errors.UsageError("--check cannot be used with --get", tries)
        return request

    def wants(self, name: str) -> bool:
        """Return whether a result is requested, by its name or a spelling of it: R9, R_f,h1."""
        from radcalc.calculators.results import name_of

        names = [*self.wanted, (self.check or "").replace("=", ":")]
        return _letters(name) in [_letters(name_of(text)) for text in names]

    def narrowed(self, function: Callable[..., Answer], page: Page) -> Callable[..., Answer]:
        """Return the function of a page that also calculates the requested results."""
        return requesting(function, tuple(filter(self.wants, page.on_request)))


def _named(claim: str, wanted: "Sequence[str]") -> "list[errors.Try]":
    """Propose an answer with the name and the unit of a requested result."""
    from radcalc.homework.question import read_claim

    typed = read_claim(claim)
    pairs = [text.partition(":")[::2] for text in wanted if not typed.name]
    claims = [f"{name}={claim}{'' if typed.unit else unit}" for name, unit in pairs] or [claim]
    return [errors.Try((("check", text),), ("get",), follow=True) for text in claims]


def _letters(name: str) -> str:
    return "".join(filter(str.isalnum, name.lower()))


TO_TERMINAL = "-"  # --plot without a file


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
        from radcalc.units.values import resolve_given

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
