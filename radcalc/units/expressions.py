"""Arithmetic with units: `500 lx * 20 m2 / (0.6*0.8)`, `1 m + 2 ft`, `10^3 lx`.

The text is read in one pass, bounded in length, depth and size.  Numbers are ratios of whole
numbers, rounded once in the answer; pi is the ratio in the table of units.

    SUM      = [sign] PRODUCT { ("+" | "-") PRODUCT }
    PRODUCT  = TERM { ("*" | "/") TERM | FACTOR }
    TERM     = FACTOR { UNIT } | NUMBER [EXPONENT] { UNIT } | UNIT { UNIT }
    FACTOR   = (CONSTANT | "(" SUM ")" | "(" LEVEL ")" | FUNCTION "(" SUM ")") [EXPONENT]
    LEVEL    = READING { ("+" | "-") GAIN }, each a number on a scale: 10 dBm + 3 dB
    EXPONENT = ("^" | "**") (NUMBER | "(" SUM ")") | superscripts

Units belong to the number before them: `800 lm / 2 m2` is 400 lm/m2.  Ambiguous expressions
(`1/2 m` in a product, `100 W / 5 W/m2`, a product without a sign after a solidus) are refused with
both readings.  A short name of a constant that is also a unit, as h, has the meaning that fits the
quantity that is asked for.
"""

import math
from contextlib import suppress

from radcalc import errors
from radcalc.errors import call, quote
from radcalc.floats import SMALLEST, divide
from radcalc.units import BASES, NUMBER, PI, Dimension, Unit, lookup, read_own, values
from radcalc.units.compiled import CONSTANTS, NAMES
from radcalc.units.dimensions import ANGLE, weights_of
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
    are_run_together,
    find_constant,
    read_term,
    refuse_lookalikes,
    relative_rounding,
    typed_digits,
    word_at,
)
from radcalc.units.table import resolve
from radcalc.units.values import KEPT, Term, Value, is_part

TYPE_CHECKING = False  # typing is slow to import
if TYPE_CHECKING:
    from radcalc.units.values import ScaleUnit

MAX_POWER = 1000  # of a number
LONGEST_SCALE = 40  # characters of its name
AFTER_SCALES = f"{SIGNS}*/·×⋅)"
OF_SCALES = 1e-15  # relative error of a scale's quantity
OF_ANGLES = ("sin", "cos", "tan")
NO_ANGLE, NOT_A_NUMBER = "has no angle in {}", "has {} in {}"  # also of functions of direction
# Places of a word: after a unit and a sign; without a sign, after a number or after a unit.
AFTER_UNIT, BESIDE, BESIDE_UNIT = "after unit", "beside", "beside unit"
# Names of logarithms with two meanings, or with another usual name.
LOGARITHMS = {"log": ("log10", "ln"), "lg": ("log10",), "lb": ("log2",)}
HINT = "arithmetic such as '2 * 100 lx' or '500 lx * 20 m2 / 0.8'"


def _as_factor(terms: str) -> str:
    """Return terms as a factor: in brackets if there are signs in them."""
    return f"({terms})" if any(sign in terms for sign in SIGNS) else terms


Leaves = dict[int, tuple[int, Value]]
Names = tuple[str, ...]
Wanted = tuple[Dimension, ...]


