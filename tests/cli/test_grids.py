"""Lists in several inputs: a grid with the last list fastest; answers equal single calls."""

import random
from itertools import product

import pytest

from radcalc.__main__ import run
from radcalc.units import ranges

VALUES = {
    "--flux": ["800lm", "2.5klm", "4W"],
    "--half-angle": ["10deg", "0.3rad", "60deg", "85deg"],
    "--distance": ["2m", "6ft", "35cm", "10km"],
    "--incidence": ["0deg", "30deg", "1rad"],
    "--time": ["1s", "2min"],
    "--wavelength": ["555nm", "0.6um"],
}
COMMANDS = (
    "point-source -q -g irradiance:lx -g exposure:lx.s -g half-angle:deg",
    "convert 800 lm lx.s -q -n",
)


def answers(words: list[str], capfd: pytest.CaptureFixture[str]) -> list[str]:
    assert run(words) == 0
    return capfd.readouterr().out.splitlines()


@pytest.mark.parametrize("seed", range(12))
@pytest.mark.parametrize("command", COMMANDS)
def test_a_grid_equals_the_single_calls_in_the_order_typed(command, seed, capfd):
    draw = random.Random(seed)
    options = list(VALUES)
    if command.startswith("convert"):
        options = [name for name in options if name not in ("--flux", "--wavelength")]
    draw.shuffle(options)
    lists = [
        draw.sample(VALUES[name], draw.randint(1, len(VALUES[name]) if k < 3 else 1))
        for k, name in enumerate(options)
    ]

    def typed(values: tuple[str, ...]) -> list[str]:
        pairs = zip(options, values, strict=True)
        return [*command.split(), *(word for pair in pairs for word in pair)]

    grid = answers(typed(tuple(map(",".join, lists))), capfd)
    assert grid == [line for case in product(*lists) for line in answers(typed(case), capfd)]


def test_a_long_range_after_a_list_equals_the_single_ranges_in_turn(capfd):
    options = "--flux 800lm --distance 1m:2m:0.5mm -q -g irradiance:lx -g flux"
    words = ["point-source", *options.split()]
    several = [words[0], "--half-angle", "10deg,20deg,30deg", *words[1:]]
    single = [
        line
        for angle in ("10deg", "20deg", "30deg")
        for line in answers([*words, "--half-angle", angle], capfd)
    ]
    assert len(single) == 3 * 2001
    assert answers(several, capfd) == single


def test_a_result_that_does_not_vary_has_a_line_for_each_answer(capfd):
    words = ["point-source", "--flux", "800lm", "-q", "-g", "flux", "--distance"]
    assert answers([*words, "1m:5m:1m"], capfd) == ["800"] * 5
    assert answers([*words, "1m:5m:2mm"], capfd) == ["800"] * 2001


def test_the_number_of_answers_is_bounded(capfd, monkeypatch):
    words = ["point-source", "--flux", "800lm", "-q", "-g", "flux", "--half-angle"]
    assert run([*words, "1deg:50deg:1deg", "--distance", "1m:201m:1m"]) == 2
    assert "50 x 201 = 10050 answers" in capfd.readouterr().err
    monkeypatch.setattr(ranges, "MOST", 20)
    assert run([*words, "1deg:5deg:1deg", "--distance", "1m:4m:1m"]) == 0
    assert run([*words, "1deg:5deg:1deg", "--distance", "1m:5m:1m"]) == 2
