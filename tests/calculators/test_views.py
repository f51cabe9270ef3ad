"""Pictures of a part of the sphere, by Radiance's VIEW= or by --field, against plain sums.

`shown` and `place` follow rpict(1) and Radiance's src/common/image.c (viewray and viewloc), without
radcalc; the values are sums over equal solid angles of the sphere.
"""

import json
import math
from functools import cache

import numpy
import pytest
from conftest import run
from distributions.maps import hdr

from radcalc.distributions.maps.pictures import Picture, write_picture

VIEWS = [  # type, angles, shift and lift, direction and up, size
    ("a", 180, 180, 0, 0, (1, 0, 0), (0, 0, 1), (120, 120)),
    ("a", 120, 90, 0, 0, (1, 2, 0.5), (0, 0.3, 1), (120, 90)),
    ("a", 350, 350, 0.1, 0, (0, 0, 1), (0, 1, 0), (140, 140)),
    ("h", 180, 180, 0, 0, (0, 0, 1), (0, 1, 0), (120, 120)),
    ("h", 100, 60, 0, 0.1, (-1, 0, 0), (0, 0, 1), (120, 80)),
    ("s", 180, 180, 0, 0, (0, -1, 0), (0, 0, 1), (120, 120)),
    ("v", 90, 60, 0, 0, (1, 1, 0), (0, 0, 1), (120, 80)),
    ("v", 60, 40, 0.3, -0.2, (1, 0, 0), (0, 1, 1), (120, 80)),
    ("c", 360, 90, 0, 0, (0, 1, 0), (0, 0, 1), (160, 80)),
    ("c", 200, 90, 0.1, 0.25, (1, 0, 0), (0, 0, 1), (120, 72)),
]
NAMES = [f"vt{kind}-{across}x{upright}" for kind, across, upright, *_ in VIEWS]


def axes(direction, up):
    forward = numpy.array(direction) / numpy.linalg.norm(direction)
    right = numpy.cross(forward, up)
    right /= numpy.linalg.norm(right)
    return forward, right, numpy.cross(right, forward)


def edges(kind, across, upright):
    """Return half the width and half the height of a view, as distances from its middle."""
    h, v = math.radians(across) / 2, math.radians(upright) / 2
    if kind == "c":
        return h, math.tan(v)
    of = {"a": float, "h": math.sin, "s": lambda t: math.tan(t / 2), "v": math.tan}[kind]
    return of(h), of(v)


def shown(view, x, y):
    """Return the directions at x (to the right) and y (up), from -1 to 1, and where some are."""
    kind, across, upright, shift, lift, direction, up, _ = view
    wide, high = edges(kind, across, upright)
    x, y = (x + 2 * shift) * wide, (y + 2 * lift) * high
    forward, right, above = (axis[:, None, None] for axis in axes(direction, up))
    r = numpy.hypot(x, y)
    if kind == "c":
        rays = forward * numpy.cos(x) + right * numpy.sin(x) + above * y
        return rays / numpy.hypot(1, y), abs(x) <= math.pi
    with numpy.errstate(invalid="ignore", divide="ignore"):
        t = {"a": r, "h": numpy.arcsin(r), "s": 2 * numpy.arctan(r), "v": numpy.arctan(r)}[kind]
        rays = forward * numpy.cos(t) + (right * x + above * y) * numpy.sin(t) / r
    return rays, t <= math.pi


def place(view, rays):
    """Return where directions (n, 3) are in the picture, and whether they are in it."""
    kind, across, upright, shift, lift, direction, up, _ = view
    wide, high = edges(kind, across, upright)
    forward, right, above = (rays @ axis for axis in axes(direction, up))
    t = numpy.arccos(forward.clip(-1, 1))
    with numpy.errstate(invalid="ignore", divide="ignore"):
        if kind == "c":
            x, y = numpy.arctan2(right, forward), above / numpy.hypot(forward, right)
        else:
            r = {"a": t, "h": numpy.sin(t), "s": numpy.tan(t / 2), "v": numpy.tan(t)}[kind]
            x, y = r * right / numpy.sin(t), r * above / numpy.sin(t)
        x, y = x / wide - 2 * shift, y / high - 2 * lift
    in_front = t < math.pi / 2 if kind in "hv" else t < math.pi
    return in_front & (abs(x) <= 1) & (abs(y) <= 1)


@cache
def sphere(n=100_000):
    """Return evenly spread directions (a Fibonacci lattice), and the solid angle of each."""
    z = (numpy.arange(n) + 0.5) / n * 2 - 1
    azimuth = numpy.arange(n) * math.pi * (1 + math.sqrt(5))
    across = numpy.sqrt(1 - z * z)
    rays = numpy.stack([across * numpy.cos(azimuth), across * numpy.sin(azimuth), z], -1)
    return rays, 4 * math.pi / n


def rendered(view, radiance, fine=4):
    """Return the pixels of a view, each the mean over `fine` by `fine` points."""
    width, height = view[-1]
    x = (numpy.arange(width * fine) + 0.5) / (width * fine) * 2 - 1
    y = 1 - (numpy.arange(height * fine) + 0.5) / (height * fine) * 2
    rays, is_shown = shown(view, *numpy.meshgrid(x, y))
    values = numpy.where(is_shown, radiance(numpy.nan_to_num(rays)), 0)
    return values.reshape(height, fine, width, fine).mean((1, 3))


