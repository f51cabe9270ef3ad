"""Strict JSON at full precision: a conversion is one flat object, a calculator has results."""

import json
from collections.abc import Sequence
from typing import Any

from radcalc.answer import Result, Row, Step
from radcalc.render.plain import number


def render(
    result: Result, precision: int | None = None, place: dict[str, int] | None = None
) -> str:
    """One object, on one line; several values of one answer are its `results`.

    In a stream it begins with its `place`: the line, and the field.
    """
    rows = [_row(row, precision) for row in result.rows]
    flat = len(rows) == 1 and not result.rows[0].name
    answer: dict[str, Any] = rows[0] if flat else {"results": rows}
    answer["assumptions"] = list(result.assumptions)
    answer["notes"] = list(result.notes)
    answer["steps"] = steps(result.steps)
    return json.dumps({**(place or {}), **answer}, ensure_ascii=False, allow_nan=False) + "\n"


def steps(derivation: Sequence[Step]) -> list[dict[str, str]]:
    """The steps of a derivation, an object each."""
    return [
        {
            "law": step.law,
            "formula": step.formula,
            "numbers": step.numbers,
            "reference": step.reference,
        }
        for step in derivation
    ]


def _row(row: Row, precision: int | None) -> dict[str, Any]:
    fields: dict[str, Any] = {
        "quantity": row.quantity,
        "symbol": row.symbol,
        "value": float(number(row.value, precision)) if precision else row.value,
        "unit": row.unit,
    }
    if row.name:
        fields = {"name": row.name, **fields}
    if row.given:
        fields["given"] = True
    return {"case": row.case, **fields} if row.case else fields
