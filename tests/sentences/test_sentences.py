"""Sentences: their answers and meanings, and refusals."""

import math
import re

import pytest
from conftest import ROOT, run
from following import call
from helpers import for_each

import radcalc
from radcalc.cli.spelling import pasted, typed
from radcalc.quantities.search import comparable
from radcalc.sentences.calls import call_of
from radcalc.sentences.phrases import FILLERS, MARKS, MEANINGFUL, PHRASES
from radcalc.sentences.reader import read

# h c / e in eV nm, with the exact constants of the SI (BIPM brochure, 9th edition, 2.2).
EV_NM = 6.62607015e-34 * 299792458 / 1.602176634e-19 * 1e9
FC = 0.3048**2  # lx in fc: 1 fc = 1 lm/ft2
# Four corners of a/c and b/c: F = 2/pi (A/W atan(B/W) + B/V atan(A/V)), W^2 = 1 + A^2 ...
A, B = 2.5 / 4, 1.5 / 4
W, V = math.sqrt(1 + A**2), math.sqrt(1 + B**2)
CORNERS = 4 / (2 * math.pi) * (A / W * math.atan(B / W) + B / V * math.atan(A / V))
# E = I / d^2, I = Phi / Omega, and N = K t / S of a light meter (ISO 2720).
ANSWERED = [
    ("20000 cd at 8 m to lx", 20000 / 8**2, "lx"),
    ("100 candela to lux 3 m", 100 / 3**2, "lux"),
    ("1200 lm isotropic to cd", 1200 / (4 * math.pi), "cd"),
    ("1500 lm over 100 m2 to fc", 1500 / 100 * FC, "fc"),
    ("800 lm 30 deg full cone to cd", 800 / (2 * math.pi * (1 - math.cos(math.radians(15)))), "cd"),
    ("how many lumens for a 15 m x 20 m office at 500 lux", 500 * 15 * 20, "lumens"),
    ("250000 cd how far for 1614 lux", math.sqrt(250000 / 1614), "m"),
    ("20 W laser 2 mm beam W/cm2", 20 / (math.pi * 0.1**2), "W/cm2"),
    ("f/5.6 1/60s ISO 100 to cd/m2", 12.5 * 5.6**2 * 60 / 100, "cd/m2"),
    ("EV 9 to lx", 2.5 * 2**9, "lx"),
    ("ev100 12 to nits", 2**12 / 8, "nits"),
    ("svítivost 80 cd, vzdálenost 2.4 m, plocha 600 cm2, kolik lm", 80 / 2.4**2 * 0.06, "lm"),
    ("25 лк на 2 м под углом 30 градусов сила света", 25 * 4 / math.cos(math.radians(30)), "cd"),
    ("photon energy 1064nm eV", EV_NM / 1064, "eV"),
    ("wavelength of 2 eV", EV_NM / 2, "nm"),
    ("ND 1.2 in %", 100 * 10**-1.2, "%"),
    ("0.9 ND to stops", 0.9 * math.log2(10), "1"),
    ("800 lx through ND 0.6 to lx", 800 * 10**-0.6, "lx"),
    ("--lux 200 fc", 200 * FC, "fc"),
    ("how many lux is 100 fc", 100 / FC, "lux"),
    ("600 ppfd 16.5/7.5 dli", 600e-6 * 16.5 * 3600, "mol/m2"),
    ("1000 cd/m2 5 m x 3 m height 4 m to lx", 1000 * math.pi * CORNERS, "lx"),
    ("500 lx from a 5 m x 3 m panel at 4 m to cd/m2", 500 / (math.pi * CORNERS), "cd/m2"),
    # the configuration factor of a rectangle from its centre: four corners of 2.5 m x 1.5 m
    ("1200 nits LED wall 5 m x 3 m at 4 m to lux", 1200 * math.pi * CORNERS, "lux"),
    ("600 ppfd 18/6 dli", 600e-6 * 18 * 3600, "mol/m2"),
    ("600 ppfd photoperiod 18 dli", 600e-6 * 18 * 3600, "mol/m2"),
    ("ppfd for dli 17 in 16 hours", 17e6 / (16 * 3600), "umol/m2/s"),
    ("wavelength of 5e14 Hz", 299792458 / 5e14 * 1e9, "nm"),
    ("solid angle of a cone 30° half angle", 2 * math.pi * (1 - math.cos(math.radians(30))), "sr"),
    (
        "solid angle of a cone with a full angle of 60 degrees",
        2 * math.pi * (1 - math.cos(math.radians(30))),
        "sr",
    ),
    ("400 J/m2 at 150 mW/m2 how long", 400 / 0.15, "s"),
    ("136 fc at 16 m, how much at 20 m", 136 * 16**2 / 20**2, "fc"),
    ("3 mW in a 1 mm spot to W/cm2", 3e-3 / (math.pi * 0.05**2), "W/cm2"),
    (
        "2000lm 100inch 16:9 gain 1.1 nits",
        2000 * 1.1 / math.pi / (2.54**2 * 16 * 9 / (16**2 + 9**2)),
        "nits",
    ),
    ("120mW beam diameter 0.8mm W/cm2", 0.12 / (math.pi * 0.04**2), "W/cm2"),
    ("mired shift 3092K 5600K", 1e6 / 5600 - 1e6 / 3092, "1/MK"),
    ("300 mW through OD 4 goggles to uW", 300e3 * 1e-4, "uW"),
    (
        "500 nit 65 inch 16:9 TV to lumens",
        500 * math.pi * (65 * 0.0254) ** 2 * 16 * 9 / (16**2 + 9**2),
        "lumens",
    ),
    ("dli 600 16h", 600 * 16 * 3600 / 1e6, "mol/m2"),
    ("peak wavelength of a 5778 K blackbody", 2.897771955e6 / 5778, "nm"),
    ("f/2.8 1/60 iso100 lx", 250 * 2.8**2 * 60 / 100, "lx"),  # E = C N^2 / (t S)
    ("GN 40m iso100 subject 5 m aperture", 40 / 5, "1"),
    ("8000 lx at 1 m, how far for 500 lx", 4, "m"),
    ("how far for 50 lux if 100 lux at 2 m", 2 * math.sqrt(2), "m"),
    ("20000 cd at 3 m at 30 deg to the wall lx", 20000 / 3**2 / 2, "lx"),  # sin 30 deg
    ("led 2.8 umol/J 320W tent 1.2m x 1.2m average ppfd", 2.8 * 320 / 1.44, "umol/m2/s"),
    ("24W/m led tape 100lm/W length 5m lumens", 24 * 100 * 5, "lumens"),
    ("2400 lux minus 3 stops to lux", 2400 / 2**3, "lux"),
    ("transmission of an OD 1.3 filter", 100 * 10**-1.3, "%"),
    ("f-stop 1000 lux ISO 800 1/50 s", math.sqrt(1000 * 800 / 50 / 250), "1"),  # E = C N^2 / (t S)
    ("ISO 1000 lux f/2.8 1/50 s", 250 * 2.8**2 * 50 / 1000, "1"),
    ("efficacy 1700 umol/s 645 W", 1700 / 645, "umol/J"),
    ("500 nits hemisphere to lx", 500 * math.pi, "lx"),  # pi sr projected, not 2 pi sr
    ("1 mW 650 nm laser 1 mm beam to W/cm2", 1e-3 / (math.pi * 0.05**2), "W/cm2"),
    ("EV 100 fc", math.log2(100 / FC / 2.5), "EV"),
    ("ND64 in stops", 6, "1"),
    ("800 lm in a hemisphere to cd", 800 / (2 * math.pi), "cd"),
    ("800 lm hemisphere at 2 m to lx", 800 / (2 * math.pi) / 4, "lx"),
    ("100 lm lambertian source to cd", 100 / math.pi, "cd"),
    ("500 lx 80% to cd/m2", 0.8 * 500 / math.pi, "cd/m2"),
    ("field angle 3.5m wide pool at 9 m throw", math.degrees(2 * math.atan(3.5 / 18)), "deg"),
    ("DLI 40 over 12h, what PPFD", 40e6 / (12 * 3600), "umol/m2/s"),
    ("15x20 ft 500 lux lm", 500 * 15 * 20 * 0.3048**2, "lm"),
    ("how many 4000 lm panels for 500 lux in 120 m2, CU 0.7 LLF 0.8", 15 / 0.56, "1"),
    ("E=3.1eV lambda", EV_NM / 3.1, "nm"),
    ("5778K peak wavelength", 2.897771955e6 / 5778, "nm"),
    ("what OD 5 W/cm2 2.5 mW/cm2", math.log10(2000), "OD"),
]


