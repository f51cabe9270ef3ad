"""The conditions of a conversion: which symbols can be given, and what each of them is about.

What factor a condition supplies is in `geometric.py` and `spectral.py`; which factors a
conversion needs is the business of `links.py`.
"""

from collections.abc import Sequence
from typing import Any, NamedTuple

from radcalc.answer import Step
from radcalc.errors import Exclusive
from radcalc.inputs.given import Input

# What a condition is about; two conditions about one thing contradict each other.
LINK, TIME, AREA, CONE, DISTANCE = "link of kinds", "time", "area", "solid angle", "distance"
BAND, REFLECTANCE, PUPIL = "bandwidth", "reflectance", "pupil"
RESPONSIVITY = "responsivity"
REFINES = "refines"  # what only refines another condition is about itself

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
    """A number with a letter that a quantity is multiplied or divided by."""

    letter: str
    value: Any
    unit: str
    assumption: str
    steps: tuple[Step, ...] = ()
    notes: tuple[str, ...] = ()


class Conditions:
    """The conditions that are given, by what they are about, and which of them have a use."""

    __slots__ = ("given", "used")

    def __init__(self, given: Sequence[Input]) -> None:
        self.given: dict[str, Input] = {}
        self.used: set[str] = set()
        for condition in given:
            about = CONDITIONS[condition.name]
            slot = condition.name if about == REFINES else about
            if slot in self.given:
                names = (self.given[slot].name, condition.name)
                raise Exclusive(names, f"both supply the {slot}")
            self.given[slot] = condition

    def use(self, slot: str) -> Input | None:
        """Take a condition, so that it counts as used."""
        if slot in self.given:
            self.used.add(slot)
        return self.given.get(slot)

    def take(self, slot: str) -> Input:
        """Take a condition that is there."""
        self.used.add(slot)
        return self.given[slot]

    @property
    def unused(self) -> list[str]:
        """The symbols of what has no use."""
        return [condition.name for slot, condition in self.given.items() if slot not in self.used]
