"""`radcalc convert VALUE UNIT [to] TARGET`, with conditions."""

from typing import Any

from radcalc import errors, terminal
from radcalc.calculators.convert import PAGE
from radcalc.cli import request
from radcalc.cli.command import define
from radcalc.cli.conversions import conversions, likely_efficacy, refuse_file, show, with_target
from radcalc.cli.output import Output
from radcalc.cli.request import cases, is_stream
from radcalc.units.grammar import TO

HELP = """\
\b
Examples:
  radcalc 100 lx fc
  radcalc convert 100 lx in fc
  radcalc convert '500 lx * 20 m2 / 0.48' klm
  radcalc convert 5 W m-2 to mW cm-2
  radcalc convert 5 mW lm --wavelength 632.8nm
  radcalc convert 800 lm lx --isotropic --distance 1m,2m,5m
  radcalc convert 500 lx cd/m2 --reflectance 0.8
  radcalc convert 1000 W/m2 W --area 2m2 --incidence 60deg
  radcalc convert 1 W/sr W --area 20mm2 --distance 1m
  radcalc convert 100 W/m2 ppfd --spectrum D65
  radcalc convert 532 nm eV                    (a photon; also THz, cm-1, kJ/mol)
  radcalc convert 5778 K MW/m2                 (a black body; also um, W/m2/sr)
  radcalc 100,200,500 lx fc,klx                (lists; or a range: 1:5:1 m ft)
  radcalc convert 250 cd/m2                    (every unit of luminance)
  radcalc convert 10 dBm mW                    (also mag, EV, mired, OD, stops ...)
  cut -f3 log.tsv | radcalc convert - lx fc
  radcalc convert - lx fc -d , --column E < log.csv
  radcalc convert - lx ppfd --spectrum sun -d , --column E --add PPFD < log.csv
  printf '100 lx\\n3 fc\\n' | radcalc convert - klx
  echo 500 lux | radcalc to fc                 (read as convert - fc)
  radcalc footcandle lx                        (read as 1 footcandle lx)

Unit symbols are case-sensitive, full names are not.  TARGET may also be the
name of a quantity in English, Czech or Russian, which stands for its usual unit.  Without
TARGET, the value is shown in every unit of its quantity.  Write the value of a condition, such
as --distance, as one word with its unit (2m, 30deg).
VALUE and conditions may be lists (1m,2m) or ranges (1m:5m:1m), and TARGET a list; with
several lists, the last one varies fastest.  A condition that no answer needs is an error.
Values and conditions may have a standard uncertainty: 100+-3 lx, '100(3) lx', 2.00+-0.03m.

With - as VALUE, each line of standard input is a number, and the result replaces it.
With - instead of VALUE UNIT, the unit is in each line or in the title of the column (E [lx]).
A unit in the title must equal UNIT, if UNIT is given; the unit of the result replaces it.  All
other bytes are unchanged.  With a pipe, - may be left out: to fc, or convert lx fc.  --from UNIT
and --to TARGET may stand for the operands.
"""


@define("convert", PAGE, text=HELP)
def command(
    words: tuple[str, ...],
    typed: dict[str, Any],
    steps: bool,
    check: str | None,
    tolerance: str | None,
    output: Output,
    **stream_options: Any,
) -> int:
    """Answer a conversion, or the lines of standard input."""
    request.refuse_idle(check, tolerance)
    options = request.LineOptions(**stream_options)
    if words and is_stream(words[0]):  # '- lx', as an option has it
        words = (*words[0].split(None, 1), *words[1:])
    if words and words[0] in TO:
        problem = f"a value is missing before '{words[0]}', and no pipe has values"
        raise errors.UsageError(
            problem, errors.call("convert", "-", *words[1:], remark="for values from a pipe")
        )
    if words[:1] == ("-",):
        request.refuse_second_reader(typed)
    try:
        # before the operands, so that the hint for `--distance 2 m` is 2m
        all_cases = cases(typed, arrays=False, bare=PAGE.bare)
    except errors.MissingUnit as error:
        if error.symbol == "efficacy":
            raise error.reworded(hint=likely_efficacy(error, list(words))) from None
        raise
    request.refuse_condition(all_cases[0])
    if words[:1] == ("-",):
        from radcalc.cli import streams

        request.refuse_stream(check)
        return streams.convert(list(words), options, all_cases, steps, output)
    request.refuse_lines(options, errors.correct(words[0], "-") if words else "a - as VALUE")
    try:
        calls = conversions(list(words), all_cases)
    except errors.NumberError:
        refuse_file(words)
        raise
    first = calls[0]
    if not first.targets:
        for name, given in (("--steps", steps), ("--check", check), ("--auto", output.style.auto)):
            if given:
                problem = f"{name} needs a unit to convert to"
                raise errors.UsageError(problem, with_target(words, first))
    elif check is not None:
        from radcalc.homework.question import of_conversion

        if len(calls) * len(first.targets) > 1:
            ends = [first.targets[0].text] if len(first.targets) > 1 else []
            lists = [(words[0], words[0].split(",")[0]), *((words[-1], end) for end in ends)]
            raise request.several(first.case.varied, lists)
        target, conditions = first.targets[0], first.conditions
        amount, value = first.amount, float(first.value)
        question = of_conversion(value, first.source, target, conditions, steps, amount)
        return request.judge(question, check, tolerance, output, first.inputs)
    show(calls, typed, steps, output)
    return terminal.ANSWERED
