"""Cones, lobes and other shapes: the wrong formula for a solid angle, or the wrong solid angle."""

import math
from collections.abc import Iterator

from radcalc.geometry import cones, lobes
from radcalc.homework.catalogue import Problem, mistake, mistake_factor


@mistake(
    "arctangent-for-arcsine",
    2,
    "the tangent was used for the sine (or the sine for the tangent)",
    "a sphere's edge: sin(alpha) = R/d; a disc's rim: tan(alpha) = R/h",
)
def _arctangent_for_arcsine(p: Problem) -> Iterator[float]:
    radius, distance = p.radius(), p.amount("distance") or p.amount("height")
    wrong = {"sphere": math.atan, "disc": math.asin}.get(p.facts.shape)
    if not wrong or not radius or not distance or radius >= distance:
        return
    half = wrong(radius / distance)
    projected = cones.projected_cone(half)
    if p.asks("half-angle"):
        yield half
    elif p.asks("apex-angle"):
        yield 2 * half
    elif p.asks("solid-angle"):
        yield cones.cone(half)
    elif p.asks("projected-solid-angle"):
        yield projected
    elif p.light and (right := p.amount("projected-solid-angle")):
        yield p.right * projected / right


@mistake(
    "flat-disc-for-cap",
    2,
    "the area of a flat disc over d^2 was used for the cap of the sphere",
    "Omega = 2 pi (1 - cos(alpha)); pi tan^2 and pi alpha^2 are only its beginning",
)
def _flat_disc_for_cap(p: Problem) -> Iterator[float]:
    given, half = p.half_angle(), p.amount("half-angle")
    for flat in _flat_discs(given):
        if p.light and p.is_of("point-source", "convert"):
            yield from p.both(flat / cones.cone(given))
        elif p.is_of("etendue"):
            yield p.right * flat / cones.projected_cone(given)
    if p.asks("solid-angle") and half and half < math.pi / 2:
        yield from (*_flat_discs(half), cones.projected_cone(half))
    elif p.asks("half-angle", "apex-angle") and (omega := p.amount("solid-angle")):
        ratio = math.sqrt(omega / math.pi)
        for angle in (ratio, math.atan(ratio)):
            yield angle * (2 if p.asks("apex-angle") else 1)


def _flat_discs(half: float | None) -> tuple[float, ...]:
    """What is taken for the solid angle of a cone of less than a hemisphere [sr]."""
    if not half or half >= math.pi / 2:
        return ()
    return math.pi * math.tan(half) ** 2, math.pi * half**2


@mistake(
    "solid-for-projected",
    2,
    "the solid angle was used for the projected one, or the other way round",
    "between L and E stands the projected solid angle: pi sr for a hemisphere, not 2 pi",
)
def _solid_for_projected(p: Problem) -> Iterator[float]:
    plain, projected = p.amount("solid-angle"), p.amount("projected-solid-angle")
    half = p.half_angle()
    if half and p.is_of("etendue", "convert"):
        plain, projected = cones.cone(half), cones.projected_cone(half)
    if not plain or not projected:
        return
    if p.asks("solid-angle"):
        yield projected
    elif p.asks("projected-solid-angle"):
        yield plain
    elif p.light or p.asks("etendue", "value"):
        yield from p.both(plain / projected)


@mistake(
    "zone-of-caps",
    2,
    "a zone was taken as one cap, or as the sum of two",
    "the zone is the outer cap less the inner one: 2 pi (cos t0 - cos t1)",
)
def _zone_of_caps(p: Problem) -> Iterator[float]:
    ends = p.given["polar"].value if p.has("polar") else None
    if isinstance(ends, tuple) and p.asks("solid-angle", "projected-solid-angle", "integral"):
        inner, outer = map(cones.cone, ends)
        for caps in (outer + inner, outer, inner):
            yield p.right * caps / (outer - inner)


@mistake(
    "f-number-without-four", 3, "the 4 in pi A / (4 N^2) was forgotten", "sin(alpha) = 1/(2 N)"
)
def _f_number_without_four(p: Problem) -> Iterator[float]:
    if p.is_of("etendue") and p.has("f-number"):
        yield p.right * 4


@mistake_factor(
    "lobe-without-one", 1, "n was used for n + 1 in the flux of a lobe", "Phi = 2 pi I0 / (n + 1)"
)
def _lobe_without_one(p: Problem) -> Iterator[float]:
    if p.light and (n := p.amount("exponent")):
        yield n + 1
        yield (n + 1) / n


@mistake_factor(
    "spot-as-sphere",
    2,
    "the peak candelas of a spot were taken times 4 pi",
    "a spot fills only its own solid angle",
)
def _spot_as_sphere(p: Problem) -> Iterator[float]:
    half, n = p.half_angle(), _exponent(p)
    omega = p.amount("solid-angle")
    if omega is None and half:
        omega = cones.cone(half)
    elif omega is None and n is not None:
        omega = lobes.solid_angle(n)
    if omega and p.light and p.is_of("point-source", "convert"):
        yield cones.FULL / omega


@mistake_factor(
    "cone-for-lobe",
    3,
    "the beam angle was taken as the edge of a uniform cone",
    "a beam angle is where half the peak is left: the lobe has more flux than the cone",
)
def _cone_for_lobe(p: Problem) -> Iterator[float]:
    beam, n = p.amount("beam-angle"), _exponent(p)
    if beam and n is not None and p.light:
        yield cones.cone(beam / 2) / lobes.solid_angle(n)


def _exponent(p: Problem) -> float | None:
    """The exponent of the lobe; a conversion does not give it beside the beam angle."""
    n, beam = p.amount("exponent"), p.input("beam-angle")
    return float(lobes.exponent(beam, 0.5)) if n is None and beam else n
