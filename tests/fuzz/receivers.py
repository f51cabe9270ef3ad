"""The flux of a point source on a round receiver, against another integral and limits."""

import itertools
import math
import random
from collections.abc import Callable

import numpy as np

import radcalc
from radcalc.errors import ConditionError
from radcalc.geometry import receivers

SHORT, LONG = 75, 20_000
PI = math.pi
RIM = (np.arange(20_000) + 0.5) * (2 * PI / 20_000)
NODES, WEIGHTS = np.polynomial.legendre.leggauss(80)


def round_the_rim(within: Callable, radius: float, height: float, offset: float) -> float:
    """Integrate by Green's theorem: the light within the circle of a direction, along the rim."""
    x, y = offset + radius * np.cos(RIM), radius * np.sin(RIM)
    square = x * x + y * y
    turn = radius * (radius + offset * np.cos(RIM)) / square  # of the azimuth, per step
    inside = within(np.arctan2(np.sqrt(square), height))
    return float((inside * turn).sum()) / RIM.size


def over_the_disc(n: float, radius: float, distance: float, off: float, turn: float) -> float:
    """Sum up the light of a lobe over points of a disc rotated about a line across its axis."""
    rho, psi = (NODES + 1) / 2 * radius, RIM[::100]
    u, v = rho[:, None] * np.cos(psi), rho[:, None] * np.sin(psi)
    to_disc = np.array([math.sin(off), 0.0, math.cos(off)])
    across = np.array([math.cos(off), 0.0, -math.sin(off)])
    in_disc = math.cos(turn) * across + math.sin(turn) * to_disc
    point = distance * to_disc[:, None, None] + in_disc[:, None, None] * u
    point[1] += v
    r = np.sqrt((point**2).sum(0))
    values = (point[2] / r) ** n * distance * math.cos(turn) / r**3
    return float((WEIGHTS * rho / 2) @ values.sum(1)) * radius * 2 * PI / psi.size


def size(dice: random.Random, low: float, high: float) -> float:
    return math.exp(dice.uniform(math.log(low), math.log(high)))


def sweep(count: int, seed: int) -> str:
    dice, turned = random.Random(seed), 0
    for _ in range(count):
        radius, distance = size(dice, 1e-3, 1e2), size(dice, 0.1, 10)
        off = dice.choice([0.0, dice.uniform(0, 1.4)])
        half, n = size(dice, 1e-3, 3.1), size(dice, 1e-2, 1e4)
        case = f"radius={radius}, distance={distance}, off={off}, half={half}, n={n}"
        height, offset = distance * math.cos(off), distance * math.sin(off)

        def in_cone(angle, half=half):
            return 4 * PI * np.sin(np.minimum(angle, half) / 2) ** 2

        def in_lobe(angle, n=n):
            return 2 * PI / (n + 1) * -np.expm1((n + 1) * np.log(np.cos(angle)))

        found = {
            "cone": (receivers.cone(half, radius, distance, off), in_cone),
            "lobe": (receivers.lobe(n, radius, distance, off), in_lobe),
        }
        if abs(radius - offset) > 1e-3 * (radius + offset):  # else: more points
            for name, (value, within) in found.items():
                expected = round_the_rim(within, radius, height, offset)
                # relative to the light along the whole rim; the cone has a kink at its edge
                most = float(within(math.atan2(offset + radius, height)))
                limit = (1e-3 if name == "cone" else 1e-7) * most
                assert abs(value - expected) <= limit, (name, case, value, expected)
        whole = {"cone": float(in_cone(PI)), "lobe": 2 * PI / (n + 1)}
        for name, (value, _) in found.items():
            assert 0 <= value <= whole[name] * (1 + 1e-12), (name, case, value)
        for larger, (name, own) in itertools.product((1.5, 20), (("cone", half), ("lobe", n))):
            more = getattr(receivers, name)(own, larger * radius, distance, off)
            assert more >= found[name][0] * (1 - 1e-11), (name, case, larger)
        tiny = 1e-6 * distance
        point = PI * tiny**2 * math.cos(off) / distance**2
        fall = math.cos(off) ** n
        if abs(off - half) > 1e-5:
            lit = point if off < half else 0.0
            assert math.isclose(receivers.cone(half, tiny, distance, off), lit, rel_tol=1e-9), case
        if fall > 1e-250:
            lit = receivers.lobe(n, tiny, distance, off)
            assert math.isclose(lit, point * fall, rel_tol=1e-3), case
        angle = dice.uniform(0, 1.5)
        small = min(radius, distance / 20)
        try:
            lit = receivers.lobe(n, small, distance, off, angle)
        except ConditionError:
            continue
        turned += 1
        expected = over_the_disc(n, small, distance, off, angle)
        allowed = receivers.unevenness(n, small, distance, off)
        assert abs(lit - expected) <= (allowed + 1e-9) * expected, (case, angle, lit, expected)
        flux = dice.uniform(1, 1000)
        given = {"distance": f"{distance!r}m", "receiver_area": f"{PI * radius**2!r}m2"}
        for own in ({"half_angle": f"{half!r}rad"}, {"exponent": n}, {}):
            answer = radcalc.point_source(flux=f"{flux!r}lm", **given, **own)
            assert answer["received_flux"].to("lm").magnitude <= flux * (1 + 1e-12), (case, own)
    return f"{turned} tilted receivers"


if __name__ == "__main__":
    from fuzz.command import main

    main(sweep, LONG)
