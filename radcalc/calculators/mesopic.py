"""Mesopic luminance, between night and day, by CIE 191:2010."""

from radcalc.answer import Answer
from radcalc.calculators.worksheet import Page, Worksheet
from radcalc.errors import ConditionError, Exclusive, MissingInput, mention, quote
from radcalc.given import Given, Inputs, require
from radcalc.laws.mesopic import LAWS
from radcalc.spectra.observers import OBSERVERS

RESULTS = ("mesopic-luminance", "adaptation", "luminance", "scotopic-luminance", "sp-ratio")
PAGE = Page(
    "a mesopic luminance",
    ("luminance", "sp-ratio", "spectrum", "mesopic-luminance", "scotopic-luminance"),
    others=RESULTS,
    goal="mesopic-luminance",
    takes_arrays=False,
    about="Give the mesopic luminance of CIE 191:2010, between night and day.",
    sections={
        "Light": ("luminance", "sp-ratio", "spectrum"),
        "Solved for the others": ("mesopic-luminance", "scotopic-luminance"),
    },
    examples=(
        "luminance=0.1cd/m2 sp-ratio=2",
        "luminance=0.5cd/m2 spectrum=LED-B3",
        "mesopic-luminance=0.1cd/m2 sp-ratio=2 get=luminance:cd/m2",
    ),
)
HIGHEST = 1e12  # cd/m2, beyond any source


def mesopic(given: Inputs) -> Answer:
    """Mesopic luminance from luminance and S/P ratio, or one of these from the others."""
    sheet = Worksheet(PAGE, given, with_light=False)
    if "luminance" in given:
        require(given["luminance"], given["luminance"].value <= HIGHEST, "up to 1e12 cd/m2")
    if "spectrum" in given:
        if "sp-ratio" in given:
            raise Exclusive(("sp-ratio", "spectrum"), "both give the S/P ratio")
        source = given["spectrum"].value
        sheet.know("sp-ratio", _ratio_of(given["spectrum"]))
        sheet.assume(f"the S/P ratio of {source.described.removeprefix('spectrum ')}")
        sheet.notes += source.notes
    luminances = {"luminance", "mesopic-luminance", "scotopic-luminance"} & set(given)
    if not luminances:
        raise MissingInput("a luminance is missing", mention("{luminance=0.1cd/m2}"))
    if not sheet.has("sp-ratio") and len(luminances) < 2:
        hint = mention("{sp-ratio=2} or {spectrum=LED-B3}")
        raise MissingInput("the S/P ratio is missing", hint)
    sheet.assume("the recommended system of CIE 191:2010 (MES2)")
    sheet.solve(LAWS)
    if sheet.has("adaptation"):
        if sheet.at("adaptation") == 1:
            sheet.notes.append("photopic vision: from 5 cd/m2 on, m is 1")
        if sheet.at("adaptation") == 0:
            sheet.notes.append("scotopic vision: up to 0.005 cd/m2, m is 0")
    return sheet.answer(LAWS)


def _ratio_of(given: Given) -> float:
    """The ratio of scotopic to photopic of a spectrum."""
    source = given.value
    seen = source.lumens(OBSERVERS["photopic"])
    if not seen > 0:
        raise ConditionError(f"nothing of {quote(source.label)} is seen by day", "another spectrum")
    return float(source.lumens(OBSERVERS["scotopic"]) / seen)
