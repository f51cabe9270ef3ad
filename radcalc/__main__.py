"""The entry point: a fast path for a plain conversion, and Click for everything else."""

import gc
import os
import sys

# The module `signal` is slow to import.
from _signal import (  # type: ignore[import-not-found]
    SIG_DFL,
    SIGINT,
    SIGTERM,
    default_int_handler,
    getsignal,
    signal,
)

TYPE_CHECKING = False  # typing.TYPE_CHECKING, without the cost of importing typing
if TYPE_CHECKING:
    from radcalc.errors import RadcalcError
    from radcalc.units import Unit

    Operands = tuple[float, Unit, Unit]


TERMINATED = 128 + SIGTERM  # the status that a shell gives the end by this signal


def main() -> None:
    """Run radcalc on the words of the command line and exit.

    All output is flushed before, and finalizing an interpreter takes as long as a conversion: the
    process exits without it.  Loaded modules do not become garbage, and collecting while they load
    takes a tenth of an answer: the threshold is above the objects of a start.
    """
    try:
        if callable(getsignal(SIGINT)):  # also the handler of the script that starts it
            signal(SIGINT, default_int_handler)
        if getsignal(SIGTERM) == SIG_DFL:
            signal(SIGTERM, _terminate)
        gc.set_threshold(50_000)
        status = run(sys.argv[1:])
    except KeyboardInterrupt:
        status = 130
    except SystemExit:
        status = TERMINATED
    os._exit(status)


def _terminate(*_: object) -> None:
    """End the process like a refusal does, so that no file with a temporary name remains."""
    raise SystemExit


def run(words: list[str]) -> int:
    """Answer the words of a command line, or a shell's Tab; return the exit status."""
    if asked := os.environ.get("_RADCALC_COMPLETE"):
        from radcalc import completion

        return completion.answer_shell(asked)
    answered = quick_lane(words)
    if answered is None:
        from radcalc import cli

        answered = cli.run(words)
    return answered


def quick_lane(words: list[str]) -> int | None:
    """Answer `[convert] VALUE UNIT [to] UNIT [-n]` into a pipe before Click is imported.

    Return None for anything else, including options and errors, which Click handles.  This path
    does not load re, dataclasses, typing or json, and a decimal in simple units not even errors.
    """
    from radcalc import terminal
    from radcalc.conversion import between, is_function
    from radcalc.render.plain import line

    number = words[-1:] == ["-n"]
    operands = words[:-1] if number else words
    is_named = words[:1] == ["convert"]
    if is_named:
        operands = operands[1:]
    if terminal.is_terminal():
        return None
    try:
        found = simplest(operands) or _any_units(operands, is_named)
        if not found or is_function(*found[1:]):
            return None
        value, source, target = found
        made = between(source, target)
        if value < 0 and source.is_light:  # it needs a note
            return None
        text = line(made.apply(value), target.text, bare=number)
    except Exception:  # an error or a bug, which Click's boundary reports
        return None
    try:
        terminal.write(text, exact=True)
    except _error_of_output() as error:
        return terminal.complain(error)
    terminal.say(terminal.remarks(made.assumptions, made.notes))
    return terminal.ANSWERED


def simplest(operands: list[str]) -> "Operands | None":
    """Read a decimal and two units of one spelling each, `100 lx fc` or `100 lx to fc`.

    Return None for other words: this is a shortcut of `_any_units`, whose modules take as long to
    load as a conversion.
    """
    from radcalc.floats import read_decimal
    from radcalc.units import single

    if operands[2:3] == ["to"]:
        operands = operands[:2] + operands[3:]
    if len(operands) != 3:
        return None
    value, source, target = read_decimal(operands[0]), single(operands[1]), single(operands[2])
    return None if value is None or not (source and target) else (value, source, target)


def _any_units(operands: list[str], is_named: bool) -> "Operands | None":
    """Read any value and units of a conversion; return None for other words."""
    from radcalc.units.numbers import is_sentence

    if not (is_named or is_sentence(operands)):
        return None
    if any(w[:1] == "-" and not w[1:2].isdigit() for w in operands):
        return None
    if sum(w[:1].isdigit() for w in operands) > 1:  # a sentence, or arithmetic
        return None
    from radcalc.conversion.operands import read_operands
    from radcalc.units.table import resolve

    amount, target = read_operands(operands)
    if not target or amount.unit is None or amount.is_uncertain or amount.scale:
        return None
    return amount.exact, amount.unit, resolve(target)


def _error_of_output() -> "type[RadcalcError]":
    from radcalc.errors import OutputError  # slow to import

    return OutputError


if __name__ == "__main__":
    main()
