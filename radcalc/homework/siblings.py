"""Mistakes that use a similar function for the right one in a law.

A row of `LAWS` has the name of a law, the symbol that it is solved for, and a function that gives
its wrong values from the other symbols.
"""

import math
from collections.abc import Callable, Iterator

from radcalc.geometry import cones
from radcalc.homework.chain import FAILURES
from radcalc.homework.edits import text_of
from radcalc.homework.problem import Candidate, Problem, usual
from radcalc.laws.law import At

Wrong = Iterator[tuple[str, float]]  # the name of a mistake, and the wrong value of the symbol
PI = math.pi


def find(p: Problem) -> Iterator[Candidate]:
    """Yield the wrong values from a similar function in a law of the derivation."""
    for law, target in p.chain.steps:
        for name_of_law, symbol, wrong in LAWS:
            if target == symbol and law.name == name_of_law:
                for name, value in _values(p, wrong):
                    candidate = usual(name, p.chain.after(target, value), right=text_of(law))
                    if candidate:
                        yield candidate


def _values(p: Problem, wrong: Callable[[At], Wrong]) -> Wrong:
    try:
        yield from wrong(p.chain.values.__getitem__)
    except FAILURES:
        return


def _flat(half: float) -> Wrong:
    """Yield wrong values of the solid angle of a cone, projected or not."""
    yield "one-forgotten", 2 * PI * math.cos(half)
    yield "sine-not-squared", PI * math.sin(half)
    if half < PI / 2:
        yield "flat-disc-for-cap", PI * math.tan(half) ** 2
        yield "flat-disc-for-cap", PI * half**2


def _cone(at: At) -> Wrong:
    half = at("half-angle")
    yield "solid-for-projected", cones.projected_cone(half)
    yield "wrong-sphere", 2 * cones.cone(half)
    yield from _flat(half)


def projected_cone(at: At) -> Wrong:
    """Yield wrong values of the projected solid angle of a cone."""
    yield "solid-for-projected", cones.cone(at("half-angle"))
    yield from _flat(at("half-angle"))


def _etendue_of_cone(at: At) -> Wrong:
    return ((name, at("area") * size) for name, size in projected_cone(at))


def _half_angle(at: At) -> Wrong:
    yield "wrong-sphere", cones.cone_of(at("solid-angle") / 2)
    ratio = math.sqrt(at("solid-angle") / PI)
    yield "flat-disc-for-cap", ratio
    yield "flat-disc-for-cap", math.atan(ratio)
    yield "solid-for-projected", math.asin(ratio)


def _lobe(at: At) -> Wrong:
    n = at("exponent")
    yield "exponent-upside-down", 2 * PI * (n + 1)


def _logarithm(over: str, under: str) -> Callable[[At], Wrong]:
    def wrong(at: At) -> Wrong:
        stops = at(over) * 100 / at(under)
        yield "log10-for-log2", math.log10(stops)
        yield "log10-for-log2", math.log(stops)

    return wrong


def _time_behind_filter(at: At) -> Wrong:
    yield "filter-the-wrong-way", at("unfiltered-time") / 2 ** at("stops")
    yield "stops-are-doublings", at("unfiltered-time") * at("stops")
    yield "stops-are-doublings", at("unfiltered-time") * at("stops") ** 2


def _pyramid(at: At) -> Wrong:
    a, b = at("horizontal"), at("vertical")
    yield "flat-for-curved", a * b
    yield "flat-for-curved", 4 * math.tan(a / 2) * math.tan(b / 2)


def _discs(at: At) -> Wrong:
    first, second = at("radius") ** 2, at("receiver-radius") ** 2
    for rim in (0.0, first, second):
        far = PI**2 * first * second / (at("distance") ** 2 + rim)
        yield "far-field-of-extended-source", far


def _mesopic(at: At) -> Wrong:
    yield "scotopic-for-mesopic", at("luminance") * at("sp-ratio")
    yield "scotopic-for-mesopic", at("luminance")


