"""The grammar of numbers and units: text to a float, text to atoms.

Nothing here knows what a unit means, and nothing is evaluated: one pass over the text, one
character at a time, bounded in length, depth and exponent.

    NUMBER   = [sign] TERM { ("*" | "/") TERM }        TERM = DECIMAL ["pi"] | "pi"
    UNIT     = FACTOR { [product] FACTOR } { "/" FACTOR }
    FACTOR   = (NAME | "1" | "(" UNIT ")") [EXPONENT]
    EXPONENT = digits | sign digits | ("^" | "**") [sign] digits | superscripts
"""

import math

from radcalc.errors import NumberError, UnitError, quote

MAX_LENGTH = 1000
MAX_DEPTH = 16
MAX_EXPONENT = 12
SMALLEST = 2.2250738585072014e-308  # below it a float loses digits

DIGITS = "0123456789"
MINUS = "-\u2212"
SIGNS = "+" + MINUS
PRODUCTS = "*.·⋅∙×"
SUPERSCRIPTS = dict(zip("⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻", "0123456789+-", strict=True))
# Characters with more than one code point, or that cannot be part of a Python identifier.
SAME = {
    "\u00b5": "u",  # micro sign
    "\u03bc": "u",  # Greek mu
    "\u212b": "\u00c5",  # angstrom sign
    "\u212a": "K",  # kelvin sign
    "\u00a0": " ",
    "\u202f": " ",
    "\t": " ",
}
NAMED = {"%": "percent", "‰": "permille", "°": "degree", "′": "arcminute", "″": "arcsecond"}
POWERS = {"square": 2, "sq": 2, "cubic": 3, "cu": 3}

Atom = tuple[str, int, bool]


def read_number(text: str) -> tuple[float, int]:
    """Read the number that `text` starts with; return it and where it ends.

    Raises NumberError where no number starts, or where the number is one that people read
    in two ways (`1,5`, `1,000`), that radcalc does not read (`1_000`, `0x10`, `nan`), or
    that a float cannot hold.
    """
    if len(text) > MAX_LENGTH:
        raise NumberError(
            f"a text of {len(text)} characters is not a number",
            f"at most {MAX_LENGTH} characters are read",
        )
    at = 1 if text[:1] and text[0] in SIGNS else 0
    value, at = _term(text, at)
    while at + 1 < len(text) and text[at] in "*/" and _term_starts(text, at + 1):
        operator = text[at]
        right, at = _term(text, at + 1)
        if operator == "*":
            value *= right
        elif right == 0:
            raise NumberError(f"'{quote(text)}' divides by zero", "a number other than 0")
        else:
            value /= right
    _refuse_lookalikes(text, at)
    if math.isinf(value):
        raise NumberError(f"'{quote(text)}' is too large for a number", "less than 1.8e308")
    return (-value if text[0] in MINUS else value), at


def parse_number(text: str) -> float:
    """Read the whole of `text` as one number."""
    text = text.strip()
    value, end = read_number(text)
    if end != len(text):
        raise NumberError(f"'{quote(text)}' is not a number", "a number such as 1.5e3, 1/3 or 4pi")
    return value


def split_quantity(text: str) -> tuple[float, str]:
    """Cut '100 lx' into its number and the text of its unit (which may be empty)."""
    text = text.strip()
    value, end = read_number(text)
    return value, text[end:].strip()


def _term_starts(text: str, at: int) -> bool:
    if text[at] in DIGITS:
        return True
    return (text[at] == "." and text[at + 1 : at + 2] in tuple(DIGITS)) or _pi_ends(text, at) > at


def _pi_ends(text: str, at: int) -> int:
    """Where a pi that starts at `at` ends, or `at` where none does."""
    end = at + 2 if text.startswith("pi", at) else at + 1 if text.startswith("π", at) else at
    if text[end:] in ("sr", "rad"):  # 4pisr, as people write it
        return end
    return at if end < len(text) and (text[end].isalnum() or text[end] == "_") else end


def _term(text: str, at: int) -> tuple[float, int]:
    start = at
    while at < len(text) and text[at] in DIGITS:
        at += 1
    whole = at - start
    if at < len(text) and text[at] == ".":
        point = at
        at += 1
        while at < len(text) and text[at] in DIGITS:
            at += 1
        if whole + at - point - 1 == 0:
            at = point
    if at == start:
        end = _pi_ends(text, at)
        if end > at:
            return math.pi, end
        raise _not_a_number(text)
    mantissa = at
    if at + 1 < len(text) and text[at] in "eE":
        digits = at + 2 if text[at + 1] in SIGNS else at + 1
        if digits < len(text) and text[digits] in DIGITS:
            at = digits
            while at < len(text) and text[at] in DIGITS:
                at += 1
    value = float(text[start:at].replace("\u2212", "-"))
    if value < SMALLEST and text[start:mantissa].strip("0.") != "":
        raise NumberError(f"'{quote(text)}' is too small for a number", "more than 2.3e-308")
    end = _pi_ends(text, at)
    return (value * math.pi, end) if end > at else (value, at)


