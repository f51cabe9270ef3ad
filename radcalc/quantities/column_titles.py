"""Titles of columns: the name and the unit in a title, and the column that a name means.

A unit is in brackets (`E [lx]`), after a slash as in ISO 80000 (`E / lx`), a word of the title
(`E_lx`, `E, lx`, `lux desk`), or the whole title.
"""

import re
from collections.abc import Collection, Iterator, Sequence
from typing import NamedTuple

from radcalc.errors import (
    MissingInput,
    UnitError,
    UsageError,
    add,
    computed,
    leave_out,
    listed,
    nearest,
    option,
    quote,
)
from radcalc.files.columns import IN_BRACKETS, plain
from radcalc.quantities import NONE, PHOTON, RADIANT, Reading, describe, read
from radcalc.quantities.names import PPF, PPFD, QUANTITIES, SOLAR, Quantity, weighted
from radcalc.quantities.search import GENERIC, comparable, index
from radcalc.quantities.symbols import LINKS, light_unit
from radcalc.units import NUMBER, Unit
from radcalc.units.compiled import WEIGHTS
from radcalc.units.table import PAR_RANGE, PARTS, resolve, suggest, unit_of
from radcalc.units.values import find_scale, scale_of

AROUND = " \t,;:_/-–"  # characters between a name and a unit
LONGEST = 200  # characters of a title that is searched for a unit
MOST_WORDS = 8  # of a unit
WORD = re.compile(r'[^\s,;:_"]+')
QUANTITY_OVER_UNIT = re.compile(r"[^/]*\w\s*/\s*(.+)")  # I/cd, the notation of ISO 80000
# Text before a unit in brackets: (unit: lx), (in lx), and numbers, which are then refused.
PREAMBLE = re.compile(r"(?:.*(?:[,;:=]|\bin\b))?\s*(?:[*×x]?\s*[\d⁰¹²³⁴-⁹.^+-]+\s*[*×x·]?\s*)?")
SCALED_BEFORE = re.compile(
    r"(?:[(\[][^)\]]*[\d⁰¹²³⁴-⁹]|(?:^|\s)1(?:0+|e)[-+^\d⁰¹²³⁴-⁹]*|[*×]|\d\s?x)\s*$"
)
HERE = "\0"  # placeholder of the unit in its title
# Numbers in a title that do not scale values: f/2.8, 1/e2, sizes such as 2x4, positions such as
# x1 y2 and x1, fractions and dates, areas such as 20 m².
NO_SCALE = re.compile(
    r"\bf/\d[\d.]*"
    r"|\b1\s?/\s?(?-i:e)(?:\^?2|²)?(?![^\W\d_])"
    r"|\b\d+(?:(?:[x×]| [x×] )(?!10+(?!\d))\d+)+(?![\d^⁰¹²³⁴-⁹.])"
    r"|(?<![^\W_])x=?\d+[\s_,;]*y=?\d+"
    r"|^x(?!10+(?!\d))\d+"
    r"|\b\d+(?:/(?!100)\d+)+"
    r"|(?<![^\W\d_])(?:[cmkµμ]?m|ft|s)(?:\^-?\d|⁻?[¹²³])",
    re.IGNORECASE,
)
FACTOR = re.compile(
    r"(?<![^\W\d_])x\s?\d|\d\s?x(?![^\W_])|[*×·÷]\s?\d|\d\s?[*×·]|/\s?\d"
    r"|10(?:\^|\*\*|[⁰¹²³⁴-⁹⁻])|(?<![^\W_])\d[\d.]*e[-+]?\d+(?![^\W_])"
    r"|(?<![^\W\d_])(?:thousand|million|hundred|tenth)(?:th)?s?(?![^\W\d_])"
    r"|(?<![^\W\d_])(?:gain|offset|factor|scaled?|multiplier|(?-i:nano|micro|milli|centi|deci|hecto"
    r"|kilo|mega|giga))(?![^\W\d_])|[(\[](?-i:[kMGuµμ])[)\]]"
    rf"|{HERE}[\])]?\s*\(?10{{2,}}\)?\s*$"
    r"|(?<!\d)(?<!\d\s)(?:%|‰|(?<![^\W\d_])(?:per ?cent|pct)(?![^\W\d_]))"
    rf"|{HERE}[\"')\]]*\s?(?:[/*·×^²³]|per\b)"
    # 1000 I (cd), but not 2 m (lx): the number before the symbol of a quantity
    rf"|^\s*\d[\d.,e]*\s?(?-i:[EFHILMQΦφ])(?:_\w+|[evp])?[\s(\[/,_]*(?:in\s+)?{HERE}",
    re.IGNORECASE,
)
FUNCTION = re.compile(
    r"(?<![^\W\d_])(?:(?i:log)(?:10|2|e)?|lg|ln|lb|dB[a-zA-Z]{0,3}|(?i:sqrt|squared|square root"
    r"|cumul\w*|integral|integrated|(?<![^\W\d_])(?:sum|delta|std|stdev|errors?|uncertainty)"
    r"|inverse|reciprocal|exp(?=\s?\()))(?=(?:[A-ZΑ-Ω][a-z]{0,3})?(?![^\W\d_]))"
    r"|(?<!\d)1\s?/\s?(?:[^\W\d_]|\()|(?<![^\W_])d[\w ()]+/\s?dt(?![^\W_])|±|\+/?-"
    r"|[√∛∫∂^²³⁻⁴-⁹]|\*\*"
)
IN = re.compile(r"(?:^|[\s_])(?:in|unit)$", re.IGNORECASE)
# A word that is surely meant as a unit of light, though unknown: klux, W/m2*s-1.
UNIT_OF_LIGHT = re.compile(
    r"(?<![^\W_])(?!units?(?![^\W_]))(?:[kmunµμ]|kilo|milli|micro)?"
    r"(?:lux|lx|lumens?|lm|candelas?|cd|watts?|w(?=/c?m|/sr|/nm)|mol|foot.?candles?|nits?)(?![^\W_])",
    re.IGNORECASE,
)
# Text in brackets that may be meant as a unit: a word as short as a symbol, or signs of units.
UNIT_LIKE = re.compile(r"[^\W\d_]{1,6}|\S*[/·^²³°%⁻]\S*|(?i:volts?|voltage|digits|percent)")
NO_UNIT = re.compile(  # places, statistics, zones of time, and words for relative values
    r"desk|bench|floor|wall|roof|room|site|top|bottom|left|right|front|back|side|upper|lower|inner"
    r"|outer|centre|center|middle|in|out|north|south|east|west|[nsew]{1,2}|up|down|low|high|new|old"
    r"|mean|avg|average|max|min|median|sum|est|cal|corr?|sensor|lamp|light|led|plot|day|night|sun"
    r"|sky|shade|utc|gmt|cet|cest|local|horiz|vert|tilt|global|direct|diffuse|optional|new|test"
    r"|rel|a\.?u\.?|arb|norm|spd|n/a|s/n",
    re.IGNORECASE,
)
OF_PVGIS = re.compile(r"G[bdr]?\([hni]\)")  # irradiances of PVGIS: horizontal, normal, inclined
PLACE = re.compile(r"\s*\((?:in|out|min|max|avg|[nshiab])\)", re.IGNORECASE)
# Remarks in brackets: the above, directions and days, one letter, a number of a sensor, a position,
# serial numbers, a band of wavelengths.
QUALIFIER = re.compile(
    rf"(?:{NO_UNIT.pattern})(?:[\s_-]?\w{{1,3}})?|[nshiab]|(?:sensor|channel|ch|probe|no\.?|nr\.?|#|[a-z])?"
    r"\s?#?\d{1,4}|.*\bs/?n\b.*|.*\blgr\b.*|lbl:.*|[\d.]+\s?[-–]\s?[\d.]+\s?nm|at .*|x\d+ y\d+",
    re.IGNORECASE,
)
OF_DETECTOR = re.compile(
    r"(?<![^\W\d_])(?:counts?|cts|adu|raw|bits?|volts?|voltage)(?![^\W\d_])", re.IGNORECASE
)
RELATIVE = re.compile(
    r"(?<![^\W_])(?:rel(?:ative)?|a\.?u\.?|arb|norm(?:ali[sz]ed)?)(?![^\W_])", re.I
)
PER_AREA = re.compile(r"(?<![^\W_])[^\W\d_]+/(?:[cm]?m|ft)\^?[2²](?![^\W_])")
# Spellings of meters that are not units of radcalc, without case and punctuation.
SPELLINGS = {
    **dict.fromkeys(("ftcd", "ftc", "fc", "fcd", "footcd", "ftcandle", "ftcandles"), "fc"),
    **dict.fromkeys(("lum/ft2", "lumen/ft2", "lumens/ft2", "lm/ft2"), "fc"),
    **dict.fromkeys(("lum/m2", "luxs"), "lx"),
}
WATTS = ("w/m2", "wm2")  # W/m2 in files of programs: w/m2, Wm2, Wm-2
DIRECT_NORMAL = "DNI"  # an irradiance; dni are days in Czech
BETWEEN = re.compile(r"(?<=\s)in(?=\s)")  # the preposition, not an inch: E at 2 m in W/m2
# Subscripts of symbols, as in E_v or E_ph, are units only if the unit of that quantity is meant.
SUBSCRIPTS = ("e", "v", "p", "ph", "q")
SYMBOL = re.compile(r"[EL](?![^\W_²³])")  # symbols, not the einstein and the lambert
RARE = ("exa", "zetta", "yotta", "ronna", "quetta", "atto", "zepto", "yocto", "ronto", "quecto")
BRACKETS = re.compile(r"[()\[\]]")
NUMBERED = re.compile(r"([^\W\d_]{2,})\d+")  # the second of several meters, lux2, not a square
# Names of photon quantities: PPFD, but PAR may also be in watts; PPF was once a name of PPFD.
PHOTON_IRRADIANCES = ("pfd", "spfd", "sppfd", *[name for name in PPFD if name != "par"])
PHOTONS = ("photon", "photons", "quanta", *PPF)
# Words of titles whose unit is of a weighted kind: melanopic EDI [lx].
OF_WEIGHTS = {
    "melanopic": "mel",
    "medi": "mel",
    "rhodopic": "rh",
    "cyanopic": "sc",
    "chloropic": "mc",
    "erythropic": "lc",
    "scotopic": "scot",
    "erythemal": "ery",
    "erythemally": "ery",
    "erythema": "ery",
    "ery": "ery",
    "actinic": "act",
    "epar": "epar",
    "ypf": "ypf",
    "ypfd": "ypf",
}
EDI = "edi"  # of melanopic light, if its title names no other
# Light of other weights and bands, which the lumens and the watts of a spectrum do not measure.
OF_BANDS = ("uva", "uvb", "uvc", "uv", "uvi", "longwave", "lw", "lwin", "lwout", "infrared", "nir")
OTHER_LIGHT = frozenset([*OF_WEIGHTS, EDI, *OF_BANDS])
NAMES_OF_PAR = ("par", "qpar", "фар")
COMPARED = 1000  # titles to search for names similar to an unknown one


