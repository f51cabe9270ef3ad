"""The light of the sky and of the sun beside it: toward a direction, on the ground, on a plane.

What is worked out by quadrature, the luminance of the sky over that of its zenith, and its
integrals over the ground and over the plane, goes into laws by which all the light follows.
"""

import math
from typing import TYPE_CHECKING

from radcalc.answer import Answer, Step
from radcalc.calculators.results import absent
from radcalc.calculators.worksheet import Page, Worksheet
from radcalc.derivation import Formula, format_angle, format_number
from radcalc.errors import (
    ConditionError,
    Exclusive,
    MissingInput,
    Unused,
    mention,
    option,
    quote,
)
from radcalc.geometry.cones import refuse
from radcalc.geometry.directions import UP, cartesian
from radcalc.geometry.numerics.vectors import Vector, dot, unit
from radcalc.geometry.projections import USUAL_SIZE
from radcalc.geometry.sky import (
    CIE,
    IS_EVEN,
    MISSING_AZIMUTH,
    MISSING_SUN,
    angle_between,
    projected_sky,
    relative_luminance,
    sky_type,
)
from radcalc.given import Inputs, require_azimuth
from radcalc.laws.law import AnyLaw, law, relation
from radcalc.maths import Number, any_true, cos, each, sin
from radcalc.quantities.symbols import LATLONG, light_unit, specific_name
from radcalc.units.table import resolve

if TYPE_CHECKING:
    from radcalc.calculators.environment import Made
    from radcalc.distributions.maps.pictures import Picture

SUN_RADIUS = math.radians(0.2666)  # at its mean distance
MOON = f"{CIE}, traditional overcast sky (Moon and Spencer)"
ISO = "ISO 80000-7, illuminance"
OF_SUN = ("sun-irradiance", "sun-radiance", "global-irradiance")
OF_PLACE = ("sun-elevation", "sun-azimuth", "sun-radius")
ANGLES = ("sun-elevation", "sun-azimuth", "toward", "normal", "tilt", "azimuth")
LEAST = 1e-15  # of a cosine: below it is what rounding makes of 0
GROUND = law(
    "irradiance of the ground", "{horizontal-irradiance} = {zenith-radiance} {horizontal-sky}", ISO
)
TOWARD = law("radiance in a direction", "{radiance-toward} = {zenith-radiance} {relative-radiance}")
SHARE = law("daylight share", "{plane-sky} = {daylight-share} {horizontal-sky}")
PLANE = law("irradiance of a plane", "{irradiance} = {zenith-radiance} {plane-sky}", ISO)
DIFFUSE = law(
    "irradiance of a plane by the sky", "{diffuse-irradiance} = {zenith-radiance} {plane-sky}", ISO
)
DIRECT = law(
    "irradiance of a plane by the sun", "{direct-irradiance} = {sun-irradiance} {cosine}", ISO
)


def _rest(whole: Number, part: Number) -> Number:
    refuse(whole < part, "sky and sun together are less than one of them", "less of that one")
    return whole - part


