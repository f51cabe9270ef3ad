"""`radcalc spectrum SOURCE`."""

import click

from radcalc import stdio
from radcalc.calculators.spectrum import spectrum as describe
from radcalc.cli import calculator, output
from radcalc.cli.sections import SectionedCommand
from radcalc.conversion.conditions import OPTIONS, give
from radcalc.errors import UsageError
from radcalc.spectra.sources import names, spectrum
from radcalc.units.ranges import read_spectra

FORMS = (
    "blackbody:T",
    "daylight:T",
    "line:WAVELENGTH[=WATTS],...",
    "gaussian:CENTRE,FWHM",
    "band:LOW:HIGH",
    "FILE",
    "-",
)


@click.command(
    "spectrum",
    cls=SectionedCommand,
    sections={
        "Source": ("column", "list_"),
        "Light": ("observer", "range", "photon_range"),
        "Results": calculator.RESULTS,
    },
    context_settings={"max_content_width": 100},
)
@click.argument("words", nargs=-1, metavar="SOURCE")
@click.option("--column", metavar="NAME", help="The column of a file's values, by name or number.")
@click.option("--list", "list_", is_flag=True, help="List the named sources.")
@click.option(
    "--observer",
    type=click.Choice(OPTIONS["observer"].choices),
    default="photopic",
    help="Whose eyes the luminous efficacy is for.",
)
@click.option("--range", metavar="LOW:HIGH", help="Where watts are counted.")
@click.option("--photon-range", metavar="LOW:HIGH", help="Where photons are counted.")
@calculator.results
@output.options
def command(
    words: tuple[str, ...],
    column: str | None,
    list_: bool,
    observer: str,
    range: str | None,
    photon_range: str | None,
    asked: calculator.Asked,
    shown: output.Output,
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
        if words or asked != calculator.Asked((), False, None, None):
            raise UsageError("--list lists the names, and nothing else", "radcalc spectrum --list")
        stdio.write("".join(f"{name}\n" for name in (*names(), *FORMS)))
        return stdio.ANSWERED
    if len(words) != 1:
        problem = "a source is missing" if not words else "one source a call"
        raise UsageError(problem, "radcalc spectrum D65, or radcalc spectrum --list")
    limits = give("range", range).value if range else None
    photon_limits = give("photon-range", photon_range).value if photon_range else None
    texts = read_spectra(words[0])
    sources = {text if len(texts) > 1 else "": spectrum(text, column or "") for text in texts}
    answers = [
        (case, describe(source, limits, photon_limits, observer))
        for case, source in sources.items()
    ]
    return calculator.finish(answers, asked, shown, command="spectrum")
