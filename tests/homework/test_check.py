"""--check: right answers are accepted, wrong ones named, and unrelated ones left alone."""

import contextlib
import io
import json
import math
import random
from collections import Counter
from functools import cache
from typing import Any

import pytest
from conftest import run
from homework.corpus import CORPUS, Wrong

import radcalc.homework
from radcalc import cli
from radcalc.calculators.solid_angle import solid_angle
from radcalc.conversion.conditions import give
from radcalc.errors import ConditionError, NumberError, RadcalcError
from radcalc.homework import Question, Verdict, check
from radcalc.homework.answer import read_claim, read_tolerance
from radcalc.homework.catalogue import SLIPS, Problem, candidates, pairs
from radcalc.units.table import resolve

LUX = "convert 500 lx cd/m2 --reflectance 0.7"  # 350/pi = 111.408
POINT = "point-source --intensity 130cd --distance 2.3m"  # 24.5747 lx
CONE = "solid-angle cone --half-angle 25deg"  # 0.588686 sr
TILTED = f"{POINT} --incidence 35deg"  # 20.1304 lx


@cache
def asked(words: str, name: str = "") -> Question:
    """What the command line asks `check`, of a question in words."""
    found: list[Question] = []

    def catch(question: Question, *_: Any) -> Verdict:
        found.append(question)
        raise ConditionError("caught", "")

    with pytest.MonkeyPatch.context() as patch, contextlib.redirect_stderr(io.StringIO()):
        patch.setattr(radcalc.homework, "check", catch)
        assert cli.run([*words.split(), "--check", f"{name}=1" if name else "1"]) == 2
    assert found, words
    return found[0]


def verdict(words: str, claim: str, tolerance: str = "1%") -> Verdict:
    name = claim.partition("=")[0] if "=" in claim else ""
    return check(asked(words, name), claim, tolerance)


def mistakes(words: str, claim: str) -> list[str]:
    return [one.mistake for one in verdict(words, claim).diagnoses]


def typed(number: float, digits: int) -> str:
    """A number as it is typed with so many digits, the last zeros too."""
    text = f"{number:.{digits - 1}e}"
    power = int(text.partition("e")[2])
    return text if not -3 <= power < digits else f"{float(text):.{digits - 1 - power}f}"


def claim_of(name: str, number: float, digits: int, unit: str) -> str:
    return f"{name}={typed(number, digits)}{unit}" if name else f"{typed(number, digits)}{unit}"


class Said:
    """What a command wrote, and its exit status."""

    def __init__(self, capsys: Any, *words: str) -> None:
        capsys.readouterr()
        self.status = cli.run(list(words))
        self.out, self.err = capsys.readouterr()


@pytest.fixture
def said(capsys):
    """Run a command in this process: its words, and others that are not split."""
    return lambda words, *others: Said(capsys, *words.split(), *others)


# --- 1. The corpus.


def digits_of(k: int) -> int:
    return 3 + k % 2


@cache
def diagnosed(k: int, wrong: Wrong) -> tuple[str, list[str]]:
    claim = claim_of(wrong.name, wrong.number, digits_of(k), wrong.unit)
    found = verdict(wrong.question, claim)
    assert not found.is_right, (wrong, claim)
    return claim, [one.mistake for one in found.diagnoses]


def test_typed_numbers_keep_their_digits():
    for number in (0.0012345, 0.12, 1.0, 12.34, 999.96, 1234.5, 1e4, 6.02e23, 3.3e-19):
        for digits in (2, 3, 4):
            said = read_claim(typed(number, digits))
            assert said.digits == digits, typed(number, digits)
            assert abs(said.value - number) <= said.half_unit * (1 + 1e-9)


def test_the_intended_mistake_is_first_or_tied_in_95_percent():
    misses = []
    first = 0
    for k, wrong in enumerate(CORPUS):
        claim, found = diagnosed(k, wrong)
        intended = wrong.mistake.split("|")
        # every diagnosis of the list reproduces the number to half a unit of its last digit
        if not set(intended) & set(found):
            misses.append(f"{wrong.question} --check {claim}: {wrong.mistake}, not {found}")
        first += bool(found) and found[0] in intended
    assert len(misses) <= 0.05 * len(CORPUS), "\n".join([f"{len(misses)} misses:", *misses])
    assert first >= 0.9 * len(CORPUS), f"only {first} of {len(CORPUS)} are first"


