"""EULUMDAT files: every symmetry with exact fluxes, and damaged files."""

import math
from itertools import product

import numpy as np
import pytest
from distributions.ldt import ALL_AROUND, GAMMAS, plain_figures, written
from helpers import for_each

from radcalc.distributions.eulumdat import read
from radcalc.errors import RadcalcError


def flux(lines):
    return read(lines, "lamp.ldt").distribution.flux()


def even(_c, _gamma):
    return 100.0


@pytest.mark.parametrize("symmetry", range(5))
@pytest.mark.parametrize("step", [5, 10, 15, 22.5, 90])
def test_a_sphere_of_every_symmetry_has_its_flux(symmetry, step):
    planes = [k * step for k in range(round(360 / step))]
    found = read(written(even, symmetry, planes), "lamp.ldt")
    assert found.distribution.flux().value == pytest.approx(400 * math.pi, rel=1e-12)
    assert found.format == f"EULUMDAT, Isym {symmetry}"
    assert found.distribution.kind == "v"
    assert found.distribution.is_axial == (symmetry == 1)


@pytest.mark.parametrize("symmetry", range(5))
def test_half_a_sphere_is_dark_beyond_its_angles(symmetry):
    for gammas in (GAMMAS[:19], GAMMAS[18:]):
        found = read(written(even, symmetry, gammas=gammas), "lamp.ldt")
        assert found.distribution.flux().value == pytest.approx(200 * math.pi, rel=1e-12)
        assert any("no light beyond" in text for text in found.assumptions)


# One modulation for each symmetry, with a mean of 0 over a whole circle.
WAVES = {
    0: lambda c: 1 + 0.3 * math.cos(c) + 0.4 * math.sin(c) + 0.1 * math.sin(2 * c),
    2: lambda c: 1 + 0.5 * math.cos(c),
    3: lambda c: 1 + 0.5 * math.sin(c),
    4: lambda c: 1 + 0.5 * math.cos(2 * c),
}


@pytest.mark.parametrize("symmetry", WAVES)
def test_each_plane_has_the_azimuth_of_its_symmetry(symmetry):
    wave = WAVES[symmetry]
    found = read(written(lambda c, g: 100 * wave(c) * (1 + g), symmetry), "lamp.ldt").distribution
    for c in ALL_AROUND:
        for g in (30, 90, 150):
            c_rad, g_rad = math.radians(c), math.radians(g)
            expected = 100 * wave(c_rad) * (1 + g_rad)
            assert found.intensity(g_rad, c_rad) == pytest.approx(expected, rel=1e-12)
    # 1 + gamma is linear, so its table is exact: 2 pi 100 (2 + pi)
    assert found.flux().value == pytest.approx(200 * math.pi * (2 + math.pi), rel=1e-12)


def test_symmetry_3_begins_with_c270():
    """According to the format, Mc1 = 3 Mc/4 + 1 (docs.agi32.com, EULUMDAT file format)."""
    lines = written(lambda c, g: 100 + 50 * math.sin(c), 3, [0, 90, 180, 270], [0.0, 90.0, 180.0])
    assert [float(text) for text in lines[-9:]] == [50] * 3 + [100] * 3 + [150] * 3
    found = read(lines, "lamp.ldt").distribution
    assert found.intensity(1.0, math.pi / 2) == pytest.approx(150)
    assert found.intensity(1.0, -math.pi / 2) == pytest.approx(50)


@for_each(product(range(5), [1, 5, 10], [1, 4, 20]))
def test_the_flux_of_a_lobe_is_within_its_error(symmetry, step, power):
    gammas = [float(step * k) for k in range(round(90 / step) + 1)]
    found = flux(written(lambda c, g: 1000 * max(math.cos(g), 0) ** power, symmetry, gammas=gammas))
    exact = 2000 * math.pi / (power + 1)
    assert abs(found.value - exact) <= found.error
    assert found.error < 0.1 * exact


def test_planes_are_weighted_by_their_angle():
    planes = [0.0, 10.0, 30.0, 90.0, 180.0, 270.0]
    lines = written(lambda c, g: 10 + math.degrees(c), 0, planes, steps=(0, 5))
    gaps = np.diff([*planes, 360.0])
    weights = (gaps + np.roll(gaps, 1)) / 2  # trapezia, the last back to the first
    expected = 2 * np.radians(weights) @ (10 + np.array(planes))
    assert flux(lines).value == pytest.approx(expected, rel=1e-12)


def test_uneven_symmetric_planes():
    planes = [0, 20, 90, 160, 180, 200, 270, 340]
    for symmetry in (2, 3, 4):
        found = read(written(even, symmetry, planes, steps=(0, 0)), "lamp.ldt")
        assert found.distribution.flux().value == pytest.approx(400 * math.pi)