def _working(at: At) -> Wrong:
    yield "magnification-forgotten", at("f-number")
    yield "magnification-forgotten", at("f-number") * math.sqrt(1 + at("magnification"))


def _spot(symbol: str) -> Callable[[At], Wrong]:
    """Use the diameter of a spot as its radius."""

    def wrong(at: At) -> Wrong:
        yield "diameter-for-radius", at(symbol) / 4

    return wrong


def _of_uniform(at: At) -> Wrong:
    yield "sum-for-root", math.hypot(at("diameter"), at("divergence") * at("distance"))


def _other_leg(hypotenuse: float, leg: float) -> float:
    return math.sqrt(hypotenuse**2 - leg**2)


def _reach_of_gaussian(at: At) -> Wrong:
    spot, exit_diameter, angle = at("limit-diameter"), at("diameter"), at("divergence")
    mean = spot / math.sqrt(2)  # the diameter at which the mean over the spot is the limit
    yield "uniform-for-gaussian", (mean - exit_diameter) / angle
    yield "mean-for-peak", mean / angle


def _reach_of_uniform(at: At) -> Wrong:
    spot, exit_diameter, angle = at("limit-diameter"), at("diameter"), at("divergence")
    yield "sum-for-root", _other_leg(spot, exit_diameter) / angle
    yield "gaussian-for-uniform", _other_leg(math.sqrt(2) * spot, exit_diameter) / angle


def _room(at: At) -> Wrong:
    yield "perimeter-for-sum", at("room-index") / 2
    yield "mean-for-sum", at("room-index") * 2


def _rounded_down(at: At) -> Wrong:
    yield "rounded-down", at("luminaires") // 1


def _lumen_method(at: At) -> Wrong:
    yield "maintenance-upside-down", at("luminaires") * at("maintenance") ** 2


def _stops_of_filter(at: At) -> Wrong:
    yield "density-for-stops", at("nd")


def _density_of_filter(at: At) -> Wrong:
    yield "density-for-stops", at("stops")


def _off_axis(at: At) -> Wrong:
    for power in (1, 2, 3):
        yield "fewer-cosines", at("irradiance") / at("cosine-off-axis") ** (4 - power)


LAWS: tuple[tuple[str, str, Callable[[At], Wrong]], ...] = (
    ("solid angle of a cone", "solid-angle", _cone),
    ("solid angle of a cone", "half-angle", _half_angle),
    ("projected solid angle of a cone", "projected-solid-angle", projected_cone),
    ("etendue of a cone", "etendue", _etendue_of_cone),
    ("flux of a lobe divided by its peak intensity", "solid-angle", _lobe),
    ("reflected light", "ev100", _logarithm("luminance", "k")),
    ("incident light", "ev100", _logarithm("illuminance", "c")),
    ("time behind a filter", "time", _time_behind_filter),
    ("rectangular pyramid", "solid-angle", _pyramid),
    ("two coaxial discs", "etendue", _discs),
    ("mesopic luminance", "mesopic-luminance", _mesopic),
    ("working f-number", "working-f-number", _working),
    ("mean irradiance of a spot", "irradiance", _spot("irradiance")),
    ("mean exposure of a spot", "exposure", _spot("exposure")),
    ("peak of a gaussian beam", "peak-irradiance", _spot("peak-irradiance")),
    ("peak of a uniform beam", "peak-irradiance", _spot("peak-irradiance")),
    ("spread of a uniform beam", "spot-diameter", _of_uniform),
    ("spread of a gaussian beam", "hazard-distance", _reach_of_gaussian),
    ("spread of a uniform beam", "hazard-distance", _reach_of_uniform),
    ("room index", "room-index", _room),
    ("luminaires to install", "luminaires-to-install", _rounded_down),
    ("lumen method", "luminaires", _lumen_method),
    ("stops of a filter", "stops", _stops_of_filter),
    ("stops of a filter", "nd", _density_of_filter),
    ("camera equation", "irradiance", _off_axis),
)
