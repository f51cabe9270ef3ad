"""The mistakes that learners make, each as what it makes of the right answer.

A mistake is either another input (the full angle as the half angle), with which the answer is
worked out anew, or a factor.  It is offered only where it can have been made: a forgotten cosine
where there is a cosine.  `rank` is how common it is and how much of this law: 1 comes first.
"""

import math
from collections.abc import Callable, Iterable, Iterator
from typing import Any, NamedTuple

from radcalc.conditions import ANGLE, LENGTH, Given
from radcalc.errors import RadcalcError
from radcalc.geometry import solid
from radcalc.maths import is_array
from radcalc.quantities import AREA, DURATION, GRID, LUMINOUS, SOLID_ANGLE
from radcalc.result import Value
from radcalc.spectra.observers import OBSERVERS


class Candidate(NamedTuple):
    """A wrong value [SI], and the mistake that leads there."""

    mistake: str
    rank: int
    value: float
    done: str
    right: str


class Problem:
    """The question as the mistakes see it."""

    def __init__(
        self,
        given: dict[str, Given],
        values: list[Value],
        work_out: Callable[[dict[str, Given]], list[Value]],
        facts: dict[str, Any],
        target: Value,
    ) -> None:
        """Hold it; `right` is the right value [SI] of the target."""
        self.given, self.facts, self.target = given, facts, target
        self.values = {v.name: v for v in values}
        self._work_out = work_out
        self.right = float(target.si)

    def si(self, name: str) -> float | None:
        """What was given or follows [SI]."""
        if name in self.given:
            value = self.given[name].value
            return None if is_array(value) else float(value)
        found = self.values.get(name)
        try:
            return float(found.si) if found else None
        except (RadcalcError, TypeError):
            return None

    def named(self, *dimensions: Any) -> list[Given]:
        """The inputs of some dimensions."""
        return [
            g
            for g in self.given.values()
            if g.dimension in dimensions and isinstance(g.value, float)
        ]

    def anew(self, **changed: float) -> Iterator[float]:
        """The target with inputs changed [SI], where that is possible."""
        given = dict(self.given)
        for key, value in changed.items():
            name = key.replace("_", "-")
            given[name] = given[name]._replace(value=value, is_exact=True)
        yield from self.of(given)

    def of(self, given: dict[str, Given]) -> Iterator[float]:
        """The target from other inputs, where that is possible."""
        try:
            for value in self._work_out(given):
                if value.name == self.target.name and value.dimensions == self.target.dimensions:
                    number = float(value.si)
                    if math.isfinite(number):
                        yield number
                    return
        except (RadcalcError, ValueError, ZeroDivisionError, OverflowError, KeyError, TypeError):
            return


Finder = Callable[[Problem], Iterable[float]]
_ALL: list[tuple[str, int, str, str, Finder]] = []


def mistake(name: str, rank: int, done: str, right: str) -> Callable[[Finder], Finder]:
    """Enter a mistake into the catalogue."""

    def enter(find: Finder) -> Finder:
        _ALL.append((name, rank, done, right, find))
        return find

    return enter


def candidates(problem: Problem) -> list[Candidate]:
    """Every wrong value that one mistake leads to."""
    found = []
    for name, rank, done, right, find in _ALL:
        for value in find(problem):
            if math.isfinite(value) and abs(value - problem.right) > 1e-9 * abs(problem.right):
                found.append(Candidate(name, rank, value, done, right))
    return found


SINGLY = 4  # the ranks that are common enough to be made together with a slip of unit


def pairs(problem: Problem) -> list[Candidate]:
    """What two common mistakes together lead to: one of the law, one of the unit."""
    one = [c for c in candidates(problem) if c.rank <= SINGLY and c.mistake not in SLIPS]
    other = [c for c in candidates(problem) if c.mistake in SLIPS and c.rank <= SINGLY + 2]
    if not problem.right:
        return []
    return [
        Candidate(
            f"{a.mistake} and {b.mistake}",
            a.rank + b.rank,
            a.value * b.value / problem.right,
            f"{a.done}; and {b.done}",
            f"{a.right}; {b.right}",
        )
        for a in one
        for b in other
    ]


