"""Right answers are accepted, by the library and by the commands."""

import math
from itertools import product

import pytest
from conftest import python, run
from helpers import PLAIN, example_of, for_each, results
from homework.questions import RIGHT, TILTED, asked, claim_of, typed, verdict

from radcalc import calculators
from radcalc.calculators.ev import ev
from radcalc.calculators.solid_angle import solid_angle
from radcalc.calculators.solved import Task
from radcalc.cli.spelling import Shell
from radcalc.errors import ConditionError, NumberError, RadcalcError
from radcalc.homework import Question, Verdict, check
from radcalc.homework.question import of_conversion, of_task, read_claim
from radcalc.inputs.reading import read
from radcalc.units.reading import read_amount
from radcalc.units.table import resolve
from radcalc.units.values import resolve_any


def right_value(words: str, name: str, unit: str) -> float:
    """Return the right value as the command answers it without --check."""
    if not name:
        return float(run(*words.split(), "-n", "-q").stdout)
    return float(run(*words.split(), "-q", "-g", f"{name}:{unit or '1'}").stdout)


def first_result(name: str) -> tuple[str, str, str]:
    """Return the first example of a calculator's page, with its first result."""
    words = Shell.command(name, *example_of(name)).removeprefix("radcalc ")
    follows = results(run(*words.split(), "--json").stdout)
    result = next(key for key, row in follows.items() if not row["given"])
    return words, result.replace("_", "-"), follows[result]["unit"].removeprefix("1")


DISC = "lambertian disc --luminance 1e4cd/m2 --radius 25cm --height 75cm"
REFLECTED = "lambertian --incident-illuminance 500lx --reflectance 0.8"
QUESTIONS = [*RIGHT, *map(first_result, PLAIN)]


def test_every_command_has_a_right_answer_here():
    # scenes and logs need files: see test_scene.py and test_dose.py in tests/calculators
    lists = {"units", "quantities", "typical", "examples", "help", "manual", "columns", "mark"}
    judging = set(calculators.COMMANDS) - lists - {"scene", "dose", "prompt"}
    assert {words.split()[0] for words, _, _ in QUESTIONS} == judging
    assert len(RIGHT) >= 30


@for_each(QUESTIONS)
def test_right_answers_are_accepted_at_their_digits(words, name, unit):
    value = right_value(words, name, unit)
    for digits in (2, 3, 4):
        claim = claim_of(name, value, digits, unit)
        found = verdict(words, claim, f"{digits}sf")
        assert found.right, claim
        assert found.value == pytest.approx(value, rel=1e-11)
        assert found.diagnoses == ()
        assert found.ratio == pytest.approx(float(typed(value, digits)) / value, rel=1e-9)
        if digits > 2:
            assert verdict(words, claim, None if name == "ev" else "1%").right, claim
    assert not verdict(words, claim_of(name, value * 1.03, 4, unit)).right


@pytest.mark.parametrize(
    ("words", "claim", "digits", "nearer"),  # 130/2.3^2 = 24.575, 470 0.72/pi = 107.72
    [
        ("convert 130 cd lx --distance 2.3m", "25", "the 2 digits", "24.6"),
        ("convert 130 cd lx --distance 2.3m", "2e1", "the digit", "24.6"),
        ("convert 470 lx cd/m2 --reflectance 0.72", "1.1e2", "the 2 digits", "108"),
        # lb(4000/0.125) = 14.966 is 15.0 to three digits, which is the answer again
        ("convert 4000 cd/m2 EV", "15EV", "the 2 digits", "14.97"),
    ],
)
def test_a_right_answer_in_few_digits_is_not_a_mistake(words, claim, digits, nearer):
    for tolerance in (None, "1%"):
        found = verdict(words, claim, tolerance)
        assert found.right == (tolerance is None)
        assert [one.mistake for one in found.diagnoses] == ["rounded"]
        assert found.diagnoses[0].done == f"to {digits} given"
        assert found.diagnoses[0].right == f"{nearer} is nearer"
    assert verdict(words, claim, "10%" if digits != "the digit" else "30%").right


