"""The cinematographer's light against an independent implementation of its formulas.

`expected` is a plain version of the model by L. Gritz (uberlight.sl, 1998, after R. Barzel, Journal
of Graphics Tools 2(1), 1997): with powers instead of radcalc's logarithms, one point at a time.
"""

import math
import random
from typing import Any

import numpy as np

import radcalc

SHORT, LONG = 150, 50_000
OMNI, SPOT = "omni", "spot"


def step(low: float, high: float, x: float) -> float:
    """Return `smoothstep` of the RenderMan Interface."""
    if x < low:
        return 0.0
    if x >= high:
        return 1.0
    t = (x - low) / (high - low)
    return 3 * t**2 - 2 * t**3


def cut(x: float, y: float, sizes: tuple[float, ...], roundness: float) -> float:
    """Return the part that the superellipses transmit."""
    a, b, outer_a, outer_b = sizes
    x, y = abs(x), abs(y)
    if x == y == 0:
        return 1.0
    if roundness == 0:
        return (1 - step(a, outer_a, x)) * (1 - step(b, outer_b, y))
    power = 2 / roundness
    q, r = (
        (w * h) / ((h * x) ** power + (w * y) ** power) ** (1 / power)
        for w, h in ((a, b), (outer_a, outer_b))
    )
    return 1 - step(q, r, 1.0)


def expected(kind: str, point: tuple[float, float, float], light: dict[str, Any]) -> float:
    """Return the attenuation."""
    x, y, z = point
    d = math.sqrt(x * x + y * y + z * z)
    depth = z if kind == SPOT else d
    if kind == SPOT and z <= 0:
        return 0.0
    found = 1.0
    if "near" in light:
        found *= step(*light["near"], depth)
    if "far" in light:
        found *= 1 - step(*light["far"], depth)
    n, far, most = light["falloff"], light["falloff_distance"], light.get("maximum")
    if d > far or most is None:
        found *= (far / d) ** n
    elif most > 1:
        s = math.log(1 / most)
        found *= most * math.exp(s * (d / far) ** (-n / s))
    if kind == SPOT:
        found *= (z / d) ** light.get("beam_exponent", 0)
        if "superellipse" in light:
            right, up = light.get("shear", (0, 0))
            roundness = light.get("roundness", 1)
            found *= cut(x / z - right, y / z - up, light["superellipse"], roundness)
    return found


def drawn(dice: random.Random, kind: str) -> dict[str, Any]:
    """Draw the settings of a light."""

    def size(low: float, high: float) -> float:
        return math.exp(dice.uniform(math.log(low), math.log(high)))

    def maybe() -> bool:
        return dice.random() < 0.6

    light: dict[str, Any] = {
        "falloff": dice.choice([0.0, 1.0, 2.0, dice.uniform(0, 6)]),
        "falloff_distance": size(0.1, 10),
    }
    if maybe():
        light["maximum"] = dice.choice([1.0, 1 + size(1e-9, 1), size(1, 1e6)])
    for name, low in (("near", 0.01), ("far", 2.0)):
        if maybe():
            start = size(low, 5)
            light[name] = (start, start + dice.choice([0.0, dice.uniform(0, 3)]))
    if kind == SPOT and maybe():
        light["beam_exponent"] = dice.choice([0.0, size(0.1, 50)])
    if kind == SPOT and maybe():
        a, b = size(0.05, 2), size(0.05, 2)
        light["superellipse"] = (a, b, a * dice.choice([1, dice.uniform(1, 3)]), b * 1.5)
        if maybe():
            light["roundness"] = dice.choice([0.0, 1.0, dice.uniform(0.02, 1)])
        if maybe():
            light["shear"] = (dice.uniform(-1, 1), dice.uniform(-1, 1))
    return light


def sweep(count: int, seed: int) -> str:
    dice, lit = random.Random(seed), 0
    for _ in range(count):
        kind = dice.choice([SPOT, SPOT, OMNI])
        light = drawn(dice, kind)
        points = [tuple(dice.uniform(-4, 4) for _ in range(3)) for _ in range(4)]
        points.append((0.0, 0.0, dice.uniform(0.1, 5)))
        given: dict[str, Any] = {**light, "falloff_distance": f"{light['falloff_distance']!r} m"}
        for name in ("near", "far"):
            if name in light:
                given[name] = ":".join(f"{end!r} m" for end in light[name])
        answer = radcalc.uberlight(points, omni=kind == OMNI, intensity="100 cd", **given)
        found = np.broadcast_to(answer["attenuation"].magnitude, len(points))
        light_there = np.broadcast_to(answer["irradiance"].magnitude, len(points))
        for point, attenuation, irradiance in zip(points, found, light_there, strict=True):
            case = (kind, point, light, attenuation)
            assert 0 <= attenuation < math.inf, case
            free = (light["falloff_distance"] / math.dist(point, (0, 0, 0))) ** light["falloff"]
            most = light.get("maximum", math.inf)
            assert attenuation <= max(1.0, min(free, most)) * (1 + 1e-12), case
            right = expected(kind, point, light)
            assert math.isclose(attenuation, right, rel_tol=1e-9, abs_tol=1e-12), (case, right)
            right = 100 * attenuation / light["falloff_distance"] ** 2
            assert math.isclose(irradiance, right, rel_tol=1e-12), case
            lit += attenuation > 0
    return f"{lit} points in the light"


if __name__ == "__main__":
    from fuzz.command import main

    main(sweep, LONG)
