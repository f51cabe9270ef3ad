"""The grammar of numbers, a text to a float; names of constants in it; amounts with a unit.

The text is read in one pass, one character at a time, bounded in length; nothing is evaluated.

    NUMBER = [sign] TERM { ("*" | "/") TERM }        TERM = DECIMAL ["pi"] | "pi"

A DECIMAL after a solidus cannot be followed by pi: `2/3pi` is ambiguous.
"""

import math

from radcalc.errors import (
    MINUS,
    ExpressionError,
    NumberError,
    OutOfRange,
    ambiguous,
    correct,
    corrections,
    quote,
)
from radcalc.floats import INFINITE, SMALLEST, Typed
from radcalc.units import Unit
from radcalc.units.compiled import SPELLINGS_OF_CONSTANTS

TYPE_CHECKING = False  # typing.TYPE_CHECKING, without the cost of importing typing
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from typing import Any

    from radcalc.units.functions import Part

LONGEST_SYMBOL = 3  # full names match in any case


def find_constant(word: str) -> str:
    """Return the name of the constant with a spelling, '' if there is none."""
    name = SPELLINGS_OF_CONSTANTS.get(word, "")
    if name or len(word) <= LONGEST_SYMBOL:
        return name
    return SPELLINGS_OF_CONSTANTS.get(word.lower(), "")


def word_at(text: str, at: int) -> str:
    """Return the word of letters, digits and underscores that begins at a place."""
    end = at
    if text[at : at + 1].isalpha():
        while text[end : end + 1].isalpha() or text[end : end + 1] in tuple("_0123456789"):
            end += 1
    return text[at:end]


def are_run_together(word: str) -> bool:
    """Return whether a word is two constants without a sign: hc."""
    return len(word) == 2 and all(map(find_constant, word))


def times(number: int, base: int, power: int = 1) -> int:
    """Return a whole number times a power of another; refuse a product of too many digits."""
    if number.bit_length() + base.bit_length() * power > MAX_BITS:
        raise ExpressionError("a number in the expression has too many digits", "fewer")
    return number * int(base**power)


def begins_formula(text: str) -> bool:
    """Return whether a text begins with a constant, or with two without a sign."""
    word = word_at(text, 0)
    return bool(find_constant(word)) or are_run_together(word)


SIGNS_OF_UNCERTAINTY = ("±", "+-", "+/-", "+" + MINUS)


def are_uncertain(words: "Sequence[str]") -> bool:
    """Return whether words have several uncertain values, which no expression has."""
    text = " ".join(words)
    return sum([text.count(sign) for sign in SIGNS_OF_UNCERTAINTY]) > 1


MAX_LENGTH = 1000
MAX_BITS = 40_000  # of a whole number of a ratio: about 12 000 digits
LARGEST_EXPONENT = 2000  # of a text of that length whose number is a float, unless it is 0

EXACT = 1e-9  # relative error of arithmetic with exact numbers
OF_ONE_DIGIT = 3  # 2m is read as 2.00 m, 20m as typed

FUNCTIONS = ("sqrt", "sin", "cos", "tan", "exp", "ln", "log10", "log2")  # of expressions
OTHER_FUNCTIONS = (  # common functions that expressions do not support
    *("asin", "acos", "atan", "atan2", "arcsin", "arccos", "arctan", "sinh", "cosh", "tanh"),
    *("log", "lg", "lb", "pow", "abs", "min", "max", "sum", "mean", "round", "floor"),
)
OF_EXPRESSIONS = frozenset("*/^( _")  # in a first word; no command has one of them
CALLS = tuple([f"{name}(" for name in FUNCTIONS + OTHER_FUNCTIONS])
DIGITS = "0123456789"
MINUSES = "-" + MINUS
SIGNS = "+" + MINUSES
RUN = DIGITS + ",._"
HEXADECIMAL = DIGITS + "abcdefABCDEF"