LINKED = [  # answers in another unit of the same light, and whether they are right
    # 600 umol/m2/s for 16 h are 34.56 mol/m2 in the day, and 400 umol/m2/s over 24 h
    ("600 ppfd dli --photoperiod 16h", "34.6mol/m2/d", True),
    ("600 ppfd dli --photoperiod 16h", "51.8mol/m2/d", False),
    ("600 ppfd dli --photoperiod 16h", "400umol/m2/s", False),
    ("600+-30 ppfd dli --photoperiod 16h", "34.6+-1.7mol/m2/d", True),
    ("600 ppfd mol/m2 --time 16h", "34.6mol/m2/d", False),
    # 3 lambda^2/(h c) is 731.95 W/m2/eV; 1 eV is 8065.544 cm-1 and 241.7989 THz (CODATA)
    ("3 W/m2/nm W/m2/eV --wavelength 550nm", "0.09075W/m2/cm-1", True),
    ("3 W/m2/nm W/m2/eV --wavelength 550nm", "3.027W/m2/THz", True),
    ("3 W/m2/nm W/m2/eV --wavelength 550nm", "3.2W/m2/THz", False),
    ("3 W/m2/nm W/m2/eV --wavelength 550nm", "3W/m2/nm", False),
    # c 2 nm/(1550 nm)^2 is 249.57 GHz; 1 cm-1 is 29.9792 GHz
    ("2 nm GHz --wavelength 1550nm", "8.325cm-1", True),
    ("2 nm GHz --wavelength 1550nm", "1.032meV", True),
    ("2 nm meV --wavelength 1550nm", "249.6GHz", True),
    ("2 nm meV --wavelength 1550nm", "6cm-1", False),
    ("532 nm eV", "563.5THz", False),
]


@for_each(LINKED)
def test_an_answer_may_be_in_another_unit_of_the_same_light(words, claim, is_right):
    assert verdict(f"convert {words}", claim).right == is_right, claim


@pytest.mark.parametrize(
    ("value", "claim", "is_right"),
    [
        # half way, both neighbours are right
        ("1.55", "1.6", True), ("1.55", "1.5", True), ("1.55", "1.7", False),
        ("0.025", "0.02", True), ("0.025", "0.03", True), ("-2.5", "-3", True),
        # zeros at the end of an integer are digits, but not before a power of ten
        ("95", "100", False), ("95.4", "100", False), ("95.4", "1e2", True),
        ("95.4", "1.0e2", False), ("99.6", "1.0e2", True), ("107.72", "110", False),
        ("107.72", "1.1e2", True), ("9.96", "10", True), ("0.96", "1.0", False),
        # exactly at 1 %
        ("32.5", "32.825", True), ("32.5", "32.175", True), ("32.5", "32.8251", False),
        # an uncertainty that includes the value
        ("25.13", "25+-1", True), ("25.13", "25(1)", True), ("25.13", "24+-1", False),
        ("25.13", "24.13+-1", True), ("25.13", "26.14+-1", False), ("25.13", "1+-100", False),
    ],
)  # fmt: skip
def test_verdicts_are_decimal(value, claim, is_right):
    found = check(of_conversion(float(value), resolve("lx"), resolve("lx"), []), claim)
    assert found.right is is_right
    if claim in ("100", "110"):
        assert found.diagnoses[0].right in ("write 1e2", "write 1.1e2")


def test_a_value_half_way_between_two_numbers_is_rounded_to_either():
    for n, power in product(range(10, 100), range(-8, 9, 4)):
        value = float(f"{n}.5e{power}")
        question = of_conversion(value, resolve("lx"), resolve("lx"), [])
        for claim in (f"{n}e{power}", f"{(n + 1) / 10:.1f}e{power + 1}"):
            assert check(question, claim).right, (value, claim)


