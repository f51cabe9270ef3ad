"""The etendue of a beam, and the flux that a uniform radiance sends through it without losses.

The projected solid angle is a mean over the area.  The half angle of a cone, the same at every
point, is at most pi/2.  Numerical apertures are in air.  A lens is corrected for coma and focused
at infinity, with an f-number of at least 0.5.  The law of two discs (parallel, on one axis) is
exact at any distance; patches are small against their distance.
"""

from radcalc.geometry import cones, projected
from radcalc.laws.law import HOWELL, law, relation
from radcalc.maths import asin, sin

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
