"""Light measured by its heat in a body that loses no heat.

Specific heat capacity, flux and irradiance are constant.  Watts and joules only: the heat of lumens
and photons depends on their spectrum.
"""

from radcalc.laws.energy import ENERGY
from radcalc.laws.law import AnyLaw, law

LAWS: list[AnyLaw] = [
    law("heat of a body", "{heat} = {mass} {specific-heat} {temperature-rise}"),
    law("absorbed light", "{heat} = {absorptance} {energy}", "ISO 80000-7, absorptance"),
    ENERGY,
    law("flux on a receiver", "{flux} = {irradiance} {receiver-area}"),
]
