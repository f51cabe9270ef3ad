"""Plain text: one result a line, fields separated by tabs."""

TYPE_CHECKING = False  # typing.TYPE_CHECKING, without the cost of importing typing
if TYPE_CHECKING:
    from collections.abc import Sequence

    from radcalc.answer import Result, Step
    from radcalc.render.formats import Judgement, Records, Style

DIGITS, RATIO_DIGITS = 12, 4
REMARKS_ARE_APART = True


def number(value: float, precision: int | None = None) -> str:
    """A number with 12 significant digits, or as many as asked for."""
    return f"{value:.{precision or DIGITS}g}"


def line(value: float, unit: str, precision: int | None = None, bare: bool = False) -> str:
    """One converted value: VALUE, a tab and UNIT, or the bare number."""
    text = number(value, precision)
    return f"{text}\n" if bare else f"{text}\t{unit}\n"


def results(results: "Sequence[Result]", style: "Style") -> str:
    """All rows of all results, a line each; a calculator's begin with their names."""
    return "".join(
        [
            (f"{row.name}\t" if result.named and not style.bare else "")
            + line(row.value, row.unit, style.precision, style.bare)
            for result in results
            for row in result.rows
        ]
    )


def records(records: "Records", style: "Style") -> str:
    """A line for each row, without a header."""
    return "".join("\t".join(texts) + "\n" for texts in fields(records))


def fields(records: "Records") -> list[list[str]]:
    """The fields of rows as texts, lists parted by commas."""
    return [
        [", ".join(field) if isinstance(field, list) else str(field) for field in row.values()]
        for row in records.rows
    ]


def verdict(judgement: "Judgement", style: "Style", digits: int = DIGITS) -> str:
    """Whether an answer is right, and what most likely went wrong."""
    if style.bare:
        refuse_verdict()
    said = judgement.verdict
    digits = style.precision or digits
    unit = "" if said.unit == "1" else f" {said.unit}"
    other = "" if said.claimed_unit == "1" else f" {said.claimed_unit}"
    right = f"{said.name} is {number(said.right, digits)}{unit}"
    if said.is_right:
        nearer = "".join(f"; {diagnosis.right}" for diagnosis in said.diagnoses)
        return f"right ({said.tolerance}): {right}{nearer}\n"
    times = "1" if said.ratio is None else number(said.ratio + 0.0, RATIO_DIGITS)
    ratio = f" ({times} times that)" if times != "1" else ""
    claimed = f"{number(said.claimed, digits)}{other}"
    lines = [f"wrong ({said.tolerance}): {right}, not {claimed}{ratio}"]
    word = "likely"
    for diagnosis in said.diagnoses:
        if diagnosis.mistake == "rounded":
            lines.append(f"right {diagnosis.done}; {diagnosis.right}")
            continue
        lines += [f"{word}: {diagnosis.done}", f"    {diagnosis.right}"]
        word = "or"
    if not said.diagnoses:
        lines.append("no usual mistake gives that number")
    return "\n".join(lines) + "\n"


def refuse_verdict() -> None:
    """Refuse to say right or wrong where only values can be said."""
    from radcalc.errors import UsageError, option

    raise UsageError(
        f"{option('check')} says right or wrong, in words or as JSON",
        f"{option('json')}, or neither",
    )


def derivation(steps: "Sequence[Step]") -> list[str]:
    """The steps, in lines: the law, its formula, the numbers, the reference."""
    lines = []
    for step in steps:
        lines.append(f"{step.law}: {step.formula}".rstrip(": "))
        lines.append(f"    {step.numbers}")
        if step.reference:
            lines.append(f"    [{step.reference}]")
    return lines
