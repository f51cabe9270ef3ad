"""The contents of a spectrum file that is not a plain table: its rows and their meaning."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from types import MappingProxyType
from typing import NamedTuple

from radcalc.errors import ConditionError, TooNarrow, add, option, quote
from radcalc.quantities import KIND_NAMES, LUMINOUS, PHOTON, RADIANT, base_of
from radcalc.spectra import observers as weights
from radcalc.spectra.column_titles import Meaning
from radcalc.spectra.observers import AVOGADRO, OBSERVERS
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
NAMES = {RADIANT: "watts", LUMINOUS: "lumens", PHOTON: "photons"}


def name_of(kind: str) -> str:
    """Return what a kind counts: watts, lumens, photons, melanopic watts."""
    own = NAMES[base_of(kind)]
    return own if kind in NAMES else f"{KIND_NAMES[kind]} {own}"


class Counts:
    """The watts, lumens, photons and weighted light of a spectrum, computed on demand."""

    def __init__(
        self,
        source: Spectrum,
        limits: Range | None = None,
        photon_limits: Range | None = None,
        *,
        is_dark_outside: bool = False,
    ) -> None:
        """The ranges are the usual ones by default, limited to the data.

        With `is_dark_outside` a weight may extend beyond the data.
        """
        self.source, self.is_dark_outside = source, is_dark_outside
        self.given = {RADIANT: limits, PHOTON: photon_limits}
        everywhere = WHOLE if source.counts_all_photons else PAR
        self.asked = {RADIANT: limits or source.limits, PHOTON: photon_limits or everywhere}
        self.ranges = {
            kind: _overlap(limits_asked, source.known) for kind, limits_asked in self.asked.items()
        }
        self._amounts: dict[str, float] = {}

    def amount(self, kind: str) -> float:
        """Return an amount [W, lm or photons/s].

        Raises ConditionError for a weight that the data do not cover.
        """
        if kind not in self._amounts:
            self._amounts[kind] = self._count(kind)
        return self._amounts[kind]

    def _count(self, kind: str) -> float:
        if kind in self.ranges:
            return _in_range(self.source, kind, self.ranges[kind])
        if not self.is_dark_outside:
            refuse_uncovered(self.source, kind)
        return weights.count(self.source, kind)

    def over(self, kind: str) -> str:
        """Return the range of the watts or the photons as text; that of a weight, too."""
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
            if kind in self.ranges and self.ranges[kind] != self.asked[kind] and known
        ]
        for seen in kinds:
            if base_of(seen) == LUMINOUS and self.amount(seen):
                unseen = [self._unseen(kind, seen) for kind in kinds if self.given.get(kind)]
                notes += filter(None, unseen)
        return notes

    def left_out(self, kinds: Iterable[str]) -> list[str]:
        """Return the note on watts beyond the usual range, if watts count over it."""
        counts_watts = RADIANT in kinds and not self.given[RADIANT]
        return [self.source.left_out] if counts_watts and self.source.left_out else []

    def _unseen(self, kind: str, seen: str) -> str:
        part = self.source.part(self.ranges[kind])
        lumens = weights.count(part, seen) if part else 0.0
        share = lumens / self.amount(seen)
        if share > 1 - REMAINDER or not self.amount(kind):
            return ""
        own_ratio = weights.ratio_text(lumens / self.amount(kind), seen, kind)
        return (
            f"lumens are counted at all wavelengths: {self.over(kind)} has {100 * share:.3g} % of "
            f"them, which is {own_ratio} of its {NAMES[kind]}"
        )

    def impossible(self, over: str, under: str) -> TooNarrow | None:
        """Return the error for a ratio above that of any light, because of a narrow range."""
        ranged = [kind for kind in (over, under) if kind in self.ranges]
        if not ranged or base_of(over) == base_of(under):
            return None
        bottom = RADIANT if RADIANT in ranged else PHOTON
        top = under if over == bottom else over
        ratio = self.amount(top) / self.amount(bottom)
        longest = min(self.ranges[PHOTON][1], self.source.longest)
        _, most = weights.bounds(top, bottom, (0.0, longest) if top == PHOTON else WHOLE)
        if ratio <= most * SLACK:
            return None
        counted = "that are seen" if top != PHOTON else f"of photons over {self.over(PHOTON)}"
        refine = option("range" if bottom == RADIANT else "photon-range")
        return TooNarrow(
            f"{self.over(bottom)} leaves out most of the {NAMES[bottom]} {counted}: "
            f"{weights.ratio_text(ratio, top, bottom)} is more than any light gives "
            f"({weights.ratio_text(most, top, bottom)})",
            f"a wider {refine}",
        )


def _in_range(source: Spectrum, kind: str, limits: Range) -> float:
    return source.power(limits) if kind == RADIANT else source.photons(limits)


def _overlap(first: Range, second: Range) -> Range:
    """Return the common part of two ranges, or the first range if there is none."""
    low, high = max(first[0], second[0]), min(first[1], second[1])
    return (low, high) if low < high else first


def refuse_uncovered(source: Spectrum, kind: str) -> None:
    """Refuse a spectrum whose data do not cover the range of a weight, and name what is missing."""
    if limits := weights.range_of(kind):
        _refuse_uncovered(source, limits, f"the {KIND_NAMES[kind]} weight")


def _refuse_uncovered(source: Spectrum, limits: Range, of_what: str) -> None:
    if source.is_whole or not isinstance(source, Table):
        return
    (low, high), (start, end) = limits, source.covered
    missing = [(low, min(start, high))] if low < start else []
    missing += [(max(end, low), high)] if high > end else []
    if missing:
        raise ConditionError(
            f"the data of {quote(source.label)} cover {range_text(source.known)}, without "
            f"{' and '.join(map(range_text, missing))} of {of_what}",
            [add("dark-outside", remark="if it has no light there")],
        )


def responsivity(
    own: weights.Weight, source: Spectrum, limits: Range, *, is_dark_outside: bool = False
) -> float:
    """Return the amperes of a detector, over all data of a spectrum, per watt in a range."""
    if not is_dark_outside:
        _refuse_uncovered(source, own.range, f"the responsivity of {own.label}")
    watts = source.power(limits)
    if not watts > 0:
        raise ConditionError(f"{source.label} has no power", "another spectrum")
    return source.weigh(own.start, own.values, own.step) / watts
