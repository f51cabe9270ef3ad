"""Typical values: they can be read, and are consistent."""

import json
import math
from itertools import pairwise

import pytest
from conftest import run
from helpers import for_each

from radcalc import cli
from radcalc.errors import NumberError, UsageError
from radcalc.quantities.language import LANGUAGES
from radcalc.quantities.lookup import VALUES, Typical, search_typical, words_of_typical
from radcalc.units.numbers import split_quantity

BASES = {
    "illuminance": "lx", "irradiance": "W/m2", "radiance": "W/m2/sr", "luminance": "cd/m2",
    "radiant flux": "W", "luminous flux": "lm", "solid angle": "sr", "luminous intensity": "cd",
    "photon irradiance": "umol/m2/s", "luminous efficacy": "lm/W",
    "melanopic EDI": "EML",
}  # fmt: skip
SIZES = {"klx": 1e3, "mW": 1e-3, "mW/m2": 1e-3, "mol/m2/day": 1e6 / 86400, "lx_mel": 1 / 0.9058}


def value(what: str, unit: str) -> Typical:
    (found,) = [v for v in VALUES if v.what == what and v.unit == unit]
    return found


@for_each(VALUES)
def test_radcalc_reads_and_converts_every_value(entry):
    for text, number in zip(entry.value.split(" to "), (entry.low, entry.high), strict=False):
        assert split_quantity(text + entry.unit) == (number, entry.unit)
        done = run("convert", text, entry.unit, BASES[entry.quantity], "-n", "-q", check=True)
        expected = number * SIZES.get(entry.unit, 1.0)
        if entry.unit == "EV":  # L = K 2^EV/S with K = 12.5 cd s/m2 of ISO 2720, at ISO 100
            expected = 0.125 * 2**number
        assert float(done.stdout) == pytest.approx(expected, rel=1e-11)
    assert entry.low <= entry.high
    assert entry.low > 0 or entry.unit == "EV"
    assert entry.source


def test_every_value_has_a_unique_name_in_each_language():
    for language in LANGUAGES:
        names = {value.what: value.name(language) for value in VALUES}
        assert len(set(names.values())) == len(names)
        assert all(name == " ".join(name.split()) for name in names.values())
    assert len({(value.what, value.unit) for value in VALUES}) == len(VALUES)


# Words of encyclopedias, of shops and of lecture notes, which repeat the numbers of others.
SECONDARY = ("wikipedia", "encyclop", "orders of magnitude", ".com", ".org", "shop", "lecture")
# Publishers of pages without a year or a number: the title follows.
TITLED = (
    *("American Meteorological Society, ", "Apogee Instruments, ", "University of Florida, "),
    "US Department of Energy, ",
)


@for_each(VALUES)
def test_every_value_has_a_primary_source_with_its_edition_or_section(entry):
    assert not [word for word in SECONDARY if word in entry.source.lower()]
    has_number = any(character.isdigit() for character in entry.source)
    assert has_number or entry.source.startswith(TITLED)
    assert entry.source.strip(" .;:,") == entry.source


def test_the_sun_agrees_with_itself():
    space, disc = "sun outside the atmosphere", value("sun's disc", "sr").low
    assert value(space, "cd/m2").low * disc == pytest.approx(133e3, rel=0.03)
    assert value(space, "W/m2/sr").low * disc == pytest.approx(1361, rel=0.01)
    assert value("sun at the ground, disc at noon", "cd/m2").low * disc == pytest.approx(
        105e3, rel=0.05
    )
    direct = value("sun at the ground, air mass 1.5, direct, facing it", "W/m2").low
    apparent = value("sun at the ground, air mass 1.5, disc", "W/m2/sr").low
    assert apparent * disc == pytest.approx(direct, rel=0.005)
    assert 1.4e7 * disc == pytest.approx(
        951, abs=0.5
    )  # the figure in the note on the lectures' value
    # Haurwitz 1945: 1098 cos z exp(-0.059/cos z), as in pvlib.clearsky.haurwitz; air mass 1/cos z
    flat = value("sun at the ground, air mass 1.5, all light on a horizontal plane", "W/m2").low
    assert flat == pytest.approx(1098 / 1.5 * math.exp(-0.059 * 1.5), rel=1e-3)
    assert direct / 1.5 < flat < value("sun at the ground, clear, at most", "W/m2").low
    assert 5.670374e-8 * 6000**4 / math.pi == pytest.approx(2.3e7, rel=0.02)
    assert 2.3e7 * disc > 1.1 * 1367


