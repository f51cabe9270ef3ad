"""Public functions of the geometry at the limits of their arguments.

0, the smallest and the largest floats, infinity, negative numbers, NaN, a right angle and its
neighbours: each call ends with a number (NaN only for NaN or infinity) or with a `RadcalcError`.
"""

import importlib
import inspect
import math
import random
import signal
from contextlib import contextmanager

import numpy as np

from radcalc.errors import RadcalcError
from radcalc.geometry import polygons, projections, solid
from radcalc.quantities.symbols import PROJECTIONS

SHORT, LONG = 6, 2_000  # calls of each function
RIGHT = math.pi / 2
EDGES = (
    0.0, -0.0, 5e-324, 1e-300, 1e-100, 1e-9, 0.5, 1.0, 3.0, RIGHT, math.nextafter(RIGHT, 0),
    math.nextafter(RIGHT, 4), math.pi, math.nextafter(math.pi, 4), 2 * math.pi, 1e9, 1e99, 1e100,
    1e200, 1e308, math.inf, -1e-9, -1.0, -math.inf, math.nan,
)  # fmt: skip
MODULES = (
    "",
    ".projections",
    ".receivers",
    ".solid",
)
# Functions with other arguments than numbers, swept below or by their own tests.
OTHERS = {"refuse", "bounded", "percent", "size", "reach", "is_near", "polygon"}
OTHERS |= {
    "facing",
    "reflected",
    "mirror_normal",
    "upright",
    "vector",
    "dot",
    "cross",
    "plus",
    "minus",
}
OTHERS |= {"times", "components", "from_components", "length", "scaled", "unit"}
OTHERS |= {"is_outside", "name_of_map", "has_shape", "direction_at", "density", "place_of"}
OTHERS |= {"radius_of", "middle_of_pixel", "corner_of_pixel", "pixel_solid_angle"}
OTHERS |= {"pixel_solid_angles", "solid_angles_in_circle", "field_text", "view_of_field"}
OTHERS |= {"view_of_angles", "projected_polygon"}
CPU_SECONDS = 20  # long enough for a busy machine


@contextmanager
def ending(case):
    """Fail if a call does not end."""

    def stop(*_):
        raise AssertionError(f"does not end: {case}")

    before = signal.signal(signal.SIGVTALRM, stop)
    signal.setitimer(signal.ITIMER_VIRTUAL, CPU_SECONDS)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0)
        signal.signal(signal.SIGVTALRM, before)


def held(function, *given, clean: bool) -> int:
    """Return 1 for a call that gives numbers, 0 for an error; `clean` arguments never give NaN."""
    case = f"{function.__module__}.{function.__name__}{given}"
    with ending(case):
        try:
            found = function(*given)
        except RadcalcError:
            return 0
        except (ArithmeticError, ValueError, TypeError) as error:
            raise AssertionError(f"{case}: {error!r}") from error
    for value in np.ravel(np.asarray(found, dtype=object)):
        if isinstance(value, (float, complex)) and clean:
            assert not isinstance(value, complex), case
            assert value == value, case
    return 1


def functions():
    for name in MODULES:
        module = importlib.import_module(f"radcalc.geometry{name}")
        for found, function in vars(module).items():
            own = inspect.isfunction(function) and function.__module__ == module.__name__
            if own and not found.startswith("_") and found not in OTHERS:
                names = inspect.signature(function).parameters
                yield function, [one for one in names if one not in ("normal", "is_long")]


def sweep(count: int, seed: int) -> str:
    dice, answers, calls = random.Random(seed), 0, 0
    for function, names in functions():
        for _ in range(count * len(names)):
            given = [dice.choice(EDGES) for _ in names]
            calls += 1
            answers += held(function, *given, clean=not any(map(math.isnan, given)))
    size = [x for x in EDGES if abs(x) <= 1e100 and not 0 < abs(x) < 1e-100]
    for _ in range(count):
        points = [tuple(dice.choice(size) for _ in range(3)) for _ in range(3)]
        toward = tuple(dice.choice(size) for _ in range(3))
        calls += 9
        projection = dice.choice(PROJECTIONS)
        answers += held(polygons.polygon, points, clean=True)
        answers += held(polygons.triangle, *points, clean=True)
        answers += held(solid.projected_polygon, points, toward, clean=True)
        answers += held(polygons.read_vertices, points, toward, clean=False)
        answers += held(projections.facing, toward, clean=True)
        answers += held(projections.reflected, points[0], toward, clean=True)
        answers += held(projections.mirror_normal, points[0], toward, clean=True)
        answers += held(projections.direction_at, projection, *toward[:2], clean=True)
        answers += held(projections.place_of, projection, *toward, clean=True)
    return f"{answers} of {calls} calls are answered"


if __name__ == "__main__":
    from fuzz.command import main

    main(sweep, LONG)
