"""Solid angles and projected solid angles of shapes.

The function of each shape imports its own geometry, so that a cone does not load polygons.
"""

import math
from collections.abc import Callable, Sequence
from functools import partial

from radcalc import errors, geometry
from radcalc.answer import Answer, Formula, format_angle, format_number, texts_of
from radcalc.calculators.page import Operand, Page, words_of
from radcalc.calculators.pixel import ROUND, contour, enter, onto, patch, sr
from radcalc.calculators.results import of_directions
from radcalc.calculators.solved import Task, Wants, solve
from radcalc.calculators.worksheet import (
    OFFSETS,
    Placed,
    Worksheet,
    place,
    refuse_slant_for_height,
    worksheet,
)
from radcalc.errors import options, quote
from radcalc.inputs import Input, Inputs, any_of, offset_of, one_of, radius_of
from radcalc.inputs.places import Point, read_point
from radcalc.laws import APEX, CONE, PROJECTED_CONE, round_sizes
from radcalc.laws.beams import DISC_ASIDE, PROJECTED_DISC, PROJECTED_ZONE, TRIANGLES, ZONE
from radcalc.maths import FAINTEST, SLACK, any_true, hypot, smaller
from radcalc.quantities.symbols import CHOICE
from radcalc.tuples import NamedTuple
from radcalc.units.dimensions import LENGTH

CONES = ("half-angle", "apex-angle", "solid-angle", "projected-solid-angle")
RESULTS = ("solid-angle", "projected-solid-angle", "sphere-fraction", "half-angle", "apex-angle")
FACING = "a plane parallel to the source (the receiver faces it)"


class Shape(NamedTuple):
    """A shape: its inputs, and a function from inputs to values and laws."""

    takes: tuple[str, ...]
    place: Callable[[Worksheet], Placed]


def task(words: Sequence[str], wants: Wants) -> Task:
    """Return the task of a call: a shape, and the vertices of a polygon."""
    if not words:
        examples = {words_of(example)[0][0]: example for example in PAGE.examples[::-1]}
        ways = [errors.call("solid-angle", *words_of(examples[name])[0]) for name in USUAL]
        raise errors.UsageError("a shape is missing", ", ".join(NAMES), ways)
    shape, *vertices = words
    if shape.lower() not in NAMES:
        takes = {name: known.takes for name, known in SHAPES.items() if known.takes}
        return Task("solid-angle", partial(OPERAND.refuse, shape, takes))
    shape = OPERAND.choice(shape)
    shape = ALIASES.get(shape, shape)
    if shape != "polygon" and vertices:
        problem = f"unexpected argument '{quote(vertices[0])}'"
        raise errors.UsageError(problem, errors.mention("options, as in {help}"))
    points = _points(vertices)
    work_out: Callable[[Inputs], Answer] = partial(solid_angle, shape, points=points)
    if shape == "pixel":
        from radcalc.calculators.pixel import pixel

        work_out = pixel
    operands = texts_of({"shape": shape, "vertices": " ".join(vertices)})
    return Task("solid-angle", work_out, operands, shape)


def _points(vertices: Sequence[str]) -> list[Point]:
    try:
        return [read_point(vertex, "the vertex") for vertex in vertices]
    except errors.ConditionError as error:
        raise error.reworded(tries=_with_three(vertices)) from None


def _with_three(vertices: Sequence[str]) -> list[errors.Try]:
    """Propose three coordinates of the first vertex that has two or four."""
    parts = [vertex.split(",") for vertex in vertices]
    thirds = {coordinates[2] for coordinates in parts if len(coordinates) == 3}
    for vertex, (x, y, *rest) in [(v, p) for v, p in zip(vertices, parts, strict=True) if p[1:]]:
        if not rest and len(thirds) == 1:
            return [
                errors.correct(
                    vertex, ",".join([x, y, *thirds]), remark="in the plane of the others"
                )
            ]
        if len(rest) == 2:
            decimal = errors.correct(
                vertex, f"{x},{y},{'.'.join(rest)}", remark="with a decimal point"
            )
            return [decimal, errors.correct(vertex, f"{x},{y},{rest[0]}", remark="the first three")]
    return []


