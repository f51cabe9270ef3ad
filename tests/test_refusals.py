"""What has no answer is refused, and says why and what would do."""

import pytest
from conftest import run
from homework.questions import CONE, LUX

from radcalc.conversion.conditions import give
from radcalc.conversion.plan import plan
from radcalc.errors import ConditionError, RadcalcError
from radcalc.quantities.search import search
from radcalc.units.table import resolve

# source, target, conditions, part of the message, part of the hint
CORPUS = [
    ("lm", "cd", {}, "luminous flux (lm) to luminous intensity (cd): a solid angle is missing",
     "--isotropic, --half-angle ANGLE or --solid-angle OMEGA"),
    ("lx", "nit", {}, "a reflectance or a projected solid angle is missing", "--hemisphere"),
    ("W", "lm", {}, "a wavelength, a spectrum or an efficacy is missing", "--wavelength"),
    ("umol/m2/s", "lx", {}, "a wavelength, a spectrum or an efficacy is missing", "--efficacy"),
    ("lm", "lx", {}, "an area, or a solid angle and a distance, is missing", "--distance"),
    ("cd", "lx", {}, "a distance is missing", "--distance"),
    ("J", "W", {}, "a time is missing", "--time"),
    ("lx.s", "lx", {}, "a time is missing", "--time"),
    ("W/Hz", "J", {}, "a bandwidth and a time are missing", "--bandwidth"),
    ("Jy", "J/m2", {}, "a bandwidth and a time are missing", "--time"),
    ("W/m2/nm", "W/m2", {}, "a bandwidth is missing", "--bandwidth"),
    ("W/m2/nm", "W/m2/THz", {}, "a wavelength is missing", "--wavelength"),
    ("W/m2/nm", "lx/THz", {}, ": a wavelength is missing", "--wavelength"),
    ("lm/m", "lm", {}, "luminous flux per length (lm/m)", "the number times that length"),
    ("td", "cd", {}, "the pupil's diameter", "--pupil"),
    ("td", "cd/m2", {}, "the pupil's diameter is missing", "--pupil"),
    ("nm", "eV", {}, "no condition links them", "radcalc"),
    ("sr", "deg", {}, "no condition links them", "radcalc"),
    ("lm/W", "1", {}, "no condition links them", "radcalc"),
    ("lm", "lx", {"distance": "2m"}, "a solid angle is missing", "--isotropic"),
    ("lm", "cd", {"time": "1h"}, "--time has no use", "--isotropic"),
    ("lm", "cd", {"reflectance": "0.5"}, "--reflectance has no use", "--isotropic"),
    ("lm", "cd", {"isotropic": True, "distance": "2m"}, "--distance has no use", "without"),
    ("m", "ft", {"time": "1h"}, "--time has no use", "without --time"),
    ("cd", "lx", {"incidence": "45deg"}, "a distance is missing", "--distance"),
    ("W", "umol/s", {"wavelength": "500nm", "observer": "scotopic"}, "--observer has no use", ""),
    ("W", "lm", {"efficacy": "93lm/W", "observer": "scotopic"}, "--observer has no use", ""),
    ("lm", "cd", {"isotropic": True, "half-angle": "9deg"}, "contradict each other", "one of"),
    ("lm", "cd", {"half-angle": "9deg", "apex-angle": "18deg"}, "contradict", "one of"),
    ("W", "lm", {"wavelength": "555nm", "efficacy": "93lm/W"}, "contradict", "one of"),
    ("lm", "lx", {"radius": "1m", "area": "3m2"}, "contradict", "one of"),
    ("lx", "nit", {"reflectance": "0.5", "hemisphere": True}, "over-specified", "fewer"),
    ("lm", "lx", {"area": "1m2", "isotropic": True, "distance": "1m"}, "over-specified", "fewer"),
    ("nit", "lx", {"solid-angle": "1sr"}, "projected solid angle", "--half-angle"),
    ("nit", "lx", {"isotropic": True}, "projected solid angle", "--hemisphere"),
    ("nit", "lx", {"exponent": "1"}, "projected solid angle", "--hemisphere"),
    ("nit", "lx", {"half-angle": "91deg"}, "--half-angle 91deg is not possible", "90 deg"),
    ("nit", "lx", {"area": "1m2", "distance": "5m"}, "five times the size", "--radius"),
    ("nit", "lx", {"radius": "1m", "distance": "1m", "incidence": "60deg"}, "horizon", "smaller"),
    ("lm", "W", {"wavelength": "300nm"}, "nothing is seen at 300nm", "360nm to 830nm"),
    ("lm", "W", {"wavelength": "10um"}, "nothing is seen", "830nm"),
    ("lx", "cd", {"distance": "2m", "incidence": "90deg"}, "no light arrives", "below 90"),
    ("cd/m2", "lx", {"reflectance": "0"}, "no light arrives", "above 0"),
    ("lx", "cd/m2", {"reflectance": "1.01"}, "not possible", "from 0 to 1"),
    ("lx", "cd/m2", {"reflectance": "101%"}, "not possible", "from 0 to 1"),
    ("W", "lm", {"efficacy": "684lm/W"}, "not possible", "683lm/W"),
    ("W", "lm", {"efficacy": "2.1umol/J"}, "does not link radiant and luminous", "93lm/W"),
    ("cd", "lx", {"distance": "-2m"}, "not possible", "more than 0"),
    ("cd", "lx", {"distance": "0m"}, "not possible", "more than 0"),
    ("lm", "lx", {"area": "-1m2"}, "not possible", "more than 0"),
    ("lm", "cd", {"half-angle": "181deg"}, "not possible", "whole sphere"),
    ("lm", "cd", {"solid-angle": "13sr"}, "not possible", "4pi sr"),
    ("lm", "cd", {"beam-angle": "180deg"}, "not possible", "180 deg"),
    ("lm", "cd", {"exponent": "-1"}, "not possible", "0 or more"),
    ("cd", "lx", {"distance": "2"}, "--distance 2 has no unit", "2m"),
    ("W", "lm", {"wavelength": "555"}, "has no unit", "555nm"),
    ("cd", "lx", {"distance": "2s"}, "takes a length, not time (s)", "--distance 2m"),
    ("lm", "cd", {"area": "1m2", "distance": "1m"}, "a solid angle is missing", "--isotropic"),
    ("cd", "lm", {"radius": "1m", "distance": "1m"}, "a solid angle is missing", "--half-angle"),
    ("lm", "lx", {"radius": "1m", "distance": "3m"}, "missing; --radius has no use", "--isotropic"),
    ("nit", "cd", {"half-angle": "60deg", "distance": "1m"}, "an area or a reflectance is missing",
     "--area"),
    ("nit", "lx", {"distance": "1m"}, "the size of the source is missing", "--radius"),
    ("radlux", "cd/m2", {"reflectance": "0.5"}, "--reflectance has no use", "--hemisphere"),
    ("radlux", "cd", {"distance": "2m"}, "missing; --distance has no use", "--area"),
    ("nit", "lx", {"radius": "1m", "distance": "1m", "incidence": "90deg"}, "horizon", "smaller"),
    ("nit", "lx", {"radius": "1m", "distance": "1m", "incidence": "100deg"}, "horizon", "smaller"),
    ("W/Hz", "W/cm-1", {"wavelength": "555nm"}, "--wavelength has no use", "without"),
    ("umol/s", "lm", {"efficacy": "149lm.s/umol"}, "not possible: no light gives more", "147"),
    ("lm/m", "lm", {"bandwidth": "5m"}, "not possible", "1 mm"),
    ("cd", "lx", {"distance": "1e200m"}, "beyond", "1e+100"),
    ("cd", "lx", {"distance": "1e-200m"}, "beyond", "1e-100"),
    ("lm", "cd", {"half-angle": "1sr"}, "takes an angle, not solid angle", "30deg"),
    ("lx", "cd/m2", {"reflectance": "0,8"}, "comma", "0.8"),
    ("W", "lm", {"wavelength": "-555nm"}, "not possible", "more than 0"),
]  # fmt: skip


