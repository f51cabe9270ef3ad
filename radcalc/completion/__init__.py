"""What can be typed next: for the shells (`shells`), and for a prompt in the same process.

The commands, their options and results are in `table`, which `python -m radcalc.cli.compile` prints
from them, so that Click, which takes longer than an answer may, stays out.
"""

import os

from radcalc.completion.table import COMMANDS, RADCALC
from radcalc.units.numbers import is_sentence

TYPE_CHECKING = False  # typing.TYPE_CHECKING, without the cost of importing typing
if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence
    from typing import Any

HELP = "help"  # `radcalc help convert`
DIGITS = "0123456789"


class Completion:
    """One way to finish a word; `closes` where a blank follows, and not more of the word."""

    __slots__ = ("closes", "description", "text")

    def __init__(self, text: str, description: str = "", closes: bool = True) -> None:
        """Hold the whole word."""
        self.text = text
        self.description = description
        self.closes = closes

    def __repr__(self) -> str:
        """Show the word, and its blank."""
        return f"Completion({self.text + ' ' * self.closes!r}, {self.description!r})"


class Option:
    """A row of the table: what an option is called, what it takes, what its help says."""

    __slots__ = ("form", "help", "hidden", "names", "repeats", "values")

    def __init__(self, row: "Sequence[Any]") -> None:
        """Read the row."""
        self.names, self.form, self.values, self.help, self.hidden, self.repeats = row


class Line:
    """The words of a command before the one that is being typed.

    `given` are the texts of the options by their longest names; `waiting` is the option whose value
    comes next, and `offering` one whose file may, or an operand; behind `--` everything is an
    operand.
    """

    def __init__(self, command: str, words: "Iterable[str]") -> None:
        """Tell options from operands."""
        self.command = command
        _, self.operand, own = COMMANDS[command]
        self.options = [Option(row) for row in own]
        self.given: dict[str, str] = {}
        self.operands: list[str] = []
        self.waiting: Option | None = None
        self.offering: Option | None = None
        self.is_closed = False
        for word in words:
            self._read(word)

    def _read(self, word: str) -> None:
        offered, self.offering = self.offering, None
        if self.waiting:
            self.given[self.waiting.names[-1]] = word
            self.waiting = None
        elif offered and word.lower().endswith(offered.values):
            self.given[offered.names[-1]] = word
        elif word == "--" and not self.is_closed:
            self.is_closed = True
        elif self.is_closed or not is_option(word):
            self.operands.append(word)
        else:
            name, equals, text = word.partition("=")
            option = self.option(name)
            if option:
                self.given[option.names[-1]] = text
                if option.form == "figure":
                    self.offering = None if equals else option
                elif option.form != "flag" and not equals:
                    self.waiting = option

    def option(self, name: str) -> Option | None:
        """The option of that name."""
        return next((one for one in self.options if name in one.names), None)


def is_option(word: str) -> bool:
    """Whether a word is read as an option: a lone - and a negative number are none."""
    return word[:1] == "-" and not is_sentence([word])


def completions(words: "Sequence[str]", incomplete: str) -> list[Completion]:
    """Every way to finish the word `incomplete`, which stands behind `words`; the best first.

    Neither has `radcalc` itself nor the quotes of a shell.
    """
    try:
        found = _found(list(words), incomplete)
    except Exception:  # whatever was typed, a Tab says nothing of it
        if os.environ.get("RADCALC_DEBUG") == "1":
            raise
        return []
    once: dict[str, Completion] = {}
    for one in found:
        if one.text.startswith(incomplete):
            once.setdefault(one.text, one)
    return list(once.values())


def _found(words: list[str], incomplete: str) -> list[Completion]:
    if not words:
        return _first(incomplete)
    if words[0] == HELP:
        return _commands(incomplete) if len(words) == 1 else []
    if words[0] in COMMANDS:
        return _in_command(Line(words[0], words[1:]), incomplete)
    if is_sentence(words):
        return _in_command(Line("convert", words), incomplete)
    return []


def _first(incomplete: str) -> list[Completion]:
    """A command, an option of radcalc itself, or the value of a conversion."""
    if incomplete == "-" or is_option(incomplete):
        return _options(map(Option, RADCALC), incomplete)
    if is_sentence([incomplete]):
        return _in_command(Line("convert", ()), incomplete)
    return [*_commands(incomplete), Completion(HELP, "Show the help of a command.")]


def _commands(incomplete: str) -> list[Completion]:
    return [
        Completion(name, row[0]) for name, row in COMMANDS.items() if name.startswith(incomplete)
    ]


def _in_command(line: Line, incomplete: str) -> list[Completion]:
    if line.waiting:
        return _values(line.waiting, incomplete)
    if not line.is_closed:
        name, equals, text = incomplete.partition("=")
        if equals and (option := line.option(name)):
            found = _values(option, text)
            return [Completion(name + equals + o.text, o.description, o.closes) for o in found]
        if incomplete == "-" or is_option(incomplete):
            return _fitting_options(line, incomplete)
    form, values = line.operand
    found = []
    if form == "conversion":
        from radcalc.completion.targets import operands

        found = operands(line.operands, line.given, incomplete)
    elif not line.operands or (form == "spectrum" and incomplete):  # several are compared
        from radcalc.completion.values import values_of

        found = values_of(form, values, incomplete)
    if line.offering:
        found = [*_values(line.offering, incomplete), *found]
    if not found and not incomplete:
        return _fitting_options(line, "" if not line.is_closed else "?")
    return found


def _values(option: Option, incomplete: str) -> list[Completion]:
    from radcalc.completion.values import values_of

    return values_of(option.form, option.values, incomplete)


def _fitting_options(line: Line, incomplete: str) -> list[Completion]:
    """The options that are not given yet, first those that the conversion lacks."""
    fitting = [one for one in line.options if one.repeats or one.names[-1] not in line.given]
    if line.command == "convert" and line.operands and incomplete in ("", "-", "--"):
        from radcalc.completion.targets import lacking

        wanted = lacking(line.operands, line.given)
        first = [one for one in fitting if one.names[-1].lstrip("-") in wanted]
        if first and not incomplete:
            return _options(first, incomplete)
        fitting = [*first, *fitting]
    return _options(fitting, incomplete)


def _options(options: "Iterable[Option]", incomplete: str) -> list[Completion]:
    """Options by their names: a hidden one, another name of another, where nothing else fits."""
    found: dict[bool, list[Completion]] = {False: [], True: []}
    for one in options:
        fitting = [name for name in one.names if name.startswith(incomplete)]
        if fitting:
            found[one.hidden].append(Completion(fitting[-1], one.help))
    return found[False] or found[True]
