"""Photometric files of IES LM-63: the editions of 1986, 1991, 1995, 2002 and 2019.

A file has a label (lines of text; keywords in brackets since 1991), a line with TILT, and numbers:
thirteen for the lamps and the table, the vertical angles V, the horizontal angles H, and for each H
the intensities at all V.  Blanks, commas and line ends separate them; a record may span several
lines.

LM-63-2002 (section 3) defines the types of goniometer.  In the coordinates of a distribution::

    C   the pole is the axis:               theta = V            phi = H
    A   the same pole, nadir at V = -90:    theta = V + 90 deg   phi = -H
    B   the pole is across the axis, y:     x = sin V cos H,  y = -sin H,  z = cos V cos H

Horizontal angles of types A and B increase clockwise.
"""

import re
from bisect import bisect_right
from collections.abc import Iterator, Sequence
from itertools import accumulate, pairwise
from typing import Any, NamedTuple, NoReturn

import numpy

from radcalc.distributions import distribution
from radcalc.distributions.distribution import Grid, Photometry
from radcalc.errors import ConditionError, quote
from radcalc.files import refusal
from radcalc.files.columns import has_odd_digits, is_number, numbers_at_once

# kind of light and SI value of each unit of intensity
UNITS = {
    "cd": ("v", 1.0),
    "candela": ("v", 1.0),
    "w/sr": ("e", 1.0),
    "mw/sr": ("e", 1e-3),
    "uw/sr": ("e", 1e-6),
}
UNITS_ARE = "_INTENSITYUNITS"  # the keyword
YEARS = (1986, 1991, 1995, 2002, 2019)
EDITIONS = {text: year for year in YEARS for text in (str(year), str(year)[2:])}
SYSTEMS = {1: "C", 2: "B", 3: "A"}
METRES = {1: 0.3048, 2: 1.0}  # by the number of the unit of length

_EDITION = re.compile(r"\s*IES(?:NA)?\s*:?\s*(?:LM-?63-)?(\d{4}|\d\d)\s*$", re.IGNORECASE)
_TAG = re.compile(r"\s*IES(?:NA|\s*:)|LM-?63", re.IGNORECASE)
_KEYWORD = re.compile(r"\s*\[([^\]]*)\](.*)")
_TILT = re.compile(r"\s*TILT\s*=(.*)", re.IGNORECASE)
_RADIANT = re.compile(r"\b([mu\u00b5\u03bc]?W)\s*/\s*sr\b", re.IGNORECASE)
BEYOND = 1e18  # limit of a number, so that products stay finite


