"""Cameras, meters, screens, lasers and rooms."""

from __future__ import annotations

from radcalc.api.calculate import calculate
from radcalc.api.keywords import Amount, Number, Observer, Profile, Text
from radcalc.api.result import Result


def ev(
    *,
    ev100: Number = None,
    luminance: Amount = None,
    illuminance: Amount = None,
    ev: Number = None,
    f_number: Number = None,
    time: Amount = None,
    iso: Number = None,
    nd: Number = None,
    stops: Number = None,
    unfiltered_time: Amount = None,
    guide_number: Amount = None,
    distance: Amount = None,
    k: Amount = None,
    c: Amount = None,
) -> Result:
    """Exposure values, and the light that a meter shows them for.

    Parameters
    ----------
    ev100 : Number, optional
        Exposure value at ISO 100, of the light.
    luminance : Amount, optional
        Luminance of the scene. [cd/m2]
    illuminance : Amount, optional
        Illuminance on the scene. [lx]
    ev : Number, optional
        Exposure value, of f-number and time.
    f_number : Number, optional
        The lens's f-number.
    time : Amount, optional
        Exposure time, with any filter. [s]
    iso : Number, optional
        Speed of the film or sensor (100).
    nd : Number, optional
        Density of a neutral filter in front of the lens: 0.9, or ND8 for a factor of 8.
    stops : Number, optional
        How many stops the filter takes.
    unfiltered_time : Amount, optional
        Exposure time without the filter. [s]
    guide_number : Amount, optional
        Guide number of a flash, at ISO 100. [m]
    distance : Amount, optional
        Distance from the flash to what it lights. [m]
    k : Amount, optional
        The meter's constant for reflected light (12.5 cd s/m2). [cd s/m2]
    c : Amount, optional
        The meter's constant for incident light (250 lx s). [lx s]

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
    >>> print(ev(ev100=15).luminance)
    4096.0 candela / metre ** 2
    """
    given = locals()
    from radcalc.calculators.ev import ev as work_out

    return calculate("ev", given, work_out)


def calorimeter(
    *,
    flux: Amount = None,
    radiant_flux: Amount = None,
    energy: Amount = None,
    radiant_energy: Amount = None,
    irradiance: Amount = None,
    mass: Amount = None,
    specific_heat: Amount = None,
    temperature_rise: Amount = None,
    absorptance: Number = None,
    receiver_area: Amount = None,
    time: Amount = None,
) -> Result:
    """The radiant flux that heats a body, or how warm a flux makes it.

    Parameters
    ----------
    flux, radiant_flux : Amount, optional
        The flux on the body. [W]
    energy, radiant_energy : Amount, optional
        The energy that reaches the body (with `time`). [J]
    irradiance : Amount, optional
        The irradiance on the body (with `receiver_area`). [W/m2]
    mass : Amount, optional
        Mass of the body that is heated. [kg]
    specific_heat : Amount, optional
        Its specific heat capacity. [J/kg/K]
    temperature_rise : Amount, optional
        How much warmer it gets. [K]
    absorptance : Number, optional
        The part of the light that it absorbs (1).
    receiver_area : Amount, optional
        The area that the light falls on. [m2]
    time : Amount, optional
        How long it is in the light. [s]

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
    >>> found = calorimeter(
    ...     mass="10 g", specific_heat="385 J/kg/K", temperature_rise="2 K", time="30 s"
    ... )
    >>> print(found.radiant_flux.to("mW").round(3))
    256.667 milliwatt
    """
    given = locals()
    from radcalc.calculators.calorimeter import calorimeter as work_out

    return calculate("calorimeter", given, work_out)


