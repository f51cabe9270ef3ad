"""Conditions of a conversion, and the factors of those of geometry and time.

A condition is a symbol that can be given, and its slot; the ways lead from one geometry to another.
"""

import math
from collections.abc import Callable, Sequence
from typing import Any

from radcalc import geometry, maths
from radcalc.answer import Formula, Step, format_angle, format_number
from radcalc.errors import ConditionError, Hint, HorizonCuts, TooNear, Try, add, option, quote
from radcalc.inputs import Input, half_angle_of, radius_of, require
from radcalc.tuples import NamedTuple
from radcalc.units.table import resolve

# Slots of conditions; two conditions in one slot are compared.
LINK, TIME, AREA, CONE, DISTANCE = "link of kinds", "time", "area", "solid angle", "distance"
BAND, REFLECTANCE, PUPIL = "bandwidth", "reflectance", "pupil"
RESPONSIVITY = "responsivity"
REFINES = "refines"  # a condition that refines another one has its own slot

CONDITIONS = {
    "wavelength": LINK,
    "spectrum": LINK,
    "efficacy": LINK,
    "observer": REFINES,
    "range": REFINES,
    "photon-range": REFINES,
    "weight": REFINES,
    "filter": REFINES,
    "dark-outside": REFINES,
    "time": TIME,
    "photoperiod": TIME,
    "area": AREA,
    "radius": AREA,
    "diameter": AREA,
    "solid-angle": CONE,
    "half-angle": CONE,
    "apex-angle": CONE,
    "isotropic": CONE,
    "hemisphere": CONE,
    "exponent": CONE,
    "beam-angle": CONE,
    "distance": DISTANCE,
    "incidence": REFINES,
    "tilt": REFINES,
    "bandwidth": BAND,
    "reflectance": REFLECTANCE,
    "pupil": PUPIL,
    "responsivity": RESPONSIVITY,
    "response": RESPONSIVITY,
    "electric-field": REFINES,
    "emissivity": REFINES,
    "k": REFINES,
    "c": REFINES,
}


class Factor(NamedTuple):
    """A factor or divisor of a quantity, with its letter.

    `check` raises for numbers in the source's unit that it does not convert.
    """

    letter: str
    value: Any
    unit: str
    assumption: str
    steps: tuple[Step, ...] = ()
    notes: tuple[str, ...] = ()
    check: Callable[[Any], None] | None = None


def slot_of(name: str) -> str:
    """Return the slot of a condition."""
    slot = CONDITIONS[name]
    return name if slot == REFINES else slot


class Conditions:
    """The given conditions by slot, one in each, and the slots in use."""

    __slots__ = ("given", "notes", "used")

    def __init__(self, given: Sequence[Input], notes: tuple[str, ...] = ()) -> None:
        self.given: dict[str, Input] = {slot_of(item.name): item for item in given}
        self.notes = notes
        self.used: set[str] = set()

    def with_others(self, others: dict[str, Input]) -> "Conditions":
        """Return conditions with other inputs in some slots."""
        conditions = Conditions(())
        conditions.given = {**self.given, **others}
        return conditions

    def use(self, slot: str) -> Input | None:
        """Return a condition, or None, and mark it as used."""
        if slot in self.given:
            self.used.add(slot)
        return self.given.get(slot)

    def take(self, slot: str) -> Input:
        self.used.add(slot)
        return self.given[slot]

    @property
    def unused(self) -> list[str]:
        return [condition.name for slot, condition in self.given.items() if slot not in self.used]


INVERSE_SQUARE = Formula(
    "inverse square law", "q = Omega0 / {distance}^2", "ISO 80000-7, intensity and irradiance"
)
ASLANT = INVERSE_SQUARE._replace(template="q = cos({incidence}) Omega0 / {distance}^2")
REFLECTOR = Formula(
    "Lambertian reflector",
    "r = {reflectance} / (pi Omega0)",
    "ISO 80000-7, luminance and reflectance",
)
REFLECTED_LIGHT = Formula(
    "reflected light", "{exitance} = {reflectance} {irradiance}", "ISO 80000-7, reflectance"
)
SLANTING_CONE = Formula(
    "cone aslant to a surface",
    "{projected-solid-angle} = integral of cos(theta) over the cone's part above the surface",
)
RETINA = Formula("retinal illuminance", "p = pi/4 {pupil}^2")


