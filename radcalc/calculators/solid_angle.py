"""The solid angle of a shape, and what goes with it: one small function a shape.

Each imports the geometry that it needs: a cone is to be answered without that of polygons.
"""

import math
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

from radcalc.answer import Answer, Step, Value
from radcalc.calculators.results import known, value
from radcalc.calculators.worksheet import (
    OFFSETS,
    Page,
    Worksheet,
    refuse_slant_for_height,
)
from radcalc.derivation import Formula, format_angle, format_number
from radcalc.errors import (
    ConditionError,
    Exclusive,
    MissingInput,
    NumberError,
    TooNear,
    Unused,
    UsageError,
    command,
    mention,
    options,
)
from radcalc.geometry import cones
from radcalc.given import (
    Given,
    Inputs,
    Point,
    angle_of,
    at_most_one,
    offset_of,
    one_of,
    radius_of,
)
from radcalc.laws.cones import APEX, CONE, PROJECTED_CONE
from radcalc.laws.law import HOWELL, AnyLaw
from radcalc.laws.sizes import CIRCLE, round_sizes
from radcalc.maths import FAINTEST, SLACK, any_true, cos, sin
from radcalc.units.dimensions import LENGTH

CONES = ("half-angle", "apex-angle", "solid-angle", "projected-solid-angle")
ROUND = ("radius", "diameter")
RESULTS = ("solid-angle", "projected-solid-angle", "sphere-fraction", "half-angle", "apex-angle")
FACING = "a plane parallel to the source's (the receiver faces it)"
ZONE = Formula(
    "zone of a sphere", "{solid-angle} = 2 dphi sin((t0 + t1)/2) sin((t1 - t0)/2) Omega0"
)
PROJECTED_ZONE = Formula(
    "projected zone", "{projected-solid-angle} = dphi (sin^2(t1) - sin^2(t0)) / 2 Omega0"
)
DISC_ASIDE = Formula(
    "disc off its axis",
    "{solid-angle} = closed integral over the rim, complete elliptic",
    "F. Paxton, Rev. Sci. Instrum. 30 (1959) 254",
)
PROJECTED_DISC = Formula(
    "projected disc",
    "{projected-solid-angle} = pi/2 (1 - ({height}^2 + {offset}^2 - {radius}^2) / "
    "sqrt(({height}^2 + {offset}^2 + {radius}^2)^2 - 4 {radius}^2 {offset}^2)) Omega0",
    HOWELL,
)
TRIANGLES = Formula(
    "rectangle, as two triangles",
    "tan({solid-angle}/2) = [a b c] / (a b c + (a.b) c + (a.c) b + (b.c) a), each",
    "A. van Oosterom, J. Strackee, IEEE Trans. Biomed. Eng. 30 (1983) 125",
)
CONTOUR = Formula(
    "Lambert's contour formula",
    "{projected-solid-angle} = 1/2 sum of beta cos(delta), over the sides",
    "J. H. Lambert, Photometria (1760)",
)


class Seen(NamedTuple):
    """What a shape adds to the worksheet: its laws, and onto which plane it is projected."""

    laws: Sequence[AnyLaw]
    onto: str


class Shape(NamedTuple):
    """A shape: the inputs it takes, and how it is seen."""

    takes: tuple[str, ...]
    see: Callable[[Worksheet], Seen]


def solid_angle(shape: str, given: Inputs, points: Sequence[Point] = ()) -> Answer:
    """The solid angle of a shape of `SHAPES`, with all that follows from it.

    `given` are its inputs; `points` the vertices of a polygon.
    """
    named = "all directions" if shape == "full" else f"a {shape}"
    takes = SHAPES[shape].takes
    page = Page(named, takes, others=_sizes(takes, given), goal="solid-angle")
    sheet = Worksheet(page, given, with_light=False)
    seen = _polygon(sheet, points) if shape == "polygon" else sheet.place(SHAPES[shape].see)
    sheet.solve(seen.laws)
    if not (sheet.has("solid-angle") and sheet.has("projected-solid-angle")):
        raise _unsolved(sheet)
    omega, flat = sheet.at("solid-angle"), sheet.at("projected-solid-angle")
    if not sheet.notes and min(omega, flat) < FAINTEST:
        raise NumberError("the solid angle is too small for a number", "less extreme sizes")
    half = sheet.at("half-angle") if sheet.has("half-angle") else cones.cone_of(omega)
    sheet.assumptions.insert(0, f"projected onto {seen.onto}")
    found = (omega, flat, omega / cones.FULL, half, 2 * half)
    results = [result(given, name, size) for name, size in zip(RESULTS, found, strict=True)]
    return _in_units_given(sheet.answer(seen.laws, results), given)


