"""`radcalc quantities [SEARCH]`: what the quantities of light are called, in three languages."""

import click

from radcalc.answer import texts_of
from radcalc.cli.command import SEARCH, define
from radcalc.cli.options import Output, refuse_number_options
from radcalc.quantities.language import ENGLISH, LANGUAGES, language
from radcalc.quantities.search import search
from radcalc.render.formats import Records

LANG = click.Option(
    ["--lang"],
    type=click.Choice(LANGUAGES),
    help="The language of the names (default: the locale's, else English).",
)


@define("quantities", {"Names": (LANG,)}, words="[SEARCH]", operands=(SEARCH, ()), calculates=False)
def command(words: tuple[str, ...], lang: str | None, shown: Output) -> None:
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
    refuse_number_options(shown, "quantities")
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
    inputs = texts_of({"search": " ".join(words), "lang": lang or ""})
    shown.records(Records(rows, notes, table, inputs=inputs))
