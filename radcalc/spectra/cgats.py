"""CGATS files, of X-Rite's and other instruments: a row per sample, a column per wavelength.

Most contain the reflectances of a chart; light is data that the file calls emission or ambient.
"""

import re
from collections.abc import Sequence

from radcalc.errors import listed, nearest, option, quote
from radcalc.files import columns
from radcalc.files.text import refusal
from radcalc.spectra.column_titles import RELATIVE_WATTS
from radcalc.spectra.contents import Contents

FORMAT, DATA = "BEGIN_DATA_FORMAT", "BEGIN_DATA"
SEARCHED = 1000  # lines that are searched for the format
BAND = re.compile(r"(?:nm|spec_|spectral_(?:nm)?_?|r_)(\d{3,4}(?:\.\d+)?)(?:nm)?", re.IGNORECASE)
KEYS = ("MEAS_TYPE", "MEASUREMENT_SOURCE", "MEASUREMENT_TYPE", "MEASUREMENT_MODE")
EMITTED = re.compile(r"\b(?:emission|emissive|emitted|ambient|telephoto)", re.IGNORECASE)
SHOWN = 5


def begins(lines: Sequence[str]) -> bool:
    """Return whether a file declares the format of its data."""
    return any(line.strip() == FORMAT for line in lines[:SEARCHED])


def read(lines: Sequence[str], name: str, column: str) -> Contents:
    """Return the bands of one sample, named by `column` if there are several."""
    fields, number = _section(lines, name, FORMAT)
    titles = [field for _, line in fields for field in line.split()]
    bands = [(k, match[1]) for k, title in enumerate(titles) if (match := BAND.fullmatch(title))]
    if len(bands) < 2:
        raise refusal(name, number, "no columns of wavelengths", "columns such as nm380, nm390")
    data, last = _section(lines, name, DATA)
    facts = dict(map(_keyword, lines[:last]))
    if not any(EMITTED.search(facts.get(key, "")) for key in KEYS):
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
    values = [(number, band, cells[k]) for k, band in bands]
    return Contents(values, (RELATIVE_WATTS,), has_commas=True)


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
