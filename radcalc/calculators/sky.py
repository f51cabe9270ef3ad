"""The light of the sky and the sun: from a direction, on the ground, on a plane.

Quadrature gives the sky's luminance relative to the zenith and its integrals for the ground and
the plane, which the laws use.
"""

import math
from typing import TYPE_CHECKING

from radcalc import errors
from radcalc.answer import Answer, Step, format_angle, format_number, format_value
from radcalc.calculators.kinds import kind_of
from radcalc.calculators.page import Operand, Page, text
from radcalc.calculators.results import absent
from radcalc.calculators.solved import Solved, solve
from radcalc.calculators.worksheet import Placed, Worksheet, place, worksheet
from radcalc.errors import option
from radcalc.geometry.models import (
    IS_EVEN,
    MISSING_AZIMUTH,
    MISSING_SUN,
    NAMES,
    angle_between,
    projected_sky,
    relative_luminance,
    sky_type,
)
from radcalc.geometry.projections import UP, USUAL_SIZE, Vector, cartesian, dot, unit
from radcalc.inputs import Inputs
from radcalc.inputs.places import require_azimuth
from radcalc.laws import AnyLaw
from radcalc.laws.surface import (
    BOTH,
    DIFFUSE,
    DIRECT,
    DISC,
    GLOBAL,
    GROUND,
    HORIZONTAL_SKY,
    LINEAR,
    LUMINANCE,
    PLANE,
    PLANE_SKY,
    RELATIVE,
    SHARE,
    SUN_COSINE,
    TOWARD,
)
from radcalc.maths import Number, any_true, cos, each, sin
from radcalc.quantities import symbols
from radcalc.units.table import resolve

if TYPE_CHECKING:
    from radcalc.calculators.solved import RenderedMap
    from radcalc.distributions.maps.pictures import Picture

SUN_RADIUS = math.radians(0.2666)  # at its mean distance
OF_SUN = ("sun-irradiance", "sun-radiance", "global-irradiance")
OF_PLACE = ("sun-elevation", "sun-azimuth", "sun-radius")
ANGLES = ("sun-elevation", "sun-azimuth", "toward", "normal", "tilt", "azimuth")
# What a remark on the sky is on: the ground, a plane, and a direction.
ON_SKY = ("horizontal-sky", "plane-sky", "relative-radiance")
LEAST = 1e-15  # a smaller cosine is a rounded 0


