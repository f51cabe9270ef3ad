"""Tables for people, drawn by Rich; the only module that imports it.

Users' text is never read as markup, and nothing is cut off: texts are folded between their words.
Where a number, a unit or a word does not fit, there is no table but a line for each row.
"""

import io
from collections.abc import Iterable, Sequence

from rich import box
from rich.cells import cell_len
from rich.console import Console
from rich.table import Table
from rich.text import Text

from radcalc.answer import FRACTION, Result, Row, shows, varying
from radcalc.quantities.language import translate
from radcalc.render import plain
from radcalc.render.formats import Judgement, Records, Style
from radcalc.render.plain import derivation, number, uncertain
from radcalc.stdio import HANGING, fold

DIGITS = 6
BLANK = 1  # columns of the terminal between two of a table, which have one at either side
GAP = BLANK + 2
LONG = 12  # letters of a word that may be folded
LONGEST_FRACTION = 0.3  # seconds: longer exposure times are marked as decimals
KEPT = "\xa0"  # a blank at which no line is folded
REMARKS_ARE_APART = False


def results(results: Sequence[Result], style: Style) -> str:
    """The rows of all results in one table, what was assumed below, then the steps.

    The quantities' names are in the language, as far as it has them.
    """
    precision, language, width, color = style.precision, style.language, style.width, style.color
    below = list(dict.fromkeys(f"assumed: {a}" for r in results for a in r.assumptions))
    below += list(dict.fromkeys(f"note: {n}" for r in results for n in r.notes))
    if not style.remarks:
        below = []
    below += [line for result in results for line in derivation(result.steps)]
    wide = _wide(results, precision, language)
    if wide and _widths(wide, wide[0], width):
        head, *lines = wide
        said = [
            f"{row.symbol}: {_quantity(row, language)}" for row in results[0].rows if row.symbol
        ]
        legend = ", ".join(dict.fromkeys(said))
        return draw(head, lines, [legend, *below], width, color, right=head)
    rows = [row for result in results for row in result.rows]
    if style.brief and len(rows) == 1:
        return _line(rows[0], precision, language) + draw([], [], below, width, color)
    names, cases = _cases(results)
    header = [*names, "quantity", "symbol", "value", "unit"]
    lines = [
        [
            *case,
            _quantity(row, language),
            row.symbol,
            _number(row, precision),
            row.unit,
        ]
        for result, case in zip(results, cases, strict=True)
        for row in result.rows
    ]
    return draw(header, lines, below, width, color, right=("value",), whole=names)


def records(records: Records, style: Style) -> str:
    """A table of a list's own columns, and its notes below."""
    notes = [f"note: {note}" for note in dict.fromkeys(records.notes)]
    header = [name for name in records.table[0] if name != "note"]
    lines = [[row[name] for name in header] for row in records.table]
    below = notes if style.remarks else []
    return draw(header, lines, below, style.width, style.color, records.right)


def verdict(judgement: Judgement, style: Style) -> str:
    """The words of plain text, with the digits of a table, folded."""
    lines = plain.verdict(judgement, style, DIGITS).splitlines()
    return "".join(f"{part}\n" for line in lines for part in fold(line, style.width, HANGING))


def _line(row: Row, precision: int | None, language: str) -> str:
    """A single value in one line, with the name of its quantity."""
    unit = "" if row.unit == "1" else f" {row.unit}"
    name = _quantity(row, language)
    return f"{_number(row, precision)}{unit}{f'   ({name})' if name else ''}\n"


def _quantity(row: Row, language: str) -> str:
    """The name of a row's quantity, and whether it was given."""
    return translate(row.quantity, language) + (" (given)" if row.given else "")


def _cases(results: Sequence[Result]) -> tuple[list[str], list[list[str]]]:
    """Columns of the inputs that vary, or else of what each answer is for; and its texts."""
    labels = [next((row.case for row in result.rows), "") for result in results]
    names = varying([result.inputs for result in results])
    texts = [_texts(result, names) for result in results]
    if len({tuple(line) for line in texts}) < len(results):
        return (["for"], [[label] for label in labels]) if any(labels) else ([], [[]] * len(labels))
    return ["from" if name == "value" else name for name in names], texts


def _texts(result: Result, names: Sequence[str]) -> list[str]:
    """Some of the inputs of an answer, as they were typed."""
    typed = {one.name: one.text or f"{one.value:.12g} {one.unit}" for one in result.inputs}
    return [typed.get(name, "") for name in names]


