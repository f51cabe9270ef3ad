"""References: definitions and textbook formulas with 80 digits, independent of radcalc."""

import mpmath
import numpy
from mpmath import mpf

DIGITS = 80  # the references may lose half of them


def close(got, reference, rel=1e-12) -> None:
    """Assert that a float is within a relative bound of a reference (exactly 0 for 0)."""
    with mpmath.workdps(DIGITS):
        assert abs(mpf(got) - reference) <= rel * abs(reference), (got, mpmath.nstr(reference, 20))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b, strict=True))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    size = mpmath.sqrt(dot(a, a))
    return tuple(x / size for x in a)


def exact(reference):
    """Make a reference compute with `DIGITS` digits, from the exact values of floats."""

    def at(*xs):
        with mpmath.workdps(DIGITS):
            return reference(*map(mpf, xs))

    return at


@exact
def cone_mp(angle):
    return 2 * mpmath.pi * (1 - mpmath.cos(angle))  # the definition, integrated


@exact
def zone_mp(lower, upper, azimuth):
    return azimuth * (mpmath.cos(lower) - mpmath.cos(upper))


@exact
def sphere_mp(radius, distance):
    return 2 * mpmath.pi * (1 - mpmath.sqrt(1 - (radius / distance) ** 2))


@exact
def disc_mp(radius, height, offset):
    """The textbook's formula, with K and Pi; the defining integral, `strips`, checks it."""
    top = mpmath.sqrt(height**2 + (radius + offset) ** 2)
    m, n = 4 * radius * offset / top**2, 4 * radius * offset / (radius + offset) ** 2
    third = 0 if radius == offset else (radius - offset) / (radius + offset) * mpmath.ellippi(n, m)
    turn = mpmath.pi * (1 + mpmath.sign(radius - offset))
    return turn - 2 * height / top * (mpmath.ellipk(m) + third)


@exact
def strips(radius, height, offset):
    """The defining integral of a disc; strips perpendicular to the offset are elementary."""

    def strip(u):
        x = height * mpmath.sinh(u)
        square, reach = x * x + height**2, radius**2 - (x - offset) ** 2
        root = mpmath.sqrt(abs(reach))
        return 2 * root / mpmath.sqrt(square + reach) / mpmath.cosh(u)

    with mpmath.workdps(25):
        ends = [mpmath.asinh((offset + sign * radius) / height) for sign in (-1, 1)]
        return mpmath.quad(strip, mpmath.linspace(*ends, 5))


def corners_mp(term, width, length, offset, offset_y):
    total = mpf(0)
    for i in (1, -1):
        for j in (1, -1):
            total += i * j * term(offset + i * width / 2, offset_y + j * length / 2)
    return total


@exact
def rectangle_mp(width, length, height, offset, offset_y):
    """The double integral of h/r^3 is arctan(xy / hr), between the corners."""

    def term(x, y):
        return mpmath.atan(x * y / (height * mpmath.sqrt(x * x + y * y + height**2)))

    return corners_mp(term, width, length, offset, offset_y)


@exact
def facing_rectangle_mp(width, length, height, offset, offset_y):
    """The textbook's formula for an element parallel to a rectangle, above one corner."""

    def term(x, y):
        x, y = x / height, y / height
        a, b = mpmath.sqrt(1 + x * x), mpmath.sqrt(1 + y * y)
        return (x / a * mpmath.atan(y / a) + y / b * mpmath.atan(x / b)) / 2

    return corners_mp(term, width, length, offset, offset_y)


@exact
def sideways_rectangle_mp(width, length, height, offset, offset_y):
    """The double integral of x h/r^4 over x > 0, the part seen by a receiver that faces +x."""
    low, high = -offset - width / 2, -offset + width / 2
    if high <= 0:
        return mpf(0)
    y0, y1 = -offset_y - length / 2, -offset_y + length / 2

    def at(x):
        away = mpmath.sqrt(x * x + height**2)
        return (mpmath.atan(y1 / away) - mpmath.atan(y0 / away)) / away

    return height / 2 * (at(max(low, mpf(0))) - at(high))


