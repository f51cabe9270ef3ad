"""Light from all around on a receiver: expressions, skies and maps."""

import csv
import io
import math
import re

import numpy
import OpenImageIO
import pytest
from conftest import python, run
from distributions.maps import hdr
from helpers import results

import radcalc
from radcalc.distributions.maps.pictures import REC_709, Picture, read_picture, write_picture
from radcalc.geometry.projections import direction_at, middle_of_pixel

LIT = 9424.77796076938  # lx: pi times 3000 cd/m2


def asked(*words: str) -> list[float]:
    """Return the numbers that a call prints."""
    done = run("environment", *words, "-q", "--precision", "15")
    assert not done.stderr, done.stderr
    return [float(number) for number in done.stdout.split()]


def written(path, pixels, weights=REC_709, unit=""):
    """Write a map, of one channel or of R, G and B, and return its path."""
    pixels = numpy.asarray(pixels, numpy.float32)
    channels = ("Y",) if pixels.ndim == 2 else ("R", "G", "B")
    pixels = pixels.reshape(*pixels.shape[:2], -1)
    weights = weights if len(channels) == 3 else (1.0,)
    write_picture(str(path), Picture(pixels, channels, weights, "", unit))
    return str(path)


def overcast(projection, width, height):
    """Return an image of an overcast sky with 9000 cd/m2 in the zenith and a dark ground."""
    rows, columns = numpy.mgrid[:height, :width]
    places = middle_of_pixel(width, height, columns, rows)
    up = direction_at(projection, *places)[2]
    return numpy.where(up > 0, 3000 * (1 + 2 * up), 0.0)  # outside of a circle up is NaN


# -- expressions ----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("source", "normal", "expected"),
    [
        ("3000 cd/m2", "0,0,1", LIT),
        ("3000 cd/m2", "1,2,-3", LIT),
        # the integral of cos^2 over the upper half is 2 pi/3
        ("3000*max(cos(theta), 0) cd/m2", "0,0,1", 2000 * math.pi),
        ("3000*max(cos(theta), 0) cd/m2", "0,0,-1", 0),
        # and over a quarter of the sphere that of cos(theta) x is 2/3
        ("3000*max(cos(theta), 0) cd/m2", "1,0,0", 2000),
        # a uniform upper half on a plane that is tilted by b: pi L (1 + cos b)/2
        ("3000*(theta < 90*deg) cd/m2", "1,0,1", LIT * (1 + math.sqrt(0.5)) / 2),
        # a disc of half angle a about the normal: pi L sin^2 a
        ("3*(theta < 30*deg) kcd/m2", "0,0,1", LIT / 4),
    ],
)
def test_an_expression_has_its_closed_form(source, normal, expected):
    (found,) = asked(source, "--normal", normal, "-g", "irradiance:lx")
    assert found == pytest.approx(expected, rel=1e-6, abs=1e-9)


def test_the_mean_is_weighted_by_solid_angle_and_the_peak_has_a_direction():
    source = "(x + 1)*100 cd/m2"
    found = asked(
        source,
        *["-g", "mean-radiance", "-g", "peak-radiance", "-g", "peak-polar", "-g", "peak-azimuth"],
    )
    assert found == pytest.approx([100, 200, 90, 0], abs=1e-6)
    assert asked(source, "--toward", "-1,0,0", "-g", "radiance-toward:cd/m2") == [0]
    assert asked(source, "--toward", "60deg:90deg:30deg,0deg", "-g", "radiance-toward") == (
        pytest.approx([100 + 100 * math.sin(math.pi / 3), 200])
    )
    found = results(run("environment", source, "--json").stdout)
    letters = {name: row["symbol"] for name, row in found.items()}
    # polar angle and azimuth, not gamma and C of a luminaire
    assert (letters["peak-polar"], letters["peak-azimuth"]) == ("θ_max", "φ_max")


@pytest.mark.parametrize("source", ["3 cd/m2", "sky:uniform", "{}"])
def test_a_uniform_environment_has_no_direction_of_its_peak(tmp_path, source):
    path = written(tmp_path / "ones.exr", numpy.ones((32, 64)), unit="cd/m2")
    done = run("environment", source.format(path))
    assert "note: the radiance is the same in all covered directions" in done.stderr
    assert ("peak-radiance" if source == "sky:uniform" else "peak-luminance") in done.stdout
    assert "peak-polar" not in done.stdout
    asked_for = run("environment", source.format(path), "-g", "peak-azimuth")
    assert (asked_for.returncode, asked_for.stdout) == (2, "")
    assert "the same in all directions" in asked_for.stderr


