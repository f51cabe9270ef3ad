"""The titles of a file's columns: the unit of its wavelengths, and the meaning of its values."""

import re
from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

from radcalc.errors import ConditionError, UnitError, option, quote
from radcalc.files.columns import plain, units_in
from radcalc.quantities import PER_WAVELENGTH, PHOTON, RADIANT, Reading, read
from radcalc.quantities.column_titles import read_title, refuse_altered, refuse_unknown
from radcalc.units import Unit
from radcalc.units.dimensions import RESPONSIVITY
from radcalc.units.table import resolve, unit_of

NANOMETRES = {  # in a unit, by its name in lower case
    "nm": 1.0,
    "nanometre": 1.0,
    "nanometer": 1.0,
    "um": 1e3,
    "micron": 1e3,
    "micrometre": 1e3,
    "micrometer": 1e3,
    "angstrom": 0.1,
    "å": 0.1,
    "mm": 1e6,
    "m": 1e9,
}
NAMES: tuple[str, ...] = ("lambda", "λ", "wl", "wave", "wvl", "w.length", "wellenlänge")
NAMES += ("longueur d'onde", "longitud de onda", "vlnová délka", "длина волны")
# A wavelength with its unit: wavelength (nm), wavelength [nm], wavelength in nm, wavelength_nm.
DECLARED = re.compile(
    r"(?:wave ?length|wvlgth|lambda|\bwl)s?\W*(?:in )?[\s_(\[:,]*([a-zå]+)[\s)\]]*$"
)
BRACKETED = re.compile(r"[(\[]\s*([^)\]]*?)\s*[)\]]\s*$")
# Wavelengths in nm by a line of a program: Ocean Optics', LI-COR's (LI-1800), StellarNet's.
STATED = re.compile(
    r'>>>>>|x ?axis mode: *wavelength|"?lims *:.*nm|"? *\w+-> +wave: *\d+nm', re.ASCII
)
WORD = r"(?<![^\W\d_]){}(?![^\W\d_])"  # of any alphabet
X_UNITS = re.compile(r"x[ _-]?(?:axis[ _-]?)?units?\s*[:=]\s*(.+)")  # in a preamble, as in JCAMP-DX
PROPERTY = WORD.format(
    r"(?:absorb|absorpt|transmitt|transmiss|reflec|respons|sensitiv|efficien|extinct|emissiv|remiss"
    r"|reflex|reflekt|odraz|propust|pohlt|отраж|пропуск|поглощ)[^\W\d_]*"
)
# Raw values of a detector, properties of samples, and photons weighted by the response of plants.
NO_LIGHT = re.compile(
    PROPERTY
    + "|"
    + WORD.format(
        "(?:optical.densit(?:y|ies)|od|qe|eqe|refractive|counts?|cts|adu|dn|raw|dark|scope|albedo"
        "|refl|rfl|trans|transm|abs|y(?:ield )?(?:ppfd?|pfd?|photon flux(?: density)?)"
        "|log(?:10)?|ln|lg|d(?:b|bm)|err(?:ors?)?|std|stdev|uncertainty|cumulative)"
    )
    + r"|% ?[tra]\b|\b[tra] ?[(\[]? ?%|^[(\[]?%[)\]]?$|v ?\(lambda\)"
)
# A number before, after or within a unit, and 1/(...), which scale the values.
SCALED = re.compile(
    r"\d[\d.]*(?:e[-+]?\d+)? *[*x×]? *(?:[mkun]?w|[mu]?mol|j)/|(?<![a-z])[*x×] *\d|1/\(|/\d"
)
AXES = re.compile(
    WORD.format(
        r"(?:[mk]?ev|[mgtp]?hz|cm\^?-1|1/cm|energy|freq\w*|wave ?numbers?|raman|shift|pixels?"
        r"|times?|angles?|distance|temperature|position|channels?|depth)"
    )
)
PHOTONS = re.compile(
    WORD.format(
        r"(?:photon(?:s|en)?|foton[^\W\d_]*|фотон[^\W\d_]*|quant(?:a|um|en)|квант[^\W\d_]*|qntm"
        r"|s?ppfd?|s?pfd|u?mol|u?einsteins?|ph(?=(?:/| per )s))"
    )
)
# A line that is only a property of a sample, or has one after its key.
SAMPLED = re.compile(
    rf"(?:.*[:=\t,;])?\W*+(?:(?:percent|spectral|total|diffuse)\W++)*{PROPERTY}\W*(?:percent)?\W*"
)
PREFIXED = re.compile(r"(?<![a-zA-Z])([µμumkn])(Watt|Mol)s?(?![a-z])")
LONGEST = 500  # characters of a line before the table that are examined
LUMENS = re.compile(WORD.format("(?:lux|lx|lumens?|lm|candelas?|(?:il)?luminances?|luminous)"))
SHORT = {"Watt": "W", "Mol": "mol"}
KNOWN = "values in W/m2/nm, umol/m2/s/nm or the like"
# The radiant quantity by the powers of 1/area and 1/solid angle.
QUANTITIES = {(0, 0): "flux", (0, 1): "intensity", (1, 0): "irradiance", (1, 1): "radiance"}


