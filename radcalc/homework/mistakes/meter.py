"""The light meter: exposure values, f-numbers, the meter's constants and the ISO speed."""

import math
from collections.abc import Iterator

from radcalc.homework.catalogue import Problem, mistake

VALUES = ("ev", "ev100")


@mistake(
    "log10-for-log2",
    1,
    "the logarithm to the base 10 was used for that to the base 2",
    "EV = log2(N^2 / t): one step is a factor of 2",
)
def _log10_for_log2(p: Problem) -> Iterator[float]:
    if p.asks(*VALUES):
        yield p.right * math.log10(2)
        yield p.right * math.log(2)


@mistake("n-not-squared", 1, "the f-number was not squared", "EV = log2(N^2 / t)")
def _n_not_squared(p: Problem) -> Iterator[float]:
    n = p.amount("f-number")
    if not n or not p.is_of("ev"):
        return
    if p.asks(*VALUES):
        yield p.right - math.log2(n)
    elif p.asks("luminance", "illuminance", "saturation-luminance", "time"):
        yield p.right / n


@mistake(
    "k-for-c",
    1,
    "the constant of reflected light was used for incident light, or the other way round",
    "L = K 2^EV100 / 100 with K = 12.5, E = C 2^EV100 / 100 with C = 250",
)
def _k_for_c(p: Problem) -> Iterator[float]:
    k, c = p.amount("k"), p.amount("c")
    if not k or not c or not p.is_of("ev"):
        return
    if p.asks("luminance"):
        yield p.right * c / k
    elif p.asks("illuminance"):
        yield p.right * k / c
    elif p.asks(*VALUES):
        yield p.right + math.log2(c / k)
        yield p.right - math.log2(c / k)


@mistake("iso-forgotten", 2, "the ISO speed was left out", "EV100 = EV - log2(S / 100)")
def _iso_forgotten(p: Problem) -> Iterator[float]:
    if p.is_of("ev") and p.has("iso"):
        yield from p.anew({"iso": 100.0})
