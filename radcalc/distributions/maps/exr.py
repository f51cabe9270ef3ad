"""OpenEXR pictures, through the package OpenEXR.

The headers are read first, so that sizes are checked before the library allocates memory for
pixels; it detects damage itself.  It prints what it cannot decode; that is caught.

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
from typing import Any, NamedTuple

import numpy as np

from radcalc.distributions.maps import pictures
from radcalc.distributions.maps.pictures import RGB, XYZ, Picture, Y
from radcalc.errors import ConditionError, add, listed, quote
from radcalc.quantities.symbols import LATLONG

FORMAT = "OpenEXR"
TILE = 1 << 20  # largest accepted tile [pixels] in a smaller picture: the library allocates all
TEXTS = 100  # attributes of a file that may not be UTF-8
# Attributes with their types.  If they are damaged, the library is silent: it takes windows of
# 64 x 64 pixels, and no envmap.
WINDOWS = (b"dataWindow\0box2i\0", b"displayWindow\0box2i\0")
ENVMAP = b"envmap\0envmap\0"
HEADER = 1 << 20  # bytes to search for an envmap
XYZ_PRIMARIES = (1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1 / 3, 1 / 3)  # with these, R, G, B are X, Y, Z
# Attributes that radcalc writes; other programs ignore them.
UNIT, WEIGHTS, PROJECTION = "radcalcUnit", "radcalcWeights", "radcalcProjection"
ASCII = bytes(range(128)) + b"?" * 128  # of each byte


def read(data: bytes, name: str, channel: str = "") -> Picture:
    """Read an OpenEXR picture: R, G and B, else Y; or a single channel of any layer, in any case.

    The largest level of tiles is read, and half floats are widened.  Of several parts, the first
    with R, G and B is read, else the first with Y; of luminance and chroma, the luminance.  With a
    `whiteLuminance` in the file, pixels are multiplied by it, and are in cd/m2.  A map with an
    `envmap` is its whole data window; otherwise the pixels are cut to the display window, and have
    a frame if they do not fill it.

    Raises
    ------
    ConditionError
        If it is damaged, deep, a cube or too large, or has neither R, G and B nor Y; if the
        package OpenEXR is missing.
    """
    file = io.BytesIO(data)
    parts = _parts(file, name)
    number, channels = (
        _named_channel(parts, channel, name) if channel else _main_channels(parts, name)
    )
    part = parts[number]
    _check_directions(part, name)
    planes = _planes(file, len(parts), number, channels, name)
    _, _, width, height = part.pixels
    pixels = np.empty((height, width, len(channels)), np.float32)
    for k, key in enumerate(channels):
        pixels[..., k] = planes[key]
    assumptions, notes = [], []
    if len(parts) > 1:
        label = f" ('{quote(part.label)}')" if part.label else ""
        notes.append(
            f"part {number + 1}{label} of {len(parts)} is read: the first with "
            f"{', '.join(channels)}"
        )
    if not channel and channels == Y and "RY" in part.channels:
        notes.append("only the luminance is read, not the chroma")
    if "A" in planes and channels != ("A",) and (clear := np.mean(planes["A"] < 1)):
        notes.append(
            f"{100 * clear:.3g} % of the pixels have an alpha below 1; their colours, which are "
            "premultiplied by alpha, are used unchanged"
        )
    unit = part.unit
    for white in part.white_luminance:
        if 0 < white < np.inf:
            pixels *= np.float32(white)
            unit = "cd/m2"
            assumptions.append(
                f"pixels are multiplied by the file's whiteLuminance of {white:g} cd/m2"
            )
        else:
            notes.append(f"the file's whiteLuminance of {white:g} cd/m2 does not give a unit")
    projection, frame = part.projection, None
    if part.environment is None:
        pixels, frame = _cut(pixels, part)
    else:
        projection = LATLONG
        assumptions.append(
            "the edges of the map's first and last row are the poles (OpenEXR itself defines them "
            "at the pixel centres)"
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

    A latlong map is marked as one, and cd/m2 by a `whiteLuminance` of 1.  X, Y, Z are written as
    R, G, B with the primaries of XYZ.  Return notes for the user.
    """
    openexr = library()
    compression, scanlines = openexr.ZIP_COMPRESSION, openexr.scanlineimage
    header: dict[str, Any] = {"compression": compression, "type": scanlines}
    if picture.projection == LATLONG:
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
        notes = ("the file has the luminance weights of R, G, B, but not their primaries",)
    if names == XYZ:
        header["chromaticities"], names = XYZ_PRIMARIES, RGB
    planes = {
        name: np.ascontiguousarray(picture.pixels[..., k], np.float32)
        for k, name in enumerate(names)
    }
    written = io.BytesIO()
    openexr.File(header, planes).write(written)
    with open(path, "wb") as file:
        file.write(written.getbuffer())
    return notes


