"""The signatures and docstrings of the functions: complete, and as the commands have them."""

import inspect
import pydoc
import re

import pytest
from test_docstrings import entries, sections

import radcalc
from radcalc.cli.signatures import API, keywords, rewritten

FUNCTIONS = [name for name in radcalc.__all__ if inspect.isfunction(getattr(radcalc, name))]


@pytest.mark.parametrize("path", sorted(API.glob("*.py")), ids=lambda path: path.stem)
def test_the_keywords_are_those_of_the_commands(path):
    """Else: python -m radcalc.cli.signatures."""
    source = path.read_text(encoding="utf-8")
    assert rewritten(source) == source


@pytest.mark.parametrize("name", FUNCTIONS)
def test_every_parameter_has_a_name_a_type_and_an_entry(name):
    function = getattr(radcalc, name)
    parameters = inspect.signature(function).parameters
    assert not any(one.kind == one.VAR_KEYWORD for one in parameters.values())
    assert all(one.annotation is not one.empty for one in parameters.values())
    documented = sections(function)
    assert entries(documented["Parameters"]) == {*parameters}
    assert [*documented] == ["", "Parameters", "Returns", "Raises", "Examples"]
    summary = documented[""].split("\n\n")[0]
    assert summary.endswith(".")
    assert "\n" not in summary


def test_the_tests_see_the_functions():
    assert len(FUNCTIONS) > 20
    assert keywords("point_source")["distance"].unit == "m"
    assert keywords("ev")["f_number"].type == "Number"


def test_help_reads_as_a_manual():
    text = pydoc.render_doc(radcalc.point_source, renderer=pydoc.plaintext)
    assert "distance: 'Amount' = None" in text
    assert "Straight line from the source to the receiver. [m]" in text
    assert "`height`" in text  # as keywords are mentioned
    assert not re.search(r"(?<!-)--[a-z]", text)
