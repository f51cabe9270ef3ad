"""Maps of radiances, compared with closed forms, plain sums of many samples and definitions."""

import math

import numpy
import pytest
from distributions.maps.images import SIZES, TILTS, directions, image, solid_angles, unit

from radcalc.distributions import maps
from radcalc.distributions.maps import RadianceMap
from radcalc.errors import ConditionError


@pytest.mark.parametrize("projection", SIZES)
def test_a_constant_map(projection):
    """E = pi L in all directions: 3000 cd/m2 give 9424.78 lx."""
    width, height = (count // 4 for count in SIZES[projection])
    around = RadianceMap(numpy.full((height, width), 3000.0), projection, kind="v")
    assert around.solid_angle == pytest.approx(4 * math.pi, rel=1e-12)
    assert around.coverage == 1
    assert around.mean() == pytest.approx(3000, rel=1e-12)
    for normal in TILTS[::4]:
        found = around.irradiance(normal)
        assert found.value == pytest.approx(math.pi * 3000, rel=1e-6), normal
        assert abs(found.value - math.pi * 3000) <= found.error + 1e-6
    assert around.irradiances(TILTS[1::3]) == pytest.approx(math.pi * 3000, rel=1e-6)


@pytest.mark.parametrize(("projection", "bound"), [("latlong", 2e-6), ("mirror-ball", 5e-5)])
@pytest.mark.parametrize("height", [4, 7, 16, 33])
def test_a_constant_map_of_few_pixels(projection, bound, height):
    width = 2 * height if projection == "latlong" else height
    around = RadianceMap(numpy.ones((height, width)), projection)
    assert around.irradiances(TILTS) == pytest.approx(math.pi, rel=bound)


@pytest.mark.parametrize("projection", SIZES)
def test_a_map_of_a_cosine(projection):
    """L = 1 + x: E = pi + 2 pi/3 n . x, since max(0, cos) has the moments pi and 2 pi/3."""
    size = [count // 4 for count in SIZES[projection]]
    around = RadianceMap(image(projection, lambda x, y, z: 1 + x, size), projection)
    true = [math.pi + 2 * math.pi / 3 * unit(normal)[0] for normal in TILTS]
    assert around.irradiances(TILTS) == pytest.approx(true, abs=2e-4)


@pytest.mark.parametrize("projection", SIZES)
def test_the_overcast_sky(projection):
    """Moon and Spencer: Lz 9000 cd/m2 give 7 pi Lz / 9 = 21991.15 lx, and a wall 0.39618 of it.

    The wall: Lz (pi/6 + 4/9), the integral of (1 + 2 cos t)/3 sin(t)^2 cos(a) over a quarter.
    """
    aim = (1.0, 0.0, 0.0) if projection == "latlong" else (0.0, 0.0, 1.0)

    def sky(x, y, z):
        up = z if projection == "latlong" else x
        return numpy.where(up > 0, 9000 * (1 + 2 * up) / 3, up * 0)

    count = 1 if projection == "latlong" else 4  # the horizon lies across pixels
    size = [pixels // 2 for pixels in SIZES[projection]]
    around = RadianceMap(image(projection, sky, size, count), projection, aim, kind="v")
    level, *walls = around.irradiances([(0, 0, 1), (1, 0, 0), (0, 1, 0), (-3, 4, 0)])
    assert level == pytest.approx(21991.15, rel=5e-5)
    assert walls == pytest.approx([9000 * (math.pi / 6 + 4 / 9)] * 3, rel=1e-4)
    assert walls[0] / level == pytest.approx(0.39618, abs=3e-5)
    peak = around.peak()
    assert peak.value == pytest.approx(9000, rel=1e-4)
    assert peak.polar < 0.01


@pytest.mark.parametrize(
    ("projection", "aim"),
    [
        ("latlong", (1.0, 0.0, 0.0)),
        ("latlong", (0.3, -2.0, 1.0)),
        ("latlong", (0.0, 0.0, -1.0)),
        ("mirror-ball", (0.3, -2.0, 1.0)),
        ("angular", (0.0, 0.0, -1.0)),
    ],
)
def test_any_map_against_a_plain_sum(projection, aim):
    """Compare with the sum of L max(0, cos) over sample points in pixels of random size."""
    width, height = (48, 24) if projection == "latlong" else (40, 40)
    many = 16
    values = numpy.random.default_rng(3).exponential(size=(height, width)) ** 3
    around = RadianceMap(values, projection, aim)
    places = directions(projection, width * many, height * many)
    weights = solid_angles(projection, width * many, height * many)
    fine = values.repeat(many, 0).repeat(many, 1) * weights
    fine, places = fine[weights > 0], places[:, weights > 0]
    forward = unit(aim)
    left = unit(numpy.cross((0, 0, 1), forward)) if aim[:2] != (0, 0) else numpy.array([0, 1, 0])
    axes = numpy.array([forward, left, numpy.cross(forward, left)])
    true = [fine @ numpy.maximum(axes @ unit(normal) @ places, 0) for normal in TILTS]
    assert around.irradiances(TILTS) == pytest.approx(true, rel=2e-4)
    assert around.mean() == pytest.approx(fine.sum() / weights.sum(), rel=1e-4)


@pytest.mark.parametrize("projection", SIZES)
def test_a_single_bright_pixel(projection):
    """E is radiance times solid angle times cosine for any pixel, and the pixel is the peak."""
    width, height = SIZES[projection]
    width, height = width // 8, height // 8
    places, weights = (of(projection, width, height) for of in (directions, solid_angles))
    for row, column in [(20, 30), (31, 64), (12, 61)]:
        values = numpy.full((height, width), 1e-9)
        values[row, column] = 1e6
        around = RadianceMap(values, projection)
        where = places[:, row, column]
        peak = around.peak()
        assert peak.value == 1e6
        at = numpy.array(
            [
                math.sin(peak.polar) * math.cos(peak.azimuth),
                math.sin(peak.polar) * math.sin(peak.azimuth),
                math.cos(peak.polar),
            ]
        )
        assert at == pytest.approx(where, abs=1e-12)
        assert around.radiance(peak.polar, peak.azimuth) == 1e6
        aside = unit(where + numpy.full(3, 0.5))
        found = around.irradiances([where, aside, -where])
        cosine = aside @ where
        flux = 1e6 * weights[row, column]
        assert found[:2] == pytest.approx([flux, flux * cosine], rel=3e-3)
        assert found[2] < 1e-6


@pytest.mark.parametrize("projection", ["mirror-ball", "angular"])
def test_a_bright_pixel_that_the_circle_cuts(projection):
    """Plain sums over its parts inside the circle, for all pixels of two rows next to the rim."""
    size, many = 64, 40
    for row, column in [(0, 24), (1, 21), (24, 0), (39, 63)]:
        part = (column * many, row * many, many, many)
        places, weights = (
            of(projection, size * many, size * many, part) for of in (directions, solid_angles)
        )
        inside = weights > 0
        assert 0 < inside.sum() < inside.size
        values = numpy.zeros((size, size))
        values[row, column] = 1e9
        around = RadianceMap(values, projection)
        normals = numpy.array([unit((-1, 0, 0)), unit((-1, 0.5, 0.3))])
        true = numpy.maximum(normals @ places[:, inside], 0) @ (1e9 * weights[inside])
        assert around.irradiances(normals) == pytest.approx(true, rel=0.02)


def test_the_error_bound_holds_for_a_pixel_cut_at_its_corner():
    values = numpy.zeros((32, 64))
    values[15, 32] = 1e9
    around = RadianceMap(values, "latlong")
    parts = (numpy.arange(200) + 0.5) / 200
    azimuth = -(32 + parts) * 2 * math.pi / 64 + math.pi
    polar = (15 + parts[:, None]) * math.pi / 32
    x, y = numpy.sin(polar) * numpy.cos(azimuth), numpy.sin(polar) * numpy.sin(azimuth)
    places = numpy.stack([x, y, numpy.cos(polar) + 0 * x]).reshape(3, -1)
    weights = (numpy.sin(polar) + 0 * x).ravel() * (2 * math.pi / 64 * math.pi / 32 / 200**2)
    for third in numpy.linspace(-0.72, 0.72, 13):
        normal = unit((-0.127, -0.7, third))
        true = 1e9 * weights @ numpy.maximum(normal @ places, 0)
        found = around.irradiance(normal)
        assert abs(found.value - true) <= found.error + 1e-6 * true


@pytest.mark.parametrize("projection", SIZES)
def test_radiance_is_the_value_of_the_pixel(projection):
    width, height = (32, 16) if projection == "latlong" else (21, 21)
    values = numpy.arange(width * height, dtype=float).reshape(height, width)
    around = RadianceMap(values, projection)
    x, y, z = directions(projection, width, height)
    inside = ~numpy.isnan(x)
    polar, azimuth = numpy.arccos(z[inside]), numpy.arctan2(y[inside], x[inside])
    assert around.radiance(polar, azimuth).tolist() == values[inside].tolist()
    assert around.radiance(float(polar[5]), float(azimuth[5])) == values[inside][5]


def test_a_part_of_an_image():
    """A rectangle of a map, in its frame, is the map with 0 elsewhere; it covers less."""
    values = numpy.random.default_rng(4).random((64, 128, 3))
    left, top, columns, rows = 17, 5, 50, 41
    part = values[top : top + rows, left : left + columns]
    padded = numpy.zeros_like(values)
    padded[top : top + rows, left : left + columns] = part
    weights = (0.2, 0.7, 0.1)
    whole = RadianceMap(padded, "latlong", weights=weights)
    around = RadianceMap(part, "latlong", weights=weights, frame=(left, top, 128, 64))
    edges = [math.cos(math.pi * row / 64) for row in (top, top + rows)]
    solid_angle = 2 * math.pi * columns / 128 * (edges[0] - edges[1])
    assert around.coverage == pytest.approx(solid_angle / 4 / math.pi, rel=1e-12)
    assert around.irradiances(TILTS) == pytest.approx(whole.irradiances(TILTS), rel=1e-12)
    assert around.mean() == pytest.approx(whole.mean() / around.coverage, rel=1e-12)
    assert around.peak() == pytest.approx(whole.peak(), rel=1e-12)
    polar, azimuth = numpy.random.default_rng(5).random((2, 200)) * [[math.pi], [2 * math.pi]]
    assert around.radiance(polar, azimuth) == pytest.approx(whole.radiance(polar, azimuth))


def test_channels_and_factor():
    """The weighted sum of the channels' irradiances is the irradiance; a factor scales all."""
    values = numpy.random.default_rng(6).random((32, 64, 3)).astype(numpy.float16)
    around = RadianceMap(values, "latlong", weights=(0.2126, 0.7152, 0.0722), factor=179.0)
    each = around.irradiances(TILTS, is_each=True)
    assert each.shape == (len(TILTS), 3)
    sums = each @ [0.2126, 0.7152, 0.0722]
    assert around.irradiances(TILTS) == pytest.approx(sums, rel=1e-12)
    red = RadianceMap(values[..., 0].astype(float), "latlong", factor=179.0)
    assert red.irradiances(TILTS) == pytest.approx(each[:, 0], rel=1e-12)


def test_progress_is_reported():
    told = []
    around = RadianceMap(numpy.ones((128, 256)), "latlong")
    around.irradiances(TILTS, progress=lambda done, of: told.append((done, of)))
    assert [done for done, _ in told] == sorted({done for done, _ in told})
    assert told[-1][0] == told[-1][1]


class Chunks:
    """Rows of an image, made when they are read; it counts the most rows at a time."""

    def __init__(self, image):
        self.image, self.most, self.read = image, 0, 0
        self.shape, self.dtype = image.shape, image.dtype

    def __getitem__(self, key):
        rows = self.image[key]
        self.most, self.read = max(self.most, len(rows)), self.read + len(rows)
        return rows


def test_no_more_than_a_strip_is_read_at_a_time(monkeypatch):
    monkeypatch.setattr(maps, "STRIP", 1 << 13)
    values = numpy.random.default_rng(7).random((128, 256, 1), dtype=numpy.float32)
    rows = Chunks(values)
    around, same = RadianceMap(rows, "latlong"), RadianceMap(values, "latlong")
    assert rows.most <= 32
    assert rows.read == 128  # once
    assert around.irradiance((1, 2, 3)) == same.irradiance((1, 2, 3))
    assert around.peak() == same.peak()


def test_dask_arrays():
    import dask.array

    values = numpy.random.default_rng(8).random((96, 192, 3))
    lazy = dask.array.from_array(values, chunks=(25, 50, 3))
    weights = (0.3, 0.6, 0.1)
    around, same = (RadianceMap(one, "latlong", weights=weights) for one in (lazy, values))
    assert around.irradiance((1, 2, 3)) == same.irradiance((1, 2, 3))
    assert (around.mean(), around.peak()) == (same.mean(), same.peak())
    assert around.radiance(1.0, 2.0) == same.radiance(1.0, 2.0)
    assert (around.irradiances(TILTS, True) == same.irradiances(TILTS, True)).all()


def test_a_signalling_nan_is_refused_without_a_warning():
    """Half floats are widened to signalling NaN, about which NumPy warns."""
    pixels = numpy.ones((4, 8, 3), numpy.float32)
    pixels.view(numpy.uint32)[1, 2, 1] = 0x7F800001
    with pytest.raises(ConditionError, match=r"column 2 of row 1, .* is nan"):
        RadianceMap(pixels, "latlong", weights=(0.2, 0.7, 0.1))


@pytest.mark.parametrize("bad", [math.nan, math.inf, -math.inf, -1e-30])
def test_invalid_pixels_are_refused(bad):
    values = numpy.ones((64, 128, 3), numpy.float32)
    values[40, 17, 1] = bad
    values[50, 3, 0] = bad
    with pytest.raises(ConditionError) as caught:
        RadianceMap(values, "latlong", weights=(1, 1, 1))
    assert "column 17 of row 40" in caught.value.message
    part = {"frame": (10, 20, 256, 128)}
    with pytest.raises(ConditionError, match="column 27 of row 60"):
        RadianceMap(values, "latlong", weights=(1, 1, 1), **part)


@pytest.mark.parametrize("projection", ["mirror-ball", "angular"])
def test_pixels_outside_the_circle_may_have_any_value(projection):
    clean = numpy.random.default_rng(9).random((20, 20))
    around = RadianceMap(clean, projection)
    lit = around.irradiances(TILTS[-4:])  # one of their horizons passes next to the rim
    values = clean.copy()
    values[[0, 0, -1, -1], [0, -1, 0, -1]] = math.nan, -math.inf, 1e30, -1.0
    other = RadianceMap(values, projection)
    assert other.irradiances(TILTS[-4:]).tolist() == lit.tolist()
    assert other.peak() == around.peak()


@pytest.mark.parametrize(
    ("shape", "projection", "words"),
    [
        ((1, 1), "latlong", "are not a latlong map"),
        ((1, 1), "angular", "too few"),
        ((1, 2), "latlong", "too few"),
        ((512, 512), "latlong", "are not a latlong map"),
        ((512, 1024), "mirror-ball", "are not a mirror-ball map"),
        ((512, 384), "latlong", "a map on a cube"),
        ((384, 512), "angular", "a map on a cube"),
        ((128, 768), "latlong", "a map on a cube"),
        ((768, 128, 3), "angular", "a map on a cube"),
        ((512,), "latlong", "shape"),
        ((0, 0), "latlong", "shape"),
    ],
)
def test_wrong_shapes_are_refused(shape, projection, words):
    weights = (1.0,) * shape[2] if len(shape) == 3 else None
    with pytest.raises(ConditionError, match=words):
        RadianceMap(numpy.ones(shape), projection, weights=weights)


def test_other_refusals():
    ones = numpy.ones((8, 16, 3))
    for pixels, given, words in [
        (ones, {}, "3 channels have 1 weights"),
        (ones, {"weights": (1, 2)}, "3 channels have 2 weights"),
        (ones[..., 0], {"frame": (-1, 0, 32, 16)}, "do not fit in an image"),
        (ones[..., 0], {"frame": (20, 0, 32, 16)}, "do not fit in an image"),
        (ones[..., 0] + 1j, {}, "complex"),
        (ones[..., 0], {"aim": (0, 0, 0)}, "no direction"),
    ]:
        with pytest.raises(ConditionError, match=words):
            RadianceMap(pixels, "latlong", **given)
    with pytest.raises(ConditionError, match="unknown projection"):
        RadianceMap(ones[..., 0], "cube")
    with pytest.raises(ConditionError, match="no direction"):
        RadianceMap(ones[..., 0], "latlong").irradiance((0, 0, 0))
