"""The share of the statements that no recorded call reaches.

`pytest tests/test_cases.py --cov=radcalc --cov-report=json:FILE` measures the statements that the
transcripts of tests/cases, docs and the README run; `python tests/reached.py FILE` compares the
rest with the limit.  Python functions have tests of their own, and builders run for developers.
"""

import json
import sys
from pathlib import Path

MOST = 0.25  # of the statements
OTHERS = ("radcalc/api/", "radcalc/units/registry.py", "radcalc/spectra/compile.py")
OTHERS += ("radcalc/units/registry.py", "radcalc/completion/rows.py")


def shares(measured: dict) -> tuple[float, dict[str, int]]:
    """Return the share that is not reached, and the statements not reached by room."""
    total = missing = 0
    rooms: dict[str, int] = {}
    for name, file in measured["files"].items():
        if name.startswith(OTHERS):
            continue
        summary = file["summary"]
        total += summary["num_statements"]
        missing += summary["missing_lines"]
        room = str(Path(name).parent)
        rooms[room] = rooms.get(room, 0) + summary["missing_lines"]
    return missing / total, rooms


def main() -> int:
    """Print the rooms and the share; return 1 if it is above the limit."""
    share, rooms = shares(json.loads(Path(sys.argv[1]).read_text(encoding="utf-8")))
    for room, count in sorted(rooms.items(), key=lambda row: -row[1]):
        print(f"{count:5} {room}")
    print(f"{share:.1%} of the statements are not reached by recorded calls (at most {MOST:.0%})")
    return int(share > MOST)


if __name__ == "__main__":
    sys.exit(main())
