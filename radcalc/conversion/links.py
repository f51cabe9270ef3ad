"""The links between two different quantities, and the given conditions that supply them.

Each difference between the quantities in kind, axis of density, time, area and solid angle needs a
condition.  Area and solid angle are linked together, in one of the ways of `WAYS`.
"""

import math
from collections.abc import Sequence
from typing import Any

from radcalc import errors
from radcalc.conversion import geometric
from radcalc.conversion.bridge import Bridge, Links, Wanted
from radcalc.conversion.geometric import (
    AREA,
    CONE,
    DISC,
    DISTANCE,
    FAR,
    FLUX,
    INTENSITY,
    IRRADIANCE,
    LINK,
    PLAIN,
    PUPIL,
    RADIANCE,
    REFLECTANCE,
    REFLECTED,
    RESPONSIVITY,
    TIME,
    WAYS,
    Conditions,
    Way,
    slot_of,
    ways_between,
)
from radcalc.errors import command, option, quote
from radcalc.inputs import Input, require
from radcalc.maths import any_true, power
from radcalc.quantities import (
    LUMINOUS,
    NONE,
    PHOTON,
    PHOTON_NAMES,
    RADIANT,
    RATIOS,
    Reading,
    coherent_text,
    is_incident,
    read,
)
from radcalc.quantities.symbols import SYMBOLS
from radcalc.units import Daily, Unit, dimensions

# The efficacies of lamps, and the light of each watt.
OF_LAMPS = {RATIOS[LUMINOUS, RADIANT]: "lm", RATIOS[PHOTON, RADIANT]: "umol/s"}

# ---------------------------------------------------------------------------------------------
# Area and solid angle


def _space(bridge: "Bridge", start: Reading, end: Reading) -> Links:
    """Return the factors between area and solid angle, or none and add missing conditions."""
    conditions = bridge.conditions
    given = {slot for slot in PLAIN if slot in conditions.given}
    here, there = start.geometry[1:], end.geometry[1:]
    if here == there:
        return _surface(bridge)
    ways, sign = ways_between(here, there)
    if bridge.source.is_exitance or bridge.target.is_exitance:
        # exitance: no light has left the surface yet, so there is no distance
        ways = tuple(way for way in ways if not {DISTANCE, REFLECTANCE} & set(way.powers))
    elif ways is WAYS[IRRADIANCE, RADIANCE] and _is_round(conditions, given):
        return _applied(DISC, sign, conditions)
    if {here, there} == {INTENSITY, IRRADIANCE} and given == {AREA, CONE}:
        _refuse_two_meanings(bridge, start)
    complete = [way for way in ways if given.issuperset(way.powers)]
    if len(complete) > 1:
        _compare_ways(conditions, complete, (here, there) if sign > 0 else (there, here))
    if not complete:
        _want_space(bridge, ways, given, start.is_radiance or end.is_radiance)
        return []
    if DISTANCE in given and DISTANCE not in complete[0].powers and CONE not in given:
        # no way uses the distance: the solid angle of the lamp is missing
        lamps = [way for way in ways if set(way.powers) == {CONE, DISTANCE}]
        if lamps:
            bridge.want_space(lamps, {DISTANCE})
            return []
    return _applied(complete[0], sign, conditions)


def _compare_ways(
    conditions: Conditions,
    ways: Sequence[Way],
    between: tuple[tuple[int, int], tuple[int, int]],
) -> None:
    """Refuse conditions that lead to a quantity in two ways with different results."""
    from radcalc.conversion.agreement import Said, compare

    def said(way: Way) -> Said:
        slots = [slot for slot in PLAIN if slot in way.powers]

        def factor(given: Sequence[Input]) -> Any:
            moved = conditions.with_others(dict(zip(slots, given, strict=True)))
            factors = [power(way.supply[n](moved).value, p) for n, p in way.powers.items()]
            return math.prod(factors)

        return Said([conditions.given[slot] for slot in slots], factor)

    powers = [end - start for start, end in zip(*between, strict=True)]
    over, under = (
        ".".join([name for name, of in zip(("m2", "sr"), powers, strict=True) if of == sign])
        for sign in (-1, 1)
    )
    first, *others = map(said, ways)
    for other in others:
        conditions.notes += compare(first, other, f"{over}/{under}".removesuffix("/"))
    conditions.used.update(slot for way in ways for slot in way.powers)


