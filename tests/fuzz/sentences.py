"""Sentences in random words: the value of a formula, the value of their command, or a refusal.

A third of the sentences state a problem whose value this module knows, in a random order
and with random fillers, words that change it, phrases too many and too few.  The others are
phrases and names of the vocabulary in random order, and the same with letters changed.
"""

import contextlib
import io
import json
import math
import random
import re
import shlex
import warnings
from collections import Counter
from collections.abc import Callable
from functools import cache
from typing import Any, NamedTuple

from conftest import run

import radcalc
from radcalc.calculators import COMMANDS
from radcalc.errors import RadcalcError
from radcalc.quantities.search import comparable
from radcalc.quantities.symbols import FLAG, SYMBOLS
from radcalc.sentences import names
from radcalc.sentences.phrases import FILLERS, MARKS, PHRASES
from radcalc.units.table import unit_of

SHORT, LONG = 120, 100_000
PREFIX = "read as: radcalc "
NAMES_WITH_NUMBERS = ("угол излучения по уровню 10",)
NUMBER = re.compile(r"(?<![\w.])\d+(?:\.\d+)?")

# --- problems with a known value

# V(lambda) of CIE 018:2019, table 6, from colour-science; K_m of the same, 4.1.
EYE = {450: 0.038, 500: 0.323, 532: 0.8849624, 555: 1.0, 633: 0.2353344, 650: 0.107}
KM = 683 / 0.999997
HC, EV = 6.62607015e-34 * 299792458, 1.602176634e-19  # SI brochure, 9th edition, 2.2
UNITS: dict[str, dict[str, float]] = {  # units in the coherent unit; 1 fc = 1 lm/ft2
    "lx": {"lx": 1, "lux": 1, "fc": 0.3048**-2, "footcandles": 0.3048**-2, "klx": 1000, "лк": 1},
    "cd": {"cd": 1, "candela": 1, "kcd": 1000, "mcd": 1e-3, "кд": 1},
    "lm": {"lm": 1, "lumens": 1, "klm": 1000, "лм": 1},
    "nit": {"cd/m2": 1, "nits": 1},
    "m": {"m": 1, "cm": 0.01, "ft": 0.3048, "metres": 1, "м": 1},
    "m2": {"m2": 1, "cm2": 1e-4, "ft2": 0.3048**2, "square metres": 1},
    "deg": {"deg": math.pi / 180, "degrees": math.pi / 180, "rad": 1, "°": math.pi / 180},
    "sr": {"sr": 1, "steradians": 1},
    "s": {"seconds": 1, "min": 60, "h": 3600, "hours": 3600, "minutes": 60},
    "lx s": {"lx.s": 1, "lx.h": 3600, "lux-hours": 3600},
    "lm s": {"lm.s": 1, "lm.h": 3600},
    "W": {"W": 1, "mW": 1e-3},
    "W/m2": {"W/m2": 1, "mW/cm2": 10},
    "J/m2": {"J/m2": 1, "kJ/m2": 1000, "mJ/cm2": 10},
    "eV": {"eV": EV, "J": 1},
    "Hz": {"THz": 1e12},
    "rho": {"": 1, "%": 0.01},
}
PLACES = {  # texts of a phrase, with {} for the amount
    "distance": ("at {}", "{} away", "from {}", "at a distance of {}", "distance {}", "na {}",
                 "ve vzdálenosti {}", "на расстоянии {}", "vzdálenost {}", "d={}", "{}"),
    "incidence": ("{} incidence", "at {} incidence", "angle of incidence {}", "incidence {}",
                  "at an angle of {}", "pod úhlem {}", "под углом {}"),
    "area": ("over {}", "on {}", "area {}", "plocha {}", "{}", "spread over {}"),
    "solid-angle": ("into {}", "over {}", "solid angle {}"),
    "lobe": ("{} lobe", "{} fwhm", "beam angle fwhm {}"),
    "full": ("{} full cone", "{} full angle", "full angle {}"),
    "half": ("{} half angle", "half angle {}", "{} half cone"),
    "time": ("for {}", "during {}", "{}", "time {}"),
    "wavelength": ("at {}", "{}", "{} laser", "wavelength {}", "λ {}", "of {} light"),
    "reflectance": ("reflectance {}", "{} reflectance", "albedo {}", "reflectance of {}"),
    "amount": ("{}",),
    "ambiguous": ("{} beam", "beam {}", "{} beam angle", "beam angle {}", "cone {}", "{} cone"),
}  # fmt: skip
# Words that change the meaning of an amount, or its number.
CHANGES = str.split("""
    half double twice two dozen each every both pair peak maximum minimum maximal total effective
    times squared minus not without except incident reflected transmitted diffuse
    global direct third percent kilo about-twice poloviční dva dvě dvojnásobný bez střední
    průměrný přímý odražený два две половина без средний прямой отражённый ×2 x2 2× 5% ½
""")


