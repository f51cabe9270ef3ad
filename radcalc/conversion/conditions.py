"""The conditions of a conversion: the symbols that can be given, and the slot of each."""

from collections.abc import Callable, Sequence
from typing import Any

from radcalc.answer import Step
from radcalc.errors import Exclusive
from radcalc.inputs.given import Input
from radcalc.tuples import NamedTuple

# Slots of conditions; two conditions in one slot contradict each other.
LINK, TIME, AREA, CONE, DISTANCE = "link of kinds", "time", "area", "solid angle", "distance"
SUPPLIES = {LINK: "link radiant, luminous and photon quantities"}
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


class Conditions:
    """The given conditions by slot, and the slots in use."""

    __slots__ = ("given", "used")

    def __init__(self, given: Sequence[Input]) -> None:
        self.given: dict[str, Input] = {}
        self.used: set[str] = set()
        for condition in given:
            about = CONDITIONS[condition.name]
            slot = condition.name if about == REFINES else about
            if slot in self.given:
                names = (self.given[slot].name, condition.name)
                raise Exclusive(names, f"both {SUPPLIES.get(slot, f'give the {slot}')}")
            self.given[slot] = condition

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
