"""Attenuations of the cinematographer's light, by depth, cross-section, direction and distance.

The light stands at the origin and a spot shines along +z; an omni shines everywhere.  What
reaches a point is multiplied by four attenuations:

- `depth_clip`: none before a near and behind a far limit, each with a soft edge
- `superellipse_clip`: none outside a cross-section between a rectangle and an ellipse, which
  widens in proportion to z
- `beam`: a power of the cosine of the angle off the axis
- `falloff`: a power of the distance, held to a maximum next to the light

These are those of Barzel's paper [1]_ as Gritz's shader [2]_ has them.  Lengths are in one unit;
arguments are floats or NumPy arrays, which are broadcast together.

References
----------
.. [1] R. Barzel, Lighting Controls for Computer Cinematography, Journal of Graphics Tools 2(1)
   (1997) 1-20, doi:10.1080/10867651.1997.10487467.
.. [2] L. Gritz, uberlight.sl, course notes of Advanced RenderMan: Beyond the Companion, SIGGRAPH
   1998.
"""

from radcalc.geometry import lobes
from radcalc.geometry.cones import refuse
from radcalc.maths import Number, atan2, exp, expm1, hypot, larger, log, piecewise, smaller

MOST = 690.0  # of a logarithm, whose exponential a float holds


def smoothstep(low: Number, high: Number, x: Number) -> Number:
    """Smooth step from 0 at one limit to 1 at another.

    Parameters
    ----------
    low, high : float or ndarray
        The limits, low <= high, in any one unit.
    x : float or ndarray
        Where, in the same unit.

    Returns
    -------
    float or ndarray [1]
        From 0 to 1; where the limits are equal, 0 below them and 1 from them on.

    Notes
    -----
    ::

        t^2 (3 - 2 t),  t = (x - low) / (high - low), held to 0 .. 1

    Its slope is 0 at both limits.

    Examples
    --------
    >>> from radcalc.geometry.uberlight import smoothstep
    >>> smoothstep(1.0, 3.0, 1.5), smoothstep(2.0, 2.0, 2.0)
    (0.15625, 1.0)
    """

    def between(low: Number, high: Number, x: Number) -> Number:
        t = (x - low) / (high - low)
        return t * t * (3 - 2 * t)

    def ends(low: Number, high: Number, x: Number) -> Number:
        return piecewise(x >= high, lambda x: 1.0 + 0 * x, lambda x: 0.0 * abs(x), x)

    return piecewise((x > low) & (x < high), between, ends, low, high, x)


def depth_clip(
    depth: Number,
    near: tuple[Number, Number] | None = None,
    far: tuple[Number, Number] | None = None,
) -> Number:
    """Attenuation by the depth of a point: none before a near, and behind a far limit.

    Parameters
    ----------
    depth : float or ndarray
        z of the point for a spot, its distance from the light for an omni.
    near : tuple of 2 floats or ndarrays, optional
        Where the light begins, and from where on it is full.
    far : tuple of 2 floats or ndarrays, optional
        Up to where the light is full, and where it ends.

    Returns
    -------
    float or ndarray [1]
        From 0 to 1; 0 where the depth is 0 or less.

    Notes
    -----
    ::

        smoothstep(A, B, z) (1 - smoothstep(C, D, z))

    Examples
    --------
    >>> from radcalc.geometry.uberlight import depth_clip
    >>> depth_clip(1.5, near=(1.0, 2.0)), depth_clip(-1.0)
    (0.5, 0.0)
    """
    clip = piecewise(depth > 0, lambda z: 1.0 + 0 * z, lambda z: 0.0 * abs(z), depth)
    if near is not None:
        clip = clip * smoothstep(*near, depth)
    if far is not None:
        clip = clip * (1 - smoothstep(*far, depth))
    return clip


def superellipse_scale(
    x: Number, y: Number, width: Number, height: Number, roundness: Number
) -> Number:
    """Factor by which a superellipse must grow to pass through a point of its plane.

    Parameters
    ----------
    x, y : float or ndarray
        The point; only its distances from the axes count.
    width, height : float or ndarray
        Half axes along x and y, above 0, in the unit of the point.
    roundness : float or ndarray [1]
        From 0, a rectangle, to 1, an ellipse.

    Returns
    -------
    float or ndarray [1]
        Below 1 inside, above 1 outside.

    Notes
    -----
    ::

        ((|x| / a)^(2/R) + (|y| / b)^(2/R))^(R/2),  and max(|x| / a, |y| / b) for R = 0

    Examples
    --------
    >>> from radcalc.geometry.uberlight import superellipse_scale
    >>> superellipse_scale(3.0, 4.0, 1.0, 1.0, 1.0), superellipse_scale(3.0, 4.0, 1.0, 1.0, 0.0)
    (5.0, 4.0)
    """
    across, along = abs(x) / width, abs(y) / height
    most, least = larger(across, along), smaller(across, along)
    ratio = piecewise(most > 0, lambda m, n: n / m, lambda m, n: 0.0 * m, most, least)
    return piecewise(
        roundness > 0,
        lambda m, r, R: m * (1 + r ** (2 / R)) ** (R / 2),
        lambda m, r, R: m + 0.0 * r,
        most,
        ratio,
        roundness,
    )


