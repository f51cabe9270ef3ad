"""`radcalc prompt`, and `radcalc` alone on a terminal: one line after another.

Only this module loads prompt_toolkit, and only on a terminal.
"""

import os
import shlex
from collections.abc import Iterable, Iterator
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

from radcalc import terminal
from radcalc._version import __version__
from radcalc.calculators import page_of
from radcalc.calculators.page import DEFAULTS
from radcalc.cli.command import SectionedCommand, sections_of
from radcalc.cli.output import decide
from radcalc.cli.session import ASSIGNMENT, Session
from radcalc.errors import RadcalcError

if TYPE_CHECKING:
    from prompt_toolkit import PromptSession
    from prompt_toolkit.history import History

    from radcalc.completion.words import Completion

PROMPT = "> "
BOM = "\ufeff"
BLOCK = 1 << 16
LONGEST = 1 << 20  # bytes of a line
WORST = (terminal.BUG, terminal.FAILED, terminal.WRONG)  # of the statuses of lines


def prompt(**values: Any) -> int:
    """Type one command or sentence on each line, without the word radcalc in front.

    \b
    Examples:
      radcalc                                   (on a terminal)
      printf '100 lx fc\\nans klx\\n' | radcalc prompt

    \b
    At the prompt:
      100 lx fc
      2 * 800 lm in lx --isotropic --distance 2m
      ans klx
      800 lm 24 deg lobe to cd
      ans at 3 m to lx
      x = point-source --flux 800lm --distance 2m -g irradiance
      x fc
      help point-source
      exit

    Special characters of the shell need no quotes.  A variable keeps an amount or an answer;
    vars lists the variables.  ans is the last answer; if it has several results, ans.NAME is one
    of them.  Tab completes, Ctrl-C clears the line or stops an answer, Ctrl-D exits.

    If standard input is not a terminal, each of its lines is answered, and the exit status is
    the highest status of any line.  The options apply to every line.
    """
    decide(**values)  # refuses contradictory options
    settings = {name: value for name, value in values.items() if value != DEFAULTS[name]}
    if os.isatty(0) and (os.isatty(1) or os.isatty(2)):
        return _converse(Session(settings))
    return answer_lines(Session(settings, has_stdin=False))


SECTIONS = sections_of(page_of("prompt"))
command = SectionedCommand(
    "prompt",
    callback=prompt,
    params=[option for group in SECTIONS.values() for option in group],
    help=prompt.__doc__,
    sections=SECTIONS,
    page=page_of("prompt"),
)


def answer_lines(session: Session) -> int:
    """Answer the lines of standard input; return the worst of their statuses."""
    statuses = {terminal.ANSWERED}
    for number, line in enumerate(_lines(), start=1):
        try:
            status = session.answer(line.removeprefix(BOM), f"line {number}")
        except EOFError:
            break
        if status == terminal.INTERRUPTED:
            return status
        statuses.add(status)
        if terminal.is_unread:
            break
    return next((candidate for candidate in WORST if candidate in statuses), terminal.ANSWERED)


def _lines() -> Iterator[str]:
    """Yield the lines of standard input, decoded like the words of a command line."""
    remainder = b""
    while data := terminal.read(BLOCK):
        *complete, remainder = (remainder + data).split(b"\n")
        yield from map(os.fsdecode, complete)
        if len(remainder) > LONGEST:
            break  # refused for its length
    if remainder:
        yield os.fsdecode(remainder)


def _converse(session: Session) -> int:
    """Ask for lines on the terminal and answer them, until the user leaves."""
    asking = _asking(session)
    terminal.say([f"radcalc {__version__}: type help for help, exit to quit"])
    while True:
        try:
            text = asking.prompt(PROMPT)
        except KeyboardInterrupt:
            continue
        except EOFError:
            return terminal.ANSWERED
        for line in text.replace("\\\n", " ").splitlines():  # of a pasted text
            try:
                if session.answer(line) == terminal.INTERRUPTED:
                    terminal.say([""])  # after the ^C of the terminal
                    break
            except EOFError:
                return terminal.ANSWERED


def _asking(session: Session) -> "PromptSession[str]":
    """Return the line editor, with completion of words and the history."""
    from prompt_toolkit import PromptSession
    from prompt_toolkit.completion import CompleteEvent, Completer, Completion
    from prompt_toolkit.document import Document
    from prompt_toolkit.output.defaults import create_output

    class Words(Completer):
        def get_completions(self, document: Document, event: CompleteEvent) -> Iterable[Completion]:
            line = document.text_before_cursor
            matches, typed = completions(session, line)
            for word in matches:
                text = quoted(word.text)
                text += " " if word.closes else ""
                yield Completion(
                    text, -len(typed), display=word.text, display_meta=word.description
                )

    return PromptSession(
        history=history(),
        completer=Words(),
        complete_while_typing=False,
        output=create_output(always_prefer_tty=True),
    )


def completions(session: Session, line: str) -> tuple["list[Completion]", str]:
    """Return the words that may follow in a line, and the typed part of them."""
    from radcalc.completion import completions as words_after
    from radcalc.completion.words import Completion

    assigned = ASSIGNMENT.fullmatch(line)
    expression = assigned[2] if assigned else line
    words = expression.split()
    incomplete = "" if expression[-1:].isspace() or not words else words.pop()
    if words[:1] == ["radcalc"]:
        words = words[1:]
    is_first = not words and not assigned
    with suppress(RadcalcError):  # reported when the line is answered
        words = session.read(" ".join(words))  # the description of ans
    matches = words_after(words, incomplete)
    if is_first or incomplete[:1].isalpha():
        known = {word.text for word in matches}
        session_names = session.names(is_first).items()
        matches += [
            Completion(*entry)
            for entry in session_names
            if entry[0].startswith(incomplete) and entry[0] not in known
        ]
    return matches, incomplete


def quoted(text: str) -> str:
    """Return a word as typed: in quotes if it has blanks."""
    return shlex.quote(text) if " " in text else text


def history_path() -> Path | None:
    """Return the file of the history: RADCALC_HISTORY ('' for none), or the platform's."""
    setting = os.environ.get("RADCALC_HISTORY")
    state = os.environ.get("LOCALAPPDATA" if os.name == "nt" else "XDG_STATE_HOME", "")
    try:
        if setting is not None:
            return Path(setting).expanduser() if setting else None
        if not os.path.isabs(state):
            state = str(Path.home() / ".local" / "state")
    except RuntimeError:  # no home folder
        return None
    return Path(state) / "radcalc" / "history"


def history() -> "History":
    """Return the lines of earlier prompts, from a file of the owner's only, if one can be kept."""
    from prompt_toolkit.history import FileHistory, InMemoryHistory

    class Kept(FileHistory):
        def store_string(self, string: str) -> None:
            with suppress(OSError):  # of a full disk, say
                super().store_string(string)

    path = history_path()
    with suppress(OSError):
        if path and not path.exists():
            path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
            path.touch(mode=0o600)
        if path and path.is_file() and os.access(path, os.R_OK):  # a device may have no end
            return Kept(path)
    return InMemoryHistory()
