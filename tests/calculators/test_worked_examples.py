"""Worked examples of textbooks, lecture notes and manuals, to the digits printed.

Each example names its source, the inputs and the printed numbers, which are right to half a unit of
the last digit.
"""

import math
from collections.abc import Callable
from decimal import Decimal
from typing import Any

import numpy as np
from helpers import for_each, number

import radcalc
from radcalc import calorimeter, ev, lambertian, point_source

SCHAUM = (
    "Schaum's Outline of Applied Physics, ch. 30, https://digilib.universitaspertamina.ac.id/"
    "ebook/Schaum's%20Outline%20of%20Theory%20and%20Problems%20of%20Applied%20Physics/files/"
    "basic-html/"
)
MEHTA = (
    "V. K. Mehta and R. Mehta, Principles of Physics, ch. 20, http://tbc-python.fossee.in/"
    "convert-notebook/principle_of_physics_by_V.K.MEHTA_,_ROHIT_MEHTA_/chapter20_3.ipynb, "
)
IRODOV = "I. E. Irodov, Problems in General Physics, https://solveirodov.com/problems/"
EES = "F-Chart EES manual, after Siegel and Howell, https://fchartsoftware.com/ees/"
EV_TABLE = (
    "Exposure value, table of EV100, luminance (K = 12.5) and illuminance (C = 250), "
    "https://e-com-net.com/article/1275207877182636032.htm"
)


def strip(f: Callable[[float], Any], low: float, high: float) -> float:
    """Return the mean of configuration factors over an interval, by Gauss-Legendre quadrature."""
    nodes, weights = np.polynomial.legendre.leggauss(12)
    at = (low + high) / 2 + (high - low) / 2 * nodes
    return float(sum(w * f(float(x)) for w, x in zip(weights, at, strict=True))) / 2


def beside_rectangle(x: float) -> float:
    """Return the factor of an element 0.5 m below the edge of a parallel 3 m by 2 m rectangle."""
    found = lambertian(
        "rectangle", width="3m", length="2m", height="0.5m", offset="1.5m", offset_y=f"{x!r}m",
        luminance="1cd/m2",
    )  # fmt: skip
    return number(found, "configuration_factor", "1")


def across_rectangle(x: float) -> float:
    """Return the factor of an element across a rectangle of 1 m by 2 m, 0.5 m from its edge."""
    found = lambertian(
        "rectangle", perpendicular=True, width="2m", length="1m", height="0.5m", offset_y="0.5m",
        offset=f"{x!r}m", luminance="1cd/m2",
    )  # fmt: skip
    return number(found, "configuration_factor", "1")


def under_sphere(r: float) -> float:
    """Return the weighted factor of an element at r on a plane that touches a sphere of 1 m."""
    found = lambertian(
        "sphere", radius="1m", distance=f"{math.hypot(1, r)!r}m",
        incidence=f"{math.degrees(math.atan(r))!r}deg", luminance="1cd/m2",
    )  # fmt: skip
    return number(found, "configuration_factor", "1") * 2 * r


def drop_of_water() -> dict[str, Any]:
    """Return the answer for 1e15 photons/s of 0.75 um, absorbed for 10 s by 0.2 mg of water."""
    power = radcalc.convert("1e15 photon/s", "W", wavelength="0.75um")
    return calorimeter(flux=power, time="10s", mass="0.2mg", specific_heat="4200J/kg/K")


