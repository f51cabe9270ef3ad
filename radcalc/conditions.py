"""What a condition supplies: a factor with a dimension, its assumption and its derivation.

A condition is an option of `convert` (`--distance 2m`) or a keyword of the Python API
(`distance="2m"`).  This module reads conditions and turns each into a factor; which factors a
conversion needs is the business of `link.py`.
"""

import math
from typing import Any, NamedTuple

from radcalc import maths
from radcalc.errors import ConditionError, NumberError, quote
from radcalc.quantities import (
    AREA,
    AXIS,
    DURATION,
    FLUX,
    FREQUENCY,
    LUMINOUS,
    NONE,
    PHOTON,
    RADIANT,
    RATIOS,
    SOLID_ANGLE,
    WAVELENGTH,
    WAVENUMBER,
    describe,
    powers,
    times,
)
from radcalc.result import Step
from radcalc.spectra.observers import (
    OBSERVERS,
    Observer,
    luminous_efficacy,
    standard_air_wavelength,
)
from radcalc.spectra.planck import AVOGADRO, LIGHT, PLANCK
from radcalc.spectra.spectrum import WHOLE, Spectrum, range_text
from radcalc.units.grammar import split_quantity
from radcalc.units.table import NUMBER, Dimension, Unit, divide, resolve

# What a condition is about; two conditions in one slot contradict each other.
LINK, TIME, AREA_SLOT, CONE, DISTANCE = "link", "time", "area", "solid angle", "distance"
BAND, REFLECTANCE, PUPIL = "bandwidth", "reflectance", "pupil"
REFINES = "refines"  # --observer and --incidence, which only refine another condition

EXTREME = 1e100  # squares and ratios of what is within stay within a float
LENGTH = powers(length=1)
ANGLE = powers(angle=1)
TEMPERATURE = powers(temperature=1)
ENERGY = times(FLUX[RADIANT], DURATION)
PHOTON_ENERGY = powers(mass=1, length=2, time=-2, count=-1)


class Option(NamedTuple):
    """A condition as a user can give it: a quantity, a choice, a text, else a flag."""

    name: str
    slot: str
    dimensions: tuple[Dimension, ...]
    takes: str
    example: str
    help: str
    choices: tuple[str, ...] = ()
    is_text: bool = False


