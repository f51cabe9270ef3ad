"""All the laws there are: those in the modules' data, and those that a shape adds."""

from typing import Any

import pytest

from radcalc import lambertian, point_source
from radcalc.calculators import calorimeter as calorimeter_module
from radcalc.calculators import ev as ev_module
from radcalc.calculators import lambertian as lambertian_module
from radcalc.calculators import point_source as point_module
from radcalc.calculators import shapes as surfaces_module
from radcalc.calculators import worksheet as sheet_module
from radcalc.laws import point as spreads_module
from radcalc.laws.law import Law, Relation, solve

MODULES = (
    spreads_module,
    surfaces_module,
    point_module,
    lambertian_module,
    ev_module,
    calorimeter_module,
    sheet_module,
)


def laws_in(data: Any) -> list[Law | Relation]:
    if isinstance(data, (Law, Relation)):
        return [data]
    if isinstance(data, dict):
        data = list(data.values())
    if isinstance(data, (list, tuple)):
        return [law for one in data for law in laws_in(one)]
    return []


def laws_added() -> list[Law | Relation]:
    """What the sheets solve for every shape and place; not all of it is data of a module."""
    caught: list[Law | Relation] = []

    def catch(laws, known):
        caught.extend(laws)
        return solve(laws, known)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(sheet_module, "solve", catch)
        for extra in ({"half_angle": "1rad"}, {"exponent": 2}, {}):
            point_source(intensity="1cd", height="1m", offset="1m", **extra)
        lambertian(luminance="1cd/m2", diameter="1cm", distance="1m")
        lambertian(luminance="1cd/m2", width="1cm", length="1cm")
        lambertian("rectangle", luminance="1cd/m2", width="1m", length="1m")
        for shape in ("disc", "sphere"):
            lambertian(shape, luminance="1cd/m2", diameter="1m", distance="2m")
            lambertian(shape, luminance="1cd/m2", illuminance="1lx", distance="2m")
    return caught


FOUND = laws_in([vars(module) for module in MODULES]) + laws_added()
LAWS = list({law.name + law.template: law for law in FOUND if isinstance(law, Law)}.values())
RELATIONS = list({r.name + r.template: r for r in FOUND if isinstance(r, Relation)}.values())