def library() -> Any:
    """Return the package OpenEXR; raise a ConditionError if it is missing."""
    try:
        return import_module("OpenEXR")
    except ImportError:
        raise ConditionError(
            "OpenEXR pictures need the package OpenEXR, which is missing",
            "pip install 'radcalc[maps]'",
        ) from None


class _Window(NamedTuple):
    """A rectangle of pixels."""

    left: int
    top: int
    width: int
    height: int


class _Part:
    """The header of a part; an error of any class means that an attribute is damaged."""

    def __init__(self, part: Any) -> None:
        header = part.header
        self.label = part.name()
        self.is_deep = part.type().name.startswith("deep")
        self.pixels = _window(header["dataWindow"])
        self.display = _window(header["displayWindow"])
        # columns and rows that share a sample of a channel
        self.channels = {
            channel.name: (channel.xSampling, channel.ySampling) for channel in header["channels"]
        }
        tile = header.get("tiles")
        self.tile = (tile.xSize, tile.ySize) if tile else (0, 0)
        self.environment = header.get("envmap")
        self.white_luminance = _floats(header, "whiteLuminance", 1)
        self.chromaticities = _floats(header, "chromaticities", 8)
        self.unit = quote(str(header.get(UNIT, "")))
        self.projection = quote(str(header.get(PROJECTION, "")))
        self.weights = _floats(header, WEIGHTS, 3)

    def room(self) -> int:
        """Return the bytes that the samples of all channels take, as floats."""
        wide, high = self.tile
        pixels = max(self.pixels.width * self.pixels.height, wide * high)
        return sum(4 * (pixels // (across * down)) for across, down in self.channels.values())


def _window(corners: Any) -> _Window:
    (left, top), (right, bottom) = (corner.tolist() for corner in corners)
    return _Window(left, top, right - left + 1, bottom - top + 1)


def _floats(header: dict[str, Any], attribute: str, count: int) -> tuple[float, ...]:
    if attribute not in header:
        return ()
    return tuple(np.array(header[attribute], float).reshape(count).tolist())


def _parts(file: io.BytesIO, name: str) -> list[_Part]:
    """Read the headers, and refuse pixels that are deep or too many."""
    library()
    try:
        with _caught():
            parts = [_Part(part) for part in _headers(file)]
        data = file.getvalue()
        is_damaged = not all(window in data for window in WINDOWS)
    except Exception:  # of many classes, depending on the damage
        is_damaged = True
    if is_damaged:
        raise _damaged(name, "its header cannot be read")
    if data.find(ENVMAP, 0, HEADER) >= 0 and all(part.environment is None for part in parts):
        raise ConditionError(
            f"{name} is an environment map of an unknown kind, which is not read", "a latlong map"
        )
    if any(part.is_deep for part in parts):
        raise ConditionError(
            f"{name} is deep: its pixels have several samples, at different distances",
            "a flat picture",
        )
    for part in parts:
        _check_size(part, name, len(data))
    room = sum(map(_Part.room, parts))
    most = 16 * pictures.most_pixels(len(data))  # of four channels
    if room > most:
        raise ConditionError(
            f"{name} has {room >> 20} MiB of pixels in {len(data)} bytes, more than {most >> 20}",
            "only the needed part and channels, in a separate file",
        )
    return parts


def _headers(file: io.BytesIO) -> list[Any]:
    """Read the headers alone, with ? in texts that are not UTF-8, which the library refuses."""
    for _ in range(TEXTS):
        try:
            return _opened(file, header_only=True)
        except UnicodeDecodeError as error:
            text = error.object
            attribute = b"\0string\0" + struct.pack("<i", len(text)) + text
            start = file.getvalue().find(attribute)
            if start < 0:
                raise
            file.seek(start + len(attribute) - len(text))
            file.write(text.translate(ASCII))
    raise ValueError


def _opened(file: io.BytesIO, header_only: bool = False) -> list[Any]:
    file.seek(0)
    parts: list[Any] = library().File(file, separate_channels=True, header_only=header_only).parts
    return parts


def _check_size(part: _Part, name: str, size: int) -> None:
    _, _, width, height = part.pixels
    pictures.check_size(width, height, name, size)
    pictures.check_size(part.display.width, part.display.height, f"the display window of {name}")
    wide, high = part.tile
    if wide * high > max(TILE, width * height):
        raise _damaged(name, f"tiles of {wide} x {high} pixels, in {width} x {height} pixels")


def _main_channels(parts: Sequence[_Part], name: str) -> tuple[int, tuple[str, ...]]:
    """Return the number of the first part with R, G, B, else with Y, and these channels."""
    for wanted in (RGB, Y):
        for number, part in enumerate(parts):
            if set(wanted) <= part.channels.keys():
                return number, _full_size(part, wanted, name)
    raise _missing(parts, f"{name} has neither R, G, B nor Y")


def _named_channel(parts: Sequence[_Part], wanted: str, name: str) -> tuple[int, tuple[str, ...]]:
    """Return the number of the first part with a channel, in any case, and its exact name."""
    for number, part in enumerate(parts):
        for channel in part.channels:
            if channel.lower() == wanted.lower():
                return number, _full_size(part, (channel,), name)
    raise _missing(parts, f"{name} has no channel '{quote(wanted)}'")


def _full_size(part: _Part, channels: tuple[str, ...], name: str) -> tuple[str, ...]:
    """Return the channels; refuse those that do not have a sample for each pixel."""
    if any(part.channels[channel] != (1, 1) for channel in channels):
        raise ConditionError(
            f"{name} does not have {', '.join(channels)} for each pixel",
            "a picture that is not subsampled",
        )
    return channels


def _missing(parts: Sequence[_Part], problem: str) -> ConditionError:
    channels = list(dict.fromkeys(channel for part in parts for channel in part.channels))
    return ConditionError(
        f"{problem}; it has {quote(listed(channels)) or 'no channels'}",
        add("channel", channels[0]) if channels else "a picture that has some",
    )


def _check_directions(part: _Part, name: str) -> None:
    if part.environment is not None:
        if part.environment != library().ENVMAP_LATLONG:
            raise ConditionError(
                f"{name} is an environment map that is a cube, which is not read",
                "the same as latlong (exrenvmap -l converts it)",
            )
        return
    pixels, display = part.pixels, part.display
    is_beside = not -pixels.width < pixels.left - display.left < display.width
    is_above_or_below = not -pixels.height < pixels.top - display.top < display.height
    if is_beside or is_above_or_below:
        raise ConditionError(
            f"{name} has no pixels in its display window", "a picture whose windows overlap"
        )


def _planes(
    file: io.BytesIO, count: int, number: int, channels: Sequence[str], name: str
) -> dict[str, Any]:
    """Read the channels of a part, and its alpha if there is one."""
    with _caught() as printed:
        try:
            parts = _opened(file)
            # the library leaves out a part if it cannot decode one of its chunks
            if len(parts) == count:
                planes = parts[number].channels
                wanted = (*channels, "A") if "A" in planes else channels
                return {key: planes[key].pixels for key in wanted}
        except Exception as error:  # of many classes, depending on the damage
            printed.write(str(error))
    problem = printed.getvalue().strip().rpartition(" - ")[2].partition("\n")[0]
    raise _damaged(name, f"its pixels cannot be read ({quote(problem)})")


@contextmanager
def _caught() -> Iterator[io.StringIO]:
    """Catch what Python prints to standard output, and discard standard error.

    The library writes to the file descriptor of standard error.
    """
    printed, kept = io.StringIO(), None
    with suppress(OSError):  # it is closed
        kept = os.dup(2)
    try:
        if kept is not None:
            with open(os.devnull, "wb") as nowhere:
                os.dup2(nowhere.fileno(), 2)
        with redirect_stdout(printed):
            yield printed
    finally:
        if kept is not None:
            os.dup2(kept, 2)
            os.close(kept)


def _cut(pixels: Any, part: _Part) -> tuple[Any, tuple[int, int, int, int] | None]:
    """Return the pixels within the display window, and their frame if they do not fill it."""
    _, _, width, height = part.display
    left, top = part.pixels.left - part.display.left, part.pixels.top - part.display.top
    within = pixels[max(0, -top) : height - top, max(0, -left) : width - left]
    if within.shape[:2] == (height, width):
        return within, None
    return within, (max(0, left), max(0, top), width, height)


def _damaged(name: str, problem: str) -> ConditionError:
    return ConditionError(f"{name} is damaged: {problem}", "another copy of it")
