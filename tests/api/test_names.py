"""The names of radcalc: what dir(), help() and a wrong name show."""

import inspect
import pydoc
import re
import rlcompleter
import runpy

import pytest
from conftest import ROOT, python
from helpers import for_each

import radcalc
from radcalc.api.result import names_of

STUB = runpy.run_path(str(ROOT / "docs" / "stub.py"))
FUNCTIONS = [name for name in radcalc.__all__ if inspect.isfunction(getattr(radcalc, name))]
LAMP = radcalc.point_source(intensity="100 cd", distance="2 m")


def completions(text, **names):
    """Return what Tab shows after a text in Python's own interpreter."""
    completer = rlcompleter.Completer(names)
    return {found.rstrip("()") for k in range(1000) if (found := completer.complete(text, k))}


def test_dir_and_tab_show_the_public_names_alone():
    assert dir(radcalc) == sorted(radcalc.__all__)
    shown = {f"radcalc.{name}" for name in radcalc.__all__ if name[0] != "_"}
    assert completions("radcalc.", radcalc=radcalc) == shown


def test_tab_shows_the_quantities_of_a_result_and_no_tools_of_the_package():
    names = {name.removeprefix("lamp.") for name in completions("lamp.", lamp=LAMP)}
    mapping = {"get", "items", "keys", "values"}
    others = {"assumptions", "command", "inputs", "notes", "plot", "rows", "steps", "to_dict"}
    assert {"illuminance", "irradiance", "distance"} <= names
    assert names == {*dir(LAMP)} == {*names_of(LAMP), *others, *mapping}


def test_help_begins_with_the_functions():
    text = pydoc.render_doc(radcalc, renderer=pydoc.plaintext)
    head = text.partition("PACKAGE CONTENTS")[0]
    assert all(re.search(rf"^ +{name} +[A-Z]", head, re.MULTILINE) for name in FUNCTIONS)
    assert head.index("convert ") < head.index("uberlight ")


def test_the_docstring_has_the_present_functions():
    """Run `python docs/stub.py` if it is outdated."""
    module = STUB["PACKAGE"].read_text(encoding="utf-8")
    assert STUB["with_lists"](module) == module
    outdated = re.sub(r"^(ask|sky) .*\n", "", module, flags=re.MULTILINE)
    assert outdated != module
    assert STUB["with_lists"](outdated) == module


@for_each(FUNCTIONS)
def test_help_of_a_function_begins_with_a_readable_line(name):
    text = pydoc.render_doc(getattr(radcalc, name), renderer=pydoc.plaintext)
    head = text.split("\n")[2]
    assert head.startswith(f"{name}(")
    assert " -> " in head
    assert len(head) <= 120


def test_a_name_that_does_not_exist_is_left_to_python():
    with pytest.raises(AttributeError) as caught:
        radcalc.zork  # noqa: B018
    assert str(caught.value) == "module 'radcalc' has no attribute 'zork'"
    assert not hasattr(radcalc, "zork")
    done = python("from radcalc import lux_to_fc")
    assert "ImportError: cannot import name 'lux_to_fc' from 'radcalc'" in done.stderr
    assert "Did you mean: 'convert'?" in python("import radcalc; radcalc.covnert").stderr


def test_an_import_of_a_module_loads_no_more_than_the_module():
    code = "import sys; from radcalc import maths; print({'numpy', 'pint'} & {*sys.modules})"
    assert python(code).stdout == "set()\n"