def _not_a_number(text: str) -> NumberError:
    word = text.lstrip(SIGNS).lower()
    if word.startswith(("nan", "inf")):
        return NumberError(f"'{quote(text)}' is not a number radcalc takes", "a finite number")
    if not text.strip():
        return NumberError("a number is missing", "a number such as 1.5e3, 1/3 or 4pi")
    if word[:1].isnumeric() and not word[0].isascii():
        return NumberError(f"'{quote(text)}' is not a number", "the digits 0 to 9")
    return NumberError(f"'{quote(text)}' is not a number", "a number such as 1.5e3, 1/3 or 4pi")


def _refuse_lookalikes(text: str, at: int) -> None:
    """Refuse what goes on, after the number, in a way that people read as a number."""
    rest = text[at : at + 2]
    if rest[:1] == "," and rest[1:] in tuple(DIGITS):
        group = text[at + 1 : at + 5]
        thousands = len(group) >= 3 and group[:3].isdigit() and not group[3:].isdigit()
        if text.count(",") == 1 and "." not in text:
            choices = text.replace(",", ".")
            choices = f"{text.replace(',', '')} or {choices}" if thousands else choices
        else:
            choices = text.replace(",", "")
        raise NumberError(f"'{quote(text)}' has a comma in its number", quote(choices))
    if rest[:1] == "_":
        raise NumberError(f"'{quote(text)}' is not a number", quote(text.replace("_", "")))
    if rest[:1] in ("x", "X") and text[:at].lstrip(SIGNS) == "0" and rest[1:].isalnum():
        raise NumberError(f"'{quote(text)}' is not a number", "decimal digits")
    if rest[:1].isnumeric():
        raise NumberError(f"'{quote(text)}' is not a number", "the digits 0 to 9")


def parse_unit(text: str) -> list[Atom]:
    """Cut the text of a unit into atoms: (name, exponent, inverted).

    `inverted` marks an atom written with the exponent -1 below a solidus, as in `W/m2/cm-1`:
    there `cm-1` is a unit by itself.  A product after a solidus (`W/m2 sr`) is refused with
    both its readings, as the SI brochure has it.
    """
    if len(text) > MAX_LENGTH:
        raise UnitError(
            f"a text of {len(text)} characters is not a unit",
            f"at most {MAX_LENGTH} characters are read",
        )
    plain = "".join([SAME.get(c, c) for c in text]).strip()
    if not plain:
        raise UnitError("a unit is missing", "a unit such as lx, cd/m2 or W/(m2 sr)")
    scanner = _Scanner(plain)
    atoms = scanner.group(0)
    if scanner.at < len(plain):
        raise scanner.error("has a closing bracket too many")
    return [(name, n, inverse and n == 1) for name, n, inverse in atoms]


