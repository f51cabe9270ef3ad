"""Words of growers that stand for a unit: ppfd, ppf and dli.

They are quantities, named in place of a unit: 700 ppfd is 700 umol/m2/s of the photons from 400 nm
to 700 nm.
"""

from radcalc.errors import Try, UnitError, ambiguous, corrections
from radcalc.units.table import resolve
from radcalc.units.unit import Daily, Photosynthetic, Unit

PPFD = "PPFD is the photon irradiance from 400 nm to 700 nm, usually in umol/m2/s"
PPF = "PPF is the photon flux from 400 nm to 700 nm, usually in umol/s"
DLI = "DLI is the daily light integral: the photons from 400 nm to 700 nm in a day, in mol/m2"
WORDS: "dict[str, tuple[str, type[Photosynthetic], str]]" = {
    "ppfd": ("umol/m2/s", Photosynthetic, PPFD),
    "ppf": ("umol/s", Photosynthetic, PPF),
    "dli": ("mol/m2", Daily, DLI),
}


AMBIGUOUS = ("par",)
PAR_RANGE = "400nm:700nm"  # of watts of PAR


def refuse(text: str) -> None:
    """Raise for PAR, which is a range of wavelengths and is measured in photons or in watts."""
    if text.strip().lower() in AMBIGUOUS:
        watts = Try((("range", PAR_RANGE),), instead=(text, "W/m2"), remark="the watts")
        raise UnitError(
            ambiguous(text, "photons (PPFD, in umol/m2/s) or watts (W/m2) from 400 nm to 700 nm"),
            [*corrections(text, "ppfd", remark="the photons"), watts],
        )


def find(word: str) -> Unit | None:
    """Return the unit that PPFD, PPF or DLI stands for, with its note; None for other words."""
    refuse(word)
    if word.lower() not in WORDS:
        return None
    text, kind, note = WORDS[word.lower()]
    unit = resolve(text).of_class(kind, note)
    unit.name = word
    return unit
