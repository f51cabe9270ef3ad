"""`-g NAME` prints the first result of that name in the listing, in the same unit.

`-g NAME:UNIT` prints the right number in a unit of every dimension, or is refused.
"""

import json
import math
import random
import re
import shlex
from itertools import permutations
from pathlib import Path
from unittest import mock

import pytest
from conftest import ROOT, run
from helpers import Q, for_each
from helpers import answers as read
from test_cases import FILES, transcripts

from radcalc.__main__ import run as main
from radcalc.calculators import SUMMARIES
from radcalc.calculators.results import pick
from radcalc.cli import answers
from radcalc.cli.command import command_of
from radcalc.errors import RadcalcError
from radcalc.quantities import GRID, KINDS, Reading, coherent_text
from radcalc.quantities.symbols import (
    EFFICACIES,
    NUMBERS_ALONE,
    SPECIFIC,
    SYMBOLS,
    light_unit,
    specific_name,
)
from radcalc.units.table import spellings, unit_of

OTHERS = {"columns", "convert", "examples", "help", "manual", "mark"}
OTHERS |= {"quantities", "typical", "units"}
ENDS = {
    "--auto",
    "--plot",
    "-n",
    "--number",
    "--json",
    "--help",
    "-h",
    "--check",
    "--steps",
    "--list",
    "--by",
    "-",
}
TAKING = {"-g", "--get", "--format", "--precision", "--tolerance", "--color"}


def listing_of(command, output):
    """Return the words of a transcript if it lists all results of a calculator, else None."""
    if not output or output.startswith("radcalc: ") or output.endswith("]\n"):
        return None
    try:
        words = shlex.split(command, comments=True)
    except ValueError:
        return None
    if (
        words[:1] != ["radcalc"]
        or len(words) < 3
        or words[1] not in SUMMARIES
        or words[1] in OTHERS
    ):
        return None
    if Path(words[1]).is_file() or ENDS & set(words) or any(c in command for c in "|<>;&$`\n"):
        return None
    kept, skipping = [], False
    for word in words[1:]:
        if not skipping and word not in TAKING:
            kept.append(word)
        skipping = not skipping and word in TAKING
    return kept


LISTINGS = sorted({shlex.join(found) for path in FILES for command, output in transcripts(path)
                   if (found := listing_of(command, output))})  # fmt: skip


def test_the_transcripts_have_every_calculator():
    assert {text.split()[0] for text in LISTINGS} >= {
        "calorimeter", "direction", "etendue", "ev", "integrate", "lambertian", "mesopic",
        "photon", "point-source", "screen", "solid-angle", "spectrum",
        "uberlight",
    }  # fmt: skip


@for_each(LISTINGS)
def test_a_bare_name_is_in_the_unit_of_the_listing(text):
    words = shlex.split(text)
    first: dict[str, list[tuple[str, str]]] = {}
    for line in run(*words, check=True).stdout.splitlines():
        name, number, unit = line.split("\t")
        first.setdefault(name, []).append((number, unit))
    assert first
    if words[0] == "spectrum" and len(words) > 3:  # a list of lights, of which some lack a result
        first = {name: told for name, told in first.items() if len(told) == len(first["x"])}
    asked = [part for name in first for part in ("-g", name)]
    done = run(*words, *asked, check=True)
    lines = [line.split("\t") for line in done.stdout.splitlines()]
    for (name, told), column in zip(first.items(), zip(*lines, strict=True), strict=True):
        each = len(told) // len(lines)  # a result may have a line for each of several units
        for (number, unit), found in zip(told[::each], column, strict=True):
            if unit == told[0][1]:  # a list has one unit, that of the first
                assert found == number or is_within(found, number), name


def test_a_result_is_in_its_own_unit_if_the_first_is_of_another_kind():
    """E = Phi / (4 pi d^2): 800 / (16 pi) = 15.9155 lx, and 900 / (16 pi) = 17.9049 W/m2."""
    lamps = ["point-source", "--flux", "800lm,900W", "--distance", "2m", "-g", "irradiance", "-q"]
    done = run(*lamps, "--format", "csv", "--precision", "6", check=True)
    assert done.stdout.splitlines() == [
        "flux,irradiance:lx,irradiance:W/m2", "800lm,15.9155,", "900W,,17.9049"
    ]  # fmt: skip


