"""Elementary functions: cases that the tests of the laws do not cover."""

import math

from radcalc.maths import limit


def test_a_limit_is_found_to_its_last_digit_from_either_side():
    half = math.nextafter(math.pi / 2, 2)  # the first float whose cosine is negative
    assert math.cos(half) < 0 < math.cos(math.pi / 2)
    assert limit(lambda x: math.cos(x) < 0, 0.0, 3.0) == half
    assert limit(lambda x: math.cos(x) > 0, 3.0, 0.0) == math.pi / 2


def test_a_limit_next_to_zero_takes_a_bounded_number_of_steps():
    tried = []
    assert 0 < limit(lambda x: not tried.append(x), 0.0, 1.0) < 1e-60
    assert len(tried) == 200
