"""Results on scales: `--check`, `mark`, `--get` and Python have one reading, and one verdict.

A case is a question with random numbers, one of its results, one scale and one claim.  The oracle
is arithmetic: the results of a question, and the readings of a quantity, each from its definition.
"""

import csv
import json
import math
import random
import shlex
import sys
import tempfile
from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, NamedTuple

import radcalc
from radcalc.errors import RadcalcError
from radcalc.units.scale_table import SCALES

sys.path.append(str(Path(__file__).parent.parent))  # for a script
from following import call
from fuzz.command import main

SHORT, LONG = 240, 10_000
PI, lg, lb = math.pi, math.log10, math.log2
Results = dict[str, tuple[str, float]]  # the dimension and the size in SI of each
FLUX, ILLUMINANCE, LUMINANCE = "W", "lx", "cd/m2"
TEMPERATURE, RATIO, EV, EV100, LOSS = "K", "1", "ev", "ev100", "loss"
ARCSEC = PI / 180 / 3600


def level(reference: float) -> Callable[[float], float]:
    return lambda power: 10 * lg(power / reference)


# ISO 2720 with K = 12.5 cd s/m2 and C = 250 lx s at ISO 100; the zero of magnitudes is 2.54e-6 lx.
def ev_of_luminance(luminance: float) -> float:
    return lb(luminance * 100 / 12.5)


def ev_of_illuminance(illuminance: float) -> float:
    return lb(illuminance * 100 / 250)


def magnitude(illuminance: float) -> float:
    return -2.5 * lg(illuminance / 2.54e-6)


def same(number: float) -> float:
    return number


# The readings of each dimension.  A number that is a reading is on its own scale; the losses of a
# filter are counted in densities.
READINGS: dict[str, dict[str, Callable[[float], float]]] = {
    FLUX: {"dBm": level(1e-3), "dBW": level(1), "dBu(W)": level(1e-6), "dB(1 mW)": level(1e-3)},
    ILLUMINANCE: {"EV": ev_of_illuminance, "EV100": ev_of_illuminance, "mag": magnitude},
    LUMINANCE: {
        "EV": ev_of_luminance,
        "EV100": ev_of_luminance,
        "mag/arcsec2": lambda x: magnitude(x * ARCSEC**2),
        "mpsas": lambda x: magnitude(x * ARCSEC**2),
        "mag/arcmin2": lambda x: magnitude(x * (60 * ARCSEC) ** 2),
        "bril": lambda x: 100 + lb(x / (1e4 / PI)),
    },
    TEMPERATURE: {"mired": lambda x: 1e6 / x, "MK-1": lambda x: 1e6 / x, "1/kK": lambda x: 1e3 / x},
    RATIO: {"dB": lambda x: 10 * lg(x), "stops": lb, "OD": lambda x: -lg(x)},
    EV: {"EV": same},
    EV100: {"EV": same, "EV100": same},
    LOSS: {"OD": same, "stops": lambda x: x / lg(2), "dB": lambda x: 10 * x},
}
# The change of a reading by 10 % more of the quantity.
TENTH = {"EV": lb(1.1), "EV100": lb(1.1), "bril": lb(1.1), "stops": lb(1.1), "OD": -lg(1.1)}
SCALE_NAMES = [*dict.fromkeys(scale.name for scale in SCALES), "mag/arcmin2", "EV100", "MK-1"]


def tenth(scale: str, reading: float) -> float:
    if scale in ("mired", "MK-1", "1/kK"):
        return reading / 1.1 - reading
    if scale.startswith("dB"):
        return 10 * lg(1.1)
    return TENTH.get(scale, -2.5 * lg(1.1))


class Asked(NamedTuple):
    """A question for a shell and for Python, with its results, which have names in both."""

    words: str
    python: Callable[[], Any]
    results: Results


def converted(number: float, source: str, target: str, of: str, factor: float) -> Asked:
    words = f"convert {number!r} {source} {target}"
    return Asked(
        words,
        lambda: radcalc.explain(number, source, target),
        {"value": (of, number * factor)},
    )


