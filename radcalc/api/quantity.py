"""Quantities of Pint in the registry of radcalc."""

from typing import TYPE_CHECKING, Any, TypeAlias

from radcalc.errors import UnitError, quote
from radcalc.maths import frozen
from radcalc.units.registry import from_container, light_registry
from radcalc.units.unit import Unit

if TYPE_CHECKING:
    import pint

    Quantity: TypeAlias = pint.Quantity[Any]
else:
    Quantity = light_registry().Quantity


def is_quantity(value: Any) -> bool:
    """Return whether a value is a quantity; refuse one of another registry."""
    if isinstance(value, light_registry().Quantity):
        return True
    if hasattr(value, "magnitude"):
        if getattr(value, "_REGISTRY", None) is light_registry():
            return True  # a Measurement from Quantity.plus_minus
        raise UnitError(
            f"'{quote(str(value))}' is a quantity of another registry", "radcalc.Quantity"
        )
    return False


def magnitude_of(value: Any) -> Any:
    """Return the magnitude of a quantity; anything else unchanged."""
    return getattr(value, "magnitude", value)


def is_lazy(value: Any) -> bool:
    """Return whether a value is a Dask collection, or a quantity with one."""
    return hasattr(magnitude_of(value), "__dask_graph__")


def unit_of(quantity: Any) -> Unit:
    """Return the unit of a quantity."""
    return from_container(quantity._units)


def plain(value: Any) -> Any:
    """Return a quantity as a number (or an array) with its unit; anything else unchanged."""
    return (value.magnitude, unit_of(value)) if is_quantity(value) else value


def quantity(magnitude: Any, unit: Unit) -> Quantity:
    """Return a number, or an array, in a unit; nobody can change the array."""
    result: Quantity = Quantity(frozen(magnitude), light_registry().container(unit))
    return result
