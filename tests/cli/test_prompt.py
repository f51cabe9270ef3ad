"""The prompt, on a terminal and with lines from a pipe."""

import os
import re
import select
import stat
import subprocess
import sys

import pytest
from conftest import entry_point, process, run
from helpers import on_terminal
from prompt_toolkit.history import FileHistory, InMemoryHistory

from radcalc.cli import prompt

ANSWERS = "9.290304\tfc\n0.1\tklx\n"


def lines(text, *words, **more):
    return run("prompt", *words, input=text, **more)


def test_the_lines_of_a_pipe_are_answered_one_by_one():
    done = lines("100 lx fc\n\n# a comment\nans klx\n")
    assert (done.returncode, done.stdout, done.stderr) == (0, ANSWERS, "")


@pytest.mark.parametrize("text", ["\ufeff100 lx fc\nans klx\n", "100 lx fc\r\nans klx\r\n"])
def test_line_ends_of_other_systems_are_accepted(text):
    assert lines(text).stdout == ANSWERS


def test_the_last_line_needs_no_newline():
    assert lines("100 lx fc\nans klx").stdout == ANSWERS


@pytest.mark.parametrize(
    ("text", "status"),
    [("", 0), ("100 lx fc\nexit\n100 lm cd\n", 0), ("100 lm cd\n100 lx fc\n", 2),
     ("100 lx fc --check 8\n100 lx fc\n", 1), ("100 lx fc --check 8\nzork\n", 2)],
)  # fmt: skip
def test_the_exit_status_is_the_worst_of_the_lines(text, status):
    assert lines(text).returncode == status


def test_a_refusal_names_its_line_and_the_other_lines_are_answered():
    done = lines("100 lm cd\n100 lx fc\n")
    assert done.stdout == "9.290304\tfc\n"
    assert done.stderr.startswith("radcalc: line 1: cannot convert luminous flux (lm)")


def test_lines_that_are_not_text_are_refused():
    more = {"text": False, "encoding": None}
    done = process("prompt", input=b"100 lx\xff fc\n100 lx fc\n", **more)
    assert done.stdout == b"9.290304\tfc\n"
    assert done.stderr.startswith(b"radcalc: line 1: ")


def test_a_line_does_not_read_the_lines_after_it():
    done = lines("convert - lx fc\n100\n")
    assert done.returncode == 2
    assert "line 1: - cannot be used at the prompt, which reads standard input" in done.stderr


def test_an_endless_line_is_not_kept_in_memory():
    done = lines("9" * (prompt.LONGEST + 2 * prompt.BLOCK))
    assert done.returncode == 2
    assert len(done.stderr) < 600


def test_options_apply_to_every_line():
    assert lines("100 lx fc\n1 klx lx\n", "-n").stdout == "9.290304\n1000\n"
    assert lines("100 lx fc\n", "--json", "-n").returncode == 2


