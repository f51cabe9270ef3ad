"""Answers, independent of terminals and formats, and the steps of their derivations.

A step is a formula in symbols, then in numbers, with its source.
"""

import math
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from typing import Any

from radcalc.errors import RadcalcError, Try, option, quote
from radcalc.maths import is_array
from radcalc.quantities.symbols import SYMBOLS, light_unit
from radcalc.tuples import NamedTuple
from radcalc.units import Dimension, unit_behind
from radcalc.units.dimensions import COHERENT


class Remark(str):
    """An assumption or a note on some results; a plain text is one on all results.

    `of` names its origins: symbols (light quantities by generic names), laws (by name) and kinds
    of light (by letter).
    """

    __slots__ = ("of",)
    of: frozenset[str]

    def __new__(cls, text: str, of: Iterable[str]) -> "Remark":
        """Return a text with its origins."""
        remark = super().__new__(cls, text)
        remark.of = frozenset(of)
        return remark

    def __reduce__(self) -> tuple[Any, ...]:
        """Return the pickled form."""
        return Remark, (str(self), self.of)


class Step(NamedTuple):
    """One step of a derivation: the law in symbols, in numbers, and its source."""

    law: str
    formula: str
    numbers: str
    reference: str = ""


class ShownInput(NamedTuple):
    """A shown input: a number in a unit, another text, or True for a flag.

    `uncertainty` is a standard uncertainty in the unit.  An input that `tells` answers apart (the
    day of a log) is shown even with a single answer.
    """

    name: str
    value: Any = None
    unit: str = ""
    text: str = ""
    uncertainty: float = 0.0
    tells: bool = False

    @property
    def is_quantity(self) -> bool:
        return bool(self.unit)


def texts_of(texts: Mapping[str, str]) -> tuple[ShownInput, ...]:
    """Return shown inputs for texts that are not empty."""
    return tuple(ShownInput(name, text=text) for name, text in texts.items() if text)


FRACTION = "fraction"  # of a second, like the times of a shutter: 1/60


class Row(NamedTuple):
    """One value of an answer; `case` identifies one of several answers.

    `name` is the name for `--get`, `given` marks inputs, `uncertainty` is a standard uncertainty in
    the unit.
    """

    quantity: str
    symbol: str
    value: Any
    unit: str
    case: str = ""
    name: str = ""
    given: bool = False
    uncertainty: float = 0.0
    form: str = ""


class Result(NamedTuple):
    """One answer; texts omit the name of a conversion's single result, which is not `named`."""

    rows: tuple[Row, ...]
    assumptions: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()
    steps: tuple[Step, ...] = ()
    inputs: tuple[ShownInput, ...] = ()
    named: bool = True

    def spelled(self, spell: Callable[[str], str]) -> "Result":
        return self._replace(
            assumptions=tuple(map(spell, self.assumptions)), notes=tuple(map(spell, self.notes))
        )


ALONE: dict[Dimension, Any] = {}


class Value(NamedTuple):
    """One result of a calculator, in coherent SI units, with its shown units.

    `dimensions` are those of the accepted units; the first is the result's own.  `si` may be a
    function, called on demand.  `reach` has the amounts in linked kinds, by dimension.  `given` is
    the input number in the first unit, `exact` a number known in that unit without a conversion
    from SI; `also` is another name.  With uncertain inputs, numbers are those of the
    `uncertainties` package.
    A result that does not follow has no units; `lacking` returns the inputs that would give it, or
    `because` is the reason why none would.  A result with neither is calculated on request alone.
    """

    name: str
    label: str
    letter: str
    si: Any
    dimensions: tuple[Dimension, ...]
    units: tuple[str, ...]
    reach: dict[Dimension, Any] = ALONE
    given: Any = None
    also: str = ""
    lacking: Callable[[], Any] | None = None
    because: RadcalcError | None = None
    exact: Any = None
    form: str = ""

    @property
    def in_first(self) -> Any:
        """The number in the first unit, as typed or known exactly; otherwise None."""
        return self.exact if self.given is None else self.given

    @property
    def amount(self) -> Any:
        return self.si() if callable(self.si) else self.si

    @property
    def is_absent(self) -> bool:
        return not self.units

    @property
    def is_on_request(self) -> bool:
        return self.is_absent and self.lacking is None and self.because is None


def itself(name: str, kind: str) -> Collection[str]:
    """Return the origins of a result where remarks name the results that they are on."""
    return name, kind


class Answer(NamedTuple):
    """The answer of a calculator; `more` are further answers if several fit the inputs.

    `origins` returns the origins of a result (by its generic name) in a kind of light: symbols,
    laws and kinds of light, as in a `Remark`; None where they are unknown.  A remark is on the
    results that share one of its origins.
    """

    values: Sequence[Value]
    assumptions: Sequence[str] = ()
    notes: Sequence[str] = ()
    steps: Sequence[Step] = ()
    more: "Sequence[Answer]" = ()
    origins: Callable[[str, str], Collection[str] | None] = itself

    def said(
        self, results: Sequence[tuple[str, str]] | None = None
    ) -> tuple[tuple[str, ...], tuple[str, ...]]:
        """Return the assumptions and the notes on all results, or on some of them.

        A result is a generic name and a kind of light, which is empty for other quantities.
        """
        assumptions, notes = self.assumptions, self.notes
        if results is not None:
            origins = [self.origins(*result) for result in results]
            assumptions, notes = _on(assumptions, origins), _on(notes, origins)
        return _once(assumptions), tuple(dict.fromkeys(notes))


