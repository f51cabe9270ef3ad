"""Plain text: one result per line, fields separated by tabs."""

from radcalc.floats import as_printed, last_place
from radcalc.units import unit_behind

TYPE_CHECKING = False  # typing.TYPE_CHECKING, without the cost of importing typing
if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence
    from typing import Any, NoReturn

    from radcalc.answer import Result, Row, Step
    from radcalc.render.formats import Judgement, Records, Style

DIGITS, TABLE_DIGITS, RATIO_DIGITS = 12, 6, 4
LEAST_FIXED, MOST_FIXED = -4, 6  # powers of ten of an uncertain number without an exponent
MOST_TOGETHER = 15  # most digits of a number with the places of its uncertainty
REMARKS_ARE_APART = True


def number(value: float, precision: int | None = None) -> str:
    """Format a number with 12 significant digits by default."""
    return f"{value:.{precision or DIGITS}g}"


def uncertain(value: float, off: float, precision: int | None = None, digits: int = DIGITS) -> str:
    """Format a number with any standard uncertainty: 9.29 ± 0.28.

    The uncertainty has two significant digits and the number has as many decimal places, with any
    precision.
    """
    if not off:
        return number(value, precision or digits)
    tens = last_place(off)
    first = tens + 1  # of the first digit of both
    if rounded := round(value, -tens):  # 9.9999 ± 0.01 is 10.00
        first = max(first, int(f"{abs(rounded):e}".partition("e")[2]))
    if first - tens >= MOST_TOGETHER:
        return f"{number(value, digits)} ± {off:.2g}"
    if LEAST_FIXED <= first < MOST_FIXED:
        places = max(-tens, 0)
        return f"{rounded + 0.0:.{places}f} ± {round(off, -tens):.{places}f}"
    scale, places = 10.0**first, first - tens
    return (
        f"({round(value / scale, places) + 0.0:.{places}f} ± {off / scale:.{places}f})e{first:+03d}"
    )


def omitted(rows: "Sequence[Row]") -> tuple[str, ...]:
    """Return notes on the uncertainties that bare numbers omit, unless they are among them."""
    names = {row.name for row in rows}
    notes = []
    for row in rows:
        if row.uncertainty and f"{row.name}-uncertainty" not in names:
            size = uncertain(row.value, row.uncertainty)
            text = f"{row.quantity or 'the result'}: {size}{unit_behind(row.unit)}"
            notes.append(f"{text}; only the number is printed")
    return tuple(notes)


def rounded(value: "Any", off: float, precision: int | None) -> "tuple[Any, float]":
    """Return a number and its uncertainty as they are shown, with a precision; else as they are."""
    if not precision:
        return value, off
    if not off:
        return float(number(value, precision)), off
    return as_printed(value, off)


def line(
    value: float,
    unit: str,
    precision: int | None = None,
    bare: bool = False,
    off: float = 0.0,
) -> str:
    """Return VALUE, a tab and UNIT, or the bare number."""
    text = number(value, precision) if bare else uncertain(value, off, precision)
    return f"{text}\n" if bare else f"{text}\t{unit}\n"


def results(results: "Sequence[Result]", style: "Style") -> str:
    """Return all rows of all results, one per line; those of a calculator begin with their names.

    The day of a log precedes its results.
    """
    lines: list[str] = []
    for result in results:
        is_named = result.named and not style.bare
        lines += [
            f"{item.name}\t{item.text}\n" for item in result.inputs if item.tells and is_named
        ]
        lines += [
            (f"{row.name}\t" if is_named else "")
            + line(row.value, row.unit, style.precision, style.bare, row.uncertainty)
            for row in result.rows
        ]
    return "".join(lines)


def records(records: "Records", style: "Style") -> str:
    """Return a line for each row, without a header."""
    return "".join("\t".join(texts) + "\n" for texts in fields(records))


def fields(records: "Records") -> list[list[str]]:
    """Return the fields of rows as texts, with lists joined by commas."""
    return [
        [", ".join(field) if isinstance(field, list) else str(field) for field in row.values()]
        for row in records.rows
    ]


def verdict(judgement: "Judgement", style: "Style", digits: int = DIGITS) -> str:
    """Return whether an answer is right, and the most likely mistakes."""
    from radcalc.homework.wording import Translatable, in_language
    from radcalc.quantities.language import ENGLISH

    if style.bare:
        refuse_verdict()
    verdict = judgement.verdict
    digits = style.precision or digits
    name = verdict.name if style.language == ENGLISH else verdict.label
    size = uncertain(verdict.value, verdict.uncertainty, style.precision, digits)
    right = f"{size}{unit_behind(verdict.unit)}"
    if verdict.right:
        word = Translatable("right, as {0}", name) if verdict.is_chosen else "right"
        sentence = Translatable("{0} ({1}): {2} is {3}", word, verdict.tolerance, name, right)
        for diagnosis in verdict.diagnoses:
            sentence = Translatable("{0}; {1}", sentence, diagnosis.right)
        return in_language(sentence, style.language) + "\n"
    times = "1" if verdict.ratio is None else number(verdict.ratio + 0.0, RATIO_DIGITS)
    claimed = number(verdict.claimed, digits)  # as typed
    if verdict.claimed_uncertainty:
        claimed += f" ± {number(verdict.claimed_uncertainty, digits)}"
    claimed += unit_behind(verdict.claimed_unit)
    parts = "wrong", verdict.tolerance, name, right, claimed
    sentence = Translatable("{0} ({1}): {2} is {3}, not {4}", *parts)
    if times != "1":
        sentence = Translatable("{0} ({1} times the right value)", sentence, times)
    lines = [in_language(sentence, style.language)]
    lines += _mistakes(verdict.diagnoses, style.language)
    return "\n".join(lines) + "\n"


def _mistakes(diagnoses: "Sequence[Any]", language: str) -> "Iterator[str]":
    """Yield the lines of the likely mistakes: what was done, the wrong step, and the rule."""
    from radcalc.homework.wording import Translatable, in_language

    word = "likely: {0}"
    for diagnosis in diagnoses:
        if diagnosis.mistake == "rounded":
            sentence = Translatable("rounded {0}: {1}", diagnosis.done, diagnosis.right)
            yield in_language(sentence, language)
            continue
        yield in_language(Translatable(word, diagnosis.done), language)
        if diagnosis.yours:
            yield f"    {in_language('yours', language)}: {diagnosis.yours}"
        yield "    " + in_language(diagnosis.right, language)
        word = "or: {0}"
    if not diagnoses:
        yield in_language("no usual mistake gives this number", language)


def refuse_verdict() -> "NoReturn":
    """Raise an error for a verdict in a format of values only."""
    from radcalc.errors import Try, UsageError, option

    raise UsageError(
        f"the result of {option('check')} is a verdict, in words or as JSON",
        Try((("json", ""),), ("format",)),
    )


def derivation(steps: "Sequence[Step]") -> list[str]:
    """Return the steps in lines: the law, its formula, the numbers, the reference."""
    lines = []
    for step in steps:
        lines.append(f"{step.law}: {step.formula}".rstrip(": "))
        lines.append(f"    {step.numbers}")
        if step.reference:
            lines.append(f"    [{step.reference}]")
    return lines
