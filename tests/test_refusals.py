"""Refusals of requests without an answer: the reason and the hint.

One table for each kind of request: the key describes the refusal, its row holds the request and
the parts of the message.
"""

import json

import pytest
from conftest import run
from helpers import for_each, shell

from radcalc.conversion.plan import plan
from radcalc.errors import ConditionError, RadcalcError
from radcalc.inputs.reading import read
from radcalc.quantities.search import search
from radcalc.units.table import resolve

# source, target, conditions, part of the message, part of the hint
CONVERSIONS = {
    "lumens to candelas need a solid angle": (
        "lm", "cd", {}, "luminous flux (lm) to luminous intensity (cd): a solid angle is missing",
        "--isotropic, --half-angle ANGLE or --solid-angle OMEGA"),
    "lux to nits need a reflectance or a projected solid angle": (
        "lx", "nit", {}, "a reflectance or a projected solid angle is missing", "--hemisphere"),
    "watts to lumens need a wavelength, a spectrum or an efficacy": (
        "W", "lm", {}, "a wavelength, a spectrum or an efficacy is missing", "--wavelength"),
    "photons to lux need a wavelength, a spectrum or an efficacy": (
        "umol/m2/s", "lx", {}, "a wavelength, a spectrum or an efficacy is missing", "--efficacy"),
    "lumens to lux need an area, or a solid angle and a distance": (
        "lm", "lx", {}, "an area, or a solid angle and a distance, is missing", "--distance"),
    "candelas to lux need a distance": (
        "cd", "lx", {}, "a distance is missing", "--distance"),
    "joules to watts need a time": ("J", "W", {}, "a time is missing", "--time"),
    "an exposure to an illuminance needs a time": (
        "lx.s", "lx", {}, "a time is missing", "--time"),
    "watts per hertz to joules need a bandwidth and a time": (
        "W/Hz", "J", {}, "a bandwidth and a time are missing", "--bandwidth"),
    "janskys to an exposure need a bandwidth and a time": (
        "Jy", "J/m2", {}, "a bandwidth and a time are missing", "--time"),
    "a density per nanometre to a total needs a bandwidth": (
        "W/m2/nm", "W/m2", {}, "a bandwidth is missing", "--bandwidth"),
    "a density per nanometre to one per terahertz needs a wavelength": (
        "W/m2/nm", "W/m2/THz", {}, "a wavelength is missing", "--wavelength"),
    "watts per nanometre to lux per terahertz need a wavelength": (
        "W/m2/nm", "lx/THz", {}, ": a wavelength is missing", "--wavelength"),
    "lumens per metre to lumens need a length": (
        "lm/m", "lm", {}, "luminous flux per length (lm/m)", "the number times that length"),
    "trolands to candelas need the pupil and more": (
        "td", "cd", {}, "the pupil's diameter", "--pupil"),
    "trolands to a luminance need the pupil's diameter": (
        "td", "cd/m2", {}, "the pupil's diameter is missing", "--pupil"),
    "electronvolts do not convert to metres under any condition": (
        "m", "eV", {}, "no condition links them", "radcalc"),
    "steradians do not convert to degrees under any condition": (
        "sr", "deg", {}, "no condition links them", "radcalc"),
    "an efficacy does not convert to a number under any condition": (
        "lm/W", "1", {}, "no condition links them", "radcalc"),
    "a time does not convert a daily dose to another rate": (
        "mol/m2/day", "umol/m2/s", {"time": "12h"}, "--time does not apply",
        "mol/m2, in all of that time"),
    "a distance alone is not enough from lumens to lux": (
        "lm", "lx", {"distance": "2m"}, "a solid angle is missing", "--isotropic"),
    "a time does not apply between lumens and candelas": (
        "lm", "cd", {"time": "1h"}, "--time does not apply", "--isotropic"),
    "a reflectance does not apply between lumens and candelas": (
        "lm", "cd", {"reflectance": "0.5"}, "--reflectance does not apply", "--isotropic"),
    "a distance does not apply from isotropic lumens to candelas": (
        "lm", "cd", {"isotropic": True, "distance": "2m"}, "--distance does not apply", "leave"),
    "a time does not apply between metres and feet": (
        "m", "ft", {"time": "1h"}, "--time does not apply", "leave out --time"),
    "an incidence without a distance is refused": (
        "cd", "lx", {"incidence": "45deg"}, "a distance is missing", "--distance"),
    "an observer does not apply between watts and photons": (
        "W", "umol/s", {"wavelength": "500nm", "observer": "scotopic"}, "--observer does not apply",
        ""),
    "an observer does not apply with an efficacy of photons": (
        "W", "umol/s", {"efficacy": "2umol/J", "observer": "scotopic"}, "--observer does not apply",
        ""),
    "an efficacy above the observer's maximum is refused": (
        "W", "lm", {"efficacy": "1701lm/W", "observer": "scotopic"},
        "no light gives more than 1700.06 lm_scot/W", "1700.06 lm_scot/W"),
    "isotropic light is not in a cone": (
        "lm", "cd", {"isotropic": True, "half-angle": "9deg"}, "contradicts", "leave out"),
    "an apex angle is twice the half angle": (
        "lm", "cd", {"half-angle": "9deg", "apex-angle": "19deg"}, "contradicts", "leave out"),
    "a lobe is not a cone": (
        "lm", "cd", {"half-angle": "9deg", "exponent": "3"}, "cannot be used with", "one of"),
    "a wavelength has its efficacy": (
        "W", "lm", {"wavelength": "555nm", "efficacy": "93lm/W"}, "93 lm/W is not 683.002 lm/W",
        "leave out"),
    "a spectrum has no wavelength": (
        "W", "lm", {"wavelength": "555nm", "spectrum": "D65"}, "cannot be used with", "one of"),
    "a radius gives the area": (
        "lm", "lx", {"radius": "1m", "area": "3m2"}, "3 m2 is not 3.14159 m2", "leave out"),
    "a hemisphere gives all of the light, a reflectance a part": (
        "lx", "nit", {"reflectance": "0.5", "hemisphere": True}, "0.31831 /sr is not 0.159155 /sr",
        "leave out"),
    "an area, and a distance in a solid angle, are more than enough": (
        "lm", "lx", {"area": "1m2", "isotropic": True, "distance": "1m"},
        "0.0795775 /m2 is not 1 /m2", "leave out"),
    "a solid angle is not a projected solid angle": (
        "nit", "lx", {"solid-angle": "1sr"}, "projected solid angle", "--half-angle"),
    "isotropic light has no projected solid angle": (
        "nit", "lx", {"isotropic": True}, "projected solid angle", "--hemisphere"),
    "an exponent does not give a projected solid angle": (
        "nit", "lx", {"exponent": "1"}, "projected solid angle", "--hemisphere"),
    "a cone wider than the hemisphere has no projected solid angle": (
        "nit", "lx", {"half-angle": "91deg"}, "--half-angle 91deg is out of range", "90 deg"),
    "an area nearer than five times its size is not a small source": (
        "nit", "lx", {"area": "1m2", "distance": "5m"}, "at least five times that", "--radius"),
    "a patch that may dip below the horizon is refused": (
        "nit", "lx", {"area": "1m2", "distance": "10m", "incidence": "86deg"}, "horizon",
        "--radius 0.56419m in place"),
    "lumens at 300 nm do not determine watts": (
        "lm", "W", {"wavelength": "300nm"}, "300nm is invisible", "360nm to 830nm"),
    "lumens at 10 um do not determine watts": (
        "lm", "W", {"wavelength": "10um"}, "is invisible", "830nm"),
    "light along the receiver's plane is refused": (
        "lx", "cd", {"distance": "2m", "incidence": "90deg"}, "no light arrives", "below 90"),
    "a reflectance of 0 is refused": (
        "cd/m2", "lx", {"reflectance": "0"}, "no light arrives", "above 0"),
    "a reflectance above 1 is out of range": (
        "lx", "cd/m2", {"reflectance": "1.01"}, "out of range", "from 0 to 1"),
    "a reflectance above 100 % is out of range": (
        "lx", "cd/m2", {"reflectance": "101%"}, "out of range", "from 0 to 1"),
    "an efficacy above 683 lm/W is out of range": (
        "W", "lm", {"efficacy": "684lm/W"}, "out of range", "683.002 lm/W"),
    "photons per joule do not link watts and lumens": (
        "W", "lm", {"efficacy": "2.1umol/J"}, "does not link radiant and luminous", "93lm/W"),
    "a negative distance is out of range": (
        "cd", "lx", {"distance": "-2m"}, "out of range", "more than 0"),
    "a distance of 0 is out of range": (
        "cd", "lx", {"distance": "0m"}, "out of range", "more than 0"),
    "a negative area is out of range": (
        "lm", "lx", {"area": "-1m2"}, "out of range", "more than 0"),
    "a half angle beyond the whole sphere is out of range": (
        "lm", "cd", {"half-angle": "181deg"}, "out of range", "at most 180 deg"),
    "a solid angle beyond the whole sphere is out of range": (
        "lm", "cd", {"solid-angle": "13sr"}, "out of range", "4pi sr"),
    "a beam angle of 180 degrees is out of range": (
        "lm", "cd", {"beam-angle": "180deg"}, "out of range", "180 deg"),
    "a negative exponent is out of range": (
        "lm", "cd", {"exponent": "-1"}, "out of range", "0 or more"),
    "a distance without a unit is refused": (
        "cd", "lx", {"distance": "2"}, "the unit of --distance 2 is missing", "2m"),
    "a wavelength without a unit is refused": (
        "W", "lm", {"wavelength": "555"}, "the unit of", "555nm"),
    "seconds are not a distance": (
        "cd", "lx", {"distance": "2s"}, "takes a length, not time (s)", "such as 2m"),
    "an area nearer than five times its size is not a small receiver": (
        "lm", "cd", {"area": "1m2", "distance": "1m"}, "size of the receiver is 1.12838 m, and",
        "--half-angle 29.4312deg in place"),
    "a radius nearer than five times its size is not a small receiver": (
        "cd", "lm", {"radius": "1m", "distance": "9m", "incidence": "9deg"},
        "size of the receiver is 2 m, and", "more distance"),
    "an incidence does not apply to a surface that a flux is spread over": (
        "lm", "lx", {"area": "1m2", "incidence": "60deg"}, "--incidence does not apply", "leave"),
    "an incidence does not apply to a luminous surface": (
        "radlux", "radlux", {"incidence": "60deg"}, "--incidence does not apply", "leave"),
    "a tilt does not apply to a small source": (
        "cd", "lx", {"distance": "1m", "tilt": "60deg"}, "--tilt does not apply", "leave out"),
    "a tilt of 90 degrees is refused": (
        "cd", "nit", {"area": "1m2", "tilt": "90deg"}, "no light arrives", "below 90"),
    "a wide solid angle has no single angle from the normal": (
        "nit", "lx", {"solid-angle": "1sr", "tilt": "60deg"}, "is too large for one --tilt",
        "--half-angle 32.7705deg in place"),
    "a tilted disc that is near is not in the far field": (
        "nit", "lx", {"radius": "1m", "distance": "2m", "tilt": "60deg"}, "five times", "more"),
    "a radius does not apply from lumens to lux at a distance": (
        "lm", "lx", {"radius": "1m", "distance": "3m"}, "missing; --radius does not apply",
        "--isotropic"),
    "a luminance to an intensity needs an area or a reflectance": (
        "nit", "cd", {"half-angle": "60deg", "distance": "1m"},
        "an area or a reflectance is missing", "--area"),
    "a luminance at a distance needs the size of the source": (
        "nit", "lx", {"distance": "1m"}, "the size of the source is missing", "--radius"),
    "a reflectance does not apply for an exitance": (
        "radlux", "cd/m2", {"reflectance": "0.5"}, "--reflectance does not apply", "--hemisphere"),
    "a distance does not apply from an exitance to an intensity": (
        "radlux", "cd", {"distance": "2m"}, "missing; --distance does not apply", "--area"),
    "a patch half below the horizon is refused": (
        "nit", "lx", {"area": "1m2", "distance": "10m", "incidence": "90deg"}, "horizon",
        "--radius 0.56419m in place"),
    "a patch mostly below the horizon is refused": (
        "nit", "lx", {"area": "1m2", "distance": "10m", "incidence": "-94deg"}, "horizon",
        "--radius 0.56419m in place"),
    "a wavelength does not apply between hertz and kaysers": (
        "W/Hz", "W/cm-1", {"wavelength": "555nm"}, "--wavelength does not apply", "leave out"),
    "an efficacy of 149 lumens per micromole per second is refused": (
        "umol/s", "lm", {"efficacy": "149lm.s/umol"}, "out of range: no light gives more", "147"),
    "light of 1 mm has 8359.35 umol/J": (
        "W/m2", "umol/m2/s", {"efficacy": "0.01mol/J"}, "no light gives more than 8359.35 umol/J",
        "up to 8359.35 umol/J"),
    "a bandwidth of metres is out of range": (
        "lm/m", "lm", {"bandwidth": "5m"}, "out of range", "1 mm"),
    "a huge distance is refused": (
        "cd", "lx", {"distance": "1e200m"}, "out of range", "1e+100"),
    "a tiny distance is refused": (
        "cd", "lx", {"distance": "1e-200m"}, "out of range", "1e-100"),
    "steradians are not a plane angle": (
        "lm", "cd", {"half-angle": "1sr"}, "takes an angle, not solid angle",
        "--solid-angle 1sr"),
    "a comma in a number is refused": ("lx", "cd/m2", {"reflectance": "0,8"}, "comma", "0.8"),
    "an illuminance is not an exitance without a reflectance": (
        "lx", "radlux", {}, "a reflectance is missing", "--reflectance"),
    "the exitance of a black surface does not determine its illuminance": (
        "radlux", "lx", {"reflectance": "0"}, "no light arrives", "above 0"),
    "a hemisphere with an area is ambiguous between candelas and lux": (
        "cd", "lm/m2", {"area": "1m2", "hemisphere": True}, "and the answers differ",
        "radcalc convert 1cd cd/m2 --area 1m2, and then --hemisphere"),
    "a cone with an area is ambiguous between watts per area and per steradian": (
        "W/m2", "W/sr", {"area": "1m2", "half-angle": "30deg"}, "and the answers differ",
        "radcalc convert 1W/m2 W --area 1m2, and then --half-angle 30deg"),
    "a negative wavelength is out of range": (
        "W", "lm", {"wavelength": "-555nm"}, "out of range", "more than 0"),
}  # fmt: skip


