"""What surrounds a place: a map of radiances, a sky, an expression; what a receiver gets of it."""

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from radcalc.answer import Answer, Step, Value
from radcalc.calculators import light
from radcalc.calculators.results import absent, value
from radcalc.calculators.worksheet import refuse_foreign
from radcalc.derivation import format_number, format_value
from radcalc.errors import ConditionError, MissingInput, Unused, mention, option, options
from radcalc.given import Inputs, at_most_one, read, sort
from radcalc.maths import is_array
from radcalc.quantities.symbols import LINKS, SYMBOLS, light_unit
from radcalc.units.dimensions import SOLID_ANGLE
from radcalc.units.table import NUMBER

if TYPE_CHECKING:
    from radcalc.distributions.environments import Environment
    from radcalc.distributions.maps.pictures import Picture

UP = (0.0, 0.0, 1.0)
SKY = "sky:"  # before the type of a sky
OF_MAP = ("unit", "projection", "aim", "channel")
OF_SKY = ("sun-elevation", "sun-azimuth")
SCALES = ("zenith-radiance", "horizontal-irradiance")
RECEIVER = ("normal", "toward")
IS_RELATIVE = (
    "the radiances are relative, and so is every result: where they are 1 everywhere, the "
    "irradiance is pi sr"
)


class Source:
    """What a user named, read once for all answers about it.

    `named` is the path of a map, sky:TYPE, an expression with its unit, or a picture.
    """

    def __init__(self, named: "str | Picture") -> None:
        self.named = named
        self.found: dict[tuple[Any, ...], Environment] = {}

    def environment(self, given: Inputs, lit: light.Lit) -> "Environment":
        """The radiances, by those of the inputs that are about them."""
        own = {name: one for name, one in given.items() if name not in RECEIVER}
        own |= lit.values
        key = tuple((name, one.text) for name, one in own.items())
        if key not in self.found:
            self.found[key] = self._read(own, lit)
        return self.found[key]

    def _read(self, own: Inputs, lit: light.Lit) -> "Environment":
        from radcalc.distributions import environments

        named = self.named
        if isinstance(named, str) and named.startswith(SKY):
            _refuse_others(own, (*OF_SKY, *SCALES), "a sky")
            return _sky(named.removeprefix(SKY).strip().lower(), own, lit)
        if isinstance(named, str) and not environments.is_map(named):
            _refuse_others(own, (), "an expression")
            return environments.expression(named)
        _refuse_others(own, OF_MAP, "a map")
        given = {name: one.value for name, one in own.items()}
        return environments.of_picture(self.picture(), **given)

    def picture(self) -> "Picture":
        """The picture of a map, which is read once."""
        from radcalc.distributions.maps.pictures import read_picture

        if isinstance(self.named, str):
            self.named = read_picture(self.named)
        return self.named


def _refuse_others(own: Inputs, takes: tuple[str, ...], what: str) -> None:
    """Refuse what is about another source."""
    others = [one.name for name, one in own.items() if name not in takes]
    if others:
        raise Unused(others, f"with {what}")


def _sky(name: str, own: Inputs, lit: light.Lit) -> "Environment":
    """A sky, scaled by what is given or relative to its zenith."""
    from radcalc.distributions.environments import Environment
    from radcalc.distributions.sky import Sky
    from radcalc.geometry.sky import sky_type

    sun = None
    useless = [one for one in OF_SKY if one in own]
    if not sky_type(name).follows_sun and useless:
        raise Unused(useless, f"with the sky {name}, which is the same at every azimuth")
    if "sun-elevation" in own:
        if "sun-azimuth" not in own:
            raise MissingInput("the sun's azimuth is missing", mention("{sun-azimuth=180deg}"))
        sun = (math.pi / 2 - own["sun-elevation"].value, own["sun-azimuth"].value)
    sky = Sky(name, sun)  # which asks for the sun where it is missing
    said = [f"sky {name}: {sky.type.name}; below the horizon it is dark"]
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
    quantities, links, rest = sort(given)
    takes = (*OF_MAP, *OF_SKY, *SCALES, *RECEIVER)
    refuse_foreign(rest, takes, "an environment")
    lit = light.read_light(quantities, links)
    refuse_foreign(lit.values, takes, "an environment")
    for one in given.values():
        if is_array(one.value):
            raise ConditionError(f"{option(one.name)} is an array", "one value at a time")
    found = source.environment(rest, lit)
    return _Surroundings(found, lit).answer(rest)


class _Surroundings:
    """Radiances, in their kind or in none, and what is said of them."""

    def __init__(self, found: "Environment", lit: light.Lit) -> None:
        self.found, self.kind = found, found.radiances.kind
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

    def answer(self, given: Inputs) -> Answer:
        """The irradiance, the mean, the peak, and the radiance from a direction."""
        radiances = self.found.radiances
        normal = given["normal"].value if "normal" in given else UP
        if "normal" not in given:
            self.assumptions.append("the receiver faces up")
        irradiance, peak, mean = radiances.irradiance(normal), radiances.peak(), radiances.mean()
        found = {"irradiance": irradiance.value, "mean-radiance": mean, "peak-radiance": peak.value}
        if "toward" in given:
            found["radiance-toward"] = float(radiances.radiance(*given["toward"].value))
        shown = self._shown(found)
        ends = [value("peak-polar", peak.polar), value("peak-azimuth", peak.azimuth)]
        if not peak.value:
            self.notes.append("there is no light from any direction that was looked at")
            dark = "there is no light", "a map, a sky or an expression that has some"
            ends = [absent("peak-polar", *dark), absent("peak-azimuth", *dark)]
        values = [*shown.values["irradiance"], *shown.values["mean-radiance"]]
        values += [*shown.values["peak-radiance"], *ends]
        values += shown.values.get("radiance-toward") or [
            absent("radiance-toward", "no direction is given", option("toward", "60deg,90deg"))
        ]
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
        return value(
            "error", error, *row.units, label="estimate of the irradiance's error"
        )._replace(dimensions=row.dimensions)

    def _steps(self, normal: Any, irradiance: float, mean: float) -> Iterator[Step]:
        """How the numbers follow."""
        if self.found.luminance:
            yield Step("radiance of a pixel", "", self.found.luminance, self.found.reference)
        facing = ",".join(map(format_number, normal))
        yield Step(
            "irradiance of a receiver",
            "E = integral of L max(n . s, 0) domega",
            f"n = {facing}; E = {self._told('irradiance', irradiance)}",
            "ISO 80000-7, irradiance",
        )
        formula = "L_mean = integral of L domega / integral of domega"
        yield Step("mean radiance", formula, f"L_mean = {self._told('mean-radiance', mean)}")


def _relative(name: str, amount: float) -> Value:
    """A light quantity of relative radiances."""
    symbol = SYMBOLS[name]
    is_radiance = symbol.geometry == SYMBOLS["radiance"].geometry
    own, unit = (NUMBER, "1") if is_radiance else (SOLID_ANGLE, "sr")
    return value(name, amount, unit, label=f"relative {symbol.label}")._replace(dimensions=(own,))
