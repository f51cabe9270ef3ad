"""A small source of any distribution: of a file or an expression, or one that is aimed.

What `radcalc.calculators.point_source` answers for a distribution that is a function of direction.
"""

import math
from collections.abc import Iterator
from functools import lru_cache, reduce
from typing import TYPE_CHECKING, Any, NamedTuple

from radcalc.answer import Answer, Step, Value
from radcalc.calculators import light
from radcalc.calculators.point_source import (
    ASSUMED,
    DIRECTED,
    FLAGS,
    LYING,
    POSITION,
    QUANTITIES,
    RECEIVER,
    SHAPED,
    compare_mean,
    know_hemisphere,
    refuse_light_of_surfaces,
    require_height,
    solve,
    spread,
)
from radcalc.calculators.results import LINKS_HINT, absent, value
from radcalc.calculators.worksheet import OFFSETS, Page, Worksheet
from radcalc.derivation import format_angle, format_number, format_value
from radcalc.errors import (
    ConditionError,
    Exclusive,
    MissingInput,
    Unused,
    mention,
    option,
    options,
    quote,
)
from radcalc.geometry import far_field
from radcalc.given import Inputs, angle_of, offset_of
from radcalc.laws import luminaire as laws_of
from radcalc.laws.law import AnyLaw
from radcalc.laws.point import CONICAL, LAWS, LOBED
from radcalc.laws.sizes import OFFSET
from radcalc.laws.solver import Disagreement, reached
from radcalc.laws.solver import solve as follow
from radcalc.maths import any_true, atan2, hypot, is_array
from radcalc.quantities.light import LUMINOUS
from radcalc.quantities.symbols import light_unit

if TYPE_CHECKING:
    from radcalc.distributions.beams import Beam
    from radcalc.distributions.distribution import Peak
    from radcalc.distributions.photometry import Photometry
    from radcalc.geometry.numerics.cubature import Integral

LIGHT = (
    "intensity",
    "peak-intensity",
    "intensity-toward",
    "flux",
    "upward-flux",
    "downward-flux",
    "irradiance",
    "exposure",
    "energy",
    "received-flux",
    "flux-within",
)
SCALING = ("peak-intensity", *QUANTITIES)
PAGE = Page(
    "a point source",
    (*QUANTITIES, *POSITION, *RECEIVER, "distribution", *FLAGS, *DIRECTED),
    LIGHT,
    (*POSITION, "off-axis", "azimuth", "beam-diameter", *RECEIVER),
)
EXPRESSION = "expression"  # the format of what is typed
BEAMS = (("beam-angle", 0.5, "a half"), ("field-angle", 0.1, "a tenth"))
PLANES = (("", 0.0), ("-90", math.pi / 2))


def luminaire(given: Inputs, is_aside: bool, any_incidence: bool) -> Answer:
    """What follows for a receiver below the source or in a direction, or aside of it."""
    return _Luminaire(given, is_aside, any_incidence).answer()


class Figures(NamedTuple):
    """What a distribution is in numbers, relative to its own unit of intensity.

    The flux is a refusal where it cannot be told.
    """

    axial: float
    peak: "Peak"
    flux: "Integral | ConditionError"


@lru_cache(maxsize=8)
def _figures(distribution: Any) -> Figures:
    """The figures of a distribution, once for all answers of a list."""
    flux: Integral | ConditionError
    try:
        flux = distribution.flux()
    except ConditionError as error:
        flux = error
    return Figures(float(distribution.intensity(0.0, 0.0)), distribution.peak(), flux)


@lru_cache(maxsize=32)
def _beam(distribution: Any, azimuth: float, share: float) -> "Beam":
    from radcalc.distributions.beams import beam

    return beam(distribution, azimuth, share)


@lru_cache(maxsize=8)
def _upward(
    distribution: Any, whole: "Integral", aim: tuple[float, float, float], rotate: float
) -> float:
    """Flux into the upper half of the world, of that in all directions."""
    from radcalc.distributions.places import upward_flux
    from radcalc.distributions.pose import Pose

    return upward_flux(distribution, Pose(aim, rotate), whole).value