def _wide(
    results: Sequence[Result], precision: int | None, language: str
) -> list[list[str]] | None:
    """Several alike answers, a line each, under a line of their quantities and units."""
    heads = [[(row.name, row.unit) for row in result.rows] for result in results]
    if len(results) < 2 or not results[0].named or any(head != heads[0] for head in heads):
        return None
    names = [
        name
        for name in varying([result.inputs for result in results])
        if not any(shows(row, name) for row in results[0].rows)
    ]
    titles = [*names]
    for row in results[0].rows:
        unit = "" if row.unit == "1" else f" [{row.unit}]"
        titles.append(f"{row.symbol or translate(row.quantity, language)}{unit}")
    lines = [
        [*_texts(one, names), *(_number(row, precision) for row in one.rows)] for one in results
    ]
    return [titles, *lines]


def _number(row: Row, precision: int | None) -> str:
    """The number of a row, with its uncertainty; of a short exposure time 1/60."""
    is_fraction = row.form == FRACTION and row.unit == "s"
    if is_fraction and 0 < row.value < LONGEST_FRACTION and not row.uncertainty:
        return f"1/{number(1 / row.value, precision or DIGITS)}"
    return uncertain(row.value, row.uncertainty, precision, DIGITS)


def draw(
    header: Sequence[str],
    lines: Iterable[Sequence[str]],
    below: Iterable[str],
    width: int,
    color: bool,
    right: Sequence[str] = (),
    whole: Sequence[str] = (),
) -> str:
    """Draw a table and the lines below it, in a given width.

    The columns that are `right` stand there, and are `whole`: not folded.
    """
    out = io.StringIO()
    console = Console(
        file=out,
        width=width,
        force_terminal=color,
        no_color=not color,
        color_system="standard" if color else None,
        highlight=False,
        markup=False,
        emoji=False,
        legacy_windows=False,
    )
    rows = list(lines)
    whole = [name for name in header if name in (*right, *whole, "unit")]
    if "unit" in header[:1]:  # the name of what the row is about
        whole.remove("unit")
    widths = _widths([header, *rows], whole, width)
    if widths:
        # Columns of blanks keep the others apart: before Rich 14 the padding of cells was counted
        # at the edges as well, where there is none, and a table as wide as its room was squeezed.
        table = Table(box=box.SIMPLE_HEAD, padding=0, show_edge=False)
        for name, columns in zip(header, widths, strict=True):
            if table.columns:
                table.add_column(width=BLANK)
            table.add_column(
                Text(name),
                width=columns,
                justify="right" if name in right else "left",
                style="bold" if name in right else "",
                overflow="fold",
            )
        for cells in rows:
            apart = [part for cell in cells for part in (None, Text(cell))]
            table.add_row(*apart[1:])
        console.print(table)
    else:
        out.write(
            "".join(f"{line}\n" for row in rows for line in _lines(header, row, whole, width))
        )
    for line in below:
        console.print(
            Text("\n".join(fold(line, width)), style="dim"), overflow="ignore", crop=False
        )
    return "\n".join(line.rstrip() for line in out.getvalue().split("\n"))


def _widths(rows: Sequence[Sequence[str]], whole: Sequence[str], room: int) -> list[int] | None:
    """How wide each column is; None where they do not fit beside each other.

    The first row has the names.  A column that is `whole` is not folded, since a number or a
    unit over two lines is another one.  Long words are folded only where nothing else helps.
    """
    columns = list(zip(*rows, strict=True))
    most = [max(cell_len(line) for text in cells for line in text.split("\n")) for cells in columns]
    for long in (room, LONG):
        widths = [
            size
            if cells[0] in whole
            else max(_least(word, long) for text in cells for word in _words(text))
            for size, cells in zip(most, columns, strict=True)
        ]
        spare = room - sum(widths) - GAP * (len(widths) - 1)
        if spare >= 0:
            break
    else:
        return None
    while spare and widths != most:  # to the column that would be folded most
        folds = [size / max(given, 1) for size, given in zip(most, widths, strict=True)]
        widths[folds.index(max(folds))] += 1
        spare -= 1
    return widths


def _lines(
    header: Sequence[str], cells: Sequence[str], whole: Sequence[str], width: int
) -> list[str]:
    """A row without a table, folded between words, but not in the columns that are `whole`."""
    said = [
        text.replace(" ", KEPT) if name in whole else text.replace("\n", ", ")
        for name, text in zip(header, cells, strict=True)
        if text
    ]
    return [line.replace(KEPT, " ") for line in fold("  ".join(said), width, HANGING)]


def _words(text: str) -> list[str]:
    return text.split() or [""]


def _least(word: str, long: int) -> int:
    """The columns that a word needs: all of its own, but for a long one that is no number."""
    size = cell_len(word)
    return size if word[:1].isdigit() else min(size, long)