def solid_angle(shape: str, given: Inputs, points: Sequence[Point] = ()) -> Answer:
    """Return the solid angle of a shape of `SHAPES`, with the equal cone and other results.

    `points` are the vertices of a polygon.
    """
    named = "all directions" if shape == "full" else f"a {shape}"
    takes = SHAPES[shape].takes
    page = Page(named, takes, others=_sizes(takes, given), goal="solid-angle")
    sheet = worksheet(page, given, with_light=False)
    placed = _polygon(sheet, points) if shape == "polygon" else place(sheet, SHAPES[shape].place)
    solved = solve(sheet, placed.laws, placed)
    if not (solved.has("solid-angle") and solved.has("projected-solid-angle")):
        raise _missing_input(sheet)
    omega, flat = solved.value("solid-angle"), solved.value("projected-solid-angle")
    if not solved.notes and any_true(smaller(omega, flat) < FAINTEST):
        raise errors.NumberError("the solid angle is too small for a number", "less extreme sizes")
    half = solved.value("half-angle") if solved.has("half-angle") else geometry.cone_of(omega)
    sizes = (omega, flat, omega / geometry.FULL, half, 2 * half)
    results = [of_directions(given, name, size) for name, size in zip(RESULTS, sizes, strict=True)]
    for result in results:
        solved.derived.setdefault(result.name, ["solid-angle"])
    return _in_units_given(solved.answer(results), given)


def _sizes(takes: Sequence[str], given: Inputs) -> tuple[str, ...]:
    """Return the sizes to show: the given ones, and the one that follows."""
    round_one = set(ROUND) & set(given)
    if "area" in given:
        round_one |= {"area"}
    hidden = {"area", *ROUND} - round_one if round_one else set()
    return tuple(name for name in takes if name not in RESULTS and name not in hidden)


def _in_units_given(answer: Answer, given: Inputs) -> Answer:
    """Return the answer with computed lengths in the unit of a given length."""
    units = [item.unit_text for item in given.values() if item.dimension == LENGTH]
    values = [
        item._replace(units=(units[0],))
        if units and item.given is None and item.units and item.dimensions == (LENGTH,)
        else item
        for item in answer.values
    ]
    return answer._replace(values=values)


def _missing_input(sheet: Worksheet) -> errors.UsageError:
    optional = ("diameter", "offset", "tilt", *sheet.given)
    choices = [name for name in sheet.page.takes if name not in optional]
    message = f"an input is missing: {sheet.page.title} takes two"
    return errors.MissingInput(message, options(choices))


def _full(sheet: Worksheet) -> Placed:
    placed = onto("a plane of any normal, from its front")
    placed.add("half-angle", math.pi)
    placed.note("a surface faces only half of the sphere: the projected solid angle is pi")
    step = Formula("all directions", "{solid-angle} = 4 pi Omega0").step({}, sr(geometry.FULL))
    return enter(sheet, placed, geometry.FULL, math.pi, step)


def _hemisphere(sheet: Worksheet) -> Placed:
    placed = onto("the hemisphere's own plane")
    placed.add("half-angle", math.pi / 2)
    return enter(
        sheet,
        placed,
        geometry.HEMISPHERE,
        math.pi,
        Formula("hemisphere", "{solid-angle} = 2 pi Omega0").step({}, sr(geometry.HEMISPHERE)),
        Formula("projected", "{projected-solid-angle} = pi Omega0").with_numbers("Omega_p = pi sr"),
    )


def _cone(sheet: Worksheet) -> Placed:
    any_of(sheet.given, "the size of the cone", *CONES)
    apex = [APEX] if "apex-angle" in sheet.given else []
    placed = onto("a plane whose normal is the cone's axis", *apex, CONE, PROJECTED_CONE)
    if any_true(solve(sheet, placed.laws).value("half-angle") > math.pi / 2):
        placed.note("the part behind that plane does not count: only a hemisphere does")
    return placed


