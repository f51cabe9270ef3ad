import numpy

from radcalc.spectra.colorimetry import load_colour


def test_colour_science_does_not_change_how_arrays_are_printed():
    before = numpy.get_printoptions()
    load_colour()
    assert numpy.get_printoptions() == before
