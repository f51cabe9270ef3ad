"""OpenEXR pictures, through the package OpenEXR.

Damaged files are found here, in the headers and the tables of where the chunks of pixels stand
[1]_, before the library makes room for what they promise.  What it cannot decode it leaves out, and
says so on the standard streams; that is caught.

References
----------
.. [1] OpenEXR File Layout, https://openexr.com/en/latest/OpenEXRFileLayout.html
.. [2] OpenEXR, Standard Optional Attributes (`whiteLuminance`, `chromaticities`, `envmap`),
   https://openexr.com/en/latest/StandardOptionalAttributes.html
.. [3] Technical Introduction to OpenEXR (windows, names of channels, luminance and chroma, alpha),
   https://openexr.com/en/latest/TechnicalIntroduction.html
"""

import io
import os
import struct
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, redirect_stdout, suppress
from importlib import import_module
from typing import Any

import numpy as np

from radcalc.distributions.maps import pictures
from radcalc.distributions.maps.pictures import RGB, XYZ, Picture, Y
from radcalc.errors import ConditionError, listed, option, quote
from radcalc.quantities.symbols import LATLONG

FORMAT = "OpenEXR"
VERSION = 2  # of the format; the flags of a file stand above it
DEEP, SEVERAL_PARTS, TILED = 0x800, 0x1000, 0x200
# Lines of a chunk, by the number of the compression; the last four as OpenEXR 3.5 writes them.
LINES = (1, 1, 1, 16, 32, 16, 32, 32, 32, 256, 256, 32, 256, 1)
DWAA = 8  # the first compression that is by transforms, and without a limit for an even picture
# Samples that a byte holds at most in those before it: deflate, the closest, makes 1 of 1032 bytes,
# and a sample has two of them or more.
DENSEST = 516
TILE = 1 << 20  # pixels that a tile may have in a smaller picture: the library makes room for all
XYZ_PRIMARIES = (1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1 / 3, 1 / 3)  # as which R, G, B are X, Y, Z
ENVMAP_LATLONG, ENVMAP_CUBE = 0, 1
# Attributes that radcalc writes for itself; other programs pass over them.
UNIT, WEIGHTS, PROJECTION = "radcalcUnit", "radcalcWeights", "radcalcProjection"
ASCII = bytes(range(128)) + b"?" * 128  # of each byte
_Places = dict[str, tuple[str, slice]]  # type and place of the value of each attribute


