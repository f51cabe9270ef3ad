"""Conversions of a call, and their answers."""

import os
from collections.abc import Sequence
from typing import Any

from radcalc import errors
from radcalc.answer import Result, Row, ShownInput
from radcalc.cli.output import Output
from radcalc.cli.request import Case
from radcalc.conversion.operands import read_lists, read_operands, sides
from radcalc.conversion.plan import Planned, plan, plans, result_of_plan, source_of, target_of
from radcalc.errors import call, quote
from radcalc.inputs import Input, any_uncertain, shown_inputs
from radcalc.quantities import read as read_light
from radcalc.tuples import NamedTuple
from radcalc.units import Unit
from radcalc.units.compiled import PREFIX_SYMBOLS
from radcalc.units.numbers import Amount, read_number, split_quantity
from radcalc.units.ranges import note_of, refuse_many
from radcalc.units.table import unit_of


class Conversion(NamedTuple):
    """A value and its targets (possibly none), with the conditions of a case."""

    amount: Amount
    value: float
    source: Unit
    targets: Sequence[Unit]
    case: Case

    @property
    def conditions(self) -> list[Input]:
        return list(self.case.given.values())

    @property
    def inputs(self) -> tuple[ShownInput, ...]:
        text, off = self.amount.text.replace(errors.MINUS, "-"), self.amount.typed_uncertainty
        value = ShownInput("value", self.value, self.source.text, text, off)
        return (value, *shown_inputs(self.case.given))

    def answer(self, planned: Sequence[Planned], steps: bool) -> Result:
        """Return the answers of the conversions as one result, with their uncertainties."""
        results = []
        for conversion, used in planned:
            result = result_of_plan(conversion, self.value, self.case.label, steps)
            if self.amount.is_uncertain or any_uncertain(used):
                from radcalc.calculators.uncertainty import converted, of_conversion

                result = of_conversion(result, converted(conversion, self.amount, used))
            results.append(result)
        return Result(
            tuple(row for result in results for row in result.rows),
            tuple(dict.fromkeys(a for result in results for a in result.assumptions)),
            tuple(
                dict.fromkeys((*self.case.notes, *(n for result in results for n in result.notes)))
            ),
            tuple(dict.fromkeys(step for result in results for step in result.steps)),
            self.inputs,
            named=False,
        )


def show(calls: Sequence[Conversion], typed: dict[str, Any], steps: bool, output: Output) -> None:
    """Write the answers to all conversions, or the values in every unit if they have no target."""
    if calls[0].targets:
        output.show(answers(calls, steps))
    else:
        output.show([every_unit(call, typed, output.style.bare) for call in calls])


def answers(calls: Sequence[Conversion], steps: bool) -> list[Result]:
    """Return the answers to all conversions."""
    wanted = [
        (call.source, target, call.conditions, f"{call.value:.12g}")
        for call in calls
        for target in call.targets
    ]
    planned = iter(plans(wanted))
    return [call.answer([next(planned) for _ in call.targets], steps) for call in calls]


def conversions(words: list[str], all_cases: Sequence[Case]) -> list[Conversion]:
    """Return every conversion of a call: the values vary slowest, the targets fastest."""
    for word in words:
        if " --" in word and word.rpartition(" --")[2][:1].isalpha():
            apart = errors.correct(word, *word.split())
            raise errors.UsageError(f"'{quote(word)}' has an option in it", apart)
    lists = read_lists(words)
    refuse_many([len(lists), len(all_cases), len(lists[0])])
    notes = note_of(words[0]) if len(lists) > 1 else ()
    calls = []
    for of_value in lists:
        amount, texts = _read_value(of_value)
        value, source = amount.exact, amount.typed[1]
        assert source is not None
        targets = [target_of(text, source) for text in texts]
        which = (ShownInput("", text=amount.text),) if len(lists) > 1 else ()
        if len(targets) == 1:
            source = source_of(amount, targets[0], list(all_cases[0].given.values())) or source
        for case in all_cases:
            labelled = Case(case.given, (*which, *case.varied), (*notes, *case.notes))
            calls.append(Conversion(amount, value, source, targets, labelled))
    return calls


def refuse_file(words: Sequence[str]) -> None:
    """Refuse a file as a value, and propose the call that reads it."""
    if os.path.isfile(words[0]):
        name = errors.quote_path(words[0])
        stream = errors.correct(words[0], "-", "<", words[0])
        if words[0].lower().endswith((".ies", ".ldt")):
            stream = call("point-source", distribution=words[0])
        raise errors.UsageError(f"'{name}' is a file, not a value", stream)


def _read_value(calls: list[list[str]]) -> tuple[Amount, list[str]]:
    try:
        operands = [read_operands(words) for words in calls]
    except errors.UnitError as error:
        raise _other_unit_meant(calls[0]) or error from None
    except errors.UsageError as error:
        raise error.reworded(hint=_with_source(calls[0])) from None
    (amount, first), *others = operands
    if others and not first:
        several = quote(",".join(words[-1] for words in calls))
        units = [words[-1] for words in calls]
        targets = errors.correct(",".join(units), units[0], ",".join(units[1:]))
        raise errors.UsageError(f"'{several}' is a list, but one unit is expected", targets)
    return amount, [target for _, target in operands if target]


