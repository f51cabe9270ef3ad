"""Maps of skies: sums over pixels compared with the sky, and with Radiance's skies."""

import math
import platform
import re

import numpy as np
import pytest
from conftest import run

from radcalc.distributions.environments import Sky
from radcalc.distributions.maps import RadianceMap
from radcalc.distributions.maps.pictures import read_picture
from radcalc.distributions.maps.rendered import Sun, sky_map
from radcalc.errors import ConditionError

PLACE = (math.radians(50), math.radians(30))


def summed(pixels, normal):
    """Return the irradiance by a plain sum over the pixels of a latlong map, +x at its centre."""
    height, width = pixels.shape
    lit = np.flatnonzero(pixels.any(1))
    pixels, polar = pixels[lit], ((lit + 0.5) * math.pi / height)[:, None]
    azimuth = math.pi - (np.arange(width) + 0.5) * 2 * math.pi / width
    axes = np.sin(polar) * np.cos(azimuth), np.sin(polar) * np.sin(azimuth), np.cos(polar)
    cosine = sum(n * axis for n, axis in zip(normal, axes, strict=True)) / math.hypot(*normal)
    solid = np.sin(polar) * (math.pi / height) * (2 * math.pi / width)
    return float((pixels.astype(float) * cosine.clip(0) * solid).sum())


@pytest.mark.parametrize("normal", [(0, 0, 1), (1, 0, 0), (0, -1, 0), (2, 3, 1)])
@pytest.mark.parametrize("name", ["overcast", "uniform", "1", "7", "12", "15"])
def test_a_map_gives_the_irradiance_of_its_sky(name, normal):
    sky = Sky(name, PLACE if name in ("7", "12", "15") else None, 3000.0, "v")
    picture = sky_map(sky, 1024, 512)
    assert (picture.unit, picture.channels) == ("cd/m2", ("Y",))
    found = summed(picture.pixels[:, :, 0], normal)
    assert found == pytest.approx(sky.irradiance(normal).value, rel=1e-4)
    assert not picture.pixels[256:].any()


@pytest.mark.parametrize("size", [(64, 32), (1024, 512), (4096, 2048)])
def test_the_sun_in_a_map_has_its_irradiance(size):
    sky, sun = Sky("5", zenith=0.0, kind="v"), Sun(*PLACE, math.radians(0.2666), 8e4)
    pixels = sky_map(sky, *size, sun).pixels[:, :, 0]
    toward = (
        math.sin(PLACE[0]) * math.cos(PLACE[1]),
        math.sin(PLACE[0]) * math.sin(PLACE[1]),
        math.cos(PLACE[0]),
    )
    # a pixel of 64 is 5.6 degrees wide, and its light not all in its middle
    assert summed(pixels, toward) == pytest.approx(8e4, rel=2e-3)
    for normal in ((0, 0, 1), (1, 0, 0), (0, 1, 0)):
        cosine = sum(n * t for n, t in zip(normal, toward, strict=True))
        assert summed(pixels, normal) == pytest.approx(8e4 * cosine, rel=2e-3)
    if size[0] == 4096:  # where it is well resolved, its luminance is that of the disc
        disc = math.pi * math.sin(math.radians(0.2666)) ** 2
        assert pixels.max() == pytest.approx(8e4 / disc, rel=0.03)


def test_the_sun_across_the_seam_and_at_the_zenith():
    for place in ((1.0, math.pi), (0.0, 0.0), (math.pi / 2, -math.pi / 2)):
        pixels = sky_map(Sky("5", kind="e"), 512, 256, Sun(*place, 0.00465, 1000.0)).pixels[..., 0]
        pixels = pixels - sky_map(Sky("5", kind="e"), 512, 256).pixels[..., 0]
        toward = (
            math.sin(place[0]) * math.cos(place[1]),
            math.sin(place[0]) * math.sin(place[1]),
            math.cos(place[0]),
        )
        assert summed(pixels, toward) == pytest.approx(1000, rel=2e-3)


@pytest.mark.parametrize("degrees", [1, 3, 17, 48.7, 89.9, 90])
@pytest.mark.parametrize("radius", [0.001, 0.2666, 0.9])
def test_a_sun_in_few_pixels_gives_the_ground_its_light(degrees, radius):
    polar = math.radians(90 - degrees)
    sun = Sun(polar, 2.7, math.radians(radius), 8e4)
    pixels = sky_map(Sky("5", zenith=0.0, kind="v"), 128, 64, sun).pixels
    found = RadianceMap(pixels, "latlong", kind="v").irradiance((0.0, 0.0, 1.0)).value
    assert found == pytest.approx(8e4 * math.cos(polar), rel=1e-6)


@pytest.mark.parametrize("name", ["overcast", "7", "12", "15"])
def test_a_pixel_of_a_coarse_map_has_its_mean(name):
    sky = Sky(name, None if name == "overcast" else PLACE, 3000.0, "v")
    coarse = sky_map(sky, 32, 16).pixels[:, :, 0]
    fine = sky_map(sky, 2048, 1024).pixels[:, :, 0].astype(float)
    sine = np.sin((np.arange(1024) + 0.5) * math.pi / 1024)[:, None]
    means = (fine * sine).reshape(16, 64, 32, 64).sum(axis=(1, 3))
    means /= 64 * sine.reshape(16, 64).sum(axis=1)[:, None]
    assert coarse == pytest.approx(means, rel=1e-4 if name == "overcast" else 2e-3)


