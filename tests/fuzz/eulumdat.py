"""EULUMDAT files: valid files have the flux of a plain sum; damaged files are refused or read.

The sweep draws a symmetry, equal or unequal planes and angles, factors and lamp sets.  Then it
changes whole lines: the file is refused with a line number, or has the figures of its numbers.
"""

import math
import random
import re

from distributions.ldt import plain_figures, written

from radcalc.distributions import eulumdat
from radcalc.errors import ConditionError

SHORT, LONG = 150, 20_000
TEXTS = ["", "0", "1", "2", "3", "4", "15", "-1", "1.5", "1,5", "1,000", "nan", "x", "1e400", "1 2"]


def drawn() -> list[str]:
    """Make the lines of a valid file."""
    symmetry = random.randrange(5)
    quarter = sorted({0.0, 90.0, *(round(random.uniform(1, 89), 1) for _ in range(3))})
    planes = [*quarter, *(180 - c for c in quarter[-2::-1])]
    planes += [180 + c for c in planes[1:-1]]  # the same in each quadrant
    steps = (0, 0)
    if random.random() < 0.5:
        step = random.choice([7.5, 15, 22.5, 45, 90])
        planes, steps = [k * step for k in range(round(360 / step))], (step, 0)
    last = random.choice([90.0, 120.0, 180.0])
    inner = {round(random.uniform(0.1, last - 0.1), 2) for _ in range(random.randrange(8))}
    sets = [
        (random.choice([1, 2, -1]), "LED", round(random.uniform(100, 9000), 1), "", "", 10 + k)
        for k in range(random.choice([1, 1, 3]))
    ]
    power = random.uniform(0, 4)
    return written(
        lambda c, g: round(random.random() ** power * 1000, 3),
        symmetry,
        planes,
        sorted({0.0, last} | inner),
        steps=steps,
        sets=sets,
        factor=round(random.uniform(0.5, 2), 2),
    )


def damaged(lines: list[str]) -> list[str]:
    """Drop, double, exchange or replace lines."""
    lines = list(lines)
    for _ in range(random.choice([1, 1, 2, 4])):
        place = random.randrange(len(lines))
        other = random.choice([place + 1, random.randrange(len(lines))]) % len(lines)
        match random.randrange(5):
            case 0:
                del lines[place]
            case 1:
                lines.insert(place, lines[other])
            case 2:
                lines[place], lines[other] = lines[other], lines[place]
            case 3:
                lines[place] = random.choice(TEXTS)
            case 4:
                del lines[max(place, len(lines) // 2) :]
    return lines


def sweep(count: int, seed: int) -> str:
    """Read a valid and a damaged file in each case."""
    random.seed(seed)
    refused = 0
    for _ in range(count):
        lines = drawn()
        assert not check(lines), lines
        lines = damaged(lines)
        if refusal := check(lines):
            refused += 1
            line = re.match(r"lamp\.ldt, line (\d+): ", refusal)
            assert line, (refusal, lines)
            assert 1 <= int(line[1]) <= max(len(lines), 1), (refusal, lines)
    return f"{count} files and as many damaged ones; {refused} were refused"


def check(lines: list[str]) -> str:
    """Compare a file with plain sums of its numbers; return the error if it is refused."""
    try:
        found = eulumdat.read(lines, "lamp.ldt")
    except ConditionError as error:
        return error.message
    value, first, lumens = plain_figures(lines)
    flux, rounding = (
        found.distribution.flux().value,
        1e-13 * lumens,
    )  # narrow cells
    assert math.isclose(flux, value, rel_tol=1e-9, abs_tol=rounding), lines
    own = found.distribution.intensity(*first[:2])
    assert math.isclose(own, first[2], rel_tol=1e-9), lines
    assert found.declared.get("lamp-flux", lumens) == lumens, lines
    return ""


if __name__ == "__main__":
    from fuzz.command import main

    main(sweep, LONG)
