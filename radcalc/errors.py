"""Errors that a user can correct: the problem, and what to do.

Every invalid input ends in a `RadcalcError`.  The command line prints its message and its hint and
exits with status 2; the Python API raises it.  A message names a symbol of the vocabulary, or a
command, by a mention (`option("height")`), which the shell and Python spell differently:
`--height 6m` and `height="6 m"`.
"""

TYPE_CHECKING = False  # typing is slow to import
if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Sequence
    from typing import Any, TypeAlias, TypeVar

    Kind = TypeVar("Kind", bound="RadcalcError")

MINUS = "\u2212"  # pasted by people, and used for the - of a number on the command line
SHOWN = 60  # characters of a text
LISTED = 10  # names
MOST = 3  # calls of a hint that a gate makes
WORDS = 60  # of a sentence or a conversion
# The marks of a mention: private characters, which `quote` escapes.
START, VALUE, WORD, END = "\ue000", "\ue001", "\ue002", "\ue003"


def is_wordy(words: "Sequence[str]") -> bool:
    """Return whether words are too many for a sentence, a conversion or a hint."""
    return len(words) > WORDS or sum([word.count(" ") + 1 for word in words]) > WORDS


def printable(text: str) -> str:
    """Return one line without control characters, which are escaped as in Python."""
    if text.isprintable():
        return text
    return "".join([c if c.isprintable() else ascii(c)[1:-1] for c in text])


def quote(text: str) -> str:
    """Return a user's text for a message: one line, printable, of bounded length."""
    text = text.replace(MINUS, "-")
    return printable(text if len(text) <= SHOWN else text[: SHOWN - 3] + "...")


def quote_path(path: str) -> str:
    """Return a path for a message; a long one by its end, which has the file's name."""
    return quote(path if len(path) <= SHOWN else "..." + path[3 - SHOWN :])


def listed(names: "Sequence[str]", separator: str = ", ") -> str:
    """Return the first few of a user's names, and the number of the others."""
    more = len(names) - LISTED
    listing = separator.join([quote(name) for name in names[:LISTED]])
    return f"{listing} and {more} more" if more > 0 else listing


def ambiguous(text: str, readings: str = "") -> str:
    """Return the message for a text with several readings, unless the hint names them."""
    return f"'{quote(text)}' is ambiguous{f': {readings}' if readings else ''}"


def nearest(word: str, known: "Iterable[str]", count: int = 2, cutoff: float = 0.6) -> list[str]:
    """Return the known words most like an unknown one."""
    import difflib  # only after an error

    return difflib.get_close_matches(word[:SHOWN], list(known), n=count, cutoff=cutoff)


def option(name: str, value: str = "") -> str:
    """Mention a symbol, with a value (`2m`) or a placeholder for one (`ANGLE`) if given."""
    return f"{START}{name}{VALUE}{value}{END}"


def options(names: "Iterable[str]", word: str = " or ") -> str:
    """Mention several symbols."""
    return word.join([option(name) for name in names])


def mention(text: str) -> str:
    """Return a text with {name} and {name=value} replaced by mentions of symbols.

    A brace before a blank is not a mention.
    """
    head, *parts = text.split("{")
    for part in parts:
        inner, _, rest = part.partition("}")
        head += f"{{{part}" if part[:1] == " " else option(*inner.split("=", 1)) + rest
    return head


def mentioned(text: str) -> tuple[str, ...]:
    """Return the symbols that a text mentions."""
    names = [part.partition(VALUE)[0] for part in text.split(START)[1:]]
    return tuple(dict.fromkeys(filter(None, names)))


def command(name: str, *words: str, **inputs: str) -> str:
    """Mention a call of a command: `command("solid-angle", "cone", half_angle="1deg")`."""
    given = [f"{key.replace('_', '-')}={value}" for key, value in inputs.items()]
    return f"{START}{VALUE}{WORD.join([name, *words, *given])}{END}"


def manual(name: str) -> str:
    """Mention the help of a command."""
    return f"{START}{VALUE}{WORD}{name}{END}"


def measured(unit: str) -> str:
    """Mention the quantity that a unit measures: illuminance (lx)."""
    return f"{START}{WORD}{unit}{END}"


def spell(text: str, spelling: "Any") -> str:
    """Return a text with its mentions spelled.

    `spelling` has `option`, `command`, `manual` and `measured`.
    """
    if START not in text:
        return text
    head, *mentions = text.split(START)
    parts = [head]
    for mention in mentions:
        inner, _, rest = mention.partition(END)
        name, _, value = inner.partition(VALUE)
        if name.startswith(WORD):
            parts.append(spelling.measured(name[1:]))
        elif name:
            parts.append(spelling.option(name, value))
        elif value.startswith(WORD):
            parts.append(spelling.manual(value[1:]))
        else:
            parts.append(spelling.command(*value.split(WORD)))
        parts.append(rest)
    return "".join(parts)


