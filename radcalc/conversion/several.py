"""Several conversions under the same conditions, each of which uses some of them."""

from collections.abc import Sequence
from itertools import combinations

from radcalc.conversion.plan import Plan, plan
from radcalc.errors import MissingCondition, RadcalcError, Unused
from radcalc.given import Given
from radcalc.units.table import Unit

Asked = tuple[Unit, Unit, Sequence[Given], str]  # what `plan` takes
Planned = tuple[Plan, Sequence[Given]]


def plans(asked: Sequence[Asked]) -> list[Planned]:
    """The plans, and what each uses of the conditions; refuses a condition that none uses."""
    planned: list[Planned] = []
    refusals: list[RadcalcError] = []
    for one in asked:
        try:
            planned.append((plan(*one), one[2]))
        except (Unused, MissingCondition) as error:
            if len(asked) == 1:
                raise
            refusals.append(error)
            planned.append(_with_fewer(one, error))
    used = {one.name for _, given in planned for one in given}
    idle = [one.name for one in asked[0][2] if one.name not in used]
    if idle:
        for refusal in refusals:
            if isinstance(refusal, Unused) and {*refusal.symbols} == {*idle}:
                raise refusal
        raise Unused(idle, "in any of these conversions")
    return planned


def _with_fewer(asked: Asked, refusal: RadcalcError) -> Planned:
    """A plan without as few conditions as must go: what is left may find a use.

    Beside a distance and an area an incidence is idle, and beside the area alone it is not.
    """
    source, target, given, number = asked
    names = refusal.symbols if isinstance(refusal, Unused) else [one.name for one in given]
    for count in range(1, len(names) + 1):
        found: list[Planned] = []
        for left_out in combinations(names, count):
            rest = [one for one in given if one.name not in left_out]
            try:
                found.append((plan(source, target, rest, number), rest))
            except RadcalcError:
                continue
        if len(found) == 1:
            return found[0]
        if found:  # which is meant is not said
            if isinstance(refusal, Unused):
                refusal.hint = "a call for each conversion"
            break
    raise refusal
