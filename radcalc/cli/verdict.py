"""How a judgement is shown, in every format."""

from collections.abc import Sequence
from typing import Any

from radcalc import stdio
from radcalc.cli.output import CSV, JSON, TABLE, Output
from radcalc.errors import UsageError
from radcalc.homework import Verdict
from radcalc.render.plain import DIGITS, derivation, number

IN_TABLES = 6  # digits


def show(verdict: Verdict, assumptions: Sequence[str], notes: Sequence[str], output: Output) -> int:
    """Write what is said of an answer; return 0 where it is right and 1 where it is wrong."""
    status = stdio.ANSWERED if verdict.is_right else stdio.WRONG
    if output.format == JSON:
        import json  # costs as much as the judgement

        if output.precision:
            verdict = _rounded(verdict, output.precision)
        stdio.write(json.dumps(_object(verdict, assumptions, notes), ensure_ascii=False) + "\n")
        return status
    if output.format == CSV or output.number:
        raise UsageError("--check says right or wrong, in words or as JSON", "--json, or neither")
    stdio.write("\n".join(_lines(verdict, output)) + "\n")
    said = [] if output.quiet else stdio.remarks(assumptions, notes)
    stdio.say(said + derivation(verdict.steps))
    return status


def _rounded(verdict: Verdict, precision: int) -> Verdict:
    """The right value and the ratio with so many digits."""
    ratio = None if verdict.ratio is None else float(number(verdict.ratio, precision))
    return verdict._replace(right=float(number(verdict.right, precision)), ratio=ratio)


def _lines(verdict: Verdict, output: Output) -> list[str]:
    digits = output.precision or (IN_TABLES if output.format == TABLE else DIGITS)
    unit = "" if verdict.unit == "1" else f" {verdict.unit}"
    other = "" if verdict.claimed_unit == "1" else f" {verdict.claimed_unit}"
    claimed = f"{number(verdict.claimed, digits)}{other}"
    right = f"{verdict.name} is {number(verdict.right, digits)}{unit}"
    if verdict.is_right:
        return [f"right ({verdict.tolerance}): {right}"]
    ratio = f" ({number(verdict.ratio, 4)} times that)" if verdict.ratio is not None else ""
    lines = [f"wrong ({verdict.tolerance}): {right}, not {claimed}{ratio}"]
    word = "likely"
    for one in verdict.diagnoses:
        lines += [f"{word}: {one.done}", f"    {one.right}"]
        word = "or"
    if not verdict.diagnoses:
        lines.append("no usual mistake gives that number")
    return lines


def _object(verdict: Verdict, assumptions: Sequence[str], notes: Sequence[str]) -> dict[str, Any]:
    """The verdict for programs."""
    from radcalc.render.json import steps

    return {
        "right": verdict.is_right,
        "name": verdict.name,
        "unit": verdict.unit,
        "value": verdict.right,
        "claimed": verdict.claimed,
        "claimed-unit": verdict.claimed_unit,
        "ratio": verdict.ratio,
        "tolerance": verdict.tolerance,
        "diagnoses": [one._asdict() for one in verdict.diagnoses],
        "assumptions": list(assumptions),
        "notes": list(notes),
        "steps": steps(verdict.steps),
    }