def radiance_file(path, view, pixels):
    """Write a Radiance picture with a VIEW= line; multiples of 1/16 up to 8 keep their values."""
    kind, across, upright, shift, lift, direction, up, _ = view
    words = f"VIEW= -vt{kind} -vp 1 2 3 -vd {direction} -vu {up} -vh {across} -vv {upright} "
    words += f"-vo 0 -va 0 -vs {shift} -vl {lift}"
    exponent = numpy.frexp(pixels)[1]
    mantissa = numpy.rint(numpy.ldexp(pixels, 8 - exponent)).clip(0, 255)
    rows = numpy.stack([mantissa] * 3 + [numpy.where(mantissa > 0, exponent + 128, 0)], -1)
    words = words.translate(str.maketrans(",", " ", "()"))
    path.write_bytes(hdr.picture(rows, hdr.flat, words))
    return str(path)


def answered(path, *words):
    done = run("environment", path, "--unit", "cd/m2", "--json", *words)
    answer = json.loads(done.stdout)
    rows = {name: row["value"] for name, row in answer["results"].items()}
    return rows, answer["assumptions"] + answer["notes"]


@pytest.mark.parametrize("view", VIEWS, ids=NAMES)
def test_a_uniform_radiance(view, tmp_path):
    path = radiance_file(tmp_path / "view.hdr", view, numpy.ones(view[-1][::-1]))
    rays, size = sphere()
    rays = rays[place(view, rays)]
    for normal in (view[5], (0, 0, 1), (0.3, -1, 0.2)):
        normal = numpy.array(normal) / numpy.linalg.norm(normal)
        rows, said = answered(path, f"--normal={','.join(map(str, normal))}")
        true = (rays @ normal).clip(0).sum() * size
        assert rows["illuminance"] == pytest.approx(true, abs=1e-3)
        assert rows["coverage"] == pytest.approx(len(rays) * size / 4 / math.pi, abs=1e-3)
        assert f"-vt{view[0]} -vh {view[1]} -vv {view[2]}" in "".join(said)
        share = next(text for text in said if "of the receiver's hemisphere" in text)
        assert float(share.split()[2]) == pytest.approx(100 * true / math.pi, rel=0.06, abs=0.5)


@pytest.mark.parametrize("view", VIEWS, ids=NAMES)
def test_a_radiance_that_varies(view, tmp_path):
    def radiance(rays):
        return 3 + rays[0] - rays[1] / 2 + rays[0] * rays[2]

    path = radiance_file(tmp_path / "view.hdr", view, rendered(view, radiance, 1))
    rays, size = sphere()
    rays = rays[place(view, rays)]
    for normal in (view[5], (0, 0, 1)):
        normal = numpy.array(normal) / numpy.linalg.norm(normal)
        rows, _ = answered(path, f"--normal={','.join(map(str, normal))}")
        true = (radiance(rays.T) * (rays @ normal).clip(0)).sum() * size
        assert rows["illuminance"] == pytest.approx(true, rel=6e-3)


@pytest.mark.parametrize("view", VIEWS, ids=NAMES)
def test_a_small_disc(view, tmp_path):
    """E = pi L sin^2 a cos t, for a disc of 1 cd/m2 with the half angle a, t from the normal."""
    half = math.radians(8)
    forward, right, above = axes(view[5], view[6])
    for x, y in [(0, 0), (-0.15, 0.12)]:
        toward = forward + x * right + y * above
        toward /= numpy.linalg.norm(toward)
        ring = axes(toward, above)
        turns = numpy.linspace(0, 2 * math.pi, 60)[:, None]
        rim = math.cos(half) * toward + math.sin(half) * (
            numpy.cos(turns) * ring[1] + numpy.sin(turns) * ring[2]
        )
        if not place(view, rim).all():
            continue
        pixels = rendered(
            view, lambda rays, s=toward: numpy.einsum("xij,x->ij", rays, s) > math.cos(half)
        )
        path = radiance_file(tmp_path / "view.hdr", view, pixels)
        rows, _ = answered(path, f"--normal={','.join(map(str, forward))}")
        true = math.pi * math.sin(half) ** 2 * (toward @ forward)
        assert rows["illuminance"] == pytest.approx(true, rel=0.02)
        rows, _ = answered(path, f"--toward={','.join(map(str, toward))}")
        assert rows["luminance-toward"] == 1


LENSES = [  # projection, field, and its distance from the middle by angle
    ("fisheye", 180, lambda t: t),
    ("fisheye", 220, lambda t: t),
    ("equisolid", 180, lambda t: math.sin(t / 2)),
    ("orthographic", 180, math.sin),
    ("orthographic", 140, math.sin),
    ("stereographic", 180, lambda t: math.tan(t / 2)),
]


