"""What every calculator shares: reading its inputs, --get, --check, and showing answers."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import partial
from typing import Any, NamedTuple

from radcalc import stdio
from radcalc.answer import Answer, Input, Result, Row
from radcalc.calculators.results import (
    LINKS_HINT,
    element,
    name_of,
    pick,
    rows,
    saying_how_read,
    scales_of,
)
from radcalc.cli import check, streams
from radcalc.cli.cases import Case, label
from radcalc.cli.options import Output
from radcalc.errors import MissingInput, UsageError, nearest, option, quote
from radcalc.given import Inputs, any_uncertain, inputs_of
from radcalc.maths import is_array
from radcalc.quantities.symbols import QUANTITY
from radcalc.render import arrays
from radcalc.render.formats import CSV
from radcalc.units.ranges import MOST

BLOCK = 100_000  # values of a long range that are worked out at a time


class Asked(NamedTuple):
    """What is asked of the answer: some results, the derivation, whether a number is right.

    `lines` are the options for lines of standard input, of a command that takes these; `plot` is
    where the picture goes, of one that has one.
    """

    wanted: tuple[str, ...]
    steps: bool
    check: str | None
    tolerance: str | None
    lines: streams.LineOptions | None = None
    plot: str = ""

    @classmethod
    def of(cls, values: dict[str, Any], takes_lines: bool) -> "Asked":
        """Take it out of a command's values; refuse what has no use with --check, or without."""
        asked = cls(*[values.pop(name) for name in cls._fields[:4]])
        asked = asked._replace(plot=values.pop("plot", None) or "")
        if takes_lines:
            own = [values.pop(name) for name in streams.LineOptions._fields]
            asked = asked._replace(lines=streams.LineOptions(*own))
        check.refuse_idle(asked.check, asked.tolerance)
        if asked.check is not None and asked.wanted:
            raise UsageError("--check and --get contradict each other", "--check NAME=VALUE")
        return asked

    def wants(self, name: str) -> bool:
        """Whether a result is asked for by its name."""
        named = [*self.wanted, (self.check or "").replace("=", ":")]
        return name in map(name_of, named)


def shape(word: str, names: Sequence[str]) -> str:
    """The name of a shape, in any case."""
    if word.lower() in names:
        return word.lower()
    near = nearest(word.lower(), names, 1) or names
    raise UsageError(f"there is no shape '{quote(word)}'", ", ".join(near))


class Answered(NamedTuple):
    """An answer, which of several it is, and what was given for it."""

    case: str
    inputs: tuple[Input, ...]
    answer: Answer

    @property
    def long(self) -> Input | None:
        """The input that is an array."""
        arrays = [told for told in self.inputs if is_array(told.value)]
        return arrays[0] if arrays else None


def run(
    each: Sequence[Case],
    work_out: Callable[[Inputs], Answer],
    asked: Asked,
    output: Output,
    command: str,
    shape: str = "",
    operands: Sequence[Input] = (),
    samples: Mapping[str, float] | None = None,
    drawn: Any = None,
) -> int:
    """Work out the answer to every case and show it, or judge one; return the exit status.

    `operands` are what was given beside the options; `samples` are facts of a log that is judged;
    `drawn` is what a picture takes beside the inputs.
    """
    work_out = saying_how_read(work_out)
    if asked.plot:
        from radcalc.cli import plot

        plot.refuse(asked, output)
    if each[0].stream:
        return _of_lines(each, work_out, asked, output, command, operands)
    if asked.lines is not None:
        streams.refuse(asked.lines, _lines_for(each[0].given))
    if asked.check is not None:
        from radcalc.homework.question import of_calculator

        check.refuse_several(sum(case.size for case in each))
        given = each[0].given
        question = of_calculator(command, shape, given, work_out, asked.steps)
        question = question._replace(samples=samples or {})
        inputs = (*operands, *inputs_of(given))
        return check.judge(question, asked.check, asked.tolerance, output, inputs)
    if asked.wanted and output.has_columns and not asked.plot:
        each = [part for case in each for part in _blocks(case)]
    elif not asked.plot:
        _refuse_long(each, asked)
    if any_uncertain([one for case in each for one in case.given.values()]):
        from radcalc.calculators.uncertainty import with_uncertainties

        work_out = partial(with_uncertainties, work_out)
    told = [(*operands, *inputs_of(case.given)) for case in each]
    if asked.plot:
        solved = [_noted(case, work_out(case.given)) for case in each]
        picture = plot.picture(command, [case.given for case in each], solved, asked, drawn)
        every = [_every(*one) for one in zip(each, told, solved, strict=True)]
        plot.show_beside(picture, [one for some in every for one in some], asked, output, told)
        return stdio.ANSWERED
    answers = (
        one
        for case, inputs in zip(each, told, strict=True)
        for one in _every(case, inputs, _noted(case, work_out(case.given)))
    )
    show(answers, asked, output, told)
    return stdio.ANSWERED


