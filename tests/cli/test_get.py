"""`-g NAME` prints the first result of that name in the listing, in the same unit."""

import re
import shlex

from conftest import run
from helpers import for_each
from test_cases import FILES, transcripts

from radcalc.units.numbers import is_sentence

OTHERS = {"convert", "units", "quantities", "typical"}
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
    if words[:1] != ["radcalc"] or len(words) < 3 or words[1] in OTHERS or is_sentence(words[1:]):
        return None
    if ENDS & set(words) or any(c in command for c in "|<>;&$`\n"):
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
    asked = [part for name in first for part in ("-g", name)]
    done = run(*words, *asked, check=True)
    lines = [line.split("\t") for line in done.stdout.splitlines()]
    for (name, told), column in zip(first.items(), zip(*lines, strict=True), strict=True):
        each = len(told) // len(lines)  # a result may have a line for each of several units
        for (number, unit), found in zip(told[::each], column, strict=True):
            if unit == told[0][1]:  # a list has one unit, that of the first
                assert found == number or is_near(found, number), name


def test_a_result_is_in_its_own_unit_if_the_first_is_of_another_kind():
    """E = Phi / (4 pi d^2): 800 / (16 pi) = 15.9155 lx, and 900 / (16 pi) = 17.9049 W/m2."""
    lamps = ["point-source", "--flux", "800lm,900W", "--distance", "2m", "-g", "irradiance", "-q"]
    done = run(*lamps, "--format", "csv", "--precision", "6", check=True)
    assert done.stdout.splitlines() == [
        "flux,irradiance:lx,irradiance:W/m2", "800lm,15.9155,", "900W,,17.9049"
    ]  # fmt: skip


def is_near(found, uncertain):
    """Return whether a number is within an uncertain one: 63.7 ± 1.6, or (3.77 ± 0.12)e-05."""
    size, off, power = re.fullmatch(r"\(?(\S+) ± ([^)]+?)\)?(e\S+)?", uncertain).groups("")
    return abs(float(found) - float(size + power)) <= float(off + power)
