"""The light of the sky and the sun: results, assumptions and errors."""

import math

import numpy as np
import pytest
from conftest import run
from helpers import Q, for_each

import radcalc
from radcalc.errors import RadcalcError

SUN = "--sun-elevation 40deg --sun-azimuth 200deg"
CLEAR = f"clear {SUN} --horizontal-illuminance 12klx --sun-illuminance 80klx"
WALL = "--tilt 90deg --azimuth 180deg"


def asked(words: str) -> list[float]:
    done = run("sky", *words.split(), "-q", "--precision", "15")
    assert done.returncode == 0, done.stderr
    return [float(part) for part in done.stdout.split()]


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        # E = 7 pi Lz/9, a wall pi/6 + 4/9 of Lz (Moon and Spencer)
        ("overcast --zenith-luminance 9000cd/m2 -g horizontal-illuminance:lx", 7000 * math.pi),
        ("overcast --horizontal-illuminance 10klx -g zenith-luminance", 90000 / (7 * math.pi)),
        ("overcast --tilt 90deg -g daylight-share", 3 / 14 + 4 / (7 * math.pi)),
        ("--tilt -90deg -g daylight-share", 3 / 14 + 4 / (7 * math.pi)),
        ("overcast --normal 3,4,0 -g daylight-share", 3 / 14 + 4 / (7 * math.pi)),
        ("overcast --tilt 180deg -g daylight-share", 0),
        ("overcast --luminance-toward 200cd/m2 --toward 60deg -g zenith-luminance", 300),
        ("overcast --zenith-luminance 300cd/m2 --toward 1,1,-1 -g luminance-toward", 0),
        (
            "overcast --illuminance 1klx --tilt 90deg -g zenith-luminance",
            1000 / (math.pi / 6 + 4 / 9),
        ),
        # uniform: pi L, and (1 + cos T)/2 of it
        ("uniform --zenith-luminance 1000cd/m2 -g horizontal-illuminance", 1000 * math.pi),
        ("5 --tilt 60deg -g daylight-share", 0.75),
        ("5 --irradiance 75W/m2 --tilt 60deg -g horizontal-irradiance", 100),
    ],
)
def test_skies_without_a_sun(words, expected):
    assert asked(words) == pytest.approx([expected], rel=1e-12, abs=1e-15)


def test_the_sun_is_added_by_its_cosine():
    """On a vertical wall it is cos(elevation) cos(difference of the azimuths)."""
    names = ("direct-illuminance", "diffuse-illuminance", "illuminance", "global-illuminance")
    gets = " ".join(f"-g {name}:lx" for name in names)
    direct, diffuse, both, on_ground = asked(f"{CLEAR} {WALL} {gets}")
    elevation, aside = math.radians(40), math.radians(20)
    assert direct == pytest.approx(8e4 * math.cos(elevation) * math.cos(aside), rel=1e-12)
    assert both == pytest.approx(direct + diffuse, rel=1e-12)
    assert on_ground == pytest.approx(12e3 + 8e4 * math.sin(elevation), rel=1e-12)


