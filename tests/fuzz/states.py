"""Parts of states, rounded: consistent values do not contradict each other, wrong ones do.

A state of a calculator is drawn and computed from textbook formulas (`EQUATIONS`).  A part of it
is given with 3 to 5 digits: this must not be a contradiction, and the results must agree with the
state within the rounding.  With one value changed by 5 % the call must be refused, if the other
values determine this value well enough.  Results that the equations determine (by the rank of their
Jacobian) and radcalc does not answer are counted in the summary.
"""

import math
import random
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from itertools import combinations
from math import atan, cos, pi, sin, sqrt
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np

from radcalc.answer import Answer
from radcalc.calculators.calorimeter import calorimeter
from radcalc.calculators.etendue import etendue
from radcalc.calculators.ev import ev
from radcalc.calculators.lambertian import lambertian
from radcalc.calculators.point_source import point_source
from radcalc.calculators.screen import screen
from radcalc.calculators.solid_angle import solid_angle
from radcalc.errors import Exclusive, Idle, MissingInput, RadcalcError, Unused
from radcalc.inputs import Inputs
from radcalc.inputs.reading import read

SHORT, LONG = 150, 10_000
CHANGE = 0.05
ROOM = 4.0  # a change must exceed the rounding by this factor, or a refusal is not required

Values = dict[str, float]
Equation = Callable[[Values], tuple[float, float]]  # two equal sides

ANGLES = ("incidence", "tilt", "half-angle", "apex-angle", "beam-angle", "field-angle", "within",
          "horizontal", "vertical")  # fmt: skip
UNITS = {
    "flux": "lm", "intensity": "cd", "irradiance": "lx", "exitance": "lm/m2",
    "radiance": "cd/m2", "incident-irradiance": "lx", "exposure": "lx.s", "energy": "lm.s",
    "luminance": "cd/m2", "illuminance": "lx", "solid-angle": "sr",
    "projected-solid-angle": "sr", "area": "m2", "receiver-area": "m2", "etendue": "m2.sr",
    "time": "s", "mass": "kg", "specific-heat": "J/kg/K", "temperature-rise": "K",
    "k": "cd.s/m2", "c": "lx.s",
    **dict.fromkeys(("distance", "height", "offset", "radius", "diameter", "width", "length",
                     "diagonal", "receiver-radius"), "m"),
    **dict.fromkeys(ANGLES, "deg"),
}  # fmt: skip
RADIANT = {"flux": "W", "energy": "J", "irradiance": "W/m2"}


class State(NamedTuple):
    """A state: its values [SI], possible and fixed inputs, and equations."""

    name: str
    ask: Callable[[Inputs], Answer]
    values: Values
    inputs: Sequence[str]
    equations: Sequence[Equation]
    always: Sequence[str] = ()
    texts: Mapping[str, str] = MappingProxyType({})
    units: Mapping[str, str] = MappingProxyType(UNITS)
    fix: Callable[[set[str], set[str]], set[str]] = lambda part, known: part
    change: float = CHANGE
    marks: Mapping[str, float] = MappingProxyType({})  # of marks on a scale


def span(rng: random.Random, low: float, high: float) -> float:
    return math.exp(rng.uniform(math.log(low), math.log(high)))


# The states, each with its equations.