@for_each(CONVERSIONS.values())
def test_a_conversion_is_refused(source, target, conditions, message, hint):
    with pytest.raises(RadcalcError) as caught:
        plan(resolve(source), resolve(target), [read(k, v) for k, v in conditions.items()])
    said, mended = shell(caught.value)
    assert message in said
    assert hint in mended


def test_a_refusal_of_a_condition_is_a_condition_error():
    with pytest.raises(ConditionError):
        plan(resolve("lm"), resolve("cd"), [read("isotropic", True), read("time", "1s")])


# words of a command, parts of its output
COMMANDS = {
    "a call would drop the second number": ("10 to 20 lx", "20 lx", "radcalc help illuminance"),
    "photons from 400 nm to 700 nm have at most 5.85154 umol/J": (
        "convert 100 W/m2 ppfd --efficacy 2.1mol/J", "light gives 3.34374 to 5.85154 umol/J",
        "2.1umol/J"),
    "photons from 400 nm to 700 nm have at least 0.0808881 lm s/umol": (
        "convert 100 lx ppfd --efficacy 54lm.s/mol", "gives 0.0808881 to 147.805 lm s/umol",
        "54lm.s/umol"),
    # options before the command
    "a format before the command is refused with its place": (
        "--json convert 100 lx fc", "'--json' is before the command",
        "radcalc convert 100 lx fc --json"),
    "conditions before the command are refused with their place": (
        "--isotropic --distance 2m convert 800 lm lx", "'--isotropic' is before the command",
        "radcalc convert 800 lm lx --isotropic --distance 2m"),
    "a result before the command is refused with its place": (
        "-g irradiance:lx point-source --flux 800lm --distance 2m", "'-g' is before the command",
        "radcalc point-source --flux 800lm --distance 2m -g irradiance:lx"),
    "a distance before the command is refused with its place": (
        "--distance 2m point-source --flux 800lm", "'--distance' is before the command",
        "radcalc point-source --flux 800lm --distance 2m"),
    "an answer to check before the command is refused with its place": (
        "--check exitance=628lm/m2 lambertian --luminance 200cd/m2",
        "'--check' is before the command",
        "radcalc lambertian --luminance 200cd/m2 --check exitance=628lm/m2"),
    "an unknown option before the command is refused": (
        "--f-number 2.8 convert 100 lx fc", "convert has no --f-number option"),
    "an option alone is refused": ("-g", "radcalc has no -g option"),
    "two options alone are refused": ("-n -g", "radcalc has no -n option"),
    "an absent file is not a command": ("absent.ies", "there is no file 'absent.ies'"),
    "a file to write is not absent": ("labertian disc --save plot.csv", "unknown command"),
    "an absent file with its place": ("absent.ies at 3 m to lx", "there is no file 'absent.ies'"),
    "an absent file in a sentence": ("flux of absent.ies", "there is no file 'absent.ies'"),
    "a conversion has no option for the name of a result": (
        "convert 100 lx fc --get illuminance", "convert has no --get option", "-n"),
    "the help takes one command": (
        "help convert ev", "help takes one command", "radcalc convert --help"),
    "the help of an unknown command names the nearest": (
        "help covnert", "nothing has the words", "radcalc help convert"),
    # too little: quantities that would be enough
    "an irradiance needs a distance": (
        "point-source --flux 800lm -g irradiance:lx", "irradiance", "--distance"),
    "an exposure does not follow from an intensity alone": (
        "point-source --intensity 100cd -g exposure:lx.s", "exposure"),
    "an energy needs a time": ("point-source --flux 800lm -g energy:lm.s", "energy", "--time"),
    "a distance alone is not enough": (
        "point-source --distance 2m", "--intensity 100cd"),
    "an offset needs a height": ("point-source --flux 800lm --offset 2m", "--height"),
    "a distance does not follow from an illuminance alone": (
        "point-source --illuminance 25lx -g distance:m", "distance", "--flux", "--intensity"),
    "a luminance to a flux needs an area": (
        "lambertian --luminance 100cd/m2 -g flux:lm", "flux", "--area"),
    "the light of a reflector needs its reflectance": (
        "lambertian --incident-illuminance 500lx -g radiance:cd/m2", "--reflectance"),
    "the light of a disc needs its distance": (
        "lambertian disc --luminance 9cd/m2 --radius 1m -g irradiance:lx", "--distance"),
    "a film's speed alone is not enough": (
        "ev --iso 100", "or --f-number"),
    "an angle with only an illuminance needs further inputs": (
        "point-source --illuminance 100lx --half-angle 30deg --time 1h",
        "--half-angle 30deg needs further inputs", "--flux"),
    "a mass alone is unused": ("calorimeter --mass 10g", "--mass 10g", "--specific-heat"),
    # contradictions: both values and the ratio; 800/(16 pi) = 15.9155, 20/15.9155 = 1.25664
    "an illuminance that contradicts a flux at its distance is refused with the ratio": (
        "point-source --flux 800lm --distance 2m --illuminance 20lx", "--illuminance 20lx",
        "15.9155 lx", "ratio 1.25664"),
    "an intensity that contradicts an isotropic flux is refused with the ratio": (
        "point-source --flux 800lm --intensity 100cd", "--flux 800lm", "1256.64 lm",
        "ratio 0.63662"),
    "an exitance that contradicts its luminance is refused with the ratio": (
        "lambertian --luminance 100cd/m2 --exitance 200lm/m2", "--exitance 200lm/m2",
        "314.159 lm/m2", "ratio 0.63662"),
    "a luminance that contradicts its exposure value is refused with both": (
        "ev --ev100 15 --luminance 1000cd/m2", "4096", "1000cd/m2"),
    "an energy that contradicts a flux in its time is refused with the ratio": (
        "calorimeter --flux 5W --time 2s --energy 20J", "10", "ratio 2"),
    # out of range: the limit
    "a luminance that no reflector can reach is refused with the reflectance that it needs": (
        "lambertian --luminance 400cd/m2 --incident-illuminance 500lx", "2.51327"),
    "a reflectance of 1.2 is refused with its limits": (
        "lambertian --incident-illuminance 500lx --reflectance 1.2", "from 0 to 1"),
    "a disc is limited to the hemisphere": (
        "lambertian disc --luminance 10cd/m2 --radius 1m --illuminance 40lx", "whole hemisphere"),
    "a sphere is limited to the hemisphere": (
        "lambertian sphere --luminance 10cd/m2 --radius 1m --illuminance 40lx",
        "whole hemisphere"),
    "a body that absorbs more than the incident light is refused": (
        "calorimeter --energy 1J --mass 10g --specific-heat 385J/kg/K --temperature-rise 2K",
        "more heat than light"),
    "an absorptance of 1.5 is refused with its limits": (
        "calorimeter --energy 1J --absorptance 1.5", "from 0 to 1"),
    "a beam angle of 180 degrees has no exponent": (
        "point-source --intensity 1cd --beam-angle 180deg", "180 deg"),
    "a half angle is at most 180 degrees": (
        "point-source --intensity 1cd --half-angle 181deg", "180 deg"),
    "an apex angle is at most 360 degrees": (
        "point-source --intensity 1cd --apex-angle 361deg", "360 deg"),
    "a lobe is limited to the flux of a hemisphere": (
        "point-source --intensity 1cd --flux 7lm --distribution lobe", "hemisphere"),
    "a cone is limited to the flux of a sphere": (
        "point-source --intensity 1cd --flux 13.0lm --distribution cone", "sr"),
    "an illuminance that contradicts an intensity at its distance is refused with the ratio": (
        "point-source --intensity 1cd --distance 1m --illuminance 2lx", "contradicts", "ratio"),
    "a source at a negative distance is refused": (
        "point-source --intensity 1cd --distance -1m", "more than 0"),
    "a tilted receiver that a lobe lights unevenly is refused": (
        "point-source --intensity 1cd --beam-angle 9deg --distance 1m --receiver-area 1m2 "
        "--incidence 5deg", "varies by more than 1 %", "--receiver-area 1m2\n"),
    "a tilted receiver that the cone's edge may cross is refused": (
        "point-source --flux 9lm --half-angle 5deg --distance 1m --receiver-area 1m2 "
        "--incidence 5deg", "edge may cross", "--receiver-area 1m2\n"),
    "a source that is too near for its size is refused with the size": (
        "lambertian --luminance 1cd/m2 --area 1m2 --distance 1m", "five times", "1.12838 m"),
    "a receiver inside a sphere is refused": (
        "lambertian sphere --luminance 1cd/m2 --radius 1m --distance 50cm", "radius"),
    # of another calculator, kind or shape
    "a height excludes a tilt of the patch": (
        "lambertian --luminance 1cd/m2 --area 1cm2 --height 1m --tilt 9deg", "--tilt", "--height"),
    "an offset needs a height, not a distance": (
        "lambertian --luminance 1cd/m2 --area 1cm2 --offset 1m", "--offset", "--height 1.5m"),
    "a distance along the ray is not a height": (
        "lambertian --luminance 1cd/m2 --area 1cm2 --distance 1m --offset 1m", "--height"),
    "watts are not a luminous flux": ("point-source --luminous-flux 5W", "luminous flux"),
    "watts per square metre are not an illuminance": (
        "point-source --illuminance 5W/m2 --distance 1m", "illuminance"),
    "watts and lux together need a link": (
        "point-source --flux 5W --illuminance 20lx", "--spectrum D65"),
    "more lumens per watt than any light has are refused": (
        "lambertian --luminance 800cd/m2 --radiance 1W/m2/sr", "contradict each other", "683"),
    "a quantity in two kinds is compared with a wavelength": (
        "point-source --flux 5lm --radiant-flux 1W --wavelength 555nm",
        "5 lm/W is not 683.002 lm/W"),
    "one quantity in three kinds is refused": (
        "point-source --flux 5lm --radiant-flux 1W --photon-flux 4umol/s", "the same quantity"),
    "two names of one quantity are refused": (
        "point-source --flux 5lm --luminous-flux 6lm", "the same quantity"),
    "a calorimeter takes watts, not lumens": ("calorimeter --flux 5lm --time 1s", "watts"),
    "a cone has no exponent": (
        "point-source --flux 5lm --half-angle 9deg --exponent 3", "--half-angle", "--exponent"),
    "a lobe has no half angle": (
        "point-source --flux 5lm --half-angle 9deg --distribution lobe", "--half-angle"),
    "a hemisphere has no half angle": (
        "point-source --flux 5lm --hemisphere --half-angle 80deg", "--hemisphere", "--half-angle"),
    "a hemisphere is not a lobe": (
        "point-source --flux 5lm --hemisphere --beam-angle 30deg", "--hemisphere", "--beam-angle"),
    "a hemisphere is not isotropic": (
        "point-source --flux 5lm --hemisphere --isotropic", "--hemisphere", "--isotropic"),
    "an isotropic source is not a cone": (
        "point-source --flux 5lm --isotropic --distribution cone", "--isotropic", "cone"),
    "a hemisphere is not an expression": (
        "point-source --flux 5lm --hemisphere --distribution cos(theta)", "--hemisphere",
        "cos(theta)"),
    "a disc has no width": ("lambertian disc --luminance 9cd/m2 --width 1m", "--width"),
    "a disc has no corner": ("lambertian disc --luminance 9cd/m2 --corner --radius 1m", "--corner"),
    "a Lambertian cube is unknown": ("lambertian cube --luminance 9cd/m2", "cube"),
    "a disc has a radius or a diameter, not both": (
        "lambertian disc --luminance 9cd/m2 --radius 1m --diameter 3m --height 1m",
        "--diameter 3m contradicts the other inputs, which give 2 m"),
    "a grid of too many answers is refused": (
        "point-source --flux 1lm:101lm:1lm --distance 1m:101m:1m", "101 x 101 = 10201 answers"),
    "a long range comes after the other lists": (
        "point-source --flux 1lm --distance 1m:10001m:1m --half-angle 1deg,2deg -g flux",
        "10001 values", "-g flux --distance 1m:10001m:1m"),
    # geometry
    "a polygon whose vertices are in a line has no area": (
        "solid-angle polygon 0,0,1 1,0,1 2,0,1", "no area"),
    "a polygon whose vertices are not in one plane is refused": (
        "solid-angle polygon 0,0,1 1,0,1 1,1,1.1 0,1,1", "not flat"),
    "a vertex that is given twice is refused": (
        "solid-angle polygon 0,0,1 1,0,1 1,0,1 0,1,1", "twice"),
    "a solid angle alone is not a pyramid": ("solid-angle pyramid --solid-angle 1sr", "takes two"),
    "a solid angle alone is not a disc": ("solid-angle disc --solid-angle 1sr", "takes two"),
    "a solid angle alone is not a sphere": ("solid-angle sphere --solid-angle 1sr", "takes two"),
    "a solid angle alone is not a patch": ("solid-angle patch --solid-angle 1msr", "takes two"),
    "a tilted patch that is too near has the disc as its hint": (
        "solid-angle patch --area 1m2 --distance 2m --tilt 80deg", "is too short",
        "--height 0.347296m --offset 1.96962m"),
    "a patch seen from its edge has no disc as its hint": (
        "solid-angle patch --area 1m2 --distance 2m --tilt 90deg", "is too short",
        "--distance 5.643m"),
    "a patch seen from behind has no disc as its hint": (
        "solid-angle patch --area 1m2 --distance 2m --tilt 100deg", "is too short",
        "--distance 5.643m"),
    "a disc is solved on its axis only": (
        "solid-angle disc --radius 1m --height 1m --offset 1m --solid-angle 1sr", "contradicts"),
    "two vertices are not a polygon": ("solid-angle polygon 0,0,1 1,0,1", "vertices"),
    "a vertex of two coordinates is refused": (
        "solid-angle polygon 0,0 1,0,1 0,1,1", "2 coordinates"),
    "a vertex of four coordinates is refused": (
        "solid-angle polygon 0,0,1,2 1,0,1 0,1,1", "4 coordinates"),
    "a vertex that is not a number is refused": ("solid-angle polygon nan,0,1 1,0,1 0,1,1", "nan"),
    "a normal of length 0 is refused": (
        "solid-angle polygon 1,0,0 0,1,0 0,0,1 --normal 0,0,0", "normal"),
    "a viewpoint in the polygon's plane is refused": (
        "solid-angle polygon 1,0,0 0,1,0 0,0,1 --viewpoint 1,0,0", "plane"),
    "an observer on a sphere is refused": (
        "solid-angle sphere --radius 1m --distance 1m", "on or inside the sphere"),
    "an observer in a disc's plane is refused": (
        "solid-angle disc --radius 1m --height 0m", "out of range"),
    "a half angle that is not a number is refused": ("solid-angle cone --half-angle nandeg", "nan"),
    "a cone wider than the sphere is refused": (
        "solid-angle cone --half-angle 181deg", "out of range"),
    "a direction of two coordinates is refused": ("direction 1 1", "three coordinates"),
    "a direction of four coordinates is refused": ("direction 1 1 1 1", "three coordinates"),
    "a direction that is not a number is refused": ("direction nan 0 1", "nan"),
    "the origin has no direction": ("direction 0 0 0", "no direction"),
    "a numerical aperture above 1 is refused": ("etendue --area 1mm2 --na 1.5", "out of range"),
    "an f-number below a half is refused": (
        "etendue --area 1mm2 --f-number 0.4", "0.5 or more, in air"),
    "patches at a distance of 0 are refused": (
        "etendue --area 1mm2 --receiver-area 1mm2 --distance 0m", "more than 0"),
    "an area that is not a number is refused": ("etendue --area nanm2 --half-angle 10deg", "nan"),
    "an expression that is 0 everywhere is refused": ("integrate x-x --sphere", "is 0"),
    "an expression that has no value is refused": ("integrate 1/(x-x) --sphere", "no value"),
    "only a quantity per solid angle is integrated over it": (
        "integrate z --sphere --unit lx", "illuminance (lx) is not a quantity per solid angle"),
    "an attribute is not allowed in an expression": ("integrate x.real --sphere", "is not allowed"),
    "a long chain of attributes is not allowed in an expression": (
        "integrate " + "x" + ".a" * 490 + " --sphere", "is not allowed"),
    "the name nan is not allowed in an expression": ("integrate nan --sphere", "nan"),
    # --check
    "a tolerance does not apply without an answer to check": (
        "solid-angle cone --half-angle 25deg --tolerance 3sf",
        "--tolerance does not apply without --check"),
    "a tolerance does not apply to a conversion without an answer to check": (
        "convert 500 lx cd/m2 --reflectance 0.7 --tolerance 3sf",
        "--tolerance does not apply without --check"),
    "an answer to check excludes a result to get": (
        "solid-angle cone --half-angle 25deg --check 0.6sr -g solid-angle",
        "--check cannot be used with --get"),
    "a list of angles has no one answer to check": (
        "solid-angle cone --half-angle 25deg,26deg --check 0.6sr", "--check takes one answer"),
    "a list of distances has no one answer to check": (
        "convert 100 cd lx --distance 1m,2m --check 25lx", "--check takes one answer"),
    "a range of distances has no one answer to check": (
        "point-source --intensity 9cd --distance 1m:3m:1m --check 1lx", "--check takes one"),
    "a number that is too large is named in a list": (
        "convert 100,1e400 lx fc", "'1e400' is too large", "less than 1.8e308"),
    "a number that is too large is named in a list with a unit after each": (
        "convert 100lx,1e400lx fc", "'1e400' is too large", "less than 1.8e308"),
    "a number that is too large is named in a list of conditions": (
        "convert 800 lm lx --isotropic --distance 1m,1e400m", "'1e400' is too large", "1.8e308"),
    "a number that is too small is named in a list": (
        "convert 1e-400,100 lx fc", "'1e-400' is too small", "more than 2.3e-308"),
    "a result that is too large is named instead of the value": (
        "convert 1e308 lx ulx", "the result in ulx is out of range", "a result between"),
    "a list of temperatures has no one answer to check": (
        "spectrum blackbody:3000K,4000K --check x=0.4", "--check takes one answer"),
    "a list of wavelengths has no one answer to check": (
        "photon 400nm,500nm --check 2eV", "--check takes one answer"),
    "a range of exposure values has no one answer to check": (
        "ev --ev100 1:40:1 --check 25lx", "--check takes one answer"),
    "a range beyond the limits is refused before the answer to check": (
        "ev --ev100 1:400:1 --check 25lx", "--ev100 101 is out of range"),
    "a list of luminances has no one answer to check": (
        "mesopic --luminance 0.1cd/m2,1cd/m2 --sp-ratio 2 --check 1cd/m2", "--check takes one"),
    "a conversion to check needs a unit to convert to": (
        "convert 130 cd/m2 --check 5", "--check needs a unit to convert to"),
    "a conversion to check needs its distance": (
        "convert 130 cd lx --check 5lx", "a distance is missing"),
    # light from the surroundings
    "empty surroundings are refused": (
        "environment", "a map, a sky or an expression is missing", "sky:overcast"),
    "an unknown word is not a light of the surroundings": (
        "environment lightprobe", "'lightprobe' is not a file, a sky or an expression",
        "sky:overcast"),
    "an intensity is not a radiance of the surroundings": (
        "environment cos(theta/2) cd", "not a radiance", "'cos(theta/2) cd/m2'"),
    "an unknown type of sky is refused with the types": (
        "environment sky:cloudy", "unknown sky 'cloudy'", "overcast"),
    "a clear sky needs the elevation of the sun": (
        "environment sky:clear", "--sun-elevation 40deg"),
    "a clear sky needs the azimuth of the sun": (
        "environment sky:clear --sun-elevation 40deg", "the sun's azimuth", "--sun-azimuth 180deg"),
    "an overcast sky does not depend on the sun": (
        "environment sky:overcast --sun-elevation 30deg", "--sun-elevation does not apply"),
    "a wide band has no single width in frequency": (
        "convert 1 um THz --wavelength 550nm", "is not small compared with",
        "radcalc photon 50nm,1050nm"),
    "two values that scale a sky are refused": (
        "environment sky:5 --zenith-luminance 9cd/m2 --horizontal-illuminance 9lx",
        "--zenith-luminance cannot be used with",
        "or:  radcalc environment sky:5 --horizontal-illuminance 9lx"),
    "a missing file of a map is refused": (
        "environment none/lit.hdr --unit 1", "cannot read none/lit.hdr", "a Radiance (.hdr)"),
    "a sky is not a map": ("environment sky:5 --unit cd/m2", "--unit does not apply to a sky"),
    "an expression is not a map": (
        "environment cos(theta/2) --projection angular --aim 0,0,1",
        "--projection and --aim do not apply to an expression"),
    "an expression has no sun": (
        "environment 2 --sun-elevation 30deg", "--sun-elevation does not apply to an expression"),
    "relative radiances have no kind": (
        "environment sky:overcast --spectrum D65", "--spectrum does not apply to relative"),
    # scales
    "a reading cannot be multiplied": (
        "convert 2*10 dBm W", "'2*10 dBm' multiplies", "'20 dBm' W"),
    "a level is not part of a unit": (
        "convert 10 dBm/m2 W/m2", "'dBm' is a scale, 10 lg(P / 1 mW), not a unit", "mW"),
    "a power of 0 has no level": ("convert 0 W dBm", "0 mW has no reading on dBm", "more than 0"),
    "a power below 0 has no level": ("convert -- -5 W dBm", "-5000 mW has no reading", "more than"),
    "an illuminance of 0 has no magnitude": (
        "convert 0 lx mag", "0 lx has no reading on mag", "more than 0"),
    "a luminance of 0 has no exposure value": (
        "convert 0 cd/m2 EV", "0 cd/m2 has no reading", "more than"),
    "a transmittance of 0 has no density": ("convert 0 % OD", "0 has no reading on OD", "more"),
    "a temperature of 0 has no reciprocal": (
        "convert 0 mired K", "0 mired is not the reciprocal", "more than 0"),
    "a shift in mireds is not a temperature": (
        "convert -- -100 mired K", "a difference, as of filters", "more than 0"),
    "the reading of a sky quality meter needs its unit": (
        "convert 21.5 SQM cd/m2", "'SQM' is not accepted", "21.5 mag/arcsec2 cd/m2"),
    "levels are not added": (
        "convert 10 dBm + 3 lx in dBm", "calculates with dBm", "then arithmetic"),
    "unexpected words are quoted as they were typed": (
        "convert 10 dBm uW mW", "too many words: 'dBm uW mW'", "10 dBm uW,mW"),
    "a level beyond the range of numbers is refused": (
        "convert 1e5 dBm W", "100000 dBm is out of range", "less extreme"),
    "a level so low that its value is 0 is refused": (
        "convert -- -1e5 dBm W", "-100000 dBm is out of range", "less extreme"),
    "a transmittance above 1 is not a density of a filter": (
        "convert 3 stops OD", "3 stops is more light", "'-3 stops' OD"),
    "a gain is not a density of a filter": ("convert 3 dB OD", "3 dB is more light", "-3 dB"),
    "dBu is a level of a voltage": ("convert 3 dBu W", "'dBu' is not accepted", "dBu(W)"),
    "a scale in small letters is refused with its spelling": (
        "convert 10 dbm W", "unknown unit", "dBm"),
    "a meter's constant does not apply to the other kind of light": (
        "convert 15 EV lx --k 14cd.s/m2", "--k does not apply", "radcalc convert 15 EV lx"),
    "a meter's constant does not apply between units": (
        "convert 15 lx fc --c 320lx.s", "--c does not apply", "radcalc convert 15 lx fc"),
    "a magnitude is not a power": (
        "convert 5 mag dBm", "illuminance (lx) to radiant flux", "--area"),
    "a range of readings needs steps in the scale": (
        "point-source --flux 0dBm:10dBm:5mW --distance 2m", "mixes quantities", "0dBm:10dBm:5dBm"),
    "the reciprocal of a difference of temperatures is not a shift": (
        "5600 K - 3200 K to mired", "a sum or a difference", "'1/(5600 K) - 1/(3200 K)' MK-1"),
    "a sum of temperatures has no reciprocal either": (
        "convert 5600K+3200K MK-1", "a sum or a difference", "'1/(5600K)+1/(3200K)' MK-1"),
    "a number of a range keeps its own unit in a hint": (
        "point-source --flux 800lm --height 50cm:4m:20", "mixes quantities", "50cm:4m:20cm"),
    "a reflectance is not a gain": (
        "lambertian --incident-irradiance 1lx --reflectance 3dB", "3dB is out of range", "0 to 1"),
    "an absorptance is not a density": (
        "calorimeter --mass 1kg --temperature-rise 2K --absorptance 0.3OD",
        "--absorptance takes a number from 0 to 1, not OD", "--absorptance 0.95"),
    "an f-number is not given in stops": (
        "ev --f-number 3stops --time 1s", "--f-number takes a number, not stops", "--f-number"),
    "an exposure value is not given as a ratio": (
        "ev --luminance 12EV", "--luminance 12EV is an exposure value", "--ev100 12"),
    "a filter is quoted as it was typed": (
        "ev --ev100 15 --iso 200 --f-number 16 --nd 3EV", "not EV", "--nd 0.9"),
    "a designation of a filter is quoted as it was typed": (
        "ev --ev100 15 --iso 200 --f-number 16 --nd ND8x2stops", "'8x2stops'"),
    "two uncertain parameters are refused": (
        "spectrum gaussian:530+-1nm,30+-1nm", "'30+-1nm' has an uncertainty, which cannot be used",
        "gaussian:530+-1nm,30nm"),
    "an exposure value has no reading on a scale": (
        "ev --ev100 12 -g ev100:stops", "ev100 cannot be in stops", "ev100:1"),
    "a difference of temperature has no reciprocal": (
        "calorimeter --mass 1kg --temperature-rise 200mired", "not mired", "--temperature-rise 2K"),
    "a level is not a distance": (
        "point-source --flux 1W --distance 3dBm", "--distance takes a length, not dBm", "2m"),
}  # fmt: skip


