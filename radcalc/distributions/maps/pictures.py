"""Picture files, read by their first bytes and written by their extension; portable float maps.

The other formats have a module each, loaded when needed: `rgbe` and `exr` define
`read(data, name)` and `write(path, picture)`, which writes over an empty file and returns notes (a
tuple of str).  They raise a ConditionError for a bad file or picture; this module handles OSError.

A portable float map (.pfm) has three lines of text, and 32-bit floats of one or three channels.
Rows begin at the bottom, as in Debevec's HDR Shop and Netpbm's pfm(5); Photoshop begins at the top,
which cannot be seen from the file.  The sign of the scale in the third line is the byte order
(negative: little-endian); a picture that has radiances only in the other order is refused.  Its
absolute value multiplies all pixels here, as in OpenImageIO and pbrt; other programs ignore it.
"""

import re
from collections.abc import Callable, Sequence
from importlib import import_module
from typing import Any, NamedTuple

import numpy as np

from radcalc.distributions import contents
from radcalc.errors import ConditionError, quote, quote_path
from radcalc.files import columns, signatures
from radcalc.geometry.projections import Vector, View

# share of the sum of all values: smaller negative values are due to lossy encoding
NOISE = 1e-6
LEAST = 1e-6  # y of a white, and twice the area of a triangle of primaries
FARTHEST = 10.0  # coordinate of a primary
RGB, XYZ, Y = ("R", "G", "B"), ("X", "Y", "Z"), ("Y",)  # the channels of a picture
BY_REC_709 = "the luminance is that of Rec. 709 primaries, as the file declares none"
REC_709 = (0.2126, 0.7152, 0.0722)  # luminance of linear R, G, B in the standard
# A map of 16384x8192, the largest common size, has 1.5 GiB as floats; twice that still fits into
# the memory of a common computer.
PIXELS = 1 << 28
MOST_BYTES = 16 * PIXELS  # of a file: four floats a pixel
# A small file can expand to a very large picture: above 4096x2048 pixels, their number is limited
# by the bytes of the file.  A large map of one colour in RGBE has 15.7 a byte.
FREE_PIXELS, PIXELS_PER_BYTE = 1 << 23, 16
BRIGHTEST, FAINTEST = 3e38, 1e-36  # limits of 32 bits, and of RGBE, without loss of digits
WRITERS = {".hdr": "rgbe", ".pic": "rgbe", ".exr": "exr", ".pfm": "pfm"}  # formats, by extension
PARALLEL = "parallel"  # a projection that does not show directions


class Picture(NamedTuple):
    """A picture as read from a file.

    Attributes
    ----------
    pixels : array of float32, (height, width, channels)
        In the file's unit (an exposure is undone); row 0 is the top.
    channels : tuple of str
        ("R", "G", "B"), ("X", "Y", "Z") or ("Y",); or the name of a requested channel.
    weights : tuple of float
        Luminance of the channels: by the file's primaries, else those of Rec. 709.
    format : str
        "Radiance RGBE", "OpenEXR" or "PFM".
    unit, projection : str
        Those declared by the file, or empty.
    frame : tuple of int, or None
        Left, top, full width and full height, if the pixels are a part of a larger picture.
    view : View, or None
        What the whole picture shows, of the sphere, and `view_text`, by which the file declares it.
    aim, up : tuple of 3 floats, or None
        World directions of its middle and of its top.
    grain : float
        Largest error of a channel by its encoding, as a share of the pixel's brightest channel.
    is_chosen : bool
        Whether the pixels are the channel or the layer that the user named.
    """

    pixels: Any
    channels: tuple[str, ...]
    weights: tuple[float, ...]
    format: str
    unit: str = ""
    projection: str = ""
    frame: tuple[int, int, int, int] | None = None
    assumptions: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()
    view: View | None = None
    view_text: str = ""
    aim: Vector | None = None
    up: Vector | None = None
    grain: float = 0.0
    is_chosen: bool = False


