"""The command line: one module per command.

Click is loaded for help, for errors and for options that are not of a calculator; a sentence and a
plain call of a calculator do without it.
"""

import os

from radcalc import terminal
from radcalc.calculators import COMMANDS
from radcalc.cli.spelling import EXPLAIN, HELP_NAMES, spelled
from radcalc.errors import WORDS, ConditionError, RadcalcError, UsageError, add, call, quote

OPTION = "--definitions"
# First words of calls that only show texts; they are answered whatever the file of definitions has.
TEXTS = ("help", "manual", "--version")


def run(words: list[str]) -> int:
    """Read the words of a call, find the call that they mean, answer and show it, or refuse."""
    try:
        _load_definitions(words)
    except RadcalcError as error:
        if words[:1] not in [[text] for text in TEXTS] and not {*HELP_NAMES} & {*words}:
            message = f"{error.message}; try {error.hint}"
            without = add("definitions", os.devnull, "without the file")
            return _refuse(ConditionError(message, "", [without]), words)
        terminal.say(terminal.remarks((), [spelled(error.message)]))
    except Exception as error:
        return _with_click(words, error)
    if len(words) > WORDS and (words[0] == "convert" or words[0] not in COMMANDS):
        problem = f"too many words: {quote(' '.join(words[:WORDS]))}"
        return _refuse(UsageError(problem, call("convert", "help=")), words)
    status: int | BaseException | None = None
    if EXPLAIN not in words and words[-1:] not in [[name] for name in HELP_NAMES]:
        from radcalc.cli import lane, spelling

        try:
            words = spelling.canonical(words)
        except RadcalcError as error:
            return _refuse(error, words)
        status = lane.answer(words)
    return status if isinstance(status, int) else _with_click(words, status)


def _with_click(words: list[str], error: BaseException | None) -> int:
    from radcalc.cli import boundary

    return boundary.run(words, error)


def _refuse(error: RadcalcError, words: list[str]) -> int:
    from radcalc.cli import trials

    return trials.refuse(error, words)


def _load_definitions(words: list[str]) -> None:
    """Load the user's definitions, if there are any."""
    if path := terminal.definitions_file(value_of_option(words)):
        from radcalc.inputs import definitions

        definitions.load(path)


def value_of_option(words: list[str]) -> str | None:
    """Return the file of definitions that the words of a call name."""
    for word, following in zip(words, [*words[1:], ""], strict=False):
        name, is_joined, value = word.partition("=")
        if name == OPTION:
            return value if is_joined else following
    return None