@pytest.mark.parametrize(
    ("words", "claim", "chosen"),
    [
        (DISC, "3142 lm/m2", "illuminance"),  # pi 1e4 0.25^2/(0.25^2 + 0.75^2)
        (DISC, "31.4klx", "exitance"),
        (DISC, "0.314sr", ""), (DISC, "3491lx", ""),  # pi 0.1, and pi 1e4 0.25^2/0.75^2
        (REFLECTED, "400 lx", "exitance"), (REFLECTED, "500lx", ""),
        ("direction 1 1 -1.4", "-0.7035", "z"),
        ("solid-angle cone --half-angle 30deg", "60deg", "apex-angle"),
        ("solid-angle cone --half-angle 30deg", "0.785sr", ""),  # pi sin(30 deg)^2
    ],
)  # fmt: skip
def test_an_answer_without_a_name_is_for_any_result_that_was_not_given(words, claim, chosen):
    found = check(asked(words), claim)
    assert found.right is bool(chosen)
    if chosen:
        assert found.name == chosen
    elif claim in ("0.314sr", "3491lx", "0.785sr"):
        (diagnosis,) = found.diagnoses
        assert diagnosis.mistake == "another-result"
        name = diagnosis.right.rpartition(": ")[2]
        assert check(asked(words, name.partition("=")[0]), name).right


@pytest.mark.parametrize("claim", ["800lm", "700lm"])
def test_an_answer_in_the_unit_of_an_input_needs_its_name(claim):
    question = asked("point-source --flux 800lm --distance 2m")
    with pytest.raises(ConditionError, match="has the unit of flux, an input"):
        check(question, claim)
    assert "wrong-unit" in [one.mistake for one in check(question, "15.9lm").diagnoses]


@pytest.mark.parametrize(
    ("words", "claim"),
    [
        ("point-source --flux 800lm --distance 2m --spectrum D65", "0.2W/m2"),
        ("convert 10 mW dBm", "4000dBm"), ("convert 10 mW dBm", "-4000dBm"),
        ("spectrum D65", "cct=0mired"), ("spectrum D65", "cct=-5mired"),
        ("ev --ev100 12", "ev=4000"), ("direction -1 -2 0", "azimuth=1e308deg"),
        ("direction -1 -2 0", "azimuth=63.43deg"),
    ],
)  # fmt: skip
def test_any_wrong_answer_has_a_verdict_that_quotes_it(words, claim):
    found = check(asked(words, claim.rpartition("=")[0]), claim)
    assert not found.right
    assert found.claimed == read_claim(claim).value


@pytest.mark.parametrize(("ev", "is_right"), [("8.6", True), ("8.65", True), ("8.7", False)])
def test_exposure_values_are_judged_alike_by_ev_and_convert(ev, is_right):
    # 1 % of the light is 0.0144 EV; lb(1000 / 2.5) is 8.6439
    for words, claim in [
        ("convert 1000 lx EV", ev), ("ev --illuminance 1000lx", f"ev100={ev}"),
        ("ev --illuminance 1000lx", f"illuminance={ev}EV"),
    ]:  # fmt: skip
        assert check(asked(words, claim.rpartition("=")[0]), claim).right is is_right


# 12 + lb(800 / 100) = 15; 0.125 cd/m2 2^12 = 512 cd/m2; a density of 0.9 is 9 dB and 0.9 / lg 2 =
# 2.98974 stops; 1 % of the light is 0.0144 EV and stops, 0.0043 OD and 0.043 dB.
CAMERA, FILTER = "ev --ev100 12 --iso 800", "ev --nd 0.9 --time 1/60s"