@pytest.mark.parametrize(("source", "target", "conditions", "message", "hint"), CORPUS)
def test_a_refusal_says_what_and_what_to_do(source, target, conditions, message, hint):
    with pytest.raises(RadcalcError) as caught:
        plan(resolve(source), resolve(target), [give(k, v) for k, v in conditions.items()])
    assert message in caught.value.message
    assert hint in caught.value.hint


def test_a_refusal_of_a_condition_is_a_condition_error():
    with pytest.raises(ConditionError):
        plan(resolve("lm"), resolve("cd"), [give("isotropic", True), give("time", "1s")])


def refused(words: str) -> str:
    done = run(*words.split())
    assert done.returncode == 2, done.stdout
    assert done.stdout == ""
    assert "\ntry: " in done.stderr
    return done.stderr


@pytest.mark.parametrize(
    ("words", "parts"),
    [
        # too little: which quantities would do
        ("point-source --flux 800lm -g irradiance:lx", ["irradiance", "--distance"]),
        ("point-source --intensity 100cd -g exposure:lx.s", ["exposure"]),
        ("point-source --flux 800lm -g energy:lm.s", ["energy", "--time"]),
        ("point-source --distance 2m", ["--flux, --intensity or --irradiance"]),
        ("point-source --flux 800lm --offset 2m", ["--height"]),
        ("point-source --illuminance 25lx -g distance:m", ["distance", "--flux", "--intensity"]),
        ("lambertian --luminance 100cd/m2 -g flux:lm", ["flux", "--area"]),
        ("lambertian --incident-illuminance 500lx -g radiance:cd/m2", ["--reflectance"]),
        ("lambertian disc --luminance 9cd/m2 --radius 1m -g irradiance:lx", ["--distance"]),
        ("ev --iso 100", ["--ev100, --luminance, --illuminance or --f-number"]),
        ("calorimeter --mass 10g", ["--mass 10g", "without --mass"]),
        # contradictions: both values and the ratio; 800/(16 pi) = 15.9155, 20/15.9155 = 1.25664
        ("point-source --flux 800lm --distance 2m --illuminance 20lx",
         ["--illuminance 20lx", "15.9155 lx", "ratio 1.25664"]),
        ("point-source --flux 800lm --intensity 100cd",
         ["--flux 800lm", "1256.64 lm", "ratio 0.63662"]),
        ("lambertian --luminance 100cd/m2 --exitance 200lm/m2",
         ["--exitance 200lm/m2", "314.159 lm/m2", "ratio 0.63662"]),
        ("ev --ev100 15 --luminance 1000cd/m2", ["4096", "1000cd/m2"]),
        ("calorimeter --flux 5W --time 2s --energy 20J", ["10", "ratio 2"]),
        # impossible: the limit
        ("lambertian --luminance 400cd/m2 --incident-illuminance 500lx", ["2.51327"]),
        ("lambertian --incident-illuminance 500lx --reflectance 1.2", ["from 0 to 1"]),
        ("lambertian disc --luminance 10cd/m2 --radius 1m --illuminance 40lx",
         ["whole hemisphere"]),
        ("lambertian sphere --luminance 10cd/m2 --radius 1m --illuminance 40lx",
         ["whole hemisphere"]),
        ("calorimeter --energy 1J --mass 10g --specific-heat 385J/kg/K --temperature-rise 2K",
         ["absorptance above 1"]),
        ("calorimeter --energy 1J --absorptance 1.5", ["from 0 to 1"]),
        ("point-source --intensity 1cd --beam-angle 180deg", ["180 deg"]),
        ("point-source --intensity 1cd --half-angle 181deg", ["180 deg"]),
        ("point-source --intensity 1cd --apex-angle 361deg", ["360 deg"]),
        ("point-source --intensity 1cd --flux 7lm --distribution lobe", ["hemisphere"]),
        ("point-source --intensity 1cd --flux 13lm --distribution cone", ["sr"]),
        ("point-source --intensity 1cd --distance 1m --illuminance 2lx", ["contradicts", "ratio"]),
        ("point-source --intensity 1cd --distance -1m", ["more than 0"]),
        ("point-source --intensity 1cd --distance 1m --receiver-area 1m2",
         ["too large", "5.6419 m"]),
        ("lambertian --luminance 1cd/m2 --area 1m2 --distance 1m", ["five times", "1.12838 m"]),
        ("lambertian sphere --luminance 1cd/m2 --radius 1m --distance 50cm", ["radius"]),
        # of another calculator, kind or shape
        ("point-source --luminous-flux 5W", ["luminous flux"]),
        ("point-source --illuminance 5W/m2 --distance 1m", ["illuminance"]),
        ("point-source --flux 5W --illuminance 20lx", ["--wavelength, --spectrum or --efficacy"]),
        ("point-source --flux 5lm --luminous-flux 5lm", ["the same quantity"]),
        ("calorimeter --flux 5lm --time 1s", ["watts"]),
        ("point-source --flux 5lm --half-angle 9deg --exponent 3", ["--half-angle", "--exponent"]),
        ("point-source --flux 5lm --half-angle 9deg --distribution lobe", ["--half-angle"]),
        ("lambertian disc --luminance 9cd/m2 --width 1m", ["--width"]),
        ("lambertian disc --luminance 9cd/m2 --corner --radius 1m", ["--corner"]),
        ("lambertian cube --luminance 9cd/m2", ["cube"]),
        ("lambertian disc --luminance 9cd/m2 --radius 1m --diameter 2m --height 1m",
         ["--radius and --diameter"]),
        ("point-source --flux 1lm,2lm --distance 1m,2m", ["both lists"]),
    ],
)  # fmt: skip
def test_what_has_no_answer_is_refused_and_says_why(words, parts):
    said = refused(words)
    for part in parts:
        assert part in said, said


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ("solid-angle polygon 0,0,1 1,0,1 2,0,1", "no area"),
        ("solid-angle polygon 0,0,1 1,0,1 1,1,1.1 0,1,1", "not flat"),
        ("solid-angle polygon 0,0,1 1,0,1 1,0,1 0,1,1", "twice"),
        ("solid-angle polygon 0,0,1 1,0,1", "vertices"),
        ("solid-angle polygon 0,0 1,0,1 0,1,1", "2 coordinates"),
        ("solid-angle polygon 0,0,1,2 1,0,1 0,1,1", "4 coordinates"),
        ("solid-angle polygon nan,0,1 1,0,1 0,1,1", "nan"),
        ("solid-angle polygon 1,0,0 0,1,0 0,0,1 --normal 0,0,0", "normal"),
        ("solid-angle polygon 1,0,0 0,1,0 0,0,1 --viewpoint 1,0,0", "plane"),
        ("solid-angle sphere --radius 1m --distance 1m", "on or inside the sphere"),
        ("solid-angle disc --radius 1m --height 0m", "not possible"),
        ("solid-angle cone --half-angle nandeg", "nan"),
        ("solid-angle cone --half-angle 181deg", "not possible"),
        ("direction 1 1", "three coordinates"),
        ("direction 1 1 1 1", "three coordinates"),
        ("direction nan 0 1", "nan"),
        ("direction 0 0 0", "no direction"),
        ("etendue --area 1mm2 --na 1.5", "not possible"),
        ("etendue --area nanm2 --half-angle 10deg", "nan"),
        ("integrate x-x --sphere", "is 0"),
        ("integrate 1/(x-x) --sphere", "no value"),
        ("integrate x.real --sphere", "cannot stand"),
        ("integrate " + "x" + ".a" * 490 + " --sphere", "cannot stand"),
        ("integrate nan --sphere", "nan"),
    ],
)
def test_bad_input_ends_in_one_refusal(words, message):
    done = run(*words.split())
    assert done.returncode == 2
    assert done.stdout == ""
    assert message in done.stderr
    assert "Traceback" not in done.stderr


