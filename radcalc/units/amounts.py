"""What people type: a value with its unit, and the words of a conversion.

`read_amount` is the one reader of a value (`100 lx`, `1/3`, `4pi sr`), `read_operands` that of
VALUE UNIT [to] TARGET.
"""

from radcalc.errors import (
    MINUS,
    ExpressionError,
    NumberError,
    RadcalcError,
    UnitError,
    UsageError,
    command,
    quote,
)
from radcalc.units.numbers import DIGITS, split_quantity
from radcalc.units.table import NUMBER, Dimension, Unit, resolve, unit_of

TYPE_CHECKING = False  # typing.TYPE_CHECKING, without the cost of importing typing
if TYPE_CHECKING:
    from collections.abc import Sequence

    from radcalc.units.scales import ScaleUnit
    from radcalc.units.uncertain import Part

NOT_UNITS = "^*+±×'.,0123456789"  # what follows a number only in a text that is none
BEFORE_NUMBERS = tuple(" */(+×·")  # what a number in an expression may follow
SEPARATORS = ("to", "into", "->", "=>", "→", "=")  # words between source and target
OPERATORS = ("+", "-", "*", "/", "·", "×", MINUS)
ALSO_UNITS = ("in", "as")  # which separate them too, but may be inches and attoseconds
UNCERTAIN = "±+("  # one of these stands in 100±3, 100+-3 and 100(3)
SIGNS_OF_UNCERTAINTY = ("±", "+-", "+/-", "+" + MINUS)
LONGEST_SUM = 100  # characters of a text whose sum a hint tells
EXAMPLE = command("convert", "100", "lx", "fc")
STREAM_EXAMPLE = f"{command('convert', '-', 'lx', 'fc')}, or "
STREAM_EXAMPLE += f"{command('convert', '-', 'fc')} for lines with their own unit"


class Amount:
    """A number in a unit, as somebody typed it.

    `unit` is None for a bare number; `uncertainty` is the standard uncertainty in the unit, and 0
    where none was given; `assumptions` say how the text was read, where that takes a word.  A
    `reading` on a `scale` is kept beside the number that it stands for.  `rounding` is how far an
    expression may be off as typed, relative to it; None for what is none.  `parts` are what
    follows of each uncertain number of an expression, or of the reading.
    """

    __slots__ = (
        "assumptions",
        "number",
        "parts",
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
        scale: "ScaleUnit | None" = None,
        reading: float = 0.0,
        rounding: float | None = None,
        parts: "tuple[Part, ...]" = (),
    ) -> None:
        """Hold what `text` says."""
        self.text = text
        self.number = number
        self.unit = unit
        self.uncertainty = uncertainty
        self.assumptions = assumptions
        self.scale = scale
        self.reading = reading
        self.rounding = rounding
        self.parts = parts

    @property
    def typed(self) -> tuple[float, Unit | None]:
        """The number and the unit that were typed, or the reading and its scale."""
        return (self.reading, self.scale) if self.scale else (self.number, self.unit)

    @property
    def is_uncertain(self) -> bool:
        """Whether it has an uncertainty, of which a flat expression may leave nothing."""
        return bool(self.uncertainty or self.parts)

    @property
    def typed_uncertainty(self) -> float:
        """The uncertainty of the number that was typed."""
        if self.scale:
            return self.uncertainty / float(abs(self.scale.slope(self.reading)))
        return self.uncertainty

    def __repr__(self) -> str:
        """Show the text."""
        return f"Amount({self.text!r})"


def read_amount(text: str, dimensions: "Sequence[Dimension]" = ()) -> Amount:
    """Read a value, with its unit or bare; a scale of several readings is read as one of them.

    Raises RadcalcError where it is none, or has an unknown unit.
    """
    text = text.strip()
    problem: RadcalcError | None = None
    try:
        number, unit = split_quantity(text)
        if unit.isalpha() or not _has_number(unit):
            return _read_plain(text, number, unit, dimensions)
    except RadcalcError as error:
        problem = error
    is_signed = any(sign in text for sign in SIGNS_OF_UNCERTAINTY)
    is_signed |= any(text[k - 1] in DIGITS for k, c in enumerate(text) if k and c == "(")  # 100(3)
    if not is_signed and (found := _read_expression(text)):
        return found
    if any(mark in text for mark in UNCERTAIN):
        from radcalc.units.uncertain import read_uncertain

        if reading := read_uncertain(text):
            size, found_in, off, _, parts = reading
            return _amount(text, size, found_in, off, dimensions, parts)
    if is_signed and (found := _read_expression(text)):
        return found
    if meant := sum_meant(text):
        raise UnitError(f"'{quote(text)}' has several numbers", f"'{quote(meant)}'")
    if problem:
        raise problem
    return _read_plain(text, number, unit, dimensions)


