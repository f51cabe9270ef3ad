"""Short runs of all sweeps; `PYTHONPATH=tests python -m fuzz.NAME` runs one in full."""

import importlib

import pytest
from fuzz.sweeps import SWEEPS


@pytest.mark.parametrize("name", SWEEPS)
def test_a_short_run_of_the_sweep(name):
    sweep = importlib.import_module(f"fuzz.{name}")
    assert sweep.sweep(sweep.SHORT, 1)
