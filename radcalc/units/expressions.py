"""Arithmetic with units: `500 lx * 20 m2 / (0.6*0.8)`, `1 m + 2 ft`, `10^3 lx`.

The text is read in one pass, bounded in length, depth and size.  Numbers are ratios of whole
numbers, rounded once in the answer; pi is the ratio in the table of units.

    SUM     = [sign] PRODUCT { ("+" | "-") PRODUCT }
    PRODUCT = TERM { ("*" | "/") TERM }
    TERM    = (NUMBER | "(" SUM ")" | FUNCTION "(" SUM ")") [EXPONENT] { UNIT } | UNIT { UNIT }

Units belong to the number before them: `800 lm / 2 m2` is 400 lm/m2.  Ambiguous expressions
(`1/2 m` in a product, `100 W / 5 W/m2`) are refused with both readings.
"""

import math

from radcalc.errors import (
    ExpressionError,
    Hint,
    NumberError,
    UnitError,
    call,
    correct,
    corrections,
    measured,
    quote,
)
from radcalc.units.compiled import NAMES
from radcalc.units.dimensions import ANGLE
from radcalc.units.grammar import MAX_DEPTH, NAMED, SUPERSCRIPTS, Scanner, parse_unit, plain
from radcalc.units.numbers import (
    CALLS,
    DIGITS,
    EXACT,
    FUNCTIONS,
    MAX_LENGTH,
    MINUSES,
    OTHER_FUNCTIONS,
    SIGNS,
    SMALLEST,
    read_term,
    refuse_lookalikes,
    relative_rounding,
    typed_digits,
)
from radcalc.units.table import PARTS, resolve
from radcalc.units.unit import BASES, NUMBER, PI, Dimension, Unit, divide, lookup

TYPE_CHECKING = False  # typing is slow to import
if TYPE_CHECKING:
    from radcalc.errors import Try
    from radcalc.units.scales import ScaleUnit

MAX_POWER = 1000  # of a number
MAX_BITS = 40_000  # of a number's numerator or denominator: about 12 000 digits
COHERENT = ("m", "kg", "s", "K", "rad", "cycle", "photon", "cd", "td", "A")  # as BASES
KEPT = 1e-12  # largest relative error of a sum by cancellation of digits
OF_ANGLES = ("sin", "cos", "tan")
NO_ANGLE, NOT_A_NUMBER = "has no angle in {}", "has {} in {}"  # also of functions of direction
HINT = "arithmetic such as '2 * 100 lx' or '500 lx * 20 m2 / 0.8'"


