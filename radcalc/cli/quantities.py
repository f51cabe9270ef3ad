"""`radcalc quantities [SEARCH]`: what the quantities of light are called, in three languages."""

import click

from radcalc.cli import lists, output
from radcalc.cli.sections import SectionedCommand
from radcalc.quantities.language import ENGLISH, LANGUAGES, language
from radcalc.quantities.search import search


@click.command(
    "quantities",
    cls=SectionedCommand,
    sections={"Names": ("lang",)},
    context_settings={"max_content_width": 100},
)
@click.argument("words", nargs=-1, metavar="[SEARCH]")
@click.option(
    "--lang",
    type=click.Choice(LANGUAGES),
    help="The language of the names (default: the locale's, else English).",
)
@output.options
def command(words: tuple[str, ...], lang: str | None, shown: output.Output) -> None:
    """List the quantities of light: names in English, Czech and Russian, symbols and units.

    \b
    Examples:
      radcalc quantities                   all of them
      radcalc quantities svítivost         by a name, with or without diacritics
      radcalc quantities Phi_v             by a symbol
      radcalc quantities W/m2/sr           by a unit
      radcalc quantities 'luminous flux [W]'
                                           a name with a unit: do they fit?
      radcalc quantities --lang ru         with Russian names first

    Words that stand for another quantity in some books (intensity, luminosity) are answered with
    the right term, and a note.
    """
    lists.refuse_number_options(shown, "quantities")
    first = lang or language()
    found = search(" ".join(words))
    order = [first, *(one for one in LANGUAGES if one != first)]
    rows = [
        {
            "name": q.name(first),
            "symbol": q.symbol,
            "unit": q.unit,
            "definition": q.definition,
            **{one: q.names(one) for one in LANGUAGES},
            "note": note,
        }
        for q, note in found
    ]
    table = [
        {
            "name": "\n".join(", ".join(q.names(one)) for one in order if q.names(one)),
            "symbol": q.symbol,
            "unit": q.unit,
            "definition": q.definition,
        }
        for q, _ in found
    ]
    notes = [f"{q.name(ENGLISH)}: {note}" for q, note in found if note]
    lists.show(shown, rows, notes, table)
