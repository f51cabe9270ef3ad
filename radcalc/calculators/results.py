"""Results of calculators: their values, how they are asked for, and names that people write."""

import math
from collections.abc import Mapping, Sequence
from functools import cache
from typing import TYPE_CHECKING, Any, cast

from radcalc import errors
from radcalc.answer import Answer, Row, Value, letter_of
from radcalc.conversion import exact_ratio
from radcalc.errors import UsageError, ambiguous, corrections, quote
from radcalc.floats import SMALLEST
from radcalc.inputs import Input, Inputs
from radcalc.inputs.quantities import measured_in, takes_scale
from radcalc.maths import is_array, is_column, is_lost, is_uncertain
from radcalc.quantities import KIND_NAMES, OBSERVERS, place_of, ratio_of, read, symbols
from radcalc.quantities import name_of as unit_name
from radcalc.quantities.language import names_meant
from radcalc.quantities.names import LABELS, QUANTITIES, Quantity, as_seen
from radcalc.quantities.search import called, comparable, label_of, symbol_key
from radcalc.quantities.symbols import SPECIFIC, SYMBOLS, is_alone, light_unit
from radcalc.units import INVERSE_TEMPERATURE, NUMBER, WEIGHT_AT, Dimension, Unit
from radcalc.units.compiled import WEIGHTS
from radcalc.units.dimensions import COHERENT
from radcalc.units.table import resolve, unit_of

if TYPE_CHECKING:
    from radcalc.units.values import ScaleUnit

MOST_OF_A_UNIT = 5  # results to suggest for a unit
LIKE = 4  # letters at the start of related words
VAGUE = ("index", "value", "factor", "ratio", "number")  # words of unrelated names
OF_UNCERTAINTY = "-uncertainty"  # suffix of the name of a result
LINKS_HINT = errors.mention("{spectrum=sun}, {spectrum=LED-B3}, {wavelength} or {efficacy}")
MISSING_LINK = "a wavelength, a spectrum or an efficacy that links them is missing"
NEEDS_LINK = "needs the wavelength or the spectrum of the light, or an efficacy"


def value(name: str, si: Any, *units: str, label: str = "", letter: str = "") -> Value:
    """Return a result of a symbol [SI], shown in its own unit or in the given ones."""
    symbol = SYMBOLS[name]
    return Value(
        name,
        label or symbol.label,
        letter or symbol.letter,
        si,
        symbol.measured,
        units or (symbol.unit,),
    )


def of_directions(given: Inputs, name: str, size: Any) -> Value:
    """Return a result of a solid angle."""
    more = ("sr", "deg2") if name == "solid-angle" else ()
    if name in given:
        return known(given[name], *more)
    is_angle = name in ("half-angle", "apex-angle")
    label = f"{SYMBOLS[name].label} of the equal cone" if is_angle else ""
    return value(name, size, *more, label=label)


def absent(name: str, problem: str, hint: str, *others: str) -> Value:
    """Return a result without a value; requesting it raises an error with the reason.

    `others` are results to request in its place.
    """
    message = f"there is no {SYMBOLS[name].label}: {problem}"
    words = [word for other in others for word in ("-g", other)][1:]
    error = errors.UsageError(message, hint, [errors.correct(name, *words)] if others else ())
    return value(name, 0.0)._replace(units=(), because=error)


@cache
def on_request(name: str) -> Value:
    """Return a result that is calculated only if it is requested, without its value."""
    return value(name, 0.0)._replace(units=())


def known(given: Input, *more_units: str) -> Value:
    """Return an input as a result: as typed, then in other units."""
    text = given.unit_text
    units = (text, *(unit for unit in more_units if unit != text.replace(".", " ")))
    return value(given.name, given.value, *units)._replace(given=given.number)


