"""Solid angles of the pixels of a map and of small patches, and what all shapes have in common."""

import math
from typing import Any

from radcalc import errors, geometry
from radcalc.answer import Answer, Formula, Remark, Step, Value, format_angle, format_number
from radcalc.calculators.direction import CONVENTION
from radcalc.calculators.results import absent, of_directions, value
from radcalc.calculators.solved import Solved, solve
from radcalc.calculators.worksheet import (
    Placed,
    Worksheet,
    place,
    refuse_foreign,
)
from radcalc.errors import ConditionError, add, mention, option, options, quote
from radcalc.geometry.projections import (
    direction_at,
    has_shape,
    is_outside,
    middle_of_pixel,
    name_of_map,
    pixel_solid_angle,
    spherical,
)
from radcalc.inputs import Input, Inputs, angle_of, any_of, one_of
from radcalc.laws import CIRCLE, AnyLaw, round_sizes
from radcalc.laws.beams import CONTOUR
from radcalc.maths import SLACK, any_true, cos, sin
from radcalc.quantities.symbols import ANGULAR, LATLONG, MIRROR_BALL, WHOLE_SPHERE

TAKES = ("size", "pixel", "projection")
RESULTS = ("solid-angle", "sphere-fraction", "half-angle", "apex-angle")
AXES = {
    LATLONG: "the middle of the map shows +x, its top +z, and +y is to the left of the middle",
    MIRROR_BALL: "the middle of the map shows +x, the direction to the camera; +z is up, and +y to "
    "the right, as in a mirror",
    ANGULAR: "the middle of the map shows +x; +z is up, and +y to the left",
}
FORMULAS = {
    LATLONG: Formula(
        "pixel of a latlong map",
        "{solid-angle} = Omega0 (4 pi / width) sin(t) sin(pi / (2 height)), "
        "t = pi (row + 1/2) / height",
    ),
    MIRROR_BALL: Formula(
        "pixel of a mirror ball",
        "{solid-angle} = integral of 4 Omega0 du dv, sqrt(u^2 + v^2) up to 1",
    ),
    ANGULAR: Formula(
        "pixel of an angular map",
        "{solid-angle} = integral of Omega0 pi (sin(pi r) / r) du dv, r = sqrt(u^2 + v^2) up to 1",
    ),
}


def pixel(given: Inputs) -> Answer:
    """Return the solid angle of a pixel of a map."""
    refuse_foreign(given, TAKES, "a pixel")
    size = one_of(given, "the size of the map", "size")
    place = one_of(given, "the pixel", "pixel")
    projection = given["projection"].value if "projection" in given else LATLONG
    if projection not in WHOLE_SPHERE:
        problem = f"{option('projection', projection)} does not show the whole sphere"
        raise ConditionError(problem, " or ".join(option("projection", p) for p in WHOLE_SPHERE))
    (width, height), (column, row) = size.value, place.value
    refuse_shape(size, projection, "projection" in given)
    if column >= width or row >= height:
        raise ConditionError(
            f"{option('pixel', quote(place.text))} is outside the map",
            f"columns from 0 to {width - 1}, rows from 0 to {height - 1}",
        )
    omega = pixel_solid_angle(projection, width, height, column, row)
    u, v = middle_of_pixel(width, height, column, row)
    half = geometry.cone_of(omega)
    angles = (omega, omega / geometry.FULL, half, 2 * half)
    results = [
        of_directions(given, name, angle) for name, angle in zip(RESULTS, angles, strict=True)
    ]
    assumptions = ["the pixel 0,0 is at the top left"]
    if "projection" not in given:
        assumptions.insert(0, mention("a latlong map ({projection})"))
    if not is_outside(projection, u, v):
        middle = AXES[projection], f"direction of the pixel's middle: {CONVENTION}"
        assumptions += [Remark(text, ["polar", "azimuth"]) for text in middle]
    notes = []
    if not omega:
        notes = ["the pixel shows nothing: it is outside the circle of the map"]
    elif is_outside(projection, abs(u) + 1 / width, abs(v) + 1 / height):  # its outer corner
        notes = ["the circle of the map cuts the pixel: only the part inside counts"]
    step = _step(projection, size, place, omega, (u, v))
    return Answer([*results, *_middle(projection, u, v)], assumptions, notes, [step])


def refuse_shape(size: Input, projection: str, is_given: bool = True) -> None:
    """Refuse a size that does not suit a projection; the hint depends on `is_given`."""
    width, height = size.value
    if has_shape(projection, width, height):
        return
    option_text = option("size", quote(size.text))
    if projection == LATLONG:
        ways = [add("size", f"{2 * height}x{height}")]
        if not is_given and width == height:
            ways = [add("projection", name) for name in (MIRROR_BALL, ANGULAR)] + ways
        raise ConditionError(
            f"{option_text} is not twice as wide as high, as a latlong map is", ways
        )
    hint = option("size", f"{height}x{height}")
    raise ConditionError(f"{option_text} is not square, as {name_of_map(projection)} is", hint)


def _middle(projection: str, u: float, v: float) -> list[Value]:
    if is_outside(projection, u, v):
        problem = "the middle of the pixel is outside the circle of the map"
        return [absent(name, problem, "a pixel further inside") for name in ("polar", "azimuth")]
    polar, azimuth, _ = spherical(*direction_at(projection, u, v))
    return [value("polar", polar), value("azimuth", azimuth)]


