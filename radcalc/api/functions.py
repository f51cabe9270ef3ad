"""The Python functions of calculators, made from their pages.

Signature and docstring follow from the symbols of the page, which the vocabulary describes.  The
unit of an amount without a keyword decides which keyword it has.
"""

from __future__ import annotations

import inspect
import re
import textwrap
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from functools import cache, partial, wraps
from importlib import import_module
from itertools import groupby
from typing import Any, NamedTuple, TypeVar, get_type_hints

import numpy

from radcalc.answer import Answer, texts_of
from radcalc.api import columns
from radcalc.api.arguments import (
    Documented,
    Python,
    as_text,
    broadcast,
    is_absent,
    is_lazy,
    is_quantity,
    keyword,
    library_of,
    magnitude_of,
    read_inputs,
    read_points,
    symbol_name,
    unit_of,
)
from radcalc.api.columns import in_columns, take_columns
from radcalc.api.result import Result, in_python, of_answer, with_keywords
from radcalc.calculators import page_of
from radcalc.calculators.page import NOTHING, Page, words_of
from radcalc.calculators.solved import Task, requesting
from radcalc.errors import (
    ConditionError,
    RadcalcError,
    UsageError,
    manual,
    mention,
    options,
    quote,
    spell,
)
from radcalc.inputs import Input, Inputs, shown_inputs
from radcalc.maths import is_column
from radcalc.quantities import read as read_light
from radcalc.quantities.symbols import (
    CHOICE,
    DIRECTION,
    DISTRIBUTION,
    FLAG,
    INTERVAL,
    NUMBERS,
    PAIR,
    POINT,
    QUANTITY,
    SPECIFIC,
    SPECTRUM,
    VECTOR,
    Symbol,
    article,
    in_kind,
    light_unit,
    names_of_kinds,
    specific_name,
)
from radcalc.sentences.frames import inputs_of
from radcalc.units import NUMBER, Unit
from radcalc.units.dimensions import LENGTH
from radcalc.units.ranges import read_values
from radcalc.units.reading import read_amount
from radcalc.units.table import resolve


class Unnamed(NamedTuple):
    """An amount without a keyword, and its unit."""

    value: Any
    unit: Unit | None


def with_amounts(
    function: Callable[..., Any], command: str, amounts: Sequence[Any], given: Mapping[str, Any]
) -> dict[str, Any]:
    """Return the keywords of a call, with those of its amounts.

    Raises UsageError, which names the possible keywords, for an amount that may be several inputs
    or none, and for two amounts that are the same input.
    """
    page, named = page_of(command), {k: v for k, v in given.items() if not is_absent(v)}
    try:
        read = [_read(value) for value in amounts]
        found = _inputs(command, read, named)
        names = [name for name in found if name]
        wrong = []
        for amount, name in zip(read, found, strict=True):
            if not name or names.count(name) > 1 or keyword(name) in named:
                wrong.append(amount)
            else:
                named[keyword(name)] = amount.value
        if wrong:
            raise _unplaced(page, command, wrong, named)
    except RadcalcError as error:
        raise with_keywords(error, function, named) from None
    return named


def _read(value: Any) -> Unnamed:
    """Return an amount with its unit; a list has the unit of its first element."""
    first = value[0] if isinstance(value, (list, tuple)) and value else value
    if isinstance(first, str):
        return Unnamed(value, read_amount(read_values(first)[0]).typed[1] or resolve("1"))
    if is_quantity(first) and not library_of(magnitude_of(first)):
        return Unnamed(value, unit_of(first))
    is_number = isinstance(value, (int, float)) and not isinstance(value, bool)
    return Unnamed(value, resolve("1") if is_number else None)


