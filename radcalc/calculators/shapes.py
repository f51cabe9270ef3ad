"""How each shape of a Lambertian source is seen: what it adds to the worksheet, and its laws."""

import math
from collections.abc import Callable
from functools import reduce
from typing import Any, NamedTuple

from radcalc.calculators.worksheet import (
    OFFSETS,
    Worksheet,
    refuse_slant_for_height,
)
from radcalc.derivation import Formula, format_number
from radcalc.errors import (
    ConditionError,
    Exclusive,
    HorizonCuts,
    MissingInput,
    mention,
    option,
)
from radcalc.geometry import cones, far_field, projected, solid, spheres
from radcalc.given import Inputs, angle_of, half_angle_of, offset_of, one_of, radius_of
from radcalc.laws.cones import CONE, PROJECTED_CONE
from radcalc.laws.law import HOWELL, AnyLaw
from radcalc.laws.sizes import CIRCLE, OFFSET, RECTANGLE, round_sizes
from radcalc.laws.solver import reached
from radcalc.laws.surface import (
    CUT_DISC,
    DISC_ASIDE,
    FLAT,
    FLAT_FLUX,
    LAWS,
    SMALL_SOURCE,
    SMALL_SOURCE_ENERGY,
    SMALL_SOURCE_INTENSITY,
    SPHERE_AREA,
    SPHERE_AT_DISTANCE,
    SPHERE_ENERGY,
    SPHERE_FLUX,
    SPHERE_FRONT,
    SPHERE_INTENSITY,
    disc_flux,
    disc_on_axis,
    rectangle_on_axis,
)
from radcalc.maths import any_true, atan2, cos, hypot, larger, piecewise, sin, smaller

SIZES = ("area", "radius", "diameter", "width", "length")
POSITION = ("distance", "height", *OFFSETS, "incidence")
PROJECTED_SOLID_ANGLE = Formula(
    "projected solid angle",
    "{projected-solid-angle} = integral of cos(theta) over the solid angle of the source",
    HOWELL,
)


class Shape(NamedTuple):
    """A source's shape: the inputs it takes, and what it adds to the worksheet: its laws."""

    takes: tuple[str, ...]
    place: Callable[[Worksheet], list[AnyLaw]]


def _place(sheet: Worksheet, flat: Any, what: str, offset: Any = 0.0) -> None:
    """Enter the exact projected solid angle of a shape, with its step."""
    sheet.know("projected-solid-angle", flat)
    aside = f", {format_number(offset)} m off its axis" if any_true(offset != 0) else ""
    sheet.placed.append(
        PROJECTED_SOLID_ANGLE.told(f"{what}{aside}: Omega_p = {format_number(flat)} sr")
    )


def _say_horizon(sheet: Worksheet, shape: str, lowest: Any, highest: Any) -> None:
    """Say what is cut of a shape, by how high it reaches over the receiver's plane."""
    if any_true(lowest < -1e-12 * abs(highest)):
        cut = "partly " if any_true(highest > 1e-12 * abs(lowest)) else ""
        sheet.notes.append(f"the {shape} is {cut}below the receiver's horizon")


def _is_sized(sheet: Worksheet) -> bool:
    """Whether the radius is known."""
    return "radius" in sheet.given or "diameter" in sheet.given


def _radius(sheet: Worksheet) -> Any:
    """The radius, given as such or as the diameter, which is used with it."""
    sheet.use("radius", "diameter")
    return radius_of(one_of(sheet.given, "the size of the source", "radius", "diameter"))


def _patch(sheet: Worksheet) -> list[AnyLaw]:
    """A flat source of whatever shape, small where it is seen from a distance."""
    given = sheet.given
    laws: list[AnyLaw] = [FLAT, *_without_size(sheet, FLAT_FLUX)]
    if "width" in given or "length" in given:
        laws.append(RECTANGLE)
    if _is_sized(sheet):
        laws += [*round_sizes(sheet.given), CIRCLE]
    if {"height", *OFFSETS} & set(given):
        return [*laws, *_patch_above(sheet)]
    placed = [name for name in ("incidence", "tilt") if name in given]
    if "distance" not in given and "irradiance" not in sheet.lit.values:
        if placed:
            message = f"{option(placed[0])} has no use without a distance"
            raise MissingInput(message, mention("{distance=2m} with it"))
        return laws
    incidence, tilt = angle_of(given, "incidence"), angle_of(given, "tilt")
    sheet.know("cosine", cones.facing(incidence))
    sheet.know("cosine-of-source", cones.facing(tilt))
    sheet.use("incidence", "tilt")
    _say_facing(sheet)
    if "distance" in given and any_true(_is_cut(sheet, given["distance"].value)):
        if not _is_sized(sheet) or any_true(tilt != 0):
            raise cut_by_horizon(given, _reach(given), given["distance"].value)
        sheet.know("incidence", incidence, given["incidence"])
        sheet.assume("a disc that faces the receiver, of which the horizon leaves a part")
        return [*laws, CUT_DISC]
    return [*laws, *_small(sheet)]