def below(elevation: float) -> float:
    """Return the part of the light outside the atmosphere that reaches the ground.

    Janiczek and DeYoung 1987, USNO Circular 171; here by its transcription in skylight 1.4 (R).
    """
    up, height = math.sin(math.radians(elevation)), 753.66156
    angle = math.asin(height * math.cos(math.radians(elevation)) / (height + 1))
    mass = height * (math.cos(angle) - up) + math.cos(angle)
    scattered = 0.0289 * math.exp(-0.042 * mass) * (1 + (elevation + 90) * up / 57.29577951)
    return math.exp(-0.21 * mass) * up + scattered


def sunlight(elevation: float) -> float:
    return 133775 * below(elevation)  # [lx]


def moonlight(elevation: float, elongation: float) -> float:
    angle = math.radians(elongation)
    phase = 0.892 * math.exp(-3.343 / math.tan(angle / 2) ** 0.632)
    phase += 0.0344 * (math.sin(angle) - angle * math.cos(angle))
    up = math.sin(math.radians(elevation))
    return 0.418 * phase / (1 - 0.005 * math.cos(angle) - 0.03 * up) * below(elevation)


STRATUS, AVERAGE = 10, 3  # the circular's divisors for dark stratus and for average clouds


def test_daylight_and_moonlight_are_those_of_the_naval_observatory():
    day, noon = value("overcast day", "lx"), value("overcast day, noon", "klx")
    assert day.low == pytest.approx(sunlight(60) / STRATUS, rel=0.03)
    assert noon.low == pytest.approx(sunlight(60) / STRATUS / 1e3, rel=0.03)
    assert noon.high == pytest.approx(sunlight(60) / AVERAGE / 1e3, rel=0.01)
    sunset = value("sunset or sunrise, overcast", "lx").low
    assert sunset == pytest.approx(sunlight(-0.83) / STRATUS, rel=0.01)
    clear = value("sunset or sunrise, clear", "lx")  # of another source
    assert clear.low < sunlight(-0.83) < clear.high
    dusk = value("civil twilight, its end", "lx")
    assert dusk.low < sunlight(-6) < dusk.high
    assert value("nautical twilight, its end", "lx").low == pytest.approx(sunlight(-12), rel=1)
    for name, elongation in (("full moon", 175), ("quarter moon", 90)):
        light = value(name, "lx")
        ends = moonlight(30, elongation), moonlight(90, elongation)
        assert (light.low, light.high) == pytest.approx(ends, rel=0.15)


FOOT = 0.3048  # [m]


@for_each(
    [  # Smith, Modern Optical Engineering, fig. 12.8 in cd/cm2, fig. 12.9 in lm/ft2
        ("sun at the ground, disc at noon", "cd/m2", 1.6e5, 1e-4),
        ("sun at the ground, disc at the horizon", "cd/m2", 600, 1e-4),
        ("clear sky", "cd/m2", 0.8, 1e-4),
        ("overcast sky, dark", "cd/m2", 4e-3, 1e-4),
        ("filament of a clear incandescent bulb", "cd/m2", 500, 1e-4),
        ("fluorescent tube", "cd/m2", 0.6, 1e-4),
        ("flame of a candle", "cd/m2", 1, 1e-4),
        ("vision, its threshold", "cd/m2", 5e-11, 1e-4),
        ("open shade under a clear sky", "klx", 1, FOOT**2),
        ("dark overcast day", "lx", 10, FOOT**2),
        ("overcast night without moon", "lx", 1e-5, FOOT**2),
    ]
)
def test_values_of_a_textbook_are_converted_from_its_units(what, unit, number, area):
    assert value(what, unit).low == pytest.approx(number / area, rel=0.08)