def _sizes(takes: Sequence[str], given: Inputs) -> tuple[str, ...]:
    """The sizes to show: those that are given, and one that they are solved for."""
    round_one = set(ROUND) & set(given)
    if "area" in given:
        round_one |= {"area"}
    hidden = {"area", *ROUND} - round_one if round_one else set()
    return tuple(name for name in takes if name not in RESULTS and name not in hidden)


def _in_units_given(answer: Answer, given: Inputs) -> Answer:
    """The answer with a length that was solved for in the unit of one that was given."""
    units = [one.unit_text for one in given.values() if one.dimension == LENGTH]
    values = [
        one._replace(units=(units[0],))
        if units and one.given is None and one.units and one.dimensions == (LENGTH,)
        else one
        for one in answer.values
    ]
    return answer._replace(values=values)


def result(given: Inputs, name: str, size: Any) -> Value:
    """One of the results of every shape."""
    more = ("sr", "deg2") if name == "solid-angle" else ()
    if name in given:
        return known(given[name], *more)
    label = f"{name.replace('-', ' ')} of the equal cone" if name in CONES[:2] else ""
    return value(name, size, *more, label=label)


def _unsolved(sheet: Worksheet) -> UsageError:
    """What is missing of a shape."""
    others = ("diameter", "offset", "tilt", *sheet.given)
    shown = [name for name in sheet.page.takes if name not in others]
    message = f"something is missing: {sheet.page.title} takes two"
    return MissingInput(message, options(shown))


def _enter(sheet: Worksheet, omega: Any, flat: Any, *steps: Step) -> None:
    """Enter what was worked out outside the laws."""
    sheet.know("solid-angle", omega)
    sheet.know("projected-solid-angle", flat)
    sheet.placed += steps
    sheet.use(*sheet.given)


def _sr(size: Any) -> str:
    return f"{format_number(size)} sr"


def _full(sheet: Worksheet) -> Seen:
    sheet.know("half-angle", math.pi)
    step = Formula("all directions", "{solid-angle} = 4 pi Omega0").step({}, _sr(cones.FULL))
    _enter(sheet, cones.FULL, math.pi, step)
    sheet.notes.append("a surface faces one half of the sphere: its projected solid angle is pi")
    return Seen([], "a plane of any normal, from its front")


def _hemisphere(sheet: Worksheet) -> Seen:
    sheet.know("half-angle", math.pi / 2)
    _enter(
        sheet,
        cones.HEMISPHERE,
        math.pi,
        Formula("hemisphere", "{solid-angle} = 2 pi Omega0").step({}, _sr(cones.HEMISPHERE)),
        Formula("projected", "{projected-solid-angle} = pi Omega0").told("Omega_p = pi sr"),
    )
    return Seen([], "the hemisphere's own plane")


def _cone(sheet: Worksheet) -> Seen:
    one_of(sheet.given, "the size of the cone", *CONES)
    laws: list[AnyLaw] = [CONE, PROJECTED_CONE, *([APEX] if "apex-angle" in sheet.given else [])]
    sheet.solve(laws)
    if sheet.at("half-angle") > math.pi / 2:
        sheet.notes.append("what is behind that plane does not count: a hemisphere is left")
    return Seen(laws, "a plane whose normal is the cone's axis")


def _zone(sheet: Worksheet) -> Seen:
    from radcalc.geometry import projected, solid

    if "polar" not in sheet.given:
        raise MissingInput(
            "the polar angles of the zone are missing", mention("{polar=30deg:60deg}")
        )
    polar, azimuth = sheet.given["polar"], sheet.given.get("azimuth")
    low, high = polar.value
    width = azimuth.value[1] - azimuth.value[0] if azimuth else 2 * math.pi
    omega, flat = solid.zone(low, high, width), projected.zone(low, high, width)
    if high > math.pi / 2 * (1 + SLACK):
        sheet.notes.append("what is below that plane, past 90 deg, does not count")
    t0, t1 = format_angle(low), format_angle(high)
    numbers = f"2 ({format_number(width)}) sin(({t0} + {t1})/2) sin(({t1} - {t0})/2) sr"
    _enter(
        sheet,
        omega,
        flat,
        ZONE.told(f"Omega = {numbers} = {_sr(omega)}"),
        PROJECTED_ZONE.told(f"Omega_p = {_sr(flat)}"),
    )
    around = f"azimuths from {_span(azimuth)} deg" if azimuth else "all azimuths"
    sheet.assume(f"polar angles from {_span(polar)} deg, {around}")
    return Seen([], "a plane whose normal is +z")


def _span(interval: Given) -> str:
    return " to ".join(format_number(math.degrees(end)) for end in interval.value)