def test_what_ties_reproduces_the_number_as_well():
    for k, wrong in list(enumerate(CORPUS))[::7]:
        claim = claim_of(wrong.name, wrong.number, digits_of(k), wrong.unit)
        said = read_claim(claim)
        question = asked(wrong.question, wrong.name)
        found = check(question, claim)
        target = next(
            v for v in question.values if wrong.name in ("", v.name, v.also) and v.given is None
        )
        problem = Problem(
            question.given, question.values, question.work_out, question.facts, target
        )
        scale = problem.right / found.right
        for one in found.diagnoses:
            near = [
                abs(c.value / scale - said.value)
                for c in (*candidates(problem), *pairs(problem))
                if c.mistake == one.mistake
            ]
            assert min(near) <= said.half_unit * (1 + 1e-9), (claim, one.mistake)


def test_every_mistake_of_the_corpus_is_there_twice_for_a_calculator():
    count = Counter((w.question.split()[0], w.mistake.partition("|")[0]) for w in CORPUS)
    for wrong in CORPUS:
        assert wrong.number != 0
        assert math.isfinite(wrong.number)
    assert {pair for pair, n in count.items() if n < 2} <= ALONE
    assert len({mistake for _, mistake in count}) >= 29


ALONE = {("photon", "avogadro")}  # of the kJ/mol alone


# --- 2. Right answers.

RIGHT = [  # the question, the result, its unit
    (LUX, "", "cd/m2"), ("convert 5.3 mW lm --wavelength 610nm", "", "lm"),
    ("convert 870 lm lx --isotropic --distance 2.3m", "", "lx"), ("convert 470 lx fc", "", "fc"),
    ("convert 41 W/m2 umol/m2/s --wavelength 660nm", "", "umol/m2/s"), (CONE, "solid-angle", "sr"),
    ("solid-angle sphere --radius 4cm --distance 11cm", "half-angle", "deg"),
    ("solid-angle zone --polar 20deg:50deg", "solid-angle", "deg2"),
    ("solid-angle pyramid --horizontal 42deg --vertical 26deg", "projected-solid-angle", "sr"),
    ("solid-angle patch --area 3cm2 --distance 1.3m --tilt 40deg", "solid-angle", "sr"),
    ("direction -3 4.6 5", "azimuth", "deg"), ("direction -3 4.6 5", "length", ""),
    ("direction --polar 35deg --azimuth 130deg", "x", ""), (TILTED, "illuminance", "lx"),
    ("etendue --area 2mm2 --half-angle 25deg", "etendue", "mm2.sr"),
    ("etendue --radius 3mm --receiver-radius 5mm --distance 13mm", "etendue", "m2.sr"),
    ("etendue --area 2mm2 --half-angle 25deg --radiance 1e5cd/m2", "flux", "lm"),
    (POINT, "flux", "lm"), (POINT, "luminous-flux", "klm"), (POINT, "irradiance", "fc"),
    ("point-source --intensity 85cd --illuminance 34lx", "distance", "ft"),
    ("point-source --flux 5.3mW --distance 1.3m --wavelength 610nm", "illuminance", "lx"),
    ("lambertian --luminance 130cd/m2", "exitance", "lm/m2"),
    ("lambertian disc --luminance 2900cd/m2 --radius 31cm --distance 45cm", "illuminance", "lx"),
    ("lambertian --incident-illuminance 470lx --reflectance 0.63", "luminance", "nit"),
    ("ev --f-number 5.6 --time 1/60s", "ev", ""), ("ev --ev100 9.3", "illuminance", "lx"),
    ("ev --illuminance 470lx --f-number 3.4", "time", "ms"),
    ("calorimeter --flux 1.7W --mass 40g --specific-heat 385J/kg/K --time 3min",
     "temperature-rise", "K"),
    ("integrate cos(theta) --half-angle 48deg", "integral", "sr"),
    ("photon 610nm", "photon-energy", "eV"), ("photon 610nm", "frequency", "THz"),
    ("photon 610nm", "luminous-efficacy", "lm/W"), ("spectrum A", "luminous-efficacy", "lm/W"),
    ("spectrum blackbody:2900K", "radiance", "W/m2/sr"), ("spectrum A", "photon-energy", "eV"),
    ("mesopic --luminance 0.1cd/m2 --sp-ratio 2", "mesopic-luminance", "cd/m2"),
    ("mesopic --luminance 0.3cd/m2 --spectrum A", "sp-ratio", ""),
]  # fmt: skip


