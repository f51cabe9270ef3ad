"""Sensors: the camera equation, photons and electrons."""

import math

import pytest
from conftest import run
from helpers import for_each, number

import radcalc

# SI Brochure
H, C, E = 6.62607015e-34, 299792458.0, 1.602176634e-19
DIODE = "--quantum-efficiency {} --wavelength {}"
PIXEL = "--irradiance 1W/m2 --wavelength 525nm --pixel-pitch 5um --quantum-efficiency 50%"
PHOTONS = 25e-12 * 525e-9 / (H * C)  # a second, on that pixel
LENS = "--radiance 10W/m2/sr --f-number 4"
LIT = math.pi * 10 / (4 * 16)  # W/m2


@for_each([
    # Senior, Optical Fiber Communications, chapter 8: 1.2e11 electrons of 3e11 photons at
    # 0.85 um; Raina, Optical Fiber Communication System, examples 9.1 to 9.4 (both as worked
    # by FOSSEE's textbook companions, with rounded constants)
    (DIODE.format("1.2/3", "0.85um"), "responsivity", 0.274, 2e-3),
    (DIODE.format("550/800", "1.3um"), "responsivity", 0.72, 2e-3),
    ("--responsivity 0.274A/W --wavelength 0.85um", "quantum-efficiency:%", 40, 2e-3),
    (DIODE.format("1/3", "0.8um") + " --flux 0.1uW", "current:nA", 21.49, 2e-3),
    (DIODE.format("50%", "0.85um") + " --current 1uA", "flux:uW", 2.92, 2e-3),
    # coseti.org/9008-039.htm: 0.26 A/W at 656 nm for 0.5
    (DIODE.format("0.5", "656nm"), "responsivity", 0.26, 2e-2),
    # FOSSEE, Optical Communication, examples 6.1 and 6.2: 0.85 A/W make 0.85 mA of 1 mW;
    # 4.2e6 pairs of 6e6 photons are 70 %
    ("--responsivity 0.85A/W --flux 1mW", "current:mA", 0.85, 1e-12),
    ("--electrons 4.2e6 --photons 6e6photon", "quantum-efficiency:%", 70, 1e-12),
    # strollswithmydog.com, Connecting Photographic Raw Data: pi p^2 t / (4 N^2) of the radiance
    ("--radiance 1W/m2/sr --f-number 4 --pixel-pitch 3um --time 10ms", "energy:J",
     math.pi * 9e-12 * 0.01 / 64, 1e-12),
    # by hand, from here on
    (LENS, "irradiance", LIT, 1e-12),
    (f"{LENS} --magnification 1", "irradiance", LIT / 4, 1e-12),
    (f"{LENS} --magnification 1", "working-f-number", 8, 1e-12),
    ("--f-number 4 --working-f-number 8", "magnification", 1, 1e-12),  # 8 = 4 (1 + m)
    (f"{LENS} --off-axis-angle 30deg", "irradiance", LIT * 9 / 16, 1e-12),
    (f"{LENS} --off-axis-angle 0deg", "irradiance", LIT, 1e-12),
    (f"{LENS} --transmittance 80%", "irradiance", LIT * 0.8, 1e-12),
    # the widest cone there is fills a hemisphere: E = pi L
    ("--radiance 10W/m2/sr --f-number 0.5", "irradiance", 10 * math.pi, 1e-12),
    ("--working-f-number 8 --pixel-area 1mm2", "etendue:mm2.sr", math.pi / 256, 1e-12),
    (f"{PIXEL} --time 10ms", "photons", PHOTONS * 0.01, 1e-12),
    (f"{PIXEL} --time 10ms", "electrons", PHOTONS * 0.005, 1e-12),
    (f"{PIXEL} --time 10ms", "current:A", PHOTONS * 0.5 * E, 1e-12),
    (f"{PIXEL} --time 10ms", "snr", math.sqrt(PHOTONS * 0.005), 1e-12),
    (f"{PIXEL} --snr 100", "time:s", 1e4 / (0.5 * PHOTONS), 1e-12),
    ("--photon-irradiance 1umol/m2/s --pixel-area 1mm2 --quantum-efficiency 0.5", "current:A",
     0.5 * 1e-12 * 6.02214076e23 * E, 1e-12),
    # back from each: the marked f-number, the aperture, the time, the scene
    ("--radiance 10W/m2/sr --irradiance 0.1W/m2", "f-number", math.sqrt(25 * math.pi), 1e-12),
    (f"{LENS} --irradiance 0.25W/m2", "transmittance", 0.25 / LIT, 1e-12),
    (f"{LENS} --irradiance 0.25W/m2 --transmittance 1", "magnification",
     math.sqrt(LIT / 0.25) - 1, 1e-12),
    (f"{PIXEL} --electrons 1000", "time:ms", 2e6 / PHOTONS, 1e-12),
    ("--f-number 4 --irradiance 2W/m2", "radiance", 2 * 64 / math.pi, 1e-12),
    ("--luminance 100cd/m2 --f-number 4 --exposure 0.1lx.s", "time:s",
     0.1 * 64 / (100 * math.pi), 1e-12),
    ("--responsivity 0.4A/W --current 2uA --pixel-area 1mm2", "irradiance:W/m2", 5, 1e-12),
    # lumens by 54 lm s/umol: 540 lx are 10 umol/m2/s
    ("--illuminance 540lx --efficacy 54lm.s/umol --pixel-area 1um2 --time 1s "
     "--quantum-efficiency 1", "electrons", 1e-12 * 1e-5 * 6.02214076e23, 1e-9),
])  # fmt: skip
def test_a_sensor_follows_from_any_sufficient_set(words, asked, expected, rel):
    done = run("sensor", *words.split(), "-q", "-g", asked)
    assert float(done.stdout) == pytest.approx(expected, rel=rel)


