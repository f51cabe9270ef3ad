"""Streams: what is converted, and that every other byte of what comes in goes out."""

import io
import json
import os
import re
import select
import signal
import subprocess
import time

import pytest
from conftest import entry_point
from helpers import on_terminal, started
from hypothesis import example, given, settings
from hypothesis import strategies as st

from radcalc.conversion.plan import plan
from radcalc.errors import LineError, RadcalcError, UsageError
from radcalc.render.plain import number
from radcalc.streams import blocks
from radcalc.streams.blocks import Bulk
from radcalc.streams.fields import Cut, Fields, read_delimiter
from radcalc.streams.readers import Numbers, Quantities
from radcalc.streams.stream import LONGEST, Stream, run
from radcalc.units.operands import read_operands
from radcalc.units.table import resolve

LX_FC = plan(resolve("lx"), resolve("fc"))


def convert(data: bytes, *words: str) -> subprocess.CompletedProcess[bytes]:
    """Run `radcalc convert - ...` on bytes."""
    return subprocess.run(
        [entry_point(), "convert", "-", *words], input=data, capture_output=True, timeout=60
    )


def stream(data: bytes, made: Stream, invalid: str = "abort") -> tuple[bytes, bool, list[str]]:
    """The same in this process: what is written, whether all is well, and the complaints."""
    out, said = io.BytesIO(), []
    good = run(made, io.BytesIO(data).read, out.write, invalid, lambda e: said.append(e.message))
    return out.getvalue(), good, said


def single(text: str, source: str = "lx", target: str = "fc", precision: int = 12) -> bytes:
    """What a single conversion prints with -n."""
    value, unit, _ = read_operands([text + source, "to", target])
    return number(plan(resolve(unit), resolve(target)).apply(value), precision).encode()


# What goes in, the options, what comes out.
EXACT = {
    "numbers": (b"100\n5e3\n", (), b"9.290304\n464.5152\n"),
    "every way to write a number": (
        b"+1\n.5\n5.\n1/4\n4pi\n\xe2\x88\x921\n-0\n2*3\n1E2\n",
        (),
        b"0.09290304\n0.04645152\n0.4645152\n0.02322576\n1.16745403184\n-0.09290304\n0\n"
        b"0.55741824\n9.290304\n",
    ),
    "no newline at the end": (b"1\n2", (), b"0.09290304\n0.18580608"),
    "a carriage return": (b"1\r\n2\r\n", (), b"0.09290304\r\n0.18580608\r\n"),
    "both ends of lines": (b"1\r\n2\n3", (), b"0.09290304\r\n0.18580608\n0.27870912"),
    "a byte order mark": (b"\xef\xbb\xbf1\n2\n", (), b"\xef\xbb\xbf0.09290304\n0.18580608\n"),
    "blank lines and comments": (
        b"# lux\n\n \t \n1\n  # 2\n\r\n",
        (),
        b"# lux\n\n \t \n0.09290304\n  # 2\n\r\n",
    ),
    "blanks around": (b"  1\t\n", (), b"  0.09290304\t\n"),
    "nothing": (b"", (), b""),
    "a field between blanks": (b" a  1\t x\n", ("--field", "2"), b" a  0.09290304\t x\n"),
    "several fields": (
        b"1,2,3,4\n",
        ("-d", ",", "--field", "1,3-"),
        b"0.09290304,2,0.27870912,0.37161216\n",
    ),
    "fields up to one": (b"1 2 x\n", ("--field", "-2"), b"0.09290304 0.18580608 x\n"),
    "all fields": (b"1 2\n3\n", ("--field", "-"), b"0.09290304 0.18580608\n0.27870912\n"),
    "the first field": (b"1;x\n", ("-d", ";"), b"0.09290304;x\n"),
    "blanks in fields": (b"a b\t1\n", ("-d", "tab", "--field", "2"), b"a b\t0.09290304\n"),
    "a delimiter of two bytes": ("a·1·b\n".encode(), ("-d", "·", "--field", "2"),
                                 "a·0.09290304·b\n".encode()),
    "bytes that are no text": (
        b"\xff\xfe,1,\x00\xc3\n",
        ("-d", ",", "--field", "2"),
        b"\xff\xfe,0.09290304,\x00\xc3\n",
    ),
    "quotes": (
        b'"a,b","1",x\n"say ""5,5""", " 2 " ,y\n',
        ("-d", ",", "--field", "2"),
        b'"a,b","0.09290304",x\n"say ""5,5""", " 0.18580608 " ,y\n',
    ),
    "a quote inside a field": (b'5",1\n', ("-d", ",", "--field", "2"), b'5",0.09290304\n'),
    "blanks in a field": (b"x, 1 ,y\n", ("-d", ",", "--field", "2"), b"x, 0.09290304 ,y\n"),
    "empty fields elsewhere": (b",1,\n,2,\n", ("-d", ",", "--field", "2"),
                               b",0.09290304,\n,0.18580608,\n"),
    "a header": (b"E\n1\n", ("--header",), b"E\n0.09290304\n"),
    "two lines of header": (b"E\nlx\n1\n", ("--header=2",), b"E\nlx\n0.09290304\n"),
    "a header alone": (b"E", ("--header=3",), b"E"),
    "a column": (b"t,E\n0,1\n", ("-d", ",", "--column", "E"), b"t,E\n0,0.09290304\n"),
    "a column of a header in quotes": (
        b'\xef\xbb\xbf"E, ""lx""",t\r\n1,2\r\n',
        ("-d", ",", "--column", 'E, "lx"'),
        b'\xef\xbb\xbf"E, ""lx""",t\r\n0.09290304,2\r\n',
    ),
    "a column of two lines of header": (
        b"# log\nt E\n0 1\n",
        ("--column", "E", "--header=2"),
        b"# log\nt E\n0 0.09290304\n",
    ),
    "a precision": (b"12345\n1\n", ("--precision", "3"), b"1.15e+03\n0.0929\n"),
    "-n": (b"1\n", ("-n",), b"0.09290304\n"),
}  # fmt: skip