@for_each([(words, parts) for words, *parts in COMMANDS.values()])
def test_a_command_is_refused(words, parts):
    done = run(*words.split())
    assert done.returncode == 2, done.stdout
    assert not done.stdout or json.loads(done.stdout)["error"]["message"] in done.stderr
    assert bool(done.stdout) == ("--json" in words)
    assert "\ntry: " in done.stderr
    assert "Traceback" not in done.stderr
    for part in parts:
        assert part in done.stderr, done.stderr


# words after `radcalc convert -`, part of the message
STREAMS = {
    "a stream without units needs the unit to convert to": ((), "a unit to convert to is missing"),
    "a stream that ends in to needs the unit to convert to": (
        ("lx", "to"), "a unit to convert to is missing"),
    "a stream with an empty unit needs the unit to convert to": (
        ("", "fc"), "a unit to convert to is missing"),
    "a third unit is an unexpected argument": (("lx", "fc", "nit"), "too many words"),
    "the word in separates units only in small letters": (
        ("lx", "IN", "fc"), "does not separate units"),
    "two words that separate units are refused": (
        ("lx", "to", "=", "fc"), "to and = both separate units"),
    "the word to is allowed once": (("a", "to", "b", "to", "c"), "more than once"),
    "a second dash is refused": (("-", "fc"), "'-' is given more than once"),
    "a spectrum and the numbers are not both read from standard input": (
        ("lx", "W/m2", "--spectrum", "-"), "- cannot be used twice"),
    "a column of a spectrum and the numbers are not both read from standard input": (
        ("lx", "W/m2", "--spectrum", "-:2"), "- cannot be used twice"),
    "a stream of lux to candelas needs a distance": (("lx", "cd"), "a distance is missing"),
    "a distance does not apply between lux and foot-candles": (
        ("lx", "fc", "--distance", "1m"), "does not apply"),
    "a stream takes no list of conditions": (
        ("cd", "lx", "--distance", "1m,2m"), "a list of conditions"),
    "an unknown unit to convert to is refused": (("lx", "zork"), "unknown unit"),
    "an unknown unit to convert lines with their own units to is refused": (
        ("zork",), "unknown unit"),
    "a stream has no steps": (("lx", "fc", "--steps"), "--steps cannot be used with a stream"),
    "a stream has no CSV": (
        ("lx", "fc", "--format", "csv"), "--format csv cannot be used with a stream"),
    "a stream has no table": (
        ("lx", "fc", "--format", "table"), "--format table cannot be used with a stream"),
    "field 0 is out of range": (("lx", "fc", "--field", "0"), "out of range"),
    "fields up to 0 are refused": (("lx", "fc", "--field", "-0"), "out of range"),
    "fields from 3 down to 2 are refused": (("lx", "fc", "--field", "3-2"), "decreasing"),
    "an empty field in a list of fields is refused": (
        ("lx", "fc", "--field", "1,,2"), "not a list of fields"),
    "a word is not a list of fields": (("lx", "fc", "--field", "x"), "not a list of fields"),
    "a field of 99 digits is refused": (("lx", "fc", "--field", "9" * 99), "out of range"),
    "two letters are not a delimiter": (("lx", "fc", "-d", "ab"), "not one character"),
    "a quotation mark is not a delimiter": (("lx", "fc", "-d", '"'), "not one character"),
    "a newline is not a delimiter": (("lx", "fc", "-d", "\n"), "not one character"),
    "fields exclude a column": (
        ("lx", "fc", "--field", "1", "--column", "E"), "cannot be used with"),
    "a column missing from the header is refused": (
        ("lx", "fc", "--column", "E"), "has no column 'E'"),
    "a field of lines with their own units needs a delimiter": (
        ("fc", "--field", "1"), "--field needs --delimiter"),
    "a column between blanks without a unit needs one": (
        ("fc", "--column", "a"), "the unit of 'a' is missing in the header of stdin"),
    "a column that is added and renamed is refused": (
        ("lx", "fc", "--header", "--add", "b", "--rename", "c"), "cannot be used with"),
    "a title without a header is refused": (
        ("lx", "fc", "--rename", "b"), "--rename needs a header"),
    "one title for two fields is refused": (
        ("lx", "fc", "-d", ",", "--field", "1,2", "--add", "b"), "take one field"),
    "a title without a letter is refused": (("lx", "fc", "--add", " "), "is not a title"),
    "a title in another unit is refused": (("lx", "fc", "--add", "E [lx]"), "is in lx, not in fc"),
    "a title of another quantity is refused": (
        ("lx", "fc", "--add", "luminance"), "named 'luminance', but contain illuminance (fc)"),
    "a title of two words between blanks is refused": (
        ("lx", "fc", "--field", "1", "--add", "a b"), "blanks, at which the lines are cut"),
    "a column that becomes another quantity is refused": (
        ("lx", "W/m2", "--spectrum", "D65", "--header"), "under the header would change from"),
    "decimal commas exclude commas as delimiters": (
        ("lx", "fc", "-d", "comma", "--decimal", ","), "cannot be used with"),
    "a decimal mark is a point or a comma": (("lx", "fc", "--decimal", "x"), "--decimal"),
    "a header of 0 lines is refused": (("lx", "fc", "--header=0"), "--header"),
    "a header of a word is refused": (("lx", "fc", "--header=x"), "--header"),
    "an unknown treatment of bad lines is refused": (
        ("lx", "fc", "--invalid", "stop"), "--invalid"),
}  # fmt: skip