def _inputs(command: str, amounts: Sequence[Unnamed], given: Mapping[str, Any]) -> list[str]:
    """Return the input that each amount is, or "" if it may be several or none.

    Two kinds of one light have their own names: flux is luminous-flux and radiant-flux.
    """
    other = [*map(symbol_name, given)]
    listed = [inputs_of(command, amount.unit, other) if amount.unit else [] for amount in amounts]
    names = [names[0] if len(names) == 1 else "" for names in listed]
    found = []
    for name, amount in zip(names, amounts, strict=True):
        light = read_light(amount.unit) if amount.unit and name else None
        is_taken = names.count(name) > 1 or keyword(name) in given
        own = specific_name(name, light.kind) if light and is_taken else name
        found.append(own if own in SPECIFIC else name)
    return found


def _unplaced(
    page: Page, command: str, wrong: Sequence[Unnamed], given: Mapping[str, Any]
) -> UsageError:
    """Return the error for amounts that need keywords, which it names."""
    texts = [f"'{quote(as_text(amount.value))}'" for amount in wrong]
    problem = f"{', '.join(texts)} {'need keywords' if texts[1:] else 'needs a keyword'}"
    listed = [_candidates(page, amount, given) for amount in wrong]
    if not all(listed):
        return UsageError(problem, manual(command))
    names = dict.fromkeys(name for names in listed for name in names)
    return UsageError(problem, f"one of {options(names, ', ')}")


def _candidates(page: Page, amount: Unnamed, given: Mapping[str, Any]) -> list[str]:
    """Return the inputs of a page that take an amount and are not given."""
    if amount.unit is None:
        return []
    dimension, light = amount.unit.dimension, read_light(amount.unit)
    symbols = [page.symbol(name) for name in page.listed]
    taking = [s.name for s in symbols if s.form == QUANTITY and dimension in s.dimensions]
    if dimension == LENGTH and amount.unit.text not in ("nm", "um"):
        taking = [name for name in taking if name != "wavelength"]
    names = [in_kind(name, light.kind) if light else name for name in taking]
    return [name for name in names if keyword(name) not in given]


WorkOut = Callable[..., Answer]  # of the inputs, and of results on request


def calculate(
    command: str,
    given: Mapping[str, Any],
    work_out: WorkOut,
    operands: Mapping[str, str] = NOTHING,
    *,
    waits: bool = True,
    adapt: Callable[[Inputs], Inputs] | None = None,
    samples: Mapping[str, float] = NOTHING,
    drawn: Any = None,
    requested: tuple[str, ...] = (),
) -> Result:
    """Read the symbols given to a function, and return the result.

    `operands` are shown with them; `samples` are facts of a log; `drawn` is what a picture needs
    in addition to the inputs; `adapt` changes the inputs that were read; `waits` is true if the
    function takes Dask arrays.  `requested` are results that the function calculates on request
    alone.
    """
    columns, given = take_columns({k: v for k, v in given.items() if not is_absent(v)})
    if waits and any(map(is_lazy, given.values())):
        from radcalc.api.columns import blockwise

        operand_texts = dict(operands)  # pickle takes it, unlike a proxy
        call = partial(calculate, command, work_out=work_out, operands=operand_texts, adapt=adapt)
        waiting: Result = blockwise(keyword(command), call, given)
        return in_columns(waiting, columns)
    symbols = dict(given)
    point = symbols.pop("point", None)
    inputs = read_inputs(symbols, page_of(command).intervals)
    if point is not None:
        inputs = {**inputs, "point": read_points(point)}
    if adapt:
        inputs = adapt(inputs)
    arrays = any(map(_has_elements, inputs.values()))
    shape = operands.get("shape") or operands.get("type", "")
    task = Task(command, requesting(work_out, requested), texts_of(operands), shape, samples, drawn)
    answer = broadcast(lambda: task.solve(inputs))

    def ask() -> Any:
        from radcalc.homework.question import of_task

        return of_task(task, inputs, steps=True)

    def again(name: str) -> Answer:
        further = task._replace(work_out=requesting(work_out, (*requested, name)))
        found: Answer = broadcast(lambda: further.solve(inputs))
        return found

    listed_inputs = (*task.operands, *shown_inputs(inputs))
    solved = (inputs, answer, drawn)
    result = of_answer(command, answer, listed_inputs, None if arrays else ask, solved, again)
    return in_columns(result, columns)