BOTH = relation(
    "irradiance of a plane by sky and sun",
    "{irradiance} = {diffuse-irradiance} + {direct-irradiance}",
    {
        "irradiance": lambda at: at("diffuse-irradiance") + at("direct-irradiance"),
        "diffuse-irradiance": lambda at: _rest(at("irradiance"), at("direct-irradiance")),
        "direct-irradiance": lambda at: _rest(at("irradiance"), at("diffuse-irradiance")),
    },
)
GLOBAL = relation(
    "irradiance of the ground by sky and sun",
    "{global-irradiance} = {horizontal-irradiance} + {sun-irradiance} {sun-height}",
    {
        "global-irradiance": lambda at: (
            at("horizontal-irradiance") + at("sun-irradiance") * at("sun-height")
        ),
        "horizontal-irradiance": lambda at: _rest(
            at("global-irradiance"), at("sun-irradiance") * at("sun-height")
        ),
        "sun-irradiance": lambda at: (
            _rest(at("global-irradiance"), at("horizontal-irradiance")) / at("sun-height")
        ),
    },
)
DISC = relation(
    "irradiance of the sun's disc",
    "{sun-irradiance} = pi Omega0 {sun-radiance} sin({sun-radius})^2",
    {
        "sun-irradiance": lambda at: math.pi * at("sun-radiance") * sin(at("sun-radius")) ** 2,
        "sun-radiance": lambda at: at("sun-irradiance") / (math.pi * sin(at("sun-radius")) ** 2),
    },
)
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
PAGE = Page("a sky", (*ANGLES, "sun-radius"), LIGHT, (SHARED, *ANGLES), goal=SHARED)
LUMINANCE = Formula(
    "luminance of the sky",
    "L / L_z = f(chi) phi(Z) / (f(Z_s) phi(0)), phi(Z) = 1 + a exp(b / cos(Z)), "
    "f(chi) = 1 + c (exp(d chi) - exp(d pi/2)) + e cos(chi)^2",
    CIE,
)
LINEAR = "luminance of the sky", "", "L / L_z = (1 + 2 cos(Z)) / 3", MOON
RELATIVE = Formula(
    "luminance in a direction, over that of the zenith", "{relative-radiance} = L / L_z"
)
HORIZONTAL_SKY = Formula(
    "the sky over the ground", "{horizontal-sky} = integral of L / L_z cos(Z) domega, over the sky"
)
PLANE_SKY = Formula(
    "the sky before the plane",
    "{plane-sky} = integral of L / L_z cos(theta) domega, over what is above ground and plane",
)
SUN_COSINE = Formula(
    "incidence of the sun",
    "{cosine} = max(n . s, 0), of the plane's normal and the sun's direction",
)
BRIGHT = mention("{zenith-radiance=1000cd/m2} or {horizontal-irradiance=100lx}")
NO_PLANE = "no plane is given", mention("{tilt=90deg} or {normal}")
NO_DIRECTION = "no direction is given", mention("{toward=60deg,90deg}")


def sky(name: str, given: Inputs, is_drawn: bool = False) -> Answer:
    """The light of a sky of `radcalc.geometry.sky.NAMES`, and of the sun beside it.

    `given` are light quantities by whichever name, where the sun is, a direction, a plane, and
    what links the kinds.  Of a sky that `is_drawn` the sun's azimuth is of use by itself.
    """
    return _Sky(name, given, is_drawn=is_drawn).answer()


def sky_map(name: str, given: Inputs) -> "Made":
    """A map of a sky, with the sun's disc if the sun has light; `given` also has its size."""
    from radcalc.calculators.environment import Made
    from radcalc.calculators.pixel import refuse_shape

    if "size" in given:
        refuse_shape(given["size"], LATLONG)
    found = _Sky(name, {key: one for key, one in given.items() if key != "size"}, for_map=True)
    answer = found.answer()
    picture = found.picture(*(given["size"].value if "size" in given else USUAL_SIZE))
    height, width, _ = picture.pixels.shape
    what = f"a latlong map of {width} x {height} pixels in {picture.unit}, "
    what += "the azimuth 0 in its middle and 90 deg a quarter to the left, "
    what += "with the sun's disc" if found.is_sunlit else "without the sun's disc"
    what += f"; {found.on_ground(picture)}"
    return Made(picture, picture.pixels, picture.unit, what, answer)


