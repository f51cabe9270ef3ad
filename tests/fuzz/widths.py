"""Tables of all widths: every number and unit of the plain answer is in a line, unbroken.

The sweep draws a command, a width of 1 to 120 columns, 1 to 17 digits and a language.
"""

import io
import os
import random
from contextlib import redirect_stderr, redirect_stdout
from unittest.mock import patch

from radcalc.cli import run

SHORT, LONG = 60, 20_000
COMMANDS = [
    "convert 800 lm cd --isotropic",
    "convert 1e-30 W/m2/sr/nm",
    "convert 12345678 uW mW/cm2 --area 1m2",
    "convert 1 lm lx --isotropic --distance 1m,2.5km,1e-7m",
    "photon 555nm",
    "direction 1 -2 3e-9",
    "solid-angle cone --half-angle 1e-5deg",
    "ev --luminance 4000cd/m2 --iso 100",
    "point-source --flux 100lm --distance 2m,300m,4e9m",
    "lambertian disc --luminance 1e4cd/m2 --radius 25cm --height 75cm",
    "spectrum blackbody:2856K",
]


def shown(words: list[str]) -> str:
    """Return the standard output of a command."""
    out, err = (io.TextIOWrapper(io.BytesIO(), "utf-8") for _ in range(2))
    with redirect_stdout(out), redirect_stderr(err):
        assert run(words) == 0, (words, err.buffer.getvalue())
    return out.buffer.getvalue().decode()


def sweep(count: int, seed: int) -> str:
    """Draw a table in each case; return the counts of tables and of lines."""
    random.seed(seed)
    drawn = 0
    for _ in range(count):
        words = random.choice(COMMANDS).split()
        digits = str(random.randint(1, 17))
        environment = {
            "COLUMNS": str(random.randint(1, 120)),
            "LC_ALL": random.choice(["C.UTF-8", "cs_CZ.UTF-8", "ru_RU.UTF-8"]),
        }
        plain = shown([*words, "--format", "plain", "--precision", digits])
        with patch.dict(os.environ, environment):
            table = shown([*words, "--format", "table", "--precision", digits])
        drawn += "\u2500" in table
        cells = table.split()
        for line in plain.splitlines():
            number, unit = line.split("\t")[-2:]
            assert number in cells, (environment, words, digits, number)
            assert unit in cells or f"[{unit}]" in cells or unit == "1" or " " in unit, (
                words,
                unit,
            )
            assert unit in table or unit == "1", (environment, words, digits, unit)
    return f"{drawn} tables and {count - drawn} plain answers, with all numbers and units unbroken"


if __name__ == "__main__":
    from fuzz.command import main

    main(sweep, LONG)
