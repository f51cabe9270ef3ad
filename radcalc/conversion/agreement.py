"""Conditions that say one thing twice: their values are compared, to the digits typed."""

from collections.abc import Callable, Sequence
from typing import Any

from radcalc.answer import digits_apart, format_value
from radcalc.conversion import geometric
from radcalc.conversion.geometric import LINK, slot_of
from radcalc.errors import ConditionError, Contradiction, Exclusive, option, options, quote
from radcalc.inputs import Input, Inputs
from radcalc.laws import same
from radcalc.laws.solver import TO_DIGITS, Disagreement, Known, solve
from radcalc.maths import larger
from radcalc.quantities import ratio_of, ratio_unit
from radcalc.quantities.symbols import LINKS, QUANTITY
from radcalc.tuples import NamedTuple

SIZES = ("radius", "diameter", "area")
CONES = ("half-angle", "apex-angle", "isotropic", "hemisphere", "solid-angle")
LOBES = ("exponent", "beam-angle")
LINKING = ("wavelength", "spectrum")


class Said(NamedTuple):
    """What some inputs say: a value with its rounding error [SI], as a function of the inputs."""

    given: Sequence[Input]
    value_of: Callable[[Sequence[Input]], Any]

    @property
    def text(self) -> str:
        return " and ".join([option(item.name, quote(item.text)) for item in self.given])

    def verb(self, verb: str) -> str:
        """Return a verb for these inputs: agrees, agree."""
        return f"{verb}s" if len(self.given) == 1 else verb

    @property
    def known(self) -> Known:
        """Return the value, and the sum of the changes that the rounding of each input makes."""
        value, off = self.value_of(self.given), 0.0
        for k, item in enumerate(self.given):
            if item.symbol.form != QUANTITY or not item.rounding:
                continue
            moves = []
            for factor in (1 + item.rounding, 1 - item.rounding):
                moved = [*self.given]
                moved[k] = item._replace(value=item.value * factor)
                try:
                    moves.append(abs(self.value_of(moved) - value))
                except ConditionError:  # past a limit
                    continue
            for move in moves[1:]:
                moves[0] = larger(moves[0], move)
            off = off + (moves[0] if moves else 0.0)
        return Known(value, off)


def compare(first: Said, second: Said, unit: str) -> tuple[str, ...]:
    """Refuse two values that differ by more than the digits typed; return a note if they differ.

    The first is the one that is used.
    """
    known = {"first": first.known, "second": second.known}
    try:
        solution = solve([same("first", "second")], known)
    except Disagreement:
        values = known["second"].value, known["first"].value
        digits = digits_apart(*values)
        other, used = (format_value(value, unit, digits) for value in values)
        names = [item.name for said in (second, first) for item in said.given]
        raise Contradiction(
            f"{second.text} {second.verb('contradict')} {first.text}: {other} is not {used}",
            f"leave out one of {options(names, ', ')}",
            names[0],
            *values,
        ) from None
    if not solution.agreed:
        return ()
    are = "is" if len(first.given) == 1 else "are"
    return (f"{first.text} {are} used; {second.text} {second.verb('agree')} {TO_DIGITS}",)


def agreed(given: Sequence[Input]) -> tuple[list[Input], tuple[str, ...]]:
    """Return one condition for each slot, where several agree, and notes; refuse others."""
    inputs, notes = without_efficacy({item.name: item for item in given})
    slots: dict[str, Input] = {}
    for item in inputs.values():
        slot = slot_of(item.name)
        if slot in slots:
            slots[slot], further = _of_one_slot(slot, slots[slot], item)
            notes += further
        else:
            slots[slot] = item
    return [*slots.values()], notes


def _of_one_slot(slot: str, first: Input, second: Input) -> tuple[Input, tuple[str, ...]]:
    """Return the more telling one of two conditions of one slot that agree, and notes."""
    for names, factor, unit in (
        (SIZES, geometric.area, "m2"),
        (CONES, geometric.solid_angle, "sr"),
        (LOBES, geometric.solid_angle, "sr"),
    ):
        if {first.name, second.name} <= {*names}:
            used, other = sorted((first, second), key=lambda item: item.name == names[-1])

            def value_of(given: Sequence[Input], factor: Any = factor) -> Any:
                return factor(given[0]).value

            return used, compare(Said([used], value_of), Said([other], value_of), unit)
    both = "link radiant, luminous and photon quantities" if slot == LINK else f"give the {slot}"
    raise Exclusive((first.name, second.name), f"both {both}")


def without_efficacy(links: Inputs) -> tuple[Inputs, tuple[str, ...]]:
    """Return links between kinds without an efficacy that agrees with another link, and notes."""
    if "efficacy" not in links or links.keys().isdisjoint(LINKING):
        return links, ()
    efficacy = links["efficacy"]
    fewer = {name: item for name, item in links.items() if name != "efficacy"}
    pair = ratio_of(efficacy.dimension)
    assert pair is not None
    return fewer, compare_ratio(Said([efficacy], lambda given: given[0].value), fewer, *pair)


def compare_ratio(ratio: Said, links: Inputs, over: str, under: str) -> tuple[str, ...]:
    """Compare a ratio of two kinds with that of the given link; return notes."""
    from radcalc.conversion.spectral import linked  # the tables of the observers

    link = next(links[name] for name in LINKS if name in links)

    def by_link(given: Sequence[Input]) -> Any:
        factor = linked({**links, link.name: given[0]}, over, under)
        if factor is None:
            names = [link.name, *[item.name for item in ratio.given]]
            raise Exclusive(names, "radiant, luminous and photon quantities are linked twice")
        return factor.value

    return compare(Said([link], by_link), ratio, ratio_unit(over, under))
