"""The Python API: Pint quantities in and out, arrays welcome."""

from typing import Any

from radcalc.conditions import OPTIONS, Given, give
from radcalc.conversion import Plan, answer, plan
from radcalc.errors import ConditionError, UnitError, quote
from radcalc.result import Result
from radcalc.units.registry import from_container, light_registry
from radcalc.units.table import resolve

Quantity: Any = light_registry().Quantity


def convert(value: Any, target: str, **conditions: Any) -> Any:
    """Convert a quantity to another unit, or to another quantity under conditions.

    Parameters
    ----------
    value : str, Quantity or float
        A text such as ``"100 lx"``, or a `radcalc.Quantity`, whose magnitude may be an array
        of any shape.  A bare number is dimensionless.
    target : str
        The unit of the result.
    **conditions
        As the options of ``radcalc convert``, with underscores: ``wavelength="555nm"``,
        ``half_angle=Quantity(30, "deg")``, ``isotropic=True``.

    Returns
    -------
    Quantity
        In the unit `target`, of the shape of the magnitude of `value` (broadcast with those of
        the conditions).

    Raises
    ------
    radcalc.errors.RadcalcError
        A text that is not a unit, or a condition that is missing, impossible, contradictory or
        without use.

    Examples
    --------
    >>> print(convert("800 lm", "cd", half_angle="60deg").round(3))
    254.648 candela
    """
    made, magnitude = _plan(value, target, conditions)
    return Quantity(made.apply(magnitude), light_registry().container(made.target))


def explain(value: Any, target: str, **conditions: Any) -> Result:
    """Convert as `convert` does, and give what was assumed, noted and derived with the value.

    Parameters
    ----------
    value, target, **conditions
        As in `convert`; a single value, no array.

    Returns
    -------
    radcalc.result.Result
        With `rows`, `assumptions`, `notes` and `steps`.

    Raises
    ------
    radcalc.errors.RadcalcError
        As in `convert`.

    Examples
    --------
    >>> explain("800 lm", "cd", isotropic=True).assumptions
    ('uniform over 4 pi sr (isotropic)',)
    """
    made, magnitude = _plan(value, target, conditions)
    return answer(made, float(magnitude), steps=True)


def _plan(value: Any, target: str, conditions: dict[str, Any]) -> tuple[Plan, Any]:
    """The plan that both need, and the magnitude to apply it to."""
    if not isinstance(target, str):
        raise UnitError(
            f"the unit to convert to is a {type(target).__name__}", "a text such as 'fc'"
        )
    if isinstance(value, str):
        value = light_registry().parse_expression(value)
    elif not _is_quantity(value):
        value = Quantity(value, "1")
    given = [_given(name, condition) for name, condition in conditions.items()]
    made = plan(from_container(value._units), resolve(target), [g for g in given if g])
    return made, value.magnitude


def _is_quantity(value: Any) -> bool:
    if isinstance(value, Quantity):
        return True
    if hasattr(value, "magnitude"):
        raise UnitError(
            f"'{quote(str(value))}' is a quantity of another registry", "radcalc.Quantity"
        )
    return False


def _given(name: str, value: Any) -> Given | None:
    option = name.replace("_", "-")
    if option not in OPTIONS:
        raise ConditionError(f"there is no condition '{quote(name)}'", ", ".join(OPTIONS))
    if value is None or value is False:
        return None
    if _is_quantity(value):
        value = (value.magnitude, from_container(value._units))
    return give(option, value)
