"""Wrong answers by family: integrals, levels, hot bodies, lamps, rooms, and rounding on the way.

As in `corpus.py`, the numbers come from the misused formulas, never from radcalc.  Integrals are
computed by the midpoint rule.
"""

from collections.abc import Callable
from math import asin, cos, degrees, e, exp, log, log10, pi, radians, sin, sqrt

from homework.corpus import C, H, Wrong, c, cap, s

SIGMA, EV, WIEN = 5.670374419e-8, 1.602176634e-19, 2.897771955e-3  # CODATA 2022
ROOM = "room --width 6m --length 9m --illuminance 500lx --flux 3600lm --utilance 0.6"
LAMPS = 500 * 54 / 3600  # without utilance and maintenance
LIT = "room --width 6m --length 9m --luminaires 12 --flux 3600lm --utilance 0.6 --maintenance 0.8"
TENTH = "integrate '100*cos(theta)**10' --polar 0deg:45deg"
SQUARE = "integrate 'cos(theta)**2' --hemisphere"
BEAM = "laser --flux 5mW --diameter 1mm --divergence 1.5mrad --distance 20m"
DIODE = "sensor --flux 0.1uW --wavelength 800nm --quantum-efficiency 0.6"
SCREEN = "screen --flux 3000lm --width 2.1m --aspect 16/9 --gain 1.3"


def over(function: Callable[[float], float], low: float, high: float) -> float:
    """Return the integral of a function of an angle [degrees]."""
    count, low, high = 20_000, radians(low), radians(high)
    step = (high - low) / count
    return step * sum(function(low + (k + 0.5) * step) for k in range(count))


def narrow(angle: float) -> float:
    return exp(-((degrees(angle) / 20) ** 2))