class Part(NamedTuple):
    """An amount of a problem: the place that it fills, its unit and its value in that."""

    place: str
    kind: str
    value: float | None = None


class Problem(NamedTuple):
    """A problem: its parts, with what their values give, and the units of its result."""

    parts: tuple[Part, ...]
    result: str
    value: Callable[..., float]
    words: tuple[str, ...] = ()  # phrases without an amount
    names: tuple[str, ...] = ()  # of the result
    alone: bool = False  # without other directions; the answer says that it assumes isotropic light


def _lobe(full: float) -> float:
    """Return the solid angle of a lobe cos^m, of half its intensity at half of `full`."""
    return 2 * math.pi / (math.log(0.5) / math.log(math.cos(full / 2)) + 1)


def _cone(half: float) -> float:
    return 2 * math.pi * (1 - math.cos(half))


def _full(full: float) -> float:
    return _cone(full / 2)


def _lit(solid_angle: Callable[[float], float], is_tilted: bool) -> Callable[..., float]:
    """Return the illuminance from a flux into a solid angle."""
    if is_tilted:
        return lambda f, a, d, t: f / solid_angle(a) / d**2 * math.cos(t)
    return lambda f, a, d: f / solid_angle(a) / d**2


def _from_lit(solid_angle: Callable[[float], float], is_tilted: bool) -> Callable[..., float]:
    """Return the flux into a solid angle from an illuminance."""
    if is_tilted:
        return lambda e, d, a, t: e * d**2 * solid_angle(a) / math.cos(t)
    return lambda e, d, a: e * d**2 * solid_angle(a)


def _received(illuminance: float, area: float, intensity: float) -> float:
    """Return the flux on a disc along whose axis a point source lies."""
    distance = math.sqrt(intensity / illuminance)
    return intensity * _cone(math.atan2(math.sqrt(area / math.pi), distance))