def read(data: bytes, name: str, channel: str = "") -> Picture:
    """Read an OpenEXR picture: its R, G and B, else its Y; or one channel alone.

    Parameters
    ----------
    data : bytes
        What the file holds: scan lines or tiles (of levels the full one), of one or more parts.
    name : str
        The file, as errors name it.
    channel : str, optional
        The channel to read alone, of any layer: "Z", "diffuse.R"; in any case.

    Returns
    -------
    Picture
        Half floats are widened.  Of several parts the first that has R, G and B, else the first
        that has Y; of luminance and chroma the luminance.  Where the file has a `whiteLuminance`
        its pixels are multiplied by it, and are in cd/m2.  A map with an `envmap` is all of its
        data window; else the pixels are cut to the display window, and have a frame where they do
        not fill it.

    Raises
    ------
    ConditionError
        If it is damaged, deep or a cube, or has neither R, G and B nor Y; if the package OpenEXR
        is missing.

    References
    ----------
    [1]_, [2]_, [3]_

    Examples
    --------
    >>> read(b"v/1\\x01\\x02\\0\\0\\0", "sky.exr")
    Traceback (most recent call last):
    radcalc.errors.ConditionError: sky.exr is damaged: its header ends early
    try: another copy of it
    """
    parts = _parts(data, name)
    number, channels = _one(parts, channel, name) if channel else _main(parts, name)
    part = parts[number]
    _check_place(part, name)
    planes = _planes(data, parts, number, channels, name)
    pixels = np.empty((part.height, part.width, len(channels)), np.float32)
    for k, key in enumerate(channels):
        pixels[..., k] = planes[key]
    assumptions, notes = [], []
    if len(parts) > 1:
        label = f" ('{quote(part.label)}')" if part.label else ""
        notes.append(
            f"of {len(parts)} parts, part {number + 1}{label} is read: the first with "
            f"{', '.join(channels)}"
        )
    if not channel and channels == Y and "RY" in part.channels:
        notes.append("of luminance and chroma, the luminance is read")
    if "A" in planes and channels != ("A",) and (clear := np.mean(planes["A"] < 1)):
        notes.append(
            f"{100 * clear:.3g} % of the pixels have an alpha below 1; their colours, which are "
            "multiplied by it, count as they are"
        )
    unit = part.unit
    if (white := part.white_luminance) is not None:
        if 0 < white < np.inf:
            pixels *= np.float32(white)
            unit = "cd/m2"
            assumptions.append(f"pixels are times the file's whiteLuminance of {white:g} cd/m2")
        else:
            notes.append(f"the file's whiteLuminance of {white:g} cd/m2 tells no unit")
    projection, frame = part.projection, None
    if part.environment is None:
        pixels, frame = _cut(pixels, part)
    else:
        projection = LATLONG
        assumptions.append(
            "the edges of the map's first and last row are the poles (OpenEXR itself has the "
            "centres of their pixels there)"
        )
    if len(channels) == 1:
        weights: tuple[float, ...] = (1.0,)
    elif part.weights:
        weights = part.weights
    elif part.chromaticities:
        weights = pictures.luminance_weights(part.chromaticities, name)
    else:
        weights = pictures.REC_709
        assumptions.append(pictures.BY_REC_709)
    return Picture(
        pixels, channels, weights, FORMAT, unit, projection, frame, tuple(assumptions), tuple(notes)
    )


def write(path: str, picture: Picture) -> tuple[str, ...]:
    """Write an OpenEXR picture over an empty file: 32-bit floats, compressed without loss.

    A latlong map is marked as one, cd/m2 by a `whiteLuminance` of 1.  X, Y, Z are written as R, G,
    B with the primaries that make them so.  Returns what is to be told.

    Raises
    ------
    ConditionError
        If the package OpenEXR is missing.
    OSError
        If it cannot be written.
    """
    openexr = library()
    height, width, _ = picture.pixels.shape
    left, top, full_width, full_height = picture.frame or (0, 0, width, height)
    header: dict[str, Any] = {
        "compression": openexr.ZIP_COMPRESSION,
        "type": openexr.scanlineimage,
        "dataWindow": ((left, top), (left + width - 1, top + height - 1)),
        "displayWindow": ((0, 0), (full_width - 1, full_height - 1)),
    }
    if picture.projection == LATLONG and not picture.frame:
        header["envmap"] = openexr.ENVMAP_LATLONG
    elif picture.projection:
        header[PROJECTION] = picture.projection
    if picture.unit == "cd/m2":
        header["whiteLuminance"] = 1.0
    elif picture.unit:
        header[UNIT] = picture.unit
    names, notes = picture.channels, tuple[str, ...]()
    if names == RGB and picture.weights != pictures.REC_709:
        header[WEIGHTS] = np.array(picture.weights, np.float32)
        notes = ("the primaries of R, G, B are not in the file, but what gives their luminance",)
    if names == XYZ:
        header["chromaticities"], names = XYZ_PRIMARIES, RGB
    planes = {
        name: np.ascontiguousarray(picture.pixels[..., k], np.float32)
        for k, name in enumerate(names)
    }
    made = io.BytesIO()
    openexr.File(header, planes).write(made)
    with open(path, "wb") as file:
        file.write(made.getbuffer())
    return notes


def library() -> Any:
    """The package OpenEXR; a ConditionError where it is missing."""
    try:
        return import_module("OpenEXR")
    except ImportError:
        raise ConditionError(
            "OpenEXR pictures need the package OpenEXR, which is missing",
            "pip install 'radcalc[maps]'",
        ) from None


