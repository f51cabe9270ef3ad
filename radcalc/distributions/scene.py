"""The irradiance from several sources at their positions.

Positions are in metres, in world coordinates (`Pose` of `radcalc.distributions.distribution`).
"""

import math
from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

import numpy

from radcalc.distributions.distribution import Distribution, Pose
from radcalc.errors import ConditionError, option, quote
from radcalc.geometry import cones, directions, projected
from radcalc.geometry.directions import Vector, cross, dot, length, minus

NEAREST = 1e-6  # [m] a point must be farther than this from a source
BLOCK = 1 << 16  # points at a time
RECTANGLE = ((-1, -1), (1, -1), (1, 1), (-1, 1))  # corners, in half sides


class Emitter:
    """A source that is small compared with its distance, at its position.

    Intensities times `factor` are in coherent SI.  `size` [m] is 0 if it is not known; with
    `is_patch`, a surface, points nearer than five times its size are refused.

    Examples
    --------
    100 cd in all directions, 2 m above the origin:

    >>> from radcalc.distributions.formula import Isotropic
    >>> lamp = Emitter("lamp", (0.0, 0.0, 2.0), Pose(), Isotropic(), 100.0)
    >>> points = tuple(numpy.zeros((3, 1)))
    >>> lamp.irradiance(points, (0.0, 0.0, 1.0)).tolist()
    [25.0]
    """

    def __init__(
        self,
        name: str,
        place: Vector,
        pose: Pose,
        distribution: Distribution,
        factor: float = 1.0,
        size: float = 0.0,
        is_patch: bool = False,
    ) -> None:
        self.name, self.place, self.pose = name, place, pose
        self.distribution, self.factor = distribution, factor
        self.size, self.is_patch = size, is_patch

    def irradiance(self, points: Vector, normal: Vector) -> Any:
        """Return the irradiance E = I(gamma, C) cos(theta) Omega0 / d^2 at points.

        It is negative for light from behind the receiver.

        Parameters
        ----------
        points : tuple of 3 ndarrays of shape (n,) [m]
            Coordinates.
        normal : tuple of 3 floats [1]
            Unit normal of the receivers.

        Returns
        -------
        ndarray of shape (n,) [lx, W/m^2 or photon/s/m^2]

        Raises
        ------
        ConditionError
            If a point is at the source, or too near a patch.
        """
        intensity, cosine, distance = self.terms(points, normal)
        return intensity * cosine / (distance * distance)

    def terms(self, points: Vector, normal: Vector) -> tuple[Any, Any, Any]:
        """Return the intensity towards points, the cosine of incidence, and the distance."""
        to = minus(points, self.place)
        distance = length(to)
        _refuse(distance <= NEAREST, points, f"is at the position of {self.name}", "another point")
        if self.is_patch:
            _refuse(
                cones.nearer(distance, self.size),
                points,
                f"is nearer than five times its size ({self.size:.3g} m) to {self.name}",
                "its width and length in place of its area, which holds at any distance",
            )
        if self.distribution.is_axial:  # any azimuth gives the same
            axis = self.pose.axes[2]
            theta, phi = numpy.arctan2(length(cross(axis, to)), dot(axis, to)), 0.0
        else:
            theta, phi, _ = self.pose.angles(to)
        try:
            intensity = self.factor * self.distribution.intensity(theta, phi)
        except ConditionError as error:  # from an expression
            raise error.reworded(f"{self.name}: {error.message}") from None
        return intensity, -dot(normal, to) / distance, distance

    def near(self, points: Vector) -> Any:
        """Return which points are nearer than five times the size."""
        return cones.nearer(length(minus(points, self.place)), self.size)


