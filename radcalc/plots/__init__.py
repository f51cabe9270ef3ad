"""Pictures of answers: plain data, and modules that draw them.

This module has the data, and the sizes, colours, settings and titles of figures.  The modules that
make pictures know no terminal and no file; `characters` and `figure`, which draw them, know nothing
of light.
"""

import math
import re
from collections.abc import Iterable, Sequence
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


STEPS = (1.0, 2.0, 2.5, 5.0, 10.0)
FAR = 20.0  # ratio of the ends above which contours are not evenly spaced
ROUNDED = 1e-12  # of the greatest value: smaller values are shown as 0
NEGLIGIBLE = 1e-9  # of the greatest value: smaller values are rounding errors of 0
SPAN = 1000.0  # ratio of an image's brightest part to its darkest shade, and of a sun to that part
PART = 0.005  # of an image, which may be brighter by more than the span: the sun
EVEN = 1.05  # ratio of the brightest to the darkest below which an image without it is even
GLOW = 2.0  # ratio to the brightest of the rest below which a value still belongs to it
RINGS = 6  # most circles of a polar diagram, including the centre
DIGITS = 6  # of a number, unless it needs more to differ from others
ROUNDING = 1e-9  # of a step: tolerance of a tick


def ticks(low: float, high: float, most: int) -> list[float]:
    """Return evenly spaced round numbers between two ends, including round ends.

    >>> ticks(380.0, 780.0, 5)
    [400.0, 500.0, 600.0, 700.0]
    """
    step = round_step((high - low) / max(most - 1, 1))
    first = math.ceil(low / step - ROUNDING)
    places = []
    while first * step <= high + step * ROUNDING:
        places.append(float(f"{first * step:.12g}"))
        first += 1
    return places if len(places) <= most or most <= 2 else ticks(low, high, most - 1)


def round_step(least: float) -> float:
    """Return the smallest of 1, 2, 2.5, 5 times a power of ten that is not below a number."""
    power = 10.0 ** math.floor(math.log10(least))
    return next(s for s in STEPS if s * power >= least * (1 - ROUNDING)) * power


def log_ticks(low: float, high: float, most: int) -> list[float]:
    """Return powers of ten between two ends, with 2 and 5 times them if there is room."""
    ends = range(math.floor(math.log10(low)), math.ceil(math.log10(high)) + 1)
    for factors in ((1, 2, 5), (1,)):
        places = [float(f"{f}e{power}") for power in ends for f in factors]
        places = [x for x in places if low * (1 - ROUNDING) <= x <= high * (1 + ROUNDING)]
        if len(places) <= most:
            return places
    apart = 2
    while len(places[::apart]) > most:
        apart += 1
    return places[::apart]


def limits(values: list[float], most: int) -> tuple[float, float]:
    """Return round ends of an axis for values, including 0 if it is near.

    >>> limits([3.0, 97.0], 6), limits([996.0, 1004.0], 6)
    ((0.0, 100.0), (996.0, 1004.0))
    """
    low, high = min(values), max(values)
    if 0 < low < high / 2:
        low = 0.0
    if high < 0 and high > low / 2:
        high = 0.0
    if low == high:
        low, high = (low - 1, high + 1) if not low else sorted((0.0, 2 * low))
    step = round_step((high - low) / max(most - 1, 1))
    return math.floor(low / step + ROUNDING) * step, math.ceil(high / step - ROUNDING) * step


def rings(most: float) -> list[float]:
    """Return the radii of the circles of a polar diagram for values up to `most`."""
    return ticks(0.0, limits([0.0, most], RINGS)[1], RINGS)[1:]


