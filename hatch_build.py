"""Build hook of the wheel: the table of completion, and the start of `radcalc`.

The table is printed from the commands.  Sources make it on demand, so an editable install has none.

`radcalc` starts from the entry point or from `bin/radcalc`.  The entry point runs everywhere, but
the one written by pip before 25.2 imports re, which takes longer than a conversion.  The script
does not.  But on Windows pip makes no radcalc.exe from a script, and elsewhere the first line of a
script fails if Python's path has a blank or is long.  A wheel must not have both under one name:
pip then drops the script, and others fail.

So the script replaces the entry point if the building Python can run it.  That is the installing
Python when pip installs these sources.  Build a wheel for other machines with
RADCALC_ENTRY_POINT=true: it keeps the entry point.
"""

import os
import subprocess
import sys
import tempfile
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

LONGEST = 127  # bytes of a first line, for Linux before 5.1


class Additions(BuildHookInterface):
    """The hook of the wheel."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Add the table, and replace the entry point by the script if it runs."""
        if version != "editable":
            self.folder = tempfile.TemporaryDirectory()
            table = os.path.join(self.folder.name, "built.py")
            _print_table(self.root, table)
            build_data["force_include"][table] = "radcalc/completion/built.py"
        script = os.path.join(self.root, "bin", "radcalc")
        if os.environ.get("RADCALC_ENTRY_POINT") != "true" and _runs(script):
            build_data["shared_scripts"][script] = "radcalc"
            self.metadata.core.scripts.clear()


def _print_table(root: str, path: str) -> None:
    """Print the table in a separate process and an empty folder, so that examples find no file."""
    paths = os.pathsep.join(filter(None, [root, os.environ.get("PYTHONPATH")]))
    subprocess.run(
        [sys.executable, "-B", "-m", "radcalc.cli.compile", path],
        cwd=os.path.dirname(path),
        env={**os.environ, "PYTHONPATH": paths},
        check=True,
    )


def _runs(script: str) -> bool:
    """Return whether the script runs under this Python."""
    first_line = os.fsencode(f"#!{sys.executable}")
    return (
        os.name == "posix"
        and len(first_line) <= LONGEST
        and len(first_line.split()) == 1
        and os.access(script, os.X_OK)  # pip keeps the mode; a copy may have lost it
    )
