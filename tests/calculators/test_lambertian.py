"""Lambertian sources against integrals over their visible parts, and closed forms."""

import itertools
import math
from typing import Any

import mpmath
import numpy as np
import pytest
from following import call
from helpers import Q, for_each, number
from mpmath import mpf

import radcalc
from radcalc import lambertian
from radcalc.calculators.lambertian import lambertian as work_out
from radcalc.cli.spelling import Shell
from radcalc.errors import RadcalcError, TooNear
from radcalc.inputs.reading import read

PI = math.pi

NODES, WEIGHTS = np.polynomial.legendre.leggauss(160)


def interval(low: Any, high: Any) -> tuple[Any, Any]:
    return (low + high) / 2 + (high - low) / 2 * NODES, (high - low) / 2 * WEIGHTS


def seen(x: Any, y: Any, h: float, normal: tuple[float, ...]) -> Any:
    """Return cos cos / r^2 of an element at x, y of a ceiling, h above a receiver."""
    square = x * x + y * y + h * h
    toward = normal[0] * x + normal[1] * y + normal[2] * h
    assert (toward > -1e-9).all()  # the limits of integration end at the horizon
    return toward * h / square**2


def disc_integral(r: float, h: float, x: float, normal: tuple[float, ...]) -> float:
    """Integrate over strips across the offset; the disc's centre is at -x from the receiver."""
    low, high = -r - x, r - x
    if normal[0] > 0:
        low = max(low, -h * normal[2] / normal[0])
    if normal[0] < 0:
        high = min(high, -h * normal[2] / normal[0])
    # the half width of the disc is smooth in this angle
    a, b = (math.asin(max(-1.0, min(1.0, (end + x) / r))) for end in (low, high))
    total = 0.0
    for angle, weight in zip(*interval(a, b), strict=True):
        half = r * math.cos(angle)
        y, wy = interval(-half, half)
        u = r * math.sin(angle) - x
        total += weight * half * float((wy * seen(u + 0 * y, y, h, normal)).sum())
    return total


@pytest.mark.parametrize("incidence", [None, -20, 0, 10, 35, 70, 100])
@pytest.mark.parametrize(("r", "h", "x"), [(0.25, 0.75, 0.1), (1, 1, 2), (2, 1, 0.5), (1, 1, -2)])
def test_the_light_of_a_disc_is_the_integral_over_it(r, h, x, incidence):
    """The incidence tilts the receiver from the line to the centre, away from the axis."""
    off = math.atan2(abs(x), h)
    tilt = 0.0 if incidence is None else off - math.radians(incidence)
    normal = (-math.copysign(1, x) * math.sin(tilt), 0.0, math.cos(tilt))
    angle = {} if incidence is None else {"incidence": f"{incidence}deg"}
    found = lambertian(
        "disc", radius=f"{r}m", height=f"{h}m", offset=f"{x}m", luminance="1e4cd/m2", **angle
    )
    expected = 1e4 * disc_integral(r, h, x, normal)
    assert number(found, "irradiance", "lx") == pytest.approx(expected, rel=1e-9)
    assert number(found, "configuration_factor", "1") == pytest.approx(
        expected / 1e4 / PI, rel=1e-9
    )


