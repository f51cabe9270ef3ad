"""Tables through a stream against a slow reference: the csv module, decimals and its own titles.

A case has a table as bytes (delimiters, quotes, blanks, comments, lines with too many fields,
decimal commas, line ends) and its options.  The reference reads it field by field, independently of
radcalc: it has its own factors and names of units.
"""

import csv
import io
import random
import re
from collections import Counter
from contextlib import redirect_stderr, redirect_stdout
from decimal import Decimal
from typing import NamedTuple
from unittest.mock import patch

from radcalc.__main__ import run

SHORT, LONG = 150, 20_000
# The international foot (0.3048 m) gives 1 fc = 1 lm/ft2; a kilolux is 1000 lx.
FACTORS = {("lx", "fc"): Decimal("0.09290304"), ("klx", "lx"): Decimal(1000)}
SPELLINGS = {"lx": ("lx", "lux", "Lux", "lm/m2"), "klx": ("klx", "kilolux", "kilo-lux")}
STYLES = ("{0} [{1}]", "{0} ({1})", "{0}_{1}", "{0}, {1}", "{0} / {1}", "{1}", "{0}", "{0} in {1}")
WORDS = ("E", "desk", "room 7", "sensor-2", "hall", "Osvětlenost", "x")
TEXTS = ("", "ok", "a b", "dim", "no. 5", "ž", "7", "-1.5", "x#", "1e5")
BAD = ("x", "nan", "1.2.3", "", "1_0", "--1", "1/0")
STATUS = {"abort": 2, "fail": 2, "warn": 0, "ignore": 0}


class Table(NamedTuple):
    """A table and the options for it."""

    data: bytes
    words: list[str]
    invalid: str
    wanted: bytes
    is_good: bool


def quoted(cell: str, mark: str) -> str:
    """Write a cell as the csv module does, sometimes in quotes without need."""
    out = io.StringIO()
    style = csv.QUOTE_ALL if random.random() < 0.1 else csv.QUOTE_MINIMAL
    csv.writer(out, delimiter=mark, lineterminator="", quoting=style).writerow([cell])
    return out.getvalue() if cell else ""


def shown(value: Decimal, comma: bool) -> str:
    """Format a number with 12 digits, as C prints it."""
    text = f"{float(value):.12g}"
    return text.replace(".", ",") if comma else text