FAMILIES = [
    # --- conversions: divided by the factor, not multiplied
    Wrong("convert 500 lx lx.h --time 8h", "", "lx.h", 500 / 8, "factor-upside-down"),
    Wrong("convert 37 lm W --efficacy 251lm/W", "", "W", 37 * 251,
          "factor-upside-down|efficacy-upside-down"),
    # --- integrals
    Wrong(SQUARE, "integral", "sr", 2 * pi * over(lambda t: cos(t) ** 2, 0, 90), "sine-forgotten"),
    Wrong(SQUARE, "integral", "sr", 2 * pi * over(lambda t: cos(t) ** 3 * sin(t), 0, 90),
          "cosine-added"),
    Wrong(SQUARE, "integral", "sr", 2 * pi * over(lambda t: cos(t) * sin(t), 0, 90),
          "integrand-without-cosine"),
    Wrong(SQUARE, "integral", "sr", 4 * pi / 3, "whole-for-half"),
    Wrong("integrate 'cos(theta)**2' --sphere", "integral", "sr", 2 * pi / 3,
          "whole-for-half|half-azimuth"),
    Wrong(SQUARE, "integral", "sr", 2 * pi * over(lambda t: cos(t) ** 2 * sin(t) ** 2, 0, 90),
          "sine-twice"),
    Wrong(TENTH, "integral", "sr", 200 * pi * over(lambda t: cos(t) ** 10, 0, 45),
          "sine-forgotten"),
    Wrong(TENTH, "integral", "sr", 200 * pi * over(lambda t: cos(t) ** 10 * sin(t), 0, 22.5),
          "full-for-half"),
    Wrong("integrate '100*cos(theta)**2' --polar 0deg:50deg", "integral", "sr", 200 * pi / 3,
          "wrong-limits"),
    Wrong(TENTH, "integral", "sr", 100 * over(lambda t: cos(t) ** 10 * sin(t), 0, 45),
          "azimuth-forgotten"),
    Wrong(TENTH, "integral", "sr", 100 * pi * over(lambda t: cos(t) ** 10 * sin(t), 0, 45),
          "half-azimuth"),
    Wrong("integrate 'exp(-(theta/(20*deg))**2)' --half-angle 60deg", "integral", "sr",
          2 * pi * over(narrow, 0, 60), "sine-forgotten"),
    Wrong("integrate 'exp(-(theta/(20*deg))**2)' --half-angle 60deg", "integral", "sr",
          2 * pi * over(lambda t: narrow(t) * sin(t) * cos(t), 0, 60), "cosine-added"),
    Wrong("integrate '50*cos(theta)' --half-angle 35deg --unit cd", "integral", "lm",
          100 * pi * s(35), "sine-forgotten"),
    Wrong("integrate 1 --polar 20deg:50deg", "integral", "sr", 2 * pi * 30,
          "degrees-in-integral"),
    Wrong("solid-angle zone --polar 20deg:50deg", "solid-angle", "sr", 2 * pi * (c(20) + c(50)),
          "cosines-added"),
    Wrong("solid-angle zone --polar 20deg:50deg", "solid-angle", "sr", cap(25) - cap(10),
          "full-for-half"),
    Wrong("solid-angle zone --polar 20deg:50deg", "solid-angle", "sr", pi * (c(20) - c(50)),
          "half-azimuth"),
    # --- shapes
    Wrong("solid-angle rectangle --width 80cm --length 50cm --height 60cm --corner", "solid-angle",
          "sr", 80 * 50 / (60 * sqrt(80**2 + 50**2 + 60**2)), "tangent-for-angle"),
    Wrong("solid-angle rectangle --width 3m --length 2m --height 1.7m", "solid-angle", "sr",
          6 / 1.7, "flat-for-curved"),
    Wrong("solid-angle disc --diameter 24cm --distance 40cm", "solid-angle", "sr",
          2 * pi * (1 - 0.96), "rounded-early"),
    Wrong("solid-angle disc --diameter 11cm --distance 40cm", "solid-angle", "sr",
          2 * pi * (1 - 0.991), "rounded-early"),
    Wrong("convert 800 lm cd --half-angle 15deg", "", "cd",
          800 * (log(0.5) / log(c(15)) + 1) / (2 * pi), "lobe-for-cone"),
    Wrong("point-source --flux 430lm --half-angle 22deg", "intensity", "cd",
          430 * (log(0.5) / log(c(22)) + 1) / (2 * pi), "lobe-for-cone"),
    Wrong("lambertian hemisphere --luminance 3000cd/m2 --half-angle 40deg", "illuminance", "lx",
          3000 * pi * s(40), "sine-not-squared"),
    Wrong("lambertian hemisphere --luminance 3000cd/m2", "illuminance", "lx", 3000 * 4 * pi,
          "wrong-sphere"),
    Wrong("refraction --index 1.6 --incidence 0deg", "reflectance", "", 0.6 / 2.6,
          "amplitude-for-intensity"),
    Wrong("refraction --index 1.5 --incidence 40deg", "brewster-angle", "deg",
          degrees(asin(1 / 1.5)), "other-quantity"),
    Wrong(BEAM, "spot-diameter", "mm", sqrt(1 + 15**2), "full-for-half"),
    # --- levels
    Wrong("convert 100 mW dBm", "", "dBm", 10 * log(100), "log-base"),
    Wrong("convert 0.02 1 OD", "", "OD", -log(0.02), "log-base"),
    Wrong("convert 1.3 OD %", "", "%", 100 * e**-1.3, "log-base"),
    Wrong("convert 250 mW dBm", "", "dBm", 20 * log10(250), "twice-the-level"),
    Wrong("convert 26 dB 1", "", "", 10 ** (26 / 20), "twice-the-level"),
    Wrong("convert -7 dBm uW", "", "uW", 1e3 * 10**0.7, "level-sign"),
    Wrong("convert 20 % OD", "", "OD", -10 * log10(0.2), "level-factor"),
    Wrong("convert 26 dB 1", "", "", exp(26 / 20), "twice-the-level and log-base"),
    Wrong("ev --stops 4", "nd", "", 4 * log(2), "log-base"),
    Wrong("convert 1.3 OD %", "", "%", 100 * (1 - 10**-1.3), "absorbed-for-reflected"),
    # --- hot bodies
    Wrong("convert 5778 K MW/m2", "", "MW/m2", SIGMA * 5778**3 / 1e6, "temperature-wrong-power"),
    Wrong("convert 200 W/m2 K", "", "K", (200 / SIGMA) ** (1 / 3), "temperature-wrong-power"),
    Wrong("convert 200 W/m2 K", "", "K", sqrt(200 / SIGMA), "temperature-wrong-power"),
    Wrong("spectrum blackbody:2900K", "exitance", "W/m2", SIGMA * 2900**3,
          "temperature-wrong-power"),
    Wrong("convert 400 K W/m2", "", "W/m2", SIGMA * 127**4, "kelvin-for-celsius"),
    Wrong("spectrum blackbody:310K", "peak-wavelength", "um", WIEN / 37 * 1e6,
          "kelvin-for-celsius"),
    Wrong("convert 300 K W/m2 --emissivity 0.9", "", "W/m2", SIGMA * 300**4,
          "emissivity-forgotten"),
    Wrong("convert 300 K W/m2/sr", "", "W/m2/sr", SIGMA * 300**4 / (2 * pi), "two-pi-for-pi"),
    Wrong("convert 3200 K nm", "", "nm", H * C / (1.380649e-23 * 3200) * 1e9,
          "wien-without-4.965"),
    Wrong("convert 5800 K nm", "", "nm", C / (5.878925757e10 * 5800) * 1e9, "wien-per-frequency"),
    Wrong("convert 5800 K nm", "", "nm", WIEN * 5800 * 1e9, "temperature-upside-down"),
    # --- lamps, photons, detectors
    Wrong("convert 50 klx umol/m2/s --spectrum HPS", "", "umol/m2/s", 50e3 / 54, "other-lamp"),
    Wrong("convert 100 klx W/m2 --spectrum LED-B3", "", "W/m2", 1e5 / 93, "other-lamp"),
    Wrong("photon 532nm", "photon-energy", "eV", H * C / 532e-9 * 1e19, "joules-for-electronvolts"),
    Wrong("convert 15 umol/m2/s mol/m2/d", "", "mol/m2/d", 15 * 12 * 3600 / 1e6,
          "hours-of-light"),
    Wrong("convert 15 dli ppfd --photoperiod 14h", "", "umol/m2/s", 15e6 / 86400,
          "hours-of-light"),
    Wrong("convert 5 mW uA --responsivity 0.4A/W", "", "uA", 5e3 / 0.4,
          "responsivity-upside-down"),
    Wrong(DIODE, "current", "nA", 60, "efficiency-for-responsivity"),
    Wrong("sensor --current 12uA --flux 20uW --wavelength 850nm", "quantum-efficiency", "",
          H * C / (EV * 850e-9) / 0.6, "responsivity-upside-down"),
    Wrong("convert 1000 W/m2 V/m --electric-field peak", "", "V/m", sqrt(2000 / 376.730313),
          "impedance-upside-down"),
    Wrong("lambertian --luminance 450cd/m2", "exitance", "lm/m2", 450 * pi**2, "pi-twice"),
    Wrong("sensor --electrons 40000", "snr", "", 40000, "other-quantity"),
    # --- skies
    Wrong("sky overcast --horizontal-illuminance 10klx --toward 60deg", "radiance-toward",
          "cd/m2", 1e4 * 9 / (7 * pi) * c(60), "cosine-of-zenith"),
    Wrong("sky uniform --zenith-luminance 3000cd/m2 --tilt 60deg", "irradiance", "lx",
          3000 * pi * c(60), "ground-for-plane"),
    # --- two mistakes in laws
    Wrong(f"{ROOM} --maintenance 0.8", "luminaires", "", LAMPS,
          "utilance-forgotten and maintenance-forgotten"),
    Wrong(LIT, "illuminance", "lx", 12 * 3600 / 54,
          "utilance-forgotten and maintenance-forgotten"),
    Wrong("point-source --flux 1200lm --distance 3m", "illuminance", "lx", 1200 / (2 * pi * 3),
          "wrong-sphere and distance-not-squared"),
    Wrong("solid-angle disc --radius 3cm --height 4cm", "solid-angle", "sr", pi * (1.5 / 4) ** 2,
          "diameter-for-radius and flat-disc-for-cap"),
    Wrong("etendue --diameter 200um --na 0.22", "etendue", "mm2.sr", pi * pi * 0.2**2 * 0.22,
          "diameter-for-radius and na-not-squared"),
]  # fmt: skip

