"""Mistakes with angles, distances, sizes and the solid angles of shapes."""

import math
from collections.abc import Iterator

from radcalc.geometry import solid
from radcalc.homework.catalogue import Problem, light_of, mistake
from radcalc.units.dimensions import ANGLE


@mistake(
    "cosine-forgotten",
    1,
    "the cosine of the incidence was left out",
    "E = I cos(theta) / d^2: a tilted surface catches less light",
)
def _no_cosine(p: Problem) -> Iterator[float]:
    for name in ("incidence", "tilt"):
        if name in p.given and p.given[name].value:
            yield from p.anew(**{name: 0.0})
            cosine = math.cos(p.given[name].value)
            if name in p.values and cosine > 0 and p.target.name != name:
                yield p.right / cosine
    off, aside = p.si("off-axis"), _aside(p)
    if aside and p.target.name == "solid-angle":
        yield math.pi * (p.si("radius") or 0.0) ** 2 / aside[1] ** 2
    elif aside and p.target.name == "irradiance" and (far := p.si("far-field-irradiance")):
        yield far * aside[1] / aside[0]
    if "height" in p.given and "incidence" not in p.given and off and math.cos(off) > 0:
        yield p.right / math.cos(off)


@mistake(
    "cosine-squared",
    5,
    "the cosine was taken twice or three times",
    "E = I cos(theta) / d^2 with the slant distance has one cosine (cos^3 goes with the height)",
)
def _more_cosines(p: Problem) -> Iterator[float]:
    angle = p.si("incidence")
    if angle and math.cos(angle) > 0:
        for power in (1, 2):
            yield p.right * math.cos(angle) ** power


@mistake(
    "angle-from-surface",
    2,
    "the angle was taken from the surface, not from its normal",
    "incidence and polar angle are counted from the normal",
)
def _from_surface(p: Problem) -> Iterator[float]:
    for name in ("incidence", "tilt", "polar", "elevation", "half-angle"):
        if name in p.given:
            yield from p.anew(**{name.replace("-", "_"): math.pi / 2 - p.given[name].value})
    if p.target.name in ("polar", "elevation", "incidence"):
        yield math.pi / 2 - p.right


@mistake(
    "full-for-half",
    1,
    "the full angle was used as the half angle, or the half angle as the full one",
    "a half angle goes from the axis to the edge, an apex or beam angle from edge to edge",
)
def _full_angle(p: Problem) -> Iterator[float]:
    for name in ("half-angle", "apex-angle", "beam-angle", "field-angle", "horizontal", "vertical"):
        if name in p.given:
            for factor in (2.0, 0.5):
                yield from p.anew(**{name.replace("-", "_"): p.given[name].value * factor})
    if {"horizontal", "vertical"} <= set(p.given):
        for factor in (2.0, 0.5):
            both = {n: p.given[n].value * factor for n in ("horizontal", "vertical")}
            yield from p.anew(**both)
    if p.target.name in ("half-angle", "apex-angle", "beam-angle", "field-angle"):
        yield p.right * 2
        yield p.right / 2


@mistake(
    "degrees-as-radians",
    2,
    "degrees were taken as radians",
    "a calculator set to radians takes 30 as 30 rad, that is 1719 degrees",
)
def _radians(p: Problem) -> Iterator[float]:
    for one in p.named(ANGLE):
        number = one.number if isinstance(one.number, (int, float)) else None
        if number is None or one.unit is None or one.unit.text == "rad":
            continue
        turned = math.fmod(abs(number), 2 * math.pi)
        for angle in (turned, 2 * math.pi - turned):
            yield from p.anew(**{one.name.replace("-", "_"): angle})
        if one.name == "incidence" and math.cos(one.value):
            yield p.right * math.cos(number) / math.cos(one.value)
        if one.name in ("half-angle", "apex-angle") and p.target.name == "solid-angle":
            half = number if one.name == "half-angle" else number / 2
            yield 2 * math.pi * (1 - math.cos(half))
    yield from _radian_sines(p)
    if ANGLE in p.target.dimensions:
        yield p.right * math.pi / 180
        yield p.right * 180 / math.pi


