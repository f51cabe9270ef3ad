"""The light that a receiver gets from its surroundings: a radiance map, a sky, an expression."""

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from radcalc.answer import Answer, Remark, Step, Value, format_number, format_value
from radcalc.calculators import kinds
from radcalc.calculators.page import ENVIRONMENT, Operand, Page, choice, text
from radcalc.calculators.results import absent, value
from radcalc.calculators.solved import RenderedMap
from radcalc.calculators.worksheet import refuse_foreign
from radcalc.errors import ConditionError, MissingInput, Unused, option, options
from radcalc.geometry.models import NAMES
from radcalc.geometry.projections import UP, Vector
from radcalc.inputs import Inputs, at_most_one, split_by_light
from radcalc.inputs.places import require_azimuth
from radcalc.inputs.reading import read
from radcalc.maths import is_array
from radcalc.quantities import KINDS, symbols
from radcalc.quantities.symbols import LATLONG, LINKS
from radcalc.units import NUMBER
from radcalc.units.dimensions import SOLID_ANGLE
from radcalc.units.table import resolve

if TYPE_CHECKING:
    from radcalc.distributions.distribution import Peak
    from radcalc.distributions.environments import Environment, Radiances
    from radcalc.distributions.maps import RadianceMap
    from radcalc.distributions.maps.light_sums import Progress
    from radcalc.distributions.maps.pictures import Picture
    from radcalc.geometry.numerics.cubature import Integral

SKY = "sky:"  # before the type of a sky
OF_MAP = ("unit", "projection", "field", "aim", "channel")
OF_SKY = ("sun-elevation", "sun-azimuth")
SCALES = ("zenith-radiance", "horizontal-irradiance")
RECEIVER = ("normal", "toward")
PAGE = Page(
    results=(
        "irradiance",
        "mean-radiance",
        "peak-radiance",
        "peak-polar",
        "peak-azimuth",
        "coverage",
        "error",
        "radiance-toward",
        "polar",
        "azimuth",
    ),
    about="Calculate the light that a receiver gets from a radiance map, a sky or an expression.",
    operand=Operand("source", "SOURCE", ENVIRONMENT, NAMES),
    sections={
        "Map": OF_MAP,
        "Sky": (*OF_SKY, *SCALES),
        "Receiver": RECEIVER,
        "Map to write": (
            text(
                "irradiance-map",
                "FILE",
                "Write the irradiances of receivers facing every direction as a latlong map "
                "(.hdr, .exr, .pfm).",
            ),
            choice(
                "order",
                ("2",),
                "Use spherical harmonics up to this order, instead of the exact sum over all "
                "pixels.",
            ),
            "size",
        ),
        "Radiant, luminous and photon quantities": (*LINKS, *symbols.REFINEMENTS),
    },
    texts={
        "toward": "Direction to where the light comes from, as POLAR (from +z), "
        "POLAR,AZIMUTH or X,Y,Z.",
        "aim": "Direction in the middle of the map (default: that of its file, else 1,0,0).",
        "normal": "Normal of the receiver (default 0,0,1: up).",
    },
    draws=True,
    takes_lines=False,
    like={"error": "irradiance"},
    examples=(
        "room.hdr unit=W/m2/sr",
        "room.exr unit=cd/m2 normal=1,0,0 toward=60deg,90deg",
        "ball.hdr projection=mirror-ball aim=0,-1,0 unit=1",
        "lens.exr projection=fisheye field=180deg aim=0,0,1 unit=cd/m2",
        "sky:overcast zenith-luminance=9000cd/m2 normal=1,0,0",
        "sky:12 sun-elevation=40deg sun-azimuth=0deg toward=0deg:90deg:15deg,90deg",
        "room.hdr unit=cd/m2 plot=room.png",
        "'3000*max(cos(theta), 0) cd/m2' steps=",
        "room.hdr unit=cd/m2 irradiance-map=lux.exr size=64x32",
    ),
    remarks="""
    SOURCE is a map of radiances (Radiance .hdr, OpenEXR .exr, .pfm), sky:TYPE with a type of
    radcalc sky, or an expression in theta (polar angle from +z, which is up) and phi (azimuth from
    +x towards +y).  An expression may end with a blank and a unit; otherwise it is relative.
    A direction always points to where the light comes from.  Radiances and irradiances may be
    in watts, lumens or photons: the unit decides.

    The middle of a map shows the direction {aim}.  The map is turned so that its upward direction
    is as close to +z as possible.  A 2:1 map is latlong.  A square map needs {projection}; a
    picture of a part of the sphere needs {projection} and {field}.  Neither is needed if the file
    has a VIEW= line of the program Radiance.  Few files state the unit of their values: give
    {unit}; with {unit} 1 every result is relative.
    Luminance is a weighted sum of R, G and B.  The weights follow from the primaries in the file,
    or from those of Rec. 709 if it has none.  With {unit} W/m2/sr the weights are those of the
    program Radiance, and a watt counts as 179 lm.
    """,
    mistakes=("all around",),
)

