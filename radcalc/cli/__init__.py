"""The command line: one module per command, one boundary for every error.

What is said of a wrong command line is in `complaints`.
"""

import os
import sys

import click

from radcalc import stdio
from radcalc._version import __version__
from radcalc.cli.spelling import Shell
from radcalc.errors import (
    MINUS,
    MissingUnit,
    RadcalcError,
    UsageError,
    quote,
)
from radcalc.errors import manual as mention_help
from radcalc.units.numbers import is_sentence

TYPE_CHECKING = False  # typing.TYPE_CHECKING, without the cost of importing typing
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from radcalc.cli.options import Listener

# The commands in the order of the help, each with its line there.
COMMANDS = {
    "convert": "Convert units, and quantities under a condition.",
    "solid-angle": "Solid angles of shapes, plain and projected.",
    "direction": "Spherical coordinates and unit vectors.",
    "etendue": "Etendues, and the flux of a radiance.",
    "point-source": "Sources that are small beside their distance.",
    "environment": "What surrounds a place: maps, skies, expressions.",
    "scene": "Many sources, summed at points or over a grid.",
    "lambertian": "Diffuse sources and reflectors.",
    "sky": "The light of the sky, and of the sun beside it.",
    "uberlight": "The cinematographer's light of computer graphics.",
    "ev": "Exposure values and the light meter.",
    "calorimeter": "Radiant flux from the heat it leaves.",
    "screen": "The picture on a projection screen.",
    "dose": "What samples of light in time add up to.",
    "sensor": "Sensors: light, photons, electrons and current.",
    "laser": "Laser beams: the spot and the hazard distance.",
    "room": "The luminaires that light a room.",
    "integrate": "Integrals over directions.",
    "photon": "Wavelength, frequency and energy of a photon.",
    "spectrum": "Peak, efficacies and colour of a spectrum.",
    "mesopic": "Mesopic luminance by CIE 191:2010.",
    "units": "Units, their definitions and sources.",
    "quantities": "Names of the quantities, in three languages.",
    "typical": "Typical values: sun, sky, rooms, lamps, screens.",
    "prompt": "One line after another, with ans and names.",
}
HELP_NAMES = ["-h", "--help"]
SETTINGS: "dict[str, Any]" = {"help_option_names": HELP_NAMES, "max_content_width": 100}