def test_the_moon_agrees_with_itself():
    disc, light = value("moon's disc", "cd/m2"), value("full moon", "lx")
    angle = value("moon's disc", "sr").low
    assert light.low < disc.low * angle < disc.high * angle < light.high * 1.1
    assert light.low / math.pi == pytest.approx(0.03, abs=0.003)  # a white wall in moonlight
    # geometric albedo 0.12, NASA Moon Fact Sheet: that of a white disc is 1
    assert disc.high == pytest.approx(0.12 * 133e3 / math.pi, rel=0.02)


def test_the_overcast_sky_agrees_with_the_overcast_day():
    # Moon and Spencer 1942: L = L_z (1 + 2 cos z)/3, integrated by hand with cos z over the sky.
    zenith_to_horizontal = 2 * math.pi * (1 / 2 + 2 / 3) / 3
    day = value("overcast day", "lx")
    zenith = value("overcast sky that gives 10 klx, its zenith", "cd/m2")
    assert zenith.low * zenith_to_horizontal == pytest.approx(day.low, rel=1e-3)
    average = value("overcast sky that gives 10 klx, average", "cd/m2")
    assert average.low == pytest.approx(zenith.low * (1 + 1) / 3, rel=1e-3)  # mean of cos z: 1/2
    dark = value("overcast sky, dark", "cd/m2")
    assert 300 * zenith_to_horizontal == pytest.approx(733, abs=0.5)  # the lectures' 300 cd/m2
    assert "733 lx" in dark.note
    assert "733 lx" in day.note


def test_lamps_agree_with_the_inverse_square_law():
    candle = value("candle", "cd").low
    assert value("candle", "lm").low == pytest.approx(4 * math.pi * candle, rel=1e-3)
    assert value("candle, 1 m away", "lx").low == candle / 1**2
    flame = candle / value("flame of a candle", "cd/m2").low
    assert 0.5e-4 <= flame <= 2e-4  # a flame of about 1 cm2
    bulb = value("incandescent bulb, 60 W", "lm").low
    away = value("incandescent bulb, 60 W, 1 m away", "lx").low
    assert away == pytest.approx(bulb / (4 * math.pi), rel=1e-3)
    efficacy = value("incandescent bulb", "lm/W")
    ends = (value(f"incandescent bulb, {watts} W", "lm").low / watts for watts in (40, 100))
    assert [efficacy.low, efficacy.high] == [pytest.approx(end, rel=0.03) for end in ends]
    assert efficacy.low < bulb / 60 < efficacy.high
    beam = value("headlight, low beam, on the road, at least", "cd").low
    lit = value("headlight, low beam, on the road, 25 m away, at least", "lx").low
    assert lit == pytest.approx(beam / 25**2, rel=3e-3)
    opal = value("incandescent bulb, opal", "cd/m2").low
    assert opal == pytest.approx(bulb / (math.pi * 0.06) ** 2, rel=1e-3)
    moon, end = value("full moon", "lx"), value("torch, where its beam ends", "lx")
    assert moon.low < end.low < moon.high  # the full moon defines the end of a beam


def test_luminances_agree_with_the_illuminances_that_cause_them():
    desk = value("office desk, reading and writing", "lx").low
    paper = value("white paper on an office desk", "cd/m2").low
    assert paper == pytest.approx(0.8 * desk / math.pi, rel=3e-3)
    assert value("cinema screen, white", "cd/m2").low == pytest.approx(
        14 / (math.pi * 0.3048**2), rel=1e-3
    )  # 14 fL

    def scene(what: str) -> tuple[float, float]:
        """Return the illuminances of a scene of reflectance 18 %, as light meters assume."""
        entry = value(f"{what}, ISO 100", "EV")
        return tuple(0.125 * 2**ev * math.pi / 0.18 for ev in (entry.low, entry.high))

    assert scene("office")[0] == pytest.approx(desk, rel=0.2)
    (sunny, _), sun = scene("sunlit scene"), value("sun at the ground, clear, at most", "klx")
    assert 0.5 < sunny / (1e3 * sun.low) < 1
    snow = value("sunlit snow", "cd/m2").low
    assert snow == pytest.approx(0.85 * 10_000 / FOOT**2 / math.pi, rel=5e-3)


