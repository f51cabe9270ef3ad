"""Names that radcalc does not have, with the calls that answer."""

import re
import sys
from collections.abc import Callable, Collection, Iterator
from contextlib import suppress
from itertools import islice
from opcode import opname
from types import FrameType

from radcalc.api.quantity import in_short
from radcalc.api.refusals import other_call, with_answer
from radcalc.api.result import Result, names_of
from radcalc.api.spelling import Python, keyword, symbol_name
from radcalc.calculators.page import Page, words_of
from radcalc.calculators.pages import SUBJECTS, SUMMARIES, page_of
from radcalc.conversion.plan import target_of
from radcalc.errors import RadcalcError, Try, nearest
from radcalc.quantities.symbols import generic_name
from radcalc.spectra.sources import find_named

CONVERSION = re.compile(r"(?:convert_)?(.+?)(?:_to_|_?2_?)(.+)")  # lux_to_fc, lux2fc
FAILURES = (RadcalcError, TypeError, ValueError, LookupError)
MOST = 2  # calls that are proposed
ALIKE = 0.75  # of similar names


def error(name: str, frame: FrameType) -> Exception:
    """Return the error for a name; `frame` is that of the code that reads or imports it."""
    text = _hint(name)
    if not text:  # Python itself proposes similar names
        return AttributeError(f"module 'radcalc' has no attribute '{name}'")
    hint = f"\ntry: {text}"
    if opname[frame.f_code.co_code[frame.f_lasti]] == "IMPORT_FROM":
        return ImportError(f"cannot import name '{name}' from 'radcalc'{hint}", name="radcalc")
    return AttributeError(f"module 'radcalc' has no attribute '{name}'{hint}", name=name)


def _hint(name: str) -> str:
    """Return the calls that a name means, each with its answer below it; '' for none.

    A name may be a conversion, a result, an input, a function or its subject, a unit or a spectrum;
    the first of these that it is decides.
    """
    ways: tuple[Callable[[str], Iterator[str]], ...]
    ways = _conversion, _result, _input, _function, _thing
    found: Iterator[list[str]] = ([*islice(way(name), MOST)] for way in ways)
    return "\nor:  ".join(next(filter(None, found), []))


def _conversion(name: str) -> Iterator[str]:
    """Yield the conversion of 1, or the calls that its refusal proposes."""
    match = CONVERSION.fullmatch(name)
    if not match:
        return
    source, target = (word.replace("_", " ") for word in match.groups())
    with suppress(RadcalcError):
        source = target_of(source).text
    proposal = Try(words=("convert", f"1 {source}", target))
    try:
        yield with_answer(*other_call(proposal, in_core=False))
    except RadcalcError as refusal:
        if "radcalc." in refusal.hint:
            yield refusal.hint


def _result(name: str) -> Iterator[str]:
    """Yield calls with a result of that name."""
    for command in SUMMARIES:
        page = page_of(command)
        results = (*page.light, *page.others)
        if not results or _names(name) & {*results}:
            for call, result in _examples(command, page):
                if name in names_of(result) and f"{name}=" not in call:
                    yield f"{call}.{name}\n     {in_short(result[name])}"
                    break


def _input(name: str) -> Iterator[str]:
    """Yield calls with an input of that name."""
    for command in SUMMARIES:
        page = page_of(command)
        if any(_names(name) & {*section} for section in page.symbols.values()):
            yield from (with_answer(*a) for a in _examples(command, page) if f"{name}=" in a[0])


def _names(name: str) -> set[str]:
    """Return a symbol, and that of its light of any kind."""
    symbol = symbol_name(name)
    return {symbol, generic_name(symbol)}


def _function(name: str) -> Iterator[str]:
    """Yield a call of each function that is meant, or its help."""
    public = sys.modules["radcalc"].__all__
    words = {*name.lower().split("_")}
    subjects = words | {symbol_name(name)}
    meant = nearest(name, public, 1, ALIKE)
    meant = meant or [function for function in public if {*function.split("_")} <= words]
    meant = meant or [keyword(k) for k, names in SUBJECTS.items() if subjects & {*names.split()}]
    for function in meant:
        command = symbol_name(function)
        if command in SUMMARIES:
            example = next(_examples(command, page_of(command), words), None)
            yield with_answer(*example) if example else Python.manual(command)
        elif function in public:
            yield f"radcalc.{function}"


def _thing(name: str) -> Iterator[str]:
    """Yield the call that explains a spectrum or a shape, or makes a quantity."""
    text = name.replace("_", " ")
    if find_named(text):
        yield with_answer(*other_call(Try(words=("spectrum", text))))
    for command in SUMMARIES:
        page = page_of(command)
        if page.operand and text in page.operand.choices:
            yield with_answer(*next(_examples(command, page, {text})))
    with suppress(RadcalcError):
        yield f'radcalc.Quantity("1 {target_of(text).text}")'


def _examples(
    command: str, page: Page, words: Collection[str] = ()
) -> Iterator[tuple[str, Result]]:
    """Yield the calls in a page's examples that are answered; those with any word come first."""
    for example in sorted(page.examples, key=lambda text: not any(word in text for word in words)):
        given = [word for word in words_of(example)[0] if word not in ("steps=", "plot=")]
        proposal = Try(words=(command, *(word for word in given if word[:4] != "get=")))
        with suppress(*FAILURES):
            call, result = other_call(proposal)
            yield call, result
