"""IES LM-63 files: exact fluxes, directions, editions, bad files."""

import math
import re

import numpy
import pytest
from distributions.lm63 import DEGREE, plain_flux, steps, written
from helpers import for_each

from radcalc.distributions import ies
from radcalc.errors import ConditionError


def opened(*args, **options):
    return ies.read(written(*args, **options), "lamp.ies")


def flux(photometry):
    return photometry.distribution.flux().value


# Whole spheres and parts of them -----------------------------------------------------------------


@pytest.mark.parametrize(
    ("planes", "step"),
    [
        ((0, 0), 1), ((0, 90), 15), ((0, 90), 90), ((0, 180), 10), ((0, 180), 180),
        ((90, 270), 30), ((0, 360), 45), ((0, 345), 15), ((0, 270), 90), ((-180, 180), 20),
    ],
)  # fmt: skip
@pytest.mark.parametrize(("polar", "sphere"), [((0, 180), 4), ((0, 90), 2), ((90, 180), 2)])
def test_spheres_of_type_c(planes, step, polar, sphere):
    found = opened(7, steps(*polar, 5), steps(*planes, step))
    assert flux(found) == pytest.approx(sphere * math.pi * 7, rel=1e-13)
    assert found.distribution.kind == "v"
    assert found.distribution.is_axial == (planes == (0, 0))
    inside, outside = numpy.radians([polar[0] + 3, polar[1] - 3]), math.radians(polar[0] - 3)
    phi = numpy.linspace(-1, 7, 50)[:, None]
    assert numpy.all(found.distribution.intensity(inside, phi) == pytest.approx(7, rel=1e-14))
    if polar[0]:
        assert found.distribution.intensity(outside, 1.0) == 0


@pytest.mark.parametrize("system", "AB")
@pytest.mark.parametrize(
    ("horizontal", "vertical", "sphere"),
    [
        ((-90, 90), (-90, 90), 2), ((0, 90), (-90, 90), 2), ((-90, 90), (0, 90), 1),
        ((0, 90), (0, 90), 1),
    ],
)  # fmt: skip
def test_parts_of_spheres_of_types_a_and_b(system, horizontal, vertical, sphere):
    found = opened(7, steps(*vertical, 15), steps(*horizontal, 10), system)
    assert flux(found) == pytest.approx(sphere * math.pi * 7, rel=1e-13)


def test_whole_spheres_of_types_a_and_b():
    whole, half, quarter = steps(-180, 180, 15), steps(0, 180, 15), steps(-90, 90, 15)
    for found in (
        opened(7, quarter, whole, "A"),
        opened(7, quarter, half, "A"),
        opened(7, whole, quarter, "B"),
    ):
        assert flux(found) == pytest.approx(4 * math.pi * 7, rel=1e-13)
        assert not any("no light" in text for text in found.assumptions)


@pytest.mark.parametrize("step", [1, 5, 10])
@pytest.mark.parametrize("power", [1, 3, 20])
@pytest.mark.parametrize("system", "ABC")
def test_lobes(system, power, step):
    """The flux of cos^n is 2 pi / (n + 1): about the axis in types B and C, across it in A."""
    if system == "C":
        found = opened(lambda v, h: math.cos(v * DEGREE) ** power, steps(0, 90, step), [0])
    else:
        both = steps(-90, 90, step)
        found = opened(
            lambda v, h: (math.cos(v * DEGREE) * math.cos(h * DEGREE)) ** power, both, both, system
        )
    true, answer = 2 * math.pi / (power + 1), found.distribution.flux()
    assert abs(answer.value - true) <= answer.error
    assert answer.error < 0.1 * true
    peak = found.distribution.peak()
    assert peak.value == pytest.approx(1)
    assert peak.polar == pytest.approx(math.pi / 2 if system == "A" else 0, abs=1e-9)


def test_a_laboratory_table():
    """300 290 260 200 110 30 0 cd every 15 degrees are 791.3485 lm."""
    table = dict(zip(steps(0, 90, 15), [300, 290, 260, 200, 110, 30, 0], strict=True))
    for planes in ([0], [0, 45, 90], [90, 270], [0, 120, 240]):
        assert flux(opened(lambda v, h: table[v], list(table), planes)) == pytest.approx(
            791.3485, abs=5e-5
        )


# Directions --------------------------------------------------------------------------------------