def is_within(found, uncertain):
    """Return whether a number is within an uncertain one: 63.7 ± 1.6, or (3.77 ± 0.12)e-05."""
    size, off, power = re.fullmatch(r"\(?(\S+) ± ([^)]+?)\)?(e\S+)?", uncertain).groups("")
    return abs(float(found) - float(size + power)) <= float(off + power)


MORE = {  # calculators that no transcript lists, and links between the kinds of light
    "dose - --efficacy 54lm.s/umol": "t_h,E_lx\n0,54e3\n10,54e3\n",
    "scene examples/office.csv --at 2m,2m,0.75m --spectrum LED-B3": "",
    "refraction --index 1.5 --incidence 30deg": "",
    "point-source --flux 800lm --distance 2m --time 1h --wavelength 555nm": "",
    "point-source --photon-flux 9umol/s --distance 3m --spectrum D65": "",
    "lambertian disc --luminance 100cd/m2 --radius 1m --height 2m --efficacy 93lm/W": "",
    "laser --flux 5mW --diameter 1mm --divergence 1mrad --distance 9m --wavelength 540THz": "",
    "photon 2.2eV": "",
    "photon 540THz": "",
}
COMPOSED = (
    "lm/W", "umol/J", "lm.s/umol", "W/lm", "J/lm/s", "umol/lm/s", "m2.sr", "A/W", "V/m", "A.s",
    "m/s", "m3", "J/kg/K", "cd.s/m2", "cm-1", "kJ/mol", "1/s", "lm/m", "kg.m", "cd.sr", "rad/s",
)  # fmt: skip
RATIOS = {name for name, _, _ in EFFICACIES}


def test_a_result_is_in_each_unit_of_its_dimension_and_in_no_other():
    """A unit of every dimension, and some of densities; dimensions and factors are from Pint."""
    chance, listed, asked = random.Random(27), listed_results(), 0
    units = by_dimension([*filter(unit_of, spellings()), *COMPOSED])
    grid = {facts: coherent_text(Reading(*facts)) for facts in GRID.values()}
    units += by_dimension(text for (*_, axis), text in grid.items() if not axis)
    densities = by_dimension(text for (*_, axis), text in grid.items() if axis)
    assert {command for command, _, _ in listed} == {*SUMMARIES} - {"convert"}
    for (command, name, _), (values, shown) in listed.items():
        rows = [(row.name, Q(row.value, row.unit)) for row in shown if unit_of(row.unit)]
        for same in (*units, *chance.sample(densities, 5)):
            text, unit = chance.choice(same)
            asked += 1
            try:
                found = pick(values, f"{name}:{text}").value * unit
            except RadcalcError:
                found = None
            assert is_right(name, found, unit, rows), (command, name, text, found)
    assert asked > 20_000, asked


def is_right(name, found, unit, rows):
    """Compare a result in a unit, or its refusal, with the listing."""
    own = [amount for other, amount in rows if other == name]
    if name == "photon-energy":  # in J, or in J for each photon
        own += [own[0] * Q(1, "photon"), own[0] / Q(1, "photon")]
    for amount in own:
        if name in NUMBERS_ALONE and unit.dimensionless and unit.to("").magnitude != 1:
            return found is None
        if amount.dimensionality == unit.dimensionality:
            return found is not None and is_near(found, amount)
    others = in_other_kinds(name, rows) + [eyes_own(a) for a in own if "scotopic" in str(a.units)]
    return found is None or any(is_near(found, amount) for amount in others)


def eyes_own(amount):
    """Return the amount in plain lumens, which in a scotopic result are those of that eye."""
    return Q(amount.magnitude, str(amount.units).replace("scotopic_", ""))


def in_other_kinds(name, rows):
    """Return the amounts of a light quantity by the ratios of kinds in the listing."""
    by_name = {}
    for other, amount in rows:
        by_name.setdefault(generic(other), []).append(amount)
    ratios = [amount for other, amount in rows if other in RATIOS and amount]
    ratios += [b / a for same in by_name.values() for a, b in permutations(same, 2) if a]
    return [k for a in by_name[generic(name)] for r in ratios if r for k in (a, a * r, a / r)]


def generic(name):
    return SPECIFIC.get(name, (name.removeprefix("radiant-"), ""))[0]


