"""`radcalc photon WAVELENGTH|FREQUENCY|WAVENUMBER|ENERGY`."""

import click

from radcalc.calculators.photon import photon
from radcalc.cli import calculator, output
from radcalc.cli.sections import SectionedCommand
from radcalc.conversion.conditions import OPTIONS, Given, give, positive
from radcalc.errors import ConditionError, RadcalcError, UsageError
from radcalc.units.ranges import read_series


@click.command(
    "photon",
    cls=SectionedCommand,
    sections={"Light": ("observer",), "Results": calculator.RESULTS},
    context_settings={"max_content_width": 100},
)
@click.argument("words", nargs=-1, metavar="WAVELENGTH|FREQUENCY|WAVENUMBER|ENERGY")
@click.option(
    "--observer",
    type=click.Choice(OPTIONS["observer"].choices),
    help="Whose eyes the luminous efficiency is for.",
)
@calculator.results
@output.options
def command(
    words: tuple[str, ...],
    observer: str | None,
    asked: calculator.Asked,
    shown: output.Output,
) -> int:
    """Give the wavelength, frequency, wavenumber and energy of a photon, and what is seen of it.

    \b
    Examples:
      radcalc photon 555nm
      radcalc photon 2.33eV
      radcalc photon 540THz
      radcalc photon 18000cm-1
      radcalc photon 400nm:700nm:50nm -g wavelength:nm -g luminous-efficacy:lm/W

    The wavelength, frequency, wavenumber and energy are those in vacuum.  A length is looked up
    in the eye's tables as it is; the others are first turned into a wavelength in standard air.
    """
    if not words:
        raise UsageError("a wavelength is missing", "radcalc photon 555nm")
    seen_by = give("observer", observer) if observer else None
    texts = read_series(" ".join(words))
    each = [(text if len(texts) > 1 else "", {"wavelength": _read(text)}) for text in texts]
    return calculator.run(
        each, lambda given: photon(given["wavelength"], seen_by), asked, shown, command="photon"
    )


def _read(text: str) -> Given:
    """A wavelength, frequency, wavenumber or energy, which is no option here."""
    try:
        given = give("wavelength", text)
        positive(given)
    except RadcalcError as error:
        message = error.message.replace("--wavelength", "photon")
        hint = error.hint.replace("--wavelength", "radcalc photon")
        raise ConditionError(message, hint) from None
    return given
