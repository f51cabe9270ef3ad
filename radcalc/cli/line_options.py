"""Options for lines of standard input, shown by convert and hidden in calculators."""

from typing import TYPE_CHECKING, Any

from radcalc.errors import Hint, Try, UsageError, add, command, option
from radcalc.quantities.symbols import SYMBOLS
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
