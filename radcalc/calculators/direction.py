"""A direction or its reflection, in spherical coordinates and as a unit vector."""

import math
from collections.abc import Sequence
from typing import Any

from radcalc import errors
from radcalc.answer import (
    Answer,
    Formula,
    Remark,
    Step,
    Value,
    format_angle,
    format_number,
    texts_of,
)
from radcalc.calculators.page import Operand, Page
from radcalc.calculators.results import known, value
from radcalc.calculators.solved import Task, Wants, solve
from radcalc.calculators.worksheet import Placed, Worksheet, place, refuse_foreign, worksheet
from radcalc.errors import option, quote
from radcalc.geometry import projections
from radcalc.geometry.projections import direction_at, is_outside, length, place_of, unit
from radcalc.inputs import Input, Inputs, any_of, one_of
from radcalc.inputs.places import read_coordinates
from radcalc.maths import SLACK, Number, any_true, atan2, cos, hypot, piecewise, sin, sqrt
from radcalc.quantities.symbols import MIRROR_BALL
from radcalc.units import NUMBER
from radcalc.units.amounts import split_value
from radcalc.units.dimensions import ANGLE, LENGTH
from radcalc.units.table import unit_of

ANGLES, MIRRORS = ("polar", "elevation", "azimuth"), ("reflect-at", "reflect-to")
ON_BALL = ("mirror-ball-u", "mirror-ball-v", "mirror-ball-w")
PAGE = Page(
    results=(
        "x",
        "y",
        "z",
        "length",
        "mirror-ball-u",
        "mirror-ball-v",
        "mirror-ball-w",
        "incidence",
    ),
    about="Express a direction, or its reflection, in spherical coordinates and as a unit vector.",
    operand=Operand("vector", "[X Y Z]"),
    sections={"Angles": ANGLES, "Mirrors": ("mirror-ball", *MIRRORS)},
    examples=(
        "1 1 1",
        "3m 4m 0m get=length:cm get=azimuth:deg",
        "polar=45deg azimuth=30deg",
        "elevation=10deg:80deg:10deg azimuth=0deg get=z",
        "mirror-ball=0.6,0",
        "0.96 0 0.28 get=mirror-ball-u get=mirror-ball-v",
        "polar=30deg azimuth=0deg reflect-at=0,0,1",
        "0 0 1 reflect-to=1,0,0                (the mirror's normal)",
    ),
    remarks="The polar angle is measured from +z, the azimuth from +x towards +y; the elevation "
    "is 90 degrees minus the polar angle. At a mirror, both directions point away from it: one "
    "towards the source of the light, one along the reflected light. A mirror ball is seen along "
    "-z from far away, with x to the right and y up. The results mirror-ball-u and mirror-ball-v, "
    "shown on request, are the point on the ball that shows a direction; with mirror-ball-w they "
    "are the ball's normal at that point.",
    mistakes=("direction",),
)

CONVENTION = "polar angle from +z, azimuth from +x towards +y (ISO 80000-2)"
UNIT = "x, y and z are the unit vector"
AWAY = "the direction d and its reflection r point away from the mirror"
BALL_AXES = (
    "a mirror ball seen along -z, from far away: x to the right, y up, z towards the camera; "
    "u, v and w are x, y and z of its normal there"
)
POLAR = Formula("polar angle", "theta = atan2(sqrt(x^2 + y^2), z)")
AZIMUTH = Formula("azimuth", "phi = atan2(y, x)")
UNIT_VECTOR = Formula(
    "unit vector", "x = sin(theta) cos(phi), y = sin(theta) sin(phi), z = cos(theta)"
)
REFLECTION = Formula("reflection", "r = 2 (n.d) / (n.n) n - d")
BISECTOR = Formula("normal of the mirror", "n = d/|d| + r/|r|, divided by its length")
BALL = Formula("mirror ball", "(x, y, z) = (2 u w, 2 v w, 2 w^2 - 1), w = sqrt(1 - u^2 - v^2)")
POLE = "at a pole the azimuth is arbitrary"
LEAST = 2**-53  # a smaller coordinate of a unit vector is a rounded 0