def _sphere(sheet: Worksheet) -> Seen:
    from radcalc.laws.solid_angles import SPHERE

    at_most_one(sheet.given, "the size of the source", *ROUND)
    sizes = {"radius" if name in ROUND else name for name in sheet.given}
    if len(sizes) != 2:
        takes = ("radius", "distance", "solid-angle")
        if len(sizes) < 2:
            others = options(name for name in takes if name not in sizes)
            raise MissingInput("something is missing: a sphere takes two", others)
        given = [name for name in sheet.given if name != "solid-angle" or len(sizes) > 2]
        raise MissingInput(
            "too much is given: a sphere takes two", f"without one of {options(given, ', ')}"
        )
    laws = [*round_sizes(sheet.given), SPHERE, CONE, PROJECTED_CONE]
    return Seen(laws, "a plane whose normal points to the sphere's centre")


def _above(given: Inputs) -> Given:
    """The height above a flat shape; on its axis, the distance is the same."""
    one = one_of(given, "the height above the source", "height", "distance")
    if one.name == "distance" and {"corner", *OFFSETS} & set(given):
        refuse_slant_for_height()
    return one


def _disc(sheet: Worksheet) -> Seen:
    from radcalc.geometry import projected, solid
    from radcalc.laws.solid_angles import disc

    given = sheet.given
    offset = offset_of(given)
    if "solid-angle" in given:
        away = "height" if "height" in given else "distance"
        if offset:
            raise Exclusive(("solid-angle", "offset"), "do not go together: it is for the axis")
        at_most_one(given, "the size of the source", *ROUND)
        if not {*ROUND, "height", "distance"} & set(given):
            raise _unsolved(sheet)
        sheet.use("offset")
        return Seen([*round_sizes(given), disc(away), CONE, PROJECTED_CONE], FACING)
    size = radius_of(one_of(given, "the size of the source", *ROUND))
    height = _above(given)
    omega = solid.disc(size, height.value, offset)
    flat = projected.disc(size, height.value, offset)
    at = {"radius": size, height.name: height.value}
    step = disc(height.name).formula.step(at, _sr(omega))
    if offset:
        where = ", ".join(
            f"{letter} = {format_number(length)} m"
            for letter, length in zip("Rhx", (size, height.value, offset), strict=True)
        )
        step = DISC_ASIDE.told(f"{where}; Omega = {_sr(omega)}")
    _enter(sheet, omega, flat, step, PROJECTED_DISC.told(f"Omega_p = {_sr(flat)}"))
    return Seen([], FACING)


def _rectangle(sheet: Worksheet) -> Seen:
    from radcalc.geometry import projected, solid

    given = sheet.given
    for name in ("width", "length"):
        one_of(given, f"the {name} of the rectangle", name)
    width, length = given["width"].value, given["length"].value
    height = _above(given).value
    x, y = offset_of(given), offset_of(given, "offset-y")
    if "corner" in given:
        if x or y:
            raise Exclusive(("corner", "offset"))
        x, y = width / 2, length / 2
        sheet.assume("seen from above a corner")
    omega = solid.rectangle(width, length, height, x, y)
    flat = projected.rectangle(width, length, height, x, y)
    sizes = [f"{format_number(size)} m" for size in (width, length, height, x, y)]
    numbers = "w = {}, l = {}, h = {}, offsets {} and {}".format(*sizes)
    _enter(sheet, omega, flat, TRIANGLES.told(f"{numbers}; Omega = {_sr(omega)}"), _contour(flat))
    return Seen([], FACING)


def _contour(flat: Any) -> Step:
    return CONTOUR.told(f"Omega_p = {_sr(flat)}")


def _pyramid(sheet: Worksheet) -> Seen:
    from radcalc.geometry import projected
    from radcalc.laws.solid_angles import PYRAMID

    given = sheet.given
    sheet.assume("the angles are full ones, from face to face through the axis")
    if "solid-angle" not in given:
        for name in ("horizontal", "vertical"):
            one_of(given, f"the {name} angle", name)
    sheet.solve([PYRAMID])
    if sheet.has("horizontal") and sheet.has("vertical"):
        flat = projected.pyramid(sheet.at("horizontal"), sheet.at("vertical"))
        sheet.know("projected-solid-angle", flat)
        sheet.placed.append(_contour(flat))
    return Seen([PYRAMID], "a plane whose normal is the pyramid's axis")


