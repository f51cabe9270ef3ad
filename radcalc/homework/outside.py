"""Mistakes that are not in a single law.

Shapes, directions, skies and logs are computed without a chain of laws.  Other mistakes concern
several laws: the wrong observer, a beam used as a sphere, one symbol used for another.
"""

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

from radcalc import geometry
from radcalc.geometry import projections
from radcalc.homework.edits import scaled
from radcalc.homework.formulas import PROJECTED
from radcalc.homework.question import PI_FORGOTTEN, Candidate, Problem, usual
from radcalc.homework.wording import Translatable
from radcalc.quantities.symbols import EFFICACIES, UNIFORM
from radcalc.spectra.observers import AVOGADRO
from radcalc.units.dimensions import SOLID_ANGLE, times

if TYPE_CHECKING:
    from radcalc.spectra.observers import Observer

Found = Iterator[Candidate | None]
PI = math.pi
FLAT = "the flat area over d was used: the distance was not squared"
SOLID = ("solid-angle", "projected-solid-angle")
DAY = 86400.0  # s
HOURS = (12, 16, 8, 10, 14, 18)  # of light in a day
SAME_AS = ("far-field-irradiance", "far-field-etendue")  # approximations of other results
DIFFUSE = "all directions are 4 pi sr, a hemisphere is 2 pi sr, projected pi sr"


def find(p: Problem) -> Iterator[Candidate]:
    """Yield the wrong values from the mistakes of all families below."""
    for family in FAMILIES:
        yield from filter(None, family(p))


# ---------------------------------------------------------------------------------------------
# Results that are computed without a chain of laws


def _away(p: Problem) -> float:
    """Return the distance of a shape, 0 if it is not known or the point is off the axis."""
    away = p.amount("height") or p.amount("distance")
    return away if away and not p.amount("offset") else 0.0


def _hemisphere(p: Problem) -> Found:
    """Use a solid angle for the projected one, or a flat area for either."""
    if p.question.shape == "hemisphere":
        half = p.amount("half-angle") or PI / 2
        for name, wrong, *_ in PROJECTED:
            yield usual(name, p.chain.after("projected-solid-angle", wrong(half)))


def _rectangle(p: Problem) -> Found:
    """Use a rectangle as a small flat area, or a tangent as an angle."""
    away = _away(p)
    if p.question.shape != "rectangle" or not away:
        return
    if not p.light:  # for light, `_far` compares with the far field
        flat = (p.amount("width") or 0.0) * (p.amount("length") or 0.0) / away**2
        for symbol in SOLID:
            yield usual("flat-for-curved", p.chain.after(symbol, flat))
            yield usual("flat-for-curved", p.chain.after(symbol, flat * away), FLAT, later=1.0)
    if omega := p.amount("solid-angle"):
        corners = 1 if "corner" in p.given else 4
        tangent = math.tan(omega / corners)
        sizes = [tangent, math.tan(tangent), math.asin(tangent) if abs(tangent) < 1 else tangent]
        for size in sizes:
            yield usual("tangent-for-angle", p.chain.after("solid-angle", corners * size))


def _round(p: Problem) -> Found:
    """Use a sphere as a disc, a disc as a sphere, or either as a small flat area."""
    shape, away, radius = p.question.shape, _away(p), p.radius()
    if shape not in ("sphere", "disc") or not radius or radius >= away:
        return
    right, other = math.asin(radius / away), math.atan(radius / away)
    if shape == "disc":
        right, other = other, right
    name = "arctangent-for-arcsine"
    yield usual(name, p.chain.after("half-angle", other))
    yield usual(name, p.chain.after("solid-angle", geometry.cone(other)))
    if shape == "sphere":  # for a disc, `_far` compares with the far field
        yield usual(name, p.chain.after("projected-solid-angle", geometry.projected_cone(other)))
    for flat in (PI * math.tan(right) ** 2, PI * right**2, PI * (radius / away) ** 2):
        yield usual("flat-disc-for-cap", p.chain.after("solid-angle", flat))
    sine = PI * math.sin(right)
    yield usual("sine-not-squared", p.chain.after("projected-solid-angle", sine))


