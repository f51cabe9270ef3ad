"""Edits of the laws along a derivation: a power dropped, doubled or turned round, another pi."""

import math
from collections.abc import Iterator

from radcalc.derivation import fill, letter_of
from radcalc.homework.problem import Candidate, Problem
from radcalc.homework.usual import USUAL
from radcalc.laws.law import AnyLaw, Law
from radcalc.quantities.symbols import SYMBOLS

# What is never left out or turned round: the light itself, and what stands for a whole factor.
WHOLE = ("value", "q", "r", "p", "light", "heat")
LABELS = {
    "cosine": "cosine of the incidence",
    "cosine-of-source": "cosine of the tilt",
    "share": "fall from the axis",
    "na": "numerical aperture",
    "J": "factor between the densities",
}
# How easily a symbol is forgotten; others are rarely.
FORGOTTEN = {"cosine": 1, "cosine-of-source": 1, "reflectance": 2, "gain": 2, "absorptance": 2, "share": 1}
NOT_SQUARED = {"f-number": 1}
NO_FACTORS = ("exponent", "ev", "ev100", "iso", "adaptation", "part", "beam-part", "cosine")
RARELY, SELDOM = 3, 4
RULES = {  # of the factors of a conversion
    "solid-angle": "I = Phi / Omega",
    "projected-solid-angle": "E = L Omega_p",
    "area": "E = Phi / A, and I = L A",
    "time": "Q = Phi t",
    "bandwidth": "a band is the density times its width",
    "luminous-efficacy": "lumens are watts times the lumens per watt",
    "efficacy": "lumens are watts times the lumens per watt",
    "photon-energy": "photons are joules over the joules per photon",
    "photon-efficacy": "photons are joules times the photons per joule",
    "J": "E_nu = E_lambda lambda^2 / c",
}
NAMES = {"J": "jacobian", "luminous-efficacy": "efficacy", "photon-efficacy": "efficacy"}  # of a symbol in the name of its mistake


def find(p: Problem) -> Iterator[Candidate]:
    """Every edit of a law that leads to the result."""
    has_pi = False
    for law, target in p.chain.steps:
        if isinstance(law, Law):
            yield from _powers(p, law, target)
        else:
            yield from _numbers(p, law, target)
        number, power = _constant(law)
        has_pi |= bool(power)
        yield from _constants(p, law, target, number, power)
    if not has_pi and (p.light or p.asks("solid-angle", "etendue", "sphere-fraction")):
        rank, rule = SELDOM, "pi stands where directions of a diffuse surface are summed"
        for name, size in (("pi-forgotten", math.pi), ("wrong-sphere", 4 * math.pi)):
            for value in (p.right * size, p.right / size):
                yield Candidate(name, rank, value, USUAL[name][1], rule)


def text_of(law: AnyLaw) -> str:
    """The formula of a law in letters."""
    return fill(law.template, lambda name, _: letter_of(name) if name in SYMBOLS else name)


def _powers(p: Problem, law: Law, target: str) -> Iterator[Candidate]:
    """What follows with one of the powers of a monomial edited."""
    own = dict(law.powers).get(target, -1.0)
    start = p.chain.values[target]
    for name, power in law.powers:
        symbol = SYMBOLS.get(name)
        is_light = symbol is not None and symbol.geometry is not None
        if name == target or is_light or name in WHOLE:
            continue
        label = LABELS.get(name) or (symbol.label if symbol else name)
        called = NAMES.get(name, name.removesuffix("-of-source"))
        rule = text_of(law) or RULES.get(name, "")
        exponent = -power / own
        for kind, rank, done, by in _edits_of(name, label, power, exponent):
            for size, later in _sizes(p, name, kind):
                value = p.chain.after(target, start * size ** (exponent * by))
                if value is not None:
                    yield Candidate(f"{called}-{kind}", rank + later, value, done, rule)
    if target == law.result:
        return
    label = LABELS.get(target) or SYMBOLS[target].label
    turned: list[tuple[str, float, str, float]] = []
    if abs(own) == 2:
        done = f"the square root was not taken: the {label} was not squared"
        turned.append(("not-squared", NOT_SQUARED.get(target, 2), done, start**2))
    if target == p.chain.goal and not SYMBOLS[target].geometry and start:
        done = f"the fraction was turned round: the {label} came out upside down"
        turned.append(("upside-down", RARELY, done, 1 / start))
    for kind, rank, done, size in turned:
        value = p.chain.after(target, size)
        if value is not None:
            yield Candidate(f"{target}-{kind}", rank, value, done, text_of(law))