@for_each(
    [
        (CAMERA, "15EV", True), (CAMERA, "ev=15 EV", True), (CAMERA, "ev=15.01EV", True),
        (CAMERA, "ev=15.02EV", False), (CAMERA, "14EV", False), (CAMERA, "ev100=12EV", True),
        (CAMERA, "ev100=12EV100", True), (CAMERA, "ev=15EV100", False), (CAMERA, "12EV", True),
        (CAMERA, "luminance=12EV", True), (CAMERA, "luminance=15EV", False),
        (CAMERA, "EV=15EV", True), (CAMERA, "EV=15", True), (CAMERA, "E_v=12EV", True),
        (FILTER, "nd=0.903OD", True), (FILTER, "nd=0.905OD", False), (FILTER, "nd=9dB", True),
        (FILTER, "nd=2.99stops", True), (FILTER, "stops=3 stops", True),
        (FILTER, "stops=2.97 stops", False), (FILTER, "stops=-3stops", False),
        (FILTER, "stops=0.9OD", True), (FILTER, "nd=0.9EV", False), (FILTER, "nd=3OD", False),
        # 1e6/4000 = 250
        ("convert 4000 K mired", "250/MK", True), ("convert 4000 K MK-1", "250 mired", True),
        ("convert 250 /MK K", "240mired", False),
        # the ratio of a conversion on a scale is on all of them: 1/2 is lg 2 = 0.30103 OD
        ("convert 0.5 1 dB", "0.301OD", True), ("convert 0.5 1 OD", "-1stop", True),
        ("convert 0.5 1 stops", "3dB", False),
    ]
)  # fmt: skip
def test_a_result_that_is_a_reading_is_judged_on_its_scales(words, claim, is_right):
    assert verdict(words, claim).right is is_right
    done = run(*words.split(), "--check", claim)
    assert done.returncode == 1 - is_right, done.stderr


@for_each(
    [
        (f"{CAMERA} -g ev:EV", 15.0), (f"{CAMERA} -g ev100:EV100", 12.0),
        (f"{CAMERA} -g EV:EV", 15.0), (f"{CAMERA} -g E_v:EV", 12.0),
        (f"{FILTER} -g nd:OD", 0.9), (f"{FILTER} -g nd:dB", 9.0),
        (f"{FILTER} -g nd:stops", 0.9 / math.log10(2)), (f"{FILTER} -g stops:OD", 0.9),
        ("ev --nd 3stops --time 1/60s -g nd", 3.0), ("ev --stops 0.9OD --time 1/60s -g nd:1", 0.9),
        ("ev --ev100 12EV --iso 800 -g ev", 15.0), ("spectrum blackbody:4000K -g cct:MK-1", 250.0),
    ]
)  # fmt: skip
def test_a_result_that_is_a_reading_is_asked_for_on_its_scales(words, right):
    found = float(run(*words.split(), "-q").stdout)
    assert found == pytest.approx(right, rel=1e-6)


@for_each(
    [
        *("--nd (0.3OD)", "--nd (3stops)*1", "--stops 2*(3dB)"),
        *("--nd 3EV", "--stops 50%", "--nd -3stops"),
    ]
)  # fmt: skip
def test_a_reading_in_arithmetic_is_not_a_density(words):
    done = run("ev", *words.split(), "--time", "1s")
    assert done.returncode == 2
    assert "takes a number, not" in done.stderr or "out of range" in done.stderr


@for_each(["ev:OD", "ev:stops", "ev:EV100", "nd:EV", "stops:mag", "iso:EV", "nd:%"])
def test_another_scale_is_refused(wanted):
    words = FILTER if wanted[0] in "ns" else CAMERA
    done = run(*words.split(), "-g", wanted)
    assert done.returncode == 2
    assert done.stderr.startswith("radcalc: ")


