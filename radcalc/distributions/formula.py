"""Distributions by formulas: expressions in theta and phi, and exact shapes.

The shapes are relative to the intensity on the axis.
"""

import math
from functools import cached_property
from typing import Any

import numpy

from radcalc.distributions.distribution import (
    ALL_AZIMUTHS,
    ALL_POLAR,
    Distribution,
    Interval,
    Peak,
    integrated,
)
from radcalc.errors import ConditionError, Hint, correct, quote
from radcalc.geometry import cones
from radcalc.geometry.directions import TURN, cartesian
from radcalc.geometry.numerics.cubature import ROUNDING, Integral, Steps, narrowest
from radcalc.geometry.numerics.expression import Expression
from radcalc.geometry.solid import zone
from radcalc.maths import Number
from radcalc.quantities.symbols import DISTRIBUTIONS

ACCURACY, OF_AXIAL = 1e-6, 1e-9  # [1] of a flux; axial ones are cheap
NEGATIVE = 1e-12  # [1] of the greatest value: rounding errors of 0
# Polar angles and azimuths in the first search for the peak: as close as the integral's own
# points.
FIRST, FIRST_OF_AXIAL = (361, 721), (7201, 1)
CLOSER = (21, 21)  # in each refinement
NARROWER = 8  # refinements, each to a tenth of the width
_, CONICAL, LOBED = DISTRIBUTIONS


class Formula:
    """An intensity as an expression, of `radcalc.geometry.numerics.expression`.

    Parameters
    ----------
    text : str
        The expression; theta is the polar angle from the axis, phi the azimuth about it [rad].
    factor : float, optional
        Factor that converts the values to coherent SI; 1 by default.
    kind : str, optional
        "v" for candelas, "e" or "p"; empty, the default, for relative values.
    unit, quantity : str, optional
        Those of the values, for messages.

    Attributes
    ----------
    unseen : float [rad]
        Narrower peaks may be missed.

    Raises
    ------
    ConditionError
        If the text is not an expression; on evaluation, if a value is negative or not finite.

    Examples
    --------
    A flux of 2 pi 100 / (10 + 1) lm:

    >>> lamp = Formula("100*max(cos(theta), 0)^10", kind="v")
    >>> round(lamp.flux().value, 4)
    57.1199
    """

    def __init__(
        self,
        text: str,
        factor: float = 1.0,
        kind: str = "",
        unit: str = "",
        quantity: str = "intensity",
    ) -> None:
        self.text = text
        self.unit = unit
        self.kind = kind
        self.quantity = quantity
        self.factor = factor
        self.expression = Expression(text)
        self.is_axial = self.expression.is_axial
        self.unseen = max(narrowest(ALL_POLAR, ALL_AZIMUTHS, self.is_axial))

    def intensity(self, theta: Number, phi: Number) -> Number:
        """Return the intensity; raise a ConditionError if it is negative or not finite."""
        phi = phi % TURN  # an expression need not be periodic
        x, y, z = cartesian(theta, phi)
        at: dict[str, Any] = {"theta": theta, "phi": phi, "x": x, "y": y, "z": z}
        with numpy.errstate(all="ignore"):
            values = self.expression(at) * self.factor + 0.0 * (theta + phi)
            least, most = numpy.min(values, initial=0.0), numpy.max(abs(values), initial=0.0)
        if not numpy.isfinite(most):
            self._refuse("no finite value", ~numpy.isfinite(values), theta, phi, "a finite number")
        if least < -NEGATIVE * most:
            self._refuse(
                "a negative value",
                values < -NEGATIVE * most,
                theta,
                phi,
                correct(self.text, f"max({self.text}, 0)"),
            )
        return numpy.maximum(values, 0.0)

    def _refuse(self, what: str, bad: Any, theta: Any, phi: Any, hint: Hint) -> None:
        bad, theta, phi = numpy.broadcast_arrays(bad, theta, phi)
        place = tuple(numpy.argwhere(bad)[0])
        angles = ", ".join(
            f"{name} = {math.degrees(angle[place]):.6g} deg"
            for name, angle in (("theta", theta), ("phi", phi))
        )
        raise ConditionError(
            f"the {self.quantity} '{quote(self.text)}' has {what} at {angles}", hint
        )

    @cached_property
    def finest(self) -> float:
        """Return the smallest width above half of the peak, in the peak's plane."""
        peak, count = self.peak(), FIRST_OF_AXIAL[0]
        theta = numpy.linspace(*ALL_POLAR, count)
        bright = self.intensity(theta, peak.azimuth) >= peak.value / 2
        ends = numpy.flatnonzero(numpy.diff(numpy.concatenate([[False], bright, [False]])))
        widths = ends[1::2] - ends[::2]
        return float(widths.min(initial=count)) * math.pi / (count - 1) or self.unseen

    def flux(self, polar: Interval = ALL_POLAR, azimuth: Interval = ALL_AZIMUTHS) -> Integral:
        accuracy = OF_AXIAL if self.is_axial else ACCURACY
        return integrated(self, polar, azimuth, accuracy, self.steps(polar, azimuth))

    def steps(self, polar: Interval, azimuth: Interval) -> Steps:
        """Return polar angles and azimuths at which an integral must be divided.

        These are the angles at which comparisons change, and limits around a narrow peak.
        """
        thetas, phis = self.expression.steps(polar, azimuth)
        width = self.finest
        if self.is_axial or width >= 2 * self.unseen:
            return thetas, phis
        peak = self.peak()
        aside = width / max(math.sin(peak.polar), width)
        around = [(peak.azimuth + k * aside) % TURN for k in (-1, 1)]
        return [*thetas, peak.polar - width, peak.polar + width], [*phis, *around]

    def peak(self) -> Peak:
        return self._peak

    @cached_property
    def _peak(self) -> Peak:
        """Search the peak on a grid, and again on finer grids around it."""
        polar, azimuth = ALL_POLAR, ALL_AZIMUTHS
        counts = FIRST_OF_AXIAL if self.is_axial else FIRST
        best = Peak(-math.inf, 0.0, 0.0)
        for _ in range(NARROWER):
            theta, phi = numpy.linspace(*polar, counts[0]), numpy.linspace(*azimuth, counts[1])
            if self.is_axial:
                phi = phi[:1] * 0.0
            values = self.intensity(theta[:, None], phi)
            row, column = numpy.unravel_index(numpy.argmax(values), values.shape)
            if values[row, column] > best.value:
                best = Peak(float(values[row, column]), float(theta[row]), float(phi[column]))
            steps = [
                (high - low) / max(count - 1, 1)
                for (low, high), count in zip((polar, azimuth), counts, strict=True)
            ]
            polar = (max(0.0, best.polar - steps[0]), min(math.pi, best.polar + steps[0]))
            azimuth = (best.azimuth - steps[1], best.azimuth + steps[1])
            counts = CLOSER
        return best._replace(azimuth=best.azimuth % TURN)


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
