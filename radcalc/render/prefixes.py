"""Answers in units with the SI prefixes that fit."""

from collections.abc import Sequence

from radcalc.answer import Result, Row
from radcalc.conversion.plan import exact_ratio, plan
from radcalc.units.prefixes import prefixed
from radcalc.units.table import resolve


def with_prefixes(results: Sequence[Result]) -> list[Result]:
    """The answers with a prefix for each result, which is that of its greatest value.

    What was given stays as it was typed.
    """
    sizes: dict[tuple[str, str], float] = {}
    for row in (row for result in results for row in result.rows if not row.given):
        key = row.name, row.unit
        sizes[key] = max(sizes.get(key, 0.0), abs(row.value))
    units = {(name, unit): prefixed(unit, size) for (name, unit), size in sizes.items()}
    return [
        result._replace(
            rows=tuple(
                row if row.given else _in_unit(row, units[row.name, row.unit])
                for row in result.rows
            )
        )
        for result in results
    ]


def _in_unit(row: Row, unit: str) -> Row:
    """A row in another unit of its quantity."""
    if unit == row.unit:
        return row
    source, target = resolve(row.unit), resolve(unit)
    uncertainty = row.uncertainty * exact_ratio(source, target)
    return row._replace(
        value=plan(source, target).apply(row.value), unit=unit, uncertainty=uncertainty
    )