def asked(dice: random.Random) -> Asked:
    """Return a question with random numbers."""

    def size(low: float, high: float) -> float:
        return float(f"{math.exp(dice.uniform(math.log(low), math.log(high))):.4g}")

    kind = dice.randrange(10)
    if kind == 0:
        return converted(size(1e-3, 1e3), "mW", "W", FLUX, 1e-3)
    if kind == 1:
        return converted(size(1, 1e5), "lx", dice.choice(["fc", "EV"]), ILLUMINANCE, 1)
    if kind == 2:
        return converted(size(1e-4, 1e4), "cd/m2", dice.choice(["nit", "mpsas"]), LUMINANCE, 1)
    if kind == 3:
        target = dice.choice(["kK", "mired", "MK-1"])
        return converted(size(1500, 2e4), "K", target, TEMPERATURE, 1)
    if kind == 4:
        target = dice.choice(["dB", "stops", "OD"])
        return converted(size(1e-3, 0.9), "1", target, RATIO, 1)
    if kind == 5:
        intensity, metres = size(1, 1e4), size(0.5, 20)
        return Asked(
            f"point-source --intensity {intensity}cd --distance {metres}m",
            lambda: radcalc.point_source(intensity=f"{intensity} cd", distance=f"{metres} m"),
            {"illuminance": (ILLUMINANCE, intensity / metres**2)},
        )
    if kind == 6:
        exitance, part = size(1, 1e4), size(0.05, 0.9)
        return Asked(
            f"lambertian --exitance {exitance * part!r}lm/m2 --incident-irradiance {exitance}lx",
            lambda: radcalc.lambertian(
                exitance=f"{exitance * part!r} lm/m2", incident_irradiance=f"{exitance} lx"
            ),
            {"luminance": (LUMINANCE, exitance * part / PI), "reflectance": (RATIO, part)},
        )
    if kind == 7:
        density = size(0.1, 3)
        return Asked(
            f"ev --nd {density}OD --time 1/60s",
            lambda: radcalc.ev(nd=f"{density} OD", time="1/60 s"),
            {"nd": (LOSS, density), "stops": (LOSS, density)},
        )
    number, iso = size(1, 18), dice.choice([50, 100, 200, 800, 3200])
    results = {
        "ev100": (EV100, number),
        "ev": (EV, number + lb(iso / 100)),
        "luminance": (LUMINANCE, 12.5 / 100 * 2**number),
        "illuminance": (ILLUMINANCE, 250 / 100 * 2**number),
    }
    unit = dice.choice(["", "EV"])
    return Asked(
        f"ev --ev100 {number}{unit} --iso {iso}",
        lambda: radcalc.ev(ev100=f"{number} {unit}".strip(), iso=str(iso)),
        results,
    )


class Case(NamedTuple):
    """A claim on a result of a question, and whether it is right; None for a foreign scale."""

    asked: Asked
    name: str
    scale: str
    reading: float
    claim: str
    right: bool | None

    @property
    def text(self) -> str:
        return f"{self.claim} {self.scale}"


# Readings with uncertainties: their scale and target, the shift between both, and their range.
SHIFTS = (
    ("dBm", "dBW", -30.0, (-30, 30), (0.1, 2)),
    ("EV", "EV", 0.0, (1, 18), (0.1, 0.9)),
    ("mag/arcsec2", "mag/arcmin2", -2.5 * lg(3600), (15, 23), (0.1, 0.9)),
    ("mired", "MK-1", 0.0, (100, 400), (10, 60)),
)


def interval(dice: random.Random) -> Iterator[Case]:
    """Yield claims at the ends of an interval as it is printed, and a digit outside of them."""
    scale, target, shift, ends, sizes = dice.choice(SHIFTS)
    number, off = round(dice.uniform(*ends), 1), float(f"{dice.uniform(*sizes):.2g}")
    place = 1 - math.floor(lg(off))
    reading, step = round(number + shift, place), 10.0**-place
    typed = f"{number}+-{off}"
    question = Asked(
        f"convert '{typed} {scale}' {target}",
        lambda: radcalc.explain(f"{typed} {scale}", target),
        {},
    )
    for sign in (-1, 1):
        for part, right in ((off, True), (off + step, False)):
            claim = f"{reading + sign * part:.{max(place, 0)}f}"
            yield Case(question, "value", target, 0.0, claim, right)


