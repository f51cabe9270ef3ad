"""What stands between two different quantities, and which of the given conditions supply it.

The two quantities' facts (kind, axis of density, time, area and solid angle) are compared, and
each difference needs a condition.  Area and solid angle go together and can be bridged in several
ways: those are the rows of `WAYS`.  Where nothing given is enough, what is missing is named; a
condition without use, or one too many, is refused as well.
"""

from collections.abc import Callable, Iterable, Sequence
from typing import NamedTuple

from radcalc.conversion import geometric
from radcalc.conversion.conditions import (
    AREA,
    BAND,
    CONE,
    DISTANCE,
    LINK,
    PUPIL,
    REFLECTANCE,
    RESPONSIVITY,
    TIME,
    Conditions,
    Factor,
)
from radcalc.errors import (
    ConditionError,
    ConversionError,
    MissingCondition,
    RadcalcError,
    Unused,
    command,
    manual,
    option,
    options,
    quote,
)
from radcalc.given import Given
from radcalc.maths import any_true
from radcalc.quantities.light import (
    NONE,
    PHOTON,
    PHOTON_NAMES,
    RADIANT,
    Reading,
    coherent_text,
    describe,
    is_incident,
    read,
)
from radcalc.units.dimensions import (
    ANGLE,
    CHARGE,
    CURRENT,
    PER_TIME,
    SOLID_ANGLE,
)
from radcalc.units.table import Unit

Links = list[tuple[Factor, int]]

# ---------------------------------------------------------------------------------------------
# Area and solid angle


Supply = dict[str, Callable[[Conditions], Factor]]


class Way(NamedTuple):
    """The powers of the conditions that lead from one geometry to another.

    `supply` gives the factor of each; a way that nobody thinks of first is not suggested to
    somebody who gave nothing.
    """

    powers: dict[str, int]
    supply: Supply
    is_suggested: bool = True
    extends: bool = True  # whether it is suggested to somebody who gave a part of it
    is_tilted: bool = False  # whether the source may be seen aslant


def _area(conditions: Conditions) -> Factor:
    return geometric.area(conditions.take(AREA))


def _front_area(conditions: Conditions) -> Factor:
    factor = geometric.area(conditions.take(AREA))
    if "tilt" in conditions.given:
        return factor
    return factor._replace(assumption=f"{factor.assumption}, seen along its normal")


def _far_area(conditions: Conditions) -> Factor:
    area, given = conditions.take(AREA), conditions.given
    return geometric.far_area(area, given[DISTANCE], given.get("incidence"), given.get("tilt"))


def _aperture(conditions: Conditions) -> Factor:
    area, given = conditions.take(AREA), conditions.given
    return geometric.aperture(area, given[DISTANCE], given.get("incidence"))


def _cone(conditions: Conditions) -> Factor:
    return geometric.solid_angle(conditions.take(CONE))


def _projected_cone(conditions: Conditions) -> Factor:
    turn = conditions.use("tilt") or conditions.use("incidence")
    return geometric.projected_solid_angle(conditions.take(CONE), turn)


def _inverse_square(conditions: Conditions) -> Factor:
    return geometric.inverse_square(conditions.take(DISTANCE), conditions.use("incidence"))


def _reflector(conditions: Conditions) -> Factor:
    return geometric.reflector(conditions.take(REFLECTANCE))


def _disc(conditions: Conditions) -> Factor:
    source, distance = conditions.take(AREA), conditions.take(DISTANCE)
    return geometric.disc(source, distance, conditions.use("incidence"))


PLAIN: Supply = {AREA: _area, CONE: _cone, DISTANCE: _inverse_square, REFLECTANCE: _reflector}
AT_RADIANCE: Supply = {**PLAIN, CONE: _projected_cone}  # with a reflector the cone is the lamp's
IN_FRONT: Supply = {**PLAIN, AREA: _front_area}
FAR: Supply = {**PLAIN, AREA: _far_area}
RECEIVED: Supply = {**PLAIN, AREA: _aperture}
REFLECTED = Way({REFLECTANCE: 1}, {REFLECTANCE: lambda c: geometric.reflected(c.take(REFLECTANCE))})
DISC = Way({DISTANCE: -1}, {DISTANCE: _disc})  # of a radius or diameter, exactly

