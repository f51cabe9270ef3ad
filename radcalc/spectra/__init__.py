"""Observers and sources, which link watts, lumens and photons.

`radcalc.spectra.luminous` and `radcalc.spectra.luminous_efficacy` serve whole arrays of spectra;
they load NumPy at their first use.
"""

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from radcalc.spectra.arrays import luminous, luminous_efficacy

__all__ = ["luminous", "luminous_efficacy"]


def __getattr__(name: str) -> "Any":
    if name in __all__:
        from radcalc.spectra import arrays

        return getattr(arrays, name)
    raise AttributeError(f"module 'radcalc.spectra' has no attribute '{name}'")
