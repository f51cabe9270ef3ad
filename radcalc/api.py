"""The Python API: Pint quantities in and out, arrays welcome."""

from collections.abc import Callable
from typing import Any

from radcalc.answer import Answer, Result
from radcalc.conversion.conditions import OPTIONS, Given, give
from radcalc.conversion.plan import Plan, answer, plan
from radcalc.errors import ConditionError, UnitError, nearest, quote
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


def point_source(
    *, distribution: str | None = None, any_incidence: bool = False, **given: Any
) -> dict[str, Any]:
    """Everything that follows for a source that is small beside its distance.

    Parameters
    ----------
    distribution : {"isotropic", "cone", "lobe"}, optional
        How its light is spread, where no option of a cone or a lobe tells.
    any_incidence : bool
        Work out the incidence, in place of taking it as 0.
    **given : str, Quantity or float
        As the options of ``radcalc point-source``, with underscores: ``flux="800 lm"``,
        ``distance=Quantity(array, "m")``.  Arrays are broadcast together.

    Returns
    -------
    dict of str to Quantity
        What was given and what follows, by the names of ``--get`` with underscores.

    Raises
    ------
    radcalc.errors.RadcalcError
        What is missing, contradictory, impossible or without use.

    Examples
    --------
    >>> print(point_source(flux="800lm", distance="2m")["irradiance"].round(3))
    15.915 lux
    """
    from radcalc.calculators.point_source import DISTRIBUTIONS
    from radcalc.calculators.point_source import point_source as law

    if distribution not in (None, *DISTRIBUTIONS):
        message = f"there is no distribution '{quote(str(distribution))}'"
        raise ConditionError(message, ", ".join(DISTRIBUTIONS))
    return _results(law, _inputs(given), distribution, any_incidence)


def lambertian(
    shape: str = "patch", *, corner: bool = False, perpendicular: bool = False, **given: Any
) -> dict[str, Any]:
    """Everything that follows for a diffuse source or reflector.

    Parameters
    ----------
    shape : {"patch", "disc", "sphere", "rectangle", "plane", "hemisphere"}
        The shape of the source.
    corner, perpendicular : bool
        Of a rectangle: the receiver is under its corner, and its normal runs along the length.
    **given : str, Quantity or float
        As the options of ``radcalc lambertian``, with underscores.

    Returns
    -------
    dict of str to Quantity
        As of `point_source`.

    Raises
    ------
    radcalc.errors.RadcalcError
        As of `point_source`.

    Examples
    --------
    >>> print(lambertian(luminance="100cd/m2", area="0.1m2")["flux"].round(3))
    31.416 lumen
    """
    from radcalc.calculators.lambertian import lambertian as law
    from radcalc.calculators.shapes import SHAPES

    if shape not in SHAPES:
        raise ConditionError(f"there is no shape '{quote(str(shape))}'", ", ".join(SHAPES))
    chosen = {"corner": corner, "perpendicular": perpendicular}
    return _results(law, shape, _inputs(given), tuple(name for name, on in chosen.items() if on))


def ev(**given: Any) -> dict[str, Any]:
    """Exposure values, and the light that a meter shows them for.

    Parameters
    ----------
    **given : str, Quantity or float
        As the options of ``radcalc ev``, with underscores.

    Returns
    -------
    dict of str to Quantity
        As of `point_source`.

    Raises
    ------
    radcalc.errors.RadcalcError
        As of `point_source`.

    Examples
    --------
    >>> print(ev(ev100=15)["luminance"])
    4096.0 candela / metre ** 2
    """
    from radcalc.calculators.ev import ev as law

    return _results(law, _inputs(given))


def calorimeter(**given: Any) -> dict[str, Any]:
    """The radiant flux that heats a body, or how warm a flux makes it.

    Parameters
    ----------
    **given : str, Quantity or float
        As the options of ``radcalc calorimeter``, with underscores.

    Returns
    -------
    dict of str to Quantity
        As of `point_source`.

    Raises
    ------
    radcalc.errors.RadcalcError
        As of `point_source`.

    Examples
    --------
    >>> print(calorimeter(energy="7.7J", mass="10g", specific_heat="385J/kg/K")["temperature_rise"])
    2.0 kelvin
    """
    from radcalc.calculators.calorimeter import calorimeter as law

    return _results(law, _inputs(given))


def _inputs(given: dict[str, Any]) -> dict[str, Given]:
    """Read what a calculator is given."""
    from radcalc.calculators import inputs, light

    known = {*inputs.INPUTS, *light.INPUTS, *light.SPECIFIC, *light.LINKS, *light.REFINEMENTS}
    found = {}
    for name, value in given.items():
        option = name.replace("_", "-")
        if option not in known:
            near = nearest(option, known)
            raise ConditionError(f"there is no input '{quote(name)}'", ", ".join(near))
        if value is None:
            continue
        if _is_quantity(value):
            value = (value.magnitude, from_container(value._units))
        found[option] = light.read_any(option, value)
    return found


def _results(law: Callable[..., Answer], *words: Any) -> dict[str, Any]:
    """The results as quantities, each in the first unit it is shown in."""
    from radcalc.calculators.results import in_unit

    try:
        answer = law(*words)
    except ValueError as error:
        if "broadcast" not in str(error):
            raise
        raise ConditionError("the arrays do not fit together", "arrays of one shape") from None
    found: dict[str, Any] = {}
    for value in answer[0]:
        name = value.name.replace("-", "_")
        if value.units and name not in found:
            unit = resolve(value.units[0])
            found[name] = Quantity(in_unit(value, unit), light_registry().container(unit))
    return found


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