# LM-63-2002, section 3: photometric zero (nadir) is at V = H = 0 of type B and at V = -90 of A;
# photometric horizontal at V = 90, H = 0 of B and V = H = 0 of A; H is clockwise.
PLACES = {
    "B": [
        (0, 0, 0, None), (90, 0, 90, 0), (-90, 0, 90, 180), (0, 90, 90, 270), (0, -90, 90, 90),
        (45, 0, 45, 0), (0, 45, 45, 270), (0, -45, 45, 90), (-45, 0, 45, 180),
        (45, 45, 60, math.degrees(-math.atan(math.sqrt(2)))),  # tan C = -y/x, cos g = 1/2
    ],
    "A": [
        (-90, 0, 0, None), (0, 0, 90, 0), (90, 0, 180, None), (0, 90, 90, 270), (0, -90, 90, 90),
        (45, 0, 135, 0), (-45, -90, 45, 90), (0, 45, 90, 315), (-45, 45, 45, 315),
    ],
    "C": [(0, 0, 0, None), (45, 45, 45, 45), (90, 135, 90, 135), (45, 315, 45, 315)],
}  # fmt: skip


@pytest.mark.parametrize("system", "ABC")
def test_directions_of_the_angles(system):
    vertical = steps(0, 180, 45) if system == "C" else steps(-90, 90, 45)
    horizontal = steps(0, 360, 45) if system == "C" else steps(-90, 90, 45)
    for v, h, gamma, c in PLACES[system]:
        is_pole = abs(h) == 90 if system == "B" else c is None  # one direction in all planes
        any_v, any_h = is_pole and system == "B", is_pole and system != "B"
        found = opened(
            lambda x, y, v=v, h=h, any_v=any_v, any_h=any_h: (
                5 if (x == v or any_v) and (y == h or any_h) else 0
            ),
            vertical,
            horizontal,
            system,
        ).distribution
        there = found.intensity(gamma * DEGREE, (0.7 if c is None else c) * DEGREE)
        assert there == pytest.approx(5, rel=1e-9), (v, h)


@pytest.mark.parametrize(
    ("planes", "images"),
    [
        ((0, 90), (30, 150, 210, 330)), ((0, 180), (30, 330)), ((0, 360), (30,)),
        ((90, 270), (120, 60)),
    ],
)  # fmt: skip
def test_symmetries_of_type_c(planes, images):
    found = opened(lambda v, h: 9.0 if h == images[0] else 0.0, [0, 90, 180], steps(*planes, 30))
    for c in range(0, 360, 15):
        near = min(abs((c - image + 180) % 360 - 180) for image in images)
        expected = 9 * max(0, 1 - near / 30)
        assert found.distribution.intensity(math.pi / 2, c * DEGREE) == pytest.approx(expected)


@pytest.mark.parametrize("system", "AB")
def test_symmetries_of_types_a_and_b(system):
    """Planes from 0 to 90 represent both sides."""
    vertical, one, two = steps(-90, 90, 15), steps(0, 90, 15), steps(-90, 90, 15)
    half = opened(lambda v, h: 100 + v + abs(h), vertical, one, system).distribution
    both = opened(lambda v, h: 100 + v + abs(h), vertical, two, system).distribution
    theta, phi = numpy.linspace(0, math.pi, 40), numpy.linspace(0, 7, 60)[:, None]
    assert half.intensity(theta, phi) == pytest.approx(both.intensity(theta, phi), rel=1e-12)


def test_a_direction_in_all_three_types():
    """An intensity linear in the direction is the same lamp in every type, to the tables' steps."""

    def seen(x, y, z):
        return 10 + 2 * x + 3 * y + 4 * z

    def of_c(v, h):
        v, h = v * DEGREE, h * DEGREE
        return seen(math.sin(v) * math.cos(h), math.sin(v) * math.sin(h), math.cos(v))

    def of_b(v, h):
        v, h = v * DEGREE, h * DEGREE
        return seen(math.sin(v) * math.cos(h), -math.sin(h), math.cos(v) * math.cos(h))

    c = opened(of_c, steps(0, 180, 2), steps(0, 360, 2)).distribution
    b = opened(of_b, steps(-180, 180, 2), steps(-90, 90, 2), "B").distribution
    a = opened(lambda v, h: of_c(v + 90, -h), steps(-90, 90, 2), steps(-180, 180, 2), "A")
    theta, phi = numpy.linspace(0.1, 3, 30), numpy.linspace(0, 6, 50)[:, None]
    expected = seen(
        numpy.sin(theta) * numpy.cos(phi), numpy.sin(theta) * numpy.sin(phi), numpy.cos(theta)
    )
    for lamp in (a.distribution, b, c):
        assert lamp.intensity(theta, phi) == pytest.approx(expected, rel=1e-3)
        assert lamp.flux().value == pytest.approx(40 * math.pi, rel=1e-3)


