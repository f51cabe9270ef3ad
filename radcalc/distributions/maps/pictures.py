"""Picture files: what they hold, told apart by their first bytes and written by their extension.

Each format is a module of its own, loaded when it is needed: `rgbe`, `pfm` and `exr` have
`read(data, name)`, of the bytes of a file, where `name` is what messages call it, and
`write(path, picture)`, which writes over an empty file and returns what is to be told (a tuple of
str).  What a file or a picture has wrong is a ConditionError; an OSError is left to this module.
"""

from collections.abc import Sequence
from importlib import import_module
from typing import Any, NamedTuple

import numpy as np

from radcalc.distributions import contents
from radcalc.errors import SHOWN, ConditionError, quote, quote_path

# Of the sum of all values: those below 0 that are less of it are what lossy encoding left.
NOISE = 1e-6
KNOWN = "a Radiance (.hdr), OpenEXR (.exr) or PFM (.pfm) picture"
LEAST = 1e-6  # y of a white, and twice the area of a triangle of primaries
FARTHEST = 10.0  # coordinate of a primary
RGB, XYZ, Y = ("R", "G", "B"), ("X", "Y", "Z"), ("Y",)  # the channels of a picture
BY_REC_709 = "luminance is by the primaries of Rec. 709, for the file names none"
REC_709 = (0.2126, 0.7152, 0.0722)  # of the luminance of linear R, G, B, as the standard has them
# A map of 16384x8192, the largest that is common, has 1.5 GiB as floats; twice that still fits into
# the memory of a common computer.
PIXELS = 1 << 28
MOST_BYTES = 16 * PIXELS  # of a file: four floats a pixel
BRIGHTEST, FAINTEST = 3e38, 1e-36  # that 32 bits, and RGBE, hold with all their digits
WRITERS = {".hdr": "rgbe", ".pic": "rgbe", ".exr": "exr", ".pfm": "pfm"}  # modules, by extension
READERS = {b"#?": "rgbe", b"v/1\x01": "exr", b"PF": "pfm", b"Pf": "pfm"}  # by the first bytes
OLD_RADIANCE = b"FORMAT=32-bit_rle_"  # in the header of a Radiance picture that begins otherwise
POINTER = b"version https://git-lfs"  # of Git LFS
OTHERS = {
    b"\xff\xd8\xff": "JPEG",
    b"\x89PNG": "PNG",
    b"GIF8": "GIF",
    b"BM": "BMP",
    b"II*\0": "TIFF",
    b"MM\0*": "TIFF",
    b"\x1f\x8b": "gzip",
    b"PK\x03\x04": "ZIP",
}


