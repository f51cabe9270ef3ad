"""The names of the sweeps: the modules here that have one."""

from pathlib import Path

OTHERS = {"command", "night", "sweeps", "test_short"}
SWEEPS = sorted({path.stem for path in Path(__file__).parent.glob("*.py")} - OTHERS)