def is_near(found, amount):
    if found.dimensionality != amount.dimensionality:
        return False
    return math.isclose(found.magnitude, amount.to(found.units).magnitude, rel_tol=1e-9)


def by_dimension(texts):
    """Return the units of each dimension in Pint, with their texts."""
    found = {}
    for text in texts:
        unit = Q(1, text)
        found.setdefault(unit.dimensionality, []).append((text, unit))
    return [*found.values()]


def listed_results():
    """Return the results in the listings, by command, name and dimension, with their answers."""
    found = {}

    def rows(values, case="", listing=answers.rows):
        shown = listing(values, case)
        for row in shown:
            if unit := unit_of(row.unit):  # no scale
                found.setdefault((words[0], row.name, unit.dimension), (values, shown))
        return shown

    with mock.patch.object(answers, "rows", rows):
        for text, lines in {**dict.fromkeys(LISTINGS, ""), **MORE}.items():
            words = shlex.split(text)
            run(*words, input=lines, cwd=ROOT, check=True)
    return found


def in_two_kinds():
    """Yield the listings with a light quantity given again, in another kind: 250 lm/W, 4 umol/J."""
    amounts = dict(zip(KINDS, (Q(1, "W"), Q(250, "lm"), Q(4, "umol/s")), strict=True))
    for text in LISTINGS:
        words = shlex.split(text)
        for k, word in enumerate(words[:-1]):
            symbol = SYMBOLS.get(word.removeprefix("--"))
            unit = unit_of(words[k + 1].lstrip("-.0123456789e")) if symbol else None
            if not (word.startswith("--") and symbol and symbol.generic and unit):
                continue
            kind = GRID[unit.dimension][0]
            number = float(words[k + 1].removesuffix(unit.text))
            for other in sorted({*KINDS} - {kind}):
                twin = specific_name(symbol.generic, other)
                text = light_unit(symbol.generic, other)
                amount = (Q(number, unit.text) / amounts[kind] * amounts[other]).to(text).magnitude
                again = [f"--{twin}", f"{amount!r}{text.replace(' ', '.')}"]
                yield symbol.name, twin, words[:k], words[k : k + 2], again, words[k + 2 :]


def test_the_order_of_two_kinds_does_not_matter():
    """The name typed has the number typed, and a name for every kind needs a unit."""
    chance, answered = random.Random(27), 0
    for name, twin, before, one, other, after in chance.sample([*in_two_kinds()], 40):
        calls = [[*before, *one, *other, *after], [*before, *other, *one, *after]]
        found = [run(*words, "--json", cwd=ROOT) for words in calls]
        assert found[0].returncode == found[1].returncode, calls
        if found[0].returncode:
            continue
        answered += 1
        first, second = ([of["results"] for of in read(done.stdout)] for done in found)
        for results, same in zip(first, second, strict=True):
            assert all(results[key]["given"] for key in {name, twin} & results.keys()), calls
            assert results.keys() == same.keys(), calls
            for key in results.keys() - {"error"}:
                assert results[key]["unit"] == same[key]["unit"], (calls, key)
                assert results[key]["value"] == pytest.approx(same[key]["value"]), (calls, key)
            for key in {generic(key) for key in results if key in SPECIFIC} - results.keys():
                done, swapped = (run(*words, "-g", key, cwd=ROOT) for words in calls)
                assert done.stdout == swapped.stdout, (calls, key)
                if f"--{key}" in calls[0] and done.returncode == 0:  # 1 cd/m2 as a radiance
                    text = calls[0][calls[0].index(f"--{key}") + 1]
                    (typed,) = (of for of in results.values() if text.endswith(of["unit"]))
                    assert float(done.stdout.split()[0]) == typed["value"], (calls, key)
                    continue
                assert (done.returncode, done.stdout) == (2, ""), (calls, key)
                assert f"'{key}' is ambiguous" in done.stderr
    assert answered > 20


def answers_of(words):
    """Return the results of a call in JSON, for each of its answers, or its refusal."""
    done = run(*words, "--json", cwd=ROOT)
    return done.stderr if done.returncode else [found["results"] for found in read(done.stdout)]


