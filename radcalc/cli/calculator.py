"""What every calculator shares: its inputs, --get, --steps, and turning values into rows."""

import math
from collections.abc import Callable, Sequence
from typing import Any

import click

from radcalc import console
from radcalc.cli.output import PLAIN, TABLE, Output
from radcalc.conditions import Given, give, read
from radcalc.conversion import exact_ratio
from radcalc.errors import ConditionError, NumberError, UsageError, nearest, quote
from radcalc.laws import light
from radcalc.laws.inputs import INPUTS, Inputs
from radcalc.quantities import describe
from radcalc.render.plain import number
from radcalc.result import Answer, Result, Row, Step, Value
from radcalc.series import read_series, read_spectra
from radcalc.units.table import NUMBER, Unit, resolve

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


def cases(typed: dict[str, str | None]) -> list[Case]:
    """The inputs as given; several times where one of them is a list or a range."""
    given = {
        name: [_read(name, part) for part in _parts(name, text)]
        for name, text in ((name.replace("_", "-"), text) for name, text in typed.items())
        if text is not None
    }
    lists = [name for name, values in given.items() if len(values) > 1]
    if len(lists) > 1:
        raise ConditionError(
            f"--{lists[0]} and --{lists[1]} are both lists", "a list for one of them, and a loop"
        )
    return [
        (
            given[lists[0]][k].text if lists else "",
            {name: values[k if name in lists else 0] for name, values in given.items()},
        )
        for k in range(len(given[lists[0]]) if lists else 1)
    ]


def _parts(name: str, text: str) -> list[str]:
    """The values of a list or a range; a range of wavelengths, or a file's name, is one value."""
    if name == "spectrum":
        return read_spectra(text)
    return [text] if name in light.REFINEMENTS else read_series(text)


def _read(name: str, text: str) -> Given:
    """Read an input, a light quantity, or what links its kinds."""
    if name in light.LINKS or name in light.REFINEMENTS:
        return give(name, text)
    option = INPUTS[name] if name in INPUTS else light.option(name)
    try:
        return read(option, text)
    except NumberError as error:
        if "," in text and option.dimensions == (NUMBER,):
            raise NumberError(error.message, f"{error.hint}; a list as in 2.0,4.0") from None
        raise


def in_unit(value: Value, unit: Unit) -> float:
    """A value in one of the units it may be asked for."""
    amount = value.reach.get(unit.dimension)
    if unit.dimension in value.dimensions:
        amount = value.si
    if amount is None:
        raise UsageError(
            f"{value.name} is not measured in {describe(unit)}",
            ", ".join(f"{value.name}:{text}" for text in value.units),
        )
    if value.given is not None and unit.text == value.units[0]:
        return float(value.given)  # as typed: 30, where pi/6 would give 29.999999999999996
    si = Unit("SI", 1, 1, unit.dimension, ())
    return _held(value, float(amount * exact_ratio(si, unit)))


def _held(value: Value, number: float) -> float:
    """A result, unless it has left what a number can hold."""
    if not math.isfinite(number):
        raise NumberError(f"{value.name} cannot be held by a number", "less extreme values")
    return number + 0.0


def pick(values: Sequence[Value], wanted: str) -> float:
    """The number that NAME[:UNIT] asks for."""
    name, _, unit = wanted.partition(":")
    for value in values:
        if name.strip() in (value.name, value.also):
            return in_unit(value, resolve(unit)) if unit else _held(value, value.si)
    names = list(dict.fromkeys(value.name for value in values))
    near = nearest(name, names) or names
    raise UsageError(f"there is no result '{quote(name)}'", ", ".join(near))


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
        lines = [
            "\t".join(number(pick(values, name), output.precision) for name in wanted) + "\n"
            for _, (values, _, _, _) in answers
        ]
        console.write("".join(lines))
        output.remark([_result("", [], *answer[1:]) for _, answer in answers])
        return
    if output.number:
        raise UsageError("-n prints one number, and there are several results", "-g NAME:UNIT")
    output.show([_result(case, *answer) for case, answer in answers])


def _result(
    case: str,
    values: Sequence[Value],
    assumptions: Sequence[str],
    notes: Sequence[str],
    steps: Sequence[Step],
) -> Result:
    rows = [
        Row(v.label, v.symbol, in_unit(v, resolve(text)), text, case, v.name, v.given is not None)
        for v in values
        for text in v.units
    ]
    if case:  # of several answers each begins with what it is for
        rows.sort(key=lambda row: not row.given)
    return Result(tuple(rows), tuple(assumptions), tuple(notes), tuple(steps))