def read_number(text: str) -> tuple[float, int]:
    """Read the number at the start of `text`; return it and its end.

    Raises NumberError if there is no number, or if it is ambiguous (`1,5`, `1,000`), unsupported
    (`1_000`, `0x10`, `nan`) or outside the range of a float.
    """
    if len(text) > MAX_LENGTH:
        raise NumberError(
            f"a text of {len(text)} characters is not a number",
            f"at most {MAX_LENGTH} characters are accepted",
        )
    at = 1 if text[:1] and text[0] in SIGNS else 0
    operator = ""
    value, _, at = read_term(text, at)
    while at + 1 < len(text) and text[at] in "*/" and _term_starts(text, at + 1):
        operator, start = text[at], at + 1
        right, bare, at = read_term(text, start)
        if operator == "/" and bare > start:
            _refuse_pi_below(text, bare)
            if right == 0:
                raise NumberError(f"'{quote(text)}' divides by zero", "a number other than 0")
        result = value * right if operator == "*" else value / right
        if value and right and abs(result) < SMALLEST:
            raise _too_small(text[:at])
        value = result
        if value == INFINITE:
            raise _too_large(text[:at])
    if operator == "/" and text[at : at + 1] in ("%", "‰"):
        over, _, under = text[:at].rpartition("/")
        ways = f"({over}/{under}){text[at:]}", f"{over}/({under}{text[at]}){text[at + 1 :]}"
        readings = " or ".join(map(quote, ways))
        raise NumberError(ambiguous(text), readings)
    refuse_lookalikes(text, at)
    return (-value if text[0] in MINUSES else value), at


def is_sentence(words: list[str]) -> bool:
    """Return whether a call begins with a value, not a command: `100 lx fc`, `-pi/2 rad deg`.

    The `-` or `- UNIT` of a stream counts as a value.
    """
    first = words[0] if words else ""
    start = 1 if first[:1] and first[0] in SIGNS else 0
    begun = first[start : start + 1]
    if begun == ".":
        begun = first[start + 1 : start + 2]
    is_function = first[start:].startswith(CALLS)
    is_number = begun.isnumeric() or _pi_ends(first, start) > start
    is_stream = first == "-" or first.lstrip()[:2] == "- "
    if is_stream or is_number or begun in ("(", "±") or is_function:
        return True
    if first.isascii() and OF_EXPRESSIONS.isdisjoint(first):
        return False

    return begins_formula(first[start:])


def typed_digits(text: str) -> tuple[str, int] | None:
    """Return the digits of a single decimal number, and the power of ten of its last digit.

    None for a fraction, a product or a multiple of pi, which are exact.
    """
    text = text[1:] if text[:1] in tuple(SIGNS) else text
    mantissa = _decimal_ends(text, 0)
    if not mantissa or _exponent_ends(text, mantissa) != len(text):
        return None
    whole, _, part = text[:mantissa].partition(".")
    exponent = int(text[mantissa + 1 :].replace(MINUS, "-") or 0)
    exponent = max(-LARGEST_EXPONENT, min(exponent, LARGEST_EXPONENT))  # 0e999999999 is 0
    return whole + part, exponent - len(part)


def parse_number(text: str) -> float:
    """Read the whole of `text` as one number."""
    text = text.strip()
    value, end = read_number(text)
    if end != len(text):
        raise NumberError(f"'{quote(text)}' is not a number", "a number such as 1.5e3, 1/3 or 4pi")
    return value


def exactly(text: str, number: float) -> float:
    """Return the number at the start of a text with its exact ratio; the number if it has none.

    Decimals, their products and quotients have one; multiples of pi and other texts have none.
    """
    try:
        end = read_number(text)[1]
    except NumberError:  # a number in a bracket, or a function
        return number
    top = bottom = 1
    for part in text[:end].replace("/", "*/").split("*"):
        typed = typed_digits(part.removeprefix("/"))
        if typed is None:
            return number
        digits, power = int(typed[0]), typed[1]
        over, under = digits * 10 ** max(power, 0), 10 ** max(-power, 0)
        if part[0] == "/":
            over, under = under, over
        top, bottom = top * over, bottom * under
    if not bottom or top / bottom != abs(number):  # the text is read in another way
        return number
    return Typed(number, (-top if number < 0 else top, bottom))


def split_quantity(text: str) -> tuple[float, str]:
    """Split '100 lx' into its number and the text of its unit, which may be empty."""
    text = text.strip()
    value, end = read_number(text)
    return value, text[end:].strip()


def _term_starts(text: str, at: int) -> bool:
    if text[at] in DIGITS:
        return True
    return (text[at] == "." and text[at + 1 : at + 2] in tuple(DIGITS)) or _pi_ends(text, at) > at


def _pi_ends(text: str, at: int) -> int:
    """Return the end of a pi that starts at `at`; `at` if none does."""
    end = at + 2 if text.startswith("pi", at) else at + 1 if text.startswith("π", at) else at
    if text[end:] in ("sr", "rad"):  # 4pisr, a common spelling
        return end
    return at if end < len(text) and (text[end].isalnum() or text[end] == "_") else end