def test_a_result_that_is_fed_back_as_an_option_gives_the_same_answer():
    """It is compared with the laws; some options exclude each other, but none contradicts."""
    chance, same = random.Random(27), 0
    for text in chance.sample(LISTINGS, 90):
        words = shlex.split(text)
        before = answers_of(words)
        if len(before) != 1 or "±" in text or "+-" in text:
            continue
        options = {spelling for option in command_of(words[0]).params for spelling in option.opts}
        for name, result in before[0].items():
            if f"--{name}" not in options or result["given"]:
                continue
            unit = result["unit"].replace(" ", ".").removeprefix("1")
            after = answers_of([*words, f"--{name}", f"{result['value']!r}{unit}"])
            if isinstance(after, str):
                assert "contradict" not in after, (text, name)
            else:
                same += 1
                assert any(is_same(before[0], found) for found in after), (text, name)
    assert same > 100


def is_same(before, after):
    """Compare the results in both; the error of a sum depends on how it was found."""
    return all(
        before[name]["unit"] != after[name]["unit"]
        or math.isclose(before[name]["value"], after[name]["value"], rel_tol=1e-6, abs_tol=1e-9)
        for name in before.keys() & after.keys() - {"error"}
    )


# 100 cd at 2 m: 25 lx by the inverse square law; 25 lx / (683 lm/W) at 555 nm, where V is 1.
OF_SYMBOLS = {
    "E": 25.0,
    "E_v": 25.0,
    "Ev:klx": 0.025,
    "osvětlenost": 25.0,
    "osvetleni": 25.0,
    "освещённость": 25.0,
    "Beleuchtungsstärke": 25.0,
    "illuminance": 25.0,
    "I": 100.0,
    "сила света": 100.0,
    "d": 2.0,
    "vzdálenost": 2.0,
    "Φ": 400 * math.pi,
    "Phi_v": 400 * math.pi,
    "luminous flux": 400 * math.pi,
}


@pytest.mark.parametrize("name", OF_SYMBOLS)
def test_a_result_has_its_symbol_and_its_names(name, capfd):
    call = ["point-source", "--intensity", "100cd", "--distance", "2m", "-q"]
    assert main([*call, "-g", name]) == 0
    assert float(capfd.readouterr().out) == pytest.approx(OF_SYMBOLS[name], rel=1e-11)
    unit = {"E": "lx", "I": "cd", "d": "m", "Φ": "lm"}.get(name)
    if unit:
        assert main([*call, "--check", f"{name}={OF_SYMBOLS[name]:.12g}{unit}"]) == 0


@pytest.mark.parametrize("name", ["E_e", "ozářenost", "облучённость"])
def test_a_name_of_one_kind_of_light_is_not_another(name, capfd):
    call = ["point-source", "--intensity", "100cd", "--distance", "2m", "-q"]
    assert main([*call, "-g", name]) == 2
    assert main([*call, "--check", f"{name}=25lx"]) == 2
    capfd.readouterr()
    assert main([*call, "--wavelength", "555nm", "-g", name]) == 0
    assert float(capfd.readouterr().out) == pytest.approx(25 / 683, rel=1e-4)
    assert main([*call, "--wavelength", "555nm", "-g", "E"]) == 2
    assert main([*call, "--wavelength", "555nm", "-g", "E:lx"]) == 0


@pytest.mark.parametrize(
    ("listed", "names"),
    [
        ("rf,rg,r9", ["rf", "rg", "r9"]),
        ("cct:K,lux-per-ppfd:lm.s/umol", ["cct:K", "lux-per-ppfd:lm.s/umol"]),
        ("R_f,h1", ["R_f,h1"]),  # a symbol with a comma
        ("R_f,h1,R_f,h16,rf", ["R_f,h1", "R_f,h16", "rf"]),
    ],
)
def test_a_list_of_results_is_the_same_as_several_options(listed, names):
    alone = run("spectrum", "LED-B3", *(word for name in names for word in ("-g", name)))
    together = run("spectrum", "LED-B3", "-g", listed)
    assert alone.stdout.count("\t") == len(names) - 1
    assert (together.stdout, together.stderr) == (alone.stdout, alone.stderr)


def test_a_hint_for_several_results_is_the_whole_answer_in_python():
    call = ["point-source", "--flux", "800lm", "-g", "illuminance,flux", "--json"]
    (found,) = json.loads(run(*call).stdout)["error"]["try"]
    assert found["call"] == 'radcalc.point_source(flux="800 lm", distance="2 m")'