@exact
def facing_disc_mp(radius, height, offset):
    """The textbook's formula for an element parallel to a disc, off its axis."""
    z = height**2 + offset**2 + radius**2
    return (
        mpmath.pi / 2 * (1 - (z - 2 * radius**2) / mpmath.sqrt(z * z - (2 * radius * offset) ** 2))
    )


@exact
def tilted_disc_mp(radius, height, offset, tilt):
    """The defining integral over the part above the horizon; its strips are elementary."""
    sine, cosine = mpmath.sin(tilt), mpmath.cos(tilt)

    def strip(x):
        reach = mpmath.sqrt(abs(radius**2 - (x - offset) ** 2))
        away = mpmath.sqrt(x * x + height**2)
        ends = reach / (away**2 + reach**2) + mpmath.atan(reach / away) / away
        return (sine * x + cosine * height) * height / away**2 * ends

    low, high, cut = offset - radius, offset + radius, -cosine * height / sine
    low, high = (max(low, cut), high) if sine > 0 else (low, min(high, cut))
    if low >= high:
        return mpf(0)
    points = [low, *(x for x in (-height, mpf(0), height) if low < x < high), high]
    with mpmath.workdps(30):
        return mpmath.quad(strip, points)


@exact
def tilted_cone_mp(angle, tilt):
    """The defining integral, zone by zone about the receiver's normal."""
    whole = max(angle - tilt, mpf(0))  # up to here all azimuths are within the cone
    low, high = max(whole, tilt - angle), min(tilt + angle, mpmath.pi / 2)

    def zone(s):
        polar = low + (high - low) * s * s
        cosine = (mpmath.cos(angle) - mpmath.cos(tilt) * mpmath.cos(polar)) / (
            mpmath.sin(tilt) * mpmath.sin(polar)
        )
        turn = mpmath.acos(min(max(cosine, mpf(-1)), mpf(1)))
        return 4 * turn * mpmath.sin(polar) * mpmath.cos(polar) * (high - low) * s

    with mpmath.workdps(40):
        part = mpmath.quad(zone, [0, 0.5, 1]) if low < high else 0
        return mpmath.pi * mpmath.sin(min(whole, mpmath.pi / 2)) ** 2 + part


def over_rectangle(function, across, down, points=40):
    """The integral of a smooth function of arrays, by Gauss-Legendre points in both directions.

    The function may return several integrands, along its first axes.
    """
    nodes, weights = numpy.polynomial.legendre.leggauss(points)
    (x, wide), (y, high) = (
        ((a + b) / 2 + (b - a) / 2 * nodes, (b - a) / 2 * weights) for a, b in (across, down)
    )
    return numpy.asarray(function(x[:, None], y[None, :])) @ high @ wide


def excess(vertices):
    """Girard's theorem for a convex polygon: the excess of its angles over a flat polygon's."""
    with mpmath.workdps(DIGITS):
        points = [tuple(map(mpf, p)) for p in vertices]
        total = -(len(points) - 2) * mpmath.pi
        for i, p in enumerate(points):
            before, after = points[i - 1], points[(i + 1) % len(points)]
            total += mpmath.acos(dot(unit(cross(p, before)), unit(cross(p, after))))
        return total


def lambert(vertices, normal):
    """The signed component of the light vector, by Lambert's contour formula with 80 digits.

    The part of the polygon below the horizon counts negatively.
    """
    with mpmath.workdps(DIGITS):
        points = [unit(tuple(map(mpf, p))) for p in vertices]
        total = mpf(0)
        for a, b in zip(points, points[1:] + points[:1], strict=True):
            side = cross(a, b)
            sine = mpmath.sqrt(dot(side, side))
            total += dot(side, tuple(map(mpf, normal))) / sine * mpmath.atan2(sine, dot(a, b))
        size = mpmath.sqrt(dot(normal, tuple(map(mpf, normal))))
        return total / 2 / size
