"""Compare shapes and integrals with other commands; see README.md."""

import sys

import numpy as np
from measure import RADCALC, command, report

from radcalc.geometry.polygons import triangle

NUMPY = "import click, numpy"
SCALARS = [
    ("disc off its axis", "disc --radius 1m --height 1m --offset 2m"),
    ("rectangle", "rectangle --width 2m --length 1m --height 1m --offset 1m"),
    ("polygon", "polygon 1,0,0 0,1,0 0,0,1 --normal 0,1,-1"),
]


def bare(a: np.ndarray, b: np.ndarray, c: np.ndarray) -> list[np.ndarray]:
    """Compute the least that the solid angle of a triangle needs: its triple and dot products."""
    normal = np.cross(b, c)
    return [np.einsum("ij,ij->i", *pair) for pair in ((a, normal), (a, b), (a, c), (b, c))]


def main() -> int:
    """Print all ratios; exit with status 1 if an aim is missed."""
    met = True
    for name, words in SCALARS:
        ours = command(RADCALC, "solid-angle", *words.split())
        theirs = command(sys.executable, "-c", NUMPY)
        met &= report(f"{name} / {NUMPY}", ours, theirs, 1.4, 40)
    ours = command(RADCALC, "integrate", "cos(theta)", "--hemisphere")
    met &= report(f"integrate / {NUMPY}", ours, command(sys.executable, "-c", NUMPY), 1.4, 20)
    corners = np.random.default_rng(1).normal(size=(3, 1_000_000, 3))
    met &= report(
        "1e6 triangles / their cross and dot products",
        lambda: triangle(*corners),
        lambda: bare(*corners),
        2,
        11,
    )
    return 0 if met else 1


if __name__ == "__main__":
    sys.exit(main())
