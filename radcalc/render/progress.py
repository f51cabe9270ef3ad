"""A progress bar on a terminal, drawn by Rich if the work lasts longer than a second."""

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from radcalc import terminal

PATIENCE = 1.0  # [s] before anything is shown


@contextmanager
def progress(task: str, is_wanted: bool = True) -> Iterator[Callable[[int, int], object]]:
    """Yield a function that is called with the work done and the total.

    If standard error is not a terminal, nothing is drawn, and Rich is not loaded.  The bar is
    erased at the end.
    """
    if not (is_wanted and terminal.error_is_terminal()):
        yield lambda done, total: None
        return
    bar = _Bar(task)
    try:
        yield bar
    finally:
        bar.stop()


class _Bar:
    """A bar that appears after a delay."""

    def __init__(self, task: str) -> None:
        self.task, self.start = task, time.monotonic()
        self.drawn: Any = None
        self.row: Any = None

    def __call__(self, done: int, total: int) -> None:
        if self.drawn is None:
            if time.monotonic() - self.start < PATIENCE:
                return
            from rich.console import Console
            from rich.progress import Progress

            colors: Any = "auto" if terminal.wants_color(terminal.chosen_color(), True) else None
            console = Console(stderr=True, no_color=False, color_system=colors)
            self.drawn = Progress(console=console, transient=True)
            self.row = self.drawn.add_task(self.task)
            self.drawn.start()
        self.drawn.update(self.row, completed=done, total=total)

    def stop(self) -> None:
        if self.drawn is not None:
            self.drawn.stop()
