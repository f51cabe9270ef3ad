"""Solid angles against textbook formulas and defining integrals, at 80 digits by mpmath."""

import math
import random

import mpmath
import numpy as np
import pytest
from mpmath import mpf

from radcalc.errors import ConditionError
from radcalc.geometry import directions, etendue, projected, solid
from radcalc.geometry.numerics import special

DIGITS = 80  # the references may lose half of them


def close(got, reference, rel=1e-12) -> None:
    """A float within a relative bound of a reference of many digits; 0 only for exactly 0."""
    with mpmath.workdps(DIGITS):
        assert abs(mpf(got) - reference) <= rel * abs(reference), (got, mpmath.nstr(reference, 20))


def exact(reference):
    """A reference that is computed with `DIGITS` digits, from the floats as they are."""

    def at(*xs):
        with mpmath.workdps(DIGITS):
            return reference(*map(mpf, xs))

    return at


# --- References: definitions and textbook formulas, nothing of radcalc's.


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
    """The textbook's, with K and Pi, here itself checked by the defining integral, `strips`."""
    top = mpmath.sqrt(height**2 + (radius + offset) ** 2)
    m, n = 4 * radius * offset / top**2, 4 * radius * offset / (radius + offset) ** 2
    third = 0 if radius == offset else (radius - offset) / (radius + offset) * mpmath.ellippi(n, m)
    turn = mpmath.pi * (1 + mpmath.sign(radius - offset))
    return turn - 2 * height / top * (mpmath.ellipk(m) + third)


@exact
def strips(radius, height, offset):
    """The defining integral of a disc, whose strips across the offset are elementary."""

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
    """The textbook's element parallel to a rectangle, above one of its corners."""

    def term(x, y):
        x, y = x / height, y / height
        a, b = mpmath.sqrt(1 + x * x), mpmath.sqrt(1 + y * y)
        return (x / a * mpmath.atan(y / a) + y / b * mpmath.atan(x / b)) / 2

    return corners_mp(term, width, length, offset, offset_y)


@exact
def sideways_rectangle_mp(width, length, height, offset, offset_y):
    """Both integrals of x h/r^4, over the part at x > 0, which a receiver facing +x sees."""
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
    """The textbook's element parallel to a disc, off its axis."""
    z = height**2 + offset**2 + radius**2
    return (
        mpmath.pi / 2 * (1 - (z - 2 * radius**2) / mpmath.sqrt(z * z - (2 * radius * offset) ** 2))
    )


@exact
def tilted_disc_mp(radius, height, offset, tilt):
    """The defining integral over what the horizon leaves, whose strips are elementary."""
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


# --- Closed forms.

ANGLES = [1e-9, 1e-6, 1e-3, 0.1, 1.0, 1.5, math.pi / 2, 2.0, 3.0, 3.1415926, math.pi]
TINY = [1e-9, 3e-7, 1e-4, 0.03, 0.5, 1.0, 7.0, 1e3, 1e6, 1e9]


@pytest.mark.parametrize("angle", ANGLES)
def test_a_cone_is_the_integral_of_its_zones(angle):
    close(solid.cone(angle), cone_mp(angle))
    want = mpmath.pi if angle >= math.pi / 2 else None  # from there on all that the receiver sees
    with mpmath.workdps(DIGITS):
        close(projected.cone(angle), want or mpmath.pi * mpmath.sin(mpf(angle)) ** 2)


@pytest.mark.parametrize("angle", [1e-9, 1e-4, 0.2, 0.7])
@pytest.mark.parametrize("tilt", [0.0, 1e-9, 0.3, -0.3, 0.8])
def test_a_cone_above_the_horizon_is_foreshortened(angle, tilt):
    with mpmath.workdps(DIGITS):
        want = mpmath.pi * mpmath.sin(mpf(angle)) ** 2 * mpmath.cos(mpf(tilt))
    close(projected.cone(angle, tilt), want)


