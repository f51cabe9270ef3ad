"""State of the prompt: reading a line, the last answer, and variables.

A line is a command or a sentence, without `radcalc`.  Texts of amounts replace `ans` and the
names of variables before a line is read, so the commands do not know them.
"""

import re
from collections.abc import Mapping, Sequence
from functools import partial
from itertools import pairwise
from string import ascii_letters
from typing import TYPE_CHECKING, Any

import click

from radcalc import terminal
from radcalc.answer import Result, Row
from radcalc.calculators import COMMANDS
from radcalc.calculators.page import DEFAULTS
from radcalc.cli import OPTION, boundary, value_of_option
from radcalc.cli.command import commands, context, protect_negatives
from radcalc.cli.output import decide
from radcalc.cli.request import is_stream
from radcalc.cli.spelling import EXPLAIN, refuse_long, split
from radcalc.conversion.operands import read_operands
from radcalc.errors import RadcalcError, UsageError, add, call, listed, quote
from radcalc.quantities import LUMINOUS, symbols
from radcalc.quantities.names import full_name
from radcalc.quantities.search import is_name
from radcalc.sentences import ENDS
from radcalc.units import unit_behind, values
from radcalc.units.grammar import ALSO_UNITS, TO
from radcalc.units.numbers import FUNCTIONS, Amount, is_sentence, read_number
from radcalc.units.reading import read_amount
from radcalc.units.table import unit_of
from radcalc.units.uncertain import SIGN

if TYPE_CHECKING:
    from radcalc.homework.question import Question

ANS = "ans"
LEAVING = ("exit", "quit")
ALSO_LEAVING = (*LEAVING, "bye", "q", "logout")  # words that people type to exit
WORDS = {"help": "The commands, or a search.", "vars": "The variables and their values."}
WORDS |= dict.fromkeys(LEAVING, "Leave the prompt.")
SEPARATING = {*TO, *ALSO_UNITS}
RESERVED = {ANS, *WORDS, *COMMANDS, *SEPARATING, *FUNCTIONS, "radcalc", "per", "pi", "π"}
OF_AMOUNTS = {
    symbols.QUANTITY,
    symbols.INTERVAL,
    symbols.POINT,
    symbols.VECTOR,
    symbols.GRID,
    symbols.DIRECTION,
    symbols.NUMBERS,
}  # forms of symbols
OPERANDS_ARE_AMOUNTS = {"convert", "photon"}
LIMITS = ("", ",", ":")  # characters of a value in a list or a range

ASSIGNMENT = re.compile(r"\s*([^\W\d]\w*)\s*=(.*)", re.S)
NAME = re.compile(r"(?<![\w.])[^\W\d]\w*(?:(?<=\bans)\.[a-z][a-z0-9]*(?:-[a-z0-9]+)*)?(?![\w(])")
OPERATIONS = "-+*/^·×⋅∙−"
ARITHMETIC = re.compile(rf"[{OPERATIONS}]|[^\s-]+[{OPERATIONS}]|[*/·×⋅∙]\S+")  # goes on in the next

EXAMPLES = {
    "100 lx fc": "A value with its unit, converted.",
    "2 * 100 lx in fc": "Arithmetic.",
    "ans klx": "The last answer; ans.NAME is one of several results.",
    "800 cd at 3 m to lx": "A sentence, also with ans or a variable for an amount.",
    "x = 800 lm": "A variable keeps an amount or an answer.",
    "vars": "The variables and their values.",
    "help WORD": "Help for a command, or a search for a word.",
    "exit": "Exit; also Ctrl-D.",
}