def _patch_above(sheet: Worksheet) -> list[AnyLaw]:
    """A small flat source by the height of the receiver, on its axis or aside of it."""
    given = sheet.given
    height = _height(sheet)
    if "height" not in given:
        raise _without_height(next(name for name in OFFSETS if name in given))
    if "tilt" in given:
        raise Exclusive(("tilt", "height"), "contradict each other: both say how it is turned")
    _centre(sheet, height, offset_of(given), offset_of(given, "offset-y"))
    return _small(sheet)


def _small(sheet: Worksheet) -> list[AnyLaw]:
    """The laws of a source that is small beside its distance."""
    return [SMALL_SOURCE, *_without_size(sheet, SMALL_SOURCE_INTENSITY, SMALL_SOURCE_ENERGY)]


def _without_height(name: str) -> MissingInput:
    """The refusal of what tells where a receiver is that has no height."""
    message = f"{option(name)} has no use without a height"
    return MissingInput(message, mention("{height=1.5m} with it"))


def _without_size(sheet: Worksheet, *laws: AnyLaw) -> tuple[AnyLaw, ...]:
    """The laws that lead past a size, where none is given."""
    return () if set(SIZES) & set(sheet.given) else laws


def _is_cut(sheet: Worksheet, distance: Any) -> Any:
    """Whether the receiver's horizon may cut a patch, as far as its size is known."""
    reach = _reach(sheet.given)
    angle = angle_of(sheet.given, "incidence")
    return reach is not None and far_field.is_cut(reach, distance, angle)


def _reach(given: Inputs) -> Any:
    """How far a patch reaches from its centre, or None where its size is not given."""
    if size := given.get("radius") or given.get("diameter"):
        return radius_of(size)
    sides = [given[name].value for name in ("width", "length") if name in given]
    if "area" in given:
        return far_field.reach(given["area"].value, *sides)
    return far_field.reach(math.prod(sides), *sides) if len(sides) == 2 else None


def cut_by_horizon(given: Inputs, reach: Any, distance: Any) -> HorizonCuts:
    """The refusal of a patch of which the receiver's horizon may cut off a part."""
    least = far_field.steepest(reach, distance)
    return HorizonCuts("incidence", given["incidence"].text, least)


def _say_facing(sheet: Worksheet) -> None:
    """Say how the receiver is turned, where no incidence tells."""
    sheet.use("incidence")
    if "incidence" not in sheet.given:
        sheet.assume("the receiver faces the source")


def _height(sheet: Worksheet) -> Any:
    """The height above a flat source; on its axis the distance is the same."""
    given = sheet.given
    both = [name for name in ("height", "distance") if name in given]
    if len(both) == 2:
        raise Exclusive(both)
    if not both:
        return None
    if both == ["distance"] and set(OFFSETS) & set(given):
        refuse_slant_for_height()
    return given[both[0]].value


def _centre(sheet: Worksheet, height: Any, x: Any = 0.0, y: Any = 0.0) -> tuple[Any, Any, Any]:
    """Where the centre is seen: distance, angle from the axis, and the receiver's tilt.

    Without an incidence the receiver faces the source's plane.  With one it is turned by that
    angle from the line to the centre, away from the source's axis: from the centre to facing
    the plane, and on.
    """
    sheet.use(*POSITION)
    lateral = hypot(x, y)
    distance = hypot(height, lateral)
    off = atan2(lateral, height)
    tilt = 0.0
    if "incidence" in sheet.given:
        tilt = off - sheet.given["incidence"].value
        tilt = piecewise(tilt > math.pi, lambda t: t - 2 * math.pi, lambda t: t, tilt)
        sheet.assume("the incidence is counted from the line to the centre, off the axis")
    else:
        sheet.assume("the receiver faces the source's plane")
    sheet.know("cosine", cones.facing(off - tilt))
    sheet.know("cosine-of-source", height / distance)
    if "distance" not in sheet.known:
        sheet.know("distance", distance)
    return distance, off, tilt


