"""EULUMDAT files for tests: a writer, and plain sums over a file's values."""

import math

ALL_AROUND = [15.0 * k for k in range(24)]
GAMMAS = [5.0 * k for k in range(37)]
STORED = {
    0: lambda planes: planes,
    1: lambda planes: planes[:1],
    2: lambda planes: [c for c in planes if c <= 180],
    3: lambda planes: [c for c in planes if c >= 270] + [c for c in planes if c <= 90],
    4: lambda planes: [c for c in planes if c <= 90],
}


def written(intensity, symmetry=0, planes=ALL_AROUND, gammas=GAMMAS, **other):
    """Return a file's lines; `intensity(C, gamma)` is in cd, its arguments in radians."""
    has = {
        "steps": (planes[1] - planes[0] if len(planes) > 1 else 0, gammas[1] - gammas[0]),
        "sets": [(1, "LED", 1000, "3000 K", "80", 12)],
        "down": 50, "ratio": 80, "factor": 1, "tilt": 0, "ratios": [0.5] * 10, "name": "A lamp",
    } | other  # fmt: skip
    scale = 1000 / has["sets"][0][2] / has["factor"]
    head = ["A company", 3, symmetry, len(planes), has["steps"][0], len(gammas), has["steps"][1]]
    head += ["report", has["name"], "number", "lamp.ldt", "2020", *[100] * 9]
    head += [has["down"], has["ratio"], has["factor"], has["tilt"], len(has["sets"])]
    table = [
        intensity(math.radians(c), math.radians(g)) * scale
        for c in STORED[symmetry](planes)
        for g in gammas
    ]
    lamps = [text for one in has["sets"] for text in one]
    lines = [*head, *lamps, *has["ratios"], *planes, *gammas, *table]
    return [str(line) for line in lines]


def plain_figures(lines):
    """Flux, the first direction and its intensity, and the lamps' flux, without radcalc.

    Each listed plane is folded to the one that is stored; planes are weighted by trapezia over
    azimuth; along gamma the integral of linear pieces is exact (2 pi times the sum over segments
    of [-I cos + s sin], s being the slope per radian).
    """
    while lines and not lines[-1].strip():
        lines = lines[:-1]
    value = [line.strip().replace(",", ".") for line in lines]
    symmetry, mc, ng, sets = (int(float(value[k])) for k in (2, 3, 5, 25))
    stored = {0: mc, 1: 1, 2: mc // 2 + 1, 3: mc // 2 + 1, 4: mc // 4 + 1}[symmetry]
    table = [max(float(text), 0.0) for text in value[-stored * ng :]]  # noise counts as 0
    gamma = [math.radians(float(text)) for text in value[-stored * ng - ng : -stored * ng]]
    end = len(value) - stored * ng - ng
    planes = [float(text) for text in value[end - mc : end]]
    assert end - mc in (26 + 6 * sets, 36 + 6 * sets)
    rows = [table[k * ng : (k + 1) * ng] for k in range(stored)]
    kept = STORED[symmetry](planes)
    fold = {
        0: lambda c: c,
        1: lambda c: kept[0],
        2: lambda c: min(c, 360 - c),
        3: lambda c: 180 - c if 90 < c < 270 else c,
        4: lambda c: min(c % 180, 180 - c % 180),
    }[symmetry]
    scale = float(value[23]) * float(value[28]) / 1000

    def nearest(c):
        return rows[min(range(stored), key=lambda k: abs((kept[k] - fold(c) + 180) % 360 - 180))]

    def along(row):
        total = 0.0
        for (a, i), (b, j) in zip(
            zip(gamma, row, strict=True), zip(gamma[1:], row[1:], strict=True), strict=False
        ):
            slope = (j - i) / (b - a)
            total += i * math.cos(a) - j * math.cos(b) + slope * (math.sin(b) - math.sin(a))
        return total

    sums = [along(nearest(c)) for c in planes]
    total = 0.0
    ends = [*planes[1:], planes[0] + 360]
    for k, (c, d) in enumerate(zip(planes, ends, strict=True)):
        total += math.radians(d - c) * (sums[k] + sums[(k + 1) % mc]) / 2
    first = gamma[0], math.radians(planes[0]), scale * nearest(planes[0])[0]
    return scale * total, first, float(value[28])
