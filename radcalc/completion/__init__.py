"""Completion of the next word, for the shells (`shells`) and for a prompt in the same process.

`radcalc.completion.rows` prints the `table` of commands and options for a wheel, so that
completion does not load Click, which is too slow.
"""

import os

from radcalc.completion.table import COMMANDS, RADCALC
from radcalc.completion.words import HELP, Completion, Line, Option, is_option
from radcalc.units.numbers import is_sentence

TYPE_CHECKING = False  # typing is slow to import
if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence


def completions(words: "Sequence[str]", incomplete: str) -> list[Completion]:
    """Return every completion of the word `incomplete` after `words`, the best first.

    The words are without `radcalc` itself and without the quotes of a shell.
    """
    try:
        candidates = _candidates(list(words), incomplete)
    except Exception:  # a Tab never reports an error
        if os.environ.get("RADCALC_DEBUG") == "1":
            raise
        return []
    once: dict[str, Completion] = {}
    for candidate in candidates:
        if candidate.text.startswith(incomplete):
            once.setdefault(candidate.text, candidate)
    return list(once.values())


def _candidates(words: list[str], incomplete: str) -> list[Completion]:
    if not words:
        return _first(incomplete)
    if words == [HELP] and (commands := _commands(incomplete)):
        return commands
    if words[0] in COMMANDS:
        return _in_command(Line(words[0], words[1:]), incomplete)
    if is_sentence(words):
        return _in_command(Line("convert", words), incomplete)
    return []


def _first(incomplete: str) -> list[Completion]:
    if incomplete == "-" or is_option(incomplete):
        return _options(map(Option, RADCALC), incomplete)
    if is_sentence([incomplete]):
        return _in_command(Line("convert", ()), incomplete)
    return _commands(incomplete)


def _commands(incomplete: str) -> list[Completion]:
    return [
        Completion(name, row[0]) for name, row in COMMANDS.items() if name.startswith(incomplete)
    ]


def _in_command(line: Line, incomplete: str) -> list[Completion]:
    """Return completions of a word after a command: values, options or operands."""
    if line.waiting:
        return _values(line.waiting, incomplete)
    if not line.is_closed:
        name, equals, text = incomplete.partition("=")
        if equals and (option := line.option(name)):
            return [value.after(name + equals) for value in _values(option, text)]
        if incomplete == "-" or is_option(incomplete):
            return _fitting_options(line, incomplete)
    form, values = line.operand
    candidates = []
    if form == "conversion":
        from radcalc.completion.targets import operands

        candidates = operands(line.operands, line.given, incomplete)
    elif not line.operands or (form == "spectrum" and incomplete):  # several spectra are compared
        from radcalc.completion.words import values_of

        candidates = values_of(form, values, incomplete)
    if line.offering:
        candidates = [*_values(line.offering, incomplete), *candidates]
    if not candidates and not incomplete:
        return _fitting_options(line, "" if not line.is_closed else "?")
    return candidates


def _values(option: Option, incomplete: str) -> list[Completion]:
    from radcalc.completion.words import values_of

    return values_of(option.form, option.values, incomplete)


def _fitting_options(line: Line, incomplete: str) -> list[Completion]:
    """Return the options not given yet, first those that the conversion lacks."""
    fitting = [
        option for option in line.options if option.repeats or option.names[-1] not in line.given
    ]
    if line.command == "convert" and line.operands and incomplete in ("", "-", "--"):
        from radcalc.completion.targets import lacking

        wanted = lacking(line.operands, line.given)
        first = [option for option in fitting if option.names[-1].lstrip("-") in wanted]
        if first and not incomplete:
            return _options(first, incomplete)
        fitting = [*first, *fitting]
    return _options(fitting, incomplete)


def _options(options: "Iterable[Option]", incomplete: str) -> list[Completion]:
    """Return options by name; hidden ones, which are other names, only if no other fits."""
    by_hidden: dict[bool, list[Completion]] = {False: [], True: []}
    for option in options:
        fitting = [name for name in option.names if name.startswith(incomplete)]
        if fitting:
            by_hidden[option.hidden].append(Completion(fitting[-1], option.help))
    return by_hidden[False] or by_hidden[True]
