"""Picture files: recognised, opened safely, written completely or not at all."""

import os
import stat
import subprocess
import sys

import numpy as np
import pytest

from radcalc.distributions.maps import pictures
from radcalc.distributions.maps.pictures import (
    PIXELS,
    REC_709,
    Picture,
    check_size,
    check_target,
    luminance_weights,
    read_picture,
    write_picture,
)
from radcalc.errors import ConditionError, OutputError

NO_PICTURES = {
    "nothing": (b"", "is empty"),
    "a pointer": (
        b"version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12345\n",
        "is a Git LFS pointer, not the file\ntry: git lfs pull",
    ),
    "a page": (b"\n <!DOCTYPE html>\n<html>", "is a web page (HTML) or XML"),
    "JPEG": (b"\xff\xd8\xff\xe0\0\x10JFIF", "is JPEG, not a picture of radiances"),
    "PNG": (b"\x89PNG\r\n\x1a\n", "is PNG"),
    "TIFF": (b"II*\0\x08\0\0\0", "is TIFF"),
    "big-endian TIFF": (b"MM\0*\0\0\0\x08", "is TIFF"),
    "compressed": (b"\x1f\x8b\x08\0", "is compressed (gzip)"),
    "text": (b"hello\x1b[2J", "is not a picture in a known format: it begins with 'hello\\x1b[2J'"),
    "one byte": (b"#", "begins with '#'"),
}


@pytest.mark.parametrize("case", NO_PICTURES)
def test_other_files_are_recognised(case, tmp_path):
    data, said = NO_PICTURES[case]
    path = tmp_path / "sky.hdr"
    path.write_bytes(data)
    with pytest.raises(ConditionError) as caught:
        read_picture(str(path))
    assert said in str(caught.value)
    assert caught.value.hint


@pytest.mark.parametrize(
    ("path", "said"),
    [
        ("/dev/zero", "a pipe or a device"),
        ("/nowhere/sky.hdr", "No such file"),
        ("/", "a directory"),
        ("a\0b", "not a file name"),
        ("-", "cannot be read from standard input"),
    ],
)
def test_what_cannot_be_read_is_refused(path, said):
    with pytest.raises(ConditionError, match=said):
        read_picture(path)


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("sky.png", "a map cannot be written as .png"),
        ("sky", "a map cannot be written without an extension"),
        ("folder.hdr", "a folder, a pipe or a device"),
        ("missing/sky.hdr", "the folder .* does not exist"),
        ("s\0ky.hdr", "not a file name"),
    ],
)
def test_a_path_that_cannot_be_written_is_refused_in_advance(name, said, tmp_path):
    (tmp_path / "folder.hdr").mkdir()
    with pytest.raises((ConditionError, OutputError), match=said):
        check_target(str(tmp_path / name))


def test_a_size_is_limited():
    check_size(1, PIXELS, "sky.hdr")
    for width, height in ((1, PIXELS + 1), (0, 5), (5, 0), (-5, -5)):
        with pytest.raises(ConditionError):
            check_size(width, height, "sky.hdr")


def test_luminance_follows_the_primaries():
    """ITU-R BT.709-6 and BT.2020-2 (their equations of luma), SMPTE ST 2065-1 (ACES)."""
    white = (0.3127, 0.3290)
    for primaries, weights, digits in (
        ((0.64, 0.33, 0.30, 0.60, 0.15, 0.06, *white), (0.2126, 0.7152, 0.0722), 5e-5),
        ((0.708, 0.292, 0.170, 0.797, 0.131, 0.046, *white), (0.2627, 0.6780, 0.0593), 5e-5),
        (
            (0.7347, 0.2653, 0.0, 1.0, 0.0001, -0.0770, 0.32168, 0.33767),
            (0.3439664498, 0.7281660966, -0.0721325464),
            1e-9,
        ),
    ):
        found = luminance_weights(primaries, "sky.hdr")
        assert found == pytest.approx(weights, abs=digits)
        assert sum(found) == pytest.approx(1, abs=1e-12)


@pytest.mark.parametrize(
    "primaries",
    [
        (0.3, 0.3, 0.4, 0.4, 0.5, 0.5, 0.33, 0.33),
        (0.64, 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0),
        (float("nan"), 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.329),
        (1e308, 1e308, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.329),
        (0,) * 8,
    ],
)
def test_impossible_primaries_are_refused(primaries):
    with pytest.raises(ConditionError, match="primaries"), np.errstate(all="raise"):
        luminance_weights(primaries, "sky.hdr")


GREY = Picture(np.full((2, 3, 1), 0.5, np.float32), ("Y",), (1.0,), "PFM")
FORMATS = {".hdr": "Radiance RGBE", ".pic": "Radiance RGBE", ".HDR": "Radiance RGBE", ".pfm": "PFM"}


@pytest.mark.parametrize("extension", FORMATS)
def test_writing_depends_on_the_extension_and_reading_on_the_contents(extension, tmp_path):
    path = str(tmp_path / f"sky{extension}")
    write_picture(path, GREY)
    other = str(tmp_path / "no extension")
    os.rename(path, other)
    found = read_picture(other)
    assert found.format == FORMATS[extension]
    assert (found.pixels == 0.5).all()
    assert os.listdir(tmp_path) == ["no extension"]


def test_a_radiance_picture_may_begin_without_its_mark(tmp_path):
    """Those of old versions do; the format is in the header nevertheless."""
    path = tmp_path / "sky.pic"
    size = b"\n-Y 1 +X 1\n" + bytes([128, 64, 0, 129])
    path.write_bytes(b"pfilt -1 -e .2\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=0.5\n" + size)
    assert read_picture(str(path)).pixels.tolist() == [[[2, 1, 0]]]