def right_value(words: str, name: str, unit: str) -> float:
    """The right value by the command's own answer, not by --check."""
    if not name:
        return float(run(*words.split(), "-n", "-q").stdout)
    return float(run(*words.split(), "-q", "-g", f"{name}:{unit or '1'}").stdout)


def test_every_command_has_a_right_answer_here():
    judging = set(cli.COMMANDS) - {"units", "quantities", "typical"}
    assert {words.split()[0] for words, _, _ in RIGHT} == judging
    assert len(RIGHT) >= 30


@pytest.mark.parametrize(("words", "name", "unit"), RIGHT, ids=lambda x: str(x)[:40])
def test_right_answers_are_accepted_at_their_digits(words, name, unit):
    value = right_value(words, name, unit)
    for digits in (2, 3, 4):
        claim = claim_of(name, value, digits, unit)
        found = verdict(words, claim, f"{digits}sf")
        assert found.is_right, claim
        assert found.right == pytest.approx(value, rel=1e-11)
        assert found.diagnoses == ()
        assert found.ratio == pytest.approx(float(typed(value, digits)) / value, rel=1e-9)
        if digits > 2:
            assert verdict(words, claim).is_right, claim
    assert not verdict(words, claim_of(name, value * 1.03, 4, unit)).is_right


@pytest.mark.parametrize(
    ("claim", "tolerance", "is_right"),
    [
        # 130 cd at 2 m: 32.5 lx exactly
        ("32.825lx", "1%", True), ("32.826lx", "1%", False), ("32.175lx", "1%", True),
        ("32.174lx", "1%", False), ("33lx", "0.02", True), ("33.2lx", "0.02", False),
        ("32.5lx", "0", True), ("32.500001lx", "0%", False), ("65lx", "100%", True),
        ("0lx", "100%", True), ("-1lx", "100%", False),
        ("33lx", "0.5lx", True), ("32lx", "0.5lx", True), ("33.01lx", "0.5lx", False),
        ("31.99lx", "0.5lx", False), ("33lx", "500mlx", True), ("33.1lx", "500mlx", False),
        ("33lx", "0.0005klx", True), ("32.6lx", "0.01fc", True), ("32.7lx", "0.01fc", False),
        ("3.02fc", "0.5lx", True), ("3.07fc", "0.5lx", False),
        ("33lx", "2sf", True), ("32lx", "2sf", True), ("33.1lx", "2sf", False),
        ("32.55lx", "3sf", True), ("32.56lx", "3sf", False), ("32.45lx", "3SF", True),
        ("32.44lx", "3sf", False), ("37lx", "1sf", True), ("37.6lx", "1sf", False),
        ("32.5lx", "15sf", True), ("32.5000001lx", "15sf", False), ("0.0325klx", "3sf", True),
    ],
)  # fmt: skip
def test_the_bounds_of_the_three_kinds_of_tolerance(claim, tolerance, is_right):
    words = "convert 130 cd lx --distance 2m"
    assert verdict(words, claim, tolerance).is_right is is_right


def test_a_right_value_of_zero_has_no_ratio():
    for claim, tolerance, is_right in [
        ("azimuth=0deg", "1%", True), ("azimuth=0.1deg", "1%", False),
        ("azimuth=0.1deg", "0.2deg", True), ("azimuth=0deg", "3sf", True),
    ]:  # fmt: skip
        found = verdict("direction 1 0 0.3", claim, tolerance)
        assert found.is_right is is_right
        assert found.ratio is None


# --- 3. Unrelated numbers.

UNRELATED, MOST_NAMED = 200, 0.1


@cache
def right_of(words: str, name: str, unit: str) -> float:
    return verdict(words, claim_of(name, 1.0, 2, unit)).right


