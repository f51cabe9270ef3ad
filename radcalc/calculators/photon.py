"""What follows from a wavelength: frequency, wavenumber, energy, and what the eye sees of it."""

from typing import Any

from radcalc.answer import Answer, Step, Value
from radcalc.conversion import spectral
from radcalc.conversion.conditions import ENERGY, LENGTH, PHOTON_ENERGY, Given, show
from radcalc.quantities.light import AXIS, FREQUENCY, LUMINOUS, RADIANT, RATIOS, WAVENUMBER
from radcalc.spectra.observers import OBSERVERS, Observer, luminous_efficiency
from radcalc.spectra.planck import LIGHT
from radcalc.units.table import NUMBER

PER_LUMEN = RATIOS[LUMINOUS, RADIANT]


def photon(given: Given, observer: Given | None = None) -> Answer:
    """Everything that follows from one wavelength, frequency, wavenumber or photon energy.

    Returns the values, what was assumed, the notes and the steps.  The wavelength, frequency,
    wavenumber and energy are those in vacuum; the eye's tables are in standard air.
    """
    light = spectral.light(given, observer)
    vacuum, energy = light.vacuum, light.photon_energy
    seen = light.observer
    scotopic = OBSERVERS["scotopic"]
    values = [
        Value("wavelength", "wavelength", "λ", vacuum, (LENGTH,), ("nm",)),
        Value("frequency", "frequency", "ν", LIGHT / vacuum, (AXIS[FREQUENCY],), ("THz",)),
        Value("wavenumber", "wavenumber", "σ", 1 / vacuum, (AXIS[WAVENUMBER],), ("cm-1",)),
        Value(
            "photon-energy",
            "photon energy",
            "Q",
            energy,
            (PHOTON_ENERGY, ENERGY),
            ("eV", "J", "kJ/mol"),
        ),
    ]
    if seen is not scotopic:
        values += _seen("luminous", light.table, seen)
    values += _seen("scotopic-luminous", light.table, scotopic)
    notes = []
    if not any(value.si for value in values if value.name.endswith("efficiency")):
        notes.append(f"nothing is seen at {given.text}: it lies outside the tables")
    return values, _assumptions(light), notes, _steps(light)


def _seen(name: str, wavelength: Any, observer: Observer) -> list[Value]:
    efficiency = luminous_efficiency(wavelength, observer)
    words, scotopic = name.replace("-", " "), "'" if "scotopic" in name else ""
    return [
        Value(
            f"{name}-efficiency",
            f"{words} efficiency",
            f"V{scotopic}",
            efficiency,
            (NUMBER,),
            ("1",),
        ),
        Value(
            f"{name}-efficacy",
            f"{words} efficacy",
            f"K{scotopic}",
            observer.maximum * efficiency,
            (PER_LUMEN,),
            ("lm/W",),
        ),
    ]


def _assumptions(light: spectral.Light) -> list[str]:
    eyes = dict.fromkeys([light.observer.assumption, OBSERVERS["scotopic"].assumption])
    text = light.given.text
    air = f"{text} is {show(light.table * 1e9)} nm in standard air"
    both = "the wavelength is that in vacuum"
    if light.given.dimension == LENGTH:
        both = f"{spectral.VACUUM.format(text)}, and looked up in the eye's tables as it is"
        return [both, *eyes]
    return [f"{both}; {air}, where the eye's tables are", *eyes]


def _steps(light: spectral.Light) -> list[Step]:
    nanometres = f"{show(light.vacuum * 1e9)} nm"
    source = "SI Brochure: exact h and c"
    return [
        Step(
            "frequency",
            "nu = c / lambda",
            f"nu = 299792458 m/s / {nanometres} = {show(LIGHT / light.vacuum * 1e-12)} THz",
            source,
        ),
        Step(
            "wavenumber",
            "sigma = 1 / lambda",
            f"sigma = 1 / {nanometres} = {show(0.01 / light.vacuum)} cm-1",
        ),
        Step(
            "photon energy",
            "Q = h c / lambda",
            f"Q = h c / {nanometres} = {show(light.photon_energy)} J",
            source,
        ),
    ]