class Title(NamedTuple):
    """A title: its name, and its unit, which is the text from `start` to `end`.

    `text[opening:start]` and `text[end:closing]` separate the unit from the name.
    """

    text: str
    name: str
    unit: Unit | None = None
    opening: int = 0
    start: int = 0
    end: int = 0
    closing: int = 0

    @property
    def in_brackets(self) -> bool:
        return BRACKETS.search(self.text, self.opening, self.start) is not None

    def with_unit(self, unit: str) -> str:
        """Return the title with another unit; a title without a unit is unchanged."""
        return self.text[: self.start] + unit + self.text[self.end :] if self.unit else self.text

    def renamed(self, name: str, unit: str) -> str:
        """Return another name with a unit in the same notation; the name alone without a unit."""
        if self.unit is None:
            return name
        if not self.opening:  # lux, lux (desk)
            return f"{name} [{unit}]"
        before, behind = self.text[self.opening : self.start], self.text[self.end : self.closing]
        return name + before + unit + behind


def read_title(text: str, like: Unit | None = None) -> Title:
    """Return the name and the unit in a title.

    The unit may measure the quantity of `like`, or any quantity of light if `like` is None.  If no
    such unit is found, text in brackets may be any unit, and a word of several letters any unit of
    light.
    """
    title = _read(text, like)
    if title.unit is None and (match := UNIT_OF_LIGHT.search(text)):
        hint = ", ".join(suggest(match[0])) or "a unit of radcalc units"
        raise UnitError(f"unknown unit in the title '{quote(text)}'", hint)
    if title.unit:
        refuse_altered(title)
        refuse_misnamed(title, title.unit)
    if not title.in_brackets and (title.unit or unit_of_name(text)):
        _refuse_unread(title)
    return title


