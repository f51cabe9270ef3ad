"""`radcalc units [SEARCH]`: the units, with their definitions and sources."""

from radcalc.answer import texts_of
from radcalc.calculators.pages import page_of
from radcalc.cli.command import define
from radcalc.cli.output import Output, refuse_number_options
from radcalc.quantities.entries import search
from radcalc.quantities.language import translate
from radcalc.render.formats import Records


@define("units", page_of("units"))
def command(words: tuple[str, ...], output: Output) -> None:
    """List the units, with their definitions and sources.

    \b
    Examples:
      radcalc units                    all of them
      radcalc units luminance          the units of a quantity
      radcalc units освещённость       the same, by its Russian name
      radcalc units lambert            the units with that in their name
      radcalc units cd/m2              what a unit measures, and the units like it
      radcalc units scales             dBm, mag, EV and others, with their formulas
      radcalc units constants          c, h, k_B and others, for arithmetic
    """
    refuse_number_options(output, "units")
    matches = search(" ".join(words))
    rows = [e._asdict() for e in matches]
    rows = [{"unit": row.pop("name"), **row} for row in rows]
    table = [{**row, "quantity": translate(row["quantity"], output.style.language)} for row in rows]
    notes = list(dict.fromkeys(e.note for e in matches if e.note))
    output.records(Records(rows, notes, table, inputs=texts_of({"search": " ".join(words)})))