def _radian_sines(p: Problem) -> Iterator[float]:
    """The same where both angles, or the sine of a wide one, are concerned."""
    polar, azimuth = p.typed("polar"), p.typed("azimuth")
    if polar is not None and azimuth is not None and p.target.name in ("x", "y"):
        turn = math.cos if p.target.name == "x" else math.sin
        yield math.sin(polar) * turn(azimuth)
    half, number = p.half_angle(), p.typed("half-angle")
    if number is None and (full := p.typed("apex-angle")) is not None:
        number = full / 2
    flat = light_of(p) or p.target.name in ("etendue", "projected-solid-angle")
    if half and number is not None and flat and p.is_of("lambertian", "etendue", "solid-angle"):
        yield p.right * (math.sin(number) / math.sin(half)) ** 2


def _aside(p: Problem) -> tuple[float, float] | None:
    """The height above a flat source and the slant distance, off its axis."""
    height, offset = p.si("height"), p.si("offset")
    if height and offset and p.facts.shape in ("disc", "rectangle"):
        return height, math.hypot(height, offset)
    return None


@mistake(
    "wrong-quadrant",
    2,
    "the arc tangent of y/x was taken without looking at the quadrant",
    "phi = atan2(y, x), which knows the signs of both",
)
def _quadrant(p: Problem) -> Iterator[float]:
    if p.target.name == "azimuth":
        for turn in (math.pi, -math.pi):
            yield p.right + turn


@mistake(
    "one-over-r",
    2,
    "the distance was not squared",
    "irradiance falls as 1/d^2",
)
def _not_squared(p: Problem) -> Iterator[float]:
    away = p.si("distance")
    one = p.given.get("distance")
    if p.target.name == "distance" and p.is_of("point-source"):
        yield p.right**2
    sizes = [away] if away else []
    if one and isinstance(one.number, (int, float)):
        sizes.append(float(one.number))
    for size in sizes:
        if size and p.target.name not in ("distance",):
            yield p.right * size
            yield p.right / size


@mistake(
    "height-for-distance",
    2,
    "the height was used for the slant distance",
    "d is the straight line: d^2 = h^2 + x^2",
)
def _height(p: Problem) -> Iterator[float]:
    aside, far = _aside(p), p.si("far-field-irradiance")
    if aside and p.target.name == "solid-angle":
        yield math.pi * (p.si("radius") or 0.0) ** 2 / aside[0] / aside[1]
    elif aside and p.target.name == "irradiance" and far:
        for power in (2, 3):
            yield far * (aside[1] / aside[0]) ** power
    height, away = p.si("height"), p.si("distance")
    if height and away and "height" in p.given and away > height:
        for power in (2, 3):
            yield p.right * (away / height) ** power
            yield p.right / (away / height) ** power


@mistake(
    "diameter-for-radius",
    1,
    "the diameter was used for the radius, or the radius for the diameter",
    "R is half the diameter: areas are off by 4",
)
def _diameter(p: Problem) -> Iterator[float]:
    for name in ("radius", "diameter", "receiver-radius", "receiver-diameter", "pupil"):
        if name in p.given:
            for factor in (2.0, 0.5):
                yield from p.anew(**{name.replace("-", "_"): p.given[name].value * factor})
    if p.target.name in ("radius", "diameter"):
        yield p.right * 2
        yield p.right / 2


@mistake(
    "distance-to-surface",
    3,
    "the distance was taken to the sphere's surface",
    "sin(alpha) = R/d, with d to the centre",
)
def _surface(p: Problem) -> Iterator[float]:
    radius, away = p.si("radius"), p.si("distance")
    if "diameter" in p.given:
        radius = p.given["diameter"].value / 2
    if p.facts.shape == "sphere" and radius and away:
        if "distance" in p.given:
            yield from p.anew(distance=away - radius)
            yield from p.anew(distance=away + radius)
        elif p.target.name == "distance":
            yield away - radius


