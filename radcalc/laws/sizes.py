"""Sizes of flat sources and receivers: lengths [m] and areas [m2].

- `RECTANGLE`: A = w l
- `CIRCLE`: A = pi R^2
- `DIAMETER`: D = 2 R
"""

from collections.abc import Container

from radcalc.laws.law import AnyLaw, law

RECTANGLE = law("area of a rectangle", "{area} = {width} {length}")
CIRCLE = law("area of a circle", "{area} = pi {radius}^2")
DIAMETER = law("diameter", "{diameter} = 2 {radius}")


def round_sizes(given: Container[str]) -> list[AnyLaw]:
    """Choose the laws that a round shape has beside those of its radius.

    Parameters
    ----------
    given : container of str
        The symbols that are given.

    Returns
    -------
    list of Law
        That of the diameter where it is given; an answer about a radius has no diameter.

    Examples
    --------
    >>> [law.template for law in round_sizes(["diameter"])], round_sizes(["radius"])
    (['{diameter} = 2 {radius}'], [])
    """
    return [DIAMETER] if "diameter" in given else []
