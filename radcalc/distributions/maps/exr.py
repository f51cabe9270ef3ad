"""OpenEXR pictures, through the package OpenEXR.

The headers are read first, so that sizes are checked before the library allocates memory for
pixels; it detects damage itself.  It prints what it cannot decode; that is caught.

References
----------
.. [1] OpenEXR File Layout, https://openexr.com/en/latest/OpenEXRFileLayout.html
.. [2] OpenEXR, Standard Optional Attributes (`whiteLuminance`, `chromaticities`, `envmap`),
   https://openexr.com/en/latest/StandardOptionalAttributes.html
.. [3] Technical Introduction to OpenEXR (windows, names of channels, layers, luminance and chroma,
   alpha), https://openexr.com/en/latest/TechnicalIntroduction.html
.. [4] ASWF Color Interop Forum, Identifying the Color Space of OpenEXR Files, 1.0.0, and Color
   Space Encodings, https://github.com/AcademySoftwareFoundation/ColorInterop
"""

import io
import os
import re
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, redirect_stdout, suppress
from importlib import import_module
from typing import Any, NamedTuple

import numpy as np

from radcalc.distributions.maps import pictures
from radcalc.distributions.maps.pictures import RGB, XYZ, Picture, Y
from radcalc.errors import MOST, ConditionError, Hint, add, leave_out, listed, quote
from radcalc.quantities.symbols import LATLONG

FORMAT = "OpenEXR"
TILE = 1 << 20  # largest accepted tile [pixels] in a smaller picture: the library allocates all
# The library's time grows with the square of the number of attributes.
LARGEST_HEADER, MOST_ATTRIBUTES = 1 << 20, 1 << 12  # bytes and attributes of all parts
ATTRIBUTE = re.compile(rb"([^\0]{1,255})\0([^\0]{1,255})\0(.{4})", re.DOTALL)  # name, type, size
MULTIPART = 0x10  # in the second byte of the version
# Attributes with their types.  If they are damaged, the library is silent: it takes windows of
# 64 x 64 pixels, and no envmap.
WINDOWS = {(b"dataWindow", b"box2i"), (b"displayWindow", b"box2i")}
ENVMAP = (b"envmap", b"envmap")
# Attributes that declare a colour space [4]_, and values.
SPACE, ACES, CHROMATICITIES = "colorInteropID", "acesImageContainerFlag", "chromaticities"
ACES_SPACE, XYZ_SPACE, DATA = "lin_ap0_scene", "lin_ciexyzd65_scene", "data"
UNKNOWN_SPACES = ("", "unknown", DATA)
XYZ_WEIGHTS, TOLERANCE = (0.0, 1.0, 0.0), 1e-3  # of weights, about that of chromaticities [4]_
LINEAR = "the same in lin_rec709_scene (oiiotool converts it)"
ENCODED = re.compile(r"(?:srgbe?|g\d\d|pq|hlg)_")
# Warnings of the library that are no contradictions.
GAPS = ("EMPTY_INTEROP_ID", "ACES_FLAG_NO_CHROMATICITIES", "DATA_HAS_CHROMATICITIES")
# Attributes without effect, with their usual values.  OpenImageIO writes the one of Exif.
UNREAD = {
    "pixelAspectRatio": (1, "but its pixels are read as square"),
    "Orientation": (1, "but its pixels are not turned"),
}
XYZ_PRIMARIES = (1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1 / 3, 1 / 3)  # with these, R, G, B are X, Y, Z
COLOURS = ("r", "g", "b", "red", "green", "blue")  # no radiance alone
# Attributes that radcalc writes; other programs ignore them.
UNIT, WEIGHTS, PROJECTION = "radcalcUnit", "radcalcWeights", "radcalcProjection"
ASCII = bytes(range(128)) + b"?" * 128  # of each byte


