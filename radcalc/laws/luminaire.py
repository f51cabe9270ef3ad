"""A small source of any distribution: its intensities are a scale times a function of direction.

f is a distribution's value at the angle gamma off the source's axis and the azimuth C about it.
The scale I_1 is the intensity for f = 1, such as 1 cd in a table of candelas.  Omega_f is the
integral of f over all directions, and the received solid angle that over a disc.

Functions make the laws of one distribution.
"""

import math
from typing import TYPE_CHECKING, Any

from radcalc.laws.common import COSINE, ENERGY, EXPOSURE
from radcalc.laws.law import AnyLaw, At, Relation, Several, law, refuse_arrays, relation
from radcalc.laws.point import STRAIGHT, WITHIN
from radcalc.maths import atan2, cos, each, is_array, sin, sqrt, tan

if TYPE_CHECKING:
    from radcalc.distributions.distribution import Distribution, Pose

PEAK = law("peak intensity", "{peak-intensity} = {scale} {relative-peak-intensity}")
FLUX = law("flux of a distribution", "{flux} = {scale} {weighted-solid-angle}")
TOWARD = law(
    "inverse square law, in a direction",
    "{irradiance} = {intensity-toward} {cosine} Omega0 / {distance}^2",
    "ISO 80000-7, intensity and irradiance",
)
TOWARD_OF_ENERGY = law(
    "inverse square law, of an energy, in a direction",
    "{exposure} = {energy} {relative-intensity} {cosine} Omega0 / "
    "({weighted-solid-angle} {distance}^2)",
)
LAWS: list[AnyLaw] = [
    law("intensity on the axis", "{intensity} = {scale} {relative-axial-intensity}"),
    PEAK,
    law("intensity in a direction", "{intensity-toward} = {scale} {relative-intensity}"),
    FLUX,
    TOWARD,
    EXPOSURE,
    ENERGY,
    COSINE,
    STRAIGHT,
    WITHIN,
    law("flux upwards", "{upward-flux} = {flux} {upward-part}"),
    relation(
        "flux downwards",
        "{downward-flux} = {flux} (1 - {upward-part})",
        {"downward-flux": lambda at: at("flux") * (1 - at("upward-part"))},
    ),
    law("flux on a receiver in a distribution", "{received-flux} = {scale} {received-solid-angle}"),
]
FLAT = relation(
    "a receiver that lies flat, under any source",
    "{incidence} = atan({lateral} / {height})",
    {"incidence": lambda at: atan2(at("lateral"), at("height"))},
)
SMALL = law(
    "a small receiver that is turned",
    "{received-solid-angle} = {relative-intensity} {receiver-area} {cosine} Omega0 / {distance}^2",
)


def _float_if_scalar(x: Any) -> Any:
    return x if is_array(x) and x.ndim else float(x)


def part(distribution: "Distribution", whole: float) -> Relation:
    """Make the law of the flux within an angle of the axis.

    Parameters
    ----------
    distribution : Distribution
        Of any form.
    whole : float [sr]
        Its integral over all directions.

    Returns
    -------
    Relation
        Between `part` and `within`.

    Examples
    --------
    Half of the flux of a Lambertian source is within 45 degrees:

    >>> from radcalc.distributions.formula import Lobe
    >>> within = part(Lobe(1.0), math.pi)
    >>> round(within.solve("part", {"within": math.pi / 4}.get), 9)
    0.5
    """

    def of(angle: float) -> float:
        return distribution.flux((0.0, angle)).value / whole

    return relation(
        "part of a distribution",
        "{part} = integral of f within {within} / Omega_f",
        {"part": lambda at: each(of, at("within"))},
    )


def relative_intensity(distribution: "Distribution") -> Relation:
    """Make the law of a distribution's value in a direction.

    Parameters
    ----------
    distribution : Distribution
        Of any form.

    Returns
    -------
    Relation
        Between `relative-intensity`, `off-axis` and `azimuth`.

    Examples
    --------
    >>> from radcalc.distributions.formula import Lobe
    >>> value = relative_intensity(Lobe(2.0))
    >>> round(value.solve("relative-intensity", {"off-axis": math.pi / 4, "azimuth": 0.0}.get), 9)
    0.5
    """
    return relation(
        "distribution in a direction",
        "{relative-intensity} = f at {off-axis} and {azimuth}",
        {
            "relative-intensity": lambda at: _float_if_scalar(
                distribution.intensity(at("off-axis"), at("azimuth"))
            )
        },
    )


def direction(pose: "Pose", bearing: Any) -> list[AnyLaw]:
    """Make the laws of the direction from a source to a receiver below it.

    Parameters
    ----------
    pose : Pose
        Aim and rotation of the source.
    bearing : float or ndarray [rad]
        Azimuth of the receiver about the point below the source, from x towards y.

    Returns
    -------
    list of Relation
        Between `off-axis` or `azimuth`, `height` and `lateral`.

    Examples
    --------
    >>> from radcalc.distributions.distribution import Pose
    >>> off_axis, azimuth = direction(Pose(), math.pi / 2)
    >>> at = {"height": 1.0, "lateral": 1.0}.get
    >>> round(off_axis.solve("off-axis", at) / math.pi, 9)
    0.25
    >>> round(azimuth.solve("azimuth", at) / math.pi, 9)
    0.5
    """

    def angles(at: At) -> tuple[Any, Any, Any]:
        x, y = at("lateral") * cos(bearing), at("lateral") * sin(bearing)
        return pose.angles((x, y, 0.0 - at("height")))

    return [
        relation(
            "angle off the axis, of a receiver",
            "{off-axis} = angle of {height} below and {lateral} sideways",
            {"off-axis": lambda at: angles(at)[0]},
        ),
        relation(
            "azimuth about the axis, of a receiver",
            "{azimuth} = azimuth of {height} below and {lateral} sideways",
            {"azimuth": lambda at: angles(at)[1]},
        ),
    ]