@for_each(
    [
        # printed -20.00 +- 0.50 dBW, 21.00 +- 0.30, 12.00 +- 0.50, 200 +- 20, 5000 +- 500
        ("10+-0.5 dBm", "dBW", (-20.5, -19.5), (-20.51, -19.49)),
        ("10+-0.5 dBm", "dBm", (9.5, 10.5), (9.49, 10.51)),
        ("21+-0.3 mag/arcsec2", "mag/arcsec2", (20.7, 21.3), (20.69, 21.31)),
        ("12+-0.5 EV", "EV", (11.5, 12.5), (11.49, 12.51)),
        ("200+-20 mired", "mired", (180, 220), (179, 221)),
        ("200+-20 mired", "K", (4500, 5500), (4499, 5501)),
        # 100 lx are 100 * 0.3048^2 = 9.2903 fc, 3.04 lx 0.28243 fc: 9.29 +- 0.28
        ("100+-3.04 lx", "fc", (9.01, 9.57), (9.005, 9.575)),
    ]
)
def test_an_interval_decides_as_it_is_printed(value, target, right, wrong):
    for claim in (*right, *wrong):
        done = run("convert", value, target, f"--check={claim}")
        assert done.returncode == (claim in wrong), done.stdout
        steps = run("convert", value, target, f"--check={claim}", "--steps")
        assert steps.returncode == done.returncode, steps.stderr


@for_each(
    [
        ("luminance=12.2EV", "0.2EV", 0), ("luminance=12.3EV", "0.2EV", 1),
        ("luminance=12.3EV", "0.3 stops", 0), ("ev=15.1", "0.2EV", 0), ("ev=15.3", "0.2EV", 1),
        ("luminance=512cd/m2", "0.2EV", 2), ("luminance=12.3EV", "0.5dB", 2),
    ]
)  # fmt: skip
def test_a_tolerance_is_a_step_of_the_scale(claim, tolerance, status):
    done = run(*CAMERA.split(), "--check", claim, "--tolerance", tolerance)
    assert done.returncode == status
    assert "Traceback" not in done.stderr


@pytest.mark.parametrize("claim", ["0", "0.00", "0e309"])
def test_zero_is_not_a_rounded_answer(claim):
    found = verdict("convert 1 lx fc", claim)
    assert not found.right
    assert "rounded" not in [one.mistake for one in found.diagnoses]


def test_zeros_at_the_end_of_a_mistake_may_not_be_significant():
    """With a factor instead of a divisor pi the answer is 350 pi, 1099.6."""
    found = verdict("convert 500 lx cd/m2 --reflectance 0.7", "1100")
    assert found.diagnoses[0].mistake == "pi-upside-down"


def test_a_right_value_of_zero_has_no_ratio():
    for claim, tolerance, is_right in [
        ("azimuth=0deg", "1%", True), ("azimuth=0.1deg", "1%", False),
        ("azimuth=0.1deg", "0.2deg", True), ("azimuth=0deg", "3sf", True),
    ]:  # fmt: skip
        found = verdict("direction 1 0 0.3", claim, tolerance)
        assert found.right is is_right
        assert found.ratio is None


def test_the_plane_under_a_sky_comes_before_the_ground():
    words = "sky overcast --zenith-luminance 9000cd/m2 --tilt 90deg"
    found = verdict(words, "8712lx")  # 9000 (pi/6 + 4/9) on the wall
    assert (found.name, found.right) == ("illuminance", True)
    found = verdict(words, "21991lx")  # 9000 7 pi/9 on the ground
    assert (found.name, found.right) == ("horizontal-illuminance", True)
    assert verdict(words, "21000lx").name == "illuminance"


def test_the_mistakes_of_a_zero_result_are_compared_in_the_unit_of_the_answer():
    found = verdict("direction 1 0 0.3", "azimuth=180deg")
    assert [one.mistake for one in found.diagnoses] == ["wrong-quadrant"]
    assert verdict("direction 1 0 0.3", "azimuth=3deg").diagnoses == ()  # not pi radians


def test_an_input_is_checked_as_well():
    assert verdict(TILTED, "intensity=130cd").right
    found = verdict(TILTED, "intensity=131.9cd")
    assert not found.right


