"""What several tests share."""

import os
import pty
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from types import FrameType
from typing import Any

import radcalc

PACKAGE = str(Path(radcalc.__file__).parent)


@contextmanager
def at_most(calls: int) -> Iterator[None]:
    """Stop radcalc where it has called more than so many functions, Python's own among them.

    What has lost its way is told by counting, since a clock tells how busy the machine is.
    """
    left = calls

    def count(frame: FrameType, event: str, _: Any) -> None:
        nonlocal left
        if event in ("call", "c_call") and frame.f_code.co_filename.startswith(PACKAGE):
            left -= 1
            if left < 0:
                raise AssertionError(f"no answer within {calls} calls")

    before = sys.getprofile()
    sys.setprofile(count)
    try:
        yield
    finally:
        sys.setprofile(before)


@contextmanager
def started(*words: str, **streams: Any) -> Iterator[subprocess.Popen[Any]]:
    """A process that ends with the test, whether that passes or fails.

    One that is left running would add a ResourceWarning of its own to another test's failure.
    """
    with subprocess.Popen(words, **streams) as process:
        try:
            yield process
        except BaseException:
            process.kill()
            raise


@contextmanager
def on_terminal(*words: str, **more: Any) -> Iterator[tuple[subprocess.Popen[bytes], int]]:
    """A process whose output is a pseudo-terminal, and the descriptor to read the screen from."""
    leader, follower = pty.openpty()
    try:
        streams = {"stdin": follower, "stdout": follower, "stderr": follower} | more
        with started(*words, **streams) as process:
            os.close(follower)
            yield process, leader
    finally:
        os.close(leader)