def sum_meant(text: str) -> str:
    """`5 ft + 3 in` for `5 ft 3 in`: numbers with units of one quantity; '' for anything else."""
    import re  # only when something is wrong already

    if len(text) > LONGEST_SUM:
        return ""
    pairs = re.findall(r"([\d.]+)\s*([^\d\s.]+)", text)
    if len(pairs) < 2 or "".join(map("".join, pairs)) != "".join(text.split()):
        return ""
    units = [unit_of(unit) for _, unit in pairs]
    if len({unit.dimension if unit else None for unit in units} | {None}) != 2 or None in units:
        return ""
    return " + ".join(f"{number} {unit}" for number, unit in pairs)


def _has_number(unit: str) -> bool:
    """Whether a number stands in a text of a unit, and not an exponent."""
    before = last = ""
    for c in unit:
        if c in DIGITS and last in BEFORE_NUMBERS and not before == last == "*":
            return True
        before, last = last, c
    return False


def _read_expression(text: str) -> Amount | None:
    from radcalc.units.expressions import read_expression

    found = read_expression(text)
    return Amount(text, found[0], found[1], rounding=found[2]) if found else None


def split_value(text: str) -> tuple[float, str]:
    """Cut a value into its number and the text of its unit, '' where it is bare.

    An expression is read as `read_amount` does, but nothing that is uncertain; whether the unit
    of a number is one is for others to say.
    """
    problem: RadcalcError | None = None
    number, unit = 0.0, ""
    try:
        number, unit = split_quantity(text)
        if not unit or unit_of(unit):
            return number, unit
        from radcalc.units.scales import find, refuse_product

        if find(unit):
            refuse_product(text, unit)
            return number, unit
    except NumberError as error:
        problem = error
    if any(sign in text for sign in SIGNS_OF_UNCERTAINTY):
        said = f"'{quote(text)}' has an uncertainty, which is not taken there"
        raise NumberError(said, "the value alone")
    from radcalc.units.expressions import read_expression

    found = read_expression(text)
    if found:
        return found[0], found[1].text if found[1] else ""
    if problem:
        raise problem
    return number, unit


def _read_plain(text: str, number: float, unit: str, dimensions: "Sequence[Dimension]") -> Amount:
    """A number, and what stands behind it as a unit."""
    if unit and (
        unit[0] in NOT_UNITS
        or unit.lower().startswith("x10")
        or (unit[0] == "(" and unit[1:2].isdigit())
    ):
        raise NumberError(
            f"'{quote(text)}' is not a number and a unit", "a number such as 1000 or 1.5e3"
        )
    amount = _amount(text, number, _unit(text, unit) if unit else None, 0.0, dimensions)
    if "+" in unit.replace("^+", "").replace("*+", ""):  # 5m+2 cm is a sum, and not m2 cm
        raise NumberError(f"'{quote(text)}' is not a number and a unit", "m^2 for a power")
    return amount


def with_unit(amount: Amount, unit: str) -> Amount:
    """A bare number with the unit that stands in another word; arithmetic as it is in one."""
    text = f"{amount.text} {unit}"
    if unit == "1":  # which multiplies nothing, so that 2 + 3 stays 5
        return Amount(
            text,
            amount.number,
            resolve(unit),
            amount.uncertainty,
            (),
            None,
            0.0,
            amount.rounding,
            amount.parts,
        )
    if amount.rounding is not None or amount.parts:
        return read_amount(text)
    return _amount(text, amount.number, _unit(text, unit), amount.uncertainty, (), amount.parts)


def _unit(text: str, unit: str) -> Unit:
    """The unit or the scale of the number of a text."""
    try:
        return resolve(unit)
    except UnitError:
        from radcalc.units.scales import find, refuse_product

        scale = find(unit)
        if scale is None:
            raise
        refuse_product(text, unit)
        return scale


def _amount(
    text: str,
    number: float,
    unit: Unit | None,
    uncertainty: float = 0.0,
    dimensions: "Sequence[Dimension]" = (),
    parts: "tuple[Part, ...]" = (),
) -> Amount:
    """A number in its unit, or what a reading on a scale stands for."""
    if unit is None or not unit.is_scale:
        return Amount(text, number, unit, uncertainty, parts=parts)
    from radcalc.units.scales import amount_on

    return amount_on(unit, text, number, uncertainty, dimensions)


def read_operands(words: list[str]) -> tuple[Amount, str]:
    """Return the value with its unit, and the text of the target ('' where none is).

    `100lx fc`, `100 lx fc`, `100 lx to fc`, `'100 lx' fc` are the same; only around a separator
    may a unit be several words.
    """
    try:
        return _read_operands(words)
    except RadcalcError:
        for end in range(len(words), 1, -1):  # 5 ft 3 in m, 5ft 3in m
            if not (end > 3 or all(word[:1].isdigit() for word in words[:end])):
                continue
            if meant := sum_meant(" ".join(words[:end])):
                typed = quote(" ".join(words[:end]))
                hint = command("convert", meant, *words[end:])
                raise UsageError(f"'{typed}' has several numbers", hint) from None
        raise


