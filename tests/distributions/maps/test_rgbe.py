"""Radiance pictures, compared with the format's description, OpenImageIO and Radiance."""

import math
import platform
import subprocess
import sys

import numpy as np
import OpenImageIO
import pytest
from distributions.maps import hdr
from helpers import for_each

from radcalc.distributions.maps.pictures import REC_709, Picture, read_picture, write_picture
from radcalc.distributions.maps.rgbe import ROUNDED, read
from radcalc.errors import ConditionError

try:
    import pyradiance
except ImportError:
    if platform.machine() != "aarch64":  # there is no wheel for aarch64
        raise
    pyradiance = None
with_radiance = pytest.mark.skipif(not pyradiance, reason="pyradiance is not installed")

NAME = "sky.hdr"


def pixels(data):
    return read(data, NAME).pixels


def openimageio(path):
    """Return pixels from OpenImageIO, by scanlines in the order of the file."""
    file = OpenImageIO.ImageInput.open(str(path))
    assert file, OpenImageIO.geterror()
    found = file.read_image("float")
    file.close()
    assert found is not None
    return found


@pytest.mark.parametrize("encoding", hdr.ENCODINGS)
@pytest.mark.parametrize(
    ("height", "width"), [(1, 1), (5, 1), (3, 7), (4, 8), (2, 127), (2, 128), (3, 129), (9, 1000)]
)
def test_every_encoding_and_width_gives_the_same_pixels(encoding, height, width):
    rows = hdr.noise(height, width, seed=width)
    found = read(hdr.picture(rows, hdr.ENCODINGS[encoding]), NAME)
    assert found.pixels.dtype == np.float32
    np.testing.assert_array_equal(found.pixels, hdr.values(rows).astype(np.float32))
    assert (found.channels, found.format, found.unit) == (("R", "G", "B"), "Radiance RGBE", "")
    assert found.weights == REC_709


def test_every_exponent_is_a_power_of_two():
    rows = [[(255, 1, 0, exponent) for exponent in range(256)]]
    expected = [(0.0, 0.0, 0.0)] + [
        (math.ldexp(255, exponent - 136), math.ldexp(1, exponent - 136), 0.0)
        for exponent in range(1, 256)
    ]
    for encoding in hdr.ENCODINGS.values():
        assert pixels(hdr.picture(rows, encoding)).tolist() == [[list(rgb) for rgb in expected]]


def test_each_scanline_is_encoded_in_its_own_way():
    rows = hdr.noise(60, 33)
    encodings = np.random.default_rng(3).choice([*hdr.ENCODINGS.values()], 60)
    encodings[:20] = hdr.flat
    lines = b"".join(encode(row) for encode, row in zip(encodings, rows, strict=True))
    found = pixels(hdr.head(size="-Y 60 +X 33") + lines)
    np.testing.assert_array_equal(found, hdr.values(rows).astype(np.float32))


@pytest.mark.parametrize("least", [1, 2, 127])
def test_runs_may_be_short_and_literals_long(least):
    """A run may have 1 or 2 bytes, and a literal 128 of which some repeat."""
    rows = hdr.noise(3, 600)
    data = hdr.picture(rows, lambda row: hdr.new(row, least))
    np.testing.assert_array_equal(pixels(data), hdr.values(rows).astype(np.float32))


@pytest.mark.parametrize("times", [1, 254, 255, 256, 257, 511, 65534, 65536, 69999])
def test_counts_of_repetitions_have_several_bytes(times):
    """Widths beyond those of the new encoding: 70000, where a count has up to three bytes."""
    line = np.empty((70000, 4), int)
    line[: times + 1] = 200, 100, 50, 130
    line[times + 1 :] = 40, 140, 60, 128
    data = hdr.picture([line], hdr.old)
    assert len(data) < 100
    np.testing.assert_array_equal(pixels(data), hdr.values([line]).astype(np.float32))


