"""Ranges of spectra: sums end with the data, and the answer states the range.

A case has a random table and random ranges of watts and photons.  The amounts are compared with
NumPy's trapezoidal rule over the range in the answer, which must be within the table and the
range.
"""

import random
import re

import numpy as np
from fuzz.command import main

from radcalc.calculators.spectrum import spectrum as describe
from radcalc.errors import ConditionError
from radcalc.inputs import Input
from radcalc.inputs.reading import read
from radcalc.quantities.symbols import SYMBOLS
from radcalc.spectra.arrays import ArrayTable
from radcalc.spectra.spectrum import Table

SHORT, LONG = 100, 20_000
COUNTED = re.compile(
    r"(?:watts counted over|of the light in) ([\d.e+]+)-([\d.e+]+) nm.*?photons counted "
    r"over ([\d.]+)-([\d.]+) nm"
)


def integral(grid, values, low, high):
    """Integrate between two limits with NumPy, on the points of the table and the limits."""
    places = np.unique([low, *grid[(grid > low) & (grid < high)], high])
    return float(np.trapezoid(np.interp(places, grid, values), places))


def sweep(count: int, seed: int) -> str:
    """Check random tables, with ranges inside, across and outside of them."""
    draw = random.Random(seed)
    clipped = refused = absent = 0
    for number in range(count):
        size = draw.randint(2, 40)
        start, end = sorted((draw.uniform(200, 900), draw.uniform(200, 1500)))
        grid = np.unique([start, end, *(draw.uniform(start, end) for _ in range(size))])
        values = np.array([draw.uniform(0, 9) for _ in grid])
        kind = draw.choice((Table, ArrayTable))
        source = kind("table", grid, values) if kind is ArrayTable else None
        source = source or Table("table", grid.tolist(), values.tolist())
        given = {"spectrum": Input(SYMBOLS["spectrum"], "table", source)}
        asked = {"range": (start, end), "photon-range": (400.0, 700.0)}
        for name in asked:
            if draw.random() < 0.7:
                low = round(draw.uniform(150, 1200), draw.choice((0, 1)))
                asked[name] = (low, low + round(draw.uniform(1, 900)))
                text = "{:.10g}nm:{:.10g}nm".format(*asked[name])
                given[name] = read(name, text)
        case = (seed, number, (start, end), asked)
        try:
            answer = describe(given)
        except ConditionError as error:
            problem = error.message
            answer = None
        if answer is None:
            assert "no power" in problem, case
            assert asked["range"][1] <= start or asked["range"][0] >= end, (case, problem)
            refused += 1
            continue
        by_name = {value.name: value for value in answer.values}
        found = COUNTED.search("; ".join(answer.assumptions))
        assert found, (case, answer.assumptions)
        notes = " ".join(answer.notes)
        claims = {"range": found.groups()[:2], "photon-range": found.groups()[2:]}
        for name, what in (("range", "watts"), ("photon-range", "photons")):
            ends = asked[name]
            if name == "photon-range" and "range" in given:  # a part of it
                ends = max(ends[0], asked["range"][0]), min(ends[1], asked["range"][1])
            low, high = max(ends[0], start), min(ends[1], end)
            if low >= high:
                continue  # no photons there: the result is absent
            claim = [float(text) for text in claims[name]]
            assert np.allclose(claim, (low, high), rtol=1e-5), (case, claim)
            is_clipped = (low, high) != ends and (name == "range" or "range" not in given)
            assert (f"{what} are counted over" in notes) == is_clipped, (case, notes)
            clipped += is_clipped
        low, high = max(asked["range"][0], start), min(asked["range"][1], end)
        assert np.isclose(by_name["range-start"].amount, low * 1e-9), case
        assert np.isclose(by_name["range-end"].amount, high * 1e-9), case
        share = integral(grid, values, low, high) / integral(grid, values, start, end)
        assert np.isclose(by_name["range-fraction"].amount, share, rtol=1e-9), case
        for name, most in (
            ("luminous-efficacy", 683.002),
            ("photon-efficacy", photons_per_joule(end)),
        ):
            value = by_name[name]
            absent += value.is_absent
            assert value.is_absent or value.amount <= most * (1 + 1e-9), (case, name, value.amount)
    return f"{clipped} ranges cut at the data, {refused} outside of them, {absent} absent ratios"


def photons_per_joule(nanometres: float) -> float:
    """Return the photons per joule at a wavelength, from the SI's h and c."""
    return nanometres * 1e-9 / (6.62607015e-34 * 299792458)


if __name__ == "__main__":
    main(sweep, LONG)