def _on(remarks: Sequence[str], origins: Sequence[Collection[str] | None]) -> list[str]:
    """Return the remarks on results with these origins."""
    return [
        remark
        for remark in remarks
        if not isinstance(remark, Remark)
        or any(of is None or not remark.of.isdisjoint(of) for of in origins)
    ]


def _once(texts: Iterable[str]) -> tuple[str, ...]:
    """Return texts without the clauses of earlier ones."""
    seen: dict[str, None] = {}
    kept = []
    for text in texts:
        clauses = [clause for clause in text.split("; ") if clause not in seen]
        seen.update(dict.fromkeys(clauses))
        kept += ["; ".join(clauses)] if clauses else []
    return tuple(kept)


def varying(inputs: Sequence[Sequence[ShownInput]]) -> list[str]:
    """Return the names of inputs that differ between answers, are arrays, or `tells` marks."""
    by_name = [{shown_input.name: shown_input for shown_input in group} for group in inputs]
    names = dict.fromkeys(name for group in by_name for name in group)
    return [
        name
        for name in names
        if any(_differ(group.get(name), by_name[0].get(name)) for group in by_name)
    ]


def _differ(first: ShownInput | None, second: ShownInput | None) -> bool:
    if first is None or second is None:
        return first is not second
    return first.tells or is_array(first.value) or is_array(second.value) or first != second


def shows(row: Row, name: str) -> bool:
    """Return whether a row shows the input of a name, which may be generic."""
    if not row.given:
        return False
    from radcalc.quantities import LUMINOUS  # not for plain conversions
    from radcalc.quantities.symbols import in_kind

    return name in (row.name, row.quantity.replace(" ", "-")) or in_kind(name, LUMINOUS) == row.name


ELEMENTS = 3  # of an array in short
RESULTS, NAMED = 3, 2  # in short, and with their names


def in_short(rows: Sequence[Row], named: bool = False, remark: str = "") -> str:
    """Return the first results in a line, and a remark: `intensity 5 cd, flux 62.8319 lm`."""
    shown = rows[:RESULTS]
    if named:  # each name once
        shown = list({row.name: row for row in rows[::-1]}.values())[::-1][:NAMED]
    texts = [f"{row.name} " * named + _in_short(row) for row in shown]
    text = ", ".join([*texts, *["..."] * (len(rows) > RESULTS and not named)])
    mark = " " if remark.startswith("(") else ", "
    return mark.join(filter(None, [text, remark]))


OF_LIGHT = ("spectrum", "reference")
Pairs = Sequence[tuple[str, str]]  # the inputs of a call by name, and operands without a name


def remark_on(proposal: Try, call: Pairs, typed: Pairs) -> str:
    """Return the remark on a proposed call, with its values that the user did not type."""
    if proposal.follow or not (proposal.inputs or proposal.is_call):
        return proposal.remark
    names = {*dict(proposal.inputs)}
    if not proposal.instead and names <= SYMBOLS.keys():
        names.add("")  # an operand
    new = [
        (name, value)
        for name, value in call
        if value and (name, value) not in typed and (proposal.words or name in names)
    ]
    if not new:
        return proposal.remark
    gone = [value for name, value in typed if proposal.words or (name, value) not in call]
    known = _numbers(" ".join(gone))
    new = [
        (name, value)
        for name, value in new
        if not _numbers(value) <= known or (name in OF_LIGHT and value not in gone)
    ]
    *texts, last = [option(name, quote(value)) for name, value in new if name in SYMBOLS] or [""]
    marked = f"{', '.join(texts)} and {last} are examples" if texts else f"{last} is an example"
    return ", ".join(filter(None, [proposal.remark, marked if last else "an example" * bool(new)]))


def _numbers(text: str) -> set[float]:
    """Return the numbers in a text; digits in a name are none."""
    import re

    return {*map(float, re.findall(r"(?<![\w.])(?<![A-Za-z]-)\d+\.?\d*(?:e[-+]?\d+)?", text))}


def _in_short(row: Row) -> str:
    """Return a number with its unit, several solutions, or the first elements of an array."""
    numbers = row.value.ravel().tolist() if hasattr(row.value, "ravel") else [row.value]
    texts = ["--" if number is None else f"{number:.6g}" for number in numbers[: ELEMENTS + 1]]
    is_long = len(texts) > ELEMENTS
    text = f"{', '.join(texts[:ELEMENTS])} ..." if is_long else " or ".join(dict.fromkeys(texts))
    uncertainty = f" ± {row.uncertainty:.2g}" if row.uncertainty else ""
    return f"{text}{uncertainty}" + ("" if row.unit == "1" else f" {row.unit}")


