"""`radcalc spectrum SOURCE`."""

import click

from radcalc import stdio
from radcalc.answer import texts_of
from radcalc.calculators.spectrum import spectrum as describe
from radcalc.cli.calculator import Asked, run
from radcalc.cli.cases import Case, told
from radcalc.cli.command import define
from radcalc.cli.options import Output
from radcalc.errors import UsageError
from radcalc.given import Given, read
from radcalc.quantities.symbols import SPECTRUM, SYMBOLS
from radcalc.render.formats import PLAIN, Records
from radcalc.spectra.kinds import forms
from radcalc.spectra.sources import names, spectrum
from radcalc.units.ranges import read_spectra

COLUMN = click.Option(
    ["--column"], metavar="NAME", help="The column of a file's values, by name or number."
)
LIST = click.Option(["--list", "list_"], is_flag=True, help="List the named sources.")


@define(
    "spectrum",
    {"Source": (COLUMN, LIST), "Light": ("observer", "range", "photon-range")},
    words="SOURCE",
    operands=(SPECTRUM, ()),
)
def command(
    words: tuple[str, ...],
    column: str | None,
    list_: bool,
    typed: dict[str, str],
    asked: Asked,
    shown: Output,
) -> int:
    """Describe a spectrum: peak, width, efficacies, photons, colour.

    \b
    Examples:
      radcalc spectrum LED-B3
      radcalc spectrum blackbody:5772K -g luminance:cd/m2
      radcalc spectrum measured.csv --range 380nm:780nm
      radcalc spectrum blackbody:3000K:6000K:1000K -g temperature:K -g luminous-efficacy:lm/W
      radcalc spectrum --list

    SOURCE is a name, blackbody:T, daylight:T, line:WAVELENGTH, gaussian:CENTRE,FWHM,
    band:LOW:HIGH, a file, or - for standard input.
    """
    if list_:
        if words or typed or asked != Asked((), False, None, None):
            raise UsageError("--list lists the names, and nothing else", "radcalc spectrum --list")
        listed = [{"source": name} for name in (*names(), *forms(), "FILE", "-")]
        shown = shown._replace(format=PLAIN) if shown.is_bare else shown
        shown.records(Records(listed, (), listed))
        return stdio.ANSWERED
    if len(words) != 1:
        problem = "a source is missing" if not words else "one source a call"
        raise UsageError(problem, "radcalc spectrum D65, or radcalc spectrum --list")
    refined = {name: read(name, text) for name, text in typed.items()}
    texts = read_spectra(words[0])
    sources = [_source(one, column) for one in texts]
    each = [
        Case({"spectrum": one, **refined}, (told(one),) if len(texts) > 1 else ())
        for one in sources
    ]
    operands = texts_of({"column": column or ""})
    return run(each, describe, asked, shown, "spectrum", operands=operands)


def _source(text: str, column: str | None) -> Given:
    """A source, which has a column where it is a file."""
    if column:
        return Given(SYMBOLS["spectrum"], text, spectrum(text, column))
    return read("spectrum", text, uncertain=True)