OPTIONS = {
    option.name: option
    for option in (
        Option(
            "wavelength",
            LINK,
            (LENGTH, AXIS[FREQUENCY], AXIS[WAVENUMBER], ENERGY, PHOTON_ENERGY),
            "a wavelength, frequency, wavenumber or photon energy",
            "555nm",
            "Light of one wavelength (or frequency, wavenumber, photon energy).",
        ),
        Option(
            "spectrum",
            LINK,
            (),
            "a spectrum",
            "D65",
            "Light of that spectrum: a name, blackbody:2856K, line:632.8nm, a file ...",
            is_text=True,
        ),
        Option(
            "efficacy",
            LINK,
            tuple(RATIOS.values()),
            "a ratio of two kinds",
            "93lm/W",
            "A given ratio of two kinds: 93lm/W, 2.1umol/J, 54lm.s/umol.",
        ),
        Option(
            "observer",
            REFINES,
            (),
            "an observer",
            "photopic",
            "Whose eyes see --wavelength or --spectrum.",
            tuple(OBSERVERS),
        ),
        Option(
            "range",
            REFINES,
            (),
            "two wavelengths",
            "380nm:780nm",
            "Where the watts of --spectrum are counted.",
            is_text=True,
        ),
        Option(
            "photon-range",
            REFINES,
            (),
            "two wavelengths",
            "400nm:700nm",
            "Where the photons of --spectrum are counted (default 400nm:700nm).",
            is_text=True,
        ),
        Option("time", TIME, (DURATION,), "a time", "1h", "Constant over that time."),
        Option("area", AREA_SLOT, (AREA,), "an area", "1m2", "Uniform over that area."),
        Option("radius", AREA_SLOT, (LENGTH,), "a length", "10cm", "Radius of a circular area."),
        Option(
            "diameter", AREA_SLOT, (LENGTH,), "a length", "20cm", "Diameter of a circular area."
        ),
        Option(
            "solid-angle",
            CONE,
            (SOLID_ANGLE,),
            "a solid angle",
            "1sr",
            "Uniform over that solid angle.",
        ),
        Option(
            "half-angle",
            CONE,
            (ANGLE,),
            "an angle",
            "30deg",
            "Uniform over the cone of that half angle, from axis to edge.",
        ),
        Option(
            "apex-angle",
            CONE,
            (ANGLE,),
            "an angle",
            "60deg",
            "Uniform over the cone of that full angle, from edge to edge.",
        ),
        Option("isotropic", CONE, (), "", "", "Uniform in all directions, over 4 pi sr."),
        Option("hemisphere", CONE, (), "", "", "Uniform over a hemisphere."),
        Option(
            "exponent",
            CONE,
            (NUMBER,),
            "a number",
            "1",
            "A lobe that falls off as a power of the cosine; 1 is Lambertian.",
        ),
        Option(
            "beam-angle",
            CONE,
            (ANGLE,),
            "an angle",
            "30deg",
            "A cosine-power lobe of that full angle at half the peak intensity.",
        ),
        Option(
            "distance",
            DISTANCE,
            (LENGTH,),
            "a length",
            "2m",
            "Straight line from a small source to the receiver.",
        ),
        Option(
            "incidence",
            REFINES,
            (ANGLE,),
            "an angle",
            "45deg",
            "Angle between the light and the receiver's normal (with --distance).",
        ),
        Option(
            "bandwidth",
            BAND,
            (AXIS[WAVELENGTH], AXIS[FREQUENCY], AXIS[WAVENUMBER]),
            "a width in wavelength, frequency or wavenumber",
            "10nm",
            "Width of a band in which the spectral density is constant.",
        ),
        Option(
            "reflectance",
            REFLECTANCE,
            (NUMBER,),
            "a number from 0 to 1",
            "0.8",
            "A Lambertian reflector, 0 to 1 or in %.",
        ),
        Option("pupil", PUPIL, (LENGTH,), "a length", "3mm", "Diameter of the eye's pupil."),
    )
}


class Given(NamedTuple):
    """A condition that was given: the option, the text as typed, the value in SI units."""

    option: Option
    text: str
    value: Any
    dimension: Dimension

    @property
    def flag(self) -> str:
        """The option as one types it."""
        return f"--{self.option.name}"


class Factor(NamedTuple):
    """A number with a symbol that a quantity is multiplied or divided by."""

    symbol: str
    value: Any
    unit: str
    assumption: str
    steps: tuple[Step, ...] = ()
    notes: tuple[str, ...] = ()


def show(value: Any) -> str:
    """A number for a derivation; an array by its shape."""
    return f"{value:.6g}" if isinstance(value, (int, float)) else f"array{value.shape}"


def give(name: str, value: Any) -> Given:
    """Read one condition.

    `value` is a text as on the command line, True for a flag, a number, or a pair of a number
    (or an array) and a `Unit`.
    """
    option = OPTIONS[name]
    if option.choices:
        if value not in option.choices:
            raise ConditionError(
                f"--{name} does not know '{quote(str(value))}'", ", ".join(option.choices)
            )
        return Given(option, str(value), value, NUMBER)
    if option.is_text:
        text = str(value).strip()
        return Given(option, text, _read_text(option, text), NUMBER)
    if not option.dimensions:
        if value is not True:
            raise ConditionError(f"--{name} takes no value", f"--{name} alone")
        return Given(option, "", True, NUMBER)
    if isinstance(value, str):
        text = value.strip().replace("\u2212", "-")
        number, unit_text = _split(option, text)
        unit = resolve(unit_text) if unit_text else None
    elif isinstance(value, tuple):
        number, unit = value
        text = f"{show(number)} {unit.text}"
    else:
        number, unit, text = value, None, show(value)
    dimension = unit.dimension if unit else NUMBER
    if dimension not in option.dimensions:
        if unit is None:
            raise ConditionError(
                f"--{name} {quote(text)} has no unit",
                f"--{name} {_with_unit(option, quote(text))} (one word, no blank)",
            )
        raise ConditionError(
            f"--{name} takes {option.takes}, not {describe(unit)}", f"--{name} {option.example}"
        )
    return Given(option, text, _in_si(option, text, number, unit), dimension)


