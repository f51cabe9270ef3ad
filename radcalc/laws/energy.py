"""The energy and the exposure of light that is constant over a time t [s].

- `ENERGY`: Q = Phi t, radiant [J], luminous [lm s] or photons [photon]
- `EXPOSURE`: H = E t, [J/m2], [lx s] or [photon/m2]

Source: ISO 80000-7 (radiant energy, radiant exposure), with the integrals over a time at constant
flux and irradiance.
"""

from radcalc.laws.law import law

ENERGY = law("energy", "{energy} = {flux} {time}")
EXPOSURE = law("exposure", "{exposure} = {irradiance} {time}")
