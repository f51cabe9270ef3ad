"""The sentences of SECURITY.md, each with its test.

`told` makes a call in a new process, in which a hook of Python (PEP 578) notes what is opened,
listed, started and connected.
"""

import json
import os
import re
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import ROOT
from helpers import require

from radcalc.errors import RadcalcError
from radcalc.inputs import definitions
from radcalc.units.reading import read_amount

TEXT = (ROOT / "SECURITY.md").read_text(encoding="utf-8")
HERE = Path(__file__).parent
# The beginning of each sentence, and the test that shows it.
TESTS = {
    "It never executes its input.": "test_package.py: no_module_runs_a_text_or_reaches_a_network",
    "radcalc has its own grammars": "test_security.py: no_text_of_a_user_is_run",
    "Python's parser turns": "test_security.py: no_text_of_a_user_is_run",
    "Text from a user or a file": "test_security.py: no_text_of_a_user_is_run",
    "It starts two programs only:": "cli/test_help.py: the_help_in_a_pipe_is_not_paged",
    "`radcalc manual` starts": "test_security.py: only_the_manual_starts_a_program_in_a_pipe",
    "Matplotlib may start": "test_security.py: only_the_manual_starts_a_program_in_a_pipe",
    "It does not use the network.": "test_package.py: no_module_runs_a_text_or_reaches_a_network",
    "No command and no function": "test_security.py: no_call_connects_or_writes",
    "It reads only the files": "test_security.py: a_call_reads_what_is_named_and_the_definitions",
    "A spectrum of the definitions": "test_security.py: a_spectrum_of_the_definitions_is_read",
    "The definitions are a regular": "test_security.py: definitions_are_a_small_regular_file",
    "From Python, only": "test_security.py: python_reads_no_definitions_unasked",
    "Tab completion reads": "test_security.py: a_tab_reads_the_definitions_and_lists_folders",
    "It imports nothing from": "test_security.py: nothing_is_imported_from_the_current_folder",
    "`python -m radcalc` is": "test_security.py: nothing_is_imported_from_the_current_folder",
    "Of Matplotlib's settings": "test_security.py: matplotlib_has_its_packaged_settings_alone",
    "It writes only on request": "test_security.py: no_call_connects_or_writes",
    "`--save`, `--irradiance-map`": "test_security.py: files_are_written_on_request",
    "The file is written beside": "test_security.py: files_are_written_on_request",
    "None of these remains": "test_security.py: nothing_temporary_remains_after_sigterm",
    "If `MPLCONFIGDIR` names": "test_security.py: matplotlib_has_its_packaged_settings_alone",
    "From Python, Matplotlib": "plots/test_figure.py: a_figure_for_a_notebook_is_matplotlibs_",
    "The prompt keeps its history": "cli/test_prompt.py: the_history_is_in_the_platforms_folder",
    "An empty `RADCALC_HISTORY`": "cli/test_prompt.py: the_prompt_works_if_the_history_cannot",
    "Input is bounded.": "test_security.py: every_size_is_bounded",
    "Limits apply to": "test_security.py: every_size_is_bounded",
    "The messages state": "test_security.py: every_size_is_bounded",
    "Streams and logs use": "calculators/test_dose.py: a_long_log_needs_no_more_memory_than",
    "XML with a document type": "spectra/test_meters.py: incomplete_or_unsuitable_xml_is_refused",
    "Output is printable.": "test_errors.py: a_quoted_text_is_one_printable_line",
    "Text from files and arguments": "test_errors.py: a_quoted_text_is_one_printable_line",
    "The exception is a stream": "test_security.py: a_stream_copies_what_is_not_a_number",
    "In CSV, cells of a file": "cli/test_mark.py: cells_that_a_spreadsheet_may_run_have_a_note",
    "An answer with a character": "render/test_plain.py: an_answer_that_the_encoding_lacks",
}  # fmt: skip


def test_each_sentence_has_its_test():
    section = TEXT.partition("## How radcalc handles its input\n")[2].partition("\n\nMalformed")[0]
    plain = " ".join(section.replace("- **", " ").replace("**", "").split())
    sentences = re.split(r"(?<=[.])\s+(?=[A-Z`]|radcalc )", plain)
    for sentence in sentences:
        assert sum(map(sentence.startswith, TESTS)) == 1, sentence
    assert len(sentences) == len(TESTS)
    for named in TESTS.values():
        name, _, function = named.partition(": ")
        assert f"def test_{function}" in (HERE / name).read_text(encoding="utf-8"), named


