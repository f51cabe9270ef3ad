"""`radcalc convert VALUE UNIT [to] TARGET`, under conditions."""

from typing import TYPE_CHECKING, Any

import click

from radcalc.answer import Result, Row
from radcalc.cli import checking, output, streams
from radcalc.cli.sections import SectionedCommand
from radcalc.conversion.conditions import OPTIONS, Given, give
from radcalc.conversion.plan import answer, plan
from radcalc.errors import ConversionError, UsageError
from radcalc.stdio import ANSWERED
from radcalc.units.operands import read_operands
from radcalc.units.ranges import one_by_one, read_series, read_spectra
from radcalc.units.table import Unit, resolve

if TYPE_CHECKING:
    from click.shell_completion import CompletionItem

SECTIONS = {
    "Light": ("wavelength", "spectrum", "efficacy", "observer", "range", "photon_range"),
    "Directions": (
        "solid_angle",
        "half_angle",
        "apex_angle",
        "isotropic",
        "hemisphere",
        "exponent",
        "beam_angle",
    ),
    "Distance and surfaces": (
        "distance",
        "incidence",
        "area",
        "radius",
        "diameter",
        "reflectance",
        "pupil",
    ),
    "Time and bandwidth": ("time", "bandwidth"),
    "Homework": ("check", "tolerance"),
    "Streams (with - for VALUE)": tuple(streams.NAMES),
}


def complete_unit(
    ctx: click.Context, parameter: click.Parameter, incomplete: str
) -> "list[CompletionItem]":
    """Offer the units that begin with what has been typed."""
    from click.shell_completion import CompletionItem

    from radcalc.units.table import spellings

    return [CompletionItem(s) for s in spellings() if s.startswith(incomplete)][:200]


def _conditions(command: Any) -> Any:
    for option in reversed(OPTIONS.values()):
        if option.choices:
            kind: dict[str, Any] = {"type": click.Choice(option.choices, case_sensitive=False)}
        elif option.dimensions or option.is_text:
            kind = {"metavar": option.example}
        else:
            kind = {"is_flag": True}
        command = click.option(f"--{option.name}", help=option.help, **kind)(command)
    return command


class ConvertCommand(SectionedCommand):
    """A --header without a number is one line, and never takes the next word for the number."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Give it the number."""
        end = args.index("--") if "--" in args else len(args)
        options = ["--header=1" if word == "--header" else word for word in args[:end]]
        return super().parse_args(ctx, options + args[end:])


@click.command(
    "convert",
    cls=ConvertCommand,
    sections=SECTIONS,
    context_settings={"max_content_width": 100},
)
@click.argument("words", nargs=-1, metavar="VALUE UNIT [to] TARGET", shell_complete=complete_unit)
@_conditions
@streams.options
@click.option("--steps", is_flag=True, help="Show the derivation.")
@checking.OPTIONS[0]
@checking.OPTIONS[1]
@output.options
def command(
    words: tuple[str, ...],
    steps: bool,
    check: str | None,
    tolerance: str | None,
    shown: output.Output,
    **others: Any,
) -> int:
    """Convert between units, and between quantities under a condition.

    \b
    Examples:
      radcalc convert 100 lx fc
      radcalc convert 5 W m-2 to mW cm-2
      radcalc convert 5 mW lm --wavelength 632.8nm
      radcalc convert 800 lm lx --isotropic --distance 1m,2m,5m
      radcalc convert 500 lx cd/m2 --reflectance 0.8
      radcalc convert 250 cd/m2                    (every unit of luminance)
      cut -f3 log.tsv | radcalc convert - lx fc
      radcalc convert - lx fc -d , --column illuminance < log.csv
      printf '100 lx\\n3 fc\\n' | radcalc convert - klx

    Symbols of units are case-sensitive, full names are not.  Without TARGET every unit of the
    quantity is shown.  A condition's value carries its unit and is one word (2m, 30deg); one
    of them may be a list (1m,2m) or a range (1m:5m:1m), for an answer each.

    With - for VALUE, the lines of standard input are numbers, each of which is replaced; with -
    for VALUE and UNIT they carry their own units.  Every other byte stays as it is.
    """
    asked, conditions = streams.apart(others)
    typed = {
        name.replace("_", "-"): text
        for name, text in conditions.items()
        if text not in (None, False)
    }
    checking.refuse_idle(check, tolerance)
    if words[:1] == ("-",):
        streams.refuse_second_reader(typed)
    each = cases(typed)  # before the operands, so that `--distance 2 m` is told to write 2m
    if words[:1] == ("-",):
        if check is not None:
            raise UsageError("--check takes one answer, and a stream has several", "one value")
        return streams.convert(list(words), asked, each, steps, shown)
    streams.refuse(asked)
    value, source_text, target_text = read_operands(list(words))
    source = resolve(source_text)
    if not target_text:
        if steps:
            raise UsageError("--steps needs a unit to convert to", "a TARGET unit")
        if check is not None:
            raise UsageError("--check needs a unit to convert to", "a TARGET unit")
        shown.show([every_unit(value, source, typed, shown.number)])
        return ANSWERED
    target = resolve(target_text)
    if check is not None:
        if len(each) > 1:
            raise UsageError("--check takes one answer, and there are several", "one value a call")
        given = each[0][1]
        return checking.judge_conversion(
            value, source, target, given, check, tolerance, steps, shown
        )
    shown.show([answer(plan(source, target, given), value, case, steps) for case, given in each])
    return ANSWERED


def cases(typed: dict[str, Any]) -> list[tuple[str, list[Given]]]:
    """The conditions as given; several times where one of them is a list or a range."""
    given = {
        name: [give(name, part) for part in _parts(name, text)] for name, text in typed.items()
    }
    varied, each = one_by_one(given)
    return [
        (f"{varied} {case[varied].text}" if varied else "", list(case.values())) for case in each
    ]


def _parts(name: str, text: Any) -> list[Any]:
    """The values of one option: a list or a range cut up, anything else by itself."""
    if name == "spectrum":
        return list(read_spectra(text))
    if OPTIONS[name].dimensions:
        return list(read_series(text))
    return [text]


def every_unit(value: float, source: Unit, typed: dict[str, Any], number: bool) -> Result:
    """The value in every unit of its quantity."""
    if typed:
        raise UsageError(f"--{next(iter(typed))} needs a unit to convert to", "a TARGET unit")
    if number:
        raise UsageError("-n prints one number, and there is no target unit", "a TARGET unit")
    from radcalc.quantities.light import name_of, symbol_of
    from radcalc.quantities.units import units_of

    targets = [source, *(resolve(text) for text in units_of(source) if text != source.text)]
    if len(targets) == 1 and not name_of(source):
        raise UsageError(f"'{source.text}' measures no quantity radcalc knows", "a TARGET unit")
    rows = []
    for target in targets:
        try:
            converted = plan(source, target).apply(value)
        except ConversionError:
            continue  # beyond what a float holds in that unit
        rows.append(Row(name_of(target), symbol_of(target), converted, target.text))
    return Result(tuple(rows), notes=source.notes)