def _step(
    projection: str, size: Input, place: Input, omega: float, middle: tuple[float, float]
) -> Step:
    (width, height), (_, row) = size.value, place.value
    result = f"Omega = {format_number(omega)} sr"
    if projection == LATLONG:
        t = format_angle(math.pi * (row + 0.5) / height)
        numbers = f"width = {width}, height = {height}, row = {row}: t = {t}; {result}"
    else:
        u, v = map(format_number, middle)
        numbers = f"{2 / width:g} by {2 / height:g} about u = {u}, v = {v}; {result}"
    return FORMULAS[projection].with_numbers(numbers)


ROUND = ("radius", "diameter")


def onto(plane: str, *laws: AnyLaw) -> Placed:
    """Return a new `Placed` with the laws of a shape and its plane of projection."""
    placed = Placed(*laws)
    placed.assume(f"projected onto {plane}", of=["projected-solid-angle"])
    return placed


def enter(sheet: Worksheet, placed: Placed, omega: Any, flat: Any, *steps: Step) -> Placed:
    """Add solid angles that use all inputs, with their steps."""
    placed.add("solid-angle", omega)
    placed.add("projected-solid-angle", flat)
    placed.steps += steps
    placed.use(*sheet.given)
    return placed


def sr(size: Any) -> str:
    """Return a solid angle with its unit."""
    return f"{format_number(size)} sr"


def contour(flat: Any) -> Step:
    """Return the step of Lambert's contour formula."""
    return CONTOUR.with_numbers(f"Omega_p = {sr(flat)}")


def patch(sheet: Worksheet) -> Placed:
    """Return the values and laws of a small patch at a distance."""
    from radcalc.laws.beams import PATCH

    given = sheet.given
    if "area" in given and set(ROUND) & set(given):
        return _on_sphere(sheet)
    placed = onto("a plane whose normal points to the patch", PATCH)
    if set(ROUND) & set(given):
        placed.laws = [*round_sizes(given), CIRCLE, PATCH]
    if "solid-angle" not in given:
        any_of(given, "the size of the patch", "area", *ROUND)
        one_of(given, "the distance", "distance")
    placed.use("tilt")
    if "tilt" not in given:
        placed.assume("the patch faces the viewpoint")
    placed.merge(place(sheet, _tilted))
    solved = solve(sheet, placed.laws, placed)
    if solved.has("area") and solved.has("distance"):
        area, away, tilt = solved.value("area"), solved.value("distance"), angle_of(given, "tilt")
        _refuse_near(solved, area, away)
        placed.add("projected-solid-angle", solved.value("solid-angle"))
        if any_true(solved.value("solid-angle") == 0):
            placed.note("the patch is seen from its edge or from behind")
        good = geometry.percent(geometry.error(geometry.size(area), away, tilt))
        placed.assume(f"a patch small compared to its distance: A cos(theta) / d^2 {good}")
    return placed


def _tilted(sheet: Worksheet) -> Placed:
    """Return a solid angle with its unit."""
    placed = Placed()
    placed.add("cosine-of-source", geometry.facing(angle_of(sheet.given, "tilt")))
    return placed


def _on_sphere(sheet: Worksheet) -> Placed:
    """Place a patch of a sphere, seen from the sphere's centre."""
    from radcalc.laws.beams import ON_SPHERE

    given = sheet.given
    any_of(given, "the size of the sphere", *ROUND)
    if foreign := [name for name in given if name not in ("area", *ROUND, "solid-angle")]:
        raise errors.Unused(foreign, "to a patch of a sphere")
    plane = "a plane whose normal points to the patch, taken as a circle"
    placed = onto(plane, *round_sizes(given), ON_SPHERE)
    solved = solve(sheet, placed.laws)
    omega = solved.value("solid-angle")
    if any_true(omega > geometry.FULL * (1 + SLACK)):
        size = format_number(omega / geometry.FULL)
        problem = f"{solved.describe('area')} is {size} times the whole sphere"
        raise errors.ConditionError(problem, f"a smaller {options(['area'])}, or a larger sphere")
    placed.add("projected-solid-angle", geometry.projected_cone(geometry.cone_of(omega)))
    placed.assume("a patch of the sphere, of any shape, seen from its centre")
    return placed


def _refuse_near(solved: Solved, area: Any, away: Any) -> None:
    """Refuse a patch that is too near for A cos(theta) / d^2."""

    size = geometry.size(area)
    if geometry.is_near(away, size):
        tilt = angle_of(solved.given, "tilt")
        hint = geometry.MORE_ROOM
        if not any_true(tilt >= math.pi / 2):  # a disc is seen from its front, above its plane
            is_tilted = any_true(tilt != 0)
            place = {"height": away * cos(tilt), "offset": away * sin(tilt)} if is_tilted else {}
            sizes = {"radius": size / 2, **(place or {"distance": away})}
            disc = {name: f"{format_number(length)}m" for name, length in sizes.items()}
            exact = errors.command("solid-angle", "disc", **disc)
            hint = f"{exact}, exact if the patch is a circle"
        law = "A cos(theta) / d^2"
        raise errors.TooNear(solved.describe("distance"), "source", format_number(size), hint, law)
