"""Solid angles of shapes: spheres, discs, pyramids, small patches, solved both ways."""

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
    """A disc from a place on its axis, which is so far away: its height, or its distance."""
    return relation(
        "disc on its axis",
        f"{{solid-angle}} = 2 pi (1 - {{{away}}} / sqrt({{{away}}}^2 + {{radius}}^2)) Omega0",
        {
            "solid-angle": lambda at: solid.disc(at("radius"), at(away)),
            "radius": lambda at: at(away) * tan(solid.rim_of(at("solid-angle"))),
            away: lambda at: at("radius") / tan(solid.rim_of(at("solid-angle"))),
        },
    )


PYRAMID = relation(
    "rectangular pyramid",
    "{solid-angle} = 4 arcsin(sin({horizontal}/2) sin({vertical}/2)) Omega0",
    {
        "solid-angle": lambda at: solid.pyramid(at("horizontal"), at("vertical")),
        "horizontal": lambda at: solid.pyramid_side(at("solid-angle"), at("vertical")),
        "vertical": lambda at: solid.pyramid_side(at("solid-angle"), at("horizontal")),
    },
)
PATCH = law("small patch", "{solid-angle} = {area} {cosine-of-source} / {distance}^2 Omega0")