def screen(
    *,
    flux: Amount = None,
    radiant_flux: Amount = None,
    luminous_flux: Amount = None,
    photon_flux: Amount = None,
    irradiance: Amount = None,
    illuminance: Amount = None,
    photon_irradiance: Amount = None,
    radiance: Amount = None,
    luminance: Amount = None,
    photon_radiance: Amount = None,
    width: Amount = None,
    height: Amount = None,
    diagonal: Amount = None,
    aspect: Number = None,
    area: Amount = None,
    gain: Number = None,
    wavelength: Amount = None,
    spectrum: Text = None,
    efficacy: Amount = None,
    observer: Observer | None = None,
    range: Text = None,
    photon_range: Text = None,
) -> Result:
    """The light of a picture, from the projector's flux, its size and the screen's gain.

    Parameters
    ----------
    flux, radiant_flux, luminous_flux, photon_flux : Amount, optional
        All the flux. [W, lm, umol/s]
    irradiance, illuminance, photon_irradiance : Amount, optional
        The irradiance on the receiver. [W/m2, lx, umol/m2/s]
    radiance, luminance, photon_radiance : Amount, optional
        The uniform radiance of the source. [W/m2/sr, cd/m2, umol/m2/s/sr]
    width : Amount, optional
        Width of the picture. [m]
    height : Amount, optional
        Height of the picture. [m]
    diagonal : Amount, optional
        Diagonal of the picture. [m]
    aspect : Number, optional
        Width of the picture over its height.
    area : Amount, optional
        Area of the picture. [m2]
    gain : Number, optional
        Gain of the screen, over a perfect diffuser (1).
    wavelength : Amount, optional
        Light of one wavelength (or frequency, wavenumber, photon energy). [nm]
    spectrum : Text, optional
        Light of that spectrum: a name, blackbody:2856K, line:632.8nm, a file ...
    efficacy : Amount, optional
        A given ratio of two kinds: 93lm/W, 2.1umol/J, 54lm.s/umol. [lm/W]
    observer : Observer, optional
        Whose eyes see `wavelength` or `spectrum`.
    range : Text, optional
        Where the watts of `spectrum` are counted.
    photon_range : Text, optional
        Where the photons of `spectrum` are counted (default 400nm:700nm).

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
    >>> print(screen(flux="2000 lm", width="2 m", aspect="4/3", gain=1.2).luminance.round(3))
    254.648 candela / metre ** 2
    """
    given = locals()
    from radcalc.calculators.screen import screen as work_out

    return calculate("screen", given, work_out)


def sensor(
    *,
    radiance: Amount = None,
    luminance: Amount = None,
    photon_radiance: Amount = None,
    irradiance: Amount = None,
    illuminance: Amount = None,
    photon_irradiance: Amount = None,
    exposure: Amount = None,
    radiant_exposure: Amount = None,
    luminous_exposure: Amount = None,
    photon_exposure: Amount = None,
    flux: Amount = None,
    radiant_flux: Amount = None,
    luminous_flux: Amount = None,
    photon_flux: Amount = None,
    energy: Amount = None,
    radiant_energy: Amount = None,
    luminous_energy: Amount = None,
    photon_number: Amount = None,
    f_number: Number = None,
    working_f_number: Number = None,
    magnification: Number = None,
    off_axis_angle: Amount = None,
    transmittance: Number = None,
    etendue: Amount = None,
    pixel_pitch: Amount = None,
    pixel_area: Amount = None,
    time: Amount = None,
    photons: Amount = None,
    quantum_efficiency: Number = None,
    responsivity: Amount = None,
    electrons: Number = None,
    current: Amount = None,
    snr: Number = None,
    wavelength: Amount = None,
    spectrum: Text = None,
    efficacy: Amount = None,
    observer: Observer | None = None,
    range: Text = None,
    photon_range: Text = None,
) -> Result:
    """The light that a lens sends to a sensor, its photons, electrons and current.

    Parameters
    ----------
    radiance, luminance, photon_radiance : Amount, optional
        The radiance of the scene. [W/m2/sr, cd/m2, umol/m2/s/sr]
    irradiance, illuminance, photon_irradiance : Amount, optional
        The irradiance of the sensor. [W/m2, lx, umol/m2/s]
    exposure, radiant_exposure, luminous_exposure, photon_exposure : Amount, optional
        The exposure of the sensor (with `time`). [J/m2, lx s, umol/m2]
    flux, radiant_flux, luminous_flux, photon_flux : Amount, optional
        The flux on a pixel, or on the detector. [W, lm, umol/s]
    energy, radiant_energy, luminous_energy, photon_number : Amount, optional
        The energy on a pixel (with `time`). [J, lm s, umol]
    f_number : Number, optional
        The lens's f-number.
    working_f_number : Number, optional
        The f-number at the magnification.
    magnification : Number, optional
        Size of the image over that of the scene (0).
    off_axis_angle : Amount, optional
        Angle between the lens's axis and what is seen (0). [deg]
    transmittance : Number, optional
        The part of the light that the lens lets through (1).
    etendue : Amount, optional
        Etendue of the light on a pixel. [m2 sr]
    pixel_pitch : Amount, optional
        Width and height of a square pixel. [um]
    pixel_area : Amount, optional
        Area of a pixel, or of another detector. [um2]
    time : Amount, optional
        Exposure time. [s]
    photons : Amount, optional
        Photons on a pixel. [photon]
    quantum_efficiency : Number, optional
        Electrons per photon.
    responsivity : Amount, optional
        Current that the detector gives per watt of light on it. [A/W]
    electrons : Number, optional
        Electrons that the photons set free.
    current : Amount, optional
        Current that the light makes in the detector. [A]
    snr : Number, optional
        Signal over its shot noise, the root of the electrons.
    wavelength : Amount, optional
        Light of one wavelength (or frequency, wavenumber, photon energy). [nm]
    spectrum : Text, optional
        Light of that spectrum: a name, blackbody:2856K, line:632.8nm, a file ...
    efficacy : Amount, optional
        A given ratio of two kinds: 93lm/W, 2.1umol/J, 54lm.s/umol. [lm/W]
    observer : Observer, optional
        Whose eyes see `wavelength` or `spectrum`.
    range : Text, optional
        Where the watts of `spectrum` are counted.
    photon_range : Text, optional
        Where the photons of `spectrum` are counted (as the watts).

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
    >>> found = sensor(luminance="4000 cd/m2", f_number=16, time="10 ms")
    >>> print(found.illuminance.round(3), found.exposure.round(4))
    12.272 lux 0.1227 lux * second
    """
    given = locals()
    from radcalc.calculators.sensor import sensor as work_out

    return calculate("sensor", given, work_out)


