"""The page of a command: the description from which its command and function are made.

Its options are names of symbols, and rows of others.  Click, completion, the help and the manual
read the rows.
"""

import re
from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import Any, NoReturn

from radcalc.errors import UsageError, corrections, mention, nearest, quote
from radcalc.quantities import KINDS
from radcalc.quantities.symbols import (
    CHOICE,
    FLAG,
    QUANTITY,
    SPECIFIC,
    SYMBOLS,
    WORD,
    Symbol,
    light_unit,
    names_of_kinds,
)
from radcalc.terminal import AUTO, COLORING, FORMATS, INVALID
from radcalc.tuples import NamedTuple

TYPE_CHECKING = False  # typing is slow to import
if TYPE_CHECKING:
    from typing import Any

PERIODS = PER_DAY, PER_HOUR = "day", "hour"  # of a log
# Forms of values, in addition to those of symbols: results, an answer to check, files.
RESULT, CLAIM, FIGURE, FILE, WHOLE = "result", "claim", "figure", "file", "whole number"


class Option(NamedTuple):
    """An option: its spellings, the example of its value, and its help.

    `form` is the kind of its value; `least` and `most` are the limits of a whole number.  `name` is
    the parameter that a command gets, if it is not the longest spelling.  A hidden option is not in
    the help: it is another name of the option before it, or another command documents it.
    """

    spellings: tuple[str, ...]
    example: str
    help: str
    form: str = WORD
    choices: tuple[str, ...] = ()
    default: "Any" = None
    repeats: bool = False
    least: "int | None" = None
    most: "int | None" = None
    name: str = ""
    hidden: bool = False
    symbol: "Any" = None

    @property
    def parameter(self) -> str:
        return self.name or self.spellings[-1].lstrip("-").replace("-", "_")


def _option(names: str, example: str, help_text: str, *form: "Any", **more: "Any") -> Option:
    """Return a row; `names` are without dashes, and the text mentions options as {name}."""
    spellings = tuple([f"{'-' * min(len(name), 2)}{name}" for name in names.split()])
    return Option(spellings, example, mention(help_text), *form, **more)


def flag(names: str, help_text: str, **more: "Any") -> Option:
    """Return the row of an option without a value."""
    return _option(names, "", help_text, FLAG, default=False, **more)


def choice(names: str, choices: "Any", help_text: str, **more: "Any") -> Option:
    """Return the row of an option with a few possible values."""
    return _option(names, "", help_text, CHOICE, tuple(choices), **more)


def text(names: str, example: str, help_text: str, **more: "Any") -> Option:
    """Return the row of an option with a text as its value."""
    return _option(names, example, help_text, **more)


GET = text(
    "g get",
    "NAME[:UNIT]",
    "Print only this result, as a bare number or in the format of {format}.  "
    "Without UNIT, the unit is that of the full answer.  Several: flux,illuminance:klx.",
    form=RESULT,
    repeats=True,
    name="wanted",
)
PLOT = text(
    "plot", "[FILE]", "Draw a picture below the answer, or in FILE (.svg, .png).", form=FIGURE
)
STEPS = flag("steps", "Show the derivation.")
COLOR = choice(
    "color",
    COLORING,
    "Colour on a terminal (NO_COLOR and FORCE_COLOR are respected).",
    default=AUTO,
)
OUTPUT = (
    flag("n number", "Print bare numbers only."),
    choice(
        "format",
        FORMATS,
        "Format of the output (default: a table on a terminal, else plain).",
        name="format_",
    ),
    flag("json", "Same as {format=json}.", name="json_"),
    text(
        "precision",
        "N",
        "Significant digits, from 1 to 17 (default: 6 in tables, 12 in plain text, all in JSON).",
        form=WHOLE,
        least=1,
        most=17,
    ),
    COLOR,
    flag("auto", "Choose SI prefixes that fit: 2.1 mlx, not 0.0021 lx."),
    flag("q quiet", "Omit notes and assumptions."),
    text(
        "definitions",
        "FILE",
        "Units, constants and spectra of your own (default: ~/.config/radcalc/definitions.txt).",
        form=FILE,
    ),
)
OF_ANSWERS = (*OUTPUT, STEPS)
# Lists have no numbers to print; the hidden options give better errors.
NUMERIC = ("number", "precision", "auto")
OF_LISTS = tuple([row._replace(hidden=row.parameter in NUMERIC) for row in OUTPUT])
DEFAULTS: "dict[str, Any]" = {row.parameter: row.default for row in OUTPUT}

