"""Tilted planes, oblique surfaces and small receivers, compared with sums over their points."""

import math

import mpmath
import pytest

from radcalc import convert, explain

PI = math.pi


def to(value: str, unit: str, **conditions: str) -> float:
    return float(convert(value, unit, **conditions).magnitude)


@pytest.mark.parametrize("angle", [0, 30, 60, 89, 90, 120, -60])
def test_irradiance_on_a_tilted_plane_follows_the_cosine(angle):
    part = max(0.0, math.cos(math.radians(angle)))
    turned = {"incidence": f"{angle}deg"}
    close = {"rel": 1e-12, "abs": 1e-9}
    assert to("1000 W/m2", "W/m2", **turned) == pytest.approx(1000 * part, **close)
    assert to("1000 W/m2", "W", area="2m2", **turned) == pytest.approx(2000 * part, **close)
    assert to("50 lx.s", "lm.s", area="2m2", **turned) == pytest.approx(100 * part, **close)
    assert to("3 umol/m2/s", "mmol", area="2m2", time="1h", **turned) == pytest.approx(
        21.6 * part, **close
    )
    assert to("500 lx", "cd/m2", reflectance="0.8", **turned) == pytest.approx(
        400 / PI * part, **close
    )
    assert to("500 lx", "radlux", reflectance="0.8", **turned) == pytest.approx(400 * part, **close)


def test_light_from_behind_is_noted():
    assert any("from the side or behind" in note for note in explain(
        "9 lx", "lx", incidence="91deg").notes)  # fmt: skip


@pytest.mark.parametrize("tilt", [0, 45, 80])
def test_the_intensity_of_an_oblique_surface_follows_the_cosine(tilt):
    part = math.cos(math.radians(tilt))
    seen = {"area": "30cm2", "tilt": f"{tilt}deg"}
    assert to("7 W/m2/sr", "W/sr", **seen) == pytest.approx(0.021 * part, rel=1e-12)
    assert to("3 cd", "cd/m2", **seen) == pytest.approx(1000 / part, rel=1e-12)
    far = to("1000 cd/m2", "lx", distance="2m", incidence="40deg", **seen)
    assert far == pytest.approx(0.75 * part * math.cos(math.radians(40)), rel=1e-12)
    assert to(f"{far!r} lx", "cd/m2", distance="2m", incidence="40deg", **seen) == pytest.approx(
        1000, rel=1e-12
    )


@pytest.mark.parametrize("tilt", [0, 20, 60, 80, 100])
@pytest.mark.parametrize("half", [5, 30, 75])
def test_an_oblique_cone_is_the_sum_over_its_directions(half, tilt):
    """Compare with the integral of the positive part of the cosine over the cone."""
    a, t = math.radians(half), math.radians(tilt)

    def ring(p):
        """Integrate max(0, cos p cos t + sin p sin t cos phi) sin p over the azimuth phi."""
        c, s = math.cos(p) * math.cos(t), math.sin(p) * math.sin(t)
        if s == 0:
            return 2 * PI * max(0, c) * math.sin(p)
        end = math.acos(max(-1, min(1, -c / s)))
        return 2 * (c * end + s * math.sin(end)) * math.sin(p)

    bend = sorted({0, min(a, max(0, PI / 2 - t)), min(a, abs(t - PI / 2)), a})
    expected = float(mpmath.quad(lambda p: ring(float(p)), bend))
    for name in ("tilt", "incidence"):
        found = to("1000 cd/m2", "lx", half_angle=f"{half}deg", **{name: f"{tilt}deg"})
        assert found == pytest.approx(1000 * expected, rel=1e-9, abs=1e-9)


def test_a_small_oblique_solid_angle_is_a_cone_within_the_stated_error():
    half = math.radians(2)
    small = to("1000 cd/m2", "lx", solid_angle=f"{2 * PI * (1 - math.cos(half))!r}sr", tilt="60deg")
    cone = PI * math.sin(half) ** 2 / 2 * 1000
    (said,) = explain("1000 cd/m2", "lx", solid_angle="3.8276e-3sr", tilt="60deg").assumptions
    within = float(said.split()[-2]) / 100 * 1.05  # two digits are shown
    assert 0 < abs(small / cone - 1) <= within < 5e-4


@pytest.mark.parametrize("angle", [0, 50, 75])
@pytest.mark.parametrize(("radius", "distance"), [(0.01, 0.101), (0.5, 7)])
def test_the_flux_on_a_small_receiver_is_within_the_stated_error(angle, radius, distance):
    """Compare with the flux of one candela on a disc: cos / r^2, summed over its points."""
    t, total = math.radians(angle), 0.0
    for k in range(200):
        rho = radius * math.sqrt((k + 0.5) / 200)
        for m in range(200):
            u, v = rho * math.cos(2 * PI * m / 200), rho * math.sin(2 * PI * m / 200)
            # on the disc, u is in the plane of the tilt
            square = (distance + u * math.sin(t)) ** 2 + (u * math.cos(t)) ** 2 + v * v
            total += distance * math.cos(t) / square**1.5
    expected = total / 200**2 * PI * radius**2
    place = {"radius": f"{radius}m", "distance": f"{distance}m", "incidence": f"{angle}deg"}
    (said, _) = explain("1 cd", "lm", **place).assumptions
    within = float(said.split()[-2]) / 100
    assert to("1 cd", "lm", **place) == pytest.approx(expected, rel=within + 1e-5)
    assert within < 0.02
    assert to("1 lm", "cd", **place) == pytest.approx(1 / to("1 cd", "lm", **place), rel=1e-12)


def test_all_quantities_at_a_small_receiver():
    """1 W/sr into 20 mm2 at 1 m: 20 uW; and lumens, photons and joules."""
    place = {"area": "20mm2", "distance": "1m"}
    assert to("1 W/sr", "uW", **place) == pytest.approx(20, rel=1e-12)
    assert to("20 uW", "W/sr", **place) == pytest.approx(1, rel=1e-12)
    assert to("100 cd", "mlm", **place) == pytest.approx(2, rel=1e-12)
    assert to("5 umol/s/sr", "nmol", time="10s", **place) == pytest.approx(1, rel=1e-12)
    assert to("1 W/sr", "lm", efficacy="100lm/W", **place) == pytest.approx(2e-3, rel=1e-12)
    assert to("1 W/sr/nm", "uW/nm", **place) == pytest.approx(20, rel=1e-12)
