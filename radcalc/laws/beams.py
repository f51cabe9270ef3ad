"""Beams: of lasers, of small sources of any distribution, through solid angles and etendues.

A Gaussian beam of a laser has a full divergence, its waist at the exit, and diameters at 1/e^2 of
the peak; it follows from w(z)^2 = w_0^2 + (phi z / 2)^2.  The peak of a uniform beam,
1.27 Phi / D_s^2, is also that of a Gaussian beam with diameters at 1/e of the peak.  The limit is
the peak irradiance at the hazard distance, beyond which it is less.  A receiver is a round aperture
on the axis.  A divergence is small: phi d is within 0.6 % of 2 d tan(phi/2) up to 0.25 rad.

The intensities of a small source are a scale times a function of direction: f is a distribution's
value at the angle gamma off the source's axis and the azimuth C about it.  The scale I_1 is the
intensity for f = 1, such as 1 cd in a table of candelas.  Omega_f is the integral of f over all
directions, and the received solid angle that over a disc.  Functions make the laws of one
distribution.

Solid angles of spheres, discs, pyramids and small patches are solved both ways.  A sphere is seen
from outside.  The angles of a pyramid are full ones from face to face, through the axis.  The
distance of a small flat patch is at least five times its size.

The etendue of a beam is that of a uniform radiance, which sends its flux through it without losses.
The projected solid angle is a mean over the area.  The half angle of a cone, the same at every
point, is at most pi/2.  Numerical apertures are in air.  A lens is corrected for coma and focused
at infinity, with an f-number of at least 0.5.  The law of two discs (parallel, on one axis) is
exact at any distance; patches are small against their distance.
"""

import math
import operator
from typing import TYPE_CHECKING, Any

