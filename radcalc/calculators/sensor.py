"""A camera sensor or a detector: its light, photons, electrons and current."""

from typing import Any

from radcalc import geometry
from radcalc.answer import FRACTION, Answer
from radcalc.calculators import kinds
from radcalc.calculators.page import Page
from radcalc.calculators.results import LINKS_HINT, NEEDS_LINK
from radcalc.calculators.solved import Solved, solve
from radcalc.calculators.worksheet import Placed, Worksheet, place, worksheet
from radcalc.errors import MissingInput, mention, option
from radcalc.inputs import Input, Inputs, angle_of
from radcalc.laws import ENERGY, EXPOSURE, AnyLaw, At, law, relation
from radcalc.maths import cos, sqrt, square
from radcalc.quantities import LUMINOUS, PHOTON, RADIANT, RATIOS
from radcalc.quantities.symbols import LINKS, REFINEMENTS, SYMBOLS
from radcalc.spectra.spectrum import range_text
from radcalc.units.table import resolve

CHARGE = resolve("eV").factor  # of an electron, in ampere seconds
SI = "SI Brochure: exact e"
LENS = ("f-number", "working-f-number", "magnification", "off-axis-angle", "transmittance")
PIXEL = ("pixel-pitch", "pixel-area", "time")
DETECTOR = ("quantum-efficiency", "responsivity", "electrons", "current", "snr")
ON_SENSOR = ("irradiance", "exposure", "flux", "energy")


def _magnification(at: At) -> Any:
    geometry.refuse(
        at("working-f-number") < at("f-number"),
        "the working f-number must not be below the lens's",
        "a working f-number of that or more",
    )
    return at("working-f-number") / at("f-number") - 1


