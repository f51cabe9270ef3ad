"""Radiance pictures, written as the picture section of Radiance's "File Formats" describes them."""

import numpy as np

TOP = "-Y {height} +X {width}"


def head(*lines, size="-Y 1 +X 1", form="32-bit_rle_rgbe"):
    """Return the header, with additional lines before the format."""
    return "\n".join(["#?RADIANCE", *lines, f"FORMAT={form}", "", size, ""]).encode()


def flat(line):
    """Return a scanline of rows of R, G, B and exponent, without encoding."""
    return bytes(int(byte) for pixel in line for byte in pixel)


def old(line):
    """A scanline in the old run-length encoding.

    "Repeated pixel values are indicated by an illegal (i.e., unnormalized) pixel that has 1's for
    all three mantissas, and an exponent that corresponds to the number of times the previous pixel
    is repeated.  Consecutive repeat indicators contain higher-order bytes of the count."
    """
    out, place = b"", 0
    line = [tuple(map(int, pixel)) for pixel in line]
    while place < len(line):
        count = 1
        while place + count < len(line) and line[place + count] == line[place]:
            count += 1
        out += bytes(line[place])
        again = count - 1
        while again:
            out += bytes([1, 1, 1, again % 256])
            again //= 256
        place += count
    return out


def new(line, least=3):
    """A scanline in the new run-length encoding, with runs from `least` equal bytes on.

    "The record begins with an unnormalized pixel having two bytes equal to 2, followed by the upper
    byte and the lower byte of the scanline length."  Then red, green, blue and exponents apart: a
    run is "a byte with its high-order bit set, corresponding to a count with excess 128", a non-run
    a byte that is less; 128 itself is a non-run in Radiance's sources.
    """
    out = bytes([2, 2, len(line) // 256, len(line) % 256])
    for channel in range(4):
        values = [int(pixel[channel]) for pixel in line]
        waiting, place = [], 0
        while place < len(values):
            count = 1
            while count < 127 and values[place : place + count + 1] == [values[place]] * (
                count + 1
            ):
                count += 1
            if count >= least:
                out += bytes([len(waiting), *waiting]) if waiting else b""
                out += bytes([128 + count, values[place]])
                waiting = []
            else:
                for value in values[place : place + count]:
                    waiting.append(value)
                    if len(waiting) == 128:
                        out += bytes([128, *waiting])
                        waiting = []
            place += count
        out += bytes([len(waiting), *waiting]) if waiting else b""
    return out


ENCODINGS = {"flat": flat, "old": old, "new": new}


def noise(height, width, seed=1, steps=40):
    """Rows of R, G, B and exponent: the largest of the three is at least 128, many repeat."""
    random = np.random.default_rng(seed)
    bytes_ = random.integers(0, 256, (height, width, 4))
    largest = random.integers(0, 3, (height, width, 1))
    brightest = random.integers(128, 256, (height, width, 1))
    np.put_along_axis(bytes_, largest, brightest, 2)
    bytes_[..., 3] = random.integers(110, 150, (height, width))
    bytes_[random.random((height, width)) < 0.1] = 0
    again = random.integers(0, steps, (height, width)) % steps > 2
    for column in range(1, width):  # most pixels are as the one before
        bytes_[:, column][again[:, column]] = bytes_[:, column - 1][again[:, column]]
    return bytes_


def picture(rows, encoding=flat, *lines, form="32-bit_rle_rgbe"):
    """A file in the usual orientation."""
    size = TOP.format(height=len(rows), width=len(rows[0]))
    return head(*lines, size=size, form=form) + b"".join(map(encoding, rows))


def values(rows):
    """Return R, G, B: mantissa * 2^(exponent - 136), and 0 for an exponent of 0."""
    rows = np.asarray(rows)
    powers = np.array([0.0, *(2.0 ** (exponent - 136) for exponent in range(1, 256))])
    return rows[..., :3] * powers[rows[..., 3:]]
