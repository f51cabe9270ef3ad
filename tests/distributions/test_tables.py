"""Tables of angles and intensities: layouts of laboratories, and their mistakes."""

import math

import numpy as np
import pytest
from helpers import for_each

from radcalc.distributions import contents as column_titles
from radcalc.distributions.tables import read
from radcalc.errors import RadcalcError

ROWS = ["0,300", "15,290", "30,260", "45,200", "60,110", "75,30", "90,0"]
LUMENS = 791.3485  # of these; the sum of [-I cos + s sin] over the segments, by two programs


def table(*lines, name="lamp.csv"):
    return read(lines, name)


def flux(*lines):
    return table(*lines).distribution.flux().value


WRITTEN = {
    "commas": ["gamma,I (cd)", *ROWS],
    "semicolons": ["gamma;I (cd)", *(row.replace(",", ";") for row in ROWS)],
    "tabs": ["gamma\tI (cd)", *(row.replace(",", "\t") for row in ROWS)],
    "bars": ["gamma|I (cd)", *(row.replace(",", " | ") for row in ROWS)],
    "blanks": ["gamma (deg) I (cd)", *(row.replace(",", "   ") for row in ROWS)],
    "decimal commas": ["gamma;I (cd)", *(row.replace(",", ",0;") + ",00" for row in ROWS)],
    "decimal commas and blanks": ["gamma I_cd", *(row.replace(",", ",0 ") + ",0" for row in ROWS)],
    "a comma and a blank": ["gamma, I (cd)", *(row.replace(",", ", ") for row in ROWS)],
    "quotes": ['"gamma","I (cd)"', *('"' + row.replace(",", '","') + '"' for row in ROWS)],
    "comments": ["# a lamp", "gamma,I (cd)", "", *ROWS[:3], "# half way", *ROWS[3:], " "],
    "titles in a comment": ["# 2020, at 25 C", "# gamma,I (cd)", *ROWS],
    "the unit in a comment": ["# gamma, C0", "# I (cd)", *ROWS],
    "no titles": ["# cd", *ROWS],
    "millicandelas": ["angle,intensity [mcd]", *(row + "000" for row in ROWS)],
    "ISO 80000": ["theta/deg,I/cd", *ROWS],
    "a row of units": ["gamma,I", "deg,cd", *ROWS],
    "a row of units over planes": [
        "gamma;C0;C90", ";cd;cd",
        *(f"{row};{row.split(',')[1]}".replace(",", ";") for row in ROWS),
    ],
    "a unit alone": ["deg,cd", *ROWS],
    "lumens per steradian": ["Winkel (°),I in lm/sr", *ROWS],
    "one C plane": ["gamma,C0 (cd)", *ROWS],
    "radians": [
        "theta (rad),I (cd)",
        *(f"{math.radians(float(a))!r},{i}" for a, i in (row.split(",") for row in ROWS)),
    ],
    "C planes": ["gamma,C0 (cd),C90 (cd)", *(row + "," + row.split(",")[1] for row in ROWS)],
    "plain planes": [
        "# cd", "gamma,0,45,90", *(row + ("," + row.split(",")[1]) * 2 for row in ROWS),
    ],
    "both sides": [
        "angle,I (cd)", *(f"-{row}" for row in ROWS[:0:-1]), *ROWS,
    ],
    "cuts": [
        "angle;C0-C180 (cd);C90/270 (cd)",
        *(f"-{row};{row.split(',')[1]}".replace(",", ";") for row in ROWS[:0:-1]),
        *(f"{row};{row.split(',')[1]}".replace(",", ";") for row in ROWS),
    ],
}  # fmt: skip


@for_each(WRITTEN.values())
def test_a_laboratory_table_is_read_in_any_layout(lines):
    found = table(*lines)
    assert found.distribution.flux().value == pytest.approx(LUMENS, abs=5e-5)
    assert found.distribution.kind == "v"
    assert found.format == "CSV table"
    assert any("no light beyond the angles of the table, 0 to 90" in a for a in found.assumptions)


