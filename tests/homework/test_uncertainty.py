"""Answers to questions with uncertain values: the value and its ±."""

import pytest
from following import call
from helpers import for_each

FOOT = 0.3048
# 100 lx are 100 * 0.3048^2 = 9.2903 fc, 3 lx 0.2787 fc; 800 lm at 2 m are 200/pi/4 = 15.915 lx;
# with 20 lm and 0.02 m, by JCGM 100:2008, 5.1.6: u/E = sqrt((20/800)^2 + (2 * 0.02/2)^2) = 3.202 %.
CONVERSION = ("convert", "100+-3", "lx", "fc")
LAMP = ("point-source", "--flux", "800+-20lm", "--distance", "2.00+-0.02m")
# 100 cd at 2 m are 25 lx, 400 cd at 1 m are 400 lx: the uncertainty is as large.
EXACT = ("convert", "100", "cd", "lx", "--distance", "2m")
NEARLY = ("convert", "100+-100", *EXACT[2:])
FAR = ("convert", "400+-400", "cd", "lx", "--distance", "1m")


@for_each(
    [
        (CONVERSION, "9.3fc", True, "within 0.28 fc, the standard uncertainty"),
        (CONVERSION, "9.55fc", True, "9.29 ± 0.28 fc"),
        (CONVERSION, "9.6fc", False, "within 0.28 fc"),
        (CONVERSION, "9.29+-0.28fc", True, "right"),
        (CONVERSION, "9.29(28)fc", True, "right"),
        (CONVERSION, "9.3+-0.3fc", True, "right"),
        (CONVERSION, "9.29+-0.35fc", False, "it is 0.28"),
        (CONVERSION, "100+-3lx", True, "100.0 ± 3.0 lx"),
        (CONVERSION, "1076+-32fc", False, "was inverted"),
        (LAMP, "irradiance=15.92+-0.51lx", True, "right"),
        (LAMP, "15.92+-0.72lx", False, "added up"),  # 2.5 % + 2 %
        (LAMP, "15.92+-1.0lx", False, "k = 2"),  # 2 * 3.2 %
        (LAMP, "15.92+-0.43lx", False, "twice that of d"),  # sqrt(2.5^2 + 1^2) %
        (LAMP, "15.92+-0.32lx", False, "only one"),  # 2 %
        # 2 % and 2 * 1 %; without the factor 2, sqrt(2^2 + 1^2) % of 25 lx are 0.56 lx
        ((*EXACT[:1], "100+-2", *EXACT[2:-1], "2.00(2)m"), "25+-0.56lx", False, "it is 0.71 lx"),
        ((*EXACT[:1], "100+-2", *EXACT[2:-1], "2.00(2)m"), "25+-0.56lx", False, "twice that of d"),
        # 10 lg(e) * 2.3/10 = 0.9989
        (("convert", "10.0+-2.3", "mW", "dBm"), "10+-2dBm", False, "it is 1 dBm"),
        (("convert", "(100±3) lx * (2.0±0.1) m2", "lm"), "200+-16lm", False, "added up"),
        (("convert", "(100±3) lx * (2.0±0.1) m2", "lm"), "200+-12lm", True, "200 ± 12 lm"),
        (EXACT, "25.2+-0.1lx", True, "within 1%"),
        (EXACT, "25.6+-0.7lx", True, "within the uncertainty given"),
        (EXACT, "25.6+-0.5lx", False, "within 1%"),
        (EXACT, "50+-100lx", False, "the distance was not squared"),
        (EXACT, "25+-100lx", False, "the right value has no uncertainty"),
        (EXACT, "25+-100lx", False, "not 25 ± 100 lx"),
        (NEARLY, "50+-100lx", False, "it is 25"),
        (NEARLY, "30+-100lx", False, "within 25 lx"),
        (FAR, "450+-500lx", False, "within 400 lx"),
    ],
)
def test_value_and_uncertainty_are_judged(words, claim, is_right, said):
    done = call([*words, "--check", claim])
    assert (done.status == 0) == is_right
    assert done.status in (0, 1)
    assert said in done.output


def test_an_explicit_tolerance_replaces_the_default():
    assert call([*CONVERSION, "--check", "9.5fc", "--tolerance", "1%"]).status == 1
    assert call([*CONVERSION, "--check", "9.3fc", "--tolerance", "1%"]).status == 0


def test_json_has_both_uncertainties():
    import json

    check = json.loads(call([*CONVERSION, "--check", "9.3+-0.3fc", "--json"]).output)["check"]
    assert check["uncertainty"] == pytest.approx(3 * FOOT**2, rel=1e-9)
    assert (check["claimed"], check["claimed_uncertainty"]) == (9.3, 0.3)


# Calls with and without uncertainties have the same diagnoses.
@pytest.mark.parametrize(
    ("words", "inputs", "claim"),
    [
        ("lambertian --luminance {}cd/m2", [("100", "100+-5")], "exitance=628lm/m2"),
        ("lambertian --luminance {}cd/m2", [("100", "100(5)")], "exitance=628+-31lm/m2"),
        ("convert {} cd lx --distance {}m", [("100", "100+-3"), ("2", "2.00(1)")], "50lx"),
        ("point-source --flux {}lm --distance {}m", [("800", "800+-20"), ("2", "2")], "63.7lx"),
        ("etendue --area 1cm2 --half-angle {}deg", [("30", "30.0+-0.5")], "etendue=1.57cm2.sr"),
    ],
)
@pytest.mark.parametrize("steps", [[], ["--steps"]])
def test_mistakes_are_found_if_inputs_are_uncertain(words, inputs, claim, steps):
    exact, uncertain = (words.format(*column).split() for column in zip(*inputs, strict=True))
    said = [call([*one, *steps, "--check", claim]).output for one in (exact, uncertain)]
    likely = [[line for line in text.split("\n") if "    " in line] for text in said]
    assert likely[0]
    assert likely[0][0] == likely[1][0]
