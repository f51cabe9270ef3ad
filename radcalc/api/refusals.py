"""Errors in Python's spelling, with the calls that their hints propose."""

import re
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import suppress
from functools import wraps
from inspect import Parameter, signature
from typing import Any, ParamSpec, TypeVar

import numpy

from radcalc.api.quantity import (
    Quantity,
    in_short,
    is_lazy,
    is_quantity,
    magnitude_of,
    unit_of,
)
from radcalc.api.reading import is_absent, library_of
from radcalc.api.spelling import Python, PythonHint, keyword, symbol_name
from radcalc.calculators.missing import on_page
from radcalc.calculators.page import Page
from radcalc.calculators.pages import SUMMARIES, page_of
from radcalc.errors import MOST, RadcalcError, Try, input_of, nearest, spell, with_correction
from radcalc.quantities.symbols import FLAG, SYMBOLS
from radcalc.quantities.synonyms import meant
from radcalc.units import horticulture

P = ParamSpec("P")
T = TypeVar("T")
QUICK, LISTED = 1000, 6  # elements of an array in a call that is made, and that are shown
SIMPLE = (str, int, float, bool, type(None))


def in_python(function: Callable[P, T]) -> Callable[P, T]:
    """Raise errors with keywords instead of options."""

    @wraps(function)
    def call(*args: P.args, **kwargs: P.kwargs) -> T:
        try:
            return function(*args, **kwargs)
        except RadcalcError as error:
            given = signature(function).bind_partial(*args).arguments | kwargs
            raise spelled(error, function, given) from None

    return call


def spelled(
    error: RadcalcError, function: Callable[..., Any], given: Mapping[str, Any]
) -> RadcalcError:
    """Return the error of a call with keywords, and with the calls that its hint proposes."""
    error = on_page(error, symbol_name(function.__name__))
    message, hint = spell(error.message, Python), spell(error.hint, PythonHint)
    if error.tries:
        hint = calls(error, function, given) or hint
    return error.reworded(message, hint).with_traceback(error.__traceback__)


def misspelt(function: Callable[..., Any], args: tuple[Any, ...], kwargs: Mapping[str, Any]) -> str:
    """Return the hint for a keyword that a function does not have, or ''.

    It is a similar keyword, a choice of the operand (`sphere=True`), or a result (`rgb=True`).
    """
    parameters = signature(function).parameters
    wrong = next((name for name in kwargs if name not in parameters), "")
    typed, known = symbol_name(wrong), [*map(symbol_name, parameters)]
    names = wrong and (meant(typed, known) or nearest(typed, known, cutoff=0.7))
    corrected = [
        {name if key == wrong else key: value for key, value in kwargs.items()}
        for name in map(keyword, names[:MOST])
    ]
    rest = {key: value for key, value in kwargs.items() if key != wrong}
    page = _page(function)
    if page.operand and typed in page.operand.choices and page.operand.name in parameters:
        corrected.insert(0, {page.operand.name: typed, **rest})
    hints = []
    for arguments in corrected:
        if not all(map(_is_quick, (*args, *arguments.values()))):
            continue
        with suppress(RadcalcError, TypeError):
            answer = function(*args, **arguments)
            hints.append(with_answer(_call(function, args, arguments), answer))
    results = [
        f"{_call(function, args, rest)}.{keyword(name)}"
        for name in (*page.light, *page.others, *page.on_request)
        if typed and typed in name
    ]
    hints = hints or [*map(keyword, names)] or results[:MOST]
    return "\ntry: " + "\nor:  ".join(hints) if hints else ""


def _page(function: Callable[..., Any]) -> Page:
    command = symbol_name(function.__name__)
    return page_of(command if command in SUMMARIES else "convert")


def calls(error: RadcalcError, function: Callable[..., Any], given: Mapping[str, Any]) -> str:
    """Return the calls that an error's hint proposes, each with its answer below it.

    Return '' if none is answered, or if the user's call may take long.
    """
    if not all(map(_is_quick, given.values())):
        return ""
    texts = []
    for proposal in error.tries[:MOST]:
        try:
            call, answer = (
                other_call(proposal) if proposal.words else _changed(proposal, function, given)
            )
        except (RadcalcError, TypeError, ValueError, LookupError):
            continue
        texts.append(with_answer(call, answer, spell(proposal.remark, PythonHint)))
    if texts and (others := error.others):
        help_ = Python.manual(symbol_name(function.__name__))
        return "\nor:  ".join(texts) + f"\nor {', '.join(map(keyword, others))} ({help_})"
    return "\nor:  ".join(texts)


