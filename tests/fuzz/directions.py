"""Sources with a distribution: where they are, how they are aimed, and how they are scaled.

A lobe as an expression has the results of the closed laws.  An oval distribution, aimed and rotated
at random, is compared with vectors, turned about the line across straight down and the aim.
Positions and intensities are recovered from the light that they give.
"""

import math
import random

import numpy as np

from radcalc import Quantity, point_source

SHORT, LONG = 2, 2000
CLOSED = (
    "intensity",
    "flux",
    "irradiance",
    "distance",
    "incidence",
    "flux_within",
    "received_flux",
)


def one_of(found, unit: str) -> np.ndarray:
    """Return all values of a result, in a unit."""
    return np.atleast_1d(found.to(unit).magnitude)


def lobe(dice: random.Random) -> str:
    """Compare a lobe in both forms; return the case if the results differ."""
    exponent = math.exp(dice.uniform(-2, 4))
    place = dice.choice(
        [
            {"distance": dice.uniform(0.5, 20)},
            {"height": dice.uniform(0.5, 20)},
            {name: dice.uniform(0.5, 5) for name in ("height", "offset", "offset_y")},
            {"distance": dice.uniform(6, 9), "offset": dice.uniform(-5, 5)},
        ]
    )
    given = {name: Quantity(size, "m") for name, size in place.items()}
    given["within"] = Quantity(dice.uniform(1, 170), "deg")
    if dice.random() < 0.5:
        given["receiver_area"] = Quantity(math.exp(dice.uniform(-6, 2)), "m2")
    light = dice.choice([{"flux": "800 lm"}, {"intensity": "70 cd"}])
    closed = point_source(exponent=exponent, **light, **given)
    text = f"{dice.uniform(0.1, 9)!r}*max(cos(theta), 0)^{exponent!r}"
    found = point_source(distribution=text, **light, **given)
    for name in CLOSED:
        if name in closed:
            one, other = (float(each[name].to_base_units().magnitude) for each in (closed, found))
            rel = 1e-4 if name == "received_flux" else 1e-6
            if not math.isclose(one, other, rel_tol=rel, abs_tol=1e-9):
                return f"{text}, {light}, {given}: {name} is {one} and {other}"
    return ""


def turned(down: np.ndarray, aim: np.ndarray, vector: np.ndarray) -> np.ndarray:
    """Rotate a vector by the rotation from straight down to the aim (Rodrigues)."""
    about = np.cross(down, aim)
    sine, cosine = np.linalg.norm(about), down @ aim
    about = about / sine if sine > 1e-12 else np.array([1.0, 0.0, 0.0])
    along = about * (about @ vector)
    return along + cosine * (vector - along) + sine * np.cross(about, vector)


def aimed(dice: random.Random) -> str:
    """Compare an oval distribution that is aimed with vectors; return the case if they differ."""
    down = np.array([0.0, 0.0, -1.0])
    aim = np.array([dice.uniform(-1, 1) for _ in range(3)])
    turn, height = dice.uniform(-400, 400), dice.uniform(0.1, 10)
    x, y = dice.uniform(-5, 5), dice.uniform(-5, 5)
    axis = aim / np.linalg.norm(aim)
    psi = math.radians(turn)
    c0 = turned(down, axis, np.array([math.cos(psi), math.sin(psi), 0.0]))
    c90 = turned(down, axis, np.array([-math.sin(psi), math.cos(psi), 0.0]))
    to = np.array([x, y, -height])
    away = float(np.linalg.norm(to))
    own = [float(to @ each) / away for each in (c0, c90, axis)]
    candelas = 200 + 60 * own[0] - 50 * own[1] + 40 * own[2] ** 3
    given = {
        "distribution": "(200 + 60*x - 50*y + 40*z^3) cd",
        "aim": ",".join(repr(float(part)) for part in aim),
        "rotate": Quantity(turn, "deg"),
        "offset": Quantity(x, "m"),
        "offset_y": Quantity(y, "m"),
    }
    found = point_source(**given, height=Quantity(height, "m"))
    lux = candelas * height / away**3
    checks = [
        ("intensity_toward", "cd", candelas),
        ("irradiance", "lx", lux),
        # the integrals of x, y and z^3 over the sphere are 0
        ("flux", "lm", 800 * math.pi),
        ("off_axis", "deg", math.degrees(math.acos(max(-1.0, min(1.0, own[2]))))),
    ]
    for name, unit, right in checks:
        got = float(one_of(found[name], unit)[0])
        if not math.isclose(got, right, rel_tol=1e-6, abs_tol=1e-5):
            return f"{given}, height {height}: {name} is {got} {unit}, not {right}"
    back = point_source(**given, illuminance=Quantity(lux, "lx"))
    if min(abs(one_of(back["height"], "m") - height)) > 1e-6 * height:
        return f"{given}: {lux} lx from {back['height']}, and not from {height} m"
    scaled = point_source(
        **given, height=Quantity(height, "m"), illuminance=Quantity(3 * lux, "lx")
    )
    got = float(one_of(scaled["flux"], "lm")[0])
    if not math.isclose(got, 2400 * math.pi, rel_tol=1e-6):
        return f"{given}, height {height}: three times the irradiance gives {got} lm"
    return ""


def sweep(count: int, seed: int) -> str:
    """Compare random cases with their oracles."""
    dice = random.Random(seed)
    for k in range(count):
        wrong = (aimed if k % 2 else lobe)(dice)
        assert not wrong, wrong
    return f"{count} sources, half of them aimed"


if __name__ == "__main__":
    from fuzz.command import main

    main(sweep, LONG)
