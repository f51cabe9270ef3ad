"""Mistakes in wrong answers are found; unrelated numbers get no diagnosis."""

import math
import random
from collections import Counter
from functools import cache

import pytest
from homework.corpus import CORPUS, Wrong
from homework.families import FAMILIES, ROUNDED
from homework.heldout import BLIND, HELD_OUT, THIRD
from homework.questions import CONE, LUX, POINT, RIGHT, TILTED, asked, claim_of, mistakes, verdict

from radcalc.homework import check
from radcalc.homework.diagnosis import candidates, pairs
from radcalc.homework.misread import SLIPS
from radcalc.homework.question import Problem, read_claim
from radcalc.homework.wording import USUAL


def digits_of(k: int) -> int:
    return 3 + k % 2


@cache
def diagnosed(k: int, wrong: Wrong) -> tuple[str, list[str]]:
    claim = claim_of(wrong.name, wrong.number, digits_of(k), wrong.unit)
    found = verdict(wrong.question, claim)
    assert not found.right, (wrong, claim)
    return claim, [one.mistake for one in found.diagnoses]


@pytest.mark.parametrize(
    ("wrongs", "first"),
    [
        (CORPUS, 0.98),
        (HELD_OUT, 0.95),
        (BLIND, 0.95),
        (THIRD, 0.9),
        (FAMILIES, 0.95),
        (ROUNDED, 0.95),
    ],
    ids=["corpus", "held out", "blind", "third", "families", "rounded on the way"],
)
def test_the_intended_mistake_is_named_and_mostly_first(wrongs, first):
    misses, count = [], 0
    for k, wrong in enumerate(wrongs):
        claim, found = diagnosed(k, wrong)
        intended = wrong.mistake.split("|")
        if not set(intended) & set(found):
            misses.append(f"{wrong.question} --check {claim}: {wrong.mistake}, not {found}")
        count += bool(found) and found[0] in intended
    assert not misses, "\n".join([f"{len(misses)} misses:", *misses])
    assert count >= first * len(wrongs), f"only {count} of {len(wrongs)} are first"


def test_every_diagnosis_reproduces_the_number():
    """To half a unit of its last digit."""
    for k, wrong in list(enumerate(CORPUS))[::7]:
        claim = claim_of(wrong.name, wrong.number, digits_of(k), wrong.unit)
        said = read_claim(claim)
        question = asked(wrong.question, wrong.name)
        found = check(question, claim)
        target = next(
            v
            for v in question.answer.values
            if wrong.name in ("", v.name, v.also) and v.given is None
        )
        problem = Problem(question, target)
        single = candidates(problem)
        scale = problem.right / found.value
        for one in found.diagnoses:
            near = [
                abs(c.value / scale - said.value)
                for c in (*single, *(p.together() for p in pairs(single, problem.right)))
                if c.mistake == one.mistake
            ]
            assert min(near) <= said.half_unit * (1 + 1e-9), (claim, one.mistake)


def test_every_diagnosis_has_the_mistake_and_the_right_rule():
    for k, wrong in enumerate((*CORPUS, *HELD_OUT, *BLIND, *THIRD)):
        claim = claim_of(wrong.name, wrong.number, digits_of(k), wrong.unit)
        for one in verdict(wrong.question, claim).diagnoses:
            assert one.mistake, wrong
            assert one.done, wrong
            assert one.right, wrong
            assert "{" not in one.done + one.right


MOST_WORK = 16  # full calculations in the check of one answer; most edits only need the laws


def test_a_check_needs_few_full_calculations():
    for words, name, unit in RIGHT:
        question, done = asked(words, name), []

        def count(given, question=question, done=done):
            done.append(given)
            return question.work_out(given)

        check(question._replace(work_out=count), claim_of(name, 3.456e-7, 4, unit))
        assert len(done) <= MOST_WORK, (words, len(done))


# Of any symbol.
EDITS = ("-forgotten", "-upside-down", "-not-squared", "-squared", "-wrong-power")
ALL = (*CORPUS, *HELD_OUT, *BLIND, *THIRD, *FAMILIES, *ROUNDED)


def test_every_mistake_of_the_corpora_has_a_rank_or_is_an_edit_of_a_symbol():
    both = {name for wrong in ALL for name in wrong.mistake.split("|")}
    named = {name for two in both for name in two.split(" and ")}
    assert {name for name in named if name not in USUAL and not name.endswith(EDITS)} == set()
    assert set(USUAL) <= named
    assert set(SLIPS) <= set(USUAL)


def test_every_mistake_of_the_corpus_occurs_twice_for_a_calculator():
    count = Counter((w.question.split()[0], w.mistake.partition("|")[0]) for w in CORPUS)
    for wrong in CORPUS:
        assert wrong.number != 0
        assert math.isfinite(wrong.number)
    assert {pair for pair, n in count.items() if n < 2} <= ALONE
    assert len({mistake for _, mistake in count}) >= 29


ALONE = {("photon", "avogadro")}  # only in kJ/mol


def cos(angle: float) -> float:
    return math.cos(math.radians(angle))