def test_without_a_unit_intensities_are_relative():
    for lines in (
        ROWS,
        ["gamma,C0", *ROWS],
        ["angle,relative (%)", *ROWS],
        ["x°,I/Imax", *ROWS][1:],
    ):
        found = table(*lines)
        assert found.distribution.kind == ""
        assert any("relative intensities" in text for text in found.assumptions)
        assert found.distribution.flux().value == pytest.approx(LUMENS, abs=5e-5)


@pytest.mark.parametrize(
    ("unit", "kind", "factor"),
    [
        ("cd", "v", 1), ("mcd", "v", 1e-3), ("kcd", "v", 1e3), ("W/sr", "e", 1),
        ("mW/sr", "e", 1e-3), ("uW sr-1", "e", 1e-6), ("photon/s/sr", "p", 1),
        ("mol/s/sr", "p", 6.02214076e23),
    ],
)  # fmt: skip
def test_units_are_those_of_radcalc(unit, kind, factor):
    for title in (
        f"I ({unit})",
        f"intensity [{unit}]",
        f"I in {unit}",
        f"I/{unit}",
        f"C0 ({unit})",
    ):
        found = table(f"gamma,{title}", *ROWS).distribution
        assert found.kind == kind
        assert found.flux().value == pytest.approx(LUMENS * factor, rel=1e-6)


@pytest.mark.parametrize("step", [1, 5, 10])
@pytest.mark.parametrize("power", [1, 4, 20])
def test_the_flux_of_a_lobe_is_within_its_error(step, power):
    rows = [f"{a},{500 * max(math.cos(math.radians(a)), 0) ** power}" for a in range(0, 91, step)]
    found = table("gamma,I (cd)", *rows).distribution.flux()
    assert abs(found.value - 1000 * math.pi / (power + 1)) <= found.error


def planes_of(wave, planes, gammas=range(0, 181, 30)):
    rows = [
        f"{g}," + ",".join(str(wave(math.radians(c)) * (1 + g)) for c in planes) for g in gammas
    ]
    return ["gamma," + ",".join(f"C{c:g} (cd)" for c in planes), *rows]


@pytest.mark.parametrize(
    ("wave", "planes"),
    [
        (lambda c: 2 + math.sin(c), range(0, 360, 30)),
        (lambda c: 2 + math.sin(c), range(0, 361, 30)),
        (lambda c: 2 + math.sin(c), range(-180, 180, 30)),
        (lambda c: 2 + math.cos(c), range(0, 181, 30)),
        (lambda c: 2 + math.sin(c), range(90, 271, 30)),
        (lambda c: 2 + math.sin(c), range(-90, 91, 30)),
        (lambda c: 2 + math.cos(2 * c), range(0, 91, 30)),
        (lambda c: 2.0, [0, 180]),
        (lambda c: 2.0, [0, 120, 240]),
    ],
)
def test_planes_cover_the_circle_or_are_mirrored(wave, planes):
    found = table(*planes_of(wave, planes)).distribution
    for c in range(0, 360, 30):
        expected = wave(math.radians(c)) * 91
        assert found.intensity(math.pi / 2, math.radians(c)) == pytest.approx(expected, rel=1e-12)
    degrees = 180 / math.pi  # 2 (1 + gamma) over a sphere: 4 pi (2 + pi) / 2 with gamma in radians
    assert found.flux().value == pytest.approx(2 * 2 * math.pi * (2 + math.pi * degrees), rel=1e-12)


