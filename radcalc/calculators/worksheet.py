"""The worksheet of a calculator: what is given, the laws, and everything that follows."""

from collections.abc import Iterable, Sequence
from typing import Any

from radcalc.answer import Answer, Step, Value
from radcalc.calculators import inputs as i
from radcalc.calculators import light as q
from radcalc.conversion.conditions import Given, degrees, positive, require, show
from radcalc.errors import ConditionError, UsageError
from radcalc.laws.law import (
    LOGARITHMIC,
    AnyLaw,
    Contradiction,
    Known,
    Law,
    Naming,
    Solution,
    reached,
    rounding,
    solve,
    steps,
)
from radcalc.maths import any_true
from radcalc.quantities.light import LUMINOUS, RADIANT, RATIOS

# How symbols are written in a derivation, where that differs from a table.
LETTERS = {
    "half-angle": "alpha",
    "apex-angle": "2 alpha",
    "solid-angle": "Omega",
    "projected-solid-angle": "Omega_p",
    "incidence": "theta",
    "tilt": "theta_s",
    "within": "beta",
    "off-axis": "gamma",
    "configuration-factor": "F",
    "reflectance": "rho",
}
GREEK = {"Φ": "Phi", "Δ": "d", "α": "alpha", "ρ": "rho", "θ": "theta", "Ω": "Omega"}
ENERGY = Law("energy", "{energy} = {flux} {time}", "energy", (("flux", 1), ("time", 1)))
OVER_TIME = (
    Law(
        "exposure", "{exposure} = {irradiance} {time}", "exposure", (("irradiance", 1), ("time", 1))
    ),
    ENERGY,
)
FROM_ZERO = ("exponent", "reflectance")
PARTS = ("reflectance", "absorptance")
SIGNED = ("offset", "offset-y", "incidence", "tilt", "ev", "ev100")  # the rest is above 0


