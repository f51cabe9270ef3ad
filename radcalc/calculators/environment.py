"""What surrounds a place: a map of radiances, a sky, an expression; what a receiver gets of it."""

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, NamedTuple

from radcalc.answer import Answer, Step, Value
from radcalc.calculators import light
from radcalc.calculators.results import absent, value
from radcalc.calculators.worksheet import refuse_foreign
from radcalc.derivation import format_number, format_value
from radcalc.errors import ConditionError, MissingInput, Unused, option, options
from radcalc.geometry.directions import UP
from radcalc.geometry.numerics.vectors import Vector
from radcalc.given import Inputs, at_most_one, read, require_azimuth, sort
from radcalc.maths import is_array
from radcalc.quantities.symbols import LATLONG, LINKS, SYMBOLS, light_unit, specific_name
from radcalc.units.dimensions import SOLID_ANGLE
from radcalc.units.table import NUMBER, resolve

if TYPE_CHECKING:
    from radcalc.distributions.distribution import Peak
    from radcalc.distributions.environments import Environment
    from radcalc.distributions.maps.light_sums import Progress
    from radcalc.distributions.maps.pictures import Picture
    from radcalc.distributions.maps.radiance_map import RadianceMap
    from radcalc.distributions.radiances import Radiances
    from radcalc.geometry.numerics.cubature import Integral

SKY = "sky:"  # before the type of a sky
OF_MAP = ("unit", "projection", "aim", "channel")
OF_SKY = ("sun-elevation", "sun-azimuth")
SCALES = ("zenith-radiance", "horizontal-irradiance")
RECEIVER = ("normal", "toward")
EVEN = 1 - 1e-9  # of the peak: a mean above it is the peak's own, up to rounding
SMALL = (64, 32)  # pixels of an irradiance map
MOST = {"irradiance": "maximum", "radiance": "peak"}  # before the name of a quantity
# Formulas of derivations, and where they come from.
IRRADIANCE = "E = integral of L max(n . s, 0) domega", "ISO 80000-7, irradiance"
BY_HARMONICS = (
    "E = sum of A_l L_lm Y_lm(n), l = 0, 1, 2, A_l = pi, 2 pi/3, pi/4",
    "Ramamoorthi and Hanrahan, SIGGRAPH 2001",
)
MEAN = "{} = integral of L domega / integral of domega"
IS_RELATIVE = (
    "the radiances are relative, and so is every result: where they are 1 everywhere, the "
    "irradiance is pi sr"
)


class Source:
    """What a user named, read once for all answers about it.

    `named` is the path of a map, sky:TYPE, an expression with its unit, or a picture; where it
    `is_path`, the first of these alone.
    """

    def __init__(self, named: "str | Picture", is_path: bool = False) -> None:
        self.named, self.is_path = named, is_path
        self.pictures: dict[str, Picture] = {}  # by the channel that they are read for
        self.found: dict[tuple[Any, ...], Environment] = {}
        self.sums: dict[tuple[int, Vector], tuple[Integral, float, Peak]] = {}

    def environment(self, own: Inputs, lit: light.Lit) -> "Environment":
        """The radiances, by the inputs that are about them."""
        key = tuple((name, one.text) for name, one in own.items())
        if key not in self.found:
            self.found[key] = self._read(own, lit)
        return self.found[key]

    def figures(self, radiances: "Radiances", normal: Vector) -> "tuple[Integral, float, Peak]":
        """The irradiance, the mean and the peak, once for a list of directions."""
        key = (id(radiances), normal)
        if key not in self.sums:
            self.sums[key] = radiances.irradiance(normal), radiances.mean(), radiances.peak()
        return self.sums[key]

    def _read(self, own: Inputs, lit: light.Lit) -> "Environment":
        from radcalc.distributions import environments

        named = self.named
        if isinstance(named, str) and not self.is_path:
            if named.lower().startswith(SKY):
                _refuse_others(own, (*OF_SKY, *SCALES), "a sky")
                return _sky(named.lower().removeprefix(SKY).strip(), own, lit)
            if not environments.is_map(named):
                _refuse_others(own, (), "an expression")
                return environments.expression(named)
        _refuse_others(own, OF_MAP, "a map")
        given = {name: one.value for name, one in own.items()}
        if isinstance(named, str):
            named = self._picture(named, given.get("channel", ""))
        return environments.of_picture(named, **given)

    def _picture(self, path: str, channel: str) -> "Picture":
        """The picture of a map, which is read once."""
        from radcalc.distributions.maps.pictures import read_picture

        if channel not in self.pictures:
            self.pictures[channel] = read_picture(path, channel)
        return self.pictures[channel]