class Meaning(NamedTuple):
    """The values of a file: watts or photons per wavelength, absolute or relative."""

    said: str
    are_photons: bool = False
    absolute: str = ""  # the radiant quantity, if there is a unit
    factor: float = 1.0  # to W/../nm or photon/s/../nm


RELATIVE_WATTS = Meaning("its values taken as relative watts per wavelength")
RELATIVE_PHOTONS = Meaning("its values taken as relative photons per wavelength", True)
TYPED = {"relative": RELATIVE_WATTS, "photons": RELATIVE_PHOTONS}  # words for units
# The settings of a spectrometer, whose program may write counts; and words for calibrated values.
INTEGRATED = re.compile(
    r"(?:integration|int\.|exposure|vnir integration) ?time|scope ?->|csm:|spectra averaged"
    r"|^\W?lims ?:"
)
CALIBRATED = re.compile(
    WORD.format("(?:ir)?rad(?:iance)?") + r"|ir?radiance|watts?|(?<![0-9])w/|wm-2|spectral power"
)
LI1800 = re.compile(r'"?(?:lims|int) *:', re.IGNORECASE)
LI180 = re.compile(r"PFD ?\(umol m-2 s-1\)")  # of each nanometre, in its table of photons
PER_AREA_AND_NM = re.compile(r"(/c?m)(?:\^?2|²)(?=nm)")  # W/m^2nm
REMARK = re.compile(r'"?rem *:(.*)', re.IGNORECASE)
STATE = f"{option('unit', 'W/m2/nm')}, or relative, if they are light"


def is_wavelength(title: str) -> bool:
    """Return whether a plain title is that of wavelengths."""
    return bool(DECLARED.match(title)) or title.startswith(("wavelength", "nm ", "nm\t"))


def is_of_wavelengths(title: str) -> bool:
    """Return whether a plain title is that of a column of wavelengths, or only their unit."""
    unit = title.strip("()[] ").rstrip("s")
    return is_wavelength(title) or title in NAMES or unit in NANOMETRES


def of_light(titles: Sequence[str], places: Sequence[int]) -> list[int]:
    """Return the columns that may be light, by their titles."""
    found = []
    for place in places:
        try:
            values(titles[place])
        except ConditionError:
            continue
        found.append(place)
    return found


def wavelengths(
    titles: Sequence[str], comments: Iterable[str], low: float, high: float, axis: str
) -> tuple[float, str]:
    """Return the nanometres per unit of the wavelengths, and a note on it; 0 and what is missing.

    The unit is that of the user, or declared in the title or in a comment.  Wavelengths without a
    unit are in nm, if their numbers may be.
    """
    typed = {plain(title): title.strip() for title in (*titles, *comments)}
    own_titles = [plain(title) for title in titles]
    for text in own_titles:
        if AXES.search(text) and not DECLARED.search(text):
            raise ConditionError(f"'{quote(typed[text])}' is not a wavelength", "wavelengths in nm")
    _refuse_other_axis(typed)
    declared, factor = _declared(typed, own_titles)
    if axis:
        differs = declared and factor != NANOMETRES[axis]
        contrast = f", though {quote(declared)} is declared" if differs else ""
        return NANOMETRES[axis], f"the wavelengths are in {axis}, as given{contrast}"
    if declared:
        return factor, f"the wavelengths are in {quote(declared)}, as declared"
    if any(map(STATED.match, typed)):
        return 1.0, "the wavelengths are in nm, by the format of the file"
    if not any(map(is_of_wavelengths, own_titles)):
        return 0, f"no title says that the numbers from {low:g} to {high:g} are wavelengths"
    if 100 <= low < 2000 and high <= 20000:
        return 1.0, "the wavelengths are taken in nanometres: their title has no unit"
    return 0, f"the unit of the wavelengths from {low:g} to {high:g} is missing"