def _projection(p: Problem) -> Found:
    """Confuse the solid angle and the projected solid angle, or mix up the pi in them."""
    plain, projected = p.amount("solid-angle"), p.amount("projected-solid-angle")
    if not plain or not projected:
        return
    yield usual("solid-for-projected", p.chain.after("projected-solid-angle", plain))
    yield usual("solid-for-projected", p.chain.after("solid-angle", projected))
    if not p.chain.steps or p.light:  # computed without laws
        yield usual(
            "pi-forgotten", p.chain.after("projected-solid-angle", projected / PI), right=DIFFUSE
        )
        yield usual("two-pi-for-pi", p.chain.after("projected-solid-angle", 2 * projected))
        whole = p.chain.after("projected-solid-angle", 4 * projected)
        yield usual("wrong-sphere", whole, right=DIFFUSE)
        yield usual("wrong-sphere", p.chain.after("solid-angle", 2 * plain), right=DIFFUSE)


def _aside(p: Problem) -> Found:
    """Use the height for the distance of a point off the axis, or forget the cosine."""
    height, offset, radius = p.amount("height"), p.amount("offset"), p.radius()
    if not height or not offset:
        return
    slant = math.hypot(height, offset)
    cosine = height / slant
    square = p.right
    if p.lists("disc off its axis"):
        if p.question.shape != "disc" or not radius or not p.asks("solid-angle"):
            return
        small = PI * (radius / slant) ** 2
        yield usual("cosine-forgotten", small)
        yield usual("height-for-distance", small / cosine)
        return
    far, near = p.amount("far-field-irradiance"), p.amount("irradiance")
    if far and near and p.asks("irradiance"):
        square = p.right * far / near
        yield usual("cosine-forgotten", square / cosine)
    is_flat = p.lists("flat source")  # its intensity has a cosine, too
    for power in (2, 3, 4)[: 2 + is_flat]:  # from 3 on, cosines were forgotten, too
        yield usual("height-for-distance", square / cosine**power)
        if p.asks("intensity", "flux"):
            yield usual("height-for-distance", square * cosine**power)


def _far(p: Problem) -> Found:
    """Use the far field near an extended source, or the inverse square law for a radiance."""
    far, near = p.amount("far-field-irradiance"), p.amount("irradiance")
    if far and near and p.light and not p.asks("far-field-irradiance"):
        for ratio in (far / near, near / far):
            yield usual("far-field-of-extended-source", p.right * ratio)
    distance = p.amount("distance")
    if distance and p.light and p.light.is_radiance:
        for power in (2, -2):
            yield usual("inverse-square-on-radiance", p.right * distance**power)


def _received(p: Problem) -> Found:
    """Multiply the irradiance by the receiver's area instead of integrating over it."""
    irradiance, area = p.amount("irradiance"), p.amount("receiver-area")
    if not p.asks("received-flux") or not irradiance or not area:
        return
    rule = "Phi = E A, if E is uniform over the receiver"
    yield usual("flat-for-curved", irradiance * area, "E A was used, as for a small receiver")
    for factor in (1e2, 1e4, 1e6):
        for wrong in (area * factor, area / factor):
            yield usual("area-unit", irradiance * wrong)
    yield Candidate("receiver-area-forgotten", 3, irradiance, "the area was forgotten", rule)
    done = "it was divided by the area, not multiplied"
    yield Candidate("receiver-area-upside-down", 3, irradiance / area, done, rule)


def _direction(p: Problem) -> Found:
    """Confuse quadrants, x and y, or the directions at a mirror."""
    if not p.lists("direction"):
        return
    if p.asks("azimuth"):
        for turn in (PI, -PI):
            yield usual("wrong-quadrant", p.right + turn)
        yield usual("x-for-y", PI / 2 - p.right)
        yield usual("x-for-y", PI / 2 - abs(math.remainder(p.right, PI)))
    if p.asks("x", "y"):
        yield usual("x-for-y", p.amount("y" if p.asks("x") else "x"))
        polar, azimuth = p.amount("polar"), p.amount("azimuth")
        if polar and azimuth:
            turned = (math.cos if p.asks("x") else math.sin)(math.degrees(azimuth))
            yield usual("degrees-as-radians", math.sin(math.degrees(polar)) * turned)
    if p.asks("length"):
        yield usual("root-forgotten", p.right**2)
    if p.asks("x", "y", "z") and "reflect-at" in p.given:
        normal = projections.unit(p.given["reflect-at"].value)
        yield usual("normal-for-reflection", normal["xyz".index(p.target.name)])
        yield usual("towards-for-away", -p.right)
    if p.asks("x", "y", "z") and "mirror-ball" in p.given:
        normals = {"x": "mirror-ball-u", "y": "mirror-ball-v", "z": "mirror-ball-w"}
        yield usual("normal-for-reflection", p.amount(normals[p.target.name]))


