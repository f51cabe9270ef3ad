"""Options that several commands share, as Click has them."""

from collections.abc import Sequence
from typing import Any

import click

from radcalc import terminal
from radcalc.render.formats import FORMATS
from radcalc.terminal import INVALID

# Lists have no numbers to print; the hidden options give better errors.
NUMERIC = ("number", "precision", "auto")


class Whole(click.Option):
    """An option for a whole number, whose help states the limits in words."""

    def get_help_extra(self, ctx: click.Context) -> Any:
        return {}


COLOR = click.Option(
    ["--color"],
    type=click.Choice(terminal.COLORING),
    default=terminal.AUTO,
    help="Colour on a terminal (NO_COLOR and FORCE_COLOR are respected).",
)


def _options(hidden: Sequence[str] = ()) -> tuple[click.Option, ...]:
    all_options = (
        click.Option(["-n", "--number"], is_flag=True, help="Print bare numbers only."),
        click.Option(
            ["--format", "format_"],
            type=click.Choice(FORMATS),
            help="Format of the output (default: a table on a terminal, else plain).",
        ),
        click.Option(["--json", "json_"], is_flag=True, help="Same as --format json."),
        Whole(
            ["--precision"],
            type=click.IntRange(1, 17),
            metavar="N",
            help="Significant digits, from 1 to 17 (default: 6 in tables, 12 in plain text, all in "
            "JSON).",
        ),
        COLOR,
        click.Option(
            ["--auto"],
            is_flag=True,
            help="Choose SI prefixes that fit: 2.1 mlx, not 0.0021 lx.",
        ),
        click.Option(["-q", "--quiet"], is_flag=True, help="Omit notes and assumptions."),
        click.Option(
            ["--definitions"],
            metavar="FILE",
            help="Units, constants and spectra of your own (default: ~/.config/radcalc/"
            "definitions.txt).",
        ),
    )
    for option in all_options:
        option.hidden = option.name in hidden
    return all_options


OPTIONS, OF_LISTS = _options(), _options(hidden=NUMERIC)
NAMES = tuple([option.name or "" for option in OPTIONS])
STEPS = click.Option(["--steps"], is_flag=True, help="Show the derivation.")


def defaults() -> dict[str, Any]:
    """Return the default output options."""
    nothing = click.Command(None, params=[*OPTIONS], add_help_option=False)
    return nothing.make_context("", []).params


TOLERANCE = click.Option(
    ["--tolerance"],
    metavar="1%",
    help="Allowed deviation: 1% (default), 0.5lx, or 3sf (3 significant digits).",
)
# Homework: a check of an answer.
OF_CHECKS = (
    click.Option(
        ["--check"],
        metavar="[NAME=]VALUE[UNIT]",
        help="Compare VALUE, your own answer, with the result.  If it is wrong, radcalc names the "
        "likely mistake and exits with status 1.",
    ),
    TOLERANCE,
)

# Lines of standard input: shown by convert, and hidden in calculators.
OF_LINES = (
    click.Option(
        ["--field"],
        metavar="LIST",
        help="Fields to convert, by number: 3, 1,3, 2-4, 3- (from 3 on), or - (all).",
    ),
    click.Option(
        ["--column"],
        metavar="NAME",
        help="Field to convert: its title, with or without its unit (E for E [lx]), or its number.",
    ),
    click.Option(
        ["-d", "--delimiter"],
        metavar="X",
        help="Field separator: one character, or tab (default: runs of blanks).",
    ),
    Whole(
        ["--header"],
        type=click.IntRange(1),
        metavar="[=N]",
        help="Number of header lines (1 without N; --column implies 1).  Every line must have as "
        "many fields as the header.  If a title has a unit, it must be the input unit; the unit of "
        "the result replaces it.",
    ),
    click.Option(
        ["--add"],
        metavar="NAME",
        help="Keep the field, and append a field with this title for the result.",
    ),
    click.Option(
        ["--rename"],
        metavar="NAME",
        help="New title of the field; required if the result is another quantity.",
    ),
    click.Option(
        ["--decimal"],
        type=click.Choice([".", ","]),
        help="Decimal mark of input and output: a comma, or a point (the default).",
    ),
    click.Option(
        ["--invalid"],
        type=click.Choice(INVALID),
        help="Treatment of unreadable lines.  abort (default): stop at the first.  fail, warn, "
        "ignore: copy them unchanged, and fail at the end (status 2), warn (status 0) or say "
        "nothing (status 0).",
    ),
)