# Units of derivations that are not coherent, and their number in one coherent unit.
CUSTOMARY = {"nm": 1e9, "THz": 1e-12, "cm-1": 0.01, "mrad": 1e3}
ASCII = {
    "2α": "2 alpha",
    "∫": "int ",
    "²": "^2",
    "π": "pi",
    "ψ": "psi",
    "Φ": "Phi",
    "Δ": "d",
    "Ω": "Omega",
    "α": "alpha",
    "ε": "epsilon",
    "η": "eta",
    "β": "beta",
    "γ": "gamma",
    "θ": "theta",
    "λ": "lambda",
    "ν": "nu",
    "ρ": "rho",
    "σ": "sigma",
    "τ": "tau",
    "φ": "phi",
}


DIGITS, MOST_DIGITS = 6, 17


def format_number(value: Any, digits: int = DIGITS) -> str:
    """Return a number for a derivation or a message; for an array, its least and greatest."""
    if not isinstance(value, (int, float)) and is_array(value):
        if not value.size:
            return "no numbers"
        low, high = (format_number(float(end), digits) for end in (value.min(), value.max()))
        return low if low == high else f"{low} to {high}"
    return f"{value + 0.0:.{digits}g}"  # no -0


def digits_apart(first: Any, second: Any) -> int:
    """Return how many digits distinguish two numbers, and their ratio from 1."""
    digits = DIGITS
    if isinstance(first, float) and isinstance(second, float) and first != second:
        while abs(first - second) < 10.0 ** (1 - digits) * abs(first) and digits < MOST_DIGITS:
            digits += 1
    return digits


def format_angle(angle: Any, digits: int = DIGITS) -> str:
    """Return an angle [rad] for a derivation, in degrees."""
    return f"{format_number(angle * (180 / math.pi), digits)} deg"


def format_value(value: Any, unit: str, digits: int = DIGITS) -> str:
    """Return a value in a coherent unit, for a derivation."""
    if unit == "rad":
        return format_angle(value, digits)
    if unit in CUSTOMARY:
        return f"{format_number(value * CUSTOMARY[unit], digits)} {unit}"
    return with_unit(format_number(value, digits), unit)


def with_unit(number: str, unit: str) -> str:
    """Return a number with its unit, if it has one."""
    return number + unit_behind(unit)


def letter_of(name: str) -> str:
    """Return the letter of a symbol in ASCII formulas."""
    return in_ascii(SYMBOLS[name].letter or name)


def in_ascii(letter: str) -> str:
    """Return a letter with Greek letters and signs spelled in ASCII."""
    for sign, word in ASCII.items():
        letter = letter.replace(sign, word)
    return letter


def coherent_unit_of(name: str, kind: str = "") -> str:
    """Return the unit of a symbol in derivations; for a light quantity, of a kind."""
    symbol = SYMBOLS[name]
    if symbol.geometry:
        return light_unit(symbol.generic, symbol.kind or kind, coherent=True)
    if symbol.unit in CUSTOMARY:
        return symbol.unit
    if symbol.dimensions[0] in COHERENT:
        return COHERENT[symbol.dimensions[0]]
    from radcalc.units.values import text_of  # of a weight

    return text_of(symbol.dimensions[0])


def fill(template: str, write: Callable[[str, bool], str]) -> str:
    """Return a template with each {name} replaced by `write(name, is_factor)`.

    A factor, raised to a power or followed by another factor, needs brackets if it has a unit.
    """
    head, *parts = template.split("{")
    text = head
    for part in parts:
        name, _, rest = part.partition("}")
        is_factor = rest[:1] == "^" or (rest[:1] == " " and rest[1:2] not in FOLLOWING)
        text += write(name, is_factor) + rest
    return text


FOLLOWING = tuple("/+-*=),")  # characters after a value that is not a factor, or the last one


class Formula(NamedTuple):
    """A formula with {names} of symbols, and its source."""

    name: str
    template: str
    reference: str = ""

    @property
    def text(self) -> str:
        """The formula in letters."""
        return fill(self.template, lambda name, _: letter_of(name))

    def step(self, values: Mapping[str, Any], result: str, kind: str = "") -> Step:
        """Return the formula with values [SI] and a result; symbols without values stay letters.

        `kind` is the kind of light quantities.
        """

        def write(name: str, is_factor: bool) -> str:
            if name not in values:
                return letter_of(name)
            text = format_value(values[name], coherent_unit_of(name, kind))
            return f"({text})" if is_factor and not text.endswith(" deg") else text

        body = self.template.partition(", ")[0]  # a remark may follow a comma
        numbers = fill(body.replace("Omega0", "sr"), write)
        return self.with_numbers(f"{numbers} = {result}")

    def with_numbers(self, numbers: str) -> Step:
        """Return the formula with a text of its numbers."""
        left, _, right = self.text.partition(" = ")
        formula = "" if left == right else self.text  # cos(theta) = cos(theta)
        return Step(self.name, formula, numbers, self.reference)