PROBE = """
import json, os, sys
noted = []
def hook(event, args):
    is_path = bool(args) and isinstance(args[0], (str, type(None)))
    path = os.path.abspath(args[0] or ".") if is_path else ""
    if event == "open" and path:
        noted.append(["writes" if (args[2] or 0) & 3 else "reads", path])
    elif event in ("os.listdir", "os.scandir") and path:
        noted.append(["lists", path])
    elif event in ("os.mkdir", "os.rename"):
        noted.append(["writes", path])
    elif event in ("subprocess.Popen", "os.system", "os.exec", "os.posix_spawn", "os.fork"):
        noted.append(["starts", str(args[0])])
    elif event.startswith("socket."):
        noted.append(["connects", str(args)])
    elif event == "exec" and "zork" in repr((args[0].co_names, args[0].co_consts)):
        noted.append(["runs", args[0].co_filename])
sys.addaudithook(hook)
try:
    from radcalc.__main__ import run
    run(sys.argv[1:])
finally:
    sys.stdout.flush()
    sys.stderr.write("\\n" + json.dumps([noted, sys.path]))
"""
OWN = ("/dev/", "/proc/", "/sys/", "/etc/", "/usr/share/", "/usr/lib/", str(ROOT))


def told(folder, *words, code=PROBE, **variables):
    """Return what a call in a folder does, but for the files of Python, radcalc and the system."""
    env = os.environ | {"HOME": str(folder), "XDG_CONFIG_HOME": "", "PYTHONPATH": str(ROOT)}
    done = subprocess.run(
        [sys.executable, "-P", "-c", code, *words],
        cwd=folder, env=env | variables, capture_output=True, text=True, timeout=120,
        stdin=subprocess.DEVNULL,
    )  # fmt: skip
    noted, path = json.loads(done.stderr.splitlines()[-1])
    own = (*OWN, sys.prefix, sys.base_prefix, *filter(None, path))
    return {(what, name) for what, name in noted if not name.startswith(own)}


@pytest.fixture
def home(tmp_path):
    """Return a folder with definitions, spectra and a scene, which is the home folder of calls."""
    (tmp_path / ".config" / "radcalc").mkdir(parents=True)
    own = "smoot = 67 inch\nspectrum bench = bench.csv\nspectrum lost = lost.csv\n"
    (tmp_path / ".config" / "radcalc" / "definitions.txt").write_text(own)
    for path in (tmp_path / "lamp.csv", tmp_path / ".config" / "radcalc" / "bench.csv"):
        path.write_text("wavelength,W\n500,1\n600,1\n")
    (tmp_path / "beam.csv").write_text("angle [deg],I [cd]\n0,100\n90,0\n")
    (tmp_path / "scene.csv").write_text("x,y,z,intensity,distribution\n0,0,2,100cd,beam.csv\n")
    return tmp_path.resolve()


def reads(home, *names):
    return {("reads", str(home / name)) for name in names}


DEFINITIONS = ".config/radcalc/definitions.txt"
READ = {
    "100 lx fc": (),
    "100 lx fc --json": (DEFINITIONS,),
    "800 lm at 2 m to lx": (DEFINITIONS,),
    "spectrum lamp.csv -g peak-wavelength": (DEFINITIONS, "lamp.csv"),
    "scene scene.csv --at 0,0,0": (DEFINITIONS, "scene.csv", "beam.csv"),
}


@pytest.mark.parametrize("text", READ)
def test_a_call_reads_what_is_named_and_the_definitions(home, text):
    read = {one for one in told(home, *text.split()) if one[0] == "reads"}
    assert read == reads(home, *READ[text])


@pytest.mark.parametrize("text", ["100 lx fc --json", "spectrum lamp.csv --definitions /dev/null"])
def test_definitions_may_be_off(home, text):
    off = {} if "--definitions" in text else {"RADCALC_DEFINITIONS": ""}
    assert not told(home, *text.split(), **off) & reads(home, DEFINITIONS)


def test_a_spectrum_of_the_definitions_is_read_if_it_is_used(home):
    bench = reads(home, ".config/radcalc/bench.csv")
    assert not told(home, *["1", "smoot", "m", "--json"]) & bench
    assert told(home, *["500", "lx", "ppfd", "--spectrum", "bench"]) >= bench
    assert told(home, *["500", "lx", "to", "ppfd", "under", "bench"]) >= bench


def test_definitions_are_a_small_regular_file(tmp_path):
    os.mkfifo(pipe := tmp_path / "pipe")  # without a writer: to open it would wait for ever
    for path in (pipe, tmp_path, Path("/dev/zero")):
        with pytest.raises(RadcalcError, match="not a regular file"):
            definitions.load(str(path))
    (tmp_path / "long.txt").write_text("#" * (256 * 1024 + 1))
    with pytest.raises(RadcalcError, match="longer than 262144 bytes"):
        definitions.load(str(tmp_path / "long.txt"))


