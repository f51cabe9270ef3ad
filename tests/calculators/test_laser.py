"""Laser beams, against published hazard distances and against sums over their spots."""

import math

import pytest
from conftest import run
from helpers import for_each, number

import radcalc

POINTER = "--flux 5mW --diameter 1mm --divergence 1mrad"
HAZARD = "--diameter 1mm --divergence 1mrad --profile uniform"


@for_each([
    # cozingmedical.com/faq/1243.html, of 1 mrad: 225 m for 1 W and 500 m for 5 W at 0.25 s,
    # whose limit is 2.54 mW/cm2 (barbella.ch, "NOHD for a 1/4 second exposure")
    (f"--flux 1W {HAZARD} --limit 2.54mW/cm2", "hazard-distance:m", 225, 0.01),
    (f"--flux 5W {HAZARD} --limit 2.54mW/cm2", "hazard-distance:m", 500, 0.01),
    # there, of 1 W: flash blindness within 1.1 km, glare within 5 km, distraction within
    # 50 km, which are the FAA's 100, 5 and 0.05 uW/cm2
    (f"--flux 1W {HAZARD} --limit 100uW/cm2", "hazard-distance:km", 1.1, 0.03),
    (f"--flux 1W {HAZARD} --limit 5uW/cm2", "hazard-distance:km", 5, 0.02),
    (f"--flux 1W {HAZARD} --limit 0.05uW/cm2", "hazard-distance:km", 50, 0.02),
    # "divide the above numbers by 2" at 2 mrad
    ("--flux 1W --diameter 1mm --divergence 2mrad --profile uniform --limit 100uW/cm2",
     "hazard-distance:km", 0.55, 0.03),
    # the range equation of laser safety, by hand: (sqrt(4 0.1 / (pi 25)) - 0.001) / 0.001
    (f"--flux 100mW {HAZARD} --limit 25W/m2", "hazard-distance:m",
     (math.sqrt(0.4 / (math.pi * 25)) - 0.001) / 0.001, 1e-9),
    # calculator.academy, of a Gaussian beam: sqrt(4 P / (pi MPE) - d0^2) / theta, for which
    # the mean of our spot is taken: our peak is twice that
    (f"{POINTER} --limit 50W/m2", "hazard-distance:m",
     math.sqrt(0.02 / (math.pi * 25) - 1e-6) / 1e-3, 1e-9),
    # by hand: a spot of 100 mm at 100 m and 1 mrad, to 5e-5
    (f"{POINTER} --distance 100m", "spot-diameter:mm", math.hypot(1, 100), 1e-9),
    (f"{POINTER} --distance 100m --profile uniform", "spot-diameter:mm", 101, 1e-9),
    # 2 P / (pi w^2)
    ("--flux 5mW --diameter 2mm", "peak-irradiance", 2 * 5e-3 / (math.pi * 1e-6), 1e-9),
    ("--flux 5mW --diameter 2mm", "irradiance", 5e-3 / (math.pi * 1e-6), 1e-9),
    ("--flux 5mW --diameter 2mm --profile uniform", "peak-irradiance",
     5e-3 / (math.pi * 1e-6), 1e-9),
    ("--energy 10mJ --diameter 2mm", "exposure:J/m2", 1e-2 / (math.pi * 1e-6), 1e-9),
    ("--energy 10mJ --time 5ns --diameter 2mm", "flux:MW", 2, 1e-9),
    # 86.5 % of the flux is within 1/e^2
    ("--flux 1mW --diameter 7mm --receiver-diameter 7mm", "received-flux:mW",
     1 - math.exp(-2), 1e-9),
    ("--flux 1mW --diameter 7mm --receiver-diameter 3.5mm --profile uniform",
     "received-flux:mW", 0.25, 1e-9),
    ("--flux 1mW --diameter 3mm --receiver-diameter 7mm --profile uniform",
     "received-flux:mW", 1, 1e-9),
    # back from each
    (f"{POINTER} --irradiance 1W/m2", "distance:m",
     math.sqrt(4 * 5e-3 / math.pi - 1e-6) / 1e-3, 1e-9),
    (f"{POINTER} --profile uniform --spot-diameter 11mm", "distance:m", 10, 1e-9),
    ("--diameter 3mm --distance 4m --spot-diameter 5mm", "divergence:mrad", 1, 1e-9),
    ("--divergence 1mrad --distance 4m --spot-diameter 5mm", "diameter:mm", 3, 1e-9),
    ("--diameter 1mm --divergence 1mrad --limit 25W/m2 --hazard-distance 10m", "flux:mW",
     25 * math.pi * (1e-6 + 1e-4) / 8 * 1e3, 1e-9),
    ("--flux 5mW --diameter 1mm --limit 25W/m2 --hazard-distance 10m", "divergence:mrad",
     100 * math.sqrt(8 * 5e-3 / (math.pi * 25) - 1e-6), 1e-9),
    # 5 mW at 532 nm are 0.005 683.002 V(532 nm) = 3.022 lm (CIE 018:2019: V = 0.88496)
    ("--flux 5mW --wavelength 532nm --diameter 2mm", "illuminance:lx",
     0.005 * 683.002 * 0.88496 / (math.pi * 1e-6), 1e-5),
])  # fmt: skip
def test_a_beam_follows_from_any_sufficient_set(words, asked, expected, rel):
    done = run("laser", *words.split(), "-q", "-g", asked)
    assert float(done.stdout) == pytest.approx(expected, rel=rel)


