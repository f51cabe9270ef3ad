"""Mistakes in the laws of a derivation: powers forgotten, doubled or inverted, wrong constants."""

import math
import re
from collections.abc import Iterator
from typing import Any, NamedTuple

from radcalc.answer import fill, letter_of
from radcalc.homework.chain import Worked
from radcalc.homework.question import BOTH, PI_FORGOTTEN, Candidate, Problem, usual
from radcalc.homework.wording import Translatable
from radcalc.laws import AnyLaw, At, Law
from radcalc.laws.optics import PEAK
from radcalc.quantities.symbols import SYMBOLS
from radcalc.units.dimensions import FREQUENCY
from radcalc.units.table import resolve

# Symbols that are never forgotten or inverted: the light, products of several factors, and
# numbers that are not factors.
SKIES = ("horizontal-sky", "plane-sky")
WHOLE = ("value", "q", "r", "p", "exposure-setting", "heat", "weighted-solid-angle", *SKIES)
NO_FACTORS = (
    *("exponent", "ev", "ev100", "iso", "adaptation", "part", "beam-part", "upward-part"),
    *("cosine", "magnification"),
)
LABELS = {
    "cosine": "cosine of the incidence",
    "cosine-of-source": "cosine of the tilt",
    "relative-intensity": "relative intensity off the axis",
    "J": "factor between the densities",
}
NAMES = {  # symbols as the names of mistakes have them
    "cosine-of-source": "cosine",
    "J": "jacobian",
    "luminous-efficacy": "efficacy",
    "photon-efficacy": "efficacy",
    "lux-per-ppfd": "efficacy",
}
# Ranks of forgotten symbols; a number without a unit is more easily forgotten than a length or a
# time.
FORGOTTEN = {
    "cosine": 1,
    "cosine-of-source": 1,
    "relative-intensity": 1,
    "reflectance": 2,
    "gain": 2,
    "absorptance": 2,
    "projected-solid-angle": 4,
}
NOT_SQUARED = {"f-number": 1}
USUALLY, RARELY, SELDOM, HARDLY = 2, 3, 4, 5
RULES = {  # right rules, by factors of a conversion
    "solid-angle": "I = Phi / Omega",
    "projected-solid-angle": "E = L Omega_p",
    "area": "E = Phi / A, and I = L A",
    "cosine": "E = E_0 cos(theta)",
    "cosine-of-source": "I = L A cos(theta_s)",
    "time": "Q = Phi t",
    "responsivity": "I = s Phi",
    "bandwidth": "a band is the density times its width",
    "luminous-efficacy": "lumens are watts times the lumens per watt",
    "photon-energy": "photons are joules divided by the joules per photon",
    "photon-efficacy": "photons are joules times the photons per joule",
    "lux-per-ppfd": "lumens are photons per second times the lumen seconds per photon",
    "J": "E_nu = E_lambda lambda^2 / c",
}
WHY = {
    "cosine": "a tilted surface receives less light",
    "cosine-of-source": "a tilted surface has less intensity",
    "distance": "light spreads over the square of the distance",
    "reflectance": "a surface reflects the part rho of the light",
    "gain": "a perfect diffuser has a gain of 1",
    "relative-intensity": "the intensity decreases off the axis",
}
IN_ITS_UNIT = ("bandwidth", "efficacy")  # often used in the unit typed, not in SI units
IN_ELECTRONVOLTS = {"photon-energy": -1, "photon-efficacy": 1}  # and the power of the unit
EV = resolve("eV").factor
RATIOS = ("responsivity", "quantum-efficiency", "luminous-efficacy", "photon-efficacy", "sp-ratio")
ROOTS = {
    2: "the square root was used for the {0}, not the fourth root",
    3: "the cube root was used for the {0}, not the fourth root",
}
DIVIDED = "it was divided by the {0}, not multiplied"
INVERTED = "the fraction was inverted: the result is the reciprocal of the {0}"
MULTIPLIED = "it was multiplied by the {0}, not divided"
WIEN_X = 4.965114231744276  # h c / (k b): the solution of x = 5 (1 - exp(-x))
PER_FREQUENCY = 1.759780  # c / (b' b^-1), for the peak per frequency at 2.821439 k T / h
CYCLES = ("frequency", "wavenumber", "photon energy")  # the laws that count cycles


