"""Names of the sweeps: the modules in this folder that have a sweep."""

from pathlib import Path

OTHERS = {"command", "night", "sweeps", "test_short"}
SWEEPS = sorted({path.stem for path in Path(__file__).parent.glob("*.py")} - OTHERS)
