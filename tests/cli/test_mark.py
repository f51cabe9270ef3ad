"""Sheets of questions: what `radcalc mark` makes of the key and of the answers of students."""

import csv
import io
import json
import os
from math import asin, cos, degrees, log2, pi, radians, sqrt

import pytest
from conftest import run
from helpers import terminal_of

# Twenty questions of ten trades: trade, command, and the right answer from outside radcalc.
QUESTIONS = (
    ("stage", "point-source --intensity 100cd --distance 2m -g illuminance", f"{100 / 2**2} lx"),
    ("stage", "20000 cd at 8 m to lx", f"{20000 / 8**2} lx"),
    # NIST SP 811, Appendix B: 1 fc = 10.76391 lx, 1 fL = 3.426259 cd/m2
    ("stage", "radcalc 500 lx to fc", f"{500 / 10.76391:.6g} fc"),
    ("cinema", "16 fL to cd/m2", f"{16 * 3.426259:.6g} cd/m2"),
    ("cinema", "screen --flux 3000lm --width 5m --height 2.1m -g illuminance", "285.714 lx"),
    # ISO 2720: 2^EV = N^2 / t
    ("photography", "ev --f-number 8 --time 1/125s -g ev", f"{log2(8**2 * 125):.6g}"),
    # ISO 12232: E = pi L / (4 N^2) on the axis of a lens without losses, focused at infinity
    ("photography", "sensor --luminance 4000cd/m2 --f-number 16 -g illuminance",
     f"{pi * 4000 / (4 * 16**2):.6g} lx"),
    ("growing", "500 umol/m2/s to mol/m2 --time 12h", f"{500e-6 * 12 * 3600} mol/m2"),
    # CODATA 2018: N_A h c = 0.11962656582 J m/mol
    ("growing", "convert 1 W/m2 umol/m2/s --wavelength 660nm",
     f"{660e-9 / 0.11962656582 * 1e6:.6g} umol/m2/s"),
    # CODATA 2018: h c = 1239.841984 eV nm, sigma = 5.670374419e-8 W/m2/K4
    ("physics", "532 nm eV", f"{1239.841984 / 532:.6g} eV"),
    ("physics", "5778 K MW/m2", f"{5.670374419e-8 * 5778**4 / 1e6:.6g} MW/m2"),
    # the definition of the metre in the SI
    ("physics", "", "299792458 m/s"),
    # IAU 2015, resolution B3: nominal solar luminosity and total irradiance; B2 of 2012: the au
    ("astronomy", "convert '1361 W/m2 * 4 pi m2 * 149597870700^2' W", "3.828e26 W"),
    ("astronomy", "solid-angle cone --apex-angle 0.5deg -g solid-angle",
     f"{2 * pi * (1 - cos(radians(0.25))):.6g} sr"),
    # BIPM, SI Brochure: Km = 683.002 lm/W at the maximum of V(lambda)
    ("lasers", "convert 1 W lm --wavelength 555nm", "683.002 lm"),
    # Siegman, Lasers, 17.1: the peak of a Gaussian beam is 2 P / (pi w^2)
    ("lasers", "laser --flux 1mW --diameter 1mm -g peak-irradiance",
     f"{2e-3 / (pi * 0.5e-3**2):.6g} W/m2"),
    ("museum", "50 lx to klx.h --time 8h*300", f"{50 * 8 * 300 / 1000} klx.h"),
    # Lambert's law: M = pi L; a disc gives L pi sin^2
    ("graphics", "lambertian disc --luminance 1e4cd/m2 --radius 25cm --height 75cm -g illuminance",
     f"{pi * 1e4 * 25**2 / (25**2 + 75**2):.6g} lx"),
    ("graphics", "lambertian --luminance 100cd/m2 -g exitance", f"{100 * pi:.6g} lm/m2"),
    # Snell's law
    ("optics", "refraction --index 1.5 --incidence 30deg -g refraction-angle",
     f"{degrees(asin(0.5 / 1.5)):.6g} deg"),
)  # fmt: skip
RIGHT = [right for _, _, right in QUESTIONS]
CALLS = {call: place for place, (_, call, _) in enumerate(QUESTIONS)}
LAMP = "point-source --intensity 100cd --distance 2m -g illuminance"


