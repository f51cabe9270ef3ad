"""The promise of sentences: what was typed is in the call, and the result comes from all of it."""

import re
from collections import Counter
from collections.abc import Callable, Sequence
from contextlib import suppress
from importlib import import_module
from math import isclose
from typing import Any

from radcalc.answer import Answer
from radcalc.calculators.pages import page_of
from radcalc.calculators.solved import Task
from radcalc.conversion.operands import read_operands
from radcalc.conversion.plan import plan, source_of, target_of
from radcalc.errors import RadcalcError, Try, Unused, UsageError, input_of, listed, quote
from radcalc.inputs import Input, Inputs
from radcalc.inputs.reading import read
from radcalc.quantities.symbols import FLAG, QUANTITY, SYMBOLS
from radcalc.sentences.facts import LEDS
from radcalc.sentences.frames import FRAMES
from radcalc.sentences.products import law_of
from radcalc.sentences.reader import Fact, Sentence
from radcalc.units.dimensions import TEMPERATURE

NUMBERS = re.compile(r"(?<![^\W\d_])\d+(?:\.\d+)?")
EXPONENTS = re.compile(r"(?<=[^\W\d_])\^?-?[1-4](?![\w.°])")  # of units: m-2, m^2
OF_LED = "spectrum=LED-"  # in place of a colour temperature
DESCRIBING = frozenset(["wavelength", "spectrum"])  # what a light is: said, if it is not used
ROUNDED = 1e-9  # relative difference of equal results, far below that of moved inputs
MOVED = 1e-3  # relative change of an input, which a result shows
ALL = "a sentence in which each amount changes the answer"
SOLVED = {frame.command for frame in FRAMES}


def refuse_unused(sentence: Sentence, call: Sequence[str]) -> None:
    """Raise for an amount of a sentence that its call lacks, or that the result does not need.

    Raise the error of a call that is refused if its hint would leave out an amount.
    """
    facts = sentence.facts
    lost = _lost(facts, call)
    tries: list[Try] = []
    if not lost:
        try:
            names, tries = unneeded(call)
            names = names - DESCRIBING
        except RadcalcError as error:
            numbers = [number for fact in facts for number in _numbers(fact.text)]
            kept = [one for one in error.tries if _has(_whole(one, call), numbers)]
            if len(kept) == len(error.tries):
                return  # the call says it
            raise error.reworded(hint=[_whole(one, call) for one in kept] or ALL) from None
        lost = [_typed(fact) for fact in facts if names & _names(fact, call)] or [*names]
    if lost:
        goals = listed([goal.text for goal in sentence.goals])
        known = [text for text in map(_typed, facts) if text not in lost]
        understood = f"understood {', '.join(map(quote, known))}; " if known else ""
        wanted = f" for {goals}" if goals else ""
        raise UsageError(f"{understood}not used{wanted}: {listed(lost)}", tries or ALL)


def _lost(facts: Sequence[Fact], call: Sequence[str]) -> list[str]:
    """Return the phrases with a number that the words of a call lack."""
    has = Counter(_numbers(" ".join(call)))
    has_led = any(word.startswith(OF_LED) for word in call)
    lost = []
    for fact in facts:
        is_of_led = has_led and fact.amount and fact.amount.dimension == TEMPERATURE
        typed = Counter(_numbers(fact.amount.text if fact.amount else fact.text))
        if typed - has and not is_of_led:
            lost.append(_typed(fact))
        has -= typed
    return lost


def _has(proposal: Try, numbers: Sequence[str]) -> bool:
    """Return whether a proposed call has all of some numbers."""
    text = " ".join(proposal.words)
    return all(number in text for number in numbers)


def _typed(fact: Fact) -> str:
    return fact.typed.replace("f/ ", "f/")


def _names(fact: Fact, call: Sequence[str]) -> set[str]:
    """Return the inputs of a call that have the numbers of a fact."""
    typed = _numbers(fact.text)
    pairs = [input_of(word) for word in call[1:]]
    return {name for name, text in pairs if name and typed and _numbers(text) == typed}


def _numbers(text: str) -> list[str]:
    """Return the numbers of a text, without those in its units."""
    return NUMBERS.findall(EXPONENTS.sub("", text))