@pytest.mark.parametrize(
    ("size", "message"), [((100, 60), "latlong"), ((62, 31), "across the horizon")]
)
def test_an_impossible_size_is_refused(size, message):
    with pytest.raises(ConditionError, match=message):
        sky_map(Sky("5", kind="v"), *size)


@pytest.mark.parametrize("extension", ["pfm", "hdr"])
def test_a_saved_map(tmp_path, extension):
    path = tmp_path / f"sky.{extension}"
    words = "overcast --zenith-luminance 9000cd/m2 --size 128x64 -q -g zenith-luminance"
    done = run("sky", *words.replace(" -q", "").split(), "--save", str(path))
    assert (done.returncode, done.stdout) == (0, "9000\n")
    assert "a latlong map of 128 x 64 pixels in cd/m2" in done.stderr
    # 7 pi / 9 of the zenith's
    told = re.search(r"its pixels give the ground (\S+) lx \(error: (\S+) %\)", done.stderr)
    assert float(told[1]) == pytest.approx(7000 * math.pi, rel=3e-4)
    assert float(told[2]) == pytest.approx(100 * (float(told[1]) / 7000 / math.pi - 1), abs=5e-3)
    lost = {"pfm": "PFM does not store the unit (cd/m2)", "hdr": "RGBE has a resolution of 1/256"}
    assert f"note: {lost[extension]}" in done.stderr
    picture = read_picture(str(path))
    pixels = picture.pixels[:, :, 0] if extension == "pfm" else picture.pixels @ picture.weights
    assert summed(pixels, (0, 0, 1)) == pytest.approx(7000 * math.pi, rel=5e-3)
    assert [one.name for one in tmp_path.iterdir()] == [path.name]


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ("overcast --tilt 9deg --save {}", "the brightness of the sky"),
        ("overcast --zenith-luminance 1cd/m2 --save {}.png", "cannot be written as .png"),
        ("overcast --zenith-luminance 1e40cd/m2 --save {}", "cannot hold values above 3e+38 cd/m2"),
        ("overcast --zenith-luminance 1e-40cd/m2 --save {}", "would be almost black"),
        ("overcast --zenith-luminance 1cd/m2 --save no/{}", "does not exist"),
        ("overcast --zenith-luminance 1cd/m2,2cd/m2 --save {}", "one map is written at a time"),
        ("overcast --zenith-luminance 1cd/m2 --size 4x2", "--size does not apply without --save"),
        ("overcast --zenith-luminance 1cd/m2 --size 4x3 --save {}", "--size 6x3"),
        ("overcast --zenith-luminance 1cd/m2 --check 3lx --save {}", "--check does not apply"),
        ("overcast --zenith-luminance 1cd/m2 -n --save {}", "-n prints one number"),
        ("overcast --zenith-luminance 1cd/m2 -g nonsense --save {}", "unknown result 'nonsense'"),
        ("overcast --zenith-luminance 1cd/m2 -g irradiance --save {}", "no plane is given"),
        ("overcast --zenith-luminance 1cd/m2 -g zenith-luminance:lx --save {}", "illuminance"),
        (
            "clear --sun-elevation 9deg --zenith-luminance 1cd/m2 --save {}",
            "the sun's azimuth is missing",
        ),
        (
            "clear --sun-elevation 9deg --sun-azimuth 0deg --horizontal-illuminance 1lx "
            "--global-illuminance 0.5lx --save {}",
            "less than one of them",
        ),
    ],
)
def test_impossible_maps_are_not_saved(tmp_path, words, message):
    done = run("sky", *words.format("sky.hdr").split(), cwd=tmp_path)
    assert (done.returncode, done.stdout) == (2, "")
    assert message in done.stderr
    assert not list(tmp_path.iterdir())


try:
    import pyradiance
except ImportError:
    if platform.machine() != "aarch64":  # there is no wheel for aarch64
        raise
    pyradiance = None


@pytest.mark.skipif(pyradiance is None, reason="pyradiance is not installed")
@pytest.mark.parametrize("degrees", [10, 30, 45, 60, 80])
def test_radiance_has_the_same_zenith_of_a_horizontal_irradiance(degrees):
    """Its gensky has the traditional overcast sky, and a fit of the clear one, CIE type 12."""
    place = (math.pi / 2 - math.radians(degrees), 0.0)
    for sky, kind, close in (
        (Sky("overcast"), {"cloudy": True}, 2e-4),  # of the four digits that it prints
        (Sky("clear", place), {"sunny_without_sun": True}, 3e-3),
    ):
        text = pyradiance.gensky(
            altitude=degrees, azimuth=20, horizontal_brightness=100, **kind
        ).decode()
        zenith = float(text.split("skybright.cal")[1].split()[3])
        assert zenith == pytest.approx(100 / sky.irradiance((0, 0, 1)).value, rel=close)
