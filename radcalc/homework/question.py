"""Questions of an answer to check, the problems that they pose, and answers as learners type them.

An answer has a tolerance.
"""

import math
from collections.abc import Callable, Mapping, Sequence
from decimal import ROUND_HALF_DOWN, ROUND_HALF_UP, Context, Decimal
from types import MappingProxyType
from typing import Any, NamedTuple, cast

from radcalc.answer import Answer, Step, Value
from radcalc.calculators import page_of
from radcalc.calculators.solved import Task
from radcalc.calculators.uncertainty import value_of, with_uncertainties
from radcalc.conversion import Plan, between
from radcalc.conversion.plan import plan
from radcalc.errors import MINUS, ConditionError, NumberError, RadcalcError, add, option, quote
from radcalc.floats import as_printed, divide
from radcalc.homework.chain import FAILURES, Worked, of_answer, of_laws
from radcalc.homework.wording import USUAL, Translatable
from radcalc.inputs import Input, Inputs, any_uncertain
from radcalc.inputs.quantities import MARKED
from radcalc.inputs.reading import read_as
from radcalc.laws.optics import EXITANCE, PEAK
from radcalc.laws.surface import LAMBERTIAN
from radcalc.quantities import Reading, place_of
from radcalc.quantities.symbols import ANY, SYMBOLS, Symbol
from radcalc.spectra.spectrum import BlackBody
from radcalc.units import NUMBER, Daily, Unit
from radcalc.units.amounts import UNCERTAIN
from radcalc.units.dimensions import ENERGY, FREQUENCY, PHOTON_ENERGY, WAVENUMBER
from radcalc.units.numbers import DIGITS, Amount, read_number, typed_digits
from radcalc.units.scale_table import Scale
from radcalc.units.table import resolve, unit_of
from radcalc.units.values import find_scale, refuse_product

HOT_BODY = {  # the laws of the results of a black body's spectrum
    "exitance": [EXITANCE],
    "radiance": [EXITANCE, LAMBERTIAN],
    "peak-wavelength": [PEAK],
}
PI_FORGOTTEN = "pi was forgotten"
BOTH, AND = "{0}; {1}", "{0}; and {1}"
RARER = 3.5  # what two mistakes in laws add to their ranks


class Question(NamedTuple):
    """The right answer, the inputs, and a function that gives the answer for other inputs.

    `shape` is the shape of the source or of the solid angle.  A conversion has a plan and a number
    to convert.  If inputs are uncertain, `uncertain` is the right answer with its uncertainties.
    The `samples` of a log are the first, the last and the sum of all [SI].  An `expression` is the
    function of direction that is integrated.
    """

    answer: Answer
    given: Inputs
    work_out: Callable[[Inputs], Answer]
    command: str
    shape: str = ""
    steps: tuple[Step, ...] = ()
    plan: Plan | None = None
    number: float = 0.0
    uncertain: Answer | None = None
    samples: Mapping[str, float] = MappingProxyType({})
    expression: str = ""


def of_task(task: Task, given: Inputs, steps: bool = False) -> Question:
    """Return the question that a calculator answers from inputs."""
    answer = task.nominal(given)
    texts = {operand.name: operand.text for operand in task.operands}
    question = Question(
        answer,
        given,
        task.nominal,
        task.command,
        task.shape,
        samples=task.samples,
        expression=texts.get("expression", ""),
    )
    return _with_uncertainties(question, given, steps)


def _with_uncertainties(question: Question, given: Inputs, steps: bool) -> Question:
    answer = question.answer
    if any_uncertain(given.values()):
        uncertain = with_uncertainties(question.work_out, given)
        # mistakes are searched in the derivation of the nominal values
        answer = uncertain._replace(values=answer.values, more=answer.more, steps=answer.steps)
        question = question._replace(answer=answer, uncertain=uncertain)
    explained = question.uncertain or answer
    return question._replace(steps=tuple(explained.steps)) if steps else question


def of_conversion(
    number: float,
    source: Unit,
    target: Unit,
    given: Sequence[Input],
    steps: bool = False,
    amount: Amount | None = None,
) -> Question:
    """Return the question of a conversion; `amount` is its value with any uncertainty."""

    def work_out(inputs: Inputs) -> Answer:
        """Return the answer for other inputs: a wrong answer is one of a changed input."""
        value = inputs[""].value if "" in inputs else number
        conversion = plan(source, target, [condition for name, condition in inputs.items() if name])
        unit = conversion.target  # a scale is resolved to one of its readings
        name, symbol, also = conversion.result
        result = Value(
            "value",
            name or "value",
            symbol,
            conversion.quantity(value) * unit.factor,
            (unit.dimension,),
            (unit.text,),
            also=also,
        )
        return Answer(
            [result],
            conversion.assumptions,
            conversion.notes,
            conversion.derive(value) if steps else (),
        )

    conditions = {condition.name: condition for condition in given}
    answer = work_out(conditions)
    conversion = plan(source, target, given)
    question = Question(answer, conditions, work_out, "convert", plan=conversion, number=number)
    inputs = {**conditions, "": value_of(amount)} if amount else conditions
    return _with_uncertainties(question, inputs, steps)


