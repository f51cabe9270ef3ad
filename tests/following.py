"""Calls that hints suggest, and whether these calls are answered.

A hint is split into its mentions (an option with a value, or a command) and the words that
separate alternatives.  Hints in prose, without a call to type, match `PROSE`.
"""

import re
import shlex
from collections.abc import Iterator
from functools import cache
from itertools import pairwise, product
from math import isclose
from pathlib import Path
from typing import Any, NamedTuple
from unittest import mock

from conftest import standard_streams

from radcalc import cli, terminal
from radcalc.calculators.page import Page
from radcalc.calculators.pages import SUMMARIES, page_of
from radcalc.cli.cases import is_stream
from radcalc.cli.spelling import Shell
from radcalc.cli.trials import is_long
from radcalc.errors import END, START, VALUE, WORD, Impossible, RadcalcError
from radcalc.quantities.symbols import FLAG, SYMBOLS, light_unit
from radcalc.units.numbers import split_quantity
from radcalc.units.uncertain import SIGN, signed

Words = list[str]
STEPS = 6  # hints followed one after another, if a call has several errors
LINES = (
    b"1\n",
    b"1 lx\n",
    b"E,F\n1,2\n",
    b"E,F\n1 lx,2 lx\n",
    b"1 2\n",
    b"E F\n1 2\n",
    b"x F\n1 2\n",
    b"1 2 3\n",
    b"1,2,3\n",
    b"400 1\n700 2\n",  # a spectrum
)  # for a stream

# Hints in prose: they describe what is possible, without a call to type.
PROSE = (
    r"a value such as .*", r"first .*, then arithmetic.*",
    r"(--column with )?one of the titles: .*",
    r"a number such as .*", r"a finite number|decimal digits|the digits 0 to 9",
    r"a number other than 0", r"(less|more) than [0-9.e-]+", r"at most [0-9]+.*", r"0 or more.*",
    r"values? (from|between) .*", r"(less extreme|other) values", r"a unit such as .*",
    r"one unit (in START, STOP and STEP|for X, Y and Z)", r"a step from START to STOP",
    r"a list for one of them, and a loop", r"quotes around .*", r"a space or a dot between them.*",
    r"the number times that length.*", r"a TARGET unit", r"X,Y,Z, in one unit .*",
    r"another spectrum or range", r"a reflectance above 0, and .* below 90 deg",
    r"(less|more) .*, or (less|more) .*", r"a receiver in the light", r"(the path of )?a file",
    r"a (wavelength|temperature) from \S+ to \S+", r"from \S+ to \S+( sr)?", r"one value.*",
    r"give it once, or .*", r"it is a (number|logarithmic scale).*",
    r"vertices that are not on one line", r"its triangles, one by one", r"each once, .*",
    r"from 3 to 1000, as X,Y,Z", r"the vertices in order round it", r"a viewpoint off that plane",
    r"a vector that is not zero", r"a part of the sphere where it is not", r"a function that .*",
    r"numbers, \+ - .*", r"an expression such as .*", r"\w+\(.*\)", r"polar angles from .*",
    r"N, N-, N-M.*", r"fields are numbered .*", r"a character, such as .*", r"one (shape|exponent)",
    r"a distance to the centre greater than the radius.*", r"the chromaticity: x and y",
    r"more of the quantities", r"a line with the names of the columns", r"one source a call",
    r"a whole number", r"wavelengths from \S+ to \S+", r"one of the two", r"one exponent",
    r"only one of them", r"one of them", r"the same unit.*", r"terms of one quantity",
    r".* \* \(1 [+-] .*\)", r"leave it out.*", r".* is read as .*",
    r"the polygon's vertices.*", r"from 3 .*", r"shorter lines",
    r"a line of \d+ fields", r"- once, and files",
    r"a larger .*", r"a smaller .*", r"an intensity or a radiance: .*", r"K: a step .*",
    r"an intensity behind it, .*",
    r"a result between .*", r"a call for each (conversion|kind of line)", r"a comparison by .*",
    r"a product of comparisons .*", r"angles with their units, .*",
)  # fmt: skip
STANDING_FOR = {  # values for placeholders in capitals
    "UNIT": "lx", "TARGET": "fc", "FILE": "D65", "SOURCE": "D65", "X": ",", "N": "1",
    "VALUE": "1",
}  # fmt: skip


ALSO = {"--get": "-g", "--format": "--json", "--delimiter": "-d"}  # other spellings


