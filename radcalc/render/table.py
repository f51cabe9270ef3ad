"""Tables for people, and a progress bar, drawn by Rich; only this module imports it.

Users' text is never read as markup, and nothing is cut off.  If a number, a unit or a word does not
fit, each row is a line instead of a row of a table.  The bar is shown on a terminal if the work
lasts longer than a second.
"""

import io
import time
from collections.abc import Callable, Container, Iterable, Iterator, Sequence
from contextlib import contextmanager
from itertools import groupby
from typing import Any, NamedTuple

from rich import box
from rich.cells import cell_len
from rich.console import Console
from rich.table import Table
from rich.text import Text

from radcalc import terminal
from radcalc.answer import FRACTION, Result, Row, shows, varying
from radcalc.quantities.language import translate
from radcalc.render import plain
from radcalc.render.formats import Judgement, Records, Style
from radcalc.render.plain import TABLE_DIGITS, derivation, number, uncertain
from radcalc.terminal import BOLD, FAINT, HANGING, RESET, can_show, fold, message, remarks
from radcalc.units import unit_behind

# Terminal columns between two columns of a table: an empty column with a blank on each side, or a
# single blank if words would be divided otherwise.
WIDE, NARROW = 3, 1
LONG = 12  # letters of a word that may be folded
LONGEST_FRACTION = 0.3  # seconds: longer exposure times are marked as decimals
FEW = 100  # rows that Rich draws: it takes a millisecond for each
CODES = {"bold": BOLD, "dim": FAINT, "": ""}
KEPT = "\xa0"  # a non-breaking blank
ASIDE = ("given: ", "    [")  # beginnings of faint lines: given values, references
REMARKS_ARE_APART = False


def results(results: Sequence[Result], style: Style) -> str:
    """Draw the rows that all results share, a table of the others, the remarks and the steps."""
    below = _remarks_and_steps(results, style)
    shared = _alike(results)
    above = _alike_lines(shared, style.precision, style.language)
    if shared:
        results = [result._replace(rows=_others(result.rows, shared)) for result in results]
    if table := _line_per_result(results, style):
        return draw(table._replace(above=above, below=[*table.below, *below]), style)
    rows = tuple(row for result in results for row in result.rows)
    if style.brief and len(rows) == 1:
        return _line(rows[0], style) + draw(Drawn([], [], [], below), style)
    table = _line_per_row(results, rows, style)
    return draw(table._replace(above=table.above or above, below=below), style)


def _remarks_and_steps(results: Sequence[Result], style: Style) -> list[str]:
    lines: list[str] = []
    if style.remarks:
        lines = remarks(
            dict.fromkeys(a for r in results for a in r.assumptions),
            dict.fromkeys(n for r in results for n in r.notes),
        )
    return lines + [line for result in results for line in derivation(result.steps)]


def _line_per_result(results: Sequence[Result], style: Style) -> "Drawn | None":
    """Return a table with a column for each quantity; None if results or width do not fit."""
    wide = _wide(results, style.precision, style.language)
    fitting = _widths(wide, wide[0], style.width) if wide else None
    if not wide or not fitting or fitting[1] != WIDE:
        return None
    head, *lines = wide
    rows = results[0].rows
    letters = [f"{_letter(row)}: {_quantity(row, style.language)}" for row in rows if row.symbol]
    legend = ", ".join(dict.fromkeys(letters))
    count = len(head) - len(rows)  # of inputs that no row has
    pairs = zip(head[count:], rows, strict=True)
    given = [*head[:count], *(title for title, row in pairs if row.given)]
    return Drawn(head, lines, below=[legend], right=head, faint=given)


def _line_per_row(results: Sequence[Result], rows: Sequence[Row], style: Style) -> "Drawn":
    """Return a table with a line for each row; a quantity shared by all is above it."""
    names, cases = _cases(results)
    header = [*names, "quantity", "symbol", "value", "unit"]
    lines = [
        [
            *case,
            _quantity(row, style.language),
            _letter(row),
            _number(row, style.precision),
            row.unit,
        ]
        for result, case in zip(results, cases, strict=True)
        for row in result.rows
    ]
    faint: set[str | int] = {*names, *(k for k, row in enumerate(rows) if row.given)}
    above: list[str] = []
    if len(rows) > 1 and len({(row.quantity, row.symbol, row.given) for row in rows}) == 1:
        quantity = _quantity(rows[0], style.language)
        above = [f"{quantity} ({_letter(rows[0])})" if rows[0].symbol else quantity]
        header, lines = _without(header, lines, ("quantity", "symbol"))
    return Drawn(header, lines, above, right=("value",), unfolded=names, faint=faint)