def disc(function, radius, rings=20_000):
    """Sum up a function of the distance from the axis over a disc, ring by ring."""
    step = radius / rings
    return sum(
        function((k + 0.5) * step) * 2 * math.pi * (k + 0.5) * step * step for k in range(rings)
    )


@pytest.mark.parametrize("receiver", [0.5e-3, 2e-3, 7e-3, 20e-3])
def test_a_gaussian_beam_equals_its_sum_over_rings(receiver):
    """Flux, mean, peak, and flux through an aperture."""
    found = radcalc.laser(
        flux="1 mW",
        diameter="2 mm",
        divergence="1.2 mrad",
        distance="4 m",
        receiver_diameter=f"{receiver} m",
    )
    peak, spot = number(found, "peak_irradiance", "W/m2"), number(found, "spot_diameter", "m")

    def irradiance(r):
        return peak * math.exp(-2 * (r / (spot / 2)) ** 2)

    assert irradiance(spot / 2) == pytest.approx(peak / math.e**2)
    assert disc(irradiance, 5 * spot) == pytest.approx(1e-3, rel=1e-6)
    assert number(found, "irradiance", "W/m2") == pytest.approx(
        disc(irradiance, 5 * spot) / (math.pi * spot**2 / 4), rel=1e-6
    )
    assert number(found, "received_flux", "W") == pytest.approx(
        disc(irradiance, receiver / 2), rel=1e-6
    )


def test_a_beam_spreads_like_a_solution_of_the_wave_equation():
    """w(z) = w0 sqrt(1 + (z lambda / (pi w0^2))^2), whose full angle is 4 lambda / (pi D)."""
    wave, waist = 632.8e-9, 0.4e-3
    angle = 4 * wave / (math.pi * 2 * waist)
    for away in (0.1, 0.8, 5.0, 300.0):
        found = radcalc.laser(
            diameter=f"{2 * waist} m", divergence=f"{angle} rad", distance=f"{away} m"
        )
        exact = waist * math.sqrt(1 + (away * wave / (math.pi * waist**2)) ** 2)
        assert number(found, "spot_diameter", "m") == pytest.approx(2 * exact, rel=1e-12)


def test_a_limit_that_the_beam_never_reaches_has_no_hazard_distance():
    done = run("laser", *POINTER.split(), "--limit", "13kW/m2", "-g", "hazard-distance:m")
    assert done.stdout == "0\n"
    assert "below the limit at the laser's exit" in done.stderr


def test_the_definitions_are_stated():
    done = run("laser", *POINTER.split(), "--distance", "10m", "--limit", "25W/m2")
    for said in ("1/e^2", "86.5 %", "full angle", "as given, applies to the peak"):
        assert said in done.stderr
    done = run("laser", "--flux", "5mW", "--diameter", "1mm")
    assert "at the laser's exit (no --distance)" in done.stderr


def test_less_divergence_than_diffraction_is_noted():
    """4 lambda / (pi D) is 0.677 mrad at 532 nm and 1 mm."""
    words = "laser --flux 5mW --diameter 1mm --limit 25W/m2 --wavelength 532nm --divergence {}mrad"
    assert "0.677 mrad" in run(*words.format(0.6).split()).stderr
    assert "diffraction" not in run(*words.format(0.7).split()).stderr


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ("", "the beam is missing"),
        ("--profile gaussian", "the beam is missing"),
        ("--flux 5mW --diameter 1mm --distance 10m", "needs further inputs"),
        ("--flux 5mW --diameter 2mm --spot-diameter 3mm", "--diameter 2mm needs further inputs"),
        ("--flux 5mW --diameter 1mm --irradiance 100W/m2", "--diameter 1mm needs further inputs"),
        ("--flux 5mW --diameter 1mm --divergence 20deg", "out of range"),
        ("--diameter 1mm --distance 10m --spot-diameter 0.5mm", "the beam would become narrower"),
        ("--diameter 1mm --distance 1m --spot-diameter 1m", "a divergence of 999.9"),
        ("--flux 1mW --received-flux 2mW --diameter 1mm", "laser has no --received-flux option"),
        ("--flux 5mW --diameter 1mm --profile square", "square"),
        ("--flux 5mW --diameter 1mm --limit 25W/m2", "alone is not enough for a hazard distance"),
        ("--divergence 1mrad --distance 10m --spot-diameter 10mm", "even of a beam without width"),
        ("--divergence 0.3mrad --distance 10m --spot-diameter 3mm", "even of a beam without width"),
        (f"{POINTER} --irradiance 10kW/m2", "the beam would become narrower"),
        (f"{POINTER} --limit 25lx", "an efficacy that links them"),
    ],
)
def test_impossible_beams_are_refused(words, message):
    done = run("laser", *words.split())
    assert done.returncode == 2
    assert message in done.stderr


def test_arrays_of_distances():
    away = radcalc.Quantity([10.0, 100.0], "m")
    found = radcalc.laser(flux="5 mW", diameter="1 mm", divergence="1 mrad", distance=away)
    spots = [math.hypot(1e-3, 1e-3 * d) for d in (10, 100)]
    peaks = [8 * 5e-3 / (math.pi * spot**2) for spot in spots]
    assert found["peak_irradiance"].to("W/m2").magnitude == pytest.approx(peaks)