class Outcome(NamedTuple):
    """The outcome of a call; `hints` are the lines that propose other calls, with their answers."""

    status: int
    output: str
    error: RadcalcError | None
    hints: Words

    @property
    def proposed(self) -> Iterator[tuple[Words, str]]:
        """Yield the calls in the hints as they are pasted, each with the answer below it."""
        for line, below in pairwise([*self.hints, ""]):
            if line.startswith(terminal.CALLS):
                answer = below.strip() if below.startswith("     ") else ""
                yield shlex.split(line.partition("radcalc ")[2]), answer


def call(words: Words, lines: bytes = LINES[0]) -> Outcome:
    """Run a command in this process, with lines as its input; catch its error."""
    caught: list[RadcalcError] = []
    hinted: Words = []

    def complain(error: RadcalcError, spelling: Any = None, hints: Any = None) -> int:
        caught.append(error)
        hinted.extend(hints or [])
        return terminal.FAILED

    with standard_streams(lines) as (out, _), mock.patch.object(terminal, "complain", complain):
        status = cli.run(list(words))
        out.seek(0)
        return Outcome(status, out.read().decode(), caught[0] if caught else None, hinted)


NUMBER = re.compile(r"-?[0-9]+\.?[0-9]*(?:e[+-]?[0-9]+)?")


def unlike(words: Words, answer: str, lines: bytes) -> str:
    """Return what is wrong with a call in a hint: it is refused, or its number is another."""
    if "<" in words:
        place = words.index("<")
        lines = Path(words[place + 1]).read_bytes()
        words = [*words[:place], *words[place + 2 :]]
        return "" if call(words, lines).output else "answers nothing"
    if is_long(words):  # the gate does not make it
        return ""
    outcomes = [call(words, each) for each in (LINES if any(map(is_stream, words)) else [lines])]
    good = [one for one in outcomes if one.status in (terminal.ANSWERED, terminal.WRONG)]
    if not good:
        return f"refused: {outcomes[0].error}"
    outcome = good[0]
    if not answer or "--check" in words:
        return ""
    shown = NUMBER.search(answer.rpartition(" ")[0] or answer)
    numbers = [float(number) for number in NUMBER.findall(outcome.output)]
    if shown and not any(
        isclose(float(shown[0]), number, rel_tol=0.01 if "±" in answer else 1e-5)
        for number in numbers
    ):
        return f"answers {outcome.output!r}, not {answer!r}"
    return ""


class Option(NamedTuple):
    """An option in a hint, with its value."""

    name: str
    value: str


class Command(NamedTuple):
    """A command in a hint."""

    words: Words


Token = Option | Command
PLAIN = re.compile(
    r"radcalc (?P<words>[a-z-]+(?:(?! for | with )[^,;()])*)"
    r"|(?<![\w-])(?P<name>--[a-z][a-z-]*|-g)(?: (?P<value>[A-Z0-9][^ ,;()]*))?"
)


def cut(hint: str) -> tuple[str, list[Token]]:
    """Return the hint with its mentions replaced by <0>, <1> ..., and the mentions."""
    tokens: list[Token] = []

    def place(token: Token) -> str:
        tokens.append(token)
        return f"<{len(tokens) - 1}>"

    def marked(found: re.Match[str]) -> str:
        name, _, value = found[1].partition(VALUE)
        if name:
            return place(Option("-g" if name == "get" else f"--{name}", value.strip("'")))
        if value.startswith(WORD):
            return place(Command([value[1:], "--help"]))
        typed: Words = []
        for word in value.split(WORD):
            key, equals, text = word.partition("=")
            typed += ["-g" if key == "get" else f"--{key}", text] if equals else [word]
        return place(Command([word for word in typed if word]))

    def plain(found: re.Match[str]) -> str:
        if found["name"]:
            return place(Option(found["name"], found["value"] or ""))
        return place(Command(shlex.split(found["words"])))

    text = re.sub(f"{START}([^{END}]*){END}", marked, hint)
    return PLAIN.sub(plain, text), tokens


def without(words: Words, *names: str) -> Words:
    """Return the words without some options."""
    names += tuple(ALSO[name] for name in names if name in ALSO)
    kept, skip = [], False
    for word in words:
        name, equals, _ = word.partition("=")
        if skip:
            skip = False
        elif name in names:
            skip = not equals and not _is_flag(name)
        else:
            kept.append(word)
    return kept


def _is_flag(name: str) -> bool:
    symbol = SYMBOLS.get(name.removeprefix("--"))
    return bool(symbol and symbol.form == FLAG) or name in ("--steps", "-n", "--json")