def answers(changed):
    """Return the right answers of a student, but for some questions."""
    return [changed.get(call, right) for (_, call, right) in QUESTIONS]


# The verdicts, mistakes and points that are not full.
CHANGES = {
    "Ann": {},
    "Ben": {LAMP: ("25", "unit missing", "", 0.5), "532 nm eV": ("2.33", "unit missing", "", 0.5)},
    "Cyn": {
        LAMP: ("50 lx", "mistake", "distance-not-squared", 0.5),
        "lambertian --luminance 100cd/m2 -g exitance":
            ("628 lm/m2", "mistake", "two-pi-for-pi", 0.5),
        "solid-angle cone --apex-angle 0.5deg -g solid-angle": ("6e-5 sr", "right", "", 1),
        "532 nm eV": ("2 eV", "too few digits", "", 0.75),
    },
    "Dan": {
        LAMP: ("", "no answer", "", 0),
        "532 nm eV": ("abc eV", "not readable", "", 0),
        "16 fL to cd/m2": ("3 m", "wrong", "wrong-unit", 0),
        "5778 K MW/m2": ("12345 MW/m2", "wrong", "", 0),
    },
    "Éva": {LAMP: ("E = 25.0 lx", "right", "", 1)},
}  # fmt: skip
HEADER = ["question", "command", "expected", "points", *CHANGES]


def rows(decimal="."):
    """Return the sheet as rows of cells, with another decimal mark in what is not a command."""
    columns = [answers({c: change[0] for c, change in own.items()}) for own in CHANGES.values()]
    yield HEADER
    for k, (trade, call, right) in enumerate(QUESTIONS):
        numbers = [right if k % 2 or not call else "", "1", *(column[k] for column in columns)]
        yield [f"{trade} {k + 1}", call, *(n.replace(".", decimal, 1) for n in numbers)]


def written(delimiter, decimal=".", quoting=csv.QUOTE_MINIMAL):
    text = io.StringIO()
    lines = csv.writer(text, delimiter=delimiter, lineterminator="\n", quoting=quoting)
    lines.writerows(rows(decimal))
    return text.getvalue()


def in_markdown():
    lines = [f"| {' | '.join(row)} |\n" for row in rows()]
    return "".join([lines[0], "|---" * len(HEADER) + "|\n", *lines[1:]])


SHEETS = {
    "commas": written(",").encode(),
    "semicolons and decimal commas": written(";", ",").encode(),
    "quotes": written(",", ",", csv.QUOTE_ALL).encode(),
    "tabs, byte order mark, Windows": b"\xef\xbb\xbf"
    + written("\t").replace("\n", "\r\n").encode(),
    "UTF-16": written("\t").encode("utf-16"),
    "Latin-1": written(";", ",").encode("latin-1"),
    "bars": "".join(" | ".join(row) + "\n" for row in rows()).encode(),
    "Markdown": in_markdown().encode(),
    "a title above": b"Homework 3;;\n\n" + written(";", ",").encode(),
}


def marked(path, *options):
    """Return the exit status and the records of a sheet, without the totals."""
    done = run("mark", str(path), "--json", *options)
    assert done.stdout, done.stderr
    return done.returncode, json.loads(done.stdout)["records"]


def sheet(tmp_path, text):
    path = tmp_path / "sheet.csv"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return path


@pytest.mark.parametrize("kind", SHEETS)
def test_a_class_has_the_verdicts_of_every_form_of_a_sheet(tmp_path, kind):
    status, records = marked(sheet(tmp_path, SHEETS[kind]))
    assert status == 1
    assert len(records) == len(CHANGES) * (len(QUESTIONS) + 1)
    for student, changes in CHANGES.items():
        own = [record for record in records if record["student"] == student]
        most = 0
        for (_, call, right), record in zip(QUESTIONS, own, strict=False):
            verdict, mistake, points = changes.get(call, ("", "right", "", 1))[1:]
            found = (record["verdict"], record["mistake"], record["points"], record["of"])
            assert found == (verdict, mistake, points, 1), (student, call, right, record)
            most += points
        total = own[-1]
        assert (total["verdict"], total["points"], total["of"]) == ("total", most, len(QUESTIONS))


