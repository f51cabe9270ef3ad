"""Random mutants of the core, in a copy of the tree, and those that no test detects.

    python tests/mutation.py [--count N] [--seed S] [--skip N] [PATH ...]
    python tests/mutation.py --count 0       check that the unchanged tree passes

A mutant has one change in one file: a comparison inverted, an operator exchanged, a number
changed, a condition negated, a sign dropped, `and` for `or`, None returned, a statement deleted.
The transcripts of `cases/` run first, in one process; then the tests of the file's folder, those
with the file's name first; then `LAST`.  A mutant that survives all of them is shown as a diff.
"""

import argparse
import ast
import contextlib
import copy
import difflib
import io
import json
import os
import random
import shlex
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from unittest.mock import patch

HERE = Path(__file__).resolve().parent
CORE = ["units", "quantities", "conversion", "laws", "calculators", "geometry", "spectra"]
CORE += ["homework", "inputs", "streams", "render", "answer.py", "answer.py", "maths.py"]
GENERATED = ("compiled.py", "catalogue.py", "compile.py", "registry.py")
LAST = ["test_api.py", "test_refusals.py", "calculators"]
TOO_LONG = 1800  # s for a stage: an endless mutant counts as detected
SWAPS: dict[type, type] = {
    ast.Lt: ast.LtE, ast.LtE: ast.Lt, ast.Gt: ast.GtE, ast.GtE: ast.Gt, ast.Eq: ast.NotEq,
    ast.NotEq: ast.Eq, ast.In: ast.NotIn, ast.NotIn: ast.In, ast.Is: ast.IsNot, ast.IsNot: ast.Is,
    ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Div, ast.Div: ast.Mult, ast.Pow: ast.Mult,
    ast.FloorDiv: ast.Mult, ast.Mod: ast.FloorDiv, ast.BitOr: ast.BitAnd, ast.BitAnd: ast.BitOr,
    ast.And: ast.Or, ast.Or: ast.And,
}  # fmt: skip


def turned(op: ast.AST) -> ast.AST:
    return SWAPS[type(op)]() if type(op) in SWAPS else op


def mutated(node: ast.AST) -> ast.AST | None:
    """Return the node with one change, or None if there is no change for this node."""
    new = copy.deepcopy(node)
    match new:
        case ast.Compare():
            new.ops[0] = turned(new.ops[0])
        case ast.BinOp() | ast.AugAssign() | ast.BoolOp():
            new.op = turned(new.op)
        case ast.Constant(value=int() | float()) if not isinstance(new.value, bool):
            new.value = new.value + 1 if isinstance(new.value, int) else new.value * 1.1 or 1.0
        case ast.UnaryOp(op=ast.USub() | ast.Not()):
            return new.operand
        case ast.IfExp() | ast.If() | ast.While():
            return ast.UnaryOp(ast.Not(), new.test)
        case ast.Return(value=ast.expr()):
            return ast.Return(ast.Constant(None))
        case ast.Expr(value=ast.Call()) | ast.Assign(targets=[ast.Subscript()]) | ast.Raise():
            return ast.Pass()
        case _:
            return None
    return new if ast.dump(new) != ast.dump(node) else None


def places(tree: ast.AST) -> Iterator[ast.AST]:
    """Yield the nodes to mutate: neither annotations nor messages of errors."""
    for node in ast.iter_child_nodes(tree):
        if mutated(node):
            yield node
        if isinstance(node, ast.Raise | ast.JoinedStr):
            continue
        if isinstance(node, ast.AnnAssign):
            node = node.value or ast.Pass()
        yield from places(node)


def replaced(source: str, node: ast.AST) -> str:
    """Return the source with the node replaced by its mutant."""
    new = mutated(node)
    if isinstance(node, ast.If | ast.While | ast.IfExp):
        node = node.test
    text = f"({ast.unparse(new)})" if isinstance(new, ast.expr) else ast.unparse(new)
    lines = source.encode().splitlines(keepends=True)
    start = sum(map(len, lines[: node.lineno - 1])) + node.col_offset
    end = sum(map(len, lines[: node.end_lineno - 1])) + node.end_col_offset
    return (source.encode()[:start] + text.encode() + source.encode()[end:]).decode()


def mutants(root: Path, seed: int, paths: list[str]) -> Iterator[tuple[Path, str]]:
    """Yield files and their text with one change, each change once."""
    found = []
    for path in sorted(x for part in paths for x in (root / "radcalc" / part,)):
        for file in sorted(path.rglob("*.py")) if path.is_dir() else [path]:
            if file.name not in GENERATED and "data" not in file.parts:
                found += [(file, node) for node in places(ast.parse(file.read_text()))]
    random.Random(seed).shuffle(found)
    for file, node in found:
        yield file, replaced(file.read_text(), node)


