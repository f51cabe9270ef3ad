"""The command line: one module per command.

Click is loaded for help, for errors and for options that are not of a calculator; a sentence and a
plain call of a calculator do without it.
"""

import os

from radcalc import terminal
from radcalc.calculators.pages import COMMANDS, SUMMARIES
from radcalc.cli.spelling import EXPLAIN, HELP_NAMES
from radcalc.errors import RadcalcError

VARIABLE = "RADCALC_DEFINITIONS"


def run(words: list[str]) -> int:
    """Run a command; turn whatever happens into an exit status."""
    if path := _definitions(words):
        from radcalc.inputs import definitions

        try:
            definitions.load(path)
        except RadcalcError as error:
            return terminal.complain(error)
    if words and words[-1] in HELP_NAMES:
        return _with_click(words)
    if EXPLAIN not in words:
        from radcalc.cli import habits

        try:
            words = habits.canonical(words)
        except RadcalcError as error:
            from radcalc.cli import trials

            return trials.refuse(error, words)
    status: int | BaseException | None = None
    if may_be_sentence(words):
        from radcalc.cli import lane

        status = lane.answer_sentence(words)
    elif words and words[0] in SUMMARIES:
        from radcalc.cli import lane

        status = lane.answer_in_full(words)
    return status if isinstance(status, int) else _with_click(words, status)


def _with_click(words: list[str], error: BaseException | None = None) -> int:
    from radcalc.cli import boundary

    return boundary.run(words, error)


def _definitions(words: list[str]) -> str:
    """Return the file of the user's definitions, '' without one."""
    for word, following in zip(words, [*words[1:], ""], strict=False):
        name, is_joined, value = word.partition("=")
        if name == "--definitions":
            return value if is_joined else following
    if VARIABLE in os.environ:
        return os.environ[VARIABLE]
    folder = os.environ.get("XDG_CONFIG_HOME") or os.path.expanduser("~/.config")
    path = os.path.join(folder, "radcalc", "definitions.txt")
    return path if os.path.exists(path) else ""


def may_be_sentence(words: list[str]) -> bool:
    """Return whether a call has several words, but neither a command nor options nor a stream."""
    return bool(words[1:]) and words[0] not in COMMANDS and not any(map(_is_option, words))


def _is_option(word: str) -> bool:
    """Return whether a word is an option, a negative number or a stream, or has an option in it."""
    return (word.lstrip()[:1] == "-" and word != "->") or " -" in word
