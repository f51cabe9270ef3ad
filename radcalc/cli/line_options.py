"""The options for lines of standard input, which convert shows and calculators hide."""

from typing import TYPE_CHECKING, Any

import click

from radcalc.errors import UsageError, command, option
from radcalc.quantities.symbols import SYMBOLS
from radcalc.terminal import INVALID
from radcalc.tuples import NamedTuple

if TYPE_CHECKING:
    from radcalc.cli.cases import Case


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


def refuse(options: LineOptions, hint: str = command("convert", "-", "UNIT", "TARGET")) -> None:
    """Refuse an option for streams where there is none."""
    for name, value in zip(LineOptions._fields, options, strict=True):
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


def refuse_condition(case: "Case") -> None:
    """Refuse lines of standard input for a condition of a conversion."""
    if case.stream:
        stream_option = option(case.stream.name, "-")
        problem = f"{stream_option}: a conversion takes lines of standard input for VALUE alone"
        raise UsageError(problem, command("convert", "-", "UNIT", "TARGET"))
