"""Quantities that a law links without a condition: of one photon, and of a hot body.

Wavelength, frequency, wavenumber and energy belong to a photon; temperature, exitance, radiance and
peak wavelength to a hot body.
"""

from collections.abc import Sequence
from typing import Any

from radcalc.answer import Step
from radcalc.conversion import Plan
from radcalc.errors import ConditionError, ConversionError, Unused, option
from radcalc.floats import LARGEST, divide
from radcalc.inputs import Input
from radcalc.maths import any_true, is_lost, sqrt
from radcalc.quantities import NONE, PHOTON_NAMES, RADIANT, describe, light_dimension
from radcalc.tuples import NamedTuple
from radcalc.units import WAVELENGTH_UNITS, Exitance, Unit
from radcalc.units.dimensions import LENGTH, TEMPERATURE

TYPE_CHECKING = False  # typing is slow to import
if TYPE_CHECKING:
    from radcalc.laws import Law

HOT = {  # what a temperature determines
    LENGTH: "peak-wavelength",
    light_dimension(RADIANT, (0, 1, 0), NONE): "exitance",
    light_dimension(RADIANT, (0, 1, 1), NONE): "radiance",
}


class Form(NamedTuple):
    """A quantity y as a function of another one x: y = (constant x^power)^(1/root)."""

    constant: Any
    power: int = 1
    root: int = 1

    def in_units(self, source: Unit, target: Unit) -> "Form":
        """Return the form in units, with a constant that is rounded once if it is a float."""
        over, under = source.top**4, source.bottom**4
        if self.power == 1:
            over, under = source.top, source.bottom
        elif self.power == -1:
            over, under = source.bottom, source.top
        over, under = over * target.bottom**self.root, under * target.top**self.root
        if isinstance(self.constant, float):
            top, bottom = self.constant.as_integer_ratio()
            return self._replace(constant=divide(over * top, under * bottom))
        return self._replace(constant=self.constant * divide(over, under))

    def at(self, x: Any) -> Any:
        """Return the quantity; squares and roots are those of IEEE 754, alike for arrays."""
        if self.power == -1:
            return self.constant / x
        square = x * x
        y = self.constant * (x if self.power == 1 else square * square)
        return sqrt(sqrt(y)) if self.root == 4 else y


class LawPlan(Plan):
    """A plan by laws that link two quantities, whose symbols are `names`."""

    __slots__ = ("emissivity", "form", "laws", "names")
    is_linear = False

    def __init__(
        self, ends: tuple[Unit, Unit], names: tuple[str, str], laws: "Sequence[Law]", form: Form
    ) -> None:
        self.form = form.in_units(*ends)
        super().__init__(*ends, self.form.constant)
        self.names, self.laws = names, laws
        self.emissivity: Any = None

    def apply(self, value: Any) -> Any:
        """Convert a number or an array, above 0."""
        if isinstance(value, (int, float)) and value - value != 0:
            raise ConversionError("the value is not a finite number", "a finite number")
        if any_true(value <= 0):
            here, there = (name.replace("-", " ") for name in self.names)
            raise ConditionError(f"a {here} of 0 or less has no {there}", "more than 0")
        result = self.form.at(value)
        if any_true(abs(result) > LARGEST) or is_lost(result):
            raise self._not_held()
        return result

    def derive(self, value: float) -> list[Step]:
        """Return the laws, in symbols and in numbers, and the change of units."""
        from radcalc.laws.solver import Derivation, Known, solve

        here, there = (name.replace("-", " ") for name in self.names)
        given = {self.names[0]: Known(float(value) * self.source.factor)}
        if self.emissivity is not None:
            given["emissivity"] = Known(self.emissivity)
        steps = [*Derivation(solve(self.laws, given), RADIANT)] if self.laws else []
        result = f"{there} {self.apply(value):.6g} {self.target.text}"
        numbers = f"{here} {value:.6g} {self.source.text}: {result}"
        return [*steps, Step("conversion", "", numbers)]

    @property
    def result(self) -> tuple[str, str, str]:
        """Return the quantity of the result, its symbol, and its name in `--get`."""
        from radcalc.quantities.symbols import SYMBOLS

        name = self.names[1]
        if self.target.is_exitance or name == "radiance":
            return super().result
        return name.replace("-", " "), SYMBOLS[name].letter, name