def read_picture(path: str, channel: str = "") -> Picture:
    """Read a picture in a format that its first bytes identify: Radiance, OpenEXR or PFM.

    Negative values become 0 if their sum is less than a millionth of all, as after lossy encoding.
    `channel` selects a channel or a layer of an OpenEXR picture.

    Raises
    ------
    ConditionError
        If it cannot be read, has none of the three formats, or has more than 4 GiB or 2^28
        pixels; also the errors of the format's reader.
    """
    if path == "-":
        raise ConditionError("a picture cannot be read from standard input", "the name of its file")
    name = quote_path(path)
    with contents.opened(path, MOST_BYTES, signatures.PICTURES) as file:
        head = file.read(signatures.HEAD)
        reader = signatures.of_picture(head)
        file.seek(0)
        data = contents.whole(file, MOST_BYTES, path) if reader else b""
    if not reader:
        raise signatures.is_no_picture(head, name)
    read, _ = _functions(reader)
    alone = (channel,) if channel and reader == "exr" else ()
    try:
        return _without_noise(read(data, name, *alone))
    except MemoryError:
        raise ConditionError(f"{name} does not fit into memory", "a smaller picture") from None


def write_picture(path: str, picture: Picture) -> tuple[str, ...]:
    """Write a picture in the format of the extension, completely or not at all.

    Return notes on the information that the format cannot store.  The picture has no frame.  It can
    replace its own source.

    Raises
    ------
    ConditionError
        If the format cannot hold the picture, or the extension is unknown.
    OutputError
        If it cannot be written.
    """
    extension = check_target(path)
    _, write = _functions(WRITERS[extension])
    with contents.written(path) as temporary:
        notes: tuple[str, ...] = write(temporary, picture)
    return notes


def _functions(name: str) -> tuple[Callable[..., Picture], Callable[..., tuple[str, ...]]]:
    """Return the functions that read and write a format; load only the module that is needed."""
    if name == "pfm":
        return read_pfm, write_pfm
    module = import_module(f"radcalc.distributions.maps.{name}")
    return module.read, module.write


def check_target(path: str) -> str:
    """Return the extension of a path; raise errors of `write_picture` that are known in advance.

    >>> check_target("map.png")
    Traceback (most recent call last):
    radcalc.errors.ConditionError: map.png: a map cannot be written as .png
    try: .hdr (Radiance), .exr (OpenEXR) or .pfm
    """
    return contents.check_place(path, WRITERS, "a map", ".hdr (Radiance), .exr (OpenEXR) or .pfm")


def most_pixels(size: int) -> int:
    """Return the number of pixels that a file of a size [bytes] may have."""
    return min(PIXELS, FREE_PIXELS + PIXELS_PER_BYTE * size)


def check_size(width: int, height: int, name: str, size: int | None = None) -> None:
    """Raise an error for a picture with no or too many pixels, before memory is allocated.

    `size` [bytes] is that of the file.
    """
    if width < 1 or height < 1:
        raise ConditionError(f"{name} has {width} x {height} pixels", "a picture that has some")
    if width * height > PIXELS:
        problem = f"{name} has {width} x {height} pixels, more than {PIXELS}"
        raise ConditionError(problem, "a smaller picture")
    if size is not None and width * height > most_pixels(size):
        problem = f"{name} has {width} x {height} pixels in only {size} bytes"
        limit = f"{most_pixels(size)} pixels (a file may have {FREE_PIXELS}, and"
        raise ConditionError(problem, f"at most {limit} {PIXELS_PER_BYTE} for each byte)")


def as_floats(values: Any, unit: str) -> Any:
    """Return the values of a new picture, 0 or more, as 32-bit floats.

    Raise a ConditionError if a value is too large, or all values are too small.
    """
    highest = values.max()
    if not highest < BRIGHTEST:
        problem = f"a picture cannot hold values above {BRIGHTEST:g} {unit}"
        raise ConditionError(problem, "less extreme values")
    if 0 < highest < FAINTEST:
        problem = f"a picture with values up to {highest:g} {unit} would be almost black"
        raise ConditionError(problem, "less extreme values")
    return values.astype(np.float32)


def _without_noise(picture: Picture) -> Picture:
    pixels = picture.pixels
    with np.errstate(invalid="ignore"):  # NaN and infinite values are not noise
        if not pixels.min() < 0:
            return picture
        below = pixels[pixels < 0]
        share = -below.sum(dtype=float) / np.abs(pixels).sum(dtype=float)
    if not share < NOISE:
        return picture
    note = f"{below.size} negative values (down to {below.min():.2g}) count as 0"
    return picture._replace(pixels=np.maximum(pixels, 0), notes=(*picture.notes, note))


