"""The process around radcalc: standard output and error, and the exit statuses."""

import os
import sys

from radcalc.errors import OutputError, Plain, RadcalcError

TYPE_CHECKING = False  # typing.TYPE_CHECKING, without the cost of importing typing
if TYPE_CHECKING:
    from collections.abc import Iterable
    from typing import Any

ANSWERED, WRONG, FAILED, BUG, INTERRUPTED = 0, 1, 2, 3, 130


def is_terminal() -> bool:
    """Whether standard output is a terminal."""
    try:
        return os.isatty(1)
    except OSError:
        return False


def write(text: str) -> None:
    """Write a whole answer.  A closed pipe ends quietly; any other failure is an error."""
    out = sys.stdout
    if out is None:
        raise OutputError("cannot write the answer: standard output is closed", "a file or a pipe")
    try:
        try:
            out.write(text)
        except UnicodeEncodeError:
            encoding = out.encoding or "ascii"
            out.write(text.encode(encoding, "backslashreplace").decode(encoding))
        out.flush()
    except BrokenPipeError:
        discard_output()
    except OSError as error:
        raise not_written(error) from None


def read(size: int) -> bytes:
    """Read from standard input what there is, at most so many bytes; none at its end."""
    try:
        return os.read(0, size)
    except OSError as error:
        problem = f"cannot read stdin: {error.strerror or error}"
        raise RadcalcError(problem, "a file or a pipe") from None


def pour(data: bytes) -> None:
    """Write a part of a stream at once.  A closed pipe raises, for there is no use in going on."""
    out = sys.stdout
    if out is None:
        raise OutputError("cannot write the answer: standard output is closed", "a file or a pipe")
    try:
        out.buffer.write(data)
        out.buffer.flush()
    except BrokenPipeError:
        raise
    except OSError as error:
        raise not_written(error) from None


def not_written(error: OSError) -> OutputError:
    """What to raise where standard output fails; nothing more is written there."""
    discard_output()
    problem = f"cannot write the answer: {error.strerror or error}"
    return OutputError(problem, "a place with room for it")


def discard_output() -> None:
    """Let what is still buffered go nowhere, so that Python's own last flush is silent."""
    null = os.open(os.devnull, os.O_WRONLY)
    os.dup2(null, 1)
    os.close(null)


def say(lines: "Iterable[str]") -> None:
    """Write lines to standard error; nobody listening there is no failure."""
    try:
        sys.stderr.write("".join([line + "\n" for line in lines]))
        sys.stderr.flush()
    except (OSError, ValueError, AttributeError):
        pass


def remarks(assumptions: "Iterable[str]", notes: "Iterable[str]") -> list[str]:
    """What was assumed and noted, a line each."""
    return [f"assumed: {text}" for text in assumptions] + [f"note: {text}" for text in notes]


def complain(error: RadcalcError, spelling: "Any" = Plain) -> int:
    """Say what is wrong and what to do, as a gate spells it; return the exit status."""
    message, hint = error.spelled(spelling)
    say([f"radcalc: {message}", *([f"try: {hint}"] if hint else [])])
    return FAILED
