"""The command `radcalc` itself, and its subcommands."""

import click

from radcalc import terminal
from radcalc.calculators.page import EXPLAIN as OF_EXPLAIN
from radcalc.calculators.page import VERSION
from radcalc.calculators.pages import COMMANDS
from radcalc.cli.help import Helped
from radcalc.cli.spelling import EXPLAIN, GROUPS, HELP_NAMES, own_module
from radcalc.errors import MINUS, UsageError, quote
from radcalc.units.numbers import is_sentence

TYPE_CHECKING = False  # typing is slow to import
if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    from radcalc.cli.command import SectionedCommand
    from radcalc.cli.output import Listener

# The module `help` has what all commands share, and `lists` has several commands.
LISTS = ("units", "typical", "quantities", "examples", "manual")
OTHERWISE = {"help": "findings", "columns": "dose", **dict.fromkeys(LISTS, "lists")}
SETTINGS: "dict[str, Any]" = {"help_option_names": HELP_NAMES, "max_content_width": 100}


def _version(ctx: click.Context, parameter: click.Parameter, wanted: bool) -> None:
    if wanted and not ctx.resilient_parsing:
        from radcalc._version import __version__

        terminal.write(f"radcalc {__version__}\n")
        ctx.exit()


class Commands(Helped, click.Group):
    """The subcommands, imported only when called."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        return list(COMMANDS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        if cmd_name not in COMMANDS:
            return None
        module = own_module(OTHERWISE.get(cmd_name, cmd_name))
        name = f"{cmd_name}_command"
        name = name if hasattr(module, name) else "command"
        command: click.Command | None = getattr(module, name, None)
        if command is None:
            from radcalc.cli.command import of_page

            command = of_page(cmd_name)
        command.short_help = COMMANDS[cmd_name]
        return command

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        width = max(map(len, COMMANDS))
        for title, names in GROUPS.items():
            with formatter.section(title):
                formatter.write_dl([(f"{name:{width}}", COMMANDS[name]) for name in names])

    def format_most_used(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        with formatter.section("Commands"):
            formatter.write_dl([(title, ", ".join(names)) for title, names in GROUPS.items()])

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """Find the command, or suggest one; a call that begins with a value is a conversion."""
        if is_sentence(args):
            return "convert", self.get_command(ctx, "convert"), args
        if args[0] not in COMMANDS and not args[0].startswith("-"):
            from radcalc.cli.files import absent_file, similar_calls

            if absent := absent_file(args):
                raise absent
            raise UsageError(f"unknown command '{quote(args[0].strip())}'", similar_calls(args))
        return super().resolve_command(ctx, args)


@click.command(cls=Commands, context_settings=SETTINGS, no_args_is_help=False)
@click.option(
    "--version",
    is_flag=True,
    is_eager=True,
    expose_value=False,
    callback=_version,
    help=VERSION.help,
)
@click.option(
    EXPLAIN,
    is_flag=True,
    expose_value=False,
    help=OF_EXPLAIN.help,
)
def commands() -> None:
    """Calculate with light: units, photometry, radiometry, photons, geometry.

    \b
    Examples:
      radcalc 100 lx fc                   (the word convert is optional)
      radcalc 20000 cd at 8 m to lx       (a sentence)
      radcalc lamp.ies at 3 m             (a luminaire: .ies, .ldt)
      radcalc log.csv                     (any file: a CSV, .hdr, .exr ...)
      radcalc 700 ppfd lx --spectrum sun  (the reading of a PAR meter)
      radcalc convert 5 mW lm --wavelength 632.8nm
      radcalc convert 800 lm cd --isotropic
      radcalc solid-angle cone --half-angle 30deg
      radcalc point-source --flux 800lm --distance 2m
      radcalc lambertian --luminance 100cd/m2 --check exitance=628lm/m2
      radcalc units luminance
    """


def context(listener: "Listener | None" = None) -> click.Context:
    """Return an empty context of `radcalc` itself."""
    return click.Context(commands, info_name="radcalc", obj=listener, **SETTINGS)


def parameters(called: str) -> list[click.Parameter]:
    """Return the options and arguments of a command, or of `radcalc` itself."""
    top = context()
    return (commands.get_command(top, called) or commands).get_params(top)


def command_of(name: str) -> "SectionedCommand":
    """Return a command by its name."""
    command = commands.get_command(context(), name)
    assert command is not None, name
    return command  # type: ignore[return-value]


def examples_of(name: str) -> list[list[str]]:
    """Return the words of the examples in the help of a command."""
    examples = []
    for line in (command_of(name).help or "").splitlines():
        start, _, call = line.partition("radcalc ")
        words = call.partition("  ")[0].split()
        if line[:1] == " " and not start.strip() and words[0] == name:
            examples.append(protect_negatives(words))
    return examples


def called_in(words: "Sequence[str]") -> str:
    """Return the command of a call; "" if it has none."""
    if is_sentence(list(words)):
        return "convert"
    return next((word for word in words if word in COMMANDS), "")


def protect_negatives(words: list[str]) -> list[str]:
    """Replace the minus of negative numbers, so that Click does not read them as options.

    The - of a stream with a unit, '- nm', gets a blank before it.
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
