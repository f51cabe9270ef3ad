"""Photons and spectra."""

from __future__ import annotations

import os
from typing import Any

from radcalc.api.calculate import calculate
from radcalc.api.keywords import Amount, Path
from radcalc.api.pages import of_page
from radcalc.api.result import Result
from radcalc.calculators.photon import named
from radcalc.calculators.photon import photon as of_photon
from radcalc.calculators.spectrum import spectrum as of_spectrum
from radcalc.errors import ConditionError, MissingInput, mention
from radcalc.inputs.given import Inputs
from radcalc.spectra.sources import spectrum as read_source


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
def spectrum(source: Path, *, column: str | int | None = None, **given: Any) -> Result:
    """Compute the peak, width, efficacies, photons and colour of a spectrum.

    Parameters
    ----------
    source : str or path
        A name (``"D65"``, ``"LED-B3"``), ``"blackbody:2856K"``, ``"line:632.8nm"``, a file ...
    column : str or int, optional
        The column of a file's values, by title or number.

    Examples
    --------
    >>> found = spectrum("D65")
    >>> print(found.x.round(4), found.y.round(4))
    0.3127 dimensionless 0.329 dimensionless
    """
    if not isinstance(source, (str, os.PathLike)):
        raise ConditionError(f"a spectrum is a text, not a {type(source).__name__}", '"D65"')
    text = os.fspath(source)

    def of_column(inputs: Inputs) -> Inputs:
        read = inputs["spectrum"]._replace(value=read_source(text, str(column)))
        return {**inputs, "spectrum": read}

    operands, adapt = ({"column": str(column)}, of_column) if column is not None else ({}, None)
    return calculate("spectrum", {"spectrum": text, **given}, of_spectrum, operands, adapt=adapt)


def _named(inputs: Inputs) -> Inputs:
    """Name the operand by the quantity that it is; refuse its absence."""
    if "wavelength" not in inputs:
        raise MissingInput("the wavelength is missing", mention("{wavelength=555nm}"))
    return {**inputs, "wavelength": named(inputs["wavelength"])}
