"""Calls that are sentences: what they mean, and how they are read."""

import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import click

from radcalc import errors, terminal
from radcalc.answer import texts_of
from radcalc.calculators import COMMANDS, page_of
from radcalc.calculators.page import CHECKS, DEFAULTS, GET, OF_ANSWERS, STEPS, Option
from radcalc.calculators.worksheet import on_page
from radcalc.cli import spelling
from radcalc.cli.command import option_of, parameters
from radcalc.cli.lane import hear, is_other, plain
from radcalc.cli.output import Output, decide, refuse_number_options
from radcalc.cli.request import is_stream
from radcalc.cli.spelling import EXPLAIN, HELP_NAMES, pasted, quoted, route, say, typed
from radcalc.conversion.operands import is_conversion
from radcalc.errors import RadcalcError, UsageError, call, drop, input_of, leave_out
from radcalc.quantities.symbols import FLAG, SYMBOLS
from radcalc.render.formats import Records
from radcalc.sentences.calls import call_of
from radcalc.sentences.frames import one_word
from radcalc.sentences.reader import Fact, Sentence, read
from radcalc.sentences.used import assumptions_of
from radcalc.terminal import JSON, PLAIN
from radcalc.units import NUMBER
from radcalc.units.numbers import are_uncertain, is_sentence

if TYPE_CHECKING:
    from radcalc.cli.output import Listener

Words = list[str]
LONG = 6  # words of a call that is rather a sentence than a command
SHORT = 3  # words of a call that is rather a command with a mistake
# Options of a call in words: those of the output and of a check.
OF_SENTENCES = (*OF_ANSWERS, *CHECKS)
# With a value and its unit.
PLAIN_OPTIONS = {"precision", "quiet", "color", "auto", "definitions", STEPS.parameter}


class Gate(NamedTuple):
    """What a sentence needs of the command line: to run a call, and to know a good hint.

    `has_answers` returns whether the calls in the hint of an error have answers.
    """

    run: Callable[[Words], int]
    has_answers: Callable[[errors.RadcalcError, Words], bool]
    listener: "Listener | None" = None


def instead(words: Words, error: errors.RadcalcError, gate: Gate) -> int:
    """Answer a refused call as a sentence, if it is one; otherwise raise the better error.

    If the call that the sentence means is refused, it replaces `words`, for the calls of its hint.
    """
    if not may_be(words, error):
        raise error
    call, options, assumed = call_meant(words, error, gate.has_answers)
    try:
        return _answer(call, options, assumed, gate)
    except errors.RadcalcError as refused:
        is_missing = isinstance(refused, (errors.MissingCondition, errors.MissingInput))
        if not is_missing and _is_clear(error, words, gate.has_answers):
            raise error from None
        words[:] = [*call, *options]
        raise on_page(refused, call[0]) from None


def _is_clear(error: errors.RadcalcError, words: Words, has_answers: Callable[..., bool]) -> bool:
    """Return whether the hint of an error that is not about the number of words has answers."""
    return not isinstance(error, errors.TooManyWords) and has_answers(error, words)


def may_be(words: Sequence[str], error: errors.RadcalcError) -> bool:
    """Return whether a refused call may be a sentence, and not a command with a mistake."""
    others = {*HELP_NAMES, "help", "--version", EXPLAIN, *GET.spellings}
    if not words or any(map(is_stream, words)) or {*words} & others:
        return False
    asked, _ = options_of(options_of(words)[0], _of_file(words))
    asked, inputs = inputs_of(asked)
    of_reading = (
        errors.ExpressionError,
        errors.MissingCondition,
        errors.NoFile,
        errors.SeveralReadings,
    )
    is_read = isinstance(error, of_reading) and not are_uncertain(words)
    if is_read or all(word[:1] == "-" for word in asked):
        return False
    options = [word.partition("=")[0] for word in asked if word[:2] == "--"]
    if asked[0] in COMMANDS:
        is_word = len(asked) > 1 and not any(c.isdigit() for c in asked[1])
        has_file = any(map(os.path.exists, asked))
        is_word |= "unexpected argument" in error.message
        is_phrase = is_word and not (options or inputs or has_file)
        return asked[0] != "convert" and is_phrase
    if asked[0][:1] == "-" and {*asked} & {*COMMANDS}:  # options before a command
        return False
    if not options:
        return True
    known = {name for parameter in parameters("convert") for name in parameter.opts}
    return not known.issuperset(options)


