"""Questions with a right answer: of a calculator or of a conversion."""

from collections.abc import Callable, Mapping, Sequence
from types import MappingProxyType
from typing import NamedTuple

from radcalc.answer import Answer, Step, Value
from radcalc.calculators.task import Task
from radcalc.calculators.uncertainty import value_of, with_uncertainties
from radcalc.conversion.linear import Plan
from radcalc.conversion.plan import plan
from radcalc.inputs.given import Input, Inputs, any_uncertain
from radcalc.units.amount import Amount
from radcalc.units.unit import Unit


class Question(NamedTuple):
    """The right answer, the inputs, and a function that gives the answer for other inputs.

    `shape` is the shape of the source or of the solid angle.  A conversion has a plan and a number
    to convert.  If inputs are uncertain, `uncertain` is the right answer with its uncertainties.
    The `samples` of a log are the first, the last and the sum of all [SI].  An `expression` is the
    function of direction that is integrated.
    """

    answer: Answer
    given: Inputs
    work_out: Callable[[Inputs], Answer]
    command: str
    shape: str = ""
    steps: tuple[Step, ...] = ()
    plan: Plan | None = None
    number: float = 0.0
    uncertain: Answer | None = None
    samples: Mapping[str, float] = MappingProxyType({})
    expression: str = ""


def of_task(task: Task, given: Inputs, steps: bool = False) -> Question:
    """Return the question that a calculator answers from inputs."""
    answer = task.nominal(given)
    texts = {operand.name: operand.text for operand in task.operands}
    question = Question(
        answer,
        given,
        task.nominal,
        task.command,
        task.shape,
        samples=task.samples,
        expression=texts.get("expression", ""),
    )
    return _with_uncertainties(question, given, steps)


def _with_uncertainties(question: Question, given: Inputs, steps: bool) -> Question:
    answer = question.answer
    if any_uncertain(given.values()):
        uncertain = with_uncertainties(question.work_out, given)
        # mistakes are searched in the derivation of the nominal values
        answer = uncertain._replace(values=answer.values, more=answer.more, steps=answer.steps)
        question = question._replace(answer=answer, uncertain=uncertain)
    explained = question.uncertain or answer
    return question._replace(steps=tuple(explained.steps)) if steps else question


def of_conversion(
    number: float,
    source: Unit,
    target: Unit,
    given: Sequence[Input],
    steps: bool = False,
    amount: Amount | None = None,
) -> Question:
    """Return the question of a conversion; `amount` is its value with any uncertainty."""

    def work_out(inputs: Inputs) -> Answer:
        value = inputs[""].value if "" in inputs else number
        conversion = plan(source, target, [condition for name, condition in inputs.items() if name])
        unit = conversion.target  # a scale is resolved to one of its readings
        name, symbol, also = conversion.result
        result = Value(
            "value",
            name or "value",
            symbol,
            conversion.quantity(value) * unit.factor,
            (unit.dimension,),
            (unit.text,),
            also=also,
        )
        return Answer(
            [result],
            conversion.assumptions,
            conversion.notes,
            conversion.derive(value) if steps else (),
        )

    conditions = {condition.name: condition for condition in given}
    answer = work_out(conditions)
    conversion = plan(source, target, given)
    question = Question(answer, conditions, work_out, "convert", plan=conversion, number=number)
    inputs = {**conditions, "": value_of(amount)} if amount else conditions
    return _with_uncertainties(question, inputs, steps)