def _has_elements(given: Input) -> bool:
    values = given.value if isinstance(given.value, tuple) else (given.value,)
    return any(map(is_column, values))


T = TypeVar("T")
FORMS = {
    DIRECTION: "Direction",
    DISTRIBUTION: "Distribution",
    SPECTRUM: "Spectrum",
    INTERVAL: "Interval",
    NUMBERS: "Numbers",
    PAIR: "Pair",
    POINT: "Vector",
    VECTOR: "Vector",
}
FEW = 3  # keywords in the text of a signature
WIDTH = 96  # width of a docstring, which help() indents
HEADING = re.compile(r"^(\w+)\n-{3,}\n", re.MULTILINE)
ENTRY = re.compile(r"^(\w[^\n]*?) : [^\n]*(?:\n    [^\n]*)*", re.MULTILINE)
RETURNS = """Result
    The inputs and results, as attributes with the names of ``radcalc -g``."""
RAISES = """radcalc.RadcalcError
    If an input is missing, contradictory, out of range or unused."""
# Quantities after the operands of a function.
AMOUNTS = inspect.Parameter("amounts", inspect.Parameter.VAR_POSITIONAL, annotation="Unnamed")
ABOUT_AMOUNTS = """amounts : Unnamed, optional
    Quantities without a keyword: the unit decides which input each is (light, a distance, an
    area, a time, a wavelength), and a quantity that may be several inputs needs its keyword."""
HEADINGS = PARAMETERS, _, _, EXAMPLES = "Parameters", "Returns", "Raises", "Examples"


class Readable(inspect.Signature):
    """A signature whose text is a line: the operands, a few keywords, and ... for the others."""

    shown: Collection[str] = ()

    def __str__(self) -> str:
        """Return the text."""
        return self.format()

    def format(self, **_: Any) -> str:
        """Return the text, which `help` shows, in one line of any width."""
        texts: list[str] = []
        omitted = False
        for parameter in self.parameters.values():
            if parameter.kind == parameter.KEYWORD_ONLY:
                if not any(text[0] == "*" for text in texts):
                    texts.append("*")
                if parameter.name in self.shown:
                    texts.append(f"{parameter.name}=...")
                omitted = omitted or parameter.name not in self.shown
            elif parameter.kind == parameter.VAR_POSITIONAL:
                texts.append(f"*{parameter.name}")
            elif parameter.default is parameter.empty:
                texts.append(parameter.name)
            else:
                texts.append(f"{parameter.name}={parameter.default!r}")
        return f"({', '.join([*texts, *['...'] * omitted])}) -> {self.return_annotation}"


class Keyword(NamedTuple):
    """A symbol as a keyword: its annotation, default, unit and description, and its group."""

    name: str
    annotation: str
    default: Any
    unit: str
    help: str
    group: str

    @property
    def parameter(self) -> inspect.Parameter:
        return inspect.Parameter(
            self.name,
            inspect.Parameter.KEYWORD_ONLY,
            default=self.default,
            annotation=self.annotation,
        )


def function_of_page(name: str) -> WorkOut:
    """Return the function that calculates what a page describes."""
    work_out: WorkOut = getattr(import_module(f"radcalc.calculators.{name}"), name)
    return work_out


@cache
def function(name: str) -> Callable[..., Result]:
    """Make the function of a calculator from its page alone."""
    command, work_out = symbol_name(name), function_of_page(name)

    def call(**given: Any) -> Result:
        return calculate(command, given, work_out)

    call.__name__ = call.__qualname__ = name
    return of_page(command, amounts=True)(call)


