"""Radiant flux and energy from the temperature rise of an absorbing body."""

from radcalc.answer import Answer
from radcalc.calculators.page import Page
from radcalc.calculators.solved import solve
from radcalc.calculators.worksheet import Placed, worksheet
from radcalc.errors import ConditionError, MissingInput, mention
from radcalc.inputs import Inputs
from radcalc.laws import HEAT_LAWS
from radcalc.quantities import RADIANT

QUANTITIES = ("flux", "energy", "irradiance")
BODY = ("mass", "specific-heat", "temperature-rise")
PAGE = Page(
    "a calorimeter",
    (*BODY, "absorptance", "time", "receiver-area"),
    QUANTITIES,
    ("heat", *BODY, "absorptance", "time", "receiver-area"),
    about="Calculate the radiant flux that heats a body, or the temperature rise from a flux.",
    sections={"Light": QUANTITIES, "Body": (*BODY, "absorptance", "receiver-area", "time")},
    texts={
        "receiver-area": "Area that the light falls on.",
        "time": "Time for which the body is in the light.",
        "flux": ("100W", "Flux on the body."),
        "irradiance": (
            "100W/m2",
            "Irradiance on the body; {receiver-area} relates it to the flux.",
        ),
        "energy": ("100J", "Energy that reaches the body; {time} relates it to the flux."),
    },
    examples=(
        "mass=10g specific-heat=385J/kg/K temperature-rise=2K time=30s",
        "irradiance=1000W/m2 receiver-area=20cm2 absorptance=0.95 time=1min mass=10g "
        "specific-heat=385J/kg/K get=temperature-rise:K",
    ),
    kinds=(RADIANT,),
)


def calorimeter(given: Inputs) -> Answer:
    """Return radiant flux, energy and temperature rise from a sufficient set."""
    sheet, placed = worksheet(PAGE, given), Placed()
    if sheet.lit.kind != RADIANT or sheet.lit.links:
        raise ConditionError(
            "a calorimeter measures watts and joules", mention("{flux=5W}, {energy=10J}")
        )
    if not given:
        hint = mention("{mass}, {specific-heat} and {temperature-rise}")
        raise MissingInput("the inputs are missing", hint)
    placed.default(
        sheet, HEAT_LAWS, "absorptance", 1.0, "a black body: all of the light is absorbed"
    )
    placed.assume("no heat is lost", of=["heat"])
    solved = solve(sheet, HEAT_LAWS, placed)
    solved.refuse_impossible(
        "absorptance", because="the body gets more heat than light", hint="more light, or less heat"
    )
    return solved.answer()
