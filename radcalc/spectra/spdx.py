"""IES TM-27-14: XML files of spectral data, in nanometres and SI units, or relative.

The names of elements may have the namespace of the standard, another one or none.
"""

from collections.abc import Sequence
from xml.parsers import expat

from radcalc.errors import quote
from radcalc.files.text import refusal
from radcalc.spectra.column_titles import Meaning
from radcalc.spectra.contents import Contents, Row

ROOT = "IESTM2714"
LIGHT = {"flux": "W/nm", "intensity": "W/sr/nm", "irradiance": "W/m2/nm", "exitance": "W/m2/nm",
         "radiance": "W/m2/sr/nm"}  # fmt: skip
RELATIVE = "relative"
READ = ("SpectralData", "SpectralQuantity")  # the elements whose text is read
QUANTITIES = f"{', '.join(LIGHT)} or {RELATIVE}"


def begins(lines: Sequence[str]) -> bool:
    """Return whether a file is XML."""
    first = next((line for line in lines if line.strip()), "")
    return first.lstrip().startswith("<")


def read(lines: Sequence[str], name: str, column: str) -> Contents:
    """Return the rows of a file, which has one spectrum, so that no column can be chosen."""
    if column:
        raise refusal(name, 0, "a file of TM-27 has no columns", "leave out the column")
    document = _Document(name)
    document.read("\n".join(lines))
    quantity = document.quantity
    if quantity == RELATIVE:
        return Contents(document.rows, (Meaning("relative watts per wavelength of IES TM-27"),))
    if quantity not in LIGHT:
        problem = f"the quantity is '{quote(quantity)}'" if quantity else "a quantity is missing"
        raise refusal(name, 0, problem, f"SpectralQuantity: {QUANTITIES}")
    note = f"its {quantity} taken in {LIGHT[quantity]}, the SI units of IES TM-27"
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
        if not self.path and name != ROOT:
            problem = f"XML of '{quote(name)}', not {ROOT}"
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
        if self.path[-1] in READ:
            self.text.append(text)

    def refuse_doctype(self, *declared: object) -> None:
        raise refusal(self.name, self.line, "a document type declaration", "the file without it")
