"""Signatures and docstrings of the functions: they are complete and agree with the commands."""

import inspect
import pickle
import pydoc
import re
import runpy
from typing import get_type_hints

import pytest
from conftest import ROOT
from helpers import for_each
from test_docstrings import entries, sections

import radcalc
from radcalc.api.arguments import AT_A_SHELL, keyword
from radcalc.calculators import COMMANDS

STUB = runpy.run_path(str(ROOT / "docs" / "stub.py"))
FUNCTIONS = [name for name in radcalc.__all__ if inspect.isfunction(getattr(radcalc, name))]


@for_each(FUNCTIONS)
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


def test_every_command_is_a_function_or_for_a_shell_only():
    functions = {keyword(name) for name in COMMANDS if name not in AT_A_SHELL}
    others = {"ask", "check", "define", "explain", "factor", "irradiance_map"}
    assert functions | others == {*FUNCTIONS}
    assert {*AT_A_SHELL} < {*COMMANDS}


def test_the_stub_has_the_signatures_of_the_functions():
    """Run `python docs/stub.py` if it is outdated."""
    assert STUB["PATH"].read_text(encoding="utf-8") == STUB["text"]()


@for_each(FUNCTIONS)
def test_a_function_is_kept_by_pickle_and_has_types_at_run_time(name):
    function = getattr(radcalc, name)
    assert pickle.loads(pickle.dumps(function)) is function
    assert get_type_hints(function).keys() == {*inspect.signature(function).parameters, "return"}


def test_units_are_those_of_the_kinds_that_a_calculator_takes():
    assert "[W/m2/sr, cd/m2, umol/m2/s/sr]" in radcalc.screen.__doc__
    assert "Flux on the body. [W]" in radcalc.calorimeter.__doc__
    assert "Photopic luminance. [cd/m2]" in radcalc.mesopic.__doc__


def test_arguments_that_a_function_does_not_take_are_a_type_error():
    problem = r"laser\(\) got an unexpected keyword argument 'powre'; its parameters are amounts, "
    with pytest.raises(TypeError, match=problem):
        radcalc.laser(powre="1 W")
    with pytest.raises(TypeError, match=r"photon\(\) too many positional arguments"):
        radcalc.photon("555 nm", "1 W")


def test_help_reads_as_a_manual():
    text = pydoc.render_doc(radcalc.point_source, renderer=pydoc.plaintext)
    assert "point_source(*amounts, flux=..., distribution=..., distance=..., ...)" in text
    assert "Receiver:\n" in text  # a group of parameters
    assert "Straight line from the source to the receiver. [m]" in text
    assert "`height`" in text  # the form of keywords


@for_each(FUNCTIONS)
def test_no_docstring_spells_an_option(name):
    assert not re.search(r"(?<!-)--[a-z]", getattr(radcalc, name).__doc__)
