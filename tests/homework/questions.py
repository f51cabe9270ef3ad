"""Questions of the command line, and verdicts on answers to them."""

import contextlib
import io
import shlex
from functools import cache
from typing import Any

import pytest

import radcalc.homework
from radcalc import cli
from radcalc.errors import ConditionError
from radcalc.homework import Question, Verdict, check

LUX = "convert 500 lx cd/m2 --reflectance 0.7"  # 350/pi = 111.408
POINT = "point-source --intensity 130cd --distance 2.3m"  # 24.5747 lx
CONE = "solid-angle cone --half-angle 25deg"  # 0.588686 sr
TILTED = f"{POINT} --incidence 35deg"  # 20.1304 lx


@cache
def asked(words: str, name: str = "") -> Question:
    """Return the question that the command line passes to `check`."""
    found: list[Question] = []

    def catch(question: Question, *_: Any) -> Verdict:
        found.append(question)
        raise ConditionError("caught", "")

    with pytest.MonkeyPatch.context() as patch, contextlib.redirect_stderr(io.StringIO()):
        patch.setattr(radcalc.homework, "check", catch)
        assert cli.run([*shlex.split(words), "--check", f"{name}=1" if name else "1"]) == 2
    assert found, words
    return found[0]


def verdict(words: str, claim: str, tolerance: str = "1%") -> Verdict:
    name = claim.partition("=")[0] if "=" in claim else ""
    return check(asked(words, name), claim, tolerance)


def mistakes(words: str, claim: str) -> list[str]:
    return [one.mistake for one in verdict(words, claim).diagnoses]


def typed(number: float, digits: int) -> str:
    """Format a number with a given count of significant digits, including zeros at the end."""
    text = f"{number:.{digits - 1}e}"
    power = int(text.partition("e")[2])
    return text if not -3 <= power < digits else f"{float(text):.{digits - 1 - power}f}"


def claim_of(name: str, number: float, digits: int, unit: str) -> str:
    return f"{name}={typed(number, digits)}{unit}" if name else f"{typed(number, digits)}{unit}"


RIGHT = [  # the question, the result, its unit
    (LUX, "", "cd/m2"), ("convert 5.3 mW lm --wavelength 610nm", "", "lm"),
    ("convert 870 lm lx --isotropic --distance 2.3m", "", "lx"), ("convert 470 lx fc", "", "fc"),
    ("convert 41 W/m2 umol/m2/s --wavelength 660nm", "", "umol/m2/s"), (CONE, "solid-angle", "sr"),
    ("solid-angle sphere --radius 4cm --distance 11cm", "half-angle", "deg"),
    ("solid-angle zone --polar 20deg:50deg", "solid-angle", "deg2"),
    ("solid-angle pyramid --horizontal 42deg --vertical 26deg", "projected-solid-angle", "sr"),
    ("solid-angle patch --area 3cm2 --distance 1.3m --tilt 40deg", "solid-angle", "sr"),
    ("direction -3 4.6 5", "azimuth", "deg"), ("direction -3 4.6 5", "length", ""),
    ("direction --polar 35deg --azimuth 130deg", "x", ""), (TILTED, "illuminance", "lx"),
    ("screen --flux 2100lm --width 2.3m --aspect 4/3 --gain 1.2", "luminance", "cd/m2"),
    ("sensor --luminance 370cd/m2 --f-number 3.4 --transmittance 0.87 --time 1/60s", "exposure",
        "lx.s"),
    ("laser --flux 3.7mW --diameter 1.3mm --divergence 1.7mrad --distance 23m", "peak-irradiance",
        "W/m2"),
    ("room --width 7m --length 11m --illuminance 470lx --flux 3400lm --utilance 0.57", "luminaires",
        ""),
    ("etendue --area 2mm2 --half-angle 25deg", "etendue", "mm2.sr"),
    ("etendue --radius 3mm --receiver-radius 5mm --distance 13mm", "etendue", "m2.sr"),
    ("etendue --area 2mm2 --half-angle 25deg --radiance 1e5cd/m2", "flux", "lm"),
    (POINT, "flux", "lm"), (POINT, "luminous-flux", "klm"), (POINT, "irradiance", "fc"),
    ("point-source --intensity 85cd --illuminance 34lx", "distance", "ft"),
    ("point-source --flux 5.3mW --distance 1.3m --wavelength 610nm", "illuminance", "lx"),
    ("uberlight 0.4,0.3,2 --intensity 730cd --beam-exponent 8", "illuminance", "lx"),
    ("lambertian --luminance 130cd/m2", "exitance", "lm/m2"),
    ("lambertian disc --luminance 2900cd/m2 --radius 31cm --distance 45cm", "illuminance", "lx"),
    ("lambertian --incident-illuminance 470lx --reflectance 0.63", "luminance", "nit"),
    ("ev --f-number 5.6 --time 1/60s", "ev", ""), ("ev --ev100 9.3", "illuminance", "lx"),
    ("ev --illuminance 470lx --f-number 3.4", "time", "ms"),
    ("calorimeter --flux 1.7W --mass 40g --specific-heat 385J/kg/K --time 3min",
     "temperature-rise", "K"),
    ("integrate cos(theta) --half-angle 48deg", "integral", "sr"),
    ("photon 610nm", "photon-energy", "eV"), ("photon 610nm", "frequency", "THz"),
    ("photon 610nm", "luminous-efficacy", "lm/W"), ("spectrum A", "luminous-efficacy", "lm/W"),
    ("spectrum blackbody:2900K", "radiance", "W/m2/sr"), ("spectrum A", "photon-energy", "eV"),
    ("mesopic --luminance 0.1cd/m2 --sp-ratio 2", "mesopic-luminance", "cd/m2"),
    ("mesopic --luminance 0.3cd/m2 --spectrum A", "sp-ratio", ""),
    ("sky overcast --zenith-luminance 8700cd/m2", "horizontal-illuminance", "lx"),
    ("sky overcast --zenith-luminance 8700cd/m2 --tilt 70deg", "irradiance", "lx"),
    ("sky 1 --horizontal-illuminance 13klx", "zenith-luminance", "cd/m2"),
    ("environment sky:overcast --zenith-luminance 8700cd/m2", "irradiance", "lx"),
]  # fmt: skip
