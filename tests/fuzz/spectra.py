"""Spectrum files: valid files give their rows; damaged files are refused, or give rows in the file.

The sweep draws a format, rows, a unit, a delimiter, an encoding, line ends and text before the
table; then it drops, doubles, exchanges and inserts lines, and changes characters.  A damaged file
is refused, or read with rows that were written, in their unit; without a unit it is relative.
Formats with a count of rows lose no row without an error.
"""

import io
import math
import random

from radcalc.errors import RadcalcError
from radcalc.spectra.files import _Reader

SHORT, LONG = 125, 30_000
UNITS = {
    "W/m2/nm": 1.0,
    "mW/m2/nm": 1e-3,
    "uW/cm2/nm": 1e-2,
    "W m-2 nm-1": 1.0,
    "umol/m2/s/nm": 0.0,
}
BEFORE = ["Lamp 7 at 2.9 m", "Date: 2026-11-22 12:00:01", "Integration time [ms]: 48.06", "Gain\t4",
          "Smoothing: 0", "Serial Number\t19J00789"]  # fmt: skip
CHARACTERS = '0123456789 .,;\t-+eE\n#nmW/>"<é\x00'
Rows = list[tuple[str, str]]


def rows() -> Rows:
    """Draw wavelengths and values, as text."""
    step = random.choice([1, 5, 10])
    scale = 10 ** random.uniform(-3, 4)
    return [(str(x), f"{scale * random.uniform(0.1, 1):.6g}") for x in range(380, 781, step)]


def joule(nm: float) -> float:
    """Return the energy of a micromole of photons [J]: h c N_A / lambda of the SI."""
    return 0.119626565643 / (nm * 1e-9) * 1e-6


def plain(table: Rows) -> tuple[str, str]:
    """Write columns; the unit is in the title, the row below, before the table or in a comment."""
    unit, delimiter = random.choice(list(UNITS)), random.choice([",", ";", "\t"])
    before = random.sample(BEFORE, random.choice([0, 0, 2, 4]))
    heads = [
        [f"wavelength (nm){delimiter}E ({unit})"],
        [f"wavelength{delimiter}value", f"nm{delimiter}{unit}"],
        [f"[nm]{delimiter}[{unit}]"],
        [f"Irradiance in {unit}", f"wavelength{delimiter}value"],
        [f"# spectral irradiance [{unit}]", f"wavelength{delimiter}value"],
    ]
    comma = delimiter != "," and random.random() < 0.3
    lines = [delimiter.join(row) for row in table]
    lines = [line.replace(".", ",") if comma else line for line in lines]
    return "\n".join([*before, *random.choice(heads), *lines, ""]), unit


def oceanview(table: Rows) -> tuple[str, str]:
    """Write a table between marks, with its count of rows."""
    count = f"Number of Pixels in Spectrum: {len(table)}"
    head = ["Data from lamp_Irradiance_1.txt Node", "", *random.sample(BEFORE, 2),
            "XAxis mode: Wavelengths",
            count, ">>>>>Begin Spectral Data<<<<<"]  # fmt: skip
    return "\n".join([*head, *map("\t".join, table), ""]), ""


def tm27(table: Rows) -> tuple[str, str]:
    """Write XML."""
    body = [f'<SpectralData wavelength="{x}">{y}</SpectralData>' for x, y in table]
    return "\n".join([
        '<?xml version="1.0"?>', '<IESTM2714 xmlns="iestm2714" version="1.0">',
        "<SpectralDistribution>", "<SpectralQuantity>irradiance</SpectralQuantity>", *body,
        "</SpectralDistribution>", "</IESTM2714>",
    ]), "W/m2/nm"  # fmt: skip


def cgats(table: Rows) -> tuple[str, str]:
    """Write a sample per row."""
    names, values = zip(*table, strict=True)
    return "\n".join([
        'CREATED\t"1/1/2014"', 'MEAS_TYPE\t"EMISSION"', f"NUMBER_OF_FIELDS\t{1 + len(names)}",
        "BEGIN_DATA_FORMAT", "\t".join(["SAMPLE_NAME", *(f"nm{x}" for x in names)]),
        "END_DATA_FORMAT", "NUMBER_OF_SETS\t1", "BEGIN_DATA", "\t".join(["white", *values]),
        "END_DATA", "",
    ]), ""  # fmt: skip


