"""Light measured by the heat it leaves in a body that absorbs it."""

from radcalc.answer import Answer
from radcalc.calculators import inputs as i
from radcalc.calculators import light as q
from radcalc.calculators.inputs import Inputs
from radcalc.calculators.worksheet import ENERGY, Sheet
from radcalc.errors import ConditionError, UsageError
from radcalc.laws.law import AnyLaw, Law
from radcalc.maths import any_true
from radcalc.quantities.light import RADIANT

QUANTITIES = ("flux", "energy", "irradiance")
INPUTS = (
    "mass",
    "specific-heat",
    "temperature-rise",
    "absorptance",
    "time",
    "receiver-area",
)
UNITS = {
    "heat": "J",
    "mass": "kg",
    "specific-heat": "J/kg/K",
    "temperature-rise": "K",
    "absorptance": "1",
    "time": "s",
    "receiver-area": "m2",
}
LAWS: list[AnyLaw] = [
    Law(
        "heat of a body",
        "{heat} = {mass} {specific-heat} {temperature-rise}",
        "heat",
        (("mass", 1), ("specific-heat", 1), ("temperature-rise", 1)),
    ),
    Law(
        "absorbed light",
        "{heat} = {absorptance} {energy}",
        "heat",
        (("absorptance", 1), ("energy", 1)),
        reference="ISO 80000-7, absorptance",
    ),
    ENERGY,
    Law(
        "flux on a receiver",
        "{flux} = {irradiance} {receiver-area}",
        "flux",
        (("irradiance", 1), ("receiver-area", 1)),
    ),
]


def calorimeter(given: Inputs) -> Answer:
    """Radiant flux and energy from a temperature rise, or any of them from the others."""
    quantities, links, rest = q.sort(given)
    i.only(rest, INPUTS, "a calorimeter")
    lit = q.read_light(quantities, links)
    if lit.kind != RADIANT or links:
        raise ConditionError("a calorimeter measures watts and joules", "--flux 5W, --energy 10J")
    if not given:
        raise UsageError("nothing is given", "--mass, --specific-heat and --temperature-rise")
    sheet = Sheet(lit, rest, {})
    if "absorptance" not in rest and not _is_solved_for(sheet):
        sheet.know("absorptance", 1.0)
        sheet.said.append("a black body: all of the light is absorbed")
    sheet.said.append("no heat is lost")
    sheet.solve(LAWS)
    sheet.refuse_idle(LAWS, (*QUANTITIES, *INPUTS))
    if sheet.has("absorptance") and any_true(sheet.at("absorptance") > 1 + 1e-9):
        raise ConditionError(
            "an absorptance above 1 is not possible: the body gets more heat than light",
            "more light, or less heat",
        )
    rows, shown = sheet.light_rows(QUANTITIES)
    rows += sheet.input_rows(UNITS)
    rows += sheet.absent_rows(LAWS, (*QUANTITIES, *INPUTS), (*QUANTITIES, *INPUTS))
    return sheet.answer(rows, shown)


def _is_solved_for(sheet: Sheet) -> bool:
    """Whether heat and light are both known, so that the absorptance follows."""
    heat = all(name in sheet.known for name in ("mass", "specific-heat", "temperature-rise"))
    light = "energy" in sheet.known or (
        "time" in sheet.known
        and ("flux" in sheet.known or {"irradiance", "receiver-area"} <= set(sheet.known))
    )
    return heat and light
