"""A point source with any distribution: of a file or an expression, or an aimed one."""

import math
from collections.abc import Iterator
from functools import lru_cache
from typing import TYPE_CHECKING, Any, NamedTuple

from radcalc import errors, geometry
from radcalc.answer import Answer, Step, Value, format_angle, format_number, format_value
from radcalc.calculators import kinds
from radcalc.calculators.page import Page
from radcalc.calculators.point_laws import (
    ASSUMED,
    DIRECTED,
    FLAGS,
    LYING,
    ON_AXIS,
    ON_DIRECTION,
    ON_RECEIVER,
    POSITION,
    QUANTITIES,
    RECEIVER,
    SHAPED,
    compare_mean,
    lies_at_incidence,
    place_at_incidence,
    place_hemisphere,
    place_incidence,
    place_offsets,
    refuse_light_of_surfaces,
    require_height,
    solve_facing,
    spread,
)
from radcalc.calculators.results import LINKS_HINT, MISSING_LINK, absent, value
from radcalc.calculators.solved import Solved, contradiction, remarks_on
from radcalc.calculators.worksheet import OFFSETS, Placed, worksheet
from radcalc.errors import option, quote
from radcalc.inputs import Inputs, angle_of, offset_of
from radcalc.laws import OFFSET, AnyLaw
from radcalc.laws import beams as laws_of
from radcalc.laws.point import CONICAL, COSINE_BELOW, ISOTROPIC, LAWS, LOBED
from radcalc.laws.solver import Disagreement, reached
from radcalc.laws.solver import solve as follow
from radcalc.maths import any_true, atan2, is_array, power
from radcalc.quantities import LUMINOUS
from radcalc.quantities.symbols import generic_name, light_unit

if TYPE_CHECKING:
    from radcalc.distributions.distribution import Beam, Peak, Photometry
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
OF_AXIS = "intensity: that on the source's axis; intensity-toward is that in the direction"
OF_DIRECTION = ("intensity-toward", "off-axis", "azimuth")  # shown if a direction is given
HORIZONTAL = "the receiver is horizontal"
EXPRESSION = "expression"  # a format of distributions
# What a remark on the distribution of the light is on; the first has no further origin.
DISTRIBUTION = (
    *("relative-axial-intensity", "relative-peak-intensity", "relative-intensity", "scale"),
    *("weighted-solid-angle", "part", "upward-part", "received-solid-angle"),
)
OF_FLUX = ("error", "output-ratio", "source-efficacy")
BEAMS = (("beam-angle", 0.5, "a half"), ("field-angle", 0.1, "a tenth"))
PLANES = (("", 0.0), ("-90", math.pi / 2))


def luminaire(given: Inputs, is_aside: bool, any_incidence: bool) -> Answer:
    """Return the answer for a receiver below the source, in a direction or off the axis."""
    return _Luminaire(given, is_aside, any_incidence).answer()


class Figures(NamedTuple):
    """The figures of a distribution, relative to its unit of intensity.

    The flux is an error if it cannot be computed.
    """

    axial: float
    peak: "Peak"
    flux: "Integral | errors.ConditionError"


@lru_cache(maxsize=8)
def _figures(distribution: Any) -> Figures:
    flux: Integral | errors.ConditionError
    try:
        flux = distribution.flux()
    except errors.ConditionError as error:
        flux = error
    return Figures(float(distribution.intensity(0.0, 0.0)), distribution.peak(), flux)


@lru_cache(maxsize=32)
def _beam(distribution: Any, azimuth: float, share: float) -> "Beam":
    from radcalc.distributions.distribution import beam

    return beam(distribution, azimuth, share)


@lru_cache(maxsize=8)
def _upward(
    distribution: Any, flux: "Integral", aim: tuple[float, float, float], rotate: float
) -> float:
    """Return the flux above the horizon, in units of the distribution."""
    from radcalc.distributions.distribution import Pose
    from radcalc.distributions.scene import upward_flux

    return upward_flux(distribution, Pose(aim, rotate), flux).value


