"""The texts of a stream: bare numbers of one unit, or quantities with units of their own.

Each is converted by itself, as a single conversion is, or many at a time where all are plain.
"""

from collections.abc import Callable

from radcalc.conversion.plan import Plan
from radcalc.errors import NumberError, RadcalcError, UsageError, command, option, quote
from radcalc.render.plain import DIGITS, number
from radcalc.streams.blocks import Bulk
from radcalc.units.amounts import read_amount
from radcalc.units.numbers import parse_number
from radcalc.units.table import Unit

MOST_UNITS, LONGEST_UNIT = 1000, 100  # that are remembered
NUMBER = b"0123456789.+-"


class Numbers:
    """Texts that are bare numbers, all of one unit."""

    example = f"{option('field', 'N')} for one of several fields, or "
    example += f"{command('convert', '-', 'TARGET')} for 100 lx"

    def __init__(self, made: Plan, precision: int | None = None) -> None:
        """Take the plan for all of them."""
        self.made = made
        self.precision = precision
        self.bulk = Bulk(made, precision or DIGITS)

    def read(self, text: bytes) -> tuple[Plan, float]:
        """The plan and the number of one text."""
        try:
            return self.made, parse_number(_decoded(text))
        except NumberError as error:
            several = len(text.split(None, 1)) > 1
            raise NumberError(error.message, self.example if several else error.hint) from None

    def show(self, made: Plan, value: float) -> bytes:
        """What stands in the output for a number that was read."""
        return number(made.apply(value), self.precision).encode()

    def lines(self, block: bytes) -> bytes | None:
        """Convert a block of lines, each of them one text; None where any is unusual."""
        return self.bulk.lines(block)

    def column(self, texts: list[bytes]) -> list[bytes] | None:
        """Convert many texts; None where any is unusual."""
        shown = self.bulk.lines(b"\n".join(texts) + b"\n")
        return None if shown is None else shown[:-1].split(b"\n")


class Quantities:
    """Texts that carry their own units: a plan for each that comes."""

    def __init__(
        self, plans: Callable[[Unit], Plan], unit: bytes, precision: int | None = None
    ) -> None:
        """Take what makes a plan from a unit, and what follows each answer."""
        self.plans = plans
        self.unit = unit
        self.precision = precision
        self.known: dict[str, Plan | RadcalcError] = {}
        self.bulks: dict[bytes, Bulk | None] = {}

    def read(self, text: bytes) -> tuple[Plan, float]:
        """The plan and the number of one text."""
        amount = read_amount(_decoded(text))
        if amount.unit is None:
            raise UsageError(
                f"'{quote(text.decode())}' has no unit",
                f"{command('convert', '-', 'UNIT', 'TARGET')} for bare numbers",
            )
        if amount.is_uncertain:
            raise NumberError(
                f"'{quote(amount.text)}' has an uncertainty, which a stream does not carry",
                f"the value alone, or a call of its own: {command('convert', quote(amount.text))}",
            )
        value, source = amount.typed
        return self._plan(source or amount.unit), value

    def _plan(self, unit: Unit) -> Plan:
        made = self.known.get(unit.text)
        if made is None:
            if len(self.known) >= MOST_UNITS:
                self.known.clear()
            try:
                made = self.plans(unit)
            except RadcalcError as error:
                made = error
            self.known[unit.text] = made
        if isinstance(made, RadcalcError):
            raise made.with_traceback(None)  # which would grow with every line
        return made

    def show(self, made: Plan, value: float) -> bytes:
        """What stands in the output for a quantity that was read."""
        return number(made.apply(value), self.precision).encode() + self.unit

    def lines(self, block: bytes) -> bytes | None:
        """Convert a block of lines, each of them one text; None where any is unusual."""
        texts = block.split(b"\n")
        texts.pop()
        shown = self.column(texts)
        return None if shown is None else b"\n".join(shown) + b"\n"

    def column(self, texts: list[bytes]) -> list[bytes] | None:
        """Convert many texts, those of one unit at a time; None where any is unusual."""
        units = [text.lstrip(NUMBER) for text in texts]
        places: dict[bytes, list[int]] = {}
        for place, unit in enumerate(units):
            if unit in places:
                places[unit].append(place)
            else:
                places[unit] = [place]
        shown = texts[:]
        for unit, having in places.items():
            bulk = self._bulk(unit, texts[having[0]])
            if bulk is None:
                return None
            size = len(unit)
            numbers = bulk.lines(b"\n".join([texts[place][:-size] for place in having]) + b"\n")
            if numbers is None:
                return None
            for place, value in zip(having, numbers.split(b"\n"), strict=False):
                shown[place] = value + self.unit
        return shown

    def _bulk(self, unit: bytes, text: bytes) -> Bulk | None:
        """What converts numbers with this text of a unit behind them.

        The grammar must agree that this is where the unit begins, and blanks behind it are none
        of it.
        """
        if len(unit) > LONGEST_UNIT:
            return None
        if unit not in self.bulks:
            if len(self.bulks) >= MOST_UNITS:
                self.bulks.clear()
            bulk = None
            if unit and unit == unit.rstrip():
                try:
                    made, _ = self.read(text)
                    agreed = made.source.text == unit.decode().strip()
                    bulk = Bulk(made, self.precision or DIGITS) if agreed else None
                except RadcalcError:
                    pass
            self.bulks[unit] = bulk
        return self.bulks[unit]


def _decoded(text: bytes) -> str:
    """The text of a number or a unit, which is UTF-8 and has no blank but those around it."""
    try:
        decoded = text.decode()
        if decoded != decoded.strip():  # a form feed, a no-break space: not ours to drop
            raise NumberError(f"'{quote(decoded)}' is not a number", "blanks or tabs around it")
        return decoded
    except UnicodeDecodeError:
        shown = quote(text.decode(errors="backslashreplace"))
        raise NumberError(f"'{shown}' is not text in UTF-8", "UTF-8") from None
