import pytest

from radcalc.errors import UsageError
from radcalc.streams.fields import Cut, Fields, read_delimiter
from radcalc.streams.header import title_spans


def test_fields_and_delimiters_are_read_as_written():
    assert list(Fields("2,1").of(3)) == [0, 1]
    assert list(Fields("1-2,2-").of(4)) == [0, 1, 2, 3]
    assert list(Fields("\u22122").of(3)) == [0, 1]  # a minus sign, not an option
    assert [read_delimiter(d) for d in ("tab", "\\t", "comma", ",", "·")] == [
        "\t", "\t", ",", ",", "·",
    ]  # fmt: skip
    with pytest.raises(UsageError):
        Fields("")


def test_a_single_quotation_mark_is_a_cell_not_quotes():
    assert Cut(b",").inner(b'a,"', (2, 3)) == (2, 3)
    assert Cut(b",").inner(b'a,""', (2, 4)) == (3, 3)


@pytest.mark.parametrize(
    ("mark", "line", "titles"),
    [
        (b",", b't, "E, lx" ,x', [b"t", b"E, lx", b"x"]),
        (b",", b"# t,E", [b"t", b"E"]),
        (b"", b" t  E\tx ", [b"t", b"E", b"x"]),
        (b"", b"# t E", [b"t", b"E"]),
        (b"", b"t [s] E (W/(m2 sr)) x", [b"t [s]", b"E (W/(m2 sr))", b"x"]),
        (b"", b"t / s E / (W / m2) x/y", [b"t / s", b"E / (W / m2)", b"x/y"]),
        (b"", b"E[W m-2] t", [b"E[W m-2]", b"t"]),
        (b"", b"a [b c", [b"a", b"[b", b"c"]),
        (b"", b"a]b (c", [b"a]b", b"(c"]),
        (b" ", b"t [s]", [b"t", b"[s]"]),
        (b"", b"", []),
    ],
)
def test_a_header_is_split_into_titles(mark, line, titles):
    assert [line[start:end] for start, end in title_spans(Cut(mark), line)] == titles