def test_the_rotation_of_a_map_centred_on_the_zenith_is_stated(tmp_path):
    """A bright pixel left of the middle is then towards +y."""
    pixels = numpy.zeros((32, 64))
    pixels[15:17, 15:17] = 1.0
    path = written(tmp_path / "left.pfm", pixels)
    for aim in ("0,0,1", "0,0,-1"):
        done = run("environment", path, "--unit", "1", "--aim", aim, "-g", "peak-azimuth:deg")
        assert float(done.stdout) == pytest.approx(90, abs=4)
        assert "pixels, with +y on the left\n" in done.stderr
    assert "on the left" not in run("environment", path, "--unit", "1", "--aim", "0,1,1").stderr


def test_answers_to_a_list_of_directions_have_the_direction():
    words = ["(x + 1)*100 cd/m2", "--toward", "60deg:90deg:30deg,0deg", "--format"]
    rows = csv.DictReader(io.StringIO(run("environment", *words, "csv").stdout))
    found = [[float(row[name]) for name in ("polar:deg", "azimuth:deg")] for row in rows]
    assert found == [pytest.approx([60, 0]), pytest.approx([90, 0])]


def test_a_linked_kind_is_shown_as_well():
    words = ["1 W/m2/sr", "--wavelength", "555nm"]
    found = asked(*words, "-g", "illuminance:lx", "-g", "mean-luminance:cd/m2")
    assert found == pytest.approx([683 * math.pi, 683], rel=1e-5)  # V(555 nm) is 1 within 1e-5
    assert asked("683 cd/m2", "--efficacy", "683lm/W", "-g", "irradiance:W/m2") == (
        pytest.approx([math.pi])
    )


def test_a_relative_environment_has_no_unit_of_light():
    done = run("environment", "1")
    assert "irradiance\t3.14159265359\tsr" in done.stdout
    assert "mean-radiance\t1\t1" in done.stdout
    assert "so are all results" in done.stderr
    found = results(run("environment", "1", "--json").stdout)
    assert found["irradiance"]["quantity"] == "relative irradiance"
    assert {row["unit"] for row in found.values()} <= {"sr", "1", "deg"}


def test_a_number_is_checked():
    done = run("environment", "3000*max(cos(theta), 0) cd/m2", "--check", "illuminance=6283lx")
    assert done.returncode == 0
    assert done.stdout.startswith("right")


# -- maps -----------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "shape", "projection"),
    [
        ("around.exr", (64, 128), ()),
        ("around.pfm", (64, 128), ("--projection", "latlong")),
        ("around.exr", (128, 128), ("--projection", "mirror-ball")),
        ("around.pfm", (128, 128), ("--projection", "angular")),
    ],
)
@pytest.mark.parametrize("normal", ["0,0,1", "3,-1,-2"])
def test_a_constant_map_has_an_irradiance_of_pi_times_its_radiance(
    tmp_path, name, shape, projection, normal
):
    path = written(tmp_path / name, numpy.full(shape, 3000.0))
    words = [path, *projection, "--unit", "cd/m2", "--normal", normal]
    found = asked(*words, "-g", "irradiance:lx", "-g", "mean-radiance", "-g", "coverage")
    assert found == pytest.approx([LIT, 3000, 1], rel=1e-5)


@pytest.mark.parametrize(
    ("projection", "shape"),
    [("latlong", (64, 128)), ("mirror-ball", (128, 128)), ("angular", (80, 80))],
)
def test_an_overcast_sky_is_the_same_in_every_projection(tmp_path, projection, shape):
    """Closed forms: 7 pi Lz/9 on the ground, 0.39618 of it on a wall, half of that as the mean."""
    height, width = shape
    path = written(tmp_path / "sky.pfm", overcast(projection, width, height))
    words = [path, "--projection", projection, "--unit", "cd/m2", "--toward", "0deg"]
    up = asked(*words, "-g", "irradiance:lx", "-g", "mean-radiance", "-g", "radiance-toward")
    assert up == pytest.approx([7000 * math.pi, 3000, 9000], rel=2e-3)
    (wall,) = asked(*words, "--normal", "0,-1,0", "-g", "irradiance:lx")
    assert wall == pytest.approx(0.39618 * up[0], rel=2e-3)


def test_the_centre_of_a_map_is_its_aim(tmp_path):
    """A bright pixel left of the middle is towards +y, or left of the aim; in a ball right."""
    pixels = numpy.zeros((32, 64))
    pixels[15:17, 15:17] = 1.0
    path = written(tmp_path / "left.pfm", pixels)
    names = ("-g", "peak-polar:deg", "-g", "peak-azimuth:deg")
    near = {"abs": 4}  # at the centre of the nearest pixel
    assert asked(path, "--unit", "1", *names) == pytest.approx([90, 90], **near)
    aimed = asked(path, "--unit", "1", "--aim", "0,1,0", *names)
    assert aimed == pytest.approx([90, 180], **near)
    ball = numpy.zeros((65, 65))
    ball[32, 32 + 23] = 1.0  # u of 23 (2/65), about sin(45 deg), at which the view is turned by 90
    path = written(tmp_path / "ball.pfm", ball)
    words = [path, "--unit", "1", "--projection", "mirror-ball"]
    assert asked(*words, *names) == pytest.approx([90, 90], **near)
    assert asked(*words, "--aim", "-1,0,0", *names) == pytest.approx([90, 270], **near)


