"""Readers of spectra and wavelength ranges."""

import re
from typing import Any

from radcalc.errors import ConditionError, RadcalcError, option, quote
from radcalc.inputs.given import Input, runs_backwards
from radcalc.inputs.quantities import quantity_input
from radcalc.quantities.symbols import SPECTRUM, SYMBOLS, WAVELENGTHS, Symbol
from radcalc.units.amounts import split_value
from radcalc.units.dimensions import LENGTH
from radcalc.units.table import resolve

# two numbers, with a unit after the last or after both
RANGE = re.compile(r"(\d+\.?\d*)\s*(?:nm|um|µm)?\s*(?:[-:,–]|to|\.\.)\s*(\d+\.?\d*)\s*(nm|um|µm)?")


def spectrum_input(symbol: Symbol, value: Any) -> Input:
    """Read a spectrum: a text, the path, column and unit of a file, or a spectrum."""
    from radcalc.spectra.sources import spectrum, uncertain_parameter
    from radcalc.spectra.spectrum import Spectrum

    if isinstance(value, Spectrum):
        return Input(symbol, value.label, value)
    if isinstance(value, tuple):  # a file, its column and its unit
        return Input(symbol, value[0], spectrum(*value))
    text = str(value).strip()
    uncertain = uncertain_parameter(text)
    if uncertain is None:
        return Input(symbol, text, spectrum(text))
    amount = uncertain.amount
    return Input(
        symbol,
        text,
        uncertain.source(amount.number),
        number=amount.number,
        unit=amount.unit,
        uncertainty=amount.uncertainty * float(amount.unit.factor if amount.unit else 1),
        parts=amount.parts,
    )


def wavelengths_input(symbol: Symbol, value: Any) -> Input:
    """Read LOW:HIGH, two wavelengths [nm]."""
    text = str(value).strip()
    parts = text.split(":")
    ends = (
        [quantity_input(SYMBOLS["wavelength"], end) for end in parts]
        if all(map(_is_length, parts))
        else []
    )
    if len(ends) != 2:
        raise ConditionError(
            f"{option(symbol.name, quote(text))} is not a range of wavelengths",
            option(symbol.name, _in_nanometres(text) or symbol.example),
        )
    low, high = (round(end.value * 1e9, 9) for end in ends)
    if low == high:
        raise ConditionError(
            f"{option(symbol.name, quote(text))} is a single wavelength",
            option(symbol.name, symbol.example),
        )
    if low > high:
        raise runs_backwards(symbol, text, option(symbol.name, f"{ends[1].text}:{ends[0].text}"))
    return Input(symbol, text, (low, high))


def _in_nanometres(text: str) -> str:
    """Return the range that 400-700, 400:700 or 400-700nm means; '' for other texts."""
    ends = RANGE.fullmatch(text)
    return f"{ends[1]}{ends[3] or 'nm'}:{ends[2]}{ends[3] or 'nm'}" if ends else ""


def _is_length(text: str) -> bool:
    try:
        value, unit = split_value(text)
        return value > 0 and bool(unit) and resolve(unit).dimension == LENGTH
    except RadcalcError:
        return False


READERS = {SPECTRUM: spectrum_input, WAVELENGTHS: wavelengths_input}
