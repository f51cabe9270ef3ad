"""Words of growers, of photographers and of the laboratory: what they mean, and which ask back.

Expected numbers are arithmetic with definitions: E = I cos(theta) / d^2, the exact h, c and N_A of
the SI (BIPM brochure, 9th edition, 2.2), and E = pi L tau / 4 N^2 on a sensor.
"""

import math
from datetime import datetime, timedelta

import pytest
from conftest import run
from following import call, liars
from helpers import for_each

import radcalc

JOULES_TIMES_NM = 6.62607015e-34 * 299792458 * 1e9  # h c, per photon
MICROMOLE = 6.02214076e17  # photons
# A flat spectrum has photons of the mean wavelength, 550 nm in PAR and 750 nm in far red.
PER_JOULE = 550 / JOULES_TIMES_NM / MICROMOLE  # umol/J of PAR
HOUR = 3600 / 1e6  # mol/m2 of 1 umol/m2/s

ANSWERED = [
    ("240 W LED 2.7 umol/J 1.2 m x 1.2 m to ppfd", 240 * 2.7 / 1.44, "umol/m2/s"),
    ("240 W LED fixture 2.7 umol/J to umol/s", 240 * 2.7, "umol/s"),
    ("450 umol at 30 cm, at 50 cm?", 450 * (30 / 50) ** 2, "umol/m2/s"),
    ("450 umol at 30 cm to umol at 50 cm", 450 * (30 / 50) ** 2, "umol/m2/s"),
    ("600 umol 16 h per day to DLI", 600 * 16 * HOUR, "mol/m2"),
    ("1000 cd/m2 f/2.8 transmittance 0.9 to lux", math.pi * 1000 * 0.9 / 4 / 2.8**2, "lux"),
    ("f/2.8 1000 cd/m2 to lux on sensor", math.pi * 1000 / 4 / 2.8**2, "lux"),
    ("sensor f/2.8 luminance 1000 cd/m2 to lux", math.pi * 1000 / 4 / 2.8**2, "lux"),
    # A Gaussian beam, whose diameter is at 1/e^2 of the peak: E_0 = 2 Phi / pi w^2.
    ("laser 5 mW diameter 2 mm peak irradiance", 2 * 5e-3 / math.pi / 1e-3**2, "W/m2"),
    ("laser 5 mW diameter 2 mm to irradiance", 5e-3 / math.pi / 1e-3**2, "W/m2"),
    ("150 cd at 2.5 m tilted 30 deg to lux", 150 / 2.5**2 * math.cos(math.radians(30)), "lux"),
    ("{flat} 450 W/m2 PAR to ppfd", 450 * PER_JOULE, "umol/m2/s"),
    ("{flat} PAR 450 W/m2 to umol/m2/s", 450 * PER_JOULE, "umol/m2/s"),
    ("{flat} 900 umol/m2/s PAR to W/m2 PAR", 900 / PER_JOULE, "W/m2"),
    ("{flat} 400-700 nm to W/m2", 300, "W/m2"),
    ("{flat} 400 nm to 700 nm ppfd", 300 * PER_JOULE, "ppfd"),
    ("{flat} fraction 400-700 nm", 50, "%"),
    ("{days} to DLI", (23 * 100 + 75) * HOUR, "DLI"),  # the first of two days
    ("{days} by day to DLI", (23 * 100 + 75) * HOUR, "DLI"),
    ("{days} to daily light integral", (23 * 100 + 75) * HOUR, "mol/m2"),
    ("{days} DLI per day", (23 * 100 + 75) * HOUR, "DLI"),
    ("{days} to mol/m2", (23 * 100 + 75 + 24 * 50) * HOUR, "mol/m2"),
]


@pytest.fixture(scope="module", name="files")
def _files(tmp_path_factory):
    """Make a spectrum of 1 W/m2/nm from 300 nm to 900 nm, and a log of two days.

    The log has 100 umol/m2/s on the first day and 50 umol/m2/s on the second, each hour, and a
    straight line between the last sample of the first day and midnight.
    """
    folder = tmp_path_factory.mktemp("files")
    flat, days, equal = folder / "flat.csv", folder / "days.csv", folder / "a=b.csv"
    rows = [f"{nm},1" for nm in range(300, 901, 5)]
    flat.write_text("\n".join(["wavelength [nm],E [W/m2/nm]", *rows]) + "\n")
    start = datetime(2024, 3, 4)
    times = [start + timedelta(hours=hour) for hour in range(49)]
    values = [100] * 24 + [50] * 25
    log = [f"{time.isoformat()},{value}" for time, value in zip(times, values, strict=True)]
    for path in (days, equal):
        path.write_text("\n".join(["time,PPFD [umol/m2/s]", *log]) + "\n")
    return {"flat": str(flat), "days": str(days), "equal": str(equal)}


