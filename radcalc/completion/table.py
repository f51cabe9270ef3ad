"""The table of completion: commands with their options, units, names, spectra and results.

A wheel brings it as the module `built`.  Sources keep the one that `radcalc.cli.compile` made of
them; after a change of the sources the table is empty until it is made again.
"""

TYPE_CHECKING = False  # typing is slow to import
if TYPE_CHECKING:
    from collections.abc import Mapping
    from typing import Any

# A command: its line in the help, the form and the values of its operands, and its options.
COMMANDS: "dict[str, Any]" = {}
# The options of radcalc itself: names, form, values, help, is hidden, is repeatable.
RADCALC: "list[Any]" = []
# The units of the quantities, with their names.
UNITS: "dict[str, Any]" = {}
# Names of quantities: the unit ("" if the kind of the source decides it), and is an exitance.
NAMES: "dict[str, Any]" = {}
# Endings of files, by the form of the value.
ENDINGS: "dict[str, Any]" = {}
# The named spectra.
SPECTRA: "dict[str, Any]" = {}
# Results: the commands that have them, each with the words of a call that shows it.
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