SLIPS = ("power-of-ten", "length-unit", "area-unit")


def _light(problem: Problem) -> tuple[str, int, int, int, str] | None:
    """Kind, time, area, solid angle, axis of the target, where it is light."""
    return GRID.get(problem.target.dimensions[0])


# --- angles -------------------------------------------------------------------------------


@mistake(
    "cosine-forgotten",
    1,
    "the cosine of the incidence was left out",
    "E = I cos(theta) / d^2: a tilted surface catches less light",
)
def _no_cosine(p: Problem) -> Iterator[float]:
    for name in ("incidence", "tilt"):
        if name in p.given and p.given[name].value:
            yield from p.anew(**{name: 0.0})
            cosine = math.cos(p.given[name].value)
            if name in p.values and cosine > 0 and p.target.name != name:
                yield p.right / cosine
    off = p.si("off-axis")
    if "height" in p.given and "incidence" not in p.given and off and math.cos(off) > 0:
        yield p.right / math.cos(off)


@mistake(
    "cosine-squared",
    5,
    "the cosine was taken twice or three times",
    "E = I cos(theta) / d^2 with the slant distance has one cosine (cos^3 goes with the height)",
)
def _more_cosines(p: Problem) -> Iterator[float]:
    angle = p.si("incidence")
    if angle and math.cos(angle) > 0:
        for power in (1, 2):
            yield p.right * math.cos(angle) ** power


@mistake(
    "angle-from-surface",
    2,
    "the angle was taken from the surface, not from its normal",
    "incidence and polar angle are counted from the normal",
)
def _from_surface(p: Problem) -> Iterator[float]:
    for name in ("incidence", "tilt", "polar", "elevation", "half-angle"):
        if name in p.given:
            yield from p.anew(**{name.replace("-", "_"): math.pi / 2 - p.given[name].value})
    if p.target.name in ("polar", "elevation", "incidence"):
        yield math.pi / 2 - p.right


@mistake(
    "full-for-half",
    1,
    "the full angle was used as the half angle, or the half angle as the full one",
    "a half angle goes from the axis to the edge, an apex or beam angle from edge to edge",
)
def _full_angle(p: Problem) -> Iterator[float]:
    for name in ("half-angle", "apex-angle", "beam-angle", "field-angle", "horizontal", "vertical"):
        if name in p.given:
            for factor in (2.0, 0.5):
                yield from p.anew(**{name.replace("-", "_"): p.given[name].value * factor})
    if {"horizontal", "vertical"} <= set(p.given):
        for factor in (2.0, 0.5):
            both = {n: p.given[n].value * factor for n in ("horizontal", "vertical")}
            yield from p.anew(**both)
    if p.target.name in ("half-angle", "apex-angle", "beam-angle", "field-angle"):
        yield p.right * 2
        yield p.right / 2


@mistake(
    "degrees-as-radians",
    2,
    "degrees were taken as radians",
    "a calculator set to radians takes 30 as 30 rad, that is 1719 degrees",
)
def _radians(p: Problem) -> Iterator[float]:
    for one in p.named(ANGLE):
        number = one.number if isinstance(one.number, (int, float)) else None
        if number is None or one.unit is None or one.unit.text == "rad":
            continue
        turned = math.fmod(abs(number), 2 * math.pi)
        for angle in (turned, 2 * math.pi - turned):
            yield from p.anew(**{one.option.name.replace("-", "_"): angle})
        if one.option.name == "incidence" and math.cos(one.value):
            yield p.right * math.cos(number) / math.cos(one.value)
        if one.option.name in ("half-angle", "apex-angle") and p.target.name == "solid-angle":
            half = number if one.option.name == "half-angle" else number / 2
            yield 2 * math.pi * (1 - math.cos(half))
    if ANGLE in p.target.dimensions:
        yield p.right * math.pi / 180
        yield p.right * 180 / math.pi