def test_the_luminance_of_colours_depends_on_their_primaries(tmp_path):
    """Rec. 709 in cd/m2; Radiance's primaries in W/m2/sr, with 179 lm/W."""
    colours = numpy.full((16, 32, 3), [1.0, 2.0, 3.0])
    path = written(tmp_path / "colours.pfm", colours)
    luminance = 0.2126 + 2 * 0.7152 + 3 * 0.0722
    brightness = 0.265 + 2 * 0.670 + 3 * 0.065
    assert asked(path, "--unit", "kcd/m2", "-g", "mean-radiance:cd/m2") == (
        pytest.approx([1000 * luminance])
    )
    assert asked(path, "--unit", "1", "-g", "mean-radiance") == pytest.approx([luminance])
    words = [path, "--unit", "W/m2/sr"]
    found = asked(
        *words, "-g", "mean-radiance", "-g", "mean-luminance:cd/m2", "-g", "illuminance:lx"
    )
    assert found == pytest.approx([brightness, 179 * brightness, 179 * math.pi * brightness])
    assert "179 lm" in run("environment", *words).stderr
    given = [*words, "--efficacy", "100lm/W"]
    assert asked(*given, "-g", "mean-luminance:cd/m2") == pytest.approx([100 * brightness])
    assert "179 lm" not in run("environment", *given).stderr
    assert asked(*words, "--channel", "b", "-g", "mean-radiance") == pytest.approx([3])
    own = written(tmp_path / "own.exr", colours, weights=(0.5, 0.25, 0.25))
    assert asked(own, "--unit", "cd/m2", "-g", "mean-radiance") == pytest.approx([1.75])
    assert asked(own, "--unit", "W/m2/sr", "-g", "mean-luminance") == pytest.approx([1.75 * 179])


def test_the_unit_of_a_map_is_in_the_file_or_given(tmp_path):
    ones = numpy.ones((16, 32))
    said = written(tmp_path / "said.exr", ones, unit="cd/m2")
    assert asked(said, "-g", "irradiance:lx") == pytest.approx([math.pi])
    done = run("environment", said, "--unit", "W/m2/sr", "-g", "irradiance:W/m2")
    assert float(done.stdout) == pytest.approx(math.pi)
    assert "the map is in cd/m2; it is read as in W/m2/sr" in done.stderr
    assert asked(said, "--unit", "umol/m2/s/sr", "-g", "irradiance:umol/m2/s") == (
        pytest.approx([math.pi])
    )


@pytest.mark.parametrize("channel", ["B", "L"])
def test_a_channel_of_a_file_that_has_no_colours_is_a_map(tmp_path, channel):
    """A channel with any name and the value 7 everywhere; blue alone is not proposed."""
    made = str(tmp_path / "one.exr")
    pixels = numpy.full((16, 32, 1), 7.0, numpy.float32)
    write_picture(made, Picture(pixels, (channel,), (1.0,), "", "1", "latlong"))
    words = ["--unit", "1", "--channel", channel.lower()]
    done = run("environment", made, "--unit", "1")
    assert done.returncode == 2
    call = f"radcalc environment {made} --unit 1 --channel L"
    # pi times the radiance of 7
    hint = f"{call}\n     irradiance 21.9911 sr" if channel == "L" else "a picture with R, G and B"
    assert f"it has {channel}\ntry: {hint}" in done.stderr
    assert asked(made, *words, "-g", "mean-radiance") == pytest.approx([7])
    assert f"assumed: the channel {channel} alone\n" in run("environment", made, *words).stderr


def test_a_layer_is_a_map_of_its_colours(tmp_path):
    """R, G and B of 1, 2 and 0.1: 0.2126 + 2 x 0.7152 + 0.1 x 0.0722, and 0.265 + 2 x 0.67 ..."""
    spec = OpenImageIO.ImageSpec(16, 8, 3, "float")
    for names, channel in ((".R .G .B", ()), ("beauty.R beauty.G beauty.B", ("beauty",))):
        path, spec.channelnames = str(tmp_path / "layer.exr"), names.split()
        file = OpenImageIO.ImageOutput.create(path)
        assert file.open(path, spec)
        assert file.write_image(numpy.full((8, 16, 3), [1, 2, 0.1], numpy.float32))
        file.close()
        words = [path, *(word for name in channel for word in ("--channel", name))]
        found = asked(*words, "--unit", "cd/m2", "-g", "illuminance:lx")
        assert found == pytest.approx([math.pi * (0.2126 + 2 * 0.7152 + 0.1 * 0.0722)])
        found = asked(*words, "--unit", "W/m2/sr", "-g", "irradiance:W/m2")
        assert found == pytest.approx([math.pi * (0.265 + 2 * 0.67 + 0.1 * 0.065)])
    done = run("environment", path, "--unit", "cd/m2")
    assert done.returncode == 2
    assert f"try: radcalc environment {path} --unit cd/m2 --channel beauty\n" in done.stderr


