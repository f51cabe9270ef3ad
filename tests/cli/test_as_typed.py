"""Inputs are shown with the number and unit that were typed, in every command."""

import re
import shlex

from following import call
from helpers import answers, for_each
from render.test_schema import ANSWERS

NUMBER = re.compile(r"(\d+(?:\.\d+)?)([^\d].*)?")
FACTORS = (1.0, 1.00370, 0.98765)  # of each typed number, to five digits
CHOSEN = {"-g", "--get", "-n", "--check", "--tolerance", "--precision", "--steps"}

# Symbols and units that are not in the transcripts.
MORE = """
point-source --luminous-flux 812.3lm --radiant-flux 3.17W
point-source --radiant-flux 3.17W --distance 7.3ft
point-source --luminous-intensity 81.7mcd --distance 7.3ft --time 17min --receiver-area 33in2
point-source --radiant-intensity 1.13W/sr --distance 7.3ft --incidence 33.3deg
point-source --photon-flux 31.7umol/s --distance 3.1ft --time 17min --receiver-area 33in2
point-source --photon-intensity 31.7umol/s/sr --distance 3.1yd
point-source --photon-irradiance 31.7umol/s/m2 --distance 3.1yd
point-source --exposure 5.3lx.h --distance 1.7yd --time 0.7h
point-source --luminous-exposure 5.3lx.h --distance 1.7yd
point-source --radiant-exposure 5.3J/cm2 --distance 1.7yd
point-source --photon-exposure 5.3mol/m2 --distance 1.7yd
point-source --luminous-energy 5.3lm.h --distance 1.7yd
point-source --radiant-energy 5.3mJ --distance 1.7yd
point-source --photon-number 5.3mol --distance 1.7yd
point-source --peak-intensity 913cd --exponent 3.3 --toward 33.3deg
point-source --peak-luminous-intensity 913mcd --exponent 3.3 --toward 33.3deg
point-source --flux 800lm --apex-angle 33.3deg --height 7.7ft --offset 1.3ft --offset-y 3.3in
point-source --flux 800lm --field-angle 33.3deg --within 11.1deg --distance 33in
point-source --flux 800lm --solid-angle 33.3deg2 --within 0.7deg
point-source --flux 5.55W --distance 7.3ft --efficacy 93.3lm/W
point-source --flux 5.55W --distance 7.3ft --wavelength 555nm
lambertian --luminous-exitance 91.7lm/m2 --area 3.3in2 --distance 91ft
lambertian --radiant-exitance 91.7mW/cm2 --area 3.3in2
lambertian --photon-exitance 91.7umol/s/m2 --diameter 3.3in
lambertian plane --incident-irradiance 91.7lx --reflectance 37.3%
lambertian --incident-photon-irradiance 91.7umol/s/m2 --reflectance 37.3%
lambertian --photon-radiance 3.31umol/s/m2/sr --area 3.3in2 --distance 91ft --tilt 33.3deg
lambertian --radiance 3.31W/cm2/sr --radius 3.3mm --distance 91in --time 17min
ev --ev 7.3 --iso 125
ev --luminance 333nt --k 14.1cd.s/m2 --f-number 5.6
ev --illuminance 333fc --c 330lx.s --time 1/60s
calorimeter --mass 45.5g --specific-heat 0.45J/g/K --temperature-rise 3.3K --absorptance 93.3%
sensor --luminance 333nt --f-number f/5.6 --time 1/60 --pixel-pitch 3.45um --wavelength 555nm
sensor --irradiance 33.3uW/cm2 --pixel-area 7.7mm2 --responsivity 371mA/W --time 17ms
sensor --photon-irradiance 91.7umol/s/m2 --pixel-pitch 33um --quantum-efficiency 61% --time 7ms
laser --flux 4.7mW --diameter 1.3mm --divergence 1.7mrad --distance 33ft --limit 25.3W/m2
laser --energy 3.3mJ --time 7ns --diameter 0.3in --receiver-diameter 7.3mm --profile uniform
room --width 23.3ft --length 31.7ft --height 6.7ft --illuminance 33fc --flux 3.3klm --utilance 61%
room --area 54.7m2 --luminaires 13 --flux 3.3klm --utilance 0.61 --maintenance 0.83
screen --flux 2.1klm --diagonal 99.9in --aspect 16/9 --gain 1.3
screen --luminance 16.3fL --width 7.7ft --height 3.3ft
solid-angle cone --projected-solid-angle 0.333sr
solid-angle cone --apex-angle 33.3deg
solid-angle patch --area 3.3in2 --distance 77in --tilt 33.3deg
solid-angle pyramid --horizontal 33.3deg --vertical 0.7rad
solid-angle rectangle --width 3.3ft --length 7.7in --height 77in --offset 3.3in \\
        --offset-y 0.7ft
etendue --radius 3.3mm --receiver-diameter 7.7in --distance 91ft --tilt 33.3deg
etendue --area 3.3mm2 --na 0.333
etendue --area 3.3mm2 --apex-angle 33.3deg --radiance 3.31W/cm2/sr
etendue --etendue 3.3mm2.sr --flux 333mW
direction --elevation 33.3deg --azimuth 0.7rad
mesopic --luminance 0.33nt --scotopic-luminance 0.77nt
mesopic --mesopic-luminance 0.33nt --sp-ratio 1.77
sky overcast --zenith-luminance 7.7kcd/m2 --toward 33.3deg,0.7rad
sky overcast --horizontal-illuminance 7.7kfc --tilt 33.3deg
sky clear --sun-elevation 33.3deg --horizontal-illuminance 7.7klx --sun-illuminance 33.3klx
sky clear --sun-elevation 33.3deg --global-illuminance 77.7klx --sun-illuminance 33.3klx
uberlight 1,0,3 --intensity 8.8cd --falloff 1.3 --falloff-distance 7.7ft --maximum 3.3
uberlight 1,0,3 --intensity 8.8cd --beam-exponent 7.3
uberlight 3.3ft,0ft,7.7ft --intensity 8.8cd
uberlight 3.3in,0in,7.7in --luminous-intensity 8.8mcd \\
        --superellipse 0.33,0.33,0.77,0.77 --roundness 0.77
photon 555nm
photon 0.777um
photon 555.5THz
photon 1.777e4cm-1
photon 2.777eV
photon 222.2kJ/mol
spectrum line:555nm --range 333.3nm:777.7nm
spectrum blackbody:2777K
integrate cos(theta) --half-angle 33.3deg --accuracy 1e-7
sky clear --sun-elevation 33.3deg --sun-azimuth 0.7rad --horizontal-illuminance 7.7klx \\
        --sun-illuminance 33.3klx --tilt 33.3deg --azimuth 11.1deg
sky clear --sun-elevation 33.3deg --horizontal-irradiance 77.7W/m2 --sun-irradiance 33.3mW/cm2
sky clear --sun-elevation 33.3deg --zenith-radiance 7.77W/m2/sr \\
        --sun-radiance 1e7W/m2/sr --sun-radius 0.277deg
sky overcast --zenith-photon-radiance 77.7umol/s/m2/sr
sky clear --sun-elevation 33.3deg --global-irradiance 777W/m2 --sun-irradiance 333W/m2
sky clear --sun-elevation 33.3deg --global-illuminance 77.7klx --sun-illuminance 33.3klx
point-source --peak-radiant-intensity 9.13mW/sr --exponent 3.3 --toward 33.3deg
"""