class Plain:
    """The spelling of mentions without a shell or Python."""

    @staticmethod
    def option(name: str, value: str) -> str:
        return f"{name} {value}".strip()

    @staticmethod
    def command(*words: str) -> str:
        return " ".join(["radcalc", *words])

    @staticmethod
    def manual(name: str) -> str:
        return f"the help of {name}"

    @staticmethod
    def measured(unit: str) -> str:
        return f"'{unit}'"


class Try:
    """A call that a hint proposes: the user's call with changes, or another call.

    `inputs` are symbols that are added or replaced, with their values: `True` for a flag, and ""
    for the example of the command.  `without` are symbols that are left out, and `instead` is a
    word of the call with its replacement, or alone if it goes.  `words` are another call: a
    command, its operands and NAME=VALUE.  `remark` says what the call assumes.  Values that
    `follow` are computed from those of the user; others that the user did not type are examples.
    """

    __slots__ = ("follow", "inputs", "instead", "remark", "without", "words")

    def __init__(
        self,
        inputs: "tuple[tuple[str, str], ...]" = (),
        without: tuple[str, ...] = (),
        instead: tuple[str, ...] = (),
        words: tuple[str, ...] = (),
        remark: str = "",
        follow: bool = False,
    ) -> None:
        self.inputs, self.without, self.instead = inputs, without, instead
        self.words, self.remark, self.follow = words, remark, follow

    @property
    def is_call(self) -> bool:
        """Return whether it is another call, and not the help of a command."""
        return bool(self.words) and "help=" not in self.words

    def __eq__(self, other: object) -> bool:
        """Return whether two propose the same."""
        return isinstance(other, Try) and all(
            getattr(self, name) == getattr(other, name) for name in self.__slots__
        )

    def __hash__(self) -> int:
        """Return the same for the same proposals."""
        return hash((self.inputs, self.without, self.instead, self.words))

    def __str__(self) -> str:
        """Return the change in words, or the call, with mentions."""
        added = " with ".join([option(name, quote(value)) for name, value in self.inputs])
        left_out = f"leave out {options(self.without, ' and ')}" if self.without else ""
        if added and left_out:
            left_out = f"in place of {options(self.without, ' and ')}"
        text = f"{added} {left_out}".strip() if added else left_out
        if self.instead:
            typed, *others = self.instead
            text = quote(" ".join(others)) if others else f"leave out {quote(typed)}"
        if self.words:
            text = command(*map(quote, self.words))
        return f"{text}, {self.remark}" if self.remark else text


def add(name: str, value: str = "", remark: str = "") -> Try:
    """Propose a symbol with a value, in place of its former value if it has one."""
    return Try(((name, value),), remark=remark)


def computed(proposal: Try) -> Try:
    """Return a proposal whose values follow from those of the user."""
    proposal.follow = True
    return proposal


def leave_out(*names: str) -> Try:
    """Propose the call without some symbols."""
    return Try(without=names)


def correct(typed: str, *words: str, remark: str = "") -> Try:
    """Propose a correction of a part of a word, or several words or none in place of a word."""
    return Try(instead=(typed, *words), remark=remark)


def drop(word: str) -> Try:
    """Propose the call without a word."""
    return Try(instead=(word,))


def corrections(typed: str, *others: str, remark: str = "") -> "list[Try]":
    """Propose several corrections of a word."""
    return [correct(typed, other, remark=remark) for other in others]


def alternatives(typed: str, hint: str) -> "list[Try]":
    """Propose what a hint lists in place of a word: `A (why), B for that or C: why`."""
    head, _, why = hint.partition(": ")
    tries = []
    for part in head.replace(", ", " or ").split(" or "):
        name, blank, remark = part.partition(" ")
        if not name or (blank and remark[0] != "(" and not remark.startswith("for ")):
            return []
        is_aside = why and remark[:1] == "("
        tries.append(correct(typed, name, remark=why if is_aside else remark.strip("()") or why))
    return tries


def one_of(*names: str) -> "list[Try]":
    """Propose each of several symbols without the others."""
    return [leave_out(*(other for other in names if other != name)) for name in names]


def call(*words: str, remark: str = "", **inputs: str) -> Try:
    """Propose a call of a command: `call("solid-angle", "cone", half_angle="1deg")`."""
    given = [f"{key.replace('_', '-')}={value}" for key, value in inputs.items()]
    return Try(words=(*words, *given), remark=remark)