def test_all_right_is_status_0(tmp_path):
    path = sheet(tmp_path, f"command;Ann\n{LAMP};25 lx\n")
    done = run("mark", str(path))
    assert (done.returncode, len(done.stdout.splitlines())) == (0, 2)
    assert "line 2: assumed: light arrives along" in done.stderr
    assert run("mark", str(path), "-q").stderr == ""


def test_a_gradebook_has_the_records_of_json(tmp_path):
    path = sheet(tmp_path, SHEETS["commas"])
    done = run("mark", str(path), "--format", "csv", "-q")
    lines = [*csv.DictReader(io.StringIO(done.stdout))]
    _, records = marked(path)
    assert [*lines[0]] == [*records[0]]
    assert lines == [{key: str(text) for key, text in record.items()} for record in records]


# Each answer to 25 lx with points; the rule is in radcalc-mark(1).
ANSWERS = {
    "25 lx": ("right", 2),
    "25.1 lx": ("right", 2),  # within 1 %
    "2.3226 fc": ("right", 2),  # NIST SP 811: 25 / 10.76391
    "E = 25 lx": ("right", 2),
    "illuminance=25": ("unit missing", 1),
    "2.5e1": ("unit missing", 1),
    "20+5": ("unit missing", 1),
    "3e1 lx": ("too few digits", 1.5),
    "3e1": ("unit missing", 1),
    "50 lx": ("mistake", 1),
    "25 cd": ("mistake", 1),  # the number is right
    "50": ("wrong", 0),  # a mistake, and no unit
    "26 cd": ("wrong", 0),
    "flux=1257 lm": ("wrong", 0),  # right for another result
    "25 blorps": ("not readable", 0),
    "x=25 lx": ("not readable", 0),
    "1,250 lx": ("not readable", 0),
    "-": ("not readable", 0),
    "`rm x`": ("not readable", 0),
    "9" * 5000: ("not readable", 0),
    "": ("no answer", 0),
}


def test_points_follow_the_rule(tmp_path):
    for answer, (verdict, points) in ANSWERS.items():
        path = sheet(tmp_path, f"command;points;Ann\n{LAMP};2;{answer}\n")
        _, (record, total) = marked(path)
        assert (record["verdict"], record["points"], record["of"]) == (verdict, points, 2), answer
        assert (total["points"], total["of"]) == (points, 2)
        has_reason = verdict in ("wrong", "mistake", "not readable", "too few digits")
        assert bool(record["likely"]) == (has_reason or answer == "3e1"), answer
    status, _ = marked(sheet(tmp_path, f"command;Ann\n{LAMP};3e1 lx\n"), "--points", "digits=1")
    assert status == 1


@pytest.mark.parametrize(
    ("points", "got"),
    [
        ("unit=0,digits=1,mistake=0.25", [0, 1, 0.25, 1.25]),
        ("mistake=1/4", [0.5, 0.75, 0.25, 1.5]),
        ("unit=1", [1, 0.75, 0.5, 2.25]),
    ],
)
def test_points_are_adjusted(tmp_path, points, got):
    text = f"command,Ann\n{LAMP},25\n{LAMP},3e1 lx\n{LAMP},50 lx\n"
    _, records = marked(sheet(tmp_path, text), "--points", points)
    assert [record["points"] for record in records] == got


@pytest.mark.parametrize("points", ["", "x=1", "unit", "unit=", "unit=2", "unit=-1", "right=1"])
def test_impossible_points_are_refused(tmp_path, points):
    done = run("mark", str(sheet(tmp_path, f"command,Ann\n{LAMP},25\n")), "--points", points)
    assert (done.returncode, done.stdout) == (2, "")
    assert "--points" in done.stderr


def test_a_tolerance_applies_to_all_questions_or_to_one(tmp_path):
    text = f"command,Ann\n{LAMP},26 lx\n{LAMP} --tolerance 1sf,29 lx\n"
    for options, verdicts in (((), "wrong right"), (("--tolerance", "5%"), "right right")):
        _, (*records, _) = marked(sheet(tmp_path, text), *options)
        assert " ".join(record["verdict"] for record in records) == verdicts