def area(given: Input) -> Factor:
    """Return the area of a source or a receiver [m2]."""
    if given.name == "area":
        return Factor("A", given.value, "m2", f"uniform over {given.text}")
    from radcalc.laws import CIRCLE

    radius = radius_of(given)
    value = CIRCLE.solve("area", lambda _: radius)
    area_text = f"{format_number(value)} m2"
    step = CIRCLE.formula.step({"radius": radius}, area_text)
    return Factor("A", value, "m2", f"uniform over a circle of {area_text}", (step,))


DAY = Factor("t", 86400.0, "s", "the rate is the mean of a day, over 24 h")


def duration(given: Input, is_daily: bool = False) -> Factor:
    """Return the factor of a time [s], or of the light in a day."""
    text = f"constant over {given.text}"
    if is_daily or given.name == "photoperiod":
        text = f"in a day with {given.text} of light, all of it constant"
    return Factor("t", given.value, "s", text)


def solid_angle(given: Input) -> Factor:
    """Return the solid angle between flux and intensity [sr]."""
    if given.name == "isotropic":
        return Factor("Omega", geometry.FULL, "sr", "uniform over 4 pi sr (isotropic)")
    if given.name == "hemisphere":
        return Factor("Omega", geometry.HEMISPHERE, "sr", "uniform over 2 pi sr (a hemisphere)")
    if given.name == "solid-angle":
        return Factor("Omega", given.value, "sr", f"uniform over {given.text}")
    if given.name in ("exponent", "beam-angle"):
        return _lobe(given)
    from radcalc.laws import CONE

    half = half_angle_of(given)
    omega = geometry.cone(half)
    omega_text = f"{format_number(omega)} sr"
    step = CONE.formula.step({"half-angle": half}, omega_text)
    assumption = f"uniform over a cone of half angle {format_angle(half)}, {omega_text}"
    return Factor("Omega", omega, "sr", assumption, (step,))


def _lobe(given: Input) -> Factor:
    """Return the solid angle of a cosine-power lobe: its flux over its peak intensity [sr]."""
    from radcalc.laws.point import BEAM_ANGLE, LOBE

    exponent = given.value
    steps: tuple[Step, ...] = ()
    if given.name == "beam-angle":
        exponent = geometry.lobe_exponent(given.value, 0.5)
        steps = (BEAM_ANGLE.formula.step({"beam-angle": given.value}, format_number(exponent)),)
    omega = geometry.lobe(exponent)
    step = LOBE.formula.step({"exponent": exponent}, f"{format_number(omega)} sr")
    assumption = f"intensity I0 cos^n(theta) with n = {format_number(exponent)}; I0 is the peak"
    return Factor("Omega", omega, "sr", assumption, (*steps, step))


PROJECTED = ("half-angle", "apex-angle", "hemisphere")  # cones with a projected solid angle


def projected_solid_angle(given: Input, turn: Input | None) -> Factor:
    """Return the projected solid angle between radiance and irradiance, exitance or flux [sr].

    The projection is onto the surface with the cone's axis as normal, or `turn` away from it.
    """
    if turn and given.name in (*PROJECTED, "solid-angle"):
        return _slanting(given, turn)
    if given.name == "hemisphere":
        return Factor("Omega_p", math.pi, "sr", "uniform over a hemisphere, pi sr projected")
    if given.name not in PROJECTED:
        hint = [
            Try((("hemisphere", ""),), (given.name,)),
            Try((("half-angle", "30deg"),), (given.name,)),
        ]
        if given.name == "solid-angle":
            hint.append(add("tilt", "0deg", "a small source in the direction of the normal"))
        raise ConditionError(
            f"{option(given.name)} does not link a radiance: it needs the projected solid angle",
            hint,
        )
    from radcalc.laws import PROJECTED_CONE

    half = _half_angle_at_most_right(given)
    omega = geometry.projected_cone(half)
    omega_text = f"{format_number(omega)} sr"
    step = PROJECTED_CONE.formula.step({"half-angle": half}, omega_text)
    assumption = f"uniform over a cone of half angle {format_angle(half)} about the normal"
    return Factor("Omega_p", omega, "sr", f"{assumption}, {omega_text} projected", (step,))


def _half_angle_at_most_right(given: Input) -> Any:
    half = half_angle_of(given)
    most = "90" if given.name == "half-angle" else "180"
    within = not maths.any_true(half > math.pi / 2 * (1 + maths.SLACK))
    require(given, within, f"at most {most} deg, for a radiance")
    return half


