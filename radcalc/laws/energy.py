"""What a constant light adds up to over a time."""

from radcalc.laws.law import law

ENERGY = law("energy", "{energy} = {flux} {time}")
EXPOSURE = law("exposure", "{exposure} = {irradiance} {time}")
