"""SI prefixes that put a number from 1 to below 1000, by the SI brochure's table 7."""

import math

import pytest

from radcalc.conversion.plan import plan
from radcalc.units.prefixes import prefixed
from radcalc.units.table import resolve, spellings

SUITED = {
    ("lx", 0.0021): "mlx",
    ("lm", 12345.0): "klm",
    ("lm", -12345.0): "klm",
    ("klx", 1e-5): "mlx",
    ("cd/m2", 12345.0): "kcd/m2",
    ("W/(m2 sr)", 1e7): "MW/(m2 sr)",
    ("W m-2", 5e4): "kW m-2",
    ("umol/m2/s", 0.003): "nmol/m2/s",
    ("µmol/m²/s", 5000.0): "mmol/m²/s",
    ("lux", 0.0021): "millilux",
    ("millilux", 12345.0): "lux",
    ("лк", 12345.0): "клк",
    ("мклк", 1e-4): "плк",
    ("kg", 1e-5): "mg",
    ("mm", 2e-4): "nm",
    ("fc", 1e-5): "mfc",  # which has kilo and milli alone
    ("lm", 999.9999999999999): "klm",  # it is told as 1000
    ("lm", 1e40): "Qlm",
}
LEFT = [
    ("lx", 0.0),
    ("lx", 1.0),
    ("lx", 999.9),
    ("m2", 1e-5),
    ("deg", 0.01),
    ("1", 5e5),
    ("%", 1e-3),
    ("1/m2", 1e9),
    ("square metre", 1e9),
    ("dBm", 1e5),
    ("no unit", 1e5),
]


@pytest.mark.parametrize(("text", "size"), SUITED)
def test_a_unit_takes_the_prefix_that_suits(text, size):
    found = prefixed(text, size)
    assert found == SUITED[text, size]
    if "fc" not in text and size < 1e40:
        told = plan(resolve(text), resolve(found)).apply(size)
        assert 1 <= abs(float(f"{told:.12g}")) < 1000


@pytest.mark.parametrize(("text", "size"), LEFT)
def test_a_unit_without_prefixes_or_need_is_left(text, size):
    assert prefixed(text, size) == text


@pytest.mark.parametrize("size", [3e-14, 0.02, 7.0, 12345.6, 8e17])
def test_every_unit_stays_one_of_its_quantity_with_a_power_of_1000(size):
    for text in spellings():
        source, target = resolve(text), resolve(prefixed(text, size))
        assert source.dimension == target.dimension, text
        power = math.log10(source.factor / target.factor)
        assert power == pytest.approx(3 * round(power / 3), abs=1e-9), text