def _refuse_unread(title: Title) -> None:
    """Raise for brackets that are neither a unit nor a qualifier, as in `PAR (mV)` and `lux [xx]`.

    The unit is that of a word or a name beside the brackets, and would not be what they say.
    """
    for found in IN_BRACKETS.findall(title.text):
        inner = "".join(filter(None, found)).strip()
        if (
            not inner
            or (title.unit and inner in title.unit.text)
            or QUALIFIER.fullmatch(inner)
            or _is_name(inner)
        ):
            continue
        unit = _unit_of(inner)
        if not (unit and title.unit and is_same(unit, title.unit)):
            of = quote(title.unit.text) if title.unit else "a unit of light"
            problem = f"'{quote(inner)}' in the title '{quote(title.text)}' is not {of}"
            raise UnitError(f"{problem}, and no known remark", "the unit in brackets, or none")


def _is_name(text: str) -> bool:
    folded = comparable(text)
    return folded in index().names or folded in index().misnomers


def unit_in(text: str, like: Unit | None = None, at_end: bool = False) -> Unit | None:
    """Return the unit in a title, or only at its end, ignoring the rest; None if there is none."""
    title = _read(text, like)
    is_there = not at_end or title.in_brackets or title.closing >= len(text.rstrip())
    return title.unit if is_there else None


