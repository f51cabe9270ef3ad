"""Helpers of several tests."""

import json
import os
import pty
import re
import select
import shutil
import subprocess
import sys
import termios
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from inspect import signature
from pathlib import Path
from types import FrameType
from typing import Any
from unittest import mock

import pytest
from conftest import entry_point, run

import radcalc
from radcalc import lambertian, terminal
from radcalc.answer import coherent_unit_of
from radcalc.calculators import SUMMARIES, page_of
from radcalc.cli.spelling import Shell
from radcalc.errors import RadcalcError
from radcalc.laws import AnyLaw

PACKAGE = str(Path(radcalc.__file__).parent)
Q = radcalc.Quantity
KINDS = {  # coherent units, with the lumen and the photon as base units
    "e": ("W", "J"),
    "v": ("lm", "lm s"),
    "p": ("photon/s", "photon"),
}
LIGHT = {
    "flux": "{0}", "intensity": "{0}/sr", "irradiance": "{0}/m2", "exitance": "{0}/m2",
    "radiance": "{0}/m2/sr", "exposure": "{1}/m2", "energy": "{1}", "received-flux": "{0}",
    "incident-irradiance": "{0}/m2", "flux-within": "{0}", "beam-flux": "{0}",
    "far-field-irradiance": "{0}/m2", "scale": "{0}/sr", "peak-intensity": "{0}/sr",
    "intensity-toward": "{0}/sr", "upward-flux": "{0}", "downward-flux": "{0}",
    "mean-irradiance": "{0}/m2", "minimum-irradiance": "{0}/m2", "maximum-irradiance": "{0}/m2",
    "mean-radiance": "{0}/m2/sr", "peak-radiance": "{0}/m2/sr",
    "radiance-toward": "{0}/m2/sr", "zenith-radiance": "{0}/m2/sr",
    "horizontal-irradiance": "{0}/m2", "sun-irradiance": "{0}/m2", "diffuse-irradiance": "{0}/m2",
    "direct-irradiance": "{0}/m2", "peak-irradiance": "{0}/m2", "limit": "{0}/m2",
    "installed-irradiance": "{0}/m2", "mean-flux": "{0}", "global-irradiance": "{0}/m2",
    "sun-radiance": "{0}/m2/sr",
}  # fmt: skip
OTHER = {
    "distance": "m", "height": "m", "lateral": "m", "radius": "m", "diameter": "m", "width": "m",
    "length": "m", "area": "m2", "apparent-area": "m2", "receiver-area": "m2", "time": "s",
    "half-angle": "rad", "apex-angle": "rad", "beam-angle": "rad", "field-angle": "rad",
    "within": "rad", "off-axis": "rad", "incidence": "rad", "solid-angle": "sr",
    "projected-solid-angle": "sr", "received-solid-angle": "sr", "cosine": "1",
    "cosine-of-source": "1", "relative-intensity": "1",
    "part": "1", "beam-part": "1", "exponent": "1", "configuration-factor": "1",
    "reflectance": "1", "absorptance": "1", "mass": "kg", "specific-heat": "J/kg/K",
    "temperature-rise": "K", "heat": "J", "exposure-setting": "cycle/s", "f-number": "1",
    "ev": "1", "ev100": "1", "iso": "1", "luminance": "cd/m2", "k": "cd s/m2",
    "illuminance": "lx", "c": "lx s", "saturation-luminance": "cd/m2",
    "etendue": "m2 sr", "far-field-etendue": "m2 sr", "na": "1",
    "receiver-radius": "m", "receiver-diameter": "m", "horizontal": "rad", "vertical": "rad",
    "wavelength": "m", "peak-wavelength": "m", "frequency": "cycle/s", "wavenumber": "cycle/m",
    "photon-energy": "J/photon", "mesopic-luminance": "cd/m2", "scotopic-luminance": "cd_scot/m2",
    "sp-ratio": "1", "adaptation": "1", "upward-part": "1",
    "relative-axial-intensity": "1", "relative-peak-intensity": "1",
    "weighted-solid-angle": "sr", "azimuth": "rad", "beam-diameter": "m",
    "divergence": "rad",
}  # fmt: skip


def for_each(rows: Iterable[Any]) -> Callable[[Callable[..., None]], Callable[[], None]]:
    """Make one test from a check of a single row, for a long table of rows that are cheap to check.

    All rows are checked.  A failure names every row that fails and shows the first three errors.
    """
    table = [*rows]
    assert table, "a table without rows checks nothing"

    def decorate(check: Callable[..., None]) -> Callable[[], None]:
        takes_whole_row = len(signature(check).parameters) == 1

        def test() -> None:
            errors = []
            for row in table:
                try:
                    check(*((row,) if takes_whole_row else row))
                except (Exception, pytest.fail.Exception) as error:
                    errors.append((row, error))
            if errors:
                rows = "".join(f"\n{repr(row)[:200]}" for row, _ in errors)
                message = f"{len(errors)} of {len(table)} rows fail:{rows}"
                raise BaseExceptionGroup(message, [error for _, error in errors[:3]])

        test.__name__, test.__doc__ = check.__name__, check.__doc__
        return test

    return decorate


def unit_of(name: str, kind: str) -> Any:
    if name in LIGHT:
        return Q(1, LIGHT[name].format(*KINDS[kind]))
    # Symbols that only one calculator has are in the unit of the vocabulary.
    return Q(1, OTHER.get(name) or coherent_unit_of(name))


def require(*tools: str) -> None:
    """Skip the test if one of the tools is not installed; fail it if CI is set."""
    for tool in tools:
        if not shutil.which(tool):
            (pytest.fail if os.environ.get("CI") else pytest.skip)(f"{tool} is not installed")


