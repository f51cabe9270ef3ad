"""Mistakes with pi, with kinds of light, with the light meter, and slips of units."""

import math
from collections.abc import Iterator

from radcalc.geometry import lobes, solid
from radcalc.homework.catalogue import Problem, light_of, mistake
from radcalc.quantities.light import GRID
from radcalc.spectra.observers import OBSERVERS
from radcalc.units.dimensions import AREA, LENGTH, SOLID_ANGLE, TIME


def _is_diffuse(p: Problem) -> bool:
    names = {"reflectance", "radiance", "exitance", "incident-irradiance", "hemisphere"}
    return p.facts.command == "lambertian" or bool(names & set(p.given)) or bool(p.facts.per_pi)


@mistake(
    "pi-forgotten",
    1,
    "pi was forgotten, or put in where it does not belong",
    "M = pi L, so L = rho E / pi; lambert, foot-lambert and apostilb carry the 1/pi",
)
def _no_pi(p: Problem) -> Iterator[float]:
    if _is_diffuse(p):
        yield p.right * math.pi
        yield p.right / math.pi


@mistake(
    "two-pi-for-pi",
    1,
    "2 pi was used for pi: the cosine in the integral over the hemisphere",
    "M = pi L Omega0, since each direction counts with its cosine",
)
def _two_pi(p: Problem) -> Iterator[float]:
    if _is_diffuse(p):
        yield p.right * 2
        yield p.right / 2


@mistake(
    "wrong-sphere",
    2,
    "the flux was spread over the wrong solid angle (2 pi, pi or none)",
    "an isotropic source shines into 4 pi sr: I = Phi / (4 pi sr)",
)
def _sphere(p: Problem) -> Iterator[float]:
    fluxes = {"flux", "luminous-flux", "radiant-flux", "photon-flux", "energy", "luminous-energy"}
    crossed = (p.target.name in fluxes) != bool(fluxes & set(p.given))
    if "isotropic" in p.given or (p.facts.distribution == "isotropic" and crossed):
        for factor in (2.0, 4.0, 4 * math.pi):
            yield p.right * factor
            yield p.right / factor


@mistake(
    "lobe-without-one",
    1,
    "n was used for n + 1 in the flux of a lobe",
    "Phi = 2 pi I0 / (n + 1)",
)
def _lobe(p: Problem) -> Iterator[float]:
    n = p.si("exponent")
    if n and light_of(p):
        yield p.right * (n + 1)
        yield p.right / (n + 1)
        yield p.right * (n + 1) / n
        yield p.right * n / (n + 1)


@mistake(
    "spot-as-sphere",
    2,
    "the peak candelas of a spot were taken times 4 pi",
    "a spot fills only its own solid angle",
)
def _spot(p: Problem) -> Iterator[float]:
    omega, n, half = p.si("solid-angle"), p.si("exponent"), p.half_angle()
    if n is None and "beam-angle" in p.given:
        n = lobes.exponent(p.given["beam-angle"].value, 0.5)
    if omega is None and half:
        omega = solid.cone(half)
    if omega is None and n is not None:
        omega = 2 * math.pi / (n + 1)
    if omega and light_of(p) and p.facts.command in ("point-source", "convert"):
        yield p.right * 4 * math.pi / omega
        yield p.right * omega / (4 * math.pi)


@mistake(
    "cone-for-lobe",
    3,
    "the beam angle was taken as the edge of a uniform cone",
    "a beam angle is where half the peak is left: the lobe has more flux than the cone",
)
def _cone(p: Problem) -> Iterator[float]:
    beam, n = p.si("beam-angle"), p.si("exponent")
    if beam and n is not None and light_of(p):
        ratio = solid.cone(beam / 2) / (2 * math.pi / (n + 1))
        yield p.right * ratio
        yield p.right / ratio


@mistake(
    "reflectance-forgotten",
    2,
    "the reflectance was left out",
    "a reflector gives back rho of what it gets",
)
def _rho(p: Problem) -> Iterator[float]:
    rho = p.si("reflectance")
    if rho and rho != 1:
        yield p.right / rho
        yield p.right * rho


