"""`radcalc spectrum SOURCE ...`."""

from typing import Any

import click

from radcalc import stdio
from radcalc.answer import texts_of
from radcalc.calculators.spectrum import spectrum as describe
from radcalc.cli.calculator import Asked, run
from radcalc.cli.cases import Case, told
from radcalc.cli.command import define
from radcalc.cli.options import Output, refuse_number_options
from radcalc.errors import UsageError
from radcalc.given import Given, read
from radcalc.quantities.language import ENGLISH
from radcalc.quantities.symbols import SPECTRUM, SYMBOLS
from radcalc.render.formats import CSV, JSON, TABLE, Records
from radcalc.render.plain import number
from radcalc.spectra.kinds import FORMS
from radcalc.spectra.sources import read_spectra, spectrum

STDIN = "-"
FILES = {"FILE": "a measured spectrum", STDIN: "a measured spectrum, from standard input"}
TITLES = ("source", "kind", "T_cp [K]", "lux/PPFD [lm.s/umol]")  # of a list for people
FIELDS = ("source", "kind", "cct:K", "lux-per-ppfd:lm.s/umol")  # of one in CSV
KEYS = ("source", "kind", "cct", "lux_per_ppfd")  # of one in JSON, in the same units
DIGITS = 4
COLUMN = click.Option(
    ["--column"],
    metavar="NAME",
    help="The column of a file's values, by its title, with its unit or without, or its number.",
)
LIST = click.Option(
    ["--list", "list_"], is_flag=True, help="List the named sources, or those of a kind."
)


@define(
    "spectrum",
    {"Source": (COLUMN, LIST), "Light": ("observer", "range", "photon-range")},
    words="SOURCE ...",
    operands=(SPECTRUM, ()),
    takes_lines=False,
    draws=True,
)
def command(
    words: tuple[str, ...],
    column: str | None,
    list_: bool,
    typed: dict[str, str],
    asked: Asked,
    shown: Output,
) -> int:
    """Describe a spectrum: peak, width, efficacies, photons, colour; or compare several.

    \b
    Examples:
      radcalc spectrum LED-B3
      radcalc spectrum blackbody:5772K -g luminance:cd/m2
      radcalc spectrum AM1.5G -g irradiance:W/m2
      radcalc spectrum measured.csv --range 380nm:780nm
      radcalc spectrum D65 LED-B3 HPS -g cct -g cri -g lux-per-ppfd
      radcalc spectrum blackbody:3000K:6000K:1000K -g temperature:K -g luminous-efficacy:lm/W
      radcalc spectrum LED-B3 --plot           a picture, with V(lambda) over it
      radcalc spectrum D65 A LED-B3 --plot lamps.svg
      radcalc spectrum --list                  the named sources
      radcalc spectrum --list fluorescent      those of a kind

    SOURCE is a name, blackbody:T, daylight:T, line:WAVELENGTH, gaussian:CENTRE,FWHM,
    band:LOW:HIGH, a file, or - for standard input. Of several each has a row in a table, and a line
    of numbers elsewhere.

    A file has columns of text, or is what OceanView, SpectraSuite, Jaz, UPRtek, Sekonic or LI-COR
    write, CGATS (X-Rite), or IES TM-27 (.spdx).
    """
    if list_:
        if typed or column or asked != Asked((), False, None, None):
            raise UsageError("--list takes words to search for alone", "radcalc spectrum --list")
        _show_list(" ".join(words), shown)
        return stdio.ANSWERED
    if not words:
        hint = "radcalc spectrum D65, or radcalc spectrum --list"
        raise UsageError("a source is missing", hint)
    refined = {name: read(name, text) for name, text in typed.items()}
    texts = [text for word in words for text in read_spectra(word)]
    if texts.count(STDIN) > 1:
        raise UsageError("standard input is one source", "- once, and files")
    sources = [_source(one, column) for one in texts]
    each = [
        Case({"spectrum": one, **refined}, (told(one),) if len(texts) > 1 else ())
        for one in sources
    ]
    operands = texts_of({"column": column or ""})
    if len(words) > 1:  # what is compared has its names beside it, wherever there is a table
        shown = shown._replace(is_chosen=shown.is_chosen or shown.format == TABLE)
    return run(each, describe, asked, shown, "spectrum", operands=operands)


def _source(text: str, column: str | None) -> Given:
    """A source, which has a column where it is a file."""
    if column:
        return Given(SYMBOLS["spectrum"], text, spectrum(text, column))
    return read("spectrum", text, uncertain=True)


def _show_list(text: str, shown: Output) -> None:
    """Show the named sources that are searched for; without a text all, and the other forms."""
    from radcalc.spectra.listing import search, temperature_and_ratio

    refuse_number_options(shown, "spectrum --list")
    language = shown.style.language
    rows: list[dict[str, Any]] = []
    table: list[dict[str, str]] = []
    fields, none = (KEYS, None) if shown.format == JSON else (FIELDS, "")
    for one in search(text):
        cct, lux = temperature_and_ratio(one.name)
        cells = one.name, one.kind_in(language), f"{cct:.0f}" if cct else "", number(lux, DIGITS)
        table.append(dict(zip(TITLES, cells, strict=True)))
        if shown.format in (JSON, CSV):
            said: tuple[Any, ...] = one.name, one.kind_in(ENGLISH), cct or none, lux
        else:
            said = one.name, one.kind_in(ENGLISH), *cells[2:]
        rows.append(dict(zip(fields, said, strict=True)))
    if not text:
        others = {f"{kind}:{row[0]}": row[1] for kind, row in FORMS.items()} | FILES
        for form, what in others.items():
            rows.append(dict(zip(fields, (form, what, none, none), strict=True)))
            table.append(dict(zip(TITLES, (form, what, "", ""), strict=True)))
    shown.records(Records(rows, (), table, TITLES[2:], texts_of({"search": text})))