class _Luminaire:
    def __init__(self, given: Inputs, is_aside: bool, any_incidence: bool) -> None:
        from radcalc.distributions.distribution import DOWN, Pose

        self.given, self.is_aside, self.any_incidence = given, is_aside, any_incidence
        _refuse_idle(given)
        shape = spread(given)  # refuses inputs of other distributions
        chosen: Any = given["distribution"].value if "distribution" in given else shape
        self.of_shape = isinstance(chosen, str)
        kind = "" if self.of_shape else chosen.distribution.kind
        shaped = SHAPED[shape] if self.of_shape else ()
        self.is_below = is_aside or "height" in given
        hidden = () if self.is_below or "toward" in given else OF_DIRECTION
        page = PAGE._replace(
            takes=(*PAGE.takes, *shaped),
            light=_without(PAGE.light, hidden),
            others=(*_without(PAGE.others, hidden), *shaped),
        )
        hints = (*SCALING, *shaped, *POSITION, *RECEIVER)
        self.sheet = worksheet(page, given, preferred=kind, hints=hints, defaults=("incidence",))
        self.placed = Placed(*laws_of.DISTRIBUTION_LAWS)
        refuse_light_of_surfaces(self.sheet.lit, SCALING)
        place_hemisphere(given, self.placed)
        self.photometry: Photometry = self._make_shape(shape) if self.of_shape else chosen
        source: Any = self.photometry.distribution
        self.source, self.figures = source, _figures(source)
        self.aim = given["aim"].value if "aim" in given else DOWN
        self.rotate = given["rotate"].value if "rotate" in given else 0.0
        if is_array(self.rotate):
            raise _one_at_a_time("rotate")
        self.pose = Pose(self.aim, self.rotate)
        self.placed.use("rotate")
        self.bearing = atan2(offset_of(given, "offset-y"), offset_of(given))

    def _make_shape(self, shape: str) -> "Photometry":
        """Return the photometry of a shape; refuse a width that is missing or an array."""
        from radcalc.distributions import sources
        from radcalc.distributions.distribution import Photometry

        if shape not in (CONICAL, LOBED):
            return Photometry(sources.Isotropic(), shape)
        name = "half-angle" if shape == CONICAL else "exponent"
        known = self.sheet.known_with(self.placed)
        if "peak-intensity" in known:
            known.setdefault("intensity", known["peak-intensity"])
        try:
            solution = follow(LAWS[shape], known)
        except Disagreement as error:
            raise contradiction(self.sheet, error, {}) from None
        values = solution.values
        self.placed.note(*remarks_on(self.sheet, solution))
        if name not in values:
            raise errors.MissingInput(
                f"the {'shape' if shape == LOBED else 'width'} of the {shape} is missing",
                errors.options(SHAPED[shape]),
            )
        width = values[name].value
        for measure in SHAPED[shape]:
            if measure in values and measure not in known:
                self.placed.known[measure] = values[measure]
        self.placed.use(*SHAPED[shape])
        if is_array(width):
            raise _one_at_a_time(next(n for n in SHAPED[shape] if n in self.given))
        return Photometry(sources.of_shape(shape, width), shape)

    def answer(self) -> Answer:
        self._place_figures()
        self._place_receiver()
        self._place_scale()
        laws = self.placed.laws
        known = {*self.sheet.known_with(self.placed), "incidence"}
        if self.is_flat and not {"height", "lateral"} <= reached(laws, known):
            floor = laws_of.floor(self.source, self.pose, self.bearing)
            laws[:] = [COSINE_BELOW, *laws, floor]
        solutions = solve_facing(self.sheet, laws, self.placed, self.any_incidence, self.is_flat)
        if self.is_aside:
            require_height(solutions[0])
        answers = [self._with_remarks(solved) for solved in solutions]
        return answers[0]._replace(more=tuple(answers[1:]))

    # -- figures and scale --------------------------------------------------------------------

    def _place_figures(self) -> None:
        """Add the relative intensities, the weighted solid angle and the upward part."""
        light, placed, flux = self.sheet.lit.values, self.placed, self.figures.flux
        placed.add("relative-axial-intensity", self.figures.axial)
        placed.add("relative-peak-intensity", self.figures.peak.value)
        if self.figures.axial == 0 and "intensity" in light:
            name = option(light["intensity"].name)
            raise errors.ConditionError(
                f"{name} is the intensity on the axis, which is 0 in this distribution",
                [
                    errors.Try(
                        (("peak-intensity", light["intensity"].text),), (light["intensity"].name,)
                    ),
                    errors.Try((("flux", ""),), (light["intensity"].name,)),
                ],
            )
        if isinstance(flux, errors.ConditionError):
            if {"flux", "energy"} & set(light):
                raise flux
            placed.note(f"no flux: {flux.message}")
            return
        if not flux.value:
            dark = "the distribution has no intensity in the sampled directions"
            raise errors.ConditionError(
                "; ".join((dark, *self.photometry.assumptions)),
                "a wider one, or a table of its angles and intensities",
            )
        placed.add("weighted-solid-angle", flux.value)
        unit = "sr, with f in units of the scale"
        placed.steps.append(
            Step(
                "integral of the distribution",
                "Omega_f = integral of f sin(gamma) dgamma dC",
                f"Omega_f = {format_number(flux.value)} {unit}",
            )
        )
        try:
            upward = _upward(self.source, flux, self.aim, self.rotate)
            placed.add("upward-part", upward / flux.value)
        except errors.ConditionError as error:
            placed.note(f"no flux upwards or downwards: {error.message}")
        placed.laws.append(laws_of.part(self.source, flux.value))

    def _place_scale(self) -> None:
        """Add a scale of 1 for an absolute source that no light quantity scales."""
        sheet, kind = self.sheet, self.source.kind
        if not sheet.lit.values and not kind:
            raise errors.MissingInput(
                "the distribution is relative: a quantity that scales it is missing",
                errors.mention("{flux}, {intensity} or {peak-intensity}") + self._unit_hint,
            )
        known = {*sheet.known_with(self.placed)}
        if not self.any_incidence:
            known |= sheet.defaults
        asks_place = self._asks_place and sheet.lit.kind == kind
        if not kind or ("scale" in reached(self.placed.laws, known) and not asks_place):
            return
        if sheet.lit.kind != kind:
            name = option(next(iter(sheet.lit.values.values())).name)
            raise errors.MissingInput(
                f"the distribution is in {light_unit('intensity', kind)}, {name} is of another "
                f"kind: {MISSING_LINK}",
                LINKS_HINT,
            )
        self.placed.add("scale", 1.0)

    @property
    def _unit_hint(self) -> str:
        """Return a hint at the place of a unit that makes the distribution absolute."""
        if self.of_shape:
            return ""
        if self.photometry.format == EXPRESSION:
            return " (or a unit after the expression, such as cd)"
        return ", or a unit in the titles of the file, as in I (cd)"

    @property
    def _asks_place(self) -> bool:
        """Return whether an irradiance gives the offset from an unscaled source."""
        strength = {"flux", "intensity", "peak-intensity", "energy"} & set(self.sheet.lit.values)
        placed = {"distance", *OFFSETS} & set(self.given)
        return bool(self.sheet.lit.values) and "height" in self.given and not strength | placed

    # -- the receiver ---------------------------------------------------------------------------

    def _place_receiver(self) -> None:
        """Place the receiver below the source or in a direction, with the laws of its light."""
        given, placed = self.given, self.placed
        place_incidence(given, placed)
        placed.laws.append(laws_of.relative_intensity(self.source))
        if self.is_below:
            self._place_below()
        else:
            polar, azimuth = given["toward"].value if "toward" in given else (0.0, 0.0)
            placed.add("off-axis", polar)
            placed.add("azimuth", azimuth)
        if "time" not in given:
            placed.laws.append(laws_of.TOWARD_OF_ENERGY)
        if "receiver-area" in given:
            placed.laws.append(self._receiver())
        edges = _beam(self.source, 0.0, 0.5).edges if self._axis_input else None
        if edges and max(map(abs, edges)) < math.pi / 2:
            placed.laws.append(laws_of.beam_diameter(edges, self._axis_input))

    def _place_below(self) -> None:
        """Add the laws and assumptions of a receiver at a height below the source."""
        given, placed = self.given, self.placed
        has_offsets = place_offsets(given, placed)
        if not (has_offsets or self.is_aside):
            placed.add("lateral", 0.0)
        placed.laws += laws_of.direction(self.pose, self.bearing)
        if self.is_aside and not has_offsets:
            placed.laws.append(OFFSET)
        if "incidence" in given:
            place_at_incidence(given, placed, HORIZONTAL if "aim" in given else LYING)
        else:
            placed.laws.append(laws_of.FLAT)
        if "aim" in given:
            placed.assume(
                f"aimed at {quote(given['aim'].text)}; heights are vertical, and offsets are "
                "measured from the vertical through the source",
                of=ON_DIRECTION,
            )
            if "incidence" not in given:
                placed.assume(HORIZONTAL, of=ON_RECEIVER)
        else:
            placed.assume("the source points straight down", of=ON_DIRECTION)
            if "incidence" not in given:
                placed.assume(LYING, of=ON_RECEIVER)
        if not self.source.is_axial or "rotate" in given:
            placed.assume(
                errors.mention("{offset} is towards C0, {offset-y} towards C90")
                if not self.rotate
                else f"C0 is turned by {format_angle(self.rotate)} from x towards y",
                of=ON_DIRECTION,
            )

    @property
    def _axis_input(self) -> str:
        """Return the input with the receiver's distance along the axis, or an empty name."""
        if self.is_below:
            return "" if "aim" in self.given else "height"
        return "" if "toward" in self.given else "distance"

    def _receiver(self) -> AnyLaw:
        if self.is_flat:
            return laws_of.lying_disc(self.source, self.pose, self.bearing)
        return laws_of.SMALL if self.is_turned else laws_of.facing_disc(self.source)

    @property
    def is_flat(self) -> bool:
        given = self.given
        return self.is_below and ("incidence" not in given or lies_at_incidence(given))

    @property
    def is_turned(self) -> bool:
        incidence = angle_of(self.given, "incidence")
        return not self.is_flat and (self.any_incidence or any_true(incidence != 0))

    @property
    def is_scaled(self) -> bool:
        return "scale" not in self.placed.known

    # -- remarks --------------------------------------------------------------------------------

    def _with_remarks(self, solved: Solved) -> Answer:
        """Return the answer with the facts about the source, and with all remarks."""
        receiver, solved.assumptions = solved.assumptions, []
        solved.assume(*self._of_source(), of=DISTRIBUTION)
        if self.is_scaled and self.source.kind:
            solved.assume(*self._of_scale(solved), of=["scale"])
        solved.assumptions += receiver
        solved.notes += self.photometry.notes
        is_on_axis = not self.is_aside and {"toward", "aim"}.isdisjoint(self.given)
        if is_on_axis and self.photometry.format != ISOTROPIC and solved.has("irradiance"):
            solved.assume(ON_AXIS, of=ON_RECEIVER)
        if "toward" in self.given:
            solved.assume(OF_AXIS, of=["intensity"])
        if solved.lit.links and not self.of_shape:
            solved.assume("the same spectrum in every direction", of=solved.lit.linked)
        solved.note_behind()
        fall = solved.value("relative-intensity") if solved.has("relative-intensity") else 1.0
        if solved.has("irradiance") and any_true(fall == 0):
            solved.note("the source is dark in the direction of the receiver")
        if solved.has("received-flux"):
            self._judge_receiver(solved)
        size = self.photometry.size
        if size and solved.has("distance") and geometry.is_near(solved.value("distance"), size):
            solved.note(
                f"the luminous part is {format_value(size, 'm')} long: at less than five times "
                "that distance the inverse square law does not hold"
            )
        facts = [*self._facts(solved)]
        solved.derived = {
            fact.name: ["flux"] if fact.name in OF_FLUX else DISTRIBUTION[:1] for fact in facts
        }
        answer = solved.answer()
        lit = {name: k for k, name in enumerate(LIGHT)}
        cut = sum(1 for row in answer.values if not row.is_absent and generic_name(row.name) in lit)
        values = [*answer.values[:cut], *facts, *answer.values[cut:]]
        return answer._replace(values=values)

    def _of_source(self) -> Iterator[str]:
        source = self.photometry
        if self.of_shape:
            yield ASSUMED[source.format].partition(";")[0]
        elif source.format == EXPRESSION:
            yield f"the intensity is {quote(source.name)}; theta is measured from the source's axis"
        else:
            yield f"distribution: {source.format}" + f": {quote(source.name)}" * bool(source.name)
        yield from source.assumptions

    def _of_scale(self, solved: Solved) -> Iterator[str]:
        """Yield the factor of the distribution, and a remark on declared values."""
        if solved.lit.kind == self.source.kind:
            times = (
                format_number(solved.value("scale"))
                if solved.has("scale")
                else "an unknown number of"
            )
            yield f"scaled: {times} times the intensities of the distribution"
        else:
            yield "scaled: only the shape of the distribution is used"
        if self.photometry.declared:
            yield "the declared lamp flux and power do not apply to a scaled distribution"

    def _judge_receiver(self, solved: Solved) -> None:
        solved.assume("the receiver is a disc of that area", of=["received-solid-angle"])
        if self.is_turned:
            self._refuse_uneven(solved)
        compare_mean(solved)

    def _refuse_uneven(self, solved: Solved) -> None:
        """Refuse uneven light on a receiver that is turned around an unknown axis."""
        from radcalc.distributions.scene import unevenness
        from radcalc.geometry.receivers import UNEVEN

        radius = power(solved.value("receiver-area") / math.pi, 0.5)
        place = (solved.value(name) for name in ("distance", "off-axis", "azimuth"))
        uneven = unevenness(self.source, radius, *place)
        if uneven > UNEVEN:
            raise errors.ConditionError(
                f"the light varies by {format_number(100 * uneven, 2)} % over the receiver, and "
                "the axis of its incidence is not known",
                errors.mention("a smaller {receiver-area}, or leave out {incidence}"),
            )
        varies = f"the light varies by {format_number(100 * uneven, 2)} % over the receiver"
        solved.assume(varies, of=["received-solid-angle"])

    # -- facts about the source -----------------------------------------------------------------

    def _facts(self, solved: Solved) -> Iterator[Value]:
        flux = self.figures.flux
        if isinstance(flux, errors.ConditionError):
            yield absent("flux", flux.message, flux.hint)
        elif not self.of_shape and solved.has("flux"):
            yield self._error(solved, flux)
        yield value("peak-polar", self.figures.peak.polar)
        yield value("peak-azimuth", self.figures.peak.azimuth)
        known = self.sheet.known_with(self.placed)
        for name, share, percentage in BEAMS:
            for suffix, azimuth in PLANES:
                if name + suffix not in known:
                    yield self._width(solved, name + suffix, azimuth, share, percentage)
        yield from self._declared(solved)

    def _error(self, solved: Solved, flux: "Integral") -> Value:
        """Return the estimated error of the flux; compare a table's flux with the zonal method."""
        kind, label = solved.lit.kind, "estimate of the flux's error"
        if zonal := getattr(self.source, "zonal_flux", None):
            label += " by the table's steps"
            part = zonal() / flux.value
            if not is_array(solved.value("flux")):
                size = format_value(solved.value("flux") * part, light_unit("flux", kind))
                solved.assume(
                    "the flux is exact for intensities that are linear between the table's "
                    f"angles; the zonal method gives {size} ({100 * (part - 1):+.2g} %)",
                    of=["weighted-solid-angle"],
                )
        return value("error", solved.value("flux") * flux.error / flux.value)._replace(
            label=label,
            dimensions=(kinds.dimension("flux", kind),),
            units=(light_unit("flux", kind),),
        )

    def _width(
        self, solved: Solved, name: str, azimuth: float, share: float, percentage: str
    ) -> Value:
        """Return a beam or field angle, or the reason why it is absent; note an ambiguous one."""
        beam = _beam(self.source, 0.0 if self.source.is_axial else azimuth, share)
        if beam.outermost is None:
            return absent(
                name,
                f"the intensity does not fall to {percentage} of the plane's maximum",
                errors.mention("{within}, and the flux within it"),
            )
        solved.assume(
            "beam and field angles: between the outermost directions in which the plane has a "
            "half and a tenth of its greatest intensity",
            of=[beam + suffix for beam, *_ in BEAMS for suffix, _ in PLANES],
        )
        row = value(name, beam.outermost)
        if beam.is_ambiguous and not (azimuth and self.source.is_axial):
            other = "does not exist"
            if beam.from_axis is not None:
                other = f"is {format_angle(beam.from_axis)}"
            solved.note(
                f"the {row.label} is ambiguous: the angle to {percentage} of the intensity on the "
                f"axis {other}"
            )
        return row

    def _declared(self, solved: Solved) -> Iterator[Value]:
        """Yield the output ratio, the input power and the efficacy, by the declared values."""
        declared = {} if self.is_scaled else self.photometry.declared
        flux = solved.value("flux") if solved.has("flux") else None
        lamps, watts = declared.get("lamp-flux"), declared.get("input-power")
        numbers = {
            "output-ratio": flux / lamps if flux is not None and lamps else None,
            "input-power": watts,
            "source-efficacy": flux / watts
            if flux is not None and watts and solved.lit.kind == LUMINOUS
            else None,
        }
        for name, number in numbers.items():
            if number is None:
                yield absent(name, *self._not_declared)
            else:
                yield value(name, number)

    @property
    def _not_declared(self) -> tuple[str, str]:
        if self.photometry.declared and self.is_scaled:
            scaling = errors.options(
                [item.name for item in self.sheet.lit.values.values()], " and "
            )
            problem = "declared values do not apply to a scaled distribution"
            return problem, f"leave out {scaling}"
        return "it is not declared", "a file with the flux of its lamps and their power"


def _refuse_idle(given: Inputs) -> None:
    """Refuse two positions of the receiver, and a rotation without a position or an aim."""
    placed = next((name for name in ("height", *OFFSETS) if name in given), None)
    if "toward" in given and placed:
        raise errors.Exclusive(("toward", placed), "both place the receiver")
    if "rotate" in given and not placed and "aim" not in given:
        raise errors.Unused(
            ("rotate",),
            "without a receiver off the axis",
            errors.mention("add {height=3m} and {offset=1m}"),
        )


def _one_at_a_time(name: str) -> errors.ConditionError:
    return errors.ConditionError(
        f"{option(name)} cannot be a long range here", "a list of at most 1000 values"
    )


def _without(names: tuple[str, ...], *hidden_names: Any) -> tuple[str, ...]:
    hidden = set().union(*hidden_names)
    return tuple(name for name in names if name not in hidden)