FLUX, INTENSITY, IRRADIANCE, RADIANCE = (0, 0), (0, 1), (1, 0), (1, 1)
# From the first geometry (powers of 1/area and 1/solid angle) to the second; back, the powers
# change their sign.  Of the ways that begin with what is given, the first two are suggested.
WAYS = {
    (FLUX, INTENSITY): (
        Way({CONE: -1}, PLAIN),
        Way({AREA: -1, DISTANCE: -1}, RECEIVED, False),
    ),
    (FLUX, IRRADIANCE): (
        Way({AREA: -1}, PLAIN),
        Way({CONE: -1, DISTANCE: 1}, PLAIN),
    ),
    (FLUX, RADIANCE): (
        Way({AREA: -1, REFLECTANCE: 1}, PLAIN),
        Way({AREA: -1, CONE: -1}, AT_RADIANCE),
        Way({CONE: -1, DISTANCE: 1, REFLECTANCE: 1}, PLAIN, False, False),
    ),
    (INTENSITY, IRRADIANCE): (
        Way({DISTANCE: 1}, PLAIN),
        Way({AREA: -1, CONE: 1}, PLAIN, False, False),
    ),
    (INTENSITY, RADIANCE): (
        Way({AREA: -1}, IN_FRONT, is_tilted=True),
        Way({DISTANCE: 1, REFLECTANCE: 1}, PLAIN),
        Way({AREA: -1, CONE: 1, REFLECTANCE: 1}, PLAIN, False, False),
    ),
    (IRRADIANCE, RADIANCE): (
        Way({REFLECTANCE: 1}, PLAIN),
        Way({CONE: -1}, AT_RADIANCE),
        Way({AREA: -1, DISTANCE: -1}, FAR, False, is_tilted=True),
    ),
}


def ways(start: tuple[int, int], end: tuple[int, int]) -> tuple[tuple[Way, ...], int]:
    """The ways between two geometries, and the sign of their powers in that direction."""
    if (start, end) in WAYS:
        return WAYS[start, end], 1
    return WAYS.get((end, start), ()), -1


def _space(bridge: "Bridge", start: Reading, end: Reading) -> Links:
    """Between flux, intensity, irradiance and radiance."""
    conditions = bridge.conditions
    given = {slot for slot in PLAIN if slot in conditions.given}
    here, there = start.geometry[1:], end.geometry[1:]
    if here == there:
        return _surface(bridge)
    rows, sign = ways(here, there)
    radiance = start.is_radiance or end.is_radiance
    if bridge.source.is_exitance or bridge.target.is_exitance:
        # what leaves the source's surface: nothing is on the way yet
        rows = tuple(way for way in rows if not {DISTANCE, REFLECTANCE} & set(way.powers))
    elif rows is WAYS[IRRADIANCE, RADIANCE] and _is_round(conditions, given):
        return _applied(DISC, sign, conditions)
    if {here, there} == {INTENSITY, IRRADIANCE} and given == {AREA, CONE}:
        _refuse_two_meanings(bridge, start)
    whole = [way for way in rows if given.issuperset(way.powers)]
    if len(whole) > 1:
        flags = options((conditions.given[slot].name for slot in PLAIN if slot in given), " and ")
        raise ConditionError(f"{bridge.heading}: over-specified by {flags}", "fewer of them")
    if whole and DISTANCE in given and DISTANCE not in whole[0].powers and CONE not in given:
        # a distance that finds no use beside an area: the lamp's cone is what is missing
        lamps = [way for way in rows if set(way.powers) == {CONE, DISTANCE}]
        if lamps:
            bridge.want_space(lamps, {DISTANCE})
            return []
    if whole:
        return _applied(whole[0], sign, conditions)
    if radiance and given == {DISTANCE} and any(way.supply is FAR for way in rows):
        conditions.take(DISTANCE)
        bridge.lacking["size"] = (
            "the size of the source",
            f"{option('radius', 'R')} or {option('area', 'A')}",
        )
    else:
        bridge.want_space(rows, given)
    return []