EVEN = 1 - 1e-9  # of the peak: a mean above it is the peak, up to rounding
SMALL = (64, 32)  # pixels of an irradiance map
# Formulas of derivations, and their sources.
IRRADIANCE = "E = integral of L max(n . s, 0) domega", "ISO 80000-7, irradiance"
BY_HARMONICS = (
    "E = sum of A_l L_lm Y_lm(n), l = 0, 1, 2, A_l = pi, 2 pi/3, pi/4",
    "Ramamoorthi and Hanrahan, SIGGRAPH 2001",
)
MEAN = "L_mean = integral of L domega / integral of domega"
IS_RELATIVE = (
    "the radiances are relative, and so are all results: radiances of 1 everywhere give an "
    "irradiance of pi sr"
)


class Source:
    """The source of the radiances, read once for all answers.

    `named` is the path of a map (with `is_path`), sky:TYPE, an expression with its unit, or a
    picture.
    """

    def __init__(self, named: "str | Picture", is_path: bool = False) -> None:
        self.named, self.is_path = named, is_path
        self.pictures: dict[str, Picture] = {}  # by channel
        self.environments: dict[tuple[Any, ...], Environment] = {}
        self.sums: dict[tuple[int, Vector], tuple[Integral, float, Peak]] = {}

    def environment(self, settings: Inputs, lit: kinds.LightInputs) -> "Environment":
        key = tuple((name, given.text) for name, given in settings.items())
        if key not in self.environments:
            self.environments[key] = self._read(settings, lit)
        return self.environments[key]

    def figures(self, radiances: "Radiances", normal: Vector) -> "tuple[Integral, float, Peak]":
        """Return irradiance, mean and peak, cached for a list of directions."""
        key = (id(radiances), normal)
        if key not in self.sums:
            self.sums[key] = radiances.irradiance(normal), radiances.mean(), radiances.peak()
        return self.sums[key]

    def _read(self, settings: Inputs, lit: kinds.LightInputs) -> "Environment":
        """Read the source, and refuse settings of other sources."""
        from radcalc.distributions import environments

        named = self.named
        if isinstance(named, str) and not self.is_path:
            if named.lower().startswith(SKY):
                _refuse_others(settings, (*OF_SKY, *SCALES), "a sky")
                return _sky(named.lower().removeprefix(SKY).strip(), settings, lit)
            if not environments.is_map(named):
                expression = environments.expression(named)
                _refuse_others(settings, (), "an expression")
                return expression
        _refuse_others(settings, OF_MAP, "a map")
        values = {name: given.value for name, given in settings.items()}
        if isinstance(named, str):
            named = self._picture(named, values.get("channel", ""))
        return environments.of_picture(named, **values)

    def _picture(self, path: str, channel: str) -> "Picture":
        from radcalc.distributions.maps.pictures import read_picture

        if channel not in self.pictures:
            self.pictures[channel] = read_picture(path, channel)
        return self.pictures[channel]


