"""Radiance pictures (.hdr): a byte each for red, green and blue, or X, Y, Z, and one exponent.

Reading follows Radiance's "File Formats": EXPOSURE and COLORCORR are undone, the scanlines may have
any of the eight orientations, and be flat or in the old or the new run-length encoding.

A channel is mantissa * 2^(exponent - 136), as in OpenImageIO, stb_image and most programs.
Radiance itself reads (mantissa + 0.5) * 2^(exponent - 136), as its writers truncate: its values are
0.2 % to 0.4 % brighter in the brightest channel.  `write` rounds to the nearest value, so that
values read here are right on average.

References
----------
.. [1] Radiance, src/common/image.c, `setview` and `getviewopt`; rpict(1).
"""

import math
import re
from collections.abc import Iterator
from operator import mul
from typing import Any, NamedTuple

import numpy as np

from radcalc._version import __version__
from radcalc.distributions.maps import pictures
from radcalc.distributions.maps.pictures import Picture
from radcalc.errors import ConditionError, quote
from radcalc.files import columns
from radcalc.geometry.projections import UP, view_of_angles
from radcalc.geometry.projections import upright as upright_axes
from radcalc.quantities import symbols

FORMAT = "Radiance RGBE"
RGBE, XYZE = "32-bit_rle_rgbe", "32-bit_rle_xyze"
# Header lines that radcalc writes; other programs ignore them.
UNIT, WEIGHTS, PROJECTION = "RADCALC_UNIT", "RADCALC_WEIGHTS", "RADCALC_PROJECTION"
GREY = "RADCALC_CHANNELS=Y"  # R = G = B, which are read as one channel
SOFTWARE = "radcalc"
VARIABLES = {"EXPOSURE": 1, "COLORCORR": 3, "PIXASPECT": 1, "GAMMA": 1, "PRIMARIES": 8, WEIGHTS: 3}
CUMULATIVE = {"EXPOSURE", "COLORCORR", "PIXASPECT"}
HEADER = 1 << 20  # largest header [bytes]
RESOLUTION = re.compile(r"([-+])([XY])\s+(-?\d{1,15})\s+([-+])([XY])\s+(-?\d{1,15})\s*")
# Types of Radiance's views, and the count of numbers of other options: horizontal and vertical
# angle, shift and lift, direction and up.
SHOWN = (
    symbols.FISHEYE,
    symbols.ORTHOGRAPHIC,
    symbols.STEREOGRAPHIC,
    symbols.PERSPECTIVE,
    symbols.CYLINDRICAL,
    pictures.PARALLEL,
)
VIEWS = dict(zip("ahsvcl", SHOWN, strict=True))
NUMBERS_OF_VIEW = {"h": 1, "v": 1, "s": 1, "l": 1, "d": 3, "u": 3}
EXTREME = 1e20  # limit of factors of pixels, and of their inverses
BIAS = 136  # of the exponent, with the 8 bits of a mantissa
BLOCK = 1 << 17  # pixels to decode at a time, so that they stay in a cache
MARK = 2  # R and G before a scanline of the new run-length encoding
LITERAL = 128  # largest code of literal bytes; larger codes are runs
NEW = range(8, 1 << 15)  # pixels of a scanline that programs encode in the new way
REPEAT = 0x010101  # R, G and B of a repetition in the old run-length encoding
LEAST_RUN, LONGEST_RUN = 4, 127  # shortest useful run; longest run of a code [bytes]
BEYOND = 1.69e38  # limit of the exponent 255
HALF_STEP = (
    "RGBE is read as in most programs; Radiance itself reads half a step, 0.2 % to 0.4 %, more"
)
# The brightest mantissa is from 128 to 255, and other writers may truncate it.
STEP = 1 / 128
OF_PIXEL = "of the brightest channel of each pixel"
TRUNCATED = f"the error includes a step of RGBE, 0.4 % to 0.8 % {OF_PIXEL}"
ROUNDED = f"the error includes half a step of RGBE, 0.2 % to 0.4 % {OF_PIXEL}"
STEPS = "RGBE has a resolution of 1/256 of the brightest channel of a pixel"
CUT_OFF = "is cut off"
MENDED = "the complete file"