def test_negative_angles_are_in_the_opposite_half_plane():
    rows = ["-90,0", "-30,10", "10,50", "90,0"]
    found = table("angle,I (cd)", *rows)
    lamp = found.distribution
    for angle, expected in ((30, 37.5), (10, 50), (0, 40), (-10, 30), (-30, 10), (-60, 5)):
        azimuth = 0.0 if angle >= 0 else math.pi
        assert lamp.intensity(abs(math.radians(angle)), azimuth) == pytest.approx(expected)
    assert lamp.intensity(math.radians(30), math.pi / 2) == pytest.approx((37.5 + 10) / 2)
    assert any("cut through the axis" in text for text in found.assumptions)
    # by the mean of both halves, since azimuths between them are linear
    halves = ["0,40", "10,40", "30,23.75", "90,0"]
    assert lamp.flux().value == pytest.approx(flux("angle,I (cd)", *halves), rel=1e-12)


def test_noise_of_a_photometer_counts_as_0():
    found = table("gamma,I (cd)", "0,300", "60,20", "90,-0.1")
    assert found.notes == ("1 negative intensity (down to -0.1) counts as 0",)
    assert found.distribution.flux().value == flux("gamma,I (cd)", "0,300", "60,20", "90,0")


def test_cuts_in_several_planes():
    lines = ["angle,C0,C45,C90,C135", "-60,1,2,3,4", "0,9,9,9,9", "60,5,6,7,8"]
    lamp = table(*lines).distribution
    edge = math.radians(60)
    for c, expected in zip(range(0, 360, 45), (5, 6, 7, 8, 1, 2, 3, 4), strict=True):
        assert lamp.intensity(edge, math.radians(c)) == pytest.approx(expected)