class Value:
    """A number top / bottom in coherent SI units, with the typed units and their powers.

    `rounding` is the relative rounding error of the typed digits, `blur` that of functions.
    `had_units` is true also if all units cancelled: such a number takes no unit.
    """

    __slots__ = ("blur", "bottom", "dimension", "had_units", "rounding", "top", "units")

    def __init__(
        self,
        top: int,
        bottom: int = 1,
        dimension: Dimension = NUMBER,
        units: "dict[str, int] | None" = None,
        rounding: float = 0.0,
        had_units: bool = False,
        blur: float = 0.0,
    ) -> None:
        common = math.gcd(top, bottom) or 1
        self.top = top // common
        self.bottom = bottom // common
        self.dimension = dimension
        self.units = units or {}
        self.had_units = had_units or bool(units)
        self.rounding = rounding
        self.blur = blur
        if max(abs(self.top), self.bottom).bit_length() > MAX_BITS:
            raise ExpressionError("a number in the expression has too many digits", "fewer")

    def times(self, other: "Value", power: int = 1) -> "Value":
        top, bottom = (other.top, other.bottom) if power > 0 else (other.bottom, other.top)
        if max(abs(top), bottom).bit_length() * abs(power) > MAX_BITS:
            raise ExpressionError("a number in the expression has too many digits", "fewer")
        if bottom == 0:
            raise ExpressionError("the expression divides by zero", "a number other than 0")
        if bottom < 0:
            top, bottom = -top, -bottom
        size = abs(power)
        units = dict(self.units)
        for name, exponent in other.units.items():
            units[name] = units.get(name, 0) + power * exponent
        return Value(
            self.top * top**size,
            self.bottom * bottom**size,
            tuple([a + power * b for a, b in zip(self.dimension, other.dimension, strict=True)]),
            {name: exponent for name, exponent in units.items() if exponent},
            self.rounding + size * other.rounding,
            self.had_units or other.had_units,
            self.blur + size * other.blur,
        )

    def plus(self, other: "Value", sign: int) -> "Value":
        """Return the sum, or the difference, in this value's unit."""
        a, b = self.top * other.bottom, sign * other.top * self.bottom
        rounding = blur = 0.0
        if a + b:
            for part, value in ((a, self), (b, other)):
                rounding += abs(divide(part, a + b)) * value.rounding if value.rounding else 0.0
                blur += abs(divide(part, a + b)) * value.blur if value.blur else 0.0
        if blur >= 1:  # sqrt(2)^2 - 2: 0 to all digits that are computed
            a, b, rounding, blur = 0, 0, 0.0, 0.0
        if blur > KEPT:
            problem = "a difference in the expression cancels too many digits of its terms"
            raise ExpressionError(problem, "terms that are less alike")
        had_units = self.had_units or other.had_units
        bottom = self.bottom * other.bottom
        return Value(a + b, bottom, self.dimension, self.units, rounding, had_units, blur)

    def is_bare(self) -> bool:
        return not self.units

    def unit(self) -> Unit | None:
        """Return the unit for display, None for a bare number."""
        if self.dimension == NUMBER:
            (name, power), *more_units = self.units.items() or [("", 0)]
            if power == 1 and not more_units and _is_part(name):
                return resolve(name)
            return resolve("1") if self.had_units else None
        units = {name: power for name, power in self.units.items() if not _is_part(name)}
        text = _unit_text(units)
        try:
            return resolve(text)
        except UnitError as error:
            if "multiplies light" not in error.message:  # the typed * makes it unambiguous
                raise
            return resolve(f"({text})")


def _is_part(name: str) -> bool:
    entry = lookup(name)
    return entry is not None and entry[1] in PARTS


def _as_factor(terms: str) -> str:
    """Return terms as a factor: in brackets if there are signs in them."""
    return f"({terms})" if any(sign in terms for sign in SIGNS) else terms


def _unit_text(units: dict[str, int]) -> str:
    def factor(name: str, power: int) -> str:
        if power == 1:
            return name
        name = f"({name})" if name.endswith("-1") else name
        return f"{name}^{power}" if name[-1] in DIGITS else f"{name}{power}"

    over = [factor(name, power) for name, power in units.items() if power > 0]
    if not over:
        return ".".join([factor(name, power) for name, power in units.items()])
    under = [factor(name, -power) for name, power in units.items() if power < 0]
    return "/".join([".".join(over), *under])


class Term:
    """A term of a product: its value, its place in the text and its form."""

    __slots__ = ("end", "has_number", "middle", "start", "units", "value")

    def __init__(
        self, value: Value, start: int, middle: int, end: int, has_number: bool, units: int
    ) -> None:
        """The number of the text from `start` to `end` ends at `middle`."""
        self.value = value
        self.start, self.middle, self.end = start, middle, end
        self.has_number = has_number
        self.units = units  # count of units after the number


Leaves = dict[int, tuple[int, Value]]


