"""Several answers under common conditions: each equals a single one with those it uses."""

import json
from itertools import permutations
from math import cos, pi, radians

import pytest
from conftest import run

from radcalc.units.compiled import UNITS
from radcalc.units.table import resolve
from radcalc.units.values import find_scale


def answers(words):
    """Return the objects of a call, as a list if it has one answer."""
    told = run(*words.split(), "--json")
    assert told.returncode == 0, told.stderr
    found = json.loads(told.stdout)
    return found if isinstance(found, list) else [found]


def values(words):
    return [row["value"] for one in answers(words) for row in results(one)]


def results(one):
    each = one["results"].values()
    return [row for found in each for row in (found if isinstance(found, list) else [found])]


# value, targets with the conditions that each needs
CALLS = {
    "100 lx": {
        "fc": "",
        "cd": "--distance 2m",
        "lm": "--area 3m2",
        "lx.s": "--time 5s",
        "W/m2": "--efficacy 200lm/W",
        "cd/m2": "--reflectance 0.8",
    },
    "800 lm": {
        "cd": "--isotropic",
        "klm": "",
        "lx": "--isotropic --distance 2m",
        "lm.s": "--time 5s",
    },
    "1 klx": {
        "W/m2": "--spectrum AM1.5G --range 400nm:700nm",
        "umol/m2/s": "--spectrum AM1.5G",
        "klx": "",
    },
}


@pytest.mark.parametrize("value", CALLS)
def test_each_target_has_the_answer_of_a_single_call(value):
    needs = CALLS[value]
    for targets in permutations(needs, 2):
        given = {text.strip() for one in targets for text in needs[one].split("--")} - {""}
        conditions = " ".join(f"--{text}" for text in sorted(given))
        alone = [number for one in targets for number in values(f"{value} {one} {needs[one]}")]
        assert values(f"{value} {','.join(targets)} {conditions}") == alone


def test_each_target_uses_the_conditions_that_apply_to_it():
    # 1000 W/m2 * cos(60 deg) * 2 m2 on the surface; 1000 W/m2 * (1 m)^2 / cos(60 deg) from a point
    turned = cos(radians(60))
    words = "1000 W/m2 W,W/sr --area 2m2 --distance 1m --incidence 60deg"
    assert values(words) == pytest.approx([1000 * turned * 2, 1000 / turned], rel=1e-14)


def test_each_answer_states_its_own_assumptions():
    plain, linked = answers("100lx,5W/m2 fc --spectrum D65")
    assert not plain["assumptions"]
    assert "spectrum D65" in linked["assumptions"][0]


def test_an_uncertain_condition_affects_only_answers_that_use_it():
    one = answers("100 lx fc,cd/m2 --reflectance 0.80+-0.08")[0]
    plain, reflected = results(one)
    assert "uncertainty" not in plain
    assert reflected["uncertainty"] == pytest.approx(100 * 0.08 / pi, rel=1e-9)  # by the slope
    certain = answers("100lx,5cd/m2 fc --reflectance 0.80+-0.08")[0]
    assert not certain["assumptions"]


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ("100 lx fc,W/m2 --spectrum D65 --area 2m2", "--area does not apply to"),
        ("5 W/m2 W,kW --distance 1m --area 1m2", "--distance does not apply to any"),
        ("100lx,50lx fc,klx --spectrum D65 --area 2m2", "--spectrum and --area do not apply"),
        ("100 lx fc,W/m2 --area 2m2", "a wavelength, a spectrum or an efficacy is missing"),
        ("100 lx fc,kg --area 2m2", "they are different quantities"),
    ],
)
def test_a_condition_that_no_answer_uses_is_refused(words, message):
    told = run(*words.split())
    assert told.returncode == 2
    assert message in told.stderr
    assert not told.stdout


@pytest.mark.parametrize("unit", ["cd/m2", "lm", "W", "m", "K"])
def test_without_a_target_every_unit_of_the_quantity_has_its_value(unit):
    lines = run("convert", "1", unit, "-q").stdout.splitlines()
    texts = [line.split("\t")[1] for line in lines]
    listed = {resolve(text).atoms for text in texts if not find_scale(text)}
    measured = resolve(unit).dimension
    assert listed >= {((name, 1),) for name in UNITS if resolve(name).dimension == measured}