# yes '100 lx fc' | radcalc prompt | head -1; with 2>&1 also for lines that are refused
@pytest.mark.parametrize("line", ["100 lx fc", "100 lx zork"])
def test_lines_end_once_nobody_reads_the_answers(line):
    reader, writer = os.pipe()
    with subprocess.Popen(
        [entry_point(), "prompt"], stdin=subprocess.PIPE, stdout=writer, stderr=writer, bufsize=0
    ) as done:
        os.close(writer)
        os.close(reader)
        written = (done.stdin.write(f"{line}\n".encode()) for _ in range(300_000 // len(line)))
        with pytest.raises(BrokenPipeError):  # it does not read what has no end
            sum(written)


def test_without_a_terminal_radcalc_alone_is_not_a_prompt():
    done = run(input="100 lx fc\n")
    assert (done.returncode, done.stdout) == (2, "")


class Screen:
    """Text sent to a terminal, without control sequences."""

    def __init__(self, leader):
        self.leader = leader
        self.text = self.raw = ""

    def read(self, wanted):
        """Read until the text appears; drop everything up to its end."""
        while wanted not in self.text:
            ready, _, _ = select.select([self.leader], [], [], 60)
            assert ready, (wanted, self.text)
            sent = os.read(self.leader, 65536).decode(errors="replace")
            self.raw += sent
            if "\x1b[6n" in sent:  # a request for the cursor's position
                os.write(self.leader, b"\x1b[1;1R")
            self.text += re.sub(r"\x1b(\[[0-9;?]*[A-Za-z]|[=>])", "", sent)
        _, _, self.text = self.text.partition(wanted)

    def type(self, keys):
        os.write(self.leader, keys.encode())

    def answer(self, line, wanted):
        """Type a line and read its answer, and the next prompt."""
        self.type(f"{line}\r")
        self.read(wanted)
        self.read(">")  # before the prompt, the terminal driver handles keys


# It must be the controlling terminal to send Ctrl-C.
OWN_TERMINAL = """
import fcntl, os, sys, termios
fcntl.ioctl(0, termios.TIOCSCTTY, 0)
os.execv(sys.argv[1], sys.argv[1:])
"""


@pytest.fixture
def terminal(tmp_path, monkeypatch):
    """Prompt on a terminal, with an empty history."""
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    monkeypatch.delenv("RADCALC_HISTORY", raising=False)
    words = (sys.executable, "-c", OWN_TERMINAL, entry_point())
    with on_terminal(*words, start_new_session=True) as (process, leader):
        screen = Screen(leader)
        screen.read("type help for help")
        screen.read(">")
        yield screen, process
        process.kill()


def test_radcalc_alone_on_a_terminal_starts_a_prompt(terminal, tmp_path):
    screen, process = terminal
    screen.answer("100 lx fc", "9.2903 fc   (illuminance)")
    screen.answer("ans klx", "0.1 klx   (illuminance)")
    screen.answer("100 lm 'cd", "the ' has no second one")
    screen.type("exit\r")
    assert process.wait(60) == 0
    history = tmp_path / "radcalc" / "history"
    assert [*FileHistory(history).load_history_strings()] == [
        "exit",
        "100 lm 'cd",
        "ans klx",
        "100 lx fc",
    ]
    assert stat.S_IMODE(history.stat().st_mode) == 0o600


def test_ctrl_c_drops_the_line_and_ctrl_d_leaves(terminal):
    screen, process = terminal
    screen.type("100 lm cd\x03")
    screen.read(">")
    screen.answer("100 lx fc", "9.2903 fc")
    screen.type("\x04")
    assert process.wait(60) == 0


def test_ctrl_c_stops_an_answer_and_the_prompt_goes_on(terminal):
    screen, process = terminal
    screen.answer("x = 5 lm", "5 lm   (luminous flux)")
    screen.type("integrate 'sin(1e9*theta*phi/rad)' --sphere --accuracy 1e-14\r")
    screen.read("1e-14")
    screen.read("\n")
    screen.type("\x03")
    screen.read(">")
    screen.answer("x mlm", "5000 mlm")
    screen.type("\x04")
    assert process.wait(60) == 0


def test_tab_completes_a_command(terminal):
    screen, process = terminal
    screen.type("calori\t")
    screen.read("meter")
    screen.type("\x03\x04")
    assert process.wait(60) == 0


def test_the_arrow_key_recalls_the_lines_of_the_last_session(tmp_path, monkeypatch):
    kept = tmp_path / "lines"
    FileHistory(kept).store_string("250 cd/m2 nit")
    text = kept.read_text()
    monkeypatch.setenv("RADCALC_HISTORY", str(kept))
    with on_terminal(entry_point(), "prompt") as (process, leader):
        screen = Screen(leader)
        screen.read("exit to quit")
        screen.read(">")
        screen.answer("\x1b[A", "250 nit")
        screen.type("\x04")
        assert process.wait(60) == 0
    assert kept.read_text() == text  # a repeated line is kept once


@pytest.mark.parametrize(
    "place", ["", "/dev/null/history", "/proc/none/history", "/dev/full", "/dev/zero", "~none/x"]
)
def test_the_prompt_works_if_the_history_cannot_be_kept(place, monkeypatch, tmp_path):
    monkeypatch.setenv("RADCALC_HISTORY", place)
    monkeypatch.setenv("HOME", str(tmp_path))
    with on_terminal(entry_point(), "prompt") as (process, leader):
        screen = Screen(leader)
        screen.read("exit to quit")
        screen.read(">")
        screen.answer("100 lx fc", "9.2903 fc")
        screen.type("\x04")
        assert process.wait(60) == 0
    assert list(tmp_path.iterdir()) == []


def test_the_answers_of_a_prompt_can_be_kept_in_a_file(tmp_path):
    answers = tmp_path / "answers"
    with (
        answers.open("w") as file,
        on_terminal(entry_point(), "prompt", stdout=file) as (process, leader),
    ):
        screen = Screen(leader)
        screen.read("exit to quit")
        screen.read(">")
        screen.type("100 lx fc\r\x04")
        assert process.wait(60) == 0
    assert answers.read_text() == "9.290304\tfc\n"


@pytest.mark.parametrize("name", ["NO_COLOR", "TERM"])
def test_a_plain_terminal_gets_no_colours(name, monkeypatch):
    monkeypatch.setenv(name, {"NO_COLOR": "1", "TERM": "dumb"}[name])
    with on_terminal(entry_point(), "prompt") as (process, leader):
        screen = Screen(leader)
        screen.read(">")
        screen.answer("800 lm cd --isotropic", "assumed")
        screen.type("\x04")
        assert process.wait(60) == 0
    assert not re.findall(r"\x1b\[(?!0m)[0-9;]+m", screen.raw)


OFFERED = {  # what is typed: a suggestion and its description
    "": ("convert", "Convert between units"),
    "va": ("vars", "The variables"),
    "ex": ("exit", "Leave"),
    "help ca": ("calorimeter", "Radiant flux"),
    "100 lx k": ("klx", "kilolux"),
    "radcalc 100 lx k": ("klx", "kilolux"),
    "ans m": ("mfc", "millifootcandle"),  # for an answer in foot-candles
    "source m": ("mlm", "millilumen"),
    "point-source --flux so": ("source", "800 lm"),
    "point-source --spectrum D6": ("D65", "6503 K"),
    "x = so": ("source", "800 lm"),
    "x = calo": ("calorimeter", "Radiant flux"),
    "x = 100 lx k": ("klx", "kilolux"),
}


@pytest.mark.parametrize("line", OFFERED)
def test_suggestions_have_descriptions(line, capsys):
    session = prompt.Session()
    session.answer("source = 800 lm")
    session.answer("100 lx fc")
    found, typed = prompt.completions(session, line)
    said = {word.text: word.description for word in found}
    word, description = OFFERED[line]
    assert description in said[word]
    assert line.endswith(typed)
    assert len(said) == len(found)


def test_the_results_of_the_last_answer_are_offered():
    session = prompt.Session()
    session.answer("point-source --flux 800lm --distance 2m")
    offered = {word.text for word in prompt.completions(session, "ans.")[0]}
    assert offered == {f"ans.{row.name}" for row in session.rows} >= {"ans.illuminance"}


@pytest.mark.parametrize("line", ["'", "exit ", "100 lx 'k", "x == ", "zork ", "ans.zork "])
def test_any_text_can_be_completed(line):
    assert isinstance(prompt.completions(prompt.Session(), line)[0], list)


def test_a_word_with_blanks_is_completed_in_quotes():
    assert prompt.quoted("Daylight FL") == "'Daylight FL'"
    assert prompt.quoted("cd/m2") == "cd/m2"


def test_a_pipe_does_not_keep_the_history(tmp_path, monkeypatch):
    os.mkfifo(path := tmp_path / "pipe")
    monkeypatch.setenv("RADCALC_HISTORY", str(path))
    assert isinstance(prompt.history(), InMemoryHistory)  # a file would wait for a reader


def test_a_line_that_cannot_be_kept_does_not_stop_the_prompt(tmp_path, monkeypatch):
    monkeypatch.setenv("RADCALC_HISTORY", str(tmp_path / "history"))
    kept = prompt.history()
    (tmp_path / "history").unlink()
    (tmp_path / "history").mkdir()
    kept.append_string("100 lx fc")
    assert kept.get_strings() == ["100 lx fc"]


def test_the_history_is_in_the_platforms_folder(monkeypatch, tmp_path):
    monkeypatch.delenv("RADCALC_HISTORY", raising=False)
    monkeypatch.setenv("XDG_STATE_HOME", "/state")
    assert str(prompt.history_path()) == "/state/radcalc/history"
    monkeypatch.setenv("XDG_STATE_HOME", "relative")  # the specification ignores relative paths
    monkeypatch.setenv("HOME", str(tmp_path))
    assert prompt.history_path() == tmp_path / ".local" / "state" / "radcalc" / "history"