def task(words: Sequence[str], wants: Wants) -> Task:
    """Return the task of a call, with or without the coordinates of a vector."""
    coordinates = words[0].split(",") if len(words) == 1 else list(words)
    vector, unit = _read(coordinates) if words else (None, "")
    with_ball = any(map(wants, ON_BALL))

    def work_out(given: Inputs) -> Answer:
        names = [name for name in given if name not in MIRRORS]
        if vector and names:
            what = option("mirror-ball") if "mirror-ball" in names else "angles"
            without = errors.call("direction", **{name: item.text for name, item in given.items()})
            problem = f"a vector cannot be used with {what}"
            raise errors.ConditionError(problem, [errors.leave_out(*names), without])
        if not vector and not names:
            texts = {name: item.text for name, item in given.items()}
            by_angles = errors.Try((("polar", ""), ("azimuth", "")))
            ways = [errors.call("direction", "1", "1", "1", **texts), by_angles]
            raise errors.UsageError("a direction is missing", ways)
        return direction(given, vector, unit, with_ball)

    return Task("direction", work_out, texts_of({"vector": ",".join(coordinates)}))


def _read(coordinates: list[str]) -> tuple[projections.Vector, str]:
    if len(coordinates) != 3:
        problem = f"a vector has three coordinates, not {len(coordinates)}"
        raise errors.UsageError(
            problem, _of_two(coordinates) or errors.call("direction", "1", "1", "1")
        )
    (x, y, z), unit = read_coordinates(coordinates)
    return (x, y, z), unit


def _of_two(words: list[str]) -> list[errors.Try]:
    """Propose the direction of two angles, or of a vector in a plane."""
    units = [unit_of(split_value(word)[1]) for word in words]
    if len(words) == 2 and not any(split_value(word)[1] for word in words):
        flat = errors.call("direction", *words, "0", remark="in the plane of x and y")
        return [errors.computed(flat)]
    if len(words) != 2 or any(unit is None or unit.dimension != ANGLE for unit in units):
        return []
    first, second = words
    return [
        errors.call("direction", polar=first, azimuth=second),
        errors.call("direction", azimuth=first, elevation=second),
    ]


def direction(
    given: Inputs, vector: projections.Vector | None = None, unit: str = "", with_ball: bool = False
) -> Answer:
    """Return the answer for a direction given by coordinates, angles or a mirror ball.

    `given` are the angles or the place on the ball, and a mirror; a `vector` is in SI units if
    its coordinates have a `unit`.  `with_ball` adds the place on a mirror ball that shows the
    resulting direction.
    """
    refuse_foreign(given, (*ANGLES, *MIRRORS, "mirror-ball"), "a direction")
    if "mirror-ball" in given:
        for name in (*ANGLES, *MIRRORS):
            if name in given:
                raise errors.Exclusive(("mirror-ball", name))
        return _of_ball(given["mirror-ball"])
    if all(name in given for name in MIRRORS):
        raise errors.Exclusive(MIRRORS)
    if any(name in given for name in MIRRORS):
        answer = _reflect(given, vector, unit)
    elif vector:
        answer = of_vector(*vector, unit)
    else:
        answer = of_angles(given)
    answer = answer._replace(notes=(*answer.notes, *_compare(given)))
    return _on_ball(answer) if with_ball else answer


def _compare(given: Inputs) -> list[str]:
    """Refuse a polar angle and an elevation that contradict each other; return notes."""
    page = Page("a direction", ("polar", "elevation"))
    both = {name: given[name] for name in page.takes if name in given}
    if len(both) < 2:
        return []
    sheet = worksheet(page, both, with_light=False)
    return solve(sheet, [], place(sheet, _polar_of_elevation)).notes


def _polar_of_elevation(sheet: Worksheet) -> Placed:
    placed = Placed()
    placed.add("polar", math.pi / 2 - sheet.given["elevation"].value)
    return placed


