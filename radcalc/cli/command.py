"""A command whose sections are its options: the help shows them so, with the examples first."""

from collections.abc import Callable, Mapping, Sequence
from copy import copy
from importlib import import_module
from typing import Any

import click

from radcalc.cli import Helped, check, options
from radcalc.cli.spelling import Shell, spelled
from radcalc.errors import UsageError, mention, quote
from radcalc.quantities.light import KINDS
from radcalc.quantities.symbols import (
    CHOICE,
    FLAG,
    SPECIFIC,
    SYMBOLS,
    WORD,
    Symbol,
    light_unit,
    names_of_kinds,
)

LIGHT = ("wavelength", "spectrum", "efficacy", "observer", "range", "photon-range")
GET = click.Option(
    ["-g", "--get", "wanted"],
    multiple=True,
    metavar="NAME[:UNIT]",
    help="The bare number of that result, or with --format the result alone (repeatable; in the "
    "unit shown, without one).",
)
PLOT = click.Option(
    ["--plot"],
    metavar="[FILE]",
    help="Draw a picture: below the answer, or as a figure in FILE (.svg, .png).",
)
HERE = "-"  # --plot without a file
# What the word behind --plot ends in where it is its file, and no operand.
FIGURES = (".svg", ".png", ".pdf", ".ps", ".eps", ".jpg", ".jpeg", ".gif", ".webp", ".tif", "/")
ALSO = " (also --"  # before the names of one kind, in the help of a light quantity
# The forms of operands that no symbol has.
CONVERSION, SEARCH, ENVIRONMENT, FILE = "conversion", "search", "environment", "file"
LINES = "Streams"
Member = str | click.Option  # the name of a symbol, or an option that is none


def define(
    name: str,
    sections: Mapping[str, Sequence[Member]],
    words: str = "",
    kinds: Sequence[str] = KINDS,
    calculates: bool = True,
    takes_lines: bool = True,
    output: Sequence[click.Option] = (),
    operands: tuple[str, Sequence[str]] = (WORD, ()),
    cls: "type[SectionedCommand] | None" = None,
    draws: bool = False,
) -> Callable[[Callable[..., Any]], "SectionedCommand"]:
    """Make a command of a function, whose docstring is the help.

    `sections` are the titles of the help, with the symbols and other options below them; `words`
    says what its operands are, and `operands` in which form, for completion; light quantities are
    taken in `kinds`.  A command that calculates has the options that ask for results, those
    for lines of standard input if it takes any, and that for a picture if it `draws`; `output` are
    more options of the output, and `cls` is the class of the command.

    The function is called with `typed`, the texts of the symbols that were given, where it has
    any; `shown`, how to show the answer; `asked`, where it calculates; and with everything else
    by its name.
    """
    sections = dict(sections)
    if calculates:
        own = sections.pop("Results", ())
        sections["Results"] = (*own, GET, *check.OPTIONS, *([PLOT] if draws else []))
        if takes_lines:
            from radcalc.cli import streams  # which no list of units or names needs

            sections[LINES] = [_hidden(option) for option in streams.OPTIONS]
    groups = {
        title: [option for member in members for option in _options(member, name, kinds)]
        for title, members in sections.items()
    }
    symbols = {
        option.name: option.opts[-1].removeprefix("--")
        for group in groups.values()
        for option in group
        if isinstance(option, SymbolOption)
    }
    shared = options.OPTIONS if calculates or output else options.OF_LISTS
    last = [*shared, *([options.STEPS] if calculates else output)]
    params: list[click.Parameter] = [option for group in groups.values() for option in group]
    if words:
        params.insert(0, click.Argument(["words"], nargs=-1, metavar=words))

    def decorate(function: Callable[..., Any]) -> "SectionedCommand":
        def call(**values: Any) -> Any:
            shown = options.decide(**{key: values.pop(key) for key in options.NAMES}, command=name)
            typed = {symbols[key]: values.pop(key) for key in tuple(values) if key in symbols}
            given = {key: text for key, text in typed.items() if text not in (None, False)}
            if calculates:
                from radcalc.cli.calculator import Asked

                values["asked"] = Asked.of(values, takes_lines)
            if symbols:
                values["typed"] = given
            return function(shown=shown, **values)

        return (cls or SectionedCommand)(
            name,
            callback=call,
            params=[*params, *last],
            help=function.__doc__,
            sections={**groups, "Output": last},
            operands=operands,
        )

    return decorate


def of_page(name: str) -> "SectionedCommand":
    """Make a command of a calculator's page."""
    module = import_module(f"radcalc.calculators.{name.replace('-', '_')}")
    page, work_out = module.PAGE, getattr(module, name.replace("-", "_"))

    def calculate(typed: dict[str, Any], asked: Any, shown: options.Output) -> int:
        from radcalc.cli.calculator import run
        from radcalc.cli.cases import cases

        return run(cases(typed, page.takes_arrays, bare=page.bare), work_out, asked, shown, name)

    examples = [f"  {Shell.command(name, *line.split())}" for line in page.examples]
    calculate.__doc__ = "\n\n".join(
        [
            page.about,
            "\b\nExamples:\n" + "\n".join(examples),
            spelled(mention(page.remarks)),
        ]
    )
    return define(name, page.sections, kinds=page.kinds)(calculate)


