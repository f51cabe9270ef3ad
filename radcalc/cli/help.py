"""The option that shows the help, and the list of the commands."""

import click

from radcalc import terminal
from radcalc.calculators.pages import SUMMARIES

# The commands in the order of the help, each with its line there.
COMMANDS = {
    **SUMMARIES,
    "units": "Units, their definitions and sources.",
    "quantities": "Names of the quantities, in three languages.",
    "typical": "Typical values: sun, sky, rooms, lamps, screens.",
    "prompt": "One line after another, with ans and names.",
}
HELP_NAMES = ["-h", "--help"]


def _help(ctx: click.Context, parameter: click.Parameter, wanted: bool) -> None:
    if wanted and not ctx.resilient_parsing:
        ctx.color = terminal.wants_color(terminal.chosen_color(), terminal.is_terminal())
        terminal.write(ctx.get_help() + "\n")
        ctx.exit()


# Click's own looks for a translation of its text at every start.
HELP = click.Option(
    HELP_NAMES,
    is_flag=True,
    is_eager=True,
    expose_value=False,
    callback=_help,
    help="Show this message and exit.",
)


class Helped(click.Command):
    """A command whose help is written as answers are: to its end, or not with status 0."""

    def get_help_option(self, ctx: click.Context) -> click.Option | None:
        """The option that shows the help."""
        return HELP

    def get_help(self, ctx: click.Context) -> str:
        """The help, laid out in the width of the terminal."""
        from radcalc.cli.help_format import HelpFormatter

        formatter = HelpFormatter(width=ctx.terminal_width, max_width=ctx.max_content_width)
        formatter.is_colored = bool(ctx.color)
        self.format_help(ctx, formatter)
        return formatter.getvalue().rstrip("\n")

    def format_epilog(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Name the page of the manual, which is called as the command is."""
        formatter.write(f"\nManual: man {ctx.command_path.replace(' ', '-')}\n")
