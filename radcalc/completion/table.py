"""The table of completion: the commands with their options and results, units, names, spectra.

A wheel brings it as the module `built`; sources make it.
"""

try:
    import radcalc.completion.built as built

    _values = vars(built)
except ImportError:
    from radcalc.completion.sources import made

    _values = made()

COMMANDS = _values["COMMANDS"]
RADCALC = _values["RADCALC"]
UNITS = _values["UNITS"]
NAMES = _values["NAMES"]
ENDINGS = _values["ENDINGS"]
SPECTRA = _values["SPECTRA"]