def test_a_fraction_is_a_number_or_a_percentage(tmp_path):
    call = "solid-angle cone --half-angle 30deg -g sphere-fraction:%"
    right = (1 - sqrt(3) / 2) / 2  # (1 - cos 30 deg) / 2
    text = f"command,Ann,Bob,Cyn\n{call},{right:.4f},{100 * right:.2f},{100 * right:.2f} %\n"
    _, records = marked(sheet(tmp_path, text))
    verdicts = [record["verdict"] for record in records if record["of"] and record["question"]]
    assert verdicts == ["right", "unit missing", "right"]


def test_a_decimal_comma_makes_a_point_of_thousands_ambiguous(tmp_path):
    text = f"command;Ann;Bob\n{LAMP};25,0 lx;25.000 lx\n{LAMP};25.000 lx;25.000 lx\n"
    _, records = marked(sheet(tmp_path, text))
    verdicts = {(r["student"], r["verdict"]) for r in records if r["question"]}
    assert verdicts == {("Ann", "right"), ("Ann", "not readable"), ("Bob", "right")}


# Calls that are not questions, and a part of the refusal.
HOSTILE = {
    "environment m.hdr --unit W/m2/sr --save x.hdr": "--save cannot be used in a question",
    "sky overcast --zenith-luminance 1kcd/m2 --plot x.svg": "--plot cannot be used in a question",
    "sky overcast --zenith-luminance 1kcd/m2 --plot=x.svg": "cannot be used in a question",
    "spectrum D65 --list": "--list cannot be used in a question",
    "convert 5 lx fc --format csv": "--format does not apply to a question",
    "convert 5 lx fc --definitions x.txt": "--definitions does not apply to a question",
    "convert - lx fc": "- is not a value or a regular file",
    "point-source --intensity 1cd --distance '- m' -g illuminance": "- m is not a value",
    "point-source --distribution /dev/stdin --distance 2m -g illuminance": "/dev/stdin is not",
    "dose -": "- is not a value or a regular file",
    "convert 5 lx fc -qh": "-qh cannot be used in a question",
    "--help": "--help cannot be used in a question",
    "convert 5 lx fc --version": "--version cannot be used in a question",
    "convert 5 lx fc --explain": "--explain cannot be used in a question",
    "units lux": "radcalc units has no answer to check",
    "prompt": "radcalc prompt has no answer to check",
    "mark sheet.csv": "radcalc mark has no answer to check",
    "convert 5 lx fc `touch x`": "too many words",
    "convert 5 lx fc $(touch x)": "too many words",
    "convert 5 lx fc > x": "too many words",
    "convert 5 lx fc | tee x": "too many words",
    "rm -f x": "unknown command 'rm'",
    "touch x": "unknown command 'touch'",
    "convert 5 lx,6 fc": "the unit 'lx,6' has",
    "convert 5,6 lx fc": "has a comma in its number",
    "convert 5lx,6lx fc": "a question takes one answer, not several",
    "convert 1:5:1 lx fc,klx": "a question",
    "convert 5 lx": "a question needs a unit to convert to",
    "point-source --intensity 1cd --distance 1m,2m -g illuminance": "a question takes one answer",
    "point-source --intensity 1cd --distance 2m": "a question has one answer, but its command has",
    "point-source --intensity 1cd --distance 2m -g x": "unknown result 'x'",
    "point-source --intensity 1cd --distance 2m -g flux -g illuminance": "several results",
    "point-source --intensity 1cd --distance 2m --check 5lx": "an answer in its command",
    "point-source --intensity 1cd -g illuminance": "the inputs do not give",
    "convert 'abc": "the ' has no second one",
    "radcalc": "the command is missing",
    "5 " * 10_000: "is too long",
}


