"""Radiometry, photometry, photons and their geometry: a calculator and unit converter.

The public API is loaded when it is first used; `import radcalc` costs nothing.

>>> import radcalc
>>> print(radcalc.convert("100 lx", "fc"))
9.290304 footcandle
"""

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
    "ask",
    "calorimeter",
    "check",
    "convert",
    "direction",
    "dose",
    "environment",
    "etendue",
    "ev",
    "examples",
    "explain",
    "factor",
    "integrate",
    "irradiance_map",
    "lambertian",
    "laser",
    "mesopic",
    "photon",
    "point_source",
    "refraction",
    "reproject",
    "room",
    "scene",
    "screen",
    "sensor",
    "sky",
    "solid_angle",
    "spectrum",
    "typical",
    "uberlight",
]


def __getattr__(name: str) -> object:
    if name == "__version__":
        from radcalc import _version

        return _version.__version__
    if name in __all__:
        from radcalc.api import public

        return public(name)
    import sys

    frame = sys._getframe(1)
    is_import = frame.f_code.co_name == "_handle_fromlist" or f"radcalc.{name}" in sys.modules
    if name[:1] == "_" or is_import:  # of a module
        raise AttributeError(f"module 'radcalc' has no attribute '{name}'")
    from radcalc.api import unknown

    raise unknown.error(name, frame)


def __dir__() -> "list[str]":
    return __all__
