"""The light meter: exposure values and their luminances and illuminances; filters and flashes."""

import math
from collections.abc import Sequence
from contextlib import suppress

from radcalc.answer import FRACTION, Answer, coherent_unit_of, format_number, format_value
from radcalc.calculators.page import Page
from radcalc.calculators.solved import Solved, solve
from radcalc.calculators.worksheet import Placed, Worksheet, worksheet
from radcalc.errors import ConditionError, Contradiction, MissingInput, Try, mention, option, quote
from radcalc.inputs import Input, Inputs
from radcalc.laws import AnyLaw
from radcalc.laws.photometry import (
    EXPOSURE_LAWS,
    FILTERED,
    FILTERED_FLASH,
    FLASH,
    INCIDENT,
    REFLECTANCE,
    REFLECTED,
    STEPS,
    UNFILTERED,
    exact,
)
from radcalc.laws.solver import TO_DIGITS
from radcalc.maths import any_true
from radcalc.quantities.symbols import METER_UNITS
from radcalc.units.scale_table import C, K, usual
from radcalc.units.values import ScaleUnit

LIGHT = ("ev100", "luminance", "illuminance")
FILTER = ("nd", "stops", "unfiltered-time")
OF_FLASH = ("guide-number", "distance")
PAGE = Page(
    "the light meter",
    (
        "ev",
        "ev100",
        "luminance",
        "illuminance",
        "f-number",
        "time",
        "iso",
        *FILTER,
        *OF_FLASH,
        "k",
        "c",
    ),
    others=(
        "ev100",
        "ev",
        "luminance",
        "illuminance",
        "reflectance",
        "saturation-luminance",
        "f-number",
        "time",
        "iso",
        *FILTER,
        *OF_FLASH,
        "k",
        "c",
    ),
    goal="ev100",
    about="Calculate exposure values, and the luminance and illuminance that they correspond to.",
    sections={
        "Light": LIGHT,
        "Camera": ("ev", "f-number", "time", "iso"),
        "Filter": FILTER,
        "Flash": OF_FLASH,
        "Meter": ("k", "c"),
    },
    texts={
        "distance": ("3m", "Distance from the flash to the subject."),
        "time": ("1/100s", "Exposure time, with the filter if there is one."),
        "illuminance": "Illuminance on the scene.",
        "luminance": "Luminance of the scene.",
    },
    examples=(
        "ev100=15",
        "luminance=1000cd/m2",
        "f-number=16 time=1/100s iso=100",
        "illuminance=500lx f-number=4 iso=400 get=time:ms",
        "unfiltered-time=1/60 nd=ND1000 get=time",
        "guide-number=40m f-number=8",
    ),
    bare={**METER_UNITS, "time": "s", "unfiltered-time": "s"},
    labels={"time": "exposure time"},
    forms={"time": FRACTION, "unfiltered-time": FRACTION},
    remarks="{ev} follows from the f-number and the time.  {ev100} follows from the given quantity "
    "of light.  At ISO 100 and without a filter the two are equal.  {luminance} gives "
    "{illuminance} for an average scene; both together give the reflectance of the scene.  "
    "{f-number} may be written as f/2.8.  A fraction for {time} is in seconds.  A {k} without a "
    "unit is in cd s/m2, and a {c} without a unit in lx s.  {nd} is a density (0.9 or ND0.9), or "
    "the factor of the filter (ND8).  For a flash, each of {guide-number}, {distance}, {f-number}, "
    "{iso} and the filter follows from the others.",
)
LEAST_STOPS = 1e-9  # fewer stops are rounding errors
FLASHING = PAGE._replace(
    title="a flash",
    takes=(*OF_FLASH, "f-number", "iso", "nd", "stops"),
    others=("f-number", *OF_FLASH, "iso", "nd", "stops"),
    goal="guide-number",
)


def ev(given: Inputs) -> Answer:
    """Return exposure values, f-number, time and light from any sufficient set of them.

    Redundant inputs may differ as much as cameras round their marks.
    """
    try:
        answer = _solve_exposure(given)
    except Contradiction as contradiction:
        marked = {name: item for name, item in given.items() if _rounded_by(item)}
        if not marked:
            raise
        loose = {name: item._replace(off=_rounded_by(item)) for name, item in marked.items()}
        try:
            answer = _solve_exposure({**given, **loose})
        except ConditionError:
            raise contradiction from None
        notes = [note for note in answer.notes if TO_DIGITS not in note]
        answer = answer._replace(notes=(*notes, *map(_marked, marked.values())))
    for row in answer.values:
        if row.name == "stops" and any_true(row.amount < -LEAST_STOPS):
            problem = "the time with a filter must be longer than without it"
            raise ConditionError(
                problem, mention("a longer {time}, or a shorter {unfiltered-time}")
            )
    return answer