def refuse_altered(title: Title) -> None:
    """Raise for a title whose numbers are not the values of the quantity in its unit.

    That is a title that scales them, as `E [lx] x1000`, names a function of them, as `log E [lx]`,
    or has a second unit, as `E [W/m2] or [lx]`.
    """
    text, unit = title.text, title.unit
    before, after = text[: title.start], text[title.end :]
    masked = NO_SCALE.sub(" ", f"{before}{HERE}{after}" if unit else text)
    hint = f"numbers in {quote(unit.text)}" if unit else "numbers in their unit"
    in_parts = unit and len(unit.atoms) > 1 and any(name in PARTS for name, _ in unit.atoms)
    if in_parts or FACTOR.search(masked) or (unit and SCALED_BEFORE.search(before)):
        raise UnitError(f"the title '{quote(text)}' scales its numbers", f"{hint} without a factor")
    if FUNCTION.search(masked):
        raise UnitError(f"the title '{quote(text)}' has a function of its numbers", hint)
    if unit and (other_unit := _other_unit(f"{before} {after}", unit)):
        units = f"{quote(unit.text)} and {quote(other_unit.text)}"
        raise UnitError(f"the title '{quote(text)}' has two units, {units}", "only one of them")


def refuse_misnamed(title: Title, unit: Unit) -> None:
    """Raise for a title that names a quantity that the unit of its numbers does not measure.

    Examples are `illuminance [cd/m2]`, and `PPFD (desk) 1` above numbers in lux.
    """
    if other := other_quantity(title.name, unit):
        raise UnitError(
            f"the title '{quote(title.text)}' names {other.name('en')}, not {describe(unit)}",
            f"a unit of {other.name('en')} in the title, such as {other.unit}, or another name",
        )


