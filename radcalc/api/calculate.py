"""From keywords to a result: what every calculator's function does."""

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from radcalc.answer import Answer, Value, texts_of
from radcalc.api.columns import taken
from radcalc.api.quantity import is_lazy
from radcalc.api.reading import broadcast, is_absent, read_inputs, read_points
from radcalc.api.result import Result, of_answer
from radcalc.api.spelling import in_python, keyword
from radcalc.calculators.results import saying_how_read
from radcalc.errors import ConditionError
from radcalc.given import Given, Inputs, inputs_of
from radcalc.maths import is_column

WorkOut = Callable[[Inputs], Answer]


@in_python
def calculate(
    command: str,
    given: Mapping[str, Any],
    work_out: WorkOut,
    *,
    operands: Mapping[str, str] | None = None,
    own: Sequence[str] = (),
    intervals: Sequence[str] = (),
    waits: bool = True,
    singly: bool = False,
    called: Callable[[Inputs], Inputs] | None = None,
    drawn: Any = None,
) -> Result:
    """Read what a function was given, work out what follows, and give all of it.

    `given` are its arguments, of which the `operands`, by their texts, and those of its `own` are
    no symbols; `intervals` are A:B.  It `waits` for Dask's arrays if it works element by element;
    what takes numbers `singly` is asked for each element; `called` gives inputs other names;
    `drawn` is what a picture takes beside the inputs.
    """
    columns, given = taken({k: v for k, v in given.items() if not is_absent(v)})
    if waits and any(map(is_lazy, given.values())):
        from radcalc.api.lazy import blockwise

        waiting: Result = blockwise(keyword(command), (), given)
        return waiting.in_columns(columns)
    operands = operands or {}
    symbols = {key: one for key, one in given.items() if key not in operands and key not in own}
    point = symbols.pop("point", None)
    inputs = read_inputs(symbols, intervals)
    if point is not None:
        inputs = {**inputs, "point": read_points(point)}
    if called:
        inputs = called(inputs)
    work_out = saying_how_read(work_out)
    told = (*texts_of(operands), *inputs_of(inputs))
    arrays = any(map(_has_elements, inputs.values()))
    every = _singly(work_out) if singly and arrays else work_out
    from radcalc.calculators.uncertainty import with_uncertainties

    answer = broadcast(lambda: with_uncertainties(every, inputs))

    def ask() -> Any:
        from radcalc.homework.question import of_calculator

        shape = operands.get("shape") or operands.get("type", "")
        return of_calculator(command, shape, inputs, work_out, steps=True)

    found = of_answer(command, answer, told, None if arrays else ask, (inputs, answer, drawn))
    return found.in_columns(columns)


def _has_elements(given: Given) -> bool:
    """Whether it is an array, or points that are."""
    values = given.value if isinstance(given.value, tuple) else (given.value,)
    return any(map(is_column, values))


def _singly(work_out: WorkOut) -> WorkOut:
    """Ask a calculator of single numbers for each element of the arrays that it is given."""

    def of_each(inputs: Inputs) -> Answer:
        import numpy

        arrays = {name: one for name, one in inputs.items() if is_column(one.value)}
        shape = numpy.broadcast_shapes(*(one.value.shape for one in arrays.values()))
        spread = {
            name: (numpy.broadcast_to(one.value, shape), numpy.broadcast_to(one.number, shape))
            for name, one in arrays.items()
        }
        answers = []
        for place in numpy.ndindex(shape):
            single = {
                name: _at(arrays[name], float(value[place]), float(number[place]))
                for name, (value, number) in spread.items()
            }
            answers.append(work_out({**inputs, **single}))
        if not answers:
            raise ConditionError("an array has no elements", "one or more")
        return _stacked(answers, shape)

    return of_each


def _at(given: Given, value: float, number: float) -> Given:
    unit = f" {given.unit_text}" if given.unit else ""
    return given._replace(value=value, number=number, text=f"{number:.12g}{unit}")


def _stacked(answers: Sequence[Answer], shape: tuple[int, ...]) -> Answer:
    """Answers of single numbers as one of arrays."""
    import numpy

    first, *others = [[one for one in each.values if not one.is_absent] for each in answers]
    heads = [(one.name, one.units) for one in first]
    if any([(one.name, one.units) for one in other] != heads for other in others):
        problem = "not all elements have the same results, in name and unit"
        raise ConditionError(problem, "a call for each")

    def array(numbers: Sequence[Any]) -> Any:
        return numpy.array(numbers, float).reshape(shape)

    def together(same: Sequence[Value]) -> Value:
        one = same[0]
        return one._replace(
            si=array([each.amount for each in same]),
            given=None if one.given is None else array([each.given for each in same]),
            exact=None if one.exact is None else array([each.exact for each in same]),
            reach={key: array([each.reach[key] for each in same]) for key in one.reach},
        )

    return Answer(
        [together(same) for same in zip(first, *others, strict=True)],
        tuple(dict.fromkeys(text for one in answers for text in one.assumptions)),
        tuple(dict.fromkeys(text for one in answers for text in one.notes)),
        answers[0].steps,
    )
