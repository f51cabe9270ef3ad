"""The contents of a spectrum file that is not a plain table: its rows and their meaning."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import NamedTuple

from radcalc.spectra.column_titles import Meaning

Row = tuple[int, str, str]  # line number, wavelength [nm] and value, as written


class Figure(NamedTuple):
    """A figure measured by a meter, and half a unit of its last digit."""

    value: float
    rounding: float


NO_FIGURES: Mapping[str, Figure] = MappingProxyType({})


class Contents(NamedTuple):
    """The rows of a file, with several meanings if the meter's figures must decide between them.

    `figures` are the meter's own results, by name, in the units of `figures.UNITS`.
    """

    rows: list[Row]
    meanings: tuple[Meaning, ...]
    notes: tuple[str, ...] = ()
    figures: Mapping[str, Figure] = NO_FIGURES
    has_commas: bool = False  # numbers may have decimal commas
