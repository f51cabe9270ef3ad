"""Attenuations of the cinematographer's light, by depth, cross-section, direction and distance.

The light is at the origin; a spot shines along +z, an omni in all directions.  The light at a
point is multiplied by four attenuations:

- `depth_clip`: 0 before a near and after a far limit, each with a soft edge
- `superellipse_clip`: 0 outside a cross-section between a rectangle and an ellipse, which
  widens in proportion to z
- `beam`: a power of the cosine of the angle off the axis
- `falloff`: a power of the distance, limited to a maximum close to the light

They follow Barzel's paper [1]_ in the version of Gritz's shader [2]_.  Lengths are in one unit;
arguments are floats or NumPy arrays, broadcast together.

References
----------
.. [1] R. Barzel, Lighting Controls for Computer Cinematography, Journal of Graphics Tools 2(1)
   (1997) 1-20, doi:10.1080/10867651.1997.10487467.
.. [2] L. Gritz, uberlight.sl, course notes of Advanced RenderMan: Beyond the Companion, SIGGRAPH
   1998.
"""

from radcalc.geometry import cones
from radcalc.geometry.cones import refuse
from radcalc.maths import Number, atan2, exp, expm1, hypot, larger, log, piecewise, power, smaller

MOST = 690.0  # largest logarithm whose exponential a float holds
OUTSIDE = 1e150  # outside every cross-section


