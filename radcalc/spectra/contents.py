"""The contents of a spectrum file that is not a plain table: its rows and their meaning."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from types import MappingProxyType
from typing import NamedTuple

from radcalc.errors import TooNarrow, option
from radcalc.quantities import LUMINOUS, PHOTON, RADIANT
from radcalc.spectra.column_titles import Meaning
from radcalc.spectra.observers import AVOGADRO, OBSERVERS, Observer, bounds, ratio_text
from radcalc.spectra.spectrum import PAR, WHOLE, Range, Spectrum, Table, range_text

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
    divisor: float = 1.0  # of the values


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


SLACK = 1 + 1e-9
REMAINDER = 5e-4  # fraction of the lumens outside a range that needs no note
NAMES = {RADIANT: "watts", PHOTON: "photons"}


class Counts:
    """The watts, lumens and photons of a spectrum, computed on demand."""

    def __init__(
        self, source: Spectrum, eye: Observer, limits: Range | None, photon_limits: Range | None
    ) -> None:
        """The ranges are the usual ones by default, limited to the data."""
        self.source, self.eye = source, eye
        self.given = {RADIANT: limits, PHOTON: photon_limits}
        everywhere = WHOLE if source.counts_all_photons else PAR
        self.asked = {RADIANT: limits or source.limits, PHOTON: photon_limits or everywhere}
        self.ranges = {
            kind: _overlap(limits_asked, source.known) for kind, limits_asked in self.asked.items()
        }
        self._amounts: dict[str, float] = {}

    def amount(self, kind: str) -> float:
        """Return an amount [W, lm or photons/s]."""
        if kind not in self._amounts:
            self._amounts[kind] = _count(self.source, kind, self.ranges.get(kind, WHOLE), self.eye)
        return self._amounts[kind]

    def over(self, kind: str) -> str:
        return range_text(self.ranges[kind])

    @property
    def known(self) -> str:
        """The known range of the spectrum, as text; '' if it is the whole spectrum."""
        return "" if self.source.is_whole else range_text(self.source.known)

    def notes(self, kinds: Iterable[str]) -> list[str]:
        label, known = self.source.label, self.known
        notes = [
            f"{label} is known over {known}: {NAMES[kind]} are counted over {self.over(kind)}, "
            f"not over {range_text(self.asked[kind])}"
            for kind in kinds
            if kind != LUMINOUS and self.ranges[kind] != self.asked[kind] and known
        ]
        if LUMINOUS in kinds and self.amount(LUMINOUS):
            notes += [
                note for kind in kinds if self.given.get(kind) and (note := self._unseen(kind))
            ]
        return notes

    def left_out(self, kinds: Iterable[str]) -> list[str]:
        """Return the note on watts beyond the usual range, if watts count over it."""
        counts_watts = RADIANT in kinds and not self.given[RADIANT]
        return [self.source.left_out] if counts_watts and self.source.left_out else []

    def _unseen(self, kind: str) -> str:
        part = self.source.part(self.ranges[kind])
        lumens = _count(part, LUMINOUS, WHOLE, self.eye) if part else 0.0
        share = lumens / self.amount(LUMINOUS)
        if share > 1 - REMAINDER or not self.amount(kind):
            return ""
        own_ratio = ratio_text(lumens / self.amount(kind), LUMINOUS, kind)
        return (
            f"lumens are counted at all wavelengths: {self.over(kind)} has {100 * share:.3g} % of "
            f"them, which is {own_ratio} of its {NAMES[kind]}"
        )

    def impossible(self, over: str, under: str) -> TooNarrow | None:
        """Return the error for a ratio above that of any light, because of a narrow range."""
        kinds = {over, under}
        top = LUMINOUS if LUMINOUS in kinds else PHOTON
        (bottom,) = kinds - {top}
        ratio = self.amount(top) / self.amount(bottom)
        longest = min(self.ranges[PHOTON][1], self.source.longest)
        _, most = bounds(top, bottom, self.eye, (0.0, longest) if top == PHOTON else WHOLE)
        if ratio <= most * SLACK:
            return None
        counted = "that are seen" if top == LUMINOUS else f"of photons over {self.over(PHOTON)}"
        refine = option("range" if bottom == RADIANT else "photon-range")
        return TooNarrow(
            f"{self.over(bottom)} leaves out most of the {NAMES[bottom]} {counted}: "
            f"{ratio_text(ratio, top, bottom)} is more than any light gives "
            f"({ratio_text(most, top, bottom)})",
            f"a wider {refine}",
        )


def _count(source: Spectrum, kind: str, limits: Range, eye: Observer) -> float:
    if kind == LUMINOUS:
        return source.lumens(eye)
    return source.power(limits) if kind == RADIANT else source.photons(limits)


def _overlap(first: Range, second: Range) -> Range:
    """Return the common part of two ranges, or the first range if there is none."""
    low, high = max(first[0], second[0]), min(first[1], second[1])
    return (low, high) if low < high else first