LAWS: list[AnyLaw] = [GROUND, TOWARD, SHARE, PLANE, DIFFUSE, DIRECT, BOTH, GLOBAL, DISC]
LIGHT = (
    "radiance-toward",
    "zenith-radiance",
    "horizontal-irradiance",
    "global-irradiance",
    "irradiance",
    "diffuse-irradiance",
    "direct-irradiance",
    "sun-irradiance",
    "sun-radiance",
)
SHARED = "daylight-share"
OPERAND = Operand("type", "[TYPE]", symbols.CHOICE, NAMES, "overcast")
PAGE = Page(
    "a sky",
    (*ANGLES, "sun-radius"),
    LIGHT,
    (SHARED, *ANGLES),
    goal=SHARED,
    results=("luminous-efficacy",),
    about="Calculate the radiance of the sky in a direction, and its irradiance on the ground and "
    "on a plane.",
    operand=OPERAND,
    sections={
        "Light": ("zenith-radiance", "horizontal-irradiance", "radiance-toward", "irradiance"),
        "Sun": (
            "sun-elevation",
            "sun-azimuth",
            "place",
            "when",
            "sun-irradiance",
            "global-irradiance",
            "sun-radiance",
            "sun-radius",
        ),
        "Plane and direction": ("tilt", "azimuth", "normal", "toward"),
        "Map": (
            text(
                "save",
                "FILE.hdr",
                "Write a latlong map of the sky (.hdr, .exr or .pfm; default 1024x512), with the "
                "disc of the sun if its light is given.",
            ),
            "size",
        ),
        "Radiant, luminous and photon quantities": (*symbols.LINKS, *symbols.REFINEMENTS),
    },
    texts={
        "irradiance": "Irradiance on the plane.",
        "tilt": ("90deg", "Tilt of a plane from the horizontal: 90deg is a wall."),
        "azimuth": ("180deg", "Azimuth of the direction that the plane faces (with {tilt})."),
        "toward": "Point of the sky, as POLAR (from the zenith), POLAR,AZIMUTH or X,Y,Z (Z up).",
        "normal": "Normal of the plane, instead of {tilt} (+z is up).",
        "sun-azimuth": "Azimuth of the sun, in the same sense as the other azimuths.",
    },
    draws=True,
    examples=(
        "overcast zenith-luminance=9000cd/m2 tilt=90deg",
        "overcast horizontal-illuminance=10klx toward=0deg:90deg:15deg",
        "clear sun-elevation=40deg horizontal-illuminance=12klx",
        "clear sun-elevation=40deg sun-azimuth=200deg horizontal-illuminance=12klx "
        "sun-illuminance=80klx tilt=30deg azimuth=180deg",
        "clear place=50.1N,14.4E when=2026-06-21T12:00+02:00 horizontal-illuminance=12klx",
        "12 sun-elevation=10deg:80deg:10deg zenith-luminance=3000cd/m2 "
        "get=horizontal-illuminance:klx",
        "13 sun-elevation=35deg global-irradiance=600W/m2 sun-irradiance=750W/m2",
        "clear sun-elevation=40deg horizontal-illuminance=12klx spectrum=D65 "
        "get=horizontal-photon-irradiance:umol/m2/s",
        "clear sun-elevation=40deg horizontal-illuminance=12klx plot=sky.png",
        "overcast illuminance=4klx tilt=90deg get=zenith-luminance",
        "clear sun-elevation=40deg sun-azimuth=0deg horizontal-illuminance=12klx "
        "save=clear.hdr size=2048x1024",
    ),
    remarks="""
    \b
    TYPE is one of:
      overcast (default)  the traditional overcast sky of Moon and Spencer: the zenith is three
                          times as bright as the horizon
      uniform             the same in all directions (CIE type 5)
      clear               CIE type 12, low turbidity
      turbid              CIE type 13, the clear sky over polluted places
      intermediate        CIE type 7, partly cloudy and brighter around the sun
      1 to 15             a type of the CIE standard general sky (ISO 15469); 1 is its overcast sky

    The CIE types 2, 4 and 6 to 15 depend on the position of the sun.  The light of the sky does not
    include the sun's own light: {sun-irradiance} (perpendicular to the rays), {sun-radiance} (of
    the disc) or {global-irradiance} adds it.  Give any light quantity; the others are calculated.
    Radiances and irradiances may be in watts, lumens or photons: the unit decides.

    {place} and {when} give the position of the sun instead of its angles (with the package pvlib).
    All azimuths are then clockwise from north; with X,Y,Z, +x is north and +y is east.

    Only differences of azimuths matter, so they may be measured from any direction, for example
    clockwise from north; with {normal} X,Y,Z or {toward} X,Y,Z they are measured from +x towards
    +y.  The ground reflects no light: only half of the sky lights a wall.  daylight-share is the
    irradiance on the plane from the sky alone, divided by that on the ground.
    """,
    mistakes=("sky",),
)
SEEN = (  # the sun at a place and a time
    "the sun is where it is seen, with refraction at 1013.25 hPa and 12 deg C (SPA, pvlib); "
    "azimuths are clockwise from north (+x is north, and +y east)"
)
BRIGHT = errors.mention("{zenith-radiance=1000cd/m2} or {horizontal-irradiance=100lx}")
NO_PLANE = "no plane is given", errors.mention("{tilt=90deg} or {normal}")
NO_DIRECTION = "no direction is given", errors.mention("{toward=60deg,90deg}")


def sky(name: str, given: Inputs, is_drawn: bool = False) -> Answer:
    """Return the light of a sky of `radcalc.geometry.models.NAMES` and of the sun.

    A sky that `is_drawn` accepts the sun's azimuth alone.
    """
    sky = _Sky(name, given, is_drawn=is_drawn)
    return sky.answer(sky.solve())


def sky_map(name: str, given: Inputs) -> "RenderedMap":
    """Return a map of a sky, with the sun's disc if the sun has light; `given` may have a size."""
    from radcalc.calculators.pixel import refuse_shape
    from radcalc.calculators.solved import RenderedMap

    if "size" in given:
        refuse_shape(given["size"], symbols.LATLONG)
    sky = _Sky(name, {key: item for key, item in given.items() if key != "size"}, for_map=True)
    solved = sky.solve()
    answer = sky.answer(solved)
    picture = sky.picture(solved, *(given["size"].value if "size" in given else USUAL_SIZE))
    height, width, _ = picture.pixels.shape
    what = f"a latlong map of {width} x {height} pixels in {picture.unit}, "
    what += "azimuth 0 in the middle and 90 deg a quarter of the width to the left, "
    what += "with the sun's disc" if sky.is_sunlit else "without the sun's disc"
    what += f"; {sky.on_ground(solved, picture)}"
    return RenderedMap(picture, picture.pixels, picture.unit, what, answer)