# source, (call, name of the result, unit, printed number) ...
EXAMPLES: list[tuple[str, list[tuple[Callable[[], Any], str, str, str]]]] = [
    ("BYJU'S, A point source emitting 628 lumen, https://byjus.com/question-answer/"
     "a-point-source-emitting-628-lumen-of-luminous-flux-uniformly-in-all-directions-is-placed",
     [(lambda: point_source(flux="628lm", distance="1.0m", incidence="37deg"),
       "irradiance", "lx", "40"),
      (lambda: point_source(flux="628lm"), "intensity", "cd", "50")]),
    (IRODOV + "5-12",
     [(lambda: lambertian("sphere", luminance="2.0e4cd/m2", radius="6.0cm", distance="3.0m"),
       "irradiance", "lx", "25")]),
    (IRODOV + "5-11",
     [(lambda: lambertian("disc", radius="25cm", distance="75cm", illuminance="70lx"),
       "exitance", "lm/m2", "7e2")]),
    (IRODOV + "5-6, at the height h = R",
     [(lambda: lambertian(luminance="1.6e4cd/m2", area="100cm2", distance="1.41421356m",
                          tilt="45deg", incidence="45deg"), "irradiance", "lx", "40")]),
    (MEHTA + "example 20.1: the sun",
     [(lambda: point_source(illuminance="2.5e5lx", distance="1.5e11m"),
       "intensity", "cd", "5.625e27"),
      (lambda: point_source(illuminance="2.5e5lx", distance="1.5e11m"),
       "flux", "lm", "7.069e28")]),
    (MEHTA + "example 20.3: 35 cd at 5 lm/W",
     [(lambda: {"power": point_source(intensity="35cd")["flux"] / radcalc.Quantity(5, "lm/W")},
       "power", "W", "88")]),
    (MEHTA + "example 20.4",
     [(lambda: point_source(flux="1260lm", height="8m"), "irradiance", "lx", "1.57"),
      (lambda: point_source(flux="1260lm", height="8m", offset="6m"),
       "irradiance", "lx", "0.8")]),
    (MEHTA + "example 20.5",
     [(lambda: point_source(intensity="250cd", height="6m"), "irradiance", "lx", "6.94"),
      (lambda: point_source(intensity="250cd", height="6m", offset="8m"),
       "irradiance", "lx", "1.5")]),
    (MEHTA + "example 20.6: the same exposure at 0.5 m in 2.5 s and at 1 m",
     [(lambda: point_source(
         intensity="1cd", distance="1m",
         exposure=point_source(intensity="1cd", distance="0.5m", time="2.5s")["exposure"]),
       "time", "s", "10.0")]),
    ("Chapter 49: Illumination, example 49.1, "
     "https://huggingface.co/datasets/nvidia/Nemotron-CC-Math-v1",
     [(lambda: point_source(flux="1200lm", height="8m", offset="6m"),
       "irradiance", "lx", "0.76")]),
    ("A 450 cd light source creates an illumination of 30 lux, https://www.univerkov.com/"
     "a-450-cd-light-source-creates-an-illumination-of-30-lux-at-a-distance-of-three-meters/",
     [(lambda: point_source(
        any_incidence=True, intensity="450cd", illuminance="30lx", distance="3m"),
       "incidence", "deg", "53.13")]),
    (SCHAUM + "page391.html: the spotlight of 30.6",
     [(lambda: point_source(intensity="150cd"), "flux", "lm", "1885"),
      (lambda: point_source(flux="1885lm", solid_angle="0.0032sr"),
       "intensity", "cd", "5.89e5")]),
    (SCHAUM + "page391.html: solved problem 30.7",
     [(lambda: point_source(intensity="90cd", illuminance="800lx", incidence="30deg"),
       "distance", "m", "0.31")]),
    (SCHAUM + "page391.html: solved problem 30.8",
     [(lambda: point_source(flux="840lm", distance="2m"), "intensity", "cd", "66.8"),
      (lambda: point_source(flux="840lm", distance="2m"), "irradiance", "lx", "16.7"),
      (lambda: point_source(
          flux="840lm", irradiance=2 * point_source(flux="840lm", distance="2m")["irradiance"]),
       "distance", "m", "1.41")]),
    (SCHAUM + "page392.html: solved problem 30.9",
     [(lambda: {"ratio": point_source(intensity="1cd", height="6ft")["irradiance"]
                / point_source(intensity="1cd", height="6ft", offset="4ft")["irradiance"]},
       "ratio", "1", "1.7")]),
    ("Calculation of radiometric quantities, II.5.a, "
     "https://light-measurement.com/calculation-of-radiometric-quantities/",
     [(lambda: point_source(flux="10W"), "intensity", "W/sr", "0.796")]),
    ("Catellani & Smith, Unità di misura, "
     "https://www.catellanismith.com/glossary-cat/unita-di-misura: an LED of 2.4 cd over 120 deg",
     [(lambda: point_source(intensity="2.4cd", apex_angle="120deg"), "flux", "lm", "7.5")]),
    (EV_TABLE,
     [(lambda n=n: ev(ev100=n), name, unit, printed)
      for n, luminance, illuminance in (
          (-4, "0.008", "0.156"), (-1, "0.063", "1.25"), (0, "0.125", "2.5"), (5, "4", "80"),
          (8, "32", "640"), (12, "512", "10240"), (14, "2048", "40960"))
      for name, unit, printed in (
          ("luminance", "cd/m2", luminance), ("illuminance", "lx", illuminance))]),
    ("Paul, Olympus mailing list, https://mlarchive.de/Olympus-OM/2001-09/msg02190.html",
     [(lambda: ev(f_number=16, time="1/125s"), "ev", "1", "15")]),
    ("Wartość ekspozycji, http://optyczne.pl/index.php?slownik=83",
     [(lambda: ev(f_number=8, time="1/60s"), "ev", "1", "12"),
      (lambda: ev(f_number=11, time="1/30s"), "ev", "1", "12"),
      (lambda: ev(f_number=32, time="1/4s"), "ev", "1", "12")]),
    ("ChemiLab, Exposure Value, http://www.chemilab.net/web/photography.html",
     [(lambda: ev(f_number=1, time="1/125s"), "ev100", "1", "7"),
      (lambda: ev(f_number=5.6, time="1s"), "ev100", "1", "5"),
      (lambda: ev(f_number=1, time="1s", iso=400), "ev100", "1", "-2")]),
    ("flutter3d_game, PhysicalCamera: f/4, 1/60 s, ISO 100, saturation at 1.2 x 960 cd/m2, "
     "https://pub.dev/documentation/flutter3d_game/1.0.0-rc.2/flutter3d_game/"
     "PhysicalCamera-class.html",
     [(lambda: ev(f_number=4, time="1/60s"), "ev100", "1", "9.907"),
      (lambda: ev(f_number=4, time="1/60s"), "saturation_luminance", "cd/m2", "1152")]),
    ("Calorimetry numerical, question 4, "
     "https://physicsteacher.in/2023/03/31/calorimetry-numerical-solution-a4-solved/",
     [(lambda: calorimeter(mass="100g", temperature_rise="50K", specific_heat="390J/kg/K"),
       "energy", "J", "1950")]),
    ("Specific heat example problem, http://chemistry.about.com/od/workedchemistryproblems/a/"
     "Specific-Heat-Example-Problem.htm",
     [(lambda: calorimeter(energy="487.5J", mass="25g", temperature_rise="50K"),
       "specific_heat", "J/g/K", "0.39")]),
    ("A drop of water in a laser's beam, https://reshimvse.com/zadacha.php?id=132",
     [(drop_of_water, "temperature_rise", "K", "3.2")]),
    ("A piece of copper, from 18 to 18.105 C, https://www.univerkov.com/to-what-temperature-"
     "a-piece-of-copper-with-a-mass-of-400-g-will-be-heated-if-we-give-it-16-8-j-of-energy-at-"
     "18-temperatures/",
     [(lambda: calorimeter(energy="16.8J", mass="400g", specific_heat="400J/kg/K"),
       "temperature_rise", "K", "0.105")]),
    ("Inverse square law, http://www.zonlichthk.com/en/displaynews.php?newsID=256",
     [(lambda: point_source(intensity="100cd", distance="3m"), "irradiance", "lx", "11"),
      (lambda: point_source(intensity="100cd", distance="2m"), "irradiance", "lx", "25")]),
    ("Photometry, question 13, https://vidyadip.com/uttarakhand_14/std-11-science_285/"
     "physics_785/photometry_4201/3-marks-question_23319",
     [(lambda: point_source(illuminance="15lx", distance="60cm"), "intensity", "cd", "5.4"),
      (lambda: point_source(intensity="5.4cd", height="60cm", offset="80cm"),
       "irradiance", "lx", "3.24")]),
    ("HC Verma solutions, ch. 22, "
     "https://infinitylearn.com/blog/hc-verma-solutions-class-11-chapter-22-photometry",
     [(lambda: point_source(flux="1000lm", distance="2m"), "irradiance", "lx", "19.89"),
      (lambda: point_source(flux="500lm", solid_angle="2sr"), "intensity", "cd", "250")]),
    ("Lux to candela, https://www.thinkcalculator.com/light/lux-to-candela-calculator.php",
     [(lambda: point_source(illuminance="500lx", distance="2m"), "intensity", "cd", "2000")]),
    ("Precalculus, ch. 5, problem 70: 18 lm/ft2 of 90 cd at 25 deg, https://vaia.com/en-us/"
     "textbooks/math/precalculus-2-edition/chapter-5/"
     "problem-70-illumination-of-a-surface-efraci-cos-thetad2-the-",
     [(lambda: point_source(intensity="90cd", illuminance="18lm/ft2", incidence="25deg"),
       "distance", "ft", "2.13")]),
    ("A. Lee, Lighting for Electricians, ch. 10, "
     "https://pressbooks.bccampus.ca/lightingforelectricians/?p=49: 100 lx at 1 m",
     [(lambda: point_source(
         intensity=point_source(illuminance="100lx", distance="1m")["intensity"], distance="3m"),
       "irradiance", "lx", "11.1")]),
    ("Inverse square law, 40 lx at 0.5 m, https://technikerschule-beckum.de/maschinen/projekte/"
     "2006_07/p18/53926998e610f9605/53926998e61103011/index.html",
     [(lambda: point_source(
         intensity=point_source(illuminance="40lx", distance="0.5m")["intensity"],
         distance="1m"), "irradiance", "lx", "10")]),
    ("Luminance for Lambertian surfaces, "
     "https://ipv4.calculatoratoz.com/en/luminance-for-lambertian-surfaces-calculator/Calc-38517",
     [(lambda: lambertian(incident_illuminance="0.8lx", reflectance=1),
       "radiance", "cd/m2", "0.254647908947033")]),
    ("Chapter 3: Thermal Radiation, example 3.1 (per um), "
     "https://huggingface.co/datasets/nvidia/Nemotron-CC-Math-v1",
     [(lambda: lambertian("sphere", exitance="82995768.8548W/m2", radius="0.695e6km",
                          distance="1.496e8km"), "irradiance", "W/m2", "1791.2755")]),
    (EES + "heat_transfer_library/shape_factors/hs301.htm: a strip parallel to a rectangle",
     [(lambda: {"f": radcalc.Quantity(strip(beside_rectangle, -1, 1), "1")}, "f", "1", "0.3886")]),
    (EES + "heat_transfer_library/shape_factors/hs303.htm: a strip across a rectangle",
     [(lambda: {"f": radcalc.Quantity(strip(across_rectangle, -1, 1), "1")}, "f", "1", "0.2153")]),
    (EES + "heat_transfer_library/shape_factors/hs306.htm: a disc that a sphere touches",
     [(lambda: {"f": radcalc.Quantity(strip(under_sphere, 0, 1), "1")}, "f", "1", "0.5858")]),
]  # fmt: skip


@for_each([(source, *case) for source, cases in EXAMPLES for case in cases])
def test_printed_examples_agree_to_their_digits(source, call, name, unit, printed):
    half = Decimal((0, (5,), Decimal(printed).as_tuple().exponent - 1))
    value = Decimal(number(call(), name, unit))
    assert abs(value - Decimal(printed)) <= half, (source, value, printed)


def test_there_are_more_than_twenty_sources():
    assert len({source for source, _ in EXAMPLES}) == len(EXAMPLES) >= 20
