"""Strict JSON at full precision: a conversion is one flat object, a calculator has results."""

import json
from collections.abc import Sequence
from typing import Any

from radcalc.answer import Result, Row, Step
from radcalc.render.formats import Judgement, Records, Style
from radcalc.render.plain import number

REMARKS_ARE_APART = False


def results(results: Sequence[Result], style: Style) -> str:
    """One object for each answer, on a line of its own."""
    return "".join(one(result, style) for result in results)


def one(result: Result, style: Style, place: dict[str, int] | None = None) -> str:
    """One object, on one line; several values of one answer are its `results`.

    In a stream it begins with its `place`: the line, and the field.
    """
    rows = [_row(row, style) for row in result.rows]
    flat = len(rows) == 1 and not result.rows[0].name
    answer: dict[str, Any] = rows[0] if flat else {"results": rows}
    answer["assumptions"] = list(result.assumptions)
    answer["notes"] = list(result.notes)
    answer["steps"] = _steps(result.steps)
    return _line({**(place or {}), **answer})


def records(records: Records, style: Style) -> str:
    """All rows in one array."""
    return _line(list(records.rows))


def verdict(judgement: Judgement, style: Style) -> str:
    """The judgement for programs."""
    said = judgement.verdict
    return _line(
        {
            "right": said.is_right,
            "name": said.name,
            "unit": said.unit,
            "value": _rounded(said.right, style),
            "claimed": said.claimed,
            "claimed-unit": said.claimed_unit,
            "ratio": None if said.ratio is None else _rounded(said.ratio, style),
            "tolerance": said.tolerance,
            "diagnoses": [diagnosis._asdict() for diagnosis in said.diagnoses],
            "assumptions": list(judgement.assumptions),
            "notes": list(judgement.notes),
            "steps": _steps(said.steps),
        }
    )


def _line(data: Any) -> str:
    return json.dumps(data, ensure_ascii=False, allow_nan=False) + "\n"


def _steps(derivation: Sequence[Step]) -> list[dict[str, str]]:
    return [step._asdict() for step in derivation]


def _row(row: Row, style: Style) -> dict[str, Any]:
    fields: dict[str, Any] = {
        "quantity": row.quantity,
        "symbol": row.symbol,
        "value": _rounded(row.value, style),
        "unit": row.unit,
    }
    if row.name:
        fields = {"name": row.name, **fields}
    if row.given:
        fields["given"] = True
    return {"case": row.case, **fields} if row.case else fields


def _rounded(value: Any, style: Style) -> Any:
    return float(number(value, style.precision)) if style.precision else value
