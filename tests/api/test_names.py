"""The names of radcalc: what dir(), help() and a wrong name show."""

import builtins
import inspect
import pydoc
import re
import rlcompleter

import pytest
from conftest import python
from helpers import for_each

import radcalc
from radcalc.api import stub
from radcalc.api.result import names_of

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
    """Run `python -m radcalc.api.stub` if it is outdated."""
    module = stub.PACKAGE.read_text(encoding="utf-8")
    assert stub.with_lists(module) == module
    outdated = re.sub(r"^(ask|sky) .*\n", "", module, flags=re.MULTILINE)
    assert outdated != module
    assert stub.with_lists(outdated) == module


@for_each(FUNCTIONS)
def test_help_of_a_function_begins_with_a_readable_line(name):
    text = pydoc.render_doc(getattr(radcalc, name), renderer=pydoc.plaintext)
    head = text.split("\n")[2]
    assert head.startswith(f"{name}(")
    assert " -> " in head
    assert len(head) <= 120


# A name, the call that is proposed, and its answer: 1 lm/m2 in lm/ft2; h c / (555 nm);
# 1 lm / (4 pi sr); 1 dBm = 10^0.1 mW; h c / (1 nm); 800 lm / (4 pi sr) / (2 m)^2;
# 2 pi (1 - cos 30 deg) sr; the peak of D65 in the CIE's table.
MEANT = {
    "lux_to_fc": ('radcalc.convert("1 lux", "fc")', 0.3048**2),
    "photon_energy": ('radcalc.photon("555 nm").photon_energy', 1239.8419843320026 / 555),
    "lumens_to_candela": (
        'radcalc.convert("1 lumens", "candela", isotropic=True)', 0.07957747154594767),
    "dbm_to_watt": ('radcalc.convert("1 dBm", "watt")', 0.0012589254117941673),
    "nm2ev": ('radcalc.convert("1 nm", "eV")', 1239.8419843320026),
    "illuminance": (
        'radcalc.point_source(flux="800 lm", distance="2 m").illuminance', 15.915494309189533),
    "convert_units": ("help(radcalc.convert)", None),
    "pointsource": ('radcalc.point_source(flux="800 lm", distance="2 m")', None),
    "blackbody": ('radcalc.spectrum("blackbody:5772K")', None),
    "cone": ('radcalc.solid_angle("cone", half_angle="30 deg")', 0.8417872144769194),
    "D65": ('radcalc.spectrum("D65")', 460),
    "lux": ('radcalc.Quantity("1 lux")', None),
}  # fmt: skip


@for_each(MEANT)
def test_a_name_that_does_not_exist_is_refused_with_the_call_that_answers(name):
    call, answer = MEANT[name]
    with pytest.raises(AttributeError) as caught:
        getattr(radcalc, name)
    first, tried, *below = str(caught.value).splitlines()
    assert first == f"module 'radcalc' has no attribute '{name}'"
    assert tried == f"try: {call}"
    if answer is not None:
        (number,) = re.findall(r"(?<![\w.])\d[\d.]*(?!\w)", below[0])
        assert float(number) == pytest.approx(answer, rel=1e-5)
    if not call.startswith("help"):
        assert eval(call, {"radcalc": radcalc, **vars(builtins)}) is not None


def test_a_name_that_means_nothing_is_left_to_python():
    with pytest.raises(AttributeError) as caught:
        radcalc.zork  # noqa: B018
    assert str(caught.value) == "module 'radcalc' has no attribute 'zork'"
    assert not hasattr(radcalc, "zork")


def test_an_import_of_such_a_name_has_the_hint_too():
    done = python("from radcalc import lux_to_fc")
    assert "ImportError: cannot import name 'lux_to_fc' from 'radcalc'" in done.stderr
    assert 'try: radcalc.convert("1 lux", "fc")' in done.stderr


def test_an_import_of_a_module_loads_no_more_than_the_module():
    code = "import sys; from radcalc import maths; print({'numpy', 'pint'} & {*sys.modules})"
    assert python(code).stdout == "set()\n"
