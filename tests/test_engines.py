"""The recipes of docs/python.md for query engines, run unchanged."""

import csv
import os
import re
import sqlite3
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import ROOT, entry_point
from helpers import require

PAGE = (ROOT / "docs" / "python.md").read_text("utf-8")
SECTION = PAGE.partition("\n## Tables larger than memory\n")[2].partition("\n## ")[0]
POLARS, DUCKDB, DASK = re.findall(r"```python\n(.*?)```", SECTION, re.S)
(SQL,) = re.findall(r"```sh\n(.*?)```", SECTION, re.S)
LUX = [0, 10, 123.4, 100000]
# The tables of LED-B3 and V(lambda) of colour-science 0.4, summed by numpy.trapezoid at 1 nm:
# 683.002 int S V over int_400^700 S lambda/(h c N_A) is 69.750 lx per umol/m2/s.
LUX_PER_PPFD = 69.750


def run(recipe: str, place: Path, *shell: str) -> str:
    """Run a recipe in a folder, in a new interpreter or a shell; return its output."""
    done = call(recipe, place, *shell)
    assert (done.returncode, done.stderr) == (0, "")
    return done.stdout


def call(recipe: str, place: Path, *shell: str) -> subprocess.CompletedProcess[str]:
    scripts = str(Path(entry_point()).parent)
    return subprocess.run(
        [*(shell or (sys.executable, "-W", "error", "-c")), recipe],
        cwd=place,
        env=os.environ | {"PATH": scripts + os.pathsep + os.environ["PATH"]},
        capture_output=True,
        text=True,
        timeout=120,
    )


def expected() -> list[object]:
    return [pytest.approx(lux / LUX_PER_PPFD, rel=1e-4) for lux in LUX]


def test_polars_streams_a_parquet_file(tmp_path):
    import polars

    polars.DataFrame({"lux": LUX}, strict=False).write_parquet(tmp_path / "log.parquet")
    run(POLARS, tmp_path)
    found = polars.read_parquet(tmp_path / "ppfd.parquet")
    assert found.columns == ["lux", "ppfd"]
    assert found["ppfd"].to_list() == expected()


def test_duckdb_reads_and_writes_csv(tmp_path):
    rows = "".join(f"2026-06-21 12:00:0{second},{lux}\n" for second, lux in enumerate(LUX))
    (tmp_path / "log.csv").write_text(f"time,lux\n{rows}")
    run(DUCKDB, tmp_path)
    with open(tmp_path / "ppfd.csv", newline="") as file:
        found = list(csv.DictReader(file))
    assert [float(row["lux"]) for row in found] == LUX
    assert [float(row["ppfd"]) for row in found] == expected()


def test_dask_works_over_many_files_and_keeps_the_checks(tmp_path):
    """800 lm/(4 pi (0.5 m)^2) on a sphere, and 1 fc = 1/0.3048^2 lx: 23.658 fc."""
    (tmp_path / "logs").mkdir()
    for name, distances in (("a", (2, 0.5)), ("b", (1, 4))):
        rows = "".join(f"{distance}\n" for distance in distances)
        (tmp_path / "logs" / f"{name}.csv").write_text(f"distance\n{rows}")
    assert run(DASK, tmp_path) == "23.658 footcandle\n"
    (tmp_path / "logs" / "c.csv").write_text("distance\n-1\n")
    refused = call(DASK, tmp_path)
    assert refused.returncode == 1
    assert 'Impossible: distance="-1 m" is out of range\ntry' in refused.stderr


def test_a_shell_puts_the_factor_into_sql(tmp_path):
    require("sqlite3")
    with sqlite3.connect(tmp_path / "log.db") as log:
        log.execute("CREATE TABLE log (lux REAL, ppfd REAL)")
        log.executemany("INSERT INTO log VALUES (?, NULL)", [(lux,) for lux in LUX])
    log.close()
    run(SQL, tmp_path, "sh", "-c")
    with sqlite3.connect(tmp_path / "log.db") as log:
        assert [ppfd for (ppfd,) in log.execute("SELECT ppfd FROM log")] == expected()
    log.close()
