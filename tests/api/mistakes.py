"""Program that uses radcalc with six mistakes; mypy reports each of them."""

import radcalc

radcalc.point_source(flux="800 lm", distanse="2 m")  # mistake: no such keyword
radcalc.point_source(flux="800 lm", distance=2.0)  # mistake: a length without a unit
radcalc.point_source("800 lm", 2.0)  # mistake: a number without a keyword
radcalc.lambertian("disk", luminance="1 cd/m2")  # mistake: no such shape
radcalc.convert("800 lm", "cd", isotropic="yes")  # mistake: a flag is true or false
lux: str = radcalc.convert("1 fc", "lx")  # mistake: the result is a quantity