NARROW = math.atan(0.1)  # half angle of a disc seen from five times its diameter


def _slanting(given: Input, turn: Input) -> Factor:
    """Return the projected solid angle of an oblique cone or of a small solid angle [sr]."""
    from radcalc.geometry import solid

    angle, where = abs(turn.value), f"{turn.text} from the normal"
    if given.name == "solid-angle":
        cosine, _, notes = _cosine(turn)
        half = geometry.cone_of(given.value)
        if maths.any_true(half > NARROW * (1 + maths.SLACK)):
            size = "ANGLE" if maths.is_array(half) else f"{half * (180 / math.pi):.6g}deg"
            raise ConditionError(
                f"{option('solid-angle', quote(given.text))} is too large for one "
                f"{option(turn.name)}: its directions are at different angles to the normal",
                Try((("half-angle", size),), ("solid-angle",), remark="a cone", follow=True),
            )
        omega = given.value * cosine
        good = geometry.percent(maths.square(maths.tan(half / 2)))
        assumption = f"a small solid angle of {given.text}, {where} (Omega cos(theta) {good})"
        formula = Formula("small solid angle", "{projected-solid-angle} = {solid-angle} cos(theta)")
        step = formula.step({"solid-angle": given.value}, f"{format_number(omega)} sr")
        return Factor("Omega_p", omega, "sr", assumption, (step,), notes)
    half = math.pi / 2 if given.name == "hemisphere" else _half_angle_at_most_right(given)
    omega = solid.projected_cone(half, angle)
    omega_text = f"{format_number(omega)} sr"
    assumption = f"uniform over a cone of half angle {format_angle(half)}, its axis {where}"
    notes = ()
    if maths.any_true(half + angle > math.pi / 2 * (1 + maths.SLACK)):
        tilt = option(turn.name, quote(turn.text))
        cut = "a part" if maths.any_true(omega > 0) else "all"
        notes = (f"{tilt}: {cut} of the cone is behind the surface and does not count",)
    step = SLANTING_CONE.with_numbers(f"Omega_p = {omega_text}")
    return Factor("Omega_p", omega, "sr", f"{assumption}, {omega_text} projected", (step,), notes)


def turned(turn: Input) -> Factor:
    """Return the cosine of the incidence on a surface, or of the tilt of a luminous surface."""
    cosine, assumption, notes = _cosine(turn)
    letter = "cos(theta)"
    if turn.name == "incidence":
        assumption = f"the given irradiance is perpendicular to the light; {assumption}"
    else:
        letter, assumption = "cos(theta_s)", f"seen {turn.text} from its normal"
    step = Step(f"cosine of the {turn.name}", "", f"{letter} = {format_number(cosine)}")
    return Factor(letter, cosine, "", assumption, (step,), notes)


def aperture(given: Input, distance: Input, incidence: Input | None) -> Factor:
    """Return an area lit by a distant small source [m2]; raise if it is too near."""
    factor = area(given)
    size = geometry.size(factor.value)
    if geometry.is_near(distance.value, size):
        hint: Hint = geometry.MORE_ROOM
        if incidence is None and not maths.is_array(size) and not maths.is_array(distance.value):
            half = math.degrees(math.atan(size / 2 / distance.value))
            hint = Try(
                (("half-angle", f"{half:.6g}deg"),),
                (given.name, "distance"),
                remark="exact for a round receiver",
                follow=True,
            )
        distance_text = option("distance", quote(distance.text))
        raise TooNear(distance_text, "receiver", format_number(size), hint, "A / d^2")
    angle = abs(incidence.value) if incidence else 0.0
    good = geometry.percent(geometry.error(size, distance.value, angle))
    return factor._replace(assumption=f"{factor.assumption} of a receiver (A / d^2 {good})")


def inverse_square(given: Input, incidence: Input | None) -> Factor:
    """Return the factor from intensity to irradiance at a distance from a small source [sr/m2]."""
    cosine, tilt, notes = _cosine(incidence)
    value = cosine / maths.square(given.value)
    values = {"distance": given.value}
    if incidence:
        values["incidence"] = incidence.value
    formula = ASLANT if incidence else INVERSE_SQUARE
    step = formula.step(values, f"{format_number(value)} sr/m2")
    assumption = f"a source small compared to its distance, {tilt}"
    return Factor("q", value, "sr/m2", assumption, (step,), notes)


