"""Files of instruments and of laboratories that are not plain tables.

Files of hand-held meters (UPRtek, Sekonic, LI-COR) have the wavelength in the name of each row:

    LUX<TAB>695.154907             Illuminance [lx],30.1
    CCT<TAB>5198.000000            Tcp [K],3262
    380nm<TAB>0.030267             Spectral Data 380[nm],0.000000000000

They do not state the unit of the spectrum; it is the unit that reproduces the illuminance of the
meter.

CGATS files, of X-Rite's and other instruments, have a row per sample and a column per wavelength.
Most contain the reflectances of a chart; light is data that the file calls emission or ambient, or
a .ccss (spectra of a display).  In the files of ArgyllCMS, SPECTRAL_NORM divides the values, and
the wavelengths in the titles of the columns are rounded to 1 nm [1]_.

IES TM-27-14 (spdx): XML files of spectral data, in nanometres and SI units, or relative.  The names
of elements may have the namespace of the standard, another one or none.

Files of Ocean Optics' programs (OceanView, SpectraSuite, Jaz) have a preamble before a plain table:

    Data from lamp_AbsoluteIrradiance_12-00.txt Node
    XAxis mode: Wavelengths
    Number of Pixels in Spectrum: 2048
    >>>>>Begin Spectral Data<<<<<

A table of Jaz has the columns W (wavelength), D (dark), R (reference, optional), S (sample) and P
(processed).  The files do not state that P of an absolute irradiance is in uW/cm2/nm; the R package
photobiologyInOut reads it so.

References
----------
.. [1] ArgyllCMS, xicc/xspect.c (`read_nxspect`, `getval_lxspec`) and xicc/ccss.c.
"""

import re
from collections.abc import Callable, Mapping, Sequence
from itertools import pairwise
from typing import NamedTuple
from xml.parsers import expat

from radcalc.errors import ConditionError, listed, nearest, option, quote
from radcalc.files import columns, refusal
from radcalc.files.columns import plain
from radcalc.spectra.column_titles import KNOWN, PROPERTY, RELATIVE_WATTS, Meaning
from radcalc.spectra.contents import Contents, Figure, Row
from radcalc.spectra.observers import AVOGADRO

SEARCHED = 500  # lines that are searched for the spectrum
BAND_ROW = re.compile(
    r'\s*"?(?:spectral data\s*)?(\d{2,5}(?:[.,]\d+)?)\s*\[?nm\]?"?\s*([\t,;])(.*)', re.IGNORECASE
)
# Names of results, and the meters' names of them.
FIGURES = {
    "illuminance": ("lux", "illuminance [lx]"),
    "irradiance": ("irr",),
    "ppfd": ("ppfd", "ppfd [umolm⁻²s⁻¹]"),
    "cct": ("cct", "tcp [k]"),
}
# Units of spectra; they differ by powers of ten, so that the illuminance distinguishes them.
ABSOLUTE = tuple(
    Meaning(f"in {unit}, which reproduces the meter's illuminance", photons, "irradiance", factor)
    for unit, photons, factor in (
        ("W/m2/nm", False, 1.0),
        ("mW/m2/nm", False, 1e-3),
        ("uW/cm2/nm", False, 1e-2),
        ("umol/m2/s/nm", True, 1e-6 * AVOGADRO),
    )
)


def is_of_meter(lines: Sequence[str]) -> bool:
    """Return whether a file has several rows with wavelengths as names."""
    return sum(BAND_ROW.match(line) is not None for line in lines[:SEARCHED]) > 1


def read_meter(lines: Sequence[str], name: str, column: str) -> Contents:
    """Return the rows of the finest table, and the figures of the meter."""
    if column:
        raise refusal(name, 0, "there are no columns to choose from", f"no {option('column')}")
    tables: list[list[Row]] = []
    is_exact = True  # whether every comma separates cells
    for number, line in enumerate(lines, 1):
        if match := BAND_ROW.match(line):
            row = number, match[1], _value(name, number, match[3], match[2])
            is_exact &= match[2] == "," and '"' not in match[3]
            if not tables or row[1] == tables[-1][0][1]:
                tables.append([])
            tables[-1].append(row)
    finest = max(tables, key=len)
    for table in tables:
        _refuse_gaps(table, name)
        if (table[0][1], table[-1][1]) != (finest[0][1], finest[-1][1]):
            problem = f"it ends at {finest[-1][1]} nm, another table at {table[-1][1]} nm"
            raise refusal(name, finest[-1][0], problem, "the whole file")
    notes: tuple[str, ...] = ()
    if len(tables) > 1:
        notes = (f"of its {len(tables)} tables the one of {len(finest)} rows is used",)
    figures = _figures(lines)
    meanings = (RELATIVE_WATTS, *(ABSOLUTE if "illuminance" in figures else ()))
    return Contents(finest, meanings, notes, figures, has_commas=not is_exact)