class _Damaged(ConditionError):
    """A scanline that cannot be read, or is missing."""

    def __init__(self, what: str, scanline: int, at: int, name: str) -> None:
        problem = f"{name} is damaged: scanline {scanline + 1} {what}, at byte {at}"
        super().__init__(problem, MENDED)
        self.is_cut_off = what == CUT_OFF


class _Header(NamedTuple):
    """The lines before the scanlines, which begin at byte `start`; `picture` has no pixels yet.

    `order` has sign and letter of the axis from scanline to scanline, and along each scanline.
    """

    picture: Picture
    exposure: float
    correction: tuple[float, ...]
    order: tuple[str, str]
    scanlines: int
    length: int
    start: int


def read(data: bytes, name: str) -> Picture:
    """Read a Radiance picture: R, G, B; X, Y, Z in cd/m2; or Y of a grey picture from `write`.

    Raises
    ------
    ConditionError
        If there is no header of a picture, the data are incomplete, or a scanline is damaged;
        with its number and the byte.

    Examples
    --------
    >>> head = b"#?RADIANCE\\nEXPOSURE=2\\nFORMAT=32-bit_rle_rgbe\\n\\n-Y 1 +X 1\\n"
    >>> read(head + bytes([128, 64, 0, 129]), "sky.hdr").pixels.tolist()
    [[[0.5, 0.25, 0.0]]]
    """
    header = _header(data, name)
    shape = header.scanlines, header.length, 4
    # Pixels that are neither normalized nor encoded can look like encoded ones.  A reader that
    # decodes them as such reaches the last scanline before the end of the data.
    may_be_flat = len(data) - header.start == math.prod(shape)
    try:
        pixels, end = _decoded(_scanlines(data, header, name), header)
    except _Damaged as error:
        if error.is_cut_off or not may_be_flat:
            raise
        end = header.start
    if may_be_flat and end < len(data):
        flat = np.frombuffer(data, np.uint8, offset=header.start).reshape(shape).transpose(0, 2, 1)
        step = max(1, BLOCK // header.length)
        firsts = range(0, header.scanlines, step)
        pixels, end = _decoded(((flat[k : k + step], len(data)) for k in firsts), header)
    if min(header.exposure, *header.correction) < 1 and not np.isfinite(pixels).all():
        problem = f"{name}: pixels divided by EXPOSURE are too large for 32 bits"
        raise ConditionError(problem, "the EXPOSURE by which they were multiplied")
    picture = header.picture
    notes = picture.notes
    if end < len(data):
        notes += (f"{name} has {len(data) - end} bytes after the picture",)
    upright = _upright(pixels[..., : len(picture.channels)], header.order)
    return picture._replace(pixels=upright, notes=notes)


def write(path: str, picture: Picture) -> tuple[str, ...]:
    """Write a Radiance picture, with rows in the new run-length encoding if possible.

    A grey picture is written as R = G = B, with a mark in its header.  Return notes on losses.
    Raise a ConditionError for pixels that are negative, not finite, or too large.
    """
    height, width = picture.pixels.shape[:2]
    pixels = np.broadcast_to(picture.pixels, (height, width, 3))
    if not (pixels.min() >= 0 and pixels.max() < BEYOND):
        problem = "RGBE cannot hold pixels that are negative, NaN or above 1.69e38"
        raise ConditionError(problem, "an OpenEXR (.exr) or PFM (.pfm) picture")
    is_xyz = picture.channels == pictures.XYZ
    weights = " ".join(map(repr, picture.weights))
    header = [
        "#?RADIANCE",
        f"SOFTWARE={SOFTWARE} {__version__}",
        f"{UNIT}={picture.unit}",
        f"{PROJECTION}={picture.projection}",
        *([GREY] if len(picture.weights) == 1 else []),
        *([f"{WEIGHTS}={weights}"] if len(picture.weights) == 3 and not is_xyz else []),
        f"FORMAT={XYZE if is_xyz else RGBE}",
        "",
        f"-Y {height} +X {width}",
        "",
    ]
    step = max(1, BLOCK // width)
    with open(path, "wb") as file:
        file.write("\n".join(header).encode())
        for top in range(0, height, step):
            rgbe = _rgbe(pixels[top : top + step])
            if width in NEW:
                mark = bytes([MARK, MARK, *divmod(width, 256)])
                rows = (b"".join([mark, *map(_encoded, row.T)]) for row in rgbe)
                file.write(b"".join(rows))
            else:
                file.write(rgbe.tobytes())
    return (STEPS,)


def _header(data: bytes, name: str) -> _Header:
    """Read the lines before the scanlines, with the exposure, the primaries and the view."""
    lines, start = _header_lines(data, name)
    variables = dict(line.split("=", 1) for line in lines if "=" in line)
    form = variables.get("FORMAT", RGBE).strip()
    if form not in (RGBE, XYZE):
        problem = f"{name} is in the format '{quote(form)}'"
        raise ConditionError(problem, f"a Radiance picture: FORMAT={RGBE} or {XYZE}")
    is_xyz = form == XYZE
    numbers = _numbers(lines, name)
    (exposure,), (aspect,) = numbers.get("EXPOSURE", [1.0]), numbers.get("PIXASPECT", [1.0])
    if numbers.get("GAMMA", [1.0]) != [1.0]:
        gamma = f"GAMMA={quote(variables['GAMMA'])}"
        problem = f"{name} has {gamma}: its pixels are encoded for display"
        raise ConditionError(problem, "a picture whose pixels are proportional to radiance")
    unit = quote(variables.get(UNIT, "cd/m2" if is_xyz else "").strip())
    # as in Radiance's own programs
    no_format = "the pixels are RGBE, as the file has no FORMAT="
    assumptions = [] if "FORMAT" in variables else [no_format]
    weights: tuple[float, ...] = pictures.REC_709
    if is_xyz:
        weights = (0.0, 1.0, 0.0)
        if UNIT not in variables:
            assumptions.append("an XYZE picture is in cd/m2, as Radiance writes it")
    elif GREY in lines:
        weights = (1.0,)
    elif WEIGHTS in numbers:
        weights = tuple(numbers[WEIGHTS])
    elif any(numbers.get("PRIMARIES", [])):  # some programs write eight zeros
        weights = pictures.luminance_weights(numbers["PRIMARIES"], name)
    else:
        assumptions.append(pictures.BY_REC_709)
    is_own = variables.get("SOFTWARE", "").startswith(SOFTWARE)
    assumptions += [ROUNDED] if is_own else [HALF_STEP, TRUNCATED]
    notes = []
    viewed = {} if variables.get(PROJECTION, "").strip() else _viewed(lines, name)
    if aspect != 1 and "view" not in viewed:
        notes.append(f"{name} has PIXASPECT={aspect:g}, but its pixels are read as square")
    picture = Picture(
        None,
        pictures.Y if len(weights) == 1 else pictures.XYZ if is_xyz else pictures.RGB,
        weights,
        FORMAT,
        unit,
        quote(variables.get(PROJECTION, "").strip()),
        assumptions=tuple(assumptions),
        notes=tuple(notes),
        grain=STEP / 2 if is_own else STEP,
    )._replace(**viewed)
    correction = tuple(numbers.get("COLORCORR", (1.0, 1.0, 1.0)))
    return _Header(picture, exposure, correction, *_resolution(data, start, name))


def _header_lines(data: bytes, name: str) -> tuple[list[str], int]:
    start = 0
    lines: list[str] = []
    while (end := data.find(b"\n", start, HEADER)) >= 0:
        line = data[start:end].decode("latin-1").removesuffix("\r")
        start = end + 1
        if not line:
            return lines, start
        lines.append(line)
    raise ConditionError(f"{name}: the header has no end (an empty line)", MENDED)


def _numbers(lines: list[str], name: str) -> dict[str, list[float]]:
    """Return the numbers of the known variables of a header; EXPOSURE and COLORCORR multiply."""
    values: dict[str, list[float]] = {}
    for line in lines:
        key, _, text = line.partition("=")
        if key not in VARIABLES:
            continue
        cells = [columns.finite(cell, False) for cell in text.split()]
        numbers = [number for number in cells if number is not None]
        if not len(numbers) == len(cells) == VARIABLES[key]:
            raise _wrong_line(line, name)
        if key in CUMULATIVE:
            numbers = list(map(mul, numbers, values.get(key, [1.0] * len(numbers))))
            if not all(1 / EXTREME < number < EXTREME for number in numbers):
                raise _wrong_line(line, name)
        values[key] = numbers
    return values


def _viewed(lines: list[str], name: str) -> dict[str, Any]:
    """Return the fields of a picture by its view in Radiance [1]_; none without type and angles."""
    views = " ".join(line.partition("=")[2] for line in lines if line.startswith("VIEW="))
    found: dict[str, Any] = {}
    for part in re.split(r"(?:^|\s)-v", views)[1:]:
        letter, cells = part[:1], part[1:].split()
        if letter == "t":
            found["t"] = "".join(cells[:1])
        elif letter in NUMBERS_OF_VIEW:
            numbers = [columns.finite(cell, False) for cell in cells]
            if len(numbers) != NUMBERS_OF_VIEW[letter] or None in numbers:
                raise _wrong_view(f"-v{part}", name)
            found[letter] = numbers
    if not found.keys() & {"t", "h", "v"}:
        return {}
    kind = found.get("t", "v")
    (across,), (upright,) = found.get("h", [45.0]), found.get("v", [45.0])
    (shift,), (lift,) = found.get("s", [0.0]), found.get("l", [0.0])
    text = f"-vt{kind} -vh {across:g} -vv {upright:g}"
    text += f" -vs {shift:g} -vl {lift:g}" if shift or lift else ""
    if kind not in VIEWS:
        raise _wrong_view(text, name)
    fields: dict[str, Any] = {"view_text": quote(f"VIEW= {text}")}
    if "d" in found:
        fields |= {"aim": tuple(found["d"]), "up": tuple(found.get("u", UP))}
        try:
            upright_axes(fields["aim"], fields["up"])
        except ConditionError:
            directions = "-vd {:g} {:g} {:g} -vu {:g} {:g} {:g}"
            text = directions.format(*fields["aim"], *fields["up"])
            raise _wrong_view(text, name) from None
    fields["projection"] = VIEWS[kind]
    if VIEWS[kind] == pictures.PARALLEL:
        return fields
    if (kind, across, upright, shift, lift) == ("a", 360, 360, 0, 0):
        return {**fields, "projection": symbols.ANGULAR}
    try:
        angles = math.radians(across), math.radians(upright)
        return {**fields, "view": view_of_angles(VIEWS[kind], *angles, shift, lift)}
    except ConditionError:
        raise _wrong_view(text, name) from None


def _wrong_view(text: str, name: str) -> ConditionError:
    return ConditionError(f"{name} has an impossible view: 'VIEW= {quote(text)}'", "rpict(1), -v")


def _wrong_line(line: str, name: str) -> ConditionError:
    key = line.partition("=")[0]
    what = "positive numbers" if key in CUMULATIVE else "numbers"
    few = f"{VARIABLES[key]} {what}" if VARIABLES[key] > 1 else f"a {what[:-1]}"
    return ConditionError(f"{name}: its header has '{quote(line)}'", f"{key}= and {few}")


def _resolution(data: bytes, start: int, name: str) -> tuple[tuple[str, str], int, int, int]:
    """Return order, count and length of the scanlines, and their first byte."""
    end = data.find(b"\n", start, start + 100)
    line = data[start : max(start, end)].decode("latin-1")
    match = RESOLUTION.fullmatch(line)
    if not match or match[2] == match[5]:
        problem = f"{name} has no size at byte {start}: '{quote(line)}'"
        raise ConditionError(problem, "-Y HEIGHT +X WIDTH, or another order of the axes")
    order = (match[1] + match[2], match[4] + match[5])
    count, length = int(match[3]), int(match[6])
    size = (length, count) if match[2] == "Y" else (count, length)
    pictures.check_size(*size, name)
    # a pixel, and the bytes of its count of repetitions
    least = count * 4 * (1 + ((length - 1).bit_length() + 7) // 8)
    if len(data) - end - 1 < least:
        problem = f"{name} is cut off: {count} scanlines of {length} pixels need {least} bytes or "
        raise ConditionError(f"{problem}more, but it has {len(data) - end - 1}", MENDED)
    pictures.check_size(*size, name, len(data))  # repeated pixels take almost no bytes
    return order, count, length, end + 1


def _decoded(scanlines: Iterator[tuple[Any, int]], header: _Header) -> tuple[Any, int]:
    """Return pixels by scanline and place, and the byte at which they end.

    Pixels that are too large without their exposure become infinite.
    """
    pixels = np.empty((header.scanlines, header.length, 3), np.float32)
    done, end = 0, header.start
    with np.errstate(all="ignore"):
        scales = (np.ldexp(1.0, np.arange(256) - BIAS) / header.exposure).astype(np.float32)
        scales[0] = 0
        for parts, at in scanlines:
            rows = pixels[done : done + len(parts)]
            scale = scales.take(parts[:, 3])  # faster than [ ]
            for channel in range(3):
                np.multiply(parts[:, channel], scale, out=rows[:, :, channel])
            if header.correction != (1.0, 1.0, 1.0):
                rows /= np.array(header.correction, np.float32)
            done, end = done + len(parts), at
    return pixels, end


def _upright(pixels: Any, order: tuple[str, str]) -> Any:
    """Return a view of the pixels, by rows from the top and columns from the left."""
    if order[0][1] == "X":
        pixels = pixels.transpose(1, 0, 2)
    if "+Y" in order:
        pixels = pixels[::-1]
    return pixels[:, ::-1] if "-X" in order else pixels


def _scanlines(data: bytes, header: _Header, name: str) -> Iterator[tuple[Any, int]]:
    """Read scanlines, some at a time, each in its own encoding.

    Yield bytes by scanline, channel (the exponent last) and place, and the byte at which they end.
    """
    length, done, at = header.length, 0, header.start
    most = max(1, BLOCK // length)
    likely = 1  # scanlines that may follow each other without the new encoding
    while done < header.scanlines:
        count = min(most, header.scanlines - done)
        if _is_new(data, at):
            parts, at = _new(data, at, count, length, done, name)
        else:
            parts, at = _old(data, at, min(likely, count), length, done, name)
            likely = 2 * likely if len(parts) == likely else 1
        done += len(parts)
        yield parts, at


def _is_new(data: bytes, at: int) -> bool:
    return data[at : at + 2] == bytes([MARK, MARK]) and data[at + 2 : at + 3] < b"\x80"


def _new(data: bytes, at: int, most: int, length: int, done: int, name: str) -> tuple[Any, int]:
    """Read consecutive scanlines in the new run-length encoding; return them and their end."""
    start = at
    marks: list[int] = []
    codes: list[int] = []
    add = codes.append
    try:
        while len(marks) < most and _is_new(data, at):
            if (length_read := data[at + 2] * 256 + data[at + 3]) != length:
                what = f"has {length_read} pixels instead of {length}"
                raise _Damaged(what, done + len(marks), at, name)
            marks.append(at)
            at += 4
            for _ in range(4):
                remaining = length
                while remaining > 0:
                    add(at)
                    code = data[at]
                    if code > LITERAL:
                        remaining -= code - LITERAL
                        at += 2
                    elif code:
                        remaining -= code
                        at += code + 1
                    else:
                        raise _Damaged("has a run of nothing", done + len(marks) - 1, at, name)
                if remaining:
                    what = "has a run that is longer than the rest"
                    raise _Damaged(what, done + len(marks) - 1, codes[-1], name)
    except IndexError:
        at = len(data) + 1
    if at > len(data):
        raise _Damaged(CUT_OFF, done + max(0, len(marks) - 1), len(data), name)
    # Number of times that each byte of the file occurs in the scanlines: 0 for codes and marks,
    # the length of the run for a byte that it repeats.
    bytes_here = np.frombuffer(data, np.uint8, at - start, start)
    times = np.ones(len(bytes_here), np.intp)
    places = np.fromiter(codes, np.intp, len(codes)) - start
    read = bytes_here.take(places)
    runs = read > LITERAL
    times[places[runs] + 1] = read[runs] - LITERAL
    times[places] = 0
    times[(np.array(marks) - start)[:, None] + np.arange(4)] = 0
    return np.repeat(bytes_here, times).reshape(len(marks), 4, length), at


def _old(data: bytes, at: int, most: int, length: int, done: int, name: str) -> tuple[Any, int]:
    """Read scanlines in the old run-length encoding, or in none; return them and their end.

    R = G = B = 1 repeats the previous pixel; the exponent is the count.  Consecutive repetitions
    have the higher bytes of the count.
    """
    # a scanline has at most as many entries as pixels: 256 repetitions take two entries, and so on
    count = min(most * length, (len(data) - at) // 4)
    if not count:
        raise _Damaged(CUT_OFF, done, at, name)
    pixels = np.frombuffer(data, "<u4", count, at)
    repeats = (pixels & 0xFFFFFF) == REPEAT
    places = np.arange(count)
    last = np.maximum.accumulate(np.where(repeats, 0, places))  # the pixel that is repeated
    digits = 8 * np.minimum(places - last - 1, 4)
    times = np.where(repeats, np.minimum((pixels >> 24).astype(int) << digits, length + 1), 1)
    filled = np.cumsum(times)
    ends = length * np.arange(1, most + 1)
    stops = np.searchsorted(filled, ends) + 1  # where the places of each scanline end
    starts = np.concatenate([[0], stops[:-1]]).clip(max=count - 1)
    is_whole = filled[stops.clip(max=count) - 1] == ends
    is_whole &= ~repeats[starts] & ((pixels[starts] & 0x80FFFF) != MARK * 0x0101)
    lines = most if is_whole.all() else int(is_whole.argmin())
    if lines:
        stop = stops[lines - 1]
        decoded = np.repeat(pixels[last[:stop]], times[:stop]).view(np.uint8)
        return decoded.reshape(lines, length, 4).transpose(0, 2, 1), at + 4 * int(stop)
    if repeats[0]:
        raise _Damaged("begins with a repetition", done, at, name)
    if stops[0] <= count:
        what = "has a repetition that is longer than the rest"
        raise _Damaged(what, done, at + 4 * int(stops[0] - 1), name)
    what = CUT_OFF if count < most * length else "has repetitions of nothing"
    raise _Damaged(what, done, at + 4 * count, name)


def _rgbe(pixels: Any) -> Any:
    largest = pixels.max(2)
    # from 255.5 on, a mantissa is rounded to 256, which is 128 with the next exponent
    exponents = np.frexp(largest * (256 / 255.5))[1]
    exponents[exponents <= -128] = -128  # black
    scaled = np.ldexp(pixels, 8 - exponents[..., None])
    encoded = np.empty((*largest.shape, 4), np.uint8)
    encoded[..., :3] = np.minimum(np.rint(scaled), 255) * (exponents > -128)[..., None]
    encoded[..., 3] = exponents + 128
    return encoded


def _encoded(values: Any) -> bytes:
    starts = np.flatnonzero(values[1:] != values[:-1]) + 1
    starts = np.concatenate([[0], starts, [len(values)]])
    runs = np.flatnonzero(np.diff(starts) >= LEAST_RUN)
    data, at = values.tobytes(), 0
    parts: list[bytes] = []
    for start, end in zip(starts[runs].tolist(), starts[runs + 1].tolist(), strict=True):
        parts += _literals(data[at:start])
        for remaining in range(end - start, 0, -LONGEST_RUN):
            parts.append(bytes([LITERAL + min(LONGEST_RUN, remaining), data[start]]))
        at = end
    return b"".join([*parts, *_literals(data[at:])])


def _literals(data: bytes) -> Iterator[bytes]:
    for start in range(0, len(data), LITERAL):
        part = data[start : start + LITERAL]
        yield bytes([len(part)]) + part
