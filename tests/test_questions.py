"""The open list of questions of tests/questions, answered by radcalc in its own words."""

import re
import shlex
from collections import Counter

from conftest import ROOT, run
from helpers import for_each
from homework.questions import asked
from questions.compare import FILES, NOTHING, QUESTIONS, Question, first_number, pint

from radcalc.homework import Verdict, check

UNANSWERED = 14  # rows without a command; a change may only make them fewer
EXPLAINED = 349  # wrong answers whose mistake is named; a change may only make them more
LACKS_PINT = ("footcandle", "footlambert")
WRONG = re.compile(r"(\S+) (.+?) = .+")
ANSWERED = [row for row in QUESTIONS if row.radcalc != NOTHING and row.has_answer]
REFUSED = [row for row in QUESTIONS if row.radcalc != NOTHING and not row.has_answer]


def wrong_answers(row: Question) -> list[tuple[str, str]]:
    """Return the numbers and the units of the wrong answers of a row."""
    found = [WRONG.fullmatch(text) for text in row.wrong.split(" ; ")]
    assert all(found), row.wrong
    return [(match[1], match[2]) for match in found if match]


def test_the_lists_are_complete():
    assert len(FILES) == 10
    assert len({row.id for row in QUESTIONS}) == len(QUESTIONS) == 300
    for row in QUESTIONS:
        assert all(row), row.id
        assert "http" in row.source, row.id
        assert wrong_answers(row), row.id
        assert row.has_answer == (row.unit != NOTHING) == (row.tolerance != NOTHING), row.id


@for_each([row for row in QUESTIONS if row.has_answer and row.formula != NOTHING])
def test_values_follow_from_their_formulas(row: Question):
    number = pint(row.formula, row.target, True)
    if number is None:
        assert set(LACKS_PINT) & set(re.findall("[a-z]+", f"{row.formula} {row.target}"))
    else:
        assert row.is_right(number), number


@for_each(ANSWERED)
def test_radcalc_answers(row: Question):
    number = float(run(*shlex.split(row.radcalc), "-q", check=True).stdout.split()[0])
    assert row.is_right(number), f"{number} for {row.value} {row.unit}"


@for_each(REFUSED)
def test_radcalc_refuses_what_has_no_answer(row: Question):
    refused = run(*shlex.split(row.radcalc), "-q")
    assert refused.returncode == 2
    assert not refused.stdout
    assert "\ntry: " in refused.stderr


def test_rows_without_a_command_become_fewer():
    missing = [row for row in QUESTIONS if row.radcalc == NOTHING]
    assert len(missing) <= UNANSWERED
    assert all(row.note != NOTHING for row in missing)


def verdicts(row: Question) -> list[Verdict]:
    """Let `--check` judge the wrong answers of a row, to the tolerance of the row."""
    words = shlex.split(row.radcalc)
    name = unit = ""
    if "-g" in words:
        at = words.index("-g")
        name, _, unit = words[at + 1].partition(":")
        del words[at : at + 2]
    elif words[0] != "convert":
        words.insert(0, "convert")
    question = asked(shlex.join(words), name)
    tolerance = f"{100 * min(float(row.tolerance), 0.01):.10f}%"
    return [
        check(
            question,
            (f"{name}=" if name else "") + number + (unit if its_unit == row.unit else its_unit),
            tolerance,
        )
        for number, its_unit in wrong_answers(row)
    ]


def test_wrong_answers_are_called_wrong():
    explained = 0
    for row in ANSWERED:
        for found in verdicts(row):
            assert not found.right, row.id
            explained += bool(found.diagnoses)
    assert explained >= EXPLAINED


def as_asked(row: Question) -> str:
    """Ask radcalc for the plain conversion of a row; return the verdict on its answer."""
    return row.verdict(
        first_number(run("convert", *row.ask.split(" ", 1), row.target, "-q").stdout)
    )


def test_the_page_is_current():
    page = (ROOT / "docs" / "questions.md").read_text("utf-8")
    named = re.findall(r"^- `([\w-]+)` \(", page, re.MULTILINE)
    assert named == [row.id for row in QUESTIONS if row.radcalc == NOTHING]
    asked = [row for row in QUESTIONS if row.ask != NOTHING]
    found = Counter((row.has_answer, as_asked(row)) for row in asked)
    counts = [found[True, "right"], found[True, "none"], found[True, "wrong"]]
    counts += [found[False, "none"], found[False, "wrong"]]
    (cells,) = re.findall(r"^\| radcalc \S+ \|(.*)\|$", page, re.MULTILINE)
    assert [int(cell) for cell in cells.split("|")][:5] == counts
    answers = f"{len(ANSWERED)} of the {sum(row.has_answer for row in QUESTIONS)} questions"
    for text in (page, (ROOT / "README.md").read_text("utf-8")):
        assert answers in text
