"""Quantities of Pint in the registry of radcalc."""

import sys
from collections.abc import Callable, Mapping
from functools import wraps
from typing import TYPE_CHECKING, Any, TypeAlias

from radcalc.answer import Row, in_short
from radcalc.errors import ConversionError, RadcalcError, UnitError, quote
from radcalc.maths import frozen
from radcalc.quantities.light import describe
from radcalc.units.registry import (
    Dimensionality,
    DimensionalityError,
    from_container,
    light_registry,
)
from radcalc.units.unit import Unit

if TYPE_CHECKING:
    import pint

    Quantity: TypeAlias = pint.Quantity[Any]
else:
    Quantity = light_registry().Quantity


def is_quantity(value: Any) -> bool:
    """Return whether a value is a quantity; refuse one of another registry."""
    own = getattr(value, "_REGISTRY", None) is light_registry()  # also a Measurement
    other = getattr(value, "magnitude", None) if own else value
    if hasattr(other, "magnitude"):
        raise UnitError(
            f"'{quote(str(other))}' is a quantity of another registry",
            "radcalc.Quantity(q.magnitude, str(q.units)), where q is that quantity",
        )
    return own


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


def typed(value: Any) -> str:
    """Return a quantity as it would be typed."""
    return f"{str(value.magnitude).removesuffix('.0')} {unit_of(value).text}"


def row_of(value: Any) -> Row:
    """Return a number, or a quantity, as a row of an answer."""
    return Row("", "", magnitude_of(value), unit_of(value).text if is_quantity(value) else "1")


class OtherQuantity(ConversionError, Dimensionality):
    """A unit of another quantity: an error of radcalc, and of Pint for those who catch that."""


def _in_words(pint_method: Callable[..., Any]) -> Callable[..., Any]:
    """Return a method of Pint that refuses a unit in the words of `radcalc.convert`."""

    @wraps(pint_method)
    def to(self: Any, other: Any = None, *contexts: Any, **settings: Any) -> Any:
        if not (isinstance(other, (str, Mapping)) or hasattr(other, "_REGISTRY")):
            problem = f"a unit is a text, not {type(other).__name__}"
            raise UnitError(problem, "a text such as 'lx'")
        try:
            return pint_method(self, other, *contexts, **settings)
        except (DimensionalityError, UnitError) as error:
            refusal = _refusal(self, other)
            if isinstance(error, DimensionalityError):
                refusal = OtherQuantity(refusal.message, refusal.hint)
        raise refusal

    return to


def _refusal(value: Any, other: Any) -> RadcalcError:
    """Return the error for a unit of another quantity, or a text that is not a unit."""
    target = other if isinstance(other, str) else from_container(other._units).text
    try:
        converted = sys.modules["radcalc"].convert(value, target)
    except RadcalcError as error:
        return error
    is_one = isinstance(value.magnitude, (int, float))
    problem = f"'{quote(target)}' is not a unit of {describe(unit_of(value))}"
    shown = f'"{typed(value)}"' if is_one else "quantity"
    hint = f'radcalc.convert({shown}, "{target}")'
    problem = f"{problem}, and Quantity.to keeps the quantity"
    return UnitError(problem, f"{hint}\n     {in_short([row_of(converted)])}" if is_one else hint)


def _reduced(measure: Any) -> tuple[Any, ...]:
    return _restored, (
        type(measure).__name__,
        getattr(measure, "magnitude", None),
        dict(measure._units),
    )


def _restored(kind: str, magnitude: Any, powers: Mapping[str, int]) -> Any:
    registry = light_registry()
    for name in powers:
        registry.get_name(name)  # defines a prefixed unit
    units = registry.UnitsContainer(powers)
    return getattr(registry, kind)(*([] if magnitude is None else [magnitude]), units)


def _adapt() -> None:
    """Change two things in Pint's classes: the registry of pickles, and the words of refusals."""
    registry = light_registry()
    for kind in (registry.Quantity, registry.Measurement, registry.Unit):
        kind.__reduce__ = _reduced  # type: ignore[method-assign]
    for quantities in (registry.Quantity, registry.Measurement):
        for name in ("to", "ito"):
            setattr(quantities, name, _in_words(getattr(quantities, name)))


_adapt()
