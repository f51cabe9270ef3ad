"""Distributions as a user gives them: a file, an expression with or without a unit, an exact shape.

Expressions are in theta and phi; shapes are relative to the intensity on the axis.

The contents of a file determine its format: an IES file has a line with its edition or with TILT=,
an EULUMDAT file only numbers in its lines 2 to 7, a table has rows of numbers.  If the contents
match none of them, the extension selects the reader, which then reports the error.
"""

import math
import os
import re
from collections.abc import Mapping, Sequence
from functools import cached_property
from importlib import import_module
from itertools import islice
from typing import Any

import numpy

from radcalc import geometry
from radcalc.distributions import contents
from radcalc.distributions.distribution import (
    ALL_AZIMUTHS,
    ALL_POLAR,
    Distribution,
    Interval,
    Peak,
    Photometry,
    integrated,
)
from radcalc.errors import ConditionError, Hint, RadcalcError, correct, corrections, nearest, quote
from radcalc.files import columns, signatures
from radcalc.geometry.numerics.cubature import ROUNDING, Integral, Steps, narrowest
from radcalc.geometry.numerics.expression import Expression
from radcalc.geometry.projections import TURN, cartesian
from radcalc.geometry.solid import zone
from radcalc.maths import Number
from radcalc.quantities import KINDS, describe, light_dimension
from radcalc.quantities import read as read_light
from radcalc.quantities.symbols import DISTRIBUTIONS, light_unit
from radcalc.units import Dimension, Unit
from radcalc.units.table import resolve

MOST_BYTES = 1 << 26  # of a file
ROWS = 3  # rows that identify a table
END_IN_DOS = "\x1a"  # end of a text
NO_TEXT = bytes({*range(32), 127} - set(b"\t\n\v\f\r\x1a"))  # bytes
UTF16 = (b"\xff\xfe", b"\xfe\xff")
READERS = {".ies": "ies", ".ldt": "eulumdat", ".csv": "tables"}  # modules, by extension
KNOWN = "an IES (LM-63) or EULUMDAT file, or a table with a column of angles"


def read_file(path: str) -> Photometry:
    """Read a photometric file or a table, of 64 MiB at most, or standard input (-).

    Raises
    ------
    ConditionError
        If it cannot be read, is not text, or has none of the three formats; also the errors of
        the format's reader, with the line.
    """
    name, lines = read_lines(path, KNOWN)
    reader = _by_content(lines) or READERS.get(os.path.splitext(path)[1].lower())
    if not reader:
        raise ConditionError(f"{name} is {_likeness(lines)}", KNOWN)
    # load only the module that is needed
    photometry: Photometry = import_module(f"radcalc.distributions.{reader}").read(lines, name)
    grid: Any = photometry.distribution
    return photometry._replace(
        notes=(*photometry.notes, *photometry.contradictions(), *grid.contradictions())
    )


def read_lines(path: str, expected: str) -> tuple[str, list[str]]:
    """Return the name of a text in messages, and its lines without line ends, in any encoding.

    At least one line is not blank.  Raise a ConditionError if it cannot be read, or is not text.
    """
    name, data = contents.read_bytes(path, MOST_BYTES, expected)
    return name, _lines(data, name, expected)


def _lines(data: bytes, name: str, expected: str) -> list[str]:
    """Return the lines of a text in UTF-8, or else in Latin-1, with any line ends."""
    if data.startswith(UTF16):
        raise ConditionError(f"{name} is text in UTF-16", "the same in UTF-8 (iconv converts it)")
    if len(data.translate(None, NO_TEXT)) < len(data):
        place = next(k for k, byte in enumerate(data) if byte in NO_TEXT)
        raise ConditionError(f"{name} is not text: byte {place} is {data[place]}", expected)
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = data.decode("latin-1")
    stripped = text.rstrip()
    if stripped.endswith(END_IN_DOS):
        text = stripped.rstrip(END_IN_DOS)
    text = text.rstrip("\r\n")  # not tabs: the last line may end with blank cells
    if not text.strip():
        raise ConditionError(f"{name} is empty", expected)
    return text.replace("\r\n", "\n").replace("\r", "\n").split("\n")


