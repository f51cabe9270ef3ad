"""The words of a conversion: VALUE UNIT [to] TARGET, in every way people write them."""

from radcalc.errors import NumberError, UsageError, command, quote
from radcalc.units.numbers import split_quantity

SEPARATORS = ("in", "into", "as", "->", "=>", "=", "→")  # what people type in place of `to`
NOT_UNITS = "^*+±×'.,0123456789"  # what follows a number only in a text that is none
EXAMPLE = command("convert", "100", "lx", "fc")
STREAM_EXAMPLE = f"{command('convert', '-', 'lx', 'fc')}, or "
STREAM_EXAMPLE += f"{command('convert', '-', 'fc')} for lines with their own unit"


def read_operands(words: list[str]) -> tuple[float, str, str]:
    """Return the value, the text of its unit and the text of the target ('' where none is).

    `100lx fc`, `100 lx fc`, `100 lx to fc`, `'100 lx' fc` are the same; only around `to` may a
    unit be several words.
    """
    if not words:
        raise UsageError("a value is missing", EXAMPLE)
    sides = f" {' '.join(words)} ".split(" to ")
    if len(sides) > 2:
        raise UsageError("the word to stands there more than once", EXAMPLE)
    if len(sides) == 2:
        value, unit = read_quantity(sides[0])
        target = sides[1].strip()
        if not target:
            raise UsageError("a unit is missing after to", EXAMPLE)
        rest: list[str] = [target]
    else:
        value, unit = read_quantity(words[0])
        rest = words[1:]
        if not unit and rest:
            unit, rest = rest[0].strip(), rest[1:]
    if not unit:
        raise UsageError(f"{quote(words[0])} has no unit", EXAMPLE)
    if rest and not rest[0].strip():
        raise UsageError("the unit to convert to is empty", EXAMPLE)
    if len(rest) > 1:
        raise _too_many(unit, rest)
    return value, unit, rest[0] if rest else ""


def read_quantity(text: str) -> tuple[float, str]:
    """Cut a value from its unit; refuse what goes on as only a number would."""
    value, unit = split_quantity(text)
    if unit and (unit[0] in NOT_UNITS or unit.lower().startswith("x10")):
        raise NumberError(
            f"'{quote(text.strip())}' is not a number and a unit", "a number such as 1000 or 1.5e3"
        )
    return value, unit


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
