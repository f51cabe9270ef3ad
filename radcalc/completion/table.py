"""The table of completion: commands with their options, units, names, spectra and results.

A wheel brings it as the module `built`.  Sources keep the one that `radcalc.cli.compile` made of
them; after a change of the sources the table is empty until it is made again.
"""

TYPE_CHECKING = False  # typing is slow to import
if TYPE_CHECKING:
    from collections.abc import Mapping
    from typing import Any

COMMANDS: "dict[str, Any]" = {}
RADCALC: "list[Any]" = []
UNITS: "dict[str, Any]" = {}
NAMES: "dict[str, Any]" = {}
ENDINGS: "dict[str, Any]" = {}
SPECTRA: "dict[str, Any]" = {}
RESULTS: "dict[str, Any]" = {}


def fill(values: "Mapping[str, Any]") -> None:
    """Fill the table, whose parts other modules have imported."""
    RADCALC[:] = values["RADCALC"]
    for name in ("COMMANDS", "UNITS", "NAMES", "ENDINGS", "SPECTRA", "RESULTS"):
        globals()[name].update(values[name])


try:
    import radcalc.completion.built as built

    fill(vars(built))
except ImportError:
    from radcalc.completion.sources import kept

    if values := kept():
        fill(values)
