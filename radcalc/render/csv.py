"""CSV with a header: one row a value, or of several alike answers one row each."""

import csv
import io
from collections.abc import Iterable, Sequence
from typing import Any

from radcalc.answer import Result, columns
from radcalc.render.formats import Judgement, Records, Style
from radcalc.render.plain import fields, number, refuse_verdict

REMARKS_ARE_APART = True


def results(results: Sequence[Result], style: Style) -> str:
    """All rows of all results under one header.

    Several answers of a calculator have a column NAME:UNIT for each result, for plotting.
    """
    if heads := columns(results):
        lines = [[_number(row.value, style) for row in result.rows] for result in results]
        return _write([f"{name}:{unit}" for name, unit in heads], lines)
    rows = [row for result in results for row in result.rows]
    with_cases = any(row.case for row in rows)
    with_names = any(row.name for row in rows)
    header = [*(["case"] if with_cases else []), *(["name"] if with_names else [])]
    lines = [
        [
            *([row.case] if with_cases else []),
            *([row.name] if with_names else []),
            row.quantity,
            row.symbol,
            _number(row.value, style),
            row.unit,
        ]
        for row in rows
    ]
    return _write([*header, "quantity", "symbol", "value", "unit"], lines)


def records(records: Records, style: Style) -> str:
    """The rows under their names."""
    return _write(list(records.rows[0]), fields(records))


def verdict(judgement: Judgement, style: Style) -> str:
    """A judgement is no table of values."""
    refuse_verdict()
    return ""


def _write(header: Sequence[str], lines: Iterable[Sequence[Any]]) -> str:
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows([header, *lines])
    return text.getvalue()


def _number(value: float, style: Style) -> str:
    return number(value, style.precision) if style.precision else repr(value)