D, E, CD, F = (
    Part("distance", "m"), Part("amount", "lx"), Part("amount", "cd"), Part("amount", "lm"),
)  # fmt: skip
A, T, RHO = Part("area", "m2"), Part("time", "s"), Part("reflectance", "rho")
TILT, OMEGA = Part("incidence", "deg"), Part("solid-angle", "sr")
LOBE, FULL, HALF = Part("lobe", "deg"), Part("full", "deg"), Part("half", "deg")
INTENSITY = ("intensity", "luminous intensity", "svítivost", "сила света")
ISOTROPIC = ("isotropic", "in all directions", "izotropní")
HEMISPHERE = ("into a hemisphere", "over a hemisphere")
QUESTIONS = (("how far",), ("how long",))
PROBLEMS = (
    Problem((CD, D), "lx", lambda i, d: i / d**2, (), ("illuminance", "osvětlení")),
    Problem((CD, D, TILT), "lx", lambda i, d, t: i * math.cos(t) / d**2),
    Problem((E, D), "cd", lambda e, d: e * d**2, (), INTENSITY),
    Problem((E, D, TILT), "cd", lambda e, d, t: e * d**2 / math.cos(t), (), INTENSITY),
    Problem((CD, E), "m", lambda i, e: math.sqrt(i / e), ("how far",)),
    Problem((CD, E, TILT), "m", lambda i, e, t: math.sqrt(i * math.cos(t) / e), ("how far",)),
    Problem((F,), "cd", lambda f: f / 4 / math.pi, ISOTROPIC, INTENSITY),
    Problem((F,), "cd", lambda f: f / 2 / math.pi, HEMISPHERE),
    Problem((F, D), "lx", lambda f, d: f / 4 / math.pi / d**2, ISOTROPIC),
    Problem((F, D), "lx", lambda f, d: f / 4 / math.pi / d**2, alone=True),
    Problem((F, D, TILT), "lx", lambda f, d, t: f * math.cos(t) / 4 / math.pi / d**2, ISOTROPIC),
    Problem((F, D, TILT), "lx", lambda f, d, t: f / 4 / math.pi / d**2 * math.cos(t), alone=True),
    Problem((E, D), "lm", lambda e, d: e * 4 * math.pi * d**2, alone=True),
    Problem((E, D, TILT), "lm", lambda e, d, t: e * 4 * math.pi * d**2 / math.cos(t), alone=True),
    Problem((F, D), "lx", lambda f, d: f / 2 / math.pi / d**2, HEMISPHERE),
    Problem((F, D, TILT), "lx", lambda f, d, t: f * math.cos(t) / 2 / math.pi / d**2, HEMISPHERE),
    Problem((CD, D), "lm", lambda i, d: 4 * math.pi * i, alone=True),
    Problem((CD, E), "lm", lambda i, e: 4 * math.pi * i, alone=True),
    Problem((F, OMEGA), "cd", lambda f, w: f / w, (), INTENSITY),
    *[
        Problem((F, shape, D, *tilt), "lx", _lit(solid_angle, bool(tilt)))
        for shape, solid_angle in ((OMEGA, float), (LOBE, _lobe), (FULL, _full), (HALF, _cone))
        for tilt in ((), (TILT,))
    ],
    *[
        Problem((E, D, shape, *tilt), "lm", _from_lit(solid_angle, bool(tilt)))
        for shape, solid_angle in ((OMEGA, float), (LOBE, _lobe), (FULL, _full), (HALF, _cone))
        for tilt in ((), (TILT,))
    ],
    Problem((CD, OMEGA), "lm", lambda i, w: i * w),
    Problem((F, LOBE), "cd", lambda f, b: f / _lobe(b), (), INTENSITY),
    Problem((F, FULL), "cd", lambda f, a: f / _full(a), (), INTENSITY),
    Problem((F, HALF), "cd", lambda f, a: f / _cone(a), (), INTENSITY),
    Problem((CD, FULL), "lm", lambda i, a: i * _full(a)),
    Problem((CD, LOBE), "lm", lambda i, b: i * _lobe(b)),
    Problem((CD, HALF), "lm", lambda i, a: i * _cone(a)),
    Problem((F, A), "lx", lambda f, a: f / a, (), ("illuminance", "osvětlení", "освещённость")),
    Problem((E, A), "lm", lambda e, a: e * a, (), ("luminous flux", "světelný tok")),
    Problem((CD, D, A), "lm", lambda i, d, a: i / d**2 * a),
    Problem((E, A, CD), "lm", _received),
    Problem((E, RHO), "nit", lambda e, r: e * r / math.pi, (), ("luminance", "jas", "яркость")),
    Problem((Part("amount", "nit"), RHO), "lx", lambda b, r: b * math.pi / r),
    Problem((F, A, RHO), "nit", lambda f, a, r: f / a * r / math.pi),
    Problem((E, T), "lx s", lambda e, t: e * t),
    Problem((F, T), "lm s", lambda f, t: f * t),
    Problem((Part("amount", "J/m2"), Part("amount", "W/m2")), "s", lambda h, e: h / e,
            ("how long",)),
    Problem((Part("amount", "W"), Part("wavelength", "nm")), "lm", lambda p, v: p * KM * EYE[v]),
    Problem((F, Part("wavelength", "nm")), "W", lambda f, v: f / KM / EYE[v]),
    Problem((Part("amount", "nm"),), "eV", lambda v: HC / v * 1e9),
    Problem((Part("amount", "nm"),), "Hz", lambda v: 299792458 / v * 1e9),
)  # fmt: skip


