"""Every answer of every transcript is in one schema as JSON, and in one shape as CSV."""

import csv
import io
import json
import shlex
import subprocess
from functools import cache
from pathlib import Path

import jsonschema
import pytest
from conftest import run
from following import call
from helpers import PLAIN, answers, example_of, for_each
from test_cases import FILES, transcripts

from radcalc.calculators import COMMANDS
from radcalc.cli.spelling import Shell

SCHEMA = json.loads(Path(__file__).with_name("schema.json").read_text(encoding="utf-8"))
VALIDATOR = jsonschema.Draft202012Validator(SCHEMA)
BARE = {"-n", "--number", "--json", "--format"}
NO_ANSWERS = {"--help", "-h", "--version", "--plot"}
# lists of what there is
LISTS = ("units", "quantities", "typical", "examples", "help", "columns", "mark", "spectrum --list")
MORE = (
    "columns examples/gallery.csv",
    "mark examples/homework.csv",
    "units lux",
    "units W/m2",
    "typical sun",
    "spectrum --list",
    "examples uv",
    "help lux",
)
ROOM = "name,x,y,z,flux\ndesk,1,2,1.2,400lm\ndoor,5,0.5,2.5,800lm\n"


def words_of(command):
    """Return the words of a call without those that select its format."""
    words = iter(shlex.split(command, comments=True)[1:])
    return [word for word in words if word not in BARE or (word == "--format" and next(words) * 0)]


def calls():
    """Return the calls of radcalc with an answer in the transcripts."""
    for path in FILES:
        for command, output in transcripts(path):
            is_plain = command.startswith("radcalc ") and not set("|<>;&$`") & set(command)
            if is_plain and not output.startswith("radcalc: ") and not output.endswith("[2]\n"):
                words = words_of(command)
                if words and not NO_ANSWERS & set(words) and not Path(words[0]).is_file():
                    yield shlex.join(words)


def piped(called):
    """Return the calls of a command with piped input, and the input."""
    for path in FILES:
        for command, output in transcripts(path):
            text, pipe, words = command.partition(" | ")
            is_plain = words.startswith(f"radcalc {called} ") and not set("|<>$;") & set(words)
            if pipe and is_plain and not output.endswith("[2]\n"):
                yield text, shlex.join(words_of(words))


EXAMPLES = {Shell.command(name, *example_of(name)).removeprefix("radcalc ") for name in PLAIN}
CALLS, STREAMS = sorted({*calls(), *MORE, *EXAMPLES}), sorted({*piped("convert -")})
LOGS = sorted({*piped("dose -")})
# Sentences among the calls, which may mean any command.
SENTENCES = {
    text
    for text in CALLS
    if " at " in text or text.startswith(("f/", "EV ", "iso ", "how ")) or " f/" in text
}
ANSWERS = [text for text in CALLS if not text.startswith(LISTS)]


def command_of(text):
    """Return the command of a call; it is a conversion if it begins with a value."""
    word = shlex.split(text)[0]
    return word if word in COMMANDS else "convert"


@cache
def as_json(text, *more):
    """Return the answers to a call, checked against the schema; several tests use one."""
    done = call([*shlex.split(text), *more, "--json"])
    assert done.status in (0, 1), (done.error, done.error and done.error.hint)
    VALIDATOR.validate(json.loads(done.output))
    return answers(done.output)


def test_the_schema_and_the_transcripts_exist():
    jsonschema.Draft202012Validator.check_schema(SCHEMA)
    assert len(CALLS) > 250
    assert len(STREAMS) > 10
    assert len(LOGS) > 10
    assert {"scene", "prompt", "manual", "dose", *map(command_of, CALLS)} >= COMMANDS.keys()


@for_each(CALLS)
def test_every_answer_is_valid(text):
    is_sentence = text in SENTENCES
    for answer in as_json(text):
        assert answer["command"] == command_of(text) or is_sentence


@for_each(STREAMS)
def test_every_line_of_a_stream_is_valid(text, words):
    lines = subprocess.run(["sh", "-c", text], stdout=subprocess.PIPE, text=True).stdout
    done = run(*shlex.split(words), "--json", input=lines)
    assert done.stdout
    for line in done.stdout.splitlines():
        VALIDATOR.validate(json.loads(line))
        assert json.loads(line)["line"]


@for_each(LOGS)
def test_every_answer_of_a_log_is_valid(text, words):
    log = subprocess.run(["sh", "-c", text], stdout=subprocess.PIPE, text=True).stdout
    done = run(*shlex.split(words), "--json", input=log)
    assert done.returncode in (0, 1)
    VALIDATOR.validate(json.loads(done.stdout))
    assert {one["command"] for one in answers(done.stdout)} == {"dose"}


# with --auto a column has one prefix, and in JSON each answer has its own
NUMBERS = [text for text in ANSWERS if "--check" not in text and "--auto" not in text]


@for_each(NUMBERS)
def test_csv_has_the_same_numbers_on_a_line_an_answer(text):
    found = as_json(text)
    done = call([*shlex.split(text), "--format", "csv"])
    assert done.status == 0
    header, *lines = csv.reader(io.StringIO(done.output))
    assert len(set(header)) == len(header)
    assert {len(line) for line in lines} == {len(header)}
    assert len(lines) == len(found)
    for answer, line in zip(found, lines, strict=True):
        cells = {head: cell for head, cell in zip(header, line, strict=True) if cell}
        for name, one in answer["results"].items():
            for amount in (one, *one.get("also", ())):
                head = f"{name}:{amount['unit']}"
                if not one["given"] or head in cells:
                    assert float(cells[head]) == amount["value"]


def listed(text):
    """Return whether a call lists all results of a calculator."""
    return command_of(text) != "convert" and not {"-g", "--get", "--check"} & {*shlex.split(text)}


@for_each([text for text in ANSWERS if listed(text)])
def test_get_accepts_every_name_of_a_result(text):
    found = as_json(text)
    names = [*found[0]["results"]]
    again = as_json(text, *(word for name in names for word in ("-g", name)))
    for one, other in zip(found, again, strict=False):
        assert one["inputs"] == other["inputs"]
        for name in names:
            asked = {k: v for k, v in one["results"][name].items() if k != "also"}
            if asked["unit"] == found[0]["results"][name]["unit"]:  # a list has one unit
                assert other["results"][name] == asked


SCENES = {
    "--at 0,0,0": 1,
    "--at 0,0,0 --at 1,1,0 -q": 3,  # and over all
    "--at 0,0,0 --at 1,1,0 -g irradiance -g share-desk": 2,
    "--grid 0:6:7,0:4:5,0.75": 1,
    "--grid 0:6:7,0:4:5,0.75 -g irradiance:fc": 35,
    "--at 0,0,0 --at 1,1,0 -g uniformity": 1,
    "--at 0,0,0 --check irradiance=9lx": 1,
}


@pytest.mark.parametrize("words", SCENES)
def test_every_answer_of_a_scene_is_valid(words, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    Path("room.csv").write_text(ROOM)
    found = as_json(f"scene room.csv {words}")
    assert len(found) == SCENES[words]
    assert found[0]["inputs"]["file"]["text"] == "room.csv"


def test_every_answer_that_writes_a_map_is_valid(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (made,) = as_json("sky --zenith-luminance 9000cd/m2 --save sky.pfm --size 64x32")
    assert made["inputs"]["save"] == {"text": "sky.pfm"}
    around = "environment sky.pfm --unit cd/m2"
    (made,) = as_json(f"{around} --irradiance-map lux.pfm --size 8x4 -g maximum-irradiance:klx")
    assert [*made["results"]] == ["maximum-irradiance"]