def _refuse_others(own: Inputs, takes: tuple[str, ...], what: str) -> None:
    """Refuse what is about another source."""
    others = [one.name for name, one in own.items() if name not in takes]
    if others:
        raise Unused(others, f"with {what}")


def _sky(name: str, own: Inputs, lit: light.Lit) -> "Environment":
    """A sky, scaled by what is given or relative to its zenith."""
    from radcalc.calculators.sky import place_of_sun
    from radcalc.distributions.environments import Environment
    from radcalc.distributions.sky import Sky
    from radcalc.geometry.sky import IS_EVEN, MISSING_AZIMUTH, sky_type

    sun: Any = None
    useless = [one for one in OF_SKY if one in own]
    if not sky_type(name).follows_sun and useless:
        raise Unused(useless, IS_EVEN.format(name))
    if "sun-elevation" in own:
        if "sun-azimuth" not in own:
            raise MissingInput(*MISSING_AZIMUTH)
        sun = place_of_sun(own)
    sky = Sky(name, sun)  # which asks for the sun where it is missing
    said = [f"sky {name}: {sky.type.name}; below the horizon it is dark"]
    if sun:
        said.append("the sun is no part of the sky")
    scale = at_most_one(own, "how bright the sky is", *SCALES)
    if scale is None:
        said.append("the radiances are those over the zenith's")
        return Environment(sky, assumptions=tuple(said))
    zenith = lit.amounts[scale.symbol.generic]
    if scale.symbol.generic == "horizontal-irradiance":
        zenith = zenith / sky.irradiance(UP).value
    return Environment(Sky(name, sun, zenith, lit.kind), assumptions=tuple(said))


def environment(source: Source, given: Inputs) -> Answer:
    """What a receiver gets of its surroundings, and what they are like.

    `given` are what tells how a map is to be read, how bright a sky is and where the sun, where the
    receiver faces, a direction, and what links the kinds.
    """
    return _surroundings(source, given, RECEIVER).answer()


def surroundings(source: Source, given: Inputs) -> "Radiances":
    """The radiances that `environment` is about; `given` as there."""
    return _surroundings(source, given, RECEIVER).found.radiances


class Made(NamedTuple):
    """A picture that was made, what it is in words, and what is to be said of its values.

    `pixels` are the picture's with all their digits, in the `unit`.
    """

    picture: "Picture"
    pixels: Any
    unit: str
    what: str
    answer: Answer


def irradiance_map(
    source: Source, given: Inputs, order: int | None = None, progress: "Progress | None" = None
) -> Made:
    """The irradiances of receivers that face in all directions, as a latlong map.

    `given` are as of `environment`, but for the receiver's, and the size of the map.
    """
    return _surroundings(source, given, ("size",)).irradiance_map(order, progress)


def reprojection(
    source: Source, given: Inputs, to: str, progress: "Progress | None" = None
) -> Made:
    """The radiances as a map in a projection of `PROJECTIONS`; `given` as of `irradiance_map`."""
    return _surroundings(source, given, ("size",)).reprojected(to, progress)


def _surroundings(source: Source, given: Inputs, more: tuple[str, ...]) -> "_Surroundings":
    """The radiances that a user named, with what is given."""
    quantities, links, rest = sort(given)
    takes = (*OF_MAP, *OF_SKY, *SCALES, *more)
    refuse_foreign(rest, takes, "an environment")
    lit = light.read_light(quantities, links)
    refuse_foreign(lit.values, takes, "an environment")
    for one in given.values():
        if is_array(one.value):
            raise ConditionError(f"{option(one.name)} is an array", "one value at a time")
    own = {name: one for name, one in rest.items() if name not in more}
    return _Surroundings(source, source.environment({**own, **lit.values}, lit), lit, rest)


