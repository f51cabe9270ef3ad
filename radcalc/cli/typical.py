"""`radcalc typical [SEARCH]`: values for orientation, with their sources."""

import click

from radcalc.cli import lists, output
from radcalc.cli.sections import SectionedCommand
from radcalc.quantities.language import translate
from radcalc.quantities.typical import search


@click.command(
    "typical",
    cls=SectionedCommand,
    context_settings={"max_content_width": 100},
)
@click.argument("words", nargs=-1, metavar="[SEARCH]")
@output.options
def command(words: tuple[str, ...], shown: output.Output) -> None:
    """List typical values: sun, sky, moon and lamps, with sources.

    \b
    Examples:
      radcalc typical                  all of them
      radcalc typical sun              by a word
      radcalc typical illuminance      by a quantity, in English, Czech or Russian
      radcalc typical cd/m2            by a unit

    Where a table of lecture notes is wrong, the corrected value is given, and a note says so.
    """
    lists.refuse_number_options(shown, "typical")
    found = search(" ".join(words))
    fields: tuple[str, ...] = ("what", "quantity", "value", "unit", "source", "note")
    if shown.format in (output.JSON, output.CSV):
        fields = (*fields, "low", "high")
    rows = [{field: getattr(value, field) for field in fields} for value in found]
    table = [{**row, "quantity": translate(row["quantity"], shown.language)} for row in rows]
    notes = [f"{v.what}, {v.value} {v.unit}: {v.note}" for v in found if v.note]
    lists.show(shown, rows, notes, table, right=("value",))
