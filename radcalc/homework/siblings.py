"""Functions replaced by their siblings.

A row of `LAWS` belongs to a law, by the start of its name, and the symbol that it was solved for;
a function of the others gives the wrong values of that symbol.  What stands outside the laws (the
shapes that are worked out at once, the eyes, a direction) has a function of its own.
"""

import math
from collections.abc import Callable, Iterator

from radcalc.geometry import cones, lobes, solid
from radcalc.homework.chain import FAILURES
from radcalc.homework.edits import text_of
from radcalc.homework.problem import Candidate, Problem
from radcalc.homework.usual import USUAL
from radcalc.laws.law import At
from radcalc.spectra.observers import OBSERVERS, luminous_efficacy

Wrong = Iterator[tuple[str, float | None]]  # the name of a mistake, and the value that it gives
PI = math.pi


def find(p: Problem) -> Iterator[Candidate]:
    """Every function of the derivation replaced by one of its siblings."""
    for law, target in p.chain.steps:
        for start, symbol, wrong in LAWS:
            if target == symbol and law.name.startswith(start):
                try:
                    found = [*wrong(p.chain.values.__getitem__)]
                except FAILURES:
                    continue
                for name, size in found:
                    value = None if size is None else p.chain.after(target, size)
                    if value is not None:
                        rank, done, right = USUAL[name]
                        yield Candidate(name, rank, value, done, right or text_of(law))
    for family in (_shape, _projection, _zone, _direction, _eyes, _beam, _near, _other_value):
        for name, value in family(p):
            if value is not None:
                yield Candidate(name, USUAL[name][0], value, *USUAL[name][1:])


# ---------------------------------------------------------------------------------------------
# Of the laws


def _flat(half: float) -> Wrong:
    """What is taken for the solid angle of a cone of less than a hemisphere, plain or projected."""
    if half < PI / 2:
        yield "flat-disc-for-cap", PI * math.tan(half) ** 2
        yield "flat-disc-for-cap", PI * half**2
    yield "one-forgotten", 2 * PI * math.cos(half)
    yield "sine-not-squared", PI * math.sin(half)


def _cone(at: At) -> Wrong:
    half = at("half-angle")
    yield "solid-for-projected", cones.projected_cone(half)
    yield "wrong-sphere", 2 * cones.cone(half)
    yield from _flat(half)


def _projected(at: At) -> Wrong:
    yield "solid-for-projected", cones.cone(at("half-angle"))
    yield from _flat(at("half-angle"))


def _of_etendue(at: At) -> Wrong:
    return ((name, at("area") * size) for name, size in _projected(at) if size is not None)


def _half_angle(at: At) -> Wrong:
    yield "wrong-sphere", cones.cone_of(at("solid-angle") / 2)
    ratio = math.sqrt(at("solid-angle") / PI)
    yield "flat-disc-for-cap", ratio
    yield "flat-disc-for-cap", math.atan(ratio)
    if ratio < 1:
        yield "solid-for-projected", math.asin(ratio)


def _lobe(at: At) -> Wrong:
    n = at("exponent")
    yield "lobe-without-one", 2 * PI
    yield "lobe-without-one", 2 * PI / n if n else None
    yield "exponent-upside-down", 2 * PI * (n + 1)


def _straight_line(at: At) -> Wrong:
    yield "sum-for-difference", math.sqrt(at("height") ** 2 - at("lateral") ** 2)


def _exposure_value(at: At) -> Wrong:
    yield "log10-for-log2", math.log10(at("light"))
    yield "log10-for-log2", math.log(at("light"))


def _of_light(constant: str, light: str) -> Callable[[At], Wrong]:
    def wrong(at: At) -> Wrong:
        stops = at(light) * 100 / at(constant)
        yield "log10-for-log2", math.log10(stops)
        yield "log10-for-log2", math.log(stops)

    return wrong


def _pyramid(at: At) -> Wrong:
    a, b = at("horizontal"), at("vertical")
    yield "flat-for-curved", a * b
    yield "flat-for-curved", 4 * math.tan(a / 2) * math.tan(b / 2)


def _discs(at: At) -> Wrong:
    first, second = at("radius") ** 2, at("receiver-radius") ** 2
    for rim in (0.0, first, second):
        etendue = PI**2 * first * second / (at("distance") ** 2 + rim)
        yield "far-field-of-extended-source", etendue


def _mesopic(at: At) -> Wrong:
    yield "scotopic-for-mesopic", at("luminance") * at("sp-ratio")
    yield "scotopic-for-mesopic", at("luminance")


