"""What several tests share."""

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
