"""What a spectrum amounts to: its shape, its efficacies, its colour."""

import math
from functools import cache
from typing import Any

from radcalc.answer import Answer, Step, Value
from radcalc.conversion.conditions import ENERGY, PHOTON_ENERGY, TEMPERATURE
from radcalc.conversion.spectral import too_narrow
from radcalc.errors import ConditionError
from radcalc.quantities.light import (
    AXIS,
    LUMINOUS,
    PHOTON,
    RADIANT,
    RATIOS,
    WAVELENGTH,
    light_dimension,
)
from radcalc.spectra.observers import OBSERVERS, Observer
from radcalc.spectra.planck import LIGHT, PLANCK
from radcalc.spectra.spectrum import WHOLE, BlackBody, Range, Spectrum, range_text
from radcalc.units.table import NUMBER

LENGTH = AXIS[WAVELENGTH]
SAMPLES = [float(x) for x in range(380, 781, 5)]  # where colour rendering looks
FARTHEST = 0.05  # |Duv| beyond which the CIE gives no correlated colour temperature
# absolute quantity: powers of 1/area and 1/solid angle, and the luminous name beside it
ABSOLUTE = {
    "flux": ((0, 0, 0), "luminous-flux", "W", "lm"),
    "intensity": ((0, 0, 1), "luminous-intensity", "W/sr", "cd"),
    "irradiance": ((0, 1, 0), "illuminance", "W/m2", "lx"),
    "radiance": ((0, 1, 1), "luminance", "W/m2/sr", "cd/m2"),
}


def spectrum(
    source: Spectrum,
    limits: Range | None = None,
    photon_limits: Range | None = None,
    observer: str = "photopic",
) -> Answer:
    """Everything that follows from a spectrum.

    Watts are counted over `limits` [nm] (the source's own where None), photons over
    `photon_limits` (400 nm to 700 nm, all of them for lines).
    """
    watts_in, photons_in = source.counted(limits, photon_limits)
    eye, night = OBSERVERS[observer], OBSERVERS["scotopic"]
    watts = source.power(watts_in)
    if not watts > 0:
        raise ConditionError(f"there is no power in {range_text(watts_in)}", "another --range")
    lumens, dark = eye.maximum * source.seen(eye), night.maximum * source.seen(night)
    too_narrow(lumens / watts, eye, watts_in)
    amounts = {RADIANT: watts, LUMINOUS: lumens, PHOTON: source.photons(photons_in)}
    values = [
        *_shape(source, watts_in, watts),
        *_efficacies(lumens, dark, watts, eye),
        *_photons(source, photons_in, lumens, watts),
        *_colour(source),
        *_absolute(source, amounts),
    ]
    assumptions = [
        f"spectrum {source.label}; watts counted over {range_text(watts_in)}, "
        f"photons over {range_text(photons_in)}",
        eye.assumption,
    ]
    notes = list(source.notes)
    if not lumens:
        notes.append("nothing of this spectrum is seen")
    return values, assumptions, notes, _steps(lumens, watts, eye)


def _number(name: str, label: str, symbol: str, value: Any, unit: str = "1") -> Value:
    return Value(name, label, symbol, value, (NUMBER,), (unit,))


def _length(name: str, label: str, symbol: str, nanometres: float) -> Value:
    return Value(name, label, symbol, nanometres * 1e-9, (LENGTH,), ("nm",))


def _shape(source: Spectrum, limits: Range, watts: float) -> list[Value]:
    peak, width = source.peak()
    centroid = source.photons(limits) * PLANCK * LIGHT / watts * 1e9
    found = [
        _length("peak-wavelength", "peak wavelength", "λ_p", peak),
        _length("centroid-wavelength", "centroid wavelength", "λ_c", centroid),
    ]
    if width is not None:
        found.append(_length("fwhm", "full width at half maximum", "Δλ", width))
    if limits != WHOLE:
        found.append(_length("range-start", "start of range", "λ_1", limits[0]))
        found.append(_length("range-end", "end of range", "λ_2", limits[1]))
    share = watts / source.total()
    return [*found, _number("range-fraction", "fraction in range", "", share, "%")]


def _efficacies(lumens: float, dark: float, watts: float, eye: Observer) -> list[Value]:
    per_watt = RATIOS[LUMINOUS, RADIANT]
    night = OBSERVERS["scotopic"]
    found = [
        _number("luminous-efficiency", "luminous efficiency", "V", lumens / watts / eye.maximum),
        Value(
            "luminous-efficacy", "luminous efficacy", "K", lumens / watts, (per_watt,), ("lm/W",)
        ),
    ]
    if eye is not night:
        label = "scotopic luminous efficacy"
        value = Value(
            "scotopic-luminous-efficacy", label, "K'", dark / watts, (per_watt,), ("lm/W",)
        )
        found.append(value)
    if eye is OBSERVERS["photopic"] and lumens:
        found.append(_number("sp-ratio", "scotopic/photopic ratio", "S/P", dark / lumens))
    return found


