"""Allowed imports between packages, and modules that a command must not load."""

import ast
import json
import re
import shlex
import shutil
from collections.abc import Iterator
from functools import cache

import pytest
from conftest import ROOT, python
from helpers import for_each

from radcalc.calculators import COMMANDS
from radcalc.cli.command import OTHERWISE
from radcalc.completion.rows import module_text
from radcalc.laws import point
from radcalc.quantities.symbols import DIRECTION, DISTRIBUTIONS, OBSERVER_NAMES, SYMBOLS
from radcalc.spectra.observers import OBSERVERS

PACKAGE = ROOT / "radcalc"
MODULES = {
    ".".join(path.relative_to(ROOT).with_suffix("").parts).removesuffix(".__init__"): path
    for path in PACKAGE.rglob("*.py")
}
# Only these may import the package on the left.
KEEPERS = {
    "click": ("radcalc.cli",),
    "rich": ("radcalc.render.table",),
    "pint": ("radcalc.units.registry",),
    "colour": ("radcalc.spectra.colorimetry",),
    "prompt_toolkit": ("radcalc.cli.prompt",),
    "dask": ("radcalc.api.columns",),
    "plotille": ("radcalc.plots.sheet",),
    "matplotlib": ("radcalc.plots.figure",),
    "OpenEXR": ("radcalc.distributions.maps.exr",),
    "pvlib": ("radcalc.streams.solar", "radcalc.inputs.sun"),
    "pandas": ("radcalc.streams.solar", "radcalc.inputs.sun"),
    "uncertainties": ("radcalc.units.uncertain",),
    "numpy": (
        "radcalc.maths",
        "radcalc.units.ranges",
        "radcalc.api",
        "radcalc.spectra.observers",
        "radcalc.streams.calculated",
        "radcalc.spectra.arrays",
        "radcalc.spectra.compile",
        "radcalc.spectra.files",
        "radcalc.spectra.colorimetry",
        "radcalc.geometry",
        "radcalc.distributions",
        "radcalc.plots.figure",
        "radcalc.plots.space",
    ),
}
PICTURE = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8").split("```text\n")[1]
# Imports point downwards: a room may import rooms below it, and those after it in its row.
LAYERS = [
    ["radcalc.__main__"],
    *(
        [f"radcalc.{room}" for room in line.partition("  ")[0].split()]
        for line in PICTURE.partition("\n```")[0].splitlines()
    ),
    ["radcalc._version"],
]
ROOMS = [room for row in LAYERS for room in row]
IMPORTERS = ("import_module", "__import__")


def statements(node: ast.AST) -> Iterator[ast.AST]:
    """Yield the statements of a tree, without expressions: tables have very many."""
    for child in ast.iter_child_nodes(node):
        if not isinstance(child, ast.expr):
            yield child
            yield from statements(child)


@cache
def tree_of(name: str) -> ast.Module:
    """Return the syntax tree of a module, without code for type checkers only."""
    tree = ast.parse(MODULES[name].read_text(encoding="utf-8"))
    for node in statements(tree):
        if isinstance(node, ast.If) and getattr(node.test, "id", "") == "TYPE_CHECKING":
            node.body = []
    return tree


@cache
def imports(name: str) -> set[str]:
    """Return everything that a module imports anywhere, except for type checking."""
    found = set()
    for node in statements(tree_of(name)):
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.module:
            found.add(node.module)
            found |= {f"{node.module}.{alias.name}" for alias in node.names}
    return found | named_modules(name)


def named_modules(name: str) -> set[str]:
    """Return the modules that a module imports by a name given as a string."""
    found = set()
    for node in ast.walk(tree_of(name)):
        if isinstance(node, ast.Call) and ast.unparse(node.func).endswith(IMPORTERS):
            found |= {arg.value for arg in node.args[:1] if isinstance(arg, ast.Constant)}
    return found


def modules_of(name: str) -> set[str]:
    """Return radcalc's modules that a module imports anywhere, except for type checking."""
    found = set()
    for node in statements(tree_of(name)):
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.module:
            inner = {f"{node.module}.{alias.name}" for alias in node.names}
            found |= inner & MODULES.keys()
            if inner - MODULES.keys():
                found.add(node.module)  # a function or a constant of the module itself
    return (found | named_modules(name)) & MODULES.keys()


def room(name: str) -> int | None:
    for depth, member in enumerate(ROOMS):
        if name == member or name.startswith(member + "."):
            return depth
    return None


@pytest.mark.parametrize("package", KEEPERS)
def test_a_heavy_package_is_imported_in_its_own_room_only(package):
    for name in MODULES:
        if any(i == package or i.startswith(package + ".") for i in imports(name)):
            assert name.startswith(KEEPERS[package]), name


@for_each(sorted(set(MODULES) - {"radcalc"}))
def test_imports_point_downwards(name):
    depth = room(name)
    assert depth is not None, f"{name} belongs to no layer"
    for imported in imports(name):
        below = room(imported)
        assert below is None or below >= depth, imported


