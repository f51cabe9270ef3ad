"""Factors of geometry and time: areas, cones, distances, reflectors, the pupil, durations."""

import math
from typing import Any

from radcalc import maths
from radcalc.answer import Step
from radcalc.conversion.conditions import Factor, Given, degrees, positive, require, show
from radcalc.errors import ConditionError, quote
from radcalc.geometry import lobes


def area(given: Given) -> Factor:
    """The area of a source or a receiver [m2]."""
    size = positive(given)
    if given.option.name == "area":
        return Factor("A", size, "m2", f"uniform over {given.text}")
    radius = size if given.option.name == "radius" else size / 2
    value = math.pi * radius**2
    step = Step("area of a circle", "A = pi R^2", f"A = pi ({show(radius)} m)^2 = {show(value)} m2")
    return Factor("A", value, "m2", f"uniform over a circle of {show(value)} m2", (step,))


def duration(given: Given) -> Factor:
    """A time [s]."""
    return Factor("t", positive(given), "s", f"constant over {given.text}")


def solid_angle(given: Given) -> Factor:
    """The solid angle between flux and intensity [sr]."""
    name, value = given.option.name, given.value
    if name == "isotropic":
        return Factor("Omega", 4 * math.pi, "sr", "uniform over 4 pi sr (isotropic)")
    if name == "hemisphere":
        return Factor("Omega", 2 * math.pi, "sr", "uniform over 2 pi sr (a hemisphere)")
    if name == "solid-angle":
        positive(given)
        whole = 4 * math.pi * (1 + 1e-12)  # 12.566370614359sr, as typed, is the whole sphere
        require(given, not maths.any_true(value > whole), "at most 4pi sr")
        return Factor("Omega", value, "sr", f"uniform over {given.text}")
    if name in ("exponent", "beam-angle"):
        return _lobe(given)
    half = half_angle(given)
    within = not maths.any_true(half > math.pi * (1 + 1e-12))
    require(given, within, "at most the whole sphere")
    omega = 4 * math.pi * maths.sin(half / 2) ** 2
    step = Step(
        "solid angle of a cone",
        "Omega = 4 pi sin^2(alpha/2) Omega0",
        f"Omega = 4 pi sin^2({degrees(half)}/2) sr = {show(omega)} sr",
        "ISO 80000-3, solid angle",
    )
    cone = f"uniform over a cone of half angle {degrees(half)}, {show(omega)} sr"
    return Factor("Omega", omega, "sr", cone, (step,))


def half_angle(given: Given) -> Any:
    """The half angle of a cone [rad], from --half-angle or --apex-angle."""
    angle = positive(given)
    return angle if given.option.name == "half-angle" else angle / 2


def _lobe(given: Given) -> Factor:
    """A cosine-power lobe: the solid angle that, at the peak intensity, holds all the flux."""
    if given.option.name == "exponent":
        exponent = given.value
        require(given, not maths.any_true(exponent < 0), "0 or more")
        steps: tuple[Step, ...] = ()
    else:
        angle = positive(given)
        require(given, not maths.any_true(angle >= math.pi), "less than 180 deg")
        exponent = lobes.exponent(angle, 0.5)
        steps = (
            Step(
                "exponent of a lobe",
                "n = ln(1/2) / ln cos(FWHM/2)",
                f"n = ln(1/2) / ln cos({degrees(angle)}/2) = {show(exponent)}",
            ),
        )
    omega = 2 * math.pi / (exponent + 1)
    step = Step(
        "flux of a lobe",
        "Omega = 2 pi Omega0 / (n + 1)",
        f"Omega = 2 pi sr / ({show(exponent)} + 1) = {show(omega)} sr",
    )
    assumption = f"intensity I0 cos^n(theta) with n = {show(exponent)}; I0 is the peak"
    return Factor("Omega", omega, "sr", assumption, (*steps, step))


def projected_solid_angle(given: Given) -> Factor:
    """The projected solid angle between radiance and irradiance, exitance or flux [sr]."""
    name = given.option.name
    if name == "hemisphere":
        return Factor("Omega_p", math.pi, "sr", "uniform over a hemisphere, pi sr projected")
    if name not in ("half-angle", "apex-angle"):
        raise ConditionError(
            f"{given.flag} does not link a radiance: that takes the projected solid angle",
            "--half-angle ANGLE or --hemisphere",
        )
    half = half_angle(given)
    limit = f"at most {'90' if name == 'half-angle' else '180'} deg, where a radiance is concerned"
    require(given, not maths.any_true(half > math.pi / 2 * (1 + 1e-12)), limit)
    omega = math.pi * maths.sin(half) ** 2
    step = Step(
        "projected solid angle of a cone",
        "Omega_p = pi sin^2(alpha) Omega0",
        f"Omega_p = pi sin^2({degrees(half)}) sr = {show(omega)} sr",
        "ISO 80000-7, radiance and irradiance",
    )
    cone = f"uniform over a cone of half angle {degrees(half)} about the normal"
    return Factor("Omega_p", omega, "sr", f"{cone}, {show(omega)} sr projected", (step,))