class Numbers:
    """The numbers after the label, in order; `start` is the line of the label's end."""

    def __init__(self, lines: Sequence[str], start: int, name: str) -> None:
        self.name, self.start = name, start
        self.place = 0
        self.body = list(lines[start:])
        while self.body and self.body[-1].strip().upper() in ("", "END"):
            self.body.pop()
        values = _at_once(self.body)
        self.values = numpy.array(self._one_by_one()) if values is None else values
        are_sound = numpy.abs(self.values) < BEYOND
        if not are_sound.all():
            place = int(numpy.argmin(are_sound))
            problem = f"{self.values[place]:g} is out of range: numbers must be below {BEYOND:g}"
            raise self.error(place, problem, "a finite number")

    def _one_by_one(self) -> list[float]:
        lines = enumerate(self.body, self.start + 1)
        return [value for number, line in lines for value in self.numbers(line, number)]

    def numbers(self, line: str, number: int) -> list[float]:
        """Return the numbers of a line, separated by blanks or commas."""
        words = line.split()
        values = numbers_at_once(words)
        if values is not None:
            return values
        if len(words) > 1 and any(re.fullmatch(r"[+-]?\d+,\d+", word) for word in words):
            raise refusal(
                self.name,
                number,
                "a number has a decimal comma",
                "decimal points: commas separate numbers",
            )
        if re.search(r",\s*,", line):
            raise refusal(self.name, number, "a number is missing between two commas", "a number")
        words = " ".join(words).replace(",", " ").split()
        for word in words:
            if not is_number(word, False):
                raise refusal(
                    self.name, number, f"'{quote(word)}' is not a number", "only numbers after TILT"
                )
        return list(map(float, words))

    @property
    def ends(self) -> list[int]:
        """Return the count of numbers up to the end of each line."""
        return [*accumulate(len(line.replace(",", " ").split()) for line in self.body)]

    def error(self, place: int, problem: str, hint: str) -> ConditionError:
        """Return an error about the number at an index."""
        line = bisect_right(self.ends, min(place, len(self.values) - 1))
        return refusal(self.name, self.start + line + (1 if len(self.values) else 0), problem, hint)

    def take(self, count: int) -> Any:
        """Return the next numbers; the caller has checked that there are enough."""
        self.place += count
        return self.values[self.place - count : self.place]

    def number(self) -> float:
        return float(self.take(1)[0])

    def remaining(self) -> int:
        return len(self.values) - self.place

    def whole(self, what: str, least: int) -> int:
        value = self.number()
        if value != int(value) or value < least:
            problem = f"the {what} is {value:g}"
            raise self.error(self.place - 1, problem, f"a whole number, {least} or more")
        return int(value)

    def one_of(self, what: str, codes: dict[int, str]) -> int:
        value = self.number()
        if value not in codes:
            meanings = ", ".join(f"{code} ({meaning})" for code, meaning in codes.items())
            raise self.error(self.place - 1, f"the {what} is {value:g}", f"one of: {meanings}")
        return int(value)

    def factor(self, what: str) -> float:
        value = self.number()
        if value <= 0:
            raise self.error(self.place - 1, f"the {what} is {value:g}", "a factor above 0")
        return value

    def need(self, count: int, what: str) -> None:
        if self.remaining() < count:
            problem = f"the file ends after {self.remaining()} of {what}"
            hint = f"{count} numbers, and the rest of the file"
            raise self.error(len(self.values), problem, hint)


def _at_once(lines: Sequence[str]) -> Any:
    """Return the numbers of lines as an array, read at once; None if a word is not a number."""
    text = " ".join(lines)
    if not text.strip() or has_odd_digits(text):
        return None
    try:
        return numpy.loadtxt([text], comments=None, ndmin=1)
    except ValueError:
        return None


def read(lines: Sequence[str], name: str) -> Photometry:
    """Read a photometric file of IES LM-63.

    Returns
    -------
    Photometry
        Distribution and declared values.  Intensities are those of the table times the
        multiplier and the ballast factor, and in the editions of 1986 and 1991 the ballast-lamp
        factor.  The factors of a tilted lamp are not applied.

    Raises
    ------
    ConditionError
        If the file is not LM-63, ends early or is ambiguous.

    References
    ----------
    .. [1] ANSI/IESNA LM-63-02, Standard File Format for the Electronic Transfer of Photometric
          Data; the differences of the other editions follow the comments in Radiance's ies2rad.

    Examples
    --------
    >>> text = "IESNA:LM-63-2002|TILT=NONE|1 -1 1 3 1 1 2 0 0 0|1 1 9|0 90 180|0|100 100 100"
    >>> sphere = read(text.split("|"), "sphere.ies")
    >>> sphere.format, round(sphere.distribution.flux().value, 3)
    ('IES LM-63-2002, type C', 1256.637)
    """
    label = _Label(lines, name)
    kind, unit, assumptions = _unit(label)
    numbers = Numbers(lines, label.end, name)
    if label.tilt != "NONE":
        assumptions.append(_tilt(label.tilt, numbers))
    header = _header(numbers, label.edition, assumptions)
    vertical = _angles(numbers, "vertical", header.vertical)
    horizontal = _angles(numbers, "horizontal", header.horizontal)
    table = _Table(numbers, vertical, horizontal)
    system = SYSTEMS[header.system]
    polar, azimuth, values = {"C": table.of_c, "B": table.of_b, "A": table.of_a}[system]()
    grid = Grid(
        numpy.radians(polar),
        numpy.radians(azimuth),
        values * (header.factor * unit),
        kind,
        "B" if system == "B" else "C",
    )
    edition = f"-{label.edition}" if label.edition else ""
    declared = {"input-power": header.watts, "lamp-flux": header.lumens if kind == "v" else 0.0}
    return Photometry(
        grid,
        f"IES LM-63{edition}, type {system}",
        quote(label.title),
        {symbol: value for symbol, value in declared.items() if value > 0},
        (*assumptions, *table.assumptions),
        tuple(table.notes),
        header.size,
    )


