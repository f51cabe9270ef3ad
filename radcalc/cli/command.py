"""The command `radcalc`, its subcommands, and their help with options in sections."""

import os
from collections.abc import Callable, Sequence
from functools import cache
from typing import Any

import click

from radcalc import terminal
from radcalc.calculators import COMMANDS, page_of
from radcalc.calculators.page import (
    DEFAULTS,
    LINES,
    OUTPUTS,
    VERSION,
    WHOLE,
    Option,
    Page,
    words_of,
)
from radcalc.calculators.page import EXPLAIN as OF_EXPLAIN
from radcalc.cli.help import HELPS, Helped
from radcalc.cli.output import decide
from radcalc.cli.request import TO_TERMINAL
from radcalc.cli.spelling import EXPLAIN, GROUPS, HELP_NAMES, Shell, own_module, spelled
from radcalc.errors import MINUS, Hint, Try, UsageError, add, correct, mention, quote
from radcalc.quantities.symbols import CHOICE, FLAG, SYMBOLS
from radcalc.units.numbers import is_sentence

TYPE_CHECKING = False  # typing is slow to import

if TYPE_CHECKING:
    from collections.abc import Sequence
    from typing import Any

    from radcalc.cli.output import Listener

# Endings of a word after --plot that is its file, not an operand.
FIGURES = (".svg", ".png", ".pdf", ".ps", ".eps", ".jpg", ".jpeg", ".gif", ".webp", ".tif", "/")


def define(
    name: str, page: Page, text: str | None = None
) -> Callable[[Callable[..., Any]], "SectionedCommand"]:
    """Make a command of its page and of a function.

    `text` replaces the page's examples and remarks in the help.  Without an `about` of the page,
    the help is the function's docstring.

    The function is called with `typed`, the texts of the given symbols; `shown`, the output;
    `request`, if it calculates; and all other parameters by name.
    """
    groups = sections_of(page)
    own = [option for title, group in groups.items() if title != OUTPUTS for option in group]
    params: list[click.Parameter] = [*own, *groups[OUTPUTS]]
    if page.operand:
        params.insert(0, click.Argument(["words"], nargs=-1, metavar=page.operand.usage))

    def decorate(function: Callable[..., Any]) -> "SectionedCommand":
        return SectionedCommand(
            name,
            callback=_callback(function, name, own, page),
            params=params,
            help=f"{page.about}\n\n{text}" if text else None if page.about else function.__doc__,
            sections=groups,
            page=page,
        )

    return decorate


def _callback(
    function: Callable[..., Any], name: str, own: Sequence[click.Option], page: Page
) -> Callable[..., Any]:
    """Return the function that Click calls: it adds what all commands of their kind have."""
    symbols = {one.name: one.symbol.name for one in own if isinstance(one, SymbolOption)}
    output_names = [row.parameter for row in page.output if row.parameter in DEFAULTS]

    def call(**values: Any) -> Any:
        root = click.get_current_context().find_root()
        of_output = {key: values.pop(key) for key in output_names}
        output = decide(**of_output, command=name, listener=root.obj)
        typed = {symbols[key]: values.pop(key) for key in tuple(values) if key in symbols}
        if page.calculates:
            from radcalc.cli.request import Request

            values["request"] = Request.of(values, page.takes_lines)
        if symbols:
            values["typed"] = {k: text for k, text in typed.items() if text not in (None, False)}
        return function(output=output, **values)

    return call


@cache
def of_page(name: str) -> "SectionedCommand":
    """Make a command of a calculator's page, answered by its function."""

    def answer(**values: Any) -> int:
        from radcalc.cli.calculator import answerer

        function = answerer(name)
        assert function is not None
        return function(**values)

    return define(name, page_of(name))(answer)


class Whole(click.Option):
    """An option for a whole number, whose help states the limits in words."""

    def get_help_extra(self, ctx: click.Context) -> Any:
        return {}


def sections_of(page: Page) -> dict[str, Sequence[click.Option]]:
    """Return Click's options of a page, by the titles of their sections."""
    return {title: [option_of(row) for row in rows] for title, rows in page.options.items()}


def option_of(row: Option) -> click.Option:
    """Return Click's option of a row."""
    kind: dict[str, Any] = {"metavar": row.example or None}
    if row.form == FLAG:
        kind = {"is_flag": True}
    elif row.form == CHOICE:
        kind = {"type": click.Choice(row.choices, case_sensitive=not row.symbol)}
    elif row.form == WHOLE:
        kind["type"] = click.IntRange(row.least, row.most)
    if row.symbol:
        return SymbolOption(row, **kind)
    names = [*row.spellings, row.parameter]
    return (Whole if row.form == WHOLE else click.Option)(
        names,
        help=spelled(row.help),
        hidden=row.hidden,
        multiple=row.repeats,
        default=row.default,
        **kind,
    )