def floor(distribution: "Distribution", pose: "Pose", bearing: Any) -> Relation:
    """Make the law of the light on a floor, solved for its place.

    Parameters
    ----------
    distribution : Distribution
        Of any form.
    pose, bearing
        As in `direction`.

    Returns
    -------
    Relation
        Between `irradiance`, `scale`, `height` and `lateral`, solved for the last two.

    Raises
    ------
    ConditionError
        When the relation is solved for arrays, or for an irradiance that no place has.

    Examples
    --------
    >>> from radcalc.distributions.distribution import Pose
    >>> from radcalc.distributions.formula import Isotropic
    >>> at = {"irradiance": 1.5, "scale": 250.0, "height": 6.0}.get
    >>> [round(x, 6) for x in floor(Isotropic(), Pose(), 0.0).solve("lateral", at)]
    [8.0]
    """

    def solve(how: str, known: str, at: At) -> Any:
        from radcalc.distributions import places

        wanted, place = at("irradiance") / at("scale"), at(known)
        refuse_arrays("places", wanted, place, bearing)
        if how == "heights" and place == 0:
            return sqrt(places.relative_irradiance(distribution, pose, 0.0, 0.0, 1.0) / wanted)
        return Several(getattr(places, how)(distribution, pose, place, bearing, wanted))

    return relation(
        "illuminance of a floor under a distribution",
        "{irradiance} = {scale} f {height} Omega0 / ({height}^2 + {lateral}^2)^(3/2)",
        {
            "lateral": lambda at: solve("laterals", "height", at),
            "height": lambda at: solve("heights", "lateral", at),
        },
    )


def lying_disc(distribution: "Distribution", pose: "Pose", bearing: Any) -> Relation:
    """Make the law of the light on a receiver that lies flat below a source.

    Parameters
    ----------
    distribution : Distribution
        Of any form.
    pose, bearing
        As in `direction`.

    Returns
    -------
    Relation
        Between `received-solid-angle`, `receiver-area`, `height` and `lateral`.

    Examples
    --------
    A disc with its rim at 45 degrees receives half of the flux of a Lambertian source:

    >>> from radcalc.distributions.distribution import Pose
    >>> from radcalc.distributions.formula import Lobe
    >>> at = {"receiver-area": math.pi, "height": 1.0, "lateral": 0.0}.get
    >>> disc = lying_disc(Lobe(1.0), Pose(), 0.0)
    >>> round(disc.solve("received-solid-angle", at) / math.pi, 6)
    0.5
    """

    def on_disc(at: At) -> Any:
        from radcalc.distributions.places import on_plane

        x, y = at("lateral") * cos(bearing), at("lateral") * sin(bearing)
        radius = sqrt(at("receiver-area") / math.pi)
        return _float_if_scalar(on_plane(distribution, pose, radius, x, y, at("height")))

    return relation(
        "a receiver in a distribution, flat",
        "{received-solid-angle} = integral of f cos(theta) / r^2, "
        "over a disc of {receiver-area}, {height} below and {lateral} sideways",
        {"received-solid-angle": on_disc},
    )


def facing_disc(distribution: "Distribution") -> Relation:
    """Make the law of the light on a receiver that faces a source.

    Parameters
    ----------
    distribution : Distribution
        Of any form.

    Returns
    -------
    Relation
        Between `received-solid-angle`, `receiver-area`, `distance`, `off-axis` and `azimuth`.

    Examples
    --------
    >>> from radcalc.distributions.formula import Isotropic
    >>> at = {"receiver-area": 3 * math.pi, "distance": 1.0, "off-axis": 1.0, "azimuth": 0.0}.get
    >>> round(facing_disc(Isotropic()).solve("received-solid-angle", at) / math.pi, 5)
    1.0
    """

    def on_disc(at: At) -> Any:
        from radcalc.distributions.places import on_facing_disc

        radius = sqrt(at("receiver-area") / math.pi)
        place = map(at, ("distance", "off-axis", "azimuth"))
        return _float_if_scalar(on_facing_disc(distribution, radius, *place))

    return relation(
        "a receiver in a distribution, facing it",
        "{received-solid-angle} = integral of f cos(theta) / r^2, "
        "over a disc of {receiver-area} at {distance}, towards {off-axis} and {azimuth}",
        {"received-solid-angle": on_disc},
    )


def beam_diameter(edges: tuple[float, float], away: str) -> Relation:
    """Make the law of the width of a beam.

    Parameters
    ----------
    edges : tuple of 2 floats [rad]
        Angles between the axis and the edges of the beam, on its two sides.
    away : str
        Symbol of the distance along the axis: `height` or `distance`.

    Returns
    -------
    Relation
        Between `beam-diameter` and that symbol.

    Examples
    --------
    >>> width = beam_diameter((-math.pi / 4, math.pi / 4), "height")
    >>> round(width.solve("beam-diameter", {"height": 3.0}.get), 9)
    6.0
    """
    width = tan(edges[1]) - tan(edges[0])
    return relation(
        "diameter of the beam",
        f"{{beam-diameter}} = {{{away}}} (tan(b) - tan(a))",
        {"beam-diameter": lambda at: at(away) * width},
    )