class Session:
    """The lines of a prompt, one after another; `settings` are output options for all."""

    def __init__(self, settings: Mapping[str, Any] | None = None, has_stdin: bool = True) -> None:
        self.settings = dict(settings or {})
        self.has_stdin = has_stdin
        self.variables: dict[str, str] = {}
        self.rows: list[Row] = []  # of the last line with any
        self.origins: dict[str, set[int]] = {}  # of the uncertainty of names and ans
        self.count = 0  # lines

    def names(self, with_words: bool = False) -> dict[str, str]:
        """Return the names of amounts with their values, and the prompt's words if requested."""
        last = {ANS: "The last answer."} if self.rows else {}
        results = dict.fromkeys(row.name for row in self.rows if row.name)
        if len(self.rows) > 1:
            last |= {f"{ANS}.{name}": "One of its results." for name in results}
        return (WORDS if with_words else {}) | last | self.variables

    def hear(self, results: Sequence[Result]) -> None:
        for result in results:  # a conversion has one value, in one or more units
            self.heard += result.rows if result.named else result.rows[:1]

    def ask(self, question: "Question") -> None:
        """Let a question be answered: the prompt hears the right answer."""

    def answer(self, line: str, place: str = "") -> int:
        """Answer a line as at the shell; raise EOFError if it exits the prompt."""
        if line.strip() in LEAVING:
            raise EOFError
        words: list[str] = []
        return boundary.guarded(words, lambda: self._answer(line, words), place)

    def _answer(self, line: str, words: list[str]) -> int:
        """Answer a line and return its status; keep its results for `ans` and for its variable."""
        if not line.strip() or line.lstrip().startswith("#"):
            return terminal.ANSWERED
        refuse_long(line)
        self.heard: list[Row] = []
        assignment = ASSIGNMENT.fullmatch(line)
        name, text = (assignment[1], assignment[2]) if assignment else ("", line)
        if assignment:
            refuse_name(name, text)
        if not assignment and self._leaves(line):
            hint = f"{LEAVING[0]}, alone in its line, or Ctrl-D"
            raise UsageError(f"'{quote(line.strip())}' is not the command to exit", hint)
        self.count += 1
        called = self.read(text)
        words[:] = _as_typed(called, split(text))
        if (file := value_of_option(words)) is not None:  # its units are units in every line
            start = call("prompt", OPTION, file or "FILE")
            raise UsageError(f"{OPTION} is read once, when radcalc starts", start)
        amount = _amount(called)
        if amount and (name or not _is_plain(amount) or self._has_names(text)):
            answer = partial(self._show, amount, called)
        elif called or not name:
            answer = partial(self._run, called)
        else:
            raise UsageError(f"{name} = has no value", f"{name} = 800 lm")
        status = boundary.or_sentence(words, answer, self)
        if name and status == terminal.ANSWERED:
            self.variables[name] = _text(amount) if amount else self._kept(name)
            self.origins[name] = self.used | {self.count}
        if self.heard:
            self.rows, self.origins[ANS] = self.heard, self.used | {self.count}
        return status

    def _leaves(self, line: str) -> bool:
        """Return whether a line is meant to exit the prompt, and does not begin with a variable."""
        first = line.split()[0].rstrip("();.").lstrip(":")
        return first.lower() in ALSO_LEAVING and first not in self.variables

    def _has_names(self, text: str) -> bool:
        return any(self._is_name(name) for name in NAME.findall(text))

    def read(self, line: str) -> list[str]:
        self.used: set[int] = set()  # origins of the uncertainties in it
        words = split(line)
        called = words[0] if words else ""
        if EXPLAIN in words:
            return self._in_sentence(words)
        if called in COMMANDS or (called[:1] == "-" and not is_sentence(words)):
            return [called, *self._filled(called, words[1:])]
        if is_sentence(words) or self._begins_with_name(called):
            return ["convert", *self._filled("convert", words)]
        return self._in_sentence(words)

    def _in_sentence(self, words: list[str]) -> list[str]:
        """Replace words that are names of amounts."""
        return [self._fill(word) if NAME.fullmatch(word.rstrip(ENDS)) else word for word in words]

    def _begins_with_name(self, word: str) -> bool:
        match = NAME.match(word)
        return match is not None and self._is_name(match[0])

    def _is_name(self, name: str) -> bool:
        return name.partition(".")[0] == ANS or name in self.variables

    def _filled(self, called: str, words: list[str]) -> list[str]:
        """Replace names by amounts in the operands and the option values of a command."""
        takers = _takers(called)
        operands: list[str] = []
        filled: list[str] = []
        remaining = iter(words)
        for word in remaining:
            if not _is_option(word):
                operands.append(word)
                if called != "convert":
                    is_amount = called in OPERANDS_ARE_AMOUNTS
                    filled.append(self._fill(word) if is_amount else word)
                continue
            name, equals, value = word.partition("=")
            filled.append(f"{name}={self._value(name, value)}" if equals else name)
            if name in takers and not equals:
                filled += [self._value(name, value) for value in [next(remaining, None)] if value]
        return [*self._operands(operands), *filled] if called == "convert" else filled

    def _value(self, name: str, text: str) -> str:
        symbol = symbols.SYMBOLS.get(name.removeprefix("--"))
        if name == "--check":
            result, equals, value = text.rpartition("=")
            return f"{result}{equals}{self._fill(value)}"
        return self._fill(text) if symbol and symbol.form in OF_AMOUNTS else text

    def _fill(self, text: str, is_part: bool = False) -> str:
        """Replace names by amounts: in brackets, unless they are the whole text."""

        def amount(match: re.Match[str]) -> str:
            if not self._is_name(match[0]):
                return match[0]
            before, after = text[: match.start()], text[match.end() :]
            kept = self._text_of(match[0])
            if before[-1:] in LIMITS and after[:1] in LIMITS and not is_part:
                return kept
            return f"({kept})"

        return NAME.sub(amount, text)

    def _text_of(self, name: str) -> str:
        """Return the text of the amount that a name means.

        An uncertain value may occur in a line only once: values are taken as independent.
        """
        owner, _, result = name.partition(".")
        text = self.variables.get(name) or text_of(self._only_row(result, self.rows, name), name)
        if (amount := _read(text)) and amount.is_uncertain:
            if self.used & self.origins[owner]:
                problem = f"{name} is correlated with another uncertain value in this line"
                raise UsageError(problem, "a line in which each uncertain value stands once")
            self.used |= self.origins[owner]
        return text

    def _only_row(self, result: str, rows: Sequence[Row], name: str) -> Row:
        """Return the only row that a name can mean; refuse a name with none or several."""
        if not rows:
            raise UsageError(f"{name} has no value yet", "an answer before it, such as 100 lx fc")
        known = (result, symbols.in_kind(result, LUMINOUS))
        matching = [row for row in rows if not result or row.name in known]
        if len(matching) == 1:
            return matching[0]
        names = list(dict.fromkeys(row.name for row in rows if row.name))
        if not matching:
            raise UsageError(f"the last answer has no '{quote(result)}'", listed(names))
        if len(names) < 2 or result:
            problem = f"{name} is one value, but there are {len(matching)}"
            raise UsageError(problem, "a call with one answer")
        raise UsageError(
            f"{name} is one value, but the answer has several",
            listed([f"{ANS}.{known}" for known in names])
            if name == ANS
            else [add("get", known) for known in _sought(rows, names)],
        )

    def _operands(self, words: list[str]) -> list[str]:
        """Replace names in the operands of a conversion; arithmetic is one word, as in quotes."""
        is_part = words[:1] != ["-"] and any(map(ARITHMETIC.fullmatch, words))
        filled = [self._fill(word, is_part) for word in words]
        is_one = is_part and words[-1] != "-" and {*words}.isdisjoint(TO)
        return [" ".join(filled)] if is_one else filled

    def _run(self, words: list[str]) -> int:
        called = words[0] if words else ""
        if called == "vars" and not words[1:]:
            self._list()
            return terminal.ANSWERED
        if words == ["help"]:
            terminal.write(_help())
            return terminal.ANSWERED
        if called == "prompt" and not words[1:]:
            raise UsageError("this is the prompt", "help, or exit")
        streams = [one for last, one in pairwise(words) if last == called or last[:2] == "--"]
        if not self.has_stdin and any(map(is_stream, streams)):
            problem = "- cannot be used at the prompt, which reads standard input"
            raise UsageError(problem, "the same at a shell")
        return boundary.run_or_refuse(words, self) if words else terminal.ANSWERED

    def _list(self) -> None:
        """Write the variables and the last answer as lines that can be typed."""
        texts = dict(self.variables)
        if len(self.rows) == 1:
            texts[ANS] = text_of(self.rows[0], ANS)
        terminal.write("".join(f"{name} = {text}\n" for name, text in texts.items()))

    def _kept(self, name: str) -> str:
        if not self.heard:
            raise UsageError(f"the amount for {name} is missing", f"{name} = 800 lm")
        return text_of(self._only_row("", self.heard, name), name)

    def _show(self, amount: Amount, words: list[str]) -> int:
        if unit := amount.typed[1]:
            return boundary.run_or_refuse([*words, "to", unit.text], self)
        output = decide(**(DEFAULTS | self.settings), listener=self)
        row = Row("", "", amount.number, "1", name="number", uncertainty=amount.uncertainty)
        output.show([Result((row,), named=False)])
        return terminal.ANSWERED


