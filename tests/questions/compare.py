"""Ask GNU units, qalc, Pint, astropy and radcalc the questions of this directory.

    python tests/questions/compare.py          the table of docs/questions.md
    python tests/questions/compare.py --list   one line for each answer that is wrong

A question is a row of a *.tsv file.  Its columns:

    question, value, unit, tolerance  what is asked, and the answer: a number with a relative
                       tolerance, or REFUSE if nobody can answer without more information
    condition, source  the condition of the answer (for REFUSE: what is missing), and its address
    wrong              typical wrong answers: `VALUE UNIT = cause ; ...`
    ask, target        the amount and the unit of somebody who asks a converter without the physics
    formula            the arithmetic of somebody who knows the physics
    radcalc, note      the command line of radcalc without `radcalc`, and a remark
    `-`                a column without an entry; in `radcalc`: it has no answer

Every tool is asked `ask` to `target`, and `formula` to `target`, in its own syntax.  Pint has its
default registry, and astropy its default units and `u.imperial`.  Where a plain conversion is
refused, Pint gets its context `spectroscopy` and astropy `u.spectral()`; the formulas of astropy
also get `u.dimensionless_angles()`.  A number in another unit than the target is not an answer.
Nothing is fetched from the network.

GNU units and qalc are programs, astropy is installed with `pip install astropy`.  A tool that is
missing is left out.
"""

import csv
import importlib.metadata
import math
import re
import shutil
import subprocess
import sys
import warnings
from collections import Counter
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

HERE = Path(__file__).parent
TIME_LIMIT = 10  # seconds for a call
REFUSE = "REFUSE"
NOTHING = "-"
NUMBER = re.compile(r"[-+]?\d+(?:\.\d*)?(?:[eE][-+]?\d+)?")
Asked = Callable[[str, str, bool], float | None]  # an expression, a target, and: is it a formula


class Question(NamedTuple):
    """A row of a list; the columns are those of the docstring above."""

    id: str
    trade: str
    question: str
    value: str
    unit: str
    tolerance: str
    condition: str
    source: str
    wrong: str
    ask: str
    target: str
    formula: str
    radcalc: str
    note: str

    @property
    def has_answer(self) -> bool:
        return self.value != REFUSE

    def is_right(self, number: float) -> bool:
        return self.has_answer and math.isclose(
            number, float(self.value), rel_tol=float(self.tolerance)
        )

    @property
    def is_typed(self) -> bool:
        """Whether the command of radcalc is a formula that the user types."""
        return self.radcalc.startswith("'")

    def verdict(self, number: float | None) -> str:
        if number is None:
            return "none"
        return "right" if self.is_right(number) else "wrong"


def read(path: Path) -> list[Question]:
    """Read one list."""
    with path.open(encoding="utf-8", newline="") as file:
        title, *rows = csv.reader(file, delimiter="\t", quoting=csv.QUOTE_NONE)
    assert tuple(title) == Question._fields, path
    return [Question(*row) for row in rows]


FILES = {path.name: read(path) for path in sorted(HERE.glob("*.tsv"))}
QUESTIONS = [question for rows in FILES.values() for question in rows]


Answers = list[tuple[Question, float | None]]  # None: no answer


def output(*words: str) -> str | None:
    """Return what a program prints, or None if it fails."""
    try:
        done = subprocess.run(words, capture_output=True, text=True, timeout=TIME_LIMIT)
    except subprocess.TimeoutExpired:
        return None
    return done.stdout.strip() if done.returncode == 0 else None


def number_in(text: str | None) -> float | None:
    found = NUMBER.fullmatch(text or "")
    return float(found[0]) if found else None


def first_number(text: str | None) -> float | None:
    """Return the number that radcalc prints, before its unit."""
    return number_in((text or "").partition("\t")[0])


def gnu_units(expression: str, target: str, is_formula: bool) -> float | None:
    """Ask GNU units, where dBm is a function, log10 is log, rad a dose, and an arc has a unit."""
    expression = re.sub(r"^(\S+) dBm$", r"dBm(\1)", expression).replace("log10(", "log(")
    expression = re.sub(r"\b(asin|acos|atan)\(", r"radian^-1 * \1(", expression)
    expression, target = (
        re.sub(r"\b(m?)rad\b", r"\1radian", text) for text in (expression, target)
    )
    return number_in(output("units", "-1", "-t", "-d", "15", "--", expression, target))


