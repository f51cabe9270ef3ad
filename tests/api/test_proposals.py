"""Calls that hints in Python propose: each can be pasted, and has the result below it."""

import re

import pytest
from helpers import for_each
from test_refusals import CONVERSIONS

import radcalc
from radcalc.api.arguments import keyword

CALL = re.compile(
    r"(radcalc\..*\))\n     (?:\S+ )?(-?[\d.]+(?:e[+-]?\d+)?)(?=[ ,]|$)", re.MULTILINE
)


def calls_of(function, *operands, **keywords):
    """Return the calls of a refusal's hint, each with the first number below it."""
    with pytest.raises(radcalc.RadcalcError) as caught:
        function(*operands, **keywords)
    return CALL.findall(caught.value.hint)


def first_number(call):
    """Return the first number that a pasted call returns."""
    found = eval(call, {"radcalc": radcalc})
    if isinstance(found, radcalc.Result):
        found = next(row.value for row in found.rows if not row.given)
    return getattr(found, "magnitude", found)


def test_a_call_in_a_hint_can_be_pasted_and_has_the_number_below_it():
    followed = 0
    for source, target, conditions, _, _ in CONVERSIONS.values():
        keywords = {keyword(name): text for name, text in conditions.items()}
        for call, number in calls_of(radcalc.convert, f"1 {source}", target, **keywords):
            assert first_number(call) == pytest.approx(float(number), rel=1e-5), call
            followed += 1
    assert followed > 60


@for_each(
    [
        ("point_source", {"flux": "800 lm", "height": "6"}),
        ("point_source", {"intensity": radcalc.Quantity(5, "cd"), "distance": "2"}),
        ("lambertian", {"luminance": "100 cd/m2", "tilt": "30 deg"}),
        ("ev", {"time": "125", "f_number": 8}),
    ]
)
def test_a_call_of_a_calculator_can_be_pasted(name, keywords):
    calls = calls_of(getattr(radcalc, name), **keywords)
    assert calls
    for call, number in calls:
        assert first_number(call) == pytest.approx(float(number), rel=1e-5), call