def test_python_reads_no_definitions_unasked(home):
    code = PROBE.replace("from radcalc.__main__ import run\n    run(sys.argv[1:])", "{}")
    asks = 'import radcalc; print(radcalc.convert("100 lx", "fc"))'
    defines = f'{asks}; radcalc.define("{DEFINITIONS}"); print(radcalc.convert("1 smoot", "m"))'
    assert not told(home, code=code.format(asks)) & reads(home, DEFINITIONS)
    assert told(home, code=code.format(defines)) >= reads(home, DEFINITIONS)


def test_a_tab_reads_the_definitions_and_lists_folders(home):
    line = {"_RADCALC_COMPLETE": "bash_complete", "COMP_LINE": "radcalc spectrum la"}
    noted = told(home, **line)
    assert noted == reads(home, DEFINITIONS) | {("lists", str(home))}


@pytest.mark.parametrize(
    "words",
    [
        ["100", "zork", "fc"], ["convert", "1+zork()", "lx"], ["1 lx", "--definitions", "zork.txt"],
        ["integrate", "zork(theta)", "--sphere"], ["integrate", "__import__('zork')", "--sphere"],
        ["environment", "zork.csv"], ["dose", "zork.csv"], ["mark", "zork.csv"],
    ],
)  # fmt: skip
def test_no_text_of_a_user_is_run(home, words):
    (home / "zork.txt").write_text("zork = __import__('zork')\n")
    (home / "zork.csv").write_text("time,zork\n1,zork()\n")
    assert not {what for what, _ in told(home, *words)} & {"runs", "starts"}


def test_only_the_manual_starts_a_program_in_a_pipe(home):
    require("man")
    started = {name for what, name in told(home, "manual", "units") if what == "starts"}
    assert {Path(name).name for name in started} == {"man"}
    for words in (["--help"], ["convert", "--help"], ["help", "lux"], ["lamp.csv"]):
        started = {name for what, name in told(home, *words) if what == "starts"}
        assert started <= {"fc-list"}, words  # older Matplotlib lists the fonts


def test_no_call_connects_or_writes(home):
    for text in (*READ, "units lux", "help convert", "zork", "lamp.csv", "dose lamp.csv"):
        assert not {what for what, _ in told(home, *text.split())} & {"writes", "connects"}, text


def test_files_are_written_on_request(home):
    """A word that help looks for has examples, which are tried in an empty folder."""
    calls = {
        "sky.pfm": "sky overcast --zenith-luminance 9000cd/m2 --save {} --size 16x8",
        "map.pfm": "environment sky.pfm --unit cd/m2 --irradiance-map {} --size 16x8",
        "d65.svg": "spectrum D65 --plot {}",
    }
    for name, text in calls.items():
        noted = told(home, *text.format(name).split(), TMPDIR=str(home), MPLCONFIGDIR="")
        assert (home / name).exists(), (text, noted)
        begun = [place for what, place in noted if what == "writes"]
        assert begun
        assert all(Path(place).is_relative_to(home) for place in begun), begun
    tried = [name for what, name in told(home, "help", "lux", TMPDIR=str(home)) if what == "writes"]
    assert tried
    assert [name for name in tried if not Path(name).is_relative_to(home)] == []
    left = {path.name for path in home.iterdir()}
    assert left == {".config", "lamp.csv", "beam.csv", "scene.csv", *calls}


STOPPED = """
import os, signal, sys
def stop(*_):
    os.kill(os.getpid(), signal.SIGTERM)
sys.argv = ["radcalc", "sky", "overcast", "--zenith-luminance", "9000cd/m2", "--save", "sky.pfm"]
from radcalc.__main__ import main
os.replace = stop
main()
"""
FAKE = "import os, signal\nos.kill(os.getpid(), signal.SIGTERM)\n"


def test_nothing_temporary_remains_after_sigterm(tmp_path):
    """The signal comes before a file has its name, and while Matplotlib is loaded."""
    work, package = tmp_path / "work", tmp_path / "fake" / "matplotlib"
    work.mkdir()
    package.mkdir(parents=True)
    (package / "__init__.py").write_text("")
    (package / "font_manager.py").write_text(FAKE)
    env = os.environ | {"TMPDIR": str(work), "PYTHONPATH": str(package.parent)}
    env.pop("MPLCONFIGDIR", None)
    plot = [sys.executable, "-m", "radcalc", "spectrum", "D65", "--plot", str(work / "a.svg")]
    for words in ([sys.executable, "-c", STOPPED], plot):
        done = subprocess.run(words, cwd=work, env=env, capture_output=True, timeout=120)
        assert done.returncode in (143, -signal.SIGTERM), done.stderr
        assert [*work.iterdir()] == []