@cache
def qalc_prints(text: str) -> tuple[float, str] | None:
    """Return the number and the unit that qalc prints."""
    printed = output("qalc", "-t", "+u8", "-s", "precision 15", text) or ""
    found = NUMBER.match(printed)
    return (float(found[0]), printed[found.end() :].strip()) if found else None


def qalc(expression: str, target: str, is_formula: bool) -> float | None:
    """Ask qalc for the ratio to the target, which has no unit if it is an answer.

    Otherwise ask it to convert; the unit of an answer is the one in which it prints the target.
    """
    answer, unit = qalc_prints(f"({expression}) / ({target})"), ""
    if not answer or answer[1]:
        answer = qalc_prints(f"{expression} to {target}")
        unit = (qalc_prints(f"7 {target} to {target}") or (7, "no unit"))[1]
    return answer[0] if answer and answer[1] == unit else None


class Names(dict[str, Any]):
    """The names of an expression in Python: functions, pi, and units of a library."""

    def __init__(self, plain: Callable[[Any], float], unit: Callable[[str], Any]):
        """Make the functions for arguments that `plain` turns into numbers, angles into radians."""

        def function(calculate: Callable[[float], float]) -> Callable[[Any], float]:
            return lambda argument: calculate(plain(argument))

        names = ["sin", "cos", "tan", "asin", "acos", "atan", "exp", "log10", "log2"]
        super().__init__({name: function(getattr(math, name)) for name in names})
        self.update(ln=function(math.log), sqrt=lambda square: square**0.5, pi=math.pi)
        self.unit = unit

    def __missing__(self, name: str) -> Any:
        return self.unit(name)

    def calculate(self, expression: str) -> Any:
        """Calculate an expression, in which a unit is multiplied by the number before it."""
        amount = r"(?<![\w.])([\d.]+(?:e[-+]?\d+)?) ([A-Za-z]\w*(?:\^[\d.]+)?)"
        text = re.sub(amount, r"(\1*\2)", expression)
        text = re.sub(r"(\w\)?) (?=[A-Za-z])", r"\1*", text)
        return eval(text.replace("^", "**"), {"__builtins__": {}}, self)


@cache
def pint_names() -> tuple[Any, Names]:
    import pint

    quantity = pint.UnitRegistry().Quantity
    return quantity, Names(lambda x: quantity(x).m_as(""), lambda name: quantity(1, name))


def pint(expression: str, target: str, is_formula: bool) -> float | None:
    """Ask Pint's default registry, and its context of spectroscopy."""
    quantity, names = pint_names()
    for context in ((), ("spectroscopy",)):
        try:
            found = quantity(names.calculate(expression))
            return float(found.to(quantity(names.calculate(target)).units, *context).m)
        except Exception:  # Pint raises many kinds for what it cannot read or convert
            continue
    return None


@cache
def astropy_names() -> tuple[Any, Names]:
    from astropy import units

    units.imperial.enable()
    own = {"dBm": units.dB(units.mW), "kelvin": units.K, "kWh": units.kW * units.h}
    angles = units.dimensionless_angles()

    def plain(argument: Any) -> float:
        return float(units.Quantity(argument).to_value("", equivalencies=angles))

    return units, Names(plain, lambda name: own.get(name) or units.Unit(name))


def astropy(expression: str, target: str, is_formula: bool) -> float | None:
    """Ask astropy, with its equivalencies of light waves and (in formulas) of angles."""
    units, names = astropy_names()
    angles = units.dimensionless_angles() if is_formula else []
    for more in ([], units.spectral()):
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                found = names.calculate(expression) * units.dimensionless_unscaled
                wanted = units.Unit(names.calculate(target))
                return float(found.to_value(wanted, equivalencies=angles + more))
        except Exception:  # astropy raises many kinds, too
            continue
    return None