def _is_round(conditions: Conditions, given: set[str]) -> bool:
    """Whether a disc that faces the receiver is given: by its radius or diameter, from afar."""
    is_exact = given == {AREA, DISTANCE} and "tilt" not in conditions.given
    return is_exact and conditions.given[AREA].name != "area"


def _refuse_two_meanings(bridge: "Bridge", start: Reading) -> None:
    """Refuse a cone beside an area, where nothing tells what is uniform over it.

    By way of the flux it is the intensity, by way of the radiance the radiance.
    """
    area, cone = (bridge.conditions.given[slot] for slot in (AREA, CONE))
    if cone.name not in geometric.PROJECTED:
        return
    first, second = (cone, area) if start.solid_angle else (area, cone)
    by_flux = coherent_text(start._replace(area=0, solid_angle=0))
    by_radiance = coherent_text(start._replace(area=1, solid_angle=1))
    steps = [
        f"{command('convert', bridge.amount, unit, **{step.name: quote(step.text)})} "
        f"and then {option(then.name, quote(then.text))}, for a uniform {what}"
        for unit, step, then, what in (
            (by_flux, first, second, "intensity"),
            (by_radiance, second, first, "radiance"),
        )
    ]
    raise ConversionError(
        f"{bridge.heading}: over {option(cone.name, quote(cone.text))} the intensity may be "
        "uniform, or the radiance, and the answers differ",
        "; or ".join(steps),
    )


def _applied(way: Way, sign: int, conditions: Conditions) -> Links:
    """The factors of a way; nothing follows from no light."""
    links = [(way.supply[slot](conditions), power * sign) for slot, power in way.powers.items()]
    if way.is_tilted and (tilt := conditions.use("tilt")):
        links.append((geometric.turned(tilt), way.powers[AREA] * sign))
    for factor, power in links:
        if power < 0 and any_true(factor.value == 0):
            raise ConditionError(
                f"{factor.assumption}: no light arrives, so nothing follows from it",
                "a reflectance above 0, and an incidence or a tilt below 90 deg",
            )
    return links


def _incidence(bridge: "Bridge", start: Reading, end: Reading) -> Links:
    """How a surface is turned that a given irradiance lights: E cos(theta) reaches it."""
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
# What is missing

KIND, AXIS, PER_LENGTH, PROJECTED = "kind", "axis", "per length", "projected solid angle"
_WAVELENGTH = option("wavelength", "LAMBDA")
_CONE = option("half-angle", "ANGLE")
# What is missing, and the symbols that supply it.
WANTED = {
    KIND: (
        "a wavelength, a spectrum or an efficacy",
        f"{_WAVELENGTH}, {option('spectrum', 'SOURCE')} or {option('efficacy', 'RATIO')}",
    ),
    AXIS: ("a wavelength", _WAVELENGTH),
    PER_LENGTH: (
        "a length",
        f"the number times that length ({option('bandwidth')} is for densities written with nm, "
        "um, angstrom)",
    ),
    BAND: ("a bandwidth", option("bandwidth", "WIDTH")),
    TIME: ("a time", option("time", "T")),
    PUPIL: ("the pupil's diameter", option("pupil", "DIAMETER")),
    RESPONSIVITY: ("the detector's responsivity", option("responsivity", "S")),
    AREA: ("an area", option("area", "A")),
    CONE: (
        "a solid angle",
        f"{option('isotropic')}, {_CONE} or {option('solid-angle', 'OMEGA')}",
    ),
    PROJECTED: ("a projected solid angle", f"{_CONE} or {option('hemisphere')}"),
    DISTANCE: ("a distance", option("distance", "D")),
    REFLECTANCE: ("a reflectance", option("reflectance", "RHO")),
}