@pytest.mark.parametrize(("r", "d"), [(0.06, 3), (1, 1.5), (1, 1.02)])
@pytest.mark.parametrize("incidence", [0, 20, 50, 80, 90, 110])
def test_the_light_of_a_sphere_is_the_integral_over_its_visible_part(r, d, incidence):
    """Rings about the receiver's normal: cos(a) = cos(t) cos(p) + sin(t) sin(p) cos(phi)."""
    found = lambertian(
        "sphere", radius=f"{r}m", distance=f"{d}m", incidence=f"{incidence}deg",
        luminance="2e4cd/m2",
    )  # fmt: skip
    with mpmath.workdps(25):
        a, t = mpmath.asin(mpf(r) / mpf(d)), mpf(incidence) * mpmath.pi / 180

        def ring(p):
            if t == 0 or p == 0:
                return 2 * mpmath.pi * mpmath.cos(p) * mpmath.sin(p)
            cosine = (mpmath.cos(a) - mpmath.cos(t) * mpmath.cos(p)) / mpmath.sin(t) / mpmath.sin(p)
            return 2 * mpmath.acos(max(-1, min(1, cosine))) * mpmath.cos(p) * mpmath.sin(p)

        low, high = max(t - a, 0), min(t + a, mpmath.pi / 2)
        inner = [abs(t - a)] if t < a < mpmath.pi / 2 else []
        ends = sorted({low, high, *(e for e in inner if low < e < high)})
        expected = 2e4 * float(mpmath.quad(ring, ends)) if high > low else 0.0
    assert number(found, "irradiance", "lx") == pytest.approx(expected, rel=1e-10)
    area = 4 * PI * r**2
    assert number(found, "flux", "lm") == pytest.approx(PI * 2e4 * area, rel=1e-12)
    assert number(found, "intensity", "cd") == pytest.approx(2e4 * PI * r**2, rel=1e-12)


def rectangle_integral(w, l, h, x, y, normal) -> float:  # noqa: E741
    """Integrate; the rectangle's centre is at (-x, -y) from the receiver, whose horizon cuts it."""
    box = [[-w / 2 - x, w / 2 - x], [-l / 2 - y, l / 2 - y]]
    for axis in (0, 1):
        if normal[axis] and not normal[1 - axis]:
            at = -h * normal[2] / normal[axis]
            if normal[axis] > 0:
                box[axis][0] = max(box[axis][0], at)
            else:
                box[axis][1] = min(box[axis][1], at)
    (u, wu), (v, wv) = interval(*box[0]), interval(*box[1])
    values = seen(u[:, None], v[None, :], h, normal)
    return float(wu @ values @ wv)


PLACES = [(0, 0), (0.5, 1), (0.3, 0.2), (2, -1.5), (-0.4, 3)]


@pytest.mark.parametrize(("x", "y"), PLACES)
def test_the_light_of_a_rectangle_is_the_integral_over_it(x, y):
    found = lambertian(
        "rectangle", luminance="3000cd/m2", width="1m", length="2m", height="1.5m",
        offset=f"{x}m", offset_y=f"{y}m",
    )  # fmt: skip
    expected = 3000 * rectangle_integral(1, 2, 1.5, x, y, (0, 0, 1))
    assert number(found, "irradiance", "lx") == pytest.approx(expected, rel=1e-11)


@pytest.mark.parametrize(("x", "y"), PLACES)
def test_the_light_across_a_rectangle_is_the_integral_over_it(x, y):
    found = lambertian(
        "rectangle", perpendicular=True, luminance="3000cd/m2", width="1m", length="2m",
        height="1.5m", offset=f"{x}m", offset_y=f"{y}m",
    )  # fmt: skip
    expected = 3000 * rectangle_integral(1, 2, 1.5, x, y, (0, -1 if y > 0 else 1, 0))
    assert number(found, "irradiance", "lx") == pytest.approx(expected, rel=1e-11)


@for_each(
    [
        *itertools.product((0.3, 2, -2), (0,), (-30, 0, 15, 60, 85)),
        *itertools.product((0,), (0.7, -3), (-30, 0, 15, 60, 85)),
        *itertools.product((0.3, -0.3), (0.4,), (-10, 0, 15)),  # no horizon across its corners
    ],
)
def test_the_light_on_a_receiver_turned_under_a_rectangle(x, y, incidence):
    lateral = math.hypot(x, y)
    tilt = math.atan2(lateral, 1.5) - math.radians(incidence)
    normal = (-x / lateral * math.sin(tilt), -y / lateral * math.sin(tilt), math.cos(tilt))
    found = lambertian(
        "rectangle", luminance="3000cd/m2", width="1m", length="2m", height="1.5m",
        offset=f"{x}m", offset_y=f"{y}m", incidence=f"{incidence}deg",
    )  # fmt: skip
    expected = 3000 * rectangle_integral(1, 2, 1.5, x, y, tuple(n + 0.0 for n in normal))
    assert number(found, "irradiance", "lx") == pytest.approx(expected, rel=1e-10)


