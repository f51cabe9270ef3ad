"""Options for lines of standard input, shown by convert and hidden in calculators."""

from typing import TYPE_CHECKING, Any

import click

from radcalc.cli.options import Whole
from radcalc.errors import Hint, Try, UsageError, add, command, option
from radcalc.quantities.symbols import SYMBOLS
from radcalc.terminal import INVALID
from radcalc.tuples import NamedTuple

if TYPE_CHECKING:
    from radcalc.cli.cases import Case


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


OPTIONS = (
    click.Option(
        ["--field"],
        metavar="LIST",
        help="Fields to convert, by number: 3, 1,3, 2-4, 3- (from 3 on), or - (all).",
    ),
    click.Option(
        ["--column"],
        metavar="NAME",
        help="Field to convert: its title, with or without its unit (E for E [lx]), or its number.",
    ),
    click.Option(
        ["-d", "--delimiter"],
        metavar="X",
        help="Field separator: one character, or tab (default: runs of blanks).",
    ),
    Whole(
        ["--header"],
        type=click.IntRange(1),
        metavar="[=N]",
        help="Number of header lines (1 without N; --column implies 1).  Every line must have as "
        "many fields as the header.  If a title has a unit, it must be the input unit; the unit of "
        "the result replaces it.",
    ),
    click.Option(
        ["--add"],
        metavar="NAME",
        help="Keep the field, and append a field with this title for the result.",
    ),
    click.Option(
        ["--rename"],
        metavar="NAME",
        help="New title of the field; required if the result is another quantity.",
    ),
    click.Option(
        ["--decimal"],
        type=click.Choice([".", ","]),
        help="Decimal mark of input and output: a comma, or a point (the default).",
    ),
    click.Option(
        ["--invalid"],
        type=click.Choice(INVALID),
        help="Treatment of unreadable lines.  abort (default): stop at the first.  fail, warn, "
        "ignore: copy them unchanged, and fail at the end (status 2), warn (status 0) or say "
        "nothing (status 0).",
    ),
)


def refuse(options: LineOptions, hint: Hint) -> None:
    """Refuse an option for streams if there is no stream."""
    for name, value in zip(LineOptions._fields, options, strict=True):
        if value is not None and value in SYMBOLS["electric-field"].choices:
            raise UsageError(
                f"--{name} {value} applies to the fields of lines, not to a wave",
                Try((("electric-field", value),), (name,), remark="for a wave"),
            )
        if value is not None:
            raise UsageError(f"--{name} applies to lines of standard input only", hint)


def refuse_second_reader(typed: dict[str, Any]) -> None:
    """Refuse a spectrum from standard input, which has the numbers."""
    if str(typed.get("spectrum", "")).partition(":")[0].strip() == "-":
        raise UsageError("- cannot be used twice: there is one standard input", add("spectrum"))


def refuse_condition(case: "Case") -> None:
    """Refuse lines of standard input for a condition of a conversion."""
    if case.stream:
        stream_option = option(case.stream.name, "-")
        problem = f"{stream_option}: a conversion reads lines of standard input only for VALUE"
        raise UsageError(problem, command("convert", "-", "UNIT", "TARGET"))