REFUSED = {
    "nothing": ([], "there is no data"),
    "only a title": (["gamma,I (cd)"], "line 1: there is no row of numbers"),
    "one row": (["gamma,I (cd)", "0,1"], "line 2: one row is not a table"),
    "one column": (["0", "15", "30"], "line 1: there is only one column"),
    "a spectrum": (["wavelength (nm),I (W/sr)", "400,1", "700,2"], "is not an angle"),
    "wavelengths": (["400,1", "500,3", "700,2"],
        "line 3: a polar angle of 700 deg is out of range"),
    "an illuminance": (["gamma,E (lx)", *ROWS], "line 1: the values are in illuminance (lx)"),
    "a flux": (["gamma,power (W)", *ROWS], "line 1: the values are in radiant flux (W)"),
    "a radiance": (["gamma,radiance", *ROWS], "'radiance' is not an intensity"),
    "per lamp flux": (["gamma,C0 (cd/klm)", *ROWS], "relative to the flux of lamps"),
    "two rows of titles": (["gamma,I", "a,b", *ROWS], "line 2: 'a,b' is between the titles"),
    "no unit": (["gamma,I (candles)", *ROWS], "'candles' is not a unit of intensity"),
    "the wrong case": (["gamma,I (Cd)", *ROWS], "unknown unit in the title"),
    "thousands of candelas": (["gamma,I x 1000 cd", *ROWS], "scales its numbers"),
    "thousandths behind": (["gamma,I (cd) / 1000", *ROWS], "scales its numbers"),
    "thousandths of a plane": (["gamma,C0 (cd) / 1000", *ROWS], "scales its numbers"),
    "each lamp of several": (["gamma,I (cd) per lamp", *ROWS], "scales its numbers"),
    "a logarithm": (["gamma,log I (cd)", *ROWS], "has a function of its numbers"),
    "two units": (["gamma,I (cd) (W/sr)", *ROWS], "has two units, W/sr and cd"),
    "angles in tens": (["angle (deg) x10,I (cd)", *ROWS], "scales its numbers"),
    "half of the angle": (["theta/2 (deg),I (cd)", *ROWS], "scales its numbers"),
    "twice the angle": (["2 theta (deg),I (cd)", *ROWS], "in the first column is not an angle"),
    "angles in two units": (["angle [deg] (rad),I (cd)", *ROWS], "has two units, rad and deg"),
    "a sine": (["sin theta,I (cd)", *ROWS], "in the first column is not an angle"),
    "a cosine": (["cosine (deg),I (cd)", *ROWS], "in the first column is not an angle"),
    "decibels": (["gamma,I (dB)", *ROWS], "line 1: 'dB' is not a unit"),
    "an elevation": (["elevation (deg),I (cd)", *ROWS], "not a polar angle from the source's axis"),
    "a place": (["x (mm),I (cd)", *ROWS], "in the first column is not an angle"),
    "no angle": (["x,I (cd)", *ROWS], "not a polar angle from the source's axis"),
    "intensities first": (["I (cd),gamma", *ROWS], "in the first column is not an angle"),
    "different light": (["gamma,C0 (cd),C90 (W/sr)", "0,1,1", "9,1,1"], "different kinds of light"),
    "half a unit": (["gamma,C0 (cd),C90", "0,1,1", "9,1,1"], "some columns have a unit"),
    "undeclared radians": (["theta,I (cd)", "0,1", "1.5708,0"],
        "the unit of the angles, up to 1.5708, is missing"),
    "a word": (["gamma,I (cd)", "0,1", "5,x"], "line 3: 'x' in column 2 is not an intensity"),
    "NaN": (["gamma,I (cd)", "0,1", "5,nan"], "line 3: 'nan' in column 2 is not an intensity"),
    "a negative value": (["gamma,I (cd)", "0,1", "5,-2"], "line 3: the intensity -2 is negative"),
    "a gap": (["gamma,I (cd)", "0,1", "5,"], "line 3: '' in column 2"),
    "a short row": (["gamma,C0,C90", "0,1,1", "5,1"], "line 3: 2 columns instead of 3"),
    "a long row": (["gamma,I (cd)", "0,1", "5,1,2"], "line 3: 3 columns instead of 2"),
    "titles over others": (["gamma,I (cd)", "0,1,2", "5,1,2"], "2 titles for 3 columns"),
    "equal angles": (["gamma,I (cd)", "0,1", "5,1", "5,1"],
        "line 4: the angles do not rise: 5 after 5"),
    "falling angles": (["gamma,I (cd)", "90,1", "0,1"],
        "line 3: the angles do not rise: 0 after 90"),
    "light of no lamp": (["gamma,I (kcd)", "0,1", "9,1e99", "19,1e101"],
        "line 4: an intensity is above"),
    "darkness": (["gamma,I (cd)", "0,0", "9,0"], "no intensity is above 0"),
    "a hole on the axis": (["gamma,I (cd)", "5,1", "90,0"], "line 2: the angles begin at 5 deg"),
    "one side further": (["gamma,I (cd)", "-60,1", "0,1", "90,1"],
        "line 4: the angles go from -60 to 90"),
    "beyond behind": (["gamma,I (cd)", "0,1", "190,0"], "line 3: a polar angle of 190 deg"),
    "planes of no name": (["gamma,a,b", "0,1,1", "9,1,1"], "2 of 2 columns (a, b) have no C plane"),
    "no titles over planes": (["0,1,1", "9,1,1"], "2 of 2 columns have no C plane"),
    "falling planes": (["gamma,C90,C0", "0,1,1", "9,1,1"], "line 1: the C planes are 90, 0"),
    "a third of the circle": (
        ["gamma,C0,C30,C60,C120", "0,1,1,1,1", "9,1,1,1,1"], "line 1: the planes end at 120 deg"
    ),
    "a bent plane": (["gamma,C0-C170", "-9,1", "9,1"], "line 1: C0-C170 is not a plane through"),
    "sides twice": (["gamma,C0,C180", "-9,1,1", "9,1,1"], "line 2: an angle is negative"),
    "a thousand": (["gamma;I (cd)", "0;1,000", "9;1,000"],
        "line 2: '1,000' is ambiguous: a thousand"),
    "points and commas": (["gamma;I", "0;1,5", "9;1.000"], "line 3: a decimal point, but line 2"),
    "two comments": (["# I (cd)", "# mcd", *ROWS], "the comments have different units: cd and mcd"),
}  # fmt: skip


