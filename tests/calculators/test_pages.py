"""The pages of calculators: one for each command that calculates."""

import re
from importlib import import_module
from pathlib import Path

from helpers import for_each

from radcalc import calculators, homework
from radcalc.calculators import SUMMARIES, page_of
from radcalc.calculators.page import Page
from radcalc.quantities.symbols import QUANTITY, SYMBOLS, names_of_kinds

MODULES = [path.stem for path in Path(calculators.__file__).parent.glob("*.py")]


def test_the_list_has_every_page_that_describes_a_command():
    modules = {name: import_module(f"radcalc.calculators.{name}") for name in MODULES}
    described = {name for name, module in modules.items() if getattr(module, "PAGE", Page()).about}
    assert described == {name.replace("-", "_") for name in SUMMARIES}


@for_each(SUMMARIES)
def test_texts_and_units_are_those_of_symbols_that_the_page_takes(name):
    page = page_of(name)
    taken = {symbol for section in page.symbols.values() for symbol in section}
    taken |= {specific for generic in taken for specific in names_of_kinds(generic)}
    assert page.about.endswith(".")
    assert page.texts.keys() <= taken
    assert page.bare.keys() <= taken
    assert all(SYMBOLS[name].form == QUANTITY for name in page.intervals)


def test_a_text_of_a_page_replaces_the_text_of_the_vocabulary():
    page = Page(texts={"radius": "Of a hole.", "time": ("1/100s", "Of an exposure.")})
    assert page.symbol("radius")[3:5] == (SYMBOLS["radius"].example, "Of a hole.")
    assert page.symbol("time")[3:5] == ("1/100s", "Of an exposure.")
    assert page.symbol("height") is SYMBOLS["height"]


def test_a_result_measures_the_symbol_that_it_is_like():
    page = Page(like={"error": "irradiance"})
    assert page.symbol("error").dimensions == SYMBOLS["irradiance"].dimensions
    assert page.symbol("error").name == "error"


def test_an_interval_has_a_colon_in_its_example():
    assert page_of("solid-angle").intervals == ("polar", "azimuth")
    assert page_of("spectrum").intervals == ()


def test_homework_uses_exactly_the_mistakes_that_pages_list():
    listed = {mistake for name in SUMMARIES for mistake in page_of(name).mistakes}
    folder = Path(homework.__file__).parent
    sources = [path.read_text(encoding="utf-8") for path in folder.glob("*.py")]
    asked = {name for source in sources for name in re.findall(r'\.lists\("([^"]+)"\)', source)}
    assert listed == asked