@mistake(
    "arctangent-for-arcsine",
    2,
    "the tangent was used for the sine (or the sine for the tangent)",
    "a sphere's edge: sin(alpha) = R/d; a disc's rim: tan(alpha) = R/h",
)
def _tangent(p: Problem) -> Iterator[float]:
    radius = p.si("radius") or (p.si("diameter") or 0) / 2
    away = p.si("distance") or p.si("height")
    if not radius or not away or p.facts.shape not in ("sphere", "disc"):
        return
    ratio = radius / away
    if p.facts.shape == "sphere":
        half = math.atan(ratio)
        others = {
            "solid-angle": solid.cone(half),
            "projected-solid-angle": math.pi * math.sin(half) ** 2,
        }
    elif ratio < 1:
        half = math.asin(ratio)
        others = {"solid-angle": solid.cone(half), "projected-solid-angle": math.pi * ratio**2}
    else:
        return
    if p.target.name == "half-angle":
        yield half
    elif p.target.name == "apex-angle":
        yield 2 * half
    elif p.target.name in others:
        yield others[p.target.name]
    elif (flat := p.si("projected-solid-angle")) and light_of(p):
        yield p.right * others["projected-solid-angle"] / flat


@mistake(
    "flat-disc-for-cap",
    2,
    "the area of a flat disc over d^2 was used for the cap of the sphere",
    "Omega = 2 pi (1 - cos(alpha)); pi tan^2 and pi alpha^2 are only its beginning",
)
def _flat(p: Problem) -> Iterator[float]:
    half, given = p.si("half-angle"), p.half_angle()
    if given and 0 < given < math.pi / 2:
        for flat in (math.pi * math.tan(given) ** 2, math.pi * given**2):
            if p.is_of("point-source", "convert") and light_of(p):
                yield p.right * solid.cone(given) / flat
                yield p.right * flat / solid.cone(given)
            elif p.is_of("etendue"):
                yield p.right * flat / (math.pi * math.sin(given) ** 2)
    if p.target.name == "solid-angle" and half and half < math.pi / 2:
        yield math.pi * math.tan(half) ** 2
        yield math.pi * half**2
        yield math.pi * math.sin(half) ** 2
    elif p.target.name in ("half-angle", "apex-angle") and (omega := p.si("solid-angle")):
        twice = 2 if p.target.name == "apex-angle" else 1
        yield twice * math.sqrt(omega / math.pi)
        yield twice * math.atan(math.sqrt(omega / math.pi))


@mistake(
    "far-field-of-extended-source",
    2,
    "the inverse square law was used on an extended source",
    "near a source of some size E = L Omega_p: for a disc pi L R^2/(R^2 + d^2)",
)
def _far(p: Problem) -> Iterator[float]:
    far, near = p.si("far-field-irradiance"), p.si("irradiance")
    if far and near and light_of(p) and p.target.name != "far-field-irradiance":
        yield p.right * far / near
        yield p.right * near / far
    exact, estimate = p.si("etendue"), p.si("far-field-etendue")
    if exact and estimate and (light_of(p) or p.target.name == "etendue"):
        yield p.right * estimate / exact


@mistake(
    "solid-for-projected",
    2,
    "the solid angle was used for the projected one, or the other way round",
    "between L and E stands the projected solid angle: pi sr for a hemisphere, not 2 pi",
)
def _projected(p: Problem) -> Iterator[float]:
    full, flat, half = p.si("solid-angle"), p.si("projected-solid-angle"), p.half_angle()
    if half and p.is_of("etendue", "convert"):
        full, flat = solid.cone(half), math.pi * math.sin(min(half, math.pi / 2)) ** 2
    if full and flat:
        if p.target.name == "solid-angle":
            yield flat
        elif p.target.name == "projected-solid-angle":
            yield full
        elif light_of(p) or p.target.name in ("etendue", "value"):
            yield p.right * full / flat
            yield p.right * flat / full


@mistake(
    "zone-of-caps",
    2,
    "a zone was taken as one cap, or as the sum of two",
    "the zone is the outer cap less the inner one: 2 pi (cos t0 - cos t1)",
)
def _caps(p: Problem) -> Iterator[float]:
    polar = p.facts.polar
    if polar and p.target.name in ("solid-angle", "projected-solid-angle", "integral"):
        inner, outer = map(solid.cone, polar)
        part = p.right / (outer - inner) if outer > inner else 0.0
        yield part * (outer + inner)
        yield part * outer
        yield part * inner


@mistake(
    "inverse-square-on-radiance",
    3,
    "the inverse square law was used on a radiance",
    "a radiance is the same from any distance",
)
def _radiance(p: Problem) -> Iterator[float]:
    light, away = light_of(p), p.si("distance")
    if light and light[2] and light[3] and away:
        yield p.right / away**2
        yield p.right * away**2
