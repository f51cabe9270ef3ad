"""The grammar of units: a text to atoms, in one pass of bounded length, depth and exponent.

The grammar does not know the units.

    UNIT     = FACTOR { [product] FACTOR } { "/" FACTOR }
    FACTOR   = (NAME | "1" | "(" UNIT ")") [EXPONENT]
    EXPONENT = digits | sign digits | ("^" | "**") [sign] digits | superscripts

The words between an amount and its target, or between a unit and its divisor, are one table.  A
divisor after Czech `za` and Russian `за` and `в` is a time; after `na` and `на` it is neither a
time nor light that is seen or counted.  It is never of the quantity that it divides.
"""

from radcalc.errors import MINUS, Hint, RadcalcError, UnitError, correct, corrections, quote
from radcalc.units import COUNT_AT, LUMINOSITY_AT, TIME_AT, Unit
from radcalc.units.numbers import DIGITS, MAX_LENGTH, SIGNS

TO = ("to", "into", "->", "=>", "→", "=")  # before a target, always
ALSO_UNITS = ("in", "as")  # before a target, or inches and attoseconds
TIME, OTHERS = "time", "others"
DIVIDERS = {"na": OTHERS, "на": OTHERS, "za": TIME, "за": TIME, "в": TIME}
ALSO = (*ALSO_UNITS, "na", "на", "в", "v", "do")  # before a target, or something else


def divides(word: str, over: "Unit | None", under: "Unit | None") -> bool:
    """Return whether a word of another language is `per` between two units."""
    if under is None:
        return False
    powers = under.dimension
    is_time = sum(map(abs, powers)) == powers[TIME_AT] == 1
    if is_time != (DIVIDERS[word] == TIME) or (over and over.dimension == powers):
        return False
    return not (powers[COUNT_AT] or powers[LUMINOSITY_AT])


MAX_DEPTH = 16
MAX_EXPONENT = 12

PRODUCTS = "*.·⋅∙×"
SUPERSCRIPTS = dict(zip("⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻", "0123456789+-", strict=True))
# Characters with several code points, or that a Python identifier cannot contain.
SAME = str.maketrans({
    "\u00b5": "u",  # micro sign
    "\u03bc": "u",  # Greek mu
    "\u212b": "\u00c5",  # angstrom sign
    "\u212a": "K",  # kelvin sign
    "\u00a0": " ",
    "\u202f": " ",
    "\t": " ",
    "\u2103": "°C",
    "\u2109": "°F",
})  # fmt: skip
NAMED = {"%": "percent", "‰": "permille", "°": "degree", "′": "arcminute", "″": "arcsecond"}
POWERS = {"square": 2, "sq": 2, "cubic": 3, "cu": 3}

Atom = tuple[str, int, bool]


def plain(text: str) -> str:
    """Return the text with look-alike characters normalised, without outer blanks."""
    return text.translate(SAME).strip()


def parse_unit(text: str) -> list[Atom]:
    """Split the text of a unit into atoms: (name, exponent, inverted).

    `inverted` marks the exponent -1 after a solidus: in `W/m2/cm-1`, `cm-1` is itself a unit.  A
    product after a solidus (`W/m2 sr`) is refused as ambiguous, as the SI Brochure requires.
    """
    if len(text) > MAX_LENGTH:
        raise UnitError(
            f"a text of {len(text)} characters is not a unit",
            f"at most {MAX_LENGTH} characters are accepted",
        )
    folded = text.translate(SAME).strip()  # as `plain` does, without the call
    folded = folded.replace("sq.", "sq ")  # W/sq.cm
    if not folded:
        raise UnitError("a unit is missing", "a unit such as lx, cd/m2 or W/(m2 sr)")
    scanner = Scanner(folded)
    atoms = scanner.group(0)
    if scanner.at < len(folded):
        raise scanner.error("has a closing bracket too many")
    return [(name, n, inverse and n == 1) for name, n, inverse in atoms]


POINTS = tuple(f".{digit}" for digit in DIGITS)


