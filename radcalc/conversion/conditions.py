"""The conditions of a conversion: the symbols that can be given, and the slot of each."""

from collections.abc import Callable, Sequence
from typing import Any

from radcalc.answer import Step
from radcalc.inputs.given import Input
from radcalc.tuples import NamedTuple

# Slots of conditions; two conditions in one slot are compared.
LINK, TIME, AREA, CONE, DISTANCE = "link of kinds", "time", "area", "solid angle", "distance"
BAND, REFLECTANCE, PUPIL = "bandwidth", "reflectance", "pupil"
RESPONSIVITY = "responsivity"
REFINES = "refines"  # a condition that refines another one has its own slot

CONDITIONS = {
    "wavelength": LINK,
    "spectrum": LINK,
    "efficacy": LINK,
    "observer": REFINES,
    "range": REFINES,
    "photon-range": REFINES,
    "time": TIME,
    "photoperiod": TIME,
    "area": AREA,
    "radius": AREA,
    "diameter": AREA,
    "solid-angle": CONE,
    "half-angle": CONE,
    "apex-angle": CONE,
    "isotropic": CONE,
    "hemisphere": CONE,
    "exponent": CONE,
    "beam-angle": CONE,
    "distance": DISTANCE,
    "incidence": REFINES,
    "tilt": REFINES,
    "bandwidth": BAND,
    "reflectance": REFLECTANCE,
    "pupil": PUPIL,
    "responsivity": RESPONSIVITY,
    "electric-field": REFINES,
    "emissivity": REFINES,
    "k": REFINES,
    "c": REFINES,
}


class Factor(NamedTuple):
    """A factor or divisor of a quantity, with its letter.

    `check` raises for numbers in the source's unit that it does not convert.
    """

    letter: str
    value: Any
    unit: str
    assumption: str
    steps: tuple[Step, ...] = ()
    notes: tuple[str, ...] = ()
    check: Callable[[Any], None] | None = None


def slot_of(name: str) -> str:
    """Return the slot of a condition."""
    slot = CONDITIONS[name]
    return name if slot == REFINES else slot


class Conditions:
    """The given conditions by slot, one in each, and the slots in use."""

    __slots__ = ("given", "notes", "used")

    def __init__(self, given: Sequence[Input], notes: tuple[str, ...] = ()) -> None:
        self.given: dict[str, Input] = {slot_of(item.name): item for item in given}
        self.notes = notes
        self.used: set[str] = set()

    def with_others(self, others: dict[str, Input]) -> "Conditions":
        """Return conditions with other inputs in some slots."""
        conditions = Conditions(())
        conditions.given = {**self.given, **others}
        return conditions

    def use(self, slot: str) -> Input | None:
        """Return a condition, or None, and mark it as used."""
        if slot in self.given:
            self.used.add(slot)
        return self.given.get(slot)

    def take(self, slot: str) -> Input:
        self.used.add(slot)
        return self.given[slot]

    @property
    def unused(self) -> list[str]:
        return [condition.name for slot, condition in self.given.items() if slot not in self.used]
