"""The energy and the exposure of light that is constant over a time (ISO 80000-7)."""

from radcalc.laws.law import law

ENERGY = law("energy", "{energy} = {flux} {time}")
EXPOSURE = law("exposure", "{exposure} = {irradiance} {time}")