def find(p: Problem) -> Iterator[Candidate]:
    """Yield the wrong values from one edit of a law in the derivation."""
    # results of a sum over directions contain pi: `outside` has the mistakes with it
    has_pi = p.lists("all around") or not p.chain.symbols.isdisjoint(SKIES)
    for law, target in p.chain.steps:
        if "scale" in law.names:
            continue  # the definition of a distribution: nobody forgets a factor in it
        yield from _powers(p, law, target) if isinstance(law, Law) else _numbers(p, law, target)
        number, power = _constant(law)
        has_pi |= power != 0
        yield from filter(None, _constants(p, law, target, number, power))
    if not has_pi and (p.light or p.asks("solid-angle", "etendue", "sphere-fraction")):
        rule = "pi and 4 pi come from integrals over directions: M = pi L, Phi = 4 pi I"
        for name, factor, size in (
            ("pi-forgotten", "pi", math.pi),
            ("wrong-sphere", "4 pi", 4 * math.pi),
        ):
            done = Translatable("a factor of {0} was introduced by mistake", factor)
            for value in (p.right * size, p.right / size):
                yield Candidate(name, SELDOM, value, done, rule)


def text_of(law: AnyLaw) -> str:
    """Return the formula of a law in letters, with its name."""
    formula = fill(law.template, lambda name, _: letter_of(name) if name in SYMBOLS else name)
    return Translatable("{0}: {1}", law.name, formula) if law.name else formula


def label_of(name: str) -> str:
    """Return the name of a symbol in a sentence."""
    return LABELS.get(name) or SYMBOLS[name].label


# ---------------------------------------------------------------------------------------------
# Powers


def _powers(p: Problem, law: Law, target: str) -> Iterator[Candidate]:
    """Yield the wrong values from a product with another power of one symbol."""
    power_of_target = dict(law.powers).get(target, -1.0)
    start = p.chain.values[target]
    for name, power in law.powers:
        if name == target or name in WHOLE or (name in SYMBOLS and SYMBOLS[name].geometry):
            continue
        rule = text_of(law) or RULES[name]
        if name in WHY:
            rule = Translatable(BOTH, rule, WHY[name])
        exponent = -power / power_of_target  # in the law solved for the target
        for kind, rank, done, by in _edits(name, abs(power), exponent > 0):
            for size, later in _sizes(p, name, kind):
                wrong = start * size ** (exponent * by)
                value = p.chain.by(_edited(law, name, power, by), target, wrong)
                if value is not None:
                    mistake = f"{NAMES.get(name, name)}-{kind}"
                    yield Candidate(mistake, rank + later, value, done, rule)
    if target != law.result and start and not SYMBOLS[target].geometry:
        yield from _turned(p, law, target, abs(power_of_target))


def _edited(law: Law, name: str, power: float, by: float) -> Law:
    """Return a law with another power of a symbol in its formula: the power times (1 + by)."""
    old, new = f"{{{name}}}", abs(power) * (1 + by)
    if abs(power) != 1:
        old += f"^{abs(power):g}"
    text = f"{{{name}}}" + (f"^{abs(new):g}" if abs(new) != 1 else "")
    before, _, after = law.template.partition(old)
    if new == 0:
        template = before + "1" + after
    elif new > 0:
        template = before + text + after
    else:
        sign = "/ " if power > 0 else ""
        template = f"{before}1{after} {sign}{text}"
    return law._replace(template=_tidy(template))


def _tidy(template: str) -> str:
    """Leave factors of 1 out of a formula."""
    left, _, right = template.partition(" = ")
    right = f" {right} ".replace(" / 1 ", " ").replace(" (1 ", " (")
    while " 1 " in right and not right.startswith(" 1 /"):
        right = right.replace(" 1 ", " ", 1)
    right = re.sub(r"(?<!\+) 1\)", ")", right).replace("/ ()", "").replace("(Omega0)", "Omega0")
    right = right.replace("  ", " ").strip()
    return f"{left} = {right or '1'}"


