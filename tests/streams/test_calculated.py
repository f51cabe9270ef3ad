"""A calculator on a stream: every line has the answer of a single call.

The expected lines come from the calculators themselves, called once for each value.
"""

import io
import json
import math
import random
import subprocess
import sys

import pytest

from radcalc import cli, terminal
from radcalc.maths import is_array
from radcalc.quantities import KINDS
from radcalc.quantities.symbols import light_unit
from radcalc.streams import calculated
from radcalc.streams.calculated import Calculated

# The call with {} for the input, the unit of its lines, their range, a result.
CALLS = [
    ("point-source --intensity 100cd --distance {}", "m", 0.01, 1e4, "irradiance:lx"),
    ("point-source --intensity 100cd --distance {}", "ft", 0.01, 1e4, "irradiance:fc"),
    ("point-source --intensity 100cd --distance {}", "m", 0.01, 1e4, "distance:ft"),
    ("point-source --flux {} --distance 2m", "lm", 1e-3, 1e6, "irradiance"),
    ("point-source --flux {} --distance 2m", "dBm", -60, 60, "irradiance"),
    ("point-source --illuminance {} --distance 2m", "lx", 1e-3, 1e6, "flux"),
    ("point-source --intensity 100cd --illuminance {}", "lx", 1e-3, 1e6, "distance"),
    ("point-source --intensity 250cd --height 6m --offset {}", "m", -30, 30, "irradiance"),
    ("point-source --intensity 250cd --height {} --offset 8m", "m", 0.01, 30, "incidence:deg"),
    ("point-source --flux 800lm --half-angle {} --distance 2m", "deg", -5, 200, "irradiance"),
    ("point-source --flux 5mW --distance {} --wavelength 555nm", "m", 0.01, 10, "irradiance:lx"),
    ("point-source --flux 5mW --distance 1m --wavelength {}", "nm", 300, 900, "illuminance:lx"),
    ("point-source --intensity 100cd --exponent {} --distance 2m", "", 0, 80, "flux"),
    ("point-source --beam-angle {}", "deg", 1, 179, "exponent"),
    ("point-source --intensity 100cd --distance 2m --incidence {}", "deg", -95, 95, "irradiance"),
    ("point-source --flux 500lm --distance {} --receiver-area 1cm2", "m", 0.005, 5,
     "received-flux"),
    ("point-source --luminous-flux {} --radiant-flux 3W", "lm", 1, 3000, "luminous-efficacy"),
    ("lambertian --luminance {} --area 1cm2 --distance 1m", "cd/m2", 1, 1e6, "illuminance"),
    ("lambertian --luminance 1e4cd/m2 --area 1cm2 --distance {}", "cm", 0.01, 500, "illuminance"),
    ("lambertian disc --luminance 1e4cd/m2 --radius {} --height 75cm", "cm", 0.01, 500,
     "illuminance"),
    ("lambertian disc --luminance 1e4cd/m2 --radius 1cm --height {}", "cm", 0.01, 500,
     "illuminance"),
    ("lambertian disc --luminance 1e4cd/m2 --radius 25cm --height 75cm --offset {}", "cm", 0, 500,
     "illuminance"),
    ("lambertian sphere --luminance 1e4cd/m2 --radius 1m --distance {}", "m", 0.5, 50,
     "illuminance"),
    ("lambertian rectangle --luminance 1e4cd/m2 --width 2m --length 1m --height {}", "m", 0.01,
     50, "illuminance"),
    ("lambertian plane --illuminance {} --reflectance 0.5", "lx", 0, 50, "luminance"),
    ("lambertian --incident-illuminance 100lx --reflectance {}", "%", -1, 110, "luminance"),
    ("ev --ev100 {}", "", -10, 20, "luminance"),
    ("ev --luminance {}", "cd/m2", 0.01, 1e5, "ev100"),
    ("ev --f-number {} --time 1/100s --iso 100", "", 0.5, 64, "ev100"),
    ("ev --f-number 8 --time {} --iso 100", "s", 1e-4, 64, "luminance"),
    ("ev --illuminance {} --f-number 4 --iso 400", "lx", 1, 1e5, "time:ms"),
    ("solid-angle cone --half-angle {}", "deg", -5, 185, "solid-angle"),
    ("solid-angle cone --half-angle {}", "rad", 1e-9, 3.2, "projected-solid-angle"),
    ("solid-angle cone --solid-angle {}", "sr", 1e-9, 13, "half-angle:deg"),
    ("solid-angle sphere --radius {} --distance 10m", "m", 0.1, 12, "solid-angle"),
    ("solid-angle disc --radius 1m --height {}", "m", 0.01, 100, "solid-angle"),
    ("solid-angle disc --radius 1m --height 1m --offset {}", "m", 0, 5, "solid-angle"),
    ("solid-angle rectangle --width 2m --length 1m --height {}", "m", 0.01, 100, "solid-angle"),
    ("solid-angle pyramid --horizontal {} --vertical 40deg", "deg", 1, 179, "solid-angle"),
    ("solid-angle patch --area 1cm2 --distance {}", "m", 0.001, 10, "solid-angle"),
    ("etendue --area 1mm2 --half-angle {}", "deg", 0.1, 95, "etendue"),
    ("etendue --area 1mm2 --f-number {}", "", 0.4, 95, "etendue"),
    ("etendue --area 1mm2 --na {} --radiance 1W/m2/sr", "", 0.01, 1.2, "flux"),
    ("photon {}", "nm", 300, 900, "luminous-efficacy"),
    ("photon {}", "eV", 1, 5, "wavelength:nm"),
    ("photon {}", "THz", 100, 900, "photon-energy:eV"),
    ("mesopic --luminance {} --sp-ratio 2", "cd/m2", 0.0005, 10, "mesopic-luminance"),
    ("mesopic --mesopic-luminance {} --sp-ratio 2", "cd/m2", 0.0005, 10, "luminance"),
    ("screen --flux {} --diagonal 100in --aspect 16/9", "lm", 1, 1e5, "illuminance"),
    ("screen --flux 3000lm --diagonal {} --aspect 16/9 --gain 1.3", "in", 1, 300, "luminance"),
    ("calorimeter --mass 10g --specific-heat 385J/kg/K --temperature-rise {} --time 30s", "K", -1,
     60, "flux"),
    ("sky overcast --zenith-luminance {} --tilt 90deg", "cd/m2", 1, 2e4, "illuminance"),
    ("sky overcast --zenith-luminance 9000cd/m2 --tilt {}", "deg", -5, 185, "illuminance"),
    ("sky clear --sun-elevation {} --horizontal-illuminance 12klx", "deg", -5, 90,
     "zenith-luminance"),
    ("direction --polar {} --azimuth 30deg", "deg", 0, 180, "z"),
    ("laser --flux 1W --diameter 1mm --divergence 1mrad --distance {}", "m", 0.01, 1e3,
     "irradiance"),
    ("laser --flux {} --diameter 1mm --divergence 1mrad --distance 10m", "mW", 0.01, 1e3,
     "peak-irradiance"),
    ("sky 12 --sun-elevation 40deg --horizontal-illuminance {}", "lx", 1, 2e4, "zenith-luminance"),
    ("point-source --flux 800lm --exponent 3 --height {} --offset 2m", "m", -2, 9, "irradiance"),
    ("point-source --intensity 100cd --exponent 3 --within {}", "deg", 0.1, 95, "flux-within"),
]  # fmt: skip


