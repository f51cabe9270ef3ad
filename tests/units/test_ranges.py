"""Lists and ranges are split into their values, and are distinguished from single numbers."""

import pytest

from radcalc.conversion.operands import read_lists
from radcalc.errors import ConditionError, RadcalcError, TooMany
from radcalc.units.ranges import MOST, note_of, read_series, read_values, refuse_many

LISTS = {
    "1m,2m": ["1m", "2m"],
    "1,2,5": ["1", "2", "5"],
    "1.5,2.5": ["1.5", "2.5"],
    "1.5,2": ["1.5", "2"],
    "0.001,1000": ["0.001", "1000"],
    "-30,-10": ["-30", "-10"],
    "1e3,5": ["1e3", "5"],
    "1/3,2": ["1/3", "2"],
    "100,200,400": ["100", "200", "400"],
    "4pi,2pi": ["4pi", "2pi"],
    "1:3:1": ["1", "2", "3"],
    "3m:1m:-1m": ["3m", "2m", "1m"],
}
# Texts that may be one number, with a decimal comma or groups of thousands.
NUMBERS = (
    "1,5",
    "1,000",
    "12,500",
    "1,500",
    "100,000",
    "100,200",
    "50,100",
    "100,050",
    "1,234,567",
    "100,200.5",
    "0,5",
    "-1,5",
    "1,5e3",
    "1.000,5",
    "7000,9000",
)


@pytest.mark.parametrize("text", LISTS)
def test_a_list_is_split_into_its_values(text):
    assert read_series(text) == LISTS[text]
    assert read_values(text) == LISTS[text]


@pytest.mark.parametrize("text", NUMBERS)
def test_a_text_that_may_be_one_number_is_not_a_list(text):
    assert read_series(text) == [text]
    assert read_values(f"{text} lx") == [f"{text} lx"]


def test_a_list_that_may_be_one_number_is_noted():
    note = "100,200,400 is read as 3 values, not as 100200400"
    assert note_of("100,200,400 lx") == (note,)
    assert note_of("100,200,400lx") == note_of("100,200,400")
    for text in LISTS:
        assert bool(note_of(text)) == text.startswith("100")


def test_a_unit_at_the_end_applies_to_all_values():
    assert read_values("1,2,5 lx") == ["1 lx", "2 lx", "5 lx"]
    assert read_values("1:3:1m") == ["1m", "2m", "3m"]
    assert read_values("1e3,2e3 W/m2") == ["1e3 W/m2", "2e3 W/m2"]
    assert read_values("1lx,2 fc") == ["1lx", "2 fc"]
    with pytest.raises(ConditionError, match="with a unit and without"):
        read_values("1lx,2,3")


def test_a_unit_at_the_end_applies_to_uncertain_values_too():
    assert read_values("100±3,200±6 lx") == ["100±3 lx", "200±6 lx"]
    assert read_values("100±3%, 200±6% lx") == ["100±3% lx", "200±6% lx"]
    assert read_values("100(3),200(6) lx") == ["100(3) lx", "200(6) lx"]
    assert read_values("100±3,200 lx") == ["100±3 lx", "200 lx"]
    assert read_values("100+-3lx,200lx") == ["100+-3lx", "200lx"]
    assert read_values("100lx,200+-3lx") == ["100lx", "200+-3lx"]
    for text in ("10±1,20±1%", "10±1,20±1 %"):
        with pytest.raises(ConditionError, match="is ambiguous") as caught:
            read_values(text)
        assert caught.value.hint == "(10±1)%,(20±1)%"


def test_a_comma_before_a_unit_leads_to_the_list():
    for words, hint in (
        (["1,2,", "lx", "fc"], "1lx,2lx"),
        (["1lx,", "2lx", "fc"], "1lx,2lx"),
        (["1lx,", "fc"], "1lx"),
        (["100", "lx", "fc,", "klx"], "fc,klx"),
    ):
        with pytest.raises(ConditionError, match="blank") as caught:
            read_lists(words)
        assert caught.value.hint == hint


@pytest.mark.parametrize(
    ("words", "values", "targets"),
    [
        (["100", "lx", "fc"], ["100"], ["fc"]),
        (["1,2,5", "lx", "fc,klx"], ["1", "2", "5"], ["fc", "klx"]),
        (["1lx,2lx", "fc"], ["1lx", "2lx"], ["fc"]),
        (["1,2,5 lx to fc, klx"], ["1 lx", "2 lx", "5 lx"], ["fc", "klx"]),
        (["1:3:1", "W", "m-2", "to", "mW", "cm-2"], [f"{k} W m-2" for k in (1, 2, 3)], ["mW cm-2"]),
        (["1in,2in", "in", "cm"], ["1in", "2in"], ["cm"]),
    ],
)
def test_the_words_of_a_conversion_are_split_into_single_conversions(words, values, targets):
    calls = read_lists(words)
    assert [call[0] for call, *_ in calls] == values
    assert [call[-1] for call in calls[0]] == targets
    assert all(len(each) == len(targets) for each in calls)


LIKE_LISTS = {  # words of a value with a comma, and the list offered in its hint
    ("10,20", "dBm", "mW"): "10dBm,20dBm",
    ("7000,9000 lm", "klm"): "7000lm,9000lm",
    ("1,5", "W", "m-2", "to", "W/m2"): "1W.m-2,5W.m-2",
    ("1,5lx", "fc"): "1lx,5lx",
}


@pytest.mark.parametrize("words", LIKE_LISTS)
def test_a_value_that_may_be_a_list_is_refused_with_that_list(words):
    with pytest.raises(RadcalcError, match="comma in its number") as caught:
        read_lists(list(words))
    listed = LIKE_LISTS[words]
    assert caught.value.hint.endswith(f" or {listed}, a list")
    assert len(read_values(listed)) == 2


def test_groups_of_thousands_are_not_offered_as_a_list():
    with pytest.raises(RadcalcError) as caught:
        read_lists(["1,000", "lx", "fc"])
    assert caught.value.hint == "1000 lx or 1.000 lx"


def test_a_target_is_missing_between_commas():
    for text in ("fc,", ",fc", "fc,,klx"):
        with pytest.raises(RadcalcError, match="a unit is missing"):
            read_lists(["100", "lx", text])


def test_the_number_of_answers_is_bounded():
    refuse_many([MOST // 4, 2, 2])
    with pytest.raises(TooMany, match="5000 x 2 x 2 = 20000"):
        refuse_many([MOST // 2, 2, 2])