def meter(table: Rows) -> tuple[str, str]:
    """Write a row per wavelength, in one table or in a coarse and a fine one."""
    before = "\n".join(["Model Name\tX", "CCT\t5198.0", *random.sample(BEFORE, 2)])
    form = random.choice(["{}nm\t{}", "{}nm;{}", "{}nm,{},", "Spectral Data {}[nm],{}"])
    coarse = [table[::10]] if len(table) > 100 and random.random() < 0.5 else []
    lines = [form.format(*row) for each in [*coarse, table] for row in each]
    return "\n".join([before, *lines, "bin1,-0.29,1", ""]), ""


FORMATS = (plain, plain, plain, oceanview, tm27, cgats, meter)


def read(data: bytes):
    """Return the table of a file, or the error."""
    try:
        return _Reader("lamp", io.BytesIO(data).read, "", None).table()
    except RadcalcError as error:
        return error


def encoded(text: str) -> bytes:
    """Encode a text in one of the encodings, with one of the line ends."""
    encoding = random.choice(["utf-8", "utf-8", "utf-8-sig", "utf-16"])
    return text.replace("\n", random.choice(["\n", "\r\n"])).encode(encoding)


def damaged(text: str) -> str:
    """Drop, double, exchange or insert lines; the result has only complete lines."""
    lines = text.split("\n")
    for _ in range(random.choice([1, 1, 2, 3])):
        k, other = random.randrange(len(lines)), random.randrange(len(lines))
        act = random.randrange(6)
        if act == 0:
            del lines[k : k + random.choice([1, 1, 2, 50, 399])]
        elif act == 1:
            lines.insert(k, lines[other])
        elif act == 2:
            lines[k], lines[other] = lines[other], lines[k]
        elif act == 3:
            lines.insert(
                k, random.choice(["", "a word", "end of data", "# note", ";;;", "\x00\x00"])
            )
        elif act == 4:
            lines = lines[: k + 1]
        else:
            lines = lines[k:]
        lines = lines or [""]
    return "\n".join(lines)


def mutated(text: str) -> str:
    """Drop, double or replace characters."""
    letters = list(text)
    for _ in range(random.choice([1, 2, 5, 40])):
        k = random.randrange(len(letters) + 1)
        letters[k : k + random.choice([0, 1, 1, 9])] = random.choice(CHARACTERS)
    return "".join(letters)


def expected(table: Rows, unit: str) -> dict[float, float]:
    """Return the watts in the rows."""
    found = {}
    for x, y in table:
        nm = float(x)
        factor = UNITS.get(unit, 1.0) or joule(nm)
        found[nm] = float(y) * factor
    return found


def is_of(found, table: Rows, unit: str) -> bool:
    """Return whether all rows that were read are rows that were written, in a unit."""
    written = expected(table, unit)
    return all(
        x in written and math.isclose(y, written[x], rel_tol=1e-9)
        for x, y in zip(found.grid, found.values, strict=True)
        if x in found.measured  # photons have points in between
    )


def sweep(count: int, seed: int) -> str:
    """Read a valid file, one with damaged lines and one with damaged characters in each case."""
    random.seed(seed)
    refused = 0
    for _ in range(count):
        write = random.choice(FORMATS)
        table = rows()
        text, unit = write(table)
        found = read(encoded(text))
        assert not isinstance(found, Exception), (found, text[:400])
        assert len(found.measured) == len(table), text[:400]
        assert is_of(found, table, unit), text[:400]
        assert bool(found.absolute) == bool(unit), text[:400]
        text = damaged(text)
        found = read(encoded(text))
        if isinstance(found, Exception):
            refused += 1
            assert found.message, text[:400]
            assert found.hint, text[:400]
            read(encoded(mutated(text)))
            continue
        if found.absolute:
            assert is_of(found, table, unit), text[:400]
        else:  # without its unit it is read as relative
            assert "relative" in found.described, text[:400]
            assert is_of(found, table, "") or is_of(found, table, unit), text[:400]
        if f"Number of Pixels in Spectrum: {len(table)}\n" in text.partition(">>>>>")[0]:
            assert len(found.measured) == len(table), text[:400]
        read(encoded(mutated(text)))
    return f"{count} files and as many damaged ones; {refused} were refused"


if __name__ == "__main__":
    from fuzz.command import main

    main(sweep, LONG)