def of_page(
    command: str, without: Sequence[str] = (), *, amounts: bool = False
) -> Callable[[Callable[..., T]], Callable[..., T]]:
    """Decorate a function with the keywords and the documentation of a page.

    The function takes the keywords as `**given`, except those named in `without`.  The sections of
    its docstring replace the remarks and examples of the page.  With `amounts`, its operands may be
    followed by quantities without keywords.
    """
    page = page_of(command)
    page_keywords = _keywords(page, without)

    def decorate(function: Callable[..., T]) -> Callable[..., T]:
        """Return the function with the keywords of the page and its documentation."""
        signature = inspect.signature(function)
        fixed = [
            parameter
            for parameter in signature.parameters.values()
            if parameter.kind != parameter.VAR_KEYWORD
        ]
        operands = [parameter for parameter in fixed if parameter.kind != parameter.KEYWORD_ONLY]
        options = [parameter for parameter in fixed if parameter.kind == parameter.KEYWORD_ONLY]
        unnamed = [AMOUNTS] if amounts else []
        keyword_only = [added.parameter for added in page_keywords]
        parameters = [*operands, *unnamed, *keyword_only, *options]
        signature = Readable(parameters, return_annotation=signature.return_annotation)

        @wraps(function)
        def call(*args: Any, **kwargs: Any) -> T:
            try:
                bound = signature.bind(*args, **kwargs)
            except TypeError as error:
                problem = f"{function.__name__}() {error}"
                if not kwargs.keys() <= signature.parameters.keys():
                    problem += f"; its parameters are {', '.join(signature.parameters)}"
                raise TypeError(problem) from None
            given = bound.arguments
            given = {key: _flag(key, value, signature) for key, value in given.items()}
            if unnamed and (values := given.pop(AMOUNTS.name, ())):
                given = with_amounts(function, command, values, given)
            return in_python(function)(**given)

        call.__annotations__ = {parameter.name: parameter.annotation for parameter in parameters}
        call.__annotations__["return"] = signature.return_annotation
        call.__annotations__ = get_type_hints(call, {**vars(columns), **function.__globals__})
        own_text = inspect.cleandoc(function.__doc__ or "")
        call.__doc__ = _docstring(
            own_text, command, page, [one.name for one in (*operands, *unnamed)], page_keywords
        )
        in_example = re.findall(r"(\w+)=", call.__doc__.partition(f"{EXAMPLES}\n")[2])
        signature.shown = [*dict.fromkeys(in_example)][:FEW]
        call.__signature__ = signature  # type: ignore[attr-defined]
        call.__module__ = "radcalc"
        return call

    return decorate


def _flag(key: str, value: Any, signature: inspect.Signature) -> Any:
    """Return a value, of a flag as a bool; refuse another one for a flag."""
    if signature.parameters[key].annotation != "bool" or value is None:
        return value
    if isinstance(value, (bool, numpy.bool_)):
        return bool(value)
    raise ConditionError(f"{key} is {article(type(value).__name__)}", f"{key}=True, or False")


def _keywords(page: Page, without: Sequence[str]) -> list[Keyword]:
    """Return the keywords of a page; a light quantity also has those of its kinds."""
    groups = {
        kind_name: group
        for group, names in page.symbols.items()
        for name in names
        if name not in without
        for kind_name in (name, *names_of_kinds(name))
        if kind_name == name or SPECIFIC[kind_name][1] in page.kinds
    }
    return [_keyword(page.symbol(name), page.kinds, group) for name, group in groups.items()]


def _keyword(symbol: Symbol, kinds: Sequence[str], group: str) -> Keyword:
    name, text = keyword(symbol.name), spell(mention(symbol.help), Documented)
    unit = ""
    if symbol.form in (QUANTITY, INTERVAL) and NUMBER not in symbol.dimensions:
        unit = symbol.unit
        if symbol.name == symbol.generic:
            unit = ", ".join(light_unit(symbol.name, kind) for kind in kinds)
    if symbol.form == FLAG:
        return Keyword(name, "bool", False, unit, text, group)
    annotation = FORMS.get(symbol.form, "Text")
    if symbol.form == CHOICE:
        annotation = "".join(map(str.capitalize, symbol.name.split("-"))) + " | None"
    elif symbol.form == QUANTITY:
        annotation = "Interval" if ":" in symbol.example else "Amount" if unit else "Number"
    return Keyword(name, annotation, None, unit, text, group)