def point(rng: random.Random) -> State:
    shape = rng.choice(("isotropic", "cone", "lobe"))
    placed = rng.choice(("facing", "turned", "floor"))
    v: Values = {"intensity": span(rng, 1, 1e4), "time": span(rng, 1, 1e4)}
    v["distance"] = span(rng, 0.5, 50)
    equations: list[Equation] = [
        lambda v: (v["exposure"], v["irradiance"] * v["time"]),
        lambda v: (v["energy"], v["flux"] * v["time"]),
    ]
    off = 0.0
    inputs = ["flux", "intensity", "irradiance", "exposure", "energy", "time", "distance"]
    always: list[str] = []
    if placed == "turned":
        v["incidence"] = rng.uniform(0.2, 1.2)
        always = ["incidence"]
    if placed == "floor":
        off = rng.uniform(0.15, 1.1)
        v["height"], v["offset"] = v["distance"] * cos(off), v["distance"] * sin(off)
        inputs += ["height", "offset"]
        equations.append(lambda v: (v["distance"], math.hypot(v["height"], v["offset"])))

    def cosine(v: Values) -> float:
        if placed == "floor":
            return v["height"] / v["distance"]
        return cos(v.get("incidence", 0.0))

    def share(v: Values) -> float:
        return (v["height"] / v["distance"]) ** v["exponent"] if shape == "lobe" and off else 1.0

    if shape == "isotropic":
        v["solid-angle"] = 4 * pi
        equations.append(lambda v: (v["flux"], 4 * pi * v["intensity"]))
    if shape == "cone":
        v["half-angle"] = rng.uniform(off + 0.1, 1.5)
        v["apex-angle"] = 2 * v["half-angle"]
        v["solid-angle"] = 2 * pi * (1 - cos(v["half-angle"]))
        inputs += ["half-angle", "apex-angle", "solid-angle"]
        equations += [
            lambda v: (v["apex-angle"], 2 * v["half-angle"]),
            lambda v: (v["solid-angle"], 2 * pi * (1 - cos(v["half-angle"]))),
            lambda v: (v["flux"], v["intensity"] * v["solid-angle"]),
        ]
    if shape == "lobe":
        v["exponent"] = span(rng, 0.5, 40)
        v["solid-angle"] = 2 * pi / (v["exponent"] + 1)
        for name, left in (("beam-angle", 0.5), ("field-angle", 0.1)):
            v[name] = 2 * math.acos(left ** (1 / v["exponent"]))
            equations.append(lambda v, n=name, p=left: (p, cos(v[n] / 2) ** v["exponent"]))
        inputs += ["exponent", "beam-angle", "field-angle"]
        equations.append(lambda v: (v["flux"], 2 * pi / (v["exponent"] + 1) * v["intensity"]))
    v["flux"] = v["intensity"] * v.pop("solid-angle")
    if shape == "cone":
        v["solid-angle"] = 2 * pi * (1 - cos(v["half-angle"]))
    v["irradiance"] = v["intensity"] * share(v) * cosine(v) / v["distance"] ** 2
    equations.append(
        lambda v: (v["irradiance"], v["intensity"] * share(v) * cosine(v) / v["distance"] ** 2)
    )
    v["exposure"], v["energy"] = v["irradiance"] * v["time"], v["flux"] * v["time"]

    def fix(part: set[str], known: set[str]) -> set[str]:
        """Add defaults: normal incidence for a distance, a point on the axis for a height."""
        if placed == "floor" and not part & {"height", "offset"}:
            return part - {"distance"} | {"height", "offset"}
        if placed == "floor" and "offset" not in part and not {"offset"} <= known:
            return part | {"offset"}
        return part

    return State(f"point-source {shape} {placed}", point_source, v, inputs, equations, always,
                 {"distribution": shape}, fix=fix)  # fmt: skip


SURFACES = ("patch", "disc", "sphere", "disc aside", "rectangle", "plane", "hemisphere")


