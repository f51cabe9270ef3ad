"""A right answer is right in any unit, and every answer gets a verdict or a refusal.

The questions are the examples of the calculators, and calculators with every kind of light and
every link between the kinds.  A right answer is the value that the calculator gives, in a unit of
its dimension or on a scale, rounded to 2 to 12 digits.  Other answers have extreme numbers and any
unit.
"""

import random
from collections import Counter, defaultdict
from collections.abc import Iterator
from contextlib import suppress
from functools import cache

from helpers import PLAIN, example_of
from homework.questions import RIGHT, asked, claim_of

from radcalc.answer import Value
from radcalc.calculators.results import fits, in_unit, unit_for
from radcalc.cli.spelling import Shell
from radcalc.errors import RadcalcError
from radcalc.homework import RELATIVES, REMARKS, Question, check
from radcalc.units import Dimension, scale_table
from radcalc.units.table import spellings, unit_of

SHORT, LONG = 200, 40_000
LINKS = ("", "--spectrum D65", "--wavelength 555nm", "--efficacy 200lm/W")
FLUX, RADIANCE, IRRADIANCE = (
    ("800lm", "3W", "5umol/s"),
    ("1000cd/m2", "10W/m2/sr", "1umol/s/m2/sr"),
    ("500lx", "2W/m2", "20umol/m2/s"),
)
CALLS = {
    "point-source --flux {} --distance 2m": FLUX,
    "point-source --irradiance {} --distance 2m --incidence 30deg": IRRADIANCE,
    "lambertian --radiance {} --area 1m2": RADIANCE,
    "lambertian --incident-irradiance {} --reflectance 0.8": IRRADIANCE,
    "lambertian disc --radiance {} --radius 25cm --height 75cm": RADIANCE,
    "etendue --area 1mm2 --half-angle 30deg --radiance {}": RADIANCE,
    "sensor --radiance {} --f-number 4 --time 10ms --pixel-pitch 4um": RADIANCE,
    "laser --flux {} --diameter 1mm --divergence 1mrad --distance 10m": FLUX,
    "sky overcast --zenith-radiance {} --tilt 60deg": RADIANCE,
    "uberlight 0.1,0,2 --flux 1W --intensity {}": ("100cd", "2W/sr"),
}
CONVERSIONS = (
    "10 mW dBm", "100 lx EV", "0.5 1 OD", "0.5 1 dB", "0.5 1 stops", "3000 K mired", "2 lx mag",
    "100 cd/m2 mpsas", "100 cd/m2 bril", "0 lx fc", "1e-300 lm klm",
)  # fmt: skip
PARTS = ("{}", "{}/m2", "{}/cm2", "{}/ft2", "{}/sr", "{}/m2/sr", "{} s", "{} h", "{} s/m2")
EXTREME = [
    "0",
    "-1",
    "1",
    "100",
    "1e300",
    "-1e300",
    "1e-300",
    "4000",
    "-4000",
    "5e-324",
    "1e308",
    "pi",
    "1/3",
    "2*3",
    "1+-0.1",
    "0+-1",
    "1e300+-1e299",
]
TOLERANCES = (None, None, "1%", "3sf", "0", "0.5lx", "15sf")


def _calls() -> Iterator[str]:
    yield from (words for words, _, _ in RIGHT)
    yield from (Shell.command(name, *example_of(name)).removeprefix("radcalc ") for name in PLAIN)
    yield from (f"{call.format(v)} {link}" for call in CALLS for v in CALLS[call] for link in LINKS)
    yield from (f"convert {words}" for words in CONVERSIONS)


@cache
def questions() -> list[tuple[str, Question]]:
    """Return the questions that have an answer; some links do not reach a kind."""
    found = []
    for words in _calls():
        with suppress(AssertionError):  # refused
            found.append((words, asked(words.strip())))
    assert len(found) > 150
    return found


@cache
def units() -> dict[Dimension, list[str]]:
    """Return units by dimension: every spelling with some prefixes, and units of every quantity."""
    found = defaultdict(list)
    whole = [prefix + spelling for spelling in spellings() for prefix in ("", "m", "k", "u")]
    for text in [part.format(spelling) for part in PARTS for spelling in whole]:
        try:
            unit = unit_of(text)
        except RadcalcError:
            continue
        if unit is not None:
            found[unit.dimension].append(text)
    return found


def _right_claims(value: Value, dice: random.Random) -> Iterator[tuple[str, float]]:
    """Yield a random unit and a random scale of a result, with its numbers."""
    dimensions = [d for d in (*value.dimensions, *value.reach) if units().get(d)]
    texts = [dice.choice(units()[dice.choice(dimensions)])] if dimensions else []
    text = dice.choice(scale_table.spellings())
    texts += [text] if fits(value, unit_for(value, text)) else []
    for text in texts:
        try:
            yield text, in_unit(value, unit_for(value, text))
        except RadcalcError:  # too large for a number, or 0 on a scale
            continue


def sweep(count: int, seed: int) -> str:
    dice, seen = random.Random(seed), Counter[str]()
    for k in range(count):
        words, question = dice.choice(questions())
        values = [v for v in question.answer.values if not v.is_absent]
        value = dice.choice(values)
        claims = [*_right_claims(value, dice)] if isinstance(value.amount, float) else []
        for unit, number in claims:
            name, digits = dice.choice(["", value.name]), dice.choice([2, 3, 4, 5, 12])
            claim = claim_of(name, number, digits, unit)
            if name or (value.given is None and value.name not in REMARKS):
                found = check(question, claim)
                only_by_name = not name and value.name.startswith(RELATIVES)
                assert found.right or only_by_name, (words, claim, found)
                seen["right" if found.right else "relative"] += 1
        unit = dice.choice([*units().values(), scale_table.spellings(), [""]])
        names = ["", *(v.name for v in values)]
        name = dice.choice(names)
        claim = f"{name}={dice.choice(EXTREME)}{dice.choice(unit)}".removeprefix("=")
        try:
            found = check(question, claim, TOLERANCES[k % len(TOLERANCES)])
            seen["extreme, right" if found.right else "extreme, wrong"] += 1
        except RadcalcError:
            seen["extreme, refused"] += 1
    return f"{len(questions())} questions, " + ", ".join(f"{n} {w}" for w, n in seen.items())


if __name__ == "__main__":
    from fuzz.command import main

    main(sweep, LONG)
