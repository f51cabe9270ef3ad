"""Answers as Python shows them: text in an interpreter, HTML in a notebook.

The HTML sets no colours, so that it is readable on light and on dark.
"""

from collections.abc import Iterable, Sequence
from html import escape
from typing import Any

from radcalc.answer import Result, Row, ShownInput
from radcalc.maths import is_column
from radcalc.render.plain import TABLE_DIGITS, derivation, number, uncertain
from radcalc.terminal import remarks
from radcalc.units import unit_behind

MOST, ENDS = 8, 3  # most elements of an array to show, and elements at each end of a longer one
QUIET = ' style="opacity: 0.7"'
STYLE = ' style="border-collapse: collapse"'
LEFT, RIGHT = ' style="text-align: left"', ' style="text-align: right"'


def text(command: str, result: Result) -> str:
    """Return a line for each result, then assumptions and notes."""
    lines = [
        (row.name, f"{_value(row)}{unit_behind(row.unit)}", _given(row)) for row in result.rows
    ]
    width = max((len(name) for name, *_ in lines), default=0)
    texts = [f"{name:<{width}}  {value}{given}" for name, value, given in lines]
    texts += remarks(result.assumptions, result.notes)
    return "\n".join([f"radcalc {command}", *(f"  {text_line}" for text_line in texts)])


def html(command: str, result: Result) -> str:
    """Return a table of inputs and results, the remarks, and the derivation, collapsed."""
    given = [_input(item) for item in result.inputs]
    rows = [_row(row) for row in result.rows if not row.given]
    parts = [
        f"<table{STYLE}><caption{LEFT}>{escape(command)}</caption>",
        "<thead>" + _cells("th", ("quantity", "symbol", "value", "unit")) + "</thead>",
        f"<tbody{QUIET}>{''.join(given)}</tbody>" if given else "",
        f"<tbody>{''.join(rows)}</tbody></table>",
    ]
    if result_remarks := remarks(result.assumptions, result.notes):
        parts.append(f"<ul>{_items(result_remarks)}</ul>")
    if result.steps:
        steps = escape("\n".join(derivation(result.steps)))
        parts.append(f"<details><summary>steps</summary><pre>{steps}</pre></details>")
    return f'<div class="radcalc">{"".join(parts)}</div>'


def _items(texts: Iterable[str]) -> str:
    return "".join(f"<li>{escape(text)}</li>" for text in texts)


def _input(item: ShownInput) -> str:
    name = item.name.replace("-", " ")
    if item.is_quantity and is_column(item.value):
        return _cells("td", (f"{name} (given)", "", _number(item.value), item.unit))
    value = item.text or ("yes" if item.value is True else f"{item.value:.12g} {item.unit}")
    return _cells("td", (f"{name} (given)", "", value, ""))


def _row(row: Row) -> str:
    return _cells("td", (row.quantity, row.symbol, _value(row), row.unit))


def _cells(tag: str, texts: Sequence[str]) -> str:
    *first_cells, unit = texts
    name, symbol, value, unit = map(escape, (*first_cells, unit_behind(unit).strip()))
    return (
        f"<tr><{tag}{LEFT}>{name}</{tag}><{tag}{LEFT}>{symbol}</{tag}>"
        f"<{tag}{RIGHT}>{value}</{tag}><{tag}{LEFT}>{unit}</{tag}></tr>"
    )


def _given(row: Row) -> str:
    return " (given)" if row.given else ""


def _value(row: Row) -> str:
    if is_column(row.value):
        return _number(row.value)
    return uncertain(float(row.value), row.uncertainty, None, TABLE_DIGITS)


def _number(values: Any) -> str:
    """Return an array's elements or those at its ends; its shape if it is not computed."""
    if not hasattr(values, "tolist"):
        return f"an array of the shape {values.shape}, not computed yet"
    if values.ndim > 1:
        return f"[{' '.join(map(_number, values))}]" if values.size <= MOST else _shape(values)
    texts = [number(value, TABLE_DIGITS) for value in values.tolist()]
    if len(texts) > MOST:
        texts = [*texts[:ENDS], "...", *texts[-ENDS:]]
    return f"[{' '.join(texts)}]"


def _shape(values: Any) -> str:
    least, most = (number(float(value), TABLE_DIGITS) for value in (values.min(), values.max()))
    return f"an array of the shape {values.shape}, from {least} to {most}"