@pytest.mark.parametrize("picture", ["X Y Z", "lin_ciexyzd65_scene", "lin_rec709_scene", "hdr"])
def test_tristimulus_values_have_a_luminance_and_no_radiance(tmp_path, picture):
    """2, 1, 5 as X, Y, Z; as R, G, B of Rec. 709 they are a radiance as without a declaration."""
    path = str(tmp_path / ("map.hdr" if picture == "hdr" else "map.exr"))
    pixels = numpy.full((8, 16, 3), [2, 1, 5], numpy.float32)
    spec = OpenImageIO.ImageSpec(16, 8, 3, "float")
    if picture == "X Y Z":
        spec.channelnames = picture.split()
    elif picture != "hdr":
        spec.attribute("oiio:ColorSpace", picture)
    file = OpenImageIO.ImageOutput.create(path)
    assert file.open(path, spec)
    assert file.write_image(pixels)
    file.close()
    if picture == "hdr":
        with open(path, "rb") as made:
            data = made.read()
        with open(path, "wb") as made:
            made.write(data.replace(b"\n\n", b"\nPRIMARIES=1 0 0 1 0 0 .3333 .3333\n\n", 1))
    if picture == "lin_rec709_scene":
        found = asked(path, "--unit", "W/m2/sr", "-g", "mean-radiance")
        assert found == pytest.approx([2 * 0.265 + 0.67 + 5 * 0.065])
        return
    assert asked(path, "--unit", "cd/m2", "-g", "mean-luminance") == pytest.approx([1])
    for unit in ("W/m2/sr", "umol/m2/s/sr"):
        done = run("environment", path, "--unit", unit)
        assert done.returncode == 2
        assert "have no sum that is a radiance in this unit\n" in done.stderr
        assert f"try: radcalc environment {path} --unit cd/m2\n" in done.stderr


@pytest.mark.parametrize("extension", [".hdr", ".exr"])
def test_the_metadata_of_a_map_are_used_or_overridden_with_a_note(tmp_path, extension):
    path = str(tmp_path / f"own{extension}")
    pixels = numpy.ones((8, 8, 1), numpy.float32)
    pixels[4, 4] = 2
    write_picture(path, Picture(pixels, ("Y",), (1.0,), "", "cd/m2", "angular"))
    done = run("environment", path)
    assert "assumed: according to its file, the map is angular and in cd/m2\n" in done.stderr
    assert "note: " not in done.stderr
    for words, noted in (
        ("--projection mirror-ball", "is angular; it is read as mirror-ball"),
        ("--unit W/m2/sr", "is in cd/m2; it is read as in W/m2/sr"),
        ("--unit 1", "is in cd/m2; it is read as relative"),
    ):
        done = run("environment", path, *words.split())
        assert f"note: according to its file, the map {noted}\n" in done.stderr
        assert "so in cd/m2" not in done.stderr
    assert (
        "according to its file"
        not in run("environment", path, "--projection", "angular", "--unit", "cd/m2").stderr
    )


def test_a_map_is_read_once_for_a_list_of_directions(tmp_path):
    path = written(tmp_path / "sky.pfm", overcast("latlong", 64, 32))
    found = asked(
        path, "--unit", "cd/m2", "--toward", "0deg:180deg:90deg,0deg", "-g", "radiance-toward"
    )
    assert found == pytest.approx([9000, 0, 0], rel=0.01)


def test_the_derivation_has_the_weights_of_channels(tmp_path):
    path = written(tmp_path / "grey.pfm", numpy.ones((16, 32, 3)))
    done = run("environment", path, "--unit", "W/m2/sr", "--steps", "-q")
    assert "L = 0.265 R + 0.67 G + 0.065 B" in done.stderr
    assert "color.h" in done.stderr