def surface(rng: random.Random) -> State:
    shape = rng.choice(
        ("patch", "disc", "sphere", "disc aside", "rectangle", "plane", "hemisphere")
    )
    v: Values = {"radiance": span(rng, 1, 1e4), "time": span(rng, 1, 1e4)}
    v["reflectance"] = rng.uniform(0.1, 0.95)
    v["exitance"] = pi * v["radiance"]
    v["incident-irradiance"] = v["exitance"] / v["reflectance"]
    inputs = ["radiance", "exitance", "irradiance", "exposure", "time", "reflectance",
              "incident-irradiance"]  # fmt: skip
    equations: list[Equation] = [
        lambda v: (v["exitance"], pi * v["radiance"]),
        lambda v: (v["exitance"], v["reflectance"] * v["incident-irradiance"]),
        lambda v: (v["exposure"], v["irradiance"] * v["time"]),
    ]
    always: list[str] = []
    size = span(rng, 0.01, 1)
    away = size * span(rng, 0.5, 10)
    if shape not in ("plane", "hemisphere"):
        inputs += ["flux", "intensity", "energy"]
        equations += [
            lambda v: (v["energy"], v["flux"] * v["time"]),
            lambda v: (v["flux"], v["exitance"] * v["area"]),
        ]
    if shape == "sphere":
        v["radius"], v["distance"] = size, away + 1.2 * size
        v["area"] = 4 * pi * size**2
        inputs += ["radius", "distance"]
        equations += [
            lambda v: (v["area"], 4 * pi * v["radius"] ** 2),
            lambda v: (v["intensity"], v["radiance"] * pi * v["radius"] ** 2),
        ]

        def projected(v: Values) -> float:
            return pi * (v["radius"] / v["distance"]) ** 2
    elif shape == "patch":
        v["width"], v["length"] = size, size * rng.uniform(0.3, 1)
        v["area"], v["distance"] = v["width"] * v["length"], 20 * size * span(rng, 1, 10)
        v["incidence"], v["tilt"] = rng.uniform(0.2, 1.2), rng.uniform(0.2, 1.2)
        inputs += ["area", "distance", "width", "length"]
        always = ["incidence", "tilt"]
        equations.append(lambda v: (v["area"], v["width"] * v["length"]))

        def projected(v: Values) -> float:
            return v["area"] * cos(v["incidence"]) * cos(v["tilt"]) / v["distance"] ** 2
    elif shape.startswith("disc"):
        v["radius"], v["height"], v["area"] = size, away, pi * size**2
        inputs += ["radius", "height"]
        equations.append(lambda v: (v["area"], pi * v["radius"] ** 2))
        if shape == "disc aside":
            v["offset"] = size * rng.uniform(0.1, 3)
            inputs += ["offset"]

        def projected(v: Values) -> float:
            h, r, x = v["height"], v["radius"], v.get("offset", 0.0)  # Howell
            return pi / 2 * (1 - (x * x + h * h - r * r) / sqrt((x * x + h * h + r * r) ** 2
                                                                - (2 * r * x) ** 2))  # fmt: skip
    elif shape == "rectangle":
        v["width"], v["length"], v["height"] = size, size * rng.uniform(0.3, 1), away
        v["area"] = v["width"] * v["length"]
        inputs += ["width", "length", "height"]
        equations.append(lambda v: (v["area"], v["width"] * v["length"]))

        def projected(v: Values) -> float:
            a, b = (v[name] / 2 / v["height"] for name in ("width", "length"))  # Howell
            p, q = sqrt(1 + a * a), sqrt(1 + b * b)
            return 2 * (a / p * atan(b / p) + b / q * atan(a / q))
    elif shape == "plane":

        def projected(v: Values) -> float:
            return pi
    else:
        v["half-angle"] = rng.uniform(0.1, 1.5)
        inputs += ["half-angle"]

        def projected(v: Values) -> float:
            return pi * sin(v["half-angle"]) ** 2

    if "area" in v:
        v["flux"] = v["exitance"] * v["area"]
        v["energy"] = v["flux"] * v["time"]
        v["intensity"] = v["radiance"] * v["area"] / (4 if shape == "sphere" else 1)
        if shape != "sphere":
            equations.append(lambda v: (v["intensity"], v["radiance"] * v["area"]))
    v["irradiance"] = v["radiance"] * projected(v)
    v["exposure"] = v["irradiance"] * v["time"]
    equations.append(lambda v: (v["irradiance"], v["radiance"] * projected(v)))
    word = shape.split()[0]

    def fix(part: set[str], known: set[str]) -> set[str]:
        """Add defaults; a rotated patch needs a distance."""
        if shape == "patch" and not part & {"distance", "irradiance"}:
            return part | {"distance"}
        usual = {"disc aside": "offset", "hemisphere": "half-angle"}.get(shape)
        if usual and usual not in part | known:
            return part | {usual}
        return part

    return State(f"lambertian {shape}", lambda given: lambertian(word, given), v, inputs,
                 equations, always, fix=fix)  # fmt: skip


