"""The Python API: Pint quantities in and out, arrays welcome.

Dask's arrays too, where a function works element by element: what depends on them is then an array
of Dask's, and what is impossible among their elements raises its error as that is computed.
"""

from collections.abc import Callable, Iterable
from functools import wraps
from typing import Any, TypeVar

from radcalc.answer import Answer, Result
from radcalc.conversion.conditions import CONDITIONS
from radcalc.conversion.plan import Plan, answer, plan, target_of
from radcalc.errors import (
    ConditionError,
    ConversionError,
    NumberError,
    RadcalcError,
    UnitError,
    nearest,
    option,
    quote,
    spell,
)
from radcalc.given import TOO_FAR, Given, Inputs, any_uncertain, read, read_place, refuse_uncertain
from radcalc.maths import LARGEST, is_array, is_column, is_uncertain
from radcalc.quantities.light import describe
from radcalc.quantities.symbols import (
    DIRECTION,
    FLAG,
    INNER,
    NUMBERS,
    POINT,
    PROJECTIONS,
    SYMBOLS,
    VECTOR,
)
from radcalc.units.amounts import Amount, read_amount
from radcalc.units.dimensions import LENGTH
from radcalc.units.numbers import read_number
from radcalc.units.ranges import real
from radcalc.units.registry import from_container, light_registry
from radcalc.units.scales import in_which, resolve_any
from radcalc.units.table import Unit, resolve

Quantity: Any = light_registry().Quantity
T = TypeVar("T")
FUNCTIONS = (
    "convert",
    "explain",
    "factor",
    "point_source",
    "scene",
    "environment",
    "lambertian",
    "uberlight",
    "sky",
    "ev",
    "calorimeter",
    "laser",
    "room",
    "sensor",
)


ONE_EACH = "one value of each, or without the uncertainty"


class Python:
    """How Python spells the symbols and commands that messages mention."""

    @staticmethod
    def option(name: str, value: str) -> str:
        """`height="6 m"`; a value in capitals stands for any, and a flag is set to True."""
        keyword = name.replace("-", "_")
        if not value:
            return keyword
        if value.isupper() and value.isalpha():
            return f"{keyword}={value}"
        return f'{keyword}="{_apart(value)}"'

    @staticmethod
    def command(*words: str) -> str:
        """`radcalc.lambertian("disc")`, or the shell's command where there is no function."""
        function = words[0].replace("-", "_")
        if function not in FUNCTIONS:
            told = " ".join(word for word in words if "=" not in word)
            return f"`radcalc {told}` at a shell"
        pairs = [word.partition("=") for word in words[1:]]
        arguments = [Python.option(key, value) if eq else f'"{key}"' for key, eq, value in pairs]
        return f"radcalc.{function}({', '.join(arguments)})"

    @staticmethod
    def manual(name: str) -> str:
        """Where the function is described."""
        return f"help(radcalc.{name.replace('-', '_')})"

    @staticmethod
    def measured(unit: str) -> str:
        """`illuminance (lx)`."""
        return describe(resolve(unit))


class PythonHint(Python):
    """In a hint a flag is what one types."""

    @staticmethod
    def option(name: str, value: str) -> str:
        """`isotropic=True`."""
        is_flag = name in SYMBOLS and SYMBOLS[name].form == FLAG
        return f"{Python.option(name, '')}=True" if is_flag else Python.option(name, value)


def _apart(value: str) -> str:
    """A blank between a number and its unit: 6m becomes 6 m."""
    try:
        end = read_number(value)[1]
    except NumberError:
        return value
    return f"{value[:end]} {value[end:].strip()}".strip()


def in_python(function: Callable[..., T]) -> Callable[..., T]:
    """Raise errors whose texts name keywords in place of options."""

    @wraps(function)
    def call(*args: Any, **kwargs: Any) -> T:
        try:
            return function(*args, **kwargs)
        except RadcalcError as error:
            error.message = spell(error.message, Python)
            error.hint = spell(error.hint, PythonHint)
            raise

    return call


