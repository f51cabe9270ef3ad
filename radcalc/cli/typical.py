"""`radcalc typical [SEARCH]`: typical values, with their sources."""

from radcalc.answer import Result, texts_of
from radcalc.calculators.pages import page_of
from radcalc.cli.command import define
from radcalc.cli.output import Output, refuse_number_options
from radcalc.quantities.language import translate
from radcalc.quantities.typical import BOUNDS, FIELDS, how_far, search
from radcalc.render.formats import Records
from radcalc.terminal import CSV, JSON


@define("typical", page_of("typical"))
def command(words: tuple[str, ...], output: Output) -> None:
    """List typical values: sun, sky, rooms, lamps, screens, plants, with sources.

    \b
    Examples:
      radcalc typical                  all of them
      radcalc typical candle           by a word, in English, Czech or Russian
      radcalc typical illuminance      by a quantity
      radcalc typical cd/m2            by a unit
      radcalc typical 500lx            the nearest to a value

    Errors in published tables are corrected, with a note.
    """
    refuse_number_options(output, "typical")
    text = " ".join(words)
    matches = search(text)
    fields = (*FIELDS, *BOUNDS) if output.format in (JSON, CSV) else FIELDS
    rows = [{field: getattr(value, field) for field in fields} for value in matches]
    language = output.style.language
    translated = [
        {"what": v.name(language), "quantity": translate(v.quantity, language)} for v in matches
    ]
    table = [{**row, **names} for row, names in zip(rows, translated, strict=True)]
    notes = [f"{v.what}, {v.value} {v.unit}: {v.note}" for v in matches if v.note]
    inputs = texts_of({"search": text})
    output.records(Records(rows, notes, table, right=("value",), inputs=inputs))
    if output.format != JSON and (far := how_far(text, matches)):
        output.remark([Result((), notes=(far,))])