def unrelated() -> list[tuple[str, str, float]]:
    """Questions, claims and their ratios, by chance."""
    chance = random.Random(20260)
    questions = [one for one in RIGHT if one[0].split()[0] != "units"]
    found = []
    while len(found) < UNRELATED:
        words, name, unit = questions[len(found) % len(questions)]
        ratio = math.exp(chance.uniform(-math.log(30), math.log(30)))
        if abs(ratio - 1) < 0.03:
            continue
        found.append((words, claim_of(name, right_of(words, name, unit) * ratio, 3, unit), ratio))
    return found


def test_few_unrelated_numbers_are_given_a_mistake():
    named = []
    for words, claim, ratio in unrelated():
        found = verdict(words, claim)
        assert not found.is_right
        if found.diagnoses:
            ids = [one.mistake for one in found.diagnoses]
            named.append(f"{words} --check {claim} ({ratio:.4g}): {ids}")
    assert len(named) < MOST_NAMED * UNRELATED, "\n".join([f"{len(named)} named:", *named])


# --- 4. Units, claims, refusals, formats.


@pytest.mark.parametrize(
    ("words", "claim", "part"),
    [
        (POINT, "illuminance=24.6nit", "luminance (nit) is not illuminance; the number would be"),
        (POINT, "illuminance=24.6cd", "luminous intensity (cd) is not illuminance"),
        (POINT, "illuminance=130nit", "check both"),
        (f"{POINT} --wavelength 555nm", "luminous-flux=5lx", "illuminance (lx) is not luminous"),
        ("convert 130 cd/m2 lx --half-angle 25deg", "72.9nit", "luminance (nit) is not illumin"),
        ("convert 870 lm cd --isotropic", "69.2lm/m2", "is not luminous intensity"),
        (LUX, "111lx", "illuminance (lx) is not luminance; the number would be right"),
        (LUX, "350lx", "illuminance (lx) is not luminance; check both"),
        (CONE, "solid-angle=0.589deg", "angle (deg) is not solid angle; the number would be"),
        ("direction 1 2 3", "azimuth=63.4sr", "solid angle (sr) is not azimuth"),
        ("lambertian --luminance 130cd/m2", "exitance=408cd", "is not luminous exitance"),
        ("ev --ev100 9.3", "illuminance=1580cd/m2", "luminance (cd/m2) is not illuminance"),
        ("etendue --area 2mm2 --half-angle 25deg", "etendue=1.12mm2", "area (mm2) is not etendue"),
    ],
)
def test_a_wrong_unit_comes_before_the_number(words, claim, part):
    found = verdict(words, claim)
    assert not found.is_right
    assert [one.mistake for one in found.diagnoses] == ["wrong-unit"]
    assert part in found.diagnoses[0].done
    assert found.diagnoses[0].right.endswith(f"is in {found.unit}")


@pytest.mark.parametrize(
    ("words", "claim"),
    [
        (LUX, "111"), (LUX, "111nit"), (LUX, "value=111"), (LUX, "value = 111 cd/m2"),
        (LUX, "350/pi"), (LUX, "1.11e2"), (LUX, "32.5fL"), (LUX, "0.0111cd/cm2"), (POINT, "24.6lx"),
        (POINT, "illuminance=24.6"), (POINT, "irradiance=24.6lx"), (POINT, "2.28fc"),
        (POINT, "flux=1630"), (POINT, "1.63klm"), (CONE, "1933deg2"),
        ("direction 1 1 -1.4", "z=\u22120.7035"), ("direction 1 1 -1.4", "z=-0.7035"),
        ("ev --f-number 5.6 --time 1/60s", "ev=10.88"),
        ("photon 610nm", "2.033eV"), ("photon 610nm", "491THz"),
        ("integrate 1 --half-angle 25deg", "integral=0.589"), (CONE, "sphere-fraction=0.0468"),
        ("ev --f-number 5.6 --time 1/60s", "illuminance=4704lx"),
    ],
)  # fmt: skip
def test_a_claim_needs_no_more_than_tells_it_apart(words, claim):
    assert verdict(words, claim).is_right


@pytest.mark.parametrize(
    ("words", "claim"), [(POINT, "24.6"), (CONE, "0.589"), ("direction 1 2 3", "0.8")]
)
def test_an_ambiguous_claim_is_refused_with_what_would_do(said, words, claim):
    found = said(words, "--check", claim)
    assert found.status == 2
    assert found.out == ""
    assert "say which result is meant" in found.err
    assert f"={claim}" in found.err


