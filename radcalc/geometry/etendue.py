"""Etendues [m2 sr]: what a uniform radiance is multiplied by to give a flux.

Lengths in metres, areas in square metres, angles in radians; floats or arrays.  All are in a
medium of refractive index 1.
"""

import math

from radcalc.geometry import projected
from radcalc.geometry.solid import facing, refuse
from radcalc.maths import Number, hypot, larger, power_of_two, sqrt


def patch_and_cone(area: Number, half_angle: Number) -> Number:
    """A flat patch and a cone about its normal, up to 90 degrees: pi A sin^2(alpha)."""
    refuse(
        (half_angle < 0) | (half_angle > math.pi / 2 * (1 + 1e-12)),
        "a surface neither sends nor sees light past its horizon",
        "a half angle from 0 to 90 deg",
    )
    return area * projected.cone(half_angle)


def patch_and_aperture(area: Number, na: Number) -> Number:
    """A patch, such as the core of a fibre, and a numerical aperture, in air: pi A NA^2."""
    refuse(
        (na <= 0) | (na > 1),
        "that numerical aperture is not possible",
        "above 0 and, in air, at most 1",
    )
    return math.pi * area * na**2


def patch_and_lens(area: Number, f_number: Number) -> Number:
    """A patch in the focal plane of a lens corrected for coma, sin(alpha) = 1/(2 N).

    pi A / (4 N^2), for f-numbers from 0.5.
    """
    refuse(f_number < 0.5, "that f-number is not possible", "0.5 or more, in air")
    return math.pi * area / (4 * f_number**2)


def two_patches(
    area: Number, other: Number, distance: Number, tilt: Number = 0.0, incidence: Number = 0.0
) -> Number:
    """Two patches that are small beside their distance: A1 cos(t1) A2 cos(t2) / d^2."""
    refuse(distance <= 0, "the patches touch", "a distance above 0")
    return area * facing(tilt) * other * facing(incidence) / distance**2


def coaxial_discs(radius: Number, other: Number, distance: Number) -> Number:
    """Two discs that face each other on one axis, exactly.

    pi^2/2 (S - sqrt(S^2 - 4 r1^2 r2^2)) with S = r1^2 + r2^2 + d^2 (J. R. Howell, A Catalog of
    Radiation Heat Transfer Configuration Factors, C-41), in the form that keeps its digits.
    """
    refuse(distance <= 0, "the discs touch", "a distance above 0")
    scale = power_of_two(larger(larger(radius, other), distance))
    radius, other, distance = radius / scale, other / scale, distance / scale
    root = hypot(distance, radius - other) * hypot(distance, radius + other)
    total = radius**2 + other**2 + distance**2
    return 2 * (math.pi * (radius * (other / sqrt(total + root))) * scale) ** 2
