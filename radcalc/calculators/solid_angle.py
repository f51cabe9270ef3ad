"""The solid angle of a shape, and what goes with it: one small function a shape."""

import math
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

from radcalc.answer import Answer, Step, Value
from radcalc.calculators import inputs as i
from radcalc.calculators.inputs import Inputs
from radcalc.conversion import geometric
from radcalc.conversion.conditions import ANGLE, degrees, positive, require, show
from radcalc.errors import ConditionError, NumberError, UsageError
from radcalc.geometry import projected, solid
from radcalc.quantities.light import SOLID_ANGLE
from radcalc.units.table import NUMBER

Point = tuple[float, float, float]
LEAST = 1e-300  # below it a float has fewer digits


class Seen(NamedTuple):
    """A shape as it is seen: solid angle, projected solid angle [sr], onto which plane.

    `half_angle` [rad] where the shape is a cone; `found` are other results.
    """

    solid: Any
    projected: Any
    onto: str
    steps: Sequence[Step]
    half_angle: Any = None
    found: Sequence[Value] = ()
    assumptions: Sequence[str] = ()
    notes: Sequence[str] = ()


class Shape(NamedTuple):
    """A shape: the inputs it takes, how it is seen, and what else it takes that is no quantity."""

    takes: tuple[str, ...]
    see: Callable[..., Seen]
    also: tuple[str, ...] = ()


def solid_angle(shape: str, given: Inputs, others: dict[str, Any] | None = None) -> Answer:
    """The solid angle of a shape of `SHAPES`, with all that follows from it.

    `given` are its inputs, `others` what is no quantity: intervals (polar, azimuth), points
    (points, viewpoint, normal) and corner.
    """
    named = "all directions" if shape == "full" else f"a {shape}"
    others = others or {}
    i.only(given, SHAPES[shape].takes, named)
    i.refuse_unused([f"--{n}" for n in others if n not in SHAPES[shape].also], named)
    seen = SHAPES[shape].see(given, **{name: others.get(name) for name in SHAPES[shape].also})
    if not seen.notes and min(seen.solid, seen.projected) < LEAST:
        raise NumberError("the solid angle is too small for a number", "less extreme sizes")
    half = solid.cone_of(seen.solid) if seen.half_angle is None else seen.half_angle
    values = [
        Value("solid-angle", "solid angle", "Ω", seen.solid, (SOLID_ANGLE,), ("sr", "deg2")),
        Value(
            "projected-solid-angle",
            "projected solid angle",
            "Ω_p",
            seen.projected,
            (SOLID_ANGLE,),
            ("sr",),
        ),
        Value(
            "sphere-fraction",
            "fraction of the sphere",
            "Ω/4π",
            seen.solid / solid.FULL,
            (NUMBER,),
            ("1",),
        ),
        Value("half-angle", "half angle of the equal cone", "α", half, (ANGLE,), ("deg",)),
        Value("apex-angle", "apex angle of the equal cone", "2α", 2 * half, (ANGLE,), ("deg",)),
    ]
    for name, one in given.items():
        row = i.known(one)
        same = [k for k, value in enumerate(values) if value.name == name]
        if same:
            own = values[same[0]].units if len(values[same[0]].units) > 1 else ()
            row.units += tuple(unit for unit in own if unit not in row.units)
            values[same[0]] = row
        else:
            values.append(row)
    values += seen.found
    assumptions = [f"projected onto {seen.onto}", *seen.assumptions]
    return values, assumptions, list(seen.notes), list(seen.steps)


def _step(law: str, formula: str, numbers: str, omega: float, reference: str = "") -> Step:
    return Step(law, formula, f"Omega = {numbers} = {show(omega)} sr", reference)


def _full(given: Inputs) -> Seen:
    step = _step("all directions", "Omega = 4 pi Omega0", "4 pi sr", solid.FULL)
    note = "a surface faces one half of the sphere: its projected solid angle is pi"
    plane = "a plane of any normal, from its front"
    return Seen(solid.FULL, math.pi, plane, (step,), math.pi, notes=(note,))


