"""An answer states the assumptions that its shown results rest on, all of them and no others."""

import shlex
from contextlib import suppress

import click
import pytest
from conftest import ROOT, run
from helpers import for_each

import radcalc
from radcalc.answer import Remark
from radcalc.calculators import SUMMARIES
from radcalc.calculators.results import pick, said_of
from radcalc.cli.command import examples_of
from radcalc.cli.lane import asked, hear
from radcalc.errors import RadcalcError
from radcalc.laws.solver import Derivation

# Options of the output, with the number of words that each takes.
OUTPUT = {"-g": 1, "--get": 1, "--format": 1, "--check": 1, "--tolerance": 1, "--precision": 1}
OUTPUT |= {"--save": 1, "--plot": 0, "--steps": 0, "-n": 0, "--json": 0, "--auto": 0, "--list": 0}
MANY = "400nm:780nm:1nm"  # values of an example
MORE = (
    "dose examples/gallery.csv",
    "environment sky:clear --sun-elevation 40deg --zenith-luminance 3000cd/m2",
    "environment '2 + cos(theta)' --toward 30deg",
    "ev --luminance 4000cd/m2 --illuminance 30klx",
    "ev --guide-number 32m --distance 4m",
    "integrate cos(theta) --hemisphere",
    "lambertian rectangle --luminance 100cd/m2 --width 1m --length 2m --height 1m --corner",
    "lambertian sphere --flux 800lm --radius 5cm --distance 1m --wavelength 555nm",
    "point-source --distribution examples/downlight.ies --height 3m --offset 1m",
    "point-source --distribution examples/downlight.ies --flux 900lm --distance 2m --spectrum D65",
    "point-source --flux 1000lm --beam-angle 30deg --height 3m --offset 1m --receiver-area 1m2",
    "point-source --flux 5W --illuminance 3lx --height 2m --spectrum LED-B3",
    "point-source --intensity 250cd --height 6m --illuminance 3lx",
    "point-source --flux 800+-20lm --distance 2m --wavelength 555+-1nm",
    "room --area 54m2 --room-index 1.8 --height 2m --luminaires 12 --flux 3600lm --utilance 0.6",
    "scene examples/office.csv --at 1,1,0.8",
    "sky clear --sun-elevation 40deg --sun-azimuth 180deg --horizontal-illuminance 12klx "
    "--sun-illuminance 80klx --tilt 90deg --azimuth 180deg --toward 60deg,90deg --spectrum D65",
    "spectrum blackbody:5772K",
    "spectrum D65 --range 500nm:600nm",
)


def without_output(words: list[str]) -> list[str]:
    """Return the words of a call without its options of the output."""
    kept, skipped = [], 0
    for word in words:
        if skipped:
            skipped -= 1
        elif word in OUTPUT:
            skipped = OUTPUT[word]
        else:
            kept.append(word)
    return kept


def calls() -> list[list[str]]:
    """Return the examples of all pages, and some calls with more assumptions."""
    found = [shlex.split(call) for call in MORE]
    for name in [*SUMMARIES][1:]:  # a conversion has one result
        found += [without_output(words) for words in examples_of(name)]
    unique = {" ".join(words): words for words in found if not {"-", MANY} & set(words)}
    return [*unique.values()]


CALLS = calls()


def heard(words: list[str]) -> tuple[list[str], set[str]]:
    """Return the names of the results of a call, and the clauses of its assumptions."""
    results = hear([*words, "--json"])  # all answers of a list
    names = dict.fromkeys(row.name for result in results for row in result.rows)
    return [*names], {
        clause for result in results for text in result.assumptions for clause in text.split("; ")
    }


@pytest.fixture(autouse=True)
def _at_the_examples(monkeypatch):
    monkeypatch.chdir(ROOT)


def answered(words: list[str]) -> bool:
    try:
        return bool(heard(words)[0])
    except (RadcalcError, click.ClickException):  # its file is missing
        return False


