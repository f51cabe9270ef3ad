"""Comparison of a meter's own figures with those of its spectrum."""

from collections.abc import Callable, Mapping, Sequence

from radcalc.spectra.contents import Figure
from radcalc.spectra.observers import OBSERVERS
from radcalc.spectra.planck import AVOGADRO
from radcalc.spectra.spectrum import PAR, Table

CLOSE = 0.01  # relative deviation by other tables of the same spectrum
UNITS = {"illuminance": "lx", "irradiance": "W/m2", "ppfd": "umol/m2/s", "cct": "K"}


def chosen(tables: Sequence[Table], figures: Mapping[str, Figure]) -> tuple[Table, tuple[str, ...]]:
    """Return the table that fits the figures of the meter, and notes on figures that deviate.

    `tables` are the same numbers with several meanings.  The first whose illuminance agrees within
    1 % and rounding is returned, or else the relative one; a single one in any case.
    """
    if len(tables) == 1:
        return tables[0], ()
    relative, *absolute = tables
    given = figures["illuminance"]
    for table in absolute:
        if _are_close(_illuminance(table), given):
            return table, tuple(
                f"the meter measured {figure.value:g} {UNITS[name]} ({name}), "
                f"but its spectrum gives {value:.6g}"
                for name, figure in figures.items()
                if (value := RESULTS[name](table)) is not None and not _are_close(value, figure)
            )
    note = f"the meter measured {given.value:g} lx, which its spectrum gives in no usual unit"
    return relative, (note,)


def _are_close(value: float, figure: Figure) -> bool:
    return abs(value - figure.value) <= CLOSE * figure.value + figure.rounding


def _illuminance(table: Table) -> float:
    return table.lumens(OBSERVERS["photopic"])


def _ppfd(table: Table) -> float:
    return table.photons(PAR) / AVOGADRO * 1e6


def _temperature(table: Table) -> float | None:
    from radcalc.spectra.colorimetry import temperature_of  # loads large tables

    return temperature_of(table)


RESULTS: Mapping[str, Callable[[Table], float | None]] = {
    "illuminance": _illuminance,
    "irradiance": Table.total,
    "ppfd": _ppfd,
    "cct": _temperature,
}
