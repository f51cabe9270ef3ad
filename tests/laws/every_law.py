"""All laws: the data of the modules, and those that functions make."""

import importlib
import inspect
import math
import pkgutil
from types import ModuleType
from typing import Any

from radcalc import calculators, laws
from radcalc.distributions.distribution import Pose
from radcalc.distributions.sources import Lobe
from radcalc.laws import AnyLaw, Law, Relation, beams

EXPONENT, ROTATE, BEARING = 3.0, 0.3, 1.0
MODULES: list[ModuleType] = [
    laws,
    *(
        importlib.import_module(found.name)
        for room in (laws, calculators)
        for found in pkgutil.iter_modules(room.__path__, f"{room.__name__}.")
    ),
]


def laws_in(data: Any) -> list[AnyLaw]:
    if isinstance(data, (Law, Relation)):
        return [data]
    if isinstance(data, dict):
        data = list(data.values())
    if isinstance(data, (list, tuple)):
        return [law for one in data for law in laws_in(one)]
    return []


def laws_made(module: ModuleType) -> list[AnyLaw]:
    """The laws that a module's functions make from the symbol of a distance."""
    return [
        function(away)
        for function in vars(module).values()
        if inspect.isfunction(function) and list(inspect.signature(function).parameters) == ["away"]
        for away in ("height", "distance")
    ]


def laws_of_a_distribution() -> list[AnyLaw]:
    """The laws that functions of `luminaire` make for a lobe that is rotated about its axis.

    Its exponent is `EXPONENT`; the receiver is towards `BEARING`, the edges of the beam at 45
    degrees from its axis.
    """
    lobe, pose = Lobe(EXPONENT), Pose(rotate=ROTATE)
    return [
        beams.part(lobe, lobe.flux().value),
        beams.relative_intensity(lobe),
        *beams.direction(pose, BEARING),
        beams.floor(lobe, pose, BEARING),
        beams.lying_disc(lobe, pose, BEARING),
        beams.facing_disc(lobe),
        beams.beam_diameter((-math.pi / 4, math.pi / 4), "height"),
    ]


def key(law: AnyLaw) -> tuple[str, str]:
    return law.name, law.template


FOUND = {
    key(law): law for module in MODULES for law in (*laws_in(vars(module)), *laws_made(module))
}
OF_A_DISTRIBUTION = laws_of_a_distribution()
FOUND |= {key(law): law for law in OF_A_DISTRIBUTION}
LAWS = [law for law in FOUND.values() if isinstance(law, Law)]
ALL_RELATIONS = [law for law in FOUND.values() if isinstance(law, Relation)]
ON_PAGES = {
    key(law)
    for module in MODULES
    if module.__name__.startswith(calculators.__name__)
    for law in laws_in({n: v for n, v in vars(module).items() if n in ("LAWS", "SIDES")})
}
IN_LAWS = {
    key(law)
    for module in MODULES
    if module.__name__.startswith(laws.__name__)
    for law in (*laws_in(vars(module)), *laws_made(module))
} | {key(law) for law in OF_A_DISTRIBUTION}
# Laws that only one calculator uses are on its page, and its own tests have their numbers.
RELATIONS = [law for law in ALL_RELATIONS if key(law) in IN_LAWS]
OF_PAGES = [law for law in ALL_RELATIONS if key(law) in ON_PAGES - IN_LAWS]