ZONES = [
    (0.0, 1e-9), (1e-9, 2e-9), (0.0, math.pi), (0.5, 0.5 + 2**-40), (1e-9, 1.0), (0.3, 2.0),
    (math.pi / 2 - 1e-9, math.pi / 2), (math.pi / 2 - 1e-3, math.pi / 2 + 1e-3), (1.0, math.pi),
    (math.pi - 2e-9, math.pi - 1e-9), (math.pi - 1e-9, math.pi), (3.0, 3.0 + 2**-45), (2.0, 2.0),
]  # fmt: skip


@pytest.mark.parametrize(("lower", "upper"), ZONES)
@pytest.mark.parametrize("azimuth", [1e-9, 1.0, 2 * math.pi])
def test_a_zone_is_a_difference_of_cosines(lower, upper, azimuth):
    close(solid.zone(lower, upper, azimuth), zone_mp(lower, upper, azimuth))
    with mpmath.workdps(DIGITS):
        low, high = (min(mpf(x), mpmath.pi / 2) for x in (lower, upper))
        want = mpf(azimuth) / 2 * (mpmath.sin(high) ** 2 - mpmath.sin(low) ** 2)
    close(projected.zone(lower, upper, azimuth), want)


SPHERES = [(1.0, 1 + 2.0**-k) for k in (52, 51, 40, 30, 20, 3)] + [
    (1.0, 2.0), (1.0, 1e3), (1.0, 1e9), (1e-9, 1.0), (3e-9, 7e8), (695700e3, 149597870700.0),
]  # fmt: skip


@pytest.mark.parametrize(("radius", "distance"), SPHERES)
def test_a_sphere_is_the_cone_that_touches_it(radius, distance):
    close(solid.sphere(radius, distance), sphere_mp(radius, distance))
    with mpmath.workdps(DIGITS):
        want = mpmath.pi * (mpf(radius) / mpf(distance)) ** 2
        close(solid.angular_radius(radius, distance), mpmath.asin(mpf(radius) / mpf(distance)))
    close(projected.sphere(radius, distance), want)


@pytest.mark.parametrize("height", TINY)
def test_a_disc_on_its_axis(height):
    with mpmath.workdps(DIGITS):
        h = mpf(height)
        close(solid.disc(1.0, height), 2 * mpmath.pi * (1 - h / mpmath.sqrt(h * h + 1)))
        close(projected.disc(1.0, height), mpmath.pi / (1 + h * h))


@pytest.mark.parametrize(
    ("height", "offset"),
    [(0.5, 0.3), (2.0, 1.0), (0.1, 1.5), (1e-3, 0.999), (1e-6, 1.0), (3.0, 50.0), (1e-9, 0.2)],
)
def test_the_reference_of_a_disc_is_its_defining_integral(height, offset):
    reference = strips(1.0, height, offset)
    close(disc_mp(1.0, height, offset), reference, 1e-18)
    close(solid.disc(1.0, height, offset), reference)


OFFSETS = [1e-9, 0.2, 0.9, 1 - 1e-9, 1 - 2**-53, 1.0, 1 + 2**-52, 1 + 1e-9, 1.1, 3.9, 4.1, 1e4, 1e9]


@pytest.mark.parametrize("offset", OFFSETS)
def test_a_disc_off_its_axis_within_on_and_outside_the_rim(offset):
    for height in TINY:
        close(solid.disc(1.0, height, offset), disc_mp(1.0, height, offset))
        close(solid.disc(1.0, height, -offset), disc_mp(1.0, height, offset))
        close(projected.disc(1.0, height, offset), facing_disc_mp(1.0, height, offset))


SIDES = [(1.0, 1.0), (1e-9, 1.0), (1.0, 1e-9), (1e-9, 1e-9), (2.0, 0.3), (1e6, 1e-3)]
PLACES = [(0.0, 0.0), (0.5, 0.5), (0.2, 0.0), (0.0, 3.0), (2.0, -1.0), (1e3, 1e3), (1e-9, 0.0)]


