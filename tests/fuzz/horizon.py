"""Distant patches, tilted and rotated, up to the horizon: against sums over their points.

The printed bound of the far field ("within 1.2 %") is checked for discs and rectangles of all
shapes; the light of a disc cut by the horizon is compared with the sum over its visible part.
"""

import math
import random
import re

import numpy as np

from radcalc.calculators.etendue import etendue
from radcalc.calculators.lambertian import lambertian
from radcalc.calculators.solid_angle import solid_angle
from radcalc.errors import ConditionError
from radcalc.inputs.reading import read

SHORT, LONG = 75, 20_000
PI = math.pi
SIDE = 20  # points


def points(shape: tuple[float, ...]) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return points of a disc (a radius) or of a rectangle (two sides) about 0, and their areas."""
    nodes, weights = np.polynomial.legendre.leggauss(SIDE)
    if len(shape) == 1:
        rho, turn = (nodes + 1) / 2 * shape[0], np.arange(2 * SIDE) * (PI / SIDE)
        area = weights / 2 * shape[0] * rho * (PI / SIDE)
        x, y = rho[:, None] * np.cos(turn), rho[:, None] * np.sin(turn)
        return x.ravel(), y.ravel(), np.repeat(area, 2 * SIDE)
    x, y = (nodes * side / 2 for side in shape)
    area = np.outer(weights, weights) * shape[0] * shape[1] / 4
    return np.repeat(x, SIDE), np.tile(y, SIDE), area.ravel()


def patch(shape, spin: float, tilt: float, azimuth: float):
    """Return points, normal and areas of a patch rotated in its plane and tilted from +z."""
    x, y, area = points(shape)
    x, y = x * math.cos(spin) - y * math.sin(spin), x * math.sin(spin) + y * math.cos(spin)
    along = np.array([math.cos(azimuth), math.sin(azimuth), 0.0])
    across = np.array([-math.sin(azimuth), math.cos(azimuth), 0.0])
    slope = math.cos(tilt) * along - math.sin(tilt) * np.array([0.0, 0.0, 1.0])
    normal = math.sin(tilt) * along + math.cos(tilt) * np.array([0.0, 0.0, 1.0])
    return x[:, None] * slope + y[:, None] * across, normal, area


def exact(source, receiver, distance: float, power: float = 2, other: bool = True) -> float:
    """Sum up dA1 cos1 dA2 cos2 / r^2; the receiver is above the source and turned to it."""
    at, normal, area = source
    total = 0.0
    for spot, share in zip(receiver[0], receiver[2], strict=True):
        line = spot + np.array([0.0, 0.0, distance]) - at
        value = np.maximum(line @ normal, 0) / (line**2).sum(1) ** power
        if other:
            value = value * np.maximum(-(line @ receiver[1]), 0)
        total += share * float(value @ area)
    return total


def drawn(dice: random.Random) -> tuple[tuple[float, ...], dict[str, str], float]:
    """Draw a shape, its inputs and its size."""
    kind = dice.choice(["radius", "area", "sides"])
    if kind == "sides":
        sides = (1.0, math.exp(dice.uniform(-4, 0)))
        size = max(1.0, 2 * math.sqrt(sides[1] / PI))
        return sides, {"width": "1m", "length": f"{sides[1]!r}m"}, size
    if kind == "radius":
        return (0.5,), {"radius": "0.5m"}, 1.0
    shape = dice.choice([(1 / math.sqrt(PI),), (1.0, 1.0)])
    return shape, {"area": "1m2"}, 2 / math.sqrt(PI)


def percent(texts) -> float:
    (found,) = [m for text in texts if (m := re.search(r"at most ([\d.e-]+) %", text))]
    return float(found[1]) / 100 * 1.05  # two digits are shown


def value_of(answer, name: str) -> float:
    (found,) = (one.si for one in answer.values if one.name == name)
    return found


class Bounds:
    """Statistics of the printed bounds: the largest error relative to its bound, and refusals."""

    def __init__(self) -> None:
        self.most, self.cut, self.refused = 0.0, 0, 0

    def hold(self, case: str, answer, found: float, expected: float) -> None:
        if expected == 0 or found == 0:
            assert found == expected == 0, (case, found, expected)
            return
        bound, off = percent(answer.assumptions), abs(found / expected - 1)
        assert off <= bound, (case, found, expected, bound)
        self.most = max(self.most, off / bound)

    def ask(self, calculator, *shape, **texts):
        given = {
            name.replace("_", "-"): read(name.replace("_", "-"), texts[name]) for name in texts
        }
        try:
            return calculator(*shape, given)
        except ConditionError as error:
            if "cut the" not in error.message:
                raise
            self.refused += 1
            return None


def sweep(count: int, seed: int) -> str:
    dice, held = random.Random(seed), Bounds()
    spot = np.zeros((1, 3))
    for _ in range(count):
        shape, given, size = drawn(dice)
        distance = size * dice.choice([5.0001, math.exp(dice.uniform(math.log(5.0001), 4))])
        edge = PI / 2 - dice.choice([-1, 1]) * math.exp(dice.uniform(-6, 0)) / 5
        tilt = dice.choice([0.0, dice.uniform(0, 1.55)])
        incidence = dice.choice([0.0, dice.uniform(0, 1.5), edge])
        spin, azimuth = dice.uniform(0, PI), dice.uniform(0, 2 * PI)
        case = f"{given} {distance=} {tilt=} {incidence=} {spin=} {azimuth=} {shape=}"
        source = patch(shape, spin, tilt, 0.0)
        sine = math.sin(incidence)
        below = -np.array([sine * math.cos(azimuth), sine * math.sin(azimuth), math.cos(incidence)])
        texts = {**given, "distance": f"{distance!r}m", "tilt": f"{tilt!r}rad"}
        if "width" not in given:
            facing = -np.array([0.0, 0.0, 1.0])
            seen = exact(source, (spot, facing, [1.0]), distance, power=1.5, other=False)
            answer = solid_angle("patch", {name: read(name, texts[name]) for name in texts})
            held.hold(case, answer, value_of(answer, "solid-angle"), seen)
        texts["incidence"] = f"{incidence!r}rad"
        expected = exact(source, (spot, below, [1.0]), distance)
        answer = held.ask(lambertian, "patch", radiance="1W/m2/sr", **texts)
        if answer and any("partly cut by the horizon" in text for text in answer.assumptions):
            held.cut += 1  # the sum has too few points along the cut
            found = value_of(answer, "irradiance")
            close = math.isclose(found, expected, rel_tol=0.1, abs_tol=1e-3 * size**2 / distance**2)
            assert close, (case, found, expected)
        elif answer:
            held.hold(case, answer, value_of(answer, "irradiance"), expected)
        above = {**given, "height": f"{distance * math.cos(tilt)!r}m"}
        above["offset"] = f"{distance * math.sin(tilt)!r}m"
        parallel = exact(source, (spot, -source[1], [1.0]), distance)
        answer = held.ask(lambertian, "patch", radiance="1W/m2/sr", **above)
        held.hold(case, answer, value_of(answer, "irradiance"), parallel)
        if dice.random() < 0.1:
            other = math.exp(dice.uniform(-3, 0)) / 2
            at, normal, area = patch((other,), 0.0, incidence, azimuth)
            expected = exact(source, (at, -normal, area), distance)
            texts["receiver_area"] = f"{PI * other**2!r}m2"
            if answer := held.ask(etendue, **texts):
                held.hold(f"{case} {other=}", answer, value_of(answer, "etendue"), expected)
    said = f"error of the far field at most {held.most:.2f} of its bound"
    return f"{said}, {held.cut} discs cut, {held.refused} patches refused"


if __name__ == "__main__":
    from fuzz.command import main

    main(sweep, LONG)
