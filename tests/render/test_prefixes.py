"""SI prefixes that put a number between 1 and 1000 (SI brochure, table 7)."""

import csv
import json
import math

import pytest
from conftest import run
from helpers import for_each

from radcalc.answer import Result, Row
from radcalc.conversion.plan import plan
from radcalc.render.prefixes import with_prefixes
from radcalc.terminal import PLAIN
from radcalc.units.table import resolve, spellings


def prefixed(text, size):
    """Return the unit in which a number in another unit is shown."""
    (result,) = with_prefixes([Result((Row("", "", size, text),))], PLAIN, None)
    return result.rows[0].unit


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
    ("fc", 1e-5): "mfc",  # fc has only kilo and milli
    ("lm", 999.9999999999999): "klm",  # it is shown as 1000
    ("lm", 1e40): "Qlm",
    ("lm", 1e300): "Qlm",  # a number can hold 1e270 of them
    ("lm", 1e-300): "qlm",
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


@for_each(SUITED)
def test_a_unit_takes_the_prefix_that_suits(text, size):
    found = prefixed(text, size)
    assert found == SUITED[text, size]
    if "fc" not in text and 1e-40 < size < 1e40:
        told = plan(resolve(text), resolve(found)).apply(size)
        assert 1 <= abs(float(f"{told:.12g}")) < 1000


@pytest.mark.parametrize(("text", "size"), LEFT)
def test_a_unit_without_prefixes_or_need_stays(text, size):
    assert prefixed(text, size) == text


@pytest.mark.parametrize("size", [3e-14, 0.02, 7.0, 12345.6, 8e17])
def test_every_unit_stays_one_of_its_quantity_with_a_power_of_1000(size):
    for text in spellings():
        source, target = resolve(text), resolve(prefixed(text, size))
        assert source.dimension == target.dimension, text
        power = math.log10(source.factor / target.factor)
        assert power == pytest.approx(3 * round(power / 3), abs=1e-9), text


MIXED = [1e-7, 0.001, 0.02, 5.0, 999.9999, 5000.0, 3.3e8]  # lx


@pytest.mark.parametrize("precision", [None, 3, 6])
def test_each_answer_has_its_own_prefix(precision):
    words = ",".join(f"{size!r}lx" for size in MIXED), "lx", "--auto"
    digits = ("--precision", str(precision)) if precision else ()
    told = json.loads(run(*words, "--json", *digits).stdout)
    rows = [row for one in told for row in one["results"].values()]
    lines = [line.split("\t") for line in run(*words, *digits).stdout.splitlines()]
    assert [row["unit"] for row in rows] == [unit for _, unit in lines]
    for size, (number, unit) in zip(MIXED, lines, strict=True):
        assert 1 <= float(number) < 1000
        assert "e" not in number
        back = plan(resolve(unit), resolve("lx")).apply(float(number))
        assert back == pytest.approx(size, rel=10.0 ** (1 - (precision or 12)))


def test_the_prefix_is_chosen_after_rounding():
    # 999.9999 lx has 1.00e3 in three digits, and 999.9 +- 10 lx are 1.000(10) klx
    assert run("999.9999", "lx", "lx", "--auto", "--precision", "3").stdout == "1\tklx\n"
    assert run("999.9+-10", "lx", "lx", "--auto", "-q").stdout == "1.000 ± 0.010\tklx\n"
    assert run("999.4", "lx", "lx", "--auto", "--precision", "3").stdout == "999\tlx\n"
    assert run("150", "lx", "lx", "--auto", "--precision", "2").stdout == "0.15\tklx\n"


def test_uncertain_answers_have_no_exponent():
    told = run("0.00100+-0.00010lx,5000+-10lx", "lx", "--auto", "-q").stdout
    assert told == "1.00 ± 0.10\tmlx\n5.000 ± 0.010\tklx\n"


def test_a_column_has_the_prefix_of_its_smallest():
    told = run(*["0lx,0.001lx,5000lx", "lx", "--auto", "--format", "csv"]).stdout
    head, *lines = csv.reader(told.splitlines())
    assert head == ["value:lx", "illuminance:mlx"]
    assert [float(number) for _, number in lines] == [0, 1, 5e6]


# 800 lm / (4 pi) / d^2 are 63.7 lx at 1 m, and at 200 m 1.59 mlx: in mlx 63662 and 1.59155
# have no exponent; at 0.1 m there are 6366.2 lx, which would be 6.3662e+06 mlx.
@pytest.mark.parametrize(("distances", "unit"), [("1m,200m", "mlx"), ("0.1m,200m", "lx")])
def test_no_prefix_brings_an_exponent_into_a_table(distances, unit):
    words = f"point-source --flux 800lm --distance {distances} --auto -q --format table"
    told = run(*words.split()).stdout
    assert f"E_v [{unit}]" in told
    assert "e+" not in told
    assert "e-" not in told