@for_each(CALLS)
def test_each_result_has_some_of_the_assumptions_and_all_results_have_all(words):
    if not answered(words):
        return
    names, of_all = heard(words)
    of_each = {}
    for name in names:
        with suppress(RadcalcError):  # one of several answers lacks it
            of_each[name] = heard([*words, "-g", name])[1]
    assert all(found <= of_all for found in of_each.values())
    assert set().union(*of_each.values()) == of_all


def test_every_page_has_an_answered_call():
    assert {"convert", *(words[0] for words in CALLS if answered(words))} == SUMMARIES.keys()


def behind(goal: str, used: dict) -> set[str]:
    """Return the symbols and laws of a derivation, from a symbol back to the inputs."""
    if goal not in used:
        return {goal}
    law = used[goal]
    return {goal, law.name}.union(*(behind(name, used) for name in law.names if name != goal))


@for_each(CALLS)
def test_each_law_and_value_of_a_derivation_has_its_assumptions_shown(words):
    try:
        answer = asked(words).question.answer
    except (RadcalcError, click.ClickException):  # it has several answers, or none to check
        return
    if not isinstance(answer.steps, Derivation):
        return
    used = {target: law for law, target in answer.steps.solution.used}
    for value in answer.values:
        if value.is_absent or value.name not in answer.steps.solution.values:
            continue
        shown, _ = said_of(answer, [pick(answer.values, value.name)])
        clauses = {clause for text in shown for clause in text.split("; ")}
        origins = behind(value.name, used)
        for remark in answer.assumptions:
            if not isinstance(remark, Remark) or not remark.of.isdisjoint(origins):
                assert set(remark.split("; ")) <= clauses


# A call, an input that an assumption replaces, and the assumption: the results that change with
# the input are those that show the assumption.
CONTRARY = [
    ("point-source --flux 800lm --distance 2m", "--incidence 60deg", "light arrives along"),
    ("point-source --flux 800lm --distance 2m", "--beam-angle 40deg", "isotropic"),
    ("point-source --flux 800lm --height 2m --offset 1m", "--incidence 0deg", "the receiver lies"),
    ("point-source --flux 800lm --height 2m --offset 1m", "--half-angle 40deg", "isotropic"),
    ("ev --luminance 500cd/m2 --f-number 4", "--k 14", "K = 12.5"),
    ("ev --luminance 500cd/m2 --f-number 4", "--c 330", "C = 250"),
    ("ev --luminance 500cd/m2 --f-number 4", "--iso 400", "ISO 100"),
    ("ev --guide-number 32m --distance 4m", "--iso 400", "ISO 100"),
    ("screen --flux 3000lm --diagonal 2m --aspect 16/9", "--gain 1.3", "a matt white screen"),
    ("calorimeter --mass 1kg --specific-heat 4.18kJ/kg/K --temperature-rise 1K --time 60s "
     "--receiver-area 1m2", "--absorptance 0.5", "a black body"),
    ("room --width 6m --length 9m --height 2m --luminaires 12 --flux 3600lm --utilance 0.6",
     "--maintenance 0.8", "new and clean"),
    ("sensor --luminance 100cd/m2 --f-number 4 --wavelength 555nm --pixel-pitch 5um --time 10ms "
     "--quantum-efficiency 0.5", "--magnification 1", "focused far away"),
    ("sensor --luminance 100cd/m2 --f-number 4 --wavelength 555nm --pixel-pitch 5um --time 10ms "
     "--quantum-efficiency 0.5", "--transmittance 0.9", "a lens without losses"),
    ("laser --flux 5mW --diameter 1mm --divergence 1mrad --distance 10m --limit 1W/m2",
     "--profile uniform", "a Gaussian beam"),
    ("lambertian disc --luminance 100cd/m2 --radius 25cm --height 75cm", "--incidence 30deg",
     "the receiver faces the source's plane"),
    ("lambertian sphere --luminance 100cd/m2 --radius 25cm --distance 75cm", "--incidence 30deg",
     "the receiver faces the source"),
    ("sky clear --sun-elevation 40deg --sun-azimuth 180deg --horizontal-illuminance 12klx "
     "--sun-illuminance 80klx --tilt 90deg --azimuth 180deg", "--sun-radius 0.3deg",
     "the sun's disc has a radius"),
    ("uberlight 0,0,3 --intensity 100cd", "--incidence 60deg", "the receiver faces"),
    ("sensor --luminance 100cd/m2 --f-number 4 --spectrum D65 --pixel-pitch 5um --time 10ms "
     "--quantum-efficiency 0.5", "--photon-range 400nm:700nm", "photons counted over"),
    ("spectrum D65", "--photon-range 400nm:750nm", "photons counted over"),
]  # fmt: skip