def is_lazy(value: Any) -> bool:
    """Whether it is a collection of Dask's, or a quantity that has one."""
    return hasattr(getattr(value, "magnitude", value), "__dask_graph__")


def in_blocks(function: Callable[..., Any]) -> Callable[..., Any]:
    """Let a function that works element by element take Dask's arrays, and wait as they do."""

    @wraps(function)
    def call(*words: Any, **given: Any) -> Any:
        if not any(map(is_lazy, (*words, *given.values()))):
            return function(*words, **given)
        from radcalc.api.lazy import blockwise

        return blockwise(function.__name__, words, given)

    return call


def _refuse_lazy(value: Any, what: str) -> None:
    if is_lazy(value):
        problem = f"{what} is one of Dask's, for which the answer here cannot wait"
        raise ConditionError(problem, "an array in memory: .compute() before the call")


def _in_words(text: str) -> str:
    return spell(text, Python)


@in_python
@in_blocks
def convert(value: Any, target: str, **conditions: Any) -> Any:
    """Convert a quantity to another unit, or to another quantity under conditions.

    Parameters
    ----------
    value : str, Quantity or float
        A text such as ``"100 lx"``, or a `radcalc.Quantity`, whose magnitude may be an array
        of any shape, Dask's too, or a number of the `uncertainties` package.  A bare number is
        dimensionless.
    target : str
        The unit of the result, or a scale: ``"dBm"``.
    **conditions
        As the options of ``radcalc convert``, with underscores: ``wavelength="555nm"``,
        ``half_angle=Quantity(30, "deg")``, ``isotropic=True``.

    Returns
    -------
    Quantity
        In the unit `target`, of the shape of the magnitude of `value` (broadcast with those of
        the conditions).  On a scale the bare readings, a float or an array: they are no
        quantity, which could be multiplied.
        Where something is uncertain the magnitude is, correlated with that.

    Raises
    ------
    radcalc.errors.RadcalcError
        A text that is not a unit, or a condition that is missing, impossible, contradictory or
        without use.

    Examples
    --------
    >>> print(convert("800 lm", "cd", half_angle="60deg").round(3))
    254.648 candela
    >>> convert("10 mW", "dBm"), str(convert("-30 dBm", "uW"))
    (10.0, '1.0 microwatt')
    """
    made, magnitude, given = _plan(value, target, conditions)
    if _has_uncertainty(magnitude) or any_uncertain(given):
        found = _converted(made, magnitude, given).number
    else:
        found = _broadcast(lambda: made.apply(magnitude))
    if made.target.is_scale:
        return found
    return Quantity(found, light_registry().container(made.target))


