"""Calls of calculators: inputs, --get, --check and answers; `photon`, `integrate` and `sky`."""

from collections.abc import Callable, Iterator, Sequence
from functools import partial
from importlib import import_module
from typing import Any, TypeVar

from radcalc import errors, terminal
from radcalc.answer import Answer, ShownInput, texts_of
from radcalc.calculators import page_of
from radcalc.calculators.page import words_of
from radcalc.calculators.results import rows
from radcalc.calculators.solved import Task
from radcalc.cli.answers import every_answer, show, with_notes
from radcalc.cli.output import Output
from radcalc.cli.request import (
    Case,
    Request,
    at_points,
    cases,
    first_of,
    judge,
    refuse_lines,
    refuse_stream,
    several,
)
from radcalc.cli.spelling import Shell, own_module
from radcalc.errors import UsageError, call, leave_out, option, quote
from radcalc.inputs import Inputs, shown_inputs
from radcalc.maths import is_array
from radcalc.quantities.symbols import QUANTITY
from radcalc.terminal import CSV
from radcalc.units.ranges import MOST

BLOCK = 100_000  # values of a long range in one calculation


def calculate(
    name: str, typed: dict[str, Any], request: Request, output: Output, words: Sequence[str] = ()
) -> int:
    """Answer a call of a calculator, of its operands and its typed inputs.

    It calculates with the function of the command's name, or with the task that the function
    `task` of the same module makes of the operands.
    """
    module = import_module(f"radcalc.calculators.{name.replace('-', '_')}")
    page = module.PAGE
    all_cases = cases(typed, intervals=page.intervals, bare=page.bare)
    if hasattr(module, "task"):
        return run(all_cases, module.task(words, request.wants), request, output)
    if page.operand and not words:
        example, _ = words_of(page.examples[0])
        raise UsageError(f"a {page.operand.name} is missing", errors.command(name, *example))
    if page.operand:
        all_cases = at_points(all_cases, page.operand.name, words)
    function = request.narrowed(getattr(module, name.replace("-", "_")), page)
    return run(all_cases, Task(name, function), request, output)


def run(all_cases: Sequence[Case], task: Task, request: Request, output: Output) -> int:
    """Answer the cases of a task, check an answer, or draw them; return the exit status."""
    if request.plot:
        from radcalc.cli import plot

        plot.refuse(request, output)
    if all_cases[0].stream:
        return _answer_lines(all_cases, task, request, output)
    if request.lines is not None:
        refuse_lines(request.lines, _lines_for(all_cases[0].given))
    if request.check is not None:
        return _judge(all_cases, task, request, output)
    if request.plot:
        return _draw(all_cases, task, request, output)
    all_cases = _in_parts(all_cases, task, request, output)
    inputs = _shown_inputs(all_cases, task)
    show(every_answer(all_cases, inputs, _solve(all_cases, task)), request, output, inputs)
    return terminal.ANSWERED


def _shown_inputs(cases: Sequence[Case], task: Task) -> list[tuple[ShownInput, ...]]:
    return [(*task.operands, *shown_inputs(case.given)) for case in cases]


def _solve(cases: Sequence[Case], task: Task) -> Iterator[Answer]:
    return (with_notes(case, task.solve(case.given)) for case in cases)


def _draw(cases: Sequence[Case], task: Task, request: Request, output: Output) -> int:
    from radcalc.cli import plot

    solved, inputs = [*_solve(cases, task)], _shown_inputs(cases, task)
    picture = plot.picture(task, [case.given for case in cases], solved, request.wanted)
    plot.show_with_picture(picture, [*every_answer(cases, inputs, solved)], request, output, inputs)
    return terminal.ANSWERED


def _judge(cases: Sequence[Case], task: Task, request: Request, output: Output) -> int:
    from radcalc.homework.question import of_task

    assert request.check is not None
    if len(cases) > 1 or cases[0].size > 1:
        options = page_of(task.command).listed
        varied = [given for given in cases[0].varied if given.name in options]
        operands = [(given.text, given.text.split(",")[0]) for given in cases[0].varied]
        raise several(varied, operands)
    question = of_task(task, cases[0].given, request.steps)
    (inputs,) = _shown_inputs(cases, task)
    return judge(question, request.check, request.tolerance, output, inputs)


def _in_parts(
    cases: Sequence[Case], task: Task, request: Request, output: Output
) -> Sequence[Case]:
    """Divide long ranges into parts that fit in memory; refuse a table that is too long."""
    if request.wanted and output.has_columns:
        return [part for case in cases for part in _blocks(case)]
    count = sum(case.size for case in cases)
    if count > MOST:
        in_columns = errors.Try((("format", CSV),), ("json",))
        hint = in_columns if request.wanted else _first_result(cases[0], task)
        raise UsageError(f"a table of {count} answers is too long", hint)
    return cases


def _first_result(case: Case, task: Task) -> errors.Hint:
    """Propose the first result, as a column of numbers."""
    try:
        values = task.solve(_part(case, slice(2)).given).values
    except errors.RadcalcError:  # an error of these values
        return "-g NAME:UNIT, for columns"
    results = [row for row in rows(values) if not row.given]
    found = next((row for row in results if is_array(row.value)), results[0])
    return errors.add("get", f"{found.name}:{found.unit}", "a column of numbers")


def _lines_for(given: Inputs) -> str:
    for name, condition in given.items():
        if condition.symbol.form == QUANTITY:
            return option(name, f"- {condition.unit_text}" if condition.unit else "-")
    return "- for the value of an option"


