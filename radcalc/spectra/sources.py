"""The grammar of --spectrum: named sources, black bodies, daylight, lines, bands, files."""

import math
import os
from functools import cache

from radcalc import errors
from radcalc.errors import command, option, quote
from radcalc.files import ENDINGS
from radcalc.quantities import PHOTON, RADIANT
from radcalc.spectra import AXES, FORMS, example
from radcalc.spectra import observers as weights
from radcalc.spectra.observers import LIGHT, PLANCK, at, standard_air_wavelength
from radcalc.spectra.observers import OWN as OWN_WEIGHTS
from radcalc.spectra.spectrum import (
    LONGEST,
    SHORTEST,
    STRONGEST,
    VISIBLE,
    WEAKEST,
    WHOLE,
    BlackBody,
    Lines,
    Range,
    Spectrum,
    Table,
    integral,
    range_text,
)
from radcalc.tuples import NamedTuple
from radcalc.units import OWN as NOTES_ON_OWN
from radcalc.units import Dimension, read_own
from radcalc.units.amounts import UNCERTAIN, split_value
from radcalc.units.dimensions import ENERGY, FREQUENCY, LENGTH, TEMPERATURE
from radcalc.units.numbers import Amount
from radcalc.units.ranges import MOST, read_series
from radcalc.units.reading import read_amount
from radcalc.units.table import resolve
from radcalc.units.values import find_scale
from radcalc.units.values import value as constant

SERIES = ("blackbody", "daylight")  # kinds for which lists and ranges give several spectra
SOLAR_CONSTANT = 1366.1  # W/m2, ASTM E490
SUNS = {"AM0": "AM0", "AM1.5G": "AM1_5G", "AM1.5D": "AM1_5D"}
SPELLED = {"AM1.5": "AM1.5G", "AM15G": "AM1.5G", "AM15D": "AM1.5D"}
# Words for light, the spectrum that each is taken as, and what that is.  A word that stands for
# several spectra, or for none that is defined, is in MEANT.
_SUN = ("AM1.5G", "the sun on a tilted plane")
_WHITE, _WARM, _COOL = (
    ("LED-B3", "a white LED of 4100 K (CIE)"),
    ("LED-B1", "a warm white LED of 2700 K (CIE)"),
    ("LED-B5", "a cool white LED of 6600 K (CIE)"),
)
_LAMP = ("A", "a tungsten lamp of 2856 K (CIE)")
WORDS = {
    **dict.fromkeys(("sun", "sunlight", "full sun", "solar"), _SUN),
    "daylight": ("D65", "average daylight of 6500 K (CIE)"),
    "skylight": ("D75", "daylight of a north sky, 7500 K (CIE)"),
    **dict.fromkeys(("led", "white led", "neutral white led"), _WHITE),
    **dict.fromkeys(("warm led", "warm white led"), _WARM),
    **dict.fromkeys(("cool led", "cool white led"), _COOL),
    **dict.fromkeys(("incandescent", "incandescent lamp", "tungsten", "tungsten lamp"), _LAMP),
    "high-pressure sodium": ("HPS", "a high-pressure sodium lamp"),
    "metal halide lamp": ("Metal Halide", "a metal halide lamp"),
}
OWN: dict[str, str] = {}  # names of a user's definitions, each with its source
LOOKED_AT = 100  # parts of a list that are checked
# Suggestions for words that are not names of spectra; the temperatures of a candle and of moonlight
# are those of Wikipedia, Color temperature.
MEANT = {
    "day": "D65, daylight:5500K, AM1.5G",
    "sky": "D75, D65, daylight:10000K",
    "blackbody": example("blackbody"),
    "black body": example("blackbody"),
    "planck": example("blackbody"),
    "halogen": "A, blackbody:3000K",
    "white": "LED-B3, D65, E",
    "fluorescent": "F11, F2",
    "sodium": "HPS, LPS",
    **dict.fromkeys(("candle", "candlelight"), "blackbody:1850K, A"),
    **dict.fromkeys(("moon", "moonlight"), "blackbody:4100K, AM1.5G"),
    **dict.fromkeys(
        ("grow light", "grow led", "horticultural led", "white horticultural", "red and blue led"),
        "LED-BH1, HPS",
    ),
    "laser": "line:632.8nm",
    "line": "line:632.8nm",
    "gaussian": example("gaussian"),
    "band": example("band"),
}
HINT = (
    f"D65, LED-B3, AM1.5G, blackbody:2856K, line:632.8nm or a file ({command('spectrum', list='')})"
)

