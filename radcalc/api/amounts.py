"""Amounts without keywords: the unit of each decides which keyword it has."""

from collections.abc import Callable, Mapping, Sequence
from itertools import product
from typing import Any, NamedTuple

from radcalc.api.quantity import is_quantity, magnitude_of, typed, unit_of
from radcalc.api.reading import library_of
from radcalc.api.refusals import with_keywords
from radcalc.api.spelling import is_absent, keyword, symbol_name
from radcalc.calculators.page import Page
from radcalc.calculators.pages import page_of
from radcalc.errors import RadcalcError, Try, UsageError, manual, options, quote
from radcalc.quantities.light import read as read_light
from radcalc.quantities.symbols import QUANTITY, SPECIFIC, in_kind, specific_name
from radcalc.sentences.frames import inputs_of
from radcalc.units.dimensions import LENGTH
from radcalc.units.ranges import read_values
from radcalc.units.reading import read_amount
from radcalc.units.table import resolve
from radcalc.units.unit import Unit

MOST = 10  # proposals of keywords
FEW = 4  # amounts without a keyword, for which there are proposals


class Unnamed(NamedTuple):
    """An amount without a keyword: its value, its text if a call can show it, and its unit."""

    value: Any
    text: str
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


def _is_single(value: Any) -> bool:
    return is_quantity(value) and isinstance(value.magnitude, (int, float))


def _read(value: Any) -> Unnamed:
    one = value[0] if isinstance(value, (list, tuple)) and value else value
    if isinstance(one, str):
        amount = read_amount(read_values(one)[0])
        unit = amount.typed[1] or resolve("1")
        return Unnamed(value, value if one is value else "", unit)
    if is_quantity(one) and not library_of(magnitude_of(one)):
        return Unnamed(value, typed(value) if _is_single(value) else "", unit_of(one))
    is_number = isinstance(value, (int, float)) and not isinstance(value, bool)
    return Unnamed(value, str(value) if is_number else "", resolve("1") if is_number else None)


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
    """Return the error for amounts that need keywords; it proposes those with their units."""
    texts = [f"'{quote(amount.text or str(amount.value))}'" for amount in wrong]
    problem = f"{', '.join(texts)} {'need keywords' if texts[1:] else 'needs a keyword'}"
    listed = [_candidates(page, amount, given) for amount in wrong]
    if not all(listed):
        return UsageError(problem, manual(command))
    hint = f"one of {options(dict.fromkeys(name for names in listed for name in names), ', ')}"
    if not all(amount.text for amount in wrong):
        return UsageError(problem, hint)
    ways = product(*listed) if len(wrong) <= FEW else ()
    choices = [names for names in ways if len({*names}) == len(names)]
    texts = [amount.text for amount in wrong]
    tries = [Try(tuple(zip(names, texts, strict=True))) for names in choices[:MOST]]
    return UsageError(problem, hint, tries)


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
