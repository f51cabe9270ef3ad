"""The entry point: a fast path for a plain conversion, and Click for everything else."""

import gc
import os
import sys

# The module `signal` is slow to import.
from _signal import SIGINT, default_int_handler, getsignal, signal  # type: ignore[import-not-found]


def main() -> None:
    """Run radcalc on the words of the command line and exit.

    All output is flushed before, and finalizing an interpreter takes as long as a conversion: the
    process exits without it.  Loaded modules do not become garbage, and collecting while they load
    takes a tenth of an answer: the threshold is above the objects of a start.
    """
    try:
        if callable(getsignal(SIGINT)):  # also the handler of the script that starts it
            signal(SIGINT, default_int_handler)
        gc.set_threshold(50_000)
        status = run(sys.argv[1:])
    except KeyboardInterrupt:
        status = 130
    os._exit(status)


def run(words: list[str]) -> int:
    """Answer the words of a command line, or a shell's Tab; return the exit status."""
    if asked := os.environ.get("_RADCALC_COMPLETE"):
        from radcalc.completion import shells, table

        if not table.COMMANDS:
            from radcalc.cli.compile import fill_table

            fill_table()
        return shells.answer(asked)
    answered = quick_lane(words)
    if answered is None:
        from radcalc import cli

        answered = cli.run(words)
    return answered


def quick_lane(words: list[str]) -> int | None:
    """Answer `[convert] VALUE UNIT [to] UNIT [-n]` into a pipe before Click is imported.

    Return None for anything else, including options and errors, which Click handles.  This path
    does not load re, dataclasses, typing or json.
    """
    from radcalc.units.numbers import is_sentence

    number = words[-1:] == ["-n"]
    operands = words[:-1] if number else words
    if words[:1] == ["convert"]:
        operands = operands[1:]
    elif not is_sentence(words):
        return None
    if any(w[:1] == "-" and not w[1:2].isdigit() for w in operands):
        return None
    from radcalc import terminal
    from radcalc.conversion.linear import between, is_function
    from radcalc.errors import RadcalcError
    from radcalc.render.plain import line
    from radcalc.units.reading import read_operands
    from radcalc.units.table import resolve

    if terminal.is_terminal():
        return None
    try:
        amount, target = read_operands(operands)
        if not target or amount.unit is None or amount.is_uncertain or amount.scale:
            return None
        unit = resolve(target)
        if is_function(amount.unit, unit):
            return None
        made = between(amount.unit, unit)
        if amount.number < 0 and made.source.is_light:  # it needs a note
            return None
        text = line(made.apply(amount.exact), made.target.text, bare=number)
    except Exception:  # an error or a bug, which Click's boundary reports
        return None
    try:
        terminal.write(text)
    except RadcalcError as error:
        return terminal.complain(error)
    terminal.say(terminal.remarks(made.assumptions, made.notes))
    return terminal.ANSWERED


if __name__ == "__main__":
    main()
