"""`radcalc convert -`: numbers are converted, and every other byte is copied unchanged."""

import json
import os
import re
import select
import signal
import subprocess
import time

import pytest
from conftest import entry_point, run
from helpers import for_each, on_terminal, started


def convert(data: bytes, *words: str) -> subprocess.CompletedProcess[bytes]:
    """Run `radcalc convert - ...` on bytes."""
    return answered(data, "convert", "-", *words)


def answered(data: bytes, *words: str) -> subprocess.CompletedProcess[bytes]:
    """Run radcalc in this process on bytes."""
    done = run(*words, input=data.decode(errors="surrogateescape"))
    texts = [text.encode(errors="surrogateescape") for text in (done.stdout, done.stderr)]
    return subprocess.CompletedProcess(words, done.returncode, *texts)


# Input, options, output.
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
    "bytes that are not text": (
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
    "two lines of header": (b"E\nlx\n1\n", ("--header=2",), b"E\nfc\n0.09290304\n"),
    "a header alone": (b"E", ("--header=3",), b"E"),
    "a column": (b"t,E\n0,1\n", ("-d", ",", "--column", "E"), b"t,E\n0,0.09290304\n"),
    "a column without titles": (
        b"1,100,OK\n2,200,OK\n",
        ("-d", ",", "--column", "2"),
        b"1,9.290304,OK\n2,18.580608,OK\n",
    ),
    "a column without titles, by its own delimiter": (
        b"a 100 OK\nb 200 OK\n",
        ("--column", "2"),
        b"a 9.290304 OK\nb 18.580608 OK\n",
    ),
    "a column of a header in quotes": (
        b'\xef\xbb\xbf"E, ""lx""",t\r\n1,2\r\n',
        ("-d", ",", "--column", 'E, "lx"'),
        b'\xef\xbb\xbf"E, ""fc""",t\r\n0.09290304,2\r\n',
    ),
    "a column of two lines of header": (
        b"# log\nt E\n0 1\n",
        ("--column", "E", "--header=2"),
        b"# log\nt E\n0 0.09290304\n",
    ),
    "a unit in a header in quotes, behind a mark of the byte order": (
        b'\xef\xbb\xbf"E, ""a"" [lx]",t\r\n1,2\r\n',
        ("-d", ",", "--column", 'e, "a"'),
        b'\xef\xbb\xbf"E, ""a"" [fc]",t\r\n0.09290304,2\r\n',
    ),
    "a header that is not UTF-8": (
        b"t\xe9,E [lx],\xff\n0,1,2\n",
        ("-d", ",", "--column", "E"),
        b"t\xe9,E [fc],\xff\n0,0.09290304,2\n",
    ),
    "titles with the delimiter in them": (
        b"E [lx]|t\n1|2\n",
        ("-d", "|", "--column", "E", "--rename", "a|b"),
        b'"a|b [fc]"|t\n0.09290304|2\n',
    ),
    "a column that is added": (
        b"E,t\r\n1,2\r\n\r\n#\r\n3,4",
        ("-d", ",", "--column", "E", "--add", "a,b"),
        b'E,t,"a,b [fc]"\r\n1,2,0.09290304\r\n\r\n#\r\n3,4,0.27870912',
    ),
    "a column that is added between blanks": (
        b"t  E\n a 1 \n b\t2\n",
        ("--column", "E", "--add", "N"),
        b"t  E N [fc]\n a 1  0.09290304\n b\t2\t0.18580608\n",
    ),
    "a decimal comma": (
        b"1,5\n-,5e1\n2\n1/4\n",
        ("--decimal", ","),
        b"0,13935456\n-0,4645152\n0,18580608\n0,02322576\n",
    ),
    "a decimal comma in quotes": (
        b'"1,5";2,5\n',
        ("--decimal", ",", "-d", ";"),
        b'"0,13935456";2,5\n',
    ),
    "a precision": (b"12345\n1\n", ("--precision", "3"), b"1.15e+03\n0.0929\n"),
    "-n": (b"1\n", ("-n",), b"0.09290304\n"),
}  # fmt: skip


@for_each(EXACT.values())
def test_the_number_is_replaced_and_nothing_else(data, words, wanted):
    done = convert(data, "lx", "fc", *words)
    note = b"note: a negative illuminance is a difference: light is never negative\n"
    said = note if re.search(rb"^-", wanted, re.M) else b""
    assert (done.stdout, done.stderr, done.returncode) == (wanted, said, 0)


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


def test_conditions_work_and_their_assumptions_are_printed_once():
    done = convert(b"100\n200\n", "cd", "lx", "--distance", "2m")
    assert done.stdout == b"25\n50\n"
    assert done.stderr.count(b"assumed: a source small compared to its distance") == 1
    done = convert(b"100 cd\n1 kcd\n", "lx", "--distance", "2m")
    assert done.stdout == b"25\tlx\n250\tlx\n"
    assert done.stderr.count(b"assumed:") == 1
    assert convert(b"100\n", "cd", "lx", "--distance", "2m", "-q").stderr == b""


