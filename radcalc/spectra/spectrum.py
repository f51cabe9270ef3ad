"""What a spectrum is to radcalc: something that can be counted in watts, lumens and photons."""

import math
from collections.abc import Sequence

from radcalc.errors import ConditionError
from radcalc.spectra import planck
from radcalc.spectra.integrals import clip, integral, trapezoid, weighted
from radcalc.spectra.observers import Observer, luminous_efficiency
from radcalc.spectra.planck import LIGHT, PLANCK

WHOLE = (0.0, math.inf)
Range = tuple[float, float]


def range_text(limits: Range) -> str:
    """A range of wavelengths [nm] for people."""
    low, high = limits
    if limits == WHOLE:
        return "all wavelengths"
    if high == math.inf:
        return f"from {low:.6g} nm"
    return f"{low:.6g}-{high:.6g} nm"


class Spectrum:
    """Watts per nanometre against wavelength [nm]; relative unless `absolute` names a quantity.

    `limits` is where watts are counted unless somebody says otherwise.
    """

    absolute = ""

    def __init__(self, label: str, limits: Range, notes: tuple[str, ...] = ()) -> None:
        """Hold what every kind of spectrum has."""
        self.label = label
        self.limits = limits
        self.notes = notes

    def power(self, limits: Range) -> float:
        """Watts between two wavelengths."""
        raise NotImplementedError

    def seen(self, observer: Observer) -> float:
        """Watts weighted by an observer's relative luminous efficiency."""
        raise NotImplementedError

    def photons(self, limits: Range) -> float:
        """Photons per second between two wavelengths."""
        raise NotImplementedError

    def mean_range(self) -> Range:
        """Where there is anything at all."""
        return self.limits

    @property
    def counts_all_photons(self) -> bool:
        """Whether photons are counted wherever they are, not from 400 nm to 700 nm."""
        return False


class Table(Spectrum):
    """A spectrum given by points, linear between them and 0 outside."""

    def __init__(
        self,
        label: str,
        grid: Sequence[float],
        values: Sequence[float],
        limits: Range = WHOLE,
        notes: tuple[str, ...] = (),
        absolute: str = "",
    ) -> None:
        """Hold the points; watts are counted over the whole data unless `limits` are given."""
        whole = (grid[0], grid[-1])
        super().__init__(label, whole if limits == WHOLE else limits, notes)
        self.grid = grid
        self.values = values
        self.absolute = absolute

    def power(self, limits: Range) -> float:
        """See `Spectrum`."""
        return integral(self.grid, self.values, *limits)

    def seen(self, observer: Observer) -> float:
        """See `Spectrum`."""
        return weighted(self.grid, self.values, observer.start, observer.values)

    def photons(self, limits: Range) -> float:
        """See `Spectrum`; the product with the wavelength is integrated exactly."""
        grid, values = clip(self.grid, self.values, *limits)
        moments = [
            (b - a) * (2 * (a * p + b * q) + a * q + b * p)
            for a, b, p, q in zip(grid, grid[1:], values, values[1:], strict=False)
        ]
        return sum(moments) / 6 * 1e-9 / (PLANCK * LIGHT)

    def mean_range(self) -> Range:
        """See `Spectrum`."""
        return self.grid[0], self.grid[-1]

    def total(self) -> float:
        """Watts in all the data."""
        return trapezoid(self.grid, self.values)


class Lines(Spectrum):
    """Lines of no width: wavelengths [nm] and watts."""

    def __init__(self, label: str, lines: Sequence[tuple[float, float]]) -> None:
        """Hold the lines; all their photons are counted."""
        notes: tuple[str, ...] = ()
        if any(not 400 <= place <= 700 for place, _ in lines):
            notes = ("a line lies outside 400-700 nm, where PPFD is counted; it counts here",)
        super().__init__(label, WHOLE, notes)
        self.lines = lines

    def power(self, limits: Range) -> float:
        """See `Spectrum`."""
        return sum(watts for place, watts in self.lines if limits[0] <= place <= limits[1])

    def seen(self, observer: Observer) -> float:
        """See `Spectrum`."""
        return float(
            sum(w * luminous_efficiency(place * 1e-9, observer) for place, w in self.lines)
        )

    def photons(self, limits: Range) -> float:
        """See `Spectrum`."""
        inside = [(p, w) for p, w in self.lines if limits[0] <= p <= limits[1]]
        return sum(watts * place for place, watts in inside) * 1e-9 / (PLANCK * LIGHT)

    @property
    def counts_all_photons(self) -> bool:
        """See `Spectrum`."""
        return True


class BlackBody(Spectrum):
    """A black body of a temperature [K]; its watts are those of a square metre."""

    absolute = "exitance"

    def __init__(self, temperature: float) -> None:
        """Hold the temperature."""
        if not 1 <= temperature <= 1e9:
            raise ConditionError(
                f"a black body of {temperature:g} K is not possible here", "from 1K to 1e9K"
            )
        super().__init__(f"a black body of {temperature:.6g} K", WHOLE)
        self.temperature = temperature

    def power(self, limits: Range) -> float:
        """See `Spectrum`."""
        return planck.exitance(self.temperature, limits[0] * 1e-9, limits[1] * 1e-9)

    def seen(self, observer: Observer) -> float:
        """See `Spectrum`; Planck's law at every nanometre of the observer's table."""
        grid = [float(observer.start + i) for i in range(len(observer.values))]
        values = [planck.spectral_exitance(x * 1e-9, self.temperature) * 1e-9 for x in grid]
        return weighted(grid, values, observer.start, observer.values)

    def photons(self, limits: Range) -> float:
        """See `Spectrum`."""
        return planck.photon_exitance(self.temperature, limits[0] * 1e-9, limits[1] * 1e-9)