BAD_CLAIMS = ["", " ", "lx", "=", "=lx", "nan", "nanlx", "inf", "-inf", "1e400", "1..2lx",
              "24.6furlongs", "nothing=24.6lx", "illuminance=", "illuminance=lx", "1/0", "--",
              "illuminance=1=2"]  # fmt: skip


@pytest.mark.parametrize("claim", BAD_CLAIMS)
def test_bad_claims_are_refused(said, claim):
    found = said(POINT, f"--check={claim}")
    assert found.status == 2, found.err
    assert found.out == ""
    assert found.err.startswith("radcalc: ")
    assert "\ntry: " in found.err


BAD_TOLERANCES = ["", " ", "sf", "0sf", "16sf", "99sf", "-1sf", "1.5sf", "nan", "nan%", "inf",
                  "-1%", "-0.5lx", "0.5cd", "1deg", "x", "%", "1%%", "3sflx", "²sf"]  # fmt: skip


@pytest.mark.parametrize("tolerance", BAD_TOLERANCES)
def test_bad_tolerances_are_refused(said, tolerance):
    found = said(POINT, "--check", "illuminance=24.6lx", f"--tolerance={tolerance}")
    assert found.status == 2, (found.out, found.err)
    assert found.out == ""
    assert found.err.startswith("radcalc: ")
    assert "\ntry: " in found.err


@pytest.mark.parametrize(
    ("words", "part"),
    [
        (f"{CONE} --tolerance 3sf", "--tolerance has no use without --check"),
        (f"{LUX} --tolerance 3sf", "--tolerance has no use without --check"),
        (f"{CONE} --check 0.6sr -g solid-angle", "--check and --get contradict each other"),
        (f"{CONE},26deg --check 0.6sr", "--check takes one answer"),
        ("convert 100 cd lx --distance 1m,2m --check 25lx", "--check takes one answer"),
        ("point-source --intensity 9cd --distance 1m:3m:1m --check 1lx", "--check takes one"),
        ("spectrum blackbody:3000K,4000K --check x=0.4", "--check takes one answer"),
        ("photon 400nm,500nm --check 2eV", "--check takes one answer"),
        ("ev --ev100 1:400:1 --check 25lx", "--check takes one answer"),
        ("mesopic --luminance 0.1cd/m2,1cd/m2 --sp-ratio 2 --check 1cd/m2", "--check takes one"),
        ("convert 130 cd/m2 --check 5", "--check needs a unit to convert to"),
        ("convert 130 cd lx --check 5lx", "a distance is missing"),
    ],
)
def test_what_goes_not_with_check(said, words, part):
    found = said(words)
    assert found.status == 2, found.out
    assert found.out == ""
    assert part in found.err


@pytest.mark.parametrize("words", [f"{LUX} --check 111", f"{CONE} --check 0.589sr"])
@pytest.mark.parametrize("option", ["-n", "--format csv", "--json -n", "--format csv -n"])
def test_bare_numbers_and_csv_are_refused(said, words, option):
    found = said(f"{words} {option}")
    assert found.status == 2
    assert found.out == ""
    assert found.err.startswith("radcalc: ")


def test_exit_statuses_of_the_installed_command():
    assert run(*LUX.split(), "--check", "111").returncode == 0
    assert run(*LUX.split(), "--check", "350").returncode == 1
    assert run(*LUX.split(), "--check", "").returncode == 2
    assert run(*CONE.split(), "--check", "0.589sr").returncode == 0
    assert run(*CONE.split(), "--check", "2.24sr").returncode == 1