def _edits(name: str, power: float, is_above: bool) -> Iterator[tuple[str, float, str, float]]:
    """Yield the edits of a symbol's power: kind, rank, description, change relative to the power.

    `is_above` is true if the symbol is a factor, false if it is a divisor.
    """
    label = label_of(name)
    is_bare = name in RULES or SYMBOLS[name].unit == "1"
    rank = FORGOTTEN.get(name, RARELY if is_bare else SELDOM)
    yield "forgotten", rank, Translatable("the {0} was forgotten", label), -1.0
    template = DIVIDED if is_above else MULTIPLIED
    by = Translatable("square of the {0}", label) if power == 2 else label
    yield "upside-down", RARELY, Translatable(template, by), -2.0
    if power == 2:
        rank = NOT_SQUARED.get(name, USUALLY)
        yield "not-squared", rank, Translatable("the {0} was not squared", label), -0.5
    for other in (power - 1, power - 2, power + 1) if power > 2 else ():
        done = Translatable(
            "the power {0} of the {1} was used, not {2}", f"{other:g}", label, f"{power:g}"
        )
        yield "wrong-power", USUALLY + abs(other - power) / 2, done, other / power - 1
    if name.startswith("cosine"):
        for more in (1.0, 2.0):
            yield "squared", HARDLY, Translatable("the {0} was squared or cubed", label), more


def _sizes(p: Problem, name: str, kind: str) -> Iterator[tuple[float, float]]:
    """Yield the value of a symbol in SI units and in the unit typed; additions to the rank."""
    size = p.chain.values[name]
    if size > 0:
        yield size, 0.0
        if name in IN_ELECTRONVOLTS:
            yield size * EV ** IN_ELECTRONVOLTS[name], 0.0
        input_name = "efficacy" if "efficacy" in NAMES.get(name, name) else name
        typed = p.given[input_name].number if input_name in p.given else None
        is_usual = kind == "not-squared" or input_name in IN_ITS_UNIT
        if isinstance(typed, float) and (is_usual or (kind, name) == ("forgotten", "time")):
            yield typed, 0.5


def _turned(p: Problem, law: Law, target: str, power: float) -> Iterator[Candidate]:
    """Yield the wrong values from a law solved wrongly: no square root, or the reciprocal."""
    size, label = p.chain.values[target], label_of(target)
    if power == 2 and (value := p.chain.after(target, size**2)) is not None:
        done = Translatable("the square root for the {0} was forgotten", label)
        rank = NOT_SQUARED.get(target, USUALLY)
        yield Candidate(f"{target}-not-squared", rank, value, done, text_of(law))
    for root in (2, 3) if power == 4 else ():
        if (value := p.chain.after(target, size ** (power / root))) is not None:
            done = Translatable(ROOTS[root], label)
            yield Candidate(f"{target}-wrong-power", USUALLY, value, done, text_of(law))
    if (target == p.chain.goal or target in RATIOS) and (
        value := p.chain.after(target, 1 / size)
    ) is not None:
        done = Translatable(INVERTED, label)
        yield Candidate(f"{target}-upside-down", RARELY, value, done, text_of(law))


def _numbers(p: Problem, law: AnyLaw, target: str) -> Iterator[Candidate]:
    """Yield the wrong values from a number in any other law forgotten or inverted."""
    for name in law.names:
        size = p.chain.values.get(name, 0.0)
        if name == target or SYMBOLS[name].unit != "1" or name in NO_FACTORS or size <= 0:
            continue
        for kind, other, rank, done in (
            ("forgotten", 1.0, FORGOTTEN.get(name, RARELY), "the {0} was forgotten"),
            ("upside-down", 1 / size, RARELY, "the {0} was inverted"),
        ):
            at = {**p.chain.values, name: other}.__getitem__
            value = p.chain.solved(target, lambda _, at=at: law.solve(target, at))  # type: ignore[misc]
            if value is not None:
                sentence = Translatable(done, label_of(name))
                yield Candidate(f"{name}-{kind}", rank, value, sentence, text_of(law))


# ---------------------------------------------------------------------------------------------
# Constants


class Constant(NamedTuple):
    """A wrong constant: its mistake and ratio to the right one, and the texts of both."""

    mistake: str
    ratio: float
    texts: tuple[str, str] | None = None
    done: str = ""