def test_the_references_of_rectangles_are_the_defining_integrals():
    at = (1.0, 2.0, 0.75, 0.25, -0.5)
    width, length, height, offset, offset_y = map(mpf, at)
    x = [-offset - width / 2, 0, -offset + width / 2]
    y = [-offset_y - length / 2, -offset_y + length / 2]

    def over(weight, low=0):
        def part(x, y):
            return weight(x, y) / (x * x + y * y + height**2) ** 2

        return mpmath.quad(part, x[low:], y)

    with mpmath.workdps(20):
        facing = over(lambda x, y: height**2)
        sideways = over(lambda x, y: x * height, low=1)
        whole = over(lambda x, y: height * mpmath.sqrt(x * x + y * y + height**2))
    close(facing_rectangle_mp(*at), facing, 1e-15)
    close(sideways_rectangle_mp(*at), sideways, 1e-15)
    close(rectangle_mp(*at), whole, 1e-15)


@pytest.mark.usefixtures("_few_calls")
@pytest.mark.parametrize(("width", "length"), SIDES)
@pytest.mark.parametrize("height", [1e-6, 1e-3, 0.5, 20.0, 1e9])
def test_a_rectangle_is_its_four_corners(width, length, height):
    for offset, offset_y in PLACES:
        at = (width, length, height, offset, offset_y)
        close(solid.rectangle(*at), rectangle_mp(*at))
        close(projected.rectangle(*at), facing_rectangle_mp(*at))
        side = projected.rectangle(*at, normal=(1.0, 0.0, 0.0))
        close(side, sideways_rectangle_mp(*at))


def test_a_rectangle_on_its_axis():
    # 4 arctan(a b / (h sqrt(a^2 + b^2 + h^2))) with half sides a and b; a cube's face has 4pi/6
    close(solid.rectangle(2.0, 2.0, 1.0), 2 * math.pi / 3, 1e-15)
    close(solid.rectangle(6.0, 8.0, 12.0), 4 * math.atan(1 / 13), 1e-15)  # 3, 4, 12, and 13


HALVES = [1e-9, 1e-5, 0.1, 1.0, math.pi / 2, 3.0, math.pi - 1e-5, math.pi - 1e-9]


@pytest.mark.parametrize("horizontal", HALVES)
@pytest.mark.parametrize("vertical", HALVES)
def test_a_pyramid_is_a_rectangle_at_height_one(horizontal, vertical):
    with mpmath.workdps(DIGITS):
        a, b = (2 * mpmath.tan(mpf(x) / 2) for x in (horizontal, vertical))
    close(solid.pyramid(horizontal, vertical), rectangle_mp(a, b, 1, 0, 0))
    close(projected.pyramid(horizontal, vertical), facing_rectangle_mp(a, b, 1, 0, 0))


def test_the_widest_pyramids():
    # two half planes' wedge of a full angle a is the lune of 2a; both open, the hemisphere
    close(solid.pyramid(math.pi, math.pi), 2 * math.pi)
    close(solid.pyramid(1.0, math.pi), 2.0)
    close(projected.pyramid(math.pi, math.pi), math.pi)
    close(projected.pyramid(1.0, math.pi), math.pi * math.sin(0.5))


@pytest.mark.parametrize("radius", [1e-9, 0.3, 1.0, 2.0, 1e9])
@pytest.mark.parametrize("distance", [1e-9, 1e-3, 1.0, 1e4, 1e9])
def test_two_discs_on_one_axis(radius, distance):
    with mpmath.workdps(DIGITS):
        # the textbook's, itself checked by the rings below
        s = 1 + mpf(radius) ** 2 + mpf(distance) ** 2
        want = mpmath.pi**2 / 2 * (s - mpmath.sqrt(s * s - 4 * mpf(radius) ** 2))
    close(etendue.coaxial_discs(1.0, radius, distance), want)


def test_two_discs_are_the_rings_of_one_seen_by_the_other():
    for radius, distance in ((0.5, 0.3), (2.0, 1.0)):
        with mpmath.workdps(20):
            want = mpmath.quad(
                lambda r, R=radius, d=distance: 2 * mpmath.pi * r * facing_disc_mp(R, d, r), [0, 1]
            )
        close(etendue.coaxial_discs(1.0, radius, distance), want)


