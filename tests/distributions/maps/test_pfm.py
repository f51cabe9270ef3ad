"""Portable float maps, compared with OpenImageIO and Netpbm's pfm(5)."""

import struct

import numpy as np
import OpenImageIO
import pytest

from radcalc.distributions.maps.pictures import (
    REC_709,
    Picture,
    read_pfm,
    read_picture,
    write_picture,
)
from radcalc.errors import ConditionError

NAME = "sky.pfm"
SIX = (1.5, -2.25, 3e38, 0.0, 1e-40, 7.0)


@pytest.mark.parametrize("order", "<>")
def test_rows_begin_at_the_bottom_and_the_sign_is_the_byte_order(order):
    scale = b"-1.0" if order == "<" else b"1"
    grey = read_pfm(b"Pf\n2 3\n" + scale + b"\n" + struct.pack(order + "6f", *SIX), NAME)
    upwards = np.array(SIX, np.float32).reshape(3, 2)
    assert grey.pixels.tolist() == [[[value] for value in row] for row in upwards[::-1].tolist()]
    assert (grey.channels, grey.weights, grey.format, grey.unit) == (("Y",), (1.0,), "PFM", "")
    assert (grey.assumptions, grey.notes) == ((), ())
    colour = read_pfm(b"PF 1 2 " + scale + b" " + struct.pack(order + "6f", *SIX), NAME)
    assert colour.pixels.reshape(2, 3).tolist() == upwards.reshape(2, 3)[::-1].tolist()
    assert (colour.channels, colour.weights) == (("R", "G", "B"), REC_709)
    assert len(colour.assumptions) == 1
    for found in (grey, colour):
        assert found.pixels.dtype == np.dtype("=f4")


def test_nan_and_infinity_are_read():
    values = struct.pack("<3f", float("nan"), float("inf"), -1)
    found = read_pfm(b"PF\n1 1\n-1\n" + values, NAME).pixels
    np.testing.assert_array_equal(found, [[[np.nan, np.inf, -1]]])


def test_the_scale_multiplies_with_a_note():
    found = read_pfm(b"Pf\n1 1\n-2.5\n" + struct.pack("<f", 3), NAME)
    assert found.pixels.tolist() == [[[7.5]]]
    assert found.notes == ("all pixels are multiplied by 2.5, the scale of sky.pfm",)
    too_large = read_pfm(b"Pf\n1 1\n-2.5\n" + struct.pack("<f", 3e38), NAME)
    assert too_large.pixels.tolist() == [[[np.inf]]]


def test_a_scale_whose_sign_contradicts_the_bytes_is_refused():
    """Half floats are denormal in the other order; other values are huge or negative there."""
    half = np.linspace(0, 2, 96).astype(np.float16).astype("<f4")
    whole = np.random.default_rng(1).lognormal(0, 3, 96).astype("<f4")
    for right in (half, whole, half * 0, half - 1e-3):
        for order, right_scale, wrong_scale in (("<f4", b"-1.0", b"1.0"), (">f4", b"2", b"-2")):
            data = right.astype(order).tobytes()
            found = read_pfm(b"Pf\n12 8\n" + right_scale + b"\n" + data, NAME).pixels
            assert (found[::-1].ravel() == right * abs(float(right_scale))).all()
            if not right.any():
                continue
            with pytest.raises(ConditionError) as caught:
                read_pfm(b"Pf\n12 8\n" + wrong_scale + b"\n" + data, NAME)
            assert f"and up to {right.max():.3g} in the other one" in caught.value.message
            sign = "other sign: -1" if order == "<f4" else "other sign: 2"
            assert caught.value.hint.endswith(sign)


def test_lines_may_end_as_in_windows():
    data = struct.pack("<f", 3)
    assert read_pfm(b"Pf\r\n1 1\r\n-1\r\n" + data, NAME).pixels.tolist() == [[[3]]]
    # a blank ends the header, and what looks like the end of a line is a part of a pixel
    data = b"\n\0\0\x40"
    expected = [[[struct.unpack("<f", data)[0]]]]
    assert read_pfm(b"Pf\n1 1\n-1\r" + data, NAME).pixels.tolist() == expected


