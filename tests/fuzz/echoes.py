"""Input cannot control the terminal or forge a line of an answer.

A case puts characters that are not printable (control and bidirectional characters, line
separators, lone surrogates, all kinds of blanks) into a word of a call, the name of a file or its
text.
"""

import io
import os
import random
import sys
import tempfile
from collections import Counter
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path
from typing import NamedTuple
from unittest.mock import patch

from radcalc.__main__ import run

SHORT, LONG = 200, 200_000
LONGEST = 700  # characters of a line on standard error
NASTY = [
    *map(chr, range(1, 32)),
    *"\x7f\x85\x9b\xa0\xad\u061c\u180e\u200b\u200e\u200f\u2028\u2029\u202a\u202e\u2066\u2069\u3000",
    *"\ue000\ue001\ue002\ue003\ufeff\ud800\udc80\udcff",
    "x" * 5000, "9" * 900,
    "\x1b[31m", "\x1b]0;x\x07", "\r\nnote: forged", "\u2028note: forged",
]  # fmt: skip
CALLS = """
convert 100 lx fc
convert 555nm THz
convert 5 W m-2 to mW cm-2
convert 250 cd/m2
convert 800 lm cd --isotropic
convert 800 lm lx --isotropic --distance 1m,2m
convert 5 mW lm --wavelength 555nm
convert 5 mW lm --spectrum blackbody:2856K --range 380nm:780nm
convert 5 mW lm --spectrum {file}
convert 5 mW lm --spectrum {file}:B
convert 100 lx fc --check 9.3 --tolerance 1%
convert - lx fc
convert - fc
convert - lx fc --field 2 --delimiter ;
convert - lx fc --column E --delimiter ,
convert - fc --header --delimiter , --add E2
convert - lx W/m2 --spectrum D65 --header --rename E2
convert - lx fc --decimal , --field 2 --delimiter ;
point-source --flux 800lm --distance 2m --beam-angle 30deg
point-source --intensity 5cd --distance 1m:3m:1m -g irradiance:lx
point-source --flux 800lm --distance 2m --check illuminance=15.9lx
point-source --flux 800lm --distribution isotropic
lambertian disc --luminance 1e4cd/m2 --radius 25cm --height 75cm
solid-angle zone --polar 30deg:60deg
solid-angle polygon 1,0,1 0,1,1 0,0,1
direction 1 2 3
direction --polar 30deg --azimuth 40deg
etendue --area 1cm2 --f-number 2
integrate cos(theta) --hemisphere
integrate theta*sin(phi)**2 --half-angle 30deg
photon 555nm
photon 2.2eV --observer photopic
spectrum D65
spectrum blackbody:3000K
spectrum line:632.8nm=1,500nm
spectrum gaussian:500nm,20nm
spectrum {file}
spectrum {file} --column B
spectrum -
spectrum - --column B
mesopic --luminance 1cd/m2 --spectrum LED-B3
ev --luminance 4000cd/m2 --iso 100 --f-number 8
calorimeter --mass 1kg --specific-heat 4186J/kg/K --temperature-rise 2K --time 60s
screen --flux 2000lm --width 2m
sensor --luminance 100cd/m2 --f-number 2.8 --time 10ms --pixel-pitch 3um --wavelength 550nm
laser --flux 5mW --diameter 1mm --divergence 1mrad --distance 10m --limit 25W/m2
room --width 6m --length 9m --height 2m --illuminance 500lx --flux 3600lm --utilance 0.6
uberlight 0,1m,2 --intensity 100cd
uberlight 0,1,2 --superellipse 1,1,2,2 --near 1m:2m --shear 0,1
units lux
units zork
quantities jas
quantities --lang ru
typical moon
covnert 100 lx fc
""".strip().splitlines()  # fmt: skip
FORMATS = [[], [], ["--format", "table"], ["--steps"], ["--json"], ["--format", "csv"]]
TEXTS = [
    "nm,W/m2/nm\n400,1\n500,2\n600,3\n700,1\n",
    "wavelength (nm),A,B\n400,1,3\n500,2,4\n600,3,5\n700,1,6\n",
    "# a lamp, wavelength in nm\n400 1\n500 2\n600 x\n700 1\n",
    "nm;B\n400;1,5\n700;2,5\n",
    "100 lx\n3 fc\n5 zork\n",
    "1\n2\nx\n",
    "A,E\n1,2\n3,x\n",
    "A [lx],E (lx)\n1,2\n3,4,5\n",
    "a;1\nb;2;3\nc;x\n",
    "1,5\n",
    "",
]


class Seen(NamedTuple):
    """The output of a call and its exit status."""

    status: int
    out: str
    err: str


def call(words: list[str], text: bytes) -> Seen:
    """Run radcalc in this process with a text as its standard input."""
    out, err = (io.TextIOWrapper(io.BytesIO(), "utf-8", "backslashreplace") for _ in range(2))
    stdin = io.TextIOWrapper(io.BytesIO(text))
    with redirect_stdout(out), redirect_stderr(err), patch.object(sys, "stdin", stdin):
        status = run(words)
    return Seen(status, *(f.buffer.getvalue().decode() for f in (out, err)))


def stained(text: str) -> str:
    """Insert some of the characters into a text."""
    for _ in range(random.choice([1, 1, 2])):
        place = random.choice([0, len(text), random.randint(0, len(text))])
        text = text[:place] + random.choice(NASTY) + text[place:]
    return text


def draw(folder: Path) -> tuple[list[str], bytes]:
    """Make a call with such characters in a word, in the name of the file or in the input."""
    words = random.choice(CALLS).split()
    text = random.choice(TEXTS)
    name = "lamp.csv"
    if random.random() < 0.5:
        place = random.randrange(len(words))
        words[place] = stained(words[place])
    elif random.random() < 0.2:
        name = stained(name).replace("/", "")
    else:
        text = stained(text)
    path = folder / name
    data = text.encode("utf-8", "surrogateescape" if text.isascii() else "replace")
    if any("{file}" in word for word in words):
        try:
            path.write_bytes(data)
        except (OSError, UnicodeEncodeError):
            path = folder / "missing"
    words = [word.replace("{file}", str(path)) for word in words]
    if words[0] in ("convert", "point-source", "spectrum", "photon") and "-g" not in words:
        words += random.choice(FORMATS)
    return words, data


def hold(words: list[str], seen: Seen) -> None:
    """Check that every character is printable and every remark is one line."""
    assert seen.status in (0, 1, 2), (words, seen)
    if "-" not in words:  # a stream copies the text of other fields unchanged
        wild = [c for c in seen.out if not (c.isprintable() or c in "\n\t")]
        assert not wild, (words, wild, seen)
        assert "\nnote: forged" not in seen.out, (words, seen)
    wild = [c for c in seen.err if not (c.isprintable() or c == "\n")]
    assert not wild, (words, wild, seen)
    assert "\nnote: forged" not in seen.err, (words, seen)
    assert max(map(len, seen.err.splitlines()), default=0) < LONGEST, (words, seen)


def sweep(count: int, seed: int) -> str:
    """Check every call; return the counts of exit statuses."""
    random.seed(seed)
    statuses: Counter[int] = Counter()
    with tempfile.TemporaryDirectory() as folder, patch.dict(os.environ, {"COLUMNS": "80"}):
        for _ in range(count):
            words, text = draw(Path(folder))
            seen = call(words, text)
            hold(words, seen)
            statuses[seen.status] += 1
    return ", ".join(f"{count} with status {status}" for status, count in sorted(statuses.items()))


if __name__ == "__main__":
    from fuzz.command import main

    main(sweep, LONG)
