"""Scene files: valid files give the plain sum of their sources; damaged files are refused or read.

The sweep draws sources, a delimiter, decimal points or commas, and the places of units.  Then it
changes single characters: the file is refused with a line number, or gives the sum of its sources.
The sum uses textbook formulas and an independent reader.
"""

import math
import random
import re
import tempfile
from pathlib import Path

import numpy

import radcalc
from radcalc.errors import RadcalcError

SHORT, LONG = 50, 20_000
UNITS = {"m": 1, "cm": 0.01, "mm": 0.001, "lm": 1, "klm": 1000, "cd": 1, "deg": math.pi / 180}
UNITS |= {f"{unit}1": factor for unit, factor in UNITS.items()}  # to the power of 1
UNITS |= {"cd/m2": 1, "": 1}
PLACES = ("x", "y", "z", "aim_x", "aim_y", "aim_z")
TITLES = (*PLACES, "distribution", "flux", "intensity", "exponent", "half_angle")
TITLES += ("width", "length", "luminance")
# A number and its unit, which may be 1 times another unit.
NUMBER = re.compile(r"\s*([-+]?(?:\d+[.,]?\d*|[.,]\d+)) *(?:1 +)?(\D?[^\s,;|]*)\s*")
# Cells that radcalc evaluates after a change: a difference, or a unit divided by a number.
RECKONED = re.compile(r"[\w.,] *- *[\d.,]|/\d")
CHARACTERS = "0123456789.,;- \n"


def drawn_row() -> dict[str, tuple[float, str] | str]:
    """Make the cells of a source above the points, which lights all of them."""
    row: dict[str, tuple[float, str] | str] = {
        "x": (random.uniform(-1, 1), "m"),
        "y": (random.uniform(-1, 1), "m"),
        "z": (random.uniform(2, 4), "m"),
    }
    shape = random.choice(["isotropic", "lobe", "cone", "lambertian"])
    row["distribution"] = shape
    if shape == "lambertian":
        for name in ("width", "length"):
            row[name] = (random.uniform(0.1, 2), "m")
        row["luminance"] = (random.uniform(1, 5000), "cd/m2")
        return row
    if random.random() < 0.5:
        row["flux"] = (random.uniform(100, 5000), "lm")
    else:
        row["intensity"] = (random.uniform(10, 500), "cd")
    if shape == "lobe":
        row["exponent"] = (random.uniform(0, 20), "")
    if shape == "cone":
        row["half_angle"] = (random.uniform(10, 90), "deg")
    if shape != "isotropic" and random.random() < 0.5:
        for name in ("aim_x", "aim_y"):
            row[name] = (random.uniform(-1, 1), "m")
        row["aim_z"] = (0.0, "m")
    return row


def drawn() -> list[str]:
    """Make the lines of a valid file."""
    delimiter = random.choice(",;\t|")
    comma = delimiter != "," and random.random() < 0.5
    in_title = {name for name in PLACES if random.random() < 0.3}
    unit = random.choice(["m", "cm", "mm"])

    def cell(name: str, value: tuple[float, str] | str) -> str:
        if isinstance(value, str):
            return value
        own = unit if value[1] == "m" else value[1]
        text = f"{value[0] / (UNITS[own] if value[1] == 'm' else 1):.{random.choice([1, 2, 4])}f}"
        text = text.replace(".", ",") if comma else text
        bare = name in in_title or (value[1] == "m" and unit == "m" and name in PLACES)
        blank = random.choice(["", " "])
        return text if bare or not own else f"{text}{blank}{own}"

    header = delimiter.join(f"{t} ({unit})" if t in in_title else t for t in TITLES)
    rows = [drawn_row() for _ in range(random.choice([1, 2, 3, 5]))]
    lines = [delimiter.join(cell(t, row.get(t, "")) for t in TITLES) for row in rows]
    return [header, *lines]


def damaged(lines: list[str]) -> list[str]:
    """Drop, double, insert or replace characters of the rows."""
    text = list("\n".join(lines[1:]))
    for _ in range(random.choice([1, 1, 2, 5])):
        place = random.randrange(len(text) + 1)
        end = place + random.choice([0, 1, 1, 5, 50])
        part = text[place:end]
        twice = part if any(map(str.isalpha, part)) else 2 * part  # ccd and kklm may be units
        text[place:end] = random.choice([[], [random.choice(CHARACTERS)], twice])
    return [lines[0], *"".join(text).split("\n")]


