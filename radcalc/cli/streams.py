"""Standard input, line by line: `radcalc convert -`, and calculators with - for an input."""

import os
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, NamedTuple

from radcalc import errors, terminal
from radcalc.answer import Answer, Result, ShownInput, Value
from radcalc.calculators.solved import Task
from radcalc.cli.output import Output
from radcalc.cli.request import Case, LineOptions, first_of
from radcalc.cli.spelling import spelled
from radcalc.conversion import Plan
from radcalc.conversion.operands import read_stream_operands
from radcalc.conversion.plan import note_on_negative, plan, result_of_plan, source_of, target_of
from radcalc.errors import option, quote
from radcalc.inputs import Input, refuse_uncertain, shown_inputs
from radcalc.quantities.symbols import SYMBOLS
from radcalc.streams import Source
from radcalc.terminal import ABORT, CSV, JSON, TABLE
from radcalc.units import Unit, own_since
from radcalc.units.table import resolve
from radcalc.units.values import resolve_any, resolve_given

BLOCK = 1 << 16  # bytes that show the head of a table

if TYPE_CHECKING:
    from radcalc.streams.calculated import Calculated, LineAnswer
    from radcalc.streams.fields import Cut, Fields
    from radcalc.streams.header import Header
    from radcalc.streams.readers import Texts
    from radcalc.streams.stream import Record


def convert(
    words: list[str], options: LineOptions, cases: Sequence[Case], steps: bool, output: Output
) -> int:
    """Convert standard input; return the exit status."""
    from radcalc.streams.readers import Numbers, Quantities, Texts

    output.refuse_auto("a stream has one unit for all lines", errors.leave_out("auto"))
    source_text, target_text = read_stream_operands(words)
    if "," in target_text:
        problem = f"'{quote(target_text)}' is a list, but a stream has one target"
        raise errors.UsageError(problem, errors.corrections(target_text, *target_text.split(",")))
    given = _given(cases, steps)
    _refuse_format(output)
    layout = Layout.of(options, bool(source_text))
    source = resolve_any(source_text) if source_text else None
    target = target_of(target_text, source)
    conversion = _Conversion(layout, source, target, given, output)
    header = conversion.header(options.column or "") if layout.has_titles else None
    texts: Texts
    if source:
        if target.text != " ".join(target_text.split()):  # the name of a quantity
            target.notes += (f"the numbers are in {target.text}",)
        texts = Numbers(conversion.plan(source), output.style.precision, layout.mark)
    else:
        blank = " " if layout.cut else "\t"
        is_bare = output.style.bare or (layout.lines and layout.adds)
        unit = "" if is_bare else blank + target.text
        texts = Quantities(
            conversion.plan,
            lambda amount: source_of(amount, target, given),
            unit.encode(),
            output.style.precision,
            layout.mark,
            target.text,
        )
    record = conversion.record if conversion.as_json else None
    status = layout.run(texts, header, record, terminal.pour, options.invalid)
    conversion.note_negative()
    return status


class _Work:
    """Base of conversions and calculators on streams: the layout of lines, and the output."""

    def __init__(self, layout: "Layout", output: Output) -> None:
        self.layout = layout
        self.style = output.style
        self.as_json = output.format == JSON
        self.since = output.since
        self.already_said: set[str] = set()

    def say(self, texts: Sequence[str]) -> None:
        """Write remarks and the user's definitions that are used, each once."""
        if self.style.remarks and not self.as_json:
            said = dict.fromkeys([*texts, *terminal.remarks((), own_since(self.since))])
            terminal.say([spelled(text) for text in said if text not in self.already_said])
            self.already_said.update(said)

    def note(self, text: str) -> None:
        self.say(terminal.remarks((), (text,)))

    def line_of(self, result: Result, line: int, field: int | None, column: str = "") -> str:
        from radcalc.render import json

        place = {"line": line, "field": field, "column": column}
        known = {name: value for name, value in place.items() if value}
        result = result._replace(notes=(*result.notes, *own_since(self.since)))
        return json.line(result.spelled(spelled), self.style, known)


