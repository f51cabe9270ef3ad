"""Amounts without keywords: the unit of each decides which keyword it has."""

from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple

from radcalc.api.arguments import as_text, is_quantity, library_of, magnitude_of, unit_of
from radcalc.api.refusals import with_keywords
from radcalc.api.spelling import is_absent, keyword, symbol_name
from radcalc.calculators.page import Page
from radcalc.calculators.pages import page_of
from radcalc.errors import RadcalcError, UsageError, manual, options, quote
from radcalc.quantities.light import read as read_light
from radcalc.quantities.symbols import QUANTITY, SPECIFIC, in_kind, specific_name
from radcalc.sentences.frames import inputs_of
from radcalc.units.dimensions import LENGTH
from radcalc.units.ranges import read_values
from radcalc.units.reading import read_amount
from radcalc.units.table import resolve
from radcalc.units.unit import Unit


class Unnamed(NamedTuple):
    """An amount without a keyword, and its unit."""

    value: Any
    unit: Unit | None


def with_amounts(
    function: Callable[..., Any], command: str, amounts: Sequence[Any], given: Mapping[str, Any]
) -> dict[str, Any]:
    """Return the keywords of a call, with those of its amounts.

    Raises UsageError, which names the possible keywords, for an amount that may be several inputs
    or none, and for two amounts that are the same input.
    """
    page, named = page_of(command), {k: v for k, v in given.items() if not is_absent(v)}
    try:
        read = [_read(value) for value in amounts]
        found = _inputs(command, read, named)
        names = [name for name in found if name]
        wrong = []
        for amount, name in zip(read, found, strict=True):
            if not name or names.count(name) > 1 or keyword(name) in named:
                wrong.append(amount)
            else:
                named[keyword(name)] = amount.value
        if wrong:
            raise _unplaced(page, command, wrong, named)
    except RadcalcError as error:
        raise with_keywords(error, function, named) from None
    return named


def _read(value: Any) -> Unnamed:
    """Return an amount with its unit; a list has the unit of its first element."""
    first = value[0] if isinstance(value, (list, tuple)) and value else value
    if isinstance(first, str):
        return Unnamed(value, read_amount(read_values(first)[0]).typed[1] or resolve("1"))
    if is_quantity(first) and not library_of(magnitude_of(first)):
        return Unnamed(value, unit_of(first))
    is_number = isinstance(value, (int, float)) and not isinstance(value, bool)
    return Unnamed(value, resolve("1") if is_number else None)


def _inputs(command: str, amounts: Sequence[Unnamed], given: Mapping[str, Any]) -> list[str]:
    """Return the input that each amount is, or "" if it may be several or none.

    Two kinds of one light have their own names: flux is luminous-flux and radiant-flux.
    """
    other = [*map(symbol_name, given)]
    listed = [inputs_of(command, amount.unit, other) if amount.unit else [] for amount in amounts]
    names = [names[0] if len(names) == 1 else "" for names in listed]
    found = []
    for name, amount in zip(names, amounts, strict=True):
        light = read_light(amount.unit) if amount.unit and name else None
        is_taken = names.count(name) > 1 or keyword(name) in given
        own = specific_name(name, light.kind) if light and is_taken else name
        found.append(own if own in SPECIFIC else name)
    return found


def _unplaced(
    page: Page, command: str, wrong: Sequence[Unnamed], given: Mapping[str, Any]
) -> UsageError:
    """Return the error for amounts that need keywords, which it names."""
    texts = [f"'{quote(as_text(amount.value))}'" for amount in wrong]
    problem = f"{', '.join(texts)} {'need keywords' if texts[1:] else 'needs a keyword'}"
    listed = [_candidates(page, amount, given) for amount in wrong]
    if not all(listed):
        return UsageError(problem, manual(command))
    names = dict.fromkeys(name for names in listed for name in names)
    return UsageError(problem, f"one of {options(names, ', ')}")


def _candidates(page: Page, amount: Unnamed, given: Mapping[str, Any]) -> list[str]:
    """Return the inputs of a page that take an amount and are not given."""
    if amount.unit is None:
        return []
    dimension, light = amount.unit.dimension, read_light(amount.unit)
    symbols = [page.symbol(name) for name in page.listed]
    taking = [s.name for s in symbols if s.form == QUANTITY and dimension in s.dimensions]
    if dimension == LENGTH and amount.unit.text not in ("nm", "um"):
        taking = [name for name in taking if name != "wavelength"]
    names = [in_kind(name, light.kind) if light else name for name in taking]
    return [name for name in names if keyword(name) not in given]
