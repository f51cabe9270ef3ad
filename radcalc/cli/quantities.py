"""`radcalc quantities [SEARCH]`: names of the quantities of light, in three languages."""

from radcalc.answer import texts_of
from radcalc.calculators.pages import page_of
from radcalc.cli.command import define
from radcalc.cli.output import Output, refuse_number_options
from radcalc.quantities.language import ENGLISH, LANGUAGES, language
from radcalc.quantities.search import search
from radcalc.render.formats import Records


@define("quantities", page_of("quantities"))
def command(words: tuple[str, ...], lang: str | None, output: Output) -> None:
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

    Misused words (intensity, luminosity) lead to the correct term, with a note.
    """
    refuse_number_options(output, "quantities")
    first = lang or language()
    matches = search(" ".join(words))
    order = [first, *(code for code in LANGUAGES if code != first)]
    rows = [
        {
            "name": q.name(first),
            "symbol": q.symbol,
            "unit": q.unit,
            "definition": q.definition,
            **{code: q.names(code) for code in LANGUAGES},
            "note": note,
        }
        for q, note in matches
    ]
    table = [
        {
            "name": "\n".join(", ".join(q.names(code)) for code in order if q.names(code)),
            "symbol": q.symbol,
            "unit": q.unit,
            "definition": q.definition,
        }
        for q, _ in matches
    ]
    notes = [f"{q.name(ENGLISH)}: {note}" for q, note in matches if note]
    inputs = texts_of({"search": " ".join(words), "lang": lang or ""})
    output.records(Records(rows, notes, table, inputs=inputs))
