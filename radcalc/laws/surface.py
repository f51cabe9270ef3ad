"""A surface with the same radiance in all directions: its light, and the light on a receiver.

The laws of a receiver are exact at any distance, except those of a small source, whose distance is
at least five times its size, and the inverse square law, which is an estimate.  Lengths [m], areas
[m2], solid angles [sr]; light in coherent SI of one kind.
"""

import math
from typing import Any

from radcalc import geometry
from radcalc.answer import Formula
from radcalc.geometry import refuse, solid
from radcalc.geometry.models import CIE
from radcalc.laws import (
    CONFIGURATION_FACTOR,
    ENERGY,
    EXPOSURE,
    HOWELL,
    AnyLaw,
    At,
    Relation,
    Several,
    law,
    refuse_arrays,
    relation,
)
from radcalc.maths import SLACK, Number, each, limit, piecewise, sin, sqrt, square
from radcalc.units.numbers import EXACT

LAMBERTIAN = law(
    "Lambertian exitance",
    "{exitance} = pi Omega0 {radiance}",
    "ISO 80000-7, radiance and exitance",
)
LAWS: list[AnyLaw] = [
    LAMBERTIAN,
    law(
        "Lambertian reflector",
        "{exitance} = {reflectance} {incident-irradiance}",
        "ISO 80000-7, reflectance",
    ),
    law("flux of a surface", "{flux} = {exitance} {area}", "ISO 80000-7, exitance"),
    law(
        "intensity of a surface",
        "{intensity} = {radiance} {apparent-area}",
        "ISO 80000-7, radiance",
    ),
    law(
        "irradiance of a uniform radiance",
        "{irradiance} = {radiance} {projected-solid-angle}",
        "ISO 80000-7, radiance and irradiance",
    ),
    CONFIGURATION_FACTOR,
    law(
        "inverse square law, as an estimate",
        "{far-field-irradiance} = {intensity} {cosine-of-source} {cosine} Omega0 / {distance}^2",
    ),
    EXPOSURE,
    ENERGY,
]
SURFACE_ENERGY = law(
    "exposure by the energy of a surface",
    "{exposure} = {energy} {projected-solid-angle} / (pi Omega0 {area})",
)
FLAT_FLUX = law("flux of a flat surface", "{flux} = pi Omega0 {intensity}")
SMALL_SOURCE_ENERGY = law(
    "exposure by the energy of a small source",
    "{exposure} = {energy} {cosine-of-source} {cosine} / (pi {distance}^2)",
)
FLAT = law("projected area of a flat surface, seen from the front", "{apparent-area} = {area}")
SPHERE_AREA = law("area of a sphere", "{area} = 4 pi {radius}^2")
SPHERE_FRONT = law(
    "projected area of a sphere, from any direction", "{apparent-area} = pi {radius}^2"
)
SMALL_SOURCE = law(
    "small source",
    "{projected-solid-angle} = {area} {cosine-of-source} {cosine} Omega0 / {distance}^2",
)
SMALL_SOURCE_INTENSITY = law(
    "inverse square law of a small source",
    "{irradiance} = {intensity} {cosine-of-source} {cosine} Omega0 / {distance}^2",
)

CUT_DISC = relation(
    "disc on its axis, cut by the receiver's horizon",
    "{projected-solid-angle} = integral of cos(theta) over the solid angle that the horizon leaves "
    "of the disc, {radius} at {distance}, under {incidence}",
    {
        "projected-solid-angle": lambda at: solid.projected_disc(
            at("radius"), at("distance"), 0.0, at("incidence")
        )
    },
    HOWELL,
)


TOO_MUCH = (
    "more irradiance than the whole hemisphere at that radiance would give",
    "more radiance, or less irradiance",
)


def _hemisphere_over(at: At) -> Any:
    part = at("projected-solid-angle")
    geometry.refuse(part >= math.pi, *TOO_MUCH)
    return math.pi / part