def _want_space(bridge: "Bridge", ways: Sequence[Way], given: set[str], is_radiance: bool) -> None:
    if is_radiance and given == {DISTANCE} and any(way.supply is FAR for way in ways):
        bridge.conditions.take(DISTANCE)
        bridge.lacking["size"] = Wanted(
            "the size of the source",
            f"{option('radius', 'R')} or {option('area', 'A')}",
            (errors.add("radius", "10cm", "a round source"),),
        )
    else:
        bridge.want_space(ways, given)


def _is_round(conditions: Conditions, given: set[str]) -> bool:
    """Return whether a distant disc that faces the receiver is given by radius or diameter."""
    is_exact = given == {AREA, DISTANCE} and "tilt" not in conditions.given
    return is_exact and conditions.given[AREA].name != "area"


def _refuse_two_meanings(bridge: "Bridge", start: Reading) -> None:
    """Raise for a cone with an area, if it is unclear what is uniform over the cone.

    Via the flux it is the intensity, via the radiance it is the radiance.
    """
    area, cone = (bridge.conditions.given[slot] for slot in (AREA, CONE))
    if cone.name not in geometric.PROJECTED:
        return
    first, second = (cone, area) if start.solid_angle else (area, cone)
    by_flux = coherent_text(start._replace(area=0, solid_angle=0))
    by_radiance = coherent_text(start._replace(area=1, solid_angle=1))
    steps = [
        errors.call(
            *("convert", bridge.amount, unit),
            **{step.name: quote(step.text)},
            remark=f"and then {option(then.name, quote(then.text))}, for a uniform {what}",
        )
        for unit, step, then, what in (
            (by_flux, first, second, "intensity"),
            (by_radiance, second, first, "radiance"),
        )
    ]
    raise errors.ConversionError(
        f"{bridge.heading}: over {option(cone.name, quote(cone.text))} either the intensity or "
        "the radiance may be uniform, and the answers differ",
        steps,
    )


def _applied(way: Way, sign: int, conditions: Conditions) -> Links:
    """Return the factors of a way; raise if one of them makes the light 0."""
    links = [(way.supply[slot](conditions), power * sign) for slot, power in way.powers.items()]
    if way.is_tilted and (tilt := conditions.use("tilt")):
        links.append((geometric.turned(tilt), way.powers[AREA] * sign))
    for factor, exponent in links:
        if exponent < 0 and any_true(factor.value == 0):
            raise errors.ConditionError(
                f"{factor.assumption}: no light arrives, so the source cannot be determined",
                "a reflectance above 0, and an incidence or a tilt below 90 deg",
                [
                    errors.leave_out(name)
                    for name in ("incidence", "tilt")
                    if name in conditions.given
                ],
            )
    return links


def _incidence(bridge: "Bridge", start: Reading, end: Reading) -> Links:
    """Return the factor cos(theta) of a surface at an angle to a given irradiance."""
    conditions = bridge.conditions
    if "incidence" not in conditions.given or DISTANCE in conditions.given:
        return []
    if start.geometry[1:] != IRRADIANCE or bridge.source.is_exitance:
        return []
    here = end.geometry[1:]
    reflects = REFLECTANCE in conditions.used
    is_lit = here == FLUX or (here == RADIANCE and reflects)
    if is_lit or (here == IRRADIANCE and bridge.target.is_exitance == reflects):
        return [(geometric.turned(conditions.take("incidence")), 1)]
    return []


# ---------------------------------------------------------------------------------------------
# Everything between two quantities


