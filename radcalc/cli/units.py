"""`radcalc units [SEARCH]`: which units there are, what they are worth, and says who."""

from radcalc.answer import texts_of
from radcalc.cli.command import SEARCH, define
from radcalc.cli.options import Output, refuse_number_options
from radcalc.errors import UnitError, nearest, quote
from radcalc.quantities.language import translate
from radcalc.quantities.units import Entry, entry, quantity_names, search
from radcalc.render.formats import Records


@define("units", {}, words="[SEARCH]", operands=(SEARCH, ()), calculates=False)
def command(
    words: tuple[str, ...],
    shown: Output,
) -> None:
    """List the units, with their definitions and sources.

    \b
    Examples:
      radcalc units                    all of them
      radcalc units luminance          the units of a quantity
      radcalc units lambert            the units with that in their name
      radcalc units cd/m2              what a unit measures, and its fellows
    """
    refuse_number_options(shown, "units")
    found = search(" ".join(words)) or _same_quantity(" ".join(words))
    rows = [e._asdict() for e in found]
    rows = [{"unit": row.pop("name"), **row} for row in rows]
    table = [{**row, "quantity": translate(row["quantity"], shown.style.language)} for row in rows]
    notes = [e.note for e in found if e.note]
    shown.records(Records(rows, notes, table, inputs=texts_of({"search": " ".join(words)})))


def _same_quantity(text: str) -> list[Entry]:
    """Read the search as a unit, and list the units of its quantity; raise where it is none."""
    from radcalc.quantities.light import describe
    from radcalc.quantities.units import named
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