def meter(rng: random.Random) -> State:
    v: Values = {"f-number": span(rng, 1, 30), "time": span(rng, 1e-3, 10),
                 "iso": span(rng, 50, 6400), "k": 12.5, "c": 250.0}  # fmt: skip
    v["ev"] = math.log2(v["f-number"] ** 2 / v["time"])
    v["ev100"] = v["ev"] - math.log2(v["iso"] / 100)
    v["luminance"] = v["k"] / 100 * 2 ** v["ev100"]
    v["illuminance"] = v["c"] / 100 * 2 ** v["ev100"]
    equations: list[Equation] = [
        lambda v: (v["ev"], math.log2(v["f-number"] ** 2 / v["time"])),
        lambda v: (v["ev100"], v["ev"] - math.log2(v["iso"] / 100)),
        lambda v: (v["luminance"], v["k"] / 100 * 2 ** v["ev100"]),
        lambda v: (v["illuminance"], v["c"] / 100 * 2 ** v["ev100"]),
        lambda v: (v["k"], 12.5),
        lambda v: (v["c"], 250.0),
    ]
    inputs = ["ev", "ev100", "luminance", "illuminance", "f-number", "time", "iso"]

    def fix(part: set[str], known: set[str]) -> set[str]:
        """Add the default ISO speed of 100."""
        if "iso" in known and part & {"luminance", "illuminance", "ev100"}:
            return part
        return part | {"iso"}

    marks = {"time": 0.07, "ev": 0.1 / abs(v["ev"]), "ev100": 0.1 / abs(v["ev100"])}  # 0.1 EV
    return State("ev", ev, v, inputs, equations, fix=fix, change=0.9, marks=marks)


def body(rng: random.Random) -> State:
    v: Values = {"mass": span(rng, 1e-3, 1), "specific-heat": span(rng, 100, 4200),
                 "temperature-rise": span(rng, 0.1, 50), "absorptance": rng.uniform(0.3, 0.99),
                 "time": span(rng, 1, 1e3), "receiver-area": span(rng, 1e-4, 1e-1)}  # fmt: skip

    def heat(v: Values) -> float:
        return v["mass"] * v["specific-heat"] * v["temperature-rise"]

    v["energy"] = heat(v) / v["absorptance"]
    v["flux"] = v["energy"] / v["time"]
    v["irradiance"] = v["flux"] / v["receiver-area"]
    equations: list[Equation] = [
        lambda v: (heat(v), v["absorptance"] * v["energy"]),
        lambda v: (v["energy"], v["flux"] * v["time"]),
        lambda v: (v["flux"], v["irradiance"] * v["receiver-area"]),
    ]

    def fix(part: set[str], known: set[str]) -> set[str]:
        """Add the default absorptance of 1."""
        return part if "absorptance" in known else part | {"absorptance"}

    return State("calorimeter", calorimeter, v, [*v], equations, units=UNITS | RADIANT, fix=fix)


def picture(rng: random.Random) -> State:
    v: Values = {"width": span(rng, 0.5, 20), "aspect": rng.uniform(1.2, 2.4),
                 "flux": span(rng, 100, 1e4), "gain": rng.uniform(0.7, 2.5)}  # fmt: skip
    v["height"] = v["width"] / v["aspect"]
    v["diagonal"], v["area"] = math.hypot(v["width"], v["height"]), v["width"] * v["height"]
    v["irradiance"] = v["flux"] / v["area"]
    v["radiance"] = v["gain"] * v["irradiance"] / pi
    equations: list[Equation] = [
        lambda v: (v["width"], v["aspect"] * v["height"]),
        lambda v: (v["diagonal"], math.hypot(v["width"], v["height"])),
        lambda v: (v["area"], v["width"] * v["height"]),
        lambda v: (v["flux"], v["irradiance"] * v["area"]),
        lambda v: (v["radiance"], v["gain"] * v["irradiance"] / pi),
    ]

    def fix(part: set[str], known: set[str]) -> set[str]:
        """Add the default gain of 1."""
        return part if {"radiance", "irradiance"} <= part else part | {"gain"}

    return State("screen", screen, v, [*v], equations, fix=fix)


