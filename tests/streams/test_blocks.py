"""Blocks of lines give the same output as single lines."""

from hypothesis import given, settings
from hypothesis import strategies as st

from radcalc.conversion.plan import plan
from radcalc.streams import readers as blocks
from radcalc.streams.readers import Bulk
from radcalc.units.table import resolve
from radcalc.units.values import resolve_any

LX_FC = plan(resolve("lx"), resolve("fc"))

SOURCES = [("lx", "fc"), ("fc", "lx"), ("lx", "klx"), ("klx", "lx"), ("fL", "nit"), ("nit", "fL"),
           ("deg", "rad"), ("in", "nm"), ("erg", "J"), ("lx", "lx"), ("Btu", "J")]  # fmt: skip


@settings(max_examples=200)
@given(st.sampled_from(SOURCES),
       st.lists(st.one_of(st.floats(1e-99, 1e99), st.floats(-1e6, 1e6),
                          st.integers(-(2**60), 2**60).map(float)), min_size=1))  # fmt: skip
def test_the_product_in_two_parts_is_exact(units, values):
    made = plan(*map(resolve, units))
    texts = [repr(value).encode() for value in values if value == 0 or abs(value) > 1e-99]
    assert Bulk(made, 12).exact([*map(float, texts)]) == [made.apply(float(text)) for text in texts]


@settings(max_examples=200)
@given(st.sampled_from([("lx", "fc"), ("lx", "klx"), ("in", "cm"), ("ft", "m"), ("W", "mW")]),
       st.integers(1, 14), st.data())  # fmt: skip
def test_a_plain_product_prints_the_exact_digits_if_used(units, precision, data):
    made = plan(*map(resolve, units))
    ready = Bulk(made, precision)
    digits = data.draw(st.integers(0, 10**ready.digits - 1))
    text = f"{digits / 10 ** data.draw(st.integers(0, 8)):.8f}".rstrip("0")
    if len(text.replace(".", "")) > ready.digits:
        text = str(digits)
    assert ready.lines(text.encode() + b"\n") == b"%.*g\n" % (precision, made.apply(float(text)))


def test_halves_of_the_last_digit_are_rounded_as_in_a_single_conversion():
    # products of 13 digits that end in 5: the float nearest to each decides, not the decimal
    made = plan(resolve("in"), resolve("cm"))
    texts = [f"{i}.{j:03d}5".encode() for i in range(999_999_000, 999_999_010) for j in range(50)]
    texts += [f"{i}{j}5".encode() for i in range(12_345_678_900, 12_345_678_910) for j in range(9)]
    for precision in range(1, 15):
        ready = Bulk(made, precision)
        wanted = b"".join([b"%.*g\n" % (precision, made.apply(float(t))) for t in texts])
        assert ready.lines(b"\n".join(texts) + b"\n") == wanted


def test_the_ratio_limits_the_digits_of_an_exact_product():
    assert Bulk(LX_FC, 12).digits == 8  # 9290304 = 2^6 * 145161 has 7 digits, 15 - 7
    assert Bulk(plan(resolve("fc"), resolve("lx")), 12).digits == 0
    assert Bulk(plan(resolve("W"), resolve("mW")), 12).digits == 11
    assert Bulk(LX_FC, 15).digits == 0
    assert blocks.plain_digits(1, 1, 12) == 11


def test_a_block_with_an_unusual_line_is_left_to_single_lines():
    ready = Bulk(LX_FC, 12)
    for text in (b" 1", b"1 ", b"", b"1/3", b"pi", b"1_0", b"nan", b"1e400", b"1e-200", b"0e0",
                 b"x", b"1,5", b"1\r", b"\xd9\xa3", b"1" * 100, b"+", b".", b"1-2"):  # fmt: skip
        assert ready.lines(b"1\n" + text + b"\n2\n") is None, text
    assert ready.lines(b"1\n1.5e3\n-2\n") == b"0.09290304\n139.35456\n-0.18580608\n"


@given(st.sampled_from([("dBm", "mW"), ("mag", "lx"), ("EV", "cd/m2"), ("mired", "K")]),
       st.lists(st.integers(1, 10**6).map(lambda n: n / 1000), min_size=1))  # fmt: skip
def test_readings_on_a_scale_are_converted_as_single_ones(units, values):
    made = plan(*map(resolve_any, units))
    texts = [b"%r" % value for value in values if value < 200]
    wanted = b"".join([b"%.12g\n" % made.apply(float(text)) for text in texts])
    assert Bulk(made, 12).lines(b"".join([text + b"\n" for text in texts])) == wanted
    assert Bulk(made, 12).lines(b"1e5\n") is None or units[0] == "mired"  # refused alone