@pytest.mark.parametrize("incidence", [-60, -15, 30, 60, 85])
@pytest.mark.parametrize("place", ["height", "distance"])
def test_on_the_axis_of_a_rectangle_the_receiver_is_tilted_along_the_width(place, incidence):
    angle = math.radians(incidence)
    found = lambertian(
        "rectangle", luminance="3000cd/m2", width="1m", length="2m", incidence=f"{incidence}deg",
        **{place: "1.5m"},
    )  # fmt: skip
    expected = 3000 * rectangle_integral(1, 2, 1.5, 0, 0, (math.sin(angle), 0, math.cos(angle)))
    assert number(found, "irradiance", "lx") == pytest.approx(expected, rel=1e-10)


def test_a_corner_is_off_the_axis_by_half_of_width_and_length():
    sizes = {"luminance": "3000cd/m2", "width": "1m", "length": "2m", "height": "1.5m"}
    for flags in ((), ("perpendicular",)):
        normal = (0, -1, 0) if flags else (0, 0, 1)
        found = lambertian("rectangle", corner=True, **dict.fromkeys(flags, True), **sizes)
        expected = 3000 * rectangle_integral(1, 2, 1.5, 0.5, 1, normal)
        assert number(found, "irradiance", "lx") == pytest.approx(expected, rel=1e-11)


@pytest.mark.parametrize("shape", ["hemisphere", "plane"])
@pytest.mark.parametrize("tilt", [0, 30, 90, 135, 180])
def test_the_light_of_a_sky_on_a_tilted_plane(shape, tilt):
    found = lambertian(shape, luminance="3000cd/m2", incidence=f"{tilt}deg")
    expected = 3000 * PI / 2 * (1 + math.cos(math.radians(tilt)))
    assert number(found, "irradiance", "lx") == pytest.approx(expected, rel=1e-12, abs=1e-9)


@pytest.mark.parametrize(("r", "d"), [(0.25, 0.75), (3, 0.5), (0.01, 4)])
def test_the_size_and_the_distance_of_a_disc_and_of_a_sphere_from_their_light(r, d):
    part = {"disc": r**2 / (r**2 + d**2), "sphere": (r / (r + d)) ** 2}
    away = {"disc": d, "sphere": r + d}
    for shape, factor in part.items():
        lit = {"luminance": Q(1e4, "cd/m2"), "illuminance": Q(1e4 * PI * factor, "lx")}
        size = lambertian(shape, distance=Q(away[shape], "m"), **lit)
        assert number(size, "radius", "m") == pytest.approx(r, rel=1e-9)
        far = lambertian(shape, radius=Q(r, "m"), **lit)
        assert number(far, "distance", "m") == pytest.approx(away[shape], rel=1e-9)
        twice = lambertian(shape, diameter=Q(2 * r, "m"), **lit)
        assert number(twice, "distance", "m") == pytest.approx(away[shape], rel=1e-9)


def test_the_sphere_seen_from_a_distance():
    found = lambertian("sphere", luminance="2e4cd/m2", radius="6cm", distance="3m")
    assert number(found, "irradiance", "lx") == pytest.approx(2e4 * PI * 0.02**2, rel=1e-12)
    omega = 2 * PI * (1 - math.sqrt(1 - 0.02**2))
    assert number(found, "solid_angle", "sr") == pytest.approx(omega, rel=1e-10)


@pytest.mark.parametrize("half", [10, 45, 80])
def test_a_disc_and_a_part_of_a_hemisphere_have_the_same_light_on_the_axis(half):
    tangent = math.tan(math.radians(half))
    disc = lambertian("disc", luminance="1e4cd/m2", radius=f"{tangent!r}m", distance="1m")
    sky = lambertian("hemisphere", luminance="1e4cd/m2", half_angle=f"{half}deg")
    expected = 1e4 * PI * math.sin(math.radians(half)) ** 2
    for found in (disc, sky):
        assert number(found, "irradiance", "lx") == pytest.approx(expected, rel=1e-12)


