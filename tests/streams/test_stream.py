"""Streams in this process: lines are converted one by one, and other bytes are unchanged."""

import io
import re
import tracemalloc

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from radcalc.conversion.operands import read_operands
from radcalc.conversion.plan import plan
from radcalc.errors import LineError, RadcalcError
from radcalc.render.plain import number
from radcalc.streams.fields import Cut, Fields
from radcalc.streams.header import Header
from radcalc.streams.readers import Numbers, Quantities
from radcalc.streams.stream import LONGEST, Stream, run
from radcalc.units.table import resolve

LX_FC = plan(resolve("lx"), resolve("fc"))


def stream(data: bytes, made: Stream, invalid: str = "abort") -> tuple[bytes, bool, list[str]]:
    """Run a stream; return the output, whether all lines were good, and the error messages."""
    out, said = io.BytesIO(), []
    good = run(made, io.BytesIO(data).read, out.write, invalid, lambda e: said.append(e.message))
    return out.getvalue(), good, said


def single(text: str, source: str = "lx", target: str = "fc", precision: int = 12) -> bytes:
    """Return the output of a single conversion with -n."""
    amount, _ = read_operands([text + source, "to", target])
    return number(plan(amount.unit, resolve(target)).apply(amount.number), precision).encode()


@pytest.mark.parametrize(
    "text",
    ["1,5", "1_000", "nan", "inf", "-inf", "Infinity", "٣", "²", "0x10", "1e400", "1e-320", "1 2",
     "", "--1", "1e", "1/0", "9" * 1001, "1.5.2", "\u00a0", "1\r"],
)  # fmt: skip
def test_a_stream_refuses_the_numbers_that_the_grammar_refuses(text):
    cut = Cut(b";")
    data = f"1;a\n{text};b\n".encode()
    out, good, said = stream(data, Stream(Numbers(LX_FC), cut), "fail")
    assert (out, good) == (f"0.09290304;a\n{text};b\n".encode(), False)
    assert said[0].startswith("stdin, line 2, field 1: ")
    out, good, _ = stream(data.replace(b";b", b" lx;b"), Stream(_own(), cut), "fail")
    assert not good


def test_a_huge_line_passes_and_an_endless_one_is_refused():
    rest = b"x" * 1_000_000
    out, good, _ = stream(b"1;" + rest + b"\n2;y\n", Stream(Numbers(LX_FC), Cut(b";")))
    assert (out, good) == (b"0.09290304;" + rest + b"\n0.18580608;y\n", True)
    out = io.BytesIO()
    endless = iter([b"1\n2\n", b"3\n1"])
    with pytest.raises(LineError, match="stdin, line 4: more than 16777216 bytes"):
        run(Stream(Numbers(LX_FC)), lambda size: next(endless, b"1" * size), out.write)
    assert out.getvalue().count(b"\n") == 3
    with pytest.raises(LineError, match="line 1: a text of"):
        stream(b"1" * (LONGEST // 8), Stream(Numbers(LX_FC)))


@pytest.mark.parametrize("field", [b"1", b"1.5", b'"2"', b"1/3", b" 4 "])
def test_a_line_of_many_fields_takes_a_small_multiple_of_its_size(field):
    count = 30_000 // (len(field) + 1)
    line = b",".join([field] * count) + b"\n"
    made = Stream(Numbers(LX_FC), Cut(b","), Fields("1-"))
    tracemalloc.start()
    out, _, _ = stream(line, made)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    one, _, _ = stream(field + b"\n", made)
    assert out == b",".join([one[:-1]] * count) + b"\n"
    assert peak < 5 * (len(line) + len(out)) + 200_000


def _own(unit: bytes = b"\tfc", precision: int | None = None, mark: bytes = b".") -> Quantities:
    fc = resolve("fc")
    return Quantities(
        lambda source: plan(source, fc), lambda amount: amount.unit, unit, precision, mark
    )


# Random lines: the fields are numbers, or bytes that a field may be made of.
NUMBERS = st.one_of(
    st.decimals(-99999, 99999, places=2).map(str),
    st.integers(-(10**20), 10**20).map(str),
    st.floats(1e-120, 1e120).map(repr),
    st.floats(-1e6, 1e6).map(repr),
    st.sampled_from(["0", "-0", "+5", ".5", "5.", "1/3", "4pi", "1e5", "-2.50E-3", "0.000", "00"]),
    st.sampled_from(["1,5", "1_000", "nan", "inf", "x", "", "1e400", "5 5", "1e-320"]),
)
# Cells are not byte order marks, which have a meaning at the start of a stream.
OTHERS = st.binary(max_size=6).map(lambda b: re.sub(rb'[\n\r"#]|\xef\xbb\xbf', b"", b))
DELIMITERS = [b",", b";", b"\t", b" ", b"", "·".encode()]


@st.composite
def tables(draw):
    """Draw a delimiter, the column of numbers, rows of cells, and whether the last line ends."""
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


@settings(max_examples=150)
@given(tables(), st.sampled_from([("lx", "fc"), ("fc", "lx"), ("fL", "nit"), ("W", "mW")]),
       st.integers(1, 17))  # fmt: skip
@example((b",", 1, [([b"\xff", b"1"], b"\n")] * 3, True), ("lx", "fc"), 12)
def test_the_lines_of_a_stream_are_converted_one_by_one(table, units, precision):
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
     b'"6"x', b"#", b"7 lx", b'"8 klx"', b"9lx", b"\t10", b"1/2", b"\xff", b"-1e3", b"1,5",
     b'"0,25"', b"1.000,5", b"2,5 klx"]
)  # fmt: skip


