"""The dose of a log: its samples added up, with the remarks on both."""

from collections.abc import Iterator
from math import inf

from radcalc.answer import Answer
from radcalc.calculators import dose as page
from radcalc.errors import MissingInput, add
from radcalc.inputs.given import Inputs
from radcalc.streams.samples import Log
from radcalc.units import horticulture

EXPECTED = "a file with a time and a value in each line"


class LogDose:
    """The dose of the samples of a log, for any light that the inputs describe."""

    def __init__(self, log: Log, longest: float, by: str = "", of_means: bool = False) -> None:
        """Read all samples, without bridging a step longer than `longest` seconds.

        `by` is a period, or '' for the whole log; with `of_means`, a sample is the mean from its
        time to that of the next one.
        """
        clock = log.clock
        page.check_unit(log.layout.unit)
        top, bottom = clock.tick
        dose = page.Dose(
            longest * bottom / top,
            longest < inf,
            (lambda time: clock.period(time, by)) if by else None,
            of_means,
        )
        for samples in log.samples():
            if samples:
                dose.add(*samples)
            else:
                dose.interrupt()
        dose.finish()
        self.log = log
        self.by = by
        self.summed = page.SummedLog(dose, log.layout.unit, clock.tick, clock.say)
        self.summed.check()

    @property
    def samples(self) -> dict[str, float]:
        """The facts of the log for the check of an answer."""
        return self.summed.samples()

    @property
    def is_of_several(self) -> bool:
        """Whether there are several periods."""
        return bool(self.by) and len(self.summed.dose.periods) > 1

    def answer(self, given: Inputs) -> Answer:
        """Return the answer for the whole log, or for its first period."""
        if self.by:
            return next(self.periods(given))[1]
        return self._with_remarks(self.summed.of_all(self._light(given)))

    def periods(self, given: Inputs) -> Iterator[tuple[str, Answer]]:
        """Yield the name of each period and its answer."""
        for label, answer in self.summed.of_periods(self._light(given)):
            yield label, self._with_remarks(answer)

    def _light(self, given: Inputs) -> Inputs:
        """Return the inputs for the light of the samples, without those for the times.

        A spectrum of PAR needs its range: the watts are those from 400 nm to 700 nm.
        """
        if self.log.layout.is_par and "spectrum" in given and "range" not in given:
            problem = "the values are PAR in watts, which are counted from 400 nm to 700 nm"
            raise MissingInput(problem, add("range", horticulture.PAR_RANGE))
        return {name: condition for name, condition in given.items() if name != "max-gap"}

    def _with_remarks(self, answer: Answer) -> Answer:
        log = self.log
        return answer._replace(
            assumptions=(*log.assumptions, *answer.assumptions), notes=[*answer.notes, *log.notes]
        )


def longest_step(given: Inputs) -> float:
    """Return the longest step that is bridged [s]."""
    return given["max-gap"].value if "max-gap" in given else inf