def test_json_is_one_object_per_number():
    done = convert(b"# c\n100,x,1\n2,x,3\n", "lx", "fc", "-d", ",", "--field", "1,3", "--json")
    found = [json.loads(line) for line in done.stdout.splitlines()]
    assert [(o["line"], o["field"], o["results"]["illuminance"]["value"]) for o in found] == [
        (2, 1, 9.290304),
        (2, 3, 0.09290304),
        (3, 1, 0.18580608),
        (3, 3, 0.27870912),
    ]
    alone = json.loads(run("convert", "2", "lx", "fc", "--json").stdout)
    assert alone["inputs"]["value"].pop("text") == "2 lx"  # in a stream, it names its line
    assert {**alone, "line": 3, "field": 1} == found[2]
    done = convert(b"2 W\nx\n\n1 W", "lm", "--efficacy", "93lm/W", "--json", "--invalid", "warn")
    found = [json.loads(line) for line in done.stdout.splitlines()]
    assert [(o["line"], o["results"]["luminous-flux"]["value"]) for o in found] == [
        (1, 186),
        (4, 93),
    ]
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
def test_a_bad_line_is_treated_as_by_numfmt(mode, out, status, complaints):
    done = convert(BAD, "lx", "fc", "--invalid", mode)
    assert (done.stdout, done.returncode) == (out, status)
    said = done.stderr.decode().splitlines()
    assert len(said) == complaints
    assert all("stdin, line 2: 'x' is not a number" in line for line in said[:1])


def test_a_bad_line_stops_the_stream_by_default():
    done = convert(BAD, "lx", "fc")
    assert (done.stdout, done.returncode) == (b"0.09290304\n", 2)
    assert b"Traceback" not in done.stderr


def test_a_line_with_a_bad_field_passes_unchanged():
    done = convert(b"1 2 3\n4 x 6\n", "lx", "fc", "--field", "1,2", "--invalid", "fail")
    assert done.stdout == b"0.09290304 0.18580608 3\n4 x 6\n"
    assert done.stderr == b"radcalc: stdin, line 2, field 2: 'x' is not a number\n"


def test_a_missing_field_is_refused():
    done = convert(b"1 2\n1\n", "lx", "fc", "--field", "2")
    assert (done.stdout, done.returncode) == (b"1 0.18580608\n", 2)
    assert done.stderr.startswith(b"radcalc: stdin, line 2: field 2 is missing\ntry: ")


def test_a_quote_that_is_not_closed_is_refused():
    for line in (b'"a,1\n', b'"a""b,1\n', b'"a"b,1\n', b'x,"\n'):
        done = convert(line, "lx", "fc", "-d", ",", "--field", "2")
        assert (done.stdout, done.returncode) == (b"", 2)
        assert b"a quoted field does not end on its line" in done.stderr


def test_a_number_with_more_after_it_is_not_a_bare_number():
    done = convert(b"100 lx\n", "lx", "fc")
    assert (done.stdout, done.returncode) == (b"", 2)
    assert b"radcalc convert - TARGET" in done.stderr


@pytest.mark.parametrize(
    "words",
    [
        ("--field", "2"),
        ("--column", "E"),
        ("-d", ","),
        ("--header",),
        ("--invalid", "warn"),
        ("--add", "E"),
        ("--rename", "E"),
        ("--decimal", ","),
    ],
)
def test_options_for_streams_do_not_apply_without_one(words):
    done = answered(b"", "convert", "1", "lx", "fc", *words)
    assert (done.stdout, done.returncode) == (b"", 2)
    assert b"applies to lines of standard input" in done.stderr


def test_a_column_must_be_in_the_header_exactly_once():
    for header, message in (
        (b"a,a\n", "2 times"),
        (b"b,c\n", "has no column"),
        (b"", "header of stdin is missing"),
    ):
        done = convert(header + b"1,2\n" * bool(header), "lx", "fc", "-d", ",", "--column", "a")
        assert (done.stdout, done.returncode) == (b"", 2)
        assert message in done.stderr.decode()


def test_a_header_in_utf_16_is_not_refused_as_one_without_the_column():
    done = convert("t,E [lx]\n0,1\n".encode("utf-16"), "lx", "fc", "-d", ",", "--column", "E")
    assert (done.stdout, done.returncode) == (b"", 2)
    assert b"is not text in UTF-8\ntry: UTF-8 (iconv" in done.stderr


def test_a_header_of_a_megabyte_is_read():
    titles = b",".join(b"c%d [lx]" % k for k in range(100_000))
    line = b",".join([b"1"] * 100_000)
    done = convert(titles + b"\n" + line + b"\n", "lx", "fc", "-d", ",", "--column", "C99999")
    assert done.stdout.endswith(b",c99999 [fc]\n" + line[:-1] + b"0.09290304\n")
    done = convert(b"(" * 1_000_000 + b"\n1\n", "lx", "fc", "--header", "--field", "1")
    assert done.returncode == 0


def test_the_header_option_never_takes_the_next_word():
    done = answered(b"E\n1\n", "convert", "--header", "-", "lx", "fc")
    assert done.stdout == b"E\n0.09290304\n"


