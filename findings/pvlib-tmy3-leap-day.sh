#!/usr/bin/env bash
# pvlib 0.16.1 (pandas 2.3.3), iotools.read_tmy3: rows of a real 29 February.
#
# Expected: the hours of 29 February 2020 and those of 1 March 2020 have different times; or the
# file is refused, since months of a typical year have no 29 February.
# Seen: every row of 29 February has the time of the same hour of 1 March, without a warning, so
# that 24 times occur twice and a sum by the day counts two days as one.
# radcalc reads the dates of the file itself (radcalc/streams/solar.py, tests/streams/test_solar.py).
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
python3 -m venv "$work/venv"
"$work/venv/bin/pip" install -q 'pvlib==0.16.1' 'pandas==2.3.3'
cat >"$work/year.csv" <<'TMY3'
000001,"OWN PLACE",AA,1.0,50.000,14.000,200
Date (MM/DD/YYYY),Time (HH:MM),GHI (W/m^2)
02/28/2020,12:00,280
02/29/2020,12:00,290
03/01/2020,12:00,301
TMY3
"$work/venv/bin/python" - "$work/year.csv" >"$work/seen" <<'PYTHON'
import sys

from pvlib import iotools

data, _ = iotools.read_tmy3(sys.argv[1])
for time, value in data["ghi"].items():
    print(time.date(), value)
print("repeated:", int(data.index.duplicated().sum()))
PYTHON
cat "$work/seen"
diff "$work/seen" - <<'SEEN'
2020-02-28 280
2020-03-01 290
2020-03-01 301
repeated: 1
SEEN
