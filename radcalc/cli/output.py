"""The output options that every command shares, and the choice of a renderer."""

import os
import sys
from collections.abc import Callable, Sequence
from functools import wraps
from typing import Any, NamedTuple, TypeVar

import click

from radcalc import stdio
from radcalc.answer import Result
from radcalc.errors import UsageError
from radcalc.quantities.language import ENGLISH, language

T = TypeVar("T")  # what a command returns: its exit status, or nothing
TABLE, PLAIN, JSON, CSV = "table", "plain", "json", "csv"


class Output(NamedTuple):
    """How an answer is to be shown, decided once."""

    format: str
    number: bool
    precision: int | None
    color: bool
    quiet: bool
    language: str = ENGLISH

    def show(self, results: Sequence[Result]) -> None:
        """Write the results to standard output, and remarks on them to standard error."""
        if self.format == TABLE:
            from radcalc.render import table

            said = not self.quiet
            stdio.write(
                table.render(results, width(), self.color, self.precision, said, self.language)
            )
        elif self.format == JSON:
            from radcalc.render import json

            stdio.write("".join(json.render(result, self.precision) for result in results))
        else:
            if self.format == CSV:
                from radcalc.render import csv

                stdio.write(csv.render(results, self.precision))
            else:
                from radcalc.render import plain

                number, precision = self.number, self.precision
                stdio.write("".join(plain.render(r, precision, number) for r in results))
            self.remark(results)

    def remark(self, results: Sequence[Result]) -> None:
        """Write to standard error what was assumed and noted, once each, and the derivations."""
        from radcalc.render.plain import derivation

        lines: list[str] = []
        if not self.quiet:
            said = [line for r in results for line in stdio.remarks(r.assumptions, r.notes)]
            lines = list(dict.fromkeys(said))
        stdio.say(lines + [line for r in results for line in derivation(r.steps)])


def width() -> int:
    """The terminal's width; 80 where there is none."""
    import shutil  # costs as much as a conversion, and only tables need it

    return shutil.get_terminal_size((80, 24)).columns


def options(function: Callable[..., T]) -> Callable[..., T]:
    """Add the output options to a command, which is called with what they decide: `shown`."""

    @wraps(function)
    def decided(
        *args: Any,
        number: bool,
        format_: str | None,
        json_: bool,
        precision: int | None,
        color: str,
        quiet: bool,
        **others: Any,
    ) -> T:
        shown = decide(format_, json_, number, precision, color, quiet)
        return function(*args, shown=shown, **others)

    for option in reversed(OPTIONS):
        decided = option(decided)
    return decided


OPTIONS = (
    click.option("-n", "--number", is_flag=True, help="Bare numbers only."),
    click.option(
        "--format",
        "format_",
        type=click.Choice([TABLE, PLAIN, JSON, CSV]),
        help="Default: a table on a terminal, plain text elsewhere.",
    ),
    click.option("--json", "json_", is_flag=True, help="Short for --format json."),
    click.option(
        "--precision",
        type=click.IntRange(1, 17),
        metavar="N",
        help="Significant digits (default: 6 in tables, 12 in plain text, all in JSON).",
    ),
    click.option(
        "--color",
        type=click.Choice(["auto", "always", "never"]),
        default="auto",
        help="Colour in tables (NO_COLOR and FORCE_COLOR are heeded).",
    ),
    click.option("-q", "--quiet", is_flag=True, help="No notes or assumptions."),
)


def decide(
    format_: str | None, json_: bool, number: bool, precision: int | None, color: str, quiet: bool
) -> Output:
    """Choose the format from the options and from what standard output is."""
    if json_ and format_ not in (None, JSON):
        raise UsageError(f"--json and --format {format_} contradict each other", "one of them")
    if number and (json_ or format_ not in (None, PLAIN)):
        raise UsageError("--number is plain text, and contradicts another format", "-n alone")
    chosen = JSON if json_ else PLAIN if number else format_
    terminal = stdio.is_terminal()
    if chosen is None:
        chosen = TABLE if terminal else PLAIN
    spoken = language() if chosen == TABLE else ENGLISH
    return Output(chosen, number, precision, wants_color(color, terminal), quiet, spoken)


def wants_color(color: str, terminal: bool) -> bool:
    """--color, then NO_COLOR, then FORCE_COLOR, then whether this is a terminal."""
    if color != "auto":
        return color == "always"
    if os.environ.get("NO_COLOR"):
        return False
    if os.environ.get("FORCE_COLOR"):
        return True
    return terminal and os.environ.get("TERM", "") not in ("", "dumb") and sys.stdout is not None