@pytest.mark.parametrize("call", HOSTILE)
def test_a_command_that_is_not_a_question_is_refused_before_any_output(tmp_path, call):
    bar = "\t" if "|" in call or "," in call else ";"
    text = bar.join(["command", "Ann"]) + "\n" + bar.join([LAMP, "25 lx"]) + "\n"
    path = sheet(tmp_path, text + bar.join([call, "5 lx"]) + "\n")
    done = run("mark", path.name, cwd=tmp_path, input="5\n")
    assert (done.returncode, done.stdout) == (2, ""), done.stderr
    assert "sheet.csv, line 3, column 'command': " in done.stderr
    assert HOSTILE[call] in done.stderr
    assert "\ntry: " in done.stderr
    assert os.listdir(tmp_path) == ["sheet.csv"]


def test_a_hint_is_the_command_that_is_answered(tmp_path):
    call = "point-source --intensity 100cd --distance 2m"
    done = run("mark", str(sheet(tmp_path, f"command;Ann\n{call};25 lx\n")))
    assert f"try: radcalc {call} -g flux:lm or radcalc {call} -g illuminance:lx" in done.stderr
    _, (record, _) = marked(sheet(tmp_path, f"command;Ann\n{call} -g illuminance:lx;25 lx\n"))
    assert record["verdict"] == "right"


def test_an_expected_value_chooses_the_result_and_has_to_agree(tmp_path):
    call = "point-source --intensity 100cd --distance 2m"
    path = sheet(tmp_path, f"command;expected;Ann\n{call};25 lx;25\n")
    _, (record, _) = marked(path)
    assert (record["verdict"], record["right"]) == ("unit missing", "25 lx")
    for wrong in ("30 lx", "25 kg", "25.5 lx"):
        done = run("mark", str(sheet(tmp_path, f"command;expected;Ann\n{LAMP};{wrong};25\n")))
        assert done.returncode == 2
        assert (
            f"column 'expected': {wrong} contradicts the command, which gives 25 lx" in done.stderr
        )


# Sheets that cannot be read, and a part of the refusal.
BAD = {
    "": "the file has no question",
    "\n;;\n": "the file has no question",
    "command;Ann\n": "the file has a header but no question",
    "question;Ann\nx;5 lx\n": "line 1: a column 'command' or 'expected' is missing",
    "command\nconvert 5 lx fc\n": "line 1: no column has answers",
    "comand;expected;Ann\nx;5 lx;5 lx\n": "column 'comand' is not a student\ntry: command",
    "command;Ann;Ann\nx;5 lx;5 lx\n": "column 'Ann' appears twice",
    "command;;Ann\nx;5 lx;5 lx\n": "column 2 has no title",
    "command;Ann\n5 lx fc\n": "line 2: 1 column instead of 2",
    "command;Ann\n5 lx fc;1;2\n": "line 2: 3 columns instead of 2",
    'command;Ann\n"5 lx fc\nx";1\n': "line 2: 1 column instead of 2",
    "expected;Ann\n;1\n": "line 2: the question has neither a command nor an expected value",
    "expected;Ann\nabc;1\n": "line 2, column 'expected': 'abc' is not a number",
    "expected;points;Ann\n5 lx;x;1\n": "line 2: 'x' is not a number",
    "expected;points;Ann\n5 lx;;1\n": "line 2: a value is missing",
    "expected;points;Ann\n5 lx;-1;1\n": "less than none",
    "expected;Ann\n1,5 lx;1\n1.500 lx;1\n": "line 3: '1.500' is ambiguous",
    "expected;Ann\n" + "5" * 10_000_000 + ";5\n": "line 2: the line has more than",
    "command;Ann\n" + "5" * 3_000_000 + ";5\n": "a line of 3000000 characters is too long",
}  # fmt: skip


@pytest.mark.parametrize("text", BAD, ids=range(len(BAD)))
def test_a_bad_sheet_is_refused_with_its_line(tmp_path, text):
    done = run("mark", str(sheet(tmp_path, text)))
    assert (done.returncode, done.stdout) == (2, "")
    assert BAD[text] in done.stderr
    assert "\ntry: " in done.stderr


def test_files_that_are_not_there_or_not_named_are_refused(tmp_path):
    assert "cannot read" in run("mark", str(tmp_path / "none.csv")).stderr
    assert "the file of the sheet is missing" in run("mark").stderr
    assert "unexpected argument 'b.csv'" in run("mark", "a.csv", "b.csv").stderr
    assert run("mark", "-", input=f"command;Ann\n{LAMP};25 lx\n").returncode == 0


