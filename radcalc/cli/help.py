"""The help options: -h is one screen, --help is complete."""

import os
from inspect import cleandoc
from types import MappingProxyType

import click

from radcalc import terminal
from radcalc.calculators import page
from radcalc.cli.spelling import COMPLETE_HELP, SHORT_HELP

TYPE_CHECKING = False  # typing is slow to import
if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence
    from typing import Any

    from radcalc.cli.help_format import HelpFormatter

PIPED = 78  # the width of help in a pipe, for which Click imports the slow `shutil`
NO_PAGERS, NO_TERMINALS = ("", "cat"), ("", "dumb")  # values of PAGER and TERM


def _short(ctx: click.Context, parameter: click.Parameter, wanted: bool) -> None:
    if wanted and not ctx.resilient_parsing:
        ctx.color = is_colored()
        assert isinstance(ctx.command, Helped)
        terminal.write(ctx.command.get_short_help(ctx) + "\n")
        ctx.exit()


def _complete(ctx: click.Context, parameter: click.Parameter, wanted: bool) -> None:
    if wanted and not ctx.resilient_parsing:
        ctx.color = is_colored()
        show(ctx.get_help())
        ctx.exit()


def is_colored() -> bool:
    """Return whether help is coloured."""
    return terminal.wants_color(terminal.chosen_color(), terminal.is_terminal())


def show(text: str) -> None:
    """Write a text; page one that is longer than the terminal."""
    if not (_is_paged(text) and _has_shown(text)):
        terminal.write(f"{text}\n")


def _has_shown(text: str) -> bool:
    """Show a text in the pager; return whether it starts.

    The pager of older versions of Click takes no arguments, and may wait for keys.
    """
    import shlex
    import subprocess

    environment = dict(os.environ)
    if click.unstyle(text) != text and not environment.get("LESS"):
        environment["LESS"] = "-R"  # shows colours
    try:
        command = shlex.split(os.environ.get("PAGER", "less"))
        options = " ".join([environment.get("LESS", ""), *command[1:]])
        if not (os.path.basename(command[0]) == "less" and "R" in options.upper()):
            text = click.unstyle(text)
        subprocess.run(command, input=f"{text}\n".encode(), env=environment, check=False)
    except (OSError, ValueError):  # no such program, or a quote is missing in PAGER
        return False
    return True


def _is_paged(text: str) -> bool:
    if not terminal.is_terminal() or not os.isatty(0):
        return False
    pager = os.environ.get("PAGER", "less").strip()
    if pager in NO_PAGERS or os.environ.get("TERM", "") in NO_TERMINALS:
        return False
    from shutil import get_terminal_size

    return text.count("\n") + 1 >= get_terminal_size().lines


# Click's own option looks for a translation at every start.  The names are not that of the command
# `help`, whose settings at the prompt would be taken for the option's.
_FLAG: "dict[str, Any]" = {"is_flag": True, "is_eager": True, "expose_value": False}
SHORT, COMPLETE = page.HELPS
HELPS = (
    click.Option(
        [SHORT_HELP, "wants_short_help"],
        callback=_short,
        help=SHORT.help,
        **_FLAG,
    ),
    click.Option(
        [COMPLETE_HELP, "wants_help"],
        callback=_complete,
        help=COMPLETE.help,
        **_FLAG,
    ),
)


class Helped(click.Command):
    """A command whose help is written like an answer: completely, or with a failing status."""

    sections: "Mapping[str, Sequence[click.Option]]" = MappingProxyType({})  # by their titles

    def get_params(self, ctx: click.Context) -> list[click.Parameter]:
        return [*self.params, *HELPS]

    def make_parser(self, ctx: click.Context) -> click.parser._OptionParser:
        """Make the parser with short options among the long ones.

        Click takes them for misspelt long ones otherwise, and compares them with all options.
        """
        parser = super().make_parser(ctx)
        parser._long_opt |= parser._short_opt
        return parser

    def get_help(self, ctx: click.Context) -> str:
        formatter = _formatter(ctx)
        self.format_help(ctx, formatter)
        return formatter.getvalue().rstrip("\n")

    def get_short_help(self, ctx: click.Context) -> str:
        """Return the help of one screen."""
        from radcalc.cli.help_format import write_examples

        formatter = _formatter(ctx)
        self.format_usage(ctx, formatter)
        summary = self.short_help or cleandoc(self.help or "").partition("\n")[0]
        formatter.write("".join([f"{line}\n" for line in terminal.fold(summary, formatter.width)]))
        write_examples(self, self.sections, formatter)
        self.format_most_used(ctx, formatter)
        formatter.write(f"more: {ctx.command_path} {COMPLETE_HELP}")
        return formatter.getvalue()

    def format_most_used(self, ctx: click.Context, formatter: "HelpFormatter") -> None:
        """Write what the short help has below the examples."""
        from radcalc.cli.help_format import write_options

        write_options(self, self.sections, formatter, ctx)

    def format_epilog(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        first, *called = ctx.command_path.split()
        formatter.write(f"\nManual: {' '.join([first, 'manual', *called])}\n")


def _formatter(ctx: click.Context) -> "HelpFormatter":
    from radcalc.cli.help_format import HelpFormatter

    width = ctx.terminal_width
    if not width and not terminal.is_terminal() and "COLUMNS" not in os.environ:
        width = PIPED
    formatter = HelpFormatter(width=width, max_width=ctx.max_content_width)
    formatter.is_colored = bool(ctx.color)
    return formatter
