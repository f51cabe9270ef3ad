"""Radiant, luminous and photon quantities: efficacies, h c / lambda, moles, and densities."""

from collections.abc import Iterator

from radcalc.homework.catalogue import Problem, mistake, mistake_factor
from radcalc.spectra.observers import OBSERVERS
from radcalc.spectra.planck import AVOGADRO
from radcalc.units.table import COUNT_AT


@mistake(
    "683-for-any-light",
    1,
    "683 lm/W was used, which holds at 555 nm alone",
    "lm = 683 V(lambda) W for one wavelength; a spectrum has its own efficacy",
)
def _same_for_any_light(p: Problem) -> Iterator[float]:
    efficacy = p.facts.efficacy or p.amount("luminous-efficacy")
    if efficacy and p.asks("luminous-efficacy"):
        yield 683.0
    elif efficacy and p.light:
        yield from p.both(683.0 / efficacy, OBSERVERS["photopic"].maximum / efficacy)


@mistake_factor(
    "scotopic-for-photopic",
    3,
    "683 lm/W and V(lambda) were mixed with the 1700 lm/W of the dark-adapted eye",
    "photopic: 683 lm/W and V; scotopic: 1700 lm/W and V'",
)
def _scotopic_for_photopic(p: Problem) -> Iterator[float]:
    is_of_eyes = any(word in p.target.name for word in ("efficacy", "scotopic"))
    if is_of_eyes or p.facts.efficacy or p.amount("luminous-efficacy"):
        yield OBSERVERS["scotopic"].maximum / OBSERVERS["photopic"].maximum
        yield 1700 / 683


@mistake_factor(
    "nanometres-for-metres",
    2,
    "nanometres were used for metres in h c / lambda",
    "h c / lambda takes the wavelength in metres",
)
def _nanometres_for_metres(p: Problem) -> Iterator[float]:
    if p.has("wavelength") or p.is_of("photon"):
        yield from (1e9, 1e7, 1e2)  # the last two where the result is per centimetre


@mistake_factor(
    "avogadro",
    2,
    "Avogadro's number was left out, or used twice",
    "1 mol of photons is 6.022e23 of them",
)
def _avogadro(p: Problem) -> Iterator[float]:
    dimensions = (*p.target.dimensions, *(one.dimension for one in p.given.values()))
    is_counted = any(dimension[COUNT_AT] for dimension in dimensions)
    if is_counted or (p.has("wavelength") and p.light):
        yield from (AVOGADRO, AVOGADRO * 1e-6)  # umol


@mistake_factor(
    "step-width-forgotten",
    2,
    "the width of the band, or of the steps of a sum, was left out",
    "a band is the density times its width",
)
def _step_width_forgotten(p: Problem) -> Iterator[float]:
    if width := p.number("bandwidth"):
        yield width


@mistake(
    "jacobian-forgotten",
    2,
    "the density was converted as if it were a plain value",
    "E_nu = E_lambda lambda^2 / c: the width of the interval changes too",
)
def _jacobian_forgotten(p: Problem) -> Iterator[float]:
    if jacobian := p.facts.jacobian:
        yield p.facts.unchanged
        yield p.right / jacobian
        yield p.right / jacobian**2