def _help(ctx: click.Context, parameter: click.Parameter, wanted: bool) -> None:
    if wanted and not ctx.resilient_parsing:
        ctx.color = stdio.wants_color(stdio.chosen_color(), stdio.is_terminal())
        stdio.write(ctx.get_help() + "\n")
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
        from radcalc.cli.help import HelpFormatter

        formatter = HelpFormatter(width=ctx.terminal_width, max_width=ctx.max_content_width)
        formatter.is_colored = bool(ctx.color)
        self.format_help(ctx, formatter)
        return formatter.getvalue().rstrip("\n")

    def format_epilog(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Name the page of the manual, which is called as the command is."""
        formatter.write(f"\nManual: man {ctx.command_path.replace(' ', '-')}\n")


def _version(ctx: click.Context, parameter: click.Parameter, wanted: bool) -> None:
    if wanted and not ctx.resilient_parsing:
        stdio.write(f"radcalc {__version__}\n")
        ctx.exit()


class Commands(Helped, click.Group):
    """The subcommands, each imported when it is called and not for the help that lists them."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        """Name them all, in the order of the help."""
        return list(COMMANDS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """Import one."""
        if cmd_name not in COMMANDS:
            return None
        from importlib import import_module

        own = f"radcalc.cli.{cmd_name.replace('-', '_')}"
        found: click.Command
        try:
            found = import_module(own).command
        except ModuleNotFoundError as error:
            if error.name != own:
                raise
            from radcalc.cli.command import of_page

            found = of_page(cmd_name)  # a calculator's page says all that there is to it
        found.short_help = COMMANDS[cmd_name]
        return found

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Write the table of the commands."""
        with formatter.section("Commands"):
            formatter.write_dl(list(COMMANDS.items()))

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """Find the command, or say which one is near; what begins with a value is converted."""
        if is_sentence(args):
            return "convert", self.get_command(ctx, "convert"), args
        if args[0] not in COMMANDS and not args[0].startswith("-"):
            from radcalc.cli.complaints import meant

            raise UsageError(f"there is no command '{quote(args[0].strip())}'", meant(args))
        return super().resolve_command(ctx, args)


@click.command(cls=Commands, context_settings=SETTINGS, no_args_is_help=False)
@click.option(
    "--version",
    is_flag=True,
    is_eager=True,
    expose_value=False,
    callback=_version,
    help="Show the version and exit.",
)
def commands() -> None:
    """Calculate with light: units, photometry, radiometry, photons and their geometry.

    \b
    Examples:
      radcalc 100 lx fc                  (convert may be left out)
      radcalc convert 5 mW lm --wavelength 632.8nm
      radcalc convert 800 lm cd --isotropic
      radcalc solid-angle cone --half-angle 30deg
      radcalc point-source --flux 800lm --distance 2m
      radcalc lambertian --luminance 100cd/m2 --check exitance=628lm/m2
      radcalc units luminance
    """


def context(listener: "Listener | None" = None) -> click.Context:
    """The context of `radcalc` itself, to which nothing was typed."""
    return click.Context(commands, info_name="radcalc", obj=listener, **SETTINGS)


def protect_negatives(words: list[str]) -> list[str]:
    """Write the minus of words that are numbers in another way, so that Click sees no option.

    The - of a stream, as in '- nm', has a blank before it.
    """
    return [
        "→"
        if word == "->"
        else f" {word}"
        if word[:2] == "- "
        else MINUS + word[1:]
        if word[:1] == "-" and _is_negative(word)
        else word
        for word in words
    ]


def _is_negative(word: str) -> bool:
    if word[1:2] in ("", "-"):
        return False
    return is_sentence([word]) or word[1:].lower() in ("inf", "infinity", "nan")


def of_help(words: list[str]) -> list[str]:
    """`help [COMMAND]` as the option that it is."""
    if words[:1] != ["help"]:
        return words
    called = [word for word in words[1:] if word not in HELP_NAMES]
    if len(called) > 1 and called[0] in COMMANDS:
        raise UsageError("help is of one command", mention_help(called[0]))
    return [*called[:1], HELP_NAMES[-1]]


def run(words: list[str]) -> int:
    """Run a command; turn whatever happens into an exit status."""
    return guarded(words, lambda: answered(words))


def guarded(words: list[str], answer: "Callable[[], int]", place: str = "") -> int:
    """Answer words, or say what is wrong, and at which place they stand; return the status."""
    try:
        return answer()
    except RadcalcError as error:
        problem = error
        if isinstance(error, MissingUnit):
            from radcalc.cli.complaints import join_unit

            join_unit(error, words)
    except click.UsageError as error:
        from radcalc.cli.complaints import of_click

        problem = of_click(error, words)
    except KeyboardInterrupt:
        return stdio.INTERRUPTED
    except BrokenPipeError:
        return stdio.ANSWERED
    except MemoryError:
        problem = RadcalcError("not enough memory", "fewer values at a time")
    except Exception as error:
        return _bug(error)
    if place:
        problem.message = f"{place}: {problem.message}"
    return stdio.complain(problem, Shell)


def answered(words: list[str], listener: "Listener | None" = None) -> int:
    """Run a command; return the exit status.

    This is what Click's `main` does, without its own ways out.  A listener is told of every
    answer, and has options for all commands.
    """
    if not words and not (words := _alone()):
        with commands.make_context("radcalc", [], resilient_parsing=True) as context:
            stdio.say(commands.get_help(context).splitlines())
        return stdio.FAILED
    words = protect_negatives(of_help(words))
    stdio.choose_color(_color_in(words, listener))
    settings = dict.fromkeys(COMMANDS, listener.settings) if listener else None
    try:
        with commands.make_context("radcalc", words, obj=listener, default_map=settings) as context:
            status = commands.invoke(context)
    except click.exceptions.Exit as left:
        status = left.exit_code
    return status if isinstance(status, int) else stdio.ANSWERED


def _color_in(words: list[str], listener: "Listener | None") -> str:
    """What --color says, which help and refusals follow before Click has read it."""
    chosen: str = listener.settings.get("color", stdio.AUTO) if listener else stdio.AUTO
    for word, following in zip(words, [*words[1:], ""], strict=True):
        name, is_joined, value = word.partition("=")
        value = value if is_joined else following
        if name == "--color" and value in stdio.COLORING:
            chosen = value
    return chosen


def _alone() -> list[str]:
    """What `radcalc` alone is: the prompt, where somebody can type."""
    return ["prompt"] if stdio.is_terminal() and os.isatty(0) else []


def _bug(error: Exception) -> int:
    if os.environ.get("RADCALC_DEBUG") == "1":
        import traceback

        traceback.print_exc(file=sys.stderr)
    stdio.say(
        [
            f"radcalc: this is a bug in radcalc {__version__}: {type(error).__name__}",
            "try: the same with RADCALC_DEBUG=1, and report what it prints with the command",
        ]
    )
    return stdio.BUG