@pytest.mark.parametrize(
    ("shape", "words", "message", "hint"),
    [
        (
            (16, 32),
            "",
            "the unit of the map is missing",
            ["--unit cd/m2", "--unit W/m2/sr", "--unit 1"],
        ),
        ((16, 32), "--unit lx", "a map has radiances, but that is illuminance", "--unit cd/m2"),
        ((16, 32), "--unit W/m2", "that is irradiance (W/m2)", "--unit W/m2/sr"),
        ((16, 32), "--unit umol/m2/s", "photon irradiance", "--unit umol/m2/s/sr"),
        ((16, 32), "--unit m", "that is length", ["--unit cd/m2", "--unit W/m2/sr", "--unit 1"]),
        ((16, 32), "--unit 3", "has a number in it", ""),
        (
            (16, 16),
            "--unit 1",
            "pixels fit several",
            [
                "--unit 1 --projection mirror-ball",
                "--unit 1 --projection angular",
                "--unit 1 --projection fisheye --field 180deg",
            ],
        ),
        (
            (16, 20),
            "--unit 1",
            "not a latlong map",
            "a latlong map, which is twice as wide as high",
        ),
        (
            (16, 64),
            "--unit 1",
            "not a latlong map",
            "a latlong map, which is twice as wide as high",
        ),
        ((12, 16), "--unit 1", "look like a map on a cube", "a latlong map"),
        ((16, 32), "--unit 1 --toward 60deg", "60deg has no azimuth", "--toward 60deg,90deg"),
        ((16, 16), "--unit 1 --projection latlong", "not a latlong map", "twice as wide"),
        ((16, 32), "--unit 1 --projection angular", "not an angular map", "square"),
        ((16, 32), "--unit 1 --channel R", "no channel 'R'", "--unit 1"),
        ((16, 32, 3), "--unit umol/m2/s/sr", "R, G, B have no sum", "--unit cd/m2"),
        ((16, 32, 3), "--unit 1 --channel x", "no channel 'x'", "--unit 1"),
        ((16, 32), "--unit 1 --sun-elevation 9deg", "--sun-elevation does not apply to a map", ""),
        ((16, 32), "--unit 1 --spectrum D65", "--spectrum does not apply to relative", ""),
        ((16, 32), "--unit 1 --aim 0,0,0", "--aim '0,0,0'", ""),
        ((1, 1), "--unit 1 --projection angular", "too few", "4 rows or more"),
    ],
)
def test_a_missing_property_of_a_map_is_required(tmp_path, shape, words, message, hint):
    path = written(tmp_path / "ones.pfm", numpy.ones(shape))
    done = run("environment", path, *words.split())
    assert (done.returncode, done.stdout) == (2, "")
    said, *told = done.stderr.splitlines()
    assert message in said
    assert told[0].startswith("try: ")
    if isinstance(hint, str):
        assert hint in told[0]
    else:
        calls = [line[5:] for line in told if not line.startswith(" ")]
        assert calls == [f"radcalc environment {path} {words}" for words in hint]


