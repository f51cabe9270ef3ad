"""Signatures of files: pictures by their first bytes, photometric files by their first lines."""

import re
from collections.abc import Sequence

from radcalc.errors import SHOWN, ConditionError, quote
from radcalc.files import columns

PICTURES = "a Radiance (.hdr), OpenEXR (.exr) or PFM (.pfm) picture"
# Formats of pictures, which are modules of radcalc.distributions.maps.
OF_PICTURES = {b"#?": "rgbe", b"v/1\x01": "exr", b"PF": "pfm", b"Pf": "pfm"}
OLD_RADIANCE = b"FORMAT=32-bit_rle_"  # in the header of a Radiance picture without the first bytes
HEAD = 1000  # bytes that identify a picture, lines that identify an IES file
POINTER = b"version https://git-lfs"  # of Git LFS
OTHERS = {
    b"\xff\xd8\xff": "JPEG",
    b"\x89PNG": "PNG",
    b"GIF8": "GIF",
    b"BM": "BMP",
    b"II*\0": "TIFF",
    b"MM\0*": "TIFF",
    b"\x1f\x8b": "gzip",
    b"PK\x03\x04": "ZIP",
    b"%PDF": "PDF",
}
# Formats of luminaires, which are modules of radcalc.distributions.
IES, EULUMDAT = "ies", "eulumdat"
IES_LINE = re.compile(r"\s*(?:TILT\s*=|IES(?:NA)?\s*(?::|\d))", re.IGNORECASE)
EULUMDAT_HEAD = 26  # lines; the names of the luminaire are text
# Public formats of the sun, which radcalc.streams.solar reads.
EPW, TMY3, NSRDB, BSRN, CRN, CAMS = "EPW", "TMY3", "NSRDB PSM", "BSRN", "CRN", "CAMS"
SURFRAD, SOLRAD, MIDC, MIDC_RAW = "SURFRAD", "SOLRAD", "MIDC", "MIDC (raw)"
PVGIS, PVGIS_TMY = "PVGIS hourly", "PVGIS TMY"
OF_NOAA = re.compile(r" *-?\d[\d.]*(?: +-?\d[\d.]*){2} +(m|-?\d+) +version +\d+ *")
OF_CRN = re.compile(r"\d{5} (?:\d{8} \d{4} ){2}[ .\w]{6} .{7} .{7} .{7} .{7} .{6} ")
OF_MIDC = re.compile(r"DATE \(MM/DD/YYYY\),[A-Z]{3,4},")
OF_MIDC_RAW = re.compile(r"[^,]*,Year,DOY,[A-Z]{3,4},")
SUN_HEAD = 100  # lines of a header


def of_picture(head: bytes) -> str:
    """Return the format of a picture with these first bytes, or ""."""
    found = next((OF_PICTURES[magic] for magic in OF_PICTURES if head.startswith(magic)), "")
    return found or ("rgbe" if OLD_RADIANCE in head[:HEAD] else "")


def of_luminaire(lines: Sequence[str]) -> str:
    """Return the format of a luminaire file with these first lines, or ""."""
    if _has_eulumdat_head(lines):
        return EULUMDAT
    return IES if any(map(IES_LINE.match, lines[:HEAD])) else ""


def of_sun(lines: Sequence[str]) -> str:
    """Return the public format of the sun of a file with these first lines, or ""."""
    first, second, third = (*lines[:3], "", "", "")[:3]
    if first.startswith("LOCATION,") and second.startswith("DESIGN CONDITIONS"):
        return EPW
    if second.startswith("Date (MM/DD/YYYY),Time (HH:MM),"):
        return TMY3
    if first.startswith("Source,Location ID,") and third.startswith("Year,Month,Day,Hour,Minute,"):
        return NSRDB if "Local Time Zone" in first and ",w/m2," in second else ""
    if first.startswith(("*U0001", "*C0001")):
        return BSRN
    if first.startswith(("# ", "Latitude (decimal degrees):")):
        return _of_header(lines[:SUN_HEAD])
    if of_noaa := OF_NOAA.fullmatch(second):
        return SURFRAD if of_noaa[1] == "m" else SOLRAD
    forms = {MIDC: OF_MIDC, MIDC_RAW: OF_MIDC_RAW, CRN: OF_CRN}
    return next((name for name, form in forms.items() if form.match(first)), "")


def _of_header(lines: Sequence[str]) -> str:
    """Return which format with a long header has its titles, too: CAMS, or one of PVGIS."""
    if lines[0].startswith("# "):
        is_cams = any("Title: CAMS " in line for line in lines[:10])
        is_whole = any(line.startswith("# Observation period;") for line in lines)
        return CAMS if is_cams and is_whole else ""
    if "month,year" in lines:
        return PVGIS_TMY
    return PVGIS if any(line.startswith("time,") for line in lines) else ""


def _has_eulumdat_head(lines: Sequence[str]) -> bool:
    """Return whether lines 2 to 7 are numbers, the first two a type and a symmetry."""
    numbers = [columns.finite(line.strip(), True) for line in lines[1:7]]
    is_head = len(numbers) == 6 and None not in numbers
    if not (is_head and numbers[0] in range(4) and numbers[1] in range(5)):
        return False
    return not all(columns.is_number(line.strip(), True) for line in lines[:EULUMDAT_HEAD])


def foreign(head: bytes) -> str:
    """Return the name of another format with these first bytes, or ""."""
    return next((OTHERS[magic] for magic in OTHERS if head.startswith(magic)), "")


def refuse_foreign(head: bytes, name: str, expected: str) -> None:
    """Raise a ConditionError for an empty or compressed file, or one of a format for screens."""
    if not head:
        raise ConditionError(f"{name} is empty", expected)
    if head.startswith(POINTER):
        problem = f"{name} is a Git LFS pointer, not the file"
        raise ConditionError(problem, "git lfs pull, which fetches it")
    kind = foreign(head)
    if kind in ("gzip", "ZIP"):
        raise ConditionError(f"{name} is compressed ({kind})", "what is in it")
    if kind:
        raise ConditionError(f"{name} is {kind}, not a picture of radiances", expected)


def is_no_picture(head: bytes, name: str) -> ConditionError:
    """Return the error for a file that is not a picture of radiances."""
    refuse_foreign(head, name, PICTURES)
    if head.removeprefix(b"\xef\xbb\xbf").lstrip().startswith(b"<"):
        return ConditionError(f"{name} is a web page (HTML) or XML", "the file it leads to")
    text = quote(head[:SHOWN].decode("latin-1"))
    return ConditionError(
        f"{name} is not a picture in a known format: it begins with '{text}'", PICTURES
    )