CALLS = [text for text in ANSWERS if not CHOSEN & set(shlex.split(text))]
CALLS += MORE.replace("\\\n", "").strip().splitlines()


def moved(text: str, factor: float) -> str:
    """Return a value with its number changed."""
    found = NUMBER.fullmatch(text)
    if found is None or factor == 1:
        return text
    return f"{float(found[1]) * factor:.5g}{found[2] or ''}"


def given_of(words):
    """Yield each numeric input of every answer, with the result that shows it."""
    done = call([*words, "--json"])
    if done.status:
        return
    for answer in answers(done.output):
        for name, told in answer["inputs"].items():
            for other, result in answer["results"].items():
                named = {other, result["quantity"].replace(" ", "-")}
                if name in named and isinstance(told["value"], float):
                    yield name, told, result


@for_each(CALLS)
def test_inputs_are_shown_as_typed(text):
    first, *rest = shlex.split(text)
    for factor in FACTORS:
        words = [first, *(moved(word, factor) for word in rest)]
        for name, told, result in given_of(words):
            shown = result["value"], result["unit"], result["given"]
            assert shown == (told["value"], told["unit"], True), (name, words)


def test_most_inputs_are_also_results():
    texts = MORE.replace("\\\n", "").strip().splitlines()
    told = [pair for text in texts for pair in given_of(shlex.split(text))]
    assert len({name for name, *_ in told}) > 60


@for_each([f"{number / 10}" for number in range(3601, 8300, 97)])
def test_the_peak_of_a_line_is_its_wavelength_as_typed(nanometres):
    done = call(["spectrum", f"line:{nanometres}nm", "--json"])
    (answer,) = answers(done.output)
    assert answer["results"]["peak-wavelength"]["value"] == float(nanometres)