def read_term(text: str, at: int) -> tuple[float, int, int]:
    """Read a term: its value, the end of its decimal, and its own end."""
    mantissa = _decimal_ends(text, at)
    if mantissa == at:
        end = _pi_ends(text, at)
        if end > at:
            return math.pi, at, end
        raise _not_a_number(text)
    bare = _exponent_ends(text, mantissa)
    value = float(text[at:bare].replace(MINUS, "-"))
    if value == INFINITE:
        raise _too_large(text[at:bare])
    if value < SMALLEST and text[at:mantissa].strip("0.") != "":
        raise _too_small(text[at:bare])
    end = _pi_ends(text, bare)
    if end == bare:
        return value, bare, bare
    if value * math.pi == INFINITE:
        raise _too_large(text[at:end])
    return value * math.pi, bare, end


def _digits_end(text: str, at: int) -> int:
    while at < len(text) and text[at] in DIGITS:
        at += 1
    return at


def _decimal_ends(text: str, at: int) -> int:
    """Return the end of a decimal without its exponent; `at` if none starts there."""
    point = _digits_end(text, at)
    if not text.startswith(".", point):
        return point
    end = _digits_end(text, point + 1)
    return end if end - at > 1 else point


def _exponent_ends(text: str, at: int) -> int:
    """Return the end of a decimal's exponent, as in e-5; `at` if none starts there."""
    if at + 1 < len(text) and text[at] in "eE":
        digits = at + 2 if text[at + 1] in SIGNS else at + 1
        end = _digits_end(text, digits)
        if end > digits:
            return end
    return at


def _refuse_pi_below(text: str, bare: int) -> None:
    """Raise for 1/2pi and 1/2 pi sr: a pi after a divisor, a decimal that ends at `bare`."""
    start = bare
    while text[start : start + 1].isspace():
        start += 1
    end = _pi_ends(text, start)
    if end > start:
        over, _, under = text[:bare].rpartition("/")
        above = f"{over}{'*pi' if over[-1] in 'iπ' else 'pi'}/{under}"
        rest = text[end:].rstrip()
        readings = f"{quote(above + rest)} or {quote(f'{over}/{under}/pi{rest}')}"
        raise NumberError(ambiguous(text), readings)


def _too_large(number: str) -> OutOfRange:
    return OutOfRange(f"'{quote(number)}' is too large for a number", "less than 1.8e308")


def _too_small(number: str) -> OutOfRange:
    return OutOfRange(f"'{quote(number)}' is too small for a number", "more than 2.3e-308")


def _not_a_number(text: str) -> NumberError:
    word = text.lstrip(SIGNS).lower()
    if word.startswith(("nan", "inf")):
        return NumberError(f"'{quote(text)}' is not a finite number", "a finite number")
    if not text.strip():
        return NumberError("a number is missing", "a number such as 1.5e3, 1/3 or 4pi")
    if word[:1].isnumeric() and not word[0].isascii():
        return NumberError(f"'{quote(text)}' is not a number", "the digits 0 to 9")
    return NumberError(f"'{quote(text)}' is not a number", "a number such as 1.5e3, 1/3 or 4pi")


def refuse_lookalikes(text: str, at: int) -> None:
    """Raise for characters after the number that look like its continuation."""
    rest = text[at : at + 2]
    if rest[:1] == "," and rest[1:] in tuple(DIGITS):
        raise _rewritten(text, at, "has a comma in its number", without_commas)
    if rest[:1] == "_":
        raise _rewritten(text, at, "is not a number", lambda run: [run.replace("_", "")])
    if rest[:1] in ("x", "X") and text[:at].lstrip(SIGNS) == "0" and rest[1:].isalnum():
        raise _of_other_base(text, at)
    if rest[:1].isnumeric():
        raise NumberError(f"'{quote(text)}' is not a number", "the digits 0 to 9")


def _of_other_base(text: str, at: int) -> NumberError:
    """Return the error for 0x1F, with the number that it is for a programmer."""
    end = at + 1
    while text[end : end + 1] and text[end] in HEXADECIMAL:
        end += 1
    typed = text[at - 1 : end]
    problem = f"'{quote(text)}' is not a number"
    if end == at + 1 or text[end : end + 1].isalpha():
        return NumberError(problem, "decimal digits")
    return NumberError(problem, correct(typed, str(int(typed, 16)), remark="in decimal digits"))