def grey(path, pixels):
    """Write a map in full precision, without metadata."""
    pixels = numpy.asarray(pixels, numpy.float32)[..., None]
    write_picture(str(path), Picture(pixels, ("Y",), (1.0,), ""))
    return str(path)


@pytest.mark.parametrize(("projection", "field", "of"), LENSES)
def test_the_circle_of_a_lens(projection, field, of, tmp_path):
    """Whatever is outside the circle does not count; a disc is where the lens shows it."""
    n, half = 200, math.radians(field) / 2
    x = (numpy.arange(n) + 0.5) / n * 2 - 1
    x, y = numpy.meshgrid(x, -x)
    pixels = numpy.where(numpy.hypot(x, y) < 1.01, 1, 99)
    path = grey(tmp_path / "lens.pfm", pixels)
    words = ("--projection", projection, "--field", f"{field}deg")
    rows, said = answered(path, *words, "--normal=1,0,0")
    seen = math.sin(min(half, math.pi / 2)) ** 2
    assert rows["illuminance"] == pytest.approx(math.pi * seen, rel=2e-4)
    assert rows["coverage"] == pytest.approx((1 - math.cos(half)) / 2, rel=2e-4)
    assert f"{field} deg wide" in said[0]
    rows, _ = answered(path, *words, "--normal=0,0,1")
    if half == math.pi / 2:
        assert rows["illuminance"] == pytest.approx(math.pi / 2, rel=1e-3)
    # a small bright patch 40 degrees up is at that distance above the middle
    r = of(math.radians(40)) / of(half)
    spot = grey(tmp_path / "spot.pfm", numpy.where(numpy.hypot(x, y - r) < 0.03, 1, 0))
    rows, _ = answered(spot, *words, "--toward=50deg,0deg")
    assert rows["luminance-toward"] == 1
    assert rows["mean-luminance"] < 0.01


def test_perspective_and_cylindrical_have_square_pixels(tmp_path):
    """A square seen from its axis: E = 4 h atan(h) L, h = a/sqrt(1 + a^2) (here a = 1)."""
    path = grey(tmp_path / "flat.pfm", numpy.ones((150, 150)))
    rows, _ = answered(path, "--projection=perspective", "--field=90deg", "--normal=1,0,0")
    half = math.atan(math.sqrt(0.5)) * math.sqrt(0.5)
    assert rows["illuminance"] == pytest.approx(4 * half, rel=1e-6)
    assert rows["coverage"] == pytest.approx(1 / 6, rel=1e-6)  # a face of a cube
    high = 2 * math.tan(math.radians(30))  # of 2 pi: the pixels of the width 2 pi / 300
    path = grey(tmp_path / "round.pfm", numpy.ones((round(300 * high / 2 / math.pi), 300)))
    rows, _ = answered(path, "--projection=cylindrical", "--field=360deg")
    assert rows["coverage"] == pytest.approx(math.sin(math.radians(30)), rel=2e-3)


def test_the_words_of_the_user_win(tmp_path):
    view = VIEWS[0]
    path = radiance_file(tmp_path / "view.hdr", view, numpy.ones(view[-1][::-1]))
    for words, meaning in [
        (("--projection=angular",), "it is read as angular"),
        (("--projection=equisolid", "--field=180deg"), "it is read as equisolid, 180 deg wide"),
        (("--field=90deg",), "it is read as fisheye, 90 deg wide"),
    ]:
        _, said = answered(path, *words)
        note = "according to its file, the map is fisheye (VIEW= -vta -vh 180 -vv 180); " + meaning
        assert note in said
    _, said = answered(path, "--projection=fisheye")
    assert "according to its file, the map is fisheye (VIEW= -vta -vh 180 -vv 180)" in said
    _, said = answered(path, "--aim=0,1,0")
    assert "-1,0,0" not in said[0]
    assert "by its file" not in said[0]


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("--projection=fisheye",), "the field of view of the fisheye picture is missing"),
        (("--projection=angular", "--field=180deg"), "--field does not apply to an angular map"),
        (("--projection=perspective", "--field=180deg"), "cannot show 180 deg"),
        (("--projection=orthographic", "--field=190deg"), "cannot show 190 deg"),
        (("--field=180deg",), "the projection of the map is missing"),
    ],
)
def test_refusals(words, message, tmp_path):
    path = grey(tmp_path / "square.pfm", numpy.ones((50, 50)))
    done = run("environment", path, "--unit=cd/m2", *words)
    assert (done.returncode, done.stdout) == (2, "")
    assert message in done.stderr


def test_other_shapes_are_refused(tmp_path):
    path = grey(tmp_path / "wide.pfm", numpy.ones((50, 60)))
    done = run("environment", path, "--unit=cd/m2", "--projection=fisheye", "--field=180deg")
    assert "60 x 50 pixels are not square" in done.stderr
    parallel = ("l", 3, 2, 0, 0, (1, 0, 0), (0, 0, 1), (30, 20))
    path = radiance_file(tmp_path / "view.hdr", parallel, numpy.ones((20, 30)))
    done = run("environment", path, "--unit=cd/m2")
    assert "a parallel view (VIEW= -vtl -vh 3 -vv 2)" in done.stderr
