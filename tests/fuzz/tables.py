"""Logs of every form: the dose is the trapezoids of what was written, or the file is refused.

The generator knows the times, the values and the unit that it writes; it writes them with titles,
delimiters, decimals, notations of times, gaps, marks, further columns and lines of others.
"""

import random
import shlex
import tempfile
from collections import Counter
from datetime import UTC, datetime, timedelta
from itertools import pairwise
from math import isclose
from pathlib import Path

from conftest import run

from radcalc import dose
from radcalc.errors import RadcalcError

SHORT, LONG = 120, 20_000
LUX, WATTS, PHOTONS = "lm/m2", "W/m2", "umol/m2/s"
# Titles of light, with the number of SI (umol for photons) that 1 in the column is.
TITLES = {
    "E [lx]": 1, "E (lx)": 1, "E_lx": 1, "lux": 1, "Illuminance (lux)": 1, "E / lx": 1,
    "E [klx]": 1e3, "Lux (in)": 1, "light [lx] (A)": 1, "E [fc]": 1 / 0.09290304,
    "fc": 1 / 0.09290304, "GHI [W/m2]": 1, "GHI": 1, "DNI (W/m^2)": 1, "Global_W/m2": 1,
    "Ee [mW/cm2]": 10, "GHI [kW/m2]": 1e3, "irradiance (W m-2)": 1, "Ee [uW/cm2]": 0.01,
    "Solar (Wm-2)": 1, "PPFD": 1, "PPFD [umol/m2/s]": 1, "PAR (µmol m-2 s-1)": 1,
    "PAR_umol_m2_s": 1, "Q [mmol/m2/s]": 1e3, "PAR [mmol photons/m2/s]": 1e3,
    "PAR [µmol photons·cm⁻²·s⁻¹]": 1e4, "PPFD (min)": 1, "PPFD [mol photons/m2/d]": 1e6 / 86400,
}  # fmt: skip
# Titles whose numbers are no light, or not in the unit that a name beside them goes with.
REFUSED = (
    "PAR (mV)", "GHI [counts]", "lux [mV]", "GHI [ly/min]", "LUX (klux-h)", "fc [foo]",
    "E [lx] x1000", "log E [lx]", "RH (%)", "T [degC]", "PPFD [%]", "lux (0-1)", "E [lx] ±5%",
    "GHI [J/cm2]", "E [lx h]", "Voltage [V]", "1000 E [lx]", "PAR [a.u.]", "illuminance [cd/m2]",
    "GHI [Wh/m2]", "PPFD [mol/m2]", "d(E)/dt [lx]", "E [lx] / 100", "std E [lx]", "lux raw counts",
    "kilo lux", "Light (volts)",
)  # fmt: skip
EXTRAS = ("T [degC]", "RH (%)", "Battery (V)", "n", "Wind [m/s]", "Pressure (hPa)")
STAMPS = {
    "%Y-%m-%dT%H:%M:%S": ("time",), "%Y-%m-%d %H:%M": ("time",), "%Y-%m-%dT%H:%M:%SZ": ("time",),
    "%Y-%m-%d %H:%M:%S+02:00": ("timestamp",), "%Y%m%dT%H%M%S": ("time",),
    "%d/%m/%Y %H:%M": ("Date Time",), "%m/%d/%Y %H:%M": ("Date Time",),
    "%d.%m.%Y %H:%M": ("Datum",), "%m/%d/%Y %I:%M:%S %p": ("time",), "%d-%b-%Y %H:%M": ("time",),
    "%Y-%m-%d|%H:%M": ("date", "time"), "%d/%m/%Y|%H:%M:%S": ("Date", "Time"),
    "%Y|%m|%d|%H|%M": ("Year", "Month", "Day", "Hour", "Minute"),
    "%Y|%j|%H%M": ("YEAR", "DOY", "HHMM"), "%Y%m%d%H%M": ("YYYYMMDDHHMM",),
    "%Y%m%d%H": ("MESS_DATUM",), "%Y%m%d %H%M": ("time",), "%d/%m/%y %H:%M": ("time",),
    "%Y|%m|%d|%H": ("Year", "MO", "DY", "HR"), "%G-W%V-%uT%H:%M": ("time",),
    "%Y-%m-%d|%H": ("date", "hour"), "%y%m%d%H%M": ("time",), "s": ("t [s]",), "min": ("t (min)",),
    "h": ("t_h",), "bare": ("t",), "unix": ("unix",), "unix ms": ("epoch_ms",),
    "unix bare": ("time",),
}  # fmt: skip
ELAPSED = {"s": 1, "min": 60, "h": 3600, "bare": 1}


def stamp(form: str, start: datetime, when: datetime) -> list[str]:
    """Return the cells of a time in a notation; numbers elapsed are from the start."""
    if form in ELAPSED:
        return [repr((when - start).total_seconds() / ELAPSED[form])]
    if form.startswith("unix"):
        seconds = int(when.replace(tzinfo=UTC).timestamp())
        return [str(seconds * 1000 if form.endswith("ms") else seconds)]
    cells = when.strftime(form).split("|")
    return [str(int(cell)) if form == "%Y|%j|%H%M" else cell for cell in cells]


def number(draw: random.Random, value: float, mark: str) -> str:
    """Return a number with so many digits that it is read without a rounding."""
    text = repr(value)
    if draw.random() < 0.03:
        text = f"{value:e}"
    return text.replace(".", mark)


