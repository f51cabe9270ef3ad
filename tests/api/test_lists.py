"""Typical values and tasks as data."""

import pytest

import radcalc
from radcalc.errors import UsageError


def test_a_typical_value_has_its_ends_as_quantities():
    """EN 12464-1 gives 500 lx for an office desk; an EV is a reading on a scale."""
    desk, *_, photo = radcalc.typical("office")
    assert desk.low == desk.high == radcalc.Quantity(500, "lx")
    assert (desk.quantity, desk.source) == ("illuminance", "EN 12464-1:2011")
    assert (photo.low, photo.high, photo.unit) == (8.0, 8.0, "EV")
    first = repr(radcalc.typical("office")).splitlines()[0]
    assert first == "office desk, reading and writing: illuminance 500 lx (EN 12464-1:2011)"


def test_a_value_is_looked_up_by_a_text_or_as_a_quantity():
    assert radcalc.typical(radcalc.Quantity(500, "lx")) == radcalc.typical("500 lx")
    assert "by a factor of" in radcalc.typical("5e9 lx").notes[0]
    assert len(radcalc.typical()) > len(radcalc.typical("lx"))


def test_the_tasks_are_those_of_the_command():
    (task,) = radcalc.examples("museum log")
    assert task.calls[-1].command.startswith("radcalc dose examples/gallery.csv")
    assert str(task).startswith("Museum and safety: A log\n")


@pytest.mark.parametrize(
    ("call", "hint"),
    [
        (lambda: radcalc.typical("ofice"), 'radcalc.typical("office")'),
        (lambda: radcalc.examples("musem"), 'radcalc.examples("museum")'),
        (lambda: radcalc.typical("zzzz"), "radcalc.typical()"),
    ],
)
def test_a_search_that_finds_nothing_is_refused_with_a_call(call, hint):
    with pytest.raises(UsageError) as caught:
        call()
    assert caught.value.hint.startswith(hint)
