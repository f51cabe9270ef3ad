"""Hostile words in every option and operand of every command: an answer or a refusal, and no leak.

A case takes an example of a command's help, and puts a hostile text or an extreme number into one
of its words, into one more of the command's options, or into a file.  The exit status is 0, 1 or
2, warnings are errors, and standard error has lines of radcalc alone, all printable.
"""

import os
import random
import re
import shlex
import tempfile
import warnings
from collections import Counter
from collections.abc import Sequence
from contextlib import chdir
from itertools import cycle
from pathlib import Path
from unittest.mock import patch

import click
from distributions import ldt
from distributions.maps.hdr import flat, head
from fuzz.edges import ending
from fuzz.processes import Seen, call

from radcalc.calculators import COMMANDS
from radcalc.cli.command import commands, context

SHORT, LONG = 200, 200_000
ROOT = Path(__file__).parents[2]
EXAMPLE = re.compile(r"^ +(?:.*\| *)?radcalc (\S.*?)(?: {2,}\S.*| [<>|].*)?$", re.MULTILINE)
NUMBER = re.compile(r"\d[\d.]*(?:[eE][+-]?\d+)?")
NUMBERS = str.split("""
    0 -0 -1 1 2 90 180 360 1e-9 1e-320 5e-324 2.3e-308 1e-300 1e-160 1e-100 1e99 1e100 1e160 1e300
    1.79e308 1.8e308 -1e308 1e400 1e-400 1e99999999999 inf -inf nan 1/0 1/3 0.1+-0.2 1e300+-1e300
    1(9) 0+-0 1e-308+-1e308 1,5 1_000 ٣ ² ½ 1e++5 1e+ 0x1p9 --1 +-+1 1e5.5 .e1 1..2 pi 1e308pi
""")
SIZES = NUMBERS[: NUMBERS.index("1.8e308")]  # of floats
LISTS = str.split(
    "0,{},20 {}:{}:{} {},{} 0:1:{} {}:1 0:{}:1 1:{}:3 {}x{} {},{},{} 0:{}:11,0:{}:11,0"
)
UNITS = str.split("""
    lx lm cd W W/m2 cd/m2 umol/m2/s photon ph photon/s m nm deg rad sr sr.deg K s h J eV Hz cm-1 %
    dBm mag EV mired OD stops ISO m2 m2.sr mm2 W/m2/nm lx.s lm.s W/nm/Hz m^99 m^-2 m^1e9 m^-99 1 °
""")
SOURCES = str.split("""
    blackbody:{}K daylight:{}K gaussian:{}nm,{}nm gauss:{}nm,{}nm line:{}nm={} line:{}nm={},{}nm={}
    led:{}nm,{}nm {}K D65 E 300*cos(theta)^{}_cd {}*x/y_cd exp({}*theta)_W/sr cone isotropic sky:{}
    bad.csv bad.ies bad.ldt bad.hdr . / /dev/null a.csv:B a.csv:{}
""")
WORDS = [
    "", " ", "-", "--", "- lx", "-1", "=", ":", ",", ";", "*", "/", "%", "(", ")", "()", "=1", "x=",
    "illuminance=", "=lx", "cct={}mired", "illuminance={}lx", "flux:{}lm", "irradiance:W/m2/nm",
    ":lx", "a:b:c", "1:2", "lx", "{file}", "@", "#", "\\", "'", '"', "\n", "\t", "\0", "\x1b[31m",
    "\x1b]0;x\x07", "\x9b31m", "\u2028", "\u202e", "\ufeff", "\ud800", "\udcff", "\ue000", "\ue003",
    "\U0010ffff", "é", "1 lx\x1b[0m", "9" * 400, "9" * 5000, "1e" + "9" * 400, "0." + "0" * 400,
    "(" * 990 + "1" + ")" * 990, "(" * 15 + "1" + ")" * 15 + " lx", "-" * 990 + "1",
    "1" + "+1" * 400,
    "1" + "^9" * 200, "9^9^9^9", "2**-" * 200 + "2", "sqrt(" * 200, "sqrt(-1)", "ln(0)", "exp(1e9)",
    "1/(1-1)", "tan(90deg)", "asin(2)", "1 lx + 1 m", "1e200 m * 1e200 m", "1e-200 m * 1e-200 m",
    "(1 lx)^99", "2 lx ± 1e308", "0,0,0", "1,2", "1,2,3,4", "0,0,1e-320", "1e200,1e200,0",
    "1e-200,0,0", "nan,0,1", "0,0,0 0,0,0", "20deg:10deg", "90deg,0deg", "400nm:400nm", "1x1",
    "0x0",
    "999999999x999999999", "2020-13-45", "25:61", "2020-01-01T00:00", "Europe/Nowhere", "../../etc",
    "%Y" * 300, "%", "%Q", "%s", "[" * 300, "m" * 5000, "m." * 300, "m/" * 300 + "m", "lx^" * 99,
    "°'\"", "12°30'", "f/0", "1/0s", "ISO 0", "ND0", "16/0", "0:0", "2.39:1", "all", "none", "x",
]  # fmt: skip
FILES = {
    "csv": "wavelength (nm),A,B\n400,1,3\n500,2,4\n600,3,5\n700,1,6\n",
    "log": "time,E [lx]\n2024-03-04 09:00,0\n2024-03-04 10:00,48\n2024-03-04 11:00,55\n",
    "table": "theta (deg),I (cd)\n0,100\n30,80\n60,20\n90,0\n",
    "scene": "name,x (m),y (m),z (m),intensity,half-angle\n"
    "a,1,1,3,100cd,40deg\nb,3,2,3,50cd,50deg\n",
    "lines": "100 lx\n3 fc\n5 lx\n",
    "numbers": "1\n2\n3\n",
    "spectrum": "400 1\n500 2\n600 3\n700 1\n",
    "ies": (ROOT / "examples" / "downlight.ies").read_text(),
    "ldt": "\r\n".join(ldt.written(lambda c, g: 100.0, gammas=[30.0 * k for k in range(7)])),
}
GOOD = {
    "lamp.ies": "ies", "lamp.ldt": "ldt", "table.csv": "table", "room.csv": "scene",
    "grow.csv": "scene", "lux.csv": "log", "par.csv": "log", "gallery.csv": "log",
    "hobo.csv": "log", "measured.csv": "csv", "a.csv": "csv",
}  # fmt: skip
# Long work, which has its own tests, and files that an example would write.
SKIPPED = ("--irradiance-map", "--save", "prompt", "$i", ".exr")
OURS = re.compile(r"(radcalc|try|or|assumed|note|likely|right|wrong|hint|  ).*|Usage: .*|$")