def words_of(sentence, files):
    return sentence.format(**files).split()


@pytest.mark.parametrize(("sentence", "value", "unit"), ANSWERED)
def test_a_sentence_is_answered(sentence, value, unit, files):
    done = run(*words_of(sentence, files))
    assert done.returncode == 0, done.stderr
    number, _, shown = done.stdout.splitlines()[0].partition("\t")
    assert float(number) == pytest.approx(value, rel=1e-6), done.stderr
    assert shown == unit


def test_a_log_of_several_days_has_a_daily_light_integral_for_each(files):
    done = run(*words_of("{days} to DLI", files))
    numbers = [float(line.split()[0]) for line in done.stdout.splitlines()]
    assert numbers == pytest.approx([(23 * 100 + 75) * HOUR, 24 * 50 * HOUR])


def test_the_name_of_a_file_may_hold_an_equals_sign(files, monkeypatch):
    folder, _, name = files["equal"].rpartition("/")
    monkeypatch.chdir(folder)
    done = run(name, "to", "mol/m2")
    assert float(done.stdout.split()[0]) == pytest.approx((23 * 100 + 75 + 24 * 50) * HOUR)


# Calls, and parts of the message and of the hint with its numbers.
CONE = 2 * math.pi * (1 - math.cos(math.radians(18))), 2 * math.pi * (1 - math.cos(math.pi / 5))
REFUSED = [
    ("dose {days} -g photon-exposure:DLI", "the sum of one day", "8.55 DLI, 4.32 DLI"),
    ("dose {days} -g DLI --by hour", "the sum of one day, not of an hour", "8.55 mol/m2"),
    ("dose {days} --check 12.87DLI", "the sum of one day", "8.55 mol/m2"),
    ("{days} to hours", "no command takes", "a call of the command"),
    ("1000 cd/m2 f/2.8 to lux", "2 readings", f"{math.pi * 1000 / 4 / 2.8**2:.6g} lux"),
    ("1000 cd/m2 f/2.8 to lux", "2 readings", "illuminance on the scene"),
    ("36 deg cone to sr", "2 readings", f"{CONE[0]:.6g} sr, full angle of a cone"),
    ("36 deg cone to sr", "2 readings", f"{CONE[1]:.6g} sr, half angle of a cone"),
    ("450 W/m2 PAR to ppfd", "a spectrum", "--range 400nm:700nm --spectrum sun"),
    ("8000 lux to umol", "photon number", "try: radcalc 8000 lux to ppfd --spectrum sun"),
    ("35000 lux sunlight to umol", "photon number", "lux ppfd --spectrum sunlight"),
    ("600 umol to DLI", "photon number", f"{600 * 16 * HOUR:.6g} mol/m2"),
    ("450 ppfd at 30 cm to 50 cm", "fill one place", f"{450 * 0.36:.6g} umol/m2/s"),
    ("450 ppfd at 30 cm to 50 cm", "fill one place", f"{450 / 0.36:.6g} umol/m2/s"),
    ("200 W LED panel 1.2 m x 1.2 m to ppfd", "electrical", f"{200 * 2.5 / 1.44:.6g} umol/m2/s"),
    ("200 W LED panel 1.2 m x 1.2 m to ppfd", "electrical", "--spectrum LED"),
    ("60 W bulb to lumens", "electrical", "100lm/W as an example"),
    ("10000 lux 3500K LED to ppfd", "no LED of the CIE", "--spectrum LED-B2"),
    ("10000 lux T5 to ppfd", "lamps of this kind differ", "--spectrum FL11"),
    ("10000 lux fluorescent to ppfd", "lamps of this kind differ", "--spectrum FL4"),
    ("dli 600 16", "the unit of 16 is missing", f"{600 * 16 * HOUR:.6g} mol/m2"),
    ("what is a candela", "candela of what?", "radcalc help candela"),
    ("spectrum temperature to lux-hours time 4.69hours", "unknown spectrum", "--list"),
    ("planck 2856 K 555 nm", "no command takes", "radcalc help temperature"),
    ("spectrum {flat} --range 700nm:800nm -g ppfd", "is ambiguous", "--photon-range 700nm:800nm"),
    # 100 W/m2 of photons of 750 nm, and 200 W/m2 of 700 nm, half of which is PAR.
    (
        "spectrum {flat} --range 700nm:800nm -g irradiance:umol/m2/s -q",
        "is ambiguous",
        f"{100 * 750 / JOULES_TIMES_NM / MICROMOLE:.6g} umol/m2/s",
    ),
    (
        "spectrum {flat} --range 600nm:800nm -g irradiance:umol/m2/s",
        "is ambiguous",
        f"{200 * 700 / JOULES_TIMES_NM / MICROMOLE:.6g} umol/m2/s, all photons",
    ),
    (
        "spectrum {flat} --range 600nm:800nm -g irradiance:umol/m2/s",
        "is ambiguous",
        f"{100 * 650 / JOULES_TIMES_NM / MICROMOLE:.6g} umol/m2/s, those of PAR",
    ),
]


