"""Checking of answers in Python."""

import pytest

import radcalc

CONE = radcalc.solid_angle("cone", half_angle="30 deg")  # 2 pi (1 - cos 30 deg) = 0.84179 sr


def test_a_right_answer_is_true_and_a_wrong_one_false():
    assert radcalc.check(CONE, "0.842 sr")
    wrong = radcalc.check(CONE, "3.14 sr")
    assert not wrong
    assert wrong.value == pytest.approx(0.841787)
    assert wrong.right is False  # both are in the schema of --json
    assert radcalc.check(CONE, "0.842 sr").right is True
    assert wrong.ratio == pytest.approx(3.14 / 0.841787)
    assert repr(wrong).startswith(
        "wrong (within 1%): solid-angle is 0.841787214477 sr, not 3.14 sr"
    )


def test_a_mistake_is_named_with_python_keywords():
    """E = 500 lx of a diffuser of 0.8 is 500 * 0.8 / pi = 127.3 cd/m2, and 400 without the pi."""
    said = radcalc.check(radcalc.explain("500 lx", "cd/m2", reflectance=0.8), "400")
    assert [one.done for one in said.diagnoses] == ["pi was forgotten"]
    assert "--" not in repr(said)
    far = radcalc.check(
        radcalc.point_source(intensity="100 cd", distance="2 m"), "irradiance=50 lx"
    )
    assert not far
    assert far.diagnoses


@pytest.mark.parametrize("name", ["solid-angle", "solid_angle"])
def test_a_claim_names_the_result_with_hyphens_or_underscores(name):
    assert radcalc.check(CONE, f"{name} = 0.842 sr")
    assert not radcalc.check(CONE, f"{name}=0.9 sr")


def test_an_answer_is_checked_at_one_point_but_not_at_several():
    """100 cd give 100/4 lx at 2 m."""
    assert radcalc.check(radcalc.uberlight((0, 0, 2), intensity="100 cd"), "irradiance=25 lx")
    with pytest.raises(radcalc.ConditionError, match="takes one answer, but there are several"):
        radcalc.check(radcalc.uberlight([(0, 0, 2), (0, 0, 3)], intensity="100 cd"), "25 lx")


def test_a_refusal_has_the_keywords_of_the_function():
    lamp = radcalc.point_source(intensity="100 cd", distance="2 m")
    with pytest.raises(radcalc.RadcalcError) as caught:
        radcalc.check(lamp, "16")
    assert "check=" not in str(caught.value)
    assert "claim=" in str(caught.value)


def test_a_tolerance_is_relative_absolute_or_in_digits():
    assert radcalc.check(CONE, "0.9 sr", tolerance="10%")
    assert not radcalc.check(CONE, "0.85 sr", "0.001 sr")
    assert radcalc.check(CONE, "0.842 sr", "3sf")
    assert radcalc.check(CONE, radcalc.Quantity(0.9, "sr"), 0.1)
    assert not radcalc.check(CONE, "0.85 sr", radcalc.Quantity(0.001, "sr"))


@pytest.mark.parametrize(
    ("ask", "said"),
    [
        (lambda: radcalc.check(CONE, "zork"), "zork"),
        (lambda: radcalc.check(CONE, "luminance=3 cd/m2"), "unknown result 'luminance'"),
        (lambda: radcalc.check(5, "3 sr"), "not a result to check"),
        (
            lambda: radcalc.check(
                radcalc.point_source(flux="1 lm", distance=["1 m", "2 m"]), "3 lx"
            ),
            "takes one answer, but there are several",
        ),
    ],
)
def test_an_answer_that_cannot_be_checked_is_refused(ask, said):
    with pytest.raises(radcalc.RadcalcError, match=said) as caught:
        ask()
    assert caught.value.hint