@for_each(STREAMS.values())
def test_a_stream_is_refused(words, message):
    done = run("convert", "-", *words, input="5 zork\n" if words == ("zork",) else "a\n1\n")
    assert (done.stdout, done.returncode) == ("", 2)
    assert message in done.stderr
    assert done.stderr.startswith("radcalc: ")
    assert done.stderr.splitlines()[1].startswith("try: ")


# search for a quantity, part of the message, part of the hint
NAMES = {
    "a misspelt English name is answered with the nearest": (
        "luminanse", "unknown quantity 'luminanse'", "luminance"),
    "a misspelt Czech name is answered with the nearest": (
        "svitivsot", "unknown quantity", "svítivost"),
    "a misspelt Russian name is answered with the nearest": (
        "яркасть", "unknown quantity", "яркость"),
    "a name unlike any other is answered with the list of all": (
        "zork", "unknown quantity 'zork'", "radcalc quantities, which lists them all"),
    "a unit of an unlisted quantity is answered with the quantity": (
        "kg", "'kg' measures mass", "radcalc quantities"),
    "a sign is not a name": ("%", "unknown quantity '%'", "radcalc quantities"),
    "empty brackets are not a name": ("[]", "unknown quantity", "radcalc quantities"),
    "markup is not a name": ("[/bold]", "unknown quantity", ""),
    "a hundred kilobytes are not a name": ("x" * 100_000, "unknown quantity", ""),
    "a unit repeated 66 times is not a name": ("lx " * 66, "unknown quantity", ""),
}  # fmt: skip


@pytest.mark.parametrize(("text", "message", "hint"), NAMES.values(), ids=NAMES)
def test_an_unknown_name_is_refused_with_the_nearest(text, message, hint):
    with pytest.raises(RadcalcError) as refused:
        search(text)
    said, mended = shell(refused.value)
    assert message in said
    assert hint in mended
    assert mended
