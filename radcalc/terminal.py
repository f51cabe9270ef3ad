"""The process: standard output and error, and exit statuses."""

import os
import sys

TYPE_CHECKING = False  # typing.TYPE_CHECKING, without the cost of importing typing
if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence
    from typing import Any

    from radcalc.errors import RadcalcError

IS_WINDOWS = os.name == "nt"
HANGING = 4  # indent of the later parts of a folded line
ANSWERED, WRONG, FAILED, BUG, INTERRUPTED = 0, 1, 2, 3, 130
AUTO, ALWAYS, NEVER = COLORING = "auto", "always", "never"
# The effects of a line of standard input that cannot be converted.
ABORT, FAIL, WARN, IGNORE = INVALID = "abort", "fail", "warn", "ignore"
TABLE, PLAIN, JSON, CSV = FORMATS = "table", "plain", "json", "csv"  # of answers
BOLD, FAINT, RESET = "\033[1m", "\033[2m", "\033[0m"
RED, GREEN, MAGENTA, CYAN = "\033[1;31m", "\033[1;32m", "\033[35m", "\033[36m"
# The colour of a line's first word, which is the kind of the line.  Only that word is coloured, so
# that the text stays readable on any background.
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
WIDE = "W", "F"  # classes of Unicode for letters of two columns
MARKS = "Mn", "Me", "Mc"  # and for marks without a column
MEDIALS = "\u1160", "\u11ff"  # first and last letters of Hangul that join the letter before
DOTS = "..."
CALLS = "try: radcalc ", "or:  radcalc ", "read as: radcalc "  # lines to paste: not folded
DEFINITIONS = "RADCALC_DEFINITIONS"  # the variable with the path of a user's definitions
_chosen = AUTO


def definitions_file(chosen: "str | None") -> str:
    """Return the path of the user's definitions: as chosen, of the variable or the usual one.

    Return '' if there is none.
    """
    chosen = os.environ.get(DEFINITIONS) if chosen is None else chosen
    if chosen is not None:
        return chosen
    folder = os.environ.get("XDG_CONFIG_HOME") or os.path.expanduser("~/.config")
    path = os.path.join(folder, "radcalc", "definitions.txt")
    return path if os.path.exists(path) else ""


def is_terminal() -> bool:
    """Return whether standard output is a terminal."""
    return os.isatty(1)


def error_is_terminal() -> bool:
    """Return whether standard error is a terminal."""
    return sys.stderr is not None and os.isatty(2)


def choose_color(choice: str) -> None:
    """Set the colour choice for standard error."""
    global _chosen
    _chosen = choice


def chosen_color() -> str:
    """Return the colour choice."""
    return _chosen


def wants_color(choice: str, terminal: bool) -> bool:
    """Return whether to colour: by the choice, NO_COLOR, FORCE_COLOR, then the terminal."""
    if choice != AUTO:
        return choice == ALWAYS
    if os.environ.get("NO_COLOR"):
        return False
    if os.environ.get("FORCE_COLOR"):
        return True
    return terminal and os.environ.get("TERM", "") not in ("", "dumb") and sys.stdout is not None


def can_show(text: str) -> bool:
    """Return whether the encoding of standard output has every character of a text."""
    try:
        text.encode(getattr(sys.stdout, "encoding", None) or "ascii")
    except (UnicodeEncodeError, LookupError):  # LookupError: an encoding unknown to Python
        return False
    return True


is_unread = False  # whether an answer was for a closed pipe


def write(text: str, exact: bool = False) -> None:
    """Write a whole answer.  A closed pipe ends quietly; any other failure is an error.

    Characters that the encoding lacks are escaped, which a note says; an `exact` text is refused.
    """
    out = _stdout()
    encoding = out.encoding or "ascii"
    try:
        data = text.encode(encoding, out.errors or "strict")
    except UnicodeEncodeError:
        data = _encoded(text.replace("±", "+-"), encoding, exact)
    try:
        pour(data)
    except BrokenPipeError:  # the reader has stopped, but the exit status still matters
        global is_unread
        is_unread = True


def _encoded(text: str, encoding: str, exact: bool) -> bytes:
    import codecs

    try:
        return text.encode(encoding)
    except UnicodeEncodeError as error:
        if exact:
            from radcalc.errors import OutputError, quote

            lacking = quote(text[error.start])
            problem = f"cannot write the answer: the encoding {encoding} lacks '{lacking}'"
            raise OutputError(problem, "PYTHONIOENCODING=utf-8, or JSON") from None
    say(remarks((), [f"characters that {encoding} lacks are written as their codes"]))
    codecs.register_error("radcalc", _escaped)
    return text.encode(encoding, "radcalc")


def _escaped(error: "Any") -> "tuple[str, int]":
    """Return characters missing in an encoding, escaped as in JSON."""
    data = error.object[error.start : error.end].encode("utf-16-be", "surrogatepass")
    units = [data[k : k + 2].hex() for k in range(0, len(data), 2)]
    return "".join([f"\\u{unit}" for unit in units]), error.end


def pour(data: bytes) -> None:
    """Write a part of a stream at once.  A closed pipe raises, to end the stream."""
    try:
        _send(_stdout(), data)
    except BrokenPipeError:
        raise
    except OSError as error:
        from radcalc.errors import OutputError

        problem = f"cannot write the answer: {error.strerror or error}"
        raise OutputError(problem, "a place with room for it") from None


def read(size: int) -> bytes:
    """Read at most `size` available bytes from standard input; none at its end.

    Wait for data if the descriptor does not block.
    """
    from radcalc.errors import RadcalcError

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
        from radcalc.errors import OutputError

        raise OutputError("cannot write the answer: standard output is closed", "a file or a pipe")
    return sys.stdout