def numbers(call: str) -> dict[str, float]:
    return {row.name: row.value for result in hear(shlex.split(call)) for row in result.rows}


@for_each(CONTRARY)
def test_results_that_an_assumption_changes_show_it(call, contrary, assumption):
    before, after = numbers(call), numbers(f"{call} {contrary}")
    changed = {
        name
        for name, number in before.items()
        if name in after and after[name] != pytest.approx(number, rel=1e-9)
    }
    assert changed
    shown = {
        name
        for name in before
        if any(text.startswith(assumption) for text in heard([*shlex.split(call), "-g", name])[1])
    }
    assert changed <= shown
    assert len(shown) < len(before)


AXIAL = "point-source --intensity 800cd --distance 2m"
GATES = [  # a call for the illuminance alone, and its standard input
    (f"{AXIAL} -g illuminance", ""),
    (f"{AXIAL} -g illuminance --json", ""),
    (f"{AXIAL} -g illuminance --format csv", ""),
    (f"{AXIAL} -g illuminance --format table", ""),
    (f"{AXIAL} --check illuminance=200lx", ""),
    (f"{AXIAL} --check illuminance=200lx --json", ""),
    ("point-source --intensity 800cd --distance 1m,2m -g illuminance", ""),
    ("point-source --intensity 800cd --distance '- m' -g illuminance", "2\n"),
    ("point-source --intensity 800cd --distance '- m' -g illuminance --json", "2\n"),
    ("800 cd at 2 m to lx", ""),
]


@for_each(GATES)
def test_every_format_shows_only_what_the_result_rests_on(call, lines):
    done = run(*shlex.split(call), input=lines, together=True)
    assert "light arrives along the receiver's normal" in done.stdout
    assert "isotropic" not in done.stdout
    assert "isotropic" in run(*shlex.split(AXIAL), together=True).stdout


def test_a_marked_sheet_shows_only_what_its_questions_rest_on(tmp_path):
    sheet = tmp_path / "sheet.csv"
    sheet.write_text(f"command,answer\n{AXIAL} -g illuminance:lx,200\n", encoding="utf-8")
    done = run("mark", str(sheet))
    assert "light arrives along" in done.stderr
    assert "isotropic" not in done.stderr


def test_a_python_function_states_the_assumptions_of_all_its_results():
    assumptions = radcalc.point_source(intensity="800 cd", distance="2 m").assumptions
    assert [text.split(":")[0] for text in assumptions] == [
        "isotropic", "light arrives along the receiver's normal"
    ]  # fmt: skip


def test_the_table_of_the_eye_is_part_of_the_derivation():
    for call in ("convert 1 lm W --wavelength 555nm", "photon 555nm", "spectrum D65"):
        assert "Km 683.002" not in run(*call.split(), together=True).stdout
        assert "Km 683.002" in run(*call.split(), "--steps", together=True).stdout


def test_ranges_of_other_kinds_of_light_are_not_stated():
    call = "point-source --flux 800lm --distance 2m --spectrum LED-B3 -g"
    ranges = {"W/m2": "watts counted over 380-780 nm", "umol/m2/s": "photons counted over"}
    for unit in ("lx", *ranges):
        stated = run(*call.split(), f"irradiance:{unit}").stderr
        assert [other for other, text in ranges.items() if text in stated] == [unit] * (
            unit in ranges
        )
