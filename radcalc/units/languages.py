"""Other spellings of units: names in Czech and Russian, and symbols that are written together.

A text that is not a unit is translated into English word by word (`5 килолюксов`, `lumen na metr
čtvereční`), in the cases used after numbers and `per`, and read again.  Case and diacritics do not
matter.

The spellings of a definition in `light.txt` are its symbols, its names, and their plurals.
"""

import re
import unicodedata

from radcalc.errors import nearest
from radcalc.tuples import NamedTuple
from radcalc.units import takes
from radcalc.units.compiled import PREFIX_SYMBOLS, SYMBOLS
from radcalc.units.grammar import DIVIDERS, divides, plain
from radcalc.units.numbers import LONGEST_SYMBOL

TYPE_CHECKING = False  # typing is slow to import
if TYPE_CHECKING:
    from collections.abc import Callable

    from radcalc.units import Unit

# The endings of a declension, singular and plural; _ is an empty ending.
CZECH_ENDINGS = {
    "m": "_ u e y ů em ům ech",  # lux, also metr
    "f": "a y u e ě ou _ ám ách ami",  # kandela
}
RUSSIAN_ENDINGS = {
    "m": "_ а у ом е ы ов ам ами ах",  # люкс
    "c": "_ а у ем е ы ев ам ами ах",  # герц
    "ь": "ь я ю ем е и ей ям ями ях",  # джоуль
    "f": "а ы у е ой _ ам ами ах",  # кандела
    "я": "я и ю е ей й ям ями ях",  # калория, without the stem's и
}
# English name, Czech names, Russian names: a stem and its declension, or all forms.  English names
# with two values are included, so that their translations are refused with both values as well.
NAMES = (
    ("metre", "metr m", "метр m"),
    ("gram", "gram m", "грамм m"),
    ("second", "sekund f, vteřin f, sek", "секунд f"),
    ("kelvin", "kelvin m", "кельвин m"),
    ("radian", "radián m", "радиан m"),
    ("photon", "foton m", "фотон m"),
    ("candela", "kandel f", "кандел f"),
    ("troland", "troland m", "троланд m"),
    ("percent", "procento procenta procent procentech", "процент m"),
    ("angstrom", "angström m", "ангстрем m"),
    ("micron", "mikron m", "микрон m"),
    ("inch", "palec palce palců palcích palcem", "дюйм m"),
    ("foot", "stopa stopy stopu stopě stopou stopách", "фут m"),  # stop is a step of exposure
    ("yard", "yard m", "ярд m"),
    ("mile", "míle mílí mílích", "миля мили миль милю милях"),
    ("hectare", "hektar m", "гектар m"),
    ("litre", "litr m", "литр m"),
    ("minute", "minut f", "минут f"),
    ("hour", "hodin f, hod", "час m"),
    ("day", "den dne dny dnů dní dnech", "день дня дню дни дней днях, сутки суток"),
    ("week", "týden týdne týdny týdnů týdnech", "неделя недели недель неделю неделе"),
    ("julian_year", "rok m, roků roky let", "год m, лет"),
    ("degree", "stupeň stupně stupňů stupních stupněm", "градус m"),
    ("turn", "otáčk f, otáček", "оборот m"),
    ("steradian", "steradián m", "стерадиан m"),
    ("pound", "libr f, liber", "фунт m"),
    ("tonne", "tun f", "тонн f"),
    ("hertz", "hertz m", "герц c"),
    ("joule", "joul m, joule", "джоул ь"),
    ("watt", "watt m", "ватт m, вт"),
    ("ampere", "ampér m", "ампер m"),
    ("volt", "volt m", "вольт m"),
    ("erg", "erg m", "эрг m"),
    ("electronvolt", "elektronvolt m", "электронвольт m"),
    ("watt_hour", "watthodin f", "ваттчас m"),
    ("watt_second", "wattsekund f", "ваттсекунд f"),
    ("calorie", "kalorie kalorií kalorii", "калори я"),
    ("jansky", "jansky", "янский янского янских"),
    ("lumen", "lumen m", "люмен m"),
    ("lux", "lux m", "люкс m"),
    ("candle", "svíčk f, svíček", "свеча свечи свечей свечу свечах"),
    ("phot", "fot m", "фот m"),
    ("footcandle", "footkandel f", "футкандел f, футсвеча футсвечи футсвечей"),
    ("lux_second", "luxsekund f", "люкссекунд f"),
    ("lux_hour", "luxhodin f", "люксчас m"),
    ("nox", "nox m", "нокс m"),
    ("nit", "nit m", "нит m"),
    ("stilb", "stilb m", "стильб m"),
    ("apostilb", "apostilb m", "апостильб m"),
    ("skot", "skot m", "скот m"),
    ("lambert", "lambert m", "ламберт m"),
    ("footlambert", "footlambert m", "футламберт m"),
    ("lumen_second", "lumensekund f", "люменсекунд f"),
    ("lumen_hour", "lumenhodin f", "люменчас m"),
    ("talbot", "talbot m", "тальбот m"),
    ("mole", "mol m", "мол ь"),
    ("einstein", "einstein m", "эйнштейн m"),
    ("rayleigh", "rayleigh m", "рэлей рэлея рэлеев рэлеях"),
    ("parsec", "parsek m", "парсек m"),
)
PREFIXES = (
    "quetta ronna yotta zetta exa peta tera giga mega kilo hecto deca deci centi milli micro nano "
    "pico femto atto zepto yocto ronto quecto",
    "quetta ronna yotta zetta exa peta tera giga mega kilo hekto deka deci centi mili mikro nano "
    "piko femto atto zepto yokto ronto quecto",
    "кветта ронна йотта зетта экса пета тера гига мега кило гекто дека деци санти милли микро нано "
    "пико фемто атто зепто йокто ронто квекто",
)
POWER = r"\^?[-\u2212\u207b]?[\d\u00b9\u00b2\u00b3\u2070-\u2079]+"
RUN = rf"[^\W\d_]+(?:{POWER}[^\W\d_]+)*(?:{POWER})?"  # one way to match it: titles may be long
JOINED = re.compile(rf"({RUN})(?:/({RUN}))?")
PARTS = re.compile(r"([^\W\d_]+)([^\w]*[\d\u00b9\u00b2\u00b3\u2070-\u2079]*)")
DIFFERENCE = re.compile(r"[-\u2212]\d+[^\W\d_]+$")  # the end of 5m-2cm
LONGEST = 30  # characters of a text
ENOUGH = 2  # readings that make a text ambiguous
PHOTONS = re.compile(r"(mol|moles?)[ .·*(]*(?:photons?|quanta)\b\)?", re.IGNORECASE)
HYPHEN = re.compile(r"(?<=[^\W_])-(?=[^\W\d_])")  # W/m2-sr, lm-hr
SQUARE, CUBIC = ("ctverecn", "квадратн"), ("krychlov", "kubick", "кубическ")  # without endings