def test_photons_of_a_spectrum_match_its_watts():
    """Of a flat band each nanometre gives lambda/(h c) photons per joule: that is its middle's."""
    words = "--irradiance 1W/m2 --spectrum band:450nm:650nm --pixel-area 1um2 --time 1s -g photons"
    done = run("sensor", *words.split(), "-q")
    assert float(done.stdout) == pytest.approx(1e-12 * 550e-9 / (H * C), rel=1e-4)


def test_photons_are_counted_where_watts_are():
    words = "--irradiance 1W/m2 --spectrum blackbody:3000K --pixel-area 1um2 --time 1s -g photons"
    done = run("sensor", *words.split(), "--quantum-efficiency", "0.5")
    assert "photons counted over all wavelengths" in done.stderr
    assert "--range 400nm:700nm counts those" in done.stderr
    done = run("sensor", *words.split(), "--range", "400nm:900nm")
    assert "photons counted over 400-900 nm" in done.stderr


def test_a_pixel_is_a_sum_over_the_exit_pupil():
    """E of a uniform pupil, as seen from the sensor: its cone filled with the radiance."""
    for f_number in (0.7, 1.4, 8.0):
        half, rings = math.asin(1 / (2 * f_number)), 20_000
        step = half / rings
        total = sum(
            2 * math.pi * math.sin((k + 0.5) * step) * math.cos((k + 0.5) * step) * step
            for k in range(rings)
        )
        found = radcalc.sensor(radiance="1 W/m2/sr", f_number=f_number)
        assert number(found, "irradiance", "W/m2") == pytest.approx(total, rel=1e-6)


def test_assumptions_are_stated():
    done = run("sensor", *LENS.split())
    for said in ("corrected for coma", "focused far away", "without losses"):
        assert said in done.stderr
    done = run("sensor", *LENS.split(), "--magnification", "1", "--off-axis-angle", "20deg")
    for said in ("pupils of equal size", "N (1 + m)", "without vignetting"):
        assert said in done.stderr
    done = run("sensor", "--irradiance", "1W/m2", "--pixel-pitch", "5um")
    assert "lens" not in done.stderr