OPTICS: list[AnyLaw] = [
    law(
        "camera equation",
        "{irradiance} = pi Omega0 {radiance} {transmittance} {cosine-off-axis}^4 / "
        "(4 {working-f-number}^2)",
        "sine condition: pi sin^2(alpha) = pi / (4 N^2)",
    ),
    relation(
        "working f-number",
        "{working-f-number} = {f-number} (1 + {magnification})",
        {
            "working-f-number": lambda at: at("f-number") * (1 + at("magnification")),
            "f-number": lambda at: at("working-f-number") / (1 + at("magnification")),
            "magnification": _magnification,
        },
        "a lens with pupils of equal size",
    )._replace(has_limit=True),
    law(
        "etendue of a pixel",
        "{etendue} = pi Omega0 {pixel-area} {cosine-off-axis}^4 / (4 {working-f-number}^2)",
    ),
    law(
        "flux on a pixel, from the radiance of the scene",
        "{flux} = {radiance} {transmittance} {etendue}",
    ),
]
COLLECTED: list[AnyLaw] = [
    law("area of a square pixel", "{pixel-area} = {pixel-pitch}^2"),
    law("flux on a pixel", "{flux} = {irradiance} {pixel-area}"),
    law("energy on a pixel", "{energy} = {exposure} {pixel-area}"),
    ENERGY,
    EXPOSURE,
]
COUNTED: list[AnyLaw] = [
    law("electrons", "{electrons} = {quantum-efficiency} {photons}", unit="1/photon"),
    law("current of electrons", "{current} = e {electrons} / {time}", SI, CHARGE, "A s"),
    relation(
        "signal to shot noise",
        "{snr} = sqrt({electrons})",
        {"snr": lambda at: sqrt(at("electrons")), "electrons": lambda at: square(at("snr"))},
        "Poisson statistics",
    ),
]
OF_KIND: dict[str, list[AnyLaw]] = {
    RADIANT: [
        law("photons on a pixel", "{photons} = {photon-efficacy} {energy}"),
        law(
            "responsivity",
            "{responsivity} = e {quantum-efficiency} {photon-efficacy}",
            f"{SI}; K_p: photons per joule",
            CHARGE,
            "A s/photon",
        ),
        law("photocurrent", "{current} = {responsivity} {flux}"),
    ],
    PHOTON: [
        law("number of photons on a pixel", "{photons} = {energy}"),
        law(
            "photocurrent of photons",
            "{current} = e {quantum-efficiency} {flux}",
            SI,
            CHARGE,
            "A s/photon",
        ),
    ],
    LUMINOUS: [],
}
LAWS: list[AnyLaw] = [*OPTICS, *COLLECTED, *COUNTED, *OF_KIND[RADIANT], *OF_KIND[PHOTON]]
PAGE = Page(
    "a sensor",
    (*LENS, "etendue", *PIXEL, "photons", *DETECTOR),
    ("irradiance", "exposure", "flux", "energy", "radiance"),
    ("photons", *DETECTOR, "etendue", *LENS, *PIXEL),
    goal="electrons",
    goals=("working-f-number", "responsivity"),
    results=("luminous-efficacy",),
    about="Calculate the light that a lens sends to a sensor, its photons, electrons and current.",
    sections={
        "Light": ("radiance", *ON_SENSOR),
        "Lens": (*LENS, "etendue"),
        "Pixel": PIXEL,
        "Detector": ("photons", *DETECTOR),
        "Radiant, luminous and photon quantities": (*LINKS, *REFINEMENTS),
    },
    texts={
        "photon-range": "Photon quantities of {spectrum} include only these wavelengths (default: "
        "those of radiant quantities).",
        "etendue": ("1um2.sr", "Etendue of the light on a pixel."),
        "time": ("1/100s", "Exposure time."),
        "flux": ("0.1uW", "Flux on a pixel, or on the detector."),
        "irradiance": ("10lx", "Irradiance on the sensor."),
        "radiance": ("1000cd/m2", "Radiance of the scene."),
        "exposure": ("0.1lx.s", "Exposure of the sensor; {time} relates it to the irradiance."),
        "energy": ("1fJ", "Energy on a pixel; {time} relates it to the flux."),
    },
    examples=(
        "luminance=4000cd/m2 f-number=16 time=1/100s",
        "luminance=100cd/m2 f-number=2.8 transmittance=0.9 time=10ms pixel-pitch=3.45um "
        "wavelength=550nm quantum-efficiency=0.6",
        "irradiance=1W/m2 wavelength=525nm pixel-pitch=5um quantum-efficiency=50% snr=100 "
        "get=time:ms",
        "radiance=10W/m2/sr f-number=4 magnification=1 get=irradiance",
        "luminance=1000cd/m2 f-number=2 off-axis-angle=0deg:40deg:10deg get=illuminance:lx",
        "illuminance=5lx spectrum=D65 range=400nm:700nm time=20ms pixel-pitch=3um "
        "quantum-efficiency=0.55 get=electrons",
        "flux=0.1uW wavelength=800nm quantum-efficiency=1/3 get=current:nA",
    ),
    bare={"time": "s"},
    forms={"time": FRACTION},
    remarks="{radiance} describes the scene.  The other light quantities are measured at the "
    "sensor.  The camera equation relates them.  {f-number} is the number N marked on the lens, "
    "for focus at infinity; {working-f-number} is N (1 + m), with the {magnification} m.  The area "
    "of a pixel or other detector is its light-collecting area.  To calculate electrons, radcalc "
    "needs the number of photons: give {wavelength} or {spectrum}, or light in photon units.  Give "
    "the quantities that you know; radcalc calculates those that follow from them.",
)
APERTURE = ("f-number", "working-f-number")
SILICON = 1200.0  # [nm]; silicon is transparent beyond


