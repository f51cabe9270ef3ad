"""Shapes of a Lambertian source: their laws, and the values that follow from their position."""

import math
from collections.abc import Callable
from functools import reduce
from typing import Any

from radcalc import geometry
from radcalc.answer import Formula, format_number
from radcalc.calculators.worksheet import (
    OFFSETS,
    Placed,
    Worksheet,
    facing,
    refuse_slant_for_height,
)
from radcalc.errors import Exclusive, HorizonCuts, MissingInput, add, leave_out, mention, option
from radcalc.geometry import solid
from radcalc.inputs import Inputs, angle_of, any_of, half_angle_of, offset_of, one_of, radius_of
from radcalc.laws import (
    CIRCLE,
    CONE,
    HOWELL,
    OFFSET,
    PROJECTED_CONE,
    RECTANGLE,
    AnyLaw,
    round_sizes,
)
from radcalc.laws.solver import reached
from radcalc.laws.surface import (
    CUT_DISC,
    DISC_ASIDE,
    DISC_FLUX_ASIDE,
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
from radcalc.maths import any_true, atan2, cos, hypot, larger, piecewise, sin, smaller, sqrt
from radcalc.tuples import NamedTuple

SIZES = ("area", "radius", "diameter", "width", "length")
POSITION = ("distance", "height", *OFFSETS, "incidence")
PROJECTED_SOLID_ANGLE = Formula(
    "projected solid angle",
    "{projected-solid-angle} = integral of cos(theta) over the solid angle of the source",
    HOWELL,
)


class Shape(NamedTuple):
    """A shape of a source: its inputs, and a function from inputs to values and laws."""

    takes: tuple[str, ...]
    place: Callable[[Worksheet], Placed]


# What a remark on the place of a receiver, or on its turn, is on.
ON_RECEIVER = ("irradiance", "exposure", "projected-solid-angle", "cosine", "cosine-of-source")


class Seen(Placed):
    """Values and laws of a shape, seen by a receiver."""

    def __init__(self, given: Inputs, *laws: AnyLaw) -> None:
        super().__init__(*laws)
        self.given = given

    def project(self, flat: Any, shape: str, offset: Any = 0.0) -> None:
        self.add("projected-solid-angle", flat)
        where = f", {format_number(offset)} m off its axis" if any_true(offset != 0) else ""
        numbers = f"{shape}{where}: Omega_p = {format_number(flat)} sr"
        self.steps.append(PROJECTED_SOLID_ANGLE.with_numbers(numbers))

    def note_horizon(self, shape: str, lowest: Any, highest: Any) -> None:
        """Note a shape between two heights that is partly or wholly below the horizon."""
        if any_true(lowest < -1e-12 * abs(highest)):
            cut = "partly " if any_true(highest > 1e-12 * abs(lowest)) else ""
            self.note(f"the {shape} is {cut}below the receiver's horizon")

    def face(self) -> None:
        """Assume that the receiver faces the source, unless an incidence is given."""
        self.use("incidence")
        if "incidence" not in self.given:
            self.assume("the receiver faces the source", of=ON_RECEIVER)

    def centre(self, height: Any, lateral: Any, tilt: Any) -> None:
        """Add the position of the source's centre, seen by a receiver with this tilt."""
        self.use(*POSITION)
        if "incidence" in self.given:
            self.assume(
                "the incidence is measured from the line to the centre, away from the axis",
                of=ON_RECEIVER,
            )
        else:
            self.assume("the receiver faces the source's plane", of=ON_RECEIVER)
        distance = hypot(height, lateral)
        self.add("cosine", geometry.facing(atan2(lateral, height) - tilt))
        self.add("cosine-of-source", height / distance)
        if "distance" not in self.given or "height" in self.given:
            self.add("distance", distance)

    def stand_aside(self) -> None:
        """Add the laws of a disc off its axis with an unknown length."""
        self.assume("the receiver faces the source's plane", of=ON_RECEIVER)
        self.laws += [DISC_ASIDE, OFFSET]


def _is_sized(given: Inputs, *more: str) -> bool:
    return not {"radius", "diameter", *more}.isdisjoint(given)


def _radius(given: Inputs, circles: int = 1) -> Any:
    """Return the radius of a disc, or of a sphere with the area of 4 circles."""
    size = any_of(given, "the size of the source", "radius", "diameter", "area")
    return sqrt(size.value / (circles * math.pi)) if size.name == "area" else radius_of(size)


def _tilt(given: Inputs, height: Any, lateral: Any) -> Any:
    """Return the angle between the receiver's normal and that of the source's plane [rad].

    Without an incidence it faces the plane.  With one it is turned by that angle from the line to
    the centre, away from the source's axis: from the centre to facing the plane, and on.
    """
    if "incidence" not in given:
        return 0.0
    tilt = atan2(lateral, height) - given["incidence"].value
    return piecewise(tilt > math.pi, lambda t: t - 2 * math.pi, lambda t: t, tilt)


def _patch(sheet: Worksheet) -> Placed:
    """Place a flat source of any shape; at a distance it must be small."""
    given = sheet.given
    placed = Seen(given, FLAT, *_without_size(given, FLAT_FLUX))
    if "width" in given or "length" in given:
        placed.laws.append(RECTANGLE)
    if _is_sized(given):
        placed.laws += [*round_sizes(given), CIRCLE]
    if {"height", *OFFSETS} & set(given):
        _patch_above(placed)
    elif "distance" in given or {"irradiance", "exposure"} & set(sheet.lit.values):
        _patch_toward(placed)
    else:
        turned = [name for name in ("incidence", "tilt") if name in given]
        if turned:
            message = f"{option(turned[0])} does not apply without a distance"
            ways = [leave_out(*turned), add("distance", "2m")]
            raise MissingInput(message, mention("add {distance=2m}"), ways)
    return placed


def _patch_above(placed: Seen) -> None:
    """Place a small flat source by the height of the receiver, on or off its axis."""
    given = placed.given
    height = _height(given)
    if "height" not in given:
        raise _without_height(next(name for name in OFFSETS if name in given))
    lateral = hypot(offset_of(given), offset_of(given, "offset-y"))
    placed.centre(height, lateral, _tilt(given, height, lateral))
    if "tilt" in given:
        placed.compare(given["tilt"], atan2(lateral, height))
    placed.laws += _small(given)


def _patch_toward(placed: Seen) -> None:
    """Place a small flat source by its distance and the angles at both ends."""
    given = placed.given
    incidence, tilt = angle_of(given, "incidence"), angle_of(given, "tilt")
    placed.add("cosine", geometry.facing(incidence))
    placed.add("cosine-of-source", geometry.facing(tilt))
    placed.use("incidence", "tilt")
    placed.assume(*facing(given))
    if "distance" in given and any_true(_is_cut(given, given["distance"].value)):
        if not _is_sized(given) or any_true(tilt != 0):
            raise cut_by_horizon(given, _reach(given), given["distance"].value)
        placed.add("incidence", incidence, given["incidence"])
        placed.assume("a disc, partly cut by the horizon", of=ON_RECEIVER)
        placed.laws.append(CUT_DISC)
    else:
        placed.laws += _small(given)


def _small(given: Inputs) -> list[AnyLaw]:
    return [SMALL_SOURCE, *_without_size(given, SMALL_SOURCE_INTENSITY, SMALL_SOURCE_ENERGY)]


def _without_height(name: str) -> MissingInput:
    message = f"{option(name)} does not apply without a height"
    return MissingInput(message, mention("add {height=1.5m}"))


def _without_size(given: Inputs, *laws: AnyLaw) -> tuple[AnyLaw, ...]:
    return () if set(SIZES) & set(given) else laws


def _is_cut(given: Inputs, distance: Any) -> Any:
    """Return whether the receiver's horizon may cut a patch of the known size."""
    reach = _reach(given)
    angle = angle_of(given, "incidence")
    return reach is not None and geometry.is_cut(reach, distance, angle)


def _reach(given: Inputs) -> Any:
    """Return the greatest distance of a patch's points from its centre; None without a size."""
    if size := given.get("radius") or given.get("diameter"):
        return radius_of(size)
    sides = [given[name].value for name in ("width", "length") if name in given]
    if "area" in given:
        return geometry.reach(given["area"].value, *sides)
    return geometry.reach(math.prod(sides), *sides) if len(sides) == 2 else None


def cut_by_horizon(given: Inputs, reach: Any, distance: Any) -> HorizonCuts:
    """Return the error for a patch that the receiver's horizon may cut."""
    least = geometry.steepest(reach, distance)
    return HorizonCuts("incidence", given["incidence"].text, least)


def _height(given: Inputs) -> Any:
    """Return the height above a flat source, which may be given as the distance, or None."""
    given_names = [name for name in ("height", "distance") if name in given]
    if not given_names:
        return None
    if given_names == ["distance"] and set(OFFSETS) & set(given):
        refuse_slant_for_height(given["distance"])
    return given[given_names[0]].value


def _disc(sheet: Worksheet) -> Placed:
    """Place a disc: seen from a known position, or by laws if its size or position is unknown."""
    given = sheet.given
    placed = Seen(given, *round_sizes(given), CIRCLE, FLAT, *_without_size(given, FLAT_FLUX))
    height = _height(given)
    if _is_sized(given, "area") and height is not None:
        _disc_seen(placed, height)
        return placed
    if "incidence" in given:
        missing = mention("{height=75cm}" if _is_sized(given, "area") else "{radius=25cm}")
        raise MissingInput(mention("{incidence} alone is not enough"), missing)
    if "offset" in given:
        placed.add("lateral", abs(offset_of(given)), given["offset"])
        placed.stand_aside()
        placed.laws.append(DISC_FLUX_ASIDE)
        return placed
    if "irradiance" in sheet.lit.values:
        placed.assume("the receiver is on the disc's axis and faces it", of=ON_RECEIVER)
    away = "height" if "height" in given else "distance"
    placed.laws += [disc_on_axis(away), disc_flux(away)]
    return placed


def _disc_seen(placed: Seen, height: Any) -> None:
    placed.use("radius", "diameter")
    size, offset = _radius(placed.given), offset_of(placed.given)
    tilt = _tilt(placed.given, height, abs(offset))
    placed.centre(height, abs(offset), tilt)
    flat = solid.projected_disc(size, height, offset, tilt)
    shape = f"a disc of {format_number(size)} m radius from {format_number(height)} m above"
    placed.project(flat, shape, offset)
    centre, half = sin(tilt) * abs(offset) + cos(tilt) * height, abs(sin(tilt)) * size
    placed.note_horizon("disc", centre - half, centre + half)
    placed.add("solid-angle", solid.disc(size, height, offset))
    placed.add("extent", 2 * size)


def _disc_off_axis(sheet: Worksheet) -> Placed:
    """Place a receiver off the disc's axis, at the offset that the irradiance gives."""
    placed = Seen(sheet.given, *round_sizes(sheet.given), CIRCLE, FLAT)
    placed.assume(
        "the receiver is off the disc's axis, at the offset that the light gives", of=ON_RECEIVER
    )
    placed.stand_aside()
    return placed


def _sphere(sheet: Worksheet) -> Placed:
    """Place a sphere: seen from a known distance, or by laws if its size or distance is unknown."""
    given = sheet.given
    without_size = _without_size(given, SPHERE_INTENSITY)
    placed = Seen(given, *round_sizes(given), SPHERE_AREA, SPHERE_FRONT, *without_size)
    incidence = angle_of(given, "incidence")
    placed.face()
    placed.add("cosine", geometry.facing(incidence))
    placed.add("cosine-of-source", 1.0)
    if _is_sized(given, "area") and "distance" in given:
        size, away = _radius(given, 4), given["distance"].value
        placed.use("radius", "diameter", "distance")
        flat = solid.projected_sphere(size, away, incidence)
        shape = f"a sphere of {format_number(size)} m radius from {format_number(away)} m"
        placed.project(flat, shape)
        placed.add("solid-angle", solid.sphere(size, away))
        placed.add("extent", 2 * size)
        within = solid.angular_radius(size, away)
        up = math.pi / 2 - incidence
        placed.note_horizon("sphere", up - within, up + within)
        return placed
    if "incidence" in given:
        message = mention("{incidence} does not apply without {radius} and {distance}")
        raise MissingInput(message, "both of them")
    placed.laws += [SPHERE_AT_DISTANCE, SPHERE_FLUX, SPHERE_ENERGY]
    return placed


def _rectangle(sheet: Worksheet) -> Placed:
    """Place a rectangle: seen from a known position, or on its axis if a length is unknown."""
    given = sheet.given
    placed = Seen(given, FLAT, *_without_size(given, FLAT_FLUX), RECTANGLE)
    height = _height(given)
    elsewhere = [
        name for name in ("corner", "perpendicular", *OFFSETS, "incidence") if name in given
    ]
    if height is None:
        if elsewhere:
            raise _without_height(elsewhere[0])
        if {"irradiance", "exposure"} & set(sheet.lit.values):
            placed.assume("the receiver is on the rectangle's axis and faces it", of=ON_RECEIVER)
        placed.laws.append(rectangle_on_axis("height"))
    elif not elsewhere and _lacks_side(sheet):
        placed.assume("the receiver is on the rectangle's axis and faces it", of=ON_RECEIVER)
        placed.laws.append(rectangle_on_axis("height" if "height" in given else "distance"))
    else:
        _rectangle_seen(placed, height)
    return placed


def _lacks_side(sheet: Worksheet) -> bool:
    """Return whether one side of a rectangle is given and the light gives the other."""
    sides = [name for name in ("width", "length", "area") if name in sheet.given]
    return len(sides) == 1 and "projected-solid-angle" in reached(LAWS, {*sheet.known})


def _rectangle_seen(placed: Seen, height: Any) -> None:
    """Add the exact solid angles of a rectangle of known size, seen from a known position."""
    given = placed.given
    width, length = _sides(given)
    placed.use("width", "length", *POSITION)
    x, y = offset_of(given), offset_of(given, "offset-y")
    if "corner" in given:
        x, y = placed.corner(given, width, length)
        placed.assume("below a corner of the rectangle", of=ON_RECEIVER)
    normal = (_sideways if "perpendicular" in given else _upward)(placed, height, x, y)
    heights = [
        normal[0] * (i * width / 2 - x) + normal[1] * (j * length / 2 - y) + normal[2] * height
        for i in (-1, 1)
        for j in (-1, 1)
    ]
    placed.note_horizon("rectangle", reduce(smaller, heights), reduce(larger, heights))
    flat = solid.projected_rectangle(width, length, height, x, y, normal)
    shape = f"a rectangle of {format_number(width)} m x {format_number(length)} m"
    placed.project(flat, shape, x)
    placed.add("solid-angle", solid.rectangle(width, length, height, x, y))
    placed.add("extent", hypot(width, length))


def _sides(given: Inputs) -> tuple[Any, Any]:
    """Return the width and the length of a rectangle; one may follow from the area."""
    names = ["width", "length"]
    lacking = [name for name in names if name not in given]
    if len(lacking) == 1 and "area" in given:
        (other,) = {*names} - {*lacking}
        sides = {other: given[other].value, lacking[0]: given["area"].value / given[other].value}
        return sides["width"], sides["length"]
    width, length = (one_of(given, f"the {name} of the rectangle", name).value for name in names)
    return width, length


def _upward(placed: Seen, height: Any, x: Any, y: Any) -> Any:
    """Place a receiver that faces a rectangle's plane or is turned; return its normal."""
    lateral = hypot(x, y)
    tilt = _tilt(placed.given, height, lateral)
    placed.centre(height, lateral, tilt)
    over = 1.0 * (lateral == 0)  # above the centre the receiver is turned along the width
    away = (-x / (lateral + over) - over, -y / (lateral + over))
    if "incidence" in placed.given and any_true(lateral == 0):
        placed.assume("the receiver is turned along the width", of=ON_RECEIVER)
    return sin(tilt) * away[0], sin(tilt) * away[1], cos(tilt)


def _sideways(placed: Seen, height: Any, x: Any, y: Any) -> Any:
    """Place an upright receiver that faces along a rectangle's length; return its normal."""
    if "incidence" in placed.given:
        raise Exclusive(("perpendicular", "incidence"), hint="one")
    distance = hypot(height, hypot(x, y))
    placed.add("cosine", abs(y) / distance)
    placed.add("cosine-of-source", height / distance)
    placed.add("distance", distance)
    placed.assume("the receiver's normal is parallel to the rectangle's length", of=ON_RECEIVER)
    return 0.0, 1.0 - 2.0 * (y > 0), 0.0


def _plane(sheet: Worksheet) -> Placed:
    """Place an infinite plane: half of all directions at any distance."""
    placed = Placed()
    placed.use("incidence")
    tilt = angle_of(sheet.given, "incidence")
    placed.add("projected-solid-angle", solid.projected_cone(math.pi / 2, tilt))
    placed.add("solid-angle", geometry.HEMISPHERE)
    placed.assume("an infinite plane: the same light at any distance")
    return placed


def _hemisphere(sheet: Worksheet) -> Placed:
    """Place a uniform sky, or a cone of it around the zenith."""
    given, placed = sheet.given, Seen(sheet.given)
    placed.use("half-angle")
    placed.face()
    half = half_angle_of(given["half-angle"], 90) if "half-angle" in given else math.pi / 2
    placed.project(solid.projected_cone(half, angle_of(given, "incidence")), "the sky")
    placed.add("solid-angle", geometry.cone(half))
    part = "a cone of it" if "half-angle" in given else "all of it"
    placed.assume(f"a hemisphere of one radiance, {part}")
    return placed


def _part_of_hemisphere(sheet: Worksheet) -> Placed:
    """Place a luminous cone of a hemisphere, whose half angle the irradiance gives."""
    placed = Seen(sheet.given, PROJECTED_CONE, CONE)
    placed.face()
    placed.assume(
        "only a cone around the zenith is luminous; its half angle follows from the irradiance"
    )
    return placed


SHAPES = {
    "patch": Shape((*SIZES, *POSITION, "tilt"), _patch),
    "disc": Shape(
        ("radius", "diameter", "area", "distance", "height", "offset", "incidence"), _disc
    ),
    "sphere": Shape(("radius", "diameter", "area", "distance", "incidence"), _sphere),
    "rectangle": Shape(
        ("width", "length", "area", *POSITION, "corner", "perpendicular"), _rectangle
    ),
    "plane": Shape(("incidence",), _plane),
    "hemisphere": Shape(("half-angle", "incidence"), _hemisphere),
}
# Other positions of a shape, tried if the light contradicts the usual one and none of these
# inputs is given.
OTHERWISE = {
    "disc": (("distance", "offset", "incidence"), _disc_off_axis),
    "hemisphere": (("half-angle", "incidence"), _part_of_hemisphere),
}
