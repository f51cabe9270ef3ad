"""What the commands that look things up share: a list of rows in each format."""

from collections.abc import Sequence
from typing import Any

from radcalc import stdio
from radcalc.cli import output
from radcalc.errors import UsageError


def refuse_number_options(shown: output.Output, command: str) -> None:
    """Refuse -n and --precision, which have no use with a list."""
    if shown.number or shown.precision:
        useless = "-n" if shown.number else "--precision"
        raise UsageError(f"{useless} has no use with {command}", f"radcalc {command} alone")


def show(
    shown: output.Output,
    rows: Sequence[dict[str, Any]],
    notes: Sequence[str],
    table: Sequence[dict[str, str]],
    right: Sequence[str] = (),
) -> None:
    """Write rows of named fields; a table has its own, and the notes below it, not beside.

    A field may be a list of texts, which JSON keeps; elsewhere they are parted by commas.
    """
    if shown.format == output.JSON:
        import json

        stdio.write(json.dumps(list(rows), ensure_ascii=False, allow_nan=False) + "\n")
        return
    if shown.format == output.TABLE:
        from radcalc.render.table import draw

        below = [] if shown.quiet else [f"note: {note}" for note in dict.fromkeys(notes)]
        header = [name for name in table[0] if name != "note"]
        lines = [[row[name] for name in header] for row in table]
        stdio.write(draw(header, lines, below, output.width(), shown.color, right))
        return
    texts = [[", ".join(v) if isinstance(v, list) else str(v) for v in r.values()] for r in rows]
    if shown.format == output.CSV:
        import csv
        import io

        text = io.StringIO()
        csv.writer(text, lineterminator="\n").writerows([list(rows[0]), *texts])
        stdio.write(text.getvalue())
    else:
        stdio.write("".join("\t".join(row) + "\n" for row in texts))
