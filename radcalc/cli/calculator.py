"""What every calculator shares: its inputs, --get, --steps, and turning values into rows."""

from collections.abc import Callable, Sequence
from functools import wraps
from typing import Any, NamedTuple

import click

from radcalc import stdio
from radcalc.answer import Answer, Result, Step, Value
from radcalc.calculators import light
from radcalc.calculators.inputs import INPUTS, Inputs
from radcalc.calculators.results import pick, rows
from radcalc.cli import checking
from radcalc.cli.output import PLAIN, TABLE, Output
from radcalc.conversion.conditions import OPTIONS
from radcalc.errors import UsageError, nearest, quote
from radcalc.maths import is_array, is_column
from radcalc.quantities.light import LUMINOUS
from radcalc.render.plain import DIGITS, number
from radcalc.units.ranges import MOST, one_by_one, read_array, read_series, read_spectra

get_option = click.option(
    "-g",
    "--get",
    "wanted",
    multiple=True,
    metavar="NAME[:UNIT]",
    help="The bare number of that result (repeatable; coherent SI without a unit).",
)
steps_option = click.option("--steps", is_flag=True, help="Show the derivation.")


class Asked(NamedTuple):
    """What is asked of the answer: some results, the derivation, whether a number is right."""

    wanted: tuple[str, ...]
    steps: bool
    check: str | None
    tolerance: str | None

    def wants(self, name: str) -> bool:
        """Whether a result is asked for by its name."""
        named = [*self.wanted, (self.check or "").replace("=", ":")]
        return any(one.partition(":")[0].strip() == name for one in named)

    def refuse_idle(self) -> None:
        """Refuse what has no use with --check, or without."""
        checking.refuse_idle(self.check, self.tolerance)
        if self.check is not None and self.wanted:
            raise UsageError("--check and --get contradict each other", "--check NAME=VALUE")


def results(function: Callable[..., Any]) -> Callable[..., Any]:
    """Add the options that ask for results; the command is called with `asked`."""

    @wraps(function)
    def asking(
        *args: Any,
        wanted: tuple[str, ...],
        steps: bool,
        check: str | None,
        tolerance: str | None,
        **others: Any,
    ) -> Any:
        asked = Asked(wanted, steps, check, tolerance)
        asked.refuse_idle()
        return function(*args, asked=asked, **others)

    for option in reversed((get_option, steps_option, *checking.OPTIONS)):
        asking = option(asking)
    return asking


RESULTS = ("wanted", "check", "tolerance")  # their section of a command's help
Case = tuple[str, Inputs]
VECTORS = {*INPUTS, *light.INPUTS, *light.SPECIFIC}  # what may be a range of any length
LINES = 1000  # formatted at a time


def inputs(*names: str, **helps: str | tuple[str, str]) -> Callable[..., Any]:
    """Add inputs as options; `helps` has other texts for some of them, or an example and a text."""

    def add(command: Callable[..., Any]) -> Callable[..., Any]:
        for name in reversed(names):
            option = INPUTS[name]
            said = helps.get(name.replace("-", "_"), option.help)
            example, text = (option.example, said) if isinstance(said, str) else said
            command = click.option(f"--{name}", metavar=example, help=text)(command)
        return command

    return add


def quantities(*names: str, kinds: Sequence[str] = light.ORDER) -> Callable[..., Any]:
    """Add light quantities as options, by their generic names and by those of one kind."""

    def add(command: Callable[..., Any]) -> Callable[..., Any]:
        for name in reversed(names):
            others = [n for n in light.names_of(name) if light.SPECIFIC[n][1] in kinds]
            text = light.INPUTS[name]
            if others:
                text += f" (also --{', --'.join(others)})"
            for other in reversed(others):
                what = f"{light.INPUTS[name]}, as {other.replace('-', ' ')}."
                command = click.option(
                    f"--{other}", metavar=light.option(other).example, help=what, hidden=True
                )(command)
            own = LUMINOUS if LUMINOUS in kinds else kinds[0]
            example = f"100{light.unit(name, own)}".replace(" ", ".")
            command = click.option(f"--{name}", metavar=example, help=f"{text}.")(command)
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
    long = [name for name, values in given.items() if is_array(values[0].value)]
    varied, each = one_by_one(given, long)
    return [(case[varied].text if varied else "", case) for case in each]


def _parts(name: str, text: str, arrays: bool) -> Sequence[Any]:
    """The values of a list or a range; a range of wavelengths, or a file's name, is one value."""
    if arrays and name in VECTORS and (values := read_array(text)):
        return [values]
    if name == "spectrum":
        return read_spectra(text)
    return [text] if name in light.REFINEMENTS else read_series(text)


def shape(word: str, names: Sequence[str]) -> str:
    """The name of a shape, in any case."""
    if word.lower() in names:
        return word.lower()
    near = nearest(word.lower(), names, 1) or names
    raise UsageError(f"there is no shape '{quote(word)}'", ", ".join(near))


def finish(
    answers: Sequence[tuple[str, Answer]], asked: Asked, output: Output, **facts: Any
) -> int:
    """Show answers that no input can be changed of, or judge one; return the exit status."""
    cases: list[Case] = [(case, {}) for case, _ in answers]
    if asked.check is not None:
        return run(cases, lambda _: answers[0][1], asked, output, **facts)
    show(answers, asked, output)
    return stdio.ANSWERED


def run(
    each: Sequence[Case],
    work_out: Callable[[Inputs], Answer],
    asked: Asked,
    output: Output,
    **facts: Any,
) -> int:
    """Work out the answer to every case and show it, or judge one; return the exit status.

    `facts` are what a judgement takes beside the inputs: the command, the shape.
    """
    if asked.check is not None:
        if len(each) > 1:
            raise UsageError("--check takes one answer, and there are several", "one value a call")
        return checking.judge(
            each[0][1], work_out, asked.check, asked.tolerance, asked.steps, output, **facts
        )
    show([(case, work_out(given)) for case, given in each], asked, output)
    return stdio.ANSWERED


def show(answers: Sequence[tuple[str, Answer]], asked: Asked, output: Output) -> None:
    """Write the answers, or the numbers that were asked for; each answer with its case."""
    wanted = asked.wanted
    if not asked.steps:
        answers = [(case, (*answer[:3], [])) for case, answer in answers]
    if wanted:
        if output.format not in (PLAIN, TABLE):
            raise UsageError(
                f"--get prints bare numbers, and contradicts --format {output.format}",
                "one of them",
            )
        lines = [
            _lines([pick(values, name) for name in wanted], output.precision)
            for _, (values, _, _, _) in answers
        ]
        stdio.write("".join(lines))
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
