"""The compiled units at run time: text to a unit, spellings to suggestions.

Factors are exact ratios of whole numbers, so the factor between any two units is rounded once.

Words of growers stand for a unit: ppfd, ppf and dli.  They are quantities, in place of a unit:
700 ppfd is 700 umol/m2/s of the photons from 400 nm to 700 nm.
"""

from radcalc import errors
from radcalc.errors import Try, UnitError, ambiguous, command, corrections, quote
from radcalc.units import (
    COUNT_AT,
    CYCLE_AT,
    INVERSE_LENGTH,
    LENGTH_ALONE,
    LUMINOSITY_AT,
    LUMINOUS_AND_COUNTED,
    MASS_AT,
    NUMBER,
    OWN,
    TIME_AT,
    Daily,
    Dimension,
    Photosynthetic,
    Unit,
    lookup,
    multiple,
    read_own,
    single,
    takes,
)
from radcalc.units.compiled import (
    NAMES,
    NOTES,
    PREFIX_NAMES,
    PREFIX_SYMBOLS,
    REFUSED,
    SYMBOLS,
    UNITS,
)
from radcalc.units.grammar import NAMED, parse_unit
from radcalc.units.numbers import times

# Spellings of a degree of an offset scale, which is a kelvin in a product.
CELSIUS = ("°c", "celsius", "centigrade", "degc", "deg_c", "degree_celsius", "degrees_celsius")
FAHRENHEIT = ("°f", "degf", "deg_f", "degree_fahrenheit", "degrees_fahrenheit", "fahrenheit")
COMMON_PREFIXES = "GMkcmun"
SUGGESTED = 3  # spellings near an unknown one
# Names of scales; they are handled above and not looked up in other languages.
SCALE_NAMES = ("dBm", "dBW", "dBu", "mag", "ABmag", "EV", "mired", "OD", "stops", "dB", "bril")
WHOLES = ("hemisphere", "spat")  # an irradiance is not a radiance times one of these
PARTS = ("percent", "permille", "ppm", "ppb")


def resolve(text: str) -> Unit:
    """Return the unit of a text; for other texts, raise UnitError with the nearest names."""
    unit = _read(text)
    if isinstance(unit, str):
        raise _unknown(unit)
    return unit


def unit_of(text: str) -> Unit | None:
    """Return the unit of a text, or None; cheaper than `resolve`, which computes suggestions."""
    try:
        unit = _read(text) if text else None
    except errors.RadcalcError:
        return None
    return None if isinstance(unit, str) else unit


def _read(text: str) -> Unit | str:
    """Return the unit of a text, or the unknown spelling in it; raise for any other problem."""
    if simple := single(text):
        return simple
    text = " ".join(text.split())  # shown as typed, with single blanks
    if named := _named_in_words(text) or ("mol" in text.lower() and _of_photons(text)):
        return named
    try:
        parsed = parse_unit(text)
    except errors.UnitError:
        if unit := _in_other_words(text):
            return unit
        raise
    unit = Unit(text, 1, 1, NUMBER, ())
    loose, inverted, is_light = "", 0, False
    for spelling, exponent, below in parsed:
        if spelling == "1":
            continue
        entry = lookup(spelling) or _degree(spelling, unit, len(parsed) == exponent == 1)
        if entry is None:
            return spelling if spelling in SCALE_NAMES else _in_other_words(text) or spelling
        powers = _multiply(unit, *entry, exponent)
        if powers == LENGTH_ALONE and exponent == 1:
            inverted += below
            loose = "" if below else spelling
        is_light = is_light or _counts_light(powers)
    if " " in text:
        _refuse_side_by_side(text)
        if len(parsed) == 2:
            _refuse_minus(unit, spelling)
    if is_light:
        _check_light(unit, loose)
    _keep_own(unit)
    return _as_wavenumber(unit, inverted)


def _keep_own(unit: Unit) -> None:
    """Keep the notes on the units of a user's definitions in a unit that is read."""
    for atom, _ in unit.atoms if OWN else ():
        _, name = lookup(atom) or ("", atom)
        read_own(name)
        read_own(name.partition("_")[0])  # a weight, of W_NAME


