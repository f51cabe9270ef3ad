"""Electric field strengths, read as the irradiance of a plane wave in vacuum.

    S = E_rms^2 / Z0 = E_peak^2 / (2 Z0)

Z0 is the characteristic impedance of vacuum.
"""

from typing import Any

from radcalc import maths
from radcalc.errors import ConversionError, NumberError, quote
from radcalc.units.scale_table import Scale
from radcalc.units.scales import ScaleUnit
from radcalc.units.unit import Unit

IMPEDANCE = 376.730313412  # ohm, CODATA 2022
PEAK, RMS = "peak", "rms"


class ElectricField(Scale):
    """The irradiance of a field: a field of 1 has an irradiance of `size` W/m2."""

    __slots__ = ()

    def of(self, quantity: str) -> str:
        return f"sqrt({'2 ' if self.steps == PER_PEAK else ''}Z0 {quantity})"

    def inverse(self, reading: str = "n") -> str:
        field = "E" if reading == "n" else f"({reading} {quote(self.name)})"
        return f"{self.letter} = {field}^2 / {'(2 Z0)' if self.steps == PER_PEAK else 'Z0'}"

    def quantity(self, reading: Any) -> Any:
        return self.size * reading * reading

    def reading(self, quantity: Any) -> Any:
        return maths.sqrt(quantity / self.size)

    def slope(self, reading: Any) -> Any:
        return 2 * self.size * reading


PER_RMS, PER_PEAK = 1.0, 2.0  # the divisor of Z0


class FieldUnit(ScaleUnit):
    """A unit of field strength whose readings are converted to irradiances; `plain` is the unit."""

    __slots__ = ("plain",)

    def __init__(self, plain: Unit, scale: Scale) -> None:
        super().__init__(plain.text, scale)
        self.plain = plain

    def describe(self, settable: bool = False) -> str:
        scale = self.scale
        return f"{scale.inverse()}, {scale.meaning}, Z0 = {IMPEDANCE:.6g} ohm"

    def quantity(self, reading: Any) -> Any:
        irradiance = self.scale.quantity(reading)
        if maths.any_true((irradiance - irradiance != 0) | ((irradiance == 0) & (reading != 0))):
            field = (
                f"{reading:.12g} {quote(self.text)}" if isinstance(reading, float) else "a field"
            )
            raise NumberError(f"{field} is out of range", "less extreme values")
        return irradiance

    def reading(self, quantity: Any) -> Any:
        if maths.any_true(quantity < 0):
            raise ConversionError("a negative irradiance has no field strength", "0 or more")
        return self.scale.reading(quantity) + 0.0

    def with_constants(self, values: dict[str, float]) -> "FieldUnit":
        """Return the same unit: the constants of light meters do not affect fields."""
        return self


def plane_wave(unit: Unit, kind: str) -> FieldUnit:
    """Return a unit of field strength whose readings are irradiances of plane waves."""
    divisor = PER_PEAK if kind == PEAK else PER_RMS
    strength = unit.top / unit.bottom
    row = ElectricField(
        (unit.text,),
        "S",
        "W/m2",
        strength * strength / (divisor * IMPEDANCE),
        10,
        divisor,
        0,
        f"E the {'peak' if kind == PEAK else 'root mean square'} field of a plane wave in vacuum",
        "ISO 80000-6, Poynting vector",
    )
    return FieldUnit(unit, row)