def input_of(word: str) -> tuple[str, str]:
    """Return the name and the value of NAME=VALUE in a proposed call, and ("", word) for others.

    The name of a flag has an empty value.  A path is not a pair: `call_of_file` gives it a slash.
    """
    name, equals, value = word.partition("=")
    is_name = bool(equals) and name.replace("-", "").isalnum()
    return (name, value) if is_name else ("", word)


def with_correction(text: str, typed: str, correction: str) -> str:
    """Return a text with a correction: of whole words and numbers, or else of parts of them."""
    import re

    before, after = "", ""
    if typed[:1].isalpha():
        before = r"(?<![^\W\d_])"
    elif typed[:1].isdigit():
        before = r"(?<![\d.])"
    if typed[-1:].isalnum():
        after = r"(?![\d.])" if typed[-1:].isdigit() else r"(?!\w)"
    whole = re.sub(f"{before}{re.escape(typed)}{after}", lambda _: correction, text)
    return whole if whole != text else text.replace(typed, correction)


APART, TOGETHER = (" or ", ", or ", ", ", ""), (" and ", " with ")  # between mentions


def proposed(hint: str) -> "list[Try]":
    """Return the calls that a hint of mentions alone proposes; none for a hint in prose.

    The mentions are alternatives, or are joined by `and` or `with`; a remark may follow the last.
    """
    head, *parts = hint.split(START)
    if not parts or head not in ("", "add ", "leave out ", "leave out one of "):
        return []
    groups: list[list[str]] = [[]]
    remark = ""
    for place, part in enumerate(parts, 1):
        mention, _, rest = part.partition(END)
        groups[-1].append(mention)
        if rest in APART:
            groups.append([])
        elif place == len(parts) and rest.startswith((",", ":", " for ", " (")):
            remark = rest.lstrip(",: ")
        elif rest not in TOGETHER:
            return []
    groups = [group for group in groups if group]
    if head.startswith("leave out"):
        return [leave_out(*(mention.partition(VALUE)[0] for mention in group)) for group in groups]
    tries = [_of_mentions(group) for group in groups]
    if tries[-1]:
        tries[-1].remark = remark
    return [one for one in tries if one]


def _of_mentions(mentions: "list[str]") -> "Try | None":
    if any(mention.startswith(WORD) for mention in mentions):
        return None
    if mentions[0].startswith(VALUE + WORD):
        return Try(words=(mentions[0][2:], "help=")) if len(mentions) == 1 else None
    if mentions[0].startswith(VALUE):
        words = tuple(mentions[0][1:].split(WORD))
        return computed(Try(words=words)) if len(mentions) == 1 else None
    pairs = [mention.split(VALUE) for mention in mentions]
    return Try(tuple([(name, "" if _is_placeholder(value) else value) for name, value in pairs]))


def _is_placeholder(value: str) -> bool:
    """Return whether a value of a mention is a name for values: ANGLE, but not 5W or ND8."""
    return value.isupper() and not any(map(str.isdigit, value))


Hint: "TypeAlias" = "str | Try | Sequence[Try]"


