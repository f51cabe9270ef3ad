"""What a system without POSIX needs: no module of POSIX alone, its encodings, its ends of lines."""

import errno
import json
import os
import subprocess
import sys

import pytest
from conftest import ROOT, run

from radcalc import terminal
from radcalc.calculators import COMMANDS
from radcalc.errors import OutputError

# What Python lacks on Windows.  asyncio and subprocess, which need it here, are imported before.
WITHOUT_POSIX = """
import asyncio, os, select, signal, subprocess, sys
for name in "fcntl grp pty pwd readline resource syslog termios tty".split():
    sys.modules[name] = None
for module, names in {
    os: "fork getpgid mkfifo O_NONBLOCK set_blocking sysconf",
    select: "epoll poll",
    signal: "SIGALRM SIGHUP SIGPIPE SIGUSR1 SIGWINCH setitimer pthread_sigmask",
}.items():
    for name in names.split():
        if hasattr(module, name):
            delattr(module, name)
"""
IMPORT_ALL = """
import importlib, json, pkgutil, radcalc
found = [one.name for one in pkgutil.walk_packages(radcalc.__path__, "radcalc.")]
for name in found:
    if not name.endswith("__main__"):
        importlib.import_module(name)
print(json.dumps(found))
"""
ANSWER = """
from radcalc.__main__ import run
sys.exit(run(sys.argv[1:]))
"""


def without_posix(code, *words, input="", encoding="cp1252"):
    """Run a program in a Python that lacks what Windows lacks, with an encoding of Windows."""
    return subprocess.run(
        [sys.executable, "-c", WITHOUT_POSIX + code, *words],
        input=input.encode(),
        capture_output=True,
        env=os.environ | {"PYTHONIOENCODING": encoding, "PYTHONPATH": str(ROOT), "PYTHONUTF8": "0"},
        timeout=120,
    )


def test_every_module_is_imported_without_those_of_posix():
    done = without_posix(IMPORT_ALL)
    assert done.returncode == 0, done.stderr.decode()
    found = json.loads(done.stdout)
    assert {"radcalc.cli.prompt", "radcalc.streams.stream", "radcalc.plots.figure"} <= {*found}


# 1 fc is 1 lm/ft2, and a foot is 0.3048 m (NIST SP 811)
@pytest.mark.parametrize(
    ("words", "input", "status", "output"),
    [
        ("convert 100 lx fc", "", 0, "9.290304\tfc\n"),
        ("100 lx to fc -q", "", 0, "9.290304\tfc\n"),
        ("convert 100 lx fc --format table", "", 0, "9.2903   fc"),
        ("convert - lx fc", "100\r\n200\r\n", 0, "9.290304\r\n18.580608\r\n"),
        ("convert 800 lm cd", "", 2, ""),
        ("convert --help", "", 0, "Usage: radcalc convert "),
        ("footcandle lx", "5\n", 2, ""),
        ("typical candle", "", 0, "candle"),
        ("manual 7 units", "", 0, "radcalc-units"),
        ("quantities svítivost", "", 0, "luminous intensity\t"),
        ("prompt", "100 lx fc\r\n", 0, "9.290304\tfc\n"),
    ],
)
def test_a_call_is_answered_without_posix(words, input, status, output):
    done = without_posix(ANSWER, *words.split(), input=input)
    printed, said = done.stdout.decode("cp1252"), done.stderr.decode("cp1252")
    assert done.returncode == status, said
    assert output in printed
    assert bool(output) == bool(printed)
    assert "bug" not in said
    assert "Traceback" not in said


def test_every_help_is_written_in_an_encoding_of_windows():
    code = """
from radcalc.__main__ import run
from radcalc.calculators import COMMANDS
for name in COMMANDS:
    assert run([name, "--help"]) == 0
"""
    done = without_posix(code)
    assert done.returncode == 0, done.stderr.decode()
    text = done.stdout.decode("cp1252")
    assert text.count("\nManual: radcalc manual") == len(COMMANDS)


class Pipe:
    """A file whose writing fails as that of a closed pipe does on Windows."""

    encoding = "utf-8"
    errors = "strict"

    def __init__(self, descriptor):
        self.buffer, self.descriptor = self, descriptor

    def fileno(self):
        return self.descriptor

    def write(self, data):
        raise OSError(errno.EINVAL, "Invalid argument")


def test_a_closed_pipe_of_windows_ends_quietly(monkeypatch, tmp_path):
    reader, writer = os.pipe()
    monkeypatch.setattr(terminal, "IS_WINDOWS", True)
    monkeypatch.setattr(sys, "stdout", Pipe(writer))
    terminal.write("100 lx\n")
    with open(tmp_path / "answer", "wb") as file:  # of a file it is another error
        monkeypatch.setattr(sys, "stdout", Pipe(file.fileno()))
        with pytest.raises(OutputError):
            terminal.write("100 lx\n")
    os.close(reader)
    os.close(writer)


def test_paths_of_windows_are_files(tmp_path, monkeypatch):
    """Such a name is a file here too."""
    monkeypatch.chdir(tmp_path)
    lamp = (ROOT / "examples" / "downlight.ies").read_bytes()
    (tmp_path / r"C:\lamps\spot.ies").write_bytes(lamp.replace(b"\n", b"\r\n"))
    (tmp_path / r"C:\lamps\led.csv").write_bytes(b"nm,W\r\n400,1\r\n500,2\r\n600,1\r\n")
    (tmp_path / "spot.ies").write_bytes(lamp)
    there, here = run(r"C:\lamps\spot.ies", "-q"), run("spot.ies", "-q")
    assert there.returncode == 0
    assert there.stdout == here.stdout != ""
    for name in (r"C:\lamps\led.csv", r"C:\lamps\led.csv:W"):
        done = run("convert", "100", "lx", "W/m2", "--spectrum", name, "-q")
        assert done.returncode == 0, done.stderr
