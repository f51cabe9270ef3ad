"""Pictures of colour: where points are, against CIE 15, and what is drawn for which result."""

import math
import subprocess
import sys

import pytest

from radcalc.errors import ConditionError, UsageError
from radcalc.plots import figure
from radcalc.plots.curves import chromaticities, diagram, vectors
from radcalc.spectra.sources import spectrum


def marks(picture):
    return {mark.label: (mark.x, mark.y) for mark in picture.marks}


def test_lights_and_wavelengths_are_at_their_chromaticities():
    found = marks(chromaticities([spectrum("A"), spectrum("D65")]))
    # CIE 15: A and D65; the spectrum locus at 520 nm and 600 nm
    assert found["A"] == pytest.approx((0.44758, 0.40745), abs=3e-5)
    assert found["D65"] == pytest.approx((0.31272, 0.32903), abs=1e-5)
    assert found["520"] == pytest.approx((0.0743, 0.8338), abs=1e-4)
    assert found["600"] == pytest.approx((0.6270, 0.3725), abs=1e-4)


def test_the_outline_is_closed_and_black_bodies_are_inside():
    outline, bodies = chromaticities([spectrum("A")]).series
    assert (outline.x[0], outline.y[0]) == (outline.x[-1], outline.y[-1])
    # Wyszecki and Stiles, Color Science: 1000 K at (0.6528, 0.3444), 10 000 K at (0.2807, 0.2884)
    assert (bodies.x[0], bodies.y[0]) == pytest.approx((0.6528, 0.3444), abs=3e-4)


def test_vectors_are_relative_to_a_circle():
    picture = vectors(spectrum("FL2"))
    circle, lit = picture.series
    assert [math.hypot(*p) for p in zip(circle.x, circle.y, strict=True)] == pytest.approx([1] * 73)
    # the chroma shift of bin 1 is -25 % in the IES's spreadsheet
    assert math.hypot(lit.x[0], lit.y[0]) == pytest.approx(0.75, abs=0.02)
    assert (lit.x[0], lit.y[0]) == (lit.x[-1], lit.y[-1])
    assert "Rf 70, Rg 86" in picture.title


@pytest.mark.parametrize(
    ("wanted", "has"),
    [(["rf"], "Rf 70"), (["x", "rcs-h3"], "Rf 70"), (["x"], ""), (["srgb-red"], "")],
)
def test_the_requested_result_decides_on_the_picture(wanted, has):
    assert has in diagram([spectrum("FL2")], wanted).title


@pytest.mark.parametrize("wanted", [[], ["cct"], ["luminous-efficacy"]])
def test_other_results_have_the_curve_of_the_spectrum(wanted):
    assert diagram([spectrum("FL2")], wanted) is None


def test_impossible_pictures_are_refused():
    with pytest.raises(UsageError, match="one spectrum"):
        diagram([spectrum("FL2"), spectrum("A")], ["rf"])
    with pytest.raises(ConditionError, match="no colour vectors of line:532nm"):
        vectors(spectrum("line:532nm"))
    with pytest.raises(ConditionError, match="invisible"):
        chromaticities([spectrum("line:1064nm")])


def test_figures_are_drawn_with_the_colours_of_colour_science():
    for wanted in ("rf", "x"):
        (axes,) = figure.figure(diagram([spectrum("FL2")], [wanted])).axes
        assert axes.images


def test_an_arrow_leads_from_the_reference_to_the_light():
    picture = vectors(spectrum("FL2"))
    # local hue shifts of the IES's spreadsheet: 0.24 in bin 3, -0.26 in bin 15
    for k, turn in ((3, 0.24), (15, -0.26)):
        start, end = picture.arrows[k - 1]
        assert math.hypot(*start) == pytest.approx(1)
        away = math.pi * (2 * k - 1) / 16
        across = (end[1] - start[1]) * math.cos(away) - (end[0] - start[0]) * math.sin(away)
        assert across == pytest.approx(turn, abs=0.01)


def test_figures_need_no_package_beyond_those_of_plots():
    """OpenImageIO reads pictures for colour-science, and is not among them."""
    code = (
        "import sys; sys.modules['OpenImageIO'] = sys.modules['imageio'] = None; "
        "from radcalc.plots import curves, figure; from radcalc.spectra.sources import spectrum; "
        "print(len(figure.data(curves.vectors(spectrum('FL2')), '.png')) > 10000)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.stdout == "True\n", done.stderr
