import os
import shutil
import signal
import subprocess
import sys
import sysconfig
from pathlib import Path

import pytest
from hypothesis import HealthCheck, settings

# No test depends on how fast the machine is, nor does the drawing of its examples.
settings.register_profile("untimed", deadline=None, suppress_health_check=[HealthCheck.too_slow])
settings.load_profile("untimed")

# What a shell starts in the background ignores interrupts, and so would all that it starts.
signal.signal(signal.SIGINT, signal.default_int_handler)

ROOT = Path(__file__).parent.parent


def entry_point() -> str:
    """The installed `radcalc` of the interpreter that runs the tests."""
    found = shutil.which("radcalc", path=sysconfig.get_path("scripts"))
    assert found, "radcalc is not installed for this interpreter: pip install '.[test]'"
    return found


def run(*words: str, **kwargs) -> subprocess.CompletedProcess[str]:
    """Run the installed command with both streams captured."""
    kwargs = {"capture_output": True, "text": True, "encoding": "utf-8", "timeout": 60} | kwargs
    return subprocess.run([entry_point(), *words], **kwargs)


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
    """No colour or debug settings of the caller's."""
    for name in ("NO_COLOR", "FORCE_COLOR", "RADCALC_DEBUG", "COLUMNS"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("LC_ALL", "C.UTF-8")  # tables have the names of the caller's language
    os.environ.setdefault("TERM", "xterm")