def disc_on_axis(away: str) -> Relation:
    """Make the law of the projected solid angle of a uniform disc from a point on its axis.

    Parameters
    ----------
    away : {"distance", "height"}
        Symbol of the length [m] between that point and the disc.

    Returns
    -------
    Relation
        Between the projected solid angle [sr], the radius [m] and `away` [m].

    Raises
    ------
    ConditionError
        When the relation is solved for a length, if the projected solid angle is pi sr or more;
        for the projected solid angle, if the receiver is in the disc's plane.

    Notes
    -----
    ::

        Omega_p = pi Omega0 R^2 / (R^2 + h^2)

    References
    ----------
    J. R. Howell, A Catalog of Radiation Heat Transfer Configuration Factors.

    Examples
    --------
    At the height of the radius the disc has pi/2 sr, and back:

    >>> disc = disc_on_axis("height")
    >>> round(disc.solve("projected-solid-angle", {"radius": 1.0, "height": 1.0}.get), 6)
    1.570796
    >>> round(disc.solve("height", {"radius": 1.0, "projected-solid-angle": 1.570796}.get), 6)
    1.0
    """
    return relation(
        "disc on its axis",
        f"{{projected-solid-angle}} = pi Omega0 {{radius}}^2 / ({{radius}}^2 + {{{away}}}^2)",
        {
            "projected-solid-angle": lambda at: solid.projected_disc(at("radius"), at(away)),
            away: lambda at: at("radius") * sqrt(_hemisphere_over(at) - 1),
            "radius": lambda at: at(away) / sqrt(_hemisphere_over(at) - 1),
        },
        HOWELL,
    )


def disc_flux(away: str) -> Relation:
    """Make the law of a uniform disc's flux from the irradiance at a point on its axis.

    Parameters
    ----------
    away : {"distance", "height"}
        Symbol of the length [m] between that point and the disc.

    Returns
    -------
    Relation
        Between the flux [SI], the irradiance [SI], the radius [m] and `away` [m].

    Raises
    ------
    ConditionError
        When the relation is solved for a length, if the flux is too small for the irradiance.

    Notes
    -----
    ::

        Phi = pi (R^2 + h^2) E

    The flux pi^2 R^2 L over the irradiance pi R^2 L / (R^2 + h^2) of the same radiance L.

    Examples
    --------
    >>> disc = disc_flux("height")
    >>> round(disc.solve("radius", {"flux": 6.2831853, "irradiance": 1.0, "height": 1.0}.get), 6)
    1.0
    """

    def side(at: At, other: str) -> Any:
        rest = at("flux") / (math.pi * at("irradiance")) - square(at(other))
        geometry.refuse(
            rest < 0,
            "more irradiance than a disc of that flux gives there",
            "more flux, or less irradiance",
        )
        return sqrt(rest)

    return relation(
        "flux of a disc, from its axis",
        f"{{flux}} = pi ({{radius}}^2 + {{{away}}}^2) {{irradiance}}",
        {
            "flux": lambda at: (
                math.pi * (square(at("radius")) + square(at(away))) * at("irradiance")
            ),
            "irradiance": lambda at: (
                at("flux") / (math.pi * (square(at("radius")) + square(at(away))))
            ),
            "radius": lambda at: side(at, away),
            away: lambda at: side(at, "radius"),
        },
    )


def _slope(at: At) -> Any:
    """Return (1 - 2 F) / sqrt(F (1 - F)), with the projected solid angle F over pi."""
    part = at("projected-solid-angle") / math.pi
    geometry.refuse(part >= 1, *TOO_MUCH)
    return (1 - 2 * part) / sqrt(part * (1 - part))


def _disc_offset(at: At) -> Any:
    radius, height = at("radius"), at("height")
    rest = square(radius) - square(height) + _slope(at) * radius * height
    geometry.refuse(rest < 0, "more irradiance than below the disc's centre", TOO_MUCH[1])
    return sqrt(rest)


def _disc_heights(at: At) -> Any:
    """Return the height for a projected solid angle; outside the disc there may be two."""
    radius, offset = at("radius"), at("lateral")
    half = _slope(at) * radius / 2
    rest = (offset - radius) * (offset + radius)
    refuse_arrays("heights", half, rest)
    within = square(half) - rest
    geometry.refuse(
        within < 0 or (half <= 0 <= rest), "more irradiance than at any height there", TOO_MUCH[1]
    )
    far = half + sqrt(within) if half > 0 else -rest / (sqrt(within) - half)
    return Several((rest / far, far)) if rest > 0 and rest < far * far else far


def _disc_radius(at: At) -> Any:
    half, away = _slope(at) * at("height") / 2, square(at("height")) + square(at("lateral"))
    root = sqrt(square(half) + away)
    return piecewise(half > 0, lambda h, r, s: s / (r + h), lambda h, r, s: r - h, half, root, away)


DISC_ASIDE = relation(
    "disc off its axis",
    "{projected-solid-angle} = Omega0 pi/2 (1 - ({height}^2 + {lateral}^2 - {radius}^2) / "
    "sqrt(({height}^2 + {lateral}^2 + {radius}^2)^2 - 4 {radius}^2 {lateral}^2))",
    {
        "projected-solid-angle": lambda at: solid.projected_disc(
            at("radius"), at("height"), at("lateral")
        ),
        "lateral": _disc_offset,
        "height": _disc_heights,
        "radius": _disc_radius,
    },
    f"{HOWELL}, B-13",
)


