"""A record repeats a calculation for other floats, to the last bit, or leaves them out."""

import math
from itertools import permutations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from radcalc import maths
from radcalc.streams.traces import MARK, Recording, Trace, Unknown, Untraceable


def recorded(function, value) -> Recording:
    trace = Trace(value)
    return trace.record([function(trace.start)])


def branching(x):
    """Comparisons with numbers, of two steps, of a step with itself; what changes no float."""
    if not x - x == 0 or x > 1e9:
        raise ValueError
    y = abs(x) * 2 + 0.0
    if y > 3:
        y = maths.sqrt(y) ** -2.0 - 1
    return y * 1.0 if y <= x else maths.hypot(x, y) / 3 + 1 / (x - 5)


def clamped(x):
    return max(0.0, min(1.0, 0.25 + x / 3))


def powers(x):
    """A power that nothing depends on, and that is refused beyond what a float holds."""
    unused = x**40.0
    return 2 * x if unused is not None else x


def trigonometric(x):
    return maths.cos(maths.atan2(x, 6.0)) * 250 * maths.hypot(6.0, x) ** -2.0


FUNCTIONS = [branching, clamped, powers, trigonometric]
FLOATS = st.floats(-50, 50) | st.floats(allow_nan=False, allow_infinity=False)


def outcome(function, value):
    try:
        return function(value)
    except (ValueError, ZeroDivisionError, OverflowError):
        return None


@pytest.mark.parametrize("function", FUNCTIONS)
@given(st.floats(-50, 50), st.lists(FLOATS, max_size=30))
def test_a_record_gives_what_the_calculation_gives_or_nothing(function, first, others):
    if outcome(function, first) is None:
        return
    try:
        record = recorded(function, first)
    except Untraceable:
        return
    values = [first, *others]
    places, (results,) = record.run(values)
    places = range(len(values)) if places is None else places
    assert 0 in places
    for place, result in zip(places, results, strict=True):
        own = outcome(function, values[place])
        assert own is not None
        assert (own, math.copysign(1, own)) == (result, math.copysign(1, result))


@pytest.mark.parametrize("function", FUNCTIONS)
def test_a_record_holds_beyond_the_number_it_was_made_of(function):
    values = [7 + k / 1000 for k in range(500)]
    places, (results,) = recorded(function, 7.25).run(values)
    assert places is None
    assert results == [function(value) for value in values]


def test_numbers_at_which_another_way_is_taken_are_left_out():
    found = [branching(10.0), branching(20.0), branching(5.0)]
    assert recorded(branching, 10.0).run([10.0, 1.0, 20.0, 5.0, 1e10]) == ([0, 2, 3], [found])


def test_a_refusal_is_left_out_though_no_result_depends_on_it():
    assert outcome(powers, 1e9) is None
    assert recorded(powers, 2.0).run([2.0, 1e9, 3.0]) == ([0, 2], [[4.0, 6.0]])


def test_many_steps_are_taken_in_parts():
    def long(x):
        for k in range(1000):
            x = x + k / 7
        return x

    values = [float(k) for k in range(1, 500)]
    assert recorded(long, 1.0).run(values) == (None, [list(map(long, values))])


@pytest.mark.parametrize(
    "function",
    [float, int, lambda x: math.sin(x), lambda x: {x: 1}, lambda x: [1, 2][x],
     lambda x: x**0.5 if x > 0 else (x - 9) ** 0.5, lambda x: sum(x / k for k in range(1, 9999))],
    ids=["float", "int", "a function of floats", "a key", "an index", "a complex number",
         "endless"],
)  # fmt: skip
def test_what_a_record_cannot_have_is_refused(function):
    with pytest.raises((Untraceable, TypeError)):
        recorded(function, -1.0)


def test_what_is_caught_on_the_way_leaves_no_record():
    def caught(x):
        try:
            return 1 / (x - 1)
        except ZeroDivisionError:
            return x

    with pytest.raises(Untraceable):
        recorded(caught, 1.0)
    assert recorded(caught, 2.0).run([1.0, 3.0]) == ([1], [[0.5]])


def test_what_is_unknown_may_go_along_but_decides_nothing():
    trace = Trace(2.0)
    off = Unknown(trace) * trace.start + 1
    assert isinstance(maths.sqrt(off), Unknown)
    with pytest.raises(Untraceable):
        bool(off > 0)
    with pytest.raises(Untraceable):
        trace.record([trace.start])


def test_a_text_with_a_number_has_the_mark():
    assert f"{Trace(2.0).start:.3g} m" == f"{MARK} m"


def test_zeros_of_both_signs_and_whole_numbers_are_different_constants():
    def both(x):
        return maths.atan2(x * 0.0, -1.0) - maths.atan2(x * -0.0, -1.0)

    assert recorded(both, 2.0).run([3.0]) == (None, [[both(3.0)]])
    assert both(3.0) == 2 * math.pi


def test_every_elementary_function_is_recorded():
    for function in (
        *(maths.sin, maths.cos, maths.tan, maths.atan, maths.asin, maths.acos, maths.sqrt),
        *(maths.exp, maths.expm1, maths.log, maths.log1p, maths.log2, maths.log10),
    ):
        values = [0.1, 0.5, 0.9]
        assert recorded(function, 0.3).run(values) == (None, [list(map(function, values))])


@pytest.mark.parametrize("order", list(permutations([1e-3, 1.0, 1e3])))
def test_ranges_are_those_of_the_ends_whatever_the_order(order):
    record = recorded(trigonometric, order[0])
    assert record.run(list(order)) == (None, [[trigonometric(x) for x in order]])
