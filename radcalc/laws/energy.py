"""What a light that is constant over a time t [s] adds up to.

- `ENERGY`: Q = Phi t, radiant [J], luminous [lm s] or photons [photon]
- `EXPOSURE`: H = E t, [J/m2], [lx s] or [photon/m2]

Source: ISO 80000-7 (radiant energy, radiant exposure), of which these are the integrals over a
time in which nothing changes.
"""

from radcalc.laws.law import law

ENERGY = law("energy", "{energy} = {flux} {time}")
EXPOSURE = law("exposure", "{exposure} = {irradiance} {time}")