def read(data: bytes, name: str, channel: str = "") -> Picture:
    """Read an OpenEXR picture: R, G and B, else X, Y and Z, else Y; or a named channel or layer.

    The largest level of tiles is read, and half floats are widened.  Of several parts, the first
    with R, G and B is read; of luminance and chroma, the luminance.  With a `whiteLuminance` in the
    file, pixels are multiplied by it, and are in cd/m2.  A map with an `envmap` is its whole data
    window; otherwise the pixels are cut to the display window, and have a frame if they do not fill
    it.  The luminance follows the colour space of the file.

    Raises
    ------
    ConditionError
        If it is damaged, deep, a cube or too large, or has no such channels; if its colour space is
        unknown, contradictory or not linear; if the package OpenEXR is missing.
    """
    file = io.BytesIO(data)
    parts = _parts(file, name)
    chosen = _named(parts, channel, name) if channel else _main(parts, name)
    number, channels = chosen.number, chosen.channels
    part = parts[number]
    _check_directions(part, name)
    weights, of_colours = _colours(parts, chosen, channel, name)
    planes = _planes(file, len(parts), chosen, name)
    _, _, width, height = part.pixels
    pixels = np.empty((height, width, len(channels)), np.float32)
    for k, key in enumerate(channels):
        if planes[key].dtype.kind == "u":
            problem = f"{name} has whole numbers (UINT) in {quote(key)}, whose scale is unknown"
            raise ConditionError(problem, "a picture of floats")
        pixels[..., k] = planes[key]
    assumptions, notes = [], [f"{name} has {text}" for text in part.unread]
    if channel:
        alone = chosen.channels == chosen.roles and len(channels) == 1
        text = f"the channel {quote(channels[0])} alone" if alone else f"the layer {quote(channel)}"
        assumptions.append(text)
    if len(parts) > 1 and part.label.lower() != channel.lower():
        label = f" ('{quote(part.label)}')" if part.label else ""
        notes.append(
            f"part {number + 1}{label} of {len(parts)} is read: the first with "
            f"{quote(', '.join(channels))}"
        )
    if not channel and channels == Y and "RY" in part.channels:
        notes.append("only the luminance is read, not the chroma")
    if chosen.alpha and (clear := np.mean(planes[chosen.alpha] < 1)):
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
    assumptions += of_colours
    made = Picture(pixels, chosen.roles, weights, FORMAT, unit, projection, frame)
    return made._replace(
        assumptions=tuple(assumptions), notes=tuple(notes), is_chosen=bool(channel)
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
        header[CHROMATICITIES], names = XYZ_PRIMARIES, RGB
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
        problem = "OpenEXR pictures need the package OpenEXR, which is missing"
        raise ConditionError(problem, "pip install 'radcalc[maps]'") from None


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
        self.chromaticities = _floats(header, CHROMATICITIES, 8)
        self.space = quote(header.get(SPACE, ""))
        names = (SPACE, ACES, CHROMATICITIES)
        self.claims = {key: header[key] for key in names if key in header}
        self.unread = [
            f"{attribute}={quote(str(header[attribute]))}, {meaning}"
            for attribute, (usual, meaning) in UNREAD.items()
            if header.get(attribute, usual) != usual
        ]
        self.unit = quote(str(header.get(UNIT, "")))
        self.projection = quote(str(header.get(PROJECTION, "")))
        self.weights = _floats(header, WEIGHTS, 3)

    def room(self) -> int:
        """Return the bytes that the samples of all channels take, as floats."""
        wide, high = self.tile
        pixels = max(self.pixels.width * self.pixels.height, wide * high)
        return sum(4 * (pixels // (across * down)) for across, down in self.channels.values())

    def group(self, layer: str, roles: tuple[str, ...]) -> tuple[str, ...]:
        """Return the channels of a layer with these roles, () without all; R, G, B in any case."""
        split = [(channel.rpartition("."), channel) for channel in self.channels]
        own = {role: channel for (of, _, role), channel in split if of.lower() == layer.lower()}
        if roles == RGB:
            colours = {role[0].upper(): own[role] for role in own if role.lower() in COLOURS}
            own = colours | own
        elif roles == Y and "X" in own:  # a vector
            return ()
        return tuple(own[role] for role in roles if set(roles) <= own.keys())


def _window(corners: Any) -> _Window:
    (left, top), (right, bottom) = (corner.tolist() for corner in corners)
    return _Window(left, top, right - left + 1, bottom - top + 1)


def _floats(header: dict[str, Any], attribute: str, count: int) -> tuple[float, ...]:
    if attribute not in header:
        return ()
    return tuple(np.array(header[attribute], float).reshape(count).tolist())


class _Chosen(NamedTuple):
    """The channels to read: number of the part, their names and roles (R, G, B ...), and alpha."""

    number: int
    channels: tuple[str, ...]
    roles: tuple[str, ...]
    alpha: str = ""


def _parts(file: io.BytesIO, name: str) -> list[_Part]:
    """Read the headers, and refuse pixels that are deep or too many.

    In texts that are not UTF-8, which the library refuses, ? replaces other characters than ASCII.
    """
    library()
    data = file.getvalue()
    attributes = _attributes(data, name)
    for _, kind, start, end in attributes:
        text = data[start:end] if kind == b"string" else b""
        if text != text.decode(errors="ignore").encode():
            file.seek(start)
            file.write(text.translate(ASCII))
    declared = {attribute[:2] for attribute in attributes}
    try:
        with _caught():
            parts = [_Part(part) for part in _opened(file, header_only=True)]
    except Exception:  # of many classes, depending on the damage
        raise _damaged(name) from None
    if not declared >= WINDOWS:
        raise _damaged(name)
    maps = [part.environment for part in parts if part.environment is not None]
    if (ENVMAP in declared and not maps) or not all(isinstance(m, library().Envmap) for m in maps):
        problem = f"{name} is an environment map of an unknown kind, which is not read"
        raise ConditionError(problem, "a latlong map")
    if any(part.is_deep for part in parts):
        problem = f"{name} is deep: its pixels have several samples, at different distances"
        raise ConditionError(problem, "a flat picture")
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


def _attributes(data: bytes, name: str) -> list[tuple[bytes, bytes, int, int]]:
    """Return name, type, start and end of the attributes of all parts [1]_; refuse long headers."""
    at, found = 8, list[tuple[bytes, bytes, int, int]]()
    is_multipart = data[5:6] > bytes([MULTIPART - 1])
    while at < LARGEST_HEADER and len(found) < MOST_ATTRIBUTES:
        if match := ATTRIBUTE.match(data, at):
            start, at = match.end(), match.end() + int.from_bytes(match[3], "little")
            found.append((match[1], match[2], start, at))
        elif data[at : at + 1] != b"\0":
            raise _damaged(name)
        elif not is_multipart or data[at + 1 : at + 2] == b"\0":
            return found
        else:
            at += 1
    if at > len(data):
        raise _damaged(name)
    limits = f"{LARGEST_HEADER >> 20} MiB or {MOST_ATTRIBUTES} attributes"
    problem = f"the header of {name} has more than {limits}"
    raise ConditionError(problem, "a copy with few attributes")


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


def _main(parts: Sequence[_Part], name: str) -> _Chosen:
    """Return the channels of the first part with R, G, B, else with X, Y, Z, else with Y."""
    for roles in (RGB, XYZ, Y):
        for number, part in enumerate(parts):
            if channels := part.group("", roles):
                return _checked(part, _Chosen(number, channels, roles), name)
    raise _missing(parts, f"{name} has neither R, G, B nor Y", _layers(parts))


def _named(parts: Sequence[_Part], wanted: str, name: str) -> _Chosen:
    """Return a channel, in any case; else those of a layer, or of a part with that name."""
    for number, part in enumerate(parts):
        for channel in part.channels:
            if channel.lower() == wanted.lower():
                return _checked(part, _Chosen(number, (channel,), (channel,)), name)
    layers = [(number, wanted) for number in range(len(parts))]
    labels = [(k, "") for k, part in enumerate(parts) if part.label.lower() == wanted.lower()]
    for number, layer in layers + labels:
        for roles in (RGB, Y):
            if channels := parts[number].group(layer, roles):
                return _checked(parts[number], _Chosen(number, channels, roles), name)
    proposed = _layers(parts)
    if any(part.group("", roles) for part in parts for roles in (RGB, XYZ, Y)):
        proposed = [leave_out("channel")]
    raise _missing(parts, f"{name} has no channel '{quote(wanted)}'", proposed)


def _checked(part: _Part, chosen: _Chosen, name: str) -> _Chosen:
    """Return a choice with its alpha; refuse channels that do not have a sample for each pixel."""
    if any(part.channels[channel] != (1, 1) for channel in chosen.channels):
        problem = f"{name} does not have {quote(', '.join(chosen.channels))} for each pixel"
        raise ConditionError(problem, "a picture that is not subsampled")
    layer, dot, _ = chosen.channels[0].rpartition(".")
    alpha = f"{layer}{dot}A"
    has_alpha = alpha in part.channels and chosen.channels != (alpha,)
    return chosen._replace(alpha=alpha if has_alpha else "")


def _layers(parts: Sequence[_Part]) -> list[Any]:
    """Propose the first layers that have R, G, B or Y."""
    names = dict.fromkeys(
        layer
        for part in parts
        for layer in (channel.rpartition(".")[0] for channel in part.channels)
        if layer and (part.group(layer, RGB) or part.group(layer, Y))
    )
    return [add("channel", layer) for layer in [*names][:MOST]]


def _missing(parts: Sequence[_Part], problem: str, proposed: Hint) -> ConditionError:
    channels = list(dict.fromkeys(channel for part in parts for channel in part.channels))
    others = [name for name in channels if name.rpartition(".")[2].lower() not in COLOURS]
    if not proposed and others:
        proposed = add("channel", others[0])
    return ConditionError(
        f"{problem}; it has {quote(listed(channels)) or 'no channels'}",
        proposed or "a picture with R, G and B",
    )


def _colours(
    parts: Sequence[_Part], chosen: _Chosen, wanted: str, name: str
) -> tuple[tuple[float, ...], list[str]]:
    """Return the weights of the channels in the luminance, and assumptions.

    The colour space of the first part is that of all parts that declare none [4]_.
    """
    openexr, part = library(), parts[chosen.number]
    claims = {**parts[0].claims, **part.claims}
    contradictions = openexr.checkColorMetadata(claims)
    for gap in GAPS:
        contradictions &= ~int(getattr(openexr.ColorMetadataWarning, gap))
    if contradictions:
        first = contradictions & -contradictions
        raise _contradictory(name, openexr.colorMetadataWarningToString(first))
    space = ACES_SPACE if ACES in claims else part.space or parts[0].space
    by_space = _weights_of(space, name)
    if space == DATA and not (wanted and len(chosen.channels) == 1):
        problem = f"{name} has data, not colours: its {SPACE} is {DATA}"
        raise ConditionError(problem, "a picture of colours")
    if len(chosen.channels) == 1:
        return (1.0,), []
    by_file = part.chromaticities and pictures.luminance_weights(part.chromaticities, name)
    stated = {
        WEIGHTS: part.weights,
        "channels X, Y, Z": XYZ_WEIGHTS if chosen.roles == XYZ else (),
        f"{SPACE} {space}": by_space,
        CHROMATICITIES: by_file,
    }
    said = [label for label in stated if stated[label]]
    if not said:
        return pictures.REC_709, [pictures.BY_REC_709]
    for label in said[1:]:
        if not np.allclose(stated[said[0]], stated[label], atol=TOLERANCE):
            raise _contradictory(name, f"its {said[0]} and its {label} differ")
    return stated[said[0]], [f"the file's colour space is {space}"] if by_space else []


def _weights_of(space: str, name: str) -> tuple[float, ...]:
    """Return the luminance weights of a colour space, () if it declares none.

    Raise a ConditionError for one that OpenEXR does not know.
    """
    if space in UNKNOWN_SPACES:
        return ()
    if space == XYZ_SPACE:
        return XYZ_WEIGHTS
    if primaries := library().colorInteropIDToChromaticities(space):
        return pictures.luminance_weights(primaries, name)
    if ENCODED.match(space):
        raise ConditionError(f"{name} is in {space}: its pixels are encoded for display", LINEAR)
    problem = f"{name} is in the colour space '{space}', which OpenEXR does not know"
    raise ConditionError(problem, LINEAR)


def _contradictory(name: str, problem: str) -> ConditionError:
    return ConditionError(
        f"{name} contradicts itself: {problem}", "a copy without the wrong attribute"
    )


def _check_directions(part: _Part, name: str) -> None:
    if part.environment is not None:
        if part.environment != library().ENVMAP_LATLONG:
            problem = f"{name} is an environment map that is a cube, which is not read"
            raise ConditionError(problem, "the same as latlong (exrenvmap -l converts it)")
        return
    pixels, display = part.pixels, part.display
    is_beside = not -pixels.width < pixels.left - display.left < display.width
    is_above_or_below = not -pixels.height < pixels.top - display.top < display.height
    if is_beside or is_above_or_below:
        problem = f"{name} has no pixels in its display window"
        raise ConditionError(problem, "a picture whose windows overlap")


def _planes(file: io.BytesIO, count: int, chosen: _Chosen, name: str) -> dict[str, Any]:
    """Read the channels of a part, and its alpha if there is one."""
    with _caught() as printed:
        try:
            parts = _opened(file)
            # the library leaves out a part if it cannot decode one of its chunks
            if len(parts) == count:
                planes = parts[chosen.number].channels
                wanted = (*chosen.channels, chosen.alpha)
                return {key: planes[key].pixels for key in wanted if key}
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


def _damaged(name: str, problem: str = "its header cannot be read") -> ConditionError:
    return ConditionError(f"{name} is damaged: {problem}", "another copy of it")
