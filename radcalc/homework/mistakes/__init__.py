"""The usual mistakes, one module a family."""

from radcalc.homework.catalogue import Mistake
from radcalc.homework.mistakes import angles, distances, kinds, meter, pi, shapes, slips

FAMILIES = (pi, angles, distances, shapes, kinds, meter, slips)
MISTAKES = [one for family in FAMILIES for one in vars(family).values() if isinstance(one, Mistake)]