def _disc_radii(at: At) -> Any:
    """Return the one or two radii of a disc of a flux for the irradiance off its axis."""
    height, offset = at("height"), at("lateral")
    part = math.pi**2 * at("irradiance") / at("flux")
    refuse_arrays("radii", part, height, offset)

    def excess(logarithm: float) -> float:
        radius = math.exp(logarithm)
        return math.log(solid.projected_disc(radius, height, offset) / radius**2 / part)

    away = math.log(math.hypot(height, offset))
    low, high = away - 12, away + 12  # small against the distance; the hemisphere
    while excess(high) > 0:
        high += 12
    left, right = low, high
    for _ in range(200):  # thirds around the brightest radius
        third = (right - left) / 3
        if excess(left + third) < excess(right - third):
            left += third
        else:
            right -= third
    top = (left + right) / 2
    geometry.refuse(
        excess(top) < -EXACT,
        "more irradiance than a disc of that flux gives there",
        "more flux, or less irradiance",
    )
    if excess(top) <= 0:
        return math.exp(top)
    ends = [end for end in (low, high) if excess(end) < 0]
    return Several(math.exp(limit(lambda r: excess(r) >= 0, end, top)) for end in ends)


DISC_FLUX_ASIDE = relation(
    "flux of a disc, off its axis",
    "{flux} = pi^2 Omega0 {radius}^2 {irradiance} / Omega_p, with the projected solid angle "
    "Omega_p of the disc with {radius}, from {height} at {lateral}",
    {"radius": _disc_radii},
    f"{HOWELL}, B-13",
)


def rectangle_on_axis(away: str) -> Relation:
    """Make the law of the projected solid angle of a uniform rectangle from a point on its axis.

    Parameters
    ----------
    away : {"distance", "height"}
        Symbol of the length [m] between that point and the rectangle.

    Returns
    -------
    Relation
        Between the projected solid angle [sr], the width and the length [m] and `away` [m].

    Raises
    ------
    ConditionError
        When the relation is solved for a length, if the projected solid angle is not less than that
        of the hemisphere or of an endless strip.

    Notes
    -----
    With a = w / (2 h) and b = l / (2 h)::

        Omega_p = 2 Omega0 (a / sqrt(1 + a^2) arctan(b / sqrt(1 + a^2))
                            + b / sqrt(1 + b^2) arctan(a / sqrt(1 + b^2)))

    Lengths are found by bisection, to the last digit.

    References
    ----------
    J. R. Howell, A Catalog of Radiation Heat Transfer Configuration Factors, B-3.

    Examples
    --------
    >>> above = rectangle_on_axis("height")
    >>> seen = {"width": 1.0, "length": 2.0, "height": 1.5}
    >>> flat = above.solve("projected-solid-angle", seen.get)
    >>> round(flat, 6)
    0.656817
    >>> round(above.solve("length", {**seen, "projected-solid-angle": flat}.get), 9)
    2.0
    """

    def height(part: float, width: float, length: float) -> float:
        geometry.refuse(part >= math.pi * (1 - SLACK), *TOO_MUCH)
        most = least = math.sqrt(width * length / part)
        while solid.projected_rectangle(width, length, least) < part:
            least /= 2
        return limit(lambda h: solid.projected_rectangle(width, length, h) >= part, most, least)

    def side(part: float, other: float, height: float) -> float:
        geometry.refuse(
            part >= math.pi * other / math.hypot(other, 2 * height) * (1 - SLACK),
            "more irradiance than an endless strip of that radiance gives there",
            TOO_MUCH[1],
        )
        least = part * height**2 / other
        most = 2 * least
        while solid.projected_rectangle(most, other, height) <= part:
            most *= 2
        return limit(lambda w: solid.projected_rectangle(w, other, height) <= part, most, least)

    return relation(
        "rectangle on its axis",
        "{projected-solid-angle} = 2 Omega0 (a / sqrt(1 + a^2) arctan(b / sqrt(1 + a^2)) + "
        "b / sqrt(1 + b^2) arctan(a / sqrt(1 + b^2))), "
        f"a = {{width}} / (2 {{{away}}}), b = {{length}} / (2 {{{away}}})",
        {
            "projected-solid-angle": lambda at: solid.projected_rectangle(
                at("width"), at("length"), at(away)
            ),
            away: lambda at: each(height, at("projected-solid-angle"), at("width"), at("length")),
            "width": lambda at: each(side, at("projected-solid-angle"), at("length"), at(away)),
            "length": lambda at: each(side, at("projected-solid-angle"), at("width"), at(away)),
        },
        f"{HOWELL}, B-3",
    )


