"""A short run of every sweep; `PYTHONPATH=tests python -m fuzz.NAME` runs the whole of one."""

import importlib
from pathlib import Path

import pytest

HERE = Path(__file__).parent
SWEEPS = sorted({path.stem for path in HERE.glob("*.py")} - {"command", "test_short"})


@pytest.mark.parametrize("name", SWEEPS)
def test_a_short_run_of_the_sweep(name):
    sweep = importlib.import_module(f"fuzz.{name}")
    assert sweep.sweep(sweep.SHORT, 1)