def _send(file: "Any", data: bytes) -> None:
    """Write everything, however little is taken at a time.

    Python's buffer fails if a descriptor does not block, and without a buffer (`python -u`) data
    that are not taken are lost; so this writes to the raw file.
    """
    raw = _unbuffered(file)
    rest = memoryview(data)
    while rest:
        try:
            taken = raw.write(rest)
        except OSError as error:
            if IS_WINDOWS and _is_closed_pipe(raw, error):
                raise BrokenPipeError from None
            raise
        if taken is None:
            _wait(raw, reading=False)
        else:
            rest = rest[taken:]


def _is_closed_pipe(raw: "Any", error: OSError) -> bool:
    """Return whether an error is that of a closed pipe on Windows, where it may be EINVAL.

    See https://github.com/python/cpython/issues/79935.
    """
    from errno import EINVAL
    from stat import S_ISFIFO

    return error.errno == EINVAL and S_ISFIFO(os.fstat(raw.fileno()).st_mode)


def _unbuffered(file: "Any") -> "Any":
    """Return the raw file of a text file; under `python -u`, its buffer is the raw file."""
    return getattr(file.buffer, "raw", file.buffer)


def _wait(raw: "Any", reading: bool) -> None:
    """Wait until a nonblocking descriptor is ready."""
    from select import select

    place = [raw.fileno()]
    select(place if reading else [], [] if reading else place, [])


def say(lines: "Iterable[str]") -> None:
    """Write lines to standard error, folded and coloured on a terminal; ignore failures."""
    lines = [*lines]
    if not lines:
        return
    from radcalc.errors import printable

    try:
        printable_lines = map(printable, lines)
        if error_is_terminal():
            width, is_colored = _width_of_terminal(), wants_color(_chosen, True)
            text = "".join([message(line, width, is_colored) for line in printable_lines])
        else:
            text = "".join([f"{line}\n" for line in printable_lines])
        _send(sys.stderr, text.encode(sys.stderr.encoding or "ascii", "backslashreplace"))
    except BrokenPipeError:
        _note_unread()
    except (OSError, ValueError, AttributeError):
        pass


def _note_unread() -> None:
    """Note that answers are not read either, if they go where errors go: 2>&1."""
    from contextlib import suppress  # after an error only

    global is_unread
    with suppress(OSError):  # standard output is closed
        is_unread = is_unread or os.path.sameopenfile(1, 2)


def _width_of_terminal() -> int:
    """Return the width of the terminal of standard error; no limit if unknown."""
    try:
        return os.get_terminal_size(2).columns or sys.maxsize
    except (OSError, ValueError):
        return sys.maxsize


def columns_of(text: str) -> int:
    """Return the columns that a text takes: 2 for a wide letter, 0 for a combining mark.

    >>> columns_of("lamp"), columns_of("灯"), columns_of("e\u0301")
    (4, 2, 1)
    """
    if text.isascii():
        return len(text)
    from unicodedata import category, east_asian_width

    own = [x for x in text if category(x) not in MARKS and not MEDIALS[0] <= x <= MEDIALS[1]]
    return len(own) + sum(east_asian_width(letter) in WIDE for letter in own)


def cut(text: str, width: int) -> str:
    """Return a text within a width, with dots for the end that does not fit."""
    if columns_of(text) <= width:
        return text
    end = len(text)
    while columns_of(text[:end]) > width - len(DOTS):
        end -= 1
    return text[:end].rstrip() + DOTS


def fold(line: str, width: int, deeper: int = 0) -> list[str]:
    """Fold a line between words, with the later parts indented by `deeper`.

    A word with wide letters, which has no blanks where it may be divided, is divided anywhere.
    """
    if columns_of(line) <= width or not line.strip():
        return [line]
    start = line[: len(line) - len(line.lstrip(" "))]
    indent = start + " " * deeper
    lines, now, gap = [], start, ""
    for word in line.strip(" ").split(" "):  # "" between two blanks
        if word and now.strip() and columns_of(now + gap + word) > width:
            lines.append(now)
            now, gap = indent, ""
        if word:
            now, gap = now + gap, ""
        has_wide_letters = columns_of(word) > len(word)
        for part in word if has_wide_letters else [word]:
            if has_wide_letters and columns_of(now + part) > width and now.strip():
                lines.append(now)
                now = indent
            now += part
        gap += " "
    return [*lines, now]


def message(line: str, width: int, is_colored: bool) -> str:
    """Fold a line to a width, and colour its first word by its kind."""
    first, *more = [line] if line.startswith(CALLS) else fold(line, width, HANGING)
    word = first.partition(" ")[0]
    if is_colored and word in COLORS:
        first = f"{COLORS[word]}{word}{RESET}{first[len(word) :]}"
    return "\n".join([first, *more, ""])


def remarks(assumptions: "Iterable[str]", notes: "Iterable[str]") -> list[str]:
    """Return assumptions and notes, a line each."""
    return [f"assumed: {text}" for text in assumptions] + [f"note: {text}" for text in notes]


def complain(
    error: "RadcalcError", spelling: "Any" = None, hints: "Sequence[str] | None" = None
) -> int:
    """Write an error and its hint in a spelling, or the lines of hints; return the exit status."""
    from radcalc.errors import Plain

    message, hint = error.spelled(spelling or Plain)
    if hints is None:
        hints = [f"try: {hint}"] if hint else []
    say([f"radcalc: {message}", *hints])
    return FAILED
