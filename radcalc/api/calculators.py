"""Functions that are not made from a page alone.

Those of calculators that have operands: surfaces, spectra, scenes, directions, skies; sentences and
their answers, checks of answers, and lists to look things up in.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from functools import partial
from typing import Any, Literal, NamedTuple, TypeVar

import numpy

from radcalc.answer import Row, Value, texts_of
from radcalc.api import arguments
from radcalc.api.arguments import (
    Quantity,
    as_text,
    in_words,
    is_quantity,
    keyword,
    quantity,
    require_texts,
)
from radcalc.api.columns import (
    Amount,
    Diffuse,
    Pair,
    Path,
    Points,
    Scalar,
    Shape,
    Sky,
    Surroundings,
    Vector,
)
from radcalc.api.functions import calculate, function_of_page, of_page
from radcalc.api.result import Result, Undrawn, call_function, in_python, of_answer, question_of
from radcalc.calculators import environment as page
from radcalc.calculators import page_of
from radcalc.calculators.environment import Source
from radcalc.calculators.integrate import BARE, integrand
from radcalc.calculators.lambertian import OPERAND
from radcalc.calculators.photon import named
from radcalc.calculators.pixel import pixel as of_pixel
from radcalc.calculators.scene import Survey
from radcalc.calculators.scene import scene as add_up
from radcalc.calculators.shapes import SHAPES
from radcalc.calculators.solid_angle import ALIASES, NAMES
from radcalc.conversion.operands import read_operands
from radcalc.conversion.plan import target_of
from radcalc.distributions.environments import picture_of
from radcalc.distributions.scene import blocks
from radcalc.errors import (
    ConditionError,
    MissingInput,
    RadcalcError,
    SeveralReadings,
    UsageError,
    input_of,
    mention,
)
from radcalc.homework import Verdict as Judged
from radcalc.inputs import Inputs, refuse_uncertain, shown_inputs
from radcalc.inputs.definitions import load
from radcalc.inputs.places import IN_METRES, read_coordinates, read_point
from radcalc.inputs.reading import read
from radcalc.quantities.lookup import FIELDS, Task, Typical, how_far
from radcalc.quantities.lookup import search_tasks as tasks_for
from radcalc.quantities.lookup import search_typical as values_for
from radcalc.quantities.symbols import article
from radcalc.render.formats import Judgement, Style
from radcalc.render.plain import verdict as words_of
from radcalc.sentences.calls import call_of
from radcalc.sentences.reader import read as read_sentence
from radcalc.spectra.files import read_text
from radcalc.units import unit_behind
from radcalc.units.numbers import is_sentence
from radcalc.units.table import resolve


@of_page("point-source", amounts=True)
def point_source(*, any_incidence: bool = False, **given: Any) -> Result:
    """
    Parameters
    ----------
    any_incidence : bool, optional
        Compute the incidence instead of taking it as 0.

    Returns
    -------
    Result
        The inputs and results, as attributes with the names of ``radcalc -g``.  If several
        heights or exponents fit, arrays of all the answers.

    Examples
    --------
    >>> lamp = point_source(flux="800 lm", distance=["1 m", "2 m"])
    >>> print(lamp.illuminance.round(3), lamp.intensity.round(3))
    [63.662 15.915] lux 63.662 candela
    >>> print(point_source(distribution="300*max(cos(theta), 0)^2 cd").flux.round(3))
    628.319 lumen
    """
    return calculate(
        "point-source",
        given,
        partial(function_of_page("point_source"), any_incidence=any_incidence),
    )


@of_page("lambertian", amounts=True)
def lambertian(shape: Diffuse | None = None, **given: Any) -> Result:
    """
    Parameters
    ----------
    shape : {"patch", "disc", "sphere", "rectangle", "plane", "hemisphere"}, optional
        The shape of the source (default: a patch, a flat surface; a radius needs a shape).

    Examples
    --------
    >>> print(lambertian(luminance="100 cd/m2", area="0.1 m2").flux.round(3))
    31.416 lumen
    """
    name = "" if shape is None else arguments.one_of(shape, SHAPES, "shape")
    operands = {"shape": name or OPERAND.default}
    return calculate("lambertian", given, partial(function_of_page("lambertian"), name), operands)


@of_page("uberlight", amounts=True)
def uberlight(point: Points, **given: Any) -> Result:
    """
    Parameters
    ----------
    point : Points, of the shape (..., 3)
        Texts such as ``"1m,0m,2m"``, lengths, or numbers of metres.  The light is at 0,0,0 and
        shines along +z.

    Examples
    --------
    >>> light = uberlight([[0, 0, 1], [0, 0, 2]], intensity="100 cd", falloff=1)
    >>> print(light.irradiance.round(6), light.attenuation.round(6))
    [100.0 50.0] lux [1.0 0.5] dimensionless
    """
    if point is None:
        raise MissingInput("the point is missing", '"1m,0m,2m", for one point')
    return calculate("uberlight", {"point": point, **given}, function_of_page("uberlight"))


@of_page("photon")
def photon(wavelength: Amount, **given: Any) -> Result:
    """
    Parameters
    ----------
    wavelength : Amount
        The wavelength in vacuum, or the frequency, the wavenumber or the energy.

    Examples
    --------
    >>> found = photon("555 nm")
    >>> print(found.photon_energy.round(4), found.luminous_efficacy)
    2.2339 electronvolt 683.002 lumen / watt
    """
    return calculate(
        "photon", {"wavelength": wavelength, **given}, function_of_page("photon"), adapt=_named
    )


@of_page("spectrum")
def spectrum(
    source: Path | Any, *, column: str | int | None = None, unit: str = "", **given: Any
) -> Result:
    """Compute the peak, width, efficacies, photons and colour of a spectrum.

    Parameters
    ----------
    source : str, path, data frame, series, or pair of arrays
        A name (``"D65"``, ``"LED-B3"``), ``"blackbody:2856K"``, ``"line:632.8nm"``, a file ...
        A data frame of pandas or Polars is read like a file with its titles; a series of pandas
        has the wavelengths as its index; a pair has the wavelengths and the values, each as
        numbers or as a quantity.
    column : str or int, optional
        The column of the values of a file or a data frame, by title or number.
    unit : str, optional
        The unit of the values: ``"W/m2/nm"`` ..., ``"relative"`` or ``"photons"``.

    Examples
    --------
    >>> found = spectrum("D65")
    >>> print(found.x.round(4), found.y.round(4))
    0.3127 dimensionless 0.329 dimensionless
    >>> lamp = spectrum(([400, 500, 600, 700], [1, 2, 2, 1]), unit="W/m2/nm")
    >>> print(lamp.irradiance)
    500.0 watt / metre ** 2
    """
    arguments.require_texts(unit=unit)
    texts = {"column": "" if column is None else str(column), "unit": unit}
    operands = {name: chosen for name, chosen in texts.items() if chosen}
    if isinstance(source, (str, os.PathLike)):
        text = os.fspath(source)
        chosen: Any = (text, *texts.values()) if operands else text
    else:
        chosen = read_text(*arguments.table_of(source), *texts.values())
    requested = ("ssi",) if given.get("reference") is not None else ()  # which it is for
    symbols = {"spectrum": chosen, **given}
    return calculate(
        "spectrum", symbols, function_of_page("spectrum"), operands, requested=requested
    )


def _named(inputs: Inputs) -> Inputs:
    """Name the operand by the quantity that it is; refuse its absence."""
    if "wavelength" not in inputs:
        raise MissingInput("the wavelength is missing", mention("{wavelength=555nm}"))
    return {**inputs, "wavelength": named(inputs["wavelength"])}


@of_page("scene", without=("grid", "normal"))
def scene(
    sources: Path | Iterable[Mapping[str, Any]],
    points: Points,
    normal: Vector = None,
    *,
    shares: bool = False,
    **given: Any,
) -> Result:
    """Add up the light of many sources at points, and compute its uniformity.

    Parameters
    ----------
    sources : str, path, or list of dicts
        A CSV file with a row for each source, or a dict for each, with the titles of the columns
        of ``radcalc scene`` as keys (``"x"``, ``"x (cm)"``) and texts, quantities or numbers as
        values.
    points : Points, of the shape (n, 3)
        The points, in metres unless they have a unit; a text such as ``"1,2,0.75"`` for one.
    normal : Vector, optional
        The normal of the receivers; up by default.
    shares : bool, optional
        Add the irradiance from each source.

    Returns
    -------
    Result
        `irradiance`, and `share_NAME` of each source if requested, of shape (n,);
        `mean_irradiance`, `minimum_irradiance`, `maximum_irradiance`, `uniformity` (minimum over
        mean) and `minimum_to_maximum`.

    Raises
    ------
    radcalc.RadcalcError
        If a row is not a source (with its column), a point is at a source, or kinds of light
        are not linked.

    Examples
    --------
    >>> lamps = [{"x": x, "y": 0, "z": 2, "intensity": "100 cd"} for x in (0, 0)]
    >>> print(scene(lamps, [[0, 0, 0], [0, 0, 1]]).irradiance)
    [50.0 200.0] lux
    """
    inputs = arguments.read_inputs(given)
    refuse_uncertain(inputs.values(), "a scene")
    arguments.refuse_arrays(inputs, "the whole scene")
    rows = _rows(sources)
    read_at = arguments.read_points(points)
    places = numpy.atleast_2d(numpy.stack(read_at.value, -1))
    facing = None if normal is None else read("normal", normal).value
    notes = () if read_at.unit else (IN_METRES,)
    survey = Survey(add_up(rows, inputs, notes), facing, shares)
    parts = [*survey.at_points(blocks(places))]
    remarks = survey.remarks(with_values=True)
    values = [
        _joined([part.values[k] for part in parts])
        for k, value in enumerate(parts[0].values)
        if value.name not in "xyz"
    ]
    answer = remarks._replace(values=[*values, *remarks.values])
    operands = texts_of({"file": rows if isinstance(rows, str) else ""})
    grid = "the isolux lines of a grid, which `radcalc scene` draws at a shell"
    undrawn = Undrawn("a scene at points has no picture", grid)
    return of_answer("scene", answer, (*operands, *shown_inputs(inputs)), None, undrawn)


def _joined(parts: Sequence[Value]) -> Value:
    return parts[0]._replace(
        si=numpy.concatenate([part.amount for part in parts]),
        reach={
            key: numpy.concatenate([part.reach[key] for part in parts]) for key in parts[0].reach
        },
    )


def _rows(sources: Any) -> str | list[Any]:
    """Return the path of a scene, or its rows with plain values."""
    if isinstance(sources, (str, os.PathLike)):
        return os.fspath(sources)
    try:
        rows = [] if isinstance(sources, bytes) else list(sources)
    except TypeError:
        rows = []
    if not rows and type(sources) is not list:
        problem = f"the sources are not rows, but of the type {type(sources).__name__}"
        raise ConditionError(problem, "the path of a CSV file, or a list with a dict for each")
    return [
        {key: arguments.plain(value) for key, value in source.items()}
        if isinstance(source, dict)
        else source
        for source in rows
    ]


@of_page("solid-angle")
def solid_angle(shape: Shape, vertices: Sequence[Vector] = (), **given: Any) -> Result:
    """
    Parameters
    ----------
    shape : {"cone", "zone", "sphere", "disc", "rectangle", "pyramid", "patch", "polygon", ...}
        ``"full"`` and ``"hemisphere"`` take nothing else, a cone one of its angles, a zone `polar`
        and `azimuth` as ``"30deg:60deg"``, a pixel `size`, `pixel` and `projection`.
    vertices : sequence of Vector, optional
        The vertices of a polygon, in order, in one unit of length.

    Examples
    --------
    >>> print(solid_angle("cone", half_angle="30 deg").solid_angle.round(6))
    0.841787 steradian
    >>> octant = solid_angle("polygon", [(1, 0, 0), (0, 1, 0), (0, 0, 1)])
    >>> print(octant.solid_angle.to("deg^2").round(2))
    5156.62 degree ** 2
    """
    name = arguments.one_of(shape, NAMES, "shape")
    name = ALIASES.get(name, name)
    corners = _corners(vertices)
    points = [read_point(corner, "the vertex") for corner in corners]
    if points and name != "polygon":
        raise ConditionError(f"vertices do not apply to a {name}", "leave out vertices")
    work_out = (
        of_pixel
        if name == "pixel"
        else partial(function_of_page("solid_angle"), name, points=points)
    )
    operands = {"shape": name, "vertices": " ".join(corners)}
    return calculate("solid-angle", given, work_out, operands)


@of_page("integrate")
def integrate(expression: str, *, unit: str = "", **given: Any) -> Result:
    """Integrate a function of direction over a part of the sphere.

    Parameters
    ----------
    expression : str
        In `theta` and `phi`, the polar angle and the azimuth, or `x`, `y`, `z`, the unit vector:
        ``"cos(theta)**2"``.  An angle in it has a unit: ``"exp(-(theta/(10*deg))**2)"``.
    unit : str, optional
        The unit of the expression, of intensity or radiance: ``"cd"``; the integral is then a
        flux, or an irradiance.

    Returns
    -------
    Result
        The `integral` over solid angle, for which the factor sin(theta) is supplied, and a bound of
        its `error`.

    Raises
    ------
    radcalc.RadcalcError
        If the expression is not valid, its integral does not converge, or an input is missing,
        contradictory or out of range.

    Examples
    --------
    >>> print(integrate("cos(theta)", half_angle="90 deg").integral.round(6))
    3.141593 steradian
    """
    arguments.require_texts(expression=expression, unit=unit)
    arguments.refuse_arrays(
        arguments.read_inputs(given, page_of("integrate").intervals), "an integral"
    )
    of = integrand(unit) if unit else BARE
    work_out = partial(function_of_page("integrate"), expression, of=of)
    operands, drawn = {"expression": expression, "unit": unit}, (expression, unit)
    return calculate("integrate", given, work_out, operands, waits=False, drawn=drawn)


@of_page("direction")
def direction(vector: Points | None = None, *, on_ball: bool = False, **given: Any) -> Result:
    """
    Parameters
    ----------
    vector : Points, optional
        Three lengths or numbers, instead of angles.
    on_ball : bool, optional
        Add its place on a mirror ball: `mirror_ball_u`, `mirror_ball_v`, and `_w`.

    Examples
    --------
    >>> found = direction((1, 1, 1))
    >>> print(found.polar.round(4), found.azimuth)
    54.7356 degree 45.0 degree
    >>> print(direction(polar="30 deg", azimuth="0 deg", reflect_at=(0, 0, 1)).azimuth)
    180.0 degree
    """
    place, unit = _vector(vector)
    angle_names = ("polar", "azimuth", "elevation", "mirror_ball")
    angles = [name for name in angle_names if given.get(name) is not None]
    if place and angles:
        raise ConditionError(f"a vector cannot be used with {angles[0]}", "only one of them")
    text = vector if isinstance(vector, str) else ",".join(map(str, place or ()))
    work_out = partial(function_of_page("direction"), vector=place, unit=unit, with_ball=on_ball)
    return calculate("direction", given, work_out, {"vector": text})


def _vector(vector: Any) -> tuple[Any, str]:
    """Return three coordinates [SI] and their typed unit; None without a vector."""
    if vector is None:
        return None, ""
    if isinstance(vector, str):
        place, unit = read_coordinates(vector.split(","))
    else:
        metres, of = arguments.in_metres(vector, "a vector")
        place, unit = tuple(numpy.atleast_1d(metres).tolist()), of.text if of else ""
    if len(place) != 3 or numpy.ndim(place) > 1:
        raise ConditionError("a vector has three coordinates", "[1, 0, 2]")
    return place, unit


def _corners(vertices: Any) -> list[str]:
    try:
        return [
            vertex if isinstance(vertex, str) else ",".join(map(str, vertex)) for vertex in vertices
        ]
    except TypeError:
        problem = f"the vertices are not points, but of the type {type(vertices).__name__}"
        raise ConditionError(problem, "[(1, 0, 0), (0, 1, 0), (0, 0, 1)]") from None


@of_page("sky", without=("size",))
def sky(kind: Sky = "overcast", **given: Any) -> Result:
    """
    Parameters
    ----------
    kind : str or int
        ``"overcast"`` (the traditional one), ``"uniform"``, ``"intermediate"``, ``"clear"``,
        ``"turbid"``, or a type of the CIE standard general sky, 1 to 15.

    Examples
    --------
    >>> found = sky("overcast", zenith_luminance="9000 cd/m2", tilt="90 deg")
    >>> print(found.illuminance.round(2))
    8712.39 lux
    """
    name = str(kind)
    return calculate(
        "sky", given, partial(function_of_page("sky"), name), {"type": name}, drawn=name
    )


@of_page("environment", without=("size",))
def environment(source: Surroundings, **given: Any) -> Result:
    """
    Parameters
    ----------
    source : str, path, array or Quantity
        The path of a map (.hdr, .exr, .pfm), ``"sky:overcast"`` or another type, or an expression
        in theta and phi, with a unit of radiance after a blank.  An array is a map, of the shape
        (height, width) or (height, width, 3), row 0 at the top; of NumPy, or of Dask, which is
        computed a strip of rows at a time.

    Raises
    ------
    radcalc.RadcalcError
        If a map is invalid or unreadable, or an input is missing, contradictory, out of range or
        unused.

    Examples
    --------
    >>> found = environment("sky:overcast", zenith_luminance="9000 cd/m2")
    >>> print(found.illuminance.round(2))
    21991.15 lux
    >>> import numpy
    >>> room = environment(numpy.full((32, 64), 3000.0), unit="cd/m2", normal=(1, 0, 0))
    >>> print(room.illuminance.round(2))
    9424.78 lux
    """
    around, given = _surroundings(source, given)
    name = around.named if isinstance(around.named, str) else ""
    work_out = partial(page.environment, around)
    operands = {"source": name}
    return calculate("environment", given, work_out, operands, waits=False, drawn=around)


@of_page("environment", without=("normal", "toward", "size"))
def irradiance_map(
    source: Surroundings, size: Pair = None, *, order: Literal[2] | None = None, **given: Any
) -> Quantity:
    """Compute the irradiances of receivers facing every direction, as a latlong map.

    Parameters
    ----------
    source : str, path, array or Quantity
        As in `environment`.  Skies and expressions are sampled, at 1024 x 512 pixels.
    size : sequence of 2 ints, optional
        Width and height of the new map, 2:1; 64 x 32 by default.
    order : int, optional
        2 for spherical harmonics up to that order; the exact sum over all pixels by default.

    Returns
    -------
    Quantity
        An array of shape (height, width, channels), in lx, W/m2, umol/m2/s or sr; row 0 is the
        top, and the middle is the receiver that faces 1,0,0.

    Raises
    ------
    radcalc.RadcalcError
        As in `environment`.

    Examples
    --------
    >>> import numpy
    >>> lit = irradiance_map(numpy.full((32, 64), 3000.0), (16, 8), unit="cd/m2")
    >>> print(lit.shape, lit[0, 0, 0].round(1))
    (8, 16, 1) 9424.8 lux
    """
    if order is not None and type(order) is not int:
        raise ConditionError(f"order is {article(type(order).__name__)}, not a number", "2")
    around, given = _surroundings(source, {"size": size, **given})
    inputs = arguments.read_inputs(given)
    refuse_uncertain(inputs.values(), "a map")
    rendered = page.irradiance_map(around, inputs, order)
    return arguments.quantity(rendered.pixels, resolve(rendered.unit))


def _surroundings(source: Any, given: dict[str, Any]) -> tuple[Source, dict[str, Any]]:
    """Return the surroundings and their symbols; a quantity has the unit of its map."""
    if isinstance(source, str):
        return Source(source), given
    if isinstance(source, os.PathLike):
        return Source(os.fspath(source), is_path=True), given
    if arguments.is_quantity(source):
        if given.get("unit") is not None:
            raise ConditionError("unit cannot be used with a map that has a unit", "leave out unit")
        given = {**given, "unit": arguments.unit_of(source)}
        source = source.magnitude
    arguments.refuse_column(source, "the map")
    return Source(picture_of(source)), given


@in_python
def ask(sentence: str) -> Result | Quantity:
    """Answer a sentence, such as ``"20000 cd at 8 m to lx"``.

    Parameters
    ----------
    sentence : str
        Amounts, their places and a target, as at a shell (radcalc-sentences(7)).

    Returns
    -------
    Result or Quantity
        The result that the sentence asks for; without a target, all results.

    Raises
    ------
    radcalc.RadcalcError
        If words are not understood, if the sentence has several readings, or as in the function
        that it means.

    Examples
    --------
    >>> print(ask("20000 cd at 8 m to lx"))
    312.5 lux
    """
    require_texts(sentence=sentence)
    command, *words = _conversion(sentence) or call_of(read_sentence([sentence]))
    if command == "convert":
        operands = [text for name, text in map(input_of, words) if not name]
        amount, target = read_operands(operands)
        unit = amount.unit.text if amount.unit else "1"
        words = [amount.text, target or unit, *words[len(operands) :]]
    try:
        answer: Result | Quantity = call_function((command, *words), in_core=False)
    except (LookupError, TypeError) as error:  # no function, no such result, or more is needed
        problem = str(error) or f"{command} is not a function of Python"
        raise UsageError(problem, "the same sentence at a shell") from None
    return answer


def _conversion(line: str) -> list[str]:
    """Return the call of a line that is a conversion or an amount, as at a shell; or []."""
    if not is_sentence(line.split()):
        return []
    try:
        amount, target = read_operands([line])
        if target:
            target_of(target, amount.unit)
    except SeveralReadings:
        raise
    except RadcalcError:
        return []
    if amount.unit is None:
        return []
    return ["convert", amount.text, *(["to", target] if target else [])]


class Verdict(Judged):
    """The judgement of an answer; true if it is right.

    Examples
    --------
    >>> import radcalc
    >>> verdict = check(radcalc.explain("500 lx", "cd/m2", reflectance=0.8), "400")
    >>> bool(verdict), verdict.diagnoses[0].done
    (False, 'pi was forgotten')
    """

    __slots__ = ()

    def __bool__(self) -> bool:
        """Return whether the answer is right."""
        return self.right

    def __repr__(self) -> str:
        """Return the judgement and the likely mistakes as text."""
        row = Row(self.name, "", self.value, self.unit)
        text = words_of(Judgement(self, row, (), (), ()), Style()).rstrip()
        return "\n".join([text, *(f"note: {note}" for note in self.notes)])


@in_python
def check(result: Result, claim: Scalar, tolerance: Scalar | None = None) -> Verdict:
    """Check an answer against a result, and name the mistakes that lead to it.

    Parameters
    ----------
    result : Result
        The result of a calculator, or of `explain` for a conversion.
    claim : str, Quantity or float
        The answer: ``"16 lx"``, ``"illuminance=16 lx"`` for a certain result, or a bare number
        if it is unambiguous.  A name may have hyphens or underscores.
    tolerance : str, Quantity or float, optional
        ``"1%"`` (the default), ``"0.5 lx"``, or ``"3sf"`` (3 significant digits); a bare number
        is a fraction of the right value.

    Returns
    -------
    Verdict
        True or false (also `right`), with the right `value` in its `unit`, the `ratio` of the
        answer to it, and the `diagnoses`: each has a `mistake` that reproduces the number, what
        was `done`, the `right` rule, and in `yours` the first wrong step in your numbers.

    Raises
    ------
    radcalc.RadcalcError
        If the answer is invalid or ambiguous, or the result has arrays.

    Examples
    --------
    >>> import radcalc
    >>> cone = radcalc.solid_angle("cone", half_angle="30 deg")
    >>> check(cone, "0.842 sr")
    right (within 1%): solid-angle is 0.841787214477 sr
    """
    from radcalc.homework import check as judge

    if not isinstance(result, Result):
        problem = f"{article(type(result).__name__)} is not a result to check"
        raise ConditionError(problem, "radcalc.explain, or a calculator's function")
    allowed = None if tolerance is None else as_text(tolerance)
    question = question_of(result)
    judgement = judge(question, _as_named(as_text(claim), question.answer.values), allowed)
    return Verdict(*judgement._replace(diagnoses=tuple(map(_in_python, judgement.diagnoses))))


def _as_named(claim: str, values: Sequence[Value]) -> str:
    name, equals, claimed = claim.partition("=")
    names = {keyword(known): known for value in values for known in (value.name, value.also)}
    return f"{names.get(keyword(name.strip()), name)}{equals}{claimed}" if equals else claim


def _in_python(diagnosis: Any) -> Any:
    return diagnosis._replace(done=in_words(diagnosis.done), right=in_words(diagnosis.right))


T = TypeVar("T")


class Listing(tuple[T, ...]):
    """Rows found by a search: a tuple that is shown as text, with notes on the search."""

    notes: tuple[str, ...]

    def __new__(cls, rows: Iterable[T], notes: Iterable[str] = ()) -> Listing[T]:
        """Return the rows with their notes."""
        listing = super().__new__(cls, rows)
        listing.notes = tuple(notes)
        return listing

    def __repr__(self) -> str:
        """Return the texts of the rows, then the notes."""
        return "\n".join([*map(str, self), *(f"note: {note}" for note in self.notes)])


class TypicalValue(NamedTuple):
    """A typical value with its source.

    `value` is the text of a number or a range in `unit`.  `low` and `high` are its ends:
    quantities, or bare readings on a scale.
    """

    what: str
    quantity: str
    value: str
    unit: str
    source: str
    note: str
    low: Quantity | float
    high: Quantity | float

    def __str__(self) -> str:
        """Return the value in a line."""
        return f"{self.what}: {self.quantity} {self.value}{unit_behind(self.unit)} ({self.source})"


@in_python
def typical(search: str | Quantity = "") -> Listing[TypicalValue]:
    """List typical values: sun, sky, rooms, lamps, screens, plants, with sources.

    Parameters
    ----------
    search : str, optional
        A subject (``"office"``), a quantity (``"illuminance"``) or a unit, in English, Czech or
        Russian, or a value, for those nearest to it (``"500 lx"``); all values by default.

    Returns
    -------
    Listing of TypicalValue
        A tuple of named tuples: `what` the value is of, its `quantity`, `value` and `unit`, its
        ends `low` and `high` as quantities, its `source`, and a `note`.

    Raises
    ------
    radcalc.RadcalcError
        If nothing is found.

    Examples
    --------
    >>> print(typical("office")[0].low.to("fc").round(1))
    46.5 footcandle
    """
    if not is_quantity(search):
        require_texts(search=search)
    text = as_text(search)
    found = values_for(text)
    far = how_far(text, found)
    return Listing(map(_typical_value, found), [far] if far else [])


def _typical_value(value: Typical) -> TypicalValue:
    unit = value.measured
    low, high = (end if unit.is_scale else quantity(end, unit) for end in (value.low, value.high))
    texts = {field: getattr(value, field) for field in FIELDS}
    return TypicalValue(**texts, low=low, high=high)


@in_python
def define(path: Path) -> tuple[str, ...]:
    """Read the units, constants, reflectances and spectra of a file of definitions.

    They are then known to every function, as they are at a shell (radcalc-units(7)); the notes of
    a result state those that it uses.  Python does not read ``definitions.txt`` by itself.

    Parameters
    ----------
    path : str or os.PathLike
        A file with lines such as ``mylamp = 54 lm/W`` or ``spectrum office = LED-B3``.

    Returns
    -------
    tuple of str
        The names of the file.

    Raises
    ------
    radcalc.RadcalcError
        If a line is not a definition, with its place; nothing is then defined.

    Examples
    --------
    >>> import pathlib, tempfile
    >>> path = pathlib.Path(tempfile.mkdtemp()) / "own.txt"
    >>> _ = path.write_text("smoot = 67 inch")
    >>> define(path)
    ('smoot',)
    >>> explain("2 smoot", "m").notes
    ('own definition: smoot = 67 inch, own.txt line 1',)
    """
    if not isinstance(path, os.PathLike):
        require_texts(path=path)
    return load(os.fspath(path))


@in_python
def examples(search: str = "") -> Listing[Task]:
    """List tasks with the commands that answer them, and how to read the answers.

    Parameters
    ----------
    search : str, optional
        Words that a task mentions: a trade (``"museum"``), a quantity; all tasks by default.

    Returns
    -------
    Listing of Task
        A tuple of named tuples: the `trade`, the `title`, the `question`, the `calls`, each with
        its `command` at a shell and the lines of its `output`, and how to read them (`reading`).

    Raises
    ------
    radcalc.RadcalcError
        If nothing is found.

    Examples
    --------
    >>> [task.title for task in examples("museum log")]
    ['A log']
    """
    require_texts(search=search)
    return Listing(tasks_for(search))