class RadcalcError(Exception):
    """An error that the user can correct: `message` is the problem, `hint` what to do.

    Both may have mentions; `spelled` spells them.  `tries` are the calls that the hint proposes:
    a gate makes them before it shows them.  `missing` describes what is missing, with the symbols
    that supply it.  A function gives a hint that takes long, once it is needed.
    """

    hint: str
    tries: tuple[Try, ...]

    def __init__(
        self,
        message: str,
        hint: "Hint | Callable[[], Hint]" = "",
        tries: "Sequence[Try]" = (),
    ) -> None:
        super().__init__(message)
        self.message: str = message
        self.missing: dict[str, tuple[str, ...]] = {}
        if callable(hint):
            self._later = hint
        else:
            self._propose(hint, tries)

    def _propose(self, hint: "Hint", tries: "Sequence[Try]" = ()) -> None:
        if not isinstance(hint, str):
            tries = (hint,) if isinstance(hint, Try) else hint
            hint = " or ".join(map(str, tries))
        elif not tries:
            tries = proposed(hint)
        self.hint, self.tries = hint, tuple(tries)

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> "Any":
            """Return the hint, or its calls, that a function gives."""
            if name not in ("hint", "tries") or "_later" not in self.__dict__:
                raise AttributeError(name)
            self._propose(self.__dict__.pop("_later")())
            return self.__dict__[name]

    @property
    def others(self) -> list[str]:
        """Return the symbols that the hint mentions, and that no call of it adds or leaves out.

        They are further ways where calls of the hint add symbols.
        """
        added = {name for one in self.tries[:MOST] for name, _ in one.inputs}
        left_out = {name for one in self.tries for name in one.without}
        known = {*added, *left_out, "get"}
        return [name for name in mentioned(self.hint) if name not in known] if added else []

    @property
    def code(self) -> str:
        """Return the kind of the error, as a program reads it: `missing-condition`."""
        kind = next(kind for kind in type(self).__mro__ if kind.__module__ == __name__)
        name = "".join([f"-{c.lower()}" if c.isupper() else c for c in kind.__name__])
        return name.removeprefix("-").removesuffix("-error").replace("radcalc", "call")

    def __reduce__(self) -> "tuple[Any, ...]":
        """Return the pickled form, with its fields."""
        _ = self.hint  # which may be given by a function
        return _remade, (type(self), self.args, self.__dict__)

    def reworded(
        self: "Kind", message: str = "", hint: "Hint" = "", tries: "Sequence[Try]" = ()
    ) -> "Kind":
        """Return a copy with another message or hint, or with calls for a hint in words."""
        _ = self.hint  # which may be given by a function
        error: Kind = _remade(type(self), self.args, self.__dict__)
        error.message = message or self.message
        error.tries = tuple(tries) or self.tries
        if hint:
            other = RadcalcError("", hint)
            error.hint, error.tries = other.hint, other.tries
        return error

    def spelled(self, spelling: "Any") -> tuple[str, str]:
        return spell(self.message, spelling), spell(self.hint, spelling)

    def __str__(self) -> str:
        """Return both lines."""
        message, hint = self.spelled(Plain)
        return f"{message}\ntry: {hint}" if hint else message


def _remade(kind: "type[Kind]", args: "tuple[Any, ...]", fields: "dict[str, Any]") -> "Kind":
    error = kind.__new__(kind, *args)
    error.__dict__.update(fields)
    return error


class NumberError(RadcalcError):
    """A text that radcalc does not read as a number, or a number that a float cannot hold."""


class OutOfRange(NumberError):
    """A number larger or smaller than a float can hold."""


class ExpressionError(NumberError):
    """Arithmetic without a value: malformed, of different quantities, or out of bounds."""


class UnitError(RadcalcError):
    """A text that is not a unit: unknown, ambiguous, malformed or refused."""


class ConversionError(RadcalcError):
    """A conversion that needs more, or other, conditions."""


class ConditionError(RadcalcError):
    """A condition that is out of range, contradictory or unused."""


class TooMany(ConditionError):
    """More values, or more answers, than are allowed."""


class UsageError(RadcalcError):
    """A call with words that do not fit together."""


class TooManyWords(UsageError):
    """A conversion with more words than a value and two units; it may be a sentence."""


class NoFile(UsageError):
    """A word with the ending of a file that does not exist."""


class SeveralReadings(UsageError):
    """A sentence that several calls may mean."""


class UnknownResult(UsageError):
    """The name of a result that the answer does not have; `names` are those that it has."""

    def __init__(self, message: str, names: "Sequence[str]", hint: "Hint" = "") -> None:
        super().__init__(message, hint or ", ".join(names))
        self.names = tuple(names)


class OutputError(RadcalcError):
    """An answer that cannot be written."""


class LineError(RadcalcError):
    """A line of a stream that cannot be converted."""


class MissingCondition(ConversionError):
    """A conversion that lacks conditions."""

    def __init__(
        self,
        message: str,
        hint: str,
        source: str,
        target: str,
        missing: "dict[str, tuple[str, ...]]",
        tries: "Sequence[Try]" = (),
    ) -> None:
        super().__init__(message, hint, tries)
        self.source, self.target, self.missing = source, target, missing


class MissingInput(UsageError):
    """A missing input; the hint mentions the symbols that supply it."""

    def __init__(self, message: str, hint: "Hint", tries: "Sequence[Try]" = ()) -> None:
        super().__init__(message, hint, tries)
        self.missing = {"an input": mentioned(self.hint)}