def _read_text(option: Option, text: str) -> Any:
    """A spectrum, or a range of wavelengths [nm]."""
    if option.name == "spectrum":
        from radcalc.spectra.sources import spectrum

        return spectrum(text)
    ends = [give("wavelength", end) for end in text.split(":")]
    if len(ends) != 2 or any(end.dimension != LENGTH for end in ends):
        raise ConditionError(
            f"--{option.name} {quote(text)} is not a range of wavelengths",
            f"--{option.name} {option.example}",
        )
    low, high = (round(_positive(end) * 1e9, 9) for end in ends)
    if low >= high:
        raise ConditionError(
            f"--{option.name} {quote(text)} ends before it starts", f"{ends[1].text}:{ends[0].text}"
        )
    return low, high


def _split(option: Option, text: str) -> tuple[float, str]:
    try:
        return split_quantity(text)
    except NumberError as error:
        raise NumberError(f"--{option.name}: {error.message}", error.hint) from None


def _with_unit(option: Option, number: str) -> str:
    if ANGLE in option.dimensions and ("pi" in number or "π" in number):
        return f"{number}rad"
    return number + option.example.lstrip("0123456789.")


def _in_si(option: Option, text: str, number: Any, unit: Unit | None) -> Any:
    """The value in SI units; extremes that no light reaches would only overflow later."""
    value = number * (divide(unit.top, unit.bottom) if unit else 1)
    size = abs(value)
    extreme = (size > EXTREME) | ((size < 1 / EXTREME) & (size != 0)) | (size != size)
    if maths.any_true(extreme):
        raise ConditionError(
            f"--{option.name} {quote(text)} is beyond what radcalc reckons with",
            f"values from {1 / EXTREME:g} to {EXTREME:g} in SI units",
        )
    return value


def _require(given: Given, good: bool, limit: str) -> None:
    if not good:
        raise ConditionError(f"{given.flag} {quote(given.text)} is not possible", limit)


def _positive(given: Given) -> Any:
    _require(given, not maths.any_true(given.value <= 0), "more than 0")
    return given.value


def area(given: Given) -> Factor:
    """The area of a source or a receiver [m2]."""
    size = _positive(given)
    if given.option.name == "area":
        return Factor("A", size, "m2", f"uniform over {given.text}")
    radius = size if given.option.name == "radius" else size / 2
    value = math.pi * radius**2
    step = Step("area of a circle", "A = pi R^2", f"A = pi ({show(radius)} m)^2 = {show(value)} m2")
    return Factor("A", value, "m2", f"uniform over a circle of {show(value)} m2", (step,))


def duration(given: Given) -> Factor:
    """A time [s]."""
    return Factor("t", _positive(given), "s", f"constant over {given.text}")


def solid_angle(given: Given) -> Factor:
    """The solid angle between flux and intensity [sr]."""
    name, value = given.option.name, given.value
    if name == "isotropic":
        return Factor("Omega", 4 * math.pi, "sr", "uniform over 4 pi sr (isotropic)")
    if name == "hemisphere":
        return Factor("Omega", 2 * math.pi, "sr", "uniform over 2 pi sr (a hemisphere)")
    if name == "solid-angle":
        _positive(given)
        whole = 4 * math.pi * (1 + 1e-12)  # 12.566370614359sr, as typed, is the whole sphere
        _require(given, not maths.any_true(value > whole), "at most 4pi sr")
        return Factor("Omega", value, "sr", f"uniform over {given.text}")
    if name in ("exponent", "beam-angle"):
        return _lobe(given)
    half = half_angle(given)
    within = not maths.any_true(half > math.pi * (1 + 1e-12))
    _require(given, within, "at most the whole sphere")
    omega = 4 * math.pi * maths.sin(half / 2) ** 2
    step = Step(
        "solid angle of a cone",
        "Omega = 4 pi sin^2(alpha/2) Omega0",
        f"Omega = 4 pi sin^2({_degrees(half)}/2) sr = {show(omega)} sr",
        "ISO 80000-3, solid angle",
    )
    cone = f"uniform over a cone of half angle {_degrees(half)}, {show(omega)} sr"
    return Factor("Omega", omega, "sr", cone, (step,))