def beam(rng: random.Random) -> State:
    limit = rng.choice(("half-angle", "apex-angle", "na", "f-number", "discs", "patches"))
    v: Values = {"radiance": span(rng, 1, 1e6)}
    inputs = ["flux", "radiance", "etendue"]
    always: list[str] = []
    equations: list[Equation] = [lambda v: (v["flux"], v["radiance"] * v["etendue"])]
    if limit == "discs":
        size = span(rng, 0.01, 1)
        v["radius"], v["receiver-radius"] = size, size * span(rng, 0.3, 3)
        v["distance"] = size * span(rng, 0.5, 10)

        def extent(v: Values) -> float:
            r, q, d = (v[name] ** 2 for name in ("radius", "receiver-radius", "distance"))
            s = r + q + d  # Howell, C-41
            return pi**2 / 2 * (s - sqrt(s * s - 4 * r * q))

        inputs += ["radius", "receiver-radius", "distance"]
        always = ["receiver-radius"]
    elif limit == "patches":
        size = span(rng, 0.01, 1)
        v["area"], v["receiver-area"] = size**2, (size * span(rng, 0.3, 1)) ** 2
        v["distance"], v["tilt"] = size * 20, rng.uniform(0.1, 1)

        def extent(v: Values) -> float:
            return v["area"] * v["receiver-area"] * cos(v["tilt"]) / v["distance"] ** 2

        inputs += ["area", "receiver-area", "distance"]
        always = ["tilt", "receiver-area"]
    else:
        v["area"], angle = span(rng, 1e-6, 1e-2), rng.uniform(0.1, 1.3)
        v[limit] = {"half-angle": angle, "apex-angle": 2 * angle, "na": sin(angle),
                    "f-number": 0.5 / sin(angle)}[limit]  # fmt: skip

        def extent(v: Values) -> float:
            squared = {"half-angle": lambda x: sin(x) ** 2, "apex-angle": lambda x: sin(x / 2) ** 2,
                       "na": lambda x: x**2, "f-number": lambda x: 0.25 / x**2}[limit]  # fmt: skip
            return pi * v["area"] * squared(v[limit])

        inputs += ["area", limit]
    v["etendue"] = extent(v)
    v["flux"] = v["radiance"] * v["etendue"]
    equations.append(lambda v: (v["etendue"], extent(v)))
    return State(f"etendue {limit}", etendue, v, inputs, equations, always)


def shape(rng: random.Random) -> State:
    word = rng.choice(("sphere", "disc", "pyramid", "patch"))
    v: Values
    if word == "sphere":
        v = {"radius": 1.0, "distance": span(rng, 1.05, 30)}

        def seen(v: Values) -> float:
            return 2 * pi * (1 - sqrt(1 - (v["radius"] / v["distance"]) ** 2))
    elif word == "disc":
        v = {"radius": 1.0, "height": span(rng, 0.1, 30)}

        def seen(v: Values) -> float:
            return 2 * pi * (1 - v["height"] / math.hypot(v["height"], v["radius"]))
    elif word == "pyramid":
        v = {"horizontal": rng.uniform(0.1, 2.5), "vertical": rng.uniform(0.1, 2.5)}

        def seen(v: Values) -> float:
            return 4 * math.asin(sin(v["horizontal"] / 2) * sin(v["vertical"] / 2))
    else:
        v = {"area": span(rng, 1e-4, 1), "distance": span(rng, 10, 100)}

        def seen(v: Values) -> float:
            return v["area"] / v["distance"] ** 2

    inputs = [*v, "solid-angle"]
    v["solid-angle"] = seen(v)
    return State(f"solid-angle {word}", lambda given: solid_angle(word, given), v, inputs,
                 [lambda v: (v["solid-angle"], seen(v))])  # fmt: skip


STATES = (point, point, point, surface, surface, meter, body, picture, beam, shape)


# Results of the equations from a part of a state.