def cone_question(half_angle: str) -> Question:
    given = {"half-angle": read("half-angle", half_angle)}
    return of_task(
        Task("solid-angle", lambda changed: solid_angle("cone", changed), shape="cone"), given
    )


def test_the_library_checks_a_question():
    question = cone_question("27deg")
    omega = 2 * math.pi * (1 - math.cos(math.radians(27)))
    found = check(question, f"solid-angle={omega:.3f}sr")
    assert isinstance(found, Verdict)
    assert found.right
    assert found.name == "solid-angle"
    assert found.unit == "sr"
    assert found.value == pytest.approx(omega, rel=1e-14)
    assert found.steps == ()
    wrong = 2 * math.pi * (1 - math.cos(math.radians(54)))
    found = check(question, f"{wrong:.3f}sr", "2sf")
    assert not found.right
    assert found.ratio == pytest.approx(wrong / omega, rel=1e-3)
    assert found.diagnoses[0].mistake == "full-for-half"
    assert "half angle" in found.diagnoses[0].done


def test_the_library_checks_a_conversion():
    given = [read("reflectance", "0.7")]
    question = of_conversion(500, resolve("lx"), resolve("cd/m2"), given)
    assert check(question, "111").right
    found = check(question, "value=350cd/m2")
    assert found.value == pytest.approx(350 / math.pi, rel=1e-14)
    assert [one.mistake for one in found.diagnoses] == ["pi-forgotten"]
    assert found.steps == ()
    question = of_conversion(500, resolve("lx"), resolve("cd/m2"), given, steps=True)
    assert "pi was forgotten" in check(question, "350").steps[-1].law


CHECK_ALONE = """
import sys
from radcalc.inputs.reading import read
from radcalc.homework import check
from radcalc.homework.question import read_claim
from radcalc.homework.question import of_conversion
from radcalc.units.reading import read_amount
from radcalc.units.values import resolve_any
from radcalc.units.table import resolve

given = [read("distance", "2m"), read("incidence", "50deg")]
question = of_conversion(100, resolve("cd"), resolve("lx"), given)
print(check(question, "25lx").diagnoses[0].mistake)
print([name for name in sys.modules if name == "click" or name.startswith("radcalc.cli")])
"""


def test_the_library_checks_without_the_command_line():
    assert python(CHECK_ALONE).stdout == "cosine-forgotten\n[]\n"


def test_an_error_is_spelled_as_the_caller_writes_options():
    with pytest.raises(ConditionError) as caught:
        check(cone_question("27deg"), "0.7")
    assert str(caught.value).startswith("check 0.7 is ambiguous: it may answer several results\n")
    message, hint = caught.value.spelled(Shell)
    assert message == "--check 0.7 is ambiguous: it may answer several results"
    assert hint.startswith("--check solid-angle=0.7sr, ")


def test_the_library_raises_exceptions():
    question = cone_question("27deg")
    with pytest.raises(ConditionError, match="several results"):
        check(question, "0.7")
    with pytest.raises(NumberError):
        check(question, "x")
    with pytest.raises(ConditionError, match="unknown result 'flux'"):
        check(question, "flux=3lm")
    with pytest.raises(RadcalcError):
        check(question, "solid-angle=0.7sr", "0sf")