def half_angle(given: Given) -> Any:
    """The half angle of a cone [rad], from --half-angle or --apex-angle."""
    angle = _positive(given)
    return angle if given.option.name == "half-angle" else angle / 2


def _degrees(angle: Any) -> str:
    return f"{show(angle * (180 / math.pi))} deg"


def _lobe(given: Given) -> Factor:
    """A cosine-power lobe: the solid angle that, at the peak intensity, holds all the flux."""
    if given.option.name == "exponent":
        exponent = given.value
        _require(given, not maths.any_true(exponent < 0), "0 or more")
        steps: tuple[Step, ...] = ()
    else:
        angle = _positive(given)
        _require(given, not maths.any_true(angle >= math.pi), "less than 180 deg")
        # cos x as 1 - 2 sin^2(x/2), whose logarithm keeps its digits for narrow beams
        exponent = math.log(0.5) / maths.log1p(-2 * maths.sin(angle / 4) ** 2)
        steps = (
            Step(
                "exponent of a lobe",
                "n = ln(1/2) / ln cos(FWHM/2)",
                f"n = ln(1/2) / ln cos({_degrees(angle)}/2) = {show(exponent)}",
            ),
        )
    omega = 2 * math.pi / (exponent + 1)
    step = Step(
        "flux of a lobe",
        "Omega = 2 pi Omega0 / (n + 1)",
        f"Omega = 2 pi sr / ({show(exponent)} + 1) = {show(omega)} sr",
    )
    assumption = f"intensity I0 cos^n(theta) with n = {show(exponent)}; I0 is the peak"
    return Factor("Omega", omega, "sr", assumption, (*steps, step))


def projected_solid_angle(given: Given) -> Factor:
    """The projected solid angle between radiance and irradiance, exitance or flux [sr]."""
    name = given.option.name
    if name == "hemisphere":
        return Factor("Omega_p", math.pi, "sr", "uniform over a hemisphere, pi sr projected")
    if name not in ("half-angle", "apex-angle"):
        raise ConditionError(
            f"{given.flag} does not link a radiance: that takes the projected solid angle",
            "--half-angle ANGLE or --hemisphere",
        )
    half = half_angle(given)
    limit = f"at most {'90' if name == 'half-angle' else '180'} deg, where a radiance is concerned"
    _require(given, not maths.any_true(half > math.pi / 2 * (1 + 1e-12)), limit)
    omega = math.pi * maths.sin(half) ** 2
    step = Step(
        "projected solid angle of a cone",
        "Omega_p = pi sin^2(alpha) Omega0",
        f"Omega_p = pi sin^2({_degrees(half)}) sr = {show(omega)} sr",
        "ISO 80000-7, radiance and irradiance",
    )
    cone = f"uniform over a cone of half angle {_degrees(half)} about the normal"
    return Factor("Omega_p", omega, "sr", f"{cone}, {show(omega)} sr projected", (step,))


def inverse_square(given: Given, incidence: Given | None) -> Factor:
    """From the intensity of a small source to the irradiance at a distance [sr/m2]."""
    distance = _positive(given)
    cosine, tilt, notes = _cosine(incidence)
    value = cosine / distance**2
    written = f"cos({_degrees(incidence.value)}) " if incidence else ""
    step = Step(
        "inverse square law",
        f"q = {'cos(theta) ' if incidence else ''}Omega0 / d^2",
        f"q = {written}sr / ({show(distance)} m)^2 = {show(value)} sr/m2",
        "ISO 80000-7, intensity and irradiance",
    )
    assumption = f"a source small beside its distance, {tilt}"
    return Factor("q", value, "sr/m2", assumption, (step,), notes)