def _zone(sheet: Worksheet) -> Placed:
    """Place a zone between two polar angles, of all azimuths or between two of them."""
    from radcalc.geometry import solid

    if "polar" not in sheet.given:
        raise errors.MissingInput(
            "the polar angles of the zone are missing", errors.mention("{polar=30deg:60deg}")
        )
    placed = onto("a plane whose normal is +z")
    polar, azimuth = sheet.given["polar"], sheet.given.get("azimuth")
    low, high = polar.value
    width = azimuth.value[1] - azimuth.value[0] if azimuth else 2 * math.pi
    omega, flat = solid.zone(low, high, width), solid.projected_zone(low, high, width)
    if high > math.pi / 2 * (1 + SLACK):
        placed.note("the part below that plane, past 90 deg, does not count")
    t0, t1 = format_angle(low), format_angle(high)
    numbers = f"2 ({format_number(width)}) sin(({t0} + {t1})/2) sin(({t1} - {t0})/2) sr"
    around = f"azimuths from {_span(azimuth)} deg" if azimuth else "all azimuths"
    placed.assume(f"polar angles from {_span(polar)} deg, {around}")
    return enter(
        sheet,
        placed,
        omega,
        flat,
        ZONE.with_numbers(f"Omega = {numbers} = {sr(omega)}"),
        PROJECTED_ZONE.with_numbers(f"Omega_p = {sr(flat)}"),
    )


def _span(interval: Input) -> str:
    return " to ".join(format_number(math.degrees(end)) for end in interval.value)


def _sphere(sheet: Worksheet) -> Placed:
    from radcalc.laws.beams import SPHERE

    sizes = {"radius" if name in ROUND else name for name in sheet.given}
    if len(sizes) < 2:
        takes = ("radius", "distance", "solid-angle")
        missing = options(name for name in takes if name not in sizes)
        raise errors.MissingInput("an input is missing: a sphere takes two", missing)
    laws = [*round_sizes(sheet.given), SPHERE, CONE, PROJECTED_CONE]
    return onto("a plane whose normal points to the sphere's centre", *laws)


def _height_above(given: Inputs) -> Input:
    """Return the height above a flat shape; on the axis it may be given as the distance."""
    height = any_of(given, "the height above the source", "height", "distance")
    if height.name == "distance" and {"corner", *OFFSETS} & set(given):
        refuse_slant_for_height(given["distance"])
    return height


def _disc(sheet: Worksheet) -> Placed:
    """Place a disc, seen from its axis or aside; on the axis its solid angle may be given."""
    from radcalc.geometry import solid
    from radcalc.laws.beams import disc

    given = sheet.given
    offset = offset_of(given)
    is_aside = any_true(offset != 0)
    is_sized, is_placed = (not set(given).isdisjoint(n) for n in (ROUND, ("height", "distance")))
    if "solid-angle" in given and not (is_sized and is_placed):
        away = "height" if "height" in given else "distance"
        if is_aside:
            raise errors.Exclusive(("solid-angle", "offset"), "it is a solid angle on the axis")
        if not (is_sized or is_placed):
            raise _missing_input(sheet)
        placed = onto(FACING, *round_sizes(given), disc(away), CONE, PROJECTED_CONE)
        _compare_distance(placed, given)
        placed.use("offset")
        return placed
    size = radius_of(any_of(given, "the size of the source", *ROUND))
    height = _height_above(given)
    omega = solid.disc(size, height.value, offset)
    flat = solid.projected_disc(size, height.value, offset)
    at = {"radius": size, height.name: height.value}
    step = disc(height.name).formula.step(at, sr(omega))
    if is_aside:
        where = ", ".join(
            f"{letter} = {format_number(length)} m"
            for letter, length in zip("Rhx", (size, height.value, offset), strict=True)
        )
        step = DISC_ASIDE.with_numbers(f"{where}; Omega = {sr(omega)}")
    projection = PROJECTED_DISC.with_numbers(f"Omega_p = {sr(flat)}")
    placed = onto(FACING, *round_sizes(given))
    _compare_distance(placed, given)
    return enter(sheet, placed, omega, flat, step, projection)


def _compare_distance(placed: Placed, given: Inputs) -> None:
    """Compare a distance with the height and the offset, if both are given."""
    if {"height", "distance"} <= given.keys():
        placed.add("distance", hypot(given["height"].value, offset_of(given)))


