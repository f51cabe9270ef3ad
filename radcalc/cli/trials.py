"""Calls that hints propose, made before they are shown: loaded only for an error."""

import math
import os
from collections.abc import Sequence
from contextlib import AbstractContextManager, nullcontext, suppress
from itertools import pairwise
from typing import Any, NamedTuple

import click

from radcalc import errors, terminal
from radcalc.answer import Row, in_short, remark_on
from radcalc.calculators import SUMMARIES, page_of
from radcalc.cli.command import (
    called_in,
    commands,
    context,
    parameters,
    protect_negatives,
    with_plot,
)
from radcalc.cli.lane import hear
from radcalc.cli.request import is_stream
from radcalc.cli.spelling import EXPLAIN, HELP_NAMES, Shell, pasted, spelled, typed
from radcalc.errors import quote
from radcalc.quantities.symbols import FLAG, SYMBOLS
from radcalc.units.ranges import size_of

Words = list[str]
ANSWERS = 100  # of a call that is made
LONG = ("scene",)  # commands with many answers
CELLS = 4096  # of its integral
LARGEST = 1 << 20  # bytes of the files of a call that is made
IN_SHORT = {"get": "-g", "number": "-n"}
TURNED = ("incidence", "tilt")  # angles that are 0 if they are left out
WITHOUT_VALUE = ("header", "plot")  # options whose value may be omitted
# Options of calls that write, draw or list.
WITH_EFFECTS = ("--plot", "--save", "--irradiance-map", "--list")
UNTRIED = ("--auto", "--invalid", *WITH_EFFECTS)


class Trial(NamedTuple):
    """A call that a hint proposes, with the results that it has in addition if it was made."""

    words: Words
    remark: str
    rows: Sequence[Row] = ()

    @property
    def command(self) -> str:
        """Return the call as it can be pasted at a shell."""
        return pasted(self.words)

    @property
    def outcome(self) -> str:
        """Return the first results, with their names unless the call names them."""
        named = called_in(self.words) != "convert" and "-g" not in self.words
        return in_short(self.rows, named, spelled(self.remark))

    def answered(self) -> "Trial":
        """Return the trial with its results; raise the error of a call that is refused.

        A call with an answer to check is made without it, and shows no result.
        """
        words, _ = _without(self.words, "--check", {})
        has_check = len(words) < len(self.words)
        words = _without(words, "--tolerance", {})[0] if has_check else words
        try:
            with _limits(words):
                rows = _results(words) if _is_short(words) else ()
        except (errors.RadcalcError, click.UsageError) as error:
            from radcalc.cli import sentence

            rows = _results(sentence.as_call(words, error, lambda *_: False))
        return self._replace(rows=() if has_check else rows)

    def record(self) -> dict[str, Any]:
        """Return the fields of JSON."""
        first = [{"value": row.value, "unit": row.unit} for row in self.rows[:1]]
        record: dict[str, Any] = {"command": self.command}
        if self.remark:
            record["remark"] = spelled(self.remark)
        with suppress(errors.RadcalcError):  # a stream has no call in Python
            record["call"] = _in_python(self.words)
        return record | dict(*first)


def _limits(words: Words) -> AbstractContextManager[None]:
    """Return the limits of the work of a call that is made for a hint."""
    if called_in(words) != "integrate":
        return nullcontext()
    from radcalc.geometry.numerics.cubature import at_most

    return at_most(CELLS)


def refuse(error: errors.RadcalcError, words: Words) -> int:
    """Write an error with the calls that its hint proposes; return the exit status."""
    shown = [] if errors.is_wordy(words) else trials(error, words)
    if "--json" in words or " --format json" in f" {' '.join(words)}".replace("=", " "):
        from radcalc.render.json import refusal

        message, hint = error.spelled(Shell)
        with suppress(errors.OutputError):  # often the error itself
            terminal.write(refusal(error, message, hint, [trial.record() for trial in shown]))
    hints = lines(error, words, shown) if shown else None
    if error.tries and not shown and (errors.is_wordy(words) or is_refused(error, words)):
        hints = [f"try: {' '.join(filter(None, ['radcalc', called_in(words), '--help']))}"]
    return terminal.complain(error, Shell, hints)


