"""Results in the units that are asked for: floats, or arrays where a range was given."""

import math
from collections.abc import Callable, Sequence
from copy import copy
from typing import Any

from radcalc.answer import Answer, Row, Value
from radcalc.conversion.plan import exact_ratio
from radcalc.errors import MissingInput, NumberError, UsageError, mention, nearest, quote
from radcalc.given import DIFFERENCES, Given, Inputs, is_on_scale
from radcalc.maths import is_array, is_column, is_lost, is_recorded, is_uncertain
from radcalc.quantities.light import GRID, describe
from radcalc.quantities.symbols import SPECIFIC, SYMBOLS, specific_name
from radcalc.units.dimensions import COHERENT
from radcalc.units.scales import CONSTANTS, ScaleUnit, degree, find, resolve_any
from radcalc.units.table import Unit, unit_of

MOST_OF_A_UNIT = 5  # results that are named in place of their unit
OF_UNCERTAINTY = "-uncertainty"  # behind the name of a result
LINKS_HINT = mention("{wavelength}, {spectrum} or {efficacy}")


def saying_how_read(work_out: Callable[[Inputs], Answer]) -> Callable[[Inputs], Answer]:
    """What works an answer out, and says as well how its inputs were read."""

    def told(given: Inputs) -> Answer:
        answer = work_out(given)
        read = dict.fromkeys([text for one in given.values() for text in one.assumptions])
        if not read:
            return answer
        answers = (answer, *answer.more)
        first, *more = (one._replace(assumptions=(*read, *one.assumptions)) for one in answers)
        return first._replace(more=more)

    return told


def value(name: str, si: Any, *units: str, label: str = "", letter: str = "") -> Value:
    """A result of a symbol [SI], in the units it is shown in: the symbol's own, or others."""
    symbol = SYMBOLS[name]
    return Value(
        name,
        label or symbol.label,
        letter or symbol.letter,
        si,
        symbol.dimensions,
        units or (symbol.unit,),
    )


def absent(name: str, problem: str, hint: str) -> Value:
    """A result that has no meaning here, which says why when it is asked for."""
    message = f"there is no {SYMBOLS[name].label}: {problem}"
    return value(name, 0.0)._replace(units=(), because=UsageError(message, hint))


def known(given: Given, *others: str) -> Value:
    """An input as a result: in the unit it was given in, as it was typed; then in others."""
    text = given.unit_text
    units = (text, *(unit for unit in others if unit != text.replace(".", " ")))
    return value(given.name, given.value, *units)._replace(given=given.number)


def in_unit(value: Value, unit: Unit) -> Any:
    """A value in one of the units it may be asked for, or its reading on a scale."""
    _refuse_absent(value)
    if isinstance(unit, ScaleUnit):
        return _on_scale(value, unit)
    amount = value.reach.get(unit.dimension)
    if unit.dimension in value.dimensions:
        amount = value.amount
    if amount is None:
        own, asked = GRID.get(value.dimensions[0]), GRID.get(unit.dimension)
        if own and asked and own[1:] == asked[1:]:
            message = f"{value.name} in {quote(unit.text)} takes what links the kinds of light"
            raise MissingInput(message, LINKS_HINT)
        raise UsageError(
            f"{value.name} is not measured in {describe(unit)}",
            ", ".join(f"{value.name}:{text}" for text in value.units),
        )
    if value.in_first is not None and unit.text == value.units[0]:
        return value.in_first + 0.0
    ratio = exact_ratio(Unit("SI", 1, 1, unit.dimension, ()), unit)
    return held(value.name, amount * (float(ratio) if is_array(amount) else ratio), amount)


def _on_scale(value: Value, unit: ScaleUnit) -> Any:
    """The reading of a value; what is no part of light has none in dB."""
    if value.in_first is not None and unit.text == value.units[0]:
        return value.in_first + 0.0
    scale = unit.measures((*value.dimensions, *value.reach))
    if not is_on_scale(value.name, scale):
        raise UsageError(
            f"{value.name} is not measured in {quote(unit.text)}",
            ", ".join(f"{value.name}:{text}" for text in value.units),
        )
    return scale.reading(in_unit(value, scale.unit))


def measured_in(text: str, *names: str) -> Unit:
    """The unit or the scale of one of some results; of a difference it may be a degree Celsius."""
    is_difference = any(name in DIFFERENCES for name in names)
    return (degree(text) if is_difference else None) or resolve_any(text)


def _unit_of(text: str, name: str, values: Sequence[Value]) -> Unit:
    """The unit of a result, or a scale with the constants of the light meter in the answer."""
    unit = measured_in(text, name)
    if not isinstance(unit, ScaleUnit):
        return unit
    return unit.with_constants({v.name: v.amount for v in values if v.name in CONSTANTS})


def scales_of(values: Sequence[Value], wanted: Sequence[str]) -> tuple[str, ...]:
    """How the scales are read in which results are asked for, NAME:SCALE."""
    found = []
    for one in wanted:
        name, _, text = one.partition(":")
        scale = _unit_of(text, name, values) if text and find(text) else None
        for value in values:
            if isinstance(scale, ScaleUnit) and name.strip() in (value.name, value.also):
                found.append(scale.measures((*value.dimensions, *value.reach)).assumption)
    return tuple(found)


def _shown(value: Value, text: str) -> Any:
    """A value in one of the units it is shown in, of which most are coherent or as typed."""
    if text == value.units[0] and (typed := value.in_first) is not None:
        return typed + 0.0  # as typed: 30, where pi/6 would give 29.999999999999996
    if text == COHERENT.get(value.dimensions[0]):
        return held(value.name, value.amount)
    return in_unit(value, resolve_any(text))


