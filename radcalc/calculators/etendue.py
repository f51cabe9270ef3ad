"""The etendue between a source and a receiver or a cone, and the flux that a radiance gives it."""

import math
from typing import Any

from radcalc.answer import Answer, Step, Value
from radcalc.calculators import inputs as i
from radcalc.calculators import light as q
from radcalc.calculators.inputs import Inputs
from radcalc.conversion import geometric
from radcalc.conversion.conditions import Given, degrees, positive, require, show
from radcalc.errors import ConditionError, NumberError, UsageError
from radcalc.geometry import etendue as g
from radcalc.geometry.solid import facing
from radcalc.quantities.light import SOLID_ANGLE, powers
from radcalc.units.table import NUMBER

ETENDUE = powers(length=2, angle=2)
LEAST = 1e-300  # below it a float has fewer digits
CONES = ("half-angle", "apex-angle", "na", "f-number")
RECEIVERS = ("receiver-area", "receiver-radius", "receiver-diameter")
SOURCES = ("area", "radius", "diameter", "width", "length")
ROUND = ("radius", "diameter")


def etendue(given: Inputs) -> Answer:
    """The etendue of a source and a cone of light, or of a source and a receiver."""
    radiance, _, given = q.sort(given)
    has_receiver = any(name in given for name in RECEIVERS)
    has_cone = any(name in given for name in CONES)
    if has_receiver and has_cone:
        raise ConditionError(
            "a receiver and a cone contradict each other: both limit the light", "one of them"
        )
    if has_receiver:
        found = _with_receiver(given)
    elif has_cone:
        found = _with_cone(given)
    else:
        raise UsageError(
            "what limits the light is missing",
            "--half-angle, --apex-angle, --na, --f-number, or --receiver-area (-radius, -diameter) "
            "with --distance",
        )
    values, assumptions, notes, steps = found
    if not notes and values[0].si < LEAST:
        raise NumberError("the etendue is too small to be held by a number", "larger sizes")
    values += [i.known(one) for one in given.values()]
    if radiance:
        flux, step = _flux(q.read_light(radiance, {}), values[0].si)
        values[1:1] = flux
        steps = [*steps, step]
    return values, assumptions, notes, steps


def _values(size: Any, area: Any, far: Any = None) -> list[Value]:
    """An etendue as results; per area it is a projected solid angle."""
    projected = size / area
    values = [
        Value("etendue", "etendue", "G", size, (ETENDUE,), ("m2 sr", "mm2 sr")),
        Value(
            "projected-solid-angle",
            "projected solid angle",
            "Ω_p",
            projected,
            (SOLID_ANGLE,),
            ("sr",),
        ),
        Value(
            "configuration-factor",
            "configuration factor",
            "F",
            projected / math.pi,
            (NUMBER,),
            ("1",),
        ),
    ]
    if far is not None:
        values.append(
            Value("far-field-etendue", "far-field etendue", "A1 A2/d²", far, (ETENDUE,), ("m2 sr",))
        )
    return values


def _area(given: Inputs) -> tuple[Any, list[Step]]:
    """The area of the source [m2]."""
    if "width" in given or "length" in given:
        for name in ("width", "length"):
            i.one_of(given, f"the {name} of the source", name)
        if any(name in given for name in ("area", *ROUND)):
            raise ConditionError("the size of the source is given twice", "one of them")
        return positive(given["width"]) * positive(given["length"]), []
    hint = "--area 1cm2, --radius 10cm, --diameter 20cm, or --width 2cm with --length 1cm"
    factor = geometric.area(i.one_of(given, "the size of the source", "area", *ROUND, hint=hint))
    return factor.value, list(factor.steps)


def _with_cone(given: Inputs) -> Answer:
    i.only(given, (*SOURCES, *CONES), "a source and a cone")
    area, steps = _area(given)
    one = i.one_of(given, "the cone", *CONES)
    said = ["every point of the source sends its light into the same cone about its normal"]
    shown = f"{show(area)} m2"
    if one.option.name == "na":
        require(one, positive(one) <= 1, "at most 1, in air")
        size = g.patch_and_aperture(area, positive(one))
        formula, numbers = "G = pi A NA^2 Omega0", f"pi {shown} ({show(one.value)})^2 sr"
        said.append("in air, where the numerical aperture is the sine of the half angle")
    elif one.option.name == "f-number":
        require(one, positive(one) >= 0.5, "0.5 or more, in air")
        size = g.patch_and_lens(area, positive(one))
        formula, numbers = "G = pi A / (4 N^2) Omega0", f"pi {shown} / (4 ({show(one.value)})^2) sr"
        said.append("a lens corrected for coma and focused far away: sin(alpha) = 1/(2 N)")
    else:
        half = i.half_angle(one, 90)
        size = g.patch_and_cone(area, half)
        formula = "G = pi A sin^2(alpha) Omega0"
        numbers = f"pi {shown} sin^2({degrees(half)}) sr"
    steps.append(Step("etendue of a cone", formula, f"G = {numbers} = {show(size)} m2 sr"))
    return _values(size, area), said, [], steps