@mistake(
    "wrong-quadrant",
    2,
    "the arc tangent of y/x was taken without looking at the quadrant",
    "phi = atan2(y, x), which knows the signs of both",
)
def _quadrant(p: Problem) -> Iterator[float]:
    if p.target.name == "azimuth":
        for turn in (math.pi, -math.pi, 2 * math.pi, -2 * math.pi):
            yield p.right + turn


# --- distances and sizes --------------------------------------------------------------------


@mistake(
    "one-over-r",
    2,
    "the distance was not squared",
    "irradiance falls as 1/d^2",
)
def _not_squared(p: Problem) -> Iterator[float]:
    if "distance" not in p.given and "height" not in p.given:
        return
    away = p.si("distance")
    one = p.given.get("distance")
    sizes = [away] if away else []
    if one and isinstance(one.number, (int, float)):
        sizes.append(float(one.number))
    for size in sizes:
        if size and p.target.name not in ("distance",):
            yield p.right * size
            yield p.right / size


@mistake(
    "height-for-distance",
    2,
    "the height was used for the slant distance",
    "d is the straight line: d^2 = h^2 + x^2",
)
def _height(p: Problem) -> Iterator[float]:
    height, away = p.si("height"), p.si("distance")
    if height and away and "height" in p.given and away > height:
        for power in (2, 3):
            yield p.right * (away / height) ** power
            yield p.right / (away / height) ** power


@mistake(
    "diameter-for-radius",
    1,
    "the diameter was used for the radius, or the radius for the diameter",
    "R is half the diameter: areas are off by 4",
)
def _diameter(p: Problem) -> Iterator[float]:
    for name in ("radius", "diameter", "receiver-radius", "receiver-diameter", "pupil"):
        if name in p.given:
            for factor in (2.0, 0.5):
                yield from p.anew(**{name.replace("-", "_"): p.given[name].value * factor})
    if p.target.name in ("radius", "diameter"):
        yield p.right * 2
        yield p.right / 2


@mistake(
    "distance-to-surface",
    3,
    "the distance was taken to the sphere's surface",
    "sin(alpha) = R/d, with d to the centre",
)
def _surface(p: Problem) -> Iterator[float]:
    radius, away = p.si("radius"), p.si("distance")
    if "diameter" in p.given:
        radius = p.given["diameter"].value / 2
    if p.facts.get("shape") == "sphere" and radius and away:
        if "distance" in p.given:
            yield from p.anew(distance=away - radius)
            yield from p.anew(distance=away + radius)
        elif p.target.name == "distance":
            yield away - radius


@mistake(
    "arctangent-for-arcsine",
    2,
    "the tangent was used for the sine (or the sine for the tangent)",
    "a sphere's edge: sin(alpha) = R/d; a disc's rim: tan(alpha) = R/h",
)
def _tangent(p: Problem) -> Iterator[float]:
    radius = p.si("radius") or (p.si("diameter") or 0) / 2
    away = p.si("distance") or p.si("height")
    if not radius or not away or p.facts.get("shape") not in ("sphere", "disc"):
        return
    ratio = radius / away
    if p.facts["shape"] == "sphere":
        half = math.atan(ratio)
        others = {
            "solid-angle": solid.cone(half),
            "projected-solid-angle": math.pi * math.sin(half) ** 2,
        }
    elif ratio < 1:
        half = math.asin(ratio)
        others = {"solid-angle": solid.cone(half), "projected-solid-angle": math.pi * ratio**2}
    else:
        return
    if p.target.name == "half-angle":
        yield half
    elif p.target.name == "apex-angle":
        yield 2 * half
    elif p.target.name in others:
        yield others[p.target.name]
    elif (flat := p.si("projected-solid-angle")) and _light(p):
        yield p.right * others["projected-solid-angle"] / flat