# Before and after the table ----------------------------------------------------------------------

EDITIONS = [
    (["A lamp"], 1986, 2), ([], 1986, 2), (["IESNA86"], 1986, 2), (["IESNA91"], 1991, 2),
    (["IESNA:LM-63-1991"], 1991, 2), (["IESNA:LM-63-1995"], 1995, 1), (["IESNA:LM-63-95"], 1995, 1),
    (["IESNA:LM-63-2002"], 2002, 1), (["IESNA: LM-63-2002 "], 2002, 1),
    (["IES:LM-63-2019"], 2019, 1),
    (["IES 2002 lamps"], 1986, 2), (["", "iesna:lm-63-2002"], 2002, 1),
]  # fmt: skip


@pytest.mark.parametrize(("label", "year", "factors"), EDITIONS)
def test_editions_and_their_factors(label, year, factors):
    """All have multiplier and ballast factor; those before 1995 a ballast-lamp factor."""
    found = opened(10, [0, 90, 180], [0], label=label, factors="0.5", ballast="0.9 0.8")
    expected = 4 * math.pi * 10 * 0.5 * 0.9 * (0.8 if factors == 2 else 1)
    assert flux(found) == pytest.approx(expected, rel=1e-13)
    assert found.format == f"IES LM-63-{year}, type C"
    assert any("ballast-lamp factor" in text for text in found.assumptions) == (year < 2019)


def test_an_unknown_edition():
    found = opened(10, [0, 90, 180], [0], label=["IESNA:LM-63-2033"])
    assert found.format == "IES LM-63, type C"
    assert found.name == ""
    assert flux(found) == pytest.approx(40 * math.pi, rel=1e-13)


@pytest.mark.parametrize(
    ("label", "name"),
    [
        (["A lamp of 1986", "more of it"], "A lamp of 1986"),
        (["IESNA91", "[TEST] 7", "[LUMCAT] L 5"], "L 5"),
        (["IESNA91", "[LUMINAIRE]Flood,", "[MORE] bronze ", "[LUMCAT] L 5"], "Flood, bronze"),
        (["IESNA:LM-63-2002", "[Luminaire] a\x1b[31mred"], r"a\x1b[31mred"),
        (["IESNA:LM-63-2002", "[LUMINAIRE]", "[LUMCAT]"], ""),
        ([], ""),
    ],
)
def test_the_name(label, name):
    assert opened(1, [0, 90], [0], label=label).name == name


def test_declared_values():
    found = opened(1, [0, 90], [0], lamps="2 1350", watts="36.5")
    assert found.declared == {"lamp-flux": 2700, "input-power": 36.5}
    assert opened(1, [0, 90], [0], lamps="2 -1", watts="0").declared == {}


@pytest.mark.parametrize(
    "tilt",
    [
        ["TILT=NONE"], ["tilt = none"], ["TILT=INCLUDE", "1", "3", "0 90 180", "1 .94 1"],
        ["TILT=INCLUDE", "1 3 0", "90 180 1 .94", "1"], ["TILT=lamp.tlt"],
    ],
)  # fmt: skip
def test_tilt_factors_are_not_applied(tilt):
    found = opened(10, [0, 90, 180], [0], tilt=tilt)
    assert flux(found) == pytest.approx(40 * math.pi, rel=1e-13)
    is_said = any("the lamp is in its measured position" in text for text in found.assumptions)
    assert is_said == ("none" not in tilt[0].lower())


GOOD = written(
    lambda v, h: 1000 - 5 * v + h / 3, steps(0, 90, 15), steps(0, 90, 30),
    lamps="2 900", factors="1.5", ballast="0.95 1",
    label=("IESNA:LM-63-2002", "[TEST] 7", "[LAMP] x"),
)  # fmt: skip