@for_each(
    [  # Kodak BW400CN, data sheet F-4036, at ISO 400: f-number, shutter speed [s]
        ("sunlit snow or sand", 22, 1 / 500),
        ("sunlit scene", 16, 1 / 500),
        ("scene under heavy clouds", 5.6, 1 / 500),
        ("brightly lit street at night", 2.8, 1 / 60),
        ("office", 4, 1 / 60),
        ("home at night", 2, 1 / 30),
    ]
)
def test_exposure_values_are_those_of_a_film_data_sheet(what, f_number, time):
    marked = math.log2(f_number**2 / time) - math.log2(4)  # ISO 400 to ISO 100
    assert value(f"{what}, ISO 100", "EV").low == pytest.approx(marked, abs=0.2)


def test_other_values_follow_from_exposures():
    # ISO 2720: L = K 2^EV/S with K = 12.5 cd s/m2, E = C 2^EV/S with C = 250 lx s
    floodlit = math.log2(2**2 * 15) - 2  # F-4036: f/2, 1/15 s at ISO 400
    assert value("floodlit building", "cd/m2").low == pytest.approx(0.125 * 2**floodlit, rel=0.1)
    night, moon = value("scene under a full moon, ISO 100", "EV"), value("full moon", "lx")
    ends = [math.log2(lit / 2.5) for lit in (moon.low, moon.high)]
    assert [night.low, night.high] == pytest.approx(ends, abs=0.05)


def test_plants_and_skin_agree_with_the_sun():
    full = value("sun at the ground, full, for plants", "umol/m2/s").low
    lit = 1e3 * value("sun at the ground, clear, at most", "klx").high
    assert lit / full == pytest.approx(55.4, rel=0.01)  # lx per umol/m2/s of AM1.5G
    day = value("sun at the ground, a summer day, for plants", "mol/m2/day")
    half_a_sine = full * 12 * 3600 * 2 / math.pi / 1e6  # from 6 to 18 o'clock
    assert day.low < half_a_sine < day.high
    for crop in ("lettuce and herbs", "tomatoes"):
        total, lamps = (
            value(f"{crop}, a day", "mol/m2/day"),
            value(f"{crop}, 16 h a day", "umol/m2/s"),
        )
        for end, rate in ((total.low, lamps.low), (total.high, lamps.high)):
            assert rate == pytest.approx(end * 1e6 / (16 * 3600), rel=2e-3)
    for index in (1, 11):  # 40 m2/W times the weighted irradiance
        burn = value(f"UV index {index}, weighted for sunburn", "mW/m2").low
        assert burn * 1e-3 * 40 == pytest.approx(index)


def test_illuminance_increases_from_night_to_noon():
    names = (
        "overcast night without moon", "starlight, clear night without moon",
        "nautical twilight, its end", "quarter moon", "full moon", "civil twilight, its end",
        "sunset or sunrise, overcast", "sunset or sunrise, clear", "overcast day",
    )  # fmt: skip
    lit = [value(name, "lx") for name in names]
    assert all(one.high < other.low for one, other in pairwise(lit))