class _Sky:
    def __init__(
        self, name: str, given: Inputs, for_map: bool = False, is_drawn: bool = False
    ) -> None:
        self.name, self.type = name, sky_type(name)
        self.is_located = "place" in given or "when" in given
        if self.is_located and not (self.type.follows_sun or _is_sunlit(given)):
            typed = {item: given[item].text for item in ("place", "when") if item in given}
            ways = [errors.leave_out(*typed)]
            if len(typed) > 1:
                of_sun = {"tilt": "0deg", "get": "sun-elevation"}
                ways.append(errors.call("sky", "clear", **typed, **of_sun))
            raise errors.Unused([*typed], IS_EVEN.format(errors.quote(name)), ways)
        if self.is_located:
            from radcalc.inputs.sun import located  # which needs pvlib

            given = located(given)
        self.is_sunlit = _is_sunlit(given)
        self.has_plane = "normal" in given or "tilt" in given
        self.laws = self._laws(with_direction="toward" in given)
        names = {name for law in self.laws for name in law.names}
        page = PAGE._replace(
            title=f"the sky {name}",
            takes=(),
            light=tuple(item for item in LIGHT if item in names),
            others=tuple(item for item in PAGE.others if item in names or item in given),
        )
        self.sheet = worksheet(page, given, accepts=PAGE.takes, hints=())
        self.given = self.sheet.given
        self.lit = self.sheet.lit.values
        self._refuse_incomplete()
        if self.type.follows_sun or self.is_sunlit:
            self._refuse_misplaced(for_map, is_drawn)
        else:
            self._refuse_sun()

    def answer(self, solved: Solved) -> Answer:
        self._assume(solved)
        kind = solved.lit.kind
        lacking = {} if self.has_plane else {"irradiance": NO_PLANE, "daylight-share": NO_PLANE}
        lacking |= {} if "toward" in self.given else {"radiance-toward": NO_DIRECTION}
        answer = solved.answer()
        rows = [
            absent(name, *why)._replace(
                also=symbols.specific_name(name, kind) if name in LIGHT else name
            )
            for name, why in lacking.items()
        ]
        return answer._replace(values=[*answer.values, *rows])

    def solve(self) -> Solved:
        if not (self.lit or self.has_plane):
            raise errors.MissingInput("a light quantity is missing", BRIGHT)
        placed = Placed()
        if self.is_sunlit and "sun-radius" not in self.given:
            placed.add("sun-radius", SUN_RADIUS)
        placed.merge(place(self.sheet, self._place))
        placed.use(*ANGLES)
        return solve(self.sheet, self.laws, placed)

    def picture(self, solved: Solved, width: int, height: int) -> "Picture":
        """Return a map of the sky, with the sun if it shines; refuse an unknown brightness."""
        from radcalc.distributions.environments import Sky
        from radcalc.distributions.maps.rendered import Sun, sky_map

        if not solved.has("zenith-radiance"):
            raise errors.MissingInput("the brightness of the sky is missing", BRIGHT)
        zenith = solved.value("zenith-radiance")
        place = place_of_sun(self.given) if "sun-elevation" in self.given else (0.0, 0.0)
        sky = Sky(self.name, place if self.type.follows_sun else None, zenith, solved.lit.kind)
        disc = None
        if self.is_sunlit:
            if not solved.has("sun-irradiance"):
                raise errors.MissingInput(
                    "the brightness of the sun is missing", errors.mention("{sun-irradiance}")
                )
            polar, azimuth = place
            radius, irradiance = solved.value("sun-radius"), solved.value("sun-irradiance")
            disc = Sun(polar, azimuth, radius, irradiance)
        return sky_map(sky, width, height, disc)

    def on_ground(self, solved: Solved, picture: "Picture") -> str:
        from radcalc.distributions.maps import RadianceMap

        kind = solved.lit.kind
        factor = float(resolve(picture.unit).factor)
        integral = RadianceMap(
            picture.pixels, symbols.LATLONG, factor=factor, kind=kind
        ).irradiance(UP)
        right = solved.value("global-irradiance" if self.is_sunlit else "horizontal-irradiance")
        unit = symbols.light_unit("irradiance", kind)
        irradiance_text = f"{format_number(integral.value / float(resolve(unit).factor))} {unit}"
        off = 100 * (integral.value / right - 1) if right else 0.0
        return f"its pixels give the ground {irradiance_text} (error: {off:.1g} %)"

    def _laws(self, with_direction: bool) -> list[AnyLaw]:
        laws: list[AnyLaw] = [GROUND]
        if self.is_sunlit:
            laws += [GLOBAL, DISC]
        if with_direction:
            laws.append(TOWARD)
        if self.has_plane:
            laws += [SHARE, *([DIFFUSE, DIRECT, BOTH] if self.is_sunlit else [PLANE])]
        return laws

    # -- checks ---------------------------------------------------------------------------------

    def _refuse_incomplete(self) -> None:
        """Refuse an incomplete plane, two planes, and light without its plane or direction."""
        given, lit = self.given, self.lit
        for other in ("tilt", "azimuth"):
            if "normal" in given and other in given:
                raise errors.Exclusive(("normal", other), "both turn the plane")
        if "azimuth" in given and "tilt" not in given:
            raise errors.Unused(("azimuth",), "without a tilt", errors.mention("add {tilt=90deg}"))
        if "irradiance" in lit and not self.has_plane:
            item = lit["irradiance"]
            hint = errors.mention(
                "{tilt=90deg} or {normal}, or {horizontal-irradiance} of the ground"
            )
            ground = symbols.specific_name("horizontal-irradiance", kind_of(item))
            of_ground = errors.Try(((ground, item.text),), (item.name,), remark="on the ground")
            ways = [errors.add("tilt", "90deg", "on a wall"), of_ground]
            raise errors.MissingInput(f"the plane of {option(item.name)} is missing", hint, ways)
        if "radiance-toward" in lit and "toward" not in given:
            option_text = option(lit["radiance-toward"].name)
            raise errors.MissingInput(f"the direction of {option_text} is missing", NO_DIRECTION[1])
        if "radiance-toward" in lit and any_true(given["toward"].value[0] > math.pi / 2):
            option_text = option(lit["radiance-toward"].name)
            problem = f"{option_text} cannot be used below the horizon, where it is dark"
            raise errors.ConditionError(problem, errors.mention("{toward=60deg,90deg}"))

    def _refuse_sun(self) -> None:
        """Refuse the position of the sun if nothing depends on it."""
        useless = [
            symbol_name for symbol_name in (*OF_PLACE, "azimuth") if symbol_name in self.given
        ]
        if useless:
            raise errors.Unused(useless, IS_EVEN.format(errors.quote(self.name)))

    def _refuse_misplaced(self, for_map: bool, is_drawn: bool) -> None:
        """Refuse missing angles and unused ones."""
        given = self.given
        if "sun-elevation" not in given:
            raise errors.MissingInput(*MISSING_SUN)
        if "sun-radius" in given and not self.is_sunlit:
            raise errors.Unused(("sun-radius",), "without the sun's light")
        turned = self._is_turned()
        is_off_zenith = self.type.follows_sun and "toward" in given and given["toward"].value[0] > 0
        # one plane of a list may be level, and one direction the zenith
        needs_azimuth = self.has_plane or (self.type.follows_sun and "toward" in given)
        needs_none = not (needs_azimuth or for_map or is_drawn or self.is_located)
        if "sun-azimuth" in given and needs_none:
            hint = errors.mention("add {tilt=90deg} and {azimuth=180deg}, or {toward=60deg,90deg}")
            raise errors.Unused(("sun-azimuth",), "without a plane or a direction", hint)
        if "sun-azimuth" not in given and (turned or is_off_zenith or for_map):
            raise errors.MissingInput(*MISSING_AZIMUTH)
        if turned and "tilt" in given and "azimuth" not in given:
            raise errors.MissingInput(
                "the plane's azimuth is missing", errors.mention("{azimuth=180deg}")
            )
        if self.type.follows_sun and "toward" in given:
            require_azimuth(given["toward"], "the sky follows the sun")

    def _is_turned(self) -> bool:
        """Return whether the plane faces neither straight up nor straight down."""
        if not self.has_plane:
            return False
        x, y, _ = _facing(self.given)
        return any_true((abs(x) > LEAST) | (abs(y) > LEAST))

    # -- quadrature -----------------------------------------------------------------------------

    def _place(self, sheet: Worksheet) -> Placed:
        """Compute the sky seen by ground and plane, its relative radiance, and the sun's cosine."""
        given, sky, placed = sheet.given, self.type, Placed()
        sun = place_of_sun(given) if "sun-elevation" in given else (0.0, 0.0)
        placed.steps.append(self._luminance())
        over_ground = each(lambda *at: projected_sky(sky, UP, at)[0], sun[0], 0.0)
        placed.add("horizontal-sky", over_ground)
        placed.steps.append(HORIZONTAL_SKY.step({}, format_value(over_ground, "sr")))
        if self.has_plane:
            facing = _facing(given)
            before = each(lambda x, y, z, *at: projected_sky(sky, (x, y, z), at)[0], *facing, *sun)
            placed.add("plane-sky", before)
            placed.steps.append(PLANE_SKY.step({}, format_value(before, "sr")))
        if self.is_sunlit:
            placed.add("sun-height", sin(given["sun-elevation"].value))
        if self.has_plane and self.is_sunlit:
            cosine = dot(facing, cartesian(*sun))
            cosine = cosine * (cosine > LEAST)
            placed.add("cosine", cosine)
            placed.steps.append(SUN_COSINE.with_numbers(f"cos(theta) = {format_number(cosine)}"))
        if "toward" in given:
            polar, azimuth = given["toward"].value
            relative = relative_luminance(sky, polar, azimuth, sun)
            placed.add("relative-radiance", relative)
            placed.steps.append(RELATIVE.step({}, format_number(relative)))
        return placed

    def _luminance(self) -> Step:
        if self.type.is_linear:
            return Step(*LINEAR)
        numbers = ", ".join(f"{name} = {getattr(self.type, name):g}" for name in "abcde")
        if self.type.follows_sun:
            polar = place_of_sun(self.given)[0]
            numbers += f"; Z_s = {format_angle(polar)}"
        return LUMINANCE.with_numbers(numbers)

    # -- remarks --------------------------------------------------------------------------------

    def _assume(self, solved: Solved) -> None:
        """Add the assumptions on the sky, the sun's disc, the horizon and the azimuths."""
        given, sky = self.given, self.type
        number = f"CIE type {sky.number}: " if sky.number else ""
        solved.assume(f"{number}{sky.name}", of=ON_SKY)
        if self.is_sunlit:
            both = "the sky does not include the sun's disc; planes get the light of both"
            solved.assume(both, of=[*ON_SKY, "global-irradiance", "irradiance"])
            if solved.lit.links:
                same = "the sun's light and the sky's have the same spectrum"
                solved.assume(same, of=solved.lit.linked)
        elif sky.follows_sun:
            solved.assume("the sky does not include the sun's disc", of=ON_SKY)
        below = "toward" in given and any_true(given["toward"].value[0] > math.pi / 2)
        if self.has_plane or below:
            solved.assume("no light comes from below the horizon", of=ON_SKY[1:])
        if self.has_plane and self.is_sunlit:
            solved.assume("the daylight share is for the sky alone", of=["daylight-share"])
        if self.is_located:
            solved.assume(SEEN, of=[*ON_SKY, "sun-elevation", "sun-azimuth", "sun-height"])
        elif "sun-azimuth" in given:
            is_vector = "normal" in given or (
                "toward" in given and given["toward"].text.count(",") == 2
            )
            solved.assume(
                "azimuths are measured from +x towards +y"
                if is_vector
                else "all azimuths are measured from the same direction and in the same sense",
                of=[*ON_SKY[1:], "cosine"],
            )
        if self.is_sunlit:
            self._say_disc(solved)

    def _say_disc(self, solved: Solved) -> None:
        """Add the size of the sun to the assumptions, with notes on where it matters."""
        radius = solved.value("sun-radius")
        if "sun-radius" not in self.given:
            disc = f"the sun's disc has a radius of {format_angle(radius)}"
            solved.assume(disc, of=["sun-radius"])
        cut = sin(self.given["sun-elevation"].value) < sin(radius)
        if self.has_plane:
            cosine = dot(_facing(self.given), cartesian(*place_of_sun(self.given)))
            cut = cut | (abs(cosine) < sin(radius))
            if any_true(cosine <= 0):
                solved.note("the sun is behind the plane")
        if "toward" in self.given and "sun-azimuth" in self.given:
            polar, azimuth = self.given["toward"].value
            if any_true(angle_between(polar, azimuth, place_of_sun(self.given)) < radius):
                solved.note("the sun's disc is in that direction; the radiance leaves it out")
        if any_true(cut):
            solved.note(
                "the horizon or the plane cuts the sun's disc, which is treated as a point at its "
                "centre"
            )


def _is_sunlit(given: Inputs) -> bool:
    return any(item.symbol.generic in OF_SUN for item in given.values())


def place_of_sun(given: Inputs) -> tuple[Number, Number]:
    """Return the polar angle and the azimuth of the sun [rad]."""
    azimuth = given["sun-azimuth"].value if "sun-azimuth" in given else 0.0
    return math.pi / 2 - given["sun-elevation"].value, azimuth


def _facing(given: Inputs) -> Vector:
    if "normal" in given:
        return unit(given["normal"].value)
    tilt, azimuth = given["tilt"].value, given["azimuth"].value if "azimuth" in given else 0.0
    return sin(tilt) * cos(azimuth), sin(tilt) * sin(azimuth), cos(tilt)
