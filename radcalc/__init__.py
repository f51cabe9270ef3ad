"""Radiometry, photometry, photons and their geometry: a calculator and unit converter.

The public API is loaded when it is first used; `import radcalc` costs nothing.

>>> import radcalc
>>> print(radcalc.convert("100 lx", "fc"))
9.290304 footcandle
"""

from radcalc._version import __version__

TYPE_CHECKING = False  # typing.TYPE_CHECKING, without the cost of importing typing
if TYPE_CHECKING:
    from typing import Any

    from radcalc.api.conversion import convert, explain, factor
    from radcalc.api.geometry import direction, etendue, solid_angle
    from radcalc.api.homework import Verdict, check
    from radcalc.api.instruments import calorimeter, ev, laser, room, screen, sensor
    from radcalc.api.quantity import Quantity
    from radcalc.api.result import Result
    from radcalc.api.sources import lambertian, point_source, scene, uberlight
    from radcalc.api.spectra import mesopic, photon, spectrum
    from radcalc.api.surroundings import environment, irradiance_map, reproject, sky
    from radcalc.errors import (
        ConditionError,
        ConversionError,
        NumberError,
        RadcalcError,
        UnitError,
        UsageError,
    )

ERRORS = (
    "ConditionError",
    "ConversionError",
    "NumberError",
    "RadcalcError",
    "UnitError",
    "UsageError",
)
__all__ = [
    "ConditionError",
    "ConversionError",
    "NumberError",
    "Quantity",
    "RadcalcError",
    "Result",
    "UnitError",
    "UsageError",
    "Verdict",
    "__version__",
    "calorimeter",
    "check",
    "convert",
    "direction",
    "environment",
    "etendue",
    "ev",
    "explain",
    "factor",
    "irradiance_map",
    "lambertian",
    "laser",
    "mesopic",
    "photon",
    "point_source",
    "reproject",
    "room",
    "scene",
    "screen",
    "sensor",
    "sky",
    "solid_angle",
    "spectrum",
    "uberlight",
]


if not TYPE_CHECKING:  # which knows every name, and no others

    def __getattr__(name: str) -> "Any":
        if name in ERRORS:
            from radcalc import errors

            return getattr(errors, name)
        if name in __all__:
            from radcalc import api

            return getattr(api, name)
        raise AttributeError(f"module 'radcalc' has no attribute '{name}'")


def __dir__() -> "list[str]":
    return [*globals(), *__all__]