TOLERANCE = text(
    "tolerance", "1%", "Allowed deviation: 1% (default), 0.5lx, or 3sf (3 significant digits)."
)
# Homework: a check of an answer.
CHECKS = (
    text(
        "check",
        "[NAME=]VALUE[UNIT]",
        "Compare VALUE, your own answer, with the result.  If it is wrong, radcalc names the "
        "likely mistake and exits with status 1.",
        form=CLAIM,
    ),
    TOLERANCE,
)
# Lines of standard input: shown by convert, and hidden in calculators.
OF_LINES = (
    text("field", "LIST", "Fields to convert, by number: 3, 1,3, 2-4, 3- (from 3 on), or - (all)."),
    text(
        "column",
        "NAME",
        "Field to convert: its title, with or without its unit (E for E [lx]), or its number.  "
        "Delimiter and header are detected.",
    ),
    text("d delimiter", "X", "Field separator: one character, or tab (default: blanks)."),
    text(
        "header",
        "[=N]",
        "Number of header lines (1 without N).  Every line must have as "
        "many fields as the header.  If a title has a unit, it must be the input unit; the unit of "
        "the result replaces it.",
        form=WHOLE,
        least=1,
    ),
    text("add", "NAME", "Keep the field, and append a field with this title for the result."),
    text("rename", "NAME", "New title of the field; required if the result is another quantity."),
    choice(
        "decimal",
        (".", ","),
        "Decimal mark of input and output: a comma, or a point (the default).",
    ),
    choice(
        "invalid",
        INVALID,
        "Treatment of unreadable lines.  abort (default): stop at the first.  fail, warn, "
        "ignore: copy them unchanged, and fail at the end (status 2), warn (status 0) or say "
        "nothing (status 0).",
    ),
)
VERSION = flag("version", "Show the version and exit.")
EXPLAIN = flag("explain", "Show how a sentence is read, without answering it.")
HELPS = (
    flag("h", "Show the help on one screen and exit."),
    flag("help", "Show the complete help and exit."),
)
OF_RADCALC = (VERSION, EXPLAIN, *HELPS)


# Forms of operands, in addition to those of symbols.
CONVERSION, SEARCH, ENVIRONMENT, FILE = "conversion", "search", "environment", "file"
ALSO = "also --"  # before the names of the kinds
RESULTS, LINES, OUTPUTS = "Results", "Streams", "Output"  # titles of sections
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
    `on_request` are results that are calculated only if they are requested, and `results` those of
    a calculator without a worksheet.

    Fields for the command and the Python function: `about` is a one-line summary; `sections` map
    titles of the help to the options: names of symbols, and rows of others.  A command that
    `calculates` has options for results.  `output` are the options of its output; `kinds` are
    the kinds of light of its symbols.  `texts` replace
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
    results: tuple[str, ...] = ()
    about: str = ""
    operand: Operand | None = None
    sections: Mapping[str, tuple[str | Option, ...]] = NOTHING
    calculates: bool = True
    output: tuple[Option, ...] = OF_ANSWERS
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
        return [name for names in self.symbols.values() for name in names]

    @property
    def symbols(self) -> dict[str, list[str]]:
        """The symbols of the options, by the titles of their sections."""
        return {
            title: [name for name in members if isinstance(name, str)]
            for title, members in self.sections.items()
        }

    @property
    def options(self) -> dict[str, list[Option]]:
        """The rows of all options, by the titles of their sections."""
        sections = {title: [*members] for title, members in self.sections.items()}
        if self.calculates:
            of_results = [GET, *CHECKS, *([PLOT] if self.draws else [])]
            sections[RESULTS] = [*sections.pop(RESULTS, ()), *of_results]
            if self.takes_lines:
                sections[LINES] = [row._replace(hidden=True) for row in OF_LINES]
        sections[OUTPUTS] = [*self.output]
        return {
            title: [row for member in members for row in self._rows(member)]
            for title, members in sections.items()
        }

    def _rows(self, member: str | Option) -> list[Option]:
        """Return the row of an option; a light quantity has hidden ones for its kinds."""
        if not isinstance(member, str):
            return [member]
        symbol, text = self.symbol(member), self.symbol(member).help
        if member != symbol.generic:
            return [_row(symbol)]
        other_names = self.kinds_of(member)
        if other_names:
            text = text.rstrip(".")
            start = f"{text[:-1]}; " if text.endswith(")") else f"{text} ("
            symbol = symbol._replace(help=f"{start}{ALSO}{', --'.join(other_names)}).")
        if len(self.kinds) == 1:
            example = f"100{light_unit(member, self.kinds[0])}".replace(" ", ".")
            symbol = symbol._replace(example=example)
        hidden = [_row(self.symbol(other))._replace(hidden=True) for other in other_names]
        return [_row(symbol), *hidden]

    @property
    def result_names(self) -> list[str]:
        """The results by their names: those with laws, those for one kind of light, the others."""
        names = [*self.listed, *self.light, *self.others, *self.goals]
        of_kinds = [other for name in names for other in names_of_kinds(name)]
        further = [*self.results, *self.on_request]
        of_kinds += [other for name in further for other in names_of_kinds(name)]
        names += [*filter(None, [self.goal]), *of_kinds, *further]
        return [name for name in dict.fromkeys(names) if SYMBOLS[name].dimensions]

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


def _row(symbol: Symbol) -> Option:
    spellings = (f"--{symbol.name}",)
    return Option(spellings, symbol.example, mention(symbol.help), symbol.form, symbol.choices,
                  symbol=symbol)  # fmt: skip


def words_of(example: str) -> tuple[list[str], str]:
    """Return the words of an example, and its remark with the blanks before it."""
    call = re.sub(" {2,}.*", "", example)
    words = re.findall(r"(?:'[^']*'|[^\s'])+", call)
    return [word.replace("'", "") for word in words], example[len(call) :]
