"""The list of named spectra: kind, colour temperature, lux per PPFD."""

import re
from collections.abc import Iterable
from typing import NamedTuple

from radcalc.errors import UsageError, command, corrections, nearest, quote
from radcalc.quantities import LUMINOUS, PHOTON
from radcalc.quantities.language import ENGLISH, LANGUAGES
from radcalc.quantities.search import comparable, matching
from radcalc.spectra.colorimetry import temperature_of
from radcalc.spectra.contents import Counts
from radcalc.spectra.observers import AVOGADRO
from radcalc.spectra.sources import aliases, names
from radcalc.spectra.sources import spectrum as read_spectrum

# Kinds by patterns of names (CIE 15:2018, and codes of lamps), in English, Czech and Russian; the
# first match applies.  Other names have no kind.
LAMPS = (
    (r"AM\d.*", "sun", "slunce", "солнце"),
    (r"B", "direct sunlight, obsolete", "přímé sluneční světlo, zastaralé",
     "прямой солнечный свет, устаревший"),
    (r"S?C", "average daylight, obsolete", "průměrné denní světlo, zastaralé",
     "средний дневной свет, устаревший"),
    (r"D\d+|.*(?:Photographic|Sensitometric) Daylight", "daylight", "denní světlo",
     "дневной свет"),
    (r"ID\d+", "indoor daylight", "denní světlo v místnosti", "дневной свет в помещении"),
    (r"E", "equal energy", "rovnoenergetické", "равноэнергетический"),
    (r"S?A|.*Incandescent|60 A/W.*|ISO.*(?:Tungsten|Photoflood)", "incandescent", "žárovka",
     "лампа накаливания"),
    (r"LED-BH\d", "LED, blue and phosphor, and red", "LED, modrá s luminoforem a červená",
     "светодиод, синий с люминофором, и красный"),
    (r"LED-B\d", "LED, blue and phosphor", "LED, modrá s luminoforem",
     "светодиод, синий с люминофором"),
    (r"LED-V\d", "LED, violet and phosphor", "LED, fialová s luminoforem",
     "светодиод, фиолетовый с люминофором"),
    (r"LED-RGB\d|3-LED.*", "LED, of three colours", "LED, tříbarevná", "светодиод, трёхцветный"),
    (r"4-LED.*", "LED, of four colours", "LED, čtyřbarevná", "светодиод, четырёхцветный"),
    (r"Luxeon.*|PHOS-.*|Phosphor LED.*", "LED, with phosphor", "LED s luminoforem",
     "светодиод с люминофором"),
    (r"HP\d", "high-pressure discharge", "vysokotlaká výbojka",
     "разрядная лампа высокого давления"),
    (r".*HPS\)?", "high-pressure sodium", "vysokotlaká sodíková výbojka",
     "натриевая лампа высокого давления"),
    (r"LPS", "low-pressure sodium", "nízkotlaká sodíková výbojka",
     "натриевая лампа низкого давления"),
    (r"(?:.*\()?Mercury.*", "mercury", "rtuťová výbojka", "ртутная лампа"),
    (r"Metal Halide|MHC.*", "metal halide", "halogenidová výbojka", "металлогалогенная лампа"),
    (r"FL\d.*|.* FL\)?|F\d+.*|T8 .*|Philips TL.*|Thorn Kolor.*", "fluorescent", "zářivka",
     "люминесцентная лампа"),
)  # fmt: skip
PATTERNS = [re.compile(row[0]) for row in LAMPS]


class Named(NamedTuple):
    """A named spectrum; `kind` is its row of `LAMPS`."""

    name: str
    kind: int | None

    def kind_in(self, language: str) -> str:
        place = 1 + LANGUAGES.index(language)
        return "" if self.kind is None else LAMPS[self.kind][place]

    @property
    def words(self) -> str:
        """Return the text for searches: its name, its alias, and its kind in every language."""
        return " ".join([self.name, *aliases(self.name), *map(self.kind_in, LANGUAGES)])


def search(text: str = "") -> list[Named]:
    """Return the named spectra whose names and kinds have words that begin with all given words.

    Raises
    ------
    UsageError
        If there is no match.

    Examples
    --------
    >>> [spectrum.name for spectrum in search("vysokotlaká sodíková")]
    ['HPS', 'Super HPS', 'C100S54 (HPS)', 'C100S54C (HPS)', 'SDW-T 100W/LV (Super HPS)']
    """
    spectra = [Named(name, kind_of(name)) for name in names()]
    if not text.strip():
        return spectra
    matches = matching(text, spectra, lambda spectrum: spectrum.words)
    if matches:
        return matches
    words = {word for spectrum in spectra for word in comparable(spectrum.words).split()}
    near = nearest(comparable(text), words, cutoff=0.75)
    raise UsageError(
        f"unknown spectrum '{quote(text)}'",
        corrections(text, *near) or command("spectrum", list=""),
    )


def kind_of(name: str) -> int | None:
    """Return the row of `LAMPS` for a name, or None."""
    return next((k for k, pattern in enumerate(PATTERNS) if pattern.fullmatch(name)), None)


def temperature_and_ratio(name: str) -> tuple[float | None, float]:
    """Return the correlated colour temperature [K] of a named spectrum, and its lux per umol/m2/s.

    Examples
    --------
    >>> cct, lux_per_ppfd = temperature_and_ratio("D65")
    >>> round(cct), round(lux_per_ppfd, 2)
    (6503, 55.5)
    """
    source = read_spectrum(name)
    counts = Counts(source)
    lux_per_ppfd = counts.amount(LUMINOUS) / (counts.amount(PHOTON) / AVOGADRO * 1e6)
    return temperature_of(source), lux_per_ppfd


def described(spectra: Iterable[Named]) -> list[tuple[str, str]]:
    """Return names, each with a line on its colour temperature and kind."""
    lines = []
    for spectrum in spectra:
        cct, _ = temperature_and_ratio(spectrum.name)
        facts = [f"{cct:.0f} K"] if cct else []
        lines.append(
            (spectrum.name, ", ".join([*facts, *filter(None, [spectrum.kind_in(ENGLISH)])]))
        )
    return lines
