"""Compare photometric files and their light with other tools; see README.md."""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
from measure import RADCALC, command, report

from radcalc.distributions.distribution import Grid, Pose

NUMPY = "import click, numpy"
# The numbers of the same file, read into an array and nothing else.
READING = "import click, numpy; numpy.fromstring(open({!r}).read().split('\\n', 2)[2], sep=' ')"
LAMPS, SIDE = 100, 317  # rows of a scene, and points along each side of its grid: 1e5 points
MEGABYTES = 60


def write_lamp(path: Path, planes: int, angles: int) -> None:
    """Write an IES file with intensities at steps of about half a degree."""
    polar, azimuth = np.linspace(0, 180, angles), np.linspace(0, 360, planes)
    values = np.random.default_rng(1).uniform(10, 1000, (planes, angles))
    values[:, 0], values[-1] = 500, values[0]
    counts = f"1 1000 1 {angles} {planes} 1 2 0 0 0\n1 1 50"
    rows = [" ".join(map(str, row.round(4).tolist())) for row in (polar, azimuth, *values)]
    path.write_text("\n".join(["IESNA:LM-63-2002", "TILT=NONE", counts, *rows]) + "\n")


def many_points() -> bool:
    """Compare a lamp's illuminances on a grid with the interpolation in its table alone."""
    polar, azimuth = np.radians(np.arange(0, 91)), np.radians(np.arange(0, 361, 5))
    values = np.random.default_rng(1).random((len(azimuth), len(polar)))
    side = np.linspace(-5, 5, 1000)
    x, y = (part.ravel() for part in np.meshgrid(side, side))
    z = np.full(x.shape, -3.0)
    lamp, pose = Grid(polar, azimuth, values), Pose()
    theta, phi, _ = pose.angles((x, y, z))

    def ours() -> np.ndarray:
        angles = pose.angles((x, y, z))
        return lamp.intensity(*angles[:2]) * -z / angles[2] ** 3

    def theirs() -> np.ndarray:
        j, i = theta / polar[1], phi / azimuth[1]
        b, a = j.astype(int), i.astype(int)
        j, i = j - b, i - a
        before = values[a, b] * (1 - i) + values[a + 1, b] * i
        return before * (1 - j) + (values[a, b + 1] * (1 - i) + values[a + 1, b + 1] * i) * j

    return report("1e6 points under a table / its bilinear look-up", ours, theirs, 3, 11)


def memory(folder: Path) -> bool:
    """Compute the light of many lamps on a grid of points, and print the peak memory."""
    write_lamp(folder / "lamp.ies", 73, 91)
    rows = [f"{k % 10},{k // 10},3,lamp.ies" for k in range(LAMPS)]
    (folder / "scene.csv").write_text("\n".join(["x,y,z,distribution", *rows]) + "\n")
    grid = f"0:9:{SIDE},0:9:{SIDE},0"
    words = [RADCALC, "scene", "scene.csv", "--grid", grid, "-g", "irradiance:lx"]
    with open(os.devnull, "wb") as null:
        child = subprocess.Popen(words, stdout=null, cwd=folder)
        _, status, used = os.wait4(child.pid, 0)
    most = used.ru_maxrss / (1 if sys.platform == "darwin" else 1024)
    took = used.ru_utime + used.ru_stime
    size = f"{LAMPS} lamps, {SIDE * SIDE} points"
    print(f"{size}: {most:.1f} MB resident at most (aim {MEGABYTES}), {took:.1f} s")
    return status == 0 and most <= MEGABYTES


def main() -> int:
    """Print all ratios; exit with status 1 if an aim is missed."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        met = memory(folder)  # first, because a child process inherits the memory of its parent
        path = folder / "large.ies"
        write_lamp(path, 361, 361)
        print(f"{path.stat().st_size / 1e6:.2f} MB")
        ours = command(RADCALC, "point-source", "--distribution", str(path))
        theirs = command(sys.executable, "-c", NUMPY)
        met &= report(f"an IES file of 1 MB / {NUMPY}", ours, theirs, 1.6, 20)
        reading = command(sys.executable, "-c", READING.format(str(path)))
        met &= report("the same / reading its numbers with NumPy", ours, reading, 1.3, 20)
    met &= many_points()
    return 0 if met else 1


if __name__ == "__main__":
    sys.exit(main())