def _rectangle(sheet: Worksheet) -> Placed:
    """Place a rectangle, seen from a height over its centre, an offset or a corner."""
    from radcalc.geometry import solid

    given = sheet.given
    for name in ("width", "length"):
        one_of(given, f"the {name} of the rectangle", name)
    width, length = given["width"].value, given["length"].value
    height = _height_above(given).value
    x, y = offset_of(given), offset_of(given, "offset-y")
    placed = onto(FACING)
    if "corner" in given:
        x, y = placed.corner(given, width, length)
        placed.assume("seen from above a corner")
    if {"height", "distance"} <= given.keys():
        placed.add("distance", hypot(height, hypot(x, y)))
    omega = solid.rectangle(width, length, height, x, y)
    flat = solid.projected_rectangle(width, length, height, x, y)
    sizes = [f"{format_number(size)} m" for size in (width, length, height, x, y)]
    numbers = "w = {}, l = {}, h = {}, offsets {} and {}".format(*sizes)
    step = TRIANGLES.with_numbers(f"{numbers}; Omega = {sr(omega)}")
    return enter(sheet, placed, omega, flat, step, contour(flat))


def _pyramid(sheet: Worksheet) -> Placed:
    """Place a pyramid by two of its horizontal angle, vertical angle and solid angle."""
    from radcalc.geometry import solid
    from radcalc.laws.beams import PYRAMID

    given = sheet.given
    placed = onto("a plane whose normal is the pyramid's axis", PYRAMID)
    placed.assume("the angles are full angles, from face to face through the axis")
    if "solid-angle" not in given:
        for name in ("horizontal", "vertical"):
            one_of(given, f"the {name} angle", name)
    solved = solve(sheet, placed.laws)
    if solved.has("horizontal") and solved.has("vertical"):
        flat = solid.projected_pyramid(solved.value("horizontal"), solved.value("vertical"))
        placed.add("projected-solid-angle", flat)
        placed.steps.append(contour(flat))
    return placed


def _polygon(sheet: Worksheet, points: Sequence[Point]) -> Placed:
    """Place a polygon, seen from the viewpoint and projected onto its plane or a normal's."""
    from radcalc.geometry import polygons, solid
    from radcalc.geometry.polygons import polygon

    given = sheet.given
    viewpoint: Point = given["viewpoint"].value if "viewpoint" in given else (0.0, 0.0, 0.0)
    normal: Point | None = given["normal"].value if "normal" in given else None
    try:
        shape = polygons.read_vertices(points, viewpoint)
    except errors.ConditionError as error:  # another polygon keeps the viewpoint and the normal
        others = [f"{name}={item.text}" for name, item in given.items()]
        ways = [errors.call(*way.words, *others) if way.words else way for way in error.tries]
        raise error.reworded(tries=ways) from None
    omega = abs(polygon(shape.vertices))
    flat = solid.projected_polygon(shape.vertices, normal or shape.normal)
    plane = "a plane parallel to the polygon"
    if normal:
        plane = f"a plane whose normal is {','.join(map(format_number, normal))}"
    placed = onto(plane)
    placed.note(*shape.notes)
    if normal and shape.dips_below(normal):
        placed.note(errors.mention("the part below the horizon of {normal} does not count"))
    step = TRIANGLES._replace(name="polygon, as triangles").with_numbers(
        f"{len(points)} vertices; Omega = {sr(omega)}"
    )
    seen_from = ",".join(map(format_number, viewpoint))
    placed.assume(f"a polygon of {len(points)} vertices, seen from {seen_from}")
    return enter(sheet, placed, omega, flat, step, contour(flat))