class Picture(NamedTuple):
    """A picture as a file has it.

    Attributes
    ----------
    pixels : array of float32, (height, width, channels)
        In the file's unit (an exposure is undone); row 0 is the top.
    channels : tuple of str
        ("R", "G", "B"), ("X", "Y", "Z") or ("Y",); or one of another name that was asked for.
    weights : tuple of float
        What gives the luminance of the channels: by the file's primaries, else those of Rec. 709.
    format : str
        "Radiance RGBE", "OpenEXR" or "PFM".
    unit : str
        In which the file says its pixels are; empty where it does not.
    projection : str
        That the file declares; empty where it does not.
    frame : tuple of int, or None
        Left, top, full width and full height, where the pixels are a part of a larger picture.
    assumptions, notes : tuple of str
        What was assumed in reading it, and what is odd.

    Examples
    --------
    >>> grey = Picture(np.full((1, 2, 1), 0.18, np.float32), ("Y",), (1.0,), "PFM")
    >>> grey.pixels.shape
    (1, 2, 1)
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


def read_picture(path: str, channel: str = "") -> Picture:
    """Read a picture: Radiance, OpenEXR or PFM, which its first bytes tell, not its name.

    Parameters
    ----------
    path : str
        A regular file of 4 GiB at most.
    channel : str, optional
        The channel that an OpenEXR picture is read for, which may have any; of the others all
        channels are read.

    Returns
    -------
    Picture
        At most 2^28 pixels.  Values below 0 of which the sum is less than a millionth of all are
        what lossy encoding left, and become 0; others stay.

    Raises
    ------
    ConditionError
        If it cannot be read, is none of the three, or has more pixels; else what the reader of
        its format refuses.

    Examples
    --------
    >>> read_picture("-")
    Traceback (most recent call last):
    radcalc.errors.ConditionError: a picture is not read from standard input
    try: its file
    """
    if path == "-":
        raise ConditionError("a picture is not read from standard input", "its file")
    name = quote_path(path)
    with contents.opened(path, MOST_BYTES, KNOWN) as file:
        head = file.read(1000)
        reader = next((READERS[magic] for magic in READERS if head.startswith(magic)), "")
        if not reader and OLD_RADIANCE in head:
            reader = "rgbe"
        file.seek(0)
        data = contents.whole(file, MOST_BYTES, path) if reader else b""
    if not reader:
        raise _is_no_picture(head, name)
    # only the one that is needed is loaded
    module = import_module(f"radcalc.distributions.maps.{reader}")
    alone = (channel,) if channel and reader == "exr" else ()
    try:
        return _without_noise(module.read(data, name, *alone))
    except MemoryError:
        raise ConditionError(f"{name} does not fit into memory", "a smaller picture") from None


def write_picture(path: str, picture: Picture) -> tuple[str, ...]:
    """Write a picture in the format of the extension: whole, or not at all.

    Returns what the format loses of it, which is to be told.

    What was there is replaced when all is written; so a picture can take the place of the one
    that it was made of.

    Raises
    ------
    ConditionError
        If the format cannot hold the picture, or the extension is of none.
    OutputError
        If it cannot be written.
    """
    extension = check_target(path)
    if picture.frame and extension != ".exr":
        raise ConditionError("a part of a picture is kept in OpenEXR alone", "an .exr file")
    module = import_module(f"radcalc.distributions.maps.{WRITERS[extension]}")
    with contents.written(path) as temporary:
        notes: tuple[str, ...] = module.write(temporary, picture)
    return notes


def check_target(path: str) -> str:
    """Refuse a place to write to, before the work whose result would be lost; the extension.

    Raises what `write_picture` raises, as far as it can be known before.

    Examples
    --------
    >>> check_target("map.png")
    Traceback (most recent call last):
    radcalc.errors.ConditionError: map.png: pictures are not written as .png
    try: .hdr (Radiance), .exr (OpenEXR) or .pfm
    """
    return contents.check_place(
        path, WRITERS, "pictures", ".hdr (Radiance), .exr (OpenEXR) or .pfm"
    )


def check_size(width: int, height: int, name: str) -> None:
    """Refuse a picture that has no pixels or too many, before room is made for them.

    Examples
    --------
    >>> check_size(65536, 65536, "sky.hdr")
    Traceback (most recent call last):
    radcalc.errors.ConditionError: sky.hdr has 65536 x 65536 pixels, more than 268435456
    try: a smaller picture
    """
    if width < 1 or height < 1:
        raise ConditionError(f"{name} has {width} x {height} pixels", "a picture that has some")
    if width * height > PIXELS:
        problem = f"{name} has {width} x {height} pixels, more than {PIXELS}"
        raise ConditionError(problem, "a smaller picture")


def as_floats(values: Any, unit: str) -> Any:
    """The values of a picture that is made, as it has them: in 32 bits.

    Parameters
    ----------
    values : ndarray of float
        0 or more.
    unit : str
        Theirs, for messages.

    Returns
    -------
    ndarray of float32

    Raises
    ------
    ConditionError
        If one is too large for that, or all are so small that nothing is left of them.

    Examples
    --------
    >>> as_floats(np.array([1e40]), "cd/m2")
    Traceback (most recent call last):
    radcalc.errors.ConditionError: a picture holds no values of more than 3e+38 cd/m2
    try: less extreme values
    """
    highest = values.max()
    if not highest < BRIGHTEST:
        problem = f"a picture holds no values of more than {BRIGHTEST:g} {unit}"
        raise ConditionError(problem, "less extreme values")
    if 0 < highest < FAINTEST:
        problem = f"a picture of values of {highest:g} {unit} at most would be all but black"
        raise ConditionError(problem, "less extreme values")
    return values.astype(np.float32)


def _without_noise(picture: Picture) -> Picture:
    """A picture whose values below 0 are 0, where they are too few and small to count."""
    pixels = picture.pixels
    with np.errstate(invalid="ignore"):  # NaN and infinite values, which are no noise
        if not pixels.min() < 0:
            return picture
        below = pixels[pixels < 0]
        share = -below.sum(dtype=float) / np.abs(pixels).sum(dtype=float)
    if not share < NOISE:
        return picture
    note = f"{below.size} values below 0, by {-below.min():.2g} at most, count as 0"
    return picture._replace(pixels=np.maximum(pixels, 0), notes=(*picture.notes, note))


def luminance_weights(chromaticities: Sequence[float], name: str) -> tuple[float, ...]:
    """What gives the luminance of R, G, B, by the chromaticities of a file.

    Parameters
    ----------
    chromaticities : sequence of eight floats
        x and y of red, green, blue and white, which is R = G = B.
    name : str
        What messages call the file.

    Returns
    -------
    tuple of float
        Of R, G and B; their sum is 1.

    Raises
    ------
    ConditionError
        If no light can have them: where y is not positive, or the three are on a line.

    Examples
    --------
    >>> of_709 = (0.64, 0.33, 0.3, 0.6, 0.15, 0.06, 0.3127, 0.329)
    >>> [round(weight, 4) for weight in luminance_weights(of_709, "sky.hdr")]
    [0.2126, 0.7152, 0.0722]
    """
    xy = np.array(chromaticities, float).reshape(4, 2)
    xyz = np.column_stack([xy, 1 - xy.sum(1)]) if np.abs(xy).max() < FARTHEST else np.zeros((4, 3))
    mixed, white = xyz[:3].T, xyz[3]
    # three on a line have a determinant of 0, up to rounding
    if white[1] < LEAST or abs(np.linalg.det(mixed)) < LEAST:
        numbers = " ".join(f"{value:g}" for value in chromaticities)
        problem = f"{name} has primaries of which no light can be mixed: {quote(numbers)}"
        raise ConditionError(problem, "x and y of red, green, blue and white")
    weights = np.linalg.solve(mixed, white / white[1]) * xyz[:3, 1]
    return tuple(map(float, weights))


def _is_no_picture(head: bytes, name: str) -> ConditionError:
    """What is wrong with a file that begins so, and what helps."""
    if not head:
        return ConditionError(f"{name} is empty", KNOWN)
    if head.startswith(POINTER):
        problem = f"{name} is a pointer of Git LFS, which stands for the picture"
        return ConditionError(problem, "git lfs pull, which fetches it")
    kind = next((OTHERS[magic] for magic in OTHERS if head.startswith(magic)), "")
    if kind in ("gzip", "ZIP"):
        return ConditionError(f"{name} is compressed ({kind})", "what is in it")
    if kind:
        return ConditionError(f"{name} is {kind}, and no picture of radiances", KNOWN)
    if head.removeprefix(b"\xef\xbb\xbf").lstrip().startswith(b"<"):
        return ConditionError(f"{name} is a web page (HTML) or XML", "the file it leads to")
    text = quote(head[:SHOWN].decode("latin-1"))
    return ConditionError(f"{name} is no picture that is read: it begins with '{text}'", KNOWN)
