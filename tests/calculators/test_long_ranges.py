"""Ranges too long for a line each in memory are arrays: as single values, or refused as such."""

import math

import pytest

from radcalc.__main__ import run

LONG = [
    ("point-source --flux 800lm --distance 1m:3m:0.001m", "illuminance:lx"),
    ("point-source --intensity 90cd --height 2m --offset 0m:2m:0.001m", "illuminance:lx"),
    ("point-source --flux 800lm --half-angle 5deg:85deg:0.05deg --distance 2m", "intensity:cd"),
    ("point-source --intensity 90cd --exponent 1:3:0.001 --distance 2m", "flux:lm"),
    ("lambertian disc --luminance 9cd/m2 --radius 1m --height 1m:3m:0.001m", "illuminance:lx"),
    ("lambertian sphere --luminance 9cd/m2 --radius 1m --distance 2m:4m:0.001m", "illuminance:lx"),
    ("lambertian --luminance 9cd/m2 --area 1mm2 --distance 1m:3m:0.001m", "illuminance:lx"),
    ("ev --f-number 2:8:0.005 --time 1s", "ev100"),
    ("calorimeter --mass 45g:90g:0.03g --specific-heat 450J/kg/K --temperature-rise 3K", "energy"),
    ("screen --flux 2000lm --width 1m:3m:0.001m --aspect 4/3", "illuminance:lx"),
    ("sensor --luminance 9cd/m2 --f-number 1:3:0.001 --wavelength 550nm", "irradiance:W/m2"),
    ("sensor --luminance 9cd/m2 --f-number 4 --off-axis-angle 0deg:60deg:0.05deg", "illuminance"),
    ("laser --flux 5mW --diameter 1mm --divergence 1mrad --distance 1m:3m:0.001m", "irradiance"),
    (
        "laser --flux 5mW --diameter 1mm:3mm:1um --limit 1kW/m2 --divergence 1mrad",
        "hazard-distance",
    ),
    ("room --area 20m2:60m2:0.02m2 --luminaires 12 --flux 3klm --utilance 0.6", "illuminance"),
    ("photon 400nm:700nm:0.2nm", "photon-energy:eV"),
    ("mesopic --luminance 0.1cd/m2:3cd/m2:0.002cd/m2 --sp-ratio 2", "mesopic-luminance"),
    ("solid-angle cone --half-angle 1deg:80deg:0.05deg", "solid-angle:sr"),
    ("etendue --area 1cm2 --half-angle 1deg:80deg:0.05deg", "etendue:mm2.sr"),
    (
        "etendue --radius 1cm --receiver-radius 1cm --distance 1m:3m:0.001m --tilt 0deg",
        "etendue:mm2.sr",
    ),
]


@pytest.mark.parametrize(("words", "name"), LONG)
def test_a_long_range_gives_the_same_as_single_values(words, name, capfd):
    def answers(text: str) -> list[float]:
        assert run([*text.split(), "-q", "-g", name]) == 0
        return [float(line) for line in capfd.readouterr().out.splitlines()]

    found = answers(words)
    (varied,) = [word for word in words.split() if word.count(":") == 2]
    start = varied.partition(":")[0]
    assert len(found) > 1000
    assert found[0] == pytest.approx(answers(words.replace(varied, start))[0], rel=1e-11)
    assert all(map(math.isfinite, found))


@pytest.mark.parametrize(
    "words",
    [
        "point-source --intensity 90cd --offset 1m:3m:0.001m --illuminance 5lx",
        "point-source --intensity 90cd --offset 0m:2m:0.001m --illuminance 5lx",
        "lambertian --luminance 9cd/m2 --area 1m2 --distance 1m:3m:0.001m",
        "point-source --intensity 9cd --illuminance 1lx:30lx:0.01lx --distance 2m --flux 9lm",
    ],
)
def test_a_refused_long_range_has_a_message(words, capfd):
    assert run(words.split()) == 2
    said = capfd.readouterr().err
    assert "array" not in said
    assert "bug" not in said