@pytest.mark.parametrize(
    ("one", "other", "distance", "factor"),
    [
        # the examples of EES's heat transfer library, fchart.com/ees/heat_transfer_library/
        # transient_conduction/shape_factors/hs203.htm and shape_factors/hs308.htm
        (0.1, 0.2, 0.5, 0.1339),
        (0.5, 1.0, 2.0, 0.1922),
    ],
)
def test_published_view_factors_of_two_discs(one, other, distance, factor):
    got = etendue.coaxial_discs(one, other, distance) / (math.pi * math.pi * one**2)
    assert got == pytest.approx(factor, abs=5e-5)


def test_etendues_of_patches():
    close(etendue.patch_and_cone(2.0, math.pi / 6), math.pi / 2)  # pi A sin^2
    close(etendue.patch_and_aperture(2.0, 0.5), math.pi / 2)  # pi A NA^2
    close(etendue.patch_and_lens(2.0, 1.0), math.pi / 2)  # sin = 1/2N
    close(etendue.two_patches(2.0, 3.0, 10.0, math.pi / 3, math.pi / 3), 0.015, 1e-15)
    assert etendue.two_patches(2.0, 3.0, 10.0, 2.0) == 0
    close(solid.patch(2.0, 10.0, math.pi / 3), 0.01, 1e-15)


# --- Special functions and inverses.


@pytest.mark.parametrize("kc", [1e-9, 1e-3, 0.4, 1.0, 3.0, 1e3])
@pytest.mark.parametrize("p", [1e-9, 1e-4, 0.5, 1.0, 2.0, 1e6])
def test_bulirschs_integral_is_legendres(kc, p):
    with mpmath.workdps(DIGITS):
        m, n = 1 - mpf(kc) ** 2, 1 - mpf(p)
        first, second, third = mpmath.ellipk(m), mpmath.ellipe(m), mpmath.ellippi(n, m)
        mixed = (third - first) / n if n else None
        square = mpf(kc) ** 2
    close(special.cel(kc, 1.0, 1.0, 1.0), first)
    close(special.cel(kc, 1.0, 1.0, float(square)), second)
    close(special.cel(kc, p, 1.0, 1.0), third)
    if mixed is not None:  # sin^2 above: n sin^2 = 1 - (1 - n sin^2) gives (Pi - K)/n
        close(special.cel(kc, p, 0.0, 1.0), mixed)


@pytest.mark.parametrize("x", [1e-9, 1e-3, 0.1, 0.2499, 0.25, 0.2501, 0.7, 0.999999, 1.0])
def test_differences_keep_their_digits(x):
    with mpmath.workdps(DIGITS):
        close(special.less_arctangent(x), mpf(x) - mpmath.atan(mpf(x)))
        close(special.arc_excess(x), mpmath.asin(mpf(x)) / mpf(x) - 1)


@pytest.mark.parametrize("angle", [1e-9, 1e-4, 0.3, 1.0, 2.0, 3.0])
def test_a_cone_and_back(angle):
    close(solid.cone_of(solid.cone(angle)), angle)
    assert solid.cone_of(12.566370614359173) == pytest.approx(math.pi, rel=1e-7)
    assert solid.cone_of(12.566370614360) == pytest.approx(math.pi, rel=1e-7)  # as typed


@pytest.mark.parametrize(("radius", "distance"), SPHERES[1:])
def test_a_sphere_and_back(radius, distance):
    size = solid.sphere(radius, distance)
    close(solid.sphere_distance(radius, size), distance)
    close(solid.sphere_radius(distance, size), radius)


# --- What the receiver's horizon cuts.


def sunken_cones():
    draw = random.Random(11)
    for k in range(25):
        angle = 10 ** draw.uniform(-9, 0) if k % 2 else draw.uniform(0.05, 1.57)
        height = draw.uniform(-0.999, 0.999)  # of the axis over the horizon, in sines of angle
        yield angle, math.acos(height * math.sin(angle))
    yield from ((1.0, 2.57), (1e-3, math.pi / 2 + 0.999999e-3), (2.0, 1.0), (3.0, 1.3))
    yield from ((math.pi / 2 + x, 1.0) for x in (-1e-3, -1e-6, -1e-9, 0.0, 1e-9, 1e-6))