def levels(values: Iterable[float], most: int = 10) -> list[float]:
    """Return round numbers between the least and the greatest of many, for contours.

    If the ends are far apart, they are 1, 2 and 5 times powers of ten.  A least value that is a
    rounding error of 0, as at the horizon of a cosine, counts as 0.

    >>> levels([0.4, 210.0])
    [0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0]
    """
    ordered = sorted(values)
    low, high = ordered[0], ordered[-1]
    if not low < high * (1 - 1e-6):
        return []
    is_far = low > NEGLIGIBLE * high and high > FAR * low
    places = log_ticks(low, high, most) if is_far else ticks(low, high, most)
    return [x for x in places if low < x < high]


def ends(values: Iterable[float]) -> tuple[float, float]:
    """Return the least and the greatest of many values, with 0 for a rounding error of 0."""
    numbers = [*values]
    low, high = min(numbers), max(numbers)
    least = ROUNDED * max(abs(low), abs(high))
    return low if abs(low) > least else 0.0, high if abs(high) > least else 0.0


def span(values: Iterable[float]) -> str:
    """Return the range of values as text.

    >>> span([32.38201, 93.258]), span([5.0, 5.0])
    ('from 32.38 to 93.26', '5 everywhere')
    """
    low, high = ends(values)
    if high - low <= ROUNDED * max(abs(low), abs(high)):
        return f"{high:.4g} everywhere"
    rounded = [float(f"{end:.4g}") for end in (low, high)]
    return "from {} to {}".format(*texts(rounded if rounded[0] < rounded[1] else [low, high]))


class Shades(NamedTuple):
    """A scale of brightness from `low` to `high`; values beyond its ends look like the ends."""

    low: float
    high: float
    is_log: bool

    @property
    def kind(self) -> str:
        return "log scale" if self.is_log else "linear scale"

    def share(self, value: float) -> float:
        """Return the brightness of a value, from 0 to 1."""
        if value >= self.high:
            return 1.0 if self.high > 0 else 0.0
        if value <= self.low:
            return 0.0
        if self.is_log:
            return math.log(value / self.low) / math.log(self.high / self.low)
        return (value - self.low) / (self.high - self.low)


def shades(values: Sequence[float]) -> Shades:
    """Return the scale of brightness of an image.

    It reaches the greatest value.  Only a small part of an image with contrast, such as the sun,
    which is brighter than the rest by more than `SPAN`, is beyond it.  The scale is logarithmic if
    its ends are far apart.

    >>> shades([1.0] * 999 + [200.0])
    Shades(low=1.0, high=200.0, is_log=True)
    >>> shades([300.0, 5000.0] * 500 + [1e9])
    Shades(low=300.0, high=5000.0, is_log=True)
    """
    ordered = sorted(values)
    least, most = ordered[0], ordered[-1]
    rest = ordered[round((1 - PART) * (len(ordered) - 1))]
    darkest = next((x for x in ordered if x > 0), 0.0)
    high = most
    if most > SPAN * rest > SPAN * EVEN * darkest > 0:
        high = max(x for x in ordered if x <= GLOW * rest)
    is_log = high > FAR * max(least, 0.0) and high > FAR * darkest > 0
    low = max(darkest, min(high, rest or high) / SPAN) if is_log else least
    return Shades(low, high, is_log)


def texts(values: list[float]) -> list[str]:
    """Return different numbers as axis labels, with enough digits to distinguish them.

    >>> texts([0.0, 0.5, 1.0]), texts([0.0, 2e-7])
    (['0', '0.5', '1'], ['0', '2e-07'])
    """
    for digits in range(DIGITS, 17):
        numbers = [f"{value + 0.0:.{digits}g}" for value in values]
        if len(set(numbers)) == len(values):
            break
    return numbers