def records(records: Records, style: Style) -> str:
    """Return a table with its notes below.

    A column with the same text in all rows is shown above the table instead, except the first
    column, numbers and units.
    """
    notes = remarks((), dict.fromkeys(records.notes)) if style.remarks else []
    header = [name for name in records.table[0] if name != "note"]
    lines = [[row[name] for name in header] for row in records.table]
    alike = {
        name: texts[0]
        for name, texts in zip(header[1:], list(zip(*lines, strict=True))[1:], strict=True)
        if name not in (*records.right, "unit") and len({*texts}) == 1 < len(texts)
    }
    above = [f"{name}: {text}" for name, text in alike.items() if text]
    header, lines = _without(header, lines, alike)
    return draw(Drawn(header, lines, above, notes, records.right, records.unfolded), style)


def verdict(judgement: Judgement, style: Style) -> str:
    """Return the text of plain output, with the digits of a table, folded."""
    lines = plain.verdict(judgement, style, TABLE_DIGITS).splitlines()
    return _folded(lines, style)


def _line(row: Row, style: Style) -> str:
    name = _quantity(row, style.language)
    number = _number(row, style.precision)
    if style.color:
        number, name = f"{BOLD}{number}{RESET}", name and f"{FAINT}({name}){RESET}"
    elif name:
        name = f"({name})"
    return f"{number}{unit_behind(row.unit)}{f'   {name}' if name else ''}\n"


def _quantity(row: Row, language: str) -> str:
    return translate(row.quantity, language) + (" (given)" if row.given else "")


def _letter(row: Row) -> str:
    """Return the symbol of a row, in characters that standard output can encode."""
    if can_show(row.symbol):
        return row.symbol
    from radcalc.answer import in_ascii

    return in_ascii(row.symbol)


def _alike(results: Sequence[Result]) -> list[Row]:
    """Return the rows that several answers share, if they have others too."""
    if len(results) < 2 or not results[0].named:
        return []
    row_sets = [{row._replace(case="") for row in result.rows} for result in results]
    shared = set.intersection(*row_sets)
    if any(len(rows) == len(shared) for rows in row_sets):
        return []
    return [row for row in (row._replace(case="") for row in results[0].rows) if row in shared]


def _others(rows: Sequence[Row], alike: Sequence[Row]) -> tuple[Row, ...]:
    return tuple(row for row in rows if row._replace(case="") not in alike)


def _alike_lines(rows: Sequence[Row], precision: int | None, language: str) -> list[str]:
    """Return a line of the given rows, and a line of the others."""
    mark = f"{KEPT}· " if can_show("·") else ", "
    lines = []
    for word, is_given in (("given", True), ("in each", False)):
        texts = [
            f"{translate(row.quantity, language)} {_number(row, precision)}{unit_behind(row.unit)}"
            for row in rows
            if row.given == is_given
        ]
        if texts:
            kept = [text.replace(" ", KEPT) for text in texts]
            lines.append(f"{word}: {mark.join(kept)}")
    return lines


def _without(
    header: Sequence[str], lines: Sequence[Sequence[str]], names: Container[str]
) -> tuple[list[str], list[list[str]]]:
    kept = [place for place, name in enumerate(header) if name not in names]
    return [header[k] for k in kept], [[line[k] for k in kept] for line in lines]


def _cases(results: Sequence[Result]) -> tuple[list[str], list[list[str]]]:
    """Return the columns that identify the answers, and their texts."""
    labels = [next((row.case for row in result.rows), "") for result in results]
    names = varying([result.inputs for result in results])
    texts = [_texts(result, names) for result in results]
    if len({tuple(line) for line in texts}) < len(results):
        return (["for"], [[label] for label in labels]) if any(labels) else ([], [[]] * len(labels))
    return ["from" if name == "value" else name for name in names], texts


def _texts(result: Result, names: Sequence[str]) -> list[str]:
    typed = {item.name: item.text or f"{item.value:.12g} {item.unit}" for item in result.inputs}
    return [typed.get(name, "") for name in names]


def _wide(
    results: Sequence[Result], precision: int | None, language: str
) -> list[list[str]] | None:
    """Return answers with the same quantities, one per line, under their symbols and units."""
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
        [*_texts(result, names), *(_number(row, precision) for row in result.rows)]
        for result in results
    ]
    return [titles, *lines]