def trials(error: errors.RadcalcError, words: Words) -> list[Trial]:
    """Return the calls that the hint of an error proposes, without those that are refused.

    If all are refused because one more input is missing, return them with that input.
    """
    made: list[Trial] = []
    lacking: list[tuple[Trial, errors.RadcalcError, int]] = []
    given = _pairs(words)
    for way, proposal in enumerate(error.tries[: errors.MOST]):
        call = changed(words, proposal)
        if call is None or call in (words, *(trial.words for trial in made)):
            continue
        if not all(map(str.isprintable, call)):  # cannot be pasted
            continue
        trial = Trial(call, remark_on(proposal, _pairs(call), given))
        try:
            answered = trial.answered()
            if answered.rows and not trial.remark and not isinstance(error, errors.Exclusive):
                answered = answered._replace(remark=_turned(proposal))
            made.append(answered)
        except errors.RadcalcError as further:
            if "definitions" in dict(proposal.inputs):  # a word of theirs is not another unit
                continue
            if proposal.inputs or not proposal.without or isinstance(error, errors.Exclusive):
                lacking.append((trial, further, way))
    if made:
        return made
    completed = [one for refused in lacking for one in _completed(*refused)]
    unique: dict[tuple[str, ...], Trial] = {}
    for trial in completed:
        unique.setdefault(tuple(trial.words), trial)
    return sorted(unique.values(), key=lambda trial: len(trial.words))


def _turned(proposal: errors.Try) -> str:
    """Return the remark on an angle that is left out, and is 0 then."""
    turned = [name for name in proposal.without if name in TURNED and not proposal.inputs]
    return f"at {errors.option(turned[0], '0deg')}" if turned else ""


def _pairs(words: Words) -> list[tuple[str, str]]:
    """Return the inputs of a call by name, and its other words but options."""
    pairs = []
    rest = iter(words)
    for word in rest:
        name, equals, value = word.removeprefix("--").partition("=")
        if word[:2] != "--" and word != "-g":
            pairs.append(("", word))
        elif word == "-g" or name in SYMBOLS:
            is_whole = equals or (name in SYMBOLS and SYMBOLS[name].form == FLAG)
            pairs.append((name, value if is_whole else next(rest, "")))
    return pairs


def has_answers(error: errors.RadcalcError, words: Words) -> bool:
    """Return whether a call that the hint of an error proposes has an answer."""
    return any(trial.rows for trial in trials(error, words))


def _completed(trial: Trial, further: errors.RadcalcError, way: int) -> list[Trial]:
    """Return a refused call with what it lacks, if it is answered then."""
    is_sentence = called_in(trial.words) in ("", "convert")
    if (
        is_sentence
        and isinstance(further, errors.SeveralReadings)
        and all(one.words for one in further.tries)
    ):
        readings = []
        for one in further.tries[: errors.MOST]:
            with suppress(errors.RadcalcError):
                readings.append(Trial([*typed(one.words)], one.remark).answered())
        return readings
    for _ in range(errors.MOST - 1):
        added = [one for one in further.tries if one.inputs and not one.without]
        added = [one for one in added if trial.words.count(f"--{one.inputs[0][0]}") < 2]
        if not added:  # another word of the same kind: 1/2 m + 1/2 m
            added = [one for one in further.tries[way:] if one.instead]
        call = changed(trial.words, added[0]) if added else None
        if call is None or call == trial.words:
            return []
        example = remark_on(added[0], _pairs(call), _pairs(trial.words))
        remark = ", ".join(dict.fromkeys(filter(None, [trial.remark, example])))
        trial = Trial(call, remark)
        try:
            return [trial.answered()]
        except errors.RadcalcError as error:
            further = error
    return []


def is_refused(error: errors.RadcalcError, words: Words) -> bool:
    """Return whether the hint is nothing but calls that are refused themselves."""
    calls = [changed(words, proposal) for proposal in error.tries]
    return all(calls) and error.hint == " or ".join(map(str, error.tries))


