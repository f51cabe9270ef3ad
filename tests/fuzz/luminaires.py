"""IES LM-63 files: valid files have the flux of a plain sum; damaged files are refused or read.

The sweep draws a type, ranges and steps of angles, intensities, factors, and line breaks.  Then it
changes single characters: the file is refused with a line number, or has the flux of its numbers.
"""

import math
import random
import re

from distributions.lm63 import plain_flux, written

from radcalc.distributions import ies
from radcalc.errors import ConditionError

SHORT, LONG = 150, 50_000
VERTICAL = {"C": [(0, 90), (0, 180), (90, 180), (0, 75)], "A": [(-90, 90), (0, 90)]}
VERTICAL["B"] = [*VERTICAL["A"], (-180, 180)]
HORIZONTAL = {
    "C": [(0, 0), (0, 90), (0, 180), (90, 270), (0, 360)],
    "A": [(0, 90), (-90, 90), (0, 180), (-180, 180)],
    "B": [(0, 90), (-90, 90), (-40, 40)],
}
BETWEEN = [" ", "\t", " \t ", ",", ", ", " , "]
CHARACTERS = "0123456789 .,-+eE\n\t[]=TILTNONEnaninf_;\u0663"


def angles(first: float, last: float) -> list[float]:
    """Draw increasing angles between two limits, at most 40 degrees apart if they are azimuths."""
    if first == last:
        return [first]
    inner = {round(random.uniform(first, last), 1) for _ in range(random.choice([0, 3, 12]))}
    return sorted({first, last} | inner)


def drawn() -> list[str]:
    """Make the lines of a valid file."""
    system = random.choice("CCAB")
    vertical, horizontal = (
        angles(*random.choice(ranges[system])) for ranges in (VERTICAL, HORIZONTAL)
    )
    power = random.uniform(0, 4)
    lines = written(
        lambda v, h: random.random() ** power * 10**power,
        vertical,
        horizontal,
        system,
        factors=f"{random.uniform(0.1, 3):.3g}",
        ballast=f"{random.uniform(0.5, 1.2):.3g} 1",
    )
    start = lines.index("TILT=NONE") + 1
    words = " ".join(lines[start:]).split()
    if random.random() < 0.5:
        return lines
    between = random.choice(BETWEEN)  # mixed with commas, it would be a decimal comma
    text = "".join(word + random.choice([between, between, "\n", "\r\n\r\n"]) for word in words)
    return [*lines[:start], *text.rstrip(" ,").splitlines()]


def damaged(lines: list[str]) -> list[str]:
    """Drop, double, insert or replace characters."""
    text = list("\n".join(lines))
    for _ in range(random.choice([1, 1, 2, 5])):
        place = random.randrange(len(text) + 1)
        end = place + random.choice([0, 1, 1, 5, 100])
        text[place:end] = random.choice([[], [random.choice(CHARACTERS)], 2 * text[place:end]])
    return "".join(text).splitlines()


def read_or_refusal(lines: list[str]) -> float | str:
    """Return the flux of a file, or the error."""
    try:
        return ies.read(lines, "lamp.ies").distribution.flux().value
    except ConditionError as error:
        return error.message


def sweep(count: int, seed: int) -> str:
    """Read a valid and a damaged file in each case."""
    random.seed(seed)
    refused = 0
    for _ in range(count):
        lines = drawn()
        value = ies.read(lines, "lamp.ies").distribution.flux().value
        assert math.isclose(value, plain_flux(lines), rel_tol=1e-9), lines
        label, lines = lines[:3], damaged(lines)
        answer = read_or_refusal(lines)
        if isinstance(answer, str):
            refused += 1
            line = re.match(r"lamp\.ies, line (\d+): ", answer)
            assert line, (answer, lines)
            assert 1 <= int(line[1]) <= max(len(lines), 1), (answer, lines)
        elif lines[:3] == label:
            assert math.isclose(answer, plain_flux(lines), rel_tol=1e-3), lines
    return f"{count} files and as many damaged ones; {refused} were refused"


if __name__ == "__main__":
    from fuzz.command import main

    main(sweep, LONG)
