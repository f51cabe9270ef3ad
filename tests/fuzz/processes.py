"""Random calls: an answer is complete, an error has status 2 and a hint, and there are no crashes.

A case changes a call of the transcripts (`tests/cases/`): letters, words, numbers, bytes that are
not text, the input.  It runs twice: with a normal output, and with an output that takes only a part
of the data at a time and may run full.
"""

import errno
import io
import os
import random
import shlex
import sys
from collections import Counter
from collections.abc import Sequence
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path
from typing import Any, NamedTuple
from unittest.mock import patch

from radcalc.__main__ import run

SHORT, LONG = 75, 100_000
CASES = Path(__file__).parent.parent / "cases"
NUMBERS = """
    1e400 1e-400 1e308 1e-308 0 -0 -1 1/3 1/0 1e2/3 3e2pi 2/3pirad 1e400/1e400 1e400*0 nan -inf
    1,5 1.000,5 1_000 0x10 4pi .5 . - -- = , : ; () ((((( ))))) 1:2:3 1m:5m:1m 5m:1m:1m 1m,2m @
    m^99 m^-2 W/m2/sr/nm % °
"""
EXTREME = [
    *NUMBERS.split(),
    "", " ", "\t", "\n", "\xa0", "\u2028", "\u2212", "\u212b", "\ud800", "\udcff", "\U0010ffff",
    "x" * 2000, "9" * 2000, "(" * 2000, "1 " * 500,
]  # fmt: skip
INPUTS = [
    b"", b"\n", b"1\n2\n3\n", b"1", b"100 lx\n3 fc\n", b"a,1\nb,2\n", b"#\n\n1,5\n", b"\xff\0",
    b"nm,W/m2/nm\n400,1\n500,2\n600,3\n700,1\n", b"400 1\n500 2\n600 3\n",
    b"\xef\xbb\xbf1\r\n2\r\n",
]  # fmt: skip


class Parts(io.RawIOBase):
    """A file that takes a few bytes at a time, and fails after a random number of bytes."""

    def __init__(self, room: int) -> None:
        super().__init__()
        self.room = room
        self.taken = bytearray()  # an answer may have megabytes

    def writable(self) -> bool:
        return True

    def write(self, data: Any) -> int:
        if self.room == 0:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        part = bytes(data[: min(self.room, random.randint(1, 200))])
        self.taken += part
        self.room -= len(part)
        return len(part)


class Seen(NamedTuple):
    """The output of a call and its exit status."""

    status: int
    out: bytes
    err: str


def call(words: list[str], text: bytes, parts: Parts | None = None) -> Seen:
    """Run radcalc in this process with a text as its standard input."""
    whole, said = io.BytesIO(), io.BytesIO()
    out, err = io.TextIOWrapper(parts or whole, "utf-8"), io.TextIOWrapper(said, "utf-8")
    stdin = io.TextIOWrapper(io.BytesIO(text))
    with redirect_stdout(out), redirect_stderr(err), patch.object(sys, "stdin", stdin):
        status = run(words)
    return Seen(status, bytes(parts.taken) if parts else whole.getvalue(), said.getvalue().decode())


def corpus() -> list[list[str]]:
    """Return the words of the calls in transcripts, without pipelines."""
    lines = [line for path in sorted(CASES.glob("*.md")) for line in path.read_text().splitlines()]
    calls = [line.removeprefix("$ radcalc ") for line in lines if line.startswith("$ radcalc ")]
    return [shlex.split(line) for line in calls if not set(line) & set("|<>$;&\\`")]


def changed(word: str) -> str:
    """Change the digits of a word, or drop, double, insert or replace a few letters."""
    if random.random() < 0.6:
        return "".join(random.choice("0123456789") if c.isdigit() else c for c in word)
    for _ in range(random.randint(1, 3)):
        k = random.randint(0, len(word))
        new = random.choice([chr(random.randint(1, 127)), random.choice(EXTREME)[:3], "\udcff"])
        word = random.choice(
            [word[:k] + word[k + 1 :], word[:k] + word[k - 1 :], word[:k] + new + word[k:],
             word[:k] + new + word[k + 1 :]]
        )  # fmt: skip
    return word


def draw(calls: Sequence[list[str]]) -> tuple[list[str], bytes]:
    """Make a call with one to three changes, and its input."""
    words = list(random.choice(calls))
    others = [call for call in calls if call[:1] == words[:1]]
    for _ in range(random.choice([1, 1, 1, 2, 3])):
        values = [k for k in range(1, len(words)) if words[k][:2] != "--"]
        k = random.choice(values if values and random.random() < 0.9 else range(len(words) + 1))
        other = random.choice(others)
        how = random.randrange(11)
        if how < 5:
            words[k : k + 1] = map(changed, words[k : k + 1])
        elif how == 5:
            words[k : k + 1] = [random.choice(EXTREME)]
        elif how == 6:
            words[k : k + 1] = [random.choice(other)]
        elif how == 7:
            words.insert(k, random.choice([random.choice(EXTREME), random.choice(other)]))
        elif how == 8:
            del words[k : k + 1]
        elif how == 9:  # an option of another call, and its value
            k = random.randrange(len(other))
            words += other[k : k + 2]
        else:
            garbage = random.randbytes(random.randint(0, 20)).replace(b"\0", b"")
            words[k : k + 1] = [os.fsdecode(garbage)]
    text = random.choice(INPUTS)
    if random.random() < 0.3:
        text = text[: random.randint(0, len(text))] + random.randbytes(random.randint(0, 30)) + text
    return words, text


def hold(words: list[str], text: bytes) -> int:
    """Check one call; return its exit status."""
    seen = call(words, text)
    told = (words, text, seen)
    assert seen.status in (0, 1, 2), told
    assert "Traceback" not in seen.err, told
    if seen.status == 2:
        assert "radcalc: " in seen.err or (not words and "Usage: " in seen.err), told
        assert "-" in words or not seen.out or seen.out.startswith(b'{"error": '), told
    parts = Parts(random.choice([len(seen.out), random.randint(0, len(seen.out))]))
    again = call(words, text, parts)
    if len(again.out) == len(seen.out):
        assert (again.status, again.out) == (seen.status, seen.out), (told, again)
    else:
        assert again.status == 2, (told, again)
        is_full = "cannot write the answer: No space left on device" in again.err
        assert is_full or (seen.status == 2 and again.err == seen.err), (told, again)
        assert seen.out.startswith(again.out), (told, again)
    return seen.status


def sweep(count: int, seed: int) -> str:
    """Check every call; return the counts of exit statuses."""
    random.seed(seed)
    calls = corpus()
    statuses = Counter(hold(*draw(calls)) for _ in range(count))
    return ", ".join(f"{count} with status {status}" for status, count in sorted(statuses.items()))


if __name__ == "__main__":
    from fuzz.command import main

    main(sweep, LONG)
