"""Strict JSON at full precision, with one schema for every command.

Several answers are an array of objects, as always the answers for the days of a log.
"""

import json
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from radcalc.answer import Result, Row, ShownInput, Step
from radcalc.errors import RadcalcError
from radcalc.render.formats import Judgement, Records, Style
from radcalc.render.plain import number, rounded
from radcalc.terminal import can_show

REMARKS_ARE_APART = False


def results(results: Sequence[Result], style: Style) -> str:
    """Return an object, or an array with an object on each line."""
    objects = [_text(_of_result(result, style)) for result in results]
    together = ",\n".join(objects)
    is_list = len(objects) != 1 or any(item.tells for result in results for item in result.inputs)
    return f"[{together}]\n" if is_list else f"{together}\n"


def line(result: Result, style: Style, place: Mapping[str, object]) -> str:
    """Return one object of a stream on a line; it begins with its `place`: line, field, column."""
    return f"{_text({**place, **_of_result(result, style)})}\n"


def records(records: Records, style: Style) -> str:
    """Return an object whose `records` are the rows."""
    answer = _object(style, records.inputs, notes=records.notes)
    return f"{_text({**answer, 'records': list(records.rows)})}\n"


def verdict(judgement: Judgement, style: Style) -> str:
    """Return an object whose `check` is the judgement, and its result the right value."""
    verdict, right = judgement.verdict, judgement.right
    check = {
        "right": verdict.right,
        "name": right.name,
        **_amount(*rounded(verdict.value, verdict.uncertainty, style.precision), verdict.unit),
        "claimed": verdict.claimed,
        **({"claimed_uncertainty": off} if (off := verdict.claimed_uncertainty) else {}),
        "claimed_unit": verdict.claimed_unit,
        "ratio": None if verdict.ratio is None else _rounded(verdict.ratio, style),
        "tolerance": verdict.tolerance,
        "diagnoses": [diagnosis._asdict() for diagnosis in verdict.diagnoses],
    }
    remarks = judgement.assumptions, judgement.notes
    answer = _object(style, judgement.inputs, [right], *remarks, verdict.steps, check)
    return f"{_text(answer)}\n"


def _of_result(result: Result, style: Style) -> dict[str, Any]:
    return _object(
        style, result.inputs, result.rows, result.assumptions, result.notes, result.steps
    )


def _object(
    style: Style,
    inputs: Iterable[ShownInput],
    rows: Iterable[Row] = (),
    assumptions: Iterable[str] = (),
    notes: Iterable[str] = (),
    steps: Iterable[Step] = (),
    check: Mapping[str, Any] | None = None,
) -> dict[str, Any]:
    """Return the object of one call, with the same keys for all calls."""
    return {
        "command": style.command,
        "inputs": {item.name: _input(item) for item in inputs},
        "results": _results(rows, style),
        "assumptions": list(assumptions),
        "notes": list(notes),
        "steps": [step._asdict() for step in steps],
        "check": check,
    }


def _input(item: ShownInput) -> dict[str, Any]:
    """Return a quantity as number and unit, with any text; else a text or true."""
    if item.is_quantity:
        amount = _amount(item.value, item.uncertainty, item.unit)
        return {**amount, "text": item.text} if item.text else amount
    return {"text": item.text} if item.value is None else {"value": item.value}


def _results(rows: Iterable[Row], style: Style) -> dict[str, Any]:
    """Return the results by name; values in further units are in `also`."""
    results: dict[str, Any] = {}
    for row in rows:
        amount = _amount(*rounded(row.value, row.uncertainty, style.precision), row.unit)
        first = results.get(row.name)
        if first is None:
            description = {"quantity": row.quantity, "symbol": row.symbol, "given": row.given}
            results[row.name] = {**amount, **description}
        elif row.unit not in {entry["unit"] for entry in (first, *first.get("also", ()))}:
            first.setdefault("also", []).append(amount)
    return results


def _amount(value: Any, uncertainty: float, unit: str) -> dict[str, Any]:
    off = {"uncertainty": uncertainty} if uncertainty else {}
    return {"value": value, **off, "unit": unit}


def refusal(error: RadcalcError, message: str, hint: str, tries: Sequence[dict[str, Any]]) -> str:
    """Return an error as an object, with the calls that its hint proposes."""
    missing = [{"what": what, "symbols": symbols} for what, symbols in error.missing.items()]
    record = {"code": error.code, "message": message, "hint": hint, "missing": missing}
    record["try"] = tries
    return f"{_text({'error': record})}\n"


def _text(data: Any) -> str:
    text = json.dumps(data, ensure_ascii=False, allow_nan=False)
    if not can_show(text):
        return json.dumps(data, allow_nan=False)
    if text.isprintable():
        return text
    return "".join([c if c.isprintable() else json.dumps(c)[1:-1] for c in text])


def _rounded(value: Any, style: Style) -> Any:
    return float(number(value, style.precision)) if style.precision else value