MISTAKES = [
    ((), "a unit to convert to is missing"),
    (("lx", "to"), "a unit to convert to is missing"),
    (("", "fc"), "a unit to convert to is missing"),
    (("lx", "fc", "nit"), "too many words"),
    (("lx", "in", "fc"), "does not separate units"),
    (("a", "to", "b", "to", "c"), "more than once"),
    (("-", "fc"), "more than one -"),
    (("lx", "W/m2", "--spectrum", "-"), "more than one -"),
    (("lx", "W/m2", "--spectrum", "-:2"), "more than one -"),
    (("lx", "cd"), "a distance is missing"),
    (("lx", "fc", "--distance", "1m"), "has no use"),
    (("cd", "lx", "--distance", "1m,2m"), "a list of conditions"),
    (("lx", "zork"), "unknown unit"),
    (("zork",), "unknown unit"),
    (("lx", "fc", "--steps"), "--steps is not for a stream"),
    (("lx", "fc", "--format", "csv"), "--format csv is not for a stream"),
    (("lx", "fc", "--format", "table"), "--format table is not for a stream"),
    (("lx", "fc", "--field", "0"), "not possible"),
    (("lx", "fc", "--field", "-0"), "not possible"),
    (("lx", "fc", "--field", "3-2"), "decreasing"),
    (("lx", "fc", "--field", "1,,2"), "not a list of fields"),
    (("lx", "fc", "--field", "x"), "not a list of fields"),
    (("lx", "fc", "--field", "9" * 99), "not possible"),
    (("lx", "fc", "-d", "ab"), "not one character"),
    (("lx", "fc", "-d", '"'), "not one character"),
    (("lx", "fc", "-d", "\n"), "not one character"),
    (("lx", "fc", "--field", "1", "--column", "E"), "contradict"),
    (("lx", "fc", "--column", "E"), "has no column 'E'"),
    (("fc", "--field", "1"), "--field needs --delimiter"),
    (("fc", "--column", "E"), "--column needs --delimiter"),
    (("lx", "fc", "--header=0"), "--header"),
    (("lx", "fc", "--header=x"), "--header"),
    (("lx", "fc", "--invalid", "stop"), "--invalid"),
]