def _refuse_others(settings: Inputs, takes: tuple[str, ...], what: str) -> None:
    foreign = [item.name for name, item in settings.items() if name not in takes]
    if foreign:
        raise Unused(foreign, f"to {what}")


def _sky(name: str, settings: Inputs, lit: kinds.LightInputs) -> "Environment":
    """Return a sky by the name of its type, bright by `SCALES` or relative to its zenith."""
    from radcalc.calculators.sky import place_of_sun
    from radcalc.distributions.environments import Environment, Sky
    from radcalc.geometry.models import IS_EVEN, MISSING_AZIMUTH, sky_type

    sun: Any = None
    useless = [symbol_name for symbol_name in OF_SKY if symbol_name in settings]
    if not sky_type(name).follows_sun and useless:
        raise Unused(useless, IS_EVEN.format(name))
    if "sun-elevation" in settings:
        if "sun-azimuth" not in settings:
            raise MissingInput(*MISSING_AZIMUTH)
        sun = place_of_sun(settings)
    sky = Sky(name, sun)  # asks for the sun if it is missing
    assumptions = [f"sky {name}: {sky.type.name}; no light comes from below the horizon"]
    if sun:
        assumptions.append("the sky does not include the sun's disc")
    scale = at_most_one(settings, "the brightness of the sky", *SCALES)
    if scale is None:
        assumptions.append("the radiances are relative to the zenith's")
        return Environment(sky, assumptions=tuple(assumptions))
    zenith = lit.amounts[scale.symbol.generic]
    if scale.symbol.generic == "horizontal-irradiance":
        zenith = zenith / sky.irradiance(UP).value
    return Environment(Sky(name, sun, zenith, lit.kind), assumptions=tuple(assumptions))


def environment(source: Source, given: Inputs) -> Answer:
    """Return the irradiance of a receiver and the mean and peak radiance of its surroundings."""
    return _surroundings(source, given, RECEIVER).answer()


def surroundings(source: Source, given: Inputs) -> "Radiances":
    """Return the radiances; `given` as for `environment`."""
    return _surroundings(source, given, RECEIVER).environment.radiances


def irradiance_map(
    source: Source, given: Inputs, order: int | None = None, progress: "Progress | None" = None
) -> RenderedMap:
    """Return the irradiances of receivers that face in all directions, as a latlong map.

    `given` are the settings of `environment` without those of the receiver, and the map's size.
    """
    return _surroundings(source, given, ("size",)).irradiance_map(order, progress)


def _surroundings(source: Source, given: Inputs, more: tuple[str, ...]) -> "_Surroundings":
    quantities, links, rest = split_by_light(given)
    takes = (*OF_MAP, *OF_SKY, *SCALES, *more)
    refuse_foreign(rest, takes, "an environment")
    lit = kinds.read_light(quantities, links)
    refuse_foreign(lit.values, takes, "an environment")
    for item in given.values():
        if is_array(item.value):
            raise ConditionError(f"{option(item.name)} is an array", "one value at a time")
    settings = {name: item for name, item in rest.items() if name not in more}
    return _Surroundings(source, source.environment({**settings, **lit.values}, lit), lit, rest)