@pytest.mark.parametrize(
    ("value", "target", "claim", "is_right", "right", "unit"),
    [
        # lb(1000 / 2.5) = 8.6439, and half a unit of the last digit typed is more than 1 %
        ("1000 lx", "EV", "8.6", True, 8.6439, "EV"),
        ("1000 lx", "EV", "8.7", False, 8.6439, "EV"),
        ("1000 lx", "EV", "9.64", False, 8.6439, "EV"),
        # 10 lg 10 = 10; 0.05 dB are 1.2 %, and 0.04 dB are 0.9 %
        ("10 mW", "dBm", "10", True, 10.0, "dBm"),
        ("10 mW", "dBm", "10.05", False, 10.0, "dBm"),
        ("10 mW", "dBm", "10.04", True, 10.0, "dBm"),
        ("10 mW", "dBm", "10mW", True, 10.0, "mW"),
        ("10 mW", "dBm", "10lx", False, 10.0, "dBm"),
        ("10 dBm", "mW", "10dBm", True, 10.0, "dBm"),
    ],
)
def test_an_answer_on_a_scale_is_compared_as_a_quantity(
    value, target, claim, is_right, right, unit
):
    amount = read_amount(value)
    number, source = amount.typed
    judged = check(of_conversion(number, source, resolve_any(target), []), claim)
    assert (judged.right, judged.unit) == (is_right, unit)
    assert judged.value == pytest.approx(right, abs=1e-4)


def test_an_answer_in_ev_is_compared_with_the_constant_of_the_meter():
    """With K = 14 cd s/m2, 100 cd/m2 are EV lb(100 * 100 / 14) = 9.4804; with 12.5, 9.6439."""
    amount, k = read_amount("100 cd/m2"), read("k", "14cd.s/m2")
    question = of_conversion(amount.number, amount.unit, resolve_any("EV"), [k])
    assert check(question, "9.48").right
    assert check(question, "9.48").value == pytest.approx(9.4804, abs=1e-4)
    assert not check(question, "9.64").right
    metered = of_task(Task("ev", ev), {"luminance": read("luminance", "100cd/m2"), "k": k})
    assert check(metered, "luminance=9.48EV").right
    assert not check(metered, "luminance=9.64EV").right


@pytest.mark.parametrize(
    ("words", "claims"),
    [
        # t = N^2 / 2^EV: 256 / 2^15 = 1/128; 1024/2^14 = 1/16; 16 / 2^10 = 1/64
        ("ev --ev100 15 --f-number 16", ("time=1/125", "time=1/125s", "time=0.008s")),
        ("ev --ev100 14 --f-number 32", ("time=1/15",)),
        ("ev --ev100 10 --f-number 4", ("time=1/60",)),
        # N = sqrt(t 2^EV): sqrt(2^5), sqrt(2^7), sqrt(2^9)
        ("ev --ev100 12 --time 1/128s", ("f-number=5.6", "f-number=f/5.6")),
        ("ev --ev100 14 --time 1/128s", ("f-number=11", "f-number=f/11")),
        ("ev --ev100 16 --time 1/128s", ("f-number=22",)),
    ],
)
def test_numbers_as_marked_on_cameras_are_right(words, claims):
    for claim in claims:
        found = check(asked(words, claim.partition("=")[0]), claim)
        assert found.right
        assert "marked" in found.tolerance
        assert not verdict(words, claim, "0.5%").right


@pytest.mark.parametrize(
    ("words", "claim"),
    [
        ("ev --ev100 15 --f-number 16", "time=1/120"),
        ("ev --ev100 15 --f-number 16", "time=1/60"),
        ("ev --ev100 12 --time 1/128s", "f-number=5.5"),
        ("laser --flux 5mW --diameter 11.31mm", "diameter=11mm"),
    ],
)
def test_other_numbers_are_not_accepted_as_marked_on_cameras(words, claim):
    found = check(asked(words, claim.partition("=")[0]), claim)
    assert not found.right or "marked" not in found.tolerance


@pytest.mark.parametrize("claim", ["1.433degC", "1.433K", "2.580 °F", "1.433 °C"])
def test_a_temperature_rise_is_checked_as_a_difference(claim):
    # 100 W for 60 s in 1 kg of 4186 J/(kg K): 6000/4186 = 1.4333 K, 9/5 of that in degrees F
    words = "calorimeter --mass 1kg --specific-heat 4186J/kg/K --flux 100W --time 60s"
    assert verdict(words, f"temperature-rise={claim}").right
    assert verdict(words, claim).right
    assert not verdict(words, f"temperature-rise=27{claim}").right  # on its scale