class SymbolOption(click.Option):
    """An option for a symbol of the vocabulary; its help is made on demand."""

    def __init__(self, row: Option, **kind: Any) -> None:
        self.row, self.symbol = row, row.symbol
        super().__init__([*row.spellings], hidden=row.hidden, **kind)

    @property
    def help(self) -> str:
        return spelled(self.row.help)

    @help.setter
    def help(self, text: str | None) -> None:
        """Ignore a help text: the options of Click set theirs at once."""


class SectionedCommand(Helped):
    """A command whose options are listed under the titles of `sections`."""

    def __init__(
        self, *args: Any, sections: dict[str, Sequence[click.Option]], page: Page, **kwargs: Any
    ) -> None:
        super().__init__(*args, **kwargs)
        self.sections, self.page = sections, page

    @property
    def help(self) -> str:
        return self._text or _help_of(self.name or "", self.page)

    @help.setter
    def help(self, text: str | None) -> None:
        self._text = text

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Refuse an option given twice, of which Click would ignore the first value.

        --header without a number is one line, and never takes the next word as its number.
        """
        end = args.index("--") if "--" in args else len(args)
        args = ["--header=1" if word == "--header" else word for word in args[:end]] + args[end:]
        if self.page.draws:
            args = with_plot(args[:end]) + args[end:]
        several = {
            name
            for option in self.params
            if getattr(option, "multiple", False) or getattr(option, "is_flag", False)
            for name in option.opts
        }
        seen: set[str] = set()
        for word in args[: args.index("--")] if "--" in args else args:
            name = word.partition("=")[0]
            if word.startswith("--") and name in seen - several:
                raise UsageError(f"{quote(name)} is given twice", _once(name[2:], args[:end]))
            seen.add(name)
        remaining = super().parse_args(ctx, args)
        for parameter in self.params:
            value = ctx.params.get(parameter.name or "")
            if value == "" or (
                isinstance(value, tuple) and "" in value and parameter.opts[0][0] == "-"
            ):
                raise UsageError(f"{parameter.opts[0]} is empty", "a value, or without the option")
        return remaining

    def format_options(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        for title, listed in self.sections.items():
            of_output = title == OUTPUTS
            visible = [*listed, *HELPS] if of_output else listed
            records = [option.get_help_record(ctx) for option in visible]
            if title == LINES:
                records = [_of_lines(listed)]
            if any(records):
                with formatter.section(title):
                    formatter.write_dl([record for record in records if record])


def _help_of(name: str, page: Page) -> str:
    examples = []
    for example in page.examples:
        words, remark = words_of(example)
        examples.append(f"  {Shell.command(name, *words)}{remark}")
    lines = "\n".join(["\b", "Examples:", *examples])
    return "\n\n".join([page.about, lines, *[spelled(mention(p)) for p in page.paragraphs]])


def _once(name: str, args: Sequence[str]) -> list[Try]:
    """Propose an option that is given twice with each of its values, and with both as a list."""
    values = []
    for word, following in zip(args, [*args[1:], ""], strict=True):
        option, equals, value = word.partition("=")
        if option == f"--{name}":
            values.append(value if equals else following)
    alone = list(dict.fromkeys(values))
    is_list = name in SYMBOLS and len(alone) > 1 and not any("," in value for value in alone)
    return [add(name, value) for value in ([*alone, ",".join(alone)] if is_list else alone)]


def with_plot(args: Sequence[str]) -> list[str]:
    """Return the words with --plot and its file joined, or with --plot alone."""
    words: list[str] = []
    for word in args:
        if words and words[-1] == "--plot":
            is_file = word.lower().endswith(FIGURES) and word[0] != "-"
            ending = os.path.splitext(word)[1]
            if not is_file and ending[1:].isalpha() and not os.path.exists(word):
                problem = f"'{quote(word)}' is not a file, and a figure does not end in"
                figure: Hint = [correct(word, word.removesuffix(ending) + FIGURES[0])]
                hint = "a figure in .svg or .png" if len(args) == 2 else figure
                raise UsageError(f"{problem} {quote(ending)}", hint)
            words[-1:] = [f"--plot={word}"] if is_file else [f"--plot={TO_TERMINAL}", word]
        else:
            words.append(word)
    return [f"--plot={TO_TERMINAL}" if word == "--plot" else word for word in words]


def _of_lines(listed: Sequence[click.Option]) -> tuple[str, str]:
    """Return the help entry of a calculator for the options for streams."""
    *names, last = (option.opts[-1] for option in listed)
    return (
        "- or '- UNIT'",
        "Write - or '- UNIT' as the value of one option: it is then read from standard input, and "
        "each line gives one answer (with -g).  With -, each line is a number with its unit; with "
        "'- UNIT', each line is a bare number.  "
        f"{', '.join(names)} and {last} work as in radcalc convert.",
    )


# The module `help` has what all commands share, and `lists` has several commands.
LISTS = ("units", "typical", "quantities", "examples", "manual")
OTHERWISE = {
    "help": "findings",
    "columns": "dose",
    "environment": "scene",
    **dict.fromkeys(LISTS, "lists"),
}
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
            from radcalc.cli.spelling import absent_file, similar_calls

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
@click.option(EXPLAIN, is_flag=True, expose_value=False, help=OF_EXPLAIN.help)
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
