"""What a constant light adds up to over a time."""

from radcalc.laws.law import Law

ENERGY = Law("energy", "{energy} = {flux} {time}", "energy", (("flux", 1), ("time", 1)))
EXPOSURE = Law(
    "exposure", "{exposure} = {irradiance} {time}", "exposure", (("irradiance", 1), ("time", 1))
)