class _Conversion(_Work):
    """The plans of a stream, one for each unit of its lines, and their remarks."""

    def __init__(
        self,
        layout: "Layout",
        source: Unit | None,
        target: Unit,
        given: Sequence[Input],
        output: Output,
    ) -> None:
        super().__init__(layout, output)
        self.source, self.target, self.given = source, target, given
        self.titles: Header | None = None
        self.planned: list[Plan] = []

    def note_negative(self) -> None:
        """Say what negative amounts of light are, as for a single one."""
        for planned in self.planned:
            if planned.has_negative:
                self._remark((), note_on_negative(planned))

    def plan(self, unit: Unit, *assumptions: str) -> Plan:
        """Return the plan for a unit of the lines, and say what it assumes."""
        try:
            planned = plan(unit, self.target, self.given)
        except errors.Unused as error:
            if self.source or assumptions:
                raise
            hint = f"{error.hint}, or a call for each kind of line"  # later units may use it
            raise error.reworded(hint=hint) from None
        if self.layout.lines and self.layout.name is None:
            from radcalc.streams.header import refuse_change

            refuse_change(planned.source, planned.target)
        planned.assumptions = (*assumptions, *planned.assumptions)
        self._remark(planned.assumptions, planned.notes)
        self.planned.append(planned)
        return planned

    def header(self, column: str) -> "Header":
        """Return the titles of the header, and keep them for the records."""
        from radcalc.streams.header import Header

        layout = self.layout
        self.titles = Header(
            layout.cut,
            self.source,
            self.target,
            self._titled,
            self.note,
            column,
            layout.name,
            layout.adds,
            given=[item.name for item in self.given],
        )
        return self.titles

    def record(self, line: int, field: int | None, planned: Plan, value: float) -> str:
        conditions = shown_inputs({given.name: given for given in self.given})
        inputs = (ShownInput("value", value, planned.source.text), *conditions)
        titles = self.titles
        title = (titles.new_titles.get(field) or titles.title_of()) if titles else ""
        return self.line_of(result_of_plan(planned, value, inputs=inputs), line, field, title)

    def _titled(self, unit: Unit) -> "tuple[Texts, Unit]":
        from radcalc.streams.readers import Numbers

        assumption = f"the numbers are in {quote(unit.text)}, as their title says"
        plan = self.plan(unit, assumption)
        texts = Numbers(plan, self.style.precision, self.layout.mark)
        texts.example = "a number alone: the title has its unit"
        return texts, self.target

    def _remark(self, assumptions: Sequence[str], notes: Sequence[str]) -> None:
        self.say(terminal.remarks(assumptions, notes))


def calculate(
    case: Case, task: Task, wanted: Sequence[str], options: LineOptions, output: Output
) -> int:
    """Answer every line of standard input; return the exit status.

    `wanted` are the results that replace the numbers that are read.
    """
    source = case.stream
    assert source is not None
    output.refuse_auto("a stream has one unit for all lines", errors.leave_out("auto"))
    _refuse_format(output)
    refuse_uncertain(case.given.values(), "a stream")
    layout = Layout.of(options, source.is_bare)
    calculation = _Calculation(case, source, task, wanted, layout, output)
    if len(wanted) > 1 and not calculation.as_json and (layout.cut or layout.lines or layout.adds):
        raise errors.UsageError(f"{len(wanted)} results cannot replace one field", "-g once")
    names_in_units = calculation.in_units(source)
    header = None
    if layout.lines or layout.adds:
        header = calculation.header(options.column or "", _unit_of(names_in_units))
        wanted = names_in_units if calculation.has_titles else wanted
    texts = calculation.texts(source, wanted)
    record = calculation.record if calculation.as_json else None
    status = layout.run(texts, header, record, calculation.write, options.invalid)
    calculation.say(calculation.remarks.changed())
    return status