def test_the_factors_are_applied_once():
    lines = written(even, 1, [0.0], factor=2.5, sets=[(2, "T16", 8100, "", "", 120)])
    found = read(lines, "lamp.ldt")
    assert found.distribution.intensity(1.0, 0.0) == pytest.approx(100)
    at = lines.index("2.5")
    doubled = [*lines[:at], "5", *lines[at + 1 :]]
    assert read(doubled, "lamp.ldt").distribution.intensity(1.0, 0.0) == pytest.approx(200)
    assert found.declared == {
        "lamp-flux": 8100, "output-ratio": 0.8, "downward-fraction": 0.5, "input-power": 120,
    }  # fmt: skip


def test_lamp_sets_are_alternatives():
    sets = [(1, "A", 2000, "", "", 20), (2, "B", 3000, "", "", 30), (1, "C", 500, "", "", "")]
    found = read(written(even, 1, [0.0], sets=sets), "lamp.ldt")
    assert found.distribution.intensity(0.0, 0.0) == pytest.approx(100)
    assert (found.declared["lamp-flux"], found.declared["input-power"]) == (2000, 20)
    assert "3 lamp sets" in found.notes[0]
    assert "3000 lm, 30 W" in found.notes[0]


def test_a_negative_number_of_lamps_is_absolute_photometry():
    found = read(written(even, 1, [0.0], sets=[(-2, "LED", 1256.6, "", "", 9)]), "lamp.ldt")
    assert found.distribution.intensity(0.0, 0.0) == pytest.approx(100)
    assert found.declared == {"flux": 1256.6, "downward-fraction": 0.5, "input-power": 9}
    assert any("absolute photometry" in text for text in found.assumptions)
    assert not [*found.notes, *found.contradictions()]
    said = read(written(even, 1, [0.0], sets=[(-1, "LED", 1300, "", "", 9)]), "lamp.ldt")
    assert [*said.contradictions()] == [
        "the file declares a luminaire of 1300 lm, but its intensities give 1257 lm"
    ]


def test_features_of_real_files_are_read():
    plain = written(even, 1, [0.0])
    expected = flux(plain).value
    dr = 26 + 6
    for lines in (
        [*plain, "", " ", ""],
        [f"  {line} \t" for line in plain],
        [line if k not in range(12, 21) else "" for k, line in enumerate(plain)],  # no sizes
        [*plain[:dr], *[""] * 10, *plain[dr + 10 :]],
        [*plain[:dr], *plain[dr + 10 :]],
        [line.replace(".", ",") for line in plain[:8]] + ["a, b"]
        + [line.replace(".", ",") for line in plain[9:]],
    ):  # fmt: skip
        assert flux(lines).value == expected
    assert "no direct ratios" in read([*plain[:dr], *plain[dr + 10 :]], "x").notes[0]
    assert flux(written(even, 1)).value == expected  # 24 planes are listed, one is there
    assert "tilt of 15 deg" in read(written(even, 1, [0.0], tilt=15), "x").notes[0]


def test_noise_of_a_photometer_counts_as_0():
    found = read(changed(200, "-0.05"), "lamp.ldt")
    assert found.notes == ("1 negative intensity (down to -0.05) counts as 0",)
    assert found.distribution.values.min() == 0


def test_the_name_is_printable():
    assert read(written(even, 1, [0.0], name="L\x1b[31m" + "x" * 100), "x").name.startswith(
        "L\\x1b[31m"
    )


def changed(number, text, **other):
    lines = written(even, **other)
    return [*lines[: number - 1], text, *lines[number:]]


