"""Laws that several subjects share: energy over a time, heat, sizes, cones, incidence.

Energy and exposure are those of light that is constant over a time (ISO 80000-7).  Lengths [m] and
areas [m2] are those of flat sources and receivers, and offsets [m] those of receivers.

Half angles [rad] of a circular cone are at most pi; its projected solid angle [sr] is about the
normal of the lit surface, pi Omega0 for half angles above pi/2, and gives half angles of at most
pi/2.

The heat is that of light in a body that loses no heat, with a constant specific heat capacity, flux
and irradiance.  Watts and joules only: the heat of lumens and photons depends on their spectrum.
"""

from collections.abc import Container
from typing import Any

from radcalc.answer import format_number
from radcalc.geometry import cones
from radcalc.laws.law import AnyLaw, law, relation
from radcalc.maths import acos, piecewise, sqrt, square

ENERGY = law("energy", "{energy} = {flux} {time}")
EXPOSURE = law("exposure", "{exposure} = {irradiance} {time}")
RECTANGLE = law("area of a rectangle", "{area} = {width} {length}")
CIRCLE = law("area of a circle", "{area} = pi {radius}^2")
DIAMETER = law("diameter", "{diameter} = 2 {radius}")
OFFSET = law("offset", "{offset} = {lateral}")


def _aspect(ratio: Any) -> Any:
    """Return the aspect a >= 1 with a + 1/a equal to a ratio."""
    cones.refuse(
        ratio < 2, "the diagonal is too short for that area", "more diagonal, or less area"
    )
    return (ratio + sqrt((ratio - 2) * (ratio + 2))) / 2


ASPECT = relation(
    "aspect of a rectangle, by its area and diagonal",
    "{diagonal}^2 = {area} ({aspect} + 1 / {aspect})",
    {"aspect": lambda at: _aspect(square(at("diagonal")) / at("area"))},
)._replace(has_limit=True)


def round_sizes(given: Container[str]) -> list[AnyLaw]:
    """Choose the laws of a round shape in addition to those of its radius.

    Parameters
    ----------
    given : container of str
        The given symbols.

    Returns
    -------
    list of Law
        The law of the diameter if that is given; otherwise the answer has no diameter.

    Examples
    --------
    >>> [law.template for law in round_sizes(["diameter"])], round_sizes(["radius"])
    (['{diameter} = 2 {radius}'], [])
    """
    return [DIAMETER] if "diameter" in given else []


def _half_angle_of(solid_angle: Any) -> Any:
    cones.refuse(
        solid_angle > cones.FULL * (1 + 1e-9),
        f"no cone has a solid angle of {format_number(solid_angle)} sr: a sphere has 4 pi sr",
        "less flux, or more intensity",
    )
    return cones.cone_of(solid_angle)


CONE = relation(
    "solid angle of a cone",
    "{solid-angle} = 4 pi Omega0 sin^2({half-angle}/2)",
    {
        "solid-angle": lambda at: cones.cone(at("half-angle")),
        "half-angle": lambda at: _half_angle_of(at("solid-angle")),
    },
    "ISO 80000-3, solid angle",
)
PROJECTED_CONE = relation(
    "projected solid angle of a cone",
    "{projected-solid-angle} = pi Omega0 sin^2({half-angle})",
    {
        "projected-solid-angle": lambda at: cones.projected_cone(at("half-angle")),
        "half-angle": lambda at: cones.projected_cone_of(at("projected-solid-angle")),
    },
    "ISO 80000-7, radiance and irradiance",
)
APEX = law("apex angle", "{apex-angle} = 2 {half-angle}")
CONFIGURATION_FACTOR = law(
    "configuration factor", "{configuration-factor} = {projected-solid-angle} / (pi Omega0)"
)


def _incidence_of(cosine: Any) -> Any:
    cones.refuse(
        cosine > 1 + 1e-9,
        f"more light than that intensity sends to that distance (the cosine of the incidence "
        f"would be {format_number(cosine)})",
        "another irradiance, intensity or distance",
    )
    return acos(piecewise(cosine > 1, lambda c: 1.0 + 0 * c, lambda c: c, cosine))


COSINE = relation(
    "cosine of the incidence",
    "{cosine} = cos({incidence})",
    {
        "cosine": lambda at: cones.facing(at("incidence")),
        "incidence": lambda at: _incidence_of(at("cosine")),
    },
)
HEAT_LAWS: list[AnyLaw] = [
    law("heat of a body", "{heat} = {mass} {specific-heat} {temperature-rise}"),
    law("absorbed light", "{heat} = {absorptance} {energy}", "ISO 80000-7, absorptance"),
    ENERGY,
    law("flux on a receiver", "{flux} = {irradiance} {receiver-area}"),
]