class Process:
    """Process with captured streams: output and messages of a command."""

    def __init__(self, monkeypatch, data=b""):
        self.out, self.said = io.BytesIO(), []
        monkeypatch.setattr(terminal, "read", io.BytesIO(data).read)
        monkeypatch.setattr(terminal, "pour", self.out.write)
        monkeypatch.setattr(
            terminal, "write", lambda text, exact=False: self.out.write(text.encode())
        )
        monkeypatch.setattr(terminal, "say", self.said.extend)
        monkeypatch.setattr(terminal, "is_terminal", lambda: False)

    def write(self, text, exact=False):
        self.out.write(text.encode())

    def run(self, *words):
        self.status = cli.run(list(words))
        return self.out.getvalue().decode()


def words_of(call, value, result):
    return [*[word.replace("{}", value) for word in call.split()], "-g", result]


def single(monkeypatch, call, value, result):
    """Return the output of a single call, or its error message."""
    process = Process(monkeypatch)
    out = process.run(*words_of(call, value, result))
    said = [line.partition("radcalc: ")[2] for line in process.said if line.startswith("radcalc")]
    return out if process.status == 0 else said[0]


@pytest.mark.parametrize(("call", "unit", "low", "high", "result"), CALLS)
def test_a_line_is_answered_as_a_single_call(monkeypatch, call, unit, low, high, result):
    chance = random.Random(call + unit + result)
    values = [f"{chance.uniform(low, high):.4g}" for _ in range(5)]
    if low > 0:
        values += [
            f"{math.exp(chance.uniform(math.log(low), math.log(high))):.17g}" for _ in values
        ]
    values += ["0", "1", "-1", f"{low:g}", f"{high:g}", "1e99", "1e-99", "1/3"]
    words = words_of(call, f"- {unit}".strip(), result)
    if call.startswith("photon"):
        words = ["photon", "-", unit, "-g", result]
    process = Process(monkeypatch, "".join([f"{value}\n" for value in values]).encode())
    shown = process.run(*words, "--invalid", "warn").splitlines()
    wrong = [line.partition("stdin, line ")[2] for line in process.said if "stdin, line" in line]
    problems = {int(n): text for n, _, text in (line.partition(": ") for line in wrong)}
    assert len(shown) == len(values)
    for k, (value, line) in enumerate(zip(values, shown, strict=True), start=1):
        own = single(monkeypatch, call, f"{value}{unit}", result)
        assert problems.get(k, f"{line}\n") == own
        if k in problems:
            assert line == value