def _with_receiver(given: Inputs) -> Answer:
    i.only(
        given,
        (*SOURCES, *RECEIVERS, "distance", "tilt", "incidence"),
        "a source and a receiver",
    )
    away = i.one_of(given, "the distance", "distance")
    receiver = i.one_of(given, "the size of the receiver", *RECEIVERS)
    discs = any(n in given for n in ROUND) and receiver.option.name != "receiver-area"
    if discs and not i.tilt(given) and not i.tilt(given, "incidence"):
        return _discs(given, positive(away))
    return _patches(given, away, receiver)


def _discs(given: Inputs, away: Any) -> Answer:
    one = i.radius(given)
    other = i.radius(given, "receiver-", "the size of the receiver")
    area = math.pi * one**2
    size = g.coaxial_discs(one, other, away)
    far = g.two_patches(area, math.pi * other**2, away)
    step = Step(
        "two coaxial discs",
        "G = pi^2/2 (S - sqrt(S^2 - 4 r1^2 r2^2)) Omega0, S = r1^2 + r2^2 + d^2",
        f"r1 = {show(one)} m, r2 = {show(other)} m, d = {show(away)} m; G = {show(size)} m2 sr",
        "J. R. Howell, A Catalog of Radiation Heat Transfer Configuration Factors, C-41",
    )
    if not size > LEAST:
        raise NumberError("the etendue is too small to be held by a number", "larger sizes")
    note = f"at {show(away)} m the far field A1 A2 / d^2 is {show(far / size)} times the exact one"
    said = [
        "two discs that face each other on one axis",
        "projected solid angle and configuration factor: means over the source",
    ]
    return _values(size, area, far), said, [note], [step]


def _patches(given: Inputs, away: Given, receiver: Given) -> Answer:
    area, steps = _area(given)
    name = receiver.option.name
    size = positive(receiver)
    other = size if name == "receiver-area" else math.pi * i.radius(given, "receiver-") ** 2
    tilt, incidence = i.tilt(given), i.tilt(given, "incidence")
    longest = max(geometric.size_of(max(area, other)), *_sides(given), 0.0)
    if geometric.is_near(positive(away), longest):
        hint = "more distance, or --radius and --receiver-radius for two discs exactly"
        if "tilt" in given or "incidence" in given:
            hint = "two discs without --tilt and --incidence, which are exact"
        raise ConditionError(
            f"--distance {away.text} is less than five times the size of the patches "
            f"({show(longest)} m): A1 A2 / d^2 does not hold",
            hint,
        )
    total = g.two_patches(area, other, away.value, tilt, incidence)
    notes = []
    if not facing(tilt) * facing(incidence):
        notes = ["one of the patches is seen from its edge or from behind"]
    cosines = f"cos({degrees(tilt)}) {show(other)} m2 cos({degrees(incidence)})"
    steps.append(
        Step(
            "two small patches",
            "G = A1 cos(t1) A2 cos(t2) / d^2 Omega0",
            f"G = {show(area)} m2 {cosines} / ({show(away.value)} m)^2 sr = {show(total)} m2 sr",
        )
    )
    off = (area + other) / math.pi / away.value**2
    said = [
        f"patches small beside their distance (two discs would have some {show(100 * off)} % less)"
    ]
    return _values(total, area), said, notes, steps


def _sides(given: Inputs) -> list[Any]:
    return [given[name].value for name in ("width", "length") if name in given]


def _flux(lit: q.Lit, size: Any) -> tuple[list[Value], Step]:
    """Phi = L G."""
    given = lit.values["radiance"]
    flux = positive(given) * size
    shown = q.show_light(lit, {"flux": flux, "radiance": given.value})
    step = Step(
        "flux of a uniform radiance",
        "Phi = L G",
        f"Phi = {given.text} * {show(size)} m2 sr = {show(flux)} {q.unit('flux', lit.kind, True)}",
        "ISO 80000-7, radiance",
    )
    return [*shown.values["flux"], *shown.values["radiance"]], step
