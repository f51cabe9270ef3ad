"""Mistakes in certain laws: a similar function for the right one, or a wrong value of a symbol.

Both tables have rows for a law, with the name of the mistake.
"""

import math
from collections.abc import Callable, Iterator, Sequence
from typing import Any, NamedTuple

from radcalc.geometry import cones
from radcalc.homework.chain import Worked
from radcalc.homework.edits import text_of
from radcalc.homework.problem import Candidate, Problem, usual
from radcalc.laws.law import AnyLaw, At

PI = math.pi
Function = Callable[[At], Any]  # of the values of a law's symbols


class Row(NamedTuple):
    """A mistake in a law, and a function that gives the wrong value of a symbol.

    `right` is a part of the law's formula, and `wrong` is what a learner writes in its place; both
    are empty if the wrong step is not shown.
    """

    law: str
    symbol: str
    mistake: str
    function: Callable[[Any], float]
    right: str = ""
    wrong: str = ""


def find(p: Problem) -> Iterator[Candidate]:
    """Yield the wrong values from a similar function or a wrong symbol in a law."""
    for law, target in p.chain.steps:
        for row, value in _wrong_values(p, law, target):
            if isinstance(value, Worked) and row.right and row.right in law.template:
                edited = law._replace(template=law.template.replace(row.right, row.wrong))
                value = p.chain.by(edited, target, value.wrong[target])
            if candidate := usual(row.mistake, value, right=text_of(law)):
                yield candidate


def _wrong_values(p: Problem, law: AnyLaw, target: str) -> Iterator[tuple[Row, float | None]]:
    """Yield the rows for a law that is solved for a symbol, with the results that they lead to."""
    for row in FORMULAS:
        if (row.law, row.symbol) == (law.name, target):
            yield row, p.chain.solved(target, row.function)
    for row in SYMBOLS_CHANGED:
        if row.law == law.name and row.symbol != target:
            changed = row.function(p.chain.values[row.symbol])
            at = {**p.chain.values, row.symbol: changed}.__getitem__
            yield row, p.chain.solved(target, lambda _, at=at: law.solve(target, at))  # type: ignore[misc]


Cap = tuple[str, Callable[[float], float], str, str]  # of the half angle, and as in `Row`
WHOLE, HALVED = "sin^2({half-angle})", "sin^2({half-angle}/2)"
FLAT: tuple[Cap, ...] = (  # of a cone, projected or not
    ("one-forgotten", lambda half: 2 * PI * math.cos(half), "", ""),
    ("sine-not-squared", lambda half: PI * math.sin(half), WHOLE, "sin({half-angle})"),
    ("flat-disc-for-cap", lambda half: PI * math.tan(half) ** 2 if half < PI / 2 else math.nan,
        WHOLE, "tan({half-angle})^2"),
    ("flat-disc-for-cap", lambda half: PI * half**2 if half < PI / 2 else math.nan,
        HALVED, "({half-angle} / 2)^2"),
)  # fmt: skip
PROJECTED: tuple[Cap, ...] = (("solid-for-projected", cones.cone, "", ""), *FLAT)
PLAIN: tuple[Cap, ...] = (
    ("solid-for-projected", cones.projected_cone, "", ""),
    ("wrong-sphere", lambda half: 2 * cones.cone(half), "", ""),
    *FLAT,
)
CONE, LOBE = "solid angle of a cone", "flux of a lobe divided by its peak intensity"


def _of_cones(law: str, symbol: str, caps: Sequence[Cap]) -> Iterator[Row]:
    """Yield the rows of a law of cones; an etendue is the area times the solid angle."""
    for mistake, wrong, *texts in caps:

        def function(at: At, wrong: Callable[[float], float] = wrong) -> float:
            return wrong(at("half-angle")) * (at("area") if symbol == "etendue" else 1.0)

        yield Row(law, symbol, mistake, function, *texts)