@pytest.mark.parametrize(("data", "words", "wanted"), EXACT.values(), ids=EXACT)
def test_the_number_is_replaced_and_nothing_else(data, words, wanted):
    done = convert(data, "lx", "fc", *words)
    assert (done.stdout, done.stderr, done.returncode) == (wanted, b"", 0)


OWN = {
    "whole lines": (b"100 lx\n3fc\r\n 1 klx \n2", (),
                    b"100\tlx\n32.2917312501\tlx\r\n 1000\tlx \n2"),
    "bare numbers out": (b"100 lx\n3 fc\n", ("-n",), b"100\n32.2917312501\n"),
    "units of several words": (b"3 lm m-2\n1/2 foot candle\n", (), b"3\tlx\n5.38195520835\tlx\n"),
    "fields": (b'a,"3 fc"\n"b, c",1lx\n', ("-d", ",", "--field", "2"),
               b'a,"32.2917312501 lx"\n"b, c",1 lx\n'),
    "fields, bare": (b"a,1 klx\nb,2 klx\n", ("-d", ",", "--field", "2", "-n"), b"a,1000\nb,2000\n"),
}  # fmt: skip


@pytest.mark.parametrize(("data", "words", "wanted"), OWN.values(), ids=OWN)
def test_lines_may_carry_their_own_units(data, words, wanted):
    done = convert(data, "lx", "--invalid", "ignore", *words)
    assert (done.stdout, done.stderr, done.returncode) == (wanted, b"", 0)


def test_conditions_work_and_what_they_assume_is_said_once():
    done = convert(b"100\n200\n", "cd", "lx", "--distance", "2m")
    assert done.stdout == b"25\n50\n"
    assert done.stderr.count(b"assumed: a source small beside its distance") == 1
    done = convert(b"100 cd\n1 kcd\n", "lx", "--distance", "2m")
    assert done.stdout == b"25\tlx\n250\tlx\n"
    assert done.stderr.count(b"assumed:") == 1
    assert convert(b"100\n", "cd", "lx", "--distance", "2m", "-q").stderr == b""


