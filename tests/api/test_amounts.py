"""Quantities without keywords: the unit of each decides its symbol."""

import re
from contextlib import suppress

import numpy
import pandas
import pytest
from helpers import for_each

import radcalc
from radcalc.api.arguments import keyword
from radcalc.calculators import page_of
from radcalc.calculators.page import words_of
from radcalc.errors import RadcalcError, UsageError
from radcalc.quantities.symbols import QUANTITY, SYMBOLS

Q = radcalc.Quantity
PAGES = ["calorimeter", "etendue", "ev", "lambertian", "laser", "mesopic", "point-source",
         "refraction", "room", "screen", "sensor"]  # fmt: skip
# The symbol of an input without its keyword, where it is not itself: any length is a distance.
MEANT = {"mesopic-luminance": "luminance", "refraction-angle": "incidence"}


def calls():
    """Yield the calls of the examples of the pages: the function, its operands and keywords."""
    for name in PAGES:
        page = page_of(name)
        for example in page.examples:
            pairs = [word.partition("=") for word in words_of(example)[0]]
            operands = [key for key, equals, _ in pairs if not equals]
            given = {key: value for key, equals, value in pairs if equals and key != "get"}
            given.pop("plot", None)
            given.pop("save", None)
            texts = {
                key: value + page.bare.get(key, "") * value[-1].isdigit() if value else True
                for key, value in given.items()
            }
            if not {".ies", ".ldt", ".csv"} & {*re.findall(r"\.\w{3}\b", example)}:
                yield name, operands, texts


CALLS = [*calls()]


def answer(name, operands, given):
    function = getattr(radcalc, keyword(name))
    return str(function(*operands, **{keyword(key): value for key, value in given.items()}))


def values(text):
    """Return the values of an answer, whose names may be those of one kind of light."""
    rows = [re.split(" {2,}", line.strip()) for line in text.splitlines() if line[:2] == "  "]
    return sorted((row[1:] for row in rows if "assumed" not in row[0]), key=str)


def is_amount(page, key, value):
    return isinstance(value, str) and page.symbol(key).form == QUANTITY


def meant(key):
    return "distance" if SYMBOLS[key].unit in ("m", "mm") else MEANT.get(key, key)


@for_each(CALLS)
def test_an_amount_without_its_keyword_is_what_its_unit_means_or_refused(name, operands, given):
    page = page_of(name)
    operands = operands or (["patch"] if name == "lambertian" else [])
    for key in [key for key, value in given.items() if is_amount(page, key, value)]:
        others = {other: value for other, value in given.items() if other != key}
        try:
            found = answer(name, [*operands, given[key]], others)
        except RadcalcError:
            continue
        assert meant(key) not in others
        right = answer(name, operands, {**others, meant(key): given[key]})
        assert values(found) == values(right), key


@for_each(CALLS)
def test_all_amounts_without_keywords_are_what_their_units_mean(name, operands, given):
    page = page_of(name)
    operands = operands or (["patch"] if name == "lambertian" else [])
    amounts = {key: value for key, value in given.items() if is_amount(page, key, value)}
    others = {key: value for key, value in given.items() if key not in amounts}
    try:
        found = answer(name, [*operands, *amounts.values()], others)
    except RadcalcError:
        return
    names = {meant(key): value for key, value in amounts.items()}
    assert len(names) == len(amounts)
    assert values(found) == values(answer(name, operands, {**others, **names}))


def test_calls_without_keywords_are_answered():
    """Of 215 amounts of the examples 96 need no keyword: the sweeps above see many."""
    answered = 0
    for name, operands, given in CALLS:
        for key, value in given.items():
            if is_amount(page_of(name), key, value):
                others = {other: one for other, one in given.items() if other != key}
                with suppress(RadcalcError):
                    answer(name, [*(operands or ["patch"] * (name == "lambertian")), value], others)
                    answered += 1
    assert answered > 50


# Inverse square law: 100 cd / (2 m)^2 = 25 lx.
@for_each([
    ("100 cd", "2 m"), ("2 m", "100 cd"), (Q(100, "cd"), Q(200, "cm")), ("100 cd", Q(2, "m")),
])  # fmt: skip
def test_amounts_may_be_texts_and_quantities_in_any_order(amounts):
    found = radcalc.point_source(*amounts)
    assert found.illuminance.m_as("lx") == pytest.approx(25, rel=1e-15)
    assert {row.name for row in found.rows if row.given} == {"intensity", "distance"}


@for_each(["1m,2m,4m", "1m:4m:1m", ["1 m", "2 m"], Q(numpy.array([1.0, 2.0]), "m")])
def test_amounts_may_be_several_values(distance):
    found = radcalc.point_source("100 cd", distance).illuminance.m_as("lx")
    assert list(found[:2]) == pytest.approx([100, 25], rel=1e-15)


