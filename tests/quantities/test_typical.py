"""The typical values: radcalc reads them, and they agree with each other."""

import json
import math

import pytest
from conftest import run

from radcalc import cli
from radcalc.errors import UsageError
from radcalc.quantities.typical import VALUES, Typical, search
from radcalc.units.numbers import split_quantity
from radcalc.units.table import resolve

BASES = {
    "illuminance": "lx", "irradiance": "W/m2", "radiance": "W/m2/sr", "luminance": "cd/m2",
    "radiant flux": "W", "luminous flux": "lm", "solid angle": "sr",
}  # fmt: skip


def value(what: str, unit: str) -> Typical:
    (found,) = [v for v in VALUES if v.what == what and v.unit == unit]
    return found


@pytest.mark.parametrize("entry", VALUES, ids=lambda v: f"{v.what}: {v.quantity}")
def test_radcalc_reads_and_converts_every_value(entry, capsys):
    for text, number in zip(entry.value.split(" to "), (entry.low, entry.high), strict=False):
        assert split_quantity(text + entry.unit) == (number, entry.unit)
        target = BASES[entry.quantity]
        assert cli.run(["convert", text, entry.unit, target, "-n"]) == 0
        factor = resolve(entry.unit).factor
        assert float(capsys.readouterr().out) == pytest.approx(number * factor, rel=1e-11)
    assert 0 < entry.low <= entry.high
    assert entry.source


# value, unit, as they stand in the list of facts that the values are taken from
FACTS = [
    ("1361", "W/m2"), ("133", "klx"), ("2.0e7", "W/m2/sr"), ("2.0e9", "cd/m2"),
    ("852", "W/m2"), ("686", "W/m2"), ("1000", "W/m2"), ("100 to 110", "klx"),
    ("1.6e9", "cd/m2"), ("10000", "lx"), ("1000", "lx"), ("100", "lx"), ("0.1 to 0.3", "lx"),
    ("0.0002 to 0.002", "lx"), ("30000", "cd/m2"), ("3000", "cd/m2"), ("300", "cd/m2"),
    ("2500 to 5000", "cd/m2"), ("82", "W"), ("23.2", "W"), ("5", "mW"), ("0.81", "lm"),
    ("6.794e-5", "sr"), ("6.418e-5", "sr"),
]  # fmt: skip


@pytest.mark.parametrize(("number", "unit"), FACTS)
def test_the_values_are_those_of_the_facts(number, unit):
    assert [v for v in VALUES if (v.value, v.unit) == (number, unit)]


def test_the_sun_agrees_with_itself():
    space, disc = "sun outside the atmosphere", value("sun's disc", "sr").low
    assert value(space, "cd/m2").low * disc == pytest.approx(133e3, rel=0.03)
    assert value(space, "W/m2/sr").low * disc == pytest.approx(1361, rel=0.01)
    assert value("sun at the ground, disc at noon", "cd/m2").low * disc == pytest.approx(
        105e3, rel=0.05
    )
    direct = value("sun at the ground, winter noon, direct, facing it", "W/m2").low
    apparent = value("sun at the ground, winter noon, disc", "W/m2/sr").low
    assert apparent * disc == pytest.approx(direct, rel=0.005)
    assert 1.4e7 * disc == pytest.approx(951, abs=0.5)  # what the note says of the lectures' value
    assert 5.670374e-8 * 6000**4 / math.pi == pytest.approx(2.3e7, rel=0.02)
    assert 2.3e7 * disc > 1.1 * 1367


def test_the_moon_agrees_with_itself():
    disc, light = value("moon's disc", "cd/m2"), value("full moon", "lx")
    angle = value("moon's disc", "sr").low
    assert light.low < disc.low * angle < disc.high * angle < light.high * 1.1
    assert light.low / math.pi == pytest.approx(0.03, abs=0.003)  # a white wall in moonlight