@for_each(ANSWERED)
def test_a_sentence_is_answered(sentence, value, unit):
    done = run(*sentence.split())
    number, _, shown = done.stdout.rstrip("\n").partition("\t")
    assert float(number) == pytest.approx(value, rel=1e-8), done.stderr
    assert shown in (unit, "")
    assert "read as: radcalc " in done.stderr


@for_each(ANSWERED)
def test_python_takes_the_same_sentence(sentence, value, unit):
    answer = radcalc.ask(sentence)
    assert float(getattr(answer, "magnitude", answer)) == pytest.approx(value, rel=1e-8)


@pytest.mark.parametrize(
    "sentence",
    [*(sentence for sentence, *_ in ANSWERED), "20000 cd at 8 m", "100 lx", "5 lx ¤ fc"],
)
def test_a_sentence_has_the_same_bytes_with_click_and_without_it(sentence, monkeypatch):
    without = run(*sentence.split())
    monkeypatch.setattr("radcalc.cli.lane.answer", lambda words: None)
    with_click = run(*sentence.split())
    assert vars(with_click) == vars(without)


# The calls that sentences mean, as WORDS of a command.
MEANT = [
    ("20000 cd at 8 m", "point-source --intensity 20000cd --distance 8m"),
    ("20000 cd at 8 m to lx", "point-source --intensity 20000cd --distance 8m -g illuminance:lx"),
    ("5 mW lm 632.8nm", "convert 5 mW lm --wavelength 632.8nm"),
    ("15500 lux W/m2 with D65", "convert 15500 lux W/m2 --spectrum D65"),
    ("1/250 s f/8 iso 200", "ev --time 1/250s --f-number 8 --iso 200"),
    ("2000 lm on a 100 inch 16:9 screen", "screen --flux 2000lm --diagonal 100inch --aspect 16:9"),
    ("300 lx + 20 fc", "convert '300 lx + 20 fc'"),
    ("20 mol/m2 per day", "convert 20 'mol/m2 per day'"),
    ("65 in diagonal 500 lm", "screen --diagonal 65in --flux 500lm"),
    ("800 lm led at 2 m", "point-source --flux 800lm --distance 2m"),
    ("75 lm led bulb to umol/s", "convert 75 lm umol/s --spectrum led"),
    ("d=2m I=100cd", "point-source --distance 2m --intensity 100cd"),
    ("400 umol/m2/s 3000K white led lux", "convert 400 umol/m2/s lux --spectrum LED-B2"),
    ("450umol 18h dli", "convert '450 ppfd' dli --time 18h"),
]