class Bridge:
    """Two units of different quantities, the conditions between them, and what is lacking."""

    def __init__(
        self, source: Unit, target: Unit, given: Sequence[Given], number: str = "1"
    ) -> None:
        self.source, self.target = source, target
        self.number, self.amount = number, f"{number}{quote(source.text)}"
        self.conditions = Conditions(given)
        self.lacking: dict[str, tuple[str, str]] = {}

    @property
    def heading(self) -> str:
        return f"cannot convert {describe(self.source)} to {describe(self.target)}"

    def want(self, what: str) -> None:
        """Note that something is missing."""
        self.lacking[what] = WANTED[what]

    def want_space(self, rows: Iterable[Way], given: set[str]) -> None:
        """Note which spatial conditions are missing beside those given: two ways at most."""
        rows = tuple(rows)
        extending = [way for way in rows if way.extends and given and given < set(way.powers)]
        sensible = [way for way in rows if way.is_suggested] or list(rows)
        alternatives: dict[str, str] = {}
        for way in (extending or sensible)[:2]:
            self.conditions.used |= given & set(way.powers)
            wanted = [
                PROJECTED if slot == CONE and way.supply is AT_RADIANCE else slot
                for slot in PLAIN
                if slot in way.powers and slot not in given
            ]
            phrases, hints = zip(*(WANTED[slot] for slot in wanted), strict=True)
            alternatives[" and ".join(phrases)] = " with ".join(hints)
        plain = all(" and " not in phrase for phrase in alternatives)
        phrase = (" or " if plain else ", or ").join(alternatives)
        self.lacking["space"] = (phrase, ", or ".join(alternatives.values()))

    def refuse(self) -> None:
        """Refuse what is missing, and what has no use."""
        unused = self.conditions.unused
        if AXIS in self.lacking:
            self.lacking.pop(KIND, None)  # a wavelength supplies both
        if self.lacking:
            raise self._missing(unused)
        if unused:
            between = f"in converting {describe(self.source)} to {describe(self.target)}"
            raise Unused(unused, between, self._instead(unused))

    def _instead(self, unused: Sequence[str]) -> str:
        """What is meant by a condition that has no use between two units of one quantity."""
        start, end = read(self.source), read(self.target)
        if start is None or end is None or start != end or len(self.conditions.given) > 1:
            return ""
        given = next(one for one in self.conditions.given.values() if one.name == unused[0])
        if given.name == "reflectance" and start.area and not start.solid_angle:
            number = f"{self.number}*{given.value:.12g}"
            again = command("convert", number, quote(self.source.text), quote(self.target.text))
            return f"{again}, which is the part that is reflected"
        if given.name == TIME and not start.time:
            slow = self.source.text.endswith(SLOW) and not self.target.text.endswith(SLOW)
            rate = self.source if slow else self.target
            whole = _over_time(rate, end)
            return f"{whole} in place of {quote(rate.text)}, for all of that time"
        return ""

    def _missing(self, unused: Sequence[str]) -> MissingCondition:
        phrases, hints = zip(*self.lacking.values(), strict=True)
        several = len(phrases) > 1
        listed = several and any(" or " in phrase for phrase in phrases)
        comma = "," if listed or any(", or " in phrase for phrase in phrases) else ""
        message = (
            f"{self.heading}: {f'{comma} and '.join(phrases)}{comma} "
            f"{'are' if several or _is_plural(phrases[0]) else 'is'} missing"
        )
        if unused:
            useless = options(unused, " and ")
            message += f"; {useless} {'has' if len(unused) == 1 else 'have'} no use"
        hint = f"{'; and '.join(hints)} (see {manual('convert')})"
        return MissingCondition(message, hint, self.source.text, self.target.text, phrases)


def _is_plural(phrase: str) -> bool:
    """Whether it is `an area and a solid angle`, and nothing else would do."""
    return " and " in phrase and " or " not in phrase


SLOW = ("/min", "/h", "/hour", "/d", "/day")  # of an amount that comes in within that time


def _over_time(unit: Unit, reading: Reading) -> str:
    """The unit of what a rate gives in a time: mol/m2 of mol/m2/day, lm.s of lm."""
    rates = ("/s", *SLOW) if reading.kind == PHOTON else SLOW
    for rate in rates:
        if unit.text.endswith(rate):
            return quote(unit.text.removesuffix(rate))
    return coherent_text(reading._replace(time=1)).replace(" ", ".")


# ---------------------------------------------------------------------------------------------
# Everything between two quantities


