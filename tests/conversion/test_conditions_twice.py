"""Conditions of a conversion that say one thing twice: compared, to the digits typed."""

import math

import pytest

from radcalc import ConditionError, convert, point_source

AGREEING = [
    # a circle: pi R^2; the solid angle of a cone: 2 pi (1 - cos(alpha)), of a lobe: 2 pi / (n + 1)
    ("lm", "lx", {"radius": "1 m", "area": "3.14 m2"}, 1 / math.pi),
    ("lm", "lx", {"area": "3.14 m2", "diameter": "2 m"}, 1 / math.pi),
    ("lm", "cd", {"half_angle": "60 deg", "apex_angle": "120 deg"}, 1 / math.pi),
    ("lm", "cd", {"solid_angle": "3.1416 sr", "half_angle": "60 deg"}, 1 / math.pi),
    ("lm", "cd", {"isotropic": True, "solid_angle": "12.566 sr"}, 1 / (4 * math.pi)),
    ("lm", "cd", {"exponent": 1, "beam_angle": "120 deg"}, 1 / math.pi),
    ("cd", "lx", {"distance": "2 m", "area": "4 m2", "solid_angle": "1 sr"}, 1 / 4),
    ("lx", "cd", {"distance": "2 m", "area": "4 m2", "solid_angle": "1 sr"}, 4),
    ("lx", "cd/m2", {"reflectance": 1, "hemisphere": True}, 1 / math.pi),
    # Km of the CIE at 555 nm; its note 683.002 lm/W
    ("W", "lm", {"wavelength": "555 nm", "efficacy": "683 lm/W"}, 683.002),
]
APART = [
    ("lm", "lx", {"radius": "1 m", "area": "3.30 m2"}),
    ("lm", "cd", {"solid_angle": "3.20 sr", "half_angle": "60.0 deg"}),
    ("lm", "cd", {"isotropic": True, "hemisphere": True}),
    ("lm", "cd", {"exponent": 1, "beam_angle": "110 deg"}),
    ("cd", "lx", {"distance": "2.00 m", "area": "5 m2", "solid_angle": "1.00 sr"}),
    ("W", "lm", {"efficacy": "680 lm/W", "wavelength": "555 nm"}),
]


@pytest.mark.parametrize(("source", "target", "conditions", "factor"), AGREEING)
def test_agreeing_conditions_are_answered(source, target, conditions, factor):
    answer = convert(f"1 {source}", target, **conditions)
    assert answer.magnitude == pytest.approx(factor, rel=1e-6)
    turned = dict(reversed(conditions.items()))
    assert convert(f"1 {source}", target, **turned).magnitude == answer.magnitude


@pytest.mark.parametrize(("source", "target", "conditions"), APART)
def test_conditions_that_differ_are_refused_with_both_values(source, target, conditions):
    with pytest.raises(ConditionError, match=r"contradicts? .*: \S.* is not \d"):
        convert(f"1 {source}", target, **conditions)


def test_a_ratio_of_two_kinds_is_compared_with_their_link():
    """Km of the CIE is 683.002 lm/W at 555 nm."""
    found = point_source(flux="683 lm", radiant_flux="1 W", wavelength="555 nm")
    assert found["luminous_efficacy"].to("lm/W").magnitude == pytest.approx(683.002)
    with pytest.raises(ConditionError, match=r"600 lm/W is not 683\.002 lm/W"):
        point_source(flux="600 lm", radiant_flux="1 W", wavelength="555 nm")