def test_the_irradiance_of_the_sun():
    # IAU 2015 B3: R = 695 700 km, 3.828e26 W, so M = L/(4 pi R^2), and 1361 W/m2 at 1 au
    au, r, power = 149597870700, 695700e3, 3.828e26
    found = lambertian("sphere", radiance=f"{power / (4 * PI**2 * r**2)!r}W/m2/sr",
                       radius="695700km", distance="1au")  # fmt: skip
    assert number(found, "irradiance", "W/m2") == pytest.approx(power / (4 * PI * au**2), rel=1e-12)
    assert round(number(found, "irradiance", "W/m2")) == 1361
    assert number(found, "flux", "W") == pytest.approx(power, rel=1e-12)
    assert number(lambertian(radiance="2.0e7W/m2/sr"), "exitance", "W/m2") == 2e7 * PI


@pytest.mark.parametrize(
    ("call", "name", "unit", "expected"),
    [
        (lambda: lambertian(luminance="100cd/m2", area="0.1m2"), "flux", "lm", 10 * PI),
        (lambda: lambertian(luminance="100cd/m2", area="0.1m2"), "intensity", "cd", 10),
        (lambda: lambertian(incident_illuminance="500lx", reflectance=0.8), "radiance", "cd/m2",
         400 / PI),
        (lambda: lambertian("disc", radius="25cm", distance="75cm", illuminance="70lx"),
         "exitance", "lm/m2", 700),
    ],
)  # fmt: skip
def test_lambertian_sources_match_their_formulas(call, name, unit, expected):
    assert number(call(), name, unit) == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize("incidence", [84.5, 87, 89, 90, 91, -93, 95])
def test_a_disc_cut_by_the_horizon_is_the_integral_over_its_visible_part(incidence):
    """The far field would be off by 5 % at 87 degrees, by 43 % at 89, and be 0 at 90."""
    angle = math.radians(abs(incidence))
    expected = 1000 * disc_integral(1, 10, 0, (math.sin(angle), 0.0, math.cos(angle)))
    placed = {"diameter": "2m", "distance": "10m", "incidence": f"{incidence}deg"}
    found = lambertian("patch", luminance="1000cd/m2", **placed)
    assert number(found, "irradiance", "lx") == pytest.approx(expected, rel=1e-9)
    found = radcalc.convert("1000 cd/m2", "lx", **placed)
    assert found.to("lx").magnitude == pytest.approx(expected, rel=1e-9)


@pytest.mark.parametrize("incidence", [-100, -99])
def test_a_receiver_turned_past_the_disc_still_sees_its_far_edge(incidence):
    """At 184 degrees from facing the plane it sees the far edge of a wide disc."""
    off = math.atan2(10, 1)
    tilt = off - math.radians(incidence)
    expected = 1e4 * disc_integral(40, 1, 10, (-math.sin(tilt), 0.0, math.cos(tilt)))
    found = lambertian(
        "disc", radius="40m", height="1m", offset="10m", luminance="1e4cd/m2",
        incidence=f"{incidence}deg",
    )  # fmt: skip
    assert expected > 0
    assert number(found, "irradiance", "lx") == pytest.approx(expected, rel=1e-9)


@pytest.mark.parametrize("incidence", [None, 0, 25, -50])
@pytest.mark.parametrize(("h", "x", "y"), [(2, 0, 0), (2, 1, 0), (1, 3, -4), (0.5, 0, 5)])
def test_a_small_patch_above_a_receiver_is_its_disc(h, x, y, incidence):
    """The integral over a disc of that area, within the error in the answer."""
    radius, lateral = 0.02, math.hypot(x, y)
    off = math.atan2(lateral, h)
    tilt = 0.0 if incidence is None else off - math.radians(incidence)
    expected = 1e4 * disc_integral(radius, h, lateral, (-math.sin(tilt), 0.0, math.cos(tilt)))
    place = {"height": f"{h}m", "offset": f"{x}m", "offset-y": f"{y}m"}
    if incidence is not None:
        place["incidence"] = f"{incidence}deg"
    texts = {"luminance": "1e4cd/m2", "area": f"{PI * radius**2!r}m2", **place}
    answer = work_out("patch", {name: read(name, text) for name, text in texts.items()})
    (said,) = (text for text in answer.assumptions if "inverse square" in text)
    within = float(said.split()[-2]) / 100
    (found,) = (value.amount for value in answer.values if value.name == "irradiance")
    assert within < 0.01
    assert found == pytest.approx(expected, rel=within)