# A wavelength in vacuum [m] times its frequency [Hz], or its photon energy [J].
TIMES_WAVELENGTH = {FREQUENCY: LIGHT, ENERGY: PLANCK * LIGHT}


def spectrum(text: str, column: str = "", unit: str = "") -> Spectrum:
    """Return the spectrum of a text: a kind with its parameters, a name, or a file's path.

    `column`, or FILE:COLUMN, chooses the values of a file with several columns, `unit` is theirs;
    nm:FILE is a file of wavelengths in nm.
    """
    text = text.strip()
    if text in OWN:
        read_own(text)
        try:
            return spectrum(OWN[text], column, unit)
        except errors.RadcalcError as error:
            raise error.reworded(f"{NOTES_ON_OWN[text][0]}: {error.message}") from None
    if (column or unit) and (
        find_named(text) or (text.partition(":")[0].lower() in FORMS and ":" in text)
    ):
        unused = "column" if column else "unit"
        problem = f"{option(unused)} does not apply to {quote(text)}"
        raise errors.ConditionError(problem, "a file", [errors.leave_out(unused)])
    kind, colon, parameters = text.partition(":")
    if colon and kind.lower() in FORMS:
        return _of_kind(kind.lower(), parameters, " ".join(text.split()))
    named = find_named(text)
    if named:
        return named
    axis, path = axis_of(text)
    path, name = file_and_column(path)
    if _is_path(path):
        from radcalc.spectra.files import read_file

        return read_file(path, column or name, unit, axis)
    raise unknown(text)


def axis_of(text: str) -> tuple[str, str]:
    """Return the unit of the wavelengths in nm:FILE, and the file; "" and the text for others."""
    axis, _, path = text.partition(":")
    return (axis, path) if path and axis in AXES and not _is_path(text) else ("", text)


def file_and_column(text: str) -> tuple[str, str]:
    """Return the file and the column of FILE:COLUMN, '' for the column of a file alone."""
    path, _, name = text.rpartition(":")
    return (text, "") if _is_path(text) or not path else (path, name)


def _is_path(text: str) -> bool:
    return text == "-" or os.path.exists(text)


class Parameter(NamedTuple):
    """An uncertain parameter of a kind of source, and the text around it."""

    before: str
    amount: Amount
    behind: str

    def source(self, number: float) -> Spectrum:
        unit = self.amount.unit.text if self.amount.unit else ""
        return spectrum(f"{self.before}{number!r}{unit}{self.behind}")


def uncertain_parameter(text: str) -> Parameter | None:
    """Return the first parameter with an uncertainty: the temperature of `blackbody:2856+-20K`."""
    kind, colon, parameters = text.strip().partition(":")
    if not colon or kind.lower() not in FORMS:
        return None
    parts = parameters.split(",")
    for k, part in enumerate(parts):
        size, equals, weight = part.partition("=")
        if not any(mark in size for mark in UNCERTAIN):
            continue
        amount = read_amount(size)
        if amount.is_uncertain:
            before = "".join(f"{parameter}," for parameter in parts[:k])
            after = "".join(f",{parameter}" for parameter in parts[k + 1 :])
            return Parameter(f"{kind}:{before}", amount, f"{equals}{weight}{after}")
    return None


def unknown(text: str) -> errors.RadcalcError:
    """Return the error for a text that is no spectrum, with those that are like it."""
    if "," in text and (error := _of_list(text)):
        return error
    if "/" in text or text.lower().endswith(ENDINGS):
        path = quote(axis_of(text)[1])
        return errors.ConditionError(f"there is no file '{path}'", "the path of a file")
    problem = f"unknown spectrum '{quote(text)}' (and no such file)"
    if meant := MEANT.get(text.strip().lower()):
        ways = [
            errors.correct(text, one, remark="an example" if ":" in one else "")
            for one in meant.split(", ")
        ]
        return errors.ConditionError(problem, ways)
    if fitting := [form for kind in FORMS if _is_spectrum(form := f"{kind}:{text}")]:
        return errors.ConditionError(problem, errors.corrections(text, *fitting))
    known = {_bare(name): name for name in names()}
    near = [known[f] for f in errors.nearest(_bare(text), known, 3)]
    if near:
        return errors.ConditionError(problem, errors.corrections(text, *near))
    return errors.ConditionError(problem, HINT, [errors.call("spectrum", list="")])