class _Scanner:
    """One pass over the text of a unit."""

    def __init__(self, text: str) -> None:
        self.text = text
        self.at = 0

    def error(self, problem: str, hint: str = "") -> UnitError:
        hint = hint or "a unit such as lx, cd/m2 or W/(m2 sr)"
        return UnitError(f"the unit '{quote(self.text)}' {problem}", hint)

    def peek(self) -> str:
        return self.text[self.at] if self.at < len(self.text) else ""

    def skip_blanks(self) -> bool:
        start = self.at
        while self.peek() == " ":
            self.at += 1
        return self.at > start

    def group(self, depth: int) -> list[Atom]:
        """Read up to the end of the text or the bracket that closes this group."""
        if depth > MAX_DEPTH:
            raise self.error("has too many brackets", f"at most {MAX_DEPTH}, one in the other")
        start, solidus = self.at, -1
        atoms: list[Atom] = []
        pending = ""  # the operator that waits for its right side
        self.skip_blanks()
        while True:
            self.skip_blanks()
            if self.peek() in ("", ")"):
                break
            operator = self.operator()
            if operator and pending:
                raise self.error(f"has '{operator}' after '{pending}'")
            if operator:
                if operator != "/" and not atoms:
                    raise self.error(f"starts with '{operator}'")
                pending = operator
                continue
            if not self.starts_factor():
                self.factor(depth)  # says what is wrong with it
            if pending == "/":
                solidus = self.at - 1 if solidus < 0 else solidus
            elif solidus >= 0:
                raise self.ambiguous(start, solidus)
            elif atoms and not pending and not self.separated():
                raise self.error("runs two units together", "a space or a dot between them")
            sign = -1 if pending == "/" else 1
            atoms += [(name, sign * n, inverse) for name, n, inverse in self.factor(depth)]
            pending = ""
        if pending:
            raise self.error(f"ends with '{pending}'")
        if not atoms:
            raise self.error("has nothing between its brackets")
        return atoms

    def starts_factor(self) -> bool:
        c = self.peek()
        return c in "(1_" or c in NAMED or c.isalpha()

    def separated(self) -> bool:
        return self.text[self.at - 1] in " )" or self.peek() == "("

    def operator(self) -> str:
        """Read an operator: '/' for a solidus or the word per, '*' for a product, or ''."""
        c = self.peek()
        if c == "/" or c in PRODUCTS:
            self.at += 1
            if c == "*" and self.peek() == "*":
                raise self.error("has an exponent on nothing")
            return "/" if c == "/" else "*"
        if self.text[self.at : self.at + 4].lower() == "per ":
            self.at += 3
            return "/"
        return ""

    def ambiguous(self, start: int, solidus: int) -> UnitError:
        """Refuse a product after a solidus, with both its readings."""
        over = self.text[start:solidus].strip().removesuffix("per").strip() or "1"
        under = self.text[solidus + 1 :].strip().lstrip("/").strip()
        first = self.text[start : self.at].strip().rstrip(PRODUCTS).strip()
        rest = self.text[self.at :].strip()
        if ")" in under and "(" not in under:  # inside a bracket that closes later
            under, rest = under.partition(")")[0], rest.partition(")")[0]
        return self.error(
            "can be read in two ways", f"{over}/({quote(under)}) or ({quote(first)}) {quote(rest)}"
        )

    def factor(self, depth: int) -> list[Atom]:
        """Read a name, a 1 or a bracket, with its exponent."""
        c = self.peek()
        power = 1
        if c == "(":
            self.at += 1
            atoms = self.group(depth + 1)
            if self.peek() != ")":
                raise self.error("has a bracket that is not closed")
            self.at += 1
        elif c in NAMED:
            self.at += 1
            atoms = [(NAMED[c], 1, False)]
        elif c == "1" and self.text[self.at + 1 : self.at + 2] in ("", "/", " ", ")", *PRODUCTS):
            self.at += 1
            return [("1", 1, False)]
        else:
            name = self.name()
            while name.lower() in POWERS and self.skip_blanks():
                power *= POWERS[name.lower()]
                name = self.name()
            atoms = [(name, power, False)]
        exponent = self.exponent()
        if power != 1 and exponent != 1:
            raise self.error("squares or cubes a unit with an exponent", "one of the two")
        if exponent == 1:
            return atoms
        simple = c != "("
        return [
            (name, self.bounded(n * exponent), inverse or (simple and exponent == -1))
            for name, n, inverse in atoms
        ]

    def name(self) -> str:
        start = self.at
        while c := self.peek():
            inside = self.at > start
            follows = self.text[self.at + 1 : self.at + 2]
            if not (
                c.isalpha()
                or c == "_"
                or (c in DIGITS and inside and "_" in self.text[start : self.at])
                or (c == "-" and inside and follows.isalpha())
            ):
                break
            self.at += 1
        if self.at == start:
            c = self.peek()
            if c in DIGITS:
                raise self.error("has a number in it", "one number, then the unit")
            raise self.error(f"has '{quote(c)}' in it, which radcalc cannot read")
        return self.text[start : self.at]

    def exponent(self) -> int:
        """Read an exponent, 1 where there is none."""
        before = self.at
        caret = False
        self.skip_blanks()
        if self.peek() == "^":
            caret, self.at = True, self.at + 1
        elif self.text.startswith("**", self.at):
            caret, self.at = True, self.at + 2
        else:
            self.at = before
        if caret:
            self.skip_blanks()
            if self.peek() == "{":
                raise self.error("has braces in it", "an exponent such as m^-2")
        bracket = caret and self.peek() == "("
        if bracket:
            self.at += 1
        start = self.at
        digits = ""
        if self.peek() in SUPERSCRIPTS:
            while self.peek() in SUPERSCRIPTS:
                digits += SUPERSCRIPTS[self.peek()]
                self.at += 1
        else:
            if self.peek() and self.peek() in SIGNS:
                self.at += 1
            while self.peek() and self.peek() in DIGITS:
                self.at += 1
            digits = self.text[start : self.at].replace("\u2212", "-")
        if not digits and not caret:
            return 1
        sign = -1 if digits[:1] == "-" else 1
        number = digits[1:] if digits[:1] in ("+", "-") else digits
        fraction = self.peek() in (".", "/") and self.text[self.at + 1 : self.at + 2].isdigit()
        if not number or (caret and fraction) or not number.isdigit():
            raise self.error("has an exponent that is not a whole number", "a whole number")
        if bracket:
            if self.peek() != ")":
                raise self.error("has an exponent that is not a whole number", "a whole number")
            self.at += 1
        if not caret and (self.peek().isalpha() or self.peek() == "("):
            raise self.error(
                "runs two units together", "a space or a dot between them, and one number"
            )
        if len(number) > 3:
            raise self.error("has an exponent too large", f"at most {MAX_EXPONENT}")
        if self.peek() in ("^", "⁻") or self.text.startswith("**", self.at):
            raise self.error("has an exponent on an exponent", "one exponent")
        return self.bounded(sign * int(number))

    def bounded(self, exponent: int) -> int:
        if abs(exponent) > MAX_EXPONENT:
            raise self.error(f"has the exponent {exponent}", f"at most {MAX_EXPONENT}")
        return exponent
