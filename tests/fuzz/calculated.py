"""Streams of calculators, computed as arrays, against the same lines one by one.

A case is a call of a transcript with one of its quantities from standard input, and all its
results.  Most lines are near the number of the transcript; some are far from it or bad.
"""

import json
import math
import random
import re
import shlex
from collections import Counter
from functools import cache
from pathlib import Path
from typing import NamedTuple
from unittest.mock import patch

from conftest import DOCS, ROOT, run

from radcalc.quantities.symbols import QUANTITY, SYMBOLS
from radcalc.streams import calculated

SHORT, LONG = 10, 4000
TRANSCRIPTS = [*sorted((ROOT / "tests" / "cases").glob("*.md")), *DOCS]
PAGES = (
    "calorimeter", "direction", "etendue", "ev", "lambertian", "laser", "mesopic", "photon",
    "point-source", "room", "screen", "sensor", "sky", "solid-angle",
)  # fmt: skip
OF_OUTPUT = {  # options with the number of their words
    "-g": 2, "--get": 2, "--format": 2, "--precision": 2, "--json": 1, "--steps": 1, "-n": 1,
    "-q": 1, "--auto": 1,
}  # fmt: skip
AMOUNT = re.compile(r"([-+]?[\d.]+(?:[eE][-+]?\d+)?) *([^\d.,:/+±(][^,:+±(]*)?")
BAD = ("x", "", "0", "-1", "1e99", "1e-99", "1/3", "# a comment")


class Stream(NamedTuple):
    """A call with `-` for a number, and that number with its unit."""

    words: tuple[str, ...]
    option: str
    number: float
    unit: str


def in_calls(path: Path) -> list[list[str]]:
    """Return the words of every call of a calculator in a transcript, without output options."""
    found = []
    for line in re.findall(r"^\$ radcalc ([^|<>\n]+)$", path.read_text(encoding="utf-8"), re.M):
        if line.split()[0] not in PAGES or "--check" in line or "--plot" in line:
            continue
        words, kept = shlex.split(line), []
        while words:
            count = OF_OUTPUT.get(words[0], 0)
            kept += [] if count else words[:1]
            words = words[count or 1 :]
        found.append(kept)
    return found


@cache
def streams() -> list[Stream]:
    """Return every call of the transcripts with each of its quantities as a stream."""
    found: dict[tuple[str, ...], Stream] = {}
    for words in [words for path in TRANSCRIPTS for words in in_calls(path)]:
        for k, word in enumerate(words[:-1]):
            symbol = SYMBOLS.get(word.removeprefix("--"))
            amount = AMOUNT.fullmatch(words[k + 1])
            if word[:2] == "--" and symbol and symbol.form == QUANTITY and amount:
                number, unit = amount[1], amount[2] or ""
                call = (*words[: k + 1], f"- {unit}".strip(), *words[k + 2 :])
                found.setdefault(call, Stream(call, symbol.name, float(number), unit))
    return list(found.values())


@cache
def results(stream: Stream) -> tuple[str, ...]:
    """Return the names of the results; none if the call is refused or has several answers."""
    amount = f"{stream.number!r}{stream.unit}"
    words = [amount if word == f"- {stream.unit}".strip() else word for word in stream.words]
    done = run(*words, "--json", cwd=ROOT)
    answer = {} if done.returncode else json.loads(done.stdout)
    return tuple(answer["results"]) if isinstance(answer, dict) and answer else ()


def draw_lines(number: float) -> list[str]:
    """Return lines near a number; some are far from it or bad."""
    is_clean = random.random() < 0.5
    lines = []
    for _ in range(random.choice([20, 60, 200])):
        factor = random.uniform(0.9, 1.1)
        if not is_clean and random.random() < 0.1:
            factor = math.exp(random.uniform(-5, 5))
        value = number * factor if number else random.uniform(0, 30)
        lines.append(f"{value:.3g}" if random.random() < 0.3 else repr(value))
    if not is_clean:
        for _ in range(random.randrange(4)):
            lines.insert(random.randrange(len(lines)), random.choice(BAD))
    return lines


def answered(words: list[str], lines: str, first: int) -> tuple[int, str, list[str], set[str]]:
    """Return the status, the answers, the errors and the remarks (these without numbers)."""
    with patch.object(calculated, "FIRST", first):
        done = run(*words, input=lines, cwd=ROOT)
    said = done.stderr.splitlines()
    refusals = [line for line in said if line.startswith("radcalc: stdin")]
    remarks = [
        re.sub(r": lines? \d[\d, ]*( to \d+| and others up to \d+)?: ", ": ", line) for line in said
    ]
    return (
        done.returncode,
        done.stdout,
        refusals,
        {re.sub(r"\d[\d.e+-]*( to -?\d[\d.e+-]*)?", "#", line) for line in remarks},
    )


def hold() -> str:
    """Answer random lines of a stream in both ways, and compare; return the calculator."""
    stream = random.choice(streams())
    while not (names := results(stream)):
        stream = random.choice(streams())
    lines = draw_lines(stream.number)
    words = [*stream.words, *[word for name in names for word in ("-g", name)]]
    words += ["--precision", "17", "--invalid", random.choice(["abort", "fail", "warn"])]
    text = "".join([f"{line}\n" for line in lines])
    one_by_one = answered(words, text, len(lines) + 1)
    as_arrays = answered(words, text, calculated.FEWEST)
    assert one_by_one == as_arrays, (words, text, one_by_one, as_arrays)
    return stream.words[0]


def sweep(count: int, seed: int) -> str:
    """Check many streams; return the number of streams per calculator."""
    random.seed(seed)
    counts = Counter(hold() for _ in range(count))
    return ", ".join(f"{count} of {name}" for name, count in sorted(counts.items()))


if __name__ == "__main__":
    from fuzz.command import main

    main(sweep, LONG)