def of_vector(x: Number, y: Number, z: Number, unit: str = "") -> Answer:
    """Return the direction of a vector; its coordinates are in SI units if they have a unit."""
    polar, azimuth, length = projections.spherical(x, y, z)
    unit_vector = (x / length, y / length, z / length)
    notes = [f"{POLE}; 0 is shown"] if any_true(_is_at_pole(x, y)) else []
    from_axis, far = format_number(hypot(x, y)), format_number(z)
    steps = [
        POLAR.with_numbers(f"theta = atan2({from_axis}, {far}) = {format_angle(polar)}"),
        AZIMUTH.with_numbers(
            f"phi = atan2({format_number(y)}, {format_number(x)}) = {format_angle(azimuth)}"
        ),
    ]
    rows = [*_rows(polar, azimuth, unit_vector, {}), _length(length, unit)]
    return Answer(rows, [CONVENTION, Remark(UNIT, "xyz")], notes, steps)


def of_angles(given: Inputs) -> Answer:
    """Return the unit vector of a polar angle or an elevation, and an azimuth."""
    polar, azimuth, vector, step = _from_angles(given)
    rows = [*_rows(polar, azimuth, vector, given), _length(1.0)]
    notes = [POLE] if any_true(_is_at_pole(*vector[:2])) else []
    return Answer(rows, [CONVENTION], notes, [step])


def _is_at_pole(x: Number, y: Number) -> Any:
    return (x == 0) & (y == 0)


def _from_angles(given: Inputs) -> tuple[Number, Number, projections.Vector, Step]:
    given_angle = any_of(given, "the polar angle or the elevation", "polar", "elevation")
    azimuth = one_of(given, "the azimuth", "azimuth").value
    polar = given_angle.value if given_angle.name == "polar" else math.pi / 2 - given_angle.value
    x, y, z = projections.cartesian(polar, azimuth)
    if given_angle.name == "elevation":
        z = sin(given_angle.value)  # avoids the rounding error of a right angle
        x, y = cos(given_angle.value) * cos(azimuth), cos(given_angle.value) * sin(azimuth)
    x, y, z = _without_rounding((x, y, z), LEAST)
    numbers = f"theta = {format_angle(polar)}, phi = {format_angle(azimuth)}; "
    numbers += f"x = {format_number(x)}, y = {format_number(y)}, z = {format_number(z)}"
    return polar, azimuth, (x, y, z), UNIT_VECTOR.with_numbers(numbers)


def _without_rounding(vector: projections.Vector, least: Number) -> projections.Vector:

    def rounded(size: Number) -> Number:
        return piecewise(abs(size) < least, lambda s: 0.0 * abs(s), lambda s: s, size)

    x, y, z = map(rounded, vector)
    return x, y, z


def _reflect(given: Inputs, vector: projections.Vector | None, unit: str) -> Answer:
    """Return the reflection of a direction, or the normal of the mirror that reflects it."""
    steps = []
    if vector is None:
        *_, vector, step = _from_angles(given)
        steps.append(step)
    size = projections.spherical(*vector)[2]
    numbers = f"d = {_format_vector(vector)}"
    if "reflect-at" in given:
        normal = given["reflect-at"].value
        incidence = _angle(vector, normal)
        _refuse_behind(given["reflect-at"], incidence)
        result = _without_rounding(projections.reflected(vector, normal), 4 * LEAST * size)
        numbers += f", n = {_format_vector(normal)}; r = {_format_vector(result)}"
        steps.append(REFLECTION.with_numbers(numbers))
        assumption = "the results are those of the reflection"
    else:
        to = given["reflect-to"].value
        result, unit = _without_rounding(projections.mirror_normal(vector, to), 4 * LEAST), ""
        incidence = _angle(vector, result)
        steps.append(
            BISECTOR.with_numbers(
                f"{numbers}, r = {_format_vector(to)}; n = {_format_vector(result)}"
            )
        )
        assumption = "the results are those of the mirror's normal"
    answer = of_vector(*result, unit=unit)
    return answer._replace(
        values=[*answer.values, value("incidence", incidence)],
        assumptions=[*answer.assumptions, f"{AWAY}; {assumption}"],
        steps=[*steps, *answer.steps],
    )