@mistake(
    "f-number-without-four",
    3,
    "the 4 in pi A / (4 N^2) was forgotten",
    "sin(alpha) = 1/(2 N)",
)
def _four(p: Problem) -> Iterator[float]:
    if p.facts.command == "etendue" and "f-number" in p.given:
        yield p.right * 4


@mistake(
    "683-for-any-light",
    1,
    "683 lm/W was used, which holds at 555 nm alone",
    "lm = 683 V(lambda) W for one wavelength; a spectrum has its own efficacy",
)
def _km(p: Problem) -> Iterator[float]:
    efficacy = p.facts.efficacy or p.si("luminous-efficacy")
    if efficacy and p.target.name == "luminous-efficacy":
        yield 683.0
    elif efficacy and light_of(p):
        for top in (683.0, 683.002):
            ratio = top / efficacy
            yield p.right * ratio
            yield p.right / ratio


@mistake(
    "scotopic-for-photopic",
    3,
    "683 lm/W and V(lambda) were mixed with the 1700 lm/W of the dark-adapted eye",
    "photopic: 683 lm/W and V; scotopic: 1700 lm/W and V'",
)
def _night(p: Problem) -> Iterator[float]:
    day, night = OBSERVERS["photopic"].maximum, OBSERVERS["scotopic"].maximum
    name = p.target.name
    if "efficacy" in name or "scotopic" in name or p.facts.efficacy or p.si("luminous-efficacy"):
        for ratio in (night / day, 1700 / 683):
            yield p.right * ratio
            yield p.right / ratio


@mistake(
    "nanometres-for-metres",
    2,
    "nanometres were used for metres in h c / lambda",
    "h c / lambda takes the wavelength in metres",
)
def _nano(p: Problem) -> Iterator[float]:
    if "wavelength" in p.given or p.facts.command == "photon":
        for factor in (1e9, 1e-9, 1e7, 1e-7, 1e2, 1e-2):
            yield p.right * factor


@mistake(
    "avogadro",
    2,
    "Avogadro's number was left out, or used twice",
    "1 mol of photons is 6.022e23 of them",
)
def _mole(p: Problem) -> Iterator[float]:
    counted = [*p.target.dimensions, *(g.dimension for g in p.given.values() if g.dimension)]
    if any(dimension[_COUNT] for dimension in counted) or ("wavelength" in p.given and light_of(p)):
        for factor in (6.02214076e23, 6.02214076e17):
            yield p.right * factor
            yield p.right / factor


_COUNT = next(
    index for index, power in enumerate(next(d for d in GRID if GRID[d][:2] == ("p", 1))) if power
)


@mistake(
    "step-width-forgotten",
    2,
    "the width of the band, or of the steps of a sum, was left out",
    "a band is the density times its width",
)
def _width(p: Problem) -> Iterator[float]:
    one = p.given.get("bandwidth")
    if one and isinstance(one.number, (int, float)) and one.number:
        yield p.right / one.number
        yield p.right * one.number


@mistake(
    "jacobian-forgotten",
    2,
    "the density was converted as if it were a plain value",
    "E_nu = E_lambda lambda^2 / c: the width of the interval changes too",
)
def _jacobian(p: Problem) -> Iterator[float]:
    factor = p.facts.jacobian
    if factor:
        yield p.facts.unchanged
        yield p.right / factor
        yield p.right / factor**2


@mistake(
    "log10-for-log2",
    1,
    "the logarithm to the base 10 was used for that to the base 2",
    "EV = log2(N^2 / t): one step is a factor of 2",
)
def _log(p: Problem) -> Iterator[float]:
    if p.target.name in ("ev", "ev100"):
        yield p.right * math.log10(2)
        yield p.right * math.log(2)