def table(draw: random.Random) -> tuple[str, float | None, list[str]]:
    """Return the text of a log, its dose [SI; umol of photons], None to refuse, and its faults."""
    faults: list[str] = []
    form = draw.choice([*STAMPS])
    is_bad = draw.random() < 0.15
    title = draw.choice(REFUSED) if is_bad else draw.choice([*TITLES])
    faults += ["title"] * is_bad
    step = timedelta(seconds=draw.choice([60, 300, 600, 3600]))
    if "%M" not in form and "%" in form:
        step = timedelta(hours=1)
    start = datetime(2024, draw.randint(1, 12), draw.randint(1, 28), draw.randint(0, 23))
    count = draw.randint(2, 40)
    times = [start + k * step for k in range(count)]
    digits = draw.choice([0, 1, 1, 2, 3])
    values = [round(draw.uniform(0, 1000), digits) for _ in times]
    delimiter = draw.choice([",", ",", ";", "\t", "|"])
    mark = "," if delimiter != "," and draw.random() < 0.3 else "."
    stamps = [stamp(form, start, when) for when in times]
    stamps = [
        [cell.replace(".", mark) if form in ELAPSED else cell for cell in row] for row in stamps
    ]
    columns = [list(column) for column in zip(*stamps, strict=True)]
    titles = [*STAMPS[form]]
    extras = draw.sample(EXTRAS, draw.choice([0, 0, 1, 2]))
    places = [(title, [number(draw, value, mark) for value in values])]
    places += [(name, [str(draw.randint(1, 90)) for _ in times]) for name in extras]
    if draw.random() < 0.08 and not is_bad:
        places.append((draw.choice([*TITLES]), [str(draw.randint(1, 90)) for _ in times]))
        faults.append("second light")
    if draw.random() < 0.08:
        texts = draw.choice([("ok",), ("A", "B"), ("ok", "bad", ""), ("",)])
        places.append((draw.choice(("status", "sensor")), [draw.choice(texts) for _ in times]))
        faults += ["series"] * (len({*places[-1][1]} - {""}) > 1)
    draw.shuffle(places)
    titles += [name for name, _ in places]
    columns += [column for _, column in places]
    at = titles.index(title)
    if draw.random() < 0.1:
        row = draw.randrange(count)
        texts = ("", "NaN", "-9999", "-99.9", "n/a", "OVER", "1,234.5", "-3", "--", "1.2.3", "<1")
        columns[at][row] = draw.choice(texts)
        faults.append("value")
    rows = [list(row) for row in zip(*columns, strict=True)]
    if draw.random() < 0.04:
        rows.append([draw.choice(["Mean", "Max", "Total"]), *rows[0][1:]])
        faults.append("summary")
    if draw.random() < 0.04:
        rows.insert(draw.randrange(len(rows)), rows[0])
        faults.append("repeated")
    return text_of(draw, titles, rows, delimiter), expected(times, values, title, faults), faults


def text_of(draw: random.Random, titles: list[str], rows: list[list[str]], delimiter: str) -> str:
    """Return the lines of a table, with comments, lines above it, quotes and other ends."""

    def cell(text: str) -> str:
        return f'"{text}"' if delimiter in text or draw.random() < 0.02 else text

    ends = draw.choice(["", "", "", delimiter])
    lines = [delimiter.join(map(cell, row)) + ends for row in (titles, *rows)]
    if draw.random() < 0.15:
        lines.insert(0, draw.choice(["# a logger", "Logger: L7", "Serial,A123", "plot 3", ""]))
    if draw.random() < 0.05:
        lines.insert(draw.randint(1, len(lines)), draw.choice(["# note", ""]))
    return ("\ufeff" * (draw.random() < 0.1)) + draw.choice(["\n", "\r\n"]).join(lines) + "\n"


def expected(
    times: list[datetime], values: list[float], title: str, faults: list[str]
) -> float | None:
    """Return the trapezoids of the values; None for a file with a fault."""
    if faults:
        return None
    seconds = [(b - a).total_seconds() for a, b in pairwise(times)]
    steps = zip(pairwise(values), seconds, strict=True)
    return TITLES[title] * sum((a + b) / 2 * step for (a, b), step in steps)


def answer(path: Path, text: str) -> float | str:
    """Return the dose of a log [SI; umol of photons], or why it is refused."""
    path.write_text(text, "utf-8", newline="")
    try:
        found = dose(path).exposure
    except RadcalcError as error:
        return str(error)
    return next(
        float(found.to(unit).magnitude)
        for unit in ("lm*s/m**2", "J/m**2", "umol/m**2")
        if found.is_compatible_with(unit)
    )


def proposed(path: Path) -> int:
    """Run the calls that `columns` proposes for a table; return their number."""
    listed = run("columns", str(path)).stdout.splitlines()
    calls = [shlex.split(line.split("\t")[-1])[1:] for line in listed if "\tradcalc " in line]
    for words in calls:
        kept = words[: words.index("<")] if "<" in words else words
        done = run(*kept, input=path.read_text("utf-8") if "<" in words else "")
        assert not done.returncode, f"{words}: {done.stderr}\n{path.read_text('utf-8')}"
    return len(calls)


def sweep(count: int, seed: int) -> str:
    """Read generated logs; each is right or refused, and what `columns` proposes answers."""
    draw = random.Random(seed)
    counts: Counter[str] = Counter()
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "log.csv"
        for _ in range(count):
            text, right, faults = table(draw)
            found = answer(path, text)
            if draw.random() < 0.1:
                counts["proposed"] += proposed(path)
            if isinstance(found, str):
                counts["refused" if right is None else "needlessly refused"] += 1
                continue
            assert right is not None, f"{faults} but {found}\n{text}"
            assert isclose(found, right, rel_tol=1e-9, abs_tol=1e-6), f"{found} != {right}\n{text}"
            counts["right"] += 1
    return ", ".join(f"{number} {what}" for what, number in sorted(counts.items()))


if __name__ == "__main__":
    from fuzz.command import main

    main(sweep, LONG)