def _changed(
    proposal: Try, function: Callable[..., Any], given: Mapping[str, Any]
) -> tuple[str, Any]:
    """Make the user's call with a change; return it as a text, and its answer."""
    page = _page(function)
    arguments = {name: value for name, value in given.items() if not is_absent(value)}
    if proposal.instead:
        typed, correction = proposal.instead[0], " ".join(proposal.instead[1:])
        (name,) = [name for name, value in arguments.items() if typed in str(value)]
        arguments[name] = with_correction(str(arguments[name]), typed, correction)
    if not (proposal.instead or proposal.without or proposal.inputs):
        raise LookupError
    for symbol in proposal.without:
        arguments.pop(keyword(symbol), None)
    for symbol, value in proposal.inputs:
        is_flag = symbol in SYMBOLS and SYMBOLS[symbol].form == FLAG
        numbers = arguments.pop(keyword(symbol), None)
        if isinstance(numbers, (list, tuple, numpy.ndarray)):  # the value is their unit
            arguments[keyword(symbol)] = Quantity(numpy.asarray(numbers), value)
        else:
            arguments[keyword(symbol)] = is_flag or value or page.symbol(symbol).example
    if all(isinstance(value, SIMPLE) for value in given.values()) and arguments == given:
        raise LookupError
    operands = [
        parameter.name
        for parameter in signature(function).parameters.values()
        if parameter.kind == Parameter.POSITIONAL_OR_KEYWORD
    ]
    first = [arguments[name] for name in operands if name in arguments]
    named = {name: value for name, value in arguments.items() if name not in operands}
    return _call(function, first, named), function(**arguments)


def _call(function: Callable[..., Any], args: Iterable[Any], kwargs: Mapping[str, Any]) -> str:
    """Return a call as it is typed."""
    texts = [*map(_literal, args), *(f"{name}={_literal(v)}" for name, v in kwargs.items())]
    return f"radcalc.{function.__name__}({', '.join(texts)})"


def other_call(proposal: Try, in_core: bool = True) -> tuple[str, Any]:
    """Make another call; return it as a text, and its answer.

    Its error is that of the core, or that of Python with the calls that its hint proposes.
    """
    command, *words = proposal.words
    pairs = [input_of(word) for word in words]
    operands = [text for name, text in pairs if not name]
    inputs = {name: text for name, text in pairs if name}
    wanted = inputs.pop("get", "")
    arguments = {
        keyword(name): value or SYMBOLS[name].form == FLAG or page_of(command).symbol(name).example
        for name, value in inputs.items()
    }
    function = getattr(sys.modules["radcalc"], keyword(command), None)
    function = getattr(function, "__wrapped__", None) if in_core else function
    if function is None:
        raise LookupError
    answer = function(*operands, **arguments)
    if wanted and isinstance(answer, dict):  # an answer for each day
        answer = {period: _result(one, wanted) for period, one in answer.items()}
    elif wanted:
        answer = _result(answer, wanted)
    return Python.command(*proposal.words), answer


def with_answer(call: str, answer: Any, remark: str = "") -> str:
    """Return a call with its answer, and a remark, below it."""
    return f"{call}\n     {', '.join(filter(None, [_text(answer), remark]))}"


def _is_quick(value: Any) -> bool:
    """Return whether a call with a value does not take long."""
    if isinstance(value, SIMPLE):
        return True
    if isinstance(value, (list, tuple)):
        return len(value) <= QUICK and all(map(_is_quick, value))
    is_array = isinstance(value, numpy.ndarray) or hasattr(value, "magnitude")
    if is_lazy(value) or not (is_array or library_of(value)):
        return False
    return int(numpy.size(magnitude_of(value))) <= QUICK


def _result(answer: Any, wanted: str) -> Any:
    """Return a result NAME[:UNIT] of an answer."""
    name, _, unit = wanted.partition(":")
    found = getattr(answer, keyword(name))
    unit, *_ = horticulture.WORDS.get(unit.lower(), (unit,))  # of ppfd and dli, which are names
    return found.to(unit) if unit else found


def _literal(value: Any) -> str:
    """Return a value as it is typed; a long array or a column by the name of its kind."""
    if isinstance(value, str):
        return '"' + value.replace('"', '\\"') + '"'
    if hasattr(value, "magnitude"):
        return f'radcalc.Quantity({_literal(value.magnitude)}, "{unit_of(value).text}")'
    if library_of(value) or (not isinstance(value, SIMPLE) and numpy.size(value) > LISTED):
        return type(value).__name__.lower().removeprefix("nd")
    text = repr(value.tolist() if isinstance(value, numpy.ndarray) else value)
    text = re.sub(r"\bnan\b", "np.nan", text)
    return f"np.array({text})" if isinstance(value, numpy.ndarray) else text


def _text(answer: Any) -> str:
    """Return the first number of an answer, with its unit, or the first line of a list."""
    if isinstance(answer, float) or is_quantity(answer):
        return in_short(answer)
    if isinstance(answer, tuple):
        return str(answer[0]).partition("\n")[0]
    if isinstance(answer, dict):  # an answer for each day
        return next((f"{period}: {_text(one)}" for period, one in answer.items()), "")
    return next(_rows(answer), "") if hasattr(answer, "rows") else str(answer)  # or uncertain


def _rows(result: Any) -> Iterator[str]:
    for row in result.rows:
        if not row.given:
            yield f"{keyword(row.name)} {in_short(row.value)} {row.unit}".removesuffix(" 1")