def _help() -> str:
    from radcalc.cli.help import HelpFormatter

    formatter = HelpFormatter(max_width=context().max_content_width)
    for title, rows in (("At the prompt", EXAMPLES), ("Commands", COMMANDS)):
        with formatter.section(title):
            formatter.write_dl(list(rows.items()))
    return formatter.getvalue().lstrip("\n")


def refuse_name(name: str, text: str) -> None:
    """Refuse a name that already has a meaning."""
    if name in RESERVED:
        what = "a word of radcalc"
    elif values.find_scale(name):
        what = "a scale"
    elif unit := unit_of(name):
        what = " ".join(["the unit", full_name(unit)]).rstrip()
    elif is_name(name):
        what = "a quantity"
    else:
        return
    text = text.strip()
    hint = f"my_{name} = {text}" if quote(text) == text else "another name"
    raise UsageError(f"'{quote(name)}' is already {what}", hint)


def text_of(row: Row, name: str) -> str:
    """Return the exact text of a row's value, with its unit."""
    if isinstance(row.value, bool) or not isinstance(row.value, (int, float)):
        raise UsageError(f"{name} is not a number", "a call with a number for its answer")
    return _exact(row.value, row.unit, row.uncertainty)


def _exact(number: float, unit: str, uncertainty: float) -> str:
    digits = repr(float(number)).removesuffix(".0")
    if uncertainty:
        digits += f"{SIGN}{repr(float(uncertainty)).removesuffix('.0')}"
    return digits + unit_behind(unit)