@pytest.mark.parametrize(
    ("words", "claim", "is_right", "first"),
    [
        (LUX, "111", True, None),
        (LUX, "350", False, "pi-forgotten"),
        (LUX, "350lx", False, "wrong-unit"),
        (CONE, "solid-angle=2.24sr", False, "full-for-half"),
        (TILTED, "illuminance=24.6lx", False, "cosine-forgotten"),
        (TILTED, "illuminance=7.77lx", False, None),
        ("direction 1 0 0.3", "azimuth=7deg", False, None),
    ],
)
def test_json_says_right_ratio_and_diagnoses(said, words, claim, is_right, first):
    found = said(words, "--check", claim, "--json")
    assert found.status == (0 if is_right else 1)
    assert found.err == ""
    one = json.loads(found.out)
    assert one["right"] is is_right
    assert {"right", "name", "unit", "value", "claimed", "ratio", "tolerance", "diagnoses",
            "assumptions", "notes", "steps"} <= set(one)  # fmt: skip
    assert one["steps"] == []
    assert one["claimed"] == read_claim(claim).value
    if first == "wrong-unit":
        assert one["ratio"] is None  # of two quantities there is none
    elif one["value"]:
        assert one["ratio"] == pytest.approx(one["claimed"] / one["value"], rel=1e-12)
    else:
        assert one["ratio"] is None
    for diagnosis in one["diagnoses"]:
        assert set(diagnosis) >= {"mistake", "done", "right"}
        assert all(diagnosis[key] for key in ("mistake", "done", "right"))
    assert (one["diagnoses"][0]["mistake"] if one["diagnoses"] else None) == first
    assert found.out == json.dumps(one, ensure_ascii=False) + "\n"


def test_words_say_right_or_wrong_and_what_would_be_right(said):
    found = said(LUX, "--check", "111")
    assert found.out.startswith("right (within 1%): ")
    assert "111.408" in found.out
    found = said(LUX, "--check", "350", "--tolerance", "3sf")
    lines = found.out.splitlines()
    assert lines[0].startswith("wrong (within half a unit of digit 3): ")
    assert "111.408" in lines[0]
    assert "350" in lines[0]
    assert "3.142 times" in lines[0]
    assert "pi was forgotten" in found.out
    assert "L = rho E / pi" in found.out
    found = said(LUX, "--check", "777")
    assert found.status == 1
    assert found.out.splitlines()[1] == "no usual mistake gives that number"
    assert "6.974 times" in found.out


def test_quiet_says_no_assumptions(said):
    assert "assumed: a Lambertian reflector" in said(LUX, "--check", "350").err
    found = said(LUX, "--check", "350", "-q")
    assert found.err == ""
    assert found.status == 1
    assert "pi was forgotten" in found.out


def test_steps_show_the_derivation(said):
    for words, claim in ((TILTED, "illuminance=24.6lx"), (LUX, "350"), (LUX, "111")):
        plain, steps = said(words, "--check", claim), said(words, "--check", claim, "--steps")
        assert steps.status == plain.status
        assert steps.out == plain.out
        assert len(steps.err) > len(plain.err)
        one = json.loads(said(words, "--check", claim, "--steps", "--json").out)
        assert one["steps"]
        assert set(one["steps"][0]) == {"law", "formula", "numbers", "reference"}
    assert "cos(" in said(TILTED, "--check", "24.6lx", "--steps", "-q").err


def test_tables_and_precision(said):
    assert "is 111.408 cd/m2" in said(LUX, "--check", "111", "--format", "table").out
    assert "is 111.4 cd/m2" in said(LUX, "--check", "111", "--precision", "4").out


def test_a_name_of_an_input_is_checked_as_well():
    assert verdict(TILTED, "intensity=130cd").is_right
    found = verdict(TILTED, "intensity=131.9cd")
    assert not found.is_right


# --- 5. Two mistakes at once.

TWO = [  # a mistake of the law with a slip, which no single mistake explains
    # the cosine left out, and the illuminance a tenth
    (TILTED, "illuminance", 130 / 2.3**2 / 10, "lx", "cosine-forgotten", "power-of-ten"),
    # the full angle, and m for nothing
    (CONE, "solid-angle", 2 * math.pi * (1 - math.cos(math.radians(50))) * 100, "sr",
     "full-for-half", "power-of-ten"),
    ("lambertian --incident-illuminance 470lx --reflectance 0.63", "luminance",
     0.63 * 470 * 1000, "cd/m2", "pi-forgotten", "power-of-ten"),
]  # fmt: skip


@pytest.mark.parametrize(("words", "name", "number", "unit", "law", "slip"), TWO)
def test_two_mistakes_are_named_where_no_single_one_fits(words, name, number, unit, law, slip):
    for digits in (3, 4):
        found = mistakes(words, claim_of(name, number, digits, unit))
        assert f"{law} and {slip}" in found
        assert all(" and " in one for one in found)