def _named_in_words(text: str) -> Unit | None:
    """Return the unit of a name of several words, as foot lambert; None for other texts."""
    joined = text.lower().replace(" ", "_")
    if " " not in text or joined not in NAMES:
        return None
    unit = resolve(joined)
    unit.text = text
    return unit


def _degree(spelling: str, unit: Unit, is_alone: bool) -> tuple[str, str] | None:
    """Return a kelvin for a degree Celsius in a product; None for other spellings."""
    if is_alone or spelling.lower().replace("-", "_") not in CELSIUS:
        return None
    unit.notes += (f"{quote(spelling)} in a product counts a difference, in kelvins",)
    return "", "kelvin"


def _refuse_side_by_side(text: str) -> None:
    """Raise for ft m and % lx: a blank there is more likely a conversion than a product."""
    first, *others = text.split(" ")
    for second in others:
        is_power = not all(part.isalpha() or part in NAMED for part in (first, second))
        one, other = (None, None) if is_power else (unit_of(first), unit_of(second))
        if one and other and one.dimension in (other.dimension, NUMBER):
            of_one = "two of one quantity" if any(one.dimension) else "a part of another"
            problem = f"the unit '{quote(text)}' has {of_one} side by side"
            product = errors.correct(f"{first} {second}", f"{first}*{second}", remark="a product")
            raise errors.UnitError(problem, [product])
        first = second


def _refuse_minus(unit: Unit, last: str) -> None:
    """Raise for m-1 m: the minus may be a subtraction or the sign of an exponent."""
    exponents = [exponent for _, exponent in unit.atoms]
    if exponents[1:] == [1] and unit.text.startswith(f"{last}-"):
        hint = f"blanks around a minus, or {quote(last)}^{exponents[0]} for a power"
        raise errors.UnitError(errors.ambiguous(unit.text, "a subtraction or a power"), hint)


def _multiply(unit: Unit, prefix: str, name: str, exponent: int) -> Dimension:
    """Multiply a unit by the power of a named unit; return the exponents of the latter."""
    if name in PARTS and exponent not in (1, -1):  # %2: it may belong to the number as well
        hint = "brackets around the number with it, as in (50%)^2"
        raise errors.UnitError(f"'{quote(unit.text)}' is a power of {name}", hint)
    top, bottom, powers = multiple(prefix, name)
    if exponent < 0:
        top, bottom = bottom, top
    size = abs(exponent)
    unit.top = times(unit.top, top, size)
    unit.bottom = times(unit.bottom, bottom, size)
    unit.dimension = tuple([a + exponent * b for a, b in zip(unit.dimension, powers, strict=True)])
    unit.atoms += ((prefix + name, exponent),)
    if name in NOTES and NOTES[name] not in unit.notes:
        unit.notes += (NOTES[name],)
    return powers


def _counts_light(powers: Dimension) -> bool:
    return bool(powers[COUNT_AT] or powers[LUMINOSITY_AT] or (powers[MASS_AT] and powers[TIME_AT]))


def _check_light(unit: Unit, length: str) -> None:
    """Refuse light times a length or a whole solid angle; note a rate over a day."""
    text = unit.text
    if length and "(" not in text:  # W m, where the blank may mean a division
        per_wavenumber = _with(text, length, f"({length}-1)-1")
        ways = [
            errors.correct(text, per_wavenumber, remark="a density per wavenumber"),
            errors.correct(text, _with(text, length, f"{length}-1"), remark="per length"),
        ]
        raise errors.UnitError(f"the unit '{quote(text)}' has a length that multiplies light", ways)
    length_power, mass_power, *_ = unit.dimension
    is_on_area = length_power - 2 * mass_power == -2  # W has m2 kg
    if is_on_area and any((name, 1) in unit.atoms for name in WHOLES):
        problem = f"the unit '{quote(text)}' has a radiance times a whole solid angle"
        raise errors.UnitError(problem, f"{command('lambertian')}, for the light of a surface")
    if unit.dimension[COUNT_AT] and ("day", -1) in unit.atoms:
        unit.notes += (f"{quote(text)} is a rate over 24 h (a daily light integral is in dli)",)