def assumptions_of(sentence: Sentence, call: Sequence[str]) -> list[str]:
    """Return what the answer of a sentence assumes, which its call does not say."""
    texts = dict(map(input_of, call))
    idle = _unneeded_in(call) if DESCRIBING & texts.keys() else set()
    said = [
        f"the same at every wavelength: {quote(texts[name])} is not used"
        for name in sorted(DESCRIBING & idle)
    ]
    led = texts.get("spectrum", "")
    for fact in sentence.facts:
        if led in LEDS and fact.amount and fact.amount.dimension == TEMPERATURE:
            said.append(f"an LED of {quote(fact.typed)} is taken as {led}, of {LEDS[led]} K (CIE)")
        elif fact.symbols == ("spectrum",) and "efficacy" in texts and not led:
            said.append(f"the efficacy is that of {quote(fact.text)}, whose spectrum is not used")
    return [*law_of(call), *said]


def is_idle(call: Sequence[str]) -> bool:
    """Return whether an input of a call does not change its result, nor describes its light."""
    return bool(_unneeded_in(call) - DESCRIBING)


def _unneeded_in(call: Sequence[str]) -> set[str]:
    """Return the inputs that do not change the result of a call; none if it is refused."""
    try:
        return unneeded(call)[0]
    except RadcalcError:
        return set()


def unneeded(call: Sequence[str]) -> tuple[set[str], list[Try]]:
    """Return the inputs of a call that do not change its result, and calls that use them.

    Return none for a call with all results.
    """
    command, *words = call
    if command not in SOLVED:
        return set(), []
    pairs = [input_of(word) for word in words]
    operands = [text for name, text in pairs if not name]
    results = [text for name, text in pairs if name == "get"]
    page = page_of(command)
    given = {
        name: read(name, text or SYMBOLS[name].form == FLAG, bare=page.bare.get(name, ""))
        for name, text in pairs
        if name and name != "get"
    }
    try:
        if command == "convert":
            _plan(operands, [*given.values()])
        elif results and (work_out := _function(command, operands)):
            names = [result.partition(":")[0] for text in results for result in text.split(",")]
            return _idle(work_out, given, names), [Try(words=(command, *words[: -len(results)]))]
    except Unused as error:
        kept = [one for one in error.tries if not one.without]
        kept = [one for one in kept if one.instead[:1] in ((), (operands[-1],))]
        return {*error.symbols}, [_whole(one, call) for one in kept]
    return set(), []


def _plan(operands: list[str], given: list[Input]) -> None:
    """Plan a conversion, which refuses a condition that it does not need."""
    amount, text = read_operands(operands)
    unit = amount.typed[1]
    if text and unit:
        target = target_of(text, unit)
        source = source_of(amount, target, given) or unit
        plan(source, target, given, f"{amount.exact:.12g}")


def _function(command: str, operands: Sequence[str]) -> Callable[[Inputs], Answer] | None:
    """Return the function of a calculator; None for one with an operand."""
    module = import_module(f"radcalc.calculators.{command.replace('-', '_')}")
    if hasattr(module, "task"):
        task: Task = module.task(operands, lambda name: False)
        return task.nominal
    if module.PAGE.operand:  # a wavelength or a spectrum, with no other inputs to lose
        return None
    return Task(command, getattr(module, command.replace("-", "_"))).nominal


def _idle(work_out: Callable[[Inputs], Answer], given: Inputs, names: Sequence[str]) -> set[str]:
    """Return the inputs that can change without any of the results of these names."""
    first = _results(work_out(given), names)
    idle = set()
    for name, item in given.items():
        if item.symbol.form != QUANTITY or not any(first):
            continue
        moved = item._replace(value=item.value * (1 + MOVED) + MOVED * (not item.value))
        with suppress(RadcalcError):  # one that contradicts the others is used
            second = _results(work_out({**given, name: moved}), names)
            if len(second) == len(first) and all(map(_is_same, first, second)):
                idle.add(name)
    return idle


def _is_same(first: float, second: float) -> bool:
    return isclose(first, second, rel_tol=ROUNDED)


def _results(answer: Answer, names: Sequence[str]) -> list[Any]:
    """Return the results of these names [SI]."""
    values = [value for value in answer.values if {value.name, value.also} & {*names}]
    return [value.amount for value in values if not value.is_absent]


def _whole(proposal: Try, call: Sequence[str]) -> Try:
    """Return the call that a proposal changes, as a whole."""
    if proposal.words:
        return proposal
    old, *new = proposal.instead or ("", "")
    gone = {*proposal.without, *[name for name, _ in proposal.inputs]}
    words = [" ".join(new) if word == old else word for word in call]
    words = [word for word in words if word and input_of(word)[0] not in gone]
    words += [f"{name}={value}" for name, value in proposal.inputs]
    return Try(words=tuple(words), remark=proposal.remark)
