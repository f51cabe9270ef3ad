"""Bytes that are not text, lone surrogates in Python, are refused like other bad inputs."""

from following import call
from helpers import for_each

from radcalc import terminal

BAD = "\udcff"
CALLS = (
    f"convert 1{BAD} lx fc", f"convert 1 lx{BAD} fc", f"convert 1 lx fc{BAD}", f"convert - fc{BAD}",
    f"convert 1 cd lx --distance 2m{BAD}", f"convert 1 lx W/m2 --spectrum {BAD}",
    f"convert 1 lx W/m2 --spectrum blackbody:{BAD}", f"convert - lx fc --column {BAD}",
    f"convert - lx fc --field {BAD}", f"convert 1 lx fc --check 1{BAD}", f"convert 1 lx fc --{BAD}",
    f"convert 1 lx fc --check 1 --tolerance {BAD}", f"convert 1 lx fc --format {BAD}",
    f"convert 1 lx fc --precision {BAD}", f"convert 1 lx W/m2 --spectrum D65 --range {BAD}", BAD,
    f"units {BAD}", f"quantities {BAD}", f"typical {BAD}", f"spectrum {BAD}.csv", f"photon {BAD}",
    f"photon 555nm -g {BAD}", f"integrate {BAD} --sphere", f"direction {BAD} 1 1",
    f"solid-angle {BAD}", f"solid-angle polygon {BAD} 1,1,1 0,0,1", f"lambertian {BAD}",
    f"solid-angle zone --polar {BAD}:30deg", f"point-source --flux {BAD}", f"ev --iso {BAD}",
    f"point-source --distribution {BAD}", f"mesopic --luminance {BAD}",
    f"dose {BAD}", f"dose - -d {BAD}", f"dose - --column {BAD}", f"dose - --unit {BAD}",
    f"dose - --time-column {BAD}", f"dose - --time-zone {BAD}", f"dose - --time-format {BAD}",
    f"spectrum - --column {BAD}", f"convert - lx fc --header --add {BAD}",
)  # fmt: skip


@for_each(CALLS)
def test_bytes_that_are_not_text_are_refused(line):
    outcome = call(line.split(" "))
    assert outcome.status == terminal.FAILED
    assert outcome.output == ""
    assert outcome.error is not None
