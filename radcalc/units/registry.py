"""The Pint registry of the Python API, built from `light.txt`.

Only this module and `compile.py` import Pint.
"""

from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pint
from pint.util import UnitsContainer

from radcalc.errors import UnitError, quote
from radcalc.units import table
from radcalc.units.reading import read_amount
from radcalc.units.uncertain import variable
from radcalc.units.unit import Unit

DEFINITIONS = Path(__file__).with_name("light.txt")


if TYPE_CHECKING:
    Registry = pint.UnitRegistry[Any]
else:
    Registry = pint.UnitRegistry  # generic in some versions of Pint only


DimensionalityError = pint.DimensionalityError


class Dimensionality(DimensionalityError):
    """Pint's error for a unit of another quantity, with a message of radcalc."""

    __eq__, __hash__ = Exception.__eq__, Exception.__hash__

    def __init__(self, message: str) -> None:
        Exception.__init__(self, message)


class LightRegistry(Registry):
    """A Pint registry of units of light that reads texts as `radcalc convert` does."""

    closed = False  # True once its own definitions are read

    def container(self, unit: Unit) -> UnitsContainer:
        powers: dict[str, int] = {}
        for name, exponent in unit.atoms:
            self.get_name(name)  # defines a prefixed unit in Pint
            powers[name] = powers.get(name, 0) + exponent
        return UnitsContainer({name: power for name, power in powers.items() if power})

    def parse_units_as_container(self, input_string: str, *args: Any, **kwargs: Any) -> Any:
        if not self.closed:
            return super().parse_units_as_container(input_string, *args, **kwargs)
        if not input_string:  # NumPy's functions ask Pint for the unit of a bare number
            return self.UnitsContainer()
        return self.container(table.resolve(input_string))

    def parse_expression(self, input_string: str, *args: Any, **kwargs: Any) -> Any:
        """Read a number and a unit; an uncertain number becomes a variable."""
        if not self.closed:
            return super().parse_expression(input_string, *args, **kwargs)
        amount = read_amount(input_string)
        if amount.scale and amount.scale.others:
            read = " or ".join(scale.unit.text for scale in (amount.scale, *amount.scale.others))
            raise UnitError(f"'{quote(amount.text)}' is ambiguous: {read}", "one of them")
        value: Any = amount.number
        if amount.uncertainty:
            value = variable(value, amount.uncertainty, amount.text)
        return self.Quantity(value, self.container(amount.unit or table.resolve("1")))


def from_container(units: Any) -> Unit:
    """Convert Pint's units to a unit of the table."""
    if any(power != int(power) for _, power in units.items()):
        raise UnitError(f"'{units}' has an exponent that is not a whole number", "whole powers")
    symbol = light_registry().get_symbol
    text = " ".join(
        symbol(name) if power == 1 else f"{symbol(name)}^{int(power)}"
        for name, power in units.items()
    )
    return table.resolve(text or "1")


@cache
def light_registry() -> LightRegistry:
    """Return the registry of the Python API, built once."""
    registry = LightRegistry(
        str(DEFINITIONS), cache_folder=None, autoconvert_offset_to_baseunit=False
    )
    registry.closed = True
    return registry


def exact_registry() -> Registry:
    """Build a registry with exact fractions as factors; a name defined twice is an error."""
    return Registry(
        str(DEFINITIONS), non_int_type=Fraction, cache_folder=None, on_redefinition="raise"
    )