def smoothstep(low: Number, high: Number, x: Number) -> Number:
    """Return the smooth step from 0 at one limit to 1 at another.

    Parameters
    ----------
    low, high : float or ndarray
        The limits, low <= high, in any one unit.
    x : float or ndarray
        The position, in the same unit.

    Returns
    -------
    float or ndarray [1]
        From 0 to 1; if the limits are equal, 0 below them, else 1.

    Notes
    -----
    ::

        t^2 (3 - 2 t),  t = (x - low) / (high - low), limited to 0 .. 1

    Its slope is 0 at both limits.

    Examples
    --------
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
    """Return the attenuation by the depth of a point: 0 before a near and after a far limit.

    Parameters
    ----------
    depth : float or ndarray
        z of the point for a spot; its distance from the light for an omni.
    near : tuple of 2 floats or ndarrays, optional
        Depths at which the light begins, and at which it becomes full.
    far : tuple of 2 floats or ndarrays, optional
        Depths up to which the light is full, and at which it ends.

    Returns
    -------
    float or ndarray [1]
        From 0 to 1; 0 for a depth of 0 or less.

    Notes
    -----
    ::

        smoothstep(A, B, z) (1 - smoothstep(C, D, z))

    Examples
    --------
    >>> depth_clip(1.5, near=(1.0, 2.0)), depth_clip(-1.0)
    (0.5, 0.0)
    """
    clip = piecewise(depth > 0, lambda z: 1.0 + 0 * z, lambda z: 0.0 * abs(z), depth)
    if near is not None:
        clip = clip * smoothstep(*near, depth)
    if far is not None:
        clip = clip * (1 - smoothstep(*far, depth))
    return clip


def cross_section(
    x: Number, y: Number, z: Number, shear: tuple[Number, Number] = (0.0, 0.0)
) -> tuple[Number, Number]:
    """Return where the light to a point crosses the plane z = 1, from the beam's centre.

    Parameters
    ----------
    x, y, z : float or ndarray
        The point.
    shear : tuple of 2 floats or ndarrays, optional
        Centre of the beam in that plane.

    Returns
    -------
    tuple of 2 floats or ndarrays [1]
        Distances along x and y; 1e150, outside every cross-section, for z of 0 or less or too small
        for the quotients.

    Notes
    -----
    ::

        |x / z - X|,  |y / z - Y|

    Examples
    --------
    >>> cross_section(3.0, 1.0, 2.0, shear=(0.5, 0.0)), cross_section(0.0, 0.0, -1.0)
    ((1.0, 0.5), (1e+150, 1e+150))
    """
    u, v = (
        piecewise(
            z > 0,
            lambda z, aside, s: smaller(abs(aside / z - s), OUTSIDE + 0 * z),
            lambda z, aside, s: OUTSIDE + 0 * (z + aside + s),
            z,
            aside,
            centre,
        )
        for aside, centre in zip((x, y), shear, strict=True)
    )
    return u, v


def superellipse_scale(
    x: Number, y: Number, width: Number, height: Number, roundness: Number
) -> Number:
    """Return the factor that scales a superellipse so that it passes through a point.

    Parameters
    ----------
    x, y : float or ndarray
        The point; only its distances from the axes matter.
    width, height : float or ndarray
        Half axes along x and y, above 0, in the unit of the point.
    roundness : float or ndarray [1]
        From above 0 to 1: 1 is an ellipse; towards 0 it becomes a rectangle.

    Returns
    -------
    float or ndarray [1]
        Below 1 for a point inside, above 1 outside.

    Notes
    -----
    ::

        ((|x| / a)^(2/R) + (|y| / b)^(2/R))^(R/2)

    Computed so that no power overflows.

    Examples
    --------
    >>> superellipse_scale(3.0, 4.0, 1.0, 1.0, 1.0), superellipse_scale(3.0, 4.0, 1.0, 1.0, 1e-6)
    (5.0, 4.0)
    """
    across, along = abs(x) / width, abs(y) / height
    most, least = larger(across, along), smaller(across, along)
    ratio = piecewise(most > 0, lambda m, n: n / m, lambda m, n: 0.0 * m, most, least)
    return most * power(1 + power(ratio, 2 / roundness), roundness / 2)


def superellipse_clip(
    x: Number,
    y: Number,
    inner: tuple[float, float],
    outer: tuple[float, float],
    roundness: Number = 1.0,
) -> Number:
    """Return the attenuation by a spot's cross-section: 1 inside, 0 outside, soft between.

    Parameters
    ----------
    x, y : float or ndarray [1]
        Point of the plane z = 1, from `cross_section`.
    inner : tuple of 2 floats [1]
        Half width and half height of the area of full light in that plane, above 0.
    outer : tuple of 2 floats [1]
        Half width and half height of the area of all light; at least as large.
    roundness : float or ndarray [1], optional
        From 0, a rectangle, to 1, an ellipse.

    Returns
    -------
    float or ndarray [1]
        From 0 to 1.

    Notes
    -----
    ::

        1 - smoothstep(q, r, 1)
        q = a b / ((b |x|)^(2/R) + (a |y|)^(2/R))^(R/2),  r the same with A and B

    q and r are the reciprocals of `superellipse_scale`.  For R = 0, a rectangle, it is the product
    of the attenuations along both axes, as in the shader:

    ::

        (1 - smoothstep(a, A, |x|)) (1 - smoothstep(b, B, |y|))

    which for soft edges is not quite the limit of the first formula.

    Examples
    --------
    >>> superellipse_clip(1.2, 0.0, inner=(1.0, 1.0), outer=(1.5, 1.5))
    0.648
    """
    (a, b), (outer_a, outer_b) = inner, outer

    def rounded(x: Number, y: Number, roundness: Number) -> Number:
        """Return 1 inside, 0 outside, and a smooth step between two superellipses."""
        return piecewise(
            (x == 0) & (y == 0),
            lambda x, y, R: 1.0 + 0 * x,
            lambda x, y, R: (
                1
                - smoothstep(
                    1 / superellipse_scale(x, y, a, b, R),
                    1 / superellipse_scale(x, y, outer_a, outer_b, R),
                    1.0 + 0 * x,
                )
            ),
            x,
            y,
            roundness,
        )

    def rectangle(x: Number, y: Number, roundness: Number) -> Number:
        return (1 - smoothstep(a, outer_a, abs(x))) * (1 - smoothstep(b, outer_b, abs(y)))

    return piecewise(roundness > 0, rounded, rectangle, x, y, roundness)


def beam(x: Number, y: Number, z: Number, exponent: Number) -> Number:
    """Return the attenuation by the angle off the axis of a spot: a power of its cosine.

    Parameters
    ----------
    x, y, z : float or ndarray
        The point.
    exponent : float or ndarray [1]
        Exponent n, 0 or more.

    Returns
    -------
    float or ndarray [1]
        From 0 to 1; 0 for z of 0 or less.

    Raises
    ------
    ConditionError : argument out of range

    Notes
    -----
    ::

        (z / d)^n = cos^n(gamma)

    Computed with the logarithm of the cosine, which keeps the digits close to the axis.

    Examples
    --------
    >>> round(beam(3**0.5, 0.0, 1.0, 2.0), 12), beam(0.0, 0.0, -1.0, 2.0)
    (0.25, 0.0)
    """
    refuse(exponent < 0, "the beam exponent is out of range", "0 or more")
    return piecewise(
        z > 0,
        lambda z, off, n: exp(n * cones.ln_cos(atan2(off, z))),
        lambda z, off, n: 0.0 * (abs(z) + off + n),
        z,
        hypot(x, y),
        exponent,
    )


def falloff(
    distance: Number, exponent: Number, reference: Number, maximum: Number | None = None
) -> Number:
    """Return the attenuation by the distance: a power of it, limited within the fall-off distance.

    Parameters
    ----------
    distance : float or ndarray
        Distance d from the light, above 0.
    exponent : float or ndarray [1]
        Exponent N, 0 or more; 2 is an inverse square.
    reference : float or ndarray
        Fall-off distance L, above 0, at which the attenuation is 1.
    maximum : float or ndarray [1], optional
        Attenuation M at the light, 1 or more; no maximum by default.

    Returns
    -------
    float or ndarray [1]
        Up to 1 from L on; up to M within L.

    Raises
    ------
    ConditionError
        If an argument is out of range, or a float cannot hold the attenuation.

    Notes
    -----
    ::

        (L / d)^N                                    beyond L, and everywhere without a maximum
        M exp(s (d / L)^beta), s = ln(1/M), beta = -N / s       within L

    Both have the value 1 and the slope -N / L at L.  For M = 1 the limit is 1 everywhere within L.

    Examples
    --------
    >>> round(falloff(2.0, 2.0, 1.0), 12), round(falloff(0.5, 2.0, 1.0), 12)
    (0.25, 4.0)
    >>> round(falloff(1e-9, 2.0, 1.0, maximum=3.0), 6)
    3.0
    """
    refuse(distance <= 0, "the distance from the light is out of range", "more than 0")
    refuse(exponent < 0, "the fall-off exponent is out of range", "0 or more")
    refuse(reference <= 0, "the fall-off distance is out of range", "more than 0")
    if maximum is None:
        return _power(distance, exponent, reference)
    refuse(maximum < 1, "the maximum is out of range", "1 or more")
    return piecewise(
        distance < reference,
        _limited,
        lambda d, n, far, m: _power(d, n, far) + 0 * m,
        distance,
        exponent,
        reference,
        maximum,
    )


def _power(distance: Number, exponent: Number, reference: Number) -> Number:
    ratio = reference / distance
    beyond = abs(exponent * log(ratio)) > MOST
    refuse(beyond, "the attenuation is too large or too small for a number", "a smaller exponent")
    return power(ratio, exponent)


def _limited(distance: Number, exponent: Number, reference: Number, maximum: Number) -> Number:
    """Return exp(-m expm1(x / m)), with m = ln M and x = N ln(d / L), for d below L."""
    return piecewise(
        maximum > 1,
        lambda x, m: exp(-m * expm1(x / m)),
        lambda x, m: 1.0 + 0 * (x + m),
        exponent * log(distance / reference),
        log(maximum),
    )