def transcripts(known: set[str]) -> list[str]:
    """Return the commands of transcripts, except `known`, with another output than shown."""
    sys.path.insert(0, str(HERE))
    os.environ |= {"LC_ALL": "C.UTF-8"}
    from test_cases import FILES, transcripts

    from radcalc.__main__ import run

    wrong = []
    for command, output in [pair for path in FILES for pair in transcripts(path)]:
        if command in known:
            continue
        words = shlex.split(command)
        said = io.TextIOWrapper(io.BytesIO(), "utf-8", newline="")
        redirected = contextlib.redirect_stdout(said), contextlib.redirect_stderr(said)
        try:
            with redirected[0], redirected[1], patch("radcalc.terminal.is_terminal", lambda: False):
                status = run(words[1:])
        except BaseException as error:
            status = repr(error)
        said.flush()
        text = said.buffer.getvalue().decode() + (f"[{status}]\n" if status else "")
        if text != output or words[0] != "radcalc":
            wrong.append(command)
            if known:
                break
    return wrong


def stages(root: Path, file: Path, known: Path) -> Iterator[tuple[str, list[str]]]:
    """Yield the commands that try to detect the mutant, the fastest first."""
    yield "transcripts", [sys.executable, "tests/mutation.py", "--transcripts", str(known)]
    place = file.relative_to(root / "radcalc")
    folders = [root / "tests" / x for x in (place.with_suffix(""), *place.parents[:-1])]
    near = [path for folder in folders for path in sorted(folder.glob("test_*.py"))]
    own = [path for path in near if path.stem == f"test_{file.stem}"]
    pytest = [sys.executable, "-m", "pytest", "-x", "-q", "-n0", "--hypothesis-seed=0"]
    pytest += ["-p", "no:cacheprovider"]
    for name, tests in (("own", own), ("folder", [x for x in near if x not in own])):
        if tests:
            yield name, [*pytest, *map(str, tests)]
    yield "last", [*pytest, *(f"tests/{name}" for name in LAST if name != place.parts[0])]


def noticed(root: Path, file: Path, known: Path) -> str:
    """Return the stage that detects the mutant in the tree, or ''."""
    env = os.environ | {"PYTHONPATH": str(root), "PYTHONDONTWRITEBYTECODE": "1"}
    for name, command in stages(root, file, known):
        try:
            done = subprocess.run(command, cwd=root, env=env, capture_output=True, timeout=TOO_LONG)
        except subprocess.TimeoutExpired:
            return name
        if done.returncode:
            return name
    return ""


def main() -> None:
    """Make mutants, test them, and show those that no test detects."""
    parser = argparse.ArgumentParser()
    parser.add_argument("paths", nargs="*", default=CORE, help="below radcalc/")
    parser.add_argument("--count", type=int, default=40)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--skip", type=int, default=0, help="number of mutants to skip")
    parser.add_argument("--transcripts", help=argparse.SUPPRESS)
    given = parser.parse_args()
    if given.transcripts:
        known = Path(given.transcripts)
        wrong = transcripts(set(json.loads(known.read_text())) if known.exists() else set())
        if known.exists():
            sys.exit(bool(wrong))
        known.write_text(json.dumps(["", *wrong]))
        return
    survivors = 0
    with tempfile.TemporaryDirectory() as folder:
        root, known = Path(folder) / "radcalc", Path(folder) / "known"
        shutil.copytree(HERE.parent, root, ignore=shutil.ignore_patterns(".git", "__pycache__"))
        env = os.environ | {"PYTHONPATH": str(root)}
        command = [sys.executable, "tests/mutation.py", "--transcripts", str(known)]
        subprocess.run(
            command, cwd=root, env=env, check=True
        )  # find the transcripts that need a shell
        drawn = list(mutants(root, given.seed, given.paths))
        if not given.count:
            for part in given.paths:
                print(part, noticed(root, root / "radcalc" / part, known) or "passes", flush=True)
        for number in range(given.skip, min(given.skip + given.count, len(drawn))):
            file, text = drawn[number]
            before = file.read_text()
            file.write_text(text)
            name, by = file.relative_to(root), noticed(root, file, known)
            file.write_text(before)
            print(number, name, by or "SURVIVED", flush=True)
            if not by:
                survivors += 1
                lines = before.splitlines(), text.splitlines()
                print("\n".join([*difflib.unified_diff(*lines, lineterm="", n=1)][2:]), flush=True)
    print(f"{survivors} of {given.count} survive, of {len(drawn)} places (seed {given.seed})")


if __name__ == "__main__":
    main()