class Calculator(Scanner):
    """One pass over the text of an expression.

    `leaves` are parts of the text that are already read: start, end and value.  `units` are the
    homonyms that are not constants; `lone` are the places of those that were read alone.  The
    `dimensions` that are asked for decide between two scales of one name.
    """

    divides = True

    def __init__(
        self, text: str, leaves: Leaves | None = None, units: Names = (), dimensions: Wanted = ()
    ) -> None:
        super().__init__(text)
        self.leaves = leaves or {}
        self.units, self.dimensions = units, dimensions
        self.lone: dict[int, str] = {}
        self.notes: dict[str, None] = {}
        self.depth = 0
        self.is_arithmetic = False  # False also for a number with an unreadable unit

    def error(self, problem: str, hint: errors.Hint = "") -> errors.ExpressionError:
        return self.wrong(problem, hint or HINT)

    def wrong(self, problem: str, hint: errors.Hint = HINT) -> errors.ExpressionError:
        return errors.ExpressionError(f"'{quote(self.text)}' {problem}", hint)

    def two_ways(self, start: int, first: str, second: str) -> errors.ExpressionError:
        """Return the error for a part, from `start` to here, that has two readings."""
        ways = [self.with_part(start, reading) for reading in (first, second)]
        return self.wrong("is ambiguous", errors.corrections(self.text, *ways))

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

    def unreadable(self) -> errors.ExpressionError:
        rest = self.text[self.at :]
        if rest[:1] in tuple(DIGITS) or rest[:1] in ("(", ".") or self.is_function():
            return self.wrong(
                f"runs two values together at '{quote(rest)}'", "a * or a + between them"
            )
        if rest.startswith("±"):
            self.is_arithmetic = True
            return self.wrong("has an uncertainty", "a separate value with it: 100±3 lx")
        return self.wrong(f"cannot be read from '{quote(rest)}' on")

    def sum(self) -> Value:
        """Read terms with + and - between them, each with a number and of the same quantity."""
        self.skip_blanks()
        if (level := self.level()) is not None:
            return level
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
                hint = "brackets, or a separate value for an uncertainty: 100±3 lx"
                raise self.wrong(f"has two signs in a row at '{signs}'", hint)
            before = start
            start = self.at
            term, is_numbered = self.product()
            if not has_number or not is_numbered:
                place = start if has_number else before
                bare = self.slice(start, self.at) if has_number else self.slice(before, start - 1)
                better = f"{self.text[:place]}1 {self.text[place:]}"
                raise self.wrong(
                    f"has no number at '{quote(bare)}'", errors.correct(self.text, better)
                )
            self.refuse_unlike(value, term, sign, begin, start)
            if value.is_mired or term.is_mired:
                self.refuse_reciprocals(sign, begin, start)
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
        hint: errors.Hint = "terms of one quantity"
        plus = "+" if sign > 0 else "-"
        if other.dimension == NUMBER and other.units:  # 100 lx + 10%
            better = f"{_as_factor(terms_before)} * (1 {plus} {term})"
            hint = errors.correct(self.text, self.with_part(begin, better))
        elif units[0] and not units[1]:  # 100 lx + 3
            hint = errors.correct(self.text, self.with_part(start, f"{term} {units[0].text}"))
        elif units[1] and not units[0] and term.endswith(units[1].text):  # 500 + 200 lx
            number = term.removesuffix(units[1].text).strip()
            better = f"({terms_before} {plus} {number}) {units[1].text}"
            hint = errors.correct(self.text, self.with_part(begin, better))
        named = [errors.measured(unit.text) if unit else "a bare number" for unit in units]
        link = " and " if sign > 0 else " from "
        if sign < 0:
            named.reverse()
        raise errors.ExpressionError(
            f"cannot {'add' if sign > 0 else 'subtract'} {link.join(named)}", hint
        )

    def refuse_reciprocals(self, sign: int, begin: int, start: int) -> None:
        """Raise for (200 mired) - (100 mired): a sum of reciprocals, or of temperatures."""
        terms = self.slice(begin, start)[:-1].rstrip(), self.slice(start, self.at)
        first, second = [term if term[0] == "(" else f"({term})" for term in terms]
        shift = f"1/{first} {'+' if sign > 0 else '-'} 1/{second}"
        hint = errors.corrections(self.text, self.with_part(begin, f"1/({shift})"))
        raise self.wrong("adds a reading in mired, which is a reciprocal", hint)

    def refuse_share(self, value: Value, other: Value, sign: int, begin: int, start: int) -> None:
        """Raise for 100 + 10%, which is 110 on a pocket calculator and 100.1 in algebra."""
        if value.is_bare() and value.top != value.bottom and any(map(is_part, other.units)):
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
        first = term = self.term(is_negative)
        value, has_number = first.value, first.has_number
        solidus: Term | None = None  # the last divisor
        operator = ""
        while True:
            self.skip_blanks()
            sign_at, last_operator = self.at, operator
            operator = self.times_ten() or (self.operator(self.peek()) if self.peek() else "")
            if not operator and self.begins_factor(term):
                value = self.implicit(first, value, term, last_operator)
                operator, has_number = "*", True
                continue
            if not operator:
                return value, has_number
            term = self.term_after(sign_at, term)
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

    def term_after(self, sign_at: int, before: Term) -> Term:
        """Read the term after an operator, which may have a sign of its own."""
        if self.text[sign_at : sign_at + 1] == "." and self.peek() in tuple(DIGITS):
            raise self.wrong("has a point that may be a product", "a * for a product")
        self.skip_blanks()
        if not self.peek() or self.peek() == ")":
            raise self.wrong(f"ends with '{quote(self.slice(sign_at, self.at))}'")
        is_negative = self.peek() in tuple(MINUSES)
        self.at += is_negative
        self.is_arithmetic |= is_negative or self.begins_number()
        follows = AFTER_UNIT if before.units or not before.has_number else ""
        term = self.term(is_negative, follows)
        if is_negative:
            term.value = term.value.times(Value(-1))
        return term

    def begins_factor(self, before: Term) -> bool:
        """Return whether a factor without a sign begins here: `4 pi (2 m)^2`, `2 c`."""
        if not before.has_number or not self.peek():
            return False
        if self.peek() == "(":
            inside, closed, _ = self.text[self.at + 1 :].partition(")")
            is_number = bool(closed) and typed_digits(inside.strip()) is not None
            ends_in_number = self.text[before.start : before.middle].strip()[-1:]
            is_uncertain = before.start in self.leaves or ends_in_number in tuple(DIGITS)
            return bool(closed) and not before.units and not (is_number and is_uncertain)
        return bool(
            self.is_function() or self.constant_here(BESIDE_UNIT if before.units else BESIDE)
        )

    def implicit(self, first: Term, value: Value, before: Term, operator: str) -> Value:
        """Return a value times the factor that begins here; raise after a divisor."""
        start = self.at
        self.is_arithmetic = True
        term = self.term(follows=BESIDE_UNIT if before.units else BESIDE)
        if operator == "/":
            over = self.slice(first.start, before.start).rstrip("/ ").removesuffix("per")
            under = self.slice(before.start, term.end)
            quotient, factor = self.slice(first.start, before.end), self.slice(start, term.end)
            raise self.two_ways(first.start, f"{over} / ({under})", f"({quotient}) * {factor}")
        before.end, before.units = term.end, term.units
        return value.times(term.value)

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

    def term(self, is_negative: bool = False, follows: str = "") -> Term:
        """Read a number, a constant, a bracket or a function with its units, or units alone."""
        start = self.at
        value = self.number(is_negative, follows)
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
            self.refuse_scale(begun, start, value)
            self.at = end
            unit = self.unit(self.text[begun:end])
            value = value.times(unit) if value else unit
            self.skip_blanks()
        if value is None:
            if not self.peek() or self.peek() == ")":
                raise errors.ExpressionError(f"a number is missing in '{quote(self.text)}'", HINT)
            raise self.unreadable()
        return Term(value, start, middle, self.at, has_number, count)

    def begins_unit(self, follows_number: bool) -> bool:
        c = self.peek()
        if not (c.isalpha() or c in NAMED or c == "_") or c in SUPERSCRIPTS or not c:
            return False
        if self.text[self.at : self.at + 4].lower() == "per " or self.is_function():
            return False
        if self.constant_here(BESIDE if follows_number else BESIDE_UNIT):
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

    def constant_here(self, follows: str) -> str:
        """Return the name of the constant that begins here, '' for a unit or another text.

        A letter beside a number or a unit is a unit: 16 h, 50k.  A homonym is noted where it is
        alone.
        """
        word = word_at(self.text, self.at)
        name = find_constant(word)
        if len(word) == 1 and follows in (BESIDE, BESIDE_UNIT):
            is_number = self.text[: self.at].rstrip()[-1:] in (".", *DIGITS)
            name = "" if is_number or follows == BESIDE_UNIT else name
        if not name or word not in values.HOMONYMS:
            return name
        if word != values.EULER and follows:
            return ""
        self.lone[self.at] = word
        if word in self.units:
            return name if word == values.EULER else ""
        return name

    def constant(self) -> Value:
        word = word_at(self.text, self.at)
        self.at += len(word)
        self.is_arithmetic = True
        if word == values.EULER and word in self.units:
            from radcalc.units import functions

            top, bottom, _ = functions.of_number("exp", 1, 1, 0.0)
            return Value(top, bottom, blur=KEPT / 1e6)
        name = find_constant(word)
        read_own(name)
        top, bottom, dimension = CONSTANTS[name]
        return Value(top, bottom, dimension, {name: 1})

    def is_function(self) -> str:
        """Return the name of the function that starts here, or ''."""
        return next((f for f in FUNCTIONS if self.text.startswith(f"{f}(", self.at)), "")

    def refuse_other_functions(self) -> None:
        for name in OTHER_FUNCTIONS:
            if self.text.startswith(f"{name}(", self.at):
                self.is_arithmetic = True
                self.at += len(name)
                start = self.at - len(name)
                meant = LOGARITHMS.get(name, ())
                better = [f"{self.text[:start]}{other}{self.text[self.at :]}" for other in meant]
                hint: errors.Hint = errors.corrections(self.text, *better) or ", ".join(FUNCTIONS)
                problem = f"unknown function '{name}' in '{quote(self.text)}'"
                raise errors.ExpressionError(problem, hint)

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

    def refuse_scale(self, begun: int, start: int, number: Value | None) -> None:
        """Raise for a reading of a scale in arithmetic, in a term from `start`: 2 * 10 dBm."""
        found, before = self.scale_at(begun), self.text[:start].strip()
        after = self.text[found[1] :].strip() if found else ""
        if not found or not (self.is_arithmetic or f"{before}{after}".strip(SIGNS)):
            return
        self.is_arithmetic = True
        name, unit = found[0].text, found[0].unit.text
        number_text = f"{divide(number.top, number.bottom):.12g}" if number else "1"
        level = f"{before.removeprefix('+')}{number_text}" if before in SIGNS else number_text
        hint: errors.Hint = [call("convert", level, name, unit, remark="then arithmetic with it")]
        if before[-1:] in tuple(SIGNS) and not found[0].scale.steps:  # 5600 K + 134 mired
            terms = f"1/({before[:-1].strip()}) {before[-1]} 1/({number_text} {name})"
            hint = errors.correct(self.text, f"1/({terms}){after}")
        elif before[-1:] in tuple(SIGNS) and not name.startswith("dB"):  # 500 lx - 1 EV
            hint = f"a value in units: after a sign, {quote(name)} may be a factor or a shift"
        raise self.wrong(f"calculates with {quote(name)}, which is a scale, not a unit", hint)

    def unit(self, text: str) -> Value:
        """Return the value of adjacent units."""
        text = " ".join(text.split())
        joined = text.lower().replace(" ", "_")
        is_name = " " in text and joined in NAMES  # foot lambert
        unit = resolve(joined if is_name else text)
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

    def number(self, is_negative: bool, follows: str = "") -> Value | None:
        """Read a number, a constant, a bracket or a function with its exponent; None at a unit."""
        start = self.at
        c = self.peek()
        self.refuse_other_functions()
        name = self.is_function()
        if c == "(" or name:
            self.at += len(name)
            value = self.bracket()
            if name:
                value = self.function(name, value, start)
        elif self.constant_here(follows):
            value = self.constant()
        elif c in tuple(DIGITS) or c == "." or self.pi_ends() > self.at:
            value = self.literal()
        else:
            return None
        base_end = self.at
        power = self.power()
        if power is None:
            return value
        self.refuse_two_powers(start, base_end, is_negative and _is_even(power))
        self.is_arithmetic = True
        if not isinstance(power, int):
            return self.real_power(value, power, self.slice(start, self.at))
        return Value(1).times(value, power) if power else Value(1, had_units=value.had_units)

    def refuse_two_powers(self, start: int, base_end: int, is_negative: bool) -> None:
        """Raise for -2^2, 2pi^2 and 5.10^3, whose exponent may belong to more or less."""
        base, raised = self.slice(start, base_end), self.slice(start, self.at)
        exponent = self.slice(base_end, self.at)
        if is_negative:
            ways = f"(-{base}){exponent}", f"-({raised})"
            raise self.two_ways(len(self.text[:start].rstrip()) - 1, *ways)
        digits, _, decimals = base.partition(".")
        if base[0] in (*DIGITS, ".") and base[-1:] in ("i", "π"):  # 2pi^2
            pi = "pi" if base.endswith("pi") else "π"
            ways = f"({base}){exponent}", f"{base.removesuffix(pi)}*{pi}{exponent}"
            raise self.two_ways(start, *ways)
        if decimals == "10" and digits:
            raise self.two_ways(start, f"{digits}*10{exponent}", f"({digits}.10){exponent}")

    def real_power(self, base: Value, power: Value, text: str) -> Value:
        """Return a number to a power that is not whole."""
        if base.quantity != NUMBER:
            unit = base.unit()
            what = errors.measured(unit.text) if unit else "a unit"
            hint = "sqrt(4 m2), or a whole number as exponent"
            raise self.wrong(f"has {what} with an exponent that is not whole, {quote(text)}", hint)
        if base.top <= 0:
            if base.top == 0 and power.top > 0:
                return Value(0, had_units=base.had_units)
            raise self.wrong(f"has no value for {quote(text)}", "a number above 0")
        from radcalc.units import functions

        try:
            top, bottom, blur = functions.of_power(base.ratio, power.ratio)
        except (ArithmeticError, ValueError):
            raise self.wrong(f"has no value for {quote(text)}", "another exponent") from None
        if blur > KEPT:
            raise self.wrong(f"has too few digits for {quote(text)}", "another exponent")
        rounding = abs(divide(power.top, power.bottom)) * base.rounding
        return Value(top, bottom, rounding=rounding, had_units=base.had_units, blur=blur)

    def leaf(self) -> Value | None:
        leaf = self.leaves.get(self.at)
        if leaf is None:
            return None
        self.at, value = leaf
        self.is_arithmetic = True
        return value

    def bracket(self) -> Value:
        """Read a number, a unit, a function, a level, or a sum in brackets."""
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
                "has a bracket that is not closed", errors.correct(self.text, self.text + lacking)
            )
        self.at += 1
        self.depth -= 1
        return value

    def scale_at(self, at: int) -> "tuple[ScaleUnit, int] | None":
        """Return the scale with the longest name that begins at a place, and its end; else None."""
        depth, found = 0, None
        is_name = self.text[at : at + 1].isalpha()
        for end in range(at + 1, min(at + LONGEST_SCALE, len(self.text)) + 1) if is_name else ():
            c = self.text[end : end + 1]
            if not depth and (not c or c in AFTER_SCALES):
                scale = values.find_scale(self.text[at:end])
                found = (scale, end) if scale else found
            depth += (c == "(") - (c == ")")
            if depth < 0:
                break
        return found

    def reading(self) -> "tuple[ScaleUnit, float, float] | None":
        """Read a number on a scale, also in brackets, with its rounding; None for other texts."""
        start, opened = self.at, self.peek() == "("
        self.at += opened
        self.skip_blanks()
        begun = self.at
        self.at += bool(self.peek()) and self.peek() in SIGNS
        if start not in self.leaves and self.peek() in (".", *DIGITS):
            with suppress(errors.NumberError):
                number, _, self.at = read_term(self.text, self.at)
                digits = self.text[begun : self.at]
                self.skip_blanks()
                scale, self.at = self.scale_at(self.at) or (None, start)
                if scale and typed_digits(digits) and (not opened or self.peek() == ")"):
                    self.at += opened
                    self.skip_blanks()
                    off = number * relative_rounding(digits)
                    return scale, -number if digits[0] in MINUSES else number, off
        self.at = start
        return None

    def level(self) -> Value | None:
        """Read a sum that is a reading of a scale, with any gains; None for another sum."""
        start, sign, number, off = self.at, 1, 0.0, 0.0
        scale: ScaleUnit | None = None
        while reading := self.reading():
            change = scale.scale.change(reading[0].scale) if scale else 1.0
            number, off = number + sign * change * reading[1], off + abs(change) * reading[2]
            is_sum, scale, following = bool(scale), scale or reading[0], self.peek()
            if change and following in ("", ")"):
                self.is_arithmetic |= is_sum or self.text[start] == "("
                return self.quantity(scale, number, off)
            if not change or following not in SIGNS:
                break
            sign = -1 if following in MINUSES else 1
            self.at += 1
            self.skip_blanks()
        self.at = start
        return None

    def quantity(self, scale: "ScaleUnit", number: float, off: float) -> Value:
        """Return the quantity of a reading; `off` is the rounding of its digits."""
        scales = (scale, *scale.others)
        fitting = [one for one in scales if one.dimension in self.dimensions or not scale.others]
        if not fitting:
            text, read = f"{number:.12g} {scale.text}", [one.unit.text for one in scales]
            problem = f"has {quote(scale.text)}, which is a scale of {' and of '.join(read)}"
            raise self.wrong(problem, [call("convert", text, one) for one in read])
        scale = fitting[0]
        quantity = scale.quantity(number)
        rounding = abs(scale.slope(number) * off / quantity)
        self.notes[scale.assumption] = None
        top, bottom = quantity.as_integer_ratio()
        is_number = scale.unit.text == "1"
        size = Value(top, bottom, NUMBER, {}, rounding, is_number, OF_SCALES)
        size = size if is_number else size.times(self.unit(scale.unit.text))
        size.is_mired = not scale.scale.steps
        return size

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

    def power(self) -> "int | Value | None":
        """Read an exponent: a whole number, or another number as a `Value`; None without one."""
        before = self.at
        self.skip_blanks()
        is_raised = self.peek() in SUPERSCRIPTS
        if self.text.startswith("**", self.at):
            self.at += 2
        elif self.peek() == "^":
            self.at += 1
        elif not self.peek() or not is_raised:
            self.at = before
            return None
        self.is_arithmetic = True
        self.skip_blanks()
        start = self.at
        value = self.exponent_of_number(start, is_raised)
        exponent = quote(self.text[start:])
        if value.quantity != NUMBER or value.had_units:
            raise self.wrong(f"has an exponent at '{exponent}' that has a unit", "a bare number")
        if abs(value.top) > MAX_POWER * value.bottom:
            raise self.wrong(f"has an exponent too large at '{exponent}'", f"at most {MAX_POWER}")
        end = self.at
        self.skip_blanks()
        if self.peek() == "^" or self.text.startswith("**", self.at):
            raise self.wrong("has an exponent on an exponent", self.bracketed(before, start, end))
        self.at = end
        return value.top if value.bottom == 1 and not value.blur else value

    def exponent_of_number(self, start: int, is_raised: bool) -> Value:
        """Read a decimal with its sign, a bracket without an uncertainty, or superscripts."""
        sign = self.peek() if self.peek() in tuple(SIGNS) and not is_raised else ""
        self.at += len(sign)
        if self.peek() == "(" and self.at not in self.leaves:
            value = self.bracket()
        elif not is_raised and self.peek() in (".", *DIGITS) and self.at not in self.leaves:
            _, end, _ = read_term(self.text, self.at)
            digits, power = typed_digits(self.text[self.at : end]) or ("0", 0)
            value = Value(int(digits) * 10 ** max(power, 0), 10 ** max(-power, 0))
            self.at = end
        else:
            value = self.whole_power(start)
        return value.times(Value(-1)) if sign and sign in MINUSES else value

    def whole_power(self, start: int) -> Value:
        """Read the digits of an exponent, which may be superscripts."""
        digits = self.signed_digits()
        if not digits.lstrip("+-").isdigit() or digits.count("-") > 1:
            exponent = quote(self.text[start:])
            again = f"{self.text[:start].rstrip('^* ')}^{self.text[start:].lstrip('^')}"
            hint: errors.Hint = (
                errors.correct(self.text, again) if exponent[:1] == "^" else "a number"
            )
            raise self.wrong(f"has an exponent at '{exponent}' that is not a number", hint)
        if len(digits) > 5:
            exponent = quote(self.text[start:])
            raise self.wrong(f"has an exponent too large at '{exponent}'", f"at most {MAX_POWER}")
        return Value(int(digits.replace("+", "")))

    def bracketed(self, before: int, start: int, end: int) -> "errors.Hint":
        """Propose both readings of 2^3^2, whose first exponent is from `start` to `end`."""
        import re  # only for an error

        base = re.search(r"[\w.]+\s*$", self.text[:before])
        second = re.match(r"\s*(\*\*|\^)\s*(\d{1,4})(?![\d.])", self.text[end:])
        first = self.text[start:end].strip()
        if not base or not second or not first.isdigit():
            return "brackets around one of them"
        head, rest = self.text[: base.start()], self.text[end:]
        left = f"{head}({self.text[base.start() : end].strip()}){rest}"
        tries = [errors.correct(self.text, left, remark="the first power first")]
        if (power := int(first) ** int(second[2])) <= MAX_POWER:
            right = f"{self.text[:start]}{power}{rest[second.end() :]}"
            tries.insert(0, errors.correct(self.text, right, remark=f"{first}^{second[2]} first"))
        return tries

    def function(self, name: str, value: Value, start: int) -> Value:
        """Return a function of a value: an angle for sines, a bare number for logarithms."""
        self.is_arithmetic = True
        call = quote(self.slice(start, self.at))
        if name == "sqrt":
            return self.root(value, call)
        dimension = ANGLE if name in OF_ANGLES else NUMBER
        if value.quantity != dimension and dimension == ANGLE:
            inside = self.slice(start, self.at)[:-1]
            better = [self.with_part(start, f"{inside}{unit})") for unit in ("deg", "rad")]
            hint = (
                errors.corrections(self.text, *better) if value.quantity == NUMBER else "an angle"
            )
            raise self.wrong(NO_ANGLE.format(call), hint)
        if value.quantity != dimension:
            unit = value.unit()
            what = errors.measured(unit.text) if unit else "a unit"
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
        if value.top < 0 or any(
            power % 2 for power in (*value.dimension, *weights_of(value.dimension).values())
        ):
            raise self.wrong(f"has no value for {call}", "a square, such as 4 m2")
        from radcalc.units import functions

        top, bottom, blur = functions.root(value.top, value.bottom, value.blur)
        dimension = tuple([power // 2 for power in value.dimension])
        units = {name: power // 2 for name, power in value.units.items()}
        if any(power % 2 for power in value.units.values()):
            units = values.base_units(dimension)
        return Value(top, bottom, dimension, units, value.rounding / 2, value.had_units, blur)


def _is_even(power: "int | Value") -> bool:
    return isinstance(power, int) and power % 2 == 0


class _Reading:
    """An expression with its homonyms read as constants, or some of them as units."""

    def __init__(self, text: str, leaves: Leaves | None, units: Names, dimensions: Wanted) -> None:
        calculator = Calculator(text, leaves, units, dimensions)
        self.value: Value | None = None
        self.problem: errors.RadcalcError | None = None
        try:
            self.value = calculator.answer()
            self.unit = self.value.unit()
        except (errors.NumberError, errors.UnitError) as error:
            self.problem = error
        self.is_arithmetic = calculator.is_arithmetic
        self.units, self.lone, self.notes = units, calculator.lone, calculator.notes

    @property
    def is_valid(self) -> bool:
        return self.problem is None and self.is_arithmetic

    def text(self, text: str) -> str:
        """Return the text with unambiguous names for the homonyms."""
        for at, word in sorted(self.lone.items(), reverse=True):
            text = text[:at] + self.meaning(word) + text[at + len(word) :]
        return text

    def meaning(self, word: str) -> str:
        if word not in self.units:
            return values.plain_spelling(find_constant(word))
        entry = lookup(word)
        return "exp(1)" if entry is None else entry[1]

    def said(self) -> list[str]:
        words = dict.fromkeys(self.lone.values())
        return [f"{word} is read as {self.meaning(word)}" for word in words]

    def fits(self, dimensions: Wanted, is_counted: bool) -> bool:
        """Return whether the value is of one of the dimensions, if need be with cycles counted."""
        if self.unit is None:
            return NUMBER in dimensions
        if not is_counted:
            return self.unit.dimension in dimensions
        return any(values.fit(self.unit, one).dimension == one for one in dimensions)


class TwoReadings(errors.ExpressionError):
    """An expression that means two quantities; the one that is asked for may decide."""


def _chosen(text: str, leaves: Leaves | None, dimensions: Wanted) -> _Reading:
    """Return the reading of an expression that fits the dimensions; raise if several do."""
    first = _Reading(text, leaves, (), dimensions)
    letters = values.homonyms(text) if first.lone or first.problem else []
    if not letters:
        return first
    readings = [first]
    for number in range(1, 1 << len(letters)):
        units = tuple([word for k, word in enumerate(letters) if number >> k & 1])
        readings.append(_Reading(text, leaves, units, dimensions))
    if not any(reading.lone for reading in readings):
        return first
    valid: dict[str, _Reading] = {}
    for reading in readings:
        if reading.is_valid:
            valid.setdefault(reading.text(text), reading)
    fitting = list(valid.values())
    for is_counted in (False, True):
        if dimensions and len(fitting) > 1:
            fitting = [r for r in valid.values() if r.fits(dimensions, is_counted)] or fitting
    if len(fitting) == 1:
        return fitting[0]
    if not fitting:
        return readings[-1]
    words = ", ".join(dict.fromkeys(w for reading in readings for w in reading.lone.values()))
    raise TwoReadings(f"'{quote(text)}' is ambiguous: {words}", errors.corrections(text, *valid))


def _begins_with_constant(text: str) -> bool:
    """Return whether a text begins with a constant; raise for two without a sign, as hc."""
    word = word_at(text, 0)
    if are_run_together(word) and not lookup(word):
        problem = f"'{quote(word)}' is not the name of a constant"
        raise errors.ExpressionError(problem, errors.correct(text, f"{word[0]}*{text[1:]}"))
    return bool(find_constant(word))


def evaluate(
    text: str, leaves: Leaves | None = None, dimensions: Wanted = ()
) -> tuple[Value, Unit | None] | None:
    """Return the value of an expression and its unit, None for a text that is not an expression.

    The dimensions that are asked for decide between two readings.
    """
    if len(text) > MAX_LENGTH:
        return None
    text = plain(text)
    begun = text[:1]
    begins = begun in ("(", ".", *SIGNS, *DIGITS) or text.startswith(CALLS) or begun in "pπ"
    if text in values.HOMONYMS or not (begins or _begins_with_constant(text)):
        return None
    reading = _chosen(text, leaves, dimensions)
    if not reading.is_arithmetic:
        return None
    if reading.problem:
        raise reading.problem
    value, unit = reading.value, reading.unit
    assert value is not None
    if unit is None and reading.notes:
        unit = resolve("1")
    if unit is not None:
        unit.notes += (*reading.said(), *reading.notes)
        for dimension in dimensions:
            unit = values.fit(unit, dimension)
    return value, unit


def read_expression(
    text: str, leaves: Leaves | None = None, dimensions: Wanted = ()
) -> tuple[float, Unit | None, float, tuple[int, int]] | None:
    """Return the number, unit, relative rounding error and exact ratio of an expression, or None.

    `leaves` are parts of a `plain` text that are already read.  The dimensions that are asked for
    decide between two readings.
    """
    result = evaluate(text, leaves, dimensions)
    if result is None:
        return None
    value, unit = result
    top, bottom = value.top, value.bottom
    if unit:
        top, bottom = top * unit.bottom, bottom * unit.top
    number = divide(top, bottom)
    if math.isinf(number):
        raise errors.ExpressionError(
            f"'{quote(text)}' is too large for a number", "less than 1.8e308"
        )
    if abs(number) < SMALLEST and top:
        raise errors.ExpressionError(
            f"'{quote(text)}' is too small for a number", "more than 2.3e-308"
        )
    return number, unit, max(value.rounding, EXACT), (top, bottom)