@pytest.mark.parametrize("width", [60, 80, 120])
def test_a_terminal_shows_every_verdict(tmp_path, width):
    path = sheet(tmp_path, SHEETS["commas"])
    text = terminal_of("mark", str(path), columns=width, NO_COLOR="1").replace("\r", "")
    assert max(map(len, text.splitlines())) <= width
    words = " ".join(text.split())
    for student, changes in CHANGES.items():
        assert student in words
        for answer, *_ in changes.values():
            assert all(word in words for word in answer.split())
    assert "the distance was not squared" in " ".join(words.split()) or width < 120


def test_cells_that_a_spreadsheet_may_run_have_a_note(tmp_path):
    """As OWASP lists the beginnings of formulas (CSV Injection); +5 lx and -3 are answers."""
    sheet = tmp_path / "sheet.csv"
    sheet.write_text(
        "question,expected,Ann,=Bob\n=1+1,2 lx,+2 lx,@SUM(1)\nB,-3 m,-3 m,-3+cmd|' /C x'!A0\n"
    )
    done = run("mark", str(sheet), "--format", "csv")
    cells = "7 cells begin with =, +, - or @, which a spreadsheet may run"
    assert f"note: {cells}\n" in done.stderr
    assert "=Bob,=1+1,@SUM(1)," in done.stdout  # copied
    for form in ("plain", "table", "json"):
        done = run("mark", str(sheet), "--format", form)
        assert "which a spreadsheet" not in done.stdout + done.stderr
    sheet.write_text("question,expected,Ann\n@A,2 lx,2 lx\n")
    assert "note: a cell begins with" in run("mark", str(sheet), "--format", "csv").stderr


def test_titles_of_columns_are_counted_too(tmp_path):
    table = tmp_path / "log.csv"
    table.write_text("=time,E [lx]\n1,2\n2,3\n")
    assert "note: a cell begins with =" in run("columns", str(table), "--format", "csv").stderr


# A key on a scale: the command or the expected value, and an answer that is right, has no unit, is
# wrong.  12 + lb 8 = 15; lb 8 = 3; 0.9 OD is 9 dB; 1e6/200 = 5000; 250 lx 2^15/100 = 81920 lx.
ON_SCALES = (
    ("ev --ev100 12 --iso 800 -g ev:EV", "", "15 EV", None, "14 EV"),
    ("ev --ev100 12 --iso 800 -g luminance:EV", "", "512 cd/m2", "12", "12.1 EV"),
    ("ev --nd 0.9 --time 1/60s -g nd:OD", "", "3 stops", None, "0.8"),
    ("ev --nd 0.9 --time 1/60s -g stops", "3 stops", "9 dB", None, "-3 stops"),
    ("convert 8 1 stops", "", "3 stops", "3", "8"),
    ("", "3 stops", "800%", "3", "8"),
    ("", "0.9 OD", "-9 dB", "0.9", "0.126"),
    ("", "-3 dB", "0.3 OD", "-3", "3 dB"),
    ("", "15 EV", "15EV", "15", "14.9EV"),
    ("", "21 mag/arcsec2", "21 mpsas", "21", "21.1"),
    ("", "200 mired", "5000 K", "200", "210 mired"),
    ("", "10+-0.5 dBm", "-20.5 dBW", "10.5", "10.6 dBm"),
)


def test_a_key_may_be_on_a_scale(tmp_path):
    lines = ["question;command;expected;A;B;C"]
    for k, (command, expected, right, bare, wrong) in enumerate(ON_SCALES):
        lines.append(f"{k};{command};{expected};{right};{bare or right};{wrong}")
    sheet = tmp_path / "sheet.csv"
    sheet.write_text("\n".join(lines), encoding="utf-8")
    done = run("mark", str(sheet), "--json")
    found = {
        (r["question"], r["student"]): r["verdict"] for r in json.loads(done.stdout)["records"]
    }
    for k, (*_, bare, _) in enumerate(ON_SCALES):
        verdicts = [found[f"{k}", student] for student in "ABC"]
        assert verdicts == ["right", "unit missing" if bare else "right", "wrong"], ON_SCALES[k]