def number(answer: dict[str, Any], name: str, unit: str) -> float:
    return float(answer[name].to(unit).magnitude)


def shell(error: RadcalcError) -> tuple[str, str]:
    """Return message and hint of an error, as the command line spells them."""
    return error.spelled(Shell)


def by_law(law: AnyLaw) -> Callable[..., Any]:
    """Return the left side of a law as a function of its other symbols, in their order."""
    return lambda *values: law.solve(
        law.names[0], dict(zip(law.names[1:], values, strict=True)).__getitem__
    )


PLAIN = [  # the calculators without operands
    name for name in SUMMARIES if page_of(name).examples and not page_of(name).operand
]


def example_of(name: str) -> list[str]:
    """Return the inputs of the first example on a calculator's page, as NAME=VALUE."""
    words = page_of(name).examples[0].split()
    return [word for word in words if word.partition("=")[0] not in ("get", "plot")]


def flagged(shape, *flags, **given):
    """Call `lambertian` with the flags of a rectangle."""
    return lambertian(shape, **dict.fromkeys(flags, True), **given)


def answers(text: str) -> list[dict[str, Any]]:
    """Read the answers in a JSON text: one object or an array of objects."""
    read = json.loads(text)
    return read if isinstance(read, list) else [read]


def results(text: str) -> dict[str, Any]:
    """Read the results of the only answer in a JSON text, keyed by name."""
    (answer,) = answers(text)
    return answer["results"]


@contextmanager
def at_most(calls: int) -> Iterator[None]:
    """Fail if radcalc calls more than that many functions, including functions of Python.

    The calls are counted because their time depends on the load of the machine.
    """
    left = calls

    def count(frame: FrameType, event: str, _: Any) -> None:
        nonlocal left
        if event in ("call", "c_call") and frame.f_code.co_filename.startswith(PACKAGE):
            left -= 1
            if left < 0:
                raise AssertionError(f"no answer within {calls} calls")

    before = sys.getprofile()
    sys.setprofile(count)
    try:
        yield
    finally:
        sys.setprofile(before)


@contextmanager
def started(*words: str, **streams: Any) -> Iterator[subprocess.Popen[Any]]:
    """Start a process that ends with the test, even if the test fails.

    A process that keeps running would cause a ResourceWarning in another test.
    """
    with subprocess.Popen(words, **streams) as process:
        try:
            yield process
        except BaseException:
            process.kill()
            raise


@contextmanager
def on_terminal(
    *words: str, columns: int = 80, **more: Any
) -> Iterator[tuple[subprocess.Popen[bytes], int]]:
    """Start a process on a pseudo-terminal; yield it and the descriptor of the screen."""
    leader, follower = pty.openpty()
    termios.tcsetwinsize(follower, (24, columns))
    try:
        streams = {"stdin": follower, "stdout": follower, "stderr": follower} | more
        with started(*words, **streams) as process:
            os.close(follower)
            yield process, leader
    finally:
        os.close(leader)


def terminal_of(*words: str, columns: int = 80, **environment: str) -> str:
    """Return the same as `screen_of`, from a call in this process with a simulated terminal."""
    size = os.terminal_size((columns, 24))
    with (
        mock.patch.dict(os.environ, {"TERM": "xterm", "COLUMNS": str(columns)} | environment),
        mock.patch.object(os, "get_terminal_size", return_value=size),
        mock.patch.object(terminal, "is_terminal", return_value=True),
        mock.patch.object(terminal, "error_is_terminal", return_value=True),
    ):
        return run(*words, together=True).stdout


def screen_of(*words: str, columns: int = 80, **environment: str) -> str:
    """Run on a pseudo-terminal of a given width; return the text on the screen."""
    env = os.environ | {"COLUMNS": str(columns), "TERM": "xterm"} | environment
    screen = b""
    with on_terminal(entry_point(), *words, columns=columns, env=env) as (process, leader):
        while True:
            ready, _, _ = select.select([leader], [], [], 60)
            try:
                part = os.read(leader, 65536) if ready else b""
            except OSError:
                part = b""
            if not part:
                break
            screen += part
        process.wait(60)
    return screen.decode().replace("\r\n", "\n")


ESCAPES = {
    r"\(aq": "'", r"\(dq": '"', r"\(ga": "`", r"\(ha": "^", r"\(ti": "~", r"\-": "-", r"\&": "",
    r"\e": "\\", r"\(+-": "±", r"\[+-]": "±", r"\(de": "°", r"\(mc": "µ", r"\(S2": "²",
    r"\[*D]": "Δ", r"\[*F]": "Φ", r"\[*h]": "θ", r"\[*p]": "π", r"\[*t]": "τ",
}  # fmt: skip
ESCAPED = re.compile(r"\\\[u([0-9A-F]{4,5})\]|\\\[[^]]*\]|\\\(..|\\.")


def displayed(source: str) -> str:
    """Return the text that the source of a manual page shows."""
    return ESCAPED.sub(lambda m: chr(int(m[1], 16)) if m[1] else ESCAPES[m[0]], source)


def displays_of(page):
    """Every command of the displays of a manual page, with the output below it."""
    displays = []
    for block in re.findall(r"^\.Bd -literal[^\n]*\n(.*?)^\.Ed$", page, re.MULTILINE | re.DOTALL):
        for entry in re.split(r"^\$ ", displayed(block), flags=re.MULTILINE)[1:]:
            lines = entry.split("\n")
            length = next(i for i, line in enumerate(lines, 1) if not line.endswith(("\\", "|")))
            displays.append(("\n".join(lines[:length]), "\n".join(lines[length:])))
    return displays