@pytest.mark.parametrize(
    "change",
    [
        lambda lines: [*lines[:4], *" ".join(lines[4:]).split()],
        lambda lines: [*lines[:4], " ".join(lines[4:])],
        lambda lines: [*lines[:4], *(line.replace(" ", ",") for line in lines[4:])],
        lambda lines: [*lines[:4], *(line.replace(" ", " , ") + "," for line in lines[4:])],
        lambda lines: [*lines[:4], *(line.replace(" ", "\t \t") for line in lines[4:])],
        lambda lines: [f"{line}\r\n" for line in lines],
        lambda lines: [part for line in lines for part in ("", line, "  ")],
        lambda lines: [*lines, "END", " "],
        lambda lines: [
            *lines[:6],
            *(line.replace("90", "89.995") for line in lines[6:8]),
            *lines[8:],
        ],
        lambda lines: [*lines[:4], *(line.replace("1000", "1.0E+3") for line in lines[4:])],
    ],
)
def test_line_ends_within_records(change):
    assert flux(ies.read(change(GOOD), "lamp.ies")) == flux(ies.read(GOOD, "lamp.ies"))


@pytest.mark.parametrize(
    ("line", "value"),
    [
        ("[_INTENSITYUNITS] mW/sr", 1e-3), ("[_INTENSITYUNITS] W / sr", 1),
        ("[_INTENSITYUNITS] µW/sr", 1e-6), ("[OTHER] Intensity values are in mW/sr.", 1e-3),
        ("[TEST] radiometric: lux-> mW/m^2, candela-> mW/sr", 1e-3),
    ],
)  # fmt: skip
def test_radiant_intensities(line, value):
    found = opened(100, [0, 90, 180], [0], label=["IESNA:LM-63-2002", line], lamps="1 500")
    assert found.distribution.kind == "e"
    assert flux(found) == pytest.approx(400 * math.pi * value, rel=1e-13)
    assert "lamp-flux" not in found.declared
    assert any("/sr" in text or "/ sr" in text for text in found.assumptions)


def test_candelas_may_be_named():
    found = opened(1, [0, 90], [0], label=["IESNA:LM-63-2002", "[_INTENSITYUNITS] cd"])
    assert found.distribution.kind == "v"


def test_assumptions_and_notes():
    """Negative noise, an open circle and a table that ends early have a text."""
    noisy = opened(lambda v, h: 1000 if v < 90 else -0.5, [0, 45, 90], [0])
    assert noisy.distribution.intensity(math.pi / 2, 0) == 0
    assert "1 negative intensity (down to -0.5) counts as 0" in noisy.notes
    seam = opened(lambda v, h: 100 + h / 36, [0, 90], steps(0, 360, 90))
    assert any("differ by 9" in text for text in seam.distribution.contradictions())
    assert not opened(100, [0, 90], steps(0, 360, 90)).notes
    short = opened(100, [0, 45, 75], [0])
    assert "no light beyond the angles of the table, 0 to 75 deg" in short.assumptions
    assert flux(short) == pytest.approx(200 * math.pi * (1 - math.cos(75 * DEGREE)))


# Refusals -----------------------------------------------------------------------------------------


def refused(lines):
    with pytest.raises(ConditionError) as caught:
        ies.read(lines, "lamp.ies")
    return caught.value


def changed(**places):
    """Return the good file with lines replaced: line_6="0 45 90"."""
    lines = list(GOOD)
    for key, text in places.items():
        lines[int(key.removeprefix("line_")) - 1] = text
    return lines


FIVE = "2 900 1.5 7 4 1 2 0 0 0"  # line 5 of the good file


