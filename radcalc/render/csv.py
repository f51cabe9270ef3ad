"""CSV with a header, one row a value."""

import csv
import io
from collections.abc import Sequence

from radcalc.render.plain import number
from radcalc.result import Result


def render(results: Sequence[Result], precision: int | None = None) -> str:
    """All rows of all results under one header."""
    rows = [row for result in results for row in result.rows]
    cases = any(row.case for row in rows)
    names = any(row.name for row in rows)
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    extra = [*(["case"] if cases else []), *(["name"] if names else [])]
    writer.writerow([*extra, "quantity", "symbol", "value", "unit"])
    for row in rows:
        value = number(row.value, precision) if precision else repr(row.value)
        extra = [*([row.case] if cases else []), *([row.name] if names else [])]
        writer.writerow([*extra, row.quantity, row.symbol, value, row.unit])
    return text.getvalue()