class MissingUnit(ConditionError):
    """A bare number for a symbol with a unit; `written` is the number with a likely unit.

    `several` is the list or the range that the number is in.
    """

    def __init__(
        self, symbol: str, text: str, written: str, number: str = "", several: str = ""
    ) -> None:
        super().__init__(f"the unit of {option(symbol, text)} is missing", add(symbol, written))
        self.symbol, self.text, self.written, self.number = symbol, text, written, number
        self.several = several

    def of_all(self, text: str) -> "MissingUnit":
        """Return the error for all the values of a list or a range."""
        written = _with_units(text, self.written.removeprefix(self.number))
        return type(self)(self.symbol, quote(text), written, self.number, text)

    def with_unit(self, written: str) -> "MissingUnit":
        """Return the error with another unit, that of `written`."""
        if self.several:
            written = _with_units(self.several, written.removeprefix(self.number))
        return self.reworded(hint=add(self.symbol, written))


def _with_units(several: str, unit: str) -> str:
    mark = ":" if ":" in several else ","
    return mark.join([part.strip() + unit for part in several.split(mark)])


class WrongQuantity(ConditionError):
    """A value of a quantity that a symbol does not take; `text` is the value as typed.

    An array has no such text.
    """

    def __init__(self, message: str, hint: "Hint", symbol: str, text: str) -> None:
        super().__init__(message, hint)
        self.symbol, self.text = symbol, text


class Unused(ConditionError):
    """Inputs that do not apply; `where` completes the sentence: "to a cone", "without a tilt"."""

    def __init__(self, symbols: "Sequence[str]", where: str, hint: "Hint" = "") -> None:
        verb = "does" if len(symbols) == 1 else "do"
        message = f"{options(symbols, ' and ')} {verb} not apply {where}"
        super().__init__(message, hint or leave_out(*symbols))
        self.symbols = tuple(symbols)


class Idle(ConditionError):
    """An input that gives no result alone; `symbols` are those in the hint."""

    def __init__(self, message: str, hint: "Hint") -> None:
        super().__init__(message, hint)
        self.symbols = mentioned(self.hint)


class Impossible(ConditionError):
    """A value outside the range of its symbol: `limit` is that range, `because` the reason.

    `nearest` is the nearest value in the range, as it would be typed.
    """

    def __init__(
        self, symbol: str, text: str, limit: str, because: str = "", nearest: str = ""
    ) -> None:
        reason = f": {because}" if because else ""
        tries = []
        if nearest:
            tries = [computed(add(symbol, nearest, f"({option(symbol)}: {limit})"))]
        super().__init__(f"{option(symbol, quote(text))} is out of range{reason}", limit, tries)
        self.symbol, self.text, self.limit, self.because = symbol, text, limit, because


class TooNarrow(ConditionError):
    """A wavelength range that excludes too much of one kind of light for its ratio to another."""


INVERSE_SQUARE = "the inverse square law"


class TooNear(ConditionError):
    """A patch closer than five times its size, where the far-field law does not hold.

    `distance` names the distance, `size` is the patch's [m]; `law` is the law.
    """

    def __init__(
        self, distance: str, body: str, size: str, hint: "Hint", law: str = INVERSE_SQUARE
    ) -> None:
        farther = add("distance", f"{5.001 * float(size):.4g}m")
        super().__init__(
            f"{distance} is too short: the size of the {body} is {size} m, and {law} needs at "
            "least five times that",
            hint,
            [*proposed(hint), farther] if isinstance(hint, str) else (),
        )


class HorizonCuts(ConditionError):
    """An angle at which the plane of one patch may cut the other.

    `least` is the steepest angle at which it does not; `hint` overrides it.
    """

    def __init__(
        self, symbol: str, text: str, least: str, hint: "Hint" = "", law: str = INVERSE_SQUARE
    ) -> None:
        turned, cut = "receiver", "source"
        if symbol == "tilt":
            turned, cut = cut, turned
        super().__init__(
            f"{option(symbol, quote(text))}: the {turned}'s horizon may cut the {cut}, and {law} "
            "does not hold",
            hint or f"{option(symbol, least)}, or as far past 90 deg, where there is no light",
        )


class Exclusive(ConditionError):
    """Inputs that exclude each other."""

    def __init__(
        self, symbols: "Sequence[str]", because: str = "", hint: "Hint" = "only one of them"
    ) -> None:
        first, *others = symbols
        reason = f": {because}" if because else ""
        message = f"{option(first)} cannot be used with {options(others, ' and ')}{reason}"
        super().__init__(message, hint, one_of(*symbols))
        self.symbols = tuple(symbols)


class Contradiction(ConditionError):
    """Two values of one symbol: the given one and the calculated one [SI]."""

    def __init__(
        self, message: str, hint: "Hint", symbol: str, given: "Any", follows: "Any"
    ) -> None:
        names = sorted(mentioned(str(hint)), key=lambda name: name != symbol)
        super().__init__(message, hint, [leave_out(name) for name in names])
        self.symbol, self.given, self.follows = symbol, given, follows