@pytest.mark.parametrize(
    "order", ["-Y +X", "-Y -X", "+Y -X", "+Y +X", "+X +Y", "-X +Y", "-X -Y", "+X -Y"]
)
@pytest.mark.parametrize("encoding", hdr.ENCODINGS)
def test_every_orientation_is_turned_upright(order, encoding):
    """The origin is at the lower left corner; a sign says which way a coordinate goes in the file.

    The first axis goes from scanline to scanline, the second along each.
    """
    height, width = 9, 12
    rows = hdr.noise(height, width, steps=4)

    def along(axis):
        size = {"X": width, "Y": height}[axis[1]]
        return range(size) if axis[0] == "+" else range(size - 1, -1, -1)

    slow, fast = order.split()
    lines = []
    for first in along(slow):
        line = []
        for second in along(fast):
            place = {slow[1]: first, fast[1]: second}
            line.append(rows[height - 1 - place["Y"]][place["X"]])
        lines.append(hdr.ENCODINGS[encoding](line))
    size = f"{slow} {len(along(slow))} {fast} {len(along(fast))}"
    found = pixels(hdr.head(size=size) + b"".join(lines))
    np.testing.assert_array_equal(found, hdr.values(rows).astype(np.float32))


def test_exposures_and_corrections_are_undone():
    """They are cumulative, and apply only at the beginning of a line."""
    rows = hdr.noise(2, 9)
    lines = [
        "pcomb -e something",
        "\tEXPOSURE=17",
        "EXPOSURE=0.5",
        "EXPOSURE= 8.0e+00",
        "COLORCORR= 1.5 1 0.25",
        "COLORCORR=2 1 2",
        "EXPOSURES=3",
        "VIEW= -vta -vv 180",
        "CAPDATE= 2020:01:02 03:04:05",
        "\xff = binary",
    ]
    found = pixels(hdr.picture(rows, hdr.new, *lines))
    expected = hdr.values(rows) / 4 / [3, 1, 0.5]
    np.testing.assert_allclose(found, expected, rtol=2e-7)


def test_xyze_has_luminance_in_y():
    """According to "File Formats", the units of the Y primary are already lm/sr/m2."""
    rows = hdr.noise(2, 9)
    lines = "EXPOSURE=0.25", "PRIMARIES=.67 .33 .21 .71 .14 .08 .33 .33"
    found = read(hdr.picture(rows, hdr.new, *lines, form="32-bit_rle_xyze"), NAME)
    assert (found.channels, found.weights, found.unit) == (("X", "Y", "Z"), (0, 1, 0), "cd/m2")
    np.testing.assert_array_equal(found.pixels, (4 * hdr.values(rows)).astype(np.float32))
    assert "an XYZE picture is in cd/m2, as Radiance writes it" in found.assumptions


def test_primaries_give_the_weights():
    """Radiance's primaries have a white of 0.3333; see CIE_rf, CIE_gf and CIE_bf in color.h."""
    line = "PRIMARIES= 0.640 0.330 0.290 0.600 0.150 0.060 0.3333 0.3333"
    found = read(hdr.picture(hdr.noise(1, 1), hdr.flat, line), NAME)
    assert found.weights == pytest.approx((0.265074126, 0.670114631, 0.064811243), abs=1e-7)
    assert not any("Rec. 709" in text for text in found.assumptions)


def test_eight_zeros_are_not_primaries():
    """Photoshop and some panorama programs write them."""
    line = "PRIMARIES=0 0 0 0 0 0 0 0"
    found = read(hdr.picture(hdr.noise(1, 1), hdr.flat, line), NAME)
    assert found.weights == (0.2126, 0.7152, 0.0722)
    assert (
        "the luminance is that of Rec. 709 primaries, as the file declares none"
        in found.assumptions
    )


def test_a_picture_without_a_format_is_rgbe():
    """Radiance's checkheader() refuses another format, but not a missing one."""
    rows = hdr.noise(1, 9)
    data = hdr.picture(rows, hdr.new).replace(b"FORMAT=32-bit_rle_rgbe\n", b"")
    found = read(data, NAME)
    np.testing.assert_array_equal(found.pixels, hdr.values(rows).astype(np.float32))
    assert found.assumptions[0] == "the pixels are RGBE, as the file has no FORMAT="


def test_four_bytes_for_each_pixel_have_no_repetitions():
    rows = np.array([[(1, 1, 1, 9), (128, 64, 2, 129)], [(1, 1, 1, 0), (1, 1, 1, 2)]])
    found = pixels(hdr.head(size="-Y 2 +X 2") + rows.astype(np.uint8).tobytes())
    np.testing.assert_array_equal(found, hdr.values(rows).astype(np.float32))


