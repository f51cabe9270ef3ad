"""The words of verdicts: names of mistakes, and sentences in other languages."""

import os
from typing import Any

from radcalc.quantities.language import ENGLISH, translate

CATALOGUES = os.path.join(os.path.dirname(os.path.dirname(__file__)), "locale")
DOMAIN = "radcalc"  # the name of a catalogue's file


class Translatable(str):
    """An English sentence, with the template and the fields that it was made of.

    If the first field is a number of things, `plural` is the template for other numbers than 1.

    Examples
    --------
    >>> Translatable("the {0} was forgotten", "reflectance")
    'the reflectance was forgotten'
    >>> Translatable("to {0} digit", 3, plural="to {0} digits")
    'to 3 digits'
    """

    __slots__ = ("fields", "plural", "template")
    fields: tuple[Any, ...]
    plural: str
    template: str

    def __new__(cls, template: str, *fields: Any, plural: str = "") -> "Translatable":
        used = plural if plural and fields[0] != 1 else template
        sentence = super().__new__(cls, used.format(*fields))
        sentence.template, sentence.fields, sentence.plural = template, fields, plural
        return sentence


def in_language(text: str, language: str) -> str:
    """Return a sentence of a verdict in a language; a word without a translation stays English."""
    if language == ENGLISH or not text:
        return text
    from gettext import translation  # which imports re

    catalogue = translation(DOMAIN, CATALOGUES, [language], fallback=True)
    if not isinstance(text, Translatable):
        translated = catalogue.gettext(text)
        is_name = translated == text and "=" not in text  # not a formula
        return translate(text, language) if is_name else translated
    if text.plural:
        template = catalogue.ngettext(text.template, text.plural, text.fields[0])
    else:
        template = catalogue.gettext(text.template)
    fields = (in_language(f, language) if isinstance(f, str) else f for f in text.fields)
    return template.format(*fields)