def test_json_is_one_object_a_number():
    done = convert(b"# c\n100,x,1\n2,x,3\n", "lx", "fc", "-d", ",", "--field", "1,3", "--json")
    found = [json.loads(line) for line in done.stdout.splitlines()]
    assert [(o["line"], o["field"], o["value"]) for o in found] == [
        (2, 1, 9.290304),
        (2, 3, 0.09290304),
        (3, 1, 0.18580608),
        (3, 3, 0.27870912),
    ]
    alone = json.loads(
        subprocess.run(
            [entry_point(), "convert", "2", "lx", "fc", "--json"], capture_output=True
        ).stdout
    )
    assert {**alone, "line": 3, "field": 1} == found[2]
    done = convert(b"2 W\nx\n\n1 W", "lm", "--efficacy", "93lm/W", "--json", "--invalid", "warn")
    found = [json.loads(line) for line in done.stdout.splitlines()]
    assert [(o["line"], o["value"]) for o in found] == [(1, 186), (4, 93)]
    assert "field" not in found[0]
    assert found[0]["assumptions"] == ["an efficacy of 93lm/W, as given"]
    assert done.stderr == b"radcalc: stdin, line 2: 'x' is not a number\n"


BAD = b"1\nx\n3\n"


@pytest.mark.parametrize(
    ("mode", "out", "status", "complaints"),
    [
        ("abort", b"0.09290304\n", 2, 2),
        ("fail", b"0.09290304\nx\n0.27870912\n", 2, 1),
        ("warn", b"0.09290304\nx\n0.27870912\n", 0, 1),
        ("ignore", b"0.09290304\nx\n0.27870912\n", 0, 0),
    ],
)
def test_a_bad_line_is_met_as_numfmt_meets_it(mode, out, status, complaints):
    done = convert(BAD, "lx", "fc", "--invalid", mode)
    assert (done.stdout, done.returncode) == (out, status)
    said = done.stderr.decode().splitlines()
    assert len(said) == complaints
    assert all("stdin, line 2: 'x' is not a number" in line for line in said[:1])


def test_a_bad_line_stops_the_stream_unless_told_otherwise():
    done = convert(BAD, "lx", "fc")
    assert (done.stdout, done.returncode) == (b"0.09290304\n", 2)
    assert b"Traceback" not in done.stderr


@pytest.mark.parametrize(
    "text",
    ["1,5", "1_000", "nan", "inf", "-inf", "Infinity", "٣", "²", "0x10", "1e400", "1e-320", "1 2",
     "", "--1", "1e", "1/0", "9" * 1001, "1.5.2", "\u00a0", "1\r"],
)  # fmt: skip
def test_what_the_grammar_refuses_a_stream_refuses(text):
    cut = Cut(b";")
    data = f"1;a\n{text};b\n".encode()
    out, good, said = stream(data, Stream(Numbers(LX_FC), cut), "fail")
    assert (out, good) == (f"0.09290304;a\n{text};b\n".encode(), False)
    assert said[0].startswith("stdin, line 2, field 1: ")
    out, good, _ = stream(data.replace(b";b", b" lx;b"), Stream(_own(), cut), "fail")
    assert not good


def test_a_line_passes_unchanged_where_one_of_its_fields_is_bad():
    done = convert(b"1 2 3\n4 x 6\n", "lx", "fc", "--field", "1,2", "--invalid", "fail")
    assert done.stdout == b"0.09290304 0.18580608 3\n4 x 6\n"
    assert done.stderr == b"radcalc: stdin, line 2, field 2: 'x' is not a number\n"


def test_a_field_that_is_not_there_is_no_number():
    done = convert(b"1 2\n1\n", "lx", "fc", "--field", "2")
    assert (done.stdout, done.returncode) == (b"1 0.18580608\n", 2)
    assert done.stderr.startswith(b"radcalc: stdin, line 2: there is no field 2\ntry: ")


def test_a_quote_that_is_not_closed_is_refused():
    for line in (b'"a,1\n', b'"a""b,1\n', b'"a"b,1\n', b'x,"\n'):
        done = convert(line, "lx", "fc", "-d", ",", "--field", "2")
        assert (done.stdout, done.returncode) == (b"", 2)
        assert b"a quoted field does not end on its line" in done.stderr


def test_a_number_with_more_behind_it_is_no_bare_number():
    done = convert(b"100 lx\n", "lx", "fc")
    assert (done.stdout, done.returncode) == (b"", 2)
    assert b"radcalc convert - TARGET" in done.stderr