@pytest.mark.parametrize(("height", "width"), [(6, 9), (2, 3), (300, 700)])
def test_a_picture_that_is_not_encoded_may_have_pixels_that_look_so(height, width):
    """With exponents of 128, as in pictures made from bytes, dark pixels are not normalized."""
    rows = np.random.default_rng(1).integers(0, 4, (height, width, 4))
    rows[..., 3] = 128
    rows[0, :3] = [(1, 1, 1, 128), (2, 2, 1, 128), (1, 1, 1, 1)]
    rows[-1, 0] = (2, 2, 2, 128)
    found = read(hdr.picture(rows, hdr.flat), NAME)
    np.testing.assert_array_equal(found.pixels, hdr.values(rows).astype(np.float32))
    assert found.notes == ()


def test_repetitions_of_one_pixel_are_decoded():
    """Each replaces the pixel that it repeats, so the size is that without encoding."""
    rows = [[(200, 100, 50, 130), (200, 100, 50, 130), (9, 8, 140, 131), (9, 8, 140, 131)]]
    data = hdr.picture(rows, hdr.old)
    assert len(data) == len(hdr.picture(rows, hdr.flat))
    found = read(data, NAME)
    np.testing.assert_array_equal(found.pixels, hdr.values(rows).astype(np.float32))
    assert found.notes == ()


@pytest.mark.parametrize(
    ("lines", "told"),
    [
        (
            ["VIEW= -vta -vp 0 0 1 -vd 0 1 0 -vu 0 0 1 -vh 180 -vv 175 -vo 0"],
            "-vta -vh 180 -vv 175",
        ),
        (["VIEW= -vtv", "VIEW= -vh 30"], "-vtv -vh 30 -vv 45"),
        (["VIEW= -vth -vs .5 -vh 90 -vv 20 -vl -1"], "-vth -vh 90 -vv 20 -vs 0.5 -vl -1"),
        (["VIEW= -vtl -vh 3 -vv 2"], "-vtl -vh 3 -vv 2"),
        (["VIEW= -vta -vv 360 -vh 360"], "-vta -vh 360 -vv 360"),
        (["VIEW= -vp 0 0 1"], ""),
        (["\tVIEW= -vtv -vh 30"], ""),
        (["VIEW= -vta -vh 180 -vv 180", "RADCALC_PROJECTION=latlong"], ""),
    ],
)
def test_the_view_of_the_file_is_read(lines, told):
    found = read(hdr.picture(hdr.noise(1, 9), hdr.new, *lines), NAME)
    assert found.view_text == (f"VIEW= {told}" if told else "")
    assert not found.notes


@pytest.mark.parametrize(
    "view",
    [
        "-vtx -vh 60 -vv 40",
        "-vt -vh 60",
        "-vtv -vh 180",
        "-vtv -vh 0",
        "-vta -vh 361",
        "-vth -vh 181",
        "-vts -vh 360",
        "-vtc -vv 180",
        "-vta -vh wide",
        "-vta -vh 180 90",
        "-vta -vh nan",
        "-vta -vd 0 0 0",
        "-vta -vd 0 0 -2",
        "-vta -vd 1 0",
    ],
)
def test_an_impossible_view_is_refused(view):
    """As by `setview` of Radiance's src/common/image.c."""
    with pytest.raises(ConditionError, match=r"sky\.hdr has an impossible view: 'VIEW= "):
        read(hdr.picture(hdr.noise(1, 9), hdr.new, f"VIEW= {view}"), NAME)


def test_oddities_have_notes():
    data = hdr.picture(hdr.noise(1, 9), hdr.new, "PIXASPECT=1.25", "PIXASPECT=0.5") + b"abc"
    assert read(data, NAME).notes == (
        "sky.hdr has PIXASPECT=0.625, but its pixels are read as square",
        "sky.hdr has 3 bytes after the picture",
    )


def test_lines_may_end_as_in_windows():
    head = b"#?RGBE\r\nFORMAT=32-bit_rle_rgbe\r\n\r\n-Y 1 +X 1\n"
    assert pixels(head + bytes([128, 0, 0, 129])).tolist() == [[[1, 0, 0]]]


GOOD = hdr.picture(hdr.noise(3, 20, steps=4), hdr.new)
START = GOOD.index(b"+X 20\n") + 6


