"""What was asked: a calculator's or a conversion's question, with what its mistakes depend on."""

from collections.abc import Callable, Sequence
from typing import NamedTuple

from radcalc.answer import Answer, Step, Value
from radcalc.conversion.plan import Plan, derive, plan
from radcalc.given import Given, Inputs
from radcalc.quantities.light import name_of, symbol_of
from radcalc.units.table import Unit

PER_PI = ("lambert", "apostilb", "skot", "blondel", "bril")  # units that carry 1/pi


class Facts(NamedTuple):
    """What the usual mistakes depend on beside the inputs.

    `shape` is that of the source or of the solid angle, `distribution` that of a point source.
    Of a conversion `number` is what is converted, `jacobian` says whether spectral densities are,
    `unchanged` is the target [SI] with the source's number, and `per_pi` tells whether one of its
    units carries 1/pi.
    """

    command: str
    shape: str = ""
    distribution: str = ""
    number: float = 0.0
    jacobian: bool = False
    unchanged: float = 0.0
    per_pi: bool = False


class Question(NamedTuple):
    """The right answer, what was given, and how to work it out anew from other inputs.

    `steps` are the derivation, where one is asked for; `plan` that of a conversion.
    """

    answer: Answer
    given: Inputs
    work_out: Callable[[Inputs], Answer]
    facts: Facts
    steps: tuple[Step, ...] = ()
    plan: Plan | None = None


def of_calculator(
    command: str,
    shape: str,
    given: Inputs,
    work_out: Callable[[Inputs], Answer],
    steps: bool = False,
) -> Question:
    """The question that a calculator answers from what is given."""
    answer = work_out(given)
    distribution = ""
    if command == "point-source":
        from radcalc.calculators.point_source import spread  # which no other question needs

        distribution = spread(given)
    facts = Facts(command, shape, distribution)
    return Question(answer, given, work_out, facts, tuple(answer.steps) if steps else ())


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
            made.apply(value) * target.factor,
            (target.dimension,),
            (target.text,),
            also=name.replace(" ", "-"),
        )
        return Answer([result], made.assumptions, made.notes, derive(made, value) if steps else ())

    conditions = {one.name: one for one in given}
    answer = work_out(conditions)
    made = plan(source, target, given)
    names = [name for unit in (source, target) for name, _ in unit.atoms]
    facts = Facts(
        "convert",
        number=value,
        jacobian=any(factor.letter == "J" for factor, _ in made.links),
        unchanged=value * target.factor,
        per_pi=any(word in name for name in names for word in PER_PI),
    )
    return Question(answer, conditions, work_out, facts, tuple(answer.steps), made)