def _lines_for(given: Inputs) -> str:
    """The option that could have its values from lines of standard input."""
    for name, one in given.items():
        if one.symbol.form == QUANTITY:
            return option(name, f"- {one.unit_text}" if one.unit else "-")
    return "- for the value of an option"


def _of_lines(
    each: Sequence[Case],
    work_out: Callable[[Inputs], Answer],
    asked: Asked,
    output: Output,
    command: str,
    operands: Sequence[Input],
) -> int:
    """Answer to lines of standard input, under one case of everything else."""
    case = each[0]
    assert case.stream is not None
    told = option(case.stream.name, "-")
    if asked.lines is None:
        raise UsageError(f"{told}: {command} takes no lines of standard input", "one value a call")
    check.refuse_stream(asked.check)
    if asked.steps:
        raise UsageError("--steps is not for a stream", "one value, for the derivation")
    if asked.plot:
        raise UsageError("--plot is not for a stream", "a range of values: 1m:10m:0.1m")
    if len(each) > 1 or case.long:
        raise UsageError(f"{told} stands beside a list", "one value of everything else")
    return streams.calculate(case, work_out, asked.wanted, asked.lines, output, operands)


def _blocks(case: Case) -> Iterator[Case]:
    """A case of a long range in parts, whose answers do not fill the memory."""
    long = case.long
    if long is None:
        yield case
        return
    for start in range(0, case.size, BLOCK):
        part = slice(start, start + BLOCK)
        values = long._replace(value=long.value[part], number=long.number[part])
        yield case._replace(given={**case.given, long.name: values}, long=values)


def _refuse_long(each: Sequence[Case], asked: Asked) -> None:
    """Refuse a table of more answers than anybody reads."""
    count = sum(case.size for case in each)
    if count > MOST:
        hint = "--format csv, for columns" if asked.wanted else "-g NAME:UNIT, for columns"
        raise UsageError(f"a table of {count} answers is too long", hint)


def refuse_bare(output: Output) -> None:
    """Refuse -n where there are several results."""
    if output.style.bare:
        raise UsageError("-n prints one number, and there are several results", "-g NAME:UNIT")


def show(
    answers: Iterable[Answered],
    asked: Asked,
    output: Output,
    inputs: Sequence[Sequence[Input]] = (),
) -> None:
    """Write the answers, or the results that were asked for; `inputs` are those of all answers."""
    if not asked.steps:
        answers = (one._replace(answer=one.answer._replace(steps=())) for one in answers)
    if not asked.wanted:
        refuse_bare(output)
        output.show([result(one) for one in _spread(answers)])
    elif output.is_bare or (output.format == CSV and _are_arrays(inputs)):
        hint = "--format table, or a unit: -g NAME:UNIT"
        output.refuse_auto("--get prints bare numbers", hint)
        _show_columns(_picked(answers, asked.wanted, in_columns=True), output, inputs)
    else:
        picked = _picked(_spread(answers), asked.wanted)
        output.show([result(one, chosen) for one, chosen in picked])


def _are_arrays(inputs: Sequence[Sequence[Input]]) -> bool:
    return any(is_array(one.value) for some in inputs for one in some)