def _cosine(incidence: Given | None) -> tuple[Any, str, tuple[str, ...]]:
    """The cosine of the incidence; light from behind the surface gives 0, and a note."""
    if incidence is None:
        return 1.0, "light along the receiver's normal", ()
    angle = abs(incidence.value)
    _require(incidence, not maths.any_true(angle > math.pi), "0 to 180 deg")
    behind = angle >= math.pi / 2
    if isinstance(angle, float):
        cosine = 0.0 if behind else math.cos(angle)
    else:
        cosine = maths.cos(angle) * ~behind
    note = f"--incidence {incidence.text}: light from the side or behind does not reach the surface"
    return (
        cosine,
        f"incidence {incidence.text} from the normal",
        (note,) if maths.any_true(behind) else (),
    )


def disc(source: Given, distance: Given, incidence: Given | None) -> Factor:
    """The projected solid angle of a uniform disc seen from its axis [sr]."""
    size, away = _positive(source), _positive(distance)
    radius = size if source.option.name == "radius" else size / 2
    cosine, tilt, _ = _cosine(incidence)
    notes: tuple[str, ...] = ()
    if incidence is not None:
        # Where the receiver's plane cuts the disc, the light vector is not all of it.
        angle, rim = abs(incidence.value), maths.atan(radius / away)
        right = math.pi / 2 * (1 + 1e-15)
        below = angle - rim >= math.pi / 2
        if maths.any_true(
            (angle + rim > right) & ~below
            if not isinstance(below, bool)
            else angle + rim > right and not below
        ):
            raise ConditionError(
                f"--incidence {quote(incidence.text)}: part of the disc is below the receiver's "
                "horizon, where the formula on the axis does not hold",
                "a smaller --incidence, --radius or a larger --distance",
            )
        if maths.any_true(below):
            notes = (f"--incidence {incidence.text}: the disc is below the receiver's horizon",)
    omega = math.pi * radius**2 / (radius**2 + away**2) * cosine
    step = Step(
        "disc on its axis",
        f"Omega_p = pi Omega0 R^2 / (R^2 + d^2){' cos(theta)' if incidence else ''}",
        f"Omega_p = pi sr ({show(radius)} m)^2 / (({show(radius)} m)^2 + ({show(away)} m)^2)"
        f"{f' cos({_degrees(incidence.value)})' if incidence else ''} = {show(omega)} sr",
        "J. R. Howell, A Catalog of Radiation Heat Transfer Configuration Factors",
    )
    assumption = f"a uniform disc seen from its axis at {distance.text}, {tilt}"
    return Factor("Omega_p", omega, "sr", assumption, (step,), notes)


def far_field(source: Factor, distance: Given) -> None:
    """Refuse an area seen from so near that the inverse square law is off."""
    size = 2 * (source.value / math.pi) ** 0.5
    if maths.any_true(distance.value < 5 * size * (1 - 1e-12)):
        raise ConditionError(
            f"--distance {quote(distance.text)} is less than five times the size of the source "
            f"({show(size)} m): the inverse square law does not hold",
            "--radius R in place of --area, for the exact disc",
        )


def reflector(given: Given) -> Factor:
    """A Lambertian reflector, from incident irradiance to radiance [1/sr]."""
    rho = given.value
    bad = maths.any_true(rho < 0) or maths.any_true(rho > 1)
    _require(given, not bad, "from 0 to 1")
    value = rho / math.pi
    step = Step(
        "Lambertian reflector",
        "r = rho / (pi Omega0)",
        f"r = {show(rho)} / (pi sr) = {show(value)} /sr",
        "ISO 80000-7, luminance and reflectance",
    )
    assumption = f"a Lambertian reflector of reflectance {given.text}"
    return Factor("r", value, "/sr", assumption, (step,))