def _angle(first: projections.Vector, second: projections.Vector) -> Number:
    """Return the angle between two vectors, to all digits."""
    a, b = unit(first), unit(second)
    return atan2(length(projections.cross(a, b)), projections.dot(a, b))


def _refuse_behind(normal: Input, incidence: Number) -> None:
    if any_true(incidence > math.pi / 2 * (1 + SLACK)):
        turned = ",".join(format_number(-component, 15) for component in normal.value)
        raise errors.ConditionError(
            f"{option('reflect-at', quote(normal.text))}: the direction is behind the mirror, "
            f"{format_angle(incidence)} from its normal",
            f"{option('reflect-at', turned)} for its other side",
        )


def _format_vector(vector: projections.Vector) -> str:
    return f"({', '.join(map(format_number, vector))})"


def _of_ball(place: Input) -> Answer:
    """Return the direction that a place on the mirror ball shows; refuse a place outside it."""
    u, v = place.value
    if is_outside(MIRROR_BALL, u, v):
        ratio = format_number(hypot(u, v))
        raise errors.ConditionError(
            f"{option('mirror-ball', quote(place.text))} is outside the ball, {ratio} times its "
            "radius from the middle",
            "u and v with u^2 + v^2 of at most 1",
        )
    z, x, y = direction_at(MIRROR_BALL, u, v)  # returns x towards the camera
    answer = _on_ball(of_vector(x, y, z), (u, v))
    w = next(row.si for row in answer.values if row.name == "mirror-ball-w")
    numbers = f"u = {format_number(u)}, v = {format_number(v)}, w = {format_number(w)}; "
    step = BALL.with_numbers(f"{numbers}(x, y, z) = {_format_vector((x, y, z))}")
    notes = ["the rim of the ball shows the direction behind it"] if w == 0 else []
    return answer._replace(
        assumptions=[CONVENTION, BALL_AXES],
        notes=[*notes, *answer.notes],
        steps=[step, *answer.steps],
    )


def _on_ball(answer: Answer, given: tuple[float, float] | None = None) -> Answer:
    """Return the answer with the place on the mirror ball that shows its direction."""
    coordinates = {item.name: item.si for item in answer.values}
    x, y, z = (coordinates[name] for name in "xyz")
    u, v = given or place_of(MIRROR_BALL, z, x, y)
    # sqrt((1 + z) / 2), without cancellation for z near -1
    w = piecewise(
        z > 0,
        lambda across, z: sqrt((1 + z) / 2),
        lambda across, z: across / sqrt(2 * (1 - z)),
        hypot(x, y),
        z,
    )
    rows = [value(name, size) for name, size in zip(ON_BALL, (u, v, w), strict=True)]
    if given:
        rows[:2] = [row._replace(given=row.si) for row in rows[:2]]
    return answer._replace(
        values=[*answer.values, *rows],
        assumptions=[*answer.assumptions, Remark(BALL_AXES, [*ON_BALL])],
    )


def _length(length: Any, unit: str = "") -> Value:
    dimension = LENGTH if unit else NUMBER
    row = value("length", length, unit or "1", letter="r")
    return row._replace(dimensions=(dimension,))


def _rows(polar: Any, azimuth: Any, vector: projections.Vector, given: Inputs) -> list[Value]:
    """Return the angles, as given where they are inputs, and the unit vector."""
    x, y, z = vector
    angles = {"polar": polar, "azimuth": azimuth, "elevation": atan2(z, hypot(x, y))}
    rows = [
        known(given[name]) if name in given else value(name, angle)
        for name, angle in angles.items()
    ]
    rows += [value(name, size, label=name) for name, size in zip("xyz", vector, strict=True)]
    return rows