def _picked(
    answers: Iterable[Answered], wanted: Sequence[str], in_columns: bool = False
) -> Iterator[tuple[Answered, list[Row]]]:
    """Each answer with the results that were asked for, in the units of the first.

    What was asked for without a unit, and is of another kind of light than in the first, is in its
    own unit; columns, each of one unit, are refused then.
    """
    said: tuple[str, ...] | None = None  # of scales
    first = wanted
    for one in answers:
        chosen = [
            _in_first(one, name, in_unit, in_columns)
            for name, in_unit in zip(wanted, first, strict=True)
        ]
        if first is wanted:
            first = [f"{row.name}:{row.unit}" for row in chosen]
        if said is None:
            said = scales_of(one.answer.values, first)
        if said:
            assumptions = dict.fromkeys((*one.answer.assumptions, *said))
            one = one._replace(answer=one.answer._replace(assumptions=tuple(assumptions)))
        yield one, chosen


def _in_first(one: Answered, name: str, in_unit: str, in_columns: bool) -> Row:
    """A result in the unit that it has in the first answer; or in its own, if that is not named."""
    try:
        return pick(one.answer.values, in_unit, one.case)
    except MissingInput:
        if name == in_unit or ":" in name:
            raise
        own = pick(one.answer.values, name, one.case)
        if not in_columns:
            return own
        units = f"{in_unit.partition(':')[2]} and {own.unit}"
        problem = f"a column of {own.name} would have two units, {units}"
        raise UsageError(problem, f"--format table, or {LINKS_HINT}") from None


def _show_columns(
    picked: Iterable[tuple[Answered, list[Row]]],
    output: Output,
    inputs: Sequence[Sequence[Input]],
) -> None:
    """Write numbers alone in plain text, or CSV of arrays."""
    units: dict[str, str] = {}
    if output.format == CSV:
        from radcalc.render import csv

        units = csv.units_of_varied(inputs)
    texts: list[str] = []
    remarks: dict[tuple[Any, ...], Result] = {}
    for one, chosen in picked:
        output.hear([result(one, chosen)])
        columns = [row.value for row in chosen]
        if output.format == CSV:
            texts.append(csv.block(result(one, chosen), units, output.style, not texts))
        else:
            count = len(one.long.value) if one.long else 1
            texts.append(arrays.lines(columns, output.style.precision, count))
        steps = () if one.long and texts[1:] else one.answer.steps
        said = result(one, ())._replace(steps=tuple(steps), inputs=())
        remarks[said if said.steps else said[1:3]] = said
    for text in texts:
        stdio.write(text)
    output.remark(list(remarks.values()))


def _noted(case: Case, answer: Answer) -> Answer:
    """The answer with what is to be said of its inputs."""
    return answer._replace(notes=(*case.notes, *answer.notes)) if case.notes else answer


def _every(case: Case, inputs: tuple[Input, ...], answer: Answer) -> list[Answered]:
    """The answer to a case, or all of them where several fit, each with its number."""
    if not answer.more:
        return [Answered(case.label, inputs, answer)]
    return [
        Answered(label((*case.varied, Input("answer", text=str(k)))), inputs, one)
        for k, one in enumerate((answer, *answer.more), start=1)
    ]


def _spread(answers: Iterable[Answered]) -> Iterator[Answered]:
    """The answers, those of a long range one by one."""
    for one in answers:
        answer, long = one.answer, one.long
        if long is None:
            yield one
            continue
        shown = [value for value in answer.values if not value.is_absent]
        for k in range(len(long.value)):
            case = ", ".join(filter(None, (one.case, label([_element(long, k)]))))
            values = [element(value, k) for value in shown]
            inputs = tuple(_element(told, k) for told in one.inputs)
            steps = answer.steps if k == 0 else ()
            yield Answered(case, inputs, answer._replace(values=values, steps=steps))


def _element(told: Input, k: int) -> Input:
    """One element of an input that is an array, as it would be typed."""
    if not is_array(told.value):
        return told
    number = float(told.value[k])
    unit = told.unit if told.unit != "1" else ""
    return told._replace(value=number, text=f"{number:.15g}{unit}")


def result(one: Answered, chosen: Sequence[Row] | None = None) -> Result:
    """An answer as rows: all of them, or those that are chosen."""
    answer = one.answer
    return Result(
        tuple(rows(answer.values, one.case) if chosen is None else chosen),
        tuple(answer.assumptions),
        tuple(answer.notes),
        tuple(answer.steps),
        one.inputs,
    )
