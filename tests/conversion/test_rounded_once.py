"""Conversions by exact ratios are the float nearest to the exact product of the typed decimal."""

import json
import math
import random
from fractions import Fraction

from conftest import run

import radcalc
from radcalc.conversion.plan import plan
from radcalc.units.compiled import UNITS
from radcalc.units.reading import read_amount
from radcalc.units.table import resolve

COUNT = 10_000
# definitions: 1 ft = 0.3048 m, 1 lb = 0.45359237 kg, 1 yd = 0.9144 m, 1 nmi = 1852 m
DEFINED = {
    ("lx", "fc"): "0.09290304", ("mlx", "lx"): "0.001", ("fc", "lx"): "1/0.09290304",
    ("ft", "m"): "0.3048", ("in", "cm"): "2.54", ("m", "yd"): "1/0.9144", ("kcd", "mcd"): "1e6",
    ("h", "s"): "3600", ("nmi", "km"): "1.852", ("umol", "mol"): "1e-6",
    ("eV", "J"): "1.602176634e-19",
    ("angstrom", "nm"): "0.1", ("W", "mW"): "1000", ("lm/cm2", "lm/mm2"): "0.01",
}  # fmt: skip


def ratio(text):
    over, _, under = text.partition("/")
    return Fraction(over) / Fraction(under or 1)


def decimals(dice):
    """Return a decimal of up to 17 digits, sometimes with an exponent."""
    digits = str(dice.randrange(1, 10 ** dice.randint(1, 17)))
    at = dice.randint(0, len(digits))
    text = f"{digits[:at] or '0'}.{digits[at:]}" if at < len(digits) else digits
    return text + dice.choice(["", "", "", f"e{dice.randint(-30, 30)}"])


def pairs_of_units(dice):
    """Return pairs of units of one dimension, with the ratio that the table of units has."""
    by_dimension = {}
    for name in UNITS:
        unit = resolve(name)
        by_dimension.setdefault((unit.dimension, unit.is_exitance), []).append(unit)
    groups = [group for group in by_dimension.values() if len(group) > 1]
    while True:
        source, target = dice.sample(dice.choice(groups), 2)
        yield source, target, Fraction(source.top * target.bottom, source.bottom * target.top)


def test_random_decimals_and_units_are_rounded_once():
    dice = random.Random(27)
    of_table = pairs_of_units(dice)
    for number in range(COUNT):
        text = decimals(dice)
        if number % 2:
            (start, end), exact_text = dice.choice(list(DEFINED.items()))
            source, target, exact = resolve(start), resolve(end), ratio(exact_text)
        else:
            source, target, exact = next(of_table)
        expected = Fraction(text) * exact
        amount = read_amount(f"{text} {source.text}")
        made = plan(amount.unit, target)
        found = made.apply(amount.exact)
        assert found == float(expected), (text, source.text, target.text)
        if number % 100 == 0:
            done = run("convert", text, source.text, target.text, "--precision", "17", "-n")
            assert float(done.stdout) == found


def test_every_path_rounds_once():
    """The command, its quick form in a pipe, JSON and Python; a stream is one bit off at most."""
    dice = random.Random(28)
    texts = [decimals(dice) for _ in range(40)] + ["0.035", "1/3", "0.1*0.3", "-0.035", ".07", "7."]
    for (start, end), exact in list(DEFINED.items())[:4]:
        expected = []
        for text in texts:
            factors = [Fraction(part) for part in text.replace("/3", "").split("*")]
            over = factors[0] * (factors[1] if factors[1:] else 1)
            expected.append(float((over / 3 if "/3" in text else over) * ratio(exact)))
        for text, number in zip(texts[-6:], expected[-6:], strict=True):
            done = run("convert", f"{text} {start}", end, "--json")
            (result,) = json.loads(done.stdout)["results"].values()
            assert result["value"] == number
            quick = run("convert", text, start, end, "--precision", "17", "-n").stdout
            assert float(quick) == number
            assert radcalc.convert(f"{text} {start}", end).magnitude == number
        for words, unit in (((start, end), ""), ((end,), f" {start}")):
            typed = "".join(f"{text}{unit}\n" for text in texts)
            done = run("convert", "-", *words, "--precision", "17", input=typed)
            for line, number in zip(done.stdout.splitlines(), expected, strict=True):
                assert math.isclose(float(line.split()[0]), number, rel_tol=2.0**-51)


def test_an_expression_is_rounded_once():
    dice = random.Random(29)
    for _ in range(500):
        a, b, c = (f"{dice.uniform(0.01, 99):.{dice.randint(1, 9)}f}" for _ in range(3))
        start, end = dice.choice([("lx", "fc"), ("fc", "lx"), ("mlx", "lx")])
        amount = read_amount(f"({a} + {b}) * {c} {start}")
        found = plan(amount.unit, resolve(end)).apply(amount.exact)
        exact = (Fraction(a) + Fraction(b)) * Fraction(c) * ratio(DEFINED[start, end])
        assert found == float(exact)


def test_a_text_that_begins_with_no_decimal_is_converted():
    for text, target, value in (
        ("(100+-3) lx * (2.0+-0.1) m2", "lm", 200.0), ("(10±1)%", "1", 0.1),
        ("sin(30deg)", "%", 50.0),
        ("4pi sr", "sr", 4 * math.pi), ("sqrt(4) lx", "mlx", 2000.0), ("100(3)e2 lx", "klx", 10.0),
        ("(1/3) lx", "lx", 1 / 3), ("-(2) lx", "mlx", -2000.0), ("10 dBm", "mW", 10.0),
    ):  # fmt: skip
        found = radcalc.convert(text, target)
        found = getattr(found, "magnitude", found)
        assert getattr(found, "nominal_value", found) == value
        done = run("convert", text, "to", target, "--json")
        (result,) = json.loads(done.stdout)["results"].values()
        assert result["value"] == value