def test_values_that_can_be_calculated_agree_with_radcalc(capsys):
    def answer(*words: str) -> float:
        assert cli.run([*words, "-q"]) == 0
        return float(capsys.readouterr().out)

    space = "sun outside the atmosphere"
    found = answer("spectrum", "AM0", "-g", "illuminance:klx")
    assert found == pytest.approx(value(space, "klx").low, abs=0.5)
    for name, spectrum, kind, unit in (
        ("sun at the ground, clear, at most", "AM1.5G", "irradiance", "W/m2"),
        ("sun at the ground, air mass 1.5, direct, facing it", "AM1.5D", "irradiance", "W/m2"),
        ("sun at the ground, full, for plants", "AM1.5G", "irradiance", "umol/m2/s"),
    ):
        found = answer("spectrum", spectrum, "-g", f"{kind}:{unit}")
        assert found == pytest.approx(value(name, unit).low, rel=2e-3)
    found = answer("convert", "5", "mW", "lm", "--wavelength", "632.8nm", "-n")
    assert found == pytest.approx(0.81, abs=0.005)
    sphere = ("solid-angle", "sphere", "-g", "solid-angle")
    found = answer(*sphere, "--radius", "695700km", "--distance", "1au")
    assert found == pytest.approx(6.794e-5, abs=5e-9)
    found = answer(*sphere, "--radius", "1737.4km", "--distance", "384400km")
    assert found == pytest.approx(6.418e-5, abs=5e-9)


LUMENS = {"luminous flux", "luminous efficacy", "luminance", "illuminance"}


@for_each(
    [
        ("SUN'S DISC", "disc", {"solid angle", "radiance", "luminance"}),
        ("solar constant", "", {"irradiance"}),
        ("illuminance", "", {"illuminance"}),
        ("osvetlenost", "", {"illuminance"}),
        ("освещённость", "", {"illuminance"}),
        ("jas", "", {"luminance"}),
        ("radiant flux", "", {"radiant flux"}),
        ("lx", "", {"illuminance"}),
        ("fc", "", {"illuminance"}),
        ("mW", "", {"radiant flux"}),
        ("EV", "ISO 100", {"luminance"}),
        ("moon", "moon", {"illuminance", "luminance", "solid angle"}),
        ("měsíc", "moon", {"illuminance", "luminance", "solid angle"}),
        ("луна", "moon", {"illuminance", "luminance"}),
        ("laser", "laser", {"radiant flux", "luminous flux"}),
        ("moon illuminance", "moon", {"illuminance"}),
        ("wall", "moon", {"luminance"}),
        ("candle", "candle", {"luminous intensity", "luminous flux", "illuminance", "luminance"}),
        ("svíčka", "candle", {"luminous intensity", "luminous flux", "illuminance", "luminance"}),
        ("svicku", "candle", {"luminous intensity", "luminous flux", "illuminance", "luminance"}),
        ("свечой", "candle", {"luminous intensity", "luminous flux", "illuminance", "luminance"}),
        ("oblačno", "", {"illuminance", "luminance"}),
        ("overcast", "", {"illuminance", "luminance"}),
        ("лампа накаливания", "", LUMENS),
        ("60 W bulb", "60 W", {"luminous flux", "illuminance"}),
        ("flashlight", "torch", {"illuminance"}),
        ("фара", "headlight", {"luminous intensity", "illuminance"}),
        ("PPFD", "", {"photon irradiance"}),
        ("DLI", "day", {"photon irradiance"}),
    ],
)
def test_a_search_finds_these(text, whats, quantities):
    found = search_typical(text)
    assert {v.quantity for v in found} == quantities
    assert all(whats in v.what for v in found)


@for_each(words_of_typical())
def test_every_completed_word_finds_values(word):
    assert search_typical(word)


@pytest.mark.parametrize(
    ("text", "first"),
    [
        ("1cd", "candle"),
        ("30 klx", "overcast day, noon"),
        ("500lx", "office desk, reading and writing"),
        ("1600 lm", "incandescent bulb, 100 W"),
        ("4 mW", "laser pointer, class 3R, at most"),
        ("15 EV", "sunlit scene, ISO 100"),
        ("16 EV", "sunlit snow or sand, ISO 100"),
        ("1.3 EV", "main road, classes M6 to M1"),  # 0.31 cd/m2
        ("9 mol/m2/day", "lettuce and herbs, a day"),
        ("1000 umol/m2/s", "sun at the ground, full, for plants"),
    ],
)
def test_the_values_nearest_to_an_amount_come_first(text, first):
    assert search_typical(text)[0].what == first


