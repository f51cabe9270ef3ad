"""Completion in real shells (bash, zsh, fish), each in a tmux screen."""

import os
import subprocess
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from conftest import entry_point
from helpers import require

START = {
    "bash": (
        "bash --norc --noprofile -i",
        "PS1='> '; eval \"$(_RADCALC_COMPLETE=bash_source radcalc)\"",
    ),
    "zsh": (
        "zsh -f -i",
        "PS1='> '; autoload -U compinit; compinit -D -u; "
        'eval "$(_RADCALC_COMPLETE=zsh_source radcalc)"',
    ),
    "fish": (
        "fish --no-config -i",
        "function fish_prompt; echo '> '; end; set -g fish_autosuggestion_enabled 0; "
        "_RADCALC_COMPLETE=fish_source radcalc | source",
    ),
}
LONGEST = 30  # seconds, on a busy machine
PAUSE = 0.02  # seconds between two reads of the screen


class Screen:
    """Shell with completion in a separate tmux screen."""

    def __init__(self, shell: str, home: Path) -> None:
        self.shell, self.socket = shell, home / "socket"
        place = Path(entry_point()).parent
        called, prepare = START[shell]
        path = f"{place}{os.pathsep}{os.environ['PATH']}"
        variables = {"HOME": str(home), "PATH": path, "TERM": "screen", "LC_ALL": "C.UTF-8"}
        environment = " ".join(f"'{name}={value}'" for name, value in variables.items())
        self.tmux(
            *("-f", os.devnull, "new-session", "-d", "-x", "150", "-y", "60", "-c", str(home)),
            f"env -i {environment} {called}",
        )
        self.type(f"{prepare}; echo rea''dy", "Enter")
        self.wait(lambda text: "\nready\n>" in text)

    def tmux(self, *words: str) -> str:
        # tmux starts commands with $SHELL, else with the user's login shell, which may be nologin
        done = subprocess.run(
            ["tmux", "-S", str(self.socket), *words],
            capture_output=True,
            text=True,
            encoding="utf-8",
            env=os.environ | {"SHELL": "/bin/sh"},
            timeout=LONGEST,
            check=True,
        )
        return done.stdout

    def type(self, text: str, *keys: str) -> None:
        self.tmux("send-keys", "-l", text)
        if keys:
            self.tmux("send-keys", *keys)

    def wait(self, is_there: Callable[[str], bool]) -> str:
        """Wait until the screen has the expected text; return it."""
        text = ""
        for _ in range(round(LONGEST / PAUSE)):
            text = self.tmux("capture-pane", "-p", "-J")
            if is_there(text):
                return text
            time.sleep(PAUSE)
        raise AssertionError(f"{self.shell} shows\n{text}")

    def clear(self) -> None:
        """Clear the screen and the line."""
        self.tmux("send-keys", "C-u", "C-l")
        self.wait(lambda text: text.strip() == ">")

    def completed(self, line: str, expected: str) -> None:
        """Check that a Tab after `line` completes it as expected, with its blank."""
        self.clear()
        self.type(line, "Tab")
        self.type("#")
        self.wait(lambda text: text.splitlines()[0].startswith(f"> {expected}#"))

    def listed(self, line: str, *expected: str) -> str:
        """Check that one or two Tabs after `line` list the expected words."""
        self.clear()
        self.type(line, "Tab", *(["Tab"] if self.shell == "bash" else []))
        return self.wait(lambda text: all(one in text for one in expected))


@pytest.fixture(scope="module", params=START)
def screen(request, tmp_path_factory) -> Iterator[Screen]:
    shell = request.param
    require("tmux", shell)
    home = tmp_path_factory.mktemp(shell)
    (home / "lamp one.ies").touch()
    (home / "folder").mkdir()
    (home / "folder" / "room.hdr").touch()
    screen = Screen(shell, home)
    yield screen
    screen.tmux("kill-server")


def described(screen: Screen, text: str, description: str) -> tuple[str, ...]:
    """Return what the shell shows for a suggestion: bash shows only the word."""
    if screen.shell == "bash":
        return (text,)
    return text, description


def test_units_in_reach_are_listed_and_the_others_with_their_conditions(screen):
    text = screen.listed(
        "radcalc 100 lx ",
        *described(screen, "fc", "footcandle"),
        *described(screen, "cd", "luminous intensity, with --distance"),
        *described(screen, "W/m2", "irradiance, with --wavelength, --spectrum or --efficacy"),
    )
    shown = text.split()
    assert shown.index("klx") < shown.index("cd")


def test_conditions_that_are_typed_are_taken_into_account(screen):
    text = screen.listed("radcalc 800 lm --isotropic --distance 2m l", "lx", "lm.s")
    assert text.split("lm.s")[0].split().count("lx") >= 1


def test_a_complete_word_gets_a_blank(screen):
    screen.completed("radcalc conv", "radcalc convert ")
    screen.completed("radcalc 100 lx umol/m2/da", "radcalc 100 lx umol/m2/day ")
    screen.completed("radcalc lambertian --lumina", "radcalc lambertian --luminance ")
    screen.completed("radcalc help photo", "radcalc help photon ")


def test_a_word_that_goes_on_gets_no_blank(screen):
    screen.completed("radcalc spectrum blackb", "radcalc spectrum blackbody:")
    screen.completed("radcalc environment fol", "radcalc environment folder/")
    screen.completed("radcalc point-source --check fl", "radcalc point-source --check flux")


def test_words_with_colons_and_equals_signs(screen):
    screen.completed("radcalc spectrum blackbody:3000", "radcalc spectrum blackbody:3000K ")
    screen.completed(
        "radcalc point-source -g illuminance:klx", "radcalc point-source -g illuminance:klx "
    )
    screen.completed("radcalc point-source --distance=2yd", "radcalc point-source --distance=2yd ")
    screen.completed(
        "radcalc point-source --check flux=80klm", "radcalc point-source --check flux=80klm "
    )
    screen.completed("radcalc environment sky:overc", "radcalc environment sky:overcast ")


def test_words_with_blanks_and_quotes(screen):
    screen.completed(
        "radcalc point-source --distribution lam",
        "radcalc point-source --distribution lamp\\ one.ies ",
    )
    screen.listed("radcalc spectrum ISO\\ 7589\\ Photo", "Photographic", "Photoflood")
    screen.clear()
    screen.type("radcalc spectrum 'ISO 7589 Photogr", "Tab")
    screen.wait(lambda text: "> radcalc spectrum 'ISO 7589 Photographic Daylight'" in text)


def test_spectra_with_their_temperatures(screen):
    screen.listed("radcalc spectrum LED-B", *described(screen, "LED-B3", "4102 K"))


def test_a_meaningless_line_is_unchanged(screen):
    for line in ("radcalc 'nosuch", "radcalc nosuch --", "radcalc 100 -- --x", "radcalc -g ((("):
        screen.clear()
        screen.type(line, "Tab")
        screen.type("#")
        text = screen.wait(lambda text, line=line: f"> {line}#" in text)
        assert "Traceback" not in text
        assert "radcalc:" not in text
