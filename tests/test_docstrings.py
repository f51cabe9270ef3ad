"""Docstrings of geometry and laws: they are complete and their examples run."""

import ast
import doctest
import importlib
import inspect
import pkgutil
import re
import textwrap
from collections.abc import Callable, Iterator
from types import ModuleType
from typing import Any

import pytest
from helpers import for_each

SECTION = re.compile(r"^(\w[\w ]*)\n-{3,}$", re.MULTILINE)
ROOMS = ("radcalc.geometry", "radcalc.laws")


def modules(package: str) -> Iterator[ModuleType]:
    """Yield a package and all its modules, recursively."""
    root = importlib.import_module(package)
    yield root
    for found in pkgutil.walk_packages(root.__path__, f"{package}."):
        yield importlib.import_module(found.name)


def public() -> Iterator[tuple[str, Any]]:
    """Yield the public functions, classes and methods of the packages, with their full names."""
    for module in (module for room in ROOMS for module in modules(room)):
        for name, found in vars(module).items():
            if name.startswith("_") or getattr(found, "__module__", "") != module.__name__:
                continue
            if inspect.isfunction(found) or inspect.isclass(found):
                yield f"{module.__name__}.{name}", found
            if inspect.isclass(found):
                for part, method in vars(found).items():
                    if inspect.isfunction(method) and not part.startswith("_"):
                        yield f"{module.__name__}.{name}.{part}", method


PUBLIC = dict(public())
FUNCTIONS = {name: found for name, found in PUBLIC.items() if inspect.isfunction(found)}
CLASSES = {name: found for name, found in PUBLIC.items() if inspect.isclass(found)}
MODULES = {m.__name__: m for package in ROOMS for m in modules(package)}
EXAMPLES = {
    found.name: found
    for module in (*MODULES.values(), *modules("radcalc.distributions"))
    for found in doctest.DocTestFinder().find(module)
    if found.examples
}


def sections(documented: Any) -> dict[str, str]:
    """Return the sections of a docstring by heading; the text before them is under ''."""
    first, *rest = SECTION.split(inspect.cleandoc(documented.__doc__ or ""))
    return {"": first} | dict(zip(rest[::2], rest[1::2], strict=True))


def entries(text: str) -> set[str]:
    """Return the names that a section documents: one or more per unindented line.

    A line that ends in a colon is the title of a group.
    """
    lines = [line for line in text.splitlines() if line and not line.startswith(" ")]
    lines = [line for line in lines if not line.endswith(":")]
    return {name.strip() for line in lines for name in line.partition(":")[0].split(",")}


def errors_of(function: Callable[..., Any], seen: set[Any] | None = None) -> set[str]:
    """Return the names of the errors that a function raises, directly or through its calls."""
    seen = set() if seen is None else seen
    if function in seen:
        return set()
    seen.add(function)
    tree = ast.parse(textwrap.dedent(inspect.getsource(function)))
    scope = dict(inspect.getmodule(function).__dict__)
    found: set[str] = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom):  # imported where it is used
            module = importlib.import_module(node.module or "")
            scope |= {
                alias.asname or alias.name: getattr(module, alias.name) for alias in node.names
            }
    for node in ast.walk(tree):
        used: Any = None
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
            used = scope.get(node.func.id)
            if inspect.isclass(used) and issubclass(used, Exception):
                found.add(used.__name__)
        elif isinstance(node, ast.Name):  # called, or passed as an argument
            used = scope.get(node.id)
        elif isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name):
            used = getattr(scope.get(node.value.id), node.attr, None)
        if inspect.isfunction(used) and used.__module__.startswith(ROOMS):
            found |= errors_of(used, seen)
    caught = {
        name.id
        for node in ast.walk(tree)
        if isinstance(node, ast.ExceptHandler) and node.type
        for name in ast.walk(node.type)
        if isinstance(name, ast.Name)
    }
    return found - caught


@for_each(MODULES)
def test_every_module_has_a_docstring(name):
    assert (MODULES[name].__doc__ or "").strip()


@for_each(EXAMPLES)
def test_the_examples_run(name):
    report: list[str] = []
    failed, tried = doctest.DocTestRunner(verbose=False).run(EXAMPLES[name], out=report.append)
    assert tried
    assert not failed, "".join(report)


@for_each(sorted(PUBLIC))
def test_every_docstring_has_a_summary_of_one_sentence_and_an_example(name):
    documented = sections(PUBLIC[name])
    summary = documented[""].split("\n\n")[0]
    assert summary.endswith(".")
    assert "\n" not in summary
    assert ">>> " in documented.get("Examples", "")
    order = ["Parameters", "Attributes", "Returns", "Raises", "Notes", "References", "Examples"]
    headings = [heading for heading in documented if heading]
    assert headings == [heading for heading in order if heading in headings]


@for_each(sorted(FUNCTIONS))
def test_every_parameter_and_return_value_is_documented(name):
    function, documented = FUNCTIONS[name], sections(FUNCTIONS[name])
    signature = inspect.signature(function)
    assert entries(documented.get("Parameters", "")) == set(signature.parameters) - {"self"}
    if signature.return_annotation is None:
        assert "Returns" not in documented
    else:
        assert documented["Returns"].strip()


@for_each(sorted(FUNCTIONS))
def test_every_error_that_is_raised_is_documented(name):
    assert errors_of(FUNCTIONS[name]) <= entries(sections(FUNCTIONS[name]).get("Raises", ""))


@pytest.mark.parametrize("name", sorted(CLASSES))
def test_the_parameters_and_attributes_of_a_class_are_documented(name):
    documented = sections(CLASSES[name])
    fields = set(getattr(CLASSES[name], "_fields", ()))
    assert entries(documented.get("Attributes", "")) >= fields
    if not fields:
        taken = set(inspect.signature(CLASSES[name]).parameters)
        assert entries(documented["Parameters"]) == taken
        assert errors_of(CLASSES[name]) <= entries(documented.get("Raises", ""))


def test_the_helpers_of_these_tests_find_functions_and_errors():
    from radcalc import geometry
    from radcalc.geometry import projections, solid

    assert len(FUNCTIONS) > 60
    assert {"radcalc.laws.law", "radcalc.laws.solver.solve"} <= FUNCTIONS.keys()
    assert errors_of(projections.spherical) == {"ConditionError"}  # directly
    assert errors_of(geometry.cone) == {"ConditionError"}  # through `refuse`
    assert errors_of(solid.projected_sphere) == {"ConditionError"}  # through another module
    assert errors_of(solid.rectangle) == {"ConditionError"}  # through an import in the function
    assert errors_of(geometry.facing) == set()