def refuse_unknown(title: Title, typed: Unit | None = None) -> None:
    """Raise for a title that has no unit of light, but an unknown one or that of a detector.

    Examples are `E (ftcd)`, `Light (counts)` and `mV`.  Another spelling of the typed unit fits.
    """
    if title.unit and read(title.unit):
        return
    text = title.text
    other = title.unit or (None if unit_of_name(text) else unit_of(text))
    is_other = other is not None and (title.unit or sum(map(str.isalpha, text)) > 1)
    detected = OF_DETECTOR.search(text)
    is_bare = not (typed and title.in_brackets)  # of RH (%) too, if --unit is another one
    is_number = other is not None and other.dimension == NUMBER and is_bare
    if (is_other and other and not read(other) and not is_number) or detected:
        what = quote(detected[0] if detected else other.text if other else "")
        problem = f"the title '{quote(text)}' has numbers in {what}, not in a unit of light"
        raise UnitError(problem, "another column, or calibrated values")
    if word := _unknown_unit(text):
        usual = SPELLINGS.get(_folded(word), "")
        if not (typed and usual and is_same(resolve(usual), typed)):
            raise UnitError(
                f"unknown unit '{quote(word)}' in the title '{quote(text)}'",
                usual or "a title with a unit of radcalc units, or without one",
            )


def refuse_uncalibrated(title: Title) -> None:
    """Raise for a title with a unit or a name of light beside words of a detector, or of a share.

    Examples are `lux raw counts` and `PAR [a.u.]`; a unit in brackets is that of the numbers.
    """
    word = OF_DETECTOR.search(title.text) or RELATIVE.search(title.text)
    if (word and not title.in_brackets) or (word and title.unit is None):
        problem = f"'{quote(word[0])}' in the title '{quote(title.text)}' is no unit of light"
        raise UnitError(problem, "another column, or calibrated values")


def words_of(title: str) -> list[str]:
    """Return the words of a title in lower case, also those between underscores."""
    return plain(title).replace("_", " ").split()


def refuse_linked(title: str, unit: Unit, given: Collection[str], hint: str = "") -> None:
    """Raise for inputs that link kinds of light, if the light of a title is another one.

    That of a spectrum is no UVA; PAR in watts needs the range that it is counted over.
    """
    links = [name for name in LINKS if name in given]
    words = words_of(title)
    light = read(unit)
    is_known = light is not None and light.kind in WEIGHTS
    if (
        links
        and not is_known
        and (band := next((word for word in words if word in OTHER_LIGHT), ""))
    ):
        problem = f"the values are of another light by their title ({band})"
        problem = f"{problem}, which {option(links[0])} does not convert"
        raise UsageError(problem, hint or leave_out(links[0]))
    is_par = not {word.rstrip("0123456789") for word in words}.isdisjoint(NAMES_OF_PAR)
    is_par = is_par or "photosynthetic" in title.lower()
    is_of_watts = light is not None and light.kind == RADIANT
    if is_par and is_of_watts and "spectrum" in given and "range" not in given:
        problem = "the values are PAR in watts, which are counted from 400 nm to 700 nm"
        raise MissingInput(problem, computed(add("range", PAR_RANGE)))


def unit_of_meter(text: str) -> Unit | None:
    """Return the unit in a cell of its own, also in a spelling of meters; None for other texts."""
    return _unit_of(text) or unit_of(SPELLINGS.get(_folded(text), ""))


def _folded(text: str) -> str:
    return re.sub(r"[\s.^_-]", "", plain(text)).replace("²", "2")