def _of_list(text: str) -> errors.RadcalcError | None:
    """Return the error for a list of spectra, or for its first part that is not a spectrum."""
    parts = [part.strip() for part in text.split(",", LOOKED_AT)]
    wrong = [part for part in parts if part in ("", "-") or not _is_spectrum(part)]
    if len(wrong) == len(parts):
        return None
    if not wrong:
        return errors.ConditionError(
            f"'{quote(text)}' is a list of spectra", "only one of them here"
        )
    if wrong[0] in ("", "-"):
        what = "standard input is not allowed" if wrong[0] else "a spectrum is missing"
        right = ",".join(part for part in parts if part not in wrong)
        return errors.ConditionError(f"{what} in the list '{quote(text)}'", quote(right))
    error = unknown(wrong[0])
    return errors.ConditionError(f"in the list '{quote(text)}': {error.message}", error.hint)


def _is_spectrum(text: str) -> bool:
    try:
        spectrum(text)
    except errors.RadcalcError:
        return False
    return True


def read_spectra(text: str) -> list[str]:
    """Split `blackbody:2000K:6000K:1000K` into its temperatures, and `D65,A` into its sources.

    Any other text is a single source.
    """
    parts = text.split(",")
    if len(parts) > 1 and "-" not in parts and not os.path.exists(text):
        if len(parts) > MOST:
            raise errors.TooMany(f"a list of {len(parts)} values is too long", f"at most {MOST}")
        if all(map(_is_spectrum, parts)):
            return parts
    kind, colon, parameters = text.partition(":")
    if kind.strip().lower() in SERIES and colon:
        return [f"{kind.strip()}:{part}" for part in read_series(parameters)]
    return [text]


def _spelled(name: str) -> str:
    """Return a name without case, and without blanks and hyphens inside it."""
    if not name[:1].isalnum() or not (name[-1].isalnum() or name[-1] == ")"):
        return name
    return "".join(c for c in name.upper() if c not in " -_")


def _bare(name: str) -> str:
    return "".join(c for c in name.upper() if c.isalnum() or c == ".")


def names() -> list[str]:
    """Return the names of all named sources."""
    from radcalc.spectra.data.sources import SOURCES

    return [*SOURCES, *SUNS, *OWN]


@cache
def _spellings() -> dict[str, str]:
    from radcalc.spectra.data.sources import SOURCES

    names = {form(name): name for name in SOURCES for form in (_spelled, _bare)}
    return names | {f"F{name[2:]}": name for name in SOURCES if name.startswith("FL")}


@cache
def _words() -> dict[str, tuple[str, str]]:
    return {_spelled(word): meaning for word, meaning in WORDS.items()}


def aliases(name: str) -> list[str]:
    """Return the other names of a named source, and the words that are taken as it."""
    words = [word for word, (taken, _) in WORDS.items() if taken == name]
    return [*words, *(alias for alias, owner in SPELLED.items() if owner == name)]


def is_named(text: str) -> bool:
    """Return whether a text is the name of a source, also of the user's definitions."""
    return text in OWN or find_named(text) is not None


def find_named(text: str) -> Table | None:
    """Return a named source, or None; F1 is FL1, and `sunlight` is AM1.5G, with a note."""
    folded = _spelled(text)
    taken, meaning = _words().get(folded, ("", ""))
    sun = SPELLED.get(taken or folded, taken or folded)
    notes = (f"'{quote(text)}' is taken as {taken}, {meaning}",) if taken else ()
    if sun in SUNS:
        from radcalc.spectra.data import suns

        values = getattr(suns, SUNS[sun])
        label = f"{sun} (ASTM G173-03)"
        return Sun(label, suns.WAVELENGTHS, values, notes=notes, absolute="irradiance")
    from radcalc.spectra.data.sources import SOURCES

    name = _spellings().get(_spelled(taken) if taken else folded)
    if name is None:
        return None
    start, step, values = SOURCES[name]
    beyond = "illuminant A over 380-780 nm carries a tenth of what a 2856 K body radiates"
    wavelengths = [start + step * i for i in range(len(values))]
    return Table(name, wavelengths, values, VISIBLE, notes, left_out=beyond * (name == "A"))


NOTHING = 1e-15  # of the peak


