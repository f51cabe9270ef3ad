"""The table of completion: commands with their options, units, names and spectra.

A wheel has it as the module `built`; sources make it of the pages at the first Tab.
"""

TYPE_CHECKING = False  # typing is slow to import
if TYPE_CHECKING:
    from typing import Any

    # A command: its line in the help, the form and the values of its operands, and its options.
    COMMANDS: dict[str, Any]
    # The options of radcalc itself: names, form, values, help, is hidden, is repeatable.
    RADCALC: list[Any]
    # The units of the quantities, with their names.
    UNITS: dict[str, Any]
    # Names of quantities: the unit ("" if the kind of the source decides it), and is an exitance.
    NAMES: dict[str, Any]
    # Endings of files, by the form of the value.
    ENDINGS: dict[str, Any]
    # The named spectra.
    SPECTRA: dict[str, Any]
else:
    try:
        from radcalc.completion.built import (  # noqa: F401
            COMMANDS,
            ENDINGS,
            NAMES,
            RADCALC,
            SPECTRA,
            UNITS,
        )
    except ImportError:
        from radcalc.completion.rows import table

        globals().update(table())