def examples(command: click.Command) -> list[list[str]]:
    """Return the examples in a command's help, as words."""
    text = (command.help or "").replace("\\\n", " ")
    lines = [m[1].rpartition("   (")[0] or m[1] for m in EXAMPLE.finditer(text)]
    calls = [
        shlex.split(line.replace("\b", "")) for line in lines if not any(s in line for s in SKIPPED)
    ]
    return [call for call in calls if call[0] == command.name]


def filled(draw: random.Random, text: str) -> str:
    """Return a form with hostile numbers and units."""
    while "{}" in text:
        number = draw.choice(NUMBERS)
        unit = draw.choice(["", "", *UNITS])
        text = text.replace("{}", number + unit, 1)
    return text


def resized(draw: random.Random, word: str) -> str:
    """Return a word with numbers of other sizes."""
    if word.count(":") == 2:  # a range of another size may have a million values
        return word
    numbers = draw.choice((SIZES, [f"{10 ** draw.uniform(-160, 160):.2g}", "1e-9", "2", "0"]))
    return NUMBER.sub(lambda _: draw.choice(numbers), word, count=draw.choice((0, 1)))


def hostile(draw: random.Random, word: str) -> str:
    """Return a hostile word in the place of another: often one with the same unit."""
    how = draw.randrange(10)
    if how < 3:
        return NUMBER.sub(lambda _: draw.choice(NUMBERS), word, count=draw.choice((0, 1)))
    if how < 5 and (unit := NUMBER.split(word)[-1]):
        return re.sub("{}", lambda _: draw.choice(NUMBERS) + unit, draw.choice(LISTS))
    if how < 6:
        return draw.choice(NUMBERS) + draw.choice([*UNITS, ""])
    if how < 7:
        return filled(draw, draw.choice(SOURCES).replace("_", " "))
    if how < 8:
        place = draw.randint(0, len(word))
        return word[:place] + draw.choice(WORDS) + word[place:]
    return filled(draw, draw.choice(WORDS))


def spoilt(draw: random.Random, text: str) -> str:
    """Return the text of a file with hostile parts."""
    parts = re.split(r"([,;\s]+)", text)
    for _ in range(draw.choice((1, 1, 2, 5))):
        place = draw.randrange(len(parts))
        parts[place] = draw.choice([hostile(draw, parts[place]), draw.choice(NUMBERS)])
    text = "".join(parts)
    return text[: draw.randrange(len(text) + 1)] if draw.random() < 0.1 else text