def cases(count: int, seed: int) -> Iterator[Case]:
    dice, made = random.Random(seed), 0
    while made < count:
        if not dice.randrange(5):
            yield from interval(dice)
            made += 4
            continue
        question = asked(dice)
        for name, (of, size) in question.results.items():
            own = READINGS[of]
            scales = [dice.choice(SCALE_NAMES), *dice.sample([*own], min(2, len(own)))]
            for scale in scales:
                if scale not in own:
                    yield Case(question, name, scale, 0.0, f"{dice.uniform(1, 30):.7g}", None)
                    made += 1
                    continue
                reading = own[scale](size)
                # 0.5 % of the quantity is right; 4 % are wrong, and so are 10 % less
                for part in (dice.choice((0, 0.05, -0.05)), dice.choice((0.4, -1))):
                    claim = f"{reading + part * tenth(scale, reading):#.7g}"
                    yield Case(question, name, scale, reading, claim, abs(part) < 0.1)
                made += 2


def shown(case: Case) -> None:
    """The reading that is requested is that of the oracle, or refused on a foreign scale."""
    if case.name == "value":
        words = shlex.split(case.asked.words)
        done = call(["convert", *words[1:3], case.scale])
    else:
        done = call([*shlex.split(case.asked.words), "-g", f"{case.name}:{case.scale}"])
    if case.right is None:
        assert (done.status, bool(done.error)) == (2, True), (case, done)
        return
    number = float(done.output.split()[0])
    assert done.status == 0, (case, done)
    assert math.isclose(number, case.reading, rel_tol=1e-9, abs_tol=1e-9), (case, done)


def is_right(status: int) -> bool:
    assert status in (0, 1, 2), status
    return status == 0


def marked(group: list[Case]) -> dict[int, str]:
    """Return the verdicts of `mark` by the identity of a case; a row has one command."""
    rows: dict[tuple[str, str], list[Case]] = {}
    for case in group:
        command = case.asked.words
        if case.name != "value":
            unit = f":{case.scale}" if case.right is not None else ""
            command += f" -g '{case.name}{unit}'"
        rows.setdefault((command, case.name), []).append(case)
    most = max(map(len, rows.values()))
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "sheet.csv"
        with path.open("w", newline="") as file:
            writer = csv.writer(file, delimiter=";")
            writer.writerow(["question", "command", *(f"S{k}" for k in range(most))])
            for k, ((command, _), listed) in enumerate(rows.items()):
                answers = [case.text for case in listed]
                writer.writerow([f"q{k}", command, *answers, *[""] * (most - len(answers))])
        done = call(["mark", str(path), "--format", "json"])
    assert done.status in (0, 1), (done, [*rows])
    verdicts = {
        (row["question"], row["student"]): row["verdict"]
        for row in json.loads(done.output)["records"]
    }
    return {
        id(case): verdicts[f"q{k}", f"S{j}"]
        for k, listed in enumerate(rows.values())
        for j, case in enumerate(listed)
    }


def sweep(count: int, seed: int) -> str:
    seen: Counter[str] = Counter()
    group = [*cases(count, seed)]
    requested: set[tuple[int, str, str]] = set()
    results: dict[int, Any] = {}
    by_mark = marked(group)
    for case in group:
        key = id(case.asked)
        if case.asked.results and (key, case.name, case.scale) not in requested:
            requested.add((key, case.name, case.scale))
            shown(case)
            seen["requested"] += 1
        if key not in results:
            results[key] = case.asked.python()
        claim = case.text if case.name == "value" else f"{case.name}={case.text}"
        try:
            python = radcalc.check(results[key], claim).right
        except RadcalcError:
            python = False
        shell = is_right(call([*shlex.split(case.asked.words), "--check", claim]).status)
        verdicts = shell, python, by_mark[id(case)] == "right"
        assert verdicts == (bool(case.right),) * 3, (case, verdicts, by_mark[id(case)])
        seen["right" if case.right else "foreign" if case.right is None else "wrong"] += 1
    return f"{len(results)} questions, " + ", ".join(f"{n} {what}" for what, n in seen.items())


if __name__ == "__main__":
    main(sweep, LONG)