@pytest.mark.parametrize(("angle", "tilt"), list(sunken_cones()))
def test_a_cone_that_the_horizon_cuts(angle, tilt):
    reference = tilted_cone_mp(angle, tilt)
    close(projected.cone(angle, tilt), reference, 1e-9)
    close(projected.cone(angle, -tilt), reference, 1e-9)
    if 1e-6 < angle < 1.5:
        distance = 1 / math.sin(angle)
        close(projected.sphere(1.0, distance, tilt), reference, 1e-9)


def tilted_discs():
    draw = random.Random(12)
    for _ in range(25):
        height, offset = (10 ** draw.uniform(-2, 3) for _ in "ho")
        cut = offset + draw.uniform(-0.98, 0.98)  # where the horizon meets the disc
        yield height, offset, math.atan2(-height, cut) + draw.choice((0.0, math.pi))
    yield from ((0.5, 0.0, 1.4), (0.5, 0.0, -1.4), (1e-6, 0.5, 1.5), (1e-6, 1.0, -1.5))


@pytest.mark.usefixtures("_few_calls")
@pytest.mark.parametrize(("height", "offset", "tilt"), list(tilted_discs()))
def test_a_disc_that_the_horizon_cuts(height, offset, tilt):
    got = projected.disc(1.0, height, offset, tilt)
    close(got, tilted_disc_mp(1.0, height, offset, tilt), 1e-9)


@pytest.mark.parametrize("tilt", [0.2, -0.2, 1e-9])
def test_a_tilted_disc_above_the_horizon(tilt):
    close(projected.disc(1.0, 3.0, 0.5, tilt), tilted_disc_mp(1.0, 3.0, 0.5, tilt))


def test_what_is_below_the_horizon_counts_for_nothing():
    assert projected.cone(0.5, math.pi) == 0
    assert projected.sphere(1.0, 2.0, 3.0) == 0
    assert projected.disc(1.0, 2.0, 0.0, math.pi) == 0
    assert projected.rectangle(1.0, 1.0, 2.0, normal=(0.0, 0.0, -1.0)) == 0
    assert projected.zone(1.6, 3.0) == 0


# --- Refusals, and arrays.

REFUSED = [
    (solid.cone, (-1e-9,)), (solid.cone, (3.15,)), (solid.cone_of, (-1.0,)),
    (solid.cone_of, (12.6,)), (solid.zone, (1.0, 0.5)), (solid.zone, (-0.1, 0.5)),
    (solid.zone, (0.1, 3.2)), (solid.zone, (0.1, 1.0, 6.4)), (solid.sphere, (1.0, 1.0)),
    (solid.sphere, (2.0, 1.0)), (solid.sphere, (-1.0, 1.0)), (solid.sphere_distance, (1.0, 6.3)),
    (solid.sphere_radius, (1.0, 0.0)), (solid.disc, (1.0, 0.0)), (solid.disc, (-1.0, 1.0)),
    (solid.rectangle, (1.0, -1.0, 1.0)), (solid.rectangle, (1.0, 1.0, 0.0)),
    (solid.pyramid, (3.2, 1.0)), (solid.patch, (1.0, 0.0)), (solid.patch, (-1.0, 1.0)),
    (projected.cone, (1.0, 3.2)), (projected.sphere, (1.0, 1.0)), (projected.disc, (1.0, -1.0)),
    (projected.zone, (1.0, 0.5)), (projected.pyramid, (-1.0, 1.0)),
    (projected.rectangle, (1.0, 1.0, 1.0, 0.0, 0.0, (0.0, 0.0, 0.0))),
    (etendue.patch_and_cone, (1.0, 1.6)), (etendue.patch_and_aperture, (1.0, 1.1)),
    (etendue.patch_and_lens, (1.0, 0.4)), (etendue.two_patches, (1.0, 1.0, 0.0)),
    (etendue.coaxial_discs, (1.0, 1.0, 0.0)), (directions.spherical, (0.0, 0.0, 0.0)),
    (directions.cartesian, (-0.1, 0.0)),
]  # fmt: skip


@pytest.mark.parametrize(("function", "arguments"), REFUSED)
def test_what_no_observer_sees_is_refused(function, arguments):
    with pytest.raises(ConditionError) as caught:
        function(*arguments)
    assert caught.value.hint
    with pytest.raises(ConditionError):
        function(np.array([arguments[0]] * 2), *arguments[1:])


