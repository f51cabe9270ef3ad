"""How a user names what surrounds a place: a map, a sky or an expression."""

from typing import NamedTuple

from radcalc.distributions.radiances import FormulaRadiances, Radiances
from radcalc.distributions.sources import WORD, formula_with_unit, unseen
from radcalc.errors import ConditionError, quote
from radcalc.quantities.light import KINDS, light_dimension

EXAMPLE = "sky:overcast, or 'max(cos(theta), 0) cd/m2'"
RADIANCES = {light_dimension(kind, (0, 1, 1), ""): kind for kind in KINDS}


class Environment(NamedTuple):
    """Radiances, and what is to be said of them.

    Attributes
    ----------
    radiances : Radiances
        By direction.
    efficacy : float [lm/W]
        What its watts count, where its format says so; else 0.
    luminance : str
        How a radiance follows from the channels of a map; else empty.
    reference : str
        Where that comes from.
    assumptions, notes : tuple of str
        What was assumed in reading it, and what is odd.
    """

    radiances: Radiances
    efficacy: float = 0.0
    luminance: str = ""
    reference: str = ""
    assumptions: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()


def expression(text: str) -> Environment:
    """An expression in theta (polar angle from +z) and phi (azimuth from +x), and its unit.

    Parameters
    ----------
    text : str
        As `radcalc.distributions.sources.formula_with_unit` takes it.

    Returns
    -------
    Environment

    Raises
    ------
    ConditionError, UnitError
        If it is no expression, or its unit is none of a radiance.

    Examples
    --------
    >>> round(expression("3000 cd/m2").radiances.mean(), 6)
    3000.0
    """
    from radcalc.geometry.numerics.expression import CONSTANTS, NAMES

    if WORD.fullmatch(text) and text not in (*NAMES, *CONSTANTS):
        raise ConditionError(f"'{quote(text)}' is no sky or expression", EXAMPLE)
    found = formula_with_unit(text, "radiance", RADIANCES, "cd/m2")
    return Environment(FormulaRadiances(found), assumptions=unseen(found))