@pytest.mark.parametrize(
    ("texts", "expected"),
    [
        ({"area": "1m2", "height": "1m", "offset": "30cm", "offset-y": "40cm"},
         lambda: disc_integral(1 / math.sqrt(PI), 1, 0.5, (0, 0, 1))),
        ({"area": "1m2", "distance": "2m", "tilt": "30deg"},
         lambda: disc_integral(1 / math.sqrt(PI), math.sqrt(3), 1, (-0.5, 0, math.sqrt(3) / 2))),
        ({"diameter": "1m", "distance": "2m", "incidence": "40deg"},
         lambda: disc_integral(0.5, 2, 0, (math.sin(math.radians(40)), 0,
                                           math.cos(math.radians(40))))),
        ({"width": "1m", "area": "2m2", "height": "1.5m", "offset-y": "1m"},
         lambda: rectangle_integral(1, 2, 1.5, 0, 1, (0, 0, 1))),
    ],
)  # fmt: skip
def test_a_source_that_is_too_near_is_refused_with_the_exact_call(texts, expected):
    given = {name: read(name, text) for name, text in {"luminance": "1e4cd/m2", **texts}.items()}
    with pytest.raises(TooNear) as caught:
        work_out("patch", given)
    words = caught.value.spelled(Shell)[1].partition(",")[0].split()
    assert words[:2] == ["radcalc", "lambertian"]
    outcome = call([*words[1:], "-g", "irradiance:lx", "-q"])
    assert float(outcome.output) == pytest.approx(1e4 * expected(), rel=1e-5)


@pytest.mark.parametrize(("r", "h", "x"), [(0.25, 0.75, 0.1), (1, 2, 3), (2, 0.5, 1.5), (1, 1, 1)])
def test_position_and_size_of_a_disc_follow_from_its_light_off_the_axis(r, h, x):
    lux = 1e4 * disc_integral(r, h, x, (0, 0, 1))
    lit = {"luminance": "1e4cd/m2", "illuminance": Q(lux, "lx")}
    sizes = {"radius": f"{r:.4f}m", "height": f"{h:.4f}m", "offset": f"{x:.4f}m"}
    for name, size in (("radius", r), ("height", h), ("offset", x)):
        others = {other: text for other, text in sizes.items() if other != name}
        found = np.atleast_1d(lambertian("disc", **lit, **others)[name].to("m").magnitude)
        assert np.min(abs(found / size - 1)) < 1e-7
        for one in map(float, found):
            place = {"radius": r, "height": h, "offset": x, name: one}
            assert 1e4 * disc_integral(*place.values(), (0, 0, 1)) == pytest.approx(lux, rel=1e-7)


def test_next_to_a_disc_two_heights_have_the_same_light():
    found = lambertian(
        "disc", luminance="1e4cd/m2", radius="25cm", offset="50cm", illuminance="1klx"
    )
    near, far = found["height"].to("m").magnitude
    for height in (near, far):
        assert 1e4 * disc_integral(0.25, height, 0.5, (0, 0, 1)) == pytest.approx(1000, rel=1e-9)


@pytest.mark.parametrize("half", [1, 30, 46.7, 89])
def test_the_half_angle_of_a_cap_follows_from_its_light(half):
    part = PI * math.sin(math.radians(half)) ** 2
    found = lambertian("hemisphere", luminance="3000cd/m2", illuminance=Q(3000 * part, "lx"))
    assert number(found, "half_angle", "deg") == pytest.approx(half, rel=1e-9)
    all_of_it = lambertian("hemisphere", luminance="3000cd/m2", illuminance="9425lx")
    assert "half_angle" not in all_of_it