SPHERE_AT_DISTANCE = relation(
    "sphere, its centre at a distance",
    "{projected-solid-angle} = pi Omega0 ({radius} / {distance})^2",
    {
        "projected-solid-angle": lambda at: solid.projected_sphere(at("radius"), at("distance")),
        "distance": lambda at: at("radius") * sqrt(_hemisphere_over(at)),
        "radius": lambda at: at("distance") / sqrt(_hemisphere_over(at)),
    },
    HOWELL,
)
SPHERE_FLUX = law("flux of a sphere at a distance", "{flux} = 4 pi {distance}^2 {irradiance}")
SPHERE_ENERGY = law("energy of a sphere at a distance", "{energy} = 4 pi {distance}^2 {exposure}")
SPHERE_INTENSITY = law("flux of a sphere", "{flux} = 4 pi Omega0 {intensity}")


MOON = f"{CIE}, traditional overcast sky (Moon and Spencer)"


ISO = "ISO 80000-7, illuminance"


GROUND = law(
    "irradiance of the ground", "{horizontal-irradiance} = {zenith-radiance} {horizontal-sky}", ISO
)


TOWARD = law("radiance in a direction", "{radiance-toward} = {zenith-radiance} {relative-radiance}")


SHARE = law("daylight share", "{plane-sky} = {daylight-share} {horizontal-sky}")


PLANE = law("irradiance of a plane", "{irradiance} = {zenith-radiance} {plane-sky}", ISO)


DIFFUSE = law(
    "irradiance of a plane by the sky", "{diffuse-irradiance} = {zenith-radiance} {plane-sky}", ISO
)


DIRECT = law(
    "irradiance of a plane by the sun", "{direct-irradiance} = {sun-irradiance} {cosine}", ISO
)


def _rest(total: Number, part: Number) -> Number:
    refuse(total < part, "sky and sun together give less than one of them", "less of that one")
    return total - part


BOTH = relation(
    "irradiance of a plane by sky and sun",
    "{irradiance} = {diffuse-irradiance} + {direct-irradiance}",
    {
        "irradiance": lambda at: at("diffuse-irradiance") + at("direct-irradiance"),
        "diffuse-irradiance": lambda at: _rest(at("irradiance"), at("direct-irradiance")),
        "direct-irradiance": lambda at: _rest(at("irradiance"), at("diffuse-irradiance")),
    },
)


GLOBAL = relation(
    "irradiance of the ground by sky and sun",
    "{global-irradiance} = {horizontal-irradiance} + {sun-irradiance} {sun-height}",
    {
        "global-irradiance": lambda at: (
            at("horizontal-irradiance") + at("sun-irradiance") * at("sun-height")
        ),
        "horizontal-irradiance": lambda at: _rest(
            at("global-irradiance"), at("sun-irradiance") * at("sun-height")
        ),
        "sun-irradiance": lambda at: (
            _rest(at("global-irradiance"), at("horizontal-irradiance")) / at("sun-height")
        ),
    },
)


DISC = relation(
    "irradiance of the sun's disc",
    "{sun-irradiance} = pi Omega0 {sun-radiance} sin({sun-radius})^2",
    {
        "sun-irradiance": lambda at: math.pi * at("sun-radiance") * square(sin(at("sun-radius"))),
        "sun-radiance": lambda at: at("sun-irradiance") / (math.pi * square(sin(at("sun-radius")))),
    },
)


LUMINANCE = Formula(
    "luminance of the sky",
    "L / L_z = f(chi) phi(Z) / (f(Z_s) phi(0)), phi(Z) = 1 + a exp(b / cos(Z)), "
    "f(chi) = 1 + c (exp(d chi) - exp(d pi/2)) + e cos(chi)^2",
    CIE,
)


LINEAR = "luminance of the sky", "", "L / L_z = (1 + 2 cos(Z)) / 3", MOON


RELATIVE = Formula(
    "luminance in a direction, relative to the zenith", "{relative-radiance} = L / L_z"
)


HORIZONTAL_SKY = Formula(
    "sky seen by the ground", "{horizontal-sky} = integral of L / L_z cos(Z) domega, over the sky"
)


PLANE_SKY = Formula(
    "sky seen by the plane",
    "{plane-sky} = integral of L / L_z cos(theta) domega, over the sky in front of the plane",
)


SUN_COSINE = Formula(
    "incidence of the sun",
    "{cosine} = max(n . s, 0), where n is the normal of the plane and s the direction of the sun",
)