@for_each(MEANT)
def test_a_sentence_means_a_command(sentence, command):
    assert pasted([*typed(call_of(read(sentence.split())))]) == f"radcalc {command}"


# Words, and parts of the message and of the hint.
REFUSED = [
    (
        "how many lumens for a 5 m x 3 m room at 500 lux with height 2.5 m",
        "may be even",
        "radcalc convert 500lux lumens --area '5m*3m'",
    ),
    ("500 lx through ND 8 to lx", "a density or a factor", "radcalc convert '500 lx * (1/8)' lx"),
    (
        "exitance 500 lm/m2 reflectance 0.5 to cd/m2",
        "may fall on the surface or leave it",
        "radcalc convert 500 lm/m2 cd/m2 --reflectance 0.5",
    ),
    ("10 S to ms", "unknown unit 'S'", "radcalc 10 s to ms"),
    ("60 bulb to lm", "unknown unit 'bulb'", ""),
    ("mired of 5600", "unknown command 'mired'", ""),
    ("500 ppfd 18/8 dli", "too many words", ""),
    ("100 cd at 2 MM to lx", "not understood: MM", "radcalc 100 cd at 2 mm to lx"),
    (
        "150 lm/W hps to umol/J",
        "a spectrum links the light",
        "radcalc convert '150lm/W*1W' umol/s --spectrum hps",
    ),
    ("f/4 shutter 50 iso 800 to lux", "the unit of --time 50 is missing", "--time 1/50s"),
    (
        "150000 cd at 12 m to lux and foot-candles",
        "asks for several results",
        "-g illuminance:lux,illuminance:foot-candles",
    ),
    ("8 ND to stops", "--nd 8 is ambiguous", "radcalc ev --nd ND8 -g stops"),
    ("5600 CCT to mired", "no command takes 5600 CCT", ""),
    ("800 ISO to stops", "the light or the setting of the camera is missing", ""),
    (
        "19 degree field angle at 15 m to diameter",
        "the field and the beam have two diameters",
        "--apex-angle 19degree --distance 15m -g beam-diameter",
    ),
    ("100 lx on grey card to nits", "the reflectance is missing", "--reflectance 0.18"),
    ("irradiance of 500 lx", "illuminance (lx) to irradiance (W/m2)", "--spectrum sun"),
    ("radiance of 100 cd/m2", "luminance (cd/m2) to radiance (W/m2/sr)", "--spectrum sun"),
    (
        "luminous exitance of 500 lx reflectance 0.8",
        "may fall on the surface or leave it",
        "radcalc convert 500 lx 'luminous exitance' --reflectance 0.8",
    ),
    ("solid angle of the moon 0.5 degrees", "has 2 readings", "cone --apex-angle 0.5degrees"),
    ("5 mw at 532 nm to lm", "not understood: mw", "radcalc 5 mW at 532 nm to lm"),
    (
        "luminous efficacy at 532 nm",
        "light of one wavelength has an efficacy",
        "radcalc photon 532nm -g luminous-efficacy:lm/W",
    ),
    ("full moon", "not understood: full", "radcalc typical full moon"),
    ("24 degree beam 800 lm to cd", "2 readings", "--beam-angle 24degree"),
    ("800 lm 30 deg cone at 5 m lux", "2 readings", "--apex-angle 30deg"),
    ("60 W led at 2 m", "electrical or of its light", "--flux 60W"),
    ("500 lx to nits on white", "the reflectance is missing", "--reflectance 0.8"),
    (
        "20000 cd at 8 m roughly to lx",
        "understood 20000 cd, at 8 m, lx; not understood: roughly",
        "",
    ),
    ("100 cd 2 m 3 m lx", "fill one place", ""),
    ("100 lx at 450", "no command takes", ""),
    ("1 sun to lux", "unknown unit 'sun'", ""),
    ("luminance of white paper at 500 lx", "the reflectance is missing", "--reflectance 0.8"),
    ("100 lx 2 m 3 m", "fill one place", ""),
    ("what ISO for f/4 at 1/100", "", ""),
    ("red led 5 W lumens", "not understood: red", ""),
    ("100 lm over 4 pi", "not understood: pi", ""),
    ("10 to 20 lx", "", ""),
    ("100 lx A", "", ""),
    ("1 candle lx at 1 m", "'candle' is not accepted as a unit", "candela"),
    ("covnert 5 lx fc", "unknown command 'covnert'", "radcalc convert 5 lx fc"),
    ("138 cd at 1,5 m", "has a comma in its number", "1.5 m"),
    ("malus 30 deg", "unknown command 'malus'", ""),
    ("circadian 100 lx D65", "", ""),
    ("photon 5s", "not time", ""),
    ("800 cd 3 m above at 30 deg to lx", "2 readings", "--height 3m"),
    ("iso 400 ev 9 f/4 how long", "2 readings", "--ev 9"),
    ("many 500 lm lamps over 3 m2 lx", "not understood: many", ""),
    ("1000 lm over 3 m2 to maximum lx", "lx is not a unit of maximum", ""),
    ("2 m radius 3 m distance to m2", "no command takes", ""),
    ("100 cd 2 m in", "", ""),
    ("nits 174 klx", "2 readings", ""),
    ("500 lx at 30 deg incidence reflectance 0.5 to nits", "2 readings", "--reflectance 0.5"),
    ("2.94 lx on 3 m2 333 cd luminous flux in klm", "2 readings", "received-flux"),
    ("800 lm 24 deg lobe to cd mean", "not understood: mean", ""),
    (f"{'30 deg ' * 20} 100 lm cd", "fill one place", ""),
    # what a sentence must not take for something else
    ("500 lx at 3 m moved back 1 m", "not understood: moved", ""),
    ("136 fc at 16 m how much 4 m away", "fill one place", ""),
    ("136 fc at 20 m from 16 m", "fill one place", ""),
    ("136 lx sun at 16 m how much at 20 m", "fill one place", ""),
    ("500 lx at 3 m with 30 cm lamp", "", ""),
    ("4 ft square 500 lx to lm", "", ""),
    ("5 mW over 2 mm W/m2", "not understood: over 2 mm", ""),
    ("intensity of a 5 mW laser at 2 m", "has a beam", "--apex-angle 30deg"),
    ("800 lm spotlight at 2 m lx", "has a beam", "--isotropic"),
    ("24 deg lobe 800 lm at 3 m at 12 deg lux", "2 readings", "--toward 12deg"),
    ("beam 2.4m wide throw 10m angle", "2 readings", "apex-angle"),
    ("60 W tungsten lm", "electrical or of its light", "--spectrum tungsten"),
    ("led 5 W to lm", "electrical or of its light", ""),
    ("400 W solar panel in lumens", "not understood: solar panel", ""),
    ("four 800 lm lamps over 20 m2 lx", "not understood: four", ""),
    ("800 lm not into 1 sr cd", "not understood: not", ""),
    ("500 lx nd 0.6 filter to lx", "no command takes", ""),
    ("sodium 500 lx ppfd", "not understood: sodium", ""),
    ("137 cd 61 to lm into 1 sr", "", ""),
    ("64 deg full angle 46 1 lm to kcd", "", ""),
    ("24 deg x 12 deg 800 lm cd", "a field from edge to edge", ""),
    ("ev 12 2 stops to lx", "", ""),
    ("ND 64 in stops", "a density or a factor", "--nd ND64"),
    ("intensity 2.5 m from a 100 W source isotropic", "2 readings", "-g irradiance"),
    ("800 lm at 2 m intensity", "2 readings", "63.662 cd"),  # 800 / (4 pi), not 800 / (16 pi)
    ("EV f/5.6 1/125 ISO 800", "2 readings", "-g ev100"),
    ("EV of 500 lux at ISO 800", "2 readings", "10.6439"),  # log2(500 8 / 2.5)
    ("pool diameter 26 deg at 12 m", "readings", "5.54084 m"),  # 2 12 m tan(13 deg)
    ("1 mW 650 nm laser at 10 m to lux", "'laser' has a beam", "--apex-angle 30deg"),
    ("PAR64 2000 lm at 5 m to lx", "'PAR64' has a beam", "--apex-angle 30deg"),
    ("700 ppfd mercury fluorescent to lx", "lamps of this kind differ", ""),
    ("100 cd at 2 m 50% to lx", "may be a reflectance", "500*0.8 lx"),
    ("54 m2 500 lx 3600 lm", "a receiver or of a room", "--utilance 0.6\n"),
    ("room 54 m2 500 lx 3600 lm", "a receiver or of a room", "luminaires 12.5"),  # 54 500/3600/0.6
    ("how many fixtures 54 m2 500 lx 3600 lm", "needs further inputs", "--utilance 0.6"),
    ("4500 K led cri", "no LED of the CIE has about 4500 K", "LED-B4"),
    ("3000 K color", "", ""),
    ("lamps of 800 lm at 2 m", "no command takes", ""),
    ("wien 500 nm", "no command takes", ""),
    ("30 deg from glass to air index 1.5", "not understood: glass", "another word for glass"),
    ("f/2.8 1/125 s iso 100 nd 0.9 filter to lx", "no command takes", ""),
    ("1000 cd at 45 deg beam at 3 m to lx", "not understood: at 45 deg beam", ""),
    ("1000 cd lens 50 mm lx", "", ""),
    ("square 3 m wide pool 500 lm to lx", "not understood: square", ""),
    ("meter reads 500 lx through od 2 filter to lx", "the meter may be in front of the filter", ""),
    ("10 W 450 nm led to lm", "electrical or of its light", "--wavelength 450nm"),
    ("1000 W/m2 sun at 30 deg to W/m2", "the sun's height", ""),
    ("45.3 lx 425kcd 10klx illumination", "given twice", ""),
    ("isotropic to mcd 4lm 's mcd", "", ""),
    ("22 lx 38 deg fwhm incidence 1.2rad to lm at 0.9m at an angle of 65deg", "fill one place", ""),
    ("1 sun in mW per cm2", "unknown unit 'sun'", ""),
    ("dli 43.2 12h", "is ambiguous", "'43.2 dli'"),
    ("1 lx fc nit", "asks for several results: fc and nit", "radcalc convert 1 lx fc"),
]