class _Surroundings:
    """Radiances, in their kind or in none, and what is said of them."""

    def __init__(self, source: Source, found: "Environment", lit: light.Lit, given: Inputs) -> None:
        self.source = source
        self.found, self.kind, self.given = found, found.radiances.kind, given
        links = lit.links
        self.assumptions, self.notes = [*found.assumptions], [*found.notes]
        if not self.kind:
            if links:
                raise Unused(tuple(links), "with relative radiances")
            self.assumptions.append(IS_RELATIVE)
        self.counts = bool(found.efficacy) and not set(LINKS) & set(links)
        if self.counts:
            links = {**links, "efficacy": read("efficacy", f"{found.efficacy:g} lm/W")}
        self.lit = light.read_light({}, links)._replace(kind=self.kind)

    def answer(self) -> Answer:
        """The irradiance, the mean, the peak, and the radiance from a direction."""
        given, radiances = self.given, self.found.radiances
        normal = given["normal"].value if "normal" in given else UP
        if "normal" not in given:
            self.assumptions.append("the receiver faces up")
        irradiance, mean, peak = self.source.figures(radiances, normal)
        found = {"irradiance": irradiance.value, "mean-radiance": mean, "peak-radiance": peak.value}
        if "toward" in given:
            if not radiances.is_axial:
                require_azimuth(given["toward"], "the radiance depends on it")
            found["radiance-toward"] = float(radiances.radiance(*given["toward"].value))
        shown = self._shown(found)
        ends = [
            value("peak-polar", peak.polar, letter="θ_max"),
            value("peak-azimuth", peak.azimuth, letter="φ_max"),
        ]
        if not peak.value:
            self.notes.append("there is no light from any direction that was looked at")
            dark = "there is no light", "a map, a sky or an expression that has some"
            ends = [absent("peak-polar", *dark), absent("peak-azimuth", *dark)]
        elif mean > peak.value * EVEN:
            self.notes.append("the radiance is the same in every direction that is covered")
            even = "the radiance is the same in all directions", "peak-radiance"
            ends = [absent("peak-polar", *even), absent("peak-azimuth", *even)]
        values = [*shown.values["irradiance"], *shown.values["mean-radiance"]]
        values += [*shown.values["peak-radiance"], *ends]
        values += shown.values.get("radiance-toward") or [
            absent("radiance-toward", "no direction is given", option("toward", "60deg,90deg"))
        ]
        if "toward" in given:  # which tells the answers to a list apart
            polar, azimuth = given["toward"].value
            values.append(value("polar", polar, label="polar angle of that direction"))
            if "," in given["toward"].text:
                values.append(value("azimuth", azimuth, label="azimuth of that direction"))
        values.append(value("coverage", radiances.coverage))
        if irradiance.error:
            values.append(self._error(irradiance.error))
        steps = [*self._steps(normal, irradiance.value, mean), *shown.steps]
        return Answer(
            values,
            (*self.assumptions, *shown.assumptions),
            (*self.notes, *shown.notes),
            steps,
        )

    def irradiance_map(self, order: int | None, progress: "Progress | None") -> Made:
        """The irradiances by the normals that the pixels of a latlong map show."""
        from radcalc.distributions.maps.irradiance_map import DIRECTIONS, irradiance_map

        size = self._size(LATLONG, *SMALL)
        found = irradiance_map(self._map(), *size, order, progress)
        if order:
            self.notes.append(
                f"of spherical harmonics up to order {order}: off the exact sum by up to "
                f"{100 * found.largest:.2g} % of the largest irradiance, by {100 * found.rms:.2g} "
                f"% in the root mean square, of receivers in {DIRECTIONS} directions"
            )
            if found.raised:
                self.notes.append(
                    f"the harmonics are below 0 in {found.raised} pixels, by up to "
                    f"{100 * found.deepest:.2g} % of the largest irradiance, and count as 0 there"
                )
        formula, reference = BY_HARMONICS if order else IRRADIANCE
        each = "n = the direction that the middle of a pixel shows"
        step = Step("irradiance of each receiver", formula, each, reference)
        return self._made("irradiance", found.pixels, LATLONG, step)

    def reprojected(self, to: str, progress: "Progress | None") -> Made:
        """The radiances in another projection."""
        from radcalc.distributions.maps.resampling import reproject

        chart = self._map()
        height = chart.size[1]
        size = self._size(to, 2 * height if to == LATLONG else height, height)
        self.assumptions.append("the middle of what is written shows +x")
        step = Step("radiance of each pixel", MEAN.format("L'"), "over what the pixel shows")
        return self._made("radiance", reproject(chart, to, *size, progress=progress), to, step)

    def _size(self, projection: str, width: int, height: int) -> tuple[int, int]:
        """The size of a map to be made: what is asked for, or one that goes without saying."""
        from radcalc.calculators.pixel import refuse_shape
        from radcalc.distributions.maps.pictures import check_size
        from radcalc.distributions.maps.radiance_map import check_shape

        if "size" in self.given:
            width, height = self.given["size"].value
            refuse_shape(self.given["size"], projection)
            check_shape(projection, width, height)
            check_size(width, height, "the map")
        return width, height

    def _map(self) -> "RadianceMap":
        """The radiances as a map; skies and expressions are sampled."""
        from radcalc.distributions import environments
        from radcalc.distributions.maps.radiance_map import RadianceMap
        from radcalc.geometry.projections import USUAL_SIZE

        if isinstance(self.found.radiances, RadianceMap):
            return self.found.radiances
        width, height = USUAL_SIZE
        self.assumptions.append(
            f"sampled at the middles of {width} x {height} pixels of a {LATLONG} map"
        )
        return environments.sampled(self.found.radiances, width, height)

    def _made(self, name: str, values: Any, projection: str, step: Step) -> Made:
        """A picture of irradiances or radiances [SI], and the least and the greatest it shows."""
        from radcalc.distributions.maps.pictures import Picture, as_floats
        from radcalc.geometry.projections import name_of_map, pixel_solid_angles

        unit, label = _relative(name, 0.0).units[0], f"relative {name}"
        if self.kind:
            unit = light_unit(name, self.kind)
            label = specific_name(name, self.kind).replace("-", " ")
        pixels = values / float(resolve(unit).factor)
        floats = as_floats(pixels, unit)
        height, width, _ = pixels.shape
        sums = values @ self.found.weights
        told = sums[pixel_solid_angles(projection, width, height) + 0 * sums > 0]
        ends = {f"minimum-{name}": float(told.min()), f"{MOST[name]}-{name}": float(told.max())}
        shown = self._shown(ends)
        picture = Picture(
            floats,
            self.found.channels,
            self.found.weights,
            "",
            unit,
            projection,
        )
        answer = Answer(
            [row for end in ends for row in shown.values[end]],
            (*self.assumptions, *shown.assumptions),
            (*self.notes, *shown.notes),
            [*self._weighting(), step, *shown.steps],
        )
        what = f"{name_of_map(projection)} of {width} x {height} pixels"
        what += f", of {label} in {unit}"
        return Made(picture, pixels, unit, what, answer)

    def _shown(self, found: dict[str, float]) -> light.Shown:
        """Light quantities as results: in every kind that is linked, or relative."""
        if not self.kind:
            rows = {name: [_relative(name, amount)] for name, amount in found.items()}
            return light.Shown(rows, (), (), ())
        shown = light.show_light(self.lit, found)
        if self.counts:
            said = (
                f"a watt counts as {self.found.efficacy:g} lm, as in Radiance "
                f"({options(LINKS)} for another light)"
            )
            return shown._replace(assumptions=(said,), notes=())
        return shown

    def _told(self, name: str, amount: float) -> str:
        """A light quantity in a derivation."""
        relative = _relative(name, amount).units[0]
        unit = light_unit(name, self.kind, coherent=True) if self.kind else relative
        return format_value(amount, unit)

    def _error(self, error: float) -> Value:
        """How far the irradiance may be off."""
        row = self._shown({"irradiance": error}).values["irradiance"][0]
        return value("error", error, *row.units, label="estimate of the error")._replace(
            dimensions=row.dimensions
        )

    def _steps(self, normal: Any, irradiance: float, mean: float) -> Iterator[Step]:
        """How the numbers follow."""
        yield from self._weighting()
        facing = ",".join(map(format_number, normal))
        told = f"n = {facing}; E = {self._told('irradiance', irradiance)}"
        yield Step("irradiance of a receiver", IRRADIANCE[0], told, IRRADIANCE[1])
        told = f"L_mean = {self._told('mean-radiance', mean)}"
        yield Step("mean radiance", MEAN.format("L_mean"), told)

    def _weighting(self) -> Iterator[Step]:
        """How the radiance of a pixel follows from its channels, if it has several."""
        if self.found.luminance:
            yield Step("radiance of a pixel", "", self.found.luminance, self.found.reference)


def _relative(name: str, amount: float) -> Value:
    """A light quantity of relative radiances."""
    symbol = SYMBOLS[name]
    is_radiance = symbol.geometry == SYMBOLS["radiance"].geometry
    own, unit = (NUMBER, "1") if is_radiance else (SOLID_ANGLE, "sr")
    return value(name, amount, unit, label=f"relative {symbol.label}")._replace(dimensions=(own,))
