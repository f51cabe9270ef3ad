"""radcalc as a process: pipes, full disks, bytes that are not text, signals."""

import os
import signal
import subprocess
import sys
import time
from itertools import product

import pytest
from conftest import ROOT, entry_point, process, python, run
from helpers import for_each, on_terminal, started

from radcalc.cli.command import commands


@pytest.mark.parametrize(
    "words", [("100", "lx", "fc"), ("250", "cd/m2"), ("1", "lx", "fc", "--json")]
)
def test_a_full_disk_is_an_error(words):
    with open("/dev/full", "w") as full:
        done = process("convert", *words, capture_output=False, stdout=full, stderr=subprocess.PIPE)
    assert done.returncode == 2
    assert done.stderr.startswith("radcalc: cannot write the answer: No space left on device\n")
    assert "Traceback" not in done.stderr
    assert len(done.stderr.splitlines()) == 2


@pytest.mark.parametrize("words", [("100", "lx", "fc"), ("250", "cd/m2", "-q"), ("--help",)])
def test_a_closed_pipe_ends_quietly(words):
    reader, writer = os.pipe()
    os.close(reader)
    done = process("convert", *words, capture_output=False, stdout=writer, stderr=subprocess.PIPE)
    os.close(writer)
    assert (done.returncode, done.stderr) == (0, "")


@pytest.mark.parametrize("words", ["100 lx fc", "100 lx fc --json"])
def test_a_missing_standard_output_is_an_error(words):
    done = subprocess.run(
        ["sh", "-c", f'exec "$@" convert {words} >&-', "sh", entry_point()],
        capture_output=True,
        text=True,
    )
    assert done.returncode == 2
    assert "standard output is closed" in done.stderr


def test_a_missing_standard_error_is_not_a_failure():
    done = subprocess.run(
        ["sh", "-c", 'exec "$@" convert 800 lm cd --isotropic 2>&-', "sh", entry_point()],
        capture_output=True,
        text=True,
    )
    assert (done.returncode, done.stdout) == (0, "63.6619772368\tcd\n")


HOSTILE = {
    "bytes that are not UTF-8": b"lx\xff\xfe",
    "control characters": b"lx\x1b[31m\x07",
    "a newline": b"lx\nfc",
    "100 kB of letters": b"x" * 100_000,
    "100 kB of brackets": b"(" * 100_000,
    "100 kB of digits": b"9" * 100_000,
    "20 kB of powers": b"m^9 " * 5_000,
    "markup": b"[/bold]",
    "a format string": b"{0.__class__}%s%n",
    "nothing": b"",
    "a blank": b" ",
}


PLACES = ["value", "source", "target", "condition", "option", "search", "name", "typical"]


@for_each(product(HOSTILE.values(), PLACES))
def test_whatever_is_typed_gets_one_clear_message(text, place):
    words = {
        "value": [b"convert", text, b"lx", b"fc"],
        "source": [b"convert", b"1", text, b"fc"],
        "target": [b"convert", b"1", b"lx", text],
        "condition": [b"convert", b"1", b"cd", b"lx", b"--distance", text],
        "option": [b"convert", b"1", b"cd", b"lx", b"--x" + text],
        "search": [b"units", b"zz" + text],
        "name": [b"quantities", b"zz" + text],
        "typical": [b"typical", b"zz" + text],
    }[place]
    done = run(*map(os.fsdecode, words))
    message = done.stderr
    assert done.returncode == 2
    assert done.stdout == ""
    assert message.startswith("radcalc: ")
    starts = [line.partition(" ")[0] for line in message.splitlines()]
    assert [start for start in starts if start not in ("", "or:", "or")] in (
        ["radcalc:"],
        ["radcalc:", "try:"],
    )
    assert len(message) < 600
    assert all(c.isprintable() or c == "\n" for c in message)


def test_bytes_of_another_process_may_not_be_text():
    done = subprocess.run([entry_point(), b"1", b"lx\xff\xfe", b"fc"], capture_output=True)
    assert (done.returncode, done.stdout) == (2, b"")
    assert done.stderr.startswith(rb"radcalc: the unit 'lx\udcff\udcfe' has ")


def test_a_bug_is_reported_as_a_bug(monkeypatch, capsys):
    from radcalc import cli

    def broken(*args, **kwargs):
        raise ZeroDivisionError("oh")

    monkeypatch.setattr(commands, "invoke", broken)
    assert cli.run(["convert"]) == 3
    message = capsys.readouterr().err
    assert "bug in radcalc" in message
    assert "Traceback" not in message
    monkeypatch.setenv("RADCALC_DEBUG", "1")
    assert cli.run(["convert"]) == 3
    assert "Traceback" in capsys.readouterr().err


