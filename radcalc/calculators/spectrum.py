"""What a spectrum amounts to: its shape, its efficacies, its colour."""

import math
from functools import cache

from radcalc.answer import Answer, Step, Value
from radcalc.calculators.results import value
from radcalc.conversion.spectral import too_narrow
from radcalc.derivation import Formula
from radcalc.errors import ConditionError, option
from radcalc.given import Inputs
from radcalc.quantities.light import LUMINOUS, PHOTON, RADIANT, light_dimension
from radcalc.quantities.symbols import SYMBOLS, light_unit, specific_name
from radcalc.spectra.observers import OBSERVERS, Observer
from radcalc.spectra.planck import LIGHT, PLANCK
from radcalc.spectra.spectrum import WHOLE, BlackBody, Range, Spectrum, range_text

SAMPLES = [float(x) for x in range(380, 781, 5)]  # where colour rendering looks
FARTHEST = 0.05  # |Duv| beyond which the CIE gives no correlated colour temperature


def spectrum(given: Inputs) -> Answer:
    """Everything that follows from a spectrum.

    Watts are counted over the given range (the source's own where there is none), photons over
    the given photon range (400 nm to 700 nm, all of them for lines).
    """
    source: Spectrum = given["spectrum"].value
    chosen = {name: one.value for name, one in given.items()}
    watts_in, photons_in = source.counted(chosen.get("range"), chosen.get("photon-range"))
    eye, night = OBSERVERS[chosen.get("observer", "photopic")], OBSERVERS["scotopic"]
    watts = source.power(watts_in)
    if not watts > 0:
        raise ConditionError(
            f"there is no power in {range_text(watts_in)}", f"another {option('range')}"
        )
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
    return Answer(values, assumptions, notes, _steps(lumens, watts, eye))


def _nanometres(name: str, size: float) -> Value:
    return value(name, size * 1e-9)


def _shape(source: Spectrum, limits: Range, watts: float) -> list[Value]:
    peak, width = source.peak()
    centroid = source.photons(limits) * PLANCK * LIGHT / watts * 1e9
    found = [_nanometres("peak-wavelength", peak), _nanometres("centroid-wavelength", centroid)]
    if width is not None:
        found.append(_nanometres("fwhm", width))
    if limits != WHOLE:
        found.append(_nanometres("range-start", limits[0]))
        found.append(_nanometres("range-end", limits[1]))
    return [*found, value("range-fraction", watts / source.total())]


def _efficacies(lumens: float, dark: float, watts: float, eye: Observer) -> list[Value]:
    found = [
        value("luminous-efficiency", lumens / watts / eye.maximum),
        value("luminous-efficacy", lumens / watts),
    ]
    if eye is not OBSERVERS["scotopic"]:
        found.append(value("scotopic-luminous-efficacy", dark / watts))
    if eye is OBSERVERS["photopic"] and lumens:
        found.append(value("sp-ratio", dark / lumens))
    return found


def _photons(source: Spectrum, limits: Range, lumens: float, watts: float) -> list[Value]:
    photons = source.photons(limits)
    if not photons:
        return []
    return [
        value("photon-energy", source.power(limits) / photons, label="mean photon energy"),
        value("photon-efficacy", photons / watts),
        value("lux-per-ppfd", lumens / photons),
    ]


def _colour(source: Spectrum) -> list[Value]:
    """Chromaticity at once; the rest through colour-science, when it is looked at."""
    from radcalc.spectra.data import sources as data

    tristimulus = [source.weigh(360, table) for table in (data.X, data.Y, data.Z)]
    total = sum(tristimulus)
    if not total > 0:
        return []
    x, y = tristimulus[0] / total, tristimulus[1] / total
    found = [value("x", x), value("y", y)]
    if not _near_planck(x, y):
        return found

    @cache
    def near() -> tuple[float, float]:
        from radcalc.spectra.colorimetry import temperature_and_distance

        return temperature_and_distance(x, y)

    found += [value("cct", lambda: near()[0]), value("duv", lambda: near()[1])]
    sampled = source.sample(SAMPLES)
    if sampled is not None:

        @cache
        def rendering() -> float:
            from radcalc.spectra.colorimetry import colour_rendering_index

            return colour_rendering_index(SAMPLES, sampled)

        found.append(value("cri", rendering))
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
        return [
            _of_light("exitance", RADIANT, amounts)._replace(
                label="radiant exitance", letter="M_e"
            ),
            _of_light("radiance", RADIANT, leaving)._replace(letter="L_e"),
            _of_light("radiance", LUMINOUS, leaving),
            value("temperature", source.temperature),
        ]
    if source.absolute:
        return [_of_light(source.absolute, kind, amounts) for kind in (RADIANT, LUMINOUS)]
    return []


def _of_light(name: str, kind: str, amounts: dict[str, float]) -> Value:
    """A light quantity in one kind, under its generic name where that is radiant."""
    symbol = SYMBOLS[specific_name(name, kind) if kind != RADIANT else name]
    geometry = symbol.geometry or (0, 0, 0)
    reach = {light_dimension(k, geometry, ""): amount for k, amount in amounts.items()}
    unit = light_unit(name, kind)
    own = light_dimension(kind, geometry, "")
    letter = symbol.letter if kind != RADIANT else ""
    return Value(symbol.name, symbol.label, letter, amounts[kind], (own,), (unit,), reach)


def _steps(lumens: float, watts: float, eye: Observer) -> list[Step]:
    weight = eye.label.split("(")[0]
    formula = Formula(
        "luminous efficacy of radiation",
        f"K = {eye.constant} int(S {weight} dlambda) / int(S dlambda)",
        "trapezoid on the union of the data's and the observer's grids",
    )
    return [formula.told(f"K = {lumens:.6g} lm / {watts:.6g} W = {lumens / watts:.6g} lm/W")]