def _unknown_unit(text: str) -> str:
    """Return the text in a title that is probably meant as a unit; its unit is unknown."""
    if _folded(bare := text.strip(" ()[]")) in SPELLINGS:
        return bare
    brackets = ["".join(filter(None, found)).strip() for found in IN_BRACKETS.findall(text)]
    for inner in reversed(brackets):
        if _folded(inner) in SPELLINGS:
            return inner
        if UNIT_LIKE.fullmatch(inner) and not QUALIFIER.fullmatch(inner) and not unit_of(inner):
            return inner
    found = PER_AREA.search(text)
    return found[0] if found else ""


def other_quantity(name: str, unit: Unit) -> Quantity | None:
    """Return the quantity with that name if a unit of light measures another one, else None.

    Unknown names, names with additional words, and units of other quantities than light fit.
    """
    words = [word.rstrip("0123456789") for word in comparable(IN_BRACKETS.sub(" ", name)).split()]
    folded = " ".join(filter(None, words))
    named = index().names.get(folded, [])
    symbols = index().misnomers.get(folded, {}) if named else {}
    if folded in (*PHOTON_IRRADIANCES, *PHOTONS):
        symbols = {"E_p": "", "Q_p": ""} if folded in PHOTONS else {"E_p": ""}
    if folded in SOLAR:
        symbols = {"E_e": "", "H_e": ""}
    named = [*named, *(quantity for quantity in QUANTITIES if quantity.symbol in symbols)]
    readings = [read(candidate) for candidate in (unit, *getattr(unit, "others", ()))]
    if not named or any(
        reading is None or _is_called(folded, quantity, reading)
        for reading in readings
        for quantity in named
    ):
        return None
    return named[0]


def _is_called(name: str, quantity: Quantity, reading: Reading) -> bool:
    usual = read(resolve(quantity.unit))
    if usual is None:
        return False
    if usual.retinal:  # retinal illuminance is also given in lux
        return reading.retinal or (reading.kind, reading.geometry) == (usual.kind, (0, 1, 0))
    return (
        (usual.kind == reading.kind or name in GENERIC)
        and (usual.geometry == reading.geometry or name in PHOTONS)
        and not reading.retinal
        and (usual.axis == NONE or reading.axis != NONE)  # irradiance, per wavelength
    )


def _read(text: str, like: Unit | None) -> Title:
    """Return the title with its likeliest unit, if any."""
    masked = _without_places(text) if len(text) <= LONGEST else ""
    candidates = list(_candidates(masked))
    for is_fitting in (_fits, _contradicts):
        longer: list[Title] = []  # units that contain shorter ones: the s in umol_m2_s
        for title, in_brackets in candidates:
            if any(
                long_title.start <= title.start and title.end <= long_title.end
                for long_title in longer
            ):
                continue
            if is_fitting(title, in_brackets, like):
                name = _name(text, title.opening, title.closing)
                return title._replace(text=text, name=name, unit=_in_its_kind(title.unit, name))
            if _contradicts(title, in_brackets, like) and not in_brackets:
                longer.append(title)
    return Title(text, text)


def _in_its_kind(unit: Unit | None, name: str) -> Unit | None:
    """Return the unit of a title in the weighted kind that its words name: melanopic EDI [lx]."""
    words = re.findall(r"[^\W_]+", name.lower())
    kinds = {OF_WEIGHTS[word] for word in words if word in OF_WEIGHTS}
    if EDI in words:
        kinds = kinds or {OF_WEIGHTS["melanopic"]}
    if unit is None or unit.is_scale or len(kinds) != 1 or read(unit) is None:
        return unit
    return weighted(unit, *kinds)


def _without_places(text: str) -> str:
    """Return a title with blanks for places after a name or a unit of light: PAR (in), Lux (min).

    They are also units: hours, seconds, minutes and inches.
    """
    if OF_PVGIS.fullmatch(text.strip()):
        return ""
    place = PLACE.search(text)
    before = text[: place.start()] if place else ""
    if place and (unit_of_name(before) or any(_fits(*one, None) for one in _candidates(before))):
        return before + " " * len(place[0]) + text[place.end() :]
    return text