DAY = resolve("day").factor  # s
A_DAY = resolve("mol/m2/d").dimension, True
PROPORTIONAL = {FREQUENCY, WAVENUMBER, ENERGY, PHOTON_ENERGY}


def in_its_unit(question: Question, text: str) -> Question:
    """Return a question whose answer is also in a unit of the same light, if `text` is one.

    These are a rate per day for a daily light integral, and the axes that are proportional to the
    frequency: for a spectral density, and for the width of a band.
    """
    unit = unit_of(text) if text and question.plan else None
    if question.plan is None or unit is None or question.plan.target.is_scale:
        return question
    target = question.plan.target
    try:
        if isinstance(target, Daily) and (unit.dimension, ("day", -1) in unit.atoms) == A_DAY:
            factor = 1 / DAY
        elif "wavelength" in question.given and {target.dimension, unit.dimension} <= PROPORTIONAL:
            factor = plan(target, unit).quantity(1.0) * unit.factor / target.factor
        else:
            factor = between(target, unit).quantity(1.0) * unit.factor / target.factor
    except RadcalcError:
        return question
    answers = [
        answer and answer._replace(values=[_reaching(v, unit, factor) for v in answer.values])
        for answer in (question.answer, question.uncertain)
    ]
    return question._replace(answer=cast("Answer", answers[0]), uncertain=answers[1])


def _reaching(value: Value, unit: Unit, factor: float) -> Value:
    if unit.dimension in value.dimensions:
        return value
    return value._replace(reach={**value.reach, unit.dimension: value.amount * factor})


class Candidate(NamedTuple):
    """A wrong value [SI] and the mistake that leads to it; rank 1 is the likeliest.

    `done` describes the mistake, `right` is the right rule.
    """

    mistake: str
    rank: float
    value: float
    done: str
    right: str


def usual(
    name: str, value: float | None, done: str = "", right: str = "", later: float = 0.0
) -> Candidate | None:
    """Return a mistake of the table `USUAL`, or None without a value.

    `done` and `right` replace the words of the table; `later` is added to the rank.
    """
    if value is None or not math.isfinite(value):
        return None
    rank, usual_done, rule = USUAL[name]
    return Candidate(name, rank + later, value, done or usual_done, rule or right)


def both(first: Candidate, second: Candidate, value: float | None = None) -> Candidate:
    """Return two mistakes together, which are rarer than one."""
    return Candidate(
        f"{first.mistake} and {second.mistake}",
        first.rank + second.rank + RARER,
        second.value if value is None else value,
        Translatable(AND, first.done, second.done),
        Translatable(BOTH, first.right, second.right),
    )