def picture() -> bytes:
    """Return a small Radiance picture."""
    return head(size="-Y 4 +X 8") + flat([(128, 64, 32, 129)]) * 32


class Commands:
    """The commands in turn, each with its examples and its options."""

    def __init__(self) -> None:
        found = [commands.get_command(context(), name) for name in COMMANDS]
        self.known = [(each, examples(each)) for each in found if each and examples(each)]
        self.turns = cycle(self.options())

    def options(self) -> list[tuple[list[list[str]], click.Option]]:
        return [
            (calls, option)
            for command, calls in self.known
            for option in command.params
            if isinstance(option, click.Option) and option.opts[-1] not in SKIPPED
        ]

    def drawn(self, draw: random.Random) -> list[str]:
        """Return an example of the next option's command, with hostile words."""
        calls, option = next(self.turns)
        words = list(draw.choice(calls))
        places = range(1, len(words))
        if draw.random() < 0.5:  # other numbers, with their units
            for place in draw.sample(places, min(len(places), draw.choice((1, 1, 2, 3)))):
                words[place] = resized(draw, words[place])
            return words
        if draw.random() < 0.7:
            name, form = option.opts[-1], str(option.metavar or "")
            if name in words:
                words[(place := words.index(name)) : place + 2] = []
            value = resized(draw, form) if draw.random() < 0.5 else hostile(draw, form)
            words.append(name if option.is_flag else f"{name}={value}")
        elif places:
            place = draw.choice(places)
            words[place] = hostile(draw, words[place])
        else:
            words.append(hostile(draw, ""))
        return words


def run(draw: random.Random, words: Sequence[str]) -> tuple[list[str], bytes, Seen]:
    """Run a call, sometimes with spoilt files and input."""
    text = FILES[draw.choice(["lines", "numbers", "csv", "log", "spectrum"])]
    if draw.random() < 0.5:
        text = spoilt(draw, text)
    bad = draw.choice(["csv", "table", "log", "scene", "ies", "ldt"])
    words = list(words)
    if draw.random() < 0.05 and not any("\n" in word for word in words):
        words, text = ["prompt"], f"x = 100 lx\n{shlex.join(words)}\nans\n{' '.join(words)}\nx fc\n"
    if draw.random() < 0.2:
        files = [k for k, word in enumerate(words) if word in GOOD]
        for k in files:
            words[k], bad = f"bad.{words[k].rpartition('.')[2]}", GOOD[words[k]]
    if any("bad." in word for word in words):
        data = spoilt(draw, FILES[bad]).encode("utf-8", "surrogatepass")
        for suffix in ("csv", "ies", "ldt", "hdr"):
            Path(f"bad.{suffix}").write_bytes(data)
    data = text.encode("utf-8", "surrogatepass")
    with warnings.catch_warnings(), ending(words):
        warnings.simplefilter("error")
        return words, data, call(words, data)


def hold(words: list[str], data: bytes, seen: Seen) -> None:
    """Check the status of a call, and that standard error has lines of radcalc alone."""
    told = (words, data, seen)
    assert seen.status in (0, 1, 2), told
    assert all(c.isprintable() or c == "\n" for c in seen.err), told
    assert (
        b"--steps" in data or "--steps" in words or all(map(OURS.fullmatch, seen.err.split("\n")))
    ), told
    assert seen.status != 2 or re.search("^radcalc: ", seen.err, re.MULTILINE), told


def sweep(count: int, seed: int) -> str:
    """Check every call; return the counts of exit statuses."""
    draw = random.Random(seed)
    statuses: Counter[int] = Counter()
    every = Commands()
    with (
        tempfile.TemporaryDirectory() as folder,
        chdir(folder),
        patch.dict(os.environ, {"COLUMNS": "80"}),
    ):
        for name, kind in GOOD.items():
            Path(name).write_text(FILES[kind])
        for name in ("room.hdr", "ball.hdr"):
            Path(name).write_bytes(picture())
        for _ in range(count):
            words, data, seen = run(draw, every.drawn(draw))
            hold(words, data, seen)
            statuses[seen.status] += 1
    return ", ".join(f"{count} with status {status}" for status, count in sorted(statuses.items()))


if __name__ == "__main__":
    from fuzz.command import main

    main(sweep, LONG)