@for_each(REFUSED.values())
def test_a_bad_table_is_refused(lines, message):
    with pytest.raises(RadcalcError) as caught:
        table(*lines)
    assert message in caught.value.message
    assert caught.value.message.startswith("lamp.csv")
    assert caught.value.hint


def again(lines):
    """Return the flux of a table of C planes from 0 to 90 degrees with commas, without radcalc."""
    rows = [[float(cell) for cell in line.split(",")] for line in lines[1:] if line.strip()]
    titles = [float(cell.strip(" Ccd()")) for cell in lines[0].split(",")[1:]]
    gammas = np.radians([row[0] for row in rows])
    sums = []
    for k in range(1, len(rows[0])):
        values = np.array([row[k] for row in rows])
        slopes = np.diff(values) / np.diff(gammas)
        ends = values[:-1] * np.cos(gammas[:-1]) - values[1:] * np.cos(gammas[1:])
        sums.append(float(np.sum(ends + slopes * np.diff(np.sin(gammas)))))
    if len(titles) == 1:
        return 2 * math.pi * sums[0]
    return 4 * float(np.trapezoid(sums, np.radians(titles)))


def mutants(lines):
    for k, line in enumerate(lines):
        yield lines[:k]
        yield lines[:k] + lines[k + 1 :]
        yield lines[: k + 1] + lines[k:]
        if k + 1 < len(lines):
            yield [*lines[:k], lines[k + 1], line, *lines[k + 2 :]]
        cells = line.split(",")
        for j, cell in enumerate(cells):
            for new in ("nan", "inf", "x", "", "-1", "1e400", "0", "17", "1_0", "\x00", "1 2", "٣"):
                yield [*lines[:k], ",".join([*cells[:j], new, *cells[j + 1 :]]), *lines[k + 1 :]]
            for cut in ([], [cell, cell], [cell + cell]):
                changed = ",".join([*cells[:j], *cut, *cells[j + 1 :]])
                yield [*lines[:k], changed, *lines[k + 1 :]]


def outcome(lines):
    """Return the contents of a table, or the error."""
    try:
        return table(*lines)
    except RadcalcError as error:
        return error


def test_damage_is_refused_or_harmless():
    whole = planes_of(lambda c: 2 + math.cos(2 * c), [0, 45, 90], [0, 20, 40, 60, 90])
    assert again(whole) == pytest.approx(flux(*whole), rel=1e-12)
    count = accepted = 0
    for lines in mutants(whole):
        count += 1
        found = outcome(lines)
        if isinstance(found, RadcalcError):
            assert found.message.startswith("lamp.csv"), lines
            assert "line" in found.message or not any(lines) or "there is no" in found.message, (
                lines
            )
            continue
        accepted += 1
        assert found.distribution.flux().value == pytest.approx(again(lines), rel=1e-9), lines
    assert count > 300
    assert 0 < accepted < count / 2


@pytest.mark.parametrize("title", ["I (cd)", "C0", "", "I [mW/sr]", "counts", "I0", "relative"])
def test_titles_of_intensities(title):
    column_titles.column(title)


@pytest.mark.parametrize(
    ("title", "plane", "opposite"),
    [
        ("C0", 0, None), ("C 22.5", 22.5, None), ("c90°", 90, None), ("phi=45 deg", 45, None),
        ("0", 0, None), ("C0 - C180", 0, 180), ("C90/270", 90, 270), ("22,5", 22.5, None),
        ("C0 (cd)", 0, None), ("I (cd)", None, None), ("2 m (cd)", None, None), ("C", None, None),
    ],
)  # fmt: skip
def test_planes_in_titles(title, plane, opposite):
    assert column_titles.column(title)[:2] == (plane, opposite)