def in_unit(value: Value, unit: Unit, among: Sequence[Value] = ()) -> Any:
    """Return a value in a unit, or its reading on a scale; `among` are results to suggest."""
    _refuse_absent(value)
    if unit.dimension == NUMBER and is_alone(value.name, unit):
        typed = f"{value.name}:{unit.text}"
        problem = f"{value.name} is a number without a unit, not in {quote(unit.text)}"
        raise errors.UnitError(problem, errors.correct(typed, value.name))
    if unit.is_scale:
        return _on_scale(value, cast("ScaleUnit", unit), among)
    amount = value.reach.get(unit.dimension)
    if unit.dimension in value.dimensions:
        amount = value.amount
    if amount is None:
        for other in among:  # the same light in another kind
            if other.because and unit.dimension in other.dimensions:
                raise other.because
        own_grid, wanted_grid = place_of(value.dimensions[0]), place_of(unit.dimension)
        is_other_kind = own_grid and wanted_grid and own_grid[1:] == wanted_grid[1:]
        if is_other_kind and not _results_in(unit.text, among):
            message = f"{name_in(value, unit.dimension)} in {quote(unit.text)} {NEEDS_LINK}"
            kind = wanted_grid[0] if wanted_grid else ""
            raise errors.MissingInput(message, LINKS_HINT, _of_weight(kind, value))
        raise _wrong_unit(value, unit, among)
    if value.in_first is not None and unit.text == value.units[0]:
        return value.in_first + 0.0
    ratio = exact_ratio(Unit("SI", 1, 1, unit.dimension, ()), unit)
    return check_representable(
        value.name, amount * (float(ratio) if is_array(amount) else ratio), amount
    )


def _of_weight(kind: str, value: Value) -> list[errors.Try]:
    """Propose the weight of a kind, with a spectrum unless the light has one."""
    if kind not in WEIGHTS:
        return []
    weight = ("weight", WEIGHTS[kind][0])
    linked = [weight] if value.reach else [("spectrum", "sun"), weight]
    return [errors.Try(tuple(linked))]


def of_eyes(value: Value, unit: Unit) -> Unit:
    """Return a unit of lumens for a result of an observer as one of its own lumens."""
    own = value.dimensions[0]
    if not own[WEIGHT_AT]:
        return unit
    place, pair = place_of(own), ratio_of(own)
    kinds = [kind for kind in (*(place or ())[:1], *(pair or ())) if kind in OBSERVERS.values()]
    return as_seen(unit, kinds[0]) if kinds else unit


def _wrong_unit(value: Value, unit: Unit, among: Sequence[Value]) -> errors.UsageError:
    described = quote(unit.text)
    if not unit.is_scale:
        name = unit_name(unit)
        described = f"{described}, a unit of {name}" if name else f"'{described}'"
    ways = [*_results_in(unit.text, among), *(f"{value.name}:{text}" for text in value.units)]
    problem = f"{value.name} cannot be in {described}"
    return errors.UsageError(problem, errors.corrections(f"{value.name}:{unit.text}", *ways))


def _on_scale(value: Value, unit: "ScaleUnit", among: Sequence[Value]) -> Any:
    if value.in_first is not None and unit.text == value.units[0]:
        return value.in_first + 0.0
    scale = unit.measures((*value.dimensions, *value.reach))
    if not _takes(value, scale):
        raise _wrong_unit(value, unit, among)
    try:
        return scale.reading(in_unit(value, scale.unit, among))
    except errors.MissingInput:
        raise
    except errors.UsageError:
        raise _wrong_unit(value, unit, among) from None


def unit_for(value: Value, text: str, constants: Mapping[str, Any] | None = None) -> Unit:
    """Return the unit or the scale of a text for a result; of scales, that of its dimension.

    `constants` are those of a light meter.
    """
    dimensions = (*value.dimensions, *value.reach)
    unit = unit_of(text)
    if unit and unit.dimension in dimensions:
        return unit
    unit = measured_in(text, value.name)
    if unit.is_scale:
        return cast("ScaleUnit", unit).with_constants(constants or {}).measures(dimensions)
    if unit.dimension == INVERSE_TEMPERATURE not in dimensions:
        from radcalc.units.values import reciprocal

        return reciprocal(unit)
    return unit