@cache
def program() -> str:
    return str(Path(sys.executable).with_name("radcalc"))


def radcalc(expression: str, target: str, is_formula: bool) -> float | None:
    """Ask radcalc in the same words as the others."""
    amount = [expression] if is_formula else expression.split(" ", 1)
    return first_number(output(program(), "convert", *amount, target, "-q"))


def tools() -> dict[str, Asked]:
    """Return the tools that are installed, with their versions."""
    found: dict[str, Asked] = {}
    if shutil.which("units"):
        found[f"GNU units {(output('units', '--version') or '').split()[3]}"] = gnu_units
    if shutil.which("qalc"):
        found[f"qalc {output('qalc', '--version')}"] = qalc
    for name, ask in {"Pint": pint, "astropy": astropy, "radcalc": radcalc}.items():
        try:
            found[f"{name} {importlib.metadata.version(name.lower())}"] = ask
        except importlib.metadata.PackageNotFoundError:
            continue
    return found


def answers_of(ask: Asked, column: str) -> Answers:
    """Ask a tool the questions that have an entry in a column."""
    rows = [question for question in QUESTIONS if getattr(question, column) != NOTHING]

    def answer(question: Question) -> float | None:
        return ask(getattr(question, column), question.target, column == "formula")

    if ask in (pint, astropy):  # which are not made for threads
        return [(question, answer(question)) for question in rows]
    with ThreadPoolExecutor(2) as pool:
        return [*zip(rows, pool.map(answer, rows), strict=True)]


def counted(answers: Answers, has_answer: bool) -> Counter[str]:
    """Count the verdicts on questions that have an answer, or on those that have none."""
    return Counter(row.verdict(number) for row, number in answers if row.has_answer == has_answer)


def asked(column: str, has_answer: bool) -> int:
    """Count the questions that have an entry in a column."""
    return sum(
        row.has_answer == has_answer and getattr(row, column) != NOTHING for row in QUESTIONS
    )


def print_table(answers: dict[str, tuple[Answers, Answers]]) -> None:
    """Print the counts of every tool as a table of Markdown."""
    plain, formulas = 0, 1
    words = {"right": "right", "none": "none", "wrong": "wrong"}
    groups = {
        f"as asked ({asked('ask', True)})": (plain, True, words),
        f"without an answer ({asked('ask', False)})": (
            plain,
            False,
            {"none": "refused", "wrong": "answered"},
        ),
        f"by the formula ({asked('formula', True)})": (formulas, True, words),
    }
    titles = [f"{title}: " + " | ".join(cells.values()) for title, (*_, cells) in groups.items()]
    print("| tool |", " | ".join(titles), "|")
    print("|---" * (1 + sum(len(cells) for *_, cells in groups.values())) + "|")
    for name, columns in answers.items():
        counts = [
            str(counted(columns[column], has_answer)[verdict])
            for column, has_answer, cells in groups.values()
            for verdict in cells
        ]
        print(f"| {name} |", " | ".join(counts), "|")
    answered = [row for row in QUESTIONS if row.has_answer and row.radcalc != NOTHING]
    print(
        f"\nCommands of radcalc (checked by tests/test_questions.py): {len(answered)} answers, "
        f"{sum(row.is_typed for row in answered)} of them by a formula that the user types; "
        f"{sum(row.radcalc == NOTHING for row in QUESTIONS)} questions without a command."
    )


def print_wrong(answers: dict[str, tuple[Answers, Answers]]) -> None:
    """Print every wrong answer: tool, question, what was typed, the answer, the right one."""
    for name, columns in answers.items():
        for column, rows in zip(("ask", "formula"), columns, strict=True):
            for row, number in rows:
                if row.verdict(number) == "wrong":
                    typed = f"{getattr(row, column)} to {row.target}"
                    print(name, row.id, typed, number, f"{row.value} {row.unit}", sep="\t")


def main() -> None:
    answers = {
        name: (answers_of(ask, "ask"), answers_of(ask, "formula")) for name, ask in tools().items()
    }
    if sys.argv[1:] == ["--list"]:
        print_wrong(answers)
    else:
        print_table(answers)


if __name__ == "__main__":
    main()