class Ranks:
    """The equations linearised about a state: relative changes, but absolute for angles and EVs."""

    def __init__(self, state: State) -> None:
        self.names = [*state.values]
        rows = []
        for equation in state.equations:
            row = []
            for name in self.names:
                ends = []
                for sign in (1, -1):
                    moved = {**state.values}
                    moved[name] += sign * 1e-6 * abs(moved[name])
                    left, right = equation(moved)
                    ends.append((left - right) / (abs(left) + abs(right)))
                row.append((ends[0] - ends[1]) / 2e-6)
            rows.append(row)
        self.jacobian = np.array(rows)

    def split(self, part: set[str]) -> tuple[Any, Any]:
        known = [k for k, name in enumerate(self.names) if name in part]
        unknown = [k for k, name in enumerate(self.names) if name not in part]
        return self.jacobian[:, known], self.jacobian[:, unknown]

    def determined(self, part: set[str]) -> set[str]:
        """Return the results that follow from a part."""
        _, unknown = self.split(part)
        names = [name for name in self.names if name not in part]
        if not names:
            return set()
        _, sizes, rows = np.linalg.svd(unknown)
        null = rows[int((sizes > 1e-6 * sizes[0]).sum()) :]
        return {name for k, name in enumerate(names) if (abs(null[:, k]) < 1e-6).all()}

    def gains(self, part: set[str]) -> Any:
        """Return the sensitivity of each unknown to each known value."""
        known, unknown = self.split(part)
        return np.linalg.pinv(unknown, rcond=1e-6) @ known

    def checks(self, part: set[str]) -> Any:
        """Return the constraints among the known values: rows times changes are 0."""
        known, unknown = self.split(part)
        left, sizes, _ = np.linalg.svd(unknown)
        rank = int((sizes > 1e-6 * sizes[0]).sum()) if sizes.size else 0
        return left[:, rank:].T @ known


class Part(NamedTuple):
    """A part of a state: the texts to type, and their rounding."""

    texts: dict[str, str]
    off: Values  # relative

    @classmethod
    def of(cls, state: State, names: Sequence[str], rng: random.Random, wrong: str = "") -> "Part":
        texts, off = {}, {}
        for name in names:
            digits = rng.choice((3, 4, 5))
            size = state.values[name]
            if name == wrong:
                size *= 1 + state.change * rng.choice((1, -1))
            number = f"{math.degrees(size) if name in ANGLES else size:.{digits - 1}e}"
            texts[name] = number + state.units.get(name, "")
            off[name] = 0.5 * 10.0 ** (1 - digits) / abs(float(number.partition("e")[0]))
        return cls(texts, off)


def answers(state: State, part: Part) -> list[Answer]:
    words = part.texts | state.texts
    answer = state.ask({name: read(name, text) for name, text in words.items()})
    return [answer, *answer.more]


def sizes_of(answer: Answer) -> Values:
    return {value.name: value.amount for value in answer.values if not value.is_absent}


LIGHT = {
    "flux", "intensity", "irradiance", "exitance", "radiance", "incident-irradiance", "exposure",
    "energy", "luminance", "illuminance", "ev100", "etendue",
}  # fmt: skip
SAME = {"distance": ("height",), "half-angle": ("na", "f-number")}  # one symbol is shown for others
REFUSED = (MissingInput, Idle)  # too few inputs, or an input that does not apply
RULES = (Exclusive, Unused)  # options that exclude each other


def draw(rng: random.Random) -> tuple[State, Ranks, set[str]]:
    state = rng.choice(STATES)(rng)
    ranks = Ranks(state)
    count = rng.randint(1, len(state.inputs))
    part = {*rng.sample(list(state.inputs), count), *state.always}
    return state, ranks, state.fix(part, ranks.determined(part))


def sweep(count: int, seed: int) -> str:
    rng = random.Random(seed)
    seen: Counter[str] = Counter()
    unanswered: Counter[str] = Counter()
    for _ in range(count):
        state, ranks, part = draw(rng)
        names = sorted(part)
        determined = ranks.determined(part)
        typed = Part.of(state, names, rng)
        case = f"{state.name}: " + " ".join(f"--{n} {t}" for n, t in typed.texts.items())
        try:
            found = [sizes_of(answer) for answer in answers(state, typed)]
        except RULES:
            seen["by rule"] += 1
            continue
        except REFUSED:
            seen["refused"] += 1
            light = part & LIGHT or "solid-angle" in state.name
            if light and determined and all(is_needed(ranks, part, name) for name in part):
                unanswered[f"{state.name}: {' '.join(names)}"] += 1
            continue
        except RadcalcError as error:
            raise AssertionError(f"{case}\nis called wrong: {error}") from None
        seen["answered"] += 1
        shown = found[0].keys() | {same for n in found[0] for same in SAME.get(n, ())}
        missing = {n for n in determined if n in state.inputs and n not in shown}
        if missing:
            lacking = " ".join(sorted(missing))
            unanswered[f"{state.name}: {' '.join(names)}, without {lacking}"] += 1
        wrong = [far(state, ranks, part, typed, one) for one in found]
        assert not all(wrong), f"{case}\ngives " + "\nor ".join(map(str, wrong))
        seen["wrong ones found"] += finds_wrong(state, ranks, part, names, rng)
    few = ", ".join(f"{n} {what}" for what, n in sorted(seen.items()))
    more = "".join(f"\n  {n} x {what}" for what, n in unanswered.most_common())
    return f"{few}; determined and not answered: {sum(unanswered.values())}{more}"


