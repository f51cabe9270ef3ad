"""Every hint of a refusal leads to an answer when it is followed."""

import re
import shlex
from pathlib import Path

import pytest
from following import call, is_prose, liars, may_be_prose
from helpers import for_each, shell
from test_cases import FILES, transcripts
from test_refusals import COMMANDS, CONVERSIONS, STREAMS

EXAMPLES = Path(__file__).parent.parent / "examples"


def conversion(source, target, conditions):
    given = [f"--{k}" if v is True else f"--{k}={v}" for k, v in conditions.items()]
    return ["convert", "1", source, target, *given]


def corpus():
    """Yield the words of all refused calls in the tests."""
    yield from (conversion(*row[:3]) for row in CONVERSIONS.values())
    yield from (row[0].split() for row in COMMANDS.values())
    yield from (["convert", "-", *row[0]] for row in STREAMS.values())
    for path in FILES:
        for command, output in transcripts(path):
            if "\ntry: " in output and not set("|<>;$") & set(command):
                yield shlex.split(command)[1:]


@pytest.fixture(autouse=True)
def _aside(tmp_path, monkeypatch):
    """Run in a folder that has the files read by the calls and takes those written by hints."""
    (tmp_path / "examples").symlink_to(EXAMPLES)
    monkeypatch.chdir(tmp_path)


CALLS = {" ".join(words)[:90]: words for words in corpus()}
FIRST_WORDS = sorted({words[0] for words in CALLS.values()})


@pytest.mark.parametrize("first", FIRST_WORDS)
def test_a_hint_leads_to_an_answer(first):
    calls = [words for words in CALLS.values() if words[0] == first]
    found = [line for words in calls for line in liars(words)]
    assert not found, "\n".join(found)


MOST_PROSE = 0.05  # of all refused calls


def test_few_hints_are_sentences():
    refused = [(words, call(words)) for words in CALLS.values()]
    prose = [(words, outcome.error) for words, outcome in refused if is_prose(outcome)]
    needless = [
        f"{shlex.join(words)}: {error}" for words, error in prose if not may_be_prose(error)
    ]
    assert len(needless) <= MOST_PROSE * len(refused), "\n".join(needless)


VALUE = re.compile(r"(?<![\w.^])(?<![A-Za-z]-)\d+\.?\d*(?:e[-+]?\d+)?")  # not that of m2 or cm-1
OF_PAR = {400.0, 700.0}  # nm: the range of PAR is a definition
OF_FORM = {0.0, 1.0}  # in a plane; in 1/x and (1 + 10%)
NOTATIONS = ("ND", "0x")  # of numbers that are not moved


def values(words):
    return {float(number) for word in words for number in VALUE.findall(word)}


def moved(words):
    """Return the words of a call with other numbers, each by a few per cent."""
    return [VALUE.sub(lambda number: f"{float(number[0]) * 1.03:.5g}", word) for word in words]


def test_a_value_that_the_user_did_not_type_is_an_example_or_follows_from_what_was_typed():
    """A value that follows moves with the typed numbers; one that stays was made up."""
    marked, made_up = 0, []
    for words in CALLS.values():
        if any(word.startswith(NOTATIONS) for word in words):
            continue
        for proposed, answer in call(words).proposed:
            own = {word for word in proposed if values([word]) - values(words) - OF_PAR - OF_FORM}
            marked += bool(own) and "example" in answer
            if not own or "example" in answer:
                continue
            again = [other for other, _ in call(moved(words)).proposed]
            if stays := own & {word for other in again for word in other}:
                made_up.append(f"{shlex.join(words)}: {shlex.join(proposed)} ({stays})")
    assert not made_up, "\n".join(made_up)
    assert marked > 150


