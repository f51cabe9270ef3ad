"""`--check` with right answers in few digits, random numbers, and one edit of a law.

The oracle is the arithmetic of each question as a learner writes it, with one edit.
"""

import math
import random
import sys
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

from radcalc.homework import check

sys.path.append(str(Path(__file__).parent.parent))  # for a script
from fuzz.command import main
from homework.questions import asked, claim_of, typed

SHORT, LONG = 60, 20_000
Numbers = dict[str, float]


def c(angle: float) -> float:
    return math.cos(math.radians(angle))


class Case(NamedTuple):
    """A question with {letters}, their ranges, the result, and its right and wrong formulas."""

    words: str
    ranges: dict[str, tuple[float, float]]
    name: str
    unit: str
    right: Callable[[Numbers], float]
    wrong: dict[str, Callable[[Numbers], float]]


def _cap(angle: float) -> float:
    return 2 * math.pi * (1 - c(angle))


CASES = [
    Case(
        "convert {i}cd lx --distance {d}m --incidence {a}deg",
        {"i": (10, 5000), "d": (1.2, 9), "a": (20, 70)},
        "",
        "lx",
        lambda n: n["i"] * c(n["a"]) / n["d"] ** 2,
        {
            "cosine-forgotten": lambda n: n["i"] / n["d"] ** 2,
            "cosine-upside-down": lambda n: n["i"] / n["d"] ** 2 / c(n["a"]),
            "distance-not-squared": lambda n: n["i"] * c(n["a"]) / n["d"],
            "distance-upside-down": lambda n: n["i"] * c(n["a"]) * n["d"] ** 2,
        },
    ),
    Case(
        "point-source --flux {p}lm --distance {d}m --time {t}min",
        {"p": (100, 9000), "d": (1.2, 9), "t": (2, 50)},
        "exposure",
        "lx.s",
        lambda n: n["p"] / (4 * math.pi * n["d"] ** 2) * n["t"] * 60,
        {
            "wrong-sphere": lambda n: n["p"] / (2 * math.pi * n["d"] ** 2) * n["t"] * 60,
            "minutes-for-seconds": lambda n: n["p"] / (4 * math.pi * n["d"] ** 2) * n["t"],
            "time-upside-down": lambda n: n["p"] / (4 * math.pi * n["d"] ** 2) / n["t"] / 60,
        },
    ),
    Case(
        "lambertian --incident-illuminance {e}lx --reflectance {r}",
        {"e": (50, 20000), "r": (0.11, 0.93)},
        "luminance",
        "cd/m2",
        lambda n: n["e"] * n["r"] / math.pi,
        {
            "pi-forgotten": lambda n: n["e"] * n["r"],
            "reflectance-forgotten": lambda n: n["e"] / math.pi,
            "reflectance-upside-down": lambda n: n["e"] / n["r"] / math.pi,
            "absorbed-for-reflected": lambda n: n["e"] * (1 - n["r"]) / math.pi,
            "two-pi-for-pi": lambda n: n["e"] * n["r"] / 2 / math.pi,
        },
    ),
    Case(
        "screen --flux {p}lm --width {w}m --aspect {a} --gain {g}",
        {"p": (500, 9000), "w": (1.1, 9), "a": (1.2, 2.5), "g": (0.6, 2.6)},
        "luminance",
        "cd/m2",
        lambda n: n["g"] * n["p"] * n["a"] / n["w"] ** 2 / math.pi,
        {
            "gain-forgotten": lambda n: n["p"] * n["a"] / n["w"] ** 2 / math.pi,
            "aspect-forgotten": lambda n: n["g"] * n["p"] / n["w"] ** 2 / math.pi,
            "pi-forgotten": lambda n: n["g"] * n["p"] * n["a"] / n["w"] ** 2,
        },
    ),
    Case(
        "solid-angle cone --half-angle {a}deg",
        {"a": (12, 62)},
        "solid-angle",
        "sr",
        lambda n: _cap(n["a"]),
        {
            "full-for-half": lambda n: _cap(n["a"] * 2),
            "flat-disc-for-cap": lambda n: math.pi * math.radians(n["a"]) ** 2,
            "solid-for-projected": lambda n: math.pi * (1 - c(n["a"]) ** 2),
        },
    ),
    Case(
        "calorimeter --flux {p}W --mass {m}g --specific-heat {h}J/kg/K --time {t}min",
        {"p": (0.3, 40), "m": (11, 900), "h": (200, 4000), "t": (2, 50)},
        "temperature-rise",
        "K",
        lambda n: n["p"] * n["t"] * 60 / (n["m"] / 1000 * n["h"]),
        {
            "minutes-for-seconds": lambda n: n["p"] * n["t"] / (n["m"] / 1000 * n["h"]),
            "time-upside-down": lambda n: n["p"] / n["t"] / 60 / (n["m"] / 1000 * n["h"]),
            "specific-heat-forgotten": lambda n: n["p"] * n["t"] * 60 / (n["m"] / 1000),
        },
    ),
]
GUESS = math.log(30)


def sweep(count: int, seed: int) -> str:
    """Ask `count` questions, with four answers each."""
    chance = random.Random(seed)
    accused = missed = edits = 0
    for k in range(count):
        case = CASES[k % len(CASES)]
        numbers = {
            name: float(typed(math.exp(chance.uniform(*map(math.log, ends))), 3))
            for name, ends in case.ranges.items()
        }
        words = case.words.format(**numbers)
        question = asked.__wrapped__(words, case.name)
        right = case.right(numbers)
        digits = chance.randint(2, 5)
        for text in (claim_of(case.name, right, digits, case.unit), _whole(case, right, digits)):
            found = check(question, text, f"{digits + 2}sf")
            assert found.right or [one.mistake for one in found.diagnoses] == ["rounded"], (
                words,
                text,
                found,
            )
        by_chance = right * math.exp(chance.uniform(-GUESS, GUESS))
        found = check(question, claim_of(case.name, by_chance, 3, case.unit))
        accused += any(one.mistake != "rounded" for one in found.diagnoses)
        mistake = chance.choice(sorted(case.wrong))
        wrong = case.wrong[mistake](numbers)
        if abs(wrong / right - 1) > 0.02:
            edits += 1
            found = check(question, claim_of(case.name, wrong, 4, case.unit))
            missed += mistake not in [one.mistake for one in found.diagnoses]
    assert accused <= 0.03 * count + 3, f"{accused} of {count} numbers by chance are accused"
    assert missed <= 0.02 * edits, f"{missed} of {edits} edits are not named"
    return f"{accused} of {count} random numbers diagnosed, {missed} of {edits} edits missed"


def _whole(case: Case, right: float, digits: int) -> str:
    """Format the right value with so many digits; a large one as a power of ten, not with zeros."""
    rounded = float(typed(right, digits))
    is_large = rounded >= 10**digits
    number = f"{rounded:.{digits - 1}e}" if is_large else f"{rounded:.{digits}g}"
    return f"{case.name}={number}{case.unit}" if case.name else f"{number}{case.unit}"


if __name__ == "__main__":
    main(sweep, LONG)
