"""Compare irradiances of radiance maps with plain sums, and measure large maps; see README.md."""

import math
import sys
import tempfile
import time
import tracemalloc
from collections.abc import Callable
from pathlib import Path

import numpy as np
from measure import report

from radcalc.distributions.maps import RadianceMap
from radcalc.distributions.maps.pictures import REC_709, Picture, read_picture, write_picture
from radcalc.distributions.maps.rendered import irradiance_map

WIDTH, HEIGHT = 4096, 2048
NORMAL = (1.0, 2.0, 3.0)


def picture() -> Picture:
    """Make a sky with clouds of all sizes and a sun."""
    v, u = (np.linspace(0, size, count) for size, count in ((3, HEIGHT), (6, WIDTH)))
    clouds = sum(np.sin(2**k * u + k) * np.cos(2**k * v[:, None] - k) / 1.5**k for k in range(10))
    pixels = np.exp(clouds)[..., None] * [1.0, 1.1, 1.4]
    pixels[400:412, 1000:1012] = 5e4
    return Picture(pixels.astype(np.float32), ("R", "G", "B"), REC_709, "PFM")


def one(path: str) -> bool:
    """Compare one irradiance of a file with reading it and one weighted sum."""
    weights = np.array(REC_709, np.float32)
    sines = np.sin((np.arange(HEIGHT) + 0.5) * math.pi / HEIGHT)

    def ours() -> float:
        read = read_picture(path)
        return RadianceMap(read.pixels, "latlong", weights=REC_709).irradiance(NORMAL).value

    def theirs() -> float:
        return float((read_picture(path).pixels @ weights).sum(1) @ sines)

    kind = Path(path).suffix
    name = f"{WIDTH}x{HEIGHT} {kind} to an irradiance / reading and a weighted sum"
    return report(name, ours, theirs, 1.5, 9)


def cost(name: str, action: Callable[[], object]) -> None:
    """Print time and peak memory of a call."""
    start = time.perf_counter()
    action()
    took = time.perf_counter() - start
    tracemalloc.start()
    action()
    _, most = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    print(f"{name}: {took:.1f} s, {most / 2**20:.0f} MB peak, without the pixels")


def main() -> int:
    """Print all figures; exit with status 1 if an aim is missed."""
    pixels = picture()
    around = RadianceMap(pixels.pixels, "latlong", weights=REC_709)
    cost("irradiance map 64x32", lambda: irradiance_map(around, 64, 32))
    with tempfile.TemporaryDirectory() as folder:
        met = True
        for extension in ("hdr", "exr", "pfm"):
            path = str(Path(folder) / f"map.{extension}")
            write_picture(path, pixels)
            met &= one(path)
    return 0 if met else 1


if __name__ == "__main__":
    sys.exit(main())