@settings(max_examples=200)
@given(st.lists(st.lists(CELLS, min_size=1, max_size=4), min_size=1, max_size=5),
       st.sampled_from([b";", b"", b"\t", b" ", "·".encode(), b","]),
       st.sampled_from(["1", "2", "3", "1,2", "2-", "-"]), st.booleans(),
       st.sampled_from([b".", b","]), st.booleans(), st.integers(0, 4))  # fmt: skip
@example([[b"1"], [b"", b"# c", b"1"]], b"\t", "3", False, b".", False, 0)  # a comment, cut off
@example([[b"1", b"2"]], b"", "1", False, b".", True, 2)
@example([[b"1", b"2"]], b"", "1", False, b".", True, 3)
def test_many_lines_at_once_give_the_same_as_one_by_one(
    rows, mark, fields, own, decimal, adds, width
):
    texts = _own(mark=decimal) if own else Numbers(LX_FC, mark=decimal)
    adds = adds and Fields(fields).is_one
    lines = [(mark or b"  ").join(row) + b"\n" for row in rows]
    made = _Held(texts, Cut(mark), Fields(fields), adds=adds)
    made.held = width
    together = stream(b"".join(lines) * 2, made, "warn")
    singly = [stream(line, made, "warn") for line in lines * 2]
    assert together[0] == b"".join([out for out, _, _ in singly])
    assert len(together[2]) == sum([len(said) for _, _, said in singly])
    shown = made.block(b"".join(lines))  # a block is answered only if all lines are good
    assert shown in (None, b"".join([made.line(line, 1) for line in lines] if shown else [b""]))


class _Held(Stream):
    """Stream with a fixed number of fields, as a header would set it."""

    held = 0
    is_counted = False
    width = property(lambda self: self.held, lambda self, value: None)

    def __init__(self, *given, **named):
        super().__init__(*given, **named)
        self.is_counted = False


@settings(max_examples=100)
@given(st.lists(st.tuples(NUMBERS, st.sampled_from(["lx", " klx", " fc", "  ph", " lm m-2", " zork",
                                                    "", " cd", " mlx "])), max_size=12),
       st.sampled_from(["\n", "\r\n"]))  # fmt: skip
def test_lines_with_their_own_units_are_converted_one_by_one(pairs, end):
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


@pytest.mark.parametrize("mended", ["", "lines"])
def test_output_before_a_bug_is_written(monkeypatch, mended):
    class Broken(Numbers):
        def read(self, text):
            return super().read(text)[0], 1 / (float(text) - 3)

    amount, target = read_operands(["1", "lx", "fc"])
    made = Stream(Broken(plan(amount.unit, resolve(target), [])))
    monkeypatch.setattr(Numbers, "lines", lambda *_: 1 / 0 if not mended else None)
    out = io.BytesIO()
    with pytest.raises(ZeroDivisionError):
        run(made, io.BytesIO(b"1\n2\n3\n4\n").read, out.write)
    assert out.getvalue().count(b"\n") == 2


def test_output_before_a_bad_line_comes_before_the_error_message():
    events: list[object] = []
    run(Stream(Numbers(LX_FC)), io.BytesIO(b"1\nx\n2\n").read, events.append, "warn",
        lambda error: events.append(error.message))  # fmt: skip
    assert events == [b"0.09290304\n", "stdin, line 2: 'x' is not a number", b"x\n0.18580608\n"]


def test_a_comma_in_a_number_does_not_split_it():
    made = Stream(Numbers(LX_FC), Cut(b","), Fields("2"))
    out, good, said = stream(b"x\n1,500\n2,1,000\n" + b"3,1\n" * 500, made, "fail")
    assert out == b"x\n1,46.45152\n2,1,000\n" + b"3,0.09290304\n" * 500
    assert (good, said) == (
        False,
        [
            "stdin, line 1: field 2 is missing",
            "stdin, line 3: 3 fields, but the lines before have 2",
        ],
    )
    out, good, _ = stream(b"1;500\n2;5;ok\n", Stream(Numbers(LX_FC), Cut(b";"), Fields("2")))
    assert (out, good) == (b"1;46.45152\n2;0.4645152;ok\n", True)


def test_lines_beyond_the_first_block_are_compared_with_the_header():
    header = Header(Cut(b","), resolve("lx"), resolve("fc"), lambda unit: Numbers(LX_FC), print)
    made = Stream(Numbers(LX_FC), header.cut, Fields("2"), 1, header)
    good_lines = b'a,5\n"b,c",7\n' * 30_000
    out, good, said = stream(b"t,E [lx]\n" + good_lines + b"1,18,000\n", made, "fail")
    assert out.startswith(b"t,E [fc]\na,0.4645152\n")
    assert out.endswith(b'"b,c",0.65032128\n1,18,000\n')
    assert (good, said) == (False, ["stdin, line 60002: 3 fields, but the header has 2"])
