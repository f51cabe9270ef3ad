"""Light measured by its heat in a body that loses no heat.

- heat of a body: Q_h = m c dT, with the specific heat capacity c [J/(kg K)] constant over the
  rise of temperature dT [K]
- absorbed light: Q_h = alpha Q, with the absorptance alpha from 0 to 1 (ISO 80000-7, absorptance)
- energy: Q = Phi t, with a constant flux
- flux on a receiver: Phi = E A_r, with a uniform irradiance

Watts and joules only: the heat of lumens and photons depends on their spectrum.
"""

from radcalc.laws.energy import ENERGY
from radcalc.laws.law import AnyLaw, law

LAWS: list[AnyLaw] = [
    law("heat of a body", "{heat} = {mass} {specific-heat} {temperature-rise}"),
    law("absorbed light", "{heat} = {absorptance} {energy}", "ISO 80000-7, absorptance"),
    ENERGY,
    law("flux on a receiver", "{flux} = {irradiance} {receiver-area}"),
]
