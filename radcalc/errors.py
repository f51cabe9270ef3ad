"""The errors a user can cause: what went wrong, and what to do about it.

Every text that a user can get wrong ends in a `RadcalcError`. The command line prints its
message and its hint and exits with status 2; the Python API raises it.
"""

TYPE_CHECKING = False  # typing.TYPE_CHECKING, without the cost of importing typing
if TYPE_CHECKING:
    from collections.abc import Iterable

SHOWN = 60


def quote(text: str) -> str:
    """Make a user's text fit for a message: one line, printable, of bounded length."""
    text = text.replace("\u2212", "-")
    if len(text) > SHOWN:
        text = text[: SHOWN - 3] + "..."
    return "".join(c if c.isprintable() else ascii(c)[1:-1] for c in text)


def nearest(word: str, known: "Iterable[str]", count: int = 2, cutoff: float = 0.6) -> list[str]:
    """Choose the known words most like a word that is not known."""
    import difflib  # only when something is wrong already

    return difflib.get_close_matches(word[:SHOWN], list(known), n=count, cutoff=cutoff)


class RadcalcError(Exception):
    """Something the user can mend: `message` says what is wrong, `hint` what to do."""

    def __init__(self, message: str, hint: str = "") -> None:
        """Keep the message and the hint apart; `str()` gives both."""
        super().__init__(message)
        self.message = message
        self.hint = hint

    def __str__(self) -> str:
        """Both lines, as the command line shows them."""
        return f"{self.message}\ntry: {self.hint}" if self.hint else self.message


class NumberError(RadcalcError):
    """A text that is not a number radcalc reads, or a number that cannot be held."""


class UnitError(RadcalcError):
    """A text that is not a unit: unknown, ambiguous, malformed or refused."""


class ConversionError(RadcalcError):
    """No answer without more, or other, conditions."""


class ConditionError(RadcalcError):
    """A condition that is impossible, contradictory or without use."""


class UsageError(RadcalcError):
    """A call whose words do not fit together."""


class OutputError(RadcalcError):
    """What was answered could not be written."""


class LineError(RadcalcError):
    """A line of a stream that cannot be converted."""