class Panel:
    """A rectangle of uniform luminance that emits on one side; exact at any distance.

    `place` [m] is its centre; `width` and `length_` [m] are its sides along C0 and C90.

    Examples
    --------
    A wide ceiling of 100 cd/m2 gives pi times that below it:

    >>> panel = Panel("ceiling", (0.0, 0.0, 1.0), Pose(), 1e6, 1e6, 100.0)
    >>> points = tuple(numpy.zeros((3, 1)))
    >>> round(float(panel.irradiance(points, (0.0, 0.0, 1.0))[0] / math.pi), 3)
    100.0
    """

    size = 0.0

    def __init__(
        self, name: str, place: Vector, pose: Pose, width: float, length_: float, radiance: float
    ) -> None:
        self.name, self.place, self.pose, self.radiance = name, place, pose, radiance
        self.half = (width / 2, length_ / 2)

    def irradiance(self, points: Vector, normal: Vector) -> Any:
        """Return the irradiance E = L Omega_p at points; see `Emitter.irradiance`.

        Omega_p is the projected solid angle of the part of the panel above their horizon, by
        Lambert's contour formula.  It is negative if all of the panel is below.
        """
        return self.radiance * self.projected_solid_angle(points, normal)

    def projected_solid_angle(self, points: Vector, normal: Vector) -> Any:
        """Return the projected solid angle [sr], with the sign of `irradiance`."""
        to = minus(points, self.place)
        across, along, ahead = (dot(axis, to) for axis in self.pose.axes)
        inside = (abs(across) <= self.half[0]) & (abs(along) <= self.half[1])
        on_it = inside & (abs(ahead) <= NEAREST)
        _refuse(on_it, points, f"is on {self.name}", "another point")
        corners = [self.pose.world((a * self.half[0], b * self.half[1], 0.0)) for a, b in RECTANGLE]
        highest = numpy.max([dot(normal, corner) for corner in corners], axis=0)
        seen = (ahead > 0) & (highest > dot(normal, to))
        solid_angles = numpy.where((ahead > 0) & ~seen, -1.0, 0.0)
        if numpy.any(seen):
            lit: Any = tuple(x[seen] for x in to)
            solid_angles[seen] = projected.polygon(
                [minus(corner, lit) for corner in corners], normal
            )
        return solid_angles

    def near(self, points: Vector) -> Any:
        """Return which points are too near: none."""
        return numpy.zeros(len(points[0]), bool)


Source = Emitter | Panel


def _refuse(bad: Any, points: Vector, problem: str, hint: str) -> None:
    if numpy.any(bad):
        k = int(numpy.argmax(bad))
        raise ConditionError(
            f"the point {point_text(*(float(x[k]) for x in points))} {problem}", hint
        )


def point_text(x: float, y: float, z: float) -> str:
    """Return a point for a message, as the user types it.

    >>> point_text(1.0, 0.25, -0.0)
    '1,0.25,0'
    """
    return quote(",".join(f"{c + 0.0:.12g}" for c in (x, y, z)))


def unit(normal: Vector) -> Vector:
    """Return a normal scaled to length 1; raise a ConditionError if it is 0 or not finite."""
    if not any(normal) or not math.isfinite(sum(normal)):
        raise ConditionError("a normal needs a finite length above 0", option("normal", "0,0,1"))
    return directions.unit(normal)


class Field(NamedTuple):
    """The irradiance at points from all sources.

    Attributes
    ----------
    points : tuple of 3 ndarrays of shape (n,) [m]
    total : ndarray of shape (n,) [lx, W/m^2 or photon/s/m^2]
    parts : list of ndarrays of shape (n,)
        Irradiance from each source; empty unless requested.
    behind : int
        Number of points with light from behind the receiver, which does not count.
    near : tuple of int
        For each source, the number of points nearer than five times its size.
    """

    points: Vector
    total: Any
    parts: list[Any]
    behind: int
    near: tuple[int, ...]


