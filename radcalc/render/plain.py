"""Plain text: one result a line, fields separated by tabs."""

TYPE_CHECKING = False  # typing.TYPE_CHECKING, without the cost of importing typing
if TYPE_CHECKING:
    from radcalc.answer import Result, Step

DIGITS = 12


def number(value: float, precision: int | None = None) -> str:
    """A number with 12 significant digits, or as many as asked for."""
    return f"{value:.{precision or DIGITS}g}"


def line(value: float, unit: str, precision: int | None = None, bare: bool = False) -> str:
    """One converted value: VALUE, a tab and UNIT, or the bare number."""
    text = number(value, precision)
    return f"{text}\n" if bare else f"{text}\t{unit}\n"


def render(result: "Result", precision: int | None = None, bare: bool = False) -> str:
    """All rows of a result, a line each; a calculator's begin with their names."""
    return "".join(
        [
            (f"{row.name}\t" if row.name and not bare else "")
            + line(row.value, row.unit, precision, bare)
            for row in result.rows
        ]
    )


def derivation(steps: "tuple[Step, ...]") -> list[str]:
    """The steps, in lines: the law, its formula, the numbers, the reference."""
    lines = []
    for step in steps:
        lines.append(f"{step.law}: {step.formula}".rstrip(": "))
        lines.append(f"    {step.numbers}")
        if step.reference:
            lines.append(f"    [{step.reference}]")
    return lines
