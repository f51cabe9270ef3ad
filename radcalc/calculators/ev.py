"""The light meter: exposure values, and what light they stand for."""

from radcalc.answer import Answer
from radcalc.calculators.worksheet import Page, Worksheet
from radcalc.errors import MissingInput, mention
from radcalc.given import Inputs
from radcalc.laws.exposure import LAWS, STEPS, C, K

LIGHT = ("ev100", "luminance", "illuminance")
PAGE = Page(
    "the light meter",
    ("ev", "ev100", "luminance", "illuminance", "f-number", "time", "iso", "k", "c"),
    others=(
        "ev100",
        "ev",
        "luminance",
        "illuminance",
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
    remarks="{ev} is that of the f-number and the time, at the ISO speed given; {ev100} is that "
    "of the light.",
)


def ev(given: Inputs) -> Answer:
    """Exposure values, f-number, time, luminance and illuminance, from any that suffice."""
    sheet = Worksheet(PAGE, given, with_light=False)
    if not {*LIGHT, "ev", "f-number"} & set(given):
        hint = mention("{ev100}, {luminance}, {illuminance} or {f-number}")
        raise MissingInput("the light is missing", hint)
    if "k" not in given:
        sheet.know("k", K)
        sheet.assume(mention("K = 12.5 cd s/m2 (some makers have 14: {k})"))
    if "c" not in given:
        sheet.know("c", C)
        sheet.assume(mention("C = 250 lx s (320 to 340 with a dome: {c})"))
    film_is_known = "ev" in given or {"f-number", "time"} <= set(given)
    light_is_known = bool(set(LIGHT) & set(given))
    if "iso" not in given and not (film_is_known and light_is_known):
        sheet.know("iso", 100.0)
        sheet.assume("ISO 100")
    sheet.solve(LAWS, STEPS)
    return sheet.answer(LAWS)
