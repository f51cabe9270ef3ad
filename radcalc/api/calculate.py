"""The common path of every calculator's function, from keywords to a result."""

from collections.abc import Callable, Mapping
from functools import partial
from typing import Any

from radcalc.answer import Answer, texts_of
from radcalc.api.arguments import broadcast, is_lazy, read_inputs, read_points
from radcalc.api.columns import take_columns
from radcalc.api.result import Result, in_columns, of_answer
from radcalc.api.spelling import is_absent, keyword
from radcalc.calculators.page import NOTHING
from radcalc.calculators.pages import page_of
from radcalc.calculators.task import Task, requesting
from radcalc.inputs.given import Input, Inputs, shown_inputs
from radcalc.maths import is_column

WorkOut = Callable[..., Answer]  # of the inputs, and of results on request


def calculate(
    command: str,
    given: Mapping[str, Any],
    work_out: WorkOut,
    operands: Mapping[str, str] = NOTHING,
    *,
    waits: bool = True,
    adapt: Callable[[Inputs], Inputs] | None = None,
    samples: Mapping[str, float] = NOTHING,
    drawn: Any = None,
    requested: tuple[str, ...] = (),
) -> Result:
    """Read the symbols given to a function, and return the result.

    `operands` are shown with them; `samples` are facts of a log; `drawn` is what a picture needs
    in addition to the inputs; `adapt` changes the inputs that were read; `waits` is true if the
    function takes Dask arrays.  `requested` are results that the function calculates on request
    alone.
    """
    columns, given = take_columns({k: v for k, v in given.items() if not is_absent(v)})
    if waits and any(map(is_lazy, given.values())):
        from radcalc.api.lazy import blockwise

        operand_texts = dict(operands)  # pickle takes it, unlike a proxy
        call = partial(calculate, command, work_out=work_out, operands=operand_texts, adapt=adapt)
        waiting: Result = blockwise(keyword(command), call, given)
        return in_columns(waiting, columns)
    symbols = dict(given)
    point = symbols.pop("point", None)
    inputs = read_inputs(symbols, page_of(command).intervals)
    if point is not None:
        inputs = {**inputs, "point": read_points(point)}
    if adapt:
        inputs = adapt(inputs)
    arrays = any(map(_has_elements, inputs.values()))
    shape = operands.get("shape") or operands.get("type", "")
    task = Task(command, requesting(work_out, requested), texts_of(operands), shape, samples, drawn)
    answer = broadcast(lambda: task.solve(inputs))

    def ask() -> Any:
        from radcalc.homework.question import of_task

        return of_task(task, inputs, steps=True)

    def again(name: str) -> Answer:
        further = task._replace(work_out=requesting(work_out, (*requested, name)))
        found: Answer = broadcast(lambda: further.solve(inputs))
        return found

    listed_inputs = (*task.operands, *shown_inputs(inputs))
    solved = (inputs, answer, drawn)
    result = of_answer(command, answer, listed_inputs, None if arrays else ask, solved, again)
    return in_columns(result, columns)


def _has_elements(given: Input) -> bool:
    values = given.value if isinstance(given.value, tuple) else (given.value,)
    return any(map(is_column, values))
