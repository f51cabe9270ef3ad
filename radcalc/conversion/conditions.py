"""The conditions of a conversion: which symbols can be given, and what each of them is about.

What factor a condition supplies is in `geometric.py` and `spectral.py`; which factors a
conversion needs is the business of `bridges.py`.
"""

from collections.abc import Sequence
from typing import Any, NamedTuple

from radcalc.answer import Step
from radcalc.errors import Exclusive
from radcalc.given import Given

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

    def __init__(self, given: Sequence[Given]) -> None:
        self.given: dict[str, Given] = {}
        self.used: set[str] = set()
        for one in given:
            about = CONDITIONS[one.name]
            slot = one.name if about == REFINES else about
            if slot in self.given:
                both = (self.given[slot].name, one.name)
                raise Exclusive(both, f"contradict each other: both supply the {slot}")
            self.given[slot] = one

    def use(self, slot: str) -> Given | None:
        """Take a condition, so that it counts as used."""
        if slot in self.given:
            self.used.add(slot)
        return self.given.get(slot)

    def take(self, slot: str) -> Given:
        """Take a condition that is there."""
        self.used.add(slot)
        return self.given[slot]

    @property
    def unused(self) -> list[str]:
        """The symbols of what has no use."""
        return [one.name for slot, one in self.given.items() if slot not in self.used]
