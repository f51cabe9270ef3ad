"""Texts of a stream: bare numbers of one unit, or quantities with their own units, many at a time.

A plan between two units is an exact fraction, applied with one rounding.  Floats certainly give the
same result in two cases:

- The fraction is a decimal of few digits (1 lx = 0.09290304 fc), as are the numbers: their product
  is a decimal of at most 15 digits.  Its factors of 2 keep it from lying halfway between two
  numbers of the required precision, and otherwise it is further from that point than three
  roundings can move it: a plain product prints the same digits.
- The product is computed in two parts, with a bound on the error.  If both ends of the interval
  round to one float, that is the exact answer; if not, the fraction decides.
"""

import re
from collections.abc import Callable
from math import gcd
from typing import Any, Protocol

from radcalc.conversion import Plan
from radcalc.errors import NumberError, RadcalcError, UsageError, command, option, quote
from radcalc.floats import divide
from radcalc.render.plain import DIGITS, number
from radcalc.units import Unit
from radcalc.units.numbers import Amount, parse_number
from radcalc.units.reading import read_for

MOST_UNITS, LONGEST_UNIT = 1000, 100  # units in the cache
NUMBER = b"0123456789.+-"
UTF_8 = "UTF-8 (iconv converts UTF-16)"
POINT, COMMA = b".", b","  # first characters of decimals
DECIMAL_COMMA = re.compile(r"(?<![\d,])(?:\d+,\d*|,\d+)(?![\d,])")
POINTED = re.compile(r"\.\d|\d\.(?!\w)")  # a number with a point; W.m-2 has another


SHAPE = bytes.maketrans(b"123456789E", b"000000000e")  # every digit becomes 0, to find long numbers
SIGNS = b".+-"
SPLITTER = 134217729.0  # 2^27 + 1 splits the 53 bits of a float (Veltkamp)
LOST = 2.0**-75  # bound of the relative error of a product in parts
SMALL, LARGE = 1e-100, 1e100  # between these, every part of a product is in the range of a float
LONGEST = 99  # digits of a number that is certainly between them, or 0
MOST_DIGITS, MOST_PRECISION = 15, 14  # digits of decimals that three roundings keep distinct


class Bulk:
    """A plan prepared for blocks of numbers, shown with `precision` digits."""

    def __init__(self, plan: Plan, precision: int) -> None:
        self.plan = plan
        self.factor = plan.factor
        self.form = b"%%.%dg" % precision
        able = self.factor == 0 or SMALL < abs(self.factor) < LARGE
        self.singly = not plan.is_linear or any(link.check for link, _ in plan.links)
        self.able = able or not plan.is_linear
        self.digits = LONGEST  # numbers of at most so many digits take a plain product
        if not plan.links and plan.is_linear:
            over = plan.source.top * plan.target.bottom
            under = plan.source.bottom * plan.target.top
            self.digits = plain_digits(over, under, precision)
            if self.able:
                self._split(over, under)

    def _split(self, over: int, under: int) -> None:
        """Split the factor into a part of 26 bits and the rest."""
        scaled = SPLITTER * self.factor
        self.high = scaled - (scaled - self.factor)
        top, bottom = self.high.as_integer_ratio()
        self.low = divide(over * bottom - top * under, under * bottom)

    def lines(self, block: bytes) -> bytes | None:
        """Convert lines of one decimal number each; return None if any is unusual."""
        values = self.values(block)
        return None if values is None else (self.form + b"\n") * len(values) % tuple(values)

    def values(self, block: bytes) -> list[float] | None:
        """Return the results of lines of one decimal number each; None if any is unusual.

        The grammar must read unusual lines: blanks, an empty line, `1/3`, a number out of range.
        """
        shape = shape_of(block)
        if shape is None or not self.able:
            return None
        try:
            typed = floats(block, shape)
            if typed is None:
                return None
            if b"-" in block and min(typed) < 0:
                self.plan.has_negative = True
                if self.plan.links:
                    return None
            if self.singly:
                values = [self.plan.apply(value) for value in typed]
            elif b"0" * (self.digits + 1) not in shape:
                factor = self.factor
                values = [value * factor for value in typed]
            else:
                values = self.exact(typed)
        except (ValueError, RadcalcError):
            return None
        return [value + 0.0 for value in values] if b"-" in block else values  # no -0

    def exact(self, values: list[float]) -> list[float]:
        """Return the products with the exact fraction, rounded once."""
        high, low, factor, splitter, lost = self.high, self.low, self.factor, SPLITTER, LOST
        answers = []
        for value in values:
            scaled = splitter * value
            head = scaled - (scaled - value)
            product = head * high
            correction = head * low + (value - head) * factor
            bound = product * lost
            answer = product + (correction - bound)
            if answer != product + (correction + bound):
                answer = self.plan.apply(value)
            answers.append(answer)
        return answers


