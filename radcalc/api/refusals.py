"""Errors in Python's spelling, with the calls that their hints propose."""

import sys
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from functools import wraps
from inspect import Parameter, signature
from typing import Any, ParamSpec, TypeVar

from radcalc.answer import in_short
from radcalc.api.arguments import is_quantity, magnitude_of, row_of, typed
from radcalc.api.spelling import Python, PythonHint, is_absent, keyword, symbol_name
from radcalc.calculators.missing import on_page
from radcalc.calculators.pages import SUMMARIES, page_of
from radcalc.errors import MOST, RadcalcError, Try, input_of, spell, with_correction
from radcalc.quantities.symbols import FLAG, SYMBOLS
from radcalc.units import table

P = ParamSpec("P")
T = TypeVar("T")
REFUSED = (RadcalcError, TypeError, ValueError, LookupError, AttributeError)  # a proposed call


def in_python(function: Callable[P, T]) -> Callable[P, T]:
    """Raise errors with keywords instead of options."""

    @wraps(function)
    def call(*args: P.args, **kwargs: P.kwargs) -> T:
        try:
            return function(*args, **kwargs)
        except RadcalcError as error:
            given = signature(function).bind_partial(*args).arguments | kwargs
            raise with_keywords(error, function, given) from None

    return call


def with_keywords(
    error: RadcalcError, function: Callable[..., Any], given: Mapping[str, Any]
) -> RadcalcError:
    """Return the error of a call with keywords, and with the calls that its hint proposes."""
    error = on_page(error, symbol_name(function.__name__))
    message, hint = spell(error.message, Python), spell(error.hint, PythonHint)
    if error.tries:
        hint = proposals(error, function, given) or hint
    return error.reworded(message, hint).with_traceback(error.__traceback__)


def proposals(error: RadcalcError, function: Callable[..., Any], given: Mapping[str, Any]) -> str:
    """Return the calls that an error's hint proposes, each with its results below it.

    Return '' if all are refused.  A call with an array is neither made nor shown.
    """
    lines = []
    for proposal in error.tries[:MOST]:
        with suppress(*REFUSED):
            words = proposal.words or _changed(proposal, function, given)
            results = _results(call_function(words), spell(proposal.remark, PythonHint))
            lines.append(f"{Python.command(*words)}\n     {results}")
    text = "\nor:  ".join(lines)
    if text and (others := error.others):
        help_ = Python.manual(symbol_name(function.__name__))
        text += f"\nor {', '.join(map(keyword, others))} ({help_})"
    return text


def _text_in_call(value: Any) -> str:
    """Return a single value as a text in a call; '' for True, the value of a flag."""
    is_single = isinstance(magnitude_of(value), (int, float))
    if not isinstance(value, str) and not is_single:
        raise TypeError
    return typed(value) if is_quantity(value) else "" if value is True else str(value)


def _changed(
    proposal: Try, function: Callable[..., Any], given: Mapping[str, Any]
) -> tuple[str, ...]:
    """Return the words of the user's call with a change: the command, operands and NAME=VALUE."""
    command = symbol_name(function.__name__)
    page = page_of(command if command in SUMMARIES else "convert")
    typed_texts = {
        key: _text_in_call(value) for key, value in given.items() if not is_absent(value)
    }
    arguments = dict(typed_texts)
    if proposal.instead:
        part, *correction = proposal.instead
        (name,) = [name for name, text in arguments.items() if part in text]
        arguments[name] = with_correction(arguments[name], part, " ".join(correction))
    for symbol in proposal.without:
        arguments.pop(keyword(symbol), None)
    for symbol, text in proposal.inputs:
        is_flag = symbol in SYMBOLS and SYMBOLS[symbol].form == FLAG
        arguments[keyword(symbol)] = "" if is_flag else text or page.symbol(symbol).example
    if arguments == typed_texts:
        raise LookupError
    operands = [
        arguments.pop(parameter.name)
        for parameter in signature(function).parameters.values()
        if parameter.kind == Parameter.POSITIONAL_OR_KEYWORD and parameter.name in arguments
    ]
    return command, *operands, *(f"{symbol_name(k)}={text}" for k, text in arguments.items())


def call_function(words: Sequence[str], in_core: bool = True) -> Any:
    """Call the function of a command with operands and NAME=VALUE, and return what it returns.

    Its error is that of the core, or that of Python with the calls that its hint proposes.
    """
    command, *others = words
    pairs = [input_of(word) for word in others]
    operands = [text for name, text in pairs if not name]
    inputs = {name: text for name, text in pairs if name}
    wanted = inputs.pop("get", "")
    arguments = {
        keyword(name): text or SYMBOLS[name].form == FLAG or page_of(command).symbol(name).example
        for name, text in inputs.items()
    }
    function = getattr(sys.modules["radcalc"], keyword(command), None)
    function = getattr(function, "__wrapped__", None) if in_core else function
    if function is None:
        raise LookupError
    found = function(*operands, **arguments)
    return _result(found, wanted) if wanted else found


def _result(found: Any, wanted: str) -> Any:
    """Return a result NAME[:UNIT] of those that a function returned; of each day, if by day."""
    if isinstance(found, dict):
        return {period: _result(result, wanted) for period, result in found.items()}
    name, _, unit = wanted.partition(":")
    quantity = getattr(found, keyword(name), None)
    if quantity is None:
        raise LookupError(f"the function has no result {keyword(name)}")
    unit, *_ = table.GROWERS_WORDS.get(unit.lower(), (unit,))  # of ppfd and dli, which are names
    return quantity.to(unit) if unit else quantity


def _results(found: Any, remark: str) -> str:
    """Return what a function returned in a line, with a remark; the first row of a list."""
    if isinstance(found, dict):  # by day
        return next(f"{day}: {_results(result, remark)}" for day, result in found.items())
    if isinstance(found, tuple):
        return str(found[0]).partition("\n")[0]
    if hasattr(found, "rows"):
        rows = [row._replace(name=keyword(row.name)) for row in found.rows if not row.given]
        return in_short(rows, True, remark)
    return in_short([row_of(found)], False, remark)
