"""All the laws there are: the data of the modules, and those that a function makes of a place."""

import importlib
import inspect
import pkgutil
from types import ModuleType
from typing import Any

from radcalc import calculators, laws
from radcalc.laws.law import AnyLaw, Law, Relation

MODULES: list[ModuleType] = [
    importlib.import_module(found.name)
    for room in (laws, calculators)
    for found in pkgutil.iter_modules(room.__path__, f"{room.__name__}.")
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
    """What a module's functions make of the symbol that says how far away something is."""
    return [
        function(away)
        for function in vars(module).values()
        if inspect.isfunction(function) and list(inspect.signature(function).parameters) == ["away"]
        for away in ("height", "distance")
    ]


def key(law: AnyLaw) -> tuple[str, str]:
    return law.name, law.template


FOUND = {
    key(law): law for module in MODULES for law in (*laws_in(vars(module)), *laws_made(module))
}
LAWS = [law for law in FOUND.values() if isinstance(law, Law)]
ALL_RELATIONS = [law for law in FOUND.values() if isinstance(law, Relation)]
ON_PAGES = {
    key(law)
    for module in MODULES
    if module.__name__.startswith(calculators.__name__)
    for law in laws_in({n: v for n, v in vars(module).items() if n == "LAWS"})
}
IN_LAWS = {
    key(law)
    for module in MODULES
    if module.__name__.startswith(laws.__name__)
    for law in (*laws_in(vars(module)), *laws_made(module))
}
# Those that one calculator alone uses stand on its page, with their numbers in its own tests.
RELATIONS = [law for law in ALL_RELATIONS if key(law) in IN_LAWS]
OF_PAGES = [law for law in ALL_RELATIONS if key(law) in ON_PAGES - IN_LAWS]