def _declared(typed: Mapping[str, str], own_titles: Sequence[str]) -> tuple[str, float]:
    """Return the unit of wavelengths in a title or another line, and its nanometres."""
    for text in typed:
        match = DECLARED.search(text)
        word = match.group(1) if match else ""
        if text in own_titles:
            bracket = BRACKETED.search(text)
            bare = text if text.rstrip("s") in NANOMETRES else word
            word = bracket.group(1) if bracket else bare
            if bracket and word.rstrip("s") not in NANOMETRES:
                unit_text = quote(_typed(typed[text], word))
                problem = f"unknown unit of wavelengths '{unit_text}'"
                raise ConditionError(problem, "nm, um, angstrom, mm or m")
        if word and word.rstrip("s") in NANOMETRES:
            return _typed(typed[text], word), NANOMETRES[word.rstrip("s")]
    return "", 0


def _refuse_other_axis(typed: Mapping[str, str]) -> None:
    """Raise for a preamble with another unit of the axis: XUNITS= 1/CM."""
    for text in typed:
        if (stated := X_UNITS.match(text)) and not is_of_wavelengths(stated[1].strip()):
            problem = f"'{quote(typed[text])}' is not a unit of wavelengths"
            raise ConditionError(problem, "wavelengths in nm")


def _typed(text: str, word: str) -> str:
    at = plain(text).rindex(word)
    return text[at : at + len(word)]


def values(title: str) -> Meaning:
    """Return the meaning of the values under a title; raise for values other than spectra."""
    title = _with_short_units(title)
    if LI180.fullmatch(title):
        return typed("umol/m2/s/nm")._replace(said="in umol/m2/s/nm, photons turned into watts")
    text = plain(title).replace("_", " ").replace("photon counts", "photons")
    if NO_LIGHT.search(text):
        raise ConditionError(f"'{quote(title)}' is not a calibrated quantity of light", KNOWN)
    try:
        parsed = read_title(title)
        if parsed.unit is None:
            refuse_altered(read_title(title.replace("%", " ")))  # of the peak, in any unit
    except UnitError as error:
        raise ConditionError(error.message, KNOWN) from None
    if parsed.unit and (facts := read(parsed.unit)):
        if _is_spectral(facts):
            return _absolute(facts, float(parsed.unit.factor))
        if parsed.in_brackets or not _is_word(parsed.unit, facts):
            problem = f"values in {quote(parsed.unit.text)} are not power or photons per wavelength"
            raise ConditionError(problem, KNOWN)
    if LUMENS.search(text):
        raise ConditionError(f"'{quote(title)}' is not power or photons per wavelength", KNOWN)
    if PHOTONS.search(text):
        return RELATIVE_PHOTONS
    try:
        refuse_unknown(parsed)
    except UnitError as error:
        raise ConditionError(error.message, KNOWN) from None
    return RELATIVE_WATTS


def typed(text: str) -> Meaning:
    """Return the meaning of a unit that the user gives: of light per wavelength, or a word."""
    if text.strip().lower() in TYPED:
        return TYPED[text.strip().lower()]
    unit = resolve(text)
    facts = read(unit)
    if not facts or not _is_spectral(facts):
        problem = f"{option('unit', quote(text))} is not power or photons per wavelength"
        raise ConditionError(
            problem, "W/m2/nm, umol/m2/s/nm, relative (watts) or photons (relative)"
        )
    meaning = _absolute(facts, float(unit.factor))
    return meaning._replace(
        said=", ".join(filter(None, (f"in {quote(text)}, as given", meaning.said)))
    )


def of_remark(lines: Sequence[str]) -> Meaning | None:
    """Return the unit in the remark of a LI-1800, or None; raise for properties of samples.

    Its program appends (QNTM) to the remark for umol/m2/s/nm, as the R package photobiologyInOut
    reads it.
    """
    remark = next(filter(None, map(REMARK.match, lines)), None)
    if not remark or not any(map(LI1800.match, lines)):
        return None
    text = plain(remark[1])
    if NO_LIGHT.search(text):
        raise ConditionError(f"'{quote(remark[0].strip())}' is not light", KNOWN)
    if "(qntm)" not in text:
        return None
    meaning = typed("umol/m2/s/nm")
    return meaning._replace(
        said="in umol/m2/s/nm, by its remark (QNTM); photons are converted to watts"
    )