class _Label:
    """The lines before the numbers."""

    def __init__(self, lines: Sequence[str], name: str) -> None:
        self.name = name
        self.lines: list[str] = []
        self.keywords: dict[str, tuple[int, str]] = {}  # line and text of each keyword
        keyword = ""
        for number, line in enumerate(lines, 1):
            if tilt := _TILT.match(line):
                self.end, self.tilt = number, tilt[1].strip()
                break
            self.lines.append(line)
            if keyword_match := _KEYWORD.match(line):
                title, text = keyword_match[1].strip().upper(), keyword_match[2].strip()
                if title == "MORE" and keyword:
                    number, before = self.keywords[keyword]
                    text = f"{before} {text}"
                else:
                    keyword = title
                self.keywords[keyword] = number, text
        else:
            problem = "the file ends before a line with TILT="
            raise self.error(max(len(lines), 1), problem, "a file of IES LM-63")
        if not self.tilt:
            raise self.error(self.end, "TILT= has no value", "TILT=NONE or TILT=INCLUDE")
        if self.tilt.upper() in ("NONE", "INCLUDE"):
            self.tilt = self.tilt.upper()
        first = next((line for line in self.lines if line.strip()), "")
        edition = _EDITION.match(first)
        self.edition = EDITIONS.get(edition[1], 0) if edition else 0
        if not (self.edition or _TAG.search(first)):
            self.edition = 1986  # the first edition has no such line
        for keyword in ("LUMINAIRE", "LUMCAT", "TEST"):
            self.title = self.keywords.get(keyword, (0, ""))[1]
            if self.title:
                break
        else:
            self.title = "" if self.keywords or _TAG.search(first) else first.strip()

    def error(self, line: int, problem: str, hint: str) -> ConditionError:
        return refusal(self.name, line, problem, hint)


def _unit(label: _Label) -> tuple[str, float, list[str]]:
    """Return the kind of light and the SI value of the unit of intensity, and assumptions."""
    wanted = f"[{UNITS_ARE}] with one of: cd, mW/sr, W/sr, uW/sr"
    if UNITS_ARE in label.keywords:
        line, text = label.keywords[UNITS_ARE]
        spelled = {text}
        where = f"[{UNITS_ARE}]"
    else:
        matches = [
            (number, match)
            for number, text in enumerate(label.lines, 1)
            for match in _RADIANT.findall(text)
        ]
        if not matches:
            for line, text in enumerate(label.lines, 1):
                if "radiometric" in text.lower():
                    raise label.error(line, "radiometric intensities without a unit", wanted)
            return "v", 1.0, []
        line = matches[0][0]
        spelled = {f"{match}/sr" for _, match in matches}
        where = f"line {line}"
    plain = {re.sub("[\u00b5\u03bc]", "u", text.replace(" ", "").lower()) for text in spelled}
    kind_and_factor = UNITS.get(plain.pop()) if len(plain) == 1 else None
    if not kind_and_factor:
        problem = f"the intensities are in {quote(' and '.join(sorted(spelled)))}"
        raise label.error(line, problem, wanted)
    return *kind_and_factor, [f"intensities in {quote(spelled.pop())}, according to {where}"]


def _tilt(tilt: str, numbers: Numbers) -> str:
    """Skip the factors of a tilted lamp; return an assumption that they are not applied."""
    if tilt != "INCLUDE":
        return f"the lamp is in its measured position: the factors in {quote(tilt)} are not applied"
    numbers.need(2, "the lamp's position and the number of its tilt angles")
    numbers.one_of(
        "lamp's position", {1: "vertical", 2: "horizontal, turning", 3: "horizontal, fixed"}
    )
    count = numbers.whole("number of tilt angles", 1)
    numbers.need(2 * count, f"the {count} tilt angles and their factors")
    _angles(numbers, "tilt", count)
    for _ in range(count):
        numbers.factor("factor of a tilt angle")
    return "the lamp is in its measured position: its tilt factors are not applied"