def fits(value: Value, unit: Unit) -> bool:
    """Return whether a result can be in a unit for it, or on a scale."""
    is_like = unit.dimension in (*value.dimensions, *value.reach)
    return is_like and not is_alone(value.name, unit) and _takes(value, unit)


def _takes(value: Value, unit: Unit) -> bool:
    """Return whether a result has readings on a scale: a ratio on any, if it is shown on one."""
    if not unit.is_scale or takes_scale(value.name, unit):
        return True
    return not value.is_absent and measured_in(value.units[0], value.name).is_scale


def constants_of(values: Sequence[Value]) -> dict[str, Any]:
    """Return the constants of a light meter among results."""
    from radcalc.units.scale_table import CONSTANTS

    return {value.name: value.amount for value in values if value.name in CONSTANTS}


def scales_of(values: Sequence[Value], wanted: Sequence[str]) -> tuple[str, ...]:
    """Return the assumptions of the scales in requested results, NAME:SCALE."""
    assumptions = []
    for name, _, text in [result.partition(":") for result in wanted]:
        if not text or text in COHERENT.values():  # not a scale
            continue
        for value in values:
            if name.strip() in (value.name, value.also):
                unit = unit_for(value, text, constants_of(values))
                assumptions += [cast("ScaleUnit", unit).assumption] if unit.is_scale else []
    return tuple(assumptions)


def _in_shown_unit(value: Value, text: str) -> Any:
    if text == value.units[0] and (typed := value.in_first) is not None:
        return typed + 0.0  # as typed: 30, where pi/6 would give 29.999999999999996
    if text == COHERENT.get(value.dimensions[0]):
        return check_representable(value.name, value.amount)
    return in_unit(value, unit_for(value, text))


def _refuse_absent(value: Value, case: str = "") -> None:
    of_case = f"{case}: " if case else ""
    if (because := value.because) is not None:
        raise because.reworded(f"{of_case}{because.message}")
    if value.lacking is not None:
        raise errors.MissingInput(
            f"{of_case}the inputs do not give the {value.label}", value.lacking()
        )
    if value.is_absent:
        problem = f"{of_case}{value.name} is calculated only if it is requested by name"
        raise errors.UsageError(problem, errors.add("get", value.name))


def element(value: Value, k: int) -> Value:
    """Return an element of an array value."""

    def of(x: Any) -> Any:
        return float(x[k]) if is_column(x) else x

    reach = {dimension: of(amount) for dimension, amount in value.reach.items()}
    return value._replace(
        si=of(value.si), reach=reach, given=of(value.given), exact=of(value.exact)
    )


def check_representable(name: str, number: Any, of: Any = None) -> Any:
    """Return a result as floats; refuse one that is too large or too small for a float.

    It is too small if it has lost digits, or is 0 though it is a multiple `of` a non-zero value.
    """
    if type(number) is float and SMALLEST <= abs(number) < math.inf:
        return number
    if type(number) is not float and is_uncertain(number):
        check_representable(name, number.nominal_value, getattr(of, "nominal_value", of))
        return number
    if is_lost(number, number if of is None else of):
        raise errors.NumberError(f"{name} is too small for a number", "less extreme values")
    if type(number) is float and number - number == 0:
        return number + 0.0
    if is_column(number):
        good = bool((abs(number) < math.inf).all())
    else:
        number = float(number)
        good = math.isfinite(number)
    if not good:
        raise errors.NumberError(f"{name} is too large for a number", "less extreme values")
    return number + 0.0


def name_of(wanted: str) -> str:
    """Return the name of a requested result, NAME[:UNIT]."""
    return wanted.partition(":")[0].strip()