def _with_source(words: list[str]) -> errors.Hint:
    """Propose a unit of the target's quantity for a bare number: `5 lx to fc` for `5 to fc`."""
    from radcalc.quantities import result_name
    from radcalc.quantities.names import units_of
    from radcalc.quantities.search import named

    value, separator, text = sides(words)
    try:
        if not separator or split_quantity(value)[1]:
            return ""
        target = target_of(text)
        usual = named(result_name(target)).text if result_name(target) else ""
        likely = next(unit for unit in (usual, *units_of(target)) if unit not in ("", target.text))
    except (errors.RadcalcError, StopIteration):
        return ""
    return errors.correct(words[0], words[0], likely)


def _other_unit_meant(words: list[str]) -> errors.UnitError | None:
    """Return the error for a quantity as the unit of VALUE, or a blank after its prefix."""
    from radcalc.quantities.search import is_name, named

    source, _, _ = sides(words)
    try:
        _, unit = split_quantity(source or words[0])
        following = words[1:] if not source else []
        if not unit and following:
            unit, *following = following
        if is_name(unit):
            usual = named(unit).text.replace(" ", ".")
            return errors.UnitError(
                f"'{quote(unit)}' is a quantity, not a unit", errors.correct(unit, usual)
            )
        if unit in PREFIX_SYMBOLS and following and unit_of(unit + following[0]):
            problem = f"'{quote(unit)} {quote(following[0])}' has a blank after its prefix"
            return errors.UnitError(
                problem, errors.correct(f"{unit} {following[0]}", unit + following[0])
            )
    except errors.RadcalcError as error:
        return error if isinstance(error, errors.UnitError) and is_name(unit) else None
    return None


def likely_efficacy(error: errors.MissingUnit, words: list[str]) -> errors.Hint:
    """Return the hint for an efficacy without a unit: one that links the kinds of the units."""
    try:
        amount, target = read_operands(words)
        ends = (amount.unit, target_of(target, amount.unit))
        readings = [read_light(unit) for unit in ends if unit]
    except errors.RadcalcError:  # reported when the unit is given
        return error.tries
    kinds = {reading.kind for reading in readings if reading}
    units = {
        frozenset("ev"): ("lm/W", "W/lm"),
        frozenset("ep"): ("umol/J", "J/umol"),
        frozenset("vp"): ("lm.s/umol", "umol/lm/s"),
    }.get(frozenset(kinds))
    if units is None:
        return error.tries
    is_small = read_number(error.number)[0] < 1
    return error.with_unit(f"{error.number}{units[is_small]}").tries


def with_target(words: Sequence[str], call: Conversion) -> errors.Hint:
    """Propose the first other unit of the quantity as the target."""
    from radcalc.quantities.names import units_of

    others = [text for text in units_of(call.source) if text != call.source.text]
    return errors.correct(words[-1], words[-1], others[0]) if others else "a TARGET unit"


def every_unit(call: Conversion, typed: dict[str, Any], is_bare: bool) -> Result:
    """Return the value in every unit of its quantity."""
    source = call.source
    if typed:
        problem = f"--{next(iter(typed))} needs a unit to convert to"
        raise errors.UsageError(problem, errors.leave_out(*typed))
    if is_bare:
        raise errors.UsageError("-n needs a unit to convert to", errors.leave_out("number"))
    from radcalc.calculators import uncertainty
    from radcalc.quantities import name_of, result_name, symbol_of
    from radcalc.quantities.names import units_of
    from radcalc.units.values import ScaleUnit, names_of, resolve_any

    readings = (source, *source.others) if isinstance(source, ScaleUnit) else (source,)
    texts = [
        text for reading in readings for text in (*units_of(reading), *names_of(reading.dimension))
    ]
    targets = [source, *(resolve_any(text) for text in texts if text != source.text)]
    if len(targets) == 1 and not name_of(source):
        problem = f"'{quote(source.text)}' is not a unit of a quantity known to radcalc"
        raise errors.UsageError(problem, "a TARGET unit")
    rows, assumptions = [], {}
    assumed: tuple[str, ...] = ()
    for target in targets:
        try:
            conversion = plan(source, target)
            number, off = conversion.apply(call.value), 0.0
            if call.amount.is_uncertain:
                uncertain = uncertainty.converted(conversion, call.amount, ())
                off, assumed = uncertain.uncertainty, (uncertain.assumed,)
        except (errors.ConversionError, errors.ConditionError):
            if target is source:
                raise
            continue  # beyond what a float holds in that unit, or has a reading on that scale
        assumptions.update(dict.fromkeys(conversion.assumptions))
        meant = conversion.target if target.is_scale else target
        about = name_of(meant), symbol_of(meant)
        name = result_name(meant)
        row = Row(*about, number, target.text, call.case.label, name, uncertainty=off)
        rows.append(row)
    notes = (*call.case.notes, *source.notes)
    assumptions.update(dict.fromkeys(assumed))
    return Result(tuple(rows), tuple(assumptions), notes, inputs=call.inputs, named=False)