@pytest.mark.parametrize(("sentence", "message", "hint"), REFUSED)
def test_a_call_that_may_mislead_is_refused_with_calls_that_answer(sentence, message, hint, files):
    words = words_of(sentence, files)
    done = run(*words)
    assert (done.returncode, done.stdout) == (2, "")
    assert message in done.stderr
    assert hint in done.stderr
    assert not liars(words)


@for_each(["LED", "HPS", "white LED", "sun"])
def test_the_light_may_follow_the_target(light):
    before = run(*f"10000 lux {light} to ppfd".split())
    assert before.returncode == 0
    assert run(*f"10000 lux to ppfd {light}".split()).stdout == before.stdout


def test_a_hint_shows_no_call_that_fails_when_it_reads_a_file(files):
    outcome = call(["dose", files["days"], "-g", "maximum-irradiance:h"])
    assert outcome.status == 2
    assert all(answer for _, answer in outcome.proposed)


def test_the_photons_of_an_absolute_spectrum_are_a_result(files):
    done = run("spectrum", files["flat"], "-g", "photon-irradiance:umol/m2/s")
    assert float(done.stdout) == pytest.approx(300 * PER_JOULE, rel=1e-6)
    found = radcalc.spectrum(files["flat"])
    assert found.photon_irradiance.to("umol/m2/s").magnitude == pytest.approx(300 * PER_JOULE)


@for_each(["R9", "r9", "Rg", "Rf"])
def test_an_index_of_colour_is_not_a_unit(name):
    shown = run("LED-B3", "to", name, "-q")
    assert shown.stdout.split()[0] == run("spectrum", "LED-B3", "-n", "-g", name).stdout.strip()


def test_hours_a_day_are_a_photoperiod():
    for words in ("600 umol for 16 hours a day DLI", "600 ppfd 16 h per day to dli"):
        done = run(*words.split(), "-q")
        assert float(done.stdout.split()[0]) == pytest.approx(600e-6 * 16 * 3600)


def test_a_hint_has_no_empty_words():
    typed = "lambertian disc 5000 cd/m2 radius 10 cm lux on axis at 50 cm"
    hint = run(*typed.split()).stderr
    assert "604.152" in hint  # 5000 pi 0.1^2/(0.1^2 + 0.5^2)
    assert ", ," not in hint


def test_a_log_of_photons_over_days_names_the_option_for_each_day(files):
    assert "(--by day for each day's)" in run("dose", files["days"]).stderr
    assert "--by day" not in run("dose", files["days"], "--by", "day").stderr


def test_a_derivation_has_the_name_and_the_unit_of_its_result():
    sentence = "150 cd at 2.5 m incidence 30 deg to lux --steps"
    done = run(*sentence.split())
    number, unit = done.stdout.splitlines()[0].split("\t")
    assert (float(number), unit) == (pytest.approx(24 * math.cos(math.pi / 6)), "lux")


def test_python_gives_a_daily_light_integral_for_each_day(files):
    found = radcalc.ask(f"{files['days']} to DLI")
    numbers = [quantity.to("mol/m2").magnitude for quantity in found.values()]
    assert numbers == pytest.approx([(23 * 100 + 75) * HOUR, 24 * 50 * HOUR])