def pupil(given: Given) -> Factor:
    """Trolands per candela per square metre: the pupil's area in mm2."""
    diameter = _positive(given)
    value = math.pi / 4 * (diameter / 1e-3) ** 2
    step = Step(
        "retinal illuminance",
        "p = pi/4 d^2",
        f"p = pi/4 ({show(diameter / 1e-3)} mm)^2 = {show(value)} mm2",
    )
    return Factor("p", value, "td m2/cd", f"a round pupil of diameter {given.text}", (step,))


class Light(NamedTuple):
    """Light of one wavelength: in vacuum for photons, in standard air for the eye's table."""

    given: Given
    vacuum: Any
    table: Any
    observer: Observer

    @property
    def photon_energy(self) -> Any:
        """The energy of a photon [J]."""
        return PLANCK * LIGHT / self.vacuum


def light(given: Given, observer: Given | None) -> Light:
    """Turn a wavelength, frequency, wavenumber or photon energy into a wavelength."""
    value = _positive(given)
    seen_by = OBSERVERS[observer.value if observer else "photopic"]
    if given.dimension == LENGTH:
        return Light(given, value, value, seen_by)
    if given.dimension == AXIS[FREQUENCY]:
        vacuum = LIGHT / value
    elif given.dimension == AXIS[WAVENUMBER]:
        vacuum = 1 / value
    else:
        vacuum = PLANCK * LIGHT / value
    return Light(given, vacuum, standard_air_wavelength(vacuum), seen_by)


VACUUM = "{} is taken as the wavelength in vacuum (in air it differs by 3e-4)"


def kind_factor(of: Light, over: str, under: str) -> Factor:
    """The ratio of two kinds, over / under, at one wavelength."""
    given, energy = of.given, of.photon_energy
    is_length = given.dimension == LENGTH
    assumption = ""
    notes: tuple[str, ...] = ()
    steps: tuple[Step, ...] = ()
    efficacy: Any = None
    if LUMINOUS in (over, under):
        efficacy = luminous_efficacy(of.table, of.observer)
        assumption = of.observer.assumption
        if not is_length:
            assumption += f"; {given.text} is {show(of.table * 1e9)} nm in standard air"
        if maths.any_true(efficacy == 0):
            notes = (
                f"nothing is seen at {given.text}: the table spans "
                f"{of.observer.start}-{of.observer.end} nm",
            )
        steps = (
            Step(
                "luminous efficacy of one wavelength",
                f"K = {of.observer.constant} {of.observer.label.split()[0]}",
                f"K = {of.observer.maximum:g} lm/W * {show(efficacy / of.observer.maximum)}"
                f" = {show(efficacy)} lm/W",
                "CIE 018:2019",
            ),
        )
    if PHOTON in (over, under):
        steps += (
            Step(
                "photon energy",
                "Q = h c / lambda",
                f"Q = h c / {show(of.vacuum * 1e9)} nm = {show(energy)} J",
                "SI Brochure: exact h and c",
            ),
        )
        photons = f"{given.text} is {show(of.vacuum * 1e9)} nm in vacuum"
        said = VACUUM.format(given.text) if is_length else photons
        assumption = "; ".join(filter(None, [assumption, said]))
        outside = (of.table < 400e-9 * (1 - 1e-12)) | (of.table > 700e-9 * (1 + 1e-12))
        if maths.any_true(outside):
            notes += (f"{given.text} lies outside 400-700 nm, where PPFD is counted",)
    unit = KIND_UNITS[over, under]
    if LUMINOUS not in (over, under):
        symbol, value = "Q", energy
        forward = over == RADIANT
    elif PHOTON not in (over, under):
        symbol, value = "K", efficacy
        forward = over == LUMINOUS
    else:
        symbol, value = "(K Q)", efficacy * energy
        forward = over == LUMINOUS
    if not forward:
        if maths.any_true(value == 0):
            raise ConditionError(
                f"nothing is seen at {quote(given.text)}: nothing follows from a luminous quantity",
                f"a wavelength from {of.observer.start}nm to {of.observer.end}nm",
            )
        symbol, value = f"(1/{symbol})", 1 / value
    return Factor(symbol, value, unit, assumption, steps, notes)