def test_values_named_after_an_amount_come_before_those_near_it():
    found = search_typical("60W")
    assert [value.what for value in found[:3]] == [
        "incandescent bulb, 60 W", "incandescent bulb, 60 W, 1 m away", "LED bulb replacing 60 W"
    ]  # fmt: skip
    assert {value.quantity for value in found[3:]} == {"radiant flux"}
    assert {value.quantity for value in search_typical("dBm")} == {"radiant flux"}


def test_a_malformed_number_has_the_usual_error():
    with pytest.raises(NumberError, match="'1,5lx' has a comma"):
        search_typical("1,5lx")


@pytest.mark.parametrize("text", ["1.79e308ph", "1.79e308 lx", "2.3e-308 lx", "0 lx", "-1 lx"])
def test_nothing_is_near_an_amount_that_no_light_has(text):
    with pytest.raises(UsageError, match="no typical value is near"):
        search_typical(text)


def test_near_values_are_sorted_by_their_ratio():
    """By hand: 1 lx is 1; 0.25, 1/4; 2 to 3.5, 2; 2 to 15, 2; 0.1 to 0.3, 3.3 times."""
    found = [value.what for value in search_typical("1 lx")]
    assert found[:3] == [
        "candle, 1 m away",
        "headlight, low beam, above its cut-off, 25 m away, at most",
        "civil twilight, its end",
    ]
    assert set(found[3:6]) == {
        "residential street, classes P6 to P1", "full moon", "torch, where its beam ends"
    }  # fmt: skip


def test_rates_and_daily_doses_come_first_for_amounts_of_their_kind():
    for text, first in (("600 umol/m2/s", "s"), ("30 mol/m2/d", "day")):
        ends = [value.unit.rpartition("/")[2] for value in search_typical(text)]
        assert ends[0] == first
        assert len(set(ends)) == 2
        assert ends == sorted(ends, key=lambda end: end != first)


def test_the_ratio_of_the_nearest_value_is_noted_if_none_is_near():
    # sunlight outside the atmosphere has 133 klx: 1e30/133e3 = 7.5e24; night 1e-4 lx: 1e5
    for text, times in (("1e30lx", "7.5e+24"), ("1e-9 lx", "1e+05")):
        done = run("typical", text)
        assert f"the nearest of these differs from {text} by a factor of {times}" in done.stderr
        assert not run("typical", text, "-q").stderr
    for near in ("500lx", "60W", "1e6lx", "candle", "lx"):
        assert not run("typical", near).stderr


@pytest.mark.parametrize("quantity", sorted({value.quantity for value in VALUES}))
def test_a_quantity_lists_all_its_values(quantity):
    assert search_typical(quantity) == [value for value in VALUES if value.quantity == quantity]


def test_without_a_search_all_are_listed():
    assert len(run("typical").stdout.splitlines()) == len(VALUES) == len(search_typical(""))


@pytest.mark.parametrize(
    "text", ["zork", "moom", "%", "[/bold]", "kg", "5 kg", "5 zork", "x" * 100_000]
)
def test_an_unknown_word_is_refused_with_a_hint(text):
    with pytest.raises(UsageError, match="no typical value") as refused:
        search_typical(text)
    assert refused.value.hint


def test_the_formats():
    (entry,) = json.loads(run("typical", "starlight", "--json").stdout)["records"]
    assert (entry["low"], entry["high"], entry["unit"]) == (0.0005, 0.001, "lx")
    lines = run("typical", "sr", "--format", "csv").stdout.splitlines()
    assert lines[0] == "what,quantity,value,unit,source,note,low,high"
    assert len(lines) == 3
    table = run("typical", "full", "moon", "--format", "table").stdout
    assert "note: full moon, 0.1 to 0.3 lx: the 0.02 lx" in table
    assert "note:" not in run("typical", "full", "moon", "--format", "table", "-q").stdout
    assert run("typical", "sun", "-n").returncode == 2