def _patch(sheet: Worksheet) -> Seen:
    from radcalc.geometry import far_field
    from radcalc.laws.solid_angles import PATCH

    given = sheet.given
    if "area" in given and set(ROUND) & set(given):
        return _on_sphere(sheet)
    laws: list[AnyLaw] = [PATCH]
    if set(ROUND) & set(given):
        laws = [*round_sizes(given), CIRCLE, PATCH]
    if "solid-angle" not in given:
        one_of(given, "the size of the patch", "area", *ROUND)
        one_of(given, "the distance", "distance")
    sheet.use("tilt")
    sheet.know("cosine-of-source", cones.facing(angle_of(given, "tilt")))
    sheet.solve(laws)
    if sheet.has("area") and sheet.has("distance"):
        area, away, tilt = sheet.at("area"), sheet.at("distance"), angle_of(given, "tilt")
        _refuse_near(sheet, area, away)
        sheet.know("projected-solid-angle", sheet.at("solid-angle"))
        if sheet.at("solid-angle") == 0:
            sheet.notes.append("the patch is seen from its edge or from behind")
        good = far_field.percent(far_field.error(far_field.size(area), away, tilt))
        sheet.assume(f"a patch small beside its distance: A cos(theta) / d^2 is {good}")
    return Seen(laws, "a plane whose normal points to the patch")


def _on_sphere(sheet: Worksheet) -> Seen:
    """A patch of a sphere, seen from the sphere's centre."""
    from radcalc.laws.solid_angles import ON_SPHERE

    given = sheet.given
    one_of(given, "the size of the sphere", *ROUND)
    if others := [name for name in given if name not in ("area", *ROUND)]:
        raise Unused(others, "with a patch of a sphere")
    laws: list[AnyLaw] = [*round_sizes(given), ON_SPHERE]
    sheet.solve(laws)
    if any_true(sheet.at("solid-angle") > cones.FULL * (1 + SLACK)):
        size = format_number(sheet.at("solid-angle") / cones.FULL)
        problem = f"{sheet.told('area')} is {size} times the whole sphere"
        raise ConditionError(problem, f"a smaller {options(['area'])}, or a larger sphere")
    sheet.know(
        "projected-solid-angle", cones.projected_cone(cones.cone_of(sheet.at("solid-angle")))
    )
    sheet.assume("a patch of the sphere, in any shape, seen from its centre")
    return Seen(laws, "a plane whose normal points to the patch, as if it were a round one")


def _refuse_near(sheet: Worksheet, area: Any, away: Any) -> None:
    """Refuse a patch seen from so near that A cos(theta) / d^2 is off."""
    from radcalc.geometry import far_field

    size = far_field.size(area)
    if far_field.is_near(away, size):
        tilt = angle_of(sheet.given, "tilt")
        place = {"height": away * cos(tilt), "offset": away * sin(tilt)} if tilt else {}
        sizes = {"radius": size / 2, **(place or {"distance": away})}
        disc = {name: f"{format_number(length)}m" for name, length in sizes.items()}
        exact = f"{command('solid-angle', 'disc', **disc)}, if it is a circle, which is exact"
        law = "A cos(theta) / d^2"
        raise TooNear(sheet.told("distance"), "source", format_number(size), exact, law)


def _polygon(sheet: Worksheet, points: Sequence[Point]) -> Seen:
    from radcalc.geometry import outline, projected
    from radcalc.geometry.polygons import polygon

    given = sheet.given
    viewpoint: Point = given["viewpoint"].value if "viewpoint" in given else (0.0, 0.0, 0.0)
    normal: Point | None = given["normal"].value if "normal" in given else None
    shape = outline.read(points, viewpoint)
    omega = abs(polygon(shape.vertices))
    flat = projected.polygon(shape.vertices, normal or shape.normal)
    sheet.notes += shape.notes
    plane = "a plane parallel to the polygon's"
    if normal:
        plane = f"a plane whose normal is {','.join(map(format_number, normal))}"
        if shape.dips_below(normal):
            sheet.notes.append(mention("what is below the horizon of {normal} is cut away"))
    step = TRIANGLES._replace(name="polygon, as triangles").told(
        f"{len(points)} vertices; Omega = {_sr(omega)}"
    )
    _enter(sheet, omega, flat, step, _contour(flat))
    seen_from = ",".join(map(format_number, viewpoint))
    sheet.assume(f"a polygon of {len(points)} vertices, seen from {seen_from}")
    return Seen([], plane)


SHAPES = {
    "full": Shape((), _full),
    "hemisphere": Shape((), _hemisphere),
    "cone": Shape(CONES, _cone),
    "zone": Shape(("polar", "azimuth"), _zone),
    "sphere": Shape((*ROUND, "distance", "solid-angle"), _sphere),
    "disc": Shape((*ROUND, "distance", "height", "offset", "solid-angle"), _disc),
    "rectangle": Shape(("width", "length", "distance", "height", *OFFSETS, "corner"), _rectangle),
    "pyramid": Shape(("horizontal", "vertical", "solid-angle"), _pyramid),
    "patch": Shape(("area", *ROUND, "distance", "tilt", "solid-angle"), _patch),
    "polygon": Shape(("viewpoint", "normal"), lambda sheet: _polygon(sheet, ())),
}
ALIASES = {"band": "zone", "triangle": "polygon"}
NAMES = (*SHAPES, "pixel", *ALIASES)  # a pixel has a page of its own
