"""A surface of one radiance in all directions: its laws, and how each shape is seen."""

import math
from collections.abc import Callable
from typing import Any, NamedTuple

from radcalc.answer import Step
from radcalc.calculators import inputs as i
from radcalc.calculators.worksheet import OVER_TIME, Sheet
from radcalc.conversion.conditions import positive, require, show
from radcalc.errors import ConditionError, UsageError
from radcalc.geometry import projected, solid
from radcalc.laws.law import AnyLaw, Law, Relation
from radcalc.maths import any_true, atan2, cos, hypot, sin, sqrt

LAWS: list[AnyLaw] = [
    Law(
        "Lambertian exitance",
        "{exitance} = pi Omega0 {radiance}",
        "exitance",
        (("radiance", 1),),
        math.pi,
        "sr",
        "ISO 80000-7, radiance and exitance",
    ),
    Law(
        "Lambertian reflector",
        "{exitance} = {reflectance} {incident-irradiance}",
        "exitance",
        (("reflectance", 1), ("incident-irradiance", 1)),
        reference="ISO 80000-7, reflectance",
    ),
    Law(
        "flux of a surface",
        "{flux} = {exitance} {area}",
        "flux",
        (("exitance", 1), ("area", 1)),
        reference="ISO 80000-7, exitance",
    ),
    Law(
        "intensity of a surface",
        "{intensity} = {radiance} {apparent-area}",
        "intensity",
        (("radiance", 1), ("apparent-area", 1)),
        reference="ISO 80000-7, radiance",
    ),
    Law(
        "irradiance of a uniform radiance",
        "{irradiance} = {radiance} {projected-solid-angle}",
        "irradiance",
        (("radiance", 1), ("projected-solid-angle", 1)),
        reference="ISO 80000-7, radiance and irradiance",
    ),
    Law(
        "configuration factor",
        "{configuration-factor} = {projected-solid-angle} / (pi Omega0)",
        "configuration-factor",
        (("projected-solid-angle", 1),),
        1 / math.pi,
        "1/sr",
    ),
    Law(
        "inverse square law, as an estimate",
        "{far-field-irradiance} = {intensity} {cosine-of-source} {cosine} Omega0 / {distance}^2",
        "far-field-irradiance",
        (("intensity", 1), ("cosine-of-source", 1), ("cosine", 1), ("distance", -2)),
        1.0,
        "sr",
    ),
    *OVER_TIME,
]
FLAT = Law("as seen from the front", "{apparent-area} = {area}", "apparent-area", (("area", 1),))
RECTANGLE = Law(
    "area of a rectangle", "{area} = {width} {length}", "area", (("width", 1), ("length", 1))
)
CIRCLE = Law("area of a circle", "{area} = pi {radius}^2", "area", (("radius", 2),), math.pi)

HOWELL = "J. R. Howell, A Catalog of Radiation Heat Transfer Configuration Factors"
SIZES = ("area", "radius", "diameter", "width", "length")
POSITION = ("distance", "height", "offset", "offset-y", "incidence")


def _place(sheet: Sheet, flat: Any, what: str, offset: Any = 0.0) -> None:
    """Enter the exact projected solid angle of a shape, with its step."""
    sheet.know("projected-solid-angle", flat)
    aside = f", {show(offset)} m off its axis" if any_true(offset != 0) else ""
    sheet.placed.append(
        Step(
            "projected solid angle",
            "Omega_p = integral of cos(theta) over the solid angle of the source",
            f"{what}{aside}: Omega_p = {show(flat)} sr",
            HOWELL,
        )
    )


class Shape(NamedTuple):
    """A source's shape: the inputs it takes, and what it adds to the worksheet: its laws."""

    takes: tuple[str, ...]
    place: Callable[..., list[AnyLaw]]
    flags: tuple[str, ...] = ()