class Problem:
    """One result of a question: its inputs, the other results, and the right value [SI].

    `light` is its light quantity, if it is one; `chain` is its derivation.
    """

    def __init__(self, question: Question, target: Value) -> None:
        self.question, self.given, self.target = question, question.given, target
        self.results = {v.name: v for v in question.answer.values if not v.is_absent}
        self.right = float(target.amount)
        self._changed: dict[Any, tuple[Question, Value] | None] = {}
        facts = place_of(target.dimensions[0])
        self.light = Reading(*facts) if facts else None
        if question.plan:
            from radcalc.homework.chain import of_conversion

            self.chain = of_conversion(question.plan, question.number, self.right, self.given)
        elif (body := self.hot_body()) and target.name in HOT_BODY:
            values = {"temperature": body.temperature, "emissivity": 1.0}
            self.chain = of_laws(HOT_BODY[target.name], target.name, values, self.right)
        else:
            self.chain = of_answer(question.answer, target, self.given)

    def hot_body(self) -> BlackBody | None:
        body = self.given["spectrum"].value if "spectrum" in self.given else None
        return body if isinstance(body, BlackBody) else None

    def lists(self, mistake: str) -> bool:
        return mistake in page_of(self.question.command).mistakes

    def asks(self, *names: str) -> bool:
        """Return whether the result is one of these; a generic name includes all kinds of light."""
        symbol = SYMBOLS.get(self.target.name)
        return self.target.name in names or (symbol is not None and symbol.generic in names)

    def amount(self, name: str) -> float | None:
        if name in self.given:
            value = self.given[name].value
            return float(value) if isinstance(value, (int, float)) else None
        if name in self.chain.values:
            return self.chain.values[name]
        try:
            return float(self.results[name].amount)
        except FAILURES:
            return None

    def radius(self) -> float | None:
        diameter = self.amount("diameter")
        return diameter / 2 if diameter else self.amount("radius")

    def anew(self, changed: dict[str, Any]) -> float | None:
        """Return the result [SI] with some inputs changed, or None if these are refused."""
        key = tuple(changed.items())
        if key not in self._changed:
            given = dict(self.given)
            for name, value in changed.items():
                given[name] = given[name]._replace(value=value, is_exact=True)
            self._changed[key] = self._with(given)
        found = self._changed[key]
        numbers = {name: value for name, value in changed.items() if isinstance(value, float)}
        return Worked(float(found[1].amount), self.chain, numbers) if found else None

    def _with(self, given: Inputs) -> tuple[Question, Value] | None:
        try:
            answer = self.question.work_out(given)
            for result in answer.values:
                if result.name == self.target.name and result.dimensions == self.target.dimensions:
                    return self.question._replace(answer=answer, given=given), result
        except FAILURES:
            pass  # a wrong input may be out of range
        return None

    def changed(self, changed: dict[str, Any]) -> "Problem | None":
        """Return the problem with some inputs changed, or None if these are refused."""
        if self.anew(changed) is None:
            return None
        question, target = cast("tuple[Question, Value]", self._changed[tuple(changed.items())])
        if question.plan is None:
            return Problem(question, target)
        ends = question.plan.source, question.plan.target
        try:
            replanned = plan(*ends, [*question.given.values()])
        except FAILURES:
            return None
        return Problem(question._replace(plan=replanned), target)

    def misread(self, name: str, value: float) -> float | None:
        """Return the result [SI] with one input changed; from the laws alone if it is refused."""
        result = self.anew({name: value})
        if result is None and name in self.chain.symbols:
            return self.chain.after(name, value)
        return result


DIGITS_OF_EXACT = 15
LEAST_MEANT = 2  # digits of a number that count in any case, even if they are zeros
PRINTED = 12  # digits of a right value, which has rounding errors in later ones


class Claim(NamedTuple):
    """The parts of an answer NAME=VALUE UNIT, and its rounding.

    Zeros at the end of an integer are significant, and `half_unit` is half a unit of the last
    digit.  In the search for mistakes they may be not significant, except among the first two
    digits: `widest` is then half a unit.  `uncertainty` is the standard uncertainty, in the unit.
    """

    text: str
    name: str
    value: float
    unit: str
    number: str
    digits: int
    half_unit: float
    widest: float = 0.0
    uncertainty: float = 0.0


def read_claim(text: str) -> Claim:
    """Read `[NAME=]VALUE[UNIT]`."""
    name, equals, value_text = text.partition("=")
    if not equals:
        name, value_text = "", text
    elif not name.strip():
        raise ConditionError(
            f"{option('check', quote(text))}: the name before = is missing",
            option("check", "illuminance=25lx"),
        )
    value_text = value_text.strip().replace(MINUS, "-")
    value_text, off = value_text.removeprefix(MARKED.get(name.strip(), "")), 0.0
    try:
        if any(mark in value_text for mark in UNCERTAIN):
            from radcalc.units.uncertain import read_uncertain

            if reading := read_uncertain(value_text):
                off, value_text = reading.uncertainty, reading.nominal
        if evaluated := _arithmetic(value_text):
            return Claim(text, name.strip(), *evaluated)
        value, end = read_number(value_text)
    except NumberError as error:
        raise NumberError(
            f"{option('check')}: {error.message}", f"{option('check', '25lx')}; {error.hint}"
        ) from None
    number, unit = value_text[:end], value_text[end:].strip()
    digits, half, widest = _digits(number, value)
    return Claim(text, name.strip(), value, unit, number, digits, half, widest, off)


def decimal(number: float, digits: int = DIGITS_OF_EXACT) -> Decimal:
    """Return a float as the decimal number that is printed with these digits."""
    return Decimal(f"{number:.{digits}g}")


def is_rounded(claim: Claim, right: float) -> bool:
    """Return whether an answer is the right value rounded to the digits typed.

    A value half way between two numbers may be rounded to either.
    """
    if not claim.value or not right:
        return False
    digits, claimed = min(claim.digits, DIGITS_OF_EXACT), decimal(claim.value)
    return any(
        Context(digits, rounding).create_decimal(decimal(right, PRINTED)) == claimed
        for rounding in (ROUND_HALF_UP, ROUND_HALF_DOWN)
    )


