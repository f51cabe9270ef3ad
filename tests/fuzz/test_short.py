"""Short runs of all sweeps; `PYTHONPATH=tests python -m fuzz.NAME` runs one in full."""

import importlib
import runpy

import pytest
from fuzz.sweeps import SWEEPS


@pytest.mark.parametrize("name", SWEEPS)
def test_a_short_run_of_the_sweep(name):
    sweep = importlib.import_module(f"fuzz.{name}")
    assert sweep.sweep(sweep.SHORT, 1)


@pytest.mark.parametrize("name", SWEEPS)
@pytest.mark.filterwarnings("ignore:'fuzz:RuntimeWarning")  # runpy: imported before
def test_the_command_in_the_readme_runs_the_sweep(name, monkeypatch, capsys):
    monkeypatch.setattr("sys.argv", [f"fuzz.{name}", "--count", "1", "--seed", "2"])
    runpy.run_module(f"fuzz.{name}", run_name="__main__")
    assert "(1 cases, seed 2," in capsys.readouterr().out