def _hemisphere(given: Inputs) -> Seen:
    steps = (
        _step("hemisphere", "Omega = 2 pi Omega0", "2 pi sr", solid.HEMISPHERE),
        Step("projected", "Omega_p = pi Omega0", "Omega_p = pi sr"),
    )
    plane = "the hemisphere's own plane"
    return Seen(solid.HEMISPHERE, projected.HEMISPHERE, plane, steps, math.pi / 2)


def _cone(given: Inputs) -> Seen:
    one = i.one_of(
        given,
        "the size of the cone",
        "half-angle",
        "apex-angle",
        "solid-angle",
        "projected-solid-angle",
    )
    name, size = one.option.name, positive(one)
    if name == "solid-angle":
        require(one, size <= solid.FULL * (1 + solid.SLACK), "at most 4pi sr")
        half = solid.cone_of(size)
    elif name == "projected-solid-angle":
        require(one, size <= math.pi * (1 + solid.SLACK), "at most pi sr, a hemisphere")
        half = math.asin(min(1.0, math.sqrt(size / math.pi)))
    else:
        half = i.half_angle(one)
    return _as_cone(half, "a plane whose normal is the cone's axis")


def _as_cone(half: float, onto: str, *before: Step, **others: Any) -> Seen:
    """What is seen under a cone of a half angle [rad], facing it."""
    omega, flat = solid.cone(half), projected.cone(half)
    notes: tuple[str, ...] = ()
    if half > math.pi / 2:
        notes = ("what is behind that plane does not count: a hemisphere is left",)
    steps = (
        *before,
        _step(
            "solid angle of a cone",
            "Omega = 4 pi sin^2(alpha/2) Omega0",
            f"4 pi sin^2({degrees(half)}/2) sr",
            omega,
            "ISO 80000-3, solid angle",
        ),
        Step(
            "projected solid angle of a cone",
            "Omega_p = pi sin^2(alpha) Omega0",
            f"Omega_p = pi sin^2({degrees(min(half, math.pi / 2))}) sr = {show(flat)} sr",
            "ISO 80000-7, radiance and irradiance",
        ),
    )
    return Seen(omega, flat, onto, steps, half, notes=notes, **others)


def _zone(
    given: Inputs, polar: tuple[float, float] | None, azimuth: tuple[float, float] | None
) -> Seen:
    if polar is None:
        raise UsageError("the polar angles of the zone are missing", "--polar 30deg:60deg")
    width = azimuth[1] - azimuth[0] if azimuth else 2 * math.pi
    omega, flat = solid.zone(*polar, width), projected.zone(*polar, width)
    low, high = map(degrees, polar)
    notes = []
    if polar[1] > math.pi / 2 * (1 + solid.SLACK):
        notes = ["what is below that plane, past 90 deg, does not count"]
    steps = (
        _step(
            "zone of a sphere",
            "Omega = 2 dphi sin((t0 + t1)/2) sin((t1 - t0)/2) Omega0",
            f"2 ({show(width)}) sin(({low} + {high})/2) sin(({high} - {low})/2) sr",
            omega,
        ),
        Step(
            "projected zone",
            "Omega_p = dphi (sin^2(t1) - sin^2(t0)) / 2 Omega0",
            f"Omega_p = {show(flat)} sr",
        ),
    )
    around = f"azimuths from {_span(azimuth)} deg" if azimuth else "all azimuths"
    said = (f"polar angles from {_span(polar)} deg, {around}",)
    return Seen(omega, flat, "a plane whose normal is +z", steps, assumptions=said, notes=notes)


def _span(interval: tuple[float, float]) -> str:
    return " to ".join(show(math.degrees(end)) for end in interval)