def examples(option: Option, words: Words) -> list[str]:
    """Return values to type for an option: its value in the hint, or examples."""
    name = option.name.removeprefix("--")
    if option.value in STANDING_FOR and name not in SYMBOLS:
        return [STANDING_FOR[option.value]]
    if option.value and not re.fullmatch("[A-Z]+", option.value) and option.value != "NAME:UNIT":
        return [option.value]
    if name not in SYMBOLS:
        return [""]
    symbol = SYMBOLS[name]
    page = page_of(words[0]) if words[0] in SUMMARIES else Page()
    example = page.symbol(name).example or symbol.example
    if name == "efficacy":
        return [example, "2.1umol/J", "54lm.s/umol"]
    found = [symbol.example, example]
    if symbol.geometry and not symbol.kind:
        found += [f"10{light_unit(name, kind)}".replace(" ", ".") for kind in "evp"]
    return list(dict.fromkeys(found))


def put(words: Words, option: Option) -> Iterator[Words]:
    """Yield the words with an option, which replaces an earlier value of the option."""
    rest = without(words, option.name)
    if option.value in ("NAME:UNIT", "NAME=VALUE"):
        first = call([*without(rest, "-n", "--json", "-g"), "-q"]).output.split("\n")[0]
        name, value, unit = ([*first.split("\t"), "", ""])[:3] if first else ("flux", "1", "lm")
        unit = unit.replace(" ", ".")
        is_get = option.value == "NAME:UNIT"
        shown = f"{name}:{unit}" if is_get else f"{name}={value}{unit}"
        yield [*without(rest, "-n", "-g"), option.name, shown]
    elif _is_flag(option.name):
        yield [*rest, option.name]
    else:
        for value in examples(option, words):
            yield [*rest, option.name, value]


def candidates(words: Words, error: RadcalcError) -> list[list[Words]] | None:
    """Return the calls to type for each alternative of the hint, or None if it is prose."""
    text, tokens = cut(error.hint.replace(" (one word, no blank)", ""))
    text = re.sub(r" ?\((?:see|or) <\d+>\)", "", text).strip()
    message, said = cut(error.message)
    told = [token.name for token in said if isinstance(token, Option)]
    mentioned = [token.name for token in tokens if isinstance(token, Option)]
    if "(one word" in error.hint and tokens:
        words = _joined(words, tokens[0])
    if isinstance(error, Impossible) and "<" not in text:
        return [list(put(words, Option(f"--{error.symbol}", "")))]
    if re.match("leave out <|two discs without <", text):
        return [[without(words, *mentioned)]]
    if text.startswith("leave out one of"):
        return [[without(words, name) for name in mentioned]]
    if text in ("only one of them", "fewer of them") and told:
        return [[without(words, *(set(told) - {name}))] for name in told]
    if text.startswith("one of <"):
        return [list(put(without(words, *mentioned), one)) for one in tokens]  # type: ignore[arg-type]
    if text.endswith(" in its place") and told:
        text = text.removesuffix(" in its place")
        return list(_alternatives(without(words, told[0]), text, tokens))
    if found := re.fullmatch(r"<0> in place of <(\d+)>.*", text):
        return [list(put(without(words, mentioned[1]), tokens[0]))]  # type: ignore[arg-type]
    if found := re.fullmatch(r"(\S+) in place of ([^<,]*),.*", text):
        return [[[found[1] if word == found[2] else word for word in words]]]
    if re.search(r"a (smaller|larger) <", text):
        return [list(_scaled(words, text, tokens))]
    if steps := re.findall(r"<(\d+)> and then <(\d+)>", text):
        return [[_in_two(words, tokens[int(a)], tokens[int(b)])] for a, b in steps]  # type: ignore[arg-type]
    if (found := re.search(r"has no (-\S+) option", error.message)) and "<" in text:
        wrong = found[1]
        if mentioned:
            named = [t for t in tokens if isinstance(t, Option)]
            put_in = [[t.name, t.value] if t.value else [t.name] for t in named]
            return [
                [[w for word in words for w in (new if word == wrong else [word])]]
                for new in put_in
            ]
    if "<" in text:
        return list(_alternatives(words, text, tokens))
    if any(re.fullmatch(prose, text) for prose in PROSE):
        return None
    text = re.sub(r"(?:,? for |: |, with |, which )[^,]*$", "", text)
    quoted = [one for one in re.findall(r"'([^']*)'", message) if one] or told
    parts = re.split(r", or | or |, ", text)
    if any(":" in one for one in parts) and "-g" in words:
        return [[[*without(words, "-g"), "-g", one]] for one in parts]
    return [[_in_place(words, quoted, one)] for one in parts]


def _joined(words: Words, option: Token) -> Words:
    """Remove the unit that is a separate word after a number."""
    if isinstance(option, Option) and option.name in words:
        k = words.index(option.name) + 2
        if k < len(words) and option.value.endswith(words[k]):
            return [*words[:k], *words[k + 1 :]]
    return words