class Case(NamedTuple):
    """A sentence and its possible values, in a unit; [] for one that no formula here answers."""

    text: str
    values: list[float]
    unit: str


def amount(draw: random.Random, part: Part) -> tuple[str, float]:
    """Return the text of an amount, and its value in the coherent unit."""
    if part.kind == "nm":
        wavelength = draw.choice(list(EYE))
        return f"{wavelength}{draw.choice(('nm', ' nm', ' nanometres'))}", wavelength
    unit, factor = draw.choice(list(UNITS[part.kind].items()))
    number = float(f"{10 ** draw.uniform(0, 3):.3g}")
    if part.kind == "deg":
        number = draw.randint(2, 80) if factor != 1 else draw.randint(1, 13) / 10
    elif part.kind == "rho":
        number = draw.randint(1, 99) * (0.01 if factor == 1 else 1)
    elif part.kind == "sr":
        number = draw.randint(1, 12) / 10
    elif part.kind == "m":
        number = draw.randint(1, 900) / 10
    text = f"{number:.10g}"
    blank = draw.choice(("", " ")) if unit.isascii() and unit.isalpha() else " "
    return f"{text}{'' if unit in ('%', '') else blank}{unit}", float(text) * factor


def placed(draw: random.Random, part: Part, text: str) -> str:
    """Return the phrase of an amount in its place."""
    return draw.choice(PLACES[part.place]).format(text)


def values_of(given: list[tuple[Part, float]], words: tuple[str, ...], result: str) -> list[float]:
    """Return the results of amounts by the formulas of most of them; [] without a reading."""
    values = dict(given)
    has_shape = words == HEMISPHERE or bool({OMEGA, LOBE, FULL, HALF} & {*values})
    if len(values) < len(given) or any(part.place == "ambiguous" for part in values):
        return []
    found: dict[int, list[float]] = {}
    for problem in PROBLEMS:
        is_meant = problem.words in ((), words, *QUESTIONS) and not (problem.alone and has_shape)
        if problem.result == result and is_meant and {*problem.parts} <= {*values}:
            value = problem.value(*[values[part] for part in problem.parts])
            found.setdefault(len(problem.parts) + bool(problem.words), []).append(value)
    best = found[max(found)] if found else []
    return best if best and max(best) < 1.2 * min(best) else []  # as their digits may agree


def target_of(draw: random.Random, problem: Problem) -> tuple[str, str, float]:
    """Return the phrase of a target, its unit, and that in the coherent unit."""
    unit, factor = draw.choice(list(UNITS[problem.result].items()))
    if problem.words in QUESTIONS and draw.random() < 0.5:
        return problem.words[0], problem.result, 1
    if problem.names and draw.random() < 0.2:
        return f"{draw.choice(problem.names)} in {unit}", unit, factor
    mark = draw.choice(("to ", "in ", "", "to ", "as ", "-> "))
    return f"{mark}{unit}", unit, factor


# Words that mean something alone, as a globe, and add nothing beside another word.
PHRASES_OF_A_WORD = {
    comparable(word) for p in PHRASES if " " not in p.pattern for word in p.pattern.split("|")
}


def shuffled(draw: random.Random, phrases: list[str]) -> str:
    """Return phrases in a random order, with a few fillers between them."""
    phrases = [phrase for phrase in phrases if phrase]
    draw.shuffle(phrases)
    at = draw.randint(0, len(phrases))
    if draw.random() < 0.3 and not (at and phrases[at - 1].isdigit()):  # 15 s is an amount
        phrases.insert(at, draw.choice(sorted(FILLERS - MARKS - PHRASES_OF_A_WORD)))
    return " ".join(phrases)