PAR = (400.0, 700.0)  # nm: the photosynthetically active photons that PPFD counts


def spectral_factor(
    given: Given,
    over: str,
    under: str,
    limits: Given | None,
    photon_limits: Given | None,
    observer: Given | None,
) -> Factor:
    """The ratio of two kinds, over / under, of a whole spectrum."""
    source: Spectrum = given.value
    seen_by = OBSERVERS[observer.value if observer else "photopic"]
    everywhere = WHOLE if source.counts_all_photons else PAR
    watts_in = limits.value if limits else source.limits
    photons_in = photon_limits.value if photon_limits else everywhere
    amounts: dict[str, float] = {}
    said = [f"spectrum {source.label}"]
    for kind in (over, under):
        if kind == RADIANT:
            amounts[kind] = source.power(watts_in)
            said.append(f"watts counted over {range_text(watts_in)}")
        elif kind == PHOTON:
            amounts[kind] = source.photons(photons_in)
            said.append(f"photons counted over {range_text(photons_in)}")
        else:
            amounts[kind] = seen_by.maximum * source.seen(seen_by)
            said.append(seen_by.assumption)
    if not all(amount > 0 or kind == LUMINOUS != under for kind, amount in amounts.items()):
        raise ConditionError(
            f"--spectrum {quote(given.text)} has nothing that counts there: {'; '.join(said[1:])}",
            "another spectrum or range",
        )
    value = amounts[over] / amounts[under]
    watts, lumens, photons = (amounts.get(kind, 1.0) for kind in (RADIANT, LUMINOUS, PHOTON))
    if PHOTON not in amounts:
        shown = f"{show(lumens / watts)} lm/W"
    elif LUMINOUS not in amounts:
        shown = f"{show(photons / AVOGADRO * 1e6 / watts)} umol/J"
    else:
        shown = f"{show(lumens / photons * AVOGADRO * 1e-6)} lm s/umol"
    names = {
        RADIANT: "int(S)",
        LUMINOUS: f"{seen_by.constant} int(S {seen_by.label.split('(')[0]})",
        PHOTON: "int(S lambda/(h c))",
    }
    step = Step(
        "ratio of kinds in a spectrum",
        f"K = {names[over]} / {names[under]}",
        f"K = {show(amounts[over])} / {show(amounts[under])} = {show(value)}; that is {shown}",
        "trapezoid on the union of the data's and the observer's grids",
    )
    said.insert(1, shown)
    notes = source.notes
    if lumens == 0:
        notes += ("nothing of this spectrum is seen",)
    return Factor("K", value, KIND_UNITS[over, under], "; ".join(said), (step,), notes)


KIND_UNITS = {
    (LUMINOUS, RADIANT): "lm/W",
    (RADIANT, LUMINOUS): "W/lm",
    (PHOTON, RADIANT): "photon/J",
    (RADIANT, PHOTON): "J/photon",
    (LUMINOUS, PHOTON): "lm s/photon",
    (PHOTON, LUMINOUS): "photon/(lm s)",
}


def _most_lumens_per_photon() -> float:
    """The most that one wavelength gives [lm s]: no mixture of wavelengths gives more."""
    eye = OBSERVERS["photopic"]
    places = range(eye.start, eye.end + 1)
    shares = (v / nm for v, nm in zip(eye.values, places, strict=True))
    return eye.maximum * max(shares) * 1e9 * PLANCK * LIGHT