@pytest.mark.parametrize(
    ("data", "message"),
    [
        (b"", "is empty"),
        (b"version https://git-lfs.github.com/spec/v1\noid sha256:0\n", "Git LFS"),
        (b"\x89PNG\r\n\x1a\n", "PNG"),
        (b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 4 +X 8\n\x02\x02", "environment.hdr"),
        (b"PF\n65536 32768\n-1\n" + bytes(10), "more than"),
        (
            b"Pf\n8 4\n-1\n" + b"\0\0\x80\xbf" * 32,
            "column 0 of row 0, from 0 at the top left, is -1",
        ),
        (b"Pf\n8 4\n-1\n" + b"\0\0\xc0\x7f" * 32, "nan"),
    ],
)
def test_other_files_than_maps_are_refused_in_two_lines(tmp_path, data, message):
    path = tmp_path / "environment.hdr"
    path.write_bytes(data)
    done = run("environment", str(path), "--unit", "1")
    assert (done.returncode, done.stdout) == (2, "")
    said, told = done.stderr.splitlines()
    assert message in said
    assert told.startswith("try: ")


@pytest.mark.parametrize(
    ("words", "formula"),
    [
        ("--irradiance-map made.pfm --size 8x4", "E = integral of L max(n . s, 0) domega"),
        ("--irradiance-map made.pfm --size 8x4 --order 2", "E = sum of A_l L_lm Y_lm(n)"),
    ],
)
def test_the_derivation_of_a_written_map(tmp_path, words, formula):
    written(tmp_path / "colours.pfm", numpy.ones((16, 32, 3)))
    words = ["colours.pfm", "--unit", "cd/m2", *words.split()]
    done = run("environment", *words, "--steps", "-q", cwd=tmp_path)
    assert "L = 0.2126 R + 0.7152 G + 0.0722 B" in done.stderr
    assert formula in done.stderr
    assert not run("environment", *words, "-q", cwd=tmp_path).stderr


# -- arrays ---------------------------------------------------------------------------------------


def test_arrays_of_numpy_and_of_dask_are_maps():
    import dask.array

    pixels = numpy.random.default_rng(1).uniform(0, 5, (64, 128, 3))
    whole = radcalc.environment(pixels, unit="cd/m2", normal=(1, 1, 1))
    parts = dask.array.from_array(pixels, chunks=(10, 128, 3))
    again = radcalc.environment(parts, unit="cd/m2", normal=(1, 1, 1))
    assert again["irradiance"].to("lx").m == pytest.approx(
        whole["irradiance"].to("lx").m, rel=1e-12
    )
    own = radcalc.environment(radcalc.Quantity(pixels, "kcd/m2"), normal=(1, 1, 1))
    assert own["irradiance"].to("klx").m == pytest.approx(whole["irradiance"].to("lx").m)
    grey = radcalc.environment(numpy.full((8, 16), 2.0), unit="1")
    assert grey["irradiance"].units == radcalc.Quantity(1, "sr").units


def test_masked_pixels_are_refused_but_not_an_empty_mask():
    import dask.array

    pixels = numpy.ma.array(numpy.full((16, 32), 3.0), mask=False)
    assert radcalc.environment(pixels, unit="1")["irradiance"].m == pytest.approx(3 * math.pi)
    pixels[15, 20] = numpy.ma.masked
    for source in (
        pixels,
        radcalc.Quantity(pixels, "1"),
        dask.array.from_array(pixels, chunks=4, asarray=False),
    ):
        given = {} if isinstance(source, radcalc.Quantity) else {"unit": "1"}
        with pytest.raises(radcalc.errors.NumberError, match="map has masked elements"):
            radcalc.environment(source, **given)
        with pytest.raises(radcalc.errors.NumberError, match="map has masked elements"):
            radcalc.irradiance_map(source, (8, 4), **given)
    filled = radcalc.environment(pixels.filled(0), unit="1", normal=(0, 0, -1))
    assert filled["irradiance"].m < 3 * math.pi


@pytest.mark.parametrize(
    ("source", "given", "message"),
    [
        (numpy.ones((16, 32)), {}, "the unit of the map is missing"),
        (numpy.ones((16, 32, 4)), {"unit": "1"}, "are not a map"),
        (7, {"unit": "1"}, "are not a map"),
        (numpy.ones((16, 16)), {"unit": "1"}, "pixels fit several"),
        (radcalc.Quantity(numpy.ones((16, 32)), "lx"), {}, "a map has radiances"),
        (
            radcalc.Quantity(numpy.ones((16, 32)), "cd/m2"),
            {"unit": "cd/m2"},
            "with a map that has a unit",
        ),
        (numpy.full((16, 32), -1.0), {"unit": "1"}, "column 0 of row 0"),
        ("sky:5", {"zenith_luminance": radcalc.Quantity([1.0, 2.0], "cd/m2")}, "is an array"),
    ],
)
def test_other_values_than_maps_are_refused(source, given, message):
    with pytest.raises(radcalc.errors.RadcalcError, match=message):
        radcalc.environment(source, **given)


# -- skies ----------------------------------------------------------------------------------------


def test_a_sky_is_scaled_or_relative_to_its_zenith():
    """For (1 + 2 cos Z)/3: 7 pi/9 on the ground, and 0.39618 of it on a wall (CIE S 003)."""
    scaled = asked("sky:overcast", "--zenith-luminance", "9000cd/m2", "-g", "irradiance:lx")
    assert scaled == pytest.approx([7000 * math.pi])
    assert asked("sky:overcast", "-g", "irradiance:sr") == pytest.approx([7 * math.pi / 9])
    words = ["sky:overcast", "--horizontal-illuminance", "10klx"]
    (wall,) = asked(*words, "--normal", "1,0,0", "-g", "irradiance:lx")
    assert wall == pytest.approx(3961.8, rel=1e-5)
    assert asked(*words, "--toward", "0deg", "-g", "radiance-toward:cd/m2") == (
        pytest.approx([90000 / 7 / math.pi])
    )


def test_a_sky_is_rotated_to_the_suns_azimuth():
    words = ["sky:clear", "--sun-elevation", "40deg", "--sun-azimuth", "70deg"]
    assert asked(*words, "-g", "peak-polar", "-g", "peak-azimuth") == pytest.approx([50, 70])


# -- maps that are written ------------------------------------------------------------------------


def test_an_irradiance_map_of_a_constant_is_pi_times_it(tmp_path):
    path = written(tmp_path / "around.pfm", numpy.full((16, 32, 3), [1000.0, 2000.0, 3000.0]))
    made = str(tmp_path / "lux.exr")
    done = run("environment", path, "--unit", "cd/m2", "--irradiance-map", made, "--json")
    rows = results(done.stdout)
    luminance = 1000 * (0.2126 + 2 * 0.7152 + 3 * 0.0722)
    for name in ("minimum-illuminance", "maximum-illuminance"):
        assert rows[name]["value"] == pytest.approx(math.pi * luminance, rel=1e-5)
        assert rows[name]["unit"] == "lx"
    found = read_picture(made)
    assert found.pixels.shape == (32, 64, 3)
    expected = numpy.broadcast_to([1000 * math.pi, 2000 * math.pi, 3000 * math.pi], (32, 64, 3))
    assert found.pixels == pytest.approx(expected, rel=1e-5)
    assert (found.unit, found.projection) == ("lx", "latlong")
    assert "a latlong map of 64 x 32 pixels, of illuminance in lx" in done.stdout
    for unit in ([], ["--unit", "cd/m2"], ["--unit", "1"]):
        again = run("environment", made, *unit)
        assert (again.returncode, again.stdout) == (2, "")
        assert "the map is in lx by its file, and that is illuminance" in again.stderr


def test_the_pixels_of_an_irradiance_map_are_the_irradiances_of_their_normals(tmp_path):
    """The middle is the receiver that faces the aim's axis +x, a quarter to the left +y."""
    path = written(tmp_path / "sky.pfm", overcast("latlong", 256, 128))
    words = [path, "--unit", "cd/m2", "--aim", "0,1,0"]
    made = str(tmp_path / "lux.pfm")
    run("environment", *words, "--irradiance-map", made, "--size", "16x8", check=True)
    pixels = read_picture(made).pixels[..., 0]
    for row, column in ((0, 0), (3, 4), (5, 11)):
        normal = direction_at("latlong", *middle_of_pixel(16, 8, column, row))
        facing = ",".join(map(repr, normal))
        (expected,) = asked(*words, "--normal", facing, "-g", "irradiance:lx")
        assert pixels[row, column] == pytest.approx(expected, rel=1e-6)


def test_the_error_of_harmonics_of_order_2_is_stated(tmp_path):
    """Nine harmonics differ from an overcast sky over a dark ground by some percent."""
    made = str(tmp_path / "lux.exr")
    words = ["sky:overcast", "--zenith-luminance", "9kcd/m2", "--irradiance-map", made]
    done = run("environment", *words, "--size", "32x16", "--order", "2")
    assert "order 2: compared to the exact sum in 128 directions" in done.stderr
    exact = radcalc.irradiance_map("sky:overcast", (32, 16), zenith_luminance="9 kcd/m2")
    off = abs(read_picture(made).pixels - exact.m).max() / exact.m.max()
    (told,) = re.findall(r"the error is up to ([\d.]+) %", done.stderr)
    # in other directions, and printed with two digits
    assert 100 * off == pytest.approx(float(told), rel=0.1)
    assert 0.001 < off < 0.05


def test_negative_harmonics_are_0_in_formats_without_negative_values(tmp_path):
    """Nine harmonics of a small sun are negative for receivers turned away from it."""
    pixels = numpy.zeros((32, 64))
    pixels[6, 20] = 1e5
    path = written(tmp_path / "sun.pfm", pixels)
    made = str(tmp_path / "lux.hdr")
    done = run("environment", path, "--unit", "1", "--irradiance-map", made, "--order", "2")
    assert (done.returncode, read_picture(made).pixels.min()) == (0, 0)
    (count,) = re.findall(r"note: the harmonics are below 0 in (\d+) pixels, by", done.stderr)
    assert int(count) == numpy.count_nonzero(read_picture(made).pixels[..., 0] == 0)


def test_skies_and_expressions_are_sampled_for_a_map(tmp_path):
    made = str(tmp_path / "lux.exr")
    words = ["sky:overcast", "--zenith-luminance", "9kcd/m2", "--irradiance-map", made]
    done = run("environment", *words, "--size", "8x4", "-g", "maximum-illuminance:lx")
    assert "1024 x 512 pixels" in done.stderr
    tilt = math.pi / 8  # of the first of four rows
    facing = f"{math.sin(tilt):.6f},0,{math.cos(tilt):.6f}"
    exact = asked(*words[:3], "--normal", facing, "-g", "irradiance:lx")
    assert float(done.stdout) == pytest.approx(*exact, rel=2e-3)
    assert run("environment", "1 + z", "--irradiance-map", made, "--size", "8x4").returncode == 0
    assert read_picture(made).unit == "sr"  # relative


@pytest.mark.parametrize(
    ("words", "message", "hint"),
    [
        ("--irradiance-map {}.png", "cannot be written as .png", ".hdr"),
        ("--irradiance-map no/{}.hdr", "does not exist", "another place"),
        (
            "--irradiance-map {}.hdr --size 30x30",
            "--size 30x30 is not twice as wide",
            "--size 60x30",
        ),
        ("--irradiance-map {}.hdr --size 999999x5", "is not twice as wide", "--size 10x5"),
        ("--irradiance-map {}.hdr --size 4x2", "too few for a map", "4 rows or more"),
        ("--irradiance-map {}.hdr --normal 1,0,0", "--normal does not apply", "{}.hdr\n"),
        ("--irradiance-map {}.hdr --toward 9deg", "--toward does not apply", "{}.hdr\n"),
        ("--irradiance-map {}.hdr --check 3", "--check does not apply", "{}.hdr\n"),
        (
            "--irradiance-map {}.hdr --size 8x4 -g nonsense",
            "unknown result 'nonsense'",
            "{}.hdr --size 8x4 -g minimum-irradiance\n",
        ),
        (
            "--irradiance-map {}.hdr --size 8x4 -g maximum-irradiance:lx",
            "cannot be in lx",
            "",
        ),
        ("--irradiance-map {}.hdr -n", "one number", "-g"),
        ("--irradiance-map {}.hdr --aim 0,0,1", "--aim does not apply to a sky", ""),
        ("--irradiance-map {}.hdr --order 3", "--order", ""),
        ("--order 2", "--order does not apply without", "--irradiance-map FILE"),
        ("--size 8x4", "--size does not apply without", "--irradiance-map FILE"),
    ],
)
def test_a_refused_map_leaves_no_file(tmp_path, words, message, hint):
    done = run("environment", "sky:5", *words.format("made").split(), cwd=tmp_path)
    assert (done.returncode, done.stdout) == (2, "")
    said, told = done.stderr.split("\n", 1)
    assert message in said
    assert told.startswith("try: ")
    assert hint.format("made") in told
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("name", ["own.pfm", "./own.pfm", "link.pfm", "hard.pfm"])
def test_the_input_map_is_not_overwritten(tmp_path, name):
    path = tmp_path / "own.pfm"
    written(path, numpy.ones((16, 32)))
    (tmp_path / "link.pfm").symlink_to("own.pfm")
    (tmp_path / "hard.pfm").hardlink_to(path)
    before = path.read_bytes()
    done = run("environment", "own.pfm", "--unit", "1", "--irradiance-map", name, cwd=tmp_path)
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr == f"radcalc: {name} is also the map to read\ntry: another name\n"
    assert path.read_bytes() == before


INTERRUPTED = """
import sys
from radcalc.distributions.maps import rendered as module
def interrupted(*args, **kwargs):
    raise KeyboardInterrupt
setattr(module, "irradiance_map", interrupted)
from radcalc.__main__ import run
sys.exit(run(sys.argv[1:]))
"""


def test_an_interrupt_leaves_no_file(tmp_path):
    path = tmp_path / "made.hdr"
    done = python(INTERRUPTED, "environment", "sky:5", "--irradiance-map", str(path))
    assert (done.returncode, done.stdout, done.stderr) == (130, "", "")
    assert not list(tmp_path.iterdir())


def test_arrays_make_arrays():
    pixels = radcalc.Quantity(numpy.full((16, 32, 3), 2.0), "W/m2/sr")
    lit = radcalc.irradiance_map(pixels, (8, 4))
    assert lit.shape == (4, 8, 3)
    assert lit.to("W/m2").m == pytest.approx(numpy.full((4, 8, 3), 2 * math.pi), rel=1e-3)
    assert radcalc.irradiance_map("sky:5", (8, 4)).shape == (4, 8, 1)
    with pytest.raises(TypeError, match="normal"):
        radcalc.irradiance_map(pixels, normal=(0, 0, 1))
    with pytest.raises(radcalc.errors.RadcalcError, match="order 3"):
        radcalc.irradiance_map(pixels, order=3)


def test_the_error_includes_that_of_the_encoding(tmp_path):
    """A byte from 128 to 255 for the brightest channel, cut off or rounded: a step, or half of one.

    The true irradiance is that of the same pixels as floats.
    """

    def read(path):
        rows = results(run("environment", path, "--unit=cd/m2", "--json").stdout)
        return {name: row["value"] for name, row in rows.items()}

    pixels = numpy.random.default_rng(7).lognormal(0, 1, (32, 64, 3)) * [1.0, 0.3, 2.0]
    highest = numpy.broadcast_to(pixels.max(2, keepdims=True), pixels.shape)
    true, brightest = (read(written(tmp_path / "sky.pfm", rgb)) for rgb in (pixels, highest))
    exponent = numpy.frexp(pixels.max(2))[1]
    mantissas = numpy.floor(numpy.ldexp(pixels, 8 - exponent[..., None]))
    rows = numpy.concatenate([mantissas, exponent[..., None] + 128.0], 2)
    cut_off = tmp_path / "cut.hdr"
    cut_off.write_bytes(hdr.picture(rows, hdr.flat))
    rounded = written(tmp_path / "rounded.hdr", pixels)
    for path, share in ((cut_off, 1 / 128), (rounded, 1 / 256)):
        found = read(str(path))
        off = abs(found["illuminance"] - true["illuminance"])
        assert share / 50 * brightest["illuminance"] * (path == cut_off) < off < found["error"]
        assert found["error"] == pytest.approx(share * brightest["illuminance"], rel=0.01)
