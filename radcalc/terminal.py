"""The process around radcalc: standard output and error, and the exit statuses."""

import os
import sys

from radcalc.errors import OutputError, Plain, RadcalcError, printable

TYPE_CHECKING = False  # typing.TYPE_CHECKING, without the cost of importing typing
if TYPE_CHECKING:
    from collections.abc import Iterable
    from typing import Any

HANGING = 4  # columns that what follows the first part of a folded line stands in
ANSWERED, WRONG, FAILED, BUG, INTERRUPTED = 0, 1, 2, 3, 130
AUTO, ALWAYS, NEVER = COLORING = "auto", "always", "never"
# What a line of standard input that cannot be converted does.
ABORT, FAIL, WARN, IGNORE = INVALID = "abort", "fail", "warn", "ignore"
BOLD, FAINT, RESET = "\033[1m", "\033[2m", "\033[0m"
RED, GREEN, MAGENTA, CYAN = "\033[1;31m", "\033[1;32m", "\033[35m", "\033[36m"
# The colour of a line's first word, which says what the line is.  That word alone is coloured: a
# colour that cannot be seen well on the background of a terminal takes nothing from what is said.
COLORS = {
    "radcalc:": RED,
    "try:": GREEN,
    "assumed:": CYAN,
    "note:": MAGENTA,
    "right": GREEN,
    "wrong": RED,
    "likely:": MAGENTA,
    "or:": MAGENTA,
}
_chosen = AUTO


def is_terminal() -> bool:
    """Check whether standard output is a terminal."""
    return os.isatty(1)


def error_is_terminal() -> bool:
    """Check whether standard error is a terminal."""
    return sys.stderr is not None and os.isatty(2)


def choose_color(choice: str) -> None:
    """Take what is chosen for colours in all that is said on standard error from now on."""
    global _chosen
    _chosen = choice


def chosen_color() -> str:
    """Return what is chosen for colours."""
    return _chosen


def wants_color(choice: str, terminal: bool) -> bool:
    """Return what was chosen, then NO_COLOR, then FORCE_COLOR, then whether this is a terminal."""
    if choice != AUTO:
        return choice == ALWAYS
    if os.environ.get("NO_COLOR"):
        return False
    if os.environ.get("FORCE_COLOR"):
        return True
    return terminal and os.environ.get("TERM", "") not in ("", "dumb") and sys.stdout is not None


def can_show(text: str) -> bool:
    """Check whether the encoding of standard output has all letters of a text."""
    try:
        text.encode(getattr(sys.stdout, "encoding", None) or "ascii")
    except (UnicodeEncodeError, LookupError):  # LookupError: of an encoding that Python has not
        return False
    return True


def write(text: str) -> None:
    """Write a whole answer.  A closed pipe ends quietly; any other failure is an error."""
    out = _stdout()
    encoding = out.encoding or "ascii"
    try:
        data = text.encode(encoding, out.errors or "strict")
    except UnicodeEncodeError:
        import codecs

        codecs.register_error("radcalc", _escaped)
        data = text.replace("±", "+-").encode(encoding, "radcalc")
    try:
        pour(data)
    except BrokenPipeError:  # nobody reads on, and the exit status is still of use
        return


def _escaped(error: "Any") -> "tuple[str, int]":
    """Return what an encoding lacks, escaped as JSON has it."""
    data = error.object[error.start : error.end].encode("utf-16-be", "surrogatepass")
    units = [data[k : k + 2].hex() for k in range(0, len(data), 2)]
    return "".join([f"\\u{unit}" for unit in units]), error.end


def pour(data: bytes) -> None:
    """Write a part of a stream at once.  A closed pipe raises, for there is no use in going on."""
    try:
        _send(_stdout(), data)
    except BrokenPipeError:
        raise
    except OSError as error:
        problem = f"cannot write the answer: {error.strerror or error}"
        raise OutputError(problem, "a place with room for it") from None