REFUSED = {
    "a step that contradicts the planes": (changed(5, "10"), "line 44: the angle C 15"),
    "a step that contradicts gamma": (changed(7, "2.5"), "line 68: the angle gamma 5"),
    "a symmetry that there is not": (changed(3, "5"), "line 3: '5' is not a valid symmetry Isym"),
    "half a plane": (changed(4, "23.5"), "line 4: 23.5 is not a valid number Mc"),
    "too few planes": (changed(4, "23"), "a valid angle gamma 1 of 37"),
    "too many angles": (changed(6, "38"), "line 104: the gamma angles do not rise: 100 deg"),
    "planes no symmetry divides": (changed(4, "22", symmetry=4), "line 4: Mc is 22"),
    "no conversion": (changed(24, "0"), "line 24: the conversion factor is 0"),
    "a negative factor": (changed(24, "-1"), "line 24: '-1' is not a valid conversion factor"),
    "lamps of no flux": (changed(29, "0"), "line 29: the first lamp set has 0 lm"),
    "no lamps": (changed(26, "0"), "line 26: '0' is not a valid number of lamp sets"),
    "equal planes": (changed(44, "0"), "line 44: the C angles do not rise: 0 deg"),
    "falling gammas": (changed(69, "4"), "line 69: the gamma angles do not rise: 4 deg"),
    "a plane beyond the circle": (changed(66, "361"), "line 66: '361' is not a valid angle C 24"),
    "NaN": (changed(200, "nan"), "line 200: 'nan' is not a valid intensity"),
    "infinity": (changed(200, "inf"), "line 200: 'inf' is not a valid intensity"),
    "a negative intensity": (changed(200, "-3"), "line 200: the intensity -3 is negative"),
    "a word": (changed(200, "much"), "line 200: 'much' is not a valid intensity"),
    "other digits": (changed(200, "١٠"), "line 200: "),
    "a gap": (changed(200, ""), "line 200: '' is not a valid intensity"),
    "data behind": ([*written(even), "", "7"], "line 993: '7' follows the last intensity"),
    "darkness": (written(lambda c, g: 0.0), "no intensity is above 0"),
    "half of the planes": (
        written(even, 0, ALL_AROUND[:12]), "line 54: the planes end at 165 deg, and 195 deg"
    ),
    "planes on one side": (
        written(even, 2, [0, 100, 170, 280], steps=(0, 5)),
        "line 45: the plane C170 is listed where"
    ),
    "a plane without its image": (
        changed(58, "226", symmetry=4, steps=(0, 5)), "line 58: the plane C226 is listed where"
    ),
    "points and commas": (changed(200, "99,5"), "line 200: a decimal comma, but line 5 has"),
    "a thousand": (
        [line.removesuffix(".0") for line in changed(29, "1,000", ratios=[1] * 10)],
        "line 29: '1,000' is ambiguous: a thousand or a decimal",
    ),
    "too short": (written(even)[:-11], "line 980: the file ends here, before its intensity 27"),
    "a flux of no lamp": (changed(29, "1e200"), "line 29: '1e200' is not a valid luminous flux"),
    "light of no lamp": (changed(200, "1e200"), "line 200: an intensity is above 1e100"),
    "nothing": ([""], "line 1: the file ends here, before its company"),
}  # fmt: skip


@for_each(REFUSED.values())
def test_a_bad_file_is_refused_with_the_line(lines, message):
    with pytest.raises(RadcalcError) as caught:
        read(lines, "lamp.ldt")
    assert message in caught.value.message
    assert caught.value.message.startswith("lamp.ldt")
    assert caught.value.hint


def outcome(lines):
    """Return the contents of a file, or the error."""
    try:
        return read(lines, "lamp.ldt")
    except RadcalcError as error:
        return error


def mutants(lines):
    for k, line in enumerate(lines):
        yield f"truncated before {k + 1}", lines[:k]
        yield f"without {k + 1}", lines[:k] + lines[k + 1 :]
        yield f"{k + 1} twice", lines[: k + 1] + lines[k:]
        if k + 1 < len(lines):
            yield f"{k + 1} swapped", [*lines[:k], lines[k + 1], line, *lines[k + 2 :]]
        for text in ("nan", "inf", "x", "", "-1", "1e400", "0", "7", "1,5", "1_0", "\x00", "1 2"):
            yield f"{k + 1} {text!r}", [*lines[:k], text, *lines[k + 1 :]]


@pytest.mark.parametrize("symmetry", range(5))
def test_damage_is_refused_with_a_line_or_harmless(symmetry):
    wave = WAVES.get(symmetry, lambda c: 1.0)
    planes = [0.0, 45.0, 90.0, 135.0, 180.0, 225.0, 270.0, 315.0]
    whole = written(
        lambda c, g: round(100 * wave(c) * (2 + math.cos(g)), 3), symmetry, planes,
        [30.0 * k for k in range(7)], sets=[(1, "LED", 2000, "", "", 12), (1, "", 3000, "", "", 9)],
    )  # fmt: skip
    assert plain_figures(whole)[0] == pytest.approx(flux(whole).value, rel=1e-12)
    count = accepted = 0
    for what, lines in mutants(whole):
        count += 1
        found = outcome(lines)
        if isinstance(found, RadcalcError):
            assert "lamp.ldt, line " in found.message, what
            assert found.hint, what
            continue
        accepted += 1
        value, first, lumens = plain_figures(lines)
        distribution = found.distribution
        assert distribution.flux().value == pytest.approx(value, rel=1e-9), what
        assert distribution.intensity(*first[:2]) == pytest.approx(first[2]), what
        assert found.declared.get("lamp-flux", lumens) == lumens, what
    assert count > 1000
    assert 0 < accepted < count / 2


@pytest.mark.parametrize(
    ("sizes", "metres"),
    [
        ([1200, 300, 80, 1150, 250, 0, 0, 0, 0], 1.15),
        ([200, 0, 80, 150, 0, 0, 0, 0, 0], 0.15),  # a circle, by its diameter
        ([200, 300, 80, 0, 0, 0, 0, 0, 0], 0.3),
        ([0] * 9, 0.0),
    ],
)
def test_the_size_of_the_luminous_area_is_read(sizes, metres):
    lines = written(lambda _c, _gamma: 100.0)
    lines[12:21] = map(str, sizes)
    assert read(lines, "lamp.ldt").size == metres