MISTAKES = [
    ((), "a unit to convert to is missing"),
    (("lx", "to"), "a unit to convert to is missing"),
    (("", "fc"), "a unit to convert to is missing"),
    (("lx", "fc", "nit"), "too many words"),
    (("lx", "in", "fc"), "does not separate units"),
    (("a", "to", "b", "to", "c"), "more than once"),
    (("-", "fc"), "more than one -"),
    (("lx", "W/m2", "--spectrum", "-"), "more than one -"),
    (("lx", "W/m2", "--spectrum", "-:2"), "more than one -"),
    (("lx", "cd"), "a distance is missing"),
    (("lx", "fc", "--distance", "1m"), "has no use"),
    (("cd", "lx", "--distance", "1m,2m"), "a list of conditions"),
    (("lx", "zork"), "unknown unit"),
    (("zork",), "unknown unit"),
    (("lx", "fc", "--steps"), "--steps is not for a stream"),
    (("lx", "fc", "--format", "csv"), "--format csv is not for a stream"),
    (("lx", "fc", "--format", "table"), "--format table is not for a stream"),
    (("lx", "fc", "--field", "0"), "not possible"),
    (("lx", "fc", "--field", "-0"), "not possible"),
    (("lx", "fc", "--field", "3-2"), "decreasing"),
    (("lx", "fc", "--field", "1,,2"), "not a list of fields"),
    (("lx", "fc", "--field", "x"), "not a list of fields"),
    (("lx", "fc", "--field", "9" * 99), "not possible"),
    (("lx", "fc", "-d", "ab"), "not one character"),
    (("lx", "fc", "-d", '"'), "not one character"),
    (("lx", "fc", "-d", "\n"), "not one character"),
    (("lx", "fc", "--field", "1", "--column", "E"), "contradict"),
    (("lx", "fc", "--column", "E"), "has no column 'E'"),
    (("fc", "--field", "1"), "--field needs --delimiter"),
    (("fc", "--column", "E"), "--column needs --delimiter"),
    (("lx", "fc", "--header=0"), "--header"),
    (("lx", "fc", "--header=x"), "--header"),
    (("lx", "fc", "--invalid", "stop"), "--invalid"),
]


@pytest.mark.parametrize(("words", "message"), MISTAKES, ids=[" ".join(w) for w, _ in MISTAKES])
def test_a_wrong_call_gets_one_clear_message(words, message):
    done = convert(b"5 zork\n" if words == ("zork",) else b"a\n1\n", *words)
    said = done.stderr.decode()
    assert (done.stdout, done.returncode) == (b"", 2)
    assert message in said
    assert said.startswith("radcalc: ")
    assert said.splitlines()[1].startswith("try: ")


@pytest.mark.parametrize(
    "words",
    [("--field", "2"), ("--column", "E"), ("-d", ","), ("--header",), ("--invalid", "warn")],
)
def test_options_for_streams_have_no_use_without_one(words):
    done = subprocess.run([entry_point(), "convert", "1", "lx", "fc", *words], capture_output=True)
    assert (done.stdout, done.returncode) == (b"", 2)
    assert b"is for lines of standard input" in done.stderr


def test_a_column_must_be_there_once():
    for header, message in ((b"a,a\n", "2 times"), (b"b,c\n", "has no column"), (b"", "no header")):
        done = convert(header + b"1,2\n" * bool(header), "lx", "fc", "-d", ",", "--column", "a")
        assert (done.stdout, done.returncode) == (b"", 2)
        assert message in done.stderr.decode()


def test_the_header_option_never_takes_the_next_word():
    done = subprocess.run(
        [entry_point(), "convert", "--header", "-", "lx", "fc"], input=b"E\n1\n",
        capture_output=True,
    )  # fmt: skip
    assert done.stdout == b"E\n0.09290304\n"