@for_each(REFUSED)
def test_a_sentence_with_several_readings_or_none_is_refused(sentence, message, hint):
    done = run(*sentence.split())
    assert done.returncode == 2
    assert done.stdout == ""
    assert message in done.stderr
    assert hint in done.stderr


# Words that change an amount, or its meaning, in addition to those of the table.
MORE = "mean average peak maximum minimum total incident"


@for_each([*MEANINGFUL, *MORE.split()])
def test_a_word_that_changes_an_amount_is_not_ignored(word):
    assert comparable(word) not in FILLERS | MARKS


def test_an_input_with_a_result_of_its_own_is_asked_for_that():
    # The luminaire is a table of intensities; a flux within an angle is less than the whole.
    whole, within = ["examples/downlight.ies"], ["within", "30", "deg"]
    fluxes = [run(*words, "lm").stdout.split()[0] for words in (whole, [*whole, *within])]
    assert float(fluxes[1]) < float(fluxes[0])
    # A point of 105 cd at d = sqrt(I / E) from a disc of radius r, along its axis.
    distance = math.sqrt(105 / 195)
    inside = 2 * math.pi * (1 - distance / math.hypot(distance, math.sqrt(2 / math.pi)))
    received = run(*["195", "lx", "over", "2", "m2", "105", "cd", "to", "lm"]).stdout.split()[0]
    assert float(received) == pytest.approx(105 * inside, rel=1e-9)


