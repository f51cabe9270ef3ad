"""`radcalc mesopic --luminance L --sp-ratio S/P`."""

import click

from radcalc.calculators.mesopic import LUMINANCE, mesopic
from radcalc.cli import calculator, output
from radcalc.cli.sections import SectionedCommand
from radcalc.errors import ConditionError, UsageError, quote
from radcalc.quantities.light import describe
from radcalc.spectra.observers import OBSERVERS
from radcalc.spectra.sources import spectrum
from radcalc.spectra.spectrum import Spectrum
from radcalc.units.grammar import parse_number, split_quantity
from radcalc.units.ranges import read_series
from radcalc.units.table import resolve


@click.command(
    "mesopic",
    cls=SectionedCommand,
    sections={"Light": ("luminance", "sp_ratio", "spectrum_"), "Results": calculator.RESULTS},
    context_settings={"max_content_width": 100},
)
@click.option("--luminance", metavar="0.1cd/m2", help="The photopic luminance.")
@click.option("--sp-ratio", metavar="2", help="The light's ratio of scotopic to photopic.")
@click.option("--spectrum", "spectrum_", metavar="SOURCE", help="A spectrum, for its S/P ratio.")
@calculator.results
@output.options
def command(
    luminance: str | None,
    sp_ratio: str | None,
    spectrum_: str | None,
    asked: calculator.Asked,
    shown: output.Output,
) -> int:
    """Give the mesopic luminance of CIE 191:2010, between night and day.

    \b
    Examples:
      radcalc mesopic --luminance 0.1cd/m2 --sp-ratio 2
      radcalc mesopic --luminance 0.5cd/m2 --spectrum LED-B3
    """
    if luminance is None:
        raise UsageError("a luminance is missing", "--luminance 0.1cd/m2")
    if (sp_ratio is None) == (spectrum_ is None):
        problem = "is missing" if sp_ratio is None else "is given twice"
        raise UsageError(f"the S/P ratio {problem}", "--sp-ratio 2 or --spectrum LED-B3")
    said: list[str] = []
    noted: list[str] = []
    if spectrum_:
        source = spectrum(spectrum_)
        ratios = [_ratio_of(source)]
        said, noted = [f"the S/P ratio of {source.label}"], list(source.notes)
    else:
        ratios = [parse_number(text) for text in read_series(sp_ratio or "")]
    texts = read_series(luminance)
    if len(texts) > 1 and len(ratios) > 1:
        raise ConditionError("--luminance and --sp-ratio are both lists", "a list for one of them")
    answers = []
    for text in texts:
        for ratio in ratios:
            values, assumptions, notes, derivation = mesopic(_luminance(text), ratio)
            case = text if len(texts) > 1 else f"S/P {ratio:g}" if len(ratios) > 1 else ""
            answers.append((case, (values, said + assumptions, noted + notes, derivation)))
    return calculator.finish(answers, asked, shown, command="mesopic")


def _luminance(text: str) -> float:
    value, unit_text = split_quantity(text)
    if not unit_text:
        raise ConditionError(
            f"--luminance {quote(text)} has no unit", f"--luminance {quote(text)}cd/m2"
        )
    unit = resolve(unit_text)
    if unit.dimension != LUMINANCE:
        raise ConditionError(
            f"--luminance takes a luminance, not {describe(unit)}", "--luminance 0.1cd/m2"
        )
    return value * unit.factor


def _ratio_of(source: Spectrum) -> float:
    day, night = OBSERVERS["photopic"], OBSERVERS["scotopic"]
    seen = day.maximum * source.seen(day)
    if not seen > 0:
        raise ConditionError(f"nothing of {quote(source.label)} is seen by day", "another spectrum")
    return night.maximum * source.seen(night) / seen