class Scanner:
    """One pass over the text of a unit."""

    divides = False  # whether a number may follow a solidus

    def __init__(self, text: str) -> None:
        self.text = text
        self.at = 0

    def error(self, problem: str, hint: Hint = "") -> RadcalcError:
        hint = hint or "a unit such as lx, cd/m2 or W/(m2 sr)"
        return UnitError(f"the unit '{quote(self.text)}' {problem}", hint)

    def peek(self) -> str:
        return self.text[self.at] if self.at < len(self.text) else ""

    def skip_blanks(self) -> bool:
        start = self.at
        while self.text.startswith(" ", self.at):
            self.at += 1
        return self.at > start

    def group(self, depth: int) -> list[Atom]:
        """Read to the end of the text or to the bracket that closes this group."""
        if depth > MAX_DEPTH:
            raise self.error("has too many brackets", f"at most {MAX_DEPTH}, one in the other")
        start, solidus = self.at, -1
        atoms: list[Atom] = []
        pending = ""  # the operator without its right side yet
        while True:
            self.skip_blanks()
            c = self.peek()
            if c in ("", ")"):
                break
            operator = self.operator(c)
            if operator and pending:
                raise self.error(f"has '{operator}' after '{pending}'")
            if operator:
                if operator != "/" and not atoms:
                    raise self.error(f"starts with '{operator}'")
                pending = operator
                continue
            if not self.starts_factor(c):
                self.factor(depth)  # raises for it
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

    def starts_factor(self, c: str) -> bool:
        return c in "(1_" or c in NAMED or c.isalpha()

    def separated(self) -> bool:
        return self.text[self.at - 1] in " )" or self.peek() == "("

    def operator(self, c: str) -> str:
        """Read an operator: '/' for a solidus or the word per, '*' for a product, or ''."""
        if c == "/" or c in PRODUCTS:
            self.at += 1
            if c == "*" and self.peek() == "*":
                raise self.error("has an exponent on nothing")
            return "/" if c == "/" else "*"
        if self.text[self.at : self.at + 4].lower() == "per ":
            self.at += 3
            return "/"
        return ""

    def ambiguous(self, start: int, solidus: int) -> RadcalcError:
        over = self.text[start:solidus].strip().removesuffix("per").strip() or "1"
        under = self.text[solidus + 1 :].strip().lstrip("/").strip()
        first = self.text[start : self.at].strip().rstrip(PRODUCTS).strip()
        rest = self.text[self.at :].strip()
        if ")" in under and "(" not in under:  # inside brackets
            under, rest = under.partition(")")[0], rest.partition(")")[0]
        readings = corrections(self.text, f"{over}/({under})", f"({first}) {rest}")
        return self.error("is ambiguous", readings)

    def factor(self, depth: int) -> list[Atom]:
        """Return the units of a group, a sign or a name, with its exponent or 'square'."""
        c = self.peek()
        power = 1
        if c == "(":
            self.at += 1
            atoms = self.group(depth + 1)
            if self.peek() != ")":
                lacking = ")" * (self.text.count("(") - self.text.count(")"))
                better = correct(self.text, self.text + lacking)
                raise self.error("has a bracket that is not closed", better)
            self.at += 1
        elif c in NAMED:
            self.at += 1
            scale = self.peek() if c == "°" and self.peek() in tuple("CFcf") else ""
            self.at += len(scale)
            atoms = [(c + scale if scale else NAMED[c], 1, False)]
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
        """Return the letters from here on; digits only after '_', a hyphen only between letters."""
        start = self.at
        while self.at < len(self.text):
            c = self.text[self.at]
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
        """Return the whole exponent from here on, 1 if there is none."""
        if self.at == len(self.text):
            return 1
        caret = self.caret()
        bracket = caret and self.peek() == "("
        if bracket:
            self.at += 1
        digits = self.signed_digits()
        if not digits and not caret:
            return 1
        sign = -1 if digits[:1] == "-" else 1
        number = digits[1:] if digits[:1] in ("+", "-") else digits
        is_decimal = self.text[self.at : self.at + 2] in POINTS  # m-1.1
        is_whole = number.isdigit() and not is_decimal and not (caret and self.has_fraction(number))
        if not is_whole or (bracket and self.peek() != ")"):
            raise self.error("has an exponent that is not a whole number", "a whole number")
        if bracket:
            self.at += 1
        self.refuse_after_exponent(number, caret)
        return self.bounded(sign * int(number))

    def caret(self) -> bool:
        """Read an exponent operator, ^ or **, and blanks around it."""
        before = self.at
        self.skip_blanks()
        mark = (
            "**"
            if self.text.startswith("**", self.at)
            else "^"
            if self.text.startswith("^", self.at)
            else ""
        )
        if not mark:
            self.at = before
            return False
        self.at += len(mark)
        self.skip_blanks()
        if self.peek() == "{":
            raise self.error("has braces in it", "an exponent such as m^-2")
        return True

    def has_fraction(self, number: str) -> bool:
        """Return whether a fractional exponent follows, as in m^1/2, but not a divisor, m^2/2."""
        mark = self.peek()
        if self.divides and mark == "/" and number != "1":
            return False
        return mark in (".", "/") and self.text[self.at + 1 : self.at + 2].isdigit()

    def refuse_after_exponent(self, number: str, caret: bool) -> None:
        if not caret and (self.peek().isalpha() or self.peek() == "("):
            raise self.error(
                "runs two units together", "a space or a dot between them, and one number"
            )
        if len(number) > 3:
            raise self.error("has an exponent too large", f"at most {MAX_EXPONENT}")
        if self.peek() in ("^", "⁻") or self.text.startswith("**", self.at):
            raise self.error("has an exponent on an exponent", "one exponent")

    def signed_digits(self) -> str:
        start = end = self.at
        is_raised = self.text[start : start + 1] in SUPERSCRIPTS
        if not is_raised and self.text[start : start + 1] in tuple(SIGNS):
            end += 1
        while end < len(self.text) and self.text[end] in (SUPERSCRIPTS if is_raised else DIGITS):
            end += 1
        self.at = end
        digits = self.text[start:end]
        if is_raised:
            return "".join([SUPERSCRIPTS[c] for c in digits])
        return digits.replace(MINUS, "-")

    def bounded(self, exponent: int) -> int:
        if abs(exponent) > MAX_EXPONENT:
            raise self.error(f"has the exponent {exponent}", f"at most {MAX_EXPONENT}")
        return exponent
