"""Picture files: valid files have the pixels that were written; damaged files are refused or read.

The sweep writes a Radiance picture (size, orientation, encoding of each scanline, multipliers), a
portable float map, or an OpenEXR picture (compression, scan lines or tiles).  Then it changes,
drops and adds bytes: the file is refused, or its pixels are numbers.
"""

import io
import random
from typing import Any

import numpy as np
import OpenEXR
from distributions.maps import hdr

from radcalc.distributions.maps import exr, pictures, rgbe
from radcalc.errors import ConditionError

SHORT, LONG = 75, 50_000
ORDERS = ["-Y +X", "-Y -X", "+Y -X", "+Y +X", "+X +Y", "-X +Y", "-X -Y", "+X -Y"]
LINES = [(), ("EXPOSURE=2",), ("EXPOSURE=0.5", "COLORCORR=1 2 4", "EXPOSURE=0.25")]
COMPRESSIONS = ["NO", "RLE", "ZIPS", "ZIP", "PIZ", "ZSTD"]  # lossless for 32-bit floats
FACTORS = [(1, 1, 1), (2, 2, 2), (0.125, 0.25, 0.5)]


def radiance(height: int, width: int) -> tuple[bytes, np.ndarray]:
    """Make a Radiance picture, and its pixels with row 0 at the top."""
    rows = hdr.noise(height, width, random.randrange(10**6), random.choice([4, 40]))
    kind = random.randrange(3)
    order = random.choice(ORDERS)
    turned = rows if order[1] == "Y" else rows.transpose(1, 0, 2)
    # the axis of the file is opposite to rows or columns
    for axis, word in enumerate(order.split()):
        if word in ("+Y", "-X"):
            turned = np.flip(turned, axis)
    encodings = random.choice(
        [[*hdr.ENCODINGS.values()], *([one] for one in hdr.ENCODINGS.values())]
    )
    size = f"{order[:2]} {turned.shape[0]} {order[3:]} {turned.shape[1]}"
    lines = b"".join(random.choice(encodings)(line) for line in turned)
    return hdr.head(*LINES[kind], size=size) + lines, hdr.values(rows) / FACTORS[kind]


def float_map(height: int, width: int) -> tuple[bytes, np.ndarray]:
    """Make a portable float map, and its pixels with row 0 at the top."""
    channels = random.choice([1, 3])
    pixels = np.random.default_rng(random.randrange(10**6)).lognormal(
        0, 9, (height, width, channels)
    )
    sign, order = random.choice([("-", "<f4"), ("", ">f4")])
    scale = random.choice(["1", "1.0", "0.5"])
    head = f"P{'F' if channels == 3 else 'f'}\n{width} {height}\n{sign}{scale}\n".encode()
    return head + pixels[::-1].astype(order).tobytes(), pixels * float(scale)


def open_exr(height: int, width: int) -> tuple[bytes, np.ndarray]:
    """Make an OpenEXR picture, and its pixels."""
    pixels = np.random.default_rng(random.randrange(10**6)).lognormal(0, 9, (height, width, 3))
    pixels = pixels.astype(np.float32)
    compression = getattr(OpenEXR, f"{random.choice(COMPRESSIONS)}_COMPRESSION")
    header = {"compression": compression, "type": OpenEXR.scanlineimage}
    if random.random() < 0.5:
        tiles = OpenEXR.TileDescription()
        tiles.xSize, tiles.ySize = random.choice([(8, 16), (64, 64)])
        header |= {"type": OpenEXR.tiledimage, "tiles": tiles}
    planes = {name: np.ascontiguousarray(pixels[..., k]) for k, name in enumerate("RGB")}
    file = io.BytesIO()
    OpenEXR.File(header, planes).write(file)
    return file.getvalue(), pixels


def damaged(data: bytes) -> bytes:
    """Change, drop, insert or double bytes."""
    found = bytearray(data)
    for _ in range(random.choice([1, 1, 2, 5])):
        place = random.randrange(len(found) + 1)
        end = place + random.choice([0, 1, 1, 5, 100])
        found[place:end] = random.choice(
            [b"", random.randbytes(1), random.randbytes(end - place), 2 * found[place:end]]
        )
    return bytes(found)


FORMATS = [
    (radiance, rgbe.read),
    (radiance, rgbe.read),
    (float_map, pictures.read_pfm),
    (open_exr, exr.read),
]


def pixels_or_refusal(read: Any, data: bytes) -> np.ndarray | str:
    """Return the pixels of a file, or the error."""
    try:
        return read(data, "sky").pixels
    except ConditionError as error:
        return error.message


def sweep(count: int, seed: int) -> str:
    """Read a valid and a damaged file in each case."""
    random.seed(seed)
    refused = 0
    for _ in range(count):
        height, width = (random.choice([1, 2, 7, 8, 30, 200]) for _ in range(2))
        draw, read = random.choice(FORMATS)
        data, expected = draw(height, width)
        assert np.allclose(pixels_or_refusal(read, data), expected, rtol=2e-7, atol=0), data
        other = damaged(data)
        found = pixels_or_refusal(read, other)
        if isinstance(found, str):
            assert "sky" in found, (found, other)
            refused += 1
        else:
            assert read is not rgbe.read or np.isfinite(found).all(), other
    return f"{count} pictures read correctly; {refused} damaged ones were refused"


if __name__ == "__main__":
    from fuzz.command import main

    main(sweep, LONG)