def _area_of(sheet: Sheet) -> list[AnyLaw]:
    """The area of a flat source, from whichever of its sizes."""
    given = sheet.given
    laws: list[AnyLaw] = [FLAT]
    if "width" in given or "length" in given:
        laws.append(RECTANGLE)
    if "radius" in given or "diameter" in given:
        laws += _round(sheet)
        laws.append(CIRCLE)
    return laws


def _round(sheet: Sheet) -> list[AnyLaw]:
    """Radius and diameter."""
    if "diameter" in sheet.given:
        return [
            Law("diameter", "{diameter} = 2 {radius}", "diameter", (("radius", 1),), 2.0),
        ]
    return []


def _patch(sheet: Sheet, flags: tuple[str, ...]) -> list[AnyLaw]:
    """A flat source of whatever shape, small where it is seen from a distance."""
    given = sheet.given
    laws = _area_of(sheet)
    placed = [given[name].flag for name in ("incidence", "tilt") if name in given]
    if "distance" not in given and "irradiance" not in sheet.lit.values:
        if placed:
            raise UsageError(f"{placed[0]} has no use without a distance", "--distance 2m with it")
        return laws
    sheet.know("cosine", solid.facing(i.tilt(given, "incidence")))
    sheet.know("cosine-of-source", solid.facing(i.tilt(given)))
    sheet.use("incidence", "tilt")
    if "distance" in given:
        sheet.said.append("a source small beside its distance")
        _say_facing(sheet)
    laws.append(
        Law(
            "small source",
            "{projected-solid-angle} = {area} {cosine-of-source} {cosine} Omega0 / {distance}^2",
            "projected-solid-angle",
            (("area", 1), ("cosine-of-source", 1), ("cosine", 1), ("distance", -2)),
            1.0,
            "sr",
        )
    )
    return laws


def _say_facing(sheet: Sheet) -> None:
    """Say how the receiver is turned, where no incidence tells."""
    sheet.use("incidence")
    if "incidence" not in sheet.given:
        sheet.said.append("the receiver faces the source")


def _height(sheet: Sheet) -> Any:
    """The height above a flat source; on its axis the distance is the same."""
    given = sheet.given
    both = [name for name in ("height", "distance") if name in given]
    if len(both) == 2:
        raise ConditionError("--height and --distance contradict each other", "one of them")
    if not both:
        return None
    if both == ["distance"] and {"offset", "offset-y"} & set(given):
        raise ConditionError(
            "--distance is the straight line to the centre, and off the axis no height",
            "--height in its place",
        )
    return positive(given[both[0]])


def _centre(sheet: Sheet, height: Any, x: Any = 0.0, y: Any = 0.0) -> tuple[Any, Any, Any]:
    """Where the centre is seen: distance, angle from the axis, and the receiver's tilt.

    Without --incidence the receiver faces the source's plane.  With one it is turned by that
    angle from the line to the centre, away from the source's axis: from the centre to facing
    the plane, and on.
    """
    sheet.use("height", "distance", "offset", "offset-y", "incidence")
    lateral = hypot(x, y)
    distance = hypot(height, lateral)
    off = atan2(lateral, height)
    tilt = 0.0
    if "incidence" in sheet.given:
        given = sheet.given["incidence"]
        require(given, not any_true(abs(given.value) > math.pi), "from -180 to 180 deg")
        tilt = off - given.value
        sheet.said.append("the incidence is counted from the line to the centre, off the axis")
    else:
        sheet.said.append("the receiver faces the source's plane")
    sheet.know("cosine", solid.facing(off - tilt))
    sheet.know("cosine-of-source", height / distance)
    if "distance" not in sheet.known:
        sheet.know("distance", distance)
    return distance, off, tilt