class Sun(Table):
    """Sunlight by ASTM G173-03, in a table over 280-4000 nm."""

    @property
    def covered(self) -> Range:
        """The range [nm] of which the light is known: the air absorbs all below 280 nm."""
        is_on_ground = self.values[0] < NOTHING * max(self.values)
        return (0.0, self.known[1]) if is_on_ground else self.known

    @property
    def left_out(self) -> str:  # type: ignore[override]
        """Return a note on sunlight beyond the table: on the ground, it is less than in space."""
        from radcalc.spectra.data.suns import AM0

        watts, in_space = self.total(), integral(self.grid, AM0, *WHOLE)
        text = f"{self.label} has {watts:.6g} W/m2 over {range_text(self.known)}"
        if watts == in_space:
            return f"{text}, of {SOLAR_CONSTANT} W/m2 (ASTM E490)"
        return f"{text}; less than {100 * (SOLAR_CONSTANT - in_space) / watts:.2g} % is beyond"


def _of_kind(kind: str, parameters: str, text: str) -> Spectrum:
    """Return the spectrum of KIND:PARAMETERS, such as blackbody:2856K; refuse a malformed one."""
    if kind == "blackbody":
        return BlackBody(_temperature(parameters, text))
    if kind == "daylight":
        from radcalc.spectra.colorimetry import illuminant

        return illuminant(_temperature(parameters, text))
    if kind == "line":
        return Lines(text, [_line(part, text) for part in parameters.split(",")])
    if kind == "gaussian":
        parts = parameters.split(",")
        if len(parts) != 2:
            raise _malformed(text, _form(kind))
        if in_lengths := _in_lengths(*parts):
            raise _malformed(text, in_lengths)
        return _gaussian(text, wavelength(parts[0], text), _width(parts[1], text))
    ends = [wavelength(part, text) for part in parameters.split(":")]
    if len(ends) != 2 or ends[0] >= ends[1]:
        raise _malformed(text, _form(kind))
    return Table(text, ends, [1.0, 1.0], is_whole=True)


def _in_lengths(centre: str, fwhm: str) -> str:
    """Return the gaussian of an energy, or of a width in frequency, in wavelengths; else ''."""
    (place, of_place), (width, of_width) = map(_in_si, (centre, fwhm))
    if not place or (of_place != ENERGY and of_width not in TIMES_WAVELENGTH):
        return ""
    if of_place in TIMES_WAVELENGTH:
        place = TIMES_WAVELENGTH[of_place] / place
        centre = f"{standard_air_wavelength(place) * 1e9:.6g}nm"
    if of_width in TIMES_WAVELENGTH:
        width *= place * place / TIMES_WAVELENGTH[of_width]
    return f"gaussian:{quote(centre.strip())},{width * 1e9:.4g}nm"


def _form(kind: str) -> str:
    return f"{kind}:{FORMS[kind][0]} as in {example(kind)}"


def _malformed(text: str, form: str) -> errors.ConditionError:
    return errors.ConditionError(f"'{quote(text)}' is not a spectrum", form)


def _temperature(parameter: str, text: str) -> float:
    value, unit_text = split_value(parameter)
    scale = find_scale(unit_text) if unit_text else None
    if scale and scale.dimension == TEMPERATURE:
        return float(scale.quantity(value))
    return _quantity(parameter, text, TEMPERATURE, f"a temperature, as in {example('blackbody')}")


def _width(parameter: str, text: str) -> float:
    form = f"a width, as in {example('gaussian')}"
    width = _in_nanometres(_quantity(parameter, text, LENGTH, form))
    if width <= 0:
        raise _malformed(text, "a width of more than 0")
    return width


def _quantity(parameter: str, text: str, dimension: Dimension, form: str) -> float:
    size, measured = _in_si(parameter)
    if measured != dimension:
        raise _malformed(text, form)
    return size


def _in_si(parameter: str) -> tuple[float, Dimension]:
    value, unit_text = split_value(parameter)
    unit = resolve(unit_text or "1")
    return value * unit.factor, unit.dimension


def _in_nanometres(metres: float) -> float:
    """Return a length in nanometres, free of rounding by its unit: 632.8."""
    return float(f"{metres * 1e9:.15g}")