def _value(name: str, number: int, text: str, delimiter: str) -> str:
    cells = columns.cells(text.rstrip(f"{delimiter} "), delimiter)
    if len(cells) != 1:
        problem = f"{len(cells)} values at one wavelength"
        raise refusal(name, number, problem, "a file with one value in every row")
    return cells[0]


def _refuse_gaps(table: list[Row], name: str) -> None:
    """Raise for a table with a missing row: its steps are not all the same."""
    places = [float(row[1].replace(",", ".")) for row in table]
    steps = [after - before for before, after in pairwise(places)]
    for row, step in zip(table[1:], steps, strict=True):
        if abs(step - steps[0]) > 1e-6:
            problem = f"a step of {step:g} nm to {row[1]} nm, while the first is {steps[0]:g} nm"
            raise refusal(name, row[0], problem, "a row for every wavelength")


def _figures(lines: Sequence[str]) -> Mapping[str, Figure]:
    names = {spelling: name for name, spellings in FIGURES.items() for spelling in spellings}
    figures = {}
    for line in lines:
        cells = columns.cells_alone(line)
        name = names.get(columns.plain(cells[0]), "") if len(cells) > 1 else ""
        if name:
            number = columns.finite(cells[1], True)
            if number is not None and number > 0:
                places = len(cells[1].replace(",", ".").partition(".")[2])
                figures[name] = Figure(number, 0.5 * 10.0**-places)
    return figures


FORMAT, DATA = "BEGIN_DATA_FORMAT", "BEGIN_DATA"
HEAD = 1000  # lines that are searched for the format
BAND_TITLE = re.compile(
    r"(?:nm|spec_|spectral_(?:nm)?_?|r_)(\d{3,4}(?:\.\d+)?)(?:nm)?", re.IGNORECASE
)
KEYS = ("MEAS_TYPE", "MEASUREMENT_SOURCE", "MEASUREMENT_TYPE", "MEASUREMENT_MODE")
EMITTED = re.compile(r"\b(?:emission|emissive|emitted|ambient|telephoto)", re.IGNORECASE)
CCSS = "CCSS"  # in the first line: spectra of a display
NORM = "SPECTRAL_NORM"
GRID = ("SPECTRAL_BANDS", "SPECTRAL_START_NM", "SPECTRAL_END_NM")
SHOWN = 5


def is_cgats(lines: Sequence[str]) -> bool:
    """Return whether a file declares the format of its data."""
    return any(line.strip() == FORMAT for line in lines[:HEAD])


def read_cgats(lines: Sequence[str], name: str, column: str) -> Contents:
    """Return the bands of one sample, named by `column` if there are several."""
    fields, number = _section(lines, name, FORMAT)
    titles = [field for _, line in fields for field in line.split()]
    bands = [
        (k, match[1]) for k, title in enumerate(titles) if (match := BAND_TITLE.fullmatch(title))
    ]
    if len(bands) < 2:
        raise refusal(name, number, "no columns of wavelengths", "columns such as nm380, nm390")
    data, last = _section(lines, name, DATA)
    facts = dict(map(_keyword, lines[:last]))
    is_light = lines[0].strip() == CCSS or any(EMITTED.search(facts.get(key, "")) for key in KEYS)
    if not is_light:
        problem = "the file does not state that this is light: it may be a reflectance of samples"
        raise refusal(name, 0, problem, f'{KEYS[0]} "EMISSION" in the file, where it is light')
    rows = [(number, columns.cells(line, "\t" if "\t" in line else None)) for number, line in data]
    for number, cells in rows:
        if len(cells) != len(titles):
            problem = f"{len(cells)} columns instead of {len(titles)}"
            raise refusal(name, number, problem, "a value in every column")
    _hold(name, facts, "NUMBER_OF_FIELDS", len(titles), "fields")
    _hold(name, facts, "NUMBER_OF_SETS", len(rows), "rows")
    number, cells = _chosen(rows, titles, name, column)
    places = _exact(name, facts, [band for _, band in bands])
    values = [(number, place, cells[k]) for place, (k, _) in zip(places, bands, strict=True)]
    norm = columns.finite(facts.get(NORM, "1"), False)
    if not norm or norm < 0:
        raise refusal(name, 0, f"{NORM} is {quote(facts[NORM])}", "a number above 0")
    notes = (f"its values are divided by its {NORM} of {norm:g}",) if norm != 1 else ()
    return Contents(values, (RELATIVE_WATTS,), notes, has_commas=True, divisor=norm)