def read(size: int) -> bytes:
    """Read from standard input what there is, at most so many bytes; none at its end.

    Where there is nothing yet, a descriptor that does not block is waited for.
    """
    if sys.stdin is None:
        raise RadcalcError("cannot read stdin: it is closed", "a file or a pipe")
    raw = _unbuffered(sys.stdin)
    try:
        while (data := raw.read(size)) is None:
            _wait(raw, reading=True)
        return data  # type: ignore[no-any-return]
    except OSError as error:
        problem = f"cannot read stdin: {error.strerror or error}"
        raise RadcalcError(problem, "a file or a pipe") from None


def _stdout() -> "Any":
    if sys.stdout is None:
        raise OutputError("cannot write the answer: standard output is closed", "a file or a pipe")
    return sys.stdout


def _send(file: "Any", data: bytes) -> None:
    """Write everything, however little of it is taken at a time.

    Python's own buffer gives up where a descriptor does not block, and without one (`python -u`)
    what was not taken is lost; so this writes below it.
    """
    raw = _unbuffered(file)
    rest = memoryview(data)
    while rest:
        taken = raw.write(rest)
        if taken is None:
            _wait(raw, reading=False)
        else:
            rest = rest[taken:]


def _unbuffered(file: "Any") -> "Any":
    """Return the raw file of a text file; under `python -u`, that is what it has for a buffer."""
    return getattr(file.buffer, "raw", file.buffer)


def _wait(raw: "Any", reading: bool) -> None:
    """Wait until a descriptor that does not block has something, or room for something."""
    from select import select

    place = [raw.fileno()]
    select(place if reading else [], [] if reading else place, [])


def say(lines: "Iterable[str]") -> None:
    """Write lines to standard error, on a terminal folded and coloured.

    Nobody listening there is no failure.
    """
    try:
        printable_lines = map(printable, lines)
        if error_is_terminal():
            width, is_colored = _width_of_terminal(), wants_color(_chosen, True)
            text = "".join([message(line, width, is_colored) for line in printable_lines])
        else:
            text = "".join([f"{line}\n" for line in printable_lines])
        _send(sys.stderr, text.encode(sys.stderr.encoding or "ascii", "backslashreplace"))
    except (OSError, ValueError, AttributeError):
        pass


def _width_of_terminal() -> int:
    """How wide the terminal of standard error is; wider than any line where it does not say."""
    try:
        return os.get_terminal_size(2).columns or sys.maxsize
    except (OSError, ValueError):
        return sys.maxsize


def fold(line: str, width: int, deeper: int = 0) -> list[str]:
    """A line in a width, folded between words; what follows the first part stands `deeper`."""
    if len(line) <= width:
        return [line]
    from textwrap import wrap

    indent = " " * (len(line) - len(line.lstrip()) + deeper)
    return wrap(
        line, width, subsequent_indent=indent, break_long_words=False, break_on_hyphens=False
    ) or [""]


def message(line: str, width: int, is_colored: bool) -> str:
    """A line folded in a width, its end included, its first word in the colour of what it is."""
    first, *more = fold(line, width, HANGING)
    word = first.partition(" ")[0]
    if is_colored and word in COLORS:
        first = f"{COLORS[word]}{word}{RESET}{first[len(word) :]}"
    return "\n".join([first, *more, ""])


def remarks(assumptions: "Iterable[str]", notes: "Iterable[str]") -> list[str]:
    """Return what was assumed and noted, a line each."""
    return [f"assumed: {text}" for text in assumptions] + [f"note: {text}" for text in notes]


def complain(error: RadcalcError, spelling: "Any" = Plain) -> int:
    """Say what is wrong and what to do, as a gate spells it; return the exit status."""
    message, hint = error.spelled(spelling)
    say([f"radcalc: {message}", *([f"try: {hint}"] if hint else [])])
    return FAILED