def _sky(p: Problem) -> Found:
    """Assume a uniform sky, mix up its pi, or use the light on the ground for a tilted plane."""
    ground = p.amount("horizontal-sky")
    if not p.lists("sky") or not ground:
        return
    symbols = [("horizontal-sky", ground, PI)]
    plane = p.amount("plane-sky")
    if plane:
        tilted = "normal" in p.given
        rise = (
            projections.unit(p.given["normal"].value)[2]
            if tilted
            else math.cos(p.amount("tilt") or 0)
        )
        part = (1 + rise) / 2
        yield usual("ground-for-plane", p.chain.after("plane-sky", ground * part))
        for wrong, later in ((ground, 0.0), (ground * rise, 1.0)):
            yield usual("ground-for-plane", p.chain.after("plane-sky", wrong), later=later)
        symbols.append(("plane-sky", plane, PI * part))
    for symbol, size, even in symbols:
        yield usual("uniform-sky", p.chain.after(symbol, even))
        for integral in (even, size):
            yield usual("two-pi-for-pi", p.chain.after(symbol, 2 * integral), right=DIFFUSE)
            yield usual("pi-forgotten", p.chain.after(symbol, integral / PI), PI_FORGOTTEN, DIFFUSE)
    if "toward" in p.given and "relative-radiance" in p.chain.symbols:
        cosine = math.cos(p.given["toward"].value[0])
        yield usual("cosine-of-zenith", p.chain.after("relative-radiance", cosine))
    height = p.amount("sun-height")
    if height:
        cosine = math.sqrt(max(0.0, 1 - height * height))
        yield usual("angle-from-surface", p.chain.after("sun-height", cosine))


def _environment(p: Problem) -> Found:
    """Mix up the pi in the light from all directions."""
    if p.lists("all around") and p.asks("irradiance"):
        yield usual("pi-forgotten", p.right / PI, PI_FORGOTTEN, DIFFUSE)
        yield usual("two-pi-for-pi", 2 * p.right, right=DIFFUSE)


WHOLE_TIME = {
    "first": "the first sample was used for the whole time",
    "last": "the last sample was used for the whole time",
}


def _samples(p: Problem) -> Found:
    """Add the samples of a log without their times, or with wrong times."""
    samples = p.question.samples
    mean = p.amount("mean-irradiance") or p.amount("mean-flux")
    names = ("covered-time", "duration", "samples", "gaps")
    covered, duration, count, gaps = (p.amount(name) or 0.0 for name in names)
    is_sum = p.asks("exposure", "energy")
    if not samples or not mean or not (is_sum or p.asks("mean-irradiance", "mean-flux")):
        return
    times_mean = p.right / mean
    step = covered / (count - 1 - gaps)
    for unit in (1.0, 60.0, 3600.0) if is_sum else ():
        if not math.isclose(unit, step):
            yield usual("step-forgotten", times_mean * samples["sum"] * unit / covered)
    yield usual("whole-steps", times_mean * samples["sum"] * step / covered)
    yield usual("plain-mean", times_mean * samples["sum"] / count)
    for name in ("first", "last"):
        done = WHOLE_TIME[name]
        yield usual("sample-for-all", times_mean * samples[name], done)
    peak = p.amount("maximum-irradiance") or p.amount("maximum-flux") or 0.0
    yield usual("sample-for-all", times_mean * peak)
    yield usual("gaps-bridged", p.right * duration / covered)
    for size in (60.0, 3600.0):
        for value in (p.right * size, p.right / size):
            yield usual("minutes-for-seconds", value)


def _pixel(p: Problem) -> Found:
    """Use the same solid angle for all pixels, or forget the sine."""
    if p.question.shape == "pixel" and p.asks("solid-angle"):
        width, height = p.given["size"].value
        yield usual("pixels-alike", 4 * PI / (width * height))
        yield usual("sine-forgotten", 2 * PI * PI / (width * height))


# ---------------------------------------------------------------------------------------------
# Observers and beams, and one symbol for another

OF_EYES = ("luminous-efficacy", "scotopic-luminous-efficacy")