def test_the_overcast_sky_agrees_with_the_overcast_day():
    # Moon and Spencer 1942: L = L_z (1 + 2 cos z)/3, integrated by hand with cos z over the sky.
    zenith_to_horizontal = 2 * math.pi * (1 / 2 + 2 / 3) / 3
    day = value("overcast day", "lx")
    zenith = value("overcast sky that gives 10 klx, its zenith", "cd/m2")
    assert zenith.low * zenith_to_horizontal == pytest.approx(day.low, rel=1e-3)
    dark = value("overcast sky, dark, its zenith", "cd/m2")
    assert dark.low * zenith_to_horizontal == pytest.approx(733, abs=0.5)
    assert "733 lx" in dark.note
    assert "733 lx" in day.note


def test_radcalc_itself_gives_what_can_be_calculated(capsys):
    def answer(*words: str) -> float:
        assert cli.run([*words, "-q"]) == 0
        return float(capsys.readouterr().out)

    space = "sun outside the atmosphere"
    found = answer("spectrum", "AM0", "-g", "illuminance:klx")
    assert found == pytest.approx(value(space, "klx").low, abs=0.5)
    found = answer("convert", "5", "mW", "lm", "--wavelength", "632.8nm", "-n")
    assert found == pytest.approx(0.81, abs=0.005)
    sphere = ("solid-angle", "sphere", "-g", "solid-angle")
    found = answer(*sphere, "--radius", "695700km", "--distance", "1au")
    assert found == pytest.approx(6.794e-5, abs=5e-9)
    found = answer(*sphere, "--radius", "1737.4km", "--distance", "384400km")
    assert found == pytest.approx(6.418e-5, abs=5e-9)


@pytest.mark.parametrize(
    ("text", "whats", "quantities"),
    [
        ("sun", "sun", {"irradiance", "illuminance", "radiance", "luminance", "solid angle"}),
        ("SUN", "sun", {"irradiance", "illuminance", "radiance", "luminance", "solid angle"}),
        ("illuminance", "", {"illuminance"}),
        ("osvetlenost", "", {"illuminance"}),
        ("освещённость", "", {"illuminance"}),
        ("jas", "", {"luminance"}),
        ("radiant flux", "", {"radiant flux"}),
        ("lx", "", {"illuminance"}),
        ("fc", "", {"illuminance"}),
        ("mW", "", {"radiant flux"}),
        ("moon", "moon", {"illuminance", "luminance", "solid angle"}),
        ("laser", "laser", {"radiant flux", "luminous flux"}),
        ("moon illuminance", "moon", {"illuminance"}),
        ("wall", "moon", {"luminance"}),
    ],
)
def test_a_search_finds_these(text, whats, quantities):
    found = search(text)
    assert {v.quantity for v in found} == quantities
    assert all(whats in v.what for v in found)


def test_without_a_search_all_are_listed():
    assert len(run("typical").stdout.splitlines()) == len(VALUES) == len(search(""))


@pytest.mark.parametrize("text", ["zork", "moom", "%", "[/bold]", "kg", "x" * 100_000])
def test_what_is_not_found_is_refused_with_a_hint(text):
    with pytest.raises(UsageError, match="no typical value") as refused:
        search(text)
    assert refused.value.hint


def test_the_formats():
    (entry,) = json.loads(run("typical", "starlight", "--json").stdout)["records"]
    assert (entry["low"], entry["high"], entry["unit"]) == (0.0002, 0.002, "lx")
    lines = run("typical", "sr", "--format", "csv").stdout.splitlines()
    assert lines[0] == "what,quantity,value,unit,source,note,low,high"
    assert len(lines) == 3
    table = run("typical", "full", "moon", "--format", "table").stdout
    assert "note: full moon, 0.1 to 0.3 lx: the 0.02 lx" in table
    assert "note:" not in run("typical", "full", "moon", "--format", "table", "-q").stdout
    assert run("typical", "sun", "-n").returncode == 2
