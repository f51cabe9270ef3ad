"""`radcalc units [SEARCH]`: which units there are, what they are worth, and says who."""

import click

from radcalc import console
from radcalc.cli import output
from radcalc.cli.sections import SectionedCommand
from radcalc.errors import UnitError, UsageError, nearest, quote
from radcalc.listing import Entry, entry, quantity_names, search


@click.command("units", cls=SectionedCommand, context_settings={"max_content_width": 100})
@click.argument("words", nargs=-1, metavar="[SEARCH]")
@output.options
def command(
    words: tuple[str, ...],
    shown: output.Output,
) -> None:
    """List the units, with their definitions and sources.

    \b
    Examples:
      radcalc units                    all of them
      radcalc units luminance          the units of a quantity
      radcalc units lambert            the units with that in their name
      radcalc units cd/m2              what a unit measures, and its fellows
    """
    if shown.number or shown.precision:
        useless = "-n" if shown.number else "--precision"
        raise UsageError(f"{useless} has no use with units", "radcalc units alone")
    found = search(" ".join(words)) or _same_quantity(" ".join(words))
    header = ("unit", "symbols", "quantity", "definition", "source", "note")
    rows = [tuple(e) for e in found]
    if shown.format == output.JSON:
        import json

        console.write(
            json.dumps([dict(zip(header, row, strict=True)) for row in rows], ensure_ascii=False)
            + "\n"
        )
    elif shown.format == output.CSV:
        import csv
        import io

        text = io.StringIO()
        csv.writer(text, lineterminator="\n").writerows([header, *rows])
        console.write(text.getvalue())
    elif shown.format == output.TABLE:
        from radcalc.render.table import draw

        notes = [f"note: {e.note}" for e in found if e.note and not shown.quiet]
        console.write(
            draw(header[:5], [row[:5] for row in rows], notes, output.width(), shown.color)
        )
    else:
        console.write("".join("\t".join(row) + "\n" for row in rows))


def _same_quantity(text: str) -> list[Entry]:
    """Read the search as a unit, and list the units of its quantity; raise where it is none."""
    from radcalc.listing import named
    from radcalc.quantities import describe
    from radcalc.units.table import resolve

    try:
        unit = resolve(text)
    except UnitError as error:
        near = nearest(text.lower(), quantity_names())
        raise UnitError(
            f"no unit and no quantity is called '{quote(text)}'", ", ".join(near) or error.hint
        ) from None
    found = [entry(name) for name in named(unit.dimension)]
    if not found:
        raise UnitError(f"{describe(unit)} has no unit with a name of its own", "radcalc units")
    return found