LAWS: tuple[tuple[str, str, Callable[[At], Wrong]], ...] = (
    ("solid angle of a cone", "solid-angle", _cone),
    ("solid angle of a cone", "half-angle", _half_angle),
    ("projected solid angle of a cone", "projected-solid-angle", _projected),
    ("etendue of a cone", "etendue", _of_etendue),
    ("flux of a lobe over its peak", "solid-angle", _lobe),
    ("straight line", "distance", _straight_line),
    ("exposure value", "ev", _exposure_value),
    ("reflected light", "ev100", _of_light("k", "luminance")),
    ("incident light", "ev100", _of_light("c", "illuminance")),
    ("rectangular pyramid", "solid-angle", _pyramid),
    ("two coaxial discs", "etendue", _discs),
    ("mesopic luminance", "mesopic-luminance", _mesopic),
)


# ---------------------------------------------------------------------------------------------
# Of what stands outside them


def _shape(p: Problem) -> Wrong:
    """A sphere, a disc or a rectangle: one taken for another, or as flat and far away."""
    shape, radius = p.facts.shape, p.radius()
    away = p.amount("height") or p.amount("distance")
    offset = p.amount("offset") or 0.0
    if not away:
        return
    wrong: list[tuple[str, str, float]] = []
    if shape in ("sphere", "disc") and radius and radius < away and not offset:
        half = math.atan(radius / away) if shape == "sphere" else math.asin(radius / away)
        own = math.asin(radius / away) if shape == "sphere" else math.atan(radius / away)
        flat, square = PI * math.tan(own) ** 2, PI * own**2
        ratio = PI * (radius / away) ** 2
        name = "arctangent-for-arcsine"
        wrong += [("half-angle", name, half), ("solid-angle", name, cones.cone(half))]
        if shape == "sphere":  # a disc's is the far field
            wrong.append(("projected-solid-angle", name, cones.projected_cone(half)))
        for size in (flat, square, ratio):
            wrong.append(("solid-angle", "flat-disc-for-cap", size))
        projected = "projected-solid-angle"
        wrong.append(("solid-angle", "solid-for-projected", cones.projected_cone(own)))
        wrong.append((projected, "solid-for-projected", cones.cone(own)))
        wrong.append((projected, "sine-not-squared", PI * math.sin(own)))
    if shape == "rectangle" and not offset:
        area = (p.amount("width") or 0.0) * (p.amount("length") or 0.0)
        wrong.append(("solid-angle", "flat-for-curved", area / away**2))
    if shape == "disc" and radius and offset:
        slant = math.hypot(away, offset)
        small = solid.patch(PI * radius**2, slant)
        wrong.append(("solid-angle", "cosine-forgotten", small))
        wrong.append(("solid-angle", "height-for-distance", small * slant / away))
    for symbol, name, size in wrong:
        yield name, p.chain.after(symbol, size)


def _projection(p: Problem) -> Wrong:
    """The solid angle of any shape for the projected one, and back."""
    plain, projected_one = p.amount("solid-angle"), p.amount("projected-solid-angle")
    if plain and projected_one and "half-angle" not in p.chain.symbols:
        yield "solid-for-projected", p.chain.after("projected-solid-angle", plain)
        yield "solid-for-projected", p.chain.after("solid-angle", projected_one)


def _near(p: Problem) -> Wrong:
    """The far field for the exact one, aslant too; the square law on a radiance."""
    far, near = p.amount("far-field-irradiance"), p.amount("irradiance")
    if far and near and p.light and not p.asks("far-field-irradiance"):
        for factor in (far / near, near / far):
            yield "far-field-of-extended-source", p.right * factor
    height, slant = p.amount("height"), p.amount("distance")
    offset = p.amount("offset")
    if height and offset:
        slant = math.hypot(height, offset)
        if far and near and p.asks("irradiance"):
            yield "cosine-forgotten", p.right * far / near * slant / height
            yield "height-for-distance", p.right * far / near * (slant / height) ** 2
            yield "height-for-distance", p.right * far / near * (slant / height) ** 3
        elif p.light and p.is_of("point-source"):
            for power in (2, 3):
                yield "height-for-distance", p.right * (slant / height) ** power
                yield "height-for-distance", p.right / (slant / height) ** power
    distance = p.amount("distance")
    if distance and p.light and p.light.is_radiance:
        yield "inverse-square-on-radiance", p.right * distance**2
        yield "inverse-square-on-radiance", p.right / distance**2


def _zone(p: Problem) -> Wrong:
    """A zone as caps; an integral without its sine."""
    ends = p.given["polar"].value if "polar" in p.given else None
    if isinstance(ends, tuple) and p.asks("solid-angle", "projected-solid-angle", "integral"):
        inner, outer = map(cones.cone, ends)
        width = cones.cone(ends[1] - ends[0])
        for caps in (outer + inner, outer, inner, width):
            yield "zone-of-caps", p.right * caps / (outer - inner)
        sines = 2 * PI * (math.sin(ends[1]) - math.sin(ends[0]))
        yield "angle-from-surface", p.right * sines / (outer - inner)
        if "azimuth" in p.given and isinstance(p.given["azimuth"].value, tuple):
            low, high = p.given["azimuth"].value
            yield "azimuth-forgotten", p.right * 2 * PI / (high - low)
    if p.asks("integral"):
        yield "azimuth-forgotten", p.right / (2 * PI)
        half = p.amount("half-angle")
        if half and math.isclose(p.right, cones.cone(half), rel_tol=1e-6):
            yield "sine-forgotten", 2 * PI * half
        if half and math.isclose(p.right, cones.projected_cone(half), rel_tol=1e-6):
            yield "sine-forgotten", 2 * PI * math.sin(half)


