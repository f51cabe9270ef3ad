"""The preamble of files of Ocean Optics' programs (OceanView, SpectraSuite, Jaz).

    Data from lamp_AbsoluteIrradiance_12-00.txt Node
    XAxis mode: Wavelengths
    Number of Pixels in Spectrum: 2048
    >>>>>Begin Spectral Data<<<<<

A table of Jaz has the columns W (wavelength), D (dark), R (reference, optional), S (sample) and P
(processed).  The files do not state that P of an absolute irradiance is in uW/cm2/nm; the R package
photobiologyInOut reads it so.
"""

import re
from collections.abc import Sequence

from radcalc.errors import ConditionError, quote
from radcalc.files.columns import plain
from radcalc.spectra.column_titles import KNOWN, PROPERTY

MARK = ">>>>>"  # start of the line before the table, and of the one after it in some files
NODE = re.compile(r"data from (.*) node")
AXIS = re.compile(r"xaxis mode: *(.*)")
PIXELS = re.compile(r"number of pixels in [a-z ]*: *0*(\d{1,9})", re.ASCII)
REFERENCE = "reference spectrum present: yes"
JAZ = (["w", "d", "s", "p"], ["w", "d", "r", "s", "p"])
ABSOLUTE = "jaz absolute irradiance"


def declared_rows(lines: Sequence[str]) -> int:
    """Return the number of rows that the lines before a table state; 0 if they do not.

    Raises ConditionError for another axis than wavelengths, and for ratios to a reference.
    """
    count = 0
    for line in lines:
        text = plain(line)
        node, axis, pixels = NODE.match(text), AXIS.match(text), PIXELS.match(text)
        if node and (match := re.search(PROPERTY, re.sub(r"[\W\d_]", " ", node[1]))):
            raise ConditionError(f"'{quote(line.strip())}' is a {match[0]}, not light", KNOWN)
        if axis and not axis[1].startswith("wavelength"):
            problem = f"'{quote(line.strip())}' is not a wavelength"
            raise ConditionError(problem, "wavelengths in nm")
        count = int(pixels[1]) if pixels else count
    return count


def notes(lines: Sequence[str]) -> list[str]:
    """Return a note on doubtful values that a program has processed."""
    if all(plain(line) != REFERENCE for line in lines):
        return []
    return ["a reference spectrum was stored: the values may be relative to it, and not light"]


def processed(titles: Sequence[str], lines: Sequence[str]) -> str:
    """Return the meaning of the title of column P of a Jaz; '' for other tables."""
    if [plain(title) for title in titles] not in JAZ:
        return ""
    if len(titles) == len(JAZ[1]):
        return "transmittance or reflectance (P, against R)"
    is_absolute = any(plain(line).startswith(ABSOLUTE) for line in lines)
    return "P [uW/cm2/nm]" if is_absolute else "P"
