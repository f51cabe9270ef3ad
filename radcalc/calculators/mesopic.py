"""Mesopic luminance by CIE 191:2010."""

from radcalc.answer import Answer
from radcalc.calculators.page import Page
from radcalc.calculators.solved import solve
from radcalc.calculators.worksheet import Placed, worksheet
from radcalc.errors import ConditionError, MissingInput, mention, quote
from radcalc.inputs import Input, Inputs, require
from radcalc.inputs.quantities import as_seen
from radcalc.laws.photometry import MESOPIC_LAWS
from radcalc.maths import any_true
from radcalc.quantities.symbols import SCOTOPIC
from radcalc.spectra.observers import OBSERVERS

RESULTS = ("mesopic-luminance", "adaptation", "luminance", "scotopic-luminance", "sp-ratio")
PAGE = Page(
    "a mesopic luminance",
    ("luminance", "sp-ratio", "spectrum", "mesopic-luminance", "scotopic-luminance"),
    others=RESULTS,
    goal="mesopic-luminance",
    about="Calculate the mesopic luminance by CIE 191:2010, between scotopic and photopic vision.",
    sections={
        "Light": ("luminance", "sp-ratio", "spectrum"),
        "Other luminances": ("mesopic-luminance", "scotopic-luminance"),
    },
    texts={
        "spectrum": ("SOURCE", "Spectrum of the light, for its S/P ratio."),
        "luminance": ("0.1cd/m2", "Photopic luminance."),
    },
    examples=(
        "luminance=0.1cd/m2 sp-ratio=2",
        "luminance=0.5cd/m2 spectrum=LED-B3",
        "mesopic-luminance=0.1cd/m2 sp-ratio=2 get=luminance:cd/m2",
    ),
)
HIGHEST = 1e12  # [cd/m2], above any source


def mesopic(given: Inputs) -> Answer:
    """Return mesopic luminance, luminance and S/P ratio from any two of them."""
    if "scotopic-luminance" in given:  # by its name, also in cd/m2
        seen = as_seen(given["scotopic-luminance"], SCOTOPIC)
        given = {**given, seen.name: seen}
    sheet, placed = worksheet(PAGE, given, with_light=False), Placed()
    if "luminance" in given:
        bright = any_true(given["luminance"].value > HIGHEST)
        require(given["luminance"], not bright, "up to 1e12 cd/m2")
    if "spectrum" in given:
        source = given["spectrum"].value
        placed.add("sp-ratio", _ratio_of(given["spectrum"]))
        ratio = f"the S/P ratio of {source.described.removeprefix('spectrum ')}"
        placed.assume(ratio, of=["sp-ratio"])
        placed.note(*source.notes, of=["sp-ratio"])
    luminances = {"luminance", "mesopic-luminance", "scotopic-luminance"} & set(given)
    if not luminances:
        raise MissingInput("a luminance is missing", mention("{luminance=0.1cd/m2}"))
    if not {"sp-ratio", "spectrum"} & set(given) and len(luminances) < 2:
        hint = mention("{sp-ratio=2} or {spectrum=LED-B3}")
        raise MissingInput("the S/P ratio is missing", hint)
    system = "the recommended system of CIE 191:2010 (MES2)"
    placed.assume(system, of=["mesopic-luminance"])
    solved = solve(sheet, MESOPIC_LAWS, placed)
    if solved.has("adaptation"):
        if any_true(solved.value("adaptation") == 1):
            solved.note("photopic vision: m is 1 from 5 cd/m2 on")
        if any_true(solved.value("adaptation") == 0):
            solved.note("scotopic vision: m is 0 up to 0.005 cd/m2")
    return solved.answer()


def _ratio_of(given: Input) -> float:
    source = given.value
    photopic = source.lumens(OBSERVERS["photopic"])
    if not photopic > 0:
        raise ConditionError(f"{quote(source.label)} is invisible by day", "another spectrum")
    return float(source.lumens(OBSERVERS["scotopic"]) / photopic)
