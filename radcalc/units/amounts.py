"""What people type: a value with its unit, and the words of a conversion.

`read_amount` is the one reader of a value (`100 lx`, `1/3`, `4pi sr`), `read_operands` that of
VALUE UNIT [to] TARGET.
"""

from radcalc.errors import NumberError, UsageError, command, quote
from radcalc.units.numbers import split_quantity
from radcalc.units.table import Unit, resolve

NOT_UNITS = "^*+±×'.,0123456789"  # what follows a number only in a text that is none
SEPARATORS = ("in", "into", "as", "->", "=>", "=", "→")  # what people type in place of `to`
EXAMPLE = command("convert", "100", "lx", "fc")
STREAM_EXAMPLE = f"{command('convert', '-', 'lx', 'fc')}, or "
STREAM_EXAMPLE += f"{command('convert', '-', 'fc')} for lines with their own unit"


class Amount:
    """A number in a unit, as somebody typed it.

    `unit` is None for a bare number; `uncertainty` is the standard uncertainty in the unit, and 0
    where none was given; `assumptions` say how the text was read, where that takes a word.
    """

    __slots__ = ("assumptions", "number", "text", "uncertainty", "unit")

    def __init__(
        self,
        text: str,
        number: float,
        unit: Unit | None,
        uncertainty: float = 0.0,
        assumptions: tuple[str, ...] = (),
    ) -> None:
        """Hold the reading of `text`."""
        self.text = text
        self.number = number
        self.unit = unit
        self.uncertainty = uncertainty
        self.assumptions = assumptions

    def __repr__(self) -> str:
        """Show the text."""
        return f"Amount({self.text!r})"


def read_amount(text: str) -> Amount:
    """Read a value, with its unit or bare.

    Raises RadcalcError where it is none, or has an unknown unit.
    """
    text = text.strip()
    number, unit = split_quantity(text)
    if unit and (unit[0] in NOT_UNITS or unit.lower().startswith("x10")):
        raise NumberError(
            f"'{quote(text)}' is not a number and a unit", "a number such as 1000 or 1.5e3"
        )
    return Amount(text, number, resolve(unit) if unit else None)


def with_unit(amount: Amount, unit: str) -> Amount:
    """A bare number with the unit that stands in another word."""
    return Amount(f"{amount.text} {unit}", amount.number, resolve(unit), amount.uncertainty)


def read_operands(words: list[str]) -> tuple[Amount, str]:
    """Return the value with its unit, and the text of the target ('' where none is).

    `100lx fc`, `100 lx fc`, `100 lx to fc`, `'100 lx' fc` are the same; only around `to` may a
    unit be several words.
    """
    if not words:
        raise UsageError("a value is missing", EXAMPLE)
    sides = f" {' '.join(words)} ".split(" to ")
    if len(sides) > 2:
        raise UsageError("the word to stands there more than once", EXAMPLE)
    if len(sides) == 2:
        amount = read_amount(sides[0])
        target = sides[1].strip()
        if not target:
            raise UsageError("a unit is missing after to", EXAMPLE)
        rest: list[str] = [target]
    else:
        amount = read_amount(words[0])
        rest = words[1:]
        if amount.unit is None and rest and rest[0].strip():
            amount, rest = with_unit(amount, rest[0].strip()), rest[1:]
    if amount.unit is None:
        raise UsageError(f"{quote(words[0])} has no unit", EXAMPLE)
    if rest and not rest[0].strip():
        raise UsageError("the unit to convert to is empty", EXAMPLE)
    if len(rest) > 1:
        raise _too_many(amount.unit.text, rest)
    return amount, rest[0] if rest else ""


def read_stream_operands(words: list[str]) -> tuple[str, str]:
    """Return the units of `- UNIT [to] TARGET`; the first is '' where the lines carry their own."""
    if words.count("-") > 1:
        raise UsageError("there is more than one -, and one standard input", STREAM_EXAMPLE)
    sides = f" {' '.join(words[1:])} ".split(" to ")
    if len(sides) > 2:
        raise UsageError("the word to stands there more than once", STREAM_EXAMPLE)
    units = [side.strip() for side in sides] if len(sides) == 2 else words[1:]
    if not units or not all(unit.strip() for unit in units[len(sides) - 1 :]):
        raise UsageError("a unit to convert to is missing", STREAM_EXAMPLE)
    if len(units) > 2:
        raise _too_many(units[0], units[1:])
    return (units[0] if len(units) > 1 else ""), units[-1]


def _too_many(unit: str, rest: list[str]) -> UsageError:
    if rest[0].lower() in SEPARATORS:
        return UsageError(
            f"'{quote(rest[0])}' does not separate units", f"{quote(unit)} to {quote(rest[1])}"
        )
    return UsageError(
        f"too many words: '{quote(' '.join([unit, *rest]))}'",
        "quotes around a unit of several words, or to between the units",
    )