SIZE = 7.2, 4.5  # inches
AREA, LONGEST = 20.0, 8.0  # of a plan [square inches, inches]
FRAME = 1.5, 1.0  # room for its numbers and its scale [inches]
FLAT = 2.0  # ratio of the width to the height above which the scale is below the plan
DOTS = 160  # per inch, in PNG
SQUARE, HALF = (6.4, 6.4), (7.2, 4.9)
LONG = 5  # characters of a radius of a polar diagram
WEDGE, CIRCLE = (0.09, -0.05, 0.82, 1.2), (0.14, 0.15, 0.72, 0.72)  # of a polar diagram
SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
POWER, INDEX = re.compile(r"(?<=[A-Za-z])-?\d+"), re.compile(r"\b(\w)_(\w+)")
SHIFTS = (0.8, 0.9, 1.1, 1.2)  # chroma relative to the reference of TM-30
GREY, NO_LIGHT, FAINT = "#6b7280", "#374151", "#d1d5db"
ARROW = {"arrowstyle": "->", "color": NO_LIGHT, "lw": 1.2, "shrinkA": 0, "shrinkB": 0}
DASHES = ("-", (0, (4, 2)))  # of the planes of a polar diagram
LINESTYLES = ("-", (0, (5, 1.5)), (0, (5, 1.5, 1, 1.5)), (0, (1, 1.5)))  # of curves of one colour
MARKERS = "os^D"  # of points of one colour
DENSE = 50  # least number of points of a curve without markers
BESIDE = 8  # longest legend inside a chart
LABEL = 40  # most letters of a label in a legend
LETTERS, MARGINS, MOST_LINES = 11, 1.0, 3  # of a title: letters an inch; inches; lines
BAND = 0.25  # opacity
MARK, POINT = 6, 72  # size of a mark [points]; points per inch
REACHES = (5, 20, 35, 50)  # distances of a label from its mark [points]
AROUND = ((1, 1), (1, -1), (-1, 1), (-1, -1), (1, 0), (-1, 0), (0, 1), (0, -1))
ACROSS, UP = ("center", "left", "right"), ("center", "bottom", "top")  # for the sides 0, 1 and -1
OVER = "white"  # brighter than the scale
STRIP = 0.03  # of the height of a chart, for the colours of its axis
TICKS = 6  # of an axis with round ends
ANGLES = (1, 1.5, 3, 4.5, 6, 9, 10)  # steps of an axis in degrees, times a power of ten
COLORMAP = "viridis"
ROUND = 1.01  # of the radius of a disc: room for its rim
WHOLE = 0.9  # of the radius of a disc, within which its rim does not cut the contour numbers
COLORS = ("#0f766e", "#b45309", "#7c3aed", "#be123c", "#1d4ed8", "#4d7c0f")
FONT = "DejaVu Sans"  # included in Matplotlib
SETTINGS = {
    "axes.edgecolor": GREY,
    "axes.grid": True,
    "axes.axisbelow": True,
    "axes.labelcolor": "#1f2937",
    "axes.spines.right": False,
    "axes.spines.top": False,
    "axes.titlelocation": "left",
    "axes.titlesize": 11,
    "figure.facecolor": "white",
    "font.family": FONT,
    "font.size": 10,
    "grid.color": "#e5e7eb",
    "grid.linewidth": 0.8,
    "legend.framealpha": 0.8,
    "legend.edgecolor": "none",
    "lines.linewidth": 1.8,
    "lines.solid_capstyle": "round",
    "svg.hashsalt": "radcalc",  # makes the names in an SVG reproducible
    "xtick.color": GREY,
    "xtick.labelcolor": NO_LIGHT,
    "ytick.color": GREY,
    "ytick.labelcolor": NO_LIGHT,
}


def plan_size(ratio: float) -> tuple[float, float]:
    """Return the size of a figure [inches] for a plan of a ratio of width to height."""
    high = min(math.sqrt(AREA / ratio), LONGEST, LONGEST / ratio)
    across, down = FRAME if ratio <= FLAT else FRAME[::-1]
    return max(high * ratio + across, SIZE[1]), high + down


def axis_title(axis: Axis) -> str:
    """Return the title of an axis, with exponents above the line and indices below it."""
    unit = POWER.sub(lambda match: match[0].translate(SUPERSCRIPTS), axis.unit)
    return INDEX.sub(r"$\1_{\\mathrm{\2}}$", axis._replace(unit=unit).title)
