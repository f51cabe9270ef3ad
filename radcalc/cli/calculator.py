"""What every calculator shares: its inputs, --get, --steps, and turning values into rows."""

from collections.abc import Callable, Sequence
from typing import Any

import click

from radcalc import console
from radcalc.asked import pick, rows
from radcalc.cli.output import PLAIN, TABLE, Output
from radcalc.conditions import OPTIONS
from radcalc.errors import ConditionError, UsageError
from radcalc.laws import light
from radcalc.laws.inputs import INPUTS, Inputs
from radcalc.maths import is_array, is_column
from radcalc.render.plain import DIGITS, number
from radcalc.result import Answer, Result, Step, Value
from radcalc.series import MOST, read_array, read_series, read_spectra

get_option = click.option(
    "-g",
    "--get",
    "wanted",
    multiple=True,
    metavar="NAME[:UNIT]",
    help="The bare number of that result (repeatable; coherent SI without a unit).",
)
steps_option = click.option("--steps", is_flag=True, help="Show the derivation.")

Case = tuple[str, Inputs]
VECTORS = {*INPUTS, *light.INPUTS, *light.SPECIFIC}  # what may be a range of any length
LINES = 1000  # formatted at a time


def inputs(*names: str, **helps: str) -> Callable[..., Any]:
    """Add inputs as options; `helps` has other texts for some of them."""

    def add(command: Callable[..., Any]) -> Callable[..., Any]:
        for name in reversed(names):
            option = INPUTS[name]
            text = helps.get(name.replace("-", "_"), option.help)
            command = click.option(f"--{name}", metavar=option.example, help=text)(command)
        return command

    return add


def quantities(*names: str) -> Callable[..., Any]:
    """Add light quantities as options, by their generic names and by those of one kind."""

    def add(command: Callable[..., Any]) -> Callable[..., Any]:
        for name in reversed(names):
            others = light.names_of(name)
            text = f"{light.INPUTS[name]} (also --{', --'.join(others)})."
            for other in reversed(others):
                what = f"{light.INPUTS[name]}, as {other.replace('-', ' ')}."
                command = click.option(
                    f"--{other}", metavar=light.option(other).example, help=what, hidden=True
                )(command)
            example = light.option(name).example
            command = click.option(f"--{name}", metavar=example, help=text)(command)
        return command

    return add


def light_options(command: Callable[..., Any]) -> Callable[..., Any]:
    """Add the options that link the kinds of light."""
    for name in reversed((*light.LINKS, *light.REFINEMENTS)):
        option = OPTIONS[name]
        kind: dict[str, Any] = {"metavar": option.example}
        if option.choices:
            kind = {"type": click.Choice(option.choices, case_sensitive=False)}
        command = click.option(f"--{name}", help=option.help, **kind)(command)
    return command


def cases(typed: dict[str, str | None], arrays: bool = False) -> list[Case]:
    """The inputs as given; several times where one of them is a list or a range.

    With `arrays` a long range is one case, whose values are arrays.
    """
    given = {
        name: [light.read_any(name, part) for part in _parts(name, text, arrays)]
        for name, text in ((name.replace("_", "-"), text) for name, text in typed.items())
        if text is not None
    }
    lists = [n for n, values in given.items() if len(values) > 1 or is_array(values[0].value)]
    if len(lists) > 1:
        raise ConditionError(
            f"--{lists[0]} and --{lists[1]} are both lists", "a list for one of them, and a loop"
        )
    count = len(given[lists[0]]) if lists else 1
    return [
        (
            given[lists[0]][k].text if count > 1 else "",
            {name: values[k if name in lists else 0] for name, values in given.items()},
        )
        for k in range(count)
    ]


def _parts(name: str, text: str, arrays: bool) -> Sequence[Any]:
    """The values of a list or a range; a range of wavelengths, or a file's name, is one value."""
    if arrays and name in VECTORS and (values := read_array(text)):
        return [values]
    if name == "spectrum":
        return read_spectra(text)
    return [text] if name in light.REFINEMENTS else read_series(text)


def show(
    answers: Sequence[tuple[str, Answer]],
    wanted: Sequence[str],
    output: Output,
    steps: bool = True,
) -> None:
    """Write the answers, or the numbers that were asked for; each answer with its case."""
    if not steps:
        answers = [(case, (*answer[:3], [])) for case, answer in answers]
    if wanted:
        if output.format not in (PLAIN, TABLE):
            raise UsageError(
                f"--get prints bare numbers, and contradicts --format {output.format}",
                "one of them",
            )
        for _, (values, _, _, _) in answers:
            columns = [pick(values, name) for name in wanted]
            console.write(_lines(columns, output.precision))
        output.remark([_result("", [], *answer[1:]) for _, answer in answers])
        return
    if output.number:
        raise UsageError("-n prints one number, and there are several results", "-g NAME:UNIT")
    output.show([_result(case, *answer) for case, answer in _spread(answers)])


def _lines(columns: Sequence[Any], precision: int | None) -> str:
    """Numbers in tab-separated columns; of arrays a line for each element."""
    arrays = [column for column in columns if is_array(column)]
    if not arrays:
        return "\t".join(number(column, precision) for column in columns) + "\n"
    count = len(arrays[0])
    form = "\t".join([f"%.{precision or DIGITS}g"] * len(columns)) + "\n"
    lists = [c.tolist() if is_array(c) else [c] * count for c in columns]
    flat = lists[0] if len(lists) == 1 else [x for line in zip(*lists, strict=True) for x in line]
    width = len(columns) * LINES
    parts = (flat[k : k + width] for k in range(0, len(flat), width))
    return "".join([form * (len(part) // len(columns)) % tuple(part) for part in parts])


def _spread(answers: Sequence[tuple[str, Answer]]) -> list[tuple[str, Answer]]:
    """The answers, those of a long range one by one."""
    found: list[tuple[str, Answer]] = []
    for case, (values, assumptions, notes, steps) in answers:
        shown = [value for value in values if value.units]
        long = [value for value in shown if is_array(value.si)]
        if not long:
            found.append((case, (values, assumptions, notes, steps)))
            continue
        count = max(len(value.si) for value in long)
        if count > MOST:
            raise UsageError(f"a table of {count} answers is too long", "-g NAME:UNIT, for columns")
        given = next(value for value in long if value.given is not None)
        for k in range(count):
            name = f"{given.given[k]:.15g}{given.units[0]}"
            one = [_element(value, k) for value in shown]
            found.append((name, (one, assumptions, notes, steps if k == 0 else [])))
    return found


def _element(value: Value, k: int) -> Value:
    """One element of a value that is an array."""

    def of(x: Any) -> Any:
        return float(x[k]) if is_column(x) else x

    return Value(
        value.name,
        value.label,
        value.symbol,
        of(value.si),
        value.dimensions,
        value.units,
        {dimension: of(amount) for dimension, amount in value.reach.items()},
        of(value.given),
        value.also,
    )


def _result(
    case: str,
    values: Sequence[Value],
    assumptions: Sequence[str],
    notes: Sequence[str],
    steps: Sequence[Step],
) -> Result:
    return Result(tuple(rows(values, case)), tuple(assumptions), tuple(notes), tuple(steps))