def link(source: Unit, target: Unit, given: Sequence[Input], number: str = "1") -> Links:
    """Return the factors, with their powers, from the source's quantity to the target's."""
    notes: tuple[str, ...] = ()
    if len({slot_of(item.name) for item in given}) < len(given):
        from radcalc.conversion.agreement import agreed

        given, notes = agreed(given)
    bridge = Bridge(source, target, Conditions(given, notes), number)
    start, end = _behind_detector(source), _behind_detector(target)
    links: Links = []
    if source.dimension == target.dimension:
        links += _surface(bridge)
        if start and end:
            links += _incidence(bridge, start, end)
    elif start is None or end is None:
        links += _width(bridge)
    else:
        if (start.kind, start.axis) != (end.kind, end.axis):
            from radcalc.conversion import spectral  # with the tables of the observers

            links += spectral.between(bridge, start, end)
        links += _time(bridge, start, end)
        links += _pupil(bridge, start, end)
        links += _detector(bridge)
        links += _space(bridge, start, end)
        links += _incidence(bridge, start, end)
    bridge.refuse()
    if notes := bridge.conditions.notes:
        (factor, power), *others = links
        links = [(factor._replace(notes=(*factor.notes, *notes)), power), *others]
    return links


def _surface(bridge: Bridge) -> Links:
    """Return the link between the light incident on a surface and the light leaving it."""
    units = (bridge.source, bridge.target)
    arriving = [unit for unit in units if not unit.is_exitance]
    if len(arriving) != 1:
        return []
    if REFLECTANCE in bridge.conditions.given:
        return _applied(REFLECTED, 1 if bridge.target.is_exitance else -1, bridge.conditions)
    if is_incident(arriving[0]):
        bridge.want(REFLECTANCE)
    return []


def _width(bridge: Bridge) -> Links:
    """Return the link between widths of a narrow band in wavelength, frequency and wavenumber."""
    given = bridge.conditions.given.get(LINK)
    if given is not None and given.name == "wavelength":
        from radcalc.conversion import spectral

        factor = spectral.width(bridge, given)
        if factor is not None:
            return [(factor, -1)]
    raise _unlike(bridge)


def _unlike(bridge: Bridge) -> errors.RadcalcError:
    """Return the error for two quantities that no condition links, with a hint for their kind."""
    source, target, heading = bridge.source, bridge.target, bridge.heading
    if any(unit.dimension == dimensions.PER_TIME and not read(unit) for unit in (source, target)):
        return _unlike_cycles(bridge)
    if source.dimension in PHOTON_NAMES and target.dimension in PHOTON_NAMES:
        return errors.ConversionError(
            f"{heading}: no condition links them, but a photon has both",
            errors.call(
                "photon",
                bridge.amount,
                get=f"{PHOTON_NAMES[target.dimension]}:{quote(target.text)}",
            ),
        )
    if source.dimension in PHOTON_NAMES and target.dimension == RATIOS[LUMINOUS, RADIANT]:
        return errors.ConversionError(
            f"{heading}: no condition links them, but light of one wavelength has an efficacy",
            errors.call("photon", bridge.amount, get=f"luminous-efficacy:{quote(target.text)}"),
        )
    if source.dimension in OF_LAMPS and target.dimension in OF_LAMPS:
        given = bridge.conditions.given.get(slot_of("spectrum"))
        spectrum = given.text if given and given.name == "spectrum" else "LED-B3"
        light = errors.call(
            "convert", f"{bridge.amount}*1W", OF_LAMPS[target.dimension], spectrum=spectrum,
            remark="of each watt",
        )  # fmt: skip
        return errors.ConversionError(
            f"{heading}: no condition links them, but a spectrum links the light", light
        )
    if dimensions.TEMPERATURE in (source.dimension, target.dimension):
        return _unlike_heat(bridge)
    if {source.dimension, target.dimension} == {dimensions.ANGLE, dimensions.SOLID_ANGLE}:
        names = (
            ("apex-angle", "half-angle")
            if source.dimension == dimensions.ANGLE
            else ("solid-angle",)
        )
        return errors.ConversionError(
            f"{heading}: no condition links them, since a solid angle depends on the shape",
            [errors.call("solid-angle", "cone", **{name: bridge.amount}) for name in names],
        )
    hint = f"{command('units', 'UNIT')}, which shows what a unit measures"
    if notes := source.notes + target.notes:
        hint = "; ".join(notes)
    elif target.atoms and all(power < 0 for _, power in target.atoms):
        both = f"{source.text} {target.text}"
        hint = f"quotes around '{quote(both)}', if that is one unit"
    return errors.ConversionError(
        f"{heading}: they are different quantities, and no condition links them", hint
    )


