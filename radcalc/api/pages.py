"""The Python functions of calculators, made from their pages.

Signature and docstring follow from the symbols of the page, which the vocabulary describes.
"""

from __future__ import annotations

import inspect
import re
import textwrap
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from functools import cache, wraps
from importlib import import_module
from itertools import groupby
from typing import Any, NamedTuple, TypeVar, get_type_hints

from radcalc.api import keywords
from radcalc.api.amounts import with_amounts
from radcalc.api.calculate import calculate
from radcalc.api.refusals import in_python
from radcalc.api.result import Result
from radcalc.api.spelling import Documented, Python, keyword, symbol_name
from radcalc.calculators.page import Page, words_of
from radcalc.calculators.pages import page_of
from radcalc.errors import mention, spell
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
    light_unit,
    names_of_kinds,
)
from radcalc.units.unit import NUMBER

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


@cache
def function(name: str) -> Callable[..., Result]:
    """Make the function of a calculator from its page alone."""
    command = symbol_name(name)
    work_out = getattr(import_module(f"radcalc.calculators.{name}"), name)

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
            if unnamed and (values := given.pop(AMOUNTS.name, ())):
                given = with_amounts(function, command, values, given)
            return in_python(function)(**given)

        call.__annotations__ = {parameter.name: parameter.annotation for parameter in parameters}
        call.__annotations__["return"] = signature.return_annotation
        call.__annotations__ = get_type_hints(call, {**vars(keywords), **function.__globals__})
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


def _keywords(page: Page, without: Sequence[str]) -> list[Keyword]:
    """Return the keywords of a page; a light quantity also has those of its kinds."""
    groups = {
        kind_name: group
        for group, names in page.sections.items()
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