def field(
    sources: Sequence[Source], points: Vector, normal: Vector, with_parts: bool = False
) -> Field:
    """Return the irradiance at points, summed over sources of one kind of light.

    Parameters and errors are those of `Emitter.irradiance`; `with_parts` keeps the irradiance
    from each source.

    Examples
    --------
    >>> from radcalc.distributions.formula import Isotropic
    >>> lamps = [Emitter(k, (k, 0.0, 2.0), Pose(), Isotropic(), 100.0) for k in (0.0, 0.0)]
    >>> field(lamps, tuple(numpy.zeros((3, 1))), (0.0, 0.0, 1.0)).total.tolist()
    [50.0]
    """
    total = numpy.zeros(len(points[0]))
    behind = numpy.zeros(len(points[0]), bool)
    parts, near = [], []
    for source in sources:
        part = source.irradiance(points, normal)
        behind |= part < 0
        part = numpy.maximum(part, 0.0)
        total += part
        if with_parts:
            parts.append(part)
        near.append(int(numpy.sum(source.near(points) & (part > 0))) if source.size else 0)
    return Field(points, total, parts, int(behind.sum()), tuple(near))


class Statistics:
    """Mean and extremes over many points, updated with one field at a time.

    `behind` and `near` are those of `Field`; `least_at` and `most_at` [m] are the first points with
    the extremes.
    """

    def __init__(self) -> None:
        self.count = self.behind = 0
        self.sums: list[float] = []
        self.near: list[int] = []
        self.least, self.most = math.inf, -math.inf
        self.least_at = self.most_at = (0.0, 0.0, 0.0)

    def add(self, field: Field) -> None:
        """Add a field of at least one point."""
        self.count += len(field.total)
        self.behind += field.behind
        self.near = [
            a + b for a, b in zip(self.near or [0] * len(field.near), field.near, strict=True)
        ]
        self.sums.append(float(field.total.sum()))
        low, high = int(field.total.argmin()), int(field.total.argmax())
        if field.total[low] < self.least:
            self.least, self.least_at = float(field.total[low]), _point(field, low)
        if field.total[high] > self.most:
            self.most, self.most_at = float(field.total[high]), _point(field, high)

    @property
    def mean(self) -> float:
        return math.fsum(self.sums) / self.count


def _point(field: Field, k: int) -> tuple[float, float, float]:
    x, y, z = (float(c[k]) for c in field.points)
    return x, y, z


class Axis(NamedTuple):
    """Evenly spaced coordinates [m] of a grid along an axis, both ends included."""

    start: float
    end: float
    size: int


def grid(x: Axis, y: Axis, z: Axis) -> Iterator[Vector]:
    """Yield the points of a grid in blocks of up to `BLOCK`; z varies fastest, then y.

    >>> [x.tolist() for x in next(grid(Axis(0, 1, 2), Axis(0, 2, 2), Axis(5, 5, 1)))]
    [[0.0, 0.0, 1.0, 1.0], [0.0, 2.0, 0.0, 2.0], [5.0, 5.0, 5.0, 5.0]]
    """
    coordinates = [numpy.linspace(axis.start, axis.end, axis.size) for axis in (x, y, z)]
    count = x.size * y.size * z.size
    for start in range(0, count, BLOCK):
        index = numpy.arange(start, min(start + BLOCK, count))
        places = numpy.unravel_index(index, (x.size, y.size, z.size))
        a, b, c = (values[place] for values, place in zip(coordinates, places, strict=True))
        yield a, b, c


def blocks(points: Any) -> Iterator[Vector]:
    """Yield points, array_like of shape (n, 3) [m], in blocks of up to `BLOCK`.

    Raise a ConditionError for another shape, or a coordinate that is not finite.

    >>> [x.tolist() for x in next(blocks([[1, 2, 3]]))]
    [[1.0], [2.0], [3.0]]
    """
    coordinates = numpy.asarray(points, float)
    if coordinates.ndim != 2 or coordinates.shape[1] != 3 or not len(coordinates):
        shape = " x ".join(map(str, coordinates.shape))
        raise ConditionError(
            f"points of the shape {shape or 'of a number'}", "n points of 3 coordinates"
        )
    if not numpy.isfinite(coordinates).all():
        raise ConditionError("a point has a coordinate that is not finite", "finite numbers")
    for start in range(0, len(coordinates), BLOCK):
        x, y, z = coordinates[start : start + BLOCK].T
        yield x, y, z
