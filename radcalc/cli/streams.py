"""Standard input, line by line: `radcalc convert -`, and a calculator with - for an input."""

import os
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import click

from radcalc import stdio
from radcalc.answer import Answer, Input, Result, Value
from radcalc.cli.cases import Case
from radcalc.cli.options import WITHOUT_NUMBERS, Output
from radcalc.cli.spelling import spelled
from radcalc.conversion.plan import Plan, answer, plan, target_of
from radcalc.errors import NumberError, RadcalcError, Unused, UsageError, command, option, quote
from radcalc.given import Given, Inputs, inputs_of, refuse_uncertain
from radcalc.quantities.symbols import SYMBOLS
from radcalc.render.formats import CSV, JSON, TABLE
from radcalc.streams import ABORT, INVALID, MARK, Source
from radcalc.units.amounts import read_stream_operands
from radcalc.units.scales import resolve_any, resolve_given
from radcalc.units.table import Unit, resolve

if TYPE_CHECKING:
    from radcalc.streams.fields import Cut, Fields
    from radcalc.streams.header import Header
    from radcalc.streams.readers import Texts
    from radcalc.streams.stream import Record


class LineOptions(NamedTuple):
    """The options for streams, as typed; None where they are not."""

    field: str | None
    column: str | None
    delimiter: str | None
    header: int | None
    add: str | None
    rename: str | None
    decimal: str | None
    invalid: str | None


OPTIONS = (
    click.Option(
        ["--field"], metavar="LIST", help="Which fields are numbers: 3, 1,3, 2-4, 3-, -2 or -."
    ),
    click.Option(
        ["--column"],
        metavar="NAME",
        help="The field under that title, which may be without its unit (E for E [lx]), or with "
        "that number.",
    ),
    click.Option(
        ["-d", "--delimiter"],
        metavar="X",
        help="What cuts the fields: one character, or tab (default: runs of blanks).",
    ),
    click.Option(
        ["--header"],
        type=click.IntRange(1),
        metavar="[=N]",
        help="The first line has titles, or the first N (--header=2); --column implies 1.  Every "
        "line has as many fields; a unit in the title is checked, and becomes TARGET.",
    ),
    click.Option(
        ["--add"], metavar="NAME", help="Keep the field, and add a last one with the result."
    ),
    click.Option(
        ["--rename"],
        metavar="NAME",
        help="The new title of the field, which one of another quantity needs.",
    ),
    click.Option(
        ["--decimal"],
        type=click.Choice([".", ","]),
        help="The decimal mark of the numbers, in and out: a comma, or a point (the default).",
    ),
    click.Option(
        ["--invalid"],
        type=click.Choice(INVALID),
        help="At a line that cannot be converted: stop (abort, the default), or pass it through "
        "and fail at the end (status 2), warn (status 0) or ignore it (status 0).",
    ),
)


def refuse(asked: LineOptions, hint: str = command("convert", "-", "UNIT", "TARGET")) -> None:
    """Refuse an option for streams where there is none."""
    for name, value in zip(LineOptions._fields, asked, strict=True):
        if value is not None and value in SYMBOLS["electric-field"].choices:
            raise UsageError(
                f"--{name} {value} is for the fields of lines",
                f"{option('electric-field', value)} in place of {option(name)}, for a wave",
            )
        if value is not None:
            raise UsageError(f"--{name} is for lines of standard input", hint)


def refuse_second_reader(typed: dict[str, Any]) -> None:
    """Refuse a spectrum from standard input, which has the numbers."""
    if str(typed.get("spectrum", "")).partition(":")[0].strip() == "-":
        raise UsageError("there is more than one -, and one standard input", "--spectrum FILE")


def refuse_condition(case: Case) -> None:
    """Refuse lines of standard input for a condition of a conversion."""
    if case.stream:
        told = option(case.stream.name, "-")
        problem = f"{told}: a conversion takes lines of standard input for VALUE alone"
        raise UsageError(problem, command("convert", "-", "UNIT", "TARGET"))