def test_the_last_word_is_not_a_preposition():
    assert run(*["400", "J/m2", "at", "150", "mW/m2", "s"]).stdout == "2666.66666667\ts\n"
    assert call_of(read(["61.3", "lx", "as", "cd", "2", "m"]))[-1] == "get=luminous-intensity:cd"


@for_each([(phrase.pattern, phrase.fills) for phrase in PHRASES])
def test_every_phrase_fills_symbols_that_exist(pattern, fills):
    from radcalc.quantities.symbols import SYMBOLS
    from radcalc.sentences.phrases import COMMAND, FILTER, PERIOD, SHAPE, TARGET, UNKNOWN

    places = {COMMAND, FILTER, PERIOD, SHAPE, TARGET, UNKNOWN}
    assert {*fills} <= {*SYMBOLS, *places}, pattern


def test_a_conversion_in_words_has_the_bytes_of_the_quick_lane():
    assert run("100", "lx", "fc").stdout == "9.290304\tfc\n"
    assert run("100", "lx", "fc").stderr == ""


def test_options_of_the_output_go_with_a_sentence():
    assert call(["20000", "cd", "at", "8", "m", "to", "lx", "-n"]).output == "312.5\n"
    assert '"value": 312.5' in call(["20000", "cd", "at", "8", "m", "to", "lx", "--json"]).output
    assert (
        call(["20000", "cd", "at", "8", "m", "to", "lx", "--precision", "2", "-q"]).output
        == "3.1e+02\tlx\n"
    )


