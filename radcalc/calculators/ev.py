"""The light meter: exposure values, and what light they stand for."""

import math

from radcalc.answer import Answer
from radcalc.calculators.worksheet import Page, Worksheet
from radcalc.derivation import format_number
from radcalc.errors import ConditionError, MissingInput, mention, option, quote
from radcalc.given import Inputs
from radcalc.laws.exposure import INCIDENT, LAWS, REFLECTANCE, REFLECTED, STEPS
from radcalc.maths import any_true
from radcalc.units.scales import METER_UNITS, C, K, ScaleUnit, usual

LIGHT = ("ev100", "luminance", "illuminance")
PAGE = Page(
    "the light meter",
    ("ev", "ev100", "luminance", "illuminance", "f-number", "time", "iso", "k", "c"),
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
        "k",
        "c",
    ),
    goal="ev100",
    about="Give exposure values, and the light that a light meter shows them for.",
    sections={
        "Light": LIGHT,
        "Camera": ("ev", "f-number", "time", "iso"),
        "Meter": ("k", "c"),
    },
    examples=(
        "ev100=15",
        "luminance=1000cd/m2",
        "f-number=16 time=1/100s iso=100",
        "illuminance=500lx f-number=4 iso=400 get=time:ms",
    ),
    bare={**METER_UNITS, "time": "s"},
    remarks="{ev} is that of the f-number and the time, at the ISO speed given; {ev100} is that "
    "of the light.  From {luminance} to {illuminance} it takes an average scene; both of them give "
    "the reflectance of the scene.  {f-number} may be f/2.8, a fraction for {time} is in seconds, "
    "and a bare {k} or {c} in its usual unit.",
)


def ev(given: Inputs) -> Answer:
    """Exposure values, f-number, time, luminance and illuminance, from any that suffice."""
    for one in given.values():
        if isinstance(one.unit, ScaleUnit) and one.unit.scale.constant:
            problem = f"{option(one.name, quote(one.text))} is an exposure value"
            raise ConditionError(problem, f"{option('ev100', f'{one.number:.12g}')} in its place")
    sheet = Worksheet(PAGE, given, with_light=False)
    if not {*LIGHT, "ev", "f-number"} & set(given):
        hint = mention("{ev100}, {luminance}, {illuminance} or {f-number}")
        raise MissingInput("the light is missing", hint)
    if "k" not in given:
        sheet.know("k", K)
        sheet.assume(usual("k", settable=True))
    if "c" not in given:
        sheet.know("c", C)
        sheet.assume(usual("c", settable=True))
    film_is_known = "ev" in given or {"f-number", "time"} <= set(given)
    light_is_known = bool(set(LIGHT) & set(given))
    if "iso" not in given and not (film_is_known and light_is_known):
        sheet.know("iso", 100.0)
        sheet.assume("ISO 100")
    if not {"luminance", "illuminance"} <= set(given):
        sheet.solve(LAWS, STEPS)
        _say_average(sheet)
        return sheet.answer(LAWS)
    laws = [law for law in LAWS if law is not REFLECTED] + [REFLECTANCE]
    try:
        sheet.solve(laws, STEPS)
        sheet.assume("exposed for the illuminance, whatever the scene reflects of it")
    except ConditionError:  # exposed for the luminance, if that fits
        laws = [law for law in LAWS if law is not INCIDENT] + [REFLECTANCE]
        sheet.solve(laws, STEPS)
        sheet.assume("exposed for the luminance, whatever light falls on the scene")
    if any_true(sheet.at("reflectance") > 1 + 1e-9):
        raise ConditionError(
            f"a reflectance of {format_number(sheet.at('reflectance'))} is not possible: the scene "
            "sends out more light than falls on it",
            "less luminance, or more illuminance",
        )
    return sheet.answer(laws)


def _say_average(sheet: Worksheet) -> None:
    """Say what lies between a luminance and an illuminance."""
    if {"luminance", "illuminance"} & set(sheet.given):
        average = format_number(100 * math.pi * sheet.at("k") / sheet.at("c"), 3)
        sheet.assume(
            "between luminance and illuminance a scene of the average reflectance pi K / C, "
            f"{average} %"
        )
