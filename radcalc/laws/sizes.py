"""Lengths [m] and areas [m2] of flat sources and receivers, and offsets of receivers [m]."""

from collections.abc import Container
from typing import Any

from radcalc.geometry import cones
from radcalc.laws.law import AnyLaw, law, relation
from radcalc.maths import sqrt, square

RECTANGLE = law("area of a rectangle", "{area} = {width} {length}")
CIRCLE = law("area of a circle", "{area} = pi {radius}^2")
DIAMETER = law("diameter", "{diameter} = 2 {radius}")
OFFSET = law("offset", "{offset} = {lateral}")


def _aspect(ratio: Any) -> Any:
    """Return the aspect a >= 1 with a + 1/a equal to a ratio."""
    cones.refuse(
        ratio < 2, "the diagonal is too short for that area", "more diagonal, or less area"
    )
    return (ratio + sqrt((ratio - 2) * (ratio + 2))) / 2


ASPECT = relation(
    "aspect of a rectangle, by its area and diagonal",
    "{diagonal}^2 = {area} ({aspect} + 1 / {aspect})",
    {"aspect": lambda at: _aspect(square(at("diagonal")) / at("area"))},
)._replace(has_limit=True)


def round_sizes(given: Container[str]) -> list[AnyLaw]:
    """Choose the laws of a round shape in addition to those of its radius.

    Parameters
    ----------
    given : container of str
        The given symbols.

    Returns
    -------
    list of Law
        The law of the diameter if that is given; otherwise the answer has no diameter.

    Examples
    --------
    >>> [law.template for law in round_sizes(["diameter"])], round_sizes(["radius"])
    (['{diameter} = 2 {radius}'], [])
    """
    return [DIAMETER] if "diameter" in given else []