def _refuse_absent(value: Value, case: str = "") -> None:
    """Say what a result lacks that does not follow, and in which of several answers."""
    of_case = f"{case}: " if case else ""
    if (because := value.because) is not None:
        error = copy(because)  # an answer may be asked again, for another case
        error.message = f"{of_case}{because.message}"
        raise error
    if value.lacking is not None:
        raise MissingInput(f"{of_case}no {value.label} follows from what is given", value.lacking())


def element(value: Value, k: int) -> Value:
    """One element of a value that is an array."""

    def of(x: Any) -> Any:
        return float(x[k]) if is_column(x) else x

    reach = {dimension: of(amount) for dimension, amount in value.reach.items()}
    return value._replace(
        si=of(value.si), reach=reach, given=of(value.given), exact=of(value.exact)
    )


def held(name: str, number: Any, of: Any = None) -> Any:
    """A result as floats, unless it has left what a number can hold.

    It is too small where it has lost digits, or is 0 and what it is a multiple `of` is not.
    """
    if type(number) is not float and is_uncertain(number):
        held(name, number.nominal_value, getattr(of, "nominal_value", of))
        return number
    if is_lost(number, number if of is None else of):
        raise NumberError(f"{name} is too small for a number", "less extreme values")
    if (type(number) is float or is_recorded(number)) and number - number == 0:
        return number + 0.0
    if is_column(number):
        good = bool((abs(number) < math.inf).all())
    else:
        number = float(number)
        good = math.isfinite(number)
    if not good:
        raise NumberError(f"{name} cannot be held by a number", "less extreme values")
    return number + 0.0


def name_of(wanted: str) -> str:
    """The name of a result that is asked for as NAME[:UNIT]."""
    return wanted.partition(":")[0].strip()


def pick(values: Sequence[Value], wanted: str, case: str = "") -> Row:
    """What NAME[:UNIT] asks for; without a unit, in the one in which the listing has it first.

    NAME-uncertainty asks for the standard uncertainty of NAME, 0 where nothing is uncertain.
    """
    name, _, text = wanted.partition(":")
    name, text = name.strip(), text.strip()
    if name.endswith(OF_UNCERTAINTY):
        row = pick(values, f"{name.removesuffix(OF_UNCERTAINTY)}:{text}", case)
        return row._replace(value=row.uncertainty, name=name, uncertainty=0.0, given=False)
    for value in values:
        if name and name in (value.name, value.also):
            _refuse_absent(value, case)
            label, letter, is_given = value.label, value.letter, value.given is not None
            if not text:
                text = value.units[0]
                number = _shown(value, text)
            else:
                unit = _unit_of(text, value.name, values)
                number = in_unit(value, unit)
                if unit.dimension not in value.dimensions and not unit.is_scale:
                    label, letter = _of_kind(value, unit)
            row = Row(label, letter, number, text, case, name, is_given, form=value.form)
            return _apart(row)
    names = names_of(values)
    generic = SPECIFIC.get(name, ("", ""))[0]
    if generic in names:
        raise MissingInput(
            f"{name} takes what links the kinds of light", f"{LINKS_HINT}, or {generic}"
        )
    of_case = f"{case}: " if case else ""
    hint = _right_names(name, values, names)
    raise UsageError(f"{of_case}there is no result '{quote(name)}'", hint)


def names_of(values: Sequence[Value]) -> list[str]:
    """The results that follow, by their names."""
    return list(dict.fromkeys(value.name for value in values if not value.is_absent))


def _right_names(name: str, values: Sequence[Value], names: Sequence[str]) -> str:
    """What to ask for in place of a name of no result: what has that unit, what is like it, all."""
    if unit := find(name) or unit_of(name):
        read = {
            one.dimension for one in (unit, *(unit.others if isinstance(unit, ScaleUnit) else ()))
        }
        own = [v for v in values if not v.is_absent and read & {*v.dimensions, *v.reach}]
        own = [v for v in own if v.given is None] or own
        return ", ".join(f"{v.name}:{quote(name)}" for v in own[:MOST_OF_A_UNIT]) or ", ".join(
            names
        )
    word = "-".join(name.lower().replace("_", " ").split())
    taken = [v.also for v in values if v.also and not v.is_absent]
    return word if word in (*names, *taken) else ", ".join(nearest(word, names) or names)


def _apart(row: Row) -> Row:
    """A row in which the number stands beside its uncertainty."""
    if not is_uncertain(row.value):
        return row
    return row._replace(value=row.value.nominal_value, uncertainty=row.value.std_dev)


def _of_kind(value: Value, unit: Unit) -> tuple[str, str]:
    """The label and the letter of a light quantity in the kind of a unit."""
    symbol, place = SYMBOLS.get(value.name), GRID.get(unit.dimension)
    if symbol is None or not symbol.generic or place is None:
        return value.label, value.letter
    own = SYMBOLS[specific_name(symbol.generic, place[0])]
    return own.label, own.letter if "_" in own.letter else f"{own.letter}_{place[0]}"


def rows(values: Sequence[Value], case: str = "") -> list[Row]:
    """All the results, each in the units it is shown in.

    Of several answers each begins with what was given, which tells them apart.
    """
    found = [
        Row(
            v.label,
            v.letter,
            _shown(v, text),
            text,
            case,
            v.name,
            v.given is not None,
            form=v.form,
        )
        for v in values
        for text in v.units
    ]
    found = [row if type(row.value) is float else _apart(row) for row in found]
    if case:
        found.sort(key=lambda row: not row.given)
    return found