def known(draw: random.Random) -> Case:
    """Make a sentence with its value, or one that has several readings or none."""
    problem = draw.choice(PROBLEMS)
    parts, words = [*problem.parts], problem.words
    target, unit, factor = target_of(draw, problem)
    how = draw.random()
    if how < 0.15:  # a part is missing
        del parts[draw.randrange(len(parts))]
    elif how < 0.2:
        words = ()
    elif how < 0.25:  # a place is filled twice
        parts.append(draw.choice(parts))
    elif how < 0.35 and A not in parts:  # an amount of another problem
        parts.append(draw.choice([part for part in draw.choice(PROBLEMS).parts if part != A]))
    elif how < 0.4 and not {LOBE, FULL, HALF} & {*parts}:
        parts.append(Part("ambiguous", "deg"))
    amounts = [amount(draw, part) for part in parts]
    given = [(part, number) for part, (_, number) in zip(parts, amounts, strict=True)]
    phrases = [
        draw.choice(PLACES[p.place]).format(text)
        for p, (text, _) in zip(parts, amounts, strict=True)
    ]
    if words and words[0] not in target and problem.words not in QUESTIONS:
        phrases.append(draw.choice(words))
    values = [value / factor for value in values_of(given, words, problem.result)]
    if 0.4 < how < 0.45:
        phrases.append(f"{draw.randint(2, 99)}")
        values = []
    text = shuffled(draw, [*phrases, target])
    if how > 0.9:  # a word that changes an amount
        typed = text.split()
        typed.insert(draw.randint(0, len(typed)), draw.choice(CHANGES))
        text, values = " ".join(typed), []
    return Case(text, values, unit)


# --- random phrases

EXAMPLES = {
    "{length}": ("2 m", "30 cm", "65 in", "6ft"), "{angle}": ("30 deg", "0.2 rad", "24°"),
    "{area}": ("3 m2", "2 m x 4 m", "15 x 20 ft"), "{time}": ("12 h", "1/60 s", "10 min"),
    "{number}": ("0.5", "8", "400"), "{power}": ("60 W", "5mW"), "{temperature}": ("2700 K",),
    "{solid-angle}": ("0.5 sr", "2 sr"), "{wavelength}": ("555 nm", "0.5 um", "540 THz"),
}  # fmt: skip
MORE = str.split("""
    lx fc cd lm W/m2 nits ppfd dli umol/m2/s eV nm cm-1 W lm/W J K h d s m A C in sr deg % mol/m2/d
    D65 A sunlight sun HPS LED-B3 white-led candle blackbody:3000K 16:9 2.39:1 lamp.ies EV9 f/5.6
    1/250 ISO 400 T4 100lx 2m 5 pi 4pi ± 3±1 10cd/m2 to in as -> = 500,5 1,000 1e3 20% 60W 2700K
    daylight mean peak direct incident isotropic white and per x × * / + - ( ) [ ] ^ 2x3m 5mx4m
    square metre metres inch feet foot candle lambert hour hours day kWh J/m2 photon mol lx.h
""")
CHARACTERS = "abcdehmnsxABCKW0123456789.,-+*/^()[]{}=:;!?%'\"±°µΩλ²⁻½жшůé\u200b\u202e\ue000\t😀"
OUTPUT = (["-q"], ["-n"], ["--json"], ["--precision", "4"], ["--steps"], ["--csv"])


@cache
def symbol_names() -> list[str]:
    return sorted(names())


def phrase(draw: random.Random) -> str:
    """Return a phrase of the table, a name with or without an amount, an amount or a target."""
    how = draw.random()
    if how < 0.45:
        words = []
        for part in draw.choice(PHRASES).pattern.split():
            if part in EXAMPLES:
                words.append(draw.choice(EXAMPLES[part]))
            elif part[-1] != "?" or draw.random() < 0.5:
                words.append(draw.choice(part.rstrip("?").split("|")))
        return " ".join(words)
    if how < 0.6:
        name = draw.choice(symbol_names())
        symbol = SYMBOLS[names()[name][0]]
        example = "" if symbol.form == FLAG else symbol.example
        return draw.choice((name, f"{name} {example}", f"{example} {name}"))
    if how < 0.85:
        text, _ = amount(draw, draw.choice(draw.choice(PROBLEMS).parts))
        return text
    return draw.choice(MORE)


