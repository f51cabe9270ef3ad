"""Sizes of flat sources and receivers: lengths [m] and areas [m2].

- `RECTANGLE`: A = w l
- `CIRCLE`: A = pi R^2
- `DIAMETER`: D = 2 R
"""

from radcalc.laws.law import law

RECTANGLE = law("area of a rectangle", "{area} = {width} {length}")
CIRCLE = law("area of a circle", "{area} = pi {radius}^2")
DIAMETER = law("diameter", "{diameter} = 2 {radius}")