@in_python
def explain(value: Any, target: str, **conditions: Any) -> Result:
    """Convert as `convert` does, and give what was assumed, noted and derived with the value.

    Parameters
    ----------
    value, target, **conditions
        As in `convert`; a single value, no array.

    Returns
    -------
    radcalc.answer.Result
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
    if any(getattr(one, "shape", ()) for one in (value, *conditions.values())):
        raise ConditionError("explain takes single values, not arrays", "one of each")
    made, magnitude, given = _plan(value, target, conditions)
    number = magnitude.typed[0] if isinstance(magnitude, Amount) else magnitude
    shown = answer(made, float(getattr(number, "nominal_value", number)), steps=True)
    if _has_uncertainty(magnitude) or any_uncertain(given):
        from radcalc.calculators.uncertainty import of_conversion

        shown = of_conversion(shown, _converted(made, magnitude, given))
    return shown.spelled(_in_words)


@in_python
def factor(source: str, target: str, **conditions: Any) -> float:
    """The number by which values in one unit are multiplied to be in another.

    A query engine then needs nothing but a multiplication: Polars, DuckDB, Spark, SQL.

    Parameters
    ----------
    source, target : str
        The units, or a quantity's name as the target: ``"ppfd"``.
    **conditions : str, Quantity or float
        As in `convert`; a single value of each.  `explain` tells what they assume.

    Returns
    -------
    float
        The factor; exact, and rounded once, between two units of one quantity.

    Raises
    ------
    radcalc.errors.RadcalcError
        As in `convert`; and where the two are not proportional, as with scales, or the factor is
        an array or uncertain.

    Examples
    --------
    >>> factor("klx", "lx"), factor("lx", "umol/m2/s", efficacy="50 lm s/umol")
    (1000.0, 0.02)
    """
    for unit in (source, target):
        if not isinstance(unit, str):
            raise UnitError(f"a unit is a text, not a {type(unit).__name__}", "a text such as 'lx'")
    start = resolve_any(source)
    given = _conditions(conditions)
    refuse_uncertain(given, "a factor")
    for one in given:
        if is_column(one.value):
            problem = f"a factor is one number, and {option(one.name)} is an array"
            raise ConditionError(
                problem, "one value of each, or radcalc.convert, which takes arrays"
            )
    made = plan(start, target_of(target, start), given)
    if not made.is_linear:
        problem = f"{quote(source)} and {quote(target)} are linked by a function, not by a factor"
        raise ConversionError(problem, f'radcalc.convert("1 {quote(source)}", "{quote(target)}")')
    return float(made.factor)


@in_python
@in_blocks
def point_source(
    *, distribution: Any = None, any_incidence: bool = False, **given: Any
) -> dict[str, Any]:
    """Everything that follows for a source that is small beside its distance.

    Parameters
    ----------
    distribution : str, path or Distribution, optional
        How its light is spread: "isotropic", "cone" or "lobe", where no option of a cone or a lobe
        tells; a file (IES, EULUMDAT, CSV); an expression in theta and phi, with a unit behind a
        blank; or an object of `radcalc.distributions`, such as a `Grid`.
    any_incidence : bool
        Work out the incidence, in place of taking it as 0.
    **given : str, Quantity or float
        As the options of ``radcalc point-source``, with underscores: ``flux="800 lm"``,
        ``distance=Quantity(array, "m")``.  Arrays are broadcast together.  For Dask's arrays the
        results are such, and a value that is impossible raises its error when they are computed.

    Returns
    -------
    dict of str to Quantity
        What was given and what follows, by the names of ``--get`` with underscores.  Where
        several heights or exponents fit, arrays of all the answers.

    Raises
    ------
    radcalc.errors.RadcalcError
        What is missing, contradictory, impossible or without use.

    Examples
    --------
    >>> print(point_source(flux="800lm", distance="2m")["irradiance"].round(3))
    15.915 lux
    >>> print(point_source(distribution="300*max(cos(theta), 0)^2 cd")["flux"].round(3))
    628.319 lumen
    """
    from radcalc.calculators.point_source import point_source as work_out

    inputs = _inputs({"distribution": distribution, **given})
    return _results(lambda given: work_out(given, any_incidence), inputs)


@in_python
def scene(
    sources: Any,
    points: Any,
    normal: Any = (0.0, 0.0, 1.0),
    *,
    shares: bool = False,
    **links: Any,
) -> dict[str, Any]:
    """What many sources give together at points, and how even that is.

    Parameters
    ----------
    sources : str, path, or list of dicts
        A CSV file with a row for each source, or a dict for each, with the columns of
        ``radcalc scene`` as keys and texts, quantities or numbers as values.
    points : array_like or Quantity of shape (n, 3)
        The points, in metres unless they have a unit; a text such as ``"1,2,0.75"`` for one.
    normal : str or sequence of 3 floats, optional
        Where the receivers face; up by default.
    shares : bool, optional
        Whether to give the irradiance by each source too.
    **links : str, Quantity or float
        What links the kinds of light: ``wavelength``, ``spectrum``, ``efficacy`` ...

    Returns
    -------
    dict of str to Quantity
        `irradiance`, and `share_NAME` of each source where it is asked for, of shape (n,);
        `mean_irradiance`, `minimum_irradiance`, `maximum_irradiance`, `uniformity` (minimum over
        mean) and `minimum_to_maximum`.

    Raises
    ------
    radcalc.errors.RadcalcError
        A row that is no source, with its column; a point at a source; kinds of light that
        nothing links.

    Examples
    --------
    >>> lamps = [{"x": x, "y": 0, "z": 2, "intensity": "100 cd"} for x in (0, 0)]
    >>> print(scene(lamps, [[0, 0, 0], [0, 0, 1]])["irradiance"])
    [50.0 200.0] lux
    """
    import os

    import numpy

    from radcalc.calculators import scene as page
    from radcalc.calculators.worksheet import refuse_foreign
    from radcalc.distributions.scene import blocks
    from radcalc.quantities.symbols import LINKS, REFINEMENTS

    inputs = _inputs(links)
    refuse_uncertain(inputs.values(), "a scene")
    refuse_foreign(inputs, (*LINKS, *REFINEMENTS), "a scene")
    for one in inputs.values():
        if is_array(one.value):
            raise ConditionError(f"{option(one.name)} is an array", "one value for the whole scene")
    if isinstance(sources, os.PathLike):
        sources = os.fspath(sources)
    elif isinstance(sources, Iterable) and not isinstance(sources, (str, bytes)):
        sources = [_row(source) for source in sources]
    elif not isinstance(sources, str):
        raise ConditionError(
            f"the sources are of the type {type(sources).__name__}",
            "the path of a CSV file, or a list with a dict for each",
        )
    points = numpy.atleast_2d(numpy.stack(_place(points).value, -1))
    facing = read("normal", normal).value
    survey = page.Survey(page.scene(sources, inputs), facing, shares)
    parts = [_quantities(answer) for answer in survey.at_points(blocks(points))]
    found = {
        name: Quantity(numpy.concatenate([part[name].magnitude for part in parts]), one.units)
        for name, one in parts[0].items()
        if name not in ("x", "y", "z")
    }
    return {**found, **_quantities(survey.remarks(with_values=True))}


@in_python
def environment(source: Any, **given: Any) -> dict[str, Any]:
    """What a receiver gets of all that surrounds it: of a map, a sky or an expression.

    Parameters
    ----------
    source : str, path, array or Quantity
        The path of a map (.hdr, .exr, .pfm), ``"sky:overcast"`` or another type, or an expression
        in theta and phi, with a unit of radiance behind a blank.  An array is a map, of the shape
        (height, width) or (height, width, 3), row 0 at the top; of NumPy, or of Dask, which is
        computed a strip of rows at a time.
    **given : str, Quantity or sequence of floats
        As the options of ``radcalc environment``, with underscores: ``unit="cd/m2"``, which a
        Quantity has itself, ``projection="mirror-ball"``, ``aim=(0, 0, 1)``, ``normal=(1, 0, 0)``,
        ``toward="60deg,90deg"``, ``zenith_luminance="9 kcd/m2"``, ``spectrum="D65"``.

    Returns
    -------
    dict of str to Quantity
        As of `point_source`.

    Raises
    ------
    radcalc.errors.RadcalcError
        What is no map or cannot be read, and what is missing, contradictory, impossible or without
        use.

    Examples
    --------
    >>> print(environment("sky:overcast", zenith_luminance="9000 cd/m2")["irradiance"].round(2))
    21991.15 lux
    >>> import numpy
    >>> room = environment(numpy.full((32, 64), 3000.0), unit="cd/m2", normal=(1, 0, 0))
    >>> print(room["irradiance"].round(2))
    9424.78 lux
    """
    from radcalc.calculators.environment import environment as work_out

    named, given = _surroundings(source, given)
    return _results(lambda inputs: work_out(named, inputs), _inputs(given))


@in_python
def irradiance_map(source: Any, size: Any = None, *, order: int | None = None, **given: Any) -> Any:
    """The irradiances of receivers that face in all directions, as a latlong map.

    Parameters
    ----------
    source : str, path, array or Quantity
        As of `environment`.  Skies and expressions are sampled, at 1024 x 512 pixels.
    size : sequence of 2 ints, optional
        Width and height of the map that is made, 2:1; 64 x 32 by default.
    order : int, optional
        2 for spherical harmonics up to that order; the exact sum over all pixels by default.
    **given : str, Quantity or sequence of floats
        What `environment` takes of the source: ``unit``, ``projection``, ``aim``, ``channel``,
        ``zenith_luminance`` ...

    Returns
    -------
    Quantity
        Of the shape (height, width, channels), in lx, W/m2, umol/m2/s or sr; row 0 is the top, and
        the middle the receiver that faces 1,0,0.

    Raises
    ------
    radcalc.errors.RadcalcError
        As of `environment`.

    Examples
    --------
    >>> import numpy
    >>> lit = irradiance_map(numpy.full((32, 64), 3000.0), (16, 8), unit="cd/m2")
    >>> print(lit.shape, lit[0, 0, 0].round(1))
    (8, 16, 1) 9424.8 lux
    """
    from radcalc.calculators.environment import irradiance_map as work_out

    named, given = _surroundings(source, given)
    inputs = _inputs({**given, "size": size})
    refuse_uncertain(inputs.values(), "a map")
    made = work_out(named, inputs, order)
    return Quantity(made.pixels, light_registry().container(resolve(made.unit)))


@in_python
def reproject(source: Any, to: str, size: Any = None, **given: Any) -> Any:
    """A map in another projection: each pixel the mean of what it shows, by solid angle.

    Parameters
    ----------
    source : str, path, array or Quantity
        As of `irradiance_map`.
    to : {"latlong", "mirror-ball", "angular"}
        The new projection; its middle shows +x.
    size : sequence of 2 ints, optional
        Width and height of the new map; as high as the source's by default.
    **given : str, Quantity or sequence of floats
        As of `irradiance_map`.

    Returns
    -------
    Quantity
        Of the shape (height, width, channels), in cd/m2, W/m2/sr, umol/m2/s/sr or 1.

    Raises
    ------
    radcalc.errors.RadcalcError
        As of `environment`.

    Examples
    --------
    >>> print(reproject("sky:uniform", "angular", (64, 64), zenith_luminance="9 cd/m2").max())
    9.0 candela / metre ** 2
    """
    from radcalc.calculators.environment import reprojection as work_out

    if to not in PROJECTIONS:
        raise ConditionError(f"there is no projection '{quote(str(to))}'", ", ".join(PROJECTIONS))
    named, given = _surroundings(source, given)
    inputs = _inputs({**given, "size": size})
    refuse_uncertain(inputs.values(), "a map")
    made = work_out(named, inputs, to)
    return Quantity(made.pixels, light_registry().container(resolve(made.unit)))


def _surroundings(source: Any, given: dict[str, Any]) -> tuple[Any, dict[str, Any]]:
    """What surrounds a place, and what is given with it."""
    import os

    from radcalc.calculators.environment import Source
    from radcalc.distributions.environments import picture_of

    if isinstance(source, str):
        return Source(source), given
    if isinstance(source, os.PathLike):
        return Source(os.fspath(source), is_path=True), given
    if _is_quantity(source):
        if given.get("unit") is not None:
            raise ConditionError("unit is given, and the map has its own", "the same without unit")
        given = {**given, "unit": from_container(source._units)}
        source = source.magnitude
    return Source(picture_of(source)), given


def _row(source: Any) -> Any:
    """A row of a scene, whose quantities are numbers with units."""
    if not isinstance(source, dict):
        return source
    return {key: _plain(value) for key, value in source.items()}


@in_python
@in_blocks
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
    from radcalc.calculators.lambertian import lambertian as work_out
    from radcalc.calculators.shapes import SHAPES

    if not isinstance(shape, str) or shape not in SHAPES:
        raise ConditionError(f"there is no shape '{quote(str(shape))}'", ", ".join(SHAPES))
    inputs = _inputs({"corner": corner, "perpendicular": perpendicular, **given})
    return _results(lambda given: work_out(shape, given), inputs)


@in_python
@in_blocks
def uberlight(point: Any, *, omni: bool = False, **given: Any) -> dict[str, Any]:
    """What a cinematographer's light sends to points, and how much each setting attenuates it.

    Parameters
    ----------
    point : str, Quantity or array_like of shape (..., 3)
        The points: a text such as ``"1m,0m,2m"``, lengths, or numbers of metres.  The light is at
        0,0,0 and shines along +z.
    omni : bool
        It shines everywhere, and depths are distances from it.
    **given : str, Quantity, float or sequence of floats
        As the options of ``radcalc uberlight``, with underscores: ``intensity="1000 cd"``,
        ``near="1 m:2 m"``, ``superellipse=(0.4, 0.3, 0.5, 0.4)``.  Arrays are broadcast together,
        and with the points.

    Returns
    -------
    dict of str to Quantity
        As of `point_source`; x, y and z, and the attenuations, are among them.

    Raises
    ------
    radcalc.errors.RadcalcError
        As of `point_source`.

    Examples
    --------
    >>> light = uberlight([[0, 0, 1], [0, 0, 2]], intensity="100cd", falloff=1)
    >>> print(light["irradiance"].round(6), light["attenuation"].round(6))
    [100.0 50.0] lux [1.0 0.5] dimensionless
    """
    from radcalc.calculators.uberlight import uberlight as work_out

    place = _place(point)
    inputs = {**_inputs({"omni": omni, **given}), place.name: place}
    return _results(work_out, inputs)


def _place(point: Any) -> Given:
    """Points, as a text, lengths or numbers of metres."""
    _refuse_lazy(point, "the array of points")
    if isinstance(point, str):
        return read_place("point", point)
    metres, unit = point, None
    if _is_quantity(point):
        unit = from_container(point._units)
        if unit.dimension != LENGTH:
            raise ConditionError("the point is a length", "metres")
        metres = point.magnitude * unit.factor
    import numpy

    array = numpy.asarray(real(metres, "a point", "three numbers, [1, 0, 2]"))
    if array.shape[-1:] != (3,):
        raise ConditionError("a point has three coordinates", "an array of the shape (..., 3)")
    if not (abs(array) <= LARGEST).all():
        raise ConditionError(*TOO_FAR)
    place = tuple(array.tolist() if array.ndim == 1 else numpy.moveaxis(array, -1, 0))
    return Given(SYMBOLS["point"], "the points", place, unit=unit)


@in_python
@in_blocks
def sky(kind: str | int = "overcast", **given: Any) -> dict[str, Any]:
    """The light of the sky, toward a direction, on the ground and on a plane.

    Parameters
    ----------
    kind : str or int
        ``"overcast"`` (the traditional one), ``"uniform"``, ``"intermediate"``, ``"clear"``,
        ``"turbid"``, or a type of the CIE standard general sky, 1 to 15.
    **given : str, Quantity or float
        As the options of ``radcalc sky``, with underscores: ``sun_elevation="40 deg"``,
        ``horizontal_illuminance="12 klx"``, ``tilt="90 deg"``, ``toward="60deg,90deg"``.

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
    >>> found = sky("overcast", zenith_luminance="9000 cd/m2", tilt="90 deg")
    >>> print(found["irradiance"].round(2))
    8712.39 lux
    """
    from radcalc.calculators.sky import sky as work_out

    inputs = _inputs(given)
    return _results(lambda given: work_out(str(kind), given), inputs)


@in_python
@in_blocks
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
    from radcalc.calculators.ev import ev as work_out

    inputs = _inputs(given)
    return _results(work_out, inputs)


@in_python
@in_blocks
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
    from radcalc.calculators.calorimeter import calorimeter as work_out

    inputs = _inputs(given)
    return _results(work_out, inputs)


@in_python
@in_blocks
def laser(**given: Any) -> dict[str, Any]:
    """The spot of a laser beam, its irradiance, and the distance where that is a limit.

    Parameters
    ----------
    **given : str, Quantity or float
        As the options of ``radcalc laser``, with underscores: ``divergence="1 mrad"``,
        ``profile="uniform"``.  Arrays are broadcast together.

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
    >>> found = laser(flux="1 mW", diameter="1 mm", divergence="1 mrad", distance="100 m")
    >>> print(found["spot_diameter"].round(3), found["peak_irradiance"].round(5))
    100.005 millimetre 0.25462 watt / metre ** 2
    """
    from radcalc.calculators.laser import laser as work_out

    return _results(work_out, _inputs(given))


@in_python
@in_blocks
def room(**given: Any) -> dict[str, Any]:
    """The luminaires that light a room, or the illuminance that they give it.

    Parameters
    ----------
    **given : str, Quantity or float
        As the options of ``radcalc room``, with underscores: ``width="6 m"``, ``utilance=0.6``.
        Arrays are broadcast together.

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
    >>> found = room(area="54 m2", illuminance="500 lx", flux="3600 lm", utilance=0.6)
    >>> print(found["luminaires"], found["luminaires_to_install"])
    12.5 dimensionless 13.0 dimensionless
    """
    from radcalc.calculators.room import room as work_out

    return _results(work_out, _inputs(given))


@in_python
@in_blocks
def sensor(**given: Any) -> dict[str, Any]:
    """The light that a lens sends to a sensor, its photons, electrons and current.

    Parameters
    ----------
    **given : str, Quantity or float
        As the options of ``radcalc sensor``, with underscores: ``f_number=2.8``,
        ``pixel_pitch="3.45 um"``, ``quantum_efficiency=0.6``.  Arrays are broadcast together.

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
    >>> found = sensor(luminance="4000 cd/m2", f_number=16, time="10 ms")
    >>> print(found["irradiance"].round(3), found["exposure"].round(4))
    12.272 lux 0.1227 lux * second
    """
    from radcalc.calculators.sensor import sensor as work_out

    return _results(work_out, _inputs(given))


def _inputs(given: dict[str, Any]) -> Inputs:
    """Read what a calculator is given."""
    known = [name for name, symbol in SYMBOLS.items() if symbol.help and name not in INNER]
    return {
        name: one
        for keyword, value in given.items()
        if (one := _given(keyword, value, known, "input")) and (name := one.name)
    }


def _given(keyword: str, value: Any, known: Any, what: str) -> Given | None:
    """Read one keyword; None and False are as if it were not there."""
    name = keyword.replace("_", "-")
    if name not in known:
        near = nearest(name, known) if what == "input" else known
        keywords = ", ".join(one.replace("-", "_") for one in near)
        raise ConditionError(f"there is no {what} '{quote(keyword)}'", keywords or "help(radcalc)")
    if value is None or value is False:
        return None
    _refuse_lazy(value, keyword)
    if isinstance(value, (list, tuple)) and any(map(_is_quantity, value)):
        if SYMBOLS[name].form not in (DIRECTION, POINT, VECTOR, NUMBERS):
            array = f"one quantity, {keyword}=radcalc.Quantity([1, 2], UNIT)"
            raise ConditionError(f"{keyword} is a list of quantities", array)
        value = ",".join(
            f"{one.magnitude} {from_container(one._units).text}" if _is_quantity(one) else str(one)
            for one in value
        )
    return read(name, _plain(value), uncertain=True)


def _plain(value: Any) -> Any:
    """A quantity as a number (or an array) with its unit; anything else as it is."""
    return (value.magnitude, from_container(value._units)) if _is_quantity(value) else value


def _broadcast(work_out: Callable[[], T]) -> T:
    """What comes of arrays, which have to fit together."""
    try:
        return work_out()
    except ValueError as error:
        if "broadcast" not in str(error):
            raise
        raise ConditionError("the arrays do not fit together", "arrays of one shape") from None


def _results(work_out: Callable[[Inputs], Answer], given: Inputs) -> dict[str, Any]:
    """The results as quantities, each in the first unit it is shown in."""
    from radcalc.calculators.uncertainty import with_uncertainties

    answer = _broadcast(lambda: with_uncertainties(work_out, given))
    answers = [_quantities(one) for one in (answer, *answer.more)]
    if len(answers) == 1:
        return answers[0]
    return {name: Quantity.from_list([one[name] for one in answers]) for name in answers[0]}


def _quantities(answer: Answer) -> dict[str, Any]:
    from radcalc.calculators.results import in_unit

    found: dict[str, Any] = {}
    for value in answer.values:
        name = value.name.replace("-", "_")
        if not value.is_absent and name not in found:
            unit = in_which(value.units[0], value.dimensions)
            found[name] = Quantity(in_unit(value, unit), light_registry().container(unit))
    return found


def _converted(made: Plan, magnitude: Any, given: list[Given]) -> Any:
    """A magnitude through a plan, where it or a condition is uncertain."""
    from radcalc.calculators.uncertainty import converted

    if isinstance(magnitude, Amount):
        return converted(made, magnitude, given)
    amount = Amount("the value", magnitude, made.source)
    of = None
    if is_uncertain(magnitude):
        number, size = magnitude.nominal_value, magnitude.std_dev
        amount, of = Amount(str(magnitude), number, made.source, size), magnitude
    elif is_array(magnitude):
        raise ConditionError("an array stands beside an uncertain condition", ONE_EACH)
    return converted(made, amount, given, of)


def _has_uncertainty(magnitude: Any) -> bool:
    return isinstance(magnitude, Amount) or is_uncertain(magnitude)


def _plan(value: Any, target: str, conditions: dict[str, Any]) -> tuple[Plan, Any, list[Given]]:
    """The plan that both need, the magnitude to apply it to, and the conditions.

    The magnitude of a text with an uncertainty is an `Amount`.
    """
    _refuse_lazy(value, "the value")
    if not isinstance(target, str):
        raise UnitError(
            f"the unit to convert to is a {type(target).__name__}", "a text such as 'fc'"
        )
    magnitude: Any
    source: Unit | None
    if isinstance(value, str):
        amount = read_amount(value)
        magnitude, source = amount.typed
        magnitude = amount if amount.is_uncertain else magnitude
    elif _is_quantity(value):
        magnitude, source = value.magnitude, from_container(value._units)
    else:
        magnitude, source = value, None
    given = _conditions(conditions)
    source = source or resolve("1")
    made = plan(source, target_of(target, source), given)
    if _has_uncertainty(magnitude):
        return made, magnitude, given
    kind = getattr(getattr(magnitude, "dtype", None), "kind", "")
    if not isinstance(magnitude, (int, float)) and kind not in ("i", "u", "f"):
        hint = "real numbers" if _is_quantity(value) else "a text, a quantity or numbers"
        magnitude = real(magnitude, "the value", hint)
    return made, magnitude, given


def _conditions(conditions: dict[str, Any]) -> list[Given]:
    """Read the conditions of a conversion."""
    read = [_given(name, one, CONDITIONS, "condition") for name, one in conditions.items()]
    return [one for one in read if one]


def _is_quantity(value: Any) -> bool:
    if isinstance(value, Quantity):
        return True
    if hasattr(value, "magnitude"):
        if getattr(value, "_REGISTRY", None) is light_registry():
            return True  # a Measurement, of Quantity.plus_minus
        raise UnitError(
            f"'{quote(str(value))}' is a quantity of another registry", "radcalc.Quantity"
        )
    return False
