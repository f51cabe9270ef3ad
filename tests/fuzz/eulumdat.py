"""EULUMDAT files: what is read has the flux of a plain sum, and no damage brings more.

Drawn are a symmetry, even or uneven planes and angles, factors and lamp sets, and then changes of
whole lines, after which a file is refused with a line or has the figures of those that are left.
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
    """The lines of a file in order."""
    symmetry = random.randrange(5)
    quarter = sorted({0.0, 90.0, *(round(random.uniform(1, 89), 1) for _ in range(3))})
    planes = [*quarter, *(180 - c for c in quarter[-2::-1])]
    planes += [180 + c for c in planes[1:-1]]  # the same in each quarter
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
    """The same with lines dropped, doubled, exchanged or replaced."""
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
    """Read a file in order and a damaged one in each case."""
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
    return f"{count} files, and as many damaged ones, of which {refused} were refused"


def check(lines: list[str]) -> str:
    """Hold a file that is read against plain sums of its numbers; say how it is refused."""
    try:
        found = eulumdat.read(lines, "lamp.ldt")
    except ConditionError as error:
        return error.message
    value, first, lumens = plain_figures(lines)
    flux, rounding = found.distribution.flux().value, 1e-13 * lumens  # that of narrow cells there
    assert math.isclose(flux, value, rel_tol=1e-9, abs_tol=rounding), lines
    own = found.distribution.intensity(*first[:2])
    assert math.isclose(own, first[2], rel_tol=1e-9), lines
    assert found.declared.get("lamp-flux", lumens) == lumens, lines
    return ""


if __name__ == "__main__":
    from fuzz.command import main

    main(sweep, LONG)