def _rewritten(
    text: str, at: int, problem: str, readings: "Callable[[str], list[str]]"
) -> NumberError:
    """Return the error for the number around `at`; its hint is the text with each reading."""
    start = end = at
    while start and text[start - 1] in RUN:
        start -= 1
    while text[end : end + 1] and text[end] in RUN:
        end += 1
    is_power = text[:start].rstrip(SIGNS)[-1:] in ("e", "E")  # 1e3,5
    runs = [] if is_power else readings(text[start:end])
    rewritten = [f"{text[:start]}{run}{text[end:]}".strip() for run in runs]
    hint = corrections(text, *rewritten) or "a number such as 1500 or 1.5, without commas"
    return NumberError(f"'{quote(text)}' {problem}", hint)


def without_commas(run: str) -> list[str]:
    """Return the readings of digits with commas: 1,5 and 1,000 and 1,000.5 and 1.000,5."""
    first, *groups = run.split(",")
    if "." in first:  # points separate thousands, and the comma begins the decimals
        grouped = _are_thousands(first.split(".")) and len(groups) == 1 and "." not in groups[0]
        return [f"{first.replace('.', '')}.{groups[0]}"] if grouped else []
    last, *decimals = groups[-1].split(".")
    thousands = _are_thousands([first, *groups[:-1], last]) and len(decimals) < 2
    readings = [run.replace(",", "")] if thousands else []
    if len(groups) == 1 and not decimals:
        readings.append(f"{first}.{last}")
    return readings


def _are_thousands(groups: list[str]) -> bool:
    is_begun = 0 < len(groups[0]) <= 3 and groups[0][0] != "0"
    return is_begun and all(len(group) == 3 for group in groups[1:])


def rounding(text: str) -> float:
    """Return the relative rounding error of a typed number: half a unit of its last digit.

    2m is read as 2.00 m.  Products, fractions, multiples of pi and 0 are exact, except for the
    rounding of the arithmetic.
    """
    return relative_rounding(text[: read_number(text)[1]]) or EXACT


def relative_rounding(number: str) -> float:
    """Return half a unit of a decimal's last digit, relative to it; 0 for other texts."""
    typed = typed_digits(number)
    digits = typed[0].lstrip("0") if typed else ""
    if len(digits) == 1:
        digits = digits.ljust(OF_ONE_DIGIT, "0")
    return 0.5 / float(digits) if digits else 0.0


class Amount:
    """A number in a unit, as the user typed it.

    `unit` is None for a bare number; `uncertainty` is the standard uncertainty in the unit, 0 if
    none was given; `assumptions` explain how the text was read, if that needs an explanation.  A
    `reading` on a `scale` is kept together with the number that it represents.  `rounding` is the
    relative rounding error of a typed expression, None for other texts.  `parts` are the
    contributions of the uncertain numbers of an expression, or of the reading.  `ratio` is the
    number of an expression, which `number` rounds.
    """

    __slots__ = (
        "assumptions",
        "number",
        "parts",
        "ratio",
        "reading",
        "rounding",
        "scale",
        "text",
        "uncertainty",
        "unit",
    )

    def __init__(
        self,
        text: str,
        number: float,
        unit: Unit | None,
        uncertainty: float = 0.0,
        assumptions: tuple[str, ...] = (),
        scale: "Any" = None,
        reading: float = 0.0,
        rounding: float | None = None,
        parts: "tuple[Part, ...]" = (),
        ratio: "tuple[int, int] | None" = None,
    ) -> None:
        self.text = text
        self.number = number
        self.unit = unit
        self.uncertainty = uncertainty
        self.assumptions = assumptions
        self.scale = scale
        self.reading = reading
        self.rounding = rounding
        self.parts = parts
        self.ratio = ratio

    @property
    def typed(self) -> tuple[float, Unit | None]:
        return (self.reading, self.scale) if self.scale else (self.number, self.unit)

    @property
    def exact(self) -> float:
        """The typed number or reading, with its ratio if the text has one."""
        if self.scale:
            return self.reading

        return Typed(self.number, self.ratio) if self.ratio else exactly(self.text, self.number)

    @property
    def is_uncertain(self) -> bool:
        """Return whether it is uncertain, even if a flat expression reduces that to 0."""
        return bool(self.uncertainty or self.parts)

    @property
    def typed_uncertainty(self) -> float:
        if self.scale:
            return self.uncertainty / float(abs(self.scale.slope(self.reading)))
        return self.uncertainty

    def __repr__(self) -> str:
        """Show the text."""
        return f"Amount({self.text!r})"
