"""What is to be drawn, as plain data: charts, polar diagrams, fields over a plane, and discs."""

from collections.abc import Sequence
from typing import NamedTuple

LINE, REFERENCE, LINES, POINTS = "line", "reference", "lines", "points"  # how a series is drawn
RIGHT = 90.0  # deg
MANY = 20  # curves at most that all have their names
Values = Sequence[float]


class Axis(NamedTuple):
    """What an axis shows, in which unit; between limits where these are not those of the data."""

    label: str
    unit: str = ""
    limits: tuple[float, float] | None = None
    is_log: bool = False

    @property
    def title(self) -> str:
        """`distance [m]`; a number has no unit."""
        unit = f"[{self.unit}]" if self.unit not in ("", "1") else ""
        return f"{self.label} {unit}".strip()


class Series(NamedTuple):
    """Points of a curve, and its name.

    A `REFERENCE` is there to compare with, `LINES` are upright from 0 to each point, and `POINTS`
    are too few for a line between them to tell the truth.
    """

    label: str
    x: Values
    y: Values
    style: str = LINE


class Hue(NamedTuple):
    """The colour that stands for a place on an axis, in sRGB from 0 to 1."""

    place: float
    red: float
    green: float
    blue: float


class Chart(NamedTuple):
    """Curves over an axis; `marks` are names and places on it that are marked.

    `hues` are colours along it, evenly apart.
    """

    title: str
    x: Axis
    y: Axis
    series: Sequence[Series]
    marks: Sequence[tuple[str, float]] = ()
    hues: Sequence[Hue] = ()

    @property
    def curves(self) -> list[Series]:
        """What is not there to compare with."""
        return [series for series in self.series if series.style != REFERENCE]

    @property
    def crowd(self) -> str:
        """What is said where there are too many curves for each to have its name, and a colour."""
        count = len(self.curves)
        return f"{count} curves, the first and the last of which are" if count > MANY else ""

    @property
    def named(self) -> list[int]:
        """Which of the series are named."""
        labelled = [k for k, series in enumerate(self.series) if series.label]
        curves = [k for k in labelled if self.series[k].style != REFERENCE]
        return [k for k in labelled if k not in curves[1:-1]] if self.crowd else labelled


class Plane(NamedTuple):
    """A plane of a polar diagram: values at angles from the axis [deg].

    Those of the second half plane, which is opposite, have negative angles.
    """

    label: str
    angles: Values
    values: Values


class Polar(NamedTuple):
    """A polar diagram, whose axis points down; what `radius` shows is its distance from there."""

    title: str
    radius: Axis
    planes: Sequence[Plane]

    @property
    def is_half(self) -> bool:
        """Whether there is nothing in the upper half."""
        return not any(
            value
            for plane in self.planes
            for angle, value in zip(plane.angles, plane.values, strict=True)
            if abs(angle) > RIGHT
        )

    @property
    def most(self) -> float:
        """The greatest value."""
        return max(value for plane in self.planes for value in plane.values)


class Mark(NamedTuple):
    """A place in a field, or in a disc, that is marked."""

    label: str
    x: float
    y: float


class Field(NamedTuple):
    """Values over a plane of x and y, a row for each y; lengths on both axes are alike."""

    title: str
    x: Axis
    y: Axis
    value: Axis
    xs: Values
    ys: Values
    rows: Sequence[Values]
    marks: Sequence[Mark] = ()


class Disc(NamedTuple):
    """Values over a hemisphere of directions: its centre is in the middle, 90 deg is the rim.

    `rows` are over x (to the right) and y (up) from -1 to 1, evenly apart, the distance from the
    middle being in proportion to the angle; what is outside of the disc counts for nothing.
    `rim` are names of angles [deg], counted clockwise from the top.  What `is_image` has edges,
    and no contours that anybody could read.
    """

    title: str
    value: Axis
    rows: Sequence[Values]
    rim: Sequence[tuple[str, float]]
    centre: str = ""
    marks: Sequence[Mark] = ()
    is_image: bool = False


Picture = Chart | Polar | Field | Disc