def _far_discs(rim: str) -> Function:
    """Return the etendue of two discs as if they were far apart, or one of them were small."""

    def etendue(at: At) -> float:
        far = at("distance") ** 2 + (at(rim) ** 2 if rim else 0.0)
        return float(PI**2 * at("radius") ** 2 * at("receiver-radius") ** 2 / far)

    return etendue


def _logarithm(ratio: Function, log: Callable[[float], float]) -> Function:
    return lambda at: log(ratio(at))


def _of_cosines(power: int) -> Function:
    return lambda at: at("irradiance") / at("cosine-off-axis") ** (4 - power)


def _mean_spot(at: At) -> Any:
    """Return the diameter of a spot whose mean is the limit, if the peak is at `limit-diameter`."""
    return at("limit-diameter") / math.sqrt(2)


def _reach(at: At, spot: float) -> Any:
    """Return the distance at which a uniform beam has a spot of a diameter."""
    return (spot - at("diameter")) / at("divergence")


def _reach_of_squares(at: At, spot: float) -> Any:
    """Return the distance at which a Gaussian beam has a spot of a diameter."""
    return math.sqrt(spot**2 - at("diameter") ** 2) / at("divergence")


LOGARITHMS: tuple[tuple[str, str, Function], ...] = (  # to base 2 of these ratios
    ("exposure value", "ev", lambda at: at("exposure-setting")),
    ("reflected light", "ev100", lambda at: at("luminance") * 100 / at("k")),
    ("incident light", "ev100", lambda at: at("illuminance") * 100 / at("c")),
)
# A law, the symbol that it is solved for, a mistake, and the wrong value from the other symbols (or
# from the right value).
FORMULAS: tuple[Row, ...] = (
    *_of_cones(CONE, "solid-angle", PLAIN),
    *_of_cones("projected solid angle of a cone", "projected-solid-angle", PROJECTED),
    *_of_cones("etendue of a cone", "etendue", PROJECTED),
    Row(CONE, "half-angle", "wrong-sphere", lambda at: cones.cone_of(at("solid-angle") / 2)),
    Row(CONE, "half-angle", "flat-disc-for-cap", lambda at: math.sqrt(at("solid-angle") / PI)),
    Row(CONE, "half-angle", "flat-disc-for-cap",
        lambda at: math.atan(math.sqrt(at("solid-angle") / PI))),
    Row(CONE, "half-angle", "solid-for-projected",
        lambda at: math.asin(math.sqrt(at("solid-angle") / PI))),
    Row(LOBE, "solid-angle", "exponent-upside-down", lambda at: 2 * PI * (at("exponent") + 1)),
    Row("straight line to the source", "distance", "sum-for-difference",
        lambda at: math.sqrt(abs(at("height") ** 2 - at("lateral") ** 2)),
        "+ {lateral}", "- {lateral}"),
    *(Row(law, symbol, "log10-for-log2", _logarithm(ratio, log), "log2", name)
        for law, symbol, ratio in LOGARITHMS
        for name, log in (("log10", math.log10), ("ln", math.log))),
    Row("time behind a filter", "time", "stops-are-doublings",
        lambda at: at("unfiltered-time") * at("stops")),
    Row("time behind a filter", "time", "stops-are-doublings",
        lambda at: at("unfiltered-time") * at("stops") ** 2),
    Row("rectangular pyramid", "solid-angle", "flat-for-curved",
        lambda at: at("horizontal") * at("vertical")),
    Row("rectangular pyramid", "solid-angle", "flat-for-curved",
        lambda at: 4 * math.tan(at("horizontal") / 2) * math.tan(at("vertical") / 2)),
    *(Row("two coaxial discs", "etendue", "far-field-of-extended-source", _far_discs(rim))
        for rim in ("", "radius", "receiver-radius")),
    Row("mesopic luminance", "mesopic-luminance", "scotopic-for-mesopic",
        lambda at: at("luminance") * at("sp-ratio")),
    Row("mesopic luminance", "mesopic-luminance", "scotopic-for-mesopic",
        lambda at: at("luminance")),
    # The diameter of a spot is used as its radius.
    Row("mean irradiance of a spot", "irradiance", "diameter-for-radius",
        lambda at: at("irradiance") / 4),
    Row("mean exposure of a spot", "exposure", "diameter-for-radius",
        lambda at: at("exposure") / 4),
    *(Row(f"peak of a {profile} beam", "peak-irradiance", "diameter-for-radius",
        lambda at: at("peak-irradiance") / 4) for profile in ("gaussian", "uniform")),
    Row("spread of a uniform beam", "spot-diameter", "sum-for-root",
        lambda at: math.hypot(at("diameter"), at("divergence") * at("distance"))),
    Row("spread of a gaussian beam", "spot-diameter", "sum-for-root",
        lambda at: at("diameter") + at("divergence") * at("distance"),
        "sqrt({diameter}^2 + ({divergence} {distance})^2)", "{diameter} + {divergence} {distance}"),
    Row("spread of a gaussian beam", "hazard-distance", "uniform-for-gaussian",
        lambda at: _reach(at, _mean_spot(at))),
    Row("spread of a gaussian beam", "hazard-distance", "mean-for-peak",
        lambda at: _mean_spot(at) / at("divergence")),
    Row("spread of a gaussian beam", "hazard-distance", "sum-for-root",
        lambda at: _reach(at, at("limit-diameter"))),
    Row("spread of a uniform beam", "hazard-distance", "sum-for-root",
        lambda at: _reach_of_squares(at, at("limit-diameter"))),
    Row("spread of a uniform beam", "hazard-distance", "gaussian-for-uniform",
        lambda at: _reach_of_squares(at, math.sqrt(2) * at("limit-diameter"))),
    Row("room index", "room-index", "perimeter-for-sum", lambda at: at("room-index") / 2),
    Row("room index", "room-index", "mean-for-sum", lambda at: at("room-index") * 2),
    Row("luminaires to install", "luminaires-to-install", "rounded-down",
        lambda at: at("luminaires") // 1),
    Row("lumen method", "luminaires", "maintenance-upside-down",
        lambda at: at("luminaires") * at("maintenance") ** 2),
    Row("stops of a filter", "stops", "density-for-stops", lambda at: at("nd")),
    Row("stops of a filter", "nd", "density-for-stops", lambda at: at("stops")),
    *(Row("camera equation", "irradiance", "fewer-cosines", _of_cosines(power))
        for power in (1, 2, 3)),
)  # fmt: skip

# A law, a symbol in it, a mistake, and the value that is used for that of the symbol.
SYMBOLS_CHANGED: tuple[Row, ...] = (
    Row(LOBE, "exponent", "lobe-without-one", lambda n: n - 1,
        "({exponent} + 1)", "{exponent}"),
    Row("working f-number", "magnification", "magnification-forgotten", lambda m: 0.0),
    Row("working f-number", "magnification", "magnification-forgotten",
        lambda m: math.sqrt(1 + m) - 1),
    Row("guide number", "iso", "speed-without-root", lambda iso: iso**2 / 100,
        "sqrt(100 / {iso})", "100 / {iso}"),
    Row("time behind a filter", "stops", "filter-the-wrong-way", lambda stops: -stops),
    Row("exposure value at ISO 100, behind a filter", "stops", "filter-the-wrong-way",
        lambda stops: -stops, "+ {stops}", "- {stops}"),
    Row("spread of a gaussian beam", "diameter", "exit-forgotten", lambda _: 0.0,
        "{diameter}^2 + ", ""),
    Row("spread of a uniform beam", "diameter", "exit-forgotten", lambda _: 0.0,
        "{diameter} + ", ""),
)  # fmt: skip