SHAPES = {
    "full": Shape((), _full),
    "hemisphere": Shape((), _hemisphere),
    "cone": Shape(CONES, _cone),
    "zone": Shape(("polar", "azimuth"), _zone),
    "sphere": Shape((*ROUND, "distance", "solid-angle"), _sphere),
    "disc": Shape((*ROUND, "distance", "height", "offset", "solid-angle"), _disc),
    "rectangle": Shape(("width", "length", "distance", "height", *OFFSETS, "corner"), _rectangle),
    "pyramid": Shape(("horizontal", "vertical", "solid-angle"), _pyramid),
    "patch": Shape(("area", *ROUND, "distance", "tilt", "solid-angle"), patch),
    "polygon": Shape(("viewpoint", "normal"), lambda sheet: _polygon(sheet, ())),
}
ALIASES = {"band": "zone", "cap": "cone", "triangle": "polygon"}
USUAL = ("cone", "disc", "rectangle")  # to propose
NAMES = (*SHAPES, "pixel", *ALIASES)  # `pixel.py` has the pixel
OPERAND = Operand("shape", "SHAPE [X,Y,Z ...]", CHOICE, NAMES)
PAGE = Page(
    results=("sphere-fraction",),
    about="Calculate the solid angle of a shape, and its projected solid angle.",
    operand=OPERAND,
    sections={
        "Cone": ("half-angle", "apex-angle", "projected-solid-angle", "solid-angle"),
        "Zone": ("polar", "azimuth"),
        "Sphere, disc, rectangle, patch": (
            "radius",
            "diameter",
            "width",
            "length",
            "area",
            "distance",
            "height",
            "offset",
            "offset-y",
            "corner",
            "tilt",
        ),
        "Pyramid": ("horizontal", "vertical"),
        "Polygon": ("viewpoint", "normal"),
        "Pixel": ("size", "pixel", "projection"),
    },
    texts={
        "radius": "Radius of a sphere, a disc or a round patch.",
        "diameter": "Diameter of a sphere, a disc or a round patch.",
        "width": "Width of a rectangle, along x.",
        "length": "Length of a rectangle, along y.",
        "area": "Area of a small patch.",
        "tilt": "Angle between the normal of a patch and the line of sight.",
        "solid-angle": "Solid angle of the shape (cone or sphere).",
        "projection": "Projection of a map of the sphere: latlong (2:1 image), mirror-ball or "
        "angular (square images).",
        "polar": ("30deg:60deg", "Polar angles of a zone, from +z."),
        "azimuth": ("0deg:90deg", "Azimuths of a zone (default: all)."),
        "distance": "Straight-line distance to the centre of the shape.",
        "height": "Distance of the viewpoint from the shape's plane, measured along the shape's "
        "axis.",
        "offset": "Sideways distance from the shape's axis, along x (with {height}).",
        "offset-y": "Sideways distance from the shape's axis, along y (with {height}).",
        "corner": "Viewpoint above a corner of the rectangle.",
    },
    examples=(
        "cone half-angle=30deg",
        "cone solid-angle=1sr               (its half angle)",
        "zone polar=30deg:60deg azimuth=0deg:90deg",
        "sphere radius=695700km distance=1au",
        "disc diameter=10cm height=50cm offset=0cm:40cm:10cm",
        "rectangle width=2m length=1m height=1m corner=",
        "pyramid horizontal=60deg vertical=40deg",
        "patch area=1cm2 distance=2m tilt=60deg",
        "polygon 1,0,0 0,1,0 0,0,1 get=solid-angle:deg2",
        "pixel size=1024x512 pixel=0,255",
    ),
    remarks="""
    \b
    SHAPE is one of:
      full, hemisphere   all directions, or the half above a plane
      cone (cap)         {half-angle}, {apex-angle}, {solid-angle} or {projected-solid-angle}
      zone (band)        {polar} A:B, {azimuth} A:B
      sphere             two of {radius} (or {diameter}), {distance}, {solid-angle}
      disc               {radius} or {diameter}; {height} (or, on the axis, {distance}); optionally
                         {offset}
      rectangle          {width} and {length}; {height} (or, on the axis, {distance}); optionally
                         {offset} and {offset-y}, or {corner}
      pyramid            {horizontal} and {vertical}, full angles
      patch              a small flat surface: {area} (or {radius}, {diameter}), {distance}, {tilt};
                         or {area} of a part of a sphere and {radius} of that sphere, seen from the
                         sphere's centre
      polygon (triangle) X,Y,Z of each vertex in order, {viewpoint}, {normal}
      pixel              {size}, {pixel}, {projection}: a pixel of a map of all directions

    Quantities may be lists (1m,2m) or ranges (1m:5m:1m), with an answer for each value.
    """,
    mistakes=("projected cone", "pair of full angles", "disc off its axis"),
)