def lines(error: errors.RadcalcError, words: Words, shown: Sequence[Trial]) -> list[str]:
    """Return the lines of a hint: calls, each with its answer below it, and further options."""
    texts = []
    for start, trial in zip(("try: ", *["or:  "] * len(shown)), shown, strict=False):
        texts.append(start + trial.command)
        if outcome := trial.outcome:
            texts.append("     " + outcome)
    if others := [f"--{name}" for name in error.others]:
        texts.append(f"or {', '.join(others)} (radcalc {called_in(words)} --help)")
    words_instead = [" ".join(one.instead[1:]) for one in error.tries[errors.MOST :]]
    if further := list(filter(None, dict.fromkeys(words_instead))):
        texts.append(f"or {errors.listed(further)}")
    return texts


def _results(words: Words) -> list[Row]:
    """Make a call without writing anything, and return the results that it has in addition."""
    rows = [row for result in hear(words) for row in result.rows]
    return [row for row in rows if "-g" in words or not row.given]


def changed(words: Words, proposal: errors.Try) -> Words | None:
    """Return the words of a call as a hint proposes, or None if they cannot be changed so."""
    if proposal.words:
        return list(typed(proposal.words))
    call = list(words)
    if proposal.instead:
        corrected = _corrected(call, *proposal.instead)
        if corrected is None:
            return None
        call = corrected
    command = called_in(call)
    known = {name: p for p in parameters(command) for name in p.opts}
    for name in proposal.without:
        call, _ = _without(call, f"--{name}", known)
    operand = page_of(command).operand if command in SUMMARIES else None
    for name, value in proposal.inputs:
        if operand and operand.name == name and call[:1] == [command]:
            call.insert(1, value)
            continue
        option = known.get(f"--{name}")
        added = _as_typed(command, option, name, value) if option else []
        if not added:
            return None
        call, place = _without(call, f"--{name}", known)
        call[place:place] = added
    asked = [after.partition(":")[0] for word, after in pairwise(call) if word == "-g"]
    if any(name in asked for name, _ in proposal.inputs):
        return None
    return _once(call) or None


def _as_typed(command: str, option: click.Parameter, name: str, value: str) -> Words:
    """Return an option with its value, or the example of its symbol; no words without either."""
    word = IN_SHORT.get(name, f"--{name}")
    if getattr(option, "is_flag", False) or (name in WITHOUT_VALUE and not value):
        return [word]
    value = value.replace(errors.MINUS, "-") or _example(command, name)
    return [word, value] if value else []


def _once(call: Words) -> Words:
    """Return a call without results that it asks for twice: -g x -g x."""
    kept: Words = []
    for word in call:
        if kept[-1:] == ["-g"] and ("-g", word) in pairwise(kept):
            kept.pop()
        else:
            kept.append(word)
    return kept


def _corrected(call: Words, *texts: str) -> Words | None:
    """Replace a word, a part of a word, or several words, by others."""
    call = [_as_message(word) for word in call]
    typed, *others = map(_as_message, texts)
    if not others:
        places = [k for k, word in enumerate(call) if word == typed]
        return [*call[: places[-1]], *call[places[-1] + 1 :]] if places else None
    correction, *more = others
    if "±" in typed:
        from radcalc.units.uncertain import signed

        call = [signed(word) for word in call]
    places = [k for k, word in enumerate(call) if typed in word]
    exact = [k for k in places if call[k] == typed]
    if not places:
        return _joined(call, typed, correction, *more)
    k = (exact or places)[0]
    return [*call[:k], errors.with_correction(call[k], typed, correction), *more, *call[k + 1 :]]


def _as_message(text: str) -> str:
    return text.replace(errors.MINUS, "-")


def _joined(call: Words, typed: str, correction: str, *more: str) -> Words | None:
    """Replace several words, such as a unit of several words, by others."""
    for count in range(2, len(call) + 1):
        for k in range(len(call) - count + 1):
            text = " ".join(call[k : k + count])
            if typed in text:
                return [*call[:k], text.replace(typed, correction), *more, *call[k + count :]]
    return None


def _without(call: Words, name: str, known: dict[str, click.Parameter]) -> tuple[Words, int]:
    """Return a call without an option, and the place of the option in it, by default its end."""
    kept: Words = []
    skipped, place = False, 0
    for word in with_plot(call) if name == "--plot" else call:
        option, equals, _ = word.partition("=")
        if skipped:
            skipped = False
        elif option == name or (option in known and known[option] is known.get(name)):
            is_flag = getattr(known.get(option), "is_flag", False)
            skipped = not (equals or is_flag or option == "--header")
            place = place or len(kept)
        else:
            kept.append(word)
    return kept, place or len(kept)


