"""`radcalc manual [PAGE]`: the pages of the manual, also where `man` does not find them."""

import re
from collections.abc import Sequence
from pathlib import Path

import click

from radcalc import terminal
from radcalc.calculators import lists, options
from radcalc.calculators.lists import MAIN
from radcalc.calculators.pages import page_of
from radcalc.cli.command import SectionedCommand, option_of
from radcalc.cli.help import is_colored, show
from radcalc.cli.output import width_of_terminal
from radcalc.cli.spelling import Shell
from radcalc.errors import RadcalcError, UsageError, call, nearest, quote
from radcalc.render.mdoc import displayed, typeset

PREFIX = f"{MAIN}-"
SECTIONS = ("1", "7")
WIDEST = 100  # columns of a page


def find(words: Sequence[str]) -> list[Path]:
    """Return the pages of a name, which may have a section before it, and `radcalc-`.

    That of a command, in section 1, is the first.

    Examples
    --------
    >>> [page.name for page in find(["units"])]
    ['radcalc-units.1', 'radcalc-units.7']
    >>> [page.name for page in find(["7", "units"])]
    ['radcalc-units.7']
    """
    section = words[0] if words and words[0] in SECTIONS else ""
    typed = " ".join(words[1:] if section else words)
    name = "-".join(typed.split()).lower().removeprefix(PREFIX) or MAIN
    known = lists.manual_pages()
    if not known:
        problem = f"cannot read '{quote(str(lists.manual_folder()))}': it has no pages"
        raise RadcalcError(problem, "a new installation of radcalc")
    named = [page for page in known if _name(page) == name]
    found = [page for page in named if _section(page) in (section or SECTIONS)]
    if not found:
        place = f"section {section} of the manual" if section else "the manual"
        near = [name] if named else nearest(name, map(_name, known))
        hint = [call("manual", other) for other in near] or [call("manual")]
        raise UsageError(f"{place} has no page '{quote(typed or MAIN)}'", hint)
    return found


def _name(page: Path) -> str:
    return page.stem.removeprefix(PREFIX)


def _section(page: Path) -> str:
    return page.suffix[1:]


def manual(words: Sequence[str], color: str) -> None:
    """Show a page of the manual.

    \b
    Examples:
      radcalc manual                 the main page, which lists the others
      radcalc manual convert         the page of a command
      radcalc manual solid angle     a name of several words
      radcalc manual sentences       a page on a subject
      radcalc manual 7 units         a page that has the name of a command

    radcalc sets the pages itself, so it needs no other program for them.  On a terminal a page is
    shown as --help is, with the program that PAGER names.
    """
    page, *others = find(words)
    source = page.read_text(encoding="utf-8")
    show(typeset(source, min(width_of_terminal(), WIDEST), is_colored()))
    terminal.say(terminal.remarks((), [_mention(other) for other in others]))


def _mention(page: Path) -> str:
    """Return the call that shows a page, with what the page is about."""
    about = re.search(r"^\.Nd (.*)$", page.read_text(encoding="utf-8"), re.M)
    typed = Shell.command("manual", _section(page), _name(page))
    return f"{typed} has {displayed(about[1])}" if about else typed


PAGE = page_of("manual")
COLOR = option_of(options.COLOR)
command = SectionedCommand(
    "manual",
    callback=manual,
    params=[click.Argument(["words"], nargs=-1, metavar="[SECTION] [PAGE]"), COLOR],
    help=manual.__doc__,
    sections={"Output": (COLOR,)},
    page=PAGE,
)
