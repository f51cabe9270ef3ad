"""Numbers in columns: a line for each element of arrays."""

from collections.abc import Sequence
from typing import Any

from radcalc.maths import is_array
from radcalc.render.plain import DIGITS, number

LINES = 1000  # lines to format at a time


def lines(columns: Sequence[Any], precision: int | None, count: int = 1) -> str:
    """Return tab-separated columns on `count` lines, or a line for each element of arrays."""
    if not any(map(is_array, columns)):
        return ("\t".join(number(column, precision) for column in columns) + "\n") * count
    return formatted(columns, f"%.{precision or DIGITS}g", "\t")


def formatted(columns: Sequence[Any], form: str, delimiter: str) -> str:
    """Return a line for each element of arrays; `form` formats numbers, not texts."""
    lists = [column.tolist() for column in columns if is_array(column)]
    flat = lists[0] if len(lists) == 1 else [x for line in zip(*lists, strict=True) for x in line]
    cells = [form if is_array(column) else _text(column, form) for column in columns]
    line = delimiter.join(cells) + "\n"
    width = len(lists) * LINES
    pieces = (flat[k : k + width] for k in range(0, len(flat), width))
    return "".join([line * (len(part) // len(lists)) % tuple(part) for part in pieces])


def _text(column: Any, form: str) -> str:
    return (column if isinstance(column, str) else form % column).replace("%", "%%")
