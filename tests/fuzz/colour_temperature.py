"""Colour temperatures against an independent search and colour-science.

The search evaluates Planck's law and the observer with NumPy and minimises the distance by golden
sections in log T; colour-science uses Ohno's method of 2013, within its range.
"""

import math
import random
import warnings
from typing import Any

import numpy as np
from fuzz.command import main

from radcalc.spectra import colorimetry
from radcalc.spectra.colorimetry import load_colour
from radcalc.spectra.data.colours import X, Z
from radcalc.spectra.data.observers import PHOTOPIC
from radcalc.spectra.sources import spectrum
from radcalc.spectra.spectrum import Table

SHORT, LONG = 10, 4000
GRID = np.arange(360.0, 831.0)
FUNCTIONS = np.array([X, PHOTOPIC[1], Z])
GOLDEN = (math.sqrt(5) - 1) / 2


def chromaticity(spectra: Any) -> Any:
    """Compute CIE 1960 (u, v) by the trapezoidal rule."""
    x, y, z = np.trapezoid(FUNCTIONS * spectra, dx=1.0, axis=1)
    return np.array([4 * x, 6 * y]) / (x + 15 * y + 3 * z)


def planckian(temperature: float) -> Any:
    """Compute the Planckian locus, with CODATA's second radiation constant."""
    x = 1.438776877e7 / (GRID * temperature)
    return chromaticity(GRID**-5 / np.expm1(x))


def normal(temperature: float) -> Any:
    """Return the unit vector across the locus, upwards."""
    along = planckian(temperature * 1.0001) - planckian(temperature / 1.0001)
    across = np.array([-along[1], along[0]]) / np.hypot(*along)
    return across if across[1] > 0 else -across


def nearest(colour: Any) -> float:
    """Find the temperature of the nearest black body."""

    def distance(log_t: float) -> float:
        return float(np.hypot(*(planckian(math.exp(log_t)) - colour)))

    coarse = np.linspace(math.log(250), math.log(1e9), 120)
    best = min(range(len(coarse)), key=lambda k: distance(coarse[k]))
    low, high = coarse[max(best - 1, 0)], coarse[min(best + 1, len(coarse) - 1)]
    while high - low > 1e-8:
        a, b = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
        low, high = (low, b) if distance(a) < distance(b) else (a, high)
    return math.exp((low + high) / 2)


def of_colour(colour: Any) -> Table:
    """Make a spectrum of a chromaticity: three narrow bands in the right proportion."""
    bands = [np.where(abs(GRID - place) < 8, 1.0, 0.0) for place in (450, 540, 620)]
    u, v = colour
    y = 1.0
    total = 6 * y / v  # X + 15 Y + 3 Z
    wanted = [u * total / 4, y, (total - u * total / 4 - 15 * y) / 3]
    parts = np.array([np.trapezoid(FUNCTIONS * band, dx=1.0, axis=1) for band in bands]).T
    return Table("", GRID.tolist(), (np.linalg.solve(parts, wanted) @ bands).tolist())


def sweep(count: int, seed: int) -> str:
    """Check black bodies, daylights and colours near the locus."""
    draw = random.Random(seed)
    colour = load_colour()
    worst = worst_ohno = 0.0
    for _ in range(count):
        temperature = math.exp(draw.uniform(math.log(1000), math.log(1e6)))
        body = spectrum(f"blackbody:{temperature!r}K").moments(*colorimetry.AT)
        found, duv = colorimetry.temperature_and_distance(body)
        assert abs(found / temperature - 1) < 1e-10, temperature
        assert duv == 0, temperature

        temperature = math.exp(draw.uniform(math.log(700), math.log(60000)))
        offset = draw.uniform(-0.049, 0.049)
        place = planckian(temperature) + offset * normal(temperature)
        light = of_colour(place).moments(*colorimetry.AT)
        found, duv = colorimetry.temperature_and_distance(light)
        case = (temperature, offset, found, duv)
        assert abs(found / temperature - 1) < 1e-6, case
        assert abs(duv - offset) < 1e-9, case
        other = nearest(place)
        worst = max(worst, abs(found / other - 1))
        assert abs(found / other - 1) < 1e-4, (case, other)  # the distance is flat near its minimum

        if 2000 <= temperature <= 20000 and abs(offset) < 0.03:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                ohno = colour.temperature.uv_to_CCT_Ohno2013(place)
            worst_ohno = max(worst_ohno, abs(found / ohno[0] - 1))
            assert abs(found / ohno[0] - 1) < 2e-3, (case, ohno)

        temperature = draw.uniform(4000, 25000)
        light = spectrum(f"daylight:{temperature!r}K").moments(*colorimetry.AT)
        found, duv = colorimetry.temperature_and_distance(light)
        assert abs(found / temperature - 1) < 2e-3, temperature
        beyond = planckian(temperature) + draw.choice((-1, 1)) * 0.052 * normal(temperature)
        try:
            colorimetry.temperature_and_distance(of_colour(beyond).moments(*colorimetry.AT))
        except colorimetry.Undefined:
            continue
        raise AssertionError(f"{beyond} has a colour temperature")
    return f"golden section {worst:.1e}, Ohno {worst_ohno:.1e}"


if __name__ == "__main__":
    main(sweep, LONG)