@mistake(
    "flat-disc-for-cap",
    2,
    "the area of a flat disc over d^2 was used for the cap of the sphere",
    "Omega = 2 pi (1 - cos(alpha)); pi tan^2 and pi alpha^2 are only its beginning",
)
def _flat(p: Problem) -> Iterator[float]:
    half = p.si("half-angle")
    if p.target.name == "solid-angle" and half and half < math.pi / 2:
        yield math.pi * math.tan(half) ** 2
        yield math.pi * half**2
        yield math.pi * math.sin(half) ** 2
    elif p.target.name in ("half-angle", "apex-angle") and (omega := p.si("solid-angle")):
        twice = 2 if p.target.name == "apex-angle" else 1
        yield twice * math.sqrt(omega / math.pi)
        yield twice * math.atan(math.sqrt(omega / math.pi))


@mistake(
    "far-field-of-extended-source",
    2,
    "the inverse square law was used on an extended source",
    "near a source of some size E = L Omega_p: for a disc pi L R^2/(R^2 + d^2)",
)
def _far(p: Problem) -> Iterator[float]:
    far, near = p.si("far-field-irradiance"), p.si("irradiance")
    if far and near and _light(p) and p.target.name != "far-field-irradiance":
        yield p.right * far / near
        yield p.right * near / far
    if p.target.name == "etendue" and (estimate := p.si("far-field-etendue")):
        yield estimate


@mistake(
    "solid-for-projected",
    2,
    "the solid angle was used for the projected one, or the other way round",
    "between L and E stands the projected solid angle: pi sr for a hemisphere, not 2 pi",
)
def _projected(p: Problem) -> Iterator[float]:
    full, flat = p.si("solid-angle"), p.si("projected-solid-angle")
    half = p.si("half-angle")
    if p.facts.get("command") == "etendue" and half:
        full = solid.cone(half)
    if p.facts.get("command") == "convert" and half is not None and not is_array(half):
        half = half / (2 if "apex-angle" in p.given else 1)
    if p.facts.get("command") == "convert" and ("half-angle" in p.given or "apex-angle" in p.given):
        angle = half if "half-angle" in p.given else (p.si("apex-angle") or 0) / 2
        if angle:
            full, flat = solid.cone(angle), math.pi * math.sin(min(angle, math.pi / 2)) ** 2
    if full and flat:
        if p.target.name == "solid-angle":
            yield flat
        elif p.target.name == "projected-solid-angle":
            yield full
        elif _light(p) or p.target.name in ("etendue", "value"):
            yield p.right * full / flat
            yield p.right * flat / full


@mistake(
    "zone-of-caps",
    2,
    "a zone was taken as one cap, or as the sum of two",
    "the zone is the outer cap less the inner one: 2 pi (cos t0 - cos t1)",
)
def _caps(p: Problem) -> Iterator[float]:
    polar = p.facts.get("polar")
    if polar and p.target.name in ("solid-angle", "projected-solid-angle"):
        inner, outer = map(solid.cone, polar)
        part = p.right / (outer - inner) if outer > inner else 0.0
        yield part * (outer + inner)
        yield part * outer
        yield part * inner


@mistake(
    "inverse-square-on-radiance",
    3,
    "the inverse square law was used on a radiance",
    "a radiance is the same from any distance",
)
def _radiance(p: Problem) -> Iterator[float]:
    light, away = _light(p), p.si("distance")
    if light and light[2] and light[3] and away:
        yield p.right / away**2
        yield p.right * away**2


# --- factors of pi and of shapes -----------------------------------------------------------