def test_a_radiance_picture_keeps_unit_weights_channels_and_projection(tmp_path):
    path = str(tmp_path / "sky.hdr")
    pixels = np.array([[[0.5, 1, 2], [0, 0, 3]]], np.float32)
    for unit, weights, channels, projection in (
        ("W/(m2 sr)", (0.265, 0.670, 0.065), ("R", "G", "B"), "mirror-ball"),
        ("", REC_709, ("R", "G", "B"), ""),
        ("lx", (0.0, 1.0, 0.0), ("X", "Y", "Z"), "latlong"),
        ("", (0.0, 1.0, 0.0), ("X", "Y", "Z"), "angular"),
    ):
        write_picture(path, Picture(pixels, channels, weights, "OpenEXR", unit, projection))
        found = read_picture(path)
        assert (found.unit, found.weights, found.channels) == (unit, weights, channels)
        assert found.projection == projection
        assert (found.pixels == pixels).all()


@pytest.mark.parametrize("value", [-1e-9, np.nan, np.inf, 1.7e38])
def test_what_a_format_cannot_hold_is_refused_and_leaves_nothing(value, tmp_path):
    path = tmp_path / "sky.hdr"
    pixels = np.array([[[1], [value]]], np.float32)
    with pytest.raises(ConditionError, match="RGBE cannot hold pixels that are negative, NaN or"):
        write_picture(str(path), GREY._replace(pixels=pixels))
    assert not os.listdir(tmp_path)


def test_a_picture_replaces_another_completely(tmp_path):
    """Its permissions and a link to it are kept."""
    path, link = tmp_path / "sky.pfm", tmp_path / "link.pfm"
    link.symlink_to(path)
    write_picture(str(path), GREY)
    path.chmod(0o640)
    for _ in range(2):
        found = read_picture(str(link))
        write_picture(str(link), found._replace(pixels=found.pixels * 2))
    assert (read_picture(str(path)).pixels == 2).all()
    assert link.is_symlink()
    assert stat.S_IMODE(path.stat().st_mode) == 0o640
    assert sorted(os.listdir(tmp_path)) == ["link.pfm", "sky.pfm"]


def test_a_new_file_has_the_permissions_of_any_other(tmp_path):
    (tmp_path / "other").touch()
    write_picture(str(tmp_path / "sky.pfm"), GREY)
    modes = [path.stat().st_mode for path in tmp_path.iterdir()]
    assert modes[0] == modes[1]


@pytest.mark.parametrize("error", [OSError(28, "No space left on device"), KeyboardInterrupt()])
def test_a_failed_write_keeps_the_previous_file(error, tmp_path, monkeypatch):
    path = tmp_path / "sky.pfm"
    write_picture(str(path), GREY)

    def write(path, picture):
        with open(path, "wb") as file:
            file.write(b"PF\n")
        raise error

    monkeypatch.setattr(pictures, "write_pfm", write)
    with pytest.raises((OutputError, KeyboardInterrupt)) as caught:
        write_picture(str(path), GREY._replace(pixels=GREY.pixels * 2))
    if isinstance(error, OSError):
        assert "No space left on device" in str(caught.value)
    assert os.listdir(tmp_path) == ["sky.pfm"]
    assert (read_picture(str(path)).pixels == 0.5).all()


LIMITED = """
import resource, sys
sys.dont_write_bytecode = True  # a module that is cut would spoil later starts
import numpy as np
from radcalc.distributions.maps.pictures import Picture, write_picture
resource.setrlimit(resource.RLIMIT_FSIZE, (100_000, 100_000))
pixels = np.random.default_rng(1).random((200, 300, 3)).astype(np.float32)
try:
    write_picture(sys.argv[1], Picture(pixels, ("R", "G", "B"), (1, 1, 1), ""))
except Exception as error:
    print(type(error).__name__, error)
"""


@pytest.mark.parametrize("name", ["sky.hdr", "sky.pfm"])
def test_a_full_disk_leaves_nothing(name, tmp_path):
    pytest.importorskip("resource")
    command = [sys.executable, "-c", LIMITED, str(tmp_path / name)]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    assert done.stdout.startswith("OutputError cannot write")
    assert "File too large" in done.stdout
    assert not os.listdir(tmp_path)


def test_negative_values_of_lossy_encoding_count_as_0(tmp_path):
    """Real maps have three such values in two million, down to -6.6e-7, with a sun of 224."""
    path = str(tmp_path / "sky.pfm")
    pixels = np.ones((4, 8, 3), np.float32)
    pixels[1, 2, 0], pixels[3, 4, 1] = -6.6e-7, -6e-8
    write_picture(path, Picture(pixels, ("R", "G", "B"), REC_709, "PFM"))
    found = read_picture(path)
    assert (found.pixels == np.maximum(pixels, 0)).all()
    assert found.notes == ("2 negative values (down to -6.6e-07) count as 0",)


@pytest.mark.parametrize("value", [-1e-3, -np.inf, np.nan])
def test_larger_negative_values_stay(value, tmp_path):
    path = str(tmp_path / "sky.pfm")
    pixels = np.ones((4, 8, 3), np.float32)
    pixels[1, 2, 0] = value
    write_picture(path, Picture(pixels, ("R", "G", "B"), REC_709, "PFM"))
    found = read_picture(path)
    np.testing.assert_array_equal(found.pixels, pixels)
    assert found.notes == ()
