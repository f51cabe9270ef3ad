"""The constants of arithmetic: `h*c/(500 nm)`; their values are compiled from `light.txt`.

A short spelling may also be a unit (h, g), or a number (e): `HOMONYMS`.  In a product with c or h,
whose laws count cycles and photons as 1, the target decides whether they are counted.
"""

from radcalc.floats import divide
from radcalc.units.compiled import CONSTANTS, NOTES, SPELLINGS_OF_CONSTANTS
from radcalc.units.dimensions import COHERENT
from radcalc.units.table import resolve
from radcalc.units.unit import (
    BASES,
    COUNT_AT,
    CYCLE_AT,
    LUMINOSITY_AT,
    MASS_AT,
    TIME_AT,
    Dimension,
    Unit,
    lookup,
)
from radcalc.units.words import word_at

ANGLE_AT = BASES.index("angle")
LIGHT, PLANCK, REDUCED = "speed_of_light", "planck_constant", "reduced_planck_constant"
EULER = "e"
HOMONYMS = tuple([s for s in SPELLINGS_OF_CONSTANTS if s == EULER or lookup(s)])
BASE_UNITS = ("m", "kg", "s", "K", "rad", "cycle", "photon", "cd", "td", "A")  # as BASES


class OfConstants(Unit):
    """The coherent unit of an expression with constants, with their powers."""

    __slots__ = ("powers",)
    powers: dict[str, int]

    def fitting(self, dimension: Dimension) -> Unit | None:
        """Return the unit in another dimension that counts cycles and photons; None if unlike."""
        if dimension == self.dimension:
            return self
        free = _uncounted(self.powers)
        if any(
            a != b and place not in free
            for place, (a, b) in enumerate(zip(self.dimension, dimension, strict=True))
        ):
            return None
        photons = dimension[COUNT_AT] - self.dimension[COUNT_AT]
        if photons and photons != -_planck(self.powers):
            return None
        counted = "a photon" if photons else "a cycle"
        note = f"{counted} counts as 1 in a formula with c or h"
        return resolve(_text(dimension)).of_class(Unit, *self.notes, note)


def value(name: str) -> float:
    """Return a constant in coherent SI, rounded once."""
    top, bottom, _ = CONSTANTS[name]
    return divide(top, bottom)


def plain_spelling(name: str) -> str:
    """Return the short spelling of a constant that is not ambiguous: h_planck."""
    return next(s for s, named in SPELLINGS_OF_CONSTANTS.items() if named == name)


def homonyms(text: str) -> list[str]:
    """Return the short spellings in a text that have another meaning too."""
    found, at = [], 0
    while at < len(text):
        word = word_at(text, at)
        if word in HOMONYMS:
            found.append(word)
        at += len(word) or 1
    return list(dict.fromkeys(found))


def quantity(dimension: Dimension, powers: dict[str, int]) -> Dimension:
    """Return the dimension of a product with constants, with cycles and angles counted as 1."""
    plain = list(dimension)
    if LIGHT in powers or PLANCK in powers or REDUCED in powers:
        plain[CYCLE_AT] = 0
    if REDUCED in powers:
        plain[ANGLE_AT] -= powers[REDUCED] if plain[ANGLE_AT] else 0
    return tuple(plain)


def unit(dimension: Dimension, units: dict[str, int]) -> OfConstants:
    """Return the unit for display of a product with constants."""
    plain = quantity(dimension, units)
    made = resolve(_text(plain)).of_class(OfConstants)
    made.powers = {name: power for name, power in units.items() if name in CONSTANTS}
    made.notes += tuple([NOTES[name] for name in made.powers if name in NOTES])
    return made


def fit(source: Unit, dimension: Dimension) -> Unit:
    """Return the unit of an expression, with cycles and photons as a dimension counts them."""
    if not isinstance(source, OfConstants):
        return source
    return source.fitting(dimension) or source


def _planck(powers: dict[str, int]) -> int:
    return powers.get(PLANCK, 0) + powers.get(REDUCED, 0)


def _uncounted(powers: dict[str, int]) -> tuple[int, ...]:
    """Return the places in a dimension that count as 1 in a product with these constants."""
    places: tuple[int, ...] = ()
    if LIGHT in powers or _planck(powers):
        places = (CYCLE_AT,)
    if _planck(powers):
        places += (COUNT_AT,)
    return (*places, ANGLE_AT) if REDUCED in powers else places


def _text(dimension: Dimension) -> str:
    """Return the text of the coherent unit of a dimension: J, W/m2/K, lm or (J.m)."""
    text = COHERENT.get(dimension, "")
    if text and resolve(text).dimension == dimension:
        return text
    powers = list(dimension)
    head = _head(dimension)
    if head:
        powers = [a - b for a, b in zip(dimension, resolve(head).dimension, strict=True)]
    over = [head] if head else []
    over += [_raised(name, n) for name, n in zip(BASE_UNITS, powers, strict=True) if n > 0]
    under = [_raised(name, -n) for name, n in zip(BASE_UNITS, powers, strict=True) if n < 0]
    product = f"({'.'.join(over)})" if len(over) > 1 else "".join(over) or "1"
    return "/".join([product, *under])


def _raised(name: str, power: int) -> str:
    return f"{name}{power}" if power > 1 else name


def _head(dimension: Dimension) -> str:
    """Return the derived unit in a dimension: W, J, lm, cd or none."""
    if dimension[MASS_AT] == 1:
        return "W" if dimension[TIME_AT] == -3 else "J"
    if dimension[LUMINOSITY_AT] == 1:
        return "lm" if dimension[ANGLE_AT] == 2 else "cd"
    return ""
