"""Solid angles of spheres, discs, pyramids and small patches, and etendues, solved both ways.

A sphere is seen from outside.  The angles of a pyramid are full ones from face to face, through the
axis.  The distance of a small flat patch is at least five times its size.

The etendue of a beam is that of a uniform radiance, which sends its flux through it without losses.
The projected solid angle is a mean over the area.  The half angle of a cone, the same at every
point, is at most pi/2.  Numerical apertures are in air.  A lens is corrected for coma and focused
at infinity, with an f-number of at least 0.5.  The law of two discs (parallel, on one axis) is
exact at any distance; patches are small against their distance.
"""

from radcalc.answer import Formula
from radcalc.geometry import cones, projected, solid
from radcalc.laws.law import HOWELL, Relation, law, relation
from radcalc.maths import asin, sin, tan

SPHERE = relation(
    "sphere, its centre at a distance",
    "sin({half-angle}) = {radius} / {distance}",
    {
        "half-angle": lambda at: solid.angular_radius(at("radius"), at("distance")),
        "radius": lambda at: solid.sphere_radius(at("distance"), cones.cone(at("half-angle"))),
        "distance": lambda at: solid.sphere_distance(at("radius"), cones.cone(at("half-angle"))),
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


FLUX = law("flux of a uniform radiance", "{flux} = {radiance} {etendue}", "ISO 80000-7, radiance")
PER_AREA = law("etendue per area", "{etendue} = {area} {projected-solid-angle}")
CONE = relation(
    "etendue of a cone",
    "{etendue} = pi Omega0 {area} sin^2({half-angle})",
    {
        "etendue": lambda at: projected.patch_and_cone(at("area"), at("half-angle")),
        "area": lambda at: at("etendue") / cones.projected_cone(at("half-angle")),
        "half-angle": lambda at: cones.projected_cone_of(at("etendue") / at("area")),
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
        "etendue": lambda at: projected.coaxial_discs(
            at("radius"), at("receiver-radius"), at("distance")
        ),
        "distance": lambda at: projected.discs_distance(
            at("radius"), at("receiver-radius"), at("etendue")
        ),
        "radius": lambda at: projected.discs_radius(
            at("receiver-radius"), at("distance"), at("etendue")
        ),
        "receiver-radius": lambda at: projected.discs_radius(
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
