"""Hints of refused conversions and calculators lead to answers.

Units, conditions and inputs are drawn from the examples of the vocabulary; a refused call is
made again as its hint proposes, in each of the ways.
"""

import random
import sys
from pathlib import Path

import click

sys.path.insert(0, str(Path(__file__).parent.parent))

from following import call, liars  # the folder of the tests is on the path when sweeps run
from fuzz.steps import CONDITIONS, UNITS

from radcalc.calculators.solid_angle import SHAPES
from radcalc.cli.command import SymbolOption, commands

SHORT, LONG = 15, 5_000

CALCULATORS = ("point-source", "lambertian", "etendue", "ev", "calorimeter", "solid-angle")
FLAT = ("patch", "disc", "sphere", "rectangle", "plane", "hemisphere")
LEFT_OUT = ("--range", "--photon-range", "--corner", "--perpendicular", "--polar", "--azimuth")


def conversion(draw: random.Random) -> list[str]:
    """Make a conversion between two units under up to two conditions."""
    words = ["convert", "2", *draw.sample(UNITS, 2)]
    for name in draw.sample(list(CONDITIONS), draw.randint(0, 2)):
        value = CONDITIONS[name]
        words += [f"--{name}"] if value is True else [f"--{name}", str(value)]
    return words


def calculation(draw: random.Random) -> list[str]:
    """Make a call of a calculator with up to three of its options."""
    name = draw.choice(CALCULATORS)
    command = commands.get_command(click.Context(commands), name)
    assert command is not None
    shapes = {"solid-angle": [*list(SHAPES)[:-1], "pixel"], "lambertian": FLAT}.get(name, ("",))
    options = [
        option
        for option in command.params
        if isinstance(option, SymbolOption) and option.opts[0] not in LEFT_OUT
    ]
    words = [name, draw.choice(shapes)]
    for option in draw.sample(options, min(len(options), draw.randint(1, 3))):
        words.append(option.opts[0])
        if not option.is_flag:
            words.append(str(option.metavar or option.type.choices[0]))
    return [word for word in words if word]


def sweep(count: int, seed: int) -> str:
    """Draw calls, and follow the hints of refused ones."""
    draw = random.Random(seed)
    refused = 0
    for k in range(count):
        words = calculation(draw) if k % 2 else conversion(draw)
        if call(words).error:
            refused += 1
            found = liars(words)
            assert not found, "\n".join(found)
    return f"{refused} of {count} calls refused, with hints that lead to an answer"


if __name__ == "__main__":
    from fuzz.command import main

    main(sweep, LONG)