def test_there_are_few_layers_and_few_loose_modules():
    assert 10 < len(LAYERS) < 18
    assert len([path for path in PACKAGE.glob("*.py") if path.stem != "__init__"]) <= 10


def test_there_are_no_circular_imports():
    edges = {name: modules_of(name) for name in MODULES}
    assert sum(map(len, edges.values())) > 300
    left = set(edges)
    while loadable := {name for name in left if not edges[name] & left}:
        left -= loadable
    assert not left, "these import each other, or one that does"


OPTION = re.compile(r"(?<![\w-])--(?!no-deps\b)[a-z]")  # --no-deps is an option of pip


def texts_of(tree: ast.Module) -> list[str]:
    """Return the string literals of a module, with parts of f-strings, without docstrings."""
    documented = (ast.Module, ast.ClassDef, ast.FunctionDef)
    docstrings = {
        id(node.body[0].value)
        for node in (tree, *statements(tree))
        if isinstance(node, documented) and node.body and isinstance(node.body[0], ast.Expr)
    }
    return [
        node.value
        for node in ast.walk(tree)
        if isinstance(node, ast.Constant)
        and isinstance(node.value, str)
        and id(node) not in docstrings
    ]


def test_a_text_that_spells_an_option_is_found():
    text = "def f(x):\n    'no --a'\n    return f'{x} --bee', 'a-b', '--', 'a--b', 'e --f'"
    assert [one for one in texts_of(ast.parse(text)) if OPTION.search(one)] == ["e --f", " --bee"]


@for_each([name for name in MODULES if not name.startswith(("radcalc.cli", "radcalc.completion"))])
def test_no_option_is_spelled_outside_the_command_line(name):
    assert [text for text in texts_of(tree_of(name)) if OPTION.search(text)] == []


def test_the_vocabulary_has_the_names_of_observers_and_distributions():
    """The vocabulary repeats them because it must not import the tables and the laws."""
    assert tuple(OBSERVERS) == OBSERVER_NAMES
    assert tuple(point.LAWS) == DISTRIBUTIONS == (point.ISOTROPIC, point.CONICAL, point.LOBED)


def test_the_vocabulary_names_no_commands():
    """A meaning that a symbol has in one command only is on the page of that command."""
    tree = tree_of("radcalc.quantities.symbols")
    keywords = {node.arg for node in ast.walk(tree) if isinstance(node, ast.keyword)}
    assert not keywords & {name.replace("-", "_") for name in COMMANDS if name != "help"}
    others = {"photon", DIRECTION}  # a unit, and a form
    assert not set(texts_of(tree)) & (COMMANDS.keys() - SYMBOLS.keys() - others)


HEAVY = {"click", "numpy", "pint", "rich", "colour", "dask", "scipy", "uncertainties"}
HEAVY |= {"prompt_toolkit", "plotille", "matplotlib"}
SLOW = {"re", "dataclasses", "typing", "json", "enum", "collections", "functools", "inspect"}
PROBE = """
import os, sys
before = set(sys.modules)
from radcalc.__main__ import run
run(sys.argv[1:])
loaded = set(sys.modules) - before
import json
os.write(2, ("\\n" + json.dumps(sorted(loaded))).encode())
"""

# The same for many calls in one interpreter: the modules loaded after each of them.
PROBE_OF_ALL = """
import json, os, sys
from radcalc.__main__ import run
before = set(sys.modules)
loaded = []
for words in json.loads(sys.argv[1]):
    run(words)
    loaded.append(sorted(set(sys.modules) - before))
os.write(2, ("\\n" + json.dumps(loaded)).encode())
"""


def loaded_by(*words: str) -> set[str]:
    """Return the modules that a run of radcalc loads in addition to a bare interpreter's."""
    done = python(PROBE, *words)
    return set(json.loads(done.stderr.splitlines()[-1]))


@pytest.mark.parametrize("words", ["convert 100 lx fc", "100 lx fc", "100 lx in fc"])
def test_a_plain_conversion_into_a_pipe_loads_few_modules(words):
    loaded = loaded_by(*words.split())
    assert not loaded & (HEAVY | SLOW)
    assert loaded - MODULES.keys() <= {"gc", "math"}


def test_lines_are_converted_without_click():
    assert not loaded_by("convert", "-", "lx", "fc", "--field", "2", "-d", ",") & HEAVY


