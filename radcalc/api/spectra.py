"""Photons, spectra and what the eye makes of them."""

from __future__ import annotations

import os
from typing import Any

from radcalc.api.calculate import calculate
from radcalc.api.keywords import Amount, Number, Observer, Path, Text
from radcalc.api.result import Result
from radcalc.api.spelling import in_python
from radcalc.errors import ConditionError, MissingInput, mention
from radcalc.given import Given, Inputs, read


def photon(
    wavelength: Amount,
    *,
    observer: Observer | None = None,
) -> Result:
    """The wavelength, frequency, wavenumber and energy of a photon, and what is seen of it.

    Parameters
    ----------
    wavelength : Amount
        The wavelength in vacuum, or the frequency, the wavenumber or the energy.
    observer : Observer, optional
        Whose eyes the luminous efficiency is for.

    Returns
    -------
    Result
        What was given and what follows, as attributes by the names of ``radcalc -g``.

    Raises
    ------
    radcalc.RadcalcError
        What is missing, contradictory, impossible or without use.

    Examples
    --------
    >>> found = photon("555 nm")
    >>> print(found.photon_energy.round(4), found.luminous_efficacy)
    2.2339 electronvolt 683.002 lumen / watt
    """
    given = locals()
    from radcalc.calculators.photon import named
    from radcalc.calculators.photon import photon as work_out

    return calculate(
        "photon",
        given,
        work_out,
        waits=False,
        singly=True,
        called=lambda inputs: {**inputs, "wavelength": named(_wave_of(inputs))},
    )


def spectrum(
    source: Path,
    *,
    observer: Observer | None = None,
    range: Text = None,
    photon_range: Text = None,
    column: str | int | None = None,
) -> Result:
    """The peak, width, efficacies, photons and colour of a spectrum.

    Parameters
    ----------
    source : str or path
        A name (``"D65"``, ``"LED-B3"``), ``"blackbody:2856K"``, ``"line:632.8nm"``, a file ...
    observer : Observer, optional
        Whose eyes the luminous efficacy is for.
    range : Text, optional
        Where watts are counted.
    photon_range : Text, optional
        Where photons are counted.
    column : str or int, optional
        The column of a file's values, by its title or its number.

    Returns
    -------
    Result
        What was given and what follows, as attributes by the names of ``radcalc -g``.

    Raises
    ------
    radcalc.RadcalcError
        What is missing, contradictory, impossible or without use.

    Examples
    --------
    >>> found = spectrum("D65")
    >>> print(found.x.round(4), found.y.round(4))
    0.3127 dimensionless 0.329 dimensionless
    """
    given = locals()
    return _spectrum(given)


def mesopic(
    *,
    luminance: Amount = None,
    sp_ratio: Number = None,
    spectrum: Text = None,
    mesopic_luminance: Amount = None,
    scotopic_luminance: Amount = None,
) -> Result:
    """Mesopic luminance by CIE 191:2010.

    Parameters
    ----------
    luminance : Amount, optional
        The photopic luminance. [cd/m2]
    sp_ratio : Number, optional
        The light's ratio of scotopic to photopic.
    spectrum : Text, optional
        A spectrum, for its S/P ratio.
    mesopic_luminance : Amount, optional
        The luminance that the half-adapted eye sees. [cd/m2]
    scotopic_luminance : Amount, optional
        The luminance as the dark-adapted eye sees it. [cd/m2]

    Returns
    -------
    Result
        What was given and what follows, as attributes by the names of ``radcalc -g``.

    Raises
    ------
    radcalc.RadcalcError
        What is missing, contradictory, impossible or without use.

    Examples
    --------
    >>> print(mesopic(luminance="0.1 cd/m2", sp_ratio=2).mesopic_luminance.round(4))
    0.131 candela / metre ** 2
    """
    given = locals()
    from radcalc.calculators.mesopic import mesopic as work_out

    return calculate("mesopic", given, work_out, waits=False, singly=True)


def _wave_of(inputs: Inputs) -> Given:
    """What was given for the wavelength, which has to be there."""
    if "wavelength" not in inputs:
        raise MissingInput("the wavelength is missing", mention("{wavelength=555nm}"))
    return inputs["wavelength"]


@in_python
def _spectrum(given: dict[str, Any]) -> Result:
    from radcalc.calculators.spectrum import spectrum as work_out
    from radcalc.spectra.sources import spectrum as read_source

    text, column = given["source"], given["column"]
    if not isinstance(text, (str, os.PathLike)):
        raise ConditionError(f"a spectrum is a text, not a {type(text).__name__}", '"D65"')
    text = os.fspath(text)
    source = read("spectrum", text, uncertain=True)
    if column is not None:
        source = source._replace(value=read_source(text, str(column)))
    return calculate(
        "spectrum",
        given,
        work_out,
        operands={"column": "" if column is None else str(column)},
        own=("source",),
        waits=False,
        called=lambda inputs: {"spectrum": source, **inputs},
    )