class _Header(NamedTuple):
    """The thirteen numbers of the lamps and the table."""

    lumens: float  # [lm] of all lamps; 0 or negative if not declared
    factor: float  # of the intensities
    vertical: int
    horizontal: int
    system: int
    watts: float
    size: float  # [m] the largest of width, length and height


def _header(numbers: Numbers, edition: int, assumptions: list[str]) -> _Header:
    """Read the header, and check its counts of angles."""
    numbers.need(13, "the 13 numbers of the lamps and the table")
    lumens = numbers.whole("number of lamps", 0) * numbers.number()
    factor = numbers.factor("multiplier")
    vertical = numbers.whole("number of vertical angles", 2)
    horizontal = numbers.whole("number of horizontal angles", 1)
    system = numbers.one_of("photometric type", {k: f"type {v}" for k, v in SYSTEMS.items()})
    units = numbers.one_of("type of units", {1: "feet", 2: "metres"})
    size = float(max(abs(numbers.take(3)))) * METRES[units]  # a diameter is negative
    ballast = numbers.factor("ballast factor")
    factor *= ballast
    if ballast != 1:
        assumptions.append(f"a ballast factor of {ballast:g}")
    factor *= _ballast_lamp_factor(numbers, edition, assumptions)
    watts = numbers.number()
    _check_counts(numbers, vertical, horizontal)
    return _Header(lumens, factor, vertical, horizontal, system, watts, size)


def _ballast_lamp_factor(numbers: Numbers, edition: int, assumptions: list[str]) -> float:
    """Return the ballast-lamp factor, which only LM-63-1986 and 1991 have."""
    if edition in (1986, 1991):
        value = numbers.factor("ballast-lamp factor")
        if value != 1:
            assumptions.append(f"a ballast-lamp factor of {value:g}, as in LM-63-{edition}")
        return value
    value = numbers.number()
    if value != 1 and not edition:
        problem = f"{value:g} is a factor in some editions, but the first line names no edition"
        hint = "IESNA91 as the first line if it is one, IESNA:LM-63-2002 if not"
        raise numbers.error(numbers.place - 1, problem, hint)
    if value != 1 and edition < 2019:
        assumptions.append(f"{value:g} is not applied: LM-63-{edition} has no ballast-lamp factor")
    return 1.0


def _check_counts(numbers: Numbers, vertical: int, horizontal: int) -> None:
    """Check that there are as many numbers as the counts of angles require.

    A record ends at the end of a line; the first one that does not is reported.
    """
    needed = vertical + horizontal + vertical * horizontal
    if numbers.remaining() == needed:
        return
    problem = (
        f"{vertical} vertical and {horizontal} horizontal angles with their intensities need "
        f"{needed} numbers, and there are {numbers.remaining()}"
    )
    place, ends = numbers.place, set(numbers.ends)
    for count, what in _records(vertical, horizontal):
        if place + count > len(numbers.values):
            hint = "the complete file"
            raise numbers.error(place + count, f"the file ends within {what}: {problem}", hint)
        if place + count not in ends:
            begun = f"{what} that begin here do not end at the end of a line: {problem}"
            raise numbers.error(place, begun, f"{count} numbers")
        place += count
    hint = "one luminaire in a file"
    raise numbers.error(place, f"more numbers than the table has: {problem}", hint)


def _records(vertical: int, horizontal: int) -> Iterator[tuple[int, str]]:
    yield vertical, f"the {vertical} vertical angles"
    yield horizontal, f"the {horizontal} horizontal angles"
    for plane in range(1, horizontal + 1):
        yield vertical, f"the {vertical} intensities of plane {plane}"


def _angles(numbers: Numbers, what: str, count: int) -> Any:
    """Read angles [deg], which must rise; those near a right angle are rounded to it."""
    start = numbers.place
    angles = numbers.take(count)
    right = 90 * numpy.round(angles / 90)
    angles = numpy.where(abs(angles - right) <= distribution.SLACK, right, angles)
    for place, (before, after) in enumerate(pairwise(angles), start + 1):
        if not before < after:
            problem = f"the {what} angles do not rise: {after:g} after {before:g}"
            raise numbers.error(place, problem, "angles that rise")
    return angles


