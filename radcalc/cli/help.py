"""The help option, and the list of the commands."""

import click

from radcalc import terminal
from radcalc.calculators.pages import SUMMARIES

# In the order of the help.
COMMANDS = {
    **SUMMARIES,
    "mark": "Marks and points for the answers of students to a sheet.",
    "columns": "Columns of a table: units, extremes, means.",
    "units": "Units, their definitions and sources.",
    "quantities": "Names of quantities in three languages.",
    "typical": "Typical values: sun, sky, rooms, lamps, screens.",
    "examples": "Tasks with their commands, answers and how to read them.",
    "help": "Help for a command, or a search for words.",
    "prompt": "Interactive prompt, with ans and variables.",
}
HELP_NAMES = ["-h", "--help"]
EXPLAIN = "--explain"


def _help(ctx: click.Context, parameter: click.Parameter, wanted: bool) -> None:
    if wanted and not ctx.resilient_parsing:
        ctx.color = terminal.wants_color(terminal.chosen_color(), terminal.is_terminal())
        terminal.write(ctx.get_help() + "\n")
        ctx.exit()


# Click's own option looks for a translation at every start.  The name is not that of the command
# `help`, whose settings at the prompt would be taken for the option's.
HELP = click.Option(
    [*HELP_NAMES, "wants_help"],
    is_flag=True,
    is_eager=True,
    expose_value=False,
    callback=_help,
    help="Show this help and exit.",
)


class Helped(click.Command):
    """A command whose help is written like an answer: completely, or with a failing status."""

    def get_help_option(self, ctx: click.Context) -> click.Option | None:
        return HELP

    def get_help(self, ctx: click.Context) -> str:
        from radcalc.cli.help_format import HelpFormatter

        formatter = HelpFormatter(width=ctx.terminal_width, max_width=ctx.max_content_width)
        formatter.is_colored = bool(ctx.color)
        self.format_help(ctx, formatter)
        return formatter.getvalue().rstrip("\n")

    def format_epilog(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        formatter.write(f"\nManual: man {ctx.command_path.replace(' ', '-')}\n")