def call_meant(
    words: Words,
    error: errors.RadcalcError,
    has_answers: Callable[[errors.RadcalcError, Words], bool],
) -> tuple[Words, Words, Words]:
    """Return the call that a refused call means, its options of the output, and what it assumes.

    Raises `error` if the words are not a sentence, or are the same call; raises the problem of the
    sentence if that is more useful.
    """
    asked, options = options_of(words)
    typed_words, own = options_of(asked, _of_file(words))
    asked, inputs = inputs_of(typed_words)
    understood = False
    try:
        sentence = read(asked, inputs)
        understood = _is_understood(sentence, asked) and not (inputs and sentence.unknown)
        found = call_of(sentence)
        call = [*typed(found), *own]
    except errors.RadcalcError as problem:
        has_readings = any(one.is_call for one in problem.tries)
        is_several = isinstance(problem, errors.SeveralReadings)
        is_free = (asked[0] not in COMMANDS or is_several) and (understood or has_readings)
        is_long = isinstance(error, errors.UsageError) and len(" ".join(asked).split()) > LONG
        has_option = any(word[:2] == "--" for word in asked)
        is_long |= is_several and not has_option
        is_better = is_free and (is_long or not _is_clear(error, words, has_answers))
        raise (problem if is_better else error) from None
    is_same = call[0] == "convert" and is_sentence(asked) and is_conversion(asked)
    values = {input_of(word)[1] for word in found}
    is_same |= any(input_of(word)[1] not in values for word in inputs)
    if is_same or not is_other(call, typed_words, error):
        raise error
    return *_for_check(call, options), assumptions_of(sentence, found)


def _is_understood(sentence: Sentence, asked: Words) -> bool:
    """Return whether words are more a sentence than a command, even if their call is refused."""
    named = [fact for fact in sentence.facts if fact.symbols]
    is_filled = any(fact.symbols != ("spectrum",) for fact in named)
    has_unit = len(named) > 1  # ev 9 iso 400
    has_unit |= is_filled and any(goal.unit for goal in sentence.goals)
    has_unit |= any(one.amount and one.amount.dimension != NUMBER for one in sentence.facts)
    is_long = len(sentence.facts) + len(sentence.goals) > 1 or len(asked) > SHORT
    return bool(sentence.files) or (has_unit and is_long)


def as_call(
    words: Words,
    error: errors.RadcalcError | click.UsageError,
    has_answers: Callable[[errors.RadcalcError, Words], bool],
) -> Words:
    """Return the call, with its options, that a refused call means as a sentence.

    Raises the error of the call if it is none.
    """
    from radcalc.cli.refusals import of_click

    problem = of_click(error, words) if isinstance(error, click.UsageError) else error
    if not may_be(words, problem):
        raise problem from None
    call, options, _ = call_meant(words, problem, has_answers)
    return [*call, *options]


def _answer(call: Words, options: Words, assumed: Words, gate: Gate) -> int:
    """Run the call of a sentence; write one result with its unit, and then the call."""
    values = values_of(options, gate.listener)
    if "-g" in call and _has_unit(values):
        results = hear([*call, *STEPS.spellings] if values[STEPS.parameter] else call)
        output = decide(**{name: values[name] for name in DEFAULTS}, listener=gate.listener)
        output.show([result._replace(named=False) for result in results])
        status = terminal.ANSWERED
    else:
        status = gate.run([*call, *options])
    settings = gate.listener.settings if gate.listener else None
    say([*call, *options], settings, assumed)
    return status


def _for_check(call: Words, options: Words) -> tuple[Words, Words]:
    """Return a call with the name of its result in an answer to check, in place of -g."""
    claim = values_of(options, None)["check"] if "-g" in call else None
    if claim is None:
        return call, options
    at = call.index("-g")
    name = call[at + 1].partition(":")[0]
    named = claim if "=" in claim else f"{name}={claim}"
    pairs = {claim: named, f"--check={claim}": f"--check={named}"}
    return [*call[:at], *call[at + 2 :]], [pairs.get(word, word) for word in options]


def options_of(
    words: Sequence[str], options_known: Sequence[Option] = OF_SENTENCES
) -> tuple[Words, Words]:
    """Return the words of a call, and its known options with their values."""
    known = {name: option for option in options_known for name in option.spellings}
    asked: Words = []
    options: Words = []
    rest = iter(words)
    for word in rest:
        name, equals, _ = word.partition("=")
        if name not in known:
            asked.append(word)
            continue
        options.append(word)
        if known[name].form != FLAG and not equals:
            options += [value for value in [next(rest, None)] if value is not None]
    return asked, options


def inputs_of(words: Sequence[str]) -> tuple[Words, Words]:
    """Return the words of a call, and its inputs NAME=VALUE in place of their options."""
    asked: Words = []
    inputs: Words = []
    rest = iter(words)
    for word in rest:
        name, equals, value = word.removeprefix("--").partition("=")
        symbol = SYMBOLS.get(name) if word[:2] == "--" else None
        if symbol is None:
            asked.append(word)
        else:
            text = value if equals or symbol.form == FLAG else next(rest, "")
            inputs.append(f"{name}={text}")
    return asked, inputs


