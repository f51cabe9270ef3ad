"""What was asked: a calculator's or a conversion's question."""

from collections.abc import Callable, Sequence
from typing import NamedTuple

from radcalc.answer import Answer, Step, Value
from radcalc.conversion.plan import Plan, plan
from radcalc.given import Given, Inputs
from radcalc.quantities.light import name_of, result_name, symbol_of
from radcalc.units.table import Unit


class Question(NamedTuple):
    """The right answer, what was given, and how to work it out anew from other inputs.

    `shape` is that of the source or of the solid angle; `steps` are the derivation, where one is
    asked for.  A conversion has a plan, and the number that is converted.
    """

    answer: Answer
    given: Inputs
    work_out: Callable[[Inputs], Answer]
    command: str
    shape: str = ""
    steps: tuple[Step, ...] = ()
    plan: Plan | None = None
    number: float = 0.0


def of_calculator(
    command: str,
    shape: str,
    given: Inputs,
    work_out: Callable[[Inputs], Answer],
    steps: bool = False,
) -> Question:
    """The question that a calculator answers from what is given."""
    answer = work_out(given)
    return Question(answer, given, work_out, command, shape, tuple(answer.steps) if steps else ())


def of_conversion(
    value: float, source: Unit, target: Unit, given: Sequence[Given], steps: bool = False
) -> Question:
    """The question what a value is in another unit, under conditions."""

    def work_out(conditions: Inputs) -> Answer:
        made = plan(source, target, list(conditions.values()))
        name = name_of(target)
        result = Value(
            "value",
            name or "value",
            symbol_of(target),
            made.quantity(value) * target.factor,
            (target.dimension,),
            (target.text,),
            also=result_name(target),
        )
        return Answer([result], made.assumptions, made.notes, made.derive(value) if steps else ())

    conditions = {one.name: one for one in given}
    answer = work_out(conditions)
    made = plan(source, target, given)
    steps_told = tuple(answer.steps)
    return Question(answer, conditions, work_out, "convert", "", steps_told, made, value)
