"""How common each mistake is, and what is said of it.

A row has the rank (1 comes first), what was done, and what would have been right.  An empty last
text is the formula of the law that was edited.  What is generated for any symbol (a power dropped,
doubled or turned round) is in `edits.py`.
"""

HALF = "a half angle goes from the axis to the edge, an apex or beam angle from edge to edge"
SOLID = "Omega = 2 pi (1 - cos(alpha)); pi tan^2 and pi alpha^2 are only its beginning"
VISION = "photopic: 683 lm/W and V; scotopic: 1700 lm/W and V'"

USUAL: dict[str, tuple[float, str, str]] = {
    # --- pi, and other constants
    "pi-forgotten": (1, "pi was forgotten, or put in where it does not belong", ""),
    "two-pi-for-pi": (
        1,
        "2 pi was used for pi: the cosine in the integral over the hemisphere",
        "M = pi L Omega0, since each direction counts with its cosine",
    ),
    "wrong-sphere": (2, "the wrong one of pi, 2 pi and 4 pi was used, or none", ""),
    "pi-upside-down": (3, "it was multiplied by pi for divided, or divided for multiplied", ""),
    "constant-forgotten": (3, "the number in front was left out", ""),
    "angular-for-cycles": (
        3,
        "2 pi was mixed up with a whole cycle: omega for nu, h/(2 pi) for h",
        "nu = c / lambda counts cycles, omega = 2 pi nu radians; E = h nu",
    ),
    # --- angles
    "cosine-forgotten": (
        1,
        "the cosine of the incidence was left out",
        "E = I cos(theta) / d^2: a tilted surface catches less light",
    ),
    "full-for-half": (
        1,
        "the full angle was used as the half angle, or the half angle as the full one",
        HALF,
    ),
    "angle-from-surface": (
        2,
        "the angle was taken from the surface, not from its normal: sine for cosine",
        "incidence and polar angle are counted from the normal",
    ),
    "degrees-as-radians": (
        2,
        "degrees were taken as radians",
        "a calculator set to radians takes 30 as 30 rad, that is 1719 degrees",
    ),
    "wrong-quadrant": (
        2,
        "the arc tangent of y/x was taken without looking at the quadrant",
        "phi = atan2(y, x), which knows the signs of both",
    ),
    "x-for-y": (3, "x and y were exchanged", "x = sin(theta) cos(phi), y = sin(theta) sin(phi)"),
    "root-forgotten": (
        3,
        "the square root was not taken",
        "the length of a vector is sqrt(x^2 + y^2 + z^2)",
    ),
    # --- sizes and places
    "diameter-for-radius": (
        1,
        "the diameter was used for the radius, or the radius for the diameter",
        "R is half the diameter: areas are off by 4",
    ),
    "height-for-distance": (
        2,
        "the height was used for the slant distance",
        "d is the straight line: d^2 = h^2 + x^2",
    ),
    "sum-for-difference": (
        3,
        "the squares were subtracted, not added",
        "d is the straight line: d^2 = h^2 + x^2",
    ),
    "distance-to-surface": (
        3,
        "the distance was taken to the sphere's surface",
        "sin(alpha) = R/d, with d to the centre",
    ),
    "diagonal-for-width": (2, "the diagonal was used for the width", "c^2 = w^2 + h^2"),
    # --- functions and their siblings
    "arctangent-for-arcsine": (
        2,
        "the tangent was used for the sine (or the sine for the tangent)",
        "a sphere's edge: sin(alpha) = R/d; a disc's rim: tan(alpha) = R/h",
    ),
    "flat-disc-for-cap": (
        2,
        "the flat area over d^2 was used for the part of the sphere",
        SOLID,
    ),
    "flat-for-curved": (
        2,
        "the flat area over d^2 was used for the part of the sphere",
        "Omega = A/d^2 is for what is small beside its distance",
    ),
    "solid-for-projected": (
        2,
        "the solid angle was used for the projected one, or the other way round",
        "between L and E stands the projected solid angle: pi sr for a hemisphere, not 2 pi",
    ),
    "one-forgotten": (3, "the 1 in 1 - cos was forgotten", "Omega = 2 pi (1 - cos(alpha))"),
    "sine-not-squared": (3, "the sine was not squared", "Omega_p = pi sin^2(alpha)"),
    "sine-forgotten": (
        2,
        "the sine of theta in the element of solid angle was left out",
        "dOmega = sin(theta) dtheta dphi",
    ),
    "azimuth-forgotten": (3, "the azimuth was left out", "dOmega = sin(theta) dtheta dphi"),
    "zone-of-caps": (
        2,
        "a zone was taken as one cap, or as the sum of two",
        "the zone is the outer cap less the inner one: 2 pi (cos t0 - cos t1)",
    ),
    "far-field-of-extended-source": (
        2,
        "the inverse square law was used on an extended source",
        "near a source of some size E = L Omega_p: for a disc pi L R^2/(R^2 + d^2)",
    ),
    "inverse-square-on-radiance": (
        3,
        "the inverse square law was used on a radiance",
        "a radiance is the same from any distance",
    ),
    "lobe-without-one": (1, "n was used for n + 1 in the flux of a lobe", ""),
    "exponent-upside-down": (3, "it was multiplied by n + 1, not divided", ""),
    "spot-as-sphere": (
        2,
        "the peak candelas of a spot were taken times 4 pi",
        "a spot fills only its own solid angle",
    ),
    "cone-forgotten": (3, "the cone was left out", "I = Phi / Omega, with Omega of the cone"),
    "cone-for-lobe": (
        3,
        "the beam angle was taken as the edge of a uniform cone",
        "a beam angle is where half the peak is left: the lobe has more flux than the cone",
    ),
    # --- kinds
    "683-for-any-light": (
        1,
        "683 lm/W was used, which holds at 555 nm alone",
        "lm = 683 V(lambda) W for one wavelength; a spectrum has its own efficacy",
    ),
    "683-forgotten": (3, "V(lambda) was used without its 683 lm/W", "lm = 683 V(lambda) W"),
    "scotopic-for-photopic": (
        3,
        "the eye by day (V, 683 lm/W) and the dark-adapted one (V', 1700 lm/W) were mixed",
        VISION,
    ),
    "scotopic-for-mesopic": (
        3,
        "the luminance of another state of the eye was taken",
        "the mesopic luminance is between the photopic and the scotopic one",
    ),
    "avogadro": (
        2,
        "Avogadro's number was left out, or used twice",
        "1 mol of photons is 6.022e23 of them",
    ),
    "nanometres-for-metres": (
        2,
        "nanometres were used for metres in h c / lambda",
        "h c / lambda takes the wavelength in metres",
    ),
    "joules-for-electronvolts": (
        2,
        "joules and electronvolts were mixed up",
        "1 eV = 1.602e-19 J",
    ),
    "jacobian-forgotten": (
        2,
        "the density was converted as if it were a plain value",
        "E_nu = E_lambda lambda^2 / c: the width of the interval changes too",
    ),
    "step-width-forgotten": (
        2,
        "the width of the band, or of the steps of a sum, was left out",
        "a band is the density times its width",
    ),
    "absorbed-for-reflected": (
        3,
        "what is absorbed was used for what is reflected, or back",
        "a reflectance rho leaves 1 - rho",
    ),
    # --- the light meter
    "log10-for-log2": (
        1,
        "another logarithm was used for that to the base 2",
        "EV = log2(N^2 / t): one step is a factor of 2",
    ),
    "iso-forgotten": (2, "the ISO speed was left out", "EV100 = EV - log2(S / 100)"),
    "iso-upside-down": (
        2,
        "the ISO speed was counted with the other sign",
        "EV100 = EV - log2(S / 100): a fast film needs less light",
    ),
    "k-for-c": (
        1,
        "the constant of reflected light was used for incident light, or the other way round",
        "L = K 2^EV100 / 100 with K = 12.5, E = C 2^EV100 / 100 with C = 250",
    ),
    # --- units and slips
    "minutes-for-seconds": (
        3,
        "a time was used in another unit (minutes or hours for seconds)",
        "a watt is a joule per second",
    ),
    "length-unit": (
        3,
        "a length was used in another unit (cm or mm for m, feet for metres)",
        "lengths go into the formula in one unit",
    ),
    "area-unit": (
        3,
        "an area was converted as a length is, or used in another unit",
        "1 m2 is 10 000 cm2, 1 m = 100 cm",
    ),
    "kelvin-for-celsius": (
        4,
        "273 was added or left out: degrees Celsius and kelvin were mixed up",
        "a difference is the same in both; T[K] = t[degC] + 273.15",
    ),
    "feet-for-metres": (4, "feet and metres were mixed up", "1 ft = 0.3048 m, and 1 fc = 10.764 lx"),
    "neighbour-unit": (4.5, "another unit of the same name or kind was used", "1 fL is 1/pi cd/ft2, 1 L is 1/pi cd/cm2, 1 asb is 1/pi cd/m2"),
    "unit-upside-down": (3, "the factor between the units was used upside down", "the larger unit has the smaller number"),
    "deg2-for-sr": (
        3,
        "square degrees and steradians were mixed up",
        "1 sr = (180/pi)^2 deg2 = 3282.81 deg2",
    ),
    "power-of-ten": (
        6,
        "the answer is off by a power of ten: a slip of a prefix",
        "m is 1e-3, u is 1e-6, k is 1e3",
    ),
}
