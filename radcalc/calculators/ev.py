"""The light meter: exposure values, and what light they stand for."""

from radcalc.answer import Answer
from radcalc.calculators import inputs as i
from radcalc.calculators import light as q
from radcalc.calculators.inputs import Inputs
from radcalc.calculators.worksheet import Sheet
from radcalc.conversion.conditions import require
from radcalc.errors import UsageError
from radcalc.laws.law import AnyLaw, Law, Relation
from radcalc.maths import any_true, log2

INPUTS = ("ev", "ev100", "luminance", "illuminance", "f-number", "time", "iso", "k", "c")
K, C = 12.5, 250.0  # cd s/m2 and lx s: what most makers of meters use
SATURATION = 1.2  # saturation luminance [cd s/m2] at ISO 100, of ISO 2720 and 12232
MOST_EV = 100  # of which no camera and no light comes near
UNITS = {
    "ev100": "1",
    "ev": "1",
    "luminance": "cd/m2",
    "illuminance": "lx",
    "saturation-luminance": "cd/m2",
    "f-number": "1",
    "time": "s",
    "iso": "1",
    "k": "cd s/m2",
    "c": "lx s",
}
LAWS: list[AnyLaw] = [
    Law(
        "exposure of a lens",
        "{light} = {f-number}^2 / {time}",
        "light",
        (("f-number", 2), ("time", -1)),
        reference="ISO 2720",
    ),
    Relation(
        "exposure value",
        "{ev} = log2({light} / 1 Hz)",
        ("ev", "light"),
        {"ev": lambda at: log2(at("light")), "light": lambda at: 2.0 ** at("ev")},
        "ISO 2720",
    ),
    Relation(
        "exposure value at ISO 100",
        "{ev100} = {ev} - log2({iso} / 100)",
        ("ev100", "ev", "iso"),
        {
            "ev100": lambda at: at("ev") - log2(at("iso") / 100),
            "ev": lambda at: at("ev100") + log2(at("iso") / 100),
            "iso": lambda at: 100 * 2.0 ** (at("ev") - at("ev100")),
        },
        "ISO 2720",
    ),
    Relation(
        "reflected light",
        "{luminance} = {k} 2^{ev100} / 100",
        ("luminance", "k", "ev100"),
        {
            "luminance": lambda at: at("k") / 100 * 2.0 ** at("ev100"),
            "ev100": lambda at: log2(at("luminance") * 100 / at("k")),
        },
        "ISO 2720",
    ),
    Relation(
        "incident light",
        "{illuminance} = {c} 2^{ev100} / 100",
        ("illuminance", "c", "ev100"),
        {
            "illuminance": lambda at: at("c") / 100 * 2.0 ** at("ev100"),
            "ev100": lambda at: log2(at("illuminance") * 100 / at("c")),
        },
        "ISO 2720",
    ),
    Relation(
        "saturation",
        "{saturation-luminance} = 1.2 cd/m2 2^{ev100}",
        ("saturation-luminance", "ev100"),
        {"saturation-luminance": lambda at: SATURATION * 2.0 ** at("ev100")},
        "ISO 12232, saturation-based speed",
    ),
]


def ev(given: Inputs) -> Answer:
    """Exposure values, f-number, time, luminance and illuminance, from any that suffice."""
    i.only(given, INPUTS, "the light meter")
    if not {"ev", "ev100", "luminance", "illuminance", "f-number"} & set(given):
        raise UsageError(
            "the light is missing", "--ev100, --luminance, --illuminance or --f-number"
        )
    for name in ("ev", "ev100"):
        if name in given:
            one = given[name]
            require(one, not any_true(abs(one.value) > MOST_EV), f"from -{MOST_EV} to {MOST_EV}")
    nothing = q.read_light({}, {})
    sheet = Sheet(nothing, given, {"light": "b"})
    for name in ("ev", "ev100"):
        if name in given:
            sheet.know(name, given[name].value, given[name])
    if "k" not in given:
        sheet.know("k", K)
        sheet.said.append("K = 12.5 cd s/m2 (some makers have 14: --k)")
    if "c" not in given:
        sheet.know("c", C)
        sheet.said.append("C = 250 lx s (320 to 340 with a dome: --c)")
    if "iso" not in given and not (_links_film(given) and _links_light(given)):
        sheet.know("iso", 100.0)
        sheet.said.append("ISO 100")
    sheet.solve(LAWS)
    sheet.refuse_idle(LAWS, INPUTS)
    rows = sheet.input_rows(UNITS)
    rows += sheet.absent_rows(LAWS, (*INPUTS, "saturation-luminance"), INPUTS)
    _, shown = sheet.light_rows(())
    return sheet.answer(rows, shown)


def _links_film(given: Inputs) -> bool:
    """Whether the exposure of the film follows without its speed."""
    return "ev" in given or {"f-number", "time"} <= set(given)


def _links_light(given: Inputs) -> bool:
    """Whether the scene's light follows without the film's speed."""
    return bool({"ev100", "luminance", "illuminance"} & set(given))