def bare(text: str) -> str:
    """Return a text without case and diacritics."""
    parts = unicodedata.normalize("NFKD", text).casefold()
    return "".join([c for c in parts if not unicodedata.combining(c)])


def comparable(word: str) -> str:
    """Return a word without case, diacritics and hyphens."""
    return bare(word).replace("-", "")


def forms(names: str, endings: dict[str, str]) -> list[str]:
    """Return all forms of the names of a unit."""
    words = []
    for name in names.split(", "):
        stem, *unit_words = comparable(name).split()
        if len(unit_words) == 1 and unit_words[0] in endings:
            words += [
                stem + ending.strip("_") for ending in comparable(endings[unit_words[0]]).split()
            ]
        else:
            words += [stem, *unit_words]
    return words


def _words(place: int, endings: dict[str, str]) -> tuple[dict[str, str], dict[str, str]]:
    prefixes = zip(map(comparable, PREFIXES[place].split()), PREFIXES[0].split(), strict=True)
    units = {form: row[0] for row in NAMES for form in forms(row[place], endings)}
    return dict(prefixes), units


LANGUAGES = (_words(1, CZECH_ENDINGS), _words(2, RUSSIAN_ENDINGS))


def near(word: str) -> list[str]:
    """Return the known names, without diacritics, that are most similar to an unknown word."""
    return nearest(comparable(word), [form for _, units in LANGUAGES for form in units], 2, 0.7)


def in_english(text: str, unit_of: "Callable[[str], Unit | None]") -> str:
    """Return a unit's text with its Czech and Russian words in English; '' if it has none.

    A word between two units divides, or not, by what `unit_of` reads in both.
    """
    text = unicodedata.normalize("NFC", text).replace("кв.", "квадратный ").removesuffix(".")
    pieces = _pieces(" ".join(text.split()))
    words: list[str] = []
    for place, piece in enumerate(pieces):
        if not piece[0].isalpha():
            words.append(piece)
        elif power := _power(piece):
            before, behind = _has_unit(pieces, place, -1), _has_unit(pieces, place, 1)
            if before and behind:  # ambiguous: it may belong to either
                return ""
            if before:  # metr čtvereční
                words[-2:] = [power, " ", words[-2]]
            else:
                words.append(power)
        elif place and comparable(piece) in DIVIDERS:
            rest = "".join(pieces[place + 1 :]).strip()
            divisor, *_ = (in_english(rest, unit_of) or rest).partition(" per ")
            over, under = unit_of("".join(words).strip()), unit_of(divisor)
            words.append("per" if divides(comparable(piece), over, under) else piece)
        else:
            words.append(_unit(piece) or piece)
    return "".join(words) if words != pieces else ""


def _pieces(text: str) -> list[str]:
    pieces: list[str] = []
    inside = False
    for c in text:
        is_part = c.isalpha() or (c == "-" and inside)
        if is_part and inside:
            pieces[-1] += c
        else:
            pieces.append(c)
        inside = is_part
    return pieces