class _Calculation(_Work):
    """The answers of a calculator to lines, and their remarks."""

    def __init__(
        self,
        case: Case,
        source: Source,
        task: Task,
        wanted: Sequence[str],
        layout: "Layout",
        output: Output,
    ) -> None:
        from radcalc.streams.calculated import Remarks

        super().__init__(layout, output)
        self.case, self.source, self.task, self.wanted = case, source, task, wanted
        self.has_titles = bool(layout.lines) and not self.as_json
        self.target: Unit | None = None  # unit of the results, for their title
        self.remarks = Remarks()

    def write(self, data: bytes) -> None:
        """Write answers after the remarks on them."""
        self.say(self.remarks.not_yet_said())
        terminal.pour(data)

    def texts(self, source: Source, wanted: Sequence[str]) -> "Calculated":
        from radcalc.streams.calculated import Calculated

        heard, precision = self.remarks.hear, self.style.precision
        return Calculated(source, self._of_line, wanted, heard, precision, self.layout.mark)

    def in_units(self, source: Source) -> Sequence[str]:
        """Return the results as NAME:UNIT in the units of the lines; NAME if each line has a unit.

        Refuse unknown results, which the answer for a value of the same kind and unit lacks.
        """
        from radcalc.calculators.results import name_of, names_of, pick

        values = _likely(source, self._of_value)
        if not self.wanted and not self.as_json:
            names = names_of([value for value in values if value.given is None]) or ["NAME:UNIT"]
            *others, last = names
            listing = f"{', '.join(others)} or {last}" if others else last
            problem = f"a stream ({option(source.name, '-')}) needs -g NAME"
            raise errors.UsageError(problem, f"-g with {listing}")
        names_in_units = list(self.wanted)
        for k, name in enumerate(self.wanted if values else ()):
            try:
                row = pick(values, name)
            except errors.NumberError:  # an error of that value only
                continue
            except errors.UsageError:
                if name_of(name) not in {v.name for v in values if v.is_absent}:
                    raise
                continue
            if source.unit or not row.given:  # it has the unit of its line
                names_in_units[k] = f"{row.name}:{row.unit}"
        return names_in_units

    def header(self, column: str, target: Unit | None) -> "Header":
        """Return the titles of the header, and keep the unit of the results."""
        from radcalc.streams.header import Header, refuse_change

        self.target = target
        source, layout = self.source, self.layout
        unit = resolve_given(source.unit) if source.unit else None
        if layout.name is None and unit and target and not self.as_json:
            refuse_change(unit, target)
        return Header(
            layout.cut,
            unit,
            resolve("1") if self.as_json else target,
            self._titled,
            self.note,
            column,
            "result" if self.as_json else layout.name,  # JSON has no titles
            layout.adds and not self.as_json,
            lambda unit: option(source.name, f"- {unit}"),
            source.is_bare,
        )

    def record(self, line: int, field: int | None, given: Input, line_answer: "LineAnswer") -> str:
        from radcalc.calculators.results import rows, said_of

        inputs = (*self.task.operands, *shown_inputs(self.case.of_line(given)))
        result_of_plan = line_answer.answer
        chosen = line_answer.rows if self.wanted else rows(result_of_plan.values)
        said = said_of(result_of_plan, chosen) if self.wanted else result_of_plan.said()
        result = Result(tuple(chosen), *said, inputs=inputs)
        return self.line_of(result, line, field)

    def _of_value(self, given: Input) -> Answer:
        return self.task.nominal(self.case.of_line(given))

    def _of_line(self, given: Input) -> Answer:
        self._refuse_change(given.unit or resolve("1"))
        return self._of_value(given)

    def _refuse_change(self, unit: Unit) -> None:
        """Refuse results of another quantity under the title of the input."""
        if self.has_titles and self.layout.name is None and self.target:
            from radcalc.streams.header import refuse_change

            refuse_change(unit, self.target)

    def _titled(self, unit: Unit) -> "tuple[Calculated, Unit]":
        self.say([f"assumed: the numbers are in {quote(unit.text)}, as their title says"])
        self.source.check(unit)
        of_unit = self.source._replace(unit=unit.text)
        names = self.in_units(of_unit)
        self.target = _unit_of(names)
        if self.target is None and not self.as_json:
            raise errors.UsageError("the title needs a unit", option("get", "NAME:UNIT"))
        self._refuse_change(unit)
        return self.texts(of_unit, names), self.target or resolve("1")


def _unit_of(wanted: Sequence[str]) -> Unit | None:
    text = wanted[0].partition(":")[2].strip() if wanted else ""
    return resolve_any(text) if text else None


def _likely(source: Source, of_line: Callable[[Input], Answer]) -> Sequence[Value]:
    """Return the results for a likely line, or none if the lines may be of other kinds."""
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
        except errors.RadcalcError:  # an error of that value, or one that the first line reports
            continue
    return ()