class Calculator(Scanner):
    """One pass over the text of an expression.

    `leaves` are parts of the text that are already read: start, end and value.
    """

    divides = True

    def __init__(self, text: str, leaves: Leaves | None = None) -> None:
        super().__init__(text)
        self.leaves = leaves or {}
        self.depth = 0
        self.is_arithmetic = False  # False also for a number with an unreadable unit

    def error(self, problem: str, hint: Hint = "") -> ExpressionError:
        return self.wrong(problem, hint or HINT)

    def wrong(self, problem: str, hint: Hint = HINT) -> ExpressionError:
        return ExpressionError(f"'{quote(self.text)}' {problem}", hint)

    def two_ways(self, start: int, first: str, second: str) -> ExpressionError:
        """Return the error for a part, from `start` to here, that has two readings."""
        ways = [self.with_part(start, reading) for reading in (first, second)]
        return self.wrong("is ambiguous", corrections(self.text, *ways))

    def with_part(self, start: int, part: str) -> str:
        """Return the whole text with another part in place of that from `start` to here."""
        end = start + len(self.text[start : self.at].rstrip())
        return self.text[:start] + " ".join(part.split()) + self.text[end:]

    def slice(self, start: int, end: int) -> str:
        return self.text[start:end].strip()

    def answer(self) -> Value:
        value = self.sum()
        if self.peek() == ")":
            raise self.wrong("has a closing bracket too many", "as many ( as )")
        if self.peek():
            raise self.unreadable()
        return value

    def unreadable(self) -> ExpressionError:
        rest = self.text[self.at :]
        if rest[:1] in tuple(DIGITS) or rest[:1] in ("(", ".") or self.is_function():
            return self.wrong(
                f"runs two values together at '{quote(rest)}'", "a * or a + between them"
            )
        if rest.startswith("±"):
            self.is_arithmetic = True
            return self.wrong("has an uncertainty", "a value of its own for it: 100±3 lx")
        return self.wrong(f"cannot be read from '{quote(rest)}' on")

    def sum(self) -> Value:
        self.skip_blanks()
        begin = self.at
        is_negative = self.peek() in MINUSES and bool(self.peek())
        if self.peek() and self.peek() in SIGNS:
            self.at += 1
            self.skip_blanks()
        start = self.at
        value, has_number = self.product(is_negative)
        if is_negative:
            value = value.times(Value(-1))
        while self.peek() and self.peek() in SIGNS:
            sign = -1 if self.peek() in MINUSES else 1
            self.at += 1
            self.is_arithmetic = True
            self.skip_blanks()
            if self.peek() and self.peek() in SIGNS:
                signs = quote(self.text[self.at - 1 :])
                hint = "brackets, or for an uncertainty a value of its own: 100±3 lx"
                raise self.wrong(f"has two signs in a row at '{signs}'", hint)
            before = start
            start = self.at
            term, is_numbered = self.product()
            if not has_number or not is_numbered:
                place = start if has_number else before
                bare = self.slice(start, self.at) if has_number else self.slice(before, start - 1)
                better = f"{self.text[:place]}1 {self.text[place:]}"
                raise self.wrong(f"has no number at '{quote(bare)}'", correct(self.text, better))
            self.refuse_unlike(value, term, sign, begin, start)
            value = value.plus(term, sign)
        return value

    def refuse_unlike(self, value: Value, other: Value, sign: int, begin: int, start: int) -> None:
        """Raise for a term at `start` that is unlike the sum from `begin`."""
        units = value.unit(), other.unit()
        (a, b) = [
            (unit.dimension, unit.is_exitance, unit.has_wavelength) if unit else None
            for unit in units
        ]
        if value.dimension == other.dimension == NUMBER:
            self.refuse_share(value, other, sign, begin, start)
            return
        if a == b:
            return
        terms_before, term = self.slice(begin, start)[:-1].rstrip(), self.slice(start, self.at)
        hint: Hint = "terms of one quantity"
        plus = "+" if sign > 0 else "-"
        if other.dimension == NUMBER and other.units:  # 100 lx + 10%
            better = f"{_as_factor(terms_before)} * (1 {plus} {term})"
            hint = correct(self.text, self.with_part(begin, better))
        elif units[0] and not units[1]:  # 100 lx + 3
            hint = correct(self.text, self.with_part(start, f"{term} {units[0].text}"))
        elif units[1] and not units[0] and term.endswith(units[1].text):  # 500 + 200 lx
            number = term.removesuffix(units[1].text).strip()
            better = f"({terms_before} {plus} {number}) {units[1].text}"
            hint = correct(self.text, self.with_part(begin, better))
        named = [measured(unit.text) if unit else "a bare number" for unit in units]
        link = " and " if sign > 0 else " from "
        if sign < 0:
            named.reverse()
        raise ExpressionError(
            f"cannot {'add' if sign > 0 else 'subtract'} {link.join(named)}", hint
        )

    def refuse_share(self, value: Value, other: Value, sign: int, begin: int, start: int) -> None:
        """Raise for 100 + 10%, which is 110 on a pocket calculator and 100.1 in algebra."""
        if value.is_bare() and value.top != value.bottom and any(map(_is_part, other.units)):
            plus = "+" if sign > 0 else "-"
            terms_before, term = self.slice(begin, start)[:-1].rstrip(), self.slice(start, self.at)
            number = f"{divide(other.top, other.bottom):.12g}"
            raise self.two_ways(
                begin,
                f"{_as_factor(terms_before)} * (1 {plus} {term})",
                f"{terms_before} {plus} {number}",
            )

    def product(self, is_negative: bool = False) -> tuple[Value, bool]:
        """Return the product of terms, and whether it contains a number."""
        first = self.term(is_negative)
        value, has_number = first.value, first.has_number
        solidus: Term | None = None  # the last divisor
        while True:
            self.skip_blanks()
            sign_at = self.at
            operator = self.times_ten() or (self.operator(self.peek()) if self.peek() else "")
            if not operator:
                return value, has_number
            if self.text[sign_at : sign_at + 1] == "." and self.peek() in tuple(DIGITS):
                raise self.wrong("has a point that may be a product", "a * for a product")
            self.skip_blanks()
            if not self.peek() or self.peek() == ")":
                raise self.wrong(f"ends with '{quote(self.slice(sign_at, self.at))}'")
            is_negative = self.peek() in tuple(MINUSES)
            self.at += is_negative
            self.is_arithmetic |= is_negative or self.begins_number()
            term = self.term(is_negative)
            if is_negative:
                term.value = term.value.times(Value(-1))
            if operator == "/":
                self.refuse_two_ways(first.start, value, sign_at, term)
            if solidus and not term.has_number and (operator == "*" or solidus.has_number):
                over = self.slice(first.start, solidus.start).rstrip("/ ").removesuffix("per")
                under = self.slice(solidus.start, term.end)
                quotient = self.slice(first.start, solidus.end)
                factors_after = self.slice(sign_at, term.end)
                ways = f"{over} / ({under})", f"({quotient}) {factors_after}"
                raise self.two_ways(first.start, *ways)
            if operator == "/" and (term.units or not term.has_number):
                solidus = term
            elif term.has_number:
                solidus = None
            has_number |= term.has_number
            value = value.times(term.value, 1 if operator == "*" else -1)

    def times_ten(self) -> str:
        """Read the x of 5x10^3."""
        if self.peek() not in ("x", "X"):
            return ""
        start, self.at = self.at, self.at + 1
        self.skip_blanks()
        next_char = self.text[self.at + 2 : self.at + 3]
        if self.text.startswith("10", self.at) and (
            next_char in ("^", "*") or next_char in SUPERSCRIPTS
        ):
            return "*"
        self.at = start
        return ""

    def refuse_two_ways(self, start: int, dividend: Value, solidus: int, term: Term) -> None:
        """Raise for a divisor that may end at its number or its unit: 1/2 m, 3/4pi, 1/m s."""
        over = self.slice(start, solidus)
        under = self.slice(term.start, term.end)
        number, units = self.slice(term.start, term.middle), self.slice(term.middle, term.end)
        digits = number.removesuffix("pi").removesuffix("π").strip()
        has_pi = digits != number and digits[-1:] in (".", *DIGITS)
        if term.has_number and dividend.is_bare() and has_pi:
            ways = f"({over}*pi/{digits}) {units}", f"({over}/({number})) {units}"
            raise self.two_ways(start, *ways)
        if term.has_number and term.units and dividend.is_bare():
            raise self.two_ways(start, f"({over}/{number}) {units}", f"{over}/({under})")
        if not term.has_number and term.units > 1:
            ways = f"{over} / ({under})", f"{over} / {under.replace(' ', ' * ', 1)}"
            raise self.two_ways(start, *ways)
        if term.has_number and not term.units and has_pi:
            raise self.two_ways(start, f"{over}/({number})", f"{over}/{digits}*pi")
        if term.value.top == 0:
            raise self.wrong("divides by zero", "a number other than 0")

    def term(self, is_negative: bool = False) -> Term:
        """Read a number, a bracket or a function with the units after it, or units alone."""
        start = self.at
        value = self.number(is_negative)
        has_number = value is not None
        middle = self.at
        count = 0
        self.skip_blanks()
        begun = self.at
        while self.begins_unit(has_number and not count):
            self.factor(0)
            count += 1
            end = self.at
            self.skip_blanks()
        if count:
            self.at = end
            unit = self.unit(self.text[begun:end], start, value)
            value = value.times(unit) if value else unit
            self.skip_blanks()
        if value is None:
            if not self.peek() or self.peek() == ")":
                raise ExpressionError(f"a number is missing in '{quote(self.text)}'", HINT)
            raise self.unreadable()
        return Term(value, start, middle, self.at, has_number, count)

    def begins_unit(self, follows_number: bool) -> bool:
        c = self.peek()
        if not (c.isalpha() or c in NAMED or c == "_") or c in SUPERSCRIPTS or not c:
            return False
        if self.text[self.at : self.at + 4].lower() == "per " or self.is_function():
            return False
        return not (follows_number and self.is_times_ten())

    def begins_number(self) -> bool:
        if self.at in self.leaves:
            return True
        if self.peek() == "(":
            start, self.at = self.at, self.at + 1
            self.skip_blanks()
            if self.peek() in tuple(SIGNS):
                self.at += 1
                self.skip_blanks()
            is_number = self.begins_number()
            self.at = start
            return is_number
        c = self.peek()
        return c in (".", *DIGITS) or bool(self.is_function()) or self.pi_ends() > self.at

    def is_times_ten(self) -> bool:
        start = self.at
        is_factor = bool(self.times_ten())
        self.at = start
        return is_factor

    def is_function(self) -> str:
        """Return the name of the function that starts here, or ''."""
        return next((f for f in FUNCTIONS if self.text.startswith(f"{f}(", self.at)), "")

    def refuse_other_functions(self) -> None:
        for name in OTHER_FUNCTIONS:
            if self.text.startswith(f"{name}(", self.at):
                self.is_arithmetic = True
                hint = "log10 or ln" if name in ("log", "lg") else ", ".join(FUNCTIONS)
                problem = f"unknown function '{name}' in '{quote(self.text)}'"
                raise ExpressionError(problem, hint)

    def exponent(self) -> int:
        """Read the exponent of a unit; the sign in 1m+2m and 5m-2m begins another term."""
        if self.peek() and self.peek() in SIGNS:
            end = self.at + 1
            while self.text[end : end + 1] in tuple(DIGITS):
                end += 1
            next_char = self.text[end : end + 1]
            is_point = next_char == "." and not self.text[end + 1 : end + 2].isalpha()  # not m-2.sr
            if self.peek() == "+" or next_char.isalpha() or is_point or next_char in NAMED:
                return 1
        return super().exponent()

    def reading_of(self, scale: "ScaleUnit", start: int, number_text: str) -> "list[Try]":
        """Propose what to do with a reading of a scale in arithmetic: 10 dBm + 3 dB is 13 dBm."""
        before, after = self.text[:start].strip(), self.text[self.at :].strip()
        name = scale.text
        if not (before + after).strip(f"{SIGNS} "):
            sign = "-" * before.count("-")
            return [correct(self.text, f"{sign}{number_text} {name}")]
        tries = [
            call("convert", number_text, name, scale.unit.text, remark="then arithmetic with it")
        ]
        gain = after.removesuffix("dB").strip()
        if not before and gain != after and name.startswith("dB") and name != "dB":
            try:
                level = float(number_text) + float(gain.replace(" ", ""))
            except ValueError:
                return tries
            tries.insert(0, correct(self.text, f"{level:.12g} {name}", remark="a level and a gain"))
        return tries

    def unit(self, text: str, start: int = 0, number: Value | None = None) -> Value:
        """Return the value of adjacent units, in a term that begins at `start`."""
        text = " ".join(text.split())
        joined = text.lower().replace(" ", "_")
        is_name = " " in text and joined in NAMES  # foot lambert
        try:
            unit = resolve(joined if is_name else text)
        except UnitError:
            from radcalc.units.scales import find

            scale = find(text)
            other_terms = (self.text[:start] + self.text[self.at :]).strip(f"{SIGNS} ")
            if scale is None or not (self.is_arithmetic or other_terms):
                raise
            self.is_arithmetic = True
            number_text = f"{divide(number.top, number.bottom):.12g}" if number else "1"
            problem = f"calculates with {quote(text)}, which is a scale, not a unit"
            raise self.wrong(problem, self.reading_of(scale, start, number_text)) from None
        atoms = parse_unit(joined if is_name else text)
        dimension = unit.dimension
        units: dict[str, int] = {}
        for name, power, _ in atoms:
            units[name] = units.get(name, 0) + power
        if len(unit.atoms) > len(atoms):  # an inverse length alone is a wavenumber
            units = {f"{atoms[0][0]}-1": 1}
            cycle = BASES.index("cycle")
            dimension = (*dimension[:cycle], 0, *dimension[cycle + 1 :])
        units = {name: power for name, power in units.items() if power}
        return Value(unit.top, unit.bottom, dimension, units)

    def number(self, is_negative: bool) -> Value | None:
        """Read a number, a bracket or a function with its exponent; None at a unit."""
        start = self.at
        c = self.peek()
        self.refuse_other_functions()
        name = self.is_function()
        if c == "(" or name:
            self.at += len(name)
            value = self.bracket()
            if name:
                value = self.function(name, value, start)
        elif c in tuple(DIGITS) or c == "." or self.pi_ends() > self.at:
            value = self.literal()
        else:
            return None
        base_end = self.at
        power = self.power()
        if power is None:
            return value
        if is_negative and power % 2 == 0:
            base, raised = self.slice(start, base_end), self.slice(start, self.at)
            ways = f"(-{base}){self.slice(base_end, self.at)}", f"-({raised})"
            raise self.two_ways(len(self.text[:start].rstrip()) - 1, *ways)
        base = self.slice(start, base_end)
        digits, _, decimals = base.partition(".")
        if c in (*DIGITS, ".") and base[-1:] in ("i", "π"):  # 2pi^2
            pi = "pi" if base.endswith("pi") else "π"
            raised = self.slice(base_end, self.at)
            ways = f"({base}){raised}", f"{base.removesuffix(pi)}*{pi}{raised}"
            raise self.two_ways(start, *ways)
        if decimals == "10" and digits:
            exponent = self.slice(base_end, self.at)
            raise self.two_ways(start, f"{digits}*10{exponent}", f"({digits}.10){exponent}")
        self.is_arithmetic = True
        return Value(1).times(value, power) if power else Value(1, had_units=value.had_units)

    def leaf(self) -> Value | None:
        leaf = self.leaves.get(self.at)
        if leaf is None:
            return None
        self.at, value = leaf
        self.is_arithmetic = True
        return value

    def bracket(self) -> Value:
        if (leaf := self.leaf()) is not None:
            return leaf
        self.is_arithmetic |= self.begins_number()
        if self.depth >= MAX_DEPTH:
            raise self.wrong("has too many brackets", f"at most {MAX_DEPTH}, one in the other")
        self.depth += 1
        self.at += 1
        value = self.sum()
        if self.peek() != ")":
            if self.peek():
                raise self.unreadable()
            lacking = ")" * (self.text.count("(") - self.text.count(")"))
            raise self.wrong(
                "has a bracket that is not closed", correct(self.text, self.text + lacking)
            )
        self.at += 1
        self.depth -= 1
        return value

    def pi_ends(self) -> int:
        """Return the end of a pi that starts here, or this place: 40piW has one."""
        end = self.at + (2 if self.text.startswith("pi", self.at) else 1)
        if not self.text.startswith(("pi", "π"), self.at):
            return self.at
        word_end = end
        while self.text[word_end : word_end + 1].isalpha():
            word_end += 1
        if word_end == end:
            return end
        is_unit = lookup(self.text[self.at : word_end]) or not lookup(self.text[end:word_end])
        self.is_arithmetic |= not is_unit
        return self.at if is_unit else end

    def literal(self) -> Value:
        """Read a decimal, with or without a pi after it, or a pi alone."""
        if (leaf := self.leaf()) is not None:
            return leaf
        start = self.at
        rounding = 0.0
        value = Value(1)
        if self.pi_ends() == start:
            _, self.at, _ = read_term(self.text, start)
            decimal = self.text[start : self.at]
            if self.peek() not in SUPERSCRIPTS:
                refuse_lookalikes(self.text, self.at)
            digits, power = typed_digits(decimal) or ("0", 0)
            top = int(digits)
            power = power if top else 0
            if "." in decimal or "e" in decimal.lower():
                rounding = relative_rounding(decimal)
            value = Value(top * 10 ** max(power, 0), 10 ** max(-power, 0), rounding=rounding)
        number_end = self.at
        if number_end > start:
            self.skip_blanks()
        end = self.pi_ends()
        if end > self.at:
            self.is_arithmetic |= self.at > number_end > start
            self.at = end
            return value.times(Value(*PI))
        self.at = number_end
        return value

    def power(self) -> int | None:
        before = self.at
        self.skip_blanks()
        if self.text.startswith("**", self.at):
            self.at += 2
        elif self.peek() == "^":
            self.at += 1
        elif self.peek() not in SUPERSCRIPTS:
            self.at = before
            return None
        self.is_arithmetic = True
        self.skip_blanks()
        start = self.at
        closes = self.peek() == "("
        self.at += closes
        digits = self.signed_digits()
        if closes:
            digits = digits if self.peek() == ")" else ""
            self.at += 1
        size = digits.lstrip("+-")
        exponent = quote(self.text[start:])
        if not size.isdigit() or digits.count("-") > 1 or self.peek() in (".", "e", "E"):
            again = f"{self.text[:before].rstrip()}^{self.text[start:].lstrip('^')}"
            hint: Hint = correct(self.text, again) if exponent[:1] == "^" else "a whole number"
            problem = f"has an exponent at '{exponent}' that is not a whole number"
            raise self.wrong(problem, hint)
        if len(size) > 4 or int(size) > MAX_POWER:
            raise self.wrong(f"has an exponent too large at '{exponent}'", f"at most {MAX_POWER}")
        end = self.at
        self.skip_blanks()
        if self.peek() == "^" or self.text.startswith("**", self.at):
            raise self.wrong("has an exponent on an exponent", self.bracketed(before, start, end))
        self.at = end
        return int(digits.replace("+", ""))

    def bracketed(self, before: int, start: int, end: int) -> "Hint":
        """Propose both readings of 2^3^2, whose first exponent is from `start` to `end`."""
        import re  # only for an error

        base = re.search(r"[\w.]+\s*$", self.text[:before])
        second = re.match(r"\s*(\*\*|\^)\s*(\d{1,4})(?![\d.])", self.text[end:])
        first = self.text[start:end].strip()
        if not base or not second or not first.isdigit():
            return "brackets around one of them"
        head, rest = self.text[: base.start()], self.text[end:]
        left = f"{head}({self.text[base.start() : end].strip()}){rest}"
        tries = [correct(self.text, left, remark="the first power first")]
        if (power := int(first) ** int(second[2])) <= MAX_POWER:
            right = f"{self.text[:start]}{power}{rest[second.end() :]}"
            tries.insert(0, correct(self.text, right, remark=f"{first}^{second[2]} first"))
        return tries

    def function(self, name: str, value: Value, start: int) -> Value:
        self.is_arithmetic = True
        call = quote(self.slice(start, self.at))
        if name == "sqrt":
            return self.root(value, call)
        dimension = ANGLE if name in OF_ANGLES else NUMBER
        if value.dimension != dimension and dimension == ANGLE:
            better = self.with_part(start, f"{self.slice(start, self.at)[:-1]}deg)")
            hint = correct(self.text, better) if value.dimension == NUMBER else "an angle"
            raise self.wrong(NO_ANGLE.format(call), hint)
        if value.dimension != dimension:
            unit = value.unit()
            what = measured(unit.text) if unit else "a unit"
            raise self.wrong(NOT_A_NUMBER.format(what, call), "a bare number")
        from radcalc.units import functions

        of, top, bottom = functions.of_number, value.top, value.bottom
        if dimension == ANGLE:
            top, bottom = top * PI[1] * 180, bottom * PI[0]
            common = math.gcd(top, bottom)
            of, top, bottom = functions.of_angle, top // common, bottom // common
        try:
            top, bottom, blur = of(name, top, bottom, value.blur)
        except (ArithmeticError, ValueError):
            if name == "exp" and value.top < 0:
                raise self.wrong(f"is too small at {call}", "more than 2.3e-308") from None
            raise self.wrong(f"has no value for {call}", "another number") from None
        if blur > KEPT:
            raise self.wrong(f"has too few digits for {call}", "another number")
        return Value(top, bottom, blur=blur)

    def root(self, value: Value, call: str) -> Value:
        if value.top < 0 or any(power % 2 for power in value.dimension):
            raise self.wrong(f"has no value for {call}", "a square, such as 4 m2")
        from radcalc.units import functions

        top, bottom, blur = functions.root(value.top, value.bottom, value.blur)
        dimension = tuple([power // 2 for power in value.dimension])
        units = {name: power // 2 for name, power in value.units.items()}
        if any(power % 2 for power in value.units.values()):
            pairs = zip(COHERENT, dimension, strict=True)
            units = {name: power for name, power in pairs if power}
        return Value(top, bottom, dimension, units, value.rounding / 2, value.had_units, blur)


def evaluate(text: str, leaves: Leaves | None = None) -> Value | None:
    """Return the value of an expression, None for a text that is not an expression."""
    if len(text) > MAX_LENGTH:
        return None
    text = plain(text)
    calculator = Calculator(text, leaves)
    begun = text[:1]
    if not (begun in ("(", ".", *SIGNS, *DIGITS) or text.startswith(CALLS) or begun in "pπ"):
        return None
    try:
        value = calculator.answer()
    except (NumberError, UnitError):
        if not calculator.is_arithmetic:
            return None
        raise
    return value if calculator.is_arithmetic else None


def read_expression(
    text: str, leaves: Leaves | None = None
) -> tuple[float, Unit | None, float, tuple[int, int]] | None:
    """Return the number, unit, relative rounding error and exact ratio of an expression, or None.

    `leaves` are parts of a `plain` text that are already read.
    """
    value = evaluate(text, leaves)
    if value is None:
        return None
    unit = value.unit()
    top, bottom = value.top, value.bottom
    if unit:
        top, bottom = top * unit.bottom, bottom * unit.top
    number = divide(top, bottom)
    if math.isinf(number):
        raise ExpressionError(f"'{quote(text)}' is too large for a number", "less than 1.8e308")
    if abs(number) < SMALLEST and top:
        raise ExpressionError(f"'{quote(text)}' is too small for a number", "more than 2.3e-308")
    return number, unit, max(value.rounding, EXACT), (top, bottom)