def laser(
    *,
    diameter: Amount = None,
    divergence: Amount = None,
    profile: Profile | None = None,
    flux: Amount = None,
    radiant_flux: Amount = None,
    luminous_flux: Amount = None,
    photon_flux: Amount = None,
    energy: Amount = None,
    radiant_energy: Amount = None,
    luminous_energy: Amount = None,
    photon_number: Amount = None,
    irradiance: Amount = None,
    illuminance: Amount = None,
    photon_irradiance: Amount = None,
    peak_irradiance: Amount = None,
    peak_illuminance: Amount = None,
    peak_photon_irradiance: Amount = None,
    exposure: Amount = None,
    radiant_exposure: Amount = None,
    luminous_exposure: Amount = None,
    photon_exposure: Amount = None,
    distance: Amount = None,
    spot_diameter: Amount = None,
    time: Amount = None,
    receiver_diameter: Amount = None,
    limit: Amount = None,
    irradiance_limit: Amount = None,
    illuminance_limit: Amount = None,
    photon_irradiance_limit: Amount = None,
    hazard_distance: Amount = None,
    wavelength: Amount = None,
    spectrum: Text = None,
    efficacy: Amount = None,
    observer: Observer | None = None,
    range: Text = None,
    photon_range: Text = None,
) -> Result:
    """The spot of a laser beam, and its hazard distance.

    Parameters
    ----------
    diameter : Amount, optional
        Diameter of the beam at the laser's exit. [m]
    divergence : Amount, optional
        Full angle by which the beam spreads. [mrad]
    profile : Profile, optional
        Gaussian, with diameters where 1/e^2 of the peak is left (by default), or uniform.
    flux, radiant_flux, luminous_flux, photon_flux : Amount, optional
        The flux of the beam, or within a pulse. [W, lm, umol/s]
    energy, radiant_energy, luminous_energy, photon_number : Amount, optional
        The energy of a pulse, or of the beam in the `time`. [J, lm s, umol]
    irradiance, illuminance, photon_irradiance : Amount, optional
        The flux over the area of the spot. [W/m2, lx, umol/m2/s]
    peak_irradiance, peak_illuminance, peak_photon_irradiance : Amount, optional
        The irradiance on the axis, where it is greatest. [W/m2, lx, umol/m2/s]
    exposure, radiant_exposure, luminous_exposure, photon_exposure : Amount, optional
        The exposure of the spot (with `time`). [J/m2, lx s, umol/m2]
    distance : Amount, optional
        Distance from the laser's exit, where the spot is without it. [m]
    spot_diameter : Amount, optional
        Diameter of the spot at the distance. [mm]
    time : Amount, optional
        How long the flux is constant: a pulse, or an exposure. [s]
    receiver_diameter : Amount, optional
        Diameter of a round receiver about the beam's axis: a pupil, a sensor. [m]
    limit, irradiance_limit, illuminance_limit, photon_irradiance_limit : Amount, optional
        A limit of the peak, from the standard (with `hazard_distance`). [W/m2, lx, umol/m2/s]
    hazard_distance : Amount, optional
        Distance beyond which the peak irradiance is below the limit. [m]
    wavelength : Amount, optional
        Light of one wavelength (or frequency, wavenumber, photon energy). [nm]
    spectrum : Text, optional
        Light of that spectrum: a name, blackbody:2856K, line:632.8nm, a file ...
    efficacy : Amount, optional
        A given ratio of two kinds: 93lm/W, 2.1umol/J, 54lm.s/umol. [lm/W]
    observer : Observer, optional
        Whose eyes see `wavelength` or `spectrum`.
    range : Text, optional
        Where the watts of `spectrum` are counted.
    photon_range : Text, optional
        Where the photons of `spectrum` are counted (default 400nm:700nm).

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
    >>> beam = laser(flux="5 mW", diameter="1 mm", divergence="1 mrad", limit="25 W/m2")
    >>> print(beam.hazard_distance.round(4))
    22.5454 metre
    """
    given = locals()
    from radcalc.calculators.laser import laser as work_out

    return calculate("laser", given, work_out)