def _disc(sheet: Sheet, flags: tuple[str, ...]) -> list[AnyLaw]:
    given = sheet.given
    laws: list[AnyLaw] = [*_round(sheet), CIRCLE, FLAT]
    sized = "radius" in given or "diameter" in given
    height = _height(sheet)
    if sized and height is not None:
        size = i.radius(given)
        sheet.use("radius", "diameter")
        offset = given["offset"].value if "offset" in given else 0.0
        _, _, tilt = _centre(sheet, height, abs(offset))
        flat = projected.disc(size, height, offset, tilt)
        _place(sheet, flat, f"a disc of {show(size)} m radius from {show(height)} m above", offset)
        sheet.know("solid-angle", solid.disc(size, height, offset))
        sheet.know("size", 2 * size)
        return laws
    if "offset" in given or "incidence" in given:
        missing = "--height 75cm" if sized else "--radius 25cm"
        raise UsageError("too little is given beside --offset or --incidence", missing)
    name = "height" if "height" in given else "distance"
    laws.append(
        Relation(
            "disc on its axis",
            f"{{projected-solid-angle}} = pi Omega0 {{radius}}^2 / ({{radius}}^2 + {{{name}}}^2)",
            ("projected-solid-angle", "radius", name),
            {
                "projected-solid-angle": lambda at: projected.disc(at("radius"), at(name)),
                name: lambda at: at("radius") * sqrt(_over(math.pi, at) - 1),
                "radius": lambda at: at(name) / sqrt(_over(math.pi, at) - 1),
            },
            HOWELL,
        )
    )
    return laws


def _over(whole: float, at: Callable[[str], Any]) -> Any:
    """A whole over the projected solid angle, which must be less."""
    part = at("projected-solid-angle")
    solid.refuse(
        part >= whole,
        "more irradiance than the whole hemisphere at that radiance would give",
        "more radiance, or less irradiance",
    )
    return whole / part


def _sphere(sheet: Sheet, flags: tuple[str, ...]) -> list[AnyLaw]:
    given = sheet.given
    laws: list[AnyLaw] = [
        *_round(sheet),
        Law("area of a sphere", "{area} = 4 pi {radius}^2", "area", (("radius", 2),), 4 * math.pi),
        Law(
            "as seen from anywhere",
            "{apparent-area} = pi {radius}^2",
            "apparent-area",
            (("radius", 2),),
            math.pi,
        ),
    ]
    incidence = i.tilt(given, "incidence")
    _say_facing(sheet)
    sheet.know("cosine", solid.facing(incidence))
    sheet.know("cosine-of-source", 1.0)
    if ("radius" in given or "diameter" in given) and "distance" in given:
        size, away = i.radius(given), positive(given["distance"])
        sheet.use("radius", "diameter", "distance", "incidence")
        flat = projected.sphere(size, away, incidence)
        _place(sheet, flat, f"a sphere of {show(size)} m radius from {show(away)} m")
        sheet.know("solid-angle", solid.sphere(size, away))
        sheet.know("size", 2 * size)
        if any_true(incidence + solid.angular_radius(size, away) > math.pi / 2):
            sheet.notes.append("the sphere is partly below the receiver's horizon")
        return laws
    if "incidence" in given:
        raise UsageError("--incidence has no use without --radius and --distance", "both of them")
    laws.append(
        Relation(
            "sphere, its centre at a distance",
            "{projected-solid-angle} = pi Omega0 ({radius} / {distance})^2",
            ("projected-solid-angle", "radius", "distance"),
            {
                "projected-solid-angle": lambda at: projected.sphere(at("radius"), at("distance")),
                "distance": lambda at: at("radius") * sqrt(_over(math.pi, at)),
                "radius": lambda at: at("distance") / sqrt(_over(math.pi, at)),
            },
            HOWELL,
        )
    )
    laws.append(  # all its flux goes through the sphere of that distance
        Law(
            "flux of a sphere at a distance",
            "{flux} = 4 pi {distance}^2 {irradiance}",
            "flux",
            (("distance", 2), ("irradiance", 1)),
            4 * math.pi,
        )
    )
    return laws


