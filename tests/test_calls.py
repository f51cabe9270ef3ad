"""The number of function calls of an answer; unlike a time, it does not depend on the load."""

import pytest
from bench.calls import CASES, calls


@pytest.mark.parametrize(("words", "most"), CASES)
def test_an_answer_takes_few_calls(words, most):
    found = calls(words)
    assert 20 < sum(found.values()) <= most, found.most_common()
    assert "units/__init__.py" in found