def is_needed(ranks: Ranks, part: set[str], name: str) -> bool:
    """Return whether a value has a result, or is checked by other values."""
    rest = part - {name}
    follows = ranks.determined(part) - ranks.determined(rest) - {name}
    return bool(follows) or len(ranks.checks(part)) > len(ranks.checks(rest))


def far(state: State, ranks: Ranks, part: set[str], typed: Part, found: Values) -> dict[str, str]:
    """Return the values that differ from the state by more than the rounding."""
    gains = ranks.gains(part)
    off = [typed.off[name] for name in ranks.names if name in part]
    unknown = [name for name in ranks.names if name not in part]
    allowed = dict(zip(unknown, abs(gains) @ off, strict=True)) if unknown else {}
    wrong = {}
    for name in ranks.determined(part) & found.keys():
        right = state.values[name]
        distance = abs(found[name] / right - 1)
        if distance > 2 * allowed[name] + 1e-6:
            limit = 2 * coarsest(ranks, part, typed, name) + 1e-6
            if distance > limit:
                wrong[name] = f"{found[name]:.6g}, not {right:.6g} (to {limit:.2g})"
    return wrong


def coarsest(ranks: Ranks, part: set[str], typed: Part, name: str) -> float:
    """Return the largest error of a result that follows from a minimal set of inputs.

    Each input counts with its strongest influence, because several ways may lead to a result; if
    they do, the difference that still counts as consistent is added.
    """
    checks = ranks.checks(part)
    surplus = len(checks)
    apart = abs(checks) @ [typed.off[one] for one in ranks.names if one in part]
    worst = dict.fromkeys(part, 0.0)
    for left_out in combinations(sorted(part), surplus):
        rest = part - {*left_out}
        if len(ranks.checks(rest)) or name not in ranks.determined(rest):
            continue
        row = [one for one in ranks.names if one not in rest].index(name)
        given = [one for one in ranks.names if one in rest]
        for one, gain in zip(given, abs(ranks.gains(rest)[row]), strict=True):
            worst[one] = max(worst[one], float(gain) * typed.off[one])
    return sum(worst.values()) + 2 * float(max(apart, default=0.0))


def finds_wrong(
    state: State, ranks: Ranks, part: set[str], names: Sequence[str], rng: random.Random
) -> bool:
    """Change one value by 5 %, and check the refusal if the other values determine it."""
    if {"luminance", "illuminance"} <= part:
        return False  # these inputs give the reflectance of the scene
    checks = ranks.checks(part)
    known = [name for name in ranks.names if name in part]
    changed = rng.choice(known)
    typed = Part.of(state, names, rng, changed)
    slack = abs(checks) @ [typed.off[name] + state.marks.get(name, 0.0) for name in known]
    moved = abs(checks[:, known.index(changed)]) * state.change
    if not (moved > ROOM * slack + 1e-6).any():
        return False
    try:
        found = answers(state, typed)
    except RadcalcError:
        return True
    if any(is_a_state(state, typed, one) for one in map(sizes_of, found)):
        return False  # another state than the random one
    case = " ".join(f"--{name} {text}" for name, text in typed.texts.items())
    raise AssertionError(
        f"{state.name}: {case}\nis right to radcalc though {changed} is off: {sizes_of(found[0])}"
    )


def is_a_state(state: State, typed: Part, found: Values) -> bool:
    """Return whether values fulfil the equations, within the rounding of the digits typed."""
    every = sum(typed.off.values())
    for equation in state.equations:
        try:
            left, right = equation({"k": 12.5, "c": 250.0} | found)
        except KeyError:  # of a quantity that is not shown
            continue
        if abs(left - right) > every * (abs(left) + abs(right)):
            return False
    return True


if __name__ == "__main__":
    from fuzz.command import main

    main(sweep, LONG)