def _cosine(turn: Input | None) -> tuple[Any, str, tuple[str, ...]]:
    """Return the cosine of an incidence or a tilt, 0 and a note for light from behind."""
    if turn is None:
        return 1.0, "light along the receiver's normal", ()
    cosine = geometry.facing(turn.value)
    notes: tuple[str, ...] = ()
    if maths.any_true(cosine == 0):
        option_text = option(turn.name, quote(turn.text))
        to = "reach" if turn.name == "incidence" else "leave"
        notes = (f"{option_text}: light from the side or behind does not {to} the surface",)
    return cosine, f"{turn.name} {turn.text} from the normal", notes


def disc(source: Input, distance: Input, incidence: Input | None) -> Factor:
    """Return the projected solid angle of a uniform disc seen from its axis [sr]."""
    from radcalc.geometry import solid
    from radcalc.laws.surface import CUT_DISC, disc_on_axis

    radius, away = radius_of(source), distance.value
    angle = abs(incidence.value) if incidence else 0.0
    _, tilt, _ = _cosine(incidence)
    notes: tuple[str, ...] = ()
    values = {"radius": radius, "distance": away}
    formula = disc_on_axis("distance").formula
    omega = solid.projected_disc(radius, away, 0.0, angle)
    if incidence is not None:
        values["incidence"] = incidence.value
        formula = formula._replace(template=f"{formula.template} cos({{incidence}})")
        if maths.any_true(angle + maths.atan(radius / away) > math.pi / 2 * (1 + 1e-15)):
            formula = CUT_DISC.formula
            cut = "partly below" if maths.any_true(omega > 0) else "below"
            incidence_text = option("incidence", quote(incidence.text))
            notes = (f"{incidence_text}: the disc is {cut} the receiver's horizon",)
    step = formula.step(values, f"{format_number(omega)} sr")
    assumption = f"a uniform disc seen from its axis at {distance.text}, {tilt}"
    return Factor("Omega_p", omega, "sr", assumption, (step,), notes)


def far_area(source: Input, distance: Input, incidence: Input | None, tilt: Input | None) -> Factor:
    """Return an area seen from a distance [m2]; raise if it is too near or below the horizon."""
    factor = area(source)
    size, reach = geometry.size(factor.value), geometry.reach(factor.value)
    angle, slope = (abs(turn.value) if turn else 0.0 for turn in (incidence, tilt))
    hint: Hint = geometry.MORE_ROOM
    if tilt is None:
        radius = "R" if maths.is_array(size) else f"{format_number(size / 2)}m"
        hint = Try((("radius", radius),), (source.name,), remark="exact for a disc", follow=True)
    if geometry.is_near(distance.value, size):
        distance_text = option("distance", quote(distance.text))
        raise TooNear(distance_text, "source", format_number(size), hint)
    if incidence and maths.any_true(geometry.is_cut(reach, distance.value, angle)):
        raise HorizonCuts("incidence", incidence.text, "", hint)
    good = geometry.percent(geometry.error(size, distance.value, slope, angle))
    facing = "" if tilt else ", which faces the receiver"
    return factor._replace(assumption=f"{factor.assumption}{facing} (A / d^2 {good})")


def reflector(given: Input) -> Factor:
    """Return the factor of a Lambertian reflector, from irradiance to radiance [1/sr]."""
    value = given.value / math.pi
    step = REFLECTOR.step({"reflectance": given.value}, f"{format_number(value)} /sr")
    assumption = f"a Lambertian reflector of reflectance {given.text}"
    return Factor("r", value, "/sr", assumption, (step,))


def reflected(given: Input) -> Factor:
    """Return the reflectance of a surface, from incident to reflected light."""
    assumption = f"only reflected light leaves the surface, with a reflectance of {given.text}"
    step = REFLECTED_LIGHT.with_numbers(f"M = {format_number(given.value)} E")
    return Factor("rho", given.value, "radlux/lx", assumption, (step,))


def responsivity(given: Input) -> Factor:
    """Return the amperes per watt of light on a detector."""
    assumption = f"a detector of {given.text} for all of that light, and no dark current"
    return Factor("s", given.value, "A/W", assumption)