def _number(row: Row, precision: int | None) -> str:
    """Return the number of a row with its uncertainty; a short exposure time as 1/60."""
    is_fraction = row.form == FRACTION and row.unit == "s"
    if is_fraction and 0 < row.value < LONGEST_FRACTION and not row.uncertainty:
        return f"1/{number(1 / row.value, precision or TABLE_DIGITS)}"
    return uncertain(row.value, row.uncertainty, precision, TABLE_DIGITS)


class Drawn(NamedTuple):
    """A table, and the lines above and below it.

    `right` columns are right-aligned, and `unfolded` ones are not folded.  `faint` has columns by
    name, and rows by number.
    """

    header: Sequence[str]
    lines: Sequence[Sequence[str]]
    above: Sequence[str] = ()
    below: Sequence[str] = ()
    right: Sequence[str] = ()
    unfolded: Sequence[str] = ()
    faint: Container[str | int] = ()

    def style(self, row: int, name: str) -> str:
        """Return the style of a cell: results are bold, given values dim."""
        if name in self.faint or row in self.faint:
            return "dim"
        return "bold" if name in self.right else ""


def draw(drawn: Drawn, style: Style) -> str:
    """Draw a table and its lines, in the width of a style."""
    header, rows, width = drawn.header, drawn.lines, style.width
    out = io.StringIO()
    out.write(_folded(drawn.above, style))
    unfolded = [name for name in header if name in (*drawn.right, *drawn.unfolded, "unit")]
    if "unit" in header[:1]:  # the name of what the row is about
        unfolded.remove("unit")
    fitting = _widths([header, *rows], unfolded, width) if header else None
    if fitting:
        out.write(_by_rich(drawn, range(min(len(rows), FEW)), *fitting, style))
        lines = [(row, _at_once(drawn, row, *fitting, style)) for row in range(FEW, len(rows))]
        for is_folded, part in groupby(lines, lambda line: line[1] is None):
            if is_folded:
                out.write(_by_rich(drawn, [row for row, _ in part], *fitting, style, False))
            else:
                out.writelines(line or "" for _, line in part)
    else:
        out.write(
            "".join(f"{line}\n" for row in rows for line in _lines(header, row, unfolded, width))
        )
    out.write(_folded(drawn.below, style))
    return "\n".join(line.rstrip() for line in out.getvalue().split("\n"))


def _by_rich(
    drawn: Drawn,
    numbers: Sequence[int],
    widths: Sequence[int],
    gap: int,
    style: Style,
    has_header: bool = True,
) -> str:
    """Draw some rows of a table."""
    out = io.StringIO()
    console = Console(
        file=out,
        width=style.width,
        force_terminal=style.color,
        no_color=not style.color,
        color_system="standard" if style.color else None,
        highlight=False,
        markup=False,
        emoji=False,
        legacy_windows=False,
    )
    # Empty columns keep the others apart: before Rich 14 the padding of cells was also counted
    # at the edges, where there is none, and a table as wide as the terminal was squeezed.
    table = Table(box=_box(), padding=0, show_edge=False, header_style="", show_header=has_header)
    for name, columns in zip(drawn.header, widths, strict=True):
        if table.columns and gap == WIDE:
            table.add_column(width=WIDE - 2)
        table.add_column(
            Text(name, "bold"),
            width=columns,
            justify="right" if name in drawn.right else "left",
            overflow="fold",
        )
    for row in numbers:
        texts = [  # the text is styled, not the blanks that fill a cell
            Text.assemble((_parted(cell, columns), drawn.style(row, name)))
            for name, cell, columns in zip(drawn.header, drawn.lines[row], widths, strict=True)
        ]
        apart = [part for text in texts for part in (None, text)]
        table.add_row(*(apart[1:] if gap == WIDE else texts))
    console.print(table)
    return out.getvalue()


def _at_once(drawn: Drawn, row: int, widths: Sequence[int], gap: int, style: Style) -> str | None:
    """Return the line of a row as Rich draws it, but sooner; None if a cell has to be folded."""
    texts = []
    for name, cell, columns in zip(drawn.header, drawn.lines[row], widths, strict=True):
        spare = columns - cell_len(cell)
        if spare < 0 or not cell.isprintable() or cell != cell.strip():
            return None
        code = CODES[drawn.style(row, name)] if style.color and cell else ""
        text = f"{code}{cell}{RESET}" if code else cell
        texts.append(" " * spare + text if name in drawn.right else text + " " * spare)
    return f"{(' ' * gap).join(texts)}\n"


