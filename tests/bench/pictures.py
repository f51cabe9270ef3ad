"""Compare readers of pictures; see README.md."""

import sys
import tempfile
from pathlib import Path

import numpy as np
import OpenImageIO
from measure import report

from radcalc.distributions.maps.pictures import Picture, read_picture, write_picture

HEIGHT, WIDTH = 2048, 4096


def scene() -> np.ndarray:
    """Make a picture with a bright sun, a smooth noisy sky and uniform ground."""
    random = np.random.default_rng(1)
    y, x = np.mgrid[-1 : 1 : HEIGHT * 1j, -1 : 1 : WIDTH * 1j]
    sky = np.exp(2 - 3 * y**2) + 1e4 * np.exp(-2000 * ((x - 0.3) ** 2 + (y + 0.5) ** 2))
    pixels = sky[..., None] * [0.7, 0.9, 1.2] * random.lognormal(0, 0.1, (HEIGHT, WIDTH, 3))
    pixels[y > 0.5] = 0.1
    return pixels.astype(np.float32)


def theirs(path: str) -> np.ndarray:
    file = OpenImageIO.ImageInput.open(path)
    found = file.read_image("float")
    file.close()
    return found


def main() -> int:
    """Print all ratios; exit with status 1 if an aim is missed."""
    met = True
    with tempfile.TemporaryDirectory() as name:
        for extension, aim in (("hdr", 2.0), ("pfm", 1.5)):
            path = str(Path(name) / f"scene.{extension}")
            write_picture(path, Picture(scene(), ("R", "G", "B"), (0.2126, 0.7152, 0.0722), ""))
            size = f"{WIDTH}x{HEIGHT} .{extension} ({Path(path).stat().st_size / 1e6:.0f} MB)"

            def ours(path: str = path) -> object:
                return read_picture(path)

            def other(path: str = path) -> object:
                return theirs(path)

            met &= report(f"{size} / OpenImageIO", ours, other, aim, 11)
    return 0 if met else 1


if __name__ == "__main__":
    sys.exit(main())