def grammatical(draw: random.Random) -> str:
    """Return phrases in a random order: any, or those of a problem and one more."""
    if draw.random() < 0.3:
        return shuffled(draw, [phrase(draw) for _ in range(draw.randint(2, 5))])
    problem = draw.choice(PROBLEMS)
    parts = [*problem.parts]
    if draw.random() < 0.5:
        del parts[draw.randrange(len(parts))]
    phrases = [placed(draw, part, amount(draw, part)[0]) for part in parts]
    target = target_of(draw, problem)[0] if draw.random() < 0.8 else ""
    return shuffled(draw, [*phrases, target, phrase(draw)])


def mutated(draw: random.Random, text: str) -> str:
    """Return a sentence with words and letters changed."""
    for _ in range(draw.randint(1, 3)):
        words = text.split() or ["lx"]
        at = draw.randrange(len(words))
        how = draw.randrange(9)
        if how == 0:
            del words[at]
        elif how == 1:
            words.insert(at, words[at])
        elif how == 2:
            other = draw.randrange(len(words))
            words[at], words[other] = words[other], words[at]
        elif how == 3:
            words.insert(at, draw.choice(MORE))
        elif how == 4:
            words[at] += draw.choice((",", ";", "?", "!", ".", ":", ")", "=", "'"))
        elif how == 5:
            words[at] = f"({words[at]})" if draw.random() < 0.9 else "(" * 50 + words[at]
        elif how == 6 and draw.random() < 0.02:
            words *= draw.randint(5, 60)
        elif how == 7:
            words[at] = re.sub("[^0-9.]+$", "", words[at]) or words[at]
        else:
            word = words[at]
            place = draw.randrange(len(word))
            end = draw.choice((place, place + 1))
            words[at] = word[:place] + draw.choice(CHARACTERS) + word[end:]
        text = " ".join(words)
    return text


# --- properties


class Answer(NamedTuple):
    """An answered sentence: its output, and the words of its command if it was read."""

    output: str
    command: list[str]


def answer(text: str, options: list[str], seen: Counter[str]) -> Answer | None:
    """Return the answer of a sentence; None if it is refused, with a message and without output."""
    words = [*text.split(), *options]
    if not words or words[0] in ("prompt", "-i") or "-" in words:
        return None
    done = run(*words)
    assert done.returncode in (0, 1, 2), (words, done.stderr)
    assert done.returncode != 1 or words[0] in COMMANDS, words
    if done.returncode:
        seen["refused"] += 1
        assert "radcalc: " in done.stderr or "Usage" in done.stderr, (words, done.stderr)
        assert done.stdout == "" or "--json" in words or words[0] in COMMANDS, (words, done.stdout)
        return None
    lines = [line for line in done.stderr.splitlines() if line.startswith(PREFIX)]
    command = shlex.split(lines[0].removeprefix("read as: radcalc ")) if lines else []
    seen["answered as sentences" if command else "answered otherwise"] += 1
    return Answer(done.stdout, command)


def check_command(text: str, found: Answer) -> None:
    """Check that the command of a sentence gives its value, and has all its numbers and units."""
    done = run(*found.command)
    assert done.returncode == 0, (text, found.command, done.stderr)
    first = found.output.split("\t")[0].strip()
    assert first in done.stdout.split() or found.output == done.stdout, (text, found, done.stdout)
    has = " ".join(found.command)
    plain = text
    for name in NAMES_WITH_NUMBERS:
        plain = plain.replace(name, "")
    typed = Counter(NUMBER.findall(plain)) - Counter(re.findall(r"\d+(?:\.\d+)?", has))
    assert not typed, (text, found.command, "without", typed)
    for number, unit in re.findall(r"(?<![\w.])(\d[\d.]*) ?([^\W\d_]+)", text):
        if unit_of(unit) and unit not in (FILLERS | MARKS):
            is_there = re.search(rf"{re.escape(number)}[\s.]?{re.escape(unit)}", has)
            assert is_there or unit in re.split("[ :]", has), (text, has)  # or it is the target


