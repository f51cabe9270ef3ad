"""Help: the options -h, which is one screen, and --help, which is complete; their lines."""

import os
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cache
from inspect import cleandoc
from types import MappingProxyType

import click

from radcalc import terminal
from radcalc.calculators import page
from radcalc.cli.spelling import COMPLETE_HELP, SHORT_HELP
from radcalc.terminal import BOLD, RESET, fold

TYPE_CHECKING = False  # typing is slow to import
if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence
    from typing import Any


BETWEEN_COLUMNS = re.compile(r"(?<=\S) {2,}(?=\S)")
AT_OPTIONS = re.compile(r" (?=-[a-z-]|\| |< )")  # where an example may be folded
DEEPER = 4  # columns


class HelpFormatter(click.HelpFormatter):
    """Click's formatter with other folding, and with coloured headings."""

    is_colored = False

    def write_usage(self, prog: str, args: str = "", prefix: str | None = None) -> None:
        heading = prefix or "Usage:"
        column = len(f"{heading} {prog} ")
        first, *more = fold(args, self.width - column)
        self.write(f"{self._heading(heading)} {prog} {first}".rstrip() + "\n")
        for line in more:
            self.write(f"{'':{column}}{line}\n")

    def write_heading(self, heading: str) -> None:
        self.write(f"{'':{self.current_indent}}{self._heading(f'{heading}:')}\n")

    def _heading(self, text: str) -> str:
        return f"{BOLD}{text}{RESET}" if self.is_colored else text

    def write_text(self, text: str) -> None:
        r"""Write paragraphs; one that begins with a line of `\b` keeps its own lines."""
        indent = " " * self.current_indent
        room = self.width - self.current_indent
        blocks = []
        for paragraph in text.split("\n\n"):
            first, *lines = paragraph.strip("\n").split("\n")
            if first.strip() != "\b":
                folded = fold(" ".join([first, *lines]), room)
            else:
                folded = [
                    line for joined_line in joined(lines) for line in narrowed(joined_line, room)
                ]
                if folded[:1] == [folded[0].rstrip(":") + ":"]:
                    folded[0] = self._heading(folded[0])
            blocks.append("\n".join(indent + line for line in folded))
        self.write("\n\n".join(blocks) + "\n")

    def write_dl(
        self, rows: Iterable[tuple[str, str]], col_max: int = 30, col_spacing: int = 2
    ) -> None:
        """Write terms and their folded meanings in two columns; a long term has its own line."""
        rows = list(rows)
        indent = " " * self.current_indent
        room = self.width - self.current_indent
        longest = max(len(term) for term, _ in rows)
        word = max(len(word) for _, meaning in rows for word in [*meaning.split(), ""])
        column = min(longest, col_max, self.width // 2, room - col_spacing - word) + col_spacing
        for term, meaning in rows:
            *above, last = _cut_choices(term, room)
            lines = fold(" ".join(meaning.split()), room - column)
            if len(last) > column - col_spacing:
                above, last = [*above, last], ""
            for line in above:
                self.write(f"{indent}{line}\n")
            self.write(f"{indent}{last:{column}}{lines[0]}".rstrip() + "\n")
            for line in lines[1:]:
                self.write(f"{indent}{'':{column}}{line}\n")


def joined(lines: Iterable[str]) -> Iterator[str]:
    """Join the lines of each example or table row of a block."""
    joined_line = ""
    for line in lines:
        start = len(line) - len(line.lstrip())
        parts = BETWEEN_COLUMNS.split(joined_line.lstrip())
        if len(parts) == 2 and start == len(joined_line) - len(parts[1]) and start > DEEPER:
            joined_line += f"\n{line.strip()}"
        else:
            yield from [joined_line] if joined_line else []
            joined_line = line
    yield joined_line


def narrowed(line: str, width: int) -> list[str]:
    """Fold a long line of a block: an example over several lines, or the last column of a row."""
    text = line.lstrip()
    indent = " " * (len(line) - len(text))
    term, *columns = BETWEEN_COLUMNS.split(text.partition("\n")[0])
    column = len(line.partition("\n")[0]) - len(columns[-1]) if columns else 0
    kept = line.replace("\n", "\n" + " " * column).split("\n")
    if max(map(len, kept)) <= width:
        return kept
    if "radcalc " in term:
        return _example(indent, term, columns[0] if columns else "", width)
    if len(columns) != 1:
        return [indent + part for part in fold(text, width - len(indent), DEEPER)]
    words = line[column:].replace("\n", " ")
    if width - column >= width // 2:
        first, *more = fold(words, width - column)
        return [line[:column] + first, *(" " * column + part for part in more)]
    deeper = indent + " " * DEEPER
    return [indent + term, *(deeper + part for part in fold(words, width - len(deeper)))]


def _example(indent: str, command: str, remark: str, width: int) -> list[str]:
    room = width - len(indent + command)
    if len(remark) <= room - len("  "):
        return [f"{indent}{command}{remark:>{room}}"]
    lines = [indent]
    for part in AT_OPTIONS.split(command):
        room = width - len(" \\")
        if lines[-1].strip() and len(lines[-1]) + 1 + len(part) > room:
            lines[-1] += " \\"
            lines.append(indent + " " * DEEPER)
        lines[-1] += f" {part}" if lines[-1].strip() else part
    return [*lines, *([f"{remark:>{width}}"] if remark else [])]


def _cut_choices(term: str, width: int) -> list[str]:
    lines = [""]
    for part in re.split(r"(?<=\|)", term):
        if lines[-1] and len(lines[-1]) + len(part) > width:
            lines.append(" " * DEEPER)
        lines[-1] += part
    return lines


SCREEN = 23  # lines; the shell's prompt is the last one of 24
EXAMPLES = 5  # lines
TERM = 27  # columns of an option with its value
ALWAYS = ("--get", "--check", "--json")
INDENT = "  "
BRACKETS = re.compile(r" \([^()]*\)")
Sections = Mapping[str, Sequence[click.Option]]


def write_examples(command: click.Command, sections: Sections, formatter: HelpFormatter) -> None:
    """Write the first example, those with the options that are used most, then the next ones.

    Those of one line come first.
    """
    room = formatter.width - len(INDENT)
    folded = {line: narrowed(line, room) for line in _examples(command)}
    lines = sorted(folded, key=lambda line: len(folded[line]) > 1)
    order = lines[:1]
    for spellings in _used(command, sections).values():
        if not any(spellings & _options(line) for line in order):
            order += [line for line in lines if spellings & _options(line)][:1]
    chosen: list[str] = []
    for line in dict.fromkeys([*order, *lines]):
        if sum(len(folded[other]) for other in [*chosen, line]) <= EXAMPLES:
            chosen.append(line)
    with formatter.section("Examples"):
        for line in folded:
            if line in chosen:
                formatter.write("".join(f"{part}\n" for part in folded[line]))


def write_options(
    command: click.Command, sections: Sections, formatter: HelpFormatter, ctx: click.Context
) -> None:
    """Write the options of the examples, the first of each section and the next ones, a line each.

    They are as many as the screen has room for, in the order of the complete help.
    """
    families = _families(sections)
    firsts = [next((o for o in group if not o.hidden), None) for group in sections.values()]
    order = [
        *(option for option in families if option.opts[-1] in ALWAYS),
        *_used(command, sections),
        *filter(None, firsts),
        *families,
    ]
    room = SCREEN - formatter.getvalue().count("\n") - len(["", "Options:", "more:"])
    chosen = [*dict.fromkeys(order)][:room]
    records = [option.get_help_record(ctx) or ("", "") for option in families if option in chosen]
    terms = [_term(term) for term, _ in records]
    column = max(map(len, terms)) + 2 * len(INDENT)
    meanings = [_cut(meaning, formatter.width - column) for _, meaning in records]
    with formatter.section("Options"):
        formatter.write_dl(list(zip(terms, meanings, strict=True)))


@cache
def _examples(command: click.Command) -> Sequence[str]:
    """Return the examples of the complete help, each on one line."""
    _, _, examples = cleandoc(command.help or "").partition("\b\nExamples:\n")
    return [*joined(examples.partition("\n\n")[0].split("\n"))] if examples else []


@cache
def _options(line: str) -> frozenset[str]:
    """Return the options of an example."""
    call = line.strip().partition("  ")[0]
    return frozenset(word.partition("=")[0] for word in call.split() if word[:1] == "-")


def _families(sections: Sections) -> dict[click.Option, set[str]]:
    """Return the visible options with their spellings; hidden ones are of the one before."""
    families: dict[click.Option, set[str]] = {}
    for group in sections.values():
        spellings: set[str] = set()
        for option in group:
            if not option.hidden:
                spellings = families[option] = set()
            spellings.update(option.opts)
    return families


def _used(command: click.Command, sections: Sections) -> dict[click.Option, set[str]]:
    """Return the options of the examples, the most frequent first."""
    lines = [_options(line) for line in _examples(command)]
    families = _families(sections)
    uses = {o: sum(bool(names & line) for line in lines) for o, names in families.items()}
    return {o: families[o] for o in sorted(uses, key=lambda o: -uses[o]) if uses[o]}


def _term(term: str) -> str:
    """Return an option with its value, with its first choices, or alone."""
    if len(term) <= TERM:
        return term
    choices, _, _ = term[: TERM - len("...]")].rpartition("|")
    return f"{choices}|...]" if choices else f"{term.partition(' ')[0]} ..."


def _cut(text: str, room: int) -> str:
    """Return the first sentence, without its remarks in brackets or cut if it is too long."""
    sentence = f"{' '.join(text.split()).partition('. ')[0].removesuffix('.')}."
    if len(sentence) > room:
        sentence = BRACKETS.sub("", sentence)
    if len(sentence) <= room:
        return sentence
    return f"{fold(sentence, room - len(' ...'))[0].rstrip(',;:(')} ..."


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
    click.Option([SHORT_HELP, "wants_short_help"], callback=_short, help=SHORT.help, **_FLAG),
    click.Option([COMPLETE_HELP, "wants_help"], callback=_complete, help=COMPLETE.help, **_FLAG),
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

        write_options(self, self.sections, formatter, ctx)

    def format_epilog(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        first, *called = ctx.command_path.split()
        formatter.write(f"\nManual: {' '.join([first, 'manual', *called])}\n")


def _formatter(ctx: click.Context) -> "HelpFormatter":

    width = ctx.terminal_width
    if not width and not terminal.is_terminal() and "COLUMNS" not in os.environ:
        width = PIPED
    formatter = HelpFormatter(width=width, max_width=ctx.max_content_width)
    formatter.is_colored = bool(ctx.color)
    return formatter
