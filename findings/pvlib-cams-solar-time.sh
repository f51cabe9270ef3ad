#!/usr/bin/env bash
# pvlib 0.16.1 (pandas 2.3.3), iotools.read_cams: a file in true solar time.
#
# Expected: times in true solar time have no zone, or are refused: at a place 14.4 deg east the sun
# culminates at 12:00 of that time, but an hour earlier in UTC.
# Seen: the header says that its time reference is true solar time, and the times that are returned
# are labelled UTC; a position of the sun from them is about an hour wrong.
# radcalc takes such times without a zone (radcalc/streams/solar.py, tests/streams/test_solar.py).
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
python3 -m venv "$work/venv"
"$work/venv/bin/pip" install -q 'pvlib==0.16.1' 'pandas==2.3.3'
cat >"$work/cams.csv" <<'CAMS'
# Coding: utf-8
# Title: CAMS Radiation Service v4.6 all-sky irradiation (derived from satellite data).
# Latitude (positive North, ISO 19115): 50.1000
# Longitude (positive East, ISO 19115): 14.4000
# Altitude (m): 300.00
# Time reference: True solar time (TST)
# Summarization (integration) period: 0 year 0 month 0 day 1 h 0 min 0 s
# noValue: nan
# Observation period;TOA;Clear sky GHI;Clear sky BHI;Clear sky DHI;Clear sky BNI;GHI;BHI;DHI;BNI;Reliability
2020-06-21T11:00:00.0/2020-06-21T12:00:00.0;1200;900;750;150;850;900;750;150;850;1.0000
2020-06-21T12:00:00.0/2020-06-21T13:00:00.0;1200;900;750;150;850;900;750;150;850;1.0000
CAMS
"$work/venv/bin/python" - "$work/cams.csv" >"$work/seen" <<'PYTHON'
import sys

from pvlib import iotools

data, facts = iotools.read_cams(sys.argv[1], label="left")
print(facts["Time reference"])
print(data.index[1], data.index.tz, data["ghi"].iloc[1])
PYTHON
cat "$work/seen"
diff "$work/seen" - <<'SEEN'
True solar time (TST)
2020-06-21 12:00:00+00:00 UTC 900.0
SEEN
