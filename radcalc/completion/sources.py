"""The table of completion of sources without a wheel, kept until they change."""

import ast
import os
from contextlib import suppress
from pathlib import Path
from typing import Any

PACKAGE = Path(__file__).parent.parent
KEPT = Path(__file__).parent / "__pycache__" / "table.txt"


def kept() -> dict[str, Any]:
    """Return the table made from the current sources; empty if there is none."""
    with suppress(OSError, UnicodeDecodeError):
        text = KEPT.read_text(encoding="utf-8")
        if text.startswith(_state()):
            return values_of(text)
    return {}


def values_of(text: str) -> dict[str, Any]:
    """Return the values in the text of the module, by name."""
    return {
        node.targets[0].id: ast.literal_eval(node.value)
        for node in ast.parse(text).body
        if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name)
    }


def keep(text: str) -> None:
    """Keep the text of the module, if the folder is writable."""
    with suppress(OSError):
        KEPT.parent.mkdir(exist_ok=True)
        path = KEPT.with_suffix(f".{os.getpid()}")
        path.write_text(_state() + text, encoding="utf-8")
        os.replace(path, KEPT)  # in one step, so that nobody reads only a part


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
