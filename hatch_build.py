"""Build hook of the wheel: catalogues, the table of completion, the manual, the start of `radcalc`.

The catalogues of other languages are compiled: for an editable install next to their sources.

The table is printed from the pages of the commands.  Sources make it on demand, so an editable
install has none.
A wheel has the manual twice: in share/man, where `man` looks, and in the package, where
`radcalc manual` finds it however the wheel was installed.

`radcalc` starts from the entry point or from `bin/radcalc`.  The entry point runs everywhere, but
the one written by pip before 25.2 imports re, which takes longer than a conversion.  The script
does not.  But on Windows pip makes no radcalc.exe from a script, and elsewhere the first line of a
script fails if Python's path has a blank or is long.  A wheel must not have both under one name:
pip then drops the script, and others fail.

So a wheel that is built from a source distribution, as `python -m build` and `uv build` do, has the
entry point and runs everywhere.  A wheel that is built from the tree, as `pip install .` does, is
for the machine that builds it: it has the script if the building Python can run it, and then the
tag of that platform.  No other platform installs it, and PyPI does not accept it from Linux.
"""

import glob
import os
import subprocess
import sys
import tempfile
from contextlib import suppress
from typing import Any

import polib
from hatchling.builders.hooks.plugin.interface import BuildHookInterface
from packaging.tags import platform_tags  # hatchling needs packaging itself

LONGEST = 127  # bytes of a first line, for Linux before 5.1


class Additions(BuildHookInterface):
    """The hook of the wheel."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Add the catalogues, the table and the pages; replace the entry point by the script."""
        self.folder = tempfile.TemporaryDirectory()
        is_editable = version == "editable"
        for name in glob.glob("radcalc/locale/*/*/*.po", root_dir=self.root):
            catalogue = polib.pofile(os.path.join(self.root, name))
            compiled = name.replace(".po", ".mo")
            with suppress(OSError):  # next to the sources, for an editable install and the tests
                catalogue.save_as_mofile(os.path.join(self.root, compiled))
            if not is_editable:
                path = os.path.join(self.folder.name, compiled.replace("/", "-"))
                catalogue.save_as_mofile(path)
                build_data["force_include"][path] = compiled
        if not is_editable:
            build_data["force_include"][os.path.join(self.root, "man")] = "radcalc/man"
            table = os.path.join(self.folder.name, "built.py")
            _print_table(self.root, table)
            build_data["force_include"][table] = "radcalc/completion/built.py"
        script = os.path.join(self.root, "bin", "radcalc")
        is_source_distribution = os.path.exists(os.path.join(self.root, "PKG-INFO"))
        if not is_source_distribution and _runs(script):
            build_data["shared_scripts"][script] = "radcalc"
            build_data["tag"] = f"py3-none-{_platform()}"
            self.metadata.core.scripts.clear()


def _print_table(root: str, path: str) -> None:
    """Print the table in a separate process.

    The path of the tree is not in PYTHONPATH: pip takes it out if the tree is also installed as
    editable.
    """
    code = "import runpy, sys; sys.path.insert(0, sys.argv.pop(1))"
    run = "runpy.run_module('radcalc.completion.rows', run_name='__main__')"
    subprocess.run([sys.executable, "-B", "-c", f"{code}; {run}", root, path], check=True)


def _platform() -> str:
    """Return the platform as in the tags of wheels; on Linux, the one that PyPI refuses."""
    return next(tag for tag in platform_tags() if "manylinux" not in tag and "musllinux" not in tag)


def _runs(script: str) -> bool:
    """Return whether the script runs under this Python."""
    first_line = os.fsencode(f"#!{sys.executable}")
    return (
        os.name == "posix"
        and len(first_line) <= LONGEST
        and len(first_line.split()) == 1
        and os.access(script, os.X_OK)  # pip keeps the mode; a copy may have lost it
    )
