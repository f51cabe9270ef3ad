"""The limits of the house: lines of each room, files, imports, long functions, the root.

A higher number in `budget.tsv` needs its reason in the message of the commit.
"""

import ast
import io
import subprocess
import tokenize
from collections import Counter
from functools import cache
from pathlib import Path

import pytest
from conftest import ROOT

MOST_FILES = 220
MOST_IMPORTS = 0.09  # of the lines
LONGEST, MOST_BRANCHES = 60, 20  # lines and branches of a function
DOCUMENTED = 15  # lines of a function that needs no docstring
TABLES = ("units/compiled.py", "units/catalogue.py", "completion/table.py", "completion/built.py")
LAYOUT = {
    *(tokenize.COMMENT, tokenize.NL, tokenize.NEWLINE),
    *(tokenize.INDENT, tokenize.DEDENT, tokenize.ENDMARKER),
}
BRANCHES = (
    *(ast.If, ast.For, ast.While, ast.IfExp, ast.ExceptHandler),
    *(ast.And, ast.Or, ast.comprehension, ast.match_case),
)
IN_ROOT = {
    *(".ci", ".gitignore", "CHANGELOG.md", "CITATION.cff", "CONTRIBUTING.md", "LICENSE"),
    *("LICENSES", "NOTICE.md", "README.md", "SECURITY.md", "bin", "docs", "examples", "findings"),
    *("hatch_build.py", "man", "pyproject.toml", "radcalc", "tests"),
}
BUDGET = dict(
    line.split("\t") for line in (ROOT / "tests" / "budget.tsv").read_text("utf-8").splitlines()[1:]
)


@cache
def modules() -> list[Path]:
    found = sorted((ROOT / "radcalc").rglob("*.py"))
    return [p for p in found if "/data/" not in p.as_posix() and not p.as_posix().endswith(TABLES)]


@cache
def read(path: Path) -> tuple[ast.Module, frozenset[int]]:
    """Return the tree of a module, and its lines of code: without docstrings and comments."""
    text = path.read_text(encoding="utf-8")
    tree = ast.parse(text)
    lines: set[int] = set()
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type not in LAYOUT:
            lines.update(range(token.start[0], token.end[0] + 1))
    for node in ast.walk(tree):
        is_scope = isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef)
        if is_scope and ast.get_docstring(node) is not None:
            lines.difference_update(range(node.body[0].lineno, node.body[0].end_lineno + 1))
    return tree, frozenset(lines)


def functions():
    for path in modules():
        tree, lines = read(path)
        for node in ast.walk(tree):
            if isinstance(node, ast.FunctionDef):
                size = sum(node.lineno <= line <= node.end_lineno for line in lines)
                yield f"{path.name}: {node.name}", node, size


def room_of(path: Path) -> str:
    return path.parent.relative_to(ROOT).as_posix()


def test_no_room_has_more_lines_than_its_budget():
    sizes: Counter[str] = Counter()
    for path in modules():
        sizes[room_of(path)] += len(read(path)[1])
    assert sizes.keys() == BUDGET.keys()
    assert {room: size for room, size in sizes.items() if size > int(BUDGET[room])} == {}


def test_there_are_few_files():
    every = [*(ROOT / "radcalc").rglob("*.py")]
    assert len([path for path in every if path.name != "built.py"]) <= MOST_FILES


def test_few_lines_are_imports():
    imports = total = 0
    for path in modules():
        tree, lines = read(path)
        found = [n for n in ast.walk(tree) if isinstance(n, ast.Import | ast.ImportFrom)]
        imports += len({line for n in found for line in range(n.lineno, n.end_lineno + 1)})
        total += len(lines)
    assert imports <= MOST_IMPORTS * total


def test_no_function_is_long_or_has_many_branches():
    for name, node, size in functions():
        branches = 1 + sum(isinstance(part, BRANCHES) for part in ast.walk(node))
        assert size <= LONGEST, name
        assert branches <= MOST_BRANCHES, name


def test_each_function_of_many_lines_has_a_docstring():
    def lacks(node):
        lines = node.end_lineno - node.lineno + 1
        return lines > DOCUMENTED and node.name != "__init__" and not ast.get_docstring(node)

    assert [name for name, node, _ in functions() if lacks(node)] == []


def test_the_root_has_no_stray_files():
    listed = ["git", "ls-files", "-z"]
    done = subprocess.run(listed, cwd=ROOT, capture_output=True, text=True, check=False)
    if done.returncode or not done.stdout:
        pytest.skip("the tree is not a checkout")
    assert {name.partition("/")[0] for name in done.stdout.split("\0") if name} <= IN_ROOT
