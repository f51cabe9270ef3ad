"""Light measured by the heat that it leaves in a body."""

from radcalc.laws.energy import ENERGY
from radcalc.laws.law import AnyLaw, Law

LAWS: list[AnyLaw] = [
    Law(
        "heat of a body",
        "{heat} = {mass} {specific-heat} {temperature-rise}",
        "heat",
        (("mass", 1), ("specific-heat", 1), ("temperature-rise", 1)),
    ),
    Law(
        "absorbed light",
        "{heat} = {absorptance} {energy}",
        "heat",
        (("absorptance", 1), ("energy", 1)),
        reference="ISO 80000-7, absorptance",
    ),
    ENERGY,
    Law(
        "flux on a receiver",
        "{flux} = {irradiance} {receiver-area}",
        "flux",
        (("irradiance", 1), ("receiver-area", 1)),
    ),
]