class _Part:
    """What the header of a part says; a ValueError or a KeyError where it is none."""

    def __init__(self, data: bytes, places: _Places, is_tiled: bool) -> None:
        attributes = {name: data[place] for name, (_, place) in places.items()}
        self._attributes = attributes
        self.texts = [place for kind, place in places.values() if kind == "string"]
        self.label = attributes.get("name", b"").decode("utf-8", "replace")
        kind = attributes.get("type", b"tiledimage" if is_tiled else b"scanlineimage")
        self.is_deep = kind.startswith(b"deep")
        self.is_tiled = kind == b"tiledimage"
        self.left, self.top, self.width, self.height = self._window("dataWindow")
        shown = self._window("displayWindow")
        self.shown_left, self.shown_top, self.shown_width, self.shown_height = shown
        self.channels = dict(_channels(attributes["channels"]))
        (self.compression,) = self._numbers("compression", "B")
        self.environment = self._numbers("envmap", "B")[0] if "envmap" in attributes else None
        self.white_luminance: float | None = None
        if "whiteLuminance" in attributes:
            (self.white_luminance,) = self._numbers("whiteLuminance", "f")
        self.chromaticities: tuple[float, ...] = ()
        if "chromaticities" in attributes:
            self.chromaticities = self._numbers("chromaticities", "8f")
        self.unit, self.projection = (
            quote(attributes.get(own, b"").decode("utf-8", "replace")) for own in (UNIT, PROJECTION)
        )
        self.weights: tuple[float, ...] = ()
        if WEIGHTS in attributes:
            self.weights = self._numbers(WEIGHTS, "3f")
        tile = self._numbers("tiles", "2IB") if self.is_tiled else (0, 0)
        self.tile: tuple[int, int] = tile[:2]

    def _numbers(self, attribute: str, layout: str) -> tuple[Any, ...]:
        return struct.unpack(f"<{layout}", self._attributes[attribute])

    def _window(self, attribute: str) -> tuple[int, int, int, int]:
        """Left, top, width and height."""
        left, top, right, bottom = self._numbers(attribute, "4i")
        return left, top, right - left + 1, bottom - top + 1

    def is_shown(self) -> bool:
        """Whether the windows overlap."""
        return (
            -self.width < self.left - self.shown_left < self.shown_width
            and -self.height < self.top - self.shown_top < self.shown_height
        )

    def samples(self) -> int:
        """How many there are of all channels."""
        pixels = self.width * self.height
        return sum(pixels // max(1, across * down) for across, down in self.channels.values())

    def chunks(self) -> int:
        """How many there are of the full level, whose chunks come first in the table."""
        wide, high = self.tile
        if self.is_tiled:
            return -(-self.width // wide) * -(-self.height // high)
        return -(-self.height // LINES[self.compression])

    def entries(self) -> int:
        """How many the table has, where the header says it."""
        if "chunkCount" in self._attributes:
            return int(self._numbers("chunkCount", "i")[0])
        return self.chunks()


def _parts(data: bytes, name: str) -> list[_Part]:
    """The parts of a file that has all the pixels that they promise."""
    try:
        (flags,) = struct.unpack_from("<I", data, 4)
        headers, place = _headers(data, bool(flags & SEVERAL_PARTS))
        parts = [_Part(data, places, bool(flags & TILED)) for places in headers]
    except (ValueError, struct.error):
        raise _damaged(name, "its header ends early") from None
    except KeyError as error:
        raise _damaged(name, f"its header has no {error.args[0]}") from None
    if flags & 0xFF != VERSION:
        raise ConditionError(
            f"{name} is of version {flags & 0xFF} of OpenEXR, which is not read", "version 2"
        )
    if flags & DEEP or any(part.is_deep for part in parts):
        raise ConditionError(
            f"{name} is deep: its pixels have several samples, in different distances",
            "a flat picture",
        )
    for part in parts:
        _check_size(part, name)
        place = _check_chunks(data, place, part, 4 if flags & SEVERAL_PARTS else 0, name)
    room = 4 * sum(map(_Part.samples, parts))
    if room > pictures.MOST_BYTES:
        raise ConditionError(
            f"{name} has {room >> 20} MiB of pixels, more than {pictures.MOST_BYTES >> 20}",
            "the part and the channels that are needed, in a file of their own",
        )
    return parts


def _headers(data: bytes, several: bool) -> tuple[list[_Places], int]:
    """Where the attributes of each part stand, and where the tables begin."""
    place, headers = 8, list[_Places]()
    while True:
        places, place = _attributes(data, place)
        if several and not places:
            return headers, place
        headers.append(places)
        if not several:
            return headers, place


def _attributes(data: bytes, place: int) -> tuple[_Places, int]:
    """Where the attributes of one part stand, and where they end."""
    found: _Places = {}
    while data[place : place + 1] != b"\0":
        label, place = _text(data, place)
        kind, place = _text(data, place)
        (size,) = struct.unpack_from("<i", data, place)
        place += 4
        if not 0 <= size <= len(data) - place:
            raise ValueError
        found[label] = kind, slice(place, place + size)
        place += size
    return found, place + 1


def _text(data: bytes, place: int) -> tuple[str, int]:
    """A text of 255 bytes at most, and where it ends."""
    end = data.index(b"\0", place, place + 256)
    return data[place:end].decode("utf-8", "replace"), end + 1


def _channels(data: bytes) -> Iterator[tuple[str, tuple[int, int]]]:
    """The channels by name: of how many columns and rows they have one sample."""
    place = 0
    while data[place : place + 1] != b"\0":
        label, place = _text(data, place)
        yield label, struct.unpack_from("<8x2i", data, place)
        place += 16


def _check_size(part: _Part, name: str) -> None:
    pictures.check_size(part.width, part.height, name)
    pictures.check_size(part.shown_width, part.shown_height, f"the display window of {name}")
    if part.compression >= len(LINES):
        raise ConditionError(
            f"{name} has pixels of compression {part.compression}, which is not known",
            "the same with compression zip",
        )
    wide, high = part.tile
    if part.is_tiled and not 0 < wide * high <= max(TILE, part.width * part.height):
        raise _damaged(
            name, f"tiles of {wide} x {high} pixels, in {part.width} x {part.height} pixels"
        )


def _check_chunks(data: bytes, place: int, part: _Part, extra: int, name: str) -> int:
    """Refuse a part of which a chunk is missing; else where its table ends.

    A chunk begins with its place (behind `extra` bytes) and the size of what follows.
    """
    count, entries = part.chunks(), part.entries()
    is_too_dense = part.compression < DWAA and part.samples() > DENSEST * len(data)
    if is_too_dense or entries < count or place + 8 * entries > len(data):
        raise _damaged(name, f"{len(data)} bytes, too few for {part.width} x {part.height} pixels")
    starts = np.frombuffer(data, "<u8", count, place)
    head = extra + (20 if part.is_tiled else 8)
    is_there = (starts > 0) & (starts <= len(data) - head)
    ends = starts[is_there].astype(np.int64) + head
    sizes = np.frombuffer(data, np.uint8)[ends[:, None] + np.arange(-4, 0)].view("<i4")[:, 0]
    whole = np.count_nonzero((sizes >= 0) & (sizes <= len(data) - ends))
    if whole < count:
        raise _damaged(name, f"{count - whole} of the {count} chunks of its pixels are missing")
    return place + 8 * entries


def _main(parts: Sequence[_Part], name: str) -> tuple[int, tuple[str, ...]]:
    """The number of the part that is read, and its channels."""
    for wanted in (RGB, Y):
        for number, part in enumerate(parts):
            if set(wanted) <= part.channels.keys():
                return number, _sampled(part, wanted, name)
    raise _has_no(parts, f"{name} has neither R, G, B nor Y")


def _one(parts: Sequence[_Part], channel: str, name: str) -> tuple[int, tuple[str, ...]]:
    """The number of the first part that has a channel, by its name in any case, and the name."""
    for number, part in enumerate(parts):
        for own in part.channels:
            if own.lower() == channel.lower():
                return number, _sampled(part, (own,), name)
    raise _has_no(parts, f"{name} has no channel '{quote(channel)}'")


def _sampled(part: _Part, channels: tuple[str, ...], name: str) -> tuple[str, ...]:
    """Channels that have a sample for each pixel; others are refused."""
    if any(part.channels[channel] != (1, 1) for channel in channels):
        raise ConditionError(
            f"{name} has no {', '.join(channels)} for each of its pixels",
            "a picture that is not subsampled",
        )
    return channels


def _has_no(parts: Sequence[_Part], problem: str) -> ConditionError:
    """What is said where wanted channels are missing, with those that are there."""
    found = list(dict.fromkeys(channel for part in parts for channel in part.channels))
    return ConditionError(
        f"{problem}; it has {quote(listed(found)) or 'no channels'}",
        option("channel", quote(found[0])) if found else "a picture that has some",
    )


def _check_place(part: _Part, name: str) -> None:
    """Refuse pixels whose directions are not known."""
    if part.environment is None and not part.is_shown():
        raise ConditionError(
            f"{name} has no pixels in its display window", "a picture whose windows overlap"
        )
    if part.environment not in (None, ENVMAP_LATLONG):
        kind = "a cube" if part.environment == ENVMAP_CUBE else f"of kind {part.environment}"
        raise ConditionError(
            f"{name} is an environment map that is {kind}, which is not read",
            "the same as latlong (exrenvmap -l converts it)",
        )


def _with_utf8(data: bytes, parts: Sequence[_Part]) -> bytes:
    """A file with ? in those of its texts that are not UTF-8, which the library refuses."""
    places = [place for part in parts for place in part.texts]
    wrong = [place for place in places if not _is_utf8(data[place])]
    if not wrong:
        return data
    mended = bytearray(data)
    for place in wrong:
        mended[place] = data[place].translate(ASCII)
    return bytes(mended)


def _is_utf8(text: bytes) -> bool:
    return text.decode("utf-8", "ignore").encode() == text


def _planes(
    data: bytes, parts: Sequence[_Part], number: int, channels: Sequence[str], name: str
) -> dict[str, Any]:
    """The pixels of the channels of a part, and of its alpha if there is one."""
    openexr = library()
    with _caught() as said:
        try:
            whole = io.BytesIO(_with_utf8(data, parts))
            file = openexr.File(whole, separate_channels=True)
            # it leaves a part out of which it cannot decode a chunk
            if len(file.parts) == len(parts):
                found = file.parts[number].channels
                return {key: found[key].pixels for key in (*channels, "A") if key in found}
        except Exception as error:  # of many classes, by what is damaged
            said.write(str(error))
    problem = said.getvalue().strip().rpartition(" - ")[2].partition("\n")[0]
    raise _damaged(name, f"its pixels cannot be read ({quote(problem)})")


@contextmanager
def _caught() -> Iterator[io.StringIO]:
    """What is printed to standard output; what is written to standard error is lost.

    The library writes to the descriptor of standard error, which only this keeps from the user.
    """
    said, kept = io.StringIO(), None
    with suppress(OSError):  # it is closed
        kept = os.dup(2)
    try:
        if kept is not None:
            with open(os.devnull, "wb") as nowhere:
                os.dup2(nowhere.fileno(), 2)
        with redirect_stdout(said):
            yield said
    finally:
        if kept is not None:
            os.dup2(kept, 2)
            os.close(kept)


def _cut(pixels: Any, part: _Part) -> tuple[Any, tuple[int, int, int, int] | None]:
    """The pixels within the display window, and their frame where they do not fill it."""
    left, top = part.left - part.shown_left, part.top - part.shown_top
    rows = slice(max(0, -top), part.shown_height - top)
    within = pixels[rows, max(0, -left) : part.shown_width - left]
    if within.shape[:2] == (part.shown_height, part.shown_width):
        return within, None
    return within, (max(0, left), max(0, top), part.shown_width, part.shown_height)


def _damaged(name: str, problem: str) -> ConditionError:
    return ConditionError(f"{name} is damaged: {problem}", "another copy of it")
