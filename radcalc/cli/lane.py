"""Sentences that are answered without Click: they have no options, and nothing is refused."""

from contextlib import suppress

from radcalc import terminal
from radcalc.cli.files import begins_with_file, say
from radcalc.cli.heard import Heard, Listener
from radcalc.cli.output import decide
from radcalc.cli.plain_call import work_out
from radcalc.cli.spelling import typed
from radcalc.errors import ExpressionError, RadcalcError, TooManyWords, input_of
from radcalc.quantities.symbols import CHOICE, FLAG, SYMBOLS
from radcalc.sentences.calls import call_of
from radcalc.sentences.reader import read
from radcalc.sentences.used import assumptions_of
from radcalc.units.numbers import is_sentence
from radcalc.units.ranges import read_lists
from radcalc.units.reading import read_operands

TYPE_CHECKING = False  # typing is slow to import
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    from radcalc.answer import Result

Words = list[str]


def answer_sentence(words: Words) -> int | None:
    """Answer words that are a sentence, as the command that they mean; return the exit status.

    Return None for a conversion, and for whatever is refused.
    """
    try:
        if not _is_refused(words):
            return None
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
    say([*typed(call)], assumptions=assumptions_of(call))
    return terminal.ANSWERED


def _is_refused(words: Words) -> bool:
    """Return whether no command takes the words as they are, so that they may be a sentence."""
    if not is_sentence(words):
        return not begins_with_file(words)
    (operands,), *others = read_lists(words)
    try:
        return not (others or read_operands(operands))
    except ExpressionError:
        return False
    except RadcalcError:
        return True


def is_other(call: "Sequence[str]", asked: "Sequence[str]", error: object = None) -> bool:
    """Return whether the call of a sentence is another one than the words that were typed."""
    has_more = "unexpected argument" in getattr(error, "message", "")
    is_same = plain(call) == plain(asked) and not isinstance(error, TooManyWords)
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
    listener = Listener()
    with suppress(Heard):
        work_out(name, operands, given, wanted, decide(command=name, listener=listener))
    results = listener.results
    return [result._replace(named=False) for result in results] if wanted else results
