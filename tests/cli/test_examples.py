"""Tasks of `radcalc examples`: their parts, how they are found, and numbers from outside."""

import json
import math
import re

import pytest
from conftest import run
from helpers import displays_of, for_each, terminal_of

from radcalc.calculators.lists import manual_pages
from radcalc.quantities.lookup import FILE, search_tasks, tasks

TRADES = {
    "stage": 2, "growing": 3, "physics class": 3, "photography film": 3, "laser": 3,
    "lighting electricity": 3, "spectra colour": 2, "sun weather": 3, "projectors": 2,
    "shell programs": 2, "museum safety": 3,
}  # fmt: skip
TITLES = [task.title for task in tasks()]
H, C, E = 6.62607015e-34, 299792458, 1.602176634e-19  # SI Brochure, 9th edition
MINUTES = 180 / math.pi * 60


@for_each(TRADES)
def test_a_trade_finds_its_tasks(trade):
    assert len(search_tasks(trade)) >= TRADES[trade]


def test_every_section_of_the_file_is_a_whole_task():
    text = FILE.read_text(encoding="utf-8")
    assert re.findall("^## (.+)$", text, re.M) == TITLES
    assert len({*TITLES}) == len(TITLES) > 25
    for task in tasks():
        assert task.question
        assert task.calls
        assert all(call.output for call in task.calls), task.title
        assert len(task.reading.split()) > 3
    commands = [call.command for task in tasks() for call in task.calls]
    assert commands == re.findall(r"^\$ (.+)$", text, re.M)


# The laws and constants are those of the sources that the tasks name.
@pytest.mark.parametrize(
    ("title", "numbers"),
    [
        ("The distance of a spotlight", [100 / 0.3048**2, math.sqrt(150e3 / 100) * 0.3048]),
        ("A daily light integral", [12e6 / (16 * 3600)]),
        ("A photon", [H * C / 532e-9 / E, C / 532e-9 / 1e12]),
        ("The size of the moon", [2 * math.asin(1737.4 / 384400) * MINUTES]),
        ("The key light of a film", [250 * 2.8**2 * 48 / 800 * 0.3048**2, 117.6]),
        ("A colour filter", [1e6 / 6500, 1e6 / 3200]),
        ("The hazard distance of a laser", [(math.sqrt(4 / math.pi / 25.4) - 1e-3) * 1e3]),
        ("Photons of a laser", [1e-3 * 632.8e-9 / H / C]),
        ("A bulb over a table", [800 / (4 * math.pi * 1.5**2)]),
        ("The colour of a star", [2897.771955e3 / 5772]),
        ("A day of sunshine", [5 * 3.6, 5000 / 24]),
        ("An overcast sky", [7 * math.pi / 9 * 4.093]),
        ("A cinema projector", [14 / math.pi / 0.3048**2, 48 * math.pi * 60]),
        ("A column of numbers", [9.290304, 18.580608, 27.870912]),
        ("A year in a museum", [120, 50 * 0.075]),
        ("The UV index", [0.2 * 1800]),
    ],
)
def test_the_numbers_of_a_task_are_those_of_its_source(title, numbers):
    (task,) = [task for task in tasks() if task.title == title]
    lines = [line for call in task.calls for line in call.output]
    printed = [float(word) for line in lines if line[:1].isdigit() for word in line.split()[:2]
               if re.fullmatch(r"[\d.]+(e[+-]?\d+)?", word)]  # fmt: skip
    assert printed[: len(numbers)] == pytest.approx(numbers, rel=4e-3)


# Apogee Instruments, conversion of lux to PPFD; reference solar spectrum and lamps differ a little.
@pytest.mark.parametrize(("place", "factor"), [(0, 0.0185), (1, 0.0122)])
def test_the_ppfd_of_a_lux_meter_is_close_to_that_of_apogee(place, factor):
    (task,) = search_tasks("lux meter greenhouse")
    ppfd = float(task.calls[place].output[0].split()[0])
    assert ppfd == pytest.approx(factor * 10_000, rel=0.03)


def test_the_list_has_every_task_with_a_command():
    lines = [line.split("\t") for line in run("examples").stdout.splitlines()]
    assert [title for _, title, _ in lines] == TITLES
    assert all("radcalc " in command for _, _, command in lines)


@for_each(["Ppfd", "PPFD", "ppf"])
def test_a_word_is_found_by_its_beginning_without_case(word):
    assert search_tasks(word) == search_tasks("ppfd") != []


def test_all_words_have_to_be_mentioned():
    assert [task.title for task in search_tasks("museum log")] == ["A log"]
    assert len(search_tasks("museum")) > 1
    assert run("examples", "museum", "greenhouse").returncode == 2


def test_a_found_task_is_complete_in_text_and_as_json():
    done = run("examples", "uv", "index")
    (task,) = search_tasks("uv index")
    for text in (task.trade, task.title, task.calls[0].command, *task.calls[0].output):
        assert text in done.stdout
    assert task.reading in " ".join(done.stdout.split())
    (record,) = json.loads(run("examples", "uv", "index", "--json").stdout)["records"]
    assert record["commands"] == [task.calls[0].command]
    assert record["output"].splitlines() == [*task.calls[0].output]
    assert record["question"] == task.question


def test_an_unknown_word_is_refused_with_words_that_exist():
    done = run("examples", "musem")
    assert (done.returncode, done.stdout) == (2, "")
    assert "try: radcalc examples museum" in done.stderr
    done = run("examples", "zebra")
    assert done.returncode == 2
    words = done.stderr.rpartition(": ")[2].strip().split(", ")
    assert len(words) > 9
    assert all(search_tasks(word) for word in words)


@pytest.mark.parametrize("width", [60, 80])
def test_a_terminal_shows_commands_that_can_be_pasted(width):
    text = terminal_of("examples", columns=width, NO_COLOR="1").replace("\r", "")
    assert max(map(len, text.splitlines())) <= width
    joined = re.sub(r" \\\n +", " ", text)
    lines = [line.strip() for line in joined.splitlines()]
    for task in tasks():
        assert task.title in lines
        assert task.command in lines


def test_the_page_has_the_tasks():
    page = manual_pages()
    (source,) = [
        path.read_text(encoding="utf-8") for path in page if path.name == "radcalc-examples.7"
    ]
    shown = [re.sub(r" \\\n +", " ", command) for command, _ in displays_of(source)]
    assert shown == [call.command for task in tasks() for call in task.calls]