def _photons(source: Spectrum, limits: Range, lumens: float, watts: float) -> list[Value]:
    photons = source.photons(limits)
    if not photons:
        return []
    mean = source.power(limits) / photons
    per_joule, per_photon = RATIOS[PHOTON, RADIANT], RATIOS[LUMINOUS, PHOTON]
    energy = Value(
        "photon-energy", "mean photon energy", "Q", mean, (PHOTON_ENERGY, ENERGY), ("eV",)
    )
    efficacy = Value(
        "photon-efficacy", "photon efficacy", "K_p", photons / watts, (per_joule,), ("umol/J",)
    )
    lux = Value("lux-per-ppfd", "lux per PPFD", "", lumens / photons, (per_photon,), ("lm.s/umol",))
    return [energy, efficacy, lux]


def _colour(source: Spectrum) -> list[Value]:
    """Chromaticity at once; the rest through colour-science, when it is looked at."""
    from radcalc.spectra.data import sources as data

    tristimulus = [source.weigh(360, table) for table in (data.X, data.Y, data.Z)]
    total = sum(tristimulus)
    if not total > 0:
        return []
    x, y = tristimulus[0] / total, tristimulus[1] / total
    found = [_number("x", "chromaticity x", "x", x), _number("y", "chromaticity y", "y", y)]
    if not _near_planck(x, y):
        return found

    @cache
    def near() -> tuple[float, float]:
        from radcalc.spectra.colorimetry import temperature_and_distance

        return temperature_and_distance(x, y)

    found.append(
        Value(
            "cct",
            "correlated colour temperature",
            "T_cp",
            lambda: near()[0],
            (TEMPERATURE,),
            ("K",),
        )
    )
    found.append(_number("duv", "distance from the Planckian", "Duv", lambda: near()[1]))
    sampled = source.sample(SAMPLES)
    if sampled is not None:

        def rendering() -> float:
            from radcalc.spectra.colorimetry import colour_rendering_index

            return colour_rendering_index(SAMPLES, sampled)

        found.append(_number("cri", "colour rendering index", "R_a", rendering))
    return found


def _near_planck(x: float, y: float) -> bool:
    """Whether a colour temperature means anything: within 0.05 of the Planckian in (u, v)."""
    u, v = _uv(x, y)
    return min(math.dist((u, v), point) for point in _locus()) <= FARTHEST


@cache
def _locus() -> list[tuple[float, float]]:
    """Points (u, v) of the Planckian locus from 1000 K to 100 000 K."""
    from radcalc.spectra.data import sources as data

    points = []
    for i in range(101):
        body = BlackBody(1000 * 10 ** (i / 50))
        tristimulus = [body.weigh(360, table) for table in (data.X, data.Y, data.Z)]
        total = sum(tristimulus)
        points.append(_uv(tristimulus[0] / total, tristimulus[1] / total))
    return points


def _uv(x: float, y: float) -> tuple[float, float]:
    """CIE 1960 (u, v)."""
    below = -2 * x + 12 * y + 3
    return 4 * x / below, 6 * y / below


def _absolute(source: Spectrum, amounts: dict[str, float]) -> list[Value]:
    """What an absolute source gives: irradiance and illuminance, or what a black body radiates.

    `amounts` are its watts, lumens and photons; each result can be asked for in all three kinds.
    """
    if isinstance(source, BlackBody):
        leaving = {kind: amount / math.pi for kind, amount in amounts.items()}
        shown = [
            ("exitance", "radiant exitance", "M_e", (0, 1, 0), RADIANT, amounts, "W/m2"),
            ("radiance", "radiance", "L_e", (0, 1, 1), RADIANT, leaving, "W/m2/sr"),
            ("luminance", "luminance", "L_v", (0, 1, 1), LUMINOUS, leaving, "cd/m2"),
        ]
    elif source.absolute:
        geometry, luminous, unit, luminous_unit = ABSOLUTE[source.absolute]
        name, label = source.absolute, luminous.replace("-", " ")
        shown = [
            (name, name, "", geometry, RADIANT, amounts, unit),
            (luminous, label, "", geometry, LUMINOUS, amounts, luminous_unit),
        ]
    else:
        return []
    found = []
    for name, label, symbol, geometry, kind, by_kind, unit in shown:
        reach = {light_dimension(k, geometry, ""): amount for k, amount in by_kind.items()}
        own = light_dimension(kind, geometry, "")
        found.append(Value(name, label, symbol, by_kind[kind], (own,), (unit,), reach))
    if isinstance(source, BlackBody):
        temperature = source.temperature
        found.append(Value("temperature", "temperature", "T", temperature, (TEMPERATURE,), ("K",)))
    return found


def _steps(lumens: float, watts: float, eye: Observer) -> list[Step]:
    weight = eye.label.split("(")[0]
    return [
        Step(
            "luminous efficacy of radiation",
            f"K = {eye.constant} int(S {weight} dlambda) / int(S dlambda)",
            f"K = {lumens:.6g} lm / {watts:.6g} W = {lumens / watts:.6g} lm/W",
            "trapezoid on the union of the data's and the observer's grids",
        )
    ]