def _of_file(words: Sequence[str]) -> Sequence[Option]:
    """Return the options of the command that the file of a sentence means, except -g."""
    path = next(filter(os.path.isfile, words), "")
    try:
        command = route(path)[0] if path and words[0] not in COMMANDS else ""
    except errors.RadcalcError:
        return ()
    own = page_of(command).options.values() if command else ()
    return [row for rows in own for row in rows if row != GET]


def values_of(options: Words, listener: "Listener | None") -> dict[str, Any]:
    """Return the values of the options of the output; a listener has those of all lines."""
    nothing = click.Command(None, params=[*map(option_of, OF_SENTENCES)], add_help_option=False)
    settings = dict(listener.settings) if listener else {}
    return nothing.make_context("", list(options), default_map=settings).params


def _has_unit(values: Mapping[str, Any]) -> bool:
    """Return whether a result keeps its unit with these values of options."""
    default = {**DEFAULTS, STEPS.parameter: False, **dict.fromkeys(row.parameter for row in CHECKS)}
    default |= {"format_": PLAIN} if values["format_"] == PLAIN else {}
    return {name for name, value in values.items() if value != default[name]} <= PLAIN_OPTIONS


EXAMPLE = "20000 cd at 8 m to lx"
Rows = list[dict[str, str]]


def explain(words: Words, listener: "Listener | None" = None) -> int:
    """Write how a call without a command is read; do not answer it."""
    output, records = explained(words, listener)
    output.records(records, (JSON,))
    return terminal.ANSWERED


def explained(words: Words, listener: "Listener | None" = None) -> tuple[Output, Records]:
    """Return how a call without a command is read, with the options of the output."""
    asked, options = options_of([word for word in words if word != EXPLAIN])
    if not asked:
        raise UsageError("a sentence is missing", call(*EXAMPLE.split()))
    if asked[0] in COMMANDS:
        raise UsageError(f"{EXPLAIN} does not apply to {asked[0]}", drop(EXPLAIN))
    values = values_of(options, listener)
    others = {name: values.pop(name) for name in ("steps", *[row.parameter for row in CHECKS])}
    output = decide(**values, command="explain", listener=listener)
    refuse_number_options(output, EXPLAIN)
    for name, value in others.items():
        if value:
            tries = [leave_out(name), drop(EXPLAIN)]
            raise UsageError(f"--{name} does not apply to {EXPLAIN}", tries)
    rows, notes, call_meant = _sentence(asked, _complete(asked))
    text = " ".join(asked)
    rows.append({"phrase": text, "meaning": pasted(call_meant)})
    return output, Records(rows, notes, rows, inputs=texts_of({"sentence": text}))


def _complete(asked: Words) -> Words | None:
    """Return the call that words are without being read as a sentence, or None."""
    if spelling.begins_with_file(asked):
        return spelling.call_of_file(asked) if all(word[:1] == "-" for word in asked[1:2]) else None
    if (other := spelling.canonical(asked)) != asked:
        return other
    whole = ["convert", *asked]
    try:
        _ = any(map(is_stream, asked)) or hear(whole)
    except (RadcalcError, click.UsageError):
        return None
    return whole


def _sentence(asked: Words, whole: Words | None) -> tuple[Rows, list[str], Words]:
    """Return what the phrases of a sentence become, notes, and the call that it means.

    The call is `whole` if the words are complete; their phrases are those of the same call.
    """
    try:
        sentence = read(asked)
        found = call_of(sentence)
    except RadcalcError:
        if whole:
            return [], [], whole
        raise
    call_meant = list(typed(found))
    if whole and plain(whole) != plain(call_meant):
        return [], [], whole
    rows = [
        {"phrase": phrase, "meaning": _spelled(part) if part in found else part}
        for phrase, part in parts_of(sentence, found)
    ]
    notes = [f"ignored: {', '.join(sentence.ignored)}"] if sentence.ignored else []
    return rows, notes, whole or call_meant


def _spelled(part: str) -> str:
    return " ".join(map(quoted, typed([part])))


def parts_of(sentence: Sentence, call: Sequence[str]) -> Iterator[tuple[str, str]]:
    """Yield each phrase with the part of the call that it becomes: operands or NAME=VALUE."""
    words = list(call[1:])
    for fact in sentence.facts:
        part = _part(fact, words)
        if input_of(part)[0]:
            words.remove(part)
        yield fact.typed, part
    for path in sentence.files:
        yield path, next(word for word in words if path in word)
    results = [word for word in words if input_of(word)[0] == "get"]
    operands = [word for word in words if not input_of(word)[0]]
    for goal in sentence.goals:
        yield goal.text, (*results, *operands[::-1])[0]


def _part(fact: Fact, words: Sequence[str]) -> str:
    """Return what a fact becomes: its option, the operand with its text, or several operands."""
    texts = (fact.text, one_word(fact))
    for word in words:
        name, value = input_of(word)
        if name and value in texts and (value or name in fact.symbols):
            return word
    return next((word for word in words if fact.text in word), fact.text)
