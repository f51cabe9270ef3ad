"""CSV: a line for each answer, a column for what varies and for each result."""

import csv
import io

import pytest
from following import call
from helpers import answers

from radcalc.answer import Result, Row, ShownInput
from radcalc.render.csv import results
from radcalc.render.formats import Style


def lines(*found, precision=None):
    return [*csv.reader(io.StringIO(results(found, Style(precision))))]


def row(name, value, unit, given=False):
    return Row(name, "", value, unit, "", name, given)


def test_a_single_answer_has_its_results_alone():
    found = Result(
        (row("flux", 0.1, "lm"), row("flux", 0.1234567, "W")), inputs=(ShownInput("a", 1, "m"),)
    )
    assert lines(found) == [["flux:lm", "flux:W"], ["0.1", "0.1234567"]]
    assert lines(found, precision=3)[1] == ["0.1", "0.123"]


def test_an_answer_that_lacks_a_result_has_an_empty_cell():
    found = [Result((row("a", 1.0, "m"),)), Result((row("b", 2.0, "m"), row("a", 3.0, "m")))]
    assert lines(*found) == [["a:m", "b:m"], ["1.0", ""], ["3.0", "2.0"]]


def test_an_input_that_varies_is_in_the_unit_of_the_first():
    sizes = [(1.0, "m"), (50.0, "cm"), (1.0, "ft")]  # a foot is 0.3048 m
    found = [
        Result((row("d", *size, given=True), row("e", 5.0, "lx")), inputs=(ShownInput("d", *size),))
        for size in sizes
    ]
    assert lines(*found) == [["d:m", "e:lx"], ["1.0", "5.0"], ["0.5", "5.0"], ["0.3048", "5.0"]]


def test_an_input_that_a_result_shows_has_no_second_column():
    found = [
        Result(
            (row("e", 5.0, "lx"), row("d", d, "m", given=True)), inputs=(ShownInput("d", d, "m"),)
        )
        for d in (1.0, 2.0)
    ]
    assert lines(*found)[0] == ["e:lx", "d:m"]


def test_a_text_has_a_column_where_no_number_tells_the_answers_apart():
    def found(given):
        return [
            Result(
                (row("x", x, "m", given), row("e", 5.0, "lx")), inputs=(ShownInput("at", text=at),)
            )
            for x, at in ((1.0, "1,0"), (2.0, "2,0"))
        ]

    assert lines(*found(False)) == [
        ["at", "x:m", "e:lx"],
        ["1,0", "1.0", "5.0"],
        ["2,0", "2.0", "5.0"],
    ]
    assert lines(*found(True))[0] == ["x:m", "e:lx"]


def test_an_input_of_several_quantities_is_a_text():
    sizes = [(555.0, "nm", "555nm"), (540.0, "THz", "540THz")]
    found = [Result((row("e", 5.0, "lx"),), inputs=(ShownInput("light", *size),)) for size in sizes]
    assert lines(*found) == [["light", "e:lx"], ["555nm", "5.0"], ["540THz", "5.0"]]


RANGES = [
    "point-source --flux 800lm --distance 1m:2m:1mm -g irradiance:fc -g distance:ft",
    "point-source --flux 800lm --distance 1m:2m:1mm -g intensity",
    "point-source --flux 1lm,2lm --distance 1m:2m:1mm -g illuminance",
    "photon 400nm:700nm:0.25nm -g photon-energy:eV -g luminous-efficiency",
    "lambertian sphere --spectrum blackbody:3000K:4000K:1000K --radiance 2W/m2/sr --radius 1cm "
    "--distance 1m:2m:1mm -g luminance",
]


@pytest.mark.parametrize("text", RANGES)
def test_the_columns_of_a_long_range_are_the_answers_one_by_one(text):
    columns, objects = (call([*text.split(), *form]) for form in (["--format", "csv"], ["--json"]))
    assert columns.status == objects.status == 0, (columns.error, objects.error)
    found = answers(objects.output)
    read = [*csv.DictReader(io.StringIO(columns.output))]
    assert len(read) == len(found) > 1000
    for line, answer in zip(read, found, strict=True):
        told = answer["inputs"] | answer["results"]
        for head, cell in line.items():
            name, _, unit = head.partition(":")
            one = told[name]
            assert cell == one.get("text") or (float(cell), unit) == (one["value"], one["unit"])
        assert set(answer["results"]) <= {head.partition(":")[0] for head in line}
