"""More inputs than a call needs: results of random calls, rounded, and given again as inputs.

A result of a call fits its inputs, whatever digits both are typed with; so such a call must be
answered.  Where an input that is off by a fifth, more or less, is refused, one that is off by ten
times its rounding must be refused, too, if the others are exact.
"""

import random
import re
import sys
from functools import cache, partial
from importlib import import_module
from pathlib import Path
from typing import NamedTuple

sys.path.append(str(Path(__file__).parent.parent))  # for a script
from fuzz.command import main

from radcalc.answer import Answer
from radcalc.calculators import SUMMARIES, page_of
from radcalc.calculators.page import words_of
from radcalc.calculators.solid_angle import SHAPES
from radcalc.calculators.solved import Task
from radcalc.errors import RadcalcError
from radcalc.inputs.reading import read, read_interval
from radcalc.quantities.symbols import QUANTITY, SYMBOLS
from radcalc.units.numbers import rounding
from radcalc.units.table import resolve

SHORT, LONG = 100, 20_000
# These have files or functions as inputs, one input, or results of which none is an option.
WITHOUT = (
    "convert",
    "dose",
    "scene",
    "integrate",
    "environment",
    "photon",
    "spectrum",
    "uberlight",
)
NUMBER = re.compile(r"^\d+(\.\d+)?(e-?\d+)?(?![\d/.])")
EXAMPLES = {  # in addition to those of the pages
    "solid-angle": (
        "cone apex-angle=60deg", "cone projected-solid-angle=1sr", "disc radius=5cm height=50cm",
        "disc diameter=10cm distance=50cm", "disc solid-angle=0.1sr height=50cm",
        "rectangle width=2m length=1m height=1m", "rectangle width=2m length=1m distance=1m",
        "sphere diameter=0.3m solid-angle=0.2sr", "patch radius=1cm distance=2m",
        "patch solid-angle=1e-3sr distance=2m tilt=20deg", "patch area=1cm2 radius=2cm",
        "pyramid solid-angle=0.3sr vertical=40deg",
    ),
    "direction": ("polar=35deg azimuth=20deg", "elevation=35deg azimuth=20deg"),
    "point-source": (
        "flux=800lm half-angle=30deg distance=2m", "flux=800lm hemisphere= distance=2m",
        "intensity=900cd beam-angle=40deg height=3m offset=1m",
        "intensity=900cd half-angle=40deg height=3m offset=1m time=20s receiver-area=10cm2",
        "flux=800lm distance=2m incidence=30deg time=20s",
        "flux=5W wavelength=532nm distance=2m", "flux=800lm exponent=3 distance=2m within=20deg",
    ),
    "lambertian": (
        "disc luminance=1e4cd/m2 radius=25cm height=75cm",
        "disc luminance=1e4cd/m2 area=0.2m2 height=75cm offset=20cm",
        "disc flux=1e4lm radius=25cm height=75cm offset=30cm",
        "patch flux=1e4lm area=25cm2 distance=1.5m incidence=20deg tilt=30deg",
        "patch flux=1e4lm radius=2cm distance=1.5m time=3s",
        "patch luminance=1e4cd/m2 width=2cm length=3cm distance=1.5m",
        "patch luminance=1e4cd/m2 width=2cm length=3cm height=1.5m offset=1m",
        "rectangle flux=500lm width=1m length=2m height=1.5m",
        "rectangle luminance=3000cd/m2 width=1m area=2m2 height=1.5m offset=1m offset-y=0.4m",
        "rectangle luminance=3000cd/m2 width=1m length=2m height=1.5m corner=",
        "sphere luminance=2e4cd/m2 diameter=6cm distance=2m",
        "sphere flux=800lm area=100cm2 distance=2m",
        "hemisphere luminance=3000cd/m2 half-angle=40deg",
    ),
    "etendue": (
        "area=1mm2 half-angle=20deg radiance=1e6cd/m2", "area=1mm2 apex-angle=40deg",
        "radius=1m receiver-radius=1.5m distance=2m radiance=100cd/m2",
        "diameter=1m receiver-diameter=1.5m distance=2m radiance=100cd/m2",
        "radius=1cm receiver-area=4cm2 distance=1m",
    ),
    "ev": ("ev=12 iso=400", "f-number=8 time=1/125s iso=200", "ev100=12 nd=0.9 f-number=8"),
    "sensor": (
        "radiance=10W/m2/sr f-number=4 magnification=0.5 time=10ms pixel-pitch=4um "
        "wavelength=600nm quantum-efficiency=0.5",
        "photons=10000photon quantum-efficiency=0.6",
        "flux=0.1uW wavelength=800nm responsivity=0.4A/W time=3ms",
    ),
    "laser": (
        "flux=5mW diameter=1mm divergence=1.5mrad distance=20m receiver-diameter=7mm time=10s",
    ),
    "screen": ("flux=3000lm width=2m height=1.2m gain=1.3",),
}  # fmt: skip


class Call(NamedTuple):
    """A call of a calculator: its operands, and texts by symbol."""

    command: str
    words: tuple[str, ...]
    texts: dict[str, str]

    def __str__(self) -> str:
        options = [f"--{name} '{text}'".removesuffix(" ''") for name, text in self.texts.items()]
        return " ".join(["radcalc", self.command, *self.words, *options])

    def answer(self) -> Answer:
        page = page_of(self.command)
        inputs = {
            name: read_interval(name, text)
            if name in page.intervals
            else read(name, text or True, bare=page.bare.get(name, ""))
            for name, text in self.texts.items()
        }
        return self._task().solve(inputs)

    def _task(self) -> Task:
        module = import_module(f"radcalc.calculators.{self.command.replace('-', '_')}")
        if hasattr(module, "task"):
            return module.task(self.words, lambda name: False)
        work_out = getattr(module, self.command.replace("-", "_"))
        return Task(self.command, partial(work_out, *self.words))


