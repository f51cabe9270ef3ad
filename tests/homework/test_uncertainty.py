"""Answers to questions with uncertain values: near enough, and with the right ±."""

import pytest
from following import call

FOOT = 0.3048
# 100 lx are 100 * 0.3048^2 = 9.2903 fc, 3 lx 0.2787 fc; 800 lm at 2 m are 200/pi/4 = 15.915 lx;
# with 20 lm and 0.02 m, by JCGM 100:2008, 5.1.6: u/E = sqrt((20/800)^2 + (2 * 0.02/2)^2) = 3.202 %.
CONVERSION = ("convert", "100+-3", "lx", "fc")
LAMP = ("point-source", "--flux", "800+-20lm", "--distance", "2.00+-0.02m")


@pytest.mark.parametrize(
    ("words", "claim", "is_right", "said"),
    [
        (CONVERSION, "9.3fc", True, "within 0.28 fc, the standard uncertainty"),
        (CONVERSION, "9.55fc", True, "9.29 ± 0.28 fc"),
        (CONVERSION, "9.6fc", False, "within 0.28 fc"),
        (CONVERSION, "9.29+-0.28fc", True, "right"),
        (CONVERSION, "9.29(28)fc", True, "right"),
        (CONVERSION, "9.3+-0.3fc", True, "right"),
        (CONVERSION, "9.29+-0.35fc", False, "it is 0.28"),
        (CONVERSION, "100+-3lx", True, "100.0 ± 3.0 lx"),
        (CONVERSION, "1076+-32fc", False, "upside down"),
        (LAMP, "irradiance=15.92+-0.51lx", True, "right"),
        (LAMP, "15.92+-0.72lx", False, "added up"),  # 2.5 % + 2 %
        (LAMP, "15.92+-1.0lx", False, "k = 2"),  # 2 * 3.2 %
        (LAMP, "15.92+-0.43lx", False, "twice the part of d"),  # sqrt(2.5^2 + 1^2) %
        (LAMP, "15.92+-0.32lx", False, "only one"),  # 2 %
        (("convert", "25.0", "lx", "lx"), "25.6+-0.7lx", True, "the uncertainty claimed"),
    ],
)
def test_value_and_uncertainty_are_judged(words, claim, is_right, said):
    done = call([*words, "--check", claim])
    assert (done.status == 0) == is_right
    assert done.status in (0, 1)
    assert said in done.output


def test_a_tolerance_that_is_asked_for_counts():
    assert call([*CONVERSION, "--check", "9.5fc", "--tolerance", "1%"]).status == 1
    assert call([*CONVERSION, "--check", "9.3fc", "--tolerance", "1%"]).status == 0


def test_json_has_both_uncertainties():
    import json

    check = json.loads(call([*CONVERSION, "--check", "9.3+-0.3fc", "--json"]).output)["check"]
    assert check["uncertainty"] == pytest.approx(3 * FOOT**2, rel=1e-9)
    assert (check["claimed"], check["claimed_uncertainty"]) == (9.3, 0.3)