def wavelength(parameter: str, text: str) -> float:
    """Return a wavelength [nm] from a length or a frequency."""
    size, dimension = _in_si(parameter)
    if size <= 0 or dimension not in (LENGTH, *TIMES_WAVELENGTH):
        raise _malformed(text, "wavelengths such as 632.8nm")
    if dimension in TIMES_WAVELENGTH:
        size = float(standard_air_wavelength(TIMES_WAVELENGTH[dimension] / size))
    if dimension == ENERGY:
        raise _malformed(text, f"a wavelength, {size * 1e9:.6g}nm")
    if dimension == FREQUENCY:
        return size * 1e9
    nanometres = _in_nanometres(size)
    if not SHORTEST <= nanometres <= LONGEST:
        raise _malformed(text, f"wavelengths from {SHORTEST:g}nm to {LONGEST:g}nm")
    return nanometres


def _line(part: str, text: str) -> tuple[float, float]:
    place, equals, weight = part.partition("=")
    watts = split_value(weight) if equals else (1.0, "")
    if watts[1] or not WEAKEST <= watts[0] <= STRONGEST:
        weights = f"weights from {WEAKEST:g} to {STRONGEST:g}, without a unit"
        raise _malformed(text, f"{example('line')}, with {weights}")
    return wavelength(place, text), watts[0]


def _gaussian(text: str, centre: float, fwhm: float) -> Table:
    """Return points at a fiftieth of the width, out to where the values vanish."""
    sigma = fwhm / (2 * math.sqrt(2 * math.log(2)))
    points = range(-150, 151)
    pairs = [(centre + i * sigma / 21, math.exp(-((i / 21) ** 2) / 2)) for i in points]
    if not 1e-6 * centre <= fwhm <= centre:
        raise _malformed(text, "a width from a millionth of the centre (or line:) to the centre")
    if pairs[0][0] <= 0:
        pairs = [
            (SHORTEST, math.exp(-(((centre - SHORTEST) / sigma) ** 2) / 2)),
            *(p for p in pairs if p[0] > SHORTEST),
        ]
    return Table(text, [x for x, _ in pairs], [y for _, y in pairs], is_whole=True)


# ---------------------------------------------------------------------------------------------
# Weights, responsivities and filters of files


def weight_of(text: str) -> str:
    """Return the kind of a weight by its name or the path of its file."""
    known = weights.names()
    folded = text.lower().replace("_", "-").replace(" ", "-")
    if folded in known:
        read_own(folded)
        return known[folded]
    if _is_file(text):
        return of_file(text, os.path.splitext(os.path.basename(text))[0])
    near = errors.nearest(folded, known)
    hint = [errors.add("weight", name) for name in near] or ", ".join(known)
    raise errors.ConditionError(f"unknown weight '{quote(text)}' (and no such file)", hint)


def _is_file(text: str) -> bool:
    return os.path.isfile(file_and_column(text)[0])


def of_file(path: str, name: str) -> str:
    """Return the kind of the weight in a file; a file that is read again has the same.

    Its values are of watts, or of photons if its title has a quantum efficiency or photons.
    """
    curve, own = _curve(path)
    if own.acts_on == CURRENT:
        raise errors.ConditionError(
            f"{curve} has a responsivity in A/W, not a weight", [errors.add("response", path)]
        )
    for kind, known in OWN_WEIGHTS.items():
        if known[2:] == own[2:] and known.label == name:
            return kind
    from radcalc.quantities.names import add_weight

    kind = add_weight(name, own.acts_on, f"the file {curve}")
    OWN_WEIGHTS[kind] = own._replace(kind=kind, label=name)
    return kind


CURRENT = "A"  # of a detector, per watt
OF_PHOTONS = ("quantum", "photon", "qe", "eqe", "iqe", "ipce")
STEPS_OF_FILES = (1.0, 0.5, 0.25, 0.2, 0.1, 0.05, 0.02, 0.01)  # nm
MOST_POINTS = 1_000_000