@pytest.mark.parametrize("settings", [b"zork: 3\n", b"\xff\xfe", b"lines.linewidth: 99\n"])
def test_matplotlib_has_its_packaged_settings_alone(tmp_path, settings):
    words = [sys.executable, "-P", "-m", "radcalc", "spectrum", "D65", "-q", "-g", "cct", "--plot"]
    pictures = []
    for name, variables in (("none", {}), ("here", {}), ("of fonts", {"MPLCONFIGDIR": "fonts"})):
        (tmp_path / name).mkdir()
        (tmp_path / name / "fonts").mkdir()
        home = tmp_path / name / ".config" / "matplotlib"
        home.mkdir(parents=True)
        for folder in (tmp_path / name, tmp_path / name / "fonts", home) if name != "none" else ():
            (folder / "matplotlibrc").write_bytes(settings)
        env = os.environ | {"HOME": str(tmp_path / name), "XDG_CONFIG_HOME": "", "MPLCONFIGDIR": ""}
        done = subprocess.run(
            [*words, "a.svg"], cwd=tmp_path / name, env=env | variables, capture_output=True,
            text=True, timeout=120,
        )  # fmt: skip
        assert (done.returncode, done.stderr) == (0, "")
        pictures.append((tmp_path / name / "a.svg").read_bytes())
    assert pictures[0] == pictures[1] == pictures[2]
    assert any("fontlist" in path.name for path in (tmp_path / "of fonts" / "fonts").iterdir())


def test_nothing_is_imported_from_the_current_folder(tmp_path):
    for name in ("json", "re", "click", "numpy", "contextlib"):
        (tmp_path / f"{name}.py").write_text("print('planted')\nraise SystemExit(9)\n")
    words = ["convert", "100", "lx", "zork", "--json"]
    launcher = [sys.executable, str(ROOT / "bin" / "radcalc")]

    def planted(*start):
        done = subprocess.run(
            [*start, *words], cwd=tmp_path, capture_output=True, text=True, timeout=60
        )
        return "planted" in done.stdout

    assert not planted(*launcher)
    assert not planted(sys.executable, "-P", "-m", "radcalc")
    assert planted(sys.executable, "-m", "radcalc")


# Every form of number of the grammars of expressions and units, each a little above its limit
# (10^12000 has some 40 000 bits): all of them could be worked out in no time.
FORMS = ("{}^{}", "{}**{}", "{}^({})", "({})^{}", "(({}))**({})", "2*{}^{}", "1/{}^{}", "{}^-{}")
LARGE = [form.format("10", power) for form in FORMS for power in ("1001", "1.001e3", "1001.5")]
LARGE += [
    "10¹⁰⁰¹", "(10^999)^13", "((10^99)^99)^2", "(10^999)^12 * 10^999", "1/(10^999)^13",
    "(10^900)^12 * (1/3)^900 lx", "((10^999)^12 + 1)^2 lx", "(1/3^1000)^30", "sqrt(10^999)^999",
    "(2^100)^(1999/2)", "exp(700)^60", "exp(709)", "ln(10^999)^1001", "pi^1001", "c^1001", "h^999",
    "1e300 lx^13", "1 lx^13", "1 lx¹³", "1 (lx^12)^2", "(1e99 m)^99", "(1+-0.1)^1001", "1e309",
    "1e-309", "9" * 400, "9" * 1001, "(" * 17 + "1" + ")" * 17, "(" * 400 + "1" + ")" * 400,
    "1" + " (" * 17 + "lx" + ")" * 17, "+".join(["1"] * 600), "2*" * 550 + "1", "-" * 1001 + "1",
]  # fmt: skip
MOST_CALLS = 50_000  # of Python's functions, for a refusal: a few hundredths of a second


@pytest.mark.parametrize("text", LARGE, ids=lambda text: text[:40])
def test_every_size_is_bounded(text):
    calls = 0

    def count(_, event, *rest):
        nonlocal calls
        calls += event == "call"

    sys.setprofile(count)
    try:
        with pytest.raises(RadcalcError) as caught:
            read_amount(text)
    finally:
        sys.setprofile(None)
    assert calls < MOST_CALLS
    assert len(caught.value.message) < 300


# 0 has every exponent; its value is 0, and its ratio has few digits.
@pytest.mark.parametrize("zero", ["0", "0.0", "00.00"])
@pytest.mark.parametrize("exponent", ["9999", "-9999", "+400"])
def test_the_exponent_of_0_has_no_size(zero, exponent):
    text = f"{zero}e{exponent}"
    for amount in map(read_amount, (f"{text} lx", f"2*{text} lx")):
        top, bottom = amount.exact.as_integer_ratio()
        assert top == 0 < bottom < 10**5000
    assert read_amount(f"(2^{text}) lx").number == 1


def test_a_stream_copies_what_is_not_a_number():
    call = [sys.executable, "-m", "radcalc", "convert", "-", "lx", "fc", "--field", "2"]
    done = subprocess.run(call, input=b"\x1b[31m\xff 100\n", capture_output=True, timeout=60)
    assert done.stdout == b"\x1b[31m\xff 9.290304\n"