def by_law(source: Unit, target: Unit, given: Sequence[Input]) -> LawPlan | None:
    """Return the plan between two quantities of a photon or of a hot body; None for others."""
    ends = source.dimension, target.dimension
    if any(unit.dimension == LENGTH and not _is_of_waves(unit) for unit in (source, target)):
        return None
    if all(dimension in PHOTON_NAMES for dimension in ends):
        is_width = any(condition.name == "wavelength" for condition in given)
        if is_width and LENGTH in ends:
            return None
        _refuse(source, target, [condition.name for condition in given])
        return _of_photon(source, target)
    if TEMPERATURE in ends and (ends[0] in HOT or ends[1] in HOT):
        return _of_hot_body(source, target, given)
    return None


def _is_of_waves(unit: Unit) -> bool:
    return len(unit.atoms) == 1 and unit.atoms[0] in [(name, 1) for name in WAVELENGTH_UNITS]


def _refuse(source: Unit, target: Unit, unused: Sequence[str]) -> None:
    if unused:
        where = f"to the conversion of {describe(source)} to {describe(target)}"
        raise Unused(unused, where)


def _of_photon(source: Unit, target: Unit) -> LawPlan:
    """Return the plan between two quantities of a photon."""
    from radcalc.laws.optics import PHOTON_LAWS
    from radcalc.spectra.observers import AVOGADRO

    names = PHOTON_NAMES[source.dimension], PHOTON_NAMES[target.dimension]
    laws = [law for law in PHOTON_LAWS if law.result in names]  # each of the wavelength
    constants = {law.result: law.constant for law in laws}
    if len(laws) == 1 and "wavelength" in names:
        form = Form(laws[0].constant, -1)
    else:
        form = Form(constants[names[1]] / constants[names[0]])
        laws = laws if len(laws) == 2 else []
    plan = LawPlan((source, target), names, laws, form)
    assumption = "a photon in vacuum"
    if "wavelength" in names:
        assumption += f", not the width of a band ({option('wavelength')})"
    if any(_is_per_mole(unit) for unit in (source, target)):
        assumption += f"; a mole has {AVOGADRO:.9g} photons"
    plan.assumptions = (assumption,)
    return plan


def _is_per_mole(unit: Unit) -> bool:
    return any(name.endswith(("mole", "einstein")) for name, _ in unit.atoms)


def _of_hot_body(source: Unit, target: Unit, given: Sequence[Input]) -> LawPlan:
    """Return the plan between the temperature of a hot body and what it determines."""
    from radcalc.laws.optics import EXITANCE, PEAK
    from radcalc.laws.surface import LAMBERTIAN

    is_backward = target.dimension == TEMPERATURE
    name = HOT[source.dimension if is_backward else target.dimension]
    names = (name, "temperature") if is_backward else ("temperature", name)
    if name == "peak-wavelength":
        _refuse(source, target, [condition.name for condition in given])
        plan = LawPlan((source, target), names, [PEAK], Form(PEAK.constant, -1))
        plan.assumptions = ("a black body, at the peak of its spectrum per wavelength",)
        return plan
    _refuse(source, target, [one.name for one in given if one.name != "emissivity"])
    emissivity, body = 1.0, "a black body (its emissivity is 1)"
    for condition in given:
        emissivity, body = condition.value, f"a grey body with the emissivity {condition.text}"
    constant = EXITANCE.constant * emissivity
    laws = [EXITANCE]
    if name == "radiance":
        constant /= LAMBERTIAN.constant
        laws.append(LAMBERTIAN)
    else:
        source, target = (
            unit if unit.dimension == TEMPERATURE else unit.of_class(Exitance)
            for unit in (source, target)
        )
    form = Form(1 / constant, 1, 4) if is_backward else Form(constant, 4)
    plan = LawPlan((source, target), names, laws, form)
    plan.assumptions = (f"{body}, without light from its surroundings",)
    plan.emissivity = emissivity
    return plan