def _unit(word: str) -> str:
    word = comparable(word)
    for prefixes, units in LANGUAGES:
        if word in units:
            return units[word]
        for prefix, english in prefixes.items():
            if word.startswith(prefix) and (unit := units.get(word[len(prefix) :])):
                return english + unit
    return ""


def _power(word: str) -> str:
    word = comparable(word)
    return "square" if word.startswith(SQUARE) else "cubic" if word.startswith(CUBIC) else ""


def _has_unit(pieces: list[str], place: int, side: int) -> bool:
    """Return whether a unit is next to a word, separated from it by one blank only."""
    at = place + 2 * side
    if not 0 <= at < len(pieces) or pieces[place + side] != " ":
        return False
    return (
        pieces[at].isalpha() and comparable(pieces[at]) not in DIVIDERS and not _power(pieces[at])
    )


def apart(text: str) -> list[str]:
    """Return the texts with signs between units that are written together: Wm-2, Js-1, J/kgK.

    A product below a solidus is all below it, so W/m2sr is W/(m2.sr).  There are up to two texts,
    as for lmm-2; none for another text.
    """
    text = plain(text)
    match = JOINED.fullmatch(text) if len(text) <= LONGEST else None
    if match is None or text.isalpha() or DIFFERENCE.search(text):
        return []
    over = _products(match[1])
    under = _products(match[2]) if match[2] else [""]
    return [f"{a}/({b})" if "." in b else f"{a}/{b}" if b else a for a in over for b in under][
        :ENOUGH
    ]


def _products(run: str) -> list[str]:
    """Return the products of symbols that a run of letters and exponents may be."""
    found = [""]
    for letters, exponent in PARTS.findall(run):
        splits = [letters] if _is_symbol(letters) else _splits(letters)
        found = [
            f"{before}.{split}{exponent}".removeprefix(".") for before in found for split in splits
        ][:ENOUGH]
    return found


def _splits(letters: str) -> list[str]:
    """Return the ways to write letters as symbols with points between them."""
    found = []
    for end in range(1, len(letters)):
        if _is_symbol(letters[:end]):
            rest = letters[end:]
            rests = [rest] if _is_symbol(rest) else _splits(rest)
            found += [f"{letters[:end]}.{other}" for other in rests]
    return found[:ENOUGH]


def _is_symbol(text: str) -> bool:
    if text in SYMBOLS:
        return True
    return any(
        text[:size] in PREFIX_SYMBOLS and text[size:] in SYMBOLS and takes(text[:size], text[size:])
        for size in (1, 2)
    )


def without_photons(text: str) -> str:
    """Return a text whose moles are not said to be of photons: umol m-2 s-1."""
    return PHOTONS.sub(r"\1", text)


def without_hyphens(text: str) -> str:
    """Return a unit with `per` and signs in place of hyphens: W/m2/sr for W/m2-sr."""
    if "-per-" in text:
        return text.replace("-", " ")
    over, solidus, under = text.partition("/")
    return HYPHEN.sub(".", over) + solidus + HYPHEN.sub("/", under)


class Definition(NamedTuple):
    """One unit of `light.txt`."""

    name: str
    value: str
    symbols: tuple[str, ...]
    names: tuple[str, ...]
    prefixes: tuple[str, ...]
    note: str
    source: str
    letters: tuple[str, ...]


def is_name(word: str) -> bool:
    """Return whether an alias is a full name (any case, a plural) rather than a symbol."""
    inside = word.replace("_", "").isalnum() and word.islower() and word.isascii()
    return len(word) > LONGEST_SYMBOL and inside and word[0].isalpha()


def definition(
    name: str,
    value: str,
    aliases: list[str],
    marks: dict[str, list[str]],
    prefix_symbols: dict[str, str],
) -> Definition:
    """Return the definition of a unit from the fields of its row, with its plurals."""
    symbol, rest = (aliases[0], aliases[1:]) if aliases else ("_", [])
    symbols = [a for a in [symbol, *rest] if a != "_" and not (a in rest and is_name(a))]
    names = [name, *(a for a in rest if is_name(a))]
    countable = [] if "$" in marks else names
    plurals = [n + "s" for n in countable if n[-1].isalpha() and not n.endswith(("s", "x", "ch"))]
    allowed = " ".join(marks.get("~", [])).split()
    if "all" in allowed:
        prefixes = dict.fromkeys(prefix_symbols.values())
    else:
        prefixes = dict.fromkeys(prefix_symbols[p] for p in allowed)
    return Definition(
        name,
        value,
        tuple(symbols),
        tuple(dict.fromkeys(names + plurals)),
        tuple(prefixes),
        " ".join(marks.get("!", [])),
        " ".join(marks.get(":", [])),
        tuple(" ".join(marks.get("$", [])).split()),
    )
