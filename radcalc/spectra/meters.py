"""Files of hand-held meters (UPRtek, Sekonic, LI-COR), with the wavelength in the name of each row.

    LUX<TAB>695.154907             Illuminance [lx],30.1
    CCT<TAB>5198.000000            Tcp [K],3262
    380nm<TAB>0.030267             Spectral Data 380[nm],0.000000000000

They do not state the unit of the spectrum; it is the unit that reproduces the illuminance of the
meter.
"""

import re
from collections.abc import Mapping, Sequence
from itertools import pairwise

from radcalc.errors import option
from radcalc.files import columns
from radcalc.files.text import refusal
from radcalc.spectra.column_titles import RELATIVE_WATTS, Meaning
from radcalc.spectra.contents import Contents, Figure, Row
from radcalc.spectra.planck import AVOGADRO

SEARCHED = 500  # lines that are searched for the spectrum
BAND = re.compile(
    r'\s*"?(?:spectral data\s*)?(\d{2,5}(?:[.,]\d+)?)\s*\[?nm\]?"?\s*([\t,;])(.*)', re.IGNORECASE
)
# Names of results, and the meters' names of them.
FIGURES = {
    "illuminance": ("lux", "illuminance [lx]"),
    "irradiance": ("irr",),
    "ppfd": ("ppfd", "ppfd [umolm⁻²s⁻¹]"),
    "cct": ("cct", "tcp [k]"),
}
# Units of spectra; they differ by powers of ten, so that the illuminance distinguishes them.
ABSOLUTE = tuple(
    Meaning(f"in {unit}, which reproduces the meter's illuminance", photons, "irradiance", factor)
    for unit, photons, factor in (
        ("W/m2/nm", False, 1.0),
        ("mW/m2/nm", False, 1e-3),
        ("uW/cm2/nm", False, 1e-2),
        ("umol/m2/s/nm", True, 1e-6 * AVOGADRO),
    )
)


def begins(lines: Sequence[str]) -> bool:
    """Return whether a file has several rows with wavelengths as names."""
    return sum(BAND.match(line) is not None for line in lines[:SEARCHED]) > 1


def read(lines: Sequence[str], name: str, column: str) -> Contents:
    """Return the rows of the finest table, and the figures of the meter."""
    if column:
        raise refusal(name, 0, "there are no columns to choose from", f"no {option('column')}")
    tables: list[list[Row]] = []
    is_exact = True  # whether every comma separates cells
    for number, line in enumerate(lines, 1):
        if match := BAND.match(line):
            row = number, match[1], _value(name, number, match[3], match[2])
            is_exact &= match[2] == "," and '"' not in match[3]
            if not tables or row[1] == tables[-1][0][1]:
                tables.append([])
            tables[-1].append(row)
    finest = max(tables, key=len)
    for table in tables:
        _refuse_gaps(table, name)
        if (table[0][1], table[-1][1]) != (finest[0][1], finest[-1][1]):
            problem = f"it ends at {finest[-1][1]} nm, another table at {table[-1][1]} nm"
            raise refusal(name, finest[-1][0], problem, "the whole file")
    notes: tuple[str, ...] = ()
    if len(tables) > 1:
        notes = (f"of its {len(tables)} tables the one of {len(finest)} rows is used",)
    figures = _figures(lines)
    meanings = (RELATIVE_WATTS, *(ABSOLUTE if "illuminance" in figures else ()))
    return Contents(finest, meanings, notes, figures, has_commas=not is_exact)


def _value(name: str, number: int, text: str, delimiter: str) -> str:
    cells = columns.cells(text.rstrip(f"{delimiter} "), delimiter)
    if len(cells) != 1:
        problem = f"{len(cells)} values at one wavelength"
        raise refusal(name, number, problem, "a file with one value in every row")
    return cells[0]


def _refuse_gaps(table: list[Row], name: str) -> None:
    """Raise for a table with a missing row: its steps are not all the same."""
    places = [float(row[1].replace(",", ".")) for row in table]
    steps = [after - before for before, after in pairwise(places)]
    for row, step in zip(table[1:], steps, strict=True):
        if abs(step - steps[0]) > 1e-6:
            problem = f"a step of {step:g} nm to {row[1]} nm, while the first is {steps[0]:g} nm"
            raise refusal(name, row[0], problem, "a row for every wavelength")


def _figures(lines: Sequence[str]) -> Mapping[str, Figure]:
    names = {spelling: name for name, spellings in FIGURES.items() for spelling in spellings}
    figures = {}
    for line in lines:
        cells = columns.cells(line, columns.dialect(line)[0])
        name = names.get(columns.plain(cells[0]), "") if len(cells) > 1 else ""
        if name:
            number = columns.finite(cells[1], True)
            if number is not None and number > 0:
                places = len(cells[1].replace(",", ".").partition(".")[2])
                figures[name] = Figure(number, 0.5 * 10.0**-places)
    return figures
