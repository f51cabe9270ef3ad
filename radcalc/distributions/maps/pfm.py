"""Portable float maps (.pfm): three lines of text, and 32-bit floats of one or three channels.

Rows begin at the bottom, as in Debevec's HDR Shop and Netpbm's pfm(5); Photoshop begins at the top,
which cannot be seen from the file.  The sign of the scale in the third line is the byte order
(negative: little-endian).  Its absolute value multiplies all pixels here, as in OpenImageIO and
pbrt; other programs ignore it.
"""

import re
from typing import Any

import numpy as np

from radcalc.distributions.maps.pictures import (
    BY_REC_709,
    REC_709,
    RGB,
    XYZ,
    Picture,
    Y,
    check_size,
)
from radcalc.errors import ConditionError, quote
from radcalc.files import columns

FORMAT = "PFM"
HEADER = re.compile(rb"P([Ff])\s+(-?\d{1,15})\s+(-?\d{1,15})\s+([^\s]{1,40})\s")
FORM = "PF or Pf, width and height, and a scale that is not 0, in three lines"
BLOCK = 1 << 20  # floats to write at a time


def read(data: bytes, name: str) -> Picture:
    """Read a portable float map; negative, infinite and NaN pixels are passed on.

    Raise a ConditionError if the header is wrong, or the size does not fit it.

    >>> read(b"Pf\\n1 2\\n-1\\n" + bytes([0, 0, 0, 64, 0, 0, 128, 63]), "sky.pfm").pixels.tolist()
    [[[1.0]], [[2.0]]]
    """
    head = HEADER.match(data[:200])
    scale = columns.finite(head[4].decode("latin-1"), False) if head else None
    if not head or not scale:
        begin = data[:200].decode("latin-1").replace("\n", " ")
        raise ConditionError(f"{name} is not a PFM picture: it begins with '{quote(begin)}'", FORM)
    channels = RGB if head[1] == b"F" else Y
    width, height = int(head[2]), int(head[3])
    check_size(width, height, name)
    size, start = 4 * width * height * len(channels), head.end()
    if len(data) == start + size + 1 and data[start - 1 : start + 1] == b"\r\n":
        start += 1
    if len(data) != start + size:
        problem = f"{name} has {len(data) - start} bytes of pixels, but its size requires {size}"
        raise ConditionError(problem, "the complete file")
    stored = np.frombuffer(data, "<f4" if scale < 0 else ">f4", offset=start)
    pixels = np.array(stored.reshape(height, width, -1)[::-1], np.float32)
    notes: tuple[str, ...] = ()
    if abs(scale) != 1:
        with np.errstate(over="ignore", invalid="ignore"):
            pixels *= np.float32(abs(scale))
        notes = (f"all pixels are multiplied by {abs(scale):g}, the scale of {name}",)
    if len(channels) == 1:
        return Picture(pixels, channels, (1.0,), FORMAT, notes=notes)
    return Picture(pixels, channels, REC_709, FORMAT, assumptions=(BY_REC_709,), notes=notes)


def write(path: str, picture: Picture) -> tuple[str, ...]:
    """Write a portable float map, little-endian; return a note about lost information.

    Raise a ConditionError for X, Y, Z, which a reader would interpret as R, G, B.
    """
    if picture.channels == XYZ:
        raise ConditionError("PFM has no X, Y, Z", "a Radiance (.hdr) or OpenEXR (.exr) picture")
    height, width, count = picture.pixels.shape
    step = max(1, BLOCK // (width * count))
    with open(path, "wb") as file:
        file.write(f"P{'F' if count == 3 else 'f'}\n{width} {height}\n-1.0\n".encode())
        for bottom in range(height, 0, -step):
            rows: Any = picture.pixels[max(0, bottom - step) : bottom][::-1]
            file.write(rows.astype("<f4").tobytes())
    lost = [f"the unit ({quote(picture.unit)})"] if picture.unit else []
    if count == 3 and picture.weights != REC_709:
        lost.append("the primaries")
    if picture.projection:
        lost.append(f"the projection ({quote(picture.projection)})")
    return (f"PFM does not store {', '.join(lost)}",) if lost else ()