class _Luminaire:
    """One attempt at an answer: the source, how it stands, and the worksheet."""

    def __init__(self, given: Inputs, is_aside: bool, any_incidence: bool) -> None:
        from radcalc.distributions.pose import DOWN, Pose

        self.given, self.is_aside, self.any_incidence = given, is_aside, any_incidence
        _refuse_idle(given)
        shape = spread(given)  # which refuses inputs of another distribution
        chosen: Any = given["distribution"].value if "distribution" in given else shape
        self.of_shape = isinstance(chosen, str)
        kind = "" if self.of_shape else chosen.distribution.kind
        shaped = SHAPED[shape] if self.of_shape else ()
        page = PAGE._replace(takes=(*PAGE.takes, *shaped), others=(*PAGE.others, *shaped))
        self.sheet = Worksheet(page, given, preferred=kind)
        self.sheet.takes = (*SCALING, *shaped, *POSITION, *RECEIVER)
        self.sheet.defaults.add("incidence")
        refuse_light_of_surfaces(self.sheet.lit, SCALING)
        know_hemisphere(self.sheet)
        self.photometry: Photometry = self._shaped(shape) if self.of_shape else chosen
        source: Any = self.photometry.distribution
        self.source, self.figures = source, _figures(source)
        self.aim = given["aim"].value if "aim" in given else DOWN
        self.rotate = given["rotate"].value if "rotate" in given else 0.0
        if is_array(self.rotate):
            raise _one_at_a_time("rotate")
        self.pose = Pose(self.aim, self.rotate)
        self.sheet.use("rotate")
        self.is_turned = False  # the receiver, nobody says about which axis
        self.is_scaled = True

    def _shaped(self, shape: str) -> "Photometry":
        """An isotropic source, a cone or a lobe as a function of direction."""
        from radcalc.distributions import shapes
        from radcalc.distributions.photometry import Photometry

        if shape not in (CONICAL, LOBED):
            return Photometry(shapes.Isotropic(), shape)
        name = "half-angle" if shape == CONICAL else "exponent"
        known = dict(self.sheet.known)
        if "peak-intensity" in known:
            known.setdefault("intensity", known["peak-intensity"])
        try:
            found = follow(LAWS[shape], known).values
        except Disagreement as error:
            raise self.sheet.contradiction(error, {}) from None
        if name not in found:
            raise MissingInput(f"how wide the {shape} is, is missing", options(SHAPED[shape]))
        width = found[name].value
        self.sheet.known = {
            n: one for n, one in found.items() if n in SHAPED[shape]
        } | self.sheet.known
        self.sheet.use(*SHAPED[shape])
        if is_array(width):
            raise _one_at_a_time(next(n for n in SHAPED[shape] if n in self.given))
        return Photometry(shapes.of_shape(shape, width), shape)

    def answer(self) -> Answer:
        """Everything that follows."""
        sheet = self.sheet
        laws = [*laws_of.LAWS]
        self._know_figures(laws)
        laws += self._places()
        self._know_scale(laws)
        is_flat = laws_of.FLAT in laws
        if is_flat and not {"height", "lateral"} <= reached(laws, {*sheet.known, "incidence"}):
            laws.append(laws_of.floor(self.source, self.pose, self.bearing))
        solve(sheet, laws, self.any_incidence, is_flat)
        if self.is_aside:
            require_height(sheet)
        answers = [self._told(one, laws) for one in sheet.each()]
        return answers[0]._replace(more=tuple(answers[1:]))

    # -- what is known ------------------------------------------------------------------------

    def _know_figures(self, laws: list[AnyLaw]) -> None:
        """The figures of the distribution, by the symbols of the laws."""
        sheet, flux = self.sheet, self.figures.flux
        sheet.know("relative-axial-intensity", self.figures.axial)
        sheet.know("relative-peak-intensity", self.figures.peak.value)
        if self.figures.axial == 0 and "intensity" in sheet.lit.values:
            name = option(sheet.lit.values["intensity"].name)
            raise ConditionError(
                f"{name} is that on the axis, where this distribution has none",
                mention("{flux} or {peak-intensity} in its place"),
            )
        if isinstance(flux, ConditionError):
            if {"flux", "energy"} & set(sheet.lit.values):
                raise flux
            sheet.notes.append(f"no flux: {flux.message}")
            return
        if not flux.value:
            dark = "the distribution has no intensity in any direction that was looked at"
            raise ConditionError(
                "; ".join((dark, *self.photometry.assumptions)),
                "a wider one, or a table of its angles and intensities",
            )
        sheet.know("weighted-solid-angle", flux.value)
        unit = "sr, with f in units of the scale"
        sheet.placed.append(
            Step(
                "integral of the distribution",
                "Omega_f = integral of f sin(gamma) dgamma dC",
                f"Omega_f = {format_number(flux.value)} {unit}",
            )
        )
        try:
            upward = _upward(self.source, flux, self.aim, self.rotate)
            sheet.know("upward-part", upward / flux.value)
        except ConditionError as error:
            sheet.notes.append(f"no flux upwards or downwards: {error.message}")
        laws.append(laws_of.part(self.source, flux.value))

    def _know_scale(self, laws: list[AnyLaw]) -> None:
        """The scale is 1 for a source as it is, unless a light quantity tells another."""
        sheet, own = self.sheet, self.source.kind
        if not sheet.lit.values and not own:
            raise MissingInput(
                "the distribution is relative, and what scales it is missing",
                mention("{flux}, {intensity} or {peak-intensity}") + self._unit_hint,
            )
        known = {*sheet.known, *(() if self.any_incidence else sheet.defaults)}
        asks_place = self._asks_place and sheet.lit.kind == own
        if not own or ("scale" in reached(laws, known) and not asks_place):
            return
        if sheet.lit.kind != own:
            name = option(next(iter(sheet.lit.values.values())).name)
            raise MissingInput(
                f"the distribution is in {light_unit('intensity', own)}, {name} of another kind: "
                "what links them is missing",
                LINKS_HINT,
            )
        sheet.know("scale", 1.0)
        self.is_scaled = False

    @property
    def _unit_hint(self) -> str:
        """Where a unit would make a distribution absolute."""
        if self.of_shape:
            return ""
        if self.photometry.format == EXPRESSION:
            return ", or a unit behind the expression, such as cd"
        return ", or a unit in the titles of the file, as in I (cd)"

    @property
    def _asks_place(self) -> bool:
        """Whether an irradiance asks for the offset of a source that is taken as it is."""
        strength = {"flux", "intensity", "peak-intensity", "energy"} & set(self.sheet.lit.values)
        placed = {"distance", *OFFSETS} & set(self.given)
        return bool(self.sheet.lit.values) and "height" in self.given and not strength | placed

    # -- where the receiver is ------------------------------------------------------------------

    def _places(self) -> list[AnyLaw]:
        """The laws of the receiver's place."""
        sheet, given = self.sheet, self.given
        self.bearing = 0.0
        if "incidence" in given:
            sheet.know("incidence", angle_of(given, "incidence"), given["incidence"])
        own: list[AnyLaw] = [laws_of.relative_intensity(self.source)]
        if self.is_aside or "height" in given:
            own += self._below()
        else:
            polar, azimuth = given["toward"].value if "toward" in given else (0.0, 0.0)
            sheet.know("off-axis", polar)
            sheet.know("azimuth", azimuth)
            if "toward" not in given:
                hidden = ("intensity-toward", "off-axis", "azimuth")
                sheet.page = sheet.page._replace(
                    light=_without(sheet.page.light, hidden),
                    others=_without(sheet.page.others, hidden),
                )
        if "time" not in given:
            own.append(laws_of.TOWARD_OF_ENERGY)
        if "receiver-area" in given:
            own.append(self._receiver(laws_of.FLAT in own))
        edges = _beam(self.source, 0.0, 0.5).edges if self._away else None
        if edges and max(map(abs, edges)) < math.pi / 2:
            own.append(laws_of.beam_diameter(edges, self._away))
        return own

    def _below(self) -> list[AnyLaw]:
        """The laws of a receiver at a height and an offset."""
        sheet, given = self.sheet, self.given
        aside = [given[name] for name in OFFSETS if name in given]
        if aside:
            self.bearing = atan2(offset_of(given, "offset-y"), offset_of(given))
            sheet.know("lateral", reduce(hypot, (one.value for one in aside), 0.0), *aside)
        elif not self.is_aside:
            sheet.know("lateral", 0.0)
        own = laws_of.direction(self.pose, self.bearing)
        if self.is_aside and not aside:
            own.append(OFFSET)
        if "incidence" not in given:
            own.append(laws_of.FLAT)
        if "aim" in given:
            sheet.assume(
                f"aimed at {quote(given['aim'].text)}; heights and offsets are counted from the "
                "vertical through the source"
            )
            if "incidence" not in given:
                sheet.assume("the receiver lies flat")
        else:
            sheet.assume("the source points straight down")
            if "incidence" not in given:
                sheet.assume(LYING)
        if not self.source.is_axial or "rotate" in given:
            sheet.assume(
                "an offset is towards C0, an offset along y towards C90"
                if not self.rotate
                else f"C0 is turned by {format_angle(self.rotate)} from x towards y"
            )
        return own

    @property
    def _away(self) -> str:
        """What tells how far along the axis the receiver is; nothing where it is elsewhere."""
        if self.is_aside or "height" in self.given:
            return "" if "aim" in self.given else "height"
        return "" if "toward" in self.given else "distance"

    def _receiver(self, is_flat: bool) -> AnyLaw:
        """The law of what the receiver gets."""
        if is_flat:
            return laws_of.lying_disc(self.source, self.pose, self.bearing)
        self.is_turned = self.any_incidence or any_true(angle_of(self.given, "incidence") != 0)
        if self.is_turned:
            return laws_of.SMALL
        return laws_of.facing_disc(self.source)

    # -- what is said of it ---------------------------------------------------------------------

    def _told(self, sheet: Worksheet, laws: list[AnyLaw]) -> Answer:
        """The answer, with what is to be said of it."""
        before = list(sheet.assumptions)
        sheet.assumptions = [*self._named(), *self.photometry.assumptions]
        sheet.notes += self.photometry.notes
        if self.is_scaled:
            self._say_scale(sheet)
        sheet.assumptions += before
        if sheet.lit.links and not self.of_shape:
            sheet.assume("the same spectrum in every direction")
        sheet.note_behind()
        fall = sheet.at("relative-intensity") if sheet.has("relative-intensity") else 1.0
        if sheet.has("irradiance") and any_true(fall == 0):
            sheet.notes.append("the source is dark in the direction of the receiver")
        if sheet.has("received-flux"):
            self._judge_receiver(sheet)
        size = self.photometry.size
        if size and sheet.has("distance") and far_field.is_near(sheet.at("distance"), size):
            sheet.notes.append(
                f"what shines is {format_value(size, 'm')} long: nearer than five times that the "
                "inverse square does not hold"
            )
        facts = [*self._facts(sheet)]
        answer = sheet.answer(laws)
        lit = {name: k for k, name in enumerate(LIGHT)}
        cut = sum(1 for one in answer.values if not one.is_absent and _generic(one) in lit)
        values = [*answer.values[:cut], *facts, *answer.values[cut:]]
        return answer._replace(values=values)

    def _named(self) -> Iterator[str]:
        """What the distribution is."""
        found = self.photometry
        if self.of_shape:
            yield ASSUMED[found.format].partition(";")[0]
        elif found.format == EXPRESSION:
            yield f"the intensity is {quote(found.name)}, with theta from the source's axis"
        else:
            yield f"distribution: {found.format}" + f": {quote(found.name)}" * bool(found.name)

    def _say_scale(self, sheet: Worksheet) -> None:
        """By what the distribution is multiplied, and what that makes void."""
        if not self.source.kind:
            return
        if sheet.lit.kind == self.source.kind:
            times = (
                format_number(sheet.at("scale")) if sheet.has("scale") else "as much as it takes"
            )
            sheet.assume(f"scaled: {times} times the intensities of the distribution")
        else:
            sheet.assume("scaled: of the distribution the shape alone counts")
        if self.photometry.declared:
            sheet.assume("what is declared of its lamps and watts holds no longer")

    def _judge_receiver(self, sheet: Worksheet) -> None:
        """What is assumed of the receiver, and how well its flux is known."""
        sheet.assume("the receiver is a disc of that area")
        if self.is_turned:
            self._refuse_uneven(sheet)
        compare_mean(sheet)

    def _refuse_uneven(self, sheet: Worksheet) -> None:
        """A receiver that is turned, nobody says about which axis, has to be evenly lit."""
        from radcalc.distributions.places import unevenness
        from radcalc.geometry.receivers import UNEVEN

        radius = (sheet.at("receiver-area") / math.pi) ** 0.5
        place = (sheet.at(name) for name in ("distance", "off-axis", "azimuth"))
        uneven = unevenness(self.source, radius, *place)
        if uneven > UNEVEN:
            raise ConditionError(
                f"the light varies by {format_number(100 * uneven, 2)} % over that receiver, and "
                "nobody tells about which axis it is turned",
                mention("a smaller {receiver-area}, or the same without {incidence}"),
            )
        sheet.assume(f"the light on it is even, within {format_number(100 * uneven, 2)} %")

    # -- facts about the source -----------------------------------------------------------------

    def _facts(self, sheet: Worksheet) -> Iterator[Value]:
        """What is known of the distribution beside its light."""
        flux = self.figures.flux
        if isinstance(flux, ConditionError):
            yield absent("flux", flux.message, flux.hint)
        elif not self.of_shape and sheet.has("flux"):
            yield self._error(sheet, flux)
        yield value("peak-polar", self.figures.peak.polar)
        yield value("peak-azimuth", self.figures.peak.azimuth)
        for name, share, said in BEAMS:
            for suffix, azimuth in PLANES:
                if name + suffix not in sheet.known:
                    yield self._width(sheet, name + suffix, azimuth, share, said)
        yield from self._declared(sheet)

    def _error(self, sheet: Worksheet, flux: "Integral") -> Value:
        """How far the flux may be off, by how it was integrated."""
        kind = sheet.lit.kind
        if zonal := getattr(self.source, "zonal_flux", None):
            part = zonal() / flux.value
            if not is_array(sheet.at("flux")):
                size = format_value(sheet.at("flux") * part, light_unit("flux", kind))
                sheet.assume(
                    "the flux is exact for intensities that are linear between the table's "
                    f"angles; the zonal method gives {size} ({100 * (part - 1):+.2g} %)"
                )
        return value("error", sheet.at("flux") * flux.error / flux.value)._replace(
            label="estimate of the flux's error",
            dimensions=(light.dimension("flux", kind),),
            units=(light_unit("flux", kind),),
        )

    def _width(self, sheet: Worksheet, name: str, azimuth: float, share: float, said: str) -> Value:
        """A beam angle or a field angle in a plane, and what is to be said of it."""
        beam = _beam(self.source, 0.0 if self.source.is_axial else azimuth, share)
        if beam.outermost is None:
            return absent(
                name,
                f"there is no edge at which {said} of the plane's greatest intensity is left",
                mention("{within}, and the flux within it"),
            )
        sheet.assume(
            "beam and field angles: between the outermost directions in which the plane has a "
            "half and a tenth of its greatest intensity"
        )
        found = value(name, beam.outermost)
        if beam.is_ambiguous and not (azimuth and self.source.is_axial):
            other = "there is none"
            if beam.from_axis is not None:
                other = f"it is {format_angle(beam.from_axis)}"
            sheet.notes.append(
                f"the {found.label} is ambiguous: counted from the axis, to {said} of the "
                f"intensity on it, {other}"
            )
        return found

    def _declared(self, sheet: Worksheet) -> Iterator[Value]:
        """What a file declares; nothing of what is scaled."""
        declared = {} if self.is_scaled else self.photometry.declared
        flux = sheet.at("flux") if sheet.has("flux") else None
        lamps, watts = declared.get("lamp-flux"), declared.get("input-power")
        found = {
            "output-ratio": flux / lamps if flux is not None and lamps else None,
            "input-power": watts,
            "source-efficacy": flux / watts
            if flux is not None and watts and sheet.lit.kind == LUMINOUS
            else None,
        }
        for name, own in found.items():
            if own is None:
                yield absent(name, *self._not_declared)
            else:
                yield value(name, own)

    @property
    def _not_declared(self) -> tuple[str, str]:
        """Why there is nothing to be declared of the lamps, and what to do."""
        if self.photometry.declared and self.is_scaled:
            scaling = options([one.name for one in self.sheet.lit.values.values()], " and ")
            problem = "the light is scaled, and what is declared of its lamps holds no longer"
            return problem, f"the same without {scaling}"
        return "nothing declares it", "a file that tells the flux of its lamps and the watts"


def _refuse_idle(given: Inputs) -> None:
    """Refuse what has no use beside each other: places in two ways, turns without a place."""
    placed = next((name for name in ("height", *OFFSETS) if name in given), None)
    if "toward" in given and placed:
        raise Exclusive(
            ("toward", placed), "contradict each other: both tell where the receiver is"
        )
    if "rotate" in given and not placed and "aim" not in given:
        raise Unused(
            ("rotate",), "without a receiver aside", mention("{height=3m} and {offset=1m} with it")
        )


def _one_at_a_time(name: str) -> ConditionError:
    return ConditionError(
        f"{option(name)} is a long range, and a source has one", "a list of at most 1000 values"
    )


def _without(names: tuple[str, ...], *others: Any) -> tuple[str, ...]:
    hidden = set().union(*others)
    return tuple(name for name in names if name not in hidden)


def _generic(one: Value) -> str:
    from radcalc.quantities.symbols import SYMBOLS

    return SYMBOLS[one.name].generic if one.name in SYMBOLS else one.name.removeprefix("radiant-")
