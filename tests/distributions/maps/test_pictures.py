"""Picture files: told apart, opened safely, written whole or not at all."""

import numpy as np
import pytest

from radcalc.distributions.maps.pictures import (
    PIXELS,
    check_size,
    check_target,
    luminance_weights,
    read_picture,
)
from radcalc.errors import ConditionError, OutputError

NO_PICTURES = {
    "nothing": (b"", "is empty"),
    "a pointer": (
        b"version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12345\n",
        "is a pointer of Git LFS, which stands for the picture\ntry: git lfs pull",
    ),
    "a page": (b"\n <!DOCTYPE html>\n<html>", "is a web page (HTML) or XML"),
    "JPEG": (b"\xff\xd8\xff\xe0\0\x10JFIF", "is JPEG, and no picture of radiances"),
    "PNG": (b"\x89PNG\r\n\x1a\n", "is PNG"),
    "TIFF": (b"II*\0\x08\0\0\0", "is TIFF"),
    "big-endian TIFF": (b"MM\0*\0\0\0\x08", "is TIFF"),
    "compressed": (b"\x1f\x8b\x08\0", "is compressed (gzip)"),
    "text": (b"hello\x1b[2J", "is no picture that is read: it begins with 'hello\\x1b[2J'"),
    "one byte": (b"#", "begins with '#'"),
}


@pytest.mark.parametrize("case", NO_PICTURES)
def test_what_is_no_picture_is_told_what_it_is(case, tmp_path):
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
        ("a\0b", "no name of a file"),
        ("-", "not read from standard input"),
    ],
)
def test_what_cannot_be_read_is_refused(path, said):
    with pytest.raises(ConditionError, match=said):
        read_picture(path)


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("sky.png", "pictures are not written as .png"),
        ("sky", "pictures are not written without an extension"),
        ("folder.hdr", "a folder, a pipe or a device"),
        ("missing/sky.hdr", "there is no folder"),
        ("s\0ky.hdr", "no name of a file"),
    ],
)
def test_where_nothing_can_be_written_is_said_before(name, said, tmp_path):
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
def test_primaries_of_no_light_are_refused(primaries):
    with pytest.raises(ConditionError, match="primaries"), np.errstate(all="raise"):
        luminance_weights(primaries, "sky.hdr")