def _other_unit(text: str, unit: Unit) -> Unit | None:
    """Return a unit in the rest of a title that is surely meant as a second unit, or None."""
    for variant in (text, BRACKETS.sub(" ", text)):
        for title, in_brackets in _candidates(variant):
            other = title.unit
            if other is None or is_same(other, unit) or IN.fullmatch(other.text):
                continue
            is_symbol = sum(map(str.isalpha, other.text)) < 2 or other.is_scale  # E1, (W)
            if is_symbol and not (in_brackets and _measure(other) == _measure(unit)):
                continue
            if _measure(other) == _measure(unit) or _contradicts(title, False, None):
                return other
    return None


def is_same(first: Unit, second: Unit) -> bool:
    """Return whether two units have the same values: lux, lx and lm/m2."""
    if first.is_scale or second.is_scale:
        return scale_of(first) == scale_of(second)
    return (
        _measure(first) == _measure(second)
        and first.top * second.bottom == second.top * first.bottom
    )


def find(titles: Sequence[str], name: str, where: str, like: Unit | None = None) -> int:
    """Return the place of the column with a name.

    The name is a whole title, a title without its unit, or either without regard to case; the first
    of these forms that matches decides.  Other numbers count columns from 1.
    """
    name = name.strip()
    places = [place for place, title in enumerate(titles) if title == name]
    number = int(name[:9]) if name.isascii() and name.isdecimal() else None
    if not places:
        places = _similar(titles, name, like)
        if number and number <= len(titles) and number - 1 not in places:
            places = sorted([*places, number - 1])
    if len(places) == 1:
        return places[0]
    if places:
        several = [f"{quote(titles[k])} (field {k + 1})" for k in places[:COMPARED]]
        raise UsageError(
            f"{where} has the column '{quote(name)}' {len(places)} times", listed(several)
        )
    known_titles = [title for title in titles[:COMPARED] if title]
    likely = nearest(name, known_titles) or known_titles
    hint = listed(likely, "; ") or "a title for each column"
    if len(likely) > 1:
        hint = f"one of the titles: {hint}"
    if number is not None:
        hint = f"from 1 to {len(titles)}"
        hint += f", or one of the titles: {listed(known_titles, '; ')}" if known_titles else ""
    raise UsageError(f"{where} has no column '{quote(name)}'", hint)


def _similar(titles: Sequence[str], name: str, like: Unit | None) -> list[int]:
    folded = name.casefold()
    near = [(k, title) for k, title in enumerate(titles) if folded in title.casefold()]
    bare = [(k, title, _read(title, like).name) for k, title in near[:COMPARED]]
    return (
        [k for k, _, bare_name in bare if bare_name == name]
        or [k for k, title, _ in bare if title.casefold() == folded]
        or [k for k, _, bare_name in bare if bare_name.casefold() == folded]
    )


def _candidates(text: str) -> Iterator[tuple[Title, bool]]:
    """Return each part of a title that is a unit, and whether it is in brackets."""
    for match in [*IN_BRACKETS.finditer(text)][::-1]:
        inner = match[1] if match[1] is not None else match[2]
        start = match.start() + 1
        preamble = PREAMBLE.match(inner)
        for before in (0, preamble.end() if preamble else 0):
            if title := _title(text, match.start(), start + before, match.end() - 1, match.end()):
                yield title, True
                break
    words = [word.span() for word in WORD.finditer(text)]
    for count in range(min(len(words), MOST_WORDS), 0, -1):
        for first in range(len(words) - count, -1, -1):  # the last first
            start, end = words[first][0], words[first + count - 1][1]
            if count > 1 and BETWEEN.search(text, start, end):
                continue
            if numbered := NUMBERED.fullmatch(text, start, end):
                unit = unit_of(numbered[1])
                end = numbered.end(1) if unit and read(unit) else end
            if title := _title(text, start, start, end, end):
                yield title, False
    if divided := QUANTITY_OVER_UNIT.fullmatch(text):
        head = unit_of(text[: text.index("/")].strip())
        is_ratio = head is not None and len(head.text) > 1 and read(head) is not None
        start, end = divided.span(1)
        if not is_ratio and (title := _title(text, start, start, end, end)):
            yield title, False