def link(source: Unit, target: Unit, given: Sequence[Given], number: str = "1") -> Links:
    """Find the factors, with their powers, that turn the source's quantity into the target's."""
    bridge = Bridge(source, target, given, number)
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
    return links


def _surface(bridge: Bridge) -> Links:
    """Between what arrives at a surface and what leaves it."""
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
    """Between the widths of one narrow band in wavelength, frequency and wavenumber."""
    given = bridge.conditions.given.get(LINK)
    if given is not None and given.name == "wavelength":
        from radcalc.conversion import spectral

        factor = spectral.width(bridge, given)
        if factor is not None:
            return [(factor, -1)]
    raise _unlike(bridge)


def _unlike(bridge: Bridge) -> RadcalcError:
    """Refuse two quantities of which one is no light quantity: no condition links them."""
    source, target, heading = bridge.source, bridge.target, bridge.heading
    if PER_TIME in (source.dimension, target.dimension):
        hint = "Hz, or cycle/s, for a frequency"
        if source.dimension == PER_TIME:
            per = source.text.removeprefix("1")
            cycles = f"cycle{per}" if per.startswith("/") else f"cycle.{source.text}"
            hint = command("convert", f"{bridge.number} {quote(cycles)}", quote(target.text))
        return ConversionError(f"{heading}: a frequency counts cycles", hint)
    if source.dimension in PHOTON_NAMES and target.dimension in PHOTON_NAMES:
        return ConversionError(
            f"{heading}: no condition links them, but a photon has both",
            command(
                "photon",
                bridge.amount,
                get=f"{PHOTON_NAMES[target.dimension]}:{quote(target.text)}",
            ),
        )
    if {source.dimension, target.dimension} == {ANGLE, SOLID_ANGLE}:
        name = "half-angle" if source.dimension == ANGLE else "solid-angle"
        return ConversionError(
            f"{heading}: no condition links them, a solid angle depends on the shape",
            command("solid-angle", "cone", **{name: bridge.amount}),
        )
    hint = f"{command('units', 'UNIT')}, which shows what a unit measures"
    if notes := source.notes + target.notes:
        hint = "; ".join(notes)
    elif target.atoms and all(power < 0 for _, power in target.atoms):
        both = f"{source.text} {target.text}"
        hint = f"quotes around '{quote(both)}', if that is one unit"
    return ConversionError(
        f"{heading}: they are different quantities, and no condition links them", hint
    )


def _time(bridge: Bridge, start: Reading, end: Reading) -> Links:
    """Between energy and flux, exposure and irradiance."""
    if start.time == end.time:
        return []
    given = bridge.conditions.use(TIME)
    if given is None:
        bridge.want(TIME)
        return []
    return [(geometric.duration(given), end.time - start.time)]


ELECTRIC = {CURRENT: 0, CHARGE: 1}  # with the power of time beside that of a flux


def _behind_detector(unit: Unit) -> Reading | None:
    """The facts of a light quantity; of a current those of the flux that makes it."""
    if unit.dimension in ELECTRIC:
        return Reading(RADIANT, ELECTRIC[unit.dimension], 0, 0, NONE)
    return read(unit)


def _detector(bridge: Bridge) -> Links:
    """Between the light on a detector and the current that it gives."""
    from_current = bridge.source.dimension in ELECTRIC
    if from_current == (bridge.target.dimension in ELECTRIC):
        return []
    given = bridge.conditions.use(RESPONSIVITY)
    if given is None:
        bridge.want(RESPONSIVITY)
        return []
    factor = geometric.responsivity(given)
    link = bridge.conditions.given.get(LINK)
    if link and link.name == "wavelength":
        from radcalc.conversion import spectral

        energy = spectral.light(link, None).photon_energy
        factor = factor._replace(notes=geometric.yield_of(given.value, energy))
    return [(factor, -1 if from_current else 1)]


def _pupil(bridge: Bridge, start: Reading, end: Reading) -> Links:
    """Between luminance and trolands."""
    if start.retinal == end.retinal:
        return []
    given = bridge.conditions.use(PUPIL)
    if given is None:
        bridge.want(PUPIL)
        return []
    return [(geometric.pupil(given), 1 if end.retinal else -1)]
