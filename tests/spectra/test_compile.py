import numpy

from radcalc.spectra.colorimetry import load_colour
from radcalc.spectra.compile import (
    HERE,
    compile_colours,
    compile_observers,
    compile_sources,
)


def test_the_committed_tables_agree_with_colour_science():
    for file, text in (
        ("observers.py", compile_observers()),
        ("sources.py", compile_sources()),
        ("colours.py", compile_colours()),
    ):
        assert (HERE / file).read_text(encoding="utf-8") == text


def test_colour_science_does_not_change_how_arrays_are_printed():
    before = numpy.get_printoptions()
    load_colour()
    assert numpy.get_printoptions() == before
