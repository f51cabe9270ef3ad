"""Diffuse surfaces and sources that shine all round: pi, 2 pi and 4 pi, and the reflectance."""

import math
from collections.abc import Iterator

from radcalc.geometry.cones import FULL, HEMISPHERE
from radcalc.homework.catalogue import Problem, mistake_factor


def _is_diffuse(p: Problem) -> bool:
    if p.is_of("lambertian") or p.facts.per_pi or p.has("reflectance", "hemisphere"):
        return True
    return p.is_of("etendue") and p.has("radiance")


@mistake_factor(
    "pi-forgotten",
    1,
    "pi was forgotten, or put in where it does not belong",
    "M = pi L, so L = rho E / pi; lambert, foot-lambert and apostilb carry the 1/pi",
)
def _pi_forgotten(p: Problem) -> Iterator[float]:
    if _is_diffuse(p):
        yield math.pi


@mistake_factor(
    "two-pi-for-pi",
    1,
    "2 pi was used for pi: the cosine in the integral over the hemisphere",
    "M = pi L Omega0, since each direction counts with its cosine",
)
def _two_pi_for_pi(p: Problem) -> Iterator[float]:
    if _is_diffuse(p):
        yield 2.0


@mistake_factor(
    "wrong-sphere",
    2,
    "the flux was spread over the wrong solid angle (2 pi, pi or none)",
    "an isotropic source shines into 4 pi sr: I = Phi / (4 pi sr)",
)
def _wrong_sphere(p: Problem) -> Iterator[float]:
    flux = ("flux", "energy")
    is_crossed = p.asks(*flux) != p.has(*flux)  # from a flux to an intensity, or back
    if p.has("isotropic") or (p.facts.distribution == "isotropic" and is_crossed):
        yield from (FULL / HEMISPHERE, FULL / math.pi, FULL)  # the last where none was used


@mistake_factor(
    "reflectance-forgotten",
    2,
    "the reflectance was left out",
    "a reflector gives back rho of what it gets",
)
def _reflectance_forgotten(p: Problem) -> Iterator[float]:
    if rho := p.amount("reflectance"):
        yield rho