def convert(
    words: list[str],
    asked: LineOptions,
    cases: Sequence[Case],
    steps: bool,
    shown: Output,
) -> int:
    """Convert standard input; return the exit status."""
    shown.refuse_auto(
        "a stream has one for all its lines", "a TARGET that fits, such as mlx or klx"
    )
    from radcalc.streams.readers import Numbers, Quantities, Texts

    source_text, target_text = read_stream_operands(words)
    if "," in target_text:
        problem = f"'{quote(target_text)}' is a list, and a stream has one target"
        raise UsageError(problem, "one unit a call")
    given = _given(cases, steps)
    _refuse_format(shown)
    layout = Layout.of(asked, bool(source_text))
    cut, _, lines, mark, name, adds = layout
    as_json = shown.format == JSON
    source = resolve_any(source_text) if source_text else None
    target = target_of(target_text, source)
    said: set[str] = set()

    def remark(assumptions: Sequence[str], notes: Sequence[str]) -> None:
        if shown.style.remarks and not as_json:
            told = stdio.remarks(assumptions, notes)
            stdio.say([spelled(line) for line in dict.fromkeys(told) if line not in said])
            said.update(told)

    def planned(unit: Unit, *assumptions: str) -> Plan:
        try:
            made = plan(unit, target, given)
        except Unused as error:
            if not (source or assumptions):  # lines to come may be in units that use it
                error.hint += ", or a call for each kind of line"
            raise
        if lines and name is None:
            refuse_change(made.source, made.target)
        made.assumptions = (*assumptions, *made.assumptions)
        remark(made.assumptions, made.notes)
        return made

    precision = shown.style.precision

    def titled(unit: Unit) -> tuple[Texts, Unit]:
        told = f"the numbers are in {quote(unit.text)}, as their title says"
        texts = Numbers(planned(unit, told), precision, mark)
        texts.example = "a number alone: the title has its unit"
        return texts, target

    header = None
    if lines or name is not None:
        from radcalc.streams.header import Header, refuse_change

        def note(text: str) -> None:
            remark((), (text,))

        column = asked.column or ""
        header = Header(cut, source, target, titled, note, column, name, adds)
    texts: Texts
    if source:
        if target.text != " ".join(target_text.split()):  # a quantity by its name
            target.notes += (f"the numbers are in {target.text}",)
        texts = Numbers(planned(source), precision, mark)
    else:
        blank = " " if cut else "\t"
        is_bare = shown.style.bare or (lines and adds)
        unit = "" if is_bare else blank + target.text
        texts = Quantities(planned, unit.encode(), precision, mark)

    conditions = inputs_of({one.name: one for one in given})

    def record(line: int, field: int | None, made: Plan, value: float) -> str:
        from radcalc.render import json

        place = _place(line, field)
        if header and (title := header.shown.get(field) or header.title_of()):
            place["column"] = title
        inputs = (Input("value", value, made.source.text), *conditions)
        return json.line(answer(made, value, inputs=inputs).spelled(spelled), shown.style, place)

    return layout.run(texts, header, record if as_json else None, stdio.pour, asked.invalid)


def calculate(
    case: Case,
    work_out: Callable[[Inputs], Answer],
    wanted: Sequence[str],
    asked: LineOptions,
    shown: Output,
    operands: Sequence[Input] = (),
) -> int:
    """Answer to every line of standard input; return the exit status.

    `wanted` are the results that take the place of what is read.
    """
    from radcalc.calculators.results import rows
    from radcalc.streams.calculated import Calculated, Found
    from radcalc.streams.header import refuse_change

    source = case.stream
    assert source is not None
    shown.refuse_auto("a stream has one unit for all its lines", "the same without --auto")
    _refuse_format(shown)
    refuse_uncertain(case.given.values(), "a stream")
    as_json = shown.format == JSON
    layout = Layout.of(asked, source.is_bare)
    if len(wanted) > 1 and not as_json and (layout.cut or layout.lines or layout.adds):
        raise UsageError(f"{len(wanted)} results in the place of one field", "-g once")
    remarks = Remarks(shown.style.remarks and not as_json)

    has_titles = bool(layout.lines) and not as_json
    target: Unit | None = None  # of the results, which a title has

    def of_value(given: Given) -> Answer:
        return work_out(case.of_line(given))

    def of_line(given: Given) -> Answer:
        if has_titles and layout.name is None and target:
            refuse_change(given.unit or resolve("1"), target)
        return of_value(given)

    def texts_of(source: Source, wanted: Sequence[str]) -> Calculated:
        heard, precision = remarks.hear, shown.style.precision
        return Calculated(source, of_line, wanted, heard, precision, layout.mark)

    def titled(unit: Unit) -> tuple[Calculated, Unit]:
        nonlocal target
        remarks.note("assumed", f"the numbers are in {quote(unit.text)}, as their title says")
        source.check(unit)
        of_unit = source._replace(unit=unit.text)
        names = _in_units(of_unit, of_value, wanted, as_json)
        target = _unit_of(names)
        if target is None and not as_json:
            raise UsageError("a title has a unit", option("get", "NAME:UNIT"))
        if has_titles and layout.name is None and target:
            refuse_change(unit, target)
        return texts_of(of_unit, names), target or resolve("1")

    def record(line: int, field: int | None, given: Given, found: Found) -> str:
        from radcalc.render import json

        inputs = (*operands, *inputs_of(case.of_line(given)))
        answer = found.answer
        chosen = found.rows if wanted else rows(answer.values)
        said = tuple(answer.assumptions), tuple(answer.notes)
        result = Result(tuple(chosen), *said, inputs=inputs)
        return json.line(result.spelled(spelled), shown.style, _place(line, field))

    def write(data: bytes) -> None:
        remarks.say()
        stdio.pour(data)

    named = _in_units(source, of_value, wanted, as_json)
    header = None
    if layout.lines or layout.adds:
        target = _unit_of(named)
        header = _header(source, asked, layout, target, as_json, titled, remarks)
        wanted = named if has_titles else wanted
    texts = texts_of(source, wanted)
    return layout.run(texts, header, record if as_json else None, write, asked.invalid)


