"""Contents of the wheel and the source distribution, and the promises of SECURITY.md."""

import ast
import os
import subprocess
import sys
import tarfile
import tomllib
import zipfile
from pathlib import Path

from conftest import ROOT
from helpers import for_each
from packaging.tags import sys_tags

from radcalc.completion.rows import module_text

PACKAGE = ROOT / "radcalc"
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
BUILD = PROJECT["tool"]["hatch"]["build"]["targets"]
TABLE = "radcalc/completion/built.py"  # generated for a wheel
COMPILED = {".pyc", ".mo"}
LEFTOVERS = {"__pycache__", ".pytest_cache", ".hypothesis", ".mypy_cache", ".ruff_cache"}
# Means to run a text, reach a network, or read files other than those named.
NEVER_CALLED = {"eval", "exec", "compile", "__import__", "system", "popen"}
NEVER_IMPORTED = {
    "ctypes", "ftplib", "http", "marshal", "multiprocessing", "pickle", "requests", "runpy",
    "shelve", "smtplib", "socket", "socketserver", "ssl", "subprocess", "urllib", "webbrowser",
    "xmlrpc",
}  # fmt: skip


def files(*places: str) -> set[str]:
    """Return the files in folders of the project, without caches; a file stands for itself."""
    found = set()
    for place in places:
        path = ROOT / place
        for one in path.rglob("*") if path.is_dir() else [path]:
            name = one.relative_to(ROOT)
            if one.is_file() and not LEFTOVERS & set(name.parts) and one.suffix not in COMPILED:
                found.add(name.as_posix())
    return found


def built(kind: str, folder: Path, root: Path = ROOT) -> Path:
    """Build a distribution of a tree with the project's build backend; return its path."""
    code = f"from hatchling.build import build_{kind} as build; print(build({str(folder)!r}))"
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=root, capture_output=True, text=True, timeout=120
    )
    assert done.returncode == 0, done.stderr
    return folder / done.stdout.split()[-1]


def entry_points(wheel: Path) -> list[str]:
    """Return the commands of a wheel that are entry points."""
    with zipfile.ZipFile(wheel) as file:
        names = [name for name in file.namelist() if name.endswith("/entry_points.txt")]
        lines = [line for name in names for line in file.read(name).decode().splitlines()]
    return [line for line in lines if "=" in line]


def test_the_wheel_has_only_the_package_its_table_and_the_manual(tmp_path):
    with zipfile.ZipFile(built("wheel", tmp_path)) as wheel:
        names = {name for name in wheel.namelist() if not name.endswith("/")}
        table = wheel.read(TABLE).decode()
    data = {name for name in names if ".data/" in name}
    about = {name for name in names if ".dist-info/" in name}
    manual = {f"radcalc/{name}" for name in files("man")}
    sources = files("radcalc")
    catalogues = {name.replace(".po", ".mo") for name in sources if name.endswith(".po")}
    assert names - data - about == sources | catalogues | {TABLE} | manual
    assert table == module_text()
    pages = {os.path.basename(name) for name in data if "/share/man/" in name}
    assert pages == {os.path.basename(name) for name in files("man")}
    scripts = {name.partition(".data/")[2] for name in data if "/scripts/" in name}
    assert scripts <= {"scripts/radcalc"}
    assert len(data) == len(pages) + len(scripts)
    ends = {name.partition(".dist-info/")[2] for name in about}
    licences = {f"licenses/{name}" for name in files("LICENSE", "LICENSES", "NOTICE.md")}
    assert {"METADATA", "RECORD", "WHEEL"} | licences <= ends


def test_the_source_distribution_has_everything_the_tests_need(tmp_path):
    with tarfile.open(built("sdist", tmp_path)) as source:
        names = {name.partition("/")[2] for name in source.getnames()}
    assert names - {"PKG-INFO", ".gitignore", "pyproject.toml"} == files(*BUILD["sdist"]["include"])
    assert {"SECURITY.md", "CHANGELOG.md", "tests/conftest.py", "tests/cases/streams.md"} <= names


def test_a_wheel_runs_everywhere_or_has_the_tag_of_its_platform(tmp_path):
    """What is published is built from the source distribution."""
    with tarfile.open(built("sdist", tmp_path)) as source:
        safe = {"filter": "data"} if hasattr(tarfile, "data_filter") else {}  # before 3.11.4
        source.extractall(tmp_path, **safe)
    (tree,) = [path for path in tmp_path.iterdir() if path.is_dir()]
    portable, own = built("wheel", tmp_path, tree), built("wheel", tmp_path)
    assert portable.name.endswith("-py3-none-any.whl")
    assert entry_points(portable) == ["radcalc = radcalc.__main__:main"]
    assert own.name.endswith("-py3-none-any.whl") == bool(entry_points(own))
    with zipfile.ZipFile(portable) as one, zipfile.ZipFile(own) as other:
        of_portable, of_own = ({*wheel.namelist()} for wheel in (one, other))
    assert not any(".data/scripts/" in name for name in of_portable)
    assert any(".data/scripts/" in name for name in of_own) != bool(entry_points(own))
    tags = {f"{tag.interpreter}-{tag.abi}-{tag.platform}" for tag in sys_tags()}
    assert own.stem.split("-", 2)[2] in tags


# They start the program of PAGER, on a terminal only, and `man`.
STARTERS = {PACKAGE / "cli" / "help.py", PACKAGE / "cli" / "lists.py"}


@for_each(sorted(PACKAGE.rglob("*.py")))
def test_no_module_runs_a_text_or_reaches_a_network(path):
    allowed = {"subprocess"} if path in STARTERS else set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            imported = {name.name.partition(".")[0] for name in node.names}
            assert not NEVER_IMPORTED & imported - allowed
        elif isinstance(node, ast.ImportFrom):
            assert (node.module or "").partition(".")[0] not in NEVER_IMPORTED
        elif isinstance(node, ast.Call):
            called = node.func
            is_of_re = isinstance(called, ast.Attribute) and getattr(called.value, "id", "") == "re"
            name = getattr(called, "id", None) or getattr(called, "attr", None)
            assert is_of_re or name not in NEVER_CALLED, ast.unparse(node)