def _disc(sheet: Worksheet) -> list[AnyLaw]:
    laws: list[AnyLaw] = [*round_sizes(sheet.given), CIRCLE, FLAT, *_without_size(sheet, FLAT_FLUX)]
    height = _height(sheet)
    if _is_sized(sheet) and height is not None:
        size = _radius(sheet)
        offset = offset_of(sheet.given)
        _, _, tilt = _centre(sheet, height, abs(offset))
        flat = projected.disc(size, height, offset, tilt)
        shown = f"a disc of {format_number(size)} m radius from {format_number(height)} m above"
        _place(sheet, flat, shown, offset)
        centre, half = sin(tilt) * abs(offset) + cos(tilt) * height, abs(sin(tilt)) * size
        _say_horizon(sheet, "disc", centre - half, centre + half)
        sheet.know("solid-angle", solid.disc(size, height, offset))
        sheet.know("extent", 2 * size)
        return laws
    if "incidence" in sheet.given:
        missing = mention("{height=75cm}" if _is_sized(sheet) else "{radius=25cm}")
        raise MissingInput(mention("too little is given beside {incidence}"), missing)
    if "offset" in sheet.given:
        sheet.know("lateral", abs(offset_of(sheet.given)), sheet.given["offset"])
        return [*laws, *_disc_aside(sheet)]
    if "irradiance" in sheet.lit.values:
        sheet.assume("the receiver is on the disc's axis and faces it")
    away = "height" if "height" in sheet.given else "distance"
    return [*laws, disc_on_axis(away), disc_flux(away)]


def _disc_aside(sheet: Worksheet) -> list[AnyLaw]:
    """The laws of a disc off its axis, of which a length is looked for."""
    sheet.assume("the receiver faces the source's plane")
    return [DISC_ASIDE, OFFSET]


def _disc_off_axis(sheet: Worksheet) -> list[AnyLaw]:
    """The laws of a disc where the offset is looked for, which is not on the axis."""
    sheet.assume("the receiver is as far off the disc's axis as the light tells")
    return [*round_sizes(sheet.given), CIRCLE, FLAT, *_disc_aside(sheet)]


def _sphere(sheet: Worksheet) -> list[AnyLaw]:
    given = sheet.given
    laws: list[AnyLaw] = [
        *round_sizes(given),
        SPHERE_AREA,
        SPHERE_FRONT,
        *_without_size(sheet, SPHERE_INTENSITY),
    ]
    incidence = angle_of(given, "incidence")
    _say_facing(sheet)
    sheet.know("cosine", cones.facing(incidence))
    sheet.know("cosine-of-source", 1.0)
    if _is_sized(sheet) and "distance" in given:
        size, away = _radius(sheet), given["distance"].value
        sheet.use("distance")
        flat = projected.sphere(size, away, incidence)
        shown = f"a sphere of {format_number(size)} m radius from {format_number(away)} m"
        _place(sheet, flat, shown)
        sheet.know("solid-angle", spheres.solid_angle(size, away))
        sheet.know("extent", 2 * size)
        within = spheres.angular_radius(size, away)
        up = math.pi / 2 - incidence
        _say_horizon(sheet, "sphere", up - within, up + within)
        return laws
    if "incidence" in given:
        message = mention("{incidence} has no use without {radius} and {distance}")
        raise MissingInput(message, "both of them")
    return [*laws, SPHERE_AT_DISTANCE, SPHERE_FLUX, SPHERE_ENERGY]


