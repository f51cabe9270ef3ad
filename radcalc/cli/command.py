"""Commands whose help lists the options in sections, after the examples."""

from collections.abc import Callable, Mapping, Sequence
from functools import cache
from typing import Any

import click

from radcalc.calculators.page import Page, words_of
from radcalc.calculators.pages import page_of
from radcalc.cli import options
from radcalc.cli.help import HELPS, Helped
from radcalc.cli.names import own_module
from radcalc.cli.output import decide
from radcalc.cli.request import TO_TERMINAL
from radcalc.cli.spelling import Shell, spelled
from radcalc.errors import Try, UsageError, add, mention, quote
from radcalc.quantities.symbols import (
    CHOICE,
    FLAG,
    SYMBOLS,
    Symbol,
    light_unit,
)

GET = click.Option(
    ["-g", "--get", "wanted"],
    multiple=True,
    metavar="NAME[:UNIT]",
    help="Print only this result, as a bare number or in the format of --format.  "
    "Without UNIT, the unit is that of the full answer.  Several: flux,illuminance:klx.",
)
PLOT = click.Option(
    ["--plot"],
    metavar="[FILE]",
    help="Draw a picture below the answer, or in FILE (.svg, .png).",
)
# Endings of a word after --plot that is its file, not an operand.
FIGURES = (".svg", ".png", ".pdf", ".ps", ".eps", ".jpg", ".jpeg", ".gif", ".webp", ".tif", "/")
ALSO = "also --"  # before the names of the kinds
LINES = "Streams"
Member = str | click.Option  # the name of a symbol, or another option


def define(
    name: str,
    page: Page,
    sections: Mapping[str, Sequence[Member]] | None = None,
    calculates: bool = True,
    output: Sequence[click.Option] = (),
    text: str | None = None,
) -> Callable[[Callable[..., Any]], "SectionedCommand"]:
    """Make a command of its page and of a function.

    `sections` replace those of the page if some options are not symbols; `text` replaces its
    examples and remarks in the help.  Without a page the help is the function's docstring.  A
    command that `calculates` has options for results, and for lines and a picture if its page
    allows them; `output` are more options of the output.

    The function is called with `typed`, the texts of the given symbols; `shown`, the output;
    `request`, if it calculates; and all other parameters by name.
    """
    sections = dict(page.sections if sections is None else sections)
    if calculates:
        of_results = (GET, *options.OF_CHECKS, *([PLOT] if page.draws else []))
        sections["Results"] = (*sections.pop("Results", ()), *of_results)
        if page.takes_lines:
            sections[LINES] = [_hidden(option) for option in options.OF_LINES]
    groups = {
        title: [option for member in members for option in _options(member, page)]
        for title, members in sections.items()
    }
    own = [option for group in groups.values() for option in group]
    shared = options.OPTIONS if calculates or output else options.OF_LISTS
    last = [*shared, *([options.STEPS] if calculates else output)]
    params: list[click.Parameter] = [*own, *last]
    if page.operand:
        params.insert(0, click.Argument(["words"], nargs=-1, metavar=page.operand.usage))

    def decorate(function: Callable[..., Any]) -> "SectionedCommand":
        return SectionedCommand(
            name,
            callback=_callback(function, name, own, page if calculates else None),
            params=params,
            help=f"{page.about}\n\n{text}" if text else None if page.about else function.__doc__,
            sections={**groups, "Output": last},
            page=page,
        )

    return decorate


def _callback(
    function: Callable[..., Any], name: str, own: Sequence[click.Option], calculator: Page | None
) -> Callable[..., Any]:
    """Return the function that Click calls: it adds what all commands of their kind have."""
    symbols = {one.name: one.symbol.name for one in own if isinstance(one, SymbolOption)}

    def call(**values: Any) -> Any:
        root = click.get_current_context().find_root()
        of_output = {key: values.pop(key) for key in options.NAMES}
        output = decide(**of_output, command=name, listener=root.obj)
        typed = {symbols[key]: values.pop(key) for key in tuple(values) if key in symbols}
        if calculator:
            from radcalc.cli.request import Request

            values["request"] = Request.of(values, calculator.takes_lines)
        if symbols:
            values["typed"] = {k: text for k, text in typed.items() if text not in (None, False)}
        return function(output=output, **values)

    return call


@cache
def of_page(name: str) -> "SectionedCommand":
    """Make a command of a calculator's page, and of the `FURTHER` options of its module."""

    def answer(**values: Any) -> int:
        from radcalc.cli.calculator import answerer  # help does without it

        function = answerer(name)
        assert function is not None
        return function(**values)

    page = page_of(name)
    sections: dict[str, Sequence[Member]] = dict(page.sections)
    for title, further in getattr(own_module(name), "FURTHER", {}).items():
        texts = [(f"--{key}", metavar, text) for key, (metavar, text) in further.items()]
        added = [click.Option([key], metavar=shown, help=text) for key, shown, text in texts]
        sections[title] = (*added, *sections[title])
    return define(name, page, sections)(answer)


class SymbolOption(click.Option):
    """An option for a symbol of the vocabulary; its help is made on demand."""

    def __init__(self, symbol: Symbol, hidden: bool, **kind: Any) -> None:
        self.symbol = symbol
        super().__init__([f"--{symbol.name}"], hidden=hidden, **kind)

    @property
    def help(self) -> str:
        return spelled(mention(self.symbol.help))

    @help.setter
    def help(self, text: str | None) -> None:
        """Ignore a help text: the options of Click set theirs at once."""


def _options(member: Member, page: Page) -> list[click.Option]:
    """Return the options of a symbol; a light quantity has hidden ones for its kinds."""
    if isinstance(member, click.Option):
        return [member]
    symbol = page.symbol(member)
    if member != symbol.generic:
        return [_option(symbol)]
    other_names = page.kinds_of(member)
    if other_names:
        text = symbol.help.rstrip(".")
        start = f"{text[:-1]}; " if text.endswith(")") else f"{text} ("
        symbol = symbol._replace(help=f"{start}{ALSO}{', --'.join(other_names)}).")
    if len(page.kinds) == 1:
        example = f"100{light_unit(member, page.kinds[0])}".replace(" ", ".")
        symbol = symbol._replace(example=example)
    hidden = [_option(page.symbol(other), hidden=True) for other in other_names]
    return [_option(symbol), *hidden]


def _option(symbol: Symbol, hidden: bool = False) -> SymbolOption:
    kind: dict[str, Any] = {"metavar": symbol.example}
    if symbol.form == FLAG:
        kind = {"is_flag": True}
    elif symbol.form == CHOICE:
        kind = {"type": click.Choice(symbol.choices, case_sensitive=False)}
    return SymbolOption(symbol, hidden, **kind)


class SectionedCommand(Helped):
    """A command whose options are listed under the titles of `sections`."""

    def __init__(
        self, *args: Any, sections: dict[str, Sequence[click.Option]], page: Page, **kwargs: Any
    ) -> None:
        super().__init__(*args, **kwargs)
        self.sections = sections
        self.page = page

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
        if PLOT in self.params:
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
            of_output = title == "Output"
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
            words[-1:] = [f"--plot={word}"] if is_file else [f"--plot={TO_TERMINAL}", word]
        else:
            words.append(word)
    return [f"--plot={TO_TERMINAL}" if word == "--plot" else word for word in words]


def _hidden(option: click.Option) -> click.Option:
    """Return a hidden copy of an option that another command documents."""
    hidden = click.Option.__new__(click.Option)  # as `copy` does, which takes longer to load
    vars(hidden).update(vars(option), hidden=True)
    return hidden


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