def _docstring(
    own_text: str,
    command: str,
    page: Page,
    operands: Sequence[str],
    page_keywords: Sequence[Keyword],
) -> str:
    """Return a docstring: the sections of a function's own text, the others of its page."""
    summary, *headed = HEADING.split(own_text)
    sections = {"Returns": RETURNS, "Raises": RAISES}
    sections |= dict(zip(headed[::2], headed[1::2], strict=True))
    if not summary:
        remarks = [] if own_text else page.paragraphs
        about = [textwrap.fill(spell(mention(text), Documented), WIDTH) for text in remarks]
        summary = "\n\n".join([page.about, *about])
    if EXAMPLES not in sections:
        calls = [_example(command, example, page.bare) for example in page.examples]
        sections[EXAMPLES] = "\n".join(calls)
    entries = [entry[0] for entry in ENTRY.finditer(sections.get(PARAMETERS, ""))]
    first = [entry for entry in entries if re.split(r"\W", entry)[0] in operands]
    options = [entry for entry in entries if entry not in first]
    if AMOUNTS.name in operands:
        first.append(ABOUT_AMOUNTS)
    grouped = [f"\n{group}:\n\n{text}" for group, text in _groups(page_keywords)]
    sections[PARAMETERS] = "\n".join([*first, *options, *grouped])
    parts = [
        f"{heading}\n{'-' * len(heading)}\n{sections[heading].strip()}" for heading in HEADINGS
    ]
    return "\n\n".join([summary.strip(), *parts])


def _groups(page_keywords: Sequence[Keyword]) -> Iterator[tuple[str, str]]:
    """Yield the title and the entries of each group of keywords."""
    for group, in_group in groupby(page_keywords, lambda entry: entry.group):
        yield group, "\n".join(_entries([*in_group]))


def _entries(page_keywords: Sequence[Keyword]) -> Iterator[str]:
    """Return an entry for each symbol; a light quantity also has the names of its kinds."""
    groups: dict[str, list[Keyword]] = {}
    for entry in page_keywords:
        generic = keyword(SPECIFIC.get(symbol_name(entry.name), (entry.name, ""))[0])
        groups.setdefault(generic if generic in groups else entry.name, []).append(entry)
    for first, *kinds in groups.values():
        names = [first.name, *(entry.name for entry in kinds)]
        kind = f"{first.annotation.removesuffix(' | None')}, optional"
        unit = f" [{first.unit}]" if first.unit else ""
        head = textwrap.fill(f"{', '.join(names)} : {kind}", WIDTH, subsequent_indent="    ")
        if "\n" not in head:
            yield f"{head}\n{_filled(first.help + unit)}"
        else:
            yield f"{first.name} : {kind}\n{_filled(first.help + unit)}"
            yield f"{', '.join(names[1:])} : {kind}\n{_filled('The same in one kind of light.')}"


def _filled(text: str) -> str:
    indent = "    "
    return textwrap.fill(
        text, WIDTH, initial_indent=indent, subsequent_indent=indent, break_on_hyphens=False
    )


def _example(command: str, example: str, bare: Mapping[str, str]) -> str:
    """Return a call from a page's examples, folded if it is long.

    Bare numbers, which Python does not take, get the unit that they have at a shell.
    """
    words = [
        word + bare.get(word.partition("=")[0], "") * word[-1].isdigit()
        for word in words_of(example)[0]
    ]
    call = f">>> found = {Python.command(command, *words)}"
    if len(call) <= WIDTH:
        return call
    head, inner, tail = re.split(r"(?<=\w)\(|(?<=[\"\w])\)(?=\.|$)", call, maxsplit=2)
    breakable = inner.replace(", ", ",\n").replace(" ", "\0")  # line breaks only between arguments
    arguments = textwrap.wrap(breakable, WIDTH - 8, break_long_words=False, break_on_hyphens=False)
    lines = "".join(f"...     {line}\n" for line in arguments).replace("\0", " ")
    return f"{head}(\n{lines}... ){tail}"
