"""Photons and spectra."""

from __future__ import annotations

import os
from typing import Any

from radcalc.api.arguments import require_texts, table_of
from radcalc.api.functions import calculate, of_page
from radcalc.api.keywords import Amount, Path
from radcalc.api.result import Result
from radcalc.calculators.photon import named
from radcalc.calculators.photon import photon as of_photon
from radcalc.calculators.spectrum import spectrum as of_spectrum
from radcalc.errors import MissingInput, mention
from radcalc.inputs.given import Inputs
from radcalc.spectra.files import read_text


@of_page("photon")
def photon(wavelength: Amount, **given: Any) -> Result:
    """
    Parameters
    ----------
    wavelength : Amount
        The wavelength in vacuum, or the frequency, the wavenumber or the energy.

    Examples
    --------
    >>> found = photon("555 nm")
    >>> print(found.photon_energy.round(4), found.luminous_efficacy)
    2.2339 electronvolt 683.002 lumen / watt
    """
    return calculate("photon", {"wavelength": wavelength, **given}, of_photon, adapt=_named)


@of_page("spectrum")
def spectrum(
    source: Path | Any, *, column: str | int | None = None, unit: str = "", **given: Any
) -> Result:
    """Compute the peak, width, efficacies, photons and colour of a spectrum.

    Parameters
    ----------
    source : str, path, data frame, series, or pair of arrays
        A name (``"D65"``, ``"LED-B3"``), ``"blackbody:2856K"``, ``"line:632.8nm"``, a file ...
        A data frame of pandas or Polars is read like a file with its titles; a series of pandas
        has the wavelengths as its index; a pair has the wavelengths and the values, each as
        numbers or as a quantity.
    column : str or int, optional
        The column of the values of a file or a data frame, by title or number.
    unit : str, optional
        The unit of the values: ``"W/m2/nm"`` ..., ``"relative"`` or ``"photons"``.

    Examples
    --------
    >>> found = spectrum("D65")
    >>> print(found.x.round(4), found.y.round(4))
    0.3127 dimensionless 0.329 dimensionless
    >>> lamp = spectrum(([400, 500, 600, 700], [1, 2, 2, 1]), unit="W/m2/nm")
    >>> print(lamp.irradiance)
    500.0 watt / metre ** 2
    """
    require_texts(unit=unit)
    texts = {"column": "" if column is None else str(column), "unit": unit}
    operands = {name: chosen for name, chosen in texts.items() if chosen}
    if isinstance(source, (str, os.PathLike)):
        text = os.fspath(source)
        chosen: Any = (text, *texts.values()) if operands else text
    else:
        chosen = read_text(*table_of(source), *texts.values())
    requested = ("ssi",) if given.get("reference") is not None else ()  # which it is for
    symbols = {"spectrum": chosen, **given}
    return calculate("spectrum", symbols, of_spectrum, operands, requested=requested)


def _named(inputs: Inputs) -> Inputs:
    """Name the operand by the quantity that it is; refuse its absence."""
    if "wavelength" not in inputs:
        raise MissingInput("the wavelength is missing", mention("{wavelength=555nm}"))
    return {**inputs, "wavelength": named(inputs["wavelength"])}