def _answer_lines(cases: Sequence[Case], task: Task, request: Request, output: Output) -> int:
    """Answer the lines of standard input; refuse lists and options that a stream cannot have."""
    case = cases[0]
    assert case.stream is not None
    stream_option = option(case.stream.name, "-")
    if request.lines is None:
        problem = f"{stream_option}: {task.command} does not read lines of standard input"
        raise UsageError(problem, "one value a call")
    refuse_stream(request.check)
    if request.steps:
        raise UsageError("--steps cannot be used with a stream", leave_out("steps"))
    if request.plot:
        raise UsageError("--plot cannot be used with a stream", leave_out("plot"))
    if len(cases) > 1 or case.long:
        problem = f"{stream_option} cannot be used with a list"
        raise UsageError(problem, "one value of everything else", [first_of(case.varied)])
    from radcalc.cli import streams

    return streams.calculate(case, task, request.wanted, request.lines, output)


def _blocks(case: Case) -> Iterator[Case]:
    for start in range(0, case.size, BLOCK):
        yield _part(case, slice(start, start + BLOCK))


def _part(case: Case, part: slice) -> Case:
    """Return a case with a part of its long range, if it has one."""
    long = case.long
    if long is None:
        return case
    values = long._replace(value=long.value[part], number=long.number[part])
    return case._replace(given={**case.given, long.name: values}, long=values)


T = TypeVar("T")


def answer_photon(
    typed: dict[str, str], request: Request, output: Output, words: tuple[str, ...] = ()
) -> int:
    """Answer for a wavelength, or a quantity given instead."""
    from radcalc.calculators.photon import photon

    if not words:
        raise UsageError("a wavelength is missing", call("photon", "555nm"))
    all_cases = _as_operand(lambda: cases({"wavelength": " ".join(words), **typed}))
    all_cases = [_named(case) for case in all_cases]
    task = Task("photon", photon)
    if all_cases[0].stream:
        return _as_operand(lambda: run(all_cases, task, request, output))
    return run(all_cases, task, request, output)


def _as_operand(read: Callable[[], T]) -> T:
    """Read the operand; an error shows the wavelength as typed, since it is not an option here."""
    try:
        return read()
    except errors.RadcalcError as error:
        calls = [
            errors.Try(
                words=("photon", value),
                remark="" if errors.mentioned(proposal.remark) else proposal.remark,
                follow=proposal.follow,
            )
            for proposal in error.tries
            for _, value in proposal.inputs
        ]
        hint = calls or errors.spell(error.hint, Command)
        raise error.reworded(errors.spell(error.message, Operand), hint) from None


def _named(case: Case) -> Case:
    from radcalc.calculators.photon import named

    if case.stream:
        read = case.stream.read
        stream = case.stream._replace(read=lambda text: named(_as_operand(lambda: read(text))))
        return case._replace(stream=stream)
    wave = named(case.given["wavelength"])
    given = {**case.given, "wavelength": wave}
    names = {"wavelength": wave.name}
    varied = tuple(entry._replace(name=names.get(entry.name, entry.name)) for entry in case.varied)
    return case._replace(given=given, varied=varied)


class Operand(Shell):
    """The spelling of the wavelength in a message: as typed."""

    @staticmethod
    def option(name: str, value: str) -> str:
        return f"photon {value}".rstrip()


class Command(Shell):
    """The spelling of the wavelength in a hint."""

    @staticmethod
    def option(name: str, value: str) -> str:
        return f"radcalc photon {value}".rstrip()


def answer_integral(
    typed: dict[str, str],
    request: Request,
    output: Output,
    words: tuple[str, ...] = (),
    unit: str | None = None,
) -> int:
    """Answer for an expression, with or without a unit."""
    from radcalc.calculators.integrate import BARE, PAGE, integrand, integrate

    if not words:
        raise UsageError("an expression is missing", call("integrate", "cos(theta)", hemisphere=""))
    all_cases = cases(typed, arrays=False, intervals=PAGE.intervals)
    text = " ".join(words)
    of = integrand(unit) if unit else BARE
    operands = texts_of({"expression": text, "unit": unit or ""})
    drawn = text, unit or ""
    task = Task("integrate", lambda given: integrate(text, given, of), operands, drawn=drawn)
    return run(all_cases, task, request, output)


def answer_sky(
    typed: dict[str, str],
    request: Request,
    output: Output,
    words: tuple[str, ...] = (),
    save: str | None = None,
) -> int:
    """Answer for a sky, or write its map."""
    from radcalc.calculators.sky import OPERAND, sky, sky_map

    word, *others = words or [OPERAND.default]
    if others:
        raise UsageError(f"unexpected argument '{quote(others[0])}'", "one type of sky")
    name = word.lower()
    if save:
        from radcalc.cli.plot import one_case, write_map

        given = one_case(typed, request)
        inputs = (*texts_of({"type": name, "save": save}), *shown_inputs(given))
        return write_map(
            save, "map", lambda progress: sky_map(name, given), request, output, inputs
        )
    if "size" in typed:
        raise UsageError("--size does not apply without --save", "--save FILE with it")
    all_cases = cases(typed)
    is_drawn = bool(request.plot)
    task = Task(
        "sky", lambda given: sky(name, given, is_drawn), texts_of({"type": name}), name, drawn=name
    )
    return run(all_cases, task, request, output)


def answerer(name: str) -> Callable[..., int] | None:
    """Return the function that answers a calculator; None if only its Click command does.

    The function has the parameters of `calculate` after the name, and those of other options.
    """
    own = {"photon": answer_photon, "integrate": answer_integral, "sky": answer_sky}
    if name in own:
        return own[name]
    return None if own_module(name) else partial(calculate, name)
