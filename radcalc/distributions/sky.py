"""Radiances of the sky: the CIE types, and the traditional overcast sky."""

import math

from radcalc.distributions.distribution import Peak
from radcalc.errors import ConditionError, MissingInput, Unused, mention
from radcalc.geometry import sky as geometry
from radcalc.geometry.directions import Vector
from radcalc.geometry.numerics.cubature import Integral
from radcalc.maths import Number


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

    def irradiance(self, normal: Vector) -> Integral:
        value, error = geometry.projected_sky(self.type, normal, self.sun)
        return Integral(self.zenith * value, self.zenith * error, 0)

    def mean(self) -> float:
        return self.zenith * geometry.mean_sky(self.type, self.sun)[0]

    def peak(self) -> Peak:
        value, polar, azimuth = geometry.brightest(self.type, self.sun)
        return Peak(self.zenith * value, polar, azimuth)
