"""A photon: wavelength, frequency, wavenumber, energy and luminous efficacy."""

from functools import reduce
from typing import Any

from radcalc.answer import Answer, Remark, Value, format_number
from radcalc.calculators.kinds import of_kinds
from radcalc.calculators.page import Operand, Page
from radcalc.calculators.results import known, value
from radcalc.conversion import spectral
from radcalc.inputs import Input, Inputs
from radcalc.laws.optics import PHOTON_LAWS
from radcalc.laws.solver import Derivation, Known, solve
from radcalc.maths import any_true, larger
from radcalc.quantities import PHOTON_NAMES, RADIANT, kind_of_observer
from radcalc.quantities.symbols import QUANTITY, SCOTOPIC, SYMBOLS
from radcalc.spectra.observers import OBSERVERS, Observer, luminous_efficiency
from radcalc.units.dimensions import LENGTH

PAGE = Page(
    results=(
        "wavelength",
        "frequency",
        "wavenumber",
        "photon-energy",
        "luminous-efficiency",
        "luminous-efficacy",
        "scotopic-luminous-efficiency",
        "scotopic-luminous-efficacy",
    ),
    about="Calculate wavelength, frequency, wavenumber, energy and luminous efficacy of a photon.",
    operand=Operand("wavelength", "WAVELENGTH|FREQUENCY|WAVENUMBER|ENERGY", QUANTITY),
    sections={"Light": ("observer",)},
    texts={"observer": "Observer (eye response) of the luminous efficiency."},
    draws=True,
    examples=(
        "555nm",
        "2.33eV",
        "540THz",
        "18000cm-1",
        "400nm:780nm:1nm get=luminous-efficacy plot=",
        "400nm:700nm:50nm get=wavelength:nm get=luminous-efficacy:lm/W",
    ),
    remarks="The wavelength, frequency, wavenumber and energy are those in vacuum.  The "
    "luminous efficacy is taken at the wavelength that you give.  A frequency, wavenumber or "
    "energy is first converted to a wavelength in standard air.",
)

SEEN = (
    *("luminous-efficiency", "luminous-efficacy"),
    *("scotopic-luminous-efficiency", "scotopic-luminous-efficacy"),
)
UNITS = {"photon-energy": ("eV", "J", "kJ/mol")}


def named(wave: Input) -> Input:
    """Return the input with the symbol of its quantity (wavelength, frequency ...)."""
    return wave._replace(symbol=SYMBOLS[PHOTON_NAMES[wave.dimension]])


def photon(given: Inputs) -> Answer:
    """Return the answer for a wavelength, frequency, wavenumber or photon energy in vacuum.

    The tables of the eye are for standard air.
    """
    wave = given["wavelength"]
    solution = solve(PHOTON_LAWS, {PHOTON_NAMES[wave.dimension]: Known(wave.value)})
    light = spectral.light(wave)
    observer = given["observer"].value if "observer" in given else "photopic"
    eye, kind = OBSERVERS[observer], kind_of_observer(observer)
    names = dict.fromkeys(PHOTON_NAMES.values())
    own_name = PHOTON_NAMES[wave.dimension]
    units = {name: UNITS.get(name, (SYMBOLS[name].unit,)) for name in names}
    values = [
        known(wave._replace(symbol=SYMBOLS[name]), *units[name])
        if name == own_name
        else value(name, solution.values[name].value, *units[name])
        for name in names
    ]
    scotopic = OBSERVERS["scotopic"]
    if eye is not scotopic:
        values += _visibility("luminous", light.table, eye, kind)
    values += _visibility("scotopic-luminous", light.table, scotopic, SCOTOPIC)
    notes = []
    efficiencies = [row.si for row in values if row.name.endswith("efficiency")]
    is_dark = reduce(larger, efficiencies) == 0
    if any_true(is_dark):
        notes.append(f"{wave.text_where(is_dark)} is invisible: it is outside the tables")
    eyes = dict.fromkeys([eye, scotopic])
    steps = [
        spectral.efficacy_step(one.maximum * luminous_efficiency(light.table, one), one)
        for one in eyes
    ]
    return Answer(
        values, _assumptions(light, wave), notes, Derivation(solution, before=(), after=steps)
    )


def _visibility(name: str, wavelength: Any, observer: Observer, kind: str) -> list[Value]:
    efficiency = luminous_efficiency(wavelength, observer)
    return [
        value(f"{name}-efficiency", efficiency),
        of_kinds(value(f"{name}-efficacy", observer.maximum * efficiency), kind, RADIANT),
    ]


def _assumptions(light: spectral.Light, wave: Input) -> list[str]:
    vacuum = "the wavelength is that in vacuum"
    tables = f"{wave.text} is {format_number(light.table * 1e9)} nm in standard air, as used in"
    tables += " the tables of the eye"
    if wave.dimension == LENGTH:
        vacuum = spectral.VACUUM.format(wave.text)
        tables = "the tables of the eye are used at this value"
    return [Remark(vacuum, PHOTON_NAMES.values()), Remark(tables, SEEN)]