def _edits_of(
    name: str, label: str, power: float, exponent: float
) -> Iterator[tuple[str, float, str, float]]:
    """The edits of a symbol's power: kind, rank, what was done, and by how many times the power.

    `power` is that in the law as it is written, `exponent` that in the law as it was solved.
    """
    symbol = SYMBOLS.get(name)
    is_bare = symbol is not None and symbol.unit == "1"
    rank = FORGOTTEN.get(name, RARELY if is_bare or name in RULES else SELDOM)
    yield "forgotten", rank, f"the {label} was left out", -1.0
    done, undone = ("divided", "multiplied") if exponent > 0 else ("multiplied", "divided")
    yield "upside-down", RARELY, f"it was {done} by the {label}, not {undone}", -2.0
    if abs(power) == 2:
        rank = NOT_SQUARED.get(name, 2)
        yield "not-squared", rank, f"the {label} was not squared", -0.5
    if name.startswith("cosine"):
        for more in (1.0, 2.0):
            yield "squared", 5, f"the {label} was taken twice or three times", more


def _sizes(p: Problem, name: str, kind: str) -> Iterator[tuple[float, float]]:
    """The number that a symbol stands for: in SI units, and in the unit that it was given in."""
    size = p.chain.values.get(name, 0.0)
    if size > 0:
        yield size, 0.0
        typed = p.given[name].number if name in p.given else None
        if isinstance(typed, float) and (kind == "not-squared" or name == "bandwidth"):
            yield typed, 0.5


def _numbers(p: Problem, law: AnyLaw, target: str) -> Iterator[Candidate]:
    """What follows with a bare number of another law left out, or turned round."""
    for name in law.names:
        x = p.chain.values.get(name, 0.0)
        if name == target or SYMBOLS[name].unit != "1" or name in NO_FACTORS or x <= 0:
            continue
        label = LABELS.get(name) or SYMBOLS[name].label
        for kind, size, done, rank in (
            ("forgotten", 1.0, f"the {label} was left out", FORGOTTEN.get(name, RARELY)),
            ("upside-down", 1 / x, f"the {label} was used upside down", RARELY),
        ):
            at = {**p.chain.values, name: size}.__getitem__
            value = p.chain.edited(target, lambda _, at=at: law.solve(target, at))
            if value is not None:
                yield Candidate(f"{name}-{kind}", rank, value, done, text_of(law))


def _constant(law: AnyLaw) -> tuple[float, int]:
    """The number in front of a formula, and the power of pi in it."""
    right = law.template.partition(" = ")[2]
    number, pi, sign = 1.0, 0, 1
    for word in right.split():
        if word == "pi":
            pi += sign
        elif word == "/":
            sign = -1
            continue
        elif word.isdigit():
            number *= float(word) ** sign
        elif word != "Omega0":
            break
        sign = 1
    if "/ (pi " in right:
        pi -= 1
    if "/ (4 " in right:
        number /= 4
    return number, pi


FAMILY = {"pi": math.pi, "2 pi": 2 * math.pi, "4 pi": 4 * math.pi}


def _constants(
    p: Problem, law: AnyLaw, target: str, number: float, power: int
) -> Iterator[Candidate]:
    """What follows with another constant of its family."""
    left = law.names[0]

    def edit(name: str, ratio: float, rank: float = 0.0) -> Iterator[Candidate]:
        usual, done, right = USUAL[name]
        if target == left:
            value = p.chain.after(target, p.chain.values[target] * ratio)
        else:
            def at(symbol: str) -> float:
                return p.chain.values[symbol] / (ratio if symbol == left else 1.0)

            value = p.chain.edited(target, lambda _: law.solve(target, at))
        if value is not None:
            yield Candidate(name, rank or usual, value, done, right or text_of(law))

    if law.name in ("diameter", "apex angle", "diameter of the receiver"):
        return  # which are half for full
    if power:
        own = math.pi * (number if number > 1 else 1.0)
        for size in FAMILY.values():
            if abs(size - own) > 1e-9 and number >= 1:
                is_double = own == math.pi and size == 2 * math.pi
                name = "two-pi-for-pi" if is_double else "wrong-sphere"
                yield from edit(name, (size / own) ** power)
        whole = number * math.pi
        yield from edit("pi-forgotten" if number <= 1 else "wrong-sphere", (1 / math.pi) ** power)
        if number != 1:
            yield from edit("wrong-sphere" if number > 1 else "constant-forgotten", (1 / whole) ** power)
        if number < 1:
            yield from edit("constant-forgotten", 1 / number)
        if number == 1:
            yield from edit("pi-upside-down", (1 / math.pi**2) ** power)
    elif number != 1:
        yield from edit("constant-forgotten", 1 / number)
    if "c / " in law.template or law.name == "wavenumber":
        for ratio in (2 * math.pi, 0.5 / math.pi):
            yield from edit("angular-for-cycles", ratio)