def _arithmetic(text: str) -> tuple[float, str, str, int, float, float] | None:
    """Evaluate an expression such as 2 * 12.5 lx; None if the text is a plain number.

    The result is value, unit, number, digits, half unit and widest, as in `Claim`.
    """
    try:
        _, end = read_number(text)
        unit_text = text[end:].strip()
        if unit_of(unit_text or "1"):
            return None
        if find_scale(unit_text):
            refuse_product(text, unit_text)
            return None
    except NumberError:
        pass
    from radcalc.units.expressions import read_expression

    result = read_expression(text)
    if result is None:
        return None
    value, unit, off, _ = result
    half = abs(value) * off
    digits = min(DIGITS_OF_EXACT, max(1, -math.floor(math.log10(2 * off))))
    return value, unit.text if unit else "", f"{value:.12g}", digits, half, half


def _digits(number: str, value: float) -> tuple[int, float, float]:
    """Count the digits of a number; half a unit of the last digit, and of the last nonzero one."""
    typed = typed_digits(number)
    if typed is None:  # pi/6, 2*pi
        return DIGITS_OF_EXACT, abs(value) * 1e-9, abs(value) * 1e-9
    digits, power = typed[0].lstrip("0"), min(typed[1], 308)
    zeros = 0 if "." in number else len(digits) - len(digits.rstrip("0"))
    zeros = max(0, min(zeros, len(digits) - LEAST_MEANT))
    return max(1, len(digits)), 0.5 * 10.0**power, 0.5 * 10.0 ** min(power + zeros, 308)


class Diagnosis(NamedTuple):
    """A likely mistake: its name, a description, the right rule, and the first wrong step.

    `yours` is that step in the learner's own numbers, or ''.
    """

    mistake: str
    done: str
    right: str
    yours: str = ""


class Tolerance(NamedTuple):
    """A tolerance: relative, absolute in the unit of the answer, or in significant digits.

    One of a reading is absolute on the scale of the answer; a standard uncertainty is that of the
    right value, and both count as they are printed.
    """

    text: str
    kind: str
    size: float

    def holds(self, value: float, right: float) -> bool:
        """Return whether a value is near the right one, as computed or as printed."""
        if not math.isfinite(value):
            return False
        claimed = decimal(value)
        if self.kind == "uncertainty":
            printed, off = as_printed(right, self.size)
            return abs(claimed - decimal(printed)) <= decimal(off)
        texts = {Decimal(repr(right)), decimal(right), decimal(right, PRINTED)}
        return any(abs(claimed - text) <= self._width(text) for text in texts)

    def width(self, right: float) -> float:
        """Return the largest allowed difference from the right value."""
        return float(self._width(Decimal(right)))

    def _width(self, right: Decimal) -> Decimal:
        size = decimal(self.size)
        if self.kind == "relative":
            return size * abs(right)
        if self.kind in ("absolute", "reading", "uncertainty"):
            return size
        return Decimal(5).scaleb((right.adjusted() if right else 0) - int(self.size))


def read_tolerance(text: str, unit: Unit, scale: Scale | None = None) -> Tolerance:
    """Read a tolerance: 1%, 0.01, 0.5lx or 3sf, for a number in a unit or a reading on a scale."""
    text = text.strip().lower() if text.strip().lower().endswith("sf") else text.strip()
    typed = option("tolerance", quote(text))
    hint = add("tolerance", "1%", "or a size such as 0.5lx, or 3sf for three significant digits")
    if text.endswith("sf"):
        if not (text[:-2].isascii() and text[:-2].isdecimal()) or not 1 <= int(text[:-2]) <= 15:
            raise ConditionError(f"{typed} is out of range", hint)
        count = int(text[:-2])
        digits = Translatable("within half a unit of digit {0}", count)
        return Tolerance(digits, "digits", count)
    if step := find_scale(text.lstrip(f"{DIGITS}. ")):  # 0.5 dB, for an answer in dBm
        if not scale or (scale.base, scale.steps) != (step.scale.base, step.scale.steps):
            raise ConditionError(f"{typed} is not a step of the answer", add("tolerance", "1%"))
        return Tolerance(Translatable("within {0}", text), "reading", read_number(text)[0])
    takes = "a part or a quantity"
    symbol = Symbol("tolerance", "", (NUMBER, unit.dimension), "1%", limits=ANY, takes=takes)
    try:
        given = read_as(symbol, text)
    except RadcalcError as error:
        name = option("tolerance")
        raise ConditionError(f"{name}: {error.message.removeprefix(f'{name}: ')}", hint) from None
    if given.value < 0:
        raise ConditionError(f"{typed} is out of range", hint)
    if given.unit is None and given.value >= 1:
        raise ConditionError(f"the unit of {typed} is missing", hint)
    is_part = given.dimension == NUMBER and unit.dimension != NUMBER
    if is_part or given.unit is None or given.unit.text in ("%", "1"):
        return Tolerance(Translatable("within {0}", given.text), "relative", given.value)
    size = given.value * divide(unit.bottom, unit.top)
    return Tolerance(Translatable("within {0}", given.text), "absolute", size)
