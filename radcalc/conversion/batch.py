"""Several conversions under common conditions, of which each may use only some."""

from collections.abc import Sequence
from itertools import combinations

from radcalc.conversion.linear import Plan
from radcalc.conversion.plan import plan
from radcalc.errors import MissingCondition, RadcalcError, Unused
from radcalc.inputs.given import Input
from radcalc.units.unit import Unit

Request = tuple[Unit, Unit, Sequence[Input], str]  # the arguments of `plan`
Planned = tuple[Plan, Sequence[Input]]


def plans(requests: Sequence[Request]) -> list[Planned]:
    """Return the plans, each with the conditions it uses; raise for a condition that none uses."""
    planned: list[Planned] = []
    refusals: list[RadcalcError] = []
    for request in requests:
        try:
            planned.append((plan(*request), request[2]))
        except (Unused, MissingCondition) as error:
            if len(requests) == 1:
                raise
            refusals.append(error)
            planned.append(_with_fewer(request, error))
    used = {condition.name for _, conditions in planned for condition in conditions}
    idle = [condition.name for condition in requests[0][2] if condition.name not in used]
    if idle:
        for refusal in refusals:
            if isinstance(refusal, Unused) and {*refusal.symbols} == {*idle}:
                raise refusal
        raise Unused(idle, "to any of these conversions")
    return planned


def _with_fewer(request: Request, refusal: RadcalcError) -> Planned:
    """Return a plan with the fewest conditions removed that make a refused conversion possible.

    With a distance and an area an incidence is unused; with the area alone it is used.
    """
    source, target, conditions, number = request
    names = (
        refusal.symbols
        if isinstance(refusal, Unused)
        else [condition.name for condition in conditions]
    )
    for count in range(1, len(names) + 1):
        fewer: list[Planned] = []
        for left_out in combinations(names, count):
            kept = [condition for condition in conditions if condition.name not in left_out]
            try:
                fewer.append((plan(source, target, kept, number), kept))
            except RadcalcError:
                continue
        if len(fewer) == 1:
            return fewer[0]
        if fewer:  # several plans: the intended one is unclear
            if isinstance(refusal, Unused):
                raise refusal.reworded(hint="a call for each conversion")
            break
    raise refusal
