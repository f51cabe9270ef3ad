"""The Python functions: texts, quantities and arrays in, quantities and assumptions out.

Elementwise functions also take Dask arrays: results that depend on them are Dask arrays, and an
invalid element raises its error when they are computed.
"""

from importlib import import_module
from typing import Any

# By module; the other functions are made from the pages.
MODULES = {
    "radcalc.api.arguments": ("Quantity",),
    "radcalc.api.calculators": (
        "Listing",
        "TypicalValue",
        "Verdict",
        "ask",
        "check",
        "define",
        "direction",
        "environment",
        "examples",
        "integrate",
        "irradiance_map",
        "lambertian",
        "photon",
        "point_source",
        "scene",
        "sky",
        "solid_angle",
        "spectrum",
        "typical",
        "uberlight",
    ),
    "radcalc.api.conversion": ("convert", "explain", "factor"),
    "radcalc.api.logs": ("dose",),
    "radcalc.api.result": ("Result",),
    "radcalc.quantities.lookup": ("Task",),
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
    from radcalc.api.functions import function

    return function(name)