class Sheet:
    """What is given to a calculator, and what follows from it.

    `lit` are the light quantities, in one kind; `given` the other inputs; `internal` the
    letters of symbols that are neither (a cosine).
    """

    def __init__(
        self, lit: q.Lit, given: i.Inputs, internal: dict[str, str], *defaults: str
    ) -> None:
        """Read the values; all but the signed ones must be more than 0.

        `defaults` are symbols that go without saying where nothing gives them.
        """
        self.lit, self.given, self.internal = lit, given, internal
        self.defaults = set(defaults)
        self.used: set[str] = set()
        self.placed: list[Step] = []  # of what was worked out outside the laws
        self.said, self.notes = list(lit.assumptions), list(lit.notes)
        self.known: dict[str, Known] = {}
        self.solution = Solution({}, [])
        for name, one in lit.values.items():
            positive(one)
            self.know(name, lit.amounts[name], one)
        for name, one in given.items():
            if name not in SIGNED:
                self.know(name, one.value if name in FROM_ZERO else positive(one), one)
                require(one, not any_true(one.value < 0), "0 or more")
                if name in PARTS:
                    require(one, not any_true(one.value > 1), "from 0 to 1, or from 0% to 100%")

    def know(self, name: str, value: Any, *of: Given) -> None:
        """Add a value: one that was given, or one that goes without saying."""
        off = max((rounding(one.text) for one in of if not one.is_exact), default=0.0)
        self.known[name] = Known(value, off, of[0].text if of else "")

    def use(self, *names: str) -> None:
        """Count inputs as used, which went into a value that was worked out outside the laws."""
        self.used.update(names)

    def has(self, *names: str) -> bool:
        """Whether one of the symbols is known, or follows."""
        return any(name in self.solution.values or name in self.known for name in names)

    def at(self, name: str) -> Any:
        """A value."""
        return self.solution.values[name].value

    def solve(self, laws: Sequence[AnyLaw]) -> None:
        """Work out what follows; a contradiction is said in the units given."""
        try:
            self.solution = solve(laws, self.known)
        except Contradiction as error:
            raise self._contradiction(error) from None

    def refuse_idle(self, laws: Sequence[AnyLaw], inputs: Iterable[str]) -> None:
        """Refuse what is given and nothing follows from; say what would change that."""
        values, known = self.solution.values, {*self.known, *self.defaults}
        live = _live(laws, set(values))
        aliases = {"offset": "lateral", "offset-y": "lateral"}
        others = len(self.lit.values) + len(self.given) > 1
        for name, one in {**self.lit.values, **self.given}.items():
            own = aliases.get(name, name)
            if own in live or name in self.used:
                continue
            missing = (n for n in inputs if n not in values)
            useful = [n for n in missing if own in _live(laws, reached(laws, known | {n}))]
            flags = " or ".join(f"--{n}" for n in useful[:4])
            raise ConditionError(
                f"nothing follows from {one.flag} {one.text}{'' if others else ' alone'}",
                f"with it, {flags}" if flags else f"the same without {one.flag}",
            )

    def efficacy_row(self) -> list[Value]:
        """The luminous efficacy that links lumens and watts, where there is one."""
        ratio = q.efficacy(self.lit)
        if ratio is None:
            return []
        dimension = RATIOS[LUMINOUS, RADIANT]
        return [
            Value("luminous-efficacy", "luminous efficacy", "K", ratio, (dimension,), ("lm/W",))
        ]

    def _all_flags(self) -> str:
        return ", ".join(one.flag for one in {**self.lit.values, **self.given}.values())

    def light_rows(self, names: Iterable[str]) -> tuple[list[Value], q.Shown]:
        """The light quantities that follow, in every kind that is linked."""
        found = {name: self.at(name) for name in names if name in self.solution.values}
        shown = q.show_light(self.lit, found)
        return [row for name in found for row in shown.values[name]], shown

    def input_rows(self, names: dict[str, str]) -> list[Value]:
        """The other results, with the unit each is shown in unless it was given in one."""
        rows = []
        for name, unit in names.items():
            if name in self.given:
                rows.append(i.known(self.given[name]))
            elif name in self.solution.values:
                rows.append(i.value(name, self.at(name), unit))
        return rows

    def absent_rows(
        self, laws: Sequence[AnyLaw], names: Iterable[str], inputs: Iterable[str]
    ) -> list[Value]:
        """Results that do not follow, which say what they lack when they are asked for."""
        rows = []
        for name in names:
            if name in self.solution.values:
                continue

            def fail(name: str = name) -> Any:
                known = {*self.known, *self.defaults}
                others = (n for n in inputs if n != name)
                alone = [n for n in others if name in reached(laws, {*known, n})]
                raise UsageError(
                    f"no {i.LABELS.get(name, name.replace('-', ' '))} follows from what is given",
                    " or ".join(f"--{n}" for n in alone[:5]) or "more of the quantities",
                )

            if name in i.INPUTS:
                rows.append(Value(name, name, "", fail, i.INPUTS[name].dimensions, ()))
            else:
                dimensions = tuple(q.dimension(name, kind) for kind in q.ORDER)
                also = q.specific(name, self.lit.kind)
                rows.append(Value(name, name, "", fail, dimensions, (), also=also))
        return rows

    def answer(self, rows: list[Value], shown: q.Shown) -> Answer:
        """All of it."""
        derivation: list[Step] = [*self.lit.steps, *self.placed, *self.steps(), *shown.steps]
        said = list(dict.fromkeys([*self.said, *shown.assumptions]))
        return rows, said, list(dict.fromkeys([*self.notes, *shown.notes])), derivation

    def steps(self) -> list[Step]:
        """The derivation."""
        names = {name for law, _ in self.solution.used for name in law.names}
        return steps(self.solution, {name: self._naming(name) for name in names})

    def _naming(self, name: str) -> Naming:
        """How a symbol is written, and its coherent unit."""
        if name in q.GEOMETRY:
            letter, unit = q.SYMBOLS[name], q.unit(name, self.lit.kind, coherent=True)
        else:
            letter = self.internal.get(name) or LETTERS.get(name) or i.SYMBOLS.get(name, name)
            unit = i.COHERENT.get(name, "1")
        for greek, word in GREEK.items():
            letter = letter.replace(greek, word)
        return Naming(letter, unit)

    def _contradiction(self, error: Contradiction) -> ConditionError:
        """Both values, with their unit, and the ratio."""
        unit = self._naming(error.name).unit
        if error.name in self.internal:
            return ConditionError(
                f"{self._all_flags()} contradict each other, by the law '{error.law.name}'",
                "fewer of them",
            )
        one = self.lit.values.get(error.name) or self.given.get(error.name)
        found = _with_unit(error.found, unit)
        text = f"{one.flag} {one.text}" if one else f"{error.name} {_with_unit(error.given, unit)}"
        ratio = f" (ratio {show(error.given / error.found)})" if _is_number(error.found) else ""
        if error.name in LOGARITHMIC:
            ratio = f" ({show(error.given - error.found)} apart)"
        return ConditionError(
            f"{text} contradicts the rest, which gives {found}{ratio}",
            f"without one of {self._all_flags()}",
        )


def _live(laws: Sequence[AnyLaw], known: set[str]) -> set[str]:
    """The symbols that have a part in what follows of the light.

    Those of the laws of light of which every symbol is known, and of those that lead there.
    """
    whole = [set(law.names) for law in laws if known.issuperset(law.names)]
    live = {*q.GEOMETRY, "projected-solid-angle", "ev100"}
    while more := [names for names in whole if names & live and not names <= live]:
        live = live.union(*more)
    return {name for names in whole if names <= live for name in names}


def _is_number(value: Any) -> bool:
    return isinstance(value, float) and value != 0


def _with_unit(value: Any, unit: str) -> str:
    if unit == "rad":
        return degrees(value)
    return show(value) if unit == "1" else f"{show(value)} {unit}"