@pytest.mark.parametrize(
    ("given", "name"),
    [
        ("--illuminance {illuminance} --sun-illuminance 80klx", "zenith-luminance"),
        ("--illuminance {illuminance} --horizontal-illuminance 12klx --sun-radius 0.2666deg", ""),
        ("--global-illuminance {global-illuminance} --sun-illuminance 80klx", "zenith-luminance"),
        ("--global-illuminance {global-illuminance} --horizontal-illuminance 12klx", "illuminance"),
        ("--sun-luminance {sun-luminance} --horizontal-illuminance 12klx", "illuminance"),
        ("--luminance-toward {luminance-toward} --sun-illuminance 80klx", "illuminance"),
    ],
)
def test_every_set_of_the_light_gives_the_rest(given, name):
    places = f"clear {SUN} {WALL} --toward 60deg,100deg"
    names = ["illuminance", "global-illuminance", "sun-luminance", "luminance-toward"]
    units = ["lx", "lx", "cd/m2", "cd/m2"]
    every = asked(
        f"{places} --horizontal-illuminance 12klx --sun-illuminance 80klx "
        + " ".join(f"-g {one}:{unit}" for one, unit in zip(names, units, strict=True))
    )
    known = {n: f"{v:.15g}{u}" for n, v, u in zip(names, every, units, strict=True)}
    words = given
    for one, text in known.items():
        words = words.replace(f"{{{one}}}", text)
    if not name:  # no sun is given
        done = run("sky", *f"{places} {words}".split())
        assert done.returncode == 2
        return
    own = "-g zenith-luminance:cd/m2 -g illuminance:lx"
    expected = asked(f"{places} --horizontal-illuminance 12klx --sun-illuminance 80klx {own}")
    assert asked(f"{places} {words} {own}") == pytest.approx(expected, rel=1e-9)


def test_the_disc_of_the_sun():
    """1.6e9 cd/m2 over a cone of 0.2666 deg: pi L sin^2 on a plane that faces it."""
    (found,) = asked("5 --sun-elevation 30deg --sun-luminance 1.6e9cd/m2 -g sun-illuminance:lx")
    assert found == pytest.approx(math.pi * 1.6e9 * math.sin(math.radians(0.2666)) ** 2, rel=1e-12)
    (half,) = asked(
        "5 --sun-elevation 30deg --sun-luminance 1.6e9cd/m2 --sun-radius 0.1333deg "
        "-g sun-illuminance:lx"
    )
    assert half == pytest.approx(found / 4, rel=1e-5)


def test_only_differences_of_azimuths_matter():
    words = "12 --sun-elevation 25deg --horizontal-illuminance 10klx --tilt 60deg -g illuminance:lx"
    first, *others = [
        asked(f"{words} --sun-azimuth {sun}deg --azimuth {plane}deg")[0]
        for sun, plane in ((0, 70), (10, 80), (10, -60), (350, 60), (70, 0))
    ]
    assert others == pytest.approx([first] * 4, rel=1e-9)
    turned = asked(
        words.replace("--tilt 60deg", "--tilt -60deg") + " --sun-azimuth 0deg --azimuth 250deg"
    )
    assert turned == pytest.approx([first], rel=1e-9)
    # x = sin(60) cos(70), y = sin(60) sin(70), z = cos(60)
    vector = ",".join(f"{x:.15g}" for x in (
        math.sin(math.radians(60)) * math.cos(math.radians(70)),
        math.sin(math.radians(60)) * math.sin(math.radians(70)),
        0.5,
    ))  # fmt: skip
    as_vector = words.replace("--tilt 60deg", f"--normal {vector}")
    assert asked(f"{as_vector} --sun-azimuth 0deg") == pytest.approx([first], rel=1e-9)


def test_other_kinds_of_light():
    """D65 has about 203.2 lx per W/m2; all results have the same ratio."""
    words = "clear --sun-elevation 40deg --horizontal-illuminance 12klx --spectrum D65"
    lux, watts, photons, zenith, zenith_watts = asked(
        f"{words} -g horizontal-illuminance:lx -g horizontal-irradiance:W/m2 "
        "-g horizontal-photon-irradiance:umol/m2/s -g zenith-luminance -g zenith-radiance:W/m2/sr"
    )
    assert watts / lux == pytest.approx(zenith_watts / zenith, rel=1e-12)
    converted = run(
        "convert", "12000", "lx", "umol/m2/s", "--spectrum", "D65", "-n", "--precision", "15"
    )
    assert photons == pytest.approx(float(converted.stdout), rel=1e-12)