def check_python(text: str, found: Answer) -> None:
    """Check that `radcalc.ask` gives the same number.

    Two units, as `THz GHz`, are a conversion of 1 at a shell only, as in GNU units.
    """
    if len(text.split()) < 4 and found.command[:2] == ["convert", "1"]:
        return
    try:
        asked: Any = radcalc.ask(text)
    except RadcalcError as error:
        raise AssertionError((text, found, str(error))) from None
    number, _, _ = found.output.partition("\t")
    if found.output.count("\n") == 1 and hasattr(asked, "magnitude") and "±" not in number:
        right = math.isclose(float(number), float(asked.magnitude), rel_tol=1e-9)
        assert right, (text, found, asked)


def check_formats(text: str, found: Answer) -> None:
    """Check that -q, -n and --json give the same number."""
    number, _, unit = found.output.rstrip("\n").partition("\t")
    if found.output.count("\n") != 1 or not unit or "±" in number:
        return
    words = text.split()
    assert run(*words, "-q").stdout == found.output, text
    assert run(*words, "-q").stderr == "", text
    assert run(*words, "-n").stdout == f"{number}\n", text
    answer = json.loads(run(*words, "--json").stdout)
    shown = [one["value"] for one in answer.get("results", {"": answer}).values()]
    assert any(math.isclose(value, float(number), rel_tol=1e-9) for value in shown), (text, shown)


def check_known(case: Case, found: Answer | None, seen: Counter[str]) -> None:
    """Check that a sentence is answered with the value of its formula, or not at all."""
    if found is None:
        seen["known, refused" if case.values else "rightly refused"] += 1
        return
    rows = [line.split("\t") for line in found.output.splitlines()]
    if len(rows) > 1 and f" {case.unit} " not in f" {case.text} ":  # no target, and a sheet
        return
    number, unit = rows[0] if len(rows[0]) == 2 else (rows[0][0], "")
    assert found.output.count("\n") == 1, (case, found)
    value = float(number)
    assert any(math.isclose(value, one, rel_tol=1e-6) for one in case.values), (case, found)
    assert unit in ("m", "s", "") or unit == case.unit, (case, found)
    seen["known, right"] += 1


def check(draw: random.Random, kind: int, seen: Counter[str]) -> None:
    """Make and check one sentence."""
    case = known(draw) if kind == 0 else None
    text = case.text if case else grammatical(draw)
    if kind == 2:
        text = mutated(draw, text if draw.random() < 0.3 else known(draw).text)
    options = draw.choice(OUTPUT) if kind and draw.random() < 0.1 else []
    found = answer(text, options, seen)
    if found and found.command[:2] == ["convert", "-"]:  # `to fc` with piped input
        return
    if case:
        check_known(case, found, seen)
    is_plain = not options and not re.search(r"(^| )-", text)
    if found and found.command and is_plain:
        check_command(text, found)
        check_python(text, found)
        if draw.random() < 0.1:
            check_formats(text, found)
    elif not found and draw.random() < 0.1:  # no other error
        with contextlib.suppress(RadcalcError):
            radcalc.ask(text)


def sweep(count: int, seed: int) -> str:
    """Check random sentences of the three kinds."""
    draw = random.Random(seed)
    seen: Counter[str] = Counter()
    with warnings.catch_warnings(), contextlib.redirect_stderr(io.StringIO()):
        warnings.simplefilter("error")
        for k in range(count):
            check(draw, k % 3, seen)
    return ", ".join([f"{n} {what}" for what, n in sorted(seen.items())])


if __name__ == "__main__":
    from fuzz.command import main

    main(sweep, LONG)
