"""`--check` on the command line: statuses, formats, and claims that are refused."""

import json
from typing import Any

import pytest
from conftest import run
from homework.questions import CONE, LUX, POINT, TILTED

from radcalc import cli
from radcalc.homework.question import read_claim


class Said:
    """Output of a command and its exit status."""

    def __init__(self, capsys: Any, *words: str) -> None:
        capsys.readouterr()
        self.status = cli.run(list(words))
        self.out, self.err = capsys.readouterr()


@pytest.fixture
def said(capsys):
    """Run a command in this process: words to split, and further words."""
    return lambda words, *others: Said(capsys, *words.split(), *others)


@pytest.mark.parametrize(
    ("words", "claim"), [(POINT, "24.6"), (CONE, "0.589"), ("direction 1 2 3", "0.9")]
)
def test_an_ambiguous_claim_is_refused_with_a_correction(said, words, claim):
    found = said(words, "--check", claim)
    assert found.status == 2
    assert found.out == ""
    assert "is ambiguous: it may answer several results" in found.err
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


@pytest.mark.parametrize("words", [f"{LUX} --check 111", f"{CONE} --check 0.589sr"])
@pytest.mark.parametrize("option", ["-n", "--format csv", "--json -n", "--format csv -n"])
def test_bare_numbers_and_csv_are_refused(said, words, option):
    found = said(f"{words} {option}")
    assert found.status == 2
    if "--json" in option:
        assert [*json.loads(found.out)] == ["error"]
    else:
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
def test_json_has_right_ratio_and_diagnoses(said, words, claim, is_right, first):
    found = said(words, "--check", claim, "--json")
    assert found.status == (0 if is_right else 1)
    assert found.err == ""
    answer = json.loads(found.out)
    one = answer["check"]
    assert one["right"] is is_right
    assert {"right", "name", "unit", "value", "claimed", "claimed_unit", "ratio", "tolerance",
            "diagnoses"} == set(one)  # fmt: skip
    assert answer["steps"] == []
    result = answer["results"][one["name"]]
    assert (result["value"], result["unit"]) == (one["value"], one["unit"])
    assert one["claimed"] == read_claim(claim).value
    if first == "wrong-unit":
        assert one["ratio"] is None  # none for two quantities
    elif one["value"]:
        assert one["ratio"] == pytest.approx(one["claimed"] / one["value"], rel=1e-12)
    else:
        assert one["ratio"] is None
    for diagnosis in one["diagnoses"]:
        assert set(diagnosis) >= {"mistake", "done", "right"}
        assert all(diagnosis[key] for key in ("mistake", "done", "right"))
    assert (one["diagnoses"][0]["mistake"] if one["diagnoses"] else None) == first
    assert found.out == json.dumps(answer, ensure_ascii=False) + "\n"


def test_the_answer_in_words_is_right_or_wrong_with_the_right_value(said):
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
    assert "L = rho E / (pi Omega0)" in found.out
    found = said(LUX, "--check", "777")
    assert found.status == 1
    assert found.out.splitlines()[1] == "no usual mistake gives this number"
    assert "6.974 times" in found.out


def test_quiet_leaves_out_assumptions(said):
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
