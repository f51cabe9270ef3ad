"""The entry point: the quick lane of a plain conversion, and Click for everything else."""

import gc
import os
import sys


def main() -> None:
    """Run radcalc on the command line's words and leave.

    Everything is written and flushed by then, and taking an interpreter apart costs as much as
    a conversion: the process ends without it.  Nothing that is loaded becomes garbage, and looking
    for it while modules load costs a tenth of an answer: the collector waits for more objects than
    a start makes.
    """
    try:
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

    Whatever is not exactly that, any option and any error included, is left to Click (None),
    which says it properly.  Nothing on this lane loads re, dataclasses, typing or json.
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
        if amount.number < 0 and made.source.is_light:  # there is more to say
            return None
        text = line(made.apply(amount.number), made.target.text, bare=number)
    except Exception:  # an error or a bug: Click's boundary says it properly
        return None
    try:
        terminal.write(text)
    except RadcalcError as error:
        return terminal.complain(error)
    terminal.say(terminal.remarks(made.assumptions, made.notes))
    return terminal.ANSWERED


if __name__ == "__main__":
    main()
