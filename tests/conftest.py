import os
import shutil
import signal
import subprocess
import sys
import sysconfig
import tempfile
from collections.abc import Iterator
from contextlib import ExitStack, chdir, contextmanager
from pathlib import Path
from typing import IO, Any

import pytest
from hypothesis import HealthCheck, settings

from radcalc import __main__, terminal

# No test depends on how fast the machine is, nor does the drawing of its examples.
settings.register_profile(
    "untimed", max_examples=50, deadline=None, suppress_health_check=[HealthCheck.too_slow]
)
settings.load_profile("untimed")


ROOT = Path(__file__).parent.parent
# The standard streams as a process under C.UTF-8 has them: what they are for, and what becomes of
# letters that there are not.
STREAMS = (
    ("stdin", "r", "surrogateescape"),
    ("stdout", "w", "surrogateescape"),
    ("stderr", "w", "backslashreplace"),
)


def pytest_configure() -> None:
    # What a shell starts in the background ignores interrupts, and so would all that it starts.
    signal.signal(signal.SIGINT, signal.default_int_handler)


def entry_point() -> str:
    """The installed `radcalc` of the interpreter that runs the tests."""
    found = shutil.which("radcalc", path=sysconfig.get_path("scripts"))
    assert found, "radcalc is not installed for this interpreter: pip install '.[test]'"
    return found


def process(*words: str, **kwargs) -> subprocess.CompletedProcess[str]:
    """Run the installed command in a process of its own, with both streams captured."""
    kwargs = {"capture_output": True, "text": True, "encoding": "utf-8", "timeout": 60} | kwargs
    return subprocess.run([entry_point(), *words], **kwargs)


def run(
    *words: str,
    input: str = "",
    together: bool = False,
    cwd: Path | str = ".",
    check: bool = False,
) -> subprocess.CompletedProcess[str]:
    """What `process` gives, by a call in this process: where a new one would show nothing more.

    With `together`, errors stand in the output.  As a process leaves without flushing, what is in
    a buffer at the end is lost here as well.
    """
    terminal.choose_color(terminal.AUTO)
    given = input.encode("utf-8", "surrogateescape")
    with standard_streams(given, together) as files, chdir(cwd):
        status = __main__.run(list(words))
        texts = []
        for file in files:
            file.seek(0)
            texts.append(file.read().decode("utf-8", "surrogateescape"))
    done = subprocess.CompletedProcess(words, status, *texts)
    if check:
        done.check_returncode()
    return done


@contextmanager
def standard_streams(given: bytes, together: bool = False) -> Iterator[tuple[IO[bytes], IO[bytes]]]:
    """Files in place of the three standard streams: of their descriptors and of Python's own.

    Those of standard output and standard error are yielded; with `together` the first has both.
    """
    how: dict[str, Any] = {"encoding": "utf-8", "newline": "", "closefd": False}
    with ExitStack() as stack:
        fed, out, err = (stack.enter_context(tempfile.TemporaryFile()) for _ in STREAMS)
        fed.write(given)
        fed.seek(0)
        for k, file in enumerate((fed, out, out if together else err)):
            kept = os.dup(k)
            stack.callback(os.close, kept)
            stack.callback(os.dup2, kept, k)
            os.dup2(file.fileno(), k)
        for k, (name, mode, errors) in enumerate(STREAMS):
            stack.callback(setattr, sys, name, getattr(sys, name))
            setattr(sys, name, stack.enter_context(open(k, mode, errors=errors, **how)))
        yield out, err


def python(code: str, *words: str) -> subprocess.CompletedProcess[str]:
    """Run code in a new interpreter, with nothing on standard input."""
    return subprocess.run(
        [sys.executable, "-c", code, *words],
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        encoding="utf-8",
        timeout=60,
    )


@pytest.fixture(autouse=True)
def _plain_environment(monkeypatch: pytest.MonkeyPatch) -> None:
    """Remove the settings of the caller for colour, debugging and encodings."""
    display = ("NO_COLOR", "FORCE_COLOR", "RADCALC_DEBUG", "COLUMNS")
    for name in (*display, "PYTHONUTF8", "PYTHONIOENCODING"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("LC_ALL", "C.UTF-8")  # tables have the names of the caller's language
    os.environ.setdefault("TERM", "xterm")
