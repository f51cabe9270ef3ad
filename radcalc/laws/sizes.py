"""Sizes of flat sources and receivers."""

from radcalc.laws.law import law

RECTANGLE = law("area of a rectangle", "{area} = {width} {length}")
CIRCLE = law("area of a circle", "{area} = pi {radius}^2")
DIAMETER = law("diameter", "{diameter} = 2 {radius}")
