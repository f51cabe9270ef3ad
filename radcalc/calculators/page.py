"""The page of a calculator: the description from which its command and function are made."""

import re
from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import Any, NoReturn

from radcalc.errors import UsageError, corrections, nearest, quote
from radcalc.quantities.light import KINDS
from radcalc.quantities.symbols import (
    QUANTITY,
    SPECIFIC,
    SYMBOLS,
    WORD,
    Symbol,
    names_of_kinds,
)
from radcalc.tuples import NamedTuple

# Forms of operands, in addition to those of symbols.
CONVERSION, SEARCH, ENVIRONMENT, FILE = "conversion", "search", "environment", "file"
NOTHING: Mapping[str, Any] = MappingProxyType({})


class Operand(NamedTuple):
    """The arguments of a call: a shape, a source, coordinates.

    `usage` is the text in the help; `form` and `choices` define valid words, `default` the choice
    of a call without one.
    """

    name: str
    usage: str
    form: str = WORD
    choices: Sequence[str] = ()
    default: str = ""

    def choice(self, word: str) -> str:
        if word.lower() in self.choices:
            return word.lower()
        self.refuse(word, {}, {})

    def refuse(
        self, word: str, takes: Mapping[str, Sequence[str]], given: Mapping[str, Any]
    ) -> NoReturn:
        """Refuse an unknown choice; propose a similar one, or those that take the inputs given."""
        known = {name for names in takes.values() for name in names} & given.keys()
        possible = [name for name in self.choices if known <= {*takes.get(name, known)}]
        near = nearest(word.lower(), possible, 1, 0.7)
        fitting = [name for name in possible if name in takes]
        hint = corrections(word, *(near or fitting)) or ", ".join(self.choices)
        raise UsageError(f"unknown {self.name} '{quote(word)}'", hint)


class Page(NamedTuple):
    """A calculator: its inputs, its results and its texts.

    Fields for the worksheet: `takes` are the accepted symbols; `light` the results that are light
    quantities (generic names), and `others` the other results, in the order of the answer; `goal`
    is a result that inputs must lead to if it is not light, and `goals` are further ones.
    `on_request` are results that are calculated only if they are requested.

    Fields for the command and the Python function: `about` is a one-line summary; `sections` map
    titles of the help to the symbols of options, `kinds` are their kinds of light.  `texts` replace
    the example and the help of a symbol, or the help alone.  `like` maps a result to the symbol of
    the same quantity.  `draws` allows pictures, `takes_lines` lines of standard input.
    `mistakes` are names of `homework` for this calculator.

    `examples` have NAME=VALUE for each symbol, NAME= for a flag, and may end in two or more blanks
    and a remark.  In `remarks` {name} mentions a symbol, and a paragraph that begins with a line of
    `\\b` keeps its lines.

    `bare` are the units of numbers that are usually written without one; `labels` replace those
    of symbols, and `forms` are the forms of their numbers.
    """

    title: str = ""
    takes: tuple[str, ...] = ()
    light: tuple[str, ...] = ()
    others: tuple[str, ...] = ()
    goal: str = ""
    goals: tuple[str, ...] = ()
    on_request: tuple[str, ...] = ()
    about: str = ""
    operand: Operand | None = None
    sections: Mapping[str, tuple[str, ...]] = NOTHING
    texts: Mapping[str, str | tuple[str, str]] = NOTHING
    examples: tuple[str, ...] = ()
    remarks: str = ""
    kinds: tuple[str, ...] = KINDS
    draws: bool = False
    takes_lines: bool = True
    mistakes: tuple[str, ...] = ()
    like: Mapping[str, str] = NOTHING
    bare: Mapping[str, str] = NOTHING
    labels: Mapping[str, str] = NOTHING
    forms: Mapping[str, str] = NOTHING

    def symbol(self, name: str) -> Symbol:
        """Return a symbol with this page's example, help and dimensions."""
        symbol = SYMBOLS[name]
        if name in self.texts:
            text = self.texts[name]
            example, text = (symbol.example, text) if isinstance(text, str) else text
            symbol = symbol._replace(example=example, help=text)
        if name in self.like:
            other = SYMBOLS[self.like[name]]
            symbol = symbol._replace(
                dimensions=other.dimensions, geometry=other.geometry, generic=other.generic
            )
        return symbol

    def kinds_of(self, name: str) -> list[str]:
        """Return the symbols of a light quantity for each kind of light that this page has."""
        if self.symbol(name).generic != name:
            return []
        return [other for other in names_of_kinds(name) if SPECIFIC[other][1] in self.kinds]

    @property
    def listed(self) -> list[str]:
        """The symbols of the options, in their order."""
        return [name for section in self.sections.values() for name in section]

    def accepts(self, name: str) -> bool:
        """Return whether a call may give a symbol: of a section, or for one kind of light."""
        generic, _ = SPECIFIC.get(name, ("", ""))
        return name in self.listed or (generic in self.listed and name in self.kinds_of(generic))

    @property
    def paragraphs(self) -> list[str]:
        from inspect import cleandoc

        return cleandoc(self.remarks).split("\n\n") if self.remarks else []

    @property
    def intervals(self) -> tuple[str, ...]:
        return tuple(
            name
            for name in self.texts
            if ":" in self.symbol(name).example and SYMBOLS[name].form == QUANTITY
        )


def words_of(example: str) -> tuple[list[str], str]:
    """Return the words of an example, and its remark with the blanks before it."""
    call = re.sub(" {2,}.*", "", example)
    words = re.findall(r"(?:'[^']*'|[^\s'])+", call)
    return [word.replace("'", "") for word in words], example[len(call) :]
