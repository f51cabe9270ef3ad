"""SI prefixes that fit the numbers of an answer."""

import math
from collections.abc import Sequence
from functools import lru_cache

from radcalc.answer import Result, Row
from radcalc.conversion import exact_ratio
from radcalc.conversion.plan import plan
from radcalc.floats import LARGEST, SMALLEST
from radcalc.render import plain
from radcalc.terminal import CSV, TABLE
from radcalc.units import lookup
from radcalc.units.compiled import PREFIX_NAMES, PREFIX_SYMBOLS
from radcalc.units.grammar import parse_unit
from radcalc.units.grammar import plain as plain_form
from radcalc.units.table import resolve, unit_of


def prefixes_of(text: str) -> dict[int, str]:
    """Return a unit with each prefix of a power of 1000, by power of ten relative to the unit.

    The unit itself is first.  The prefix goes before the first of several units, unless that one
    has an exponent: kcd/m2, but m2.
    """
    spellings = {0: text}
    if unit_of(text) is None:
        return spellings
    folded = plain_form(text)
    spelling, exponent, _ = parse_unit(folded)[0]
    read = lookup(spelling)
    if read is None or exponent != 1 or not folded.startswith(spelling):
        return spellings
    own_shift = PREFIX_NAMES.get(read[0], 0)
    for shift, first in _spellings(spelling, *read).items():
        spellings.setdefault(shift - own_shift, first + folded[len(spelling) :])
    return spellings


def _spellings(spelling: str, prefix: str, unit: str) -> dict[int, str]:
    own_marks = [prefix, *(mark for mark, name in PREFIX_SYMBOLS.items() if name == prefix)]
    head = next(head for head in own_marks if spelling.lower().startswith(head.lower()))
    stem = spelling[len(head) :]
    spellings: dict[int, str] = {}
    for mark, name in [("", ""), *PREFIX_SYMBOLS.items(), *((full, full) for full in PREFIX_NAMES)]:
        shift = PREFIX_NAMES.get(name, 0)
        if shift % 3 == 0 and lookup(mark + stem) == (name, unit):
            spellings.setdefault(shift, mark + stem)
    return spellings


LEAST, MOST = 1.0, 1000.0
_units = lru_cache(maxsize=64)(prefixes_of)
DIGITS = {TABLE: plain.TABLE_DIGITS, CSV: 16}  # digits of numbers; CSV has all


def with_prefixes(results: Sequence[Result], form: str, precision: int | None) -> list[Result]:
    """Return the answers with an SI prefix for each number with a unit of its own.

    The numbers of a column share the prefix of the smallest.  Given values stay as typed.
    """
    digits = DIGITS.get(form, plain.DIGITS)
    heads = {tuple((row.name, row.unit) for row in result.rows) for result in results}
    is_wide = form == TABLE and len(results) > 1 == len(heads) and results[0].named
    of_columns = form == CSV or is_wide
    columns: dict[tuple[str, str], list[Row]] = {}
    for row in (row for result in results for row in result.rows if not row.given):
        columns.setdefault((row.name, row.unit), []).append(row)
    units = {key: _suited(rows, precision, digits) for key, rows in columns.items() if of_columns}

    def prefixed(row: Row) -> Row:
        if row.given:
            return row
        unit = units.get((row.name, row.unit)) or _suited([row], precision, digits)
        return _in_unit(row, unit)

    return [result._replace(rows=tuple(map(prefixed, result.rows))) for result in results]


def _suited(rows: Sequence[Row], precision: int | None, digits: int) -> str:
    """Return the unit with the best prefix for the rounded numbers; unchanged for zeros.

    As few numbers as possible have an exponent, and the smallest is between 1 and 1000.
    """
    amounts = [(row.value, row.uncertainty) for row in rows]
    unit = rows[0].unit
    sizes = [max(abs(value), off) for value, off in amounts]
    if not any(sizes):
        return unit
    least = amounts[sizes.index(min(size for size in sizes if size))]

    def unsuited(power: int) -> tuple[int, bool, float, int]:
        times = 10.0**-power
        texts = [plain.uncertain(x * times, off * times, precision, digits) for x, off in amounts]
        size = _rounded(least[0] * times, least[1] * times, precision, digits)
        fits = LEAST <= size < MOST
        away = 0.0 if fits else abs(math.log10(size / (LEAST if size < LEAST else MOST)))
        return sum("e" in text for text in texts), not fits, away, abs(power)

    if unsuited(0)[:2] == (0, False):
        return unit
    held = [
        power
        for power in _units(unit)
        if all(SMALLEST <= size * 10.0**-power <= LARGEST for size in sizes if size)
    ]
    return _units(unit)[min(held, key=unsuited)]


def _rounded(value: float, off: float, precision: int | None, digits: int) -> float:
    """Return the size of a nonzero amount as it is shown."""
    digits = min(precision or digits, plain.DIGITS)  # 999.9999999999999 is 1000
    text = plain.uncertain(value, off, precision, digits).partition(" ")[0]
    return max(abs(float(text)), off) if text[0] != "(" else max(abs(value), off)


def _in_unit(row: Row, unit: str) -> Row:
    if unit == row.unit:
        return row
    source, target = resolve(row.unit), resolve(unit)
    uncertainty = row.uncertainty * exact_ratio(source, target)
    made = plan(source, target)
    return row._replace(value=made.apply(row.value), unit=unit, uncertainty=uncertainty)