def _direction(p: Problem) -> Wrong:
    """A direction, by its angles or its coordinates."""
    if p.asks("azimuth"):
        yield "wrong-quadrant", p.right + PI
        yield "wrong-quadrant", p.right - PI
        yield "x-for-y", PI / 2 - p.right
        yield "x-for-y", math.pi / 2 - abs(math.remainder(p.right, PI))
    if p.is_of("direction"):
        if p.asks("x", "y"):
            yield "x-for-y", p.amount("y" if p.asks("x") else "x")
            polar, azimuth = p.amount("polar"), p.amount("azimuth")
            if "polar" in p.given and polar and azimuth:
                turn = math.sin if p.asks("y") else math.cos
                wrong = math.sin(math.degrees(polar)) * turn(math.degrees(azimuth))
                yield "degrees-as-radians", wrong
        if p.asks("length"):
            yield "root-forgotten", p.right**2


def _eyes(p: Problem) -> Wrong:
    """The efficacies of the wrong eye, and watts as if all were seen best."""
    day, night = OBSERVERS["photopic"], OBSERVERS["scotopic"]
    ratio = night.maximum / day.maximum
    for symbol in ("luminous-efficacy", "efficacy", "scotopic-luminous-efficacy"):
        if symbol not in p.chain.symbols:
            continue
        own = p.chain.values[symbol]
        for size in (683.0, day.maximum):
            yield "683-for-any-light", p.chain.after(symbol, size)
        for factor in (ratio, 1 / ratio, 1700 / 683, 683 / 1700):
            yield "scotopic-for-photopic", p.chain.after(symbol, own * factor)
        if symbol == "efficacy":
            continue
        for eye, other in ((day, night), (night, day)):
            efficacy = _efficacy(p, eye)
            if efficacy:
                yield "scotopic-for-photopic", p.chain.after(symbol, efficacy)
                yield "scotopic-for-photopic", p.chain.after(symbol, efficacy / eye.maximum * other.maximum)
        eye = night if symbol.startswith("scotopic") else day
        yield "683-forgotten", p.chain.after(symbol, own / eye.maximum)
    if "sp-ratio" in p.chain.symbols or p.asks("sp-ratio"):
        for factor in (1700 / 683, 683 / 1700):
            yield "scotopic-for-photopic", p.chain.after("sp-ratio", p.chain.values["sp-ratio"] * factor)


def _efficacy(p: Problem, eye: object) -> float | None:
    """What an eye sees of the light that is given [lm/W]."""
    if "wavelength" in p.given:
        from radcalc.conversion.spectral import light

        return float(luminous_efficacy(light(p.given["wavelength"], None).table, eye))
    if p.is_of("spectrum"):
        name = "scotopic-luminous-efficacy" if eye is OBSERVERS["scotopic"] else "luminous-efficacy"
        return p.amount(name)
    return None


def _beam(p: Problem) -> Wrong:
    """A beam as a sphere, or as a cone."""
    if p.light and "solid-angle" in p.chain.symbols and p.is_of("point-source", "convert"):
        if {"isotropic", "hemisphere"} & set(p.given):
            return
        yield "spot-as-sphere", p.chain.after("solid-angle", cones.FULL)
        yield "wrong-sphere", p.chain.after("solid-angle", cones.HEMISPHERE)
        yield "cone-forgotten", p.chain.after("solid-angle", 1.0)
        beam = p.amount("beam-angle")
        n = p.amount("exponent")
        if beam is None and n:
            beam = float(lobes.angle(n, 0.5))
        if beam:
            yield "cone-for-lobe", p.chain.after("solid-angle", cones.cone(beam / 2))


def _other_value(p: Problem) -> Wrong:
    """One symbol's value for another's of the same sort."""
    values = p.chain.values
    for name, symbol, other in SWAPS:
        if symbol in p.chain.symbols and other in values:
            yield name, p.chain.after(symbol, values[other])
    iso = values.get("iso")
    if iso and "iso" in p.chain.symbols:
        yield "iso-forgotten", p.chain.after("iso", 100.0)
        yield "iso-upside-down", p.chain.after("iso", 1e4 / iso)
    if "cosine" in p.chain.symbols and 0 < values["cosine"] < 1:
        sine = math.sqrt(1 - values["cosine"] ** 2)
        yield "angle-from-surface", p.chain.after("cosine", sine)


SWAPS = (
    ("k-for-c", "k", "c"),
    ("k-for-c", "c", "k"),
    ("diagonal-for-width", "width", "diagonal"),
    ("height-for-distance", "distance", "height"),
)
