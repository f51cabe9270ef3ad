"""Colour temperature and colour rendering, through colour-science, loaded only when asked for."""

import warnings
from collections.abc import Sequence
from typing import Any


def load_colour() -> Any:
    """colour-science, without its warnings of packages that are missing.

    Importing it changes how NumPy prints arrays in the whole process: that is undone.
    """
    import numpy

    with warnings.catch_warnings(), numpy.printoptions():
        warnings.simplefilter("ignore")
        import colour
    return colour


def temperature_and_distance(x: float, y: float) -> tuple[float, float]:
    """Correlated colour temperature [K] and Duv of a chromaticity (Ohno 2013)."""
    colour = load_colour()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        uv = colour.UCS_to_uv(colour.XYZ_to_UCS(colour.xy_to_XYZ([x, y])))
        cct, duv = colour.temperature.uv_to_CCT_Ohno2013(uv)
    return float(cct), float(duv)


def colour_rendering_index(wavelengths: Sequence[float], values: Sequence[float]) -> float:
    """The general colour rendering index Ra (CIE 1995) of a spectrum."""
    colour = load_colour()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        table = colour.SpectralDistribution(dict(zip(wavelengths, values, strict=True)))
        return float(colour.colour_rendering_index(table))