def _eyes(p: Problem) -> Found:
    """Use the efficacy of the wrong observer, or 683 lm/W for any light."""
    if p.chain.symbols.isdisjoint((*OF_EYES, "sp-ratio")):
        return
    from radcalc.spectra.observers import OBSERVERS

    day, night = OBSERVERS["photopic"], OBSERVERS["scotopic"]
    rounded = 1700 / 683, night.maximum / day.maximum
    for symbol in (*OF_EYES, "sp-ratio"):
        if symbol not in p.chain.symbols:
            continue
        right = p.chain.values[symbol]
        wrong_values = [right * ratio for ratio in rounded] + [right / ratio for ratio in rounded]
        if symbol != "sp-ratio":
            for size in (683.0, day.maximum):
                yield usual("683-for-any-light", p.chain.after(symbol, size))
            for eye, other in ((day, night), (night, day)):
                seen = _efficacy(p, eye, eye is night)
                wrong_values += [seen, seen * other.maximum / eye.maximum] if seen else []
            own_eye = night if symbol == OF_EYES[1] else day
            if "efficacy" not in p.given:
                yield usual("683-forgotten", p.chain.after(symbol, right / own_eye.maximum))
        for size in wrong_values:
            yield usual("scotopic-for-photopic", p.chain.after(symbol, size))


def _efficacy(p: Problem, eye: "Observer", is_dark: bool) -> float | None:
    if "wavelength" in p.given:
        from radcalc.conversion.spectral import light
        from radcalc.spectra.observers import luminous_efficacy

        return float(luminous_efficacy(light(p.given["wavelength"]).table, eye))
    return p.amount(OF_EYES[is_dark]) if p.lists("efficacies of eyes") else None


def _beam(p: Problem) -> Found:
    """Use a sphere for a beam, or a cone for a lobe."""
    is_round = not p.given.keys().isdisjoint(("isotropic", "hemisphere"))
    if not p.light or is_round or not p.lists("beam"):
        return
    yield usual("spot-as-sphere", p.chain.after("solid-angle", geometry.FULL))
    hemisphere = p.chain.after("solid-angle", geometry.HEMISPHERE)
    yield usual("wrong-sphere", hemisphere, "2 pi was used for the beam", "I = Phi / Omega")
    yield usual("cone-forgotten", p.chain.after("solid-angle", 1.0))
    beam, n = p.amount("beam-angle"), p.amount("exponent")
    if n and not beam:
        beam = 2 * math.acos(0.5 ** (1 / n))
    if beam:
        yield usual("cone-for-lobe", p.chain.after("solid-angle", geometry.cone(beam / 2)))
        return
    half = p.chain.values.get("half-angle")
    if half and 0 < half < PI / 2:
        n = math.log(0.5) / math.log(math.cos(half))
        yield usual("lobe-for-cone", p.chain.after("solid-angle", 2 * PI / (n + 1)))


PEAKS = {  # laws of a spot: the mistake, and its ratio to the right value
    "mean irradiance of a spot": ("peak-for-mean", 2.0),
    "mean exposure of a spot": ("peak-for-mean", 2.0),
    "peak of a gaussian beam": ("mean-for-peak", 0.5),
    "limit of a gaussian beam's peak": ("mean-for-peak", 0.5),
}


def _peaks(p: Problem) -> Found:
    """Confuse the mean over a spot and the peak on its axis."""
    is_uniform = "profile" in p.given and p.given["profile"].value == UNIFORM
    for law, target in p.chain.steps:
        if law.name in PEAKS and not is_uniform:
            name, ratio = PEAKS[law.name]
            yield usual(name, scaled(p, law, target, ratio))


SWAPS = (
    ("k-for-c", "k", "c"),
    ("k-for-c", "c", "k"),
    ("diagonal-for-width", "width", "diagonal"),
    ("height-for-distance", "distance", "height"),
    ("efficiency-for-responsivity", "responsivity", "quantum-efficiency"),
    ("efficiency-for-responsivity", "quantum-efficiency", "responsivity"),
)


def _swapped(p: Problem) -> Found:
    """Use the value of another symbol of the same sort, or mix up ISO speeds, sine and cosine."""
    values, symbols = p.chain.values, p.chain.symbols
    for name, symbol, other in SWAPS:
        if symbol in symbols and other in values:
            yield usual(name, p.chain.after(symbol, values[other]))
    if "iso" in symbols:
        yield usual("iso-forgotten", p.chain.after("iso", 100.0))
        yield usual("iso-upside-down", p.chain.after("iso", 1e4 / values["iso"]))
    cosines = sorted(symbols.intersection(("cosine", "cosine-of-source")))
    sines = {name: math.sqrt(1 - values[name] ** 2) for name in cosines if 0 < values[name] < 1}
    for name, sine in sines.items():
        yield usual("angle-from-surface", p.chain.after(name, sine))


