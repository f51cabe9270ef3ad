"""The Python functions: texts, quantities and arrays in, quantities and assumptions out.

Elementwise functions also take Dask arrays: results that depend on them are Dask arrays, and an
invalid element raises its error when they are computed.
"""

from importlib import import_module
from typing import Any

# By module; the other functions are made from the pages.
MODULES = {
    "radcalc.api.conversion": ("convert", "explain", "factor"),
    "radcalc.api.geometry": ("direction", "integrate", "solid_angle"),
    "radcalc.api.homework": ("Verdict", "check"),
    "radcalc.api.lists": ("Listing", "TypicalValue", "examples", "typical"),
    "radcalc.api.logs": ("dose",),
    "radcalc.api.quantity": ("Quantity",),
    "radcalc.api.result": ("Result",),
    "radcalc.api.scene": ("scene",),
    "radcalc.api.sentence": ("ask",),
    "radcalc.api.sources": ("lambertian", "point_source", "uberlight"),
    "radcalc.api.spectra": ("photon", "spectrum"),
    "radcalc.api.surroundings": ("environment", "irradiance_map", "sky"),
    "radcalc.sentences.tasks": ("Task",),
    "radcalc.errors": (
        "ConditionError",
        "ConversionError",
        "NumberError",
        "RadcalcError",
        "UnitError",
        "UsageError",
    ),
}


def public(name: str) -> Any:
    """Return a function or a class by its public name."""
    for module, names in MODULES.items():
        if name in names:
            return getattr(import_module(module), name)
    from radcalc.api.pages import function

    return function(name)
