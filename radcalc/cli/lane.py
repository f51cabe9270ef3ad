"""Calls that are answered without Click: every option is in full and once, and nothing is refused.

A sentence has no options.  Whatever else is typed is left to Click.
"""

from contextlib import suppress

from radcalc import errors, terminal
from radcalc.calculators import COMMANDS, SUMMARIES, page_of
from radcalc.cli.output import Output, decide
from radcalc.cli.request import Request
from radcalc.errors import RadcalcError, UsageError, input_of, is_wordy
from radcalc.quantities.symbols import CHOICE, FLAG, SYMBOLS
from radcalc.terminal import FORMATS
from radcalc.tuples import NamedTuple
from radcalc.units.numbers import are_uncertain, is_sentence

TYPE_CHECKING = False  # typing is slow to import
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    from radcalc.answer import Result

Words = list[str]
GET = ("-g", "--get")
# Options of the output without a value, and the parameters of `decide`.
OUTPUT = {
    "--json": "json_",
    "-n": "number",
    "--number": "number",
    "-q": "quiet",
    "--quiet": "quiet",
}
OF_LINES = {  # options for lines with a text as their value
    "--field": "field",
    "--column": "column",
    "-d": "delimiter",
    "--delimiter": "delimiter",
    "--add": "add",
    "--rename": "rename",
}


class Call(NamedTuple):
    """The words of a call: operands, inputs, results, and options of the output and of lines."""

    operands: list[str]
    given: "dict[str, Any]"
    wanted: list[str]
    of_output: "dict[str, Any]"
    of_lines: dict[str, str]


def answer(words: Words) -> int | BaseException | None:
    """Answer a sentence, or a call of a calculator, without Click; None for whatever is left."""
    if len(words) > 1 and words[0] not in COMMANDS and not any(map(_is_option, words)):
        return None if is_wordy(words) else answer_sentence(words)
    return answer_in_full(words) if words and words[0] in SUMMARIES else None


def _is_option(word: str) -> bool:
    """Return whether a word is an option, a negative number or a stream, or has an option in it."""
    return (word.lstrip()[:1] == "-" and word != "->") or " -" in word


def answer_in_full(words: "Sequence[str]") -> int | BaseException | None:
    """Answer a calculator, or lines of standard input by `convert`; return the exit status.

    Return None for a command with options of its own, for other words, and for whatever is refused:
    nothing is written before all results are known.  Return the error of lines that are refused:
    some may be read and written.
    """
    name = words[0]
    try:
        call = _read(words)
        output = decide(**call.of_output, command=name)
        is_stream = name == "convert" and call.operands[:1] == ["-"]
        if is_stream and not (call.given or call.wanted):
            return _convert_lines(call, output)
        # a conversion without conditions was tried before
        is_other = name == "convert" and (call.wanted or not call.given)
        if is_stream or is_other or call.of_lines:
            return None
        if work_out(name, call.operands, call.given, call.wanted, output):
            return terminal.ANSWERED
        return None
    except errors.OutputError as error:  # a full disk
        return terminal.complain(error)
    except Exception:  # an error or a bug, which the boundary reports
        return None


def _read(words: "Sequence[str]") -> Call:
    """Read the words of a call; raise ValueError for those that need Click."""
    name, *rest = words
    call = Call([], {}, [], {}, {})
    page = page_of(name)
    following = iter(rest)
    for word in following:
        symbol = word.removeprefix("--")
        if word in OUTPUT:
            call.of_output[OUTPUT[word]] = True
        elif word == "--format" and "format_" not in call.of_output:
            call.of_output["format_"] = FORMATS[FORMATS.index(next(following))]
        elif word in GET:
            call.wanted.append(_value(next(following)))
        elif word in OF_LINES and OF_LINES[word] not in call.of_lines:
            call.of_lines[OF_LINES[word]] = _value(next(following))
        elif symbol == word and page.operand:
            call.operands.append(word if word == "-" else _value(word))
        elif symbol in call.given or not page.accepts(symbol) or SYMBOLS[symbol].form == CHOICE:
            raise ValueError(word)
        else:
            call.given[symbol] = SYMBOLS[symbol].form == FLAG or _value(next(following))
    return call


def _value(word: str) -> str:
    """Return a word that is certainly a value: not an option, a stream or a negative number."""
    if not word or word.lstrip()[:1] == "-":
        raise ValueError(word)
    return word


def _convert_lines(call: Call, output: Output) -> int | BaseException:
    """Convert the lines of standard input; return the exit status, or the error."""
    from radcalc.cli import streams
    from radcalc.cli.request import Case, LineOptions

    typed: dict[str, Any] = dict.fromkeys(LineOptions._fields) | call.of_lines
    try:
        return streams.convert(call.operands, LineOptions(**typed), [Case({})], False, output)
    except BaseException as error:
        return error


def work_out(
    name: str,
    operands: "Sequence[str]",
    given: "dict[str, Any]",
    wanted: "Sequence[str]",
    output: Output,
) -> bool:
    """Write the answers of a calculator or of `convert` to typed inputs; return whether it can."""
    if name == "convert":
        from radcalc.calculators.convert import PAGE
        from radcalc.cli.conversions import conversions, show
        from radcalc.cli.request import cases

        show(conversions([*operands], cases(given, False, bare=PAGE.bare)), given, False, output)
        return True
    from radcalc.calculators.results import listed_in
    from radcalc.cli.calculator import answerer

    answer_in_full = answerer(name)
    if answer_in_full:
        answer_in_full(
            typed=given, request=Request(listed_in(wanted)), output=output, words=tuple(operands)
        )
    return answer_in_full is not None