def _by_content(lines: Sequence[str]) -> str:
    """Return the module that can read the lines, or ""."""
    return signatures.of_luminaire(lines) or ("tables" if _has_rows(lines) else "")


def _has_rows(lines: Sequence[str]) -> bool:
    """Return whether rows of columns begin with a number, after up to two rows of titles."""
    texts = (line.strip() for line in lines)
    rows = list(islice((text for text in texts if _is_data(text)), ROWS))
    rows = rows[2:] or rows[1:] or rows  # after titles and units
    split = [(columns.cells(row, columns.dialect(row)[0]), columns.dialect(row)[1]) for row in rows]
    return bool(rows) and all(
        len(cells) > 1 and columns.is_number(cells[0], comma) for cells, comma in split
    )


def _is_data(text: str) -> bool:
    return bool(text) and not columns.is_comment(text)


def _likeness(lines: Sequence[str]) -> str:
    """Describe a text that has none of the formats."""
    first = next(line.strip() for line in lines if line.strip())
    if first.startswith(("<", "{")):
        return "XML or HTML" if first[0] == "<" else "JSON"
    return f"not a photometric file: it begins with '{quote(first)}'"


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
        self.text, self.unit, self.kind, self.quantity = text, unit, kind, quantity
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
        problem = f"the {self.quantity} '{quote(self.text)}' has {what} at {angles}"
        raise ConditionError(problem, hint)

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
        geometry.cone(half_angle)  # raises an error if it is out of range
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
        geometry.lobe(exponent)  # raises an error if it is out of range
        self.exponent = exponent
        self.finest = geometry.lobe_angle(exponent, 0.5) / 2

    def intensity(self, theta: Number, phi: Number) -> Number:
        ahead = numpy.asarray(theta) <= math.pi / 2
        return numpy.maximum(numpy.cos(theta), 0.0) ** self.exponent * ahead + 0.0 * phi

    def flux(self, polar: Interval = ALL_POLAR, azimuth: Interval = ALL_AZIMUTHS) -> Integral:
        inner, outer = (geometry.lobe_part(self.exponent, angle) for angle in polar)
        turn = (azimuth[1] - azimuth[0]) / (2 * math.pi)
        return _exactly(geometry.lobe(self.exponent) * (outer - inner) * turn)


def _exactly(value: float) -> Integral:
    return Integral(value, ROUNDING * value, 0)


EXAMPLE = "a file (IES, EULUMDAT, CSV), or an expression such as '300*cos(theta)^4 cd'"


def path_pattern(endings: str) -> re.Pattern[str]:
    """Return a pattern that recognises a path, by its beginning or by one of the endings."""
    return re.compile(rf"^(\.{{0,2}}/|~|[A-Za-z]:\\)|\.({endings})$", re.IGNORECASE)


PATH = path_pattern("ies|ldt|csv|tsv|txt|dat")
# Other words for distributions.
MEANT = {
    "spot": ("lobe", "cone"),
    "spotlight": ("lobe", "cone"),
    "beam": ("lobe", "cone"),
    "gaussian": ("lobe",),
    "uniform": ("isotropic", "cone"),
    "sphere": ("isotropic",),
    "lambertian": ("max(cos(theta), 0)",),
    "cosine": ("max(cos(theta), 0)",),
}
WORD = re.compile(r"[^\W\d][\w-]*")
# After an expression and a blank, a letter can only begin a unit.
UNIT = re.compile(r"^(.*?[\w.)])\s+([^\W\d].*)$", re.DOTALL)
INTENSITIES = {light_dimension(kind, (0, 0, 1), ""): kind for kind in KINDS}


