"""`radcalc spectrum SOURCE ...`."""

from typing import Any

from radcalc import terminal
from radcalc.answer import texts_of
from radcalc.calculators.solved import Task
from radcalc.calculators.spectrum import PAGE
from radcalc.calculators.spectrum import spectrum as describe
from radcalc.cli.calculator import run
from radcalc.cli.command import define
from radcalc.cli.output import Output, refuse_number_options
from radcalc.cli.request import Case, Request, as_typed
from radcalc.errors import RadcalcError, UsageError, call, correct
from radcalc.inputs import Input
from radcalc.inputs.reading import read
from radcalc.quantities.language import ENGLISH
from radcalc.quantities.symbols import SYMBOLS
from radcalc.render.formats import Records
from radcalc.render.plain import number
from radcalc.spectra import FORMS
from radcalc.spectra.sources import read_spectra, spectrum
from radcalc.terminal import CSV, JSON, TABLE

STDIN = "-"
FILES = {"FILE": "a measured spectrum", STDIN: "a measured spectrum, from standard input"}
TITLES = ("source", "kind", "T_cp [K]", "lux/PPFD [lm.s/umol]")  # in a list for people
FIELDS = ("source", "kind", "cct:K", "lux-per-ppfd:lm.s/umol")  # in CSV
KEYS = ("source", "kind", "cct", "lux_per_ppfd")  # in JSON, in the same units
DIGITS = 4


@define("spectrum", PAGE)
def command(
    words: tuple[str, ...],
    column: str | None,
    unit: str | None,
    list_: bool,
    typed: dict[str, str],
    request: Request,
    output: Output,
) -> int:
    """Answer for each source, or list the named ones."""
    if list_:
        if typed or column or unit or request != Request((), False, None, None):
            problem = "--list takes no options, only words to search for"
            raise UsageError(problem, call("spectrum", list=""))
        _show_list(" ".join(words), output)
        return terminal.ANSWERED
    if not words:
        hint = [call("spectrum", "D65"), call("spectrum", list="")]
        raise UsageError("a source is missing", hint)
    refined = {name: read(name, text) for name, text in typed.items()}
    texts = [text for word in words for text in read_spectra(word)]
    if texts.count(STDIN) > 1:
        problem = "- cannot be used twice: there is one standard input"
        raise UsageError(problem, "- once, and files", [correct(STDIN)])
    sources = [_source(text, column or "", unit or "") for text in texts]
    all_cases = [
        Case({"spectrum": source, **refined}, (as_typed(source),) if len(texts) > 1 else ())
        for source in sources
    ]
    operands = texts_of({"column": column or "", "unit": unit or ""})
    if len(words) > 1:  # in a comparison each row has its source, in every table
        output = output._replace(is_chosen=output.is_chosen or output.format == TABLE)
    task = Task("spectrum", request.narrowed(describe, PAGE), operands)
    return run(all_cases, task, request, output)


def _source(text: str, column: str, unit: str) -> Input:
    if column or unit:
        return Input(SYMBOLS["spectrum"], text, spectrum(text, column, unit))
    return read("spectrum", text, uncertain=True)


def _show_list(text: str, output: Output) -> None:
    """Show the named sources that match; without a text all, and the other forms."""
    from radcalc.spectra.listing import search, temperature_and_ratio

    refuse_number_options(output, "spectrum --list")
    language = output.style.language
    rows: list[dict[str, Any]] = []
    table: list[dict[str, str]] = []
    fields, none = (KEYS, None) if output.format == JSON else (FIELDS, "")
    notes: list[str] = []
    for source in search(text):
        cct: float | None = None
        lux: Any = none
        try:
            cct, lux = temperature_and_ratio(source.name)
        except RadcalcError as error:  # a file of the user's definitions
            notes.append(error.message)
        cells = (
            source.name,
            source.kind_in(language),
            f"{cct:.0f}" if cct else "",
            number(lux, DIGITS) if isinstance(lux, float) else "",
        )
        table.append(dict(zip(TITLES, cells, strict=True)))
        if output.format in (JSON, CSV):
            cells_of_row: tuple[Any, ...] = source.name, source.kind_in(ENGLISH), cct or none, lux
        else:
            cells_of_row = source.name, source.kind_in(ENGLISH), *cells[2:]
        rows.append(dict(zip(fields, cells_of_row, strict=True)))
    if not text:
        other_forms = {f"{kind}:{row[0]}": row[1] for kind, row in FORMS.items()} | FILES
        for form, what in other_forms.items():
            rows.append(dict(zip(fields, (form, what, none, none), strict=True)))
            table.append(dict(zip(TITLES, (form, what, "", ""), strict=True)))
    records = Records(rows, notes, table, TITLES[2:], texts_of({"search": text}))
    output.records(records, (JSON,), answers=True)
