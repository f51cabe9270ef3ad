"""What the file of a spectrum has that is no plain table: its rows, and what they are."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import NamedTuple

from radcalc.spectra.column_titles import Meaning

Row = tuple[int, str, str]  # its line, the wavelength [nm] and the value, as they are written


class Figure(NamedTuple):
    """What a meter found itself, and half a unit of its last digit."""

    value: float
    rounding: float


NO_FIGURES: Mapping[str, Figure] = MappingProxyType({})


class Contents(NamedTuple):
    """The rows of a file; several meanings where its own figures have to tell which one is right.

    `figures` are what the meter itself found, by name, in the units of `figures.UNITS`.
    """

    rows: list[Row]
    meanings: tuple[Meaning, ...]
    notes: tuple[str, ...] = ()
    figures: Mapping[str, Figure] = NO_FIGURES
    has_commas: bool = False  # numbers may have decimal commas