@for_each(
    [
        ("", "the light is missing"),
        ("--luminance 10cd/m2 --f-number 0.4", "0.5 or more, in air"),
        ("--radiance 10W/m2/sr --irradiance 40W/m2", "an f-number of 0.44"),
        ("--luminance 10cd/m2 --illuminance 40lx", "another value of --luminance or --illuminance"),
        (
            "--working-f-number 0.5 --magnification 2",
            "an f-number of 0.166667 follows from the rest and is out",
        ),
        (f"{LENS} --irradiance 5W/m2", "a transmittance of 10"),
        (f"{LENS} --irradiance 5W/m2 --transmittance 1", "not be below the lens's"),
        (f"{LENS} --off-axis-angle 95deg", "try: from 0 to less than 90 deg"),
        (
            f"{LENS} --off-axis-angle -20deg",
            f"try: radcalc sensor {LENS} --off-axis-angle 20deg\n",
            " (--off-axis-angle: from 0 to less than 90 deg)\n",
        ),
        (
            f"{LENS} --field-angle 20deg",
            f"try: radcalc sensor {LENS} --off-axis-angle 20deg\n",
        ),
        ("--f-number 8 --working-f-number 4", "not be below the lens's"),
        (f"{LENS} --transmittance 1.2", "out of range"),
        (f"{PIXEL} --responsivity 0.4A/W", "--responsivity 0.4A/W contradicts the other inputs"),
        ("--responsivity 0.6A/W --wavelength 400nm", "a quantum efficiency of 1.8"),
        (
            "--illuminance 5lx --pixel-pitch 3um --quantum-efficiency 0.5",
            "needs the wavelength or the spectrum",
        ),
        (
            "--irradiance 5W/m2 --pixel-pitch 3um --quantum-efficiency 0.5",
            "needs the wavelength or the spectrum",
        ),
        (
            "--photon-irradiance 5umol/m2/s --pixel-pitch 3um --responsivity 0.5A/W",
            "needs the wavelength or the spectrum",
        ),
        ("--luminance 5cd/m2 --f-number 2 --quantum-efficiency 60 --wavelength 550nm", "from 0"),
        (
            "--illuminance 5lx --time 1s -g electrons",
            "try: radcalc sensor --illuminance 5lx --time 1s -g electrons --spectrum sun "
            "--pixel-pitch 3.45um --quantum-efficiency 0.6\n",
        ),
        (
            "--illuminance 5lx --time 1s -g electrons --pixel-pitch 3um --quantum-efficiency 0.6",
            "--wavelength 555nm\n",
            "--spectrum LED-B3\n",
        ),
        ("--pixel-pitch 3um --pixel-area 10um2 --irradiance 1W/m2", "contradicts the other inputs"),
    ],
)
def test_impossible_sensors_are_refused(words, *messages):
    done = run("sensor", *words.split())
    assert done.returncode == 2
    for message in messages:
        assert message in done.stderr


def test_arrays_of_times():
    times = radcalc.Quantity([1.0, 2.0], "ms")
    found = radcalc.sensor(
        irradiance="1 W/m2", wavelength="525 nm", pixel_pitch="5 um", time=times,
        quantum_efficiency=0.5,
    )  # fmt: skip
    expected = [PHOTONS * 0.5e-3, PHOTONS * 1e-3]
    assert found["electrons"].magnitude == pytest.approx(expected)


def test_a_short_exposure_time_is_a_fraction_only_in_tables():
    words = ("sensor", "--luminance", "1000cd/m2", "--f-number", "4", "--time", "0.008s")
    assert "1/125 " in run(*words, "--format", "table").stdout  # 1 / 0.008
    assert "time\t0.008\ts" in run(*words).stdout