def inverse_square(given: Given, incidence: Given | None) -> Factor:
    """From the intensity of a small source to the irradiance at a distance [sr/m2]."""
    distance = positive(given)
    cosine, tilt, notes = _cosine(incidence)
    value = cosine / distance**2
    written = f"cos({degrees(incidence.value)}) " if incidence else ""
    step = Step(
        "inverse square law",
        f"q = {'cos(theta) ' if incidence else ''}Omega0 / d^2",
        f"q = {written}sr / ({show(distance)} m)^2 = {show(value)} sr/m2",
        "ISO 80000-7, intensity and irradiance",
    )
    assumption = f"a source small beside its distance, {tilt}"
    return Factor("q", value, "sr/m2", assumption, (step,), notes)


def _cosine(incidence: Given | None) -> tuple[Any, str, tuple[str, ...]]:
    """The cosine of the incidence; light from behind the surface gives 0, and a note."""
    if incidence is None:
        return 1.0, "light along the receiver's normal", ()
    angle = abs(incidence.value)
    require(incidence, not maths.any_true(angle > math.pi), "0 to 180 deg")
    behind = angle >= math.pi / 2
    if isinstance(angle, float):
        cosine = 0.0 if behind else math.cos(angle)
    else:
        cosine = maths.cos(angle) * ~behind
    note = f"--incidence {incidence.text}: light from the side or behind does not reach the surface"
    return (
        cosine,
        f"incidence {incidence.text} from the normal",
        (note,) if maths.any_true(behind) else (),
    )


def disc(source: Given, distance: Given, incidence: Given | None) -> Factor:
    """The projected solid angle of a uniform disc seen from its axis [sr]."""
    size, away = positive(source), positive(distance)
    radius = size if source.option.name == "radius" else size / 2
    cosine, tilt, _ = _cosine(incidence)
    notes: tuple[str, ...] = ()
    if incidence is not None:
        # Where the receiver's plane cuts the disc, the light vector is not all of it.
        angle, rim = abs(incidence.value), maths.atan(radius / away)
        right = math.pi / 2 * (1 + 1e-15)
        below = angle - rim >= math.pi / 2
        if maths.any_true(
            (angle + rim > right) & ~below
            if not isinstance(below, bool)
            else angle + rim > right and not below
        ):
            raise ConditionError(
                f"--incidence {quote(incidence.text)}: part of the disc is below the receiver's "
                "horizon, where the formula on the axis does not hold",
                "a smaller --incidence, --radius or a larger --distance",
            )
        if maths.any_true(below):
            notes = (f"--incidence {incidence.text}: the disc is below the receiver's horizon",)
    omega = math.pi * radius**2 / (radius**2 + away**2) * cosine
    step = Step(
        "disc on its axis",
        f"Omega_p = pi Omega0 R^2 / (R^2 + d^2){' cos(theta)' if incidence else ''}",
        f"Omega_p = pi sr ({show(radius)} m)^2 / (({show(radius)} m)^2 + ({show(away)} m)^2)"
        f"{f' cos({degrees(incidence.value)})' if incidence else ''} = {show(omega)} sr",
        "J. R. Howell, A Catalog of Radiation Heat Transfer Configuration Factors",
    )
    assumption = f"a uniform disc seen from its axis at {distance.text}, {tilt}"
    return Factor("Omega_p", omega, "sr", assumption, (step,), notes)


def size_of(area: Any) -> Any:
    """The diameter of a circle of an area: how large a patch counts beside its distance."""
    return 2 * (area / math.pi) ** 0.5


def is_near(distance: Any, size: Any, slack: float = 1e-12) -> bool:
    """Whether a distance is under five times a size, where the inverse square law is off."""
    return maths.any_true(distance < 5 * size * (1 - slack))


def far_field(
    source: Factor,
    distance: Given,
    hint: str = "--radius R in place of --area, for the exact disc (or radcalc lambertian)",
    law: str = "the inverse square law",
) -> None:
    """Refuse an area seen from so near that the inverse square law is off."""
    size = size_of(source.value)
    if is_near(distance.value, size):
        raise ConditionError(
            f"--distance {quote(distance.text)} is less than five times the size of the source "
            f"({show(size)} m): {law} does not hold",
            hint,
        )


def reflector(given: Given) -> Factor:
    """A Lambertian reflector, from incident irradiance to radiance [1/sr]."""
    rho = given.value
    bad = maths.any_true(rho < 0) or maths.any_true(rho > 1)
    require(given, not bad, "from 0 to 1, or from 0% to 100%")
    value = rho / math.pi
    step = Step(
        "Lambertian reflector",
        "r = rho / (pi Omega0)",
        f"r = {show(rho)} / (pi sr) = {show(value)} /sr",
        "ISO 80000-7, luminance and reflectance",
    )
    assumption = f"a Lambertian reflector of reflectance {given.text}"
    return Factor("r", value, "/sr", assumption, (step,))


def pupil(given: Given) -> Factor:
    """Trolands per candela per square metre: the pupil's area in mm2."""
    diameter = positive(given)
    value = math.pi / 4 * (diameter / 1e-3) ** 2
    step = Step(
        "retinal illuminance",
        "p = pi/4 d^2",
        f"p = pi/4 ({show(diameter / 1e-3)} mm)^2 = {show(value)} mm2",
    )
    return Factor("p", value, "td m2/cd", f"a round pupil of diameter {given.text}", (step,))