from radcalc import geometry
from radcalc.answer import Formula
from radcalc.geometry import solid
from radcalc.laws import (
    COSINE,
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
from radcalc.laws.point import STRAIGHT, WITHIN
from radcalc.maths import (
    asin,
    atan2,
    cos,
    each,
    expm1,
    hypot,
    is_array,
    larger,
    log1p,
    sin,
    smaller,
    sqrt,
    square,
    tan,
)
from radcalc.quantities.symbols import GAUSSIAN, UNIFORM
from radcalc.units.numbers import EXACT

if TYPE_CHECKING:
    from radcalc.distributions.distribution import Distribution, Pose

SPHERE = relation(
    "sphere, its centre at a distance",
    "sin({half-angle}) = {radius} / {distance}",
    {
        "half-angle": lambda at: solid.angular_radius(at("radius"), at("distance")),
        "radius": lambda at: solid.sphere_radius(at("distance"), geometry.cone(at("half-angle"))),
        "distance": lambda at: solid.sphere_distance(at("radius"), geometry.cone(at("half-angle"))),
    },
)


def disc(away: str) -> Relation:
    """Make the law of the solid angle of a disc from a point on its axis.

    Parameters
    ----------
    away : {"height", "distance"}
        Symbol of the length [m] between that point and the disc.

    Returns
    -------
    Relation
        Between the solid angle [sr], less than 2 pi, the radius [m] and `away` [m].

    Raises
    ------
    ConditionError
        When the relation is solved, if the observer is in the disc's plane, or the solid angle is
        2 pi sr or more.

    Notes
    -----
    ::

        Omega = 2 pi Omega0 (1 - h / sqrt(h^2 + R^2))

    References
    ----------
    F. Paxton, Rev. Sci. Instrum. 30 (1959) 254.

    Examples
    --------
    >>> law = disc("height")
    >>> round(law.solve("solid-angle", {"radius": 1.0, "height": 1.0}.get), 6)
    1.840302
    >>> round(law.solve("radius", {"height": 1.0, "solid-angle": 1.840302}.get), 6)
    1.0
    """
    return relation(
        "disc on its axis",
        f"{{solid-angle}} = 2 pi Omega0 (1 - {{{away}}} / sqrt({{{away}}}^2 + {{radius}}^2))",
        {
            "solid-angle": lambda at: solid.disc(at("radius"), at(away)),
            "radius": lambda at: at(away) * tan(solid.rim_of(at("solid-angle"))),
            away: lambda at: at("radius") / tan(solid.rim_of(at("solid-angle"))),
        },
    )


PYRAMID = relation(
    "rectangular pyramid",
    "{solid-angle} = 4 Omega0 arcsin(sin({horizontal}/2) sin({vertical}/2))",
    {
        "solid-angle": lambda at: solid.pyramid(at("horizontal"), at("vertical")),
        "horizontal": lambda at: solid.pyramid_side(at("solid-angle"), at("vertical")),
        "vertical": lambda at: solid.pyramid_side(at("solid-angle"), at("horizontal")),
    },
)
PATCH = law("small patch", "{solid-angle} = Omega0 {area} {cosine-of-source} / {distance}^2")
ON_SPHERE = law(
    "part of a sphere", "{solid-angle} = Omega0 {area} / {radius}^2", "ISO 80000-3, solid angle"
)


RADIANCE_FLUX = law(
    "flux of a uniform radiance", "{flux} = {radiance} {etendue}", "ISO 80000-7, radiance"
)
PER_AREA = law("etendue per area", "{etendue} = {area} {projected-solid-angle}")
CONE = relation(
    "etendue of a cone",
    "{etendue} = pi Omega0 {area} sin^2({half-angle})",
    {
        "etendue": lambda at: solid.patch_and_cone(at("area"), at("half-angle")),
        "area": lambda at: at("etendue") / geometry.projected_cone(at("half-angle")),
        "half-angle": lambda at: geometry.projected_cone_of(at("etendue") / at("area")),
    },
)
APERTURE = law("etendue of a cone", "{etendue} = pi Omega0 {area} {na}^2")
LENS = law("etendue of a cone", "{etendue} = pi Omega0 {area} / (4 {f-number}^2)")
NUMERICAL_APERTURE = relation(
    "numerical aperture",
    "{na} = sin({half-angle})",
    {"na": lambda at: sin(at("half-angle")), "half-angle": lambda at: asin(at("na"))},
)
F_NUMBER = relation(
    "half angle of a lens's light",
    "sin({half-angle}) = 1 / (2 {f-number})",
    {
        "half-angle": lambda at: asin(1 / (2 * at("f-number"))),
        "f-number": lambda at: 1 / (2 * sin(at("half-angle"))),
    },
)
PATCHES = law(
    "two small patches",
    "{etendue} = Omega0 {area} {cosine-of-source} {receiver-area} {cosine} / {distance}^2",
)
DISCS = relation(
    "two coaxial discs",
    "{etendue} = Omega0 pi^2/2 (S - sqrt(S^2 - 4 {radius}^2 {receiver-radius}^2)), "
    "S = {radius}^2 + {receiver-radius}^2 + {distance}^2",
    {
        "etendue": lambda at: solid.coaxial_discs(
            at("radius"), at("receiver-radius"), at("distance")
        ),
        "distance": lambda at: solid.discs_distance(
            at("radius"), at("receiver-radius"), at("etendue")
        ),
        "radius": lambda at: solid.discs_radius(
            at("receiver-radius"), at("distance"), at("etendue")
        ),
        "receiver-radius": lambda at: solid.discs_radius(
            at("radius"), at("distance"), at("etendue")
        ),
    },
    f"{HOWELL}, C-41",
)
FAR_FIELD = law(
    "far-field etendue of two discs",
    "{far-field-etendue} = Omega0 {area} {receiver-area} / {distance}^2",
)
RECEIVER_CIRCLE = law("area of the receiver", "{receiver-area} = pi {receiver-radius}^2")
RECEIVER_DIAMETER = law("diameter of the receiver", "{receiver-diameter} = 2 {receiver-radius}")


ZONE = Formula(
    "zone of a sphere", "{solid-angle} = 2 Omega0 dphi sin((t0 + t1)/2) sin((t1 - t0)/2)"
)


PROJECTED_ZONE = Formula(
    "projected zone", "{projected-solid-angle} = Omega0 dphi (sin^2(t1) - sin^2(t0)) / 2"
)


DISC_ASIDE = Formula(
    "disc off its axis",
    "{solid-angle} follows from an integral around the rim, given by complete elliptic integrals",
    "F. Paxton, Rev. Sci. Instrum. 30 (1959) 254",
)


PROJECTED_DISC = Formula(
    "projected disc",
    "{projected-solid-angle} = Omega0 pi/2 (1 - ({height}^2 + {offset}^2 - {radius}^2) / "
    "sqrt(({height}^2 + {offset}^2 + {radius}^2)^2 - 4 {radius}^2 {offset}^2))",
    HOWELL,
)


TRIANGLES = Formula(
    "rectangle, as two triangles",
    "tan({solid-angle}/2) = [a b c] / (a b c + (a.b) c + (a.c) b + (b.c) a) for each triangle; "
    "a, b and c are the vectors to its vertices, [a b c] is their triple product, a.b a scalar "
    "product, and a, b or c alone a length",
    "A. van Oosterom, J. Strackee, IEEE Trans. Biomed. Eng. 30 (1983) 125",
)


CONTOUR = Formula(
    "Lambert's contour formula",
    "{projected-solid-angle} = 1/2 sum of beta cos(delta), over the sides",
    "J. H. Lambert, Photometria (1760)",
)


WAIST = "Gaussian beam with its waist at the exit"
PROFILE = "Gaussian beam: E(r) = E_0 exp(-8 r^2 / D_s^2)"
RANGE = "range equation of laser safety"
WIDER = "a wider spot, or less of the diameter, the divergence or the distance"
HAZARD, DISTANCE = "hazard-distance", "distance"
EXIT = law("spot at the laser's exit", "{spot-diameter} = {diameter}")


def _leg(whole: Any, part: Any) -> Any:
    return sqrt((whole - part) * (whole + part))


def _widened(far: Any, near: Any) -> Any:
    geometry.refuse(far < near, "the beam would become narrower with distance", WIDER)
    return far


SPREADS = {  # sum and difference of diameters, template of the formula, and its reference
    GAUSSIAN: (hypot, _leg, "sqrt({diameter}^2 + ({divergence} {%s})^2)", WAIST),
    UNIFORM: (operator.add, operator.sub, "{diameter} + {divergence} {%s}", RANGE),
}


def _spread(profile: str, spot: str, distance: str) -> Relation:
    """Return the law of a beam's diameter; beams wider than their limit have it at the exit."""
    add, take, template, reference = SPREADS[profile]

    def widening(at: At) -> Any:
        return at("divergence") * at(distance)

    def remaining(at: At, part: Any) -> Any:
        return take(_widened(at(spot), part), part)

    def before(at: At) -> Any:
        problem = "the divergence alone makes such a wide spot, even of a beam without width"
        is_all = at(spot) <= widening(at) * (1 + EXACT)
        geometry.refuse(is_all, problem, WIDER)
        return take(at(spot), widening(at))

    def away(at: At) -> Any:
        if distance == HAZARD:
            return take(larger(at(spot), at("diameter")), at("diameter"))
        return remaining(at, at("diameter"))

    return relation(
        f"spread of a {profile} beam",
        f"{{{spot}}} = {template % distance}",
        {
            spot: lambda at: add(at("diameter"), widening(at)),
            "diameter": before,
            "divergence": lambda at: remaining(at, at("diameter")) / at(distance),
            distance: lambda at: away(at) / at("divergence"),
        },
        reference,
    )


def _received_share(at: At) -> Any:
    part = at("received-flux") / at("flux")
    geometry.refuse(part >= 1, "the received flux is not less than the beam's", "less of it")
    return part


def _gaussian_share(at: At) -> Any:
    return -expm1(-2 * square(at("receiver-diameter") / at("spot-diameter")))


def _uniform_share(at: At) -> Any:
    return square(smaller(1.0, at("receiver-diameter") / at("spot-diameter")))


def _aperture_over_spot(at: At) -> Any:
    return sqrt(-log1p(-_received_share(at)) / 2)


RECEIVED = {
    GAUSSIAN: relation(
        "flux of a gaussian beam through an aperture",
        "{received-flux} = {flux} (1 - exp(-2 {receiver-diameter}^2 / {spot-diameter}^2))",
        {
            "received-flux": lambda at: at("flux") * _gaussian_share(at),
            "flux": lambda at: at("received-flux") / _gaussian_share(at),
            "receiver-diameter": lambda at: at("spot-diameter") * _aperture_over_spot(at),
            "spot-diameter": lambda at: at("receiver-diameter") / _aperture_over_spot(at),
        },
        PROFILE,
    ),
    UNIFORM: relation(
        "flux of a uniform beam through an aperture",
        "{received-flux} = {flux} min(1, {receiver-diameter}^2 / {spot-diameter}^2)",
        {
            "received-flux": lambda at: at("flux") * _uniform_share(at),
            "flux": lambda at: at("received-flux") / _uniform_share(at),
            "receiver-diameter": lambda at: at("spot-diameter") * sqrt(_received_share(at)),
            "spot-diameter": lambda at: at("receiver-diameter") / sqrt(_received_share(at)),
        },
    ),
}
SPOT = [
    law("mean irradiance of a spot", "{irradiance} = 4 {flux} / (pi {spot-diameter}^2)"),
    law("mean exposure of a spot", "{exposure} = 4 {energy} / (pi {spot-diameter}^2)"),
    ENERGY,
    EXPOSURE,
]
PEAKS = {
    GAUSSIAN: [
        law(
            "peak of a gaussian beam",
            "{peak-irradiance} = 8 {flux} / (pi {spot-diameter}^2)",
            PROFILE,
        ),
        law("peak over the mean of a gaussian beam", "{peak-irradiance} = 2 {irradiance}", PROFILE),
        law(
            "limit of a gaussian beam's peak",
            "{limit} = 8 {flux} / (pi {limit-diameter}^2)",
            PROFILE,
        ),
    ],
    UNIFORM: [
        law("peak of a uniform beam", "{peak-irradiance} = 4 {flux} / (pi {spot-diameter}^2)"),
        law("peak and mean of a uniform beam", "{peak-irradiance} = {irradiance}"),
        law("limit of a uniform beam", "{limit} = 4 {flux} / (pi {limit-diameter}^2)", RANGE),
    ],
}
SPREAD = {profile: _spread(profile, "spot-diameter", DISTANCE) for profile in SPREADS}
REACH = {profile: _spread(profile, "limit-diameter", HAZARD) for profile in SPREADS}


def laser_laws(profile: str, with_distance: bool) -> list[AnyLaw]:
    """Choose the laws of a beam.

    Parameters
    ----------
    profile : {"gaussian", "uniform"}
        Profile of its irradiance.
    with_distance : bool
        Whether the spot is at a distance, not at the laser's exit.

    Returns
    -------
    list of Law or Relation
        Laws of the spot, its peak, its limit and a receiver.

    Examples
    --------
    >>> laser_laws("uniform", with_distance=False)[0].template
    '{spot-diameter} = {diameter}'
    """
    spread = SPREAD[profile] if with_distance else EXIT
    return [spread, *SPOT, *PEAKS[profile], REACH[profile], RECEIVED[profile]]


PEAK = law("peak intensity", "{peak-intensity} = {scale} {relative-peak-intensity}")
DISTRIBUTION_FLUX = law("flux of a distribution", "{flux} = {scale} {weighted-solid-angle}")
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
DISTRIBUTION_LAWS: list[AnyLaw] = [
    law("intensity on the axis", "{intensity} = {scale} {relative-axial-intensity}"),
    PEAK,
    law("intensity in a direction", "{intensity-toward} = {scale} {relative-intensity}"),
    DISTRIBUTION_FLUX,
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

    >>> from radcalc.distributions.sources import Lobe
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
    >>> from radcalc.distributions.sources import Lobe
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
    >>> from radcalc.distributions.sources import Isotropic
    >>> at = {"irradiance": 1.5, "scale": 250.0, "height": 6.0}.get
    >>> [round(x, 6) for x in floor(Isotropic(), Pose(), 0.0).solve("lateral", at)]
    [8.0]
    """

    def solve(how: str, known: str, at: At) -> Any:
        from radcalc.distributions import scene

        wanted, place = at("irradiance") / at("scale"), at(known)
        refuse_arrays("places", wanted, place, bearing)
        if how == "heights" and place == 0:
            return sqrt(scene.relative_irradiance(distribution, pose, 0.0, 0.0, 1.0) / wanted)
        return Several(getattr(scene, how)(distribution, pose, place, bearing, wanted))

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
    >>> from radcalc.distributions.sources import Lobe
    >>> at = {"receiver-area": math.pi, "height": 1.0, "lateral": 0.0}.get
    >>> disc = lying_disc(Lobe(1.0), Pose(), 0.0)
    >>> round(disc.solve("received-solid-angle", at) / math.pi, 6)
    0.5
    """

    def on_disc(at: At) -> Any:
        from radcalc.distributions.scene import on_plane

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
    >>> from radcalc.distributions.sources import Isotropic
    >>> at = {"receiver-area": 3 * math.pi, "distance": 1.0, "off-axis": 1.0, "azimuth": 0.0}.get
    >>> round(facing_disc(Isotropic()).solve("received-solid-angle", at) / math.pi, 5)
    1.0
    """

    def on_disc(at: At) -> Any:
        from radcalc.distributions.scene import on_facing_disc

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