def draw() -> Table:
    """Draw a table with its options and the expected output."""
    (source, target), factor = random.choice(list(FACTORS.items()))
    comma = random.random() < 0.3
    mark = random.choice(["\t", ";", "|", ""] if comma else [",", ",", "\t", ";", "|", ""])
    width = random.randint(1, 4)
    place = random.randrange(width)
    invalid = random.choice([*STATUS, "warn"])
    adds, names = random.random() < 0.3, random.random() < 0.2
    titles = [f"c{k}" for k in range(width)]
    style, word = random.choice(STYLES), random.choice(WORDS)
    if not mark:
        style, word = random.choice(STYLES[:3]), re.sub(r"\s", "-", word)
    spelling = random.choice(SPELLINGS[source])
    titles[place] = style.format(word, spelling)
    has_unit = "{1}" in style
    after = list(titles)
    if adds:
        after.append(f"new [{target}]")
    elif names:
        after[place] = style.format("new", target) if has_unit else "new"
        if style == "{1}":
            after[place] = f"new [{target}]"
    elif has_unit:
        after[place] = style.format(word, target)
    words = ["lx" if source == "lx" else source, target]
    if has_unit and random.random() < 0.3:
        words = [target]  # the unit of the numbers is the unit in the title
    words += ["--field", str(place + 1), "--header"]
    if style != "{1}" and random.random() < 0.5:
        words[-3:] = ["--column", random.choice([titles[place], word, word.upper()])]
    words += ["-d", mark] if mark else []
    words += ["--add", "new"] if adds else ["--rename", "new"] if names else []
    words += ["--decimal", ","] if comma else []
    words += ["--invalid", invalid]
    end = random.choice(["\n", "\n", "\r\n"])
    joint = mark or random.choice([" ", "  ", "\t"])
    own = mark or ("\t" if joint == "\t" and width > 1 else " ")  # before an added field
    cell = (lambda text: quoted(text, mark)) if mark else str
    start = random.choice(["", "", "\ufeff"])
    data = start + joint.join(map(cell, titles)) + end
    # the unchanged header, except its cell
    cells = data[len(start) : -len(end)].split(joint) if not mark else None
    head = next(csv.reader([data[len(start) : -len(end)]], delimiter=mark)) if mark else cells
    assert not mark or head == titles
    raw = [cell(title) for title in titles]
    data = start + joint.join(raw) + end
    if adds:
        out = start + joint.join(raw) + own + cell_of(after[-1], mark, False) + end
    else:
        was_quoted = raw[place].startswith('"')
        changed = after[place] != titles[place]
        raw[place] = cell_of(after[place], mark, was_quoted) if changed else raw[place]
        out = start + joint.join(raw) + end
    good, stopped = True, False
    for _ in range(random.choice([0, 1, 3, 8, 40])):
        kind = random.random()
        if kind < 0.03:
            line = random.choice(["", "# a comment", "  # 1,2,3,4,5", " \t"])
            data += line + end
            out += "" if stopped else line + end
            continue
        row = [random.choice(TEXTS) for _ in range(width)]
        if not mark:
            row = [re.sub(r"\s", "-", text) or "-" for text in row]
        number = f"{random.uniform(-1e4, 1e6):.{random.randint(0, 3)}f}"
        wrong = random.random() < 0.05
        row[place] = random.choice(BAD) if wrong else number.replace(".", "," if comma else ".")
        if not mark and not row[place]:
            row[place] = "?"
        if comma and wrong and random.random() < 0.5:
            row[place] = "1.5"
        if row[0].lstrip().startswith("#"):
            row[0] = "-"
        if kind > 0.95:  # a comma too many or too few
            wrong = True
            row = [*row, "000"] if width == 1 or random.random() < 0.5 else row[:-1]
        raw = [cell(text) for text in row]
        line = joint.join(raw)
        if not line.strip(" \t"):
            data += line + end
            out += "" if stopped else line + end
            continue
        data += line + end
        if stopped:
            continue
        if wrong:
            good = False
            stopped = invalid == "abort"
            passed = line + ((mark or own_joint(line) + "-") if adds else "")
            out += "" if stopped else passed + end
            continue
        answer = shown(Decimal(number) * factor, comma)
        if adds:
            out += line + (mark or own_joint(line)) + answer + end
        else:
            raw[place] = f'"{answer}"' if raw[place].startswith('"') else answer
            out += joint.join(raw) + end
    return Table(data.encode(), words, invalid, out.encode(), good)


def own_joint(line: str) -> str:
    """Return the separator of a field that is added to a line of fields between blanks."""
    return "\t" if "\t" in line else " "


def cell_of(title: str, mark: str, in_quotes: bool) -> str:
    """Write a title into a line: in the old quotes, or in new quotes if it needs them."""
    if in_quotes or (mark and mark in title):
        return '"' + title.replace('"', '""') + '"'
    return title


def hold(table: Table) -> int:
    """Run a table, and compare every byte; return the exit status."""
    out, err = (io.TextIOWrapper(io.BytesIO(), "utf-8") for _ in range(2))
    stdin = io.TextIOWrapper(io.BytesIO(table.data))
    with redirect_stdout(out), redirect_stderr(err), patch("sys.stdin", stdin):
        status = run(["convert", "-", *table.words])
    said = err.buffer.getvalue().decode()
    case = (table.data, table.words, said)
    assert out.buffer.getvalue() == table.wanted, (*case, table.wanted, out.buffer.getvalue())
    assert status == (0 if table.is_good else STATUS[table.invalid]), (*case, status)
    assert ("line " in said) == (not table.is_good and table.invalid != "ignore"), case
    return status


def sweep(count: int, seed: int) -> str:
    """Check every table; return the counts of exit statuses."""
    random.seed(seed)
    statuses = Counter(hold(draw()) for _ in range(count))
    return ", ".join(f"{count} with status {status}" for status, count in sorted(statuses.items()))


if __name__ == "__main__":
    from fuzz.command import main

    main(sweep, LONG)