def _box() -> box.Box:
    """Return the rule below the titles, in characters that standard output can encode."""
    if can_show(str(box.SIMPLE_HEAD)):
        return box.SIMPLE_HEAD
    return box.Box(str(box.SIMPLE_HEAD).replace("─", "-"), ascii=True)


def _folded(lines: Iterable[str], style: Style) -> str:
    """Fold lines; colour the label of a remark or a verdict, and references."""
    text = ""
    for line in lines:
        folded = message(line, style.width, style.color)
        is_faint = style.color and line.startswith(ASIDE)
        text += f"{FAINT}{folded[:-1]}{RESET}\n" if is_faint else folded
    return text.replace(KEPT, " ")


def _widths(
    rows: Sequence[Sequence[str]], unfolded: Sequence[str], room: int
) -> tuple[list[int], int] | None:
    """Return the width of each column, and the gap between two; None if they do not fit.

    The first row has the titles.  An `unfolded` column is not folded, as a number or a unit on two
    lines would be another one.  The columns move closer before a word is divided, at its slashes
    first; long words with more than letters are divided only if nothing else helps.
    """
    columns = list(zip(*rows, strict=True))
    most = [max(cell_len(line) for text in cells for line in text.split("\n")) for cells in columns]
    for gap, is_parted, long in (
        (WIDE, False, room),
        (NARROW, False, room),
        (NARROW, True, room),
        (NARROW, True, LONG),
    ):
        widths = [
            size
            if cells[0] in unfolded
            else max(_least(word, long) for text in cells for word in _words(text, is_parted))
            for size, cells in zip(most, columns, strict=True)
        ]
        spare = room - sum(widths) - gap * (len(widths) - 1)
        if spare >= 0:
            break
    else:
        return None
    while spare and widths != most:  # to the column with the most folds
        folds = [size / max(given, 1) for size, given in zip(most, widths, strict=True)]
        widths[folds.index(max(folds))] += 1
        spare -= 1
    return widths, gap


def _lines(
    header: Sequence[str], cells: Sequence[str], unfolded: Sequence[str], width: int
) -> list[str]:
    """Return a row without a table, folded between words except in `unfolded` columns."""
    texts = [
        text.replace(" ", KEPT) if name in unfolded else text.replace("\n", ", ")
        for name, text in zip(header, cells, strict=True)
        if text
    ]
    return [line.replace(KEPT, " ") for line in fold("  ".join(texts), width, HANGING)]


def _words(text: str, is_parted: bool = False) -> list[str]:
    return (text.replace("/", "/ ") if is_parted else text).split() or [""]


def _parted(text: str, columns: int) -> str:
    """Return the text with line ends after the slashes of words wider than their column."""
    words = [
        word if cell_len(word) <= columns else word.replace("/", "/\n").removesuffix("\n")
        for word in text.split(" ")
    ]
    return " ".join(words)


def _least(word: str, long: int) -> int:
    """Return the columns that a word needs: its length, or less if it is long with symbols."""
    size = cell_len(word)
    return size if word[:1].isdigit() or word.isalpha() else min(size, long)


PATIENCE = 1.0  # [s] before anything is shown


@contextmanager
def progress(task: str, is_wanted: bool = True) -> Iterator[Callable[[int, int], object]]:
    """Yield a function that is called with the work done and the total.

    If standard error is not a terminal, nothing is drawn, and Rich is not loaded.  The bar is
    erased at the end.
    """
    if not (is_wanted and terminal.error_is_terminal()):
        yield lambda done, total: None
        return
    bar = _Bar(task)
    try:
        yield bar
    finally:
        bar.stop()


class _Bar:
    """A bar that appears after a delay."""

    def __init__(self, task: str) -> None:
        self.task, self.start = task, time.monotonic()
        self.drawn: Any = None
        self.row: Any = None

    def __call__(self, done: int, total: int) -> None:
        if self.drawn is None:
            if time.monotonic() - self.start < PATIENCE:
                return
            from rich.progress import Progress

            colors: Any = "auto" if terminal.wants_color(terminal.chosen_color(), True) else None
            console = Console(stderr=True, no_color=False, color_system=colors)
            self.drawn = Progress(console=console, transient=True)
            self.row = self.drawn.add_task(self.task)
            self.drawn.start()
        self.drawn.update(self.row, completed=done, total=total)

    def stop(self) -> None:
        if self.drawn is not None:
            self.drawn.stop()