def yield_of(responsivity: Any, photon_energy: Any) -> tuple[str, ...]:
    """Return a note on a detector with more than one electron per photon."""
    electrons = responsivity * photon_energy / resolve("eV").factor  # 1 eV is e times 1 V
    if not maths.any_true(electrons > 1):
        return ()
    number = format_number(electrons) if isinstance(electrons, float) else "more than one"
    return (f"{number} electrons per photon: only a detector with internal gain gives so many",)


def pupil(given: Input) -> Factor:
    """Return the trolands per candela per square metre: the pupil's area in mm2."""
    millimetres = given.value / 1e-3
    value = math.pi / 4 * maths.square(millimetres)
    step = RETINA.with_numbers(
        f"p = pi/4 ({format_number(millimetres)} mm)^2 = {format_number(value)} mm2"
    )
    return Factor("p", value, "td m2/cd", f"a round pupil of diameter {given.text}", (step,))


Supply = dict[str, Callable[[Conditions], Factor]]


class Way(NamedTuple):
    """The powers of the conditions that lead from one geometry to another.

    `supply` gives the factor of each.
    """

    powers: dict[str, int]
    supply: Supply
    is_suggested: bool = True
    extends: bool = True  # whether it is suggested if part of it is given
    is_tilted: bool = False  # whether the source may be seen obliquely


def _area(conditions: Conditions) -> Factor:
    return area(conditions.take(AREA))


def _front_area(conditions: Conditions) -> Factor:
    factor = area(conditions.take(AREA))
    if "tilt" in conditions.given:
        return factor
    return factor._replace(assumption=f"{factor.assumption}, seen along its normal")


def _far_area(conditions: Conditions) -> Factor:
    area, given = conditions.take(AREA), conditions.given
    return far_area(area, given[DISTANCE], given.get("incidence"), given.get("tilt"))


def _aperture(conditions: Conditions) -> Factor:
    area, given = conditions.take(AREA), conditions.given
    return aperture(area, given[DISTANCE], given.get("incidence"))


def _cone(conditions: Conditions) -> Factor:
    return solid_angle(conditions.take(CONE))


def _projected_cone(conditions: Conditions) -> Factor:
    turn = conditions.use("tilt") or conditions.use("incidence")
    return projected_solid_angle(conditions.take(CONE), turn)


def _inverse_square(conditions: Conditions) -> Factor:
    return inverse_square(conditions.take(DISTANCE), conditions.use("incidence"))


def _reflector(conditions: Conditions) -> Factor:
    return reflector(conditions.take(REFLECTANCE))


def _disc(conditions: Conditions) -> Factor:
    source, distance = conditions.take(AREA), conditions.take(DISTANCE)
    return disc(source, distance, conditions.use("incidence"))


PLAIN: Supply = {AREA: _area, CONE: _cone, DISTANCE: _inverse_square, REFLECTANCE: _reflector}
AT_RADIANCE: Supply = {**PLAIN, CONE: _projected_cone}  # with a reflector, the cone of the lamp
IN_FRONT: Supply = {**PLAIN, AREA: _front_area}
FAR: Supply = {**PLAIN, AREA: _far_area}
RECEIVED: Supply = {**PLAIN, AREA: _aperture}
REFLECTED = Way({REFLECTANCE: 1}, {REFLECTANCE: lambda c: reflected(c.take(REFLECTANCE))})
DISC = Way({DISTANCE: -1}, {DISTANCE: _disc})  # exact, of a radius or diameter

FLUX, INTENSITY, IRRADIANCE, RADIANCE = (0, 0), (0, 1), (1, 0), (1, 1)
# From the first geometry (powers of 1/area and 1/solid angle) to the second; in reverse, the powers
# change sign.  Of the ways that begin with the given conditions, the first two are suggested.
WAYS = {
    (FLUX, INTENSITY): (Way({CONE: -1}, PLAIN), Way({AREA: -1, DISTANCE: -1}, RECEIVED, False)),
    (FLUX, IRRADIANCE): (Way({AREA: -1}, PLAIN), Way({CONE: -1, DISTANCE: 1}, PLAIN)),
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


def ways_between(start: tuple[int, int], end: tuple[int, int]) -> tuple[tuple[Way, ...], int]:
    """Return the ways between two geometries, and the sign of their powers in that direction."""
    if (start, end) in WAYS:
        return WAYS[start, end], 1
    return WAYS.get((end, start), ()), -1
