"""Distributions as a user gives them: a file, or an expression with or without a unit."""

import math
import os
import re
from collections.abc import Mapping
from typing import Any

from radcalc.distributions.distribution import Photometry
from radcalc.errors import ConditionError, RadcalcError, correct, corrections, nearest, quote
from radcalc.quantities.light import KINDS, describe, light_dimension
from radcalc.quantities.light import read as read_light
from radcalc.quantities.symbols import DISTRIBUTIONS, light_unit
from radcalc.units import Dimension, Unit
from radcalc.units.table import resolve

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
        from radcalc.distributions.files import read_file

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
    from radcalc.distributions.formula import Formula

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