LAMPS = ("D65", "AM1.5G", "blackbody:5772K", "A", "LED-B3", "HPS")  # the likeliest first
# Published factors of daylight and of other lamps [lm/W, lm s/umol, umol/J].
PUBLISHED = {
    "luminous-efficacy": (93.0, 110.0, 120.0),
    "lux-per-ppfd": (54.0, 55.0, 683.0, 683 / 4.57, 82.0, 67.0),
    "photon-efficacy": (4.57, 4.6, 2.02, 2.1),
}
IN_UNITS = {"lux-per-ppfd": 1e6 / AVOGADRO, "photon-efficacy": AVOGADRO / 1e6}  # in SI units


def _lamps(p: Problem) -> Found:
    """Use the factor between two kinds of light of another lamp."""
    spectrum = p.given.get("spectrum")
    used = [name for name, *_ in EFFICACIES if name in p.chain.symbols]
    if not used or "wavelength" in p.given or "efficacy" in p.given:
        return
    for name in used:
        for size in PUBLISHED[name]:
            yield usual("other-lamp", p.chain.after(name, size * IN_UNITS.get(name, 1.0)))
    if spectrum is None or p.question.command == "spectrum":
        return
    from radcalc.spectra.sources import spectrum as named

    for k, lamp in enumerate(LAMPS):
        value = p.anew({"spectrum": named(lamp)})
        done = Translatable("the factor of another lamp was used ({0})", lamp)
        yield usual("other-lamp", value, done, later=0.1 * k)


def _others(p: Problem) -> Found:
    """Give another result of the question, with the number in its own unit."""
    for other in p.results.values():
        if other is p.target or other.name in SAME_AS or not isinstance(other.amount, float):
            continue
        apart = [times(other.dimensions[0], SOLID_ANGLE, k) for k in (0, 1, -1)]
        if p.target.dimensions[0] in apart:
            done = Translatable("the {0} was given", other.label)
            later = 0.0 if p.target.dimensions[0] == apart[0] else 0.5
            later += 0.0 if other.given is None else 1.0
            asked = Translatable("the {0} was asked for", p.target.label)
            yield usual("other-quantity", other.amount, done, asked, later)


def _amplitude(p: Problem) -> Found:
    """Give the ratio of amplitudes for that of intensities, which is its square."""
    if p.asks("reflectance", "reflectance-s", "reflectance-p") and 0 < p.right < 1:
        yield usual("amplitude-for-intensity", math.sqrt(p.right))


def _day(p: Problem) -> Found:
    """Use the whole day for the hours of light, or some hours of light for the day."""
    if "photoperiod" in p.given:
        yield usual("hours-of-light", p.anew({"photoperiod": DAY}))
    elif "time" in p.chain.symbols and p.chain.values["time"] == DAY and "time" not in p.given:
        for hours in HOURS:
            yield usual("hours-of-light", p.chain.after("time", hours * 3600.0))
    elif (plan := p.question.plan) and not plan.links and plan.is_linear:
        days = sum(
            power for name, power in (*plan.source.atoms, *plan.target.atoms) if name == "day"
        )
        for hours in HOURS if days else ():
            yield usual("hours-of-light", p.right * (hours / 24) ** -days)


def _rounded_early(p: Problem) -> Found:
    """Round the cosine of a narrow cone before it is subtracted from 1."""
    half = p.amount("half-angle")
    if not half or not ("solid-angle" in p.chain.symbols or p.asks("solid-angle")):
        return
    for digits in (2, 3):
        size = 2 * PI * (1 - round(math.cos(half), digits))
        if size > 0:
            yield usual("rounded-early", p.chain.after("solid-angle", size))


FAMILIES = (
    _hemisphere,
    _rectangle,
    _round,
    _projection,
    _aside,
    _far,
    _received,
    _direction,
    _sky,
    _environment,
    _samples,
    _pixel,
    _eyes,
    _beam,
    _peaks,
    _swapped,
    _lamps,
    _others,
    _amplitude,
    _day,
    _rounded_early,
)