@mistake(
    "n-not-squared",
    1,
    "the f-number was not squared",
    "EV = log2(N^2 / t)",
)
def _squared(p: Problem) -> Iterator[float]:
    n = p.si("f-number")
    if n and p.facts.command == "ev":
        if p.target.name in ("ev", "ev100"):
            yield p.right - math.log2(n)
        elif (
            p.target.name in ("luminance", "illuminance", "saturation-luminance")
            or p.target.name == "time"
        ):
            yield p.right / n


@mistake(
    "k-for-c",
    1,
    "the constant of reflected light was used for incident light, or the other way round",
    "L = K 2^EV100 / 100 with K = 12.5, E = C 2^EV100 / 100 with C = 250",
)
def _constants(p: Problem) -> Iterator[float]:
    k, c = p.si("k"), p.si("c")
    if k and c and p.facts.command == "ev":
        if p.target.name == "luminance":
            yield p.right * c / k
        elif p.target.name == "illuminance":
            yield p.right * k / c
        elif p.target.name in ("ev", "ev100"):
            yield p.right + math.log2(c / k)
            yield p.right - math.log2(c / k)


@mistake(
    "iso-forgotten",
    2,
    "the ISO speed was left out",
    "EV100 = EV - log2(S / 100)",
)
def _iso(p: Problem) -> Iterator[float]:
    if "iso" in p.given and p.facts.command == "ev":
        yield from p.anew(iso=100.0)


@mistake(
    "minutes-for-seconds",
    3,
    "hours or minutes were used as seconds",
    "a watt is a joule per second",
)
def _seconds(p: Problem) -> Iterator[float]:
    for one in p.named(TIME):
        if isinstance(one.number, (int, float)) and one.unit and one.unit.text != "s":
            yield from p.anew(**{one.name: float(one.number)})


@mistake(
    "length-unit",
    3,
    "a length was used in another unit (cm or mm for m, feet for metres)",
    "lengths go into the formula in one unit",
)
def _length(p: Problem) -> Iterator[float]:
    for one in p.named(LENGTH):
        if one.name == "wavelength":
            continue
        for factor in (100.0, 0.01, 1000.0, 0.001, 0.3048, 1 / 0.3048):
            yield from p.anew(**{one.name.replace("-", "_"): one.value * factor})


@mistake(
    "area-unit",
    3,
    "an area was converted as a length is",
    "1 m2 is 10 000 cm2, 1 m = 100 cm",
)
def _area(p: Problem) -> Iterator[float]:
    for one in p.named(AREA):
        for factor in (1e2, 1e-2, 1e3, 1e-3, 1e4, 1e-4, 1e6, 1e-6):
            yield from p.anew(**{one.name.replace("-", "_"): one.value * factor})
        for factor in (1e2, 1e-2, 1e4, 1e-4):  # where the patch would be too large for its law
            yield p.right * factor


@mistake(
    "feet-for-metres",
    4,
    "feet and metres were mixed up",
    "1 ft = 0.3048 m, and 1 fc = 10.764 lx",
)
def _feet(p: Problem) -> Iterator[float]:
    light = light_of(p)
    if light and light[2]:
        for factor in (0.3048**2, 0.3048):
            yield p.right * factor
            yield p.right / factor


@mistake(
    "power-of-ten",
    4,
    "the answer is off by a power of ten: a slip of a prefix",
    "m is 1e-3, u is 1e-6, k is 1e3",
)
def _ten(p: Problem) -> Iterator[float]:
    for power in (1, 2, 3, 4, 6, 9):
        yield p.right * 10.0**power
        yield p.right / 10.0**power


@mistake(
    "deg2-for-sr",
    3,
    "square degrees and steradians were mixed up",
    "1 sr = (180/pi)^2 deg2 = 3282.81 deg2",
)
def _square_degrees(p: Problem) -> Iterator[float]:
    if SOLID_ANGLE in p.target.dimensions:
        factor = (180 / math.pi) ** 2
        for ratio in (factor, 180 / math.pi):
            yield p.right * ratio
            yield p.right / ratio