def sensor(given: Inputs) -> Answer:
    """Return light, photons, electrons and current of a sensor from a sufficient set."""
    if not given:
        hint = mention("{luminance} and {f-number}, or {irradiance} and {pixel-pitch}")
        raise MissingInput("the light is missing", hint)
    sheet, placed = worksheet(PAGE, _with_photons_counted(given), preferred=_kind(given)), Placed()
    kind = sheet.lit.kind
    factor = kinds.linking_factor(sheet.lit.links, PHOTON, RADIANT) if kind == RADIANT else None
    if factor:
        placed.add("photon-efficacy", factor.value)
        placed.assume(factor.assumption, of=["photon-efficacy"])
        placed.steps += factor.steps
    _refuse_unlinked(sheet, is_linked=factor is not None)
    laws = [*COLLECTED, *COUNTED, *OF_KIND.get(kind, [])]
    if "radiance" in sheet.known or set(LENS) & set(given):
        laws = [*OPTICS, *laws]
        _place_lens(sheet, placed, laws)
    solved = solve(sheet, laws, placed)
    solved.refuse_impossible("transmittance", "quantum-efficiency", "f-number", "working-f-number")
    if solved.has("working-f-number") and solved.has("radiance", "etendue"):
        solved.use("off-axis-angle")
    if solved.has("electrons", "current"):
        even = "the whole area of a pixel collects light uniformly"
        solved.assume(even, of=["pixel-area", *DETECTOR])
        if "spectrum" in sheet.lit.links:
            same = "the same quantum efficiency for all counted photons"
            solved.assume(same, of=DETECTOR)
            _note_infrared(solved)
    if solved.has("snr"):
        solved.assume("signal-to-noise ratio: shot noise only", of=["snr"])
    answer = solved.answer()
    if kind in (RADIANT, PHOTON):
        return answer
    lit = [
        value._replace(lacking=lambda: LINKS_HINT)
        if value.name in ("photons", *DETECTOR) and value.lacking
        else value
        for value in answer.values
    ]
    return answer._replace(values=lit)


def _kind(given: Inputs) -> str:
    """Return the kind to calculate in: photons if the efficacy links them with lumens."""
    links = (RATIOS[LUMINOUS, PHOTON], RATIOS[PHOTON, LUMINOUS])
    ratio = given.get("efficacy")
    return PHOTON if ratio and ratio.dimension in links else RADIANT


def _with_photons_counted(given: Inputs) -> Inputs:
    """Return the inputs, with the range of the watts as the photon range unless one is given."""
    if "spectrum" not in given or "photon-range" in given:
        return given
    limits = given["range"].value if "range" in given else given["spectrum"].value.limits
    counted = Input(SYMBOLS["photon-range"], range_text(limits), limits)
    return {**given, counted.name: counted}


def _note_infrared(solved: Solved) -> None:
    limits = solved.lit.links["photon-range"].value
    if limits[1] > SILICON:
        narrower = mention("{range=400nm:700nm} counts those that a filter transmits")
        solved.note(f"photons are counted over {range_text(limits)}: {narrower}")


def _refuse_unlinked(sheet: Worksheet, is_linked: bool) -> None:
    """Refuse inputs that need watts or photons if the light is of another kind."""
    kind = sheet.lit.kind
    lacking: tuple[str, ...] = ()
    if kind not in (RADIANT, PHOTON):
        lacking = ("photons", *DETECTOR)
    elif kind == PHOTON:
        lacking = ("responsivity",)
    elif not is_linked:
        lacking = ("photons", "quantum-efficiency")
    for name in lacking:
        if name in sheet.given and sheet.lit.values:
            option_text = option(name, sheet.given[name].text)
            problem = f"{option_text} {NEEDS_LINK}"
            raise MissingInput(problem, LINKS_HINT)


def _place_lens(sheet: Worksheet, placed: Placed, laws: list[AnyLaw]) -> None:
    """Add the angle off the axis, the defaults and the assumptions of the lens."""
    given = sheet.given
    if "off-axis-angle" in given:
        fourth = "off the axis: the fourth power of the cosine, without vignetting"
        placed.assume(fourth, of=["cosine-off-axis"])
    else:
        on_axis = mention("on the axis of the lens ({off-axis-angle})")
        placed.assume(on_axis, of=["cosine-off-axis"])
    placed.merge(place(sheet, _off_axis))
    placed.assume("a lens corrected for coma, in air: sin(alpha) = 1/(2 N)", of=APERTURE)
    if "working-f-number" not in given:
        far = mention("focused far away: a magnification of 0 ({magnification})")
        placed.default(sheet, laws, "magnification", 0.0, far)
    lossless = mention("a lens without losses: a transmittance of 1 ({transmittance})")
    placed.default(sheet, laws, "transmittance", 1.0, lossless)
    if "magnification" in given:
        placed.assume("pupils of equal size: the working f-number is N (1 + m)", of=APERTURE)


def _off_axis(sheet: Worksheet) -> Placed:
    placed = Placed()
    placed.add("cosine-off-axis", cos(angle_of(sheet.given, "off-axis-angle")))
    return placed