def refuse_counts(lines: Sequence[str], meant: Meaning, title: str) -> None:
    """Raise for the preamble of a spectrometer that does not state that its values are light."""
    texts = [plain(line[:LONGEST]).replace("_", " ") for line in (*lines, title)]
    settings = next(
        (line for line, text in zip(lines, texts, strict=False) if INTEGRATED.search(text)), ""
    )
    if settings and meant == RELATIVE_WATTS and not any(map(CALIBRATED.search, texts)):
        problem = (
            f"the values may be counts of a detector: '{quote(settings.strip())}', and no unit"
        )
        raise ConditionError(problem, STATE)


def in_preamble(lines: Iterable[str], meant: Meaning) -> Meaning | None:
    """Return the unit of the values in the lines before a table; raise for lines on other data.

    `meant` is the meaning by the title of the column.
    """
    meanings: dict[object, Meaning] = {}
    photons = ""
    for line in lines:
        line = _with_short_units(line[:LONGEST])
        text = plain(line).replace("_", " ")
        if SAMPLED.fullmatch(text):
            raise ConditionError(f"'{quote(line.strip())}' is not light", KNOWN)
        brackets, endings = units_in(re.sub(r"[\t,;:=]", " ", line))
        for part in brackets + endings:
            facts, factor = _light(part, part in brackets)
            if facts and _is_spectral(facts):
                if SCALED.search(text):
                    raise ConditionError(f"'{quote(line.strip())}' scales its values", KNOWN)
                meaning = _absolute(facts, factor)
                notes = filter(None, (f"in {quote(part)}, as its preamble says", meaning.said))
                meanings[meaning] = meaning._replace(said=", ".join(notes))
                break
            if _is_of_a_detector(part):
                raise ConditionError(f"'{quote(line.strip())}' is not light", KNOWN)
        else:
            photons = photons or (line if PHOTONS.search(text) else "")
    if len(meanings) > 1:
        problem = "the lines before the table have several units of light"
        raise ConditionError(problem, "the unit in the title of the column")
    if not meanings and photons and not meant.are_photons:
        problem = f"'{quote(photons.strip())}' may mean that the values are photons"
        raise ConditionError(problem, "a title over the values: watts, photons or their unit")
    stated = next(iter(meanings.values()), None)
    if stated and meant.are_photons and not stated.are_photons:
        raise ConditionError("the title has photons, the lines before it watts", KNOWN)
    return stated


def _with_short_units(text: str) -> str:
    """Return the text with uW and umol for uWatt and uMol, which are not spellings of units."""
    short = PREFIXED.sub(lambda match: match[1] + SHORT[match[2]], text)
    return PER_AREA_AND_NM.sub(r"\g<1>2/", short)


def _is_spectral(facts: Reading) -> bool:
    return facts.axis == PER_WAVELENGTH and facts.kind in (RADIANT, PHOTON) and not facts.time


def _is_word(unit: Unit, facts: Reading) -> bool:
    """Return whether a unit serves as a word for its quantity in titles: watts, mol."""
    is_of_all = not (facts.axis or facts.area or facts.solid_angle or unit.is_scale)
    is_known = facts.kind == PHOTON or (facts.kind == RADIANT and not facts.time)
    return is_of_all and is_known and len(unit.atoms) == 1


def _is_of_a_detector(part: str) -> bool:
    """Return whether a text is a unit of a detector's output over light, such as A/W."""
    unit = unit_of(part) if "/" in part or "-" in part or "⁻" in part else None
    return unit is not None and unit.dimension == RESPONSIVITY


def _absolute(facts: Reading, factor: float) -> Meaning:
    are_photons = facts.kind == PHOTON
    note = "photons turned into watts" if are_photons else ""
    return Meaning(note, are_photons, QUANTITIES[facts.area, facts.solid_angle], factor * 1e-9)


def _light(text: str, in_brackets: bool) -> tuple[Reading | None, float]:
    """Return the facts of a unit of light and its factor to SI; W without brackets is a word."""
    if not text or not (in_brackets or "/" in text or "-" in text or "⁻" in text):
        return None, 1.0
    unit = unit_of(text)
    facts = read(unit) if unit else None
    return (facts, float(unit.factor)) if unit and facts else (None, 1.0)
