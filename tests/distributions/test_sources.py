"""Distributions as a user gives them."""

import math
from pathlib import Path

import pytest

from radcalc.distributions.sources import Lobe, photometry
from radcalc.errors import ConditionError, RadcalcError


@pytest.mark.parametrize(
    ("text", "kind", "on_axis"),
    [
        ("300*max(cos(theta), 0)^4 cd", "v", 300.0),
        ("300 cd", "v", 300.0),
        ("2*max(cos(theta), 0) kcd", "v", 2000.0),
        ("max(cos(theta), 0)", "", 1.0),
        ("100 * max(cos(theta), 0)", "", 100.0),
        ("1/(4*pi) W/sr", "e", 1 / (4 * math.pi)),
        ("z^2 mW / sr", "e", 1e-3),
        ("1 umol s-1 sr-1", "p", 6.02214076e17),  # photons: the mole of SI
        ("theta lm/sr", "v", 0.0),
    ],
)
def test_an_expression_may_have_a_unit(text, kind, on_axis):
    found = photometry(text).distribution
    assert found.kind == kind
    assert found.intensity(0.0, 0.0) == pytest.approx(on_axis, rel=1e-15)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("100 cos(theta)", "not an expression"),
        ("cos(theta) lm", "'lm' after the expression is luminous flux (lm), not an intensity"),
        ("cos(theta) foo", "unknown unit 'foo'"),
        ("lobee", "unknown distribution 'lobee' (and no such file)"),
        ("lamp.ies", "cannot read 'lamp.ies': no such file"),
        ("./lamp", "cannot read './lamp': no such file"),
        (Path("lamp"), "cannot read 'lamp': no such file"),
        ("", "not a distribution"),
        (5.0, "not a distribution"),
    ],
)
def test_texts_that_are_neither_files_nor_expressions_are_refused(text, said):
    with pytest.raises(RadcalcError) as refused:
        photometry(text)
    assert said in refused.value.message
    assert refused.value.hint


def test_a_similar_name_of_a_distribution_is_suggested():
    with pytest.raises(ConditionError) as refused:
        photometry("lobee")
    assert refused.value.hint.startswith("lobe")


def test_a_distribution_is_returned_unchanged():
    lobe = Lobe(3.0)
    assert photometry(lobe).distribution is lobe
    assert photometry(photometry(lobe)).distribution is lobe