SCALARS = """
    convert 5 mW lm --wavelength 632.8nm
    convert 800 lm cd --isotropic
    convert 800 lm cd --half-angle 30deg --steps
    convert 100 lx fc --json
    convert 800 lm cd
    convert 250 cd/m2
    units lambert
    quantities 'svítivost'
    typical sun
    examples
    examples museum
    photon 555nm
    convert 1000 lx W/m2 --spectrum D65
    convert 1000 lx umol/m2/s --spectrum AM1.5G
    spectrum blackbody:2856K -g luminous-efficacy:lm/W
    spectrum --list
    spectrum D65
    mesopic --luminance 0.1cd/m2 --spectrum LED-B3
    photon 400nm:700nm:10nm -g photon-energy:eV
    solid-angle cone --half-angle 30deg
    solid-angle sphere --radius 695700km --distance 1au
    solid-angle zone --polar 30deg:60deg
    solid-angle disc --radius 1m --height 1m --offset 0m:2m:0.5m
    solid-angle polygon 1,0,0 0,1,0 0,0,1 --normal 0,1,-1
    solid-angle pixel --size 64x64 --pixel 9,9 --projection angular
    direction 1 1 1
    direction --mirror-ball 0.6,0
    direction 0 0 1 --reflect-at 1,0,1
    etendue --area 1mm2 --half-angle 90deg
    point-source --flux 800lm --distance 2m
    point-source --beam-angle 30deg
    uberlight 0,0,4 --intensity 100cd
    sky overcast --zenith-luminance 9000cd/m2 --tilt 90deg
    sky clear --sun-elevation 40deg --horizontal-illuminance 12klx
    convert 1 W/sr W --area 20mm2 --distance 1m
    lambertian --luminance 1e4cd/m2 --area 1cm2 --height 1m
    lambertian disc --luminance 1e4cd/m2 --radius 25cm --height 75cm --offset 10cm
    ev --f-number 16 --time 1/100s
    calorimeter --mass 10g --specific-heat 385J/kg/K --temperature-rise 2K --time 30s
    sensor --luminance 100cd/m2 --f-number 2.8 --wavelength 550nm
    laser --flux 5mW --diameter 1mm --receiver-diameter 7mm
    room --width 6m --length 9m --height 2m
    convert - lx fc
    convert - lx W/m2 --spectrum D65 --field 2 -d ,
    convert - fc --json
    point-source --intensity 100cd --distance '- m' -g irradiance
"""


def test_a_scalar_answer_into_a_pipe_loads_neither_pint_nor_numpy_nor_rich():
    calls = [shlex.split(line) for line in SCALARS.split("\n") if line]
    done = python(PROBE_OF_ALL, json.dumps(calls))
    loaded = json.loads(done.stderr.splitlines()[-1])
    assert len(loaded) == len(calls) > 40
    assert "click" in loaded[-1]
    for words, modules in zip(calls, loaded, strict=True):
        assert not HEAVY & {*modules} - {"click"}, words


@for_each(
    [
        "point-source --intensity 100cd --distance 2m",
        "laser --flux 5mW --diameter 1mm -g irradiance",
        "ev --f-number 16 --time 1/100s --json",
        "photon 555nm",
        "mesopic --luminance 0.1cd/m2 --spectrum LED-B3",
        "lambertian disc --luminance 1e4cd/m2 --radius 25cm --height 75cm",
        "convert 800 lm cd --isotropic",
    ]
)
def test_a_lane_of_a_calculator_into_a_pipe_does_not_load_click(call):
    assert not HEAVY & loaded_by(*call.split())


@for_each(["20000 cd at 8 m to lx", "1200 lm isotropic to cd", "ev100 12 to nits"])
def test_a_sentence_into_a_pipe_does_not_load_click(sentence):
    assert not HEAVY & loaded_by(*sentence.split())


OF_COMMANDS = {
    f"radcalc.{room}.{OTHERWISE.get(name, name).replace('-', '_')}"
    for room in ("cli", "calculators")
    for name in COMMANDS
}


@pytest.fixture(scope="module")
def installed(tmp_path_factory):
    """Return a folder with the package as in a wheel, with the completion table."""
    folder = tmp_path_factory.mktemp("installed")
    shutil.copytree(PACKAGE, folder / "radcalc", ignore=shutil.ignore_patterns("__pycache__"))
    table = folder / "radcalc" / "completion" / "built.py"
    table.write_text(module_text(), encoding="utf-8")
    return folder


@pytest.mark.parametrize(
    ("shell", "line", "found", "left_out"),
    [
        ("bash", "radcalc ", "typical", SLOW),
        ("zsh", "radcalc --", "--version", SLOW),
        ("fish", "radcalc lambertian --lum", "--luminous-flux", SLOW),
        ("bash", "radcalc point-source --distance 2c", "2cm", SLOW),
        ("bash", "radcalc point-source -g illum", "illuminance", SLOW),
        ("bash", "radcalc convert 5 mW lm --spectrum LED-B", "LED-B3", SLOW),
        ("bash", "radcalc 100 lx ", "fc", set()),
        ("bash", "radcalc 800 lm lx --isotropic ", "--distance", set()),
    ],
)
def test_completing_a_word_imports_neither_commands_nor_click(
    shell, line, found, left_out, installed, monkeypatch
):
    monkeypatch.chdir(installed)  # python -c puts it first on the path
    monkeypatch.setenv("_RADCALC_COMPLETE", f"{shell}_complete")
    monkeypatch.setenv("COMP_LINE", line)
    done = python(PROBE)
    assert found in done.stdout
    assert not set(json.loads(done.stderr.splitlines()[-1])) & (OF_COMMANDS | HEAVY | left_out)


def test_import_radcalc_costs_nothing():
    done = python(
        "import sys; before = set(sys.modules); import radcalc; "
        "print(sorted(set(sys.modules) - before))"
    )
    assert ast.literal_eval(done.stdout) == ["radcalc"]
