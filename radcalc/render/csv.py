"""CSV with a header: one row a value, or of several alike answers one row each."""

import csv
import io
from collections.abc import Sequence

from radcalc.answer import Result, columns
from radcalc.render.plain import number


def render(results: Sequence[Result], precision: int | None = None) -> str:
    """All rows of all results under one header.

    Several answers of a calculator have a column NAME:UNIT for each result, for plotting.
    """
    if heads := columns(results):
        return _wide(results, heads, precision)
    rows = [row for result in results for row in result.rows]
    cases = any(row.case for row in rows)
    names = any(row.name for row in rows)
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    extra = [*(["case"] if cases else []), *(["name"] if names else [])]
    writer.writerow([*extra, "quantity", "symbol", "value", "unit"])
    for row in rows:
        value = _number(row.value, precision)
        extra = [*([row.case] if cases else []), *([row.name] if names else [])]
        writer.writerow([*extra, row.quantity, row.symbol, value, row.unit])
    return text.getvalue()


def _wide(
    results: Sequence[Result], heads: Sequence[tuple[str, str]], precision: int | None
) -> str:
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow([f"{name}:{unit}" for name, unit in heads])
    writer.writerows([_number(row.value, precision) for row in result.rows] for result in results)
    return text.getvalue()


def _number(value: float, precision: int | None) -> str:
    return number(value, precision) if precision else repr(value)