def read(lines: list[str]) -> list[dict[str, float | str]]:
    """Return the cells of the rows in SI, or nothing if one is an expression.

    Raise ValueError if a cell is not a number.
    """
    delimiter = next(mark for mark in "\t;|," if mark in lines[0])
    titles = [title.partition(" (") for title in lines[0].split(delimiter)]
    rows: list[dict[str, float | str]] = []
    marks = set()
    for line in lines[1:]:
        if not line.strip(" \t;,|"):
            continue
        row: dict[str, float | str] = {}
        cells = line.split(delimiter)
        if not "".join(cells[len(titles) :]).strip():  # empty cells at the end
            cells = cells[: len(titles)]
        for (name, _, unit), text in zip(titles, cells, strict=True):
            if not text.strip():
                continue
            if name == "distribution":
                row[name] = text.strip().lower()
                continue
            if RECKONED.search(text):
                return []
            found = NUMBER.fullmatch(text)
            if not found:
                raise ValueError(text)
            marks.update(re.findall(r"[.,](?=\d)", found[1]))
            factor = UNITS[found[2].replace("-", "") or unit.rstrip(")")]  # c-d is cd
            row[name] = float(found[1].replace(",", ".")) * factor
        rows.append(row)
    if len(marks) > 1 or ("," in marks and delimiter == ","):
        raise ValueError("two decimal marks")
    return rows


def light_of(row: dict[str, float | str], point: numpy.ndarray, normal: numpy.ndarray) -> float:
    """Return the illuminance of a source at a point, above the point's horizon."""
    at = {name: value for name, value in row.items() if not isinstance(value, str)}
    place = numpy.array([at["x"], at["y"], at["z"]])
    shape = row.get("distribution", "")
    if shape == "lambertian" or "luminance" in at:
        across, along = at["width"] / 2, at["length"] / 2
        signs = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
        corners = [place - point + numpy.array([a * across, b * along, 0]) for a, b in signs]
        vector = numpy.zeros(3)  # Lambert's contour formula
        for one, other in zip(corners, [*corners[1:], corners[0]], strict=True):
            edge = numpy.cross(one, other)
            size = float(numpy.linalg.norm(edge))
            vector += edge / size * math.atan2(size, float(one @ other)) / 2
        return at["luminance"] * abs(float(normal @ vector))
    aim = numpy.array([at["aim_x"], at["aim_y"], at["aim_z"]]) - place if "aim_x" in at else None
    axis = numpy.array([0.0, 0.0, -1.0]) if aim is None else aim / numpy.linalg.norm(aim)
    to = point - place
    distance = float(numpy.linalg.norm(to))
    cosine = float(axis @ to) / distance
    if "exponent" in at:
        solid_angle = 2 * math.pi / (at["exponent"] + 1)
        fall = cosine ** at["exponent"] if cosine > 0 else 0.0
    elif "half_angle" in at:
        solid_angle = 2 * math.pi * (1 - math.cos(at["half_angle"]))
        fall = float(math.acos(max(-1.0, min(1.0, cosine))) <= at["half_angle"])
    else:
        solid_angle, fall = 4 * math.pi, 1.0
    intensity = at["intensity"] if "intensity" in at else at["flux"] / solid_angle
    return intensity * fall * max(-float(normal @ to), 0.0) / distance**3


def is_far_out(row: dict[str, float | str]) -> bool:
    """Return whether the horizon may cut a panel."""
    if "aim_x" in row and "luminance" in row:
        return True
    sizes = (row.get(name, 0.0) for name in ("x", "y", "width", "length"))
    return float(row["z"]) < 1.5 or max(abs(float(size)) for size in sizes) > 2


def answer_or_refusal(path: Path, point: numpy.ndarray, normal: numpy.ndarray) -> float | str:
    """Return the illuminance at a point, or the error."""
    try:
        answer = radcalc.scene(str(path), point, normal=tuple(normal.tolist()))
    except RadcalcError as error:
        return str(error)
    return float(answer["irradiance"].to("lx").magnitude[0])


def sweep(count: int, seed: int) -> str:
    """Read a valid and a damaged file in each case."""
    random.seed(seed)
    refused = unclear = 0
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "rig.csv"
        for _ in range(count):
            lines = drawn()
            point = numpy.array([random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), 0.0])
            normal = numpy.array([random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2), 1.0])
            for text in (lines, damaged(lines)):
                path.write_text("\n".join(text) + "\n")
                where = (text, point.tolist(), normal.tolist())
                answer = answer_or_refusal(path, point, normal)
                if isinstance(answer, str):
                    assert text is not lines, (answer, where)
                    line = re.search(r"rig\.csv, line (\d+)", answer)
                    assert line or "no source" in answer, (answer, where)
                    assert not line or 1 <= int(line[1]) <= len(text), (answer, where)
                    refused += 1
                    continue
                rows = read(text)
                if not rows or any(map(is_far_out, rows)):
                    unclear += 1
                    continue
                up = normal / numpy.linalg.norm(normal)
                expected = sum(light_of(row, point, up) for row in rows)
                is_sum = math.isclose(answer, expected, rel_tol=1e-9, abs_tol=1e-12)
                assert is_sum, (answer, expected, where)
    return (
        f"{count} scenes and as many damaged ones; {refused} were refused, {unclear} not compared"
    )


if __name__ == "__main__":
    from fuzz.command import main

    main(sweep, LONG)
