"""Pictures as plain data."""

from collections.abc import Sequence
from typing import NamedTuple

from radcalc.errors import listed

LINE, REFERENCE, LINES, POINTS = "line", "reference", "lines", "points"  # styles of a series
RIGHT = 90.0  # deg
MANY = 20  # most curves that can all be named
FEW = 8  # curves to name among more, evenly spaced in their order
Values = Sequence[float]
Band = tuple[Values, Values]  # the lower and the upper ends of uncertain values


class Axis(NamedTuple):
    """Label and unit of an axis; its limits, if any, replace those of the data."""

    label: str
    unit: str = ""
    limits: tuple[float, float] | None = None
    is_log: bool = False

    @property
    def title(self) -> str:
        unit = f"[{self.unit}]" if self.unit not in ("", "1") else ""
        return f"{self.label} {unit}".strip()


class Series(NamedTuple):
    """Points of a curve, and its name.

    A `REFERENCE` is drawn for comparison; `LINES` are vertical from 0; `POINTS` are too few to
    connect.  A `band` has the ends of uncertain values; the `note` of the picture states its
    coverage.
    """

    label: str
    x: Values
    y: Values
    style: str = LINE
    band: Band | None = None

    @property
    def heights(self) -> list[float]:
        """The values and the ends of their band."""
        return [y for values in (self.y, *(self.band or ())) for y in values]


class Tint(NamedTuple):
    """The colour of a position on an axis, in sRGB from 0 to 1."""

    place: float
    red: float
    green: float
    blue: float


class Chart(NamedTuple):
    """Curves over an axis, with named marks and evenly spaced `hues` along it.

    A `note` of any picture is shown below it.
    """

    title: str
    x: Axis
    y: Axis
    series: Sequence[Series]
    marks: Sequence[tuple[str, float]] = ()
    hues: Sequence[Tint] = ()
    note: str = ""

    @property
    def curves(self) -> list[Series]:
        return [series for series in self.series if series.style != REFERENCE]

    @property
    def is_crowd(self) -> bool:
        """True if there are too many curves to name each; their colours then follow their order."""
        return len(self.curves) > MANY

    @property
    def named(self) -> list[int]:
        """The series to name in a legend: all, or of a crowd some, and the references."""
        labelled = [k for k, series in enumerate(self.series) if series.label]
        if not self.is_crowd:
            return labelled
        curves = [k for k in labelled if self.series[k].style != REFERENCE]
        some = {curves[k * (len(curves) - 1) // (FEW - 1)] for k in range(FEW)} if curves else ()
        return [k for k in labelled if k not in curves or k in some]

    @property
    def more(self) -> str:
        """The number of curves that a legend does not name, if any."""
        count = len(self.curves) - sum(self.series[k].style != REFERENCE for k in self.named)
        return f"and {count} more, in this order" if self.is_crowd and count else ""


class Plane(NamedTuple):
    """Values at angles from the axis [deg], which are negative in the opposite half plane."""

    label: str
    angles: Values
    values: Values
    band: Band | None = None

    @property
    def ranges(self) -> Sequence[Values]:
        """The values, and the ends of their band."""
        return (self.values, *(self.band or ()))


class Polar(NamedTuple):
    """A polar diagram with its axis downwards; `radius` describes the distance from the centre."""

    title: str
    radius: Axis
    planes: Sequence[Plane]
    note: str = ""

    @property
    def is_half(self) -> bool:
        return not any(
            value
            for plane in self.planes
            for angle, value in zip(plane.angles, plane.values, strict=True)
            if abs(angle) > RIGHT
        )

    @property
    def most(self) -> float:
        return max(y for plane in self.planes for values in plane.ranges for y in values)


class Mark(NamedTuple):
    """A named point in a field or a disc."""

    label: str
    x: float
    y: float


def nameless(labels: Sequence[str]) -> str:
    """Return the note on marks whose labels have no room in a picture."""
    return f"without room for a name: {listed(labels)}" if labels else ""


class Field(NamedTuple):
    """Values over a plane of x and y, a row for each y; both axes have the same scale."""

    title: str
    x: Axis
    y: Axis
    value: Axis
    xs: Values
    ys: Values
    rows: Sequence[Values]
    marks: Sequence[Mark] = ()
    note: str = ""


class Disc(NamedTuple):
    """Values over a hemisphere of directions: the centre is in the middle, the rim at 90 deg.

    `rows` are over x (to the right) and y (up) from -1 to 1, evenly spaced; the distance from the
    middle is proportional to the angle.  Values outside the disc are ignored.  `rim` has names of
    angles [deg], clockwise from the top.  An image (`is_image`) has edges, for which contours would
    not be readable.
    """

    title: str
    value: Axis
    rows: Sequence[Values]
    rim: Sequence[tuple[str, float]]
    centre: str = ""
    marks: Sequence[Mark] = ()
    is_image: bool = False
    note: str = ""

    @property
    def notes(self) -> list[str]:
        """The places of the directions, and the note."""
        places = f"{self.centre} in the middle, 90 deg from it at the rim" if self.centre else ""
        return list(filter(None, (places, self.note)))


class ColourDiagram(NamedTuple):
    """Curves and named points in a plane of colours; both axes have the same scale.

    A figure has the colours of the plane behind them: those of TM-30's colour vectors if there are
    `arrows` (from and to), or those of the chromaticity diagram.
    """

    title: str
    x: Axis
    y: Axis
    series: Sequence[Series]
    marks: Sequence[Mark] = ()
    arrows: Sequence[tuple[tuple[float, float], tuple[float, float]]] = ()
    note: str = ""

    @property
    def limits(self) -> tuple[tuple[float, float], tuple[float, float]]:
        return self.x.limits or (0.0, 1.0), self.y.limits or (0.0, 1.0)


Picture = Chart | Polar | Field | Disc | ColourDiagram
IN_A_FILE: dict[type, str] = {  # kinds of pictures that are not drawn in characters
    Disc: "a fisheye view",
    ColourDiagram: "a colour diagram",
}