def _unlike_cycles(bridge: Bridge) -> errors.RadcalcError:
    """Return the error for a frequency and a rate without cycles, such as 3/s."""
    source, target = bridge.source, bridge.target
    hint: errors.Hint = "Hz, or cycle/s, for a frequency"
    if source.dimension == dimensions.PER_TIME:
        per = source.text.removeprefix("1")
        cycles = f"cycle{per}" if per.startswith("/") else f"cycle.{source.text}"
        amount = f"{bridge.number} {quote(cycles)}"
        hint = errors.computed(errors.call("convert", amount, quote(target.text)))
    return errors.ConversionError(f"{bridge.heading}: a frequency counts cycles", hint)


def _unlike_heat(bridge: Bridge) -> errors.RadcalcError:
    """Return the error for a temperature and what a hot body does not determine in one number."""
    source, target = bridge.source, bridge.target
    hint: errors.Hint = "W/m2 or W/m2/sr of a black body, or um for the peak of its spectrum"
    if source.dimension == dimensions.LENGTH:
        hint = "a wavelength in nm or um, for the peak of a black body's spectrum"
    elif target.dimension == dimensions.LENGTH:
        hint = errors.correct(target.text, "um", remark="for the peak of a black body's spectrum")
    elif source.dimension == dimensions.TEMPERATURE and target.is_light:
        hint = errors.call("spectrum", f"blackbody:{bridge.amount}")
    what = "but a black body of a temperature has an exitance, a radiance and a peak wavelength"
    message = f"{bridge.heading}: no condition links them, {what}"
    return errors.ConversionError(message, hint)


def _time(bridge: Bridge, start: Reading, end: Reading) -> Links:
    if start.time == end.time:
        return []
    units = bridge.source, bridge.target
    given = bridge.conditions.use(TIME)
    is_daily = any(isinstance(unit, Daily) for unit in units)
    if is_daily and given is None and any(("day", -1) in unit.atoms for unit in units):
        return [(geometric.DAY, end.time - start.time)]
    if given is None:
        bridge.want("photoperiod" if is_daily else TIME)
        return []
    if is_daily:
        limits = SYMBOLS["photoperiod"].limits
        require(given, not any_true(given.value > limits.high), limits.said)
    return [(geometric.duration(given, is_daily), end.time - start.time)]


ELECTRIC = {
    dimensions.CURRENT: 0,
    dimensions.CHARGE: 1,
}  # with the power of time relative to a flux


def _behind_detector(unit: Unit) -> Reading | None:
    """Return the facts of a light quantity; for a current those of the flux that causes it."""
    if unit.dimension in ELECTRIC:
        return Reading(RADIANT, ELECTRIC[unit.dimension], 0, 0, NONE)
    return read(unit)


def _detector(bridge: Bridge) -> Links:
    """Return the link by a responsivity if only one of the quantities is electric."""
    from_current = bridge.source.dimension in ELECTRIC
    if from_current == (bridge.target.dimension in ELECTRIC):
        return []
    given = bridge.conditions.use(RESPONSIVITY)
    if given is None:
        bridge.want(RESPONSIVITY)
        return []
    link = bridge.conditions.given.get(LINK)
    if given.name == "response":
        from radcalc.conversion import spectral

        return [(spectral.response(bridge, given), -1 if from_current else 1)]
    factor = geometric.responsivity(given)
    if link and link.name == "wavelength":
        from radcalc.conversion import spectral

        energy = spectral.light(link).photon_energy
        factor = factor._replace(notes=geometric.yield_of(given.value, energy))
    return [(factor, -1 if from_current else 1)]


def _pupil(bridge: Bridge, start: Reading, end: Reading) -> Links:
    if start.retinal == end.retinal:
        return []
    given = bridge.conditions.use(PUPIL)
    if given is None:
        bridge.want(PUPIL)
        return []
    return [(geometric.pupil(given), 1 if end.retinal else -1)]