def _curve(path: str) -> tuple[str, weights.Weight]:
    """Return the name of a file and the weight in it, at equal steps."""
    from radcalc.files.columns import plain
    from radcalc.spectra.files import read_curve
    from radcalc.units.dimensions import RESPONSIVITY
    from radcalc.units.table import unit_of

    curve = read_curve(*file_and_column(path))
    start, end = curve.grid[0], curve.grid[-1]
    for step in STEPS_OF_FILES:
        offsets = [(x - start) / step for x in curve.grid]
        if all(abs(x - round(x)) < 1e-6 for x in offsets):
            break
    count = math.floor((end - start) / step + 1e-6) + 1
    if count > MOST_POINTS:
        raise errors.ConditionError(f"{curve.name} spans {end - start:g} nm", "a narrower weight")
    title, factor, acts_on = plain(curve.title), 1.0, RADIANT
    texts = [part.strip(" ()[]") for part in curve.title.replace("[", "(").split("(")]
    units = [unit for text in texts if (unit := unit_of(text))]
    if any(unit.dimension == RESPONSIVITY for unit in units):
        acts_on, factor = CURRENT, next(u.factor for u in units if u.dimension == RESPONSIVITY)
    elif "%" in title or "percent" in title:
        factor = 0.01
    if acts_on == RADIANT and not {*title.replace("_", " ").split()}.isdisjoint(OF_PHOTONS):
        acts_on = PHOTON
    values = [
        factor * at(curve.grid, curve.values, min(start + step * k, end)) for k in range(count)
    ]
    own = weights.Weight(
        "", curve.name, acts_on, start, step, tuple(values), f"the file {curve.name}"
    )
    return curve.name, own


def response_of(path: str) -> weights.Weight:
    """Return the responsivity in a file [A/W], from its title, or from a quantum efficiency."""
    name, own = _curve(path)
    if own.acts_on == PHOTON:
        charge = constant("elementary_charge")
        amperes = tuple([charge * photons for photons in own.per_watt])
        return own._replace(acts_on=CURRENT, values=amperes)
    if own.acts_on != CURRENT:
        problem = f"the title of {name} does not state A/W or a quantum efficiency"
        raise errors.ConditionError(problem, "a title such as: responsivity (A/W)")
    return own


def transmittance_of(text: str) -> weights.Weight:
    """Return the transmittance of a file, or the product of those of several, by commas."""
    paths = [text] if _is_file(text) else text.split(",")
    curves = [_curve(path.strip())[1] for path in paths]
    for own in curves:
        if max(own.values) > 1 or own.acts_on != RADIANT:
            most = f"its values are up to {max(own.values):g}"
            problem = f"{own.label} is not a transmittance: {most}"
            raise errors.ConditionError(problem, "values from 0 to 1, or a title with %")
    low, high = max(own.range[0] for own in curves), min(own.range[1] for own in curves)
    step = min(own.step for own in curves)
    if low >= high:
        raise errors.ConditionError(
            f"the files {quote(text)} have no range in common", "files that overlap"
        )
    points = [low + step * k for k in range(math.floor((high - low) / step + 1e-6) + 1)]
    values = [math.prod(own.at(x) for own in curves) for x in points]
    label = " and ".join([own.label for own in curves])
    return weights.Weight("", label, RADIANT, low, step, tuple(values), f"the file {label}")


def through(source: Spectrum, own: weights.Weight) -> Spectrum:
    """Return a spectrum behind a filter, over the wavelengths that both have."""
    label = f"{source.label} behind {own.label}"
    low, high = max(own.range[0], source.known[0]), min(own.range[1], source.known[1])
    if isinstance(source, Lines):
        beyond = [place for place, _ in source.lines if not low <= place <= high]
        if beyond:
            problem = f"the filter {own.label} has no value at {beyond[0]:g} nm"
            raise errors.ConditionError(problem, "a filter with all the lines")
        lines = [(place, watts * own.at(place)) for place, watts in source.lines]
        return Lines(label, [line for line in lines if line[1] > 0] or lines)
    if low >= high:
        raise errors.ConditionError(
            f"the filter {own.label} has no value where {source.label} has", ""
        )
    points = {*own.grid}
    if isinstance(source, BlackBody):
        points |= {float(nm) for nm in range(math.ceil(low), math.floor(high) + 1)}
        grid = sorted({low, high, *[x for x in points if low <= x <= high]})
        watts = weights.spectral_exitances([1e-9 * x for x in grid], source.temperature)
        values = [1e-9 * y for y in watts]
    else:
        assert isinstance(source, Table)
        grid = sorted({low, high, *[x for x in (*points, *source.grid) if low <= x <= high]})
        values = [at(source.grid, source.values, x) for x in grid]
    values = [y * own.at(x) for x, y in zip(grid, values, strict=True)]
    if not any(values):
        raise errors.ConditionError(
            f"nothing of {source.label} is behind {own.label}", "another filter"
        )
    limits = max(low, source.limits[0]), min(high, source.limits[1])
    filtered = Table(label, grid, values, limits, source.notes, source.absolute)
    filtered.reading = source.reading
    return filtered