def test_the_assumption_of_one_spectrum_for_sun_and_sky_is_stated():
    told = "the sun's light and the sky's have the same spectrum"
    assert told in run("sky", *f"{CLEAR} {WALL} --spectrum D65".split()).stderr
    assert told not in run("sky", *f"{CLEAR} {WALL}".split()).stderr


def test_assumptions_are_stated():
    said = run("sky", *f"{CLEAR} {WALL}".split()).stderr
    for text in (
        "CIE type 12: CIE standard clear sky",
        "the sky does not include the sun's disc",
        "no light comes from below the horizon",
        "azimuths are measured from the same direction",
        "radius of 0.2666 deg",
        "daylight share is for the sky alone",
    ):
        assert text in said
    said = run("sky", *["--zenith-luminance", "1cd/m2"]).stderr
    assert said == "assumed: traditional overcast sky (Moon and Spencer)\n"
    words = f"{CLEAR} --normal 0,1,0"
    said = run("sky", *words.split()).stderr
    assert "from +x towards +y" in said
    assert "the sun is behind the plane" in said
    assert "cuts the sun's disc" not in said
    said = run("sky", *CLEAR.replace("40deg", "0.1deg").split(), *WALL.split()).stderr
    assert "cuts the sun's disc" in said


@for_each(
    [
        ("", "a light quantity is missing", "--horizontal-irradiance"),
        ("cleer --zenith-luminance 1cd/m2", "unknown sky 'cleer'", "clear"),
        ("clear --zenith-luminance 1cd/m2", "the sun's elevation is missing", "--sun-elevation"),
        ("clear clear", "unexpected argument 'clear'", "one type of sky"),
        ("5 --sun-illuminance 1klx", "the sun's elevation is missing", "--sun-elevation"),
        (
            "3 --sun-elevation 3deg --zenith-luminance 1cd/m2",
            "not apply to the sky type 3",
            "try: radcalc sky 3 --zenith-luminance 1cd/m2\n",
        ),
        (
            "3 --tilt 3deg --azimuth 1deg",
            "the same at every azimuth",
            "try: radcalc sky 3 --tilt 3deg\n",
        ),
        (  # for the position of the sun alone
            "-g sun-elevation --place 50.1N,14.4E --when 2026-06-21T12:00+02:00",
            "not apply to the sky type overcast",
            "try: radcalc sky clear --place 50.1N,14.4E --when 2026-06-21T12:00+02:00 "
            "--tilt 0deg -g sun-elevation\n",
        ),
        ("clear --sun-elevation -1deg", "out of range", "above the horizon"),
        ("clear --sun-elevation 91deg", "out of range", "90 deg"),
        (f"clear {SUN} --zenith-luminance 1cd/m2", "--sun-azimuth does not apply", "--tilt 90deg"),
        (f"clear {SUN} --tilt 90deg", "the plane's azimuth is missing", "--azimuth 180deg"),
        ("clear --sun-elevation 9deg --tilt 9deg", "the sun's azimuth is missing", "--sun-azimuth"),
        (f"clear {SUN} --zenith-luminance 1cd/m2 --toward 60deg", "no azimuth", "60deg,90deg"),
        ("overcast --illuminance 1lx", "the plane of --illuminance is missing", "--tilt"),
        ("overcast --luminance-toward 1cd/m2", "direction of --luminance-toward", "--toward"),
        (
            "overcast --tilt 9deg --normal 0,0,1",
            "both turn the plane",
            "try: radcalc sky overcast --normal 0,0,1\n     daylight-share 1\n"
            "or:  radcalc sky overcast --tilt 9deg\n",
        ),
        ("overcast --zenith-luminance 1cd/m2 --azimuth 9deg", "without a tilt", "--tilt 90deg"),
        (
            "overcast --tilt 9deg --sun-radius 1deg",
            "does not apply",
            "try: radcalc sky overcast --tilt 9deg\n",
        ),
        (
            f"clear {SUN} {WALL} --sun-radius 1deg",
            "without the sun's light",
            f"try: radcalc sky clear {SUN} {WALL}\n",
        ),
        (
            f"{CLEAR} {WALL} --illuminance 1klx",
            "contradicts",
            f"try: radcalc sky {CLEAR} {WALL}\n",
        ),
        (
            f"clear {SUN} {WALL} --sun-illuminance 80klx --illuminance 50klx",
            "less than one of them",
            "",
        ),
        ("overcast --zenith-luminance 1cd/m2 --horizontal-illuminance 1lx", "contradicts", ""),
        ("overcast --illuminance 1lx --tilt 180deg", "no light arrives", ""),
        ("overcast --zenith-luminance 1cd/m2 -g illuminance", "no plane is given", "--tilt"),
    ],
)
def test_impossible_skies_are_refused(words, message, hint):
    done = run("sky", *words.split())
    assert (done.returncode, done.stdout) == (2, "")
    assert message in done.stderr.replace("\n", " ")
    assert hint in done.stderr