def _refuse_format(output: Output) -> None:
    if output.is_chosen and output.format in (TABLE, CSV):
        problem = f"--format {output.format} cannot be used with a stream"
        raise errors.UsageError(problem, [errors.add("format", "json"), errors.leave_out("format")])


class Layout(NamedTuple):
    """The division of lines into fields, from the options.

    `lines` is the number of header lines; `name` is the title of the results.
    """

    cut: "Cut | None"
    fields: "Fields"
    lines: int
    mark: bytes
    name: str | None
    adds: bool
    begin: list[bytes]  # what is read of the input already

    @classmethod
    def of(cls, options: LineOptions, has_unit: bool) -> "Layout":
        """Read the options; lines of bare numbers may be separated at blanks.

        The head of a table with a named column shows the rest.
        """
        from radcalc.streams.fields import Cut, Fields, read_delimiter

        lines = options.header or (1 if options.column is not None else 0)
        _refuse_contradictions(options, lines, has_unit)
        cut, begin = None, []
        delimiter = read_delimiter(options.delimiter) if options.delimiter is not None else ""
        if options.column is not None and not (options.header and delimiter):
            from radcalc.streams.header import head_of

            begin = [terminal.read(BLOCK)]
            delimiter, lines = head_of(begin[0], options.column, delimiter)
            lines = options.header or lines
        if (options.field, options.column, options.delimiter) != (None, None, None):
            cut = Cut(os.fsencode(delimiter))
        mark = (options.decimal or ".").encode()
        if cut and cut.delimiter == mark != b".":
            problem = "--decimal , cannot be used with --delimiter ,"
            raise errors.UsageError(problem, option("delimiter", "tab"))
        column = None if lines else options.column  # the number of one without a title
        fields = Fields(next((one for one in (options.field, column) if one is not None), "1"))
        name = options.rename if options.add is None else options.add
        name = None if name is None else name.strip()
        if name is not None and not fields.is_one:
            each = [
                errors.add("field", str(first)) for first, last in fields.ranges if first == last
            ]
            hint: errors.Hint = each[:3] or "a call for each field"
            raise errors.UsageError("--add and --rename take one field", hint)
        return cls(cut, fields, lines, mark, name, options.add is not None, begin)

    @property
    def has_titles(self) -> bool:
        return bool(self.lines) or self.name is not None

    def run(
        self,
        texts: "Texts",
        header: "Header | None",
        record: "Record | None",
        write: Callable[[bytes], object],
        invalid: str | None,
    ) -> int:
        from radcalc.streams.stream import Stream, run

        stream = Stream(texts, self.cut, self.fields, self.lines, header, record, self.adds)
        good = run(stream, self.read, write, invalid or ABORT, complain)
        return terminal.ANSWERED if good else terminal.FAILED

    def read(self, size: int) -> bytes:
        return self.begin.pop() if self.begin else terminal.read(size)


def _refuse_contradictions(options: LineOptions, lines: int, has_unit: bool) -> None:
    """Refuse options for lines that contradict each other or lack one that they need."""
    if options.field is not None and options.column is not None:
        problem = "--field cannot be used with --column"
        raise errors.UsageError(problem, errors.one_of("field", "column"))
    if options.add is not None and options.rename is not None:
        problem = "--add cannot be used with --rename"
        raise errors.UsageError(problem, errors.one_of("add", "rename"))
    if options.rename is not None and not lines:
        raise errors.UsageError("--rename needs a header", errors.add("header"))
    if not has_unit and options.delimiter is None and options.field is not None and not lines:
        raise errors.UsageError(
            "--field needs --delimiter if the lines have their own units",
            [
                errors.add("delimiter", "tab"),
                errors.add("delimiter", ","),
                errors.leave_out("field"),
            ],
        )


def _given(cases: Sequence[Case], steps: bool) -> Sequence[Input]:
    if steps:
        raise errors.UsageError("--steps cannot be used with a stream", errors.leave_out("steps"))
    if len(cases) > 1:
        each = [first_of(case.varied) for case in cases[:3]]
        raise errors.UsageError("a list of conditions cannot be used with a stream", each)
    refuse_uncertain(cases[0].given.values(), "a stream")
    return list(cases[0].given.values())


def complain(error: errors.RadcalcError) -> None:
    """Write the error of a line, without a hint: there may be many."""
    terminal.say([f"radcalc: {spelled(error.message)}"])
