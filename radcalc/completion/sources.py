"""The table of completion where no wheel brings it: made of the commands, and kept."""

import ast
import os
from contextlib import suppress
from importlib import import_module
from pathlib import Path
from typing import Any

PACKAGE = Path(__file__).parent.parent
KEPT = Path(__file__).parent / "__pycache__" / "table.txt"


def made() -> dict[str, Any]:
    """Return the table by its names.

    The commands are above this room, and are imported by their name.
    """
    state = _state()
    text = _kept(state)
    if not text:
        text = import_module("radcalc.cli.compile").Compiler().text()
        with suppress(OSError):  # a folder that cannot be written keeps nothing
            _keep(state + text)
    return {
        node.targets[0].id: ast.literal_eval(node.value)
        for node in ast.parse(text).body
        if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name)
    }


def _state() -> str:
    """Return a line that differs after any change of the sources."""
    files = [
        file.stat()
        for folder, _, names in os.walk(PACKAGE)
        if not folder.endswith("__pycache__")
        for file in map(Path(folder).joinpath, names)
    ]
    size, newest = sum(file.st_size for file in files), max(file.st_mtime_ns for file in files)
    return f"# {len(files)} {size} {newest}\n"


def _kept(state: str) -> str:
    """Return the table that was made of the sources in this state, if it was kept."""
    with suppress(OSError, UnicodeDecodeError):
        text = KEPT.read_text(encoding="utf-8")
        if text.startswith(state):
            return text
    return ""


def _keep(text: str) -> None:
    """Write the table in one step, so that nobody reads a part of it."""
    KEPT.parent.mkdir(exist_ok=True)
    path = KEPT.with_suffix(f".{os.getpid()}")
    path.write_text(text, encoding="utf-8")
    os.replace(path, KEPT)
