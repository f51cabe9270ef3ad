"""What follows from a wavelength: frequency, wavenumber, energy, and what the eye sees of it."""

from typing import Any

from radcalc.answer import Answer, Value
from radcalc.calculators.results import known, value
from radcalc.conversion import spectral
from radcalc.derivation import format_number
from radcalc.given import Given, Inputs
from radcalc.laws.photon import LAWS
from radcalc.laws.solver import Derivation, Known, solve
from radcalc.quantities.light import PHOTON_NAMES
from radcalc.quantities.symbols import SYMBOLS
from radcalc.spectra.observers import OBSERVERS, Observer, luminous_efficiency
from radcalc.units.dimensions import LENGTH

UNITS = {"photon-energy": ("eV", "J", "kJ/mol")}


def named(wave: Given) -> Given:
    """What is given for the wavelength, by the name of what it is."""
    return wave._replace(symbol=SYMBOLS[PHOTON_NAMES[wave.dimension]])


def photon(given: Inputs) -> Answer:
    """Everything that follows from one wavelength, frequency, wavenumber or photon energy.

    `given` has it as its wavelength, and may have an observer.  The wavelength, frequency,
    wavenumber and energy are those in vacuum; the eye's tables are in standard air.
    """
    wave = given["wavelength"]
    solution = solve(LAWS, {PHOTON_NAMES[wave.dimension]: Known(wave.value)})
    light = spectral.light(wave, given.get("observer"))
    names = dict.fromkeys(PHOTON_NAMES.values())
    own = PHOTON_NAMES[wave.dimension]
    units = {name: UNITS.get(name, (SYMBOLS[name].unit,)) for name in names}
    values = [
        known(wave._replace(symbol=SYMBOLS[name]), *units[name])
        if name == own
        else value(name, solution.values[name].value, *units[name])
        for name in names
    ]
    scotopic = OBSERVERS["scotopic"]
    if light.observer is not scotopic:
        values += _seen("luminous", light.table, light.observer)
    values += _seen("scotopic-luminous", light.table, scotopic)
    notes = []
    if not any(one.si for one in values if one.name.endswith("efficiency")):
        notes.append(f"nothing is seen at {wave.text}: it lies outside the tables")
    return Answer(values, _assumptions(light, wave), notes, Derivation(solution))


def _seen(kind: str, wavelength: Any, observer: Observer) -> list[Value]:
    """Efficiency and efficacy of one wavelength [m]."""
    efficiency = luminous_efficiency(wavelength, observer)
    return [
        value(f"{kind}-efficiency", efficiency),
        value(f"{kind}-efficacy", observer.maximum * efficiency),
    ]


def _assumptions(light: spectral.Light, wave: Given) -> list[str]:
    eyes = dict.fromkeys([light.observer.assumption, OBSERVERS["scotopic"].assumption])
    if wave.dimension == LENGTH:
        taken = spectral.VACUUM.format(wave.text)
        return [f"{taken}, and looked up in the eye's tables as it is", *eyes]
    air = f"{wave.text} is {format_number(light.table * 1e9)} nm in standard air"
    return [f"the wavelength is that in vacuum; {air}, where the eye's tables are", *eyes]