def _in_other_words(text: str) -> Unit | str:
    """Return the unit of a text in another language or without signs; '' for other texts."""
    return _in_another_language(text) or _joined(text)


def _of_photons(text: str) -> Unit | None:
    """Return the unit of `umol photons m-2 s-1`, whose moles are of photons; None for others."""
    from radcalc.units.languages import without_photons

    plain = without_photons(text)
    unit = _read(plain) if plain != text else None
    if not isinstance(unit, Unit):
        return None
    unit.text = text
    return unit


def _joined(text: str) -> Unit | str:
    """Return the unit of symbols that are written together, as Wm-2; '' for other texts."""
    from radcalc.units.languages import apart, without_hyphens

    plain = without_hyphens(text)
    texts = [plain] if plain != text else apart(text)
    if len(texts) > 1:
        raise errors.UnitError(errors.ambiguous(text), errors.corrections(text, *texts))
    unit = _read(texts[0]) if texts and texts[0] != text else ""
    if isinstance(unit, str):
        return ""
    unit.text = text
    unit.notes += (f"{quote(text)} is read as {texts[0]}",)
    return unit


def _in_another_language(text: str) -> Unit | str:
    from radcalc.units.languages import in_english

    english = in_english(text, unit_of)
    unit = _read(english) if english else ""
    if isinstance(unit, str):
        if unit in REFUSED:
            raise _unknown(unit)
        return ""
    unit.text = text
    return unit


def _with(text: str, old: str, new: str) -> str:
    """Return the text of a unit with the last `old` replaced."""
    before, _, after = text.rpartition(old)
    return quote(f"{before}{new}{after}")


def _as_wavenumber(unit: Unit, inverted: int) -> Unit:
    """Read an inverse length as a wavenumber if it is alone or divides a light quantity."""
    cycles = 0
    if unit.dimension == INVERSE_LENGTH and len(unit.atoms) == 1:
        cycles, read = 1, f"{quote(unit.text)} is read as a wavenumber, in cycles per length"
    elif inverted == 1 and any(unit.dimension[i] for i in LUMINOUS_AND_COUNTED):
        cycles, read = -1, f"{quote(unit.text)} is read as a density per wavenumber"
    if cycles:
        powers = list(unit.dimension)
        powers[CYCLE_AT] += cycles
        unit.dimension = tuple(powers)
        unit.atoms = (*unit.atoms, ("cycle", cycles))
        unit.notes = (*unit.notes, read)
    return unit


def spellings() -> list[str]:
    """List every spelling without a prefix, symbols first."""
    return [*SYMBOLS, *NAMES]


def _unknown(spelling: str) -> errors.UnitError:
    """Return the error for an unknown spelling: other letter cases, prefixes or similar units."""
    typed = quote(spelling)
    name = spelling.lower().replace("-", "_")
    if name in REFUSED:
        listed = REFUSED[name]
        tries = [] if name in CELSIUS + FAHRENHEIT else errors.alternatives(spelling, listed)
        return errors.UnitError(f"'{typed}' is not accepted as a unit", listed, tries)

    from radcalc.units import scale_table

    if error := scale_table.refuse(spelling):
        return error
    folded = spelling.lower()
    same = [s for s in (*_prefixed(), *scale_table.spellings()) if s.lower() == folded]
    if same:  # those with the fewest other letters first: mW for mw
        same.sort(key=lambda s: sum(a != b for a, b in zip(s, spelling, strict=True)))
        return errors.UnitError(f"unknown unit '{typed}'", errors.corrections(spelling, *same[:3]))
    for prefixes, text in ((PREFIX_SYMBOLS, spelling), (PREFIX_NAMES, name)):
        for prefix in prefixes:
            stem = text[len(prefix) :]
            if text.startswith(prefix) and (stem in SYMBOLS or stem.lower() in NAMES):
                return errors.UnitError(
                    f"unknown unit '{typed}': the prefix {prefix} does not go before {quote(stem)}",
                    _respelt(spelling, PREFIX_SYMBOLS.get(prefix, prefix), stem),
                )
    return errors.UnitError(f"unknown unit '{typed}'", lambda: _similar(spelling))