def shape_of(block: bytes) -> bytes | None:
    """Return lines of decimal numbers with every digit as 0, or None for other lines."""
    shape = block.translate(SHAPE, SIGNS)
    is_other = shape.translate(None, b"0e\n") or b"0" * (LONGEST + 1) in shape
    return None if is_other else shape


def floats(block: bytes, shape: bytes) -> list[float] | None:
    """Return the numbers of lines; None if one with an exponent may be out of range."""
    values = list(map(float, block.split(b"\n")[:-1]))
    if b"e" not in shape:
        return values
    sizes = list(map(abs, values))
    return values if min(sizes) > SMALL and max(sizes) < LARGE else None


def numbers(texts: list[bytes]) -> list[float] | None:
    """Return decimal numbers as the grammar reads them, or None for other texts or -0."""
    block = b"\n".join(texts) + b"\n"
    shape = shape_of(block)
    if shape is None:
        return None
    try:
        values = floats(block, shape)
    except ValueError:
        return None
    return None if values and b"-" in block and 0.0 in values else values


def plain_digits(over: int, under: int, precision: int) -> int:
    """Return the digits of numbers whose plain product with over/under is printed correctly.

    Return 0 if the fraction is not a decimal of few digits.  With T the digits of the fraction as
    a whole number, a number N of n digits gives N T of at most n + digits(T) digits.  N T lies
    halfway only if it has L digits and is 5 * 10^(L - precision - 1) times an odd number; then 2
    divides it exactly L - precision - 1 times, but it does so at least as often as T.
    """
    under //= gcd(over, under)
    tens = next((power for power in range(23) if 10**power % under == 0), None)
    if tens is None or precision > MOST_PRECISION:
        return 0
    digits = str(over * 10**tens // under).rstrip("0")
    twos = (int(digits) & -int(digits)).bit_length() - 1
    return max(0, min(MOST_DIGITS, precision + twos) - len(digits))


class Texts(Protocol):
    """The reader of the texts in the lines of a stream; `line` is the current one.

    `form` is the form of one result where all have it, and else empty.
    """

    line: int
    form: bytes

    def read(self, text: bytes) -> tuple[Any, Any]:
        """Return the value of one text; raise RadcalcError if it has none."""

    def show(self, source: Any, value: Any) -> bytes:
        """Return the output for a text."""

    def lines(self, block: bytes) -> bytes | None:
        """Convert a block of lines, each of one text; return None if any is unusual."""

    def column(self, texts: list[bytes]) -> list[bytes] | None:
        """Convert many texts; return None if any is unusual."""

    def values(self, texts: list[bytes]) -> list[float] | None:
        """Return the results of many texts, one for each `form`; None if any is unusual."""


class Numbers:
    """Texts that are bare numbers, all of one unit."""

    example = f"{option('field', 'N')} for one of several fields, or "
    example += f"{command('convert', '-', 'TARGET')} for 100 lx"

    def __init__(self, plan: Plan, precision: int | None = None, mark: bytes = POINT) -> None:
        self.line = 0
        self.plan, self.precision, self.mark = plan, precision, mark
        self.bulk = Bulk(plan, precision or DIGITS)
        self.form = self.bulk.form if mark == POINT else b""

    def read(self, text: bytes) -> tuple[Plan, float]:
        try:
            return self.plan, parse_number(pointed(decoded(text), self.mark))
        except NumberError as error:
            hint = error.hint
            if len(text.split(None, 1)) > 1 and hint != UTF_8:
                hint = self.example
            elif self.mark == POINT and b"," in text and error.hint[:1].isdigit():
                hint += f", or {option('decimal', ',')} for commas in all numbers"
            raise NumberError(error.message, hint) from None

    def show(self, plan: Plan, value: float) -> bytes:
        plan.has_negative |= value < 0
        return number(plan.apply(value), self.precision).encode().replace(POINT, self.mark)

    def lines(self, block: bytes) -> bytes | None:
        return _with_mark(self.mark, block, self.bulk)

    def column(self, texts: list[bytes]) -> list[bytes] | None:
        lines = self.lines(b"\n".join(texts) + b"\n")
        return None if lines is None else lines[:-1].split(b"\n")

    def values(self, texts: list[bytes]) -> list[float] | None:
        return self.bulk.values(b"\n".join(texts) + b"\n")


class Quantities:
    """Texts with their own units, and a plan for each unit."""

    form = b""

    def __init__(
        self,
        plans: Callable[[Unit], Plan],
        unit_of: Callable[[Amount], Unit | None],
        unit: bytes,
        precision: int | None = None,
        mark: bytes = POINT,
        target: str = "",
    ) -> None:
        """Take the planner of a unit, the reader of an amount's unit, and the output's form.

        The target decides between two readings of an expression.
        """
        self.line = 0
        self.plans, self.unit_of, self.unit, self.precision = plans, unit_of, unit, precision
        self.mark, self.target = mark, target
        self.known: dict[str, Plan | RadcalcError] = {}
        self.bulks: dict[bytes, Bulk | None] = {}

    def read(self, text: bytes) -> tuple[Plan, float]:
        amount = read_for(pointed(decoded(text), self.mark), self.target)
        if amount.unit is None:
            hint = f"{command('convert', '-', 'UNIT', 'TARGET')} for bare numbers"
            raise UsageError(f"the unit of '{quote(text.decode())}' is missing", hint)
        if amount.is_uncertain:
            problem = f"'{quote(amount.text)}' has an uncertainty, which a stream does not carry"
            hint = f"the value alone, or a separate call: {command('convert', quote(amount.text))}"
            raise NumberError(problem, hint)
        return self._plan(self.unit_of(amount) or amount.unit), amount.typed[0]

    def _plan(self, unit: Unit) -> Plan:
        plan = self.known.get(unit.text)
        if plan is None:
            if len(self.known) >= MOST_UNITS:
                self.known.clear()
            try:
                plan = self.plans(unit)
            except RadcalcError as error:
                plan = error
            self.known[unit.text] = plan
        if isinstance(plan, RadcalcError):
            raise plan.with_traceback(None)  # it would grow with every line
        return plan

    def show(self, plan: Plan, value: float) -> bytes:
        plan.has_negative |= value < 0
        text = number(plan.apply(value), self.precision).encode()
        return text.replace(POINT, self.mark) + self.unit

    def lines(self, block: bytes) -> bytes | None:
        converted = self.column(block.split(b"\n")[:-1])
        return None if converted is None else b"\n".join(converted) + b"\n"

    def column(self, texts: list[bytes]) -> list[bytes] | None:
        converted = texts[:]
        for unit, having in by_unit(texts, self.mark).items():
            bulk = self._bulk(unit, texts[having[0]])
            if bulk is None:
                return None
            size = len(unit)
            block = b"\n".join([texts[place][:-size] for place in having]) + b"\n"
            numbers = _with_mark(self.mark, block, bulk)
            if numbers is None:
                return None
            for place, value in zip(having, numbers.split(b"\n"), strict=False):
                converted[place] = value + self.unit
        return converted

    def values(self, texts: list[bytes]) -> None:
        """Return None: the results have units."""

    def _bulk(self, unit: bytes, text: bytes) -> Bulk | None:
        """Return the converter of numbers followed by this text of a unit.

        The grammar must agree that the unit begins here, without blanks after it.
        """
        if len(unit) > LONGEST_UNIT:
            return None
        if unit not in self.bulks:
            if len(self.bulks) >= MOST_UNITS:
                self.bulks.clear()
            bulk = None
            if unit and unit == unit.rstrip():
                try:
                    plan, _ = self.read(text)
                    agreed = plan.source.text == unit.decode().strip()
                    bulk = Bulk(plan, self.precision or DIGITS) if agreed else None
                except RadcalcError:
                    pass
            self.bulks[unit] = bulk
        return self.bulks[unit]


def _with_mark(mark: bytes, block: bytes, bulk: Bulk) -> bytes | None:
    """Convert lines of one decimal number each, with that decimal mark."""
    if mark == POINT:
        return bulk.lines(block)
    if POINT in block:
        return None
    lines = bulk.lines(block.replace(mark, POINT))
    return lines and lines.replace(POINT, mark)


def by_unit(texts: list[bytes], mark: bytes = POINT) -> dict[bytes, list[int]]:
    """Group the places of texts by the unit after their numbers, with that decimal mark."""
    start = NUMBER.replace(POINT, mark)
    places: dict[bytes, list[int]] = {}
    for place, text in enumerate(texts):
        unit = text.lstrip(start)
        if unit in places:
            places[unit].append(place)
        else:
            places[unit] = [place]
    return places


def pointed(text: str, mark: bytes) -> str:
    """Return a text with decimal points instead of its decimal marks."""
    if mark == POINT:
        return text
    if POINTED.search(text):
        problem = f"'{quote(text)}' has a point in its number, but the decimal mark is a comma"
        raise NumberError(problem, "a comma before the decimals, and nothing between thousands")
    if "," in DECIMAL_COMMA.sub("", text):
        raise NumberError(f"'{quote(text)}' is not a number with a decimal comma", "1,5")
    return text.replace(mark.decode(), ".")


def decoded(text: bytes) -> str:
    """Decode the text of a number or a unit from UTF-8; refuse unusual blanks around it."""
    try:
        decoded = text.decode()
        if decoded != decoded.strip():  # a form feed or no-break space is not dropped
            raise NumberError(f"'{quote(decoded)}' is not a number", "blanks or tabs around it")
        return decoded
    except UnicodeDecodeError:
        escaped = quote(text.decode(errors="backslashreplace"))
        raise NumberError(f"'{escaped}' is not text in UTF-8", UTF_8) from None
