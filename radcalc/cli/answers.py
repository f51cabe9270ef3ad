"""Preparation of answers for the renderers."""

from collections.abc import Iterable, Iterator, Sequence
from typing import Any

from radcalc import terminal
from radcalc.answer import Answer, Result, Row, ShownInput
from radcalc.calculators.results import LINKS_HINT, element, pick, rows, said_of, scales_of
from radcalc.cli.output import Output
from radcalc.cli.request import Case, Request, label
from radcalc.errors import MissingInput, Try, UsageError, add, leave_out
from radcalc.maths import is_array
from radcalc.render.plain import omitted
from radcalc.terminal import CSV, TABLE
from radcalc.tuples import NamedTuple


class Answered(NamedTuple):
    """An answer with its case and its inputs."""

    case: str
    inputs: tuple[ShownInput, ...]
    answer: Answer

    @property
    def long(self) -> ShownInput | None:
        arrays = [given for given in self.inputs if is_array(given.value)]
        return arrays[0] if arrays else None


def refuse_bare(output: Output, answered: Answered | None = None) -> None:
    """Refuse -n if there are several results; propose the first two of an answer."""
    if output.style.bare:
        rows = result(answered).rows if answered else ()
        found = [f"{row.name}:{row.unit}" for row in rows if not row.given][:2]
        hint = [Try((("get", name),), ("number",)) for name in found] or "-g NAME:UNIT"
        raise UsageError("-n prints one number, but there are several results", hint)


def with_steps(answers: Iterable[Answered], request: Request) -> Iterable[Answered]:
    """Return the answers with their derivations only if they are requested."""
    if request.steps:
        return answers
    return (answered._replace(answer=answered.answer._replace(steps=())) for answered in answers)


def show(
    answers: Iterable[Answered],
    request: Request,
    output: Output,
    inputs: Sequence[Sequence[ShownInput]] = (),
) -> None:
    """Write the answers, or the requested results."""
    answers = with_steps(answers, request)
    if not request.wanted:
        first, *others = _spread(answers)
        refuse_bare(output, first)
        output.show([result(answered) for answered in (first, *others)])
    elif (output.is_bare and not _has_derivation(request, output)) or (
        output.format == CSV and _are_arrays(inputs)
    ):
        hint = [leave_out("auto"), add("format", TABLE)]
        output.refuse_auto("--get prints bare numbers", hint)
        _show_columns(_picked(answers, request.wanted, in_columns=True), output, inputs)
    else:
        picked = _picked(_spread(answers), request.wanted)
        output.show([result(answered, chosen) for answered, chosen in picked])


def _has_derivation(request: Request, output: Output) -> bool:
    """Return whether a derivation for people to read ends in the results, with their names."""
    return request.steps and output.format == TABLE and not output.style.bare


def _are_arrays(inputs: Sequence[Sequence[ShownInput]]) -> bool:
    return any(is_array(given.value) for listed in inputs for given in listed)


def _picked(
    answers: Iterable[Answered], wanted: Sequence[str], in_columns: bool = False
) -> Iterator[tuple[Answered, list[Row]]]:
    """Yield each answer with the requested results, in the units of the first answer.

    A result of another kind of light keeps its own unit unless a unit is requested; columns,
    which have one unit each, are refused then.
    """
    scale_remarks: tuple[str, ...] | None = None
    first = wanted
    for answered in answers:
        chosen = [
            _in_first(answered, name, in_unit, in_columns)
            for name, in_unit in zip(wanted, first, strict=True)
        ]
        if first is wanted:
            first = [f"{row.name}:{row.unit}" for row in chosen]
        if scale_remarks is None:
            scale_remarks = scales_of(answered.answer.values, first)
        if scale_remarks:
            assumptions = (*answered.answer.assumptions, *scale_remarks)
            answered = answered._replace(answer=answered.answer._replace(assumptions=assumptions))
        yield answered, chosen