def _header(
    source: Source,
    asked: LineOptions,
    layout: "Layout",
    target: Unit | None,
    as_json: bool,
    titled: "Callable[[Unit], tuple[Texts, Unit]]",
    remarks: "Remarks",
) -> "Header":
    """What reads the titles over the input, and writes that of the result, in the target's unit."""
    from radcalc.streams.header import Header, refuse_change

    own = resolve_given(source.unit) if source.unit else None
    if layout.name is None and own and target and not as_json:
        refuse_change(own, target)
    return Header(
        layout.cut,
        own,
        resolve("1") if as_json else target,
        titled,
        lambda text: remarks.note("note", text),
        asked.column or "",
        "result" if as_json else layout.name,  # JSON has no titles
        layout.adds and not as_json,
        lambda unit: option(source.name, f"- {unit}"),
        source.is_bare,
    )


def _unit_of(wanted: Sequence[str]) -> Unit | None:
    """The unit of the first result, NAME:UNIT; None where the name is alone."""
    text = wanted[0].partition(":")[2].strip() if wanted else ""
    return resolve_any(text) if text else None


def _in_units(
    source: Source, of_line: Callable[[Given], Answer], wanted: Sequence[str], as_json: bool
) -> Sequence[str]:
    """The results NAME:UNIT that lines have; where only a line tells the unit, NAME.

    Refuses what no line has, by what follows of a value of the same kind in the same unit.
    """
    from radcalc.calculators.results import name_of, names_of, pick

    values = _likely(source, of_line)
    if not wanted and not as_json:
        names = names_of([one for one in values if one.given is None]) or ["NAME:UNIT"]
        told = option(source.name, "-")
        raise UsageError(f"{told} takes a result for every line", f"-g with {', '.join(names)}")
    named = list(wanted)
    for k, one in enumerate(wanted if values else ()):
        try:
            row = pick(values, one)
        except NumberError:  # of that value
            continue
        except UsageError:
            if name_of(one) not in {v.name for v in values if v.is_absent}:
                raise
            continue
        if source.unit or not row.given:  # which has the unit of its line
            named[k] = f"{row.name}:{row.unit}"
    return named


def _likely(source: Source, of_line: Callable[[Given], Answer]) -> Sequence[Value]:
    """What follows of a line as there may be one; nothing where the lines may be of other kinds."""
    symbol = SYMBOLS[source.name]
    example = source.read(symbol.example)
    texts = [symbol.example]
    if source.unit:
        unit = resolve_given(source.unit)
        is_like = unit.dimension == example.dimension and not unit.is_scale
        texts = [f"{example.value / unit.factor!r} {source.unit}"] if is_like else []
        texts.append(f"1 {source.unit}")
    elif len(symbol.dimensions) > 1 and not source.is_bare:
        return ()
    for text in texts:
        try:
            return of_line(source.read(text)).values
        except RadcalcError:  # of everything else, which the first line says, or of that value
            continue
    return ()