@pytest.mark.parametrize(("words", "message"), MISTAKES, ids=[" ".join(w) for w, _ in MISTAKES])
def test_a_wrong_call_gets_one_clear_message(words, message):
    done = run("convert", "-", *words, input="5 zork\n" if words == ("zork",) else "a\n1\n")
    assert (done.stdout, done.returncode) == ("", 2)
    assert message in done.stderr
    assert done.stderr.startswith("radcalc: ")
    assert done.stderr.splitlines()[1].startswith("try: ")


@pytest.mark.parametrize(
    ("words", "part"),
    [
        (f"{CONE} --tolerance 3sf", "--tolerance has no use without --check"),
        (f"{LUX} --tolerance 3sf", "--tolerance has no use without --check"),
        (f"{CONE} --check 0.6sr -g solid-angle", "--check and --get contradict each other"),
        (f"{CONE},26deg --check 0.6sr", "--check takes one answer"),
        ("convert 100 cd lx --distance 1m,2m --check 25lx", "--check takes one answer"),
        ("point-source --intensity 9cd --distance 1m:3m:1m --check 1lx", "--check takes one"),
        ("spectrum blackbody:3000K,4000K --check x=0.4", "--check takes one answer"),
        ("photon 400nm,500nm --check 2eV", "--check takes one answer"),
        ("ev --ev100 1:400:1 --check 25lx", "--check takes one answer"),
        ("mesopic --luminance 0.1cd/m2,1cd/m2 --sp-ratio 2 --check 1cd/m2", "--check takes one"),
        ("convert 130 cd/m2 --check 5", "--check needs a unit to convert to"),
        ("convert 130 cd lx --check 5lx", "a distance is missing"),
    ],
)
def test_what_goes_not_with_check(words, part):
    done = run(*words.split())
    assert done.returncode == 2, done.stdout
    assert done.stdout == ""
    assert part in done.stderr


@pytest.mark.parametrize(
    ("text", "message", "hint"),
    [
        ("luminanse", "no quantity is called 'luminanse'", "luminance"),
        ("svitivsot", "no quantity is called", "svítivost"),
        ("яркасть", "no quantity is called", "яркость"),
        ("zork", "no quantity is called 'zork'", "radcalc quantities, which lists them all"),
        ("kg", "'kg' measures mass", "radcalc quantities"),
        ("%", "no quantity is called '%'", "radcalc quantities"),
        ("[]", "no quantity is called", "radcalc quantities"),
        ("[/bold]", "no quantity is called", ""),
        ("x" * 100_000, "no quantity is called", ""),
        ("lx " * 66, "no quantity is called", ""),
    ],
)
def test_what_is_not_found_is_refused_with_the_nearest_names(text, message, hint):
    with pytest.raises(RadcalcError) as refused:
        search(text)
    assert message in refused.value.message
    assert hint in refused.value.hint
    assert refused.value.hint