@for_each([
    (changed(line_7="0 15 30 45 45 75 90"), "line 7: the vertical angles do not rise: 45 after 45",
     "rise"),
    (changed(line_7="0 15 45 30 60 75 90"), "line 7: the vertical angles do not rise: 30 after 45",
     "rise"),
    (changed(line_8="0 60 30 90"), "line 8: the horizontal angles do not rise: 30 after 60",
     "rise"),
    (changed(line_8="0 30 60 100"), "line 8: the horizontal angles are 0 to 100 deg", "0..90"),
    (changed(line_8="10 30 60 90"), "line 8: the horizontal angles are 10 to 90 deg", "0..90"),
    (changed(line_8="0 60 90 181"), "line 8: the horizontal angles are 0 to 181 deg", "90..270"),
    (changed(line_7="5 15 30 45 60 75 90"), "line 7: the vertical angles are 5 to 90", "0 or 90"),
    (changed(line_7="0 15 30 45 60 75 190"), "line 7: the vertical angles are 0 to 190",
     "0 to 180"),
    (changed(line_7="0 15 30 45 60 75"), "line 7: the 7 vertical angles that begin here", "7"),
    (changed(line_10="1 2 3 4 5 6 7 8"), "line 10: the 7 intensities of plane 2", "7 numbers"),
    (GOOD[:-1], "line 11: the file ends within the 7 intensities of plane 4", "the complete"),
    ([*GOOD, "1 2 3"], "line 13: more numbers than the table has: 7 vertical and 4 horizontal",
     "one luminaire"),
    (changed(line_9="1 2 nan 4 5 6 7"), "line 9: nan is out of range: numbers must be below 1e+18",
     "finite"),
    (changed(line_9="1 2 -inf 4 5 6 7"),
     "line 9: -inf is out of range: numbers must be below 1e+18", "finite"),
    (changed(line_9="1 2 1e999 4 5 6 7"),
     "line 9: inf is out of range: numbers must be below 1e+18", "finite"),
    (changed(line_9="1 2 1_0 4 5 6 7"), "line 9: '1_0' is not a number", "numbers"),
    (changed(line_9="1 2 ٣ 4 5 6 7"), "line 9: '٣' is not a number", "numbers"),
    (changed(line_9="1 2 \x1a 4 5 6 7"), r"line 9: '\x1a' is not a number", "numbers"),
    (changed(line_9="1 2 x 4 5 6 7"), "line 9: 'x' is not a number", "numbers"),
    (changed(line_9="1 2 ,, 4 5 6 7"), "line 9: a number is missing between two commas",
     "a number"),
    (changed(line_9="10,5 2 3,5 4 5 6 7"), "line 9: a number has a decimal comma",
     "decimal points"),
    (changed(line_9="1 2 -9 4 5 6 7"), "line 9: the intensity -9 is negative", "0 or more"),
    (
        written(0, [0, 90], [0]),
        "line 8: no intensity is above 0", "a table with light",
    ),
    (changed(line_5="0.5 900 1.5 7 4 1 2 0 0 0"), "the number of lamps is 0.5", "whole"),
    (changed(line_5="2 900 0 7 4 1 2 0 0 0"), "line 5: the multiplier is 0", "above 0"),
    (changed(line_6="-0.9 1 20"), "line 6: the ballast factor is -0.9", "above 0"),
    (changed(line_5="2 900 1.5 7.5 4 1 2 0 0 0"), "number of vertical angles is 7.5", "whole"),
    (changed(line_5="2 900 1.5 1 4 1 2 0 0 0"), "number of vertical angles is 1", "2 or more"),
    (changed(line_5="2 900 1.5 7 0 1 2 0 0 0"), "horizontal angles is 0", "1 or more"),
    (changed(line_5="2 900 1.5 7e9 4e9 1 2 0 0 0"), "line 12: the file ends within", "complete"),
    (changed(line_5="2 900 1.5 7 4 4 2 0 0 0"), "photometric type is 4", "1 (type C)"),
    (changed(line_5="2 900 1.5 7 4 1 0 0 0 0"), "type of units is 0", "1 (feet), 2 (metres)"),
    (changed(line_5="2 900 1.5 7 4 2 2 0 0 0", line_8="5 30 60 90"), "line 8:", "-90..90"),
    (changed(line_5="2 900 1.5 7 4 2 2 0 0 0", line_8="0 30 60 95"), "line 8:", "-90 to 90"),
    (changed(line_5="2 900 1.5 7 4 2 2 0 0 0", line_8="-9 30 60 90"), "line 8:", "-90..90"),
    (changed(line_5="2 900 1.5 7 4 3 2 0 0 0", line_7="0 15 30 45 60 75 95"), "line 7:", "-90"),
    (changed(line_1="IESNA:LM--63-2002", line_6="1 9 20"),
     "line 6: 9 is a factor in some editions", "IESNA91"),
    (changed(line_1="IESNA91", line_6="1 0 20"), "line 6: the ballast-lamp factor is", "above"),
    (changed(line_4="TILT="), "line 4: TILT= has no value", "TILT=NONE"),
    (changed(line_4="TILTED"), "line 12: the file ends before a line with TILT=", "LM-63"),
    ([], "line 1: the file ends before a line with TILT=", "LM-63"),
    (GOOD[:4], "line 4: the file ends after 0 of the 13 numbers", "13"),
    (GOOD[:5], "line 5: the file ends after 10 of the 13 numbers", "13"),
    (
        [*GOOD[:3], "TILT=INCLUDE", "4", "2", "0 90", "1 1", *GOOD[4:]],
        "line 5: the lamp's position is 4", "1 (vertical)",
    ),
    (
        [*GOOD[:3], "TILT=INCLUDE", "1", "2", "90 0", "1 1", *GOOD[4:]],
        "line 7: the tilt angles do not rise: 0 after 90", "rise",
    ),
    ([*GOOD[:3], "TILT=INCLUDE", "1", "200", *GOOD[4:]], "of the 200 tilt angles", "400"),
    (changed(line_2="[_INTENSITYUNITS] lm"), "line 2: the intensities are in lm", "mW/sr"),
    (changed(line_2="[TEST] mW/sr or W/sr"), "line 2: the intensities are in W/sr and mW/sr",
     "one of"),
    (changed(line_2="[TEST] RADIOMETRIC UNITS"), "line 2: radiometric intensities", "_INTENS"),
])  # fmt: skip
def test_refusals(lines, message, hint):
    error = refused(lines)
    assert error.message.startswith("lamp.ies, line ")
    assert message in error.message
    assert hint in error.hint


