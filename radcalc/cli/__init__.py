"""The command line: one module per command.

Click is loaded for help, for errors and for options that are not of a calculator; a sentence and a
plain call of a calculator do without it.
"""

import os

from radcalc import terminal
from radcalc.cli.spelling import EXPLAIN, HELP_NAMES
from radcalc.errors import RadcalcError

OPTION, VARIABLE = "--definitions", "RADCALC_DEFINITIONS"


def run(words: list[str]) -> int:
    """Read the words of a call, find the call that they mean, answer and show it, or refuse."""
    try:
        _load_definitions(words)
    except RadcalcError as error:
        return terminal.complain(error)
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
    if path := _file_of_definitions(words):
        from radcalc.inputs import definitions

        definitions.load(path)


def _file_of_definitions(words: list[str]) -> str:
    for word, following in zip(words, [*words[1:], ""], strict=False):
        name, is_joined, value = word.partition("=")
        if name == OPTION:
            return value if is_joined else following
    if VARIABLE in os.environ:
        return os.environ[VARIABLE]
    folder = os.environ.get("XDG_CONFIG_HOME") or os.path.expanduser("~/.config")
    path = os.path.join(folder, "radcalc", "definitions.txt")
    return path if os.path.exists(path) else ""
