"""The boundary of the command line: commands are run, and every error gets an exit status."""

import os
import sys
from contextlib import suppress
from functools import partial

import click

from radcalc import terminal
from radcalc.calculators import COMMANDS
from radcalc.cli import spelling
from radcalc.cli.command import commands, protect_negatives
from radcalc.cli.spelling import EXPLAIN, HELP_NAMES
from radcalc.errors import MissingCondition, MissingUnit, RadcalcError, WrongQuantity, is_wordy

TYPE_CHECKING = False  # typing is slow to import
if TYPE_CHECKING:
    from collections.abc import Callable

    from radcalc.cli.output import Listener


def of_help(words: list[str]) -> list[str]:
    """Return `help` and `help COMMAND` as the --help option; other words are searched for."""
    if words[:1] != ["help"]:
        return words
    called = [word for word in words[1:] if word not in HELP_NAMES]
    if not words[1:] or (len(called) == 1 and called[0] in COMMANDS):
        return [*called, HELP_NAMES[-1]]
    return words


def run(words: list[str], error: BaseException | None = None) -> int:
    """Run a command, or a sentence with options; turn whatever happens into an exit status.

    An `error` is that of a run that has begun.
    """

    def answer() -> int:
        if error:
            raise error
        return run_or_refuse(words)

    return guarded(words, lambda: or_sentence(words, answer))


def or_sentence(
    words: list[str], answer: "Callable[[], int]", listener: "Listener | None" = None
) -> int:
    """Run `answer`; if it is refused, answer the words as a sentence, if they are one."""
    try:
        return answer()
    except MissingCondition:
        raise
    except (RadcalcError, click.UsageError) as error:
        if is_wordy(words):
            raise
        from radcalc.cli import sentence, trials

        run = partial(run_or_refuse, listener=listener)
        gate = sentence.Gate(run, trials.has_answers, listener)
        return sentence.instead(words, _problem(error, words), gate)


def guarded(words: list[str], answer: "Callable[[], int]", place: str = "") -> int:
    """Run `answer` and return the exit status; report an error with the `place` of the words."""
    try:
        return answer()
    except (RadcalcError, click.UsageError) as error:
        problem = error if isinstance(error, RadcalcError) else _problem(error, words)
    except KeyboardInterrupt:
        return terminal.INTERRUPTED
    except BrokenPipeError:
        return terminal.ANSWERED
    except MemoryError:
        problem = RadcalcError("not enough memory", "fewer values at a time")
    except Exception as error:
        return _bug(error)
    words, problem = _with_files(words, problem)
    if place:
        problem = problem.reworded(f"{place}: {problem.message}")
    from radcalc.cli import trials

    return trials.refuse(problem, words)


def _with_files(words: list[str], error: RadcalcError) -> tuple[list[str], RadcalcError]:
    """Return the call that a file as the first word means, and the error of a file."""
    if spelling.begins_with_file(words):
        try:
            words = spelling.call_of_file(words)
        except RadcalcError:
            return words, error
    return words, spelling.redirected(error, words)


def _problem(error: RadcalcError | click.UsageError, words: list[str]) -> RadcalcError:
    """Return an error with the hint that fits the words of a call."""
    if isinstance(error, RadcalcError) and not isinstance(error, (MissingUnit, WrongQuantity)):
        return error
    from radcalc.cli.refusals import about_unit, of_click

    if spelling.begins_with_file(words):
        with suppress(RadcalcError):
            words = spelling.call_of_file(words)
    return about_unit(error, words) if isinstance(error, RadcalcError) else of_click(error, words)


def run_or_refuse(words: list[str], listener: "Listener | None" = None) -> int:
    """Run a command like Click's `main`, without its own ways to exit; return the exit status.

    A listener hears every answer and has options for all commands.
    """
    if not words and not (words := _alone()):
        with commands.make_context("radcalc", [], resilient_parsing=True) as context:
            terminal.say(commands.get_help(context).splitlines())
        return terminal.FAILED
    if EXPLAIN in words:
        from radcalc.cli.sentence import explain

        return explain(words, listener)
    if spelling.begins_with_file(words):
        words = spelling.call_of_file(words)
        spelling.say(words, listener.settings if listener else None)
    words = protect_negatives(of_help(words))
    terminal.choose_color(_color_in(words, listener))
    settings = dict.fromkeys(COMMANDS, listener.settings) if listener else None
    try:
        with commands.make_context("radcalc", words, obj=listener, default_map=settings) as context:
            status = commands.invoke(context)
    except click.exceptions.Exit as left:
        status = left.exit_code
    return status if isinstance(status, int) else terminal.ANSWERED


def _color_in(words: list[str], listener: "Listener | None") -> str:
    """Return the value of --color, which is needed before Click has read it."""
    chosen: str = listener.settings.get("color", terminal.AUTO) if listener else terminal.AUTO
    for word, following in zip(words, [*words[1:], ""], strict=True):
        name, is_joined, value = word.partition("=")
        value = value if is_joined else following
        if name == "--color" and value in terminal.COLORING:
            chosen = value
    return chosen


def _alone() -> list[str]:
    return ["prompt"] if terminal.is_terminal() and os.isatty(0) else []


def _bug(error: Exception) -> int:
    from radcalc._version import __version__

    if os.environ.get("RADCALC_DEBUG") == "1":
        import traceback

        traceback.print_exc(file=sys.stderr)
    terminal.say(
        [
            f"radcalc: this is a bug in radcalc {__version__}",
            "try: the same with RADCALC_DEBUG=1, and report what it prints with the command",
        ]
    )
    return terminal.BUG