@cache
def calls() -> list[Call]:
    """Return the examples of single values that have several results."""
    found = []
    for command in SUMMARIES:
        if command in WITHOUT:
            continue
        page = page_of(command)
        for example in (*page.examples, *EXAMPLES.get(command, ())):
            words = words_of(example)[0]
            pairs = [word.split("=", 1) for word in words if "=" in word]
            texts = {
                name: text if name in page.intervals else text.split(",")[0].split(":")[0]
                for name, text in pairs
                if name in SYMBOLS
            }
            call = Call(command, tuple(word for word in words if "=" not in word), texts)
            if _is_usable(call):
                found.append(call)
    return found


def _is_usable(call: Call) -> bool:
    try:
        return len(call.answer().values) > 1
    except RadcalcError:
        return False


def varied(call: Call, rng: random.Random) -> Call:
    """Return a call with other numbers of many digits."""

    def other(match: re.Match[str]) -> str:
        return f"{float(match[0]) * rng.uniform(0.7, 1.4):.9f}"

    fixed = ("nd", "luminaires")
    texts = {
        name: NUMBER.sub(other, text) if SYMBOLS[name].form == QUANTITY and name not in fixed
        else text
        for name, text in call.texts.items()
    }  # fmt: skip
    return call._replace(texts=texts)


def sizes(call: Call, answer: Answer) -> dict[str, tuple[float, str]]:
    """Return numbers and units of the results that the call takes as options."""
    takes = {name for names in page_of(call.command).symbols.values() for name in names}
    if call.command == "solid-angle":
        takes &= {*SHAPES[call.words[0]].takes}
    if call.command == "direction" and call.words:
        return {}
    if call.texts.get("distribution", "").startswith("300"):  # it has no width
        takes -= {"beam-angle", "field-angle"}
    found = {}
    for row in answer.values:
        if row.is_absent or row.name not in takes or SYMBOLS[row.name].form != QUANTITY:
            continue
        if row.name == "luminaires" and row.amount % 1:  # whole numbers only
            continue
        unit = row.units[0] if row.units[0] != "1" else ""
        found[row.name] = (row.amount / float(resolve(unit).factor if unit else 1), unit)
    return found


def write(number: float, digits: int) -> str:
    """Return a number with that many significant digits."""
    mantissa, e, exponent = f"{number:#.{digits}g}".partition("e")
    return mantissa.rstrip(".") + e + exponent


def _surplus(call: Call, found: dict[str, tuple[float, str]]) -> list[str]:
    given = {SYMBOLS[name].generic or name for name in call.texts}
    return [name for name in found if name not in given]


def _mixed(call: Call, texts: dict[str, str], rng: random.Random) -> Call:
    items = [*{**call.texts, **texts}.items()]
    rng.shuffle(items)
    return call._replace(texts=dict(items))


def rounded(call: Call, rng: random.Random) -> Call | None:
    """Return the call with 2 to 5 digits, and with one to three of its results as inputs."""
    answer = call.answer()
    found = sizes(call, answer)
    surplus = _surplus(call, found)
    if answer.more or not surplus:
        return None
    names = rng.sample(surplus, min(len(surplus), rng.randint(1, 3)))
    texts = {
        name: write(found[name][0], rng.randint(2, 5)) + found[name][1]
        for name in (*call.texts, *names)
        if name in found
    }
    return _mixed(call, texts, rng)


def off(call: Call, rng: random.Random) -> list[Call]:
    """Return the call with a result as input, off by ten times its rounding and by a fifth."""
    answer = call.answer()
    found = sizes(call, answer)
    surplus = [name for name in _surplus(call, found) if found[name][0]]
    if answer.more or not surplus or call.command == "ev":  # its marks are 0.1 stops wide
        return []
    name = rng.choice(surplus)
    number, unit = found[name]
    text = write(number, rng.randint(3, 5))
    shift = rng.choice((-1, 1)) * 10.1 * rounding(text)
    digits = len(text.partition("e")[0].replace(".", "").lstrip("-0"))
    if rounding(write(float(text) * (1 + shift), digits)) > 2 * rounding(text):  # 0.9995 to 1.000
        return []
    return [
        _mixed(call, {name: write(float(text) * (1 + by), digits) + unit}, rng)
        for by in (shift, -0.2, 0.2)
    ]


def sweep(count: int, seed: int) -> str:
    rng = random.Random(seed)
    answered = compared = refused = 0
    while answered + refused + compared < count:
        call = varied(rng.choice(calls()), rng)
        if not _is_usable(call):  # a random number is past a limit
            continue
        if rng.random() < 2 / 3:
            if more := rounded(call, rng):
                try:
                    more.answer()
                except RadcalcError as error:
                    raise AssertionError(f"{more}: {error}") from error
                answered += 1
        elif calls_off := off(call, rng):
            near, *far = calls_off
            compared += 1
            if not any(map(_is_usable, far)):
                assert not _is_usable(near), near
                refused += 1
    return f"{answered} answered, {refused} of {compared} refused"


if __name__ == "__main__":
    main(sweep, LONG)
