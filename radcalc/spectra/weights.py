"""The weights of spectra: functions of the wavelength, each of which counts a kind of light.

A weighted amount is the integral of S(lambda) w(lambda), of watts or, for a weight of photons, of
photons; the lumens of an observer are its constant times the watts weighted by its table.  The rows
are those of `units/weights.tsv`, and the user's own.  Weights are linear between their points.
"""

import math
from functools import cache
from typing import TYPE_CHECKING, Any

from radcalc.errors import ConditionError, add, nearest, quote
from radcalc.maths import is_array, rounded
from radcalc.quantities import KIND_NAMES, LUMINOUS, PHOTON, RADIANT, base_of, ratio_unit
from radcalc.quantities.names import data_rows
from radcalc.spectra.observers import (
    AVOGADRO,
    LIGHT,
    OBSERVERS,
    PLANCK,
    Observer,
    lumens_per_photon,
    luminous_efficacy,
    photons,
)
from radcalc.tuples import NamedTuple
from radcalc.units.compiled import WEIGHTS

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from radcalc.spectra.spectrum import Range, Spectrum


class Weight(NamedTuple):
    """A weight: w at points from `start` [nm] at equal steps, 0 outside, and its source.

    `acts_on` is the light that it weights, watts or photons.
    """

    kind: str
    label: str
    acts_on: str
    start: float
    step: float
    values: tuple[float, ...]
    source: str

    @property
    def range(self) -> "Range":
        """Its first and its last wavelength [nm]."""
        return self.start, self.start + self.step * (len(self.values) - 1)

    @property
    def per_watt(self) -> "Sequence[float]":
        """The weighted light of a watt at each point: photons, if it is a weight of photons."""
        if self.acts_on == RADIANT:
            return self.values
        return [w * photons(self.start + self.step * k) for k, w in enumerate(self.values)]

    @property
    def described(self) -> str:
        """Its name and its source, for derivations."""
        return f"w({KIND_NAMES[self.kind]}): {self.source}"

    def at(self, nanometres: Any) -> Any:
        """Return w at a wavelength or an array of them [nm]; 0 outside its range."""
        place = (rounded(nanometres, 9) - self.start) / self.step
        last = len(self.values) - 1
        if is_array(place):
            import numpy

            return numpy.interp(place, numpy.arange(last + 1), self.values, left=0, right=0)
        if not 0 <= place <= last:
            return 0.0
        index = min(int(place), last - 1)
        below, above = self.values[index], self.values[index + 1]
        return below + (above - below) * (place - index)


def erythema(nanometres: float) -> float:
    """Return the erythema action spectrum of ISO/CIE 17166:2019 at a wavelength [nm].

    Examples
    --------
    >>> erythema(298.0), round(erythema(328.0), 9)
    (1.0, 0.001513561)
    """
    if nanometres <= 298:
        return 1.0
    if nanometres <= 328:
        return 10 ** (0.094 * (298 - nanometres))
    return 10 ** (0.015 * (140 - nanometres))


FORMULAS: "dict[str, Callable[[float], float]]" = {"erythema": erythema, "band": lambda _: 1.0}
STEPS = {"erythema": 0.5}  # nm; others have 1 nm
LOGARITHMIC = ("actinic_uv",)  # tables whose logarithm is linear between their points
OWN: dict[str, Weight] = {}  # the weights of files, by kind


@cache
def _rows() -> dict[str, list[str]]:
    return {row[1]: row for row in data_rows("weights", "units")}


@cache
def weight(kind: str) -> Weight:
    """Return the weight of a kind that is not of an observer."""
    if kind in OWN:
        return OWN[kind]
    name, _, _, base, adjective, table, low, high, _, source = _rows()[kind]
    first, last, step = float(low), float(high), STEPS.get(table, 1.0)
    grid = [first + step * k for k in range(round((last - first) / step) + 1)]
    values = map(FORMULAS.get(table) or _of_table(table, name), grid)
    return Weight(kind, adjective, base, first, step, tuple(values), source)


def _of_table(table: str, column: str) -> "Callable[[float], float]":
    """Return the function of a column of a file of data, between its points and 0 outside."""
    from radcalc.spectra.spectrum import at

    lines = data_rows(table, "spectra/data")
    titles = _titles(table)
    place = titles.index(column) if column in titles else 1
    points = [(float(line[0]), float(line[place])) for line in lines if line[place]]
    grid, values = [nm for nm, _ in points], [w for _, w in points]
    if table in LOGARITHMIC:
        logs = [math.log(w) for w in values]
        return lambda nm: math.exp(at(grid, logs, nm)) if grid[0] <= nm <= grid[-1] else 0.0
    return lambda nm: at(grid, values, nm) if grid[0] <= nm <= grid[-1] else 0.0