@for_each(
    [
        ("100 cd at 2 m to lx", "25lx", 0),  # E = I / d^2
        ("100 cd at 2 m to lx", "illuminance=50lx", 1),
        ("1200 lm isotropic to cd", "95.5cd", 0),  # I = Phi / (4 pi)
        ("100 cd at 2 m", "illuminance=25lx", 0),
    ]
)
def test_an_answer_to_a_sentence_is_checked(sentence, claim, status):
    for words in (["--check", claim], [f"--check={claim}"]):
        done = run(*sentence.split(), *words)
        assert done.returncode == status, done.stderr
        assert done.stdout.startswith("wrong" if status else "right")


def test_a_number_without_a_unit_is_not_lost():
    for sentence in ("100 lx at 450", "5 100 lx fc", "100 lx 7 fc"):
        assert run(*sentence.split()).returncode == 2, sentence


def test_a_refusal_in_python_proposes_calls_with_their_numbers():
    # A lobe of cos^n with cos^n(12 deg) = 1/2 has I = Phi (n + 1) / 2 pi sr; a cone has
    # I = Phi / 2 pi (1 - cos(12 deg)) sr.
    cos = math.cos(math.radians(12))
    lobe = 800 * (math.log(0.5) / math.log(cos) + 1) / (2 * math.pi)
    cone = 800 / (2 * math.pi * (1 - cos))
    with pytest.raises(radcalc.RadcalcError, match="2 readings") as caught:
        radcalc.ask("24 deg beam 800 lm to cd")
    calls = re.findall(r"(radcalc\.convert\(.*\))\n +(\S+) cd", str(caught.value))
    answers = {text: eval(text, {"radcalc": radcalc}).magnitude for text, _ in calls}
    assert sorted(answers.values()) == pytest.approx([lobe, cone])
    assert [float(number) for _, number in calls] == pytest.approx([*answers.values()], rel=1e-5)


