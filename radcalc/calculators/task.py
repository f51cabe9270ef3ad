"""A task: a calculation that both the command line and the Python functions hand out."""

from collections.abc import Callable, Mapping, Sequence
from types import MappingProxyType
from typing import Any, NamedTuple

from radcalc.answer import Answer, ShownInput
from radcalc.inputs.given import Inputs, any_uncertain

Wants = Callable[[str], bool]  # whether a result is asked for by its name


class Task(NamedTuple):
    """A calculation: the name of its command, its function, and what is given besides inputs.

    `operands` are shown with the inputs; `shape` is the kind of source or solid angle among them.
    `samples` are facts of a log, for `--check`; `drawn` is what a picture needs besides the inputs.
    """

    command: str
    work_out: Callable[[Inputs], Answer]
    operands: Sequence[ShownInput] = ()
    shape: str = ""
    samples: Mapping[str, float] = MappingProxyType({})
    drawn: Any = None

    def nominal(self, inputs: Inputs) -> Answer:
        """Work out what follows from the values of inputs, and say how these were read."""
        return _saying_how_read(self.work_out(inputs), inputs)

    def solve(self, inputs: Inputs) -> Answer:
        """Work out what follows from inputs, with their uncertainties."""
        if not any_uncertain(inputs.values()):
            return self.nominal(inputs)
        from radcalc.calculators.uncertainty import with_uncertainties

        return with_uncertainties(self.nominal, inputs)


def _saying_how_read(answer: Answer, inputs: Inputs) -> Answer:
    """Return the answer with an assumption for each input that was read in one of several ways."""
    readings = dict.fromkeys([text for given in inputs.values() for text in given.assumptions])
    if not readings:
        return answer
    answers = (answer, *answer.more)
    first, *more = (
        alternative._replace(assumptions=(*readings, *alternative.assumptions))
        for alternative in answers
    )
    return first._replace(more=more)