def listed_in(texts: Sequence[str]) -> tuple[str, ...]:
    """Return the results that texts list: two in rf,rg:1, one in the symbol R_f,h1."""
    names: list[str] = []
    for text in texts:
        for k, part in enumerate(text.split(",")):
            if k and part[:1] == "h" and part[1:].isdigit():
                names[-1] += f",{part}"
            else:
                names.append(part)
    return tuple(names)


def pick(values: Sequence[Value], wanted: str, case: str = "") -> Row:
    """Return the result NAME[:UNIT]; without a unit, in its first shown unit.

    NAME-uncertainty is the standard uncertainty of NAME, 0 without uncertain inputs.
    """
    name, _, text = wanted.partition(":")
    name, text = name.strip(), text.strip()
    if name.endswith(OF_UNCERTAINTY):
        row = pick(values, f"{name.removesuffix(OF_UNCERTAINTY)}:{text}", case)
        number, name = row.uncertainty, row.name + OF_UNCERTAINTY
        return row._replace(value=number, name=name, uncertainty=0.0, given=False)
    if called := _called(values, name, text):
        value = called[0]
        _refuse_absent(value, case)
        label, letter, is_given = value.label, value.letter, value.given is not None
        if not text:
            text = value.units[0]
            number = _in_shown_unit(value, text)
        else:
            unit = unit_for(value, text, constants_of(values))
            if (seen := of_eyes(value, unit)) is not unit:
                unit, text = seen, seen.text
            number = in_unit(value, unit, values)
            if unit.dimension not in value.dimensions and not unit.is_scale:
                label, letter = of_kind(value, unit)
        row = Row(label, letter, number, text, case, name, is_given, 0.0, value.form)
        return _apart(row)
    other, unit_text = results_meant(name, values, text)
    if other:
        try:
            return pick(values, f"{other}:{text or unit_text}", case)
        except errors.RadcalcError as error:
            raise _as_typed(error, name, other) from None
    names = names_of(values)
    generic = symbols.SPECIFIC.get(name, ("", ""))[0]
    linked = _of_kind(name, generic, values) if generic in names and not text else []
    if generic in names and not linked:
        raise errors.MissingInput(f"{name} {NEEDS_LINK}", f"{LINKS_HINT}, or {generic}")
    of_case = f"{case}: " if case else ""
    few = names if len(names) <= MOST_OF_A_UNIT else []
    hint = linked or errors.corrections(name, *(right_names(name, values) or few))
    raise errors.UnknownResult(f"{of_case}unknown result '{quote(name)}'", names, hint)


def _as_typed(error: errors.RadcalcError, typed: str, name: str) -> errors.RadcalcError:
    """Return the error of a result whose hint replaces the name as the user typed it."""
    tries = [
        errors.correct(typed, *one.instead[1:], remark=one.remark)
        if one.instead[:1] == (name,)
        else one
        for one in error.tries
    ]
    return error.reworded(tries=tries)


def _of_kind(name: str, generic: str, values: Sequence[Value]) -> list[errors.Try]:
    """Propose the result of a light quantity in a unit of a kind, if the light has that kind."""
    kind = symbols.SPECIFIC[name][1]
    unit = symbols.light_unit(generic, kind)
    reach = next(value.reach for value in values if value.name == generic)
    return [errors.correct(name, f"{generic}:{unit}")] if resolve(unit).dimension in reach else []