def _example(command: str, name: str) -> str:
    symbol = page_of(command).symbol(name) if command in SUMMARIES and name in SYMBOLS else None
    return symbol.example if symbol else ""


def _is_short(words: Words) -> bool:
    """Return whether a call can be tried; raise Click's error if its options are wrong.

    A call that reads standard input or a large file, or writes one, or works long, is not tried.
    """
    command = called_in(words)
    values = pairwise([*words, ""])  # with --invalid ignore a call writes no errors
    options = [word.partition("=")[0] for word, value in values if value != terminal.IGNORE]
    if {*words} & {*HELP_NAMES, "help", "--version"}:
        return False
    if EXPLAIN in words:
        from radcalc.cli.sentence import explained

        return not explained(words)
    is_quick = command in SUMMARIES and command not in LONG and not {*options} & {*UNTRIED}
    if not is_quick or reads_stdin(words) or is_long(words):
        top = context()
        name, found, rest = commands.resolve_command(top, protect_negatives(words))
        if found:
            found.make_context(name, rest, parent=top)
        return False
    paths = {path for word in words for path in _paths(word) if os.path.exists(path)}
    paths.discard(os.devnull)  # in place of a file of definitions
    return all(map(os.path.isfile, paths)) and sum(map(os.path.getsize, paths)) <= LARGEST


def reads_stdin(words: Words) -> bool:
    """Return whether a word is or has standard input: -, '- lx', nm:-."""
    return any(is_stream(word.rpartition(":")[2]) for word in words)


def refuse_effects(words: Words) -> None:
    """Refuse a call that does anything but answer: one that writes, lists or reads a pipe.

    Short options in one word are refused too, since one of them may ask for help.
    """
    command = called_in(words)
    if command and command not in SUMMARIES:
        problem = f"radcalc {command} has no answer to check"
        raise errors.UsageError(problem, "a calculator or a conversion")
    for word in words:
        name = word.partition("=")[0]
        is_joined = word[:1] == "-" != word[1:2] and len(word) > 2
        if name in (*WITH_EFFECTS, *HELP_NAMES, "--version", EXPLAIN) or (
            is_joined and protect_negatives([word]) == [word]
        ):
            problem = f"{quote(word)} cannot be used in a question"
            raise errors.UsageError(problem, errors.drop(word) if len(words) > 1 else "a command")
        if reads_stdin([word]) or _is_special(word):
            problem = f"{quote(word)} is not a value or a regular file"
            raise errors.UsageError(problem, "a value or a file's name")


def _is_special(word: str) -> bool:
    """Return whether a word is, or has, a pipe, a terminal or another device."""
    return any(os.path.exists(t) and not os.path.isfile(t) for t in _paths(word) if "/" in t)


def is_long(words: Words) -> bool:
    """Return whether a call has many answers, which take long."""
    return math.prod([size_of(word.rpartition("=")[2]) for word in words]) > ANSWERS


def _paths(word: str) -> Words:
    """Return the parts of a word that may be a path: --spectrum=FILE, nm:FILE, FILE:COLUMN."""
    texts = [word, word.partition("=")[2]]
    texts += [text.partition(":")[2] for text in texts]
    return list(filter(None, (*texts, *[text.rpartition(":")[0] for text in texts])))


def _in_python(words: Words) -> str:
    """Return a call in Python."""
    from radcalc.api.arguments import Python

    command = called_in(words)
    known = {name: p for p in parameters(command) for name in p.opts}
    operands: Words = []
    given: Words = []
    rest = iter([word for word in words if word != command])
    for word in rest:
        name, equals, value = word.partition("=")
        if name not in known:
            operands.append(word)
        elif known[name].name in ("format_", "json_", "quiet", "steps", "definitions"):
            _ = "" if equals or getattr(known[name], "is_flag", False) else next(rest, "")
        else:
            is_flag = getattr(known[name], "is_flag", False)
            value = value if equals or is_flag else next(rest, "")
            given.append(f"{'get' if name == '-g' else name.removeprefix('--')}={value}")
    if command == "convert":
        from radcalc.conversion.operands import read_operands

        amount, target = read_operands(operands)
        operands = [amount.text, target]
    return Python.command(command, *operands, *given)
