"""Distributions with exact formulas, relative to the intensity on the axis."""

import math

import numpy

from radcalc.distributions.distribution import ALL_AZIMUTHS, ALL_POLAR, Distribution, Interval, Peak
from radcalc.geometry import cones
from radcalc.geometry.numerics.cubature import ROUNDING, Integral
from radcalc.geometry.solid import zone
from radcalc.maths import Number
from radcalc.quantities.symbols import DISTRIBUTIONS

_, CONICAL, LOBED = DISTRIBUTIONS


def of_shape(shape: str, width: float | None = None) -> Distribution:
    """Return a distribution by its shape: "isotropic", "cone" or "lobe".

    `width` is the half angle of a cone [rad], or the exponent of a lobe.
    """
    if shape == LOBED and width is not None:
        return Lobe(width)
    return Cone(width) if shape == CONICAL and width is not None else Isotropic()


class _Axial:
    """A distribution that is greatest on the axis."""

    kind = ""
    is_axial = True
    finest = math.pi

    def peak(self) -> Peak:
        return Peak(1.0, 0.0, 0.0)


class Isotropic(_Axial):
    """The same intensity in all directions.

    Examples
    --------
    >>> round(Isotropic().flux().value / math.pi, 12)
    4.0
    """

    def intensity(self, theta: Number, phi: Number) -> Number:
        return numpy.ones(numpy.broadcast_shapes(numpy.shape(theta), numpy.shape(phi)))

    def flux(self, polar: Interval = ALL_POLAR, azimuth: Interval = ALL_AZIMUTHS) -> Integral:
        return _exactly(zone(*polar, azimuth[1] - azimuth[0]))


class Cone(_Axial):
    """The same intensity up to an angle from the axis, and 0 beyond.

    `half_angle` [rad] is that of its edge from the axis, above 0 and up to pi.

    Examples
    --------
    >>> round(Cone(math.pi / 3).flux().value / math.pi, 12)
    1.0
    """

    def __init__(self, half_angle: float) -> None:
        cones.cone(half_angle)  # raises an error if it is out of range
        self.half_angle = self.finest = half_angle

    def intensity(self, theta: Number, phi: Number) -> Number:
        return (theta <= self.half_angle) * (1.0 + 0.0 * phi)

    def flux(self, polar: Interval = ALL_POLAR, azimuth: Interval = ALL_AZIMUTHS) -> Integral:
        low, high = polar[0], min(polar[1], self.half_angle)
        return _exactly(zone(low, high, azimuth[1] - azimuth[0]) if low < high else 0.0)


class Lobe(_Axial):
    """Intensity that falls as a power of the cosine, up to 90 degrees from the axis.

    Examples
    --------
    >>> round(Lobe(3.0).flux().value / math.pi, 12)
    0.5
    """

    def __init__(self, exponent: float) -> None:
        cones.lobe(exponent)  # raises an error if it is out of range
        self.exponent = exponent
        self.finest = cones.lobe_angle(exponent, 0.5) / 2

    def intensity(self, theta: Number, phi: Number) -> Number:
        ahead = numpy.asarray(theta) <= math.pi / 2
        return numpy.maximum(numpy.cos(theta), 0.0) ** self.exponent * ahead + 0.0 * phi

    def flux(self, polar: Interval = ALL_POLAR, azimuth: Interval = ALL_AZIMUTHS) -> Integral:
        inner, outer = (cones.lobe_part(self.exponent, angle) for angle in polar)
        turn = (azimuth[1] - azimuth[0]) / (2 * math.pi)
        return _exactly(cones.lobe(self.exponent) * (outer - inner) * turn)


def _exactly(value: float) -> Integral:
    return Integral(value, ROUNDING * value, 0)