def superellipse_clip(
    x: Number,
    y: Number,
    inner: tuple[Number, Number],
    outer: tuple[Number, Number],
    roundness: Number = 1.0,
) -> Number:
    """Attenuation by the cross-section of a spot: full inside, none outside, soft between.

    Parameters
    ----------
    x, y : float or ndarray [1]
        Where the ray crosses the plane z = 1, from the axis of the (sheared) beam.
    inner : tuple of 2 floats or ndarrays [1]
        Half width and half height in that plane within which the light is full, above 0.
    outer : tuple of 2 floats or ndarrays [1]
        Those outside which there is none; at least as large.
    roundness : float or ndarray [1], optional
        From 0, a rectangle, to 1, an ellipse, the default.

    Returns
    -------
    float or ndarray [1]
        From 0 to 1.

    Notes
    -----
    ::

        1 - smoothstep(q, r, 1)
        q = a b / ((b |x|)^(2/R) + (a |y|)^(2/R))^(R/2),  r the same of A and B

    q and r are 1 over the factors by which the superellipses must grow (`superellipse_scale`).
    For R = 0 the formula's limit is used, which is continuous; the shader multiplies the clips of
    x and of y there, which makes the soft corners of a rectangle darker.

    Examples
    --------
    >>> from radcalc.geometry.uberlight import superellipse_clip
    >>> superellipse_clip(1.2, 0.0, inner=(1.0, 1.0), outer=(1.5, 1.5))
    0.648
    """
    scale = superellipse_scale(x, y, *inner, roundness)
    outside = superellipse_scale(x, y, *outer, roundness)
    return piecewise(
        scale > 0,
        lambda f, F: 1 - smoothstep(1 / f, 1 / F, 1.0 + 0 * f),
        lambda f, F: 1.0 + 0 * f,
        scale,
        outside,
    )


def beam(x: Number, y: Number, z: Number, exponent: Number) -> Number:
    """Attenuation by the angle off the axis of a spot: a power of its cosine.

    Parameters
    ----------
    x, y, z : float or ndarray
        The point.
    exponent : float or ndarray [1]
        Exponent n, 0 or more.

    Returns
    -------
    float or ndarray [1]
        From 0 to 1; 0 where z is 0 or less.

    Raises
    ------
    ConditionError
        If an exponent is negative.

    Notes
    -----
    ::

        (z / d)^n = cos^n(gamma)

    Computed with the logarithm of the cosine, which keeps the digits next to the axis.

    Examples
    --------
    At 60 degrees off the axis:

    >>> from radcalc.geometry.uberlight import beam
    >>> round(beam(3**0.5, 0.0, 1.0, 2.0), 12), beam(0.0, 0.0, -1.0, 2.0)
    (0.25, 0.0)
    """
    refuse(exponent < 0, "a negative beam exponent is not possible", "0 or more")
    return piecewise(
        z > 0,
        lambda z, off, n: exp(n * lobes.ln_cos(atan2(off, z))),
        lambda z, off, n: 0.0 * (abs(z) + off + n),
        z,
        hypot(x, y),
        exponent,
    )


def falloff(
    distance: Number, exponent: Number, reference: Number, maximum: Number | None = None
) -> Number:
    """Attenuation by the distance: a power of it, held to a maximum within the fall-off distance.

    Parameters
    ----------
    distance : float or ndarray
        Distance d from the light, above 0.
    exponent : float or ndarray [1]
        Exponent N, 0 or more; 2 is an inverse square.
    reference : float or ndarray
        Fall-off distance L, above 0, at which the attenuation is 1.
    maximum : float or ndarray [1], optional
        Attenuation M at the light, 1 or more; without it there is no maximum.

    Returns
    -------
    float or ndarray [1]
        Up to 1 from L on; up to M within it.

    Raises
    ------
    ConditionError
        If an argument is out of its range, or the attenuation so extreme that a float cannot hold
        it.

    Notes
    -----
    ::

        (L / d)^N                                    beyond L, and everywhere without a maximum
        M exp(s (d / L)^beta), s = ln(1/M), beta = -N / s       within L

    Both have the value 1 and the slope -N / L at L.  The limit for M = 1 is 1 all over within L;
    for a rising M the second tends to the first.  It is computed as exp(-m expm1(x / m)), with
    m = ln M and x = N ln(d / L), which keeps its digits for every M.

    Examples
    --------
    >>> from radcalc.geometry.uberlight import falloff
    >>> round(falloff(2.0, 2.0, 1.0), 12), round(falloff(0.5, 2.0, 1.0), 12)
    (0.25, 4.0)
    >>> round(falloff(1e-9, 2.0, 1.0, maximum=3.0), 6)
    3.0
    """
    refuse(distance <= 0, "a distance from the light is more than 0", "more than 0")
    refuse(exponent < 0, "a negative fall-off is not possible", "0 or more")
    refuse(reference <= 0, "a fall-off distance is more than 0", "more than 0")
    power = exponent * log(distance / reference)  # of 1/e, by which the light falls off
    if maximum is not None:
        refuse(maximum < 1, "a maximum is at least the 1 at the fall-off distance", "1 or more")
        power = piecewise(
            (power < 0) & (maximum > 1),
            lambda x, m: m * expm1(x / m),
            lambda x, m: larger(x, 0.0 * m),
            power,
            log(maximum),
        )
    refuse(abs(power) > MOST, "that fall-off is beyond what a number holds", "a smaller exponent")
    return exp(-power)
