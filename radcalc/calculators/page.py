"""The page of a calculator: its one description, which the command and the function are made of."""

import re
from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import Any, NamedTuple

from radcalc.errors import UsageError, nearest, quote
from radcalc.quantities.light import KINDS
from radcalc.quantities.symbols import QUANTITY, SYMBOLS, WORD, Symbol

# The forms of operands that no symbol has.
CONVERSION, SEARCH, ENVIRONMENT, FILE = "conversion", "search", "environment", "file"
NOTHING: Mapping[str, Any] = MappingProxyType({})


class Operand(NamedTuple):
    """The words of a call without an option: a shape, a source, coordinates.

    `usage` shows it in the help; `form` and `choices` say which words it may be.  `default` is
    the choice of a call without one.
    """

    name: str
    usage: str
    form: str = WORD
    choices: Sequence[str] = ()
    default: str = ""

    def choice(self, word: str) -> str:
        """Return the choice that a word names, in any case."""
        if word.lower() in self.choices:
            return word.lower()
        near = nearest(word.lower(), self.choices, 1) or self.choices
        raise UsageError(f"unknown {self.name} '{quote(word)}'", ", ".join(near))


class Page(NamedTuple):
    """A calculator: its inputs, its results and its texts.

    The worksheet reads the first fields.  `takes` are the symbols that can be given; `light` are
    the results that are light quantities, by generic names, and `others` the remaining ones, in
    the order of the answer; `goal` is the result that inputs must lead to where it is not light.

    The command and the Python function read the others.  `about` is one line that says what the
    calculator gives.  `sections` are the symbols of the options by the titles of the help;
    `kinds` are the kinds of light that they take.  `texts` replace the example and the help of a
    symbol, or the help alone, where it means less here.  `like` names the symbol whose quantity a
    result measures.  A calculator that `draws` has a picture; `takes_lines` is false where no input
    can come from lines of standard input.  `mistakes` are those that belong to this calculator, as
    `homework` calls them.

    `examples` have NAME=VALUE for each symbol, NAME= for a flag, and may end in two or more blanks
    and a remark.  In `remarks` {name} mentions a symbol, and a paragraph that begins with a line of
    `\\b` keeps its lines.

    `bare` are the units of numbers that are usually written without one; `labels` replace those
    of symbols, and `forms` say how people read their numbers.
    """

    title: str = ""
    takes: tuple[str, ...] = ()
    light: tuple[str, ...] = ()
    others: tuple[str, ...] = ()
    goal: str = ""
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
        """Return a symbol with the example, the help and the dimensions that it has here."""
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

    @property
    def paragraphs(self) -> list[str]:
        """Return the paragraphs of the remarks."""
        from inspect import cleandoc

        return cleandoc(self.remarks).split("\n\n") if self.remarks else []

    @property
    def intervals(self) -> tuple[str, ...]:
        """Return the symbols that are given as A:B on this page."""
        return tuple(
            name
            for name in self.texts
            if ":" in self.symbol(name).example and SYMBOLS[name].form == QUANTITY
        )


def words_of(example: str) -> tuple[list[str], str]:
    """Return the words of an example, and the remark on it with the blanks before it."""
    call = re.sub(" {2,}.*", "", example)
    words = re.findall(r"(?:'[^']*'|[^\s'])+", call)
    return [word.replace("'", "") for word in words], example[len(call) :]
