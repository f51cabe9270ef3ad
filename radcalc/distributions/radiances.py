"""Radiance as a function of the direction that it comes from: a sky, a map or an expression.

Directions are those from a point, in world axes (+z up, azimuths from +x towards +y).  Angles are
in radians, radiances in coherent SI (cd/m2, W/m2/sr, photon/s/m2/sr).
"""

import math
from typing import Any, NamedTuple, Protocol

import numpy

from radcalc.distributions.distribution import ALL_AZIMUTHS, ALL_POLAR, Peak, integrated
from radcalc.distributions.formula import ACCURACY, OF_AXIAL, Formula
from radcalc.errors import ConditionError, MissingInput, Unused, mention
from radcalc.geometry import directions
from radcalc.geometry import sky as geometry
from radcalc.geometry.numerics.cubature import Integral
from radcalc.maths import Number


class Radiances(Protocol):
    """Radiance as a function of the direction that it comes from.

    Attributes
    ----------
    kind : str
        Kind of light: "v" for radiances in cd/m2, "e" for W/m2/sr, "p" for photon/s/m2/sr;
        empty for relative radiances.
    is_axial : bool
        Whether the radiance is known to be the same at every azimuth.
    coverage : float [1]
        Share of the sphere that is covered, by solid angle; the rest is dark.
    """

    @property
    def kind(self) -> str: ...
    @property
    def is_axial(self) -> bool: ...
    @property
    def coverage(self) -> float: ...

    def radiance(self, polar: Number, azimuth: Number) -> Number:
        """Return the radiance [cd/m2, W/m2/sr, photon/s/m2/sr or 1] from directions, 0 or more.

        `polar`, the angle from +z, from 0 to pi, and the azimuth from +x [rad] are broadcast
        together.
        """
        ...

    def irradiance(self, normal: directions.Vector) -> Integral:
        """Return the irradiance [lx, W/m2, photon/s/m2 or sr] of a plane receiver."""
        ...

    def mean(self) -> float:
        """Return the mean radiance, by solid angle, of the covered part."""
        ...

    def peak(self) -> Peak:
        """Return the greatest radiance, and its direction."""
        ...


class FormulaRadiances:
    """Radiances by an expression in theta (polar angle from +z) and phi (azimuth from +x).

    Examples
    --------
    A sky of 3000 cd/m2 gives pi 3000 lx on the ground, and half as much on a wall:

    >>> sky = FormulaRadiances(Formula("3000*(theta < 90*deg)", kind="v"))
    >>> [round(sky.irradiance(n).value, 2) for n in ((0, 0, 1), (1, 0, 0), (0, 0, -1))]
    [9424.78, 4712.39, 0.0]
    """

    coverage = 1.0

    def __init__(self, formula: Formula) -> None:
        self.formula = formula
        self.kind = formula.kind
        self.is_axial = formula.is_axial

    def radiance(self, polar: Number, azimuth: Number) -> Number:
        return self.formula.intensity(polar, azimuth)

    def irradiance(self, normal: directions.Vector) -> Integral:
        forward, left, up = directions.facing(normal)
        is_level = not (forward[0] or forward[1])
        if is_level or self.formula.expression.comparisons:
            return self._in_own_angles(forward, self.formula.is_axial and is_level)
        # about the normal the integrand is smooth: the receiver's horizon does not cross it
        turned = _ReceivedAboutNormal(self.formula, (directions.times(up, -1.0), left, forward))
        return integrated(turned, (0.0, math.pi / 2), ALL_AZIMUTHS, ACCURACY)

    def _in_own_angles(self, normal: directions.Vector, is_axial: bool) -> Integral:
        """Integrate in theta and phi, for which the steps of the expression are known."""
        polar = ALL_POLAR
        if is_axial:
            polar = (0.0, math.pi / 2) if normal[2] > 0 else (math.pi / 2, math.pi)
        steps = self.formula.steps(polar, ALL_AZIMUTHS)
        accuracy = OF_AXIAL if is_axial else ACCURACY
        received = _Received(self.formula, normal, is_axial)
        return integrated(received, polar, ALL_AZIMUTHS, accuracy, steps)

    def mean(self) -> float:
        return self.formula.flux().value / (4 * math.pi)

    def peak(self) -> Peak:
        return self.formula.peak()


