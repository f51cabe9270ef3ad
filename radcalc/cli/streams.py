"""`radcalc convert -`: standard input, line by line."""

from collections.abc import Sequence
from typing import Any, NamedTuple

import click

from radcalc import stdio
from radcalc.answer import Input
from radcalc.cli.cases import Case
from radcalc.cli.options import Output
from radcalc.cli.spelling import spelled
from radcalc.conversion.plan import Plan, answer, plan, target_of
from radcalc.errors import RadcalcError, UsageError, command, option, quote
from radcalc.given import Given, inputs_of, refuse_uncertain
from radcalc.quantities.symbols import SYMBOLS
from radcalc.render.formats import CSV, JSON, TABLE
from radcalc.streams import ABORT, INVALID
from radcalc.units.amounts import read_stream_operands
from radcalc.units.scales import resolve_any
from radcalc.units.table import Unit


class Asked(NamedTuple):
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
        help="The field under that title, which may be without its unit: E for E [lx].",
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


def refuse(asked: Asked) -> None:
    """Refuse an option for streams where there is none."""
    for name, value in zip(Asked._fields, asked, strict=True):
        if value is not None and value in SYMBOLS["electric-field"].choices:
            raise UsageError(
                f"--{name} {value} is for the fields of lines", option("electric-field", value)
            )
        if value is not None:
            raise UsageError(
                f"--{name} is for lines of standard input",
                command("convert", "-", "UNIT", "TARGET"),
            )


def refuse_second_reader(typed: dict[str, Any]) -> None:
    """Refuse a spectrum from standard input, which has the numbers."""
    if str(typed.get("spectrum", "")).partition(":")[0].strip() == "-":
        raise UsageError("there is more than one -, and one standard input", "--spectrum FILE")


def convert(
    words: list[str],
    asked: Asked,
    cases: Sequence[Case],
    steps: bool,
    shown: Output,
) -> int:
    """Convert standard input; return the exit status."""
    shown.refuse_auto(
        "a stream has one for all its lines", "a TARGET that fits, such as mlx or klx"
    )
    from radcalc.streams.fields import Cut, Fields, read_delimiter
    from radcalc.streams.readers import Numbers, Quantities, Texts
    from radcalc.streams.stream import Stream, run

    source_text, target_text = read_stream_operands(words)
    if "," in target_text:
        problem = f"'{quote(target_text)}' is a list, and a stream has one target"
        raise UsageError(problem, "one unit a call")
    given = _given(cases, steps)
    if asked.field is not None and asked.column is not None:
        raise UsageError("--field and --column contradict each other", "one of them")
    if asked.add is not None and asked.rename is not None:
        raise UsageError("--add and --rename contradict each other", "one of them")
    lines = asked.header or (1 if asked.column is not None else 0)
    if asked.rename is not None and not lines:
        raise UsageError("--rename needs a header", "--header, or --column NAME")
    format_ = click.get_current_context().params.get("format_")
    if format_ in (TABLE, CSV):
        raise UsageError(f"--format {format_} is not for a stream", "--format plain or json")
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
        made = plan(unit, target, given)
        if lines and name is None:
            refuse_change(made.source, made.target)
        made.assumptions = (*assumptions, *made.assumptions)
        remark(made.assumptions, made.notes)
        return made

    if not source_text and asked.delimiter is None and asked.field is not None and not lines:
        raise UsageError(
            "--field needs --delimiter where the lines carry their own units",
            "--delimiter X, which says what cuts the fields",
        )
    cut = None
    if (asked.field, asked.column, asked.delimiter) != (None, None, None):
        cut = Cut(read_delimiter(asked.delimiter) if asked.delimiter is not None else b"")
    mark = (asked.decimal or ".").encode()
    if cut and cut.delimiter == mark != b".":
        raise UsageError(
            "--decimal , and --delimiter , contradict each other", "--delimiter ';' or tab"
        )
    fields = Fields("1" if asked.field is None else asked.field)
    precision = shown.style.precision

    def titled(unit: Unit) -> Texts:
        told = f"the numbers are in {quote(unit.text)}, as their title says"
        return Numbers(planned(unit, told), precision, mark)

    name = asked.rename if asked.add is None else asked.add
    adds = asked.add is not None
    if name is not None and not fields.is_one:
        raise UsageError("--add and --rename are for one field", "a call for each field")
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
        is_bare = shown.style.bare or (lines and asked.add is not None)
        unit = "" if is_bare else blank + target.text
        texts = Quantities(planned, unit.encode(), precision, mark)

    conditions = inputs_of({one.name: one for one in given})

    def record(line: int, field: int | None, made: Plan, value: float) -> str:
        from radcalc.render import json

        place: dict[str, object] = {"line": line, "field": field} if field else {"line": line}
        if header and (title := header.shown.get(field) or header.title_of()):
            place["column"] = title
        inputs = (Input("value", value, made.source.text), *conditions)
        return json.line(answer(made, value, inputs=inputs).spelled(spelled), shown.style, place)

    stream = Stream(texts, cut, fields, lines, header, record if as_json else None, adds)
    good = run(stream, stdio.read, stdio.pour, asked.invalid or ABORT, _complain)
    return stdio.ANSWERED if good else stdio.FAILED


def _given(cases: Sequence[Case], steps: bool) -> Sequence[Given]:
    """The conditions, of which there is one case."""
    if steps:
        raise UsageError("--steps is not for a stream", "one value, for the derivation")
    if len(cases) > 1:
        raise UsageError("a list of conditions is not for a stream", "one value a condition")
    refuse_uncertain(cases[0].given.values(), "a stream")
    return list(cases[0].given.values())


def _complain(error: RadcalcError) -> None:
    """Say what is wrong with a line, and nothing more: there may be many."""
    stdio.say([f"radcalc: {spelled(error.message)}"])
