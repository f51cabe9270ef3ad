"""Solid angles of spheres, discs, pyramids and small patches, solved both ways.

A sphere is seen from outside.  The angles of a pyramid are full ones from face to face, through the
axis.  The distance of a small flat patch is at least five times its size.
"""

from radcalc.geometry import cones, solid
from radcalc.laws.law import Relation, law, relation
from radcalc.maths import tan

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