# Rounding on the way: pi as 3.14, c as 3e8, h as 6.63e-34, e as 1.6e-19, a cosine of three digits,
# and digits that are cut off.
ROUNDED = [
    Wrong("convert 300 K W/m2/sr", "", "W/m2/sr", 5.67e-8 * 300**4 / (2 * 3.14), "two-pi-for-pi"),
    Wrong("lambertian --luminance 1200cd/m2 --area 0.25m2", "flux", "lm", 2 * 3.14 * 1200 * 0.25,
          "two-pi-for-pi"),
    Wrong("lambertian --incident-illuminance 500lx --reflectance 0.83", "luminance", "cd/m2",
          500 / 3.14, "reflectance-forgotten"),
    Wrong(DIODE, "current", "nA", 1.6e-19 * 800e-9 / (6.63e-34 * 3e8) * 100,
          "quantum-efficiency-forgotten"),
    Wrong("photon 532nm", "photon-energy", "eV", 6.63e-34 * 3e8 / 532e-9 / 1.6e-19 / (2 * 3.14),
          "angular-for-cycles"),
    Wrong("photon 850nm", "frequency", "THz", 3e8 / 850e-9 / (2 * 3.14) / 1e12,
          "angular-for-cycles"),
    Wrong("point-source --intensity 1500cd --distance 4m --incidence 50deg", "illuminance", "lx",
          1500 * 0.643 / 4, "distance-not-squared"),
    Wrong("convert 300 cd lx --distance 2m --incidence 30deg", "", "lx", 300 * 0.866 / 2,
          "distance-not-squared"),
    Wrong("convert 250 cd lx --distance 2.2m --incidence 35deg", "", "lx",
          250 * 0.819**2 / 2.2**2, "cosine-squared"),
    Wrong(SCREEN, "luminance", "cd/m2", 3000 / 2.48 / 3.14, "gain-forgotten"),
    Wrong("lambertian --flux 300lm --area 0.05m2", "luminance", "cd/m2", 300 / (4 * 3.14 * 0.05),
          "wrong-sphere"),
    Wrong("solid-angle cone --half-angle 60deg", "solid-angle", "sr", 3.14 * 0.866**2,
          "solid-for-projected"),
    Wrong("solid-angle zone --polar 30deg:60deg", "solid-angle", "sr", 3.14 * (0.866 - 0.5),
          "half-azimuth"),
    Wrong("integrate '50*cos(theta)' --polar 0deg:45deg --unit cd", "integral", "lm",
          2 * 3.14 * 50 * (1 - 0.707**3) / 3, "cosine-added"),
    Wrong("convert 10 nm GHz --wavelength 800nm", "", "GHz",
          2 * 3.14 * 3e8 * 10e-9 / 800e-9**2 / 1e9, "angular-for-cycles"),
    Wrong("etendue --area 3mm2 --na 0.25", "etendue", "mm2.sr", 3.14 * 3 * 0.25,
          "na-not-squared"),
    Wrong("lambertian disc --luminance 1e4cd/m2 --radius 25cm --height 75cm", "illuminance", "lx",
          2 * 3.14 * 1e4 * 0.1, "two-pi-for-pi"),
    Wrong("sensor --luminance 4000cd/m2 --f-number 16", "illuminance", "lx", 3.14 * 4000 / (4 * 16),
          "working-f-number-not-squared"),
]  # fmt: skip
