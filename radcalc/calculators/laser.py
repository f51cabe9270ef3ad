"""A laser beam: its spot at a distance, the irradiance, and the hazard distance."""

import math

from radcalc.answer import Answer, format_number
from radcalc.calculators.page import Page
from radcalc.calculators.solved import Solved, solve
from radcalc.calculators.worksheet import Placed, worksheet
from radcalc.conversion import spectral
from radcalc.errors import ConditionError, MissingInput, mention, option, options, quote
from radcalc.inputs import Inputs
from radcalc.laws.beams import DISTANCE, HAZARD, laser_laws
from radcalc.laws.solver import reached
from radcalc.maths import any_true
from radcalc.quantities.symbols import GAUSSIAN, LINKS, REFINEMENTS, UNIFORM

BEAM = ("diameter", "divergence", "profile")
# What a remark on the profile of the beam is on.
PROFILED = ("spot-diameter", "divergence", "peak-irradiance", "limit", "received-flux")
SPOT = ("distance", "spot-diameter", "time", "receiver-diameter")
LIGHT = ("flux", "energy", "irradiance", "peak-irradiance", "exposure")
PROFILES = {
    GAUSSIAN: "a Gaussian beam with its waist at the laser's exit; diameters at 1/e^2 of the peak, "
    "with 86.5 % of the flux inside and a peak of twice the mean",
    UNIFORM: "a uniform beam, which widens by phi d",
}
PAGE = Page(
    "a laser beam",
    (*BEAM, *SPOT, HAZARD),
    ("irradiance", "peak-irradiance", "exposure", "flux", "energy", "received-flux", "limit"),
    ("spot-diameter", HAZARD, "distance", "diameter", "divergence", "time", "receiver-diameter"),
    goal="spot-diameter",
    results=("luminous-efficacy",),
    about="Calculate the spot and the irradiance of a laser beam, and its hazard distance.",
    sections={
        "Beam": (*BEAM, *LIGHT),
        "Spot": SPOT,
        "Hazard distance": ("limit", HAZARD),
        "Radiant, luminous and photon quantities": (*LINKS, *REFINEMENTS),
    },
    texts={
        "diameter": ("1mm", "Diameter of the beam at the laser's exit."),
        "distance": ("10m", "Distance of the spot from the laser's exit (default: at the exit)."),
        "receiver-diameter": (
            "7mm",
            "Diameter of a round receiver centred on the beam's axis: a pupil, a sensor.",
        ),
        "time": ("10ns", "Duration of a pulse or of an exposure, with a constant flux."),
        "flux": ("5mW", "Flux of the beam, or of a pulse while it lasts."),
        "irradiance": ("1W/m2", "Flux divided by the area of the spot."),
        "exposure": ("100J/m2", "Exposure of the spot; {time} relates it to the irradiance."),
        "energy": ("10mJ", "Energy of a pulse, or of the beam during {time}."),
        "peak-irradiance": ("10W/m2", "Peak irradiance, on the axis."),
        "limit": (
            "25W/m2",
            "Limit of the peak irradiance, from the standard (gives {hazard-distance}).",
        ),
    },
    examples=(
        "flux=5mW diameter=1mm divergence=1mrad distance=10m",
        "flux=5mW diameter=1mm divergence=1mrad limit=25W/m2 get=hazard-distance",
        "flux=1W diameter=3mm divergence=1.5mrad limit=25W/m2 profile=uniform",
        "flux=5mW wavelength=532nm diameter=1mm divergence=1mrad distance=50m get=illuminance:lx",
        "energy=10mJ time=8ns diameter=6mm get=peak-irradiance:MW/cm2",
        "flux=1mW diameter=8mm receiver-diameter=7mm get=received-flux:mW",
    ),
    remarks="{divergence} is the full angle of the beam far from the laser.  By default the beam "
    "is Gaussian, with diameters at 1/e^2 of the peak.  Laser safety standards use another "
    "formula, 1.27 P / (a + phi d)^2 (P: flux, a: diameter, phi: divergence, d: distance).  It "
    "applies to a uniform beam ({profile=uniform}), or to a Gaussian beam with diameters at 1/e of "
    "the peak.  The hazard distance is the distance at which the peak irradiance falls to the "
    "{limit}.  Take the limit from the standard: radcalc has no table of limits and gives no "
    "advice on safety.  Give the quantities that you know; radcalc calculates those that follow "
    "from them.",
)


def laser(given: Inputs) -> Answer:
    """Return the spot and the hazard distance of a laser beam, from enough quantities."""
    sheet, placed = worksheet(PAGE, given), Placed()
    if not {*sheet.given, *sheet.lit.values} - {"profile"}:
        hint = mention("{flux}, {diameter}, {divergence} and {distance}")
        raise MissingInput("the beam is missing", hint)
    profile = given["profile"].value if "profile" in given else GAUSSIAN
    placed.use("profile")
    far = laser_laws(profile, with_distance=True)
    is_far = DISTANCE in reached(far, set(sheet.known))
    at_exit = laser_laws(profile, with_distance=False)
    placed.assume(PROFILES[profile], of=PROFILED)
    is_at_exit = not is_far
    try:
        solved = solve(sheet, at_exit if is_at_exit else far, placed)
    except ConditionError as error:
        if DISTANCE in given:
            raise
        is_at_exit = not is_at_exit
        try:  # the spot may be wider than the beam at the exit, or as wide to the digits typed
            solved = solve(sheet, at_exit if is_at_exit else far, placed)
        except ConditionError:
            raise error from None
    solved.refuse_impossible("divergence")
    if "limit" in sheet.lit.values and not solved.has(HAZARD):
        limit_text = option("limit", quote(sheet.lit.values["limit"].text))
        lacking = [n for n in ("flux", "diameter", "divergence") if not solved.has(n)]
        hint = options(lacking, " and ")
        raise MissingInput(f"{limit_text} alone is not enough for a hazard distance", hint)
    if solved.has("spot-diameter"):
        if is_at_exit:
            solved.assume(
                mention("the spot is at the laser's exit (no {distance})"), of=["spot-diameter"]
            )
        mean = "irradiance: the mean, the flux divided by the area of the spot"
        solved.assume(mean, of=["irradiance", "exposure"])
    if solved.has("divergence"):
        solved.assume("divergence: the full angle, far from the laser", of=["divergence"])
        _note_diffraction(solved, profile)
    if solved.has("received-flux"):
        centred = "the receiver is round and centred on the beam's axis"
        solved.assume(centred, of=["received-flux"])
    if solved.has("limit"):
        solved.assume(
            "the limit, as given, applies to the peak irradiance; nothing absorbs on the way",
            of=["limit"],
        )
        if solved.has(HAZARD) and any_true(solved.value(HAZARD) == 0):
            solved.note("the peak irradiance is already below the limit at the laser's exit")
    return solved.answer()


def _note_diffraction(solved: Solved, profile: str) -> None:
    wave = solved.lit.links.get("wavelength")
    if wave is None or profile != GAUSSIAN or not solved.has("diameter"):
        return
    least = 4 * spectral.light(wave).vacuum / (math.pi * solved.value("diameter"))
    if any_true(solved.value("divergence") < least):
        solved.note(
            f"a waist of that diameter spreads by {format_number(1e3 * least, 3)} mrad or more, "
            f"by diffraction at {wave.text}: the waist is elsewhere, or the divergence is wrong"
        )