def test_a_lack_of_memory_is_not_reported_as_a_bug(monkeypatch, capsys):
    from radcalc import cli

    def greedy(*args, **kwargs):
        raise MemoryError

    monkeypatch.setattr(commands, "invoke", greedy)
    assert cli.run(["convert"]) == 2
    assert capsys.readouterr().err.startswith("radcalc: not enough memory\ntry: ")


@pytest.mark.parametrize("asked", ["nonsense", "bash", "bash_nonsense", "bash_complete"])
def test_an_unknown_completion_is_refused(asked, monkeypatch):
    monkeypatch.setenv("_RADCALC_COMPLETE", asked)
    done = process()
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr.startswith(f"radcalc: _RADCALC_COMPLETE={asked} is not a known request")


def test_an_interrupt_exits_130_without_a_traceback():
    code = (
        "import sys, time, radcalc.terminal as c\n"
        "def wait(*a, **k):\n    print('ready', flush=True)\n    time.sleep(30)\n"
        "c.write = wait\n"
        "sys.argv = ['radcalc', 'convert', '250', 'cd/m2']\n"
        "from radcalc.__main__ import main\n"
        "main()"
    )
    words = (sys.executable, "-c", code)
    with started(*words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        assert process.stdout.readline() == "ready\n"
        time.sleep(0.1)  # asleep, as when a user interrupts it
        process.send_signal(signal.SIGINT)
        _, err = process.communicate(timeout=30)
    assert (process.returncode, err) == (130, "")


def heed_interrupts() -> None:
    """Restore the default action of SIGINT, which shells disable for background processes."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)


def test_an_interrupted_stream_ends_quietly_in_a_pipe():
    words = (entry_point(), "convert", "-", "lx", "fc")
    streams = dict.fromkeys(("stdin", "stdout", "stderr"), subprocess.PIPE)
    with started(*words, **streams, preexec_fn=heed_interrupts) as process:
        process.stdin.write(b"1\n")
        process.stdin.flush()
        assert process.stdout.readline() == b"0.09290304\n"
        process.send_signal(signal.SIGINT)
        assert process.wait(30) == 130
        assert process.stderr.read() == b""
        process.stdin.close()


def test_an_interrupted_stream_ends_quietly_on_a_terminal():
    words = (sys.executable, "-c", ON_A_TERMINAL, entry_point(), "convert", "-", "lx", "fc")
    heeding = {"start_new_session": True, "preexec_fn": heed_interrupts}
    with on_terminal(*words, **heeding) as (process, leader):
        os.write(leader, b"1\n")
        screen = b""
        while b"0.09290304" not in screen:
            screen += os.read(leader, 1000)
        os.write(leader, b"\x03")
        assert process.wait(30) == 130
        assert os.read(leader, 1000).strip() in (b"", b"^C")


# It must be the controlling terminal to send Ctrl-C.
ON_A_TERMINAL = """
import fcntl, os, sys, termios
fcntl.ioctl(0, termios.TIOCSCTTY, 0)
os.execv(sys.argv[1], sys.argv[1:])
"""
LAUNCHER = str(ROOT / "bin" / "radcalc")  # hatch_build.py installs it there


def launched(*words: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-X", "importtime", *words], capture_output=True, text=True, timeout=60
    )


def test_the_launcher_answers_without_the_modules_that_start_slowly():
    bare, done = launched("-c", "pass"), launched(LAUNCHER, "convert", "100", "lx", "fc")
    assert done.stdout == "9.290304\tfc\n"
    before, loaded = (
        {line.rpartition("|")[2].strip() for line in each.stderr.splitlines()}
        for each in (bare, done)
    )
    assert "radcalc.__main__" in loaded
    assert not (loaded - before) & {"re", "enum", "functools", "collections", "signal", "typing"}


@pytest.mark.parametrize(
    ("words", "status"),
    [
        ("convert 100 lx fc", 0),
        ("convert 100 lx fc --json", 0),
        ("convert 100 lx fc --check 8", 1),
        ("convert 800 lm cd", 2),
        ("covnert", 2),
        ("--help", 0),
    ],
)
def test_the_launcher_returns_the_exit_status(words, status):
    done = subprocess.run([sys.executable, LAUNCHER, *words.split()], capture_output=True)
    assert done.returncode == status
    assert b"Traceback" not in done.stderr


@pytest.mark.parametrize("module", ["radcalc", "radcalc.__main__", "radcalc.units"])
def test_an_interrupt_while_the_launcher_imports_exits_130_without_a_traceback(module):
    code = """
import os, signal, sys
class Interrupting:
    def find_spec(self, name, *rest):
        if name == wanted:
            os.kill(os.getpid(), signal.SIGINT)
signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell's background job ignores it
sys.meta_path.insert(0, Interrupting())
script, wanted = sys.argv[1:]
sys.argv = ["radcalc", "convert", "100", "lx", "fc"]
exec(compile(open(script).read(), script, "exec"))
"""
    done = python(code, LAUNCHER, module)
    assert (done.returncode, done.stdout, done.stderr) == (130, "", "")