def changed(at, byte, data=GOOD, start=START):
    """Return a good file with another byte, counted from the first scanline."""
    return data[: start + at] + bytes([byte]) + data[start + at + 1 :]


REFUSED = {
    "an octree": (
        hdr.head(form="Radiance_octree"),
        "is in the format 'Radiance_octree'",
    ),
    "no end of the header": (b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n", "the header has no end"),
    "the first two bytes": (b"#?", "the header has no end"),
    "no size": (hdr.head(size="hello"), "has no size at byte 35: 'hello'"),
    "no end of the size": (hdr.head()[:-1], "has no size at byte 35: ''"),
    "one axis twice": (hdr.head(size="-Y 2 +Y 2"), "has no size at byte 35: '-Y 2 +Y 2'"),
    "a negative size": (hdr.head(size="-Y 2 +X -3"), "has -3 x 2 pixels"),
    "no size at all": (hdr.head(size="-Y 0 +X 0"), "has 0 x 0 pixels"),
    "a size of many digits": (hdr.head(size=f"-Y {'9' * 16} +X 1"), "has no size"),
    "a large size": (hdr.head(size="-Y 65536 +X 65536") + bytes(10), "more than 268435456"),
    "sizes the other way": (hdr.head(size="+X 10 -Y -4"), "has 10 x -4 pixels"),
    "ten bytes": (
        hdr.head(size="-Y 8192 +X 16384") + bytes(10),
        "is cut off: 8192 scanlines of 16384 pixels need 98304 bytes or more, but it has 10",
    ),
    "a negative exposure": (hdr.head("EXPOSURE=-1"), "its header has 'EXPOSURE=-1'"),
    "no exposure": (hdr.head("EXPOSURE=0"), "its header has 'EXPOSURE=0'"),
    "an empty exposure": (hdr.head("EXPOSURE="), "its header has 'EXPOSURE='"),
    "an exposure of nan": (hdr.head("EXPOSURE=nan"), "its header has 'EXPOSURE=nan'"),
    "a word": (hdr.head("EXPOSURE=1_0"), "its header has 'EXPOSURE=1_0'"),
    "exposures too far": (hdr.head(*["EXPOSURE=1e-9"] * 3), "its header has 'EXPOSURE=1e-9'"),
    "two corrections": (hdr.head("COLORCORR=1 1"), "its header has 'COLORCORR=1 1'"),
    "primaries": (
        hdr.head("PRIMARIES=0 0 0 0 0 0 .3 .3"),
        "has impossible primaries",
    ),
    "seven": (hdr.head("PRIMARIES=0 0 0 0 0 0 0"), "its header has 'PRIMARIES=0"),
    "a gamma": (hdr.head("GAMMA=2.2"), "has GAMMA=2.2: its pixels are encoded for display"),
    "too bright": (
        hdr.picture([[(255, 0, 0, 255)]], hdr.flat, "EXPOSURE=0.001"),
        "pixels divided by EXPOSURE are too large for 32 bits",
    ),
    "cut off": (GOOD[:-1], "scanline 3 is cut off"),
    "cut off in a mark": (GOOD[: START + 2], "is cut off"),
    "cut off in flat": (hdr.picture(hdr.noise(3, 20), hdr.flat)[:-1], "scanline 3 is cut off"),
    "another length": (changed(3, 21), "scanline 1 has 21 pixels instead of 20, at byte"),
    "a long run": (changed(4, 255), "scanline 1 has a run that is longer than the rest, at byte"),
    "a run of nothing": (changed(4, 0), f"scanline 1 has a run of nothing, at byte {START + 4}"),
    "a repetition first": (
        hdr.head(size="-Y 1 +X 3") + bytes([1, 1, 1, 2] + [128] * 9),
        "scanline 1 begins with a repetition",
    ),
    "a long repetition": (
        hdr.head(size="-Y 2 +X 3") + bytes([128] * 12 + [128] * 4 + [1, 1, 1, 3] + [128] * 5),
        "scanline 2 has a repetition that is longer than the rest, at byte 61",
    ),
    "a repetition without end": (
        hdr.head(size="-Y 1 +X 9") + bytes([128] * 4 + [1, 1, 1, 0] * 7 + [1, 1, 1, 1, 0]),
        "longer than the rest",
    ),
    "repetitions of nothing": (
        hdr.head(size="-Y 1 +X 9") + bytes([128] * 4 + [1, 1, 1, 0] * 20),
        "scanline 1 has repetitions of nothing",
    ),
}


@for_each(REFUSED)
def test_damage_is_refused_with_its_place(case):
    data, said = REFUSED[case]
    with pytest.raises(ConditionError) as caught:
        read(data, NAME)
    assert caught.value.message.startswith(NAME)
    assert said in caught.value.message
    assert caught.value.hint


def test_a_file_is_refused_wherever_it_is_cut_off():
    for encoding in hdr.ENCODINGS.values():
        data = hdr.picture(hdr.noise(2, 20, steps=4), encoding)
        for end in range(2, len(data)):
            with pytest.raises(ConditionError):
                read(data[:end], NAME)


def test_memory_is_limited_by_the_contents(tmp_path):
    """No memory is allocated for a picture of 96 MiB with a damaged second scanline.

    A picture that expands to 32,000 times the size of its file is refused.
    """
    line = hdr.old([(200, 100, 50, 130)] * 4096)
    data = hdr.head(size="-Y 2048 +X 4096") + line + bytes([1, 1, 1, 1]) + line * 20000
    path = tmp_path / NAME
    path.write_bytes(data)
    bomb = hdr.head(size="-Y 8192 +X 16384") + hdr.old([(200, 100, 50, 130)] * 16384) * 8192
    with pytest.raises(ConditionError, match="16384 x 8192 pixels in only 98356 bytes"):
        read(bomb, NAME)
    script = (
        "import resource, sys\n"
        "from radcalc.distributions.maps.pictures import read_picture\n"
        "before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss\n"
        "try: read_picture(sys.argv[1])\n"
        "except Exception as error: print(error)\n"
        "print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before)\n"
    )
    pytest.importorskip("resource")
    command = [sys.executable, "-c", script, str(path)]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    *said, kibibytes = done.stdout.splitlines()
    assert "scanline 2 begins with a repetition" in said[0]
    assert int(kibibytes) < 50 * 1024


def picture_or_message(data):
    try:
        return pixels(data)
    except ConditionError as error:
        return error.message


@pytest.mark.parametrize("seed", range(8))
def test_damage_ends_in_a_picture_or_a_refusal(seed):
    random = np.random.default_rng(seed)
    for encoding in hdr.ENCODINGS.values():
        good = hdr.picture(hdr.noise(4, 40, seed, steps=6), encoding, "EXPOSURE=2")
        for _ in range(150):
            data = bytearray(good)
            for _ in range(random.integers(1, 4)):
                place = int(random.integers(len(data)))
                how = random.integers(3)
                if how == 0:
                    data[place] = random.integers(256)
                elif how == 1:
                    del data[place : place + int(random.integers(1, 20))]
                else:
                    data[place:place] = random.bytes(int(random.integers(1, 20)))
            found = picture_or_message(bytes(data))
            if isinstance(found, str):
                assert found.startswith(NAME)
                assert found.isprintable()
            else:
                assert np.isfinite(found).all()


# With OpenImageIO, which reads flat pictures and the new encoding, and undoes no exposure


@pytest.mark.parametrize("order", ["-Y 40 +X 300", "+Y 40 -X 300", "+X 40 -Y 300"])
@pytest.mark.parametrize("encoding", ["flat", "new"])
def test_openimageio_reads_the_same(order, encoding, tmp_path):
    rows = hdr.noise(40, 300)
    data = hdr.head(size=order) + b"".join(map(hdr.ENCODINGS[encoding], rows))
    path = tmp_path / NAME
    path.write_bytes(data)
    found = read_picture(str(path)).pixels
    if order.startswith("+Y"):
        found = found[::-1, ::-1]
    if order.startswith("+X"):
        found = found.transpose(1, 0, 2)
    np.testing.assert_array_equal(found, openimageio(path))


def test_pictures_of_openimageio_are_read_as_by_openimageio(tmp_path):
    path = tmp_path / NAME
    random = np.random.default_rng(5)
    written = random.lognormal(0, 4, (64, 700, 3)).astype(np.float32)
    written[:30] = written[:30, :1]
    written[40:, ::2] = 0
    file = OpenImageIO.ImageOutput.create(str(path))
    assert file.open(str(path), OpenImageIO.ImageSpec(700, 64, 3, "float"))
    assert file.write_image(written)
    file.close()
    np.testing.assert_array_equal(read_picture(str(path)).pixels, openimageio(path))


@pytest.mark.parametrize("width", [1, 7, 8, 700, 32767, 32768])
def test_written_pictures_are_read_by_openimageio(width, tmp_path):
    """To the nearest mantissa: within half of 1 part in 128 of the brightest channel."""
    path = tmp_path / NAME
    random = np.random.default_rng(width)
    pixels = random.lognormal(0, 4, (5, width, 3)).astype(np.float32)
    pixels[0] = pixels[0, 0]
    pixels[1, :: max(2, width // 9)] = 0
    pixels[2] = 255.5 / 256  # is rounded to 1
    pixels[3] *= 1e30
    notes = write_picture(str(path), Picture(pixels, ("R", "G", "B"), REC_709, "", "cd/m2"))
    assert notes == ("RGBE has a resolution of 1/256 of the brightest channel of a pixel",)
    found = read_picture(str(path))
    # its powers of two are decimals of eight digits
    np.testing.assert_allclose(found.pixels, openimageio(path), rtol=2e-7)
    assert (found.unit, found.weights, found.assumptions) == ("cd/m2", REC_709, (ROUNDED,))
    assert (found.pixels[2] == 1).all()
    step = 2.0 ** (np.frexp(found.pixels.max(2, keepdims=True))[1] - 8)
    assert (np.abs(found.pixels - pixels.astype(float)) <= step / 2).all()
    assert np.mean((found.pixels - pixels) / step) == pytest.approx(0, abs=0.1)
    if width == 700:
        assert path.stat().st_size < 4 * 5 * width


# With Radiance, which reads half a step more


@with_radiance
@pytest.mark.parametrize("encoding", hdr.ENCODINGS)
def test_radiance_reads_the_same_but_for_half_a_step(encoding, tmp_path):
    """Its pvalue undoes the exposures, too."""
    rows = hdr.noise(20, 90)
    path = tmp_path / NAME
    lines = "EXPOSURE=0.25", "EXPOSURE=3", "COLORCORR=1.25 1 0.5"
    path.write_bytes(hdr.picture(rows, hdr.ENCODINGS[encoding], *lines))
    theirs = pyradiance.pvalue(str(path), original=True, header=False, resstr=False, outform="f")
    ours = read_picture(str(path)).pixels
    half = np.where(rows[..., 3:] > 0, 2.0 ** (rows[..., 3:] - 137), 0) / 0.75 / [1.25, 1, 0.5]
    np.testing.assert_allclose(
        np.frombuffer(theirs, np.float32).reshape(ours.shape), ours + half, rtol=1e-6
    )


@with_radiance
def test_radiance_and_its_xyz_have_the_same_luminance(tmp_path):
    """Compare with a picture from ra_xyze, and its luminance."""
    rows = hdr.noise(20, 90)
    rows[..., :3] = np.maximum(rows[..., :3], 100)
    path, other = tmp_path / NAME, tmp_path / "xyz.hdr"
    path.write_bytes(hdr.picture(rows, hdr.new, "EXPOSURE=0.25"))
    other.write_bytes(pyradiance.ra_xyze(str(path)))
    found = read_picture(str(other))
    assert (found.channels, found.unit) == (("X", "Y", "Z"), "cd/m2")
    luminance = 179 * read_picture(str(path)).pixels @ [0.265074126, 0.670114631, 0.064811243]
    lit = luminance > 0
    np.testing.assert_allclose(found.pixels[..., 1][lit], luminance[lit], rtol=0.03)
    assert np.mean(found.pixels[..., 1][lit] / luminance[lit]) == pytest.approx(1, abs=0.005)


def test_a_grey_picture_stays_grey(tmp_path):
    path = str(tmp_path / "grey.hdr")
    pixels = np.arange(1, 33, dtype=np.float32).reshape(4, 8, 1)
    write_picture(path, Picture(pixels, ("Y",), (1.0,), "", "umol/m2/s/sr", "latlong"))
    found = read_picture(path)
    assert (found.channels, found.weights, found.unit) == (("Y",), (1.0,), "umol/m2/s/sr")
    assert (found.pixels == pixels).all()