# Inputs with other names: a diameter for a radius, luminance for radiance, a conversion.
OTHER_NAMES = [
    ("etendue --area 2mm2 --half-angle 25deg --luminance 1e5cd/m2", "flux", "lm",
     2e-6 * 1e5 * (1 - cos(25) ** 2), "pi-forgotten"),
    ("point-source --radiant-energy 6J --time 3s", "intensity", "W/sr", 2 / (2 * math.pi),
     "wrong-sphere"),
    ("solid-angle disc --diameter 2cm --height 1.1m --offset 0.7m", "solid-angle", "sr",
     math.pi * 1e-4 / (1.1**2 + 0.7**2), "cosine-forgotten"),
    ("lambertian disc --radiance 13W/m2/sr --wavelength 610nm --radius 1cm --height 1.1m "
     "--offset 0.7m", "illuminance", "lx",
     683 * 0.503 * 13 * math.pi * 1e-4 * 1.1 / (1.1**2 + 0.7**2) ** 1.5, "cosine-forgotten"),
    ("convert 920 cd lm --beam-angle 34deg", "", "lm", 920 * 2 * math.pi * (1 - cos(17)),
     "cone-for-lobe"),
]  # fmt: skip


@pytest.mark.parametrize(("words", "name", "unit", "number", "mistake"), OTHER_NAMES)
def test_a_mistake_is_found_for_any_name_of_its_input(words, name, unit, number, mistake):
    assert mistakes(words, claim_of(name, number, 4, unit))[0] == mistake


@pytest.mark.parametrize(
    ("words", "claim"),
    [
        ("point-source --intensity 1cd --height 1e-10m --offset 1e25m", "irradiance=7lx"),
        ("convert 1 W/m2/nm W/m2/Hz --wavelength 1e-90m", "3"),
        ("lambertian disc --luminance 1cd/m2 --radius 1e-20m --height 1e20m", "irradiance=7lx"),
    ],
)
def test_extreme_inputs_have_a_verdict_without_a_diagnosis(words, claim):
    found = verdict(words, claim)
    assert not found.right
    assert found.diagnoses == ()
    assert found.ratio is None or math.isfinite(found.ratio)


def test_an_answer_of_0_has_no_diagnosis():
    assert mistakes("convert 130 cd lx --distance 2.3m --incidence 20deg", "0lx") == []


# --- Unrelated numbers.

UNRELATED, MOST_NAMED = 1500, 0.03


@cache
def right_of(words: str, name: str, unit: str) -> float:
    return verdict(words, claim_of(name, 1.0, 2, unit)).value


def unrelated() -> list[tuple[str, str, float]]:
    """Return questions, random claims and their ratios to the right values."""
    chance = random.Random(20260)
    questions = [one for one in RIGHT if one[0].split()[0] != "units"]
    found = []
    while len(found) < UNRELATED:
        words, name, unit = questions[len(found) % len(questions)]
        ratio = math.exp(chance.uniform(-math.log(30), math.log(30)))
        right = right_of(words, name, unit)
        off = right * (ratio - 1)
        if name == "azimuth":  # whole turns make no difference
            off = math.remainder(off, 360)
        if abs(off) < 0.03 * abs(right):
            continue
        found.append((words, claim_of(name, right * ratio, 3, unit), ratio))
    return found


def test_few_unrelated_numbers_get_a_diagnosis():
    """Numbers of three digits, within a factor of 30 of the right value."""
    named = []
    for words, claim, ratio in unrelated():
        found = verdict(words, claim)
        assert not found.right
        if found.diagnoses:
            ids = [one.mistake for one in found.diagnoses]
            named.append(f"{words} --check {claim} ({ratio:.4g}): {ids}")
    assert len(named) < MOST_NAMED * UNRELATED, "\n".join([f"{len(named)} named:", *named])


# --- Units.


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
def test_a_wrong_unit_is_the_only_diagnosis(words, claim, part):
    found = verdict(words, claim)
    assert not found.right
    assert [one.mistake for one in found.diagnoses] == ["wrong-unit"]
    assert part in found.diagnoses[0].done
    assert found.diagnoses[0].right.endswith(f"is in {found.unit}")


# --- Two mistakes at once.

TWO = [  # a mistake in a law and a slip: no single mistake leads to these
    # the cosine forgotten, and a tenth of the illuminance
    (TILTED, "illuminance", 130 / 2.3**2 / 10, "lx", "cosine-forgotten", "power-of-ten"),
    # the full angle, and a factor of 100
    (CONE, "solid-angle", 2 * math.pi * (1 - math.cos(math.radians(50))) * 100, "sr",
     "full-for-half", "power-of-ten"),
    ("lambertian --incident-illuminance 470lx --reflectance 0.63", "luminance",
     0.63 * 470 * 1000, "cd/m2", "pi-forgotten", "power-of-ten"),
]  # fmt: skip


@pytest.mark.parametrize(("words", "name", "number", "unit", "law", "slip"), TWO)
def test_two_mistakes_are_found_if_no_single_one_fits(words, name, number, unit, law, slip):
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


def test_every_pair_of_the_catalogue_is_a_law_and_a_slip_or_two_laws():
    question = asked(TILTED, "illuminance")
    values = question.answer.values
    target = next(v for v in values if v.also == "illuminance" or v.name == "irradiance")
    single = candidates(Problem(question, target))
    singles = {one.mistake for one in single}
    both = pairs(single, float(target.amount))
    assert both
    for one in both:
        law, _, other = one.together().mistake.partition(" and ")
        assert law in singles - set(SLIPS)
        assert other in singles - {law}