def _sought(rows: Sequence[Row], names: list[str]) -> list[str]:
    """Return the names of the results that were not given, or of all if there is none."""
    given = {row.name for row in rows if row.given}
    return [name for name in names if name not in given] or names


def _as_typed(called: list[str], typed: list[str]) -> list[str]:
    """Return the words of a call for the hints of its refusal: in the order typed.

    A call in which names or arithmetic were replaced keeps its order.
    """
    if called[:1] == ["convert"] != typed[:1] and is_sentence(called[1:]):
        called = called[1:]
    return typed if sorted(typed) == sorted(called) else called


def _takers(called: str) -> set[str]:
    """Return the options of a command that take the next word as their value."""
    if called not in COMMANDS:
        return set()
    command = commands.get_command(context(), called)
    options = (
        [option for option in command.params if isinstance(option, click.Option)] if command else []
    )
    # a value [=N] is never the next word
    takers = [o for o in options if not o.is_flag and not (o.metavar or "").startswith("[=")]
    return {text for option in takers for text in option.opts}


def _is_option(word: str) -> bool:
    return word[:1] == "-" and word[1:2] in ("-", *ascii_letters) and not _is_negative(word)


def _is_negative(word: str) -> bool:
    return protect_negatives([word]) != [word]


def _read(text: str) -> Amount | None:
    try:
        return read_amount(text)
    except RadcalcError:
        return None


def _amount(words: list[str]) -> Amount | None:
    """Return the amount that words mean, if they are only an amount."""
    if words[:1] != ["convert"] or any(map(_is_option, words)) or words[1:2] == ["-"]:
        return None
    try:
        amount, target = read_operands(words[1:])
    except RadcalcError:  # a bare number, or an error that the command reports best
        bare = _read(" ".join(words[1:]))
        return bare if bare and bare.unit is None else None
    return None if target else amount


def _is_plain(amount: Amount) -> bool:
    unit = amount.unit.text if amount.unit else ""
    if amount.scale:
        return True
    if amount.is_uncertain:
        return not amount.parts
    try:
        return amount.text[read_number(amount.text)[1] :].strip() == unit
    except RadcalcError:
        return False


def _text(amount: Amount) -> str:
    """Return the text of an amount as typed, or the value of arithmetic.

    Arithmetic with it needs brackets around a fraction with its unit.
    """
    if _is_plain(amount):
        if not amount.unit or amount.scale or amount.uncertainty:
            return amount.text
        number = amount.text[: read_number(amount.text)[1]]
        return f"({number}) {amount.unit.text}" if "/" in number else amount.text
    return _exact(amount.number, amount.unit.text if amount.unit else "1", amount.uncertainty)
