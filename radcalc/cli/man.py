"""`radcalc manual [PAGE]`: find a page of the manual, and let `man` show it."""

import re
import subprocess
from collections.abc import Sequence
from pathlib import Path

import click

from radcalc import terminal
from radcalc.calculators import lists, page
from radcalc.calculators.lists import MAIN
from radcalc.calculators.pages import page_of
from radcalc.cli.command import SectionedCommand, option_of
from radcalc.cli.group import commands, context
from radcalc.cli.help import is_colored, show
from radcalc.cli.spelling import Shell
from radcalc.errors import RadcalcError, UsageError, call, nearest, quote

PREFIX = f"{MAIN}-"
OF_COMMANDS = "1"
SECTIONS = (OF_COMMANDS, "7")
# Programs that show a page; the first that is installed does.  Every `man` takes an argument with a
# slash as the path of a page.  With -a, mandoc shows a page screen by screen, as `man` does.
PROGRAMS = (["man"], ["mandoc", "-a"])
OVERSTRUCK = re.compile(".\b")  # a letter below the next one, which is then bold or underlined


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
    """Show a page of the manual with man.

    \b
    Examples:
      radcalc manual                 the main page, which lists the others
      radcalc manual convert         the page of a command
      radcalc manual solid angle     a name of several words
      radcalc manual sentences       a page on a subject
      radcalc manual 7 units         a page that has the name of a command

    On a terminal, man shows the page screen by screen; in a pipe, the page is plain text.  Without
    man and mandoc, the path of the page is printed, and the --help of its command.
    """
    page, *others = find(words)
    if not _has_shown(page):
        show("\n\n".join([str(page), *_helps(page)]))
        problem = "neither man nor mandoc is available: this is the path of the page"
        terminal.say(terminal.remarks((), [problem]))
    terminal.say(terminal.remarks((), [_mention(other) for other in others]))


def _has_shown(page: Path) -> bool:
    """Show a page with one of `PROGRAMS`; return whether one could show it."""
    output = None if terminal.is_terminal() else subprocess.PIPE
    for program in PROGRAMS:
        words = [*program, str(page)]
        try:
            done = subprocess.run(words, stdout=output, text=True, errors="replace", check=False)
        except OSError:  # it is not installed
            continue
        if done.returncode == 0:
            terminal.write(OVERSTRUCK.sub("", done.stdout or ""))
            return True
    return False


def _helps(page: Path) -> list[str]:
    """Return the help of the command that a page describes; none for a page on a subject."""
    if _section(page) != OF_COMMANDS:
        return []
    top = context()
    name = _name(page)
    command = commands.get_command(top, name)
    of_page = click.Context(command, top, name, color=is_colored()) if command else top
    return [of_page.get_help()]


def _mention(page: Path) -> str:
    """Return the call that shows a page, with what the page is about."""
    about = re.search(r"^\.Nd (.*)$", page.read_text(encoding="utf-8"), re.M)
    typed = Shell.command("manual", _section(page), _name(page))
    return f"{typed} has {about[1]}" if about else typed


PAGE = page_of("manual")
COLOR = option_of(page.COLOR)
command = SectionedCommand(
    "manual",
    callback=manual,
    params=[click.Argument(["words"], nargs=-1, metavar="[SECTION] [PAGE]"), COLOR],
    help=manual.__doc__,
    sections={"Output": (COLOR,)},
    page=PAGE,
)