def room(
    *,
    width: Amount = None,
    length: Amount = None,
    area: Amount = None,
    height: Amount = None,
    room_index: Number = None,
    irradiance: Amount = None,
    illuminance: Amount = None,
    photon_irradiance: Amount = None,
    flux: Amount = None,
    radiant_flux: Amount = None,
    luminous_flux: Amount = None,
    photon_flux: Amount = None,
    luminaires: Number = None,
    utilance: Number = None,
    maintenance: Number = None,
    wavelength: Amount = None,
    spectrum: Text = None,
    efficacy: Amount = None,
    observer: Observer | None = None,
    range: Text = None,
    photon_range: Text = None,
) -> Result:
    """The luminaires of a room, its index and illuminance.

    Parameters
    ----------
    width : Amount, optional
        Width of the room. [m]
    length : Amount, optional
        Length of the room. [m]
    area : Amount, optional
        Area of the room. [m2]
    height : Amount, optional
        Height of the luminaires above the working plane. [m]
    room_index : Number, optional
        The room's area over half its walls' from the working plane up to the luminaires.
    irradiance, illuminance, photon_irradiance : Amount, optional
        The mean irradiance of the working plane. [W/m2, lx, umol/m2/s]
    flux, radiant_flux, luminous_flux, photon_flux : Amount, optional
        The flux of one luminaire. [W, lm, umol/s]
    luminaires : Number, optional
        How many luminaires there are.
    utilance : Number, optional
        The part of the luminaires' flux that gets to the working plane, at once or reflected; with
        the flux of bare lamps, the utilization factor.
    maintenance : Number, optional
        Maintenance factor: the part of the light that is left by ageing and dirt (1).
    wavelength : Amount, optional
        Light of one wavelength (or frequency, wavenumber, photon energy). [nm]
    spectrum : Text, optional
        Light of that spectrum: a name, blackbody:2856K, line:632.8nm, a file ...
    efficacy : Amount, optional
        A given ratio of two kinds: 93lm/W, 2.1umol/J, 54lm.s/umol. [lm/W]
    observer : Observer, optional
        Whose eyes see `wavelength` or `spectrum`.
    range : Text, optional
        Where the watts of `spectrum` are counted.
    photon_range : Text, optional
        Where the photons of `spectrum` are counted (default 400nm:700nm).

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
    >>> found = room(area="54 m2", illuminance="500 lx", flux="3600 lm", utilance=0.6)
    >>> print(found.luminaires, found.luminaires_to_install)
    12.5 dimensionless 13.0 dimensionless
    """
    given = locals()
    from radcalc.calculators.room import room as work_out

    return calculate("room", given, work_out)