def _rounded_by(item: Input) -> float:
    """Return the relative rounding error of an input that is marked on cameras; 0 for others."""
    if not isinstance(item.value, float) or item.uncertainty or not item.value:
        return 0.0
    return abs(exact(item.name, item.value) / item.value - 1)


def _marked(item: Input) -> str:
    meant = format_value(exact(item.name, item.value), coherent_unit_of(item.name), 4)
    return f"{option(item.name, quote(item.text))} is rounded, as marked on cameras: {meant}"


def _solve_exposure(given: Inputs) -> Answer:
    """Return the answer by the laws of a flash, a filter or an exposure; refuse light in EV."""
    for item in given.values():
        if isinstance(item.unit, ScaleUnit) and item.unit.scale.constant:
            problem = f"{option(item.name, quote(item.text))} is an exposure value"
            better = Try((("ev100", f"{item.number:.12g}"),), (item.name,))
            raise ConditionError(problem, better)
    if set(OF_FLASH) & set(given):
        return _flash(given)
    filtered = bool(set(FILTER) & set(given))
    page, all_laws = (
        (PAGE._replace(goal="stops", goals=("ev100",)), FILTERED)
        if filtered
        else (PAGE, EXPOSURE_LAWS)
    )
    if set(FILTER) & set(given) == {"unfiltered-time"} and "time" not in given:
        all_laws = [*all_laws, UNFILTERED]
    sheet, placed = worksheet(page, given, with_light=False), Placed()
    if filtered and not {*LIGHT, "ev", "f-number"} & set(given):
        return solve(sheet, all_laws).answer()
    if not {*LIGHT, "ev", "f-number"} & set(given):
        hint = mention("{ev100}, {luminance}, {illuminance} or {f-number}")
        raise MissingInput("the light or the setting of the camera is missing", hint)
    _place_usual(given, placed)
    if not {"luminance", "illuminance"} <= set(given):
        solved = solve(sheet, all_laws, placed, STEPS)
        _assume_average(solved)
        return solved.answer()
    return _solve_reflectance(given, sheet, placed, all_laws)


def _place_usual(given: Inputs, placed: Placed) -> None:
    """Add the usual constants of meters and sensitivity where none are given."""
    if "k" not in given:
        placed.add("k", K)
        placed.assume(usual("k", settable=True), of=["k"])
    if "c" not in given:
        placed.add("c", C)
        placed.assume(usual("c", settable=True), of=["c"])
    film_is_known = "ev" in given or {"f-number", "time"} <= set(given)
    light_is_known = bool(set(LIGHT) & set(given))
    if "iso" not in given and not (film_is_known and light_is_known):
        placed.add("iso", 100.0)
        placed.assume("ISO 100", of=["iso"])


def _solve_reflectance(
    given: Inputs, sheet: Worksheet, placed: Placed, all_laws: Sequence[AnyLaw]
) -> Answer:
    """Return the answer to a luminance with an illuminance, which give the reflectance."""
    if {"k", "c"} & set(given):
        with suppress(ConditionError):  # an average scene
            return solve(sheet, [*all_laws, REFLECTANCE], placed, STEPS).answer()
    laws = [law for law in all_laws if law is not REFLECTED] + [REFLECTANCE]
    try:
        solved = solve(sheet, laws, placed, STEPS)
        solved.assume("exposed for the illuminance, independent of the scene's reflectance")
    except ConditionError:  # exposed for the luminance, if that fits
        laws = [law for law in all_laws if law is not INCIDENT] + [REFLECTANCE]
        solved = solve(sheet, laws, placed, STEPS)
        solved.assume("exposed for the luminance, independent of the illuminance")
    solved.refuse_impossible(
        "reflectance",
        because="the scene reflects more light than it receives",
        hint="less luminance, or more illuminance",
    )
    return solved.answer()


def _flash(given: Inputs) -> Answer:
    sheet, placed = worksheet(FLASHING, given, with_light=False), Placed()
    if "iso" not in given and not {*OF_FLASH, "f-number"} <= set(given):
        placed.add("iso", 100.0)
        placed.assume("ISO 100", of=["iso"])
    placed.assume("direct flash, without other light")
    laws = FILTERED_FLASH if {"nd", "stops"} & set(given) else FLASH
    return solve(sheet, laws, placed).answer()


def _assume_average(solved: Solved) -> None:
    others = {"luminance", "illuminance"} - set(solved.given)
    if len(others) == 1:
        average = format_number(100 * math.pi * solved.value("k") / solved.value("c"), 3)
        solved.assume(
            "luminance and illuminance of a scene with the average reflectance pi K / C, "
            f"{average} %",
            of=others,
        )
