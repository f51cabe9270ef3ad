"""Choose what starts `radcalc` where a wheel is installed: the entry point or `bin/radcalc`.

The entry point runs everywhere, but what pip before 25.2 writes for it imports re, which takes
longer than a conversion.  The script does without.  On Windows, though, pip makes no radcalc.exe
of a script, and elsewhere it gives it a first line that fails if Python's path has a blank or is
long.  A wheel must not have both under one name: pip then drops the script, others fail.

So the script replaces the entry point if the Python that builds could run it.  That is the one
installed for when pip installs these sources.  Build a wheel for other machines with
HATCH_BUILD_NO_HOOKS=true: it keeps the entry point.
"""

import os
import sys
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

LONGEST = 127  # bytes of a first line, for Linux before 5.1


class Launcher(BuildHookInterface):
    """A hook of the wheel."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Put the script in the place of the entry point, or leave that."""
        script = os.path.join(self.root, "bin", "radcalc")
        first_line = os.fsencode(f"#!{sys.executable}")
        if (
            os.name == "posix"
            and len(first_line) <= LONGEST
            and len(first_line.split()) == 1
            and os.access(script, os.X_OK)  # pip keeps the mode; a copy may have lost it
        ):
            build_data["shared_scripts"][script] = "radcalc"
            self.metadata.core.scripts.clear()
