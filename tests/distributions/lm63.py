"""IES LM-63 files for tests: a writer, and plain sums for the flux of a file."""

import math
import re

DEGREE = math.pi / 180
TYPE = {"C": 1, "B": 2, "A": 3}


def written(
    intensity,
    vertical,
    horizontal,
    system="C",
    label=("IESNA:LM-63-2002", "[TEST] 1"),
    tilt=("TILT=NONE",),
    lamps="1 -1",
    factors="1",
    ballast="1 1",
    watts="20",
):
    """Return the lines of a file; the intensity is a function of V and H [deg] or a number."""
    function = intensity if callable(intensity) else lambda v, h: intensity
    counts = f"{len(vertical)} {len(horizontal)} {TYPE[system]}"
    rows = [" ".join(f"{function(v, h):.17g}" for v in vertical) for h in horizontal]
    angles = [" ".join(f"{angle:g}" for angle in angles) for angles in (vertical, horizontal)]
    header = [f"{lamps} {factors} {counts} 2 0 0 0", f"{ballast} {watts}"]
    return [*label, *tilt, *header, *angles, *rows]


def steps(first, last, step):
    return [first + k * step for k in range(round((last - first) / step) + 1)]


def plain_flux(lines):
    """Return the flux of a valid file of any type, by sums over its segments.

    Linear in the angle from the pole's plane, I cos H (or I sin V of type C) integrates to closed
    forms; over the other angle the trapezoidal rule is exact.
    """
    text = "\n".join(lines)
    place = re.search(r"TILT=NONE", text).end()
    numbers = [float(word) for word in re.findall(r"[^\s,]+", text[place:])]
    nv, nh, system = (int(numbers[k]) for k in (3, 4, 5))
    v, h = numbers[13 : 13 + nv], numbers[13 + nv : 13 + nv + nh]
    table = [numbers[13 + nv + nh + k * nv :][:nv] for k in range(nh)]
    values = [[max(value, 0.0) for value in row] for row in table]
    if system == 2:
        across, along, values = v, h, [list(column) for column in zip(*values, strict=True)]
    else:
        across, along = h, v
    # angles from the equator of the pole, of which the solid angle has the cosine
    x = [(a - 90 if system == 1 else a) * DEGREE for a in along]
    rows = []
    for row in values:
        total = 0.0
        for a, b, p, q in zip(x, x[1:], row, row[1:], strict=False):
            slope = (q - p) / (b - a)
            total += q * math.sin(b) - p * math.sin(a) + slope * (math.cos(b) - math.cos(a))
        rows.append(total)
    if system == 1 and nh == 1:
        return numbers[2] * numbers[10] * rows[0] * 2 * math.pi
    if system == 1 and (across[0], across[-1]) not in ((0, 90), (0, 180), (90, 270)):
        across, rows = [*across, across[0] + 360], [*rows, rows[0]]
    span = across[-1] - across[0]
    times = 360 / span if system == 1 else 2 if h[0] == 0 else 1
    sums = sum(
        (b - a) * (p + q) / 2
        for a, b, p, q in zip(across, across[1:], rows, rows[1:], strict=False)
    )
    return numbers[2] * numbers[10] * times * sums * DEGREE