@pytest.mark.parametrize(("w", "l", "h"), [(1, 2, 1.5), (0.1, 3, 0.4), (5, 5, 0.2)])
def test_the_sides_and_the_height_of_a_rectangle_follow_from_its_light(w, l, h):  # noqa: E741
    lux = 3000 * rectangle_integral(w, l, h, 0, 0, (0, 0, 1))
    lit = {"luminance": "3000cd/m2", "illuminance": Q(lux, "lx")}
    sizes = {"width": f"{w}m", "length": f"{l}m", "height": f"{h}m"}
    for name, size in (("width", w), ("length", l), ("height", h)):
        others = {other: text for other, text in sizes.items() if other != name}
        found = lambertian("rectangle", **lit, **others)
        assert number(found, name, "m") == pytest.approx(size, rel=1e-6)
        assert number(found, "flux", "lm") == pytest.approx(3000 * PI * w * l, rel=2e-6)
    with pytest.raises(RadcalcError, match="endless strip"):
        lambertian("rectangle", luminance="3000cd/m2", illuminance="9klx", width="1m", height="1m")


def test_a_thin_rectangle_is_a_strip():
    """An endless strip of width w has a projected solid angle of pi w / sqrt(w^2 + 4 h^2)."""
    found = lambertian(
        "rectangle", radiance="1W/m2/sr", width="1e-12m", length="1e12m", irradiance="1e-9W/m2"
    )
    assert number(found, "height", "m") == pytest.approx(PI * 1e-12 / 2 / 1e-9, rel=1e-9)


# A flux of 1600 lm over pi R^2 or 4 pi R^2, divided by pi sr: ISO 80000-7, exitance and radiance.
@pytest.mark.parametrize(
    ("shape", "circles"), [("disc", 1), ("DISC", 1), ("sphere", 4), ("Sphere", 4)]
)
def test_a_disc_and_a_sphere_of_one_radius_differ_by_four(shape, circles):
    found = lambertian(shape, flux="1600 lm", radius="3 cm")
    expected = 1600 / (circles * PI * 0.03**2) / PI
    assert number(found, "luminance", "cd/m2") == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize("size", ["radius", "diameter"])
@pytest.mark.parametrize(
    "light", [{"flux": "1600 lm"}, {"luminance": "9 cd/m2", "distance": "2 m"}]
)
def test_a_radius_without_a_shape_is_refused_with_a_call_for_each(size, light):
    with pytest.raises(RadcalcError, match="the shape is missing") as caught:
        lambertian(**light, **{size: "3 cm"})
    for shape in ("disc", "sphere"):
        assert f'radcalc.lambertian("{shape}", ' in caught.value.hint
    if "flux" in light and size == "radius":  # the values of the test above
        assert "180127 " in caught.value.hint
        assert "45031.6 " in caught.value.hint


@pytest.mark.parametrize(
    ("given", "is_assumed"),
    [
        ({"flux": "1600 lm", "area": "2 m2"}, True),
        ({"flux": "1600 lm"}, True),
        ({"luminance": "9 cd/m2", "width": "1 m", "length": "2 m"}, True),
        ({"luminance": "9 cd/m2", "radius": "3 cm", "height": "2 m", "offset": "1 m"}, True),
        ({"luminance": "9 cd/m2"}, False),
        ({"incident_illuminance": "500 lx", "reflectance": "0.8"}, False),
    ],
)
def test_a_patch_is_assumed_where_the_shape_matters(given, is_assumed):
    first = lambertian(**given).assumptions[0]
    assert ("a flat surface that emits on one side" in first) == is_assumed
    assert "flat surface" not in " ".join(lambertian("patch", **given).assumptions)


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({}, "source and receiver face each other"),
        ({"tilt": "10 deg"}, "the receiver faces the source"),
        ({"incidence": "10 deg"}, "the source faces the receiver"),
    ],
)
def test_an_angle_that_is_not_given_is_an_assumption(given, said):
    assert (
        said in lambertian(luminance="9 cd/m2", area="1 cm2", distance="2 m", **given).assumptions
    )
    between = {"area": "1 cm2", "receiver_area": "1 cm2", "distance": "2 m"}
    assert said in radcalc.etendue(**between, **given).assumptions