FAMILY = {
    "quarter": GOOD,
    "circle": written(lambda v, h: 500 + v + h, steps(0, 180, 45), steps(0, 360, 60)),
    "B": written(lambda v, h: 900 - v - h, steps(-90, 90, 45), steps(-90, 90, 45), "B"),
    "A": written(lambda v, h: 900 - v - h, steps(-90, 90, 45), steps(0, 90, 30), "A"),
}


def mutants(lines):
    """Yield files with a number dropped, doubled, swapped or replaced, and files cut off."""
    start = next(k for k, line in enumerate(lines) if line.startswith("TILT")) + 1
    for number in range(len(lines)):
        yield f"{number} lines", lines[:number]
        yield f"without line {number + 1}", lines[:number] + lines[number + 1 :]
        yield f"line {number + 1} twice", lines[: number + 1] + lines[number:]
    for number in range(start, len(lines)):
        words = lines[number].split()
        for k in range(len(words)):
            swapped = [*words[:k], *reversed(words[k : k + 2]), *words[k + 2 :]]
            joined = [*words[:k], "".join(words[k : k + 2]), *words[k + 2 :]]
            changes = {
                "dropped": words[:k] + words[k + 1 :],
                "doubled": words[: k + 1] + words[k:],
                "swapped": swapped,
                "joined": joined,
            }
            for text in (
                "nan", "inf", "-1", "x", "1,5", "0", "1e400", "-0.25", "1e9", "1e308", "3.5", "",
            ):  # fmt: skip
                changes[repr(text)] = [*words[:k], text, *words[k + 1 :]]
            for what, found in changes.items():
                yield (
                    f"{words[k]} in line {number + 1} {what}",
                    [*lines[:number], " ".join(found), *lines[number + 1 :]],
                )


@pytest.mark.parametrize("which", FAMILY)
def test_damaged_files_are_refused_or_read_correctly(which):
    """A file is refused, or its flux is that of a plain sum over its numbers."""
    answered, messages = 0, []
    for what, lines in mutants(FAMILY[which]):
        try:
            found = ies.read(lines, "lamp.ies")
        except ConditionError as error:
            messages.append((what, error.message, error.hint, max(len(lines), 1)))
            continue
        answered += 1
        value = flux(found)
        if math.isfinite(value):
            assert value == pytest.approx(plain_flux(lines), rel=1e-9), what
    assert answered
    for what, message, hint, last in messages:
        line = re.match(r"lamp\.ies, line (\d+): .", message)
        assert line, (what, message)
        assert 1 <= int(line[1]) <= last, (what, message)
        assert hint, (what, message)


def test_the_plain_sum_itself():
    for lines in FAMILY.values():
        assert plain_flux(lines) == pytest.approx(flux(ies.read(lines, "lamp.ies")), rel=1e-12)
    assert plain_flux(written(1, [0, 90, 180], [0])) == pytest.approx(4 * math.pi)
    assert plain_flux(written(1, [-90, 0, 90], [0, 90], "B")) == pytest.approx(2 * math.pi)


@pytest.mark.parametrize(
    ("sizes", "metres"),
    [
        ("1 2 3.5 0", 1.0668),  # feet
        ("2 0.3 1.2 0", 1.2),
        ("2 -0.15 0 0", 0.15),  # a circle, by its diameter
        ("2 0 0 0", 0.0),
    ],
)
def test_the_size_of_the_luminous_area_is_read(sizes, metres):
    text = f"IESNA:LM-63-2002\nTILT=NONE\n1 1000 1 2 1 1 {sizes}\n1 1 10\n0 90\n0\n100 100\n"
    assert ies.read(text.splitlines(), "lamp.ies").size == pytest.approx(metres)