def _read_operands(words: list[str]) -> tuple[Amount, str]:
    if not words:
        raise UsageError("a value is missing", EXAMPLE)
    if words[1:] and words[-1] in ("-", "="):
        shell = "to in its place, or '->' in quotes: without them > is the shell's"
        raise UsageError(f"a unit is missing after {words[-1]}", shell)
    amount, separator, rest = read_value(words)
    if separator and not rest:
        raise UsageError(f"a unit is missing after {separator}", EXAMPLE)
    if not separator and amount.unit is None and rest and rest[0] in OPERATORS:
        raise _too_many(quote(words[0]), rest)
    if not separator and amount.unit is None and rest and rest[0].strip():
        amount, rest = with_unit(amount, rest[0].strip()), rest[1:]
    if separator and amount.unit is None and _is_of_numbers(rest[0]):
        amount = with_unit(amount, "1")
    if amount.unit is None:
        is_plain = words[0].replace(".", "").isalnum()
        hint = EXAMPLE if is_plain else command("convert", quote(words[0]), "to", "1")
        raise UsageError(f"{quote(words[0])} has no unit", hint)
    if rest and not rest[0].strip():
        raise UsageError("the unit to convert to is empty", EXAMPLE)
    if len(rest) > 1:
        _, typed = amount.typed
        raise _too_many(typed.text if typed else "", rest)
    return amount, rest[0] if rest else ""


def read_value(words: list[str]) -> tuple[Amount, str, list[str]]:
    """The value, the separator behind it or '', and the words behind both.

    The unit of a bare number may be the first of these, where nothing separates it.
    """
    if any(mark in word for word in words for mark in SIGNS_OF_UNCERTAINTY):
        from radcalc.units.uncertain import join_words

        words = join_words(words)
    source, separator, target = sides(words)
    if separator:
        return read_amount(source), separator, [target] if target else []
    return read_amount(words[0]), "", words[1:]


def read_stream_operands(words: list[str]) -> tuple[str, str]:
    """Return the units of `- UNIT [to] TARGET`; the first is '' where the lines carry their own."""
    if words.count("-") > 1:
        raise UsageError("there is more than one -, and one standard input", STREAM_EXAMPLE)
    source, separator, target = sides(words[1:], is_stream=True)
    units = [source, target] if separator else words[1:]
    if not units or not all(unit.strip() for unit in units[bool(separator) :]):
        raise UsageError("a unit to convert to is missing", STREAM_EXAMPLE)
    if len(units) > 2:
        raise _too_many(units[0], units[1:])
    return (units[0] if len(units) > 1 else ""), units[-1]


def sides(words: list[str], is_stream: bool = False) -> tuple[str, str, str]:
    """Cut the words at what separates source and target: the source, the separator, the target.

    All are '' where nothing does.  `in` and `as` do between a value with its unit and a target:
    `5 in in cm` has an inch and a separator, `100 in cm` and `100 cm in` have inches alone.
    """
    parts = " ".join(words).split()
    places = [place for place, part in enumerate(parts) if part in SEPARATORS]
    if not places and (len(words) == 1 or any(word in ALSO_UNITS for word in words)):
        last = max((i for i, part in enumerate(parts[:-1]) if part in ALSO_UNITS), default=0)
        if last and (parts[last + 1][0] in "(°%" or parts[last + 1][0].isalpha()):
            places = [last] if is_stream or _has_unit(" ".join(parts[:last])) else []
    if not places:
        return "", "", ""
    at, *others = places
    if others:
        again = parts[others[0]]
        raise UsageError(
            f"the word {again} stands there more than once"
            if again == parts[at]
            else f"{parts[at]} and {again} both separate units",
            STREAM_EXAMPLE if is_stream else EXAMPLE,
        )
    return " ".join(parts[:at]), parts[at], " ".join(parts[at + 1 :])


def _is_of_numbers(text: str) -> bool:
    """Whether a unit or a scale is of bare numbers: 1, % or dB."""
    unit = unit_of(text)
    if unit is None:
        from radcalc.units.scales import find

        unit = find(text)
    return unit is not None and unit.dimension == NUMBER


def _has_unit(text: str) -> bool:
    """Whether a value has a unit, which may be one that nobody knows."""
    try:
        return read_amount(text).unit is not None
    except RadcalcError as error:
        return isinstance(error, ExpressionError) or not isinstance(error, NumberError)


def _too_many(unit: str, rest: list[str]) -> UsageError:
    if rest[0].lower() in SEPARATORS + ALSO_UNITS and rest[1:]:
        return UsageError(
            f"'{quote(rest[0])}' does not separate units", f"{quote(unit)} to {quote(rest[1])}"
        )
    hint = "quotes around a unit of several words, or to between the units"
    if any(word in OPERATORS for word in rest):
        hint = "quotes around a value that is calculated"
    return UsageError(f"too many words: '{quote(' '.join([unit, *rest]))}'", hint)
