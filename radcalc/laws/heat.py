"""Light measured by the heat that it leaves in a body."""

from radcalc.laws.energy import ENERGY
from radcalc.laws.law import AnyLaw, law

LAWS: list[AnyLaw] = [
    law("heat of a body", "{heat} = {mass} {specific-heat} {temperature-rise}"),
    law("absorbed light", "{heat} = {absorptance} {energy}", "ISO 80000-7, absorptance"),
    ENERGY,
    law("flux on a receiver", "{flux} = {irradiance} {receiver-area}"),
]