def _exact(name: str, facts: dict[str, str], titles: list[str]) -> list[str]:
    """Return the wavelengths by the keywords of ArgyllCMS, whose titles are rounded to 1 nm."""
    count, start, end = (columns.finite(facts.get(key, ""), False) for key in GRID)
    if count is None or start is None or end is None:
        return titles
    exact = [start + k * (end - start) / (len(titles) - 1) for k in range(len(titles))]
    differences = [abs(x - float(title)) for x, title in zip(exact, titles, strict=True)]
    if count != len(titles) or max(differences) > 0.5:
        problem = f"the columns of wavelengths do not agree with {', '.join(GRID)}"
        raise refusal(name, 0, problem, "the whole file")
    return [f"{x:.10g}" for x in exact]


def _section(lines: Sequence[str], name: str, start: str) -> tuple[list[tuple[int, str]], int]:
    stripped = [line.strip() for line in lines]
    end = start.replace("BEGIN", "END")
    for word in (start, end):
        if stripped.count(word) != 1:
            count = stripped.count(word)
            raise refusal(name, 0, f"{count} times {word}", "the whole file, of one table")
    first, last = stripped.index(start) + 1, stripped.index(end)
    section = [(k + 1, lines[k]) for k in range(first, last) if stripped[k]]
    if not section:
        raise refusal(name, first, f"no lines after {start}", "the whole file")
    return section, first


def _keyword(line: str) -> tuple[str, str]:
    key, _, value = line.strip().partition("\t" if "\t" in line else " ")
    return key, value.strip().strip('"')


def _hold(name: str, facts: dict[str, str], key: str, count: int, what: str) -> None:
    """Raise for a file whose count of something differs from the stated one."""
    if facts.get(key, str(count)) != str(count):
        problem = f"{count} {what}, but {key} is {quote(facts[key])}"
        raise refusal(name, 0, problem, "the whole file")


def _chosen(
    rows: list[tuple[int, list[str]]], titles: list[str], name: str, column: str
) -> tuple[int, list[str]]:
    """Return the row of the sample that the caller names, or the only one."""
    named = next((k for k, title in enumerate(titles) if title.upper() == "SAMPLE_NAME"), 0)
    samples = [cells[named] for _, cells in rows]
    if not column:
        if len(rows) == 1:
            return rows[0]
        hint = f"{name}:NAME (or {option('column')}) with one of: {listed(samples)}"
        raise refusal(name, 0, f"there are {len(rows)} samples", hint)
    if samples.count(column) == 1:
        return rows[samples.index(column)]
    near = nearest(column, [quote(sample) for sample in samples], SHOWN)
    problem = f"unknown sample '{quote(column)}'"
    if column in samples:
        problem = f"{samples.count(column)} samples are named '{quote(column)}'"
    raise refusal(name, 0, problem, ", ".join(near) or listed(samples))


SPDX_ROOT = "IESTM2714"
SPDX_LIGHT = {
    "flux": "W/nm",
    "intensity": "W/sr/nm",
    "irradiance": "W/m2/nm",
    "exitance": "W/m2/nm",
    "radiance": "W/m2/sr/nm",
}
SPDX_RELATIVE = "relative"
SPDX_ELEMENTS = ("SpectralData", "SpectralQuantity")  # the elements whose text is read
SPDX_QUANTITIES = f"{', '.join(SPDX_LIGHT)} or {SPDX_RELATIVE}"


def is_xml(lines: Sequence[str]) -> bool:
    """Return whether a file is XML."""
    first = next((line for line in lines if line.strip()), "")
    return first.lstrip().startswith("<")


def read_spdx(lines: Sequence[str], name: str, column: str) -> Contents:
    """Return the rows of a file, which has one spectrum, so that no column can be chosen."""
    if column:
        raise refusal(name, 0, "a file of TM-27 has no columns", "leave out the column")
    document = _Document(name)
    document.read("\n".join(lines))
    quantity = document.quantity
    if quantity == SPDX_RELATIVE:
        return Contents(document.rows, (Meaning("relative watts per wavelength of IES TM-27"),))
    if quantity not in SPDX_LIGHT:
        problem = f"the quantity is '{quote(quantity)}'" if quantity else "a quantity is missing"
        raise refusal(name, 0, problem, f"SpectralQuantity: {SPDX_QUANTITIES}")
    note = f"its {quantity} taken in {SPDX_LIGHT[quantity]}, the SI units of IES TM-27"
    return Contents(document.rows, (Meaning(note, absolute=quantity),))