def test_operands_stay_first():
    # Disc: E = pi L r^2 / (r^2 + d^2), 1e4 cd/m2, 25 cm, 75 cm: 1000 pi lx.
    found = radcalc.lambertian("disc", "1e4 cd/m2", "75 cm", radius="25 cm")
    assert found.illuminance.m_as("lx") == pytest.approx(1000 * numpy.pi, rel=1e-12)
    light = radcalc.uberlight([0, 0, 2], "100 cd")
    assert light.irradiance.m_as("lx") == pytest.approx(25, rel=1e-12)
    with pytest.raises(RadcalcError, match="unknown shape '1e4 cd/m2'"):
        radcalc.lambertian("1e4 cd/m2")


def test_two_kinds_of_one_light_have_their_own_keywords():
    found = radcalc.point_source("800 lm", "4 W", "1 m")
    assert found.luminous_efficacy.m_as("lm/W") == 200
    given = {row.name for row in found.rows if row.given}
    assert given == {"luminous-flux", "radiant-flux", "distance"}


def test_a_wavelength_is_known_by_its_unit():
    # The efficacy at 555 nm is 683.002 lm/W (CIE S 010).
    found = radcalc.point_source("1 W", "555 nm", "1 m")
    assert found.luminous_flux.m_as("lm") == pytest.approx(683.002, rel=1e-6)


# function, amounts, keywords, what needs a keyword, some that it may have
NEED_KEYWORDS = [
    ("point_source", ("100 cd", "30 deg"), {}, "'30 deg' needs a keyword", {"half_angle"}),
    ("point_source", ("100 cd", "1 m"), {"distance": "2 m"}, "'1 m' needs a keyword", {"height"}),
    ("point_source", ("100 cd", "2 m", "1 m"), {}, "'2 m', '1 m' need keywords",
     {"distance", "height"}),
    ("refraction", ("45 deg", 1.5), {}, "'1.5' needs a keyword", {"index"}),
    ("laser", ("5 mW", "1 mm", "1 mrad", "10 m"), {}, "'1 mm', '1 mrad', '10 m' need keywords",
     {"diameter", "divergence", "distance"}),
    ("ev", ("1/60 s",), {"nd": "ND1000"}, "'1/60 s' needs a keyword", {"unfiltered_time"}),
    ("calorimeter", ("1000 W/m2", "20 cm2"), {}, "'20 cm2' needs a keyword", {"receiver_area"}),
    ("lambertian", ("patch", "500 lx"), {"reflectance": 0.5}, "'500 lx' needs a keyword",
     {"incident_illuminance"}),
]  # fmt: skip


@for_each(NEED_KEYWORDS)
def test_amounts_that_may_be_confused_need_keywords(name, amounts, given, problem, keywords):
    with pytest.raises(UsageError) as caught:
        getattr(radcalc, name)(*amounts, **given)
    assert caught.value.message == problem
    assert keywords <= {*caught.value.hint.removeprefix("one of ").split(", ")}


@for_each([
    ("point_source", ("100 cd", "50 cd"), "one of intensity, peak_intensity"),
    ("screen", ("3000 lm", "100 in"), "one of width, height, diagonal"),
    ("sensor", ("1000 cd/m2", "3.45 um"), "one of pixel_pitch, wavelength"),
    ("point_source", ("100 cd", Q([1, 2], "m"), "1 m"),
     "one of distance, height, offset, offset_y"),
    ("point_source", ("1 kg",), "help(radcalc.point_source)"),
    ("point_source", (None,), "help(radcalc.point_source)"),
    ("point_source", ("100 cd", True), "help(radcalc.point_source)"),
    ("point_source", ("100 cd", numpy.array([1.0])), "help(radcalc.point_source)"),
    ("point_source", ("800 lm", pandas.Series([1.0], name="height [m]")),
     "help(radcalc.point_source)"),
    ("point_source", ("1 m",) * 9, "one of distance, height, offset, offset_y"),
])  # fmt: skip
def test_a_refusal_names_the_keywords(name, amounts, hint):
    with pytest.raises(UsageError, match="keyword") as caught:
        getattr(radcalc, name)(*amounts)
    assert caught.value.hint == hint


def test_a_text_that_is_not_an_amount_is_refused():
    with pytest.raises(radcalc.UnitError, match="unknown unit 'cdd'"):
        radcalc.point_source("100 cdd", "2 m")
    with pytest.raises(RadcalcError, match="'D65' is not a number"):
        radcalc.laser("5 mW", "D65")
