"""Units and C planes in the titles of a table of angles and intensities."""

import re
from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

from radcalc.errors import ConditionError, UnitError, quote
from radcalc.files.columns import IN_BRACKETS, plain, units_in
from radcalc.quantities import NONE, describe, read
from radcalc.quantities.column_titles import Title, read_title, refuse_altered
from radcalc.units import NUMBER, Unit
from radcalc.units.dimensions import ANGLE
from radcalc.units.table import resolve, unit_of

INTENSITY = (0, 0, 1)  # the powers of time, 1/area and 1/solid angle
SHORT = 6  # words of a comment that may be a title
ANGLE_WORDS = re.compile(r"gamma|theta|polar|angle|vertical|winkel|γ|θ|ϑ")
OF_ANGLE = re.compile(rf"(?<![a-z])a?(?:sin|cos|tan)|\d\s*(?:{ANGLE_WORDS.pattern})")
OTHER_ANGLES = re.compile(r"elevation|altitude|azimut|horizontal|phi|latitude|zenith")
DEGREES = r"([-+]?\d+(?:[.,]\d+)?)\s*(?:°|deg)?"
# A plane, and the opposite one: C0, C 22.5 deg, phi=45, 90, C0-C180, C0/180.
PLANE = re.compile(
    rf"(?P<letter>c|phi|φ|ϕ)?\s*=?\s*{DEGREES}(?:\s*[-–/]\s*c?\s*{DEGREES})?(?![\w.])",
    re.IGNORECASE,
)
OTHER_WORDS = re.compile(
    r"(?:il)?luminance|radiance"
    r"|(?<![a-z])(?:flux|lux|lumens?|exposure|d[b]m?|log|lg|ln|log10|squared|errors?|uncertainty"
    r"|stdev?|cumulative|exitance|wavelengths?|distance)(?![a-z])"
)
RELATIVE = re.compile(r"|%|-|1|rel\.?|relative|norm(?:ali[sz]ed|\.)?|arb.*|a\. ?u\.|au")
PER_FLUX = re.compile(r"cd\s*/\s*\(?\s*(?:k|1000\s*)?lm|cd\s+per\b")
# The unit in a comment: I (cd), unit: cd, intensities in cd, cd.
STATED = re.compile(r"(?:^|\bin |[:=/]|(?=[(\[]))\s*(\S+)$")
KNOWN = "an intensity in cd, mcd, W/sr, mW/sr or the like, or no unit for relative values"


class Column(NamedTuple):
    """C planes [deg] and unit in the title of a column of intensities, if it has them.

    `opposite` is the opposite plane of a title such as C0-C180.
    """

    plane: float | None
    opposite: float | None
    unit: Unit | None


def angles(title: str) -> Unit | None:
    """Return the unit of angle in the title of the first column, or None.

    Raise a ConditionError if the title is not that of polar angles.

    >>> angles("theta [rad]")
    Unit('rad')
    >>> angles("gamma")
    """
    text, unit = plain(title), _read(title.replace("º", "°"), resolve("deg")).unit
    has_other = unit.dimension != ANGLE if unit else bool(units_in(title)[0])
    if has_other or OF_ANGLE.search(text):
        raise ConditionError(
            f"'{quote(title)}' in the first column is not an angle", "polar angles in it"
        )
    if OTHER_ANGLES.search(text) or not (unit or not text or ANGLE_WORDS.search(text)):
        raise ConditionError(
            f"'{quote(title)}' in the first column is not a polar angle from the source's axis",
            "a title such as gamma, theta or angle (deg)",
        )
    return unit


def column(title: str) -> Column:
    """Read the title of a column; raise a ConditionError if it is not that of intensities.

    >>> column("I (cd)")
    Column(plane=None, opposite=None, unit=Unit('cd'))
    """
    plane_match = PLANE.match(title)
    after_plane = title[plane_match.end() :].strip().lstrip("/ ") if plane_match else title
    is_bare = not after_plane or IN_BRACKETS.fullmatch(after_plane)
    if plane_match and not (
        is_bare or (plane_match["letter"] and unit_of(after_plane))
    ):  # not a plane, as in "2 m from the lamp"
        plane_match, after_plane = None, title
    plane, opposite = (
        (_number(plane_match[2]), _number(plane_match[3])) if plane_match else (None, None)
    )
    text = plain(after_plane)
    if PER_FLUX.search(text):
        raise ConditionError(
            f"'{quote(title)}' is relative to the flux of lamps, which the table does not have",
            "the values times that flux, in cd",
        )
    unit = _intensity(after_plane)
    if not unit and OTHER_WORDS.search(text):
        raise ConditionError(f"'{quote(title)}' is not an intensity", KNOWN)
    return Column(plane, opposite, unit)


def _number(text: str | None) -> float | None:
    return float(text.replace(",", ".")) if text else None


def in_comments(comments: Sequence[str]) -> Unit | None:
    """Return the unit of intensity in a short comment such as `# I (cd)`, or None.

    Raise a ConditionError if comments have different units.
    """
    units: dict[tuple[object, float], Unit] = {}
    for comment in comments:
        stated = STATED.search(comment)
        if len(comment.split()) > SHORT:
            continue
        try:
            _read(comment)
            unit = _intensity(stated[1] if stated else "")
        except ConditionError:  # a comment is free text
            continue
        if unit:
            units[unit.dimension, unit.factor] = unit
    if len(units) > 1:
        unit_texts = " and ".join(quote(unit.text) for unit in units.values())
        raise ConditionError(
            f"the comments have different units: {unit_texts}",
            "the unit in the titles of the columns",
        )
    return next(iter(units.values()), None)


@lru_cache(16)
def _intensity(title: str) -> Unit | None:
    """Return the unit of intensity in a title, or None; raise an error for another unit."""
    unit = _read(title).unit
    if unit is None or unit.dimension == NUMBER:
        unknown_units = [text for text in units_in(title)[0] if not RELATIVE.fullmatch(plain(text))]
        if unknown_units:
            raise ConditionError(f"'{quote(unknown_units[0])}' is not a unit of intensity", KNOWN)
        return None
    facts = read(unit)
    if facts and facts.geometry == INTENSITY and facts.axis == NONE and not unit.is_scale:
        return unit
    raise ConditionError(f"the values are in {describe(unit)}", KNOWN)


def _read(title: str, like: Unit | None = None) -> Title:
    """Read a title; its numbers, if any, must belong to its unit."""
    try:
        parsed = read_title(title, like)
        if parsed.unit is None:
            refuse_altered(read_title(title.replace("%", " "), like))  # of the peak
    except UnitError as error:
        raise ConditionError(error.message, KNOWN if like is None else error.hint) from None
    return parsed