def given_ratio(given: Given, over: str, under: str) -> Factor | None:
    """A given efficacy as over / under, or None where it links two other kinds."""
    value = _positive(given)
    pairs = {dimension: pair for pair, dimension in RATIOS.items()}
    pair = pairs[given.dimension]
    if pair in ((LUMINOUS, RADIANT), (RADIANT, LUMINOUS)):
        efficacy = value if pair[0] == LUMINOUS else 1 / value
        limit = OBSERVERS["photopic"].maximum
        if maths.any_true(efficacy > limit * (1 + 1e-12)):
            raise ConditionError(
                f"--efficacy {quote(given.text)} is not possible: no light gives more than "
                f"{limit:g} lm/W",
                "an efficacy of up to 683lm/W",
            )
    if LUMINOUS in pair and PHOTON in pair:
        per_photon = value if pair[0] == LUMINOUS else 1 / value
        most = _most_lumens_per_photon()
        if maths.any_true(per_photon > most * (1 + 1e-9)):
            raise ConditionError(
                f"--efficacy {quote(given.text)} is not possible: no light gives more than "
                f"{most * AVOGADRO * 1e-6:.4g} lm s/umol",
                "an efficacy of up to 147lm.s/umol",
            )
    text = f"an efficacy of {given.text}, as given"
    if pair == (over, under):
        return Factor("K", value, KIND_UNITS[over, under], text)
    if pair == (under, over):
        return Factor("(1/K)", 1 / value, KIND_UNITS[over, under], text)
    return None


AXIS_UNITS = {WAVELENGTH: "m", FREQUENCY: "Hz", WAVENUMBER: "cycle/m"}


def jacobian(of: Light | None, start: str, end: str) -> Factor:
    """From a density on one axis to the density on another.

    `of` may be None between frequency and wavenumber, where only c stands between.
    """
    if of is None:
        value = LIGHT if end == WAVENUMBER else 1 / LIGHT
        formula = "J = d nu / d sigma = c" if end == WAVENUMBER else "J = d sigma / d nu = 1/c"
        step = Step("density", formula, f"J = {show(value)}", "SI Brochure: exact c")
        said = "wavenumber in vacuum, 1 cycle per wavelength"
        return Factor("J", value, _per_axis(start, end), said, (step,))
    per_frequency = {WAVELENGTH: of.vacuum**2 / LIGHT, FREQUENCY: 1.0, WAVENUMBER: 1 / LIGHT}
    value = per_frequency[start] / per_frequency[end]
    greek = {WAVELENGTH: "lambda", FREQUENCY: "nu", WAVENUMBER: "sigma"}
    forms = {
        (WAVELENGTH, FREQUENCY): "lambda^2 / c",
        (FREQUENCY, WAVELENGTH): "c / lambda^2",
        (WAVELENGTH, WAVENUMBER): "lambda^2",
        (WAVENUMBER, WAVELENGTH): "1 / lambda^2",
    }
    step = Step(
        "density",
        f"J = |d {greek[start]} / d {greek[end]}| = {forms[start, end]}",
        f"J = {show(value)} at {show(of.vacuum * 1e9)} nm",
        "E_nu = E_lambda lambda^2 / c",
    )
    assumption = f"spectral density at {of.given.text}"
    if of.given.dimension == LENGTH:
        assumption += "; " + VACUUM.format(of.given.text)
    return Factor("J", value, _per_axis(start, end), assumption, (step,))


def _per_axis(start: str, end: str) -> str:
    return f"{AXIS_UNITS[start]}/({AXIS_UNITS[end]})"


def bandwidth(given: Given, of_kind: Given | None) -> Factor:
    """The width of a band [m, Hz or cycle/m], in which a kind may be taken at one wavelength."""
    axis = band_axis(given)
    width = _positive(given)
    if axis == WAVELENGTH:
        _require(given, not maths.any_true(width > 1e-3), "at most 1 mm: a band of wavelengths")
    said = f"constant over a band of {given.text}"
    if of_kind is not None and of_kind.option.name == "wavelength":
        said += f", in which everything is taken as at {of_kind.text}"
    return Factor("B", width, AXIS_UNITS[axis], said)


def band_axis(given: Given) -> str:
    """Whether a band's width is in wavelength, frequency or wavenumber."""
    return next(axis for axis in AXIS if axis != NONE and AXIS[axis] == given.dimension)