PIXEL = struct.pack("<f", 3)
REFUSED = {
    "nothing else": (b"PF", "is not a PFM picture: it begins with 'PF'"),
    "four channels": (
        b"PF4\n1 1\n-1\n" + 4 * PIXEL,
        "is not a PFM picture: it begins with 'PF4 1 1",
    ),
    "no scale": (b"Pf\n1 1\n", "is not a PFM picture"),
    "a scale of 0": (b"Pf\n1 1\n0\n" + PIXEL, "is not a PFM picture"),
    "a scale of nan": (b"Pf\n1 1\nnan\n" + PIXEL, "is not a PFM picture"),
    "a word": (b"Pf\n1 1\n-1_0\n" + PIXEL, "is not a PFM picture"),
    "no end of the header": (b"Pf\n1 1\n-1.0", "is not a PFM picture"),
    "no width": (b"Pf\n0 1\n-1\n" + PIXEL, "has 0 x 1 pixels"),
    "a negative height": (b"Pf\n1 -1\n-1\n" + PIXEL, "has 1 x -1 pixels"),
    "too large": (b"Pf\n65536 65536\n-1\n" + PIXEL, "more than 268435456"),
    "cut off": (b"Pf\n1 2\n-1\n" + PIXEL, "has 4 bytes of pixels, but its size requires 8"),
    "a byte more": (b"Pf\n1 1\n-1\n" + PIXEL + b"x", "has 5 bytes of pixels"),
    "grey and not colour": (b"PF\n1 1\n-1\n" + PIXEL, "its size requires 12"),
}


@pytest.mark.parametrize("case", REFUSED)
def test_what_is_no_map_is_refused(case):
    data, said = REFUSED[case]
    with pytest.raises(ConditionError) as caught:
        read_pfm(data, NAME)
    assert caught.value.message.startswith(NAME)
    assert said in caught.value.message
    assert caught.value.hint


def openimageio(path):
    """Return pixels from OpenImageIO with its documented default, which must be set."""
    wish = OpenImageIO.ImageSpec()
    wish.attribute("pnm:pfmflip", 1)
    file = OpenImageIO.ImageInput.open(str(path), wish)
    found = file.read_image("float")
    file.close()
    return found


@pytest.mark.parametrize("channels", [("Y",), ("R", "G", "B")])
@pytest.mark.parametrize(("height", "width"), [(1, 1), (3, 5), (700, 1000)])
def test_what_is_written_is_read_again_and_by_openimageio(channels, height, width, tmp_path):
    path = tmp_path / NAME
    shape = height, width, len(channels)
    pixels = np.random.default_rng(1).normal(0, 1e3, shape).astype(np.float32)
    weights = (1.0,) if len(channels) == 1 else REC_709
    assert write_picture(str(path), Picture(pixels, channels, weights, "OpenEXR")) == ()
    found = read_picture(str(path))
    assert found.channels == channels
    np.testing.assert_array_equal(found.pixels, pixels)
    np.testing.assert_array_equal(openimageio(path).reshape(shape), pixels)


def test_a_scale_is_read_as_in_openimageio(tmp_path):
    path = tmp_path / NAME
    stored = np.random.default_rng(1).normal(0, 1e3, (4, 5, 3))
    path.write_bytes(b"PF\n5 4\n0.37\n" + stored.astype(">f4").tobytes())
    np.testing.assert_array_equal(openimageio(path), read_picture(str(path)).pixels)


def test_lost_information_has_a_note(tmp_path):
    path = str(tmp_path / NAME)
    pixels = np.ones((1, 2, 3), np.float32)
    picture = Picture(pixels, ("R", "G", "B"), (0.3, 0.6, 0.1), "OpenEXR", "cd/m2", "latlong")
    told = ("PFM does not store the unit (cd/m2), the primaries, the projection (latlong)",)
    assert write_picture(path, picture) == told
    with pytest.raises(ConditionError, match="PFM has no X, Y, Z"):
        write_picture(path, picture._replace(channels=("X", "Y", "Z")))