class Remarks:
    """What is to be said of the answers to lines: once, and of which line where not of all.

    What differs in its numbers alone is the same.
    """

    def __init__(self, are_wanted: bool) -> None:
        """Say nothing unless it is wanted."""
        self.are_wanted = are_wanted
        self.lines: dict[str, int] = {}  # of what is not said yet, the first
        self.known: set[str] = set()  # without numbers, as what is shared
        self.shared: set[str] | None = None  # by all lines before anything is said
        self.has_begun = False

    def hear(self, texts: Sequence[str], line: int) -> None:
        """Take what there is to say of a line; MARK stands for numbers that depend on its own."""
        if not self.has_begun:
            own = {_without_numbers(text) for text in texts}
            self.shared = own if self.shared is None else self.shared & own
        for text in texts:
            if MARK not in text and (key := _without_numbers(text)) not in self.known:
                self.known.add(key)
                self.lines[text] = line

    def note(self, word: str, text: str) -> None:
        """Say at once what holds for the whole stream."""
        if self.are_wanted:
            stdio.say([spelled(f"{word}: {text}")])

    def say(self) -> None:
        """Say what was heard, before the answers are written."""
        if self.are_wanted and self.lines:
            shared = () if self.has_begun else self.shared or ()
            said = [
                text if _without_numbers(text) in shared else _of_line(text, line)
                for text, line in self.lines.items()
            ]
            stdio.say([spelled(text) for text in said])
        self.has_begun = self.has_begun or self.shared is not None
        self.lines.clear()


def _without_numbers(text: str) -> str:
    return text.replace(MARK, "").translate(WITHOUT_NUMBERS)


def _of_line(text: str, line: int) -> str:
    """What is assumed or noted, with the line for which it is."""
    word, mark, rest = text.partition(": ")
    return f"{word}{mark}line {line}: {rest}"


def _refuse_format(shown: Output) -> None:
    """Refuse a format that has a header or borders, if it was asked for."""
    if shown.is_chosen and shown.format in (TABLE, CSV):
        raise UsageError(f"--format {shown.format} is not for a stream", "--format plain or json")


class Layout(NamedTuple):
    """How lines fall into fields and which of these are read, as the options say it.

    `lines` are those of a header; `mark` is the decimal mark, `name` the title of the results.
    """

    cut: "Cut | None"
    fields: "Fields"
    lines: int
    mark: bytes
    name: str | None
    adds: bool

    @classmethod
    def of(cls, asked: LineOptions, has_unit: bool) -> "Layout":
        """Read the options; lines whose numbers have no unit may be cut at blanks."""
        from radcalc.streams.fields import Cut, Fields, read_delimiter

        if asked.field is not None and asked.column is not None:
            raise UsageError("--field and --column contradict each other", "one of them")
        if asked.add is not None and asked.rename is not None:
            raise UsageError("--add and --rename contradict each other", "one of them")
        lines = asked.header or (1 if asked.column is not None else 0)
        if asked.rename is not None and not lines:
            raise UsageError("--rename needs a header", "--header, or --column NAME")
        if not has_unit and asked.delimiter is None and asked.field is not None and not lines:
            raise UsageError(
                "--field needs --delimiter where the lines carry their own units",
                "--delimiter X, which says what cuts the fields",
            )
        cut = None
        if (asked.field, asked.column, asked.delimiter) != (None, None, None):
            delimiter = read_delimiter(asked.delimiter) if asked.delimiter is not None else ""
            cut = Cut(os.fsencode(delimiter))
        mark = (asked.decimal or ".").encode()
        if cut and cut.delimiter == mark != b".":
            raise UsageError(
                "--decimal , and --delimiter , contradict each other", option("delimiter", "tab")
            )
        fields = Fields("1" if asked.field is None else asked.field)
        name = asked.rename if asked.add is None else asked.add
        name = None if name is None else name.strip()
        if name is not None and not fields.is_one:
            raise UsageError("--add and --rename are for one field", "a call for each field")
        return cls(cut, fields, lines, mark, name, asked.add is not None)

    def run(
        self,
        texts: "Texts",
        header: "Header | None",
        record: "Record | None",
        write: Callable[[bytes], object],
        invalid: str | None,
    ) -> int:
        """Convert the texts in the lines of standard input; return the exit status."""
        from radcalc.streams.stream import Stream, run

        stream = Stream(texts, self.cut, self.fields, self.lines, header, record, self.adds)
        good = run(stream, stdio.read, write, invalid or ABORT, complain)
        return stdio.ANSWERED if good else stdio.FAILED


def _place(line: int, field: int | None) -> dict[str, object]:
    """Where in standard input a number stands, as JSON has it."""
    return {"line": line, "field": field} if field else {"line": line}


def _given(cases: Sequence[Case], steps: bool) -> Sequence[Given]:
    """The conditions, of which there is one case."""
    if steps:
        raise UsageError("--steps is not for a stream", "one value, for the derivation")
    if len(cases) > 1:
        raise UsageError("a list of conditions is not for a stream", "one value a condition")
    refuse_uncertain(cases[0].given.values(), "a stream")
    return list(cases[0].given.values())


def complain(error: RadcalcError) -> None:
    """Say what is wrong with a line, and nothing more: there may be many."""
    stdio.say([f"radcalc: {spelled(error.message)}"])