class _Table:
    """Intensities at horizontal and vertical angles [deg], with assumptions and notes."""

    def __init__(self, numbers: Numbers, vertical: Any, horizontal: Any) -> None:
        self.numbers, self.start = numbers, numbers.place
        self.vertical, self.horizontal = vertical, horizontal
        shape = len(horizontal), len(vertical)
        self.values = numpy.reshape(numbers.take(shape[0] * shape[1]), shape)
        self.assumptions: list[str] = []
        self.notes: list[str] = []
        self.values, notes = distribution.without_noise(self.values, self.refuse)
        self.notes += notes

    def refuse(self, place: int, problem: str, hint: str) -> NoReturn:
        raise self.numbers.error(self.start + place, problem, hint)

    def of_c(self) -> tuple[Any, Any, Any]:
        """Return polar angles, azimuths of the whole circle [deg] and values of type C."""
        self.check_range("vertical", 0, 180)
        if self.vertical[0] not in (0, 90):
            raise self.error("vertical", "0 or 90 for the first of type C")
        self.assumptions += distribution.end_of(self.vertical)
        planes, values = self.horizontal, self.values
        first, last = planes[0], planes[-1]
        represent = f"the planes {first:g} to {last:g} deg represent "
        if len(planes) == 1 and first == 0:
            self.assumptions.append("one plane represents all")
            return self.vertical, planes, values
        if (first, last) in ((0, 90), (0, 180), (90, 270)):
            self.assumptions.append(
                represent + ("all four quadrants" if last == 90 else "both sides")
            )
            return self.vertical, *distribution.mirrored(planes, values)
        if last != first + 360:
            self.assumptions.append(f"the plane after {last:g} deg is the first one again")
        try:
            return self.vertical, *distribution.closed(planes, values)
        except ConditionError:
            hint = "0 alone, 0..90, 0..180, 90..270 or 0..360 for type C"
            raise self.error("horizontal", hint) from None

    def of_b(self) -> tuple[Any, Any, Any]:
        """Return the same for type B, with polar angles and azimuths about the y axis."""
        angles, values = self.both_sides((-180, 180), (-90, 90))
        self.assumptions.append(
            "the axis is at V = H = 0 of type B; V increases to C 0 and H to C 270 deg"
        )
        return angles + 90, self.vertical, values.T

    def of_a(self) -> tuple[Any, Any, Any]:
        """Return the same for type A, which has the axis of type C."""
        angles, values = self.both_sides((-90, 90), (-180, 180))
        self.assumptions.append(
            "V = H = 0 of type A is at C 0, gamma 90 deg; V increases upwards and H to C 270 deg"
        )
        return self.vertical + 90, -angles[::-1], values[::-1]

    def both_sides(self, vertical: tuple[int, int], horizontal: tuple[int, int]) -> tuple[Any, Any]:
        """Return horizontal angles and values of types A and B on both sides, within range."""
        self.check_range("vertical", *vertical)
        self.check_range("horizontal", *horizontal)
        angles, values = self.horizontal, self.values
        if len(angles) < 2 or angles[0] not in (0, -angles[-1]):
            raise self.error("horizontal", "0..90 or -90..90 for types A and B")
        if angles[0] == 0:
            self.assumptions.append(f"the planes 0 to {angles[-1]:g} deg represent both sides")
            angles = numpy.concatenate([-angles[:0:-1], angles])
            values = numpy.concatenate([values[:0:-1], values])
        ends = [(side_angles[0], side_angles[-1]) for side_angles in (self.vertical, angles)]
        if ends != [vertical, horizontal]:
            (a, b), (c, d) = ends
            self.assumptions.append(
                f"no light beyond V of {a:g} to {b:g} and H of {c:g} to {d:g} deg, as in the table"
            )
        return angles, values

    def check_range(self, what: str, low: float, high: float) -> None:
        angles = getattr(self, what)
        if angles[0] < low or angles[-1] > high:
            raise self.error(what, f"{what} angles from {low} to {high} deg")

    def error(self, what: str, hint: str) -> ConditionError:
        angles = getattr(self, what)
        later_angles = len(self.horizontal) if what == "vertical" else 0
        span = f"{angles[0]:g} to {angles[-1]:g}" if len(angles) > 1 else f"{angles[0]:g}"
        return self.numbers.error(
            self.start - 1 - later_angles, f"the {what} angles are {span} deg", hint
        )
