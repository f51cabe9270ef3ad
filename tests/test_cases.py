"""The console transcripts in `cases/` and in README.md are run, and print what they show."""

import os
import re
import subprocess
from pathlib import Path

import pytest
from conftest import ROOT, entry_point

FILES = [*sorted((ROOT / "tests" / "cases").glob("*.md")), ROOT / "README.md"]


def transcripts(path: Path) -> list[tuple[str, str]]:
    """Every command of a file's console blocks, with the output below it."""
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


@pytest.mark.parametrize(("command", "output"), CASES)
def test_the_transcript_is_what_is_printed(command, output):
    scripts = str(Path(entry_point()).parent)
    done = subprocess.run(
        ["sh", "-c", command],
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        encoding="utf-8",
        env=os.environ | {"PATH": scripts + os.pathsep + os.environ["PATH"]},
        timeout=60,
    )
    status = f"[{done.returncode}]\n" if done.returncode else ""
    assert done.stdout + status == output
