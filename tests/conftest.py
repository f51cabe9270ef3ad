import gc
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

# Neither tests nor the generation of examples depend on the speed of the machine.
settings.register_profile(
    "untimed", max_examples=50, deadline=None, suppress_health_check=[HealthCheck.too_slow]
)
settings.load_profile("untimed")


ROOT = Path(__file__).parent.parent
DOCS = (ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md")))
# The standard streams of a process under C.UTF-8: name, mode and error handler.
STREAMS = (
    ("stdin", "r", "surrogateescape"),
    ("stdout", "w", "surrogateescape"),
    ("stderr", "w", "backslashreplace"),
)


def pytest_configure() -> None:
    # A background process of a shell ignores interrupts, and its child processes inherit this.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    # As radcalc does at its start: looking for garbage takes a sixth of the tests' collection.
    gc.set_threshold(50_000)


def entry_point() -> str:
    """Return the path of `radcalc`, installed for the interpreter that runs the tests."""
    found = shutil.which("radcalc", path=sysconfig.get_path("scripts"))
    assert found, "radcalc is not installed for this interpreter: pip install '.[test]'"
    return found


def process(*words: str, **kwargs) -> subprocess.CompletedProcess[str]:
    """Run the installed command in a new process, with both streams captured."""
    kwargs = {"capture_output": True, "text": True, "encoding": "utf-8", "timeout": 60} | kwargs
    return subprocess.run([entry_point(), *words], **kwargs)


def run(
    *words: str,
    input: str = "",
    together: bool = False,
    cwd: Path | str = ".",
    check: bool = False,
) -> subprocess.CompletedProcess[str]:
    """Return the same as `process`, from a call in this process, which is much faster.

    With `together`, standard error is part of the output.  radcalc exits without flushing, so text
    that is still in a buffer at the end is lost here, too.
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
    """Replace the standard streams, both the descriptors and Python's objects, by files.

    Yield the files of standard output and standard error; with `together` both go to the first.
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
    """Run code in a new interpreter, with an empty standard input."""
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
    monkeypatch.setenv("LC_ALL", "C.UTF-8")  # the language of tables depends on the locale
    os.environ.setdefault("TERM", "xterm")
