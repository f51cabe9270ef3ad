"""The facts of a sentence: the light that their amounts measure, and the places that they mean."""

from radcalc.quantities.light import Reading
from radcalc.quantities.light import read as read_light
from radcalc.quantities.symbols import (
    SYMBOLS,
)
from radcalc.sentences.reader import Fact
from radcalc.sentences.words import Amount
from radcalc.units import NUMBER, dimensions

VALUE = "value"  # the amount that is converted
LIGHT = ("flux", "intensity", "exitance", "irradiance", "radiance", "exposure", "energy")
Facts = dict[str, Fact]
# Facts that an amount of that dimension may fill, if no phrase says which.
OF_DIMENSION = {
    dimensions.LENGTH: ("distance",),
    dimensions.AREA: ("area",),
    dimensions.TIME: ("time",),
    dimensions.ANGLE: ("apex-angle", "incidence", "half-angle"),
}
# Words for light that is not that of a lamp.
DAYS = ("sun", "sunlight", "full sun", "solar", "daylight", "skylight", "moonlight")
# Correlated colour temperatures [K] of the white LEDs of the CIE, as `spectrum` gives them.
LEDS = {"LED-B1": 2735, "LED-B2": 2999, "LED-B3": 4102, "LED-B4": 5106, "LED-B5": 6591}


def is_efficacy(fact: Fact) -> bool:
    """Return whether a fact is a ratio of two kinds of light, such as lm/W."""
    amount = fact.amount
    return amount is not None and amount.dimension in SYMBOLS["efficacy"].dimensions


def is_number(fact: Fact) -> bool:
    """Return whether a fact is a number alone, or one with a name, as `nd 0.6`."""
    amount = fact.amount
    is_named = bool(fact.symbols) and amount is not None and amount.dimension == NUMBER
    return is_named or is_bare(fact)


def is_bare(fact: Fact) -> bool:
    """Return whether a fact is a number alone, without a name and without a unit."""
    return not fact.symbols and fact.amount is not None and fact.amount.unit.text == "1"


def is_lamp(fact: Fact) -> bool:
    """Return whether a fact is a spectrum by a word of everyday language: led, sun, daylight."""
    return fact.symbols == ("spectrum",) and fact.text.replace(" ", "").isalpha()


def light_of(amount: Amount) -> Reading | None:
    """Return the light that an amount measures; None for a density, a scale or no light."""
    light = read_light(amount.unit)
    return light if light and not light.axis and not amount.unit.is_scale else None


def quantities_meant(amount: Amount) -> tuple[str, ...]:
    """Return the symbols that a unit means."""
    if light_of(amount):
        return (generic(amount) or VALUE,)
    if amount.is_wavelength:
        return ("wavelength",)
    for name in ("efficacy", "responsivity"):
        if amount.dimension in SYMBOLS[name].dimensions:
            return (name,)
    return OF_DIMENSION.get(amount.dimension, (VALUE,))


def is_light(fact: Fact) -> bool:
    """Return whether a fact is an amount of light, with or without its name."""
    is_named = any(SYMBOLS[name].geometry for name in fact.symbols if name in SYMBOLS)
    is_alone = not fact.symbols and fact.amount and read_light(fact.amount.unit)
    return bool(is_named or is_alone)


def generic(amount: Amount) -> str:
    """Return the generic name of a light quantity: flux, intensity, irradiance, radiance ..."""
    if amount.unit.is_exitance:
        return "exitance"
    names = [name for name in LIGHT[::-1] if amount.dimension in SYMBOLS[name].dimensions]
    return next((name for name in names if name != "exitance"), "")