def said_of(answer: Answer, rows: Sequence[Row]) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Return the assumptions and the notes on the results that rows show."""
    return answer.said([_in_its_kind(answer.values, row) for row in rows])


def _in_its_kind(values: Sequence[Value], row: Row) -> tuple[str, str]:
    """Return the generic name of a result, and the kind of light of its unit, if any."""
    name = row.name.removesuffix(OF_UNCERTAINTY)
    value = next(iter(_called(values, name, row.unit)), values[0])
    place = place_of(unit_for(value, row.unit).dimension)
    return symbols.generic_name(value.name), place[0] if place else ""


def _called(values: Sequence[Value], name: str, text: str) -> list[Value]:
    """Return the results with a name; the unit decides between two kinds of light."""
    exact = [value for value in values if name and value.name == name]
    found = exact or [value for value in values if name and value.also == name]
    names = dict.fromkeys(value.name for value in found)
    if len(names) < 2:
        return found
    if not text:
        problem = errors.ambiguous(name, "light is given in two kinds")
        raise errors.UsageError(problem, errors.corrections(name, *names))
    dimension = measured_in(text).dimension
    return [value for value in found if dimension in value.dimensions] or found


def names_of(values: Sequence[Value]) -> list[str]:
    """Return the names of the results that follow."""
    return list(dict.fromkeys(value.name for value in values if not value.is_absent))


def _results_in(text: str, values: Sequence[Value]) -> list[str]:
    """Return the results that can be in a unit or on a scale, with it; given ones if no others."""
    from radcalc.units.values import find_scale

    if not (find_scale(text) or unit_of(text)):
        return []
    suitable = [v for v in values if not v.is_absent and fits(v, unit_for(v, text))]
    suitable = [v for v in suitable if v.given is None] or suitable
    return [f"{v.name}:{quote(text)}" for v in suitable[:MOST_OF_A_UNIT]]


def right_names(name: str, values: Sequence[Value]) -> Sequence[str]:
    """Return the results, with or without a unit, that an unknown name may mean."""
    if ways := _results_in(name, values):
        return ways
    word, names = "-".join(name.lower().replace("_", " ").split()), names_of(values)
    names += [value.name for value in values if value.is_on_request]
    present = [v for v in values if not v.is_absent]
    if word in (*names, *(v.also for v in present if v.also)):
        return [word]
    known = {name: letter_of(name).replace("_", "").lower() for name in names if name in SYMBOLS}
    lettered = [name for name, letter in known.items() if letter == word.replace("_", "")]
    return (
        [*dict.fromkeys(lettered)]
        or names_meant(word, names)
        or errors.nearest(word, names)
        or _related(word, present)
    )


def _related(name: str, values: Sequence[Value]) -> list[str]:
    """Return the results whose names or labels have words like those of a name."""
    words = [word for word in name.split("-") if len(word) >= 3]
    starts = tuple([word[:LIKE] for word in words if word == name or word not in VAGUE])
    related = {
        value.name: sum(word.startswith(starts) for word in value.name.split("-"))
        for value in values
        if any(word.startswith(starts) for word in (*value.name.split("-"), *value.label.split()))
    }
    return sorted(related, key=related.__getitem__, reverse=True)[:MOST_OF_A_UNIT]


def _apart(row: Row) -> Row:
    """Return a row with the uncertainty apart from the value."""
    if not is_uncertain(row.value):
        return row
    return row._replace(value=row.value.nominal_value, uncertainty=row.value.std_dev)


def name_in(value: Value, dimension: Dimension) -> str:
    """Return the name of a result in a unit: illuminance, not irradiance, in lux."""
    place = place_of(dimension)
    if place is None or dimension in value.dimensions:
        is_luminous = "radiance" in value.name and "luminance" in value.also
        return value.also if is_luminous else value.name
    symbol = SYMBOLS.get(value.name)
    generic = symbol.generic if symbol else ""
    return symbols.specific_name(generic, place[0]) if "radiance" in generic else value.name


def of_kind(value: Value, unit: Unit) -> tuple[str, str]:
    """Return the label and the letter of a light quantity in the kind of a unit."""
    symbol, place = SYMBOLS.get(value.name), place_of(unit.dimension)
    if symbol is None or not symbol.generic or place is None:
        return value.label, value.letter
    specific = SYMBOLS[symbols.specific_name(symbol.generic, place[0])]
    return (
        specific.label,
        specific.letter if "_" in specific.letter else f"{specific.letter}_{place[0]}",
    )


def rows(values: Sequence[Value], case: str = "") -> list[Row]:
    """Return a row for each shown unit of each result.

    With several answers, each starts with its inputs.
    """
    result_rows = []
    for v in values:
        # As in `name_in`, without a call for each row.
        name = v.also if "radiance" in v.name and "luminance" in v.also else v.name
        is_given = v.given is not None
        for text in v.units:
            number = _in_shown_unit(v, text)
            row = Row(v.label, v.letter, number, text, case, name, is_given, 0.0, v.form)
            result_rows.append(row if type(number) is float else _apart(row))
    if case:
        result_rows.sort(key=lambda row: not row.given)
    return result_rows


def results_meant(name: str, values: Sequence[Value], text: str = "") -> tuple[str, str]:
    """Return the result, and its unit or '', that a symbol or a foreign name means.

    `text` is the unit or the scale that is asked for.  The result may be absent.  Both are '' if
    the name means no result, or none of that dimension.  Raises UsageError if it means several.
    """
    if name in SPECIFIC or name in SYMBOLS:
        return "", ""
    present = [value for value in values if not value.is_absent]
    found = _by_letter(name, present) or _by_name(name, present) or _by_name(name, values)
    if text:
        found = [way for way in found if _measures(*way, text)]
    if len(found) > 1:
        ways = [":".join(filter(None, way)) for way in found]
        raise UsageError(ambiguous(name), corrections(name, *ways))
    return found[0] if found else ("", "")


def _measures(name: str, unit: str, text: str) -> bool:
    """Return whether a unit of a result, '' for any, has a dimension of the unit of a text."""
    asked = measured_in(text, name)
    dimensions = [one.dimension for one in (asked, *getattr(asked, "others", ()))]
    return not unit or measured_in(unit, name).dimension in dimensions


def _by_letter(name: str, values: Sequence[Value]) -> list[tuple[str, str]]:
    """Return the results with a symbol; a letter alone is that of any kind of light."""
    typed = symbol_key(name)
    if not typed:
        return []
    if exact := [value for value in values if symbol_key(value.letter) == typed]:
        return _distinct(exact)
    if bare := [value for value in values if _bare(value.letter) == typed]:
        return _distinct(bare)
    return _of_light([q for q in QUANTITIES if symbol_key(q.symbol) == typed], values)


def _bare(letter: str) -> str:
    head, _, below = letter.partition("_")
    return symbol_key(head) if below in KIND_NAMES else ""


def _by_name(name: str, values: Sequence[Value]) -> list[tuple[str, str]]:
    """Return the results with that name in any language, or with that other word for it."""
    folded = comparable(name)
    labels = {label for label, names in LABELS.items() if folded in map(comparable, names)}
    labels |= {label_of(name)} - {""}
    if labelled := [value for value in values if value.label in labels or value.name in labels]:
        return _distinct(labelled)
    return _of_light([found.quantity for found in called(name)], values)


def _of_light(quantities: Sequence[Quantity], values: Sequence[Value]) -> list[tuple[str, str]]:
    """Return the results that are one of the quantities, in its unit; those at hand if any are."""
    found = {}
    by_name = {value.name: value for value in values}
    for quantity in quantities:
        name = quantity.name("en").replace(" ", "-")
        reading = read(resolve(quantity.unit))
        generic, kind = SPECIFIC.get(name, (name, reading.kind if reading else ""))
        if name in SPECIFIC and name in by_name:
            found[name, ""] = True
            continue
        value = by_name.get(generic)
        if value is None:
            continue
        unit = light_unit(generic, kind) if kind and not (reading and reading.axis) else ""
        own = bool(unit) and resolve(unit).dimension == value.dimensions[0]
        found[generic, "" if own else unit] = own or not unit
    return [way for way, is_own in found.items() if is_own] or list(found)


def _distinct(values: Sequence[Value]) -> list[tuple[str, str]]:
    return list(dict.fromkeys((value.name, "".join(value.units[:1])) for value in values))