class SymbolOption(click.Option):
    """The option of a symbol of the vocabulary."""


def _options(member: Member, command_name: str, kinds: Sequence[str]) -> list[click.Option]:
    """The options of a symbol; a light quantity has hidden ones for the names of its kinds."""
    if isinstance(member, click.Option):
        return [member]
    symbol = SYMBOLS[member]
    example, text = symbol.shown_in(command_name)
    text = spelled(mention(text))
    if member != symbol.generic:
        return [_option(symbol, example, text)]
    others = [n for n in names_of_kinds(member) if SPECIFIC[n][1] in kinds]
    if others:
        text = f"{text.rstrip('.')}{ALSO}{', --'.join(others)})."
    if len(kinds) == 1:
        example = f"100{light_unit(member, kinds[0])}".replace(" ", ".")
    hidden = []
    for other in others:
        shown, said = SYMBOLS[other].shown_in(command_name)
        hidden.append(_option(SYMBOLS[other], shown, spelled(mention(said)), hidden=True))
    return [_option(symbol, example, text), *hidden]


def _option(symbol: Symbol, example: str, text: str, hidden: bool = False) -> SymbolOption:
    kind: dict[str, Any] = {"metavar": example}
    if symbol.form == FLAG:
        kind = {"is_flag": True}
    elif symbol.form == CHOICE:
        kind = {"type": click.Choice(symbol.choices, case_sensitive=False)}
    return SymbolOption([f"--{symbol.name}"], help=text, hidden=hidden, **kind)


class SectionedCommand(Helped):
    """Options are listed under the titles of `sections`."""

    def __init__(
        self,
        *args: Any,
        sections: dict[str, Sequence[click.Option]],
        operands: tuple[str, Sequence[str]],
        **kwargs: Any,
    ) -> None:
        super().__init__(*args, **kwargs)
        self.sections = sections
        self.operands = operands

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Refuse an option that is given twice: the first would be ignored silently.

        A --header without a number is one line, and never takes the next word for the number.
        """
        end = args.index("--") if "--" in args else len(args)
        args = ["--header=1" if word == "--header" else word for word in args[:end]] + args[end:]
        if PLOT in self.params:
            args = _with_plot(args[:end]) + args[end:]
        several = {o for p in self.params if getattr(p, "multiple", False) for o in p.opts}
        seen: set[str] = set()
        for word in args[: args.index("--")] if "--" in args else args:
            name = word.partition("=")[0]
            if word.startswith("--") and name in seen - several:
                raise UsageError(f"{quote(name)} is given twice", "it once, or a list of values")
            seen.add(name)
        rest = super().parse_args(ctx, args)
        for parameter in self.params:
            value = ctx.params.get(parameter.name or "")
            if value == "" or (
                isinstance(value, tuple) and "" in value and parameter.opts[0][0] == "-"
            ):
                raise UsageError(f"{parameter.opts[0]} is empty", "a value, or without the option")
        return rest

    def format_options(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Write one list of options a section."""
        for title, listed in self.sections.items():
            of_output = title == "Output"
            shown = [*listed, self.get_help_option(ctx)] if of_output else listed
            records = [option.get_help_record(ctx) for option in shown if option]
            if title == LINES:
                records = [_of_lines(listed)]
            if any(records):
                with formatter.section(title):
                    formatter.write_dl([record for record in records if record])


def _with_plot(args: Sequence[str]) -> list[str]:
    """The words of a call, in which --plot and its file are one word, or --plot has none."""
    found: list[str] = []
    for word in args:
        if found and found[-1] == "--plot":
            is_file = word.lower().endswith(FIGURES) and word[0] != "-"
            found[-1:] = [f"--plot={word}"] if is_file else [f"--plot={HERE}", word]
        else:
            found.append(word)
    return [f"--plot={HERE}" if word == "--plot" else word for word in found]


def _hidden(option: click.Option) -> click.Option:
    """The same option, of which the help of another command tells."""
    hidden = copy(option)
    hidden.hidden = True
    return hidden


def _of_lines(listed: Sequence[click.Option]) -> tuple[str, str]:
    """What the help of a calculator says of its options for streams, which are those of convert."""
    *names, last = (option.opts[-1] for option in listed)
    return (
        "- or '- UNIT'",
        "In place of one value: an answer (-g) to each line of standard input, which carries its "
        f"unit or is a bare number of UNIT; {', '.join(names)} and {last} as in radcalc convert.",
    )