@pytest.mark.parametrize(("call", "unit", "low", "high", "result"), CALLS)
def test_an_array_has_the_answers_of_its_lines(monkeypatch, call, unit, low, high, result):
    """Answers agree to the last bit and messages word for word, with bad lines among them."""
    chance = random.Random(call + unit)
    values = [f"{low + (high - low) * chance.uniform(0.4, 0.6)!r}" for _ in range(50)]
    values += [f"{chance.uniform(low, high):.3g}" for _ in range(15)]
    for bad in ("-1e5", "0", "x", "1e99"):
        values.insert(chance.randrange(35, 65), bad)
    data = "".join([f"{value}\n" for value in values]).encode()
    words = words_of(call, f"- {unit}".strip(), result)
    if call.startswith("photon"):
        words = ["photon", "-", unit, "-g", result]
    taken = []
    work_out = Calculated.find

    def find(self, given):
        found = work_out(self, given)
        taken.append(given.value.size if is_array(given.value) else 0)
        return found

    monkeypatch.setattr(Calculated, "find", find)
    answers = []
    for first in (len(values) + 1, calculated.FEWEST):
        monkeypatch.setattr(calculated, "FIRST", first)
        process = Process(monkeypatch, data)
        out = process.run(*words, "--invalid", "warn", "--precision", "17")
        answers.append((process.status, out, [one for one in process.said if "stdin" in one]))
    assert answers[0] == answers[1]
    assert sum(taken) > len(values) / 4


def test_a_bad_line_costs_a_few_smaller_blocks(monkeypatch):
    values = [f"{1 + k / 1000:.3f}" for k in range(4096)]
    values[1234] = "-1"
    sizes = []
    work_out = Calculated.find

    def find(self, given):
        sizes.append(given.value.size if is_array(given.value) else 1)
        return work_out(self, given)

    monkeypatch.setattr(Calculated, "find", find)
    process = Process(monkeypatch, "".join([f"{value}\n" for value in values]).encode())
    words = ["point-source", "--flux", "800lm", "--distance"]
    out = process.run(*words, "- m", "-g", "illuminance", "--invalid", "warn")
    assert len(out.splitlines()) == 4096
    assert len([line for line in process.said if "line 1235" in line]) == 1
    assert len(sizes) < 60


def test_a_short_stream_loads_no_numpy():
    lines = "1\n" * (calculated.FIRST - 1)
    code = "import sys; from radcalc import cli; cli.run(sys.argv[1:]); print(*sys.modules)"
    words = ["point-source", "--flux", "800lm", "--distance", "- m", "-g", "illuminance"]
    done = subprocess.run(
        [sys.executable, "-c", code, *words],
        input=lines,
        text=True,
        check=True,
        capture_output=True,
    )
    *answers, modules = done.stdout.splitlines()
    assert len(answers) == calculated.FIRST - 1
    assert "numpy" not in modules.split()


# For every light quantity that calculators take, a call with {} for it.
OF_LIGHT = [
    ("flux", "point-source --flux {} --distance 2m"),
    ("intensity", "point-source --intensity {} --distance 2m"),
    ("peak-intensity", "point-source --peak-intensity {} --exponent 3"),
    ("irradiance", "point-source --irradiance {} --distance 2m"),
    ("energy", "point-source --energy {} --time 10s --distance 2m"),
    ("exposure", "point-source --exposure {} --time 10s --distance 2m"),
    ("exitance", "lambertian --exitance {} --area 1cm2"),
    ("radiance", "lambertian --radiance {} --area 1cm2 --distance 1m"),
    ("incident-irradiance", "lambertian --incident-irradiance {} --reflectance 0.5"),
    (
        "peak-irradiance",
        "laser --peak-irradiance {} --diameter 1mm --divergence 1mrad --distance 1m",
    ),
    ("flux", "point-source --flux {} --distance 2m --wavelength 555nm"),
    ("radiance", "sensor --radiance {} --f-number 4"),
    ("flux", "etendue --etendue 1mm2.sr --flux {}"),
]


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize(("name", "call"), OF_LIGHT)
def test_a_title_has_the_unit_of_the_numbers(monkeypatch, name, call, kind):
    unit = light_unit(name, kind)
    process = Process(monkeypatch)
    words = [word.replace("{}", f"7 {unit}") for word in call.split()]
    own = json.loads(process.run(*words, "--json"))
    as_csv = "-d", ",", "--column", "P", "--add", "result"
    found = [one for one, row in own["results"].items() if not row["given"]]
    assert found
    for result in found:
        number = single(monkeypatch, call, f"7 {unit}", result)
        unit_of = own["results"][result]["unit"]
        said = f"result [{unit_of}]\n{number}" if unit_of != "1" else f"result\n{number}"
        # the unit in the title, and for the first result also as typed
        told = [("-", f"P [{unit}]"), (f"- {unit}", "P"), (f"- {unit}", f"P [{unit}]")]
        for typed, title in told if result == found[0] else told[:1]:
            data = f"n,{title}\na,7\n".encode()
            words = words_of(call, typed, result)
            out = Process(monkeypatch, data).run(*words, "-q", *as_csv)
            titles, line = out.splitlines()
            assert f"{titles.rpartition(',')[2]}\n{line.rpartition(',')[2]}\n" == said