def luminance_weights(chromaticities: Sequence[float], name: str) -> tuple[float, ...]:
    """Return the luminance weights of R, G, B, whose sum is 1.

    `chromaticities` are x and y of red, green, blue and white, which is R = G = B.  Raise a
    ConditionError if y of white is not positive, or the primaries are on a line.

    >>> of_709 = (0.64, 0.33, 0.3, 0.6, 0.15, 0.06, 0.3127, 0.329)
    >>> [round(weight, 4) for weight in luminance_weights(of_709, "sky.hdr")]
    [0.2126, 0.7152, 0.0722]
    """
    xy = np.array(chromaticities, float).reshape(4, 2)
    xyz = np.column_stack([xy, 1 - xy.sum(1)]) if np.abs(xy).max() < FARTHEST else np.zeros((4, 3))
    mixed, white = xyz[:3].T, xyz[3]
    # the determinant of three points on a line is 0, up to rounding
    if white[1] < LEAST or abs(np.linalg.det(mixed)) < LEAST:
        numbers = " ".join(f"{value:g}" for value in chromaticities)
        problem = f"{name} has impossible primaries: {quote(numbers)}"
        raise ConditionError(problem, "x and y of red, green, blue and white")
    weights = np.linalg.solve(mixed, white / white[1]) * xyz[:3, 1]
    return tuple(map(float, weights))


PFM = "PFM"
PFM_HEADER = re.compile(rb"P([Ff])\s+(-?\d{1,15})\s+(-?\d{1,15})\s+([^\s]{1,40})\s")
PFM_FORM = "PF or Pf, width and height, and a scale that is not 0, in three lines"
PFM_BLOCK = 1 << 20  # floats to write at a time
USUAL = (1e-30, 1e30)  # limits of the greatest value of a picture, in any unit


def read_pfm(data: bytes, name: str) -> Picture:
    """Read a portable float map; negative, infinite and NaN pixels are passed on.

    Raise a ConditionError if the header is wrong, or the size does not fit it.

    >>> pixels = bytes([0, 0, 0, 64, 0, 0, 128, 63])
    >>> read_pfm(b"Pf\\n1 2\\n-1\\n" + pixels, "sky.pfm").pixels.tolist()
    [[[1.0]], [[2.0]]]
    """
    head = PFM_HEADER.match(data[:200])
    scale = columns.finite(head[4].decode("latin-1"), False) if head else None
    if not head or not scale:
        begin = data[:200].decode("latin-1").replace("\n", " ")
        problem = f"{name} is not a PFM picture: it begins with '{quote(begin)}'"
        raise ConditionError(problem, PFM_FORM)
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
    if not _is_usual(stored) and _is_usual(other := stored.view(stored.dtype.newbyteorder())):
        problem = f"{name} has values up to {stored.max():.3g} in the byte order of its scale"
        hint = f"a copy whose scale, in its third line, has the other sign: {-scale:g}"
        raise ConditionError(f"{problem}, and up to {other.max():.3g} in the other one", hint)
    pixels = np.array(stored.reshape(height, width, -1)[::-1], np.float32)
    notes: tuple[str, ...] = ()
    if abs(scale) != 1:
        with np.errstate(over="ignore", invalid="ignore"):
            pixels *= np.float32(abs(scale))
        notes = (f"all pixels are multiplied by {abs(scale):g}, the scale of {name}",)
    if len(channels) == 1:
        return Picture(pixels, channels, (1.0,), PFM, notes=notes)
    return Picture(pixels, channels, REC_709, PFM, assumptions=(BY_REC_709,), notes=notes)


def _is_usual(values: Any) -> bool:
    """Return whether the values, negative noise apart, are of a size that radiances have."""
    least, most = values.min(), values.max()
    return bool(USUAL[0] < most < USUAL[1] and least > -most) or most == least == 0


def write_pfm(path: str, picture: Picture) -> tuple[str, ...]:
    """Write a portable float map, little-endian; return a note about lost information.

    Raise a ConditionError for X, Y, Z, which a reader would interpret as R, G, B.
    """
    if picture.channels == XYZ:
        raise ConditionError("PFM has no X, Y, Z", "a Radiance (.hdr) or OpenEXR (.exr) picture")
    height, width, count = picture.pixels.shape
    step = max(1, PFM_BLOCK // (width * count))
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
