"""Named tuples made without compiling behave like those of the standard library."""

import copy
import pickle
from typing import NamedTuple as Standard

import pytest

from radcalc.tuples import NamedTuple


class Ours(NamedTuple):
    first: int
    second: str = "default"

    def doubled(self) -> int:
        return 2 * self.first


class Theirs(Standard):
    first: int
    second: str = "default"


CALLS = [((1,), {}), ((1, "x"), {}), ((), {"second": "x", "first": 1}), ((1,), {"second": "x"})]
BAD_CALLS = [((), {}), ((1, 2, 3), {}), ((1,), {"first": 2}), ((1,), {"a": 2}), ((1,), {"u": 2})]


@pytest.mark.parametrize(("args", "kwargs"), CALLS)
def test_equal_calls_make_equal_tuples(args, kwargs):
    ours, theirs = Ours(*args, **kwargs), Theirs(*args, **kwargs)
    assert ours == theirs
    assert hash(ours) == hash(theirs)
    assert (ours.first, ours.second) == (theirs.first, theirs.second)
    assert repr(ours) == repr(theirs).replace("Theirs", "Ours")
    assert ours._asdict() == theirs._asdict()
    assert ours._replace(first=7) == theirs._replace(first=7)
    assert ours.doubled() == 2 * theirs.first
    for copied in (pickle.loads(pickle.dumps(ours)), copy.copy(ours), copy.deepcopy(ours)):
        assert type(copied) is Ours
        assert copied == ours


@pytest.mark.parametrize(("args", "kwargs"), BAD_CALLS)
def test_calls_with_other_fields_are_refused(args, kwargs):
    for kind in (Ours, Theirs):
        with pytest.raises(TypeError):
            kind(*args, **kwargs)


def test_an_unknown_field_cannot_be_replaced_or_set():
    with pytest.raises(TypeError, match="third"):
        Ours(1)._replace(third=3)
    with pytest.raises(AttributeError):
        Ours(1).first = 2  # type: ignore[misc]


def test_fields_match_patterns():
    match Ours(1):
        case Ours(first, second):
            assert (first, second) == (1, "default")