def test_answers_to_lists_have_their_inputs():
    done = run("sky", *["12", "--sun-elevation", "10deg,20deg", "--zenith-luminance", "1kcd/m2"])
    assert "sun-elevation\t10\tdeg" in done.stdout
    words = "overcast --zenith-luminance 9cd/m2 --toward 0deg:90deg:30deg -g luminance-toward"
    assert asked(words) == pytest.approx([9, 3 + 3 * math.sqrt(3), 6, 3])


def test_a_number_can_be_checked():
    done = run("sky", *["overcast", "--zenith-luminance", "9000cd/m2", "--check", "22klx"])
    assert "right" in done.stdout
    words = "overcast --zenith-luminance 9000cd/m2 --check horizontal-illuminance=28klx"
    assert "wrong" in run("sky", *words.split()).stdout


def test_arrays_in_python():
    tilts = Q(np.array([0.0, 30.0, 90.0, 180.0]), "deg")
    share = radcalc.sky("uniform", tilt=tilts)["daylight_share"]
    assert share.magnitude == pytest.approx((1 + np.cos(np.radians([0, 30, 90, 180]))) / 2)
    found = radcalc.sky(
        12,
        sun_elevation=Q(np.array([20.0, 60.0]), "deg"),
        sun_azimuth="0 deg",
        tilt="90deg",
        azimuth=Q(np.array([0.0, 180.0]), "deg"),
        horizontal_illuminance="10 klx",
    )["irradiance"]
    single = [
        radcalc.sky(
            12,
            sun_elevation=f"{sun} deg",
            sun_azimuth="0 deg",
            tilt="90deg",
            azimuth=f"{plane} deg",
            horizontal_illuminance="10 klx",
        )["irradiance"]
        for sun, plane in ((20, 0), (60, 180))
    ]
    assert found.to("lx").magnitude == pytest.approx(
        [one.to("lx").magnitude for one in single], rel=1e-12
    )
    with pytest.raises(RadcalcError, match="unknown sky 'dull'"):
        radcalc.sky("dull", zenith_luminance="1 cd/m2")


def test_one_of_a_list_may_need_no_azimuth():
    """A level plane and the zenith do not depend on the sun's azimuth; others of a list do."""
    words = ["--sun-elevation", "40deg", "--sun-azimuth", "90deg", "--zenith-luminance", "1cd/m2"]
    planes = run("sky", "clear", *words, "--tilt", "0deg,90deg", "--azimuth", "90deg", "-g", "tilt")
    places = run(
        "sky", "clear", *words, "--toward", "0deg:60deg:60deg,90deg", "-g", "zenith-luminance"
    )
    assert (planes.stdout, places.stdout) == ("0\n90\n", "1\n1\n")
    useless = run("sky", "clear", *words)
    assert (useless.returncode, useless.stdout) == (2, "")
    assert "--sun-azimuth does not apply without a plane or a direction" in useless.stderr