def _sphere(given: Inputs) -> Seen:
    sized = "radius" in given or "diameter" in given
    size = i.radius(given) if sized else None
    away = positive(given["distance"]) if "distance" in given else None
    filled = positive(given["solid-angle"]) if "solid-angle" in given else None
    if [size, away, filled].count(None) != 1:
        several = (
            "too much is given" if None not in (size, away, filled) else "something is missing"
        )
        raise UsageError(f"{several}: a sphere takes two", "--radius, --distance, --solid-angle")
    found = []
    if size is None:
        size = solid.sphere_radius(away, filled)
        found = [i.value("radius", size, i.unit_of(given["distance"]))]
    elif away is None:
        away = solid.sphere_distance(size, filled)
        unit = i.unit_of(given["radius" if "radius" in given else "diameter"])
        found = [i.value("distance", away, unit)]
    half = solid.angular_radius(size, away)
    step = Step(
        "sphere, its centre at a distance",
        "sin(alpha) = R / d",
        f"sin(alpha) = {show(size)} m / {show(away)} m, alpha = {degrees(half)}",
    )
    plane = "a plane whose normal points to the sphere's centre"
    return _as_cone(half, plane, step, found=found)


def _above(given: Inputs, corner: bool = False) -> Any:
    """The height above a flat shape; on its axis, the distance is the same."""
    one = i.one_of(given, "the height above the source", "height", "distance")
    if one.option.name == "distance" and (corner or {"offset", "offset-y"} & set(given)):
        raise ConditionError(
            "--distance is the straight line to the centre, and off the axis no height",
            "--height in its place",
        )
    return positive(one)


def _offset(given: Inputs, name: str) -> Any:
    return given[name].value if name in given else 0.0


def _disc(given: Inputs) -> Seen:
    size, height, offset = i.radius(given), _above(given), _offset(given, "offset")
    omega = solid.disc(size, height, offset)
    flat = projected.disc(size, height, offset)
    if offset:
        formula = "Omega = closed integral over the rim, complete elliptic"
        numbers = f"R = {show(size)} m, h = {show(height)} m, x = {show(offset)} m; Omega"
        reference = "F. Paxton, Rev. Sci. Instrum. 30 (1959) 254"
        step = Step("disc off its axis", formula, f"{numbers} = {show(omega)} sr", reference)
    else:
        step = _step(
            "disc on its axis",
            "Omega = 2 pi (1 - h / sqrt(h^2 + R^2)) Omega0",
            f"2 pi (1 - {show(height)} m / sqrt(({show(height)} m)^2 + ({show(size)} m)^2)) sr",
            omega,
        )
    more = Step(
        "projected disc",
        "Omega_p = pi/2 (1 - (h^2 + x^2 - R^2) / sqrt((h^2 + x^2 + R^2)^2 - 4 R^2 x^2)) Omega0",
        f"Omega_p = {show(flat)} sr",
        "J. R. Howell, A Catalog of Radiation Heat Transfer Configuration Factors",
    )
    return Seen(omega, flat, FACING, (step, more))


FACING = "a plane parallel to the source's (the receiver faces it)"


def _rectangle(given: Inputs, corner: bool | None) -> Seen:
    for name in ("width", "length"):
        i.one_of(given, f"the {name} of the rectangle", name)
    width, length = positive(given["width"]), positive(given["length"])
    x, y = _offset(given, "offset"), _offset(given, "offset-y")
    height = _above(given, bool(corner))
    if corner:
        if {"offset", "offset-y"} & set(given):
            raise ConditionError("--corner and --offset contradict each other", "one of them")
        x, y = width / 2, length / 2
    omega = solid.rectangle(width, length, height, x, y)
    flat = projected.rectangle(width, length, height, x, y)
    at = f"w = {show(width)} m, l = {show(length)} m, h = {show(height)} m"
    steps = (
        Step(
            "rectangle, as two triangles",
            "tan(Omega/2) = [a b c] / (a b c + (a.b) c + (a.c) b + (b.c) a), each",
            f"{at}, offsets {show(x)} m and {show(y)} m; Omega = {show(omega)} sr",
            "A. van Oosterom, J. Strackee, IEEE Trans. Biomed. Eng. 30 (1983) 125",
        ),
        _contour(flat),
    )
    said = ("seen from above a corner",) if corner else ()
    return Seen(omega, flat, FACING, steps, assumptions=said)


def _contour(flat: float) -> Step:
    return Step(
        "Lambert's contour formula",
        "Omega_p = 1/2 sum of beta cos(delta), over the sides",
        f"Omega_p = {show(flat)} sr",
        "J. H. Lambert, Photometria (1760)",
    )