def _alternatives(words: Words, text: str, tokens: list[Token]) -> Iterator[list[Words]]:
    """Split `<0>, <1> or <2> with <3>; and <4>`; parts joined by `and` or `with` go together."""
    for chosen in product(*(group.split(", or ") for group in text.split("; and "))):
        parts = [part for one in chosen for part in one.split(" with ")]
        if " or " not in text and " and " in text:
            parts = text.split(" and ")
            parts = [one for part in parts for one in part.split(", ")]
        choices = [
            [named for one in re.split(" or |, ", part) if (named := re.findall(r"<(\d+)>", one))]
            for part in parts
        ]
        if not any(choices):
            continue
        for numbers in product(*(choice for choice in choices if choice)):
            typed = [words]
            for token in (tokens[int(n)] for named in numbers for n in named):
                if isinstance(token, Command):
                    typed = [[STANDING_FOR.get(word, word) for word in token.words]]
                else:
                    typed = [more for base in typed for more in put(base, token)]
            yield typed


def _in_two(words: Words, first: Command, then: Option) -> Words:
    """Return the second of two conversions, with the result of the first."""
    quantity = call([*first.words, "-q"]).output.split("\n")[0].replace("\t", " ")
    operands = [word for word in words if not word.startswith("-")]
    target = operands[3] if len(operands) > 3 else operands[-1]
    return ["convert", quantity, target, then.name, *([then.value] if then.value else [])]


def _scaled(words: Words, text: str, tokens: list[Token]) -> Iterator[Words]:
    """Follow `a smaller <0>, <1> or a larger <2>`: multiply the option's value by 0.01 or 100."""
    larger = False
    for word, number in re.findall(r"(smaller |larger )?<(\d+)>", text):
        larger = word == "larger " if word else larger
        token = tokens[int(number)]
        for k, typed in enumerate(words):
            key, equals, value = typed.partition("=")
            if isinstance(token, Option) and key == token.name:
                size, unit = split_quantity(value if equals else words[k + 1])
                size *= 100 if larger else 0.01
                yield from put(words, Option(token.name, f"{size:g}{unit}"))


def _in_place(words: Words, quoted: list[str], one: str) -> Words:
    """Replace the words that the message quotes by an alternative, or append it."""
    one = re.sub(r" (?:if that|with the power|where|for) .*| \(.*", "", one)
    words = [signed(word) if SIGN in one + "".join(quoted) else word for word in words]
    for text in quoted:
        for k, word in enumerate(words):
            if text in word:
                return [*words[:k], word.replace(text, one), *words[k + 1 :]]
        joined = " ".join(words)
        if text in joined:  # several words of one unit
            before, after = joined.split(text, 1)
            return [*before.split(), one, *after.split()]
    return [*words, one]


def answered(words: Words, steps: int = STEPS) -> bool:
    """Return whether a call is answered, at once or by following hints, or ends in prose."""
    return _is_answered(tuple(words), steps)


@cache  # many hints lead to the same call
def _is_answered(typed: tuple[str, ...], steps: int) -> bool:
    words = list(typed)
    for lines in LINES if any(map(is_stream, words)) else LINES[:1]:
        outcome = call(words, lines)
        if outcome.error is None:
            is_answer = outcome.status in (terminal.ANSWERED, terminal.WRONG)
            return is_answer and outcome.output.strip() != ""
        if any(not unlike(typed, answer, lines) for typed, answer in outcome.proposed):
            return True
        ways = candidates(words, outcome.error) if steps else []
        if ways is None:
            return True
        first = [way for alternative in ways[:3] for way in alternative[:3] if way != words]
        if any(answered(way, steps - 1) for way in first):
            return True
    return False


def liars(words: Words, lines: bytes = LINES[0]) -> list[str]:
    """Return the alternatives in the hint of a refused call that do not lead to an answer."""
    outcome = call(words, lines)
    error = outcome.error
    assert error is not None, words
    if proposed := list(outcome.proposed):
        faults = [(typed, unlike(typed, answer, lines)) for typed, answer in proposed]
        return [
            f"radcalc {shlex.join(words)}\n    try: radcalc {shlex.join(typed)}\n    {fault}"
            for typed, fault in faults
            if fault
        ]
    ways = candidates(words, error)
    if ways is None:
        return []
    message, hint = error.spelled(Shell)
    told = f"radcalc {' '.join(words)}\n    {message}\n    try: {hint}\n    followed: "
    if not ways:
        return [told + "nothing to type"]
    return [
        told + " | ".join(" ".join(way) for way in alternative)
        for alternative in ways
        if not any(answered(way, STEPS - 1) for way in alternative if way != words)
    ]