@pytest.mark.parametrize(("words", "name", "number", "unit", "law", "slip"), TWO)
def test_two_digits_are_too_few_for_two_mistakes(words, name, number, unit, law, slip):
    assert not [m for m in mistakes(words, claim_of(name, number, 2, unit)) if " and " in m]


def test_a_single_mistake_hides_every_pair():
    for k, wrong in enumerate(CORPUS):
        found = diagnosed(k, wrong)[1]
        assert len({" and " in one for one in found}) <= 1, (wrong, found)
        assert len(found) == len(set(found)) <= 5
        for one in found:
            law, _, slip = one.partition(" and ")
            assert not slip or (slip in SLIPS and law not in SLIPS), one


def test_every_pair_of_the_catalogue_is_a_law_and_a_slip():
    question = asked(TILTED, "illuminance")
    target = next(v for v in question.values if v.also == "illuminance" or v.name == "irradiance")
    problem = Problem(question.given, question.values, question.work_out, question.facts, target)
    singles = {one.mistake for one in candidates(problem)}
    both = pairs(problem)
    assert both
    for one in both:
        law, _, slip = one.mistake.partition(" and ")
        assert law in singles
        assert slip in singles & set(SLIPS)


# --- 6. The library.


def cone_question(half_angle: str) -> Question:
    given = {"half-angle": give("half-angle", half_angle)}

    def work_out(changed):
        return solid_angle("cone", changed, {})[0]

    return Question(work_out(given), given, work_out, {"command": "solid-angle", "shape": "cone"})


def test_the_library_checks_a_question():
    question = cone_question("27deg")
    omega = 2 * math.pi * (1 - math.cos(math.radians(27)))
    found = check(question, f"solid-angle={omega:.3f}sr")
    assert isinstance(found, Verdict)
    assert found.is_right
    assert found.name == "solid-angle"
    assert found.unit == "sr"
    assert found.right == pytest.approx(omega, rel=1e-14)
    assert found.steps == ()
    wrong = 2 * math.pi * (1 - math.cos(math.radians(54)))
    found = check(question, f"{wrong:.3f}sr", "2sf")
    assert not found.is_right
    assert found.ratio == pytest.approx(wrong / omega, rel=1e-3)
    assert found.diagnoses[0].mistake == "full-for-half"
    assert "half angle" in found.diagnoses[0].done


def test_the_library_refuses_by_exceptions():
    question = cone_question("27deg")
    with pytest.raises(ConditionError, match="which result"):
        check(question, "0.7")
    with pytest.raises(NumberError):
        check(question, "x")
    with pytest.raises(ConditionError, match="no result 'flux'"):
        check(question, "flux=3lm")
    with pytest.raises(RadcalcError):
        check(question, "solid-angle=0.7sr", "0sf")


@pytest.mark.parametrize(
    ("text", "digits", "half"),
    [
        ("25lx", 2, 0.5), ("25.0lx", 3, 0.05), ("0.0250lx", 3, 0.00005), ("2.50e3lx", 3, 5.0),
        ("2.5e-3", 2, 5e-5), ("100", 3, 0.5), ("007", 1, 0.5), ("0", 1, 0.5), ("-3.14", 3, 0.005),
        ("\u22123.14", 3, 0.005), ("E=1.5e+2lx", 2, 5.0), ("1E3", 1, 500.0),
    ],
)  # fmt: skip
def test_the_digits_typed(text, digits, half):
    said = read_claim(text)
    assert said.digits == digits
    assert said.half_unit == pytest.approx(half, rel=1e-12)


def test_formulas_are_typed_exactly():
    assert read_claim("pi/6sr").digits == 15
    assert read_claim("2pi sr").value == pytest.approx(2 * math.pi)
    assert read_claim("1/3").half_unit < 1e-9


def test_tolerances_read():
    lux = resolve("lx")
    assert read_tolerance("1%", lux).kind == "relative"
    assert read_tolerance("0.01", lux).size == pytest.approx(0.01)
    assert read_tolerance("0.5lx", lux)[1:] == ("absolute", 0.5)
    assert read_tolerance("1fc", lux).size == pytest.approx(10.7639104)
    assert read_tolerance(" 3SF ", lux)[1:] == ("digits", 3)
    assert not read_tolerance("3sf", lux).holds(0.1, 0.0)
    assert read_tolerance("3sf", lux).holds(-1.004, -1.0)