ARRAYS = [
    (solid.cone, [0.0, 1e-9, 1.0, 3.0]),
    (solid.cone_of, [0.0, 1e-9, 1.0, 12.566370614360]),
    (solid.zone, [0.0, 0.1, 0.5], [0.5, 1.0, 3.0], [1.0, 6.0]),
    (solid.angular_radius, [0.1, 1.0], [1.5, 1e9]),
    (solid.sphere, [0.0, 0.1, 1.0], [1.0000001, 2.0, 1e9]),
    (solid.sphere_distance, [0.1, 1.0], [1e-9, 1.0, 6.0]),
    (solid.sphere_radius, [0.1, 1.0], [1e-9, 1.0, 6.0]),
    (solid.disc, [0.0, 1.0, 2.0], [1e-3, 0.5, 100.0], [-3.0, 0.0, 1.0, 2.0]),
    (solid.rectangle, [1e-3, 1.0], [0.5, 2.0], [0.1, 1.0], [0.0, 0.5], [0.0, 3.0]),
    (solid.pyramid, [0.0, 1e-9, 1.0, 3.14], [1e-9, 1.0, 3.1]),
    (solid.patch, [0.0, 1.0], [1.0, 2.0], [0.0, 1.0, 2.0]),
    (projected.cone, [1e-9, 0.5, 1.5, 2.5], [0.0, 0.4, -1.4, 2.0, 3.1]),
    (projected.zone, [0.0, 0.1, 0.5], [0.5, 1.0, 3.0], [1.0, 6.0]),
    (projected.sphere, [0.1, 1.0], [1.1, 2.0], [0.0, 1.0, 2.0]),
    (projected.disc, [0.1, 1.0], [1e-3, 0.5], [0.0, 1.0, 2.0], [0.0, 0.5, 1.5, -1.5, 3.0]),
    (projected.disc, [0.1, 1.0], [1e-3, 0.5], [0.0, 1.0, 2.0]),
    (projected.rectangle, [1e-3, 1.0], [0.5, 2.0], [0.1, 1.0], [0.0, 0.5], [0.0, 3.0]),
    (projected.pyramid, [0.0, 1e-9, 1.0, 3.14], [1e-9, 1.0, 3.1]),
    (etendue.patch_and_cone, [1.0, 2.0], [0.0, 1.0, 1.5]),
    (etendue.patch_and_aperture, [1.0, 2.0], [0.1, 1.0]),
    (etendue.patch_and_lens, [1.0, 2.0], [0.5, 4.0]),
    (etendue.two_patches, [1.0, 2.0], [1.0, 3.0], [1.0, 9.0], [0.0, 2.0], [0.0, 1.0]),
    (etendue.coaxial_discs, [0.1, 1.0], [0.2, 1.0], [1e-3, 1.0, 1e6]),
    (special.cel, [1e-3, 1.0], [0.5, 1.0], [1.0], [0.0, 1.0]),
    (special.less_arctangent, [0.0, 0.1, 0.25, 2.0]),
    (special.arc_excess, [0.0, 0.1, 0.25, 1.0]),
]


@pytest.mark.usefixtures("_few_calls")
@pytest.mark.parametrize(("function", "axes"), [(f, axes) for f, *axes in ARRAYS])
def test_arrays_give_what_floats_give(function, axes):
    grids = np.meshgrid(*axes, indexing="ij")
    floats = [function(*map(float, at)) for at in zip(*(g.ravel() for g in grids), strict=True)]
    want = np.reshape(floats, grids[0].shape)
    np.testing.assert_allclose(function(*grids), want, rtol=2e-13, atol=0)
    # open axes, which broadcast, and a float for the last one
    np.testing.assert_allclose(function(*np.ix_(*axes)), want, rtol=2e-13, atol=0)
    if len(axes) > 1:
        part = function(*np.ix_(*axes[:-1]), float(axes[-1][-1]))
        np.testing.assert_allclose(part, want[..., -1], rtol=2e-13, atol=0)
