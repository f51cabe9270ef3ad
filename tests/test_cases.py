"""The transcripts in `cases/`, the README, `docs/` and `radcalc examples` show what is printed.

Commands that need no more of a shell than words, pipes and sequences run in this process.
"""

import os
import re
import shlex
import subprocess
from pathlib import Path

import pytest
from conftest import DOCS, ROOT, entry_point, run

from radcalc.quantities import lookup

BARE = r"[^\"|<>;&`$\\]*"  # no characters special to a shell, except in '...'
CALL = re.compile(
    rf"((?:printf|echo|seq) {BARE}\| )?radcalc ({BARE}?)( 2> ?(?:&1|/dev/null))?(?: ?(\|.*))?"
)
PARTS = re.compile(rf"radcalc {BARE}(?:(?: &&|;) (?:radcalc|rm) {BARE})+")  # a sequence
FILES = [
    *sorted((ROOT / "tests" / "cases").glob("*.md")),
    *(path for path in DOCS if "```console\n" in path.read_text("utf-8")),
    lookup.FILE,
]


def transcripts(path: Path) -> list[tuple[str, str]]:
    """Return the commands in the console blocks of a file, each with its output."""
    found = []
    for block in re.findall(r"```console\n(.*?)```", path.read_text(encoding="utf-8"), re.S):
        for entry in re.split(r"^\$ ", block, flags=re.M)[1:]:
            command, _, output = entry.partition("\n")
            found.append((command, output))
    assert found, path
    return found


CASES = [
    pytest.param(command, output, id=f"{path.stem}: {command}")
    for path in FILES
    for command, output in transcripts(path)
]


def answered(command: str) -> tuple[str, int]:
    """Return the output of a command line, errors included, and its exit status."""
    unquoted = re.sub(r"'[^']*'", lambda quoted: "." * len(quoted[0]), command)
    found = CALL.fullmatch(unquoted.removesuffix(" < /dev/null"))
    if not found and PARTS.fullmatch(unquoted):
        return one_by_one(command, [part.span() for part in re.finditer(r"[^;&]+|&&|;", unquoted)])
    if not found:
        return in_shell(command)
    before, words, errors, after = (command[slice(*found.span(k))] for k in range(1, 5))
    lines = in_shell(before.removesuffix("| "))[0] if before else ""
    are_together = errors.endswith("1") or not (after or errors)
    done = run(*shlex.split(words), input=lines, together=are_together)
    if not after:
        return done.stdout, done.returncode
    printed, status = in_shell(after.removeprefix("|"), done.stdout)
    return ("" if errors else done.stderr) + printed, status


def one_by_one(command: str, spans: list[tuple[int, int]]) -> tuple[str, int]:
    """Run commands joined by `;` and `&&`; return their output and exit status."""
    printed, status, joint = "", 0, ";"
    for start, end in spans:
        part = command[start:end].strip()
        if part in (";", "&&"):
            joint = part
        elif joint == ";" or not status:
            more, status = answered(part)
            printed += more
    return printed, status


def in_shell(command: str, lines: str = "") -> tuple[str, int]:
    scripts = str(Path(entry_point()).parent)
    done = subprocess.run(
        ["sh", "-c", command],
        input=lines.encode("utf-8", "surrogateescape"),
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        env=os.environ | {"PATH": scripts + os.pathsep + os.environ["PATH"]},
        timeout=60,
    )
    return done.stdout.decode("utf-8", "surrogateescape"), done.returncode


@pytest.fixture(scope="module")
def folder(tmp_path_factory) -> Path:
    """Temporary folder for the files that some commands write and remove."""
    path = tmp_path_factory.mktemp("cases")
    (path / "examples").symlink_to(ROOT / "examples")
    return path


@pytest.mark.parametrize(("command", "output"), CASES)
def test_the_command_prints_the_transcript(command, output, folder, monkeypatch):
    monkeypatch.chdir(folder)
    printed, status = answered(command)
    assert printed + (f"[{status}]\n" if status else "") == output