class _Surroundings:
    """Radiances of a kind, or relative ones, with their assumptions and notes."""

    def __init__(
        self, source: Source, environment: "Environment", lit: kinds.LightInputs, given: Inputs
    ) -> None:
        self.source = source
        self.environment, self.kind, self.given = environment, environment.radiances.kind, given
        links = lit.links
        self.assumptions, self.notes = [*environment.assumptions], [*environment.notes]
        if not self.kind:
            if links:
                raise Unused(tuple(links), "to relative radiances")
            self.assumptions.append(IS_RELATIVE)
        self.uses_own_efficacy = bool(environment.efficacy) and not set(LINKS) & set(links)
        if self.uses_own_efficacy:
            links = {**links, "efficacy": read("efficacy", f"{environment.efficacy:g} lm/W")}
        again = kinds.read_light({}, links)
        self.lit = again._replace(kind=self.kind, mixed=lit.mixed, kinds=lit.kinds)

    def answer(self) -> Answer:
        """Return irradiance, mean and peak, and the radiance of a direction."""
        given, radiances = self.given, self.environment.radiances
        normal = given["normal"].value if "normal" in given else UP
        if "normal" not in given:
            self.assumptions.append(Remark("the receiver faces up", ["irradiance"]))
        irradiance, mean, peak = self.source.figures(radiances, normal)
        amounts = {
            "irradiance": irradiance.value,
            "mean-radiance": mean,
            "peak-radiance": peak.value,
        }
        self._note_share(normal)
        if "toward" in given:
            if not radiances.is_axial:
                require_azimuth(given["toward"], "the radiance depends on it")
            amounts["radiance-toward"] = float(radiances.radiance(*given["toward"].value))
        results = self._show_light(amounts)
        ends = [
            value("peak-polar", peak.polar, letter="θ_max"),
            value("peak-azimuth", peak.azimuth, letter="φ_max"),
        ]
        if not peak.value:
            self.notes.append("the sampled directions have no light")
            dark = "there is no light", "a map, a sky or an expression that has some"
            ends = [absent("peak-polar", *dark), absent("peak-azimuth", *dark)]
        elif mean > peak.value * EVEN:
            self.notes.append("the radiance is the same in all covered directions")
            even = "the radiance is the same in all directions", "peak-radiance"
            ends = [absent("peak-polar", *even), absent("peak-azimuth", *even)]
        values = [*results.values["irradiance"], *results.values["mean-radiance"]]
        values += [*results.values["peak-radiance"], *ends]
        values += results.values.get("radiance-toward") or [
            absent("radiance-toward", "no direction is given", option("toward", "60deg,90deg"))
        ]
        if "toward" in given:  # identifies each answer of a list
            polar, azimuth = given["toward"].value
            values.append(value("polar", polar, label="polar angle of that direction"))
            if "," in given["toward"].text:
                values.append(value("azimuth", azimuth, label="azimuth of that direction"))
        values.append(value("coverage", radiances.coverage))
        if irradiance.error:
            values.append(self._error(irradiance.error))
        steps = [*self._steps(normal, irradiance.value, mean), *results.steps]
        return Answer(
            values, (*self.assumptions, *results.assumptions), (*self.notes, *results.notes), steps
        )

    def _note_share(self, normal: Vector) -> None:
        """Note how much of what the receiver faces is in the map, if it is not the whole sphere."""
        seen = getattr(self.environment.radiances, "seen", None)
        if seen and self.environment.radiances.coverage < 1:
            share = f"{round(100 * seen(normal), 1):g} %"
            self.notes.append(f"it covers {share} of the receiver's hemisphere, by cosine")

    def irradiance_map(self, order: int | None, progress: "Progress | None") -> RenderedMap:
        """Return the map, with notes on the errors of its order."""
        from radcalc.distributions.maps.rendered import DIRECTIONS, irradiance_map

        size = self._size()
        result = irradiance_map(self._map(), *size, order, progress)
        if order:
            self.notes.append(
                f"spherical harmonics up to order {order}: compared to the exact sum in "
                f"{DIRECTIONS} directions, the error is up to {100 * result.largest:.2g} % of the "
                f"largest irradiance, {100 * result.rms:.2g} % root mean square"
            )
            if result.raised:
                self.notes.append(
                    f"the harmonics are below 0 in {result.raised} pixels, by up to "
                    f"{100 * result.deepest:.2g} % of the largest irradiance; these pixels are 0"
                )
        formula, reference = BY_HARMONICS if order else IRRADIANCE
        numbers = "n = the direction of the middle of a pixel"
        step = Step("irradiance of each receiver", formula, numbers, reference)
        return self._render(result.pixels, step)

    def _size(self) -> tuple[int, int]:
        """Return the size of the irradiance map [pixels]."""
        from radcalc.calculators.pixel import refuse_shape
        from radcalc.distributions.maps import check_shape
        from radcalc.distributions.maps.pictures import check_size

        if "size" not in self.given:
            return SMALL
        width, height = self.given["size"].value
        refuse_shape(self.given["size"], LATLONG)
        check_shape(LATLONG, width, height)
        check_size(width, height, "the map")
        return width, height

    def _map(self) -> "RadianceMap":
        from radcalc.distributions import environments
        from radcalc.distributions.maps import RadianceMap
        from radcalc.geometry.projections import USUAL_SIZE

        if isinstance(self.environment.radiances, RadianceMap):
            return self.environment.radiances
        width, height = USUAL_SIZE
        self.assumptions.append(
            f"sampled at the middles of {width} x {height} pixels of a {LATLONG} map"
        )
        return environments.sampled(self.environment.radiances, width, height)

    def _render(self, values: Any, step: Step) -> RenderedMap:
        """Return a latlong picture of irradiances [SI], with its extremes as results."""
        from radcalc.distributions.maps.pictures import Picture, as_floats

        unit, label = "sr", "relative irradiance"
        if self.kind:
            unit = symbols.light_unit("irradiance", self.kind)
            label = symbols.specific_name("irradiance", self.kind).replace("-", " ")
        pixels = values / float(resolve(unit).factor)
        floats = as_floats(pixels, unit)
        height, width, _ = pixels.shape
        sums = values @ self.environment.weights
        ends = {
            "minimum-irradiance": float(sums.min()),
            "maximum-irradiance": float(sums.max()),
        }
        results = self._show_light(ends)
        picture = Picture(
            floats, self.environment.channels, self.environment.weights, "", unit, LATLONG
        )
        answer = Answer(
            [row for end in ends for row in results.values[end]],
            (*self.assumptions, *results.assumptions),
            (*self.notes, *results.notes),
            [*self._weighting(), step, *results.steps],
        )
        what = f"a {LATLONG} map of {width} x {height} pixels, of {label} in {unit}"
        return RenderedMap(picture, pixels, unit, what, answer)

    def _show_light(self, amounts: dict[str, float]) -> kinds.LightResults:
        if not self.kind:
            rows = {name: [_relative(name, amount)] for name, amount in amounts.items()}
            return kinds.LightResults(rows, (), (), ())
        results = kinds.show_light(self.lit, amounts)
        if self.uses_own_efficacy:
            assumption = (
                f"a watt counts as {self.environment.efficacy:g} lm, as in Radiance "
                f"({options(LINKS)} for another light)"
            )
            others = [kind for kind in KINDS if kind != self.kind]
            return results._replace(assumptions=(Remark(assumption, others),), notes=())
        return results

    def _format(self, name: str, amount: float) -> str:
        relative = _relative(name, amount).units[0]
        unit = symbols.light_unit(name, self.kind, coherent=True) if self.kind else relative
        return format_value(amount, unit)

    def _error(self, error: float) -> Value:
        row = self._show_light({"irradiance": error}).values["irradiance"][0]
        return value("error", error, *row.units, label="estimate of the error")._replace(
            dimensions=row.dimensions
        )

    def _steps(self, normal: Any, irradiance: float, mean: float) -> Iterator[Step]:
        yield from self._weighting()
        facing = ",".join(map(format_number, normal))
        numbers = f"n = {facing}; E = {self._format('irradiance', irradiance)}"
        yield Step("irradiance of a receiver", IRRADIANCE[0], numbers, IRRADIANCE[1])
        numbers = f"L_mean = {self._format('mean-radiance', mean)}"
        yield Step("mean radiance", MEAN, numbers)

    def _weighting(self) -> Iterator[Step]:
        if self.environment.luminance:
            yield Step(
                "radiance of a pixel", "", self.environment.luminance, self.environment.reference
            )


def _relative(name: str, amount: float) -> Value:
    symbol = symbols.SYMBOLS[name]
    is_radiance = symbol.geometry == symbols.SYMBOLS["radiance"].geometry
    dimension, unit = (NUMBER, "1") if is_radiance else (SOLID_ANGLE, "sr")
    return value(name, amount, unit, label=f"relative {symbol.label}")._replace(
        dimensions=(dimension,)
    )
