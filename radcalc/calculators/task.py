"""A task: a calculation for the command line or a Python function."""

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from types import MappingProxyType
from typing import Any

from radcalc.answer import Answer, Remark, ShownInput, itself
from radcalc.inputs.given import Inputs, any_uncertain
from radcalc.quantities.symbols import generic_name
from radcalc.tuples import NamedTuple

Wants = Callable[[str], bool]  # returns whether the result of a name is requested


class Task(NamedTuple):
    """A calculation: its command, its function, and arguments in addition to the inputs.

    `operands` are shown with the inputs; `shape` is the shape among them.  `samples` are facts of
    a log, for `--check`; `drawn` is extra data of a picture.
    """

    command: str
    work_out: Callable[[Inputs], Answer]
    operands: Sequence[ShownInput] = ()
    shape: str = ""
    samples: Mapping[str, float] = MappingProxyType({})
    drawn: Any = None

    def nominal(self, inputs: Inputs) -> Answer:
        """Return the answer for the values of inputs, with assumptions about their readings."""
        return _with_readings(self.work_out(inputs), inputs)

    def solve(self, inputs: Inputs) -> Answer:
        if not any_uncertain(inputs.values()):
            return self.nominal(inputs)
        from radcalc.calculators.uncertainty import with_uncertainties

        return with_uncertainties(self.nominal, inputs)


def requesting(function: Callable[..., Answer], names: Sequence[str]) -> Callable[..., Answer]:
    """Return the function of a page that also calculates these results of its `on_request`."""
    return partial(function, requested=names) if names else function


def _with_readings(answer: Answer, inputs: Inputs) -> Answer:
    readings: list[str] = []
    for given in inputs.values():
        readings += [Remark(text, [generic_name(given.name)]) for text in given.assumptions]
    if not readings:
        return answer
    if answer.origins is itself:
        readings = [*map(str, readings)]
    answers = (answer, *answer.more)
    first, *more = (
        alternative._replace(assumptions=(*readings, *alternative.assumptions))
        for alternative in answers
    )
    return first._replace(more=more)