def answer_sentence(words: Words) -> int | None:
    """Answer words that are a sentence, as the command that they mean; return the exit status.

    Return None for a conversion, and for whatever is refused.
    """
    try:
        if not _is_refused(words):
            return None
        from radcalc.cli.spelling import say, typed
        from radcalc.sentences.calls import call_of
        from radcalc.sentences.reader import read
        from radcalc.sentences.used import assumptions_of

        sentence = read(words)
        call = call_of(sentence)
        if not is_other(list(typed(call)), words):
            return None
        results = _results(call)
        if not results:
            return None
        output = decide()
    except Exception:  # an error or a bug, which the boundary reports
        return None
    try:
        output.show(results)
    except RadcalcError as error:  # a full disk
        return terminal.complain(error)
    say([*typed(call)], assumptions=assumptions_of(sentence, call))
    return terminal.ANSWERED


def _is_refused(words: Words) -> bool:
    """Return whether no command takes the words as they are, so that they may be a sentence."""
    from radcalc.cli.spelling import begins_with_file
    from radcalc.conversion.operands import read_lists, read_operands

    if not is_sentence(words):
        return not begins_with_file(words)
    (operands,), *others = read_lists(words)
    try:
        return not (others or read_operands(operands))
    except errors.ExpressionError:
        return are_uncertain(words)
    except errors.SeveralReadings:
        return False
    except RadcalcError:
        return True


def is_other(call: "Sequence[str]", asked: "Sequence[str]", error: object = None) -> bool:
    """Return whether the call of a sentence is another one than the words that were typed."""
    has_more = "unexpected argument" in getattr(error, "message", "")
    is_same = plain(call) == plain(asked) and not isinstance(error, errors.TooManyWords)
    return not is_same and (asked[0] != call[0] or has_more)


def plain(words: "Sequence[str]") -> str:
    """Return the words of a call without what may be left out."""
    text = " ".join(words).removeprefix("convert ")
    parts = text.replace("->", " ").replace("=", " ").replace(",", " ").split()
    return "".join([part for part in parts if part not in ("to", "in", "as", "→")])


def _results(call: "Sequence[str]") -> "Sequence[Result]":
    """Return the answers to a call of a calculator or of `convert`; none for other commands."""
    name, *words = call
    operands = [text for symbol, text in map(input_of, words) if not symbol]
    given: dict[str, Any] = {}
    wanted: list[str] = []
    for symbol, text in map(input_of, words):
        if symbol == "get":
            wanted.append(text)
        elif symbol in given:  # refused by the command
            return ()
        elif symbol and SYMBOLS[symbol].form != CHOICE:
            given[symbol] = SYMBOLS[symbol].form == FLAG or text
        elif symbol:
            return ()
    listener = Hearer()
    with suppress(Heard):
        work_out(name, operands, given, wanted, decide(command=name, listener=listener))
    results = listener.results
    return [result._replace(named=False) for result in results] if wanted else results


if TYPE_CHECKING:
    from radcalc.homework.question import Question


class Heard(RadcalcError):
    """The end of a command whose answer was heard, and is not written."""


class Hearer:
    """A listener that keeps an answer, and ends the command before it writes."""

    def __init__(self) -> None:
        self.settings: dict[str, Any] = {}
        self.results: Sequence[Result] = ()

    def hear(self, results: "Sequence[Result]") -> None:
        self.results = results
        raise Heard("")

    def ask(self, question: "Question") -> None:
        """Let a question be answered: the right answer is heard."""


class Examiner(Hearer):
    """A listener that keeps a question, and ends the command before an answer is judged."""

    question: "Question | None" = None

    def ask(self, question: "Question") -> None:
        self.question = question
        raise Heard("")


class Asked(NamedTuple):
    """The question that a call answers, the result NAME[:UNIT] that it asks for, its tolerance."""

    question: "Question"
    wanted: str
    tolerance: str | None


def hear(words: "Sequence[str]") -> "Sequence[Result]":
    """Return the answers to a call, or none for one that lists or writes; raise its error."""
    from radcalc.cli.command import commands, protect_negatives  # with Click

    listener = Hearer()
    protected = protect_negatives(list(words))
    with suppress(Heard), commands.make_context("radcalc", protected, obj=listener) as context:
        commands.invoke(context)
    return listener.results


def asked(words: "Sequence[str]") -> Asked:
    """Return the question that a call answers; raise its error.

    The call is parsed as always, and its check is then one whose answer is never read.
    """
    from radcalc.cli.command import commands, context, protect_negatives  # with Click

    examiner = Examiner()
    top = context(examiner)
    name, command, rest = commands.resolve_command(top, protect_negatives(list(words)))
    assert command is not None
    with command.make_context(name, rest, parent=top) as call:
        params = call.params
        several = params.get("wanted", ())
        if params.get("check") is not None or len(several) > 1:
            problem = "several results" if len(several) > 1 else "an answer in its command"
            raise UsageError(f"a question cannot have {problem}", "one -g, and no --check")
        wanted, tolerance = "".join(several), params.get("tolerance")
        if several:
            params["wanted"] = ()
        params["check"] = f"{wanted.partition(':')[0]}=?"
        with suppress(Heard):
            command.invoke(call)
    if examiner.question is None:
        raise UsageError("a question needs one answer", "a command with one answer")
    return Asked(examiner.question, wanted, tolerance)
