"""The words of a line being typed."""

from radcalc.completion.table import COMMANDS
from radcalc.units.numbers import is_sentence

TYPE_CHECKING = False  # typing is slow to import
if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence
    from typing import Any

HELP = "help"  # `radcalc help convert`
DIGITS = "0123456789"


class Completion:
    """A completion of a word; `closes` if a blank follows rather than more of the word."""

    __slots__ = ("closes", "description", "text")

    def __init__(self, text: str, description: str = "", closes: bool = True) -> None:
        self.text = text
        self.description = description
        self.closes = closes

    def after(self, text: str) -> "Completion":
        """Return the completion of a word that begins with a text."""
        return Completion(text + self.text, self.description, self.closes)

    def __repr__(self) -> str:
        """Show the word, and its blank."""
        return f"Completion({self.text + ' ' * self.closes!r}, {self.description!r})"


class Option:
    """A row of the table: the names of an option, its values, and its help."""

    __slots__ = ("form", "help", "hidden", "names", "repeats", "values")

    def __init__(self, row: "Sequence[Any]") -> None:
        self.names, self.form, self.values, self.help, self.hidden, self.repeats = row


class Line:
    """The words of a command before the word being typed.

    `given` has the texts of the options by their longest names; `waiting` is the option whose value
    comes next, and `offering` one with an optional file; after `--` every word is an operand.
    """

    def __init__(self, command: str, words: "Iterable[str]") -> None:
        self.command = command
        _, self.operand, option_rows = COMMANDS[command]
        self.options = [Option(row) for row in option_rows]
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
        return next((option for option in self.options if name in option.names), None)


def is_option(word: str) -> bool:
    """Return whether a word is read as an option, not a lone - or a negative number."""
    return word[:1] == "-" and not is_sentence([word])