class _Document:
    """The data read while a document is parsed."""

    def __init__(self, name: str) -> None:
        self.name = name
        self.rows: list[Row] = []
        self.quantity = ""
        self.path: list[str] = []
        self.text: list[str] = []
        self.wavelength = ""
        self.has_distribution = False
        self.parser = expat.ParserCreate("utf-8")
        self.parser.buffer_text = True
        self.parser.StartElementHandler = self.start
        self.parser.EndElementHandler = self.end
        self.parser.CharacterDataHandler = self.data
        # Entity declarations could expand to gigabytes, and a spectrum needs none.
        self.parser.StartDoctypeDeclHandler = self.refuse_doctype

    def read(self, text: str) -> None:
        """Parse the text, now in UTF-8 whatever encoding it declares."""
        try:
            self.parser.Parse(text.encode(), True)
        except expat.ExpatError as error:
            problem = f"not XML: {expat.errors.messages[error.code]}"
            raise refusal(self.name, error.lineno, problem, "the whole file") from None
        if not self.rows:
            raise refusal(self.name, 0, "there is no SpectralData", "a file of IES TM-27-14")

    @property
    def line(self) -> int:
        return self.parser.CurrentLineNumber

    def start(self, tag: str, attributes: dict[str, str]) -> None:
        name = tag.rpartition(":")[2]
        if not self.path and name != SPDX_ROOT:
            problem = f"XML of '{quote(name)}', not {SPDX_ROOT}"
            raise refusal(self.name, self.line, problem, "a file of IES TM-27-14")
        if name == "SpectralDistribution":
            if self.has_distribution:
                raise refusal(self.name, self.line, "a second spectrum", "a file of one")
            self.has_distribution = True
        self.path.append(name)
        self.text = []
        if name == "SpectralData":
            self.wavelength = attributes.get("wavelength", "").strip()
            if not self.wavelength:
                raise refusal(self.name, self.line, "a wavelength is missing", "one in every row")

    def end(self, tag: str) -> None:
        name, text = self.path.pop(), "".join(self.text).strip()
        self.text = []
        if name == "SpectralData":
            self.rows.append((self.line, self.wavelength, text))
        elif name == "SpectralQuantity":
            if self.quantity:
                raise refusal(self.name, self.line, "a second spectrum", "a file of one")
            self.quantity = text.lower()

    def data(self, text: str) -> None:
        if self.path[-1] in SPDX_ELEMENTS:
            self.text.append(text)

    def refuse_doctype(self, *declared: object) -> None:
        raise refusal(self.name, self.line, "a document type declaration", "the file without it")


TABLE_MARK = ">>>>>"  # start of the line before the table, and of the one after it in some files
NODE = re.compile(r"data from (.*) node")
AXIS = re.compile(r"xaxis mode: *(.*)")
PIXELS = re.compile(r"number of pixels in [a-z ]*: *0*(\d{1,9})", re.ASCII)
REFERENCE = "reference spectrum present: yes"
JAZ = (["w", "d", "s", "p"], ["w", "d", "r", "s", "p"])
JAZ_ABSOLUTE = "jaz absolute irradiance"


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


def notes_on_reference(lines: Sequence[str]) -> list[str]:
    """Return a note on doubtful values that a program has processed."""
    if all(plain(line) != REFERENCE for line in lines):
        return []
    return ["a reference spectrum was stored: the values may be relative to it, and not light"]


def processed_column(titles: Sequence[str], lines: Sequence[str]) -> str:
    """Return the meaning of the title of column P of a Jaz; '' for other tables."""
    if [plain(title) for title in titles] not in JAZ:
        return ""
    if len(titles) == len(JAZ[1]):
        return "transmittance or reflectance (P, against R)"
    is_absolute = any(plain(line).startswith(JAZ_ABSOLUTE) for line in lines)
    return "P [uW/cm2/nm]" if is_absolute else "P"


class Format(NamedTuple):
    """A format of whole files: whether lines begin one, and its reader."""

    begins: Callable[[Sequence[str]], bool]
    read: Callable[[Sequence[str], str, str], Contents]


SPDX = Format(is_xml, read_spdx)
FORMATS = (SPDX, Format(is_cgats, read_cgats), Format(is_of_meter, read_meter))