def _title(text: str, opening: int, start: int, end: int, closing: int) -> Title | None:
    inner = text[start:end]
    start += len(inner) - len(inner.lstrip())
    inner = inner.strip()
    if DIRECT_NORMAL in inner:
        return None
    unit = find_scale(inner) or _unit_of(inner) or _of_words(inner)
    if unit is None:
        return None
    if text[opening - 1 : opening] == '"' == text[closing : closing + 1]:
        opening, closing = opening - 1, closing + 1
    before = IN.sub("", text[:opening].rstrip(AROUND)).rstrip(AROUND)
    name = _name(text, len(before), closing)
    return Title(text, name, unit, len(before), start, start + len(inner), closing)


def _name(text: str, opening: int, closing: int) -> str:
    """Return the text of a title around its unit."""
    return " ".join(filter(None, [text[:opening], text[closing:].strip(AROUND)]))


def _of_words(text: str) -> Unit | None:
    """Return the unit of umol_m2_s or umol_m-2_s-1, which programs write for umol/m2/s."""
    words = text.split("_")
    if len(words) < 2 or not all(word[:1].isalpha() for word in words):
        return None
    return unit_of(" ".join(words) if "-" in text else "/".join(words))


def _unit_of(text: str) -> Unit | None:
    """Return the unit of a text, which is W/m2 for Wm2; None for other texts."""
    unit = unit_of(text)
    if _folded(text) not in WATTS:
        return unit
    watts = resolve("W/m2")
    return unit if unit and unit.dimension == watts.dimension else watts


def _fits(title: Title, in_brackets: bool, like: Unit | None) -> bool:
    unit = title.unit
    if unit is None or like is None:
        return _contradicts(title, in_brackets, like) and unit is not None and _is_light(unit)
    readings = {_measure(reading) for reading in (unit, *getattr(unit, "others", ()))}
    return any(_measure(reading) in readings for reading in (like, *getattr(like, "others", ())))


def _contradicts(title: Title, in_brackets: bool, like: Unit | None) -> bool:
    """Return whether the text is surely meant as a unit, of any quantity."""
    unit = title.unit
    if unit is None or in_brackets:
        return unit is not None
    is_word = sum(map(str.isalpha, unit.text)) > 1 and unit.text not in SUBSCRIPTS
    is_word = is_word and not (title.name and "magnitude" in unit.text.lower())  # of a vector
    is_word = is_word and not SYMBOL.match(unit.text)
    if len(unit.atoms) == 1 and unit.atoms[0][0].startswith(RARE):  # RW, a coordinate
        return False
    is_name_of_kind = len(unit.atoms) == 1 and unit.atoms[0][0] == "photon"  # photon irradiance
    return is_word and not is_name_of_kind and _is_light(unit)


def _is_light(unit: Unit) -> bool:
    return read(unit) is not None


def unit_of_name(title: str) -> str:
    """Return the unit that goes without a word with the name in a title: PPFD, GHI; else ''."""
    if OF_PVGIS.fullmatch(title.strip()):
        return light_unit("irradiance", RADIANT)
    words = {*words_of(title)}
    names = ((PPFD, light_unit("irradiance", PHOTON)), (SOLAR, light_unit("irradiance", RADIANT)))
    return next((unit for known, unit in names if not words.isdisjoint(known)), "")


def _measure(unit: Unit) -> tuple[object, bool]:
    return unit.dimension, unit.is_exitance