def _is_diffuse(p: Problem) -> bool:
    names = {"reflectance", "radiance", "exitance", "incident-irradiance"}
    return (
        p.facts.get("command") == "lambertian"
        or bool(names & set(p.given))
        or bool(p.facts.get("per_pi"))
    )


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
    if "isotropic" in p.given or (p.facts.get("distribution") == "isotropic" and crossed):
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
    if n and _light(p):
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
    omega = p.si("solid-angle")
    n = p.si("exponent")
    if n is not None and omega is None:
        omega = 2 * math.pi / (n + 1)
    if omega is None and "half-angle" in p.given:
        omega = solid.cone(p.given["half-angle"].value)
    if omega and _light(p) and p.facts.get("command") in ("point-source", "convert"):
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
    if beam and n is not None and _light(p):
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
    if p.facts.get("command") == "etendue" and "f-number" in p.given:
        yield p.right * 4


# --- kinds of light ------------------------------------------------------------------------


@mistake(
    "683-for-any-light",
    1,
    "683 lm/W was used, which holds at 555 nm alone",
    "lm = 683 V(lambda) W for one wavelength; a spectrum has its own efficacy",
)
def _km(p: Problem) -> Iterator[float]:
    efficacy = p.facts.get("efficacy")
    if efficacy and _light(p):
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
    luminous = p.target.dimensions[0] in GRID and GRID[p.target.dimensions[0]][0] == LUMINOUS
    if "efficacy" in name or luminous or p.facts.get("efficacy"):
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
    if "wavelength" in p.given or p.facts.get("command") == "photon":
        for factor in (1e9, 1e-9, 1e7, 1e-7, 1e2, 1e-2):
            yield p.right * factor


@mistake(
    "avogadro",
    2,
    "Avogadro's number was left out, or used twice",
    "1 mol of photons is 6.022e23 of them",
)
def _mole(p: Problem) -> Iterator[float]:
    if any(dimension[_COUNT] for dimension in p.target.dimensions):
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
    factor = p.facts.get("jacobian")
    if factor:
        yield p.right / factor
        yield p.right / factor**2


# --- the light meter ----------------------------------------------------------------------


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
    if n and p.facts.get("command") == "ev":
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
    if k and c and p.facts.get("command") == "ev":
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
    if "iso" in p.given and p.facts.get("command") == "ev":
        yield from p.anew(iso=100.0)


# --- slips ---------------------------------------------------------------------------------


@mistake(
    "minutes-for-seconds",
    3,
    "hours or minutes were used as seconds",
    "a watt is a joule per second",
)
def _seconds(p: Problem) -> Iterator[float]:
    for one in p.named(DURATION):
        if isinstance(one.number, (int, float)) and one.unit and one.unit.text != "s":
            yield from p.anew(**{one.option.name: float(one.number)})


@mistake(
    "length-unit",
    3,
    "a length was used in another unit (cm or mm for m, feet for metres)",
    "lengths go into the formula in one unit",
)
def _length(p: Problem) -> Iterator[float]:
    for one in p.named(LENGTH):
        if one.option.name == "wavelength":
            continue
        for factor in (100.0, 0.01, 1000.0, 0.001, 0.3048, 1 / 0.3048):
            yield from p.anew(**{one.option.name.replace("-", "_"): one.value * factor})


@mistake(
    "area-unit",
    3,
    "an area was converted as a length is",
    "1 m2 is 10 000 cm2, 1 m = 100 cm",
)
def _area(p: Problem) -> Iterator[float]:
    for one in p.named(AREA):
        for factor in (1e2, 1e-2, 1e3, 1e-3, 1e4, 1e-4, 1e6, 1e-6):
            yield from p.anew(**{one.option.name.replace("-", "_"): one.value * factor})


@mistake(
    "feet-for-metres",
    4,
    "feet and metres were mixed up",
    "1 ft = 0.3048 m, and 1 fc = 10.764 lx",
)
def _feet(p: Problem) -> Iterator[float]:
    light = _light(p)
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
