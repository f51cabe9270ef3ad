"""Progress bars on a terminal."""

import pytest

from radcalc.render import table as module
from radcalc.render.table import progress


@pytest.fixture
def terminal(monkeypatch):
    """A terminal with a clock set by the test: the list has the seconds."""
    now = [100.0]
    monkeypatch.setattr("radcalc.terminal.error_is_terminal", lambda: True)
    monkeypatch.setattr(module.time, "monotonic", lambda: now[0])
    monkeypatch.setenv("FORCE_COLOR", "1")  # makes Rich treat captured output as a terminal
    return now


def test_work_of_a_second_has_no_progress_bar(terminal, capsys):
    with progress("a map") as tick:
        tick(1, 4)
        terminal[0] += 0.9
        tick(3, 4)
    assert capsys.readouterr() == ("", "")


def test_longer_work_has_a_bar_that_is_erased(terminal, capsys):
    with progress("a map") as tick:
        terminal[0] += 1.1
        tick(1, 4)
        terminal[0] += 1.0
        tick(3, 4)
    out, drawn = capsys.readouterr()
    assert out == ""
    assert "a map" in drawn
    assert "75%" in drawn
    assert drawn.endswith("\x1b[2K")  # clears the line


@pytest.mark.parametrize(("choice", "has_color"), [("always", True), ("never", False)])
def test_a_bar_has_the_colours_that_are_chosen(terminal, monkeypatch, capsys, choice, has_color):
    monkeypatch.setattr("radcalc.terminal._chosen", choice)
    monkeypatch.setenv("TERM", "xterm")
    with progress("a map") as tick:
        terminal[0] += 2.0
        tick(1, 4)
    assert ("\x1b[3" in capsys.readouterr().err) == has_color  # SGR 30 to 38: a colour of letters


def test_a_bar_stops_when_the_work_is_interrupted(terminal, capsys):
    def work():
        with progress("a map") as tick:
            terminal[0] += 2.0
            tick(1, 4)
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        work()
    assert capsys.readouterr().err.endswith("\x1b[2K")


@pytest.mark.parametrize(("on_terminal", "is_wanted"), [(False, True), (True, False)])
def test_there_is_no_bar_in_a_pipe_or_if_unwanted(
    terminal, monkeypatch, capsys, on_terminal, is_wanted
):
    monkeypatch.setattr("radcalc.terminal.error_is_terminal", lambda: on_terminal)
    with progress("a map", is_wanted) as tick:
        terminal[0] += 9.0
        tick(1, 4)
    assert capsys.readouterr() == ("", "")