def _rectangle(sheet: Worksheet) -> list[AnyLaw]:
    given = sheet.given
    laws: list[AnyLaw] = [FLAT, *_without_size(sheet, FLAT_FLUX), RECTANGLE]
    height = _height(sheet)
    if height is None:
        for name in ("corner", "perpendicular", *OFFSETS, "incidence"):
            if name in given:
                raise _without_height(name)
        if {"irradiance", "exposure"} & set(sheet.lit.values):
            sheet.assume("the receiver is on the rectangle's axis and faces it")
        return [*laws, rectangle_on_axis("height")]
    sides = [name for name in ("width", "length") if name in given]
    elsewhere = {"corner", "perpendicular", *OFFSETS, "incidence"} & set(given)
    if (
        len(sides) == 1
        and not elsewhere
        and "projected-solid-angle" in reached(LAWS, {*sheet.known})
    ):
        sheet.assume("the receiver is on the rectangle's axis and faces it")
        return [*laws, rectangle_on_axis("height" if "height" in given else "distance")]
    for name in ("width", "length"):
        one_of(given, f"the {name} of the rectangle", name)
    width, length = given["width"].value, given["length"].value
    sheet.use("width", "length", *POSITION)
    x, y = offset_of(given), offset_of(given, "offset-y")
    if "corner" in given:
        x, y = _corner(sheet.given)
        sheet.assume("below a corner of the rectangle")
    if "perpendicular" in given:
        normal = _sideways(sheet, height, x, y)
    else:
        _, _, tilt = _centre(sheet, height, x, y)
        lateral = hypot(x, y)
        over = 1.0 * (lateral == 0)  # above the centre it is turned along the width
        away = (-x / (lateral + over) - over, -y / (lateral + over))
        normal = (sin(tilt) * away[0], sin(tilt) * away[1], cos(tilt))
        if "incidence" in given and any_true(lateral == 0):
            sheet.assume("the receiver is turned along the width")
    heights = [
        normal[0] * (i * width / 2 - x) + normal[1] * (j * length / 2 - y) + normal[2] * height
        for i in (-1, 1)
        for j in (-1, 1)
    ]
    _say_horizon(sheet, "rectangle", reduce(smaller, heights), reduce(larger, heights))
    flat = projected.rectangle(width, length, height, x, y, normal)
    _place(sheet, flat, f"a rectangle of {format_number(width)} m x {format_number(length)} m", x)
    sheet.know("solid-angle", solid.rectangle(width, length, height, x, y))
    sheet.know("extent", hypot(width, length))
    return laws


def _corner(given: Inputs) -> tuple[Any, Any]:
    """How far aside a corner of a rectangle is, which no offset and no distance can tell."""
    if {*OFFSETS, "distance"} & set(given):
        message = mention("{corner}, with {height}, already says where")
        raise ConditionError(message, "one of them")
    return given["width"].value / 2, given["length"].value / 2


def _sideways(sheet: Worksheet, height: Any, x: Any, y: Any) -> Any:
    """The normal of a receiver that stands upright, along the length, and where it is."""
    if "incidence" in sheet.given:
        raise Exclusive(("perpendicular", "incidence"), hint="one")
    distance = hypot(height, hypot(x, y))
    sheet.know("cosine", abs(y) / distance)
    sheet.know("cosine-of-source", height / distance)
    sheet.know("distance", distance)
    sheet.assume("the receiver's normal runs along the rectangle's length")
    return 0.0, 1.0 - 2.0 * (y > 0), 0.0


def _plane(sheet: Worksheet) -> list[AnyLaw]:
    """An endless plane: half of all directions, whatever its distance."""
    sheet.use("incidence")
    tilt = angle_of(sheet.given, "incidence")
    sheet.know("projected-solid-angle", projected.cone(math.pi / 2, tilt))
    sheet.know("solid-angle", cones.HEMISPHERE)
    sheet.assume("an endless plane, seen under the same light from any distance")
    return []


def _hemisphere(sheet: Worksheet) -> list[AnyLaw]:
    """The sky, or the part of it in a cone about the zenith."""
    given = sheet.given
    sheet.use("half-angle")
    _say_facing(sheet)
    half = half_angle_of(given["half-angle"], 90) if "half-angle" in given else math.pi / 2
    _place(sheet, projected.cone(half, angle_of(given, "incidence")), "the sky")
    sheet.know("solid-angle", cones.cone(half))
    part = "a cone of it" if "half-angle" in given else "all of it"
    sheet.assume(f"a hemisphere of one radiance, {part}")
    return []


def _part_of_hemisphere(sheet: Worksheet) -> list[AnyLaw]:
    """The laws of a hemisphere of which no more shines than the light tells."""
    _say_facing(sheet)
    sheet.assume("a hemisphere shines as far from its zenith as the light tells")
    return [PROJECTED_CONE, CONE]


SHAPES = {
    "patch": Shape((*SIZES, *POSITION, "tilt"), _patch),
    "disc": Shape(("radius", "diameter", "distance", "height", "offset", "incidence"), _disc),
    "sphere": Shape(("radius", "diameter", "distance", "incidence"), _sphere),
    "rectangle": Shape(("width", "length", *POSITION, "corner", "perpendicular"), _rectangle),
    "plane": Shape(("incidence",), _plane),
    "hemisphere": Shape(("half-angle", "incidence"), _hemisphere),
}
# Where the light contradicts what goes without saying of a shape, unless one of these is given:
# what is looked for in its place.
OTHERWISE = {
    "disc": (("distance", "offset", "incidence"), _disc_off_axis),
    "hemisphere": (("half-angle", "incidence"), _part_of_hemisphere),
}
