"""Descriptors that transfer a part at a time: an answer is complete or the status is an error.

Some outputs are also tested without Python's buffer (PYTHONUNBUFFERED, usual in containers).
"""

import fcntl
import os
import signal
import subprocess
import termios
import time
from collections.abc import Iterator
from functools import cache

import pytest
from conftest import entry_point, process, run
from helpers import started

LINES = "".join(f"{k}.5\n" for k in range(4_000))
SMALL = [("convert", "100", "lx", "fc"), ("convert", "1", "lx", "fc", "--json"), ("--version",)]
LARGE = [
    ("convert", "-", "lx", "fc"),  # a stream
    ("convert", "-", "lx", "fc", "--json"),
    ("point-source", "--flux", "1lm", "--distance", "1m:900m:0.1m", "-g", "irradiance"),
    ("units", "--format", "table"),
    ("convert", "1", "lm", "lx", "--isotropic", "--distance", "1m:300m:1m", "--format", "table"),
]
WAYS = [*SMALL, *LARGE, ("convert", "--help"), ("direction", "1", "2", "3")]


UNBUFFERED = [SMALL[0], LARGE[0], LARGE[3]]  # a word, a stream and a table


def in_both_ways(calls: list[tuple[str, ...]]) -> pytest.MarkDecorator:
    """Parametrise with every call, and with some of them unbuffered."""
    rows = [(words, "") for words in calls] + [
        (words, "1") for words in UNBUFFERED if words in calls
    ]
    ids = [f"{' '.join(words)}{' unbuffered' if value else ''}" for words, value in rows]
    return pytest.mark.parametrize(("words", "unbuffered"), rows, ids=ids, indirect=["unbuffered"])


@pytest.fixture
def unbuffered(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PYTHONUNBUFFERED", request.param)


@pytest.fixture
def lines(tmp_path) -> Iterator[object]:
    """File of numbers, for calls that read standard input."""
    (tmp_path / "lines").write_text(LINES)
    with (tmp_path / "lines").open() as file:
        yield file


def waiting(reader: int) -> int:
    """Return the number of bytes in a pipe."""
    return int.from_bytes(fcntl.ioctl(reader, termios.FIONREAD, b"\0" * 4), "little")


def whole(reader: int) -> bytes:
    """Read everything, in small parts."""
    return b"".join(iter(lambda: os.read(reader, 5000), b""))


@cache
def expected(words: tuple[str, ...]) -> bytes:
    return run(*words, input=LINES).stdout.encode()


@in_both_ways(WAYS)
def test_a_full_device_is_never_an_answer(words, unbuffered, lines):
    with open("/dev/full", "w") as full:
        done = process(
            *words, capture_output=False, stdin=lines, stdout=full, stderr=subprocess.PIPE
        )
    assert done.returncode == 2
    assert done.stderr.startswith("radcalc: cannot write the answer: No space left on device\n")
    assert len(done.stderr.splitlines()) == 2


@in_both_ways(LARGE)
def test_a_file_that_may_not_grow_is_an_error(words, unbuffered, tmp_path):
    # Otherwise Python would write truncated compiled modules, which later starts would read.
    limited = f'export PYTHONDONTWRITEBYTECODE=1; ulimit -f 8; exec "$@" > "{tmp_path / "out"}"'
    command = ["sh", "-c", limited, "sh", entry_point(), *words]
    done = subprocess.run(command, input=LINES, capture_output=True, text=True)
    assert done.returncode == 2
    assert done.stderr.startswith("radcalc: cannot write the answer: File too large\n")


@in_both_ways([*SMALL, *LARGE])
def test_a_full_pipe_that_does_not_block_is_waited_for(words, unbuffered, lines):
    reader, writer = os.pipe()
    os.set_blocking(writer, False)
    filled = os.write(writer, b"." * (1 << 20))
    command = (entry_point(), *words)
    with started(*command, stdin=lines, stdout=writer, stderr=subprocess.DEVNULL) as process:
        os.close(writer)
        time.sleep(0.5)  # until it waits for the full pipe
        assert process.poll() is None
        out = whole(reader)
        process.wait(60)
    os.close(reader)
    assert process.returncode == 0
    assert out[filled:] == expected(words)


@in_both_ways(LARGE)
def test_a_process_that_is_stopped_and_continued_loses_nothing(words, unbuffered, lines):
    reader, writer = os.pipe()
    size = fcntl.fcntl(writer, fcntl.F_SETPIPE_SZ, 4096)
    command = (entry_point(), *words)
    with started(*command, stdin=lines, stdout=writer, stderr=subprocess.DEVNULL) as process:
        os.close(writer)
        while waiting(reader) < size and process.poll() is None:  # until it is writing
            time.sleep(0.01)
        process.send_signal(signal.SIGSTOP)
        os.waitid(os.P_PID, process.pid, os.WSTOPPED)
        process.send_signal(signal.SIGCONT)
        out = whole(reader)
        process.wait(60)
    os.close(reader)
    assert process.returncode == 0
    assert out == expected(words)


def test_an_error_is_printed_on_a_full_pipe_that_does_not_block():
    reader, writer = os.pipe()
    os.set_blocking(writer, False)
    filled = os.write(writer, b"." * (1 << 20))
    with started(entry_point(), "convert", "1", "zork", "fc", stderr=writer) as process:
        os.close(writer)
        time.sleep(0.5)
        said = whole(reader)[filled:]
        process.wait(60)
    os.close(reader)
    assert process.returncode == 2
    assert said.startswith(b"radcalc: unknown unit 'zork'\ntry: ")


SPECTRUM = "nm,value\n" + "".join(f"{k},{1 + (k % 7)}\n" for k in range(380, 781))
READERS = {
    "spectrum": (("spectrum", "-", "-g", "luminous-efficacy:lm/W"), SPECTRUM),
    "condition": (("convert", "1", "W", "lm", "--spectrum", "-"), SPECTRUM),
    "stream": (("convert", "-", "lx", "fc"), "1\n2\n3\n4\n"),
}


@pytest.mark.parametrize(("words", "text"), READERS.values(), ids=READERS)
def test_an_input_that_does_not_block_is_read_to_its_end(words, text):
    reader, writer = os.pipe()
    os.set_blocking(reader, False)
    half = text.index("\n", len(text) // 2) + 1
    command = (entry_point(), *words)
    streams = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True}
    with started(*command, stdin=reader, **streams) as process:
        for part in (text[:half], text[half:]):
            time.sleep(0.3)  # an empty pipe is not the end
            os.write(writer, part.encode())
            while waiting(reader):
                time.sleep(0.01)
        time.sleep(0.3)
        os.close(reader)
        os.close(writer)
        out, _ = process.communicate(timeout=60)
    assert (process.returncode, out) == (0, run(*words, input=text).stdout)


@pytest.mark.parametrize(("words", "_"), READERS.values(), ids=READERS)
def test_an_input_that_is_closed_is_an_error(words, _):
    command = ["sh", "-c", 'exec "$@" <&-', "sh", entry_point(), *words]
    done = subprocess.run(command, capture_output=True, text=True)
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr == "radcalc: cannot read stdin: it is closed\ntry: a file or a pipe\n"
