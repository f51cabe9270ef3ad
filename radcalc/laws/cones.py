"""The solid angle [sr] and the projected solid angle [sr] of a circular cone, solved both ways.

Half angles [rad] are at most pi; the projected solid angle is about the normal of the lit surface,
pi Omega0 for half angles above pi/2, and gives half angles of at most pi/2.
"""

from typing import Any

from radcalc.derivation import format_number
from radcalc.geometry import cones
from radcalc.laws.law import law, relation


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