class _Sky:
    """A sky, where its sun is, and what is asked of it."""

    def __init__(
        self, name: str, given: Inputs, for_map: bool = False, is_drawn: bool = False
    ) -> None:
        self.name, self.type = name, sky_type(name)
        self.sheet = Worksheet(PAGE._replace(title=f"the sky {name}"), given)
        self.given = self.sheet.given
        self.lit = self.sheet.lit.values
        self.is_sunlit = any(one in self.lit for one in OF_SUN)
        self.has_plane = "normal" in self.given or "tilt" in self.given
        self.laws: list[AnyLaw] = self._laws()
        self._refuse_incomplete()
        if self.type.follows_sun or self.is_sunlit:
            self._refuse_misplaced(for_map, is_drawn)
        else:
            self._refuse_sun()

    def answer(self) -> Answer:
        """Everything that follows."""
        sheet = self.solve()
        self._assume(sheet)
        kind = sheet.lit.kind
        lacking = {} if self.has_plane else {"irradiance": NO_PLANE, "daylight-share": NO_PLANE}
        lacking |= {} if "toward" in self.given else {"radiance-toward": NO_DIRECTION}
        found = sheet.answer(self.laws)
        rows = [
            absent(name, *why)._replace(also=specific_name(name, kind) if name in LIGHT else name)
            for name, why in lacking.items()
        ]
        return found._replace(values=[*found.values, *rows])

    def solve(self) -> Worksheet:
        """The sheet, with everything that follows on it."""
        sheet = self.sheet
        if not (self.lit or self.has_plane):
            raise MissingInput("a light quantity is missing", BRIGHT)
        if self.is_sunlit and "sun-radius" not in self.given:
            sheet.know("sun-radius", SUN_RADIUS)
        sheet.place(self._place)
        sheet.use(*ANGLES)
        shown = {name for law in self.laws for name in law.names}
        sheet.page = sheet.page._replace(
            takes=(),
            light=tuple(name for name in LIGHT if name in shown),
            others=tuple(name for name in PAGE.others if name in shown or name in self.given),
        )
        sheet.takes = ()
        sheet.solve(self.laws)
        return sheet

    def picture(self, width: int, height: int) -> "Picture":
        """The map of the sky, once it is solved."""
        from radcalc.distributions.maps.sky_map import Sun, sky_map
        from radcalc.distributions.sky import Sky

        sheet = self.sheet
        if not sheet.has("zenith-radiance"):
            raise MissingInput("how bright the sky is is missing", BRIGHT)
        zenith = sheet.at("zenith-radiance")
        place = place_of_sun(self.given) if "sun-elevation" in self.given else (0.0, 0.0)
        sky = Sky(self.name, place if self.type.follows_sun else None, zenith, sheet.lit.kind)
        disc = None
        if self.is_sunlit:
            if not sheet.has("sun-irradiance"):
                raise MissingInput("how bright the sun is is missing", mention("{sun-irradiance}"))
            polar, azimuth = place
            disc = Sun(polar, azimuth, sheet.at("sun-radius"), sheet.at("sun-irradiance"))
        return sky_map(sky, width, height, disc)

    def on_ground(self, picture: "Picture") -> str:
        """What the pixels of its map give the ground, beside the right value."""
        from radcalc.distributions.maps.radiance_map import RadianceMap

        kind = self.sheet.lit.kind
        factor = float(resolve(picture.unit).factor)
        found = RadianceMap(picture.pixels, LATLONG, factor=factor, kind=kind).irradiance(UP)
        right = self.sheet.at("global-irradiance" if self.is_sunlit else "horizontal-irradiance")
        unit = light_unit("irradiance", kind)
        told = f"{format_number(found.value / float(resolve(unit).factor))} {unit}"
        off = 100 * (found.value / right - 1) if right else 0.0
        return f"its pixels give the ground {told}, which is off by {off:.1g} %"

    def _laws(self) -> list[AnyLaw]:
        """The laws of what is asked."""
        own: list[AnyLaw] = [GROUND]
        if self.is_sunlit:
            own += [GLOBAL, DISC]
        if "toward" in self.given:
            own.append(TOWARD)
        if self.has_plane:
            own += [SHARE, *([DIFFUSE, DIRECT, BOTH] if self.is_sunlit else [PLANE])]
        return own

    # -- what is refused ------------------------------------------------------------------------

    def _refuse_incomplete(self) -> None:
        """Refuse half of a plane, two planes, and light on what is not there."""
        given, lit = self.given, self.lit
        for other in ("tilt", "azimuth"):
            if "normal" in given and other in given:
                raise Exclusive(("normal", other), "contradict each other: both turn the plane")
        if "azimuth" in given and "tilt" not in given:
            raise Unused(("azimuth",), "without a tilt", mention("{tilt=90deg} with it"))
        if "irradiance" in lit and not self.has_plane:
            told = option(lit["irradiance"].name)
            hint = mention("{tilt=90deg} or {normal}, or {horizontal-irradiance} of the ground")
            raise MissingInput(f"the plane of {told} is missing", hint)
        if "radiance-toward" in lit and "toward" not in given:
            told = option(lit["radiance-toward"].name)
            raise MissingInput(f"the direction of {told} is missing", NO_DIRECTION[1])
        if "radiance-toward" in lit and any_true(given["toward"].value[0] > math.pi / 2):
            told = option(lit["radiance-toward"].name)
            problem = f"below the horizon it is dark, and nothing follows from {told}"
            raise ConditionError(problem, mention("{toward=60deg,90deg}"))

    def _refuse_sun(self) -> None:
        """Refuse the place of a sun where nothing depends on it."""
        useless = [one for one in (*OF_PLACE, "azimuth") if one in self.given]
        if useless:
            raise Unused(useless, IS_EVEN.format(quote(self.name)))

    def _refuse_misplaced(self, for_map: bool, is_drawn: bool) -> None:
        """Ask for the angles that matter, and refuse those that do not."""
        given = self.given
        if "sun-elevation" not in given:
            raise MissingInput(*MISSING_SUN)
        if "sun-radius" in given and not self.is_sunlit:
            raise Unused(("sun-radius",), "without the sun's light")
        turned = self._is_turned()
        aside = self.type.follows_sun and "toward" in given and given["toward"].value[0] > 0
        # one of a list of planes or directions may be level, or the zenith
        asked = self.has_plane or (self.type.follows_sun and "toward" in given)
        if "sun-azimuth" in given and not (asked or for_map or is_drawn):
            hint = mention("{tilt=90deg} and {azimuth=180deg}, or {toward=60deg,90deg}, with it")
            raise Unused(("sun-azimuth",), "without a plane or a direction", hint)
        if "sun-azimuth" not in given and (turned or aside or for_map):
            raise MissingInput(*MISSING_AZIMUTH)
        if turned and "tilt" in given and "azimuth" not in given:
            raise MissingInput("the plane's azimuth is missing", mention("{azimuth=180deg}"))
        if self.type.follows_sun and "toward" in given:
            require_azimuth(given["toward"], "the sky follows the sun")

    def _is_turned(self) -> bool:
        """Whether the plane faces anything but straight up or down."""
        if not self.has_plane:
            return False
        x, y, _ = _facing(self.given)
        return any_true((abs(x) > LEAST) | (abs(y) > LEAST))

    # -- what is worked out by quadrature -------------------------------------------------------

    def _place(self, sheet: Worksheet) -> None:
        """Enter the sky over the ground and the plane, and in a direction, and the sun's cosine."""
        given, sky = sheet.given, self.type
        sun = place_of_sun(given) if "sun-elevation" in given else (0.0, 0.0)
        sheet.placed.append(self._luminance())
        over_ground = each(lambda *at: projected_sky(sky, UP, at)[0], sun[0], 0.0)
        sheet.know("horizontal-sky", over_ground)
        sheet.placed.append(HORIZONTAL_SKY.step({}, _solid(over_ground)))
        if self.has_plane:
            facing = _facing(given)
            before = each(lambda x, y, z, *at: projected_sky(sky, (x, y, z), at)[0], *facing, *sun)
            sheet.know("plane-sky", before)
            sheet.placed.append(PLANE_SKY.step({}, _solid(before)))
        if self.is_sunlit:
            sheet.know("sun-height", sin(given["sun-elevation"].value))
        if self.has_plane and self.is_sunlit:
            cosine = dot(facing, cartesian(*sun))
            cosine = cosine * (cosine > LEAST)
            sheet.know("cosine", cosine)
            sheet.placed.append(SUN_COSINE.told(f"cos(theta) = {format_number(cosine)}"))
        if "toward" in given:
            polar, azimuth = given["toward"].value
            relative = relative_luminance(sky, polar, azimuth, sun)
            sheet.know("relative-radiance", relative)
            sheet.placed.append(RELATIVE.step({}, format_number(relative)))

    def _luminance(self) -> Step:
        """How the luminance depends on the direction."""
        if self.type.is_linear:
            return Step(*LINEAR)
        numbers = ", ".join(f"{name} = {getattr(self.type, name):g}" for name in "abcde")
        if self.type.follows_sun:
            polar = place_of_sun(self.given)[0]
            numbers += f"; Z_s = {format_angle(polar)}"
        return LUMINANCE.told(numbers)

    # -- what is said of it ---------------------------------------------------------------------

    def _assume(self, sheet: Worksheet) -> None:
        """Say what the sky is, and what goes without saying."""
        given, sky = self.given, self.type
        number = f"CIE type {sky.number}: " if sky.number else ""
        sheet.assume(f"{number}{sky.name}")
        if self.is_sunlit:
            sheet.assume(
                "the sun's disc is no part of the sky: its light is added to what planes get"
            )
            if sheet.lit.links:
                sheet.assume("the sun's light and the sky's have the same spectrum")
        elif sky.follows_sun:
            sheet.assume("the sun is no part of the sky")
        below = "toward" in given and any_true(given["toward"].value[0] > math.pi / 2)
        if self.has_plane or below:
            sheet.assume("below the horizon it is dark: nothing comes from the ground")
        if self.has_plane and self.is_sunlit:
            sheet.assume("the daylight share is that of the sky alone")
        if "sun-azimuth" in given:
            is_vector = "normal" in given or (
                "toward" in given and given["toward"].text.count(",") == 2
            )
            sheet.assume(
                "azimuths are counted from +x towards +y"
                if is_vector
                else "azimuths are counted in any one way, all in the same"
            )
        if self.is_sunlit:
            self._say_disc(sheet)

    def _say_disc(self, sheet: Worksheet) -> None:
        """Say how large the sun is, and where that matters."""
        radius = sheet.at("sun-radius")
        if "sun-radius" not in self.given:
            sheet.assume(f"the sun's disc has a radius of {format_angle(radius)}")
        cut = sin(self.given["sun-elevation"].value) < sin(radius)
        if self.has_plane:
            cosine = dot(_facing(self.given), cartesian(*place_of_sun(self.given)))
            cut = cut | (abs(cosine) < sin(radius))
            if any_true(cosine <= 0):
                sheet.notes.append("the sun is behind the plane")
        if "toward" in self.given and "sun-azimuth" in self.given:
            polar, azimuth = self.given["toward"].value
            if any_true(angle_between(polar, azimuth, place_of_sun(self.given)) < radius):
                sheet.notes.append("the sun's disc is seen there, and not counted in the radiance")
        if any_true(cut):
            sheet.notes.append(
                "the horizon or the plane cuts the sun's disc, which is taken as if all of it were "
                "at its centre"
            )


def place_of_sun(given: Inputs) -> tuple[Number, Number]:
    """Polar angle and azimuth of the sun."""
    azimuth = given["sun-azimuth"].value if "sun-azimuth" in given else 0.0
    return math.pi / 2 - given["sun-elevation"].value, azimuth


def _facing(given: Inputs) -> Vector:
    """Where the plane faces, as a vector of length 1."""
    if "normal" in given:
        return unit(given["normal"].value)
    tilt, azimuth = given["tilt"].value, given["azimuth"].value if "azimuth" in given else 0.0
    return sin(tilt) * cos(azimuth), sin(tilt) * sin(azimuth), cos(tilt)


def _solid(size: Number) -> str:
    return f"{format_number(size)} sr"