# Sentences, and parts of the refusal in Python.
REFUSED_IN_PYTHON = [
    ("800 lm to cd", 'try: radcalc.convert("800 lm", "cd", isotropic=True)\n     63.662 cd'),
    ("800 lm isotorpic cd", 'try: radcalc.ask("800 lm isotropic cd")\n     63.662 cd'),
    ("examples/office.csv", "'points'"),
]


@for_each(REFUSED_IN_PYTHON)
def test_a_refusal_in_python_is_that_of_the_function_that_is_meant(sentence, text):
    with pytest.raises(radcalc.RadcalcError) as caught:
        radcalc.ask(sentence)
    assert text in str(caught.value)


def test_an_amount_alone_is_a_quantity_in_python():
    assert radcalc.ask("300 lx + 20 fc").to("lx").magnitude == pytest.approx(300 + 20 / FC)


def test_light_at_another_distance_states_its_law():
    done = run("136", "fc", "at", "16", "m,", "how", "much", "at", "20", "m")
    assert "assumed: a source small compared to both distances" in done.stderr


@for_each([("cri hps", "HPS -g cri"), ("cct of hps", "HPS -g cct"), ("led cri", "led -g cri")])
def test_a_lamp_alone_is_asked_for_its_colour(sentence, call):
    done = run(*sentence.split())
    assert done.returncode == 0, done.stderr
    assert f"read as: radcalc spectrum {call}".lower() in done.stderr.lower()


def test_a_file_is_asked_for_several_results():
    """884.328 lm is the zonal sum of the file, 420 cd its value on the axis."""
    done = run("examples/downlight.ies", "flux", "and", "intensity", cwd=ROOT)
    assert [line.split()[1] for line in done.stdout.splitlines()] == ["lm", "cd"]
    assert done.stdout.splitlines()[1].split()[0] == "420"


@pytest.mark.parametrize(
    "words",
    [
        "log.csv to dli --time-zone Europe/Berlin",
        "log.csv --time-zone Europe/Berlin to dli",
        "log.csv to dli --column PPFD --time-zone=Europe/Berlin",
    ],
)
def test_options_of_a_file_go_with_its_sentence(words, tmp_path, monkeypatch):
    """Two hours of 100 umol/m2/s are 0.72 mol/m2."""
    monkeypatch.chdir(tmp_path)
    rows = [f"2024-06-01 {hour:02}:00,100" for hour in (8, 9, 10)]
    (tmp_path / "log.csv").write_text("\n".join(["time,PPFD [umol/m2/s]", *rows]) + "\n")
    done = run(*words.split())
    assert done.stdout == "0.72\tdli\n"
    assert done.stderr.count("read as: radcalc dose log.csv") == 1
    assert "--time-zone Europe/Berlin" in done.stderr.replace("=", " ")


def test_the_name_of_a_file_is_never_changed(tmp_path, monkeypatch):
    """`klux` is a spelling of klx, and `=>` and `@` are marks of sentences."""
    monkeypatch.chdir(tmp_path)
    for name, value in (("klux.csv", 100), ("klx.csv", 900), ("a@b.csv", 200)):
        rows = [f"2024-06-01 {hour:02}:00,{value}" for hour in (8, 9)]
        (tmp_path / name).write_text("\n".join(["time,PPFD [umol/m2/s]", *rows]) + "\n")
        assert run(name, "to", "dli").stdout == f"{value * 3600 / 1e6:.12g}\tdli\n"