def test_a_closed_pipe_ends_at_once_and_quietly():
    script = 'yes 1 | { "$@" convert - lx fc; echo $? >&2; } | head -n 1'
    command = ["sh", "-c", script, "sh", entry_point()]
    done = subprocess.run(command, capture_output=True, text=True, timeout=60)
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
            ["sh", "-c", f'exec "$@" convert - lx fc {closed}', "sh", entry_point()],
            input="1\n", capture_output=True, text=True, timeout=60,
        )  # fmt: skip
        assert done.returncode == 2
        assert message in done.stderr
        assert "Traceback" not in done.stderr


def test_standard_input_is_not_read_without_a_dash():
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
    """Read until a text appears."""
    found = b""
    while until not in found:
        ready, _, _ = select.select([descriptor], [], [], 60)
        assert ready, found
        found += os.read(descriptor, 65536)
    return found


@pytest.mark.parametrize("words", [(), ("--field", "1"), ("--json",)])
def test_a_terminal_shows_each_line_as_it_comes(words):
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


CALCULATED = ("point-source", "--intensity", "100cd", "--distance", "- m", "-g", "irradiance:lx")


def calculate(data: bytes, *words: str) -> subprocess.CompletedProcess[bytes]:
    """Run a calculator on bytes that hold the distances."""
    return answered(data, *CALCULATED, "-q", *words)


def test_a_calculator_on_a_stream_ends_as_a_conversion_does():
    script = 'yes 1 | { "$@"; echo $? >&2; } | head -n 1'
    command = ["sh", "-c", script, "sh", entry_point(), *CALCULATED, "-q"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=60)
    assert (done.stdout, done.stderr) == ("100\n", "0\n")
    with open("/dev/full", "wb") as full:
        done = subprocess.run(
            [entry_point(), *CALCULATED, "-q"],
            input=b"1\n" * 100_000, stdout=full, stderr=subprocess.PIPE, timeout=60,
        )  # fmt: skip
    assert done.returncode == 2
    assert done.stderr.startswith(b"radcalc: cannot write the answer: No space left on device\n")
    with started(
        entry_point(), *CALCULATED, "-q",
        stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
    ) as process:  # fmt: skip
        assert process.stdin is not None
        assert process.stdout is not None
        process.stdin.write(b"1\n")
        process.stdin.flush()
        assert process.stdout.readline() == b"100\n"
        time.sleep(0.1)  # back to reading
        process.send_signal(signal.SIGINT)
        _, err = process.communicate(timeout=30)
    assert (process.returncode, err.strip()) == (130, b"")


@pytest.mark.parametrize(
    ("mode", "out", "status", "complaints"),
    [("abort", b"100\n", 2, 2), ("fail", b"100\n-1\n25\n", 2, 1), ("warn", b"100\n-1\n25\n", 0, 1),
     ("ignore", b"100\n-1\n25\n", 0, 0)],
)  # fmt: skip
def test_a_refused_value_is_a_bad_line(mode, out, status, complaints):
    done = calculate(b"1\n-1\n2\n", "--invalid", mode)
    assert (done.stdout, done.returncode) == (out, status)
    said = done.stderr.decode().splitlines()
    assert len(said) == complaints
    assert all("stdin, line 2: --distance -1m is out of range" in line for line in said[:1])


def test_every_other_byte_of_a_line_is_unchanged():
    data = b'\xef\xbb\xbfa,"d [m]"\r\n"x, y"," 2 "\r\n\r\n# z\r\n\xff,10'
    done = calculate(data, "-d", ",", "--column", "d", "--rename", "E")
    wanted = b'\xef\xbb\xbfa,"E [lx]"\r\n"x, y"," 25 "\r\n\r\n# z\r\n\xff,1'
    assert (done.stdout, done.stderr, done.returncode) == (wanted, b"", 0)


def test_a_long_stream_of_a_calculator_equals_its_parts():
    """Blocks of many lines, a few of them refused, give the same as single lines."""
    lines = [b"-1" if k % 997 == 0 else b"%.3f" % (1 + k / 7) for k in range(20_000)]
    together = calculate(b"\n".join(lines) + b"\n", "--invalid", "ignore").stdout
    apart = calculate(b" x\n".join(lines) + b" x\n", "--invalid", "ignore", "--field", "1").stdout
    assert together.splitlines() == [line.removesuffix(b" x") for line in apart.splitlines()]
    distances = [float(line) for line in lines]  # E = I / d^2
    for distance, shown in zip(distances, together.splitlines(), strict=True):
        assert float(shown) == (
            pytest.approx(100 / distance**2, rel=1e-11) if distance > 0 else distance
        )


def test_a_remark_on_some_lines_is_printed_once_with_these_lines():
    words = ("photon", "-", "nm", "-g", "luminous-efficacy", "-g", "frequency")
    done = answered(b"500\n900\n950\n510\n", *words)
    said = done.stderr.decode().splitlines()
    notes = [line for line in said if line.startswith("note")]
    assert notes == ["note: lines 2 to 3: 900 to 950nm is invisible: it is outside the tables"]
    assert "assumed: 500 to 950nm is a vacuum wavelength" in said[0]
    assert sum("the tables of the eye" in line for line in said) == 1