def _titles(table: str) -> list[str]:
    (titles,) = data_rows(table, "spectra/data", titles=True)
    return titles


def names() -> dict[str, str]:
    """Return the kinds of the weights by their names."""
    return {row[0]: kind for kind, row in WEIGHTS.items()}


def kind_of(text: str) -> str:
    """Return the kind of a weight by its name."""
    known = names()
    folded = text.lower().replace("_", "-").replace(" ", "-")
    if folded in known:
        return known[folded]
    near = nearest(folded, known)
    hint = [add("weight", name) for name in near] or ", ".join(known)
    raise ConditionError(f"unknown weight '{quote(text)}'", hint)


def observer_of(kind: str) -> Observer | None:
    """Return the observer whose lumens a kind has, or None."""
    if base_of(kind) != LUMINOUS:
        return None
    return OBSERVERS[WEIGHTS[kind][0] if kind in WEIGHTS else "photopic"]


def per_watt(kind: str, nanometres: Any) -> Any:
    """Return the light of a kind in a watt of one wavelength [nm, in vacuum for photons]."""
    if kind == RADIANT:
        return 1.0
    if kind == PHOTON:
        return nanometres * 1e-9 / (PLANCK * LIGHT)
    if eye := observer_of(kind):
        return luminous_efficacy(nanometres * 1e-9, eye)
    own = weight(kind)
    return own.at(nanometres) * per_watt(own.acts_on, nanometres)


def count(source: "Spectrum", kind: str) -> float:
    """Return the amount of a weighted kind in a spectrum: lumens, weighted watts or photons."""
    if eye := observer_of(kind):
        return source.lumens(eye)
    own = weight(kind)
    if _is_band(kind) and own.acts_on == RADIANT:
        return source.power(own.range)
    if _is_band(kind):
        return source.photons(own.range)
    return source.weigh(own.start, own.per_watt, own.step)


def _is_band(kind: str) -> bool:
    return kind not in OWN and _rows()[kind][5] == "band"


def range_of(kind: str) -> "Range | None":
    """Return the range [nm] of a weight that a spectrum must cover, or None."""
    return weight(kind).range if kind in WEIGHTS and observer_of(kind) is None else None


def refuse_uncovered(source: "Spectrum", kind: str) -> None:
    """Refuse a spectrum whose data do not cover the range of a weight, and name what is missing."""
    from radcalc.spectra.spectrum import Table, range_text

    limits = range_of(kind)
    if limits is None or source.is_whole or not isinstance(source, Table):
        return
    (low, high), (start, end) = limits, source.covered
    missing = [(low, min(start, high))] if low < start else []
    missing += [(max(end, low), high)] if high > end else []
    if missing:
        raise ConditionError(
            f"the data of {quote(source.label)} cover {range_text(source.known)}, without "
            f"{' and '.join(map(range_text, missing))} of the {KIND_NAMES[kind]} weight",
            [add("dark-outside", remark="if it has no light there")],
        )


GRID = tuple([float(nm) for nm in range(100, 1201)])  # for the bounds of ratios


def bounds(top: str, bottom: str, limits: "Range") -> tuple[float, float]:
    """Return the least and the greatest ratio of two kinds, of light within a range."""
    eyes = [observer_of(kind) for kind in (top, bottom)]
    if {top, bottom} == {RADIANT, PHOTON}:
        return photons(limits[0]), photons(limits[1])
    if bottom == PHOTON and (eye := eyes[0]):
        return lumens_per_photon(eye, limits)
    if bottom == RADIANT and (eye := eyes[0]):
        return 0.0, eye.maximum
    ratios = [
        per_watt(top, nm) / below if below else math.inf
        for nm in GRID
        if limits[0] <= nm <= limits[1]
        if (below := per_watt(bottom, nm)) or per_watt(top, nm)
    ]
    return min(ratios, default=0.0), max(ratios, default=0.0)


def ratio_text(ratio: float, over: str, under: str) -> str:
    """Return a ratio of kinds in its usual unit: lm/W, umol/J, lm s/umol or mW_mel/lm."""
    bases = base_of(over), base_of(under)
    unit = ratio_unit(over, under)
    if bases == (LUMINOUS, PHOTON):
        return f"{ratio * AVOGADRO * 1e-6:.6g} {unit.replace('photon', 'umol')}"
    if bases == (PHOTON, RADIANT):
        return f"{ratio / AVOGADRO * 1e6:.6g} {unit.replace('photon', 'umol')}"
    if bases == (RADIANT, PHOTON) and over in WEIGHTS:
        return f"{ratio * AVOGADRO * 1e-6:.6g} {unit.replace('photon', 'umol')}"
    if bases == (RADIANT, LUMINOUS) and over in WEIGHTS:
        return f"{ratio * 1e3:.6g} m{unit}"
    return f"{ratio:.6g} {unit}"