def _similar(spelling: str) -> "errors.Hint":
    """Propose the known spellings that are like an unknown one."""
    near = suggest(spelling)
    if not near and not spelling.isascii():
        from radcalc.units import languages

        near = languages.near(spelling)
    return errors.corrections(spelling, *near) or f"{command('units')}, which lists them all"


def _respelt(typed: str, prefix: str, rest: str) -> "errors.Hint":
    """Propose the prefix in the form of its unit: kilolumen for klumen, klm for kilolm."""
    name = NAMES.get(rest.lower(), "")
    if name and prefix in UNITS[name][3]:
        return errors.correct(typed, prefix + rest.lower())
    letters = [letter for letter, full in PREFIX_SYMBOLS.items() if full == prefix]
    if rest in SYMBOLS and letters and prefix in UNITS[SYMBOLS[rest]][3]:
        return errors.correct(typed, letters[0] + rest)
    return f"{quote(rest)}, with the power of ten in the number"


def suggest(spelling: str) -> list[str]:
    """Return the known spellings nearest to an unknown one."""
    spelling = spelling[:60]
    folded = spelling.lower()
    near = errors.nearest(folded, NAMES, SUGGESTED, 0.7)
    if len(spelling) <= 4:
        near = errors.nearest(spelling, _prefixed(), SUGGESTED, 0.75) + near
    # a first letter may be a prefix, which a correction keeps: klux, not lux, for KLux
    if folded[:1] in {prefix.lower() for prefix in PREFIX_SYMBOLS}:
        near = [one for one in near if one[0].lower() == folded[0]]
    return list(dict.fromkeys(near))[:SUGGESTED]


def _prefixed() -> list[str]:
    """Return the symbols, with and without a common prefix."""
    symbols = list(SYMBOLS)
    for symbol in SYMBOLS:
        symbols += [prefix + symbol for prefix in COMMON_PREFIXES if takes(prefix, symbol)]
    return symbols


PPFD = "PPFD is the photon irradiance from 400 nm to 700 nm, usually in umol/m2/s"
PPF = "PPF is the photon flux from 400 nm to 700 nm, usually in umol/s"
DLI = "DLI is the daily light integral: the photons from 400 nm to 700 nm in a day, in mol/m2"
GROWERS_WORDS: "dict[str, tuple[str, type[Photosynthetic], str]]" = {
    "ppfd": ("umol/m2/s", Photosynthetic, PPFD),
    "ppf": ("umol/s", Photosynthetic, PPF),
    "dli": ("mol/m2", Daily, DLI),
}


PAR = ("par",)
PAR_RANGE = "400nm:700nm"  # of watts of PAR


def refuse_par(text: str) -> None:
    """Raise for PAR, which is a range of wavelengths and is measured in photons or in watts."""
    if text.strip().lower() in PAR:
        watts = Try(
            (("range", PAR_RANGE),), instead=(text, "W/m2"), remark="the watts", follow=True
        )
        raise UnitError(
            ambiguous(text, "photons (PPFD, in umol/m2/s) or watts (W/m2) from 400 nm to 700 nm"),
            [*corrections(text, "ppfd", remark="the photons"), watts],
        )


def growers_unit(word: str) -> Unit | None:
    """Return the unit that PPFD, PPF or DLI stands for, with its note; None for other words."""
    refuse_par(word)
    if word.lower() not in GROWERS_WORDS:
        return None
    text, kind, note = GROWERS_WORDS[word.lower()]
    unit = resolve(text).of_class(kind, note)
    unit.name = word
    return unit