class _Received(NamedTuple):
    """The radiance times the cosine of incidence on a receiver."""

    formula: Formula
    normal: directions.Vector
    is_axial: bool

    def intensity(self, theta: Any, phi: Any) -> Any:
        cosine = directions.dot(self.normal, directions.cartesian(theta, phi))
        return self.formula.intensity(theta, phi) * numpy.maximum(cosine, 0.0)


class _ReceivedAboutNormal(NamedTuple):
    """The radiance times the cosine, in angles about the receiver's normal."""

    formula: Formula
    axes: tuple[directions.Vector, directions.Vector, directions.Vector]
    is_axial: bool = False

    def intensity(self, theta: Any, phi: Any) -> Any:
        direction = directions.cartesian(theta, phi)
        polar, azimuth, _ = directions.spherical(*directions.from_components(self.axes, direction))
        return self.formula.intensity(polar, azimuth) * direction[2]


class Sky:
    """Radiances of a sky; see the protocol `radcalc.distributions.radiances.Radiances`.

    The sun itself is not included, and below the horizon the radiance is 0.

    Parameters
    ----------
    name : str
        A name or a number in `radcalc.geometry.sky.NAMES`.
    sun : tuple of 2 floats [rad], optional
        Polar angle and azimuth of the sun, above the horizon; for skies that depend on it.
    zenith : float [cd/m2, W/m2/sr, photon/s/m2/sr or 1], optional
        Radiance at the zenith; 1 by default.
    kind : str, optional
        "v", "e" or "p"; empty, the default, for relative radiances.

    Raises
    ------
    ConditionError
        If there is no such sky, the sun is below the horizon, or the sky does not depend on it.
    MissingInput
        If the sky depends on the sun, and its position is missing.

    Examples
    --------
    An overcast sky of 9000 cd/m2 at the zenith, on the ground and on a wall:

    >>> sky = Sky("overcast", zenith=9000.0, kind="v")
    >>> [round(sky.irradiance(normal).value, 2) for normal in ((0, 0, 1), (1, 0, 0))]
    [21991.15, 8712.39]
    """

    coverage = 0.5

    def __init__(
        self, name: str, sun: tuple[float, float] | None = None, zenith: float = 1.0, kind: str = ""
    ) -> None:
        self.type = geometry.sky_type(name)
        if self.type.follows_sun and sun is None:
            raise MissingInput(*geometry.MISSING_SUN)
        if sun is not None and not self.type.follows_sun:
            raise Unused(("sun-elevation",), geometry.IS_EVEN.format(name))
        if sun is not None and not 0 <= sun[0] <= math.pi / 2:
            raise ConditionError("the sun is below the horizon", mention("{sun-elevation=40deg}"))
        self.sun, self.zenith, self.kind = sun, zenith, kind
        self.is_axial = not self.type.follows_sun

    def radiance(self, polar: Number, azimuth: Number) -> Number:
        return self.zenith * geometry.relative_luminance(self.type, polar, azimuth, self.sun)

    def irradiance(self, normal: directions.Vector) -> Integral:
        value, error = geometry.projected_sky(self.type, normal, self.sun)
        return Integral(self.zenith * value, self.zenith * error, 0)

    def mean(self) -> float:
        return self.zenith * geometry.mean_sky(self.type, self.sun)[0]

    def peak(self) -> Peak:
        value, polar, azimuth = geometry.brightest(self.type, self.sun)
        return Peak(self.zenith * value, polar, azimuth)
