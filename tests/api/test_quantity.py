"""Units of a quantity: Pint converts them, and radcalc refuses another quantity."""

import pickle

import numpy
import pint
import pytest
from conftest import python
from helpers import for_each

import radcalc
from radcalc.errors import ConversionError, RadcalcError

Q = radcalc.Quantity

# a matte surface: 500 lx * 0.5 / pi sr; a photon: E = h c / lambda; 5 W is 10 lg(5000) dBm;
# I = E d^2
OTHERS = [
    ("500 lx", "cd/m2", 'radcalc.convert("500 lx", "cd/m2", reflectance="0.5")\n     79.5775 '),
    ("500 lx", "luminance", '("500 lx", "luminance", reflectance="0.5")\n     79.5775 '),
    ("532 nm", "eV", 'radcalc.convert("532 nm", "eV")\n     2.33053 eV'),
    ("500 umol/m2/s", "ppfd", 'radcalc.convert("500 umol m^-2 s^-1", "ppfd")\n     500 umol'),
    ("5 W", "dBm", 'radcalc.convert("5 W", "dBm")\n     36.9897'),
    ("500 lx", "ppfd", 'radcalc.convert("500 lx", "ppfd", spectrum="sun")'),
    ("5 lx", Q("1 cd").units, 'radcalc.convert("5 lx", "cd", distance="2 m")\n     20 cd'),
    ("5 lx", Q("1 cd"), 'radcalc.convert("5 lx", "cd", distance="2 m")\n     20 cd'),
]


@for_each(OTHERS)
def test_another_quantity_is_refused_with_the_conversion(text, target, call):
    for method in ("to", "ito", "m_as"):
        with pytest.raises(RadcalcError) as caught:
            getattr(Q(text), method)(target)
        assert call in caught.value.hint, method
        assert "Pint" not in str(caught.value)


@for_each([Q([1.0, 2.0], "lx"), Q("5 lx").plus_minus(1), Q("5+-1 lx")])
def test_values_that_a_hint_cannot_show_are_refused_too(quantity):
    with pytest.raises(ConversionError, match="a distance is missing"):
        quantity.to("cd")


def test_the_error_is_one_of_pint_too():
    """Functions of Pint catch it: no illuminance is among lengths."""
    with pytest.raises(pint.DimensionalityError) as caught:
        Q("1 lx").to("m")
    copy = pickle.loads(pickle.dumps(caught.value))
    assert str(copy) == str(caught.value)
    assert isinstance(copy, RadcalcError)
    assert hash(copy) != hash(caught.value)
    assert copy != caught.value
    assert not numpy.isin(Q([1, 2], "lx"), Q([1, 2], "m")).any()
    assert Q("1 lx") != Q("1 m")


def test_units_of_one_quantity_are_converted_by_pint():
    assert Q("500 lx").to("klx").magnitude == 0.5
    assert Q("1 ft").m_as("in") == pytest.approx(12, rel=1e-15)
    lux = Q([1.0, 2.0], "klx")
    lux.ito("lx")
    assert lux.magnitude.tolist() == [1000, 2000]


def test_a_text_that_is_not_a_unit_is_unknown():
    with pytest.raises(radcalc.UnitError, match="unknown unit 'zork'"):
        Q("1 lx").to("zork")


def test_a_quantity_that_was_kept_refuses_in_the_same_words():
    kept = pickle.dumps(Q("500 lx"))
    program = (
        f"import pickle\ntry: pickle.loads({kept!r}).to('cd')\nexcept Exception as e: print(e)"
    )
    assert "a distance is missing" in python(program).stdout