USUAL: dict[str, tuple[float, str, str]] = {
    # --- pi, and other constants
    "pi-forgotten": (1, "pi was forgotten, or added by mistake", ""),
    "two-pi-for-pi": (1,
        "2 pi was used for pi: the cosine in the integral over the hemisphere was forgotten",
        "M = pi L Omega0, because each direction counts with its cosine"),
    "wrong-sphere": (2, "pi, 2 pi and 4 pi were mixed up, or forgotten", ""),
    "pi-twice": (3.5, "pi was used twice", ""),
    "pi-upside-down": (3, "pi was a factor instead of a divisor, or vice versa", ""),
    "constant-forgotten": (2.5, "the constant factor was forgotten", ""),
    "wien-without-4.965": (2, "the peak was taken at h c / (k T), without the factor 4.965",
        "lambda = b / T with b = h c / (4.965 k) = 2.898e-3 m K"),
    "wien-per-frequency": (2, "the peak per frequency was used for the peak per wavelength",
        "lambda = b / T with b = 2.898e-3 m K; c / (5.88e10 Hz/K T) is the peak per frequency"),
    "angular-for-cycles": (3, "cycles and radians were mixed up: omega for nu, h/(2 pi) for h",
        "nu = c / lambda counts cycles, omega = 2 pi nu radians; E = h nu"),
    # --- skies
    "uniform-sky": (1, "the sky was assumed to be uniform",
        "a uniform sky gives the ground pi L_z, the traditional overcast sky 7 pi/9 L_z"),
    "cosine-of-zenith": (2, "the cosine of the zenith angle was used for the luminance",
        "the overcast sky has L = L_z (1 + 2 cos(Z))/3, a uniform one L = L_z"),
    "ground-for-plane": (1,
        "the light on the plane was taken as the share of the ground's light by the visible sky",
        "a plane gets (1 + cos(T))/2 of the light on the ground only from a uniform sky"),
    # --- angles
    "cosine-forgotten": (1, "the cosine of the incidence was forgotten",
        "E = I cos(theta) / d^2: a tilted surface receives less light"),
    "full-for-half": (1,
        "the full angle was used as the half angle, or the half angle as the full one",
        "a half angle goes from the axis to the edge, an apex or beam angle from edge to edge"),
    "angle-from-surface": (2,
        "the angle was measured from the surface, not from its normal: sine for cosine",
        "the incidence and the polar angle are measured from the normal"),
    "degrees-as-radians": (2, "degrees were used as radians",
        "a calculator in radian mode reads 30 as 30 rad, which is 1719 degrees"),
    "wrong-quadrant": (2, "the arc tangent of y/x was used without regard to the quadrant",
        "phi = atan2(y, x), which uses the signs of both"),
    "x-for-y": (2.5, "x and y were exchanged", "x = sin(theta) cos(phi), y = sin(theta) sin(phi)"),
    "normal-for-reflection": (1, "the normal of the mirror was used as the reflected direction",
        "r = 2 (n.d) n - d, at the same angle to the normal n as d, on the other side"),
    "towards-for-away": (2, "the direction was taken towards the mirror, not away from it",
        "r = 2 (n.d) n - d if both point away from the mirror"),
    "pixels-alike": (2, "the sphere was divided by the number of pixels",
        "the pixels of a latlong map become smaller towards the poles, as sin(t)"),
    "root-forgotten": (3, "the square root was forgotten",
        "the length of a vector is sqrt(x^2 + y^2 + z^2)"),
    # --- sizes and places
    "diameter-for-radius": (1,
        "the diameter was used for the radius, or the radius for the diameter",
        "R is half the diameter; areas are wrong by a factor of 4"),
    "height-for-distance": (2, "the height was used for the slant distance",
        "d is the hypotenuse: d^2 = h^2 + x^2"),
    "sum-for-difference": (3, "the squares were subtracted, not added",
        "d is the hypotenuse: d^2 = h^2 + x^2"),
    "distance-to-surface": (3, "the distance was measured to the surface of the sphere",
        "sin(alpha) = R/d, with d to the centre"),
    "diagonal-for-width": (2, "the diagonal was used for the width", "c^2 = w^2 + h^2"),
    "perimeter-for-sum": (2, "the perimeter was used for the sum of two sides",
        "k = w l / (h (w + l)), with the sum of one width and one length"),
    "mean-for-sum": (2, "the mean of the two sides was used for their sum",
        "k = w l / (h (w + l)), with the sum of one width and one length"),
    # --- rooms
    "rounded-down": (1, "the number of luminaires was rounded down",
        "fewer luminaires give too little light: the next larger integer is installed"),
    "maintenance-upside-down": (1, "the maintenance factor was a factor instead of a divisor",
        "n = E A / (Phi U MF): losses require more luminaires"),
    # --- cameras
    "fewer-cosines": (1, "a lower power of the cosine than the fourth was used",
        "off the axis of a lens: one cosine each for pupil and sensor, two for the distance"),
    "magnification-forgotten": (1, "the magnification was forgotten, or not squared",
        "for close-ups, N (1 + m) replaces the f-number: the light decreases as 1/(1 + m)^2"),
    # --- laser beams
    "mean-for-peak": (1, "the mean over the spot was used for the peak on the axis",
        "the peak of a Gaussian beam is twice the mean in the 1/e^2 diameter: 8 Phi / (pi D^2)"),
    "peak-for-mean": (1, "the peak on the axis was used for the mean over the spot",
        "the mean is the flux divided by the area of the spot: 4 Phi / (pi D^2)"),
    "uniform-for-gaussian": (1, "the range equation of a uniform beam was used",
        "for a Gaussian beam (1/e^2 diameter) E_lim = 8 Phi / (pi (D^2 + (phi d)^2))"),
    "gaussian-for-uniform": (1, "the beam was assumed to be Gaussian",
        "for a uniform beam E_lim = 4 Phi / (pi (D + phi d)^2)"),
    "exit-forgotten": (2, "the diameter at the exit of the laser was forgotten",
        "a Gaussian beam has D_s^2 = D^2 + (phi d)^2, a uniform one D_s = D + phi d"),
    "sum-for-root": (1, "the diameters were added (as for a uniform beam), or their squares were",
        "a Gaussian beam has D_s^2 = D^2 + (phi d)^2, a uniform one D_s = D + phi d"),
    # --- functions and their siblings
    "arctangent-for-arcsine": (2, "the tangent was used for the sine (or the sine for the tangent)",
        "edge of a sphere: sin(alpha) = R/d; rim of a disc: tan(alpha) = R/h"),
    "flat-disc-for-cap": (2, "the flat area over d^2 was used for the part of the sphere",
        "Omega = 2 pi (1 - cos(alpha)); pi tan^2 and pi alpha^2 are its limits for small angles"),
    "flat-for-curved": (2, "the flat area over d^2 was used for the part of the sphere",
        "Omega = A/d^2 applies to surfaces that are small compared with their distance"),
    "solid-for-projected": (2,
        "the solid angle was used for the projected solid angle, or vice versa",
        "the projected solid angle links L and E: pi sr for a hemisphere, not 2 pi sr"),
    "one-forgotten": (3, "the 1 in 1 - cos was forgotten", "Omega = 2 pi (1 - cos(alpha))"),
    "sine-not-squared": (3, "the sine was not squared", "Omega_p = pi sin^2(alpha)"),
    "sine-forgotten": (2, "sin(theta) in the element of solid angle was forgotten",
        "dOmega = sin(theta) dtheta dphi"),
    "degrees-in-integral": (3, "theta was counted in degrees, without sin(theta)",
        "dOmega = sin(theta) dtheta dphi, with dtheta in radians"),
    "sine-twice": (3, "sin(theta) was used twice",
        "dOmega = sin(theta) dtheta dphi has it once"),
    "cosine-added": (2, "the function was multiplied by cos(theta)",
        "cos(theta) belongs to an irradiance on a plane, not to a flux or a solid angle"),
    "integrand-without-cosine": (2, "cos(theta) was left out of the function",
        "the function is integrated as given, including its cos(theta)"),
    "whole-for-half": (2, "the integral was taken over the sphere, not over a half of it, or vice "
        "versa", "a hemisphere ends at theta = 90 deg, the sphere at 180 deg"),
    "wrong-limits": (3, "the integral was taken over the whole hemisphere",
        "theta goes from the inner to the outer edge of the zone or the cone"),
    "half-azimuth": (2, "the integral over the azimuth was taken as pi, not 2 pi",
        "phi goes all the way round, from 0 to 2 pi"),
    "azimuth-forgotten": (3, "the integral over the azimuth was forgotten",
        "dOmega = sin(theta) dtheta dphi"),
    "zone-of-caps": (2, "one cap, or the sum of two caps, was used for the zone",
        "the zone is the outer cap minus the inner cap: 2 pi (cos t0 - cos t1)"),
    "cosines-added": (2, "the cosines of the edges were added",
        "the zone is the outer cap minus the inner cap: 2 pi (cos t0 - cos t1)"),
    "far-field-of-extended-source": (2, "the inverse square law was used for an extended source",
        "close to an extended source E = L Omega_p; for a disc pi L R^2/(R^2 + d^2)"),
    "inverse-square-on-radiance": (3, "the inverse square law was used for a radiance",
        "a radiance does not depend on the distance"),
    "lobe-without-one": (1, "n was used for n + 1 in the flux of a lobe", ""),
    "exponent-upside-down": (3, "n + 1 was a factor instead of a divisor", ""),
    "spot-as-sphere": (2, "the peak intensity of a spot was multiplied by 4 pi",
        "a spot fills only the solid angle of its beam"),
    "cone-forgotten": (3, "the cone was forgotten", "I = Phi / Omega, with Omega of the cone"),
    "lobe-for-cone": (3, "the half angle of the cone was used as half the beam angle of a lobe",
        "a uniform cone has Omega = 2 pi (1 - cos(alpha)); a lobe has 2 pi/(n + 1)"),
    "rounded-early": (2, "the cosine was rounded before it was subtracted from 1",
        "keep all digits on the way: 1 - cos(alpha) loses the first digits of the cosine"),
    "tangent-for-angle": (3, "the arc tangent was forgotten, or another function was used",
        "the solid angle of a rectangle is an arc tangent, not a tangent"),
    "cone-for-lobe": (3, "the beam angle was used as the edge of a uniform cone",
        "at the beam angle the intensity is half the peak: the lobe has more flux than the cone"),
    "other-quantity": (2.9, "", ""),
    # --- kinds
    "amplitude-for-intensity": (2, "the ratio of the amplitudes was not squared",
        "a reflectance is the square of the ratio of the amplitudes"),
    "other-lamp": (2, "the factor of another lamp, or of daylight, was used",
        "each spectrum has its own lumens and photons per watt"),
    "hours-of-light": (2, "another number of hours was used for the day or for the hours of light",
        "a daily light integral is the rate times the hours of light, or the mean rate times 24 h"),
    "efficiency-for-responsivity": (2,
        "the quantum efficiency was used for the responsivity in A/W, or vice versa",
        "s = e eta / (h nu): the responsivity also depends on the wavelength"),
    "683-for-any-light": (1, "683 lm/W was used, which applies only at 555 nm",
        "lm = 683 V(lambda) W for one wavelength; a spectrum has its own efficacy"),
    "683-forgotten": (3, "V(lambda) was used without its 683 lm/W", "lm = 683 V(lambda) W"),
    "scotopic-for-photopic": (3,
        "photopic (V, 683 lm/W) and scotopic vision (V', 1700 lm/W) were mixed up",
        "photopic: 683 lm/W and V; scotopic: 1700 lm/W and V'"),
    "scotopic-for-mesopic": (2.5, "the luminance for another state of adaptation was used",
        "the mesopic luminance is between the photopic and the scotopic luminance"),
    "avogadro": (2, "Avogadro's number was forgotten, or used twice",
        "1 mol is 6.022e23 photons"),
    "nanometres-for-metres": (2, "nanometres were used for metres in h c / lambda",
        "h c / lambda takes the wavelength in metres"),
    "joules-for-electronvolts": (2, "joules and electronvolts were mixed up", "1 eV = 1.602e-19 J"),
    "jacobian-forgotten": (1.5, "the density was converted like a plain value",
        "E_nu = E_lambda lambda^2 / c: the width of the interval changes, too"),
    "absorbed-for-reflected": (3,
        "the absorbed light was used for the reflected light, or vice versa",
        "the absorptance is 1 - rho"),
    # --- the light meter
    "filter-the-wrong-way": (1, "the filter was used in the wrong direction",
        "with a filter of n stops the time is 2^n times as long"),
    "density-for-stops": (1, "the density was used for the number of stops, or vice versa",
        "n = D / lg 2: a density of 0.3 is 1 stop"),
    "stops-are-doublings": (1, "the time was multiplied by the stops; each stop doubles it",
        "t = t0 2^n"),
    "impedance-upside-down": (2, "the impedance of vacuum was inverted",
        "E_rms^2 = S Z0, with Z0 = 1/(epsilon0 c) = 376.7 ohm"),
    "peak-for-rms": (1, "the peak of the field was used for its root mean square, or vice versa",
        "S = E_rms^2 / Z0 = E_peak^2 / (2 Z0)"),
    "speed-without-root": (1, "the ISO speed was used without its square root",
        "GN = N d sqrt(100 / S): four times the speed doubles the distance"),
    "log10-for-log2": (1, "the logarithm to base 10 or e was used instead of base 2",
        "EV = log2(N^2 / t): one step is a factor of 2"),
    "iso-forgotten": (2, "the ISO speed was forgotten", "EV100 = EV - log2(S / 100)"),
    "iso-upside-down": (2, "the ISO speed was used with the wrong sign",
        "EV100 = EV - log2(S / 100): a fast film needs less light"),
    "k-for-c": (1,
        "the constant for reflected light was used for incident light, or vice versa",
        "L = K 2^EV100 / 100 with K = 12.5, E = C 2^EV100 / 100 with C = 250"),
    # --- levels
    "log-base": (1, "the logarithm to another base was used (e, 2 and 10 were mixed up)",
        "decibels, magnitudes and densities have the logarithm to base 10, stops that to base 2"),
    "twice-the-level": (2, "20 was used for 10 in the decibel, or 10 for 20",
        "a ratio of powers has 10 lg: 10 dB are a factor of 10"),
    "level-sign": (2, "the sign of the level was turned",
        "a loss has a negative level in dB and stops, and a positive density"),
    "level-factor": (2, "the factor 10 of the decibel was forgotten, or used for a density",
        "1 B = 10 dB; a density of 1 is 10 dB"),
    # --- samples in time
    "step-forgotten": (1, "the samples were added without the time between them",
        "H is the sum of (E_i + E_i+1)/2 (t_i+1 - t_i)"),
    "whole-steps": (1, "each sample was counted with a whole step, even the first and the last",
        "n samples have n - 1 steps: by the trapezoidal rule, the first and the last count half"),
    "sample-for-all": (2, "the maximum was used for the whole time",
        "H is the sum of (E_i + E_i+1)/2 (t_i+1 - t_i)"),
    "plain-mean": (2, "the plain mean of the samples was used, as if the steps were equal",
        "the mean over time is H / t: each sample counts with the time around it"),
    "gaps-bridged": (3, "the gaps were counted with the mean of the other times",
        "times without samples do not count"),
    # --- units and slips
    "minutes-for-seconds": (3, "a time was used in another unit (minutes or hours for seconds)",
        "a watt is a joule per second"),
    "length-unit": (3, "a length was used in another unit (cm or mm for m, feet for metres)",
        "all lengths in a formula need the same unit"),
    "area-unit": (3, "an area was converted like a length, or used in another unit",
        "1 m2 = 10 000 cm2, 1 m = 100 cm"),
    "kelvin-for-celsius": (4,
        "273 was added or forgotten: degrees Celsius and kelvin were mixed up",
        "a difference is the same in both units; T[K] = t[degC] + 273.15"),
    "feet-for-metres": (4, "feet and metres were mixed up",
        "1 ft = 0.3048 m, and 1 fc = 10.764 lx"),
    "neighbour-unit": (4.5, "another unit with the same name or of the same kind was used",
        "1 fL is 1/pi cd/ft2, 1 L is 1/pi cd/cm2, 1 asb is 1/pi cd/m2"),
    "unit-upside-down": (3, "the factor between the units was inverted",
        "a larger unit has a smaller number"),
    "factor-upside-down": (3, "it was divided by the factor of the conversion, not multiplied",
        "the units show it: lx times h are lx h, lm divided by lm/W are W"),
    "deg2-for-sr": (3, "square degrees and steradians were mixed up",
        "1 sr = (180/pi)^2 deg2 = 3282.81 deg2"),
    "power-of-ten": (6, "the answer is wrong by a power of ten: a prefix was mixed up",
        "m is 1e-3, u is 1e-6, k is 1e3"),
}  # fmt: skip