def photometry(source: Any) -> Photometry:
    """Read a distribution as a user gives it.

    `source` is the path of a file; an expression in theta and phi, followed by a blank and a unit
    of intensity, or relative without a unit; or a distribution.

    Raises
    ------
    ConditionError, UnitError
        If a text is neither a file nor an expression, if its unit is not a unit of intensity, or
        if the file cannot be read.

    Examples
    --------
    >>> spot = photometry("2*max(cos(theta), 0)^4 kcd").distribution
    >>> spot.kind, float(spot.intensity(0.0, 0.0))
    ('v', 2000.0)
    """
    if isinstance(source, Photometry):
        return source
    if hasattr(source, "intensity") and hasattr(source, "flux"):
        return Photometry(source, type(source).__name__)
    text = os.fspath(source).strip() if isinstance(source, (str, os.PathLike)) else ""
    if not text:
        raise ConditionError(f"'{quote(str(source))}' is not a distribution", EXAMPLE)
    if text == "-" or os.path.exists(text):
        return read_file(text)
    if PATH.search(text) or isinstance(source, os.PathLike):
        raise ConditionError(f"cannot read '{quote(text)}': no such file", "the path of a file")
    return _expression(text)


def _expression(text: str) -> Photometry:
    if is_unknown_word(text):
        near = MEANT.get(text.lower()) or nearest(text.lower(), DISTRIBUTIONS)
        problem = f"unknown distribution '{quote(text)}' (and no such file)"
        hint = f"{', '.join(near or DISTRIBUTIONS)}, or {EXAMPLE}"
        raise ConditionError(problem, hint, corrections(text, *near))
    formula = formula_with_unit(text, "intensity", INTENSITIES, "cd")
    return Photometry(formula, "expression", text, assumptions=unseen(formula))


def is_unknown_word(text: str) -> bool:
    """Return whether a text is a single word that cannot be an expression."""
    from radcalc.geometry.numerics.expression import CONSTANTS, NAMES

    return bool(WORD.fullmatch(text)) and text not in (*NAMES, *CONSTANTS)


def unseen(formula: Any) -> tuple[str, ...]:
    """Return an assumption about peaks of an expression that may be missed, if any."""
    if not formula.expression.uses:
        return ()
    return (f"peaks narrower than {math.degrees(formula.unseen):.2g} deg may be missed",)


def formula_with_unit(
    text: str, quantity: str, kinds: Mapping[Dimension, str], example: str
) -> Any:
    """Read an expression, followed by a blank and a unit of `kinds`, or relative without a unit.

    `kinds` are the accepted dimensions of the unit, with their kinds of light; `quantity` and
    `example` are for messages.

    Raises
    ------
    ConditionError, UnitError
        If the text is not an expression, or its unit does not belong to the quantity.
    """

    parts = UNIT.match(text)
    if not parts:
        return Formula(text, quantity=quantity)
    unit = _unit(parts[2], text)
    if unit.dimension not in kinds:
        what = f"{'an' if quantity[0] in 'aeiou' else 'a'} {quantity}"
        light = read_light(unit)
        likely = light_unit(quantity, light.kind).replace(" ", ".") if light else example
        raise ConditionError(
            f"'{quote(parts[2])}' after the expression is {describe(unit)}, not {what}",
            f"{what} after it, '{quote(parts[1])} {example}', or no unit",
            [correct(text, f"{parts[1]} {likely}")],
        )
    return Formula(parts[1], unit.factor, kinds[unit.dimension], parts[2], quantity)


def _unit(text: str, source_text: str) -> Unit:
    """Return the unit after an expression; if it is a part of the expression, raise its error."""
    try:
        return resolve(text)
    except RadcalcError:
        from radcalc.geometry.numerics import expression

        words = {*expression.NAMES, *expression.CONSTANTS, *expression.FUNCTIONS}
        if words.intersection(re.findall(r"\w+", text)):
            expression.Expression(source_text)  # raises the error
        raise
