"""Build what a wheel has besides the sources: the table of completion, and what starts `radcalc`.

The table is printed from the commands.  Sources make it themselves when it is asked for, so an
editable install has none.

What starts `radcalc` is the entry point or `bin/radcalc`.  The entry point runs everywhere, but
what pip before 25.2 writes for it imports re, which takes longer than a conversion.  The script
does without.  On Windows, though, pip makes no radcalc.exe of a script, and elsewhere it gives it a
first line that fails if Python's path has a blank or is long.  A wheel must not have both under one
name: pip then drops the script, others fail.

So the script replaces the entry point if the Python that builds could run it.  That is the one
installed for when pip installs these sources.  Build a wheel for other machines with
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
    """A hook of the wheel."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Add the table, and put the script in the place of the entry point, or leave that."""
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
    """Print the table in a process and a folder of its own, where no file is one of an example."""
    paths = os.pathsep.join(filter(None, [root, os.environ.get("PYTHONPATH")]))
    subprocess.run(
        [sys.executable, "-B", "-m", "radcalc.cli.compile", path],
        cwd=os.path.dirname(path),
        env={**os.environ, "PYTHONPATH": paths},
        check=True,
    )


def _runs(script: str) -> bool:
    """Return whether the script would run under this Python."""
    first_line = os.fsencode(f"#!{sys.executable}")
    return (
        os.name == "posix"
        and len(first_line) <= LONGEST
        and len(first_line.split()) == 1
        and os.access(script, os.X_OK)  # pip keeps the mode; a copy may have lost it
    )