# words of a command, a part of the hint that fits the request
MEANT = [
    ("convert 500 lx umol/m2/s --efficacy 0.0185", "--efficacy 0.0185umol/lm/s"),
    ("convert 500 lx umol/m2/s --efficacy 54", "--efficacy 54lm.s/umol"),
    ("convert 500 lx ppfd --efficacy 54", "--efficacy 54lm.s/umol"),
    ("convert 1 W/m2 ppfd --wavelength 900nm", "1 W/m2 photon-irradiance --wavelength 900nm"),
    ("convert 100 lx iluminance", "illuminance"),
    ("convert 100 lx intensity", "cd"),
    ("convert 1 sr projected-solid-angle", "radcalc solid-angle --help"),
    ("units osvetlenst", "osvětlenost"),
    ("convert 5 W umol/s --efficacy 2.7", "--efficacy 2.7umol/J"),
    ("convert 5 W umol/s --efficacy 2.7 umol/J", "2.7umol/J"),
    ("convert 5 W lm --efficacy 93", "--efficacy 93lm/W"),
    ("convert 100 cd lx --distance 2 ft", "2ft"),
    ("convert 1.000,5 lx fc", "1000.5"),
    ("convert 100 cd lx --distance 1,2,5", "--distance 1m,2m,5m"),
    ("convert 100 cd lx --distance 1:5:2", "--distance 1m:5m:2m"),
    ("5 to fc", "radcalc 5 lx to fc"),
    ("7 cd to", "radcalc 7 cd\n"),
    # 3630.78 Jy 10^-2: Oke and Gunn 1983
    ("5 mag Jy", "radcalc 5 ABmag Jy\n     36.3078 Jy, if it is an AB magnitude"),
    ("5 Jy Vmag", "radcalc 5 Jy ABmag\n     7.15257 ABmag"),
    ("convert 5 mag Jy --wavelength 555nm", "radcalc convert 5 ABmag Jy\n     36.3078 Jy"),
    ("convert 22 mag/arcsec2 MJy/sr", "22 ABmag/arcsec2 MJy/sr\n     0.244822 MJy/sr"),
    ("12 EV W/m2", "12 EV W/m2 --spectrum sun\n     93.55"),  # 2.5 lx 2^12 / (109.455 lm/W)
    ("10 dBm uW mW", "radcalc convert 10 dBm uW,mW\n     10000 uW, 10 mW"),
    ("2^3^2 lx fc", "radcalc 2^9 lx fc"),
    ("convert 100 cd lx --dist 2m", "--distance 2m\n     25 lx"),
    ("convert 500 lx fc --reflectance 80%", "radcalc convert 500*0.8 lx fc"),
    ("convert 400 umol/m2/s mol/m2/day --time 12h", "mol/m2, in all of that time"),
    ("convert 60 W kW --time 2h", "J, in all of that time"),
    ("convert 500 lx fc --time 2h", "lm.s/m2, in all of that time"),
    ("convert 555 mm GHz", "radcalc photon 555mm -g frequency:GHz"),
    ("convert 2 eV m", "radcalc photon 2eV -g wavelength:m"),
    ("convert 30 deg sr", "radcalc solid-angle cone --half-angle 30deg"),
    ("calorimeter --mass 1kg --specific-heat 385J/kg/°F --temperature-rise 2K", "K: a step"),
    ("convert 25 ℃ K", "25 °C is 298.15 K"),
    ("convert 77 degF K", "77 °F is 298.15 K"),
    # h c / 2.2 eV = 563.564 nm in vacuum; 30 meV are 30/2200 of it; 30 meV / h = 7.25397 THz
    ("spectrum gaussian:2.2eV,30meV", "gaussian:563.408nm,7.685nm"),
    ("spectrum gaussian:550nm,10THz", "gaussian:550nm,10.09nm"),
    ("spectrum line:2.2eV", "563.408nm"),
    ("3 W/m2/nm W/m2/eV", "--wavelength 555nm\n     745.317 W/m2/eV, --wavelength 555nm is an"),
    ("3 W/m2/eV W/m2", "--bandwidth 10meV\n     0.03 W/m2, --bandwidth 10meV is an example"),
    ("lambertian --illuminance 500lx --reflectance 0.8", "--incident-irradiance 500lx for the"),
    ("point-source --flux 5W --distance 2m -g illuminance", "--spectrum sun\n     10.88"),
    ("calorimeter --mass 1kg", "--specific-heat with --temperature-rise"),
    ("lambertian disc --flux 5lm -g irradiance", "--radius with --distance"),
    ("point-source --intensity 5cd -g exposure", "--distance with --time"),
    ("cone --half-angle 30deg", "radcalc solid-angle cone"),
    ("camera --f-number 2.8", "radcalc ev --f-number 2.8"),
    ("lux", "radcalc units lux"),
    ("luminous flux", "radcalc quantities 'luminous flux'"),
    ("osvětlenost", "radcalc quantities osvětlenost"),
    ("2*3", "radcalc convert 2*3 to 1"),
    ("(2+3)*4", "radcalc convert '(2+3)*4' to 1"),
    ("atan(0.5) deg", "sqrt, sin, cos, tan"),
    ("log(100) lx fc", "log10(100)"),
    ("ev --aperture 8", "radcalc ev --f-number 8"),
    ("ev --shutter 1/60", "radcalc ev --time 1/60"),
    ("ev --ISO 400", "--iso"),
    ("800 lm cd --angle 36deg", "radcalc 800 lm cd --apex-angle 36deg"),
    ("point-source --lumens 800lm", "radcalc point-source --luminous-flux 800lm"),
    ("lamp", "radcalc point-source --help"),
    ("-g", "radcalc --help"),
    ("convert 5600K+134mired K", "1/(1/(5600K) + 1/(134 mired))"),
    ("convert 500lx-1EV lx", "may be a factor or a shift"),
    ("spectrum D65 -g cri:%", "radcalc spectrum D65 -g cri\n     "),
    ("convert 400 umol/m2/s mol/m2/day --photoperiod 16h", "23.04 mol/m2"),  # 400 16 3600 / 1e6
    ("convert 23.04 mol/m2/d ppfd --photoperiod 16h", "radcalc convert 23.04 dli ppfd"),
    # 0.3016: colour.wavelength_to_XYZ(550) of colour-science
    ("spectrum line:550nm -g cct -g cri", "radcalc spectrum line:550nm -g x -g y\n     0.3016"),
    ("absent.ies", "the path of a file"),
    ("examples/downlght.ies", "radcalc examples/downlight.ies\n     intensity 420"),  # the file's
    ("100 lx absent.csv ppfd", "another word for absent.csv"),
    ("convert 5 micromol/s umol/s", "radcalc convert 5 umol/s umol/s\n     5 umol/s"),
    ("convert 5 kilolm lm", "radcalc convert 5 klm lm\n     5000 lm"),
    ("100 lx fc --quiet=5", "radcalc 100 lx fc --quiet\n     9.29"),  # 100 x 0.3048 x 0.3048
    ("100 lx fc -n=5", "radcalc 100 lx fc -n\n     9.29"),
    ("100 lx fc --format", "radcalc 100 lx fc --format plain\n     9.29"),
    # 100 lm / (4 pi sr)
    ("point-source --flux", "radcalc point-source --flux 100lm\n     intensity 7.95775 cd"),
    (
        "point-source --flux 100lm -g",
        "radcalc point-source --flux 100lm\n     intensity 7.95775 cd",
    ),
    ("point-source --f-number 2.8", "radcalc etendue --help\n     which has --f-number (also ev"),
    ("solid-angle cone --flux 5lm", "point-source, lambertian"),
    ("convert 1 cd lx --distance 1m:1e300m:2m", "at most 10000"),
    (f"convert 1 cd lx --distance {'1m,' * 10_000}2m", "at most 10000"),
    ("typical lx!!!", "radcalc typical"),
    ("quantities luminance?", "luminance"),
    # a sphere of 1 m whose surface is 50 cm away has its centre at 1.5 m
    ("lambertian sphere --luminance 1cd/m2 --radius 1m --distance 50cm", "--distance 1.5m"),
    ("lambertian --luminance 400cd/m2 --incident-illuminance 500lx", "--luminance 400cd/m2\n"),
    ("lambertian --luminance 800cd/m2 --radiance 1W/m2/sr", "lambertian --radiance 1W/m2/sr\n"),
    ("point-source --intensity 1cd --flux 7lm --distribution lobe", "--distribution cone"),
    ("point-source --intensity 100lm --distance 2m", "--flux 100lm"),
    ("point-source --distance 2 ft --intensity 100cd", "--distance 2ft"),
    ("point-source --distribution spot --flux 800lm", "--distribution lobe"),
    ("ev --luminance 10W/m2/sr", "convert 10W/m2/sr cd/m2 --spectrum"),
    ("mesopic --luminance 0.1lx --sp-ratio 2", "--luminance 0.1cd/m2"),
    ("photon 5s", "photon 0.2Hz"),
    ("solid-angle polygon 0,0,1 1,0,1 1,0,1 0,1,1", "polygon 0,0,1 1,0,1 0,1,1\n"),
    ("solid-angle polygon 0,0,1 2,0,1 0,1,1 1,2,1", "polygon 0,0,1 2,0,1 1,2,1 0,1,1\n"),
    ("solid-angle polygon 0,0 1,0,1 0,1,1", "polygon 0,0,1 1,0,1 0,1,1\n"),
    ("solid-angle cube --width 1m --length 1m --height 2m", "solid-angle rectangle"),
    ("solid-angle cone --half-angle 30deg --check solidangle=0.9sr", "--check solid-angle=0.9sr"),
    ("direction 30deg 45deg", "direction --polar 30deg --azimuth 45deg"),
    ("direction 1 2 3 --check 0.9", "try: radcalc direction 1 2 3 --check z=0.9"),
    ("direction 1m 1m 1", "direction 1m,1m,1m"),
    ("integrate cos(45)*z --sphere", "'cos(45*rad)*z'"),
    ("integrate 2cos(theta) --sphere", "'2*cos(theta)'"),
    ("integrate (x<1)and(y<0) --sphere", "'(x<1)*(y<0)'"),
    ("integrate z --sphere --unit lx", "--unit lx/sr"),
    ("environment sky:cloudy", "sky:overcast"),
    ("sky overcast --illuminance 4klx", "--horizontal-illuminance 4klx"),
    ("spectrum D65 -g luminance", "-g luminous-efficacy"),
    ("spectrum D65 -g illuminance", "-g luminous-efficacy"),
    ("spectrum blackbody:5000K -g photon-radiance", "-g radiance:umol/m2/s/sr"),
    ("spectrum gaussian:530nm,30nm -g cct", "-g x -g y"),
    # a half angle of 0.5 mrad is a full one of 1 mrad
    ("laser --flux 5mW --diameter 1mm --half-divergence 0.5mrad --distance 10m", "--divergence 1m"),
    ("spectrum D65 --range 400-700", "--range 400nm:700nm"),
    ("spectrum D65 --range 0.4-0.7um", "--range 0.4um:0.7um"),
    ("ev --time 125 --f-number 8", "try: radcalc ev --time 1/125s"),
    ("room --area 54m2 --luminaires 12 --flux 3klm --uf 0.6 --mf 0.8", "0.6 --maintenance 0.8"),
    ("sensor --photons 1000photon --qe 0.6", "--quantum-efficiency 0.6"),
    ("convert 400 umol/m2/s mol/m2 --hours 12h", "--time 12h"),
    ("lambertian --luminance 100cd/m2 --tilt 30deg", "lambertian --luminance 100cd/m2\n"),
]


@for_each(MEANT)
def test_a_hint_fits_the_request(line, part):
    outcome = call(line.split())
    assert outcome.error is not None
    message, hint = shell(outcome.error)
    hint = "\n".join([*outcome.hints, hint])
    assert part in hint, hint
    assert len(message) < 200
