"""Conversion: a plan from one unit to another, applied to a number or an array.

Several conversions may have common conditions, of which each may use only some.
"""

from itertools import combinations

from radcalc.conversion import Plan, are_reciprocal, between, is_function
from radcalc.errors import MissingCondition, RadcalcError, Unused
from radcalc.units import TEMPERATURE_ALONE, Unit
from radcalc.units.table import unit_of

TYPE_CHECKING = False  # typing.TYPE_CHECKING, without the cost of importing typing
if TYPE_CHECKING:
    from collections.abc import Sequence

    from radcalc.answer import Result, ShownInput
    from radcalc.inputs import Input
    from radcalc.units.numbers import Amount

Request = tuple[Unit, Unit, "Sequence[Input]", str]  # the arguments of `plan`
Planned = tuple[Plan, "Sequence[Input]"]


def plan(source: Unit, target: Unit, given: "Sequence[Input]" = (), number: str = "1") -> Plan:
    """Plan the conversion from one unit to another under the given conditions.

    `number` precedes the source's unit in commands that hints suggest.

    Raises ConversionError if a condition is missing, ConditionError if one is out of range,
    contradictory or unused.
    """
    if any(condition.name in ("observer", "weight", "filter") for condition in given):
        from radcalc.conversion.spectral import in_kinds

        source, target, given = in_kinds(source, target, given)
    if source.is_scale or target.is_scale or is_function(source, target):
        from radcalc.conversion import scaled

        return scaled.plan(source, target, given, number)
    if source.dimension != target.dimension:
        from radcalc.conversion.natural import by_law

        if law_plan := by_law(source, target, given):
            return law_plan
    return between(source, target, given, number)


def source_of(amount: "Amount", target: Unit, given: "Sequence[Input]" = ()) -> Unit | None:
    """Return the unit of an amount, as the target counts it.

    A formula of a textbook has the steradian of its law, one with h or c the target's photons.
    Raises ConversionError for the reciprocal of a difference of temperatures.
    """
    source = amount.typed[1]
    if source is None or amount.rounding is None:
        return source
    from radcalc.units.values import fit

    if source.dimension == TEMPERATURE_ALONE and (
        target.is_scale or are_reciprocal(source, target)
    ):
        from radcalc.conversion.scaled import refuse_difference

        refuse_difference(amount.text, target)
    source = fit(source, target.dimension)
    if given:
        return source
    from radcalc.conversion.bridge import as_law

    return as_law(amount.text, source, target)


def target_of(text: str, source: Unit | None = None) -> Unit:
    """Return the target of a conversion: a unit, a scale, or a quantity's usual unit.

    A known `source` determines the kind of light of a name such as flux.
    """
    if unit := unit_of(text):
        return unit
    from radcalc.units.values import find_scale

    if scale := find_scale(text):
        return scale
    from radcalc.quantities import search

    return search.named(text, source)


def result_of_plan(
    made: Plan,
    value: float,
    case: str = "",
    steps: bool = False,
    inputs: "tuple[ShownInput, ...]" = (),
) -> "Result":
    """Return the result for one value; `inputs` are the value and the conditions."""
    from radcalc.answer import Result, Row

    unit = made.target
    number = made.apply(value)
    quantity, symbol, name = made.result
    row = Row(quantity, symbol, number, unit.text, case, name)
    derivation = tuple(made.derive(value)) if steps else ()
    notes = made.notes
    if value < 0:
        notes += note_on_negative(made)
    return Result((row,), made.assumptions, notes, derivation, inputs, named=False)


def note_on_negative(made: Plan) -> tuple[str, ...]:
    """Return the note on a negative amount of light that is converted."""
    from radcalc.quantities import name_of, read

    if made.source.is_scale or not read(made.source):
        return ()
    return (f"a negative {name_of(made.source)} is a difference: light is never negative",)


def plans(requests: "Sequence[Request]") -> list[Planned]:
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