def test_a_huge_line_passes_and_an_endless_one_is_refused():
    rest = b"x" * 1_000_000
    out, good, _ = stream(b"1;" + rest + b"\n2;y\n", Stream(Numbers(LX_FC), Cut(b";")))
    assert (out, good) == (b"0.09290304;" + rest + b"\n0.18580608;y\n", True)
    with pytest.raises(LineError, match="more than"):
        run(Stream(Numbers(LX_FC)), lambda size: b"1" * size, lambda data: None)
    with pytest.raises(LineError, match="line 1: a text of"):
        stream(b"1" * (LONGEST // 8), Stream(Numbers(LX_FC)))


def _own(unit: bytes = b"\tfc", precision: int | None = None) -> Quantities:
    return Quantities(lambda text: plan(resolve(text), resolve("fc")), unit, precision)


# Random lines: the fields are numbers, or bytes that a field may be made of.
NUMBERS = st.one_of(
    st.decimals(-99999, 99999, places=2).map(str),
    st.integers(-(10**20), 10**20).map(str),
    st.floats(1e-120, 1e120).map(repr),
    st.floats(-1e6, 1e6).map(repr),
    st.sampled_from(["0", "-0", "+5", ".5", "5.", "1/3", "4pi", "1e5", "-2.50E-3", "0.000", "00"]),
    st.sampled_from(["1,5", "1_000", "nan", "inf", "x", "", "1e400", "5 5", "1e-320"]),
)
OTHERS = st.binary(max_size=6).map(lambda b: re.sub(rb'[\n\r"#]', b"", b))
DELIMITERS = [b",", b";", b"\t", b" ", b"", "·".encode()]


@st.composite
def tables(draw):
    """Lines with a column of numbers, as bytes; the delimiter, the column and the cells."""
    mark = draw(st.sampled_from(DELIMITERS))
    width = draw(st.integers(1, 4))
    column = draw(st.integers(0, width - 1))
    rows, ends = [], st.sampled_from([b"\n"] * 4 + [b"\r\n"])
    same_end = draw(st.booleans()) and draw(ends)
    for _ in range(draw(st.integers(0, 12))):
        cells = [re.sub(re.escape(mark or b" ") + rb"|[ \t]", b"", c) for c in draw(
            st.lists(OTHERS, min_size=width, max_size=width))]  # fmt: skip
        if not mark:
            cells = [cell or b"-" for cell in cells]
        cells[column] = draw(NUMBERS).encode()
        if (mark and mark in cells[column]) or (not mark and cells[column] in (b"", b"5 5")):
            cells[column] = b"7"
        rows.append((cells, same_end or draw(ends)))
    return mark, column, rows, draw(st.booleans())


@settings(max_examples=400)
@given(tables(), st.sampled_from([("lx", "fc"), ("fc", "lx"), ("fL", "nit"), ("W", "mW")]),
       st.integers(1, 17))  # fmt: skip
@example((b",", 1, [([b"\xff", b"1"], b"\n")] * 3, True), ("lx", "fc"), 12)
def test_a_stream_is_its_lines_converted_by_themselves(table, units, precision):
    mark, column, rows, ended = table
    made = plan(*map(resolve, units))
    data, wanted, bad = b"", b"", 0
    for place, (cells, end) in enumerate(rows):
        if place == len(rows) - 1 and not ended:
            end = b""
        joint = mark or b" "
        line = joint.join(cells)
        shown = list(cells)
        blank = not line.strip(b" \t")
        if not blank:
            try:
                shown[column] = single(cells[column].decode() + " ", *units, precision)
            except RadcalcError:
                bad += 1
        data += line + end
        wanted += joint.join(shown) + end
    fields = Fields(str(column + 1))
    out, good, said = stream(data, Stream(Numbers(made, precision), Cut(mark), fields), "fail")
    assert out == wanted
    assert (len(said), good) == (bad, not bad)


CELLS = st.sampled_from(
    [b"1", b" 2.5 ", b'"3"', b'" 4 "', b'"a;b"', b'"a""b"', b"", b'""', b'x"', b'"', b'"5', b"# c",
     b'"6"x', b"#", b"7 lx", b'"8 klx"', b"9lx", b"\t10", b"1/2", b"\xff", b"-1e3"]
)  # fmt: skip


@settings(max_examples=1000)
@given(st.lists(st.lists(CELLS, min_size=1, max_size=4), min_size=1, max_size=5),
       st.sampled_from([b";", b"", b"\t", b" ", "·".encode()]),
       st.sampled_from(["1", "2", "3", "1,2", "2-", "-"]), st.booleans())  # fmt: skip
def test_many_lines_at_once_are_the_same_as_one_by_one(rows, mark, fields, own):
    texts = _own() if own else Numbers(LX_FC)
    lines = [(mark or b"  ").join(row) + b"\n" for row in rows]
    made = Stream(texts, Cut(mark), Fields(fields))
    together = stream(b"".join(lines) * 2, made, "warn")
    singly = [stream(line, made, "warn") for line in lines * 2]
    assert together[0] == b"".join([out for out, _, _ in singly])
    assert len(together[2]) == sum([len(said) for _, _, said in singly])
    shown = made.block(b"".join(lines))  # where it answers at all, the lines are all good
    assert shown in (None, b"".join([made.line(line, 1) for line in lines] if shown else [b""]))


@settings(max_examples=300)
@given(st.lists(st.tuples(NUMBERS, st.sampled_from(["lx", " klx", " fc", "  ph", " lm m-2", " zork",
                                                    "", " cd", " mlx "])), max_size=12),
       st.sampled_from(["\n", "\r\n"]))  # fmt: skip
def test_lines_with_their_own_units_are_converted_by_themselves(pairs, end):
    wanted = b""
    for value, unit in pairs:
        text = value + unit
        try:
            answer = single(value, unit) + b"\tfc" + b" " * unit.endswith(" ")
        except RadcalcError:
            answer = text.encode()
        wanted += answer + end.encode()
    data = "".join(value + unit + end for value, unit in pairs).encode()
    assert stream(data, Stream(_own()), "ignore")[0] == wanted


SOURCES = [("lx", "fc"), ("fc", "lx"), ("lx", "klx"), ("klx", "lx"), ("fL", "nit"), ("nit", "fL"),
           ("deg", "rad"), ("in", "nm"), ("erg", "J"), ("lx", "lx"), ("Btu", "J")]  # fmt: skip


@settings(max_examples=500)
@given(st.sampled_from(SOURCES),
       st.lists(st.one_of(st.floats(1e-99, 1e99), st.floats(-1e6, 1e6),
                          st.integers(-(2**60), 2**60).map(float)), min_size=1))  # fmt: skip
def test_the_product_in_two_parts_is_the_exact_one(units, values):
    made = plan(*map(resolve, units))
    texts = [repr(value).encode() for value in values if value == 0 or abs(value) > 1e-99]
    assert Bulk(made, 12).exact(texts) == [made.apply(float(text)) for text in texts]


@settings(max_examples=500)
@given(st.sampled_from([("lx", "fc"), ("lx", "klx"), ("in", "cm"), ("ft", "m"), ("W", "mW")]),
       st.integers(1, 14), st.data())  # fmt: skip
def test_a_plain_product_prints_right_where_it_is_used(units, precision, data):
    made = plan(*map(resolve, units))
    ready = Bulk(made, precision)
    digits = data.draw(st.integers(0, 10**ready.digits - 1))
    text = f"{digits / 10 ** data.draw(st.integers(0, 8)):.8f}".rstrip("0")
    if len(text.replace(".", "")) > ready.digits:
        text = str(digits)
    assert ready.lines(text.encode() + b"\n") == b"%.*g\n" % (precision, made.apply(float(text)))


def test_halves_of_the_last_digit_are_rounded_as_a_single_conversion_does():
    # products of 13 digits that end in 5: the float nearest to each decides, not the decimal
    made = plan(resolve("in"), resolve("cm"))
    texts = [f"{i}.{j:03d}5".encode() for i in range(999_999_000, 999_999_010) for j in range(50)]
    texts += [f"{i}{j}5".encode() for i in range(12_345_678_900, 12_345_678_910) for j in range(9)]
    for precision in range(1, 15):
        ready = Bulk(made, precision)
        wanted = b"".join([b"%.*g\n" % (precision, made.apply(float(t))) for t in texts])
        assert ready.lines(b"\n".join(texts) + b"\n") == wanted


def test_a_decimal_ratio_has_room_for_so_many_digits():
    assert Bulk(LX_FC, 12).digits == 8  # 9290304 = 2^6 * 145161 has 7 digits, 15 - 7
    assert Bulk(plan(resolve("fc"), resolve("lx")), 12).digits == 0
    assert Bulk(plan(resolve("W"), resolve("mW")), 12).digits == 11
    assert Bulk(LX_FC, 15).digits == 0
    assert blocks.plain_digits(1, 1, 12) == 11


def test_a_block_is_not_taken_where_a_line_is_unusual():
    ready = Bulk(LX_FC, 12)
    for text in (b" 1", b"1 ", b"", b"1/3", b"pi", b"1_0", b"nan", b"1e400", b"1e-200", b"0e0",
                 b"x", b"1,5", b"1\r", b"\xd9\xa3", b"1" * 100, b"+", b".", b"1-2"):  # fmt: skip
        assert ready.lines(b"1\n" + text + b"\n2\n") is None, text
    assert ready.lines(b"1\n1.5e3\n-2\n") == b"0.09290304\n139.35456\n-0.18580608\n"


def test_fields_and_delimiters_are_read_as_written():
    assert Fields("2,1").of(3) == [0, 1]
    assert Fields("1-2,2-").of(4) == [0, 1, 2, 3]
    assert Fields("\u22122").of(3) == [0, 1]  # a minus that was no option
    assert [read_delimiter(d) for d in ("tab", "\\t", "comma", ",", "·")] == [
        b"\t", b"\t", b",", b",", "·".encode(),
    ]  # fmt: skip
    with pytest.raises(UsageError):
        Fields("")


def test_what_came_before_a_bad_line_is_out_before_the_complaint():
    events: list[object] = []
    run(Stream(Numbers(LX_FC)), io.BytesIO(b"1\nx\n2\n").read, events.append, "warn",
        lambda error: events.append(error.message))  # fmt: skip
    assert events == [b"0.09290304\n", "stdin, line 2: 'x' is not a number", b"x\n0.18580608\n"]


def test_a_closed_pipe_ends_at_once_and_quietly():
    script = f"yes 1 | {{ {entry_point()} convert - lx fc; echo $? >&2; }} | head -n 1"
    done = subprocess.run(["sh", "-c", script], capture_output=True, text=True, timeout=60)
    assert (done.stdout, done.stderr) == ("0.09290304\n", "0\n")


def test_a_full_disk_is_an_error():
    with open("/dev/full", "wb") as full:
        done = subprocess.run(
            [entry_point(), "convert", "-", "lx", "fc"],
            input=b"1\n" * 100_000, stdout=full, stderr=subprocess.PIPE, timeout=60,
        )  # fmt: skip
    assert done.returncode == 2
    assert done.stderr.startswith(b"radcalc: cannot write the answer: No space left on device\n")
    assert len(done.stderr.splitlines()) == 2


def test_no_standard_input_or_output_is_an_error():
    for closed, message in (("<&-", "cannot read stdin"), (">&-", "standard output is closed")):
        done = subprocess.run(
            ["sh", "-c", f"echo 1 | sh -c 'exec {entry_point()} convert - lx fc {closed}'"],
            capture_output=True, text=True, timeout=60,
        )  # fmt: skip
        assert done.returncode == 2
        assert message in done.stderr
        assert "Traceback" not in done.stderr


def test_standard_input_is_left_alone_without_a_dash():
    reader, writer = os.pipe()
    os.write(writer, b"1\n")
    os.close(writer)
    done = subprocess.run(
        [entry_point(), "convert", "100", "lx", "fc"], stdin=reader, capture_output=True, timeout=60
    )
    left = os.read(reader, 2)
    os.close(reader)
    assert done.stdout == b"9.290304\tfc\n"
    assert left == b"1\n"


def _read(descriptor: int, until: bytes) -> bytes:
    """Read until a text has come."""
    found = b""
    while until not in found:
        ready, _, _ = select.select([descriptor], [], [], 60)
        assert ready, found
        found += os.read(descriptor, 65536)
    return found


@pytest.mark.parametrize("words", [(), ("--field", "1"), ("--json",)])
def test_a_terminal_sees_each_line_as_it_comes(words):
    command = (entry_point(), "convert", "-", "lx", "fc", *words)
    with on_terminal(*command, stdin=subprocess.PIPE) as (process, leader):
        assert process.stdin is not None
        for text, answer in ((b"1", b"0.09290304"), (b"2", b"0.18580608"), (b"3", b"0.27870912")):
            process.stdin.write(text + b"\n")
            process.stdin.flush()
            assert answer in _read(leader, b"\r\n")
        process.stdin.close()
        assert process.wait(60) == 0


def test_an_interrupt_exits_130_without_a_traceback():
    with started(
        entry_point(), "convert", "-", "lx", "fc",
        stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
    ) as process:  # fmt: skip
        assert process.stdin is not None
        assert process.stdout is not None
        process.stdin.write(b"1\n")
        process.stdin.flush()
        assert process.stdout.readline() == b"0.09290304\n"
        time.sleep(0.1)  # back to reading
        process.send_signal(signal.SIGINT)
        _, err = process.communicate(timeout=30)
    assert (process.returncode, err.strip()) == (130, b"")
