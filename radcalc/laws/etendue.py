"""The etendue of a beam, and the flux that a uniform radiance sends through it."""

import math

from radcalc.geometry import cones, etendue
from radcalc.laws.law import Law, Relation
from radcalc.laws.surface import HOWELL

FLUX = Law(
    "flux of a uniform radiance",
    "{flux} = {radiance} {etendue}",
    "flux",
    (("radiance", 1), ("etendue", 1)),
    reference="ISO 80000-7, radiance",
)
PER_AREA = Law(
    "etendue per area",
    "{etendue} = {area} {projected-solid-angle}",
    "etendue",
    (("area", 1), ("projected-solid-angle", 1)),
)
CONE = Relation(
    "etendue of a cone",
    "{etendue} = pi {area} sin^2({half-angle}) Omega0",
    ("etendue", "area", "half-angle"),
    {
        "etendue": lambda at: etendue.patch_and_cone(at("area"), at("half-angle")),
        "area": lambda at: at("etendue") / cones.projected_cone(at("half-angle")),
        "half-angle": lambda at: cones.projected_cone_of(at("etendue") / at("area")),
    },
)
APERTURE = Law(
    "etendue of a cone",
    "{etendue} = pi {area} {na}^2 Omega0",
    "etendue",
    (("area", 1), ("na", 2)),
    math.pi,
    "sr",
)
LENS = Law(
    "etendue of a cone",
    "{etendue} = pi {area} / (4 {f-number}^2) Omega0",
    "etendue",
    (("area", 1), ("f-number", -2)),
    math.pi / 4,
    "sr",
)
PATCHES = Law(
    "two small patches",
    "{etendue} = {area} {cosine-of-source} {receiver-area} {cosine} / {distance}^2 Omega0",
    "etendue",
    (
        ("area", 1),
        ("cosine-of-source", 1),
        ("receiver-area", 1),
        ("cosine", 1),
        ("distance", -2),
    ),
    1.0,
    "sr",
)
DISCS = Relation(
    "two coaxial discs",
    "{etendue} = pi^2/2 (S - sqrt(S^2 - 4 {radius}^2 {receiver-radius}^2)) Omega0, "
    "S = {radius}^2 + {receiver-radius}^2 + {distance}^2",
    ("etendue", "radius", "receiver-radius", "distance"),
    {
        "etendue": lambda at: etendue.coaxial_discs(
            at("radius"), at("receiver-radius"), at("distance")
        ),
        "distance": lambda at: etendue.discs_distance(
            at("radius"), at("receiver-radius"), at("etendue")
        ),
        "radius": lambda at: etendue.discs_radius(
            at("receiver-radius"), at("distance"), at("etendue")
        ),
        "receiver-radius": lambda at: etendue.discs_radius(
            at("radius"), at("distance"), at("etendue")
        ),
    },
    f"{HOWELL}, C-41",
)
FAR_FIELD = Law(
    "far field of two discs",
    "{far-field-etendue} = {area} {receiver-area} / {distance}^2 Omega0",
    "far-field-etendue",
    (("area", 1), ("receiver-area", 1), ("distance", -2)),
    1.0,
    "sr",
)
RECEIVER_CIRCLE = Law(
    "area of the receiver",
    "{receiver-area} = pi {receiver-radius}^2",
    "receiver-area",
    (("receiver-radius", 2),),
    math.pi,
)
RECEIVER_DIAMETER = Law(
    "diameter of the receiver",
    "{receiver-diameter} = 2 {receiver-radius}",
    "receiver-diameter",
    (("receiver-radius", 1),),
    2.0,
)
