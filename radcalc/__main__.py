"""The entry point: the quick lane of a plain conversion, and Click for everything else."""

import sys


def main() -> int:
    """Run radcalc on the command line's words; return the exit status."""
    try:
        answered = quick_lane(sys.argv[1:])
        if answered is None:
            from radcalc.cli import run

            answered = run(sys.argv[1:])
        return answered
    except KeyboardInterrupt:
        return 130


def quick_lane(words: list[str]) -> int | None:
    """Answer `convert VALUE UNIT [to] UNIT [-n]` into a pipe before Click is imported.

    Whatever is not exactly that, any option and any error included, is left to Click (None),
    which says it properly.  Nothing on this lane loads re, dataclasses, typing or json.
    """
    number = words[-1:] == ["-n"]
    operands = words[1:-1] if number else words[1:]
    if words[:1] != ["convert"] or any(w[:1] == "-" and not w[1:2].isdigit() for w in operands):
        return None
    from radcalc import console
    from radcalc.conversion import plan
    from radcalc.errors import RadcalcError
    from radcalc.operands import read_operands
    from radcalc.render.plain import line
    from radcalc.units.table import resolve

    if console.is_terminal():
        return None
    try:
        value, source, target = read_operands(operands)
        if not target:
            return None
        made = plan(resolve(source), resolve(target))
        text = line(made.apply(value), target, number=number)
    except RadcalcError:
        return None
    try:
        console.write(text)
    except RadcalcError as error:
        return console.complain(error)
    console.say(console.remarks(made.assumptions, made.notes))
    return console.ANSWERED


if __name__ == "__main__":
    sys.exit(main())
