"""Light at a surface between two media."""

import pytest
from conftest import run

# colour-science 0.4.7, colour.phenomena: snell_law and polarised_light_reflection_coefficient
FRESNEL = [
    (1.52, 0, 0, 0.04257999, 0.04257999),
    (1.52, 30, 19.2048974971, 0.06120869, 0.02707831),
    (1.52, 60, 34.7330421912, 0.18343825, 0.00152716),
    (1.52, 85, 40.9493231667, 0.73767396, 0.49217302),
    (1.333, 48.6, 34.244389451, 0.06244283, 0.00103235),
    (2.417, 20, 8.13500473578, 0.19011488, 0.15436661),
    ("1/1.5", 40, 74.618568308, 0.39051811, 0.10006430),
]


def asked(words: str, *names: str) -> list[float]:
    options = [word for name in names for word in ("-g", name)]
    done = run("refraction", *words.split(), "-q", *options, check=True)
    return [float(number) for number in done.stdout.split()]


@pytest.mark.parametrize(("index", "incidence", "angle", "s", "p"), FRESNEL)
def test_angles_and_reflectances_match_colour_science(index, incidence, angle, s, p):
    words = f"--index {index} --incidence {incidence}deg"
    found = asked(words, "refraction-angle:deg", "reflectance-s", "reflectance-p")
    assert found == pytest.approx([angle, s, p], rel=1e-6, abs=1e-8)
    halves = asked(words, "reflectance", "transmittance")
    assert halves == pytest.approx([(s + p) / 2, 1 - (s + p) / 2], rel=1e-6)


@pytest.mark.parametrize(("index", "incidence", "angle", "s", "p"), FRESNEL[1:])
def test_two_of_index_and_angles_give_the_third(index, incidence, angle, s, p):
    number = eval(index) if isinstance(index, str) else index
    words = f"--refraction-angle {angle}deg --incidence {incidence}deg"
    assert asked(words, "index") == pytest.approx([number], rel=1e-9)
    words = f"--refraction-angle {angle}deg --index {index}"
    assert asked(words, "incidence:deg") == pytest.approx([incidence], rel=1e-9)


def test_a_slab_sums_the_reflections_at_both_faces():
    """Along the normal (1 - R) / (1 + R) with R = ((n - 1) / (n + 1))^2 is 2 n / (n^2 + 1)."""
    assert asked("--index 1.52 --incidence 0deg", "slab-transmittance") == pytest.approx(
        [2 * 1.52 / (1.52**2 + 1)], rel=1e-12
    )
    found = asked("--index 1.52 --incidence 60deg", "slab-transmittance")
    assert found == pytest.approx([0.84347], abs=5e-6)


def test_brewsters_angle_reflects_no_parallel_light_and_is_square_to_the_refracted():
    (angle,) = asked("--index 1.52", "brewster-angle:deg")
    words = f"--index 1.52 --incidence {angle!r}deg"
    reflected, refracted = asked(words, "reflectance-p", "refraction-angle:deg")
    assert reflected == pytest.approx(0, abs=1e-20)
    assert refracted == pytest.approx(90 - angle, rel=1e-10)
    assert asked(f"--brewster-angle {angle!r}deg", "index") == pytest.approx([1.52], rel=1e-10)


def test_light_past_the_critical_angle_is_totally_reflected():
    (angle,) = asked("--index 1/1.52", "critical-angle:deg")
    assert asked("--index 1.52", "critical-angle:deg") == [angle]
    assert asked(f"--critical-angle {angle!r}deg", "index") == pytest.approx([1.52], rel=1e-10)
    before, past = f"{angle - 1e-9!r}deg", f"{angle + 1e-9!r}deg"
    assert asked(f"--index 1/1.52 --incidence {before}", "reflectance")[0] == pytest.approx(
        1, abs=1e-3
    )
    done = run("refraction", "--index", "1/1.52", "--incidence", past, "-g", "reflectance")
    assert done.stdout == "1\n"
    assert "total reflection" in done.stderr


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ("", "the index is missing"),
        ("--incidence 60deg", "--incidence 60deg alone is not enough"),
        ("--index 1.52 --incidence 91deg", "out of range"),
        ("--index 0 --incidence 10deg", "out of range"),
        ("--index 1.52 --incidence 60deg --refraction-angle 30deg", "contradicts the other inputs"),
        ("--index 0.5 --incidence 60deg --refraction-angle 30deg", "totally reflected"),
        ("--index 1.52 --refraction-angle 60deg", "no incidence gives"),
        ("--incidence 0deg --refraction-angle 0deg", "does not determine the index"),
        ("--index 1.52 --critical-angle 45deg", "contradicts the other inputs"),
        (
            "--index 1.52 --incidence 10deg --wavelength 500nm",
            "refraction has no --wavelength option",
        ),
    ],
)
def test_impossible_refractions_are_refused(words, message):
    done = run("refraction", *words.split())
    assert done.returncode == 2
    assert message in done.stderr