def _in_first(answered: Answered, name: str, in_unit: str, in_columns: bool) -> Row:
    try:
        return pick(answered.answer.values, in_unit, answered.case)
    except MissingInput:
        if name == in_unit or ":" in name:
            raise
        row = pick(answered.answer.values, name, answered.case)
        if not in_columns:
            return row
        units = f"{in_unit.partition(':')[2]} and {row.unit}"
        problem = f"a column of {row.name} would have two units, {units}"
        hint = f"--format table, or {LINKS_HINT}"
        raise UsageError(problem, hint, [add("format", TABLE)]) from None


def _show_columns(
    picked: Iterable[tuple[Answered, list[Row]]],
    output: Output,
    inputs: Sequence[Sequence[ShownInput]],
) -> None:
    """Write the picked results as CSV or as bare numbers, then each of their remarks once."""
    units: dict[str, str] = {}
    if output.format == CSV:
        from radcalc.render import csv

        units = csv.units_of_varied(inputs)
    texts: list[str] = []
    heard: list[Result] = []
    remarks: dict[tuple[Any, ...], Result] = {}
    for answered, chosen in picked:
        heard.append(result(answered, chosen))
        columns = [row.value for row in chosen]
        if output.format == CSV:
            texts.append(csv.block(heard[-1], units, output.style, not texts))
        else:
            count = len(answered.long.value) if answered.long else 1
            from radcalc.render.csv import lines

            texts.append(lines(columns, output.style.precision, count))
        steps = () if answered.long and texts[1:] else answered.answer.steps
        remark = result(answered, chosen)._replace(rows=(), steps=tuple(steps), inputs=())
        if output.is_bare:
            remark = remark._replace(notes=(*remark.notes, *omitted(chosen)))
        remarks[remark if remark.steps else remark[1:3]] = remark
    output.hear(heard)
    for text in texts:
        terminal.write(text, exact=True)
    output.remark(list(remarks.values()))


def with_notes(case: Case, answer: Answer) -> Answer:
    """Return the answer with the notes on its inputs."""
    return answer._replace(notes=(*case.notes, *answer.notes)) if case.notes else answer


def every_answer(
    cases: Iterable[Case], inputs: Iterable[tuple[ShownInput, ...]], solved: Iterable[Answer]
) -> Iterator[Answered]:
    """Pair the cases with their answers; number the answers if a case has several."""
    for case, given, answer in zip(cases, inputs, solved, strict=True):
        if not answer.more:
            yield Answered(case.label, given, answer)
            continue
        for k, alternative in enumerate((answer, *answer.more), start=1):
            number = ShownInput("answer", text=str(k))
            yield Answered(label((*case.varied, number)), given, alternative)


def _spread(answers: Iterable[Answered]) -> Iterator[Answered]:
    for answered in answers:
        answer, long = answered.answer, answered.long
        if long is None:
            yield answered
            continue
        present = [value for value in answer.values if not value.is_absent]
        for k in range(len(long.value)):
            case = ", ".join(filter(None, (answered.case, label([_element(long, k)]))))
            values = [element(value, k) for value in present]
            inputs = tuple(_element(given, k) for given in answered.inputs)
            steps = answer.steps if k == 0 else ()
            yield Answered(case, inputs, answer._replace(values=values, steps=steps))


def _element(given: ShownInput, k: int) -> ShownInput:
    if not is_array(given.value):
        return given
    number = float(given.value[k])
    unit = given.unit if given.unit != "1" else ""
    return given._replace(value=number, text=f"{number:.15g}{unit}")


def result(answered: Answered, chosen: Sequence[Row] | None = None) -> Result:
    """Return an answer as rows: the chosen ones, or all of them."""
    answer = answered.answer
    said = answer.said() if chosen is None else said_of(answer, chosen)
    return Result(
        tuple(rows(answer.values, answered.case) if chosen is None else chosen),
        *said,
        tuple(answer.steps),
        answered.inputs,
    )