def _constant(law: AnyLaw) -> tuple[float, int]:
    """Return number and power of the constant (number * pi)^power in front of a formula.

    For 4 x / (pi y) they are 1/4 and -1.  Without pi the power is 0, and the number is the whole
    constant.
    """
    right = law.template.partition(" = ")[2]
    number, pi, sign = 1.0, 0, 1
    for word in right.split():
        if word == "/":
            sign = -1
            continue
        if word == "pi":
            pi += sign
        elif word.isdigit():
            number *= float(word) ** sign
        elif word != "Omega0":
            break
        sign = 1
    if "/ (4 pi " in right:
        return 4.0, pi - 1
    if "/ (pi " in right:
        return 1 / number, pi - 1
    if "/ (4 " in right:
        number /= 4
    return number, pi


def scaled(
    p: Problem, law: AnyLaw, target: str, ratio: float, texts: tuple[str, str] | None = None
) -> float | None:
    """Return the result [SI] if a law has a constant that is `ratio` times the right one.

    `texts` are the right and the wrong constant as they are written in the formula.
    """
    result = law.names[0]

    def solve(at: At) -> Any:
        if target == result:
            return at(target) * ratio
        return law.solve(target, lambda name: at(name) / (ratio if name == result else 1.0))

    value = p.chain.solved(target, solve)
    left, _, right = law.template.partition(" = ")
    if texts is None or not isinstance(value, Worked) or texts[0] not in right:
        return None if value is None else float(value)
    template = _tidy(f"{left} = {right.replace(texts[0], texts[1] or '1', 1)}")
    return p.chain.by(law._replace(template=template), target, value.wrong[target])


def _constants(
    p: Problem, law: AnyLaw, target: str, number: float, power: int
) -> Iterator[Candidate | None]:
    """Yield the wrong values from a law with another constant of the same family."""
    if law.name in ("diameter", "apex angle", "diameter of the receiver"):
        return  # the 2 is between half and full: see `misread`
    for constant in (*_wrong_pi(number, power), *_wrong_factors(p, law)):
        value = scaled(p, law, target, constant.ratio, constant.texts)
        yield usual(constant.mistake, value, constant.done, text_of(law))


def _wrong_pi(number: float, power: int) -> Iterator[Constant]:
    """Yield the wrong constants in place of (number * pi)^power."""
    right = f"{number:g} pi" if number != 1 else "pi"
    if power and number >= 1:
        for size in (1, 2, 4):
            wrong = f"{size} pi" if size > 1 else "pi"
            if (right, wrong) == ("pi", "2 pi"):
                yield Constant("two-pi-for-pi", 2.0**power, (right, wrong))
            elif size != number:
                done = Translatable("{0} was used for {1}", wrong, right)
                yield Constant("wrong-sphere", (size / number) ** power, (right, wrong), done)
        name = "pi-forgotten" if number == 1 else "wrong-sphere"
        yield Constant(name, math.pi**-power, (right, f"{number:g}"), PI_FORGOTTEN)
        done = Translatable("{0} was forgotten", right)
        yield Constant(name, (number * math.pi) ** -power, (right, ""), done)
    elif power:
        yield Constant("pi-forgotten", math.pi**-power, (right, "1"), PI_FORGOTTEN)
        yield Constant("constant-forgotten", (number * math.pi) ** -power, (right, ""))
    if power and number == 1:
        yield Constant("pi-upside-down", math.pi ** (-2 * power))
        yield Constant("pi-twice", math.pi**power, (right, "pi^2"))
    elif number != 1:
        yield Constant("constant-forgotten", number ** -(power if number < 1 and power else 1))


def _wrong_factors(p: Problem, law: AnyLaw) -> Iterator[Constant]:
    """Yield the wrong constants of laws of cycles, decades and the peak."""
    if law.name in CYCLES or (law.name == "density" and FREQUENCY in p.target.dimensions):
        yield Constant("angular-for-cycles", 2 * math.pi)
        yield Constant("angular-for-cycles", 0.5 / math.pi)
    if "lg2" in law.template:
        yield Constant("log-base", math.log(10), ("lg2", "ln2"))
    if law.name == PEAK.name:
        yield Constant("wien-without-4.965", WIEN_X)
        yield Constant("wien-per-frequency", PER_FREQUENCY)