def _pyramid(given: Inputs) -> Seen:
    for name in ("horizontal", "vertical"):
        i.one_of(given, f"the {name} angle", name)
    a, b = positive(given["horizontal"]), positive(given["vertical"])
    omega, flat = solid.pyramid(a, b), projected.pyramid(a, b)
    step = _step(
        "rectangular pyramid",
        "Omega = 4 arcsin(sin(a/2) sin(b/2)) Omega0",
        f"4 arcsin(sin({degrees(a)}/2) sin({degrees(b)}/2)) sr",
        omega,
    )
    said = ("the angles are full ones, from face to face through the axis",)
    plane = "a plane whose normal is the pyramid's axis"
    return Seen(omega, flat, plane, (step, _contour(flat)), assumptions=said)


def _patch(given: Inputs) -> Seen:
    area = geometric.area(i.one_of(given, "the size of the patch", "area", "radius", "diameter"))
    away = i.one_of(given, "the distance", "distance")
    tilt = i.tilt(given)
    omega = solid.patch(area.value, positive(away), tilt)
    geometric.far_field(
        area, away, "radcalc solid-angle disc or rectangle, which are exact", "A cos(theta) / d^2"
    )
    notes = []
    if omega == 0:
        notes = ["the patch is seen from its edge or from behind"]
    step = _step(
        "small patch",
        "Omega = A cos(theta) / d^2 Omega0",
        f"{show(area.value)} m2 cos({degrees(tilt)}) / ({show(away.value)} m)^2 sr",
        omega,
    )
    more = 0.75 * area.value / math.pi / away.value**2
    said = (
        f"a patch small beside its distance (a disc facing it fills {show(100 * more)} % less)",
    )
    plane = "a plane whose normal points to the patch"
    steps = (*area.steps, step)
    return Seen(omega, omega, plane, steps, assumptions=said, notes=notes)


def _polygon(
    given: Inputs, points: Sequence[Point], viewpoint: Point | None, normal: Point | None
) -> Seen:
    from radcalc.geometry import outline

    flat_shape = outline.read(points, viewpoint or (0.0, 0.0, 0.0))
    omega = abs(solid.polygon(flat_shape.vertices))
    facing = normal or flat_shape.normal
    flat = projected.polygon(flat_shape.vertices, facing)
    notes = list(flat_shape.notes)
    if normal and flat_shape.dips_below(normal):
        notes.append("what is below the horizon of --normal is cut away")
    step = Step(
        "polygon, as triangles",
        "tan(Omega/2) = [a b c] / (a b c + (a.b) c + (a.c) b + (b.c) a), each",
        f"{len(points)} vertices; Omega = {show(omega)} sr",
        "A. van Oosterom, J. Strackee, IEEE Trans. Biomed. Eng. 30 (1983) 125",
    )
    plane = "a plane parallel to the polygon's"
    if normal:
        plane = f"a plane whose normal is {','.join(map(show, normal))}"
    seen_from = ",".join(map(show, viewpoint or (0.0, 0.0, 0.0)))
    said = (f"a polygon of {len(points)} vertices, seen from {seen_from}",)
    return Seen(omega, flat, plane, (step, _contour(flat)), assumptions=said, notes=notes)


SIZE = ("radius", "diameter")
SHAPES = {
    "full": Shape((), _full),
    "hemisphere": Shape((), _hemisphere),
    "cone": Shape(("half-angle", "apex-angle", "solid-angle", "projected-solid-angle"), _cone),
    "zone": Shape((), _zone, ("polar", "azimuth")),
    "sphere": Shape((*SIZE, "distance", "solid-angle"), _sphere),
    "disc": Shape((*SIZE, "distance", "height", "offset"), _disc),
    "rectangle": Shape(
        ("width", "length", "distance", "height", "offset", "offset-y"), _rectangle, ("corner",)
    ),
    "pyramid": Shape(("horizontal", "vertical"), _pyramid),
    "patch": Shape(("area", *SIZE, "distance", "tilt"), _patch),
    "polygon": Shape((), _polygon, ("points", "viewpoint", "normal")),
}
ALIASES = {"band": "zone", "triangle": "polygon"}