def _rectangle(sheet: Sheet, flags: tuple[str, ...]) -> list[AnyLaw]:
    given = sheet.given
    laws: list[AnyLaw] = [FLAT, RECTANGLE]
    height = _height(sheet)
    if height is None:
        useless = [f"--{flag}" for flag in flags]
        useless += [given[n].flag for n in ("offset", "offset-y", "incidence") if n in given]
        if useless:
            raise UsageError(f"{useless[0]} has no use without a height", "--height 1.5m with it")
        return laws
    for name in ("width", "length"):
        i.one_of(given, f"the {name} of the rectangle", name)
    width, length = positive(given["width"]), positive(given["length"])
    sheet.use("width", "length", "height", "distance", "offset", "offset-y")
    x, y = (given[name].value if name in given else 0.0 for name in ("offset", "offset-y"))
    if "corner" in flags:
        if {"offset", "offset-y", "distance"} & set(given):
            raise ConditionError("--corner, with --height, already says where", "one of them")
        x, y = width / 2, length / 2
        sheet.said.append("below a corner of the rectangle")
    if "perpendicular" in flags:
        if "incidence" in given:
            raise ConditionError("--perpendicular and --incidence contradict each other", "one")
        toward = 1.0 - 2.0 * (y > 0)
        normal: Any = (0.0, toward, 0.0)
        distance = hypot(height, hypot(x, y))
        sheet.know("cosine", abs(y) / distance)
        sheet.know("cosine-of-source", height / distance)
        sheet.know("distance", distance)
        sheet.said.append("the receiver's normal runs along the rectangle's length")
    else:
        _, _, tilt = _centre(sheet, height, x, y)
        lateral = hypot(x, y)
        over = 1.0 * (lateral == 0)  # above the centre it is turned along the width
        away = (-x / (lateral + over) - over, -y / (lateral + over))
        normal = (sin(tilt) * away[0], sin(tilt) * away[1], cos(tilt))
        if "incidence" in given and any_true(lateral == 0):
            sheet.said.append("the receiver is turned along the width")
    flat = projected.rectangle(width, length, height, x, y, normal)
    _place(sheet, flat, f"a rectangle of {show(width)} m x {show(length)} m", x)
    sheet.know("solid-angle", solid.rectangle(width, length, height, x, y))
    sheet.know("size", hypot(width, length))
    return laws


def _plane(sheet: Sheet, flags: tuple[str, ...]) -> list[AnyLaw]:
    """An endless plane: half of all directions, whatever its distance."""
    sheet.use("incidence")
    sheet.know(
        "projected-solid-angle", projected.cone(math.pi / 2, i.tilt(sheet.given, "incidence"))
    )
    sheet.know("solid-angle", solid.HEMISPHERE)
    sheet.said.append("an endless plane, seen under the same light from any distance")
    return []


def _hemisphere(sheet: Sheet, flags: tuple[str, ...]) -> list[AnyLaw]:
    """The sky, or the part of it in a cone about the zenith."""
    given = sheet.given
    sheet.use("half-angle")
    _say_facing(sheet)
    half = i.half_angle(given["half-angle"], 90) if "half-angle" in given else math.pi / 2
    _place(sheet, projected.cone(half, i.tilt(given, "incidence")), "the sky")
    sheet.know("solid-angle", solid.cone(half))
    part = "a cone of it" if "half-angle" in given else "all of it"
    sheet.said.append(f"a hemisphere of one radiance, {part}")
    return []


SHAPES = {
    "patch": Shape((*SIZES, "distance", "incidence", "tilt"), _patch),
    "disc": Shape(("radius", "diameter", "distance", "height", "offset", "incidence"), _disc),
    "sphere": Shape(("radius", "diameter", "distance", "incidence"), _sphere),
    "rectangle": Shape(("width", "length", *POSITION), _rectangle, ("corner", "perpendicular")),
    "plane": Shape(("incidence",), _plane),
    "hemisphere": Shape(("half-angle", "incidence"), _hemisphere),
}
